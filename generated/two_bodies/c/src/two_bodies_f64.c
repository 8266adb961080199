/*
 * two_bodies_f64: gsmc on SE3 x SO3, law log (the logarithm and the rotation vector), double
         precision.
 * Every step below carries its quantity, unit and equation; trace.csv lists them by line.
 */
#include "two_bodies_f64.h"

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

const two_bodies_f64_params two_bodies_f64_defaults = {
    {0.1827, 0.0, 0.004, 0.0, -0.18, 0.0, 0.0, 0.0, 0.0, 0.2127, 0.0, 0.18, 0.0, 0.0, 0.0, 0.0, 0.0,
     0.15, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 12.0, 0.0, 0.0, 0.0, 0.0, 0.0, 12.0, 0.0, 0.0, 0.0, 0.0,
     12.0, 0.0, 0.0, 0.0, 0.0421, 0.0, 0.0, 0.0417, 0.0, 0.0067},
    0.08, /* lambda */
    0.3, /* k_s */
    1.0e-6 /* max_drift */
};

/* Kernel function k(w) on 0 <= w <= 1, a polynomial in 1 - w. */
static inline double two_bodies_f64_k(const double w)
{
    const double z = 1.0 - w;
    double sum = 8.277514146196502e-5;
    sum = sum * z - 0.0007444806306887051;
    sum = sum * z + 0.00317670645149068;
    sum = sum * z - 0.008454515050142185;
    sum = sum * z + 0.01566904108961398;
    sum = sum * z - 0.02138402971876357;
    sum = sum * z + 0.022234983575225374;
    sum = sum * z - 0.01792610921286688;
    sum = sum * z + 0.011402056638616778;
    sum = sum * z - 0.005632546133953197;
    sum = sum * z + 0.002377672542009468;
    sum = sum * z - 0.0004366715134129454;
    sum = sum * z + 0.0007243405609038858;
    sum = sum * z + 0.0011382817325777553;
    sum = sum * z + 0.0024908875171720216;
    sum = sum * z + 0.0053275406688376775;
    sum = sum * z + 0.01154404554160158;
    sum = sum * z + 0.02539682373687369;
    sum = sum * z + 0.05714285719245186;
    sum = sum * z + 0.13333333333254913;
    sum = sum * z + 0.33333333333333826;
    sum = sum * z + 1.0;
    return sum;
}

/* Kernel function h(w) on 0 <= w <= 1, a polynomial in 1 - w. */
static inline double two_bodies_f64_h(const double w)
{
    const double z = 1.0 - w;
    double sum = 0.0005869285541338526;
    sum = sum * z - 0.005858782802349971;
    sum = sum * z + 0.02775217181527643;
    sum = sum * z - 0.08239871557949739;
    sum = sum * z + 0.17141579919249336;
    sum = sum * z - 0.2648054375312226;
    sum = sum * z + 0.31451612336770063;
    sum = sum * z - 0.2933687632591719;
    sum = sum * z + 0.21795684792382322;
    sum = sum * z - 0.12974666772406582;
    sum = sum * z + 0.06249498320555255;
    sum = sum * z - 0.023679806838676747;
    sum = sum * z + 0.008179325052908947;
    sum = sum * z - 0.00044990996254287995;
    sum = sum * z + 0.0029965381931628668;
    sum = sum * z + 0.00493433513118645;
    sum = sum * z + 0.009366742351494562;
    sum = sum * z + 0.01740429621188172;
    sum = sum * z + 0.0319680631824094;
    sum = sum * z + 0.05772005646930993;
    sum = sum * z + 0.10158730161801939;
    sum = sum * z + 0.17142857142817186;
    sum = sum * z + 0.2666666666666687;
    sum = sum * z + 0.3333333333333333;
    return sum;
}

/* Kernel function m(w) on 0 <= w <= 1, a polynomial in 1 - w. */
static inline double two_bodies_f64_m(const double w)
{
    const double z = 1.0 - w;
    double sum = 0.005086617270586654;
    sum = sum * z - 0.055706599747338964;
    sum = sum * z + 0.28993069131182037;
    sum = sum * z - 0.9497531819644951;
    sum = sum * z + 2.191472343354955;
    sum = sum * z - 3.7799407192384487;
    sum = sum * z + 5.051152839252075;
    sum = sum * z - 5.349819738530713;
    sum = sum * z + 4.558603016452899;
    sum = sum * z - 3.154192583107265;
    sum = sum * z + 1.7828890332945444;
    sum = sum * z - 0.8234877082783333;
    sum = sum * z + 0.31320023890797616;
    sum = sum * z - 0.09357070006098941;
    sum = sum * z + 0.028572814006091584;
    sum = sum * z + 0.0031765590861297516;
    sum = sum * z + 0.014652333042480134;
    sum = sum * z + 0.02365800843776174;
    sum = sum * z + 0.03991463872482601;
    sum = sum * z + 0.06552338456620405;
    sum = sum * z + 0.1044289360435494;
    sum = sum * z + 0.159840158783183;
    sum = sum * z + 0.23088023090191748;
    sum = sum * z + 0.304761904761669;
    sum = sum * z + 0.34285714285714386;
    sum = sum * z + 0.26666666666666666;
    return sum;
}

/* A command that asks for nothing; number by number, since memset is of no use without libc. */
static void two_bodies_f64_nothing(two_bodies_f64_command *command)
{
    command->force[0] = 0.0;
    command->force[1] = 0.0;
    command->force[2] = 0.0;
    command->force[3] = 0.0;
    command->force[4] = 0.0;
    command->force[5] = 0.0;
    command->force[6] = 0.0;
    command->force[7] = 0.0;
    command->force[8] = 0.0;
    command->s[0] = 0.0;
    command->s[1] = 0.0;
    command->s[2] = 0.0;
    command->s[3] = 0.0;
    command->s[4] = 0.0;
    command->s[5] = 0.0;
    command->s[6] = 0.0;
    command->s[7] = 0.0;
    command->s[8] = 0.0;
    command->nu_u[0] = 0.0;
    command->nu_u[1] = 0.0;
    command->nu_u[2] = 0.0;
    command->nu_u[3] = 0.0;
    command->nu_u[4] = 0.0;
    command->nu_u[5] = 0.0;
    command->nu_u[6] = 0.0;
    command->nu_u[7] = 0.0;
    command->nu_u[8] = 0.0;
    command->nu_u_dot[0] = 0.0;
    command->nu_u_dot[1] = 0.0;
    command->nu_u_dot[2] = 0.0;
    command->nu_u_dot[3] = 0.0;
    command->nu_u_dot[4] = 0.0;
    command->nu_u_dot[5] = 0.0;
    command->nu_u_dot[6] = 0.0;
    command->nu_u_dot[7] = 0.0;
    command->nu_u_dot[8] = 0.0;
}

/* force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl), past the error. Gives its clearance, 0
   where the law jumps. */
static double two_bodies_f64_law(const two_bodies_f64_params *params,
        const two_bodies_f64_state *state, const two_bodies_f64_reference *reference,
        two_bodies_f64_command *command, const double g_e_0, const double g_e_1, const double g_e_2,
        const double g_e_3, const double g_e_4, const double g_e_5, const double g_e_6,
        const double g_e_7, const double g_e_8, const double g_e_9, const double g_e_10,
        const double g_e_11, const double g_e_16, const double g_e_17, const double g_e_18,
        const double g_e_19, const double g_e_20, const double g_e_21, const double g_e_22,
        const double g_e_23, const double g_e_24)
{
    /* -- tracking -- */
    const double inertia_0 = params->inertia[0], inertia_2 = params->inertia[2],
        inertia_4 = params->inertia[4], inertia_9 = params->inertia[9],
        inertia_11 = params->inertia[11], inertia_17 = params->inertia[17],
        inertia_24 = params->inertia[24], inertia_30 = params->inertia[30],
        inertia_35 = params->inertia[35], inertia_39 = params->inertia[39],
        inertia_42 = params->inertia[42], inertia_44 = params->inertia[44];
    const double rate_gain = params->lambda;
    const double reach_gain = params->k_s;
    const double nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2], nu_3 = state->nu[3],
        nu_4 = state->nu[4], nu_5 = state->nu[5], nu_6 = state->nu[6], nu_7 = state->nu[7],
        nu_8 = state->nu[8];
    const double nu_r_0 = reference->nu[0], nu_r_1 = reference->nu[1], nu_r_2 = reference->nu[2],
        nu_r_3 = reference->nu[3], nu_r_4 = reference->nu[4], nu_r_5 = reference->nu[5],
        nu_r_6 = reference->nu[6], nu_r_7 = reference->nu[7], nu_r_8 = reference->nu[8];
    const double nu_r_dot_0 = reference->nu_dot[0], nu_r_dot_1 = reference->nu_dot[1],
        nu_r_dot_2 = reference->nu_dot[2], nu_r_dot_3 = reference->nu_dot[3],
        nu_r_dot_4 = reference->nu_dot[4], nu_r_dot_5 = reference->nu_dot[5],
        nu_r_dot_6 = reference->nu_dot[6], nu_r_dot_7 = reference->nu_dot[7],
        nu_r_dot_8 = reference->nu_dot[8];

    /* eta_arm_0_a: velocity at p [m/s] */
    const double eta_arm_0_a_0 = nu_r_3 + g_e_11*nu_r_1 - g_e_7*nu_r_2;
    const double eta_arm_0_a_1 = nu_r_4 + g_e_3*nu_r_2 - g_e_11*nu_r_0;
    const double eta_arm_0_a_2 = nu_r_5 + g_e_7*nu_r_0 - g_e_3*nu_r_1;

    /* eta: reference velocity in the body frame [rad/s, m/s], eq. (velErr) */
    const double eta_0 = g_e_0*nu_r_0 + g_e_4*nu_r_1 + g_e_8*nu_r_2;
    const double eta_1 = g_e_1*nu_r_0 + g_e_5*nu_r_1 + g_e_9*nu_r_2;
    const double eta_2 = g_e_10*nu_r_2 + g_e_2*nu_r_0 + g_e_6*nu_r_1;
    const double eta_3 = eta_arm_0_a_0*g_e_0 + eta_arm_0_a_1*g_e_4 + eta_arm_0_a_2*g_e_8;
    const double eta_4 = eta_arm_0_a_0*g_e_1 + eta_arm_0_a_1*g_e_5 + eta_arm_0_a_2*g_e_9;
    const double eta_5 = eta_arm_0_a_0*g_e_2 + eta_arm_0_a_1*g_e_6 + eta_arm_0_a_2*g_e_10;
    const double eta_6 = g_e_16*nu_r_6 + g_e_19*nu_r_7 + g_e_22*nu_r_8;
    const double eta_7 = g_e_17*nu_r_6 + g_e_20*nu_r_7 + g_e_23*nu_r_8;
    const double eta_8 = g_e_18*nu_r_6 + g_e_21*nu_r_7 + g_e_24*nu_r_8;

    /* nu_e: velocity error [rad/s, m/s], eq. (velErr) */
    const double nu_e_0 = nu_0 - eta_0;
    const double nu_e_1 = nu_1 - eta_1;
    const double nu_e_2 = nu_2 - eta_2;
    const double nu_e_3 = nu_3 - eta_3;
    const double nu_e_4 = nu_4 - eta_4;
    const double nu_e_5 = nu_5 - eta_5;
    const double nu_e_6 = nu_6 - eta_6;
    const double nu_e_7 = nu_7 - eta_7;
    const double nu_e_8 = nu_8 - eta_8;

    /* eta_dot_arm_0_a: velocity at p [m/s] */
    const double eta_dot_arm_0_a_0 = nu_r_dot_3 + g_e_11*nu_r_dot_1 - g_e_7*nu_r_dot_2;
    const double eta_dot_arm_0_a_1 = nu_r_dot_4 + g_e_3*nu_r_dot_2 - g_e_11*nu_r_dot_0;
    const double eta_dot_arm_0_a_2 = nu_r_dot_5 + g_e_7*nu_r_dot_0 - g_e_3*nu_r_dot_1;

    /* eta_dot: exact rate of eta [rad/s^2, m/s^2] */
    const double eta_dot_0 = eta_1*nu_e_2 + g_e_0*nu_r_dot_0 + g_e_4*nu_r_dot_1 + g_e_8*nu_r_dot_2 -
        eta_2*nu_e_1;
    const double eta_dot_1 = eta_2*nu_e_0 + g_e_1*nu_r_dot_0 + g_e_5*nu_r_dot_1 + g_e_9*nu_r_dot_2 -
        eta_0*nu_e_2;
    const double eta_dot_2 = eta_0*nu_e_1 + g_e_10*nu_r_dot_2 + g_e_2*nu_r_dot_0 + g_e_6*nu_r_dot_1
        - eta_1*nu_e_0;
    const double eta_dot_3 = eta_1*nu_e_5 + eta_4*nu_e_2 + eta_dot_arm_0_a_0*g_e_0 +
        eta_dot_arm_0_a_1*g_e_4 + eta_dot_arm_0_a_2*g_e_8 - eta_2*nu_e_4 - eta_5*nu_e_1;
    const double eta_dot_4 = eta_2*nu_e_3 + eta_5*nu_e_0 + eta_dot_arm_0_a_0*g_e_1 +
        eta_dot_arm_0_a_1*g_e_5 + eta_dot_arm_0_a_2*g_e_9 - eta_0*nu_e_5 - eta_3*nu_e_2;
    const double eta_dot_5 = eta_0*nu_e_4 + eta_3*nu_e_1 + eta_dot_arm_0_a_0*g_e_2 +
        eta_dot_arm_0_a_1*g_e_6 + eta_dot_arm_0_a_2*g_e_10 - eta_1*nu_e_3 - eta_4*nu_e_0;
    const double eta_dot_6 = eta_7*nu_e_8 + g_e_16*nu_r_dot_6 + g_e_19*nu_r_dot_7 +
        g_e_22*nu_r_dot_8 - eta_8*nu_e_7;
    const double eta_dot_7 = eta_8*nu_e_6 + g_e_17*nu_r_dot_6 + g_e_20*nu_r_dot_7 +
        g_e_23*nu_r_dot_8 - eta_6*nu_e_8;
    const double eta_dot_8 = eta_6*nu_e_7 + g_e_18*nu_r_dot_6 + g_e_21*nu_r_dot_7 +
        g_e_24*nu_r_dot_8 - eta_7*nu_e_6;

    /* pairs_a: what B's diagonal is made of [1] */
    const double pairs_a_0 = 1.0 + g_e_0;
    const double pairs_a_1 = 1.0 - g_e_0;
    const double pairs_a_2 = g_e_10 + g_e_5;
    const double pairs_a_3 = g_e_5 - g_e_10;

    /* B_a: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack */
    const double B_a_0 = pairs_a_0 - pairs_a_2;
    const double B_a_1 = g_e_1 + g_e_4;
    const double B_a_2 = g_e_2 + g_e_8;
    const double B_a_3 = g_e_9 - g_e_6;
    const double B_a_4 = pairs_a_1 + pairs_a_3;
    const double B_a_5 = g_e_6 + g_e_9;
    const double B_a_6 = g_e_2 - g_e_8;
    const double B_a_7 = pairs_a_1 - pairs_a_3;
    const double B_a_8 = g_e_4 - g_e_1;
    const double B_a_9 = pairs_a_0 + pairs_a_2;

    /* column_a: a column of B that cannot vanish [1] */
    double column_a_0, column_a_1, column_a_2, column_a_3;
    if (B_a_9 >= 1.0) {
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
    const double power_a_0 = B_a_0*column_a_0 + B_a_1*column_a_1 + B_a_2*column_a_2 +
        B_a_3*column_a_3;
    const double power_a_1 = B_a_1*column_a_0 + B_a_4*column_a_1 + B_a_5*column_a_2 +
        B_a_6*column_a_3;
    const double power_a_2 = B_a_2*column_a_0 + B_a_5*column_a_1 + B_a_7*column_a_2 +
        B_a_8*column_a_3;
    const double power_a_3 = B_a_3*column_a_0 + B_a_6*column_a_1 + B_a_8*column_a_2 +
        B_a_9*column_a_3;

    /* square_a: square of its vector part [1] */
    const double square_a = power_a_0*power_a_0 + power_a_1*power_a_1 + power_a_2*power_a_2;

    /* norm_square_a: its squared length [1] */
    const double norm_square_a = square_a + power_a_3*power_a_3;

    /* norm_bounded_a: the same: less is no element [1] */
    double norm_bounded_a;
    if (norm_square_a <= 49.0) {
        norm_bounded_a = 49.0;
    } else {
        norm_bounded_a = norm_square_a;
    }

    /* norm_a: its length [1] */
    const double norm_a = sqrt(norm_bounded_a);

    /* inverse_norm_a: to unit length [1] */
    const double inverse_norm_a = 1.0/norm_a;

    /* scale_a: to unit length, and to w >= 0: the shorter way round [1] */
    double scale_a;
    if (power_a_3 < 0.0) {
        scale_a = -inverse_norm_a;
    } else {
        scale_a = inverse_norm_a;
    }

    /* cosine_a: cos of half the error angle, rounded [1] */
    const double cosine_a = power_a_3*scale_a;

    /* w_a: cos of half the error angle [1] */
    double w_a;
    if (cosine_a >= 1.0) {
        w_a = 1.0;
    } else {
        w_a = cosine_a;
    }

    /* v_a: sin of half the error angle times its axis [1] */
    const double v_a_0 = power_a_0*scale_a;
    const double v_a_1 = power_a_1*scale_a;
    const double v_a_2 = power_a_2*scale_a;

    /* k_a: half angle over its sine [1] */
    const double k_a = two_bodies_f64_k(w_a);

    /* h_a: -dk/dw [1] */
    const double h_a = two_bodies_f64_h(w_a);

    /* phi_a: rotation vector of the error [rad] */
    const double phi_a_0 = 2.0*k_a*v_a_0;
    const double phi_a_1 = 2.0*k_a*v_a_1;
    const double phi_a_2 = 2.0*k_a*v_a_2;

    /* half_a: 1/(2 k) [1] */
    const double half_a = 0.5/k_a;

    /* swing_p_a: Y p [m] */
    const double swing_p_a_0 = g_e_11*v_a_1 - g_e_7*v_a_2;
    const double swing_p_a_1 = g_e_3*v_a_2 - g_e_11*v_a_0;
    const double swing_p_a_2 = g_e_7*v_a_0 - g_e_3*v_a_1;

    /* sway_p_a: Y Y p [m] */
    const double sway_p_a_0 = swing_p_a_2*v_a_1 - swing_p_a_1*v_a_2;
    const double sway_p_a_1 = swing_p_a_0*v_a_2 - swing_p_a_2*v_a_0;
    const double sway_p_a_2 = swing_p_a_1*v_a_0 - swing_p_a_0*v_a_1;

    /* rho_p_a: p - k Y p + h Y Y p [m] */
    const double rho_p_a_0 = g_e_3 + h_a*sway_p_a_0 - k_a*swing_p_a_0;
    const double rho_p_a_1 = g_e_7 + h_a*sway_p_a_1 - k_a*swing_p_a_1;
    const double rho_p_a_2 = g_e_11 + h_a*sway_p_a_2 - k_a*swing_p_a_2;

    /* y_p_a: rho/(2 k) [m] */
    const double y_p_a_0 = half_a*rho_p_a_0;
    const double y_p_a_1 = half_a*rho_p_a_1;
    const double y_p_a_2 = half_a*rho_p_a_2;

    /* pairs_b: what B's diagonal is made of [1] */
    const double pairs_b_0 = 1.0 + g_e_16;
    const double pairs_b_1 = 1.0 - g_e_16;
    const double pairs_b_2 = g_e_20 + g_e_24;
    const double pairs_b_3 = g_e_20 - g_e_24;

    /* B_b: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack */
    const double B_b_0 = pairs_b_0 - pairs_b_2;
    const double B_b_1 = g_e_17 + g_e_19;
    const double B_b_2 = g_e_18 + g_e_22;
    const double B_b_3 = g_e_23 - g_e_21;
    const double B_b_4 = pairs_b_1 + pairs_b_3;
    const double B_b_5 = g_e_21 + g_e_23;
    const double B_b_6 = g_e_18 - g_e_22;
    const double B_b_7 = pairs_b_1 - pairs_b_3;
    const double B_b_8 = g_e_19 - g_e_17;
    const double B_b_9 = pairs_b_0 + pairs_b_2;

    /* column_b: a column of B that cannot vanish [1] */
    double column_b_0, column_b_1, column_b_2, column_b_3;
    if (B_b_9 >= 1.0) {
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
    const double power_b_0 = B_b_0*column_b_0 + B_b_1*column_b_1 + B_b_2*column_b_2 +
        B_b_3*column_b_3;
    const double power_b_1 = B_b_1*column_b_0 + B_b_4*column_b_1 + B_b_5*column_b_2 +
        B_b_6*column_b_3;
    const double power_b_2 = B_b_2*column_b_0 + B_b_5*column_b_1 + B_b_7*column_b_2 +
        B_b_8*column_b_3;
    const double power_b_3 = B_b_3*column_b_0 + B_b_6*column_b_1 + B_b_8*column_b_2 +
        B_b_9*column_b_3;

    /* square_b: square of its vector part [1] */
    const double square_b = power_b_0*power_b_0 + power_b_1*power_b_1 + power_b_2*power_b_2;

    /* norm_square_b: its squared length [1] */
    const double norm_square_b = square_b + power_b_3*power_b_3;

    /* norm_bounded_b: the same: less is no element [1] */
    double norm_bounded_b;
    if (norm_square_b <= 49.0) {
        norm_bounded_b = 49.0;
    } else {
        norm_bounded_b = norm_square_b;
    }

    /* norm_b: its length [1] */
    const double norm_b = sqrt(norm_bounded_b);

    /* inverse_norm_b: to unit length [1] */
    const double inverse_norm_b = 1.0/norm_b;

    /* scale_b: to unit length, and to w >= 0: the shorter way round [1] */
    double scale_b;
    if (power_b_3 < 0.0) {
        scale_b = -inverse_norm_b;
    } else {
        scale_b = inverse_norm_b;
    }

    /* w_b: cos of half the error angle [1] */
    const double w_b = power_b_3*scale_b;

    /* k_b: half angle over its sine [1] */
    const double k_b = two_bodies_f64_k(w_b);

    /* h_raw_b: -dk/dw times scale^2, as s^2 h = 1 - w k [1] */
    const double h_raw_b = (1.0 - k_b*w_b)/(square_b + 1.0e-17);

    /* reach_b: p times the scale of the vector part [1] */
    const double reach_b = k_b*scale_b;

    /* stretch_b: nu_u over the vector part [1] */
    const double stretch_b = 2.0*reach_b;

    /* clearance_0: the smaller clearance [1] */
    double clearance_0;
    if (w_a <= w_b) {
        clearance_0 = w_a;
    } else {
        clearance_0 = w_b;
    }

    /* nu_u: kinematic law, the logarithm and the rotation vector [rad, m], def. (KctrLaw) */
    const double nu_u_6 = power_b_0*stretch_b;
    const double nu_u_7 = power_b_1*stretch_b;
    const double nu_u_8 = power_b_2*stretch_b;

    /* turn_a: Y nu_e, Y = ad of y [rad/s, m/s] */
    const double turn_a_0 = nu_e_2*v_a_1 - nu_e_1*v_a_2;
    const double turn_a_1 = nu_e_0*v_a_2 - nu_e_2*v_a_0;
    const double turn_a_2 = nu_e_1*v_a_0 - nu_e_0*v_a_1;
    const double turn_a_3 = nu_e_2*y_p_a_1 + nu_e_5*v_a_1 - nu_e_1*y_p_a_2 - nu_e_4*v_a_2;
    const double turn_a_4 = nu_e_0*y_p_a_2 + nu_e_3*v_a_2 - nu_e_2*y_p_a_0 - nu_e_5*v_a_0;
    const double turn_a_5 = nu_e_1*y_p_a_0 + nu_e_4*v_a_0 - nu_e_0*y_p_a_1 - nu_e_3*v_a_1;

    /* bend_a: Y Y nu_e [rad/s, m/s] */
    const double bend_a_0 = turn_a_2*v_a_1 - turn_a_1*v_a_2;
    const double bend_a_1 = turn_a_0*v_a_2 - turn_a_2*v_a_0;
    const double bend_a_2 = turn_a_1*v_a_0 - turn_a_0*v_a_1;
    const double bend_a_3 = turn_a_2*y_p_a_1 + turn_a_5*v_a_1 - turn_a_1*y_p_a_2 - turn_a_4*v_a_2;
    const double bend_a_4 = turn_a_0*y_p_a_2 + turn_a_3*v_a_2 - turn_a_2*y_p_a_0 - turn_a_5*v_a_0;
    const double bend_a_5 = turn_a_1*y_p_a_0 + turn_a_4*v_a_0 - turn_a_0*y_p_a_1 - turn_a_3*v_a_1;

    /* m_a: -dh/dw [1] */
    const double m_a = two_bodies_f64_m(w_a);

    /* along_p_a: -2 v.q [m] */
    const double along_p_a = -2.0*(v_a_0*y_p_a_0 + v_a_1*y_p_a_1 + v_a_2*y_p_a_2);

    /* tail_a: (Y^2 + s^2) Y^2 nu_e [rad/s, m/s] */
    const double tail_a_3 = along_p_a*bend_a_0;
    const double tail_a_4 = along_p_a*bend_a_1;
    const double tail_a_5 = along_p_a*bend_a_2;

    /* twofold_a: h^2 - k m/2, of the double root [1] */
    const double twofold_a = h_a*h_a - 0.5*k_a*m_a;

    /* turn_b: vector part x nu_e [rad/s] */
    const double turn_b_0 = nu_e_8*power_b_1 - nu_e_7*power_b_2;
    const double turn_b_1 = nu_e_6*power_b_2 - nu_e_8*power_b_0;
    const double turn_b_2 = nu_e_7*power_b_0 - nu_e_6*power_b_1;

    /* bend_b: vector part x turn [rad/s] */
    const double bend_b_0 = power_b_1*turn_b_2 - power_b_2*turn_b_1;
    const double bend_b_1 = power_b_2*turn_b_0 - power_b_0*turn_b_2;
    const double bend_b_2 = power_b_0*turn_b_1 - power_b_1*turn_b_0;

    /* nu_u_dot: exact rate of nu_u [rad/s, m/s] */
    const double nu_u_dot_0 = nu_e_0 + bend_a_0*h_a + k_a*turn_a_0;
    const double nu_u_dot_1 = nu_e_1 + bend_a_1*h_a + k_a*turn_a_1;
    const double nu_u_dot_2 = nu_e_2 + bend_a_2*h_a + k_a*turn_a_2;
    const double nu_u_dot_3 = nu_e_3 + bend_a_3*h_a + k_a*turn_a_3 + tail_a_3*twofold_a;
    const double nu_u_dot_4 = nu_e_4 + bend_a_4*h_a + k_a*turn_a_4 + tail_a_4*twofold_a;
    const double nu_u_dot_5 = nu_e_5 + bend_a_5*h_a + k_a*turn_a_5 + tail_a_5*twofold_a;
    const double nu_u_dot_6 = nu_e_6 + bend_b_0*h_raw_b + reach_b*turn_b_0;
    const double nu_u_dot_7 = nu_e_7 + bend_b_1*h_raw_b + reach_b*turn_b_1;
    const double nu_u_dot_8 = nu_e_8 + bend_b_2*h_raw_b + reach_b*turn_b_2;

    /* drive: lambda nu_u [rad/s, m/s] */
    const double drive_0 = phi_a_0*rate_gain;
    const double drive_1 = phi_a_1*rate_gain;
    const double drive_2 = phi_a_2*rate_gain;
    const double drive_3 = rate_gain*rho_p_a_0;
    const double drive_4 = rate_gain*rho_p_a_1;
    const double drive_5 = rate_gain*rho_p_a_2;
    const double drive_6 = nu_u_6*rate_gain;
    const double drive_7 = nu_u_7*rate_gain;
    const double drive_8 = nu_u_8*rate_gain;

    /* s: sliding variable [rad/s, m/s], eq. (SurfaceErr) */
    const double s_0 = drive_0 + nu_e_0;
    const double s_1 = drive_1 + nu_e_1;
    const double s_2 = drive_2 + nu_e_2;
    const double s_3 = drive_3 + nu_e_3;
    const double s_4 = drive_4 + nu_e_4;
    const double s_5 = drive_5 + nu_e_5;
    const double s_6 = drive_6 + nu_e_6;
    const double s_7 = drive_7 + nu_e_7;
    const double s_8 = drive_8 + nu_e_8;

    /* wanted: acceleration asked for [rad/s^2, m/s^2] */
    const double wanted_0 = eta_dot_0 - nu_u_dot_0*rate_gain - reach_gain*s_0;
    const double wanted_1 = eta_dot_1 - nu_u_dot_1*rate_gain - reach_gain*s_1;
    const double wanted_2 = eta_dot_2 - nu_u_dot_2*rate_gain - reach_gain*s_2;
    const double wanted_3 = eta_dot_3 - nu_u_dot_3*rate_gain - reach_gain*s_3;
    const double wanted_4 = eta_dot_4 - nu_u_dot_4*rate_gain - reach_gain*s_4;
    const double wanted_5 = eta_dot_5 - nu_u_dot_5*rate_gain - reach_gain*s_5;
    const double wanted_6 = eta_dot_6 - nu_u_dot_6*rate_gain - reach_gain*s_6;
    const double wanted_7 = eta_dot_7 - nu_u_dot_7*rate_gain - reach_gain*s_7;
    const double wanted_8 = eta_dot_8 - nu_u_dot_8*rate_gain - reach_gain*s_8;

    /* turning: lambda nu_u - eta [rad/s, m/s] */
    const double turning_0 = drive_0 - eta_0;
    const double turning_1 = drive_1 - eta_1;
    const double turning_2 = drive_2 - eta_2;
    const double turning_3 = drive_3 - eta_3;
    const double turning_4 = drive_4 - eta_4;
    const double turning_5 = drive_5 - eta_5;
    const double turning_6 = drive_6 - eta_6;
    const double turning_7 = drive_7 - eta_7;
    const double turning_8 = drive_8 - eta_8;

    /* momentum: I nu [N m s, N s] */
    const double momentum_0 = inertia_0*nu_0 + inertia_2*nu_2 + inertia_4*nu_4;
    const double momentum_1 = inertia_11*nu_3 + inertia_9*nu_1;
    const double momentum_2 = inertia_17*nu_2 + inertia_2*nu_0;
    const double momentum_3 = inertia_11*nu_1 + inertia_24*nu_3;
    const double momentum_4 = inertia_30*nu_4 + inertia_4*nu_0;
    const double momentum_5 = inertia_35*nu_5;
    const double momentum_6 = inertia_39*nu_6;
    const double momentum_7 = inertia_42*nu_7;
    const double momentum_8 = inertia_44*nu_8;

    /* force: control force, I f_u [N m, N], eq. (TckCtrl) */
    const double force_0 = inertia_0*wanted_0 + inertia_2*wanted_2 + inertia_4*wanted_4 +
        momentum_1*turning_2 + momentum_4*turning_5 - momentum_2*turning_1 - momentum_5*turning_4;
    const double force_1 = inertia_11*wanted_3 + inertia_9*wanted_1 + momentum_2*turning_0 +
        momentum_5*turning_3 - momentum_0*turning_2 - momentum_3*turning_5;
    const double force_2 = inertia_17*wanted_2 + inertia_2*wanted_0 + momentum_0*turning_1 +
        momentum_3*turning_4 - momentum_1*turning_0 - momentum_4*turning_3;
    const double force_3 = inertia_11*wanted_1 + inertia_24*wanted_3 + momentum_4*turning_2 -
        momentum_5*turning_1;
    const double force_4 = inertia_30*wanted_4 + inertia_4*wanted_0 + momentum_5*turning_0 -
        momentum_3*turning_2;
    const double force_5 = inertia_35*wanted_5 + momentum_3*turning_1 - momentum_4*turning_0;
    const double force_6 = inertia_39*wanted_6 + momentum_7*turning_8 - momentum_8*turning_7;
    const double force_7 = inertia_42*wanted_7 + momentum_8*turning_6 - momentum_6*turning_8;
    const double force_8 = inertia_44*wanted_8 + momentum_6*turning_7 - momentum_7*turning_6;

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
static void two_bodies_f64_definiteness(const two_bodies_f64_params *params, double pivot[9])
{
    /* -- definiteness -- */
    const double inertia_0 = params->inertia[0], inertia_2 = params->inertia[2],
        inertia_4 = params->inertia[4], inertia_9 = params->inertia[9],
        inertia_11 = params->inertia[11], inertia_17 = params->inertia[17],
        inertia_24 = params->inertia[24], inertia_30 = params->inertia[30],
        inertia_35 = params->inertia[35], inertia_39 = params->inertia[39],
        inertia_42 = params->inertia[42], inertia_44 = params->inertia[44];

    /* divisor_0: the pivot, or 1 where it is not positive [kg m^2, kg m, kg] */
    double divisor_0;
    if (inertia_0 > 0.0) {
        divisor_0 = inertia_0;
    } else {
        divisor_0 = 1.0;
    }

    /* lower_20: I = L D L^T, entry of L [1] */
    const double lower_20 = inertia_2/divisor_0;

    /* lower_40: I = L D L^T, entry of L [1] */
    const double lower_40 = inertia_4/divisor_0;

    /* divisor_1: the pivot, or 1 where it is not positive [kg m^2, kg m, kg] */
    double divisor_1;
    if (inertia_9 > 0.0) {
        divisor_1 = inertia_9;
    } else {
        divisor_1 = 1.0;
    }

    /* lower_31: I = L D L^T, entry of L [1] */
    const double lower_31 = inertia_11/divisor_1;

    /* pivot_2: pivot of I [kg m^2, kg m, kg] */
    const double pivot_2 = inertia_17 - inertia_0*lower_20*lower_20;

    /* divisor_2: the pivot, or 1 where it is not positive [kg m^2, kg m, kg] */
    double divisor_2;
    if (pivot_2 > 0.0) {
        divisor_2 = pivot_2;
    } else {
        divisor_2 = 1.0;
    }

    /* lower_42: I = L D L^T, entry of L [1] */
    const double lower_42 = -inertia_0*lower_20*lower_40/divisor_2;

    /* pivot_3: pivot of I [kg m^2, kg m, kg] */
    const double pivot_3 = inertia_24 - inertia_9*lower_31*lower_31;

    /* pivot_4: pivot of I [kg m^2, kg m, kg] */
    const double pivot_4 = inertia_30 - inertia_0*lower_40*lower_40 - pivot_2*lower_42*lower_42;

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

void two_bodies_f64_tracking(const two_bodies_f64_params *params, const two_bodies_f64_state *state,
        const two_bodies_f64_reference *reference, two_bodies_f64_command *command)
{
    /* -- tracking -- */
    const double g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5], g_6 = state->g[6], g_7 = state->g[7],
        g_8 = state->g[8], g_9 = state->g[9], g_10 = state->g[10], g_11 = state->g[11],
        g_16 = state->g[16], g_17 = state->g[17], g_18 = state->g[18], g_19 = state->g[19],
        g_20 = state->g[20], g_21 = state->g[21], g_22 = state->g[22], g_23 = state->g[23],
        g_24 = state->g[24];
    const double g_r_0 = reference->g[0], g_r_1 = reference->g[1], g_r_2 = reference->g[2],
        g_r_3 = reference->g[3], g_r_4 = reference->g[4], g_r_5 = reference->g[5],
        g_r_6 = reference->g[6], g_r_7 = reference->g[7], g_r_8 = reference->g[8],
        g_r_9 = reference->g[9], g_r_10 = reference->g[10], g_r_11 = reference->g[11],
        g_r_16 = reference->g[16], g_r_17 = reference->g[17], g_r_18 = reference->g[18],
        g_r_19 = reference->g[19], g_r_20 = reference->g[20], g_r_21 = reference->g[21],
        g_r_22 = reference->g[22], g_r_23 = reference->g[23], g_r_24 = reference->g[24];

    /* gap_0_a: translation of g from g_r [m] */
    const double gap_0_a_0 = g_3 - g_r_3;
    const double gap_0_a_1 = g_7 - g_r_7;
    const double gap_0_a_2 = g_11 - g_r_11;

    /* g_e: error, g_r^-1 g [1], eq. (velErr) */
    const double g_e_0 = g_0*g_r_0 + g_4*g_r_4 + g_8*g_r_8;
    const double g_e_1 = g_1*g_r_0 + g_5*g_r_4 + g_9*g_r_8;
    const double g_e_2 = g_10*g_r_8 + g_2*g_r_0 + g_6*g_r_4;
    const double g_e_3 = g_r_0*gap_0_a_0 + g_r_4*gap_0_a_1 + g_r_8*gap_0_a_2;
    const double g_e_4 = g_0*g_r_1 + g_4*g_r_5 + g_8*g_r_9;
    const double g_e_5 = g_1*g_r_1 + g_5*g_r_5 + g_9*g_r_9;
    const double g_e_6 = g_10*g_r_9 + g_2*g_r_1 + g_6*g_r_5;
    const double g_e_7 = g_r_1*gap_0_a_0 + g_r_5*gap_0_a_1 + g_r_9*gap_0_a_2;
    const double g_e_8 = g_0*g_r_2 + g_4*g_r_6 + g_8*g_r_10;
    const double g_e_9 = g_1*g_r_2 + g_5*g_r_6 + g_9*g_r_10;
    const double g_e_10 = g_10*g_r_10 + g_2*g_r_2 + g_6*g_r_6;
    const double g_e_11 = g_r_10*gap_0_a_2 + g_r_2*gap_0_a_0 + g_r_6*gap_0_a_1;
    const double g_e_16 = g_16*g_r_16 + g_19*g_r_19 + g_22*g_r_22;
    const double g_e_17 = g_17*g_r_16 + g_20*g_r_19 + g_23*g_r_22;
    const double g_e_18 = g_18*g_r_16 + g_21*g_r_19 + g_24*g_r_22;
    const double g_e_19 = g_16*g_r_17 + g_19*g_r_20 + g_22*g_r_23;
    const double g_e_20 = g_17*g_r_17 + g_20*g_r_20 + g_23*g_r_23;
    const double g_e_21 = g_18*g_r_17 + g_21*g_r_20 + g_24*g_r_23;
    const double g_e_22 = g_16*g_r_18 + g_19*g_r_21 + g_22*g_r_24;
    const double g_e_23 = g_17*g_r_18 + g_20*g_r_21 + g_23*g_r_24;
    const double g_e_24 = g_18*g_r_18 + g_21*g_r_21 + g_24*g_r_24;

    /* -- end -- */
    (void)two_bodies_f64_law(params, state, reference, command, g_e_0, g_e_1, g_e_2, g_e_3, g_e_4,
            g_e_5, g_e_6, g_e_7, g_e_8, g_e_9, g_e_10, g_e_11, g_e_16, g_e_17, g_e_18, g_e_19,
            g_e_20, g_e_21, g_e_22, g_e_23, g_e_24);
}

void two_bodies_f64_reaching(const two_bodies_f64_params *params, const two_bodies_f64_state *state,
        two_bodies_f64_command *command)
{
    /* -- reaching -- */
    const double inertia_0 = params->inertia[0], inertia_2 = params->inertia[2],
        inertia_4 = params->inertia[4], inertia_9 = params->inertia[9],
        inertia_11 = params->inertia[11], inertia_17 = params->inertia[17],
        inertia_24 = params->inertia[24], inertia_30 = params->inertia[30],
        inertia_35 = params->inertia[35], inertia_39 = params->inertia[39],
        inertia_42 = params->inertia[42], inertia_44 = params->inertia[44];
    const double rate_gain = params->lambda;
    const double reach_gain = params->k_s;
    const double g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5], g_6 = state->g[6], g_7 = state->g[7],
        g_8 = state->g[8], g_9 = state->g[9], g_10 = state->g[10], g_11 = state->g[11],
        g_16 = state->g[16], g_17 = state->g[17], g_18 = state->g[18], g_19 = state->g[19],
        g_20 = state->g[20], g_21 = state->g[21], g_22 = state->g[22], g_23 = state->g[23],
        g_24 = state->g[24];
    const double nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2], nu_3 = state->nu[3],
        nu_4 = state->nu[4], nu_5 = state->nu[5], nu_6 = state->nu[6], nu_7 = state->nu[7],
        nu_8 = state->nu[8];

    /* pairs_a: what B's diagonal is made of [1] */
    const double pairs_a_0 = 1.0 + g_0;
    const double pairs_a_1 = 1.0 - g_0;
    const double pairs_a_2 = g_10 + g_5;
    const double pairs_a_3 = g_5 - g_10;

    /* B_a: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack */
    const double B_a_0 = pairs_a_0 - pairs_a_2;
    const double B_a_1 = g_1 + g_4;
    const double B_a_2 = g_2 + g_8;
    const double B_a_3 = g_9 - g_6;
    const double B_a_4 = pairs_a_1 + pairs_a_3;
    const double B_a_5 = g_6 + g_9;
    const double B_a_6 = g_2 - g_8;
    const double B_a_7 = pairs_a_1 - pairs_a_3;
    const double B_a_8 = g_4 - g_1;
    const double B_a_9 = pairs_a_0 + pairs_a_2;

    /* column_a: a column of B that cannot vanish [1] */
    double column_a_0, column_a_1, column_a_2, column_a_3;
    if (B_a_9 >= 1.0) {
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
    const double power_a_0 = B_a_0*column_a_0 + B_a_1*column_a_1 + B_a_2*column_a_2 +
        B_a_3*column_a_3;
    const double power_a_1 = B_a_1*column_a_0 + B_a_4*column_a_1 + B_a_5*column_a_2 +
        B_a_6*column_a_3;
    const double power_a_2 = B_a_2*column_a_0 + B_a_5*column_a_1 + B_a_7*column_a_2 +
        B_a_8*column_a_3;
    const double power_a_3 = B_a_3*column_a_0 + B_a_6*column_a_1 + B_a_8*column_a_2 +
        B_a_9*column_a_3;

    /* square_a: square of its vector part [1] */
    const double square_a = power_a_0*power_a_0 + power_a_1*power_a_1 + power_a_2*power_a_2;

    /* norm_square_a: its squared length [1] */
    const double norm_square_a = square_a + power_a_3*power_a_3;

    /* norm_bounded_a: the same: less is no element [1] */
    double norm_bounded_a;
    if (norm_square_a <= 49.0) {
        norm_bounded_a = 49.0;
    } else {
        norm_bounded_a = norm_square_a;
    }

    /* norm_a: its length [1] */
    const double norm_a = sqrt(norm_bounded_a);

    /* inverse_norm_a: to unit length [1] */
    const double inverse_norm_a = 1.0/norm_a;

    /* scale_a: to unit length, and to w >= 0: the shorter way round [1] */
    double scale_a;
    if (power_a_3 < 0.0) {
        scale_a = -inverse_norm_a;
    } else {
        scale_a = inverse_norm_a;
    }

    /* cosine_a: cos of half the error angle, rounded [1] */
    const double cosine_a = power_a_3*scale_a;

    /* w_a: cos of half the error angle [1] */
    double w_a;
    if (cosine_a >= 1.0) {
        w_a = 1.0;
    } else {
        w_a = cosine_a;
    }

    /* v_a: sin of half the error angle times its axis [1] */
    const double v_a_0 = power_a_0*scale_a;
    const double v_a_1 = power_a_1*scale_a;
    const double v_a_2 = power_a_2*scale_a;

    /* k_a: half angle over its sine [1] */
    const double k_a = two_bodies_f64_k(w_a);

    /* h_a: -dk/dw [1] */
    const double h_a = two_bodies_f64_h(w_a);

    /* phi_a: rotation vector of the error [rad] */
    const double phi_a_0 = 2.0*k_a*v_a_0;
    const double phi_a_1 = 2.0*k_a*v_a_1;
    const double phi_a_2 = 2.0*k_a*v_a_2;

    /* half_a: 1/(2 k) [1] */
    const double half_a = 0.5/k_a;

    /* swing_p_a: Y p [m] */
    const double swing_p_a_0 = g_11*v_a_1 - g_7*v_a_2;
    const double swing_p_a_1 = g_3*v_a_2 - g_11*v_a_0;
    const double swing_p_a_2 = g_7*v_a_0 - g_3*v_a_1;

    /* sway_p_a: Y Y p [m] */
    const double sway_p_a_0 = swing_p_a_2*v_a_1 - swing_p_a_1*v_a_2;
    const double sway_p_a_1 = swing_p_a_0*v_a_2 - swing_p_a_2*v_a_0;
    const double sway_p_a_2 = swing_p_a_1*v_a_0 - swing_p_a_0*v_a_1;

    /* rho_p_a: p - k Y p + h Y Y p [m] */
    const double rho_p_a_0 = g_3 + h_a*sway_p_a_0 - k_a*swing_p_a_0;
    const double rho_p_a_1 = g_7 + h_a*sway_p_a_1 - k_a*swing_p_a_1;
    const double rho_p_a_2 = g_11 + h_a*sway_p_a_2 - k_a*swing_p_a_2;

    /* y_p_a: rho/(2 k) [m] */
    const double y_p_a_0 = half_a*rho_p_a_0;
    const double y_p_a_1 = half_a*rho_p_a_1;
    const double y_p_a_2 = half_a*rho_p_a_2;

    /* pairs_b: what B's diagonal is made of [1] */
    const double pairs_b_0 = 1.0 + g_16;
    const double pairs_b_1 = 1.0 - g_16;
    const double pairs_b_2 = g_20 + g_24;
    const double pairs_b_3 = g_20 - g_24;

    /* B_b: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack */
    const double B_b_0 = pairs_b_0 - pairs_b_2;
    const double B_b_1 = g_17 + g_19;
    const double B_b_2 = g_18 + g_22;
    const double B_b_3 = g_23 - g_21;
    const double B_b_4 = pairs_b_1 + pairs_b_3;
    const double B_b_5 = g_21 + g_23;
    const double B_b_6 = g_18 - g_22;
    const double B_b_7 = pairs_b_1 - pairs_b_3;
    const double B_b_8 = g_19 - g_17;
    const double B_b_9 = pairs_b_0 + pairs_b_2;

    /* column_b: a column of B that cannot vanish [1] */
    double column_b_0, column_b_1, column_b_2, column_b_3;
    if (B_b_9 >= 1.0) {
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
    const double power_b_0 = B_b_0*column_b_0 + B_b_1*column_b_1 + B_b_2*column_b_2 +
        B_b_3*column_b_3;
    const double power_b_1 = B_b_1*column_b_0 + B_b_4*column_b_1 + B_b_5*column_b_2 +
        B_b_6*column_b_3;
    const double power_b_2 = B_b_2*column_b_0 + B_b_5*column_b_1 + B_b_7*column_b_2 +
        B_b_8*column_b_3;
    const double power_b_3 = B_b_3*column_b_0 + B_b_6*column_b_1 + B_b_8*column_b_2 +
        B_b_9*column_b_3;

    /* square_b: square of its vector part [1] */
    const double square_b = power_b_0*power_b_0 + power_b_1*power_b_1 + power_b_2*power_b_2;

    /* norm_square_b: its squared length [1] */
    const double norm_square_b = square_b + power_b_3*power_b_3;

    /* norm_bounded_b: the same: less is no element [1] */
    double norm_bounded_b;
    if (norm_square_b <= 49.0) {
        norm_bounded_b = 49.0;
    } else {
        norm_bounded_b = norm_square_b;
    }

    /* norm_b: its length [1] */
    const double norm_b = sqrt(norm_bounded_b);

    /* inverse_norm_b: to unit length [1] */
    const double inverse_norm_b = 1.0/norm_b;

    /* scale_b: to unit length, and to w >= 0: the shorter way round [1] */
    double scale_b;
    if (power_b_3 < 0.0) {
        scale_b = -inverse_norm_b;
    } else {
        scale_b = inverse_norm_b;
    }

    /* w_b: cos of half the error angle [1] */
    const double w_b = power_b_3*scale_b;

    /* k_b: half angle over its sine [1] */
    const double k_b = two_bodies_f64_k(w_b);

    /* h_raw_b: -dk/dw times scale^2, as s^2 h = 1 - w k [1] */
    const double h_raw_b = (1.0 - k_b*w_b)/(square_b + 1.0e-17);

    /* reach_b: p times the scale of the vector part [1] */
    const double reach_b = k_b*scale_b;

    /* stretch_b: nu_u over the vector part [1] */
    const double stretch_b = 2.0*reach_b;

    /* nu_u: kinematic law, the logarithm and the rotation vector [rad, m], def. (KctrLaw) */
    const double nu_u_6 = power_b_0*stretch_b;
    const double nu_u_7 = power_b_1*stretch_b;
    const double nu_u_8 = power_b_2*stretch_b;

    /* turn_a: Y nu_e, Y = ad of y [rad/s, m/s] */
    const double turn_a_0 = nu_2*v_a_1 - nu_1*v_a_2;
    const double turn_a_1 = nu_0*v_a_2 - nu_2*v_a_0;
    const double turn_a_2 = nu_1*v_a_0 - nu_0*v_a_1;
    const double turn_a_3 = nu_2*y_p_a_1 + nu_5*v_a_1 - nu_1*y_p_a_2 - nu_4*v_a_2;
    const double turn_a_4 = nu_0*y_p_a_2 + nu_3*v_a_2 - nu_2*y_p_a_0 - nu_5*v_a_0;
    const double turn_a_5 = nu_1*y_p_a_0 + nu_4*v_a_0 - nu_0*y_p_a_1 - nu_3*v_a_1;

    /* bend_a: Y Y nu_e [rad/s, m/s] */
    const double bend_a_0 = turn_a_2*v_a_1 - turn_a_1*v_a_2;
    const double bend_a_1 = turn_a_0*v_a_2 - turn_a_2*v_a_0;
    const double bend_a_2 = turn_a_1*v_a_0 - turn_a_0*v_a_1;
    const double bend_a_3 = turn_a_2*y_p_a_1 + turn_a_5*v_a_1 - turn_a_1*y_p_a_2 - turn_a_4*v_a_2;
    const double bend_a_4 = turn_a_0*y_p_a_2 + turn_a_3*v_a_2 - turn_a_2*y_p_a_0 - turn_a_5*v_a_0;
    const double bend_a_5 = turn_a_1*y_p_a_0 + turn_a_4*v_a_0 - turn_a_0*y_p_a_1 - turn_a_3*v_a_1;

    /* m_a: -dh/dw [1] */
    const double m_a = two_bodies_f64_m(w_a);

    /* along_p_a: -2 v.q [m] */
    const double along_p_a = -2.0*(v_a_0*y_p_a_0 + v_a_1*y_p_a_1 + v_a_2*y_p_a_2);

    /* tail_a: (Y^2 + s^2) Y^2 nu_e [rad/s, m/s] */
    const double tail_a_3 = along_p_a*bend_a_0;
    const double tail_a_4 = along_p_a*bend_a_1;
    const double tail_a_5 = along_p_a*bend_a_2;

    /* twofold_a: h^2 - k m/2, of the double root [1] */
    const double twofold_a = h_a*h_a - 0.5*k_a*m_a;

    /* turn_b: vector part x nu_e [rad/s] */
    const double turn_b_0 = nu_8*power_b_1 - nu_7*power_b_2;
    const double turn_b_1 = nu_6*power_b_2 - nu_8*power_b_0;
    const double turn_b_2 = nu_7*power_b_0 - nu_6*power_b_1;

    /* bend_b: vector part x turn [rad/s] */
    const double bend_b_0 = power_b_1*turn_b_2 - power_b_2*turn_b_1;
    const double bend_b_1 = power_b_2*turn_b_0 - power_b_0*turn_b_2;
    const double bend_b_2 = power_b_0*turn_b_1 - power_b_1*turn_b_0;

    /* nu_u_dot: exact rate of nu_u [rad/s, m/s] */
    const double nu_u_dot_0 = nu_0 + bend_a_0*h_a + k_a*turn_a_0;
    const double nu_u_dot_1 = nu_1 + bend_a_1*h_a + k_a*turn_a_1;
    const double nu_u_dot_2 = nu_2 + bend_a_2*h_a + k_a*turn_a_2;
    const double nu_u_dot_3 = nu_3 + bend_a_3*h_a + k_a*turn_a_3 + tail_a_3*twofold_a;
    const double nu_u_dot_4 = nu_4 + bend_a_4*h_a + k_a*turn_a_4 + tail_a_4*twofold_a;
    const double nu_u_dot_5 = nu_5 + bend_a_5*h_a + k_a*turn_a_5 + tail_a_5*twofold_a;
    const double nu_u_dot_6 = nu_6 + bend_b_0*h_raw_b + reach_b*turn_b_0;
    const double nu_u_dot_7 = nu_7 + bend_b_1*h_raw_b + reach_b*turn_b_1;
    const double nu_u_dot_8 = nu_8 + bend_b_2*h_raw_b + reach_b*turn_b_2;

    /* drive: lambda nu_u [rad/s, m/s] */
    const double drive_0 = phi_a_0*rate_gain;
    const double drive_1 = phi_a_1*rate_gain;
    const double drive_2 = phi_a_2*rate_gain;
    const double drive_3 = rate_gain*rho_p_a_0;
    const double drive_4 = rate_gain*rho_p_a_1;
    const double drive_5 = rate_gain*rho_p_a_2;
    const double drive_6 = nu_u_6*rate_gain;
    const double drive_7 = nu_u_7*rate_gain;
    const double drive_8 = nu_u_8*rate_gain;

    /* s: sliding variable [rad/s, m/s], eq. (sldS) */
    const double s_0 = drive_0 + nu_0;
    const double s_1 = drive_1 + nu_1;
    const double s_2 = drive_2 + nu_2;
    const double s_3 = drive_3 + nu_3;
    const double s_4 = drive_4 + nu_4;
    const double s_5 = drive_5 + nu_5;
    const double s_6 = drive_6 + nu_6;
    const double s_7 = drive_7 + nu_7;
    const double s_8 = drive_8 + nu_8;

    /* wanted: acceleration asked for [rad/s^2, m/s^2] */
    const double wanted_0 = -(nu_u_dot_0*rate_gain + reach_gain*s_0);
    const double wanted_1 = -(nu_u_dot_1*rate_gain + reach_gain*s_1);
    const double wanted_2 = -(nu_u_dot_2*rate_gain + reach_gain*s_2);
    const double wanted_3 = -(nu_u_dot_3*rate_gain + reach_gain*s_3);
    const double wanted_4 = -(nu_u_dot_4*rate_gain + reach_gain*s_4);
    const double wanted_5 = -(nu_u_dot_5*rate_gain + reach_gain*s_5);
    const double wanted_6 = -(nu_u_dot_6*rate_gain + reach_gain*s_6);
    const double wanted_7 = -(nu_u_dot_7*rate_gain + reach_gain*s_7);
    const double wanted_8 = -(nu_u_dot_8*rate_gain + reach_gain*s_8);

    /* momentum: I nu [N m s, N s] */
    const double momentum_0 = inertia_0*nu_0 + inertia_2*nu_2 + inertia_4*nu_4;
    const double momentum_1 = inertia_11*nu_3 + inertia_9*nu_1;
    const double momentum_2 = inertia_17*nu_2 + inertia_2*nu_0;
    const double momentum_3 = inertia_11*nu_1 + inertia_24*nu_3;
    const double momentum_4 = inertia_30*nu_4 + inertia_4*nu_0;
    const double momentum_5 = inertia_35*nu_5;
    const double momentum_6 = inertia_39*nu_6;
    const double momentum_7 = inertia_42*nu_7;
    const double momentum_8 = inertia_44*nu_8;

    /* force: control force, I f_u [N m, N], eq. (Ctrl2) */
    const double force_0 = drive_2*momentum_1 + drive_5*momentum_4 + inertia_0*wanted_0 +
        inertia_2*wanted_2 + inertia_4*wanted_4 - drive_1*momentum_2 - drive_4*momentum_5;
    const double force_1 = drive_0*momentum_2 + drive_3*momentum_5 + inertia_11*wanted_3 +
        inertia_9*wanted_1 - drive_2*momentum_0 - drive_5*momentum_3;
    const double force_2 = drive_1*momentum_0 + drive_4*momentum_3 + inertia_17*wanted_2 +
        inertia_2*wanted_0 - drive_0*momentum_1 - drive_3*momentum_4;
    const double force_3 = drive_2*momentum_4 + inertia_11*wanted_1 + inertia_24*wanted_3 -
        drive_1*momentum_5;
    const double force_4 = drive_0*momentum_5 + inertia_30*wanted_4 + inertia_4*wanted_0 -
        drive_2*momentum_3;
    const double force_5 = drive_1*momentum_3 + inertia_35*wanted_5 - drive_0*momentum_4;
    const double force_6 = drive_8*momentum_7 + inertia_39*wanted_6 - drive_7*momentum_8;
    const double force_7 = drive_6*momentum_8 + inertia_42*wanted_7 - drive_8*momentum_6;
    const double force_8 = drive_7*momentum_6 + inertia_44*wanted_8 - drive_6*momentum_7;

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

void two_bodies_f64_plant(const two_bodies_f64_params *params, const two_bodies_f64_state *state,
        const double force[9], double nu_dot[9])
{
    /* -- plant -- */
    const double inertia_0 = params->inertia[0], inertia_2 = params->inertia[2],
        inertia_4 = params->inertia[4], inertia_9 = params->inertia[9],
        inertia_11 = params->inertia[11], inertia_17 = params->inertia[17],
        inertia_24 = params->inertia[24], inertia_30 = params->inertia[30],
        inertia_35 = params->inertia[35], inertia_39 = params->inertia[39],
        inertia_42 = params->inertia[42], inertia_44 = params->inertia[44];
    const double nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2], nu_3 = state->nu[3],
        nu_4 = state->nu[4], nu_5 = state->nu[5], nu_6 = state->nu[6], nu_7 = state->nu[7],
        nu_8 = state->nu[8];
    const double force_0 = force[0], force_1 = force[1], force_2 = force[2], force_3 = force[3],
        force_4 = force[4], force_5 = force[5], force_6 = force[6], force_7 = force[7],
        force_8 = force[8];

    /* momentum: I nu [N m s, N s] */
    const double momentum_0 = inertia_0*nu_0 + inertia_2*nu_2 + inertia_4*nu_4;
    const double momentum_1 = inertia_11*nu_3 + inertia_9*nu_1;
    const double momentum_2 = inertia_17*nu_2 + inertia_2*nu_0;
    const double momentum_3 = inertia_11*nu_1 + inertia_24*nu_3;
    const double momentum_4 = inertia_30*nu_4 + inertia_4*nu_0;
    const double momentum_5 = inertia_35*nu_5;
    const double momentum_6 = inertia_39*nu_6;
    const double momentum_7 = inertia_42*nu_7;
    const double momentum_8 = inertia_44*nu_8;

    /* total: coad(nu) I nu + force [N m, N] */
    const double total_0 = force_0 + momentum_1*nu_2 + momentum_4*nu_5 - momentum_2*nu_1 -
        momentum_5*nu_4;
    const double total_1 = force_1 + momentum_2*nu_0 + momentum_5*nu_3 - momentum_0*nu_2 -
        momentum_3*nu_5;
    const double total_2 = force_2 + momentum_0*nu_1 + momentum_3*nu_4 - momentum_1*nu_0 -
        momentum_4*nu_3;
    const double total_3 = force_3 + momentum_4*nu_2 - momentum_5*nu_1;
    const double total_4 = force_4 + momentum_5*nu_0 - momentum_3*nu_2;
    const double total_5 = force_5 + momentum_3*nu_1 - momentum_4*nu_0;
    const double total_6 = force_6 + momentum_7*nu_8 - momentum_8*nu_7;
    const double total_7 = force_7 + momentum_8*nu_6 - momentum_6*nu_8;
    const double total_8 = force_8 + momentum_6*nu_7 - momentum_7*nu_6;

    /* lower_20: I = L D L^T, entry of L [1] */
    const double lower_20 = inertia_2/inertia_0;

    /* lower_40: I = L D L^T, entry of L [1] */
    const double lower_40 = inertia_4/inertia_0;

    /* lower_31: I = L D L^T, entry of L [1] */
    const double lower_31 = inertia_11/inertia_9;

    /* pivot_2: pivot of I [kg m^2, kg m, kg] */
    const double pivot_2 = inertia_17 - inertia_0*lower_20*lower_20;

    /* lower_42: I = L D L^T, entry of L [1] */
    const double lower_42 = -inertia_0*lower_20*lower_40/pivot_2;

    /* pivot_3: pivot of I [kg m^2, kg m, kg] */
    const double pivot_3 = inertia_24 - inertia_9*lower_31*lower_31;

    /* pivot_4: pivot of I [kg m^2, kg m, kg] */
    const double pivot_4 = inertia_30 - inertia_0*lower_40*lower_40 - pivot_2*lower_42*lower_42;

    /* forward_2: forward substitution [N m, N] */
    const double forward_2 = total_2 - lower_20*total_0;

    /* forward_3: forward substitution [N m, N] */
    const double forward_3 = total_3 - lower_31*total_1;

    /* forward_4: forward substitution [N m, N] */
    const double forward_4 = total_4 - forward_2*lower_42 - lower_40*total_0;

    /* back_8: back substitution [rad/s^2, m/s^2] */
    const double back_8 = total_8/inertia_44;

    /* back_7: back substitution [rad/s^2, m/s^2] */
    const double back_7 = total_7/inertia_42;

    /* back_6: back substitution [rad/s^2, m/s^2] */
    const double back_6 = total_6/inertia_39;

    /* back_5: back substitution [rad/s^2, m/s^2] */
    const double back_5 = total_5/inertia_35;

    /* back_4: back substitution [rad/s^2, m/s^2] */
    const double back_4 = forward_4/pivot_4;

    /* back_3: back substitution [rad/s^2, m/s^2] */
    const double back_3 = forward_3/pivot_3;

    /* back_2: back substitution [rad/s^2, m/s^2] */
    const double back_2 = forward_2/pivot_2 - back_4*lower_42;

    /* back_1: back substitution [rad/s^2, m/s^2] */
    const double back_1 = total_1/inertia_9 - back_3*lower_31;

    /* back_0: back substitution [rad/s^2, m/s^2] */
    const double back_0 = total_0/inertia_0 - back_2*lower_20 - back_4*lower_40;

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
static two_bodies_f64_status two_bodies_f64_worse(const two_bodies_f64_status a,
        const two_bodies_f64_status b)
{
    return a > b ? a : b;
}

/* OUT_OF_RANGE or NONFINITE_INPUT if any number is larger than a limit or not finite. */
static two_bodies_f64_status two_bodies_f64_inspect(const double *numbers, const int count,
        const double limit)
{
    two_bodies_f64_status worst = TWO_BODIES_F64_OK;
    int i;
    for (i = 0; i < count; i++) {
        if (!isfinite(numbers[i])) {
            worst = TWO_BODIES_F64_NONFINITE_INPUT;
        } else if (fabs(numbers[i]) > limit) {
            worst = two_bodies_f64_worse(worst, TWO_BODIES_F64_OUT_OF_RANGE);
        } else {
            /* finite and in range: it leaves the finding as it is */
        }
    }
    return worst;
}

/* Zero command; its status says what is wrong with what was refused, at least what was found. */
static two_bodies_f64_status two_bodies_f64_refuse(const two_bodies_f64_state *state,
        const two_bodies_f64_reference *reference, const two_bodies_f64_status found,
        two_bodies_f64_command *command)
{
    two_bodies_f64_status worst = found;
    worst = two_bodies_f64_worse(worst,
            two_bodies_f64_inspect(state->g, 25, TWO_BODIES_F64_MAX_INPUT));
    worst = two_bodies_f64_worse(worst,
            two_bodies_f64_inspect(state->nu, 9, TWO_BODIES_F64_MAX_INPUT));
    worst = two_bodies_f64_worse(worst,
            two_bodies_f64_inspect(reference->g, 25, TWO_BODIES_F64_MAX_INPUT));
    worst = two_bodies_f64_worse(worst,
            two_bodies_f64_inspect(reference->nu, 9, TWO_BODIES_F64_MAX_INPUT));
    worst = two_bodies_f64_worse(worst,
            two_bodies_f64_inspect(reference->nu_dot, 9, TWO_BODIES_F64_MAX_INPUT));
    two_bodies_f64_nothing(command);
    return worst;
}

/* What a computed command is worth, given its distance from the cut locus of the law. */
static two_bodies_f64_status two_bodies_f64_verdict(const double clearance,
        two_bodies_f64_command *command)
{
    if (!(isfinite(command->force[0]) && isfinite(command->force[1]) && isfinite(command->force[2])
            && isfinite(command->force[3]) && isfinite(command->force[4])
            && isfinite(command->force[5]) && isfinite(command->force[6])
            && isfinite(command->force[7]) && isfinite(command->force[8]))) {
        two_bodies_f64_nothing(command);
        return TWO_BODIES_F64_NONFINITE_INPUT;
    }
    return clearance < TWO_BODIES_F64_NEAR_CUT ? TWO_BODIES_F64_NEAR_CUT_LOCUS : TWO_BODIES_F64_OK;
}

two_bodies_f64_status two_bodies_f64_control(const two_bodies_f64_params *params,
        const two_bodies_f64_state *state, const two_bodies_f64_reference *reference,
        two_bodies_f64_command *command)
{
    double clearance;
#ifdef TWO_BODIES_CHECK_POINTERS
    if (params == NULL || state == NULL || reference == NULL || command == NULL) {
        if (command != NULL) {
            two_bodies_f64_nothing(command);
        }
        return TWO_BODIES_F64_BAD_PARAMS;
    }
#endif
    /* -- tracking -- */
    const double g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5], g_6 = state->g[6], g_7 = state->g[7],
        g_8 = state->g[8], g_9 = state->g[9], g_10 = state->g[10], g_11 = state->g[11],
        g_16 = state->g[16], g_17 = state->g[17], g_18 = state->g[18], g_19 = state->g[19],
        g_20 = state->g[20], g_21 = state->g[21], g_22 = state->g[22], g_23 = state->g[23],
        g_24 = state->g[24];
    const double g_r_0 = reference->g[0], g_r_1 = reference->g[1], g_r_2 = reference->g[2],
        g_r_3 = reference->g[3], g_r_4 = reference->g[4], g_r_5 = reference->g[5],
        g_r_6 = reference->g[6], g_r_7 = reference->g[7], g_r_8 = reference->g[8],
        g_r_9 = reference->g[9], g_r_10 = reference->g[10], g_r_11 = reference->g[11],
        g_r_16 = reference->g[16], g_r_17 = reference->g[17], g_r_18 = reference->g[18],
        g_r_19 = reference->g[19], g_r_20 = reference->g[20], g_r_21 = reference->g[21],
        g_r_22 = reference->g[22], g_r_23 = reference->g[23], g_r_24 = reference->g[24];

    /* gap_0_a: translation of g from g_r [m] */
    const double gap_0_a_0 = g_3 - g_r_3;
    const double gap_0_a_1 = g_7 - g_r_7;
    const double gap_0_a_2 = g_11 - g_r_11;

    /* g_e: error, g_r^-1 g [1], eq. (velErr) */
    const double g_e_0 = g_0*g_r_0 + g_4*g_r_4 + g_8*g_r_8;
    const double g_e_1 = g_1*g_r_0 + g_5*g_r_4 + g_9*g_r_8;
    const double g_e_2 = g_10*g_r_8 + g_2*g_r_0 + g_6*g_r_4;
    const double g_e_3 = g_r_0*gap_0_a_0 + g_r_4*gap_0_a_1 + g_r_8*gap_0_a_2;
    const double g_e_4 = g_0*g_r_1 + g_4*g_r_5 + g_8*g_r_9;
    const double g_e_5 = g_1*g_r_1 + g_5*g_r_5 + g_9*g_r_9;
    const double g_e_6 = g_10*g_r_9 + g_2*g_r_1 + g_6*g_r_5;
    const double g_e_7 = g_r_1*gap_0_a_0 + g_r_5*gap_0_a_1 + g_r_9*gap_0_a_2;
    const double g_e_8 = g_0*g_r_2 + g_4*g_r_6 + g_8*g_r_10;
    const double g_e_9 = g_1*g_r_2 + g_5*g_r_6 + g_9*g_r_10;
    const double g_e_10 = g_10*g_r_10 + g_2*g_r_2 + g_6*g_r_6;
    const double g_e_11 = g_r_10*gap_0_a_2 + g_r_2*gap_0_a_0 + g_r_6*gap_0_a_1;
    const double g_e_16 = g_16*g_r_16 + g_19*g_r_19 + g_22*g_r_22;
    const double g_e_17 = g_17*g_r_16 + g_20*g_r_19 + g_23*g_r_22;
    const double g_e_18 = g_18*g_r_16 + g_21*g_r_19 + g_24*g_r_22;
    const double g_e_19 = g_16*g_r_17 + g_19*g_r_20 + g_22*g_r_23;
    const double g_e_20 = g_17*g_r_17 + g_20*g_r_20 + g_23*g_r_23;
    const double g_e_21 = g_18*g_r_17 + g_21*g_r_20 + g_24*g_r_23;
    const double g_e_22 = g_16*g_r_18 + g_19*g_r_21 + g_22*g_r_24;
    const double g_e_23 = g_17*g_r_18 + g_20*g_r_21 + g_23*g_r_24;
    const double g_e_24 = g_18*g_r_18 + g_21*g_r_21 + g_24*g_r_24;

    /* -- end -- */
    if (!(fabs(g_e_0) <= TWO_BODIES_F64_MAX_ENTRY && fabs(g_e_1) <= TWO_BODIES_F64_MAX_ENTRY
            && fabs(g_e_2) <= TWO_BODIES_F64_MAX_ENTRY && fabs(g_e_3) <= TWO_BODIES_F64_MAX_REACH
            && fabs(g_e_4) <= TWO_BODIES_F64_MAX_ENTRY && fabs(g_e_5) <= TWO_BODIES_F64_MAX_ENTRY
            && fabs(g_e_6) <= TWO_BODIES_F64_MAX_ENTRY && fabs(g_e_7) <= TWO_BODIES_F64_MAX_REACH
            && fabs(g_e_8) <= TWO_BODIES_F64_MAX_ENTRY && fabs(g_e_9) <= TWO_BODIES_F64_MAX_ENTRY
            && fabs(g_e_10) <= TWO_BODIES_F64_MAX_ENTRY && fabs(g_e_11) <= TWO_BODIES_F64_MAX_REACH
            && fabs(g_e_16) <= TWO_BODIES_F64_MAX_ENTRY && fabs(g_e_17) <= TWO_BODIES_F64_MAX_ENTRY
            && fabs(g_e_18) <= TWO_BODIES_F64_MAX_ENTRY && fabs(g_e_19) <= TWO_BODIES_F64_MAX_ENTRY
            && fabs(g_e_20) <= TWO_BODIES_F64_MAX_ENTRY && fabs(g_e_21) <= TWO_BODIES_F64_MAX_ENTRY
            && fabs(g_e_22) <= TWO_BODIES_F64_MAX_ENTRY && fabs(g_e_23) <= TWO_BODIES_F64_MAX_ENTRY
            && fabs(g_e_24) <= TWO_BODIES_F64_MAX_ENTRY
            && fabs(state->g[3]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(state->g[7]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(state->g[11]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(state->nu[0]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(state->nu[1]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(state->nu[2]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(state->nu[3]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(state->nu[4]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(state->nu[5]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(state->nu[6]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(state->nu[7]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(state->nu[8]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->g[3]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->g[7]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->g[11]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->nu[0]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->nu[1]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->nu[2]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->nu[3]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->nu[4]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->nu[5]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->nu[6]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->nu[7]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->nu[8]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->nu_dot[0]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->nu_dot[1]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->nu_dot[2]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->nu_dot[3]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->nu_dot[4]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->nu_dot[5]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->nu_dot[6]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->nu_dot[7]) <= TWO_BODIES_F64_MAX_INPUT
            && fabs(reference->nu_dot[8]) <= TWO_BODIES_F64_MAX_INPUT)) {
        if (fabs(g_e_3) <= TWO_BODIES_F64_MAX_REACH && fabs(g_e_7) <= TWO_BODIES_F64_MAX_REACH
                && fabs(g_e_11) <= TWO_BODIES_F64_MAX_REACH) {
            return two_bodies_f64_refuse(state, reference, TWO_BODIES_F64_NOT_ON_GROUP, command);
        }
        return two_bodies_f64_refuse(state, reference, TWO_BODIES_F64_OUT_OF_RANGE, command);
    }
    /* -- drift -- */
    const double g_12 = state->g[12], g_13 = state->g[13], g_14 = state->g[14], g_15 = state->g[15];
    const double g_r_12 = reference->g[12], g_r_13 = reference->g[13], g_r_14 = reference->g[14],
        g_r_15 = reference->g[15];

    /* off: what vanishes on the group, and only there [1] */
    const double off_0 = g_e_0*g_e_0 - 1.0 + g_e_4*g_e_4 + g_e_8*g_e_8;
    const double off_1 = g_e_0*g_e_1 + g_e_4*g_e_5 + g_e_8*g_e_9;
    const double off_2 = g_e_1*g_e_1 - 1.0 + g_e_5*g_e_5 + g_e_9*g_e_9;
    const double off_3 = g_e_2 + g_e_5*g_e_8 - g_e_4*g_e_9;
    const double off_4 = g_e_6 + g_e_0*g_e_9 - g_e_1*g_e_8;
    const double off_5 = g_e_10 + g_e_1*g_e_4 - g_e_0*g_e_5;
    const double off_6 = g_e_16*g_e_16 - 1.0 + g_e_19*g_e_19 + g_e_22*g_e_22;
    const double off_7 = g_e_16*g_e_17 + g_e_19*g_e_20 + g_e_22*g_e_23;
    const double off_8 = g_e_17*g_e_17 - 1.0 + g_e_20*g_e_20 + g_e_23*g_e_23;
    const double off_9 = g_e_18 + g_e_20*g_e_22 - g_e_19*g_e_23;
    const double off_10 = g_e_21 + g_e_16*g_e_23 - g_e_17*g_e_22;
    const double off_11 = g_e_24 + g_e_17*g_e_19 - g_e_16*g_e_20;
    const double off_15 = g_15 - 1.0;
    const double off_19 = g_r_15 - 1.0;

    /* drift: square of the distance from the group [1] */
    const double drift = g_12*g_12 + g_13*g_13 + g_14*g_14 + g_r_12*g_r_12 + g_r_13*g_r_13 +
        g_r_14*g_r_14 + off_0*off_0 + off_1*off_1 + off_10*off_10 + off_11*off_11 + off_15*off_15 +
        off_19*off_19 + off_2*off_2 + off_3*off_3 + off_4*off_4 + off_5*off_5 + off_6*off_6 +
        off_7*off_7 + off_8*off_8 + off_9*off_9;

    /* -- end -- */

    if (!(drift < params->max_drift*params->max_drift)) {
        return two_bodies_f64_refuse(state, reference, TWO_BODIES_F64_NOT_ON_GROUP, command);
    }
    clearance = two_bodies_f64_law(params, state, reference, command, g_e_0, g_e_1, g_e_2, g_e_3,
            g_e_4, g_e_5, g_e_6, g_e_7, g_e_8, g_e_9, g_e_10, g_e_11, g_e_16, g_e_17, g_e_18,
            g_e_19, g_e_20, g_e_21, g_e_22, g_e_23, g_e_24);
    return two_bodies_f64_verdict(clearance, command);
}

two_bodies_f64_status two_bodies_f64_check_params(const two_bodies_f64_params *params)
{
#ifdef TWO_BODIES_CHECK_POINTERS
    if (params == NULL) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
#endif
    double pivot[9];
    int i;
    if (two_bodies_f64_inspect(params->inertia, 45, TWO_BODIES_F64_MAX_PARAM) != TWO_BODIES_F64_OK)
            {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (!(params->lambda >= TWO_BODIES_F64_MIN_GAIN && params->lambda <= TWO_BODIES_F64_MAX_RATE)) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (!(params->k_s >= TWO_BODIES_F64_MIN_GAIN && params->k_s <= TWO_BODIES_F64_MAX_RATE)) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (!(params->max_drift >= TWO_BODIES_F64_LEAST_DRIFT && params->max_drift <=
            TWO_BODIES_F64_MOST_DRIFT)) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[1]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[3]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[5]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[6]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[7]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[8]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[10]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[12]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[13]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[14]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[15]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[16]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[18]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[19]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[20]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[21]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[22]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[23]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[25]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[26]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[27]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[28]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[29]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[31]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[32]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[33]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[34]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[36]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[37]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[38]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[40]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[41]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[43]) > 0.0) {
        return TWO_BODIES_F64_BAD_PARAMS;
    }
    two_bodies_f64_definiteness(params, pivot);
    for (i = 0; i < 9; i++) {
        if (!(pivot[i] > 0.0)) {
            return TWO_BODIES_F64_BAD_PARAMS;
        }
    }
    return TWO_BODIES_F64_OK;
}
