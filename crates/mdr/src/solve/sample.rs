//! Radii that the program chooses where the scene names none: short decimals, so that they are exact in any arithmetic.

use mdr_core::contact::{Error, Fold, Quantity, Result};
use mdr_core::number::Literal;
use mdr_numeric::folds::Folds;
#[cfg(feature = "mp")]
use mdr_numeric::proof;

use super::model::Model;
#[cfg(feature = "mp")]
use super::search::Search;

/// Points of a curve.
const POINTS: usize = 41;
/// How far a curve goes beyond its folds.
const MARGIN: f64 = 4.0;
/// How far folds are proved beyond the folds found in f64, where g is a closed form or a sum over rows,
#[cfg(feature = "mp")]
const REACH: f64 = 1e3;
/// and where it is an integral, whose cost grows with the waves inside the radius.
#[cfg(feature = "mp")]
const REACH_OF_INTEGRALS: f64 = 10.0;
/// The share of the rest up to an outer radius that is left out where g is an integral, inverse.
#[cfg(feature = "mp")]
const OF_THE_REST: f64 = 8.0;
/// So many folds are proved where g is an integral: those of waves without end are ever more work.
#[cfg(feature = "mp")]
const FOLDS_OF_INTEGRALS: usize = 8;
/// Folds are proved up to so many kinks where g is an integral: each kink cuts all integrals beyond it.
#[cfg(feature = "mp")]
const KINKS_OF_INTEGRALS: usize = 16;
/// How close to the outer radius of a profile.
const RIM: f64 = 1e-6;

/// `value` as a decimal of the given number of significant digits.
///
/// # Errors
/// Unless it is a number.
pub(crate) fn decimal(value: f64, digits: usize) -> Result<Literal> {
    format!("{value:.*e}", digits - 1)
        .parse()
        .map_err(|_| Error::domain(Quantity::ContactRadius, &value, "a number in the range of f64"))
}

/// Contact radii for a curve, ascending: evenly spread in ln a, from below the folds to above them.
///
/// # Errors
/// When w/E* or a fold is out of the range of f64.
pub(crate) fn radii(model: &Model<f64>, folds: &Folds<f64>) -> Result<Vec<Literal>> {
    let (length, outer) = (model.contact().material_length(), model.transform().outer_radius());
    // Around w/E* where there is no fold.
    let middle = outer.map_or(length, |outer| length.min(outer / 2.0));
    let at = |fold: Option<&Fold<f64>>| fold.map_or(middle, |fold| fold.contact_radius);
    let (lower, upper) = (at(folds.folds.first()) / MARGIN, at(folds.folds.last()) * MARGIN);
    let upper = upper.min(outer.map_or(f64::MAX, |outer| outer * (1.0 - RIM)));
    let step = (upper / lower).ln() / (POINTS - 1) as f64;
    (0..POINTS).map(|i| decimal(model.contact_radius(&(lower * (step * i as f64).exp())), 4)).collect()
}

/// A range of contact radii on which folds are proved.
#[cfg(feature = "mp")]
pub(crate) struct Range {
    pub(crate) ends: [Literal; 2],
    /// Whether states beyond it are not looked for.
    pub(crate) is_limit: bool,
}

/// Where the proof of folds ends where g is an integral, if there are more folds or kinks than it should see: between two of them.
///
/// # Errors
/// Errors of the search for folds.
#[cfg(feature = "mp")]
pub(crate) fn end_of_proof(search: &Search<'_>) -> Result<Option<f64>> {
    if !search.scene.takes_integrals() {
        return Ok(None);
    }
    let after = |radii: &[f64], count: usize| Some((radii.get(count - 1)? * radii.get(count)?).sqrt());
    let folds: Vec<f64> = search.folds()?.iter().map(|fold| fold.contact_radius).collect();
    let kinks = search.model.transform().kinks();
    let ends = [after(&folds, FOLDS_OF_INTEGRALS), after(&kinks, KINKS_OF_INTEGRALS)];
    Ok(ends.into_iter().flatten().reduce(f64::min))
}

/// The range of contact radii on which all folds are to be proved: far around the folds found in f64 and the kinks, and with the
/// radii to which the scene leads, to powers of ten; less far where g is an integral, and not beyond [`end_of_proof`] unless the
/// scene leads there.
///
/// # Errors
/// When w/E* or a fold is out of the range of f64; errors of the search for folds.
#[cfg(feature = "mp")]
pub(crate) fn range(search: &Search<'_>) -> Result<Range> {
    let (model, folds, visited) = (&search.model, search.folds()?, &search.visited());
    let by_integrals = search.scene.takes_integrals();
    let reach = if by_integrals { REACH_OF_INTEGRALS } else { REACH };
    let (lower, upper) = proof::range(&model.contact(), folds, reach, visited);
    let power = |value: f64| decimal(10f64.powf(value.log10().round()), 1);
    if let Some(end) = end_of_proof(search)?.filter(|end| visited.iter().all(|radius| radius < end)) {
        return Ok(Range { ends: [power(lower)?, decimal(end, 3)?], is_limit: true });
    }
    let outer = model.transform().outer_radius().filter(|_| by_integrals);
    // Towards an end where g may diverge integrals take ever more pieces.
    let radii = folds.iter().map(|fold| fold.contact_radius).chain(visited.iter().copied());
    let far = radii.chain(model.transform().kinks()).fold(0.0, f64::max);
    let upper = match outer {
        Some(outer) if far < outer => {
            let end = decimal(outer - (outer - far) / OF_THE_REST, 6)?;
            if end.nearest_f64() < outer { end } else { power(upper)? }
        }
        _ => power(upper)?,
    };
    Ok(Range { ends: [power(lower)?, upper], is_limit: false })
}
