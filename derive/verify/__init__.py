"""Doubting: what is derived is measured here against oracles that share no code with it."""
