//! Heights that a program computes: f(r) from a closure.

use mdr_core::contact::{Error, Profile, Quantity, Result};
use mdr_core::number::{Dual, Lift};

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
#[derive(Clone, Debug)]
pub struct Function<F> {
    heights: F,
    kinks: Vec<f64>,
    outer_radius: Option<f64>,
}

impl<F: Fn(f64) -> [f64; 3] + Send + Sync> Function<F> {
    /// A profile from a closure that gives f, f' and f'' at a radius, in units of metres. f is continuous, with f(0) = 0.
    ///
    /// # Errors
    /// [`Error::Domain`] unless f(0) is 0.
    pub fn new(heights: F) -> Result<Self> {
        let [tip, ..] = heights(0.0);
        if tip != 0.0 {
            let quantity = Quantity::Parameter("f(0)");
            return Err(Error::domain(quantity, &tip, "0: heights and depths are counted from the tip"));
        }
        Ok(Function { heights, kinks: Vec::new(), outer_radius: None })
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
}

impl Function<()> {
    /// A profile from a closure over numbers that carry their derivatives, so that f is written once.
    ///
    /// # Errors
    /// [`Error::Domain`] unless f(0) is 0.
    pub fn differentiated(
        height: impl Fn(Differentiated) -> Differentiated + Send + Sync,
    ) -> Result<Function<impl Fn(f64) -> [f64; 3] + Send + Sync>> {
        Function::new(move |r| {
            let f = height(Dual::variable(Dual::variable(r)));
            [f.value.value, f.value.slope, f.slope.slope]
        })
    }
}

impl<F: Fn(f64) -> [f64; 3] + Send + Sync> Profile<f64> for Function<F> {
    /// Taylor's series to second order, which is all that a number with two derivatives holds.
    fn height<S: Lift<f64>>(&self, r: &S) -> S {
        let at = r.value_of();
        let [f, slope, bend] = (self.heights)(at).map(|value| S::lift(&value));
        let step = r.clone() - S::lift(&at);
        f + (slope + bend.over(2) * &step) * step
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
