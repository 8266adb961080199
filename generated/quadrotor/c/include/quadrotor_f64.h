/**
 * @file
 * @brief quadrotor_f64: gsmc on S3, law {'name': 'tracking', 'doc': 'force that drives (g, nu) to
 *     (g_r, nu_r)', 'source': 'eq. (TckCtrl)', 'inputs': [{'name': 'inertia', 'size': 6, 'unit':
 *     'kg m^2', 'doc': 'inertia, upper triangle, row by row', 'source': '', 'is_scalar': False,
 *     'holder': 'params', 'member': 'inertia', 'entries': [['inertia_0', 0], ['inertia_2', 2],
 *     ['inertia_3', 3], ['inertia_5', 5]], 'argument': 'inertia', 'shape': (6,)}, {'name':
 *     'rate_gain', 'size': 1, 'unit': '1/s', 'doc': 'sliding rate', 'source': '', 'is_scalar':
 *     True, 'holder': 'params', 'member': 'lambda', 'entries': [['rate_gain', 0]], 'argument':
 *     'lambda_', 'shape': (1,)}, {'name': 'reach_gain', 'size': 1, 'unit': '1/s', 'doc': 'reaching
 *     rate', 'source': '', 'is_scalar': True, 'holder': 'params', 'member': 'k_s', 'entries':
 *     [['reach_gain', 0]], 'argument': 'k_s', 'shape': (1,)}, {'name': 'nu', 'size': 3, 'unit':
 *     'rad/s', 'doc': 'body velocity', 'source': '', 'is_scalar': False, 'holder': 'state',
 *     'member': 'nu', 'entries': [['nu_0', 0], ['nu_1', 1], ['nu_2', 2]], 'argument': 'nu',
 *     'shape': (3,)}, {'name': 'nu_r', 'size': 3, 'unit': 'rad/s', 'doc': 'reference velocity,
 *     reference body frame', 'source': '', 'is_scalar': False, 'holder': 'reference', 'member':
 *     'nu', 'entries': [['nu_r_0', 0], ['nu_r_1', 1], ['nu_r_2', 2]], 'argument': 'nu_r', 'shape':
 *     (3,)}, {'name': 'nu_r_dot', 'size': 3, 'unit': 'rad/s^2', 'doc': 'its rate', 'source': '',
 *     'is_scalar': False, 'holder': 'reference', 'member': 'nu_dot', 'entries': [['nu_r_dot_0', 0],
 *     ['nu_r_dot_1', 1], ['nu_r_dot_2', 2]], 'argument': 'nu_r_dot', 'shape': (3,)}, {'name':
 *     'g_e', 'size': 4, 'unit': '1', 'doc': 'error, g_r^-1 g', 'source': 'eq. (velErr)',
 *     'is_scalar': False, 'holder': '', 'member': 'g_e', 'entries': [['g_e_0', 0], ['g_e_1', 1],
 *     ['g_e_2', 2], ['g_e_3', 3]], 'argument': 'g_e', 'shape': (4,)}], 'steps': [{'name':
 *     'to_body', 'size': 9, 'unit': '1', 'doc': 'Ad of g_e^-1: reference to body frame', 'source':
 *     '', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['to_body_0', 'to_body_1',
 *     'to_body_2', 'to_body_3', 'to_body_4', 'to_body_5', 'to_body_6', 'to_body_7', 'to_body_8'],
 *     'lines': [['to_body_0', '1.0 - 2.0*g_e_2*g_e_2 - 2.0*g_e_3*g_e_3'], ['to_body_1',
 *     '2.0*(g_e_0*g_e_3 + g_e_1*g_e_2)'], ['to_body_2', '2.0*(g_e_1*g_e_3 - g_e_0*g_e_2)'],
 *     ['to_body_3', '2.0*(g_e_1*g_e_2 - g_e_0*g_e_3)'], ['to_body_4', '1.0 - 2.0*g_e_1*g_e_1 -
 *     2.0*g_e_3*g_e_3'], ['to_body_5', '2.0*(g_e_0*g_e_1 + g_e_2*g_e_3)'], ['to_body_6',
 *     '2.0*(g_e_0*g_e_2 + g_e_1*g_e_3)'], ['to_body_7', '2.0*(g_e_2*g_e_3 - g_e_0*g_e_1)'],
 *     ['to_body_8', '1.0 - 2.0*g_e_1*g_e_1 - 2.0*g_e_2*g_e_2']], 'cases': []}, {'name': 'eta',
 *     'size': 3, 'unit': 'rad/s', 'doc': 'reference velocity in the body frame', 'source': 'eq.
 *     (velErr)', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['eta_0', 'eta_1',
 *     'eta_2'], 'lines': [['eta_0', 'nu_r_0*to_body_0 + nu_r_1*to_body_1 + nu_r_2*to_body_2'],
 *     ['eta_1', 'nu_r_0*to_body_3 + nu_r_1*to_body_4 + nu_r_2*to_body_5'], ['eta_2',
 *     'nu_r_0*to_body_6 + nu_r_1*to_body_7 + nu_r_2*to_body_8']], 'cases': []}, {'name': 'nu_e',
 *     'size': 3, 'unit': 'rad/s', 'doc': 'velocity error', 'source': 'eq. (velErr)', 'is_scalar':
 *     False, 'holder': '', 'member': '', 'names': ['nu_e_0', 'nu_e_1', 'nu_e_2'], 'lines':
 *     [['nu_e_0', 'nu_0 - eta_0'], ['nu_e_1', 'nu_1 - eta_1'], ['nu_e_2', 'nu_2 - eta_2']],
 *     'cases': []}, {'name': 'eta_dot', 'size': 3, 'unit': 'rad/s^2', 'doc': 'exact rate of eta',
 *     'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['eta_dot_0',
 *     'eta_dot_1', 'eta_dot_2'], 'lines': [['eta_dot_0', 'eta_1*nu_e_2 + nu_r_dot_0*to_body_0 +
 *     nu_r_dot_1*to_body_1 + nu_r_dot_2*to_body_2 - eta_2*nu_e_1'], ['eta_dot_1', 'eta_2*nu_e_0 +
 *     nu_r_dot_0*to_body_3 + nu_r_dot_1*to_body_4 + nu_r_dot_2*to_body_5 - eta_0*nu_e_2'],
 *     ['eta_dot_2', 'eta_0*nu_e_1 + nu_r_dot_0*to_body_6 + nu_r_dot_1*to_body_7 +
 *     nu_r_dot_2*to_body_8 - eta_1*nu_e_0']], 'cases': []}, {'name': 'norm_square', 'size': 1,
 *     'unit': '1', 'doc': 'squared length', 'source': '', 'is_scalar': True, 'holder': '',
 *     'member': '', 'names': ['norm_square'], 'lines': [['norm_square', 'g_e_0*g_e_0 + g_e_1*g_e_1
 *     + g_e_2*g_e_2 + g_e_3*g_e_3']], 'cases': []}, {'name': 'norm_bounded', 'size': 1, 'unit':
 *     '1', 'doc': 'the same: less is no element', 'source': '', 'is_scalar': True, 'holder': '',
 *     'member': '', 'names': ['norm_bounded'], 'lines': [], 'cases': [{'condition': 'norm_square <
 *     1.0e-7', 'lines': [['norm_bounded', '1.0e-7']]}, {'condition': '', 'lines': [['norm_bounded',
 *     'norm_square']]}]}, {'name': 'norm', 'size': 1, 'unit': '1', 'doc': 'length', 'source': '',
 *     'is_scalar': True, 'holder': '', 'member': '', 'names': ['norm'], 'lines': [['norm',
 *     'sqrt(norm_bounded)']], 'cases': []}, {'name': 'scale', 'size': 1, 'unit': '1', 'doc': 'to
 *     unit length', 'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names':
 *     ['scale'], 'lines': [['scale', '1.0/norm']], 'cases': []}, {'name': 'w', 'size': 1, 'unit':
 *     '1', 'doc': 'cos of half the error angle', 'source': '', 'is_scalar': True, 'holder': '',
 *     'member': '', 'names': ['w'], 'lines': [['w', 'g_e_0*scale']], 'cases': []}, {'name': 'v',
 *     'size': 3, 'unit': '1', 'doc': 'sin of half the error angle times its axis', 'source': '',
 *     'is_scalar': False, 'holder': '', 'member': '', 'names': ['v_0', 'v_1', 'v_2'], 'lines':
 *     [['v_0', 'g_e_1*scale'], ['v_1', 'g_e_2*scale'], ['v_2', 'g_e_3*scale']], 'cases': []},
 *     {'name': 'k_near', 'size': 1, 'unit': '1', 'doc': 'half angle over its sine, for |w|',
 *     'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['k_near'], 'lines':
 *     [['k_near', 'quadrotor_f64_k(fabs(w))']], 'cases': []}, {'name': 'sine_square', 'size': 1,
 *     'unit': '1', 'doc': 'v.v', 'source': '', 'is_scalar': True, 'holder': '', 'member': '',
 *     'names': ['sine_square'], 'lines': [['sine_square', 'v_0*v_0 + v_1*v_1 + v_2*v_2']], 'cases':
 *     []}, {'name': 'sine_bounded', 'size': 1, 'unit': '1', 'doc': 'the same, away from -i and i',
 *     'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['sine_bounded'],
 *     'lines': [], 'cases': [{'condition': 'sine_square < (1.0e-60*1.0e-60)', 'lines':
 *     [['sine_bounded', '1.0e-60*1.0e-60']]}, {'condition': '', 'lines': [['sine_bounded',
 *     'sine_square']]}]}, {'name': 'sine', 'size': 1, 'unit': '1', 'doc': '|v|', 'source': '',
 *     'is_scalar': True, 'holder': '', 'member': '', 'names': ['sine'], 'lines': [['sine',
 *     'sqrt(sine_bounded)']], 'cases': []}, {'name': 'k', 'size': 1, 'unit': '1', 'doc': 'half
 *     angle over its sine, on to 2 pi', 'source': '', 'is_scalar': True, 'holder': '', 'member':
 *     '', 'names': ['k'], 'lines': [], 'cases': [{'condition': 'w >= 0.0', 'lines': [['k',
 *     'k_near']]}, {'condition': '', 'lines': [['k', '3.141592653589793/sine - k_near']]}]},
 *     {'name': 'h', 'size': 1, 'unit': '1', 'doc': '-dk/dw, as (1 - w k)/s^2', 'source': '',
 *     'is_scalar': True, 'holder': '', 'member': '', 'names': ['h'], 'lines': [['h', '(1.0 -
 *     k*w)/sine_bounded']], 'cases': []}, {'name': 'distance', 'size': 1, 'unit': '1', 'doc':
 *     'distance from -i', 'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names':
 *     ['distance'], 'lines': [], 'cases': [{'condition': 'w < 0.0', 'lines': [['distance',
 *     'sine']]}, {'condition': '', 'lines': [['distance', '1.0']]}]}, {'name': 'nu_u', 'size': 3,
 *     'unit': 'rad', 'doc': 'kinematic law, the rotation vector', 'source': 'def. (KctrLaw)',
 *     'is_scalar': False, 'holder': '', 'member': '', 'names': ['nu_u_0', 'nu_u_1', 'nu_u_2'],
 *     'lines': [['nu_u_0', '2.0*k*v_0'], ['nu_u_1', '2.0*k*v_1'], ['nu_u_2', '2.0*k*v_2']],
 *     'cases': []}, {'name': 'turn', 'size': 3, 'unit': 'rad/s', 'doc': 'v x nu_e', 'source': '',
 *     'is_scalar': False, 'holder': '', 'member': '', 'names': ['turn_0', 'turn_1', 'turn_2'],
 *     'lines': [['turn_0', 'nu_e_2*v_1 - nu_e_1*v_2'], ['turn_1', 'nu_e_0*v_2 - nu_e_2*v_0'],
 *     ['turn_2', 'nu_e_1*v_0 - nu_e_0*v_1']], 'cases': []}, {'name': 'bend', 'size': 3, 'unit':
 *     'rad/s', 'doc': 'v x (v x nu_e)', 'source': '', 'is_scalar': False, 'holder': '', 'member':
 *     '', 'names': ['bend_0', 'bend_1', 'bend_2'], 'lines': [['bend_0', 'turn_2*v_1 - turn_1*v_2'],
 *     ['bend_1', 'turn_0*v_2 - turn_2*v_0'], ['bend_2', 'turn_1*v_0 - turn_0*v_1']], 'cases': []},
 *     {'name': 'nu_u_dot', 'size': 3, 'unit': 'rad/s', 'doc': 'exact rate of nu_u', 'source': '',
 *     'is_scalar': False, 'holder': '', 'member': '', 'names': ['nu_u_dot_0', 'nu_u_dot_1',
 *     'nu_u_dot_2'], 'lines': [['nu_u_dot_0', 'nu_e_0 + bend_0*h + k*turn_0'], ['nu_u_dot_1',
 *     'nu_e_1 + bend_1*h + k*turn_1'], ['nu_u_dot_2', 'nu_e_2 + bend_2*h + k*turn_2']], 'cases':
 *     []}, {'name': 'drive', 'size': 3, 'unit': 'rad/s', 'doc': 'lambda nu_u', 'source': '',
 *     'is_scalar': False, 'holder': '', 'member': '', 'names': ['drive_0', 'drive_1', 'drive_2'],
 *     'lines': [['drive_0', 'nu_u_0*rate_gain'], ['drive_1', 'nu_u_1*rate_gain'], ['drive_2',
 *     'nu_u_2*rate_gain']], 'cases': []}, {'name': 's', 'size': 3, 'unit': 'rad/s', 'doc': 'sliding
 *     variable', 'source': 'eq. (SurfaceErr)', 'is_scalar': False, 'holder': '', 'member': '',
 *     'names': ['s_0', 's_1', 's_2'], 'lines': [['s_0', 'drive_0 + nu_e_0'], ['s_1', 'drive_1 +
 *     nu_e_1'], ['s_2', 'drive_2 + nu_e_2']], 'cases': []}, {'name': 'wanted', 'size': 3, 'unit':
 *     'rad/s^2', 'doc': 'acceleration asked for', 'source': '', 'is_scalar': False, 'holder': '',
 *     'member': '', 'names': ['wanted_0', 'wanted_1', 'wanted_2'], 'lines': [['wanted_0',
 *     'eta_dot_0 - nu_u_dot_0*rate_gain - reach_gain*s_0'], ['wanted_1', 'eta_dot_1 -
 *     nu_u_dot_1*rate_gain - reach_gain*s_1'], ['wanted_2', 'eta_dot_2 - nu_u_dot_2*rate_gain -
 *     reach_gain*s_2']], 'cases': []}, {'name': 'turning', 'size': 3, 'unit': 'rad/s', 'doc':
 *     'lambda nu_u - eta', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names':
 *     ['turning_0', 'turning_1', 'turning_2'], 'lines': [['turning_0', 'drive_0 - eta_0'],
 *     ['turning_1', 'drive_1 - eta_1'], ['turning_2', 'drive_2 - eta_2']], 'cases': []}, {'name':
 *     'momentum', 'size': 3, 'unit': 'N m s', 'doc': 'I nu', 'source': '', 'is_scalar': False,
 *     'holder': '', 'member': '', 'names': ['momentum_0', 'momentum_1', 'momentum_2'], 'lines':
 *     [['momentum_0', 'inertia_0*nu_0 + inertia_2*nu_2'], ['momentum_1', 'inertia_3*nu_1'],
 *     ['momentum_2', 'inertia_2*nu_0 + inertia_5*nu_2']], 'cases': []}, {'name': 'force', 'size':
 *     3, 'unit': 'N m', 'doc': 'control force, I f_u', 'source': 'eq. (TckCtrl)', 'is_scalar':
 *     False, 'holder': '', 'member': '', 'names': ['force_0', 'force_1', 'force_2'], 'lines':
 *     [['force_0', 'inertia_0*wanted_0 + inertia_2*wanted_2 + momentum_1*turning_2 -
 *     momentum_2*turning_1'], ['force_1', 'inertia_3*wanted_1 + momentum_2*turning_0 -
 *     momentum_0*turning_2'], ['force_2', 'inertia_2*wanted_0 + inertia_5*wanted_2 +
 *     momentum_0*turning_1 - momentum_1*turning_0']], 'cases': []}], 'outputs': [{'name': 'force',
 *     'size': 3, 'unit': 'N m', 'doc': 'control force', 'source': '', 'is_scalar': False, 'holder':
 *     'command', 'member': 'force', 'entries': ['force_0', 'force_1', 'force_2']}, {'name': 's',
 *     'size': 3, 'unit': 'rad/s', 'doc': 'sliding variable', 'source': '', 'is_scalar': False,
 *     'holder': 'command', 'member': 's', 'entries': ['s_0', 's_1', 's_2']}, {'name': 'nu_u',
 *     'size': 3, 'unit': 'rad', 'doc': 'kinematic law', 'source': '', 'is_scalar': False, 'holder':
 *     'command', 'member': 'nu_u', 'entries': ['nu_u_0', 'nu_u_1', 'nu_u_2']}, {'name': 'nu_u_dot',
 *     'size': 3, 'unit': 'rad/s', 'doc': 'its exact rate', 'source': '', 'is_scalar': False,
 *     'holder': 'command', 'member': 'nu_u_dot', 'entries': ['nu_u_dot_0', 'nu_u_dot_1',
 *     'nu_u_dot_2']}, {'name': 'clearance', 'size': 1, 'unit': '1', 'doc': 'distance from the cut
 *     locus of the law', 'source': '', 'is_scalar': True, 'holder': '', 'member': 'clearance',
 *     'entries': ['distance']}], 'operations': 185, 'temporaries': 63, 'symbol': 'tracking',
 *     'is_public': False, 'holders': ['params', 'state', 'reference'], 'arguments': ['nu', 'nu_r',
 *     'nu_r_dot', 'g_e'], 'has_reference': True, 'writes': ['command', 'clearance'],
 *     'public_writes': ['command', 'clearance']}, double precision.
 *
 * Generated by derive from the vehicle file quadrotor.toml; regenerate instead of editing.
 *
 * - Use: quadrotor_f64_check_params once at start-up, then quadrotor_f64_control at every instant.
 * - Units: SI; they stand in brackets beside each number.
 * - Frames: velocities and forces are in the body frame; the reference's in the reference's own.
 * - Configuration g: unit quaternion, Hamilton, scalar first.
 * - Pointers: never null; each to a whole struct, or to as many numbers as stand in the brackets,
 *   aligned as its type; what is written may not overlap what is read.
 * - Compiler: C99 with IEEE 754 numbers, rounded to nearest. Give gcc and clang
 *   -ffp-contract=off and -fno-math-errno, as the build files of the package do. The source
 *   refuses -ffast-math, -Ofast and -ffinite-math-only: control must see NaN and infinity.
 * - Needs: sqrt of libm; memcpy and memset, which compilers call of their own accord. No heap,
 *   no data that changes, no recursion, no pointer to a function: calls may interrupt each other.
 * - Evidence: beside the folder c, EVIDENCE.md has what was proved and measured, DEVIATIONS.md
 *   where the code departs from rules, trace.csv which lines are which equation.
 */
#ifndef QUADROTOR_F64_H
#define QUADROTOR_F64_H

#ifdef __cplusplus
extern "C" {
#endif

#define QUADROTOR_F64_MAX_INPUT 1.0e6 /**< largest magnitude of a number in state or reference */
#define QUADROTOR_F64_MAX_ENTRY 1.01 /**< of an entry of the error that the group keeps at 1 */
#define QUADROTOR_F64_MAX_REACH 4.0e6 /**< of any other entry of the error */
#define QUADROTOR_F64_MOST_DRIFT 0.1 /**< largest max_drift that may be asked for */
#define QUADROTOR_F64_NEAR_CUT 0.001 /**< clearance below which NEAR_CUT_LOCUS is flagged */
#define QUADROTOR_F64_REFUSED_CUT 1.0e-8 /**< clearance below which a law with a pole is refused */
#define QUADROTOR_F64_MAX_PARAM 1.0e9 /**< largest inertia entry, force limit, or other gain */
#define QUADROTOR_F64_MIN_GAIN 1.0e-9 /**< least gain */
#define QUADROTOR_F64_MAX_RATE 1.0e4 /**< largest gain in 1/s */

/** What was found. The largest that applies is returned; from 16 on the whole command is zero. */
typedef enum {
    QUADROTOR_F64_OK = 0, /**< the command is good */
    QUADROTOR_F64_SATURATED = 1, /**< a force limit was reached */
    QUADROTOR_F64_NEAR_CUT_LOCUS = 2, /**< the error is close to where the law jumps */
    QUADROTOR_F64_NOT_ON_GROUP = 16, /**< the error is off the group by more than max_drift */
    QUADROTOR_F64_OUT_OF_RANGE = 17, /**< beyond MAX_INPUT, or too near a pole of the law */
    QUADROTOR_F64_NONFINITE_INPUT = 18, /**< an input, or what it leads to, is not finite */
    QUADROTOR_F64_BAD_PARAMS = 19 /**< found by check_params */
} quadrotor_f64_status;

/** Inertia and gains, from the vehicle file or tuned on the target. */
typedef struct {
    double inertia[6]; /**< inertia, upper triangle, row by row [kg m^2] */
    double lambda; /**< sliding rate [1/s] */
    double k_s; /**< reaching rate [1/s] */
    double max_drift; /**< largest distance of the error from the group [1] */
} quadrotor_f64_params;

/** What is measured. */
typedef struct {
    double g[4]; /**< configuration: unit quaternion, Hamilton, scalar first [1] */
    double nu[3]; /**< body velocity [rad/s] */
} quadrotor_f64_state;

/** Where to be, and how that moves. */
typedef struct {
    double g[4]; /**< reference configuration: unit quaternion, Hamilton, scalar first [1] */
    double nu[3]; /**< reference velocity, reference body frame [rad/s] */
    double nu_dot[3]; /**< its rate [rad/s^2] */
} quadrotor_f64_reference;

/** What is to be done, and what it was made of. */
typedef struct {
    double force[3]; /**< control force [N m] */
    double s[3]; /**< sliding variable [rad/s] */
    double nu_u[3]; /**< kinematic law [rad] */
    double nu_u_dot[3]; /**< its exact rate [rad/s] */
} quadrotor_f64_command;

/** The vehicle file's inertia and gains. */
extern const quadrotor_f64_params quadrotor_f64_defaults;

/**
 * Judges the parameters, once at start-up.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @return OK; or BAD_PARAMS when one is not finite or out of range, the inertia not positive
 *     definite, or not zero where the derivation took that for granted
 */
quadrotor_f64_status quadrotor_f64_check_params(const quadrotor_f64_params *params);

/**
 * The guarded controller, for parameters that were checked. Whatever bits the other inputs are
 * made of, all of the command is written, and it is finite.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] reference where to be, and how that moves
 * @param[out] command what is to be done, and what it was made of
 * @return the largest status that applies
 */
quadrotor_f64_status quadrotor_f64_control(const quadrotor_f64_params *params,
        const quadrotor_f64_state *state, const quadrotor_f64_reference *reference,
        quadrotor_f64_command *command);

/**
 * Force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl).
 * Unguarded: presumes what control checks. Cost: 213 operations, 67 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] reference where to be, and how that moves
 * @param[out] command what is to be done, and what it was made of
 */
void quadrotor_f64_tracking(const quadrotor_f64_params *params, const quadrotor_f64_state *state,
        const quadrotor_f64_reference *reference, quadrotor_f64_command *command);

/**
 * Force that drives (g, nu) to (e, 0); eq. (Ctrl2).
 * Unguarded: presumes what control checks. Cost: 103 operations, 41 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[out] command what is to be done, and what it was made of
 */
void quadrotor_f64_reaching(const quadrotor_f64_params *params, const quadrotor_f64_state *state,
        quadrotor_f64_command *command);

/**
 * Acceleration under a force, Euler-Poincare; eq. (EulerP).
 * Unguarded: presumes what control checks. Cost: 30 operations, 12 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] force applied force [N m]
 * @param[out] nu_dot body acceleration [rad/s^2]
 */
void quadrotor_f64_plant(const quadrotor_f64_params *params, const quadrotor_f64_state *state,
        const double force[3], double nu_dot[3]);

#ifdef __cplusplus
}
#endif

#endif /* QUADROTOR_F64_H */
