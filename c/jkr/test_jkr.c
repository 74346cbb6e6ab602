/* SPDX-License-Identifier: MIT
 * Checks of jkr.h, C99 or C++11: against certified values (certified.h, made by scripts/jkr_values.py from `mdr solve`), the
 * statuses, round trips, histories with two works of adhesion, any bit patterns, and the fast functions against the exact ones. */
#include "jkr.h"

#include "certified.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

static long checks, failures;

#define CHECK(condition)                                                                                                        \
    do {                                                                                                                        \
        checks++;                                                                                                               \
        if (!(condition) && ++failures <= 20)                                                                                   \
            printf("%s:%d: fails: %s\n", __FILE__, __LINE__, #condition);                                                       \
    } while (0)

/* ---- Random numbers: xorshift, the same on every machine ---- */

static uint64_t seed = UINT64_C(88172645463325252);

static uint64_t random_bits(void)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return seed;
}

static double uniform(double from, double to) { return from + (to - from) * ((double)(random_bits() >> 11) / 9007199254740992.0); }

/* 10 to a uniform power. */
static double decades(double from, double to) { return pow(10, uniform(from, to)); }

static double value(jkr_pair x) { return ldexp(x.high, x.exponent); }

/* ---- Against certified values ---- */

/* The distance from the certified value, the sum of two doubles, in units in the last place. */
static double ulps(double found, const double certified[2])
{
    int exponent;
    if (fabs(certified[0]) > DBL_MAX || certified[0] == 0)
        return found == certified[0] ? 0 : HUGE_VAL;
    frexp(certified[0], &exponent);
    return fabs((found - certified[0]) - certified[1]) / ldexp(1.0, exponent - 53 < -1074 ? -1074 : exponent - 53);
}

static double worst[4];

static void check_member(int member, double found, const double certified[2], const struct certified_row *row, long index)
{
    double error = ulps(found, certified);
    /* The whole promise; the rounding of a subnormal number is a second one. */
    double limit = fabs(certified[0]) < DBL_MIN ? 1.0 : 0.51;
    if (!(error <= worst[member]))
        worst[member] = error;
    checks++;
    if (!(error <= limit) && ++failures <= 20)
        printf("row %ld, question %d at %.17g: member %d is %.17g, certified %.17g: %.3f units\n", index, row->question, row->value, member,
               found, certified[0], error);
}

static void check_certified(void)
{
    const long count = (long)(sizeof certified_rows / sizeof certified_rows[0]);
    long i;
    for (i = 0; i < count; i++) {
        const struct certified_row *row = &certified_rows[i];
        jkr_contact contact;
        jkr_state state;
        int status;
        CHECK(jkr_set(&contact, row->radius, row->modulus, row->work) == JKR_OK);
        if (row->question == AT_CONTACT_RADIUS)
            status = jkr_at_contact_radius(&contact, row->value, &state);
        else if (row->question == AT_INDENTATION)
            status = jkr_at_indentation(&contact, row->value, row->branch, &state);
        else if (row->question == AT_FORCE)
            status = jkr_at_force(&contact, row->value, row->branch, &state);
        else
            status = jkr_fold(&contact, row->branch, &state);
        checks++;
        if (status != row->status && ++failures <= 20)
            printf("row %ld, question %d at %.17g: %s instead of %s\n", i, row->question, row->value, jkr_status_name(status),
                   jkr_status_name(row->status));
        if (row->status == JKR_NO_EQUILIBRIUM)
            continue;
        if (row->question == AT_INDENTATION && row->status == JKR_FOLD)
            CHECK(state.indentation == row->value);
        else
            check_member(1, state.indentation, row->indentation, row, i);
        if (row->question == AT_FORCE && row->status == JKR_FOLD)
            CHECK(state.force == row->value);
        else
            check_member(2, state.force, row->force, row, i);
        check_member(0, state.contact_radius, row->contact_radius, row, i);
        check_member(3, state.stiffness, row->stiffness, row, i);
    }
    printf("%ld certified rows; largest errors, in units in the last place: a %.6f, d %.6f, F %.6f, dF/dd %.6f\n", count, worst[0],
           worst[1], worst[2], worst[3]);
}

/* ---- Statuses ---- */

static void check_statuses(void)
{
    const double nan = sqrt(-1.0);
    jkr_contact contact, other;
    jkr_fast fast;
    jkr_state state;
    CHECK(jkr_set(&contact, -1, 1, 1) == JKR_DOMAIN_ERROR);
    CHECK(jkr_at_indentation(&contact, 1, JKR_STABLE, &state) == JKR_DOMAIN_ERROR && state.force == 0);
    CHECK(jkr_fast_set(&fast, &contact) == JKR_DOMAIN_ERROR);
    CHECK(jkr_fast_at_indentation(&fast, 1, JKR_STABLE, &state) == JKR_DOMAIN_ERROR);
    CHECK(jkr_set(&contact, nan, 1, 1) == JKR_DOMAIN_ERROR);
    CHECK(jkr_set(&contact, 0, 1, 1) == JKR_DOMAIN_ERROR);
    CHECK(jkr_set(&contact, 1, HUGE_VAL, 1) == JKR_DOMAIN_ERROR);
    CHECK(jkr_set(&contact, 1, 1, -1) == JKR_DOMAIN_ERROR);
    CHECK(jkr_set(&contact, 1, 1, 1) == JKR_OK && jkr_fast_set(&fast, &contact) == JKR_OK);
    CHECK(jkr_at_indentation(&contact, nan, JKR_STABLE, &state) == JKR_DOMAIN_ERROR);
    CHECK(jkr_at_indentation(&contact, 1, 7, &state) == JKR_DOMAIN_ERROR);
    CHECK(jkr_fold(&contact, 7, &state) == JKR_DOMAIN_ERROR);
    CHECK(jkr_at_force(&contact, HUGE_VAL, JKR_STABLE, &state) == JKR_DOMAIN_ERROR);
    CHECK(jkr_fast_at_force(&fast, HUGE_VAL, JKR_STABLE, &state) == JKR_DOMAIN_ERROR);
    CHECK(jkr_fast_at_indentation(&fast, nan, JKR_STABLE, &state) == JKR_DOMAIN_ERROR);
    CHECK(jkr_fast_at_contact_radius(&fast, -1, &state) == JKR_DOMAIN_ERROR);
    CHECK(jkr_fast_at_indentation(&fast, 1e60, JKR_STABLE, &state) == JKR_INACCURATE && state.contact_radius == 0);
    CHECK(jkr_at_contact_radius(&contact, -1, &state) == JKR_DOMAIN_ERROR);
    CHECK(jkr_at_contact_radius(&contact, 0, &state) == JKR_OK && state.indentation == 0 && state.force == 0);
    CHECK(jkr_at_indentation(&contact, 0, JKR_UNSTABLE, &state) == JKR_NO_EQUILIBRIUM);
    CHECK(jkr_at_force(&contact, 0, JKR_UNSTABLE, &state) == JKR_NO_EQUILIBRIUM);
    /* Beyond the doubles, and the members that are within. */
    jkr_set(&contact, 1e150, 1e150, 1e150);
    CHECK(jkr_at_indentation(&contact, 1e150, JKR_STABLE, &state) == JKR_OVERFLOW && state.contact_radius > 1e149);
    CHECK(state.force > DBL_MAX && jkr_fast_set(&fast, &contact) == JKR_INACCURATE);
    jkr_set(&contact, 1e300, 5e-324, 1e-300);
    CHECK(jkr_at_force(&contact, 1, JKR_STABLE, &state) != JKR_NO_EQUILIBRIUM && state.contact_radius > 0);
    /* Hertz. */
    jkr_set(&other, 1, 1, 0);
    CHECK(jkr_at_indentation(&other, 4, JKR_STABLE, &state) == JKR_OK && state.contact_radius == 2 && state.stiffness == 4);
    CHECK(jkr_at_force(&other, 4.0 / 3 * 8, JKR_STABLE, &state) == JKR_OK && fabs(state.contact_radius - 2) <= DBL_EPSILON);
    CHECK(jkr_at_indentation(&other, -1, JKR_STABLE, &state) == JKR_NO_EQUILIBRIUM);
    CHECK(jkr_at_indentation(&other, 0, JKR_STABLE, &state) == JKR_FOLD && state.contact_radius == 0);
    jkr_fast_set(&fast, &other);
    CHECK(jkr_fast_at_indentation(&fast, 4, JKR_STABLE, &state) == JKR_OK && state.contact_radius == 2 && state.stiffness == 4);
    CHECK(jkr_fast_at_indentation(&fast, -1, JKR_STABLE, &state) == JKR_NO_EQUILIBRIUM);
    /* Two works of adhesion that are exchanged, and two moduli. */
    jkr_set(&contact, 1, 1, 1);
    CHECK(jkr_follow(&contact, &other, 1, 0, &state) == JKR_DOMAIN_ERROR);
    jkr_set(&other, 1, 2, 3);
    CHECK(jkr_follow(&contact, &other, 1, 0, &state) == JKR_DOMAIN_ERROR);
    CHECK(strcmp(jkr_status_name(JKR_NO_EQUILIBRIUM), "no-equilibrium") == 0 && strcmp(jkr_status_name(-1), "unknown") == 0);
}

/* ---- Folds and round trips of random contacts ---- */

static void check_branches(void)
{
    int i;
    for (i = 0; i < 100000; i++) {
        jkr_contact contact;
        jkr_state fold, found;
        double a;
        int branch;
        jkr_set(&contact, decades(-9, 9), decades(-9, 9), decades(-9, 9));
        CHECK(jkr_fold(&contact, JKR_INDENTATION, &fold) == JKR_FOLD);
        CHECK(jkr_at_indentation(&contact, fold.indentation * (1 + 1e-15), JKR_STABLE, &found) == JKR_NO_EQUILIBRIUM);
        CHECK(jkr_at_indentation(&contact, fold.indentation * (1 - 1e-15), JKR_STABLE, &found) == JKR_OK);
        CHECK(found.contact_radius >= fold.contact_radius);
        CHECK(jkr_at_indentation(&contact, fold.indentation, JKR_STABLE, &found) <= JKR_FOLD);
        CHECK(fabs(found.contact_radius / fold.contact_radius - 1) < 3e-8);
        CHECK(jkr_at_indentation(&contact, fold.indentation, JKR_UNSTABLE, &found) <= JKR_FOLD);
        CHECK(found.contact_radius <= fold.contact_radius);
        CHECK(jkr_fold(&contact, JKR_FORCE, &fold) == JKR_FOLD);
        CHECK(jkr_at_force(&contact, fold.force * (1 + 1e-15), JKR_STABLE, &found) == JKR_NO_EQUILIBRIUM);
        CHECK(jkr_at_force(&contact, fold.force * (1 - 1e-15), JKR_STABLE, &found) == JKR_OK);
        CHECK(found.contact_radius >= fold.contact_radius);
        CHECK(jkr_at_force(&contact, fold.force, JKR_STABLE, &found) <= JKR_FOLD);
        CHECK(fabs(found.contact_radius / fold.contact_radius - 1) < 3e-8);
        a = fold.contact_radius * decades(-3, 3);
        jkr_at_contact_radius(&contact, a, &fold);
        branch = a < value(contact.a_c) ? JKR_UNSTABLE : JKR_STABLE;
        CHECK(jkr_at_indentation(&contact, fold.indentation, branch, &found) <= JKR_FOLD);
        CHECK(fabs(found.contact_radius / a - 1) < 1e-7);
        branch = a < value(contact.a_c) * cbrt(9.0) ? JKR_UNSTABLE : JKR_STABLE;
        CHECK(jkr_at_force(&contact, fold.force, branch, &found) <= JKR_FOLD);
        CHECK(fabs(found.contact_radius / a - 1) < 1e-7);
    }
}

/* ---- Histories with two works of adhesion ---- */

/* The condition of the edge (1.8), (1.9) holds after every step, and a step that stands still changes nothing. */
static void check_step(const jkr_contact *contact1, const jkr_contact *contact2, int status, const jkr_state *state)
{
    const double a = state->contact_radius, d = state->indentation, R = contact1->radius, E = contact1->modulus;
    const double g = a * a / R, pi = 3.141592653589793;
    const double l1 = sqrt(2 * pi * a * contact1->work / E), l2 = sqrt(2 * pi * a * contact2->work / E);
    const double rounding = 1e-13 * (g + l2 + fabs(d));
    jkr_state again;
    /* At a fold a is known to the root of a rounding only. */
    CHECK(status == JKR_FOLD || g - d > l1 - rounding);
    CHECK(g - d < l2 + rounding);
    CHECK(fabs(state->force - 2 * E * (a * d - a * a * a / (3 * R))) <= 1e-13 * 2 * E * (a * fabs(d) + a * a * a / R));
    CHECK(jkr_follow(contact1, contact2, a, d, &again) != JKR_DETACHED);
    CHECK(fabs(again.contact_radius - a) <= (status == JKR_FOLD ? 1e-7 : 1e-15) * a);
}

static void check_histories(void)
{
    int i, j;
    for (i = 0; i < 20000; i++) {
        const double R = decades(-3, 3), E = decades(-3, 3), w2 = decades(-3, 3);
        const double w1 = i % 3 ? w2 * uniform(0, 1) : i & 1 ? 0 : w2;
        jkr_contact contact1, contact2;
        jkr_fast fast1, fast2;
        double a = 0, d = 0, depth;
        jkr_set(&contact1, R, E, w1);
        jkr_set(&contact2, R, E, w2);
        CHECK(jkr_fast_set(&fast1, &contact1) == JKR_OK && jkr_fast_set(&fast2, &contact2) == JKR_OK);
        depth = value(contact2.d_c);
        for (j = 0; j < 40; j++) {
            const double before = a;
            jkr_state state, fast;
            int status, fast_status;
            d = i % 5 == 0 && j % 9 == 0 ? 0 : d + 2 * depth * uniform(-1, 1.02);
            status = jkr_follow(&contact1, &contact2, before, d, &state);
            fast_status = jkr_fast_follow(&fast1, &fast2, before, d, &fast);
            a = state.contact_radius;
            CHECK(status == JKR_OK || status == JKR_DETACHED || status == JKR_FOLD);
            CHECK((status == JKR_DETACHED) == (a == 0) && state.indentation == d);
            CHECK(fast_status == status || status == JKR_FOLD || fast_status == JKR_FOLD);
            CHECK(fabs(fast.contact_radius - a) <= 8 * DBL_EPSILON * a);
            CHECK(fabs(fast.force - state.force) <= 8 * DBL_EPSILON * 2 * E * a * (fabs(d) + a * a / R));
            if (a == 0)
                CHECK(before > 0 ? d <= 0 : d <= 0);
            else
                check_step(&contact1, &contact2, status, &state);
        }
    }
}

/* Surfaces that meet without adhesion (w1 = 0), are pressed in and drawn apart: the least force is the pull-off force of w2, the
 * more exactly the smaller the step, and the state at the end does not depend on the number of steps. */
static void check_step_sizes(void)
{
    const double R = 1e-6, E = 1e9, w2 = 0.05;
    jkr_contact contact1, contact2;
    jkr_state fold, ended[4];
    double depth, pull_off;
    long steps, i;
    int k;
    jkr_set(&contact1, R, E, 0);
    jkr_set(&contact2, R, E, w2);
    jkr_fold(&contact2, JKR_FORCE, &fold);
    pull_off = -fold.force;
    jkr_fold(&contact2, JKR_INDENTATION, &fold);
    depth = -fold.indentation;
    for (k = 0, steps = 10; k < 4; k++, steps *= 10) {
        jkr_state state;
        double least = 0, h = 3.99 * depth / (double)steps;
        CHECK(jkr_follow(&contact1, &contact2, 0, 3 * depth, &state) == JKR_OK);
        for (i = 1; i <= steps; i++) {
            CHECK(jkr_follow(&contact1, &contact2, state.contact_radius, 3 * depth - 3.99 * depth * ((double)i / (double)steps), &state)
                  == JKR_OK);
            if (state.force < least)
                least = state.force;
        }
        /* Where F is least, v = 3, its curvature is (3/8) 3^(4/3) E* R/a_c, and a step is nearer than h. */
        CHECK(-least <= pull_off * (1 + 1e-15));
        CHECK(pull_off + least <= 0.5 * 1.6225 * E * R / fold.contact_radius * h * h);
        ended[k] = state;
        CHECK(fabs(ended[k].contact_radius - ended[0].contact_radius) <= 1e-12 * ended[0].contact_radius);
        CHECK(jkr_follow(&contact1, &contact2, state.contact_radius, -1.01 * depth, &state) == JKR_DETACHED);
    }
    CHECK(jkr_follow(&contact1, &contact2, 2 * fold.contact_radius, -1.01 * depth, &ended[0]) == JKR_DETACHED);
}

/* ---- Any bits: a status and no NaN ---- */

static int any_nan(const jkr_state *state)
{
    return state->contact_radius != state->contact_radius || state->indentation != state->indentation
           || state->force != state->force || state->stiffness != state->stiffness;
}

static void check_any_bits(void)
{
    long i;
    int j;
    for (i = 0; i < 1000000; i++) {
        double number[5];
        jkr_contact contact, larger;
        jkr_fast fast, fast_larger;
        jkr_state state;
        for (j = 0; j < 5; j++) {
            const uint64_t bits = random_bits();
            memcpy(&number[j], &bits, sizeof bits);
        }
        if (jkr_set(&contact, fabs(number[0]), fabs(number[1]), fabs(number[2])) != JKR_OK)
            continue;
        jkr_set(&larger, fabs(number[0]), fabs(number[1]), 3 * fabs(number[2]));
        jkr_fast_set(&fast, &contact);
        jkr_fast_set(&fast_larger, &larger);
        for (j = 0; j < 12; j++) {
            const int branch = j & 1;
            int status;
            if (j < 2)
                status = jkr_at_indentation(&contact, number[3], branch, &state);
            else if (j < 4)
                status = jkr_at_force(&contact, number[3], branch, &state);
            else if (j < 6)
                status = jkr_fast_at_indentation(&fast, number[3], branch, &state);
            else if (j < 8)
                status = jkr_fast_at_force(&fast, number[3], branch, &state);
            else if (j == 8)
                status = jkr_at_contact_radius(&contact, fabs(number[3]), &state);
            else if (j == 9)
                status = jkr_fast_at_contact_radius(&fast, fabs(number[3]), &state);
            else if (j == 10)
                status = jkr_follow(&contact, &larger, fabs(number[3]), number[4], &state);
            else
                status = jkr_fast_follow(&fast, &fast_larger, fabs(number[3]), number[4], &state);
            CHECK(!any_nan(&state));
            /* Beyond the doubles is said. */
            if (fabs(state.contact_radius) > DBL_MAX || fabs(state.indentation) > DBL_MAX || fabs(state.force) > DBL_MAX)
                CHECK(status == JKR_OVERFLOW);
            if (state.stiffness > DBL_MAX)
                CHECK(status == JKR_OVERFLOW || status == JKR_FOLD || status == JKR_UNDERFLOW);
        }
    }
}

/* ---- The fast functions against the exact ones ---- */

/* The largest errors in units of 2^-53 of what is promised: a relative, d and F to the sum of their parts, dF/dd by its condition. */
static double fast_worst[3][4];

static void compare_fast(int question, const jkr_contact *contact, const jkr_state *fast, const jkr_state *exact, int at_indentation)
{
    const double unit = DBL_EPSILON / 2, a = exact->contact_radius, x = a / value(contact->a_c), v = x * sqrt(x);
    const double depths = value(contact->d_c) * sqrt(x) * (v + 4), forces = value(contact->p) / 6 * v * (v + 6);
    const double condition = 1 + (at_indentation ? 0 : v / fabs(v - 1)) + (question == 2 ? 0 : 3 / fabs(v - 3));
    const double errors[4] = {
        fabs(fast->contact_radius - a) / (unit * a),
        fabs(fast->indentation - exact->indentation) / (unit * depths),
        fabs(fast->force - exact->force) / (unit * forces),
        fabs(fast->stiffness - exact->stiffness) / (unit * condition * fabs(exact->stiffness)),
    };
    int i;
    for (i = 0; i < 4; i++) {
        CHECK(errors[i] <= (i == 3 ? 48 : 16) || exact->stiffness == 0);
        if (errors[i] > fast_worst[question][i] && exact->stiffness != 0)
            fast_worst[question][i] = errors[i];
    }
}

/* A value near a special one, or anywhere on its scale. */
static double near_or_far(double special, double scale, double far)
{
    if (random_bits() & 1)
        return special * (1 - decades(-17, 0));
    return random_bits() & 1 ? scale * decades(-20, far) * (random_bits() & 1 ? 1 : -1) : scale * uniform(-3, 6);
}

static void check_fast(void)
{
    static const double depths[3] = { -3, -1.4422495703074083, 3.634241185664279 }, loads[3] = { -9, -8, -5 };
    static const double radii[4] = { 1, 2.080083823051904, 2.519842099789746, 3.3019272488946263 };
    long i;
    for (i = 0; i < 400000; i++) {
        jkr_contact contact;
        jkr_fast fast;
        jkr_state found, exact;
        const int branch = (int)(random_bits() & 1);
        double x;
        int status, exact_status;
        jkr_set(&contact, decades(-12, 12), decades(-12, 12), decades(-9, 9));
        if (jkr_fast_set(&fast, &contact) != JKR_OK)
            continue;
        x = value(contact.d_c);
        x = near_or_far(depths[i % 3] * x, x, i & 8 ? 4 : 40);
        status = jkr_fast_at_indentation(&fast, x, branch, &found);
        exact_status = jkr_at_indentation(&contact, x, branch, &exact);
        CHECK(status == exact_status || status == JKR_FOLD || exact_status == JKR_FOLD);
        if (status == JKR_OK && exact_status == JKR_OK)
            compare_fast(0, &contact, &found, &exact, 1);
        x = value(contact.p) / 6;
        x = near_or_far(loads[i % 3] * x, x, i & 8 ? 4 : 40);
        status = jkr_fast_at_force(&fast, x, branch, &found);
        exact_status = jkr_at_force(&contact, x, branch, &exact);
        CHECK(status == exact_status || status == JKR_FOLD || exact_status == JKR_FOLD || status == JKR_OVERFLOW);
        if (status == JKR_OK && exact_status == JKR_OK)
            compare_fast(2, &contact, &found, &exact, 0);
        x = value(contact.a_c);
        x = fabs(near_or_far(radii[i % 4] * x, x, i & 8 ? 4 : 40));
        status = jkr_fast_at_contact_radius(&fast, x, &found);
        exact_status = jkr_at_contact_radius(&contact, x, &exact);
        CHECK(status == exact_status || status == JKR_FOLD);
        if (status == JKR_OK && exact_status == JKR_OK)
            compare_fast(1, &contact, &found, &exact, 0);
    }
    for (i = 0; i < 3; i++) {
        static const char *const names[] = { "indentation", "contact_radius", "force" };
        printf("jkr_fast_at_%s, errors in the promised units of 2^-53 (16, of dF/dd 48): a %.2f, d %.2f, F %.2f, dF/dd %.2f\n", names[i],
               fast_worst[i][0], fast_worst[i][1], fast_worst[i][2], fast_worst[i][3]);
    }
}

int main(void)
{
    check_certified();
    check_statuses();
    check_branches();
    check_histories();
    check_step_sizes();
    check_any_bits();
    check_fast();
    printf("%ld checks, %ld failed\n", checks, failures);
    return failures != 0;
}
