//! The force curve over enclosures: samples at values that are short decimals, and a summary, with every digit proved.

use std::cell::{Cell, RefCell};

use mdr_core::contact::{Control, Error, EvaluationCounter, Fold, FoldKind, Quantity, Result};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Interval, Literal, Precision, Real};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::path::{ContactState, Path};
use mdr_numeric::proof::ProvedBranches;
use rug::Float;

use super::samples::{Branches, Course, Places};
use super::summary::{jump_in, passes, pull_off, stretches};
use super::{CurveNumbers, CurveSummary, ForceCurve, ForceSample};
use crate::answer::record::{Numbers, Row};
use crate::answer::{Number, Promise, Value};
use crate::outputs::path::{self, Dissipation, Energies};
use crate::solve::certified::Certified;
use crate::solve::proof::{Enclosed, budget_of_folds, decided, exactly};

/// The work of samples, in nanoseconds as budgets count it, above which they are left to f64: a curve is asked for to be looked at, and
/// has hundreds of them.
const MOST: u64 = 5_000_000_000;
/// After how many samples the work of all is known.
const FIRST: u64 = 8;

/// The force curve with every digit proved; `None` if the path is not, a minimum of the force stays open, or the samples take too much
/// work. Where the energies of the path cannot be enclosed, the hysteresis is that of the curve in f64.
///
/// # Errors
/// No stable equilibrium at the first way point; errors of the transform; errors of `in_doubles`.
pub(super) fn proved(
    certified: &Certified<'_>,
    points: usize,
    in_doubles: impl FnOnce() -> Result<ForceCurve>,
) -> Result<Option<ForceCurve>> {
    let curve = Curve { certified, points, is_chosen: RefCell::default() };
    let found = if certified.scene.has_two_works() {
        path::with_pair(certified, |pair| {
            let Some(path) = path::proved_between_edges(certified, pair, Energies::Proved)? else { return Ok(None) };
            let scene = pair.edges[1].scene;
            let numbers = curve.decided(|precision| {
                path::with_path_between(pair, precision, |enclosed, branches, path| {
                    let branches = Branches::Between(branches);
                    curve.numbers(&Course { scene, model: &enclosed[1].value, branches }, enclosed, &path)
                })
            })?;
            Ok(numbers.zip(Some(path)))
        })?
    } else {
        path::refuse_at_once(certified)?;
        let Some(folds) = certified.fold_proof()? else { return Ok(None) };
        let Some(path) = path::proved(certified, folds, Energies::Proved)? else { return Ok(None) };
        let numbers = curve.decided(|precision| {
            path::with_path(certified, folds, precision, |enclosed, branches, path| {
                let (scene, branches) = (certified.scene, Branches::One(branches));
                curve.numbers(&Course { scene, model: &enclosed.value, branches }, [enclosed; 2], &path)
            })
        })?;
        numbers.zip(Some(path))
    };
    let Some((numbers, path)) = found else { return Ok(None) };
    let mut curve = ForceCurve::new(Promise::Certified, numbers);
    if let Some(balance) = path.balance {
        curve.summary.hysteresis = Some(balance.dissipated);
    } else if !path.events.items.iter().any(|event| event.dissipated == Some(Dissipation::Unbounded)) {
        curve.summary.hysteresis = in_doubles()?.summary.hysteresis;
        curve.energy = curve.summary.hysteresis.as_ref().map(|_| Promise::F64);
    }
    Ok(Some(curve))
}

/// A force curve over enclosures.
struct Curve<'c, 's> {
    certified: &'c Certified<'s>,
    points: usize,
    /// Of each sample, whether it is between two events, where its place was chosen.
    is_chosen: RefCell<Vec<bool>>,
}

impl Curve<'_, '_> {
    /// The digits of its numbers. A sample whose place was chosen, and which has a number that no precision decides, such as a force that is
    /// exactly zero, is left out; `None` if another has.
    fn decided(
        &self,
        numbers: impl FnMut(Precision) -> Result<CurveNumbers<Enclosure>>,
    ) -> Result<Option<CurveNumbers<Number>>> {
        let Some(numbers) = decided(self.certified.decide(numbers))? else { return Ok(None) };
        let is_open = |sample: &ForceSample| sample.rows().iter().any(Row::is_open);
        let samples = numbers.samples.into_iter().zip(self.is_chosen.take());
        let samples = samples.filter(|(sample, is_chosen)| !(*is_chosen && is_open(sample)));
        let samples: Vec<ForceSample> = samples.map(|(sample, _)| sample).collect();
        let has_open = samples.iter().any(is_open) || numbers.summary.rows().iter().any(Row::is_open);
        Ok((!has_open).then_some(CurveNumbers { samples, summary: numbers.summary }))
    }

    /// The samples and the summary, without hysteresis, of a path.
    fn numbers(
        &self,
        course: &Course<'_, Interval, ProvedBranches>,
        enclosed: [&Enclosed; 2],
        path: &Path<Interval>,
    ) -> Result<CurveNumbers<Enclosure>> {
        let counter = &self.certified.counts[0];
        let decimals = Decimals { course, counter, before: counter.spent(), count: Cell::new(0), points: self.points };
        let samples = course.sampled(path, self.points, &decimals)?;
        let known = |value: Interval| Some(Value::Known(Enclosure::from(value)));
        let minimum = minimum(course, enclosed, path)?;
        let summary = CurveSummary {
            pull_off_force: pull_off(&path.events).and_then(known),
            jump_in_force: jump_in(&path.events).and_then(known),
            minimum_force: minimum.and_then(known),
            hysteresis: None,
        };
        *self.is_chosen.borrow_mut() = samples.iter().map(|(_, origin)| matches!(origin, Origin::Chosen(_))).collect();
        let written = path::written(&course.scene.path, path);
        let exact = |(sample, origin)| with_exact(course, path, &written, sample, &origin);
        let samples = samples.into_iter().map(exact).collect();
        Ok(CurveNumbers { samples, summary })
    }
}

/// Where a sample is from.
enum Origin {
    /// Its value was chosen, as a decimal; between two events at one value there is no choice.
    Chosen(Option<Literal>),
    /// The state after an event, or before it, by its number.
    Event { number: usize, is_before: bool },
}

/// Samples at short decimals, as long as they take no more work than they may.
struct Decimals<'c> {
    course: &'c Course<'c, Interval, ProvedBranches>,
    counter: &'c EvaluationCounter,
    /// What was spent before.
    before: u64,
    count: Cell<u64>,
    points: usize,
}

impl Places<Interval> for Decimals<'_> {
    type Origin = Origin;

    fn between(&self, ends: [&Interval; 2], share: [usize; 2]) -> Result<(Interval, Origin)> {
        if ends[0].is_same(ends[1]) {
            return Ok((ends[0].clone(), Origin::Chosen(None)));
        }
        let quantity = self.course.model.control().quantity();
        let written = between(quantity, ends, share)?;
        self.count.set(self.count.get() + 1);
        let spent = self.counter.spent() - self.before;
        if self.count.get() == FIRST && (spent / FIRST).saturating_mul(self.points as u64) > MOST {
            let (from, to) = ("the first sample".to_owned(), "the last".to_owned());
            return Err(Error::Unproved { quantity, from, to, remedy: "ask for fewer samples" });
        }
        Ok((self.course.model.number(&written), Origin::Chosen(Some(written))))
    }

    fn of_event(&self, number: usize, is_before: bool) -> Origin {
        Origin::Event { number, is_before }
    }
}

/// The number at a share of the way between two others, as a decimal that is by a thousand times finer than the steps.
fn between(quantity: Quantity, [from, to]: [&Interval; 2], [index, count]: [usize; 2]) -> Result<Literal> {
    let [from, to] = [from.mid(), to.mid()];
    let bits = from.prec();
    let step = Float::with_val(bits, &to - &from) / count as u64;
    let power = Float::with_val(bits, step.abs_ref()).log10().floor().to_f64() - 3.0;
    let unit = Float::with_val(bits, 10u32).ln() * power;
    let value = (step * index as u64 + &from) / unit.exp();
    let whole = value.round().to_integer().unwrap_or_default();
    let text = format!("{whole}e{power:.0}");
    let remedy = "ask for fewer samples";
    text.parse().map_err(|_| Error::Unproved { quantity, from: from.to_string(), to: to.to_string(), remedy })
}

/// A sample with the numbers that are exact: the controlled quantity where it is written, and the depth where the contact breaks at zero.
fn with_exact(
    course: &Course<'_, Interval, ProvedBranches>,
    path: &Path<Interval>,
    values: &[Option<&Literal>],
    sample: ForceSample<Interval>,
    origin: &Origin,
) -> ForceSample<Enclosure> {
    let (written, event) = match origin {
        Origin::Chosen(literal) => (literal.as_ref(), None),
        Origin::Event { number, is_before } => (values[*number], Some(&path.events[*number]).filter(|_| *is_before)),
    };
    let mut sample = sample.convert(Enclosure::from);
    let is_apart = sample.contact_radius.is_none();
    if let Some(literal) = written {
        let put = |slot: &mut Option<Value<Enclosure>>| {
            if let Some(Value::Known(_)) = slot {
                *slot = Some(exactly(literal));
            }
        };
        put(&mut sample.position.0);
        match course.scene.control {
            Control::Indentation => put(&mut sample.indentation),
            Control::Machine { .. } if is_apart => put(&mut sample.indentation),
            Control::Force if !is_apart => sample.force = exactly(literal),
            _ => {}
        }
    }
    if event.is_some_and(|event| path::breaks_at_zero_depth(course.scene, event)) {
        sample.indentation = sample.indentation.map(|_| exactly(&0.into()));
    }
    sample
}

/// The minimum of F along the path: at an end of a stretch between two events, or at a fold of F that lies on it.
///
/// # Errors
/// [`Error::Unproved`] where the folds are not proved to be all; errors of the transform.
fn minimum(
    course: &Course<'_, Interval, ProvedBranches>,
    enclosed: [&Enclosed; 2],
    path: &Path<Interval>,
) -> Result<Option<Interval>> {
    let force =
        |state: &ContactState<Interval>, value: &Interval| match path::quantities(course.model.control(), state, value)
        {
            [_, _, Some(Value::Known(force))] => Some(force),
            _ => None,
        };
    let ends = path
        .events
        .windows(2)
        .flat_map(|pair| [force(&pair[0].after, &pair[0].value), force(&pair[1].before, &pair[1].value)]);
    let mut least = ends.flatten().reduce(|one, other| one.lesser(&other));
    if matches!(course.model.control(), Control::Force) {
        return Ok(least);
    }
    let [advancing, receding] = enclosed;
    for (stretches, (enclosed, grows)) in stretches(course, path).iter().zip([(advancing, true), (receding, false)]) {
        if !stretches.is_empty() {
            let range = course.branches.moving(grows).range();
            let budget = budget_of_folds(course.scene);
            let (found, possible) = at_folds(enclosed, range, path, stretches, budget)?;
            least = found.into_iter().chain(least).reduce(|one, other| one.lesser(&other));
            for other in possible {
                least = least.map(|least| down_to(least, &other));
            }
        }
    }
    Ok(least)
}

/// A number with what lies between it and another that may be in its place if it is smaller.
fn down_to(one: Interval, other: &Interval) -> Interval {
    if other.lower() < one.lower() { Interval::new(other.lower().clone(), one.upper().clone()) } else { one }
}

/// The least force at a fold of F on stretches between two radii, and forces at folds of which it is not decided whether they are on one, as
/// where a fold is at the end of a stretch. Folds are proved to be all between the tip and the largest radius.
fn at_folds(
    enclosed: &Enclosed,
    (lower, upper): &(Float, Float),
    path: &Path<Interval>,
    stretches: &[[Interval; 2]],
    budget: usize,
) -> Result<(Option<Interval>, Vec<Interval>)> {
    let curve = enclosed.curve_of_force();
    let proved = curve.folds(lower, upper, budget)?;
    let branches = ProvedBranches::new(curve, &proved)?;
    branches.check(path)?;
    let edge = enclosed.value.contact().vertical_edge();
    let (mut least, mut possible) = (None::<Interval>, Vec::new());
    for fold in branches.folds().iter().filter(|fold| fold.kind == FoldKind::Minimum && fold.force.is_finite()) {
        let Fold { contact_radius, force, .. } = fold;
        let is_at_edge = edge.as_ref().is_some_and(|edge| edge.is_same(contact_radius));
        match passes(contact_radius, stretches, is_at_edge, Interval::is_same) {
            Some(false) => {}
            Some(true) => least = Some(least.map_or_else(|| force.clone(), |least| least.lesser(force))),
            None => possible.push(force.clone()),
        }
    }
    Ok((least, possible))
}
