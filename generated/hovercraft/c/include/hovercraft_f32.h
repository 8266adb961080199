/**
 * @file
 * @brief hovercraft_f32: gsmc on SE2, law {'arguments': ['nu', 'nu_r', 'nu_r_dot', 'g_e'], 'doc':
 *     'force that drives (g, nu) to (g_r, nu_r)', 'has_reference': True, 'holders': ['params',
 *     'state', 'reference'], 'inputs': [{'argument': 'inertia', 'doc': 'inertia, upper triangle,
 *     row by row', 'entries': [['inertia_0', 0], ['inertia_2', 2], ['inertia_3', 3], ['inertia_5',
 *     5]], 'holder': 'params', 'is_scalar': False, 'member': 'inertia', 'name': 'inertia', 'shape':
 *     [6], 'size': 6, 'source': '', 'unit': 'kg m^2, kg m, kg'}, {'argument': 'lambda_', 'doc':
 *     'sliding rate', 'entries': [['rate_gain', 0]], 'holder': 'params', 'is_scalar': True,
 *     'member': 'lambda', 'name': 'rate_gain', 'shape': [1], 'size': 1, 'source': '', 'unit':
 *     '1/s'}, {'argument': 'k_s', 'doc': 'reaching rate', 'entries': [['reach_gain', 0]], 'holder':
 *     'params', 'is_scalar': True, 'member': 'k_s', 'name': 'reach_gain', 'shape': [1], 'size': 1,
 *     'source': '', 'unit': '1/s'}, {'argument': 'nu', 'doc': 'body velocity', 'entries': [['nu_0',
 *     0], ['nu_1', 1], ['nu_2', 2]], 'holder': 'state', 'is_scalar': False, 'member': 'nu', 'name':
 *     'nu', 'shape': [3], 'size': 3, 'source': '', 'unit': 'rad/s, m/s'}, {'argument': 'nu_r',
 *     'doc': 'reference velocity, reference body frame', 'entries': [['nu_r_0', 0], ['nu_r_1', 1],
 *     ['nu_r_2', 2]], 'holder': 'reference', 'is_scalar': False, 'member': 'nu', 'name': 'nu_r',
 *     'shape': [3], 'size': 3, 'source': '', 'unit': 'rad/s, m/s'}, {'argument': 'nu_r_dot', 'doc':
 *     'its rate', 'entries': [['nu_r_dot_0', 0], ['nu_r_dot_1', 1], ['nu_r_dot_2', 2]], 'holder':
 *     'reference', 'is_scalar': False, 'member': 'nu_dot', 'name': 'nu_r_dot', 'shape': [3],
 *     'size': 3, 'source': '', 'unit': 'rad/s^2, m/s^2'}, {'argument': 'g_e', 'doc': 'error, g_r^-1
 *     g', 'entries': [['g_e_0', 0], ['g_e_1', 1], ['g_e_2', 2], ['g_e_3', 3], ['g_e_4', 4],
 *     ['g_e_5', 5]], 'holder': '', 'is_scalar': False, 'member': 'g_e', 'name': 'g_e', 'shape':
 *     [9], 'size': 9, 'source': 'eq. (velErr)', 'unit': '1'}], 'is_public': False, 'name':
 *     'tracking', 'operations': 118, 'outputs': [{'doc': 'control force', 'entries': ['force_0',
 *     'force_1', 'force_2'], 'holder': 'command', 'is_scalar': False, 'member': 'force', 'name':
 *     'force', 'size': 3, 'source': '', 'unit': 'N m, N'}, {'doc': 'sliding variable', 'entries':
 *     ['s_0', 's_1', 's_2'], 'holder': 'command', 'is_scalar': False, 'member': 's', 'name': 's',
 *     'size': 3, 'source': '', 'unit': 'rad/s, m/s'}, {'doc': 'kinematic law', 'entries': ['phi_0',
 *     'rho_p_0', 'rho_p_1'], 'holder': 'command', 'is_scalar': False, 'member': 'nu_u', 'name':
 *     'nu_u', 'size': 3, 'source': '', 'unit': 'rad, m'}, {'doc': 'its exact rate', 'entries':
 *     ['nu_e_0', 'nu_u_dot_1', 'nu_u_dot_2'], 'holder': 'command', 'is_scalar': False, 'member':
 *     'nu_u_dot', 'name': 'nu_u_dot', 'size': 3, 'source': '', 'unit': 'rad/s, m/s'}, {'doc':
 *     'distance from the cut locus of the law', 'entries': ['w'], 'holder': '', 'is_scalar': True,
 *     'member': 'clearance', 'name': 'clearance', 'size': 1, 'source': '', 'unit': '1'}],
 *     'public_writes': ['command', 'clearance'], 'source': 'eq. (TckCtrl)', 'steps': [{'cases': [],
 *     'doc': 'velocity at p', 'holder': '', 'is_scalar': False, 'lines': [['eta_arm_0_0', 'nu_r_1 -
 *     g_e_5*nu_r_0'], ['eta_arm_0_1', 'nu_r_2 + g_e_2*nu_r_0']], 'member': '', 'name': 'eta_arm_0',
 *     'names': ['eta_arm_0_0', 'eta_arm_0_1'], 'size': 2, 'source': '', 'unit': 'm/s'}, {'cases':
 *     [], 'doc': 'reference velocity in the body frame', 'holder': '', 'is_scalar': False, 'lines':
 *     [['eta_1', 'eta_arm_0_0*g_e_0 + eta_arm_0_1*g_e_3'], ['eta_2', 'eta_arm_0_0*g_e_1 +
 *     eta_arm_0_1*g_e_4']], 'member': '', 'name': 'eta', 'names': ['eta_1', 'eta_2'], 'size': 3,
 *     'source': 'eq. (velErr)', 'unit': 'rad/s, m/s'}, {'cases': [], 'doc': 'velocity error',
 *     'holder': '', 'is_scalar': False, 'lines': [['nu_e_0', 'nu_0 - nu_r_0'], ['nu_e_1', 'nu_1 -
 *     eta_1'], ['nu_e_2', 'nu_2 - eta_2']], 'member': '', 'name': 'nu_e', 'names': ['nu_e_0',
 *     'nu_e_1', 'nu_e_2'], 'size': 3, 'source': 'eq. (velErr)', 'unit': 'rad/s, m/s'}, {'cases':
 *     [], 'doc': 'velocity at p', 'holder': '', 'is_scalar': False, 'lines': [['eta_dot_arm_0_0',
 *     'nu_r_dot_1 - g_e_5*nu_r_dot_0'], ['eta_dot_arm_0_1', 'nu_r_dot_2 + g_e_2*nu_r_dot_0']],
 *     'member': '', 'name': 'eta_dot_arm_0', 'names': ['eta_dot_arm_0_0', 'eta_dot_arm_0_1'],
 *     'size': 2, 'source': '', 'unit': 'm/s'}, {'cases': [], 'doc': 'exact rate of eta', 'holder':
 *     '', 'is_scalar': False, 'lines': [['eta_dot_1', 'eta_2*nu_e_0 + eta_dot_arm_0_0*g_e_0 +
 *     eta_dot_arm_0_1*g_e_3 - nu_e_2*nu_r_0'], ['eta_dot_2', 'eta_dot_arm_0_0*g_e_1 +
 *     eta_dot_arm_0_1*g_e_4 + nu_e_1*nu_r_0 - eta_1*nu_e_0']], 'member': '', 'name': 'eta_dot',
 *     'names': ['eta_dot_1', 'eta_dot_2'], 'size': 3, 'source': '', 'unit': 'rad/s^2, m/s^2'},
 *     {'cases': [], 'doc': '2 cos and 2 sin of the angle', 'holder': '', 'is_scalar': False,
 *     'lines': [['twice_0', 'g_e_0 + g_e_4'], ['twice_1', 'g_e_3 - g_e_1']], 'member': '', 'name':
 *     'twice', 'names': ['twice_0', 'twice_1'], 'size': 2, 'source': '', 'unit': '1'}, {'cases':
 *     [], 'doc': 'their squared length', 'holder': '', 'is_scalar': True, 'lines': [['norm_square',
 *     'twice_0*twice_0 + twice_1*twice_1']], 'member': '', 'name': 'norm_square', 'names':
 *     ['norm_square'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [{'condition': 'norm_square
 *     < 3.0F', 'lines': [['norm_bounded', '3.0F']]}, {'condition': '', 'lines': [['norm_bounded',
 *     'norm_square']]}], 'doc': 'the same: less is no turn', 'holder': '', 'is_scalar': True,
 *     'lines': [], 'member': '', 'name': 'norm_bounded', 'names': ['norm_bounded'], 'size': 1,
 *     'source': '', 'unit': '1'}, {'cases': [], 'doc': 'their length', 'holder': '', 'is_scalar':
 *     True, 'lines': [['norm', 'sqrtf(norm_bounded)']], 'member': '', 'name': 'norm', 'names':
 *     ['norm'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [{'condition': 'twice_0 >= 0.0F',
 *     'lines': [['column_0', 'norm + twice_0'], ['column_1', 'twice_1']]}, {'condition': 'twice_1
 *     >= 0.0F', 'lines': [['column_0', 'twice_1'], ['column_1', 'norm - twice_0']]}, {'condition':
 *     '', 'lines': [['column_0', '-twice_1'], ['column_1', 'twice_0 - norm']]}], 'doc': 'cos >= 0
 *     and sin of half the angle, unscaled', 'holder': '', 'is_scalar': False, 'lines': [],
 *     'member': '', 'name': 'column', 'names': ['column_0', 'column_1'], 'size': 2, 'source': '',
 *     'unit': '1'}, {'cases': [], 'doc': 'squared length', 'holder': '', 'is_scalar': True,
 *     'lines': [['column_square', 'column_0*column_0 + column_1*column_1']], 'member': '', 'name':
 *     'column_square', 'names': ['column_square'], 'size': 1, 'source': '', 'unit': '1'}, {'cases':
 *     [{'condition': 'column_square < 3.0F', 'lines': [['column_bounded', '3.0F']]}, {'condition':
 *     '', 'lines': [['column_bounded', 'column_square']]}], 'doc': 'the same', 'holder': '',
 *     'is_scalar': True, 'lines': [], 'member': '', 'name': 'column_bounded', 'names':
 *     ['column_bounded'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'to unit
 *     length', 'holder': '', 'is_scalar': True, 'lines': [['scale', '1.0F/sqrtf(column_bounded)']],
 *     'member': '', 'name': 'scale', 'names': ['scale'], 'size': 1, 'source': '', 'unit': '1'},
 *     {'cases': [], 'doc': 'cos of half the error angle, rounded', 'holder': '', 'is_scalar': True,
 *     'lines': [['cosine', 'column_0*scale']], 'member': '', 'name': 'cosine', 'names': ['cosine'],
 *     'size': 1, 'source': '', 'unit': '1'}, {'cases': [{'condition': 'cosine > 1.0F', 'lines':
 *     [['w', '1.0F']]}, {'condition': '', 'lines': [['w', 'cosine']]}], 'doc': 'cos of half the
 *     error angle', 'holder': '', 'is_scalar': True, 'lines': [], 'member': '', 'name': 'w',
 *     'names': ['w'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'sin of half the
 *     error angle', 'holder': '', 'is_scalar': True, 'lines': [['sine', 'column_1*scale']],
 *     'member': '', 'name': 'sine', 'names': ['sine'], 'size': 1, 'source': '', 'unit': '1'},
 *     {'cases': [], 'doc': 'half angle over its sine', 'holder': '', 'is_scalar': True, 'lines':
 *     [['k', 'hovercraft_f32_k(w)']], 'member': '', 'name': 'k', 'names': ['k'], 'size': 1,
 *     'source': '', 'unit': '1'}, {'cases': [], 'doc': '-dk/dw', 'holder': '', 'is_scalar': True,
 *     'lines': [['h', 'hovercraft_f32_h(w)']], 'member': '', 'name': 'h', 'names': ['h'], 'size':
 *     1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'rotation vector of the error', 'holder':
 *     '', 'is_scalar': False, 'lines': [['phi_0', '2.0F*k*sine']], 'member': '', 'name': 'phi',
 *     'names': ['phi_0'], 'size': 1, 'source': '', 'unit': 'rad'}, {'cases': [], 'doc': '1/(2 k)',
 *     'holder': '', 'is_scalar': True, 'lines': [['half', '0.5F/k']], 'member': '', 'name': 'half',
 *     'names': ['half'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'p turned back
 *     by half the angle', 'holder': '', 'is_scalar': False, 'lines': [['turned_p_0', 'g_e_2*w +
 *     g_e_5*sine'], ['turned_p_1', 'g_e_5*w - g_e_2*sine']], 'member': '', 'name': 'turned_p',
 *     'names': ['turned_p_0', 'turned_p_1'], 'size': 2, 'source': '', 'unit': 'm'}, {'cases': [],
 *     'doc': 'p - k Y p + h Y Y p', 'holder': '', 'is_scalar': False, 'lines': [['rho_p_0',
 *     'k*turned_p_0'], ['rho_p_1', 'k*turned_p_1']], 'member': '', 'name': 'rho_p', 'names':
 *     ['rho_p_0', 'rho_p_1'], 'size': 2, 'source': '', 'unit': 'm'}, {'cases': [], 'doc': 'rho/(2
 *     k)', 'holder': '', 'is_scalar': False, 'lines': [['y_p_0', 'half*rho_p_0'], ['y_p_1',
 *     'half*rho_p_1']], 'member': '', 'name': 'y_p', 'names': ['y_p_0', 'y_p_1'], 'size': 2,
 *     'source': '', 'unit': 'm'}, {'cases': [], 'doc': 'Y nu_e, Y = ad of y', 'holder': '',
 *     'is_scalar': False, 'lines': [['turn_1', 'nu_e_0*y_p_1 - nu_e_2*sine'], ['turn_2',
 *     'nu_e_1*sine - nu_e_0*y_p_0']], 'member': '', 'name': 'turn', 'names': ['turn_1', 'turn_2'],
 *     'size': 3, 'source': '', 'unit': 'rad/s, m/s'}, {'cases': [], 'doc': 'Y Y nu_e', 'holder':
 *     '', 'is_scalar': False, 'lines': [['bend_1', '-sine*turn_2'], ['bend_2', 'sine*turn_1']],
 *     'member': '', 'name': 'bend', 'names': ['bend_1', 'bend_2'], 'size': 3, 'source': '', 'unit':
 *     'rad/s, m/s'}, {'cases': [], 'doc': 'exact rate of nu_u', 'holder': '', 'is_scalar': False,
 *     'lines': [['nu_u_dot_1', 'nu_e_1 + bend_1*h + k*turn_1'], ['nu_u_dot_2', 'nu_e_2 + bend_2*h +
 *     k*turn_2']], 'member': '', 'name': 'nu_u_dot', 'names': ['nu_u_dot_1', 'nu_u_dot_2'], 'size':
 *     3, 'source': '', 'unit': 'rad/s, m/s'}, {'cases': [], 'doc': 'lambda nu_u', 'holder': '',
 *     'is_scalar': False, 'lines': [['drive_0', 'phi_0*rate_gain'], ['drive_1',
 *     'rate_gain*rho_p_0'], ['drive_2', 'rate_gain*rho_p_1']], 'member': '', 'name': 'drive',
 *     'names': ['drive_0', 'drive_1', 'drive_2'], 'size': 3, 'source': '', 'unit': 'rad/s, m/s'},
 *     {'cases': [], 'doc': 'sliding variable', 'holder': '', 'is_scalar': False, 'lines': [['s_0',
 *     'drive_0 + nu_e_0'], ['s_1', 'drive_1 + nu_e_1'], ['s_2', 'drive_2 + nu_e_2']], 'member': '',
 *     'name': 's', 'names': ['s_0', 's_1', 's_2'], 'size': 3, 'source': 'eq. (SurfaceErr)', 'unit':
 *     'rad/s, m/s'}, {'cases': [], 'doc': 'acceleration asked for', 'holder': '', 'is_scalar':
 *     False, 'lines': [['wanted_0', 'nu_r_dot_0 - nu_e_0*rate_gain - reach_gain*s_0'], ['wanted_1',
 *     'eta_dot_1 - nu_u_dot_1*rate_gain - reach_gain*s_1'], ['wanted_2', 'eta_dot_2 -
 *     nu_u_dot_2*rate_gain - reach_gain*s_2']], 'member': '', 'name': 'wanted', 'names':
 *     ['wanted_0', 'wanted_1', 'wanted_2'], 'size': 3, 'source': '', 'unit': 'rad/s^2, m/s^2'},
 *     {'cases': [], 'doc': 'lambda nu_u - eta', 'holder': '', 'is_scalar': False, 'lines':
 *     [['turning_0', 'drive_0 - nu_r_0'], ['turning_1', 'drive_1 - eta_1'], ['turning_2', 'drive_2
 *     - eta_2']], 'member': '', 'name': 'turning', 'names': ['turning_0', 'turning_1',
 *     'turning_2'], 'size': 3, 'source': '', 'unit': 'rad/s, m/s'}, {'cases': [], 'doc': 'I nu',
 *     'holder': '', 'is_scalar': False, 'lines': [['momentum_1', 'inertia_3*nu_1'], ['momentum_2',
 *     'inertia_2*nu_0 + inertia_5*nu_2']], 'member': '', 'name': 'momentum', 'names':
 *     ['momentum_1', 'momentum_2'], 'size': 3, 'source': '', 'unit': 'N m s, N s'}, {'cases': [],
 *     'doc': 'control force, I f_u', 'holder': '', 'is_scalar': False, 'lines': [['force_0',
 *     'inertia_0*wanted_0 + inertia_2*wanted_2 + momentum_1*turning_2 - momentum_2*turning_1'],
 *     ['force_1', 'inertia_3*wanted_1 + momentum_2*turning_0'], ['force_2', 'inertia_2*wanted_0 +
 *     inertia_5*wanted_2 - momentum_1*turning_0']], 'member': '', 'name': 'force', 'names':
 *     ['force_0', 'force_1', 'force_2'], 'size': 3, 'source': 'eq. (TckCtrl)', 'unit': 'N m, N'}],
 *     'symbol': 'tracking', 'temporaries': 57, 'writes': ['command', 'clearance']}, float
 *     precision.
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
