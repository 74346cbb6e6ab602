//! What is known of the start of a path before any fold is proved: that a path over a table cannot start, by f64; and that one of surfaces that
//! are apart has no state with a fold.

use mdr_core::contact::{Error, Result};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::folds::SearchQuality;
use mdr_numeric::path::Path;

use crate::scene::Start;
use crate::solve::certified::Certified;
use crate::solve::proof::FoldProof;
use crate::solve::states::branches;

/// How close to the value of a fold, relative to the largest one, the question of the start is left to more digits.
const BESIDE: f64 = 1e-9;
/// Octaves around the folds in which a start is looked for.
const REACH: i64 = 1000;

/// Refuses a path over a table that cannot start: the search in f64 has resolved g everywhere, and the first value is not that of
/// a fold. A proof of its folds would take many times as long.
///
/// # Errors
/// [`Error::NoEquilibrium`]; errors of the search.
pub(crate) fn refuse_at_once(certified: &Certified<'_>) -> Result<()> {
    let scene = certified.scene;
    let (Some(_), Some(first)) = (scene.profile.rows(), scene.path.first()) else { return Ok(()) };
    // Where separated surfaces touch is another question.
    if scene.start == Start::Detached || scene.has_two_works() || !scene.pressed_into().is_half_space() {
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

/// The proof of no folds, for a path that begins apart where the surfaces are proved to touch first on a ring: it ends there at the latest.
///
/// # Errors
/// Errors of the transform.
pub(super) fn without_folds(certified: &Certified<'_>) -> Result<Option<FoldProof>> {
    if certified.scene.start != Start::Detached {
        return Ok(None);
    }
    let admissibility = certified.admissibility()?;
    Ok(admissibility.has_proved_ring().then(FoldProof::of_none))
}
