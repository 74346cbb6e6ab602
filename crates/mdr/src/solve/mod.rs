//! From a scene to its answer.
//!
//! Each output is asked of a list of [providers](provider::Provider), in their order; what they do for it is said in its
//! [room](crate::outputs).
//!
//! | provider | arithmetic | branches from | numbers become |
//! |---|---|---|---|
//! | [`power_law`] | intervals | closed forms, at any scale | proved digits |
//! | [`proof`] | intervals | folds isolated on a range of radii | proved digits |
//! | [`search`] | f64 | a survey of the tangency ratio | doubles |
//!
//! A certified scene is proved where that can be, output by output, and searched elsewhere: fields on other media than a half-space, and
//! energies there of tables and beyond kinks. A scene in f64 is searched, and what f64 does not hold is proved in digits.

mod admissible;
#[cfg(feature = "mp")]
pub(crate) mod certified;
#[cfg(feature = "mp")]
mod closed;
#[cfg(feature = "mp")]
pub(crate) mod digits;
mod graded;
#[cfg(feature = "mp")]
pub(crate) mod law_branches;
pub(crate) mod media;
pub(crate) mod model;
#[cfg(feature = "mp")]
pub(crate) mod out_of_range;
#[cfg(feature = "mp")]
pub(crate) mod power_law;
#[cfg(feature = "mp")]
pub(crate) mod proof;
mod provider;
#[cfg(feature = "mp")]
pub(crate) mod rigorous;
mod roughness;
pub(crate) mod rows;
pub(crate) mod sample;
pub(crate) mod search;
pub(crate) mod states;
mod unused;
pub(crate) mod weight;

use std::cell::OnceCell;
use std::sync::Arc;

use mdr_core::contact::{self, Edge};
use mdr_numeric::admissible::Admissibility;
use mdr_numeric::energy::MEDIUM;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::folds::{Folds, SearchQuality};

#[cfg(feature = "mp")]
use self::certified::Certified;
use self::model::Model;
#[cfg(feature = "mp")]
use self::power_law::PowerLaw;
use self::provider::Provider;
use self::search::Search;
use crate::answer::{Answer, Output};
use crate::error::{Error, Result};
#[cfg(feature = "mp")]
use crate::outputs::path;
use crate::outputs::room::Open;
use crate::run::{Cost, Counts, Run, Stop};
#[cfg(feature = "mp")]
use crate::scene::Arithmetic;
use crate::scene::{Scene, Start, Want};
use crate::validity;

pub(crate) use admissible::{on_medium, verdict};
pub use graded::GradedReal;
pub(crate) use unused::unused;

/// The answer to a scene that has been checked.
pub(crate) fn solve(scene: &Scene, run: &mut Run<'_>) -> Result<Answer> {
    let profile = scene.profile.name();
    #[cfg(feature = "mp")]
    let scene = &*closed::in_closed_form(scene);
    let counts = run.stop.counts();
    let solver = Solver::new(scene, &counts).map_err(|error| scene.places.complaint_about_profile(error))?;
    solver.check_range()?;
    #[cfg(feature = "mp")]
    solver.check_start()?;
    let mut outputs = Vec::new();
    let mut costs = Vec::new();
    let parts = scene.wants.len() + usize::from(scene.range_of_adhesion.is_some());
    let mut allowance = run.allowance(parts);
    for want in &scene.wants {
        if let Some(observer) = &mut run.observer {
            observer.begin(want);
        }
        let before = counts.each_ref().map(|count| count.read());
        allowance.next(&counts, rows(scene, want));
        let output = solver.output(want);
        // A stop may have been taken for a number that cannot be had.
        if run.stop.is_stopped() {
            return Err(Error::Stopped);
        }
        let output = match output.map_err(|error| solver.doubted(want, error)) {
            Err(error) if is_open(&error) => want.room().undecided(&Open::new(scene, &error)),
            output => output.map_err(|error| solver.complaint(want, error))?,
        };
        let evaluations = std::array::from_fn(|index| counts[index].read() - before[index]);
        let cost = Cost { output: want.kind(), evaluations };
        if let Some(observer) = &mut run.observer {
            observer.output(&output, &cost);
        }
        outputs.push(output);
        costs.push(cost);
    }
    allowance.next(&counts, 0);
    let validity = validity::of(scene, &counts).map_err(|error| scene.places.complaint_about_profile(error))?;
    let mut notes = scene.notes.clone();
    notes.extend(roughness::note(scene, solver.search().ok()));
    notes.extend(media::note(scene, &outputs));
    #[cfg(feature = "mp")]
    notes.extend(path::note(scene, &outputs));
    let has_states = scene.has(|kind| !kind.is_of_profile());
    let admissibility = if has_states { solver.admissibility().map(|known| known.basis()) } else { None };
    if run.stop.is_stopped() {
        return Err(Error::Stopped);
    }
    Ok(Answer {
        arithmetic: scene.arithmetic,
        profile,
        medium: (!scene.medium.is_half_space()).then(|| scene.medium.name()),
        force_unit: scene.medium.force_unit(),
        control: scene.names_control().then(|| scene.control.kind()),
        notes,
        outputs,
        admissibility,
        validity: validity.map(Box::new),
        costs,
    })
}

/// How many rows an output has at least, by what is given.
fn rows(scene: &Scene, want: &Want) -> usize {
    let way = if want.kind().moves() { scene.path.len() } else { 0 };
    want.rows().max(way)
}

/// Whether an error is that of one output, with which no input is wrong.
fn is_open(error: &contact::Error) -> bool {
    matches!(
        error,
        contact::Error::NoConvergence { .. }
            | contact::Error::Undecided { .. }
            | contact::Error::Unproved { .. }
            | contact::Error::BudgetSpent { .. }
    )
}

/// Where there is no equilibrium to start from, but the search for folds was not resolved everywhere, there may be one all the same.
pub(crate) fn unresolved(quantity: contact::Quantity) -> contact::Error {
    let what = "whether there is an equilibrium to start from: the search for folds was not resolved everywhere";
    contact::Error::Undecided { quantity, bits: f64::MANTISSA_DIGITS, what }
}

/// No provider has an output, which is no fault of the scene.
fn unanswered() -> contact::Error {
    let what = "an output for which there is no way to compute it";
    contact::Error::Undecided { quantity: contact::Quantity::ContactRadius, bits: f64::MANTISSA_DIGITS, what }
}

/// What is computed when something needs it, and once.
type Once<T> = OnceCell<contact::Result<T>>;

/// The result of a computation that was made before, or now. One that spent the budget is not made again for the next output,
/// which would spend its own on it.
fn once<T>(cell: &Once<T>, compute: impl FnOnce() -> contact::Result<T>) -> contact::Result<&T> {
    let known = match cell.get() {
        Some(known) => known,
        None => match compute() {
            Err(error) if !matches!(error, contact::Error::BudgetSpent { .. }) => return Err(error),
            found => cell.get_or_init(|| found),
        },
    };
    known.as_ref().map_err(Clone::clone)
}

/// The branches of a scene in f64, `octaves` beyond its folds, for a drawing.
pub(crate) fn drawn<T>(
    scene: &Scene,
    octaves: i64,
    draw: impl FnOnce(&Model<f64>, &SearchedBranches<f64>) -> contact::Result<T>,
) -> Result<T> {
    let counts = Stop::default().counts();
    let solver = Solver::new(scene, &counts).map_err(|error| scene.places.complaint_about_profile(error))?;
    let (model, folds) = solver.in_doubles().map_err(|error| scene.places.complaint(error))?;
    let branches = states::branches(&model, folds, octaves);
    draw(&model, &branches).map_err(|error| solver.complaint(&Want::Path, error))
}

/// The branches of an advancing and of a receding edge in f64, `octaves` beyond their folds, for a drawing.
pub(crate) fn drawn_between<T>(
    scene: &Scene,
    octaves: i64,
    draw: impl FnOnce(&Model<f64>, [&SearchedBranches<f64>; 2]) -> contact::Result<T>,
) -> Result<T> {
    let counts = Stop::default().counts();
    let of = |edge: Edge| {
        let scene = scene.at(edge);
        let solver = Solver::new(&scene, &counts).map_err(|error| scene.places.complaint_about_profile(error))?;
        let (model, folds) = solver.in_doubles().map_err(|error| scene.places.complaint(error))?;
        Ok::<_, Error>((states::branches(&model, folds, octaves), model))
    };
    let [(advancing, _), (receding, model)] = [of(Edge::Advancing)?, of(Edge::Receding)?];
    let solver = Solver::new(scene, &counts).map_err(|error| scene.places.complaint_about_profile(error))?;
    draw(&model, [&advancing, &receding]).map_err(|error| solver.complaint(&Want::Path, error))
}

/// A scene in its arithmetic.
struct Solver<'s> {
    scene: &'s Scene,
    counts: &'s Counts,
    route: Route<'s>,
}

enum Route<'s> {
    Search(Box<Search<'s>>),
    #[cfg(feature = "mp")]
    Certified(Box<Certified<'s>>),
}

#[cfg(feature = "mp")]
impl<'s> Route<'s> {
    /// The search in f64 and SI units, after proofs with what is kept for it.
    ///
    /// # Errors
    /// A number that no double holds; errors of the search.
    fn search(&self) -> contact::Result<&Search<'s>> {
        match self {
            Route::Search(search) => Ok(search),
            Route::Certified(certified) => {
                certified.counts[0].budget().open_reserve();
                certified.plain()
            }
        }
    }

    /// A part of the output that is proved.
    fn kept(&self) -> Option<Output> {
        match self {
            Route::Search(_) => None,
            Route::Certified(certified) => certified.take_kept(),
        }
    }
}

impl<'s> Solver<'s> {
    fn new(scene: &'s Scene, counts: &'s Counts) -> contact::Result<Self> {
        let route = match scene.arithmetic {
            #[cfg(feature = "mp")]
            crate::scene::Arithmetic::Certified { digits } => {
                Route::Certified(Box::new(Certified::new(scene, digits, counts)))
            }
            _ => Route::Search(Box::new(Search::new(scene, counts)?)),
        };
        Ok(Solver { scene, counts, route })
    }

    /// The output; with two works of adhesion made of those at each, unless it follows the path between them or is of its start.
    ///
    /// # Errors
    /// Errors of the transform, of the quadratures and of the proofs; a decision that no precision makes.
    fn output(&self, want: &Want) -> contact::Result<Output> {
        let of_path = want.kind().moves() || want.kind().is_of_states() && want.values().is_empty();
        if !self.scene.has_two_works() || want.kind().is_of_profile() || of_path {
            return self.output_of_one(want);
        }
        let of = |edge: Edge| {
            let scene = self.scene.at(edge);
            Solver::new(&scene, self.counts)?.output_of_one(want)
        };
        want.room().of_edges([of(Edge::Advancing)?, of(Edge::Receding)?]).ok_or_else(unanswered)
    }

    #[cfg(not(feature = "mp"))]
    fn output_of_one(&self, want: &Want) -> contact::Result<Output> {
        let Route::Search(search) = &self.route;
        Provider::Search(search).output(&*want.room())?.ok_or_else(unanswered)
    }

    /// The output of the first provider that has it, in the arithmetic of the scene.
    #[cfg(feature = "mp")]
    fn output_of_one(&self, want: &Want) -> contact::Result<Output> {
        let room = want.room();
        let law = if want.kind().is_of_profile() { None } else { PowerLaw::of(self.scene)? };
        let beyond = Certified::new(self.scene, out_of_range::DIGITS, self.counts);
        let others = match &self.route {
            Route::Certified(certified) => vec![Provider::Proof(certified)],
            Route::Search(search) if self.scene.profile.has_function() => vec![Provider::Search(search)],
            Route::Search(search) => vec![Provider::Search(search), Provider::Proof(&beyond)],
        };
        let others = others.into_iter().chain([Provider::Last(&self.route)]);
        for provider in law.iter().map(Provider::Law).chain(others) {
            let found = match (provider.output(&*room), &law, provider) {
                (found, None, _) | (found, _, Provider::Law(_)) => found?,
                (Ok(found), Some(law), _) => found.map(|output| room.confirmed(output, law)).transpose()?,
                (Err(error), Some(law), _) => return Err(law.doubted(error)),
            };
            match (found, self.scene.arithmetic, provider) {
                (None, ..) => {}
                (Some(output), _, Provider::Search(_))
                    if self.scene.profile.has_formula() && room.has_open_numbers(&output) =>
                {
                    return Ok(match Provider::Proof(&beyond).output(&*room) {
                        Ok(Some(proved)) => out_of_range::in_doubles(proved),
                        _ => output,
                    });
                }
                (Some(output), Arithmetic::Certified { .. }, _) | (Some(output), _, Provider::Search(_)) => {
                    return Ok(output);
                }
                (Some(output), Arithmetic::F64, _) => return Ok(out_of_range::in_doubles(output)),
            }
        }
        Err(unanswered())
    }

    /// The contact in f64 with all its folds, in SI units.
    fn in_doubles(&self) -> contact::Result<(Model<f64>, Folds<f64>)> {
        match &self.route {
            Route::Search(search) => Ok((Model::new(self.scene, (), self.counts)?, search.folds()?.clone())),
            #[cfg(feature = "mp")]
            Route::Certified(certified) => certified.in_doubles(),
        }
    }

    /// The contact in f64.
    fn search(&self) -> contact::Result<&Search<'s>> {
        match &self.route {
            Route::Search(search) => Ok(search),
            #[cfg(feature = "mp")]
            Route::Certified(certified) => certified.search(),
        }
    }

    /// The admissibility of states; `None` if it cannot be computed.
    fn admissibility(&self) -> Option<Arc<Admissibility>> {
        match &self.route {
            Route::Search(search) => Some(search.admissibility()),
            #[cfg(feature = "mp")]
            Route::Certified(certified) => certified.admissibility().ok(),
        }
    }

    /// Refuses a range of contact radii for the proof of folds that begins where the profile has ended.
    fn check_range(&self) -> Result<()> {
        let Some([lower, _]) = &self.scene.range else { return Ok(()) };
        let search = self.search().map_err(|error| self.scene.places.complaint(error))?;
        match search.model.transform().outer_radius() {
            Some(outer) if is_beyond(lower, outer) => Err(self.scene.places.of("output.folds.range").refuse(format!(
                "the range must begin within the profile, whose outer radius is {outer}, got {lower}"
            ))),
            _ => Ok(()),
        }
    }

    /// Refuses what f64 knows to have no start before anything is proved, which would take many times as long.
    #[cfg(feature = "mp")]
    fn check_start(&self) -> Result<()> {
        let needs_start = |want: &&Want| want.request().needs_start();
        let (Route::Certified(certified), Some(want)) = (&self.route, self.scene.wants.iter().find(needs_start)) else {
            return Ok(());
        };
        match path::refuse_at_once(certified) {
            Err(error @ contact::Error::NoEquilibrium { .. }) => Err(self.complaint(want, error)),
            // Other errors are those of an output.
            _ => Ok(()),
        }
    }

    /// Where a path cannot start but the search was not resolved everywhere, it is not known whether it can.
    fn doubted(&self, want: &Want, error: contact::Error) -> contact::Error {
        let contact::Error::NoEquilibrium { quantity, .. } = error else { return error };
        let doubtful =
            || self.search().and_then(Search::folds).map(|folds| folds.completeness == SearchQuality::Doubtful);
        if !want.kind().moves() || self.scene.start == Start::Detached || !doubtful().unwrap_or(true) {
            return error;
        }
        unresolved(quantity)
    }

    /// What is wrong with the scene when it has no answer.
    fn complaint(&self, want: &Want, error: contact::Error) -> Error {
        let places = &self.scene.places;
        match error {
            contact::Error::NoEquilibrium { .. } if want.request().needs_start() => {
                places.read_at("control.start").unwrap_or_else(|| places.of("control")).refuse(self.no_start())
            }
            // All that is left to do in certified digits was done.
            contact::Error::OutOfRange { quantity, log10 } => {
                places.complaint_about_profile(contact::Error::Domain {
                    quantity,
                    value: format!("10^{log10:.6}"),
                    requirement: "within the range of f64, where the search for states begins: take units of length in which \
                                  the contact is nearer to 1",
                })
            }
            contact::Error::Domain { quantity: MEDIUM, .. } => places.of("output.want").refuse(error.to_string()),
            contact::Error::Domain { .. } if self.scene.medium.is_periodic() => places.complaint_about_profile(error),
            error => places.complaint(error),
        }
    }

    /// Whether the profile is a power on a graded half-space that is too sharp to come off, n ≤ (1 − k)/2.
    fn is_below_threshold(&self) -> bool {
        let order = self.scene.medium.exponent_of_grade().map(|k| (1.0 - k) / 2.0);
        let law = self.scene.profile.power_law(mdr_core::number::Literal::nearest_f64, |radius| 0.5 / radius);
        matches!((order, law), (Some(order), Some([n, _])) if n <= order)
    }

    /// Why a path cannot start at its first way point.
    fn no_start(&self) -> String {
        let quantity = self.scene.control.kind().symbol();
        let Some(first) = self.scene.path.first() else { return "a path needs way points".to_owned() };
        let apart = first.is_negative() || first.is_zero();
        match self.scene.start {
            Start::Detached => {
                let touch = self.admissibility().and_then(|admissibility| admissibility.first_touch());
                let place = touch.map_or_else(String::new, |[radius, height]| {
                    format!(
                        "; they first touch at the indentation depth {height:.6e} m, on a ring of radius {radius:.6e} m"
                    )
                });
                format!("the path cannot start there: the surfaces are not apart at {quantity} = {first}{place}")
            }
            _ if self.is_below_threshold() => format!(
                "the path cannot start there: no stable equilibrium at {quantity} = {first}; of a power r^n with n at most (1 − k)/2 \
                 a contact is stable only between 0 and the fold of {quantity}"
            ),
            _ if apart => format!(
                "the path cannot start there: no stable equilibrium at {quantity} = {first}; where the surfaces are apart, \
                 start = \"detached\""
            ),
            _ => format!("the path cannot start there: no stable equilibrium at {quantity} = {first}"),
        }
    }
}

/// Whether a radius lies at or beyond the outer radius of a profile.
fn is_beyond(lower: &mdr_core::number::Literal, outer: f64) -> bool {
    mdr_core::number::Literal::try_from(outer)
        .map_or(lower.nearest_f64() >= outer, |outer| lower.compare(&outer).is_ge())
}
