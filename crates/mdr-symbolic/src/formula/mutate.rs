//! Small errors in a formula: a sign, an exponent, a factor. A statement that remains true after one of them says
//! little.

use rug::Rational;

use super::Formula;

impl Formula {
    /// All formulas that differ from this one in one place: a number too large by one, a sign flipped, an exponent of
    /// the opposite sign, a factor omitted, a quotient inverted, a root omitted.
    pub fn mutants(&self) -> Vec<Formula> {
        let mut mutants = self.mutants_here();
        let parts = self.parts();
        let count = match self {
            // What a name abbreviates is not written here.
            Formula::Name(_) => 0,
            // The upper end of an integral stays.
            Formula::Integral(..) => 1,
            _ => parts.len(),
        };
        for (place, part) in parts.into_iter().take(count).enumerate() {
            mutants.extend(part.mutants().into_iter().map(|mutant| self.with_part(place, &mutant)));
        }
        mutants
    }

    /// The formula with another part in this place.
    fn with_part(&self, place: usize, part: &Formula) -> Formula {
        let mut places = 0..;
        self.rebuilt(|own| if places.next() == Some(place) { part.clone() } else { own.clone() })
    }

    /// The formula with its definitions, and those of substituted values, expanded.
    pub(crate) fn written_out(&self) -> Formula {
        match self {
            Formula::Name(definition) => definition.formula().unwrap_or(self).clone(),
            Formula::At(inner, variable, value) => {
                Formula::At(Box::new(inner.written_out()), *variable, Box::new(value.written_out()))
            }
            other => other.clone(),
        }
    }

    /// The mutants at the top of the tree.
    fn mutants_here(&self) -> Vec<Formula> {
        match self {
            Formula::Number(value) => vec![Formula::Number(Rational::from(value + 1u32))],
            Formula::Negative(inner) => vec![(**inner).clone()],
            Formula::Sum(terms) => {
                terms.iter().enumerate().map(|(i, term)| self.with_part(i, &opposite(term))).collect()
            }
            Formula::Product(factors) => {
                let without = |i: usize| factors[..i].iter().chain(&factors[i + 1..]).cloned().collect();
                (0..factors.len()).map(|i| Formula::Product(without(i))).collect()
            }
            Formula::Quotient(above, below) => vec![Formula::Quotient(below.clone(), above.clone())],
            Formula::Power(base, exponent) => vec![Formula::Power(base.clone(), Box::new(opposite(exponent)))],
            Formula::Root(inner) => vec![(**inner).clone()],
            _ => Vec::new(),
        }
    }
}

fn opposite(formula: &Formula) -> Formula {
    match formula {
        Formula::Negative(inner) => (**inner).clone(),
        other => Formula::Negative(Box::new(other.clone())),
    }
}
