/**
 * @file
 * @brief hovercraft_f32: gsmc on SE2, law {'name': 'tracking', 'doc': 'force that drives (g, nu) to
 *     (g_r, nu_r)', 'source': 'eq. (TckCtrl)', 'inputs': [{'name': 'inertia', 'size': 6, 'unit':
 *     'kg m^2, kg m, kg', 'doc': 'inertia, upper triangle, row by row', 'source': '', 'is_scalar':
 *     False, 'holder': 'params', 'member': 'inertia', 'entries': [['inertia_0', 0], ['inertia_2',
 *     2], ['inertia_3', 3], ['inertia_5', 5]], 'argument': 'inertia', 'shape': (6,)}, {'name':
 *     'rate_gain', 'size': 1, 'unit': '1/s', 'doc': 'sliding rate', 'source': '', 'is_scalar':
 *     True, 'holder': 'params', 'member': 'lambda', 'entries': [['rate_gain', 0]], 'argument':
 *     'lambda_', 'shape': (1,)}, {'name': 'reach_gain', 'size': 1, 'unit': '1/s', 'doc': 'reaching
 *     rate', 'source': '', 'is_scalar': True, 'holder': 'params', 'member': 'k_s', 'entries':
 *     [['reach_gain', 0]], 'argument': 'k_s', 'shape': (1,)}, {'name': 'nu', 'size': 3, 'unit':
 *     'rad/s, m/s', 'doc': 'body velocity', 'source': '', 'is_scalar': False, 'holder': 'state',
 *     'member': 'nu', 'entries': [['nu_0', 0], ['nu_1', 1], ['nu_2', 2]], 'argument': 'nu',
 *     'shape': (3,)}, {'name': 'nu_r', 'size': 3, 'unit': 'rad/s, m/s', 'doc': 'reference velocity,
 *     reference body frame', 'source': '', 'is_scalar': False, 'holder': 'reference', 'member':
 *     'nu', 'entries': [['nu_r_0', 0], ['nu_r_1', 1], ['nu_r_2', 2]], 'argument': 'nu_r', 'shape':
 *     (3,)}, {'name': 'nu_r_dot', 'size': 3, 'unit': 'rad/s^2, m/s^2', 'doc': 'its rate', 'source':
 *     '', 'is_scalar': False, 'holder': 'reference', 'member': 'nu_dot', 'entries': [['nu_r_dot_0',
 *     0], ['nu_r_dot_1', 1], ['nu_r_dot_2', 2]], 'argument': 'nu_r_dot', 'shape': (3,)}, {'name':
 *     'g_e', 'size': 9, 'unit': '1', 'doc': 'error, g_r^-1 g', 'source': 'eq. (velErr)',
 *     'is_scalar': False, 'holder': '', 'member': 'g_e', 'entries': [['g_e_0', 0], ['g_e_1', 1],
 *     ['g_e_2', 2], ['g_e_3', 3], ['g_e_4', 4], ['g_e_5', 5]], 'argument': 'g_e', 'shape': (9,)}],
 *     'steps': [{'name': 'eta_arm_0', 'size': 2, 'unit': 'm/s', 'doc': 'velocity at p', 'source':
 *     '', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['eta_arm_0_0', 'eta_arm_0_1'],
 *     'lines': [['eta_arm_0_0', 'nu_r_1 - g_e_5*nu_r_0'], ['eta_arm_0_1', 'nu_r_2 +
 *     g_e_2*nu_r_0']], 'cases': []}, {'name': 'eta', 'size': 3, 'unit': 'rad/s, m/s', 'doc':
 *     'reference velocity in the body frame', 'source': 'eq. (velErr)', 'is_scalar': False,
 *     'holder': '', 'member': '', 'names': ['eta_1', 'eta_2'], 'lines': [['eta_1',
 *     'eta_arm_0_0*g_e_0 + eta_arm_0_1*g_e_3'], ['eta_2', 'eta_arm_0_0*g_e_1 +
 *     eta_arm_0_1*g_e_4']], 'cases': []}, {'name': 'nu_e', 'size': 3, 'unit': 'rad/s, m/s', 'doc':
 *     'velocity error', 'source': 'eq. (velErr)', 'is_scalar': False, 'holder': '', 'member': '',
 *     'names': ['nu_e_0', 'nu_e_1', 'nu_e_2'], 'lines': [['nu_e_0', 'nu_0 - nu_r_0'], ['nu_e_1',
 *     'nu_1 - eta_1'], ['nu_e_2', 'nu_2 - eta_2']], 'cases': []}, {'name': 'eta_dot_arm_0', 'size':
 *     2, 'unit': 'm/s', 'doc': 'velocity at p', 'source': '', 'is_scalar': False, 'holder': '',
 *     'member': '', 'names': ['eta_dot_arm_0_0', 'eta_dot_arm_0_1'], 'lines': [['eta_dot_arm_0_0',
 *     'nu_r_dot_1 - g_e_5*nu_r_dot_0'], ['eta_dot_arm_0_1', 'nu_r_dot_2 + g_e_2*nu_r_dot_0']],
 *     'cases': []}, {'name': 'eta_dot', 'size': 3, 'unit': 'rad/s^2, m/s^2', 'doc': 'exact rate of
 *     eta', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['eta_dot_1',
 *     'eta_dot_2'], 'lines': [['eta_dot_1', 'eta_2*nu_e_0 + eta_dot_arm_0_0*g_e_0 +
 *     eta_dot_arm_0_1*g_e_3 - nu_e_2*nu_r_0'], ['eta_dot_2', 'eta_dot_arm_0_0*g_e_1 +
 *     eta_dot_arm_0_1*g_e_4 + nu_e_1*nu_r_0 - eta_1*nu_e_0']], 'cases': []}, {'name': 'twice',
 *     'size': 2, 'unit': '1', 'doc': '2 cos and 2 sin of the angle', 'source': '', 'is_scalar':
 *     False, 'holder': '', 'member': '', 'names': ['twice_0', 'twice_1'], 'lines': [['twice_0',
 *     'g_e_0 + g_e_4'], ['twice_1', 'g_e_3 - g_e_1']], 'cases': []}, {'name': 'norm_square',
 *     'size': 1, 'unit': '1', 'doc': 'their squared length', 'source': '', 'is_scalar': True,
 *     'holder': '', 'member': '', 'names': ['norm_square'], 'lines': [['norm_square',
 *     'twice_0*twice_0 + twice_1*twice_1']], 'cases': []}, {'name': 'norm_bounded', 'size': 1,
 *     'unit': '1', 'doc': 'the same: less is no turn', 'source': '', 'is_scalar': True, 'holder':
 *     '', 'member': '', 'names': ['norm_bounded'], 'lines': [], 'cases': [{'condition':
 *     'norm_square < 3.0F', 'lines': [['norm_bounded', '3.0F']]}, {'condition': '', 'lines':
 *     [['norm_bounded', 'norm_square']]}]}, {'name': 'norm', 'size': 1, 'unit': '1', 'doc': 'their
 *     length', 'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['norm'],
 *     'lines': [['norm', 'sqrtf(norm_bounded)']], 'cases': []}, {'name': 'column', 'size': 2,
 *     'unit': '1', 'doc': 'cos >= 0 and sin of half the angle, unscaled', 'source': '',
 *     'is_scalar': False, 'holder': '', 'member': '', 'names': ['column_0', 'column_1'], 'lines':
 *     [], 'cases': [{'condition': 'twice_0 >= 0.0F', 'lines': [['column_0', 'norm + twice_0'],
 *     ['column_1', 'twice_1']]}, {'condition': 'twice_1 >= 0.0F', 'lines': [['column_0',
 *     'twice_1'], ['column_1', 'norm - twice_0']]}, {'condition': '', 'lines': [['column_0',
 *     '-twice_1'], ['column_1', 'twice_0 - norm']]}]}, {'name': 'column_square', 'size': 1, 'unit':
 *     '1', 'doc': 'squared length', 'source': '', 'is_scalar': True, 'holder': '', 'member': '',
 *     'names': ['column_square'], 'lines': [['column_square', 'column_0*column_0 +
 *     column_1*column_1']], 'cases': []}, {'name': 'column_bounded', 'size': 1, 'unit': '1', 'doc':
 *     'the same', 'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names':
 *     ['column_bounded'], 'lines': [], 'cases': [{'condition': 'column_square < 3.0F', 'lines':
 *     [['column_bounded', '3.0F']]}, {'condition': '', 'lines': [['column_bounded',
 *     'column_square']]}]}, {'name': 'scale', 'size': 1, 'unit': '1', 'doc': 'to unit length',
 *     'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['scale'], 'lines':
 *     [['scale', '1.0F/sqrtf(column_bounded)']], 'cases': []}, {'name': 'cosine', 'size': 1,
 *     'unit': '1', 'doc': 'cos of half the error angle, rounded', 'source': '', 'is_scalar': True,
 *     'holder': '', 'member': '', 'names': ['cosine'], 'lines': [['cosine', 'column_0*scale']],
 *     'cases': []}, {'name': 'w', 'size': 1, 'unit': '1', 'doc': 'cos of half the error angle',
 *     'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['w'], 'lines': [],
 *     'cases': [{'condition': 'cosine > 1.0F', 'lines': [['w', '1.0F']]}, {'condition': '',
 *     'lines': [['w', 'cosine']]}]}, {'name': 'sine', 'size': 1, 'unit': '1', 'doc': 'sin of half
 *     the error angle', 'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names':
 *     ['sine'], 'lines': [['sine', 'column_1*scale']], 'cases': []}, {'name': 'k', 'size': 1,
 *     'unit': '1', 'doc': 'half angle over its sine', 'source': '', 'is_scalar': True, 'holder':
 *     '', 'member': '', 'names': ['k'], 'lines': [['k', 'hovercraft_f32_k(w)']], 'cases': []},
 *     {'name': 'h', 'size': 1, 'unit': '1', 'doc': '-dk/dw', 'source': '', 'is_scalar': True,
 *     'holder': '', 'member': '', 'names': ['h'], 'lines': [['h', 'hovercraft_f32_h(w)']], 'cases':
 *     []}, {'name': 'phi', 'size': 1, 'unit': 'rad', 'doc': 'rotation vector of the error',
 *     'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['phi_0'], 'lines':
 *     [['phi_0', '2.0F*k*sine']], 'cases': []}, {'name': 'half', 'size': 1, 'unit': '1', 'doc':
 *     '1/(2 k)', 'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['half'],
 *     'lines': [['half', '0.5F/k']], 'cases': []}, {'name': 'turned_p', 'size': 2, 'unit': 'm',
 *     'doc': 'p turned back by half the angle', 'source': '', 'is_scalar': False, 'holder': '',
 *     'member': '', 'names': ['turned_p_0', 'turned_p_1'], 'lines': [['turned_p_0', 'g_e_2*w +
 *     g_e_5*sine'], ['turned_p_1', 'g_e_5*w - g_e_2*sine']], 'cases': []}, {'name': 'rho_p',
 *     'size': 2, 'unit': 'm', 'doc': 'p - k Y p + h Y Y p', 'source': '', 'is_scalar': False,
 *     'holder': '', 'member': '', 'names': ['rho_p_0', 'rho_p_1'], 'lines': [['rho_p_0',
 *     'k*turned_p_0'], ['rho_p_1', 'k*turned_p_1']], 'cases': []}, {'name': 'y_p', 'size': 2,
 *     'unit': 'm', 'doc': 'rho/(2 k)', 'source': '', 'is_scalar': False, 'holder': '', 'member':
 *     '', 'names': ['y_p_0', 'y_p_1'], 'lines': [['y_p_0', 'half*rho_p_0'], ['y_p_1',
 *     'half*rho_p_1']], 'cases': []}, {'name': 'turn', 'size': 3, 'unit': 'rad/s, m/s', 'doc': 'Y
 *     nu_e, Y = ad of y', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names':
 *     ['turn_1', 'turn_2'], 'lines': [['turn_1', 'nu_e_0*y_p_1 - nu_e_2*sine'], ['turn_2',
 *     'nu_e_1*sine - nu_e_0*y_p_0']], 'cases': []}, {'name': 'bend', 'size': 3, 'unit': 'rad/s,
 *     m/s', 'doc': 'Y Y nu_e', 'source': '', 'is_scalar': False, 'holder': '', 'member': '',
 *     'names': ['bend_1', 'bend_2'], 'lines': [['bend_1', '-sine*turn_2'], ['bend_2',
 *     'sine*turn_1']], 'cases': []}, {'name': 'nu_u_dot', 'size': 3, 'unit': 'rad/s, m/s', 'doc':
 *     'exact rate of nu_u', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names':
 *     ['nu_u_dot_1', 'nu_u_dot_2'], 'lines': [['nu_u_dot_1', 'nu_e_1 + bend_1*h + k*turn_1'],
 *     ['nu_u_dot_2', 'nu_e_2 + bend_2*h + k*turn_2']], 'cases': []}, {'name': 'drive', 'size': 3,
 *     'unit': 'rad/s, m/s', 'doc': 'lambda nu_u', 'source': '', 'is_scalar': False, 'holder': '',
 *     'member': '', 'names': ['drive_0', 'drive_1', 'drive_2'], 'lines': [['drive_0',
 *     'phi_0*rate_gain'], ['drive_1', 'rate_gain*rho_p_0'], ['drive_2', 'rate_gain*rho_p_1']],
 *     'cases': []}, {'name': 's', 'size': 3, 'unit': 'rad/s, m/s', 'doc': 'sliding variable',
 *     'source': 'eq. (SurfaceErr)', 'is_scalar': False, 'holder': '', 'member': '', 'names':
 *     ['s_0', 's_1', 's_2'], 'lines': [['s_0', 'drive_0 + nu_e_0'], ['s_1', 'drive_1 + nu_e_1'],
 *     ['s_2', 'drive_2 + nu_e_2']], 'cases': []}, {'name': 'wanted', 'size': 3, 'unit': 'rad/s^2,
 *     m/s^2', 'doc': 'acceleration asked for', 'source': '', 'is_scalar': False, 'holder': '',
 *     'member': '', 'names': ['wanted_0', 'wanted_1', 'wanted_2'], 'lines': [['wanted_0',
 *     'nu_r_dot_0 - nu_e_0*rate_gain - reach_gain*s_0'], ['wanted_1', 'eta_dot_1 -
 *     nu_u_dot_1*rate_gain - reach_gain*s_1'], ['wanted_2', 'eta_dot_2 - nu_u_dot_2*rate_gain -
 *     reach_gain*s_2']], 'cases': []}, {'name': 'turning', 'size': 3, 'unit': 'rad/s, m/s', 'doc':
 *     'lambda nu_u - eta', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names':
 *     ['turning_0', 'turning_1', 'turning_2'], 'lines': [['turning_0', 'drive_0 - nu_r_0'],
 *     ['turning_1', 'drive_1 - eta_1'], ['turning_2', 'drive_2 - eta_2']], 'cases': []}, {'name':
 *     'momentum', 'size': 3, 'unit': 'N m s, N s', 'doc': 'I nu', 'source': '', 'is_scalar': False,
 *     'holder': '', 'member': '', 'names': ['momentum_1', 'momentum_2'], 'lines': [['momentum_1',
 *     'inertia_3*nu_1'], ['momentum_2', 'inertia_2*nu_0 + inertia_5*nu_2']], 'cases': []}, {'name':
 *     'force', 'size': 3, 'unit': 'N m, N', 'doc': 'control force, I f_u', 'source': 'eq.
 *     (TckCtrl)', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['force_0', 'force_1',
 *     'force_2'], 'lines': [['force_0', 'inertia_0*wanted_0 + inertia_2*wanted_2 +
 *     momentum_1*turning_2 - momentum_2*turning_1'], ['force_1', 'inertia_3*wanted_1 +
 *     momentum_2*turning_0'], ['force_2', 'inertia_2*wanted_0 + inertia_5*wanted_2 -
 *     momentum_1*turning_0']], 'cases': []}], 'outputs': [{'name': 'force', 'size': 3, 'unit': 'N
 *     m, N', 'doc': 'control force', 'source': '', 'is_scalar': False, 'holder': 'command',
 *     'member': 'force', 'entries': ['force_0', 'force_1', 'force_2']}, {'name': 's', 'size': 3,
 *     'unit': 'rad/s, m/s', 'doc': 'sliding variable', 'source': '', 'is_scalar': False, 'holder':
 *     'command', 'member': 's', 'entries': ['s_0', 's_1', 's_2']}, {'name': 'nu_u', 'size': 3,
 *     'unit': 'rad, m', 'doc': 'kinematic law', 'source': '', 'is_scalar': False, 'holder':
 *     'command', 'member': 'nu_u', 'entries': ['phi_0', 'rho_p_0', 'rho_p_1']}, {'name':
 *     'nu_u_dot', 'size': 3, 'unit': 'rad/s, m/s', 'doc': 'its exact rate', 'source': '',
 *     'is_scalar': False, 'holder': 'command', 'member': 'nu_u_dot', 'entries': ['nu_e_0',
 *     'nu_u_dot_1', 'nu_u_dot_2']}, {'name': 'clearance', 'size': 1, 'unit': '1', 'doc': 'distance
 *     from the cut locus of the law', 'source': '', 'is_scalar': True, 'holder': '', 'member':
 *     'clearance', 'entries': ['w']}], 'operations': 118, 'temporaries': 57, 'symbol': 'tracking',
 *     'is_public': False, 'holders': ['params', 'state', 'reference'], 'arguments': ['nu', 'nu_r',
 *     'nu_r_dot', 'g_e'], 'has_reference': True, 'writes': ['command', 'clearance'],
 *     'public_writes': ['command', 'clearance']}, float precision.
 *
 * Generated by derive from the vehicle file hovercraft.toml; regenerate instead of editing.
 *
 * - Use: hovercraft_f32_check_params once at start-up, then hovercraft_f32_control at every
 *   instant.
 * - Units: SI; they stand in brackets beside each number.
 * - Frames: velocities and forces are in the body frame; the reference's in the reference's own.
 * - Configuration g: matrix of 3 rows, row by row.
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
#ifndef HOVERCRAFT_F32_H
#define HOVERCRAFT_F32_H

#ifdef __cplusplus
extern "C" {
#endif

#define HOVERCRAFT_F32_MAX_INPUT 1.0e6F /**< largest magnitude of a number in state or reference */
#define HOVERCRAFT_F32_MAX_ENTRY 1.01F /**< of an entry of the error that the group keeps at 1 */
#define HOVERCRAFT_F32_MAX_REACH 4.0e6F /**< of any other entry of the error */
#define HOVERCRAFT_F32_MOST_DRIFT 0.1F /**< largest max_drift that may be asked for */
#define HOVERCRAFT_F32_NEAR_CUT 0.001F /**< clearance below which NEAR_CUT_LOCUS is flagged */
#define HOVERCRAFT_F32_MAX_PARAM 1.0e9F /**< largest inertia entry, force limit, or other gain */
#define HOVERCRAFT_F32_MIN_GAIN 1.0e-9F /**< least gain */
#define HOVERCRAFT_F32_MAX_RATE 1.0e4F /**< largest gain in 1/s */

/** What was found. The largest that applies is returned; from 16 on the whole command is zero. */
typedef enum {
    HOVERCRAFT_F32_OK = 0, /**< the command is good */
    HOVERCRAFT_F32_SATURATED = 1, /**< a force limit was reached */
    HOVERCRAFT_F32_NEAR_CUT_LOCUS = 2, /**< the error is close to where the law jumps */
    HOVERCRAFT_F32_NOT_ON_GROUP = 16, /**< the error is off the group by more than max_drift */
    HOVERCRAFT_F32_OUT_OF_RANGE = 17, /**< beyond MAX_INPUT, or too near a pole of the law */
    HOVERCRAFT_F32_NONFINITE_INPUT = 18, /**< an input, or what it leads to, is not finite */
    HOVERCRAFT_F32_BAD_PARAMS = 19 /**< found by check_params */
} hovercraft_f32_status;

/** Inertia and gains, from the vehicle file or tuned on the target. */
typedef struct {
    float inertia[6]; /**< inertia, upper triangle, row by row [kg m^2, kg m, kg] */
    float lambda; /**< sliding rate [1/s] */
    float k_s; /**< reaching rate [1/s] */
    float max_drift; /**< largest distance of the error from the group [1] */
} hovercraft_f32_params;

/** What is measured. */
typedef struct {
    float g[9]; /**< configuration: matrix of 3 rows, row by row [1] */
    float nu[3]; /**< body velocity [rad/s, m/s] */
} hovercraft_f32_state;

/** Where to be, and how that moves. */
typedef struct {
    float g[9]; /**< reference configuration: matrix of 3 rows, row by row [1] */
    float nu[3]; /**< reference velocity, reference body frame [rad/s, m/s] */
    float nu_dot[3]; /**< its rate [rad/s^2, m/s^2] */
} hovercraft_f32_reference;

/** What is to be done, and what it was made of. */
typedef struct {
    float force[3]; /**< control force [N m, N] */
    float s[3]; /**< sliding variable [rad/s, m/s] */
    float nu_u[3]; /**< kinematic law [rad, m] */
    float nu_u_dot[3]; /**< its exact rate [rad/s, m/s] */
} hovercraft_f32_command;

/** The vehicle file's inertia and gains. */
extern const hovercraft_f32_params hovercraft_f32_defaults;

/**
 * Judges the parameters, once at start-up.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @return OK; or BAD_PARAMS when one is not finite or out of range, the inertia not positive
 *     definite, or not zero where the derivation took that for granted
 */
hovercraft_f32_status hovercraft_f32_check_params(const hovercraft_f32_params *params);

/**
 * The guarded controller, for parameters that were checked. Whatever bits the other inputs are
 * made of, all of the command is written, and it is finite.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] reference where to be, and how that moves
 * @param[out] command what is to be done, and what it was made of
 * @return the largest status that applies
 */
hovercraft_f32_status hovercraft_f32_control(const hovercraft_f32_params *params,
        const hovercraft_f32_state *state, const hovercraft_f32_reference *reference,
        hovercraft_f32_command *command);

/**
 * Force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl).
 * Unguarded: presumes what control checks. Cost: 138 operations, 65 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] reference where to be, and how that moves
 * @param[out] command what is to be done, and what it was made of
 */
void hovercraft_f32_tracking(const hovercraft_f32_params *params, const hovercraft_f32_state *state,
        const hovercraft_f32_reference *reference, hovercraft_f32_command *command);

/**
 * Force that drives (g, nu) to (e, 0); eq. (Ctrl2).
 * Unguarded: presumes what control checks. Cost: 84 operations, 43 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[out] command what is to be done, and what it was made of
 */
void hovercraft_f32_reaching(const hovercraft_f32_params *params, const hovercraft_f32_state *state,
        hovercraft_f32_command *command);

/**
 * Acceleration under a force, Euler-Poincare; eq. (EulerP).
 * Unguarded: presumes what control checks. Cost: 23 operations, 11 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] force applied force [N m, N]
 * @param[out] nu_dot body acceleration [rad/s^2, m/s^2]
 */
void hovercraft_f32_plant(const hovercraft_f32_params *params, const hovercraft_f32_state *state,
        const float force[3], float nu_dot[3]);

#ifdef __cplusplus
}
#endif

#endif /* HOVERCRAFT_F32_H */
