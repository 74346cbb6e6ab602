//! What f64 knows of a path over a table before anything is proved: that it cannot start, and what its energies would take.

use mdr_core::contact::{Error, Result};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::folds::SearchQuality;
use mdr_numeric::path::{ContactState, Path};

use super::{changes, follow};
use crate::scene::Start;
use crate::solve::certified::Certified;
use crate::solve::digits::start;
use crate::solve::states::branches;
use crate::solve::weight::weight;

/// How close to the value of a fold, relative to the largest one, the question of the start is left to more digits.
const BESIDE: f64 = 1e-9;
/// Octaves around the folds in which a start is looked for.
const REACH: i64 = 1000;
/// Evaluations of g that the integrals of energy take between two rows, at two precisions, for so many bits.
const EVALUATIONS: (f64, f64) = (160.0, 99.0);
/// The work that energies may take without being asked for, in nanoseconds as budgets count it.
const MOST: f64 = 5e9;
/// The place of arbitrary precision among the [arithmetics](crate::run::ARITHMETICS).
const PRECISE: usize = 1;

/// Refuses a path over a table that cannot start: the search in f64 has resolved g everywhere, and the first value is not that of
/// a fold. A proof of its folds would take many times as long.
///
/// # Errors
/// [`Error::NoEquilibrium`]; errors of the search.
pub(crate) fn refuse_at_once(certified: &Certified<'_>) -> Result<()> {
    let scene = certified.scene;
    let (Some(_), Some(first)) = (scene.profile.rows(), scene.path.first()) else { return Ok(()) };
    // Where separated surfaces touch is another question.
    if scene.start == Start::Detached || !scene.pressed_into().is_half_space() {
        return Ok(());
    }
    let (model, folds) = certified.in_doubles()?;
    if folds.completeness != SearchQuality::Resolved || !folds.out_of_range.is_empty() {
        return Ok(());
    }
    let value = model.number(first);
    let branches = branches(&model, folds, REACH);
    let values = branches.folds().iter().map(|fold| model.control().controlled(&fold.indentation, &fold.force));
    let values: Vec<f64> = values.filter(|value| value.is_finite()).collect();
    let largest = values.iter().map(|value| value.abs()).fold(value.abs(), f64::max);
    if values.iter().any(|fold| (fold - value).abs() <= BESIDE * largest) {
        return Ok(());
    }
    match Path::first(&branches, &model.start(&scene.start)?, &value) {
        Err(error @ Error::NoEquilibrium { .. }) => Err(error),
        _ => Ok(()),
    }
}

/// Why the energies of a path over a table are left out unless they are asked for: their integrals end at every row. `None` if they
/// take little.
///
/// # Errors
/// Errors of the search and of the path in f64.
pub(super) fn too_much_energy(certified: &Certified<'_>) -> Result<Option<String>> {
    if certified.scene.profile.rows().is_none() {
        return Ok(None);
    }
    let (model, folds) = certified.in_doubles()?;
    let kinks = model.transform().kinks();
    let branches = branches(&model, folds, REACH).with_admissibility(certified.admissibility()?);
    let path = follow(&model, &branches, certified.scene)?;
    let rows = |state: &ContactState<f64>| {
        state.contact().map_or(0, |rest| kinks.partition_point(|kink| *kink < rest.contact_radius))
    };
    let lost = path.events.iter().filter(|event| changes(event.kind));
    let lost: usize = lost.map(|event| rows(&event.before).abs_diff(rows(&event.after))).sum();
    let ends = [path.events.first(), path.events.last()].into_iter().flatten();
    let pieces = lost + ends.map(|event| rows(&event.after)).sum::<usize>();
    let bits = start(certified.digits).bits();
    let evaluations = pieces as f64 * EVALUATIONS.0 * f64::from(bits) / EVALUATIONS.1;
    let work = evaluations * weight(&certified.scene.profile, PRECISE, bits) as f64;
    Ok((work > MOST).then(|| {
        format!(
            "left out: integrals over {pieces} parts between rows, about {:.0} s of work; energies = \"yes\" computes them",
            work / 1e9
        )
    }))
}
