//! Pressure, displacement and gap over enclosures.
//!
//! Outside the contact the order of two integrals is exchanged: with f for g the displacement has one, whose kernel is smooth up to
//! the edge, c² = r² − a²,
//!
//! u(r) = (2/π) \[d arcsin(a/r) − a c ∫₀^{π/2} sinθ f(a sinθ)/(r² − a² sin²θ) dθ\],
//!
//! and the gap is f(r) − d + u(r). In it the inner integral ∫ₛᵃ x dx/√((r² − x²)(x² − s²)) = arctan(√(a² − s²)/c) was done, and f'
//! integrated by parts. Within the contact
//!
//! p(r) = (E*/π) \[∫ᵣᵃ g'(x)/√(x² − r²) dx − (g(a) − d)/√(a² − r²)\]
//!
//! is integrated over √(x² − r²), beyond a kink b over √(x² − b²).

use mdr_core::calculus::enclose::{Integrand, Sampled};
use mdr_core::contact::{Equilibrium, Error, Quantity, Result, Transform};
use mdr_core::number::{Analytic, Ends, Interval, Precision, Real, Rectangle, Special};

use super::continuation::Continuation;
use super::energy::{all_over_unit_interval, located, over_unit_interval, unproved};
use super::kinks::at_edge;
use super::stretch::{Stretch, leg};
use crate::contact::Contact;
use crate::transform::is_moderate;

/// The radius, over that of the contact, up to which g' is looked at for a tip where the pressure is infinite.
const NEAR_TIP: i64 = 1 << 20;

/// Pressure, displacement and gap of a state on a half-space, as enclosures.
///
/// ```
/// use std::sync::Arc;
/// use mdr_core::contact::{Control, Equilibrium, Expression, Material, Stability};
/// use mdr_core::number::{Interval, Precision, Real};
/// use mdr_numeric::{contact::Contact, proof::{Continuation, EnclosedFields}, transform::Enclosed};
/// let (formula, none): (Expression, _) = ("r^2/2".parse()?, Default::default());
/// let precision = Precision::new(100);
/// let formula = || formula.enclosed(&none, &formula.breaks(&none)?, precision);
/// let (transform, one) = (Arc::new(Enclosed::new(formula()?, precision)), Interval::from_int(precision, 1));
/// let contact = Contact::half_space(&transform, &Material::new(one.clone(), one.clone())?, &Control::Indentation);
/// let profile = Continuation::new(vec![formula()?]).expect("no kinks");
/// let (indentation, force) = contact.state(&one)?;
/// let state = Equilibrium { contact_radius: one.clone(), indentation, force, stability: Stability::Stable };
/// let pressure = EnclosedFields::new(&contact, &profile, &state)?.pressure(&one.lit(0))?;
/// // JKR: p(0) = 2E*a/πR − √(2E*w/πa).
/// let ratio = std::f64::consts::FRAC_2_PI;
/// assert!((pressure.approx() - (ratio - ratio.sqrt())).abs() < 1e-15 && pressure.accuracy_bits() > 80);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct EnclosedFields<'a> {
    contact: &'a Contact<Interval>,
    profile: &'a Continuation,
    a: Interval,
    d: Interval,
    /// g(a) − d.
    edge: Interval,
}

impl<'a> EnclosedFields<'a> {
    /// # Errors
    /// [`Error::Domain`] on another medium than a half-space, and unless the contact radius is positive; errors of the transform.
    pub fn new(
        contact: &'a Contact<Interval>,
        profile: &'a Continuation,
        state: &Equilibrium<Interval>,
    ) -> Result<Self> {
        super::check_half_space(contact)?;
        let a = Error::require_positive(Quantity::ContactRadius, state.contact_radius.clone())?;
        if !profile.reaches(&a) || profile.breaks().iter().any(|b| b.overlaps(&a)) {
            return Err(unproved(&a));
        }
        let edge = if contact.vertical_edge().is_some_and(|outer_edge| outer_edge.overlaps(&a)) {
            let [_, g, _] = at_edge(contact, &a)?.ok_or_else(|| unproved(&a))?;
            g - &state.indentation
        } else {
            contact.elongation(&a)
        };
        Ok(EnclosedFields { contact, profile, a, d: state.indentation.clone(), edge })
    }

    /// The fields of a state in which the edge is pinned between two works of adhesion: its elongation is g(a) − d.
    ///
    /// # Errors
    /// [`EnclosedFields::new`].
    pub fn pinned(
        contact: &'a Contact<Interval>,
        profile: &'a Continuation,
        state: &Equilibrium<Interval>,
    ) -> Result<Self> {
        let fields = Self::new(contact, profile, state)?;
        let edge = contact.transform().g(&fields.a)? - &fields.d;
        Ok(EnclosedFields { edge, ..fields })
    }

    /// The precision of the enclosures.
    pub fn precision(&self) -> Precision {
        self.a.ctx()
    }

    /// dF/dd along the equilibria, in N/m.
    ///
    /// # Errors
    /// [`Error::Undecided`] where it is not certain that the state is no fold of the indentation; errors of the transform.
    pub fn stiffness(&self) -> Result<Interval> {
        stiffness(self.contact, &self.a)
    }

    /// The displacement u(r) at r > a, in m, positive into the half-space.
    ///
    /// # Errors
    /// [`Error::Domain`] unless r > a; [`Error::Unproved`] where an integral takes too many pieces.
    pub fn displacement(&self, r: &Interval) -> Result<Interval> {
        let a = &self.a;
        if !(r > a && Real::is_finite(r)) {
            return Err(Error::domain(Quantity::Radius, r, "finite and outside the contact, r > a"));
        }
        let c = leg(r, a);
        let integral = moments(self.profile, a, r, 0)?.swap_remove(0);
        let held = self.d.clone() * Special::atan(&(a.clone() / &c));
        Ok((held - integral * a).times(2) / a.pi())
    }

    /// The gap at r > a, in m.
    ///
    /// # Errors
    /// [`Error::Domain`] unless r > a and within the profile; [`EnclosedFields::displacement`].
    pub fn gap(&self, r: &Interval) -> Result<Interval> {
        let outer = self.contact.transform().outer_radius();
        if outer.as_ref().is_some_and(|outer| r > outer) {
            return Err(Error::domain(Quantity::Radius, r, "within the profile"));
        }
        let outside = self.displacement(r)?;
        if !self.profile.reaches(r) || outer.is_some_and(|outer| r.upper() >= outer.lower()) {
            return Err(unproved(r));
        }
        let breaks = self.profile.breaks();
        let first = breaks.partition_point(|b| b.upper() < r.lower());
        let last = breaks.partition_point(|b| b.lower() <= r.upper());
        // f is continuous: at a kink it is in both parts.
        let heights = (first..=last).map(|beyond| self.profile.height(r, beyond).ok_or_else(|| unproved(r)));
        let mut heights = heights.collect::<Result<Vec<_>>>()?.into_iter();
        let one = heights.next().ok_or_else(|| unproved(r))?;
        let height = heights.fold(one, |hull, other| hull.hull(&other));
        Ok(height - &self.d + outside)
    }

    /// Whether a radius cannot be told from that of a kink of the profile.
    pub fn is_at_kink(&self, r: &Interval) -> bool {
        self.profile.breaks().iter().any(|b| b.overlaps(r))
    }

    /// The pressure p(r) at 0 ≤ r < a, in Pa; negative is tension.
    ///
    /// # Errors
    /// [`Error::Domain`] unless 0 ≤ r < a, and at a tip or a kink where the pressure is infinite; [`Error::Unproved`] at any other
    /// kink, and where an integral takes too many pieces.
    pub fn pressure(&self, r: &Interval) -> Result<Interval> {
        let a = &self.a;
        let zero = r.lit(0);
        if !(*r >= zero && r < a) {
            return Err(Error::domain(Quantity::Radius, r, "within the contact, 0 <= r < a"));
        }
        let breaks = self.profile.breaks();
        if let Some(kink) = breaks.iter().position(|b| b.overlaps(r)) {
            if self.profile.jumps(kink, r) {
                let apart = "told apart from a kink of the profile, where the pressure is infinite";
                return Err(Error::domain(Quantity::Radius, r, apart));
            }
            return Err(unproved(r));
        }
        let at_tip = r.upper().is_zero();
        if at_tip && self.is_infinite_at_tip() {
            return Err(Error::domain(Quantity::Radius, r, "off a tip or an edge where the pressure is infinite"));
        }
        let is_flat = at_tip && self.profile.is_flat_at_tip(a.ctx());
        let before = breaks.partition_point(|b| b.upper() < r.lower());
        let inside = breaks.partition_point(|b| b.upper() < a.lower());
        let mut bulk = zero.clone();
        for beyond in before..=inside {
            let to = if beyond < inside { breaks[beyond].rounded(a.ctx()) } else { a.clone() };
            let kink = (beyond > before).then(|| breaks[beyond - 1].rounded(a.ctx()));
            let base = kink.as_ref().or((!at_tip).then_some(r)).cloned();
            let length = base.as_ref().map_or_else(|| to.clone(), |base| leg(&to, base));
            let stretch = Stretch { profile: self.profile, beyond, base, from: zero.clone(), length };
            let rest = kink.as_ref().map(|kink| (kink.clone() - r) * (kink.clone() + r));
            let load = Load { transform: self.contact.transform(), stretch, rest, is_flat };
            bulk += &over_unit_interval(&load, a.precision()).map_err(|error| located(error, r))?;
        }
        Ok((bulk - self.edge.clone() / leg(a, r)) / a.pi() * self.contact.modulus())
    }

    /// Whether g' is certainly of one sign, and not near 0, next to the tip.
    fn is_infinite_at_tip(&self) -> bool {
        let near = self.a.clone().over(NEAR_TIP);
        self.profile.stretch_from_tip(&near).is_some_and(|slope| !slope.contains_zero())
    }
}

/// dF/dd along the equilibria of a contact.
pub(super) fn stiffness(contact: &Contact<Interval>, a: &Interval) -> Result<Interval> {
    if contact.vertical_edge().is_some_and(|outer_edge| outer_edge.overlaps(a)) {
        return Ok(contact.stiffness(a));
    }
    let open = || Error::undecided(Quantity::ContactRadius, a, "whether the state is a fold of the indentation");
    contact.stiffness_along(a)?.filter(Real::is_finite).ok_or_else(open)
}

/// The moments at the leg c of a radius r > a, c² = r² − a²: see [`moments_at`].
///
/// # Errors
/// Errors of [`moments_at`].
pub(super) fn moments(profile: &Continuation, a: &Interval, r: &Interval, order: usize) -> Result<Vec<Interval>> {
    moments_at(profile, [a, &leg(r, a)], r, order)
}

/// dᵏ/dcᵏ c ∫₀^{π/2} sinθ f(a sinθ)/(c² + a² cos²θ) dθ for k from 0 to `order` ≤ 2, at c > 0. A contact may end at a kink, to as
/// many bits as that is known.
///
/// # Errors
/// [`Error::Unproved`], with the radius that is asked for, where an integral takes too many pieces.
pub(super) fn moments_at(
    profile: &Continuation,
    [a, c]: [&Interval; 2],
    asked: &Interval,
    order: usize,
) -> Result<Vec<Interval>> {
    let breaks = profile.breaks();
    let inside = breaks.partition_point(|b| b.upper() < a.lower());
    let angle = |b: &Interval| Special::asin(&(b.rounded(a.ctx()) / a));
    let quarter = a.pi().over(2);
    let at_edge = breaks.get(inside).filter(|b| b.overlaps(a));
    let last = at_edge.map_or_else(|| quarter.clone(), |b| last_before(b, a));
    let ends = breaks[..inside].iter().map(angle).chain([last.clone()]);
    let (mut from, mut sums) = (a.lit(0), vec![a.lit(0); order + 1]);
    let kernel = |beyond: usize, from: &Interval, to: &Interval| {
        let (from, width) = (from.clone(), to.clone() - from);
        Kernel { profile, a, c, order, beyond, from, width }
    };
    for (beyond, to) in ends.enumerate() {
        let parts = all_over_unit_interval(&kernel(beyond, &from, &to), a.precision());
        let parts = parts.map_err(|error| located(error, asked))?;
        sums.iter_mut().zip(&parts).for_each(|(sum, part)| *sum += part);
        from = to;
    }
    if at_edge.is_some() {
        // Either part of f, up to the edge.
        let all = a.lit(0).hull(&a.lit(1));
        let [before, after] = [inside, inside + 1].map(|beyond| kernel(beyond, &last, &quarter).at(&all));
        let (Some(before), Some(after)) = (before, after) else { return Err(unproved(asked)) };
        sums.iter_mut().zip(before.iter().zip(&after)).for_each(|(sum, (one, other))| *sum += &one.hull(other));
    }
    Ok(sums)
}

/// An angle up to which a sinθ is below a kink b that cannot be told apart from a.
fn last_before(b: &Interval, a: &Interval) -> Interval {
    let share = Interval::point(b.lower().clone()).rounded(a.ctx()) / Interval::point(a.upper().clone());
    let angle = Special::asin(&Interval::point(share.lower().clone()).lesser(&a.lit(1)));
    Interval::point(angle.lower().clone())
}

/// sinθ f(a sinθ) dθ/dt times derivatives of c/(c² + a² cos²θ): with A = a² cos²θ these are (A − c²)/(c² + A)² and
/// 2c(c² − 3A)/(c² + A)³.
pub(super) struct Kernel<'a> {
    pub(super) profile: &'a Continuation,
    pub(super) a: &'a Interval,
    pub(super) c: &'a Interval,
    pub(super) order: usize,
    pub(super) beyond: usize,
    pub(super) from: Interval,
    pub(super) width: Interval,
}

impl Integrand for Kernel<'_> {
    fn is_moderate(&self) -> bool {
        is_moderate(self.a) && is_moderate(self.c)
    }

    fn at<T: Analytic>(&self, t: &T) -> Option<Vec<T>> {
        let (sine, cosine) = t.scaled(&self.width).plus(&t.constant(&self.from)).sin_cos();
        let height = self.profile.heights(&sine.scaled(self.a), 0, self.beyond)?;
        let height = height.value().product(&sine).scaled(&self.width);
        let (c, across) = (t.constant(self.c), cosine.scaled(self.a).squared());
        let square = c.squared();
        let far = square.plus(&across);
        let mut values = vec![height.product(&c).quotient(&far)?];
        if self.order > 0 {
            values.push(height.product(&across.minus(&square)).quotient(&far.squared())?);
        }
        if self.order > 1 {
            let above = square.minus(&across.product(&t.integer(3)));
            let above = above.product(&c).product(&t.integer(2));
            values.push(height.product(&above).quotient(&far.squared().product(&far))?);
        }
        Some(values)
    }
}

/// g' dx/dt/√(x² − r²).
struct Load<'a> {
    transform: &'a dyn Transform<Interval>,
    stretch: Stretch<'a>,
    /// b² − r², if the piece begins at a kink b.
    rest: Option<Interval>,
    /// Whether the piece begins at the axis, where g'/x is analytic.
    is_flat: bool,
}

impl Load<'_> {
    /// dg/dv, and beside a kink over √(v² + b² − r²), else over x.
    fn of<T: Analytic>(&self, slope: &T, [v, x]: &[T; 2]) -> Option<Vec<T>> {
        let distance = match &self.rest {
            Some(rest) => v.squared().plus(&v.constant(rest)).sqrt()?,
            None => x.clone(),
        };
        Some(vec![slope.quotient(&distance)?.scaled(&self.stretch.length)])
    }

    /// Around the axis g'/x = h/x² is analytic, and nowhere larger than on the boundary.
    fn around_axis<I: Ends>(&self, x: &Rectangle<I>) -> Option<Vec<Rectangle<I>>> {
        let rise = self.stretch.profile.first_rise(x)?;
        let size = |z: &Rectangle<I>| Real::sqrt(&(z.re().abs().square() + z.im().abs().square()));
        let ([left, right], [_, top]) = (x.re().ends(), x.im().ends());
        let nearest = left.abs().lesser(&right.abs()).lesser(&top.abs());
        let length = I::around(x.re().ctx(), &self.stretch.length);
        let bound = (size(&rise) / nearest.square()).abs() * length.abs();
        if !Real::is_finite(&bound) {
            return None;
        }
        let all = bound.lit(0).inflate(&bound);
        Some(vec![Rectangle::new(all.clone(), all)])
    }
}

impl Sampled for Load<'_> {
    fn values(&self, t: &Interval) -> Result<Option<Vec<Interval>>> {
        let Some(place) = self.stretch.at(t) else { return Ok(None) };
        let slope = self.transform.slope(&place[1])?;
        let slope = if self.rest.is_some() { slope * &place[0] / &place[1] } else { slope };
        Ok(self.of(&slope, &place))
    }

    fn image<I: Ends>(&self, t: &Rectangle<I>) -> Option<Vec<Rectangle<I>>> {
        let place = self.stretch.at(t)?;
        if self.is_flat && self.stretch.base.is_none() && place[1].re().has_zero() {
            return self.around_axis(&place[1]);
        }
        let profile = self.stretch.profile;
        let legs = profile.legs(&place[1], self.stretch.beyond, self.rest.as_ref().map(|_| &place[0]))?;
        self.of(&profile.slope(&place[1], &legs, self.rest.is_some())?, &place)
    }

    fn is_moderate(&self) -> bool {
        self.stretch.is_moderate() && self.rest.as_ref().is_none_or(is_moderate)
    }

    fn range(&self, _: &Interval) -> Option<Vec<Interval>> {
        None
    }
}
