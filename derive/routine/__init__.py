"""A derivation as data: named steps, their exact rates, their cost."""
