//! The pull-off of the Maugis–Dugdale theory as enclosures, against the route by quadratures of g in the ring.
#![cfg(feature = "mp")]
#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::sync::Arc;

use mdr_core::contact::{Control, Expression, Material, Result};
use mdr_core::number::{Interval, Precision, Real};
use mdr_numeric::contact::Contact;
use mdr_numeric::dugdale::{CohesiveState, Dugdale, separation};
use mdr_numeric::folds::folds;
use mdr_numeric::proof::{Continuation, EnclosedPullOff};
use mdr_numeric::transform::{Enclosed, Quadrature};

/// Powers, a ball, waves, ends of the profile, kinks under the contact, in the ring and at its end, and smooth sums.
const PROFILES: [&str; 11] = [
    "r^2/2",
    "0.5*r",
    "r^1.5",
    "r^3",
    "1 - sqrt(1 - r^2)",
    "sqrt(r^2 + 0.01) - 0.1",
    "r^2/2 + 0.1*r^3",
    "0.3*max(0, r - 0.1)",
    "max(r^2 - 0.01, 0)",
    "r^2/2 + max(0, r - 0.05)^2",
    "r^2/2 + 1e-5*(1 - cos(20*pi*r))",
];

const WORK: f64 = 1e-5;

fn number(value: f64, bits: u32) -> Interval {
    Interval::from_f64(Precision::new(bits), value)
}

fn in_doubles(formula: &str, range: f64) -> CohesiveState<f64> {
    let (formula, none) = (formula.parse::<Expression>().unwrap(), Default::default());
    let breaks = formula.breaks(&none).unwrap();
    let transform = Arc::new(Quadrature::new(formula.bind::<f64>((), &none).unwrap().broken_at((), &breaks)));
    let material = Material::new(1.0, WORK).unwrap();
    let radii: Vec<f64> =
        folds(&transform, &material, &Control::Force).unwrap().iter().map(|fold| fold.contact_radius).collect();
    let contact = Contact::half_space(&transform, &material, &Control::Force);
    Dugdale::new(contact, &separation(&range)).unwrap().pull_off(&radii).unwrap().unwrap()
}

fn enclosed(formula: &str, range: f64, bits: u32, near: &CohesiveState<f64>) -> Result<CohesiveState<Interval>> {
    let (formula, none) = (formula.parse::<Expression>().unwrap(), Default::default());
    let bound = || formula.enclosed(&none, &formula.breaks(&none).unwrap(), Precision::new(bits)).unwrap();
    let transform = Arc::new(Enclosed::new(bound(), Precision::new(bits)));
    let material = Material::new(number(1.0, bits), number(WORK, bits)).unwrap();
    let contact = Contact::half_space(&transform, &material, &Control::Force);
    let contact = Dugdale::new(contact, &separation(&number(range, bits))).unwrap();
    let profile = Continuation::new(vec![bound()]).unwrap();
    EnclosedPullOff::new(&contact, &profile).near(near.contact_radius, near.outer_radius)
}

fn parts<R: Clone>(state: &CohesiveState<R>) -> [R; 4] {
    [&state.contact_radius, &state.outer_radius, &state.indentation, &state.force].map(Clone::clone)
}

#[test]
fn trial() {
    for formula in PROFILES {
        for range in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
            let start = std::time::Instant::now();
            let near = std::panic::catch_unwind(|| in_doubles(formula, range));
            let Ok(near) = near else { continue };
            let doubles = start.elapsed();
            let start = std::time::Instant::now();
            match enclosed(formula, range, 100, &near) {
                Ok(found) => {
                    let bits = parts(&found).map(|part| part.accuracy_bits());
                    let apart: Vec<f64> = parts(&found).iter().zip(parts(&near)).map(|(x, y)| (x.approx() / y - 1.0) as f32 as f64).collect();
                    println!("{formula} {range} {doubles:?} {:?} {bits:?} {apart:?} y/a {:.1e}", start.elapsed(), near.outer_radius / near.contact_radius - 1.0);
                }
                Err(error) => println!("{formula} {range} {doubles:?} {:?} {error} {near:?}", start.elapsed()),
            }
        }
    }
}
