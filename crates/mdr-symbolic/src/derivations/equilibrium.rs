//! Equilibrium and its stability for any profile: (1.5) to (1.11).

use super::{ABOVE, BELOW, BOTH, Entry, POSITIVE, Step};

const ANY: &[&str] = &["any profile $g$", "the outer springs are stretched: `g > d`"];

pub(super) const INDENTATION: Entry = Entry {
    id: "1.5",
    title: "The indentation in equilibrium",
    refuted: false,
    assumptions: ANY,
    steps: &[
        Step::proved(
            POSITIVE,
            "at(diff(U, a), d, d_g) = 0",
            "`d_g = g - Δl` makes the energy of (1.4) stationary in the contact radius.",
        ),
        Step::proved(
            POSITIVE,
            "diff(U, a) = E*(d - g - Δl)*(d - g + Δl)",
            "The only other zero is `d = g + Δl`, where the outer springs are compressed: excluded.",
        ),
    ],
    erratum: None,
    references: &[],
};

pub(super) const FORCE: Entry = Entry {
    id: "1.6",
    title: "The normal force",
    refuted: false,
    assumptions: &["any profile $g$"],
    steps: &[
        Step::proved(
            POSITIVE,
            "diff(U, d) = 2*E*(a*d - G)",
            "The force is the derivative of the energy with respect to the indentation at fixed contact radius: the sum \
             over the springs, $2 E^* \\int (d - g) \\, dx$.",
        ),
        Step::proved(
            POSITIVE,
            "2*E*int(d - κ*C*x^n, x, a) = 2*E*(a*d - κ*C*a^(n + 1)/(n + 1))",
            "The same for a power law, by its integral.",
        ),
        Step::proved(
            POSITIVE,
            "diff(F_g, a) = 2*E*(a*diff(d_g, a) - Δl)",
            "The slope of the force along the equilibria, with `F_g = 2*E*(a*d_g - G)`.",
        ),
    ],
    erratum: None,
    references: &[],
};

pub(super) const BALANCE: Entry = Entry {
    id: "1.7",
    title: "Equilibrium as an intersection of two curves",
    refuted: false,
    assumptions: ANY,
    steps: &[Step::proved(
        POSITIVE,
        "diff(U, a)/(E*(g - d + Δl)) = g - d - Δl",
        "The slope of the energy over a positive number: it vanishes where the curves `g - d` and `Δl` intersect, and \
         has the sign of their difference elsewhere.",
    )],
    erratum: None,
    references: &[],
};

pub(super) const SHRINKS: Entry = Entry {
    id: "1.8",
    title: "Where the contact shrinks",
    refuted: false,
    assumptions: ANY,
    steps: &[Step::proved(
        POSITIVE,
        "at(diff(U, a), d, g - (Δl + δ)) > 0",
        "Where `g - d` exceeds `Δl`, by `δ > 0`, the energy grows with the contact radius: the contact shrinks.",
    )],
    erratum: None,
    references: &[],
};

pub(super) const GROWS: Entry = Entry {
    id: "1.9",
    title: "Where the contact grows",
    refuted: false,
    assumptions: &["any profile $g$"],
    steps: &[
        Step::proved(
            POSITIVE,
            "at(at(diff(U, a), d, g - y), w, E*(y + δ)^2/(2*π*a)) < 0",
            "Where the elongation `y = g - d` falls short of `Δl`, by `δ > 0`, the energy falls with the contact radius: the \
             contact grows. Here `d = g - y`, and `Δl = y + δ` is put in as the work of adhesion that belongs to it.",
        ),
        Step::proved(
            POSITIVE,
            "at(at(diff(U, a), d, g + y), w, E*(y + δ)^2/(2*π*a)) < 0",
            "The same where the outer springs are compressed by `y`, less than `Δl`,",
        ),
        Step::proved(
            POSITIVE,
            "at(diff(U, a), d, g) < 0",
            "and where they are relaxed: the contact grows wherever $|g(a) - d| \\lt \\Delta l(a)$.",
        ),
    ],
    erratum: None,
    references: &[],
};

pub(super) const TANGENCY: Entry = Entry {
    id: "1.10",
    title: "The condition of instability",
    refuted: false,
    assumptions: &["any profile $g$", "the indentation is controlled"],
    steps: &[
        Step::proved(POSITIVE, "diff(Δl, a) = sqrt(π*w/(2*E*a))", "The slope of `Δl`."),
        Step::proved(
            POSITIVE,
            "at(diff(diff(U, a), a), d, d_g) = 2*E*Δl*diff(d_g, a)",
            "The curvature of the energy in an equilibrium has the sign of $d'(a) = g'(a) - \\Delta l'(a)$. The equilibrium is stable \
             where that is positive, and stability ends where it vanishes: the curves touch.",
        ),
    ],
    erratum: None,
    references: &[],
};

pub(super) const REGIMES: Entry = Entry {
    id: "1.11",
    title: "Power laws and their two regimes",
    refuted: false,
    assumptions: &["$f = C r^n$ with `n > 0`", "the indentation is controlled"],
    steps: &[
        Step::proved(
            POSITIVE,
            "κ*C*a^n/Δl = κ*C/sqrt(2*π*w/E)*a^(n - 1/2)",
            "The ratio of `g` to `Δl` grows with `a` for `n > 1/2` and falls for `n < 1/2`; $g$ is that of (1.12).",
        ),
        Step::proved(
            BOTH,
            "at(d_n, a, a_0) = 0",
            "At `d = 0` there is one equilibrium, at `a_0 = (4*n^2*B/N^2)^(1/(2*n - 1))` with `N = n*κ*C`, where the ratio is 1. \
             The indentation `d_n = κ*C*a^n - Δl` is that of (1.13).",
        ),
        Step::proved(ABOVE, "at(diff(d_n, a), a, a_0) > 0", "For `n > 1/2` it is stable (figure 1a)."),
        Step::proved(
            BELOW,
            "at(diff(d_n, a), a, a_0) < 0",
            "For `n < 1/2` it is unstable (figure 3a): a smaller contact shrinks to nothing, a larger one becomes complete.",
        ),
    ],
    erratum: None,
    references: &[],
};
