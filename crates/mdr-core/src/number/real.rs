//! The trait in which every formula of the workspace is written.

use std::cmp::Ordering;
use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::Inv;

use super::Literal;

/// A real number in some arithmetic: hardware, arbitrary precision, rigorous enclosure, or any of these with
/// derivatives.
///
/// * A value carries its precision. Inside a formula, constants come from a value ([`lit`](Real::lit),
///   [`ratio`](Real::ratio), [`pi`](Real::pi), [`times`](Real::times), [`over`](Real::over)), never from a literal
///   `f64`: there is deliberately no `Mul<f64>` for generic numbers. The context [`Ctx`](Real::Ctx) appears only where
///   numbers are created.
/// * All inputs of one computation come from one context.
/// * The operations are total, as in IEEE 754: outside its domain a function returns a value that is not
///   [finite](Real::is_finite). Public functions check domains first and return an [`Error`](crate::contact::Error)
///   with the quantity.
/// * Comparison is partial. An interval compares only when the answer is *certain*; a dual number compares by its value.
///
/// ```
/// use mdr_core::number::Real;
/// fn circle_area<R: Real>(radius: &R) -> R {
///     radius.square() * radius.pi()
/// }
/// assert_eq!(circle_area(&2.0_f64), 4.0 * std::f64::consts::PI);
/// ```
pub trait Real:
    Clone
    + Debug
    + PartialOrd
    + Send
    + Sync
    + 'static
    + Inv<Output = Self>
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + for<'a> Add<&'a Self, Output = Self>
    + for<'a> Sub<&'a Self, Output = Self>
    + for<'a> Mul<&'a Self, Output = Self>
    + for<'a> Div<&'a Self, Output = Self>
    + for<'a> AddAssign<&'a Self>
    + for<'a> SubAssign<&'a Self>
    + for<'a> MulAssign<&'a Self>
    + for<'a> DivAssign<&'a Self>
{
    /// The context for creating a number: nothing for `f64`, a precision in bits otherwise.
    type Ctx: Copy + Debug + PartialEq + Send + Sync + 'static;

    /// The context of this value.
    fn ctx(&self) -> Self::Ctx;

    /// The integer `value`.
    fn from_int(ctx: Self::Ctx, value: i64) -> Self;

    /// The exact value of a finite `f64`, rounded if the precision is too small.
    fn from_f64(ctx: Self::Ctx, value: f64) -> Self;

    /// An exact literal: nearest for a floating type, the tightest enclosure for an interval.
    fn from_literal(ctx: Self::Ctx, literal: &Literal) -> Self;

    /// The integer `value` in the precision of `self`.
    #[inline]
    fn lit(&self, value: i64) -> Self {
        Self::from_int(self.ctx(), value)
    }

    /// Whether it is certainly this integer.
    #[inline]
    fn is_integer(&self, value: i64) -> bool {
        *self == self.lit(value)
    }

    /// Whether it is certainly zero; a dual number, with a slope that is.
    #[inline]
    fn vanishes(&self) -> bool {
        self.is_integer(0)
    }

    /// The fraction `numerator/denominator` in the precision of `self`.
    fn ratio(&self, numerator: i64, denominator: i64) -> Self {
        self.lit(numerator).over(denominator)
    }

    /// π in the precision of `self`.
    fn pi(&self) -> Self;

    /// `self · k`.
    fn times(self, k: i64) -> Self;

    /// `self / k`.
    fn over(self, k: i64) -> Self;

    /// |self|.
    fn abs(&self) -> Self;

    /// self², which for an interval is tighter than `self * self`.
    fn square(&self) -> Self;

    /// √self, for self ≥ 0.
    fn sqrt(&self) -> Self;

    /// e^self.
    fn exp(&self) -> Self;

    /// e^self − 1 without cancellation near 0.
    fn exp_m1(&self) -> Self;

    /// ln self, for self > 0.
    fn ln(&self) -> Self;

    /// ln(1 + self) without cancellation near 0, for self > −1.
    fn ln_1p(&self) -> Self;

    /// self^exponent, for self > 0 (or self = 0 and exponent > 0).
    fn pow(&self, exponent: &Self) -> Self;

    /// self^exponent − 1 without cancellation near 1, for self > 0.
    fn pow_m1(&self, exponent: &Self) -> Self {
        (self.ln() * exponent).exp_m1()
    }

    /// self^exponent for an integer exponent.
    fn powi(&self, exponent: i64) -> Self;

    /// Bits in the significand.
    fn precision(&self) -> u32;

    /// The unit roundoff 2^−precision.
    fn unit_roundoff(&self) -> Self;

    /// The nearest double (midpoint of an interval, value of a dual). ±∞ or 0 when out of range.
    fn approx(&self) -> f64;

    /// Whether the value is a number (for an interval: both ends).
    fn is_finite(&self) -> bool;

    /// `self` after a truncation with an error of at most |bound|: an interval grows by it on both sides; other
    /// arithmetics, which guarantee no error bound, return `self`.
    fn inflate(self, _bound: &Self) -> Self {
        self
    }

    /// `self` after a truncation whose error and derivative of the error are at most |bound| and |bound'|: a dual number over
    /// intervals keeps its slope, widened by that of the bound. See also [`inflate`](Real::inflate).
    fn inflate_with_slope(self, bound: &Self) -> Self {
        self.inflate(bound)
    }

    /// The greater of two numbers; for intervals an enclosure of the greater of every pair, even if their order is
    /// uncertain.
    fn greater(&self, other: &Self) -> Self {
        match self.partial_cmp(other) {
            Some(Ordering::Less) => other.clone(),
            Some(_) => self.clone(),
            None => self.either(other),
        }
    }

    /// The lesser of two numbers, likewise.
    fn lesser(&self, other: &Self) -> Self {
        -(-self.clone()).greater(&-other.clone())
    }

    /// An enclosure of both numbers, where the arithmetic has enclosures: their mean ± half their difference.
    fn either(&self, other: &Self) -> Self {
        let half = [self, other].map(|number| number.clone().over(2));
        let [mean, spread] = [half[0].clone() + &half[1], half[0].clone() - &half[1]];
        mean.inflate(&spread)
    }

    /// A representative point for control flow (pivots, brackets, stopping): the value of a floating type, the midpoint
    /// of an interval as a point, a dual number without its slope. Never enters a result.
    fn midpoint(&self) -> Self {
        self.clone()
    }
}

/// The order of numbers by their [representative points](Real::midpoint), which exists even for overlapping enclosures.
///
/// ```
/// let mut radii = [3.0, 1.0, 2.0];
/// radii.sort_by(mdr_core::number::order);
/// assert_eq!(radii, [1.0, 2.0, 3.0]);
/// ```
pub fn order<R: Real>(x: &R, y: &R) -> Ordering {
    x.midpoint().partial_cmp(&y.midpoint()).unwrap_or(Ordering::Equal)
}

/// The functions beyond algebra, exponential and natural logarithm: circular, hyperbolic, decimal logarithm.
pub trait Special: Real {
    /// sin self.
    fn sin(&self) -> Self;
    /// cos self.
    fn cos(&self) -> Self;
    /// [sin](Special::sin) and [cos](Special::cos) at once: the same two numbers, and in doubles for little more than one of them costs.
    #[inline]
    fn sin_and_cos(&self) -> (Self, Self) {
        (self.sin(), self.cos())
    }
    /// arctan self.
    fn atan(&self) -> Self;
    /// arcsin self, for |self| ≤ 1.
    fn asin(&self) -> Self;
    /// arccos self, for |self| ≤ 1.
    fn acos(&self) -> Self;
    /// sinh self.
    fn sinh(&self) -> Self;
    /// cosh self.
    fn cosh(&self) -> Self;
    /// tanh self.
    fn tanh(&self) -> Self;
    /// artanh self, for |self| < 1.
    fn atanh(&self) -> Self;
    /// log₁₀ self, for self > 0.
    fn log10(&self) -> Self {
        self.ln() / self.lit(10).ln()
    }
}

/// The Gamma family. Not available for duals: its second derivative would need the trigamma function.
pub trait Gamma: Real {
    /// Γ(self), for self > 0.
    fn gamma(&self) -> Self;
    /// ln Γ(self), for self > 0.
    fn ln_gamma(&self) -> Self;
    /// ψ(self) = Γ'(self)/Γ(self), for self > 0.
    fn digamma(&self) -> Self;
}

/// Numbers that can represent a value of `R` as a constant: `R` itself, and `R` with derivatives.
///
/// A profile is written once as `fn height<S: Lift<R>>(&self, r: &S) -> S`; its parameters are lifted, and
/// [`Dual`](super::Dual) then differentiates it.
pub trait Lift<R: Real>: Special {
    /// `constant` as a number of this kind with zero derivatives.
    fn lift(constant: &R) -> Self;

    /// The number without its derivatives.
    fn value_of(&self) -> R;
}

impl<R: Special> Lift<R> for R {
    fn lift(constant: &R) -> Self {
        constant.clone()
    }

    fn value_of(&self) -> R {
        self.clone()
    }
}
