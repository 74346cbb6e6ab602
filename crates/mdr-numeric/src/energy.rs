//! Equilibria once more, from the potential energy (Griffith).
//!
//! Π(a, d) = E* ∫₀ᵃ (d − g)² dx − πa²w. Equilibria at a given d are its stationary points in a, minima the stable ones;
//! under controlled force those of Π − Fd, on a machine those of Π + k(D − d)²/2, each stationary in d as well. The rule of
//! Heß is nowhere used: the derivative is that of the integral itself, by dual numbers under the integral sign.
//!
//! In units of 2πa²w: Π/(2πa²w) = ∫₀¹ v² dt − 1/2 with v = (d − g(at))/√(2πaw/E*), which is in range at any scale.

use mdr_core::calculus::roots::{self, Bracket};
use mdr_core::calculus::{gauss_jacobi, quadrature::tanh_sinh_pieces, roundoff_tolerance};
use mdr_core::contact::{Control, Equilibrium, Error, Material, Quantity, Result, Stability, Transform};
use mdr_core::number::{Dual, Real};

use crate::curve::relative_elongation;
use crate::survey::{self, Crossing, Range};

/// The potential energy of a profile in contact.
///
/// ```
/// use mdr_core::contact::{Control, Material, Stability};
/// use mdr_numeric::{energy::Energy, profiles::Paraboloid, transform::Quadrature};
/// let (ball, glue) = (Quadrature::new(Paraboloid::new(1.0)?), Material::new(1.0, 1e-3)?);
/// let stationary = Energy::new(&ball, &glue)?.equilibria(&Control::Indentation, &-0.01)?;
/// assert_eq!(stationary.len(), 2);
/// assert_eq!(stationary[1].stability, Stability::Stable); // the minimum
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
pub struct Energy<'a, R: Real> {
    transform: &'a dyn Transform<R>,
    material: &'a Material<R>,
    /// w/E*.
    length: R,
    /// p of g ≈ c xᵖ at the tip, as far as g tells; none beside kinks.
    tip: Option<R>,
}

/// How well an integral is needed.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Grade {
    /// To a percent or so, for finding the crossings.
    Coarse,
    /// To rounding.
    Full,
}

/// Nodes of a coarse integral.
const COARSE: usize = 12;

impl<'a, R: Real> Energy<'a, R> {
    /// The energy of a transformed profile against a material.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] when w/E* is no number of this arithmetic.
    pub fn new(transform: &'a dyn Transform<R>, material: &'a Material<R>) -> Result<Self> {
        let length = material.work_of_adhesion().clone() / material.effective_modulus();
        if !(length > length.lit(0) && length.is_finite()) {
            return Err(Error::OutOfRange { quantity: Quantity::Energy, log10: length.approx().log10() });
        }
        let tip = if transform.kinks().is_empty() { tip_exponent(transform, &length) } else { None };
        Ok(Energy { transform, material, length, tip })
    }

    /// Π(a, d), in J, zero for separated surfaces.
    ///
    /// # Errors
    /// Those of the transform and of the quadrature; [`Error::OutOfRange`] when it is no number of this arithmetic.
    pub fn potential(&self, a: &R, d: &R) -> Result<R> {
        let a = Error::require_positive(Quantity::ContactRadius, a.clone())?;
        let unit = self.unit(&a);
        let elastic = self.mean(&a, Grade::Full, |x| Ok(((d.clone() - g(self.transform, x)?) / &unit).square()))?;
        let reduced = elastic.times(2) - a.lit(1);
        let potential = a.clone() * self.material.work_of_adhesion() * a.pi() * &a * &reduced;
        let vanished = potential == potential.lit(0) && reduced != reduced.lit(0);
        if vanished || !potential.is_finite() {
            let factors = [a.pi(), a.clone(), a, self.material.work_of_adhesion().clone(), reduced.abs()];
            let log10 = factors.iter().map(|x| x.ln().approx()).sum::<f64>() / std::f64::consts::LN_10;
            return Err(Error::OutOfRange { quantity: Quantity::Energy, log10 });
        }
        Ok(potential)
    }

    /// The energy lost when the radius jumps from `from` to `to` at fixed d, in J.
    ///
    /// # Errors
    /// As [`Energy::potential`].
    pub fn dissipated(&self, from: &R, to: &R, d: &R) -> Result<R> {
        Ok(self.potential(from, d)? - self.potential(to, d)?)
    }

    /// The energy release rate at fixed d over the work of adhesion: (∂/∂a of the elastic energy)/(2πaw). Where it is one,
    /// Π is stationary in a; where it is larger, the contact shrinks.
    ///
    /// # Errors
    /// Those of the transform and of the quadrature.
    pub fn release(&self, a: &R, d: &R) -> Result<R> {
        self.graded_release(a, d, Grade::Full)
    }

    fn graded_release(&self, a: &R, d: &R, grade: Grade) -> Result<R> {
        // a d/da of a ∫ v(at)² dt, with the unit of v held: the dual's slope is a d/da.
        let unit = self.unit(a);
        self.mean(a, grade, |x| {
            let radius = Dual { value: a.lit(1), slope: a.lit(1) };
            let x = Dual { value: x.clone(), slope: x.clone() };
            let g = if vanishes(&x.value) {
                x.lit(0)
            } else {
                x.chain(self.transform.g(&x.value)?, self.transform.slope(&x.value)?)
            };
            let v = (Dual::constant(d.clone()) - g) / Dual::constant(unit.clone());
            Ok((v.square() * radius).slope)
        })
    }

    /// The indentation that makes the energy stationary in d at radius `a`: ∂Π/∂d = 2E* ∫₀ᵃ (d − g) dx is F, or k(D − d).
    fn indentation(&self, control: &Control<R>, value: &R, a: &R, grade: Grade) -> Result<R> {
        let stiffness = self.stiffness(a);
        let mean = || self.mean(a, grade, |x| g(self.transform, x));
        Ok(match control {
            Control::Indentation => value.clone(),
            Control::Force => value.clone() / stiffness + mean()?,
            Control::Machine { stiffness: k } => {
                let whole = k.clone() + &stiffness;
                k.clone() / &whole * value + stiffness / whole * mean()?
            }
        })
    }

    /// ∂²Π/∂d² = 2E*a.
    fn stiffness(&self, a: &R) -> R {
        (a.clone() * self.material.effective_modulus()).times(2)
    }

    /// √(2πaw/E*), the unit of displacement at radius `a`.
    fn unit(&self, a: &R) -> R {
        relative_elongation(a, &self.length) * a
    }

    /// All equilibria at `value` of the controlled quantity, as stationary points of the energy where the edge is in
    /// tension, g(a) − d > 0; by increasing radius. Minima are stable.
    ///
    /// Accuracy as that of [`equilibrium::equilibria`](crate::equilibrium::equilibria), except that the stationary point of
    /// an integral is known to about ten times its rounding error. Each evaluation is an integral over g and g'; expect
    /// some ten milliseconds in f64, and seconds at 50 digits where g is itself a quadrature.
    ///
    /// # Errors
    /// Those of the transform and of the quadrature.
    pub fn equilibria(&self, control: &Control<R>, value: &R) -> Result<Vec<Equilibrium<R>>> {
        let ratio = |a: &R, grade| self.graded_release(a, &self.indentation(control, value, a, grade)?, grade);
        let kinks = self.transform.kinks();
        let range = Range { scale: self.length.clone(), kinks, outer: self.transform.outer_radius() };
        let survey = survey::survey(&range, |a| ratio(a, Grade::Coarse));
        let excess = |a: &R| Ok(ratio(a, Grade::Full)? - a.lit(1));
        let mut found = Vec::new();
        for crossing in &survey.crossings {
            let Some(bracket) = bracket(crossing, excess)? else { continue };
            let a = roots::refine(bracket, &roundoff_tolerance(&crossing.lower).over(8), excess)?.value;
            let d = self.indentation(control, value, &a, Grade::Full)?;
            if self.transform.g(&a)? > d {
                let force = self.stiffness(&a) * (d.clone() - self.mean(&a, Grade::Full, |x| g(self.transform, x))?);
                let stability = if crossing.rising { Stability::Stable } else { Stability::Unstable };
                found.push(Equilibrium { contact_radius: a, indentation: d, force, stability });
            }
        }
        Ok(found)
    }

    /// (1/a) ∫₀ᵃ h(x) dx.
    ///
    /// g may itself be noisy: a tolerance that cannot be met is relaxed step by step, up to √u.
    fn mean(&self, a: &R, grade: Grade, mut h: impl FnMut(&R) -> Result<R>) -> Result<R> {
        if grade == Grade::Coarse {
            return self.coarse(a, &mut h);
        }
        let limit = a.unit_roundoff().sqrt();
        let mut tolerance = roundoff_tolerance(a).times(4);
        loop {
            match self.full(a, &tolerance, &mut h) {
                Err(Error::NoConvergence { .. }) if tolerance < limit => tolerance = tolerance.times(64),
                result => return result,
            }
        }
    }

    fn coarse(&self, a: &R, h: &mut impl FnMut(&R) -> Result<R>) -> Result<R> {
        match &self.tip {
            Some(p) => {
                let inverse = p.clone().inv();
                let rule = gauss_jacobi::rule(COARSE, &a.lit(0), &(inverse.clone() - a.lit(1)))?;
                Ok(rule.integrate(|tau| h(&(tau.pow(&inverse) * a)))? * inverse)
            }
            None => self.double_exponential(a, &a.ratio(1, 10_000), h),
        }
    }

    /// In τ = tᵖ, t = x/a, whole powers of g are analytic: Gauss–Jacobi with the weight τ^(1/p−1). Where that does not
    /// converge and beside kinks, tanh-sinh.
    fn full(&self, a: &R, tolerance: &R, h: &mut impl FnMut(&R) -> Result<R>) -> Result<R> {
        let Some(p) = &self.tip else { return self.double_exponential(a, tolerance, h) };
        let inverse = p.clone().inv();
        let beta = inverse.clone() - a.lit(1);
        match gauss_jacobi::integrate(&a.lit(0), &beta, tolerance, |tau| h(&(tau.pow(&inverse) * a))) {
            Ok(estimate) => Ok(estimate.value * inverse),
            Err(Error::NoConvergence { .. }) => self.double_exponential(a, tolerance, h),
            Err(error) => Err(error),
        }
    }

    fn double_exponential(&self, a: &R, tolerance: &R, h: &mut impl FnMut(&R) -> Result<R>) -> Result<R> {
        let integral = tanh_sinh_pieces(&a.lit(0), a, &self.transform.kinks(), tolerance, h)?;
        Ok(integral.value / a)
    }
}

/// g(x), zero where x is.
fn g<R: Real>(transform: &dyn Transform<R>, x: &R) -> Result<R> {
    if vanishes(x) { Ok(x.lit(0)) } else { transform.g(x) }
}

/// Whether x is so close to the end of the range of the arithmetic that g(0) = 0 is all there is to know.
fn vanishes<R: Real>(x: &R) -> bool {
    x.unit_roundoff().square() * x == x.lit(0)
}

/// x g'/g close to the tip, on the scale of the material's length.
fn tip_exponent<R: Real>(transform: &dyn Transform<R>, length: &R) -> Option<R> {
    let x = length.clone() * length.unit_roundoff();
    let (value, slope) = (transform.g(&x).ok()?, transform.slope(&x).ok()?);
    let p = slope * x / value;
    (p > p.ratio(1, 10_000) && p < p.lit(10_000)).then_some(p)
}

/// The bracket of a crossing that was found with coarse integrals: widened until the full ones change sign in it.
fn bracket<R: Real>(crossing: &Crossing<R>, mut excess: impl FnMut(&R) -> Result<R>) -> Result<Option<Bracket<R>>> {
    let (mut lower, mut upper) = (crossing.lower.clone(), crossing.upper.clone());
    for halvings in (1..=7).rev() {
        if let Some(bracket) = Bracket::new(&lower, &upper, &mut excess)? {
            return Ok(Some(bracket));
        }
        let wider = lower.lit(1) + lower.lit(2).powi(-halvings);
        lower /= &wider;
        upper *= &wider;
    }
    Ok(None)
}
