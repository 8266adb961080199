/*
 * hovercraft_f64: gsmc on SE2, law log (the logarithm), double precision.
 * Every step below carries its quantity, unit and equation; trace.csv lists them by line.
 */
#include "hovercraft_f64.h"

#include <math.h>

#ifdef HOVERCRAFT_CHECK_POINTERS /* that none is null: a precondition, which the self-test checks */
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

const hovercraft_f64_params hovercraft_f64_defaults = {
    {0.05836, 0.0, -0.084, 2.1, 0.0, 2.1},
    0.5, /* lambda */
    1.5, /* k_s */
    1.0e-6 /* max_drift */
};

/* Kernel function k(w) on 0 <= w <= 1, a polynomial in 1 - w. */
static inline double hovercraft_f64_k(const double w)
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
static inline double hovercraft_f64_h(const double w)
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

/* A command that asks for nothing; number by number, since memset is of no use without libc. */
static void hovercraft_f64_nothing(hovercraft_f64_command *command)
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
static double hovercraft_f64_law(const hovercraft_f64_params *params,
        const hovercraft_f64_state *state, const hovercraft_f64_reference *reference,
        hovercraft_f64_command *command, const double g_e_0, const double g_e_1, const double g_e_2,
        const double g_e_3, const double g_e_4, const double g_e_5)
{
    /* -- tracking -- */
    const double inertia_0 = params->inertia[0], inertia_2 = params->inertia[2],
        inertia_3 = params->inertia[3], inertia_5 = params->inertia[5];
    const double rate_gain = params->lambda;
    const double reach_gain = params->k_s;
    const double nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2];
    const double nu_r_0 = reference->nu[0], nu_r_1 = reference->nu[1], nu_r_2 = reference->nu[2];
    const double nu_r_dot_0 = reference->nu_dot[0], nu_r_dot_1 = reference->nu_dot[1],
        nu_r_dot_2 = reference->nu_dot[2];

    /* eta_arm_0: velocity at p [m/s] */
    const double eta_arm_0_0 = nu_r_1 - g_e_5*nu_r_0;
    const double eta_arm_0_1 = nu_r_2 + g_e_2*nu_r_0;

    /* eta: reference velocity in the body frame [rad/s, m/s], eq. (velErr) */
    const double eta_1 = eta_arm_0_0*g_e_0 + eta_arm_0_1*g_e_3;
    const double eta_2 = eta_arm_0_0*g_e_1 + eta_arm_0_1*g_e_4;

    /* nu_e: velocity error [rad/s, m/s], eq. (velErr) */
    const double nu_e_0 = nu_0 - nu_r_0;
    const double nu_e_1 = nu_1 - eta_1;
    const double nu_e_2 = nu_2 - eta_2;

    /* eta_dot_arm_0: velocity at p [m/s] */
    const double eta_dot_arm_0_0 = nu_r_dot_1 - g_e_5*nu_r_dot_0;
    const double eta_dot_arm_0_1 = nu_r_dot_2 + g_e_2*nu_r_dot_0;

    /* eta_dot: exact rate of eta [rad/s^2, m/s^2] */
    const double eta_dot_1 = eta_2*nu_e_0 + eta_dot_arm_0_0*g_e_0 + eta_dot_arm_0_1*g_e_3 -
        nu_e_2*nu_r_0;
    const double eta_dot_2 = eta_dot_arm_0_0*g_e_1 + eta_dot_arm_0_1*g_e_4 + nu_e_1*nu_r_0 -
        eta_1*nu_e_0;

    /* twice: 2 cos and 2 sin of the angle [1] */
    const double twice_0 = g_e_0 + g_e_4;
    const double twice_1 = g_e_3 - g_e_1;

    /* norm_square: their squared length [1] */
    const double norm_square = twice_0*twice_0 + twice_1*twice_1;

    /* norm_bounded: the same: less is no turn [1] */
    double norm_bounded;
    if (norm_square <= 3.0) {
        norm_bounded = 3.0;
    } else {
        norm_bounded = norm_square;
    }

    /* norm: their length [1] */
    const double norm = sqrt(norm_bounded);

    /* column: cos >= 0 and sin of half the angle, unscaled [1] */
    double column_0, column_1;
    if (twice_0 >= 0.0) {
        column_0 = norm + twice_0;
        column_1 = twice_1;
    } else if (twice_1 >= 0.0) {
        column_0 = twice_1;
        column_1 = norm - twice_0;
    } else {
        column_0 = -twice_1;
        column_1 = twice_0 - norm;
    }

    /* column_square: squared length [1] */
    const double column_square = column_0*column_0 + column_1*column_1;

    /* column_bounded: the same [1] */
    double column_bounded;
    if (column_square <= 3.0) {
        column_bounded = 3.0;
    } else {
        column_bounded = column_square;
    }

    /* scale: to unit length [1] */
    const double scale = 1.0/sqrt(column_bounded);

    /* cosine: cos of half the error angle, rounded [1] */
    const double cosine = column_0*scale;

    /* w: cos of half the error angle [1] */
    double w;
    if (cosine >= 1.0) {
        w = 1.0;
    } else {
        w = cosine;
    }

    /* sine: sin of half the error angle [1] */
    const double sine = column_1*scale;

    /* k: half angle over its sine [1] */
    const double k = hovercraft_f64_k(w);

    /* h: -dk/dw [1] */
    const double h = hovercraft_f64_h(w);

    /* phi: rotation vector of the error [rad] */
    const double phi_0 = 2.0*k*sine;

    /* half: 1/(2 k) [1] */
    const double half = 0.5/k;

    /* turned_p: p turned back by half the angle [m] */
    const double turned_p_0 = g_e_2*w + g_e_5*sine;
    const double turned_p_1 = g_e_5*w - g_e_2*sine;

    /* rho_p: p - k Y p + h Y Y p [m] */
    const double rho_p_0 = k*turned_p_0;
    const double rho_p_1 = k*turned_p_1;

    /* y_p: rho/(2 k) [m] */
    const double y_p_0 = half*rho_p_0;
    const double y_p_1 = half*rho_p_1;

    /* turn: Y nu_e, Y = ad of y [rad/s, m/s] */
    const double turn_1 = nu_e_0*y_p_1 - nu_e_2*sine;
    const double turn_2 = nu_e_1*sine - nu_e_0*y_p_0;

    /* bend: Y Y nu_e [rad/s, m/s] */
    const double bend_1 = -sine*turn_2;
    const double bend_2 = sine*turn_1;

    /* nu_u_dot: exact rate of nu_u [rad/s, m/s] */
    const double nu_u_dot_1 = nu_e_1 + bend_1*h + k*turn_1;
    const double nu_u_dot_2 = nu_e_2 + bend_2*h + k*turn_2;

    /* drive: lambda nu_u [rad/s, m/s] */
    const double drive_0 = phi_0*rate_gain;
    const double drive_1 = rate_gain*rho_p_0;
    const double drive_2 = rate_gain*rho_p_1;

    /* s: sliding variable [rad/s, m/s], eq. (SurfaceErr) */
    const double s_0 = drive_0 + nu_e_0;
    const double s_1 = drive_1 + nu_e_1;
    const double s_2 = drive_2 + nu_e_2;

    /* wanted: acceleration asked for [rad/s^2, m/s^2] */
    const double wanted_0 = nu_r_dot_0 - nu_e_0*rate_gain - reach_gain*s_0;
    const double wanted_1 = eta_dot_1 - nu_u_dot_1*rate_gain - reach_gain*s_1;
    const double wanted_2 = eta_dot_2 - nu_u_dot_2*rate_gain - reach_gain*s_2;

    /* turning: lambda nu_u - eta [rad/s, m/s] */
    const double turning_0 = drive_0 - nu_r_0;
    const double turning_1 = drive_1 - eta_1;
    const double turning_2 = drive_2 - eta_2;

    /* momentum: I nu [N m s, N s] */
    const double momentum_1 = inertia_3*nu_1;
    const double momentum_2 = inertia_2*nu_0 + inertia_5*nu_2;

    /* force: control force, I f_u [N m, N], eq. (TckCtrl) */
    const double force_0 = inertia_0*wanted_0 + inertia_2*wanted_2 + momentum_1*turning_2 -
        momentum_2*turning_1;
    const double force_1 = inertia_3*wanted_1 + momentum_2*turning_0;
    const double force_2 = inertia_2*wanted_0 + inertia_5*wanted_2 - momentum_1*turning_0;

    /* -- end -- */
    command->force[0] = force_0;
    command->force[1] = force_1;
    command->force[2] = force_2;
    command->s[0] = s_0;
    command->s[1] = s_1;
    command->s[2] = s_2;
    command->nu_u[0] = phi_0;
    command->nu_u[1] = rho_p_0;
    command->nu_u[2] = rho_p_1;
    command->nu_u_dot[0] = nu_e_0;
    command->nu_u_dot[1] = nu_u_dot_1;
    command->nu_u_dot[2] = nu_u_dot_2;
    return w;
}

/* pivots of the inertia: all positive for a valid one. */
static void hovercraft_f64_definiteness(const hovercraft_f64_params *params, double pivot[3])
{
    /* -- definiteness -- */
    const double inertia_0 = params->inertia[0], inertia_2 = params->inertia[2],
        inertia_3 = params->inertia[3], inertia_5 = params->inertia[5];

    /* divisor_0: the pivot, or 1 where it is not positive [kg m^2, kg m, kg] */
    double divisor_0;
    if (inertia_0 > 0.0) {
        divisor_0 = inertia_0;
    } else {
        divisor_0 = 1.0;
    }

    /* lower_20: I = L D L^T, entry of L [1] */
    const double lower_20 = inertia_2/divisor_0;

    /* pivot_2: pivot of I [kg m^2, kg m, kg] */
    const double pivot_2 = inertia_5 - inertia_0*lower_20*lower_20;

    /* -- end -- */
    pivot[0] = inertia_0;
    pivot[1] = inertia_3;
    pivot[2] = pivot_2;
}

void hovercraft_f64_tracking(const hovercraft_f64_params *params, const hovercraft_f64_state *state,
        const hovercraft_f64_reference *reference, hovercraft_f64_command *command)
{
    /* -- tracking -- */
    const double g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5];
    const double g_r_0 = reference->g[0], g_r_1 = reference->g[1], g_r_2 = reference->g[2],
        g_r_3 = reference->g[3], g_r_4 = reference->g[4], g_r_5 = reference->g[5];

    /* gap_0: translation of g from g_r [m] */
    const double gap_0_0 = g_2 - g_r_2;
    const double gap_0_1 = g_5 - g_r_5;

    /* g_e: error, g_r^-1 g [1], eq. (velErr) */
    const double g_e_0 = g_0*g_r_0 + g_3*g_r_3;
    const double g_e_1 = g_1*g_r_0 + g_4*g_r_3;
    const double g_e_2 = g_r_0*gap_0_0 + g_r_3*gap_0_1;
    const double g_e_3 = g_0*g_r_1 + g_3*g_r_4;
    const double g_e_4 = g_1*g_r_1 + g_4*g_r_4;
    const double g_e_5 = g_r_1*gap_0_0 + g_r_4*gap_0_1;

    /* -- end -- */
    (void)hovercraft_f64_law(params, state, reference, command, g_e_0, g_e_1, g_e_2, g_e_3, g_e_4,
            g_e_5);
}

void hovercraft_f64_reaching(const hovercraft_f64_params *params, const hovercraft_f64_state *state,
        hovercraft_f64_command *command)
{
    /* -- reaching -- */
    const double inertia_0 = params->inertia[0], inertia_2 = params->inertia[2],
        inertia_3 = params->inertia[3], inertia_5 = params->inertia[5];
    const double rate_gain = params->lambda;
    const double reach_gain = params->k_s;
    const double g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5];
    const double nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2];

    /* twice: 2 cos and 2 sin of the angle [1] */
    const double twice_0 = g_0 + g_4;
    const double twice_1 = g_3 - g_1;

    /* norm_square: their squared length [1] */
    const double norm_square = twice_0*twice_0 + twice_1*twice_1;

    /* norm_bounded: the same: less is no turn [1] */
    double norm_bounded;
    if (norm_square <= 3.0) {
        norm_bounded = 3.0;
    } else {
        norm_bounded = norm_square;
    }

    /* norm: their length [1] */
    const double norm = sqrt(norm_bounded);

    /* column: cos >= 0 and sin of half the angle, unscaled [1] */
    double column_0, column_1;
    if (twice_0 >= 0.0) {
        column_0 = norm + twice_0;
        column_1 = twice_1;
    } else if (twice_1 >= 0.0) {
        column_0 = twice_1;
        column_1 = norm - twice_0;
    } else {
        column_0 = -twice_1;
        column_1 = twice_0 - norm;
    }

    /* column_square: squared length [1] */
    const double column_square = column_0*column_0 + column_1*column_1;

    /* column_bounded: the same [1] */
    double column_bounded;
    if (column_square <= 3.0) {
        column_bounded = 3.0;
    } else {
        column_bounded = column_square;
    }

    /* scale: to unit length [1] */
    const double scale = 1.0/sqrt(column_bounded);

    /* cosine: cos of half the error angle, rounded [1] */
    const double cosine = column_0*scale;

    /* w: cos of half the error angle [1] */
    double w;
    if (cosine >= 1.0) {
        w = 1.0;
    } else {
        w = cosine;
    }

    /* sine: sin of half the error angle [1] */
    const double sine = column_1*scale;

    /* k: half angle over its sine [1] */
    const double k = hovercraft_f64_k(w);

    /* h: -dk/dw [1] */
    const double h = hovercraft_f64_h(w);

    /* phi: rotation vector of the error [rad] */
    const double phi_0 = 2.0*k*sine;

    /* half: 1/(2 k) [1] */
    const double half = 0.5/k;

    /* turned_p: p turned back by half the angle [m] */
    const double turned_p_0 = g_2*w + g_5*sine;
    const double turned_p_1 = g_5*w - g_2*sine;

    /* rho_p: p - k Y p + h Y Y p [m] */
    const double rho_p_0 = k*turned_p_0;
    const double rho_p_1 = k*turned_p_1;

    /* y_p: rho/(2 k) [m] */
    const double y_p_0 = half*rho_p_0;
    const double y_p_1 = half*rho_p_1;

    /* turn: Y nu_e, Y = ad of y [rad/s, m/s] */
    const double turn_1 = nu_0*y_p_1 - nu_2*sine;
    const double turn_2 = nu_1*sine - nu_0*y_p_0;

    /* bend: Y Y nu_e [rad/s, m/s] */
    const double bend_1 = -sine*turn_2;
    const double bend_2 = sine*turn_1;

    /* nu_u_dot: exact rate of nu_u [rad/s, m/s] */
    const double nu_u_dot_1 = nu_1 + bend_1*h + k*turn_1;
    const double nu_u_dot_2 = nu_2 + bend_2*h + k*turn_2;

    /* drive: lambda nu_u [rad/s, m/s] */
    const double drive_0 = phi_0*rate_gain;
    const double drive_1 = rate_gain*rho_p_0;
    const double drive_2 = rate_gain*rho_p_1;

    /* s: sliding variable [rad/s, m/s], eq. (sldS) */
    const double s_0 = drive_0 + nu_0;
    const double s_1 = drive_1 + nu_1;
    const double s_2 = drive_2 + nu_2;

    /* wanted: acceleration asked for [rad/s^2, m/s^2] */
    const double wanted_0 = -(nu_0*rate_gain + reach_gain*s_0);
    const double wanted_1 = -(nu_u_dot_1*rate_gain + reach_gain*s_1);
    const double wanted_2 = -(nu_u_dot_2*rate_gain + reach_gain*s_2);

    /* momentum: I nu [N m s, N s] */
    const double momentum_1 = inertia_3*nu_1;
    const double momentum_2 = inertia_2*nu_0 + inertia_5*nu_2;

    /* force: control force, I f_u [N m, N], eq. (Ctrl2) */
    const double force_0 = drive_2*momentum_1 + inertia_0*wanted_0 + inertia_2*wanted_2 -
        drive_1*momentum_2;
    const double force_1 = drive_0*momentum_2 + inertia_3*wanted_1;
    const double force_2 = inertia_2*wanted_0 + inertia_5*wanted_2 - drive_0*momentum_1;

    /* -- end -- */
    command->force[0] = force_0;
    command->force[1] = force_1;
    command->force[2] = force_2;
    command->s[0] = s_0;
    command->s[1] = s_1;
    command->s[2] = s_2;
    command->nu_u[0] = phi_0;
    command->nu_u[1] = rho_p_0;
    command->nu_u[2] = rho_p_1;
    command->nu_u_dot[0] = nu_0;
    command->nu_u_dot[1] = nu_u_dot_1;
    command->nu_u_dot[2] = nu_u_dot_2;
}

void hovercraft_f64_plant(const hovercraft_f64_params *params, const hovercraft_f64_state *state,
        const double force[3], double nu_dot[3])
{
    /* -- plant -- */
    const double inertia_0 = params->inertia[0], inertia_2 = params->inertia[2],
        inertia_3 = params->inertia[3], inertia_5 = params->inertia[5];
    const double nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2];
    const double force_0 = force[0], force_1 = force[1], force_2 = force[2];

    /* momentum: I nu [N m s, N s] */
    const double momentum_1 = inertia_3*nu_1;
    const double momentum_2 = inertia_2*nu_0 + inertia_5*nu_2;

    /* total: coad(nu) I nu + force [N m, N] */
    const double total_0 = force_0 + momentum_1*nu_2 - momentum_2*nu_1;
    const double total_1 = force_1 + momentum_2*nu_0;
    const double total_2 = force_2 - momentum_1*nu_0;

    /* lower_20: I = L D L^T, entry of L [1] */
    const double lower_20 = inertia_2/inertia_0;

    /* pivot_2: pivot of I [kg m^2, kg m, kg] */
    const double pivot_2 = inertia_5 - inertia_0*lower_20*lower_20;

    /* forward_2: forward substitution [N m, N] */
    const double forward_2 = total_2 - lower_20*total_0;

    /* back_2: back substitution [rad/s^2, m/s^2] */
    const double back_2 = forward_2/pivot_2;

    /* back_1: back substitution [rad/s^2, m/s^2] */
    const double back_1 = total_1/inertia_3;

    /* back_0: back substitution [rad/s^2, m/s^2] */
    const double back_0 = total_0/inertia_0 - back_2*lower_20;

    /* -- end -- */
    nu_dot[0] = back_0;
    nu_dot[1] = back_1;
    nu_dot[2] = back_2;
}

/* The worse of two findings. */
static hovercraft_f64_status hovercraft_f64_worse(const hovercraft_f64_status a,
        const hovercraft_f64_status b)
{
    return a > b ? a : b;
}

/* OUT_OF_RANGE or NONFINITE_INPUT if any number is larger than a limit or not finite. */
static hovercraft_f64_status hovercraft_f64_inspect(const double *numbers, const int count,
        const double limit)
{
    hovercraft_f64_status worst = HOVERCRAFT_F64_OK;
    int i;
    for (i = 0; i < count; i++) {
        if (!isfinite(numbers[i])) {
            worst = HOVERCRAFT_F64_NONFINITE_INPUT;
        } else if (fabs(numbers[i]) > limit) {
            worst = hovercraft_f64_worse(worst, HOVERCRAFT_F64_OUT_OF_RANGE);
        } else {
            /* finite and in range: it leaves the finding as it is */
        }
    }
    return worst;
}

/* Zero command; its status says what is wrong with what was refused, at least what was found. */
static hovercraft_f64_status hovercraft_f64_refuse(const hovercraft_f64_state *state,
        const hovercraft_f64_reference *reference, const hovercraft_f64_status found,
        hovercraft_f64_command *command)
{
    hovercraft_f64_status worst = found;
    worst = hovercraft_f64_worse(worst,
            hovercraft_f64_inspect(state->g, 9, HOVERCRAFT_F64_MAX_INPUT));
    worst = hovercraft_f64_worse(worst,
            hovercraft_f64_inspect(state->nu, 3, HOVERCRAFT_F64_MAX_INPUT));
    worst = hovercraft_f64_worse(worst,
            hovercraft_f64_inspect(reference->g, 9, HOVERCRAFT_F64_MAX_INPUT));
    worst = hovercraft_f64_worse(worst,
            hovercraft_f64_inspect(reference->nu, 3, HOVERCRAFT_F64_MAX_INPUT));
    worst = hovercraft_f64_worse(worst,
            hovercraft_f64_inspect(reference->nu_dot, 3, HOVERCRAFT_F64_MAX_INPUT));
    hovercraft_f64_nothing(command);
    return worst;
}

/* What a computed command is worth, given its distance from the cut locus of the law. */
static hovercraft_f64_status hovercraft_f64_verdict(const double clearance,
        hovercraft_f64_command *command)
{
    if (!(isfinite(command->force[0]) && isfinite(command->force[1]) &&
            isfinite(command->force[2]))) {
        hovercraft_f64_nothing(command);
        return HOVERCRAFT_F64_NONFINITE_INPUT;
    }
    return clearance < HOVERCRAFT_F64_NEAR_CUT ? HOVERCRAFT_F64_NEAR_CUT_LOCUS : HOVERCRAFT_F64_OK;
}

hovercraft_f64_status hovercraft_f64_control(const hovercraft_f64_params *params,
        const hovercraft_f64_state *state, const hovercraft_f64_reference *reference,
        hovercraft_f64_command *command)
{
    double clearance;
#ifdef HOVERCRAFT_CHECK_POINTERS
    if (params == NULL || state == NULL || reference == NULL || command == NULL) {
        if (command != NULL) {
            hovercraft_f64_nothing(command);
        }
        return HOVERCRAFT_F64_BAD_PARAMS;
    }
#endif
    /* -- tracking -- */
    const double g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5];
    const double g_r_0 = reference->g[0], g_r_1 = reference->g[1], g_r_2 = reference->g[2],
        g_r_3 = reference->g[3], g_r_4 = reference->g[4], g_r_5 = reference->g[5];

    /* gap_0: translation of g from g_r [m] */
    const double gap_0_0 = g_2 - g_r_2;
    const double gap_0_1 = g_5 - g_r_5;

    /* g_e: error, g_r^-1 g [1], eq. (velErr) */
    const double g_e_0 = g_0*g_r_0 + g_3*g_r_3;
    const double g_e_1 = g_1*g_r_0 + g_4*g_r_3;
    const double g_e_2 = g_r_0*gap_0_0 + g_r_3*gap_0_1;
    const double g_e_3 = g_0*g_r_1 + g_3*g_r_4;
    const double g_e_4 = g_1*g_r_1 + g_4*g_r_4;
    const double g_e_5 = g_r_1*gap_0_0 + g_r_4*gap_0_1;

    /* -- end -- */
    if (!(fabs(g_e_0) <= HOVERCRAFT_F64_MAX_ENTRY && fabs(g_e_1) <= HOVERCRAFT_F64_MAX_ENTRY
            && fabs(g_e_2) <= HOVERCRAFT_F64_MAX_REACH && fabs(g_e_3) <= HOVERCRAFT_F64_MAX_ENTRY
            && fabs(g_e_4) <= HOVERCRAFT_F64_MAX_ENTRY && fabs(g_e_5) <= HOVERCRAFT_F64_MAX_REACH
            && fabs(state->g[2]) <= HOVERCRAFT_F64_MAX_INPUT
            && fabs(state->g[5]) <= HOVERCRAFT_F64_MAX_INPUT
            && fabs(state->nu[0]) <= HOVERCRAFT_F64_MAX_INPUT
            && fabs(state->nu[1]) <= HOVERCRAFT_F64_MAX_INPUT
            && fabs(state->nu[2]) <= HOVERCRAFT_F64_MAX_INPUT
            && fabs(reference->g[2]) <= HOVERCRAFT_F64_MAX_INPUT
            && fabs(reference->g[5]) <= HOVERCRAFT_F64_MAX_INPUT
            && fabs(reference->nu[0]) <= HOVERCRAFT_F64_MAX_INPUT
            && fabs(reference->nu[1]) <= HOVERCRAFT_F64_MAX_INPUT
            && fabs(reference->nu[2]) <= HOVERCRAFT_F64_MAX_INPUT
            && fabs(reference->nu_dot[0]) <= HOVERCRAFT_F64_MAX_INPUT
            && fabs(reference->nu_dot[1]) <= HOVERCRAFT_F64_MAX_INPUT
            && fabs(reference->nu_dot[2]) <= HOVERCRAFT_F64_MAX_INPUT)) {
        if (fabs(g_e_2) <= HOVERCRAFT_F64_MAX_REACH && fabs(g_e_5) <= HOVERCRAFT_F64_MAX_REACH) {
            return hovercraft_f64_refuse(state, reference, HOVERCRAFT_F64_NOT_ON_GROUP, command);
        }
        return hovercraft_f64_refuse(state, reference, HOVERCRAFT_F64_OUT_OF_RANGE, command);
    }
    /* -- drift -- */
    const double g_6 = state->g[6], g_7 = state->g[7], g_8 = state->g[8];
    const double g_r_6 = reference->g[6], g_r_7 = reference->g[7], g_r_8 = reference->g[8];

    /* off: what vanishes on the group, and only there [1] */
    const double off_0 = g_e_0*g_e_0 - 1.0 + g_e_3*g_e_3;
    const double off_1 = g_e_1 + g_e_3;
    const double off_2 = g_e_4 - g_e_0;
    const double off_5 = g_8 - 1.0;
    const double off_8 = g_r_8 - 1.0;

    /* drift: square of the distance from the group [1] */
    const double drift = g_6*g_6 + g_7*g_7 + g_r_6*g_r_6 + g_r_7*g_r_7 + off_0*off_0 + off_1*off_1 +
        off_2*off_2 + off_5*off_5 + off_8*off_8;

    /* -- end -- */

    if (!(drift < params->max_drift*params->max_drift)) {
        return hovercraft_f64_refuse(state, reference, HOVERCRAFT_F64_NOT_ON_GROUP, command);
    }
    clearance = hovercraft_f64_law(params, state, reference, command, g_e_0, g_e_1, g_e_2, g_e_3,
            g_e_4, g_e_5);
    return hovercraft_f64_verdict(clearance, command);
}

hovercraft_f64_status hovercraft_f64_check_params(const hovercraft_f64_params *params)
{
#ifdef HOVERCRAFT_CHECK_POINTERS
    if (params == NULL) {
        return HOVERCRAFT_F64_BAD_PARAMS;
    }
#endif
    double pivot[3];
    int i;
    if (hovercraft_f64_inspect(params->inertia, 6, HOVERCRAFT_F64_MAX_PARAM) != HOVERCRAFT_F64_OK) {
        return HOVERCRAFT_F64_BAD_PARAMS;
    }
    if (!(params->lambda >= HOVERCRAFT_F64_MIN_GAIN && params->lambda <= HOVERCRAFT_F64_MAX_RATE)) {
        return HOVERCRAFT_F64_BAD_PARAMS;
    }
    if (!(params->k_s >= HOVERCRAFT_F64_MIN_GAIN && params->k_s <= HOVERCRAFT_F64_MAX_RATE)) {
        return HOVERCRAFT_F64_BAD_PARAMS;
    }
    if (!(params->max_drift >= HOVERCRAFT_F64_LEAST_DRIFT && params->max_drift <=
            HOVERCRAFT_F64_MOST_DRIFT)) {
        return HOVERCRAFT_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[1]) > 0.0) {
        return HOVERCRAFT_F64_BAD_PARAMS;
    }
    if (fabs(params->inertia[4]) > 0.0) {
        return HOVERCRAFT_F64_BAD_PARAMS;
    }
    hovercraft_f64_definiteness(params, pivot);
    for (i = 0; i < 3; i++) {
        if (!(pivot[i] > 0.0)) {
            return HOVERCRAFT_F64_BAD_PARAMS;
        }
    }
    return HOVERCRAFT_F64_OK;
}
