//! The curve of equilibria in logarithms against the closed forms in their own variables.

#![cfg(feature = "mp")]
#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use mdr_analytic::certified::{Curve, Elasticity, Question};
use mdr_analytic::{PowerLaw, PowerLawContact};
use mdr_core::contact::{Control, Material, Result};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Interval, Literal, Precision};
use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use rug::Rational;

const BITS: u32 = 160;

fn literal(text: &str) -> Literal {
    text.parse().unwrap()
}

struct Case {
    curve: Curve,
    contact: PowerLawContact<Interval>,
    control: Control<Interval>,
}

fn case([n, c, e_star, work, k]: [&str; 5], control: &Control<()>) -> Result<Case> {
    let number = |text: &str| Interval::from_rational(Precision::new(BITS), &literal(text).to_rational());
    let (exact, control) = match control {
        Control::Indentation => (Control::Indentation, Control::Indentation),
        Control::Force => (Control::Force, Control::Force),
        Control::Machine { .. } => {
            (Control::Machine { stiffness: literal(k) }, Control::Machine { stiffness: number(k) })
        }
    };
    let elasticity = Elasticity::Effective(literal(e_star));
    let question = Question::new(&literal(n), &literal(c), &elasticity, &literal(work), &exact)?;
    let contact =
        PowerLawContact::new(PowerLaw::new(number(n), number(c))?, Material::new(number(e_star), number(work))?);
    Ok(Case { curve: question.curve(Precision::new(BITS))?, contact, control })
}

fn value(enclosure: Enclosure) -> Interval {
    match enclosure {
        Enclosure::Value(value) => value,
        other => panic!("{other:?}"),
    }
}

/// Every state found is an equilibrium, with its energy, and none is missed: a branch between two radii at which the
/// controlled quantity is on either side of a value contains one.
#[test]
fn states_are_those_of_the_closed_forms() -> Result<()> {
    let mut random = StdRng::seed_from_u64(13);
    for round in 0..150 {
        let n = match round % 5 {
            0 => "0.5".to_owned(),
            1 => format!("{:.12}", 0.5 + random.random_range(-0.01..0.01)),
            2 => format!("{:.6}", random.random_range(0.5..0.77)),
            _ => format!("{:.5}", random.random_range(-4.0..3.5f64).exp()),
        };
        let mut size = || format!("{:.4e}", random.random_range(-9.0..9.0f64).exp());
        let [c, e_star, work, k, x] = [(); 5].map(|()| size());
        let control = match round % 3 {
            0 => Control::Indentation,
            1 => Control::Force,
            _ => Control::Machine { stiffness: () },
        };
        let Case { curve, contact, control } = case([&n, &c, &e_star, &work, &k], &control)?;
        let about = format!("n = {n}, C = {c}, E* = {e_star}, w = {work}, k = {k}");
        for sign in [-1, 0, 1] {
            let x: Rational = literal(&x).to_rational() * sign;
            let points = curve.equilibria(&x)?;
            for point in &points {
                let a = value(point.radius().enclosure());
                let (d, force) = (contact.indentation(&a)?, contact.force(&a)?);
                let found = value(curve.force(point).enclosure());
                assert!(found.overlaps(&force), "{about}: F at {x}, a = {a}: {found} {force}");
                assert!(value(point.indentation().enclosure()).overlaps(&d), "{about}: d at {x}");
                assert!(control.controlled(&d, &force).contains(&rug::Float::with_val(BITS, &x)), "{about}: {x}");
                let energy = contact.energy(&a, &d)?;
                assert!(value(curve.energy(point).enclosure()).overlaps(&energy), "{about}: Π at {x}");
            }
            let Control::Machine { .. } = control else {
                let x = Interval::from_rational(Precision::new(BITS), &x);
                let known = contact.equilibria(&control, &x)?;
                assert_eq!(points.len(), known.as_slice().len(), "{about}: at {x}");
                for (point, known) in points.iter().zip(known.as_slice()) {
                    assert!(value(point.radius().enclosure()).overlaps(&known.contact_radius), "{about}: a at {x}");
                    assert_eq!(point.stability, known.stability, "{about}: at {x}");
                }
                continue;
            };
        }
    }
    Ok(())
}

/// Values next to a fold, on both sides of it.
#[test]
fn states_beside_a_fold_are_found() -> Result<()> {
    for (n, control) in [("0.55062", Control::Force), ("2", Control::Indentation), ("0.3", Control::Force)] {
        let Case { curve, .. } = case([n, "8.16591", "86", "0.17", "1"], &control)?;
        let fold = value(curve.controlled(&curve.folds()[0].0).enclosure());
        for bits in [8, 14, 30, 60] {
            let middle = fold.lower().to_rational().unwrap();
            let off = Rational::from(&middle >> bits);
            let (beyond, within) = (Rational::from(&middle + &off), middle - off);
            assert_eq!(curve.equilibria(&beyond)?.len(), 0, "n = {n}, 2^-{bits} beyond");
            assert_eq!(curve.equilibria(&within)?.len(), 2, "n = {n}, 2^-{bits} before");
        }
    }
    Ok(())
}

/// No exponent range limits the search: radii of 10^(10^20) and beyond.
#[test]
fn no_scale_is_out_of_reach() -> Result<()> {
    let Case { curve, .. } = case(["0.50000000000000000001", "1e5", "1", "1", "1"], &Control::Indentation)?;
    let Enclosure::Log { ln_magnitude, .. } = curve.folds()[0].0.radius().enclosure() else { panic!() };
    assert!(ln_magnitude.upper().to_f64() < -1e20);
    for (x, count) in [("1", 1), ("-1", 0), ("0", 1)] {
        assert_eq!(curve.equilibria(&literal(x).to_rational())?.len(), count, "{x}");
    }
    Ok(())
}
