//! Kendall's punch as a limit, and wavy surfaces.

use super::{ABOVE, Entry, POSITIVE, Step};

/// Values for a power law close to a punch.
const BLUNT: &[(&str, &str)] = &[("n", "10000"), ("E", "1"), ("w", "1"), ("R", "1"), ("δ", "1")];

pub(super) const KENDALL: Entry = Entry {
    id: "kendall",
    title: "Kendall's flat punch as the limit of large n",
    refuted: false,
    assumptions: &["$f = \\delta (r/R)^n$ with a length `δ`", "`n` grows without bound"],
    steps: &[
        Step::proved(
            ABOVE,
            "at(a_c, C, δ*R^(-n)) = R*(B*R/(n^2*κ^2*δ^2))^(1/(2*n - 1))",
            "The critical radius is `R` times a power that has the exponent `1/(2*n - 1)`.",
        ),
        Step::enclosed(
            POSITIVE,
            "kappa(n)^2 > π*n/2",
            "`κ` grows with `n` (see kappa-growth). So for `n > 1` its square lies between `kappa(n - 1)*kappa(n) = π*n/2` (see kappa-recurrences), as here in numbers,",
        ),
        Step::enclosed(
            POSITIVE,
            "kappa(n)^2 < π*(n + 1)/2",
            "and `kappa(n)*kappa(n + 1) = π*(n + 1)/2`. So the bracket is of the order $n^{-3}$. Its logarithm over `2*n - 1` tends to 0, and the power \
             to 1: `a_c` tends to `R`.",
        ),
        Step::proved(
            POSITIVE,
            "2*(2*n + 1)/(n + 1) = 4 - 2/(n + 1)",
            "The factor of `F_c`, in the factored form of 1.17, tends to 4,",
        ),
        Step::proved(
            POSITIVE,
            "4*E*sqrt(B)*R^(3/2) = sqrt(8*π*R^3*E*w)",
            "and `F_c` to Kendall's force, `-sqrt(8*π*R^3*E*w)`.",
        ),
        Step::proved(
            POSITIVE,
            "2*sqrt(B*R) = at(Δl, a, R)",
            "As `(1 - 2*n)/n` tends to −2, `d_c` tends to $-\\Delta l(R)$.",
        ),
        Step::at(BLUNT, ABOVE, "at(F_c, C, δ*R^(-n)) < -0.997*sqrt(8*π*R^3*E*w)", "In numbers, at $n = 10^4$."),
        Step::at(BLUNT, ABOVE, "at(F_c, C, δ*R^(-n)) > -0.999*sqrt(8*π*R^3*E*w)", "From the other side."),
    ],
    erratum: None,
    references: &["K. Kendall, Journal of Physics D: Applied Physics 4 (1971) 1186–1195"],
};

pub(super) const WAVY: Entry = Entry {
    id: "wavy",
    title: "A paraboloid with waves",
    refuted: false,
    assumptions: &["$f = r^2/2R + A (1 - \\cos q r)$, with $q = 2\\pi$ over the wavelength"],
    steps: &[
        Step::enclosed(
            POSITIVE,
            "turn(sin(z*sinθ)) = π/2*H0(z)",
            "The waves have $f' = A q \\sin q r$, and (1.1) gives $A q x \\int \\sin(q x \\sin\\theta) \\, d\\theta$ over a quarter turn: with $z = q x$ this is \
             $\\frac{\\pi}{2} A z \\, \\mathbf{H}_0(z)$, $\\mathbf{H}_0$ the Struve function.",
        ),
        Step::proved(
            POSITIVE,
            "at(κ, n, 2)*x^2/(2*R) = x^2/R",
            "The transform of the paraboloid adds to it, as (1.1) is linear.",
        ),
    ],
    erratum: None,
    references: &[
        "P. R. Guduru, Journal of the Mechanics and Physics of Solids 55 (2007) 445–472",
        "NIST Digital Library of Mathematical Functions, §11.5",
    ],
};
