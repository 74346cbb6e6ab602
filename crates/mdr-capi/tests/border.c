/* Every function of mdr.h, against closed forms of the JKR paraboloid; what is wrong is an error, and nothing crashes. C99 or C++11. */
#include "mdr.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static int checks, failures;

#define CHECK(condition)                                                                                                        \
    do {                                                                                                                        \
        checks++;                                                                                                               \
        if (!(condition)) {                                                                                                     \
            failures++;                                                                                                         \
            printf("%s:%d: fails: %s (%s)\n", __FILE__, __LINE__, #condition, mdr_error());                                     \
        }                                                                                                                       \
    } while (0)

static const double R = 1e-5, E = 1.3e6, w = 0.05, pi = 3.14159265358979323846;

/* Within some roundings times the condition of questions that are not beside a fold. */
static int near(double found, double right) { return fabs(found - right) <= 1e-13 * fabs(right); }

static mdr_contact *bead(void)
{
    mdr_scene *scene = mdr_scene_read("[profile]\nkind = \"paraboloid\"\nradius = 1e-5\n[material]\ne_star = 1.3e6\n"
                                      "work_of_adhesion = 0.05\n[control]\nkind = \"force\"\n[output]\nwant = [\"folds\"]\n");
    mdr_contact *contact = mdr_contact_new(scene);
    CHECK(scene != NULL && contact != NULL && strcmp(mdr_error(), "") == 0);
    mdr_scene_free(scene); /* the contact does not need it */
    return contact;
}

static void errors(void)
{
    mdr_contact *contact = bead();
    mdr_scene *scene;
    char *answer;
    double number = 1;
    CHECK(mdr_scene_read(NULL) == NULL && strstr(mdr_error(), "null") != NULL);
    CHECK(mdr_scene_read("[profile]\nkind = \"spher\"\n") == NULL && strstr(mdr_error(), "sphere") != NULL);
    CHECK(mdr_scene_read("\xff") == NULL && strstr(mdr_error(), "UTF-8") != NULL);
    CHECK(mdr_scene_open("/no/such/file.toml") == NULL && strstr(mdr_error(), "/no/such/file.toml") != NULL);
    CHECK(mdr_contact_new(NULL) == NULL && strcmp(mdr_error(), "") != 0);
    scene = mdr_scene_read("[profile]\nkind = \"paraboloid\"\nradius = 1\n[material]\ne_star = 1\n"
                           "work_of_adhesion = { advancing = 0, receding = 1 }\n"
                           "[control]\nkind = \"force\"\npath = [1, -5]\n[output]\nwant = [\"path\"]\n");
    CHECK(scene != NULL && mdr_contact_new(scene) == NULL && strstr(mdr_error(), "work_of_adhesion") != NULL);
    answer = mdr_scene_solve(scene, -1);
    CHECK(answer != NULL && strstr(answer, "\"receding\"") != NULL);
    mdr_text_free(answer);
    mdr_scene_free(scene);
    CHECK(mdr_scene_solve(NULL, 0) == NULL && mdr_scene_read("[") == NULL);
    CHECK(mdr_states(NULL, MDR_FORCE, 0, MDR_LARGEST, &number, 1, &number, NULL, NULL, NULL) == -1);
    CHECK(mdr_states(contact, MDR_FORCE, 0, MDR_LARGEST, NULL, 1, &number, NULL, NULL, NULL) == -1);
    CHECK(mdr_states(contact, 7, 0, MDR_LARGEST, &number, 1, &number, NULL, NULL, NULL) == -1 && strstr(mdr_error(), "7") != NULL);
    CHECK(mdr_states(contact, MDR_FORCE, 0, 7, &number, 1, &number, NULL, NULL, NULL) == -1);
    CHECK(mdr_states(contact, MDR_MACHINE, 0, MDR_LARGEST, &number, 1, &number, NULL, NULL, NULL) == -1);
    CHECK(mdr_follow(contact, MDR_FORCE, 0, MDR_LARGEST, NULL, 0, NULL, NULL, NULL, NULL) == -1);
    CHECK(mdr_states(contact, MDR_FORCE, 0, MDR_LARGEST, NULL, 0, NULL, NULL, NULL, NULL) == 0 && strcmp(mdr_error(), "") == 0);
    CHECK(number == 1);
    mdr_contact_free(contact);
    mdr_contact_free(NULL);
    mdr_scene_free(NULL);
    mdr_text_free(NULL);
    mdr_thread_end();
    CHECK(strcmp(mdr_status_name(MDR_NO_EQUILIBRIUM), "no-equilibrium") == 0 && strcmp(mdr_status_name(99), "unknown") == 0);
    CHECK(strcmp(mdr_status_name(-1), "unknown") == 0 && strlen(mdr_version()) >= 5);
}

static void states(void)
{
    const double load = pi * w * R, a_c = cbrt(load * R / (8 * E)), depth = a_c * a_c / R;
    mdr_contact *contact = bead();
    /* v = u^3 = 8: d = D (16 - 8), F = (P/6) (64 - 48), a = 4 a_c. */
    double values[3] = { load * 16 / 6, -2 * load, NAN }, a[3], d[3], force[3];
    int status[3], i;
    CHECK(mdr_states(contact, MDR_FORCE, 0, MDR_LARGEST, values, 3, a, d, force, status) == 0);
    CHECK(status[0] == MDR_OK && status[1] == MDR_NO_EQUILIBRIUM && status[2] == MDR_DOMAIN_ERROR);
    CHECK(near(a[0], 4 * a_c) && near(d[0], 8 * depth) && force[0] == values[0] && isnan(a[1]) && isnan(d[2]));
    values[0] = 8 * depth;
    values[1] = -3.1 * depth;
    CHECK(mdr_states(contact, MDR_INDENTATION, 0, MDR_SMALLEST, values, 2, values, d, force, status) == 0);
    CHECK(near(values[0], 4 * a_c) && near(force[0], load * 16 / 6) && status[1] == MDR_NO_EQUILIBRIUM && isnan(force[1]));
    /* A machine: D = d + F/k. */
    values[0] = 8 * depth + load * 16 / 6 / 0.5;
    CHECK(mdr_states(contact, MDR_MACHINE, 0.5, MDR_LARGEST, values, 1, a, d, force, NULL) == 0);
    CHECK(near(a[0], 4 * a_c) && near(d[0] + force[0] / 0.5, values[0]));
    /* By radius, and their stability under both controls: v = 8, 2 and 1/8. */
    values[0] = 4 * a_c;
    values[1] = cbrt(4) * a_c;
    values[2] = a_c / 4;
    CHECK(mdr_curve(contact, values, 3, d, force, status) == 0);
    CHECK(near(d[0], 8 * depth) && near(force[0], load * 16 / 6) && near(force[1], load / 6 * (4 - 12)) && status[2] == MDR_OK);
    CHECK(mdr_stability(contact, MDR_INDENTATION, 0, values, 3, status) == 0 && status[0] == 1 && status[1] == 1 && status[2] == -1);
    CHECK(mdr_stability(contact, MDR_FORCE, 0, values, 3, status) == 0 && status[0] == 1 && status[1] == -1 && status[2] == -1);
    /* A history: pulled off under a dead load, and back: apart, since a load cannot be held without contact. */
    for (i = 0; i < 3; i++)
        values[i] = load * (i == 0 ? 1 : i == 1 ? -1.4 : -1.6);
    CHECK(mdr_follow(contact, MDR_FORCE, 0, MDR_LARGEST, values, 3, a, d, force, status) == 0);
    CHECK(a[1] > 2 * a_c && a[2] == 0 && force[2] == 0);
    mdr_contact_free(contact);
}

static void folds(void)
{
    const double load = pi * w * R;
    double a[4] = { 0, 0, 0, 0 }, d[4], force[4];
    int kind[4];
    mdr_contact *contact = bead();
    mdr_scene *scene;
    CHECK(mdr_folds(contact, MDR_FORCE, 0, 4, a, d, force, kind) == 1);
    CHECK(near(force[0], -1.5 * load) && kind[0] == MDR_MINIMUM);
    CHECK(mdr_folds(contact, MDR_INDENTATION, 0, 4, a, d, force, kind) == 1 && near(force[0], -load * 5 / 6));
    CHECK(mdr_pull_off(contact, MDR_FORCE, 0, a, d, force) == 0 && near(force[0], -1.5 * load));
    CHECK(mdr_pull_off(contact, MDR_INDENTATION, 0, NULL, NULL, force) == 0 && near(force[0], -load * 5 / 6));
    mdr_contact_free(contact);
    /* Waves: more folds than there is room for. */
    scene = mdr_scene_read("{\"profile\": {\"kind\": \"wavy-paraboloid\", \"radius\": 1, \"amplitude\": 5e-4, \"wavelength\": 0.1},"
                           "\"material\": {\"e_star\": 1, \"work_of_adhesion\": 1e-4}, \"control\": {\"kind\": \"indentation\"},"
                           "\"output\": {\"want\": [\"folds\"]}}");
    contact = mdr_contact_new(scene);
    a[2] = 7;
    CHECK(mdr_folds(contact, MDR_INDENTATION, 0, 2, a, NULL, NULL, kind) == 3);
    CHECK(a[0] < a[1] && a[2] == 7 && kind[0] == MDR_MINIMUM && kind[1] == MDR_MAXIMUM);
    mdr_contact_free(contact);
    mdr_scene_free(scene);
}

static void answers(void)
{
    mdr_scene *scene = mdr_scene_read("[profile]\nkind = \"paraboloid\"\nradius = 1\n[material]\ne_star = 1\nwork_of_adhesion = 1\n"
                                      "[control]\nkind = \"force\"\npath = [1, -5]\n[output]\nwant = [\"folds\", \"path\"]\n");
    char *answer = mdr_scene_solve(scene, -1);
    CHECK(answer != NULL && strstr(answer, "\"schema\":\"mdr.solve/1\"") != NULL && strstr(answer, "\"detached\"") != NULL);
    CHECK(strstr(answer, "-4.71238898038469") != NULL);
    mdr_text_free(answer);
    answer = mdr_scene_solve(scene, 30);
    if (mdr_certified())
        CHECK(answer != NULL && strstr(answer, "-4.71238898038468985769396507492") != NULL);
    else
        CHECK(answer == NULL && strcmp(mdr_error(), "") != 0);
    mdr_text_free(answer);
    mdr_scene_free(scene);
}

int main(void)
{
    errors();
    states();
    folds();
    answers();
    printf("%d checks, %d failed\n", checks, failures);
    return failures != 0;
}
