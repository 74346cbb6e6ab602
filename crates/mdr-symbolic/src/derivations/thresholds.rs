//! n = 1/2: (1.18), (1.19), and the threshold under a dead load.

use super::{Entry, Erratum, HALF as AT_HALF, Step};

const GAUSS: &str =
    "C. F. Gauss, Werke III (1866), on the lemniscate; NIST Digital Library of Mathematical Functions, §19.8";

pub(super) const HALF: Entry = Entry {
    id: "1.18",
    title: "The case n = 1/2",
    refuted: false,
    assumptions: &["$f = C r^{1/2}$"],
    steps: &[
        Step::proved(
            AT_HALF,
            "κ_Γ = π^(3/2)*sqrt(2)/(4*Γ(3/4)^2)",
            "Equation (1.12) at `n = 1/2`, by the reflection $\\Gamma(\\tfrac14) \\, \\Gamma(\\tfrac34) = \\pi \\sqrt2$.",
        ),
        Step::proved(
            AT_HALF,
            "κ*C*a^n/Δl = κ*C/sqrt(2*π*w/E)",
            "`g` and `Δl` are both proportional to `sqrt(a)`: no length is singled out.",
        ),
        Step::enclosed(AT_HALF, "kappa(1/2) = π/(2*agm(1, sqrt(2)))", "By Gauss: half the lemniscate constant."),
        Step::enclosed(
            AT_HALF,
            "kappa(1/2) > 1.3105",
            "The printed value 1,311 is right to its last digit: from below,",
        ),
        Step::enclosed(AT_HALF, "kappa(1/2) < 1.3115", "and from above."),
    ],
    erratum: None,
    references: &[GAUSS],
};

pub(super) const THRESHOLD: Entry = Entry {
    id: "1.19",
    title: "The threshold of C at n = 1/2",
    refuted: false,
    assumptions: &["$f = C r^{1/2}$", "the indentation is controlled"],
    steps: &[
        Step::proved(
            AT_HALF,
            "at(d_n, C, C_ρ) = (ρ - 1)*sqrt(2*π*w*a/E)",
            "With the ratio `ρ` of `κ*C` to `sqrt(2*π*w/E)`: `C_ρ = ρ/κ*sqrt(2*π*w/E)`. All equilibria with `d > 0` are stable for `ρ > 1`, \
             all with `d < 0` are unstable for `ρ < 1`.",
        ),
        Step::proved(AT_HALF, "at(C_ρ, ρ, 1) = 1/κ*sqrt(2*π*w/E)", "The threshold of `C`."),
        Step::proved(
            AT_HALF,
            "at(at(d_n, C, C_ρ), ρ, 1 + t) > 0",
            "I. Above the threshold (`ρ = 1 + t` with `t > 0`) `g` exceeds `Δl` for every `a`: at `d = 0` the contact shrinks (1.8).",
        ),
        Step::proved(
            AT_HALF,
            "at(at(d_n, C, C_ρ), ρ, 1 - t) < 0",
            "II. Below (`ρ = 1 - t`) it grows (1.9) until it is complete.",
        ),
        Step::enclosed(AT_HALF, "1/kappa(1/2) = 2*agm(1, sqrt(2))/π", "The constant of the paper is exactly this."),
        Step::enclosed(
            AT_HALF,
            "1/kappa(1/2) > 0.76275",
            "The printed value 0,7628 is right to its last digit: from below,",
        ),
        Step::enclosed(AT_HALF, "1/kappa(1/2) < 0.76285", "and from above."),
    ],
    erratum: Some(Erratum {
        text: "The number 0.7628 in (1.19) is `1/kappa(1/2)`, exactly `2*agm(1, sqrt(2))/π`, which is $0.762759763501813\\ldots$",
        shown_by: &[1, 4, 5, 6],
    }),
    references: &[GAUSS],
};

pub(super) const UNDER_FORCE: Entry = Entry {
    id: "threshold-force",
    title: "The threshold of C at n = 1/2 under controlled force",
    refuted: false,
    assumptions: &["$f = C r^{1/2}$", "the force is controlled"],
    steps: &[
        Step::proved(AT_HALF, "at(F_n, C, C_ρ) = 2*E*a*sqrt(2*π*w*a/E)*(ρ/3 - 1)", "The force along the equilibria."),
        Step::proved(
            AT_HALF,
            "at(at(F_n, C, C_ρ), ρ, 3) = 0",
            "It vanishes for every radius at `ρ = 3`: the threshold is three times the other.",
        ),
        Step::proved(
            AT_HALF,
            "at(at(F_n, C, C_ρ), ρ, 3 - t) < 0",
            "Below it the force is tensile, although the contact is stable under controlled indentation for $1 \\lt \\rho \\lt 3$.",
        ),
        Step::proved(
            AT_HALF,
            "at(at(diff(F_n, a), C, C_ρ), ρ, 3 + t) > 0",
            "Above it the equilibria are stable under a dead load, too.",
        ),
        Step::enclosed(
            AT_HALF,
            "3/kappa(1/2) > 2.28827929",
            "The threshold in units of `sqrt(2*π*w/E)` is 2.28827929…: above this,",
        ),
        Step::enclosed(AT_HALF, "3/kappa(1/2) < 2.28827930", "and below that."),
    ],
    erratum: None,
    references: &[],
};
