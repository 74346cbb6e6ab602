//! The output `force-curve`: the loading path as a measurement shows it, sampled in f64, with a break at every jump.

mod samples;
mod summary;

#[cfg(feature = "mp")]
use mdr_core::contact::Edge;
use mdr_core::contact::Result;

use self::samples::Course;
use super::key::Key;
use super::path::edges;
use super::room::{Content, Facts, Open, Request, Room as IsRoom, Subject, Table, not_wanted};
use super::{Output, Want};
#[cfg(feature = "mp")]
use crate::answer::Number;
use crate::answer::record::{Numbers, Row, record};
use crate::answer::{List, NumberStyle, Optional, Promise, Value};
use crate::scene::MOST_ROWS;
use crate::solve::search::Search;
#[cfg(feature = "mp")]
use crate::solve::{certified::Certified, states::States};

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
}

impl Content for ForceCurve {
    fn list(&self) -> &dyn Table {
        &self.samples
    }

    fn beside(&self) -> Vec<(&'static str, Vec<Row<'_>>)> {
        vec![("force-curve-summary", self.summary.rows())]
    }

    fn sentences(&self, style: &NumberStyle) -> Vec<String> {
        vec![self.summary.sentence(style)]
    }

    /// It is in f64, whatever is asked for.
    #[cfg(feature = "mp")]
    fn resolve(&mut self, _: Promise, _: fn(Number) -> Value) {}
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
    fn estimated(&self, certified: &Certified<'_>) -> Result<Output> {
        if certified.scene.has_two_works() {
            return between_edges(certified, self.rows());
        }
        let (model, folds) = certified.in_doubles()?;
        let states = States::new(certified.scene, &model, folds, certified.admissibility()?);
        Ok(Output::ForceCurve(Box::new(samples::sampled(Course::One(&states), self.rows())?)))
    }

    fn searched(&self, search: &Search<'_>) -> Result<Output> {
        let curve = if search.scene.has_two_works() {
            edges::with_both(search, |states, _| samples::sampled(Course::Between(states), self.rows()))?
        } else {
            samples::sampled(Course::One(&search.states()?), self.rows())?
        };
        Ok(Output::ForceCurve(Box::new(curve)))
    }

    fn undecided(&self, open: &Open<'_>) -> Output {
        let [pull_off_force, jump_in_force, minimum_force, hysteresis] = [(); 4].map(|()| Some(open.value()));
        let summary = CurveSummary { pull_off_force, jump_in_force, minimum_force, hysteresis };
        let samples = List::new(Promise::F64, Vec::new()).complete(open.completeness());
        Output::ForceCurve(Box::new(ForceCurve { samples, summary }))
    }
}

/// The force curve between the branches of an advancing and of a receding edge, in f64.
#[cfg(feature = "mp")]
fn between_edges(certified: &Certified<'_>, points: usize) -> Result<Output> {
    let scenes = [Edge::Advancing, Edge::Receding].map(|edge| certified.scene.at(edge));
    let parts = scenes.each_ref().map(|scene| Certified::new(scene, certified.digits, certified.counts));
    let [(one, folds), (other, others)] = [parts[0].in_doubles()?, parts[1].in_doubles()?];
    let states = [
        States::new(&scenes[0], &one, folds, parts[0].admissibility()?),
        States::new(&scenes[1], &other, others, parts[1].admissibility()?),
    ];
    let curve = samples::sampled(Course::Between([&states[0], &states[1]]), points)?;
    Ok(Output::ForceCurve(Box::new(curve)))
}
