//! Power laws under a dead load.

use super::{ABOVE, BELOW, BOTH, Entry, POSITIVE, Step};

pub(super) const CRITICAL: Entry = Entry {
    id: "critical-force",
    title: "The instability under controlled force",
    refuted: false,
    assumptions: &["$f = C r^n$ with `n > 0`", "the force is controlled"],
    steps: &[
        Step::proved(
            POSITIVE,
            "diff(at(U - F*d, d, (F + 2*E*G)/(2*E*a)), a) = E*(((F + 2*E*G)/(2*E*a) - g)^2 - Δl^2)",
            "For any profile under a load `F`: the slope of the energy of contact and load over the radius, at the indentation \
             that balances the load. It is that of 1.4.",
        ),
        Step::proved(
            POSITIVE,
            "at(diff(E*(((F + 2*E*G)/(2*E*a) - g)^2 - Δl^2), a), F, (g - Δl)*2*E*a - 2*E*G) = Δl/a*diff(F_g, a)",
            "Its second derivative in an equilibrium has the sign of the slope of the force along the equilibria: the \
             equilibrium is stable where the force grows with the radius.",
        ),
        Step::proved(
            POSITIVE,
            "diff(F_g, a) = 2*E*a*(g' - 3*sqrt(B/a))",
            "For any profile: stability ends where $F'(a) = 0$, that is where `g'` is three times the slope of `Δl`.",
        ),
        Step::proved(BOTH, "at(diff(F_n, a), a, a_F) = 0", "For a power law at `a_F = (9*B/N^2)^(1/(2*n - 1))`, once."),
        Step::proved(BOTH, "a_F/a_c = 9^(1/(2*n - 1))", "Against the radius at fixed grips."),
        Step::proved(BOTH, "d_F = (3 - 2*n)/n*sqrt(B*a_F)", "The indentation, factored: exactly 0 at `n = 3/2`."),
        Step::proved(ABOVE, "at((3 - 2*n)/n, n, 3/2) = 0", "Its factor at `n = 3/2`."),
        Step::proved(BOTH, "F_F = 2*(1 - 2*n)/(n + 1)*E*sqrt(B)*a_F^(3/2)", "The force, factored."),
        Step::proved(ABOVE, "F_F < 0", "For `n > 1/2` it is tensile: the force of adhesion."),
        Step::proved(
            BELOW,
            "F_F > 0",
            "For `n < 1/2` it is compressive: the largest load that the contact bears before it becomes complete.",
        ),
        Step::proved(
            ABOVE,
            "at(at(F_F, n, 2), C, 1/(2*R)) = -3/2*π*w*R",
            "The paraboloid: the force of Johnson, Kendall and Roberts.",
        ),
        Step::proved(ABOVE, "at(diff(diff(F_n, a), a), a, a_F) > 0", "For `n > 1/2` the force is a minimum there."),
        Step::proved(BELOW, "at(diff(diff(F_n, a), a), a, a_F) < 0", "For `n < 1/2` it is a maximum."),
    ],
    erratum: None,
    references: &["K. L. Johnson, K. Kendall, A. D. Roberts, Proceedings of the Royal Society A 324 (1971) 301–313"],
};
