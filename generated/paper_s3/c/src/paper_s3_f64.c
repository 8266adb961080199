/*
 * paper_s3_f64: gsmc on S3, law {'arguments': ['nu', 'nu_r', 'nu_r_dot', 'g_e'], 'doc': 'force that
         drives (g, nu) to (g_r, nu_r)', 'has_reference': True, 'holders': ['params', 'state',
         'reference'], 'inputs': [{'argument': 'inertia', 'doc': 'inertia, upper triangle, row by
         row', 'entries': [['inertia_0', 0], ['inertia_1', 1], ['inertia_2', 2], ['inertia_3', 3],
         ['inertia_4', 4], ['inertia_5', 5]], 'holder': 'params', 'is_scalar': False, 'member':
         'inertia', 'name': 'inertia', 'shape': [6], 'size': 6, 'source': '', 'unit': 'kg m^2'},
         {'argument': 'lambda_', 'doc': 'sliding rate', 'entries': [['rate_gain', 0]], 'holder':
         'params', 'is_scalar': True, 'member': 'lambda', 'name': 'rate_gain', 'shape': [1], 'size':
         1, 'source': '', 'unit': '1/s'}, {'argument': 'k_s', 'doc': 'reaching rate', 'entries':
         [['reach_gain', 0]], 'holder': 'params', 'is_scalar': True, 'member': 'k_s', 'name':
         'reach_gain', 'shape': [1], 'size': 1, 'source': '', 'unit': '1/s'}, {'argument': 'nu',
         'doc': 'body velocity', 'entries': [['nu_0', 0], ['nu_1', 1], ['nu_2', 2]], 'holder':
         'state', 'is_scalar': False, 'member': 'nu', 'name': 'nu', 'shape': [3], 'size': 3,
         'source': '', 'unit': 'rad/s'}, {'argument': 'nu_r', 'doc': 'reference velocity, reference
         body frame', 'entries': [['nu_r_0', 0], ['nu_r_1', 1], ['nu_r_2', 2]], 'holder':
         'reference', 'is_scalar': False, 'member': 'nu', 'name': 'nu_r', 'shape': [3], 'size': 3,
         'source': '', 'unit': 'rad/s'}, {'argument': 'nu_r_dot', 'doc': 'its rate', 'entries':
         [['nu_r_dot_0', 0], ['nu_r_dot_1', 1], ['nu_r_dot_2', 2]], 'holder': 'reference',
         'is_scalar': False, 'member': 'nu_dot', 'name': 'nu_r_dot', 'shape': [3], 'size': 3,
         'source': '', 'unit': 'rad/s^2'}, {'argument': 'g_e', 'doc': 'error, g_r^-1 g', 'entries':
         [['g_e_0', 0], ['g_e_1', 1], ['g_e_2', 2], ['g_e_3', 3]], 'holder': '', 'is_scalar': False,
         'member': 'g_e', 'name': 'g_e', 'shape': [4], 'size': 4, 'source': 'eq. (velErr)', 'unit':
         '1'}], 'is_public': False, 'name': 'tracking', 'operations': 206, 'outputs': [{'doc':
         'control force', 'entries': ['force_0', 'force_1', 'force_2'], 'holder': 'command',
         'is_scalar': False, 'member': 'force', 'name': 'force', 'size': 3, 'source': '', 'unit': 'N
         m'}, {'doc': 'sliding variable', 'entries': ['s_0', 's_1', 's_2'], 'holder': 'command',
         'is_scalar': False, 'member': 's', 'name': 's', 'size': 3, 'source': '', 'unit': 'rad/s'},
         {'doc': 'kinematic law', 'entries': ['nu_u_0', 'nu_u_1', 'nu_u_2'], 'holder': 'command',
         'is_scalar': False, 'member': 'nu_u', 'name': 'nu_u', 'size': 3, 'source': '', 'unit':
         'rad'}, {'doc': 'its exact rate', 'entries': ['nu_u_dot_0', 'nu_u_dot_1', 'nu_u_dot_2'],
         'holder': 'command', 'is_scalar': False, 'member': 'nu_u_dot', 'name': 'nu_u_dot', 'size':
         3, 'source': '', 'unit': 'rad/s'}, {'doc': 'distance from the cut locus of the law',
         'entries': ['distance'], 'holder': '', 'is_scalar': True, 'member': 'clearance', 'name':
         'clearance', 'size': 1, 'source': '', 'unit': '1'}], 'public_writes': ['command',
         'clearance'], 'source': 'eq. (TckCtrl)', 'steps': [{'cases': [], 'doc': 'Ad of g_e^-1:
         reference to body frame', 'holder': '', 'is_scalar': False, 'lines': [['to_body_0', '1.0 -
         2.0*g_e_2*g_e_2 - 2.0*g_e_3*g_e_3'], ['to_body_1', '2.0*(g_e_0*g_e_3 + g_e_1*g_e_2)'],
         ['to_body_2', '2.0*(g_e_1*g_e_3 - g_e_0*g_e_2)'], ['to_body_3', '2.0*(g_e_1*g_e_2 -
         g_e_0*g_e_3)'], ['to_body_4', '1.0 - 2.0*g_e_1*g_e_1 - 2.0*g_e_3*g_e_3'], ['to_body_5',
         '2.0*(g_e_0*g_e_1 + g_e_2*g_e_3)'], ['to_body_6', '2.0*(g_e_0*g_e_2 + g_e_1*g_e_3)'],
         ['to_body_7', '2.0*(g_e_2*g_e_3 - g_e_0*g_e_1)'], ['to_body_8', '1.0 - 2.0*g_e_1*g_e_1 -
         2.0*g_e_2*g_e_2']], 'member': '', 'name': 'to_body', 'names': ['to_body_0', 'to_body_1',
         'to_body_2', 'to_body_3', 'to_body_4', 'to_body_5', 'to_body_6', 'to_body_7', 'to_body_8'],
         'size': 9, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'reference velocity in the body
         frame', 'holder': '', 'is_scalar': False, 'lines': [['eta_0', 'nu_r_0*to_body_0 +
         nu_r_1*to_body_1 + nu_r_2*to_body_2'], ['eta_1', 'nu_r_0*to_body_3 + nu_r_1*to_body_4 +
         nu_r_2*to_body_5'], ['eta_2', 'nu_r_0*to_body_6 + nu_r_1*to_body_7 + nu_r_2*to_body_8']],
         'member': '', 'name': 'eta', 'names': ['eta_0', 'eta_1', 'eta_2'], 'size': 3, 'source':
         'eq. (velErr)', 'unit': 'rad/s'}, {'cases': [], 'doc': 'velocity error', 'holder': '',
         'is_scalar': False, 'lines': [['nu_e_0', 'nu_0 - eta_0'], ['nu_e_1', 'nu_1 - eta_1'],
         ['nu_e_2', 'nu_2 - eta_2']], 'member': '', 'name': 'nu_e', 'names': ['nu_e_0', 'nu_e_1',
         'nu_e_2'], 'size': 3, 'source': 'eq. (velErr)', 'unit': 'rad/s'}, {'cases': [], 'doc':
         'exact rate of eta', 'holder': '', 'is_scalar': False, 'lines': [['eta_dot_0',
         'eta_1*nu_e_2 + nu_r_dot_0*to_body_0 + nu_r_dot_1*to_body_1 + nu_r_dot_2*to_body_2 -
         eta_2*nu_e_1'], ['eta_dot_1', 'eta_2*nu_e_0 + nu_r_dot_0*to_body_3 + nu_r_dot_1*to_body_4 +
         nu_r_dot_2*to_body_5 - eta_0*nu_e_2'], ['eta_dot_2', 'eta_0*nu_e_1 + nu_r_dot_0*to_body_6 +
         nu_r_dot_1*to_body_7 + nu_r_dot_2*to_body_8 - eta_1*nu_e_0']], 'member': '', 'name':
         'eta_dot', 'names': ['eta_dot_0', 'eta_dot_1', 'eta_dot_2'], 'size': 3, 'source': '',
         'unit': 'rad/s^2'}, {'cases': [], 'doc': 'squared length', 'holder': '', 'is_scalar': True,
         'lines': [['norm_square', 'g_e_0*g_e_0 + g_e_1*g_e_1 + g_e_2*g_e_2 + g_e_3*g_e_3']],
         'member': '', 'name': 'norm_square', 'names': ['norm_square'], 'size': 1, 'source': '',
         'unit': '1'}, {'cases': [{'condition': 'norm_square < 1.0e-7', 'lines': [['norm_bounded',
         '1.0e-7']]}, {'condition': '', 'lines': [['norm_bounded', 'norm_square']]}], 'doc': 'the
         same: less is no element', 'holder': '', 'is_scalar': True, 'lines': [], 'member': '',
         'name': 'norm_bounded', 'names': ['norm_bounded'], 'size': 1, 'source': '', 'unit': '1'},
         {'cases': [], 'doc': 'length', 'holder': '', 'is_scalar': True, 'lines': [['norm',
         'sqrt(norm_bounded)']], 'member': '', 'name': 'norm', 'names': ['norm'], 'size': 1,
         'source': '', 'unit': '1'}, {'cases': [], 'doc': 'to unit length', 'holder': '',
         'is_scalar': True, 'lines': [['scale', '1.0/norm']], 'member': '', 'name': 'scale',
         'names': ['scale'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'cos of
         half the error angle', 'holder': '', 'is_scalar': True, 'lines': [['w', 'g_e_0*scale']],
         'member': '', 'name': 'w', 'names': ['w'], 'size': 1, 'source': '', 'unit': '1'}, {'cases':
         [], 'doc': 'sin of half the error angle times its axis', 'holder': '', 'is_scalar': False,
         'lines': [['v_0', 'g_e_1*scale'], ['v_1', 'g_e_2*scale'], ['v_2', 'g_e_3*scale']],
         'member': '', 'name': 'v', 'names': ['v_0', 'v_1', 'v_2'], 'size': 3, 'source': '', 'unit':
         '1'}, {'cases': [], 'doc': 'half angle over its sine, for |w|', 'holder': '', 'is_scalar':
         True, 'lines': [['k_near', 'paper_s3_f64_k(fabs(w))']], 'member': '', 'name': 'k_near',
         'names': ['k_near'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'v.v',
         'holder': '', 'is_scalar': True, 'lines': [['sine_square', 'v_0*v_0 + v_1*v_1 + v_2*v_2']],
         'member': '', 'name': 'sine_square', 'names': ['sine_square'], 'size': 1, 'source': '',
         'unit': '1'}, {'cases': [{'condition': 'sine_square < (1.0e-60*1.0e-60)', 'lines':
         [['sine_bounded', '1.0e-60*1.0e-60']]}, {'condition': '', 'lines': [['sine_bounded',
         'sine_square']]}], 'doc': 'the same, away from -i and i', 'holder': '', 'is_scalar': True,
         'lines': [], 'member': '', 'name': 'sine_bounded', 'names': ['sine_bounded'], 'size': 1,
         'source': '', 'unit': '1'}, {'cases': [], 'doc': '|v|', 'holder': '', 'is_scalar': True,
         'lines': [['sine', 'sqrt(sine_bounded)']], 'member': '', 'name': 'sine', 'names': ['sine'],
         'size': 1, 'source': '', 'unit': '1'}, {'cases': [{'condition': 'w >= 0.0', 'lines': [['k',
         'k_near']]}, {'condition': '', 'lines': [['k', '3.141592653589793/sine - k_near']]}],
         'doc': 'half angle over its sine, on to 2 pi', 'holder': '', 'is_scalar': True, 'lines':
         [], 'member': '', 'name': 'k', 'names': ['k'], 'size': 1, 'source': '', 'unit': '1'},
         {'cases': [], 'doc': '-dk/dw, as (1 - w k)/s^2', 'holder': '', 'is_scalar': True, 'lines':
         [['h', '(1.0 - k*w)/sine_bounded']], 'member': '', 'name': 'h', 'names': ['h'], 'size': 1,
         'source': '', 'unit': '1'}, {'cases': [{'condition': 'w < 0.0', 'lines': [['distance',
         'sine']]}, {'condition': '', 'lines': [['distance', '1.0']]}], 'doc': 'distance from -i',
         'holder': '', 'is_scalar': True, 'lines': [], 'member': '', 'name': 'distance', 'names':
         ['distance'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'half of nu_u
         over v', 'holder': '', 'is_scalar': True, 'lines': [['p', '0.5*k']], 'member': '', 'name':
         'p', 'names': ['p'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': '-dp/dw',
         'holder': '', 'is_scalar': True, 'lines': [['drop', '0.5*h']], 'member': '', 'name':
         'drop', 'names': ['drop'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc':
         'kinematic law, half the rotation vector', 'holder': '', 'is_scalar': False, 'lines':
         [['nu_u_0', '2.0*p*v_0'], ['nu_u_1', '2.0*p*v_1'], ['nu_u_2', '2.0*p*v_2']], 'member': '',
         'name': 'nu_u', 'names': ['nu_u_0', 'nu_u_1', 'nu_u_2'], 'size': 3, 'source': 'eq.
         (KinCtrlLawS3)', 'unit': 'rad'}, {'cases': [], 'doc': 'v x nu_e', 'holder': '',
         'is_scalar': False, 'lines': [['turn_0', 'nu_e_2*v_1 - nu_e_1*v_2'], ['turn_1', 'nu_e_0*v_2
         - nu_e_2*v_0'], ['turn_2', 'nu_e_1*v_0 - nu_e_0*v_1']], 'member': '', 'name': 'turn',
         'names': ['turn_0', 'turn_1', 'turn_2'], 'size': 3, 'source': '', 'unit': 'rad/s'},
         {'cases': [], 'doc': 'v x (v x nu_e)', 'holder': '', 'is_scalar': False, 'lines':
         [['bend_0', 'turn_2*v_1 - turn_1*v_2'], ['bend_1', 'turn_0*v_2 - turn_2*v_0'], ['bend_2',
         'turn_1*v_0 - turn_0*v_1']], 'member': '', 'name': 'bend', 'names': ['bend_0', 'bend_1',
         'bend_2'], 'size': 3, 'source': '', 'unit': 'rad/s'}, {'cases': [], 'doc': 'exact rate of
         nu_u', 'holder': '', 'is_scalar': False, 'lines': [['nu_u_dot_0', '0.5*nu_e_0 + bend_0*drop
         + p*turn_0'], ['nu_u_dot_1', '0.5*nu_e_1 + bend_1*drop + p*turn_1'], ['nu_u_dot_2',
         '0.5*nu_e_2 + bend_2*drop + p*turn_2']], 'member': '', 'name': 'nu_u_dot', 'names':
         ['nu_u_dot_0', 'nu_u_dot_1', 'nu_u_dot_2'], 'size': 3, 'source': '', 'unit': 'rad/s'},
         {'cases': [], 'doc': 'lambda nu_u', 'holder': '', 'is_scalar': False, 'lines': [['drive_0',
         'nu_u_0*rate_gain'], ['drive_1', 'nu_u_1*rate_gain'], ['drive_2', 'nu_u_2*rate_gain']],
         'member': '', 'name': 'drive', 'names': ['drive_0', 'drive_1', 'drive_2'], 'size': 3,
         'source': '', 'unit': 'rad/s'}, {'cases': [], 'doc': 'sliding variable', 'holder': '',
         'is_scalar': False, 'lines': [['s_0', 'drive_0 + nu_e_0'], ['s_1', 'drive_1 + nu_e_1'],
         ['s_2', 'drive_2 + nu_e_2']], 'member': '', 'name': 's', 'names': ['s_0', 's_1', 's_2'],
         'size': 3, 'source': 'eq. (SurfaceErr)', 'unit': 'rad/s'}, {'cases': [], 'doc':
         'acceleration asked for', 'holder': '', 'is_scalar': False, 'lines': [['wanted_0',
         'eta_dot_0 - nu_u_dot_0*rate_gain - reach_gain*s_0'], ['wanted_1', 'eta_dot_1 -
         nu_u_dot_1*rate_gain - reach_gain*s_1'], ['wanted_2', 'eta_dot_2 - nu_u_dot_2*rate_gain -
         reach_gain*s_2']], 'member': '', 'name': 'wanted', 'names': ['wanted_0', 'wanted_1',
         'wanted_2'], 'size': 3, 'source': '', 'unit': 'rad/s^2'}, {'cases': [], 'doc': 'lambda nu_u
         - eta', 'holder': '', 'is_scalar': False, 'lines': [['turning_0', 'drive_0 - eta_0'],
         ['turning_1', 'drive_1 - eta_1'], ['turning_2', 'drive_2 - eta_2']], 'member': '', 'name':
         'turning', 'names': ['turning_0', 'turning_1', 'turning_2'], 'size': 3, 'source': '',
         'unit': 'rad/s'}, {'cases': [], 'doc': 'I nu', 'holder': '', 'is_scalar': False, 'lines':
         [['momentum_0', 'inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2'], ['momentum_1',
         'inertia_1*nu_0 + inertia_3*nu_1 + inertia_4*nu_2'], ['momentum_2', 'inertia_2*nu_0 +
         inertia_4*nu_1 + inertia_5*nu_2']], 'member': '', 'name': 'momentum', 'names':
         ['momentum_0', 'momentum_1', 'momentum_2'], 'size': 3, 'source': '', 'unit': 'N m s'},
         {'cases': [], 'doc': 'control force, I f_u', 'holder': '', 'is_scalar': False, 'lines':
         [['force_0', 'inertia_0*wanted_0 + inertia_1*wanted_1 + inertia_2*wanted_2 +
         momentum_1*turning_2 - momentum_2*turning_1'], ['force_1', 'inertia_1*wanted_0 +
         inertia_3*wanted_1 + inertia_4*wanted_2 + momentum_2*turning_0 - momentum_0*turning_2'],
         ['force_2', 'inertia_2*wanted_0 + inertia_4*wanted_1 + inertia_5*wanted_2 +
         momentum_0*turning_1 - momentum_1*turning_0']], 'member': '', 'name': 'force', 'names':
         ['force_0', 'force_1', 'force_2'], 'size': 3, 'source': 'eq. (TckCtrl)', 'unit': 'N m'}],
         'symbol': 'tracking', 'temporaries': 65, 'writes': ['command', 'clearance']}, double
         precision.
 * Every step below carries its quantity, unit and equation; trace.csv lists them by line.
 */
#include "paper_s3_f64.h"

#include <math.h>
#include <stddef.h>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "leave out -ffast-math, -Ofast, -ffinite-math-only: control must see NaN and infinity"
#endif

#if !defined(__GNUC__) || defined(__clang__)
#pragma STDC FP_CONTRACT OFF /* gcc: -ffp-contract=off */
#endif

const paper_s3_f64_params paper_s3_f64_defaults = {
    {3.6046, -0.0706, 0.1491, 8.6868, 0.0449, 9.3484},
    0.5, /* lambda */
    1.0, /* k_s */
    1.0e-6 /* max_drift */
};

/* Kernel function k(w) on 0 <= w <= 1, a polynomial in 1 - w. */
static inline double paper_s3_f64_k(const double w)
{
    const double z = 1.0 - w;
    double sum = 8.277514146196502e-5;
    sum = sum * z - 0.0007444806306887051;
    sum = sum * z + 0.00317670645149068;
    sum = sum * z - 0.008454515050142185;
    sum = sum * z + 0.01566904108961398;
    sum = sum * z - 0.02138402971876357;
    sum = sum * z + 0.022234983575225374;
    sum = sum * z - 0.01792610921286688;
    sum = sum * z + 0.011402056638616778;
    sum = sum * z - 0.005632546133953197;
    sum = sum * z + 0.002377672542009468;
    sum = sum * z - 0.0004366715134129454;
    sum = sum * z + 0.0007243405609038858;
    sum = sum * z + 0.0011382817325777553;
    sum = sum * z + 0.0024908875171720216;
    sum = sum * z + 0.0053275406688376775;
    sum = sum * z + 0.01154404554160158;
    sum = sum * z + 0.02539682373687369;
    sum = sum * z + 0.05714285719245186;
    sum = sum * z + 0.13333333333254913;
    sum = sum * z + 0.33333333333333826;
    sum = sum * z + 1.0;
    return sum;
}

static const paper_s3_f64_command paper_s3_f64_nothing = { {0.0}, {0.0}, {0.0}, {0.0} };

/* force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl), past the error. Gives the distance from
        the cut locus. */
static double paper_s3_f64_law(const paper_s3_f64_params *params, const paper_s3_f64_state *state,
        const paper_s3_f64_reference *reference, paper_s3_f64_command *command, const double g_e_0,
        const double g_e_1, const double g_e_2, const double g_e_3)
{
    /* -- tracking -- */
    const double inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_3 = params->inertia[3],
        inertia_4 = params->inertia[4], inertia_5 = params->inertia[5];
    const double rate_gain = params->lambda;
    const double reach_gain = params->k_s;
    const double nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2];
    const double nu_r_0 = reference->nu[0], nu_r_1 = reference->nu[1], nu_r_2 = reference->nu[2];
    const double nu_r_dot_0 = reference->nu_dot[0], nu_r_dot_1 = reference->nu_dot[1],
        nu_r_dot_2 = reference->nu_dot[2];

    /* to_body: Ad of g_e^-1: reference to body frame [1] */
    const double to_body_0 = 1.0 - 2.0*g_e_2*g_e_2 - 2.0*g_e_3*g_e_3;
    const double to_body_1 = 2.0*(g_e_0*g_e_3 + g_e_1*g_e_2);
    const double to_body_2 = 2.0*(g_e_1*g_e_3 - g_e_0*g_e_2);
    const double to_body_3 = 2.0*(g_e_1*g_e_2 - g_e_0*g_e_3);
    const double to_body_4 = 1.0 - 2.0*g_e_1*g_e_1 - 2.0*g_e_3*g_e_3;
    const double to_body_5 = 2.0*(g_e_0*g_e_1 + g_e_2*g_e_3);
    const double to_body_6 = 2.0*(g_e_0*g_e_2 + g_e_1*g_e_3);
    const double to_body_7 = 2.0*(g_e_2*g_e_3 - g_e_0*g_e_1);
    const double to_body_8 = 1.0 - 2.0*g_e_1*g_e_1 - 2.0*g_e_2*g_e_2;

    /* eta: reference velocity in the body frame [rad/s], eq. (velErr) */
    const double eta_0 = nu_r_0*to_body_0 + nu_r_1*to_body_1 + nu_r_2*to_body_2;
    const double eta_1 = nu_r_0*to_body_3 + nu_r_1*to_body_4 + nu_r_2*to_body_5;
    const double eta_2 = nu_r_0*to_body_6 + nu_r_1*to_body_7 + nu_r_2*to_body_8;

    /* nu_e: velocity error [rad/s], eq. (velErr) */
    const double nu_e_0 = nu_0 - eta_0;
    const double nu_e_1 = nu_1 - eta_1;
    const double nu_e_2 = nu_2 - eta_2;

    /* eta_dot: exact rate of eta [rad/s^2] */
    const double eta_dot_0 = eta_1*nu_e_2 + nu_r_dot_0*to_body_0 + nu_r_dot_1*to_body_1 +
        nu_r_dot_2*to_body_2 - eta_2*nu_e_1;
    const double eta_dot_1 = eta_2*nu_e_0 + nu_r_dot_0*to_body_3 + nu_r_dot_1*to_body_4 +
        nu_r_dot_2*to_body_5 - eta_0*nu_e_2;
    const double eta_dot_2 = eta_0*nu_e_1 + nu_r_dot_0*to_body_6 + nu_r_dot_1*to_body_7 +
        nu_r_dot_2*to_body_8 - eta_1*nu_e_0;

    /* norm_square: squared length [1] */
    const double norm_square = g_e_0*g_e_0 + g_e_1*g_e_1 + g_e_2*g_e_2 + g_e_3*g_e_3;

    /* norm_bounded: the same: less is no element [1] */
    double norm_bounded;
    if (norm_square < 1.0e-7) {
        norm_bounded = 1.0e-7;
    } else {
        norm_bounded = norm_square;
    }

    /* norm: length [1] */
    const double norm = sqrt(norm_bounded);

    /* scale: to unit length [1] */
    const double scale = 1.0/norm;

    /* w: cos of half the error angle [1] */
    const double w = g_e_0*scale;

    /* v: sin of half the error angle times its axis [1] */
    const double v_0 = g_e_1*scale;
    const double v_1 = g_e_2*scale;
    const double v_2 = g_e_3*scale;

    /* k_near: half angle over its sine, for |w| [1] */
    const double k_near = paper_s3_f64_k(fabs(w));

    /* sine_square: v.v [1] */
    const double sine_square = v_0*v_0 + v_1*v_1 + v_2*v_2;

    /* sine_bounded: the same, away from -i and i [1] */
    double sine_bounded;
    if (sine_square < (1.0e-60*1.0e-60)) {
        sine_bounded = 1.0e-60*1.0e-60;
    } else {
        sine_bounded = sine_square;
    }

    /* sine: |v| [1] */
    const double sine = sqrt(sine_bounded);

    /* k: half angle over its sine, on to 2 pi [1] */
    double k;
    if (w >= 0.0) {
        k = k_near;
    } else {
        k = 3.141592653589793/sine - k_near;
    }

    /* h: -dk/dw, as (1 - w k)/s^2 [1] */
    const double h = (1.0 - k*w)/sine_bounded;

    /* distance: distance from -i [1] */
    double distance;
    if (w < 0.0) {
        distance = sine;
    } else {
        distance = 1.0;
    }

    /* p: half of nu_u over v [1] */
    const double p = 0.5*k;

    /* drop: -dp/dw [1] */
    const double drop = 0.5*h;

    /* nu_u: kinematic law, half the rotation vector [rad], eq. (KinCtrlLawS3) */
    const double nu_u_0 = 2.0*p*v_0;
    const double nu_u_1 = 2.0*p*v_1;
    const double nu_u_2 = 2.0*p*v_2;

    /* turn: v x nu_e [rad/s] */
    const double turn_0 = nu_e_2*v_1 - nu_e_1*v_2;
    const double turn_1 = nu_e_0*v_2 - nu_e_2*v_0;
    const double turn_2 = nu_e_1*v_0 - nu_e_0*v_1;

    /* bend: v x (v x nu_e) [rad/s] */
    const double bend_0 = turn_2*v_1 - turn_1*v_2;
    const double bend_1 = turn_0*v_2 - turn_2*v_0;
    const double bend_2 = turn_1*v_0 - turn_0*v_1;

    /* nu_u_dot: exact rate of nu_u [rad/s] */
    const double nu_u_dot_0 = 0.5*nu_e_0 + bend_0*drop + p*turn_0;
    const double nu_u_dot_1 = 0.5*nu_e_1 + bend_1*drop + p*turn_1;
    const double nu_u_dot_2 = 0.5*nu_e_2 + bend_2*drop + p*turn_2;

    /* drive: lambda nu_u [rad/s] */
    const double drive_0 = nu_u_0*rate_gain;
    const double drive_1 = nu_u_1*rate_gain;
    const double drive_2 = nu_u_2*rate_gain;

    /* s: sliding variable [rad/s], eq. (SurfaceErr) */
    const double s_0 = drive_0 + nu_e_0;
    const double s_1 = drive_1 + nu_e_1;
    const double s_2 = drive_2 + nu_e_2;

    /* wanted: acceleration asked for [rad/s^2] */
    const double wanted_0 = eta_dot_0 - nu_u_dot_0*rate_gain - reach_gain*s_0;
    const double wanted_1 = eta_dot_1 - nu_u_dot_1*rate_gain - reach_gain*s_1;
    const double wanted_2 = eta_dot_2 - nu_u_dot_2*rate_gain - reach_gain*s_2;

    /* turning: lambda nu_u - eta [rad/s] */
    const double turning_0 = drive_0 - eta_0;
    const double turning_1 = drive_1 - eta_1;
    const double turning_2 = drive_2 - eta_2;

    /* momentum: I nu [N m s] */
    const double momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2;
    const double momentum_1 = inertia_1*nu_0 + inertia_3*nu_1 + inertia_4*nu_2;
    const double momentum_2 = inertia_2*nu_0 + inertia_4*nu_1 + inertia_5*nu_2;

    /* force: control force, I f_u [N m], eq. (TckCtrl) */
    const double force_0 = inertia_0*wanted_0 + inertia_1*wanted_1 + inertia_2*wanted_2 +
        momentum_1*turning_2 - momentum_2*turning_1;
    const double force_1 = inertia_1*wanted_0 + inertia_3*wanted_1 + inertia_4*wanted_2 +
        momentum_2*turning_0 - momentum_0*turning_2;
    const double force_2 = inertia_2*wanted_0 + inertia_4*wanted_1 + inertia_5*wanted_2 +
        momentum_0*turning_1 - momentum_1*turning_0;

    /* -- end -- */
    command->force[0] = force_0;
    command->force[1] = force_1;
    command->force[2] = force_2;
    command->s[0] = s_0;
    command->s[1] = s_1;
    command->s[2] = s_2;
    command->nu_u[0] = nu_u_0;
    command->nu_u[1] = nu_u_1;
    command->nu_u[2] = nu_u_2;
    command->nu_u_dot[0] = nu_u_dot_0;
    command->nu_u_dot[1] = nu_u_dot_1;
    command->nu_u_dot[2] = nu_u_dot_2;
    return distance;
}

/* pivots of the inertia: all positive for a valid one. */
static void paper_s3_f64_definiteness(const paper_s3_f64_params *params, double pivot[3])
{
    /* -- definiteness -- */
    const double inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_3 = params->inertia[3],
        inertia_4 = params->inertia[4], inertia_5 = params->inertia[5];

    /* divisor_0: the pivot, or 1 where it is not positive [kg m^2] */
    double divisor_0;
    if (inertia_0 > 0.0) {
        divisor_0 = inertia_0;
    } else {
        divisor_0 = 1.0;
    }

    /* lower_10: I = L D L^T, entry of L [1] */
    const double lower_10 = inertia_1/divisor_0;

    /* lower_20: I = L D L^T, entry of L [1] */
    const double lower_20 = inertia_2/divisor_0;

    /* pivot_1: pivot of I [kg m^2] */
    const double pivot_1 = inertia_3 - inertia_0*lower_10*lower_10;

    /* divisor_1: the pivot, or 1 where it is not positive [kg m^2] */
    double divisor_1;
    if (pivot_1 > 0.0) {
        divisor_1 = pivot_1;
    } else {
        divisor_1 = 1.0;
    }

    /* lower_21: I = L D L^T, entry of L [1] */
    const double lower_21 = (inertia_4 - inertia_0*lower_10*lower_20)/divisor_1;

    /* pivot_2: pivot of I [kg m^2] */
    const double pivot_2 = inertia_5 - inertia_0*lower_20*lower_20 - pivot_1*lower_21*lower_21;

    /* -- end -- */
    pivot[0] = inertia_0;
    pivot[1] = pivot_1;
    pivot[2] = pivot_2;
}

void paper_s3_f64_tracking(const paper_s3_f64_params *params, const paper_s3_f64_state *state,
        const paper_s3_f64_reference *reference, paper_s3_f64_command *command)
{
    /* -- tracking -- */
    const double g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3];
    const double g_r_0 = reference->g[0], g_r_1 = reference->g[1], g_r_2 = reference->g[2],
        g_r_3 = reference->g[3];

    /* g_e: error, g_r^-1 g [1], eq. (velErr) */
    const double g_e_0 = g_0*g_r_0 + g_1*g_r_1 + g_2*g_r_2 + g_3*g_r_3;
    const double g_e_1 = g_1*g_r_0 + g_2*g_r_3 - g_0*g_r_1 - g_3*g_r_2;
    const double g_e_2 = g_2*g_r_0 + g_3*g_r_1 - g_0*g_r_2 - g_1*g_r_3;
    const double g_e_3 = g_1*g_r_2 + g_3*g_r_0 - g_0*g_r_3 - g_2*g_r_1;

    /* -- end -- */
    (void)paper_s3_f64_law(params, state, reference, command, g_e_0, g_e_1, g_e_2, g_e_3);
}

void paper_s3_f64_reaching(const paper_s3_f64_params *params, const paper_s3_f64_state *state,
        paper_s3_f64_command *command)
{
    /* -- reaching -- */
    const double inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_3 = params->inertia[3],
        inertia_4 = params->inertia[4], inertia_5 = params->inertia[5];
    const double rate_gain = params->lambda;
    const double reach_gain = params->k_s;
    const double g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3];
    const double nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2];

    /* norm_square: squared length [1] */
    const double norm_square = g_0*g_0 + g_1*g_1 + g_2*g_2 + g_3*g_3;

    /* norm_bounded: the same: less is no element [1] */
    double norm_bounded;
    if (norm_square < 1.0e-7) {
        norm_bounded = 1.0e-7;
    } else {
        norm_bounded = norm_square;
    }

    /* norm: length [1] */
    const double norm = sqrt(norm_bounded);

    /* scale: to unit length [1] */
    const double scale = 1.0/norm;

    /* w: cos of half the error angle [1] */
    const double w = g_0*scale;

    /* v: sin of half the error angle times its axis [1] */
    const double v_0 = g_1*scale;
    const double v_1 = g_2*scale;
    const double v_2 = g_3*scale;

    /* k_near: half angle over its sine, for |w| [1] */
    const double k_near = paper_s3_f64_k(fabs(w));

    /* sine_square: v.v [1] */
    const double sine_square = v_0*v_0 + v_1*v_1 + v_2*v_2;

    /* sine_bounded: the same, away from -i and i [1] */
    double sine_bounded;
    if (sine_square < (1.0e-60*1.0e-60)) {
        sine_bounded = 1.0e-60*1.0e-60;
    } else {
        sine_bounded = sine_square;
    }

    /* sine: |v| [1] */
    const double sine = sqrt(sine_bounded);

    /* k: half angle over its sine, on to 2 pi [1] */
    double k;
    if (w >= 0.0) {
        k = k_near;
    } else {
        k = 3.141592653589793/sine - k_near;
    }

    /* h: -dk/dw, as (1 - w k)/s^2 [1] */
    const double h = (1.0 - k*w)/sine_bounded;

    /* p: half of nu_u over v [1] */
    const double p = 0.5*k;

    /* drop: -dp/dw [1] */
    const double drop = 0.5*h;

    /* nu_u: kinematic law, half the rotation vector [rad], eq. (KinCtrlLawS3) */
    const double nu_u_0 = 2.0*p*v_0;
    const double nu_u_1 = 2.0*p*v_1;
    const double nu_u_2 = 2.0*p*v_2;

    /* turn: v x nu_e [rad/s] */
    const double turn_0 = nu_2*v_1 - nu_1*v_2;
    const double turn_1 = nu_0*v_2 - nu_2*v_0;
    const double turn_2 = nu_1*v_0 - nu_0*v_1;

    /* bend: v x (v x nu_e) [rad/s] */
    const double bend_0 = turn_2*v_1 - turn_1*v_2;
    const double bend_1 = turn_0*v_2 - turn_2*v_0;
    const double bend_2 = turn_1*v_0 - turn_0*v_1;

    /* nu_u_dot: exact rate of nu_u [rad/s] */
    const double nu_u_dot_0 = 0.5*nu_0 + bend_0*drop + p*turn_0;
    const double nu_u_dot_1 = 0.5*nu_1 + bend_1*drop + p*turn_1;
    const double nu_u_dot_2 = 0.5*nu_2 + bend_2*drop + p*turn_2;

    /* drive: lambda nu_u [rad/s] */
    const double drive_0 = nu_u_0*rate_gain;
    const double drive_1 = nu_u_1*rate_gain;
    const double drive_2 = nu_u_2*rate_gain;

    /* s: sliding variable [rad/s], eq. (sldS) */
    const double s_0 = drive_0 + nu_0;
    const double s_1 = drive_1 + nu_1;
    const double s_2 = drive_2 + nu_2;

    /* wanted: acceleration asked for [rad/s^2] */
    const double wanted_0 = -(nu_u_dot_0*rate_gain + reach_gain*s_0);
    const double wanted_1 = -(nu_u_dot_1*rate_gain + reach_gain*s_1);
    const double wanted_2 = -(nu_u_dot_2*rate_gain + reach_gain*s_2);

    /* momentum: I nu [N m s] */
    const double momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2;
    const double momentum_1 = inertia_1*nu_0 + inertia_3*nu_1 + inertia_4*nu_2;
    const double momentum_2 = inertia_2*nu_0 + inertia_4*nu_1 + inertia_5*nu_2;

    /* force: control force, I f_u [N m], eq. (Ctrl2) */
    const double force_0 = drive_2*momentum_1 + inertia_0*wanted_0 + inertia_1*wanted_1 +
        inertia_2*wanted_2 - drive_1*momentum_2;
    const double force_1 = drive_0*momentum_2 + inertia_1*wanted_0 + inertia_3*wanted_1 +
        inertia_4*wanted_2 - drive_2*momentum_0;
    const double force_2 = drive_1*momentum_0 + inertia_2*wanted_0 + inertia_4*wanted_1 +
        inertia_5*wanted_2 - drive_0*momentum_1;

    /* -- end -- */
    command->force[0] = force_0;
    command->force[1] = force_1;
    command->force[2] = force_2;
    command->s[0] = s_0;
    command->s[1] = s_1;
    command->s[2] = s_2;
    command->nu_u[0] = nu_u_0;
    command->nu_u[1] = nu_u_1;
    command->nu_u[2] = nu_u_2;
    command->nu_u_dot[0] = nu_u_dot_0;
    command->nu_u_dot[1] = nu_u_dot_1;
    command->nu_u_dot[2] = nu_u_dot_2;
}

void paper_s3_f64_plant(const paper_s3_f64_params *params, const paper_s3_f64_state *state,
        const double force[3], double nu_dot[3])
{
    /* -- plant -- */
    const double inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_3 = params->inertia[3],
        inertia_4 = params->inertia[4], inertia_5 = params->inertia[5];
    const double nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2];
    const double force_0 = force[0], force_1 = force[1], force_2 = force[2];

    /* momentum: I nu [N m s] */
    const double momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2;
    const double momentum_1 = inertia_1*nu_0 + inertia_3*nu_1 + inertia_4*nu_2;
    const double momentum_2 = inertia_2*nu_0 + inertia_4*nu_1 + inertia_5*nu_2;

    /* total: coad(nu) I nu + force [N m] */
    const double total_0 = force_0 + momentum_1*nu_2 - momentum_2*nu_1;
    const double total_1 = force_1 + momentum_2*nu_0 - momentum_0*nu_2;
    const double total_2 = force_2 + momentum_0*nu_1 - momentum_1*nu_0;

    /* lower_10: I = L D L^T, entry of L [1] */
    const double lower_10 = inertia_1/inertia_0;

    /* lower_20: I = L D L^T, entry of L [1] */
    const double lower_20 = inertia_2/inertia_0;

    /* pivot_1: pivot of I [kg m^2] */
    const double pivot_1 = inertia_3 - inertia_0*lower_10*lower_10;

    /* lower_21: I = L D L^T, entry of L [1] */
    const double lower_21 = (inertia_4 - inertia_0*lower_10*lower_20)/pivot_1;

    /* pivot_2: pivot of I [kg m^2] */
    const double pivot_2 = inertia_5 - inertia_0*lower_20*lower_20 - pivot_1*lower_21*lower_21;

    /* forward_1: forward substitution [N m] */
    const double forward_1 = total_1 - lower_10*total_0;

    /* forward_2: forward substitution [N m] */
    const double forward_2 = total_2 - forward_1*lower_21 - lower_20*total_0;

    /* back_2: back substitution [rad/s^2] */
    const double back_2 = forward_2/pivot_2;

    /* back_1: back substitution [rad/s^2] */
    const double back_1 = forward_1/pivot_1 - back_2*lower_21;

    /* back_0: back substitution [rad/s^2] */
    const double back_0 = total_0/inertia_0 - back_1*lower_10 - back_2*lower_20;

    /* -- end -- */
    nu_dot[0] = back_0;
    nu_dot[1] = back_1;
    nu_dot[2] = back_2;
}

/* The worse of two findings. */
static paper_s3_f64_status paper_s3_f64_worse(const paper_s3_f64_status a,
        const paper_s3_f64_status b)
{
    return a > b ? a : b;
}

/* OUT_OF_RANGE or NONFINITE_INPUT if any number is larger than a limit or not finite. */
static paper_s3_f64_status paper_s3_f64_inspect(const double *numbers, const int count,
        const double limit)
{
    paper_s3_f64_status worst = PAPER_S3_F64_OK;
    int i;
    for (i = 0; i < count; i++) {
        if (!isfinite(numbers[i])) {
            worst = PAPER_S3_F64_NONFINITE_INPUT;
        } else if (fabs(numbers[i]) > limit) {
            worst = paper_s3_f64_worse(worst, PAPER_S3_F64_OUT_OF_RANGE);
        }
    }
    return worst;
}

/* Zero command; its status says what is wrong with what was refused, at least what was found. */
static paper_s3_f64_status paper_s3_f64_refuse(const paper_s3_f64_state *state,
        const paper_s3_f64_reference *reference, const paper_s3_f64_status found,
        paper_s3_f64_command *command)
{
    paper_s3_f64_status worst = found;
    worst = paper_s3_f64_worse(worst,
            paper_s3_f64_inspect(state->g, 4, PAPER_S3_F64_MAX_INPUT));
    worst = paper_s3_f64_worse(worst,
            paper_s3_f64_inspect(state->nu, 3, PAPER_S3_F64_MAX_INPUT));
    worst = paper_s3_f64_worse(worst,
            paper_s3_f64_inspect(reference->g, 4, PAPER_S3_F64_MAX_INPUT));
    worst = paper_s3_f64_worse(worst,
            paper_s3_f64_inspect(reference->nu, 3, PAPER_S3_F64_MAX_INPUT));
    worst = paper_s3_f64_worse(worst,
            paper_s3_f64_inspect(reference->nu_dot, 3, PAPER_S3_F64_MAX_INPUT));
    *command = paper_s3_f64_nothing;
    return worst;
}

/* What a computed command is worth, given its distance from the cut locus of the law. */
static paper_s3_f64_status paper_s3_f64_verdict(const double clearance,
        paper_s3_f64_command *command)
{
    if (!(isfinite(command->force[0]) && isfinite(command->force[1]) &&
            isfinite(command->force[2]))) {
        *command = paper_s3_f64_nothing;
        return PAPER_S3_F64_NONFINITE_INPUT;
    }
    if (clearance < PAPER_S3_F64_REFUSED_CUT) {
        *command = paper_s3_f64_nothing;
        return PAPER_S3_F64_OUT_OF_RANGE;
    }
    return clearance < PAPER_S3_F64_NEAR_CUT ? PAPER_S3_F64_NEAR_CUT_LOCUS : PAPER_S3_F64_OK;
}

paper_s3_f64_status paper_s3_f64_control(const paper_s3_f64_params *params,
        const paper_s3_f64_state *state, const paper_s3_f64_reference *reference,
        paper_s3_f64_command *command)
{
    double clearance;
#ifdef PAPER_S3_CHECK_POINTERS /* none may be null: a precondition, which the self-test checks */
    if (params == NULL || state == NULL || reference == NULL || command == NULL) {
        return PAPER_S3_F64_BAD_PARAMS;
    }
#endif
    /* -- tracking -- */
    const double g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3];
    const double g_r_0 = reference->g[0], g_r_1 = reference->g[1], g_r_2 = reference->g[2],
        g_r_3 = reference->g[3];

    /* g_e: error, g_r^-1 g [1], eq. (velErr) */
    const double g_e_0 = g_0*g_r_0 + g_1*g_r_1 + g_2*g_r_2 + g_3*g_r_3;
    const double g_e_1 = g_1*g_r_0 + g_2*g_r_3 - g_0*g_r_1 - g_3*g_r_2;
    const double g_e_2 = g_2*g_r_0 + g_3*g_r_1 - g_0*g_r_2 - g_1*g_r_3;
    const double g_e_3 = g_1*g_r_2 + g_3*g_r_0 - g_0*g_r_3 - g_2*g_r_1;

    /* -- end -- */
    if (!(fabs(g_e_0) <= PAPER_S3_F64_MAX_ENTRY && fabs(g_e_1) <= PAPER_S3_F64_MAX_ENTRY
            && fabs(g_e_2) <= PAPER_S3_F64_MAX_ENTRY && fabs(g_e_3) <= PAPER_S3_F64_MAX_ENTRY
            && fabs(state->nu[0]) <= PAPER_S3_F64_MAX_INPUT
            && fabs(state->nu[1]) <= PAPER_S3_F64_MAX_INPUT
            && fabs(state->nu[2]) <= PAPER_S3_F64_MAX_INPUT
            && fabs(reference->nu[0]) <= PAPER_S3_F64_MAX_INPUT
            && fabs(reference->nu[1]) <= PAPER_S3_F64_MAX_INPUT
            && fabs(reference->nu[2]) <= PAPER_S3_F64_MAX_INPUT
            && fabs(reference->nu_dot[0]) <= PAPER_S3_F64_MAX_INPUT
            && fabs(reference->nu_dot[1]) <= PAPER_S3_F64_MAX_INPUT
            && fabs(reference->nu_dot[2]) <= PAPER_S3_F64_MAX_INPUT)) {
        return paper_s3_f64_refuse(state, reference, PAPER_S3_F64_NOT_ON_GROUP, command);
    }
    /* -- drift -- */

    /* off: what vanishes on the group, and only there [1] */
    const double off_0 = g_e_0*g_e_0 - 1.0 + g_e_1*g_e_1 + g_e_2*g_e_2 + g_e_3*g_e_3;

    /* drift: square of the distance from the group [1] */
    const double drift = off_0*off_0;

    /* -- end -- */

    if (!(drift <= params->max_drift*params->max_drift)) {
        return paper_s3_f64_refuse(state, reference, PAPER_S3_F64_NOT_ON_GROUP, command);
    }
    clearance = paper_s3_f64_law(params, state, reference, command, g_e_0, g_e_1, g_e_2, g_e_3);
    return paper_s3_f64_verdict(clearance, command);
}

paper_s3_f64_status paper_s3_f64_check_params(const paper_s3_f64_params *params)
{
#ifdef PAPER_S3_CHECK_POINTERS
    if (params == NULL) {
        return PAPER_S3_F64_BAD_PARAMS;
    }
#endif
    double pivot[3];
    int i;
    if (paper_s3_f64_inspect(params->inertia, 6, PAPER_S3_F64_MAX_PARAM) != PAPER_S3_F64_OK) {
        return PAPER_S3_F64_BAD_PARAMS;
    }
    if (!(params->lambda >= PAPER_S3_F64_MIN_GAIN && params->lambda <= PAPER_S3_F64_MAX_RATE)) {
        return PAPER_S3_F64_BAD_PARAMS;
    }
    if (!(params->k_s >= PAPER_S3_F64_MIN_GAIN && params->k_s <= PAPER_S3_F64_MAX_RATE)) {
        return PAPER_S3_F64_BAD_PARAMS;
    }
    if (!(params->max_drift > 0.0 && params->max_drift <= PAPER_S3_F64_MOST_DRIFT)) {
        return PAPER_S3_F64_BAD_PARAMS;
    }
    paper_s3_f64_definiteness(params, pivot);
    for (i = 0; i < 3; i++) {
        if (!(pivot[i] > 0.0)) {
            return PAPER_S3_F64_BAD_PARAMS;
        }
    }
    return PAPER_S3_F64_OK;
}
