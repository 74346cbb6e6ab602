//! Equilibria with a proof of completeness: at most one on each branch between proved folds.

use std::cmp::Ordering;
use std::sync::{Arc, OnceLock};

use mdr_core::calculus::roots::{self, Bracket, Sample};
use mdr_core::contact::{Control, Equilibrium, Error, Fold, FoldKind, Quantity, Result, Stability};
use mdr_core::number::{Dual, Interval, Real};
use rug::Float;
use rug::float::Round;

use super::overlap::Outside;
use super::{Continuation, EnclosedCurve, ProvedFolds, kinks};
use crate::admissible::{self, Admissibility, Basis, GapVerdict, Ring, Touch};
use crate::branch::{self, EquilibriumBranches, FirstContact};

/// Radii that are looked at beside those where a state is expected.
const STEPS_BESIDE: usize = 6;

/// Where admissibility is lost, before it is proved, relative to the contact radius.
const ROUGHLY: f64 = 1e-3;

/// The branches of a contact over enclosures, between folds that are proved to be complete in their range.
///
/// A branch contains an equilibrium if the value certainly lies between those of the controlled quantity at its two
/// ends. On the range the list of equilibria is therefore complete and correct; if an order is not certain the result
/// is [`Error::Undecided`], and more bits may decide. The value may itself be an enclosure, as that of a fold is: the
/// result then holds for every number in it. Beyond the range, equilibria are searched outwards; one that is found
/// certainly exists, but there may be more.
pub struct ProvedBranches {
    pub(super) curve: EnclosedCurve,
    /// Includes poles.
    folds: Vec<Fold<Interval>>,
    range: (Float, Float),
    pub(super) edge: Option<VerticalEdge>,
    /// The equator, if no fold lies between the range and it.
    pub(super) equator: Option<Interval>,
    /// Whether equilibria are looked for below the range, and above it.
    is_open: [bool; 2],
    admissibility: OnceLock<Arc<Admissibility>>,
    profile: Option<Continuation>,
}

/// The vertical edge, with the mean of g and the controlled quantity of the state in which the contact just reaches it.
pub(super) struct VerticalEdge {
    radius: Interval,
    mean: Interval,
    controlled: Interval,
}

/// An end of a branch: an enclosure of it, the end of the enclosure from which the branch is searched, and the sign of
/// the controlled quantity minus its prescribed value.
struct End {
    enclosure: Interval,
    radius: Interval,
    excess: Interval,
}

impl ProvedBranches {
    /// The branches between folds that were proved in the precision of `curve` or in a lower one.
    ///
    /// # Errors
    /// [`Error::Unproved`] with the first part of the range that was not decided; [`Error::Undecided`] if a fold cannot be
    /// refined; errors of the transform at a fold. See [`EnclosedCurve::refine`].
    pub fn new(curve: EnclosedCurve, proved: &ProvedFolds) -> Result<Self> {
        if let Some((from, to)) = proved.undecided.first() {
            let [from, to] = [(from, Round::Down), (to, Round::Up)]
                .map(|(end, outwards)| end.to_string_radix_round(10, Some(4), outwards));
            let remedy = "raise the precision or the budget, or narrow the range of radii";
            return Err(Error::Unproved { quantity: Quantity::ContactRadius, from, to, remedy });
        }
        let mut folds = proved.folds.iter().map(|fold| curve.refine(fold)).collect::<Result<Vec<_>>>()?;
        folds.extend(proved.poles.iter().cloned());
        folds.sort_by(|one, other| one.contact_radius.lower().total_cmp(other.contact_radius.lower()));
        let edge = curve.vertical_edge()?.filter(|edge| proved.range.1 >= *edge.radius.lower());
        let equator = curve.stable_equator(&proved.range.1)?;
        let (range, admissibility, is_open) = (proved.range.clone(), OnceLock::new(), [true; 2]);
        Ok(ProvedBranches { curve, folds, range, edge, equator, is_open, admissibility, profile: None })
    }

    /// The branches of each [part](ProvedFolds::decided_parts) of a range of which something is undecided. On a part its equilibria are
    /// complete; they are looked for beyond it only where it ends with the range.
    ///
    /// # Errors
    /// [`Error::Undecided`] if a fold cannot be refined; errors of the transform at a fold. See [`ProvedBranches::new`].
    pub fn of_parts(curve: &EnclosedCurve, proved: &ProvedFolds) -> Result<Vec<Self>> {
        let of = |part: &ProvedFolds| {
            let is_open = [part.range.0 == proved.range.0, part.range.1 == proved.range.1];
            Ok(ProvedBranches { is_open, ..Self::new(curve.clone(), part)? })
        };
        proved.decided_parts().iter().map(of).collect()
    }

    /// Sets the admissibility, which is otherwise searched when needed.
    pub fn with_admissibility(self, admissibility: Arc<Admissibility>) -> Self {
        ProvedBranches { admissibility: OnceLock::from(admissibility), ..self }
    }

    /// Sets the profile, with which the loss of admissibility is proved on a half-space.
    pub fn with_profile(self, profile: Continuation) -> Self {
        ProvedBranches { profile: Some(profile), ..self }
    }

    /// What lies outside a contact, where gaps can be enclosed.
    fn outside(&self, radius: f64) -> Result<Outside<'_>> {
        let contact = &self.curve.plain;
        let profile = self.profile.as_ref().filter(|_| contact.medium().is_half_space());
        profile.map(|profile| Outside::new(contact, profile)).ok_or_else(|| not_enclosed(radius))
    }

    /// The range of radii on which [all equilibria](EquilibriumBranches::equilibria) are found; some beyond it are also reported.
    pub fn range(&self) -> &(Float, Float) {
        &self.range
    }

    fn controlled(&self, fold: &Fold<Interval>) -> Interval {
        self.control().controlled(&fold.indentation, &fold.force)
    }

    /// The end of a branch at a fold. At the value of the fold the sign is the same on both sides.
    fn at_fold(&self, fold: &Fold<Interval>, radius: &Float, value: &Interval) -> Result<End> {
        let enclosure = fold.contact_radius.clone();
        let radius = self.curve.promoted(&Interval::point(radius.clone()));
        if !fold.indentation.is_finite() {
            let End { excess, .. } = self.at_radius(radius.clone(), value)?;
            let zero = excess.lit(0);
            let agrees = if fold.kind == FoldKind::Minimum { excess < zero } else { excess > zero };
            let near = || self.curve.undecided("where exactly the equilibrium lies beside an edge where g is infinite");
            // Between the edge and this radius the direction has one sign.
            return if agrees { Ok(End { enclosure: radius.clone(), radius, excess }) } else { Err(near()) };
        }
        let excess = match self.compare(value, fold)? {
            Ordering::Equal if fold.kind == FoldKind::Minimum => value.lit(1),
            Ordering::Equal => value.lit(-1),
            _ => self.controlled(fold) - value,
        };
        Ok(End { enclosure, radius, excess })
    }

    /// The end on a flat that just touches, where the direction is exactly 0 and folds are where g' = 0: the sign beside the fold at its end.
    fn at_flat(&self, end: End) -> End {
        let zero = end.excess.lit(0);
        if end.excess == zero && self.curve.folds_where_level() { End { excess: zero.lit(1), ..end } } else { end }
    }

    /// The sign at a radius that is not a fold.
    fn at_radius(&self, radius: Interval, value: &Interval) -> Result<End> {
        let excess = self.direction(&radius, value)?;
        Ok(End { enclosure: radius.clone(), radius, excess })
    }

    /// The [direction of change](crate::contact::Contact::direction); if a point is not certainly on one side of a kink, more
    /// bits are needed.
    fn direction(&self, a: &Interval, value: &Interval) -> Result<Interval> {
        match self.curve.plain.direction_at(a, value) {
            Err(Error::Domain { .. }) => Err(self.curve.undecided("on which side of a kink a radius lies")),
            direction => direction,
        }
    }

    /// The two ends of a branch.
    fn ends(&self, branch: usize, value: &Interval) -> Result<[End; 2]> {
        let promoted = |end: &Float| self.curve.promoted(&Interval::point(end.clone()));
        let below = branch.checked_sub(1).and_then(|index| self.folds.get(index));
        let lower = match below {
            Some(fold) => self.at_fold(fold, fold.contact_radius.upper(), value)?,
            None => self.at_flat(self.at_radius(promoted(&self.range.0), value)?),
        };
        let upper = match (self.folds.get(branch), &self.edge) {
            (Some(fold), _) => self.at_fold(fold, fold.contact_radius.lower(), value)?,
            (None, Some(edge)) => {
                let radius = promoted(edge.radius.lower());
                End { enclosure: edge.radius.clone(), radius, excess: edge.controlled.clone() - value }
            }
            (None, None) => self.at_radius(promoted(&self.range.1), value)?,
        };
        Ok([lower, upper])
    }

    /// The contact at the vertical edge, if it is pressed beyond the state that just reaches it.
    fn at_vertical_edge(&self, value: &Interval) -> Result<Option<Equilibrium<Interval>>> {
        let Some(edge) = &self.edge else { return Ok(None) };
        match value.partial_cmp(&edge.controlled) {
            None => Err(self.curve.undecided("whether the contact reaches the vertical edge")),
            Some(Ordering::Less | Ordering::Equal) => Ok(None),
            Some(Ordering::Greater) => {
                let curve = &self.curve.plain;
                let d = curve.held_against(&edge.radius, value, || Ok(edge.mean.clone()))?;
                let force = curve.stiffness(&edge.radius) * (d.clone() - &edge.mean);
                Ok(Some(self.equilibrium(edge.radius.clone(), d, force, value, Stability::Stable)))
            }
        }
    }

    /// The controlled one of d and F is taken from its prescribed value, which is more accurate.
    pub(super) fn equilibrium(
        &self,
        contact_radius: Interval,
        indentation: Interval,
        force: Interval,
        value: &Interval,
        stability: Stability,
    ) -> Equilibrium<Interval> {
        Equilibrium { contact_radius, indentation, force, stability }.controlled(self.control(), value.clone())
    }

    /// The equilibrium between two radii with opposite directions of change.
    fn between(&self, [lower, upper]: [End; 2], value: &Interval) -> Result<Equilibrium<Interval>> {
        let grows_below = lower.excess < lower.excess.lit(0);
        let sample = |end: &End| Sample { x: end.radius.clone(), f: end.excess.clone() };
        let Some(bracket) = Bracket::between(sample(&lower), sample(&upper), 0) else {
            return Err(self.curve.undecided("which way the contact moves at the ends of a branch"));
        };
        let direction = |a: &Interval| self.direction(a, value);
        let root = roots::refine(bracket, &value.unit_roundoff(), direction)?;
        // No sample lies within the enclosure of an end itself.
        let first = if root.lower == lower.radius { lower.enclosure } else { root.lower };
        let last = if root.upper == upper.radius { upper.enclosure } else { root.upper };
        let radius = self.narrowed(first.hull(&last), value)?;
        let (d, force) = self.curve.plain.state(&radius)?;
        let stability = if grows_below { Stability::Stable } else { Stability::Unstable };
        Ok(self.equilibrium(radius, d, force, value, stability))
    }

    /// The enclosure after steps of the interval Newton operator, as long as they more than halve it and the slope has a certain sign.
    ///
    /// The search for a sign change may leave one of its ends far away.
    fn narrowed(&self, mut radius: Interval, value: &Interval) -> Result<Interval> {
        let held = Dual::constant(value.clone());
        loop {
            let middle = radius.midpoint();
            let at_middle = self.direction(&middle, value)?;
            let slope = match self.curve.dual.direction_at(&Dual::variable(radius.clone()), &held) {
                Err(Error::Domain { .. }) => return Ok(radius),
                direction => direction?.slope,
            };
            let Some(narrower) = (middle - at_middle / slope).intersect(&radius) else { return Ok(radius) };
            let width = |set: &Interval| Float::with_val(set.upper().prec(), set.upper() - set.lower());
            let (before, after) = (width(&radius), width(&narrower));
            radius = narrower;
            if after.is_zero() || !(after * 2u32 <= before) {
                return Ok(radius);
            }
        }
    }

    /// The equilibrium of a branch beside two radii, if the direction of change has opposite signs at two radii near them.
    fn beside(&self, branch: usize, value: &Interval, near: [&Interval; 2]) -> Result<Option<Equilibrium<Interval>>> {
        let below = branch.checked_sub(1).map_or(&self.range.0, |index| self.folds[index].contact_radius.upper());
        let above = match (self.folds.get(branch), &self.edge) {
            (Some(fold), _) => fold.contact_radius.lower(),
            (None, Some(edge)) => edge.radius.lower(),
            (None, None) => &self.range.1,
        };
        let is_inside = |radius: &Interval| radius.lower() > below && radius.upper() < above;
        let [mut last, other] = near.map(|radius| self.curve.promoted(&radius.midpoint()));
        let mut step = last.clone() - &other;
        let mut ends: Option<End> = None;
        for _ in 0..STEPS_BESIDE {
            if !is_inside(&last) {
                return Ok(None);
            }
            let next = self.at_radius(last.clone(), value)?;
            let Some(sign) = next.excess.partial_cmp(&value.lit(0)).filter(|sign| sign.is_ne()) else {
                return Ok(None);
            };
            match ends {
                Some(first) if (first.excess < value.lit(0)) != sign.is_lt() => {
                    let ends = if first.radius < next.radius { [first, next] } else { [next, first] };
                    return self.between(ends, value).map(Some);
                }
                // The contact grows towards a stable state: the first steps tell which way to go on.
                Some(_) => step = step.times(4),
                None if sign.is_lt() != (step > value.lit(0)) => step = -step,
                None => {}
            }
            last = (next.radius.clone() + &step).midpoint();
            ends = Some(next);
        }
        Ok(None)
    }

    /// The last end visited from a given one, and the next if its direction of change is opposite.
    fn walk(&self, mut last: End, steps: impl Iterator<Item = Interval>, value: &Interval) -> (End, Option<End>) {
        let zero = value.lit(0);
        let growing = last.excess < zero;
        for radius in steps {
            let Ok(next) = self.at_radius(radius, value) else { break };
            if next.excess.partial_cmp(&zero).is_none_or(Ordering::is_eq) {
                continue;
            }
            if (next.excess < zero) != growing {
                return (last, Some(next));
            }
            last = next;
        }
        (last, None)
    }

    /// The equilibrium beyond the range, on the last branch.
    fn outwards(&self, upper: End, value: &Interval) -> Result<Option<Equilibrium<Interval>>> {
        let grows = upper.excess < value.lit(0);
        match (self.walk(upper, self.above(), value), &self.equator) {
            ((last, Some(next)), _) => self.between([last, next], value).map(Some),
            ((last, None), Some(equator)) if grows => self.before_equator(&last.radius, equator, value).map(Some),
            ((last, None), None) if grows && branch::end(&self.curve.plain)? == branch::End::Unknown => {
                Err(branch::beyond_reach(self.control(), &last.radius))
            }
            _ => Ok(None),
        }
    }

    /// Radii below the range: 2^−1, 2^−2, 2^−4, … of its lower end.
    fn below(&self) -> impl Iterator<Item = Interval> {
        let lower = Interval::point(self.range.0.clone());
        octaves().map(move |octave| self.curve.promoted(&(lower.lit(2).powi(-octave) * &lower)))
    }

    /// Radii above the range: 2^1, 2^2, 2^4, … times its upper end, or ever closer to the end of the profile.
    fn above(&self) -> impl Iterator<Item = Interval> {
        let upper = self.curve.promoted(&Interval::point(self.range.1.clone()));
        let outer = self.curve.plain.transform().outer_radius();
        let bits = i64::from(self.curve.precision().bits());
        let finest = move |octave: &i64| outer.is_none() || *octave < bits - i64::from(kinks::FINEST);
        let outer = self.curve.plain.transform().outer_radius();
        octaves().take_while(finest).map(move |octave| match &outer {
            Some(outer) => {
                let step = outer.lit(2).powi(-octave - i64::from(kinks::FINEST)) * outer;
                (outer.clone() - step).midpoint()
            }
            None => upper.lit(2).powi(octave) * &upper,
        })
    }
}

/// 1, 2, 4, … to 2²⁰, far beyond the exponent range of double precision.
fn octaves() -> impl Iterator<Item = i64> {
    (0..=20).map(|power| 1 << power)
}

impl EquilibriumBranches<Interval> for ProvedBranches {
    fn control(&self) -> &Control<Interval> {
        self.curve.plain.control()
    }

    fn is_same(&self, one: &Interval, other: &Interval) -> bool {
        one.is_same(other)
    }

    fn tip_value(&self, like: &Interval) -> Interval {
        self.curve.plain.tip_value(like)
    }

    fn is_pushed_back(&self, radius: &Interval, value: &Interval) -> Result<bool> {
        self.curve.plain.is_pushed_back(radius, value)
    }

    fn verdict(&self, state: &Equilibrium<Interval>) -> Result<GapVerdict> {
        let verdict = self.admissibility().decided(&state.contact_radius, &state.indentation);
        let is_open = matches!(verdict, GapVerdict::Undecided(_)) && self.admissibility().basis() == Basis::Proved;
        if is_open { Err(self.curve.undecided("whether a state is admissible")) } else { Ok(verdict) }
    }

    /// In double precision: evidence, not proof, unless it has enclosures of the gap.
    fn admissibility(&self) -> &Admissibility {
        let search = || Arc::new(Admissibility::rounded(&self.curve.plain, &self.folds));
        self.admissibility.get_or_init(search)
    }

    fn first_touch(&self) -> Result<Option<Touch<Interval>>> {
        if let Some(touch) = admissible::proved_touch(self.admissibility(), self.curve.precision()) {
            return Ok(Some(touch));
        }
        match admissible::first_touch_roughly(self.admissibility())? {
            None => Ok(None),
            Some([radius, _]) => Err(not_enclosed(radius)),
        }
    }

    fn last_admissible(&self, [from, to]: [&Interval; 2]) -> Result<Option<(Equilibrium<Interval>, Ring<Interval>)>> {
        let outside = self.outside(to.approx())?;
        let open = || self.curve.undecided("in which state admissibility is lost");
        let ends = [from, to].map(Interval::approx);
        let Some(rough) = admissible::lost_roughly(&self.curve.plain, self.admissibility(), ends, ROUGHLY)? else {
            let verdict = self.admissibility().of(ends[0], self.curve.plain.indentation(from)?.approx());
            let GapVerdict::Interpenetrating { radius, .. } = verdict else { return Err(open()) };
            return if outside.overlaps(from, radius)? { Ok(None) } else { Err(open()) };
        };
        let (state, ring) = outside.last_admissible(rough)?;
        if *from < state.contact_radius && state.contact_radius < *to { Ok(Some((state, ring))) } else { Err(open()) }
    }

    fn folds(&self) -> &[Fold<Interval>] {
        &self.folds
    }

    fn onset(&self) -> Result<FirstContact> {
        branch::onset(&self.curve.plain, self.folds.first())
    }

    fn end(&self) -> Result<branch::End<Interval>> {
        match branch::end(&self.curve.plain)? {
            branch::End::Unknown => Err(branch::beyond_reach(self.control(), self.curve.plain.modulus())),
            end => Ok(end),
        }
    }

    fn on_branch_near(
        &self,
        branch: usize,
        value: &Interval,
        near: [&Interval; 2],
    ) -> Result<Option<Equilibrium<Interval>>> {
        match self.beside(branch, value, near) {
            Ok(Some(rest)) => Ok(Some(rest)),
            Ok(None) | Err(Error::Undecided { .. }) => self.on_branch(branch, value),
            Err(error) => Err(error),
        }
    }

    fn on_branch(&self, branch: usize, value: &Interval) -> Result<Option<Equilibrium<Interval>>> {
        let last = branch == self.folds.len();
        if last && let Some(rest) = self.at_vertical_edge(value)? {
            return Ok(Some(rest));
        }
        if last && self.vertical_edge_is_fold() {
            return Ok(None);
        }
        let ends = self.ends(branch, value)?;
        let zero = value.lit(0);
        let [below, above] = ends.each_ref().map(|end| end.excess.partial_cmp(&zero));
        let (Some(below), Some(above)) = (below, above) else {
            return Err(self.curve.undecided("which way the contact moves at the ends of a branch"));
        };
        if below != above {
            return self.between(ends, value).map(Some);
        }
        let [lower, upper] = ends;
        if branch == 0
            && self.is_open[0]
            && let (near, Some(far)) = self.walk(lower, self.below(), value)
        {
            return self.between([far, near], value).map(Some);
        }
        if last && self.is_open[1] && self.edge.is_none() { self.outwards(upper, value) } else { Ok(None) }
    }
}

/// The error for first contact on a ring, which is not enclosed.
fn not_enclosed(radius: f64) -> Error {
    let (from, to) = (radius.to_string(), "infinity".to_owned());
    Error::Unproved { quantity: Quantity::Radius, from, to, remedy: "where surfaces touch outside is not enclosed" }
}

impl ProvedBranches {
    /// Whether the last fold is at the vertical edge, so that only the vertical edge follows.
    fn vertical_edge_is_fold(&self) -> bool {
        let last = self.folds.last();
        self.edge.as_ref().is_some_and(|edge| last.is_some_and(|fold| fold.contact_radius.overlaps(&edge.radius)))
    }
}

impl EnclosedCurve {
    /// The vertical edge, if g is known there.
    fn vertical_edge(&self) -> Result<Option<VerticalEdge>> {
        let Some(radius) = self.plain.vertical_edge() else { return Ok(None) };
        let index = self.plain.transform().kinks().len();
        let kink = self.plain.transform().kink(index, &radius.lit(2).powi(-i64::from(kinks::FINEST)))?;
        let Some((g, mean)) = kink.and_then(|kink| kink.value) else { return Ok(None) };
        let state = self.state_at_kink(&radius, &g, &mean, FoldKind::Minimum);
        let controlled = self.plain.control().controlled(&state.indentation, &state.force);
        Ok(Some(VerticalEdge { radius, mean, controlled }))
    }
}
