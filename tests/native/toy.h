/* A toy of the emitted shape: force = -k_s nu - lambda g_r + inertia . (1, .., 1); "comment; f(x);" */
#ifndef TOY_F64_H
#define TOY_F64_H

#include <stdint.h>

#define TOY_F64_MAX_NU 1.0e3 // rad/s
#define TOY_F64_MARGIN (-0x1p-3)
#define TOY_F64_ORDER 0x10u
#define TOY_F64_LONG \
    2.5F
#define TOY_F64_TEXT "not a number"

#ifdef __cplusplus
extern "C" {
#else
#define TOY_F64_IS_C 1
#endif

typedef enum {
    TOY_F64_OK = 0,
    TOY_F64_SATURATED = 1,
    TOY_F64_OUT_OF_RANGE = 17
} toy_f64_status;

typedef struct {
    double inertia[6];
    double lambda;
    double k_s;
} toy_f64_params;

typedef struct {
    double g[4];
    double nu[2];
} toy_f64_state;

typedef struct {
    double g[4];
    double nu[2];
    double nu_dot[2];
} toy_f64_reference;

typedef struct {
    double force[2];
    double s[2];
} toy_f64_command;

extern const toy_f64_params toy_f64_defaults;

toy_f64_status toy_f64_check_params(const toy_f64_params *params);

__attribute__((warn_unused_result)) toy_f64_status toy_f64_control(
    const toy_f64_params *params, const toy_f64_state *state,
    const toy_f64_reference *reference, toy_f64_command *command);

void toy_f64_tracking(const toy_f64_params *params, const toy_f64_state *state,
                      const toy_f64_reference *reference, toy_f64_command *command);

void toy_f64_reaching(const toy_f64_params *params, const toy_f64_state *state,
                      toy_f64_command *command);

void toy_f64_plant(const toy_f64_params *params, const toy_f64_state *state,
                   const double force[2], double nu_dot[2]);

#ifdef __cplusplus
}
#endif

#endif
