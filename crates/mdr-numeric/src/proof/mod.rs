//! Folds and equilibria with a proof of completeness on a stated range of radii.
//!
//! The range is halved until on every cell an enclosure shows that the tangency condition (1.10) has no zero, or that
//! it is monotone and so has at most one. The cost grows with the number of folds, unlike that of a scan, which grows
//! with the ratio of the range to the distance of the closest pair. Between two folds the controlled quantity is
//! monotone, so every equilibrium is a certain sign change: see [`ProvedBranches`].
//!
//! At a kink of g the condition jumps. There the profile itself gives bounds of g' on both sides
//! ([`Transform::kink`](mdr_core::contact::Transform::kink)), which decide whether the kink is a fold and exclude folds
//! beside it.

mod branches;
mod cells;
mod condition;
mod continuation;
mod distant;
mod elsewhere;
mod ends;
mod energy;
mod equator;
mod extrema;
mod fields;
mod floor;
mod found;
mod gaps;
mod kinks;
mod onsets;
mod overlap;
mod pull_off;
mod range;
mod squares;
mod staircase;
mod stretch;

pub use branches::ProvedBranches;
pub use cells::{ProvedCell, Trend};
pub use condition::CurveInDoubles;
pub use continuation::Continuation;
pub use energy::{EnclosedEnergy, StoredEnergy};
pub use extrema::rises_from;
pub use fields::EnclosedFields;
pub use found::ProvedFolds;
pub use gaps::EnclosedGaps;
pub use pull_off::EnclosedPullOff;
pub use range::range;

use std::sync::Arc;

use mdr_core::calculus::isolate::{Behaviour, Effort, isolate_each};
use mdr_core::calculus::verify::verify_with;
use mdr_core::contact::{Error, Fold, FoldKind, Quantity, Result};
use mdr_core::number::{Dual, Interval, Precision, Real, order};
use rug::Float;

use crate::contact::Contact;
use crate::energy::MEDIUM;
use condition::{behaviour, condition, folds_where_level};

/// The most steps of Newton's method towards a zero that is proved then.
const APPROACHES: u32 = 6;

/// A radius is taken as an interval of these shares of it, 2^−k, before it is taken as it is: that costs less.
const AROUND: [i64; 2] = [25, 42];

/// The last bits of a radius that may be unknown after Newton's method has converged.
const SPARE: i64 = 24;

/// What a step of Newton's method may be for the place after it to have half of all digits: a proof begins with another such step.
fn near(place: &Float) -> Float {
    Float::with_val(53, place.abs_ref()) >> (place.prec() / 4)
}

/// Refuses other media than a half-space.
fn check_half_space(contact: &Contact<Interval>) -> Result<()> {
    if contact.medium().is_half_space() {
        return Ok(());
    }
    let requirement = "a half-space, for integrals with a proof";
    Err(Error::Domain { quantity: MEDIUM, value: "another medium".to_owned(), requirement })
}

/// One contact in two arithmetics: enclosures, and enclosures with derivatives.
#[derive(Clone)]
pub struct EnclosedCurve {
    plain: Contact<Interval>,
    dual: Contact<Dual<Interval>>,
    /// The contact in the precision in which folds are enclosed once they are isolated; without it they are in this one.
    fine: Option<Arc<EnclosedCurve>>,
    /// Whether g is an integral, of which few digits cost less than all.
    is_by_integrals: bool,
    /// The contact in doubles, which are asked first.
    in_doubles: Option<CurveInDoubles>,
}

impl EnclosedCurve {
    /// A contact, given over enclosures and over dual numbers of enclosures.
    pub fn new(plain: Contact<Interval>, dual: Contact<Dual<Interval>>) -> Self {
        EnclosedCurve { plain, dual, fine: None, is_by_integrals: false, in_doubles: None }
    }

    /// With the same contact in a higher precision, in which folds are enclosed once this one has isolated them: these are then
    /// [refined](EnclosedCurve::refine) to that precision at once.
    #[must_use]
    pub fn with_fine(self, fine: EnclosedCurve) -> Self {
        EnclosedCurve { fine: Some(Arc::new(fine)), ..self }
    }

    /// With g as an integral: where a sign is asked for, it is looked for in the few digits of an interval around a radius first.
    #[must_use]
    pub fn by_integrals(self) -> Self {
        EnclosedCurve { is_by_integrals: true, ..self }
    }

    /// With the same contact in doubles, which decide what needs few digits: for a profile whose g takes many operations, as a table.
    #[must_use]
    pub fn with_doubles(self, in_doubles: Option<CurveInDoubles>) -> Self {
        EnclosedCurve { in_doubles, ..self }
    }

    /// What doubles know; `None` without them.
    fn ask_doubles<T>(&self, ask: impl FnOnce(&CurveInDoubles) -> Result<Option<T>>) -> Result<Option<T>> {
        self.in_doubles.as_ref().map_or(Ok(None), ask)
    }

    /// The contact over enclosures.
    pub fn plain(&self) -> &Contact<Interval> {
        &self.plain
    }

    /// All folds with radii in (lower, upper), with at most about `budget` evaluations between two kinks. The range
    /// ends with the profile, at its vertical edge or [slightly](EnclosedCurve::octaves_to_equator) before its outer
    /// radius. An end at a kink of g includes the kink.
    ///
    /// # Errors
    /// [`Error::Domain`] unless 0 < lower < upper, unless the range begins before that end of the profile, and unless the
    /// stiffness of a machine is positive and finite; errors of the transform.
    pub fn folds(&self, lower: &Float, upper: &Float, budget: usize) -> Result<ProvedFolds> {
        self.plain.control().check()?;
        if !(*lower > 0 && lower < upper && upper.is_finite()) {
            return Err(Error::domain(Quantity::Radius, upper, "finite and above the lower end of the range, above 0"));
        }
        let range = self.beyond_kinks(lower, upper);
        let (lower, upper) = &range.clone();
        let octaves = self.octaves_to_equator()?;
        let end = self.plain.transform().outer_radius().map(|outer| kinks::shifted(outer.lower(), -1, octaves));
        if end.as_ref().is_some_and(|end| lower >= end) {
            return Err(Error::domain(Quantity::Radius, lower, "below the outer radius of the profile"));
        }
        let mut found = ProvedFolds::on(range);
        let mut from = lower.clone();
        for gap in self.gaps(lower, upper)? {
            self.smooth_part(&from, &gap.before, budget, &mut found)?;
            from = gap.after.clone();
            let around = (gap.before.clone(), gap.after.clone());
            self.gap(gap, &mut found).or_else(|error| found.leave(around, error))?;
        }
        match end {
            Some(end) if from < end => {
                found.range.1 = if end < *upper { end.clone() } else { upper.clone() };
                self.smooth_part(&from, &found.range.1.clone(), budget, &mut found)?;
                if let Some(equator) = self.plain.equator()?.filter(|_| end < *upper)
                    && self.stable_equator(&end)?.is_none()
                {
                    found.undecided.push((end, equator.upper().clone()));
                }
            }
            Some(_) => found.range.1 = from,
            None => self.smooth_part(&from, upper, budget, &mut found)?,
        }
        Ok(found)
    }

    /// The folds between kinks.
    fn smooth_part(&self, lower: &Float, upper: &Float, budget: usize, found: &mut ProvedFolds) -> Result<()> {
        if lower >= upper {
            return Ok(());
        }
        let ends = [lower, upper].map(|end| Interval::point(end.clone()));
        let condition = |a: &Interval| self.signed_condition(a);
        let behaviour = |a: &Interval, b: &Interval| self.behaviour(&a.hull(b));
        let (mut folds, mut merged) = (Vec::new(), Vec::new());
        let effort = self.effort(budget);
        let isolation = isolate_each(&ends[0], &ends[1], &effort, condition, behaviour, |bracket| {
            let cell = bracket.lower.x.hull(&bracket.upper.x);
            match self.fold_in(&cell, bracket.lower.f < bracket.upper.f)? {
                Some(fold) => folds.push(fold),
                None => merged.push((cell.lower().clone(), cell.upper().clone())),
            }
            Ok(())
        });
        let isolation = match isolation {
            Err(error) => return found.leave((lower.clone(), upper.clone()), error),
            Ok(isolation) => isolation,
        };
        folds.sort_by(|one, other| order(&one.contact_radius, &other.contact_radius));
        found.folds.extend(folds);
        found.undecided.extend(merged);
        found.cells.extend(isolation.cells.iter().map(ProvedCell::of));
        let ends = |(a, b): (Interval, Interval)| (a.lower().clone(), b.upper().clone());
        found.undecided.extend(isolation.undecided.into_iter().map(ends));
        found.evaluations += isolation.evaluations;
        found.is_spent |= isolation.is_spent;
        Ok(())
    }

    /// The effort of an isolation. Where g is an integral, something in the profile may be narrower than the root of the unit roundoff, and
    /// cells are halved further.
    fn effort(&self, evaluations: usize) -> Effort<Interval> {
        let like = self.plain.modulus();
        let effort = Effort::of(evaluations, like);
        if !self.is_by_integrals {
            return effort;
        }
        Effort { narrowest: like.unit_roundoff().pow(&like.lit(2).over(3)), ..effort }
    }

    /// The fold in a cell that isolates it, in the finer precision; `None` where that is not proved.
    fn fold_in(&self, cell: &Interval, rises: bool) -> Result<Option<Fold<Interval>>> {
        let fine = self.fine.as_deref().unwrap_or(self);
        let kind = if rises { FoldKind::Minimum } else { FoldKind::Maximum };
        fine.zero(cell)?.map(|radius| fine.state(radius, kind)).transpose()
    }

    /// The fold in the precision of this curve, from an enclosure in a lower precision.
    ///
    /// # Errors
    /// [`Error::Undecided`] if the enclosure of the derivative contains zero; errors of the transform at the fold.
    pub fn refine(&self, fold: &Fold<Interval>) -> Result<Fold<Interval>> {
        if let Some(kink) = self.fold_at_kink(fold)? {
            return Ok(kink);
        }
        if fold.contact_radius.is_point() {
            return self.state(fold.contact_radius.clone(), fold.kind);
        }
        let radius = &fold.contact_radius;
        if radius.ctx() == self.precision() && radius.accuracy_bits() + SPARE >= i64::from(radius.precision()) {
            return Ok(fold.clone());
        }
        match self.zero(radius)? {
            Some(radius) => self.state(radius, fold.kind),
            None => Err(self.undecided("whether the two curves touch once or twice")),
        }
    }

    fn undecided(&self, what: &'static str) -> Error {
        Error::undecided(Quantity::ContactRadius, self.plain.modulus(), what)
    }

    fn precision(&self) -> Precision {
        self.plain.modulus().ctx()
    }

    /// The condition of folds; the entire line if the enclosure leaves the domain of the profile.
    fn condition(&self, a: &Interval) -> Result<Interval> {
        Ok(condition(&self.plain, a)?.unwrap_or_else(|| Interval::entire(a.ctx())))
    }

    /// The condition at a radius, with at least its sign.
    fn signed_condition(&self, a: &Interval) -> Result<Interval> {
        self.ask_doubles(|doubles| doubles.signed_condition(a))?.map_or_else(|| self.signed_in_bits(a), Ok)
    }

    /// The condition at a radius, with at least its sign, without the help of doubles.
    fn signed_in_bits(&self, a: &Interval) -> Result<Interval> {
        if self.is_by_integrals && a.is_point() {
            for share in AROUND {
                let around = a.clone().inflate(&(a.lit(2).powi(-share) * a));
                let rough = self.condition(&around)?;
                if !rough.contains_zero() {
                    return Ok(rough);
                }
            }
        }
        let condition = self.condition(a)?;
        if condition.is_entire() && self.is_by_integrals {
            return Err(Error::unproved(Quantity::TransformedProfile, a, "the profile is not known there"));
        }
        Ok(condition)
    }

    fn folds_where_level(&self) -> bool {
        folds_where_level(&self.plain)
    }

    fn slope(&self, a: &Interval) -> Result<Interval> {
        Ok(self.with_slope(a)?.slope)
    }

    fn with_slope(&self, a: &Interval) -> Result<Dual<Interval>> {
        let unknown = || Interval::entire(a.ctx());
        let known = condition(&self.dual, &Dual::variable(a.clone()))?;
        Ok(known.unwrap_or_else(|| Dual { value: unknown(), slope: unknown() }))
    }

    /// The behaviour on a cell, in doubles if they tell enough.
    fn behaviour(&self, cell: &Interval) -> Result<Behaviour> {
        match self.ask_doubles(|doubles| doubles.behaviour(cell))? {
            Some(known) => Ok(known),
            None => behaviour(Some(self.with_slope(cell)?), cell, |centre| self.signed_in_bits(centre).map(Some)),
        }
    }

    /// The only zero in a cell where the condition is monotone, by bisection followed by interval Newton.
    fn zero(&self, cell: &Interval) -> Result<Option<Interval>> {
        let mut cell = self.promoted(cell);
        // Newton converges from nearly any cell that isolates a simple zero; halving leads to such a cell.
        for _ in 0..cell.precision() {
            let (candidate, slope) = self.approached(&cell)?;
            if let Some(zero) = verify_with(&candidate, &slope, |a| self.condition(a), |a| self.slope(a))?
                && let Some(common) = zero.intersect(&cell)
                && (cell.encloses(&zero) || !self.slope(&zero.hull(&cell))?.contains_zero())
            {
                // The verified zero is that of the cell: it lies within it, or both together contain only one.
                return Ok(Some(common));
            }
            let Some(half) = self.half_with_zero(&cell)? else { return Ok(None) };
            cell = half;
        }
        Ok(None)
    }

    /// A place near the zero in a cell, by steps of Newton's method from its middle until half of the digits are known, and a slope beside
    /// it: a proof takes few evaluations where it succeeds and many where it does not. The middle, where a step leads out of the cell.
    fn approached(&self, cell: &Interval) -> Result<(Float, Interval)> {
        let in_doubles = self.ask_doubles(|doubles| doubles.approached(cell))?;
        let mut place = in_doubles.map_or_else(|| cell.mid(), |place| Float::with_val(cell.precision(), place));
        let mut slope = None;
        for _ in 0..APPROACHES {
            if Float::with_val(53, cell.radius()) <= near(&place) {
                break;
            }
            let at = self.with_slope(&Interval::point(place.clone()))?;
            let step = (at.value / &at.slope).mid();
            slope = Some(at.slope);
            let next = Float::with_val(place.prec(), &place - &step);
            if !cell.contains(&next) {
                place = cell.mid();
                break;
            }
            let is_last = Float::with_val(53, step.abs_ref()) <= near(&next);
            place = next;
            if is_last {
                break;
            }
        }
        let slope = slope.map_or_else(|| self.slope(&Interval::point(place.clone())), Ok)?;
        Ok((place, slope))
    }

    /// An interval in the precision of this curve, or its own if that is larger.
    fn promoted(&self, interval: &Interval) -> Interval {
        interval.rounded(self.precision().max(interval.ctx()))
    }

    fn half_with_zero(&self, cell: &Interval) -> Result<Option<Interval>> {
        let middle = cell.mid();
        let at = |a: &Float| self.signed_condition(&Interval::point(a.clone()));
        let (left, centre) = (at(cell.lower())?, at(&middle)?);
        let zero = centre.lit(0);
        Ok(match (left < zero, centre < zero, centre > zero) {
            (_, false, false) => None,
            (left, centre, _) if left != centre => Some(Interval::new(cell.lower().clone(), middle)),
            _ => Some(Interval::new(middle, cell.upper().clone())),
        })
    }

    fn state(&self, contact_radius: Interval, kind: FoldKind) -> Result<Fold<Interval>> {
        let (indentation, force) = self.plain.state(&contact_radius)?;
        Ok(Fold { contact_radius, indentation, force, kind })
    }
}
