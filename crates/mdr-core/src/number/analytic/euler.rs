//! Derivatives in the logarithm of a radius.

use std::cmp::Ordering;

use super::Analytic;
use crate::number::Interval;

/// A function of r with its Euler derivatives D = r d/dr up to some order: the Taylor coefficients Dᵏv/k! in ln r.
///
/// Unlike a derivative in r these stay bounded at the tip of a profile such as r^(1/4). There a quotient Dv/v would be
/// 0/0; so the coefficients of Dv/v are kept where a formula gives them without a division, as for powers of r, products
/// and exponentials.
///
/// ```
/// use mdr_core::number::{Analytic, Euler, Interval, Precision, Real};
/// let bits = Precision::new(64);
/// let r = Interval::from_int(bits, 0).hull(&Interval::from_int(bits, 1));
/// // D r^(1/4) = r^(1/4)/4, within [0, 1/4] on all of [0, 1].
/// let root = Euler::variable(&r, 1).power(&Interval::from_f64(bits, 0.25)).unwrap();
/// let slope = root.derivative(1);
/// assert!(*slope.lower() == 0 && *slope.upper() == 0.25);
/// ```
#[derive(Clone, Debug)]
pub struct Euler<T> {
    /// Dᵏv/k!.
    coefficients: Vec<T>,
    /// The coefficients of Dv/v, one fewer, where they are known without a division.
    logarithmic: Option<Vec<T>>,
}

impl<T: Analytic> Euler<T> {
    /// r itself, with derivatives up to an order.
    pub fn variable(r: &T, order: usize) -> Self {
        Self::root(r, 1, order)
    }

    /// The root q = r^(1/k) of the radius, with derivatives up to an order: Dq = q/k.
    ///
    /// ```
    /// use mdr_core::number::{Analytic, Euler, Interval, Precision, Real};
    /// let q = Euler::root(&Interval::from_f64(Precision::new(64), 0.5), 4, 1);
    /// // D q⁴ = D r = r.
    /// assert!(q.raised(4).is_some_and(|r| r.derivative(1).contains(&rug::Float::with_val(64, 0.0625))));
    /// ```
    pub fn root(q: &T, k: u32, order: usize) -> Self {
        let mut logarithmic = vec![q.integer(0); order];
        if let Some(first) = logarithmic.first_mut() {
            *first = q.integer(1).divided(i64::from(k));
        }
        Self::growing(q.clone(), logarithmic)
    }

    /// The value.
    pub fn value(&self) -> &T {
        &self.coefficients[0]
    }

    /// Dᵏv, for k up to the order.
    pub fn derivative(&self, k: usize) -> T {
        let factorial: i64 = (1..=k as i64).product();
        if factorial == 1 { self.coefficients[k].clone() } else { self.coefficients[k].multiplied(factorial) }
    }

    /// The value, replaced by one that is known better.
    pub fn with_value(mut self, value: T) -> Self {
        self.coefficients[0] = value;
        self.logarithmic = None;
        self
    }

    /// The value and its derivatives, from the first one on; `None` without any value.
    pub fn from_derivatives(derivatives: Vec<T>) -> Option<Self> {
        let mut factorial = 1;
        let coefficient = |(k, derivative): (usize, T)| {
            factorial *= (k as i64).max(1);
            if factorial == 1 { derivative } else { derivative.divided(factorial) }
        };
        let coefficients: Vec<T> = derivatives.into_iter().enumerate().map(coefficient).collect();
        (!coefficients.is_empty()).then(|| Self::of(coefficients))
    }

    /// The value and its derivatives.
    pub fn derivatives(&self) -> Vec<T> {
        (0..=self.order()).map(|k| self.derivative(k)).collect()
    }

    /// Parts of two numbers combined one by one, such as by the hull of both.
    pub fn combined(&self, other: &Self, combine: impl Fn(&T, &T) -> T) -> Self {
        Self::of(self.coefficients.iter().zip(&other.coefficients).map(|(one, other)| combine(one, other)).collect())
    }

    fn of(coefficients: Vec<T>) -> Self {
        Euler { coefficients, logarithmic: None }
    }

    /// The highest order of a derivative.
    pub fn order(&self) -> usize {
        self.coefficients.len() - 1
    }

    /// A constant, without derivatives.
    fn whole(&self, value: T) -> Self {
        let zero = value.integer(0);
        let mut coefficients = vec![zero.clone(); self.order() + 1];
        coefficients[0] = value;
        Euler { coefficients, logarithmic: Some(vec![zero; self.order()]) }
    }

    /// x/k for a small integer.
    fn part(x: &T, k: usize) -> T {
        if k == 1 { x.clone() } else { x.divided(k as i64) }
    }

    /// From the value and the coefficients of Dv/v: k v_k is the sum of l_j v_(k−1−j).
    fn growing(value: T, logarithmic: Vec<T>) -> Self {
        let mut grown = Self::of(vec![value]);
        for k in 1..=logarithmic.len() {
            let sum = convolution(&logarithmic, &grown.coefficients, k - 1);
            grown.coefficients.push(Self::part(&sum, k));
        }
        Euler { logarithmic: Some(logarithmic), ..grown }
    }

    /// The function with a given value whose D is given.
    fn integral(value: T, slope: &[T]) -> Self {
        let mut integral = Self::of(vec![value]);
        for (j, slope) in slope.iter().enumerate() {
            integral.coefficients.push(Self::part(slope, j + 1));
        }
        integral
    }

    /// The coefficients of Dv.
    fn slopes(&self) -> Vec<T> {
        let times = |(j, c): (usize, &T)| if j == 0 { c.clone() } else { c.multiplied(j as i64 + 1) };
        self.coefficients[1..].iter().enumerate().map(times).collect()
    }

    /// The coefficients of Dv/v.
    fn growth(&self) -> Option<Vec<T>> {
        self.logarithmic.clone().map_or_else(|| quotient(&self.slopes(), &self.coefficients), Some)
    }

    /// The function f of this with Df = f'·D of this, from its value and f' as a function of this.
    fn chained(&self, value: T, derivative: Option<Self>) -> Option<Self> {
        let derivative = derivative?;
        let slopes = self.slopes();
        let product = (0..slopes.len()).map(|k| convolution(&slopes, &derivative.coefficients, k)).collect::<Vec<_>>();
        Some(Self::integral(value, &product))
    }

    /// The solutions s and c of Ds = c·Dx, Dc = ±s·Dx.
    fn rotated(&self, (s, c): (T, T), sign: i64) -> (Self, Self) {
        let slopes = self.slopes();
        let (mut s, mut c) = (Self::of(vec![s]), Self::of(vec![c]));
        for k in 1..=self.order() {
            let [rise, fall] = [&c, &s].map(|other| convolution(&slopes, &other.coefficients, k - 1));
            s.coefficients.push(Self::part(&rise, k));
            let fall = Self::part(&fall, k);
            c.coefficients.push(if sign < 0 { fall.negated() } else { fall });
        }
        (s, c)
    }
}

/// The coefficient of order k of a product.
fn convolution<T: Analytic>(one: &[T], other: &[T], k: usize) -> T {
    let mut terms = (0..=k).map(|j| one[j].product(&other[k - j]));
    let first = terms.next().unwrap_or_else(|| one[0].integer(0));
    terms.fold(first, |sum, term| sum.plus(&term))
}

/// The coefficients of a quotient.
fn quotient<T: Analytic>(one: &[T], other: &[T]) -> Option<Vec<T>> {
    let mut quotient: Vec<T> = Vec::with_capacity(one.len());
    for k in 0..one.len() {
        let rest = (0..k).fold(one[k].clone(), |rest, j| rest.minus(&quotient[j].product(&other[k - j])));
        quotient.push(rest.quotient(&other[0])?);
    }
    Some(quotient)
}

impl<T: Analytic> Analytic for Euler<T> {
    const WORK: u64 = T::WORK;
    type Complex = Euler<T::Complex>;

    fn bits(&self) -> u32 {
        self.coefficients[0].bits()
    }
    fn constant(&self, value: &Interval) -> Self {
        self.whole(self.value().constant(value))
    }
    fn plus(&self, other: &Self) -> Self {
        self.combined(other, T::plus)
    }
    fn minus(&self, other: &Self) -> Self {
        self.combined(other, T::minus)
    }
    fn product(&self, other: &Self) -> Self {
        if let (Some(one), Some(two)) = (&self.logarithmic, &other.logarithmic) {
            let sum = one.iter().zip(two).map(|(one, two)| one.plus(two)).collect();
            return Self::growing(self.value().product(other.value()), sum);
        }
        let (one, two) = (&self.coefficients, &other.coefficients);
        Self::of((0..=self.order()).map(|k| convolution(one, two, k)).collect())
    }
    fn scaled(&self, factor: &Interval) -> Self {
        let coefficients = self.coefficients.iter().map(|c| c.scaled(factor)).collect();
        Euler { coefficients, logarithmic: self.logarithmic.clone() }
    }
    fn squared(&self) -> Self {
        let value = self.value().squared();
        match &self.logarithmic {
            Some(logarithmic) => Self::growing(value, logarithmic.iter().map(|l| l.multiplied(2)).collect()),
            None => {
                let mut square = self.product(self);
                square.coefficients[0] = value;
                square
            }
        }
    }
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        let value = self.value().quotient(divisor.value())?;
        if let (Some(one), Some(two)) = (&self.logarithmic, &divisor.logarithmic) {
            let difference = one.iter().zip(two).map(|(one, two)| one.minus(two)).collect();
            return Some(Self::growing(value, difference));
        }
        Some(Self::of(quotient(&self.coefficients, &divisor.coefficients)?))
    }
    fn raised(&self, exponent: i64) -> Option<Self> {
        if let Some(logarithmic) = &self.logarithmic {
            let scaled = logarithmic.iter().map(|l| l.multiplied(exponent)).collect();
            return Some(Self::growing(self.value().raised(exponent)?, scaled));
        }
        self.raised_by_squaring(exponent)
    }
    fn power(&self, exponent: &Interval) -> Option<Self> {
        let value = self.value().power(exponent)?;
        Some(Self::growing(value, self.growth()?.iter().map(|l| l.scaled(exponent)).collect()))
    }
    fn sqrt(&self) -> Option<Self> {
        let value = self.value().sqrt()?;
        Some(Self::growing(value, self.growth()?.iter().map(|l| l.divided(2)).collect()))
    }
    fn exp(&self) -> Self {
        Self::growing(self.value().exp(), self.slopes())
    }
    fn ln(&self) -> Option<Self> {
        Some(Self::integral(self.value().ln()?, &self.growth()?))
    }
    fn sin_cos(&self) -> (Self, Self) {
        self.rotated(self.value().sin_cos(), -1)
    }
    fn sinh_cosh(&self) -> (Self, Self) {
        self.rotated(self.value().sinh_cosh(), 1)
    }
    fn atan(&self) -> Option<Self> {
        let one = self.integer(1);
        self.chained(self.value().atan()?, one.quotient(&one.plus(&self.squared())))
    }
    fn asin(&self) -> Option<Self> {
        let one = self.integer(1);
        self.chained(self.value().asin()?, one.quotient(&one.minus(&self.squared()).sqrt()?))
    }
    fn atanh(&self) -> Option<Self> {
        let one = self.integer(1);
        self.chained(self.value().atanh()?, one.quotient(&one.minus(&self.squared())))
    }
    fn is_bounded(&self) -> bool {
        self.coefficients.iter().all(T::is_bounded)
    }
    fn side(&self) -> Option<Ordering> {
        self.value().side()
    }
    fn is_small(&self) -> bool {
        self.value().is_small()
    }
    fn half_turn(&self) -> Self {
        self.whole(self.value().half_turn())
    }
    fn integer(&self, value: i64) -> Self {
        self.whole(self.value().integer(value))
    }
}
