//! The energy of states over enclosures.
//!
//! Π(a, d) = ½S(d² − 2d·ḡ + q) − Aw, with the means ḡ of g and q of g² over the springs. Where the transform has no closed form of q, and on
//! a half-space, where it is (1/a)∫₀ᵃ g² dx, the integral over the springs is [rigorous](mdr_core::calculus::enclose): its nodes take g from the transform,
//! its remainders from the [continuation](super::Continuation) of the profile. From the axis on the variable is a root of the radius, where
//! the profile has fractional powers of it.

use mdr_core::calculus::enclose::{BOUND_BITS, Goal, Sampled, enclose};
use mdr_core::contact::{Control, Error, Quantity, Result};
use mdr_core::number::{Interval, Precision, Real};
use rug::Float;

use super::continuation::Continuation;
use super::kinks::at_edge;
use super::squares::SquareIntegral;
use super::stretch::up;
use crate::contact::Contact;
use crate::energy::MEDIUM;
use crate::path::ContactState;

/// The most pieces of an integral.
const PIECES: usize = 400;
/// Bits by which the aim of a rule is below the size of the integral.
const SPARE: i32 = 6;
/// Where the integrand is looked at for its size.
pub(super) const SAMPLES: [f64; 5] = [0.97, 0.71, 0.43, 0.23, 0.05];

/// The energies of the states of a contact as enclosures: on a half-space, and where the mean of g² has a
/// [closed form](mdr_core::contact::Transform::mean_square).
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
    /// ∫g²; `None` where the mean of g² is a closed form.
    integral: Option<SquareIntegral<'a>>,
}

impl<'a> EnclosedEnergy<'a> {
    /// By the integral of g² over the springs: of a half-space, which may be graded, or a Winkler foundation, with the profile
    /// [on the same medium](Continuation::on).
    ///
    /// # Errors
    /// [`Error::Domain`] on another medium, and where the profile is on another medium than the contact.
    pub fn new(contact: &'a Contact<Interval>, profile: &'a Continuation) -> Result<Self> {
        if !profile.is_on(contact.medium()) {
            let requirement = "the one on which the profile is continued, for integrals with a proof";
            return Err(Error::Domain { quantity: MEDIUM, value: "another medium".to_owned(), requirement });
        }
        Ok(EnclosedEnergy { contact, integral: Some(SquareIntegral { contact, profile }) })
    }

    /// By the closed form of the mean of g², which the transform has: that of powers on a graded half-space or a Winkler foundation, and of
    /// Johnson's wave.
    ///
    /// ```
    /// use mdr_core::contact::Control;
    /// use mdr_core::number::{Interval, Precision, Real};
    /// use mdr_numeric::contact::Contact;
    /// use mdr_numeric::medium::{Adhesion, Medium};
    /// use mdr_numeric::proof::EnclosedEnergy;
    /// use mdr_numeric::transform::Powers;
    /// let number = |text: &str| Interval::from_literal(Precision::new(100), &text.parse().expect("a number"));
    /// let (ball, springs) = (Powers::winkler([(number("2"), number("0.5"))])?, Medium::winkler(number("3"))?);
    /// let contact = Contact::new(ball, springs, Adhesion::new(number("0.1"))?, Control::Indentation);
    /// let energy = EnclosedEnergy::closed(&contact).potential(&number("0.4"), &number("0.2"))?;
    /// // (K/2)∫(d − r²/2)² 2πr dr − πa²w.
    /// let pi = std::f64::consts::PI;
    /// let by_hand = 3.0 * pi * (0.2 * 0.2 * 0.08 - 0.2 * 0.0064 + 0.4f64.powi(6) / 24.0) - pi * 0.016;
    /// assert!((energy.approx() / by_hand - 1.0).abs() < 1e-14 && energy.accuracy_bits() > 80);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    pub fn closed(contact: &'a Contact<Interval>) -> Self {
        EnclosedEnergy { contact, integral: None }
    }

    /// Π(a, d), in J.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive; errors of the transform; [`Error::Unproved`] where the integral takes too many pieces.
    pub fn potential(&self, a: &Interval, d: &Interval) -> Result<Interval> {
        let mut squares = self.mean_squares(std::slice::from_ref(a))?;
        self.with_square(a, d, &squares.swap_remove(0))
    }

    /// dF/dd along the equilibria at a, in N/m.
    ///
    /// # Errors
    /// [`Error::Undecided`] where it is not certain that the state is no fold of the indentation; errors of the transform.
    pub fn stiffness(&self, a: &Interval) -> Result<Interval> {
        super::fields::stiffness(self.contact, a)
    }

    /// What is stored in each of some states, in J: Π, and F²/2k in the spring of a machine; 0 where the surfaces are apart or meet
    /// in a point, `None` for complete contact.
    ///
    /// # Errors
    /// [`EnclosedEnergy::potential`].
    pub fn stored(&self, states: &[&ContactState<Interval>]) -> Result<Vec<Option<StoredEnergy>>> {
        let radii: Vec<Interval> =
            states.iter().filter_map(|state| Some(extended(state)?.contact_radius.clone())).collect();
        let mut squares = self.mean_squares(&radii)?.into_iter();
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

    /// What complete contact stores at a value of the control, per area, all of which adheres: Π, and k(D − d)²/2 in the spring of a machine
    /// per area. `None` where the transform [has none](mdr_core::contact::Transform::complete_contact).
    pub fn complete_contact(&self, value: &Interval) -> Option<StoredEnergy> {
        let [depth, stored] = self.contact.transform().complete_contact()?;
        let mut energy = stored * self.contact.modulus() - self.contact.adhesion().work();
        if let Control::Machine { stiffness } = self.contact.control() {
            energy += &((value.clone() - depth).square() * stiffness).over(2);
        }
        Some(StoredEnergy::from(energy))
    }

    /// Π from the mean of g².
    fn with_square(&self, a: &Interval, d: &Interval, square: &Interval) -> Result<Interval> {
        let mean = self.mean(a)?;
        let stored = (d.clone() * (d.clone() - mean.times(2)) + square) * self.contact.stiffness(a);
        Ok(stored.over(2) - self.contact.medium().area(a) * self.contact.adhesion().work())
    }

    /// The mean of g over the springs. From a kink to a radius that is not told apart from it g changes its mean by its range there at most.
    fn mean(&self, a: &Interval) -> Result<Interval> {
        let beside = match (self.contact.transform().mean(a), &self.integral) {
            (Err(error @ Error::Domain { .. }), Some(integral)) => (at_edge(self.contact, a)?.ok_or(error)?, integral),
            (mean, _) => return mean,
        };
        let ([edge, _, mean], SquareIntegral { profile, .. }) = beside;
        if edge.is_same(a) || self.contact.vertical_edge().is_some_and(|outer_edge| outer_edge.overlaps(a)) {
            return Ok(mean);
        }
        let g = profile.range(&a.hull(&edge)).ok_or_else(|| unproved(a))?;
        let change = (g.abs() + mean.abs()) * (a.clone() - &edge).abs() / a;
        Ok(mean.inflate(&change))
    }

    /// The mean of g² over the springs for each a, in their order.
    fn mean_squares(&self, radii: &[Interval]) -> Result<Vec<Interval>> {
        if let Some(integral) = &self.integral {
            return integral.means(radii);
        }
        let without = || {
            let requirement = "one whose mean of g² is a closed form";
            Error::Domain { quantity: Quantity::TransformedProfile, value: "another one".to_owned(), requirement }
        };
        let square = |a: &Interval| self.contact.transform().mean_square(a).ok_or_else(without)?;
        radii.iter().map(square).collect()
    }

    /// ∫₀ᵃ g² dx for each a, in their order, on a half-space.
    ///
    /// # Errors
    /// [`Error::Domain`] for an energy by closed forms or on another medium, or unless each a is positive; errors of the transform;
    /// [`Error::Unproved`] where an integral takes too many pieces.
    pub fn squares(&self, radii: &[Interval]) -> Result<Vec<Interval>> {
        super::check_half_space(self.contact)?;
        let none = || Error::Domain {
            quantity: Quantity::Integral,
            value: "of an energy by closed forms".to_owned(),
            requirement: "one by integrals",
        };
        self.integral.as_ref().ok_or_else(none)?.up_to(radii)
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
    let aim = relative_aim(bits);
    let tolerance = |size: Float| if size.is_zero() { aim.clone() } else { size * &aim };
    aiming_at(f, bits, sizes.into_iter().map(tolerance).collect())
}

/// The integrals of several functions from 0 to 1, with rules whose errors aim at some tolerances.
pub(super) fn aiming_at(f: &impl Sampled, bits: u32, tolerances: Vec<Float>) -> Result<Vec<Interval>> {
    let goal = Goal { bits, tolerances, pieces: PIECES };
    let ends = [Float::new(BOUND_BITS), Float::with_val(BOUND_BITS, 1)];
    enclose(f, [&ends[0], &ends[1]], &goal)
}

/// The error of a rule to aim at, beside the size of an integral.
pub(super) fn relative_aim(bits: u32) -> Float {
    Float::with_val(BOUND_BITS, Float::i_exp(1, SPARE - bits as i32))
}

/// An integral that no number of bits makes easier.
pub(super) fn located(error: Error, at: &Interval) -> Error {
    match error {
        Error::Undecided { quantity: Quantity::Integral, .. } => unproved(at),
        error => error,
    }
}

pub(super) fn unproved(at: &Interval) -> Error {
    Error::unproved(Quantity::Integral, at, "an integral up to there takes too many pieces")
}
