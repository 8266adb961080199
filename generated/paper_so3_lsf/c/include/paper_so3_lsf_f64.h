/**
 * @file
 * @brief paper_so3_lsf_f64: lsf on SO3, law {'name': 'tracking', 'doc': 'LSF force that tracks
 *     (g_r, nu_r)', 'source': 'eq. (Ctrls2) corrected', 'inputs': [{'name': 'inertia', 'size': 6,
 *     'unit': 'kg m^2', 'doc': 'inertia, upper triangle, row by row', 'source': '', 'is_scalar':
 *     False, 'holder': 'params', 'member': 'inertia', 'entries': [['inertia_0', 0], ['inertia_1',
 *     1], ['inertia_2', 2], ['inertia_3', 3], ['inertia_4', 4], ['inertia_5', 5]], 'argument':
 *     'inertia', 'shape': (6,)}, {'name': 'k', 'size': 1, 'unit': '1/s', 'doc': 'gain of s',
 *     'source': '', 'is_scalar': True, 'holder': 'params', 'member': 'k', 'entries': [['k', 0]],
 *     'argument': 'k', 'shape': (1,)}, {'name': 'kappa', 'size': 1, 'unit': '1/s^2', 'doc': 'gain
 *     of the attitude error', 'source': '', 'is_scalar': True, 'holder': 'params', 'member':
 *     'kappa', 'entries': [['kappa', 0]], 'argument': 'kappa', 'shape': (1,)}, {'name': 'nu',
 *     'size': 3, 'unit': 'rad/s', 'doc': 'body velocity', 'source': '', 'is_scalar': False,
 *     'holder': 'state', 'member': 'nu', 'entries': [['nu_0', 0], ['nu_1', 1], ['nu_2', 2]],
 *     'argument': 'nu', 'shape': (3,)}, {'name': 'nu_r', 'size': 3, 'unit': 'rad/s', 'doc':
 *     'reference velocity, reference body frame', 'source': '', 'is_scalar': False, 'holder':
 *     'reference', 'member': 'nu', 'entries': [['nu_r_0', 0], ['nu_r_1', 1], ['nu_r_2', 2]],
 *     'argument': 'nu_r', 'shape': (3,)}, {'name': 'nu_r_dot', 'size': 3, 'unit': 'rad/s^2', 'doc':
 *     'its rate', 'source': '', 'is_scalar': False, 'holder': 'reference', 'member': 'nu_dot',
 *     'entries': [['nu_r_dot_0', 0], ['nu_r_dot_1', 1], ['nu_r_dot_2', 2]], 'argument': 'nu_r_dot',
 *     'shape': (3,)}, {'name': 'g_e', 'size': 9, 'unit': '1', 'doc': 'error, g_r^-1 g', 'source':
 *     'eq. (velErr)', 'is_scalar': False, 'holder': '', 'member': 'g_e', 'entries': [['g_e_1', 1],
 *     ['g_e_2', 2], ['g_e_3', 3], ['g_e_5', 5], ['g_e_6', 6], ['g_e_7', 7]], 'argument': 'g_e',
 *     'shape': (9,)}], 'steps': [{'name': 'nu_u', 'size': 3, 'unit': 'rad', 'doc': 'attitude error,
 *     2 sin(angle) axis', 'source': 'eq. (s2)', 'is_scalar': False, 'holder': '', 'member': '',
 *     'names': ['nu_u_0', 'nu_u_1', 'nu_u_2'], 'lines': [['nu_u_0', 'g_e_7 - g_e_5'], ['nu_u_1',
 *     'g_e_2 - g_e_6'], ['nu_u_2', 'g_e_3 - g_e_1']], 'cases': []}, {'name': 'raw', 'size': 3,
 *     'unit': 'rad/s', 'doc': 'nu - nu_r, each in its own body frame', 'source': '', 'is_scalar':
 *     False, 'holder': '', 'member': '', 'names': ['raw_0', 'raw_1', 'raw_2'], 'lines': [['raw_0',
 *     'nu_0 - nu_r_0'], ['raw_1', 'nu_1 - nu_r_1'], ['raw_2', 'nu_2 - nu_r_2']], 'cases': []},
 *     {'name': 'ratio', 'size': 1, 'unit': '1/s', 'doc': 'kappa/k', 'source': '', 'is_scalar':
 *     True, 'holder': '', 'member': '', 'names': ['ratio'], 'lines': [['ratio', 'kappa/k']],
 *     'cases': []}, {'name': 's', 'size': 3, 'unit': 'rad/s', 'doc': 'sliding variable', 'source':
 *     'eq. (s2)', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['s_0', 's_1', 's_2'],
 *     'lines': [['s_0', 'raw_0 + nu_u_0*ratio'], ['s_1', 'raw_1 + nu_u_1*ratio'], ['s_2', 'raw_2 +
 *     nu_u_2*ratio']], 'cases': []}, {'name': 'crossing', 'size': 3, 'unit': 'rad/s^2', 'doc': 'nu
 *     x nu_r', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names':
 *     ['crossing_0', 'crossing_1', 'crossing_2'], 'lines': [['crossing_0', 'nu_1*nu_r_2 -
 *     nu_2*nu_r_1'], ['crossing_1', 'nu_2*nu_r_0 - nu_0*nu_r_2'], ['crossing_2', 'nu_0*nu_r_1 -
 *     nu_1*nu_r_0']], 'cases': []}, {'name': 'wanted', 'size': 3, 'unit': 'rad/s^2', 'doc':
 *     'acceleration asked for', 'source': '', 'is_scalar': False, 'holder': '', 'member': '',
 *     'names': ['wanted_0', 'wanted_1', 'wanted_2'], 'lines': [['wanted_0', 'crossing_0 +
 *     nu_r_dot_0 - k*s_0'], ['wanted_1', 'crossing_1 + nu_r_dot_1 - k*s_1'], ['wanted_2',
 *     'crossing_2 + nu_r_dot_2 - k*s_2']], 'cases': []}, {'name': 'momentum', 'size': 3, 'unit': 'N
 *     m s', 'doc': 'I nu', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names':
 *     ['momentum_0', 'momentum_1', 'momentum_2'], 'lines': [['momentum_0', 'inertia_0*nu_0 +
 *     inertia_1*nu_1 + inertia_2*nu_2'], ['momentum_1', 'inertia_1*nu_0 + inertia_3*nu_1 +
 *     inertia_4*nu_2'], ['momentum_2', 'inertia_2*nu_0 + inertia_4*nu_1 + inertia_5*nu_2']],
 *     'cases': []}, {'name': 'force', 'size': 3, 'unit': 'N m', 'doc': 'control force', 'source':
 *     'eq. (Ctrls2) corrected', 'is_scalar': False, 'holder': '', 'member': '', 'names':
 *     ['force_0', 'force_1', 'force_2'], 'lines': [['force_0', 'inertia_0*wanted_0 +
 *     inertia_1*wanted_1 + inertia_2*wanted_2 + momentum_2*nu_1 - momentum_1*nu_2'], ['force_1',
 *     'inertia_1*wanted_0 + inertia_3*wanted_1 + inertia_4*wanted_2 + momentum_0*nu_2 -
 *     momentum_2*nu_0'], ['force_2', 'inertia_2*wanted_0 + inertia_4*wanted_1 + inertia_5*wanted_2
 *     + momentum_1*nu_0 - momentum_0*nu_1']], 'cases': []}], 'outputs': [{'name': 'force', 'size':
 *     3, 'unit': 'N m', 'doc': 'control force', 'source': '', 'is_scalar': False, 'holder':
 *     'command', 'member': 'force', 'entries': ['force_0', 'force_1', 'force_2']}, {'name': 's',
 *     'size': 3, 'unit': 'rad/s', 'doc': 'sliding variable', 'source': '', 'is_scalar': False,
 *     'holder': 'command', 'member': 's', 'entries': ['s_0', 's_1', 's_2']}, {'name': 'nu_u',
 *     'size': 3, 'unit': 'rad', 'doc': 'attitude error', 'source': '', 'is_scalar': False,
 *     'holder': 'command', 'member': 'nu_u', 'entries': ['nu_u_0', 'nu_u_1', 'nu_u_2']}, {'name':
 *     'clearance', 'size': 1, 'unit': '1', 'doc': 'distance from the cut locus of the law',
 *     'source': '', 'is_scalar': True, 'holder': '', 'member': 'clearance', 'entries': ['1.0']}],
 *     'operations': 73, 'temporaries': 22, 'symbol': 'tracking', 'is_public': False, 'holders':
 *     ['params', 'state', 'reference'], 'arguments': ['nu', 'nu_r', 'nu_r_dot', 'g_e'],
 *     'has_reference': True, 'writes': ['command', 'clearance'], 'public_writes': ['command',
 *     'clearance']}, double precision.
 *
 * Generated by derive from the vehicle file paper_so3_lsf.toml; regenerate instead of editing.
 *
 * - Use: paper_so3_lsf_f64_check_params once at start-up, then paper_so3_lsf_f64_control at every
 *   instant.
 * - Units: SI; they stand in brackets beside each number.
 * - Frames: velocities and forces are in the body frame; the reference's in the reference's own.
 * - Configuration g: rotation matrix, row by row.
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
#ifndef PAPER_SO3_LSF_F64_H
#define PAPER_SO3_LSF_F64_H

#ifdef __cplusplus
extern "C" {
#endif

/** largest magnitude of a number in state or reference */
#define PAPER_SO3_LSF_F64_MAX_INPUT 1.0e6
#define PAPER_SO3_LSF_F64_MAX_ENTRY 1.01 /**< of an entry of the error that the group keeps at 1 */
#define PAPER_SO3_LSF_F64_MAX_REACH 4.0e6 /**< of any other entry of the error */
#define PAPER_SO3_LSF_F64_MOST_DRIFT 0.1 /**< largest max_drift that may be asked for */
#define PAPER_SO3_LSF_F64_NEAR_CUT 0.001 /**< clearance below which NEAR_CUT_LOCUS is flagged */
#define PAPER_SO3_LSF_F64_MAX_PARAM 1.0e9 /**< largest inertia entry, force limit, or other gain */
#define PAPER_SO3_LSF_F64_MIN_GAIN 1.0e-9 /**< least gain */
#define PAPER_SO3_LSF_F64_MAX_RATE 1.0e4 /**< largest gain in 1/s */

/** What was found. The largest that applies is returned; from 16 on the whole command is zero. */
typedef enum {
    PAPER_SO3_LSF_F64_OK = 0, /**< the command is good */
    PAPER_SO3_LSF_F64_SATURATED = 1, /**< a force limit was reached */
    PAPER_SO3_LSF_F64_NEAR_CUT_LOCUS = 2, /**< the error is close to where the law jumps */
    PAPER_SO3_LSF_F64_NOT_ON_GROUP = 16, /**< the error is off the group by more than max_drift */
    PAPER_SO3_LSF_F64_OUT_OF_RANGE = 17, /**< beyond MAX_INPUT, or too near a pole of the law */
    PAPER_SO3_LSF_F64_NONFINITE_INPUT = 18, /**< an input, or what it leads to, is not finite */
    PAPER_SO3_LSF_F64_BAD_PARAMS = 19 /**< found by check_params */
} paper_so3_lsf_f64_status;

/** Inertia and gains, from the vehicle file or tuned on the target. */
typedef struct {
    double inertia[6]; /**< inertia, upper triangle, row by row [kg m^2] */
    double k; /**< gain of s [1/s] */
    double kappa; /**< gain of the attitude error [1/s^2] */
    double max_drift; /**< largest distance of the error from the group [1] */
} paper_so3_lsf_f64_params;

/** What is measured. */
typedef struct {
    double g[9]; /**< configuration: rotation matrix, row by row [1] */
    double nu[3]; /**< body velocity [rad/s] */
} paper_so3_lsf_f64_state;

/** Where to be, and how that moves. */
typedef struct {
    double g[9]; /**< reference configuration: rotation matrix, row by row [1] */
    double nu[3]; /**< reference velocity, reference body frame [rad/s] */
    double nu_dot[3]; /**< its rate [rad/s^2] */
} paper_so3_lsf_f64_reference;

/** What is to be done, and what it was made of. */
typedef struct {
    double force[3]; /**< control force [N m] */
    double s[3]; /**< sliding variable [rad/s] */
    double nu_u[3]; /**< attitude error [rad] */
} paper_so3_lsf_f64_command;

/** The vehicle file's inertia and gains. */
extern const paper_so3_lsf_f64_params paper_so3_lsf_f64_defaults;

/**
 * Judges the parameters, once at start-up.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @return OK; or BAD_PARAMS when one is not finite or out of range, the inertia not positive
 *     definite, or not zero where the derivation took that for granted
 */
paper_so3_lsf_f64_status paper_so3_lsf_f64_check_params(const paper_so3_lsf_f64_params *params);

/**
 * The guarded controller, for parameters that were checked. Whatever bits the other inputs are
 * made of, all of the command is written, and it is finite.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] reference where to be, and how that moves
 * @param[out] command what is to be done, and what it was made of
 * @return the largest status that applies
 */
paper_so3_lsf_f64_status paper_so3_lsf_f64_control(const paper_so3_lsf_f64_params *params,
        const paper_so3_lsf_f64_state *state, const paper_so3_lsf_f64_reference *reference,
        paper_so3_lsf_f64_command *command);

/**
 * LSF force that tracks (g_r, nu_r); eq. (Ctrls2) corrected.
 * Unguarded: presumes what control checks. Cost: 103 operations, 28 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] reference where to be, and how that moves
 * @param[out] command what is to be done, and what it was made of
 */
void paper_so3_lsf_f64_tracking(const paper_so3_lsf_f64_params *params,
        const paper_so3_lsf_f64_state *state, const paper_so3_lsf_f64_reference *reference,
        paper_so3_lsf_f64_command *command);

/**
 * Acceleration under a force, Euler-Poincare; eq. (EulerP).
 * Unguarded: presumes what control checks. Cost: 57 operations, 16 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] force applied force [N m]
 * @param[out] nu_dot body acceleration [rad/s^2]
 */
void paper_so3_lsf_f64_plant(const paper_so3_lsf_f64_params *params,
        const paper_so3_lsf_f64_state *state, const double force[3], double nu_dot[3]);

#ifdef __cplusplus
}
#endif

#endif /* PAPER_SO3_LSF_F64_H */
