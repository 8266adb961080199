/**
 * @file
 * @brief paper_so3_lsf_printed_f32: lsf_printed on SO3, law {'arguments': ['nu', 'nu_r',
 *     'nu_r_dot', 'g_e'], 'doc': 'LSF force that tracks (g_r, nu_r)', 'has_reference': True,
 *     'holders': ['params', 'state', 'reference'], 'inputs': [{'argument': 'inertia', 'doc':
 *     'inertia, upper triangle, row by row', 'entries': [['inertia_0', 0], ['inertia_1', 1],
 *     ['inertia_2', 2], ['inertia_3', 3], ['inertia_4', 4], ['inertia_5', 5]], 'holder': 'params',
 *     'is_scalar': False, 'member': 'inertia', 'name': 'inertia', 'shape': [6], 'size': 6,
 *     'source': '', 'unit': 'kg m^2'}, {'argument': 'k', 'doc': 'gain of s', 'entries': [['k', 0]],
 *     'holder': 'params', 'is_scalar': True, 'member': 'k', 'name': 'k', 'shape': [1], 'size': 1,
 *     'source': '', 'unit': '1/s'}, {'argument': 'kappa', 'doc': 'gain of the attitude error',
 *     'entries': [['kappa', 0]], 'holder': 'params', 'is_scalar': True, 'member': 'kappa', 'name':
 *     'kappa', 'shape': [1], 'size': 1, 'source': '', 'unit': '1/s^2'}, {'argument': 'nu', 'doc':
 *     'body velocity', 'entries': [['nu_0', 0], ['nu_1', 1], ['nu_2', 2]], 'holder': 'state',
 *     'is_scalar': False, 'member': 'nu', 'name': 'nu', 'shape': [3], 'size': 3, 'source': '',
 *     'unit': 'rad/s'}, {'argument': 'nu_r', 'doc': 'reference velocity, reference body frame',
 *     'entries': [['nu_r_0', 0], ['nu_r_1', 1], ['nu_r_2', 2]], 'holder': 'reference', 'is_scalar':
 *     False, 'member': 'nu', 'name': 'nu_r', 'shape': [3], 'size': 3, 'source': '', 'unit':
 *     'rad/s'}, {'argument': 'nu_r_dot', 'doc': 'its rate', 'entries': [['nu_r_dot_0', 0],
 *     ['nu_r_dot_1', 1], ['nu_r_dot_2', 2]], 'holder': 'reference', 'is_scalar': False, 'member':
 *     'nu_dot', 'name': 'nu_r_dot', 'shape': [3], 'size': 3, 'source': '', 'unit': 'rad/s^2'},
 *     {'argument': 'g_e', 'doc': 'error, g_r^-1 g', 'entries': [['g_e_1', 1], ['g_e_2', 2],
 *     ['g_e_3', 3], ['g_e_5', 5], ['g_e_6', 6], ['g_e_7', 7]], 'holder': '', 'is_scalar': False,
 *     'member': 'g_e', 'name': 'g_e', 'shape': [9], 'size': 9, 'source': 'eq. (velErr)', 'unit':
 *     '1'}], 'is_public': False, 'name': 'tracking', 'operations': 73, 'outputs': [{'doc': 'control
 *     force', 'entries': ['force_0', 'force_1', 'force_2'], 'holder': 'command', 'is_scalar':
 *     False, 'member': 'force', 'name': 'force', 'size': 3, 'source': '', 'unit': 'N m'}, {'doc':
 *     'sliding variable', 'entries': ['s_0', 's_1', 's_2'], 'holder': 'command', 'is_scalar':
 *     False, 'member': 's', 'name': 's', 'size': 3, 'source': '', 'unit': 'rad/s'}, {'doc':
 *     'attitude error', 'entries': ['nu_u_0', 'nu_u_1', 'nu_u_2'], 'holder': 'command',
 *     'is_scalar': False, 'member': 'nu_u', 'name': 'nu_u', 'size': 3, 'source': '', 'unit':
 *     'rad'}, {'doc': 'distance from the cut locus of the law', 'entries': ['1.0F'], 'holder': '',
 *     'is_scalar': True, 'member': 'clearance', 'name': 'clearance', 'size': 1, 'source': '',
 *     'unit': '1'}], 'public_writes': ['command', 'clearance'], 'source': 'eq. (Ctrls2)', 'steps':
 *     [{'cases': [], 'doc': 'attitude error, 2 sin(angle) axis', 'holder': '', 'is_scalar': False,
 *     'lines': [['nu_u_0', 'g_e_7 - g_e_5'], ['nu_u_1', 'g_e_2 - g_e_6'], ['nu_u_2', 'g_e_3 -
 *     g_e_1']], 'member': '', 'name': 'nu_u', 'names': ['nu_u_0', 'nu_u_1', 'nu_u_2'], 'size': 3,
 *     'source': 'eq. (s2)', 'unit': 'rad'}, {'cases': [], 'doc': 'nu - nu_r, each in its own body
 *     frame', 'holder': '', 'is_scalar': False, 'lines': [['raw_0', 'nu_0 - nu_r_0'], ['raw_1',
 *     'nu_1 - nu_r_1'], ['raw_2', 'nu_2 - nu_r_2']], 'member': '', 'name': 'raw', 'names':
 *     ['raw_0', 'raw_1', 'raw_2'], 'size': 3, 'source': '', 'unit': 'rad/s'}, {'cases': [], 'doc':
 *     'kappa/k', 'holder': '', 'is_scalar': True, 'lines': [['ratio', 'kappa/k']], 'member': '',
 *     'name': 'ratio', 'names': ['ratio'], 'size': 1, 'source': '', 'unit': '1/s'}, {'cases': [],
 *     'doc': 'sliding variable', 'holder': '', 'is_scalar': False, 'lines': [['s_0', 'raw_0 +
 *     nu_u_0*ratio'], ['s_1', 'raw_1 + nu_u_1*ratio'], ['s_2', 'raw_2 + nu_u_2*ratio']], 'member':
 *     '', 'name': 's', 'names': ['s_0', 's_1', 's_2'], 'size': 3, 'source': 'eq. (s2)', 'unit':
 *     'rad/s'}, {'cases': [], 'doc': 'acceleration asked for', 'holder': '', 'is_scalar': False,
 *     'lines': [['wanted_0', 'nu_r_dot_0 - k*s_0'], ['wanted_1', 'nu_r_dot_1 - k*s_1'],
 *     ['wanted_2', 'nu_r_dot_2 - k*s_2']], 'member': '', 'name': 'wanted', 'names': ['wanted_0',
 *     'wanted_1', 'wanted_2'], 'size': 3, 'source': '', 'unit': 'rad/s^2'}, {'cases': [], 'doc':
 *     'nu x nu_r', 'holder': '', 'is_scalar': False, 'lines': [['crossing_0', 'nu_1*nu_r_2 -
 *     nu_2*nu_r_1'], ['crossing_1', 'nu_2*nu_r_0 - nu_0*nu_r_2'], ['crossing_2', 'nu_0*nu_r_1 -
 *     nu_1*nu_r_0']], 'member': '', 'name': 'crossing', 'names': ['crossing_0', 'crossing_1',
 *     'crossing_2'], 'size': 3, 'source': '', 'unit': 'rad/s^2'}, {'cases': [], 'doc': 'I nu',
 *     'holder': '', 'is_scalar': False, 'lines': [['momentum_0', 'inertia_0*nu_0 + inertia_1*nu_1 +
 *     inertia_2*nu_2'], ['momentum_1', 'inertia_1*nu_0 + inertia_3*nu_1 + inertia_4*nu_2'],
 *     ['momentum_2', 'inertia_2*nu_0 + inertia_4*nu_1 + inertia_5*nu_2']], 'member': '', 'name':
 *     'momentum', 'names': ['momentum_0', 'momentum_1', 'momentum_2'], 'size': 3, 'source': '',
 *     'unit': 'N m s'}, {'cases': [], 'doc': 'control force', 'holder': '', 'is_scalar': False,
 *     'lines': [['force_0', 'inertia_0*wanted_0 - crossing_0 + inertia_1*wanted_1 +
 *     inertia_2*wanted_2 + momentum_2*nu_1 - momentum_1*nu_2'], ['force_1', 'inertia_1*wanted_0 -
 *     crossing_1 + inertia_3*wanted_1 + inertia_4*wanted_2 + momentum_0*nu_2 - momentum_2*nu_0'],
 *     ['force_2', 'inertia_2*wanted_0 - crossing_2 + inertia_4*wanted_1 + inertia_5*wanted_2 +
 *     momentum_1*nu_0 - momentum_0*nu_1']], 'member': '', 'name': 'force', 'names': ['force_0',
 *     'force_1', 'force_2'], 'size': 3, 'source': 'eq. (Ctrls2)', 'unit': 'N m'}], 'symbol':
 *     'tracking', 'temporaries': 22, 'writes': ['command', 'clearance']}, float precision.
 *
 * Generated by derive from the vehicle file paper_so3_lsf_printed.toml; regenerate instead of
         editing.
 *
 * - Use: paper_so3_lsf_printed_f32_check_params once at start-up, then
 *   paper_so3_lsf_printed_f32_control at every instant.
 * - Units: SI; they stand in brackets beside each number.
 * - Frames: velocities and forces are in the body frame; the reference's in the reference's own.
 * - Configuration g: rotation matrix, row by row.
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
#ifndef PAPER_SO3_LSF_PRINTED_F32_H
#define PAPER_SO3_LSF_PRINTED_F32_H

#ifdef __cplusplus
extern "C" {
#endif

/** largest magnitude of a number in state or reference */
#define PAPER_SO3_LSF_PRINTED_F32_MAX_INPUT 1.0e6F
/** of an entry of the error that the group keeps at 1 */
#define PAPER_SO3_LSF_PRINTED_F32_MAX_ENTRY 1.01F
#define PAPER_SO3_LSF_PRINTED_F32_MAX_REACH 4.0e6F /**< of any other entry of the error */
#define PAPER_SO3_LSF_PRINTED_F32_MOST_DRIFT 0.1F /**< largest max_drift that may be asked for */
/** clearance below which NEAR_CUT_LOCUS is flagged */
#define PAPER_SO3_LSF_PRINTED_F32_NEAR_CUT 0.001F
/** largest inertia entry, force limit, or other gain */
#define PAPER_SO3_LSF_PRINTED_F32_MAX_PARAM 1.0e9F
#define PAPER_SO3_LSF_PRINTED_F32_MIN_GAIN 1.0e-9F /**< least gain */
#define PAPER_SO3_LSF_PRINTED_F32_MAX_RATE 1.0e4F /**< largest gain in 1/s */

/** What was found. The largest that applies is returned; from 16 on the whole command is zero. */
typedef enum {
    PAPER_SO3_LSF_PRINTED_F32_OK = 0, /**< the command is good */
    PAPER_SO3_LSF_PRINTED_F32_SATURATED = 1, /**< a force limit was reached */
    PAPER_SO3_LSF_PRINTED_F32_NEAR_CUT_LOCUS = 2, /**< the error is close to where the law jumps */
    /** the error is off the group by more than max_drift */
    PAPER_SO3_LSF_PRINTED_F32_NOT_ON_GROUP = 16,
    /** beyond MAX_INPUT, or too near a pole of the law */
    PAPER_SO3_LSF_PRINTED_F32_OUT_OF_RANGE = 17,
    /** an input, or what it leads to, is not finite */
    PAPER_SO3_LSF_PRINTED_F32_NONFINITE_INPUT = 18,
    PAPER_SO3_LSF_PRINTED_F32_BAD_PARAMS = 19 /**< found by check_params */
} paper_so3_lsf_printed_f32_status;

/** Inertia and gains, from the vehicle file or tuned on the target. */
typedef struct {
    float inertia[6]; /**< inertia, upper triangle, row by row [kg m^2] */
    float k; /**< gain of s [1/s] */
    float kappa; /**< gain of the attitude error [1/s^2] */
    float max_drift; /**< largest distance of the error from the group [1] */
} paper_so3_lsf_printed_f32_params;

/** What is measured. */
typedef struct {
    float g[9]; /**< configuration: rotation matrix, row by row [1] */
    float nu[3]; /**< body velocity [rad/s] */
} paper_so3_lsf_printed_f32_state;

/** Where to be, and how that moves. */
typedef struct {
    float g[9]; /**< reference configuration: rotation matrix, row by row [1] */
    float nu[3]; /**< reference velocity, reference body frame [rad/s] */
    float nu_dot[3]; /**< its rate [rad/s^2] */
} paper_so3_lsf_printed_f32_reference;

/** What is to be done, and what it was made of. */
typedef struct {
    float force[3]; /**< control force [N m] */
    float s[3]; /**< sliding variable [rad/s] */
    float nu_u[3]; /**< attitude error [rad] */
} paper_so3_lsf_printed_f32_command;

/** The vehicle file's inertia and gains. */
extern const paper_so3_lsf_printed_f32_params paper_so3_lsf_printed_f32_defaults;

/**
 * Judges the parameters, once at start-up.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @return OK; or BAD_PARAMS when one is not finite or out of range, the inertia not positive
 *     definite, or not zero where the derivation took that for granted
 */
paper_so3_lsf_printed_f32_status paper_so3_lsf_printed_f32_check_params(const
        paper_so3_lsf_printed_f32_params *params);

/**
 * The guarded controller, for parameters that were checked. Whatever bits the other inputs are
 * made of, all of the command is written, and it is finite.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] reference where to be, and how that moves
 * @param[out] command what is to be done, and what it was made of
 * @return the largest status that applies
 */
paper_so3_lsf_printed_f32_status paper_so3_lsf_printed_f32_control(const
        paper_so3_lsf_printed_f32_params *params,
        const paper_so3_lsf_printed_f32_state *state,
        const paper_so3_lsf_printed_f32_reference *reference,
        paper_so3_lsf_printed_f32_command *command);

/**
 * LSF force that tracks (g_r, nu_r); eq. (Ctrls2).
 * Unguarded: presumes what control checks. Cost: 103 operations, 28 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] reference where to be, and how that moves
 * @param[out] command what is to be done, and what it was made of
 */
void paper_so3_lsf_printed_f32_tracking(const paper_so3_lsf_printed_f32_params *params,
        const paper_so3_lsf_printed_f32_state *state,
        const paper_so3_lsf_printed_f32_reference *reference,
        paper_so3_lsf_printed_f32_command *command);

/**
 * Acceleration under a force, Euler-Poincare; eq. (EulerP).
 * Unguarded: presumes what control checks. Cost: 57 operations, 16 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] force applied force [N m]
 * @param[out] nu_dot body acceleration [rad/s^2]
 */
void paper_so3_lsf_printed_f32_plant(const paper_so3_lsf_printed_f32_params *params,
        const paper_so3_lsf_printed_f32_state *state, const float force[3], float nu_dot[3]);

#ifdef __cplusplus
}
#endif

#endif /* PAPER_SO3_LSF_PRINTED_F32_H */
