//! Formulas evaluated as they are written, without the algebra that proves them.
//!
//! A derivative is taken by dual numbers, a substituted value is bound to its symbol in the environment, an integral is summed by
//! tanh-sinh quadrature. g is a profile, p x + q x² with random p and q; its slope and its integrals follow from that, at
//! whatever radius they are asked for.

use std::collections::BTreeMap;

use mdr_core::calculus::quadrature::tanh_sinh;
use mdr_core::contact::{Error as Failure, Quantity};
use mdr_core::number::{Dual, Interval, Special};
use mdr_symbolic::formula::{Evaluator, Function, Variable, evaluate};
use mdr_symbolic::{Domain, Error, Formula, Result, Symbol};
use rug::Rational;

use super::point::SamplePoint;
use super::{functions, turn};

/// Numbers that can hold an interval as a constant.
pub(super) trait Level: Special {
    /// A constant.
    fn constant(value: Interval) -> Self;
    /// A number of which nothing is known, nor of its derivatives.
    fn unknown() -> Self;
    /// The interval, if all derivatives are 0.
    fn as_constant(&self) -> Option<Interval>;
    /// A derivative by numbers that have one more, if there are any.
    fn derivative(at: &Direct<'_, Self>, inner: &Formula, along: Symbol, domain: Domain) -> Result<Self>;
}

impl Level for Interval {
    fn constant(value: Interval) -> Self {
        value
    }
    fn unknown() -> Self {
        Interval::entire(mdr_core::number::Precision::new(super::BITS))
    }
    fn as_constant(&self) -> Option<Interval> {
        Some(self.clone())
    }
    fn derivative(at: &Direct<'_, Self>, inner: &Formula, along: Symbol, domain: Domain) -> Result<Self> {
        at.slope(inner, along, domain)
    }
}

/// Dual numbers, and their derivatives.
macro_rules! level {
    ($this:ty, $derivative:expr) => {
        impl Level for $this {
            fn constant(value: Interval) -> Self {
                Dual::constant(Level::constant(value))
            }
            fn unknown() -> Self {
                Dual { value: Level::unknown(), slope: Level::unknown() }
            }
            fn as_constant(&self) -> Option<Interval> {
                let flat = self.slope.as_constant().is_some_and(|slope| slope.is_point() && slope.contains_zero());
                if flat { self.value.as_constant() } else { None }
            }
            fn derivative(at: &Direct<'_, Self>, inner: &Formula, along: Symbol, domain: Domain) -> Result<Self> {
                $derivative(at, inner, along, domain)
            }
        }
    };
}
type First = Dual<Interval>;
type Second = Dual<First>;
type Third = Dual<Second>;
level!(First, Direct::slope);
level!(Second, Direct::slope);
// No statement has four derivatives within each other.
level!(Third, |_, _, _, _| Err(Error::TooLarge("a fourth derivative".to_owned())));

/// A point with values for some symbols, and for n, that are not those of the point.
pub(super) struct Direct<'a, R> {
    point: &'a SamplePoint,
    n: Rational,
    values: BTreeMap<Symbol, R>,
}

impl<'a, R: Level> Direct<'a, R> {
    /// A point, and values that are not those of the point.
    pub(super) fn new(point: &'a SamplePoint, values: impl IntoIterator<Item = (&'static str, R)>) -> Self {
        let values = values.into_iter().filter_map(|(name, value)| Some((Symbol::named(name)?, value)));
        Direct { point, n: point.exponent().clone(), values: values.collect() }
    }

    fn with(&self, symbol: Symbol, value: R) -> Self {
        let mut values = self.values.clone();
        values.insert(symbol, value);
        Direct { point: self.point, n: self.n.clone(), values }
    }

    fn named(&self, name: &str) -> R {
        Symbol::named(name).map_or_else(R::unknown, |symbol| self.symbol(symbol))
    }

    /// g, g', ∫g or ∫g² at the radius a, of the profile p x + q x².
    fn profile(&self, name: &str) -> R {
        let coefficient = |name| R::constant(SamplePoint::interval(&self.point.value(name)));
        let (p, q, a) = (coefficient("g"), coefficient("g'"), self.named("a"));
        match name {
            "g" => (q * &a + p) * &a,
            "g'" => q.times(2) * &a + p,
            "G" => (q.times(2) * &a + p.times(3)) * a.square().over(6),
            _ => {
                let series = q.square().times(6) * a.square() + (p.clone() * q * &a).times(15) + p.square().times(10);
                series * a.powi(3).over(30)
            }
        }
    }

    /// ∫₀^X by quadrature, widened far beyond its error but not beyond the accuracy that is asked of two sides.
    fn integral(&self, inner: &Formula, along: Symbol, upper: &R, domain: Domain) -> R {
        let accuracy = |bits: i64| upper.lit(2).powi(-bits);
        let integrand = |x: &R| {
            let refused =
                |_| Failure::domain(Quantity::Parameter("a variable of integration"), x, "where the integrand is");
            evaluate(inner, domain, &self.with(along, x.clone())).map_err(refused)
        };
        let Ok(integral) = tanh_sinh(&upper.lit(0), upper, &accuracy(60), integrand) else {
            return R::unknown();
        };
        let width = integral.value.clone() * accuracy(40);
        integral.value.inflate_with_slope(&width)
    }
}

impl<R: Level> Direct<'_, R>
where
    Dual<R>: Level,
{
    /// A derivative by dual numbers over these.
    fn slope(&self, inner: &Formula, along: Symbol, domain: Domain) -> Result<R> {
        let raise = |symbol: Symbol, value: &R| match symbol == along {
            true => (symbol, Dual::variable(value.clone())),
            false => (symbol, Dual::constant(value.clone())),
        };
        let mut values: BTreeMap<_, _> = self.values.iter().map(|(symbol, value)| raise(*symbol, value)).collect();
        values.entry(along).or_insert_with(|| Dual::variable(self.symbol(along)));
        Ok(evaluate(inner, domain, &Direct { point: self.point, n: self.n.clone(), values })?.slope)
    }
}

impl<R: Level> Evaluator for Direct<'_, R> {
    type Value = R;

    fn rational(&self, value: &Rational) -> R {
        R::constant(SamplePoint::interval(value))
    }
    fn pi(&self) -> R {
        R::constant(self.point.pi())
    }
    fn n(&self) -> R {
        self.rational(&self.n)
    }
    /// κ and the Gamma functions are those of n; sine and cosine, those of the angle.
    fn symbol(&self, symbol: Symbol) -> R {
        if let Some(value) = self.values.get(&symbol) {
            return value.clone();
        }
        let angle = Symbol::named("θ").and_then(|angle| self.values.get(&angle));
        match (symbol.name(), angle) {
            ("g" | "g'" | "G" | "Q", _) => self.profile(symbol.name()),
            ("sinθ", Some(angle)) => angle.sin(),
            ("cosθ", Some(angle)) => angle.cos(),
            ("κ", _) => R::constant(functions::kappa(&SamplePoint::interval(&self.n))),
            _ => R::constant(self.point.symbol(symbol)),
        }
    }
    fn add(&self, left: &R, right: &R) -> R {
        left.clone() + right
    }
    fn multiply(&self, left: &R, right: &R) -> R {
        left.clone() * right
    }
    fn divide(&self, left: &R, right: &R) -> R {
        self.point.note(right.as_constant().is_some_and(|right| right.is_point() && right.contains_zero()));
        left.clone() / right
    }
    fn integer_power(&self, base: &R, exponent: i32) -> R {
        base.powi(i64::from(exponent))
    }
    fn power(&self, base: &R, exponent: &R) -> R {
        self.point.note(*base < base.lit(0));
        base.pow(exponent)
    }
    /// Of the functions only the sine has derivatives here.
    fn function(&self, function: Function, arguments: &[R]) -> R {
        let constants: Option<Vec<_>> = arguments.iter().map(R::as_constant).collect();
        match (constants, function, arguments) {
            (Some(constants), ..) => R::constant(self.point.function(function, &constants)),
            (None, Function::Sine, [z]) => z.sin(),
            _ => R::unknown(),
        }
    }
    fn quarter_turn(&self, integrand: &Formula) -> R {
        let whole = self.values.is_empty() && self.n == *self.point.exponent();
        if whole { R::constant(turn::quarter_turn(integrand, self.point)) } else { R::unknown() }
    }
    fn operation(&self, formula: &Formula, domain: Domain) -> Result<R> {
        match formula {
            Formula::Derivative(inner, along) => R::derivative(self, inner, *along, domain),
            Formula::Integral(inner, along, upper) => {
                Ok(self.integral(inner, *along, &evaluate(upper, domain, self)?, domain))
            }
            Formula::At(inner, Variable::Symbol(symbol), value) => {
                evaluate(inner, domain, &self.with(*symbol, evaluate(value, domain, self)?))
            }
            Formula::At(inner, Variable::N, value) => {
                let n = value.number().ok_or_else(|| Error::Exponent(value.text()))?;
                evaluate(inner, domain, &Direct { point: self.point, n, values: self.values.clone() })
            }
            part => evaluate(part, domain, self),
        }
    }
}

#[cfg(test)]
#[path = "../../tests/private/direct.rs"]
mod tests;
