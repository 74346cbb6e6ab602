//! Heights that a program computes: f(r) from a closure.

use std::any::TypeId;
use std::fmt;
use std::sync::Arc;

use mdr_core::contact::{Error, Profile, Quantity, Result};
use mdr_core::number::{Dual, Lift, Special};

/// A number with its first and second derivative with respect to r.
pub type Differentiated = Dual<Dual<f64>>;

/// A profile f(r) in f64 from a closure that gives f, f' and f'' at a radius.
///
/// ```
/// use mdr_core::contact::Control;
/// use mdr_numeric::contact::Contact;
/// use mdr_numeric::medium::{Adhesion, Medium};
/// use mdr_numeric::{folds, function::Function, transform::Quadrature};
/// // f = r⁴/4L³, L = 1 mm: once by its derivatives, once by differentiating numbers.
/// let cubed = 4.0 * 1e-3_f64.powi(3);
/// let by_hand = Function::new(move |r: f64| [r.powi(4), 4.0 * r.powi(3), 12.0 * r.powi(2)].map(|x| x / cubed))?;
/// let by_duals = Function::differentiated(|r| {
///     use mdr_core::number::Real;
///     r.square().square() * r.lit(250_000_000)
/// })?;
/// let pull_off = |profile| -> mdr_core::contact::Result<f64> {
///     let (medium, adhesion) = (Medium::half_space(1e6)?, Adhesion::new(0.05)?);
///     Ok(folds::find(&Contact::new(profile, medium, adhesion, Control::Force))?[0].force)
/// };
/// let one = pull_off(Quadrature::new(by_hand))?;
/// let (medium, adhesion) = (Medium::half_space(1e6)?, Adhesion::new(0.05)?);
/// let other = folds::find(&Contact::new(Quadrature::new(by_duals), medium, adhesion, Control::Force))?[0].force;
/// assert!((one / other - 1.0).abs() < 1e-12);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone)]
pub struct Function {
    heights: Arc<dyn Fn(f64) -> [f64; 3] + Send + Sync>,
    kinks: Vec<f64>,
    outer_radius: Option<f64>,
}

impl fmt::Debug for Function {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Function { kinks, outer_radius, .. } = self;
        f.debug_struct("Function").field("kinks", kinks).field("outer_radius", outer_radius).finish_non_exhaustive()
    }
}

impl Function {
    /// A profile from a closure that gives f, f' and f'' at a radius, in units of metres. f is continuous, with f(0) = 0.
    ///
    /// # Errors
    /// [`Error::Domain`] unless f(0) is 0.
    pub fn new(heights: impl Fn(f64) -> [f64; 3] + Send + Sync + 'static) -> Result<Self> {
        let [tip, ..] = heights(0.0);
        if tip != 0.0 {
            let quantity = Quantity::Parameter("f(0)");
            return Err(Error::domain(quantity, &tip, "0: heights and depths are counted from the tip"));
        }
        Ok(Function { heights: Arc::new(heights), kinks: Vec::new(), outer_radius: None })
    }

    /// A profile from a closure over numbers that carry their derivatives, so that f is written once.
    ///
    /// # Errors
    /// [`Error::Domain`] unless f(0) is 0.
    pub fn differentiated(height: impl Fn(Differentiated) -> Differentiated + Send + Sync + 'static) -> Result<Self> {
        Function::new(move |r| {
            let f = height(Dual::variable(Dual::variable(r)));
            [f.value.value, f.value.slope, f.slope.slope]
        })
    }

    /// The profile with the radii at which f or a derivative of it jumps, in m. Integrals are split there.
    ///
    /// # Errors
    /// [`Error::Domain`] unless they are positive, finite and ascending.
    pub fn with_kinks(self, kinks: impl Into<Vec<f64>>) -> Result<Self> {
        let (kinks, quantity) = (kinks.into(), Quantity::Parameter("the radius of a kink"));
        for (index, kink) in kinks.iter().enumerate() {
            Error::require_positive(quantity, *kink)?;
            if index > 0 && kinks[index - 1] >= *kink {
                return Err(Error::domain(quantity, kink, "larger than the radius of the kink before it"));
            }
        }
        Ok(Function { kinks, ..self })
    }

    /// The profile with the radius, in m, beyond which it is not defined.
    ///
    /// # Errors
    /// [`Error::Domain`] unless it is positive and finite.
    pub fn with_outer_radius(self, radius: f64) -> Result<Self> {
        let radius = Error::require_positive(Quantity::Parameter("the outer radius"), radius)?;
        Ok(Function { outer_radius: Some(radius), ..self })
    }

    /// The profile for code that is written for any arithmetic: `None` unless that is f64.
    pub fn in_arithmetic<R: Special>(&self, ctx: R::Ctx) -> Option<impl Profile<R> + use<R>> {
        let found = InArithmetic { function: self.clone(), ctx };
        Some(found).filter(|_| TypeId::of::<R>() == TypeId::of::<f64>())
    }
}

/// A function in the arithmetic R, which is f64.
struct InArithmetic<R: Special> {
    function: Function,
    ctx: R::Ctx,
}

impl<R: Special> InArithmetic<R> {
    fn number(&self, x: f64) -> R {
        R::from_f64(self.ctx, x)
    }
}

impl<R: Special> Profile<R> for InArithmetic<R> {
    fn height<S: Lift<R>>(&self, r: &S) -> S {
        let at = r.value_of();
        let values = (self.function.heights)(at.approx());
        series(values.map(|value| S::lift(&self.number(value))), r.clone() - S::lift(&at))
    }

    fn kinks(&self) -> Vec<R> {
        self.function.kinks.iter().map(|kink| self.number(*kink)).collect()
    }

    fn outer_radius(&self) -> Option<R> {
        self.function.outer_radius.map(|radius| self.number(radius))
    }
}

/// Taylor's series to second order, which is all that a number with two derivatives holds.
fn series<S: Special>([f, slope, bend]: [S; 3], step: S) -> S {
    f + (slope + bend.over(2) * &step) * step
}

impl Profile<f64> for Function {
    fn height<S: Lift<f64>>(&self, r: &S) -> S {
        let at = r.value_of();
        series((self.heights)(at).map(|value| S::lift(&value)), r.clone() - S::lift(&at))
    }

    fn kinks(&self) -> Vec<f64> {
        self.kinks.clone()
    }

    fn outer_radius(&self) -> Option<f64> {
        self.outer_radius
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// f, f' and f'' come back from numbers that carry them.
    #[test]
    fn derivatives_are_those_given() -> Result<()> {
        let cubic = Function::differentiated(|r| r.clone() * &r * &r)?;
        let f = cubic.height(&Dual::variable(Dual::variable(2.0)));
        assert_eq!([f.value.value, f.value.slope, f.slope.value, f.slope.slope], [8.0, 12.0, 12.0, 12.0]);
        assert_eq!(cubic.height(&2.0), 8.0);
        Ok(())
    }

    #[test]
    fn a_profile_that_is_none_is_refused() {
        assert!(Function::new(|r: f64| [r + 1.0, 1.0, 0.0]).is_err());
        assert!(Function::new(|r: f64| [f64::NAN * r, 1.0, 0.0]).is_err());
        let line = || Function::new(|r: f64| [r, 1.0, 0.0]).expect("a cone");
        assert!(line().with_kinks([0.1, 0.1]).is_err() && line().with_kinks([-0.1]).is_err());
        assert!(line().with_outer_radius(0.0).is_err() && line().with_outer_radius(1.0).is_ok());
    }
}
