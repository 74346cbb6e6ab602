//! The MDR transform (1.1) and that of a power law (1.12).

use super::{Entry, POSITIVE, Step};

const BOOK: &str =
    "V. L. Popov, M. Heß, Method of Dimensionality Reduction in Contact Mechanics and Friction, Springer 2015";
const DLMF: &str = "NIST Digital Library of Mathematical Functions, §5.5 and §5.12";

pub(super) const TRANSFORM: Entry = Entry {
    id: "1.1",
    title: "The MDR transform",
    refuted: false,
    assumptions: &["axisymmetric profile with $f(0) = 0$", "no friction", "the contact is one disc of radius `a`"],
    steps: &[
        Step::cited(
            "The transform, and the theorem that the one-dimensional foundation has the force, the indentation and the \
             contact radius of the three-dimensional problem, are those of the method of dimensionality reduction.",
        ),
        Step::proved(
            POSITIVE,
            "x*at(diff(C*r^n, r), r, x*sinθ) = n*C*x^n*sinθ^(n - 1)",
            "With `r = x*sinθ` the transform (1.1) is $g(x) = x \\int f'(x \\sin\\theta) \\, d\\theta$ over a quarter turn: the root in the \
             denominator is gone. This is the integrand for $f = C r^n$; for `n < 1` it is infinite at `θ = 0`.",
        ),
        Step::proved(
            POSITIVE,
            "diff(cosθ*sinθ^n, θ) = n*sinθ^(n - 1)*cosθ^2 - sinθ^(n + 1)",
            "The function on the left vanishes at both ends, so the integral of its derivative is 0.",
        ),
        Step::proved(
            POSITIVE,
            "n*sinθ^(n - 1)*cosθ^2 - sinθ^(n + 1) = n*sinθ^(n - 1) - (n + 1)*sinθ^(n + 1)",
            "With `cosθ^2 = 1 - sinθ^2`: the integrals of `n*sinθ^(n - 1)` and of `(n + 1)*sinθ^(n + 1)` are equal. In general \
             $g(x) = \\int \\sin\\theta \\, (f + r f') \\, d\\theta$, without a singularity at `r = 0`.",
        ),
    ],
    erratum: None,
    references: &[BOOK],
};

pub(super) const POWER: Entry = Entry {
    id: "1.12",
    title: "The transform of a power law and its factor",
    refuted: false,
    assumptions: &["$f = C r^n$ with `n > 0`"],
    steps: &[
        Step::enclosed(
            POSITIVE,
            "(n + 1)*turn(sinθ^(n + 1)) = sqrt(π)/2*n*Γ(n/2)/Γ((n + 1)/2)",
            "The integral of (1.1) in the regular form, over `C*x^n`. It is Wallis's integral, whose value is cited; here \
             quadrature with a proved remainder encloses it.",
        ),
        Step::proved(
            POSITIVE,
            "sqrt(π)/2*n*Γ(n/2)/Γ((n + 1)/2) = sqrt(π)*Γ(1 + n/2)/Γ((n + 1)/2)",
            "By $\\Gamma(z + 1) = z \\, \\Gamma(z)$. The printed form is $0 \\cdot \\infty$ at `n = 0`; this one is 1 there.",
        ),
        Step::proved(POSITIVE, "kappa(1) = π/2", "The cone."),
        Step::proved(POSITIVE, "kappa(2) = 2", "The paraboloid: `r^2/(2*R)` becomes `x^2/R`."),
    ],
    erratum: None,
    references: &[BOOK, DLMF],
};
