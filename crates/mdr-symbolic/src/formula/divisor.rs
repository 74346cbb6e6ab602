//! What a formula divides by, as it is written.
//!
//! A normal form has lost the divisors that cancel: x²/x² is 1. A formula without a value, such as x²/x² at x = 0, is
//! recognised by the divisors of the tree.

use super::Formula;
use crate::domain::Domain;
use crate::error::{Error, Result};
use crate::quotient::Quotient;

impl Formula {
    /// Whether a divisor of the formula, as written, has the normal form 0: the formula then has a value nowhere on the
    /// domain.
    pub(crate) fn divides_by_zero(&self, domain: Domain) -> bool {
        let vanishes = |divisor: &Formula| divisor.vanishes(domain);
        self.divisors().iter().any(vanishes) || self.fails_by_zero(domain)
    }

    /// Refuses an operation that puts a value in, where it makes a divisor of this formula 0.
    ///
    /// # Errors
    /// [`Error::DivisionByZero`].
    pub(super) fn refuse_poles(&self, domain: Domain, put_in: impl Fn(&Quotient) -> Result<Quotient>) -> Result<()> {
        let at_value = |divisor: &Formula| put_in(&divisor.normalise(domain)?);
        let pole = |divisor: &Formula| at_value(divisor).is_ok_and(|there| there.numerator().is_zero());
        if self.divisors().iter().any(pole) { Err(Error::DivisionByZero) } else { Ok(()) }
    }

    /// Whether it has no normal form because of a function outside the algebra.
    pub(crate) fn is_outside(&self, domain: Domain) -> bool {
        matches!(self.normalise(domain), Err(Error::Transcendental(_)))
    }

    fn vanishes(&self, domain: Domain) -> bool {
        self.normalise(domain).is_ok_and(|normal| normal.numerator().is_zero())
    }

    /// Whether a part that is expanded before it has a value, or a function, divides by 0 in its expansion.
    fn fails_by_zero(&self, domain: Domain) -> bool {
        match self {
            Formula::Derivative(..) | Formula::Integral(..) | Formula::At(..) => {
                matches!(self.normalise(domain), Err(Error::DivisionByZero))
            }
            other => other.parts().into_iter().any(|part| part.fails_by_zero(domain)),
        }
    }

    /// Everything that stands below a fraction bar or under a negative integer power, with the values that are substituted
    /// there. Of an integrand, which may be infinite at single points, nothing is listed.
    pub(crate) fn divisors(&self) -> Vec<Formula> {
        match self {
            Formula::Quotient(above, below) => [above.divisors(), below.divisors(), vec![(**below).clone()]].concat(),
            Formula::Power(base, exponent) => {
                let negative = exponent.written_integer().is_some_and(|exponent| exponent < 0);
                let here = if negative { vec![(**base).clone()] } else { Vec::new() };
                [base.divisors(), exponent.divisors(), here].concat()
            }
            Formula::Integral(_, _, upper) => upper.divisors(),
            Formula::At(inner, variable, value) => {
                let at = |divisor| Formula::At(Box::new(divisor), *variable, value.clone());
                value.divisors().into_iter().chain(inner.divisors().into_iter().map(at)).collect()
            }
            other => other.parts().into_iter().flat_map(Formula::divisors).collect(),
        }
    }
}
