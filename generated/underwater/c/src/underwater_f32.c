/*
 * underwater_f32: gsmc on SE3, law log (the logarithm), float precision.
 * Every step below carries its quantity, unit and equation; trace.csv lists them by line.
 */
#include "underwater_f32.h"

#include <math.h>

#ifdef UNDERWATER_CHECK_POINTERS /* that none is null: a precondition, which the self-test checks */
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

const underwater_f32_params underwater_f32_defaults = {
    {2.65625F, -0.0875F, 0.175F, 0.12F, -2.6F, -0.1F, 10.82F, 0.0875F, 2.1F, 0.1F, 1.4F, 10.64625F,
     0.05F, -1.2F, 0.1F, 66.0F, 0.7F, -0.9F, 102.0F, 0.4F, 118.0F},
    0.25F, /* lambda */
    0.6F, /* k_s */
    0.0001F /* max_drift */
};

/* Kernel function k(w) on 0 <= w <= 1, a polynomial in 1 - w. */
static inline float underwater_f32_k(const float w)
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

/* Kernel function h(w) on 0 <= w <= 1, a polynomial in 1 - w. */
static inline float underwater_f32_h(const float w)
{
    const float z = 1.0F - w;
    float sum = 0.03755537F;
    sum = sum * z - 0.15084887F;
    sum = sum * z + 0.2894651F;
    sum = sum * z - 0.3082163F;
    sum = sum * z + 0.22480422F;
    sum = sum * z - 0.07859547F;
    sum = sum * z + 0.059559852F;
    sum = sum * z + 0.052769855F;
    sum = sum * z + 0.10210469F;
    sum = sum * z + 0.17140095F;
    sum = sum * z + 0.26666725F;
    sum = sum * z + 0.33333334F;
    return sum;
}

/* Kernel function m(w) on 0 <= w <= 1, a polynomial in 1 - w. */
static inline float underwater_f32_m(const float w)
{
    const float z = 1.0F - w;
    float sum = 0.1852023F;
    sum = sum * z - 0.9302454F;
    sum = sum * z + 2.177158F;
    sum = sum * z - 2.9927545F;
    sum = sum * z + 2.7156496F;
    sum = sum * z - 1.6283582F;
    sum = sum * z + 0.73549557F;
    sum = sum * z - 0.13504317F;
    sum = sum * z + 0.14312719F;
    sum = sum * z + 0.15506272F;
    sum = sum * z + 0.2312295F;
    sum = sum * z + 0.3047487F;
    sum = sum * z + 0.34285733F;
    sum = sum * z + 0.26666668F;
    return sum;
}

/* A command that asks for nothing; number by number, since memset is of no use without libc. */
static void underwater_f32_nothing(underwater_f32_command *command)
{
    command->force[0] = 0.0F;
    command->force[1] = 0.0F;
    command->force[2] = 0.0F;
    command->force[3] = 0.0F;
    command->force[4] = 0.0F;
    command->force[5] = 0.0F;
    command->s[0] = 0.0F;
    command->s[1] = 0.0F;
    command->s[2] = 0.0F;
    command->s[3] = 0.0F;
    command->s[4] = 0.0F;
    command->s[5] = 0.0F;
    command->nu_u[0] = 0.0F;
    command->nu_u[1] = 0.0F;
    command->nu_u[2] = 0.0F;
    command->nu_u[3] = 0.0F;
    command->nu_u[4] = 0.0F;
    command->nu_u[5] = 0.0F;
    command->nu_u_dot[0] = 0.0F;
    command->nu_u_dot[1] = 0.0F;
    command->nu_u_dot[2] = 0.0F;
    command->nu_u_dot[3] = 0.0F;
    command->nu_u_dot[4] = 0.0F;
    command->nu_u_dot[5] = 0.0F;
}

/* force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl), past the error. Gives its clearance, 0
   where the law jumps. */
static float underwater_f32_law(const underwater_f32_params *params,
        const underwater_f32_state *state, const underwater_f32_reference *reference,
        underwater_f32_command *command, const float g_e_0, const float g_e_1, const float g_e_2,
        const float g_e_3, const float g_e_4, const float g_e_5, const float g_e_6,
        const float g_e_7, const float g_e_8, const float g_e_9, const float g_e_10,
        const float g_e_11)
{
    /* -- tracking -- */
    const float inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_3 = params->inertia[3],
        inertia_4 = params->inertia[4], inertia_5 = params->inertia[5],
        inertia_6 = params->inertia[6], inertia_7 = params->inertia[7],
        inertia_8 = params->inertia[8], inertia_9 = params->inertia[9],
        inertia_10 = params->inertia[10], inertia_11 = params->inertia[11],
        inertia_12 = params->inertia[12], inertia_13 = params->inertia[13],
        inertia_14 = params->inertia[14], inertia_15 = params->inertia[15],
        inertia_16 = params->inertia[16], inertia_17 = params->inertia[17],
        inertia_18 = params->inertia[18], inertia_19 = params->inertia[19],
        inertia_20 = params->inertia[20];
    const float rate_gain = params->lambda;
    const float reach_gain = params->k_s;
    const float nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2], nu_3 = state->nu[3],
        nu_4 = state->nu[4], nu_5 = state->nu[5];
    const float external_0 = state->external[0], external_1 = state->external[1],
        external_2 = state->external[2], external_3 = state->external[3],
        external_4 = state->external[4], external_5 = state->external[5];
    const float nu_r_0 = reference->nu[0], nu_r_1 = reference->nu[1], nu_r_2 = reference->nu[2],
        nu_r_3 = reference->nu[3], nu_r_4 = reference->nu[4], nu_r_5 = reference->nu[5];
    const float nu_r_dot_0 = reference->nu_dot[0], nu_r_dot_1 = reference->nu_dot[1],
        nu_r_dot_2 = reference->nu_dot[2], nu_r_dot_3 = reference->nu_dot[3],
        nu_r_dot_4 = reference->nu_dot[4], nu_r_dot_5 = reference->nu_dot[5];

    /* eta_arm_0: velocity at p [m/s] */
    const float eta_arm_0_0 = nu_r_3 + g_e_11*nu_r_1 - g_e_7*nu_r_2;
    const float eta_arm_0_1 = nu_r_4 + g_e_3*nu_r_2 - g_e_11*nu_r_0;
    const float eta_arm_0_2 = nu_r_5 + g_e_7*nu_r_0 - g_e_3*nu_r_1;

    /* eta: reference velocity in the body frame [rad/s, m/s], eq. (velErr) */
    const float eta_0 = g_e_0*nu_r_0 + g_e_4*nu_r_1 + g_e_8*nu_r_2;
    const float eta_1 = g_e_1*nu_r_0 + g_e_5*nu_r_1 + g_e_9*nu_r_2;
    const float eta_2 = g_e_10*nu_r_2 + g_e_2*nu_r_0 + g_e_6*nu_r_1;
    const float eta_3 = eta_arm_0_0*g_e_0 + eta_arm_0_1*g_e_4 + eta_arm_0_2*g_e_8;
    const float eta_4 = eta_arm_0_0*g_e_1 + eta_arm_0_1*g_e_5 + eta_arm_0_2*g_e_9;
    const float eta_5 = eta_arm_0_0*g_e_2 + eta_arm_0_1*g_e_6 + eta_arm_0_2*g_e_10;

    /* nu_e: velocity error [rad/s, m/s], eq. (velErr) */
    const float nu_e_0 = nu_0 - eta_0;
    const float nu_e_1 = nu_1 - eta_1;
    const float nu_e_2 = nu_2 - eta_2;
    const float nu_e_3 = nu_3 - eta_3;
    const float nu_e_4 = nu_4 - eta_4;
    const float nu_e_5 = nu_5 - eta_5;

    /* eta_dot_arm_0: velocity at p [m/s] */
    const float eta_dot_arm_0_0 = nu_r_dot_3 + g_e_11*nu_r_dot_1 - g_e_7*nu_r_dot_2;
    const float eta_dot_arm_0_1 = nu_r_dot_4 + g_e_3*nu_r_dot_2 - g_e_11*nu_r_dot_0;
    const float eta_dot_arm_0_2 = nu_r_dot_5 + g_e_7*nu_r_dot_0 - g_e_3*nu_r_dot_1;

    /* eta_dot: exact rate of eta [rad/s^2, m/s^2] */
    const float eta_dot_0 = eta_1*nu_e_2 + g_e_0*nu_r_dot_0 + g_e_4*nu_r_dot_1 + g_e_8*nu_r_dot_2 -
        eta_2*nu_e_1;
    const float eta_dot_1 = eta_2*nu_e_0 + g_e_1*nu_r_dot_0 + g_e_5*nu_r_dot_1 + g_e_9*nu_r_dot_2 -
        eta_0*nu_e_2;
    const float eta_dot_2 = eta_0*nu_e_1 + g_e_10*nu_r_dot_2 + g_e_2*nu_r_dot_0 + g_e_6*nu_r_dot_1 -
        eta_1*nu_e_0;
    const float eta_dot_3 = eta_1*nu_e_5 + eta_4*nu_e_2 + eta_dot_arm_0_0*g_e_0 +
        eta_dot_arm_0_1*g_e_4 + eta_dot_arm_0_2*g_e_8 - eta_2*nu_e_4 - eta_5*nu_e_1;
    const float eta_dot_4 = eta_2*nu_e_3 + eta_5*nu_e_0 + eta_dot_arm_0_0*g_e_1 +
        eta_dot_arm_0_1*g_e_5 + eta_dot_arm_0_2*g_e_9 - eta_0*nu_e_5 - eta_3*nu_e_2;
    const float eta_dot_5 = eta_0*nu_e_4 + eta_3*nu_e_1 + eta_dot_arm_0_0*g_e_2 +
        eta_dot_arm_0_1*g_e_6 + eta_dot_arm_0_2*g_e_10 - eta_1*nu_e_3 - eta_4*nu_e_0;

    /* pairs: what B's diagonal is made of [1] */
    const float pairs_0 = 1.0F + g_e_0;
    const float pairs_1 = 1.0F - g_e_0;
    const float pairs_2 = g_e_10 + g_e_5;
    const float pairs_3 = g_e_5 - g_e_10;

    /* B: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack */
    const float B_0 = pairs_0 - pairs_2;
    const float B_1 = g_e_1 + g_e_4;
    const float B_2 = g_e_2 + g_e_8;
    const float B_3 = g_e_9 - g_e_6;
    const float B_4 = pairs_1 + pairs_3;
    const float B_5 = g_e_6 + g_e_9;
    const float B_6 = g_e_2 - g_e_8;
    const float B_7 = pairs_1 - pairs_3;
    const float B_8 = g_e_4 - g_e_1;
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

    /* cosine: cos of half the error angle, rounded [1] */
    const float cosine = power_3*scale;

    /* w: cos of half the error angle [1] */
    float w;
    if (cosine >= 1.0F) {
        w = 1.0F;
    } else {
        w = cosine;
    }

    /* v: sin of half the error angle times its axis [1] */
    const float v_0 = power_0*scale;
    const float v_1 = power_1*scale;
    const float v_2 = power_2*scale;

    /* k: half angle over its sine [1] */
    const float k = underwater_f32_k(w);

    /* h: -dk/dw [1] */
    const float h = underwater_f32_h(w);

    /* phi: rotation vector of the error [rad] */
    const float phi_0 = 2.0F*k*v_0;
    const float phi_1 = 2.0F*k*v_1;
    const float phi_2 = 2.0F*k*v_2;

    /* half: 1/(2 k) [1] */
    const float half = 0.5F/k;

    /* swing_p: Y p [m] */
    const float swing_p_0 = g_e_11*v_1 - g_e_7*v_2;
    const float swing_p_1 = g_e_3*v_2 - g_e_11*v_0;
    const float swing_p_2 = g_e_7*v_0 - g_e_3*v_1;

    /* sway_p: Y Y p [m] */
    const float sway_p_0 = swing_p_2*v_1 - swing_p_1*v_2;
    const float sway_p_1 = swing_p_0*v_2 - swing_p_2*v_0;
    const float sway_p_2 = swing_p_1*v_0 - swing_p_0*v_1;

    /* rho_p: p - k Y p + h Y Y p [m] */
    const float rho_p_0 = g_e_3 + h*sway_p_0 - k*swing_p_0;
    const float rho_p_1 = g_e_7 + h*sway_p_1 - k*swing_p_1;
    const float rho_p_2 = g_e_11 + h*sway_p_2 - k*swing_p_2;

    /* y_p: rho/(2 k) [m] */
    const float y_p_0 = half*rho_p_0;
    const float y_p_1 = half*rho_p_1;
    const float y_p_2 = half*rho_p_2;

    /* turn: Y nu_e, Y = ad of y [rad/s, m/s] */
    const float turn_0 = nu_e_2*v_1 - nu_e_1*v_2;
    const float turn_1 = nu_e_0*v_2 - nu_e_2*v_0;
    const float turn_2 = nu_e_1*v_0 - nu_e_0*v_1;
    const float turn_3 = nu_e_2*y_p_1 + nu_e_5*v_1 - nu_e_1*y_p_2 - nu_e_4*v_2;
    const float turn_4 = nu_e_0*y_p_2 + nu_e_3*v_2 - nu_e_2*y_p_0 - nu_e_5*v_0;
    const float turn_5 = nu_e_1*y_p_0 + nu_e_4*v_0 - nu_e_0*y_p_1 - nu_e_3*v_1;

    /* bend: Y Y nu_e [rad/s, m/s] */
    const float bend_0 = turn_2*v_1 - turn_1*v_2;
    const float bend_1 = turn_0*v_2 - turn_2*v_0;
    const float bend_2 = turn_1*v_0 - turn_0*v_1;
    const float bend_3 = turn_2*y_p_1 + turn_5*v_1 - turn_1*y_p_2 - turn_4*v_2;
    const float bend_4 = turn_0*y_p_2 + turn_3*v_2 - turn_2*y_p_0 - turn_5*v_0;
    const float bend_5 = turn_1*y_p_0 + turn_4*v_0 - turn_0*y_p_1 - turn_3*v_1;

    /* m: -dh/dw [1] */
    const float m = underwater_f32_m(w);

    /* along_p: -2 v.q [m] */
    const float along_p = -2.0F*(v_0*y_p_0 + v_1*y_p_1 + v_2*y_p_2);

    /* tail: (Y^2 + s^2) Y^2 nu_e [rad/s, m/s] */
    const float tail_3 = along_p*bend_0;
    const float tail_4 = along_p*bend_1;
    const float tail_5 = along_p*bend_2;

    /* twofold: h^2 - k m/2, of the double root [1] */
    const float twofold = h*h - 0.5F*k*m;

    /* nu_u_dot: exact rate of nu_u [rad/s, m/s] */
    const float nu_u_dot_0 = nu_e_0 + bend_0*h + k*turn_0;
    const float nu_u_dot_1 = nu_e_1 + bend_1*h + k*turn_1;
    const float nu_u_dot_2 = nu_e_2 + bend_2*h + k*turn_2;
    const float nu_u_dot_3 = nu_e_3 + bend_3*h + k*turn_3 + tail_3*twofold;
    const float nu_u_dot_4 = nu_e_4 + bend_4*h + k*turn_4 + tail_4*twofold;
    const float nu_u_dot_5 = nu_e_5 + bend_5*h + k*turn_5 + tail_5*twofold;

    /* drive: lambda nu_u [rad/s, m/s] */
    const float drive_0 = phi_0*rate_gain;
    const float drive_1 = phi_1*rate_gain;
    const float drive_2 = phi_2*rate_gain;
    const float drive_3 = rate_gain*rho_p_0;
    const float drive_4 = rate_gain*rho_p_1;
    const float drive_5 = rate_gain*rho_p_2;

    /* s: sliding variable [rad/s, m/s], eq. (SurfaceErr) */
    const float s_0 = drive_0 + nu_e_0;
    const float s_1 = drive_1 + nu_e_1;
    const float s_2 = drive_2 + nu_e_2;
    const float s_3 = drive_3 + nu_e_3;
    const float s_4 = drive_4 + nu_e_4;
    const float s_5 = drive_5 + nu_e_5;

    /* wanted: acceleration asked for [rad/s^2, m/s^2] */
    const float wanted_0 = eta_dot_0 - nu_u_dot_0*rate_gain - reach_gain*s_0;
    const float wanted_1 = eta_dot_1 - nu_u_dot_1*rate_gain - reach_gain*s_1;
    const float wanted_2 = eta_dot_2 - nu_u_dot_2*rate_gain - reach_gain*s_2;
    const float wanted_3 = eta_dot_3 - nu_u_dot_3*rate_gain - reach_gain*s_3;
    const float wanted_4 = eta_dot_4 - nu_u_dot_4*rate_gain - reach_gain*s_4;
    const float wanted_5 = eta_dot_5 - nu_u_dot_5*rate_gain - reach_gain*s_5;

    /* turning: lambda nu_u - eta [rad/s, m/s] */
    const float turning_0 = drive_0 - eta_0;
    const float turning_1 = drive_1 - eta_1;
    const float turning_2 = drive_2 - eta_2;
    const float turning_3 = drive_3 - eta_3;
    const float turning_4 = drive_4 - eta_4;
    const float turning_5 = drive_5 - eta_5;

    /* momentum: I nu [N m s, N s] */
    const float momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2 + inertia_3*nu_3 +
        inertia_4*nu_4 + inertia_5*nu_5;
    const float momentum_1 = inertia_1*nu_0 + inertia_10*nu_5 + inertia_6*nu_1 + inertia_7*nu_2 +
        inertia_8*nu_3 + inertia_9*nu_4;
    const float momentum_2 = inertia_11*nu_2 + inertia_12*nu_3 + inertia_13*nu_4 + inertia_14*nu_5 +
        inertia_2*nu_0 + inertia_7*nu_1;
    const float momentum_3 = inertia_12*nu_2 + inertia_15*nu_3 + inertia_16*nu_4 + inertia_17*nu_5 +
        inertia_3*nu_0 + inertia_8*nu_1;
    const float momentum_4 = inertia_13*nu_2 + inertia_16*nu_3 + inertia_18*nu_4 + inertia_19*nu_5 +
        inertia_4*nu_0 + inertia_9*nu_1;
    const float momentum_5 = inertia_10*nu_1 + inertia_14*nu_2 + inertia_17*nu_3 + inertia_19*nu_4 +
        inertia_20*nu_5 + inertia_5*nu_0;

    /* force: control force, I f_u [N m, N], eq. (TckCtrl) */
    const float force_0 = inertia_0*wanted_0 - external_0 + inertia_1*wanted_1 + inertia_2*wanted_2
        + inertia_3*wanted_3 + inertia_4*wanted_4 + inertia_5*wanted_5 + momentum_1*turning_2 +
        momentum_4*turning_5 - momentum_2*turning_1 - momentum_5*turning_4;
    const float force_1 = inertia_1*wanted_0 - external_1 + inertia_10*wanted_5 + inertia_6*wanted_1
        + inertia_7*wanted_2 + inertia_8*wanted_3 + inertia_9*wanted_4 + momentum_2*turning_0 +
        momentum_5*turning_3 - momentum_0*turning_2 - momentum_3*turning_5;
    const float force_2 = inertia_11*wanted_2 - external_2 + inertia_12*wanted_3 +
        inertia_13*wanted_4 + inertia_14*wanted_5 + inertia_2*wanted_0 + inertia_7*wanted_1 +
        momentum_0*turning_1 + momentum_3*turning_4 - momentum_1*turning_0 - momentum_4*turning_3;
    const float force_3 = inertia_12*wanted_2 - external_3 + inertia_15*wanted_3 +
        inertia_16*wanted_4 + inertia_17*wanted_5 + inertia_3*wanted_0 + inertia_8*wanted_1 +
        momentum_4*turning_2 - momentum_5*turning_1;
    const float force_4 = inertia_13*wanted_2 - external_4 + inertia_16*wanted_3 +
        inertia_18*wanted_4 + inertia_19*wanted_5 + inertia_4*wanted_0 + inertia_9*wanted_1 +
        momentum_5*turning_0 - momentum_3*turning_2;
    const float force_5 = inertia_10*wanted_1 - external_5 + inertia_14*wanted_2 +
        inertia_17*wanted_3 + inertia_19*wanted_4 + inertia_20*wanted_5 + inertia_5*wanted_0 +
        momentum_3*turning_1 - momentum_4*turning_0;

    /* -- end -- */
    command->force[0] = force_0;
    command->force[1] = force_1;
    command->force[2] = force_2;
    command->force[3] = force_3;
    command->force[4] = force_4;
    command->force[5] = force_5;
    command->s[0] = s_0;
    command->s[1] = s_1;
    command->s[2] = s_2;
    command->s[3] = s_3;
    command->s[4] = s_4;
    command->s[5] = s_5;
    command->nu_u[0] = phi_0;
    command->nu_u[1] = phi_1;
    command->nu_u[2] = phi_2;
    command->nu_u[3] = rho_p_0;
    command->nu_u[4] = rho_p_1;
    command->nu_u[5] = rho_p_2;
    command->nu_u_dot[0] = nu_u_dot_0;
    command->nu_u_dot[1] = nu_u_dot_1;
    command->nu_u_dot[2] = nu_u_dot_2;
    command->nu_u_dot[3] = nu_u_dot_3;
    command->nu_u_dot[4] = nu_u_dot_4;
    command->nu_u_dot[5] = nu_u_dot_5;
    return w;
}

/* pivots of the inertia: all positive for a valid one. */
static void underwater_f32_definiteness(const underwater_f32_params *params, float pivot[6])
{
    /* -- definiteness -- */
    const float inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_3 = params->inertia[3],
        inertia_4 = params->inertia[4], inertia_5 = params->inertia[5],
        inertia_6 = params->inertia[6], inertia_7 = params->inertia[7],
        inertia_8 = params->inertia[8], inertia_9 = params->inertia[9],
        inertia_10 = params->inertia[10], inertia_11 = params->inertia[11],
        inertia_12 = params->inertia[12], inertia_13 = params->inertia[13],
        inertia_14 = params->inertia[14], inertia_15 = params->inertia[15],
        inertia_16 = params->inertia[16], inertia_17 = params->inertia[17],
        inertia_18 = params->inertia[18], inertia_19 = params->inertia[19],
        inertia_20 = params->inertia[20];

    /* divisor_0: the pivot, or 1 where it is not positive [kg m^2, kg m, kg] */
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

    /* lower_30: I = L D L^T, entry of L [1] */
    const float lower_30 = inertia_3/divisor_0;

    /* lower_40: I = L D L^T, entry of L [1] */
    const float lower_40 = inertia_4/divisor_0;

    /* lower_50: I = L D L^T, entry of L [1] */
    const float lower_50 = inertia_5/divisor_0;

    /* pivot_1: pivot of I [kg m^2, kg m, kg] */
    const float pivot_1 = inertia_6 - inertia_0*lower_10*lower_10;

    /* divisor_1: the pivot, or 1 where it is not positive [kg m^2, kg m, kg] */
    float divisor_1;
    if (pivot_1 > 0.0F) {
        divisor_1 = pivot_1;
    } else {
        divisor_1 = 1.0F;
    }

    /* lower_21: I = L D L^T, entry of L [1] */
    const float lower_21 = (inertia_7 - inertia_0*lower_10*lower_20)/divisor_1;

    /* lower_31: I = L D L^T, entry of L [1] */
    const float lower_31 = (inertia_8 - inertia_0*lower_10*lower_30)/divisor_1;

    /* lower_41: I = L D L^T, entry of L [1] */
    const float lower_41 = (inertia_9 - inertia_0*lower_10*lower_40)/divisor_1;

    /* lower_51: I = L D L^T, entry of L [1] */
    const float lower_51 = (inertia_10 - inertia_0*lower_10*lower_50)/divisor_1;

    /* pivot_2: pivot of I [kg m^2, kg m, kg] */
    const float pivot_2 = inertia_11 - inertia_0*lower_20*lower_20 - pivot_1*lower_21*lower_21;

    /* divisor_2: the pivot, or 1 where it is not positive [kg m^2, kg m, kg] */
    float divisor_2;
    if (pivot_2 > 0.0F) {
        divisor_2 = pivot_2;
    } else {
        divisor_2 = 1.0F;
    }

    /* lower_32: I = L D L^T, entry of L [1] */
    const float lower_32 = (inertia_12 - inertia_0*lower_20*lower_30 -
        lower_21*lower_31*pivot_1)/divisor_2;

    /* lower_42: I = L D L^T, entry of L [1] */
    const float lower_42 = (inertia_13 - inertia_0*lower_20*lower_40 -
        lower_21*lower_41*pivot_1)/divisor_2;

    /* lower_52: I = L D L^T, entry of L [1] */
    const float lower_52 = (inertia_14 - inertia_0*lower_20*lower_50 -
        lower_21*lower_51*pivot_1)/divisor_2;

    /* pivot_3: pivot of I [kg m^2, kg m, kg] */
    const float pivot_3 = inertia_15 - inertia_0*lower_30*lower_30 - pivot_1*lower_31*lower_31 -
        pivot_2*lower_32*lower_32;

    /* divisor_3: the pivot, or 1 where it is not positive [kg m^2, kg m, kg] */
    float divisor_3;
    if (pivot_3 > 0.0F) {
        divisor_3 = pivot_3;
    } else {
        divisor_3 = 1.0F;
    }

    /* lower_43: I = L D L^T, entry of L [1] */
    const float lower_43 = (inertia_16 - inertia_0*lower_30*lower_40 - lower_31*lower_41*pivot_1 -
        lower_32*lower_42*pivot_2)/divisor_3;

    /* lower_53: I = L D L^T, entry of L [1] */
    const float lower_53 = (inertia_17 - inertia_0*lower_30*lower_50 - lower_31*lower_51*pivot_1 -
        lower_32*lower_52*pivot_2)/divisor_3;

    /* pivot_4: pivot of I [kg m^2, kg m, kg] */
    const float pivot_4 = inertia_18 - inertia_0*lower_40*lower_40 - pivot_1*lower_41*lower_41 -
        pivot_2*lower_42*lower_42 - pivot_3*lower_43*lower_43;

    /* divisor_4: the pivot, or 1 where it is not positive [kg m^2, kg m, kg] */
    float divisor_4;
    if (pivot_4 > 0.0F) {
        divisor_4 = pivot_4;
    } else {
        divisor_4 = 1.0F;
    }

    /* lower_54: I = L D L^T, entry of L [1] */
    const float lower_54 = (inertia_19 - inertia_0*lower_40*lower_50 - lower_41*lower_51*pivot_1 -
        lower_42*lower_52*pivot_2 - lower_43*lower_53*pivot_3)/divisor_4;

    /* pivot_5: pivot of I [kg m^2, kg m, kg] */
    const float pivot_5 = inertia_20 - inertia_0*lower_50*lower_50 - pivot_1*lower_51*lower_51 -
        pivot_2*lower_52*lower_52 - pivot_3*lower_53*lower_53 - pivot_4*lower_54*lower_54;

    /* -- end -- */
    pivot[0] = inertia_0;
    pivot[1] = pivot_1;
    pivot[2] = pivot_2;
    pivot[3] = pivot_3;
    pivot[4] = pivot_4;
    pivot[5] = pivot_5;
}

void underwater_f32_tracking(const underwater_f32_params *params, const underwater_f32_state *state,
        const underwater_f32_reference *reference, underwater_f32_command *command)
{
    /* -- tracking -- */
    const float g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5], g_6 = state->g[6], g_7 = state->g[7],
        g_8 = state->g[8], g_9 = state->g[9], g_10 = state->g[10], g_11 = state->g[11];
    const float g_r_0 = reference->g[0], g_r_1 = reference->g[1], g_r_2 = reference->g[2],
        g_r_3 = reference->g[3], g_r_4 = reference->g[4], g_r_5 = reference->g[5],
        g_r_6 = reference->g[6], g_r_7 = reference->g[7], g_r_8 = reference->g[8],
        g_r_9 = reference->g[9], g_r_10 = reference->g[10], g_r_11 = reference->g[11];

    /* gap_0: translation of g from g_r [m] */
    const float gap_0_0 = g_3 - g_r_3;
    const float gap_0_1 = g_7 - g_r_7;
    const float gap_0_2 = g_11 - g_r_11;

    /* g_e: error, g_r^-1 g [1], eq. (velErr) */
    const float g_e_0 = g_0*g_r_0 + g_4*g_r_4 + g_8*g_r_8;
    const float g_e_1 = g_1*g_r_0 + g_5*g_r_4 + g_9*g_r_8;
    const float g_e_2 = g_10*g_r_8 + g_2*g_r_0 + g_6*g_r_4;
    const float g_e_3 = g_r_0*gap_0_0 + g_r_4*gap_0_1 + g_r_8*gap_0_2;
    const float g_e_4 = g_0*g_r_1 + g_4*g_r_5 + g_8*g_r_9;
    const float g_e_5 = g_1*g_r_1 + g_5*g_r_5 + g_9*g_r_9;
    const float g_e_6 = g_10*g_r_9 + g_2*g_r_1 + g_6*g_r_5;
    const float g_e_7 = g_r_1*gap_0_0 + g_r_5*gap_0_1 + g_r_9*gap_0_2;
    const float g_e_8 = g_0*g_r_2 + g_4*g_r_6 + g_8*g_r_10;
    const float g_e_9 = g_1*g_r_2 + g_5*g_r_6 + g_9*g_r_10;
    const float g_e_10 = g_10*g_r_10 + g_2*g_r_2 + g_6*g_r_6;
    const float g_e_11 = g_r_10*gap_0_2 + g_r_2*gap_0_0 + g_r_6*gap_0_1;

    /* -- end -- */
    (void)underwater_f32_law(params, state, reference, command, g_e_0, g_e_1, g_e_2, g_e_3, g_e_4,
            g_e_5, g_e_6, g_e_7, g_e_8, g_e_9, g_e_10, g_e_11);
}

void underwater_f32_reaching(const underwater_f32_params *params, const underwater_f32_state *state,
        underwater_f32_command *command)
{
    /* -- reaching -- */
    const float inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_3 = params->inertia[3],
        inertia_4 = params->inertia[4], inertia_5 = params->inertia[5],
        inertia_6 = params->inertia[6], inertia_7 = params->inertia[7],
        inertia_8 = params->inertia[8], inertia_9 = params->inertia[9],
        inertia_10 = params->inertia[10], inertia_11 = params->inertia[11],
        inertia_12 = params->inertia[12], inertia_13 = params->inertia[13],
        inertia_14 = params->inertia[14], inertia_15 = params->inertia[15],
        inertia_16 = params->inertia[16], inertia_17 = params->inertia[17],
        inertia_18 = params->inertia[18], inertia_19 = params->inertia[19],
        inertia_20 = params->inertia[20];
    const float rate_gain = params->lambda;
    const float reach_gain = params->k_s;
    const float g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5], g_6 = state->g[6], g_7 = state->g[7],
        g_8 = state->g[8], g_9 = state->g[9], g_10 = state->g[10], g_11 = state->g[11];
    const float nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2], nu_3 = state->nu[3],
        nu_4 = state->nu[4], nu_5 = state->nu[5];
    const float external_0 = state->external[0], external_1 = state->external[1],
        external_2 = state->external[2], external_3 = state->external[3],
        external_4 = state->external[4], external_5 = state->external[5];

    /* pairs: what B's diagonal is made of [1] */
    const float pairs_0 = 1.0F + g_0;
    const float pairs_1 = 1.0F - g_0;
    const float pairs_2 = g_10 + g_5;
    const float pairs_3 = g_5 - g_10;

    /* B: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack */
    const float B_0 = pairs_0 - pairs_2;
    const float B_1 = g_1 + g_4;
    const float B_2 = g_2 + g_8;
    const float B_3 = g_9 - g_6;
    const float B_4 = pairs_1 + pairs_3;
    const float B_5 = g_6 + g_9;
    const float B_6 = g_2 - g_8;
    const float B_7 = pairs_1 - pairs_3;
    const float B_8 = g_4 - g_1;
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

    /* cosine: cos of half the error angle, rounded [1] */
    const float cosine = power_3*scale;

    /* w: cos of half the error angle [1] */
    float w;
    if (cosine >= 1.0F) {
        w = 1.0F;
    } else {
        w = cosine;
    }

    /* v: sin of half the error angle times its axis [1] */
    const float v_0 = power_0*scale;
    const float v_1 = power_1*scale;
    const float v_2 = power_2*scale;

    /* k: half angle over its sine [1] */
    const float k = underwater_f32_k(w);

    /* h: -dk/dw [1] */
    const float h = underwater_f32_h(w);

    /* phi: rotation vector of the error [rad] */
    const float phi_0 = 2.0F*k*v_0;
    const float phi_1 = 2.0F*k*v_1;
    const float phi_2 = 2.0F*k*v_2;

    /* half: 1/(2 k) [1] */
    const float half = 0.5F/k;

    /* swing_p: Y p [m] */
    const float swing_p_0 = g_11*v_1 - g_7*v_2;
    const float swing_p_1 = g_3*v_2 - g_11*v_0;
    const float swing_p_2 = g_7*v_0 - g_3*v_1;

    /* sway_p: Y Y p [m] */
    const float sway_p_0 = swing_p_2*v_1 - swing_p_1*v_2;
    const float sway_p_1 = swing_p_0*v_2 - swing_p_2*v_0;
    const float sway_p_2 = swing_p_1*v_0 - swing_p_0*v_1;

    /* rho_p: p - k Y p + h Y Y p [m] */
    const float rho_p_0 = g_3 + h*sway_p_0 - k*swing_p_0;
    const float rho_p_1 = g_7 + h*sway_p_1 - k*swing_p_1;
    const float rho_p_2 = g_11 + h*sway_p_2 - k*swing_p_2;

    /* y_p: rho/(2 k) [m] */
    const float y_p_0 = half*rho_p_0;
    const float y_p_1 = half*rho_p_1;
    const float y_p_2 = half*rho_p_2;

    /* turn: Y nu_e, Y = ad of y [rad/s, m/s] */
    const float turn_0 = nu_2*v_1 - nu_1*v_2;
    const float turn_1 = nu_0*v_2 - nu_2*v_0;
    const float turn_2 = nu_1*v_0 - nu_0*v_1;
    const float turn_3 = nu_2*y_p_1 + nu_5*v_1 - nu_1*y_p_2 - nu_4*v_2;
    const float turn_4 = nu_0*y_p_2 + nu_3*v_2 - nu_2*y_p_0 - nu_5*v_0;
    const float turn_5 = nu_1*y_p_0 + nu_4*v_0 - nu_0*y_p_1 - nu_3*v_1;

    /* bend: Y Y nu_e [rad/s, m/s] */
    const float bend_0 = turn_2*v_1 - turn_1*v_2;
    const float bend_1 = turn_0*v_2 - turn_2*v_0;
    const float bend_2 = turn_1*v_0 - turn_0*v_1;
    const float bend_3 = turn_2*y_p_1 + turn_5*v_1 - turn_1*y_p_2 - turn_4*v_2;
    const float bend_4 = turn_0*y_p_2 + turn_3*v_2 - turn_2*y_p_0 - turn_5*v_0;
    const float bend_5 = turn_1*y_p_0 + turn_4*v_0 - turn_0*y_p_1 - turn_3*v_1;

    /* m: -dh/dw [1] */
    const float m = underwater_f32_m(w);

    /* along_p: -2 v.q [m] */
    const float along_p = -2.0F*(v_0*y_p_0 + v_1*y_p_1 + v_2*y_p_2);

    /* tail: (Y^2 + s^2) Y^2 nu_e [rad/s, m/s] */
    const float tail_3 = along_p*bend_0;
    const float tail_4 = along_p*bend_1;
    const float tail_5 = along_p*bend_2;

    /* twofold: h^2 - k m/2, of the double root [1] */
    const float twofold = h*h - 0.5F*k*m;

    /* nu_u_dot: exact rate of nu_u [rad/s, m/s] */
    const float nu_u_dot_0 = nu_0 + bend_0*h + k*turn_0;
    const float nu_u_dot_1 = nu_1 + bend_1*h + k*turn_1;
    const float nu_u_dot_2 = nu_2 + bend_2*h + k*turn_2;
    const float nu_u_dot_3 = nu_3 + bend_3*h + k*turn_3 + tail_3*twofold;
    const float nu_u_dot_4 = nu_4 + bend_4*h + k*turn_4 + tail_4*twofold;
    const float nu_u_dot_5 = nu_5 + bend_5*h + k*turn_5 + tail_5*twofold;

    /* drive: lambda nu_u [rad/s, m/s] */
    const float drive_0 = phi_0*rate_gain;
    const float drive_1 = phi_1*rate_gain;
    const float drive_2 = phi_2*rate_gain;
    const float drive_3 = rate_gain*rho_p_0;
    const float drive_4 = rate_gain*rho_p_1;
    const float drive_5 = rate_gain*rho_p_2;

    /* s: sliding variable [rad/s, m/s], eq. (sldS) */
    const float s_0 = drive_0 + nu_0;
    const float s_1 = drive_1 + nu_1;
    const float s_2 = drive_2 + nu_2;
    const float s_3 = drive_3 + nu_3;
    const float s_4 = drive_4 + nu_4;
    const float s_5 = drive_5 + nu_5;

    /* wanted: acceleration asked for [rad/s^2, m/s^2] */
    const float wanted_0 = -(nu_u_dot_0*rate_gain + reach_gain*s_0);
    const float wanted_1 = -(nu_u_dot_1*rate_gain + reach_gain*s_1);
    const float wanted_2 = -(nu_u_dot_2*rate_gain + reach_gain*s_2);
    const float wanted_3 = -(nu_u_dot_3*rate_gain + reach_gain*s_3);
    const float wanted_4 = -(nu_u_dot_4*rate_gain + reach_gain*s_4);
    const float wanted_5 = -(nu_u_dot_5*rate_gain + reach_gain*s_5);

    /* momentum: I nu [N m s, N s] */
    const float momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2 + inertia_3*nu_3 +
        inertia_4*nu_4 + inertia_5*nu_5;
    const float momentum_1 = inertia_1*nu_0 + inertia_10*nu_5 + inertia_6*nu_1 + inertia_7*nu_2 +
        inertia_8*nu_3 + inertia_9*nu_4;
    const float momentum_2 = inertia_11*nu_2 + inertia_12*nu_3 + inertia_13*nu_4 + inertia_14*nu_5 +
        inertia_2*nu_0 + inertia_7*nu_1;
    const float momentum_3 = inertia_12*nu_2 + inertia_15*nu_3 + inertia_16*nu_4 + inertia_17*nu_5 +
        inertia_3*nu_0 + inertia_8*nu_1;
    const float momentum_4 = inertia_13*nu_2 + inertia_16*nu_3 + inertia_18*nu_4 + inertia_19*nu_5 +
        inertia_4*nu_0 + inertia_9*nu_1;
    const float momentum_5 = inertia_10*nu_1 + inertia_14*nu_2 + inertia_17*nu_3 + inertia_19*nu_4 +
        inertia_20*nu_5 + inertia_5*nu_0;

    /* force: control force, I f_u [N m, N], eq. (Ctrl2) */
    const float force_0 = drive_2*momentum_1 - external_0 + drive_5*momentum_4 + inertia_0*wanted_0
        + inertia_1*wanted_1 + inertia_2*wanted_2 + inertia_3*wanted_3 + inertia_4*wanted_4 +
        inertia_5*wanted_5 - drive_1*momentum_2 - drive_4*momentum_5;
    const float force_1 = drive_0*momentum_2 - external_1 + drive_3*momentum_5 + inertia_1*wanted_0
        + inertia_10*wanted_5 + inertia_6*wanted_1 + inertia_7*wanted_2 + inertia_8*wanted_3 +
        inertia_9*wanted_4 - drive_2*momentum_0 - drive_5*momentum_3;
    const float force_2 = drive_1*momentum_0 - external_2 + drive_4*momentum_3 + inertia_11*wanted_2
        + inertia_12*wanted_3 + inertia_13*wanted_4 + inertia_14*wanted_5 + inertia_2*wanted_0 +
        inertia_7*wanted_1 - drive_0*momentum_1 - drive_3*momentum_4;
    const float force_3 = drive_2*momentum_4 - external_3 + inertia_12*wanted_2 +
        inertia_15*wanted_3 + inertia_16*wanted_4 + inertia_17*wanted_5 + inertia_3*wanted_0 +
        inertia_8*wanted_1 - drive_1*momentum_5;
    const float force_4 = drive_0*momentum_5 - external_4 + inertia_13*wanted_2 +
        inertia_16*wanted_3 + inertia_18*wanted_4 + inertia_19*wanted_5 + inertia_4*wanted_0 +
        inertia_9*wanted_1 - drive_2*momentum_3;
    const float force_5 = drive_1*momentum_3 - external_5 + inertia_10*wanted_1 +
        inertia_14*wanted_2 + inertia_17*wanted_3 + inertia_19*wanted_4 + inertia_20*wanted_5 +
        inertia_5*wanted_0 - drive_0*momentum_4;

    /* -- end -- */
    command->force[0] = force_0;
    command->force[1] = force_1;
    command->force[2] = force_2;
    command->force[3] = force_3;
    command->force[4] = force_4;
    command->force[5] = force_5;
    command->s[0] = s_0;
    command->s[1] = s_1;
    command->s[2] = s_2;
    command->s[3] = s_3;
    command->s[4] = s_4;
    command->s[5] = s_5;
    command->nu_u[0] = phi_0;
    command->nu_u[1] = phi_1;
    command->nu_u[2] = phi_2;
    command->nu_u[3] = rho_p_0;
    command->nu_u[4] = rho_p_1;
    command->nu_u[5] = rho_p_2;
    command->nu_u_dot[0] = nu_u_dot_0;
    command->nu_u_dot[1] = nu_u_dot_1;
    command->nu_u_dot[2] = nu_u_dot_2;
    command->nu_u_dot[3] = nu_u_dot_3;
    command->nu_u_dot[4] = nu_u_dot_4;
    command->nu_u_dot[5] = nu_u_dot_5;
}

void underwater_f32_plant(const underwater_f32_params *params, const underwater_f32_state *state,
        const float force[6], float nu_dot[6])
{
    /* -- plant -- */
    const float inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_3 = params->inertia[3],
        inertia_4 = params->inertia[4], inertia_5 = params->inertia[5],
        inertia_6 = params->inertia[6], inertia_7 = params->inertia[7],
        inertia_8 = params->inertia[8], inertia_9 = params->inertia[9],
        inertia_10 = params->inertia[10], inertia_11 = params->inertia[11],
        inertia_12 = params->inertia[12], inertia_13 = params->inertia[13],
        inertia_14 = params->inertia[14], inertia_15 = params->inertia[15],
        inertia_16 = params->inertia[16], inertia_17 = params->inertia[17],
        inertia_18 = params->inertia[18], inertia_19 = params->inertia[19],
        inertia_20 = params->inertia[20];
    const float nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2], nu_3 = state->nu[3],
        nu_4 = state->nu[4], nu_5 = state->nu[5];
    const float external_0 = state->external[0], external_1 = state->external[1],
        external_2 = state->external[2], external_3 = state->external[3],
        external_4 = state->external[4], external_5 = state->external[5];
    const float force_0 = force[0], force_1 = force[1], force_2 = force[2], force_3 = force[3],
        force_4 = force[4], force_5 = force[5];

    /* momentum: I nu [N m s, N s] */
    const float momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2 + inertia_3*nu_3 +
        inertia_4*nu_4 + inertia_5*nu_5;
    const float momentum_1 = inertia_1*nu_0 + inertia_10*nu_5 + inertia_6*nu_1 + inertia_7*nu_2 +
        inertia_8*nu_3 + inertia_9*nu_4;
    const float momentum_2 = inertia_11*nu_2 + inertia_12*nu_3 + inertia_13*nu_4 + inertia_14*nu_5 +
        inertia_2*nu_0 + inertia_7*nu_1;
    const float momentum_3 = inertia_12*nu_2 + inertia_15*nu_3 + inertia_16*nu_4 + inertia_17*nu_5 +
        inertia_3*nu_0 + inertia_8*nu_1;
    const float momentum_4 = inertia_13*nu_2 + inertia_16*nu_3 + inertia_18*nu_4 + inertia_19*nu_5 +
        inertia_4*nu_0 + inertia_9*nu_1;
    const float momentum_5 = inertia_10*nu_1 + inertia_14*nu_2 + inertia_17*nu_3 + inertia_19*nu_4 +
        inertia_20*nu_5 + inertia_5*nu_0;

    /* total: coad(nu) I nu + force [N m, N] */
    const float total_0 = external_0 + force_0 + momentum_1*nu_2 + momentum_4*nu_5 - momentum_2*nu_1
        - momentum_5*nu_4;
    const float total_1 = external_1 + force_1 + momentum_2*nu_0 + momentum_5*nu_3 - momentum_0*nu_2
        - momentum_3*nu_5;
    const float total_2 = external_2 + force_2 + momentum_0*nu_1 + momentum_3*nu_4 - momentum_1*nu_0
        - momentum_4*nu_3;
    const float total_3 = external_3 + force_3 + momentum_4*nu_2 - momentum_5*nu_1;
    const float total_4 = external_4 + force_4 + momentum_5*nu_0 - momentum_3*nu_2;
    const float total_5 = external_5 + force_5 + momentum_3*nu_1 - momentum_4*nu_0;

    /* lower_10: I = L D L^T, entry of L [1] */
    const float lower_10 = inertia_1/inertia_0;

    /* lower_20: I = L D L^T, entry of L [1] */
    const float lower_20 = inertia_2/inertia_0;

    /* lower_30: I = L D L^T, entry of L [1] */
    const float lower_30 = inertia_3/inertia_0;

    /* lower_40: I = L D L^T, entry of L [1] */
    const float lower_40 = inertia_4/inertia_0;

    /* lower_50: I = L D L^T, entry of L [1] */
    const float lower_50 = inertia_5/inertia_0;

    /* pivot_1: pivot of I [kg m^2, kg m, kg] */
    const float pivot_1 = inertia_6 - inertia_0*lower_10*lower_10;

    /* lower_21: I = L D L^T, entry of L [1] */
    const float lower_21 = (inertia_7 - inertia_0*lower_10*lower_20)/pivot_1;

    /* lower_31: I = L D L^T, entry of L [1] */
    const float lower_31 = (inertia_8 - inertia_0*lower_10*lower_30)/pivot_1;

    /* lower_41: I = L D L^T, entry of L [1] */
    const float lower_41 = (inertia_9 - inertia_0*lower_10*lower_40)/pivot_1;

    /* lower_51: I = L D L^T, entry of L [1] */
    const float lower_51 = (inertia_10 - inertia_0*lower_10*lower_50)/pivot_1;

    /* pivot_2: pivot of I [kg m^2, kg m, kg] */
    const float pivot_2 = inertia_11 - inertia_0*lower_20*lower_20 - pivot_1*lower_21*lower_21;

    /* lower_32: I = L D L^T, entry of L [1] */
    const float lower_32 = (inertia_12 - inertia_0*lower_20*lower_30 -
        lower_21*lower_31*pivot_1)/pivot_2;

    /* lower_42: I = L D L^T, entry of L [1] */
    const float lower_42 = (inertia_13 - inertia_0*lower_20*lower_40 -
        lower_21*lower_41*pivot_1)/pivot_2;

    /* lower_52: I = L D L^T, entry of L [1] */
    const float lower_52 = (inertia_14 - inertia_0*lower_20*lower_50 -
        lower_21*lower_51*pivot_1)/pivot_2;

    /* pivot_3: pivot of I [kg m^2, kg m, kg] */
    const float pivot_3 = inertia_15 - inertia_0*lower_30*lower_30 - pivot_1*lower_31*lower_31 -
        pivot_2*lower_32*lower_32;

    /* lower_43: I = L D L^T, entry of L [1] */
    const float lower_43 = (inertia_16 - inertia_0*lower_30*lower_40 - lower_31*lower_41*pivot_1 -
        lower_32*lower_42*pivot_2)/pivot_3;

    /* lower_53: I = L D L^T, entry of L [1] */
    const float lower_53 = (inertia_17 - inertia_0*lower_30*lower_50 - lower_31*lower_51*pivot_1 -
        lower_32*lower_52*pivot_2)/pivot_3;

    /* pivot_4: pivot of I [kg m^2, kg m, kg] */
    const float pivot_4 = inertia_18 - inertia_0*lower_40*lower_40 - pivot_1*lower_41*lower_41 -
        pivot_2*lower_42*lower_42 - pivot_3*lower_43*lower_43;

    /* lower_54: I = L D L^T, entry of L [1] */
    const float lower_54 = (inertia_19 - inertia_0*lower_40*lower_50 - lower_41*lower_51*pivot_1 -
        lower_42*lower_52*pivot_2 - lower_43*lower_53*pivot_3)/pivot_4;

    /* pivot_5: pivot of I [kg m^2, kg m, kg] */
    const float pivot_5 = inertia_20 - inertia_0*lower_50*lower_50 - pivot_1*lower_51*lower_51 -
        pivot_2*lower_52*lower_52 - pivot_3*lower_53*lower_53 - pivot_4*lower_54*lower_54;

    /* forward_1: forward substitution [N m, N] */
    const float forward_1 = total_1 - lower_10*total_0;

    /* forward_2: forward substitution [N m, N] */
    const float forward_2 = total_2 - forward_1*lower_21 - lower_20*total_0;

    /* forward_3: forward substitution [N m, N] */
    const float forward_3 = total_3 - forward_1*lower_31 - forward_2*lower_32 - lower_30*total_0;

    /* forward_4: forward substitution [N m, N] */
    const float forward_4 = total_4 - forward_1*lower_41 - forward_2*lower_42 - forward_3*lower_43 -
        lower_40*total_0;

    /* forward_5: forward substitution [N m, N] */
    const float forward_5 = total_5 - forward_1*lower_51 - forward_2*lower_52 - forward_3*lower_53 -
        forward_4*lower_54 - lower_50*total_0;

    /* back_5: back substitution [rad/s^2, m/s^2] */
    const float back_5 = forward_5/pivot_5;

    /* back_4: back substitution [rad/s^2, m/s^2] */
    const float back_4 = forward_4/pivot_4 - back_5*lower_54;

    /* back_3: back substitution [rad/s^2, m/s^2] */
    const float back_3 = forward_3/pivot_3 - back_4*lower_43 - back_5*lower_53;

    /* back_2: back substitution [rad/s^2, m/s^2] */
    const float back_2 = forward_2/pivot_2 - back_3*lower_32 - back_4*lower_42 - back_5*lower_52;

    /* back_1: back substitution [rad/s^2, m/s^2] */
    const float back_1 = forward_1/pivot_1 - back_2*lower_21 - back_3*lower_31 - back_4*lower_41 -
        back_5*lower_51;

    /* back_0: back substitution [rad/s^2, m/s^2] */
    const float back_0 = total_0/inertia_0 - back_1*lower_10 - back_2*lower_20 - back_3*lower_30 -
        back_4*lower_40 - back_5*lower_50;

    /* -- end -- */
    nu_dot[0] = back_0;
    nu_dot[1] = back_1;
    nu_dot[2] = back_2;
    nu_dot[3] = back_3;
    nu_dot[4] = back_4;
    nu_dot[5] = back_5;
}

/* The worse of two findings. */
static underwater_f32_status underwater_f32_worse(const underwater_f32_status a,
        const underwater_f32_status b)
{
    return a > b ? a : b;
}

/* OUT_OF_RANGE or NONFINITE_INPUT if any number is larger than a limit or not finite. */
static underwater_f32_status underwater_f32_inspect(const float *numbers, const int count,
        const float limit)
{
    underwater_f32_status worst = UNDERWATER_F32_OK;
    int i;
    for (i = 0; i < count; i++) {
        if (!isfinite(numbers[i])) {
            worst = UNDERWATER_F32_NONFINITE_INPUT;
        } else if (fabsf(numbers[i]) > limit) {
            worst = underwater_f32_worse(worst, UNDERWATER_F32_OUT_OF_RANGE);
        } else {
            /* finite and in range: it leaves the finding as it is */
        }
    }
    return worst;
}

/* Zero command; its status says what is wrong with what was refused, at least what was found. */
static underwater_f32_status underwater_f32_refuse(const underwater_f32_state *state,
        const underwater_f32_reference *reference, const underwater_f32_status found,
        underwater_f32_command *command)
{
    underwater_f32_status worst = found;
    worst = underwater_f32_worse(worst,
            underwater_f32_inspect(state->g, 16, UNDERWATER_F32_MAX_INPUT));
    worst = underwater_f32_worse(worst,
            underwater_f32_inspect(state->nu, 6, UNDERWATER_F32_MAX_INPUT));
    worst = underwater_f32_worse(worst,
            underwater_f32_inspect(state->external, 6, UNDERWATER_F32_MAX_INPUT));
    worst = underwater_f32_worse(worst,
            underwater_f32_inspect(reference->g, 16, UNDERWATER_F32_MAX_INPUT));
    worst = underwater_f32_worse(worst,
            underwater_f32_inspect(reference->nu, 6, UNDERWATER_F32_MAX_INPUT));
    worst = underwater_f32_worse(worst,
            underwater_f32_inspect(reference->nu_dot, 6, UNDERWATER_F32_MAX_INPUT));
    underwater_f32_nothing(command);
    return worst;
}

/* What a computed command is worth, given its distance from the cut locus of the law. */
static underwater_f32_status underwater_f32_verdict(const float clearance,
        underwater_f32_command *command)
{
    if (!(isfinite(command->force[0]) && isfinite(command->force[1]) && isfinite(command->force[2])
            && isfinite(command->force[3]) && isfinite(command->force[4])
            && isfinite(command->force[5]))) {
        underwater_f32_nothing(command);
        return UNDERWATER_F32_NONFINITE_INPUT;
    }
    return clearance < UNDERWATER_F32_NEAR_CUT ? UNDERWATER_F32_NEAR_CUT_LOCUS : UNDERWATER_F32_OK;
}

underwater_f32_status underwater_f32_control(const underwater_f32_params *params,
        const underwater_f32_state *state, const underwater_f32_reference *reference,
        underwater_f32_command *command)
{
    float clearance;
#ifdef UNDERWATER_CHECK_POINTERS
    if (params == NULL || state == NULL || reference == NULL || command == NULL) {
        if (command != NULL) {
            underwater_f32_nothing(command);
        }
        return UNDERWATER_F32_BAD_PARAMS;
    }
#endif
    /* -- tracking -- */
    const float g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5], g_6 = state->g[6], g_7 = state->g[7],
        g_8 = state->g[8], g_9 = state->g[9], g_10 = state->g[10], g_11 = state->g[11];
    const float g_r_0 = reference->g[0], g_r_1 = reference->g[1], g_r_2 = reference->g[2],
        g_r_3 = reference->g[3], g_r_4 = reference->g[4], g_r_5 = reference->g[5],
        g_r_6 = reference->g[6], g_r_7 = reference->g[7], g_r_8 = reference->g[8],
        g_r_9 = reference->g[9], g_r_10 = reference->g[10], g_r_11 = reference->g[11];

    /* gap_0: translation of g from g_r [m] */
    const float gap_0_0 = g_3 - g_r_3;
    const float gap_0_1 = g_7 - g_r_7;
    const float gap_0_2 = g_11 - g_r_11;

    /* g_e: error, g_r^-1 g [1], eq. (velErr) */
    const float g_e_0 = g_0*g_r_0 + g_4*g_r_4 + g_8*g_r_8;
    const float g_e_1 = g_1*g_r_0 + g_5*g_r_4 + g_9*g_r_8;
    const float g_e_2 = g_10*g_r_8 + g_2*g_r_0 + g_6*g_r_4;
    const float g_e_3 = g_r_0*gap_0_0 + g_r_4*gap_0_1 + g_r_8*gap_0_2;
    const float g_e_4 = g_0*g_r_1 + g_4*g_r_5 + g_8*g_r_9;
    const float g_e_5 = g_1*g_r_1 + g_5*g_r_5 + g_9*g_r_9;
    const float g_e_6 = g_10*g_r_9 + g_2*g_r_1 + g_6*g_r_5;
    const float g_e_7 = g_r_1*gap_0_0 + g_r_5*gap_0_1 + g_r_9*gap_0_2;
    const float g_e_8 = g_0*g_r_2 + g_4*g_r_6 + g_8*g_r_10;
    const float g_e_9 = g_1*g_r_2 + g_5*g_r_6 + g_9*g_r_10;
    const float g_e_10 = g_10*g_r_10 + g_2*g_r_2 + g_6*g_r_6;
    const float g_e_11 = g_r_10*gap_0_2 + g_r_2*gap_0_0 + g_r_6*gap_0_1;

    /* -- end -- */
    if (!(fabsf(g_e_0) <= UNDERWATER_F32_MAX_ENTRY && fabsf(g_e_1) <= UNDERWATER_F32_MAX_ENTRY
            && fabsf(g_e_2) <= UNDERWATER_F32_MAX_ENTRY && fabsf(g_e_3) <= UNDERWATER_F32_MAX_REACH
            && fabsf(g_e_4) <= UNDERWATER_F32_MAX_ENTRY && fabsf(g_e_5) <= UNDERWATER_F32_MAX_ENTRY
            && fabsf(g_e_6) <= UNDERWATER_F32_MAX_ENTRY && fabsf(g_e_7) <= UNDERWATER_F32_MAX_REACH
            && fabsf(g_e_8) <= UNDERWATER_F32_MAX_ENTRY && fabsf(g_e_9) <= UNDERWATER_F32_MAX_ENTRY
            && fabsf(g_e_10) <= UNDERWATER_F32_MAX_ENTRY
            && fabsf(g_e_11) <= UNDERWATER_F32_MAX_REACH
            && fabsf(state->g[3]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(state->g[7]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(state->g[11]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(state->nu[0]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(state->nu[1]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(state->nu[2]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(state->nu[3]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(state->nu[4]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(state->nu[5]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(state->external[0]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(state->external[1]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(state->external[2]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(state->external[3]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(state->external[4]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(state->external[5]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(reference->g[3]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(reference->g[7]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(reference->g[11]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(reference->nu[0]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(reference->nu[1]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(reference->nu[2]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(reference->nu[3]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(reference->nu[4]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(reference->nu[5]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(reference->nu_dot[0]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(reference->nu_dot[1]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(reference->nu_dot[2]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(reference->nu_dot[3]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(reference->nu_dot[4]) <= UNDERWATER_F32_MAX_INPUT
            && fabsf(reference->nu_dot[5]) <= UNDERWATER_F32_MAX_INPUT)) {
        if (fabsf(g_e_3) <= UNDERWATER_F32_MAX_REACH && fabsf(g_e_7) <= UNDERWATER_F32_MAX_REACH
                && fabsf(g_e_11) <= UNDERWATER_F32_MAX_REACH) {
            return underwater_f32_refuse(state, reference, UNDERWATER_F32_NOT_ON_GROUP, command);
        }
        return underwater_f32_refuse(state, reference, UNDERWATER_F32_OUT_OF_RANGE, command);
    }
    /* -- drift -- */
    const float g_12 = state->g[12], g_13 = state->g[13], g_14 = state->g[14], g_15 = state->g[15];
    const float g_r_12 = reference->g[12], g_r_13 = reference->g[13], g_r_14 = reference->g[14],
        g_r_15 = reference->g[15];

    /* off: what vanishes on the group, and only there [1] */
    const float off_0 = g_e_0*g_e_0 - 1.0F + g_e_4*g_e_4 + g_e_8*g_e_8;
    const float off_1 = g_e_0*g_e_1 + g_e_4*g_e_5 + g_e_8*g_e_9;
    const float off_2 = g_e_1*g_e_1 - 1.0F + g_e_5*g_e_5 + g_e_9*g_e_9;
    const float off_3 = g_e_2 + g_e_5*g_e_8 - g_e_4*g_e_9;
    const float off_4 = g_e_6 + g_e_0*g_e_9 - g_e_1*g_e_8;
    const float off_5 = g_e_10 + g_e_1*g_e_4 - g_e_0*g_e_5;
    const float off_9 = g_15 - 1.0F;
    const float off_13 = g_r_15 - 1.0F;

    /* drift: square of the distance from the group [1] */
    const float drift = g_12*g_12 + g_13*g_13 + g_14*g_14 + g_r_12*g_r_12 + g_r_13*g_r_13 +
        g_r_14*g_r_14 + off_0*off_0 + off_1*off_1 + off_13*off_13 + off_2*off_2 + off_3*off_3 +
        off_4*off_4 + off_5*off_5 + off_9*off_9;

    /* -- end -- */

    if (!(drift < params->max_drift*params->max_drift)) {
        return underwater_f32_refuse(state, reference, UNDERWATER_F32_NOT_ON_GROUP, command);
    }
    clearance = underwater_f32_law(params, state, reference, command, g_e_0, g_e_1, g_e_2, g_e_3,
            g_e_4, g_e_5, g_e_6, g_e_7, g_e_8, g_e_9, g_e_10, g_e_11);
    return underwater_f32_verdict(clearance, command);
}

underwater_f32_status underwater_f32_check_params(const underwater_f32_params *params)
{
#ifdef UNDERWATER_CHECK_POINTERS
    if (params == NULL) {
        return UNDERWATER_F32_BAD_PARAMS;
    }
#endif
    float pivot[6];
    int i;
    if (underwater_f32_inspect(params->inertia, 21, UNDERWATER_F32_MAX_PARAM) != UNDERWATER_F32_OK)
            {
        return UNDERWATER_F32_BAD_PARAMS;
    }
    if (!(params->lambda >= UNDERWATER_F32_MIN_GAIN && params->lambda <= UNDERWATER_F32_MAX_RATE)) {
        return UNDERWATER_F32_BAD_PARAMS;
    }
    if (!(params->k_s >= UNDERWATER_F32_MIN_GAIN && params->k_s <= UNDERWATER_F32_MAX_RATE)) {
        return UNDERWATER_F32_BAD_PARAMS;
    }
    if (!(params->max_drift >= UNDERWATER_F32_LEAST_DRIFT && params->max_drift <=
            UNDERWATER_F32_MOST_DRIFT)) {
        return UNDERWATER_F32_BAD_PARAMS;
    }
    underwater_f32_definiteness(params, pivot);
    for (i = 0; i < 6; i++) {
        if (!(pivot[i] > 0.0F)) {
            return UNDERWATER_F32_BAD_PARAMS;
        }
    }
    return UNDERWATER_F32_OK;
}
