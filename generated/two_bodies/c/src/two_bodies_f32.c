/*
 * two_bodies_f32: gsmc on SE3 x SO3, law log (the logarithm and the rotation vector), float
         precision.
 * Every step below carries its quantity, unit and equation; trace.csv lists them by line.
 */
#include "two_bodies_f32.h"

#include <math.h>

#ifdef TWO_BODIES_CHECK_POINTERS /* that none is null: a precondition, which the self-test checks */
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

const two_bodies_f32_params two_bodies_f32_defaults = {
    {0.1827F, 0.0F, 0.004F, 0.0F, -0.18F, 0.0F, 0.0F, 0.0F, 0.0F, 0.2127F, 0.0F, 0.18F, 0.0F, 0.0F,
     0.0F, 0.0F, 0.0F, 0.15F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 12.0F, 0.0F, 0.0F, 0.0F, 0.0F,
     0.0F, 12.0F, 0.0F, 0.0F, 0.0F, 0.0F, 12.0F, 0.0F, 0.0F, 0.0F, 0.0421F, 0.0F, 0.0F, 0.0417F,
     0.0F, 0.0067F},
    0.08F, /* lambda */
    0.3F, /* k_s */
    0.0001F /* max_drift */
};

/* Kernel function k(w) on 0 <= w <= 1, a polynomial in 1 - w. */
static inline float two_bodies_f32_k(const float w)
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
static inline float two_bodies_f32_h(const float w)
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
static inline float two_bodies_f32_m(const float w)
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
static void two_bodies_f32_nothing(two_bodies_f32_command *command)
{
    command->force[0] = 0.0F;
    command->force[1] = 0.0F;
    command->force[2] = 0.0F;
    command->force[3] = 0.0F;
    command->force[4] = 0.0F;
    command->force[5] = 0.0F;
    command->force[6] = 0.0F;
    command->force[7] = 0.0F;
    command->force[8] = 0.0F;
    command->s[0] = 0.0F;
    command->s[1] = 0.0F;
    command->s[2] = 0.0F;
    command->s[3] = 0.0F;
    command->s[4] = 0.0F;
    command->s[5] = 0.0F;
    command->s[6] = 0.0F;
    command->s[7] = 0.0F;
    command->s[8] = 0.0F;
    command->nu_u[0] = 0.0F;
    command->nu_u[1] = 0.0F;
    command->nu_u[2] = 0.0F;
    command->nu_u[3] = 0.0F;
    command->nu_u[4] = 0.0F;
    command->nu_u[5] = 0.0F;
    command->nu_u[6] = 0.0F;
    command->nu_u[7] = 0.0F;
    command->nu_u[8] = 0.0F;
    command->nu_u_dot[0] = 0.0F;
    command->nu_u_dot[1] = 0.0F;
    command->nu_u_dot[2] = 0.0F;
    command->nu_u_dot[3] = 0.0F;
    command->nu_u_dot[4] = 0.0F;
    command->nu_u_dot[5] = 0.0F;
    command->nu_u_dot[6] = 0.0F;
    command->nu_u_dot[7] = 0.0F;
    command->nu_u_dot[8] = 0.0F;
}

/* force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl), past the error. Gives its clearance, 0
   where the law jumps. */
static float two_bodies_f32_law(const two_bodies_f32_params *params,
        const two_bodies_f32_state *state, const two_bodies_f32_reference *reference,
        two_bodies_f32_command *command, const float g_e_0, const float g_e_1, const float g_e_2,
        const float g_e_3, const float g_e_4, const float g_e_5, const float g_e_6,
        const float g_e_7, const float g_e_8, const float g_e_9, const float g_e_10,
        const float g_e_11, const float g_e_16, const float g_e_17, const float g_e_18,
        const float g_e_19, const float g_e_20, const float g_e_21, const float g_e_22,
        const float g_e_23, const float g_e_24)
{
    /* -- tracking -- */
    const float inertia_0 = params->inertia[0], inertia_2 = params->inertia[2],
        inertia_4 = params->inertia[4], inertia_9 = params->inertia[9],
        inertia_11 = params->inertia[11], inertia_17 = params->inertia[17],
        inertia_24 = params->inertia[24], inertia_30 = params->inertia[30],
        inertia_35 = params->inertia[35], inertia_39 = params->inertia[39],
        inertia_42 = params->inertia[42], inertia_44 = params->inertia[44];
    const float rate_gain = params->lambda;
    const float reach_gain = params->k_s;
    const float nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2], nu_3 = state->nu[3],
        nu_4 = state->nu[4], nu_5 = state->nu[5], nu_6 = state->nu[6], nu_7 = state->nu[7],
        nu_8 = state->nu[8];
    const float nu_r_0 = reference->nu[0], nu_r_1 = reference->nu[1], nu_r_2 = reference->nu[2],
        nu_r_3 = reference->nu[3], nu_r_4 = reference->nu[4], nu_r_5 = reference->nu[5],
        nu_r_6 = reference->nu[6], nu_r_7 = reference->nu[7], nu_r_8 = reference->nu[8];
    const float nu_r_dot_0 = reference->nu_dot[0], nu_r_dot_1 = reference->nu_dot[1],
        nu_r_dot_2 = reference->nu_dot[2], nu_r_dot_3 = reference->nu_dot[3],
        nu_r_dot_4 = reference->nu_dot[4], nu_r_dot_5 = reference->nu_dot[5],
        nu_r_dot_6 = reference->nu_dot[6], nu_r_dot_7 = reference->nu_dot[7],
        nu_r_dot_8 = reference->nu_dot[8];

    /* eta_arm_0_a: velocity at p [m/s] */
    const float eta_arm_0_a_0 = nu_r_3 + g_e_11*nu_r_1 - g_e_7*nu_r_2;
    const float eta_arm_0_a_1 = nu_r_4 + g_e_3*nu_r_2 - g_e_11*nu_r_0;
    const float eta_arm_0_a_2 = nu_r_5 + g_e_7*nu_r_0 - g_e_3*nu_r_1;

    /* eta: reference velocity in the body frame [rad/s, m/s], eq. (velErr) */
    const float eta_0 = g_e_0*nu_r_0 + g_e_4*nu_r_1 + g_e_8*nu_r_2;
    const float eta_1 = g_e_1*nu_r_0 + g_e_5*nu_r_1 + g_e_9*nu_r_2;
    const float eta_2 = g_e_10*nu_r_2 + g_e_2*nu_r_0 + g_e_6*nu_r_1;
    const float eta_3 = eta_arm_0_a_0*g_e_0 + eta_arm_0_a_1*g_e_4 + eta_arm_0_a_2*g_e_8;
    const float eta_4 = eta_arm_0_a_0*g_e_1 + eta_arm_0_a_1*g_e_5 + eta_arm_0_a_2*g_e_9;
    const float eta_5 = eta_arm_0_a_0*g_e_2 + eta_arm_0_a_1*g_e_6 + eta_arm_0_a_2*g_e_10;
    const float eta_6 = g_e_16*nu_r_6 + g_e_19*nu_r_7 + g_e_22*nu_r_8;
    const float eta_7 = g_e_17*nu_r_6 + g_e_20*nu_r_7 + g_e_23*nu_r_8;
    const float eta_8 = g_e_18*nu_r_6 + g_e_21*nu_r_7 + g_e_24*nu_r_8;

    /* nu_e: velocity error [rad/s, m/s], eq. (velErr) */
    const float nu_e_0 = nu_0 - eta_0;
    const float nu_e_1 = nu_1 - eta_1;
    const float nu_e_2 = nu_2 - eta_2;
    const float nu_e_3 = nu_3 - eta_3;
    const float nu_e_4 = nu_4 - eta_4;
    const float nu_e_5 = nu_5 - eta_5;
    const float nu_e_6 = nu_6 - eta_6;
    const float nu_e_7 = nu_7 - eta_7;
    const float nu_e_8 = nu_8 - eta_8;

    /* eta_dot_arm_0_a: velocity at p [m/s] */
    const float eta_dot_arm_0_a_0 = nu_r_dot_3 + g_e_11*nu_r_dot_1 - g_e_7*nu_r_dot_2;
    const float eta_dot_arm_0_a_1 = nu_r_dot_4 + g_e_3*nu_r_dot_2 - g_e_11*nu_r_dot_0;
    const float eta_dot_arm_0_a_2 = nu_r_dot_5 + g_e_7*nu_r_dot_0 - g_e_3*nu_r_dot_1;

    /* eta_dot: exact rate of eta [rad/s^2, m/s^2] */
    const float eta_dot_0 = eta_1*nu_e_2 + g_e_0*nu_r_dot_0 + g_e_4*nu_r_dot_1 + g_e_8*nu_r_dot_2 -
        eta_2*nu_e_1;
    const float eta_dot_1 = eta_2*nu_e_0 + g_e_1*nu_r_dot_0 + g_e_5*nu_r_dot_1 + g_e_9*nu_r_dot_2 -
        eta_0*nu_e_2;
    const float eta_dot_2 = eta_0*nu_e_1 + g_e_10*nu_r_dot_2 + g_e_2*nu_r_dot_0 + g_e_6*nu_r_dot_1 -
        eta_1*nu_e_0;
    const float eta_dot_3 = eta_1*nu_e_5 + eta_4*nu_e_2 + eta_dot_arm_0_a_0*g_e_0 +
        eta_dot_arm_0_a_1*g_e_4 + eta_dot_arm_0_a_2*g_e_8 - eta_2*nu_e_4 - eta_5*nu_e_1;
    const float eta_dot_4 = eta_2*nu_e_3 + eta_5*nu_e_0 + eta_dot_arm_0_a_0*g_e_1 +
        eta_dot_arm_0_a_1*g_e_5 + eta_dot_arm_0_a_2*g_e_9 - eta_0*nu_e_5 - eta_3*nu_e_2;
    const float eta_dot_5 = eta_0*nu_e_4 + eta_3*nu_e_1 + eta_dot_arm_0_a_0*g_e_2 +
        eta_dot_arm_0_a_1*g_e_6 + eta_dot_arm_0_a_2*g_e_10 - eta_1*nu_e_3 - eta_4*nu_e_0;
    const float eta_dot_6 = eta_7*nu_e_8 + g_e_16*nu_r_dot_6 + g_e_19*nu_r_dot_7 + g_e_22*nu_r_dot_8
        - eta_8*nu_e_7;
    const float eta_dot_7 = eta_8*nu_e_6 + g_e_17*nu_r_dot_6 + g_e_20*nu_r_dot_7 + g_e_23*nu_r_dot_8
        - eta_6*nu_e_8;
    const float eta_dot_8 = eta_6*nu_e_7 + g_e_18*nu_r_dot_6 + g_e_21*nu_r_dot_7 + g_e_24*nu_r_dot_8
        - eta_7*nu_e_6;

    /* pairs_a: what B's diagonal is made of [1] */
    const float pairs_a_0 = 1.0F + g_e_0;
    const float pairs_a_1 = 1.0F - g_e_0;
    const float pairs_a_2 = g_e_10 + g_e_5;
    const float pairs_a_3 = g_e_5 - g_e_10;

    /* B_a: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack */
    const float B_a_0 = pairs_a_0 - pairs_a_2;
    const float B_a_1 = g_e_1 + g_e_4;
    const float B_a_2 = g_e_2 + g_e_8;
    const float B_a_3 = g_e_9 - g_e_6;
    const float B_a_4 = pairs_a_1 + pairs_a_3;
    const float B_a_5 = g_e_6 + g_e_9;
    const float B_a_6 = g_e_2 - g_e_8;
    const float B_a_7 = pairs_a_1 - pairs_a_3;
    const float B_a_8 = g_e_4 - g_e_1;
    const float B_a_9 = pairs_a_0 + pairs_a_2;

    /* column_a: a column of B that cannot vanish [1] */
    float column_a_0, column_a_1, column_a_2, column_a_3;
    if (B_a_9 >= 1.0F) {
        column_a_0 = B_a_3;
        column_a_1 = B_a_6;
        column_a_2 = B_a_8;
        column_a_3 = B_a_9;
    } else if ((B_a_0 >= B_a_4) && (B_a_0 >= B_a_7)) {
        column_a_0 = B_a_0;
        column_a_1 = B_a_1;
        column_a_2 = B_a_2;
        column_a_3 = B_a_3;
    } else if (B_a_4 >= B_a_7) {
        column_a_0 = B_a_1;
        column_a_1 = B_a_4;
        column_a_2 = B_a_5;
        column_a_3 = B_a_6;
    } else {
        column_a_0 = B_a_2;
        column_a_1 = B_a_5;
        column_a_2 = B_a_7;
        column_a_3 = B_a_8;
    }

    /* power_a: the column after one power step [1] */
    const float power_a_0 = B_a_0*column_a_0 + B_a_1*column_a_1 + B_a_2*column_a_2 +
        B_a_3*column_a_3;
    const float power_a_1 = B_a_1*column_a_0 + B_a_4*column_a_1 + B_a_5*column_a_2 +
        B_a_6*column_a_3;
    const float power_a_2 = B_a_2*column_a_0 + B_a_5*column_a_1 + B_a_7*column_a_2 +
        B_a_8*column_a_3;
    const float power_a_3 = B_a_3*column_a_0 + B_a_6*column_a_1 + B_a_8*column_a_2 +
        B_a_9*column_a_3;

    /* square_a: square of its vector part [1] */
    const float square_a = power_a_0*power_a_0 + power_a_1*power_a_1 + power_a_2*power_a_2;

    /* norm_square_a: its squared length [1] */
    const float norm_square_a = square_a + power_a_3*power_a_3;

    /* norm_bounded_a: the same: less is no element [1] */
    float norm_bounded_a;
    if (norm_square_a <= 49.0F) {
        norm_bounded_a = 49.0F;
    } else {
        norm_bounded_a = norm_square_a;
    }

    /* norm_a: its length [1] */
    const float norm_a = sqrtf(norm_bounded_a);

    /* inverse_norm_a: to unit length [1] */
    const float inverse_norm_a = 1.0F/norm_a;

    /* scale_a: to unit length, and to w >= 0: the shorter way round [1] */
    float scale_a;
    if (power_a_3 < 0.0F) {
        scale_a = -inverse_norm_a;
    } else {
        scale_a = inverse_norm_a;
    }

    /* cosine_a: cos of half the error angle, rounded [1] */
    const float cosine_a = power_a_3*scale_a;

    /* w_a: cos of half the error angle [1] */
    float w_a;
    if (cosine_a >= 1.0F) {
        w_a = 1.0F;
    } else {
        w_a = cosine_a;
    }

    /* v_a: sin of half the error angle times its axis [1] */
    const float v_a_0 = power_a_0*scale_a;
    const float v_a_1 = power_a_1*scale_a;
    const float v_a_2 = power_a_2*scale_a;

    /* k_a: half angle over its sine [1] */
    const float k_a = two_bodies_f32_k(w_a);

    /* h_a: -dk/dw [1] */
    const float h_a = two_bodies_f32_h(w_a);

    /* phi_a: rotation vector of the error [rad] */
    const float phi_a_0 = 2.0F*k_a*v_a_0;
    const float phi_a_1 = 2.0F*k_a*v_a_1;
    const float phi_a_2 = 2.0F*k_a*v_a_2;

    /* half_a: 1/(2 k) [1] */
    const float half_a = 0.5F/k_a;

    /* swing_p_a: Y p [m] */
    const float swing_p_a_0 = g_e_11*v_a_1 - g_e_7*v_a_2;
    const float swing_p_a_1 = g_e_3*v_a_2 - g_e_11*v_a_0;
    const float swing_p_a_2 = g_e_7*v_a_0 - g_e_3*v_a_1;

    /* sway_p_a: Y Y p [m] */
    const float sway_p_a_0 = swing_p_a_2*v_a_1 - swing_p_a_1*v_a_2;
    const float sway_p_a_1 = swing_p_a_0*v_a_2 - swing_p_a_2*v_a_0;
    const float sway_p_a_2 = swing_p_a_1*v_a_0 - swing_p_a_0*v_a_1;

    /* rho_p_a: p - k Y p + h Y Y p [m] */
    const float rho_p_a_0 = g_e_3 + h_a*sway_p_a_0 - k_a*swing_p_a_0;
    const float rho_p_a_1 = g_e_7 + h_a*sway_p_a_1 - k_a*swing_p_a_1;
    const float rho_p_a_2 = g_e_11 + h_a*sway_p_a_2 - k_a*swing_p_a_2;

    /* y_p_a: rho/(2 k) [m] */
    const float y_p_a_0 = half_a*rho_p_a_0;
    const float y_p_a_1 = half_a*rho_p_a_1;
    const float y_p_a_2 = half_a*rho_p_a_2;

    /* pairs_b: what B's diagonal is made of [1] */
    const float pairs_b_0 = 1.0F + g_e_16;
    const float pairs_b_1 = 1.0F - g_e_16;
    const float pairs_b_2 = g_e_20 + g_e_24;
    const float pairs_b_3 = g_e_20 - g_e_24;

    /* B_b: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack */
    const float B_b_0 = pairs_b_0 - pairs_b_2;
    const float B_b_1 = g_e_17 + g_e_19;
    const float B_b_2 = g_e_18 + g_e_22;
    const float B_b_3 = g_e_23 - g_e_21;
    const float B_b_4 = pairs_b_1 + pairs_b_3;
    const float B_b_5 = g_e_21 + g_e_23;
    const float B_b_6 = g_e_18 - g_e_22;
    const float B_b_7 = pairs_b_1 - pairs_b_3;
    const float B_b_8 = g_e_19 - g_e_17;
    const float B_b_9 = pairs_b_0 + pairs_b_2;

    /* column_b: a column of B that cannot vanish [1] */
    float column_b_0, column_b_1, column_b_2, column_b_3;
    if (B_b_9 >= 1.0F) {
        column_b_0 = B_b_3;
        column_b_1 = B_b_6;
        column_b_2 = B_b_8;
        column_b_3 = B_b_9;
    } else if ((B_b_0 >= B_b_4) && (B_b_0 >= B_b_7)) {
        column_b_0 = B_b_0;
        column_b_1 = B_b_1;
        column_b_2 = B_b_2;
        column_b_3 = B_b_3;
    } else if (B_b_4 >= B_b_7) {
        column_b_0 = B_b_1;
        column_b_1 = B_b_4;
        column_b_2 = B_b_5;
        column_b_3 = B_b_6;
    } else {
        column_b_0 = B_b_2;
        column_b_1 = B_b_5;
        column_b_2 = B_b_7;
        column_b_3 = B_b_8;
    }

    /* power_b: the column after one power step [1] */
    const float power_b_0 = B_b_0*column_b_0 + B_b_1*column_b_1 + B_b_2*column_b_2 +
        B_b_3*column_b_3;
    const float power_b_1 = B_b_1*column_b_0 + B_b_4*column_b_1 + B_b_5*column_b_2 +
        B_b_6*column_b_3;
    const float power_b_2 = B_b_2*column_b_0 + B_b_5*column_b_1 + B_b_7*column_b_2 +
        B_b_8*column_b_3;
    const float power_b_3 = B_b_3*column_b_0 + B_b_6*column_b_1 + B_b_8*column_b_2 +
        B_b_9*column_b_3;

    /* square_b: square of its vector part [1] */
    const float square_b = power_b_0*power_b_0 + power_b_1*power_b_1 + power_b_2*power_b_2;

    /* norm_square_b: its squared length [1] */
    const float norm_square_b = square_b + power_b_3*power_b_3;

    /* norm_bounded_b: the same: less is no element [1] */
    float norm_bounded_b;
    if (norm_square_b <= 49.0F) {
        norm_bounded_b = 49.0F;
    } else {
        norm_bounded_b = norm_square_b;
    }

    /* norm_b: its length [1] */
    const float norm_b = sqrtf(norm_bounded_b);

    /* inverse_norm_b: to unit length [1] */
    const float inverse_norm_b = 1.0F/norm_b;

    /* scale_b: to unit length, and to w >= 0: the shorter way round [1] */
    float scale_b;
    if (power_b_3 < 0.0F) {
        scale_b = -inverse_norm_b;
    } else {
        scale_b = inverse_norm_b;
    }

    /* w_b: cos of half the error angle [1] */
    const float w_b = power_b_3*scale_b;

    /* k_b: half angle over its sine [1] */
    const float k_b = two_bodies_f32_k(w_b);

    /* h_raw_b: -dk/dw times scale^2, as s^2 h = 1 - w k [1] */
    const float h_raw_b = (1.0F - k_b*w_b)/(square_b + 1.0e-8F);

    /* reach_b: p times the scale of the vector part [1] */
    const float reach_b = k_b*scale_b;

    /* stretch_b: nu_u over the vector part [1] */
    const float stretch_b = 2.0F*reach_b;

    /* clearance_0: the smaller clearance [1] */
    float clearance_0;
    if (w_a <= w_b) {
        clearance_0 = w_a;
    } else {
        clearance_0 = w_b;
    }

    /* nu_u: kinematic law, the logarithm and the rotation vector [rad, m], def. (KctrLaw) */
    const float nu_u_6 = power_b_0*stretch_b;
    const float nu_u_7 = power_b_1*stretch_b;
    const float nu_u_8 = power_b_2*stretch_b;

    /* turn_a: Y nu_e, Y = ad of y [rad/s, m/s] */
    const float turn_a_0 = nu_e_2*v_a_1 - nu_e_1*v_a_2;
    const float turn_a_1 = nu_e_0*v_a_2 - nu_e_2*v_a_0;
    const float turn_a_2 = nu_e_1*v_a_0 - nu_e_0*v_a_1;
    const float turn_a_3 = nu_e_2*y_p_a_1 + nu_e_5*v_a_1 - nu_e_1*y_p_a_2 - nu_e_4*v_a_2;
    const float turn_a_4 = nu_e_0*y_p_a_2 + nu_e_3*v_a_2 - nu_e_2*y_p_a_0 - nu_e_5*v_a_0;
    const float turn_a_5 = nu_e_1*y_p_a_0 + nu_e_4*v_a_0 - nu_e_0*y_p_a_1 - nu_e_3*v_a_1;

    /* bend_a: Y Y nu_e [rad/s, m/s] */
    const float bend_a_0 = turn_a_2*v_a_1 - turn_a_1*v_a_2;
    const float bend_a_1 = turn_a_0*v_a_2 - turn_a_2*v_a_0;
    const float bend_a_2 = turn_a_1*v_a_0 - turn_a_0*v_a_1;
    const float bend_a_3 = turn_a_2*y_p_a_1 + turn_a_5*v_a_1 - turn_a_1*y_p_a_2 - turn_a_4*v_a_2;
    const float bend_a_4 = turn_a_0*y_p_a_2 + turn_a_3*v_a_2 - turn_a_2*y_p_a_0 - turn_a_5*v_a_0;
    const float bend_a_5 = turn_a_1*y_p_a_0 + turn_a_4*v_a_0 - turn_a_0*y_p_a_1 - turn_a_3*v_a_1;

    /* m_a: -dh/dw [1] */
    const float m_a = two_bodies_f32_m(w_a);

    /* along_p_a: -2 v.q [m] */
    const float along_p_a = -2.0F*(v_a_0*y_p_a_0 + v_a_1*y_p_a_1 + v_a_2*y_p_a_2);

    /* tail_a: (Y^2 + s^2) Y^2 nu_e [rad/s, m/s] */
    const float tail_a_3 = along_p_a*bend_a_0;
    const float tail_a_4 = along_p_a*bend_a_1;
    const float tail_a_5 = along_p_a*bend_a_2;

    /* twofold_a: h^2 - k m/2, of the double root [1] */
    const float twofold_a = h_a*h_a - 0.5F*k_a*m_a;

    /* turn_b: vector part x nu_e [rad/s] */
    const float turn_b_0 = nu_e_8*power_b_1 - nu_e_7*power_b_2;
    const float turn_b_1 = nu_e_6*power_b_2 - nu_e_8*power_b_0;
    const float turn_b_2 = nu_e_7*power_b_0 - nu_e_6*power_b_1;

    /* bend_b: vector part x turn [rad/s] */
    const float bend_b_0 = power_b_1*turn_b_2 - power_b_2*turn_b_1;
    const float bend_b_1 = power_b_2*turn_b_0 - power_b_0*turn_b_2;
    const float bend_b_2 = power_b_0*turn_b_1 - power_b_1*turn_b_0;

    /* nu_u_dot: exact rate of nu_u [rad/s, m/s] */
    const float nu_u_dot_0 = nu_e_0 + bend_a_0*h_a + k_a*turn_a_0;
    const float nu_u_dot_1 = nu_e_1 + bend_a_1*h_a + k_a*turn_a_1;
    const float nu_u_dot_2 = nu_e_2 + bend_a_2*h_a + k_a*turn_a_2;
    const float nu_u_dot_3 = nu_e_3 + bend_a_3*h_a + k_a*turn_a_3 + tail_a_3*twofold_a;
    const float nu_u_dot_4 = nu_e_4 + bend_a_4*h_a + k_a*turn_a_4 + tail_a_4*twofold_a;
    const float nu_u_dot_5 = nu_e_5 + bend_a_5*h_a + k_a*turn_a_5 + tail_a_5*twofold_a;
    const float nu_u_dot_6 = nu_e_6 + bend_b_0*h_raw_b + reach_b*turn_b_0;
    const float nu_u_dot_7 = nu_e_7 + bend_b_1*h_raw_b + reach_b*turn_b_1;
    const float nu_u_dot_8 = nu_e_8 + bend_b_2*h_raw_b + reach_b*turn_b_2;

    /* drive: lambda nu_u [rad/s, m/s] */
    const float drive_0 = phi_a_0*rate_gain;
    const float drive_1 = phi_a_1*rate_gain;
    const float drive_2 = phi_a_2*rate_gain;
    const float drive_3 = rate_gain*rho_p_a_0;
    const float drive_4 = rate_gain*rho_p_a_1;
    const float drive_5 = rate_gain*rho_p_a_2;
    const float drive_6 = nu_u_6*rate_gain;
    const float drive_7 = nu_u_7*rate_gain;
    const float drive_8 = nu_u_8*rate_gain;

    /* s: sliding variable [rad/s, m/s], eq. (SurfaceErr) */
    const float s_0 = drive_0 + nu_e_0;
    const float s_1 = drive_1 + nu_e_1;
    const float s_2 = drive_2 + nu_e_2;
    const float s_3 = drive_3 + nu_e_3;
    const float s_4 = drive_4 + nu_e_4;
    const float s_5 = drive_5 + nu_e_5;
    const float s_6 = drive_6 + nu_e_6;
    const float s_7 = drive_7 + nu_e_7;
    const float s_8 = drive_8 + nu_e_8;

    /* wanted: acceleration asked for [rad/s^2, m/s^2] */
    const float wanted_0 = eta_dot_0 - nu_u_dot_0*rate_gain - reach_gain*s_0;
    const float wanted_1 = eta_dot_1 - nu_u_dot_1*rate_gain - reach_gain*s_1;
    const float wanted_2 = eta_dot_2 - nu_u_dot_2*rate_gain - reach_gain*s_2;
    const float wanted_3 = eta_dot_3 - nu_u_dot_3*rate_gain - reach_gain*s_3;
    const float wanted_4 = eta_dot_4 - nu_u_dot_4*rate_gain - reach_gain*s_4;
    const float wanted_5 = eta_dot_5 - nu_u_dot_5*rate_gain - reach_gain*s_5;
    const float wanted_6 = eta_dot_6 - nu_u_dot_6*rate_gain - reach_gain*s_6;
    const float wanted_7 = eta_dot_7 - nu_u_dot_7*rate_gain - reach_gain*s_7;
    const float wanted_8 = eta_dot_8 - nu_u_dot_8*rate_gain - reach_gain*s_8;

    /* turning: lambda nu_u - eta [rad/s, m/s] */
    const float turning_0 = drive_0 - eta_0;
    const float turning_1 = drive_1 - eta_1;
    const float turning_2 = drive_2 - eta_2;
    const float turning_3 = drive_3 - eta_3;
    const float turning_4 = drive_4 - eta_4;
    const float turning_5 = drive_5 - eta_5;
    const float turning_6 = drive_6 - eta_6;
    const float turning_7 = drive_7 - eta_7;
    const float turning_8 = drive_8 - eta_8;

    /* momentum: I nu [N m s, N s] */
    const float momentum_0 = inertia_0*nu_0 + inertia_2*nu_2 + inertia_4*nu_4;
    const float momentum_1 = inertia_11*nu_3 + inertia_9*nu_1;
    const float momentum_2 = inertia_17*nu_2 + inertia_2*nu_0;
    const float momentum_3 = inertia_11*nu_1 + inertia_24*nu_3;
    const float momentum_4 = inertia_30*nu_4 + inertia_4*nu_0;
    const float momentum_5 = inertia_35*nu_5;
    const float momentum_6 = inertia_39*nu_6;
    const float momentum_7 = inertia_42*nu_7;
    const float momentum_8 = inertia_44*nu_8;

    /* force: control force, I f_u [N m, N], eq. (TckCtrl) */
    const float force_0 = inertia_0*wanted_0 + inertia_2*wanted_2 + inertia_4*wanted_4 +
        momentum_1*turning_2 + momentum_4*turning_5 - momentum_2*turning_1 - momentum_5*turning_4;
    const float force_1 = inertia_11*wanted_3 + inertia_9*wanted_1 + momentum_2*turning_0 +
        momentum_5*turning_3 - momentum_0*turning_2 - momentum_3*turning_5;
    const float force_2 = inertia_17*wanted_2 + inertia_2*wanted_0 + momentum_0*turning_1 +
        momentum_3*turning_4 - momentum_1*turning_0 - momentum_4*turning_3;
    const float force_3 = inertia_11*wanted_1 + inertia_24*wanted_3 + momentum_4*turning_2 -
        momentum_5*turning_1;
    const float force_4 = inertia_30*wanted_4 + inertia_4*wanted_0 + momentum_5*turning_0 -
        momentum_3*turning_2;
    const float force_5 = inertia_35*wanted_5 + momentum_3*turning_1 - momentum_4*turning_0;
    const float force_6 = inertia_39*wanted_6 + momentum_7*turning_8 - momentum_8*turning_7;
    const float force_7 = inertia_42*wanted_7 + momentum_8*turning_6 - momentum_6*turning_8;
    const float force_8 = inertia_44*wanted_8 + momentum_6*turning_7 - momentum_7*turning_6;

    /* -- end -- */
    command->force[0] = force_0;
    command->force[1] = force_1;
    command->force[2] = force_2;
    command->force[3] = force_3;
    command->force[4] = force_4;
    command->force[5] = force_5;
    command->force[6] = force_6;
    command->force[7] = force_7;
    command->force[8] = force_8;
    command->s[0] = s_0;
    command->s[1] = s_1;
    command->s[2] = s_2;
    command->s[3] = s_3;
    command->s[4] = s_4;
    command->s[5] = s_5;
    command->s[6] = s_6;
    command->s[7] = s_7;
    command->s[8] = s_8;
    command->nu_u[0] = phi_a_0;
    command->nu_u[1] = phi_a_1;
    command->nu_u[2] = phi_a_2;
    command->nu_u[3] = rho_p_a_0;
    command->nu_u[4] = rho_p_a_1;
    command->nu_u[5] = rho_p_a_2;
    command->nu_u[6] = nu_u_6;
    command->nu_u[7] = nu_u_7;
    command->nu_u[8] = nu_u_8;
    command->nu_u_dot[0] = nu_u_dot_0;
    command->nu_u_dot[1] = nu_u_dot_1;
    command->nu_u_dot[2] = nu_u_dot_2;
    command->nu_u_dot[3] = nu_u_dot_3;
    command->nu_u_dot[4] = nu_u_dot_4;
    command->nu_u_dot[5] = nu_u_dot_5;
    command->nu_u_dot[6] = nu_u_dot_6;
    command->nu_u_dot[7] = nu_u_dot_7;
    command->nu_u_dot[8] = nu_u_dot_8;
    return clearance_0;
}

/* pivots of the inertia: all positive for a valid one. */
static void two_bodies_f32_definiteness(const two_bodies_f32_params *params, float pivot[9])
{
    /* -- definiteness -- */
    const float inertia_0 = params->inertia[0], inertia_2 = params->inertia[2],
        inertia_4 = params->inertia[4], inertia_9 = params->inertia[9],
        inertia_11 = params->inertia[11], inertia_17 = params->inertia[17],
        inertia_24 = params->inertia[24], inertia_30 = params->inertia[30],
        inertia_35 = params->inertia[35], inertia_39 = params->inertia[39],
        inertia_42 = params->inertia[42], inertia_44 = params->inertia[44];

    /* divisor_0: the pivot, or 1 where it is not positive [kg m^2, kg m, kg] */
    float divisor_0;
    if (inertia_0 > 0.0F) {
        divisor_0 = inertia_0;
    } else {
        divisor_0 = 1.0F;
    }

    /* lower_20: I = L D L^T, entry of L [1] */
    const float lower_20 = inertia_2/divisor_0;

    /* lower_40: I = L D L^T, entry of L [1] */
    const float lower_40 = inertia_4/divisor_0;

    /* divisor_1: the pivot, or 1 where it is not positive [kg m^2, kg m, kg] */
    float divisor_1;
    if (inertia_9 > 0.0F) {
        divisor_1 = inertia_9;
    } else {
        divisor_1 = 1.0F;
    }

    /* lower_31: I = L D L^T, entry of L [1] */
    const float lower_31 = inertia_11/divisor_1;

    /* pivot_2: pivot of I [kg m^2, kg m, kg] */
    const float pivot_2 = inertia_17 - inertia_0*lower_20*lower_20;

    /* divisor_2: the pivot, or 1 where it is not positive [kg m^2, kg m, kg] */
    float divisor_2;
    if (pivot_2 > 0.0F) {
        divisor_2 = pivot_2;
    } else {
        divisor_2 = 1.0F;
    }

    /* lower_42: I = L D L^T, entry of L [1] */
    const float lower_42 = -inertia_0*lower_20*lower_40/divisor_2;

    /* pivot_3: pivot of I [kg m^2, kg m, kg] */
    const float pivot_3 = inertia_24 - inertia_9*lower_31*lower_31;

    /* pivot_4: pivot of I [kg m^2, kg m, kg] */
    const float pivot_4 = inertia_30 - inertia_0*lower_40*lower_40 - pivot_2*lower_42*lower_42;

    /* -- end -- */
    pivot[0] = inertia_0;
    pivot[1] = inertia_9;
    pivot[2] = pivot_2;
    pivot[3] = pivot_3;
    pivot[4] = pivot_4;
    pivot[5] = inertia_35;
    pivot[6] = inertia_39;
    pivot[7] = inertia_42;
    pivot[8] = inertia_44;
}

void two_bodies_f32_tracking(const two_bodies_f32_params *params, const two_bodies_f32_state *state,
        const two_bodies_f32_reference *reference, two_bodies_f32_command *command)
{
    /* -- tracking -- */
    const float g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5], g_6 = state->g[6], g_7 = state->g[7],
        g_8 = state->g[8], g_9 = state->g[9], g_10 = state->g[10], g_11 = state->g[11],
        g_16 = state->g[16], g_17 = state->g[17], g_18 = state->g[18], g_19 = state->g[19],
        g_20 = state->g[20], g_21 = state->g[21], g_22 = state->g[22], g_23 = state->g[23],
        g_24 = state->g[24];
    const float g_r_0 = reference->g[0], g_r_1 = reference->g[1], g_r_2 = reference->g[2],
        g_r_3 = reference->g[3], g_r_4 = reference->g[4], g_r_5 = reference->g[5],
        g_r_6 = reference->g[6], g_r_7 = reference->g[7], g_r_8 = reference->g[8],
        g_r_9 = reference->g[9], g_r_10 = reference->g[10], g_r_11 = reference->g[11],
        g_r_16 = reference->g[16], g_r_17 = reference->g[17], g_r_18 = reference->g[18],
        g_r_19 = reference->g[19], g_r_20 = reference->g[20], g_r_21 = reference->g[21],
        g_r_22 = reference->g[22], g_r_23 = reference->g[23], g_r_24 = reference->g[24];

    /* gap_0_a: translation of g from g_r [m] */
    const float gap_0_a_0 = g_3 - g_r_3;
    const float gap_0_a_1 = g_7 - g_r_7;
    const float gap_0_a_2 = g_11 - g_r_11;

    /* g_e: error, g_r^-1 g [1], eq. (velErr) */
    const float g_e_0 = g_0*g_r_0 + g_4*g_r_4 + g_8*g_r_8;
    const float g_e_1 = g_1*g_r_0 + g_5*g_r_4 + g_9*g_r_8;
    const float g_e_2 = g_10*g_r_8 + g_2*g_r_0 + g_6*g_r_4;
    const float g_e_3 = g_r_0*gap_0_a_0 + g_r_4*gap_0_a_1 + g_r_8*gap_0_a_2;
    const float g_e_4 = g_0*g_r_1 + g_4*g_r_5 + g_8*g_r_9;
    const float g_e_5 = g_1*g_r_1 + g_5*g_r_5 + g_9*g_r_9;
    const float g_e_6 = g_10*g_r_9 + g_2*g_r_1 + g_6*g_r_5;
    const float g_e_7 = g_r_1*gap_0_a_0 + g_r_5*gap_0_a_1 + g_r_9*gap_0_a_2;
    const float g_e_8 = g_0*g_r_2 + g_4*g_r_6 + g_8*g_r_10;
    const float g_e_9 = g_1*g_r_2 + g_5*g_r_6 + g_9*g_r_10;
    const float g_e_10 = g_10*g_r_10 + g_2*g_r_2 + g_6*g_r_6;
    const float g_e_11 = g_r_10*gap_0_a_2 + g_r_2*gap_0_a_0 + g_r_6*gap_0_a_1;
    const float g_e_16 = g_16*g_r_16 + g_19*g_r_19 + g_22*g_r_22;
    const float g_e_17 = g_17*g_r_16 + g_20*g_r_19 + g_23*g_r_22;
    const float g_e_18 = g_18*g_r_16 + g_21*g_r_19 + g_24*g_r_22;
    const float g_e_19 = g_16*g_r_17 + g_19*g_r_20 + g_22*g_r_23;
    const float g_e_20 = g_17*g_r_17 + g_20*g_r_20 + g_23*g_r_23;
    const float g_e_21 = g_18*g_r_17 + g_21*g_r_20 + g_24*g_r_23;
    const float g_e_22 = g_16*g_r_18 + g_19*g_r_21 + g_22*g_r_24;
    const float g_e_23 = g_17*g_r_18 + g_20*g_r_21 + g_23*g_r_24;
    const float g_e_24 = g_18*g_r_18 + g_21*g_r_21 + g_24*g_r_24;

    /* -- end -- */
    (void)two_bodies_f32_law(params, state, reference, command, g_e_0, g_e_1, g_e_2, g_e_3, g_e_4,
            g_e_5, g_e_6, g_e_7, g_e_8, g_e_9, g_e_10, g_e_11, g_e_16, g_e_17, g_e_18, g_e_19,
            g_e_20, g_e_21, g_e_22, g_e_23, g_e_24);
}

void two_bodies_f32_reaching(const two_bodies_f32_params *params, const two_bodies_f32_state *state,
        two_bodies_f32_command *command)
{
    /* -- reaching -- */
    const float inertia_0 = params->inertia[0], inertia_2 = params->inertia[2],
        inertia_4 = params->inertia[4], inertia_9 = params->inertia[9],
        inertia_11 = params->inertia[11], inertia_17 = params->inertia[17],
        inertia_24 = params->inertia[24], inertia_30 = params->inertia[30],
        inertia_35 = params->inertia[35], inertia_39 = params->inertia[39],
        inertia_42 = params->inertia[42], inertia_44 = params->inertia[44];
    const float rate_gain = params->lambda;
    const float reach_gain = params->k_s;
    const float g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5], g_6 = state->g[6], g_7 = state->g[7],
        g_8 = state->g[8], g_9 = state->g[9], g_10 = state->g[10], g_11 = state->g[11],
        g_16 = state->g[16], g_17 = state->g[17], g_18 = state->g[18], g_19 = state->g[19],
        g_20 = state->g[20], g_21 = state->g[21], g_22 = state->g[22], g_23 = state->g[23],
        g_24 = state->g[24];
    const float nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2], nu_3 = state->nu[3],
        nu_4 = state->nu[4], nu_5 = state->nu[5], nu_6 = state->nu[6], nu_7 = state->nu[7],
        nu_8 = state->nu[8];

    /* pairs_a: what B's diagonal is made of [1] */
    const float pairs_a_0 = 1.0F + g_0;
    const float pairs_a_1 = 1.0F - g_0;
    const float pairs_a_2 = g_10 + g_5;
    const float pairs_a_3 = g_5 - g_10;

    /* B_a: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack */
    const float B_a_0 = pairs_a_0 - pairs_a_2;
    const float B_a_1 = g_1 + g_4;
    const float B_a_2 = g_2 + g_8;
    const float B_a_3 = g_9 - g_6;
    const float B_a_4 = pairs_a_1 + pairs_a_3;
    const float B_a_5 = g_6 + g_9;
    const float B_a_6 = g_2 - g_8;
    const float B_a_7 = pairs_a_1 - pairs_a_3;
    const float B_a_8 = g_4 - g_1;
    const float B_a_9 = pairs_a_0 + pairs_a_2;

    /* column_a: a column of B that cannot vanish [1] */
    float column_a_0, column_a_1, column_a_2, column_a_3;
    if (B_a_9 >= 1.0F) {
        column_a_0 = B_a_3;
        column_a_1 = B_a_6;
        column_a_2 = B_a_8;
        column_a_3 = B_a_9;
    } else if ((B_a_0 >= B_a_4) && (B_a_0 >= B_a_7)) {
        column_a_0 = B_a_0;
        column_a_1 = B_a_1;
        column_a_2 = B_a_2;
        column_a_3 = B_a_3;
    } else if (B_a_4 >= B_a_7) {
        column_a_0 = B_a_1;
        column_a_1 = B_a_4;
        column_a_2 = B_a_5;
        column_a_3 = B_a_6;
    } else {
        column_a_0 = B_a_2;
        column_a_1 = B_a_5;
        column_a_2 = B_a_7;
        column_a_3 = B_a_8;
    }

    /* power_a: the column after one power step [1] */
    const float power_a_0 = B_a_0*column_a_0 + B_a_1*column_a_1 + B_a_2*column_a_2 +
        B_a_3*column_a_3;
    const float power_a_1 = B_a_1*column_a_0 + B_a_4*column_a_1 + B_a_5*column_a_2 +
        B_a_6*column_a_3;
    const float power_a_2 = B_a_2*column_a_0 + B_a_5*column_a_1 + B_a_7*column_a_2 +
        B_a_8*column_a_3;
    const float power_a_3 = B_a_3*column_a_0 + B_a_6*column_a_1 + B_a_8*column_a_2 +
        B_a_9*column_a_3;

    /* square_a: square of its vector part [1] */
    const float square_a = power_a_0*power_a_0 + power_a_1*power_a_1 + power_a_2*power_a_2;

    /* norm_square_a: its squared length [1] */
    const float norm_square_a = square_a + power_a_3*power_a_3;

    /* norm_bounded_a: the same: less is no element [1] */
    float norm_bounded_a;
    if (norm_square_a <= 49.0F) {
        norm_bounded_a = 49.0F;
    } else {
        norm_bounded_a = norm_square_a;
    }

    /* norm_a: its length [1] */
    const float norm_a = sqrtf(norm_bounded_a);

    /* inverse_norm_a: to unit length [1] */
    const float inverse_norm_a = 1.0F/norm_a;

    /* scale_a: to unit length, and to w >= 0: the shorter way round [1] */
    float scale_a;
    if (power_a_3 < 0.0F) {
        scale_a = -inverse_norm_a;
    } else {
        scale_a = inverse_norm_a;
    }

    /* cosine_a: cos of half the error angle, rounded [1] */
    const float cosine_a = power_a_3*scale_a;

    /* w_a: cos of half the error angle [1] */
    float w_a;
    if (cosine_a >= 1.0F) {
        w_a = 1.0F;
    } else {
        w_a = cosine_a;
    }

    /* v_a: sin of half the error angle times its axis [1] */
    const float v_a_0 = power_a_0*scale_a;
    const float v_a_1 = power_a_1*scale_a;
    const float v_a_2 = power_a_2*scale_a;

    /* k_a: half angle over its sine [1] */
    const float k_a = two_bodies_f32_k(w_a);

    /* h_a: -dk/dw [1] */
    const float h_a = two_bodies_f32_h(w_a);

    /* phi_a: rotation vector of the error [rad] */
    const float phi_a_0 = 2.0F*k_a*v_a_0;
    const float phi_a_1 = 2.0F*k_a*v_a_1;
    const float phi_a_2 = 2.0F*k_a*v_a_2;

    /* half_a: 1/(2 k) [1] */
    const float half_a = 0.5F/k_a;

    /* swing_p_a: Y p [m] */
    const float swing_p_a_0 = g_11*v_a_1 - g_7*v_a_2;
    const float swing_p_a_1 = g_3*v_a_2 - g_11*v_a_0;
    const float swing_p_a_2 = g_7*v_a_0 - g_3*v_a_1;

    /* sway_p_a: Y Y p [m] */
    const float sway_p_a_0 = swing_p_a_2*v_a_1 - swing_p_a_1*v_a_2;
    const float sway_p_a_1 = swing_p_a_0*v_a_2 - swing_p_a_2*v_a_0;
    const float sway_p_a_2 = swing_p_a_1*v_a_0 - swing_p_a_0*v_a_1;

    /* rho_p_a: p - k Y p + h Y Y p [m] */
    const float rho_p_a_0 = g_3 + h_a*sway_p_a_0 - k_a*swing_p_a_0;
    const float rho_p_a_1 = g_7 + h_a*sway_p_a_1 - k_a*swing_p_a_1;
    const float rho_p_a_2 = g_11 + h_a*sway_p_a_2 - k_a*swing_p_a_2;

    /* y_p_a: rho/(2 k) [m] */
    const float y_p_a_0 = half_a*rho_p_a_0;
    const float y_p_a_1 = half_a*rho_p_a_1;
    const float y_p_a_2 = half_a*rho_p_a_2;

    /* pairs_b: what B's diagonal is made of [1] */
    const float pairs_b_0 = 1.0F + g_16;
    const float pairs_b_1 = 1.0F - g_16;
    const float pairs_b_2 = g_20 + g_24;
    const float pairs_b_3 = g_20 - g_24;

    /* B_b: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack */
    const float B_b_0 = pairs_b_0 - pairs_b_2;
    const float B_b_1 = g_17 + g_19;
    const float B_b_2 = g_18 + g_22;
    const float B_b_3 = g_23 - g_21;
    const float B_b_4 = pairs_b_1 + pairs_b_3;
    const float B_b_5 = g_21 + g_23;
    const float B_b_6 = g_18 - g_22;
    const float B_b_7 = pairs_b_1 - pairs_b_3;
    const float B_b_8 = g_19 - g_17;
    const float B_b_9 = pairs_b_0 + pairs_b_2;

    /* column_b: a column of B that cannot vanish [1] */
    float column_b_0, column_b_1, column_b_2, column_b_3;
    if (B_b_9 >= 1.0F) {
        column_b_0 = B_b_3;
        column_b_1 = B_b_6;
        column_b_2 = B_b_8;
        column_b_3 = B_b_9;
    } else if ((B_b_0 >= B_b_4) && (B_b_0 >= B_b_7)) {
        column_b_0 = B_b_0;
        column_b_1 = B_b_1;
        column_b_2 = B_b_2;
        column_b_3 = B_b_3;
    } else if (B_b_4 >= B_b_7) {
        column_b_0 = B_b_1;
        column_b_1 = B_b_4;
        column_b_2 = B_b_5;
        column_b_3 = B_b_6;
    } else {
        column_b_0 = B_b_2;
        column_b_1 = B_b_5;
        column_b_2 = B_b_7;
        column_b_3 = B_b_8;
    }

    /* power_b: the column after one power step [1] */
    const float power_b_0 = B_b_0*column_b_0 + B_b_1*column_b_1 + B_b_2*column_b_2 +
        B_b_3*column_b_3;
    const float power_b_1 = B_b_1*column_b_0 + B_b_4*column_b_1 + B_b_5*column_b_2 +
        B_b_6*column_b_3;
    const float power_b_2 = B_b_2*column_b_0 + B_b_5*column_b_1 + B_b_7*column_b_2 +
        B_b_8*column_b_3;
    const float power_b_3 = B_b_3*column_b_0 + B_b_6*column_b_1 + B_b_8*column_b_2 +
        B_b_9*column_b_3;

    /* square_b: square of its vector part [1] */
    const float square_b = power_b_0*power_b_0 + power_b_1*power_b_1 + power_b_2*power_b_2;

    /* norm_square_b: its squared length [1] */
    const float norm_square_b = square_b + power_b_3*power_b_3;

    /* norm_bounded_b: the same: less is no element [1] */
    float norm_bounded_b;
    if (norm_square_b <= 49.0F) {
        norm_bounded_b = 49.0F;
    } else {
        norm_bounded_b = norm_square_b;
    }

    /* norm_b: its length [1] */
    const float norm_b = sqrtf(norm_bounded_b);

    /* inverse_norm_b: to unit length [1] */
    const float inverse_norm_b = 1.0F/norm_b;

    /* scale_b: to unit length, and to w >= 0: the shorter way round [1] */
    float scale_b;
    if (power_b_3 < 0.0F) {
        scale_b = -inverse_norm_b;
    } else {
        scale_b = inverse_norm_b;
    }

    /* w_b: cos of half the error angle [1] */
    const float w_b = power_b_3*scale_b;

    /* k_b: half angle over its sine [1] */
    const float k_b = two_bodies_f32_k(w_b);

    /* h_raw_b: -dk/dw times scale^2, as s^2 h = 1 - w k [1] */
    const float h_raw_b = (1.0F - k_b*w_b)/(square_b + 1.0e-8F);

    /* reach_b: p times the scale of the vector part [1] */
    const float reach_b = k_b*scale_b;

    /* stretch_b: nu_u over the vector part [1] */
    const float stretch_b = 2.0F*reach_b;

    /* nu_u: kinematic law, the logarithm and the rotation vector [rad, m], def. (KctrLaw) */
    const float nu_u_6 = power_b_0*stretch_b;
    const float nu_u_7 = power_b_1*stretch_b;
    const float nu_u_8 = power_b_2*stretch_b;

    /* turn_a: Y nu_e, Y = ad of y [rad/s, m/s] */
    const float turn_a_0 = nu_2*v_a_1 - nu_1*v_a_2;
    const float turn_a_1 = nu_0*v_a_2 - nu_2*v_a_0;
    const float turn_a_2 = nu_1*v_a_0 - nu_0*v_a_1;
    const float turn_a_3 = nu_2*y_p_a_1 + nu_5*v_a_1 - nu_1*y_p_a_2 - nu_4*v_a_2;
    const float turn_a_4 = nu_0*y_p_a_2 + nu_3*v_a_2 - nu_2*y_p_a_0 - nu_5*v_a_0;
    const float turn_a_5 = nu_1*y_p_a_0 + nu_4*v_a_0 - nu_0*y_p_a_1 - nu_3*v_a_1;

    /* bend_a: Y Y nu_e [rad/s, m/s] */
    const float bend_a_0 = turn_a_2*v_a_1 - turn_a_1*v_a_2;
    const float bend_a_1 = turn_a_0*v_a_2 - turn_a_2*v_a_0;
    const float bend_a_2 = turn_a_1*v_a_0 - turn_a_0*v_a_1;
    const float bend_a_3 = turn_a_2*y_p_a_1 + turn_a_5*v_a_1 - turn_a_1*y_p_a_2 - turn_a_4*v_a_2;
    const float bend_a_4 = turn_a_0*y_p_a_2 + turn_a_3*v_a_2 - turn_a_2*y_p_a_0 - turn_a_5*v_a_0;
    const float bend_a_5 = turn_a_1*y_p_a_0 + turn_a_4*v_a_0 - turn_a_0*y_p_a_1 - turn_a_3*v_a_1;

    /* m_a: -dh/dw [1] */
    const float m_a = two_bodies_f32_m(w_a);

    /* along_p_a: -2 v.q [m] */
    const float along_p_a = -2.0F*(v_a_0*y_p_a_0 + v_a_1*y_p_a_1 + v_a_2*y_p_a_2);

    /* tail_a: (Y^2 + s^2) Y^2 nu_e [rad/s, m/s] */
    const float tail_a_3 = along_p_a*bend_a_0;
    const float tail_a_4 = along_p_a*bend_a_1;
    const float tail_a_5 = along_p_a*bend_a_2;

    /* twofold_a: h^2 - k m/2, of the double root [1] */
    const float twofold_a = h_a*h_a - 0.5F*k_a*m_a;

    /* turn_b: vector part x nu_e [rad/s] */
    const float turn_b_0 = nu_8*power_b_1 - nu_7*power_b_2;
    const float turn_b_1 = nu_6*power_b_2 - nu_8*power_b_0;
    const float turn_b_2 = nu_7*power_b_0 - nu_6*power_b_1;

    /* bend_b: vector part x turn [rad/s] */
    const float bend_b_0 = power_b_1*turn_b_2 - power_b_2*turn_b_1;
    const float bend_b_1 = power_b_2*turn_b_0 - power_b_0*turn_b_2;
    const float bend_b_2 = power_b_0*turn_b_1 - power_b_1*turn_b_0;

    /* nu_u_dot: exact rate of nu_u [rad/s, m/s] */
    const float nu_u_dot_0 = nu_0 + bend_a_0*h_a + k_a*turn_a_0;
    const float nu_u_dot_1 = nu_1 + bend_a_1*h_a + k_a*turn_a_1;
    const float nu_u_dot_2 = nu_2 + bend_a_2*h_a + k_a*turn_a_2;
    const float nu_u_dot_3 = nu_3 + bend_a_3*h_a + k_a*turn_a_3 + tail_a_3*twofold_a;
    const float nu_u_dot_4 = nu_4 + bend_a_4*h_a + k_a*turn_a_4 + tail_a_4*twofold_a;
    const float nu_u_dot_5 = nu_5 + bend_a_5*h_a + k_a*turn_a_5 + tail_a_5*twofold_a;
    const float nu_u_dot_6 = nu_6 + bend_b_0*h_raw_b + reach_b*turn_b_0;
    const float nu_u_dot_7 = nu_7 + bend_b_1*h_raw_b + reach_b*turn_b_1;
    const float nu_u_dot_8 = nu_8 + bend_b_2*h_raw_b + reach_b*turn_b_2;

    /* drive: lambda nu_u [rad/s, m/s] */
    const float drive_0 = phi_a_0*rate_gain;
    const float drive_1 = phi_a_1*rate_gain;
    const float drive_2 = phi_a_2*rate_gain;
    const float drive_3 = rate_gain*rho_p_a_0;
    const float drive_4 = rate_gain*rho_p_a_1;
    const float drive_5 = rate_gain*rho_p_a_2;
    const float drive_6 = nu_u_6*rate_gain;
    const float drive_7 = nu_u_7*rate_gain;
    const float drive_8 = nu_u_8*rate_gain;

    /* s: sliding variable [rad/s, m/s], eq. (sldS) */
    const float s_0 = drive_0 + nu_0;
    const float s_1 = drive_1 + nu_1;
    const float s_2 = drive_2 + nu_2;
    const float s_3 = drive_3 + nu_3;
    const float s_4 = drive_4 + nu_4;
    const float s_5 = drive_5 + nu_5;
    const float s_6 = drive_6 + nu_6;
    const float s_7 = drive_7 + nu_7;
    const float s_8 = drive_8 + nu_8;

    /* wanted: acceleration asked for [rad/s^2, m/s^2] */
    const float wanted_0 = -(nu_u_dot_0*rate_gain + reach_gain*s_0);
    const float wanted_1 = -(nu_u_dot_1*rate_gain + reach_gain*s_1);
    const float wanted_2 = -(nu_u_dot_2*rate_gain + reach_gain*s_2);
    const float wanted_3 = -(nu_u_dot_3*rate_gain + reach_gain*s_3);
    const float wanted_4 = -(nu_u_dot_4*rate_gain + reach_gain*s_4);
    const float wanted_5 = -(nu_u_dot_5*rate_gain + reach_gain*s_5);
    const float wanted_6 = -(nu_u_dot_6*rate_gain + reach_gain*s_6);
    const float wanted_7 = -(nu_u_dot_7*rate_gain + reach_gain*s_7);
    const float wanted_8 = -(nu_u_dot_8*rate_gain + reach_gain*s_8);

    /* momentum: I nu [N m s, N s] */
    const float momentum_0 = inertia_0*nu_0 + inertia_2*nu_2 + inertia_4*nu_4;
    const float momentum_1 = inertia_11*nu_3 + inertia_9*nu_1;
    const float momentum_2 = inertia_17*nu_2 + inertia_2*nu_0;
    const float momentum_3 = inertia_11*nu_1 + inertia_24*nu_3;
    const float momentum_4 = inertia_30*nu_4 + inertia_4*nu_0;
    const float momentum_5 = inertia_35*nu_5;
    const float momentum_6 = inertia_39*nu_6;
    const float momentum_7 = inertia_42*nu_7;
    const float momentum_8 = inertia_44*nu_8;

    /* force: control force, I f_u [N m, N], eq. (Ctrl2) */
    const float force_0 = drive_2*momentum_1 + drive_5*momentum_4 + inertia_0*wanted_0 +
        inertia_2*wanted_2 + inertia_4*wanted_4 - drive_1*momentum_2 - drive_4*momentum_5;
    const float force_1 = drive_0*momentum_2 + drive_3*momentum_5 + inertia_11*wanted_3 +
        inertia_9*wanted_1 - drive_2*momentum_0 - drive_5*momentum_3;
    const float force_2 = drive_1*momentum_0 + drive_4*momentum_3 + inertia_17*wanted_2 +
        inertia_2*wanted_0 - drive_0*momentum_1 - drive_3*momentum_4;
    const float force_3 = drive_2*momentum_4 + inertia_11*wanted_1 + inertia_24*wanted_3 -
        drive_1*momentum_5;
    const float force_4 = drive_0*momentum_5 + inertia_30*wanted_4 + inertia_4*wanted_0 -
        drive_2*momentum_3;
    const float force_5 = drive_1*momentum_3 + inertia_35*wanted_5 - drive_0*momentum_4;
    const float force_6 = drive_8*momentum_7 + inertia_39*wanted_6 - drive_7*momentum_8;
    const float force_7 = drive_6*momentum_8 + inertia_42*wanted_7 - drive_8*momentum_6;
    const float force_8 = drive_7*momentum_6 + inertia_44*wanted_8 - drive_6*momentum_7;

    /* -- end -- */
    command->force[0] = force_0;
    command->force[1] = force_1;
    command->force[2] = force_2;
    command->force[3] = force_3;
    command->force[4] = force_4;
    command->force[5] = force_5;
    command->force[6] = force_6;
    command->force[7] = force_7;
    command->force[8] = force_8;
    command->s[0] = s_0;
    command->s[1] = s_1;
    command->s[2] = s_2;
    command->s[3] = s_3;
    command->s[4] = s_4;
    command->s[5] = s_5;
    command->s[6] = s_6;
    command->s[7] = s_7;
    command->s[8] = s_8;
    command->nu_u[0] = phi_a_0;
    command->nu_u[1] = phi_a_1;
    command->nu_u[2] = phi_a_2;
    command->nu_u[3] = rho_p_a_0;
    command->nu_u[4] = rho_p_a_1;
    command->nu_u[5] = rho_p_a_2;
    command->nu_u[6] = nu_u_6;
    command->nu_u[7] = nu_u_7;
    command->nu_u[8] = nu_u_8;
    command->nu_u_dot[0] = nu_u_dot_0;
    command->nu_u_dot[1] = nu_u_dot_1;
    command->nu_u_dot[2] = nu_u_dot_2;
    command->nu_u_dot[3] = nu_u_dot_3;
    command->nu_u_dot[4] = nu_u_dot_4;
    command->nu_u_dot[5] = nu_u_dot_5;
    command->nu_u_dot[6] = nu_u_dot_6;
    command->nu_u_dot[7] = nu_u_dot_7;
    command->nu_u_dot[8] = nu_u_dot_8;
}

void two_bodies_f32_plant(const two_bodies_f32_params *params, const two_bodies_f32_state *state,
        const float force[9], float nu_dot[9])
{
    /* -- plant -- */
    const float inertia_0 = params->inertia[0], inertia_2 = params->inertia[2],
        inertia_4 = params->inertia[4], inertia_9 = params->inertia[9],
        inertia_11 = params->inertia[11], inertia_17 = params->inertia[17],
        inertia_24 = params->inertia[24], inertia_30 = params->inertia[30],
        inertia_35 = params->inertia[35], inertia_39 = params->inertia[39],
        inertia_42 = params->inertia[42], inertia_44 = params->inertia[44];
    const float nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2], nu_3 = state->nu[3],
        nu_4 = state->nu[4], nu_5 = state->nu[5], nu_6 = state->nu[6], nu_7 = state->nu[7],
        nu_8 = state->nu[8];
    const float force_0 = force[0], force_1 = force[1], force_2 = force[2], force_3 = force[3],
        force_4 = force[4], force_5 = force[5], force_6 = force[6], force_7 = force[7],
        force_8 = force[8];

    /* momentum: I nu [N m s, N s] */
    const float momentum_0 = inertia_0*nu_0 + inertia_2*nu_2 + inertia_4*nu_4;
    const float momentum_1 = inertia_11*nu_3 + inertia_9*nu_1;
    const float momentum_2 = inertia_17*nu_2 + inertia_2*nu_0;
    const float momentum_3 = inertia_11*nu_1 + inertia_24*nu_3;
    const float momentum_4 = inertia_30*nu_4 + inertia_4*nu_0;
    const float momentum_5 = inertia_35*nu_5;
    const float momentum_6 = inertia_39*nu_6;
    const float momentum_7 = inertia_42*nu_7;
    const float momentum_8 = inertia_44*nu_8;

    /* total: coad(nu) I nu + force [N m, N] */
    const float total_0 = force_0 + momentum_1*nu_2 + momentum_4*nu_5 - momentum_2*nu_1 -
        momentum_5*nu_4;
    const float total_1 = force_1 + momentum_2*nu_0 + momentum_5*nu_3 - momentum_0*nu_2 -
        momentum_3*nu_5;
    const float total_2 = force_2 + momentum_0*nu_1 + momentum_3*nu_4 - momentum_1*nu_0 -
        momentum_4*nu_3;
    const float total_3 = force_3 + momentum_4*nu_2 - momentum_5*nu_1;
    const float total_4 = force_4 + momentum_5*nu_0 - momentum_3*nu_2;
    const float total_5 = force_5 + momentum_3*nu_1 - momentum_4*nu_0;
    const float total_6 = force_6 + momentum_7*nu_8 - momentum_8*nu_7;
    const float total_7 = force_7 + momentum_8*nu_6 - momentum_6*nu_8;
    const float total_8 = force_8 + momentum_6*nu_7 - momentum_7*nu_6;

    /* lower_20: I = L D L^T, entry of L [1] */
    const float lower_20 = inertia_2/inertia_0;

    /* lower_40: I = L D L^T, entry of L [1] */
    const float lower_40 = inertia_4/inertia_0;

    /* lower_31: I = L D L^T, entry of L [1] */
    const float lower_31 = inertia_11/inertia_9;

    /* pivot_2: pivot of I [kg m^2, kg m, kg] */
    const float pivot_2 = inertia_17 - inertia_0*lower_20*lower_20;

    /* lower_42: I = L D L^T, entry of L [1] */
    const float lower_42 = -inertia_0*lower_20*lower_40/pivot_2;

    /* pivot_3: pivot of I [kg m^2, kg m, kg] */
    const float pivot_3 = inertia_24 - inertia_9*lower_31*lower_31;

    /* pivot_4: pivot of I [kg m^2, kg m, kg] */
    const float pivot_4 = inertia_30 - inertia_0*lower_40*lower_40 - pivot_2*lower_42*lower_42;

    /* forward_2: forward substitution [N m, N] */
    const float forward_2 = total_2 - lower_20*total_0;

    /* forward_3: forward substitution [N m, N] */
    const float forward_3 = total_3 - lower_31*total_1;

    /* forward_4: forward substitution [N m, N] */
    const float forward_4 = total_4 - forward_2*lower_42 - lower_40*total_0;

    /* back_8: back substitution [rad/s^2, m/s^2] */
    const float back_8 = total_8/inertia_44;

    /* back_7: back substitution [rad/s^2, m/s^2] */
    const float back_7 = total_7/inertia_42;

    /* back_6: back substitution [rad/s^2, m/s^2] */
    const float back_6 = total_6/inertia_39;

    /* back_5: back substitution [rad/s^2, m/s^2] */
    const float back_5 = total_5/inertia_35;

    /* back_4: back substitution [rad/s^2, m/s^2] */
    const float back_4 = forward_4/pivot_4;

    /* back_3: back substitution [rad/s^2, m/s^2] */
    const float back_3 = forward_3/pivot_3;

    /* back_2: back substitution [rad/s^2, m/s^2] */
    const float back_2 = forward_2/pivot_2 - back_4*lower_42;

    /* back_1: back substitution [rad/s^2, m/s^2] */
    const float back_1 = total_1/inertia_9 - back_3*lower_31;

    /* back_0: back substitution [rad/s^2, m/s^2] */
    const float back_0 = total_0/inertia_0 - back_2*lower_20 - back_4*lower_40;

    /* -- end -- */
    nu_dot[0] = back_0;
    nu_dot[1] = back_1;
    nu_dot[2] = back_2;
    nu_dot[3] = back_3;
    nu_dot[4] = back_4;
    nu_dot[5] = back_5;
    nu_dot[6] = back_6;
    nu_dot[7] = back_7;
    nu_dot[8] = back_8;
}

/* The worse of two findings. */
static two_bodies_f32_status two_bodies_f32_worse(const two_bodies_f32_status a,
        const two_bodies_f32_status b)
{
    return a > b ? a : b;
}

/* OUT_OF_RANGE or NONFINITE_INPUT if any number is larger than a limit or not finite. */
static two_bodies_f32_status two_bodies_f32_inspect(const float *numbers, const int count,
        const float limit)
{
    two_bodies_f32_status worst = TWO_BODIES_F32_OK;
    int i;
    for (i = 0; i < count; i++) {
        if (!isfinite(numbers[i])) {
            worst = TWO_BODIES_F32_NONFINITE_INPUT;
        } else if (fabsf(numbers[i]) > limit) {
            worst = two_bodies_f32_worse(worst, TWO_BODIES_F32_OUT_OF_RANGE);
        } else {
            /* finite and in range: it leaves the finding as it is */
        }
    }
    return worst;
}

/* Zero command; its status says what is wrong with what was refused, at least what was found. */
static two_bodies_f32_status two_bodies_f32_refuse(const two_bodies_f32_state *state,
        const two_bodies_f32_reference *reference, const two_bodies_f32_status found,
        two_bodies_f32_command *command)
{
    two_bodies_f32_status worst = found;
    worst = two_bodies_f32_worse(worst,
            two_bodies_f32_inspect(state->g, 25, TWO_BODIES_F32_MAX_INPUT));
    worst = two_bodies_f32_worse(worst,
            two_bodies_f32_inspect(state->nu, 9, TWO_BODIES_F32_MAX_INPUT));
    worst = two_bodies_f32_worse(worst,
            two_bodies_f32_inspect(reference->g, 25, TWO_BODIES_F32_MAX_INPUT));
    worst = two_bodies_f32_worse(worst,
            two_bodies_f32_inspect(reference->nu, 9, TWO_BODIES_F32_MAX_INPUT));
    worst = two_bodies_f32_worse(worst,
            two_bodies_f32_inspect(reference->nu_dot, 9, TWO_BODIES_F32_MAX_INPUT));
    two_bodies_f32_nothing(command);
    return worst;
}

/* What a computed command is worth, given its distance from the cut locus of the law. */
static two_bodies_f32_status two_bodies_f32_verdict(const float clearance,
        two_bodies_f32_command *command)
{
    if (!(isfinite(command->force[0]) && isfinite(command->force[1]) && isfinite(command->force[2])
            && isfinite(command->force[3]) && isfinite(command->force[4])
            && isfinite(command->force[5]) && isfinite(command->force[6])
            && isfinite(command->force[7]) && isfinite(command->force[8]))) {
        two_bodies_f32_nothing(command);
        return TWO_BODIES_F32_NONFINITE_INPUT;
    }
    return clearance < TWO_BODIES_F32_NEAR_CUT ? TWO_BODIES_F32_NEAR_CUT_LOCUS : TWO_BODIES_F32_OK;
}

two_bodies_f32_status two_bodies_f32_control(const two_bodies_f32_params *params,
        const two_bodies_f32_state *state, const two_bodies_f32_reference *reference,
        two_bodies_f32_command *command)
{
    float clearance;
#ifdef TWO_BODIES_CHECK_POINTERS
    if (params == NULL || state == NULL || reference == NULL || command == NULL) {
        if (command != NULL) {
            two_bodies_f32_nothing(command);
        }
        return TWO_BODIES_F32_BAD_PARAMS;
    }
#endif
    /* -- tracking -- */
    const float g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5], g_6 = state->g[6], g_7 = state->g[7],
        g_8 = state->g[8], g_9 = state->g[9], g_10 = state->g[10], g_11 = state->g[11],
        g_16 = state->g[16], g_17 = state->g[17], g_18 = state->g[18], g_19 = state->g[19],
        g_20 = state->g[20], g_21 = state->g[21], g_22 = state->g[22], g_23 = state->g[23],
        g_24 = state->g[24];
    const float g_r_0 = reference->g[0], g_r_1 = reference->g[1], g_r_2 = reference->g[2],
        g_r_3 = reference->g[3], g_r_4 = reference->g[4], g_r_5 = reference->g[5],
        g_r_6 = reference->g[6], g_r_7 = reference->g[7], g_r_8 = reference->g[8],
        g_r_9 = reference->g[9], g_r_10 = reference->g[10], g_r_11 = reference->g[11],
        g_r_16 = reference->g[16], g_r_17 = reference->g[17], g_r_18 = reference->g[18],
        g_r_19 = reference->g[19], g_r_20 = reference->g[20], g_r_21 = reference->g[21],
        g_r_22 = reference->g[22], g_r_23 = reference->g[23], g_r_24 = reference->g[24];

    /* gap_0_a: translation of g from g_r [m] */
    const float gap_0_a_0 = g_3 - g_r_3;
    const float gap_0_a_1 = g_7 - g_r_7;
    const float gap_0_a_2 = g_11 - g_r_11;

    /* g_e: error, g_r^-1 g [1], eq. (velErr) */
    const float g_e_0 = g_0*g_r_0 + g_4*g_r_4 + g_8*g_r_8;
    const float g_e_1 = g_1*g_r_0 + g_5*g_r_4 + g_9*g_r_8;
    const float g_e_2 = g_10*g_r_8 + g_2*g_r_0 + g_6*g_r_4;
    const float g_e_3 = g_r_0*gap_0_a_0 + g_r_4*gap_0_a_1 + g_r_8*gap_0_a_2;
    const float g_e_4 = g_0*g_r_1 + g_4*g_r_5 + g_8*g_r_9;
    const float g_e_5 = g_1*g_r_1 + g_5*g_r_5 + g_9*g_r_9;
    const float g_e_6 = g_10*g_r_9 + g_2*g_r_1 + g_6*g_r_5;
    const float g_e_7 = g_r_1*gap_0_a_0 + g_r_5*gap_0_a_1 + g_r_9*gap_0_a_2;
    const float g_e_8 = g_0*g_r_2 + g_4*g_r_6 + g_8*g_r_10;
    const float g_e_9 = g_1*g_r_2 + g_5*g_r_6 + g_9*g_r_10;
    const float g_e_10 = g_10*g_r_10 + g_2*g_r_2 + g_6*g_r_6;
    const float g_e_11 = g_r_10*gap_0_a_2 + g_r_2*gap_0_a_0 + g_r_6*gap_0_a_1;
    const float g_e_16 = g_16*g_r_16 + g_19*g_r_19 + g_22*g_r_22;
    const float g_e_17 = g_17*g_r_16 + g_20*g_r_19 + g_23*g_r_22;
    const float g_e_18 = g_18*g_r_16 + g_21*g_r_19 + g_24*g_r_22;
    const float g_e_19 = g_16*g_r_17 + g_19*g_r_20 + g_22*g_r_23;
    const float g_e_20 = g_17*g_r_17 + g_20*g_r_20 + g_23*g_r_23;
    const float g_e_21 = g_18*g_r_17 + g_21*g_r_20 + g_24*g_r_23;
    const float g_e_22 = g_16*g_r_18 + g_19*g_r_21 + g_22*g_r_24;
    const float g_e_23 = g_17*g_r_18 + g_20*g_r_21 + g_23*g_r_24;
    const float g_e_24 = g_18*g_r_18 + g_21*g_r_21 + g_24*g_r_24;

    /* -- end -- */
    if (!(fabsf(g_e_0) <= TWO_BODIES_F32_MAX_ENTRY && fabsf(g_e_1) <= TWO_BODIES_F32_MAX_ENTRY
            && fabsf(g_e_2) <= TWO_BODIES_F32_MAX_ENTRY && fabsf(g_e_3) <= TWO_BODIES_F32_MAX_REACH
            && fabsf(g_e_4) <= TWO_BODIES_F32_MAX_ENTRY && fabsf(g_e_5) <= TWO_BODIES_F32_MAX_ENTRY
            && fabsf(g_e_6) <= TWO_BODIES_F32_MAX_ENTRY && fabsf(g_e_7) <= TWO_BODIES_F32_MAX_REACH
            && fabsf(g_e_8) <= TWO_BODIES_F32_MAX_ENTRY && fabsf(g_e_9) <= TWO_BODIES_F32_MAX_ENTRY
            && fabsf(g_e_10) <= TWO_BODIES_F32_MAX_ENTRY
            && fabsf(g_e_11) <= TWO_BODIES_F32_MAX_REACH
            && fabsf(g_e_16) <= TWO_BODIES_F32_MAX_ENTRY
            && fabsf(g_e_17) <= TWO_BODIES_F32_MAX_ENTRY
            && fabsf(g_e_18) <= TWO_BODIES_F32_MAX_ENTRY
            && fabsf(g_e_19) <= TWO_BODIES_F32_MAX_ENTRY
            && fabsf(g_e_20) <= TWO_BODIES_F32_MAX_ENTRY
            && fabsf(g_e_21) <= TWO_BODIES_F32_MAX_ENTRY
            && fabsf(g_e_22) <= TWO_BODIES_F32_MAX_ENTRY
            && fabsf(g_e_23) <= TWO_BODIES_F32_MAX_ENTRY
            && fabsf(g_e_24) <= TWO_BODIES_F32_MAX_ENTRY
            && fabsf(state->g[3]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(state->g[7]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(state->g[11]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(state->nu[0]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(state->nu[1]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(state->nu[2]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(state->nu[3]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(state->nu[4]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(state->nu[5]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(state->nu[6]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(state->nu[7]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(state->nu[8]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->g[3]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->g[7]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->g[11]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->nu[0]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->nu[1]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->nu[2]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->nu[3]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->nu[4]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->nu[5]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->nu[6]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->nu[7]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->nu[8]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->nu_dot[0]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->nu_dot[1]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->nu_dot[2]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->nu_dot[3]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->nu_dot[4]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->nu_dot[5]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->nu_dot[6]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->nu_dot[7]) <= TWO_BODIES_F32_MAX_INPUT
            && fabsf(reference->nu_dot[8]) <= TWO_BODIES_F32_MAX_INPUT)) {
        if (fabsf(g_e_3) <= TWO_BODIES_F32_MAX_REACH && fabsf(g_e_7) <= TWO_BODIES_F32_MAX_REACH
                && fabsf(g_e_11) <= TWO_BODIES_F32_MAX_REACH) {
            return two_bodies_f32_refuse(state, reference, TWO_BODIES_F32_NOT_ON_GROUP, command);
        }
        return two_bodies_f32_refuse(state, reference, TWO_BODIES_F32_OUT_OF_RANGE, command);
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
    const float off_6 = g_e_16*g_e_16 - 1.0F + g_e_19*g_e_19 + g_e_22*g_e_22;
    const float off_7 = g_e_16*g_e_17 + g_e_19*g_e_20 + g_e_22*g_e_23;
    const float off_8 = g_e_17*g_e_17 - 1.0F + g_e_20*g_e_20 + g_e_23*g_e_23;
    const float off_9 = g_e_18 + g_e_20*g_e_22 - g_e_19*g_e_23;
    const float off_10 = g_e_21 + g_e_16*g_e_23 - g_e_17*g_e_22;
    const float off_11 = g_e_24 + g_e_17*g_e_19 - g_e_16*g_e_20;
    const float off_15 = g_15 - 1.0F;
    const float off_19 = g_r_15 - 1.0F;

    /* drift: square of the distance from the group [1] */
    const float drift = g_12*g_12 + g_13*g_13 + g_14*g_14 + g_r_12*g_r_12 + g_r_13*g_r_13 +
        g_r_14*g_r_14 + off_0*off_0 + off_1*off_1 + off_10*off_10 + off_11*off_11 + off_15*off_15 +
        off_19*off_19 + off_2*off_2 + off_3*off_3 + off_4*off_4 + off_5*off_5 + off_6*off_6 +
        off_7*off_7 + off_8*off_8 + off_9*off_9;

    /* -- end -- */

    if (!(drift < params->max_drift*params->max_drift)) {
        return two_bodies_f32_refuse(state, reference, TWO_BODIES_F32_NOT_ON_GROUP, command);
    }
    clearance = two_bodies_f32_law(params, state, reference, command, g_e_0, g_e_1, g_e_2, g_e_3,
            g_e_4, g_e_5, g_e_6, g_e_7, g_e_8, g_e_9, g_e_10, g_e_11, g_e_16, g_e_17, g_e_18,
            g_e_19, g_e_20, g_e_21, g_e_22, g_e_23, g_e_24);
    return two_bodies_f32_verdict(clearance, command);
}

two_bodies_f32_status two_bodies_f32_check_params(const two_bodies_f32_params *params)
{
#ifdef TWO_BODIES_CHECK_POINTERS
    if (params == NULL) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
#endif
    float pivot[9];
    int i;
    if (two_bodies_f32_inspect(params->inertia, 45, TWO_BODIES_F32_MAX_PARAM) != TWO_BODIES_F32_OK)
            {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (!(params->lambda >= TWO_BODIES_F32_MIN_GAIN && params->lambda <= TWO_BODIES_F32_MAX_RATE)) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (!(params->k_s >= TWO_BODIES_F32_MIN_GAIN && params->k_s <= TWO_BODIES_F32_MAX_RATE)) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (!(params->max_drift >= TWO_BODIES_F32_LEAST_DRIFT && params->max_drift <=
            TWO_BODIES_F32_MOST_DRIFT)) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[1]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[3]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[5]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[6]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[7]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[8]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[10]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[12]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[13]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[14]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[15]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[16]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[18]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[19]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[20]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[21]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[22]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[23]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[25]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[26]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[27]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[28]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[29]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[31]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[32]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[33]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[34]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[36]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[37]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[38]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[40]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[41]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[43]) > 0.0F) {
        return TWO_BODIES_F32_BAD_PARAMS;
    }
    two_bodies_f32_definiteness(params, pivot);
    for (i = 0; i < 9; i++) {
        if (!(pivot[i] > 0.0F)) {
            return TWO_BODIES_F32_BAD_PARAMS;
        }
    }
    return TWO_BODIES_F32_OK;
}
