//! Proofs over enclosures against closed forms and against the searches in f64, for every profile and control.

use std::sync::Arc;

use mdr_analytic::{PowerLaw, PowerLawContact};
use mdr_core::contact::{Control, Error, Fold, FoldKind, Material, Quantity, Result, Stability, Transform};
use mdr_core::number::{Dual, Interval, Precision, Real};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::folds;
use mdr_numeric::proof::{self, EnclosedCurve, ProvedBranches, ProvedFolds};
use rug::Float;

use super::common::{Drawn, Machine, ROUNDINGS};
use crate::grid::{Family, Held};
use crate::subject::profiles::NAMES;
use crate::trial::Trial;

/// Bits of the enclosures.
const BITS: u32 = 80;
/// Evaluations that a proof may spend.
const BUDGET: usize = 1_000_000;
/// How far beyond what f64 finds: 2²⁰.
const REACH: f64 = 1_048_576.0;

/// A contact in one arithmetic.
struct Side<R: Real> {
    transform: Arc<dyn Transform<R>>,
    material: Material<R>,
    control: Control<R>,
}

impl<R: Real> Side<R> {
    /// A profile under a control, both lifted exactly from f64.
    fn new(
        transform: Box<dyn Transform<R>>,
        material: &Material<f64>,
        control: &Control<f64>,
        ctx: R::Ctx,
    ) -> Result<Self> {
        let [e_star, work] = [material.effective_modulus(), material.work_of_adhesion()].map(|x| R::from_f64(ctx, *x));
        let control =
            control.try_map(|stiffness| Error::require_positive(Quantity::Stiffness, R::from_f64(ctx, *stiffness)))?;
        Ok(Side { transform: transform.into(), material: Material::new(e_star, work)?, control })
    }

    fn curve(&self) -> Contact<R> {
        Contact::half_space(&self.transform, &self.material, &self.control)
    }
}

/// A contact of the library in f64 and over enclosures, each also with derivatives.
struct Library {
    rough: Side<f64>,
    dual: Side<Dual<f64>>,
    plain: Side<Interval>,
    enclosed_dual: Side<Dual<Interval>>,
    /// A radius on the scale of the profile.
    radius: f64,
}

impl Library {
    /// A profile of the library at any scale, with w such that the state at a drawn radius is tangent or nearly so.
    fn draw(trial: &mut Trial<'_>) -> Result<Self> {
        let turn = trial.index / NAMES.len();
        let drawn = Drawn::<f64>::draw(trial, ());
        let beyond = trial.uniform(0.0, 1.0) < 0.6;
        let radius = drawn.radius(trial, beyond, ())?;
        let rough = drawn.closed::<f64>()?;
        let slope = match rough.slope(&radius)?.abs() {
            0.0 => drawn.steepness(),
            slope => slope,
        };
        let e_star = 10_f64.powf(trial.uniform(-8.0, 8.0));
        let lambda = 10_f64.powf(trial.uniform(-0.5, 0.5));
        let work = (slope / lambda).powi(2) * 2.0 * e_star * radius / std::f64::consts::PI;
        let (control, shown) = match turn % 3 {
            0 => (Control::Indentation, "indentation".to_owned()),
            1 => (Control::Force, "force".to_owned()),
            _ => {
                let stiffness = 2.0 * e_star * radius * 10_f64.powf(trial.uniform(-2.0, 2.0));
                (Control::Machine { stiffness }, format!("k = {stiffness:e}"))
            }
        };
        trial.describe(format_args!("{drawn}, E* = {e_star:e}, w = {work:e}, {shown}"));
        let material = Material::new(e_star, work)?;
        let ctx = Precision::new(BITS);
        let lifted = drawn.lifted::<Interval>(ctx);
        Ok(Library {
            rough: Side::new(rough, &material, &control, ())?,
            dual: Side::new(drawn.closed::<Dual<f64>>()?, &material, &control, ())?,
            plain: Side::new(lifted.closed::<Interval>()?, &material, &control, ctx)?,
            enclosed_dual: Side::new(lifted.closed::<Dual<Interval>>()?, &material, &control, ctx)?,
            radius,
        })
    }

    fn enclosed(&self) -> EnclosedCurve {
        EnclosedCurve::new(self.plain.curve(), self.enclosed_dual.curve())
    }

    /// All folds far around what f64 finds, and around the drawn radius.
    fn prove(&self) -> Result<ProvedFolds> {
        let curve = self.rough.curve();
        let (lower, upper) = proof::range(&curve, &folds::find(&curve)?, REACH, &[self.radius]);
        let [lower, upper] = [lower, upper].map(|end| Float::with_val(BITS, end));
        self.enclosed().folds(&lower, &upper, BUDGET)
    }

    /// The allowed error of a fold in f64.
    fn fold_error(&self, a: f64) -> Result<f64> {
        if self.rough.transform.kinks().iter().any(|kink| (a / kink - 1.0).abs() < 8.0 * f64::EPSILON) {
            return Ok(4.0);
        }
        let (curve, a) = (self.dual.curve(), Dual::variable(a));
        let condition = |f: Dual<f64>| (f.slope * a.value / f.value).abs();
        let steepness = condition(curve.tangency(&a)? / curve.critical_ratio(&a)?);
        Ok(ROUNDINGS * (2.0 + condition(self.dual.transform.slope(&a)?)) / steepness + 4.0)
    }

    /// The allowed error of an equilibrium in f64.
    fn equilibrium_error(&self, a: f64, value: f64) -> Result<f64> {
        let (curve, x) = (self.dual.curve(), Dual::variable(a));
        let g = self.dual.transform.g(&x)?;
        let terms = g.value.abs() + curve.detachment_elongation(&x)?.value + self.rough.transform.mean(&a)?.abs();
        let direction = curve.direction(&x, &Dual::constant(value))?;
        Ok(100.0 * (terms + (g.slope * a).abs()) / (direction.slope * a).abs() + 4.0)
    }
}

/// All folds proved, as many as the search in f64 finds, and each where it finds it.
///
/// The search errs by the error of g', 40(1 + c) roundoffs with the condition c of g', over the steepness
/// |d ln(g'/Δl'λ)/d ln a| of the tangency condition; at an edge it finds the edge to two roundoffs.
pub(super) fn search(trial: &mut Trial<'_>) -> Result<()> {
    let library = Library::draw(trial)?;
    let proved = library.prove()?;
    trial.demand("the proof is complete", proved.is_complete());
    let Ok(found) = folds::find(&library.rough.curve()) else { return Ok(()) };
    trial.demand("as many folds", proved.folds.len() == found.folds.len());
    for (proved, found) in proved.folds.iter().zip(&found.folds) {
        trial.demand("the kind of fold", proved.kind == found.kind);
        let a = proved.contact_radius.approx();
        trial.compare("a", &found.contact_radius, &a, library.fold_error(a)?);
    }
    Ok(())
}

/// All equilibria proved, as many as the branches in f64 hold, each where they hold it and as stable.
///
/// The radius errs by the rounding of the direction of change, 100(1 + c) roundoffs of its terms with the condition c of
/// g, over the slope of that direction.
pub(super) fn equilibria(trial: &mut Trial<'_>) -> Result<()> {
    let library = Library::draw(trial)?;
    let proved = library.prove()?;
    // In f64 a curve is not cut where g is infinite.
    if !proved.poles.is_empty() {
        return Ok(());
    }
    // The state at a radius that is not the drawn one, where it is likely to be tangent.
    let at = library.radius * 2_f64.powf(-trial.uniform(0.1, 1.0));
    let Ok(value) = library.rough.curve().controlled(&at) else { return Ok(()) };
    trial.describe_also(format_args!("value {value:e}"));
    let branches = ProvedBranches::new(library.enclosed(), &proved)?;
    let Ok(rough) = SearchedBranches::new(library.rough.curve()) else { return Ok(()) };
    let found = branches.equilibria(&Interval::from_f64(Precision::new(BITS), value))?;
    let expected = rough.equilibria(&value)?;
    trial.demand("as many equilibria", found.len() == expected.len());
    for (found, expected) in found.iter().zip(&expected) {
        trial.demand("stability", found.stability == expected.stability);
        if found.stability != Stability::Neutral {
            let a = found.contact_radius.approx();
            trial.compare("a", &expected.contact_radius, &a, library.equilibrium_error(a, value)?);
        }
    }
    Ok(())
}

/// The proved folds of power laws against a_c, d_c, F_c and the folds of machines in closed form, as enclosures.
pub(super) fn closed(trial: &mut Trial<'_>) -> Result<()> {
    let round = trial.index / 3;
    let family = Family { least: 0.05, most: 12.0, nearest: 4 };
    let exponent = trial.exponent(round, family);
    let (scene, radius, control) = if trial.index % 3 == 2 {
        let Machine { scene, stiffness, radius, .. } = trial.machine::<f64>(round, family, ());
        (scene, radius, Control::Machine { stiffness })
    } else {
        let held = Held::BOTH[trial.index % 3];
        let scales = trial.scales::<f64>(round, exponent);
        (trial.planted::<f64>(exponent, held.lambda(), scales, ()), scales.radius, held.control())
    };
    let material = scene.material()?;
    let ctx = Precision::new(BITS);
    let law = PowerLaw::new(Interval::from_f64(ctx, scene.n), Interval::from_f64(ctx, scene.c))?;
    let enclosed_dual = PowerLaw::new(Dual::<Interval>::from_f64(ctx, scene.n), Dual::from_f64(ctx, scene.c))?;
    let plain = Side::new(Box::new(law.clone()), &material, &control, ctx)?;
    let contact = PowerLawContact::new(law, plain.material.clone());
    let enclosed_dual = Side::new(Box::new(enclosed_dual), &material, &control, ctx)?;
    let expected = match &plain.control {
        Control::Machine { stiffness } => trial.closed.machine_folds(&contact, stiffness)?,
        control => {
            let critical = trial.closed.critical(&contact, control)?;
            let kind = if scene.n < 0.5 { FoldKind::Maximum } else { FoldKind::Minimum };
            let (contact_radius, indentation, force) = (critical.contact_radius, critical.indentation, critical.force);
            vec![Fold { contact_radius, indentation, force, kind }]
        }
    };
    // Wide enough for all three folds of a machine.
    let ends = [-60, 60].map(|octaves| Float::with_val(BITS, radius) << octaves);
    let enclosed = EnclosedCurve::new(plain.curve(), enclosed_dual.curve());
    let within =
        |fold: &&Fold<Interval>| *fold.contact_radius.lower() > ends[0] && *fold.contact_radius.upper() < ends[1];
    let expected: Vec<_> = expected.iter().filter(within).collect();
    let proved = enclosed.folds(&ends[0], &ends[1], BUDGET)?;
    trial.demand("the proof is complete", proved.is_complete());
    trial.demand("as many folds", proved.folds.len() == expected.len());
    for (proved, expected) in proved.folds.iter().zip(expected) {
        trial.demand("a", proved.contact_radius.overlaps(&expected.contact_radius));
        trial.demand("d", proved.indentation.overlaps(&expected.indentation));
        trial.demand("F", proved.force.overlaps(&expected.force));
        trial.demand("the kind of fold", proved.kind == expected.kind);
    }
    Ok(())
}
