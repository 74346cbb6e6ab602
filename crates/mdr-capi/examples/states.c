/* States of a glass bead on rubber under dead loads, in C.
 *
 *     cc states.c -I../include -L../../../target/capi/lib -lmdr -lm -o states && ./states */
#include "mdr.h"

#include <stdio.h>

static const char scene_text[] = "[profile]\n"
                                 "kind = \"paraboloid\"\n"
                                 "radius = \"10 um\"\n"
                                 "[material]\n"
                                 "e_star = \"1.3 MPa\"\n"
                                 "work_of_adhesion = \"50 mJ/m^2\"\n"
                                 "[control]\n"
                                 "kind = \"force\"\n"
                                 "[output]\n"
                                 "want = [\"folds\"]\n";

int main(void)
{
    const double forces[] = { 2e-6, 0, -2e-6, -3e-6 };
    enum { COUNT = sizeof forces / sizeof forces[0] };
    double a[COUNT], d[COUNT];
    int status[COUNT], i;
    mdr_scene *scene = mdr_scene_read(scene_text);
    mdr_contact *contact = mdr_contact_new(scene);
    char *answer = mdr_scene_solve(scene, mdr_certified() ? 20 : -1);
    if (!scene || !contact || !answer) {
        fprintf(stderr, "%s\n", mdr_error());
        return 1;
    }
    if (mdr_states(contact, MDR_FORCE, 0, MDR_LARGEST, forces, COUNT, a, d, NULL, status) != 0) {
        fprintf(stderr, "%s\n", mdr_error());
        return 1;
    }
    printf("F, N; a, m; d, m\n");
    for (i = 0; i < COUNT; i++)
        printf("%g %.6g %.6g %s\n", forces[i], a[i], d[i], mdr_status_name(status[i]));
    printf("%s\n", answer);
    mdr_text_free(answer);
    mdr_contact_free(contact);
    mdr_scene_free(scene);
    return 0;
}
