"""LSF, printed and corrected, and PD+ against the paper's formulas, and the loops they close."""

from fractions import Fraction
from random import Random
from typing import Any

import numpy as np
import pytest
import sympy
from sympy import Matrix, Rational

from derive.control.controller import WRITERS, routines
from derive.control.table import CONTROLLERS
from derive.lie.kernel import TINY
from derive.routine.derivation import Derivation
from derive.verify.oracle import baseline_truth
from tests import points
from tests.control.drawn import LAWS, full, numbers, square
from tests.groups import ALL
from tests.points import vector

SO3 = ALL["SO3"]
NAMES = ("lsf_printed", "lsf", "pd_plus")
OPTIONS = ("external", "momentum")
each_baseline = pytest.mark.parametrize("name", NAMES)


def derived(name: str, *options: str) -> Derivation:
    (write,) = WRITERS[name]
    return write(SO3, LAWS["SO3", CONTROLLERS[name].law or ""], full(SO3), options)


def drawn(name: str, seed: int) -> dict[str, Any]:
    """Exact inputs by name, gains of the controller among them."""
    given, rng = numbers(SO3, seed), Random(seed)
    gains = {
        gain: abs(x) + 1 for gain, x in zip(CONTROLLERS[name].names, vector(rng, 2), strict=True)
    }
    wanted = ("inertia", "g", "nu", "momentum", "external", "g_r", "nu_r", "nu_r_dot")
    return gains | {key: given[key] for key in wanted}


def rational(value: Any) -> Rational:
    exact = Fraction(value)
    return Rational(exact.numerator, exact.denominator)


def run(d: Derivation, given: dict[str, Any]) -> dict[str, Matrix]:
    """Outputs in 50 digits."""
    values: dict[Any, Any] = {TINY: sympy.S.Zero}
    for q in d.inputs:
        row = [given[q.name]] if q.is_scalar else given[q.name]
        values |= dict(zip(q.symbols(), map(rational, row), strict=True))
    return {key: Matrix(value) for key, value in d.evaluate(values).items()}


def papers(name: str, given: dict[str, Any], *options: str) -> dict[str, Matrix]:
    gains = {gain: given[gain] for gain in CONTROLLERS[name].names}
    state = {key: given[key] for key in ("g_r", "g", "nu", "nu_r", "nu_r_dot", *options)}
    found = baseline_truth.tracking(name, square(given["inertia"]).tolist(), gains, **state)
    return {key: Matrix([sympy.Float(str(x), 60) for x in value]) for key, value in found.items()}


@each_baseline
@pytest.mark.parametrize("options", [(), OPTIONS, ("momentum",), ("external",)], ids="-".join)
@pytest.mark.parametrize("seed", range(3))
def test_the_command_is_the_papers(name: str, options: tuple[str, ...], seed: int) -> None:
    given = drawn(name, seed)
    found, wanted = run(derived(name, *options), given), papers(name, given, *options)
    assert set(found) == {"force", "s", "nu_u", "clearance"}
    for key in ("force", "s", "nu_u"):
        assert (found[key] - wanted[key]).norm() < 1e-45 * (1 + wanted[key].norm()), key


def test_the_attitude_error_of_lsf_is_the_papers_in_the_body_frame() -> None:
    """R^T (R R_r^T - R_r R^T)^vee is (R_e - R_e^T)^vee, R_e = R_r^T R, and 2 sin(angle) axis."""
    from scipy.spatial.transform import Rotation

    rotations = Rotation.random(40, random_state=5).as_matrix()
    for R, R_r in zip(rotations[::2], rotations[1::2], strict=True):
        spatial, R_e = R @ R_r.T, R_r.T @ R
        error = R.T @ odd(spatial)
        np.testing.assert_allclose(error, odd(R_e), atol=1e-14)
        turn = Rotation.from_matrix(R_e).as_rotvec()
        angle = np.linalg.norm(turn)
        np.testing.assert_allclose(error, 2 * np.sin(angle) * turn / angle, atol=1e-14)
        psi = 1 / (2 * np.sqrt(1 + np.trace(R_e)))
        np.testing.assert_allclose(psi * odd(R_e), np.sin(angle / 2) * turn / angle, atol=1e-12)


def odd(a: Any) -> Any:
    """(A - A^T)^vee."""
    return np.array([a[2, 1] - a[1, 2], a[0, 2] - a[2, 0], a[1, 0] - a[0, 1]])


def closed(name: str, seed: int) -> tuple[Matrix, Matrix, dict[str, Any]]:
    """J (nu' - nu_r' - nu x nu_r) and -k J s, exactly: Euler's equation is written here."""
    d, given = derived(name, *OPTIONS), drawn(name, seed)
    known: dict[Any, Any] = {}
    for q in d.inputs:
        row = [given[q.name]] if q.is_scalar else given[q.name]
        known |= dict(zip(q.symbols(), map(rational, row), strict=True))
    for symbol, term in d.terms():
        known[symbol] = term.xreplace(known)
    out = {q.name: Matrix([x.xreplace(known) for x in row]) for q, row in d.outputs}
    J = Matrix(3, 3, [rational(x) for x in square(given["inertia"]).ravel()])
    at = {key: Matrix([rational(x) for x in given[key]]) for key in given if key[:2] != "k"
          and not isinstance(given[key], Fraction)}  # fmt: skip
    nu, nu_r = at["nu"], at["nu_r"]
    pushed = (J * nu + at["momentum"]).cross(nu) + out["force"] + at["external"]
    left = pushed - J * (at["nu_r_dot"] + nu.cross(nu_r))
    return left, -rational(given["k"]) * J * out["s"], {"J": J, "nu": nu, "nu_r": nu_r}


@pytest.mark.parametrize("seed", range(4))
def test_the_corrected_lsf_closes_its_loop_exactly(seed: int) -> None:
    """In ratios: the rate of R (nu - nu_r) is R (nu' - nu_r' - nu x nu_r), and falls by -k s."""
    left, right, _ = closed("lsf", seed)
    assert left == right
    assert all(x.is_Rational for x in left)


@pytest.mark.parametrize("seed", range(4))
def test_the_printed_lsf_does_not(seed: int) -> None:
    """What it lacks is exactly (J + 1) (nu x nu_r), whose second part has no unit of a torque."""
    left, right, at = closed("lsf_printed", seed)
    missing = at["nu"].cross(at["nu_r"])
    assert left - right == -(at["J"] + sympy.eye(3)) * missing
    assert left != right


def test_where_the_reference_rests_both_lsf_agree() -> None:
    given = {**drawn("lsf", 1), "nu_r": [Fraction(0)] * 3}
    printed, corrected = (run(derived(name), given) for name in ("lsf_printed", "lsf"))
    assert printed["force"] == corrected["force"]


def test_on_the_reference_pd_plus_is_the_force_of_the_reference() -> None:
    """With R = R_r and Omega = Omega_r: J Omega_r' = J Omega_r x Omega_r + force."""
    given = drawn("pd_plus", 2)
    given |= {"g": given["g_r"], "nu": given["nu_r"]}
    found = run(derived("pd_plus"), given)
    J, nu = square(given["inertia"]), np.array(given["nu"])
    wanted = J @ np.array(given["nu_r_dot"]) - np.cross(J @ nu, nu)
    assert found["s"].norm() < 1e-48
    assert (found["force"] - Matrix([rational(x) for x in wanted])).norm() < 1e-45


@each_baseline
def test_left_invariance(name: str) -> None:
    """One rotation before both attitudes changes nothing."""
    given = drawn(name, 3)
    shift = points.embedded(SO3, points.point(SO3, Random(8)))
    moved = {
        key: points.stored(SO3, shift @ points.embedded(SO3, given[key])) for key in ("g", "g_r")
    }
    found, there = run(derived(name), given), run(derived(name), {**given, **moved})
    for key in ("force", "s", "nu_u"):
        assert (found[key] - there[key]).norm() < 1e-45


@each_baseline
def test_its_routines_have_no_rate(name: str) -> None:
    law = LAWS["SO3", CONTROLLERS[name].law or ""]
    parts = routines(SO3, law, name, full(SO3))
    assert parts.main.name == "tracking"
    assert [q.name for q, _ in parts.main.outputs] == ["force", "s", "nu_u", "clearance"]
    assert [d.name for d in parts.public] == ["plant"]


@each_baseline
@pytest.mark.parametrize(("group", "law"), [("S3", "vec"), ("SE3", "skew"), ("SO3", "log")])
def test_elsewhere_and_with_another_law_it_is_refused(name: str, group: str, law: str) -> None:
    with pytest.raises(ValueError, match=f"{name} exists on SO3, with law .*, not on {group}"):
        routines(ALL[group], LAWS[group, law], name, full(ALL[group]))


def test_lsf_divides_by_its_gain_alone_and_takes_no_root() -> None:
    for name in ("lsf_printed", "lsf"):
        d = derived(name)
        powers = [p for _, value in d.terms() for p in value.atoms(sympy.Pow)]
        assert {str(p) for p in powers if not p.exp.is_positive} == {"1/k"}
        assert not any(p.exp == sympy.S.Half for p in powers)
