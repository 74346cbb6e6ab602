//! The fields of a state: pressure, displacement and gap.
//!
//! All three are integrals of g alone, so a profile needs only its transform. The substitutions below remove the
//! square-root singularities, and every integral is split at the kinks of g.

mod media;

use mdr_core::calculus::quadrature::tanh_sinh_pieces;
use mdr_core::calculus::{Estimate, Tolerance, gauss_jacobi};
use mdr_core::contact::{Equilibrium, Error, Quantity, Result};
use mdr_core::number::Special;

use crate::contact::{Contact, negligible};

/// The fields of the equilibrium with a given contact radius.
///
/// ```
/// use std::sync::Arc;
/// use mdr_core::contact::{Control, Material, Shape};
/// use mdr_numeric::{contact::Contact, fields::Fields, transform::Quadrature};
/// let ball = Arc::new(Quadrature::of([Shape::Paraboloid { radius: 1.0 }])?);
/// let (material, control) = (Material::new(1.0, 1e-4)?, Control::Indentation);
/// let fields = Fields::new(Contact::half_space(&ball, &material, &control), 0.1)?;
/// assert!(fields.pressure(&0.0)? > 0.0);   // compressed in the middle,
/// assert!(fields.pressure(&0.0999)? < 0.0); // in tension at the edge
/// assert!(fields.gap(&0.2)? > 0.0);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone)]
pub struct Fields<R: Special> {
    curve: Contact<R>,
    contact_radius: R,
    indentation: R,
    /// g(a) − d, the elongation of the edge springs: Δl, but less if the contact is pressed against a vertical edge or pinned.
    edge: R,
    /// Whether the edge stays where it is when the depth changes.
    stays: bool,
}

impl<R: Special> Fields<R> {
    /// The equilibrium of the curve at the given contact radius.
    ///
    /// # Errors
    /// [`Error::Domain`] unless the contact radius is positive and finite; errors of the transform there.
    pub fn new(curve: Contact<R>, contact_radius: R) -> Result<Self> {
        let contact_radius = Error::require_positive(Quantity::ContactRadius, contact_radius)?;
        let indentation = curve.indentation(&contact_radius)?;
        let edge = curve.elongation(&contact_radius);
        let stays = curve.vertical_edge().as_ref() == Some(&contact_radius);
        Ok(Fields { curve, contact_radius, indentation, edge, stays })
    }

    /// An equilibrium that was found on the curve, or at its vertical edge.
    ///
    /// # Errors
    /// [`Error::Domain`] unless the contact radius is positive and finite; errors of the transform there.
    pub fn of(curve: Contact<R>, state: &Equilibrium<R>) -> Result<Self> {
        let fields = Self::new(curve, state.contact_radius.clone())?;
        if fields.curve.vertical_edge().as_ref() != Some(&state.contact_radius) {
            return Ok(fields);
        }
        fields.held_at(&state.indentation)
    }

    /// A state whose edge is pinned between two works of adhesion, with its own depth: g(a) − d lies between Δl₁ and Δl₂.
    ///
    /// ```
    /// use mdr_core::contact::{Control, Edge, Equilibrium, Shape, Stability};
    /// use mdr_numeric::medium::{Adhesion, Medium};
    /// use mdr_numeric::{contact::Contact, fields::Fields, transform::Quadrature};
    /// let ball = Quadrature::of([Shape::Paraboloid { radius: 1.0 }])?;
    /// let adhesion = Adhesion::hysteretic(0.01, 0.04)?;
    /// let contact = Contact::new(ball, Medium::half_space(1.0)?, adhesion, Control::Indentation);
    /// let (contact_radius, indentation) = (0.2, -0.1);
    /// let force = 2.0 * contact_radius * (indentation - contact_radius * contact_radius / 3.0);
    /// let state = Equilibrium { contact_radius, indentation, force, stability: Stability::Stable };
    /// let fields = Fields::pinned(contact.at(Edge::Receding), &state)?;
    /// assert_eq!(fields.stiffness()?, 0.4); // 2E*a
    /// // The tension at the edge is between those of the two works of adhesion.
    /// let at = |edge: Edge| Fields::new(contact.at(edge), 0.2)?.pressure(&0.199);
    /// let tension = fields.pressure(&0.199)?;
    /// assert!(at(Edge::Receding)? < tension && tension < at(Edge::Advancing)?);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] unless the contact radius is positive and finite; errors of the transform there.
    pub fn pinned(curve: Contact<R>, state: &Equilibrium<R>) -> Result<Self> {
        Self::new(curve, state.contact_radius.clone())?.held_at(&state.indentation)
    }

    /// The contact radius held at another depth.
    fn held_at(self, indentation: &R) -> Result<Self> {
        let edge = self.curve.transform().g(&self.contact_radius)? - indentation;
        Ok(Fields { indentation: indentation.clone(), edge, stays: true, ..self })
    }

    /// The indentation depth d, in m.
    pub fn indentation(&self) -> &R {
        &self.indentation
    }

    /// The pressure p(r) = (E*/π)[∫ᵣᵃ g'(x)/√(x² − r²) dx − (g(a) − d)/√(a² − r²)] for 0 ≤ r < a, in Pa (Popov & Heß
    /// 2014), with g(a) − d = Δl away from a vertical edge; negative is tension. With q² = a² − r² and x² = r² + q²t²
    /// the integral is ∫ g'(x) q/x dt up to the first kink b > r, or to a, where all ratios of lengths are moderate.
    /// Beyond a kink, where g' may begin with 1/√(x − b), the variable is τ in x = b + (b − r) sinh²τ; with a kink b just inside
    /// r it is that in x = r + (r − b) sinh²τ.
    ///
    /// # Errors
    /// [`Error::Domain`] unless 0 ≤ r < a, and where the pressure is infinite: at the tip of a cone, and at some kinks;
    /// [`Error::NoConvergence`] if the quadrature does not converge; [`Error::OutOfRange`] if it is not representable
    /// in this arithmetic.
    pub fn pressure(&self, r: &R) -> Result<R> {
        let estimate = self.pressure_estimate(r)?;
        let medium = self.curve.medium();
        let share = if medium.is_half_space() {
            self.edge.abs() / leg(&self.contact_radius, r) * medium.modulus()
        } else {
            medium.stiffness(&self.contact_radius) * self.edge.abs() * r.unit_roundoff().sqrt()
        };
        settled(estimate, &share)
    }

    /// The pressure with its estimated error, also if that exceeds the limit of [`Fields::pressure`].
    ///
    /// # Errors
    /// [`Error::Domain`] unless 0 ≤ r < a, and where the pressure is infinite; [`Error::NoConvergence`] if the quadrature does
    /// not converge; [`Error::OutOfRange`] if the pressure is not representable in this arithmetic.
    pub fn pressure_estimate(&self, r: &R) -> Result<Estimate<R>> {
        let a = &self.contact_radius;
        if self.curve.medium().is_half_space() && !(*r >= r.lit(0) && r < a) {
            return Err(Error::domain(Quantity::Radius, r, "within the contact, 0 <= r < a"));
        }
        if let Some(estimate) = self.pressure_on_medium(r)? {
            return in_range(estimate);
        }
        let reach = leg(a, r);
        let aside = r.clone() / &reach;
        let kinks = self.kinks(r, a);
        let first = kinks.first().unwrap_or(a);
        let mut bulk = match self.kink_just_inside(r, first) {
            Some(kink) => integrate_beside_kink(&kink, first, r, |x| self.curve.transform().slope(x))?,
            None => integrate(&r.lit(0), &(leg(first, r) / &reach), &[], |t| {
                let share = hypotenuse(&aside, t);
                // Rounding must not lead beyond a kink: a piece in which g' is 0 would consist of such a point only.
                let x = (share.clone() * &reach).greater(r).lesser(first);
                Ok(self.curve.transform().slope(&self.off_axis(x))? / share)
            })
            .map_err(|error| if self.is_infinite_at(r) { infinite_at(r) } else { error })?,
        };
        for (i, kink) in kinks.iter().enumerate() {
            let next = kinks.get(i + 1).unwrap_or(a);
            bulk += &integrate_from_kink(kink, next, r, |x| self.curve.transform().slope(x))?;
        }
        let strain = (bulk.value - self.edge.clone() / &reach) / r.pi();
        let pressure = strain.clone() * self.curve.modulus();
        if pressure.is_finite() && (pressure != r.lit(0) || strain == r.lit(0)) {
            let error = bulk.error / r.pi() * self.curve.modulus();
            return Ok(Estimate { value: pressure, error, evaluations: bulk.evaluations });
        }
        let log10 = (strain.abs().ln() + self.curve.modulus().ln()).approx() / std::f64::consts::LN_10;
        Err(Error::OutOfRange { quantity: Quantity::Parameter("the pressure p"), log10 })
    }

    /// The kink b below r, if it is much closer to r than the next radius at which the integral is split.
    fn kink_just_inside(&self, r: &R, first: &R) -> Option<R> {
        let kink = self.curve.transform().kinks().into_iter().rfind(|kink| kink < r)?;
        ((r.clone() - &kink).times(16) < first.clone() - r).then_some(kink)
    }

    /// Whether the quadrature is expected to fail: at the tip if g' does not vanish there, and at a kink. A slope that falls slowly towards
    /// the tip, as that of r^1.05, has a pressure there, though the quadrature may not reach it.
    fn is_infinite_at(&self, r: &R) -> bool {
        let near = |bits: i64| self.curve.transform().slope(&(r.lit(2).powi(-bits) * &self.contact_radius));
        let sharp =
            || matches!((near(20), near(40)), (Ok(far), Ok(near)) if near.abs() > far.abs().times(1023).over(1024));
        self.curve.transform().kinks().contains(r) || *r == r.lit(0) && sharp()
    }

    /// The gap between the surfaces at r > a, in m: (2/π) ∫ (g(r cos φ) − d) dφ over 0 < φ < arccos(a/r).
    ///
    /// It is f(r) − d + u(r), with the profile itself written as the inverse transform of g.
    ///
    /// # Errors
    /// [`Error::Domain`] unless r > a; errors of the transform between a and r.
    pub fn gap(&self, r: &R) -> Result<R> {
        settled(self.gap_estimate(r)?, &self.edge)
    }

    /// The gap with its estimated error, also if that exceeds the limit of [`Fields::gap`].
    ///
    /// # Errors
    /// [`Error::Domain`] unless r > a; errors of the transform between a and r.
    pub fn gap_estimate(&self, r: &R) -> Result<Estimate<R>> {
        if let Some(estimate) = self.gap_on_medium(r)? {
            return Ok(estimate);
        }
        let a = self.outside(r)?;
        let angle = |x: &R| (leg(r, x) / x).atan();
        let breaks: Vec<R> = self.kinks(a, r).iter().map(angle).collect();
        let needed = negligible(&self.edge);
        let excess = |phi: &R| Ok(self.curve.transform().g_within(&(phi.cos() * r), &needed)? - &self.indentation);
        Ok(integrate(&r.lit(0), &angle(a), &breaks, excess)?.scaled(&(r.lit(2) / r.pi())))
    }

    /// The displacement of the surface at r > a, in m, positive into the half-space:
    /// u(r) = (2/π) ∫ (d − g(r sin θ)) dθ over 0 < θ < arcsin(a/r).
    ///
    /// # Errors
    /// [`Error::Domain`] unless r > a; errors of the transform within the contact.
    pub fn displacement(&self, r: &R) -> Result<R> {
        settled(self.displacement_estimate(r)?, &self.edge)
    }

    /// The displacement with its estimated error, also if that exceeds the limit of [`Fields::displacement`].
    ///
    /// # Errors
    /// [`Error::Domain`] unless r > a; errors of the transform within the contact.
    pub fn displacement_estimate(&self, r: &R) -> Result<Estimate<R>> {
        if let Some(estimate) = self.displacement_on_medium(r)? {
            return Ok(estimate);
        }
        let a = self.outside(r)?;
        let angle = |x: &R| (x.clone() / &leg(r, x)).atan();
        let breaks: Vec<R> = self.kinks(&r.lit(0), a).iter().map(angle).collect();
        let depth = |theta: &R| {
            let x = self.off_axis(theta.sin() * r);
            Ok(self.indentation.clone() - self.curve.transform().g_within(&x, &negligible(&self.edge))?)
        };
        Ok(integrate(&r.lit(0), &angle(a), &breaks, depth)?.scaled(&(r.lit(2) / r.pi())))
    }

    /// The stiffness of the contact along the equilibria, dF/dd = F'(a)/d'(a), in N/m; infinite at a fold of d. At a
    /// vertical edge the radius is fixed, and it is that of a punch.
    ///
    /// # Errors
    /// [`Error::Domain`] at the fold itself; errors of the transform at the contact radius.
    pub fn stiffness(&self) -> Result<R> {
        if self.stays {
            return Ok(self.curve.stiffness(&self.contact_radius));
        }
        let at_fold = || {
            let requirement = "off the fold of the indentation";
            Error::domain(Quantity::ContactRadius, &self.contact_radius, requirement)
        };
        self.curve.stiffness_along(&self.contact_radius)?.ok_or_else(at_fold)
    }

    /// The contact radius, for a radius outside it.
    fn outside(&self, r: &R) -> Result<&R> {
        let a = &self.contact_radius;
        if r > a && r.is_finite() {
            Ok(a)
        } else {
            Err(Error::domain(Quantity::Radius, r, "finite and outside the contact, r > a"))
        }
    }

    /// A radius in the contact, bounded away from the axis by an amount that is negligible in an integral: rounding
    /// could give 0.
    fn off_axis(&self, x: R) -> R {
        x.greater(&(self.contact_radius.unit_roundoff().square() * &self.contact_radius))
    }

    /// The kinks of g strictly between two radii.
    fn kinks(&self, from: &R, to: &R) -> Vec<R> {
        let mut kinks = self.curve.transform().kinks();
        kinks.retain(|kink| kink > from && kink < to);
        kinks
    }
}

/// A pressure that is representable.
fn in_range<R: Special>(pressure: Estimate<R>) -> Result<Estimate<R>> {
    if pressure.value.is_finite() {
        return Ok(pressure);
    }
    let log10 = pressure.value.approx().abs().log10();
    Err(Error::OutOfRange { quantity: Quantity::Parameter("the pressure p"), log10 })
}

fn infinite_at<R: Special>(r: &R) -> Error {
    Error::domain(Quantity::Radius, r, "off a tip or an edge where the pressure is infinite")
}

/// √(x² − r²) for x ≥ r.
fn leg<R: Special>(x: &R, r: &R) -> R {
    (x.clone() - r).sqrt() * (x.clone() + r).sqrt()
}

/// √(x² + y²) for x, y ≥ 0; the squares stay in range.
fn hypotenuse<R: Special>(x: &R, y: &R) -> R {
    let (short, long) = if x < y { (x, y) } else { (y, x) };
    if *long == long.lit(0) {
        return long.clone();
    }
    ((short.clone() / long).square() + long.lit(1)).sqrt() * long
}

/// ∫ f from `lower` to `upper`.
fn integrate<R: Special>(lower: &R, upper: &R, breaks: &[R], f: impl Fn(&R) -> Result<R>) -> Result<Estimate<R>> {
    tanh_sinh_pieces(lower, upper, breaks, or_half_of_the_digits(upper), f)
}

/// ∫ g'(x)/√(x² − r²) dx from r, where g' may have an inverse root at a kink b < r: in τ with x = r + (r − b) sinh²τ, which
/// removes that root and the one of x − r however close r is, 2∫ g'(x) √((x − b)/(x + r)) dτ.
fn integrate_beside_kink<R: Special>(
    kink: &R,
    upper: &R,
    r: &R,
    slope: impl Fn(&R) -> Result<R>,
) -> Result<Estimate<R>> {
    let near = r.clone() - kink;
    let width = arsinh(&((upper.clone() - r) / &near).sqrt());
    let weighted = |t: &R| {
        let x = (sinh(&(t.clone() * &width)).square() * &near + r).lesser(upper);
        Ok(slope(&x)? * ((x.clone() - kink) / (x + r)).sqrt())
    };
    Ok(over_unit_interval(upper, weighted)?.scaled(&width.times(2)))
}

/// ∫ g'(x)/√(x² − r²) dx from a kink b > r, where g' may have an inverse root: in τ with x = b + (b − r) sinh²τ, which
/// removes that root and the one of x − r however close r is, 2∫ g'(x) √((b − r)/(x + r)) sinh τ dτ.
fn integrate_from_kink<R: Special>(kink: &R, upper: &R, r: &R, slope: impl Fn(&R) -> Result<R>) -> Result<Estimate<R>> {
    let near = kink.clone() - r;
    let beside = kink.unit_roundoff().times(2) * kink + kink;
    let width = arsinh(&((upper.clone() - kink) / &near).sqrt());
    let weighted = |t: &R| {
        let x = (sinh(&(t.clone() * &width)).square() * &near + kink).lesser(upper).greater(&beside);
        // sinh at the rounded radius, at which the slope is evaluated.
        let sinh = ((x.clone() - kink) / &near).sqrt();
        Ok(slope(&x)? * (near.clone() / (x + r)).sqrt() * sinh)
    };
    Ok(over_unit_interval(upper, weighted)?.scaled(&width.times(2)))
}

/// arsinh x for x ≥ 0, without cancellation.
fn arsinh<R: Special>(x: &R) -> R {
    let one = x.lit(1);
    (x.square() / ((x.square() + &one).sqrt() + &one) + x).ln_1p()
}

/// sinh x, without cancellation.
fn sinh<R: Special>(x: &R) -> R {
    let excess = x.exp_m1();
    (excess.clone() / (excess.clone() + excess.lit(1)) + excess).over(2)
}

/// ∫ f from 0 to 1 by Gauss–Legendre, whose nodes stay away from a kink: next to it x − b would consist of the rounding of x
/// only. Tanh-sinh if a singularity is close.
fn over_unit_interval<R: Special>(like: &R, f: impl Fn(&R) -> Result<R>) -> Result<Estimate<R>> {
    let (zero, one) = (like.lit(0), like.lit(1));
    match gauss_jacobi::integrate(&zero, &zero, Tolerance::of_cancelling(like), &f) {
        Err(Error::NoConvergence { .. }) => tanh_sinh_pieces(&zero, &one, &[], or_half_of_the_digits(like), &f),
        integral => integral,
    }
}

/// The tightest tolerance, or the result of the finest rule with its error.
fn or_half_of_the_digits<R: Special>(like: &R) -> Tolerance<R> {
    Tolerance::of_cancelling(like).or_finest_below(like.unit_roundoff().sqrt().times(16))
}

/// The value of an estimate that meets the tolerance, relative to itself or to the contribution of the edge.
fn settled<R: Special>(estimate: Estimate<R>, edge: &R) -> Result<R> {
    let Estimate { value, error, evaluations } = estimate;
    let size = value.abs() + edge.abs();
    if error <= Tolerance::of_cancelling(&value).limit().clone() * &size {
        return Ok(value);
    }
    let error = (error / size).approx();
    Err(Error::NoConvergence { quantity: Quantity::Integral, evaluations, error })
}
