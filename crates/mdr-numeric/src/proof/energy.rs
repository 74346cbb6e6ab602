//! The energy of states over enclosures.
//!
//! Π(a, d) = E*(a d² − 2d ∫₀ᵃ g dx + ∫₀ᵃ g² dx) − πa²w. The integral of g² is [rigorous](mdr_core::calculus::enclose): its nodes
//! take g from the transform, its remainders from the [continuation](super::Continuation) of the profile. From the axis on the
//! variable is a root of the radius, where the profile has fractional powers of it.

use mdr_core::calculus::enclose::{BOUND_BITS, Goal, Sampled, enclose};
use mdr_core::contact::{Control, Error, Quantity, Result, Transform};
use mdr_core::number::{Analytic, Interval, Precision, Real, Rectangle};
use rug::Float;

use super::continuation::{Continuation, Stretch, leg, up};
use super::kinks::at_edge;
use crate::contact::Contact;
use crate::path::ContactState;

/// The most pieces of an integral.
const PIECES: usize = 400;
/// Bits by which the aim of a rule is below the size of the integral.
const SPARE: i32 = 6;
/// Where the integrand is looked at for its size.
const SAMPLES: [f64; 5] = [0.97, 0.71, 0.43, 0.23, 0.05];

/// The energies of the states of a contact on a half-space, as enclosures.
///
/// ```
/// use std::sync::Arc;
/// use mdr_core::contact::{Control, Expression, Material};
/// use mdr_core::number::{Interval, Precision, Real};
/// use mdr_numeric::{contact::Contact, proof::{Continuation, EnclosedEnergy}, transform::Enclosed};
/// let (formula, none): (Expression, _) = ("r^2/2".parse()?, Default::default());
/// let precision = Precision::new(100);
/// let formula = || formula.enclosed(&none, &formula.breaks(&none)?, precision);
/// let (transform, one) = (Arc::new(Enclosed::new(formula()?, precision)), Interval::from_int(precision, 1));
/// let contact = Contact::half_space(&transform, &Material::new(one.clone(), one.clone())?, &Control::Indentation);
/// let profile = Continuation::new(vec![formula()?]).expect("no kinks");
/// // a³d²/a − 2da³/3 + a⁵/5 − πa² at a = d = 1.
/// let energy = EnclosedEnergy::new(&contact, &profile)?.potential(&one, &one)?;
/// assert!((energy.approx() - (8.0 / 15.0 - std::f64::consts::PI)).abs() < 1e-15 && energy.accuracy_bits() > 80);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct EnclosedEnergy<'a> {
    contact: &'a Contact<Interval>,
    profile: &'a Continuation,
}

impl<'a> EnclosedEnergy<'a> {
    /// # Errors
    /// [`Error::Domain`] on another medium than a half-space.
    pub fn new(contact: &'a Contact<Interval>, profile: &'a Continuation) -> Result<Self> {
        super::check_half_space(contact)?;
        Ok(EnclosedEnergy { contact, profile })
    }

    /// Π(a, d), in J.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive; errors of the transform; [`Error::Unproved`] where the integral takes too many pieces.
    pub fn potential(&self, a: &Interval, d: &Interval) -> Result<Interval> {
        let squares = self.squares(std::slice::from_ref(a))?;
        self.with_square(a, d, &squares[0])
    }

    /// What is stored in each of some states, in J: Π, and F²/2k in the spring of a machine; 0 where the surfaces are apart or meet
    /// in a point, `None` for complete contact.
    ///
    /// # Errors
    /// [`EnclosedEnergy::potential`].
    pub fn stored(&self, states: &[&ContactState<Interval>]) -> Result<Vec<Option<StoredEnergy>>> {
        let radii: Vec<Interval> =
            states.iter().filter_map(|state| Some(extended(state)?.contact_radius.clone())).collect();
        let mut squares = self.squares(&radii)?.into_iter();
        let of = |state: &&ContactState<Interval>| match (extended(state), state) {
            (_, ContactState::Complete) => Ok(None),
            (None, _) => Ok(Some(StoredEnergy(None))),
            (Some(rest), _) => {
                let square = squares.next().unwrap_or_else(|| Interval::entire(rest.contact_radius.ctx()));
                let mut energy = self.with_square(&rest.contact_radius, &rest.indentation, &square)?;
                if let Control::Machine { stiffness } = self.contact.control() {
                    energy += &(rest.force.square() / stiffness).over(2);
                }
                Ok(Some(StoredEnergy::from(energy)))
            }
        };
        states.iter().map(of).collect()
    }

    /// Π from ∫₀ᵃ g².
    fn with_square(&self, a: &Interval, d: &Interval, square: &Interval) -> Result<Interval> {
        let mean = self.mean(a)?;
        let elastic = (d.clone() * (d.clone() - mean.times(2)) * a + square) * self.contact.modulus();
        Ok(elastic - a.square() * a.pi() * self.contact.adhesion().work())
    }

    /// (1/a) ∫₀ᵃ g dx. From a kink to a radius that is not told apart from it g changes its mean by its range there at most.
    fn mean(&self, a: &Interval) -> Result<Interval> {
        let beside = match self.contact.transform().mean(a) {
            Err(error @ Error::Domain { .. }) => at_edge(self.contact, a)?.ok_or(error)?,
            mean => return mean,
        };
        let [edge, _, mean] = beside;
        if edge.is_same(a) || self.contact.vertical_edge().is_some_and(|outer_edge| outer_edge.overlaps(a)) {
            return Ok(mean);
        }
        let g = self.profile.range(&a.hull(&edge)).ok_or_else(|| unproved(a))?;
        let change = (g.abs() + mean.abs()) * (a.clone() - &edge).abs() / a;
        Ok(mean.inflate(&change))
    }

    /// ∫₀ᵃ g² dx for each a, in their order.
    ///
    /// # Errors
    /// [`EnclosedEnergy::potential`].
    pub fn squares(&self, radii: &[Interval]) -> Result<Vec<Interval>> {
        let places: Vec<(usize, Interval)> = radii.iter().map(|a| self.place(a)).collect();
        let mut order: Vec<usize> = (0..radii.len()).collect();
        order.sort_by(|&i, &j| places[i].1.mid().total_cmp(&places[j].1.mid()));
        let mut squares = vec![None; radii.len()];
        let Some(first) = radii.first() else { return Ok(Vec::new()) };
        let (mut total, mut from, mut beyond) = (first.lit(0), first.lit(0), 0);
        for index in order {
            Error::require_positive(Quantity::ContactRadius, radii[index].clone())?;
            let (end, to) = &places[index];
            if !self.profile.reaches(to) {
                return Err(unproved(to));
            }
            while beyond < *end {
                let kink = self.profile.breaks()[beyond].rounded(to.ctx());
                if !from.is_same(&kink) {
                    total += &self.square_between(&from, &kink, beyond)?;
                }
                (from, beyond) = (kink, beyond + 1);
            }
            if !from.is_same(to) {
                total += &self.square_between(&from, to, beyond)?;
                from = to.clone();
            }
            squares[index] = Some(total.clone() + self.rest(&radii[index], to)?);
        }
        Ok(squares.into_iter().flatten().collect())
    }

    /// How many kinks lie before a radius, and the radius; a kink itself where it may be on either side of it.
    fn place(&self, a: &Interval) -> (usize, Interval) {
        let breaks = self.profile.breaks();
        let before = breaks.partition_point(|b| b.upper() < a.lower());
        match breaks.get(before) {
            Some(b) if b.lower() <= a.upper() => (before, b.rounded(a.ctx())),
            _ => (before, a.clone()),
        }
    }

    /// ∫ g² from a kink to a radius that is not told apart from it.
    fn rest(&self, a: &Interval, place: &Interval) -> Result<Interval> {
        if a.is_same(place) {
            return Ok(a.lit(0));
        }
        let g = self.profile.range(&a.hull(place)).ok_or_else(|| unproved(a))?;
        // The range has few bits, its width has less.
        Ok((a.clone() - place) * g.square())
    }

    /// ∫ g² between two radii that have so many kinks before them, and none between them.
    fn square_between(&self, from: &Interval, to: &Interval, beyond: usize) -> Result<Interval> {
        let base = beyond.checked_sub(1).map(|last| self.profile.breaks()[last].rounded(to.ctx()));
        let along = |x: &Interval| base.as_ref().map_or_else(|| x.clone(), |b| leg(x, b));
        if let (None, Some(k), true) = (&base, self.profile.root(), from.upper().is_zero()) {
            let square = RootedSquare { transform: self.contact.transform(), profile: self.profile, to, k };
            return over_unit_interval(&square, to.precision()).map_err(|error| located(error, to));
        }
        let start = along(from);
        let length = along(to) - &start;
        let stretch = Stretch { profile: self.profile, beyond, base, from: start, length };
        let square = Square { transform: self.contact.transform(), stretch };
        over_unit_interval(&square, to.precision()).map_err(|error| located(error, to))
    }
}

/// The energy stored in a state, or a sum of such, in J: exactly nothing where all its terms are.
#[derive(Clone, Debug, Default)]
pub struct StoredEnergy(Option<Interval>);

impl From<Interval> for StoredEnergy {
    fn from(energy: Interval) -> Self {
        StoredEnergy(Some(energy))
    }
}

impl StoredEnergy {
    /// The sum, `None` where it is exactly nothing.
    pub fn energy(&self) -> Option<&Interval> {
        self.0.as_ref()
    }

    /// The sum with the terms of another one.
    #[must_use]
    pub fn plus(self, other: &StoredEnergy) -> StoredEnergy {
        StoredEnergy(match (self.0, &other.0) {
            (Some(one), Some(other)) => Some(one + other),
            (one, other) => one.or_else(|| other.clone()),
        })
    }

    /// The sum without the terms of another one.
    #[must_use]
    pub fn minus(self, other: &StoredEnergy) -> StoredEnergy {
        self.plus(&StoredEnergy(other.0.clone().map(|energy| -energy)))
    }
}

/// The equilibrium, if the surfaces are in contact on more than a point.
fn extended(state: &ContactState<Interval>) -> Option<&mdr_core::contact::Equilibrium<Interval>> {
    state.contact().filter(|rest| !rest.contact_radius.upper().is_zero())
}

/// g² dx/dt.
struct Square<'a> {
    transform: &'a dyn Transform<Interval>,
    stretch: Stretch<'a>,
}

impl Square<'_> {
    fn of<T: Analytic>(&self, g: &T, [v, x]: &[T; 2]) -> Option<Vec<T>> {
        let square = g.squared().scaled(&self.stretch.length);
        Some(vec![if self.stretch.base.is_some() { square.product(v).quotient(x)? } else { square }])
    }
}

impl Sampled for Square<'_> {
    fn values(&self, t: &Interval) -> Result<Option<Vec<Interval>>> {
        let Some(place) = self.stretch.at(t) else { return Ok(None) };
        Ok(self.of(&self.transform.g(&place[1])?, &place))
    }

    fn image(&self, t: &Rectangle) -> Option<Vec<Rectangle>> {
        let place = self.stretch.at(t)?;
        let Stretch { profile, beyond, base, .. } = &self.stretch;
        let legs = profile.legs(&place[1], *beyond, base.as_ref().map(|_| &place[0]))?;
        self.of(&profile.g(&place[1], &legs)?, &place)
    }

    fn range(&self, t: &Interval) -> Option<Vec<Interval>> {
        let place = self.stretch.over(t)?;
        self.of(&self.stretch.profile.range(&place[1])?, &place)
    }
}

/// g² dx/dt up to a radius x₁ from the axis, where g is analytic as a function of q = x^(1/k) alone: x = x₁tᵏ.
struct RootedSquare<'a> {
    transform: &'a dyn Transform<Interval>,
    profile: &'a Continuation,
    to: &'a Interval,
    k: u32,
}

impl RootedSquare<'_> {
    fn of<T: Analytic>(&self, g: &T, t: &T) -> Option<Vec<T>> {
        let slope = t.raised(i64::from(self.k) - 1)?.product(&t.integer(i64::from(self.k)));
        Some(vec![g.squared().product(&slope).scaled(self.to)])
    }

    /// From the formula.
    fn by_formula<T: Analytic>(&self, t: &T) -> Option<Vec<T>> {
        let order = self.to.lit(1).over(i64::from(self.k));
        self.of(&self.profile.g_at_root(&t.scaled(&self.to.pow(&order)))?, t)
    }
}

impl Sampled for RootedSquare<'_> {
    fn values(&self, t: &Interval) -> Result<Option<Vec<Interval>>> {
        Ok(self.of(&self.transform.g(&(t.powi(i64::from(self.k)) * self.to))?, t))
    }

    fn image(&self, t: &Rectangle) -> Option<Vec<Rectangle>> {
        self.by_formula(t)
    }

    fn range(&self, t: &Interval) -> Option<Vec<Interval>> {
        self.by_formula(t)
    }
}

/// The integral of one function from 0 to 1.
pub(super) fn over_unit_interval(f: &impl Sampled, bits: u32) -> Result<Interval> {
    Ok(all_over_unit_interval(f, bits)?.swap_remove(0))
}

/// The integrals of several functions from 0 to 1.
pub(super) fn all_over_unit_interval(f: &impl Sampled, bits: u32) -> Result<Vec<Interval>> {
    let precision = Precision::new(bits);
    let mut sizes: Vec<Float> = Vec::new();
    for t in SAMPLES {
        let t = Interval::from_f64(precision, t);
        let values = f.values(&t)?.unwrap_or_default();
        sizes.resize(sizes.len().max(values.len()), Float::new(BOUND_BITS));
        for (size, value) in sizes.iter_mut().zip(values) {
            size.max_mut(&up(value.abs().upper()));
        }
    }
    if sizes.is_empty() {
        sizes.push(Float::new(BOUND_BITS));
    }
    let aim = Float::with_val(BOUND_BITS, Float::i_exp(1, SPARE - bits as i32));
    let tolerance = |size: Float| if size.is_zero() { aim.clone() } else { size * &aim };
    let goal = Goal { bits, tolerances: sizes.into_iter().map(tolerance).collect(), pieces: PIECES };
    let ends = [Float::new(BOUND_BITS), Float::with_val(BOUND_BITS, 1)];
    enclose(f, [&ends[0], &ends[1]], &goal)
}

/// An integral that no number of bits makes easier.
pub(super) fn located(error: Error, at: &Interval) -> Error {
    match error {
        Error::Undecided { quantity: Quantity::Integral, .. } => unproved(at),
        error => error,
    }
}

pub(super) fn unproved(at: &Interval) -> Error {
    let [from, to] = [at.lower(), at.upper()].map(|end| end.to_string_radix(10, Some(17)));
    let remedy = "an integral up to there takes too many pieces";
    Error::Unproved { quantity: Quantity::Integral, from, to, remedy }
}

#[cfg(test)]
#[path = "../../tests/private/rigorous.rs"]
pub(super) mod tests;
