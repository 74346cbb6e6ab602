//! Complex rectangles. Every function refuses an argument that meets its branch cut.

use std::cmp::Ordering;

use super::{Analytic, Ends};
use crate::number::{Interval, Real};

/// A rectangle in the complex plane: all x + iy with x and y in two intervals of one precision, or two of doubles.
///
/// ```
/// use mdr_core::number::{Analytic, Interval, Precision, Real, Rectangle};
/// let number = |value| Interval::from_f64(Precision::new(64), value);
/// let i = Rectangle::new(number(0.0), number(1.0));
/// let square = i.squared();
/// assert!(square.re().contains(number(-1.0).lower()) && square.im().contains_zero());
/// // e^(iπ/2) = i
/// let turn = i.scaled(&number(1.0).pi().over(2)).exp();
/// assert!(turn.re().contains_zero() && turn.im().contains(number(1.0).lower()));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Rectangle<I = Interval> {
    re: I,
    im: I,
}

impl<I: Ends> Rectangle<I> {
    /// The rectangle of a real and an imaginary part.
    pub fn new(re: I, im: I) -> Self {
        Rectangle { re, im }
    }

    /// The real parts.
    pub fn re(&self) -> &I {
        &self.re
    }

    /// The imaginary parts.
    pub fn im(&self) -> &I {
        &self.im
    }

    /// Whether it is free of the negative real axis and of 0.
    fn is_off_cut(&self) -> bool {
        let [lower, upper] = self.im.signs();
        self.re.signs()[0].is_gt() || lower.is_gt() || upper.is_lt()
    }

    /// Whether it lies in the closed right half-plane. There a root is analytic inside and continuous up to the boundary: what maps
    /// into it maps the inside of a set to the open half-plane, or is constant.
    fn is_right(&self) -> bool {
        self.re.signs()[0].is_ge()
    }

    /// zᵖ for p > 0 where 0 is on the boundary: |z|ᵖ, at an angle of pπ/2 at most.
    fn power_from_zero(&self, exponent: &I) -> Option<Self> {
        let [_, size] = Real::pow(&self.modulus(), exponent).ends();
        if !Real::is_finite(&size) {
            return None;
        }
        let zero = size.lit(0);
        let far = zero.clone().inflate(&size);
        let is_root = *exponent <= exponent.lit(1);
        Some(Rectangle { re: if is_root { zero.hull(&size) } else { far.clone() }, im: far })
    }

    /// The boundary, without the real axis, of the rectangle and its conjugate together: that of its upper half in pieces.
    fn upper_boundary(&self) -> Vec<Self> {
        let far = self.im.abs().ends()[1].clone();
        let [left, right] = self.re.ends();
        let zero = far.lit(0);
        let top = pieces(&left, &right, PIECES_OF_BOUNDARY).into_iter().map(|re| Rectangle { re, im: far.clone() });
        let sides = pieces(&zero, &far, PIECES_OF_BOUNDARY / 2);
        let at = |re: &I| sides.iter().map(|im| Rectangle { re: re.clone(), im: im.clone() }).collect::<Vec<_>>();
        top.chain(at(&left)).chain(at(&right)).collect()
    }

    /// The smallest rectangle that contains both, and their conjugates.
    fn hull_with_conjugates(&self, other: &Self) -> Self {
        let im = self.im.hull(&other.im);
        Rectangle { re: self.re.hull(&other.re), im: im.hull(&-im.clone()) }
    }

    /// iz.
    fn turned(&self) -> Self {
        Rectangle { re: -self.im.clone(), im: self.re.clone() }
    }

    /// The modulus.
    fn modulus(&self) -> I {
        self.re.abs().hypot(&self.im.abs())
    }

    /// The argument between −π and π, off the cut: its extremes are at corners.
    fn argument(&self) -> I {
        let ([low, high], [left, right]) = (self.im.ends(), self.re.ends());
        let at = |y: &I| y.angle(&left).hull(&y.angle(&right));
        at(&low).hull(&at(&high))
    }
}

/// Pieces into which the longer side of a boundary is cut.
const PIECES_OF_BOUNDARY: i64 = 8;

/// Enclosures of the parts between two numbers, of one length.
fn pieces<I: Ends>(from: &I, to: &I, count: i64) -> Vec<I> {
    let length = to.clone() - from;
    let places: Vec<I> = (1..count).map(|k| length.clone().times(k).over(count) + from).chain([to.clone()]).collect();
    let before = std::iter::once(from).chain(&places);
    before.zip(&places).map(|(one, other)| one.hull(other)).collect()
}

/// The least number ≥ 0 and the greatest that √((|z| ± x)/2) takes at x + iy: the real part of √z for +, |imaginary part|
/// for −. Where |z| and ±x cancel, as y²/2(|z| ∓ x).
fn part<I: Ends>(x: &I, y: &I, imaginary: bool) -> I {
    let modulus = Rectangle { re: x.clone(), im: y.clone() }.modulus();
    let x = if imaginary { -x.clone() } else { x.clone() };
    let twice = if x.signs()[0] != Ordering::Less {
        modulus + x
    } else {
        y.square().quotient(&(modulus - x)).unwrap_or_else(|| y.lit(0))
    };
    Real::sqrt(&twice.over(2))
}

impl<I: Ends> Analytic for Rectangle<I> {
    const WORK: u64 = 4 * <I as Ends>::WORK;
    type Complex = Self;

    fn bits(&self) -> u32 {
        self.re.bits()
    }
    fn constant(&self, value: &Interval) -> Self {
        Rectangle { re: self.re.constant(value), im: self.im.lit(0) }
    }
    fn plus(&self, other: &Self) -> Self {
        Rectangle { re: self.re.plus(&other.re), im: self.im.plus(&other.im) }
    }
    fn minus(&self, other: &Self) -> Self {
        Rectangle { re: self.re.minus(&other.re), im: self.im.minus(&other.im) }
    }
    fn product(&self, other: &Self) -> Self {
        Rectangle {
            re: self.re.product(&other.re) - self.im.product(&other.im),
            im: self.re.product(&other.im) + self.im.product(&other.re),
        }
    }
    fn scaled(&self, factor: &Interval) -> Self {
        let factor = self.re.constant(factor);
        Rectangle { re: self.re.product(&factor), im: self.im.product(&factor) }
    }
    fn squared(&self) -> Self {
        Rectangle { re: self.re.square() - self.im.square(), im: Real::times(self.re.product(&self.im), 2) }
    }
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        let square = divisor.re.square() + divisor.im.square();
        let product = self.product(&Rectangle { re: divisor.re.clone(), im: -divisor.im.clone() });
        Some(Rectangle { re: product.re.quotient(&square)?, im: product.im.quotient(&square)? })
    }
    fn power(&self, exponent: &Interval) -> Option<Self> {
        if !self.is_off_cut() && self.is_right() && *exponent.lower() > 0 {
            return self.power_from_zero(&self.re.constant(exponent));
        }
        Some(self.ln()?.scaled(exponent).exp())
    }
    /// Both parts of √z are monotone in x and in |y|: their extremes are at corners.
    fn sqrt(&self) -> Option<Self> {
        if !self.is_off_cut() && !self.is_right() {
            return None;
        }
        let ([left, right], [low, high]) = (self.re.ends(), self.im.ends());
        let [near, far] = self.im.abs().ends();
        let re = part(&left, &near, false).hull(&part(&right, &far, false));
        let (outer, inner) = (|y: &I| part(&left, y, true), |y: &I| part(&right, y, true));
        let im = match self.im.signs() {
            [Ordering::Greater | Ordering::Equal, _] => inner(&low).hull(&outer(&high)),
            [_, Ordering::Less | Ordering::Equal] => -inner(&high).hull(&outer(&low)),
            _ => (-outer(&low)).hull(&outer(&high)),
        };
        Some(Rectangle { re, im })
    }
    fn exp(&self) -> Self {
        let (size, (sin, cos)) = (Real::exp(&self.re), self.im.sin_cos());
        Rectangle { re: size.product(&cos), im: size.product(&sin) }
    }
    fn ln(&self) -> Option<Self> {
        if !self.is_off_cut() {
            return None;
        }
        Some(Rectangle { re: Analytic::ln(&self.modulus())?, im: self.argument() })
    }
    fn sin_cos(&self) -> (Self, Self) {
        let ((sin, cos), (sinh, cosh)) = (self.re.sin_cos(), self.im.sinh_cosh());
        (
            Rectangle { re: sin.product(&cosh), im: cos.product(&sinh) },
            Rectangle { re: cos.product(&cosh), im: -sin.product(&sinh) },
        )
    }
    fn sinh_cosh(&self) -> (Self, Self) {
        let ((sin, cos), (sinh, cosh)) = (self.im.sin_cos(), self.re.sinh_cosh());
        (
            Rectangle { re: sinh.product(&cos), im: cosh.product(&sin) },
            Rectangle { re: cosh.product(&cos), im: sinh.product(&sin) },
        )
    }
    /// −i artanh(iz).
    fn atan(&self) -> Option<Self> {
        let Rectangle { re, im } = self.turned().atanh()?;
        Some(Rectangle { re: im, im: -re })
    }
    /// 2 arctan(z/(1 + √(1 − z²))), whose argument lies in the unit disc.
    fn asin(&self) -> Option<Self> {
        let one = self.integer(1);
        let root = one.minus(&self.squared()).sqrt()?;
        Some(self.quotient(&one.plus(&root))?.atan()?.multiplied(2))
    }
    /// (ln(1 + z) − ln(1 − z))/2.
    fn atanh(&self) -> Option<Self> {
        let one = self.integer(1);
        let twice = one.plus(self).ln()?.minus(&one.minus(self).ln()?);
        Some(twice.divided(2))
    }
    fn is_bounded(&self) -> bool {
        self.re.is_bounded() && self.im.is_bounded()
    }
    fn side(&self) -> Option<Ordering> {
        self.re.side()
    }
    fn is_small(&self) -> bool {
        self.re.is_small() && self.im.is_small()
    }
    fn by_boundary(
        &self,
        is_analytic: impl Fn(&Self) -> bool,
        values: impl Fn(&Self) -> Option<Vec<Self>>,
    ) -> Option<Vec<Self>> {
        if !(self.re.has_zero() && self.im.has_zero() && is_analytic(self)) {
            return None;
        }
        let mut edges = self.upper_boundary().into_iter().map(|edge| values(&edge));
        let first = edges.next()??;
        edges.try_fold(first, |hull, values| {
            Some(hull.iter().zip(&values?).map(|(one, other)| one.hull_with_conjugates(other)).collect())
        })
    }
    fn integer(&self, value: i64) -> Self {
        Rectangle { re: self.re.lit(value), im: self.im.lit(0) }
    }
    fn half_turn(&self) -> Self {
        Rectangle { re: self.re.pi(), im: self.im.lit(0) }
    }
    fn multiplied(&self, k: i64) -> Self {
        Rectangle { re: self.re.multiplied(k), im: self.im.multiplied(k) }
    }
    fn divided(&self, k: i64) -> Self {
        Rectangle { re: self.re.divided(k), im: self.im.divided(k) }
    }
    fn negated(&self) -> Self {
        Rectangle { re: -self.re.clone(), im: -self.im.clone() }
    }
}
