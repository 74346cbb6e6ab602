//! Complex rectangles. Every function refuses an argument that meets its branch cut.

use rug::Float;
use rug::float::Round;

use super::{Analytic, defined};
use crate::number::{Interval, Precision, Real};

/// A rectangle in the complex plane: all x + iy with x and y in two intervals of one precision.
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
#[derive(Clone, Debug)]
pub struct Rectangle {
    re: Interval,
    im: Interval,
}

impl Rectangle {
    /// The rectangle of a real and an imaginary part.
    pub fn new(re: Interval, im: Interval) -> Self {
        Rectangle { re, im }
    }

    /// The real parts.
    pub fn re(&self) -> &Interval {
        &self.re
    }

    /// The imaginary parts.
    pub fn im(&self) -> &Interval {
        &self.im
    }

    fn ctx(&self) -> Precision {
        self.re.ctx()
    }

    /// Whether it is free of the negative real axis and of 0.
    fn is_off_cut(&self) -> bool {
        *self.re.lower() > 0 || *self.im.lower() > 0 || *self.im.upper() < 0
    }

    /// Whether it lies in the closed right half-plane. There a root is analytic inside and continuous up to the boundary: what maps
    /// into it maps the inside of a set to the open half-plane, or is constant.
    fn is_right(&self) -> bool {
        *self.re.lower() >= 0
    }

    /// zᵖ for p > 0 where 0 is on the boundary: |z|ᵖ, at an angle of pπ/2 at most.
    fn power_from_zero(&self, exponent: &Interval) -> Option<Self> {
        let size = defined(self.modulus().pow(&exponent.rounded(self.ctx())))?;
        let zero = Interval::from_int(self.ctx(), 0);
        let far = zero.clone().inflate(&Interval::point(size.upper().clone()));
        let re = if *exponent.upper() <= 1 { zero.hull(&Interval::point(size.upper().clone())) } else { far.clone() };
        Some(Rectangle { re, im: far })
    }

    /// iz.
    fn turned(&self) -> Self {
        Rectangle { re: -self.im.clone(), im: self.re.clone() }
    }

    /// The modulus.
    fn modulus(&self) -> Interval {
        let bits = self.bits();
        let (re, im) = (self.re.abs(), self.im.abs());
        let hypot = |x: &Float, y: &Float, round| Float::with_val_round(bits, x.hypot_ref(y), round).0;
        Interval::new(hypot(re.lower(), im.lower(), Round::Down), hypot(re.upper(), im.upper(), Round::Up))
    }

    /// The argument between −π and π, off the cut: its extremes are at corners.
    fn argument(&self) -> Interval {
        let angle = |y: &Float, x: &Float, round| Float::with_val_round(self.bits(), y.atan2_ref(x), round).0;
        let corner = |y: &Float, x: &Float| Interval::new(angle(y, x, Round::Down), angle(y, x, Round::Up));
        let ends = [self.im.lower(), self.im.upper()];
        let first = corner(ends[0], self.re.lower());
        ends.iter().fold(first, |hull, y| hull.hull(&corner(y, self.re.lower())).hull(&corner(y, self.re.upper())))
    }
}

/// The least number ≥ 0 and the greatest that √((|z| ± x)/2) takes at x + iy: the real part of √z for +, |imaginary part|
/// for −. Where |z| and ±x cancel, as y²/2(|z| ∓ x).
fn part(x: &Float, y: &Float, imaginary: bool) -> Interval {
    let bits = x.prec();
    let [x, y] = [x, y].map(|end| Interval::point(end.clone()));
    let modulus = Rectangle { re: x.clone(), im: y.clone() }.modulus();
    let x = if imaginary { -x } else { x };
    let twice = if *x.lower() >= 0 {
        modulus + x
    } else {
        y.square().quotient(&(modulus - x)).unwrap_or_else(|| Interval::from_int(Precision::new(bits), 0))
    };
    Real::sqrt(&Real::over(twice, 2))
}

impl Analytic for Rectangle {
    const WORK: u64 = 4;

    fn bits(&self) -> u32 {
        self.re.bits()
    }
    fn constant(&self, value: &Interval) -> Self {
        Rectangle { re: value.rounded(self.ctx()), im: Interval::from_int(self.ctx(), 0) }
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
        Rectangle { re: self.re.product(factor), im: self.im.product(factor) }
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
            return self.power_from_zero(exponent);
        }
        Some(self.ln()?.scaled(exponent).exp())
    }
    /// Both parts of √z are monotone in x and in |y|: their extremes are at corners.
    fn sqrt(&self) -> Option<Self> {
        if !self.is_off_cut() && !self.is_right() {
            return None;
        }
        let (x, y, far) = (&self.re, &self.im, self.im.abs());
        let re = part(x.lower(), far.lower(), false).hull(&part(x.upper(), far.upper(), false));
        let outer = |y: &Float| part(x.lower(), y, true);
        let inner = |y: &Float| part(x.upper(), y, true);
        let im = if *y.lower() >= 0 {
            inner(y.lower()).hull(&outer(y.upper()))
        } else if *y.upper() <= 0 {
            -inner(y.upper()).hull(&outer(y.lower()))
        } else {
            (-outer(y.lower())).hull(&outer(y.upper()))
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
        Some(Rectangle { re: defined(Real::ln(&self.modulus()))?, im: self.argument() })
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
        Some(self.quotient(&one.plus(&root))?.atan()?.scaled(&Interval::from_int(self.ctx(), 2)))
    }
    /// (ln(1 + z) − ln(1 − z))/2.
    fn atanh(&self) -> Option<Self> {
        let one = self.integer(1);
        let twice = one.plus(self).ln()?.minus(&one.minus(self).ln()?);
        Some(Rectangle { re: Real::over(twice.re, 2), im: Real::over(twice.im, 2) })
    }
    fn is_bounded(&self) -> bool {
        self.re.is_bounded() && self.im.is_bounded()
    }
}
