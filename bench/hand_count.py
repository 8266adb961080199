"""What `tracking` costs by hand on SE3 and SE2, term by term: the yardstick of the emitted code.

The same task as emitted: full inertia, moving reference, all four outputs, right at every angle
up to pi and against drift. Counted are + - * / and square roots, not the polynomials of k, h, m,
nor signs, comparisons and choices. Every product of a term is shared with no other.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Term:
    """One quantity as it would be written by hand, and the operations of that."""

    what: str
    multiplications: int
    additions: int
    divisions: int = 0
    roots: int = 0

    @property
    def operations(self) -> int:
        """All of them."""
        return self.multiplications + self.additions + self.divisions + self.roots


SE3 = (
    Term("R_e = R_r' R", 27, 18),
    Term("p_e = R_r' (p - p_r)", 9, 9),
    Term("velocity of the reference at p_e, v_r + w_r x p_e", 6, 6),
    Term("eta: both parts turned by R_e'", 18, 12),
    Term("nu_e = nu - eta", 0, 6),
    Term("the same for nu_r': v_r' + w_r' x p_e", 6, 6),
    Term("both parts turned by R_e'", 18, 12),
    Term("eta' = that - ad(nu_e) eta: w x w", 6, 6),
    Term("and w x v + v x w", 12, 12),
    Term("B = 4 q q': diagonal from 1 + x, 1 - x, y + z, y - z", 0, 8),
    Term("and six sums and differences of pairs", 0, 6),
    Term("power step, B times its best column", 16, 12),
    Term("length, its inverse, and the four components", 8, 3, 1, 1),
    Term("rotation vector 2 k v", 4, 0),
    Term("v x p and v x (v x p)", 12, 6),
    Term("rho = p - k v x p + h v x (v x p)", 6, 6),
    Term("q = rho/(2 k), 2 k from above", 3, 0, 1),
    Term("Y nu_e: v x w, v x v_e + q x w", 18, 12),
    Term("Y Y nu_e likewise", 18, 12),
    Term("v.q", 3, 2),
    Term("(k m - 2 h^2) v.q", 4, 1),
    Term("nu_u' = nu_e + k Y nu_e + h Y Y nu_e", 12, 12),
    Term("and the tail, (k m - 2 h^2) v.q times v x (v x w)", 3, 3),
    Term("lambda nu_u and s = nu_e + lambda nu_u", 6, 6),
    Term("wanted = eta' - lambda nu_u' - k_s s", 12, 12),
    Term("lambda nu_u - eta", 0, 6),
    Term("I nu", 36, 30),
    Term("I wanted", 36, 30),
    Term("+ coad: m x w + f x v", 12, 12),
    Term("and f x w", 6, 6),
)
"""SE3 with a full 6x6 inertia; w and v are angular and linear parts, m and f of the momentum."""

SE2 = (
    Term("R_e = R_r' R, all of it", 8, 4),
    Term("its polar part: sum and difference of pairs", 0, 2),
    Term("p_e = R_r' (p - p_r)", 4, 4),
    Term("velocity of the reference at p_e", 2, 2),
    Term("eta: turned by R_e'", 4, 2),
    Term("nu_e = nu - eta", 0, 3),
    Term("the same for nu_r'", 2, 2),
    Term("turned by R_e'", 4, 2),
    Term("eta' = that - ad(nu_e) eta", 4, 4),
    Term("length of (cos, sin)", 2, 1, 0, 1),
    Term("half of the angle: a sum, its length, its inverse", 2, 2, 1, 1),
    Term("w and s", 2, 0),
    Term("phi = 2 k s", 2, 0),
    Term("rho = k (w p - s J p)", 6, 2),
    Term("q = rho/(2 k), 2 k from above", 2, 0, 1),
    Term("Y nu_e: s J v_e - w J q", 4, 2),
    Term("Y Y nu_e = s J of it", 2, 0),
    Term("nu_u' = nu_e + k Y nu_e + h Y Y nu_e", 4, 4),
    Term("lambda nu_u and s = nu_e + lambda nu_u", 3, 3),
    Term("wanted = eta' - lambda nu_u' - k_s s", 6, 6),
    Term("lambda nu_u - eta", 0, 3),
    Term("I nu, the two linear rows", 6, 4),
    Term("I wanted", 9, 6),
    Term("+ coad: f x v", 2, 2),
    Term("and f turned by w", 2, 2),
)
"""SE2 with a full 3x3 inertia; w is the angular part, v the linear one, f its momentum."""

BY_HAND = {"SE3": SE3, "SE2": SE2}
"""Group name -> the terms of `tracking` with law log."""


def total(group: str) -> int:
    """Operations of `tracking` by hand."""
    return sum(term.operations for term in BY_HAND[group])
