//! What a state looks like in space: pressure, displacement and gap.
//!
//! All three are integrals of g alone, so a profile needs no more than its transform. The substitutions below take the
//! square-root singularities out, and every integral is split at the kinks of g.

use mdr_core::calculus::isolate::isolate;
use mdr_core::calculus::quadrature::tanh_sinh_pieces;
use mdr_core::calculus::roots::bisect;
use mdr_core::calculus::{Tolerance, roundoff_tolerance};
use mdr_core::contact::{Equilibrium, Error, Quantity, Result};
use mdr_core::number::Special;

use crate::curve::Curve;

/// The fields of the equilibrium with a given contact radius.
///
/// ```
/// use mdr_core::contact::{Control, Material};
/// use mdr_numeric::{curve::Curve, fields::Fields, profiles::Paraboloid, transform::Quadrature};
/// let ball = Quadrature::new(Paraboloid::new(1.0)?);
/// let (material, control) = (Material::new(1.0, 1e-4)?, Control::Indentation);
/// let fields = Fields::new(Curve::new(&ball, &material, &control), 0.1)?;
/// assert!(fields.pressure(&0.0)? > 0.0);   // pressed in the middle,
/// assert!(fields.pressure(&0.0999)? < 0.0); // torn at the edge
/// assert!(fields.gap(&0.2)? > 0.0);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone)]
pub struct Fields<'a, R: Special> {
    curve: Curve<'a, R>,
    contact_radius: R,
    indentation: R,
    /// g(a) − d, by which the springs at the edge are stretched: Δl, but less at a wall that the contact is pressed against.
    edge: R,
}

impl<'a, R: Special> Fields<'a, R> {
    /// The equilibrium of the curve at the given contact radius.
    ///
    /// # Errors
    /// As [`Curve::indentation`].
    pub fn new(curve: Curve<'a, R>, contact_radius: R) -> Result<Self> {
        let contact_radius = Error::require_positive(Quantity::ContactRadius, contact_radius)?;
        let indentation = curve.indentation(&contact_radius)?;
        let edge = curve.detachment_elongation(&contact_radius);
        Ok(Fields { curve, contact_radius, indentation, edge })
    }

    /// An equilibrium that was found on the curve, or at its wall.
    ///
    /// # Errors
    /// As [`Fields::new`].
    pub fn of(curve: Curve<'a, R>, state: &Equilibrium<R>) -> Result<Self> {
        let fields = Self::new(curve, state.contact_radius.clone())?;
        if fields.curve.wall().as_ref() != Some(&state.contact_radius) {
            return Ok(fields);
        }
        let edge = fields.curve.transform().g(&state.contact_radius)? - &state.indentation;
        Ok(Fields { indentation: state.indentation.clone(), edge, ..fields })
    }

    /// The indentation depth d, in m.
    pub fn indentation(&self) -> &R {
        &self.indentation
    }

    /// The pressure p(r) = (E*/π)[∫ᵣᵃ g'(x)/√(x² − r²) dx − (g(a) − d)/√(a² − r²)] for 0 ≤ r < a, in Pa (Popov & Heß 2014),
    /// with g(a) − d = Δl away from a wall; negative is tension. With x² = r² + t² the integral is ∫ g'(x)/x dt over
    /// 0 < t < √(a² − r²).
    ///
    /// # Errors
    /// [`Error::Domain`] unless 0 ≤ r < a; where the pressure is infinite (the tip of a cone, r = 0) the quadrature does
    /// not converge and says so.
    pub fn pressure(&self, r: &R) -> Result<R> {
        let a = &self.contact_radius;
        if !(*r >= r.lit(0) && r < a) {
            return Err(Error::domain(Quantity::Radius, r, "within the contact, 0 <= r < a"));
        }
        let reach = leg(a, r);
        let breaks = self.breaks(r, a, |kink| leg(kink, r));
        let bulk = integrate(&reach, &breaks, |t| {
            let x = (r.square() + t.square()).sqrt();
            Ok(self.curve.transform().slope(&x)? / &x)
        })?;
        let edge = self.edge.clone() / &reach;
        Ok((bulk - edge) * self.curve.effective_modulus() / r.pi())
    }

    /// The gap between the surfaces at r > a, in m: (2/π) ∫ (g(r cos φ) − d) dφ over 0 < φ < arccos(a/r).
    ///
    /// It is f(r) − d + u(r), with the profile itself written as the inverse transform of g.
    ///
    /// # Errors
    /// [`Error::Domain`] unless r > a; as [`Transform::g`](mdr_core::contact::Transform::g).
    pub fn gap(&self, r: &R) -> Result<R> {
        let a = self.outside(r)?;
        let angle = |x: &R| (leg(r, x) / x).atan();
        let breaks = self.breaks(a, r, angle);
        let excess = |phi: &R| Ok(self.curve.transform().g(&(phi.cos() * r))? - &self.indentation);
        Ok(integrate(&angle(a), &breaks, excess)?.times(2) / r.pi())
    }

    /// The displacement of the surface at r > a, in m, positive into the half-space:
    /// u(r) = (2/π) ∫ (d − g(r sin θ)) dθ over 0 < θ < arcsin(a/r).
    ///
    /// # Errors
    /// As [`Fields::gap`].
    pub fn displacement(&self, r: &R) -> Result<R> {
        let a = self.outside(r)?;
        let angle = |x: &R| (x.clone() / &leg(r, x)).atan();
        let breaks = self.breaks(&r.lit(0), a, angle);
        let depth = |theta: &R| Ok(self.indentation.clone() - self.curve.transform().g(&(theta.sin() * r))?);
        Ok(integrate(&angle(a), &breaks, depth)?.times(2) / r.pi())
    }

    /// The smallest sampled radius in (a, `until`) where the gap turns negative: there the surfaces would interpenetrate,
    /// and the assumption of one simply connected contact is not admissible. None where no sample finds it.
    ///
    /// No gap closes while g stays above d: only radii beyond such a dip are sampled.
    ///
    /// # Errors
    /// As [`Fields::gap`].
    pub fn interpenetration(&self, until: &R) -> Result<Option<R>> {
        /// Enough for some hundred crests between a and the outer radius.
        const SAMPLES: usize = 1000;
        let a = self.outside(until)?;
        let excess = |x: &R| Ok(self.curve.transform().g(x)? - &self.indentation);
        let Some(first) = isolate(a, until, SAMPLES, excess)?.brackets.into_iter().next() else {
            return Ok(None);
        };
        let dip = bisect(first, &roundoff_tolerance(a), excess)?;
        let closing = isolate(&dip.value, until, SAMPLES, |r| self.gap(r))?;
        Ok(closing.brackets.into_iter().next().map(|bracket| bracket.upper.x))
    }

    /// The stiffness of the contact along the equilibria, dF/dd = F'(a)/d'(a), in N/m; infinite at a fold of d. At a wall
    /// the radius is fixed, and it is 2E*a.
    ///
    /// # Errors
    /// [`Error::Domain`] at the fold itself; as [`Curve::tangency`].
    pub fn stiffness(&self) -> Result<R> {
        let stiffness = (self.contact_radius.clone() * self.curve.effective_modulus()).times(2);
        if self.curve.wall().as_ref() == Some(&self.contact_radius) {
            return Ok(stiffness);
        }
        // d' = Δl'(τ − 1) and F' = 2E*a Δl'(τ − 3) with the tangency ratio τ = g'/Δl'.
        let tangency = self.curve.tangency(&self.contact_radius)?;
        let fold = tangency.clone() - tangency.lit(1);
        if fold == fold.lit(0) {
            return Err(Error::domain(
                Quantity::ContactRadius,
                &self.contact_radius,
                "off the fold of the indentation",
            ));
        }
        Ok((tangency.clone() - tangency.lit(3)) / fold * stiffness)
    }

    /// The contact radius, for a radius outside it.
    fn outside(&self, r: &R) -> Result<&R> {
        let a = &self.contact_radius;
        if r > a { Ok(a) } else { Err(Error::domain(Quantity::Radius, r, "outside the contact, r > a")) }
    }

    /// The kinks of g strictly between two radii, as values of the variable of integration.
    fn breaks(&self, from: &R, to: &R, variable: impl Fn(&R) -> R) -> Vec<R> {
        let kinks = self.curve.transform().kinks();
        kinks.iter().filter(|kink| *kink > from && *kink < to).map(variable).collect()
    }
}

/// √(x² − r²) for x ≥ r.
fn leg<R: Special>(x: &R, r: &R) -> R {
    ((x.clone() - r) * (x.clone() + r)).sqrt()
}

/// ∫ f from 0 to `upper`. Where the integrand cancels, rounding may leave less of it than is asked for.
fn integrate<R: Special>(upper: &R, breaks: &[R], f: impl Fn(&R) -> Result<R>) -> Result<R> {
    let goal = roundoff_tolerance(upper);
    let tolerance = Tolerance::new(&goal).or_noise_below(goal.times(4096));
    Ok(tanh_sinh_pieces(&upper.lit(0), upper, breaks, tolerance, f)?.value)
}
