//! Equilibria from the potential energy (Griffith).
//!
//! Π(a, d) = ½∫₀ᵃ S'(x)(d − g)² dx − πa²w, with S' = 2E* on a half-space. Equilibria at a given d are its stationary points in a, minima the stable ones;
//! under controlled force those of Π − Fd, on a machine those of Π + k(D − d)²/2, each stationary in d as well. The
//! rule of Heß is not used: the derivative is that of the integral itself, by dual numbers under the integral sign. (At
//! its end the integrand is ((d − g(a))/Δl)², which is equivalent to that rule: [`Energy::release`], the cheaper
//! method.)
//!
//! In units of 2πa²w: Π/(2πa²w) = ∫₀¹ v² S'(at)/S'(a) dt − 1/2 with v = (d − g(at))/Δl(a), which is in range at any scale.

mod loading;
mod mean;

use mdr_core::calculus::roots::{self, Bracket};
use mdr_core::calculus::{Tolerance, quadrature::tanh_sinh_pieces, roundoff_tolerance};
use mdr_core::contact::{Control, Equilibrium, Error, Quantity, Result, Stability, Transform};
use mdr_core::number::{Dual, Real};

use crate::contact::{Contact, in_range, negligible};
use crate::survey::{self, Crossing, Range};
pub(crate) use loading::Complete;
use mean::Grade;

/// The medium, for errors where it lacks what is asked of it.
pub const MEDIUM: Quantity = Quantity::Parameter("the medium");
/// Why a line contact has no energy.
const NEEDS_ENERGY: &str =
    "one with an energy: that of a line contact grows without bound with the size of the body; take forces and folds";

/// The potential energy of a profile in contact.
///
/// ```
/// use std::sync::Arc;
/// use mdr_core::contact::{Control, Material, Shape, Stability};
/// use mdr_numeric::contact::Contact;
/// use mdr_numeric::{energy::Energy, transform::Quadrature};
/// let (ball, glue) = (Arc::new(Quadrature::of([Shape::Paraboloid { radius: 1.0 }])?), Material::new(1.0, 1e-3)?);
/// let stationary = Energy::new(Contact::half_space(&ball, &glue, &Control::Indentation))?.equilibria(&Control::Indentation, &-0.01)?;
/// assert_eq!(stationary.len(), 2);
/// assert_eq!(stationary[1].stability, Stability::Stable); // the minimum
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
pub struct Energy<R: Real> {
    contact: Contact<R>,
    /// p of g ≈ c xᵖ at the tip, estimated from g; `None` beside kinks.
    tip: Option<R>,
}

impl<R: Real> Energy<R> {
    /// The energy of a contact, whose control is not used.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if w/E* is not representable in this arithmetic.
    pub fn new(contact: Contact<R>) -> Result<Self> {
        if !contact.medium().has_energy() {
            return Err(Error::Domain {
                quantity: MEDIUM,
                value: "a half-plane".to_owned(),
                requirement: NEEDS_ENERGY,
            });
        }
        let (transform, length) = (contact.transform(), contact.material_length());
        if !(length > length.lit(0) && length.is_finite()) {
            return Err(Error::OutOfRange { quantity: Quantity::Energy, log10: length.approx().log10() });
        }
        let tip = if transform.kinks().is_empty() { tip_exponent(transform, &length) } else { None };
        Ok(Energy { contact, tip })
    }

    /// Π(a, d), in J, zero for separated surfaces.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and finite; errors of the transform and of the quadrature; [`Error::OutOfRange`] if
    /// Π is not representable in this arithmetic.
    pub fn potential(&self, a: &R, d: &R) -> Result<R> {
        self.potential_by(a, d, |square| self.mean(a, &Grade::Full, square))
    }

    /// Π(a, d), in J, with a given method for the mean of v² over the contact.
    pub(crate) fn potential_by(
        &self,
        a: &R,
        d: &R,
        mean: impl FnOnce(&dyn Fn(&R) -> Result<R>) -> Result<R>,
    ) -> Result<R> {
        let a = Error::require_positive(Quantity::ContactRadius, a.clone())?;
        if let Some(wavelength) = self.contact.medium().period() {
            return self.by_loading(wavelength, &a, d);
        }
        // Without adhesion, in units of that of the other edge.
        let (work, unit) = (self.contact.adhesion().scale(), self.contact.unit_elongation(&a));
        let needed = negligible(&unit);
        let medium = self.contact.medium();
        let elastic = mean(&|x| {
            let square = ((d.clone() - g(self.contact.transform(), x, &needed)?) / &unit).square();
            Ok(medium.weighted_relative(x, &a, square))
        })?;
        let adhesive = if self.contact.adhesion().vanishes() { a.lit(0) } else { a.lit(1) };
        let reduced = elastic.times(2) - adhesive;
        let [pi, width, radius] = self.contact.medium().disc_factors(&a);
        let potential = width.clone() * work * &pi * &radius * &reduced;
        let factors = || [pi.clone(), width, radius, work.clone(), reduced.clone()];
        in_range(Quantity::Energy, potential, &reduced, factors)
    }

    /// The energy dissipated when the radius jumps from `from` to `to` at fixed d, in J: Π(from, d) − Π(to, d),
    /// computed as ½∫ S' ((d − g)² − Δl²) dx from `to` to `from`. It is not a difference of energies, so a small jump
    /// keeps its accuracy.
    /// # Errors
    /// [`Error::Domain`] unless both radii are positive and finite; errors of the transform and of the quadrature;
    /// [`Error::OutOfRange`] if the energy is not representable in this arithmetic.
    pub fn dissipated(&self, from: &R, to: &R, d: &R) -> Result<R> {
        let [from, to] = [from, to].map(|a| Error::require_positive(Quantity::ContactRadius, a.clone()));
        let (from, to) = (from?, to?);
        let unit = self.unit(&from);
        let (kinks, distance) = (self.contact.transform().kinks(), (from.clone() - &to).abs());
        if distance == from.lit(0) {
            return Ok(distance);
        }
        // Near a fold the integrand is of the order of the square of the distance, but its rounding error is not.
        let share = (from.clone() / distance).square() * from.unit_roundoff();
        let limit = share.times(64).greater(&from.unit_roundoff().sqrt()).lesser(&from.ratio(1, 1024));
        let tolerance = Tolerance::new(&roundoff_tolerance(&from).times(4)).or_noise_below(limit);
        let shrinks = to < from;
        let [lower, upper] = if shrinks { [&to, &from] } else { [&from, &to] };
        let needed = negligible(&unit);
        let gained = tanh_sinh_pieces(lower, upper, &kinks, tolerance, |x| {
            let (excess, length) = (d.clone() - g(self.contact.transform(), x, &needed)?, self.unit(x));
            let change = (excess.clone() - &length) / &unit * ((excess + length) / &unit);
            Ok(self.contact.medium().weighted_relative(x, &from, change))
        })?
        .value;
        let reduced = if shrinks { gained } else { -gained };
        // In units of A'w, 2πaw of a disc.
        let [pi, radius] = self.contact.medium().half_area_slope_factors(&from);
        let lost = (radius.clone() * self.work() * &pi).times(2) * &reduced;
        let factors = || [pi.times(2), radius, self.work().clone(), reduced.clone()];
        in_range(Quantity::Energy, lost, &reduced, factors)
    }

    /// The energy release rate at fixed d over the work of adhesion: (∂/∂a of the elastic energy)/(2πaw). Where it is
    /// one, Π is stationary in a; where it is larger, the contact shrinks.
    ///
    /// The derivative of the integral with respect to its end a is the integrand there, ((d − g(a))/Δl)²: a square, as
    /// accurate near its zero as d − g(a) is.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and finite; errors of the transform; [`Error::OutOfRange`] if the rate is not
    /// representable in this arithmetic.
    pub fn release(&self, a: &R, d: &R) -> Result<R> {
        let a = Error::require_positive(Quantity::ContactRadius, a.clone())?;
        let unit = self.unit(&a);
        let excess = (d.clone() - g(self.contact.transform(), &a, &negligible(&unit))?) / &unit;
        in_range(Quantity::Energy, excess.square(), &excess, || [excess.clone(), excess.clone()])
    }

    /// The energy release rate of [`Energy::release`], as the derivative of the integral, without the integrand at its end: the
    /// method of [`Energy::equilibria`]. It is accurate to a few roundings of the energy.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use mdr_core::contact::{Control, Flank, Material, Shape};
    /// use mdr_numeric::contact::Contact;
    /// use mdr_numeric::{energy::Energy, transform::Quadrature};
    /// let (cone, glue) = (Arc::new(Quadrature::of([Shape::Cone { flank: Flank::Slope(0.3) }])?), Material::new(2.0, 1e-3)?);
    /// let energy = Energy::new(Contact::half_space(&cone, &glue, &Control::Indentation))?;
    /// let (at_the_end, of_the_integral) = (energy.release(&0.08, &-0.01)?, energy.release_by_variation(&0.08, &-0.01)?);
    /// assert!((at_the_end - of_the_integral).abs() < 1e-12 * at_the_end);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and finite; errors of the transform and of the quadrature.
    pub fn release_by_variation(&self, a: &R, d: &R) -> Result<R> {
        let a = Error::require_positive(Quantity::ContactRadius, a.clone())?;
        self.varied(&a, d, &Grade::Full)
    }

    /// The release rate as the derivative of the integral, to the required accuracy.
    fn varied(&self, a: &R, d: &R, grade: &Grade<R>) -> Result<R> {
        // a d/da of a ∫ v(at)² dt at a fixed unit of v: the slope of the dual is a d/da. Only the piece from the last
        // kink b on depends on a, so there it is (a − b) d/da, x − b and the mean over it: g' may have an inverse root
        // or a pole at b, but (x − b)g' has not.
        let unit = self.unit(a);
        let edge = self.contact.transform().kinks().into_iter().rfind(|kink| kink < a);
        let from = edge.clone().unwrap_or_else(|| a.lit(0));
        self.mean_beyond(edge.as_ref(), a, grade, |x| {
            let radius = Dual { value: a.lit(1), slope: a.lit(1) };
            let x = Dual { value: x.clone(), slope: x.clone() - &from };
            let g = if vanishes(&x.value) {
                x.lit(0)
            } else {
                x.chain(self.contact.transform().g(&x.value)?, self.contact.transform().slope(&x.value)?)
            };
            let v = (Dual::constant(d.clone()) - g) / Dual::constant(unit.clone());
            Ok(self.contact.medium().weighted_change(&x, a, v.square() * radius))
        })
    }

    /// The force balance of the contact; methods of the curve that use the rule of Heß are not called.
    fn balance(&self, control: &Control<R>) -> Contact<R> {
        self.contact.with_control(control.clone())
    }

    /// w.
    fn work(&self) -> &R {
        self.contact.adhesion().work()
    }

    /// The indentation that makes the energy stationary in d at radius `a`: ∂Π/∂d = 2E* ∫₀ᵃ (d − g) dx is F, or k(D − d).
    fn indentation(&self, control: &Control<R>, value: &R, a: &R, grade: &Grade<R>) -> Result<R> {
        let needed = negligible(&self.unit(a));
        self.balance(control)
            .held_against(a, value, || self.mean(a, grade, |x| g(self.contact.transform(), x, &needed)))
    }

    /// Δl(a), the unit of displacement at radius `a`.
    fn unit(&self, a: &R) -> R {
        self.contact.elongation(a)
    }

    /// A quantity that equals one at equilibria only: the root of the release rate, positive where the edge is in
    /// tension, g(a) − d > 0, and negative elsewhere. A nearly Hertzian equilibrium is thus where a smooth function
    /// passes from large negative to large positive values. Without the sign it would be one side of a notch, as narrow
    /// as Δl is small against d, which a search could miss.
    ///
    /// Crossings are located by `coarse` integrals, and then computed to full precision.
    fn edge_excess(&self, control: &Control<R>, value: &R, a: &R, coarse: bool) -> Result<R> {
        // Near a crossing d − g is of the magnitude of the unit, so a fraction of the unit bounds the error of both.
        let grade = |scale: R| if coarse { Grade::Coarse(scale) } else { Grade::Full };
        let d = self.indentation(control, value, a, &grade(self.unit(a)))?;
        let root = self.varied(a, &d, &grade(a.lit(1)))?.abs().sqrt();
        Ok(if self.contact.transform().g(a)? > d { root } else { -root })
    }

    /// All equilibria at `value` of the controlled quantity, as stationary points of the energy where the edge is in
    /// tension, g(a) − d > 0; by increasing radius. Minima are stable.
    ///
    /// Accuracy as that of [`equilibrium::equilibria`](crate::equilibrium::equilibria), except that the stationary
    /// point of an integral is accurate to about ten times its rounding error. Each evaluation is an integral over g
    /// and g'; the cost is about ten milliseconds in f64, and seconds at 50 digits if g is itself a quadrature.
    ///
    /// # Errors
    /// [`Error::Domain`] unless `value` is finite and the stiffness of a machine positive and finite; errors of the transform and
    /// of the quadrature; [`Error::OutOfRange`] if a force is not representable in this arithmetic; [`Error::Undecided`] if Π is
    /// stationary, up to rounding, over a whole range of radii, as at d = 0 at the threshold of n = 1/2.
    pub fn equilibria(&self, control: &Control<R>, value: &R) -> Result<Vec<Equilibrium<R>>> {
        control.check_value(value)?;
        let range =
            Range { heights: u64::MAX, ..Range::whole(self.contact.transform(), self.contact.material_length()) };
        let survey = survey::survey(&range, |a| self.edge_excess(control, value, a, true))?;
        let excess = |a: &R| Ok(self.edge_excess(control, value, a, false)? - a.lit(1));
        let mut found = Vec::new();
        for crossing in &survey.crossings {
            let Some(bracket) = bracket(crossing, excess)? else { continue };
            let a = roots::refine(bracket, &roundoff_tolerance(&crossing.lower).over(8), excess)?.value;
            let d = self.indentation(control, value, &a, &Grade::Full)?;
            let needed = negligible(&self.unit(&a));
            let excess = d.clone() - self.mean(&a, &Grade::Full, |x| g(self.contact.transform(), x, &needed))?;
            let force = self.balance(control).force_of(&a, &excess)?;
            let stability = if crossing.rising { Stability::Stable } else { Stability::Unstable };
            found.push(Equilibrium { contact_radius: a, indentation: d, force, stability });
        }
        Ok(found)
    }
}

/// g(x) to the required accuracy, zero where x is.
fn g<R: Real>(transform: &dyn Transform<R>, x: &R, needed: &R) -> Result<R> {
    if vanishes(x) { Ok(x.lit(0)) } else { transform.g_within(x, needed) }
}

/// Whether x is so close to the end of the range of the arithmetic that g(x) is taken as g(0) = 0.
fn vanishes<R: Real>(x: &R) -> bool {
    x.unit_roundoff().square() * x == x.lit(0)
}

/// x g'/g close to the tip: at w/E* times u, or if g is not a normal number there, at the nearest power of two times
/// that where it is. A steep profile leaves the range within a few octaves.
fn tip_exponent<R: Real>(transform: &dyn Transform<R>, length: &R) -> Option<R> {
    /// The widest exponent range: 2^±2²⁰.
    const GALLOPS: u32 = 20;
    let start = -i64::from(length.precision());
    let side = |t: i64| side(transform, length.clone() * length.lit(2).powi(t));
    let (mut low, mut high) = match side(start) {
        Side::Normal(p) => return p,
        Side::Below => (Some(start), None),
        Side::Above => (None, Some(start)),
    };
    for gallop in 4..GALLOPS {
        let t = match (low, high) {
            (Some(low), Some(high)) => (low + high) / 2,
            (Some(low), None) => low + (1 << gallop),
            (_, high) => high? - (1 << gallop),
        };
        match side(t) {
            Side::Normal(p) => return p,
            Side::Below => low = Some(t),
            Side::Above => high = Some(t),
        }
    }
    None
}

/// The position of g(x) in the range of the arithmetic.
enum Side<R> {
    /// Below the normal numbers of the arithmetic.
    Below,
    /// A normal number, with x g'/g if that can be an exponent.
    Normal(Option<R>),
    /// Above the normal numbers, or beyond the profile.
    Above,
}

fn side<R: Real>(transform: &dyn Transform<R>, x: R) -> Side<R> {
    if vanishes(&x) {
        return Side::Below;
    }
    match (transform.g(&x), transform.slope(&x)) {
        (Ok(value), _) if vanishes(&value.abs()) => Side::Below,
        (Ok(value), Ok(slope)) => {
            let p = slope * x / value;
            Side::Normal((p > p.ratio(1, 10_000) && p < p.lit(10_000)).then_some(p))
        }
        (Err(Error::OutOfRange { log10, .. }), _) if log10 < 0.0 => Side::Below,
        (Err(Error::OutOfRange { .. } | Error::Domain { .. }), _) => Side::Above,
        _ => Side::Normal(None),
    }
}

/// The bracket of a crossing that was found with coarse integrals, widened until the full ones change sign in it.
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

#[cfg(test)]
mod tests {
    use mdr_core::contact::{Flank, Shape};

    use super::*;
    use crate::medium::{Adhesion, Medium};
    use crate::transform::Quadrature;

    /// The derivative of the integral is the integrand at its end: to the tolerance of the integral, 128 roundoffs of
    /// ∫|v² + 2v x g'/Δl| < 3 max v², and v² < 10 at all x < a here.
    #[test]
    fn varied_is_released() -> Result<()> {
        let cone = Quadrature::of([Shape::Cone { flank: Flank::Slope(0.3) }])?;
        let (medium, adhesion) = (Medium::half_space(2.0)?, Adhesion::new(1e-3)?);
        let energy = Energy::new(Contact::new(cone, medium, adhesion, Control::Indentation))?;
        for (a, d) in [(0.08, -0.01), (0.03, 0.0), (0.05, 0.03)] {
            let (local, varied) = (energy.release(&a, &d)?, energy.varied(&a, &d, &Grade::Full)?);
            assert!(local < 10.0 && (local - varied).abs() < 64.0 * f64::EPSILON * 30.0, "{local} {varied}");
        }
        Ok(())
    }
}
