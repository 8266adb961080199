/**
 * @file
 * @brief paper_s3_f32: gsmc on S3, law {'arguments': ['nu', 'nu_r', 'nu_r_dot', 'g_e'], 'doc':
 *     'force that drives (g, nu) to (g_r, nu_r)', 'has_reference': True, 'holders': ['params',
 *     'state', 'reference'], 'inputs': [{'argument': 'inertia', 'doc': 'inertia, upper triangle,
 *     row by row', 'entries': [['inertia_0', 0], ['inertia_1', 1], ['inertia_2', 2], ['inertia_3',
 *     3], ['inertia_4', 4], ['inertia_5', 5]], 'holder': 'params', 'is_scalar': False, 'member':
 *     'inertia', 'name': 'inertia', 'shape': [6], 'size': 6, 'source': '', 'unit': 'kg m^2'},
 *     {'argument': 'lambda_', 'doc': 'sliding rate', 'entries': [['rate_gain', 0]], 'holder':
 *     'params', 'is_scalar': True, 'member': 'lambda', 'name': 'rate_gain', 'shape': [1], 'size':
 *     1, 'source': '', 'unit': '1/s'}, {'argument': 'k_s', 'doc': 'reaching rate', 'entries':
 *     [['reach_gain', 0]], 'holder': 'params', 'is_scalar': True, 'member': 'k_s', 'name':
 *     'reach_gain', 'shape': [1], 'size': 1, 'source': '', 'unit': '1/s'}, {'argument': 'nu',
 *     'doc': 'body velocity', 'entries': [['nu_0', 0], ['nu_1', 1], ['nu_2', 2]], 'holder':
 *     'state', 'is_scalar': False, 'member': 'nu', 'name': 'nu', 'shape': [3], 'size': 3, 'source':
 *     '', 'unit': 'rad/s'}, {'argument': 'nu_r', 'doc': 'reference velocity, reference body frame',
 *     'entries': [['nu_r_0', 0], ['nu_r_1', 1], ['nu_r_2', 2]], 'holder': 'reference', 'is_scalar':
 *     False, 'member': 'nu', 'name': 'nu_r', 'shape': [3], 'size': 3, 'source': '', 'unit':
 *     'rad/s'}, {'argument': 'nu_r_dot', 'doc': 'its rate', 'entries': [['nu_r_dot_0', 0],
 *     ['nu_r_dot_1', 1], ['nu_r_dot_2', 2]], 'holder': 'reference', 'is_scalar': False, 'member':
 *     'nu_dot', 'name': 'nu_r_dot', 'shape': [3], 'size': 3, 'source': '', 'unit': 'rad/s^2'},
 *     {'argument': 'g_e', 'doc': 'error, g_r^-1 g', 'entries': [['g_e_0', 0], ['g_e_1', 1],
 *     ['g_e_2', 2], ['g_e_3', 3]], 'holder': '', 'is_scalar': False, 'member': 'g_e', 'name':
 *     'g_e', 'shape': [4], 'size': 4, 'source': 'eq. (velErr)', 'unit': '1'}], 'is_public': False,
 *     'name': 'tracking', 'operations': 206, 'outputs': [{'doc': 'control force', 'entries':
 *     ['force_0', 'force_1', 'force_2'], 'holder': 'command', 'is_scalar': False, 'member':
 *     'force', 'name': 'force', 'size': 3, 'source': '', 'unit': 'N m'}, {'doc': 'sliding
 *     variable', 'entries': ['s_0', 's_1', 's_2'], 'holder': 'command', 'is_scalar': False,
 *     'member': 's', 'name': 's', 'size': 3, 'source': '', 'unit': 'rad/s'}, {'doc': 'kinematic
 *     law', 'entries': ['nu_u_0', 'nu_u_1', 'nu_u_2'], 'holder': 'command', 'is_scalar': False,
 *     'member': 'nu_u', 'name': 'nu_u', 'size': 3, 'source': '', 'unit': 'rad'}, {'doc': 'its exact
 *     rate', 'entries': ['nu_u_dot_0', 'nu_u_dot_1', 'nu_u_dot_2'], 'holder': 'command',
 *     'is_scalar': False, 'member': 'nu_u_dot', 'name': 'nu_u_dot', 'size': 3, 'source': '',
 *     'unit': 'rad/s'}, {'doc': 'distance from the cut locus of the law', 'entries': ['distance'],
 *     'holder': '', 'is_scalar': True, 'member': 'clearance', 'name': 'clearance', 'size': 1,
 *     'source': '', 'unit': '1'}], 'public_writes': ['command', 'clearance'], 'source': 'eq.
 *     (TckCtrl)', 'steps': [{'cases': [], 'doc': 'Ad of g_e^-1: reference to body frame', 'holder':
 *     '', 'is_scalar': False, 'lines': [['to_body_0', '1.0F - 2.0F*g_e_2*g_e_2 -
 *     2.0F*g_e_3*g_e_3'], ['to_body_1', '2.0F*(g_e_0*g_e_3 + g_e_1*g_e_2)'], ['to_body_2',
 *     '2.0F*(g_e_1*g_e_3 - g_e_0*g_e_2)'], ['to_body_3', '2.0F*(g_e_1*g_e_2 - g_e_0*g_e_3)'],
 *     ['to_body_4', '1.0F - 2.0F*g_e_1*g_e_1 - 2.0F*g_e_3*g_e_3'], ['to_body_5', '2.0F*(g_e_0*g_e_1
 *     + g_e_2*g_e_3)'], ['to_body_6', '2.0F*(g_e_0*g_e_2 + g_e_1*g_e_3)'], ['to_body_7',
 *     '2.0F*(g_e_2*g_e_3 - g_e_0*g_e_1)'], ['to_body_8', '1.0F - 2.0F*g_e_1*g_e_1 -
 *     2.0F*g_e_2*g_e_2']], 'member': '', 'name': 'to_body', 'names': ['to_body_0', 'to_body_1',
 *     'to_body_2', 'to_body_3', 'to_body_4', 'to_body_5', 'to_body_6', 'to_body_7', 'to_body_8'],
 *     'size': 9, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'reference velocity in the body
 *     frame', 'holder': '', 'is_scalar': False, 'lines': [['eta_0', 'nu_r_0*to_body_0 +
 *     nu_r_1*to_body_1 + nu_r_2*to_body_2'], ['eta_1', 'nu_r_0*to_body_3 + nu_r_1*to_body_4 +
 *     nu_r_2*to_body_5'], ['eta_2', 'nu_r_0*to_body_6 + nu_r_1*to_body_7 + nu_r_2*to_body_8']],
 *     'member': '', 'name': 'eta', 'names': ['eta_0', 'eta_1', 'eta_2'], 'size': 3, 'source': 'eq.
 *     (velErr)', 'unit': 'rad/s'}, {'cases': [], 'doc': 'velocity error', 'holder': '',
 *     'is_scalar': False, 'lines': [['nu_e_0', 'nu_0 - eta_0'], ['nu_e_1', 'nu_1 - eta_1'],
 *     ['nu_e_2', 'nu_2 - eta_2']], 'member': '', 'name': 'nu_e', 'names': ['nu_e_0', 'nu_e_1',
 *     'nu_e_2'], 'size': 3, 'source': 'eq. (velErr)', 'unit': 'rad/s'}, {'cases': [], 'doc': 'exact
 *     rate of eta', 'holder': '', 'is_scalar': False, 'lines': [['eta_dot_0', 'eta_1*nu_e_2 +
 *     nu_r_dot_0*to_body_0 + nu_r_dot_1*to_body_1 + nu_r_dot_2*to_body_2 - eta_2*nu_e_1'],
 *     ['eta_dot_1', 'eta_2*nu_e_0 + nu_r_dot_0*to_body_3 + nu_r_dot_1*to_body_4 +
 *     nu_r_dot_2*to_body_5 - eta_0*nu_e_2'], ['eta_dot_2', 'eta_0*nu_e_1 + nu_r_dot_0*to_body_6 +
 *     nu_r_dot_1*to_body_7 + nu_r_dot_2*to_body_8 - eta_1*nu_e_0']], 'member': '', 'name':
 *     'eta_dot', 'names': ['eta_dot_0', 'eta_dot_1', 'eta_dot_2'], 'size': 3, 'source': '', 'unit':
 *     'rad/s^2'}, {'cases': [], 'doc': 'squared length', 'holder': '', 'is_scalar': True, 'lines':
 *     [['norm_square', 'g_e_0*g_e_0 + g_e_1*g_e_1 + g_e_2*g_e_2 + g_e_3*g_e_3']], 'member': '',
 *     'name': 'norm_square', 'names': ['norm_square'], 'size': 1, 'source': '', 'unit': '1'},
 *     {'cases': [{'condition': 'norm_square < 0.75F', 'lines': [['norm_bounded', '0.75F']]},
 *     {'condition': '', 'lines': [['norm_bounded', 'norm_square']]}], 'doc': 'the same: less is no
 *     element', 'holder': '', 'is_scalar': True, 'lines': [], 'member': '', 'name': 'norm_bounded',
 *     'names': ['norm_bounded'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc':
 *     'length', 'holder': '', 'is_scalar': True, 'lines': [['norm', 'sqrtf(norm_bounded)']],
 *     'member': '', 'name': 'norm', 'names': ['norm'], 'size': 1, 'source': '', 'unit': '1'},
 *     {'cases': [], 'doc': 'to unit length', 'holder': '', 'is_scalar': True, 'lines': [['scale',
 *     '1.0F/norm']], 'member': '', 'name': 'scale', 'names': ['scale'], 'size': 1, 'source': '',
 *     'unit': '1'}, {'cases': [], 'doc': 'cos of half the error angle', 'holder': '', 'is_scalar':
 *     True, 'lines': [['w', 'g_e_0*scale']], 'member': '', 'name': 'w', 'names': ['w'], 'size': 1,
 *     'source': '', 'unit': '1'}, {'cases': [], 'doc': 'sin of half the error angle times its
 *     axis', 'holder': '', 'is_scalar': False, 'lines': [['v_0', 'g_e_1*scale'], ['v_1',
 *     'g_e_2*scale'], ['v_2', 'g_e_3*scale']], 'member': '', 'name': 'v', 'names': ['v_0', 'v_1',
 *     'v_2'], 'size': 3, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'half angle over its
 *     sine, for |w|', 'holder': '', 'is_scalar': True, 'lines': [['k_near',
 *     'paper_s3_f32_k(fabsf(w))']], 'member': '', 'name': 'k_near', 'names': ['k_near'], 'size': 1,
 *     'source': '', 'unit': '1'}, {'cases': [], 'doc': 'v.v', 'holder': '', 'is_scalar': True,
 *     'lines': [['sine_square', 'v_0*v_0 + v_1*v_1 + v_2*v_2']], 'member': '', 'name':
 *     'sine_square', 'names': ['sine_square'], 'size': 1, 'source': '', 'unit': '1'}, {'cases':
 *     [{'condition': 'sine_square < (5.0e-8F*5.0e-8F)', 'lines': [['sine_bounded',
 *     '5.0e-8F*5.0e-8F']]}, {'condition': '', 'lines': [['sine_bounded', 'sine_square']]}], 'doc':
 *     'the same, away from -i and i', 'holder': '', 'is_scalar': True, 'lines': [], 'member': '',
 *     'name': 'sine_bounded', 'names': ['sine_bounded'], 'size': 1, 'source': '', 'unit': '1'},
 *     {'cases': [], 'doc': '|v|', 'holder': '', 'is_scalar': True, 'lines': [['sine',
 *     'sqrtf(sine_bounded)']], 'member': '', 'name': 'sine', 'names': ['sine'], 'size': 1,
 *     'source': '', 'unit': '1'}, {'cases': [{'condition': 'w >= 0.0F', 'lines': [['k',
 *     'k_near']]}, {'condition': '', 'lines': [['k', '3.1415927F/sine - k_near']]}], 'doc': 'half
 *     angle over its sine, on to 2 pi', 'holder': '', 'is_scalar': True, 'lines': [], 'member': '',
 *     'name': 'k', 'names': ['k'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc':
 *     '-dk/dw, as (1 - w k)/s^2', 'holder': '', 'is_scalar': True, 'lines': [['h', '(1.0F -
 *     k*w)/sine_bounded']], 'member': '', 'name': 'h', 'names': ['h'], 'size': 1, 'source': '',
 *     'unit': '1'}, {'cases': [{'condition': 'w < 0.0F', 'lines': [['distance', 'sine']]},
 *     {'condition': '', 'lines': [['distance', '1.0F']]}], 'doc': 'distance from -i', 'holder': '',
 *     'is_scalar': True, 'lines': [], 'member': '', 'name': 'distance', 'names': ['distance'],
 *     'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'half of nu_u over v', 'holder':
 *     '', 'is_scalar': True, 'lines': [['p', '0.5F*k']], 'member': '', 'name': 'p', 'names': ['p'],
 *     'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': '-dp/dw', 'holder': '',
 *     'is_scalar': True, 'lines': [['drop', '0.5F*h']], 'member': '', 'name': 'drop', 'names':
 *     ['drop'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'kinematic law, half
 *     the rotation vector', 'holder': '', 'is_scalar': False, 'lines': [['nu_u_0', '2.0F*p*v_0'],
 *     ['nu_u_1', '2.0F*p*v_1'], ['nu_u_2', '2.0F*p*v_2']], 'member': '', 'name': 'nu_u', 'names':
 *     ['nu_u_0', 'nu_u_1', 'nu_u_2'], 'size': 3, 'source': 'eq. (KinCtrlLawS3)', 'unit': 'rad'},
 *     {'cases': [], 'doc': 'v x nu_e', 'holder': '', 'is_scalar': False, 'lines': [['turn_0',
 *     'nu_e_2*v_1 - nu_e_1*v_2'], ['turn_1', 'nu_e_0*v_2 - nu_e_2*v_0'], ['turn_2', 'nu_e_1*v_0 -
 *     nu_e_0*v_1']], 'member': '', 'name': 'turn', 'names': ['turn_0', 'turn_1', 'turn_2'], 'size':
 *     3, 'source': '', 'unit': 'rad/s'}, {'cases': [], 'doc': 'v x (v x nu_e)', 'holder': '',
 *     'is_scalar': False, 'lines': [['bend_0', 'turn_2*v_1 - turn_1*v_2'], ['bend_1', 'turn_0*v_2 -
 *     turn_2*v_0'], ['bend_2', 'turn_1*v_0 - turn_0*v_1']], 'member': '', 'name': 'bend', 'names':
 *     ['bend_0', 'bend_1', 'bend_2'], 'size': 3, 'source': '', 'unit': 'rad/s'}, {'cases': [],
 *     'doc': 'exact rate of nu_u', 'holder': '', 'is_scalar': False, 'lines': [['nu_u_dot_0',
 *     '0.5F*nu_e_0 + bend_0*drop + p*turn_0'], ['nu_u_dot_1', '0.5F*nu_e_1 + bend_1*drop +
 *     p*turn_1'], ['nu_u_dot_2', '0.5F*nu_e_2 + bend_2*drop + p*turn_2']], 'member': '', 'name':
 *     'nu_u_dot', 'names': ['nu_u_dot_0', 'nu_u_dot_1', 'nu_u_dot_2'], 'size': 3, 'source': '',
 *     'unit': 'rad/s'}, {'cases': [], 'doc': 'lambda nu_u', 'holder': '', 'is_scalar': False,
 *     'lines': [['drive_0', 'nu_u_0*rate_gain'], ['drive_1', 'nu_u_1*rate_gain'], ['drive_2',
 *     'nu_u_2*rate_gain']], 'member': '', 'name': 'drive', 'names': ['drive_0', 'drive_1',
 *     'drive_2'], 'size': 3, 'source': '', 'unit': 'rad/s'}, {'cases': [], 'doc': 'sliding
 *     variable', 'holder': '', 'is_scalar': False, 'lines': [['s_0', 'drive_0 + nu_e_0'], ['s_1',
 *     'drive_1 + nu_e_1'], ['s_2', 'drive_2 + nu_e_2']], 'member': '', 'name': 's', 'names':
 *     ['s_0', 's_1', 's_2'], 'size': 3, 'source': 'eq. (SurfaceErr)', 'unit': 'rad/s'}, {'cases':
 *     [], 'doc': 'acceleration asked for', 'holder': '', 'is_scalar': False, 'lines': [['wanted_0',
 *     'eta_dot_0 - nu_u_dot_0*rate_gain - reach_gain*s_0'], ['wanted_1', 'eta_dot_1 -
 *     nu_u_dot_1*rate_gain - reach_gain*s_1'], ['wanted_2', 'eta_dot_2 - nu_u_dot_2*rate_gain -
 *     reach_gain*s_2']], 'member': '', 'name': 'wanted', 'names': ['wanted_0', 'wanted_1',
 *     'wanted_2'], 'size': 3, 'source': '', 'unit': 'rad/s^2'}, {'cases': [], 'doc': 'lambda nu_u -
 *     eta', 'holder': '', 'is_scalar': False, 'lines': [['turning_0', 'drive_0 - eta_0'],
 *     ['turning_1', 'drive_1 - eta_1'], ['turning_2', 'drive_2 - eta_2']], 'member': '', 'name':
 *     'turning', 'names': ['turning_0', 'turning_1', 'turning_2'], 'size': 3, 'source': '', 'unit':
 *     'rad/s'}, {'cases': [], 'doc': 'I nu', 'holder': '', 'is_scalar': False, 'lines':
 *     [['momentum_0', 'inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2'], ['momentum_1',
 *     'inertia_1*nu_0 + inertia_3*nu_1 + inertia_4*nu_2'], ['momentum_2', 'inertia_2*nu_0 +
 *     inertia_4*nu_1 + inertia_5*nu_2']], 'member': '', 'name': 'momentum', 'names': ['momentum_0',
 *     'momentum_1', 'momentum_2'], 'size': 3, 'source': '', 'unit': 'N m s'}, {'cases': [], 'doc':
 *     'control force, I f_u', 'holder': '', 'is_scalar': False, 'lines': [['force_0',
 *     'inertia_0*wanted_0 + inertia_1*wanted_1 + inertia_2*wanted_2 + momentum_1*turning_2 -
 *     momentum_2*turning_1'], ['force_1', 'inertia_1*wanted_0 + inertia_3*wanted_1 +
 *     inertia_4*wanted_2 + momentum_2*turning_0 - momentum_0*turning_2'], ['force_2',
 *     'inertia_2*wanted_0 + inertia_4*wanted_1 + inertia_5*wanted_2 + momentum_0*turning_1 -
 *     momentum_1*turning_0']], 'member': '', 'name': 'force', 'names': ['force_0', 'force_1',
 *     'force_2'], 'size': 3, 'source': 'eq. (TckCtrl)', 'unit': 'N m'}], 'symbol': 'tracking',
 *     'temporaries': 65, 'writes': ['command', 'clearance']}, float precision.
 *
 * Generated by derive from the vehicle file paper_s3.toml; regenerate instead of editing.
 *
 * - Use: paper_s3_f32_check_params once at start-up, then paper_s3_f32_control at every instant.
 * - Units: SI; they stand in brackets beside each number.
 * - Frames: velocities and forces are in the body frame; the reference's in the reference's own.
 * - Configuration g: unit quaternion, Hamilton, scalar first.
 * - Pointers: never null; each to a whole struct, or to as many numbers as stand in the brackets,
 *   aligned as its type; what is written may not overlap what is read.
 * - Compiler: C99 with IEEE 754 numbers, rounded to nearest. Give gcc and clang
 *   -ffp-contract=off and -fno-math-errno, as the build files of the package do. The source
 *   refuses -ffast-math, -Ofast and -ffinite-math-only: control must see NaN and infinity.
 * - Needs: sqrtf of libm; memcpy and memset, which compilers call of their own accord. No heap,
 *   no data that changes, no recursion, no pointer to a function: calls may interrupt each other.
 * - Evidence: beside the folder c, EVIDENCE.md has what was proved and measured, DEVIATIONS.md
 *   where the code departs from rules, trace.csv which lines are which equation.
 */
#ifndef PAPER_S3_F32_H
#define PAPER_S3_F32_H

#ifdef __cplusplus
extern "C" {
#endif

#define PAPER_S3_F32_MAX_INPUT 1.0e6F /**< largest magnitude of a number in state or reference */
#define PAPER_S3_F32_MAX_ENTRY 1.01F /**< of an entry of the error that the group keeps at 1 */
#define PAPER_S3_F32_MAX_REACH 4.0e6F /**< of any other entry of the error */
#define PAPER_S3_F32_MOST_DRIFT 0.1F /**< largest max_drift that may be asked for */
#define PAPER_S3_F32_NEAR_CUT 0.001F /**< clearance below which NEAR_CUT_LOCUS is flagged */
#define PAPER_S3_F32_REFUSED_CUT 1.0e-5F /**< clearance below which a law with a pole is refused */
#define PAPER_S3_F32_MAX_PARAM 1.0e9F /**< largest inertia entry, force limit, or other gain */
#define PAPER_S3_F32_MIN_GAIN 1.0e-9F /**< least gain */
#define PAPER_S3_F32_MAX_RATE 1.0e4F /**< largest gain in 1/s */

/** What was found. The largest that applies is returned; from 16 on the whole command is zero. */
typedef enum {
    PAPER_S3_F32_OK = 0, /**< the command is good */
    PAPER_S3_F32_SATURATED = 1, /**< a force limit was reached */
    PAPER_S3_F32_NEAR_CUT_LOCUS = 2, /**< the error is close to where the law jumps */
    PAPER_S3_F32_NOT_ON_GROUP = 16, /**< the error is off the group by more than max_drift */
    PAPER_S3_F32_OUT_OF_RANGE = 17, /**< beyond MAX_INPUT, or too near a pole of the law */
    PAPER_S3_F32_NONFINITE_INPUT = 18, /**< an input, or what it leads to, is not finite */
    PAPER_S3_F32_BAD_PARAMS = 19 /**< found by check_params */
} paper_s3_f32_status;

/** Inertia and gains, from the vehicle file or tuned on the target. */
typedef struct {
    float inertia[6]; /**< inertia, upper triangle, row by row [kg m^2] */
    float lambda; /**< sliding rate [1/s] */
    float k_s; /**< reaching rate [1/s] */
    float max_drift; /**< largest distance of the error from the group [1] */
} paper_s3_f32_params;

/** What is measured. */
typedef struct {
    float g[4]; /**< configuration: unit quaternion, Hamilton, scalar first [1] */
    float nu[3]; /**< body velocity [rad/s] */
} paper_s3_f32_state;

/** Where to be, and how that moves. */
typedef struct {
    float g[4]; /**< reference configuration: unit quaternion, Hamilton, scalar first [1] */
    float nu[3]; /**< reference velocity, reference body frame [rad/s] */
    float nu_dot[3]; /**< its rate [rad/s^2] */
} paper_s3_f32_reference;

/** What is to be done, and what it was made of. */
typedef struct {
    float force[3]; /**< control force [N m] */
    float s[3]; /**< sliding variable [rad/s] */
    float nu_u[3]; /**< kinematic law [rad] */
    float nu_u_dot[3]; /**< its exact rate [rad/s] */
} paper_s3_f32_command;

/** The vehicle file's inertia and gains. */
extern const paper_s3_f32_params paper_s3_f32_defaults;

/**
 * Judges the parameters, once at start-up.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @return OK; or BAD_PARAMS when one is not finite or out of range, the inertia not positive
 *     definite, or not zero where the derivation took that for granted
 */
paper_s3_f32_status paper_s3_f32_check_params(const paper_s3_f32_params *params);

/**
 * The guarded controller, for parameters that were checked. Whatever bits the other inputs are
 * made of, all of the command is written, and it is finite.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] reference where to be, and how that moves
 * @param[out] command what is to be done, and what it was made of
 * @return the largest status that applies
 */
paper_s3_f32_status paper_s3_f32_control(const paper_s3_f32_params *params,
        const paper_s3_f32_state *state, const paper_s3_f32_reference *reference,
        paper_s3_f32_command *command);

/**
 * Force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl).
 * Unguarded: presumes what control checks. Cost: 234 operations, 69 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] reference where to be, and how that moves
 * @param[out] command what is to be done, and what it was made of
 */
void paper_s3_f32_tracking(const paper_s3_f32_params *params, const paper_s3_f32_state *state,
        const paper_s3_f32_reference *reference, paper_s3_f32_command *command);

/**
 * Force that drives (g, nu) to (e, 0); eq. (Ctrl2).
 * Unguarded: presumes what control checks. Cost: 124 operations, 43 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[out] command what is to be done, and what it was made of
 */
void paper_s3_f32_reaching(const paper_s3_f32_params *params, const paper_s3_f32_state *state,
        paper_s3_f32_command *command);

/**
 * Acceleration under a force, Euler-Poincare; eq. (EulerP).
 * Unguarded: presumes what control checks. Cost: 57 operations, 16 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] force applied force [N m]
 * @param[out] nu_dot body acceleration [rad/s^2]
 */
void paper_s3_f32_plant(const paper_s3_f32_params *params, const paper_s3_f32_state *state,
        const float force[3], float nu_dot[3]);

#ifdef __cplusplus
}
#endif

#endif /* PAPER_S3_F32_H */
