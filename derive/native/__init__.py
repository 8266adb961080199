"""Emitted C compiled and called from Python; what it computes is not known here."""
