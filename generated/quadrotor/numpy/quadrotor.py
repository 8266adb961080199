"""quadrotor: gsmc on S3, law {'name': 'tracking', 'doc': 'force that drives (g, nu) to (g_r,
nu_r)', 'source': 'eq. (TckCtrl)', 'inputs': [{'name': 'inertia', 'size': 6, 'unit': 'kg m^2',
'doc': 'inertia, upper triangle, row by row', 'source': '', 'is_scalar': False, 'holder': 'params',
'member': 'inertia', 'entries': [['inertia_0', 0], ['inertia_2', 2], ['inertia_3', 3], ['inertia_5',
5]], 'argument': 'inertia', 'shape': (6,)}, {'name': 'rate_gain', 'size': 1, 'unit': '1/s', 'doc':
'sliding rate', 'source': '', 'is_scalar': True, 'holder': 'params', 'member': 'lambda', 'entries':
[['rate_gain', 0]], 'argument': 'lambda_', 'shape': (1,)}, {'name': 'reach_gain', 'size': 1, 'unit':
'1/s', 'doc': 'reaching rate', 'source': '', 'is_scalar': True, 'holder': 'params', 'member': 'k_s',
'entries': [['reach_gain', 0]], 'argument': 'k_s', 'shape': (1,)}, {'name': 'nu', 'size': 3, 'unit':
'rad/s', 'doc': 'body velocity', 'source': '', 'is_scalar': False, 'holder': 'state', 'member':
'nu', 'entries': [['nu_0', 0], ['nu_1', 1], ['nu_2', 2]], 'argument': 'nu', 'shape': (3,)}, {'name':
'nu_r', 'size': 3, 'unit': 'rad/s', 'doc': 'reference velocity, reference body frame', 'source': '',
'is_scalar': False, 'holder': 'reference', 'member': 'nu', 'entries': [['nu_r_0', 0], ['nu_r_1', 1],
['nu_r_2', 2]], 'argument': 'nu_r', 'shape': (3,)}, {'name': 'nu_r_dot', 'size': 3, 'unit':
'rad/s^2', 'doc': 'its rate', 'source': '', 'is_scalar': False, 'holder': 'reference', 'member':
'nu_dot', 'entries': [['nu_r_dot_0', 0], ['nu_r_dot_1', 1], ['nu_r_dot_2', 2]], 'argument':
'nu_r_dot', 'shape': (3,)}, {'name': 'g_e', 'size': 4, 'unit': '1', 'doc': 'error, g_r^-1 g',
'source': 'eq. (velErr)', 'is_scalar': False, 'holder': '', 'member': 'g_e', 'entries': [['g_e_0',
0], ['g_e_1', 1], ['g_e_2', 2], ['g_e_3', 3]], 'argument': 'g_e', 'shape': (4,)}], 'steps':
[{'name': 'double', 'size': 3, 'unit': '1', 'doc': 'twice the vector part', 'source': '',
'is_scalar': False, 'holder': '', 'member': '', 'names': ['double_0', 'double_1', 'double_2'],
'lines': [['double_0', '2.0*g_e_1'], ['double_1', '2.0*g_e_2'], ['double_2', '2.0*g_e_3']], 'cases':
[]}, {'name': 'to_body', 'size': 9, 'unit': '1', 'doc': 'Ad of g_e^-1: reference to body frame',
'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['to_body_0', 'to_body_1',
'to_body_2', 'to_body_3', 'to_body_4', 'to_body_5', 'to_body_6', 'to_body_7', 'to_body_8'], 'lines':
[['to_body_0', '1.0 - double_1*g_e_2 - double_2*g_e_3'], ['to_body_1', 'double_0*g_e_2 +
double_2*g_e_0'], ['to_body_2', 'double_0*g_e_3 - double_1*g_e_0'], ['to_body_3', 'double_0*g_e_2 -
double_2*g_e_0'], ['to_body_4', '1.0 - double_0*g_e_1 - double_2*g_e_3'], ['to_body_5',
'double_0*g_e_0 + double_1*g_e_3'], ['to_body_6', 'double_0*g_e_3 + double_1*g_e_0'], ['to_body_7',
'double_1*g_e_3 - double_0*g_e_0'], ['to_body_8', '1.0 - double_0*g_e_1 - double_1*g_e_2']],
'cases': []}, {'name': 'eta', 'size': 3, 'unit': 'rad/s', 'doc': 'reference velocity in the body
frame', 'source': 'eq. (velErr)', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['eta_0',
'eta_1', 'eta_2'], 'lines': [['eta_0', 'nu_r_0*to_body_0 + nu_r_1*to_body_1 + nu_r_2*to_body_2'],
['eta_1', 'nu_r_0*to_body_3 + nu_r_1*to_body_4 + nu_r_2*to_body_5'], ['eta_2', 'nu_r_0*to_body_6 +
nu_r_1*to_body_7 + nu_r_2*to_body_8']], 'cases': []}, {'name': 'nu_e', 'size': 3, 'unit': 'rad/s',
'doc': 'velocity error', 'source': 'eq. (velErr)', 'is_scalar': False, 'holder': '', 'member': '',
'names': ['nu_e_0', 'nu_e_1', 'nu_e_2'], 'lines': [['nu_e_0', 'nu_0 - eta_0'], ['nu_e_1', 'nu_1 -
eta_1'], ['nu_e_2', 'nu_2 - eta_2']], 'cases': []}, {'name': 'eta_dot', 'size': 3, 'unit':
'rad/s^2', 'doc': 'exact rate of eta', 'source': '', 'is_scalar': False, 'holder': '', 'member': '',
'names': ['eta_dot_0', 'eta_dot_1', 'eta_dot_2'], 'lines': [['eta_dot_0', 'eta_1*nu_e_2 +
nu_r_dot_0*to_body_0 + nu_r_dot_1*to_body_1 + nu_r_dot_2*to_body_2 - eta_2*nu_e_1'], ['eta_dot_1',
'eta_2*nu_e_0 + nu_r_dot_0*to_body_3 + nu_r_dot_1*to_body_4 + nu_r_dot_2*to_body_5 - eta_0*nu_e_2'],
['eta_dot_2', 'eta_0*nu_e_1 + nu_r_dot_0*to_body_6 + nu_r_dot_1*to_body_7 + nu_r_dot_2*to_body_8 -
eta_1*nu_e_0']], 'cases': []}, {'name': 'square', 'size': 1, 'unit': '1', 'doc': 'square of its
vector part', 'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['square'],
'lines': [['square', 'g_e_1*g_e_1 + g_e_2*g_e_2 + g_e_3*g_e_3']], 'cases': []}, {'name':
'norm_square', 'size': 1, 'unit': '1', 'doc': 'its squared length', 'source': '', 'is_scalar': True,
'holder': '', 'member': '', 'names': ['norm_square'], 'lines': [['norm_square', 'square +
g_e_0*g_e_0']], 'cases': []}, {'name': 'norm_bounded', 'size': 1, 'unit': '1', 'doc': 'the same:
less is no element', 'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names':
['norm_bounded'], 'lines': [], 'cases': [{'condition': 'norm_square.real < 1.0e-8.real', 'lines':
[['norm_bounded', '1.0e-8']]}, {'condition': '', 'lines': [['norm_bounded', 'norm_square']]}]},
{'name': 'norm', 'size': 1, 'unit': '1', 'doc': 'its length', 'source': '', 'is_scalar': True,
'holder': '', 'member': '', 'names': ['norm'], 'lines': [['norm', 'np.sqrt(norm_bounded)']],
'cases': []}, {'name': 'scale', 'size': 1, 'unit': '1', 'doc': 'to unit length', 'source': '',
'is_scalar': True, 'holder': '', 'member': '', 'names': ['scale'], 'lines': [['scale', '1.0/norm']],
'cases': []}, {'name': 'w', 'size': 1, 'unit': '1', 'doc': 'cos of half the error angle', 'source':
'', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['w'], 'lines': [['w', 'g_e_0*scale']],
'cases': []}, {'name': 'k_near', 'size': 1, 'unit': '1', 'doc': 'half angle over its sine, for |w|',
'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['k_near'], 'lines':
[['k_near', '_k(np.where(w.real < 0.0, -w, w))']], 'cases': []}, {'name': 'divisor', 'size': 1,
'unit': '1', 'doc': 'the same, never zero', 'source': '', 'is_scalar': True, 'holder': '', 'member':
'', 'names': ['divisor'], 'lines': [], 'cases': [{'condition': 'w.real >= 0.0', 'lines':
[['divisor', 'square + 1.0e-17']]}, {'condition': 'square.real > (1.0e-60*1.0e-60).real', 'lines':
[['divisor', 'square']]}, {'condition': '', 'lines': [['divisor', '1.0e-60*1.0e-60']]}]}, {'name':
'distance', 'size': 1, 'unit': '1', 'doc': 'distance from -i: |v| beyond pi, and 1 before',
'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['distance'], 'lines': [],
'cases': [{'condition': 'w.real >= 0.0', 'lines': [['distance', '1.0']]}, {'condition': '', 'lines':
[['distance', 'scale*np.sqrt(divisor)']]}]}, {'name': 'k', 'size': 1, 'unit': '1', 'doc': 'half
angle over its sine, on to 2 pi', 'source': '', 'is_scalar': True, 'holder': '', 'member': '',
'names': ['k'], 'lines': [], 'cases': [{'condition': 'w.real >= 0.0', 'lines': [['k', 'k_near']]},
{'condition': '', 'lines': [['k', '3.141592653589793/distance - k_near']]}]}, {'name': 'h_raw',
'size': 1, 'unit': '1', 'doc': "-dk/dw by the scale's square, as s^2 h = 1 - w k", 'source': '',
'is_scalar': True, 'holder': '', 'member': '', 'names': ['h_raw'], 'lines': [['h_raw', '(1.0 -
k*w)/divisor']], 'cases': []}, {'name': 'reach', 'size': 1, 'unit': '1', 'doc': 'p by the scale, but
for a number', 'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['reach'],
'lines': [['reach', 'k*scale']], 'cases': []}, {'name': 'stretch', 'size': 1, 'unit': '1', 'doc':
'ratio of nu_u to the vector part', 'source': '', 'is_scalar': True, 'holder': '', 'member': '',
'names': ['stretch'], 'lines': [['stretch', '2.0*reach']], 'cases': []}, {'name': 'nu_u', 'size': 3,
'unit': 'rad', 'doc': 'kinematic law, the rotation vector', 'source': 'def. (KctrLaw)', 'is_scalar':
False, 'holder': '', 'member': '', 'names': ['nu_u_0', 'nu_u_1', 'nu_u_2'], 'lines': [['nu_u_0',
'g_e_1*stretch'], ['nu_u_1', 'g_e_2*stretch'], ['nu_u_2', 'g_e_3*stretch']], 'cases': []}, {'name':
'turn', 'size': 3, 'unit': 'rad/s', 'doc': 'vector part x nu_e, its share', 'source': '',
'is_scalar': False, 'holder': '', 'member': '', 'names': ['turn_0', 'turn_1', 'turn_2'], 'lines':
[['turn_0', 'g_e_2*nu_e_2 - g_e_3*nu_e_1'], ['turn_1', 'g_e_3*nu_e_0 - g_e_1*nu_e_2'], ['turn_2',
'g_e_1*nu_e_1 - g_e_2*nu_e_0']], 'cases': []}, {'name': 'bend', 'size': 3, 'unit': 'rad/s', 'doc':
'vector part x that', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names':
['bend_0', 'bend_1', 'bend_2'], 'lines': [['bend_0', 'g_e_2*turn_2 - g_e_3*turn_1'], ['bend_1',
'g_e_3*turn_0 - g_e_1*turn_2'], ['bend_2', 'g_e_1*turn_1 - g_e_2*turn_0']], 'cases': []}, {'name':
'nu_u_dot', 'size': 3, 'unit': 'rad/s', 'doc': 'exact rate of nu_u', 'source': '', 'is_scalar':
False, 'holder': '', 'member': '', 'names': ['nu_u_dot_0', 'nu_u_dot_1', 'nu_u_dot_2'], 'lines':
[['nu_u_dot_0', 'nu_e_0 + bend_0*h_raw + reach*turn_0'], ['nu_u_dot_1', 'nu_e_1 + bend_1*h_raw +
reach*turn_1'], ['nu_u_dot_2', 'nu_e_2 + bend_2*h_raw + reach*turn_2']], 'cases': []}, {'name':
'drive', 'size': 3, 'unit': 'rad/s', 'doc': 'lambda nu_u', 'source': '', 'is_scalar': False,
'holder': '', 'member': '', 'names': ['drive_0', 'drive_1', 'drive_2'], 'lines': [['drive_0',
'nu_u_0*rate_gain'], ['drive_1', 'nu_u_1*rate_gain'], ['drive_2', 'nu_u_2*rate_gain']], 'cases':
[]}, {'name': 's', 'size': 3, 'unit': 'rad/s', 'doc': 'sliding variable', 'source': 'eq.
(SurfaceErr)', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['s_0', 's_1', 's_2'],
'lines': [['s_0', 'drive_0 + nu_e_0'], ['s_1', 'drive_1 + nu_e_1'], ['s_2', 'drive_2 + nu_e_2']],
'cases': []}, {'name': 'wanted', 'size': 3, 'unit': 'rad/s^2', 'doc': 'acceleration asked for',
'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['wanted_0', 'wanted_1',
'wanted_2'], 'lines': [['wanted_0', 'eta_dot_0 - nu_u_dot_0*rate_gain - reach_gain*s_0'],
['wanted_1', 'eta_dot_1 - nu_u_dot_1*rate_gain - reach_gain*s_1'], ['wanted_2', 'eta_dot_2 -
nu_u_dot_2*rate_gain - reach_gain*s_2']], 'cases': []}, {'name': 'turning', 'size': 3, 'unit':
'rad/s', 'doc': 'lambda nu_u - eta, as s - nu', 'source': '', 'is_scalar': False, 'holder': '',
'member': '', 'names': ['turning_0', 'turning_1', 'turning_2'], 'lines': [['turning_0', 's_0 -
nu_0'], ['turning_1', 's_1 - nu_1'], ['turning_2', 's_2 - nu_2']], 'cases': []}, {'name':
'momentum', 'size': 3, 'unit': 'N m s', 'doc': 'I nu', 'source': '', 'is_scalar': False, 'holder':
'', 'member': '', 'names': ['momentum_0', 'momentum_1', 'momentum_2'], 'lines': [['momentum_0',
'inertia_0*nu_0 + inertia_2*nu_2'], ['momentum_1', 'inertia_3*nu_1'], ['momentum_2', 'inertia_2*nu_0
+ inertia_5*nu_2']], 'cases': []}, {'name': 'force', 'size': 3, 'unit': 'N m', 'doc': 'control
force, I f_u', 'source': 'eq. (TckCtrl)', 'is_scalar': False, 'holder': '', 'member': '', 'names':
['force_0', 'force_1', 'force_2'], 'lines': [['force_0', 'inertia_0*wanted_0 + inertia_2*wanted_2 +
momentum_1*turning_2 - momentum_2*turning_1'], ['force_1', 'inertia_3*wanted_1 +
momentum_2*turning_0 - momentum_0*turning_2'], ['force_2', 'inertia_2*wanted_0 + inertia_5*wanted_2
+ momentum_0*turning_1 - momentum_1*turning_0']], 'cases': []}], 'outputs': [{'name': 'force',
'size': 3, 'unit': 'N m', 'doc': 'control force', 'source': '', 'is_scalar': False, 'holder':
'command', 'member': 'force', 'entries': ['force_0', 'force_1', 'force_2']}, {'name': 's', 'size':
3, 'unit': 'rad/s', 'doc': 'sliding variable', 'source': '', 'is_scalar': False, 'holder':
'command', 'member': 's', 'entries': ['s_0', 's_1', 's_2']}, {'name': 'nu_u', 'size': 3, 'unit':
'rad', 'doc': 'kinematic law', 'source': '', 'is_scalar': False, 'holder': 'command', 'member':
'nu_u', 'entries': ['nu_u_0', 'nu_u_1', 'nu_u_2']}, {'name': 'nu_u_dot', 'size': 3, 'unit': 'rad/s',
'doc': 'its exact rate', 'source': '', 'is_scalar': False, 'holder': 'command', 'member':
'nu_u_dot', 'entries': ['nu_u_dot_0', 'nu_u_dot_1', 'nu_u_dot_2']}, {'name': 'clearance', 'size': 1,
'unit': '1', 'doc': 'distance from the cut locus of the law', 'source': '', 'is_scalar': True,
'holder': '', 'member': 'clearance', 'entries': ['distance']}], 'operations': 172, 'temporaries':
64, 'symbol': 'tracking', 'is_public': False, 'holders': ['params', 'state', 'reference'],
'arguments': ['nu', 'nu_r', 'nu_r_dot', 'g_e'], 'has_reference': True, 'writes': ['command',
'clearance'], 'public_writes': ['command', 'clearance']}, double precision, batched.

Generated by derive from the vehicle file quadrotor.toml; regenerate instead of editing.
Configuration: unit quaternion, Hamilton, scalar first.
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

BOUNDS = (MAX_ENTRY, MAX_ENTRY, MAX_ENTRY, MAX_ENTRY)  # of the error's entries
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
    force_limit: Array = (0.8, 0.8, 0.1)  # largest force of each coordinate [N m]
    max_drift: Array = 1.0e-6  # largest distance of the error from the group [1]


class Command(NamedTuple):
    """Force, sliding variable, law and its exact rate, (..., 3) each; status (...)."""

    force: Array
    s: Array
    nu_u: Array
    nu_u_dot: Array
    status: Array


DEFAULTS = Params(
    inertia=(0.0085, 0.0, 0.00012, 0.0088, 0.0, 0.0152),
    lambda_=6.0,
    k_s=1.0e1,
)


def control(
    g: Array, nu: Array, g_r: Array, nu_r: Array, nu_r_dot: Array, params: Params = DEFAULTS
) -> Command:
    """Guarded controller: force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl).

    Arguments as for `tracking`, real numbers only, computed and judged in double; TypeError for
    others. Where the status is 16 or larger, the whole command is zero.
    """
    given = [
        _real("inertia", params.inertia, (6,)),
        _real("lambda_", params.lambda_, ()),
        _real("k_s", params.k_s, ()),
        _real("g", g, (4,)),
        _real("nu", nu, (3,)),
        _real("g_r", g_r, (4,)),
        _real("nu_r", nu_r, (3,)),
        _real("nu_r_dot", nu_r_dot, (3,)),
    ]
    force_limit = _real("force_limit", params.force_limit, (3,))
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
        command[0], status = _saturated(command[0], force_limit)
        near = np.where(clearance[..., 0] < NEAR_CUT, NEAR_CUT_LOCUS, OK)
        near = np.where(clearance[..., 0] < REFUSED_CUT, OUT_OF_RANGE, near)
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
        _real("lambda_", params.lambda_, ()),
        _real("k_s", params.k_s, ()),
    ]
    inertia, *gains = given
    with np.errstate(all="ignore"):
        pivots = _batched(_definiteness, [inertia])[0]
        good = (np.abs(inertia) <= MAX_PARAM).all(-1) & (pivots > 0.0).all(-1)
        good = good & (inertia[..., [1, 4]] == 0.0).all(-1)
        good = good & ((gains[0] >= MIN_GAIN) & (gains[0] <= MAX_RATE))[..., 0]
        good = good & ((gains[1] >= MIN_GAIN) & (gains[1] <= MAX_RATE))[..., 0]
        limit = _real("force_limit", params.force_limit, (3,))
        good = good & ((limit >= MIN_GAIN) & (limit <= MAX_PARAM)).all(-1)
        drift = _real("max_drift", params.max_drift, ())
        good = good & ((drift > 0.0) & (drift <= MOST_DRIFT))[..., 0]
    return np.where(good, OK, BAD_PARAMS)


def tracking(
    g: Array, nu: Array, g_r: Array, nu_r: Array, nu_r_dot: Array, params: Params = DEFAULTS
) -> Command:
    """Force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl). Presumes what `control` checks.

    g: configuration: unit quaternion, Hamilton, scalar first [1], (..., 4)
    nu: body velocity [rad/s], (..., 3)
    g_r: reference configuration: unit quaternion, Hamilton, scalar first [1], (..., 4)
    nu_r: reference velocity, reference body frame [rad/s], (..., 3)
    nu_r_dot: its rate [rad/s^2], (..., 3)
    Nothing is judged: every status is OK.
    Complex arrays pass through, for complex-step derivatives.
    """
    given = [
        _rows("inertia", params.inertia, (6,)),
        _rows("lambda_", params.lambda_, ()),
        _rows("k_s", params.k_s, ()),
        _rows("g", g, (4,)),
        _rows("nu", nu, (3,)),
        _rows("g_r", g_r, (4,)),
        _rows("nu_r", nu_r, (3,)),
        _rows("nu_r_dot", nu_r_dot, (3,)),
    ]
    command = _batched(_law, given)[:4]
    return Command(*command, np.full(command[0].shape[:-1], OK))


def reaching(
    g: Array, nu: Array, params: Params = DEFAULTS
) -> Command:
    """Force that drives (g, nu) to (e, 0); eq. (Ctrl2). Presumes what `control` checks.

    g: configuration: unit quaternion, Hamilton, scalar first [1], (..., 4)
    nu: body velocity [rad/s], (..., 3)
    Nothing is judged: every status is OK.
    Complex arrays pass through, for complex-step derivatives.
    """
    given = [
        _rows("inertia", params.inertia, (6,)),
        _rows("lambda_", params.lambda_, ()),
        _rows("k_s", params.k_s, ()),
        _rows("g", g, (4,)),
        _rows("nu", nu, (3,)),
    ]
    command = _batched(_reaching, given)[:4]
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


def _saturated(force: Array, limit: Array) -> tuple[Array, Array]:
    """The force within its limits, (..., 3), and OK, SATURATED or NONFINITE_INPUT, (...)."""
    size = np.abs(force)
    share = np.where(size > limit, limit / size, 1.0).min(-1, keepdims=True)  # direction stays
    cut = force * share
    cut = np.where(cut > limit, limit, np.where(cut < -limit, -limit, cut))
    usable = ((np.abs(cut) <= limit)).all(-1)
    within = (size <= limit).all(-1)
    status = np.where(within, OK, np.where(usable, SATURATED, NONFINITE_INPUT))
    return np.where(within[..., None], force, cut), status


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
    inertia: Array, lambda_: Array, k_s: Array, g: Array, nu: Array, g_r: Array, nu_r: Array,
    nu_r_dot: Array,
) -> Array:
    """Force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl)."""
    # -- tracking --
    inertia_0, inertia_2, inertia_3, inertia_5 = inertia[0], inertia[2], inertia[3], inertia[5]
    rate_gain = lambda_[0]
    reach_gain = k_s[0]
    g_0, g_1, g_2, g_3 = g[0], g[1], g[2], g[3]
    nu_0, nu_1, nu_2 = nu[0], nu[1], nu[2]
    g_r_0, g_r_1, g_r_2, g_r_3 = g_r[0], g_r[1], g_r[2], g_r[3]
    nu_r_0, nu_r_1, nu_r_2 = nu_r[0], nu_r[1], nu_r[2]
    nu_r_dot_0, nu_r_dot_1, nu_r_dot_2 = nu_r_dot[0], nu_r_dot[1], nu_r_dot[2]
    # g_e: error, g_r^-1 g [1], eq. (velErr)
    g_e_0 = g_0*g_r_0 + g_1*g_r_1 + g_2*g_r_2 + g_3*g_r_3
    g_e_1 = g_1*g_r_0 + g_2*g_r_3 - g_0*g_r_1 - g_3*g_r_2
    g_e_2 = g_2*g_r_0 + g_3*g_r_1 - g_0*g_r_2 - g_1*g_r_3
    g_e_3 = g_1*g_r_2 + g_3*g_r_0 - g_0*g_r_3 - g_2*g_r_1
    # double: twice the vector part [1]
    double_0 = 2.0*g_e_1
    double_1 = 2.0*g_e_2
    double_2 = 2.0*g_e_3
    # to_body: Ad of g_e^-1: reference to body frame [1]
    to_body_0 = 1.0 - double_1*g_e_2 - double_2*g_e_3
    to_body_1 = double_0*g_e_2 + double_2*g_e_0
    to_body_2 = double_0*g_e_3 - double_1*g_e_0
    to_body_3 = double_0*g_e_2 - double_2*g_e_0
    to_body_4 = 1.0 - double_0*g_e_1 - double_2*g_e_3
    to_body_5 = double_0*g_e_0 + double_1*g_e_3
    to_body_6 = double_0*g_e_3 + double_1*g_e_0
    to_body_7 = double_1*g_e_3 - double_0*g_e_0
    to_body_8 = 1.0 - double_0*g_e_1 - double_1*g_e_2
    # eta: reference velocity in the body frame [rad/s], eq. (velErr)
    eta_0 = nu_r_0*to_body_0 + nu_r_1*to_body_1 + nu_r_2*to_body_2
    eta_1 = nu_r_0*to_body_3 + nu_r_1*to_body_4 + nu_r_2*to_body_5
    eta_2 = nu_r_0*to_body_6 + nu_r_1*to_body_7 + nu_r_2*to_body_8
    # nu_e: velocity error [rad/s], eq. (velErr)
    nu_e_0 = nu_0 - eta_0
    nu_e_1 = nu_1 - eta_1
    nu_e_2 = nu_2 - eta_2
    # eta_dot: exact rate of eta [rad/s^2]
    eta_dot_0 = (
        eta_1*nu_e_2 + nu_r_dot_0*to_body_0 + nu_r_dot_1*to_body_1 + nu_r_dot_2*to_body_2 -
        eta_2*nu_e_1
    )
    eta_dot_1 = (
        eta_2*nu_e_0 + nu_r_dot_0*to_body_3 + nu_r_dot_1*to_body_4 + nu_r_dot_2*to_body_5 -
        eta_0*nu_e_2
    )
    eta_dot_2 = (
        eta_0*nu_e_1 + nu_r_dot_0*to_body_6 + nu_r_dot_1*to_body_7 + nu_r_dot_2*to_body_8 -
        eta_1*nu_e_0
    )
    # square: square of its vector part [1]
    square = g_e_1*g_e_1 + g_e_2*g_e_2 + g_e_3*g_e_3
    # norm_square: its squared length [1]
    norm_square = square + g_e_0*g_e_0
    # norm_bounded: the same: less is no element [1]
    norm_bounded_if_0 = norm_square.real < 1.0e-8.real
    norm_bounded = np.where(norm_bounded_if_0, 1.0e-8, norm_square)
    # norm: its length [1]
    norm = np.sqrt(norm_bounded)
    # scale: to unit length [1]
    scale = 1.0/norm
    # w: cos of half the error angle [1]
    w = g_e_0*scale
    # k_near: half angle over its sine, for |w| [1]
    k_near = _k(np.where(w.real < 0.0, -w, w))
    # divisor: the same, never zero [1]
    divisor_if_0 = w.real >= 0.0
    divisor_if_1 = square.real > (1.0e-60*1.0e-60).real
    divisor = (
        np.where(divisor_if_0, square + 1.0e-17, np.where(divisor_if_1, square, 1.0e-60*1.0e-60))
    )
    # distance: distance from -i: |v| beyond pi, and 1 before [1]
    distance_if_0 = w.real >= 0.0
    distance = np.where(distance_if_0, 1.0, scale*np.sqrt(divisor))
    # k: half angle over its sine, on to 2 pi [1]
    k_if_0 = w.real >= 0.0
    k = np.where(k_if_0, k_near, 3.141592653589793/distance - k_near)
    # h_raw: -dk/dw by the scale's square, as s^2 h = 1 - w k [1]
    h_raw = (1.0 - k*w)/divisor
    # reach: p by the scale, but for a number [1]
    reach = k*scale
    # stretch: ratio of nu_u to the vector part [1]
    stretch = 2.0*reach
    # nu_u: kinematic law, the rotation vector [rad], def. (KctrLaw)
    nu_u_0 = g_e_1*stretch
    nu_u_1 = g_e_2*stretch
    nu_u_2 = g_e_3*stretch
    # turn: vector part x nu_e, its share [rad/s]
    turn_0 = g_e_2*nu_e_2 - g_e_3*nu_e_1
    turn_1 = g_e_3*nu_e_0 - g_e_1*nu_e_2
    turn_2 = g_e_1*nu_e_1 - g_e_2*nu_e_0
    # bend: vector part x that [rad/s]
    bend_0 = g_e_2*turn_2 - g_e_3*turn_1
    bend_1 = g_e_3*turn_0 - g_e_1*turn_2
    bend_2 = g_e_1*turn_1 - g_e_2*turn_0
    # nu_u_dot: exact rate of nu_u [rad/s]
    nu_u_dot_0 = nu_e_0 + bend_0*h_raw + reach*turn_0
    nu_u_dot_1 = nu_e_1 + bend_1*h_raw + reach*turn_1
    nu_u_dot_2 = nu_e_2 + bend_2*h_raw + reach*turn_2
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
    # turning: lambda nu_u - eta, as s - nu [rad/s]
    turning_0 = s_0 - nu_0
    turning_1 = s_1 - nu_1
    turning_2 = s_2 - nu_2
    # momentum: I nu [N m s]
    momentum_0 = inertia_0*nu_0 + inertia_2*nu_2
    momentum_1 = inertia_3*nu_1
    momentum_2 = inertia_2*nu_0 + inertia_5*nu_2
    # force: control force, I f_u [N m], eq. (TckCtrl)
    force_0 = inertia_0*wanted_0 + inertia_2*wanted_2 + momentum_1*turning_2 - momentum_2*turning_1
    force_1 = inertia_3*wanted_1 + momentum_2*turning_0 - momentum_0*turning_2
    force_2 = inertia_2*wanted_0 + inertia_5*wanted_2 + momentum_0*turning_1 - momentum_1*turning_0
    # -- end --
    return (
        (force_0, force_1, force_2),
        (s_0, s_1, s_2),
        (nu_u_0, nu_u_1, nu_u_2),
        (nu_u_dot_0, nu_u_dot_1, nu_u_dot_2),
        (distance,),
    )


def _reaching(
    inertia: Array, lambda_: Array, k_s: Array, g: Array, nu: Array,
) -> Array:
    """Force that drives (g, nu) to (e, 0); eq. (Ctrl2)."""
    # -- reaching --
    inertia_0, inertia_2, inertia_3, inertia_5 = inertia[0], inertia[2], inertia[3], inertia[5]
    rate_gain = lambda_[0]
    reach_gain = k_s[0]
    g_0, g_1, g_2, g_3 = g[0], g[1], g[2], g[3]
    nu_0, nu_1, nu_2 = nu[0], nu[1], nu[2]
    # square: square of its vector part [1]
    square = g_1*g_1 + g_2*g_2 + g_3*g_3
    # norm_square: its squared length [1]
    norm_square = square + g_0*g_0
    # norm_bounded: the same: less is no element [1]
    norm_bounded_if_0 = norm_square.real < 1.0e-8.real
    norm_bounded = np.where(norm_bounded_if_0, 1.0e-8, norm_square)
    # norm: its length [1]
    norm = np.sqrt(norm_bounded)
    # scale: to unit length [1]
    scale = 1.0/norm
    # w: cos of half the error angle [1]
    w = g_0*scale
    # k_near: half angle over its sine, for |w| [1]
    k_near = _k(np.where(w.real < 0.0, -w, w))
    # divisor: the same, never zero [1]
    divisor_if_0 = w.real >= 0.0
    divisor_if_1 = square.real > (1.0e-60*1.0e-60).real
    divisor = (
        np.where(divisor_if_0, square + 1.0e-17, np.where(divisor_if_1, square, 1.0e-60*1.0e-60))
    )
    # distance: distance from -i: |v| beyond pi, and 1 before [1]
    distance_if_0 = w.real >= 0.0
    distance = np.where(distance_if_0, 1.0, scale*np.sqrt(divisor))
    # k: half angle over its sine, on to 2 pi [1]
    k_if_0 = w.real >= 0.0
    k = np.where(k_if_0, k_near, 3.141592653589793/distance - k_near)
    # h_raw: -dk/dw by the scale's square, as s^2 h = 1 - w k [1]
    h_raw = (1.0 - k*w)/divisor
    # reach: p by the scale, but for a number [1]
    reach = k*scale
    # stretch: ratio of nu_u to the vector part [1]
    stretch = 2.0*reach
    # nu_u: kinematic law, the rotation vector [rad], def. (KctrLaw)
    nu_u_0 = g_1*stretch
    nu_u_1 = g_2*stretch
    nu_u_2 = g_3*stretch
    # turn: vector part x nu_e, its share [rad/s]
    turn_0 = g_2*nu_2 - g_3*nu_1
    turn_1 = g_3*nu_0 - g_1*nu_2
    turn_2 = g_1*nu_1 - g_2*nu_0
    # bend: vector part x that [rad/s]
    bend_0 = g_2*turn_2 - g_3*turn_1
    bend_1 = g_3*turn_0 - g_1*turn_2
    bend_2 = g_1*turn_1 - g_2*turn_0
    # nu_u_dot: exact rate of nu_u [rad/s]
    nu_u_dot_0 = nu_0 + bend_0*h_raw + reach*turn_0
    nu_u_dot_1 = nu_1 + bend_1*h_raw + reach*turn_1
    nu_u_dot_2 = nu_2 + bend_2*h_raw + reach*turn_2
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
    # momentum: I nu [N m s]
    momentum_0 = inertia_0*nu_0 + inertia_2*nu_2
    momentum_1 = inertia_3*nu_1
    momentum_2 = inertia_2*nu_0 + inertia_5*nu_2
    # force: control force, I f_u [N m], eq. (Ctrl2)
    force_0 = drive_2*momentum_1 + inertia_0*wanted_0 + inertia_2*wanted_2 - drive_1*momentum_2
    force_1 = drive_0*momentum_2 + inertia_3*wanted_1 - drive_2*momentum_0
    force_2 = drive_1*momentum_0 + inertia_2*wanted_0 + inertia_5*wanted_2 - drive_0*momentum_1
    # -- end --
    return (
        (force_0, force_1, force_2),
        (s_0, s_1, s_2),
        (nu_u_0, nu_u_1, nu_u_2),
        (nu_u_dot_0, nu_u_dot_1, nu_u_dot_2),
    )


def _plant(
    inertia: Array, nu: Array, force: Array,
) -> Array:
    """Acceleration under a force, Euler-Poincare; eq. (EulerP)."""
    # -- plant --
    inertia_0, inertia_2, inertia_3, inertia_5 = inertia[0], inertia[2], inertia[3], inertia[5]
    nu_0, nu_1, nu_2 = nu[0], nu[1], nu[2]
    force_0, force_1, force_2 = force[0], force[1], force[2]
    # momentum: I nu [N m s]
    momentum_0 = inertia_0*nu_0 + inertia_2*nu_2
    momentum_1 = inertia_3*nu_1
    momentum_2 = inertia_2*nu_0 + inertia_5*nu_2
    # total: coad(nu) I nu + force [N m]
    total_0 = force_0 + momentum_1*nu_2 - momentum_2*nu_1
    total_1 = force_1 + momentum_2*nu_0 - momentum_0*nu_2
    total_2 = force_2 + momentum_0*nu_1 - momentum_1*nu_0
    # lower_20: I = L D L^T, entry of L [1]
    lower_20 = inertia_2/inertia_0
    # pivot_2: pivot of I [kg m^2]
    pivot_2 = inertia_5 - inertia_0*lower_20*lower_20
    # forward_2: forward substitution [N m]
    forward_2 = total_2 - lower_20*total_0
    # back_2: back substitution [rad/s^2]
    back_2 = forward_2/pivot_2
    # back_1: back substitution [rad/s^2]
    back_1 = total_1/inertia_3
    # back_0: back substitution [rad/s^2]
    back_0 = total_0/inertia_0 - back_2*lower_20
    # -- end --
    return (
        (back_0, back_1, back_2),
    )


def _definiteness(
    inertia: Array,
) -> Array:
    """Pivots of the inertia: all positive for a valid one."""
    # -- definiteness --
    inertia_0, inertia_2, inertia_3, inertia_5 = inertia[0], inertia[2], inertia[3], inertia[5]
    # divisor_0: the pivot, or 1 where it is not positive [kg m^2]
    divisor_0_if_0 = inertia_0.real > 0.0
    divisor_0 = np.where(divisor_0_if_0, inertia_0, 1.0)
    # lower_20: I = L D L^T, entry of L [1]
    lower_20 = inertia_2/divisor_0
    # pivot_2: pivot of I [kg m^2]
    pivot_2 = inertia_5 - inertia_0*lower_20*lower_20
    # -- end --
    return (
        (inertia_0, inertia_3, pivot_2),
    )


def _error(
    g: Array, g_r: Array,
) -> Array:
    """Force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl)."""
    # -- tracking --
    g_0, g_1, g_2, g_3 = g[0], g[1], g[2], g[3]
    g_r_0, g_r_1, g_r_2, g_r_3 = g_r[0], g_r[1], g_r[2], g_r[3]
    # g_e: error, g_r^-1 g [1], eq. (velErr)
    g_e_0 = g_0*g_r_0 + g_1*g_r_1 + g_2*g_r_2 + g_3*g_r_3
    g_e_1 = g_1*g_r_0 + g_2*g_r_3 - g_0*g_r_1 - g_3*g_r_2
    g_e_2 = g_2*g_r_0 + g_3*g_r_1 - g_0*g_r_2 - g_1*g_r_3
    g_e_3 = g_1*g_r_2 + g_3*g_r_0 - g_0*g_r_3 - g_2*g_r_1
    # -- end --
    return (
        (g_e_0, g_e_1, g_e_2, g_e_3),
    )


def _drift(
    g_e: Array,
) -> Array:
    """Square of the distance from the group."""
    # -- drift --
    g_e_0, g_e_1, g_e_2, g_e_3 = g_e[0], g_e[1], g_e[2], g_e[3]
    # off: what vanishes on the group, and only there [1]
    off_0 = g_e_0*g_e_0 - 1.0 + g_e_1*g_e_1 + g_e_2*g_e_2 + g_e_3*g_e_3
    # drift: square of the distance from the group [1]
    drift = off_0*off_0
    # -- end --
    return (
        (drift,),
    )
