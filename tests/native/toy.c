#include "toy.h"

const toy_f64_params toy_f64_defaults = {{1.0, 2.0, 3.0, 4.0, 5.0, 6.0}, 0.5, 2.0};

toy_f64_status toy_f64_check_params(const toy_f64_params *params)
{
    return params->k_s > 0.0 ? TOY_F64_OK : TOY_F64_OUT_OF_RANGE;
}

void toy_f64_tracking(const toy_f64_params *params, const toy_f64_state *state,
                      const toy_f64_reference *reference, toy_f64_command *command)
{
    for (int i = 0; i < 2; ++i) {
        command->s[i] = state->nu[i] - reference->nu[i] + params->lambda * state->g[i];
        command->force[i] = params->inertia[i] * reference->nu_dot[i] - params->k_s * command->s[i]
                            + reference->g[i + 2];
    }
}

void toy_f64_reaching(const toy_f64_params *params, const toy_f64_state *state,
                      toy_f64_command *command)
{
    const toy_f64_reference none = {{0.0, 0.0, 0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}};
    toy_f64_tracking(params, state, &none, command);
}

toy_f64_status toy_f64_control(const toy_f64_params *params, const toy_f64_state *state,
                               const toy_f64_reference *reference, toy_f64_command *command)
{
    toy_f64_tracking(params, state, reference, command);
    return state->nu[0] > TOY_F64_MAX_NU ? TOY_F64_OUT_OF_RANGE : TOY_F64_OK;
}

void toy_f64_plant(const toy_f64_params *params, const toy_f64_state *state,
                   const double force[2], double nu_dot[2])
{
    nu_dot[0] = (force[0] + state->nu[1]) / params->inertia[0];
    nu_dot[1] = (force[1] - state->nu[0]) / params->inertia[1];
}
