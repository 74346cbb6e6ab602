//! Gaps outside contacts on a half-space, open or closed, over enclosures: a proof for each state that is asked for.

use std::sync::Arc;

use mdr_core::contact::{Budget, Result};
use mdr_core::number::Interval;
use rug::Float;

use super::continuation::Continuation;
use super::elsewhere::{HEIGHTS, ONE_LOOK, Seen};
use super::floor::Floor;
use super::overlap::{Outside, Place};
use super::staircase::{Bounded, Staircases, State, TERMS_OF_HEIGHT};
use super::{CurveInDoubles, EnclosedCurve};
use crate::admissible::GapVerdict;
use crate::contact::Contact;
use crate::recent::Recent;

/// Why nothing is said of a state whose gap is not enclosed closely enough.
const NOT_DECIDED: &str = "enclosures of the gap outside the contact do not decide it";

/// Recent verdicts that are kept: outputs ask of the same states, and of one in several precisions.
const KEPT: usize = 64;

/// A contact on a half-space, with its profile as formulas, from which the gap outside any state is enclosed. Without them it is
/// known where g rises.
///
/// ```
/// use std::sync::Arc;
/// use mdr_core::contact::{Control, Expression, Material};
/// use mdr_core::number::{Interval, Precision, Real};
/// use mdr_numeric::{contact::Contact, proof::{Continuation, EnclosedGaps}, transform::Enclosed};
/// // Waves of 10 mm on a paraboloid of 1 m: a contact on the first crest reaches the next crest when it is pressed deep.
/// let formula: Expression = "r^2/2 + 0.01*(1 - cos(20*pi*r))".parse()?;
/// let (none, precision) = (Default::default(), Precision::new(64));
/// let formula = || formula.enclosed(&none, &formula.breaks(&none)?, precision);
/// let transform = Arc::new(Enclosed::new(formula()?, precision));
/// let number = |x: f64| Interval::from_f64(precision, x);
/// let contact = Contact::half_space(&transform, &Material::new(number(1.0), number(1e-6))?, &Control::Indentation);
/// let gaps = EnclosedGaps::new(contact.clone(), Continuation::new(vec![formula()?]))?;
/// let [shallow, deep] = [number(0.01), number(0.03)];
/// assert!(gaps.are_open(&shallow, &contact.indentation(&shallow)?));
/// assert!(gaps.is_closed(&deep, &contact.indentation(&deep)?, 0.1));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct EnclosedGaps {
    contact: Contact<Interval>,
    profile: Option<Continuation>,
    /// The budget from which heights are paid, and what each costs.
    budget: Option<(Arc<Budget>, u64)>,
    kept: Recent<(Place, GapVerdict)>,
    /// In place of integrals over the profile.
    staircases: Option<Staircases>,
    /// The minima of d, for where integrals over the profile take long.
    floor: Option<Floor>,
}

impl EnclosedGaps {
    /// # Errors
    /// [`Error::Domain`](mdr_core::contact::Error::Domain) on another medium than a half-space.
    pub fn new(contact: Contact<Interval>, profile: Option<Continuation>) -> Result<Self> {
        super::check_half_space(&contact)?;
        Ok(EnclosedGaps { contact, profile, budget: None, kept: Recent::up_to(KEPT), staircases: None, floor: None })
    }

    /// The gaps, with a budget from which each height of the profile is paid by its `weight`; once it is spent nothing is decided.
    #[must_use]
    pub fn within(self, budget: &Arc<Budget>, weight: u64) -> Self {
        EnclosedGaps { budget: Some((Arc::clone(budget), weight)), ..self }
    }

    /// The gaps from bounds of g on cells, without integrals over f: for a profile of many pieces whose g is quick, as a table. A gap
    /// that is all but closed is then left undecided. Bounds are those of the contact in doubles, where it is given.
    #[must_use]
    pub fn by_staircases(self, in_doubles: Option<&CurveInDoubles>) -> Self {
        let in_bits = || Bounded::InBits(Arc::clone(self.contact.shared_transform()));
        let bounded =
            in_doubles.map_or_else(in_bits, |curve| Bounded::InDoubles(Arc::clone(curve.plain().shared_transform())));
        let range = |radii: &Interval| self.profile.as_ref()?.range(radii);
        EnclosedGaps { staircases: Some(Staircases::new(bounded, range)), ..self }
    }

    /// The gaps, with the folds of this contact at fixed grips on a range of radii, which are looked for where integrals over f take long:
    /// for a profile of which something is narrow. They take at most about `most` evaluations between two kinks.
    #[must_use]
    pub fn with_folds(self, curve: EnclosedCurve, range: (Float, Float), most: usize) -> Self {
        EnclosedGaps { floor: Some(Floor::new(curve, range, most)), ..self }
    }

    /// Whether a contact of radius a at the indentation d is admissible, as far as it is proved: no gap outside it is negative up to
    /// the end of the profile, or the gap at some radius is.
    pub fn verdict(&self, a: &Interval, d: &Interval) -> GapVerdict {
        let transform = self.contact.transform();
        if transform.rises_beyond(a) && transform.g(a).is_ok_and(|g| g.lower() >= d.upper()) {
            return GapVerdict::Admissible;
        }
        let place = Place { a: a.clone(), d: d.clone() }.rough();
        if let Some(known) = self.known(&place) {
            return known;
        }
        let is_limited = self.heights() < HEIGHTS;
        let verdict = match &self.staircases {
            Some(staircases) => self.above(staircases, &place),
            None => self.outside(&place),
        };
        if is_limited && matches!(verdict, GapVerdict::Undecided(_)) {
            // A larger budget may decide more.
            return verdict;
        }
        self.kept.keep((place, verdict));
        verdict
    }

    /// The verdict by integrals over f.
    fn outside(&self, place: &Place) -> GapVerdict {
        match self.spending(place, |outside, place| outside.look_everywhere(place)) {
            Some(Seen::Open) => GapVerdict::Admissible,
            Some(Seen::Closed { radius, gap }) => GapVerdict::Interpenetrating { radius, gap },
            _ => GapVerdict::Undecided(NOT_DECIDED),
        }
    }

    /// The verdict by bounds of g.
    fn above(&self, staircases: &Staircases, place: &Place) -> GapVerdict {
        if self.heights() == 0 {
            return GapVerdict::Undecided(NOT_DECIDED);
        }
        let (are_open, terms) = staircases.are_open(State::of(place));
        if let Some((budget, weight)) = &self.budget {
            budget.spend(weight.saturating_mul(terms / TERMS_OF_HEIGHT));
        }
        if are_open { GapVerdict::Admissible } else { GapVerdict::Undecided(NOT_DECIDED) }
    }

    /// The verdict on a place that holds this one, or that no verdict was found for one that is nearly this.
    fn known(&self, place: &Place) -> Option<GapVerdict> {
        self.kept.find(|(other, verdict)| {
            let holds = match verdict {
                GapVerdict::Undecided(_) => place.overlaps(other),
                GapVerdict::Admissible | GapVerdict::Interpenetrating { .. } => place.is_within(other),
            };
            holds.then_some(*verdict)
        })
    }

    /// The most heights of f for one look at the gap of a state. The verdict on it is the last that is proved.
    fn heights(&self) -> u64 {
        let left = |(budget, weight): &(Arc<Budget>, u64)| Some(budget.left_for_last_proof()? / (*weight).max(1));
        let [parts, of] = ONE_LOOK;
        self.budget.as_ref().and_then(left).map_or(HEIGHTS, |left| (left / of * parts).min(HEIGHTS))
    }

    /// Whether it is proved that no gap outside a contact of radius a at the indentation d is negative, up to the end of the
    /// profile.
    pub fn are_open(&self, a: &Interval, d: &Interval) -> bool {
        self.verdict(a, d) == GapVerdict::Admissible
    }

    /// Whether it is proved that the gap at a radius is negative, so that the surfaces overlap there.
    pub fn is_closed(&self, a: &Interval, d: &Interval, r: f64) -> bool {
        self.overlap(a, d, r).is_some()
    }

    /// The gap at a radius, if it is proved that it is negative.
    pub fn overlap(&self, a: &Interval, d: &Interval, r: f64) -> Option<f64> {
        let place = Place { a: a.clone(), d: d.clone() }.rough();
        let by_bounds = |staircases: &Staircases| staircases.overlap(State::of(&place), r);
        if let Some(gap) = self.staircases.as_ref().and_then(by_bounds) {
            return Some(gap);
        }
        self.spending(&place, |outside, place| outside.overlap(place, r))?
    }

    /// What `look` sees outside a contact, with its heights paid from the budget; `None` if it sees nothing, or the budget is spent.
    fn spending<T>(&self, place: &Place, look: impl FnOnce(&Outside<'_>, &Place) -> Result<T>) -> Option<T> {
        let profile = self.profile.as_ref()?;
        let heights = self.heights();
        if heights == 0 {
            return None;
        }
        let before = profile.work();
        let outside = Outside { heights, floor: self.floor.as_ref(), ..Outside::new(&self.contact, profile) };
        let seen = look(&outside, place);
        if let Some((budget, weight)) = &self.budget {
            budget.spend(weight.saturating_mul(profile.work().saturating_sub(before)));
        }
        seen.ok()
    }
}
