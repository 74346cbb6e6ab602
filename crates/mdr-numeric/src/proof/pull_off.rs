//! The pull-off of the Maugis–Dugdale theory over enclosures.
//!
//! With q = √(c² − a²), θ = arccos(a/c) and M(q) = q ∫₀^{π/2} sinψ f(a sinψ)/(q² + a² cos²ψ) dψ the integrals over the ring are
//!
//! * ∫₀^θ (g(c cosφ) − g(a)) dφ = (π/2) f(c) − a M(q) − θ g(a),
//! * ∫₀^θ x g'(x) dφ = (π/2) c f'(c) − (a c²/q) M'(q) − (a/q) g(a), x = c cosφ:
//!
//! in the first the order of the integrals over the ring and in (1.1) is exchanged, and f' integrated by parts; the second is c times
//! its derivative in c. The profile is integrated under the contact alone, so that a kink between a and c does no harm, and all
//! derivatives of both in a and c follow from g(a), g'(a), f(c), f'(c), f''(c) and three integrals.
//!
//! A pull-off is a zero of both conditions of the [theory](crate::dugdale), which the operator of Krawczyk (Computing 4 (1969) 187)
//! encloses, with the sign of a determinant for a minimum. Where f' jumps at the end of the ring, and at a vertical edge, c is
//! known, a a zero of the first condition, and the second has one sign on each side.

use mdr_core::calculus::verify::verify;
use mdr_core::contact::{Error, Result};
use mdr_core::number::{Interval, Real};

use super::continuation::Continuation;
use super::energy::unproved;
use super::fields::moments_at;
use crate::dugdale::{CohesiveState, Dugdale, Ring};

/// The most steps of Newton's method.
const STEPS: usize = 12;
/// A ring ends at a kink if it is so many bits as close to it.
const AT_KINK: i64 = 24;
/// The most heights of the profile for each bit, counted over intervals: about a second at 100 bits.
const MOST: u64 = 500;

/// A contact with a ring of attraction whose pull-off is enclosed.
///
/// ```
/// use std::sync::Arc;
/// use mdr_core::contact::{Control, Expression, Material};
/// use mdr_core::number::{Interval, Precision, Real};
/// use mdr_numeric::{contact::Contact, dugdale::Dugdale, transform::Enclosed};
/// use mdr_numeric::proof::{Continuation, EnclosedPullOff};
/// let (formula, none): (Expression, _) = ("r^2/2".parse()?, Default::default());
/// let precision = Precision::new(100);
/// let [modulus, work, separation] = [1.0, 1e-6, 1e-4].map(|number| Interval::from_f64(precision, number));
/// let formula = || formula.enclosed(&none, &formula.breaks(&none)?, precision);
/// let transform = Arc::new(Enclosed::new(formula()?, precision));
/// let contact = Contact::half_space(&transform, &Material::new(modulus, work)?, &Control::Force);
/// let contact = Dugdale::new(contact, &separation)?;
/// let profile = Continuation::new(vec![formula()?]).expect("no kinks");
/// let state = EnclosedPullOff::new(&contact, &profile).near(0.0120, 0.0196)?;
/// // Between 3/2 πwR and 2πwR.
/// let share = state.force.approx() / -1e-6 / std::f64::consts::PI;
/// assert!(1.5 < share && share < 2.0 && state.force.accuracy_bits() > 80);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct EnclosedPullOff<'a> {
    contact: &'a Dugdale<Interval>,
    profile: &'a Continuation,
}

/// Both conditions at a ring, with their derivatives.
struct Conditions {
    /// The gap at c less h₀, times π/2, and what the slope of the force is a positive multiple of.
    values: [Interval; 2],
    /// Of each, the derivatives in a and in the width of the ring.
    slopes: [[Interval; 2]; 2],
    /// That of the first in c alone, and g'(a) + s a/q: where both are positive the ring grows with the contact.
    senses: [Interval; 2],
}

/// f, r f' and r(r f')' at the end of a ring.
type Heights = [Interval; 3];

impl<'a> EnclosedPullOff<'a> {
    /// A contact on a half-space, and its profile.
    pub fn new(contact: &'a Dugdale<Interval>, profile: &'a Continuation) -> Self {
        EnclosedPullOff { contact, profile }
    }

    /// The minimum of the force along the states that is next to the contact radius and the outer radius of an approximation: it is
    /// proved that there is one in the enclosure, not that no other minimum is lower.
    ///
    /// # Errors
    /// [`Error::Unproved`] if no proof succeeds there: too far from a minimum, too close to where the theory is singular, an integral
    /// that takes too many pieces; errors of the transform.
    pub fn near(&self, contact_radius: f64, outer_radius: f64) -> Result<CohesiveState<Interval>> {
        let number = |value: f64| Interval::from_f64(self.contact.strength().ctx(), value);
        let [a, c] = [number(contact_radius), number(outer_radius)];
        if !(a > a.lit(0) && c > a) {
            return Err(unproved(&a));
        }
        let is_near = |b: &Interval| (c.clone() - b).abs() < c.lit(2).powi(-AT_KINK) * &c;
        if let Some(edge) = self.contact.contact().vertical_edge().filter(is_near) {
            // The last part of the profile ends there.
            let is_last = self.profile.breaks().iter().all(|b| b.upper() < edge.lower());
            return if is_last { self.at_end(&a, &edge, None) } else { Err(unproved(&edge)) };
        }
        if let Some(kink) = self.profile.breaks().iter().position(is_near) {
            let end = self.profile.breaks()[kink].rounded(a.ctx());
            match self.at_end(&a, &end, Some(kink)) {
                Err(Error::Unproved { .. } | Error::Undecided { .. }) => {}
                found => return found,
            }
        }
        self.within(&a, &(c - &a))
    }

    /// Where the profile is smooth at the end of the ring.
    fn within(&self, a: &Interval, width: &Interval) -> Result<CohesiveState<Interval>> {
        let mut centre = [a.midpoint(), width.midpoint()];
        for _ in 0..STEPS {
            let here = self.conditions(&centre)?;
            let inverse = inverse(&here.slopes).ok_or_else(|| unproved(a))?;
            let step = times(&inverse, &here.values);
            if is_small(&step, &centre)
                && let Some(found) = self.krawczyk(&centre, &step, &inverse)?
            {
                return self.contact.state_of(&Ring::new(&found[0], &found[1]));
            }
            for (centre, step) in centre.iter_mut().zip(&step) {
                let next = (centre.clone() - step).midpoint();
                *centre = if next > next.lit(0) { next } else { centre.clone().over(2) };
            }
        }
        Err(unproved(a))
    }

    /// The box that holds one zero of both conditions, at which the force is least; `None` if that is not proved. The step is the
    /// inverse times the values at the centre.
    fn krawczyk(
        &self,
        centre: &[Interval; 2],
        step: &[Interval; 2],
        inverse: &[[Interval; 2]; 2],
    ) -> Result<Option<[Interval; 2]>> {
        let around = [0, 1].map(|i| {
            let rounding = centre[i].unit_roundoff() * &centre[i];
            centre[i].clone().inflate(&(step[i].abs() + rounding).times(2))
        });
        let over = self.conditions(&around)?;
        let mut image = [0, 1].map(|i| centre[i].clone() - &step[i]);
        for (i, image) in image.iter_mut().enumerate() {
            for j in 0..2 {
                let radius = (around[j].clone() - &centre[j]).abs();
                let share = inverse[i][0].clone() * &over.slopes[0][j] + inverse[i][1].clone() * &over.slopes[1][j];
                let rest = share.lit(i64::from(i == j)) - share;
                *image = image.clone().inflate(&(rest.abs() * &radius));
            }
        }
        let within = image
            .iter()
            .zip(&around)
            .all(|(image, around)| around.lower() < image.lower() && image.upper() < around.upper());
        let determinant = determinant(&over.slopes);
        let is_minimum = over.grows() && determinant < determinant.lit(0);
        Ok((within && is_minimum).then_some(image))
    }

    /// Where the ring ends at a kink of the profile, or without one at its vertical edge.
    fn at_end(&self, a: &Interval, end: &Interval, kink: Option<usize>) -> Result<CohesiveState<Interval>> {
        let beyond = kink.unwrap_or(self.profile.breaks().len());
        let ring = |a: &Interval| Ring { c: end.clone(), ..Ring::new(a, &(end.clone() - a)) };
        let inside = self.heights(end, beyond)?;
        let gap = |a: &Interval| Ok(self.of(&ring(a), &inside)?.values[0].clone());
        let slope = |a: &Interval| {
            let [along, across] = self.of(&ring(a), &inside)?.slopes[0].clone();
            Ok(along - across)
        };
        let found = verify(&a.mid(), gap, slope)?.ok_or_else(|| unproved(a))?;
        let ring = ring(&found);
        let before = self.of(&ring, &inside)?;
        let falls = before.grows() && before.values[1] < found.lit(0);
        let rises = match kink {
            Some(kink) => {
                let after = self.of(&ring, &self.heights(end, kink + 1)?)?;
                after.grows() && after.values[1] > found.lit(0)
            }
            None => true,
        };
        if falls && rises { self.contact.state_of(&ring) } else { Err(unproved(&found)) }
    }

    /// f and its derivatives at a radius that lies beyond so many kinks.
    fn heights(&self, c: &Interval, beyond: usize) -> Result<Heights> {
        let f = self.profile.heights(c, 2, beyond).ok_or_else(|| unproved(c))?;
        Ok([f.value().clone(), f.derivative(1), f.derivative(2)])
    }

    /// Both conditions at a ring with this contact radius and width, which does not end at a kink.
    fn conditions(&self, [a, width]: &[Interval; 2]) -> Result<Conditions> {
        let ring = Ring::new(a, width);
        let breaks = self.profile.breaks();
        if !self.profile.reaches(&ring.c) || breaks.iter().any(|b| b.overlaps(&ring.c)) {
            return Err(unproved(&ring.c));
        }
        let heights = self.heights(&ring.c, breaks.partition_point(|b| b.upper() < ring.c.lower()))?;
        self.of(&ring, &heights)
    }

    /// Both conditions, with their derivatives, of a ring at whose end f is known.
    fn of(&self, ring: &Ring<Interval>, [height, rise, bend]: &Heights) -> Result<Conditions> {
        let Ring { a, width, c, leg: q, angle } = ring;
        if !(*a > a.lit(0) && *width > a.lit(0)) || self.profile.work() > MOST * u64::from(a.precision()) {
            return Err(unproved(a));
        }
        let moments = moments_at(self.profile, [a, q], c, 2)?;
        let transform = self.contact.contact().transform();
        let (level, slope, s) = (transform.g(a)?, transform.slope(a)?, self.contact.strength());
        let (quarter, lever) = (a.pi().over(2), a.clone() / q);
        let share = c.square() / q;
        let shape = quarter.clone() * height - moments[0].clone() * a - level.clone() * angle;
        let weighted = quarter.clone() * rise - share.clone() * a * &moments[1] - level.clone() * &lever;
        let gap = shape + self.contact.opening(ring) - self.contact.needed_opening();
        let excess = weighted.clone() - self.contact.pull(ring);
        // In c alone; dq/dc = c/q, dθ/dc = a/(cq).
        let turn = c.clone() / q * angle;
        let gap_by_c = weighted / c + (turn.clone() - width.clone() / c) * s;
        let inner = moments[1].clone().times(2) + share.clone() * (moments[2].clone() - moments[1].clone() / q);
        let excess_by_c = quarter * bend / c - inner * (c.clone() / q) * a + level * &lever * c / q.square()
            - ((turn.clone() * (angle.clone() * q / a + a.lit(1))).times(2) + a.lit(1)) * s;
        // In a alone; dq/da = −a/q, dθ/da = −1/q.
        let rising = slope.clone() + lever.clone() * s;
        let gap_by_a = -(rising.clone() * angle);
        let wide = c.clone() / a * angle;
        let excess_by_a = (wide.square() + (wide * c / q).times(2) + a.lit(1)) * s - lever * slope;
        let slopes = [[gap_by_a + &gap_by_c, gap_by_c.clone()], [excess_by_a + &excess_by_c, excess_by_c]];
        Ok(Conditions { values: [gap, excess], slopes, senses: [gap_by_c, rising] })
    }
}

impl Conditions {
    /// Whether c certainly grows with a along the states.
    fn grows(&self) -> bool {
        self.senses.iter().all(|sense| *sense > sense.lit(0))
    }
}

/// Whether a step is so small that the next one would be below the roundings.
fn is_small(step: &[Interval; 2], centre: &[Interval; 2]) -> bool {
    let share = centre[0].lit(2).powi(-i64::from(centre[0].precision() / 2));
    step.iter().zip(centre).all(|(step, centre)| step.abs() < share.clone() * centre)
}

fn determinant([[a, b], [c, d]]: &[[Interval; 2]; 2]) -> Interval {
    a.clone() * d - b.clone() * c
}

/// An approximate inverse, of numbers; `None` of a matrix that may be singular.
fn inverse(matrix: &[[Interval; 2]; 2]) -> Option<[[Interval; 2]; 2]> {
    let determinant = determinant(matrix);
    if determinant.contains_zero() || !Real::is_finite(&determinant) {
        return None;
    }
    let [[a, b], [c, d]] = matrix.clone();
    Some([[d, -b], [-c, a]].map(|row| row.map(|entry| (entry / &determinant).midpoint())))
}

fn times(matrix: &[[Interval; 2]; 2], vector: &[Interval; 2]) -> [Interval; 2] {
    matrix.each_ref().map(|[left, right]| left.clone() * &vector[0] + right.clone() * &vector[1])
}

#[cfg(test)]
#[path = "../../tests/private/pull_off.rs"]
mod tests;
