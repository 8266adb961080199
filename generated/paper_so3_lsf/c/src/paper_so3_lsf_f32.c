/*
 * paper_so3_lsf_f32: lsf on SO3, law skew (sin(angle) axis), float precision.
 * Every step below carries its quantity, unit and equation; trace.csv lists them by line.
 */
#include "paper_so3_lsf_f32.h"

#include <math.h>

/* that none is null: a precondition, which the self-test checks */
#ifdef PAPER_SO3_LSF_CHECK_POINTERS
#include <stddef.h>
#endif

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "leave out -ffast-math, -Ofast, -ffinite-math-only: control must see NaN and infinity"
#endif

#if defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "leave out -funsafe-math-optimizations: every target must round alike"
#endif

#if defined(__FLT_EVAL_METHOD__) && (__FLT_EVAL_METHOD__ == 1 || __FLT_EVAL_METHOD__ == 2)
#error "numbers must be rounded to their own type: with x87, give -msse2 -mfpmath=sse"
#endif

#if !defined(__GNUC__) || defined(__clang__)
#pragma STDC FP_CONTRACT OFF /* gcc: -ffp-contract=off */
#endif

const paper_so3_lsf_f32_params paper_so3_lsf_f32_defaults = {
    {3.6046F, -0.0706F, 0.1491F, 8.6868F, 0.0449F, 9.3484F},
    1.0F, /* k */
    0.5F, /* kappa */
    0.0001F /* max_drift */
};

/* A command that asks for nothing; number by number, since memset is of no use without libc. */
static void paper_so3_lsf_f32_nothing(paper_so3_lsf_f32_command *command)
{
    command->force[0] = 0.0F;
    command->force[1] = 0.0F;
    command->force[2] = 0.0F;
    command->s[0] = 0.0F;
    command->s[1] = 0.0F;
    command->s[2] = 0.0F;
    command->nu_u[0] = 0.0F;
    command->nu_u[1] = 0.0F;
    command->nu_u[2] = 0.0F;
}

/* LSF force that tracks (g_r, nu_r); eq. (Ctrls2) corrected, past the error. Gives its clearance, 0
   where the law jumps. */
static float paper_so3_lsf_f32_law(const paper_so3_lsf_f32_params *params,
        const paper_so3_lsf_f32_state *state, const paper_so3_lsf_f32_reference *reference,
        paper_so3_lsf_f32_command *command, const float g_e_1, const float g_e_2, const float g_e_3,
        const float g_e_5, const float g_e_6, const float g_e_7)
{
    /* -- tracking -- */
    const float inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_3 = params->inertia[3],
        inertia_4 = params->inertia[4], inertia_5 = params->inertia[5];
    const float k = params->k;
    const float kappa = params->kappa;
    const float nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2];
    const float nu_r_0 = reference->nu[0], nu_r_1 = reference->nu[1], nu_r_2 = reference->nu[2];
    const float nu_r_dot_0 = reference->nu_dot[0], nu_r_dot_1 = reference->nu_dot[1],
        nu_r_dot_2 = reference->nu_dot[2];

    /* nu_u: attitude error, 2 sin(angle) axis [rad], eq. (s2) */
    const float nu_u_0 = g_e_7 - g_e_5;
    const float nu_u_1 = g_e_2 - g_e_6;
    const float nu_u_2 = g_e_3 - g_e_1;

    /* raw: nu - nu_r, each in its own body frame [rad/s] */
    const float raw_0 = nu_0 - nu_r_0;
    const float raw_1 = nu_1 - nu_r_1;
    const float raw_2 = nu_2 - nu_r_2;

    /* ratio: kappa/k [1/s] */
    const float ratio = kappa/k;

    /* s: sliding variable [rad/s], eq. (s2) */
    const float s_0 = raw_0 + nu_u_0*ratio;
    const float s_1 = raw_1 + nu_u_1*ratio;
    const float s_2 = raw_2 + nu_u_2*ratio;

    /* crossing: nu x nu_r [rad/s^2] */
    const float crossing_0 = nu_1*nu_r_2 - nu_2*nu_r_1;
    const float crossing_1 = nu_2*nu_r_0 - nu_0*nu_r_2;
    const float crossing_2 = nu_0*nu_r_1 - nu_1*nu_r_0;

    /* wanted: acceleration asked for [rad/s^2] */
    const float wanted_0 = crossing_0 + nu_r_dot_0 - k*s_0;
    const float wanted_1 = crossing_1 + nu_r_dot_1 - k*s_1;
    const float wanted_2 = crossing_2 + nu_r_dot_2 - k*s_2;

    /* momentum: I nu [N m s] */
    const float momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2;
    const float momentum_1 = inertia_1*nu_0 + inertia_3*nu_1 + inertia_4*nu_2;
    const float momentum_2 = inertia_2*nu_0 + inertia_4*nu_1 + inertia_5*nu_2;

    /* force: control force [N m], eq. (Ctrls2) corrected */
    const float force_0 = inertia_0*wanted_0 + inertia_1*wanted_1 + inertia_2*wanted_2 +
        momentum_2*nu_1 - momentum_1*nu_2;
    const float force_1 = inertia_1*wanted_0 + inertia_3*wanted_1 + inertia_4*wanted_2 +
        momentum_0*nu_2 - momentum_2*nu_0;
    const float force_2 = inertia_2*wanted_0 + inertia_4*wanted_1 + inertia_5*wanted_2 +
        momentum_1*nu_0 - momentum_0*nu_1;

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
    return 1.0F;
}

/* pivots of the inertia: all positive for a valid one. */
static void paper_so3_lsf_f32_definiteness(const paper_so3_lsf_f32_params *params, float pivot[3])
{
    /* -- definiteness -- */
    const float inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_3 = params->inertia[3],
        inertia_4 = params->inertia[4], inertia_5 = params->inertia[5];

    /* divisor_0: the pivot, or 1 where it is not positive [kg m^2] */
    float divisor_0;
    if (inertia_0 > 0.0F) {
        divisor_0 = inertia_0;
    } else {
        divisor_0 = 1.0F;
    }

    /* lower_10: I = L D L^T, entry of L [1] */
    const float lower_10 = inertia_1/divisor_0;

    /* lower_20: I = L D L^T, entry of L [1] */
    const float lower_20 = inertia_2/divisor_0;

    /* pivot_1: pivot of I [kg m^2] */
    const float pivot_1 = inertia_3 - inertia_0*lower_10*lower_10;

    /* divisor_1: the pivot, or 1 where it is not positive [kg m^2] */
    float divisor_1;
    if (pivot_1 > 0.0F) {
        divisor_1 = pivot_1;
    } else {
        divisor_1 = 1.0F;
    }

    /* lower_21: I = L D L^T, entry of L [1] */
    const float lower_21 = (inertia_4 - inertia_0*lower_10*lower_20)/divisor_1;

    /* pivot_2: pivot of I [kg m^2] */
    const float pivot_2 = inertia_5 - inertia_0*lower_20*lower_20 - pivot_1*lower_21*lower_21;

    /* -- end -- */
    pivot[0] = inertia_0;
    pivot[1] = pivot_1;
    pivot[2] = pivot_2;
}

void paper_so3_lsf_f32_tracking(const paper_so3_lsf_f32_params *params,
        const paper_so3_lsf_f32_state *state, const paper_so3_lsf_f32_reference *reference,
        paper_so3_lsf_f32_command *command)
{
    /* -- tracking -- */
    const float g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5], g_6 = state->g[6], g_7 = state->g[7],
        g_8 = state->g[8];
    const float g_r_0 = reference->g[0], g_r_1 = reference->g[1], g_r_2 = reference->g[2],
        g_r_3 = reference->g[3], g_r_4 = reference->g[4], g_r_5 = reference->g[5],
        g_r_6 = reference->g[6], g_r_7 = reference->g[7], g_r_8 = reference->g[8];

    /* g_e: error, g_r^-1 g [1], eq. (velErr) */
    const float g_e_1 = g_1*g_r_0 + g_4*g_r_3 + g_7*g_r_6;
    const float g_e_2 = g_2*g_r_0 + g_5*g_r_3 + g_8*g_r_6;
    const float g_e_3 = g_0*g_r_1 + g_3*g_r_4 + g_6*g_r_7;
    const float g_e_5 = g_2*g_r_1 + g_5*g_r_4 + g_8*g_r_7;
    const float g_e_6 = g_0*g_r_2 + g_3*g_r_5 + g_6*g_r_8;
    const float g_e_7 = g_1*g_r_2 + g_4*g_r_5 + g_7*g_r_8;

    /* -- end -- */
    (void)paper_so3_lsf_f32_law(params, state, reference, command, g_e_1, g_e_2, g_e_3, g_e_5,
            g_e_6, g_e_7);
}

void paper_so3_lsf_f32_plant(const paper_so3_lsf_f32_params *params,
        const paper_so3_lsf_f32_state *state, const float force[3], float nu_dot[3])
{
    /* -- plant -- */
    const float inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_3 = params->inertia[3],
        inertia_4 = params->inertia[4], inertia_5 = params->inertia[5];
    const float nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2];
    const float force_0 = force[0], force_1 = force[1], force_2 = force[2];

    /* momentum: I nu [N m s] */
    const float momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2;
    const float momentum_1 = inertia_1*nu_0 + inertia_3*nu_1 + inertia_4*nu_2;
    const float momentum_2 = inertia_2*nu_0 + inertia_4*nu_1 + inertia_5*nu_2;

    /* total: coad(nu) I nu + force [N m] */
    const float total_0 = force_0 + momentum_1*nu_2 - momentum_2*nu_1;
    const float total_1 = force_1 + momentum_2*nu_0 - momentum_0*nu_2;
    const float total_2 = force_2 + momentum_0*nu_1 - momentum_1*nu_0;

    /* lower_10: I = L D L^T, entry of L [1] */
    const float lower_10 = inertia_1/inertia_0;

    /* lower_20: I = L D L^T, entry of L [1] */
    const float lower_20 = inertia_2/inertia_0;

    /* pivot_1: pivot of I [kg m^2] */
    const float pivot_1 = inertia_3 - inertia_0*lower_10*lower_10;

    /* lower_21: I = L D L^T, entry of L [1] */
    const float lower_21 = (inertia_4 - inertia_0*lower_10*lower_20)/pivot_1;

    /* pivot_2: pivot of I [kg m^2] */
    const float pivot_2 = inertia_5 - inertia_0*lower_20*lower_20 - pivot_1*lower_21*lower_21;

    /* forward_1: forward substitution [N m] */
    const float forward_1 = total_1 - lower_10*total_0;

    /* forward_2: forward substitution [N m] */
    const float forward_2 = total_2 - forward_1*lower_21 - lower_20*total_0;

    /* back_2: back substitution [rad/s^2] */
    const float back_2 = forward_2/pivot_2;

    /* back_1: back substitution [rad/s^2] */
    const float back_1 = forward_1/pivot_1 - back_2*lower_21;

    /* back_0: back substitution [rad/s^2] */
    const float back_0 = total_0/inertia_0 - back_1*lower_10 - back_2*lower_20;

    /* -- end -- */
    nu_dot[0] = back_0;
    nu_dot[1] = back_1;
    nu_dot[2] = back_2;
}

/* The worse of two findings. */
static paper_so3_lsf_f32_status paper_so3_lsf_f32_worse(const paper_so3_lsf_f32_status a,
        const paper_so3_lsf_f32_status b)
{
    return a > b ? a : b;
}

/* OUT_OF_RANGE or NONFINITE_INPUT if any number is larger than a limit or not finite. */
static paper_so3_lsf_f32_status paper_so3_lsf_f32_inspect(const float *numbers, const int count,
        const float limit)
{
    paper_so3_lsf_f32_status worst = PAPER_SO3_LSF_F32_OK;
    int i;
    for (i = 0; i < count; i++) {
        if (!isfinite(numbers[i])) {
            worst = PAPER_SO3_LSF_F32_NONFINITE_INPUT;
        } else if (fabsf(numbers[i]) > limit) {
            worst = paper_so3_lsf_f32_worse(worst, PAPER_SO3_LSF_F32_OUT_OF_RANGE);
        } else {
            /* finite and in range: it leaves the finding as it is */
        }
    }
    return worst;
}

/* Zero command; its status says what is wrong with what was refused, at least what was found. */
static paper_so3_lsf_f32_status paper_so3_lsf_f32_refuse(const paper_so3_lsf_f32_state *state,
        const paper_so3_lsf_f32_reference *reference, const paper_so3_lsf_f32_status found,
        paper_so3_lsf_f32_command *command)
{
    paper_so3_lsf_f32_status worst = found;
    worst = paper_so3_lsf_f32_worse(worst,
            paper_so3_lsf_f32_inspect(state->g, 9, PAPER_SO3_LSF_F32_MAX_INPUT));
    worst = paper_so3_lsf_f32_worse(worst,
            paper_so3_lsf_f32_inspect(state->nu, 3, PAPER_SO3_LSF_F32_MAX_INPUT));
    worst = paper_so3_lsf_f32_worse(worst,
            paper_so3_lsf_f32_inspect(reference->g, 9, PAPER_SO3_LSF_F32_MAX_INPUT));
    worst = paper_so3_lsf_f32_worse(worst,
            paper_so3_lsf_f32_inspect(reference->nu, 3, PAPER_SO3_LSF_F32_MAX_INPUT));
    worst = paper_so3_lsf_f32_worse(worst,
            paper_so3_lsf_f32_inspect(reference->nu_dot, 3, PAPER_SO3_LSF_F32_MAX_INPUT));
    paper_so3_lsf_f32_nothing(command);
    return worst;
}

/* What a computed command is worth. */
static paper_so3_lsf_f32_status paper_so3_lsf_f32_verdict(paper_so3_lsf_f32_command *command)
{
    if (!(isfinite(command->force[0]) && isfinite(command->force[1]) &&
            isfinite(command->force[2]))) {
        paper_so3_lsf_f32_nothing(command);
        return PAPER_SO3_LSF_F32_NONFINITE_INPUT;
    }
    return PAPER_SO3_LSF_F32_OK;
}

paper_so3_lsf_f32_status paper_so3_lsf_f32_control(const paper_so3_lsf_f32_params *params,
        const paper_so3_lsf_f32_state *state, const paper_so3_lsf_f32_reference *reference,
        paper_so3_lsf_f32_command *command)
{
#ifdef PAPER_SO3_LSF_CHECK_POINTERS
    if (params == NULL || state == NULL || reference == NULL || command == NULL) {
        if (command != NULL) {
            paper_so3_lsf_f32_nothing(command);
        }
        return PAPER_SO3_LSF_F32_BAD_PARAMS;
    }
#endif
    /* -- tracking -- */
    const float g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5], g_6 = state->g[6], g_7 = state->g[7],
        g_8 = state->g[8];
    const float g_r_0 = reference->g[0], g_r_1 = reference->g[1], g_r_2 = reference->g[2],
        g_r_3 = reference->g[3], g_r_4 = reference->g[4], g_r_5 = reference->g[5],
        g_r_6 = reference->g[6], g_r_7 = reference->g[7], g_r_8 = reference->g[8];

    /* g_e: error, g_r^-1 g [1], eq. (velErr) */
    const float g_e_0 = g_0*g_r_0 + g_3*g_r_3 + g_6*g_r_6;
    const float g_e_1 = g_1*g_r_0 + g_4*g_r_3 + g_7*g_r_6;
    const float g_e_2 = g_2*g_r_0 + g_5*g_r_3 + g_8*g_r_6;
    const float g_e_3 = g_0*g_r_1 + g_3*g_r_4 + g_6*g_r_7;
    const float g_e_4 = g_1*g_r_1 + g_4*g_r_4 + g_7*g_r_7;
    const float g_e_5 = g_2*g_r_1 + g_5*g_r_4 + g_8*g_r_7;
    const float g_e_6 = g_0*g_r_2 + g_3*g_r_5 + g_6*g_r_8;
    const float g_e_7 = g_1*g_r_2 + g_4*g_r_5 + g_7*g_r_8;
    const float g_e_8 = g_2*g_r_2 + g_5*g_r_5 + g_8*g_r_8;

    /* -- end -- */
    if (!(fabsf(g_e_0) <= PAPER_SO3_LSF_F32_MAX_ENTRY && fabsf(g_e_1) <= PAPER_SO3_LSF_F32_MAX_ENTRY
            && fabsf(g_e_2) <= PAPER_SO3_LSF_F32_MAX_ENTRY
            && fabsf(g_e_3) <= PAPER_SO3_LSF_F32_MAX_ENTRY
            && fabsf(g_e_4) <= PAPER_SO3_LSF_F32_MAX_ENTRY
            && fabsf(g_e_5) <= PAPER_SO3_LSF_F32_MAX_ENTRY
            && fabsf(g_e_6) <= PAPER_SO3_LSF_F32_MAX_ENTRY
            && fabsf(g_e_7) <= PAPER_SO3_LSF_F32_MAX_ENTRY
            && fabsf(g_e_8) <= PAPER_SO3_LSF_F32_MAX_ENTRY
            && fabsf(state->nu[0]) <= PAPER_SO3_LSF_F32_MAX_INPUT
            && fabsf(state->nu[1]) <= PAPER_SO3_LSF_F32_MAX_INPUT
            && fabsf(state->nu[2]) <= PAPER_SO3_LSF_F32_MAX_INPUT
            && fabsf(reference->nu[0]) <= PAPER_SO3_LSF_F32_MAX_INPUT
            && fabsf(reference->nu[1]) <= PAPER_SO3_LSF_F32_MAX_INPUT
            && fabsf(reference->nu[2]) <= PAPER_SO3_LSF_F32_MAX_INPUT
            && fabsf(reference->nu_dot[0]) <= PAPER_SO3_LSF_F32_MAX_INPUT
            && fabsf(reference->nu_dot[1]) <= PAPER_SO3_LSF_F32_MAX_INPUT
            && fabsf(reference->nu_dot[2]) <= PAPER_SO3_LSF_F32_MAX_INPUT)) {
        return paper_so3_lsf_f32_refuse(state, reference, PAPER_SO3_LSF_F32_NOT_ON_GROUP, command);
    }
    /* -- drift -- */

    /* off: what vanishes on the group, and only there [1] */
    const float off_0 = g_e_0*g_e_0 - 1.0F + g_e_3*g_e_3 + g_e_6*g_e_6;
    const float off_1 = g_e_0*g_e_1 + g_e_3*g_e_4 + g_e_6*g_e_7;
    const float off_2 = g_e_1*g_e_1 - 1.0F + g_e_4*g_e_4 + g_e_7*g_e_7;
    const float off_3 = g_e_2 + g_e_4*g_e_6 - g_e_3*g_e_7;
    const float off_4 = g_e_5 + g_e_0*g_e_7 - g_e_1*g_e_6;
    const float off_5 = g_e_8 + g_e_1*g_e_3 - g_e_0*g_e_4;

    /* drift: square of the distance from the group [1] */
    const float drift = off_0*off_0 + off_1*off_1 + off_2*off_2 + off_3*off_3 + off_4*off_4 +
        off_5*off_5;

    /* -- end -- */

    if (!(drift < params->max_drift*params->max_drift)) {
        return paper_so3_lsf_f32_refuse(state, reference, PAPER_SO3_LSF_F32_NOT_ON_GROUP, command);
    }
    (void)paper_so3_lsf_f32_law(params, state, reference, command, g_e_1, g_e_2, g_e_3, g_e_5,
            g_e_6, g_e_7);
    return paper_so3_lsf_f32_verdict(command);
}

paper_so3_lsf_f32_status paper_so3_lsf_f32_check_params(const paper_so3_lsf_f32_params *params)
{
#ifdef PAPER_SO3_LSF_CHECK_POINTERS
    if (params == NULL) {
        return PAPER_SO3_LSF_F32_BAD_PARAMS;
    }
#endif
    float pivot[3];
    int i;
    if (paper_so3_lsf_f32_inspect(params->inertia, 6, PAPER_SO3_LSF_F32_MAX_PARAM) !=
            PAPER_SO3_LSF_F32_OK) {
        return PAPER_SO3_LSF_F32_BAD_PARAMS;
    }
    if (!(params->k >= PAPER_SO3_LSF_F32_MIN_GAIN && params->k <= PAPER_SO3_LSF_F32_MAX_RATE)) {
        return PAPER_SO3_LSF_F32_BAD_PARAMS;
    }
    if (!(params->kappa >= PAPER_SO3_LSF_F32_MIN_GAIN && params->kappa <=
            PAPER_SO3_LSF_F32_MAX_PARAM)) {
        return PAPER_SO3_LSF_F32_BAD_PARAMS;
    }
    if (!(params->max_drift >= PAPER_SO3_LSF_F32_LEAST_DRIFT && params->max_drift <=
            PAPER_SO3_LSF_F32_MOST_DRIFT)) {
        return PAPER_SO3_LSF_F32_BAD_PARAMS;
    }
    paper_so3_lsf_f32_definiteness(params, pivot);
    for (i = 0; i < 3; i++) {
        if (!(pivot[i] > 0.0F)) {
            return PAPER_SO3_LSF_F32_BAD_PARAMS;
        }
    }
    return PAPER_SO3_LSF_F32_OK;
}
