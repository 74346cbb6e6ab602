//! Functions on all radii up to one, the axis left out: with powers and logarithms that have no value at 0.

use rug::Rational;

use super::Analytic;
use crate::number::{Interval, Precision, Real, Special};

/// A function on 0 < r ≤ ε < 1 as rᵖ Σ aⱼ(r) ℓʲ with ℓ = ln(1/r), where each aⱼ(r) lies in an interval.
///
/// Over an interval of radii that begins at 0, ln r has no bounds and r² ln r would have none either; here both are kept.
///
/// ```
/// use mdr_core::number::{Analytic, Interval, NearZero, Precision, Real};
/// let end = Interval::from_f64(Precision::new(64), 1e-3);
/// let r = NearZero::up_to(&end).expect("below 1");
/// // r² ln(1 + 1/r) grows up to 1e-6 ln 1001.
/// let one = r.integer(1);
/// let log = one.plus(&one.quotient(&r).unwrap()).ln().unwrap();
/// let range = r.squared().product(&log).range().unwrap();
/// assert!(range.contains(end.lit(0).lower()) && (range.upper().to_f64() / 6.9088e-6 - 1.0).abs() < 1e-3);
/// ```
#[derive(Clone, Debug)]
pub struct NearZero {
    /// ε, and ln(1/ε).
    end: Interval,
    log: Interval,
    /// p.
    order: Rational,
    /// The aⱼ; at least one.
    coefficients: Vec<Interval>,
}

impl NearZero {
    /// r itself; `None` unless ε is certainly within (0, 1).
    pub fn up_to(end: &Interval) -> Option<Self> {
        let end = Interval::point(end.upper().clone());
        let log = -Real::ln(&end);
        (log > log.lit(0) && Real::is_finite(&log)).then(|| {
            let coefficients = vec![end.lit(1)];
            NearZero { end, log, order: Rational::from(1), coefficients }
        })
    }

    /// An interval that contains all values; `None` if there is none.
    pub fn range(&self) -> Option<Interval> {
        if let ([only], true) = (self.coefficients.as_slice(), self.order == 0) {
            return Real::is_finite(only).then(|| only.clone());
        }
        if self.order <= 0 {
            return self.is_zero().then(|| self.end.lit(0));
        }
        let terms = self.coefficients.iter().enumerate();
        let sum = terms.fold(self.end.lit(0), |sum, (j, a)| sum + a.clone() * self.largest(j).hull(&self.end.lit(0)));
        Real::is_finite(&sum).then_some(sum)
    }

    /// The largest value of rᵖ ℓʲ, for p > 0: at ℓ = j/p, or at ε if that is beyond it.
    fn largest(&self, j: usize) -> Interval {
        let order = Interval::from_rational(self.end.ctx(), &self.order);
        let [power, number] = [j as i64, j as i64].map(|j| self.end.lit(j));
        if j == 0 || self.log >= number.clone() / &order {
            return self.end.pow(&order) * self.log.powi(j as i64);
        }
        (number / (order * Real::exp(&self.end.lit(1)))).pow(&power)
    }

    fn is_zero(&self) -> bool {
        self.coefficients.iter().all(|a| *a == a.lit(0))
    }

    fn of(&self, order: Rational, coefficients: Vec<Interval>) -> Self {
        let mut value = NearZero { end: self.end.clone(), log: self.log.clone(), order, coefficients };
        while value.coefficients.len() > 1 && value.coefficients.last().is_some_and(|a| *a == a.lit(0)) {
            value.coefficients.pop();
        }
        value
    }

    /// rᵖ a without a logarithm: p and a.
    fn power_of_radius(&self) -> Option<(&Rational, &Interval)> {
        match self.coefficients.as_slice() {
            [a] => Some((&self.order, a)),
            _ => None,
        }
    }

    /// A function of the values, by its range; the entire line where they have no bounds.
    fn by_range(&self, function: impl Fn(&Interval) -> Interval) -> Self {
        let range = self.range().map_or_else(|| Interval::entire(self.end.ctx()), |range| function(&range));
        self.of(Rational::new(), vec![range])
    }

    /// Likewise, `None` where it is not defined.
    fn defined_by_range(&self, function: impl Fn(&Interval) -> Option<Interval>) -> Option<Self> {
        Some(self.of(Rational::new(), vec![function(&self.range()?)?]))
    }

    fn sum(&self, other: &Self, sign: i64) -> Self {
        let order = if self.is_zero() {
            &other.order
        } else if other.is_zero() {
            &self.order
        } else {
            (&self.order).min(&other.order)
        };
        let of = |value: &Self, j: usize, sign: i64| {
            let a = value.coefficients.get(j).cloned().unwrap_or_else(|| self.end.lit(0)).times(sign);
            let excess = Rational::from(&value.order - order);
            if excess == 0 || a == a.lit(0) {
                return a;
            }
            a * self.end.pow(&Interval::from_rational(self.end.ctx(), &excess)).hull(&self.end.lit(0))
        };
        let count = self.coefficients.len().max(other.coefficients.len());
        let coefficients = (0..count).map(|j| of(self, j, 1) + of(other, j, sign)).collect();
        self.of(order.clone(), coefficients)
    }
}

impl Analytic for NearZero {
    const WORK: u64 = 8;

    fn bits(&self) -> u32 {
        self.end.precision()
    }
    fn constant(&self, value: &Interval) -> Self {
        self.of(Rational::new(), vec![value.rounded(self.end.ctx())])
    }
    fn plus(&self, other: &Self) -> Self {
        self.sum(other, 1)
    }
    fn minus(&self, other: &Self) -> Self {
        self.sum(other, -1)
    }
    fn product(&self, other: &Self) -> Self {
        let (one, two) = (&self.coefficients, &other.coefficients);
        let mut product = vec![self.end.lit(0); one.len() + two.len() - 1];
        for (j, a) in one.iter().enumerate() {
            for (k, b) in two.iter().enumerate() {
                product[j + k] += &(a.clone() * b);
            }
        }
        self.of(Rational::from(&self.order + &other.order), product)
    }
    fn scaled(&self, factor: &Interval) -> Self {
        let factor = factor.rounded(self.end.ctx());
        self.of(self.order.clone(), self.coefficients.iter().map(|a| a.clone() * &factor).collect())
    }
    fn squared(&self) -> Self {
        match self.power_of_radius() {
            Some((order, a)) => self.of(Rational::from(order * 2u32), vec![a.square()]),
            None => self.product(self),
        }
    }
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        let (order, a) = divisor.power_of_radius()?;
        let coefficients = self.coefficients.iter().map(|b| b.quotient(a)).collect::<Option<_>>()?;
        Some(self.of(Rational::from(&self.order - order), coefficients))
    }
    /// From a lower bound of the exponent: what is left of rʸ is within (0, 1].
    fn power(&self, exponent: &Interval) -> Option<Self> {
        let (order, a) = self.power_of_radius()?;
        let exponent = exponent.rounded(self.end.ctx());
        let value = Analytic::power(a, &exponent)?;
        if *order == 0 {
            return Some(self.of(Rational::new(), vec![value]));
        }
        let least = if *order > 0 { exponent.lower() } else { exponent.upper() }.to_rational()?;
        let rest = if exponent.is_point() { self.end.lit(1) } else { self.end.lit(0).hull(&self.end.lit(1)) };
        Some(self.of(order * least, vec![value * rest]))
    }
    fn sqrt(&self) -> Option<Self> {
        let (order, a) = self.power_of_radius()?;
        Some(self.of(Rational::from(order / 2u32), vec![Analytic::sqrt(a)?]))
    }
    /// e^(a + bℓ) = e^a r^(−b).
    fn exp(&self) -> Self {
        if let ([a, b], true) = (self.coefficients.as_slice(), self.order == 0)
            && b.is_point()
            && let Some(b) = b.lower().to_rational()
        {
            return self.of(-b, vec![Real::exp(a)]);
        }
        self.by_range(Real::exp)
    }
    /// ln(a rᵖ) = ln a − pℓ.
    fn ln(&self) -> Option<Self> {
        let (order, a) = self.power_of_radius()?;
        let slope = -Interval::from_rational(self.end.ctx(), order);
        Some(self.of(Rational::new(), vec![Analytic::ln(a)?, slope]))
    }
    fn sin_cos(&self) -> (Self, Self) {
        (self.by_range(Special::sin), self.by_range(Special::cos))
    }
    fn sinh_cosh(&self) -> (Self, Self) {
        (self.by_range(Special::sinh), self.by_range(Special::cosh))
    }
    fn atan(&self) -> Option<Self> {
        self.defined_by_range(Analytic::atan)
    }
    fn asin(&self) -> Option<Self> {
        self.defined_by_range(Analytic::asin)
    }
    fn atanh(&self) -> Option<Self> {
        self.defined_by_range(Analytic::atanh)
    }
    fn is_bounded(&self) -> bool {
        self.range().is_some()
    }
    fn integer(&self, value: i64) -> Self {
        self.constant(&Interval::from_int(Precision::new(self.bits()), value))
    }
}
