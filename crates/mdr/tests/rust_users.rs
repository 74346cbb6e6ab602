//! Contacts of a Rust program: profiles from closures, from slices, and transforms of its own.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "in a test a panic is a verdict")]

use std::f64::consts::PI;

use mdr::columns::{Choice, ContactColumns};
use mdr::contact::{Function, folds};
use mdr::prelude::*;

/// f = r⁴/4, from a closure.
fn quartic() -> Function {
    Function::new(|r| [r.powi(4) / 4.0, r.powi(3), 3.0 * r.powi(2)]).expect("f(0) = 0")
}

fn on_rubber(profile: impl mdr::scene::IntoProfile) -> Scene {
    Scene::new(profile, Elasticity::effective(1).expect("E*"), "0.01").expect("a scene").arithmetic(Arithmetic::F64)
}

/// A scene with everything: folds, equilibria, a path with its energies, a field, the transform.
fn asked(scene: Scene) -> Answer {
    let numbers = |texts: &[&str]| texts.iter().map(|text| text.parse().expect("a number")).collect::<Vec<Literal>>();
    scene
        .path(["0.1", "-0.4"])
        .expect("numbers")
        .want(Want::Transform { at: numbers(&["0.3", "0.7"]) })
        .want(Want::Folds { range: None })
        .want(Want::Equilibria { at: numbers(&["-0.05"]) })
        .want(Want::Curve { at: numbers(&["0.5"]) })
        .want(Want::Path)
        .solve()
        .expect("an answer")
}

/// Every number of the answer to a closure is that of the closed form of its power law, to the rounding of quadratures times the
/// condition at the folds.
#[test]
fn a_scene_from_a_closure_solves_as_the_power_law_does() {
    let law = Shape::Power { n: "4", c: "0.25" };
    let media = [
        ExactMedium::HalfSpace,
        ExactMedium::Winkler { modulus: "1".parse().expect("K") },
        ExactMedium::Graded {
            exponent: "0.3".parse().expect("k"),
            stiffness: Grading::Coefficient("1".parse().expect("c")),
        },
    ];
    for medium in media {
        let name = medium.name();
        let [own, closed] = [on_rubber(quartic()), on_rubber(law.clone())]
            .map(|scene| asked(scene.medium(medium.clone()).expect("a medium")));
        assert_eq!(own.profile, "function");
        let folds = [&own, &closed].map(|answer| answer.folds().expect("wanted").items.clone());
        // On a foundation the depth rises from the tip on, without a fold.
        assert_eq!(folds.each_ref().map(Vec::len), [usize::from(name != "winkler"); 2], "{name}");
        let of = |value: &Value| value.to_f64().expect("a number");
        for (one, other) in folds[0].iter().zip(&folds[1]) {
            assert!((of(&one.contact_radius) / of(&other.contact_radius) - 1.0).abs() < 1e-7, "{name}");
            assert!((of(&one.force) / of(&other.force) - 1.0).abs() < 1e-7, "{name}");
            assert!((of(&one.indentation) / of(&other.indentation) - 1.0).abs() < 1e-12, "{name}");
        }
        let events = [&own, &closed].map(|answer| {
            let events = &answer.path().expect("wanted").events.items;
            events.iter().map(|event| event.event).collect::<Vec<_>>()
        });
        assert_eq!(events[0], events[1], "{name}");
        assert!(events[0].contains(&EventKind::Detached), "{name}");
    }
}

/// A function over numbers that carry their derivatives is the function with its derivatives written by hand.
#[test]
fn a_function_of_duals_is_that_with_derivatives() {
    use mdr_core::number::Real;
    let duals = Function::differentiated(|r| r.square().square().over(4)).expect("f(0) = 0");
    let [one, other] = [duals, quartic()].map(|tip| on_rubber(tip).contact().expect("a contact").state(&0.5).unwrap());
    assert!((one.0 / other.0 - 1.0).abs() < 1e-14 && (one.1 / other.1 - 1.0).abs() < 1e-14);
}

/// Slices are a measured profile: rows of r²/2R have JKR's pull-off force to the square of their spacing.
#[test]
fn slices_are_a_profile() {
    let radii: Vec<f64> = (0..=400).map(|i| f64::from(i) * 2.5e-3).collect();
    let heights: Vec<f64> = radii.iter().map(|r| r * r / 2.0).collect();
    let rows = Measured::from_rows(&radii, &heights).expect("rows");
    let contact = on_rubber(rows).control(Control::Force).contact().expect("a contact");
    let pull_off = folds::find(&contact).expect("folds").iter().map(|fold| fold.force).fold(0.0, f64::min);
    assert!((pull_off / (-1.5 * PI * 0.01) - 1.0).abs() < 1e-3, "{pull_off}");
}

/// Arrays of states, kinks and an outer radius of a function; and a sum of a function and a shape.
#[test]
fn functions_have_arrays_kinks_and_sums() {
    // A flat of radius 0.3 with a cone around it, which ends at 2.
    let blunt = Function::new(|r| if r > 0.3 { [r - 0.3, 1.0, 0.0] } else { [0.0; 3] })
        .and_then(|tip| tip.with_kinks([0.3]))
        .and_then(|tip| tip.with_outer_radius(2.0))
        .expect("a profile");
    let known = Shape::TruncatedCone { flank: Flank::Slope("1"), flat: "0.3" };
    let pulled = |scene: &Scene| {
        let columns = ContactColumns::new(scene).expect("a contact");
        let states = columns.states(&Control::Force, &[0.0, 0.5], Choice::Largest).expect("states");
        assert_eq!(states.status, [Status::Ok, Status::Ok]);
        states.contact_radius
    };
    let [own, closed] = [pulled(&on_rubber(blunt)), pulled(&on_rubber(known))];
    assert!(own.iter().zip(&closed).all(|(one, other)| (one / other - 1.0).abs() < 1e-9), "{own:?} {closed:?}");
    let sphere = Profile::Shape(Shape::Paraboloid { radius: "1".parse().expect("R") });
    let sum = on_rubber(Profile::Sum(vec![Profile::Function(quartic()), sphere]));
    let (d, _) = sum.contact().expect("a contact").state(&0.5).expect("a state");
    // κ₄/4 = 2/3: g = (2/3)·a⁴ + a².
    let expected = 0.5_f64.powi(4) * 2.0 / 3.0 + 0.25 - (2.0 * PI * 0.5 * 0.01).sqrt();
    assert!((d / expected - 1.0).abs() < 1e-13, "{d} {expected}");
}

/// A function has 53 bits: other arithmetics are refused, with the remedy.
#[test]
fn digits_of_a_function_are_refused() {
    let scene = on_rubber(quartic()).want(Want::Folds { range: None });
    let certified = scene.clone().arithmetic(Arithmetic::Certified { digits: 20 }).solve().expect_err("f64 only");
    assert!(certified.to_string().contains("Arithmetic::F64"), "{certified}");
    #[cfg(feature = "mp")]
    {
        use mdr_core::number::{Interval, Precision};
        let Err(enclosed) = scene.contact_in::<Interval>(Precision::new(100)) else { panic!("f64 only") };
        assert!(enclosed.to_string().contains("f64"), "{enclosed}");
    }
}

/// The error of a quadrature is estimated and bounds nothing: over enclosures it is refused, with the remedy. The rigorous integrals
/// of the scene enclose what f64 has.
#[cfg(feature = "mp")]
#[test]
fn a_quadrature_is_refused_over_enclosures() {
    use mdr_core::number::{Dual, Interval, Precision, Real};
    fn transformed<R: mdr::contact::ProfileReal>(ctx: R::Ctx) -> Result<R, mdr::ContactError> {
        let formula = Profile::Formula(Formula::new("r^2/(1 + r)", [].into()).expect("a formula"));
        formula.transform::<R>(ctx, &mut |literal| R::from_literal(ctx, literal))?.g(&R::from_f64(ctx, 0.5))
    }
    let precision = Precision::new(100);
    let refusals = [transformed::<Interval>(precision).err(), transformed::<Dual<Interval>>(precision).err()];
    for refusal in refusals {
        let refusal = refusal.expect("no enclosure").to_string();
        assert!(refusal.contains("quadrature") && refusal.contains("f64"), "{refusal}");
    }
    let scene = on_rubber(Formula::new("r^2/(1 + r)", [].into()).expect("a formula"));
    let enclosed = scene.contact_in::<Interval>(precision).expect("a contact");
    let enclosed = enclosed.transform().g(&Interval::from_f64(precision, 0.5)).expect("an enclosure");
    let values = [transformed::<f64>(()), transformed::<rug::Float>(precision).map(|value| value.approx())];
    for value in values.map(|value| value.expect("a number")) {
        assert!((enclosed.approx() / value - 1.0).abs() < 1e-14, "{enclosed:?} {value}");
    }
}

/// A function is no formula in what is said of its states.
#[test]
fn doubts_about_a_function_name_a_function() {
    let answer = asked(on_rubber(quartic()));
    let basis = mdr::answer::described(answer.admissibility.expect("states"));
    assert!(basis.contains("g of a function was searched") && !basis.contains("formula"), "{basis}");
    let admissions = answer.folds().expect("wanted").items.iter().map(|fold| &fold.admissible);
    let doubts: Vec<_> = admissions
        .filter_map(|admissible| match admissible {
            mdr::answer::Admission::Unknown { why } => Some(*why),
            _ => None,
        })
        .collect();
    assert!(!doubts.is_empty() && doubts.iter().all(|why| !why.contains("formula")), "{doubts:?}");
}
