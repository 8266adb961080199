/*
 * hovercraft_f32: gsmc on SE2, law log (the logarithm), float precision.
 * Every step below carries its quantity, unit and equation; trace.csv lists them by line.
 */
#include "hovercraft_f32.h"

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

const hovercraft_f32_params hovercraft_f32_defaults = {
    {0.05836F, 0.0F, -0.084F, 2.1F, 0.0F, 2.1F},
    0.5F, /* lambda */
    1.5F, /* k_s */
    0.0001F /* max_drift */
};

/* Kernel function k(w) on 0 <= w <= 1, a polynomial in 1 - w. */
static inline float hovercraft_f32_k(const float w)
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
static inline float hovercraft_f32_h(const float w)
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

/* A command that asks for nothing; number by number, since memset is of no use without libc. */
static void hovercraft_f32_nothing(hovercraft_f32_command *command)
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
static float hovercraft_f32_law(const hovercraft_f32_params *params,
        const hovercraft_f32_state *state, const hovercraft_f32_reference *reference,
        hovercraft_f32_command *command, const float g_e_0, const float g_e_1, const float g_e_2,
        const float g_e_3, const float g_e_4, const float g_e_5)
{
    /* -- tracking -- */
    const float inertia_0 = params->inertia[0], inertia_2 = params->inertia[2],
        inertia_3 = params->inertia[3], inertia_5 = params->inertia[5];
    const float rate_gain = params->lambda;
    const float reach_gain = params->k_s;
    const float nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2];
    const float nu_r_0 = reference->nu[0], nu_r_1 = reference->nu[1], nu_r_2 = reference->nu[2];
    const float nu_r_dot_0 = reference->nu_dot[0], nu_r_dot_1 = reference->nu_dot[1],
        nu_r_dot_2 = reference->nu_dot[2];

    /* eta_arm_0: velocity at p [m/s] */
    const float eta_arm_0_0 = nu_r_1 - g_e_5*nu_r_0;
    const float eta_arm_0_1 = nu_r_2 + g_e_2*nu_r_0;

    /* eta: reference velocity in the body frame [rad/s, m/s], eq. (velErr) */
    const float eta_1 = eta_arm_0_0*g_e_0 + eta_arm_0_1*g_e_3;
    const float eta_2 = eta_arm_0_0*g_e_1 + eta_arm_0_1*g_e_4;

    /* nu_e: velocity error [rad/s, m/s], eq. (velErr) */
    const float nu_e_0 = nu_0 - nu_r_0;
    const float nu_e_1 = nu_1 - eta_1;
    const float nu_e_2 = nu_2 - eta_2;

    /* eta_dot_arm_0: velocity at p [m/s] */
    const float eta_dot_arm_0_0 = nu_r_dot_1 - g_e_5*nu_r_dot_0;
    const float eta_dot_arm_0_1 = nu_r_dot_2 + g_e_2*nu_r_dot_0;

    /* eta_dot: exact rate of eta [rad/s^2, m/s^2] */
    const float eta_dot_1 = eta_2*nu_e_0 + eta_dot_arm_0_0*g_e_0 + eta_dot_arm_0_1*g_e_3 -
        nu_e_2*nu_r_0;
    const float eta_dot_2 = eta_dot_arm_0_0*g_e_1 + eta_dot_arm_0_1*g_e_4 + nu_e_1*nu_r_0 -
        eta_1*nu_e_0;

    /* twice: 2 cos and 2 sin of the angle [1] */
    const float twice_0 = g_e_0 + g_e_4;
    const float twice_1 = g_e_3 - g_e_1;

    /* norm_square: their squared length [1] */
    const float norm_square = twice_0*twice_0 + twice_1*twice_1;

    /* norm_bounded: the same: less is no turn [1] */
    float norm_bounded;
    if (norm_square <= 3.0F) {
        norm_bounded = 3.0F;
    } else {
        norm_bounded = norm_square;
    }

    /* norm: their length [1] */
    const float norm = sqrtf(norm_bounded);

    /* column: cos >= 0 and sin of half the angle, unscaled [1] */
    float column_0, column_1;
    if (twice_0 >= 0.0F) {
        column_0 = norm + twice_0;
        column_1 = twice_1;
    } else if (twice_1 >= 0.0F) {
        column_0 = twice_1;
        column_1 = norm - twice_0;
    } else {
        column_0 = -twice_1;
        column_1 = twice_0 - norm;
    }

    /* column_square: squared length [1] */
    const float column_square = column_0*column_0 + column_1*column_1;

    /* column_bounded: the same [1] */
    float column_bounded;
    if (column_square <= 3.0F) {
        column_bounded = 3.0F;
    } else {
        column_bounded = column_square;
    }

    /* scale: to unit length [1] */
    const float scale = 1.0F/sqrtf(column_bounded);

    /* cosine: cos of half the error angle, rounded [1] */
    const float cosine = column_0*scale;

    /* w: cos of half the error angle [1] */
    float w;
    if (cosine >= 1.0F) {
        w = 1.0F;
    } else {
        w = cosine;
    }

    /* sine: sin of half the error angle [1] */
    const float sine = column_1*scale;

    /* k: half angle over its sine [1] */
    const float k = hovercraft_f32_k(w);

    /* h: -dk/dw [1] */
    const float h = hovercraft_f32_h(w);

    /* phi: rotation vector of the error [rad] */
    const float phi_0 = 2.0F*k*sine;

    /* half: 1/(2 k) [1] */
    const float half = 0.5F/k;

    /* turned_p: p turned back by half the angle [m] */
    const float turned_p_0 = g_e_2*w + g_e_5*sine;
    const float turned_p_1 = g_e_5*w - g_e_2*sine;

    /* rho_p: p - k Y p + h Y Y p [m] */
    const float rho_p_0 = k*turned_p_0;
    const float rho_p_1 = k*turned_p_1;

    /* y_p: rho/(2 k) [m] */
    const float y_p_0 = half*rho_p_0;
    const float y_p_1 = half*rho_p_1;

    /* turn: Y nu_e, Y = ad of y [rad/s, m/s] */
    const float turn_1 = nu_e_0*y_p_1 - nu_e_2*sine;
    const float turn_2 = nu_e_1*sine - nu_e_0*y_p_0;

    /* bend: Y Y nu_e [rad/s, m/s] */
    const float bend_1 = -sine*turn_2;
    const float bend_2 = sine*turn_1;

    /* nu_u_dot: exact rate of nu_u [rad/s, m/s] */
    const float nu_u_dot_1 = nu_e_1 + bend_1*h + k*turn_1;
    const float nu_u_dot_2 = nu_e_2 + bend_2*h + k*turn_2;

    /* drive: lambda nu_u [rad/s, m/s] */
    const float drive_0 = phi_0*rate_gain;
    const float drive_1 = rate_gain*rho_p_0;
    const float drive_2 = rate_gain*rho_p_1;

    /* s: sliding variable [rad/s, m/s], eq. (SurfaceErr) */
    const float s_0 = drive_0 + nu_e_0;
    const float s_1 = drive_1 + nu_e_1;
    const float s_2 = drive_2 + nu_e_2;

    /* wanted: acceleration asked for [rad/s^2, m/s^2] */
    const float wanted_0 = nu_r_dot_0 - nu_e_0*rate_gain - reach_gain*s_0;
    const float wanted_1 = eta_dot_1 - nu_u_dot_1*rate_gain - reach_gain*s_1;
    const float wanted_2 = eta_dot_2 - nu_u_dot_2*rate_gain - reach_gain*s_2;

    /* turning: lambda nu_u - eta [rad/s, m/s] */
    const float turning_0 = drive_0 - nu_r_0;
    const float turning_1 = drive_1 - eta_1;
    const float turning_2 = drive_2 - eta_2;

    /* momentum: I nu [N m s, N s] */
    const float momentum_1 = inertia_3*nu_1;
    const float momentum_2 = inertia_2*nu_0 + inertia_5*nu_2;

    /* force: control force, I f_u [N m, N], eq. (TckCtrl) */
    const float force_0 = inertia_0*wanted_0 + inertia_2*wanted_2 + momentum_1*turning_2 -
        momentum_2*turning_1;
    const float force_1 = inertia_3*wanted_1 + momentum_2*turning_0;
    const float force_2 = inertia_2*wanted_0 + inertia_5*wanted_2 - momentum_1*turning_0;

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
static void hovercraft_f32_definiteness(const hovercraft_f32_params *params, float pivot[3])
{
    /* -- definiteness -- */
    const float inertia_0 = params->inertia[0], inertia_2 = params->inertia[2],
        inertia_3 = params->inertia[3], inertia_5 = params->inertia[5];

    /* divisor_0: the pivot, or 1 where it is not positive [kg m^2, kg m, kg] */
    float divisor_0;
    if (inertia_0 > 0.0F) {
        divisor_0 = inertia_0;
    } else {
        divisor_0 = 1.0F;
    }

    /* lower_20: I = L D L^T, entry of L [1] */
    const float lower_20 = inertia_2/divisor_0;

    /* pivot_2: pivot of I [kg m^2, kg m, kg] */
    const float pivot_2 = inertia_5 - inertia_0*lower_20*lower_20;

    /* -- end -- */
    pivot[0] = inertia_0;
    pivot[1] = inertia_3;
    pivot[2] = pivot_2;
}

void hovercraft_f32_tracking(const hovercraft_f32_params *params, const hovercraft_f32_state *state,
        const hovercraft_f32_reference *reference, hovercraft_f32_command *command)
{
    /* -- tracking -- */
    const float g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5];
    const float g_r_0 = reference->g[0], g_r_1 = reference->g[1], g_r_2 = reference->g[2],
        g_r_3 = reference->g[3], g_r_4 = reference->g[4], g_r_5 = reference->g[5];

    /* gap_0: translation of g from g_r [m] */
    const float gap_0_0 = g_2 - g_r_2;
    const float gap_0_1 = g_5 - g_r_5;

    /* g_e: error, g_r^-1 g [1], eq. (velErr) */
    const float g_e_0 = g_0*g_r_0 + g_3*g_r_3;
    const float g_e_1 = g_1*g_r_0 + g_4*g_r_3;
    const float g_e_2 = g_r_0*gap_0_0 + g_r_3*gap_0_1;
    const float g_e_3 = g_0*g_r_1 + g_3*g_r_4;
    const float g_e_4 = g_1*g_r_1 + g_4*g_r_4;
    const float g_e_5 = g_r_1*gap_0_0 + g_r_4*gap_0_1;

    /* -- end -- */
    (void)hovercraft_f32_law(params, state, reference, command, g_e_0, g_e_1, g_e_2, g_e_3, g_e_4,
            g_e_5);
}

void hovercraft_f32_reaching(const hovercraft_f32_params *params, const hovercraft_f32_state *state,
        hovercraft_f32_command *command)
{
    /* -- reaching -- */
    const float inertia_0 = params->inertia[0], inertia_2 = params->inertia[2],
        inertia_3 = params->inertia[3], inertia_5 = params->inertia[5];
    const float rate_gain = params->lambda;
    const float reach_gain = params->k_s;
    const float g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5];
    const float nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2];

    /* twice: 2 cos and 2 sin of the angle [1] */
    const float twice_0 = g_0 + g_4;
    const float twice_1 = g_3 - g_1;

    /* norm_square: their squared length [1] */
    const float norm_square = twice_0*twice_0 + twice_1*twice_1;

    /* norm_bounded: the same: less is no turn [1] */
    float norm_bounded;
    if (norm_square <= 3.0F) {
        norm_bounded = 3.0F;
    } else {
        norm_bounded = norm_square;
    }

    /* norm: their length [1] */
    const float norm = sqrtf(norm_bounded);

    /* column: cos >= 0 and sin of half the angle, unscaled [1] */
    float column_0, column_1;
    if (twice_0 >= 0.0F) {
        column_0 = norm + twice_0;
        column_1 = twice_1;
    } else if (twice_1 >= 0.0F) {
        column_0 = twice_1;
        column_1 = norm - twice_0;
    } else {
        column_0 = -twice_1;
        column_1 = twice_0 - norm;
    }

    /* column_square: squared length [1] */
    const float column_square = column_0*column_0 + column_1*column_1;

    /* column_bounded: the same [1] */
    float column_bounded;
    if (column_square <= 3.0F) {
        column_bounded = 3.0F;
    } else {
        column_bounded = column_square;
    }

    /* scale: to unit length [1] */
    const float scale = 1.0F/sqrtf(column_bounded);

    /* cosine: cos of half the error angle, rounded [1] */
    const float cosine = column_0*scale;

    /* w: cos of half the error angle [1] */
    float w;
    if (cosine >= 1.0F) {
        w = 1.0F;
    } else {
        w = cosine;
    }

    /* sine: sin of half the error angle [1] */
    const float sine = column_1*scale;

    /* k: half angle over its sine [1] */
    const float k = hovercraft_f32_k(w);

    /* h: -dk/dw [1] */
    const float h = hovercraft_f32_h(w);

    /* phi: rotation vector of the error [rad] */
    const float phi_0 = 2.0F*k*sine;

    /* half: 1/(2 k) [1] */
    const float half = 0.5F/k;

    /* turned_p: p turned back by half the angle [m] */
    const float turned_p_0 = g_2*w + g_5*sine;
    const float turned_p_1 = g_5*w - g_2*sine;

    /* rho_p: p - k Y p + h Y Y p [m] */
    const float rho_p_0 = k*turned_p_0;
    const float rho_p_1 = k*turned_p_1;

    /* y_p: rho/(2 k) [m] */
    const float y_p_0 = half*rho_p_0;
    const float y_p_1 = half*rho_p_1;

    /* turn: Y nu_e, Y = ad of y [rad/s, m/s] */
    const float turn_1 = nu_0*y_p_1 - nu_2*sine;
    const float turn_2 = nu_1*sine - nu_0*y_p_0;

    /* bend: Y Y nu_e [rad/s, m/s] */
    const float bend_1 = -sine*turn_2;
    const float bend_2 = sine*turn_1;

    /* nu_u_dot: exact rate of nu_u [rad/s, m/s] */
    const float nu_u_dot_1 = nu_1 + bend_1*h + k*turn_1;
    const float nu_u_dot_2 = nu_2 + bend_2*h + k*turn_2;

    /* drive: lambda nu_u [rad/s, m/s] */
    const float drive_0 = phi_0*rate_gain;
    const float drive_1 = rate_gain*rho_p_0;
    const float drive_2 = rate_gain*rho_p_1;

    /* s: sliding variable [rad/s, m/s], eq. (sldS) */
    const float s_0 = drive_0 + nu_0;
    const float s_1 = drive_1 + nu_1;
    const float s_2 = drive_2 + nu_2;

    /* wanted: acceleration asked for [rad/s^2, m/s^2] */
    const float wanted_0 = -(nu_0*rate_gain + reach_gain*s_0);
    const float wanted_1 = -(nu_u_dot_1*rate_gain + reach_gain*s_1);
    const float wanted_2 = -(nu_u_dot_2*rate_gain + reach_gain*s_2);

    /* momentum: I nu [N m s, N s] */
    const float momentum_1 = inertia_3*nu_1;
    const float momentum_2 = inertia_2*nu_0 + inertia_5*nu_2;

    /* force: control force, I f_u [N m, N], eq. (Ctrl2) */
    const float force_0 = drive_2*momentum_1 + inertia_0*wanted_0 + inertia_2*wanted_2 -
        drive_1*momentum_2;
    const float force_1 = drive_0*momentum_2 + inertia_3*wanted_1;
    const float force_2 = inertia_2*wanted_0 + inertia_5*wanted_2 - drive_0*momentum_1;

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

void hovercraft_f32_plant(const hovercraft_f32_params *params, const hovercraft_f32_state *state,
        const float force[3], float nu_dot[3])
{
    /* -- plant -- */
    const float inertia_0 = params->inertia[0], inertia_2 = params->inertia[2],
        inertia_3 = params->inertia[3], inertia_5 = params->inertia[5];
    const float nu_0 = state->nu[0], nu_1 = state->nu[1], nu_2 = state->nu[2];
    const float force_0 = force[0], force_1 = force[1], force_2 = force[2];

    /* momentum: I nu [N m s, N s] */
    const float momentum_1 = inertia_3*nu_1;
    const float momentum_2 = inertia_2*nu_0 + inertia_5*nu_2;

    /* total: coad(nu) I nu + force [N m, N] */
    const float total_0 = force_0 + momentum_1*nu_2 - momentum_2*nu_1;
    const float total_1 = force_1 + momentum_2*nu_0;
    const float total_2 = force_2 - momentum_1*nu_0;

    /* lower_20: I = L D L^T, entry of L [1] */
    const float lower_20 = inertia_2/inertia_0;

    /* pivot_2: pivot of I [kg m^2, kg m, kg] */
    const float pivot_2 = inertia_5 - inertia_0*lower_20*lower_20;

    /* forward_2: forward substitution [N m, N] */
    const float forward_2 = total_2 - lower_20*total_0;

    /* back_2: back substitution [rad/s^2, m/s^2] */
    const float back_2 = forward_2/pivot_2;

    /* back_1: back substitution [rad/s^2, m/s^2] */
    const float back_1 = total_1/inertia_3;

    /* back_0: back substitution [rad/s^2, m/s^2] */
    const float back_0 = total_0/inertia_0 - back_2*lower_20;

    /* -- end -- */
    nu_dot[0] = back_0;
    nu_dot[1] = back_1;
    nu_dot[2] = back_2;
}

/* The worse of two findings. */
static hovercraft_f32_status hovercraft_f32_worse(const hovercraft_f32_status a,
        const hovercraft_f32_status b)
{
    return a > b ? a : b;
}

/* OUT_OF_RANGE or NONFINITE_INPUT if any number is larger than a limit or not finite. */
static hovercraft_f32_status hovercraft_f32_inspect(const float *numbers, const int count,
        const float limit)
{
    hovercraft_f32_status worst = HOVERCRAFT_F32_OK;
    int i;
    for (i = 0; i < count; i++) {
        if (!isfinite(numbers[i])) {
            worst = HOVERCRAFT_F32_NONFINITE_INPUT;
        } else if (fabsf(numbers[i]) > limit) {
            worst = hovercraft_f32_worse(worst, HOVERCRAFT_F32_OUT_OF_RANGE);
        } else {
            /* finite and in range: it leaves the finding as it is */
        }
    }
    return worst;
}

/* Zero command; its status says what is wrong with what was refused, at least what was found. */
static hovercraft_f32_status hovercraft_f32_refuse(const hovercraft_f32_state *state,
        const hovercraft_f32_reference *reference, const hovercraft_f32_status found,
        hovercraft_f32_command *command)
{
    hovercraft_f32_status worst = found;
    worst = hovercraft_f32_worse(worst,
            hovercraft_f32_inspect(state->g, 9, HOVERCRAFT_F32_MAX_INPUT));
    worst = hovercraft_f32_worse(worst,
            hovercraft_f32_inspect(state->nu, 3, HOVERCRAFT_F32_MAX_INPUT));
    worst = hovercraft_f32_worse(worst,
            hovercraft_f32_inspect(reference->g, 9, HOVERCRAFT_F32_MAX_INPUT));
    worst = hovercraft_f32_worse(worst,
            hovercraft_f32_inspect(reference->nu, 3, HOVERCRAFT_F32_MAX_INPUT));
    worst = hovercraft_f32_worse(worst,
            hovercraft_f32_inspect(reference->nu_dot, 3, HOVERCRAFT_F32_MAX_INPUT));
    hovercraft_f32_nothing(command);
    return worst;
}

/* What a computed command is worth, given its distance from the cut locus of the law. */
static hovercraft_f32_status hovercraft_f32_verdict(const float clearance,
        hovercraft_f32_command *command)
{
    if (!(isfinite(command->force[0]) && isfinite(command->force[1]) &&
            isfinite(command->force[2]))) {
        hovercraft_f32_nothing(command);
        return HOVERCRAFT_F32_NONFINITE_INPUT;
    }
    return clearance < HOVERCRAFT_F32_NEAR_CUT ? HOVERCRAFT_F32_NEAR_CUT_LOCUS : HOVERCRAFT_F32_OK;
}

hovercraft_f32_status hovercraft_f32_control(const hovercraft_f32_params *params,
        const hovercraft_f32_state *state, const hovercraft_f32_reference *reference,
        hovercraft_f32_command *command)
{
    float clearance;
#ifdef HOVERCRAFT_CHECK_POINTERS
    if (params == NULL || state == NULL || reference == NULL || command == NULL) {
        if (command != NULL) {
            hovercraft_f32_nothing(command);
        }
        return HOVERCRAFT_F32_BAD_PARAMS;
    }
#endif
    /* -- tracking -- */
    const float g_0 = state->g[0], g_1 = state->g[1], g_2 = state->g[2], g_3 = state->g[3],
        g_4 = state->g[4], g_5 = state->g[5];
    const float g_r_0 = reference->g[0], g_r_1 = reference->g[1], g_r_2 = reference->g[2],
        g_r_3 = reference->g[3], g_r_4 = reference->g[4], g_r_5 = reference->g[5];

    /* gap_0: translation of g from g_r [m] */
    const float gap_0_0 = g_2 - g_r_2;
    const float gap_0_1 = g_5 - g_r_5;

    /* g_e: error, g_r^-1 g [1], eq. (velErr) */
    const float g_e_0 = g_0*g_r_0 + g_3*g_r_3;
    const float g_e_1 = g_1*g_r_0 + g_4*g_r_3;
    const float g_e_2 = g_r_0*gap_0_0 + g_r_3*gap_0_1;
    const float g_e_3 = g_0*g_r_1 + g_3*g_r_4;
    const float g_e_4 = g_1*g_r_1 + g_4*g_r_4;
    const float g_e_5 = g_r_1*gap_0_0 + g_r_4*gap_0_1;

    /* -- end -- */
    if (!(fabsf(g_e_0) <= HOVERCRAFT_F32_MAX_ENTRY && fabsf(g_e_1) <= HOVERCRAFT_F32_MAX_ENTRY
            && fabsf(g_e_2) <= HOVERCRAFT_F32_MAX_REACH && fabsf(g_e_3) <= HOVERCRAFT_F32_MAX_ENTRY
            && fabsf(g_e_4) <= HOVERCRAFT_F32_MAX_ENTRY && fabsf(g_e_5) <= HOVERCRAFT_F32_MAX_REACH
            && fabsf(state->g[2]) <= HOVERCRAFT_F32_MAX_INPUT
            && fabsf(state->g[5]) <= HOVERCRAFT_F32_MAX_INPUT
            && fabsf(state->nu[0]) <= HOVERCRAFT_F32_MAX_INPUT
            && fabsf(state->nu[1]) <= HOVERCRAFT_F32_MAX_INPUT
            && fabsf(state->nu[2]) <= HOVERCRAFT_F32_MAX_INPUT
            && fabsf(reference->g[2]) <= HOVERCRAFT_F32_MAX_INPUT
            && fabsf(reference->g[5]) <= HOVERCRAFT_F32_MAX_INPUT
            && fabsf(reference->nu[0]) <= HOVERCRAFT_F32_MAX_INPUT
            && fabsf(reference->nu[1]) <= HOVERCRAFT_F32_MAX_INPUT
            && fabsf(reference->nu[2]) <= HOVERCRAFT_F32_MAX_INPUT
            && fabsf(reference->nu_dot[0]) <= HOVERCRAFT_F32_MAX_INPUT
            && fabsf(reference->nu_dot[1]) <= HOVERCRAFT_F32_MAX_INPUT
            && fabsf(reference->nu_dot[2]) <= HOVERCRAFT_F32_MAX_INPUT)) {
        if (fabsf(g_e_2) <= HOVERCRAFT_F32_MAX_REACH && fabsf(g_e_5) <= HOVERCRAFT_F32_MAX_REACH) {
            return hovercraft_f32_refuse(state, reference, HOVERCRAFT_F32_NOT_ON_GROUP, command);
        }
        return hovercraft_f32_refuse(state, reference, HOVERCRAFT_F32_OUT_OF_RANGE, command);
    }
    /* -- drift -- */
    const float g_6 = state->g[6], g_7 = state->g[7], g_8 = state->g[8];
    const float g_r_6 = reference->g[6], g_r_7 = reference->g[7], g_r_8 = reference->g[8];

    /* off: what vanishes on the group, and only there [1] */
    const float off_0 = g_e_0*g_e_0 - 1.0F + g_e_3*g_e_3;
    const float off_1 = g_e_1 + g_e_3;
    const float off_2 = g_e_4 - g_e_0;
    const float off_5 = g_8 - 1.0F;
    const float off_8 = g_r_8 - 1.0F;

    /* drift: square of the distance from the group [1] */
    const float drift = g_6*g_6 + g_7*g_7 + g_r_6*g_r_6 + g_r_7*g_r_7 + off_0*off_0 + off_1*off_1 +
        off_2*off_2 + off_5*off_5 + off_8*off_8;

    /* -- end -- */

    if (!(drift < params->max_drift*params->max_drift)) {
        return hovercraft_f32_refuse(state, reference, HOVERCRAFT_F32_NOT_ON_GROUP, command);
    }
    clearance = hovercraft_f32_law(params, state, reference, command, g_e_0, g_e_1, g_e_2, g_e_3,
            g_e_4, g_e_5);
    return hovercraft_f32_verdict(clearance, command);
}

hovercraft_f32_status hovercraft_f32_check_params(const hovercraft_f32_params *params)
{
#ifdef HOVERCRAFT_CHECK_POINTERS
    if (params == NULL) {
        return HOVERCRAFT_F32_BAD_PARAMS;
    }
#endif
    float pivot[3];
    int i;
    if (hovercraft_f32_inspect(params->inertia, 6, HOVERCRAFT_F32_MAX_PARAM) != HOVERCRAFT_F32_OK) {
        return HOVERCRAFT_F32_BAD_PARAMS;
    }
    if (!(params->lambda >= HOVERCRAFT_F32_MIN_GAIN && params->lambda <= HOVERCRAFT_F32_MAX_RATE)) {
        return HOVERCRAFT_F32_BAD_PARAMS;
    }
    if (!(params->k_s >= HOVERCRAFT_F32_MIN_GAIN && params->k_s <= HOVERCRAFT_F32_MAX_RATE)) {
        return HOVERCRAFT_F32_BAD_PARAMS;
    }
    if (!(params->max_drift >= HOVERCRAFT_F32_LEAST_DRIFT && params->max_drift <=
            HOVERCRAFT_F32_MOST_DRIFT)) {
        return HOVERCRAFT_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[1]) > 0.0F) {
        return HOVERCRAFT_F32_BAD_PARAMS;
    }
    if (fabsf(params->inertia[4]) > 0.0F) {
        return HOVERCRAFT_F32_BAD_PARAMS;
    }
    hovercraft_f32_definiteness(params, pivot);
    for (i = 0; i < 3; i++) {
        if (!(pivot[i] > 0.0F)) {
            return HOVERCRAFT_F32_BAD_PARAMS;
        }
    }
    return HOVERCRAFT_F32_OK;
}
