/*
 * freeflyer_f64: gsmc on SE3, law log (the logarithm), double precision.
 * Every step below carries its quantity, unit and equation; trace.csv lists them by line.
 */
#include "freeflyer_f64.h"

#include <math.h>

#ifdef FREEFLYER_CHECK_POINTERS /* that none is null: a precondition, which the self-test checks */
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

const freeflyer_f64_params freeflyer_f64_defaults = {
    {0.15334, 0.0046, -0.005, 0.0, -0.05, 0.03, 0.16625, 0.00185, 0.05, 0.0, 0.2, 0.14709, -0.03,
     -0.2, 0.0, 1.0e1, 0.0, 0.0, 1.0e1, 0.0, 1.0e1},
    0.1, /* lambda */
    0.4, /* k_s */
    {0.3, 0.3, 0.3, 1.5, 1.0, 1.0}, /* force_limit */
    1.0e-6 /* max_drift */
};

/* Kernel function k(w) on 0 <= w <= 1, a polynomial in 1 - w. */
static inline double freeflyer_f64_k(const double w)
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
static inline double freeflyer_f64_h(const double w)
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
static inline double freeflyer_f64_m(const double w)
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
static void freeflyer_f64_nothing(freeflyer_f64_command *command)
{
    command->force[0] = 0.0;
    command->force[1] = 0.0;
    command->force[2] = 0.0;
    command->force[3] = 0.0;
    command->force[4] = 0.0;
    command->force[5] = 0.0;
    command->s[0] = 0.0;
    command->s[1] = 0.0;
    command->s[2] = 0.0;
    command->s[3] = 0.0;
    command->s[4] = 0.0;
    command->s[5] = 0.0;
    command->nu_u[0] = 0.0;
    command->nu_u[1] = 0.0;
    command->nu_u[2] = 0.0;
    command->nu_u[3] = 0.0;
    command->nu_u[4] = 0.0;
    command->nu_u[5] = 0.0;
    command->nu_u_dot[0] = 0.0;
    command->nu_u_dot[1] = 0.0;
    command->nu_u_dot[2] = 0.0;
    command->nu_u_dot[3] = 0.0;
    command->nu_u_dot[4] = 0.0;
    command->nu_u_dot[5] = 0.0;
}

/* force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl), past the error. Gives its clearance, 0
   where the law jumps. */
static double freeflyer_f64_law(const freeflyer_f64_params *params,
        const freeflyer_f64_state *state, const freeflyer_f64_reference *reference,
        freeflyer_f64_command *command, const double g_e_0, const double g_e_1, const double g_e_2,
        const double g_e_3, const double g_e_4, const double g_e_5, const double g_e_6,
        const double g_e_7, const double g_e_8, const double g_e_9, const double g_e_10,
        const double g_e_11)
{
    /* -- tracking -- */
    const double inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_4 = params->inertia[4],
        inertia_5 = params->inertia[5], inertia_6 = params->inertia[6],
        inertia_7 = params->inertia[7], inertia_8 = params->inertia[8],
        inertia_10 = params->inertia[10], inertia_11 = params->inertia[11],
        inertia_12 = params->inertia[12], inertia_13 = params->inertia[13],
        inertia_15 = params->inertia[15], inertia_18 = params->inertia[18],
        inertia_20 = params->inertia[20];
    const double rate_gain = params->lambda;
    const double reach_gain = params->k_s;
    const double nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2], nu_3 = state->nu[3],
        nu_4 = state->nu[4], nu_5 = state->nu[5];
    const double nu_r_0 = reference->nu[0], nu_r_1 = reference->nu[1], nu_r_2 = reference->nu[2],
        nu_r_3 = reference->nu[3], nu_r_4 = reference->nu[4], nu_r_5 = reference->nu[5];
    const double nu_r_dot_0 = reference->nu_dot[0], nu_r_dot_1 = reference->nu_dot[1],
        nu_r_dot_2 = reference->nu_dot[2], nu_r_dot_3 = reference->nu_dot[3],
        nu_r_dot_4 = reference->nu_dot[4], nu_r_dot_5 = reference->nu_dot[5];

    /* eta_arm_0: velocity at p [m/s] */
    const double eta_arm_0_0 = nu_r_3 + g_e_11*nu_r_1 - g_e_7*nu_r_2;
    const double eta_arm_0_1 = nu_r_4 + g_e_3*nu_r_2 - g_e_11*nu_r_0;
    const double eta_arm_0_2 = nu_r_5 + g_e_7*nu_r_0 - g_e_3*nu_r_1;

    /* eta: reference velocity in the body frame [rad/s, m/s], eq. (velErr) */
    const double eta_0 = g_e_0*nu_r_0 + g_e_4*nu_r_1 + g_e_8*nu_r_2;
    const double eta_1 = g_e_1*nu_r_0 + g_e_5*nu_r_1 + g_e_9*nu_r_2;
    const double eta_2 = g_e_10*nu_r_2 + g_e_2*nu_r_0 + g_e_6*nu_r_1;
    const double eta_3 = eta_arm_0_0*g_e_0 + eta_arm_0_1*g_e_4 + eta_arm_0_2*g_e_8;
    const double eta_4 = eta_arm_0_0*g_e_1 + eta_arm_0_1*g_e_5 + eta_arm_0_2*g_e_9;
    const double eta_5 = eta_arm_0_0*g_e_2 + eta_arm_0_1*g_e_6 + eta_arm_0_2*g_e_10;

    /* nu_e: velocity error [rad/s, m/s], eq. (velErr) */
    const double nu_e_0 = nu_0 - eta_0;
    const double nu_e_1 = nu_1 - eta_1;
    const double nu_e_2 = nu_2 - eta_2;
    const double nu_e_3 = nu_3 - eta_3;
    const double nu_e_4 = nu_4 - eta_4;
    const double nu_e_5 = nu_5 - eta_5;

    /* eta_dot_arm_0: velocity at p [m/s] */
    const double eta_dot_arm_0_0 = nu_r_dot_3 + g_e_11*nu_r_dot_1 - g_e_7*nu_r_dot_2;
    const double eta_dot_arm_0_1 = nu_r_dot_4 + g_e_3*nu_r_dot_2 - g_e_11*nu_r_dot_0;
    const double eta_dot_arm_0_2 = nu_r_dot_5 + g_e_7*nu_r_dot_0 - g_e_3*nu_r_dot_1;

    /* eta_dot: exact rate of eta [rad/s^2, m/s^2] */
    const double eta_dot_0 = eta_1*nu_e_2 + g_e_0*nu_r_dot_0 + g_e_4*nu_r_dot_1 + g_e_8*nu_r_dot_2 -
        eta_2*nu_e_1;
    const double eta_dot_1 = eta_2*nu_e_0 + g_e_1*nu_r_dot_0 + g_e_5*nu_r_dot_1 + g_e_9*nu_r_dot_2 -
        eta_0*nu_e_2;
    const double eta_dot_2 = eta_0*nu_e_1 + g_e_10*nu_r_dot_2 + g_e_2*nu_r_dot_0 + g_e_6*nu_r_dot_1
        - eta_1*nu_e_0;
    const double eta_dot_3 = eta_1*nu_e_5 + eta_4*nu_e_2 + eta_dot_arm_0_0*g_e_0 +
        eta_dot_arm_0_1*g_e_4 + eta_dot_arm_0_2*g_e_8 - eta_2*nu_e_4 - eta_5*nu_e_1;
    const double eta_dot_4 = eta_2*nu_e_3 + eta_5*nu_e_0 + eta_dot_arm_0_0*g_e_1 +
        eta_dot_arm_0_1*g_e_5 + eta_dot_arm_0_2*g_e_9 - eta_0*nu_e_5 - eta_3*nu_e_2;
    const double eta_dot_5 = eta_0*nu_e_4 + eta_3*nu_e_1 + eta_dot_arm_0_0*g_e_2 +
        eta_dot_arm_0_1*g_e_6 + eta_dot_arm_0_2*g_e_10 - eta_1*nu_e_3 - eta_4*nu_e_0;

    /* pairs: what B's diagonal is made of [1] */
    const double pairs_0 = 1.0 + g_e_0;
    const double pairs_1 = 1.0 - g_e_0;
    const double pairs_2 = g_e_10 + g_e_5;
    const double pairs_3 = g_e_5 - g_e_10;

    /* B: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack */
    const double B_0 = pairs_0 - pairs_2;
    const double B_1 = g_e_1 + g_e_4;
    const double B_2 = g_e_2 + g_e_8;
    const double B_3 = g_e_9 - g_e_6;
    const double B_4 = pairs_1 + pairs_3;
    const double B_5 = g_e_6 + g_e_9;
    const double B_6 = g_e_2 - g_e_8;
    const double B_7 = pairs_1 - pairs_3;
    const double B_8 = g_e_4 - g_e_1;
    const double B_9 = pairs_0 + pairs_2;

    /* column: a column of B that cannot vanish [1] */
    double column_0, column_1, column_2, column_3;
    if (B_9 >= 1.0) {
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
    const double power_0 = B_0*column_0 + B_1*column_1 + B_2*column_2 + B_3*column_3;
    const double power_1 = B_1*column_0 + B_4*column_1 + B_5*column_2 + B_6*column_3;
    const double power_2 = B_2*column_0 + B_5*column_1 + B_7*column_2 + B_8*column_3;
    const double power_3 = B_3*column_0 + B_6*column_1 + B_8*column_2 + B_9*column_3;

    /* square: square of its vector part [1] */
    const double square = power_0*power_0 + power_1*power_1 + power_2*power_2;

    /* norm_square: its squared length [1] */
    const double norm_square = square + power_3*power_3;

    /* norm_bounded: the same: less is no element [1] */
    double norm_bounded;
    if (norm_square <= 49.0) {
        norm_bounded = 49.0;
    } else {
        norm_bounded = norm_square;
    }

    /* norm: its length [1] */
    const double norm = sqrt(norm_bounded);

    /* inverse_norm: to unit length [1] */
    const double inverse_norm = 1.0/norm;

    /* scale: to unit length, and to w >= 0: the shorter way round [1] */
    double scale;
    if (power_3 < 0.0) {
        scale = -inverse_norm;
    } else {
        scale = inverse_norm;
    }

    /* cosine: cos of half the error angle, rounded [1] */
    const double cosine = power_3*scale;

    /* w: cos of half the error angle [1] */
    double w;
    if (cosine >= 1.0) {
        w = 1.0;
    } else {
        w = cosine;
    }

    /* v: sin of half the error angle times its axis [1] */
    const double v_0 = power_0*scale;
    const double v_1 = power_1*scale;
    const double v_2 = power_2*scale;

    /* k: half angle over its sine [1] */
    const double k = freeflyer_f64_k(w);

    /* h: -dk/dw [1] */
    const double h = freeflyer_f64_h(w);

    /* phi: rotation vector of the error [rad] */
    const double phi_0 = 2.0*k*v_0;
    const double phi_1 = 2.0*k*v_1;
    const double phi_2 = 2.0*k*v_2;

    /* half: 1/(2 k) [1] */
    const double half = 0.5/k;

    /* swing_p: Y p [m] */
    const double swing_p_0 = g_e_11*v_1 - g_e_7*v_2;
    const double swing_p_1 = g_e_3*v_2 - g_e_11*v_0;
    const double swing_p_2 = g_e_7*v_0 - g_e_3*v_1;

    /* sway_p: Y Y p [m] */
    const double sway_p_0 = swing_p_2*v_1 - swing_p_1*v_2;
    const double sway_p_1 = swing_p_0*v_2 - swing_p_2*v_0;
    const double sway_p_2 = swing_p_1*v_0 - swing_p_0*v_1;

    /* rho_p: p - k Y p + h Y Y p [m] */
    const double rho_p_0 = g_e_3 + h*sway_p_0 - k*swing_p_0;
    const double rho_p_1 = g_e_7 + h*sway_p_1 - k*swing_p_1;
    const double rho_p_2 = g_e_11 + h*sway_p_2 - k*swing_p_2;

    /* y_p: rho/(2 k) [m] */
    const double y_p_0 = half*rho_p_0;
    const double y_p_1 = half*rho_p_1;
    const double y_p_2 = half*rho_p_2;

    /* turn: Y nu_e, Y = ad of y [rad/s, m/s] */
    const double turn_0 = nu_e_2*v_1 - nu_e_1*v_2;
    const double turn_1 = nu_e_0*v_2 - nu_e_2*v_0;
    const double turn_2 = nu_e_1*v_0 - nu_e_0*v_1;
    const double turn_3 = nu_e_2*y_p_1 + nu_e_5*v_1 - nu_e_1*y_p_2 - nu_e_4*v_2;
    const double turn_4 = nu_e_0*y_p_2 + nu_e_3*v_2 - nu_e_2*y_p_0 - nu_e_5*v_0;
    const double turn_5 = nu_e_1*y_p_0 + nu_e_4*v_0 - nu_e_0*y_p_1 - nu_e_3*v_1;

    /* bend: Y Y nu_e [rad/s, m/s] */
    const double bend_0 = turn_2*v_1 - turn_1*v_2;
    const double bend_1 = turn_0*v_2 - turn_2*v_0;
    const double bend_2 = turn_1*v_0 - turn_0*v_1;
    const double bend_3 = turn_2*y_p_1 + turn_5*v_1 - turn_1*y_p_2 - turn_4*v_2;
    const double bend_4 = turn_0*y_p_2 + turn_3*v_2 - turn_2*y_p_0 - turn_5*v_0;
    const double bend_5 = turn_1*y_p_0 + turn_4*v_0 - turn_0*y_p_1 - turn_3*v_1;

    /* m: -dh/dw [1] */
    const double m = freeflyer_f64_m(w);

    /* along_p: -2 v.q [m] */
    const double along_p = -2.0*(v_0*y_p_0 + v_1*y_p_1 + v_2*y_p_2);

    /* tail: (Y^2 + s^2) Y^2 nu_e [rad/s, m/s] */
    const double tail_3 = along_p*bend_0;
    const double tail_4 = along_p*bend_1;
    const double tail_5 = along_p*bend_2;

    /* twofold: h^2 - k m/2, of the double root [1] */
    const double twofold = h*h - 0.5*k*m;

    /* nu_u_dot: exact rate of nu_u [rad/s, m/s] */
    const double nu_u_dot_0 = nu_e_0 + bend_0*h + k*turn_0;
    const double nu_u_dot_1 = nu_e_1 + bend_1*h + k*turn_1;
    const double nu_u_dot_2 = nu_e_2 + bend_2*h + k*turn_2;
    const double nu_u_dot_3 = nu_e_3 + bend_3*h + k*turn_3 + tail_3*twofold;
    const double nu_u_dot_4 = nu_e_4 + bend_4*h + k*turn_4 + tail_4*twofold;
    const double nu_u_dot_5 = nu_e_5 + bend_5*h + k*turn_5 + tail_5*twofold;

    /* drive: lambda nu_u [rad/s, m/s] */
    const double drive_0 = phi_0*rate_gain;
    const double drive_1 = phi_1*rate_gain;
    const double drive_2 = phi_2*rate_gain;
    const double drive_3 = rate_gain*rho_p_0;
    const double drive_4 = rate_gain*rho_p_1;
    const double drive_5 = rate_gain*rho_p_2;

    /* s: sliding variable [rad/s, m/s], eq. (SurfaceErr) */
    const double s_0 = drive_0 + nu_e_0;
    const double s_1 = drive_1 + nu_e_1;
    const double s_2 = drive_2 + nu_e_2;
    const double s_3 = drive_3 + nu_e_3;
    const double s_4 = drive_4 + nu_e_4;
    const double s_5 = drive_5 + nu_e_5;

    /* wanted: acceleration asked for [rad/s^2, m/s^2] */
    const double wanted_0 = eta_dot_0 - nu_u_dot_0*rate_gain - reach_gain*s_0;
    const double wanted_1 = eta_dot_1 - nu_u_dot_1*rate_gain - reach_gain*s_1;
    const double wanted_2 = eta_dot_2 - nu_u_dot_2*rate_gain - reach_gain*s_2;
    const double wanted_3 = eta_dot_3 - nu_u_dot_3*rate_gain - reach_gain*s_3;
    const double wanted_4 = eta_dot_4 - nu_u_dot_4*rate_gain - reach_gain*s_4;
    const double wanted_5 = eta_dot_5 - nu_u_dot_5*rate_gain - reach_gain*s_5;

    /* turning: lambda nu_u - eta [rad/s, m/s] */
    const double turning_0 = drive_0 - eta_0;
    const double turning_1 = drive_1 - eta_1;
    const double turning_2 = drive_2 - eta_2;
    const double turning_3 = drive_3 - eta_3;
    const double turning_4 = drive_4 - eta_4;
    const double turning_5 = drive_5 - eta_5;

    /* momentum: I nu [N m s, N s] */
    const double momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2 + inertia_4*nu_4 +
        inertia_5*nu_5;
    const double momentum_1 = inertia_1*nu_0 + inertia_10*nu_5 + inertia_6*nu_1 + inertia_7*nu_2 +
        inertia_8*nu_3;
    const double momentum_2 = inertia_11*nu_2 + inertia_12*nu_3 + inertia_13*nu_4 + inertia_2*nu_0 +
        inertia_7*nu_1;
    const double momentum_3 = inertia_12*nu_2 + inertia_15*nu_3 + inertia_8*nu_1;
    const double momentum_4 = inertia_13*nu_2 + inertia_18*nu_4 + inertia_4*nu_0;
    const double momentum_5 = inertia_10*nu_1 + inertia_20*nu_5 + inertia_5*nu_0;

    /* force: control force, I f_u [N m, N], eq. (TckCtrl) */
    const double force_0 = inertia_0*wanted_0 + inertia_1*wanted_1 + inertia_2*wanted_2 +
        inertia_4*wanted_4 + inertia_5*wanted_5 + momentum_1*turning_2 + momentum_4*turning_5 -
        momentum_2*turning_1 - momentum_5*turning_4;
    const double force_1 = inertia_1*wanted_0 + inertia_10*wanted_5 + inertia_6*wanted_1 +
        inertia_7*wanted_2 + inertia_8*wanted_3 + momentum_2*turning_0 + momentum_5*turning_3 -
        momentum_0*turning_2 - momentum_3*turning_5;
    const double force_2 = inertia_11*wanted_2 + inertia_12*wanted_3 + inertia_13*wanted_4 +
        inertia_2*wanted_0 + inertia_7*wanted_1 + momentum_0*turning_1 + momentum_3*turning_4 -
        momentum_1*turning_0 - momentum_4*turning_3;
    const double force_3 = inertia_12*wanted_2 + inertia_15*wanted_3 + inertia_8*wanted_1 +
        momentum_4*turning_2 - momentum_5*turning_1;
    const double force_4 = inertia_13*wanted_2 + inertia_18*wanted_4 + inertia_4*wanted_0 +
        momentum_5*turning_0 - momentum_3*turning_2;
    const double force_5 = inertia_10*wanted_1 + inertia_20*wanted_5 + inertia_5*wanted_0 +
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
static void freeflyer_f64_definiteness(const freeflyer_f64_params *params, double pivot[6])
{
    /* -- definiteness -- */
    const double inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_4 = params->inertia[4],
        inertia_5 = params->inertia[5], inertia_6 = params->inertia[6],
        inertia_7 = params->inertia[7], inertia_8 = params->inertia[8],
        inertia_10 = params->inertia[10], inertia_11 = params->inertia[11],
        inertia_12 = params->inertia[12], inertia_13 = params->inertia[13],
        inertia_15 = params->inertia[15], inertia_18 = params->inertia[18],
        inertia_20 = params->inertia[20];

    /* divisor_0: the pivot, or 1 where it is not positive [kg m^2, kg m, kg] */
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

    /* lower_40: I = L D L^T, entry of L [1] */
    const double lower_40 = inertia_4/divisor_0;

    /* lower_50: I = L D L^T, entry of L [1] */
    const double lower_50 = inertia_5/divisor_0;

    /* pivot_1: pivot of I [kg m^2, kg m, kg] */
    const double pivot_1 = inertia_6 - inertia_0*lower_10*lower_10;

    /* divisor_1: the pivot, or 1 where it is not positive [kg m^2, kg m, kg] */
    double divisor_1;
    if (pivot_1 > 0.0) {
        divisor_1 = pivot_1;
    } else {
        divisor_1 = 1.0;
    }

    /* lower_21: I = L D L^T, entry of L [1] */
    const double lower_21 = (inertia_7 - inertia_0*lower_10*lower_20)/divisor_1;

    /* lower_31: I = L D L^T, entry of L [1] */
    const double lower_31 = inertia_8/divisor_1;

    /* lower_41: I = L D L^T, entry of L [1] */
    const double lower_41 = -inertia_0*lower_10*lower_40/divisor_1;

    /* lower_51: I = L D L^T, entry of L [1] */
    const double lower_51 = (inertia_10 - inertia_0*lower_10*lower_50)/divisor_1;

    /* pivot_2: pivot of I [kg m^2, kg m, kg] */
    const double pivot_2 = inertia_11 - inertia_0*lower_20*lower_20 - pivot_1*lower_21*lower_21;

    /* divisor_2: the pivot, or 1 where it is not positive [kg m^2, kg m, kg] */
    double divisor_2;
    if (pivot_2 > 0.0) {
        divisor_2 = pivot_2;
    } else {
        divisor_2 = 1.0;
    }

    /* lower_32: I = L D L^T, entry of L [1] */
    const double lower_32 = (inertia_12 - lower_21*lower_31*pivot_1)/divisor_2;

    /* lower_42: I = L D L^T, entry of L [1] */
    const double lower_42 = (inertia_13 - inertia_0*lower_20*lower_40 -
        lower_21*lower_41*pivot_1)/divisor_2;

    /* lower_52: I = L D L^T, entry of L [1] */
    const double lower_52 = (-(inertia_0*lower_20*lower_50 + lower_21*lower_51*pivot_1))/divisor_2;

    /* pivot_3: pivot of I [kg m^2, kg m, kg] */
    const double pivot_3 = inertia_15 - pivot_1*lower_31*lower_31 - pivot_2*lower_32*lower_32;

    /* divisor_3: the pivot, or 1 where it is not positive [kg m^2, kg m, kg] */
    double divisor_3;
    if (pivot_3 > 0.0) {
        divisor_3 = pivot_3;
    } else {
        divisor_3 = 1.0;
    }

    /* lower_43: I = L D L^T, entry of L [1] */
    const double lower_43 = (-(lower_31*lower_41*pivot_1 + lower_32*lower_42*pivot_2))/divisor_3;

    /* lower_53: I = L D L^T, entry of L [1] */
    const double lower_53 = (-(lower_31*lower_51*pivot_1 + lower_32*lower_52*pivot_2))/divisor_3;

    /* pivot_4: pivot of I [kg m^2, kg m, kg] */
    const double pivot_4 = inertia_18 - inertia_0*lower_40*lower_40 - pivot_1*lower_41*lower_41 -
        pivot_2*lower_42*lower_42 - pivot_3*lower_43*lower_43;

    /* divisor_4: the pivot, or 1 where it is not positive [kg m^2, kg m, kg] */
    double divisor_4;
    if (pivot_4 > 0.0) {
        divisor_4 = pivot_4;
    } else {
        divisor_4 = 1.0;
    }

    /* lower_54: I = L D L^T, entry of L [1] */
    const double lower_54 = (-(inertia_0*lower_40*lower_50 + lower_41*lower_51*pivot_1 +
        lower_42*lower_52*pivot_2 + lower_43*lower_53*pivot_3))/divisor_4;

    /* pivot_5: pivot of I [kg m^2, kg m, kg] */
    const double pivot_5 = inertia_20 - inertia_0*lower_50*lower_50 - pivot_1*lower_51*lower_51 -
        pivot_2*lower_52*lower_52 - pivot_3*lower_53*lower_53 - pivot_4*lower_54*lower_54;

    /* -- end -- */
    pivot[0] = inertia_0;
    pivot[1] = pivot_1;
    pivot[2] = pivot_2;
    pivot[3] = pivot_3;
    pivot[4] = pivot_4;
    pivot[5] = pivot_5;
}

void freeflyer_f64_tracking(const freeflyer_f64_params *params, const freeflyer_f64_state *state,
        const freeflyer_f64_reference *reference, freeflyer_f64_command *command)
{
    /* -- tracking -- */
    const double g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5], g_6 = state->g[6], g_7 = state->g[7],
        g_8 = state->g[8], g_9 = state->g[9], g_10 = state->g[10], g_11 = state->g[11];
    const double g_r_0 = reference->g[0], g_r_1 = reference->g[1], g_r_2 = reference->g[2],
        g_r_3 = reference->g[3], g_r_4 = reference->g[4], g_r_5 = reference->g[5],
        g_r_6 = reference->g[6], g_r_7 = reference->g[7], g_r_8 = reference->g[8],
        g_r_9 = reference->g[9], g_r_10 = reference->g[10], g_r_11 = reference->g[11];

    /* gap_0: translation of g from g_r [m] */
    const double gap_0_0 = g_3 - g_r_3;
    const double gap_0_1 = g_7 - g_r_7;
    const double gap_0_2 = g_11 - g_r_11;

    /* g_e: error, g_r^-1 g [1], eq. (velErr) */
    const double g_e_0 = g_0*g_r_0 + g_4*g_r_4 + g_8*g_r_8;
    const double g_e_1 = g_1*g_r_0 + g_5*g_r_4 + g_9*g_r_8;
    const double g_e_2 = g_10*g_r_8 + g_2*g_r_0 + g_6*g_r_4;
    const double g_e_3 = g_r_0*gap_0_0 + g_r_4*gap_0_1 + g_r_8*gap_0_2;
    const double g_e_4 = g_0*g_r_1 + g_4*g_r_5 + g_8*g_r_9;
    const double g_e_5 = g_1*g_r_1 + g_5*g_r_5 + g_9*g_r_9;
    const double g_e_6 = g_10*g_r_9 + g_2*g_r_1 + g_6*g_r_5;
    const double g_e_7 = g_r_1*gap_0_0 + g_r_5*gap_0_1 + g_r_9*gap_0_2;
    const double g_e_8 = g_0*g_r_2 + g_4*g_r_6 + g_8*g_r_10;
    const double g_e_9 = g_1*g_r_2 + g_5*g_r_6 + g_9*g_r_10;
    const double g_e_10 = g_10*g_r_10 + g_2*g_r_2 + g_6*g_r_6;
    const double g_e_11 = g_r_10*gap_0_2 + g_r_2*gap_0_0 + g_r_6*gap_0_1;

    /* -- end -- */
    (void)freeflyer_f64_law(params, state, reference, command, g_e_0, g_e_1, g_e_2, g_e_3, g_e_4,
            g_e_5, g_e_6, g_e_7, g_e_8, g_e_9, g_e_10, g_e_11);
}

void freeflyer_f64_reaching(const freeflyer_f64_params *params, const freeflyer_f64_state *state,
        freeflyer_f64_command *command)
{
    /* -- reaching -- */
    const double inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_4 = params->inertia[4],
        inertia_5 = params->inertia[5], inertia_6 = params->inertia[6],
        inertia_7 = params->inertia[7], inertia_8 = params->inertia[8],
        inertia_10 = params->inertia[10], inertia_11 = params->inertia[11],
        inertia_12 = params->inertia[12], inertia_13 = params->inertia[13],
        inertia_15 = params->inertia[15], inertia_18 = params->inertia[18],
        inertia_20 = params->inertia[20];
    const double rate_gain = params->lambda;
    const double reach_gain = params->k_s;
    const double g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5], g_6 = state->g[6], g_7 = state->g[7],
        g_8 = state->g[8], g_9 = state->g[9], g_10 = state->g[10], g_11 = state->g[11];
    const double nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2], nu_3 = state->nu[3],
        nu_4 = state->nu[4], nu_5 = state->nu[5];

    /* pairs: what B's diagonal is made of [1] */
    const double pairs_0 = 1.0 + g_0;
    const double pairs_1 = 1.0 - g_0;
    const double pairs_2 = g_10 + g_5;
    const double pairs_3 = g_5 - g_10;

    /* B: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack */
    const double B_0 = pairs_0 - pairs_2;
    const double B_1 = g_1 + g_4;
    const double B_2 = g_2 + g_8;
    const double B_3 = g_9 - g_6;
    const double B_4 = pairs_1 + pairs_3;
    const double B_5 = g_6 + g_9;
    const double B_6 = g_2 - g_8;
    const double B_7 = pairs_1 - pairs_3;
    const double B_8 = g_4 - g_1;
    const double B_9 = pairs_0 + pairs_2;

    /* column: a column of B that cannot vanish [1] */
    double column_0, column_1, column_2, column_3;
    if (B_9 >= 1.0) {
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
    const double power_0 = B_0*column_0 + B_1*column_1 + B_2*column_2 + B_3*column_3;
    const double power_1 = B_1*column_0 + B_4*column_1 + B_5*column_2 + B_6*column_3;
    const double power_2 = B_2*column_0 + B_5*column_1 + B_7*column_2 + B_8*column_3;
    const double power_3 = B_3*column_0 + B_6*column_1 + B_8*column_2 + B_9*column_3;

    /* square: square of its vector part [1] */
    const double square = power_0*power_0 + power_1*power_1 + power_2*power_2;

    /* norm_square: its squared length [1] */
    const double norm_square = square + power_3*power_3;

    /* norm_bounded: the same: less is no element [1] */
    double norm_bounded;
    if (norm_square <= 49.0) {
        norm_bounded = 49.0;
    } else {
        norm_bounded = norm_square;
    }

    /* norm: its length [1] */
    const double norm = sqrt(norm_bounded);

    /* inverse_norm: to unit length [1] */
    const double inverse_norm = 1.0/norm;

    /* scale: to unit length, and to w >= 0: the shorter way round [1] */
    double scale;
    if (power_3 < 0.0) {
        scale = -inverse_norm;
    } else {
        scale = inverse_norm;
    }

    /* cosine: cos of half the error angle, rounded [1] */
    const double cosine = power_3*scale;

    /* w: cos of half the error angle [1] */
    double w;
    if (cosine >= 1.0) {
        w = 1.0;
    } else {
        w = cosine;
    }

    /* v: sin of half the error angle times its axis [1] */
    const double v_0 = power_0*scale;
    const double v_1 = power_1*scale;
    const double v_2 = power_2*scale;

    /* k: half angle over its sine [1] */
    const double k = freeflyer_f64_k(w);

    /* h: -dk/dw [1] */
    const double h = freeflyer_f64_h(w);

    /* phi: rotation vector of the error [rad] */
    const double phi_0 = 2.0*k*v_0;
    const double phi_1 = 2.0*k*v_1;
    const double phi_2 = 2.0*k*v_2;

    /* half: 1/(2 k) [1] */
    const double half = 0.5/k;

    /* swing_p: Y p [m] */
    const double swing_p_0 = g_11*v_1 - g_7*v_2;
    const double swing_p_1 = g_3*v_2 - g_11*v_0;
    const double swing_p_2 = g_7*v_0 - g_3*v_1;

    /* sway_p: Y Y p [m] */
    const double sway_p_0 = swing_p_2*v_1 - swing_p_1*v_2;
    const double sway_p_1 = swing_p_0*v_2 - swing_p_2*v_0;
    const double sway_p_2 = swing_p_1*v_0 - swing_p_0*v_1;

    /* rho_p: p - k Y p + h Y Y p [m] */
    const double rho_p_0 = g_3 + h*sway_p_0 - k*swing_p_0;
    const double rho_p_1 = g_7 + h*sway_p_1 - k*swing_p_1;
    const double rho_p_2 = g_11 + h*sway_p_2 - k*swing_p_2;

    /* y_p: rho/(2 k) [m] */
    const double y_p_0 = half*rho_p_0;
    const double y_p_1 = half*rho_p_1;
    const double y_p_2 = half*rho_p_2;

    /* turn: Y nu_e, Y = ad of y [rad/s, m/s] */
    const double turn_0 = nu_2*v_1 - nu_1*v_2;
    const double turn_1 = nu_0*v_2 - nu_2*v_0;
    const double turn_2 = nu_1*v_0 - nu_0*v_1;
    const double turn_3 = nu_2*y_p_1 + nu_5*v_1 - nu_1*y_p_2 - nu_4*v_2;
    const double turn_4 = nu_0*y_p_2 + nu_3*v_2 - nu_2*y_p_0 - nu_5*v_0;
    const double turn_5 = nu_1*y_p_0 + nu_4*v_0 - nu_0*y_p_1 - nu_3*v_1;

    /* bend: Y Y nu_e [rad/s, m/s] */
    const double bend_0 = turn_2*v_1 - turn_1*v_2;
    const double bend_1 = turn_0*v_2 - turn_2*v_0;
    const double bend_2 = turn_1*v_0 - turn_0*v_1;
    const double bend_3 = turn_2*y_p_1 + turn_5*v_1 - turn_1*y_p_2 - turn_4*v_2;
    const double bend_4 = turn_0*y_p_2 + turn_3*v_2 - turn_2*y_p_0 - turn_5*v_0;
    const double bend_5 = turn_1*y_p_0 + turn_4*v_0 - turn_0*y_p_1 - turn_3*v_1;

    /* m: -dh/dw [1] */
    const double m = freeflyer_f64_m(w);

    /* along_p: -2 v.q [m] */
    const double along_p = -2.0*(v_0*y_p_0 + v_1*y_p_1 + v_2*y_p_2);

    /* tail: (Y^2 + s^2) Y^2 nu_e [rad/s, m/s] */
    const double tail_3 = along_p*bend_0;
    const double tail_4 = along_p*bend_1;
    const double tail_5 = along_p*bend_2;

    /* twofold: h^2 - k m/2, of the double root [1] */
    const double twofold = h*h - 0.5*k*m;

    /* nu_u_dot: exact rate of nu_u [rad/s, m/s] */
    const double nu_u_dot_0 = nu_0 + bend_0*h + k*turn_0;
    const double nu_u_dot_1 = nu_1 + bend_1*h + k*turn_1;
    const double nu_u_dot_2 = nu_2 + bend_2*h + k*turn_2;
    const double nu_u_dot_3 = nu_3 + bend_3*h + k*turn_3 + tail_3*twofold;
    const double nu_u_dot_4 = nu_4 + bend_4*h + k*turn_4 + tail_4*twofold;
    const double nu_u_dot_5 = nu_5 + bend_5*h + k*turn_5 + tail_5*twofold;

    /* drive: lambda nu_u [rad/s, m/s] */
    const double drive_0 = phi_0*rate_gain;
    const double drive_1 = phi_1*rate_gain;
    const double drive_2 = phi_2*rate_gain;
    const double drive_3 = rate_gain*rho_p_0;
    const double drive_4 = rate_gain*rho_p_1;
    const double drive_5 = rate_gain*rho_p_2;

    /* s: sliding variable [rad/s, m/s], eq. (sldS) */
    const double s_0 = drive_0 + nu_0;
    const double s_1 = drive_1 + nu_1;
    const double s_2 = drive_2 + nu_2;
    const double s_3 = drive_3 + nu_3;
    const double s_4 = drive_4 + nu_4;
    const double s_5 = drive_5 + nu_5;

    /* wanted: acceleration asked for [rad/s^2, m/s^2] */
    const double wanted_0 = -(nu_u_dot_0*rate_gain + reach_gain*s_0);
    const double wanted_1 = -(nu_u_dot_1*rate_gain + reach_gain*s_1);
    const double wanted_2 = -(nu_u_dot_2*rate_gain + reach_gain*s_2);
    const double wanted_3 = -(nu_u_dot_3*rate_gain + reach_gain*s_3);
    const double wanted_4 = -(nu_u_dot_4*rate_gain + reach_gain*s_4);
    const double wanted_5 = -(nu_u_dot_5*rate_gain + reach_gain*s_5);

    /* momentum: I nu [N m s, N s] */
    const double momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2 + inertia_4*nu_4 +
        inertia_5*nu_5;
    const double momentum_1 = inertia_1*nu_0 + inertia_10*nu_5 + inertia_6*nu_1 + inertia_7*nu_2 +
        inertia_8*nu_3;
    const double momentum_2 = inertia_11*nu_2 + inertia_12*nu_3 + inertia_13*nu_4 + inertia_2*nu_0 +
        inertia_7*nu_1;
    const double momentum_3 = inertia_12*nu_2 + inertia_15*nu_3 + inertia_8*nu_1;
    const double momentum_4 = inertia_13*nu_2 + inertia_18*nu_4 + inertia_4*nu_0;
    const double momentum_5 = inertia_10*nu_1 + inertia_20*nu_5 + inertia_5*nu_0;

    /* force: control force, I f_u [N m, N], eq. (Ctrl2) */
    const double force_0 = drive_2*momentum_1 + drive_5*momentum_4 + inertia_0*wanted_0 +
        inertia_1*wanted_1 + inertia_2*wanted_2 + inertia_4*wanted_4 + inertia_5*wanted_5 -
        drive_1*momentum_2 - drive_4*momentum_5;
    const double force_1 = drive_0*momentum_2 + drive_3*momentum_5 + inertia_1*wanted_0 +
        inertia_10*wanted_5 + inertia_6*wanted_1 + inertia_7*wanted_2 + inertia_8*wanted_3 -
        drive_2*momentum_0 - drive_5*momentum_3;
    const double force_2 = drive_1*momentum_0 + drive_4*momentum_3 + inertia_11*wanted_2 +
        inertia_12*wanted_3 + inertia_13*wanted_4 + inertia_2*wanted_0 + inertia_7*wanted_1 -
        drive_0*momentum_1 - drive_3*momentum_4;
    const double force_3 = drive_2*momentum_4 + inertia_12*wanted_2 + inertia_15*wanted_3 +
        inertia_8*wanted_1 - drive_1*momentum_5;
    const double force_4 = drive_0*momentum_5 + inertia_13*wanted_2 + inertia_18*wanted_4 +
        inertia_4*wanted_0 - drive_2*momentum_3;
    const double force_5 = drive_1*momentum_3 + inertia_10*wanted_1 + inertia_20*wanted_5 +
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

void freeflyer_f64_plant(const freeflyer_f64_params *params, const freeflyer_f64_state *state,
        const double force[6], double nu_dot[6])
{
    /* -- plant -- */
    const double inertia_0 = params->inertia[0], inertia_1 = params->inertia[1],
        inertia_2 = params->inertia[2], inertia_4 = params->inertia[4],
        inertia_5 = params->inertia[5], inertia_6 = params->inertia[6],
        inertia_7 = params->inertia[7], inertia_8 = params->inertia[8],
        inertia_10 = params->inertia[10], inertia_11 = params->inertia[11],
        inertia_12 = params->inertia[12], inertia_13 = params->inertia[13],
        inertia_15 = params->inertia[15], inertia_18 = params->inertia[18],
        inertia_20 = params->inertia[20];
    const double nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2], nu_3 = state->nu[3],
        nu_4 = state->nu[4], nu_5 = state->nu[5];
    const double force_0 = force[0], force_1 = force[1], force_2 = force[2], force_3 = force[3],
        force_4 = force[4], force_5 = force[5];

    /* momentum: I nu [N m s, N s] */
    const double momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2 + inertia_4*nu_4 +
        inertia_5*nu_5;
    const double momentum_1 = inertia_1*nu_0 + inertia_10*nu_5 + inertia_6*nu_1 + inertia_7*nu_2 +
        inertia_8*nu_3;
    const double momentum_2 = inertia_11*nu_2 + inertia_12*nu_3 + inertia_13*nu_4 + inertia_2*nu_0 +
        inertia_7*nu_1;
    const double momentum_3 = inertia_12*nu_2 + inertia_15*nu_3 + inertia_8*nu_1;
    const double momentum_4 = inertia_13*nu_2 + inertia_18*nu_4 + inertia_4*nu_0;
    const double momentum_5 = inertia_10*nu_1 + inertia_20*nu_5 + inertia_5*nu_0;

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

    /* lower_10: I = L D L^T, entry of L [1] */
    const double lower_10 = inertia_1/inertia_0;

    /* lower_20: I = L D L^T, entry of L [1] */
    const double lower_20 = inertia_2/inertia_0;

    /* lower_40: I = L D L^T, entry of L [1] */
    const double lower_40 = inertia_4/inertia_0;

    /* lower_50: I = L D L^T, entry of L [1] */
    const double lower_50 = inertia_5/inertia_0;

    /* pivot_1: pivot of I [kg m^2, kg m, kg] */
    const double pivot_1 = inertia_6 - inertia_0*lower_10*lower_10;

    /* lower_21: I = L D L^T, entry of L [1] */
    const double lower_21 = (inertia_7 - inertia_0*lower_10*lower_20)/pivot_1;

    /* lower_31: I = L D L^T, entry of L [1] */
    const double lower_31 = inertia_8/pivot_1;

    /* lower_41: I = L D L^T, entry of L [1] */
    const double lower_41 = -inertia_0*lower_10*lower_40/pivot_1;

    /* lower_51: I = L D L^T, entry of L [1] */
    const double lower_51 = (inertia_10 - inertia_0*lower_10*lower_50)/pivot_1;

    /* pivot_2: pivot of I [kg m^2, kg m, kg] */
    const double pivot_2 = inertia_11 - inertia_0*lower_20*lower_20 - pivot_1*lower_21*lower_21;

    /* lower_32: I = L D L^T, entry of L [1] */
    const double lower_32 = (inertia_12 - lower_21*lower_31*pivot_1)/pivot_2;

    /* lower_42: I = L D L^T, entry of L [1] */
    const double lower_42 = (inertia_13 - inertia_0*lower_20*lower_40 -
        lower_21*lower_41*pivot_1)/pivot_2;

    /* lower_52: I = L D L^T, entry of L [1] */
    const double lower_52 = (-(inertia_0*lower_20*lower_50 + lower_21*lower_51*pivot_1))/pivot_2;

    /* pivot_3: pivot of I [kg m^2, kg m, kg] */
    const double pivot_3 = inertia_15 - pivot_1*lower_31*lower_31 - pivot_2*lower_32*lower_32;

    /* lower_43: I = L D L^T, entry of L [1] */
    const double lower_43 = (-(lower_31*lower_41*pivot_1 + lower_32*lower_42*pivot_2))/pivot_3;

    /* lower_53: I = L D L^T, entry of L [1] */
    const double lower_53 = (-(lower_31*lower_51*pivot_1 + lower_32*lower_52*pivot_2))/pivot_3;

    /* pivot_4: pivot of I [kg m^2, kg m, kg] */
    const double pivot_4 = inertia_18 - inertia_0*lower_40*lower_40 - pivot_1*lower_41*lower_41 -
        pivot_2*lower_42*lower_42 - pivot_3*lower_43*lower_43;

    /* lower_54: I = L D L^T, entry of L [1] */
    const double lower_54 = (-(inertia_0*lower_40*lower_50 + lower_41*lower_51*pivot_1 +
        lower_42*lower_52*pivot_2 + lower_43*lower_53*pivot_3))/pivot_4;

    /* pivot_5: pivot of I [kg m^2, kg m, kg] */
    const double pivot_5 = inertia_20 - inertia_0*lower_50*lower_50 - pivot_1*lower_51*lower_51 -
        pivot_2*lower_52*lower_52 - pivot_3*lower_53*lower_53 - pivot_4*lower_54*lower_54;

    /* forward_1: forward substitution [N m, N] */
    const double forward_1 = total_1 - lower_10*total_0;

    /* forward_2: forward substitution [N m, N] */
    const double forward_2 = total_2 - forward_1*lower_21 - lower_20*total_0;

    /* forward_3: forward substitution [N m, N] */
    const double forward_3 = total_3 - forward_1*lower_31 - forward_2*lower_32;

    /* forward_4: forward substitution [N m, N] */
    const double forward_4 = total_4 - forward_1*lower_41 - forward_2*lower_42 - forward_3*lower_43
        - lower_40*total_0;

    /* forward_5: forward substitution [N m, N] */
    const double forward_5 = total_5 - forward_1*lower_51 - forward_2*lower_52 - forward_3*lower_53
        - forward_4*lower_54 - lower_50*total_0;

    /* back_5: back substitution [rad/s^2, m/s^2] */
    const double back_5 = forward_5/pivot_5;

    /* back_4: back substitution [rad/s^2, m/s^2] */
    const double back_4 = forward_4/pivot_4 - back_5*lower_54;

    /* back_3: back substitution [rad/s^2, m/s^2] */
    const double back_3 = forward_3/pivot_3 - back_4*lower_43 - back_5*lower_53;

    /* back_2: back substitution [rad/s^2, m/s^2] */
    const double back_2 = forward_2/pivot_2 - back_3*lower_32 - back_4*lower_42 - back_5*lower_52;

    /* back_1: back substitution [rad/s^2, m/s^2] */
    const double back_1 = forward_1/pivot_1 - back_2*lower_21 - back_3*lower_31 - back_4*lower_41 -
        back_5*lower_51;

    /* back_0: back substitution [rad/s^2, m/s^2] */
    const double back_0 = total_0/inertia_0 - back_1*lower_10 - back_2*lower_20 - back_4*lower_40 -
        back_5*lower_50;

    /* -- end -- */
    nu_dot[0] = back_0;
    nu_dot[1] = back_1;
    nu_dot[2] = back_2;
    nu_dot[3] = back_3;
    nu_dot[4] = back_4;
    nu_dot[5] = back_5;
}

/* The worse of two findings. */
static freeflyer_f64_status freeflyer_f64_worse(const freeflyer_f64_status a,
        const freeflyer_f64_status b)
{
    return a > b ? a : b;
}

/* OUT_OF_RANGE or NONFINITE_INPUT if any number is larger than a limit or not finite. */
static freeflyer_f64_status freeflyer_f64_inspect(const double *numbers, const int count,
        const double limit)
{
    freeflyer_f64_status worst = FREEFLYER_F64_OK;
    int i;
    for (i = 0; i < count; i++) {
        if (!isfinite(numbers[i])) {
            worst = FREEFLYER_F64_NONFINITE_INPUT;
        } else if (fabs(numbers[i]) > limit) {
            worst = freeflyer_f64_worse(worst, FREEFLYER_F64_OUT_OF_RANGE);
        } else {
            /* finite and in range: it leaves the finding as it is */
        }
    }
    return worst;
}

/* Zero command; its status says what is wrong with what was refused, at least what was found. */
static freeflyer_f64_status freeflyer_f64_refuse(const freeflyer_f64_state *state,
        const freeflyer_f64_reference *reference, const freeflyer_f64_status found,
        freeflyer_f64_command *command)
{
    freeflyer_f64_status worst = found;
    worst = freeflyer_f64_worse(worst,
            freeflyer_f64_inspect(state->g, 16, FREEFLYER_F64_MAX_INPUT));
    worst = freeflyer_f64_worse(worst,
            freeflyer_f64_inspect(state->nu, 6, FREEFLYER_F64_MAX_INPUT));
    worst = freeflyer_f64_worse(worst,
            freeflyer_f64_inspect(reference->g, 16, FREEFLYER_F64_MAX_INPUT));
    worst = freeflyer_f64_worse(worst,
            freeflyer_f64_inspect(reference->nu, 6, FREEFLYER_F64_MAX_INPUT));
    worst = freeflyer_f64_worse(worst,
            freeflyer_f64_inspect(reference->nu_dot, 6, FREEFLYER_F64_MAX_INPUT));
    freeflyer_f64_nothing(command);
    return worst;
}

/* A force cut at its limit. */
static double freeflyer_f64_cut(const double force, const double limit)
{
    const double most = (force > 0.0) ? limit : -limit;
    return (fabs(force) <= limit) ? force : most;
}

/* The force within its limits, each coordinate by itself. */
static freeflyer_f64_status freeflyer_f64_saturate(const freeflyer_f64_params *params,
        freeflyer_f64_command *command)
{
    if (!(isfinite(command->force[0]) && params->force_limit[0] >= 0.0
            && isfinite(command->force[1]) && params->force_limit[1] >= 0.0
            && isfinite(command->force[2]) && params->force_limit[2] >= 0.0
            && isfinite(command->force[3]) && params->force_limit[3] >= 0.0
            && isfinite(command->force[4]) && params->force_limit[4] >= 0.0
            && isfinite(command->force[5]) && params->force_limit[5] >= 0.0)) {
        freeflyer_f64_nothing(command);
        return FREEFLYER_F64_NONFINITE_INPUT;
    }
    command->force[0] = freeflyer_f64_cut(command->force[0], params->force_limit[0]);
    command->force[1] = freeflyer_f64_cut(command->force[1], params->force_limit[1]);
    command->force[2] = freeflyer_f64_cut(command->force[2], params->force_limit[2]);
    command->force[3] = freeflyer_f64_cut(command->force[3], params->force_limit[3]);
    command->force[4] = freeflyer_f64_cut(command->force[4], params->force_limit[4]);
    command->force[5] = freeflyer_f64_cut(command->force[5], params->force_limit[5]);
    return FREEFLYER_F64_SATURATED;
}

/* What a computed command is worth, given its distance from the cut locus of the law. */
static freeflyer_f64_status freeflyer_f64_verdict(const freeflyer_f64_params *params,
        const double clearance, freeflyer_f64_command *command)
{
    freeflyer_f64_status status = FREEFLYER_F64_OK;
    if (!(fabs(command->force[0]) <= params->force_limit[0]
            && fabs(command->force[1]) <= params->force_limit[1]
            && fabs(command->force[2]) <= params->force_limit[2]
            && fabs(command->force[3]) <= params->force_limit[3]
            && fabs(command->force[4]) <= params->force_limit[4]
            && fabs(command->force[5]) <= params->force_limit[5])) {
        status = freeflyer_f64_saturate(params, command);
        if (status == FREEFLYER_F64_NONFINITE_INPUT) {
            return status;
        }
    }
    return clearance < FREEFLYER_F64_NEAR_CUT ? FREEFLYER_F64_NEAR_CUT_LOCUS : status;
}

freeflyer_f64_status freeflyer_f64_control(const freeflyer_f64_params *params,
        const freeflyer_f64_state *state, const freeflyer_f64_reference *reference,
        freeflyer_f64_command *command)
{
    double clearance;
#ifdef FREEFLYER_CHECK_POINTERS
    if (params == NULL || state == NULL || reference == NULL || command == NULL) {
        if (command != NULL) {
            freeflyer_f64_nothing(command);
        }
        return FREEFLYER_F64_BAD_PARAMS;
    }
#endif
    /* -- tracking -- */
    const double g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5], g_6 = state->g[6], g_7 = state->g[7],
        g_8 = state->g[8], g_9 = state->g[9], g_10 = state->g[10], g_11 = state->g[11];
    const double g_r_0 = reference->g[0], g_r_1 = reference->g[1], g_r_2 = reference->g[2],
        g_r_3 = reference->g[3], g_r_4 = reference->g[4], g_r_5 = reference->g[5],
        g_r_6 = reference->g[6], g_r_7 = reference->g[7], g_r_8 = reference->g[8],
        g_r_9 = reference->g[9], g_r_10 = reference->g[10], g_r_11 = reference->g[11];

    /* gap_0: translation of g from g_r [m] */
    const double gap_0_0 = g_3 - g_r_3;
    const double gap_0_1 = g_7 - g_r_7;
    const double gap_0_2 = g_11 - g_r_11;

    /* g_e: error, g_r^-1 g [1], eq. (velErr) */
    const double g_e_0 = g_0*g_r_0 + g_4*g_r_4 + g_8*g_r_8;
    const double g_e_1 = g_1*g_r_0 + g_5*g_r_4 + g_9*g_r_8;
    const double g_e_2 = g_10*g_r_8 + g_2*g_r_0 + g_6*g_r_4;
    const double g_e_3 = g_r_0*gap_0_0 + g_r_4*gap_0_1 + g_r_8*gap_0_2;
    const double g_e_4 = g_0*g_r_1 + g_4*g_r_5 + g_8*g_r_9;
    const double g_e_5 = g_1*g_r_1 + g_5*g_r_5 + g_9*g_r_9;
    const double g_e_6 = g_10*g_r_9 + g_2*g_r_1 + g_6*g_r_5;
    const double g_e_7 = g_r_1*gap_0_0 + g_r_5*gap_0_1 + g_r_9*gap_0_2;
    const double g_e_8 = g_0*g_r_2 + g_4*g_r_6 + g_8*g_r_10;
    const double g_e_9 = g_1*g_r_2 + g_5*g_r_6 + g_9*g_r_10;
    const double g_e_10 = g_10*g_r_10 + g_2*g_r_2 + g_6*g_r_6;
    const double g_e_11 = g_r_10*gap_0_2 + g_r_2*gap_0_0 + g_r_6*gap_0_1;

    /* -- end -- */
    if (!(fabs(g_e_0) <= FREEFLYER_F64_MAX_ENTRY && fabs(g_e_1) <= FREEFLYER_F64_MAX_ENTRY
            && fabs(g_e_2) <= FREEFLYER_F64_MAX_ENTRY && fabs(g_e_3) <= FREEFLYER_F64_MAX_REACH
            && fabs(g_e_4) <= FREEFLYER_F64_MAX_ENTRY && fabs(g_e_5) <= FREEFLYER_F64_MAX_ENTRY
            && fabs(g_e_6) <= FREEFLYER_F64_MAX_ENTRY && fabs(g_e_7) <= FREEFLYER_F64_MAX_REACH
            && fabs(g_e_8) <= FREEFLYER_F64_MAX_ENTRY && fabs(g_e_9) <= FREEFLYER_F64_MAX_ENTRY
            && fabs(g_e_10) <= FREEFLYER_F64_MAX_ENTRY && fabs(g_e_11) <= FREEFLYER_F64_MAX_REACH
            && fabs(state->g[3]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(state->g[7]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(state->g[11]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(state->nu[0]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(state->nu[1]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(state->nu[2]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(state->nu[3]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(state->nu[4]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(state->nu[5]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(reference->g[3]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(reference->g[7]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(reference->g[11]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(reference->nu[0]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(reference->nu[1]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(reference->nu[2]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(reference->nu[3]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(reference->nu[4]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(reference->nu[5]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(reference->nu_dot[0]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(reference->nu_dot[1]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(reference->nu_dot[2]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(reference->nu_dot[3]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(reference->nu_dot[4]) <= FREEFLYER_F64_MAX_INPUT
            && fabs(reference->nu_dot[5]) <= FREEFLYER_F64_MAX_INPUT)) {
        if (fabs(g_e_3) <= FREEFLYER_F64_MAX_REACH && fabs(g_e_7) <= FREEFLYER_F64_MAX_REACH
                && fabs(g_e_11) <= FREEFLYER_F64_MAX_REACH) {
            return freeflyer_f64_refuse(state, reference, FREEFLYER_F64_NOT_ON_GROUP, command);
        }
        return freeflyer_f64_refuse(state, reference, FREEFLYER_F64_OUT_OF_RANGE, command);
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
    const double off_9 = g_15 - 1.0;
    const double off_13 = g_r_15 - 1.0;

    /* drift: square of the distance from the group [1] */
    const double drift = g_12*g_12 + g_13*g_13 + g_14*g_14 + g_r_12*g_r_12 + g_r_13*g_r_13 +
        g_r_14*g_r_14 + off_0*off_0 + off_1*off_1 + off_13*off_13 + off_2*off_2 + off_3*off_3 +
        off_4*off_4 + off_5*off_5 + off_9*off_9;

    /* -- end -- */

    if (!(drift < params->max_drift*params->max_drift)) {
        return freeflyer_f64_refuse(state, reference, FREEFLYER_F64_NOT_ON_GROUP, command);
    }
    clearance = freeflyer_f64_law(params, state, reference, command, g_e_0, g_e_1, g_e_2, g_e_3,
            g_e_4, g_e_5, g_e_6, g_e_7, g_e_8, g_e_9, g_e_10, g_e_11);
    return freeflyer_f64_verdict(params, clearance, command);
}

freeflyer_f64_status freeflyer_f64_check_params(const freeflyer_f64_params *params)
{
#ifdef FREEFLYER_CHECK_POINTERS
    if (params == NULL) {
        return FREEFLYER_F64_BAD_PARAMS;
    }
#endif
    double pivot[6];
    int i;
    if (freeflyer_f64_inspect(params->inertia, 21, FREEFLYER_F64_MAX_PARAM) != FREEFLYER_F64_OK) {
        return FREEFLYER_F64_BAD_PARAMS;
    }
    if (!(params->lambda >= FREEFLYER_F64_MIN_GAIN && params->lambda <= FREEFLYER_F64_MAX_RATE)) {
        return FREEFLYER_F64_BAD_PARAMS;
    }
    if (!(params->k_s >= FREEFLYER_F64_MIN_GAIN && params->k_s <= FREEFLYER_F64_MAX_RATE)) {
        return FREEFLYER_F64_BAD_PARAMS;
    }
    if (!(params->max_drift >= FREEFLYER_F64_LEAST_DRIFT && params->max_drift <=
            FREEFLYER_F64_MOST_DRIFT)) {
        return FREEFLYER_F64_BAD_PARAMS;
    }
    for (i = 0; i < 6; i++) {
        if (!(params->force_limit[i] >= FREEFLYER_F64_MIN_GAIN && params->force_limit[i] <=
                FREEFLYER_F64_MAX_PARAM)) {
            return FREEFLYER_F64_BAD_PARAMS;
        }
    }
    if (fabs(params->inertia[3]) > 0.0) {
        return FREEFLYER_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[9]) > 0.0) {
        return FREEFLYER_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[14]) > 0.0) {
        return FREEFLYER_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[16]) > 0.0) {
        return FREEFLYER_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[17]) > 0.0) {
        return FREEFLYER_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[19]) > 0.0) {
        return FREEFLYER_F64_BAD_PARAMS;
    }
    freeflyer_f64_definiteness(params, pivot);
    for (i = 0; i < 6; i++) {
        if (!(pivot[i] > 0.0)) {
            return FREEFLYER_F64_BAD_PARAMS;
        }
    }
    return FREEFLYER_F64_OK;
}
