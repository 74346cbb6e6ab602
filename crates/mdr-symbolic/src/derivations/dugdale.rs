//! Adhesion of finite range: Maugis–Dugdale.

use super::{ABOVE, Entry, POSITIVE, Step};

pub(super) const STATES: Entry = Entry {
    id: "maugis-dugdale",
    title: "Adhesion of finite range, and its limit",
    refuted: false,
    assumptions: &[
        "the surfaces attract each other with the stress $\\sigma_0 = w/\\delta$ in a ring $a \\lt r \\lt c$, at the \
         end of which the gap is $\\delta$",
        "$a = c \\cos\\theta$, so that the ring has $0 \\lt \\theta \\lt \\pi/2$; $s = 2\\sigma_0/E^*$",
        "the pressure is finite at $r = a$: $d = g(a) - s c \\sin\\theta$",
        "the gap at $c$ is that of $g$ beyond $a$ and of the ring: $\\pi\\delta/2 = \\int (g(c \\cos\\varphi) - \
         g(a)) \\, d\\varphi$ over $0 \\lt \\varphi \\lt \\theta$, plus $s c (\\theta \\sin\\theta + \\cos\\theta - \
         1)$",
        "the force is that of the contact and of the ring: $F = 2E^* (a g(a) - \\int g) - E^* s c^2 (\\theta + \
         \\sin\\theta \\cos\\theta)$",
    ],
    steps: &[
        Step::proved(
            POSITIVE,
            "diff(θ*sinθ + cosθ, θ) = θ*cosθ",
            "At a fixed $c$ the opening of the ring grows with $\\theta$, and as $-a$ changes by $c \\sin\\theta \\, \
             d\\theta$, its derivative along $a$ is $-\\theta \\cos\\theta/\\sin\\theta$.",
        ),
        Step::proved(
            POSITIVE,
            "diff(θ + sinθ*cosθ, θ) = 2*cosθ^2",
            "So the gap changes along $a$ by $-\\theta (g' + s \\cos\\theta/\\sin\\theta)$, and the force by $2E^* a \
             (g' + s \\cos\\theta/\\sin\\theta)$.",
        ),
        Step::proved(
            POSITIVE,
            "θ*(θ + cosθ/sinθ) - cosθ*(θ/sinθ + cosθ - 1) = θ^2 + cosθ - cosθ^2",
            "Where the force is stationary at a constant gap these cancel with the changes along $c$, which are $J/c \
             + s(\\theta/\\sin\\theta + \\cos\\theta - 1)$ and $-2E^* s c(\\theta + \\cos\\theta/\\sin\\theta)$, \
             with $J = \\int x g'(x) \\, d\\varphi$: pull-off is where $J \\cos\\theta = s c (\\theta^2 + \
             \\cos\\theta - \\cos^2\\theta)$.",
        ),
        Step::proved(
            POSITIVE,
            "cosθ^2*(sinθ/cosθ + (1/cosθ^2 - 2)*θ) = θ + sinθ*cosθ - 2*θ*cosθ^2",
            "The paraboloid, $g = x^2/R$: with $m = 1/\\cos\\theta$ the gap is that of Maugis, $\\sqrt{m^2 - 1} + \
             (m^2 - 2) \\theta$ with $\\tan\\theta = \\sqrt{m^2 - 1}$, in units of $a^2/(2R)$, beside the opening of \
             the ring.",
        ),
        Step::proved(
            POSITIVE,
            "2*w/(E*δ)*a*sqrt(π*δ/(2*w/(E*δ)*a)) = Δl",
            "Short range: the ring is thin, its opening is $s a \\theta^2/2$ and the gap $\\pi\\delta/2$ is that \
             alone. So $\\theta^2 = \\pi\\delta/(s a)$, and $g(a) - d = s a \\theta$ is the elongation of the rule \
             of Heß (1.4), whatever $\\delta$ is.",
        ),
        Step::proved(
            POSITIVE,
            "3/2*(2*w/(E*δ))*sqrt(π*δ/(2*w/(E*δ)*a)) = 3*sqrt(B/a)",
            "The condition of pull-off becomes $g'(a) a \\theta = 3 s a \\theta^2/2$: the fold under a dead load \
             (see critical-force).",
        ),
        Step::proved(
            ABOVE,
            "at(at(at(Δl, a, a_F), n, 2), C, 1/(2*R)) = sqrt(2*π*(9*π/8)^(1/3))*(R*w^2/E^2)^(1/3)",
            "The elongation at the pull-off of a paraboloid. Over the range of adhesion $z_0$ and the constant $c_T$ \
             it is Tabor's number, $(R w^2/(E^{*2} z_0^3))^{1/3}$: for any profile $\\mu = \\Delta l(a_F)/(c_T \
             z_0)$.",
        ),
    ],
    erratum: None,
    references: &[
        "D. Maugis, Journal of Colloid and Interface Science 150 (1992) 243–269",
        "D. Tabor, Journal of Colloid and Interface Science 58 (1977) 2–13",
        "D. S. Dugdale, Journal of the Mechanics and Physics of Solids 8 (1960) 100–104",
    ],
};
