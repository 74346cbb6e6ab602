//! The output `force-curve`: the loading path as a measurement shows it, with a break at every jump.

#[cfg(feature = "mp")]
mod proof;
mod samples;
mod summary;

#[cfg(feature = "mp")]
use mdr_core::contact::Error;
use mdr_core::contact::Result;
use mdr_numeric::equilibrium::SearchedBranches;

use self::samples::{Branches, Course, Places};
use super::key::Key;
#[cfg(feature = "mp")]
use super::path;
use super::path::edges;
use super::room::{Content, Facts, Open, Request, Room as IsRoom, Subject, Table, not_wanted};
use super::{Output, Want};
use crate::answer::record::{Numbers, Row, record};
use crate::answer::{Column, List, Number, NumberStyle, Optional, Promise, Value};
use crate::scene::MOST_ROWS;
#[cfg(feature = "mp")]
use crate::solve::certified::Certified;
use crate::solve::search::Search;
use crate::solve::states::States;

/// The samples of a force curve when their number is not given.
pub const POINTS: u32 = 400;

record! {
    /// A sample of the loading path.
    ForceSample {
        /// From 1; the next one begins at a jump and where the direction changes.
        segment: usize,
        /// `approach` while the controlled quantity rises, `retract` while it falls.
        direction: &'static str,
        /// D = d + F/k, on a machine.
        position: Optional<N> = "position" in "m",
        /// d; `None` for bodies apart under a dead load.
        indentation: Option<Value<N>> = "indentation" in "m",
        /// F; 0 of bodies apart.
        force: Value<N> = "force" in "N",
        /// a; `None` for bodies apart.
        contact_radius: Option<Value<N>> = "contact radius" in "m",
    }

    /// The characteristic values of a force curve; a quantity that the path does not reach has no value.
    CurveSummary {
        /// F at the fold from which the contact breaks, or, between two works of adhesion, in the state in which its edge begins to
        /// recede and breaks at once. Where it shrinks to a point from a smaller contact, to which it has jumped
        /// before, F at the fold of that jump.
        pull_off_force: Option<Value<N>>,
        /// F just after the surfaces have jumped into contact; where contact begins continuously, after the first jump of the
        /// contact that grows from there.
        jump_in_force: Option<Value<N>>,
        /// The minimum of F along the path, at an end of a stretch between two events or at a fold of F on it.
        minimum_force: Option<Value<N>>,
        /// The energy lost in all events, in joules, and by the receding edge if there are two works of adhesion; `None` if it has
        /// no bound.
        hysteresis: Option<Value<N>>,
    }
}

impl CurveSummary {
    /// The summary of a force curve, in a sentence.
    pub fn sentence(&self, style: &NumberStyle) -> String {
        let part = |(name, value, unit): (&str, &Option<Value>, &str)| match value {
            Some(value) => format!("{name} {}", style.quantity(&value.to_string(), unit)),
            None => format!("no {name}"),
        };
        let parts = [
            ("pull-off force", &self.pull_off_force, "N"),
            ("force after jump-in", &self.jump_in_force, "N"),
            ("minimum force", &self.minimum_force, "N"),
            ("hysteresis", &self.hysteresis, "J"),
        ];
        format!("Summary: {}.", parts.map(part).join(", "))
    }
}

/// The loading path as a measurement shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct ForceCurve {
    /// The samples, in the order of the path.
    pub samples: List<ForceSample>,
    /// Pull-off force, jump-in, minimum force and hysteresis.
    pub summary: CurveSummary,
    /// How far the hysteresis can be trusted, where that is less than the rest.
    pub energy: Option<Promise>,
}

/// The samples and the summary of a force curve, in one arithmetic.
#[derive(Clone)]
struct CurveNumbers<N> {
    samples: Vec<ForceSample<N>>,
    summary: CurveSummary<N>,
}

impl<N> Numbers<N> for CurveNumbers<N> {
    type With<M> = CurveNumbers<M>;

    fn map_values<M>(self, f: &mut dyn FnMut(Value<N>) -> Value<M>) -> CurveNumbers<M> {
        CurveNumbers { samples: self.samples.map_values(f), summary: self.summary.map_values(f) }
    }

    fn rows(&self) -> Vec<Row<'_, N>> {
        let mut rows = self.samples.rows();
        rows.extend(self.summary.rows());
        rows
    }

    fn columns() -> Vec<Column> {
        <ForceSample<N> as Numbers<N>>::columns()
    }
}

impl ForceCurve {
    fn new(promise: Promise, numbers: CurveNumbers<Number>) -> Self {
        let CurveNumbers { samples, summary } = numbers;
        ForceCurve { samples: List::new(promise, samples), summary, energy: None }
    }
}

impl Content for ForceCurve {
    fn list(&self) -> &dyn Table {
        &self.samples
    }

    fn beside(&self) -> Vec<(&'static str, Vec<Row<'_>>)> {
        vec![("force-curve-summary", self.summary.rows())]
    }

    fn exceptions(&self) -> Vec<(&'static str, Promise)> {
        self.energy.map(|promise| ("force-curve-summary.hysteresis", promise)).into_iter().collect()
    }

    fn sentences(&self, style: &NumberStyle) -> Vec<String> {
        vec![self.summary.sentence(style)]
    }

    #[cfg(feature = "mp")]
    fn resolve(&mut self, promise: Promise, f: fn(Number) -> Value) {
        self.samples.resolve(promise, f);
        self.summary = self.summary.clone().resolve(f);
        self.energy = None;
    }
}

pub(super) const FACTS: Facts = Facts {
    of: Subject::Path,
    key: Some(Key::Count { name: "points", least: 2, most: MOST_ROWS }),
    question: |keys, kind| Want::ForceCurve { points: keys.count(kind).unwrap_or(POINTS) },
    unused: not_wanted,
};

pub(super) struct Room<'w> {
    pub(super) points: &'w u32,
}

impl<'w> Request<'w> for Room<'w> {
    fn rows(&self) -> usize {
        *self.points as usize
    }
}

impl<'w> IsRoom<'w> for Room<'w> {
    #[cfg(feature = "mp")]
    fn visited(&self, search: &Search<'_>) -> Vec<f64> {
        path::visited(search)
    }

    /// Proved where the path is; its hysteresis where the energies of the path are.
    #[cfg(feature = "mp")]
    fn proved(&self, certified: &Certified<'_>) -> Result<Option<Output>> {
        let in_doubles = || in_doubles(certified, self.rows());
        if certified.scene.is_closed() && certified.scene.medium.is_half_space() {
            return Ok(proof::proved(certified, self.rows(), in_doubles)?.map(Output::from));
        }
        // Integrals, and sums over rows, may take all of the budget: what f64 knows comes first.
        let known = in_doubles();
        let curve = match proof::proved(certified, self.rows(), || known.clone()) {
            Err(Error::BudgetSpent { .. } | Error::NoConvergence { .. }) => None,
            curve => curve?,
        };
        curve.map_or(known, Ok).map(|curve| Some(curve.into()))
    }

    fn searched(&self, search: &Search<'_>) -> Result<Output> {
        let curve = if search.scene.has_two_works() {
            edges::with_both(search, |states, _| of_both(states, self.rows()))?
        } else {
            let states = search.states()?;
            of_states(&states, Branches::One(&states.branches), self.rows())?
        };
        Ok(curve.into())
    }

    fn undecided(&self, open: &Open<'_>) -> Output {
        let [pull_off_force, jump_in_force, minimum_force, hysteresis] = [(); 4].map(|()| Some(open.value()));
        let summary = CurveSummary { pull_off_force, jump_in_force, minimum_force, hysteresis };
        let samples = List::new(Promise::F64, Vec::new()).complete(open.completeness());
        ForceCurve { samples, summary, energy: None }.into()
    }
}

impl From<ForceCurve> for Output {
    fn from(curve: ForceCurve) -> Self {
        Output::ForceCurve(Box::new(curve))
    }
}

/// The force curve of a scene in f64.
#[cfg(feature = "mp")]
fn in_doubles(certified: &Certified<'_>, points: usize) -> Result<ForceCurve> {
    if certified.scene.has_two_works() {
        return between_edges(certified, points);
    }
    let (model, folds) = certified.in_doubles()?;
    let states = States::new(certified.scene, &model, folds, certified.admissibility()?);
    of_states(&states, Branches::One(&states.branches), points)
}

/// The force curve between the branches of an advancing and of a receding edge, in f64.
#[cfg(feature = "mp")]
fn between_edges(certified: &Certified<'_>, points: usize) -> Result<ForceCurve> {
    path::with_edges(certified, |edges| {
        let [(one, folds), (other, others)] = [edges[0].in_doubles()?, edges[1].in_doubles()?];
        let advancing = States::new(edges[0].scene, &one, folds, edges[0].admissibility()?);
        let receding = States::new(edges[1].scene, &other, others, edges[1].admissibility()?);
        of_both([&advancing, &receding], points)
    })
}

/// The force curve between the states of an advancing and of a receding edge, in f64.
fn of_both([advancing, receding]: [&States<'_, f64>; 2], points: usize) -> Result<ForceCurve> {
    of_states(receding, Branches::Between([&advancing.branches, &receding.branches]), points)
}

/// Samples at doubles that are evenly spaced.
struct Even;

impl Places<f64> for Even {
    type Origin = ();

    fn between(&self, [from, to]: [&f64; 2], [index, count]: [usize; 2]) -> Result<(f64, ())> {
        Ok((from + (to - from) * (index as f64 / count as f64), ()))
    }

    fn of_event(&self, _: usize, _: bool) {}
}

/// The force curve on branches in f64; the states are those of an edge that recedes.
fn of_states(
    states: &States<'_, f64>,
    branches: Branches<'_, SearchedBranches<f64>>,
    points: usize,
) -> Result<ForceCurve> {
    let course = Course { scene: states.scene, model: states.model, branches };
    let path = course.follow()?;
    let samples = course.sampled(&path, points, &Even)?.into_iter().map(|(sample, ())| sample).collect::<Vec<_>>();
    let known = |value: f64| Some(Value::Known(value));
    let summary = CurveSummary {
        pull_off_force: summary::pull_off(&path.events).and_then(known),
        jump_in_force: summary::jump_in(&path.events).and_then(known),
        minimum_force: summary::minimum(&course, &path, &samples)?,
        hysteresis: summary::hysteresis(&course, &path)?,
    };
    let numbers = CurveNumbers { samples, summary }.convert(Number::F64);
    Ok(ForceCurve::new(Promise::F64, numbers))
}
