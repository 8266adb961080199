/*
 * sl2_f64: gsmc on SL2, law skew (vee(g - g^-1)/2), double precision.
 * Every step below carries its quantity, unit and equation; trace.csv lists them by line.
 */
#include "sl2_f64.h"

#include <math.h>

#ifdef SL2_CHECK_POINTERS /* that none is null: a precondition, which the self-test checks */
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

const sl2_f64_params sl2_f64_defaults = {
    {2.0, 0.3, 0.1, 1.5, -0.2, 2.5},
    0.5, /* lambda */
    1.0, /* k_s */
    1.0e-6 /* max_drift */
};

/* A command that asks for nothing; number by number, since memset is of no use without libc. */
static void sl2_f64_nothing(sl2_f64_command *command)
{
    command->force[0] = 0.0;
    command->force[1] = 0.0;
    command->force[2] = 0.0;
    command->s[0] = 0.0;
    command->s[1] = 0.0;
    command->s[2] = 0.0;
    command->nu_u[0] = 0.0;
    command->nu_u[1] = 0.0;
    command->nu_u[2] = 0.0;
    command->nu_u_dot[0] = 0.0;
    command->nu_u_dot[1] = 0.0;
    command->nu_u_dot[2] = 0.0;
}

/* force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl), past the error. Gives its clearance, 0
   where the law jumps. */
static double sl2_f64_law(const sl2_f64_params *params, const sl2_f64_state *state,
        const sl2_f64_reference *reference, sl2_f64_command *command, const double g_e_0,
        const double g_e_1, const double g_e_2, const double g_e_3)
{
    /* -- tracking -- */
    const double inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_3 = params->inertia[3],
        inertia_4 = params->inertia[4], inertia_5 = params->inertia[5];
    const double rate_gain = params->lambda;
    const double reach_gain = params->k_s;
    const double nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2];
    const double nu_r_0 = reference->nu[0], nu_r_1 = reference->nu[1], nu_r_2 = reference->nu[2];
    const double nu_r_dot_0 = reference->nu_dot[0], nu_r_dot_1 = reference->nu_dot[1],
        nu_r_dot_2 = reference->nu_dot[2];

    /* to_body: Ad of g_e^-1: reference to body frame [1] */
    const double to_body_0 = g_e_3*g_e_3;
    const double to_body_1 = -g_e_1*g_e_1;
    const double to_body_2 = 2.0*g_e_1*g_e_3;
    const double to_body_3 = -g_e_2*g_e_2;
    const double to_body_4 = g_e_0*g_e_0;
    const double to_body_5 = -2.0*g_e_0*g_e_2;
    const double to_body_6 = g_e_2*g_e_3;
    const double to_body_7 = -g_e_0*g_e_1;
    const double to_body_8 = g_e_0*g_e_3 + g_e_1*g_e_2;

    /* eta: reference velocity in the body frame [1/s], eq. (velErr) */
    const double eta_0 = nu_r_0*to_body_0 + nu_r_1*to_body_1 + nu_r_2*to_body_2;
    const double eta_1 = nu_r_0*to_body_3 + nu_r_1*to_body_4 + nu_r_2*to_body_5;
    const double eta_2 = nu_r_0*to_body_6 + nu_r_1*to_body_7 + nu_r_2*to_body_8;

    /* nu_e: velocity error [1/s], eq. (velErr) */
    const double nu_e_0 = nu_0 - eta_0;
    const double nu_e_1 = nu_1 - eta_1;
    const double nu_e_2 = nu_2 - eta_2;

    /* eta_dot: exact rate of eta [1/s^2] */
    const double eta_dot_0 = nu_r_dot_0*to_body_0 + nu_r_dot_1*to_body_1 + nu_r_dot_2*to_body_2 -
        2.0*eta_0*nu_e_2 + 2.0*eta_2*nu_e_0;
    const double eta_dot_1 = nu_r_dot_0*to_body_3 + nu_r_dot_1*to_body_4 + nu_r_dot_2*to_body_5 -
        2.0*eta_2*nu_e_1 + 2.0*eta_1*nu_e_2;
    const double eta_dot_2 = eta_0*nu_e_1 + nu_r_dot_0*to_body_6 + nu_r_dot_1*to_body_7 +
        nu_r_dot_2*to_body_8 - eta_1*nu_e_0;

    /* nu_u: kinematic law, vee(g - g^-1)/2 [1], def. (KctrLaw) */
    const double nu_u_2 = 0.5*(g_e_0 - g_e_3);

    /* nu_u_dot: exact rate of nu_u [1/s] */
    const double nu_u_dot_0 = g_e_0*nu_e_0 - g_e_1*nu_e_2;
    const double nu_u_dot_1 = g_e_2*nu_e_2 + g_e_3*nu_e_1;
    const double nu_u_dot_2 = 0.5*(g_e_0*nu_e_2 + g_e_1*nu_e_1 + g_e_3*nu_e_2 - g_e_2*nu_e_0);

    /* drive: lambda nu_u [1/s] */
    const double drive_0 = g_e_1*rate_gain;
    const double drive_1 = g_e_2*rate_gain;
    const double drive_2 = nu_u_2*rate_gain;

    /* s: sliding variable [1/s], eq. (SurfaceErr) */
    const double s_0 = drive_0 + nu_e_0;
    const double s_1 = drive_1 + nu_e_1;
    const double s_2 = drive_2 + nu_e_2;

    /* wanted: acceleration asked for [1/s^2] */
    const double wanted_0 = eta_dot_0 - nu_u_dot_0*rate_gain - reach_gain*s_0;
    const double wanted_1 = eta_dot_1 - nu_u_dot_1*rate_gain - reach_gain*s_1;
    const double wanted_2 = eta_dot_2 - nu_u_dot_2*rate_gain - reach_gain*s_2;

    /* turning: lambda nu_u - eta [1/s] */
    const double turning_0 = drive_0 - eta_0;
    const double turning_1 = drive_1 - eta_1;
    const double turning_2 = drive_2 - eta_2;

    /* momentum: I nu [J s] */
    const double momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2;
    const double momentum_1 = inertia_1*nu_0 + inertia_3*nu_1 + inertia_4*nu_2;
    const double momentum_2 = inertia_2*nu_0 + inertia_4*nu_1 + inertia_5*nu_2;

    /* force: control force, I f_u [J], eq. (TckCtrl) */
    const double force_0 = inertia_0*wanted_0 + inertia_1*wanted_1 + inertia_2*wanted_2 -
        momentum_2*turning_1 + 2.0*momentum_0*turning_2;
    const double force_1 = inertia_1*wanted_0 + inertia_3*wanted_1 + inertia_4*wanted_2 +
        momentum_2*turning_0 - 2.0*momentum_1*turning_2;
    const double force_2 = inertia_2*wanted_0 + inertia_4*wanted_1 + inertia_5*wanted_2 -
        2.0*momentum_0*turning_0 + 2.0*momentum_1*turning_1;

    /* -- end -- */
    command->force[0] = force_0;
    command->force[1] = force_1;
    command->force[2] = force_2;
    command->s[0] = s_0;
    command->s[1] = s_1;
    command->s[2] = s_2;
    command->nu_u[0] = g_e_1;
    command->nu_u[1] = g_e_2;
    command->nu_u[2] = nu_u_2;
    command->nu_u_dot[0] = nu_u_dot_0;
    command->nu_u_dot[1] = nu_u_dot_1;
    command->nu_u_dot[2] = nu_u_dot_2;
    return 1.0;
}

/* pivots of the inertia: all positive for a valid one. */
static void sl2_f64_definiteness(const sl2_f64_params *params, double pivot[3])
{
    /* -- definiteness -- */
    const double inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_3 = params->inertia[3],
        inertia_4 = params->inertia[4], inertia_5 = params->inertia[5];

    /* divisor_0: the pivot, or 1 where it is not positive [J s^2] */
    double divisor_0;
    if (inertia_0 > 0.0) {
        divisor_0 = inertia_0;
    } else {
        divisor_0 = 1.0;
    }

    /* lower_10: I = L D L^T, entry of L [1] */
    const double lower_10 = inertia_1/divisor_0;

    /* lower_20: I = L D L^T, entry of L [1] */
    const double lower_20 = inertia_2/divisor_0;

    /* pivot_1: pivot of I [J s^2] */
    const double pivot_1 = inertia_3 - inertia_0*lower_10*lower_10;

    /* divisor_1: the pivot, or 1 where it is not positive [J s^2] */
    double divisor_1;
    if (pivot_1 > 0.0) {
        divisor_1 = pivot_1;
    } else {
        divisor_1 = 1.0;
    }

    /* lower_21: I = L D L^T, entry of L [1] */
    const double lower_21 = (inertia_4 - inertia_0*lower_10*lower_20)/divisor_1;

    /* pivot_2: pivot of I [J s^2] */
    const double pivot_2 = inertia_5 - inertia_0*lower_20*lower_20 - pivot_1*lower_21*lower_21;

    /* -- end -- */
    pivot[0] = inertia_0;
    pivot[1] = pivot_1;
    pivot[2] = pivot_2;
}

void sl2_f64_tracking(const sl2_f64_params *params, const sl2_f64_state *state,
        const sl2_f64_reference *reference, sl2_f64_command *command)
{
    /* -- tracking -- */
    const double g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3];
    const double g_r_0 = reference->g[0], g_r_1 = reference->g[1], g_r_2 = reference->g[2],
        g_r_3 = reference->g[3];

    /* g_e: error, g_r^-1 g [1], eq. (velErr) */
    const double g_e_0 = g_0*g_r_3 - g_2*g_r_1;
    const double g_e_1 = g_1*g_r_3 - g_3*g_r_1;
    const double g_e_2 = g_2*g_r_0 - g_0*g_r_2;
    const double g_e_3 = g_3*g_r_0 - g_1*g_r_2;

    /* -- end -- */
    (void)sl2_f64_law(params, state, reference, command, g_e_0, g_e_1, g_e_2, g_e_3);
}

void sl2_f64_reaching(const sl2_f64_params *params, const sl2_f64_state *state,
        sl2_f64_command *command)
{
    /* -- reaching -- */
    const double inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_3 = params->inertia[3],
        inertia_4 = params->inertia[4], inertia_5 = params->inertia[5];
    const double rate_gain = params->lambda;
    const double reach_gain = params->k_s;
    const double g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3];
    const double nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2];

    /* nu_u: kinematic law, vee(g - g^-1)/2 [1], def. (KctrLaw) */
    const double nu_u_2 = 0.5*(g_0 - g_3);

    /* nu_u_dot: exact rate of nu_u [1/s] */
    const double nu_u_dot_0 = g_0*nu_0 - g_1*nu_2;
    const double nu_u_dot_1 = g_2*nu_2 + g_3*nu_1;
    const double nu_u_dot_2 = 0.5*(g_0*nu_2 + g_1*nu_1 + g_3*nu_2 - g_2*nu_0);

    /* drive: lambda nu_u [1/s] */
    const double drive_0 = g_1*rate_gain;
    const double drive_1 = g_2*rate_gain;
    const double drive_2 = nu_u_2*rate_gain;

    /* s: sliding variable [1/s], eq. (sldS) */
    const double s_0 = drive_0 + nu_0;
    const double s_1 = drive_1 + nu_1;
    const double s_2 = drive_2 + nu_2;

    /* wanted: acceleration asked for [1/s^2] */
    const double wanted_0 = -(nu_u_dot_0*rate_gain + reach_gain*s_0);
    const double wanted_1 = -(nu_u_dot_1*rate_gain + reach_gain*s_1);
    const double wanted_2 = -(nu_u_dot_2*rate_gain + reach_gain*s_2);

    /* momentum: I nu [J s] */
    const double momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2;
    const double momentum_1 = inertia_1*nu_0 + inertia_3*nu_1 + inertia_4*nu_2;
    const double momentum_2 = inertia_2*nu_0 + inertia_4*nu_1 + inertia_5*nu_2;

    /* force: control force, I f_u [J], eq. (Ctrl2) */
    const double force_0 = inertia_0*wanted_0 + inertia_1*wanted_1 + inertia_2*wanted_2 -
        drive_1*momentum_2 + 2.0*drive_2*momentum_0;
    const double force_1 = drive_0*momentum_2 + inertia_1*wanted_0 + inertia_3*wanted_1 +
        inertia_4*wanted_2 - 2.0*drive_2*momentum_1;
    const double force_2 = inertia_2*wanted_0 + inertia_4*wanted_1 + inertia_5*wanted_2 -
        2.0*drive_0*momentum_0 + 2.0*drive_1*momentum_1;

    /* -- end -- */
    command->force[0] = force_0;
    command->force[1] = force_1;
    command->force[2] = force_2;
    command->s[0] = s_0;
    command->s[1] = s_1;
    command->s[2] = s_2;
    command->nu_u[0] = g_1;
    command->nu_u[1] = g_2;
    command->nu_u[2] = nu_u_2;
    command->nu_u_dot[0] = nu_u_dot_0;
    command->nu_u_dot[1] = nu_u_dot_1;
    command->nu_u_dot[2] = nu_u_dot_2;
}

void sl2_f64_plant(const sl2_f64_params *params, const sl2_f64_state *state, const double force[3],
        double nu_dot[3])
{
    /* -- plant -- */
    const double inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_3 = params->inertia[3],
        inertia_4 = params->inertia[4], inertia_5 = params->inertia[5];
    const double nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2];
    const double force_0 = force[0], force_1 = force[1], force_2 = force[2];

    /* momentum: I nu [J s] */
    const double momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2;
    const double momentum_1 = inertia_1*nu_0 + inertia_3*nu_1 + inertia_4*nu_2;
    const double momentum_2 = inertia_2*nu_0 + inertia_4*nu_1 + inertia_5*nu_2;

    /* total: coad(nu) I nu + force [J] */
    const double total_0 = force_0 - momentum_2*nu_1 + 2.0*momentum_0*nu_2;
    const double total_1 = force_1 + momentum_2*nu_0 - 2.0*momentum_1*nu_2;
    const double total_2 = force_2 - 2.0*momentum_0*nu_0 + 2.0*momentum_1*nu_1;

    /* lower_10: I = L D L^T, entry of L [1] */
    const double lower_10 = inertia_1/inertia_0;

    /* lower_20: I = L D L^T, entry of L [1] */
    const double lower_20 = inertia_2/inertia_0;

    /* pivot_1: pivot of I [J s^2] */
    const double pivot_1 = inertia_3 - inertia_0*lower_10*lower_10;

    /* lower_21: I = L D L^T, entry of L [1] */
    const double lower_21 = (inertia_4 - inertia_0*lower_10*lower_20)/pivot_1;

    /* pivot_2: pivot of I [J s^2] */
    const double pivot_2 = inertia_5 - inertia_0*lower_20*lower_20 - pivot_1*lower_21*lower_21;

    /* forward_1: forward substitution [J] */
    const double forward_1 = total_1 - lower_10*total_0;

    /* forward_2: forward substitution [J] */
    const double forward_2 = total_2 - forward_1*lower_21 - lower_20*total_0;

    /* back_2: back substitution [1/s^2] */
    const double back_2 = forward_2/pivot_2;

    /* back_1: back substitution [1/s^2] */
    const double back_1 = forward_1/pivot_1 - back_2*lower_21;

    /* back_0: back substitution [1/s^2] */
    const double back_0 = total_0/inertia_0 - back_1*lower_10 - back_2*lower_20;

    /* -- end -- */
    nu_dot[0] = back_0;
    nu_dot[1] = back_1;
    nu_dot[2] = back_2;
}

/* The worse of two findings. */
static sl2_f64_status sl2_f64_worse(const sl2_f64_status a,
        const sl2_f64_status b)
{
    return a > b ? a : b;
}

/* OUT_OF_RANGE or NONFINITE_INPUT if any number is larger than a limit or not finite. */
static sl2_f64_status sl2_f64_inspect(const double *numbers, const int count,
        const double limit)
{
    sl2_f64_status worst = SL2_F64_OK;
    int i;
    for (i = 0; i < count; i++) {
        if (!isfinite(numbers[i])) {
            worst = SL2_F64_NONFINITE_INPUT;
        } else if (fabs(numbers[i]) > limit) {
            worst = sl2_f64_worse(worst, SL2_F64_OUT_OF_RANGE);
        } else {
            /* finite and in range: it leaves the finding as it is */
        }
    }
    return worst;
}

/* Zero command; its status says what is wrong with what was refused, at least what was found. */
static sl2_f64_status sl2_f64_refuse(const sl2_f64_state *state, const sl2_f64_reference *reference,
        const sl2_f64_status found, sl2_f64_command *command)
{
    sl2_f64_status worst = found;
    worst = sl2_f64_worse(worst,
            sl2_f64_inspect(state->g, 4, SL2_F64_MAX_INPUT));
    worst = sl2_f64_worse(worst,
            sl2_f64_inspect(state->nu, 3, SL2_F64_MAX_INPUT));
    worst = sl2_f64_worse(worst,
            sl2_f64_inspect(reference->g, 4, SL2_F64_MAX_INPUT));
    worst = sl2_f64_worse(worst,
            sl2_f64_inspect(reference->nu, 3, SL2_F64_MAX_INPUT));
    worst = sl2_f64_worse(worst,
            sl2_f64_inspect(reference->nu_dot, 3, SL2_F64_MAX_INPUT));
    sl2_f64_nothing(command);
    return worst;
}

/* What a computed command is worth. */
static sl2_f64_status sl2_f64_verdict(sl2_f64_command *command)
{
    if (!(isfinite(command->force[0]) && isfinite(command->force[1]) &&
            isfinite(command->force[2]))) {
        sl2_f64_nothing(command);
        return SL2_F64_NONFINITE_INPUT;
    }
    return SL2_F64_OK;
}

sl2_f64_status sl2_f64_control(const sl2_f64_params *params, const sl2_f64_state *state,
        const sl2_f64_reference *reference, sl2_f64_command *command)
{
#ifdef SL2_CHECK_POINTERS
    if (params == NULL || state == NULL || reference == NULL || command == NULL) {
        if (command != NULL) {
            sl2_f64_nothing(command);
        }
        return SL2_F64_BAD_PARAMS;
    }
#endif
    /* -- tracking -- */
    const double g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3];
    const double g_r_0 = reference->g[0], g_r_1 = reference->g[1], g_r_2 = reference->g[2],
        g_r_3 = reference->g[3];

    /* g_e: error, g_r^-1 g [1], eq. (velErr) */
    const double g_e_0 = g_0*g_r_3 - g_2*g_r_1;
    const double g_e_1 = g_1*g_r_3 - g_3*g_r_1;
    const double g_e_2 = g_2*g_r_0 - g_0*g_r_2;
    const double g_e_3 = g_3*g_r_0 - g_1*g_r_2;

    /* -- end -- */
    if (!(fabs(g_e_0) <= SL2_F64_MAX_REACH && fabs(g_e_1) <= SL2_F64_MAX_REACH
            && fabs(g_e_2) <= SL2_F64_MAX_REACH && fabs(g_e_3) <= SL2_F64_MAX_REACH
            && fabs(state->g[0]) <= SL2_F64_MAX_INPUT && fabs(state->g[1]) <= SL2_F64_MAX_INPUT
            && fabs(state->g[2]) <= SL2_F64_MAX_INPUT && fabs(state->g[3]) <= SL2_F64_MAX_INPUT
            && fabs(state->nu[0]) <= SL2_F64_MAX_INPUT && fabs(state->nu[1]) <= SL2_F64_MAX_INPUT
            && fabs(state->nu[2]) <= SL2_F64_MAX_INPUT && fabs(reference->g[0]) <= SL2_F64_MAX_INPUT
            && fabs(reference->g[1]) <= SL2_F64_MAX_INPUT
            && fabs(reference->g[2]) <= SL2_F64_MAX_INPUT
            && fabs(reference->g[3]) <= SL2_F64_MAX_INPUT
            && fabs(reference->nu[0]) <= SL2_F64_MAX_INPUT
            && fabs(reference->nu[1]) <= SL2_F64_MAX_INPUT
            && fabs(reference->nu[2]) <= SL2_F64_MAX_INPUT
            && fabs(reference->nu_dot[0]) <= SL2_F64_MAX_INPUT
            && fabs(reference->nu_dot[1]) <= SL2_F64_MAX_INPUT
            && fabs(reference->nu_dot[2]) <= SL2_F64_MAX_INPUT)) {
        if (fabs(g_e_0) <= SL2_F64_MAX_REACH && fabs(g_e_1) <= SL2_F64_MAX_REACH
                && fabs(g_e_2) <= SL2_F64_MAX_REACH && fabs(g_e_3) <= SL2_F64_MAX_REACH) {
            return sl2_f64_refuse(state, reference, SL2_F64_NOT_ON_GROUP, command);
        }
        return sl2_f64_refuse(state, reference, SL2_F64_OUT_OF_RANGE, command);
    }
    /* -- drift -- */

    /* off: what vanishes on the group, and only there [1] */
    const double off_0 = 1.0 + g_e_1*g_e_2 - g_e_0*g_e_3;
    const double off_1 = g_e_0*g_e_3 - 1.0 - g_e_1*g_e_2;

    /* drift: square of the distance from the group [1] */
    const double drift = off_0*off_0 + off_1*off_1;

    /* -- end -- */

    if (!(drift < params->max_drift*params->max_drift)) {
        return sl2_f64_refuse(state, reference, SL2_F64_NOT_ON_GROUP, command);
    }
    (void)sl2_f64_law(params, state, reference, command, g_e_0, g_e_1, g_e_2, g_e_3);
    return sl2_f64_verdict(command);
}

sl2_f64_status sl2_f64_check_params(const sl2_f64_params *params)
{
#ifdef SL2_CHECK_POINTERS
    if (params == NULL) {
        return SL2_F64_BAD_PARAMS;
    }
#endif
    double pivot[3];
    int i;
    if (sl2_f64_inspect(params->inertia, 6, SL2_F64_MAX_PARAM) != SL2_F64_OK) {
        return SL2_F64_BAD_PARAMS;
    }
    if (!(params->lambda >= SL2_F64_MIN_GAIN && params->lambda <= SL2_F64_MAX_RATE)) {
        return SL2_F64_BAD_PARAMS;
    }
    if (!(params->k_s >= SL2_F64_MIN_GAIN && params->k_s <= SL2_F64_MAX_RATE)) {
        return SL2_F64_BAD_PARAMS;
    }
    if (!(params->max_drift >= SL2_F64_LEAST_DRIFT && params->max_drift <= SL2_F64_MOST_DRIFT)) {
        return SL2_F64_BAD_PARAMS;
    }
    sl2_f64_definiteness(params, pivot);
    for (i = 0; i < 3; i++) {
        if (!(pivot[i] > 0.0)) {
            return SL2_F64_BAD_PARAMS;
        }
    }
    return SL2_F64_OK;
}
