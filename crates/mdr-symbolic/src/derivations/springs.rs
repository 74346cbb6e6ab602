//! The foundation (1.2), its modulus (1.3) and the rule of Heß (1.4).

use super::{Entry, POSITIVE, Step};

const HESS_2010: &str = "M. Heß, On the reduction method of dimensionality: the exact mapping of axisymmetric contact \
                         problems with and without adhesion, Physical Mesomechanics 15 (2012) 264–269";
const GRIFFITH: &str = "D. Maugis, Contact, Adhesion and Rupture of Elastic Solids, Springer 2000";

pub(super) const SPRINGS: Entry = Entry {
    id: "1.2",
    title: "The stiffness of the springs",
    refuted: false,
    assumptions: &["linear elastic half-spaces"],
    steps: &[
        Step::cited(
            "Each spring of the width $\\Delta x$ has the stiffness $E^* \\Delta x$: this is the foundation of the method.",
        ),
        Step::proved(
            POSITIVE,
            "2*int(E, x, a) = 2*E*a",
            "All springs from `-a` to `a` together have the stiffness of a flat punch of radius `a`.",
        ),
        Step::proved(POSITIVE, "E*x ~ k", "$E^* \\Delta x$ is a stiffness."),
    ],
    erratum: None,
    references: &["I. N. Sneddon, International Journal of Engineering Science 3 (1965) 47–57"],
};

pub(super) const MODULUS: Entry = Entry {
    id: "1.3",
    title: "The effective modulus",
    refuted: false,
    assumptions: &["no friction, or similar materials"],
    steps: &[
        Step::cited("The compliances of the two bodies add up."),
        Step::proved(
            POSITIVE,
            "1/((1 - ν1^2)/E1 + (1 - ν2^2)/E2) = E1*E2/(E2*(1 - ν1^2) + E1*(1 - ν2^2))",
            "Solved for the modulus.",
        ),
        Step::proved(
            POSITIVE,
            "at(at(E1*E2/(E2*(1 - ν1^2) + E1*(1 - ν2^2)), E2, E1), ν2, ν1) = E1/(2*(1 - ν1^2))",
            "Two equal bodies have half the modulus of one on a rigid counterpart.",
        ),
    ],
    erratum: None,
    references: &["K. L. Johnson, Contact Mechanics, Cambridge University Press 1985"],
};

pub(super) const HESS: Entry = Entry {
    id: "1.4",
    title: "The rule of Heß, from the balance of energy",
    refuted: false,
    assumptions: &["any profile $g$", "the outer springs are stretched: `g > d`"],
    steps: &[
        Step::cited(
            "The potential energy of a contact is the elastic energy of the springs less the work of adhesion: `U`, with \
             `U = E*(a*d^2 - 2*d*G + Q) - π*a^2*w`, which is $E^* \\int_0^a (d - g)^2 \\, dx - \\pi a^2 w$.",
        ),
        Step::proved(
            POSITIVE,
            "diff(U, a) = E*((d - g)^2 - 2*π*a*w/E)",
            "The derivative at fixed indentation. The first term is the energy that the last springs give back, the second \
             the work of adhesion.",
        ),
        Step::proved(
            POSITIVE,
            "diff(U, a) = E*(g - d - Δl)*(g - d + Δl)",
            "Griffith's balance: as `g > d`, the energy is stationary where the elongation `g - d` of the outer springs is `Δl`. The \
             rule of Heß is this balance.",
        ),
        Step::proved(POSITIVE, "Δl = 2*sqrt(B*a)", "With the length `B = π*w/(2*E)`, used from here on."),
        Step::proved(POSITIVE, "Δl ~ a", "`Δl` is a length."),
    ],
    erratum: None,
    references: &[HESS_2010, GRIFFITH],
};
