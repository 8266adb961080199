"""The CasADi twin agrees with the truth where the printed formulas are well conditioned."""

import casadi as ca
import numpy as np
import pytest
from numpy.typing import NDArray

from derive.verify.oracle import casadi_twin, truth

INERTIA = ((3.6046, -0.0706, 0.1491), (-0.0706, 8.6868, 0.0449), (0.1491, 0.0449, 9.3484))
ROWS = 12
VECTORS = ("nu", "nu_r", "nu_r_dot", "momentum", "external")
PAIRS = sorted(truth.LAWS)
Array = NDArray[np.float64]


def quaternions(random: np.random.Generator, angles: Array) -> Array:
    axes = random.normal(size=(len(angles), 3))
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    return np.column_stack([np.cos(angles / 2), np.sin(angles / 2)[:, None] * axes])


def matrix(q: Array) -> Array:
    w, v = q[0], q[1:]
    hat = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    return np.asarray(np.eye(3) + 2 * w * hat + 2 * hat @ hat)


def product(p: Array, q: Array) -> Array:
    w = p[0] * q[0] - p[1:] @ q[1:]
    return np.concatenate([[w], p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:])])


def stored(group: str, batch: Array) -> Array:
    return batch if group == "S3" else np.array([matrix(q).ravel() for q in batch])


def scenario(group: str, seed: int, *, far: bool = False) -> dict[str, Array]:
    """Twelve states; the error angle is in (0.3, 2.8), or with `far` in (3.4, 5.9)."""
    random = np.random.default_rng(seed)
    q_r = quaternions(random, random.uniform(0, 3, ROWS))
    q_e = quaternions(random, random.uniform(0.3, 2.8, ROWS))
    q_e = q_e * [-1, 1, 1, 1] if far else q_e
    q = np.array([product(a, b) for a, b in zip(q_r, q_e, strict=True)])
    inputs = {"g": stored(group, q), "g_r": stored(group, q_r)}
    inputs |= {name: random.normal(size=(ROWS, 3)) for name in VECTORS}
    return inputs | {"inertia": np.array(INERTIA), "lambda": np.array(0.7), "k_s": np.array(1.3)}


def true_rows(group: str, law: str, inputs: dict[str, Array]) -> dict[str, Array]:
    order = ("g_r", "g", *VECTORS)
    states = zip(*(inputs[name].tolist() for name in order), strict=True)
    rows = [truth.tracking(group, law, INERTIA, 0.7, 1.3, *state) for state in states]
    return {
        name: np.array([[float(x) for x in row[name]] for row in rows])
        for name in casadi_twin.OUTPUTS
    }


@pytest.mark.parametrize(
    ("group", "law", "far"),
    [(*pair, False) for pair in PAIRS]
    + [("S3", law, True) for group, law in PAIRS if group == "S3"],
)
def test_twin_agrees_with_truth(group: str, law: str, far: bool) -> None:
    inputs = scenario(group, seed=PAIRS.index((group, law)), far=far)
    measured = casadi_twin.evaluate(casadi_twin.twin(group, law), inputs)
    expected = true_rows(group, law, inputs)
    for name in casadi_twin.OUTPUTS:
        scale = np.linalg.norm(expected[name], axis=1)
        distance = np.linalg.norm(measured[name] - expected[name], axis=1)
        assert np.max(distance / scale) < 1e-10, name


def test_a_batch_equals_its_rows() -> None:
    function = casadi_twin.twin("SO3", "log")
    inputs = scenario("SO3", seed=7)
    inertias = np.array(INERTIA) * np.linspace(1, 3, ROWS)[:, None, None]
    inertias[:, 0, 1] += 1e-3  # not symmetric: a transposed layout would show
    gains = np.linspace(0.1, 2, ROWS)
    inputs |= {"inertia": inertias, "lambda": gains}
    batch = casadi_twin.evaluate(function, inputs)
    for row in range(ROWS):
        state = [inputs[name][row] for name in casadi_twin.INPUTS[:-1]]
        one = function.call([*map(ca.DM, state), ca.DM(1.3)])
        for name, value in zip(casadi_twin.OUTPUTS, one, strict=True):
            np.testing.assert_allclose(batch[name][row], np.array(value).ravel(), rtol=1e-13)


def test_a_missing_input_is_named() -> None:
    with pytest.raises(KeyError, match="k_s"):
        casadi_twin.evaluate(casadi_twin.twin("S3", "log"), {"g": np.zeros(4)})


def test_every_law_of_the_truth_has_a_twin() -> None:
    assert all(casadi_twin.twin(*pair).n_out() == 4 for pair in PAIRS)
