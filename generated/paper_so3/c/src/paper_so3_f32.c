/*
 * paper_so3_f32: gsmc on SO3, law log (the rotation vector), float precision.
 * Every step below carries its quantity, unit and equation; trace.csv lists them by line.
 */
#include "paper_so3_f32.h"

#include <math.h>

#ifdef PAPER_SO3_CHECK_POINTERS /* that none is null: a precondition, which the self-test checks */
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

const paper_so3_f32_params paper_so3_f32_defaults = {
    {3.6046F, -0.0706F, 0.1491F, 8.6868F, 0.0449F, 9.3484F},
    0.5F, /* lambda */
    1.0F, /* k_s */
    0.0001F /* max_drift */
};

/* Kernel function k(w) on 0 <= w <= 1, a polynomial in 1 - w. */
static inline float paper_so3_f32_k(const float w)
{
    const float z = 1.0F - w;
    float sum = 0.0113573875F;
    sum = sum * z - 0.03345748F;
    sum = sum * z + 0.05257884F;
    sum = sum * z - 0.03515102F;
    sum = sum * z + 0.03098574F;
    sum = sum * z + 0.019848673F;
    sum = sum * z + 0.058037706F;
    sum = sum * z + 0.13326089F;
    sum = sum * z + 0.33333558F;
    sum = sum * z + 1.0F;
    return sum;
}

/* A command that asks for nothing; number by number, since memset is of no use without libc. */
static void paper_so3_f32_nothing(paper_so3_f32_command *command)
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
    command->nu_u_dot[0] = 0.0F;
    command->nu_u_dot[1] = 0.0F;
    command->nu_u_dot[2] = 0.0F;
}

/* force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl), past the error. Gives its clearance, 0
   where the law jumps. */
static float paper_so3_f32_law(const paper_so3_f32_params *params, const paper_so3_f32_state *state,
        const paper_so3_f32_reference *reference, paper_so3_f32_command *command, const float g_e_0,
        const float g_e_1, const float g_e_2, const float g_e_3, const float g_e_4,
        const float g_e_5, const float g_e_6, const float g_e_7, const float g_e_8)
{
    /* -- tracking -- */
    const float inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_3 = params->inertia[3],
        inertia_4 = params->inertia[4], inertia_5 = params->inertia[5];
    const float rate_gain = params->lambda;
    const float reach_gain = params->k_s;
    const float nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2];
    const float nu_r_0 = reference->nu[0], nu_r_1 = reference->nu[1], nu_r_2 = reference->nu[2];
    const float nu_r_dot_0 = reference->nu_dot[0], nu_r_dot_1 = reference->nu_dot[1],
        nu_r_dot_2 = reference->nu_dot[2];

    /* eta: reference velocity in the body frame [rad/s], eq. (velErr) */
    const float eta_0 = g_e_0*nu_r_0 + g_e_3*nu_r_1 + g_e_6*nu_r_2;
    const float eta_1 = g_e_1*nu_r_0 + g_e_4*nu_r_1 + g_e_7*nu_r_2;
    const float eta_2 = g_e_2*nu_r_0 + g_e_5*nu_r_1 + g_e_8*nu_r_2;

    /* nu_e: velocity error [rad/s], eq. (velErr) */
    const float nu_e_0 = nu_0 - eta_0;
    const float nu_e_1 = nu_1 - eta_1;
    const float nu_e_2 = nu_2 - eta_2;

    /* eta_dot: exact rate of eta [rad/s^2] */
    const float eta_dot_0 = eta_1*nu_e_2 + g_e_0*nu_r_dot_0 + g_e_3*nu_r_dot_1 + g_e_6*nu_r_dot_2 -
        eta_2*nu_e_1;
    const float eta_dot_1 = eta_2*nu_e_0 + g_e_1*nu_r_dot_0 + g_e_4*nu_r_dot_1 + g_e_7*nu_r_dot_2 -
        eta_0*nu_e_2;
    const float eta_dot_2 = eta_0*nu_e_1 + g_e_2*nu_r_dot_0 + g_e_5*nu_r_dot_1 + g_e_8*nu_r_dot_2 -
        eta_1*nu_e_0;

    /* pairs: what B's diagonal is made of [1] */
    const float pairs_0 = 1.0F + g_e_0;
    const float pairs_1 = 1.0F - g_e_0;
    const float pairs_2 = g_e_4 + g_e_8;
    const float pairs_3 = g_e_4 - g_e_8;

    /* B: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack */
    const float B_0 = pairs_0 - pairs_2;
    const float B_1 = g_e_1 + g_e_3;
    const float B_2 = g_e_2 + g_e_6;
    const float B_3 = g_e_7 - g_e_5;
    const float B_4 = pairs_1 + pairs_3;
    const float B_5 = g_e_5 + g_e_7;
    const float B_6 = g_e_2 - g_e_6;
    const float B_7 = pairs_1 - pairs_3;
    const float B_8 = g_e_3 - g_e_1;
    const float B_9 = pairs_0 + pairs_2;

    /* column: a column of B that cannot vanish [1] */
    float column_0, column_1, column_2, column_3;
    if (B_9 >= 1.0F) {
        column_0 = B_3;
        column_1 = B_6;
        column_2 = B_8;
        column_3 = B_9;
    } else if ((B_0 >= B_4) && (B_0 >= B_7)) {
        column_0 = B_0;
        column_1 = B_1;
        column_2 = B_2;
        column_3 = B_3;
    } else if (B_4 >= B_7) {
        column_0 = B_1;
        column_1 = B_4;
        column_2 = B_5;
        column_3 = B_6;
    } else {
        column_0 = B_2;
        column_1 = B_5;
        column_2 = B_7;
        column_3 = B_8;
    }

    /* power: the column after one power step [1] */
    const float power_0 = B_0*column_0 + B_1*column_1 + B_2*column_2 + B_3*column_3;
    const float power_1 = B_1*column_0 + B_4*column_1 + B_5*column_2 + B_6*column_3;
    const float power_2 = B_2*column_0 + B_5*column_1 + B_7*column_2 + B_8*column_3;
    const float power_3 = B_3*column_0 + B_6*column_1 + B_8*column_2 + B_9*column_3;

    /* square: square of its vector part [1] */
    const float square = power_0*power_0 + power_1*power_1 + power_2*power_2;

    /* norm_square: its squared length [1] */
    const float norm_square = square + power_3*power_3;

    /* norm_bounded: the same: less is no element [1] */
    float norm_bounded;
    if (norm_square <= 49.0F) {
        norm_bounded = 49.0F;
    } else {
        norm_bounded = norm_square;
    }

    /* norm: its length [1] */
    const float norm = sqrtf(norm_bounded);

    /* inverse_norm: to unit length [1] */
    const float inverse_norm = 1.0F/norm;

    /* scale: to unit length, and to w >= 0: the shorter way round [1] */
    float scale;
    if (power_3 < 0.0F) {
        scale = -inverse_norm;
    } else {
        scale = inverse_norm;
    }

    /* w: cos of half the error angle [1] */
    const float w = power_3*scale;

    /* k: half angle over its sine [1] */
    const float k = paper_so3_f32_k(w);

    /* h_raw: -dk/dw times scale^2, as s^2 h = 1 - w k [1] */
    const float h_raw = (1.0F - k*w)/(square + 1.0e-8F);

    /* reach: p times the scale of the vector part [1] */
    const float reach = k*scale;

    /* stretch: nu_u over the vector part [1] */
    const float stretch = 2.0F*reach;

    /* nu_u: kinematic law, the rotation vector [rad], eq. (KinCtrlLawSO3) */
    const float nu_u_0 = power_0*stretch;
    const float nu_u_1 = power_1*stretch;
    const float nu_u_2 = power_2*stretch;

    /* turn: vector part x nu_e [rad/s] */
    const float turn_0 = nu_e_2*power_1 - nu_e_1*power_2;
    const float turn_1 = nu_e_0*power_2 - nu_e_2*power_0;
    const float turn_2 = nu_e_1*power_0 - nu_e_0*power_1;

    /* bend: vector part x turn [rad/s] */
    const float bend_0 = power_1*turn_2 - power_2*turn_1;
    const float bend_1 = power_2*turn_0 - power_0*turn_2;
    const float bend_2 = power_0*turn_1 - power_1*turn_0;

    /* nu_u_dot: exact rate of nu_u [rad/s] */
    const float nu_u_dot_0 = nu_e_0 + bend_0*h_raw + reach*turn_0;
    const float nu_u_dot_1 = nu_e_1 + bend_1*h_raw + reach*turn_1;
    const float nu_u_dot_2 = nu_e_2 + bend_2*h_raw + reach*turn_2;

    /* drive: lambda nu_u [rad/s] */
    const float drive_0 = nu_u_0*rate_gain;
    const float drive_1 = nu_u_1*rate_gain;
    const float drive_2 = nu_u_2*rate_gain;

    /* s: sliding variable [rad/s], eq. (SurfaceErr) */
    const float s_0 = drive_0 + nu_e_0;
    const float s_1 = drive_1 + nu_e_1;
    const float s_2 = drive_2 + nu_e_2;

    /* wanted: acceleration asked for [rad/s^2] */
    const float wanted_0 = eta_dot_0 - nu_u_dot_0*rate_gain - reach_gain*s_0;
    const float wanted_1 = eta_dot_1 - nu_u_dot_1*rate_gain - reach_gain*s_1;
    const float wanted_2 = eta_dot_2 - nu_u_dot_2*rate_gain - reach_gain*s_2;

    /* turning: lambda nu_u - eta [rad/s] */
    const float turning_0 = drive_0 - eta_0;
    const float turning_1 = drive_1 - eta_1;
    const float turning_2 = drive_2 - eta_2;

    /* momentum: I nu [N m s] */
    const float momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2;
    const float momentum_1 = inertia_1*nu_0 + inertia_3*nu_1 + inertia_4*nu_2;
    const float momentum_2 = inertia_2*nu_0 + inertia_4*nu_1 + inertia_5*nu_2;

    /* force: control force, I f_u [N m], eq. (TckCtrl) */
    const float force_0 = inertia_0*wanted_0 + inertia_1*wanted_1 + inertia_2*wanted_2 +
        momentum_1*turning_2 - momentum_2*turning_1;
    const float force_1 = inertia_1*wanted_0 + inertia_3*wanted_1 + inertia_4*wanted_2 +
        momentum_2*turning_0 - momentum_0*turning_2;
    const float force_2 = inertia_2*wanted_0 + inertia_4*wanted_1 + inertia_5*wanted_2 +
        momentum_0*turning_1 - momentum_1*turning_0;

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
    command->nu_u_dot[0] = nu_u_dot_0;
    command->nu_u_dot[1] = nu_u_dot_1;
    command->nu_u_dot[2] = nu_u_dot_2;
    return w;
}

/* pivots of the inertia: all positive for a valid one. */
static void paper_so3_f32_definiteness(const paper_so3_f32_params *params, float pivot[3])
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

void paper_so3_f32_tracking(const paper_so3_f32_params *params, const paper_so3_f32_state *state,
        const paper_so3_f32_reference *reference, paper_so3_f32_command *command)
{
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
    (void)paper_so3_f32_law(params, state, reference, command, g_e_0, g_e_1, g_e_2, g_e_3, g_e_4,
            g_e_5, g_e_6, g_e_7, g_e_8);
}

void paper_so3_f32_reaching(const paper_so3_f32_params *params, const paper_so3_f32_state *state,
        paper_so3_f32_command *command)
{
    /* -- reaching -- */
    const float inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_3 = params->inertia[3],
        inertia_4 = params->inertia[4], inertia_5 = params->inertia[5];
    const float rate_gain = params->lambda;
    const float reach_gain = params->k_s;
    const float g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5], g_6 = state->g[6], g_7 = state->g[7],
        g_8 = state->g[8];
    const float nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2];

    /* pairs: what B's diagonal is made of [1] */
    const float pairs_0 = 1.0F + g_0;
    const float pairs_1 = 1.0F - g_0;
    const float pairs_2 = g_4 + g_8;
    const float pairs_3 = g_4 - g_8;

    /* B: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack */
    const float B_0 = pairs_0 - pairs_2;
    const float B_1 = g_1 + g_3;
    const float B_2 = g_2 + g_6;
    const float B_3 = g_7 - g_5;
    const float B_4 = pairs_1 + pairs_3;
    const float B_5 = g_5 + g_7;
    const float B_6 = g_2 - g_6;
    const float B_7 = pairs_1 - pairs_3;
    const float B_8 = g_3 - g_1;
    const float B_9 = pairs_0 + pairs_2;

    /* column: a column of B that cannot vanish [1] */
    float column_0, column_1, column_2, column_3;
    if (B_9 >= 1.0F) {
        column_0 = B_3;
        column_1 = B_6;
        column_2 = B_8;
        column_3 = B_9;
    } else if ((B_0 >= B_4) && (B_0 >= B_7)) {
        column_0 = B_0;
        column_1 = B_1;
        column_2 = B_2;
        column_3 = B_3;
    } else if (B_4 >= B_7) {
        column_0 = B_1;
        column_1 = B_4;
        column_2 = B_5;
        column_3 = B_6;
    } else {
        column_0 = B_2;
        column_1 = B_5;
        column_2 = B_7;
        column_3 = B_8;
    }

    /* power: the column after one power step [1] */
    const float power_0 = B_0*column_0 + B_1*column_1 + B_2*column_2 + B_3*column_3;
    const float power_1 = B_1*column_0 + B_4*column_1 + B_5*column_2 + B_6*column_3;
    const float power_2 = B_2*column_0 + B_5*column_1 + B_7*column_2 + B_8*column_3;
    const float power_3 = B_3*column_0 + B_6*column_1 + B_8*column_2 + B_9*column_3;

    /* square: square of its vector part [1] */
    const float square = power_0*power_0 + power_1*power_1 + power_2*power_2;

    /* norm_square: its squared length [1] */
    const float norm_square = square + power_3*power_3;

    /* norm_bounded: the same: less is no element [1] */
    float norm_bounded;
    if (norm_square <= 49.0F) {
        norm_bounded = 49.0F;
    } else {
        norm_bounded = norm_square;
    }

    /* norm: its length [1] */
    const float norm = sqrtf(norm_bounded);

    /* inverse_norm: to unit length [1] */
    const float inverse_norm = 1.0F/norm;

    /* scale: to unit length, and to w >= 0: the shorter way round [1] */
    float scale;
    if (power_3 < 0.0F) {
        scale = -inverse_norm;
    } else {
        scale = inverse_norm;
    }

    /* w: cos of half the error angle [1] */
    const float w = power_3*scale;

    /* k: half angle over its sine [1] */
    const float k = paper_so3_f32_k(w);

    /* h_raw: -dk/dw times scale^2, as s^2 h = 1 - w k [1] */
    const float h_raw = (1.0F - k*w)/(square + 1.0e-8F);

    /* reach: p times the scale of the vector part [1] */
    const float reach = k*scale;

    /* stretch: nu_u over the vector part [1] */
    const float stretch = 2.0F*reach;

    /* nu_u: kinematic law, the rotation vector [rad], eq. (KinCtrlLawSO3) */
    const float nu_u_0 = power_0*stretch;
    const float nu_u_1 = power_1*stretch;
    const float nu_u_2 = power_2*stretch;

    /* turn: vector part x nu_e [rad/s] */
    const float turn_0 = nu_2*power_1 - nu_1*power_2;
    const float turn_1 = nu_0*power_2 - nu_2*power_0;
    const float turn_2 = nu_1*power_0 - nu_0*power_1;

    /* bend: vector part x turn [rad/s] */
    const float bend_0 = power_1*turn_2 - power_2*turn_1;
    const float bend_1 = power_2*turn_0 - power_0*turn_2;
    const float bend_2 = power_0*turn_1 - power_1*turn_0;

    /* nu_u_dot: exact rate of nu_u [rad/s] */
    const float nu_u_dot_0 = nu_0 + bend_0*h_raw + reach*turn_0;
    const float nu_u_dot_1 = nu_1 + bend_1*h_raw + reach*turn_1;
    const float nu_u_dot_2 = nu_2 + bend_2*h_raw + reach*turn_2;

    /* drive: lambda nu_u [rad/s] */
    const float drive_0 = nu_u_0*rate_gain;
    const float drive_1 = nu_u_1*rate_gain;
    const float drive_2 = nu_u_2*rate_gain;

    /* s: sliding variable [rad/s], eq. (sldS) */
    const float s_0 = drive_0 + nu_0;
    const float s_1 = drive_1 + nu_1;
    const float s_2 = drive_2 + nu_2;

    /* wanted: acceleration asked for [rad/s^2] */
    const float wanted_0 = -(nu_u_dot_0*rate_gain + reach_gain*s_0);
    const float wanted_1 = -(nu_u_dot_1*rate_gain + reach_gain*s_1);
    const float wanted_2 = -(nu_u_dot_2*rate_gain + reach_gain*s_2);

    /* momentum: I nu [N m s] */
    const float momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2;
    const float momentum_1 = inertia_1*nu_0 + inertia_3*nu_1 + inertia_4*nu_2;
    const float momentum_2 = inertia_2*nu_0 + inertia_4*nu_1 + inertia_5*nu_2;

    /* force: control force, I f_u [N m], eq. (Ctrl2) */
    const float force_0 = drive_2*momentum_1 + inertia_0*wanted_0 + inertia_1*wanted_1 +
        inertia_2*wanted_2 - drive_1*momentum_2;
    const float force_1 = drive_0*momentum_2 + inertia_1*wanted_0 + inertia_3*wanted_1 +
        inertia_4*wanted_2 - drive_2*momentum_0;
    const float force_2 = drive_1*momentum_0 + inertia_2*wanted_0 + inertia_4*wanted_1 +
        inertia_5*wanted_2 - drive_0*momentum_1;

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
    command->nu_u_dot[0] = nu_u_dot_0;
    command->nu_u_dot[1] = nu_u_dot_1;
    command->nu_u_dot[2] = nu_u_dot_2;
}

void paper_so3_f32_plant(const paper_so3_f32_params *params, const paper_so3_f32_state *state,
        const float force[3], float nu_dot[3])
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
static paper_so3_f32_status paper_so3_f32_worse(const paper_so3_f32_status a,
        const paper_so3_f32_status b)
{
    return a > b ? a : b;
}

/* OUT_OF_RANGE or NONFINITE_INPUT if any number is larger than a limit or not finite. */
static paper_so3_f32_status paper_so3_f32_inspect(const float *numbers, const int count,
        const float limit)
{
    paper_so3_f32_status worst = PAPER_SO3_F32_OK;
    int i;
    for (i = 0; i < count; i++) {
        if (!isfinite(numbers[i])) {
            worst = PAPER_SO3_F32_NONFINITE_INPUT;
        } else if (fabsf(numbers[i]) > limit) {
            worst = paper_so3_f32_worse(worst, PAPER_SO3_F32_OUT_OF_RANGE);
        } else {
            /* finite and in range: it leaves the finding as it is */
        }
    }
    return worst;
}

/* Zero command; its status says what is wrong with what was refused, at least what was found. */
static paper_so3_f32_status paper_so3_f32_refuse(const paper_so3_f32_state *state,
        const paper_so3_f32_reference *reference, const paper_so3_f32_status found,
        paper_so3_f32_command *command)
{
    paper_so3_f32_status worst = found;
    worst = paper_so3_f32_worse(worst,
            paper_so3_f32_inspect(state->g, 9, PAPER_SO3_F32_MAX_INPUT));
    worst = paper_so3_f32_worse(worst,
            paper_so3_f32_inspect(state->nu, 3, PAPER_SO3_F32_MAX_INPUT));
    worst = paper_so3_f32_worse(worst,
            paper_so3_f32_inspect(reference->g, 9, PAPER_SO3_F32_MAX_INPUT));
    worst = paper_so3_f32_worse(worst,
            paper_so3_f32_inspect(reference->nu, 3, PAPER_SO3_F32_MAX_INPUT));
    worst = paper_so3_f32_worse(worst,
            paper_so3_f32_inspect(reference->nu_dot, 3, PAPER_SO3_F32_MAX_INPUT));
    paper_so3_f32_nothing(command);
    return worst;
}

/* What a computed command is worth, given its distance from the cut locus of the law. */
static paper_so3_f32_status paper_so3_f32_verdict(const float clearance,
        paper_so3_f32_command *command)
{
    if (!(isfinite(command->force[0]) && isfinite(command->force[1]) &&
            isfinite(command->force[2]))) {
        paper_so3_f32_nothing(command);
        return PAPER_SO3_F32_NONFINITE_INPUT;
    }
    return clearance < PAPER_SO3_F32_NEAR_CUT ? PAPER_SO3_F32_NEAR_CUT_LOCUS : PAPER_SO3_F32_OK;
}

paper_so3_f32_status paper_so3_f32_control(const paper_so3_f32_params *params,
        const paper_so3_f32_state *state, const paper_so3_f32_reference *reference,
        paper_so3_f32_command *command)
{
    float clearance;
#ifdef PAPER_SO3_CHECK_POINTERS
    if (params == NULL || state == NULL || reference == NULL || command == NULL) {
        if (command != NULL) {
            paper_so3_f32_nothing(command);
        }
        return PAPER_SO3_F32_BAD_PARAMS;
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
    if (!(fabsf(g_e_0) <= PAPER_SO3_F32_MAX_ENTRY && fabsf(g_e_1) <= PAPER_SO3_F32_MAX_ENTRY
            && fabsf(g_e_2) <= PAPER_SO3_F32_MAX_ENTRY && fabsf(g_e_3) <= PAPER_SO3_F32_MAX_ENTRY
            && fabsf(g_e_4) <= PAPER_SO3_F32_MAX_ENTRY && fabsf(g_e_5) <= PAPER_SO3_F32_MAX_ENTRY
            && fabsf(g_e_6) <= PAPER_SO3_F32_MAX_ENTRY && fabsf(g_e_7) <= PAPER_SO3_F32_MAX_ENTRY
            && fabsf(g_e_8) <= PAPER_SO3_F32_MAX_ENTRY
            && fabsf(state->nu[0]) <= PAPER_SO3_F32_MAX_INPUT
            && fabsf(state->nu[1]) <= PAPER_SO3_F32_MAX_INPUT
            && fabsf(state->nu[2]) <= PAPER_SO3_F32_MAX_INPUT
            && fabsf(reference->nu[0]) <= PAPER_SO3_F32_MAX_INPUT
            && fabsf(reference->nu[1]) <= PAPER_SO3_F32_MAX_INPUT
            && fabsf(reference->nu[2]) <= PAPER_SO3_F32_MAX_INPUT
            && fabsf(reference->nu_dot[0]) <= PAPER_SO3_F32_MAX_INPUT
            && fabsf(reference->nu_dot[1]) <= PAPER_SO3_F32_MAX_INPUT
            && fabsf(reference->nu_dot[2]) <= PAPER_SO3_F32_MAX_INPUT)) {
        return paper_so3_f32_refuse(state, reference, PAPER_SO3_F32_NOT_ON_GROUP, command);
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
        return paper_so3_f32_refuse(state, reference, PAPER_SO3_F32_NOT_ON_GROUP, command);
    }
    clearance = paper_so3_f32_law(params, state, reference, command, g_e_0, g_e_1, g_e_2, g_e_3,
            g_e_4, g_e_5, g_e_6, g_e_7, g_e_8);
    return paper_so3_f32_verdict(clearance, command);
}

paper_so3_f32_status paper_so3_f32_check_params(const paper_so3_f32_params *params)
{
#ifdef PAPER_SO3_CHECK_POINTERS
    if (params == NULL) {
        return PAPER_SO3_F32_BAD_PARAMS;
    }
#endif
    float pivot[3];
    int i;
    if (paper_so3_f32_inspect(params->inertia, 6, PAPER_SO3_F32_MAX_PARAM) != PAPER_SO3_F32_OK) {
        return PAPER_SO3_F32_BAD_PARAMS;
    }
    if (!(params->lambda >= PAPER_SO3_F32_MIN_GAIN && params->lambda <= PAPER_SO3_F32_MAX_RATE)) {
        return PAPER_SO3_F32_BAD_PARAMS;
    }
    if (!(params->k_s >= PAPER_SO3_F32_MIN_GAIN && params->k_s <= PAPER_SO3_F32_MAX_RATE)) {
        return PAPER_SO3_F32_BAD_PARAMS;
    }
    if (!(params->max_drift >= PAPER_SO3_F32_LEAST_DRIFT && params->max_drift <=
            PAPER_SO3_F32_MOST_DRIFT)) {
        return PAPER_SO3_F32_BAD_PARAMS;
    }
    paper_so3_f32_definiteness(params, pivot);
    for (i = 0; i < 3; i++) {
        if (!(pivot[i] > 0.0F)) {
            return PAPER_SO3_F32_BAD_PARAMS;
        }
    }
    return PAPER_SO3_F32_OK;
}
