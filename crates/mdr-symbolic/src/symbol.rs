//! The symbols of the theory. All represent positive real numbers.

use std::sync::LazyLock;

use crate::dimension::Dimension;
use crate::table::rows;

/// A symbol: a positive real number, independent of all others.
///
/// Some are functions of another one, and are then differentiated by a rule: g, G, Q, S and l of a, sinθ and cosθ of θ. The
/// [documentation of the crate](crate#what-is-proved-and-where) lists those that are not independent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Symbol(usize);

/// The properties of a symbol.
struct Entry {
    name: &'static str,
    text: &'static str,
    tex: &'static str,
    coq: &'static str,
    meaning: &'static str,
    /// Powers of length: the constant, and the factor of n.
    length: [i64; 2],
    force: i64,
}

/// The properties of all symbols, from `data/symbols.tsv`.
static ENTRIES: LazyLock<Vec<Entry>> = LazyLock::new(|| {
    let entry = |[name, text, tex, coq, constant, slope, force, meaning]: [&'static str; 8]| {
        let length = [constant.parse().ok()?, slope.parse().ok()?];
        Some(Entry { name, text, tex, coq, meaning, length, force: force.parse().ok()? })
    };
    rows(include_str!("../data/symbols.tsv")).filter_map(entry).collect()
});

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

    /// In Coq.
    pub(crate) fn coq(self) -> &'static str {
        self.entry().coq
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
            ("S", "a") => Some(Some((1, of("S'"), 1))),
            ("l", "a") => Some(Some((1, of("l'"), 1))),
            ("g'" | "S'" | "l'" | "A'", "a") => Some(None),
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
