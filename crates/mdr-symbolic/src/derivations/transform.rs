//! The MDR transform (1.1) and that of a power law (1.12).

use super::{Entry, POSITIVE, Step};

const BOOK: &str =
    "V. L. Popov, M. Heß, Method of Dimensionality Reduction in Contact Mechanics and Friction, Springer 2015";
const DLMF: &str = "NIST Digital Library of Mathematical Functions, §5.5 and §5.12";

pub(super) const TRANSFORM: Entry = Entry {
    id: "1.1",
    title: "The MDR transform",
    refuted: false,
    assumptions: &["axisymmetric profile with f(0) = 0", "no friction", "the contact is one disc of radius a"],
    steps: &[
        Step::cited(
            "The transform, and the theorem that the one-dimensional foundation has the force, the indentation and the \
             contact radius of the three-dimensional problem, are those of the method of dimensionality reduction.",
        ),
        Step::proved(
            POSITIVE,
            "x*at(diff(C*r^n, r), r, x*sinθ) = n*C*x^n*sinθ^(n - 1)",
            "With r = x sinθ the transform (1.1) is g(x) = x ∫ f'(x sinθ) dθ over a quarter turn: the root in the \
             denominator is gone. This is the integrand for f = C rⁿ; for n < 1 it is infinite at θ = 0.",
        ),
        Step::proved(
            POSITIVE,
            "diff(cosθ*sinθ^n, θ) = n*sinθ^(n - 1)*cosθ^2 - sinθ^(n + 1)",
            "The function on the left vanishes at both ends, so the integral of its derivative is 0.",
        ),
        Step::proved(
            POSITIVE,
            "n*sinθ^(n - 1)*cosθ^2 - sinθ^(n + 1) = n*sinθ^(n - 1) - (n + 1)*sinθ^(n + 1)",
            "With cos²θ = 1 − sin²θ: the integrals of n sin^(n−1)θ and of (n+1) sin^(n+1)θ are equal. In general \
             g(x) = ∫ sinθ (f + r f') dθ, without a singularity at r = 0.",
        ),
    ],
    erratum: None,
    references: &[BOOK],
};

pub(super) const POWER: Entry = Entry {
    id: "1.12",
    title: "The transform of a power law and its factor",
    refuted: false,
    assumptions: &["f = C rⁿ with n > 0"],
    steps: &[
        Step::enclosed(
            POSITIVE,
            "(n + 1)*turn(sinθ^(n + 1)) = sqrt(π)/2*n*Γ(n/2)/Γ((n + 1)/2)",
            "The integral of (1.1) in the regular form, over C xⁿ. It is Wallis's integral, whose value is cited; here \
             quadrature with a proved remainder encloses it.",
        ),
        Step::proved(
            POSITIVE,
            "sqrt(π)/2*n*Γ(n/2)/Γ((n + 1)/2) = sqrt(π)*Γ(1 + n/2)/Γ((n + 1)/2)",
            "By Γ(z + 1) = z Γ(z). The printed form is 0·∞ at n = 0; this one is 1 there.",
        ),
        Step::proved(POSITIVE, "kappa(1) = π/2", "The cone."),
        Step::proved(POSITIVE, "kappa(2) = 2", "The paraboloid: r²/2R becomes x²/R."),
    ],
    erratum: None,
    references: &[BOOK, DLMF],
};
