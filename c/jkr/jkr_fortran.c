/* SPDX-License-Identifier: MIT
 * jkr.h as functions with C linkage, for jkr.f90: contacts are opaque words whose number is checked here. */
#include "jkr.h"

enum { CONTACT_WORDS = 64, FAST_WORDS = 40 };

/* The words of jkr.f90 are enough: these arrays have a positive length. */
typedef char contact_fits[sizeof(jkr_contact) <= CONTACT_WORDS * sizeof(double) ? 1 : -1];
typedef char fast_fits[sizeof(jkr_fast) <= FAST_WORDS * sizeof(double) ? 1 : -1];

int jkr_f_set(void *contact, double radius, double modulus, double work);
int jkr_f_at_contact_radius(const void *contact, double radius, jkr_state *state);
int jkr_f_at_indentation(const void *contact, double indentation, int branch, jkr_state *state);
int jkr_f_at_force(const void *contact, double force, int branch, jkr_state *state);
int jkr_f_fold(const void *contact, int control, jkr_state *state);
int jkr_f_follow(const void *advancing, const void *receding, double radius, double indentation, jkr_state *state);
int jkr_f_fast_set(void *fast, const void *contact);
int jkr_f_fast_at_contact_radius(const void *fast, double radius, jkr_state *state);
int jkr_f_fast_at_indentation(const void *fast, double indentation, int branch, jkr_state *state);
int jkr_f_fast_at_force(const void *fast, double force, int branch, jkr_state *state);
int jkr_f_fast_follow(const void *advancing, const void *receding, double radius, double indentation, jkr_state *state);

int jkr_f_set(void *contact, double radius, double modulus, double work)
{
    return jkr_set((jkr_contact *)contact, radius, modulus, work);
}

int jkr_f_at_contact_radius(const void *contact, double radius, jkr_state *state)
{
    return jkr_at_contact_radius((const jkr_contact *)contact, radius, state);
}

int jkr_f_at_indentation(const void *contact, double indentation, int branch, jkr_state *state)
{
    return jkr_at_indentation((const jkr_contact *)contact, indentation, branch, state);
}

int jkr_f_at_force(const void *contact, double force, int branch, jkr_state *state)
{
    return jkr_at_force((const jkr_contact *)contact, force, branch, state);
}

int jkr_f_fold(const void *contact, int control, jkr_state *state)
{
    return jkr_fold((const jkr_contact *)contact, control, state);
}

int jkr_f_follow(const void *advancing, const void *receding, double radius, double indentation, jkr_state *state)
{
    return jkr_follow((const jkr_contact *)advancing, (const jkr_contact *)receding, radius, indentation, state);
}

int jkr_f_fast_set(void *fast, const void *contact) { return jkr_fast_set((jkr_fast *)fast, (const jkr_contact *)contact); }

int jkr_f_fast_at_contact_radius(const void *fast, double radius, jkr_state *state)
{
    return jkr_fast_at_contact_radius((const jkr_fast *)fast, radius, state);
}

int jkr_f_fast_at_indentation(const void *fast, double indentation, int branch, jkr_state *state)
{
    return jkr_fast_at_indentation((const jkr_fast *)fast, indentation, branch, state);
}

int jkr_f_fast_at_force(const void *fast, double force, int branch, jkr_state *state)
{
    return jkr_fast_at_force((const jkr_fast *)fast, force, branch, state);
}

int jkr_f_fast_follow(const void *advancing, const void *receding, double radius, double indentation, jkr_state *state)
{
    return jkr_fast_follow((const jkr_fast *)advancing, (const jkr_fast *)receding, radius, indentation, state);
}
