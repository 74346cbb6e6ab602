//! Forward derivatives: a value and its slope.

use std::cmp::Ordering;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::Inv;

use super::{Lift, Literal, Real, Special};

/// A value together with its derivative with respect to one variable, over any [`Real`].
///
/// Nest it for higher derivatives. Comparisons use the value alone, so control flow never depends on the derivative.
///
/// ```
/// use mdr_core::number::{Dual, Real};
/// // f(r) = r³ at r = 2: f = 8, f' = 12, f'' = 12.
/// let r = Dual::variable(Dual::variable(2.0));
/// let f = r.powi(3);
/// assert_eq!((f.value.value, f.slope.value, f.slope.slope), (8.0, 12.0, 12.0));
/// ```
#[derive(Clone, Debug)]
pub struct Dual<R> {
    /// The value.
    pub value: R,
    /// Its derivative.
    pub slope: R,
}

/// The argument from which on tanh is differentiated without a cosh, whose square overflows in doubles above 355.
const FAR: f64 = 300.0;

impl<R: Real> Dual<R> {
    /// The independent variable at `value`: slope one.
    #[inline]
    pub fn variable(value: R) -> Self {
        let slope = value.lit(1);
        Dual { value, slope }
    }

    /// A constant: slope zero.
    #[inline]
    pub fn constant(value: R) -> Self {
        let slope = value.lit(0);
        Dual { value, slope }
    }

    /// A function of this number, from its value and its derivative there (the chain rule).
    #[inline]
    pub fn chain(&self, value: R, derivative: R) -> Self {
        Dual { value, slope: derivative * &self.slope }
    }
}

impl<R: Special> Lift<R> for Dual<R> {
    #[inline]
    fn lift(constant: &R) -> Self {
        Dual::constant(constant.clone())
    }

    #[inline]
    fn value_of(&self) -> R {
        self.value.clone()
    }
}

impl<R: Special> Lift<R> for Dual<Dual<R>> {
    #[inline]
    fn lift(constant: &R) -> Self {
        Dual::constant(Dual::constant(constant.clone()))
    }

    #[inline]
    fn value_of(&self) -> R {
        self.value.value.clone()
    }
}

impl<R: Real> PartialEq for Dual<R> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<R: Real> PartialOrd for Dual<R> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl<R: Real> Neg for Dual<R> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Dual { value: -self.value, slope: -self.slope }
    }
}

impl<R: Real> Inv for Dual<R> {
    type Output = Self;
    fn inv(self) -> Self {
        let value = self.value.inv();
        let slope = -(value.square() * &self.slope);
        Dual { value, slope }
    }
}

impl<R: Real> AddAssign<&Self> for Dual<R> {
    #[inline]
    fn add_assign(&mut self, other: &Self) {
        self.value += &other.value;
        if !other.slope.vanishes() {
            self.slope += &other.slope;
        }
    }
}

impl<R: Real> SubAssign<&Self> for Dual<R> {
    #[inline]
    fn sub_assign(&mut self, other: &Self) {
        self.value -= &other.value;
        if !other.slope.vanishes() {
            self.slope -= &other.slope;
        }
    }
}

impl<R: Real> MulAssign<&Self> for Dual<R> {
    /// A constant factor scales the slope, and two constants have none: fewer products, and none of zero with what is out of range.
    #[inline]
    fn mul_assign(&mut self, other: &Self) {
        if !self.slope.vanishes() {
            self.slope *= &other.value;
        }
        if !other.slope.vanishes() {
            self.slope += &(self.value.clone() * &other.slope);
        }
        self.value *= &other.value;
    }
}

impl<R: Real> DivAssign<&Self> for Dual<R> {
    #[inline]
    fn div_assign(&mut self, other: &Self) {
        self.value /= &other.value;
        if !other.slope.vanishes() {
            self.slope -= &(self.value.clone() * &other.slope);
        }
        if !self.slope.vanishes() {
            self.slope /= &other.value;
        }
    }
}

operators_from_assigning! { [R: Real] Dual<R> }

impl<R: Real> Real for Dual<R> {
    type Ctx = R::Ctx;

    #[inline]
    fn ctx(&self) -> R::Ctx {
        self.value.ctx()
    }
    #[inline]
    fn from_int(ctx: R::Ctx, value: i64) -> Self {
        Dual::constant(R::from_int(ctx, value))
    }
    fn from_f64(ctx: R::Ctx, value: f64) -> Self {
        Dual::constant(R::from_f64(ctx, value))
    }
    fn from_literal(ctx: R::Ctx, literal: &Literal) -> Self {
        Dual::constant(R::from_literal(ctx, literal))
    }
    #[inline]
    fn vanishes(&self) -> bool {
        self.value.vanishes() && self.slope.vanishes()
    }
    fn pi(&self) -> Self {
        Dual::constant(self.value.pi())
    }
    #[inline]
    fn times(self, k: i64) -> Self {
        Dual { value: self.value.times(k), slope: self.slope.times(k) }
    }
    #[inline]
    fn over(self, k: i64) -> Self {
        Dual { value: self.value.over(k), slope: self.slope.over(k) }
    }
    fn abs(&self) -> Self {
        let zero = self.value.lit(0);
        if self.value < zero {
            -self.clone()
        } else if self.value >= zero {
            self.clone()
        } else {
            // The interval contains the kink, so the sign of the slope is unknown.
            let value = self.value.abs();
            let sign = self.value.clone() / &value;
            self.chain(value, sign)
        }
    }
    #[inline]
    fn square(&self) -> Self {
        self.chain(self.value.square(), self.value.clone().times(2))
    }
    #[inline]
    fn sqrt(&self) -> Self {
        let root = self.value.sqrt();
        let derivative = root.clone().times(2).inv();
        self.chain(root, derivative)
    }
    fn exp(&self) -> Self {
        let value = self.value.exp();
        self.chain(value.clone(), value)
    }
    fn exp_m1(&self) -> Self {
        self.chain(self.value.exp_m1(), self.value.exp())
    }
    fn ln(&self) -> Self {
        self.chain(self.value.ln(), self.value.clone().inv())
    }
    fn ln_1p(&self) -> Self {
        self.chain(self.value.ln_1p(), (self.value.lit(1) + &self.value).inv())
    }
    fn pow(&self, exponent: &Self) -> Self {
        // d(x^y) = x^y (y dx/x + ln x dy): one power, and no x^(y−1) that could leave the range unless x^y does. The
        // second term is evaluated only where y varies.
        let value = self.value.pow(&exponent.value);
        let vanishes = (value.unit_roundoff() * &value).midpoint() == value.lit(0);
        let may_underflow = self.value.precision() <= f64::MANTISSA_DIGITS;
        let is_constant = self.slope.vanishes() && value.is_finite() && !(vanishes && may_underflow);
        let mut slope = if is_constant {
            // Of which no power with a finite slope need exist. In f64 both may be zero by underflow.
            self.slope.clone()
        } else if vanishes {
            self.value.pow(&(exponent.value.clone() - exponent.value.lit(1))) * &exponent.value * &self.slope
        } else {
            self.slope.clone() / &self.value * &exponent.value * &value
        };
        if !exponent.slope.vanishes() {
            slope += &(value.clone() * self.value.ln() * &exponent.slope);
        }
        Dual { value, slope }
    }
    fn powi(&self, exponent: i64) -> Self {
        if exponent == 0 {
            return self.lit(1);
        }
        self.chain(self.value.powi(exponent), self.value.powi(exponent - 1).times(exponent))
    }
    fn precision(&self) -> u32 {
        self.value.precision()
    }
    fn unit_roundoff(&self) -> Self {
        Dual::constant(self.value.unit_roundoff())
    }
    fn approx(&self) -> f64 {
        self.value.approx()
    }
    fn is_finite(&self) -> bool {
        self.value.is_finite() && self.slope.is_finite()
    }
    /// A bound on the error does not bound the derivative: over intervals a nonzero slope becomes unbounded.
    fn inflate(self, bound: &Self) -> Self {
        let unknown = bound.value.lit(1).over(0);
        Dual { value: self.value.inflate(&bound.value), slope: self.slope.inflate(&unknown) }
    }
    /// The first derivative is kept; nothing is known of the second.
    fn inflate_with_slope(self, bound: &Self) -> Self {
        Dual { value: self.value.inflate_with_slope(&bound.value), slope: self.slope.inflate(&bound.slope) }
    }
    /// If the order is not certain, or the two are equal, the slope is an enclosure of both.
    fn greater(&self, other: &Self) -> Self {
        match self.value.partial_cmp(&other.value) {
            Some(Ordering::Less) => other.clone(),
            Some(Ordering::Greater) => self.clone(),
            // The slope is discontinuous at the kink and has no derivative.
            _ => {
                let slope = self.slope.either(&other.slope).inflate(&self.value.lit(0));
                Dual { value: self.value.greater(&other.value), slope }
            }
        }
    }
    fn either(&self, other: &Self) -> Self {
        Dual { value: self.value.either(&other.value), slope: self.slope.either(&other.slope) }
    }
    fn midpoint(&self) -> Self {
        Dual::constant(self.value.midpoint())
    }
}

impl<R: Special> Special for Dual<R> {
    fn sin(&self) -> Self {
        let (sin, cos) = self.value.sin_and_cos();
        self.chain(sin, cos)
    }
    fn cos(&self) -> Self {
        let (sin, cos) = self.value.sin_and_cos();
        self.chain(cos, -sin)
    }
    fn sin_and_cos(&self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_and_cos();
        (self.chain(sin.clone(), cos.clone()), self.chain(cos, -sin))
    }
    fn atan(&self) -> Self {
        let derivative = (self.value.lit(1) + self.value.square()).inv();
        self.chain(self.value.atan(), derivative)
    }
    fn asin(&self) -> Self {
        let derivative = (self.value.lit(1) - self.value.square()).sqrt().inv();
        self.chain(self.value.asin(), derivative)
    }
    fn acos(&self) -> Self {
        let derivative = -(self.value.lit(1) - self.value.square()).sqrt().inv();
        self.chain(self.value.acos(), derivative)
    }
    fn sinh(&self) -> Self {
        self.chain(self.value.sinh(), self.value.cosh())
    }
    fn cosh(&self) -> Self {
        self.chain(self.value.cosh(), self.value.sinh())
    }
    fn tanh(&self) -> Self {
        // 1 − tanh² would cancel, and a cosh overflows, of which the derivatives are ∞/∞ then.
        let derivative = if self.value.approx().abs() < FAR {
            self.value.cosh().inv().square()
        } else {
            let e = self.value.abs().times(-2).exp();
            e.clone().times(4) / (e.lit(1) + e).square()
        };
        self.chain(self.value.tanh(), derivative)
    }
    fn atanh(&self) -> Self {
        let derivative = (self.value.lit(1) - self.value.square()).inv();
        self.chain(self.value.atanh(), derivative)
    }
}
