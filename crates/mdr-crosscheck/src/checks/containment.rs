//! Enclosures of 8 to 24 bits, without guard bits, against a truth of 400 bits.
//!
//! A proof is sound when enclosures contain what they enclose. In many bits an enclosure that is too narrow still has right digits;
//! in a few its error is of the size of what it states. The truth is the enclosure of 400 bits of the same exact numbers, which as a
//! whole must lie within.

use mdr_analytic::media::{GradedContact, GradedHalfSpace};
use mdr_analytic::struve::Struve;
use mdr_analytic::{PowerLaw, PowerLawContact};
use mdr_core::contact::{Control, Material, Result, Transform};
use mdr_core::number::{Interval, Precision, Real};

use super::common::Drawn;
use crate::trial::Trial;

/// Bits of the truth.
const TRUTH: u32 = 400;

/// The few bits of this case.
fn few(trial: &Trial<'_>) -> Precision {
    Precision::new(8 + (trial.index as u32 * 5) % 17)
}

/// A number that eight bits hold, or in every other case one that they enclose only.
fn number(trial: &mut Trial<'_>, least: f64, greatest: f64) -> f64 {
    let value = trial.uniform(least, greatest);
    let unit = 2_f64.powi(value.abs().log2().floor() as i32 - 5);
    if trial.index.is_multiple_of(2) { (value / unit).round() * unit } else { value }
}

/// Demands that the truths lie within enclosures of the same quantities. What few bits do not decide is no answer, and no error; a
/// list of another length is one.
fn demand(trial: &mut Trial<'_>, quantity: &str, few: Result<Vec<Interval>>, truth: Result<Vec<Interval>>) {
    let (Ok(few), Ok(truth)) = (few, truth) else { return };
    trial.demand(format!("{quantity}: as many"), few.len() == truth.len());
    for (few, truth) in few.iter().zip(&truth) {
        let within = few.encloses(truth);
        // What is written down of a miss: how far beside, in radii.
        let off = ((truth.mid() - few.mid()).abs() / few.radius()).to_f64();
        trial.enter(format!("{quantity} of {} bits", few.precision()), if within { 0.0 } else { off.min(1e9) }, 0.0);
    }
}

/// Numbers under the name of their quantity.
type Named = (&'static str, Result<Vec<Interval>>);

/// Everything that a power law answers.
struct Law {
    contact: PowerLawContact<Interval>,
    graded: GradedContact<Interval>,
    a: Interval,
    d: Interval,
    stiffness: Interval,
}

impl Law {
    fn new(bits: Precision, numbers: [f64; 8]) -> Result<Self> {
        let [n, c, e, w, k, a, d, stiffness] = numbers.map(|value| Interval::from_f64(bits, value));
        let medium = GradedHalfSpace::new(k, e.clone(), w.clone())?;
        let graded = GradedContact::new(n.clone(), c.clone(), medium)?;
        let contact = PowerLawContact::new(PowerLaw::new(n, c)?, Material::new(e, w)?);
        Ok(Law { contact, graded, a, d, stiffness })
    }

    /// A quantity with its name.
    fn quantities(&self) -> Vec<Named> {
        let Law { contact, graded, a, d, stiffness } = self;
        let one = |value: Result<Interval>| value.map(|value| vec![value]);
        let state =
            |control| contact.critical(control).map(|state| vec![state.contact_radius, state.indentation, state.force]);
        let equilibria = |control: &Control<Interval>| -> Result<Vec<Interval>> {
            let found = contact.equilibria(control, d)?;
            let numbers =
                found.as_slice().iter().map(|state| [&state.contact_radius, &state.indentation, &state.force]);
            Ok(numbers.flatten().cloned().collect())
        };
        let folds = contact.machine_folds(stiffness);
        vec![
            ("κ", Ok(vec![contact.profile().kappa().clone()])),
            ("d(a)", one(contact.indentation(a))),
            ("d'(a)", one(contact.indentation_slope(a))),
            ("F(a)", one(contact.force(a))),
            ("F'(a)", one(contact.force_slope(a))),
            ("Π", one(contact.energy(a, d))),
            ("critical, fixed grips", state(&Control::Indentation)),
            ("critical, dead load", state(&Control::Force)),
            ("equilibria, fixed grips", equilibria(&Control::Indentation)),
            ("equilibria, dead load", equilibria(&Control::Force)),
            ("folds on a machine", folds.map(|folds| folds.into_iter().map(|fold| fold.contact_radius).collect())),
            ("w lost at pull-off", one(contact.energy_lost_at_pull_off())),
            ("w lost at jump-in", one(contact.energy_lost_at_jump_in())),
            ("κ(n, k)", Ok(vec![graded.profile().kappa().clone()])),
            ("d(a), graded", one(graded.indentation(a))),
            ("F(a), graded", one(graded.force(a))),
        ]
    }
}

/// Closed forms of power laws, their critical states, folds and equilibria.
pub(super) fn power_laws(trial: &mut Trial<'_>) -> Result<()> {
    let n = match trial.index % 3 {
        0 => number(trial, 0.05, 0.45),
        1 => number(trial, 0.6, 2.0),
        _ => number(trial, 2.0, 20.0),
    };
    let [c, e_star, work, a, stiffness] = [(); 5].map(|()| number(trial, 0.1, 8.0));
    let (k, d) = (number(trial, -0.6, 0.6), number(trial, -0.5, 2.0));
    let numbers = [n, c, e_star, work, k, a, d, stiffness];
    let bits = few(trial);
    trial.describe(format_args!("n, C, E*, w, k, a, d, stiffness = {numbers:?}, {} bits", bits.bits()));
    let truth = Law::new(Precision::new(TRUTH), numbers)?.quantities();
    let Ok(law) = Law::new(bits, numbers) else { return Ok(()) };
    for ((quantity, few), (_, truth)) in law.quantities().into_iter().zip(truth) {
        demand(trial, quantity, few, truth);
    }
    Ok(())
}

/// g, g' and the mean of g of the profiles of the library, and the Struve functions that the waves need.
pub(super) fn profiles(trial: &mut Trial<'_>) -> Result<()> {
    let profile = Drawn::<f64>::draw(trial, ());
    let x = profile.radius(trial, trial.index.is_multiple_of(2), ())?;
    let z = 2_f64.powf(trial.uniform(-4.0, 7.0));
    let bits = few(trial);
    trial.describe(format_args!("{profile}, x = {x:e}, z = {z}, {} bits", bits.bits()));
    let answers = |precision: Precision| -> Result<Vec<Named>> {
        let transform = profile.lifted::<Interval>(precision).closed::<Interval>()?;
        let [x, z] = [x, z].map(|value| Interval::from_f64(precision, value));
        let one = |value: Result<Interval>| value.map(|value| vec![value]);
        Ok(vec![
            ("g", one(transform.g(&x))),
            ("g'", one(transform.slope(&x))),
            ("∫g", one(transform.integral(&x))),
            ("mean of g", one(transform.mean(&x))),
            ("H₀, H₁", Ok(z.struve().to_vec())),
        ])
    };
    let truth = answers(Precision::new(TRUTH))?;
    let Ok(found) = answers(bits) else { return Ok(()) };
    for ((quantity, few), (_, truth)) in found.into_iter().zip(truth) {
        demand(trial, quantity, few, truth);
    }
    Ok(())
}
