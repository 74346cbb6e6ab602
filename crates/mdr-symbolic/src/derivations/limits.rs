//! Kendall's punch as a limit, and wavy surfaces.

use super::{ABOVE, Entry, POSITIVE, Step};

/// Values for a power law close to a punch.
const BLUNT: &[(&str, &str)] = &[("n", "10000"), ("E", "1"), ("w", "1"), ("R", "1"), ("δ", "1")];

pub(super) const KENDALL: Entry = Entry {
    id: "kendall",
    title: "Kendall's flat punch as the limit of large n",
    refuted: false,
    assumptions: &["f = δ (r/R)ⁿ with a length δ", "n grows without bound"],
    steps: &[
        Step::proved(
            ABOVE,
            "at(a_c, C, δ*R^(-n)) = R*(B*R/(n^2*κ^2*δ^2))^(1/(2*n - 1))",
            "The critical radius is R times a power that has the exponent 1/(2n−1).",
        ),
        Step::enclosed(
            POSITIVE,
            "kappa(n)^2 > π*n/2",
            "κ_n grows with n (see kappa-growth). So for n > 1 κ_n² lies between κ_{n−1}κ_n = πn/2 (see kappa-recurrences), as here in numbers,",
        ),
        Step::enclosed(
            POSITIVE,
            "kappa(n)^2 < π*(n + 1)/2",
            "and κ_nκ_{n+1} = π(n+1)/2. So the bracket is of the order n⁻³. Its logarithm over 2n − 1 tends to 0, and the power \
             to 1: a_c tends to R.",
        ),
        Step::proved(
            POSITIVE,
            "2*(2*n + 1)/(n + 1) = 4 - 2/(n + 1)",
            "The factor of F_c, in the factored form of 1.17, tends to 4,",
        ),
        Step::proved(POSITIVE, "4*E*sqrt(B)*R^(3/2) = sqrt(8*π*R^3*E*w)", "and F_c to Kendall's force, −√(8πR³E*w)."),
        Step::proved(POSITIVE, "2*sqrt(B*R) = at(Δl, a, R)", "As (1−2n)/n tends to −2, d_c tends to −Δl(R)."),
        Step::at(BLUNT, ABOVE, "at(F_c, C, δ*R^(-n)) < -0.997*sqrt(8*π*R^3*E*w)", "In numbers, at n = 10⁴."),
        Step::at(BLUNT, ABOVE, "at(F_c, C, δ*R^(-n)) > -0.999*sqrt(8*π*R^3*E*w)", "From the other side."),
    ],
    erratum: None,
    references: &["K. Kendall, Journal of Physics D: Applied Physics 4 (1971) 1186–1195"],
};

pub(super) const WAVY: Entry = Entry {
    id: "wavy",
    title: "A paraboloid with waves",
    refuted: false,
    assumptions: &["f = r²/2R + A (1 − cos qr), with q = 2π over the wavelength"],
    steps: &[
        Step::enclosed(
            POSITIVE,
            "turn(sin(z*sinθ)) = π/2*H0(z)",
            "The waves have f' = Aq sin qr, and (1.1) gives Aqx ∫ sin(qx sinθ) dθ over a quarter turn: with z = qx this is \
             (π/2) A z H₀(z), H₀ the Struve function.",
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
