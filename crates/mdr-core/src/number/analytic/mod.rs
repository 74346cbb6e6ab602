//! Functions over sets of numbers, with the question whether they are analytic there.

mod ends;
mod euler;
mod near_zero;
mod rectangle;

pub use ends::Ends;
pub use euler::Euler;
pub use near_zero::NearZero;
pub use rectangle::Rectangle;

use std::cmp::Ordering;

use super::{Interval, Precision, Real};

/// A set of numbers on which a formula is evaluated: an [`Interval`], a [`DoubleInterval`](super::DoubleInterval), a complex
/// [`Rectangle`] of either, or one of these with derivatives, [`Euler`].
///
/// `None` means that the function is not defined on all of the set, or not shown to be analytic there: a root or a logarithm
/// whose argument meets its cut, a divisor that may be zero, an overflow. Over real intervals a result proves that the
/// function is defined and continuous; over rectangles, that it is analytic inside and continuous up to the boundary, where a root
/// may be zero. A result has the precision of `self`.
///
/// ```
/// use mdr_core::number::{Analytic, Interval, Precision, Real, Rectangle};
/// let bits = Precision::new(64);
/// let [one, two] = [1, 2].map(|k| Interval::from_int(bits, k));
/// // √z is analytic on [1, 2] + i[1, 2], and not on a rectangle around 0.
/// let away = Rectangle::new(one.hull(&two), one.hull(&two));
/// assert!(away.sqrt().is_some());
/// let around = (-one.clone()).hull(&one);
/// assert!(Rectangle::new(around.clone(), around).sqrt().is_none());
/// ```
pub trait Analytic: Clone {
    /// The time that a formula takes over such a set, over its time on an interval of doubles, as budgets count it: to within a factor of
    /// two.
    const WORK: u64;
    /// The complex sets of such numbers.
    type Complex: Analytic;
    /// Bits in the significand.
    fn bits(&self) -> u32;
    /// A real constant.
    fn constant(&self, value: &Interval) -> Self;
    /// The sum.
    fn plus(&self, other: &Self) -> Self;
    /// The difference.
    fn minus(&self, other: &Self) -> Self;
    /// The product.
    fn product(&self, other: &Self) -> Self;
    /// The product with a real constant.
    fn scaled(&self, factor: &Interval) -> Self;
    /// The square, which may be tighter than the product with itself.
    fn squared(&self) -> Self;
    /// The quotient.
    fn quotient(&self, divisor: &Self) -> Option<Self>;
    /// An integer power.
    fn raised(&self, exponent: i64) -> Option<Self> {
        self.raised_by_squaring(exponent)
    }
    /// The power x^y = e^(y ln x) with a real constant exponent.
    fn power(&self, exponent: &Interval) -> Option<Self>;
    /// The square root.
    fn sqrt(&self) -> Option<Self>;
    /// e^x.
    fn exp(&self) -> Self;
    /// The natural logarithm.
    fn ln(&self) -> Option<Self>;
    /// The sine and the cosine.
    fn sin_cos(&self) -> (Self, Self);
    /// The hyperbolic sine and cosine.
    fn sinh_cosh(&self) -> (Self, Self);
    /// tanh x: as (1 − e)/(1 + e) with e = exp(−2|x|), which does not overflow, and as sinh x/cosh x where x may have both signs or is small.
    fn tanh(&self) -> Option<Self> {
        match self.side() {
            Some(Ordering::Less) if !self.is_small() => Some(self.negated().tanh()?.negated()),
            Some(_) if !self.is_small() => {
                let (one, e) = (self.integer(1), self.multiplied(-2).exp());
                one.minus(&e).quotient(&one.plus(&e))
            }
            _ => {
                let (sinh, cosh) = self.sinh_cosh();
                sinh.quotient(&cosh)
            }
        }
    }
    /// arctan x.
    fn atan(&self) -> Option<Self>;
    /// arcsin x.
    fn asin(&self) -> Option<Self>;
    /// artanh x.
    fn atanh(&self) -> Option<Self>;
    /// Whether both ends of every part are numbers.
    fn is_bounded(&self) -> bool;
    /// The side of 0 on which all real parts lie, with 0 on both of them; `None` where they have both signs.
    fn side(&self) -> Option<Ordering>;
    /// Whether every part is certainly within (−1/2, 1/2).
    fn is_small(&self) -> bool;
    /// max(0, x) over a real set. A complex set is its own: what is x beyond 0 is continued.
    fn positive_part(&self) -> Self {
        self.clone()
    }

    /// Enclosures over a set that may hold 0 of functions which take conjugate values at conjugate points: from their `values` on the boundary
    /// of a complex set around it, by the maximum principle for real and imaginary parts. On that set and its conjugate together they must be
    /// analytic, which `is_analytic` is asked. `None` where it is not, where a value is `None`, and of a set without 0.
    fn by_boundary(
        &self,
        _is_analytic: impl Fn(&Self::Complex) -> bool,
        _values: impl Fn(&Self::Complex) -> Option<Vec<Self::Complex>>,
    ) -> Option<Vec<Self>> {
        None
    }

    /// All numbers of a real interval that begins at 0, but for that; `None` of other sets, and of an interval beyond 1.
    fn beside_zero(&self) -> Option<NearZero<Self>> {
        None
    }

    /// An integer.
    fn integer(&self, value: i64) -> Self {
        self.constant(&Interval::from_int(Precision::new(self.bits()), value))
    }
    /// An integer power by squares and products, with its parts [raised](Analytic::raised).
    fn raised_by_squaring(&self, exponent: i64) -> Option<Self> {
        match exponent {
            0 => Some(self.integer(1)),
            1 => Some(self.clone()),
            n if n < 0 => self.integer(1).quotient(&self.raised(n.checked_neg()?)?),
            n if n % 2 == 0 => Some(self.raised(n / 2)?.squared()),
            n => Some(self.raised(n - 1)?.product(self)),
        }
    }
    /// π.
    fn half_turn(&self) -> Self {
        self.constant(&Interval::from_int(Precision::new(self.bits()), 1).pi())
    }
    /// The product with an integer.
    fn multiplied(&self, k: i64) -> Self {
        self.scaled(&Interval::from_int(Precision::new(self.bits()), k))
    }
    /// The quotient by an integer other than zero.
    fn divided(&self, k: i64) -> Self {
        self.scaled(&Real::over(Interval::from_int(Precision::new(self.bits()), 1), k))
    }
    /// −x.
    fn negated(&self) -> Self {
        self.multiplied(-1)
    }
}
