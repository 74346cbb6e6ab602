/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * mdr.h: adhesive contacts of axisymmetric tips, for C, C++, and what speaks C. Link libmdr; documentation: docs/capi.md of mdr.
 *
 *     mdr_scene *scene = mdr_scene_read("[profile]\nkind = \"sphere\"\n...");   a scene as of docs/scenes.md, TOML or JSON
 *     mdr_contact *contact = mdr_contact_new(scene);                            its profile and material, in doubles
 *     mdr_states(contact, MDR_FORCE, 0, MDR_LARGEST, forces, n, a, d, NULL, status);
 *
 * Units are SI; d and F are positive when pressed in.
 *
 * Errors: a function that returns a pointer gives NULL, one that returns int or ptrdiff_t gives -1, and mdr_error() says why. A value
 * without a state is no error: its numbers are NaN and its status says why.
 *
 * Ownership: what _read, _open, _new and _solve return is freed by its _free, once; NULL may be freed. Strings of mdr_version,
 * mdr_status_name and mdr_error are not freed. Nothing that is passed in is kept: a scene may be freed before the contacts made of
 * it. An output column that is NULL is not written; columns may be the inputs.
 *
 * Threads: handles are never changed by a call, and any number of threads may use one at once. Errors are of the calling thread. No
 * C++ exception and no panic comes out of the library. */
#ifndef MDR_H
#define MDR_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct mdr_scene mdr_scene;
typedef struct mdr_contact mdr_contact;

enum mdr_status {
    MDR_OK = 0,
    MDR_FOLD = 1,           /* the state is the fold itself */
    MDR_NO_EQUILIBRIUM = 2, /* none satisfies the equations */
    MDR_OVERFLOW = 3,       /* beyond the doubles */
    MDR_UNDERFLOW = 4,      /* below the doubles */
    MDR_DOMAIN_ERROR = 5,   /* the value is no question, such as NaN or a radius outside of the profile */
    MDR_NOT_ADMISSIBLE = 6, /* surfaces would overlap outside of the contact; the numbers are there */
    MDR_UNDECIDED = 7
};

/* What is held: d by fixed grips, F by a dead load, D = d + F/k by a machine of stiffness k. The stiffness is used for the last. */
enum mdr_control { MDR_INDENTATION = 0, MDR_FORCE = 1, MDR_MACHINE = 2 };

/* Which of several stable contact radii; or, at the start of a history, surfaces that are apart. */
enum mdr_choice { MDR_LARGEST = 0, MDR_SMALLEST = 1, MDR_APART = 2 };

enum mdr_fold_kind { MDR_MINIMUM = 0, MDR_MAXIMUM = 1 };

/* ---- The library ---- */

/* Such as "0.1.0". */
const char *mdr_version(void);
/* 1 if there are certified digits, 0 if the library was built without GMP. */
int mdr_certified(void);
/* What went wrong in the last call on this thread, "" if nothing. Lives until the next call on this thread. */
const char *mdr_error(void);
/* "ok", "fold", "no-equilibrium", ... as everywhere in mdr. */
const char *mdr_status_name(int status);
/* Frees what this thread keeps of arbitrary precision: for threads that end. */
void mdr_thread_end(void);

/* ---- Scenes ---- */

/* TOML, or JSON if it begins with a brace; UTF-8. Files that it names are looked for from the current folder. */
mdr_scene *mdr_scene_read(const char *text);
/* From a file; files that it names are looked for from its folder. */
mdr_scene *mdr_scene_open(const char *path);
void mdr_scene_free(mdr_scene *scene);
/* All outputs that the scene wants, folds, equilibria, path, energy, fields, as JSON (mdr.solve/1, with a promise on each): in certified
 * digits if `digits` is positive, in doubles if it is negative, as the scene says if it is 0. */
char *mdr_scene_solve(const mdr_scene *scene, int digits);
void mdr_text_free(char *text);

/* ---- The contact of a scene, in columns of doubles ---- */

/* The outputs and the control of the scene are not used. With two works of adhesion it is an error: mdr_scene_solve follows these. */
mdr_contact *mdr_contact_new(const mdr_scene *scene);
void mdr_contact_free(mdr_contact *contact);

/* The stable equilibrium at each value of what is held. */
int mdr_states(const mdr_contact *contact, int control, double stiffness, int choice, const double *values, size_t count,
               double *contact_radius, double *indentation, double *force, int *status);
/* The states along the values, one after the other and slowly: with jumps where they happen, a = F = 0 where surfaces are apart. */
int mdr_follow(const mdr_contact *contact, int control, double stiffness, int start, const double *values, size_t count,
               double *contact_radius, double *indentation, double *force, int *status);
/* The equilibrium with each contact radius, stable or not. */
int mdr_curve(const mdr_contact *contact, const double *radii, size_t count, double *indentation, double *force, int *status);
/* Whether those are stable under a control: 1 stable, 0 neutral, -1 unstable, -2 outside of the profile. */
int mdr_stability(const mdr_contact *contact, int control, double stiffness, const double *radii, size_t count, int *stable);
/* The number of folds under a control; the first `capacity` of them go to the columns, by increasing radius. */
ptrdiff_t mdr_folds(const mdr_contact *contact, int control, double stiffness, size_t capacity, double *contact_radius,
                    double *indentation, double *force, int *kind);
/* The state from which the contact comes off when it is drawn back from 0. */
int mdr_pull_off(const mdr_contact *contact, int control, double stiffness, double *contact_radius, double *indentation,
                 double *force);

#ifdef __cplusplus
}
#endif

#endif
