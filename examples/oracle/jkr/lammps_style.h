// SPDX-License-Identifier: MIT
// JKR for a code in the style of LAMMPS' `granular`: per pair of types, E* and the cohesion are constants, and the radius is that of
// the pair at hand. The cohesion of LAMMPS is half of the work of adhesion; `delta` is the overlap, radsum - r. A contact begins when
// the spheres touch, and lasts to the fold at fixed grips, since the distance is what a time step is given.
#ifndef JKR_LAMMPS_STYLE_H
#define JKR_LAMMPS_STYLE_H

#include "jkr.h"

namespace granular {

// What a pair style keeps while it works on one pair.
struct NormalJkr {
    jkr_fast contact;
    double contact_radius, Fne, F_pulloff, stiffness;

    // Once per pair of radii and types, not once per time step. False where E*, R or the cohesion leave no JKR contact.
    bool init(double Reff, double Emix, double cohesion)
    {
        jkr_contact exact;
        if (jkr_set(&exact, Reff, Emix, 2 * cohesion) != JKR_OK || jkr_fast_set(&contact, &exact) != JKR_OK)
            return false;
        F_pulloff = -contact.folds[JKR_FORCE].force;
        return true;
    }

    // How far beyond touch the pair can be drawn: for neighbour lists and the size of ghost layers.
    double pulloff_distance() const { return -contact.folds[JKR_INDENTATION].indentation; }

    // Whether there is contact at this overlap; then contact radius, force and stiffness are set, else they are 0. `touched` is the
    // history: without it surfaces that have not met would attract each other.
    bool calculate_forces(double delta, bool touched)
    {
        jkr_state state;
        int status = JKR_NO_EQUILIBRIUM;
        jkr_none(&state, status);
        if (touched || delta >= 0)
            status = jkr_fast_at_indentation(&contact, delta, JKR_STABLE, &state);
        contact_radius = state.contact_radius;
        Fne = state.force;
        // The stiffness is infinite at the fold: a time step that is chosen by it must not see that.
        stiffness = status == JKR_OK ? state.stiffness : 0;
        return status == JKR_OK || status == JKR_FOLD;
    }
};

} // namespace granular

#endif
