//! Small errors in a formula: a sign, an exponent, a factor. A statement that remains true after one of them says
//! little.

use rug::Rational;

use super::Formula;

impl Formula {
    /// All formulas that differ from this one in one place: a number too large by one, a sign flipped, an exponent of
    /// the opposite sign, a factor omitted, a quotient inverted, a root omitted.
    pub fn mutants(&self) -> Vec<Formula> {
        let mut mutants = self.mutants_here();
        let within = |part: &Formula, rebuild: &dyn Fn(Box<Formula>) -> Formula| -> Vec<Formula> {
            part.mutants().into_iter().map(|mutant| rebuild(Box::new(mutant))).collect()
        };
        match self {
            Formula::Number(_) | Formula::N | Formula::Pi | Formula::Symbol(_) | Formula::Name(_) => {}
            Formula::Negative(inner) => mutants.extend(within(inner, &Formula::Negative)),
            Formula::Sum(parts) => mutants.extend(in_list(parts).map(Formula::Sum)),
            Formula::Product(parts) => mutants.extend(in_list(parts).map(Formula::Product)),
            Formula::Quotient(above, below) => {
                mutants.extend(within(above, &|above| Formula::Quotient(above, below.clone())));
                mutants.extend(within(below, &|below| Formula::Quotient(above.clone(), below)));
            }
            Formula::Power(base, exponent) => {
                mutants.extend(within(base, &|base| Formula::Power(base, exponent.clone())));
                mutants.extend(within(exponent, &|exponent| Formula::Power(base.clone(), exponent)));
            }
            Formula::Root(inner) => mutants.extend(within(inner, &Formula::Root)),
            Formula::Derivative(inner, along) => mutants.extend(within(inner, &|of| Formula::Derivative(of, *along))),
            Formula::Integral(inner, along, to) => {
                mutants.extend(within(inner, &|of| Formula::Integral(of, *along, to.clone())));
            }
            Formula::At(inner, variable, value) => {
                mutants.extend(within(inner, &|of| Formula::At(of, *variable, value.clone())));
                mutants.extend(within(value, &|value| Formula::At(inner.clone(), *variable, value)));
            }
            Formula::Function(function, arguments) => {
                mutants.extend(in_list(arguments).map(|arguments| Formula::Function(*function, arguments)));
            }
            Formula::QuarterTurn(inner) => mutants.extend(within(inner, &Formula::QuarterTurn)),
        }
        mutants
    }

    /// The formula with its definitions, and those of substituted values, expanded.
    pub(crate) fn written_out(&self) -> Formula {
        match self {
            Formula::Name(definition) => definition.formula().unwrap_or_else(|_| self.clone()),
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
                (0..terms.len()).map(|i| Formula::Sum(changed(terms, i, opposite(&terms[i])))).collect()
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

fn changed(parts: &[Formula], index: usize, part: Formula) -> Vec<Formula> {
    let mut parts = parts.to_vec();
    parts[index] = part;
    parts
}

/// The lists with an error in one of their parts.
fn in_list(parts: &[Formula]) -> impl Iterator<Item = Vec<Formula>> {
    let mistakes = |(i, part): (usize, &Formula)| {
        part.mutants().into_iter().map(|mutant| changed(parts, i, mutant)).collect::<Vec<_>>()
    };
    parts.iter().enumerate().flat_map(mistakes).collect::<Vec<_>>().into_iter()
}
