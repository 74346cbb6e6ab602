//! The named formulas of the derivations.

use super::Formula;
use crate::error::Result;

/// A named formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Definition(usize);

struct Entry {
    name: &'static str,
    text: &'static str,
    tex: &'static str,
    formula: &'static str,
}

const fn named(name: &'static str, text: &'static str, tex: &'static str, formula: &'static str) -> Entry {
    Entry { name, text, tex, formula }
}

const ENTRIES: &[Entry] = &[
    named("B", "B", "B", "π*w/(2*E)"),
    named("N", "N", "N", "n*κ*C"),
    named("Δl", "Δl(a)", r"\Delta l(a)", "sqrt(2*π*a*w/E)"),
    // Any profile.
    named("U", "U(a,d)", "U(a,d)", "E*(a*d^2 - 2*d*G + Q) - π*a^2*w"),
    named("d_g", "d(a)", "d(a)", "g - Δl"),
    named("F_g", "F(a)", "F(a)", "2*E*(a*d_g - G)"),
    named("λ", "λ(a)", r"\lambda(a)", "(k + 6*E*a)/(k + 2*E*a)"),
    // The power law.
    named("d_n", "d_n(a)", "d_n(a)", "κ*C*a^n - sqrt(2*π*a*w/E)"),
    named("F_n", "F_n(a)", "F_n(a)", "2*E*a*(n/(n + 1)*κ*C*a^n - sqrt(2*π*a*w/E))"),
    named("U_n", "U_n(a,d)", "U_n(a,d)", "E*int((d - κ*C*x^n)^2, x, a) - π*a^2*w"),
    named("a_c", "a_c", "a_c", "(B/N^2)^(1/(2*n - 1))"),
    named("d_c", "d_c", "d_c", "at(d_n, a, a_c)"),
    named("F_c", "F_c", "F_c", "at(F_n, a, a_c)"),
    named("a_F", "a_F", "a_F", "(9*B/N^2)^(1/(2*n - 1))"),
    named("d_F", "d_F", "d_F", "at(d_n, a, a_F)"),
    named("F_F", "F_F", "F_F", "at(F_n, a, a_F)"),
    named("a_0", "a₀", "a_0", "(4*n^2*B/N^2)^(1/(2*n - 1))"),
    named("a_z", "a_z", "a_z", "(4*(n + 1)^2*B/N^2)^(1/(2*n - 1))"),
    // n = 1/2.
    named("C_ρ", "C(ρ)", r"C(\rho)", "ρ/κ*sqrt(2*π*w/E)"),
    named("a_k", "a_k", "a_k", "k*(ρ - 1)/(2*E*(3 - ρ))"),
    // The factor κ.
    named("κ_Γ", "κ_n", r"\kappa_n", "sqrt(π)/2*n*Γ(n/2)/Γ((n + 1)/2)"),
    // Machines in units of their stiffness.
    named("h", "h(s)", "h(s)", "2*s/((1 + s)*(1 + 3*s))"),
    // The ratio of successive terms of the series of ₂F₁(1, b; c; 1/2).
    named("q", "q_j", "q_j", "(b + j)/(2*(c + j))"),
];

impl Definition {
    /// The definition with this name.
    pub fn named(name: &str) -> Option<Self> {
        ENTRIES.iter().position(|entry| entry.name == name).map(Definition)
    }

    /// Every definition.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..ENTRIES.len()).map(Definition)
    }

    /// As text for a reader.
    pub fn text(self) -> &'static str {
        ENTRIES[self.0].text
    }

    /// In TeX.
    pub fn tex(self) -> &'static str {
        ENTRIES[self.0].tex
    }

    /// The defining formula.
    ///
    /// # Errors
    /// None for the definitions of this crate, all of which are parsed in its tests.
    pub fn formula(self) -> Result<Formula> {
        ENTRIES[self.0].formula.parse()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_definition_is_a_formula() {
        for definition in Definition::all() {
            assert!(definition.formula().is_ok(), "{}: {:?}", definition.text(), definition.formula());
        }
    }
}
