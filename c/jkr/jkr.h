/* SPDX-License-Identifier: MIT
 *
 * jkr.h: the JKR contact of a paraboloid f(r) = r^2/(2 R) on a half-space, in one file of C99 or C++11. Copyright: the mdr
 * developers. Documentation, error budget and measurements: docs/jkr.md of mdr.
 *
 *     jkr_contact contact;                        // once a pair of bodies: R in m, E* in Pa, w in J/m^2, or any coherent units
 *     jkr_set(&contact, 1e-6, 1e9, 0.05);
 *     jkr_state state;
 *     if (jkr_at_indentation(&contact, -2e-9, JKR_STABLE, &state) == JKR_OK)
 *         use(state.contact_radius, state.force, state.stiffness);
 *
 * Equations are numbered as in docs/theory.md; R is 1/(1/R1 + 1/R2) of two spheres, E* the effective modulus (1.3), w the whole
 * work of adhesion (of like bodies twice their surface energy); d and F are positive when pressed in.
 *
 *     d = g(a) - Dl(a) = a^2/R - sqrt(2 pi a w/E*)                                  (1.4), (1.5)
 *     F = (4/3) E* a^3/R - sqrt(8 pi a^3 E* w)                                      (1.16) with n = 2
 *
 * With a_c^3 = pi w R^2/(8 E*), D = a_c^2/R, P = pi w R, u = sqrt(a/a_c) and v = u^3, all states are one curve:
 *
 *     d = D (u^4 - 4 u),   F = (P/6) (v^2 - 6 v),   dF/dd = 2 E* a (v - 3)/(v - 1).
 *
 * Its folds are v = 1 under fixed grips (1.10), d = -3 D and F = -(5/6) P, and v = 3 under a dead load, d = -3^(1/3) D and
 * F = -(3/2) P. Below the fold there is no equilibrium; above it the larger contact is stable.
 *
 * jkr_at_contact_radius, jkr_at_indentation, jkr_at_force, jkr_fold, jkr_follow: rounded once, within 0.51 units in the last
 * place of the exact answer to the given doubles, whatever their size. A quarter to half a microsecond.
 * jkr_fast_...: the same questions in plain doubles, for inner loops, at a tenth of the time; a is within 16 roundings (of
 * 2^-53) also beside a fold, d and F within 16 of the sum of their two parts; JKR_INACCURATE where that is not promised.
 *
 * No allocation, no iteration beyond a fixed count, no global state: a contact that has been set is only read, by any number of
 * threads. Needs IEEE doubles rounded to nearest; not -ffast-math. */
#ifndef JKR_H
#define JKR_H

#include <float.h>
#include <math.h>
#include <stddef.h>

#if defined(__FAST_MATH__) || defined(_M_FP_FAST) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "jkr.h needs IEEE arithmetic: compile without -ffast-math and -ffinite-math-only"
#endif
#if FLT_EVAL_METHOD == 2 || FLT_EVAL_METHOD == -1
#error "jkr.h needs doubles that are computed as doubles: on x87 compile with -msse2 -mfpmath=sse"
#endif
#if FLT_RADIX != 2 || DBL_MANT_DIG != 53
#error "jkr.h needs IEEE doubles"
#endif
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif

/* ---- What callers see ---- */

enum jkr_status {
    JKR_OK = 0,
    /* The value is that of a fold to within its rounding. The fold is returned; its stiffness is +infinity or 0. */
    JKR_FOLD,
    /* No equilibrium on this branch: a, d, F and the stiffness are 0. */
    JKR_NO_EQUILIBRIUM,
    /* Of jkr_follow: the surfaces are apart, or have come apart. a, F and the stiffness are 0. */
    JKR_DETACHED,
    /* A member of the state is infinite, being beyond the doubles, be the state a fold or not; at a given force also a stiffness at
     * the fold of the other control. The other members hold. */
    JKR_OVERFLOW,
    /* A member of the state is subnormal or 0, being below the normal doubles, be the state a fold or not. The others hold. */
    JKR_UNDERFLOW,
    /* Not a question: NaN, infinity, R <= 0, E* <= 0, w < 0, a < 0, w of receding below that of advancing. All are 0. */
    JKR_DOMAIN_ERROR,
    /* Of jkr_fast_...: not within the promised error, so that nothing is answered. All are 0; ask the exact function. */
    JKR_INACCURATE
};

/* Which of the two equilibria at one value. Stability is that under the control of the call: at a given force the unstable branch
 * has the states that only a control of the indentation holds, and those that none does. */
enum jkr_branch { JKR_STABLE = 0, JKR_UNSTABLE = 1 };

/* What is held: the indentation by fixed grips, or the force by a dead load. */
enum jkr_control { JKR_INDENTATION = 0, JKR_FORCE = 1 };

/* A state of equilibrium. */
typedef struct {
    double contact_radius; /* a, m */
    double indentation;    /* d, m */
    double force;          /* F, N */
    double stiffness;      /* dF/dd along the equilibria, N/m; of a pinned edge in jkr_follow 2 E* a */
} jkr_state;

/* (high + low) 2^exponent, |low| at most half a unit in the last place of high. */
typedef struct {
    double high, low;
    int exponent;
} jkr_pair;

/* (word[0] + word[1] + word[2]) 2^exponent. */
typedef struct {
    double word[3];
    int exponent;
} jkr_triple;

/* A contact: its numbers as given, and what is derived from them once. */
typedef struct {
    double radius, modulus, work; /* R, E*, w */
    int status;                   /* JKR_OK once it is set */
    jkr_pair r, e;                /* R, E* */
    jkr_pair p, inverse_p;        /* P, 1/P */
    jkr_pair hertz;               /* 4 E* /(3 R) */
    jkr_pair a3, inverse_a3;      /* a_c^3 and its inverse */
    jkr_pair d3;                  /* D^3 = pi^2 w^2 R/(64 E*^2) */
    jkr_pair a_c, d_c, inverse_d; /* a_c, D, 1/D */
    jkr_triple pi_w_r, pi_w_r2;   /* pi w R, pi w R^2 = 8 E* a_c^3 */
    jkr_triple pi2_w2_r;          /* pi^2 w^2 R = 64 E*^2 D^3 */
} jkr_contact;

/* The words of mdr for statuses. */
static inline const char *jkr_status_name(int status)
{
    static const char *const names[] = { "ok",       "fold",      "no-equilibrium", "detached",
                                         "overflow", "underflow", "domain-error",   "inaccurate" };
    return status >= JKR_OK && status <= JKR_INACCURATE ? names[status] : "unknown";
}

/* ---- Arithmetic of some hundred bits, with exponents of its own so that nothing overflows on the way ---- */

/* a + b = sum + *error (Knuth). */
static inline double jkr_two_sum(double a, double b, double *error)
{
    double sum = a + b, part = sum - a;
    *error = (a - (sum - part)) + (b - part);
    return sum;
}

/* a b = product + *error, by a fused operation where it is fast, else after Dekker. */
static inline double jkr_two_product(double a, double b, double *error)
{
    double product = a * b;
#ifdef FP_FAST_FMA
    *error = fma(a, b, -product);
#else
    double t = 134217729.0 * a, a1 = t - (t - a), a2 = a - a1;
    double s = 134217729.0 * b, b1 = s - (s - b), b2 = b - b1;
    *error = ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2;
#endif
    return product;
}

/* high + low, where |high| >= |low| or high = 0. */
static inline jkr_pair jkr_pair_of(double high, double low, int exponent)
{
    jkr_pair x;
    x.high = high + low;
    x.low = low - (x.high - high);
    x.exponent = exponent;
    return x;
}

static inline jkr_pair jkr_pair_from(double value)
{
    jkr_pair x;
    x.high = frexp(value, &x.exponent);
    x.low = 0;
    return x;
}

/* A number near 1. */
static inline jkr_pair jkr_pair_constant(double c) { return jkr_pair_of(c, 0, 0); }

static inline jkr_pair jkr_multiply(jkr_pair x, jkr_pair y)
{
    double error, product = jkr_two_product(x.high, y.high, &error);
    return jkr_pair_of(product, error + (x.high * y.low + x.low * y.high), x.exponent + y.exponent);
}

/* x c with a constant near 1. */
static inline jkr_pair jkr_times(jkr_pair x, double c)
{
    double error, product = jkr_two_product(x.high, c, &error);
    return jkr_pair_of(product, error + x.low * c, x.exponent);
}

static inline jkr_pair jkr_divide(jkr_pair x, jkr_pair y)
{
    double quotient = x.high / y.high, error, product = jkr_two_product(quotient, y.high, &error);
    double rest = (x.high - product) - error + x.low - quotient * y.low;
    return jkr_pair_of(quotient, rest / y.high, x.exponent - y.exponent);
}

/* The same value with another exponent; what is below the smallest number then is lost. */
static inline jkr_pair jkr_with_exponent(jkr_pair x, int exponent)
{
    double scale;
    if (x.exponent == exponent)
        return x;
    scale = x.exponent - exponent < -1000 ? 0 : ldexp(1.0, x.exponent - exponent);
    x.high *= scale;
    x.low *= scale;
    x.exponent = exponent;
    return x;
}

static inline jkr_pair jkr_add(jkr_pair x, jkr_pair y)
{
    double error, low_error, high, low;
    if (x.high == 0)
        return y;
    if (y.high == 0)
        return x;
    if (x.exponent > y.exponent)
        y = jkr_with_exponent(y, x.exponent);
    else
        x = jkr_with_exponent(x, y.exponent);
    high = jkr_two_sum(x.high, y.high, &error);
    low = jkr_two_sum(x.low, y.low, &low_error);
    y = jkr_pair_of(high, error + low, x.exponent);
    return jkr_pair_of(y.high, y.low + low_error, x.exponent);
}

/* x + c with a constant near 1. */
static inline jkr_pair jkr_plus(jkr_pair x, double c) { return jkr_add(x, jkr_pair_constant(c)); }

static inline jkr_pair jkr_negative(jkr_pair x)
{
    x.high = -x.high;
    x.low = -x.low;
    return x;
}

/* One step of Newton from the root of the high word. */
static inline jkr_pair jkr_square_root(jkr_pair x)
{
    double root, error, square;
    if (x.exponent & 1) {
        x.high *= 2;
        x.low *= 2;
        x.exponent--;
    }
    if (x.high <= 0)
        return jkr_pair_constant(0);
    root = sqrt(x.high);
    square = jkr_two_product(root, root, &error);
    return jkr_pair_of(root, ((x.high - square) - error + x.low) / (2 * root), x.exponent / 2);
}

/* Of x > 0; one step of Newton from the root of the high word. */
static inline jkr_pair jkr_cube_root(jkr_pair x)
{
    int rest = x.exponent % 3;
    double root, square, square_error, cube, cube_error;
    if (rest < 0)
        rest += 3;
    if (rest) {
        double scale = rest == 1 ? 2 : 4;
        x.high *= scale;
        x.low *= scale;
        x.exponent -= rest;
    }
    root = cbrt(x.high);
    square = jkr_two_product(root, root, &square_error);
    cube = jkr_two_product(square, root, &cube_error);
    return jkr_pair_of(root, ((x.high - cube) - cube_error - square_error * root + x.low) / (3 * square), x.exponent / 3);
}

/* The same value with 1/2 <= |high| < 1, so that the exponent tells its size. */
static inline jkr_pair jkr_normal(jkr_pair x)
{
    int k;
    double high = frexp(x.high, &k);
    if (x.high == 0)
        return jkr_pair_constant(0);
    x.low = ldexp(x.low, -k);
    x.high = high;
    x.exponent += k;
    return x;
}

/* The nearest double: the one rounding of an answer. A status is only made worse. */
static inline double jkr_rounded(jkr_pair x, int *status)
{
    double y = ldexp(x.high, x.exponent);
    if (x.high == 0)
        return 0;
    if (fabs(y) > DBL_MAX)
        *status = JKR_OVERFLOW;
    else if (fabs(y) < DBL_MIN && *status != JKR_OVERFLOW)
        *status = JKR_UNDERFLOW;
    return y;
}

/* *t becomes *t y. */
static inline void jkr_triple_multiply(jkr_triple *t, double y)
{
    int k;
    double m = frexp(y, &k), error0, error1, rest, product0 = jkr_two_product(t->word[0], m, &error0);
    double product1 = jkr_two_product(t->word[1], m, &error1), middle, low;
    middle = jkr_two_sum(error0, product1, &rest);
    low = error1 + rest + t->word[2] * m;
    middle = jkr_two_sum(middle, low, &low);
    t->word[0] = jkr_two_sum(product0, middle, &middle);
    t->word[1] = jkr_two_sum(middle, low, &t->word[2]);
    t->exponent += k;
}

static inline jkr_triple jkr_triple_from(double value)
{
    jkr_triple t = { { 1, 0, 0 }, 0 };
    jkr_triple_multiply(&t, value);
    return t;
}

static inline jkr_pair jkr_pair_of_triple(jkr_triple t) { return jkr_pair_of(t.word[0], t.word[1], t.exponent); }

/* x + n y through cancellation: the difference of two numbers of 155 bits. */
static inline jkr_pair jkr_difference(jkr_triple x, double n, jkr_triple y)
{
    double words[6], scale_x = 1, scale_y = 1;
    int apart, i, j;
    jkr_triple_multiply(&y, n);
    if (x.word[0] == 0)
        return jkr_pair_of_triple(y);
    apart = x.exponent - y.exponent;
    if (apart > 0)
        scale_y = apart > 1000 ? 0 : ldexp(1.0, -apart);
    else if (apart < 0)
        scale_x = apart < -1000 ? 0 : ldexp(1.0, apart);
    for (j = 0; j < 3; j++) {
        words[2 * j] = x.word[j] * scale_x;
        words[2 * j + 1] = y.word[j] * scale_y;
    }
    for (i = 0; i < 3; i++)
        for (j = 5; j > 0; j--)
            words[j - 1] = jkr_two_sum(words[j - 1], words[j], &words[j]);
    return jkr_pair_of(words[0], words[1] + (words[2] + (words[3] + (words[4] + words[5]))),
                       x.exponent > y.exponent ? x.exponent : y.exponent);
}

/* ---- A contact, its folds, and the state with a given contact radius ---- */

/* Sets a contact: R > 0, E* > 0, w >= 0, finite. w = 0 is Hertz's contact. JKR_OK or JKR_DOMAIN_ERROR. */
static inline int jkr_set(jkr_contact *contact, double radius, double modulus, double work)
{
    /* pi and pi^2 in 159 bits. */
    static const jkr_triple pi = { { 3.141592653589793, 1.2246467991473532e-16, -2.9947698097183397e-33 }, 0 };
    static const jkr_triple pi2 = { { 9.869604401089358, 6.265295508739711e-16, 3.730017701459809e-32 }, 0 };
    jkr_contact *c = contact;
    c->radius = radius;
    c->modulus = modulus;
    c->work = work;
    c->status = JKR_DOMAIN_ERROR;
    if (!(radius > 0 && radius <= DBL_MAX && modulus > 0 && modulus <= DBL_MAX && work >= 0 && work <= DBL_MAX))
        return c->status;
    c->status = JKR_OK;
    c->r = jkr_pair_from(radius);
    c->e = jkr_pair_from(modulus);
    c->hertz = jkr_divide(jkr_times(c->e, 4), jkr_times(c->r, 3));
    c->p = c->inverse_p = c->a3 = c->inverse_a3 = c->d3 = c->a_c = c->d_c = c->inverse_d = jkr_pair_constant(0);
    c->pi_w_r = pi;
    jkr_triple_multiply(&c->pi_w_r, work);
    jkr_triple_multiply(&c->pi_w_r, radius);
    c->pi_w_r2 = c->pi_w_r;
    jkr_triple_multiply(&c->pi_w_r2, radius);
    c->pi2_w2_r = pi2;
    jkr_triple_multiply(&c->pi2_w2_r, work);
    jkr_triple_multiply(&c->pi2_w2_r, work);
    jkr_triple_multiply(&c->pi2_w2_r, radius);
    if (work == 0)
        return JKR_OK;
    c->p = jkr_pair_of_triple(c->pi_w_r);
    c->inverse_p = jkr_divide(jkr_pair_constant(1), c->p);
    c->a3 = jkr_divide(jkr_pair_of_triple(c->pi_w_r2), jkr_times(c->e, 8));
    c->inverse_a3 = jkr_divide(jkr_pair_constant(1), c->a3);
    c->d3 = jkr_divide(jkr_pair_of_triple(c->pi2_w2_r), jkr_times(jkr_multiply(c->e, c->e), 64));
    c->a_c = jkr_cube_root(c->a3);
    c->d_c = jkr_cube_root(c->d3);
    c->inverse_d = jkr_divide(jkr_pair_constant(1), c->d_c);
    return JKR_OK;
}

/* No state, for a reason. */
static inline int jkr_none(jkr_state *state, int status)
{
    state->contact_radius = state->indentation = state->force = state->stiffness = 0;
    return status;
}

/* Hertz's state with a contact radius: w = 0. */
static inline int jkr_hertz(const jkr_contact *c, jkr_pair a, jkr_state *state)
{
    int status = JKR_OK;
    jkr_pair a2 = jkr_multiply(a, a);
    state->contact_radius = jkr_rounded(a, &status);
    state->indentation = jkr_rounded(jkr_divide(a2, c->r), &status);
    state->force = jkr_rounded(jkr_multiply(c->hertz, jkr_multiply(a2, a)), &status);
    state->stiffness = jkr_rounded(jkr_times(jkr_multiply(c->e, a), 2), &status);
    return status;
}

/* q - m for q = v^2 = 8 E* a^3/(pi w R^2): where it cancels, (8 E* a^3 - m pi w R^2)/(pi w R^2) from exact products. */
static inline jkr_pair jkr_q_minus(const jkr_contact *c, double a, jkr_pair q, double m)
{
    jkr_pair difference = jkr_normal(jkr_plus(q, -m));
    jkr_triple t;
    if (difference.exponent > (m > 2 ? 1 : -2))
        return difference;
    t = jkr_triple_from(a);
    jkr_triple_multiply(&t, a);
    jkr_triple_multiply(&t, a);
    jkr_triple_multiply(&t, c->modulus);
    jkr_triple_multiply(&t, 8);
    return jkr_divide(jkr_difference(t, -m, c->pi_w_r2), jkr_pair_of_triple(c->pi_w_r2));
}

/* d(a) = a^2 (q - 16)/(R (q + 4 v)) of a > 0, which is (1.5) with the square root out of the difference. */
static inline jkr_pair jkr_indentation_of(const jkr_contact *c, double radius)
{
    jkr_pair a = jkr_pair_from(radius), a2 = jkr_multiply(a, a), q, v;
    if (c->work == 0)
        return jkr_divide(a2, c->r);
    q = jkr_multiply(jkr_multiply(a2, a), c->inverse_a3);
    v = jkr_square_root(q);
    return jkr_divide(jkr_multiply(a2, jkr_q_minus(c, radius, q, 16)), jkr_multiply(c->r, jkr_add(q, jkr_times(v, 4))));
}

/* The equilibrium with a contact radius a >= 0, stable or not; a = 0 is the state without contact, with status JKR_OK. */
static inline int jkr_at_contact_radius(const jkr_contact *contact, double radius, jkr_state *state)
{
    const jkr_contact *c = contact;
    jkr_pair a, a3, q, v, force, above, below;
    int status = JKR_OK;
    if (c->status != JKR_OK || !(radius >= 0 && radius <= DBL_MAX))
        return jkr_none(state, JKR_DOMAIN_ERROR);
    if (radius == 0)
        return jkr_none(state, JKR_OK);
    a = jkr_pair_from(radius);
    if (c->work == 0)
        return jkr_hertz(c, a, state);
    a3 = jkr_multiply(a, jkr_multiply(a, a));
    q = jkr_multiply(a3, c->inverse_a3);
    v = jkr_square_root(q);
    /* F = (4 E* a^3/3 R) (q - 36)/(q + 6 v); v - 3 = (q - 9)/(v + 3); v - 1 = (q - 1)/(v + 1). */
    force = jkr_multiply(jkr_multiply(c->hertz, a3), jkr_q_minus(c, radius, q, 36));
    force = jkr_divide(force, jkr_add(q, jkr_times(v, 6)));
    above = jkr_divide(jkr_q_minus(c, radius, q, 9), jkr_plus(v, 3));
    below = jkr_divide(jkr_q_minus(c, radius, q, 1), jkr_plus(v, 1));
    state->contact_radius = radius;
    state->indentation = jkr_rounded(jkr_indentation_of(c, radius), &status);
    state->force = jkr_rounded(force, &status);
    if (below.high == 0) {
        state->stiffness = HUGE_VAL;
        return JKR_FOLD;
    }
    state->stiffness = jkr_rounded(jkr_multiply(jkr_times(jkr_multiply(c->e, a), 2), jkr_divide(above, below)), &status);
    return status;
}

/* The fold under a control, where the contact breaks: F = -(3/2) pi w R under a dead load, the pull-off force, and
 * F = -(5/6) pi w R at d = -3 (pi^2 w^2 R/(64 E*^2))^(1/3) under fixed grips. The status is JKR_FOLD. */
static inline int jkr_fold(const jkr_contact *contact, int control, jkr_state *state)
{
    const jkr_contact *c = contact;
    int status = JKR_FOLD;
    if (c->status != JKR_OK || (control != JKR_INDENTATION && control != JKR_FORCE))
        return jkr_none(state, JKR_DOMAIN_ERROR);
    if (c->work == 0)
        return jkr_none(state, JKR_FOLD);
    if (control == JKR_FORCE) {
        state->contact_radius = jkr_rounded(jkr_cube_root(jkr_times(c->a3, 9)), &status);
        state->indentation = -jkr_rounded(jkr_cube_root(jkr_times(c->d3, 3)), &status);
        state->force = jkr_rounded(jkr_times(c->p, -1.5), &status);
        state->stiffness = 0;
    } else {
        state->contact_radius = jkr_rounded(c->a_c, &status);
        state->indentation = -jkr_rounded(jkr_times(c->d_c, 3), &status);
        state->force = jkr_rounded(jkr_divide(jkr_times(c->p, -5), jkr_pair_constant(6)), &status);
        state->stiffness = HUGE_VAL;
    }
    return status;
}

/* ---- The states at a given force ---- */

/* 6 F/P + n, where it cancels from exact products. */
static inline jkr_pair jkr_force_plus(const jkr_contact *c, double force, jkr_pair phi, double n)
{
    jkr_pair sum = jkr_normal(jkr_plus(phi, n));
    jkr_triple t;
    if (sum.exponent > 0)
        return sum;
    t = jkr_triple_from(force);
    jkr_triple_multiply(&t, 6);
    return jkr_multiply(jkr_difference(t, n, c->pi_w_r), c->inverse_p);
}

/* The equilibrium at a force: v = 3 +- sqrt(9 + 6 F/P), in closed form. The unstable branch has states for -(3/2) P < F < 0. */
static inline int jkr_at_force(const jkr_contact *contact, double force, int branch, jkr_state *state)
{
    const jkr_contact *c = contact;
    jkr_pair phi, gap, root, v, a, minus4, minus1;
    int status = JKR_OK;
    if (c->status != JKR_OK || !(fabs(force) <= DBL_MAX) || (branch != JKR_STABLE && branch != JKR_UNSTABLE))
        return jkr_none(state, JKR_DOMAIN_ERROR);
    if (branch == JKR_UNSTABLE && (force >= 0 || c->work == 0))
        return jkr_none(state, JKR_NO_EQUILIBRIUM);
    if (c->work == 0) {
        if (force <= 0)
            return jkr_none(state, force < 0 ? JKR_NO_EQUILIBRIUM : JKR_FOLD);
        status = jkr_hertz(c, jkr_cube_root(jkr_divide(jkr_pair_from(force), c->hertz)), state);
        state->force = force;
        return status;
    }
    phi = jkr_multiply(jkr_times(jkr_pair_from(force), 6), c->inverse_p);
    gap = jkr_normal(jkr_force_plus(c, force, phi, 9));
    if (gap.high <= 0) {
        /* Below the fold: by at most two units in the last place, or by more. */
        if (ldexp(gap.high, gap.exponent) < -9 * DBL_EPSILON)
            return jkr_none(state, JKR_NO_EQUILIBRIUM);
        status = jkr_fold(c, JKR_FORCE, state);
        state->force = force;
        return status;
    }
    root = jkr_square_root(gap);
    v = jkr_plus(root, 3);
    if (branch == JKR_UNSTABLE) {
        v = jkr_divide(jkr_negative(phi), v);
        root = jkr_negative(root);
    }
    a = jkr_cube_root(jkr_multiply(c->a3, jkr_multiply(v, v)));
    /* v - 4 = (6 F/P + 8)/(root + 1) and v - 1 = (6 F/P + 5)/(root - 2). */
    minus4 = jkr_normal(jkr_plus(v, -4));
    minus1 = jkr_normal(jkr_plus(v, -1));
    if (minus4.exponent < -3)
        minus4 = jkr_divide(jkr_force_plus(c, force, phi, 8), jkr_plus(root, 1));
    if (minus1.exponent < -3)
        minus1 = jkr_divide(jkr_force_plus(c, force, phi, 5), jkr_plus(root, -2));
    state->contact_radius = jkr_rounded(a, &status);
    state->indentation = jkr_rounded(jkr_multiply(jkr_cube_root(jkr_multiply(c->d3, v)), minus4), &status);
    state->force = force;
    if (minus1.high == 0) { /* the fold of the other control */
        state->stiffness = HUGE_VAL;
        return JKR_OVERFLOW;
    }
    state->stiffness = jkr_rounded(jkr_multiply(jkr_times(jkr_multiply(c->e, a), 2), jkr_divide(root, minus1)), &status);
    return status;
}

/* ---- The states at a given indentation: u^4 - 4 u = d/D ---- */

/* (d/D)^3 + n through cancellation, from exact products: D^3 is rational in the inputs and pi. */
static inline jkr_pair jkr_cube_plus(const jkr_contact *c, double indentation, double n)
{
    jkr_triple t = jkr_triple_from(indentation);
    jkr_triple_multiply(&t, indentation);
    jkr_triple_multiply(&t, indentation);
    jkr_triple_multiply(&t, c->modulus);
    jkr_triple_multiply(&t, c->modulus);
    jkr_triple_multiply(&t, 64);
    return jkr_divide(jkr_difference(t, n, c->pi2_w2_r), jkr_pair_of_triple(c->pi2_w2_r));
}

/* v - m for m = 3, where the stiffness is 0, or m = 6, where the force is 0. Near that zero from x = u - m^(1/3), the root of
 * (4 m - 4) x + 6 m^(2/3) x^2 + 4 m^(1/3) x^3 + x^4 = d/D - (m - 4) m^(1/3). */
static inline jkr_pair jkr_v_minus(const jkr_contact *c, double indentation, jkr_pair delta, jkr_pair v, int m)
{
    /* m^(1/3) and 3 m^(2/3). */
    static const double constants[2][4] = {
        { 1.4422495703074083, 8.054912676113687e-17, 6.240251469155712, 7.190432746636593e-17 },
        { 1.8171205928321397, -1.0534616531458147e-17, 9.90578174668388, -1.7731922336829373e-16 },
    };
    const double *words = constants[m == 6], root = words[0];
    double n = m - 4.0, slope = 4.0 * (m - 1), x;
    jkr_pair difference = jkr_plus(v, -m), at_zero, y;
    int i;
    if (!(fabs(ldexp(difference.high, difference.exponent)) < 1.0 / 1024))
        return difference;
    at_zero = jkr_times(jkr_pair_of(words[0], words[1], 0), n);
    y = jkr_add(jkr_multiply(at_zero, at_zero), jkr_multiply(delta, jkr_add(delta, at_zero)));
    y = jkr_divide(jkr_cube_plus(c, indentation, -n * n * n * m), y);
    y = jkr_with_exponent(jkr_normal(y), 0);
    x = y.high / slope;
    for (i = 0; i < 5; i++)
        x = (y.high - x * x * (2 * words[2] + x * (4 * root + x))) / slope;
    y = jkr_divide(jkr_plus(y, -x * x * (2 * words[2] + x * (4 * root + x))), jkr_pair_constant(slope));
    return jkr_plus(jkr_multiply(y, jkr_pair_of(words[2], words[3], 0)), x * x * (3 * root + x));
}

/* s^2 (s^2 + 4 s + 6), which is d/D + 3 at u = 1 + s, and a quarter of its derivative. */
static inline double jkr_above_fold(double s) { return s * s * (6 + s * (4 + s)); }
static inline double jkr_quarter_slope(double s) { return s * (3 + s * (3 + s)); }

/* A step of Halley. */
static inline double jkr_s_improved(double s, double epsilon)
{
    double rest = jkr_above_fold(s) - epsilon, slope = 4 * jkr_quarter_slope(s);
    return s - rest * slope / (slope * slope - 6 * rest * (1 + s) * (1 + s));
}

/* s with s^2 (s^2 + 4 s + 6) = epsilon > 0 in double: an approximation within 1.6 % (stable, s > 0) or 0.1 % (unstable, s < 0,
 * epsilon < 1.1), and two steps, which leave 2e-7 and nothing of its error. */
static inline double jkr_s_of(double epsilon, int branch)
{
    double t = sqrt(epsilon), s;
    if (branch == JKR_UNSTABLE)
        s = -t * (0.40816679 + t * (0.0567888 + t * (0.00915192 + t * 0.00792728)));
    else {
        s = t * (t + 4.449489742783178) / (t + 5.449489742783178);
        s = s / (1 + sqrt(1 + s));
    }
    return jkr_s_improved(jkr_s_improved(s, epsilon), epsilon);
}

/* u with u - u^4/4 = y = -d/(4 D) < 1/2, the smaller root, in double: three terms of its series, two steps of Newton. */
static inline double jkr_small_u(double y)
{
    double e = y * y * y / 4, u = y * (1 + e * (1 + e * (4 + e * 22)));
    int i;
    for (i = 0; i < 2; i++)
        u -= (u - u * u * u * u / 4 - y) / (1 - u * u * u);
    return u;
}

/* u and v = u^3 of a state. */
typedef struct {
    jkr_pair u, v, v_minus_1;
} jkr_root;

/* The root for d/D >= 2^100: u^4 = d/D to 2^-73. */
static inline jkr_root jkr_large_root(jkr_pair delta)
{
    jkr_root root;
    jkr_pair u2 = jkr_square_root(delta);
    root.u = jkr_square_root(u2);
    root.v = root.v_minus_1 = jkr_multiply(u2, root.u);
    return root;
}

/* The unstable root for -2 < d/D < 0: one step of Newton with a residual in pairs. Below 2^-40 the series has one term. */
static inline jkr_root jkr_small_root(jkr_pair delta)
{
    jkr_root root;
    jkr_pair y = jkr_times(delta, -0.25), u2, rest;
    root.u = y;
    if (delta.exponent >= -40) {
        double u;
        y = jkr_with_exponent(y, 0);
        u = jkr_small_u(y.high);
        u2 = jkr_multiply(jkr_pair_constant(u), jkr_pair_constant(u));
        rest = jkr_plus(jkr_add(y, jkr_times(jkr_multiply(u2, u2), 0.25)), -u);
        root.u = jkr_pair_of(u, rest.high / (1 - u * u * u), 0);
    }
    root.v = jkr_multiply(jkr_multiply(root.u, root.u), root.u);
    root.v_minus_1 = jkr_plus(root.v, -1);
    return root;
}

/* The root u = 1 + s with s^2 (s^2 + 4 s + 6) = epsilon = d/D + 3 > 0: the last step of Newton with a residual in pairs. */
static inline jkr_root jkr_root_above_fold(jkr_pair epsilon, int branch)
{
    jkr_root root;
    double s = jkr_s_of(epsilon.high, branch);
    jkr_pair x = jkr_pair_constant(s), x2 = jkr_multiply(x, x), rest;
    rest = jkr_multiply(x2, jkr_plus(jkr_add(x2, jkr_times(x, 4)), 6));
    rest = jkr_add(rest, jkr_negative(epsilon));
    x = jkr_pair_of(s, -rest.high / (4 * jkr_quarter_slope(s)), 0);
    root.u = jkr_plus(x, 1);
    root.v = jkr_multiply(jkr_multiply(root.u, root.u), root.u);
    root.v_minus_1 = jkr_multiply(x, jkr_plus(jkr_add(jkr_multiply(x, x), jkr_times(x, 3)), 3));
    return root;
}

/* The equilibrium at an indentation. The unstable branch has states for -3 D < d < 0. */
static inline int jkr_at_indentation(const jkr_contact *contact, double indentation, int branch, jkr_state *state)
{
    const jkr_contact *c = contact;
    jkr_pair delta, epsilon, a, force, stiffness;
    jkr_root root;
    int status = JKR_OK;
    if (c->status != JKR_OK || !(fabs(indentation) <= DBL_MAX) || (branch != JKR_STABLE && branch != JKR_UNSTABLE))
        return jkr_none(state, JKR_DOMAIN_ERROR);
    if (branch == JKR_UNSTABLE && (indentation >= 0 || c->work == 0))
        return jkr_none(state, JKR_NO_EQUILIBRIUM);
    if (c->work == 0) {
        if (indentation <= 0)
            return jkr_none(state, indentation < 0 ? JKR_NO_EQUILIBRIUM : JKR_FOLD);
        status = jkr_hertz(c, jkr_square_root(jkr_multiply(jkr_pair_from(indentation), c->r)), state);
        state->indentation = indentation;
        return status;
    }
    delta = jkr_normal(jkr_multiply(jkr_pair_from(indentation), c->inverse_d));
    if (delta.exponent > 2 && indentation < 0)
        return jkr_none(state, JKR_NO_EQUILIBRIUM);
    if (delta.exponent > 100)
        root = jkr_large_root(delta);
    else if (branch == JKR_UNSTABLE && delta.exponent < 2)
        root = jkr_small_root(delta);
    else {
        delta = jkr_with_exponent(delta, 0);
        epsilon = jkr_plus(delta, 3);
        if (epsilon.high < 0.25) { /* ((d/D)^3 + 27)/((d/D)^2 - 3 d/D + 9): no cube root in the difference */
            epsilon = jkr_plus(jkr_multiply(delta, jkr_plus(delta, -3)), 9);
            epsilon = jkr_with_exponent(jkr_normal(jkr_divide(jkr_cube_plus(c, indentation, 27), epsilon)), 0);
        }
        if (epsilon.high <= 0) {
            /* Below the fold: by at most two units in the last place, or by more. */
            if (epsilon.high < -3 * DBL_EPSILON)
                return jkr_none(state, JKR_NO_EQUILIBRIUM);
            status = jkr_fold(c, JKR_INDENTATION, state);
            state->indentation = indentation;
            return status;
        }
        root = jkr_root_above_fold(epsilon, branch);
    }
    a = jkr_multiply(c->a_c, jkr_multiply(root.u, root.u));
    force = jkr_divide(jkr_v_minus(c, indentation, delta, root.v, 6), jkr_pair_constant(6));
    stiffness = jkr_divide(jkr_v_minus(c, indentation, delta, root.v, 3), root.v_minus_1);
    state->contact_radius = jkr_rounded(a, &status);
    state->indentation = indentation;
    state->force = jkr_rounded(jkr_multiply(jkr_multiply(c->p, root.v), force), &status);
    state->stiffness = jkr_rounded(jkr_multiply(jkr_times(jkr_multiply(c->e, a), 2), stiffness), &status);
    return status;
}

/* ---- Hysteresis: w1 while the edge advances, w2 >= w1 while it recedes, pinned between ---- */

/* F at a pinned edge: 2 E* (a d - a^3/(3 R)), (1.6), as (2 E* a/3 R) (3 R d - a^2) from exact products. */
static inline jkr_pair jkr_pinned_force(const jkr_contact *c, double radius, double indentation)
{
    jkr_triple t = jkr_triple_from(c->radius), square = jkr_triple_from(radius);
    jkr_pair factor = jkr_divide(jkr_times(jkr_multiply(c->e, jkr_pair_from(radius)), 2), jkr_times(c->r, 3));
    jkr_triple_multiply(&t, 3);
    jkr_triple_multiply(&t, indentation);
    jkr_triple_multiply(&square, radius);
    return jkr_multiply(factor, jkr_difference(t, -1, square));
}

/* The state after the edge has receded to its equilibrium under w2, or to nothing. */
static inline int jkr_receded(const jkr_contact *c, double radius, double indentation, jkr_state *state)
{
    int status = JKR_NO_EQUILIBRIUM;
    jkr_pair inside = jkr_add(c->a_c, jkr_negative(jkr_pair_from(radius)));
    /* An edge inside of the fold under fixed grips finds no equilibrium on its way. */
    if (c->work == 0 ? indentation > 0 : inside.high <= 0)
        status = jkr_at_indentation(c, indentation, JKR_STABLE, state);
    if (status != JKR_NO_EQUILIBRIUM)
        return status;
    jkr_none(state, JKR_DETACHED);
    state->indentation = indentation;
    return JKR_DETACHED;
}

/* The state that follows one with contact radius a (0: apart) when the indentation has moved slowly to d. The edge advances where
 * g(a) - d < Dl1(a) (1.9), recedes where g(a) - d > Dl2(a) (1.8), and is pinned between, F = 2 E* (a d - a^3/(3 R)). Surfaces that
 * are apart meet at d = 0. `advancing` has w1 and `receding` w2, with the R and E* of both. */
static inline int jkr_follow(const jkr_contact *advancing, const jkr_contact *receding, double radius, double indentation,
                             jkr_state *state)
{
    const jkr_contact *c1 = advancing, *c2 = receding;
    jkr_pair minus_d;
    int status;
    if (c1->status != JKR_OK || c2->status != JKR_OK || c1->radius != c2->radius || c1->modulus != c2->modulus
        || c1->work > c2->work || !(radius >= 0 && radius <= DBL_MAX && fabs(indentation) <= DBL_MAX))
        return jkr_none(state, JKR_DOMAIN_ERROR);
    if (radius == 0) {
        if (indentation > 0 || (indentation == 0 && c1->work > 0))
            return jkr_at_indentation(c1, indentation, JKR_STABLE, state);
        jkr_none(state, JKR_DETACHED);
        state->indentation = indentation;
        return JKR_DETACHED;
    }
    minus_d = jkr_pair_from(-indentation);
    if (jkr_add(jkr_indentation_of(c1, radius), minus_d).high < 0) {
        status = jkr_at_indentation(c1, indentation, JKR_STABLE, state);
        if (status != JKR_NO_EQUILIBRIUM && status != JKR_FOLD && state->contact_radius >= radius)
            return status;
    } else if (jkr_add(jkr_indentation_of(c2, radius), minus_d).high > 0) {
        status = jkr_receded(c2, radius, indentation, state);
        if (status == JKR_DETACHED || state->contact_radius <= radius)
            return status;
    }
    status = JKR_OK;
    state->contact_radius = radius;
    state->indentation = indentation;
    state->force = jkr_rounded(jkr_pinned_force(c1, radius, indentation), &status);
    state->stiffness = jkr_rounded(jkr_times(jkr_multiply(c1->e, jkr_pair_from(radius)), 2), &status);
    return status;
}

/* ---- In plain doubles, for inner loops ---- */

/* A contact for the fast functions, and how far from its own lengths and forces, by factors, they answer. */
#define JKR_FAST_RANGE 1e45

typedef struct {
    double radius, per_radius, two_e, hertz; /* R, 1/R, 2 E*, 4 E* /(3 R) */
    double a_c, per_a_c, d_c, sixth_p;       /* a_c, 1/a_c, D, P/6 */
    double per_d[2], per_sixth_p[2];         /* 1/D and 6/P, each as the sum of two doubles */
    double edge;                             /* sqrt(2 pi w/E*): Dl = edge sqrt(a) */
    double shortest, longest;                /* the depths at which it answers */
    double weakest, strongest;               /* the forces */
    int adhesive, status;
    jkr_state folds[2]; /* of each control */
} jkr_fast;

static inline int jkr_fast_scale(double x) { return x >= 1 / JKR_FAST_RANGE && x <= JKR_FAST_RANGE; }

/* Sets a contact for the fast functions from one that is set. JKR_INACCURATE if R, E*, a_c, D or P is beyond 10^+-45 in the units
 * of the caller. */
static inline int jkr_fast_set(jkr_fast *fast, const jkr_contact *contact)
{
    const jkr_contact *c = contact;
    jkr_fast *f = fast;
    jkr_pair inverse, six;
    int status = JKR_OK, fits;
    f->status = c->status;
    f->adhesive = c->status == JKR_OK && c->work > 0;
    if (c->status != JKR_OK)
        return f->status;
    f->radius = c->radius;
    f->two_e = 2 * c->modulus;
    f->per_radius = 1 / c->radius;
    f->hertz = jkr_rounded(c->hertz, &status);
    fits = jkr_fast_scale(c->radius) && jkr_fast_scale(c->modulus);
    f->a_c = f->per_a_c = f->d_c = f->sixth_p = f->edge = 0;
    f->per_d[0] = f->per_d[1] = f->per_sixth_p[0] = f->per_sixth_p[1] = 0;
    jkr_fold(c, JKR_INDENTATION, &f->folds[JKR_INDENTATION]);
    jkr_fold(c, JKR_FORCE, &f->folds[JKR_FORCE]);
    if (f->adhesive) {
        f->a_c = jkr_rounded(c->a_c, &status);
        f->d_c = jkr_rounded(c->d_c, &status);
        f->sixth_p = jkr_rounded(jkr_divide(c->p, jkr_pair_constant(6)), &status);
        fits = fits && jkr_fast_scale(f->a_c) && jkr_fast_scale(f->d_c) && jkr_fast_scale(f->sixth_p);
    }
    if (!fits) {
        f->status = JKR_INACCURATE;
        return f->status;
    }
    if (f->adhesive) {
        inverse = c->inverse_d;
        six = jkr_times(c->inverse_p, 6);
        f->per_a_c = jkr_rounded(jkr_divide(jkr_pair_constant(1), c->a_c), &status);
        f->per_d[0] = ldexp(inverse.high, inverse.exponent);
        f->per_d[1] = ldexp(inverse.low, inverse.exponent);
        f->per_sixth_p[0] = ldexp(six.high, six.exponent);
        f->per_sixth_p[1] = ldexp(six.low, six.exponent);
        f->edge = 4 * sqrt(f->a_c) * (f->a_c / f->radius); /* 4 D sqrt(a/a_c) = Dl */
    }
    f->longest = JKR_FAST_RANGE * (f->adhesive ? f->d_c : f->radius);
    f->strongest = JKR_FAST_RANGE * (f->adhesive ? f->sixth_p : c->modulus * c->radius * c->radius);
    f->shortest = (f->adhesive ? f->d_c : f->radius) / JKR_FAST_RANGE;
    f->weakest = (f->adhesive ? f->sixth_p : c->modulus * c->radius * c->radius) / JKR_FAST_RANGE;
    return JKR_OK;
}

/* The reason for no answer to a value that is not between the limits. */
static inline int jkr_fast_refused(const jkr_fast *f, double value, jkr_state *state)
{
    if (f->status != JKR_OK)
        return jkr_none(state, f->status);
    if (!(fabs(value) <= DBL_MAX))
        return jkr_none(state, JKR_DOMAIN_ERROR);
    return jkr_none(state, JKR_INACCURATE);
}

/* x (y[0] + y[1]) + c where that cancels. */
static inline double jkr_fast_sum(double x, const double y[2], double c)
{
    double error, product = jkr_two_product(x, y[0], &error);
    return (product + c) + (error + x * y[1]);
}

/* Hertz's state with a contact radius. */
static inline int jkr_fast_hertz(const jkr_fast *f, double a, jkr_state *state)
{
    state->contact_radius = a;
    state->indentation = a * a * f->per_radius;
    state->force = f->hertz * a * a * a;
    state->stiffness = f->two_e * a;
    return JKR_OK;
}

/* The fold of a control, at a value that is that of the fold within half a rounding. */
static inline int jkr_fast_fold(const jkr_fast *f, int control, double value, jkr_state *state)
{
    *state = f->folds[control];
    *(control == JKR_FORCE ? &state->force : &state->indentation) = value;
    return JKR_FOLD;
}

/* jkr_at_contact_radius in doubles: d and F within 16 units of 2^-53 of the sums of their two parts, the stiffness within
 * 48 (1 + v/|v - 1| + 3/|v - 3|) units of itself. */
static inline int jkr_fast_at_contact_radius(const jkr_fast *fast, double radius, jkr_state *state)
{
    const jkr_fast *f = fast;
    double x, u, v, longest = JKR_FAST_RANGE * (f->adhesive ? f->a_c : f->radius);
    if (radius == 0 && f->status == JKR_OK)
        return jkr_none(state, JKR_OK);
    if (f->status != JKR_OK || !(radius <= longest && radius >= longest * (1 / JKR_FAST_RANGE / JKR_FAST_RANGE)))
        return radius < 0 ? jkr_none(state, JKR_DOMAIN_ERROR) : jkr_fast_refused(f, radius, state);
    if (!f->adhesive)
        return jkr_fast_hertz(f, radius, state);
    x = radius * f->per_a_c;
    u = sqrt(x);
    v = x * u;
    state->contact_radius = radius;
    state->indentation = f->d_c * (u * (v - 4));
    state->force = f->sixth_p * (v * (v - 6));
    if (fabs(v - 1) <= 8 * DBL_EPSILON) {
        state->stiffness = HUGE_VAL;
        return JKR_FOLD;
    }
    state->stiffness = f->two_e * radius * ((v - 3) / (v - 1));
    return JKR_OK;
}

/* jkr_at_force in doubles: a within 16 units of 2^-53, d within 16 of the sum of its two parts, the stiffness within
 * 48 (1 + v/|v - 1|) of itself. */
static inline int jkr_fast_at_force(const jkr_fast *fast, double force, int branch, jkr_state *state)
{
    const jkr_fast *f = fast;
    double phi, gap, root, u, v;
    if (f->status != JKR_OK || !(fabs(force) <= f->strongest))
        return jkr_fast_refused(f, force, state);
    if (branch == JKR_UNSTABLE && (force >= 0 || !f->adhesive))
        return jkr_none(state, JKR_NO_EQUILIBRIUM);
    if (!f->adhesive) {
        if (force <= 0)
            return jkr_none(state, force < 0 ? JKR_NO_EQUILIBRIUM : JKR_FOLD);
        if (force < f->weakest)
            return jkr_fast_refused(f, force, state);
        jkr_fast_hertz(f, cbrt(force / f->hertz), state);
        state->force = force;
        return JKR_OK;
    }
    if (branch == JKR_UNSTABLE && force > -f->weakest)
        return jkr_fast_refused(f, force, state);
    phi = force * f->per_sixth_p[0];
    gap = phi < -6 ? jkr_fast_sum(force, f->per_sixth_p, 9) : phi + 9;
    if (gap < 2 * DBL_EPSILON) {
        if (gap < -9 * DBL_EPSILON)
            return jkr_none(state, JKR_NO_EQUILIBRIUM);
        return jkr_fast_fold(f, JKR_FORCE, force, state);
    }
    root = sqrt(gap);
    v = 3 + root;
    if (branch == JKR_UNSTABLE) {
        v = -phi / v;
        root = -root;
    }
    u = cbrt(v);
    state->contact_radius = f->a_c * (u * u);
    state->indentation = f->d_c * (u * (v - 4));
    state->force = force;
    if (fabs(v - 1) <= 8 * DBL_EPSILON) { /* the fold of the other control */
        state->stiffness = HUGE_VAL;
        return JKR_OVERFLOW;
    }
    state->stiffness = f->two_e * state->contact_radius * (root / (v - 1));
    return JKR_OK;
}

/* jkr_at_indentation in doubles: a within 16 units of 2^-53, F within 16 of the sum of its two parts, the stiffness within
 * 48 (1 + 3/|v - 3|) of itself. */
static inline int jkr_fast_at_indentation(const jkr_fast *fast, double indentation, int branch, jkr_state *state)
{
    const jkr_fast *f = fast;
    double delta, epsilon, s, u, v, minus1;
    if (f->status != JKR_OK || !(fabs(indentation) <= f->longest))
        return jkr_fast_refused(f, indentation, state);
    if (branch == JKR_UNSTABLE && (indentation >= 0 || !f->adhesive))
        return jkr_none(state, JKR_NO_EQUILIBRIUM);
    if (!f->adhesive) {
        if (indentation <= 0)
            return jkr_none(state, indentation < 0 ? JKR_NO_EQUILIBRIUM : JKR_FOLD);
        if (indentation < f->shortest)
            return jkr_fast_refused(f, indentation, state);
        jkr_fast_hertz(f, sqrt(indentation * f->radius), state);
        state->indentation = indentation;
        return JKR_OK;
    }
    if (branch == JKR_UNSTABLE && indentation > -f->shortest)
        return jkr_fast_refused(f, indentation, state);
    delta = indentation * f->per_d[0];
    if (branch == JKR_UNSTABLE && delta > -2) {
        u = jkr_small_u(-0.25 * delta);
        v = u * u * u;
        minus1 = v - 1;
    } else {
        epsilon = delta < -2 ? jkr_fast_sum(indentation, f->per_d, 3) : delta + 3;
        if (epsilon < DBL_EPSILON / 2) {
            if (epsilon < -3 * DBL_EPSILON)
                return jkr_none(state, JKR_NO_EQUILIBRIUM);
            return jkr_fast_fold(f, JKR_INDENTATION, indentation, state);
        }
        s = jkr_s_of(epsilon, branch);
        u = 1 + s;
        v = u * u * u;
        minus1 = s * (3 + s * (3 + s));
    }
    /* v^2 - 6 v = u^2 (d/D - 2 u) has a third of the error of v. */
    state->contact_radius = f->a_c * (u * u);
    state->indentation = indentation;
    state->force = f->sixth_p * ((u * u) * (delta - 2 * u));
    state->stiffness = f->two_e * state->contact_radius * ((v - 3) / minus1);
    return JKR_OK;
}

static inline int jkr_fast_detached(double indentation, jkr_state *state)
{
    jkr_none(state, JKR_DETACHED);
    state->indentation = indentation;
    return JKR_DETACHED;
}

/* jkr_follow in doubles, with the errors of jkr_fast_at_indentation. An edge that is balanced to within some roundings may be taken
 * for pinned or for moving, whose states agree to within these errors but not in their stiffness. */
static inline int jkr_fast_follow(const jkr_fast *advancing, const jkr_fast *receding, double radius, double indentation,
                                  jkr_state *state)
{
    const jkr_fast *f1 = advancing, *f2 = receding, *moving = NULL;
    double excess, root, g = 0;
    int status = JKR_NO_EQUILIBRIUM;
    if (f1->status != JKR_OK || f2->status != JKR_OK)
        return jkr_none(state, f1->status != JKR_OK ? f1->status : f2->status);
    if (f1->radius != f2->radius || f1->two_e != f2->two_e || f1->edge > f2->edge
        || !(radius >= 0 && radius <= DBL_MAX && fabs(indentation) <= DBL_MAX))
        return jkr_none(state, JKR_DOMAIN_ERROR);
    if (radius > 0) {
        if (!jkr_fast_scale(radius * f1->per_radius) || fabs(indentation) > f1->radius * JKR_FAST_RANGE)
            return jkr_none(state, JKR_INACCURATE);
        g = radius * radius * f1->per_radius;
        excess = g - indentation;
        root = sqrt(radius);
        if (excess < f1->edge * root)
            moving = f1;
        else if (excess > f2->edge * root) {
            /* An edge inside of the fold under fixed grips finds no equilibrium on its way. */
            if (f2->adhesive ? radius < f2->a_c : indentation <= 0)
                return jkr_fast_detached(indentation, state);
            moving = f2;
        }
    } else {
        if (indentation < 0 || (indentation == 0 && !f1->adhesive))
            return jkr_fast_detached(indentation, state);
        moving = f1;
    }
    if (moving) {
        status = jkr_fast_at_indentation(moving, indentation, JKR_STABLE, state);
        if (status == JKR_INACCURATE || radius == 0)
            return status;
        if (moving == f1 && status == JKR_OK && state->contact_radius >= radius)
            return status;
        if (moving == f2 && status == JKR_NO_EQUILIBRIUM)
            return jkr_fast_detached(indentation, state);
        if (moving == f2 && state->contact_radius <= radius)
            return status;
    }
    state->contact_radius = radius;
    state->indentation = indentation;
    state->force = f1->two_e * radius * (indentation - g / 3);
    state->stiffness = f1->two_e * radius;
    return JKR_OK;
}

#endif
