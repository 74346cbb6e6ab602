//! Functions on all numbers of a ray up to one, 0 left out: with powers and logarithms that have no value at 0.

use std::cmp::Ordering;

use rug::Rational;

use super::Analytic;
use crate::number::{Interval, Precision, Real};

/// A function of r = x s, 0 < s ≤ ε < 1, as sᵖ Σ aⱼ(s) ℓʲ with ℓ = ln(1/s), where each aⱼ(s) lies in a set.
///
/// Over an interval of radii that begins at 0, ln r has no bounds and r² ln r would have none either; here both are kept.
///
/// ```
/// use mdr_core::number::{Analytic, Interval, NearZero, Precision, Real};
/// let end = Interval::from_f64(Precision::new(64), 1e-3);
/// let r = NearZero::up_to(&end.lit(1), &end).expect("below 1");
/// // r² ln(1 + 1/r) grows up to 1e-6 ln 1001.
/// let one = r.integer(1);
/// let log = one.plus(&one.quotient(&r).unwrap()).ln().unwrap();
/// let range = r.squared().product(&log).range().unwrap();
/// assert!(range.contains(end.lit(0).lower()) && (range.upper().to_f64() / 6.9088e-6 - 1.0).abs() < 1e-3);
/// ```
#[derive(Clone, Debug)]
pub struct NearZero<T> {
    /// 1.
    unit: T,
    /// ε, and ln(1/ε).
    end: Interval,
    log: Interval,
    /// p.
    order: Rational,
    /// The aⱼ; none of a function that is exactly zero.
    coefficients: Vec<T>,
}

impl<T: Analytic> NearZero<T> {
    /// r itself; `None` unless ε is certainly within (0, 1).
    pub fn up_to(x: &T, end: &Interval) -> Option<Self> {
        let end = Interval::point(end.upper().clone());
        let log = -Real::ln(&end);
        let is_within = log > log.lit(0) && Real::is_finite(&log);
        is_within.then(|| NearZero {
            unit: x.integer(1),
            end,
            log,
            order: Rational::from(1),
            coefficients: vec![x.clone()],
        })
    }

    /// A set that contains all values; `None` if there is none.
    pub fn range(&self) -> Option<T> {
        let is_constant = self.order == 0 && self.coefficients.len() == 1;
        if !(is_constant || self.order > 0 || self.coefficients.is_empty()) {
            return None;
        }
        let zero = self.end.lit(0);
        let terms = self.coefficients.iter().enumerate();
        let term = |(j, a): (usize, &T)| if is_constant { a.clone() } else { a.scaled(&self.largest(j).hull(&zero)) };
        let sum = terms.map(term).fold(self.unit.integer(0), |sum, term| sum.plus(&term));
        sum.is_bounded().then_some(sum)
    }

    /// The largest value of sᵖ ℓʲ, for p > 0: at ℓ = j/p, or at ε if that is beyond it.
    fn largest(&self, j: usize) -> Interval {
        let order = Interval::from_rational(self.end.ctx(), &self.order);
        let number = self.end.lit(j as i64);
        if j == 0 || self.log >= number.clone() / &order {
            return self.end.pow(&order) * self.log.powi(j as i64);
        }
        (number / (order * Real::exp(&self.end.lit(1)))).powi(j as i64)
    }

    fn of(&self, order: Rational, coefficients: Vec<T>) -> Self {
        let NearZero { unit, end, log, .. } = self.clone();
        NearZero { unit, end, log, order, coefficients }
    }

    /// sᵖ a without a logarithm: p and a.
    fn power_of_share(&self) -> Option<(&Rational, &T)> {
        match self.coefficients.as_slice() {
            [a] => Some((&self.order, a)),
            _ => None,
        }
    }

    /// A function of the values, by their range; nothing is known of it where they have no bounds.
    fn by_range(&self, function: impl Fn(&T) -> T) -> Self {
        let entire = || self.unit.constant(&Interval::entire(self.end.ctx()));
        self.constant_set(self.range().map_or_else(entire, |range| function(&range)))
    }

    /// Values within one set, of which nothing more is known.
    fn constant_set(&self, value: T) -> Self {
        self.of(Rational::new(), vec![value])
    }

    fn sum(&self, other: &Self, of_other: impl Fn(&T) -> T) -> Self {
        let order = match (self.coefficients.is_empty(), other.coefficients.is_empty()) {
            (true, _) => &other.order,
            (_, true) => &self.order,
            _ => (&self.order).min(&other.order),
        };
        let of = |value: &Self| {
            let excess = Rational::from(&value.order - order);
            let share = self.end.pow(&Interval::from_rational(self.end.ctx(), &excess)).hull(&self.end.lit(0));
            let scaled = |a: &T| if excess == 0 { a.clone() } else { a.scaled(&share) };
            value.coefficients.iter().map(scaled).collect::<Vec<_>>()
        };
        let (mut sum, other) = (of(self), of(other));
        for (j, a) in other.iter().map(of_other).enumerate() {
            match sum.get_mut(j) {
                Some(sum) => *sum = sum.plus(&a),
                None => sum.push(a),
            }
        }
        self.of(order.clone(), sum)
    }
}

impl<T: Analytic> Analytic for NearZero<T> {
    const WORK: u64 = T::WORK;
    type Complex = Self;

    fn bits(&self) -> u32 {
        self.unit.bits()
    }
    fn constant(&self, value: &Interval) -> Self {
        let is_zero = *value.lower() == 0 && *value.upper() == 0;
        self.of(Rational::new(), if is_zero { Vec::new() } else { vec![self.unit.constant(value)] })
    }
    fn plus(&self, other: &Self) -> Self {
        self.sum(other, T::clone)
    }
    fn minus(&self, other: &Self) -> Self {
        self.sum(other, T::negated)
    }
    fn product(&self, other: &Self) -> Self {
        let mut product: Vec<T> = Vec::new();
        for (j, a) in self.coefficients.iter().enumerate() {
            for (k, b) in other.coefficients.iter().enumerate() {
                let term = a.product(b);
                match product.get_mut(j + k) {
                    Some(sum) => *sum = sum.plus(&term),
                    None => product.push(term),
                }
            }
        }
        self.of(Rational::from(&self.order + &other.order), product)
    }
    fn scaled(&self, factor: &Interval) -> Self {
        self.product(&self.constant(factor))
    }
    fn squared(&self) -> Self {
        match self.power_of_share() {
            Some((order, a)) => self.of(Rational::from(order * 2u32), vec![a.squared()]),
            None => self.product(self),
        }
    }
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        let (order, a) = divisor.power_of_share()?;
        let coefficients = self.coefficients.iter().map(|b| b.quotient(a)).collect::<Option<_>>()?;
        Some(self.of(Rational::from(&self.order - order), coefficients))
    }
    /// From a bound of the exponent: what is left of sʸ is within (0, 1].
    fn power(&self, exponent: &Interval) -> Option<Self> {
        let (order, a) = self.power_of_share()?;
        let value = a.power(exponent)?;
        if *order == 0 {
            return Some(self.constant_set(value));
        }
        let least = if *order > 0 { exponent.lower() } else { exponent.upper() }.to_rational()?;
        let unit = self.end.lit(0).hull(&self.end.lit(1));
        let value = if exponent.is_point() { value } else { value.scaled(&unit) };
        Some(self.of(order * least, vec![value]))
    }
    fn sqrt(&self) -> Option<Self> {
        let (order, a) = self.power_of_share()?;
        Some(self.of(Rational::from(order / 2u32), vec![a.sqrt()?]))
    }
    fn exp(&self) -> Self {
        self.by_range(T::exp)
    }
    /// ln(a sᵖ) = ln a − pℓ.
    fn ln(&self) -> Option<Self> {
        let (order, a) = self.power_of_share()?;
        let slope = self.unit.constant(&-Interval::from_rational(self.end.ctx(), order));
        let without = *order == 0;
        Some(self.of(Rational::new(), if without { vec![a.ln()?] } else { vec![a.ln()?, slope] }))
    }
    fn sin_cos(&self) -> (Self, Self) {
        (self.by_range(|x| x.sin_cos().0), self.by_range(|x| x.sin_cos().1))
    }
    fn sinh_cosh(&self) -> (Self, Self) {
        (self.by_range(|x| x.sinh_cosh().0), self.by_range(|x| x.sinh_cosh().1))
    }
    fn tanh(&self) -> Option<Self> {
        Some(self.constant_set(self.range()?.tanh()?))
    }
    fn atan(&self) -> Option<Self> {
        Some(self.constant_set(self.range()?.atan()?))
    }
    fn asin(&self) -> Option<Self> {
        Some(self.constant_set(self.range()?.asin()?))
    }
    fn atanh(&self) -> Option<Self> {
        Some(self.constant_set(self.range()?.atanh()?))
    }
    fn is_bounded(&self) -> bool {
        self.range().is_some()
    }
    fn side(&self) -> Option<Ordering> {
        self.range()?.side()
    }
    fn is_small(&self) -> bool {
        self.range().is_some_and(|range| range.is_small())
    }
    fn integer(&self, value: i64) -> Self {
        self.constant(&Interval::from_int(Precision::new(self.bits()), value))
    }
}
