//! The curve of equilibria as a polyline that looks like the curve itself.

use mdr_core::contact::Result;
use mdr_numeric::contact::Contact;

/// A point of the curve of equilibria, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct CurveSample {
    /// a.
    pub contact_radius: f64,
    /// d(a) = g(a) − Δl(a).
    pub indentation: f64,
    /// F(a).
    pub force: f64,
    /// g(a).
    pub transformed: f64,
    /// Δl(a).
    pub elongation: f64,
}

impl CurveSample {
    fn at(curve: &Contact<f64>, a: f64) -> Result<Self> {
        let (indentation, force) = curve.state(&a)?;
        let (transformed, elongation) = (curve.transform().g(&a)?, curve.detachment_elongation(&a)?);
        Ok(CurveSample { contact_radius: a, indentation, force, transformed, elongation })
    }

    fn coordinates(&self) -> [f64; 4] {
        [self.contact_radius, self.indentation, self.force, self.elongation]
    }
}

/// The largest distance of the polyline from the curve, in shares of the range of each quantity.
const TOLERANCE: f64 = 1.5e-4;

/// How near to a singular radius the curve is drawn, in shares of the radius.
const BESIDE: f64 = 1e-9;

/// Halvings of an interval between two nodes.
const DEPTH: u32 = 14;

/// Points of the curve from `lower` > 0 to `upper`, denser where it bends; every one of the `nodes` in between (folds,
/// kinks, events) is a point, so that a fold stays sharp.
///
/// # Errors
/// Errors of the transform.
pub(super) fn samples(curve: &Contact<f64>, lower: f64, upper: f64, nodes: &[f64]) -> Result<Vec<CurveSample>> {
    const COARSE: u32 = 64;
    // Equal steps in √a: near the tip everything changes as a root or faster.
    let root = |share: f64| (lower.sqrt() + share * (upper.sqrt() - lower.sqrt())).powi(2);
    let mut radii: Vec<f64> = (1..COARSE).map(|step| root(f64::from(step) / f64::from(COARSE))).collect();
    let nodes = curve.transform().kinks().into_iter().chain(nodes.iter().copied());
    radii.extend(nodes.flat_map(|a| regular(curve, a)).filter(|a| *a > lower && *a < upper));
    radii.extend([lower, upper]);
    radii.sort_by(f64::total_cmp);
    radii.dedup();
    let coarse = radii.iter().map(|a| CurveSample::at(curve, *a)).collect::<Result<Vec<_>>>()?;
    let scales = ranges(&coarse);
    let mut fine: Vec<CurveSample> = coarse.first().copied().into_iter().collect();
    for pair in coarse.windows(2) {
        refine(curve, (pair[0], pair[1]), &scales, DEPTH, &mut fine)?;
    }
    Ok(fine)
}

/// The radius itself, or where the profile is singular its two neighbours.
fn regular(curve: &Contact<f64>, a: f64) -> Vec<f64> {
    if curve.state(&a).is_ok() { vec![a] } else { vec![a * (1.0 - BESIDE), a * (1.0 + BESIDE)] }
}

/// The largest minus the smallest of each quantity.
fn ranges(samples: &[CurveSample]) -> [f64; 4] {
    let mut extremes = [[f64::INFINITY, f64::NEG_INFINITY]; 4];
    for sample in samples {
        for (range, value) in extremes.iter_mut().zip(sample.coordinates()) {
            *range = [range[0].min(value), range[1].max(value)];
        }
    }
    extremes.map(|[least, most]| most - least)
}

/// Adds the points after the first of the pair, up to its second.
fn refine(
    curve: &Contact<f64>,
    (from, to): (CurveSample, CurveSample),
    scales: &[f64; 4],
    depth: u32,
    fine: &mut Vec<CurveSample>,
) -> Result<()> {
    if to.contact_radius - from.contact_radius <= 3.0 * BESIDE * to.contact_radius {
        fine.push(to);
        return Ok(());
    }
    let middle = CurveSample::at(curve, f64::midpoint(from.contact_radius, to.contact_radius))?;
    let bent = (0..4).any(|index| {
        let [from, middle, to] = [from, middle, to].map(|sample| sample.coordinates()[index]);
        (middle - f64::midpoint(from, to)).abs() > TOLERANCE * scales[index]
    });
    if depth > 0 && bent {
        refine(curve, (from, middle), scales, depth - 1, fine)?;
        refine(curve, (middle, to), scales, depth - 1, fine)?;
    } else {
        fine.push(to);
    }
    Ok(())
}

#[cfg(test)]
#[path = "../../tests/private/sampling.rs"]
mod tests;
