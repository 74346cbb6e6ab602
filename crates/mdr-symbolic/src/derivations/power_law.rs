//! Power laws under controlled indentation: (1.13) to (1.17).

use super::{ABOVE, BELOW, BOTH, Entry, Erratum, POSITIVE, Step};

const POWER: &[&str] = &["$f = C r^n$ with `n > 0`", "the indentation is controlled"];
const JKR: &str = "K. L. Johnson, K. Kendall, A. D. Roberts, Proceedings of the Royal Society A 324 (1971) 301–313";
const PRINTED_RADIUS: &str = "Equation (1.15) has the exponent `1/(1 - 2*n)`; it must be `1/(2*n - 1)`.";

pub(super) const INDENTATION: Entry = Entry {
    id: "1.13",
    title: "The indentation of a power law",
    refuted: false,
    assumptions: &["$f = C r^n$ with `n > 0`"],
    steps: &[
        Step::proved(
            POSITIVE,
            "at(d_g, g, κ*C*a^n) = κ*C*a^n - sqrt(2*π*a*w/E)",
            "Equation (1.5) with the transform (1.12). From here on `d_n = κ*C*a^n - Δl`; `d_g = g - Δl` stays that of any profile.",
        ),
        Step::proved(POSITIVE, "κ*C*a^n ~ a", "`C` has the dimension of a length to the power `1 - n`."),
    ],
    erratum: None,
    references: &[],
};

pub(super) const TANGENCY: Entry = Entry {
    id: "1.14",
    title: "The condition of instability of a power law",
    refuted: false,
    assumptions: POWER,
    steps: &[
        Step::proved(
            POSITIVE,
            "diff(d_n, a) = n*κ*C*a^(n - 1) - sqrt(π*w/(2*E*a))",
            "The condition (1.10), that this slope be 0, is (1.14).",
        ),
        Step::proved(
            POSITIVE,
            "diff(d_n, a) = sqrt(B/a)*(N/sqrt(B)*a^(n - 1/2) - 1)",
            "With `N = n*κ*C`. The bracket is monotone in `a` for $n \\ne \\tfrac12$, so it has one zero.",
        ),
    ],
    erratum: None,
    references: &[],
};

pub(super) const RADIUS: Entry = Entry {
    id: "1.15",
    title: "The critical contact radius",
    refuted: true,
    assumptions: POWER,
    steps: &[
        Step::refuted(
            BOTH,
            "(π*w/(2*E*n^2*κ^2*C^2))^(1/(1 - 2*n)) ~ a",
            "As printed it is no length: the bracket has the dimension of a length to the power `2*n - 1`.",
        ),
        Step::refuted(
            BOTH,
            "at(diff(d_n, a), a, (π*w/(2*E*n^2*κ^2*C^2))^(1/(1 - 2*n))) = 0",
            "As printed it does not fulfil (1.14).",
        ),
        Step::refuted(
            ABOVE,
            "at(at((π*w/(2*E*n^2*κ^2*C^2))^(1/(1 - 2*n)), n, 2), C, 1/(2*R))^3 = π*w*R^2/(8*E)",
            "As printed it contradicts Johnson, Kendall and Roberts for the paraboloid.",
        ),
        Step::at(
            &[("n", "2"), ("C", "1/2"), ("E", "1"), ("w", "1")],
            ABOVE,
            "at(diff(d_n, a), a, (π*w/(2*E*n^2*κ^2*C^2))^(1/(1 - 2*n))) > 1.6",
            "A counter-example in numbers: with $R = E^* = w = 1$ the printed radius is 1.366, and the two sides of (1.14) differ \
             there by 1.66. The right radius is 0.732.",
        ),
        Step::proved(
            BOTH,
            "at(diff(d_n, a), a, (π*w/(2*E*n^2*κ^2*C^2))^(1/(2*n - 1))) = 0",
            "With the exponent corrected it solves (1.14); as the bracket in (1.14) has one zero, it is the only one. Written \
             `a_c = (B/N^2)^(1/(2*n - 1))`.",
        ),
        Step::proved(BOTH, "a_c ~ a", "Corrected, it is a length."),
        Step::proved(
            ABOVE,
            "at(at(a_c, n, 2), C, 1/(2*R))^3 = π*w*R^2/(8*E)",
            "Corrected, it is the radius of Johnson, Kendall and Roberts at fixed grips.",
        ),
        Step::proved(
            ABOVE,
            "at(diff(diff(d_n, a), a), a, a_c) > 0",
            "For `n > 1/2` the indentation is a minimum there: pulled further, the contact breaks.",
        ),
        Step::proved(
            BELOW,
            "at(diff(diff(d_n, a), a), a, a_c) < 0",
            "For `n < 1/2` it is a maximum: pressed further, the contact becomes complete.",
        ),
    ],
    erratum: Some(Erratum { text: PRINTED_RADIUS, shown_by: &[0, 1, 2, 3, 4, 5] }),
    references: &[JKR],
};

pub(super) const FORCE: Entry = Entry {
    id: "1.16",
    title: "The force of a power law",
    refuted: false,
    assumptions: &["$f = C r^n$ with `n > 0`"],
    steps: &[
        Step::proved(
            POSITIVE,
            "at(2*E*int(d - κ*C*x^n, x, a), d, d_n) = 2*E*n/(n + 1)*κ*C*a^(n + 1) - sqrt(8*π*a^3*E*w)",
            "The force (1.6) with the indentation (1.13), `d_n`.",
        ),
        Step::proved(
            POSITIVE,
            "2*E*n/(n + 1)*κ*C*a^(n + 1) - sqrt(8*π*a^3*E*w) = F_n",
            "Written with a common factor: `F_n = 2*E*a*(n/(n + 1)*κ*C*a^n - Δl)`, the force of a power law from here on.",
        ),
        Step::proved(
            POSITIVE,
            "2*E*(a*d_n - int(κ*C*x^n, x, a)) = F_n",
            "It is `F_g = 2*E*(a*d_g - G)`, the force of any profile, for this one: with `d_n` and with the integral of its g.",
        ),
        Step::proved(POSITIVE, "diff(F_n, a) = 2*E*a*(N*a^(n - 1) - 3*sqrt(B/a))", "Its slope along the equilibria."),
    ],
    erratum: None,
    references: &[],
};

pub(super) const PULL_OFF: Entry = Entry {
    id: "1.17",
    title: "The force at the instability",
    refuted: false,
    assumptions: POWER,
    steps: &[
        Step::proved(
            BOTH,
            "F_c = -2*(2*n + 1)/(n + 1)*E^(-(n - 2)/(1 - 2*n))*(π*w/2)^(-(n + 1)/(1 - 2*n))\
             *(1/(n*C*κ))^(-3/(1 - 2*n))",
            "The force (1.16) at the corrected radius is (1.17) as printed, with `C` for its $c$.",
        ),
        Step::refuted(
            BOTH,
            "at(F_n, a, (B/N^2)^(1/(1 - 2*n))) = -2*(2*n + 1)/(n + 1)*E^(-(n - 2)/(1 - 2*n))\
             *(π*w/2)^(-(n + 1)/(1 - 2*n))*(1/(n*C*κ))^(-3/(1 - 2*n))",
            "At the radius (1.15) as printed it is not: the paper itself had the right radius at this place.",
        ),
        Step::proved(
            BOTH,
            "F_c = -2*(2*n + 1)/(n + 1)*E*sqrt(B)*a_c^(3/2)",
            "Factored. Nothing cancels in this form, as it does in (1.16).",
        ),
        Step::proved(BOTH, "F_c < 0", "The force is tensile in both regimes."),
        Step::proved(ABOVE, "at(at(F_c, n, 2), C, 1/(2*R)) = -5/6*π*w*R", "The paraboloid at fixed grips."),
    ],
    erratum: Some(Erratum {
        text: "Equation (1.17) writes $c$ for the coefficient `C`. It is the force at the corrected radius, not at the one \
               printed in (1.15).",
        shown_by: &[0, 1],
    }),
    references: &[JKR],
};

pub(super) const CRITICAL: Entry = Entry {
    id: "critical-indentation",
    title: "The critical indentation, and where the force turns tensile",
    refuted: false,
    assumptions: POWER,
    steps: &[
        Step::proved(BOTH, "d_c = (1 - 2*n)/n*sqrt(B*a_c)", "The indentation (1.13) at the critical radius, factored."),
        Step::proved(ABOVE, "d_c < 0", "For `n > 1/2` the contact has to be pulled to break."),
        Step::proved(BELOW, "d_c > 0", "For `n < 1/2` it has to be pressed to become complete."),
        Step::proved(
            BOTH,
            "at(F_n, a, a_z) = 0",
            "Along the equilibria the force vanishes at one radius, `a_z = (4*(n + 1)^2*B/N^2)^(1/(2*n - 1))`.",
        ),
        Step::proved(
            BOTH,
            "a_z/a_c = (4*(n + 1)^2)^(1/(2*n - 1))",
            "For `n < 1/2` a number above 1 has a negative exponent: the radius of no force is smaller than the critical one.",
        ),
        Step::enclosed(BELOW, "(4*(n + 1)^2)^(1/(2*n - 1)) < 1", "The same in numbers."),
        Step::proved(
            BELOW,
            "F_c < 0",
            "So on the stable branch of `n < 1/2`, where $0 \\lt a \\lt a_c$ and $0 \\lt d \\lt d_c$, the force is compressive up to `a_z` and \
             tensile from there to the instability.",
        ),
    ],
    erratum: Some(Erratum {
        text: "“The adhesion force is exactly zero” for `n < 1/2` is true for $d \\le 0$ only. On the stable branch, at small \
               positive indentation, the force becomes tensile before the instability, and `F_c` of (1.17) is tensile itself.",
        shown_by: &[2, 3, 4, 5, 6],
    }),
    references: &[],
};
