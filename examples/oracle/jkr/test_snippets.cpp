// SPDX-License-Identifier: MIT
// Both snippets against the certified table jkr-sphere, at given indentations.
//
//     c++ -std=c++11 -I../../../c/jkr test_snippets.cpp && ./a.out
#include "../cpp/jkr-sphere.h"
#include "lammps_style.h"
#include "lethe_style.h"

#include <cstdio>
#include <cstring>

static int checked, failed;

static void check(bool holds, const mdr_jkr_sphere &row, const char *what)
{
    ++checked;
    if (!holds) {
        ++failed;
        std::printf("%s fails: %s\n", row.id, what);
    }
}

// Four roundings times the condition of the question, as in the other tests of these data.
static bool near(double found, double certified, const mdr_jkr_sphere &row)
{
    return std::fabs(found - certified) <= 4 * row.tolerance * std::fabs(certified);
}

static bool is(const char *text, const char *word) { return std::strcmp(text, word) == 0; }

int main()
{
    for (const auto &row : mdr_jkr_sphere_rows) {
        granular::NormalJkr pair;
        const bool usual = pair.init(row.radius, row.e_star, row.work_of_adhesion / 2);
        if (is(row.question, "fold") && is(row.control, "indentation") && usual) {
            check(near(pair.pulloff_distance(), -row.indentation, row), row, "pulloff_distance");
            check(near(pair.F_pulloff, 1.5 * 3.14159265358979323846 * row.work_of_adhesion * row.radius, row), row, "F_pulloff");
        }
        if (!is(row.question, "equilibrium") || !is(row.control, "indentation") || is(row.branch, "unstable"))
            continue;
        const bool there = is(row.status, "ok");
        const auto found = dem::calculate_jkr_contact(row.indentation, row.radius, row.e_star, row.work_of_adhesion);
        check(found.in_contact == there, row, "Lethe's style: contact");
        if (there) {
            check(near(found.contact_radius, row.contact_radius, row), row, "Lethe's style: contact radius");
            check(near(found.normal_force, row.force, row), row, "Lethe's style: force");
        }
        if (!usual)
            continue;
        check(pair.calculate_forces(row.indentation, true) == there, row, "LAMMPS' style: contact");
        check(pair.calculate_forces(row.indentation, false) == (there && row.indentation >= 0), row, "LAMMPS' style: not yet touched");
        if (there) {
            pair.calculate_forces(row.indentation, true);
            check(near(pair.contact_radius, row.contact_radius, row), row, "LAMMPS' style: contact radius");
            check(near(pair.Fne, row.force, row), row, "LAMMPS' style: force");
        }
    }
    std::printf("%d checks, %d failed\n", checked, failed);
    return failed != 0 || checked < 50;
}
