"""cubesat_3u: gsmc on SO3, law {'arguments': ['nu', 'momentum', 'nu_r', 'nu_r_dot', 'g_e'], 'doc':
'force that drives (g, nu) to (g_r, nu_r)', 'has_reference': True, 'holders': ['params', 'state',
'reference'], 'inputs': [{'argument': 'inertia', 'doc': 'inertia, upper triangle, row by row',
'entries': [['inertia_0', 0], ['inertia_3', 3], ['inertia_5', 5]], 'holder': 'params', 'is_scalar':
False, 'member': 'inertia', 'name': 'inertia', 'shape': [6], 'size': 6, 'source': '', 'unit': 'kg
m^2'}, {'argument': 'lambda_', 'doc': 'sliding rate', 'entries': [['rate_gain', 0]], 'holder':
'params', 'is_scalar': True, 'member': 'lambda', 'name': 'rate_gain', 'shape': [1], 'size': 1,
'source': '', 'unit': '1/s'}, {'argument': 'k_s', 'doc': 'reaching rate', 'entries': [['reach_gain',
0]], 'holder': 'params', 'is_scalar': True, 'member': 'k_s', 'name': 'reach_gain', 'shape': [1],
'size': 1, 'source': '', 'unit': '1/s'}, {'argument': 'nu', 'doc': 'body velocity', 'entries':
[['nu_0', 0], ['nu_1', 1], ['nu_2', 2]], 'holder': 'state', 'is_scalar': False, 'member': 'nu',
'name': 'nu', 'shape': [3], 'size': 3, 'source': '', 'unit': 'rad/s'}, {'argument': 'momentum',
'doc': 'internal momentum, of wheels', 'entries': [['momentum_0', 0], ['momentum_1', 1],
['momentum_2', 2]], 'holder': 'state', 'is_scalar': False, 'member': 'momentum', 'name': 'momentum',
'shape': [3], 'size': 3, 'source': '', 'unit': 'N m s'}, {'argument': 'nu_r', 'doc': 'reference
velocity, reference body frame', 'entries': [['nu_r_0', 0], ['nu_r_1', 1], ['nu_r_2', 2]], 'holder':
'reference', 'is_scalar': False, 'member': 'nu', 'name': 'nu_r', 'shape': [3], 'size': 3, 'source':
'', 'unit': 'rad/s'}, {'argument': 'nu_r_dot', 'doc': 'its rate', 'entries': [['nu_r_dot_0', 0],
['nu_r_dot_1', 1], ['nu_r_dot_2', 2]], 'holder': 'reference', 'is_scalar': False, 'member':
'nu_dot', 'name': 'nu_r_dot', 'shape': [3], 'size': 3, 'source': '', 'unit': 'rad/s^2'},
{'argument': 'g_e', 'doc': 'error, g_r^-1 g', 'entries': [['g_e_0', 0], ['g_e_1', 1], ['g_e_2', 2],
['g_e_3', 3], ['g_e_4', 4], ['g_e_5', 5], ['g_e_6', 6], ['g_e_7', 7], ['g_e_8', 8]], 'holder': '',
'is_scalar': False, 'member': 'g_e', 'name': 'g_e', 'shape': [9], 'size': 9, 'source': 'eq.
(velErr)', 'unit': '1'}], 'is_public': False, 'name': 'tracking', 'operations': 187, 'outputs':
[{'doc': 'control force', 'entries': ['force_0', 'force_1', 'force_2'], 'holder': 'command',
'is_scalar': False, 'member': 'force', 'name': 'force', 'size': 3, 'source': '', 'unit': 'N m'},
{'doc': 'sliding variable', 'entries': ['s_0', 's_1', 's_2'], 'holder': 'command', 'is_scalar':
False, 'member': 's', 'name': 's', 'size': 3, 'source': '', 'unit': 'rad/s'}, {'doc': 'kinematic
law', 'entries': ['nu_u_0', 'nu_u_1', 'nu_u_2'], 'holder': 'command', 'is_scalar': False, 'member':
'nu_u', 'name': 'nu_u', 'size': 3, 'source': '', 'unit': 'rad'}, {'doc': 'its exact rate',
'entries': ['nu_u_dot_0', 'nu_u_dot_1', 'nu_u_dot_2'], 'holder': 'command', 'is_scalar': False,
'member': 'nu_u_dot', 'name': 'nu_u_dot', 'size': 3, 'source': '', 'unit': 'rad/s'}, {'doc':
'distance from the cut locus of the law', 'entries': ['w'], 'holder': '', 'is_scalar': True,
'member': 'clearance', 'name': 'clearance', 'size': 1, 'source': '', 'unit': '1'}], 'public_writes':
['command', 'clearance'], 'source': 'eq. (TckCtrl)', 'steps': [{'cases': [], 'doc': 'reference
velocity in the body frame', 'holder': '', 'is_scalar': False, 'lines': [['eta_0', 'g_e_0*nu_r_0 +
g_e_3*nu_r_1 + g_e_6*nu_r_2'], ['eta_1', 'g_e_1*nu_r_0 + g_e_4*nu_r_1 + g_e_7*nu_r_2'], ['eta_2',
'g_e_2*nu_r_0 + g_e_5*nu_r_1 + g_e_8*nu_r_2']], 'member': '', 'name': 'eta', 'names': ['eta_0',
'eta_1', 'eta_2'], 'size': 3, 'source': 'eq. (velErr)', 'unit': 'rad/s'}, {'cases': [], 'doc':
'velocity error', 'holder': '', 'is_scalar': False, 'lines': [['nu_e_0', 'nu_0 - eta_0'], ['nu_e_1',
'nu_1 - eta_1'], ['nu_e_2', 'nu_2 - eta_2']], 'member': '', 'name': 'nu_e', 'names': ['nu_e_0',
'nu_e_1', 'nu_e_2'], 'size': 3, 'source': 'eq. (velErr)', 'unit': 'rad/s'}, {'cases': [], 'doc':
'exact rate of eta', 'holder': '', 'is_scalar': False, 'lines': [['eta_dot_0', 'eta_1*nu_e_2 +
g_e_0*nu_r_dot_0 + g_e_3*nu_r_dot_1 + g_e_6*nu_r_dot_2 - eta_2*nu_e_1'], ['eta_dot_1', 'eta_2*nu_e_0
+ g_e_1*nu_r_dot_0 + g_e_4*nu_r_dot_1 + g_e_7*nu_r_dot_2 - eta_0*nu_e_2'], ['eta_dot_2',
'eta_0*nu_e_1 + g_e_2*nu_r_dot_0 + g_e_5*nu_r_dot_1 + g_e_8*nu_r_dot_2 - eta_1*nu_e_0']], 'member':
'', 'name': 'eta_dot', 'names': ['eta_dot_0', 'eta_dot_1', 'eta_dot_2'], 'size': 3, 'source': '',
'unit': 'rad/s^2'}, {'cases': [], 'doc': '4 p p^T, p = (v, w), by rows', 'holder': '', 'is_scalar':
False, 'lines': [['B_0', '1.0 + g_e_0 - g_e_4 - g_e_8'], ['B_1', 'g_e_1 + g_e_3'], ['B_2', 'g_e_2 +
g_e_6'], ['B_3', 'g_e_7 - g_e_5'], ['B_4', '1.0 + g_e_4 - g_e_0 - g_e_8'], ['B_5', 'g_e_5 + g_e_7'],
['B_6', 'g_e_2 - g_e_6'], ['B_7', '1.0 + g_e_8 - g_e_0 - g_e_4'], ['B_8', 'g_e_3 - g_e_1'], ['B_9',
'1.0 + g_e_0 + g_e_4 + g_e_8']], 'member': '', 'name': 'B', 'names': ['B_0', 'B_1', 'B_2', 'B_3',
'B_4', 'B_5', 'B_6', 'B_7', 'B_8', 'B_9'], 'size': 10, 'source': 'polar factor of Markley and
Bar-Itzhack', 'unit': '1'}, {'cases': [{'condition': 'B_9.real >= 1.0', 'lines': [['column_0',
'B_3'], ['column_1', 'B_6'], ['column_2', 'B_8'], ['column_3', 'B_9']]}, {'condition': '(B_0.real >=
B_4.real) & (B_0.real >= B_7.real)', 'lines': [['column_0', 'B_0'], ['column_1', 'B_1'],
['column_2', 'B_2'], ['column_3', 'B_3']]}, {'condition': 'B_4.real >= B_7.real', 'lines':
[['column_0', 'B_1'], ['column_1', 'B_4'], ['column_2', 'B_5'], ['column_3', 'B_6']]}, {'condition':
'', 'lines': [['column_0', 'B_2'], ['column_1', 'B_5'], ['column_2', 'B_7'], ['column_3', 'B_8']]}],
'doc': 'a column of B that cannot vanish', 'holder': '', 'is_scalar': False, 'lines': [], 'member':
'', 'name': 'column', 'names': ['column_0', 'column_1', 'column_2', 'column_3'], 'size': 4,
'source': '', 'unit': '1'}, {'cases': [], 'doc': 'the column after one power step', 'holder': '',
'is_scalar': False, 'lines': [['power_0', 'B_0*column_0 + B_1*column_1 + B_2*column_2 +
B_3*column_3'], ['power_1', 'B_1*column_0 + B_4*column_1 + B_5*column_2 + B_6*column_3'],
['power_2', 'B_2*column_0 + B_5*column_1 + B_7*column_2 + B_8*column_3'], ['power_3', 'B_3*column_0
+ B_6*column_1 + B_8*column_2 + B_9*column_3']], 'member': '', 'name': 'power', 'names': ['power_0',
'power_1', 'power_2', 'power_3'], 'size': 4, 'source': '', 'unit': '1'}, {'cases': [], 'doc':
'squared length', 'holder': '', 'is_scalar': True, 'lines': [['norm_square', 'power_0*power_0 +
power_1*power_1 + power_2*power_2 + power_3*power_3']], 'member': '', 'name': 'norm_square',
'names': ['norm_square'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [{'condition':
'norm_square.real < 49.0', 'lines': [['norm_bounded', '49.0']]}, {'condition': '', 'lines':
[['norm_bounded', 'norm_square']]}], 'doc': 'the same: less is no element', 'holder': '',
'is_scalar': True, 'lines': [], 'member': '', 'name': 'norm_bounded', 'names': ['norm_bounded'],
'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'length', 'holder': '', 'is_scalar':
True, 'lines': [['norm', 'np.sqrt(norm_bounded)']], 'member': '', 'name': 'norm', 'names': ['norm'],
'size': 1, 'source': '', 'unit': '1'}, {'cases': [{'condition': 'power_3.real < 0.0', 'lines':
[['scale', '-1.0/norm']]}, {'condition': '', 'lines': [['scale', '1.0/norm']]}], 'doc': 'to unit
length, and to w >= 0: the shorter way round', 'holder': '', 'is_scalar': True, 'lines': [],
'member': '', 'name': 'scale', 'names': ['scale'], 'size': 1, 'source': '', 'unit': '1'}, {'cases':
[], 'doc': 'cos of half the error angle', 'holder': '', 'is_scalar': True, 'lines': [['w',
'power_3*scale']], 'member': '', 'name': 'w', 'names': ['w'], 'size': 1, 'source': '', 'unit': '1'},
{'cases': [], 'doc': 'sin of half the error angle times its axis', 'holder': '', 'is_scalar': False,
'lines': [['v_0', 'power_0*scale'], ['v_1', 'power_1*scale'], ['v_2', 'power_2*scale']], 'member':
'', 'name': 'v', 'names': ['v_0', 'v_1', 'v_2'], 'size': 3, 'source': '', 'unit': '1'}, {'cases':
[], 'doc': 'half angle over its sine', 'holder': '', 'is_scalar': True, 'lines': [['k', '_k(w)']],
'member': '', 'name': 'k', 'names': ['k'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [],
'doc': '1 - w^2, below zero by an ulp at most', 'holder': '', 'is_scalar': True, 'lines':
[['sine_square', '(1.0 + w)*(1.0 - w)']], 'member': '', 'name': 'sine_square', 'names':
['sine_square'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': '-dk/dw, as (1 - w
k)/s^2', 'holder': '', 'is_scalar': True, 'lines': [['h', '(1.0 - k*w)/(1.0e-17 +
np.where(sine_square.real < 0.0, -sine_square, sine_square))']], 'member': '', 'name': 'h', 'names':
['h'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'kinematic law, the rotation
vector', 'holder': '', 'is_scalar': False, 'lines': [['nu_u_0', '2.0*k*v_0'], ['nu_u_1',
'2.0*k*v_1'], ['nu_u_2', '2.0*k*v_2']], 'member': '', 'name': 'nu_u', 'names': ['nu_u_0', 'nu_u_1',
'nu_u_2'], 'size': 3, 'source': 'eq. (KinCtrlLawSO3)', 'unit': 'rad'}, {'cases': [], 'doc': 'v x
nu_e', 'holder': '', 'is_scalar': False, 'lines': [['turn_0', 'nu_e_2*v_1 - nu_e_1*v_2'], ['turn_1',
'nu_e_0*v_2 - nu_e_2*v_0'], ['turn_2', 'nu_e_1*v_0 - nu_e_0*v_1']], 'member': '', 'name': 'turn',
'names': ['turn_0', 'turn_1', 'turn_2'], 'size': 3, 'source': '', 'unit': 'rad/s'}, {'cases': [],
'doc': 'v x (v x nu_e)', 'holder': '', 'is_scalar': False, 'lines': [['bend_0', 'turn_2*v_1 -
turn_1*v_2'], ['bend_1', 'turn_0*v_2 - turn_2*v_0'], ['bend_2', 'turn_1*v_0 - turn_0*v_1']],
'member': '', 'name': 'bend', 'names': ['bend_0', 'bend_1', 'bend_2'], 'size': 3, 'source': '',
'unit': 'rad/s'}, {'cases': [], 'doc': 'exact rate of nu_u', 'holder': '', 'is_scalar': False,
'lines': [['nu_u_dot_0', 'nu_e_0 + bend_0*h + k*turn_0'], ['nu_u_dot_1', 'nu_e_1 + bend_1*h +
k*turn_1'], ['nu_u_dot_2', 'nu_e_2 + bend_2*h + k*turn_2']], 'member': '', 'name': 'nu_u_dot',
'names': ['nu_u_dot_0', 'nu_u_dot_1', 'nu_u_dot_2'], 'size': 3, 'source': '', 'unit': 'rad/s'},
{'cases': [], 'doc': 'lambda nu_u', 'holder': '', 'is_scalar': False, 'lines': [['drive_0',
'nu_u_0*rate_gain'], ['drive_1', 'nu_u_1*rate_gain'], ['drive_2', 'nu_u_2*rate_gain']], 'member':
'', 'name': 'drive', 'names': ['drive_0', 'drive_1', 'drive_2'], 'size': 3, 'source': '', 'unit':
'rad/s'}, {'cases': [], 'doc': 'sliding variable', 'holder': '', 'is_scalar': False, 'lines':
[['s_0', 'drive_0 + nu_e_0'], ['s_1', 'drive_1 + nu_e_1'], ['s_2', 'drive_2 + nu_e_2']], 'member':
'', 'name': 's', 'names': ['s_0', 's_1', 's_2'], 'size': 3, 'source': 'eq. (SurfaceErr)', 'unit':
'rad/s'}, {'cases': [], 'doc': 'acceleration asked for', 'holder': '', 'is_scalar': False, 'lines':
[['wanted_0', 'eta_dot_0 - nu_u_dot_0*rate_gain - reach_gain*s_0'], ['wanted_1', 'eta_dot_1 -
nu_u_dot_1*rate_gain - reach_gain*s_1'], ['wanted_2', 'eta_dot_2 - nu_u_dot_2*rate_gain -
reach_gain*s_2']], 'member': '', 'name': 'wanted', 'names': ['wanted_0', 'wanted_1', 'wanted_2'],
'size': 3, 'source': '', 'unit': 'rad/s^2'}, {'cases': [], 'doc': 'lambda nu_u - eta', 'holder': '',
'is_scalar': False, 'lines': [['turning_0', 'drive_0 - eta_0'], ['turning_1', 'drive_1 - eta_1'],
['turning_2', 'drive_2 - eta_2']], 'member': '', 'name': 'turning', 'names': ['turning_0',
'turning_1', 'turning_2'], 'size': 3, 'source': '', 'unit': 'rad/s'}, {'cases': [], 'doc': 'I nu and
the internal momentum', 'holder': '', 'is_scalar': False, 'lines': [['whole_momentum_0', 'momentum_0
+ inertia_0*nu_0'], ['whole_momentum_1', 'momentum_1 + inertia_3*nu_1'], ['whole_momentum_2',
'momentum_2 + inertia_5*nu_2']], 'member': '', 'name': 'whole_momentum', 'names':
['whole_momentum_0', 'whole_momentum_1', 'whole_momentum_2'], 'size': 3, 'source': '', 'unit': 'N m
s'}, {'cases': [], 'doc': 'control force, I f_u', 'holder': '', 'is_scalar': False, 'lines':
[['force_0', 'inertia_0*wanted_0 + turning_2*whole_momentum_1 - turning_1*whole_momentum_2'],
['force_1', 'inertia_3*wanted_1 + turning_0*whole_momentum_2 - turning_2*whole_momentum_0'],
['force_2', 'inertia_5*wanted_2 + turning_1*whole_momentum_0 - turning_0*whole_momentum_1']],
'member': '', 'name': 'force', 'names': ['force_0', 'force_1', 'force_2'], 'size': 3, 'source': 'eq.
(TckCtrl)', 'unit': 'N m'}], 'symbol': 'tracking', 'temporaries': 68, 'writes': ['command',
'clearance']}, double precision, batched.

Generated by derive from the vehicle file cubesat_3u.toml; regenerate instead of editing.
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
    lambda_: Array
    k_s: Array
    max_drift: Array = 1.0e-6  # largest distance of the error from the group [1]


class Command(NamedTuple):
    """Force, sliding variable, law and its exact rate, (..., 3) each; status (...)."""

    force: Array
    s: Array
    nu_u: Array
    nu_u_dot: Array
    status: Array


DEFAULTS = Params(
    inertia=(0.0421, 0.0, 0.0, 0.0417, 0.0, 0.0067),
    lambda_=0.05,
    k_s=0.2,
)


def control(
    g: Array, nu: Array, momentum: Array, g_r: Array, nu_r: Array, nu_r_dot: Array,
    params: Params = DEFAULTS
) -> Command:
    """Guarded controller: force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl).

    Arguments as for `tracking`, real numbers only, computed and judged in double; TypeError for
    others. Where the status is 16 or larger, the whole command is zero.
    """
    given = [
        _real("inertia", params.inertia, (6,)),
        _real("lambda_", params.lambda_, ()),
        _real("k_s", params.k_s, ()),
        _real("g", g, (3, 3)),
        _real("nu", nu, (3,)),
        _real("momentum", momentum, (3,)),
        _real("g_r", g_r, (3, 3)),
        _real("nu_r", nu_r, (3,)),
        _real("nu_r_dot", nu_r_dot, (3,)),
    ]
    max_drift = _real("max_drift", params.max_drift, ())
    with np.errstate(all="ignore"):
        *command, clearance = _batched(_law, given)
        g_e = _batched(_error, [given[3], given[6]])[0]
        good = (np.abs(g_e) <= BOUNDS).all(-1)
        good = good & ((np.abs(given[3]) <= MAX_INPUT) | ~FREE).all(-1)
        good = good & (np.abs(given[4]) <= MAX_INPUT).all(-1)
        good = good & (np.abs(given[5]) <= MAX_INPUT).all(-1)
        good = good & ((np.abs(given[6]) <= MAX_INPUT) | ~FREE).all(-1)
        good = good & (np.abs(given[7]) <= MAX_INPUT).all(-1)
        good = good & (np.abs(given[8]) <= MAX_INPUT).all(-1)
        good = good & (_batched(_drift, [g_e])[0] <= max_drift * max_drift)[..., 0]
        status = np.where(np.isfinite(command[0]).all(-1), OK, NONFINITE_INPUT)
        near = np.where(clearance[..., 0] < NEAR_CUT, NEAR_CUT_LOCUS, OK)
        far = (~(np.abs(g_e) <= BOUNDS) & FREE).any(-1)
        refused = np.where(far, OUT_OF_RANGE, NOT_ON_GROUP)
        for rows in (given[3], given[4], given[5], given[6], given[7], given[8]):
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
        _real("lambda_", params.lambda_, ()),
        _real("k_s", params.k_s, ()),
    ]
    inertia, *gains = given
    with np.errstate(all="ignore"):
        pivots = _batched(_definiteness, [inertia])[0]
        good = (np.abs(inertia) <= MAX_PARAM).all(-1) & (pivots > 0.0).all(-1)
        good = good & (inertia[..., [1, 2, 4]] == 0.0).all(-1)
        good = good & ((gains[0] >= MIN_GAIN) & (gains[0] <= MAX_RATE))[..., 0]
        good = good & ((gains[1] >= MIN_GAIN) & (gains[1] <= MAX_RATE))[..., 0]
        drift = _real("max_drift", params.max_drift, ())
        good = good & ((drift > 0.0) & (drift <= MOST_DRIFT))[..., 0]
    return np.where(good, OK, BAD_PARAMS)


def tracking(
    g: Array, nu: Array, momentum: Array, g_r: Array, nu_r: Array, nu_r_dot: Array,
    params: Params = DEFAULTS
) -> Command:
    """Force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl). Presumes what `control` checks.

    g: configuration: rotation matrix, row by row [1], (..., 3, 3)
    nu: body velocity [rad/s], (..., 3)
    momentum: internal momentum, of wheels [N m s], (..., 3)
    g_r: reference configuration: rotation matrix, row by row [1], (..., 3, 3)
    nu_r: reference velocity, reference body frame [rad/s], (..., 3)
    nu_r_dot: its rate [rad/s^2], (..., 3)
    Nothing is judged: every status is OK.
    Complex arrays pass through, for complex-step derivatives.
    """
    given = [
        _rows("inertia", params.inertia, (6,)),
        _rows("lambda_", params.lambda_, ()),
        _rows("k_s", params.k_s, ()),
        _rows("g", g, (3, 3)),
        _rows("nu", nu, (3,)),
        _rows("momentum", momentum, (3,)),
        _rows("g_r", g_r, (3, 3)),
        _rows("nu_r", nu_r, (3,)),
        _rows("nu_r_dot", nu_r_dot, (3,)),
    ]
    command = _batched(_law, given)[:4]
    return Command(*command, np.full(command[0].shape[:-1], OK))


def reaching(
    g: Array, nu: Array, momentum: Array, params: Params = DEFAULTS
) -> Command:
    """Force that drives (g, nu) to (e, 0); eq. (Ctrl2). Presumes what `control` checks.

    g: configuration: rotation matrix, row by row [1], (..., 3, 3)
    nu: body velocity [rad/s], (..., 3)
    momentum: internal momentum, of wheels [N m s], (..., 3)
    Nothing is judged: every status is OK.
    Complex arrays pass through, for complex-step derivatives.
    """
    given = [
        _rows("inertia", params.inertia, (6,)),
        _rows("lambda_", params.lambda_, ()),
        _rows("k_s", params.k_s, ()),
        _rows("g", g, (3, 3)),
        _rows("nu", nu, (3,)),
        _rows("momentum", momentum, (3,)),
    ]
    command = _batched(_reaching, given)[:4]
    return Command(*command, np.full(command[0].shape[:-1], OK))


def plant(
    nu: Array, momentum: Array, force: Array, params: Params = DEFAULTS
) -> Array:
    """Acceleration under a force, Euler-Poincare; eq. (EulerP). Presumes what `control` checks.

    nu: body velocity [rad/s], (..., 3)
    momentum: internal momentum, of wheels [N m s], (..., 3)
    force: applied force [N m], (..., 3)
    Complex arrays pass through, for complex-step derivatives.
    """
    given = [
        _rows("inertia", params.inertia, (6,)),
        _rows("nu", nu, (3,)),
        _rows("momentum", momentum, (3,)),
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


def _k(w: Array) -> Array:
    """Kernel function k(w) on 0 <= w <= 1, a polynomial in 1 - w."""
    z = 1.0 - w
    value = 8.277514146196502e-5
    value = value * z - 0.0007444806306887051
    value = value * z + 0.00317670645149068
    value = value * z - 0.008454515050142185
    value = value * z + 0.01566904108961398
    value = value * z - 0.02138402971876357
    value = value * z + 0.022234983575225374
    value = value * z - 0.01792610921286688
    value = value * z + 0.011402056638616778
    value = value * z - 0.005632546133953197
    value = value * z + 0.002377672542009468
    value = value * z - 0.0004366715134129454
    value = value * z + 0.0007243405609038858
    value = value * z + 0.0011382817325777553
    value = value * z + 0.0024908875171720216
    value = value * z + 0.0053275406688376775
    value = value * z + 0.01154404554160158
    value = value * z + 0.02539682373687369
    value = value * z + 0.05714285719245186
    value = value * z + 0.13333333333254913
    value = value * z + 0.33333333333333826
    value = value * z + 1.0
    return value


def _law(
    inertia: Array, lambda_: Array, k_s: Array, g: Array, nu: Array, momentum: Array, g_r: Array,
    nu_r: Array, nu_r_dot: Array,
) -> Array:
    """Force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl)."""
    # -- tracking --
    inertia_0, inertia_3, inertia_5 = inertia[0], inertia[3], inertia[5]
    rate_gain = lambda_[0]
    reach_gain = k_s[0]
    g_0, g_1, g_2, g_3, g_4, g_5, g_6, g_7, g_8 = (
        g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8]
    )
    nu_0, nu_1, nu_2 = nu[0], nu[1], nu[2]
    momentum_0, momentum_1, momentum_2 = momentum[0], momentum[1], momentum[2]
    g_r_0, g_r_1, g_r_2, g_r_3, g_r_4, g_r_5, g_r_6, g_r_7, g_r_8 = (
        g_r[0], g_r[1], g_r[2], g_r[3], g_r[4], g_r[5], g_r[6], g_r[7], g_r[8]
    )
    nu_r_0, nu_r_1, nu_r_2 = nu_r[0], nu_r[1], nu_r[2]
    nu_r_dot_0, nu_r_dot_1, nu_r_dot_2 = nu_r_dot[0], nu_r_dot[1], nu_r_dot[2]
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
    # eta: reference velocity in the body frame [rad/s], eq. (velErr)
    eta_0 = g_e_0*nu_r_0 + g_e_3*nu_r_1 + g_e_6*nu_r_2
    eta_1 = g_e_1*nu_r_0 + g_e_4*nu_r_1 + g_e_7*nu_r_2
    eta_2 = g_e_2*nu_r_0 + g_e_5*nu_r_1 + g_e_8*nu_r_2
    # nu_e: velocity error [rad/s], eq. (velErr)
    nu_e_0 = nu_0 - eta_0
    nu_e_1 = nu_1 - eta_1
    nu_e_2 = nu_2 - eta_2
    # eta_dot: exact rate of eta [rad/s^2]
    eta_dot_0 = eta_1*nu_e_2 + g_e_0*nu_r_dot_0 + g_e_3*nu_r_dot_1 + g_e_6*nu_r_dot_2 - eta_2*nu_e_1
    eta_dot_1 = eta_2*nu_e_0 + g_e_1*nu_r_dot_0 + g_e_4*nu_r_dot_1 + g_e_7*nu_r_dot_2 - eta_0*nu_e_2
    eta_dot_2 = eta_0*nu_e_1 + g_e_2*nu_r_dot_0 + g_e_5*nu_r_dot_1 + g_e_8*nu_r_dot_2 - eta_1*nu_e_0
    # B: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack
    B_0 = 1.0 + g_e_0 - g_e_4 - g_e_8
    B_1 = g_e_1 + g_e_3
    B_2 = g_e_2 + g_e_6
    B_3 = g_e_7 - g_e_5
    B_4 = 1.0 + g_e_4 - g_e_0 - g_e_8
    B_5 = g_e_5 + g_e_7
    B_6 = g_e_2 - g_e_6
    B_7 = 1.0 + g_e_8 - g_e_0 - g_e_4
    B_8 = g_e_3 - g_e_1
    B_9 = 1.0 + g_e_0 + g_e_4 + g_e_8
    # column: a column of B that cannot vanish [1]
    column_if_0 = B_9.real >= 1.0
    column_if_1 = (B_0.real >= B_4.real) & (B_0.real >= B_7.real)
    column_if_2 = B_4.real >= B_7.real
    column_0 = (
        np.where(column_if_0, B_3, np.where(column_if_1, B_0, np.where(column_if_2, B_1, B_2)))
    )
    column_1 = (
        np.where(column_if_0, B_6, np.where(column_if_1, B_1, np.where(column_if_2, B_4, B_5)))
    )
    column_2 = (
        np.where(column_if_0, B_8, np.where(column_if_1, B_2, np.where(column_if_2, B_5, B_7)))
    )
    column_3 = (
        np.where(column_if_0, B_9, np.where(column_if_1, B_3, np.where(column_if_2, B_6, B_8)))
    )
    # power: the column after one power step [1]
    power_0 = B_0*column_0 + B_1*column_1 + B_2*column_2 + B_3*column_3
    power_1 = B_1*column_0 + B_4*column_1 + B_5*column_2 + B_6*column_3
    power_2 = B_2*column_0 + B_5*column_1 + B_7*column_2 + B_8*column_3
    power_3 = B_3*column_0 + B_6*column_1 + B_8*column_2 + B_9*column_3
    # norm_square: squared length [1]
    norm_square = power_0*power_0 + power_1*power_1 + power_2*power_2 + power_3*power_3
    # norm_bounded: the same: less is no element [1]
    norm_bounded_if_0 = norm_square.real < 49.0
    norm_bounded = np.where(norm_bounded_if_0, 49.0, norm_square)
    # norm: length [1]
    norm = np.sqrt(norm_bounded)
    # scale: to unit length, and to w >= 0: the shorter way round [1]
    scale_if_0 = power_3.real < 0.0
    scale = np.where(scale_if_0, -1.0/norm, 1.0/norm)
    # w: cos of half the error angle [1]
    w = power_3*scale
    # v: sin of half the error angle times its axis [1]
    v_0 = power_0*scale
    v_1 = power_1*scale
    v_2 = power_2*scale
    # k: half angle over its sine [1]
    k = _k(w)
    # sine_square: 1 - w^2, below zero by an ulp at most [1]
    sine_square = (1.0 + w)*(1.0 - w)
    # h: -dk/dw, as (1 - w k)/s^2 [1]
    h = (1.0 - k*w)/(1.0e-17 + np.where(sine_square.real < 0.0, -sine_square, sine_square))
    # nu_u: kinematic law, the rotation vector [rad], eq. (KinCtrlLawSO3)
    nu_u_0 = 2.0*k*v_0
    nu_u_1 = 2.0*k*v_1
    nu_u_2 = 2.0*k*v_2
    # turn: v x nu_e [rad/s]
    turn_0 = nu_e_2*v_1 - nu_e_1*v_2
    turn_1 = nu_e_0*v_2 - nu_e_2*v_0
    turn_2 = nu_e_1*v_0 - nu_e_0*v_1
    # bend: v x (v x nu_e) [rad/s]
    bend_0 = turn_2*v_1 - turn_1*v_2
    bend_1 = turn_0*v_2 - turn_2*v_0
    bend_2 = turn_1*v_0 - turn_0*v_1
    # nu_u_dot: exact rate of nu_u [rad/s]
    nu_u_dot_0 = nu_e_0 + bend_0*h + k*turn_0
    nu_u_dot_1 = nu_e_1 + bend_1*h + k*turn_1
    nu_u_dot_2 = nu_e_2 + bend_2*h + k*turn_2
    # drive: lambda nu_u [rad/s]
    drive_0 = nu_u_0*rate_gain
    drive_1 = nu_u_1*rate_gain
    drive_2 = nu_u_2*rate_gain
    # s: sliding variable [rad/s], eq. (SurfaceErr)
    s_0 = drive_0 + nu_e_0
    s_1 = drive_1 + nu_e_1
    s_2 = drive_2 + nu_e_2
    # wanted: acceleration asked for [rad/s^2]
    wanted_0 = eta_dot_0 - nu_u_dot_0*rate_gain - reach_gain*s_0
    wanted_1 = eta_dot_1 - nu_u_dot_1*rate_gain - reach_gain*s_1
    wanted_2 = eta_dot_2 - nu_u_dot_2*rate_gain - reach_gain*s_2
    # turning: lambda nu_u - eta [rad/s]
    turning_0 = drive_0 - eta_0
    turning_1 = drive_1 - eta_1
    turning_2 = drive_2 - eta_2
    # whole_momentum: I nu and the internal momentum [N m s]
    whole_momentum_0 = momentum_0 + inertia_0*nu_0
    whole_momentum_1 = momentum_1 + inertia_3*nu_1
    whole_momentum_2 = momentum_2 + inertia_5*nu_2
    # force: control force, I f_u [N m], eq. (TckCtrl)
    force_0 = inertia_0*wanted_0 + turning_2*whole_momentum_1 - turning_1*whole_momentum_2
    force_1 = inertia_3*wanted_1 + turning_0*whole_momentum_2 - turning_2*whole_momentum_0
    force_2 = inertia_5*wanted_2 + turning_1*whole_momentum_0 - turning_0*whole_momentum_1
    # -- end --
    return (
        (force_0, force_1, force_2),
        (s_0, s_1, s_2),
        (nu_u_0, nu_u_1, nu_u_2),
        (nu_u_dot_0, nu_u_dot_1, nu_u_dot_2),
        (w,),
    )


def _reaching(
    inertia: Array, lambda_: Array, k_s: Array, g: Array, nu: Array, momentum: Array,
) -> Array:
    """Force that drives (g, nu) to (e, 0); eq. (Ctrl2)."""
    # -- reaching --
    inertia_0, inertia_3, inertia_5 = inertia[0], inertia[3], inertia[5]
    rate_gain = lambda_[0]
    reach_gain = k_s[0]
    g_0, g_1, g_2, g_3, g_4, g_5, g_6, g_7, g_8 = (
        g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8]
    )
    nu_0, nu_1, nu_2 = nu[0], nu[1], nu[2]
    momentum_0, momentum_1, momentum_2 = momentum[0], momentum[1], momentum[2]
    # B: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack
    B_0 = 1.0 + g_0 - g_4 - g_8
    B_1 = g_1 + g_3
    B_2 = g_2 + g_6
    B_3 = g_7 - g_5
    B_4 = 1.0 + g_4 - g_0 - g_8
    B_5 = g_5 + g_7
    B_6 = g_2 - g_6
    B_7 = 1.0 + g_8 - g_0 - g_4
    B_8 = g_3 - g_1
    B_9 = 1.0 + g_0 + g_4 + g_8
    # column: a column of B that cannot vanish [1]
    column_if_0 = B_9.real >= 1.0
    column_if_1 = (B_0.real >= B_4.real) & (B_0.real >= B_7.real)
    column_if_2 = B_4.real >= B_7.real
    column_0 = (
        np.where(column_if_0, B_3, np.where(column_if_1, B_0, np.where(column_if_2, B_1, B_2)))
    )
    column_1 = (
        np.where(column_if_0, B_6, np.where(column_if_1, B_1, np.where(column_if_2, B_4, B_5)))
    )
    column_2 = (
        np.where(column_if_0, B_8, np.where(column_if_1, B_2, np.where(column_if_2, B_5, B_7)))
    )
    column_3 = (
        np.where(column_if_0, B_9, np.where(column_if_1, B_3, np.where(column_if_2, B_6, B_8)))
    )
    # power: the column after one power step [1]
    power_0 = B_0*column_0 + B_1*column_1 + B_2*column_2 + B_3*column_3
    power_1 = B_1*column_0 + B_4*column_1 + B_5*column_2 + B_6*column_3
    power_2 = B_2*column_0 + B_5*column_1 + B_7*column_2 + B_8*column_3
    power_3 = B_3*column_0 + B_6*column_1 + B_8*column_2 + B_9*column_3
    # norm_square: squared length [1]
    norm_square = power_0*power_0 + power_1*power_1 + power_2*power_2 + power_3*power_3
    # norm_bounded: the same: less is no element [1]
    norm_bounded_if_0 = norm_square.real < 49.0
    norm_bounded = np.where(norm_bounded_if_0, 49.0, norm_square)
    # norm: length [1]
    norm = np.sqrt(norm_bounded)
    # scale: to unit length, and to w >= 0: the shorter way round [1]
    scale_if_0 = power_3.real < 0.0
    scale = np.where(scale_if_0, -1.0/norm, 1.0/norm)
    # w: cos of half the error angle [1]
    w = power_3*scale
    # v: sin of half the error angle times its axis [1]
    v_0 = power_0*scale
    v_1 = power_1*scale
    v_2 = power_2*scale
    # k: half angle over its sine [1]
    k = _k(w)
    # sine_square: 1 - w^2, below zero by an ulp at most [1]
    sine_square = (1.0 + w)*(1.0 - w)
    # h: -dk/dw, as (1 - w k)/s^2 [1]
    h = (1.0 - k*w)/(1.0e-17 + np.where(sine_square.real < 0.0, -sine_square, sine_square))
    # nu_u: kinematic law, the rotation vector [rad], eq. (KinCtrlLawSO3)
    nu_u_0 = 2.0*k*v_0
    nu_u_1 = 2.0*k*v_1
    nu_u_2 = 2.0*k*v_2
    # turn: v x nu_e [rad/s]
    turn_0 = nu_2*v_1 - nu_1*v_2
    turn_1 = nu_0*v_2 - nu_2*v_0
    turn_2 = nu_1*v_0 - nu_0*v_1
    # bend: v x (v x nu_e) [rad/s]
    bend_0 = turn_2*v_1 - turn_1*v_2
    bend_1 = turn_0*v_2 - turn_2*v_0
    bend_2 = turn_1*v_0 - turn_0*v_1
    # nu_u_dot: exact rate of nu_u [rad/s]
    nu_u_dot_0 = nu_0 + bend_0*h + k*turn_0
    nu_u_dot_1 = nu_1 + bend_1*h + k*turn_1
    nu_u_dot_2 = nu_2 + bend_2*h + k*turn_2
    # drive: lambda nu_u [rad/s]
    drive_0 = nu_u_0*rate_gain
    drive_1 = nu_u_1*rate_gain
    drive_2 = nu_u_2*rate_gain
    # s: sliding variable [rad/s], eq. (sldS)
    s_0 = drive_0 + nu_0
    s_1 = drive_1 + nu_1
    s_2 = drive_2 + nu_2
    # wanted: acceleration asked for [rad/s^2]
    wanted_0 = -(nu_u_dot_0*rate_gain + reach_gain*s_0)
    wanted_1 = -(nu_u_dot_1*rate_gain + reach_gain*s_1)
    wanted_2 = -(nu_u_dot_2*rate_gain + reach_gain*s_2)
    # whole_momentum: I nu and the internal momentum [N m s]
    whole_momentum_0 = momentum_0 + inertia_0*nu_0
    whole_momentum_1 = momentum_1 + inertia_3*nu_1
    whole_momentum_2 = momentum_2 + inertia_5*nu_2
    # force: control force, I f_u [N m], eq. (Ctrl2)
    force_0 = drive_2*whole_momentum_1 + inertia_0*wanted_0 - drive_1*whole_momentum_2
    force_1 = drive_0*whole_momentum_2 + inertia_3*wanted_1 - drive_2*whole_momentum_0
    force_2 = drive_1*whole_momentum_0 + inertia_5*wanted_2 - drive_0*whole_momentum_1
    # -- end --
    return (
        (force_0, force_1, force_2),
        (s_0, s_1, s_2),
        (nu_u_0, nu_u_1, nu_u_2),
        (nu_u_dot_0, nu_u_dot_1, nu_u_dot_2),
    )


def _plant(
    inertia: Array, nu: Array, momentum: Array, force: Array,
) -> Array:
    """Acceleration under a force, Euler-Poincare; eq. (EulerP)."""
    # -- plant --
    inertia_0, inertia_3, inertia_5 = inertia[0], inertia[3], inertia[5]
    nu_0, nu_1, nu_2 = nu[0], nu[1], nu[2]
    momentum_0, momentum_1, momentum_2 = momentum[0], momentum[1], momentum[2]
    force_0, force_1, force_2 = force[0], force[1], force[2]
    # whole_momentum: I nu and the internal momentum [N m s]
    whole_momentum_0 = momentum_0 + inertia_0*nu_0
    whole_momentum_1 = momentum_1 + inertia_3*nu_1
    whole_momentum_2 = momentum_2 + inertia_5*nu_2
    # total: coad(nu) I nu + force [N m]
    total_0 = force_0 + nu_2*whole_momentum_1 - nu_1*whole_momentum_2
    total_1 = force_1 + nu_0*whole_momentum_2 - nu_2*whole_momentum_0
    total_2 = force_2 + nu_1*whole_momentum_0 - nu_0*whole_momentum_1
    # back_2: back substitution [rad/s^2]
    back_2 = total_2/inertia_5
    # back_1: back substitution [rad/s^2]
    back_1 = total_1/inertia_3
    # back_0: back substitution [rad/s^2]
    back_0 = total_0/inertia_0
    # -- end --
    return (
        (back_0, back_1, back_2),
    )


def _definiteness(
    inertia: Array,
) -> Array:
    """Pivots of the inertia: all positive for a valid one."""
    # -- definiteness --
    inertia_0, inertia_3, inertia_5 = inertia[0], inertia[3], inertia[5]
    # -- end --
    return (
        (inertia_0, inertia_3, inertia_5),
    )


def _error(
    g: Array, g_r: Array,
) -> Array:
    """Force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl)."""
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
    off_2 = g_e_0*g_e_2 + g_e_3*g_e_5 + g_e_6*g_e_8
    off_3 = g_e_1*g_e_1 - 1.0 + g_e_4*g_e_4 + g_e_7*g_e_7
    off_4 = g_e_1*g_e_2 + g_e_4*g_e_5 + g_e_7*g_e_8
    off_5 = g_e_2*g_e_2 - 1.0 + g_e_5*g_e_5 + g_e_8*g_e_8
    off_6 = (
        g_e_0*g_e_4*g_e_8 - 1.0 + g_e_1*g_e_5*g_e_6 + g_e_2*g_e_3*g_e_7 - g_e_0*g_e_5*g_e_7 -
        g_e_1*g_e_3*g_e_8 - g_e_2*g_e_4*g_e_6
    )
    # drift: square of the distance from the group [1]
    drift = (
        off_0*off_0 + off_1*off_1 + off_2*off_2 + off_3*off_3 + off_4*off_4 + off_5*off_5 +
        off_6*off_6
    )
    # -- end --
    return (
        (drift,),
    )
