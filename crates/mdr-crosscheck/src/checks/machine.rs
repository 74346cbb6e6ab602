//! Folds on a machine of finite stiffness: up to three.

use mdr_core::contact::{Error, FoldKind, Result};

use super::common::{Machine, part};
use crate::arithmetic::Arithmetic;
use crate::grid::Family;
use crate::trial::Trial;

/// Each fold put back into k d' + F' = 0, (1.13) and (1.16); a fold is known to be there, three where three are due.
pub(super) fn folds<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    // Close to 1/2 the folds are hundreds of decades apart.
    let nearest = if R::NAME == f64::NAME { 5 } else { 24 };
    let machine = trial.machine::<R>(round, Family::up_to(nearest), ctx);
    let Machine { scene, stiffness, .. } = &machine;
    let contact = scene.contact()?;
    let found = match trial.closed.machine_folds(&contact, stiffness) {
        Err(Error::OutOfRange { quantity, log10 }) => return machine.is_beyond(trial, quantity, log10),
        found => found?,
    };
    trial.demand("the number of folds", machine.expects(found.len()));
    let ends = if scene.n < scene.n.ratio(1, 2) { FoldKind::Maximum } else { FoldKind::Minimum };
    let alternate = found.iter().enumerate().all(|(i, fold)| (fold.kind == ends) == (i % 2 == 0));
    trial.demand("the kinds of the folds", alternate);

    for fold in found {
        let a = &fold.contact_radius;
        let edge = scene.e_star.clone().times(2) * a;
        let share = edge.clone() / stiffness;
        let (lambda, balance) = (1.0 + 2.0 * part(share.approx()), machine.balance(&share));
        let tangent = scene.tangent(lambda, a);

        let d_slope = trial.closed.indentation_slope(&contact, a)?;
        let f_slope = trial.closed.force_slope(&contact, a)?;
        let elongation = trial.closed.detachment_elongation(contact.material(), a)?;
        let unit = (elongation.clone() / a).over(2);
        let residual = (d_slope * stiffness + f_slope) / (stiffness.clone() + &edge) / &unit;
        let allowed = lambda * balance + 3.0 * tangent.slope_terms() + 12.0;
        trial.compare_on("k d' + F'", &residual, &unit.lit(0), &unit.lit(1), allowed);

        let d = trial.closed.indentation(&contact, a)?;
        let allowed = tangent.indentation_terms() + tangent.transform() * balance;
        trial.compare_on("d", &fold.indentation, &d, &elongation, allowed);
        let f = trial.closed.force(&contact, a)?;
        let allowed = tangent.force_terms() + tangent.pressed() * balance;
        trial.compare_on("F", &fold.force, &f, &(elongation * &edge), allowed);
    }
    Ok(())
}
