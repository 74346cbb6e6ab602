//! Adhesion of finite range: the Maugis–Dugdale theory for any profile, and when the short-range theory of the other modules holds.
//!
//! The surfaces attract each other with the constant stress σ₀ = w/h₀ wherever the gap is below h₀: in a ring a < r < c
//! around the contact (D. Maugis, J. Colloid Interface Sci. 150 (1992) 243). For h₀ → 0 this is the rule of Heß (1.4).
//! With s = 2σ₀/E*, q = √(c² − a²) and θ = arccos(a/c), where the pressure is continuous at r = a,
//!
//! * d = g(a) − s q,
//! * (π/2) h₀ = ∫₀^θ (g(c cos φ) − g(a)) dφ + s (q θ − (c − a)), the gap at r = c,
//! * F = S(a) [g(a) − mean of g − (s/2a)(c²θ + a q)].
//!
//! Along these states the force is stationary where ∫₀^θ x g'(x) dφ = s (c²θ²/a + c − a), x = c cos φ; h₀ → 0 gives the
//! fold under a dead load, g'(a) = 3Δl'(a).

mod graded;
mod ring;

use std::cmp::Ordering;

use mdr_core::calculus::roots::{self, Bracket, Sample};
use mdr_core::calculus::{Tolerance, roundoff_tolerance};
use mdr_core::contact::{Error, Quantity, Result};
use mdr_core::number::{Special, order};

use crate::contact::{Contact, negligible};

pub use graded::state_on_graded;
pub(crate) use ring::Ring;

/// The range of adhesion, for errors.
const RANGE: Quantity = Quantity::Parameter("the range of adhesion");

/// The separation h₀ = 0.974 z₀ up to which the stress of Dugdale acts, for the range z₀ of a Lennard-Jones attraction with
/// the same strength and the same work (Maugis 1992), in m.
pub fn separation<R: Special>(range: &R) -> R {
    range.clone().times(487).over(500)
}

/// The generalised Tabor number μ = Δl(a)/(c_T z₀), c_T = √(2π(9π/8)^(1/3)), of a contact of radius `a`: the elongation at
/// its edge over the range z₀ of adhesion. At the pull-off of a paraboloid under a dead load it is Tabor's own
/// (Rw²/(E*²z₀³))^(1/3).
///
/// # Errors
/// [`Error::Domain`] unless a and z₀ are positive and finite.
pub fn tabor_number<R: Special>(curve: &Contact<R>, a: &R, range: &R) -> Result<R> {
    let range = Error::require_positive(RANGE, range.clone())?;
    let constant = (a.pi().times(9).over(8).ln().over(3).exp() * a.pi()).times(2).sqrt();
    Ok(curve.detachment_elongation(a)? / range / constant)
}

/// A profile in contact whose surfaces attract each other up to a finite separation.
///
/// ```
/// use std::sync::Arc;
/// use mdr_core::contact::{Control, Material, Shape};
/// use mdr_numeric::{contact::Contact, dugdale::{Dugdale, separation}, folds::folds};
/// use mdr_numeric::transform::Quadrature;
/// // A ball of 10 nm with z₀ = 0.3 nm: its pull-off force is between 3/2 πwR (JKR) and 2πwR (DMT).
/// let ball = Arc::new(Quadrature::of([Shape::Paraboloid { radius: 10e-9 }])?);
/// let material = Material::new(5e9, 0.05)?;
/// let contact = Dugdale::new(Contact::half_space(&ball, &material, &Control::Force), &separation(&0.3e-9))?;
/// let jkr = folds(&ball, &material, &Control::Force)?[0].contact_radius;
/// let pull_off = contact.pull_off(&[jkr])?.expect("it breaks");
/// let share = -pull_off.force / (std::f64::consts::PI * 0.05 * 10e-9);
/// assert!(1.5 < share && share < 2.0);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
pub struct Dugdale<R: Special> {
    curve: Contact<R>,
    separation: R,
    /// s = 2σ₀/E*, without a unit.
    strength: R,
}

/// A state with a ring of attraction.
#[derive(Clone, Debug, PartialEq)]
pub struct CohesiveState<R> {
    /// a, within which the surfaces touch, in m.
    pub contact_radius: R,
    /// c, up to which they attract each other, in m.
    pub outer_radius: R,
    /// d, in m.
    pub indentation: R,
    /// F, in N.
    pub force: R,
}

impl<R: Special> Dugdale<R> {
    /// A contact with the separation h₀ up to which the surfaces attract each other, in m; [`separation`] takes it from the
    /// range of adhesion. The control of the curve is not used.
    ///
    /// # Errors
    /// [`Error::Domain`] unless h₀ is positive and finite; [`Error::OutOfRange`] if w/(E*h₀) is not representable.
    pub fn new(curve: Contact<R>, separation: &R) -> Result<Self> {
        let separation = Error::require_positive(RANGE, separation.clone())?;
        if !curve.medium().is_half_space() {
            let requirement = "left out: the theory of a finite range is available on a homogeneous half-space only";
            return Err(Error::domain(RANGE, &separation, requirement));
        }
        let strength = (curve.material_length() / &separation).times(2);
        if !(strength > strength.lit(0) && strength.is_finite()) {
            let log10 = curve.material_length().ln() - separation.ln();
            return Err(Error::OutOfRange { quantity: RANGE, log10: log10.approx() / std::f64::consts::LN_10 });
        }
        Ok(Dugdale { curve, separation, strength })
    }

    /// The contact without the ring.
    pub fn contact(&self) -> &Contact<R> {
        &self.curve
    }

    /// The state with the contact radius `a`. Outside a contact whose gap is not monotonic the ring ends where the gap first
    /// reaches h₀.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and finite, and if the ring would reach beyond the profile; errors of the
    /// transform; [`Error::OutOfRange`] if the force is not representable.
    pub fn state(&self, a: &R) -> Result<CohesiveState<R>> {
        let ring = self.ring(&Error::require_positive(Quantity::ContactRadius, a.clone())?, None)?;
        self.state_of(&ring)
    }

    /// The state of greatest tension at which a contact breaks under a dead load that is lowered step by step: the lowest of the
    /// minima of the force along the states. `None` if there is no minimum, because the contact spreads by itself.
    ///
    /// The minima are looked for among contact radii an octave apart, from four times the largest of the `folds` of the
    /// short-range theory under a dead load downwards, and around each of them.
    ///
    /// # Errors
    /// [`Error::Domain`] if the ring would reach beyond the profile; errors of the transform; [`Error::OutOfRange`] if a force is
    /// not representable.
    pub fn pull_off(&self, folds: &[R]) -> Result<Option<CohesiveState<R>>> {
        let mut lowest: Option<CohesiveState<R>> = None;
        for state in self.minima(folds)? {
            if lowest.as_ref().is_none_or(|known| state.force < known.force) {
                lowest = Some(state);
            }
        }
        Ok(lowest)
    }

    /// The minima of the force, by decreasing contact radius.
    fn minima(&self, folds: &[R]) -> Result<Vec<CohesiveState<R>>> {
        let mut minima: Vec<_> = self.at_vertical_edge()?.into_iter().collect();
        let natural = self.separation.clone() / &self.strength;
        let top =
            folds.iter().cloned().reduce(|top, fold| top.greater(&fold)).unwrap_or_else(|| natural.clone().times(4));
        let mut radii: Vec<R> =
            folds.iter().flat_map(|fold| [9, 10, 11].map(|k| fold.clone().times(k).over(10))).collect();
        radii.sort_by(order);
        let (mut next, mut above, mut width, mut lost) = (top.times(4), None, None, None);
        loop {
            let a = match radii.pop_if(|radius| *radius >= next) {
                Some(radius) => radius,
                None => {
                    let half = next.clone().over(2);
                    std::mem::replace(&mut next, half)
                }
            };
            let sampled = self.ring(&a, width.as_ref()).and_then(|ring| Ok((self.excess(&ring)?, ring)));
            let (excess, ring) = match sampled {
                Ok(sampled) => sampled,
                // A ring that ends beyond the profile, or a contact radius there or where g is not resolved.
                Err(error @ (Error::Domain { .. } | Error::NoConvergence { .. }))
                    if a > natural.clone() * a.unit_roundoff() =>
                {
                    above = None;
                    if matches!(error, Error::NoConvergence { .. }) {
                        lost.get_or_insert(error);
                    }
                    continue;
                }
                Err(Error::Domain { .. }) if !minima.is_empty() => return Ok(minima),
                Err(error) => return Err(error),
            };
            let rises = excess > a.lit(0);
            if let Some((upper, true)) = above.replace((a.clone(), rises))
                && !rises
                && let Some(minimum) = self.minimum(a.clone(), upper, Some(&ring.width))?
            {
                minima.push(minimum);
            }
            // From here on the condition is linear in a: the force falls with a growing contact.
            if !rises && radii.is_empty() && ring.c > a.times(8) {
                return lost.filter(|_| minima.is_empty()).map_or(Ok(minima), Err);
            }
            width = Some(ring.width);
        }
    }

    /// The minimum between two radii, if the force falls with a growing contact at the lower one and rises at the upper. Where
    /// the slope of g jumps up at a kink, as at the edge of a flat face, the force turns where the ring reaches the kink.
    fn minimum(&self, mut lower: R, mut upper: R, width: Option<&R>) -> Result<Option<CohesiveState<R>>> {
        let excess = |a: &R| self.excess(&self.ring(a, width)?);
        let Some(bracket) = Bracket::new(&lower, &upper, excess)? else { return Ok(None) };
        let mut kinks = self.curve.transform().kinks();
        if !kinks.is_empty() {
            let [inner, outer] = [&lower, &upper].map(|a| self.ring(a, width).map(|ring| ring.c));
            let (inner, outer) = (inner?, outer?);
            kinks.retain(|kink| *kink > inner && *kink < outer);
        }
        let mut left = kinks.as_slice();
        while let [below @ .., _] = left {
            let (below, rest) = left.split_at(below.len() / 2);
            let Some((ring, side)) = self.at_kink(&rest[0], &lower, &upper)? else { break };
            (lower, upper, left) = match side {
                Ordering::Less => (ring.a, upper, &rest[1..]),
                Ordering::Equal => return self.state_of(&ring).map(Some),
                Ordering::Greater => (lower, ring.a, below),
            };
        }
        let bracket = if kinks.is_empty() { bracket } else { Bracket::new(&lower, &upper, excess)?.unwrap_or(bracket) };
        let a = roots::refine(bracket, &lower.unit_roundoff(), excess)?.value;
        self.state_of(&self.ring(&a, width)?).map(Some)
    }

    /// The ring that ends at a kink, of a contact between two radii, and whether the force falls with a growing contact there, or
    /// rises, or is least. `None` if there is no such ring.
    fn at_kink(&self, kink: &R, lower: &R, upper: &R) -> Result<Option<(Ring<R>, Ordering)>> {
        let rounding = kink.unit_roundoff().times(4) * kink;
        let gap = |a: &R| self.excess_gap(&Ring::new(a, &(kink.clone() - a)));
        let upper = upper.lesser(&(kink.clone() - &rounding));
        if *lower >= upper {
            return Ok(None);
        }
        let Some(bracket) = Bracket::new(lower, &upper, gap)? else { return Ok(None) };
        let a = roots::refine(bracket, &kink.unit_roundoff(), gap)?.value;
        let width = kink.clone() - &a;
        let excess = |width: R| Ok(self.excess(&Ring::new(&a, &width))? > kink.lit(0));
        let [within, beyond] = [width.clone() - &rounding, width.clone() + rounding].map(excess);
        let side = match (within?, beyond?) {
            (false, false) => Ordering::Less,
            (false, true) => Ordering::Equal,
            (true, _) => Ordering::Greater,
        };
        Ok(Some((Ring::new(&a, &width), side)))
    }

    /// At a vertical edge of radius b: the ring can reach it and not beyond, so that the state with c = b is a minimum if the
    /// force falls with a growing contact up to there.
    fn at_vertical_edge(&self) -> Result<Option<CohesiveState<R>>> {
        let Some(outer_edge) = self.curve.vertical_edge() else { return Ok(None) };
        let gap = |a: &R| self.excess_gap(&Ring::new(a, &(outer_edge.clone() - a)));
        // A contact as wide as the edge has no ring, one far narrower has one that opens as far as it can.
        let narrow = outer_edge.unit_roundoff() * &outer_edge;
        let wide = outer_edge.clone() - outer_edge.unit_roundoff().times(4) * &outer_edge;
        let a = match Bracket::new(&narrow, &wide, gap)? {
            Some(bracket) => roots::refine(bracket, &outer_edge.unit_roundoff(), gap)?.value,
            None if gap(&narrow)? < outer_edge.lit(0) => narrow,
            None => wide,
        };
        let ring = Ring::new(&a, &(outer_edge - &a));
        Ok(if self.excess(&ring)? < a.lit(0) { Some(self.state_of(&ring)?) } else { None })
    }

    /// The ring around a contact, found from the width of a similar one.
    fn ring(&self, a: &R, width: Option<&R>) -> Result<Ring<R>> {
        let transform = self.curve.transform();
        let gap = |width: &R| self.excess_gap(&Ring::new(a, width));
        let limit = transform.outer_radius().map(|outer| (outer - a).midpoint());
        if let Some(limit) = &limit {
            let open = *limit > a.lit(0) && gap(limit)? >= a.lit(0);
            if !open {
                return Err(Error::domain(
                    RANGE,
                    &self.separation,
                    "so short that the ring of attraction ends within the profile",
                ));
            }
        }
        let within = |width: &R| match &limit {
            Some(limit) if width >= limit => Ok(a.lit(1)),
            _ => gap(width),
        };
        // The width that the opening of the ring alone would have where a is far larger.
        let guess = width.cloned().unwrap_or_else(|| self.separation.clone() / &self.strength * a.pi().over(2));
        let Some(mut bracket) = bracket(guess, within)? else {
            return Err(Error::domain(RANGE, &self.separation, "one at which the gap outside the contact passes"));
        };
        if !transform.rises() {
            bracket = first_crossing(bracket, within)?;
        }
        let width = roots::refine(bracket, &a.unit_roundoff(), within)?.value;
        Ok(Ring::new(a, &width))
    }

    /// The gap at the end of a ring minus h₀, times π/2.
    fn excess_gap(&self, ring: &Ring<R>) -> Result<R> {
        let (elastic, limit) = (self.opening(ring), self.needed_opening());
        let needed = negligible(&(elastic.clone() + &limit));
        let level = self.curve.transform().g_within(&ring.a, &needed)?;
        // g(x) − g(a) cannot be better than its terms.
        let rounding = roundoff_tolerance(&level).times(4) * level.abs() * &ring.angle + &needed;
        let (transform, half) = (self.curve.transform(), rounding.unit_roundoff().sqrt().times(16));
        let (kinks, rise) =
            (transform.kinks(), |x: &R| Ok(beside_singular(x, |x| transform.g_within(x, &needed))? - &level));
        let rounding = rounding + ring.rounding(&kinks, rise)?;
        let tolerance = Tolerance::of_cancelling(&ring.a).or_finest_below(half).or_error_below(&rounding);
        let shape = ring.integral(&kinks, &tolerance, rise)?;
        Ok(shape.value + elastic - limit)
    }

    /// ∫₀^θ x g'(x) dφ − s (c²θ²/a + c − a): positive where the force grows with the contact.
    fn excess(&self, ring: &Ring<R>) -> Result<R> {
        let (Ring { a, .. }, elastic) = (ring, self.pull(ring));
        // Where g' has an inverse root half of the digits are left, and as the force is stationary that is enough for it.
        let half = a.unit_roundoff().sqrt().times(4096);
        let tolerance = Tolerance::of_cancelling(a)
            .or_finest_below(half.clone())
            .or_error_below(&(elastic.clone() * a.unit_roundoff()));
        let transform = self.curve.transform();
        let (kinks, slope) = (transform.kinks(), |x: &R| Ok(beside_singular(x, |x| transform.slope(x))? * x));
        let weighted = match ring.integral(&kinks, &tolerance, slope) {
            // A piece of a few roundings beside a kink is a small part of the whole, and need not be known better.
            Err(Error::NoConvergence { .. }) => {
                ring.integral(&kinks, &tolerance.or_error_below(&(elastic.clone() * &half)), slope)
            }
            weighted => weighted,
        }?;
        Ok(weighted.value - elastic)
    }

    pub(crate) fn state_of(&self, ring: &Ring<R>) -> Result<CohesiveState<R>> {
        let Ring { a, c, leg, angle, .. } = ring;
        let depth = self.strength.clone() * leg;
        let indentation = self.curve.transform().g_within(a, &negligible(&depth))? - depth;
        let attraction = (c.clone() / a * c * angle + leg).over(2) * &self.strength;
        let force = self.curve.force_of(a, &(self.curve.transform().above_mean(a)? - attraction))?;
        Ok(CohesiveState { contact_radius: a.clone(), outer_radius: c.clone(), indentation, force })
    }
}

/// A function of the profile at x, or beside it where x is rounded to the end of the profile or to a radius where g diverges.
fn beside_singular<R: Special>(x: &R, f: impl Fn(&R) -> Result<R>) -> Result<R> {
    match f(x) {
        Err(Error::Domain { .. }) => f(&(x.clone() - x.unit_roundoff().times(8) * x)),
        value => value,
    }
}

/// A sign change of a function that is negative near zero, from a guess downwards where it is positive there, and upwards
/// otherwise, in steps that double in the logarithm: far above its zero the function may be hard to compute. `None` if there is
/// none in the range of the arithmetic.
fn bracket<R: Special>(guess: R, mut f: impl FnMut(&R) -> Result<R>) -> Result<Option<Bracket<R>>> {
    let mut last = Sample::take(guess, &mut f)?;
    let downwards = last.f > last.f.lit(0);
    for (evaluations, doubling) in (2..).zip(0..i64::from(i32::BITS)) {
        let octaves = 1_i64 << doubling;
        let x = last.x.lit(2).powi(if downwards { -octaves } else { octaves }) * &last.x;
        if !(x.is_finite() && x > x.lit(0)) {
            break;
        }
        let next = Sample::take(x, &mut f)?;
        if let Some(bracket) = Bracket::between(last, next.clone(), evaluations) {
            return Ok(Some(bracket));
        }
        last = next;
    }
    Ok(None)
}

/// The lowest of the zeros that sixteen steps up to the bracket show.
fn first_crossing<R: Special>(bracket: Bracket<R>, mut f: impl FnMut(&R) -> Result<R>) -> Result<Bracket<R>> {
    let mut lower = bracket.lower.x.clone();
    for step in 1..=16 {
        let x = bracket.lower.x.clone().times(step).over(16);
        if f(&x)? > x.lit(0) {
            let lower = if step == 1 { bracket.lower.x.lit(2).powi(-16) * &x } else { lower };
            return Ok(Bracket::new(&lower, &x, f)?.unwrap_or(bracket));
        }
        lower = x;
    }
    Ok(bracket)
}
