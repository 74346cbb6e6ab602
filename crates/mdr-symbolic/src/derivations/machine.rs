//! Any profile and power laws on a machine of finite stiffness.

use super::{Entry, POSITIVE, Step};

pub(super) const CRITICAL: Entry = Entry {
    id: "critical-machine",
    title: "The instability on a machine of finite stiffness",
    refuted: false,
    assumptions: &["the position $d + F/k$ of a machine of stiffness `k > 0` is controlled"],
    steps: &[
        Step::proved(
            POSITIVE,
            "at(diff(U + k*(δ - d)^2/2, d), d, (k*δ + 2*E*G)/(k + 2*E*a)) = 0",
            "For any profile: at a given position $\\delta$ of the machine, the energy of contact and machine is least over the indentation, \
             at any contact radius, where the two forces balance. Its slope over the radius is that of 1.4 there.",
        ),
        Step::proved(
            POSITIVE,
            "at(diff(E*(((k*δ + 2*E*G)/(k + 2*E*a) - g)^2 - Δl^2), a), δ, ((g - Δl)*(k + 2*E*a) - 2*E*G)*k^(-1)) \
             = 2*E*Δl/(k + 2*E*a)*k*diff(d_g + F_g/k, a)",
            "Its second derivative in an equilibrium has the sign of the slope of the controlled position along the equilibria: \
             the equilibrium is stable where that position grows with the radius.",
        ),
        Step::proved(
            POSITIVE,
            "k*diff(d_g + F_g/k, a) = (k + 2*E*a)*diff(d_g, a) - 2*E*Δl",
            "For any profile: the slope of the controlled position along the equilibria. Stability ends where it vanishes.",
        ),
        Step::proved(
            POSITIVE,
            "k*diff(d_g + F_g/k, a) = (k + 2*E*a)*(g' - λ*sqrt(B/a))",
            "So `g'` is `λ` times the slope of `Δl` there, with `λ = (k + 6*E*a)/(k + 2*E*a)`.",
        ),
        Step::proved(POSITIVE, "at(λ, k, 0) = 3", "A very compliant machine is a dead load."),
        Step::proved(POSITIVE, "λ - 1 = 4*E*a/(k + 2*E*a)", "A very stiff one is fixed grips: `λ` tends to 1."),
        Step::proved(POSITIVE, "3 - λ = 2*k/(k + 2*E*a)", "So `λ` lies between 1 and 3."),
        Step::proved(POSITIVE, "diff(λ, a) > 0", "Between the two limits `λ` grows with the contact radius."),
        Step::proved(
            POSITIVE,
            "k*diff(d_n + F_n/k, a) = (k + 2*E*a)*(N*a^(n - 1) - λ*sqrt(B/a))",
            "For a power law the folds are the roots of `N*a^(n - 1/2) = λ*sqrt(B)`.",
        ),
        Step::proved(
            POSITIVE,
            "at(d_n, C, Λ*sqrt(B)*a^(1/2 - n)/(n*κ)) = (Λ - 2*n)/n*sqrt(B*a)",
            "The indentation at a fold at which `λ` has the value `Λ`. `Λ = 1` and `Λ = 3` are the cases of fixed grips and dead load.",
        ),
        Step::proved(
            POSITIVE,
            "at(F_n, C, Λ*sqrt(B)*a^(1/2 - n)/(n*κ)) = 2*(Λ - 2*(n + 1))/(n + 1)*E*a*sqrt(B*a)",
            "The force there.",
        ),
    ],
    erratum: None,
    references: &["D. Maugis, Contact, Adhesion and Rupture of Elastic Solids, Springer 2000"],
};
