//! The pull-off of the Maugis–Dugdale theory as enclosures: against the search in doubles, and at few bits.
#![cfg(feature = "mp")]
#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::sync::Arc;

use mdr_core::contact::{Control, Error, Expression, Material, Result};
use mdr_core::number::{Interval, Precision, Real};
use mdr_numeric::contact::Contact;
use mdr_numeric::dugdale::{CohesiveState, Dugdale, separation};
use mdr_numeric::proof::{Continuation, EnclosedPullOff};
use mdr_numeric::transform::{Enclosed, Quadrature};

/// Profiles and ranges with E* = 1 and w = 1e-5, and the contact radius and the outer radius of the pull-off as the search in doubles
/// finds them: from rings that are far wider than the contact to narrow ones, that end at a kink, and that hold one.
const CASES: [(&str, f64, [f64; 2]); 16] = [
    ("r^2/2", 1e-3, [2.0192176182925795e-2, 4.5630064781904685e-2]),
    ("r^2/2", 1e-4, [3.235538561044754e-2, 3.3073918993533305e-2]),
    ("r^2/2", 1e-5, [3.2812318161483896e-2, 3.281976622768028e-2]),
    ("0.5*r", 1e-3, [1.2948847436971818e-4, 2.116017645082093e-3]),
    ("0.5*r", 1e-5, [2.249373692357305e-4, 2.3201425937738432e-4]),
    ("r^1.5", 1e-4, [4.0522277077003266e-3, 4.649053540804015e-3]),
    ("r^3", 1e-3, [5.524126715740933e-2, 9.38220716501903e-2]),
    ("1 - sqrt(1 - r^2)", 1e-3, [2.0174976607871157e-2, 4.560894844428913e-2]),
    ("sqrt(r^2 + 0.01) - 0.1", 1e-3, [2.704909699709238e-3, 1.37680093790584e-2]),
    ("r^2/2 + 0.1*r^3", 1e-4, [3.210598493020726e-2, 3.282432862275246e-2]),
    ("0.3*max(0, r - 0.1)", 1e-3, [9.907900937724251e-3, 1.0077227902000901e-1]),
    ("0.3*max(0, r - 0.1)", 1e-4, [9.925304904187959e-2, 1e-1]),
    ("max(r^2 - 0.01, 0)", 1e-5, [9.999254893105523e-2, 1e-1]),
    ("r^2/2 + max(0, r - 0.03)^2", 1e-3, [2.0174906926617584e-2, 4.55604e-2]),
    ("r^2/2 + 1e-5*(1 - cos(20*pi*r))", 1e-3, [2.0121881349386226e-2, 4.541676193177927e-2]),
    ("r^2/2 + 1e-5*(1 - cos(20*pi*r))", 1e-5, [3.2574467976471906e-2, 3.258191602210159e-2]),
];
const WORK: f64 = 1e-5;

fn number(value: f64, bits: u32) -> Interval {
    Interval::from_f64(Precision::new(bits), value)
}

fn enclosed(formula: &str, range: f64, near: [f64; 2], bits: u32) -> Result<CohesiveState<Interval>> {
    let (formula, none) = (formula.parse::<Expression>().unwrap(), Default::default());
    let bound = || formula.enclosed(&none, &formula.breaks(&none).unwrap(), Precision::new(bits)).unwrap();
    let transform = Arc::new(Enclosed::new(bound(), Precision::new(bits)));
    let material = Material::new(number(1.0, bits), number(WORK, bits)).unwrap();
    let contact = Contact::half_space(&transform, &material, &Control::Force);
    let contact = Dugdale::new(contact, &separation(&number(range, bits))).unwrap();
    let profile = Continuation::new(vec![bound()]).unwrap();
    EnclosedPullOff::new(&contact, &profile).near(near[0], near[1])
}

fn parts<R: Clone>(state: &CohesiveState<R>) -> [R; 4] {
    [&state.contact_radius, &state.outer_radius, &state.indentation, &state.force].map(Clone::clone)
}

/// The states by quadratures of g over the ring: the one with this contact radius, and the forces beside it, which are larger.
#[test]
fn enclosures_are_states_of_least_force_by_quadratures() {
    let mut compared = 0;
    for (formula, range, near) in CASES {
        let found = enclosed(formula, range, near, 80).unwrap_or_else(|error| panic!("{formula}, {range}: {error}"));
        let (parsed, none) = (formula.parse::<Expression>().unwrap(), Default::default());
        let breaks = parsed.breaks(&none).unwrap();
        let transform = Arc::new(Quadrature::new(parsed.bind::<f64>((), &none).unwrap().broken_at((), &breaks)));
        let material = Material::new(1.0, WORK).unwrap();
        let contact = Contact::half_space(&transform, &material, &Control::Force);
        let contact = Dugdale::new(contact, &separation(&range)).unwrap();
        let a = found.contact_radius.approx();
        // Some formulas are not resolved in doubles.
        let Ok(state) = contact.state(&a) else { continue };
        compared += 1;
        for (part, (one, other)) in parts(&found).iter().zip(parts(&state)).enumerate() {
            let off = (one.approx() / other - 1.0).abs();
            // A narrow ring leaves fewer digits of d in doubles.
            assert!(off < [1e-13, 1e-12, 1e-8, 1e-10][part], "{formula}, {range}, {part}: {one} and {other}");
        }
        for beside in [1.0 - 1e-3, 1.0 + 1e-3] {
            let force = contact.state(&(a * beside)).map(|state| state.force);
            assert!(force.is_ok_and(|force| force > state.force), "{formula}, {range}, {beside}");
        }
    }
    assert!(compared > CASES.len() - 3, "{compared}");
}

/// The truth is that of 200 bits; it lies within what is said with few. So few may not suffice for a proof.
#[test]
fn few_bits_contain_the_truth() {
    let mut proved = 0;
    for (formula, range, near) in CASES {
        let truth = enclosed(formula, range, near, 200).unwrap();
        assert!(parts(&truth).iter().all(|part| part.accuracy_bits() > 130), "{formula}, {range}: {truth:?}");
        for bits in [24, 32, 40, 53, 64] {
            let Ok(found) = enclosed(formula, range, near, bits) else {
                assert!(bits < 64, "{formula}, {range} at {bits} bits");
                continue;
            };
            proved += 1;
            for (found, truth) in parts(&found).iter().zip(parts(&truth)) {
                assert!(found.overlaps(&truth), "{formula}, {range} at {bits} bits: {found} without {truth}");
            }
        }
    }
    assert!(proved > 3 * CASES.len(), "{proved}");
}

#[test]
fn nothing_is_proved_where_there_is_no_minimum() {
    for near in [[2.0, 3.0], [1e-9, 1e-3], [0.03, 0.03], [0.03, 0.02], [-1.0, 1.0], [f64::NAN, 1.0]] {
        match enclosed("r^2/2", 1e-3, near, 80) {
            Err(Error::Unproved { .. }) => {}
            // Newton's method may find the only one from afar.
            found => assert!((found.unwrap().contact_radius.approx() / 2.0192176182925795e-2 - 1.0).abs() < 1e-12),
        }
    }
}
