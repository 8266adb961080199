"""A derivation to read: every step with its formula, unit, equation and emitted lines."""
