//! Folds on a machine of finite stiffness: up to three.

use mdr_core::contact::{Error, FoldKind, Quantity, Result};
use mdr_core::number::Real;
use rug::Float;

use crate::arithmetic::Arithmetic;
use crate::grid::{Exponent, Family, Scene};
use crate::tolerance::machine_balance;
use crate::trial::Trial;

/// A contact on a machine with a fold at a planted radius.
pub(super) struct Machine<R> {
    pub(super) scene: Scene<R>,
    pub(super) stiffness: R,
    /// The planted radius.
    pub(super) radius: f64,
    /// Whether the planted fold is the middle one of three.
    pub(super) middle: bool,
}

impl Trial<'_> {
    /// Draws one. Every third is the middle fold of three: 1/2 < n < 5/2 − √3 and s between the roots of
    /// 3μs² − 2(1−2μ)s + μ = 0, μ = n − 1/2, where D falls with a.
    pub(super) fn machine<R: Arithmetic>(&mut self, round: usize, family: Family, ctx: R::Ctx) -> Machine<R> {
        let middle = round % 3 == 1;
        let exponent = if middle {
            Exponent::Double(0.5 + 10_f64.powf(self.uniform(-2.0, 0.24_f64.log10())))
        } else {
            self.exponent(round / 3, family)
        };
        let share = if middle {
            let mu = exponent.value::<f64>(()) - 0.5;
            let (half, third) = ((1.0 - 2.0 * mu) / (3.0 * mu), 1.0 / 3.0);
            let width = (half * half - third).sqrt();
            let (least, most) = (third / (half + width), half + width);
            // Away from both ends, where two folds merge.
            least * (most / least).powf(self.uniform(0.1, 0.9))
        } else {
            10_f64.powf(self.uniform(-3.0, 3.0))
        };
        let scales = self.scales::<R>(round, exponent);
        let lambda = 1.0 + 2.0 * part(share);
        let scene = self.planted(exponent, lambda, scales, ctx);
        let stiffness = R::from_f64(ctx, 2.0 * scales.e_star / share) * R::from_f64(ctx, scales.radius);
        self.describe_also(format_args!("k = {:e}", stiffness.approx()));
        Machine { scene, stiffness, radius: scales.radius, middle }
    }
}

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

/// s/(1+s), the part of the compliance that lies in the machine.
pub(super) fn part(share: f64) -> f64 {
    1.0 / (1.0 + 1.0 / share)
}

impl<R: Arithmetic> Machine<R> {
    /// Whether there may be so many folds: three around a planted middle one, one outside 1/2 < n < 5/2 − √3.
    pub(super) fn expects(&self, folds: usize) -> bool {
        let multistable = (0.5..2.5 - 3_f64.sqrt()).contains(&self.scene.n.approx());
        if self.middle { folds == 3 } else { folds == 1 || multistable && folds == 3 }
    }

    /// Checks the log₁₀ of a quantity of some fold that is out of the range of this arithmetic, by the same in an arithmetic
    /// that holds it.
    pub(super) fn is_beyond(&self, trial: &mut Trial<'_>, quantity: Quantity, log10: f64) -> Result<()> {
        const BITS: u32 = 200;
        let precise = |value: &R| Float::with_val(BITS, value.widen());
        let scene = self.scene.map(precise);
        let folds = trial.closed.machine_folds(&scene.contact()?, &precise(&self.stiffness))?;
        let logs = folds.iter().filter_map(|fold| {
            let value = match quantity {
                Quantity::ContactRadius => &fold.contact_radius,
                Quantity::Indentation => &fold.indentation,
                Quantity::Force => &fold.force,
                _ => return None,
            };
            Some(value.clone().abs().ln().approx() / std::f64::consts::LN_10)
        });
        let error = logs.map(|exact| (exact - log10).abs()).fold(f64::INFINITY, f64::min);
        // A logarithm of each input, each with its rounding, over |2n − 1|, and one of the sum.
        let largest = [&scene.c, &scene.e_star, &scene.work, &precise(&self.stiffness)]
            .map(|value| value.clone().ln().approx().abs())
            .into_iter()
            .fold(1.0, f64::max);
        let inputs = 16.0 * largest / (2.0 * scene.n.approx() - 1.0).abs();
        let roundoff = self.scene.n.unit_roundoff().approx();
        trial.enter(format!("log₁₀ of {quantity}"), error / roundoff, inputs + 4.0 * log10.abs());
        trial.demand(format!("{quantity} is out of range"), log10.abs() > 307.0);
        Ok(())
    }

    /// How far the balance of forces may be off at a computed fold of share s = 2E*a/k.
    pub(super) fn balance(&self, share: &R) -> f64 {
        let ln = |x: &R| x.ln().approx();
        let Scene { n, c, e_star, work } = &self.scene;
        let ln_stiffness_length = ln(&self.stiffness) - ln(e_star);
        let ln_ratio = ln(n) + ln(c) - 0.5 * (ln(work) - ln(e_star));
        machine_balance(n.approx(), ln(share), ln_stiffness_length, ln_ratio)
    }
}
