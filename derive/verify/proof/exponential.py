"""Exponentials of exact matrices, with nothing in them but rational numbers.

A matrix is the sum of a diagonalisable and a nilpotent one that commute. The exponential of the
second is a finite series; that of the first takes, for a pair of eigenvalues +-i theta, a cosine
and a sine/theta. Between these and theta^2 there is one polynomial relation and no other, so
any rational point of cos^2 + theta^2 (sine/theta)^2 = 1 stands for the functions.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import sympy
from sympy import QQ, Matrix, Poly, Rational, Symbol
from sympy.polys.matrices import DomainMatrix

Z = Symbol("z")


@dataclass(frozen=True)
class Turn:
    """cos(theta), sin(theta)/theta and (1 - cos(theta))/theta^2 for one theta^2, rational."""

    square: Any
    cosine: Any
    sine: Any
    versine: Any

    @classmethod
    def at(cls, square: Any, t: Any) -> Turn:
        """The point of the conic on the line of slope t through (1, 0); t = tan(theta/2)/theta."""
        below = 1 + square * t**2
        return cls(square, (1 - square * t**2) / below, 2 * t / below, 2 * t**2 / below)

    @property
    def double(self) -> Turn:
        """The same of the angle 2 theta."""
        cosine, sine = 1 - 2 * self.square * self.sine**2, self.sine * self.cosine
        return Turn(4 * self.square, cosine, sine, self.sine**2 / 2)


STILL = Turn(*map(sympy.S, (0, 1, 1, sympy.S.Half)))
"""No turn at all."""


def exponential(X: Matrix, turn: Turn = STILL) -> Matrix:
    """exp(X), X (m, m) rational with eigenvalues 0 and +-i theta alone; ValueError for others."""
    whole = _rational(X)
    still, moving = jordan(whole)
    if _any(still * (still * still + _scaled(_one(whole), turn.square))):
        raise ValueError("there are eigenvalues besides 0 and one pair +-i theta")
    turned = _one(whole) + _scaled(still, turn.sine) + _scaled(still * still, turn.versine)
    return (turned * _series(moving)).to_Matrix()


def derivative(X: Matrix, moved: Matrix, turn: Turn = STILL) -> Matrix:
    """d/dt exp(X) for X' = moved: the corner of the exponential of [[X, X'], [0, X]]."""
    m = X.rows
    whole = Matrix.vstack(Matrix.hstack(X, moved), Matrix.hstack(0 * X, X))
    return exponential(whole, turn)[:m, m:]


def one_parameter(E: Matrix, t: Rational) -> Matrix:
    """An element other than 1, rational, where every polynomial that vanishes on exp(R E) does.

    E nilpotent, or with rational eigenvalues, or 0 and one pair whose sum is 0, or a sum of these
    that commute. Raises ValueError for other eigenvalues.
    """
    whole = _rational(E)
    still, moving = jordan(whole)
    value = _one(whole) - _one(whole)
    roots, squares = _eigenvalues(whole)
    common = math.lcm(*(int(root.q) for root in roots))
    for root in roots:
        value += _scaled(_projector(still, Poly(Z - root, Z)), (1 + t) ** int(root * common))
    for square in squares:
        turn = Turn.at(square, t)
        onto = _projector(still, Poly(Z**2 + square, Z))
        value += _scaled(onto, turn.cosine) + _scaled(onto * still, turn.sine)
    return (value * _series(_scaled(moving, t))).to_Matrix()


def jordan(X: DomainMatrix) -> tuple[DomainMatrix, DomainMatrix]:
    """X = S + N, S diagonalisable, N nilpotent, both polynomials in X: Newton's iteration."""
    minimal = Poly(X.charpoly(), Z, domain=QQ).sqf_part()
    slope, still = minimal.diff(), X
    while _any(off := _at(minimal, still)):
        still = still - off * _at(slope, still).inv()
    return still, X - still


def square_of_pair(X: Matrix) -> Rational:
    """theta^2 of the one pair of eigenvalues +-i theta of X, 0 where there is none."""
    roots, squares = _eigenvalues(_rational(X))
    if any(roots) or len(squares) > 1:
        raise ValueError("there are eigenvalues besides 0 and one pair +-i theta")
    return squares[0] if squares else sympy.S.Zero


def _eigenvalues(X: DomainMatrix) -> tuple[list[Rational], list[Rational]]:
    """Rational ones, and theta^2 of the pair +-i theta; ValueError for any others."""
    roots: list[Rational] = []
    squares: list[Rational] = []
    for factor, _ in Poly(X.charpoly(), Z, domain=QQ).factor_list()[1]:
        coefficients = factor.monic().all_coeffs()
        if len(coefficients) == 2:
            roots.append(-coefficients[1])
        elif len(coefficients) == 3 and not coefficients[1] and not squares:
            squares.append(coefficients[2])
        else:
            raise ValueError(f"no exact element is known from eigenvalues {factor.as_expr()} = 0")
    return roots, squares


def _projector(still: DomainMatrix, factor: Poly) -> DomainMatrix:
    """Onto the eigenvectors of a factor of the minimal polynomial, along all others."""
    others = Poly(still.charpoly(), Z, domain=QQ).sqf_part().quo(factor)
    inverse = others.rem(factor).invert(factor) if others.degree() else Poly(1, Z, domain=QQ)
    return _at(inverse * others, still)


def _rational(X: Matrix) -> DomainMatrix:
    return DomainMatrix.from_Matrix(X).convert_to(QQ).to_dense()


def _series(N: DomainMatrix) -> DomainMatrix:
    """exp(N) of a nilpotent matrix."""
    power = total = _one(N)
    for order in range(1, N.shape[0]):
        power = _scaled(power * N, Rational(1, order))
        total = total + power
    return total


def _at(p: Poly, X: DomainMatrix) -> DomainMatrix:
    """p(X), by Horner."""
    value = _one(X) - _one(X)
    for coefficient in p.all_coeffs():
        value = value * X + _scaled(_one(X), coefficient)
    return value


def _one(X: DomainMatrix) -> DomainMatrix:
    return DomainMatrix.eye(X.shape[0], QQ).to_dense()


def _scaled(X: DomainMatrix, factor: Any) -> DomainMatrix:
    return X * QQ.from_sympy(sympy.sympify(factor))


def _any(X: DomainMatrix) -> bool:
    return not X.is_zero_matrix
