/* SPDX-License-Identifier: MIT
 * Times of jkr.h beside the ways of discrete element codes, in one run: nanoseconds a call, the fastest of many rounds in which all
 * take turns, the ratio to the quartic, and the largest relative error of a. `bench [rounds]` */
#ifndef _POSIX_C_SOURCE
#define _POSIX_C_SOURCE 199309L
#endif
#include "jkr.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { COUNT = 4096 };

static double depths[COUNT], pulled[COUNT], forces[COUNT], radii[COUNT], cycle[COUNT];
static double a_c, depth, load;
static jkr_contact contact, receding;
static jkr_fast fast, fast_receding;

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return 1e9 * (double)time.tv_sec + (double)time.tv_nsec;
}

/* a(d) by Ferrari's solution of u^4 - 4 u = d/D, as in textbooks. */
static double quartic(double d)
{
    double delta = d / depth, r = sqrt(64 + 64.0 / 27 * delta * delta * delta), y = cbrt(8 + r) + cbrt(8 - r), s = sqrt(y);
    r = 0.5 * (s + sqrt(-y + 8 / s));
    return a_c * r * r;
}

/* a(d) by Newton's method from above, until a step is below 1e-15. */
static double newton(double d)
{
    double delta = d / depth, u = 1.2 + sqrt(sqrt(delta + 3)), step;
    int i;
    for (i = 0; i < 60; i++) {
        step = (u * (u * u * u - 4) - delta) / (4 * (u * u * u - 1));
        u -= step;
        if (fabs(step) < 1e-15 * u)
            break;
    }
    return a_c * u * u;
}

/* a(F) in closed form. */
static double closed_form(double force)
{
    double v = 3 + sqrt(9 + 6 * force / load);
    return a_c * cbrt(v * v);
}

typedef double (*way)(int i);

static jkr_state state;

static double at_indentation(int i) { jkr_at_indentation(&contact, depths[i], JKR_STABLE, &state); return state.contact_radius; }
static double unstable(int i) { jkr_at_indentation(&contact, pulled[i], JKR_UNSTABLE, &state); return state.contact_radius; }
static double at_force(int i) { jkr_at_force(&contact, forces[i], JKR_STABLE, &state); return state.contact_radius; }
static double at_radius(int i) { jkr_at_contact_radius(&contact, radii[i], &state); return state.contact_radius; }
static double follow(int i)
{
    jkr_follow(&contact, &receding, i ? state.contact_radius : 0, cycle[i], &state);
    return state.contact_radius;
}
static double fast_at_indentation(int i) { jkr_fast_at_indentation(&fast, depths[i], JKR_STABLE, &state); return state.contact_radius; }
static double fast_unstable(int i) { jkr_fast_at_indentation(&fast, pulled[i], JKR_UNSTABLE, &state); return state.contact_radius; }
static double fast_at_force(int i) { jkr_fast_at_force(&fast, forces[i], JKR_STABLE, &state); return state.contact_radius; }
static double fast_at_radius(int i) { jkr_fast_at_contact_radius(&fast, radii[i], &state); return state.contact_radius; }
static double fast_follow(int i)
{
    jkr_fast_follow(&fast, &fast_receding, i ? state.contact_radius : 0, cycle[i], &state);
    return state.contact_radius;
}
static double by_quartic(int i) { return quartic(depths[i]); }
static double by_newton(int i) { return newton(depths[i]); }
static double by_closed_form(int i) { return closed_form(forces[i]); }

static const struct {
    const char *name;
    way run;
    way exact; /* what its contact radii are compared with */
} ways[] = {
    { "quartic, a(d)", by_quartic, at_indentation },
    { "Newton, a(d)", by_newton, at_indentation },
    { "closed form, a(F)", by_closed_form, at_force },
    { "jkr_fast_at_indentation, all four", fast_at_indentation, at_indentation },
    { "  on the unstable branch", fast_unstable, unstable },
    { "jkr_fast_at_force, all four", fast_at_force, at_force },
    { "jkr_fast_at_contact_radius, all four", fast_at_radius, at_radius },
    { "jkr_fast_follow, all four", fast_follow, NULL },
    { "jkr_at_indentation, all four", at_indentation, NULL },
    { "  on the unstable branch", unstable, NULL },
    { "jkr_at_force, all four", at_force, NULL },
    { "jkr_at_contact_radius, all four", at_radius, NULL },
    { "jkr_follow, all four", follow, NULL },
};

enum { WAYS = sizeof ways / sizeof ways[0] };

/* Half of the values near the fold, half up to 17 D above it; a cycle pressed to 15 D and drawn to the fold of the receding edge. */
static void choose(void)
{
    int i;
    srand(1);
    for (i = 0; i < COUNT; i++) {
        double q = rand() / (RAND_MAX + 1.0), z = pow(10, -12 + 14 * q);
        depths[i] = depth * (i & 1 ? -3 + z : -3 + 20 * q);
        pulled[i] = depths[i] < 0 ? depths[i] : -2 * depth;
        forces[i] = load * (i & 1 ? -1.5 + z : -1.5 + 20 * q);
        radii[i] = a_c * pow(10, -1 + 3 * q);
        cycle[i] = depth * (15 - 21 * fabs(1 - 2.0 * i / COUNT));
    }
}

static double largest_error(way run, way exact)
{
    double worst = 0, error;
    int i;
    for (i = 0; i < COUNT; i++) {
        const double found = run(i), right = exact(i);
        if (right > 0) {
            error = fabs(found / right - 1);
            if (!(error <= worst))
                worst = error;
        }
    }
    return worst;
}

int main(int count, char **arguments)
{
    static const double far[] = { -3 + 1e-10, -1, 1e5, 1e10 };
    const int rounds = count > 1 ? atoi(arguments[1]) : 40;
    double best[WAYS], sum = 0;
    int k, round, i;
    jkr_set(&contact, 1.3e-6, 7.1e9, 0.051);
    jkr_set(&receding, 1.3e-6, 7.1e9, 3 * 0.051);
    jkr_fast_set(&fast, &contact);
    jkr_fast_set(&fast_receding, &receding);
    a_c = fast.a_c;
    depth = fast.d_c;
    load = 6 * fast.sixth_p;
    choose();
    for (k = 0; k < WAYS; k++)
        best[k] = HUGE_VAL;
    for (round = 0; round < rounds; round++)
        for (k = 0; k < WAYS; k++) {
            const double start = now();
            double time;
            for (i = 0; i < COUNT; i++)
                sum += ways[k].run(i);
            time = (now() - start) / COUNT;
            if (time < best[k])
                best[k] = time;
        }
    printf("%-38s %8s %8s   %s\n", "", "ns", "/quartic", "largest relative error of a");
    for (k = 0; k < WAYS; k++) {
        printf("%-38s %8.1f %8.2f   ", ways[k].name, best[k], best[k] / best[0]);
        if (ways[k].exact)
            printf("%.1e\n", largest_error(ways[k].run, ways[k].exact));
        else
            printf("%s\n", k > 7 ? "rounded once" : "as at_indentation");
    }
    printf("\nd/D                    quartic    Newton   jkr_fast: relative error of a\n");
    for (i = 0; i < 4; i++) {
        const double d = far[i] * depth;
        double right, quick;
        jkr_at_indentation(&contact, d, JKR_STABLE, &state);
        right = state.contact_radius;
        jkr_fast_at_indentation(&fast, d, JKR_STABLE, &state);
        quick = state.contact_radius;
        printf("%-20.13g %9.1e %9.1e %9.1e\n", far[i], fabs(quartic(d) / right - 1), fabs(newton(d) / right - 1), fabs(quick / right - 1));
    }
    return sum > 0 ? 0 : 1;
}
