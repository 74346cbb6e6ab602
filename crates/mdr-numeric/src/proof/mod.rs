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
use mdr_core::calculus::verify::verify;
use mdr_core::contact::{Error, Fold, FoldKind, Quantity, Result};
use mdr_core::number::{Dual, Interval, Precision, Real, order};
use rug::Float;

use crate::contact::Contact;
use crate::energy::MEDIUM;

/// The most steps of Newton's method towards a zero that is proved then.
const APPROACHES: u32 = 6;

/// A radius is taken as an interval of these shares of it, 2^−k, before it is taken as it is: that costs less.
const AROUND: [i64; 2] = [25, 42];

/// The last bits of a radius that may be unknown after Newton's method has converged.
const SPARE: i64 = 8;

/// What a step of Newton's method may be for the next one to lead to a zero with nearly all digits.
fn near(place: &Float) -> Float {
    Float::with_val(53, place.abs_ref()) >> (place.prec() / 2)
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
}

impl EnclosedCurve {
    /// A contact, given over enclosures and over dual numbers of enclosures.
    pub fn new(plain: Contact<Interval>, dual: Contact<Dual<Interval>>) -> Self {
        EnclosedCurve { plain, dual, fine: None, is_by_integrals: false }
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

    /// The tangency ratio minus its critical value: positive where equilibria are stable, zero at a fold. The entire
    /// line if the enclosure leaves the domain of the profile.
    fn condition(&self, a: &Interval) -> Result<Interval> {
        match self.plain.tangency(a) {
            Err(Error::Domain { .. }) => Ok(Interval::entire(a.ctx())),
            ratio => Ok(self.holding(ratio?) - self.plain.critical_ratio_at(a)),
        }
    }

    /// The condition at a radius, with at least its sign.
    fn signed_condition(&self, a: &Interval) -> Result<Interval> {
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

    /// The tangency ratio, but −1 where g' = 0 on all of a cell and folds are where g' = 0: a flat is neutral there, and surfaces touch without
    /// holding.
    fn holding(&self, ratio: Interval) -> Interval {
        if ratio == ratio.lit(0) && self.folds_where_level() { ratio.lit(-1) } else { ratio }
    }

    /// Whether folds are where g' = 0: at an edge without adhesion, and on a Winkler foundation at fixed grips, where Δl is constant.
    fn folds_where_level(&self) -> bool {
        let like = self.plain.modulus();
        self.plain.critical_ratio_at(&like.lit(1)) == like.lit(0)
    }

    fn slope(&self, a: &Interval) -> Result<Interval> {
        Ok(self.with_slope(a)?.slope)
    }

    fn with_slope(&self, a: &Interval) -> Result<Dual<Interval>> {
        let a = Dual::variable(a.clone());
        match self.dual.tangency(&a) {
            Err(Error::Domain { .. }) => {
                let unknown = Interval::entire(a.ctx());
                Ok(Dual { value: unknown.clone(), slope: unknown })
            }
            ratio => {
                let ratio = ratio?;
                let ratio = Dual { value: self.holding(ratio.value), ..ratio };
                Ok(ratio - self.dual.critical_ratio_at(&a))
            }
        }
    }

    /// The behaviour on a cell by its enclosure, either direct or in the mean-value form f(m) + f'(cell)(cell − m).
    fn behaviour(&self, cell: &Interval) -> Result<Behaviour> {
        let over_cell = self.with_slope(cell)?;
        if !over_cell.value.contains_zero() {
            return Ok(Behaviour::Nonzero);
        }
        if !over_cell.slope.is_finite() {
            return Ok(Behaviour::Unknown);
        }
        // Before another evaluation: what is monotone needs none.
        if !over_cell.slope.contains_zero() {
            return Ok(Behaviour::Monotone);
        }
        let centre = Interval::point(cell.mid());
        let mean_value = self.signed_condition(&centre)? + over_cell.slope * (cell.clone() - &centre);
        Ok(if mean_value.contains_zero() { Behaviour::Unknown } else { Behaviour::Nonzero })
    }

    /// The only zero in a cell where the condition is monotone, by bisection followed by interval Newton.
    fn zero(&self, cell: &Interval) -> Result<Option<Interval>> {
        let mut cell = self.promoted(cell);
        // Newton converges from nearly any cell that isolates a simple zero; halving leads to such a cell.
        for _ in 0..cell.precision() {
            let candidate = self.approached(&cell)?;
            if let Some(zero) = verify(&candidate, |a| self.condition(a), |a| self.slope(a))?
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

    /// A place near the zero in a cell, by steps of Newton's method from its middle until half of the digits are known: a proof takes six
    /// evaluations where it succeeds and twice as many where it does not. The middle, where a step leads out of the cell.
    fn approached(&self, cell: &Interval) -> Result<Float> {
        let mut place = cell.mid();
        for _ in 0..APPROACHES {
            if Float::with_val(53, cell.radius()) <= near(&place) {
                break;
            }
            let at = self.with_slope(&Interval::point(place.clone()))?;
            let step = (at.value / &at.slope).mid();
            let next = Float::with_val(place.prec(), &place - &step);
            if !cell.contains(&next) {
                return Ok(cell.mid());
            }
            let is_last = Float::with_val(53, step.abs_ref()) <= near(&next);
            place = next;
            if is_last {
                break;
            }
        }
        Ok(place)
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
