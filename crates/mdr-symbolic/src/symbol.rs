//! The symbols of the theory. All represent positive real numbers.

use crate::dimension::Dimension;

/// A symbol: a positive real number, independent of all others.
///
/// Some are functions of another one, and are then differentiated by a rule: g, G and Q of a, sinθ and cosθ of θ. The
/// [documentation of the crate](crate#what-is-proved-and-where) lists those that are not independent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Symbol(usize);

/// The properties of a symbol.
struct Entry {
    name: &'static str,
    text: &'static str,
    tex: &'static str,
    meaning: &'static str,
    /// Powers of length: the constant, and the factor of n.
    length: [i64; 2],
    force: i64,
}

const fn pure(name: &'static str, tex: &'static str, meaning: &'static str) -> Entry {
    Entry { name, text: name, tex, meaning, length: [0, 0], force: 0 }
}

const fn length(name: &'static str, tex: &'static str, power: i64, meaning: &'static str) -> Entry {
    Entry { name, text: name, tex, meaning, length: [power, 0], force: 0 }
}

const fn elastic(
    name: &'static str,
    text: &'static str,
    tex: &'static str,
    power: i64,
    meaning: &'static str,
) -> Entry {
    Entry { name, text, tex, meaning, length: [power, 0], force: 1 }
}

const ENTRIES: &[Entry] = &[
    elastic("E", "E*", "E^*", -2, "effective modulus"),
    elastic("w", "w", "w", -1, "work of adhesion per area, the Δγ of the paper"),
    Entry {
        name: "C", text: "C", tex: "C", meaning: "coefficient of the profile f = C rⁿ", length: [1, -1], force: 0
    },
    pure("κ", r"\kappa_n", "factor between profile and MDR-transformed profile"),
    length("a", "a", 1, "contact radius"),
    length("d", "d", 1, "indentation depth"),
    elastic("k", "k", "k", -1, "stiffness of the machine"),
    length("R", "R", 1, "radius of curvature, or of a punch"),
    length("x", "x", 1, "coordinate of the springs"),
    length("y", "y", 1, "elongation g(a) − d of the outer springs"),
    length("δ", r"\delta", 1, "a positive length"),
    length("g", "g(a)", 1, "MDR-transformed profile at the edge"),
    pure("g'", "g'(a)", "its slope"),
    length("G", r"\textstyle\int_0^a g", 2, "its integral"),
    length("Q", r"\textstyle\int_0^a g^2", 3, "the integral of its square"),
    pure("t", "t", "contact radius in units of the critical one"),
    pure("s", "s", "contact stiffness 2E*a over machine stiffness k"),
    pure("ρ", r"\rho", "C over its threshold at n = 1/2"),
    pure("μ", r"\mu", "n − 1/2"),
    pure("θ", r"\theta", "angle between 0 and π/2, x sinθ = r"),
    pure("sinθ", r"\sin\theta", "sine of θ"),
    pure("cosθ", r"\cos\theta", "cosine of θ"),
    pure("b", "b", "second parameter of ₂F₁(1, b; c; 1/2)"),
    pure("c", "c", "third parameter of ₂F₁(1, b; c; 1/2)"),
    pure("j", "j", "index of a term"),
    pure("m", "m", "index of a term"),
    pure("z", "z", "argument of a function"),
    elastic("E1", "E₁", "E_1", -2, "modulus of the first body"),
    elastic("E2", "E₂", "E_2", -2, "modulus of the second body"),
    pure("ν1", r"\nu_1", "Poisson's ratio of the first body"),
    pure("ν2", r"\nu_2", "Poisson's ratio of the second body"),
    pure("Γ(n/2)", r"\Gamma\left(\frac{n}{2}\right)", "Euler's Gamma function"),
    pure("Γ((n+1)/2)", r"\Gamma\left(\frac{n+1}{2}\right)", "Euler's Gamma function"),
    pure("Γ(3/4)", r"\Gamma\left(\frac34\right)", "Euler's Gamma function"),
    length("r", "r", 1, "polar radius"),
    pure("Λ", r"\Lambda", "value of λ at a fold"),
    pure("ε", r"\varepsilon", "a positive number"),
    elastic("F", "F", "F", 0, "dead load"),
];

impl Symbol {
    /// κ_n, treated as an independent positive number.
    pub const KAPPA: Symbol = Symbol(3);
    /// Γ(n/2).
    pub const GAMMA_LOWER: Symbol = Symbol(31);
    /// Γ((n+1)/2).
    pub const GAMMA_UPPER: Symbol = Symbol(32);
    /// Γ(3/4).
    pub const GAMMA_THREE_QUARTERS: Symbol = Symbol(33);

    /// The symbol of this name.
    pub fn named(name: &str) -> Option<Self> {
        ENTRIES.iter().position(|entry| entry.name == name).map(Symbol)
    }

    /// Every symbol.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..ENTRIES.len()).map(Symbol)
    }

    fn entry(self) -> &'static Entry {
        &ENTRIES[self.0]
    }

    /// As written in a formula.
    pub fn name(self) -> &'static str {
        self.entry().name
    }

    /// As text for a reader.
    pub fn text(self) -> &'static str {
        self.entry().text
    }

    /// In TeX.
    pub fn tex(self) -> &'static str {
        self.entry().tex
    }

    /// Its meaning.
    pub fn meaning(self) -> &'static str {
        self.entry().meaning
    }

    /// Its dimension.
    pub fn dimension(self) -> Dimension {
        let Entry { length: [constant, slope], force, .. } = *self.entry();
        Dimension::new(constant, slope, force)
    }

    /// The derivative with respect to `variable` as coefficient and powers, when this symbol is a function of it.
    /// `None` for an independent symbol; `Some(None)` for one whose derivative has no symbol.
    pub(crate) fn slope_along(self, variable: Symbol) -> Option<Option<(i32, Symbol, i32)>> {
        let of = |name: &str| Symbol::named(name).unwrap_or(self);
        match (self.name(), variable.name()) {
            ("g", "a") => Some(Some((1, of("g'"), 1))),
            ("G", "a") => Some(Some((1, of("g"), 1))),
            ("Q", "a") => Some(Some((1, of("g"), 2))),
            ("g'", "a") => Some(None),
            ("sinθ", "θ") => Some(Some((1, of("cosθ"), 1))),
            ("cosθ", "θ") => Some(Some((-1, of("sinθ"), 1))),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_named_constants_are_where_they_should_be() {
        assert_eq!(Symbol::named("κ"), Some(Symbol::KAPPA));
        assert_eq!(Symbol::named("Γ(n/2)"), Some(Symbol::GAMMA_LOWER));
        assert_eq!(Symbol::named("Γ((n+1)/2)"), Some(Symbol::GAMMA_UPPER));
        assert_eq!(Symbol::named("Γ(3/4)"), Some(Symbol::GAMMA_THREE_QUARTERS));
    }
}
