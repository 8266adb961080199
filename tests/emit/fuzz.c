/*
 * Calls `control` on bit patterns from a fixed seed and judges what comes back by itself.
 * HEADER, PREFIX, MACRO, REAL, BITS, STORED, DIM, FIELDS, ROWS, HAS_REFERENCE, HAS_RESIDUAL and
 * HAS_LIMIT come from the command line, ELEMENTS and their number from elements.h. Prints how often a status came back.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include HEADER
#include "elements.h"

#define JOIN_(a, b) a##_##b
#define JOIN(a, b) JOIN_(a, b)
#define NAME(x) JOIN(PREFIX, x)
#define LIMIT(x) JOIN(MACRO, x)

enum {
    STATE = sizeof(NAME(state)) / sizeof(REAL), /* g, nu, and what else the state holds */
    WIDTH = STATE + STORED + 2 * DIM,
    COMMAND = FIELDS * DIM
};

typedef struct {
    REAL x[WIDTH]; /* the state, then g_r, nu_r, nu_r_dot */
} input;

static uint64_t seed = UINT64_C(0x9e3779b97f4a7c15);

static uint64_t draw(void)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return seed;
}

static REAL any_bits(void)
{
    const BITS bits = (BITS)(draw() >> (64 - 8 * sizeof(BITS)));
    REAL value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static REAL moderate(void)
{
    return (REAL)((double)(draw() >> 11) * 0x1p-53 * 4.0 - 2.0);
}

/* Elements of the group, at pi and at the far end of S3 too, and moderate velocities. */
static input valid(void)
{
    input in;
    int i;
    for (i = 0; i < WIDTH; i++) {
        in.x[i] = moderate();
    }
    memcpy(in.x, ELEMENTS[draw() % COUNT], sizeof(REAL) * STORED);
    memcpy(in.x + STATE, ELEMENTS[draw() % COUNT], sizeof(REAL) * STORED);
    return in;
}

static void flip(input *in)
{
    const int place = (int)(draw() % WIDTH);
    BITS bits;
    memcpy(&bits, &in->x[place], sizeof bits);
    bits ^= (BITS)1 << (draw() % (8 * sizeof(BITS)));
    memcpy(&in->x[place], &bits, sizeof bits);
}

static input row(int kind)
{
    input in = valid();
    int i;
    if (kind == 0) { /* nothing but noise */
        for (i = 0; i < WIDTH; i++) {
            in.x[i] = any_bits();
        }
    } else if (kind == 1) { /* on the group, the velocities any bits that are in range */
        for (i = STORED; i < WIDTH; i += i + 1 == STATE ? STORED + 1 : 1) {
            const REAL value = any_bits();
            in.x[i] = fabs((double)value) <= (double)LIMIT(MAX_INPUT) ? value : (REAL)i;
        }
    } else if (kind == 2) { /* one bit wrong */
        flip(&in);
    }
    return in;
}

/* 18, 17 or 0, from the numbers alone. */
static int judged(const input *in)
{
    int worst = 0;
    int i;
    for (i = 0; i < (HAS_REFERENCE ? WIDTH : STATE); i++) {
        const double size = fabs((double)in->x[i]);
        const int one = !isfinite(size) ? 18 : size > (double)LIMIT(MAX_INPUT) ? 17 : 0;
        worst = one > worst ? one : worst;
    }
    return worst;
}

static int called(const input *in, NAME(command) *command)
{
    NAME(state) state;
    memcpy(&state, in->x, sizeof state);
#if HAS_REFERENCE
    NAME(reference) reference;
    memcpy(&reference, in->x + STATE, sizeof reference);
#if HAS_SIDE
    NAME(side) side;
    side.sign = any_bits();
    return (int)NAME(control)(&NAME(defaults), &state, &reference, &side, command);
#else
    return (int)NAME(control)(&NAME(defaults), &state, &reference, command);
#endif
#else
    return (int)NAME(control)(&NAME(defaults), &state, command);
#endif
}

/* A force is within its limits; it is at one of them where it was cut. */
static int is_cut_wrong(int status, const NAME(command) *command)
{
#if HAS_LIMIT
    int i, at = 0, wrong = 0;
    for (i = 0; i < DIM; i++) {
        const double size = fabs((double)command->force[i]);
        const double limit = (double)NAME(defaults).force_limit[i];
        wrong |= !(size <= limit);
        at |= size >= limit * (1 - 1e-6);
    }
    return wrong || (status == 1 && !at);
#else
    (void)command;
    return status == 1; /* nothing saturates */
#endif
}

static int is_wrong(const input *in, int status, const NAME(command) *command)
{
    REAL out[COMMAND];
    const int found = judged(in);
    const int last = HAS_RESIDUAL ? 17 : 18; /* what no residual bounds may overflow */
    int wrong = found ? status != found : status > last || (status > 2 && status < 16);
    int i;
    wrong |= is_cut_wrong(status, command);
    memcpy(out, command, sizeof out);
    for (i = 0; i < COMMAND; i++) {
        wrong |= !isfinite(out[i]) || (status >= 16 && out[i] != 0);
    }
    return wrong;
}

int main(void)
{
    long counts[32] = {0};
    int i;
    for (i = 0; i < ROWS; i++) {
        const input in = row(i % 4);
        NAME(command) command;
        memset(&command, 0xff, sizeof command); /* what is not written is not a number */
        const int status = called(&in, &command);
        if (status < 0 || status > 31 || is_wrong(&in, status, &command)) {
            int k;
            printf("row %d: status %d, expected %d, from\n", i, status, judged(&in));
            for (k = 0; k < WIDTH; k++) {
                printf("  %a\n", (double)in.x[k]);
            }
            return 1;
        }
        counts[status]++;
    }
    for (i = 0; i < 32; i++) {
        if (counts[i]) {
            printf("%d %ld\n", i, counts[i]);
        }
    }
    return 0;
}
