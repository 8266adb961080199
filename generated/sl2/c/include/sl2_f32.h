/**
 * @file
 * @brief sl2_f32: gsmc on SL2, law {'arguments': ['nu', 'nu_r', 'nu_r_dot', 'g_e'], 'doc': 'force
 *     that drives (g, nu) to (g_r, nu_r)', 'has_reference': True, 'holders': ['params', 'state',
 *     'reference'], 'inputs': [{'argument': 'inertia', 'doc': 'inertia, upper triangle, row by
 *     row', 'entries': [['inertia_0', 0], ['inertia_1', 1], ['inertia_2', 2], ['inertia_3', 3],
 *     ['inertia_4', 4], ['inertia_5', 5]], 'holder': 'params', 'is_scalar': False, 'member':
 *     'inertia', 'name': 'inertia', 'shape': [6], 'size': 6, 'source': '', 'unit': 'J s^2'},
 *     {'argument': 'lambda_', 'doc': 'sliding rate', 'entries': [['rate_gain', 0]], 'holder':
 *     'params', 'is_scalar': True, 'member': 'lambda', 'name': 'rate_gain', 'shape': [1], 'size':
 *     1, 'source': '', 'unit': '1/s'}, {'argument': 'k_s', 'doc': 'reaching rate', 'entries':
 *     [['reach_gain', 0]], 'holder': 'params', 'is_scalar': True, 'member': 'k_s', 'name':
 *     'reach_gain', 'shape': [1], 'size': 1, 'source': '', 'unit': '1/s'}, {'argument': 'nu',
 *     'doc': 'body velocity', 'entries': [['nu_0', 0], ['nu_1', 1], ['nu_2', 2]], 'holder':
 *     'state', 'is_scalar': False, 'member': 'nu', 'name': 'nu', 'shape': [3], 'size': 3, 'source':
 *     '', 'unit': '1/s'}, {'argument': 'nu_r', 'doc': 'reference velocity, reference body frame',
 *     'entries': [['nu_r_0', 0], ['nu_r_1', 1], ['nu_r_2', 2]], 'holder': 'reference', 'is_scalar':
 *     False, 'member': 'nu', 'name': 'nu_r', 'shape': [3], 'size': 3, 'source': '', 'unit': '1/s'},
 *     {'argument': 'nu_r_dot', 'doc': 'its rate', 'entries': [['nu_r_dot_0', 0], ['nu_r_dot_1', 1],
 *     ['nu_r_dot_2', 2]], 'holder': 'reference', 'is_scalar': False, 'member': 'nu_dot', 'name':
 *     'nu_r_dot', 'shape': [3], 'size': 3, 'source': '', 'unit': '1/s^2'}, {'argument': 'g_e',
 *     'doc': 'error, g_r^-1 g', 'entries': [['g_e_0', 0], ['g_e_1', 1], ['g_e_2', 2], ['g_e_3',
 *     3]], 'holder': '', 'is_scalar': False, 'member': 'g_e', 'name': 'g_e', 'shape': [4], 'size':
 *     4, 'source': 'eq. (velErr)', 'unit': '1'}], 'is_public': False, 'name': 'tracking',
 *     'operations': 148, 'outputs': [{'doc': 'control force', 'entries': ['force_0', 'force_1',
 *     'force_2'], 'holder': 'command', 'is_scalar': False, 'member': 'force', 'name': 'force',
 *     'size': 3, 'source': '', 'unit': 'J'}, {'doc': 'sliding variable', 'entries': ['s_0', 's_1',
 *     's_2'], 'holder': 'command', 'is_scalar': False, 'member': 's', 'name': 's', 'size': 3,
 *     'source': '', 'unit': '1/s'}, {'doc': 'kinematic law', 'entries': ['g_e_1', 'g_e_2',
 *     'nu_u_2'], 'holder': 'command', 'is_scalar': False, 'member': 'nu_u', 'name': 'nu_u', 'size':
 *     3, 'source': '', 'unit': '1'}, {'doc': 'its exact rate', 'entries': ['nu_u_dot_0',
 *     'nu_u_dot_1', 'nu_u_dot_2'], 'holder': 'command', 'is_scalar': False, 'member': 'nu_u_dot',
 *     'name': 'nu_u_dot', 'size': 3, 'source': '', 'unit': '1/s'}, {'doc': 'distance from the cut
 *     locus of the law', 'entries': ['1.0F'], 'holder': '', 'is_scalar': True, 'member':
 *     'clearance', 'name': 'clearance', 'size': 1, 'source': '', 'unit': '1'}], 'public_writes':
 *     ['command', 'clearance'], 'source': 'eq. (TckCtrl)', 'steps': [{'cases': [], 'doc': 'Ad of
 *     g_e^-1: reference to body frame', 'holder': '', 'is_scalar': False, 'lines': [['to_body_0',
 *     'g_e_3*g_e_3'], ['to_body_1', '-g_e_1*g_e_1'], ['to_body_2', '2.0F*g_e_1*g_e_3'],
 *     ['to_body_3', '-g_e_2*g_e_2'], ['to_body_4', 'g_e_0*g_e_0'], ['to_body_5',
 *     '-2.0F*g_e_0*g_e_2'], ['to_body_6', 'g_e_2*g_e_3'], ['to_body_7', '-g_e_0*g_e_1'],
 *     ['to_body_8', 'g_e_0*g_e_3 + g_e_1*g_e_2']], 'member': '', 'name': 'to_body', 'names':
 *     ['to_body_0', 'to_body_1', 'to_body_2', 'to_body_3', 'to_body_4', 'to_body_5', 'to_body_6',
 *     'to_body_7', 'to_body_8'], 'size': 9, 'source': '', 'unit': '1'}, {'cases': [], 'doc':
 *     'reference velocity in the body frame', 'holder': '', 'is_scalar': False, 'lines': [['eta_0',
 *     'nu_r_0*to_body_0 + nu_r_1*to_body_1 + nu_r_2*to_body_2'], ['eta_1', 'nu_r_0*to_body_3 +
 *     nu_r_1*to_body_4 + nu_r_2*to_body_5'], ['eta_2', 'nu_r_0*to_body_6 + nu_r_1*to_body_7 +
 *     nu_r_2*to_body_8']], 'member': '', 'name': 'eta', 'names': ['eta_0', 'eta_1', 'eta_2'],
 *     'size': 3, 'source': 'eq. (velErr)', 'unit': '1/s'}, {'cases': [], 'doc': 'velocity error',
 *     'holder': '', 'is_scalar': False, 'lines': [['nu_e_0', 'nu_0 - eta_0'], ['nu_e_1', 'nu_1 -
 *     eta_1'], ['nu_e_2', 'nu_2 - eta_2']], 'member': '', 'name': 'nu_e', 'names': ['nu_e_0',
 *     'nu_e_1', 'nu_e_2'], 'size': 3, 'source': 'eq. (velErr)', 'unit': '1/s'}, {'cases': [],
 *     'doc': 'exact rate of eta', 'holder': '', 'is_scalar': False, 'lines': [['eta_dot_0',
 *     'nu_r_dot_0*to_body_0 + nu_r_dot_1*to_body_1 + nu_r_dot_2*to_body_2 - 2.0F*eta_0*nu_e_2 +
 *     2.0F*eta_2*nu_e_0'], ['eta_dot_1', 'nu_r_dot_0*to_body_3 + nu_r_dot_1*to_body_4 +
 *     nu_r_dot_2*to_body_5 - 2.0F*eta_2*nu_e_1 + 2.0F*eta_1*nu_e_2'], ['eta_dot_2', 'eta_0*nu_e_1 +
 *     nu_r_dot_0*to_body_6 + nu_r_dot_1*to_body_7 + nu_r_dot_2*to_body_8 - eta_1*nu_e_0']],
 *     'member': '', 'name': 'eta_dot', 'names': ['eta_dot_0', 'eta_dot_1', 'eta_dot_2'], 'size': 3,
 *     'source': '', 'unit': '1/s^2'}, {'cases': [], 'doc': 'kinematic law, vee(g - g^-1)/2',
 *     'holder': '', 'is_scalar': False, 'lines': [['nu_u_2', '0.5F*(g_e_0 - g_e_3)']], 'member':
 *     '', 'name': 'nu_u', 'names': ['nu_u_2'], 'size': 3, 'source': 'def. (KctrLaw)', 'unit': '1'},
 *     {'cases': [], 'doc': 'exact rate of nu_u', 'holder': '', 'is_scalar': False, 'lines':
 *     [['nu_u_dot_0', 'g_e_0*nu_e_0 - g_e_1*nu_e_2'], ['nu_u_dot_1', 'g_e_2*nu_e_2 +
 *     g_e_3*nu_e_1'], ['nu_u_dot_2', '0.5F*(g_e_0*nu_e_2 + g_e_1*nu_e_1 + g_e_3*nu_e_2 -
 *     g_e_2*nu_e_0)']], 'member': '', 'name': 'nu_u_dot', 'names': ['nu_u_dot_0', 'nu_u_dot_1',
 *     'nu_u_dot_2'], 'size': 3, 'source': '', 'unit': '1/s'}, {'cases': [], 'doc': 'lambda nu_u',
 *     'holder': '', 'is_scalar': False, 'lines': [['drive_0', 'g_e_1*rate_gain'], ['drive_1',
 *     'g_e_2*rate_gain'], ['drive_2', 'nu_u_2*rate_gain']], 'member': '', 'name': 'drive', 'names':
 *     ['drive_0', 'drive_1', 'drive_2'], 'size': 3, 'source': '', 'unit': '1/s'}, {'cases': [],
 *     'doc': 'sliding variable', 'holder': '', 'is_scalar': False, 'lines': [['s_0', 'drive_0 +
 *     nu_e_0'], ['s_1', 'drive_1 + nu_e_1'], ['s_2', 'drive_2 + nu_e_2']], 'member': '', 'name':
 *     's', 'names': ['s_0', 's_1', 's_2'], 'size': 3, 'source': 'eq. (SurfaceErr)', 'unit': '1/s'},
 *     {'cases': [], 'doc': 'acceleration asked for', 'holder': '', 'is_scalar': False, 'lines':
 *     [['wanted_0', 'eta_dot_0 - nu_u_dot_0*rate_gain - reach_gain*s_0'], ['wanted_1', 'eta_dot_1 -
 *     nu_u_dot_1*rate_gain - reach_gain*s_1'], ['wanted_2', 'eta_dot_2 - nu_u_dot_2*rate_gain -
 *     reach_gain*s_2']], 'member': '', 'name': 'wanted', 'names': ['wanted_0', 'wanted_1',
 *     'wanted_2'], 'size': 3, 'source': '', 'unit': '1/s^2'}, {'cases': [], 'doc': 'lambda nu_u -
 *     eta', 'holder': '', 'is_scalar': False, 'lines': [['turning_0', 'drive_0 - eta_0'],
 *     ['turning_1', 'drive_1 - eta_1'], ['turning_2', 'drive_2 - eta_2']], 'member': '', 'name':
 *     'turning', 'names': ['turning_0', 'turning_1', 'turning_2'], 'size': 3, 'source': '', 'unit':
 *     '1/s'}, {'cases': [], 'doc': 'I nu', 'holder': '', 'is_scalar': False, 'lines':
 *     [['momentum_0', 'inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2'], ['momentum_1',
 *     'inertia_1*nu_0 + inertia_3*nu_1 + inertia_4*nu_2'], ['momentum_2', 'inertia_2*nu_0 +
 *     inertia_4*nu_1 + inertia_5*nu_2']], 'member': '', 'name': 'momentum', 'names': ['momentum_0',
 *     'momentum_1', 'momentum_2'], 'size': 3, 'source': '', 'unit': 'J s'}, {'cases': [], 'doc':
 *     'control force, I f_u', 'holder': '', 'is_scalar': False, 'lines': [['force_0',
 *     'inertia_0*wanted_0 + inertia_1*wanted_1 + inertia_2*wanted_2 - momentum_2*turning_1 +
 *     2.0F*momentum_0*turning_2'], ['force_1', 'inertia_1*wanted_0 + inertia_3*wanted_1 +
 *     inertia_4*wanted_2 + momentum_2*turning_0 - 2.0F*momentum_1*turning_2'], ['force_2',
 *     'inertia_2*wanted_0 + inertia_4*wanted_1 + inertia_5*wanted_2 - 2.0F*momentum_0*turning_0 +
 *     2.0F*momentum_1*turning_1']], 'member': '', 'name': 'force', 'names': ['force_0', 'force_1',
 *     'force_2'], 'size': 3, 'source': 'eq. (TckCtrl)', 'unit': 'J'}], 'symbol': 'tracking',
 *     'temporaries': 40, 'writes': ['command', 'clearance']}, float precision.
 *
 * Generated by derive from the vehicle file sl2.toml; regenerate instead of editing.
 *
 * - Use: sl2_f32_check_params once at start-up, then sl2_f32_control at every instant.
 * - Units: SI; they stand in brackets beside each number.
 * - Frames: velocities and forces are in the body frame; the reference's in the reference's own.
 * - Configuration g: matrix of 2 rows, row by row.
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
#ifndef SL2_F32_H
#define SL2_F32_H

#ifdef __cplusplus
extern "C" {
#endif

#define SL2_F32_MAX_INPUT 1.0e6F /**< largest magnitude of a number in state or reference */
#define SL2_F32_MAX_ENTRY 1.01F /**< of an entry of the error that the group keeps at 1 */
#define SL2_F32_MAX_REACH 1.0e3F /**< of any other entry of the error */
#define SL2_F32_MOST_DRIFT 0.1F /**< largest max_drift that may be asked for */
#define SL2_F32_NEAR_CUT 0.001F /**< clearance below which NEAR_CUT_LOCUS is flagged */
#define SL2_F32_MAX_PARAM 1.0e9F /**< largest inertia entry, force limit, or other gain */
#define SL2_F32_MIN_GAIN 1.0e-9F /**< least gain */
#define SL2_F32_MAX_RATE 1.0e4F /**< largest gain in 1/s */

/** What was found. The largest that applies is returned; from 16 on the whole command is zero. */
typedef enum {
    SL2_F32_OK = 0, /**< the command is good */
    SL2_F32_SATURATED = 1, /**< a force limit was reached */
    SL2_F32_NEAR_CUT_LOCUS = 2, /**< the error is close to where the law jumps */
    SL2_F32_NOT_ON_GROUP = 16, /**< the error is off the group by more than max_drift */
    SL2_F32_OUT_OF_RANGE = 17, /**< beyond MAX_INPUT, or too near a pole of the law */
    SL2_F32_NONFINITE_INPUT = 18, /**< an input, or what it leads to, is not finite */
    SL2_F32_BAD_PARAMS = 19 /**< found by check_params */
} sl2_f32_status;

/** Inertia and gains, from the vehicle file or tuned on the target. */
typedef struct {
    float inertia[6]; /**< inertia, upper triangle, row by row [J s^2] */
    float lambda; /**< sliding rate [1/s] */
    float k_s; /**< reaching rate [1/s] */
    float max_drift; /**< largest distance of the error from the group [1] */
} sl2_f32_params;

/** What is measured. */
typedef struct {
    float g[4]; /**< configuration: matrix of 2 rows, row by row [1] */
    float nu[3]; /**< body velocity [1/s] */
} sl2_f32_state;

/** Where to be, and how that moves. */
typedef struct {
    float g[4]; /**< reference configuration: matrix of 2 rows, row by row [1] */
    float nu[3]; /**< reference velocity, reference body frame [1/s] */
    float nu_dot[3]; /**< its rate [1/s^2] */
} sl2_f32_reference;

/** What is to be done, and what it was made of. */
typedef struct {
    float force[3]; /**< control force [J] */
    float s[3]; /**< sliding variable [1/s] */
    float nu_u[3]; /**< kinematic law [1] */
    float nu_u_dot[3]; /**< its exact rate [1/s] */
} sl2_f32_command;

/** The vehicle file's inertia and gains. */
extern const sl2_f32_params sl2_f32_defaults;

/**
 * Judges the parameters, once at start-up.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @return OK; or BAD_PARAMS when one is not finite or out of range, the inertia not positive
 *     definite, or not zero where the derivation took that for granted
 */
sl2_f32_status sl2_f32_check_params(const sl2_f32_params *params);

/**
 * The guarded controller, for parameters that were checked. Whatever bits the other inputs are
 * made of, all of the command is written, and it is finite.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] reference where to be, and how that moves
 * @param[out] command what is to be done, and what it was made of
 * @return the largest status that applies
 */
sl2_f32_status sl2_f32_control(const sl2_f32_params *params, const sl2_f32_state *state,
        const sl2_f32_reference *reference, sl2_f32_command *command);

/**
 * Force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl).
 * Unguarded: presumes what control checks. Cost: 160 operations, 44 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] reference where to be, and how that moves
 * @param[out] command what is to be done, and what it was made of
 */
void sl2_f32_tracking(const sl2_f32_params *params, const sl2_f32_state *state,
        const sl2_f32_reference *reference, sl2_f32_command *command);

/**
 * Force that drives (g, nu) to (e, 0); eq. (Ctrl2).
 * Unguarded: presumes what control checks. Cost: 81 operations, 19 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[out] command what is to be done, and what it was made of
 */
void sl2_f32_reaching(const sl2_f32_params *params, const sl2_f32_state *state,
        sl2_f32_command *command);

/**
 * Acceleration under a force, Euler-Poincare; eq. (EulerP).
 * Unguarded: presumes what control checks. Cost: 60 operations, 16 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] force applied force [J]
 * @param[out] nu_dot body acceleration [1/s^2]
 */
void sl2_f32_plant(const sl2_f32_params *params, const sl2_f32_state *state, const float force[3],
        float nu_dot[3]);

#ifdef __cplusplus
}
#endif

#endif /* SL2_F32_H */
