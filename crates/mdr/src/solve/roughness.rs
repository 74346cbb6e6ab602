//! The effect of the roughness of measured rows on the answer, and the effect of smoothing.

use std::sync::Arc;

use mdr_core::contact::{Control, Material};
use mdr_numeric::folds;
use mdr_numeric::table::{Scatter, Table};

use super::search::Search;
use crate::scene::{Measured, Profile, Scene};

/// Folds come from the scatter of the rows if the tangency ratio between them stays closer to its threshold than so many standard
/// deviations of the effect of the scatter.
const DEVIATIONS: f64 = 6.0;
/// A fold is worth a closer look where the scatter is so large a part of the slope of g.
const SHARE: f64 = 0.05;
/// The scatter of rows is worth a warning where it changes the pull-off force by so much.
const CHANGE: f64 = 0.02;

/// How the pull-off force changes with the length of smoothing; for rows as they are, only where their roughness matters.
pub(super) fn note(scene: &Scene, search: Option<&Search<'_>>) -> Option<String> {
    let tables = scene.profile.tables();
    if tables.is_empty() || !scene.medium.is_half_space() || !scene.has(|kind| !kind.is_of_profile()) {
        return None;
    }
    if let Some(length) = tables.iter().find_map(|table| table.length()) {
        let factors = [None, Some(0.5), Some(1.0), Some(2.0)];
        let at = |factor: Option<f64>| {
            let scaled = |table: &Measured| match table.length() {
                Some(length) => table.smoothed(factor.map(|factor| factor * length)),
                None => Some(table.clone()),
            };
            tension(scene, factor.map(|factor| factor * length), &scene.profile.with_tables(&scaled)?)
        };
        return Some(series(factors.into_iter().filter_map(at)));
    }
    let search = search?;
    tables.into_iter().find_map(|table| warning(scene, search, table))
}

/// Warns of folds that come from the scatter of rows.
fn warning(scene: &Scene, search: &Search<'_>, measured: &Measured) -> Option<String> {
    let scatter = measured.file.scatter();
    if scatter.of_rows().iter().all(|sigma| *sigma == 0.0) {
        return None;
    }
    let curve = search.model.contact();
    let radii: Vec<f64> = search.folds().ok()?.iter().map(|fold| fold.contact_radius).collect();
    // What the scatter does to the tangency ratio g'/Δl' = 2a g'/Δl.
    let of_ratio = |a: f64| Some(scatter.of_slope(a) * 2.0 * a / curve.detachment_elongation(&a).ok()?);
    let excess = |a: f64| Some(curve.tangency(&a).ok()? - curve.critical_ratio(&a).ok()?);
    let is_scatter = |pair: &[f64]| {
        let inner = [0.25, 0.5, 0.75].map(|t| excess(pair[0] + t * (pair[1] - pair[0])));
        let largest = inner.into_iter().flatten().map(f64::abs).fold(0.0, f64::max);
        of_ratio(pair[1]).is_some_and(|deviation| largest < DEVIATIONS * deviation)
    };
    let pairs: Vec<bool> = radii.windows(2).map(is_scatter).collect();
    let from_scatter = |fold: usize| pairs.get(fold) == Some(&true) || fold > 0 && pairs[fold - 1];
    let count = (0..radii.len()).filter(|fold| from_scatter(*fold)).count();
    let is_shifted = |a: f64| Some(of_ratio(a)? > SHARE * curve.critical_ratio(&a).ok()?);
    let affected: Vec<f64> = radii
        .iter()
        .enumerate()
        .filter(|(fold, a)| from_scatter(*fold) || is_shifted(**a) == Some(true))
        .map(|(_, a)| *a)
        .collect();
    let (first, last) = (*affected.first()?, *affected.last()?);

    let rows = measured.file.rows();
    let spacing = rows.last()?.radius.nearest_f64() / rows.len() as f64;
    let at = |length: Option<f64>| {
        let smoothed = |table: &Measured| table.smoothed(length);
        tension(scene, length, &scene.profile.with_tables(&smoothed)?)
    };
    let lengths = [2.0, 8.0, 32.0].map(|rows| rows * spacing).into_iter().filter(|length| *length < 2.0 * last);
    let tensions: Vec<Tension> = std::iter::once(None).chain(lengths.map(Some)).filter_map(at).collect();
    let changes = tensions.get(..2).is_some_and(|two| (two[1].force / two[0].force - 1.0).abs() > CHANGE);
    if count == 0 && !changes {
        return None;
    }
    let affected = scatter.row_before(first)..=(scatter.row_before(last) + 1).min(rows.len() - 1);
    let sigma = affected.clone().map(|row| scatter.of_rows()[row]).sum::<f64>() / affected.clone().count() as f64;
    let lines = [rows[*affected.start()].line, rows[*affected.end()].line];
    let whose =
        if is_rounding(&measured.file, &scatter, affected) { ", as the rounding of their last digit does" } else { "" };
    let folds = match count {
        0 => "the folds there are uncertain by that".to_owned(),
        count => format!("{count} of the {} folds come from that, not from the shape", radii.len()),
    };
    Some(format!(
        "the heights scatter by about {sigma:.1e} m from row to row (lines {} to {}){whose}: {folds}; {}; smooth the rows over a \
         length beyond which the force settles: `smooth` in [profile]",
        lines[0],
        lines[1],
        series(tensions)
    ))
}

/// Whether the scatter of most rows is no more than that of rounded numbers, 0.3 of the last digit, and up to 1.5 where they
/// are a staircase. Rows may have lost zeros.
fn is_rounding(table: &Table, scatter: &Scatter, rows: std::ops::RangeInclusive<usize>) -> bool {
    let unit = |row: usize| last_digit(&table.rows()[row].height.to_string());
    let last = table.rows().len() - 1;
    let finest = |row: usize| (row.saturating_sub(4)..=(row + 4).min(last)).map(unit).fold(f64::MAX, f64::min);
    let rounded = rows.clone().filter(|row| scatter.of_rows()[*row] < 1.5 * finest(*row)).count();
    4 * rounded >= 3 * rows.count()
}

/// The unit of the last digit of a decimal; 0 for a fraction.
fn last_digit(text: &str) -> f64 {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let places = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    if text.contains('/') { 0.0 } else { format!("1e{exponent}").parse().unwrap_or(0.0) / 10f64.powi(places as i32) }
}

/// The largest tensile force of a profile at a fold under a dead load.
struct Tension {
    length: Option<f64>,
    force: f64,
    folds: usize,
}

fn tension(scene: &Scene, length: Option<f64>, profile: &Profile) -> Option<Tension> {
    let transform = crate::scene::transform_in_doubles(profile).ok()?;
    let [modulus, work] = [&scene.effective_modulus, &scene.work_of_adhesion].map(|literal| literal.nearest_f64());
    let folds = folds::folds(&Arc::new(transform), &Material::new(modulus, work).ok()?, &Control::Force).ok()?;
    let force = folds.iter().map(|fold| fold.force).min_by(f64::total_cmp)?;
    Some(Tension { length, force, folds: folds.len() })
}

/// Forces by length of smoothing.
fn series(tensions: impl IntoIterator<Item = Tension>) -> String {
    let one = |Tension { length, force, folds }: Tension| {
        let over =
            length.map_or("for the rows as they are".to_owned(), |length| format!("smoothed over {length:.2e} m"));
        format!("{force:.4e} N {over} ({folds} fold{})", if folds == 1 { "" } else { "s" })
    };
    let all: Vec<String> = tensions.into_iter().map(one).collect();
    format!("the largest tensile force under a dead load is {}", all.join(", "))
}
