"""A basis is judged exactly: shapes, independence, closure, with the offending matrix or pair."""

from fractions import Fraction
from itertools import combinations
from random import Random

import numpy as np
import pytest
from sympy import Matrix as Exact
from sympy import zeros

from derive.lie.basis import BadBasis, Basis, Matrix, bracket, check
from derive.lie.catalogue import GROUPS, named


def of(*matrices: object) -> Basis:
    """Nested lists of numbers as a basis."""
    return tuple(
        tuple(tuple(Fraction(entry) for entry in row) for row in np.array(matrix, object))
        for matrix in matrices
    )


def single(size: int, *ones: tuple[int, int]) -> list[list[int]]:
    return [[int((i, j) in ones) for j in range(size)] for i in range(size)]


E, F, H = [[0, 1], [0, 0]], [[0, 0], [1, 0]], [[1, 0], [0, -1]]
X, Y, Z = single(3, (0, 1)), single(3, (1, 2)), single(3, (0, 2))

ALGEBRAS: dict[str, Basis] = {
    "sl2": of(E, F, H),
    "heisenberg": of(X, Y, Z),
    "affine line": of([[1, 0], [0, 0]], [[0, 1], [0, 0]]),
    "gl2": of(E, F, H, [[1, 0], [0, 1]]),
    "one matrix": of([[1, 2], [3, 4]]),
    "diagonal": of([[1, 0], [0, 0]], [[0, 0], [0, 1]]),
    "one number": of([[5]]),
    **{name: of(*(e.tolist() for e in group.basis)) for name, group in GROUPS.items()},
    "SE2 x SO2": of(*(e.tolist() for e in named("SE2 x SO2").basis)),
}
small = {name: basis for name, basis in ALGEBRAS.items() if len(basis[0]) <= 6 and len(basis) <= 12}
each_algebra = pytest.mark.parametrize("basis", small.values(), ids=small)


def mixed(basis: Basis, seed: int) -> Basis:
    """The same algebra in another basis: a unitriangular mix with ratios, and a scale for each."""
    random = Random(seed)
    n, size = len(basis), len(basis[0])

    def weight(i: int, j: int) -> Fraction:
        if i < j:
            return Fraction()
        return Fraction(random.choice((-3, -1, 2, 5)), random.randint(1, 7))

    weights = [[weight(i, j) for j in range(n)] for i in range(n)]
    return tuple(
        tuple(
            tuple(sum((w * e[r][c] for w, e in zip(row, basis, strict=True)), Fraction())
                  for c in range(size))
            for r in range(size)
        )
        for row in weights
    )  # fmt: skip


def test_the_groups_of_bodies_are_among_them() -> None:
    assert {"SO2", "SO3", "S3", "SE2", "SE3", "SE23", "R3"} <= set(small)


@each_algebra
@pytest.mark.parametrize("seed", range(3))
def test_an_algebra_is_accepted_in_every_basis(basis: Basis, seed: int) -> None:
    check(basis)
    check(mixed(basis, seed))


@each_algebra
def test_structure_constants_are_exact_and_obey_jacobi(basis: Basis) -> None:
    """What `check` accepts has constants, which sympy solves for, and they are an algebra's."""
    basis = mixed(basis, 7)
    n = len(basis)
    stacked = Exact([[entry for row in e for entry in row] for e in basis]).T
    ad = [zeros(n, n) for _ in basis]
    for i, a in enumerate(basis):
        for j, b in enumerate(basis):
            flat = Exact([entry for row in bracket(a, b) for entry in row])
            constants = (stacked.T * stacked).LUsolve(stacked.T * flat)
            assert stacked * constants == flat
            assert Exact(a) * Exact(b) - Exact(b) * Exact(a) == Exact(bracket(a, b))
            ad[i][:, j] = constants
    for i, j in combinations(range(n), 2):
        of_bracket = sum((ad[i][k, j] * ad[k] for k in range(n)), zeros(n, n))
        assert ad[i] * ad[j] - ad[j] * ad[i] == of_bracket


def tiny(matrix: Matrix, row: int, column: int) -> Matrix:
    """The matrix with one entry moved by what no float would see."""
    return tuple(
        tuple(x + Fraction(1, 10**40) * ((i, j) == (row, column)) for j, x in enumerate(line))
        for i, line in enumerate(matrix)
    )


@pytest.mark.parametrize(
    ("name", "place"),
    [("sl2", (1, 1)), ("heisenberg", (2, 0)), ("SO3", (1, 1)), ("SE2", (2, 0)), ("SE3", (3, 0))],
)
def test_closure_is_exact(name: str, place: tuple[int, int]) -> None:
    basis = ALGEBRAS[name]
    with pytest.raises(BadBasis, match="closed"):
        check((tiny(basis[0], *place), *basis[1:]))


def test_independence_is_exact() -> None:
    a = of([[0, 1], [0, 0]])[0]
    with pytest.raises(BadBasis, match="closed"):
        check((a, tiny(a, 1, 0)))
    with pytest.raises(BadBasis, match="E_2 is a combination of E_1"):
        check((tiny(a, 1, 0), tuple(tuple(-x / 3 for x in row) for row in tiny(a, 1, 0))))


BAD = [
    ("empty", (), "1 to 12 matrices", "0 of them"),
    ("many", of(*[E] * 13), "1 to 12 matrices", "13 of them"),
    ("large", of(single(7, (0, 1))), "1 to 6 rows", "E_1 with 7 rows of 7 entries"),
    ("no rows", (of(E)[0], ()), "square", "E_2 with 0 rows of no entries"),
    ("flat", of([[1, 2]]), "square", "E_1 with 1 row of 2 entries"),
    ("ragged", (((Fraction(1), Fraction(0)), (Fraction(1),)),), "square", "of 1 and 2 entries"),
    ("unequal", of(E, F, X), "2 by 2 as E_1", "E_3, which is 3 by 3"),
    ("zero first", of([[0, 0], [0, 0]], E), "independent", "E_1 is zero"),
    ("zero", of(E, [[0, 0], [0, 0]]), "independent", "E_2 is zero"),
    ("twice", of(E, F, E, H), "independent", "E_3 is a combination of E_1 to E_2"),
    ("dependent", of(E, F, H, [[2, 3], [5, -2]]), "independent", "E_4 is a combination of E_1 to"),
    ("open", of(E, F), "closed", "[E_1, E_2], which is 1.41421 away"),
    ("open later", of(X, Z, Y, single(3, (1, 0))), "closed", "[E_1, E_4], which is 1.41421 away"),
]


@pytest.mark.parametrize(
    ("basis", "expected", "found"), [c[1:] for c in BAD], ids=[c[0] for c in BAD]
)
def test_a_bad_basis_is_told(basis: Basis, expected: str, found: str) -> None:
    with pytest.raises(BadBasis) as caught:
        check(basis)
    assert expected in caught.value.expected
    assert found in caught.value.found
    assert caught.value.remedy
    assert all(part in str(caught.value) for part in (caught.value.found, caught.value.remedy))


@pytest.mark.parametrize("seed", range(20))
def test_how_far_out_is_what_least_squares_finds(seed: int) -> None:
    random = np.random.default_rng(seed)
    floats = random.integers(-4, 5, (3, 3, 3)).astype(float)
    with pytest.raises(BadBasis, match="closed") as caught:
        check(of(*floats.astype(int).tolist()))
    pair, _, told = caught.value.found.partition(", which is ")
    i, j = (int(mark) - 1 for mark in pair.replace("E_", "").strip("[]").split(", "))
    outside = (floats[i] @ floats[j] - floats[j] @ floats[i]).ravel()
    stacked = floats.reshape(3, 9).T
    nearest = stacked @ np.linalg.lstsq(stacked, outside, rcond=None)[0]
    np.testing.assert_allclose(float(told.split()[0]), np.linalg.norm(outside - nearest), rtol=1e-5)
