//! The divisors of a formula as it is written.
//!
//! A normal form has lost the divisors that cancel: x²/x² is 1. A formula without a value, such as x²/x² at x = 0, is
//! recognised by the divisors of the tree.

use super::{Formula, Function, Variable};
use crate::domain::Domain;
use crate::error::{Error, Result};
use crate::quotient::Quotient;
use crate::symbol::Symbol;

/// A part of a formula that leaves it without a value where it is 0, or a pole of Γ.
struct Divisor {
    part: Formula,
    role: Role,
}

/// Where a [`Divisor`] stands.
enum Role {
    /// Below a fraction bar.
    Denominator,
    /// Under this exponent, which may be negative.
    Base(Formula),
    /// In Γ or κ, which have poles at natural numbers below 1.
    Argument,
}

impl Divisor {
    /// With its parts changed in one way.
    fn map(self, change: impl Fn(Formula) -> Formula) -> Self {
        let role = match self.role {
            Role::Base(exponent) => Role::Base(change(exponent)),
            other => other,
        };
        Divisor { part: change(self.part), role }
    }

    /// Whether it leaves the formula without a value on the whole domain once values are put in.
    ///
    /// # Errors
    /// Errors of [`Formula::normalise`] and of `put_in`; [`Error::Divisor`] where a relation of symbols that the algebra does
    /// not include may make it 0.
    fn is_pole(&self, domain: Domain, put_in: &impl Fn(&Quotient) -> Result<Quotient>) -> Result<bool> {
        let there = put_in(&self.part.normalise(domain)?)?;
        let is_zero = || there.numerator().vanishes(domain)?.ok_or_else(|| Error::Divisor(self.part.text()));
        match &self.role {
            Role::Denominator => is_zero(),
            // 0 to a power that is not known to be > 0. A power that is written as 0 is 1 by the rule of polynomials; one
            // that is calculated, such as n − n, is a real power.
            Role::Base(exponent) => {
                let exponent = put_in(&exponent.normalise(domain)?)?.as_function();
                let positive = exponent.and_then(|exponent| exponent.sign_on(domain)).is_some_and(|sign| sign.is_gt());
                Ok(!positive && is_zero()?)
            }
            Role::Argument => {
                let number = there.as_function().and_then(|argument| argument.as_constant());
                Ok(number.is_some_and(|number| number.is_integer() && number < 1))
            }
        }
    }
}

impl Formula {
    /// Whether a divisor of the formula, as written, has the normal form 0: the formula then has a value nowhere on the
    /// domain.
    pub(crate) fn divides_by_zero(&self, domain: Domain) -> bool {
        let vanishes = |divisor: &Divisor| divisor.is_pole(domain, &|normal| Ok(normal.clone())).unwrap_or(false);
        let listed = self.all_divisors(&mut self.symbols());
        listed.is_ok_and(|divisors| divisors.iter().any(vanishes)) || self.fails_by_zero(domain)
    }

    /// Refuses a formula with a divisor, as written, that is 0 on the whole domain, or that a relation may make 0.
    ///
    /// # Errors
    /// [`Error::DivisionByZero`], [`Error::Divisor`]; errors of [`Formula::normalise`] for a divisor.
    pub(crate) fn refuse_divisors(&self, domain: Domain) -> Result<()> {
        self.refuse_poles(domain, &[], |normal| Ok(normal.clone()))
    }

    /// Refuses an operation that puts a value in, where it makes a divisor of this formula 0, or where that cannot be
    /// decided. `symbols` are those of the operation.
    ///
    /// # Errors
    /// [`Error::DivisionByZero`], [`Error::Divisor`]; errors of [`Formula::normalise`] for a divisor at the value.
    pub(super) fn refuse_poles(
        &self,
        domain: Domain,
        symbols: &[Symbol],
        put_in: impl Fn(&Quotient) -> Result<Quotient>,
    ) -> Result<()> {
        let mut taken = self.symbols();
        taken.extend(symbols);
        for divisor in self.all_divisors(&mut taken)? {
            if divisor.is_pole(domain, &put_in)? {
                return Err(Error::DivisionByZero);
            }
        }
        Ok(())
    }

    /// Whether it has no normal form because of a function outside the algebra.
    pub(crate) fn is_outside(&self, domain: Domain) -> bool {
        matches!(self.normalise(domain), Err(Error::Transcendental(_)))
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

    /// Every divisor, with the values that are substituted there. In an integrand, which may be infinite at single points, the
    /// variable of integration is replaced by a symbol that is not `taken`, so that no value is put in for it: what is 0
    /// then is 0 along the whole range.
    ///
    /// # Errors
    /// [`Error::TooLarge`] if there are more integrals than symbols.
    fn all_divisors(&self, taken: &mut Vec<Symbol>) -> Result<Vec<Divisor>> {
        let mut found = Vec::new();
        match self {
            Formula::Integral(inner, variable, upper) => {
                let inside = inner.all_divisors(taken)?;
                if !inside.is_empty() {
                    let point = Symbol::all().find(|symbol| symbol.is_free() && !taken.contains(symbol));
                    let point = point.ok_or_else(|| Error::TooLarge(self.text()))?;
                    taken.push(point);
                    let (variable, point) = (Variable::Symbol(*variable), Box::new(Formula::Symbol(point)));
                    let at = |part| Formula::At(Box::new(part), variable, point.clone());
                    found.extend(inside.into_iter().map(|divisor| divisor.map(at)));
                }
                found.extend(upper.all_divisors(taken)?);
            }
            Formula::At(inner, variable, value) => {
                let at = |part| Formula::At(Box::new(part), *variable, value.clone());
                found.extend(value.all_divisors(taken)?);
                found.extend(inner.all_divisors(taken)?.into_iter().map(|divisor| divisor.map(at)));
            }
            other => {
                for part in other.parts() {
                    found.extend(part.all_divisors(taken)?);
                }
            }
        }
        found.extend(self.own_divisor());
        Ok(found)
    }

    /// The divisor of this formula itself, apart from those of its parts.
    fn own_divisor(&self) -> Option<Divisor> {
        let (part, role) = match self {
            Formula::Quotient(_, below) => (&**below, Role::Denominator),
            // A power that is written as a natural number has no pole.
            Formula::Power(_, exponent) if exponent.written_integer().is_some_and(|exponent| exponent >= 0) => {
                return None;
            }
            Formula::Power(base, exponent) => (&**base, Role::Base((**exponent).clone())),
            Formula::Function(Function::Gamma | Function::Kappa, arguments) => (&arguments[0], Role::Argument),
            _ => return None,
        };
        Some(Divisor { part: part.clone(), role })
    }

    /// Every symbol that is written, variables of integration and substitution among them.
    pub(super) fn symbols(&self) -> Vec<Symbol> {
        let here = match self {
            Formula::Symbol(symbol) | Formula::Derivative(_, symbol) | Formula::Integral(_, symbol, _) => Some(*symbol),
            Formula::At(_, Variable::Symbol(symbol), _) => Some(*symbol),
            _ => None,
        };
        here.into_iter().chain(self.parts().into_iter().flat_map(Formula::symbols)).collect()
    }

    /// The formulas below a fraction bar or under a negative integer power, with the values that are substituted there: the
    /// hypotheses of a statement in Coq. Of an integrand, which may be infinite at single points, nothing is listed.
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
