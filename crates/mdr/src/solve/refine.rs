//! Folds that a search in f64 has found, in another arithmetic.

use mdr_core::calculus::roots::{self, Bracket};
use mdr_core::contact::{Error, Fold, Quantity, Result};
use mdr_numeric::contact::Contact;
use mdr_numeric::folds::{Folds, pole};

use super::model::{Model, SceneReal};

/// Folds that were found in f64, in another arithmetic: each is searched near its radius in f64.
///
/// # Errors
/// Errors of the transform; [`Error::NoConvergence`] when a fold is not found again.
pub(crate) fn refined<R: SceneReal>(model: &Model<R>, searched: &Folds<f64>) -> Result<Folds<R>> {
    let curve = model.contact();
    let folds = searched.folds.iter().map(|fold| refine(model, &curve, fold)).collect::<Result<_>>()?;
    let kinks = model.transform().kinks();
    let at = |radius: f64| kinks.iter().find(|kink| kink.approx() == radius).cloned();
    let poles = searched.poles.iter().filter_map(|found| Some(pole(at(found.contact_radius)?, found.kind))).collect();
    Ok(Folds { folds, poles, out_of_range: Vec::new(), completeness: searched.completeness })
}

fn refine<R: SceneReal>(model: &Model<R>, curve: &Contact<R>, searched: &Fold<f64>) -> Result<Fold<R>> {
    let centre = model.double(searched.contact_radius);
    if let Some(outer_edge) = curve.vertical_edge().filter(|outer_edge| outer_edge.approx() == searched.contact_radius)
    {
        let (indentation, force) = curve.state(&outer_edge)?;
        return Ok(Fold { contact_radius: outer_edge, indentation, force, kind: searched.kind });
    }
    let excess = |a: &R| Ok(curve.tangency(a)? - curve.critical_ratio(a)?);
    for halvings in [44, 36, 28, 20, 12] {
        let margin = centre.lit(2).powi(-halvings) * &centre;
        let (lower, mut upper) = (centre.clone() - &margin, centre.clone() + &margin);
        if let Some(outer) = curve.transform().outer_radius().filter(|outer| upper >= *outer) {
            upper = (centre.clone() + outer).over(2);
        }
        let Some(bracket) = Bracket::new(&lower, &upper, excess)? else { continue };
        let contact_radius = roots::refine(bracket, &centre.unit_roundoff(), excess)?.value;
        let (indentation, force) = curve.state(&contact_radius)?;
        return Ok(Fold { contact_radius, indentation, force, kind: searched.kind });
    }
    Err(Error::NoConvergence { quantity: Quantity::ContactRadius, evaluations: 10, error: 2f64.powi(-12) })
}
