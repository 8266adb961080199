"""Proof: the paper's statements decided by exact arithmetic, and its mistakes by counterexample."""
