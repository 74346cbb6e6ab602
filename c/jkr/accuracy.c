/* SPDX-License-Identifier: MIT
 * Random questions to jkr.h with its answers, for accuracy.py: `accuracy N SEED`, one record of twelve hexadecimal numbers a line.
 * Scales are 10^+-12, 10^+-60, 10^+-150 or 10^+-307; values lie about folds and about zeros of d, F and dF/dd, down to
 * neighbouring doubles, and far away. */
#include "jkr.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static uint64_t seed = UINT64_C(88172645463325252);

static uint64_t random_bits(void)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return seed;
}

static int coin(void) { return (int)(random_bits() >> 20 & 1); }
static double uniform(double from, double to) { return from + (to - from) * ((double)(random_bits() >> 11) / 9007199254740992.0); }
static double decades(double from, double to) { return pow(10, uniform(from, to)); }
static double value(jkr_pair x) { return ldexp(x.high, x.exponent); }

/* x or one of its three neighbours on each side. */
static double neighbour(double x)
{
    int steps = (int)(random_bits() % 7) - 3;
    for (; steps > 0; steps--)
        x = nextafter(x, HUGE_VAL);
    for (; steps < 0; steps++)
        x = nextafter(x, -HUGE_VAL);
    return x;
}

static double near_to(double x)
{
    const double t = decades(-17, 0) * (coin() ? 1 : -1);
    return fabs(t) < 1e-14 ? neighbour(x * (1 + t)) : x * (1 + t);
}

static double far_from(double scale, double far)
{
    return scale * (coin() ? decades(-20, coin() ? 4 : far) * (coin() ? 1 : -1) : uniform(-3, 6));
}

enum { AT_CONTACT_RADIUS, AT_INDENTATION, AT_FORCE, FOLD, FOLLOW };

int main(int count, char **arguments)
{
    static const double radii[] = { 1, 9, 16, 36 }, depths[] = { -27, -3, 48 }, loads[] = { -9, -8, -5 };
    long n = count > 1 ? atol(arguments[1]) : 1000, i;
    seed ^= (uint64_t)(count > 2 ? atol(arguments[2]) : 0) * UINT64_C(0x9E3779B97F4A7C15);
    for (i = 0; i < n; i++) {
        const double range = random_bits() % 3 ? 12 : coin() ? 60 : coin() ? 150 : 307;
        const int question = (int)(random_bits() % 5);
        double R = decades(-range, range), E = decades(-range, range), w = decades(-range, range), x = 0, a0 = 0, w1 = 0;
        jkr_contact contact, advancing;
        jkr_state state;
        int branch = coin(), status;
        jkr_set(&contact, R, E, w);
        if (question == AT_CONTACT_RADIUS) {
            x = value(contact.a_c) * (coin() ? decades(-8, 8) : near_to(cbrt(radii[random_bits() % 4])));
            if (!(x > DBL_MIN && x < DBL_MAX))
                continue;
            status = jkr_at_contact_radius(&contact, x, &state);
        } else if (question == AT_INDENTATION) {
            x = value(contact.d_c);
            x = coin() ? near_to(cbrt(depths[random_bits() % 3]) * x) : far_from(x, 45);
            if (branch == JKR_UNSTABLE)
                x = -fabs(x);
            if (!(fabs(x) > DBL_MIN && fabs(x) < DBL_MAX))
                continue;
            status = jkr_at_indentation(&contact, x, branch, &state);
        } else if (question == AT_FORCE) {
            x = value(contact.p) / 6;
            x = coin() ? near_to(loads[random_bits() % 3] * x) : far_from(x, 60);
            if (branch == JKR_UNSTABLE)
                x = -fabs(x);
            if (!(fabs(x) > DBL_MIN && fabs(x) < DBL_MAX))
                continue;
            status = jkr_at_force(&contact, x, branch, &state);
        } else if (question == FOLD)
            status = jkr_fold(&contact, branch, &state);
        else {
            w1 = w * (coin() ? uniform(0, 1) : decades(-9, 0));
            jkr_set(&advancing, R, E, w1);
            a0 = value(contact.a_c) * (coin() ? decades(-2, 2) : uniform(0.9, 4));
            x = a0 * a0 / R - sqrt(2 * 3.141592653589793 * a0) * sqrt((coin() ? w1 : w) / E) * (1 + decades(-17, 0) * (coin() ? 1 : -1));
            if (!(fabs(x) > 1e-290 && fabs(x) < 1e300 && a0 > 1e-290 && a0 < 1e300))
                continue;
            status = jkr_follow(&advancing, &contact, a0, x, &state);
        }
        printf("%d %d %d %a %a %a %a %a %a %a %a %a %a\n", question, branch, status, R, E, w, w1, a0, x, state.contact_radius,
               state.indentation, state.force, state.stiffness);
    }
    return 0;
}
