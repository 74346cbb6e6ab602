//! Energy dissipated in jumps under controlled indentation.

use super::{ABOVE, BELOW, BOTH, Entry, Step};

pub(super) const PULL_OFF: Entry = Entry {
    id: "work-pull-off",
    title: "The energy lost when the contact breaks",
    refuted: false,
    assumptions: &["$f = C r^n$ with `n > 1/2`", "the indentation is controlled"],
    steps: &[
        Step::proved(
            BOTH,
            "E*(a*d^2 - 2*d*int(κ*C*x^n, x, a) + int((κ*C*x^n)^2, x, a)) - π*a^2*w = U_n",
            "The energy of any profile, `U`, for a power law.",
        ),
        Step::proved(
            BOTH,
            "diff(U_n, a) = E*((d - κ*C*a^n)^2 - Δl^2)",
            "The energy `U_n = E*int((d - κ*C*x^n)^2, x, a) - π*a^2*w` of a power law, and its slope: the integral, taken \
             exactly, agrees with the general result in 1.4.",
        ),
        Step::proved(
            BOTH,
            "at(at(U_n, d, d_n), a, a_c) = n*(2*n - 1)/((n + 1)*(2*n + 1))*π*a_c^2*w",
            "The energy in the critical state. The broken contact has none: for `n > 1/2` all of this is lost.",
        ),
        Step::proved(ABOVE, "at(at(U_n, d, d_n), a, a_c) > 0", "It is positive."),
        Step::proved(ABOVE, "at(n*(2*n - 1)/((n + 1)*(2*n + 1)), n, 2) = 2/5", "The paraboloid."),
    ],
    erratum: None,
    references: &[],
};

pub(super) const JUMP_IN: Entry = Entry {
    id: "work-jump-in",
    title: "The energy lost when the surfaces jump into contact",
    refuted: false,
    assumptions: &["$f = C r^n$ with `n > 0`, $n \\ne \\tfrac12$", "the indentation is controlled and `d = 0`"],
    steps: &[
        Step::proved(
            BOTH,
            "at(at(U_n, d, 0), a, a_0) = -(2*n - 1)/(2*n + 1)*π*a_0^2*w",
            "The energy of the equilibrium at `d = 0`.",
        ),
        Step::proved(
            ABOVE,
            "at(at(U_n, d, 0), a, a_0) < 0",
            "For `n > 1/2` the contact that forms at first touch has this radius, and the energy is lost.",
        ),
        Step::proved(
            BELOW,
            "at(at(U_n, d, 0), a, a_0) > 0",
            "For `n < 1/2` the equilibrium is unstable, and its energy is the barrier between no contact and complete contact.",
        ),
        Step::proved(ABOVE, "at((2*n - 1)/(2*n + 1), n, 2) = 3/5", "The paraboloid."),
    ],
    erratum: None,
    references: &[],
};
