//! Adhesion of finite range: Maugis–Dugdale.

use super::{ABOVE, Entry, POSITIVE, Step};

pub(super) const STATES: Entry = Entry {
    id: "maugis-dugdale",
    title: "Adhesion of finite range, and its limit",
    refuted: false,
    assumptions: &[
        "the surfaces attract each other with the stress σ₀ = w/δ in a ring a < r < c, at the end of which the gap is δ",
        "a = c cosθ, so that the ring has 0 < θ < π/2; s = 2σ₀/E*",
        "the pressure is finite at r = a: d = g(a) − sc sinθ",
        "the gap at c is that of g beyond a and of the ring: πδ/2 = ∫ (g(c cosφ) − g(a)) dφ over 0 < φ < θ, plus \
         sc (θ sinθ + cosθ − 1)",
        "the force is that of the contact and of the ring: F = 2E* (a g(a) − ∫g) − E*sc² (θ + sinθ cosθ)",
    ],
    steps: &[
        Step::proved(
            POSITIVE,
            "diff(θ*sinθ + cosθ, θ) = θ*cosθ",
            "At a fixed c the opening of the ring grows with θ, and as −a changes by c sinθ dθ, its derivative along a is \
             −θ cosθ/sinθ.",
        ),
        Step::proved(
            POSITIVE,
            "diff(θ + sinθ*cosθ, θ) = 2*cosθ^2",
            "So the gap changes along a by −θ (g' + s cosθ/sinθ), and the force by 2E*a (g' + s cosθ/sinθ).",
        ),
        Step::proved(
            POSITIVE,
            "θ*(θ + cosθ/sinθ) - cosθ*(θ/sinθ + cosθ - 1) = θ^2 + cosθ - cosθ^2",
            "Where the force is stationary at a constant gap these cancel with the changes along c, which are J/c + \
             s(θ/sinθ + cosθ − 1) and −2E*sc(θ + cosθ/sinθ), with J = ∫ x g'(x) dφ: pull-off is where \
             J cosθ = sc (θ² + cosθ − cos²θ).",
        ),
        Step::proved(
            POSITIVE,
            "cosθ^2*(sinθ/cosθ + (1/cosθ^2 - 2)*θ) = θ + sinθ*cosθ - 2*θ*cosθ^2",
            "The paraboloid, g = x²/R: with m = 1/cosθ the gap is that of Maugis, √(m² − 1) + (m² − 2) arctan √(m² − 1) in units \
             of a²/2R, beside the opening of the ring.",
        ),
        Step::proved(
            POSITIVE,
            "2*w/(E*δ)*a*sqrt(π*δ/(2*w/(E*δ)*a)) = Δl",
            "Short range: the ring is thin, its opening is saθ²/2 and the gap πδ/2 is that alone. So θ = √(πδ/sa), and \
             g(a) − d = saθ is the elongation of the rule of Heß (1.4), whatever δ is.",
        ),
        Step::proved(
            POSITIVE,
            "3/2*(2*w/(E*δ))*sqrt(π*δ/(2*w/(E*δ)*a)) = 3*sqrt(B/a)",
            "The condition of pull-off becomes g'(a) aθ = 3saθ²/2: the fold under a dead load (see critical-force).",
        ),
        Step::proved(
            ABOVE,
            "at(at(at(Δl, a, a_F), n, 2), C, 1/(2*R)) = sqrt(2*π*(9*π/8)^(1/3))*(R*w^2/E^2)^(1/3)",
            "The elongation at the pull-off of a paraboloid. Over the range of adhesion z₀ and the constant c_T it is Tabor's \
             number, (Rw²/E*²z₀³)^(1/3): for any profile μ = Δl(a_F)/(c_T z₀).",
        ),
    ],
    erratum: None,
    references: &[
        "D. Maugis, Journal of Colloid and Interface Science 150 (1992) 243–269",
        "D. Tabor, Journal of Colloid and Interface Science 58 (1977) 2–13",
        "D. S. Dugdale, Journal of the Mechanics and Physics of Solids 8 (1960) 100–104",
    ],
};
