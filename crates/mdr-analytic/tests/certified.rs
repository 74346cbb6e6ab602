//! Certified answers against values computed with another arbitrary-precision library (mpmath, Γ and the definitions
//! (1.13), (1.16)), and the answers that only number theory decides.
#![cfg(feature = "mp")]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use mdr_analytic::certified::{Answer, Elasticity, Question, kappa};
use mdr_analytic::{PowerLaw, PowerLawContact};
use mdr_core::contact::{Body, Control, Error, Material, Quantity, Regime, Result};
use mdr_core::number::Literal;

fn literal(text: &str) -> Literal {
    text.parse().unwrap()
}

fn question(n: &str, c: &str, e_star: &str, work: &str, control: &Control<Literal>) -> Result<Question> {
    let elasticity = Elasticity::Effective(literal(e_star));
    Question::new(&literal(n), &literal(c), &elasticity, &literal(work), control)
}

fn answer(n: &str, c: &str, e_star: &str, work: &str, control: &Control<Literal>, digits: u32) -> Answer {
    question(n, c, e_star, work, control).unwrap().answer(digits).unwrap()
}

fn critical(answer: &Answer) -> [String; 3] {
    let critical = answer.critical.as_ref().unwrap();
    [&critical.contact_radius, &critical.indentation, &critical.force].map(ToString::to_string)
}

fn machine(stiffness: &str) -> Control<Literal> {
    Control::Machine { stiffness: literal(stiffness) }
}

#[test]
fn agrees_with_an_independent_library() {
    let pyramid = answer("0.25", "1", "1e6", "0.05", &Control::Indentation, 25);
    assert_eq!(pyramid.regime, Regime::CompleteContact);
    assert_eq!(
        critical(&pyramid),
        ["1160871185573.421974424115", "603.9026733142962369293113", "-841263854809591215956.4662"]
    );
    assert_eq!(
        critical(&answer("0.3", "1", "1e6", "0.05", &Control::Force, 25)),
        ["14051602782812.98213686809", "8404.228656922386203533037", "9084067906385170254452.003"]
    );
    assert_eq!(
        critical(&answer("2", "0.5", "1", "1", &Control::Indentation, 25)),
        ["0.7322959437807616315100713", "-1.608772047833269200058083", "-2.617993877991494365385536"]
    );
    assert_eq!(
        critical(&answer("2", "0.5", "1", "1", &Control::Force, 25)),
        ["1.523236946344888900859079", "-0.7734169315700339827422363", "-4.712388980384689857693965"]
    );
}

#[test]
fn exact_values_are_decided() {
    assert_eq!(kappa(&literal("2"), 40).unwrap().to_string(), "2.000000000000000000000000000000000000000");
    assert_eq!(kappa(&literal("6"), 1).unwrap().to_string(), "3");
    assert_eq!(kappa(&literal("6"), 3).unwrap().to_string(), "3.20");
    // d = 0 at n = 3/2 under a dead load.
    assert_eq!(critical(&answer("1.5", "7", "3", "0.1", &Control::Force, 30))[1], "0");
    // The cone: −w/(E*C) and 3w/(E*C), here decimal ties at one digit.
    assert_eq!(critical(&answer("1", "2", "1e3", "5", &Control::Indentation, 1))[1], "-0.002");
    assert_eq!(critical(&answer("1", "4", "1", "1", &Control::Indentation, 2))[1], "-0.25");
    assert_eq!(critical(&answer("1", "4", "1", "1", &Control::Force, 2))[1], "0.75");
}

#[test]
fn magnitudes_beyond_every_exponent() {
    // log10 a_c = −336903728823285301868624184808350373738825533598816.012024196870212…
    let near =
        answer("0.50000000000000000000000000000000000000000000000001", "1", "1e6", "0.05", &Control::Indentation, 20);
    let [a, d, f] = critical(&near);
    // 10^(1 − 0.01202419686021224129…), from the same library.
    assert_eq!(a, "9.7269302835452544768e-336903728823285301868624184808350373738825533598817");
    assert!(d.starts_with('-') && f.starts_with('-'));
    let below = answer("0.49999999999", "1", "1e6", "0.05", &Control::Indentation, 20);
    assert_eq!(below.regime, Regime::CompleteContact);
    assert!(critical(&below).iter().all(|value| value.contains('e')));
}

/// The range of MPFR ends at 10^±323228496.
#[test]
fn radii_about_the_end_of_the_range_have_digits() {
    for c in ["1.770", "1.765", "1.760", "2.075", "2.080", "2.085"] {
        let answer = answer("0.5000000001", c, "1", "1", &Control::Indentation, 20);
        let radius = answer.critical.unwrap().contact_radius.log10_f64();
        let contact = PowerLawContact::new(
            PowerLaw::new(0.5000000001, c.parse().unwrap()).unwrap(),
            Material::new(1.0, 1.0).unwrap(),
        );
        let expected = contact.ln_critical(&Control::Indentation).unwrap().contact_radius / std::f64::consts::LN_10;
        assert!(
            (3e8..4e8).contains(&radius.abs()) && (radius / expected - 1.0).abs() < 1e-5,
            "{c}: {radius} {expected}"
        );
    }
}

#[test]
fn threshold_at_one_half() {
    // (2/ϖ)√(2πw/E*): the lemniscate constant and 2/ϖ are A062539 and 2/A062539 of the OEIS.
    let scale_free = answer("1/2", "1", "1", "1", &Control::Indentation, 20);
    assert_eq!(scale_free.regime, Regime::ScaleFree);
    assert_eq!(scale_free.kappa.to_string(), "1.3110287771460599052");
    assert!(scale_free.critical.is_none());
    let threshold = scale_free.threshold.unwrap().to_f64();
    assert!((threshold / (0.762_759_763_501_813_2 * std::f64::consts::TAU.sqrt()) - 1.0).abs() < 1e-15);
    let force = answer("0.5", "1", "1", "1", &Control::Force, 20).threshold.unwrap().to_f64();
    assert!((force / threshold - 3.0).abs() < 1e-15);
}

#[test]
fn a_compliant_machine_has_three_folds() {
    let folds = answer("0.6", "2.4829", "1", "1", &machine("1"), 30).folds;
    assert_eq!(folds.len(), 3);
    for (fold, radius) in folds.iter().zip([0.01271, 0.06940, 459.2]) {
        // The references have four digits.
        assert!((fold.contact_radius.to_f64() / radius - 1.0).abs() < 5e-4);
    }
    // The paraboloid with k/(2E*a_c) = 1: a/a_c = 1.72526627…, a_c = (π/8)^{1/3}.
    let a_c = (std::f64::consts::PI / 8.0).cbrt();
    let stiffness = format!("{}", 2.0 * a_c);
    let ball = answer("2", "0.5", "1", "1", &machine(&stiffness), 20);
    let ratio = ball.critical.unwrap().contact_radius.to_f64() / a_c;
    assert!((ratio / 1.725_266_27 - 1.0).abs() < 3e-9);
}

#[test]
fn a_machine_at_one_half() {
    // ρ = 1.3110287…·C/√(2π) = 2 for C = 2√(2π)/1.3110…: s = (ρ−1)/(3−ρ).
    let one = answer("0.5", "3.8", "1", "1", &machine("2"), 20);
    let rho = 1.311_028_777_146_059_9 * 3.8 / std::f64::consts::TAU.sqrt();
    let a = one.folds[0].contact_radius.to_f64();
    assert!((a / ((rho - 1.0) / (3.0 - rho)) - 1.0).abs() < 1e-14);
    assert!(answer("0.5", "1", "1", "1", &machine("2"), 20).folds.is_empty());
    assert!(answer("0.5", "9", "1", "1", &machine("2"), 20).critical.is_none());
}

#[test]
fn fewer_digits_are_the_rounding_of_more() {
    for (n, control) in
        [("0.3", Control::Indentation), ("7/3", Control::Force), ("0.50001", machine("3")), ("12.5", machine("1e-9"))]
    {
        let long = answer(n, "1.5", "1e6", "0.05", &control, 400);
        for digits in [1, 2, 17, 50, 200] {
            let short = answer(n, "1.5", "1e6", "0.05", &control, digits);
            for (short, long) in critical(&short).iter().zip(critical(&long)) {
                let bits = 3000;
                let parse = |text: &str| rug::Float::with_val(bits, rug::Float::parse(text).unwrap());
                let difference: rug::Float = (parse(short) - parse(&long)) / parse(&long);
                // Half a unit in the last of `digits` digits is at most 10^(1−digits)/2 of the value.
                assert!(difference.abs() <= 0.5 * 10f64.powi(1 - digits as i32) * 1.000001, "{n} {digits}: {short}");
            }
        }
    }
}

#[test]
fn many_digits() {
    let long = answer("1/3", "1.5", "1e6", "0.05", &Control::Indentation, 10_000);
    assert!(critical(&long).iter().all(|text| text.bytes().filter(u8::is_ascii_digit).count() >= 10_000));
}

#[test]
fn bad_input_is_named() {
    let control = Control::Indentation;
    for (n, c, e, w, quantity) in [
        ("0", "1", "1", "1", Quantity::Exponent),
        ("-1", "1", "1", "1", Quantity::Exponent),
        ("1", "-2", "1", "1", Quantity::Coefficient),
        ("1", "1", "0", "1", Quantity::EffectiveModulus),
        ("1", "1", "1", "-0.5", Quantity::WorkOfAdhesion),
    ] {
        match question(n, c, e, w, &control) {
            Err(Error::Domain { quantity: named, .. }) => assert_eq!(named, quantity),
            other => panic!("{other:?}"),
        }
    }
    assert!(question("1", "1", "1", "1", &machine("-1")).is_err());
    for digits in [0, 1_000_001, u32::MAX] {
        let refused = question("1", "1", "1", "1", &control).unwrap().answer(digits);
        assert!(matches!(refused, Err(Error::Domain { quantity: Quantity::Digits, .. })));
        assert!(kappa(&literal("0.3"), digits).is_err());
    }
    // 1/2 + 10⁻⁹⁰⁰⁰⁰ is rejected at once, not after hours.
    let hopeless = format!("0.5{}1", "0".repeat(89_998));
    let refused = question(&hopeless, "1", "1", "1", &control).unwrap().answer(5);
    assert!(matches!(refused, Err(Error::Undecided { .. })));
    let body = |e: &str, nu: &str| Body { youngs_modulus: literal(e), poissons_ratio: literal(nu) };
    let with = |first, second| {
        Question::new(&literal("2"), &literal("1"), &Elasticity::bodies(first, second), &literal("1"), &control)
    };
    assert!(with(body("1", "0.6"), body("1", "0.3")).is_err());
    assert!(with(body("1", "-1"), body("1", "0.3")).is_err());
    // 1/E* = 2·(1 − 1/4)/E: two equal bodies with ν = 1/2 have E* = 2E/3.
    let two = with(body("3", "0.5"), body("3", "1/2")).unwrap();
    assert_eq!(two, question("2", "1", "2", "1", &control).unwrap());
}
