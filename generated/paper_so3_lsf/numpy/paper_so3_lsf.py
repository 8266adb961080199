"""paper_so3_lsf: lsf on SO3, law {'name': 'tracking', 'doc': 'LSF force that tracks (g_r, nu_r)',
'source': 'eq. (Ctrls2) corrected', 'inputs': [{'name': 'inertia', 'size': 6, 'unit': 'kg m^2',
'doc': 'inertia, upper triangle, row by row', 'source': '', 'is_scalar': False, 'holder': 'params',
'member': 'inertia', 'entries': [['inertia_0', 0], ['inertia_1', 1], ['inertia_2', 2], ['inertia_3',
3], ['inertia_4', 4], ['inertia_5', 5]], 'argument': 'inertia', 'shape': (6,)}, {'name': 'k',
'size': 1, 'unit': '1/s', 'doc': 'gain of s', 'source': '', 'is_scalar': True, 'holder': 'params',
'member': 'k', 'entries': [['k', 0]], 'argument': 'k', 'shape': (1,)}, {'name': 'kappa', 'size': 1,
'unit': '1/s^2', 'doc': 'gain of the attitude error', 'source': '', 'is_scalar': True, 'holder':
'params', 'member': 'kappa', 'entries': [['kappa', 0]], 'argument': 'kappa', 'shape': (1,)},
{'name': 'nu', 'size': 3, 'unit': 'rad/s', 'doc': 'body velocity', 'source': '', 'is_scalar': False,
'holder': 'state', 'member': 'nu', 'entries': [['nu_0', 0], ['nu_1', 1], ['nu_2', 2]], 'argument':
'nu', 'shape': (3,)}, {'name': 'nu_r', 'size': 3, 'unit': 'rad/s', 'doc': 'reference velocity,
reference body frame', 'source': '', 'is_scalar': False, 'holder': 'reference', 'member': 'nu',
'entries': [['nu_r_0', 0], ['nu_r_1', 1], ['nu_r_2', 2]], 'argument': 'nu_r', 'shape': (3,)},
{'name': 'nu_r_dot', 'size': 3, 'unit': 'rad/s^2', 'doc': 'its rate', 'source': '', 'is_scalar':
False, 'holder': 'reference', 'member': 'nu_dot', 'entries': [['nu_r_dot_0', 0], ['nu_r_dot_1', 1],
['nu_r_dot_2', 2]], 'argument': 'nu_r_dot', 'shape': (3,)}, {'name': 'g_e', 'size': 9, 'unit': '1',
'doc': 'error, g_r^-1 g', 'source': 'eq. (velErr)', 'is_scalar': False, 'holder': '', 'member':
'g_e', 'entries': [['g_e_1', 1], ['g_e_2', 2], ['g_e_3', 3], ['g_e_5', 5], ['g_e_6', 6], ['g_e_7',
7]], 'argument': 'g_e', 'shape': (9,)}], 'steps': [{'name': 'nu_u', 'size': 3, 'unit': 'rad', 'doc':
'attitude error, 2 sin(angle) axis', 'source': 'eq. (s2)', 'is_scalar': False, 'holder': '',
'member': '', 'names': ['nu_u_0', 'nu_u_1', 'nu_u_2'], 'lines': [['nu_u_0', 'g_e_7 - g_e_5'],
['nu_u_1', 'g_e_2 - g_e_6'], ['nu_u_2', 'g_e_3 - g_e_1']], 'cases': []}, {'name': 'raw', 'size': 3,
'unit': 'rad/s', 'doc': 'nu - nu_r, each in its own body frame', 'source': '', 'is_scalar': False,
'holder': '', 'member': '', 'names': ['raw_0', 'raw_1', 'raw_2'], 'lines': [['raw_0', 'nu_0 -
nu_r_0'], ['raw_1', 'nu_1 - nu_r_1'], ['raw_2', 'nu_2 - nu_r_2']], 'cases': []}, {'name': 'ratio',
'size': 1, 'unit': '1/s', 'doc': 'kappa/k', 'source': '', 'is_scalar': True, 'holder': '', 'member':
'', 'names': ['ratio'], 'lines': [['ratio', 'kappa/k']], 'cases': []}, {'name': 's', 'size': 3,
'unit': 'rad/s', 'doc': 'sliding variable', 'source': 'eq. (s2)', 'is_scalar': False, 'holder': '',
'member': '', 'names': ['s_0', 's_1', 's_2'], 'lines': [['s_0', 'raw_0 + nu_u_0*ratio'], ['s_1',
'raw_1 + nu_u_1*ratio'], ['s_2', 'raw_2 + nu_u_2*ratio']], 'cases': []}, {'name': 'crossing',
'size': 3, 'unit': 'rad/s^2', 'doc': 'nu x nu_r', 'source': '', 'is_scalar': False, 'holder': '',
'member': '', 'names': ['crossing_0', 'crossing_1', 'crossing_2'], 'lines': [['crossing_0',
'nu_1*nu_r_2 - nu_2*nu_r_1'], ['crossing_1', 'nu_2*nu_r_0 - nu_0*nu_r_2'], ['crossing_2',
'nu_0*nu_r_1 - nu_1*nu_r_0']], 'cases': []}, {'name': 'wanted', 'size': 3, 'unit': 'rad/s^2', 'doc':
'acceleration asked for', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names':
['wanted_0', 'wanted_1', 'wanted_2'], 'lines': [['wanted_0', 'crossing_0 + nu_r_dot_0 - k*s_0'],
['wanted_1', 'crossing_1 + nu_r_dot_1 - k*s_1'], ['wanted_2', 'crossing_2 + nu_r_dot_2 - k*s_2']],
'cases': []}, {'name': 'momentum', 'size': 3, 'unit': 'N m s', 'doc': 'I nu', 'source': '',
'is_scalar': False, 'holder': '', 'member': '', 'names': ['momentum_0', 'momentum_1', 'momentum_2'],
'lines': [['momentum_0', 'inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2'], ['momentum_1',
'inertia_1*nu_0 + inertia_3*nu_1 + inertia_4*nu_2'], ['momentum_2', 'inertia_2*nu_0 + inertia_4*nu_1
+ inertia_5*nu_2']], 'cases': []}, {'name': 'force', 'size': 3, 'unit': 'N m', 'doc': 'control
force', 'source': 'eq. (Ctrls2) corrected', 'is_scalar': False, 'holder': '', 'member': '', 'names':
['force_0', 'force_1', 'force_2'], 'lines': [['force_0', 'inertia_0*wanted_0 + inertia_1*wanted_1 +
inertia_2*wanted_2 + momentum_2*nu_1 - momentum_1*nu_2'], ['force_1', 'inertia_1*wanted_0 +
inertia_3*wanted_1 + inertia_4*wanted_2 + momentum_0*nu_2 - momentum_2*nu_0'], ['force_2',
'inertia_2*wanted_0 + inertia_4*wanted_1 + inertia_5*wanted_2 + momentum_1*nu_0 -
momentum_0*nu_1']], 'cases': []}], 'outputs': [{'name': 'force', 'size': 3, 'unit': 'N m', 'doc':
'control force', 'source': '', 'is_scalar': False, 'holder': 'command', 'member': 'force',
'entries': ['force_0', 'force_1', 'force_2']}, {'name': 's', 'size': 3, 'unit': 'rad/s', 'doc':
'sliding variable', 'source': '', 'is_scalar': False, 'holder': 'command', 'member': 's', 'entries':
['s_0', 's_1', 's_2']}, {'name': 'nu_u', 'size': 3, 'unit': 'rad', 'doc': 'attitude error',
'source': '', 'is_scalar': False, 'holder': 'command', 'member': 'nu_u', 'entries': ['nu_u_0',
'nu_u_1', 'nu_u_2']}, {'name': 'clearance', 'size': 1, 'unit': '1', 'doc': 'distance from the cut
locus of the law', 'source': '', 'is_scalar': True, 'holder': '', 'member': 'clearance', 'entries':
['1.0']}], 'operations': 73, 'temporaries': 22, 'symbol': 'tracking', 'is_public': False, 'holders':
['params', 'state', 'reference'], 'arguments': ['nu', 'nu_r', 'nu_r_dot', 'g_e'], 'has_reference':
True, 'writes': ['command', 'clearance'], 'public_writes': ['command', 'clearance']}, double
precision, batched.

Generated by derive from the vehicle file paper_so3_lsf.toml; regenerate instead of editing.
Configuration: rotation matrix, row by row.
Velocities and forces are in the body frame, the reference velocity in the reference body
frame. Every argument and every field of Params broadcasts over leading axes.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

MAX_INPUT = 1.0e6  # largest magnitude of a number in state or reference
MAX_ENTRY = 1.01  # of an entry of the error that the group keeps at 1
MAX_REACH = 4.0e6  # of any other entry of the error
MOST_DRIFT = 0.1  # largest max_drift that may be asked for
NEAR_CUT = 0.001  # clearance below which NEAR_CUT_LOCUS is flagged
REFUSED_CUT = 1.0e-8  # clearance below which a law with a pole is refused
MAX_PARAM = 1.0e9  # largest inertia entry, force limit, or other gain
MIN_GAIN = 1.0e-9  # least gain
MAX_RATE = 1.0e4  # largest gain in 1/s

OK = 0  # the command is good
SATURATED = 1  # a force limit was reached
NEAR_CUT_LOCUS = 2  # the error is close to where the law jumps
NOT_ON_GROUP = 16  # the error is off the group by more than max_drift
OUT_OF_RANGE = 17  # beyond MAX_INPUT, or too near a pole of the law
NONFINITE_INPUT = 18  # an input, or what it leads to, is not finite
BAD_PARAMS = 19  # found by check_params

BOUNDS = (MAX_ENTRY, MAX_ENTRY, MAX_ENTRY, MAX_ENTRY, MAX_ENTRY, MAX_ENTRY, MAX_ENTRY, MAX_ENTRY,
          MAX_ENTRY)  # of the error's entries
FREE = np.array(BOUNDS) > MAX_ENTRY
CHUNK = 4096  # rows computed together, so that their temporaries stay in the cache
Array = Any  # a numpy array, or what np.asarray makes one of


class Params(NamedTuple):
    """Inertia, upper triangle row by row (..., 6), and gains, each (...).

    What `control` keeps to has the vehicle's values where it is left out.
    """

    inertia: Array
    k: Array
    kappa: Array
    max_drift: Array = 1.0e-6  # largest distance of the error from the group [1]


class Command(NamedTuple):
    """Force, sliding variable and attitude error, (..., 3) each; status (...)."""

    force: Array
    s: Array
    nu_u: Array
    status: Array


DEFAULTS = Params(
    inertia=(3.6046, -0.0706, 0.1491, 8.6868, 0.0449, 9.3484),
    k=1.0,
    kappa=0.5,
)


def control(
    g: Array, nu: Array, g_r: Array, nu_r: Array, nu_r_dot: Array, params: Params = DEFAULTS
) -> Command:
    """Guarded controller: LSF force that tracks (g_r, nu_r); eq. (Ctrls2) corrected.

    Arguments as for `tracking`, real numbers only, computed and judged in double; TypeError for
    others. Where the status is 16 or larger, the whole command is zero.
    """
    given = [
        _real("inertia", params.inertia, (6,)),
        _real("k", params.k, ()),
        _real("kappa", params.kappa, ()),
        _real("g", g, (3, 3)),
        _real("nu", nu, (3,)),
        _real("g_r", g_r, (3, 3)),
        _real("nu_r", nu_r, (3,)),
        _real("nu_r_dot", nu_r_dot, (3,)),
    ]
    max_drift = _real("max_drift", params.max_drift, ())
    with np.errstate(all="ignore"):
        *command, clearance = _batched(_law, given)
        g_e = _batched(_error, [given[3], given[5]])[0]
        good = (np.abs(g_e) <= BOUNDS).all(-1)
        good = good & ((np.abs(given[3]) <= MAX_INPUT) | ~FREE).all(-1)
        good = good & (np.abs(given[4]) <= MAX_INPUT).all(-1)
        good = good & ((np.abs(given[5]) <= MAX_INPUT) | ~FREE).all(-1)
        good = good & (np.abs(given[6]) <= MAX_INPUT).all(-1)
        good = good & (np.abs(given[7]) <= MAX_INPUT).all(-1)
        good = good & (_batched(_drift, [g_e])[0] <= max_drift * max_drift)[..., 0]
        status = np.where(np.isfinite(command[0]).all(-1), OK, NONFINITE_INPUT)
        near = np.where(clearance[..., 0] < NEAR_CUT, NEAR_CUT_LOCUS, OK)
        far = (~(np.abs(g_e) <= BOUNDS) & FREE).any(-1)
        refused = np.where(far, OUT_OF_RANGE, NOT_ON_GROUP)
        for rows in (given[3], given[4], given[5], given[6], given[7]):
            refused = np.maximum(refused, _judge(rows))
        status = np.where(good, np.maximum(status, near), refused)
    bad = (status >= 16)[..., None]
    return Command(*(np.where(bad, 0.0, one) for one in command), status)


def check_params(params: Params = DEFAULTS) -> Array:
    """OK or BAD_PARAMS of each set of parameters, (...); real numbers only.

    BAD_PARAMS where a number is not finite or beyond MAX_PARAM, a gain is not positive, or the
    inertia is not positive definite, or not zero where the derivation took a zero for granted.
    """
    given = [
        _real("inertia", params.inertia, (6,)),
        _real("k", params.k, ()),
        _real("kappa", params.kappa, ()),
    ]
    inertia, *gains = given
    with np.errstate(all="ignore"):
        pivots = _batched(_definiteness, [inertia])[0]
        good = (np.abs(inertia) <= MAX_PARAM).all(-1) & (pivots > 0.0).all(-1)
        good = good & ((gains[0] >= MIN_GAIN) & (gains[0] <= MAX_RATE))[..., 0]
        good = good & ((gains[1] >= MIN_GAIN) & (gains[1] <= MAX_PARAM))[..., 0]
        drift = _real("max_drift", params.max_drift, ())
        good = good & ((drift > 0.0) & (drift <= MOST_DRIFT))[..., 0]
    return np.where(good, OK, BAD_PARAMS)


def tracking(
    g: Array, nu: Array, g_r: Array, nu_r: Array, nu_r_dot: Array, params: Params = DEFAULTS
) -> Command:
    """LSF force that tracks (g_r, nu_r); eq. (Ctrls2) corrected. Presumes what `control` checks.

    g: configuration: rotation matrix, row by row [1], (..., 3, 3)
    nu: body velocity [rad/s], (..., 3)
    g_r: reference configuration: rotation matrix, row by row [1], (..., 3, 3)
    nu_r: reference velocity, reference body frame [rad/s], (..., 3)
    nu_r_dot: its rate [rad/s^2], (..., 3)
    Nothing is judged: every status is OK.
    Complex arrays pass through, for complex-step derivatives.
    """
    given = [
        _rows("inertia", params.inertia, (6,)),
        _rows("k", params.k, ()),
        _rows("kappa", params.kappa, ()),
        _rows("g", g, (3, 3)),
        _rows("nu", nu, (3,)),
        _rows("g_r", g_r, (3, 3)),
        _rows("nu_r", nu_r, (3,)),
        _rows("nu_r_dot", nu_r_dot, (3,)),
    ]
    command = _batched(_law, given)[:3]
    return Command(*command, np.full(command[0].shape[:-1], OK))


def plant(
    nu: Array, force: Array, params: Params = DEFAULTS
) -> Array:
    """Acceleration under a force, Euler-Poincare; eq. (EulerP). Presumes what `control` checks.

    nu: body velocity [rad/s], (..., 3)
    force: applied force [N m], (..., 3)
    Complex arrays pass through, for complex-step derivatives.
    """
    given = [
        _rows("inertia", params.inertia, (6,)),
        _rows("nu", nu, (3,)),
        _rows("force", force, (3,)),
    ]
    return _batched(_plant, given)[0]


def _real(name: str, value: Array, shape: tuple[int, ...]) -> Array:
    """As _rows, in double; TypeError for a mask, and for what is not real numbers."""
    array = np.asarray(value)
    is_masked = isinstance(value, np.ma.MaskedArray)
    if is_masked or array.dtype.kind not in "biuf":
        found = "a masked array" if is_masked else f"an array of {array.dtype}"
        raise TypeError(f"{name}: expected real numbers, found {found}")
    with np.errstate(all="ignore"):  # beyond the largest double it is infinite, and so judged
        return _rows(name, array.astype(np.float64), shape)


def _rows(name: str, value: Array, shape: tuple[int, ...]) -> Array:
    """value (..., *shape) as (..., k); ValueError when its last axes are others."""
    array = np.asarray(value)
    split = array.ndim - len(shape)
    if array.shape[max(split, 0) :] != shape:
        wanted = ", ".join(map(str, shape))
        raise ValueError(f"{name}: expected an array (..., {wanted}), found {array.shape}")
    return array.reshape(*array.shape[:split], int(np.prod(shape)))


def _batched(law: Any, given: list[Array]) -> list[Array]:
    """Run a law over the broadcast leading axes, in chunks, each quantity as columns."""
    batch = np.broadcast_shapes(*(one.shape[:-1] for one in given))
    spread = [np.broadcast_to(one, (*batch, one.shape[-1])) for one in given]
    flat = [one.reshape(-1, one.shape[-1]) for one in spread]
    typed = [(one, np.result_type(one, np.float64)) for one in flat]  # float32 is too coarse
    dtype = np.result_type(np.float64, *given)
    outputs: list[Array] = []
    for start in range(0, max(1, len(flat[0])), CHUNK):
        chunk = slice(start, start + CHUNK)
        columns = law(*(np.ascontiguousarray(one[chunk].T, kind) for one, kind in typed))
        if not outputs:
            outputs = [np.empty((len(flat[0]), len(entries)), dtype) for entries in columns]
        for output, entries in zip(outputs, columns):
            for i, entry in enumerate(entries):
                output[chunk, i] = entry
    return [output.reshape(*batch, output.shape[-1]) for output in outputs]


def _judge(rows: Array) -> Array:
    """OK, OUT_OF_RANGE or NONFINITE_INPUT for each row, (...)."""
    status = np.where((np.abs(rows) > MAX_INPUT).any(-1), OUT_OF_RANGE, OK)
    return np.where(np.isfinite(rows).all(-1), status, NONFINITE_INPUT)


def _law(
    inertia: Array, k: Array, kappa: Array, g: Array, nu: Array, g_r: Array, nu_r: Array,
    nu_r_dot: Array,
) -> Array:
    """LSF force that tracks (g_r, nu_r); eq. (Ctrls2) corrected."""
    # -- tracking --
    inertia_0, inertia_1, inertia_2, inertia_3, inertia_4, inertia_5 = (
        inertia[0], inertia[1], inertia[2], inertia[3], inertia[4], inertia[5]
    )
    k = k[0]
    kappa = kappa[0]
    g_0, g_1, g_2, g_3, g_4, g_5, g_6, g_7, g_8 = (
        g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8]
    )
    nu_0, nu_1, nu_2 = nu[0], nu[1], nu[2]
    g_r_0, g_r_1, g_r_2, g_r_3, g_r_4, g_r_5, g_r_6, g_r_7, g_r_8 = (
        g_r[0], g_r[1], g_r[2], g_r[3], g_r[4], g_r[5], g_r[6], g_r[7], g_r[8]
    )
    nu_r_0, nu_r_1, nu_r_2 = nu_r[0], nu_r[1], nu_r[2]
    nu_r_dot_0, nu_r_dot_1, nu_r_dot_2 = nu_r_dot[0], nu_r_dot[1], nu_r_dot[2]
    # g_e: error, g_r^-1 g [1], eq. (velErr)
    g_e_1 = g_1*g_r_0 + g_4*g_r_3 + g_7*g_r_6
    g_e_2 = g_2*g_r_0 + g_5*g_r_3 + g_8*g_r_6
    g_e_3 = g_0*g_r_1 + g_3*g_r_4 + g_6*g_r_7
    g_e_5 = g_2*g_r_1 + g_5*g_r_4 + g_8*g_r_7
    g_e_6 = g_0*g_r_2 + g_3*g_r_5 + g_6*g_r_8
    g_e_7 = g_1*g_r_2 + g_4*g_r_5 + g_7*g_r_8
    # nu_u: attitude error, 2 sin(angle) axis [rad], eq. (s2)
    nu_u_0 = g_e_7 - g_e_5
    nu_u_1 = g_e_2 - g_e_6
    nu_u_2 = g_e_3 - g_e_1
    # raw: nu - nu_r, each in its own body frame [rad/s]
    raw_0 = nu_0 - nu_r_0
    raw_1 = nu_1 - nu_r_1
    raw_2 = nu_2 - nu_r_2
    # ratio: kappa/k [1/s]
    ratio = kappa/k
    # s: sliding variable [rad/s], eq. (s2)
    s_0 = raw_0 + nu_u_0*ratio
    s_1 = raw_1 + nu_u_1*ratio
    s_2 = raw_2 + nu_u_2*ratio
    # crossing: nu x nu_r [rad/s^2]
    crossing_0 = nu_1*nu_r_2 - nu_2*nu_r_1
    crossing_1 = nu_2*nu_r_0 - nu_0*nu_r_2
    crossing_2 = nu_0*nu_r_1 - nu_1*nu_r_0
    # wanted: acceleration asked for [rad/s^2]
    wanted_0 = crossing_0 + nu_r_dot_0 - k*s_0
    wanted_1 = crossing_1 + nu_r_dot_1 - k*s_1
    wanted_2 = crossing_2 + nu_r_dot_2 - k*s_2
    # momentum: I nu [N m s]
    momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2
    momentum_1 = inertia_1*nu_0 + inertia_3*nu_1 + inertia_4*nu_2
    momentum_2 = inertia_2*nu_0 + inertia_4*nu_1 + inertia_5*nu_2
    # force: control force [N m], eq. (Ctrls2) corrected
    force_0 = (
        inertia_0*wanted_0 + inertia_1*wanted_1 + inertia_2*wanted_2 + momentum_2*nu_1 -
        momentum_1*nu_2
    )
    force_1 = (
        inertia_1*wanted_0 + inertia_3*wanted_1 + inertia_4*wanted_2 + momentum_0*nu_2 -
        momentum_2*nu_0
    )
    force_2 = (
        inertia_2*wanted_0 + inertia_4*wanted_1 + inertia_5*wanted_2 + momentum_1*nu_0 -
        momentum_0*nu_1
    )
    # -- end --
    return (
        (force_0, force_1, force_2),
        (s_0, s_1, s_2),
        (nu_u_0, nu_u_1, nu_u_2),
        (1.0,),
    )


def _plant(
    inertia: Array, nu: Array, force: Array,
) -> Array:
    """Acceleration under a force, Euler-Poincare; eq. (EulerP)."""
    # -- plant --
    inertia_0, inertia_1, inertia_2, inertia_3, inertia_4, inertia_5 = (
        inertia[0], inertia[1], inertia[2], inertia[3], inertia[4], inertia[5]
    )
    nu_0, nu_1, nu_2 = nu[0], nu[1], nu[2]
    force_0, force_1, force_2 = force[0], force[1], force[2]
    # momentum: I nu [N m s]
    momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2
    momentum_1 = inertia_1*nu_0 + inertia_3*nu_1 + inertia_4*nu_2
    momentum_2 = inertia_2*nu_0 + inertia_4*nu_1 + inertia_5*nu_2
    # total: coad(nu) I nu + force [N m]
    total_0 = force_0 + momentum_1*nu_2 - momentum_2*nu_1
    total_1 = force_1 + momentum_2*nu_0 - momentum_0*nu_2
    total_2 = force_2 + momentum_0*nu_1 - momentum_1*nu_0
    # lower_10: I = L D L^T, entry of L [1]
    lower_10 = inertia_1/inertia_0
    # lower_20: I = L D L^T, entry of L [1]
    lower_20 = inertia_2/inertia_0
    # pivot_1: pivot of I [kg m^2]
    pivot_1 = inertia_3 - inertia_0*lower_10*lower_10
    # lower_21: I = L D L^T, entry of L [1]
    lower_21 = (inertia_4 - inertia_0*lower_10*lower_20)/pivot_1
    # pivot_2: pivot of I [kg m^2]
    pivot_2 = inertia_5 - inertia_0*lower_20*lower_20 - pivot_1*lower_21*lower_21
    # forward_1: forward substitution [N m]
    forward_1 = total_1 - lower_10*total_0
    # forward_2: forward substitution [N m]
    forward_2 = total_2 - forward_1*lower_21 - lower_20*total_0
    # back_2: back substitution [rad/s^2]
    back_2 = forward_2/pivot_2
    # back_1: back substitution [rad/s^2]
    back_1 = forward_1/pivot_1 - back_2*lower_21
    # back_0: back substitution [rad/s^2]
    back_0 = total_0/inertia_0 - back_1*lower_10 - back_2*lower_20
    # -- end --
    return (
        (back_0, back_1, back_2),
    )


def _definiteness(
    inertia: Array,
) -> Array:
    """Pivots of the inertia: all positive for a valid one."""
    # -- definiteness --
    inertia_0, inertia_1, inertia_2, inertia_3, inertia_4, inertia_5 = (
        inertia[0], inertia[1], inertia[2], inertia[3], inertia[4], inertia[5]
    )
    # divisor_0: the pivot, or 1 where it is not positive [kg m^2]
    divisor_0_if_0 = inertia_0.real > 0.0
    divisor_0 = np.where(divisor_0_if_0, inertia_0, 1.0)
    # lower_10: I = L D L^T, entry of L [1]
    lower_10 = inertia_1/divisor_0
    # lower_20: I = L D L^T, entry of L [1]
    lower_20 = inertia_2/divisor_0
    # pivot_1: pivot of I [kg m^2]
    pivot_1 = inertia_3 - inertia_0*lower_10*lower_10
    # divisor_1: the pivot, or 1 where it is not positive [kg m^2]
    divisor_1_if_0 = pivot_1.real > 0.0
    divisor_1 = np.where(divisor_1_if_0, pivot_1, 1.0)
    # lower_21: I = L D L^T, entry of L [1]
    lower_21 = (inertia_4 - inertia_0*lower_10*lower_20)/divisor_1
    # pivot_2: pivot of I [kg m^2]
    pivot_2 = inertia_5 - inertia_0*lower_20*lower_20 - pivot_1*lower_21*lower_21
    # -- end --
    return (
        (inertia_0, pivot_1, pivot_2),
    )


def _error(
    g: Array, g_r: Array,
) -> Array:
    """LSF force that tracks (g_r, nu_r); eq. (Ctrls2) corrected."""
    # -- tracking --
    g_0, g_1, g_2, g_3, g_4, g_5, g_6, g_7, g_8 = (
        g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8]
    )
    g_r_0, g_r_1, g_r_2, g_r_3, g_r_4, g_r_5, g_r_6, g_r_7, g_r_8 = (
        g_r[0], g_r[1], g_r[2], g_r[3], g_r[4], g_r[5], g_r[6], g_r[7], g_r[8]
    )
    # g_e: error, g_r^-1 g [1], eq. (velErr)
    g_e_0 = g_0*g_r_0 + g_3*g_r_3 + g_6*g_r_6
    g_e_1 = g_1*g_r_0 + g_4*g_r_3 + g_7*g_r_6
    g_e_2 = g_2*g_r_0 + g_5*g_r_3 + g_8*g_r_6
    g_e_3 = g_0*g_r_1 + g_3*g_r_4 + g_6*g_r_7
    g_e_4 = g_1*g_r_1 + g_4*g_r_4 + g_7*g_r_7
    g_e_5 = g_2*g_r_1 + g_5*g_r_4 + g_8*g_r_7
    g_e_6 = g_0*g_r_2 + g_3*g_r_5 + g_6*g_r_8
    g_e_7 = g_1*g_r_2 + g_4*g_r_5 + g_7*g_r_8
    g_e_8 = g_2*g_r_2 + g_5*g_r_5 + g_8*g_r_8
    # -- end --
    return (
        (g_e_0, g_e_1, g_e_2, g_e_3, g_e_4, g_e_5, g_e_6, g_e_7, g_e_8),
    )


def _drift(
    g_e: Array,
) -> Array:
    """Square of the distance from the group."""
    # -- drift --
    g_e_0, g_e_1, g_e_2, g_e_3, g_e_4, g_e_5, g_e_6, g_e_7, g_e_8 = (
        g_e[0], g_e[1], g_e[2], g_e[3], g_e[4], g_e[5], g_e[6], g_e[7], g_e[8]
    )
    # off: what vanishes on the group, and only there [1]
    off_0 = g_e_0*g_e_0 - 1.0 + g_e_3*g_e_3 + g_e_6*g_e_6
    off_1 = g_e_0*g_e_1 + g_e_3*g_e_4 + g_e_6*g_e_7
    off_2 = g_e_1*g_e_1 - 1.0 + g_e_4*g_e_4 + g_e_7*g_e_7
    off_3 = g_e_2 + g_e_4*g_e_6 - g_e_3*g_e_7
    off_4 = g_e_5 + g_e_0*g_e_7 - g_e_1*g_e_6
    off_5 = g_e_8 + g_e_1*g_e_3 - g_e_0*g_e_4
    # drift: square of the distance from the group [1]
    drift = off_0*off_0 + off_1*off_1 + off_2*off_2 + off_3*off_3 + off_4*off_4 + off_5*off_5
    # -- end --
    return (
        (drift,),
    )
