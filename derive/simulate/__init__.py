"""Closing the loop: a plant that stays on its group, and the controller as it was emitted."""
