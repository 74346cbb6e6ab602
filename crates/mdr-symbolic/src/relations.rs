//! Relations between symbols that normal forms do not include.
//!
//! Sine and cosine belong to one angle; κ_n, Γ(n/2) and Γ((n+1)/2) to one n, by (1.12). Terms that differ in two members of
//! such a family may cancel although their normal forms differ.

use rug::Integer;

use crate::domain::Domain;
use crate::error::Result;
use crate::expression::Expression;
use crate::rational_function::RationalFunction;
use crate::symbol::Symbol;

/// The symbols that belong to one function of the radius.
pub(crate) const PROFILE: [&str; 4] = ["g", "g'", "G", "Q"];

/// The symbols that belong to one angle.
const ANGLE: [&str; 3] = ["θ", "sinθ", "cosθ"];

/// The symbols that belong to one n, by (1.12).
const EXPONENT: [&str; 4] = ["κ", "Γ(n/2)", "Γ((n+1)/2)", "Γ(3/4)"];

impl Symbol {
    /// The other symbols that belong to the same profile, angle or n.
    pub(crate) fn relatives(self) -> impl Iterator<Item = Symbol> {
        let family = [&PROFILE[..], &ANGLE, &EXPONENT]
            .into_iter()
            .find(|family| family.contains(&self.name()))
            .unwrap_or_default();
        family.iter().filter_map(|name| Symbol::named(name)).filter(move |other| *other != self)
    }

    /// Whether it is a number of its own: neither κ nor Γ, which n determines, nor one of a profile or an angle.
    pub(crate) fn is_free(self) -> bool {
        self.relatives().next().is_none()
    }
}

impl Expression {
    /// An expression with the same zeros: cos²θ is replaced by 1 − sin²θ where the powers of the cosine differ by
    /// integers.
    pub(crate) fn with_one_cosine(&self) -> Result<Self> {
        let (Some(sine), Some(cosine)) = (Symbol::named("sinθ"), Symbol::named("cosθ")) else {
            return Ok(self.clone());
        };
        let exponents: Vec<_> = self.terms().map(|(_, monomial)| monomial.exponent(cosine)).collect();
        let offset = |exponent: &RationalFunction| exponents.first().and_then(|first| (exponent - first).as_integer());
        let Some(offsets) = exponents.iter().map(offset).collect::<Option<Vec<Integer>>>() else {
            return Ok(self.clone());
        };
        let least = offsets.iter().min().cloned().unwrap_or_default();
        let two = RationalFunction::constant(2);
        let rest = &Self::integer(1) - &Self::symbol(sine).power(&two, Domain::Positive)?;
        let mut sum = Self::zero();
        for ((coefficient, monomial), offset) in self.terms().zip(&offsets) {
            let (pairs, single) = Integer::from(offset - &least).div_rem_euc(Integer::from(2));
            let term = Self::from_term((coefficient.clone(), monomial.without(cosine)));
            let power = |base: &Self, exponent| base.power(&RationalFunction::constant(exponent), Domain::Positive);
            let term = term.times(&power(&rest, pairs)?)?;
            sum = &sum + &term.times(&power(&Self::symbol(cosine), single)?)?;
        }
        Ok(sum)
    }

    /// Whether it is 0 on the domain, also by the relations of its symbols; `None` where they leave that open.
    ///
    /// # Errors
    /// [`Error::TooLarge`](crate::Error::TooLarge) for too large a power of the cosine.
    pub(crate) fn vanishes(&self, domain: Domain) -> Result<Option<bool>> {
        let rest = self.with_one_cosine()?;
        Ok(if rest.is_zero() { Some(true) } else { rest.related_symbols(domain).is_none().then_some(false) })
    }

    /// Symbols in which the terms differ and that are related on the domain.
    pub(crate) fn related_symbols(&self, domain: Domain) -> Option<Vec<Symbol>> {
        let named = |names: &[&str]| names.iter().filter_map(|name| Symbol::named(name)).collect::<Vec<_>>();
        let angle = named(&ANGLE);
        let of_n = match domain.is_point() {
            false => vec![Symbol::KAPPA, Symbol::GAMMA_LOWER, Symbol::GAMMA_UPPER],
            true => vec![Symbol::KAPPA, Symbol::GAMMA_THREE_QUARTERS],
        };
        let differing = |family: Vec<Symbol>| family.into_iter().filter(|symbol| self.differs_in(*symbol)).collect();
        let mut families = [angle, of_n].into_iter().map(differing).filter(|family: &Vec<_>| family.len() > 1);
        families.find(|family| *family != named(&["sinθ", "cosθ"]) || !self.has_one_cosine())
    }

    /// Whether the terms have different powers of a symbol.
    fn differs_in(&self, symbol: Symbol) -> bool {
        let mut exponents = self.terms().map(|(_, monomial)| monomial.exponent(symbol));
        let first = exponents.next();
        exponents.any(|exponent| Some(exponent) != first)
    }

    /// Whether the cosine occurs to the powers 0 and 1 only. P + Q cosθ with P and Q sums of powers of sinθ vanishes only
    /// where both do: cosθ = √(1 − sin²θ) is not analytic at sinθ = 1, the quotient P/Q is meromorphic there.
    fn has_one_cosine(&self) -> bool {
        let exponents = |cosine| self.terms().map(move |(_, monomial)| monomial.exponent(cosine));
        Symbol::named("cosθ").is_some_and(|cosine| exponents(cosine).all(|power| power.is_zero() || power.is_one()))
    }
}
