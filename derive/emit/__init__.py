"""Printing: a derivation and a target in, text out; nothing is written here."""
