// SPDX-License-Identifier: MIT
// JKR for a code in the style of Lethe: vectors over pairs of particle types hold the effective properties, and the radius is that of
// the pair. Lethe's effective surface energy, gamma1 + gamma2 - 2 gamma12, is the whole work of adhesion.
#ifndef JKR_LETHE_STYLE_H
#define JKR_LETHE_STYLE_H

#include "jkr.h"

#include <stdexcept>
#include <string>

namespace dem {

struct NormalContact {
    double contact_radius, normal_force, normal_stiffness;
    bool in_contact;
};

// The contact at an overlap, for one call: sets the contact each time, at some 200 ns; keep the jkr_fast of a pair where that counts.
inline NormalContact calculate_jkr_contact(double normal_overlap, double effective_radius, double effective_youngs_modulus,
                                           double effective_surface_energy)
{
    jkr_contact contact;
    jkr_state state;
    const int set = jkr_set(&contact, effective_radius, effective_youngs_modulus, effective_surface_energy);
    if (set != JKR_OK)
        throw std::domain_error("JKR contact of a pair: R and E* must be positive and w not negative");
    const int status = jkr_at_indentation(&contact, normal_overlap, JKR_STABLE, &state);
    switch (status) {
    case JKR_OK:
        return {state.contact_radius, state.force, state.stiffness, true};
    case JKR_FOLD: // the last state: it breaks at the next step away
        return {state.contact_radius, state.force, 0, true};
    case JKR_NO_EQUILIBRIUM:
        return {0, 0, 0, false};
    default:
        throw std::domain_error(std::string("JKR contact at an overlap: ") + jkr_status_name(status));
    }
}

} // namespace dem

#endif
