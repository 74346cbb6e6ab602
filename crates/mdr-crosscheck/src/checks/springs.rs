//! The procedure of the paper taken literally: discrete springs, the outer ones detaching by the rule of Heß.

use mdr_core::contact::{Control, Outcome, Result};
use mdr_numeric::springs::Foundation;

use super::Run;
use super::folds::transform;
use crate::grid::{Exponent, Scene};
use crate::trial::Trial;

/// Critical states of a foundation of springs at spacing Δx = a_c/N against the closed forms, at their order.
///
/// * a: the last spring to let go stands within Δx/2 of a_c: 1/2N;
/// * d: the extremum of d(a) sampled within Δx/2 of it, d''a² = ¼(2n−1)Δl there: |2n−1|/32N² of Δl;
/// * F: the two half strips at the edge, and F'(a)|_d = −2E*Δl over Δx/2: together 1/N of 2E*aΔl;
/// * each times (1 + (n+3)/N)², for the derivatives one order higher across Δx.
pub(super) const SPRINGS: Run = ("spring-foundation", case);

fn case(trial: &mut Trial<'_>) -> Result<()> {
    let round = trial.index;
    let n = if round.is_multiple_of(3) { trial.uniform(0.1, 0.45) } else { trial.uniform(0.6, 6.0) };
    let springs = [100, 200, 400][round / 3 % 3];
    let exponent = Exponent::Double(n);
    let scene: Scene<f64> = trial.scene(round, exponent, 1.0, ());
    trial.describe_also(format_args!("N = {springs}"));
    let (contact, material) = (scene.contact()?, scene.material()?);
    let state = trial.closed.critical(&contact, &Control::Indentation)?;
    let a = state.contact_radius;
    let transform = transform(&scene)?;
    let reach = 2 * springs;
    let spacing = a / springs as f64;
    let foundation = Foundation::new(&transform, &material, spacing, reach)?;
    let pull_off = n > 0.5;
    let (cascades, end) = if pull_off {
        (foundation.pull(reach, &Control::Indentation)?, Outcome::Detached)
    } else {
        (foundation.press(1, &Control::Indentation)?, Outcome::CompleteContact)
    };
    trial.demand("one instability, and what it ends in", cascades.len() == 1 && cascades[0].outcome == end);
    let Some(cascade) = cascades.first() else { return Ok(()) };
    let found = &cascade.instability;

    let count = springs as f64;
    let higher = (1.0 + (n + 3.0) / count).powi(2);
    let elongation = mdr_analytic::detachment_elongation(&material, &a)?;
    let scale = 2.0 * scene.e_star * a * elongation;
    // Under pressure the spring named is the last one before the jump: the critical one is its outer neighbour.
    let radius = if pull_off { found.contact_radius } else { found.contact_radius + spacing };
    trial.enter("a", (radius / a - 1.0).abs(), 0.5 / count * higher);
    let allowed = (2.0 * n - 1.0).abs() / (32.0 * count * count) * higher + 1e-12;
    trial.enter("d/Δl", ((found.indentation - state.indentation) / elongation).abs(), allowed);
    let strip = if pull_off { 0.0 } else { 1.0 / count };
    trial.enter("F/2E*aΔl", ((found.force - state.force) / scale).abs(), (1.0 / count + strip) * higher);
    Ok(())
}
