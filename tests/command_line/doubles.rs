//! `mdr critical --f64`.

use serde_json::Value;

use crate::reference::{FOLDS, STATES};
use crate::{critical, output, text};

const QUANTITIES: [&str; 3] = ["contact_radius", "indentation", "force"];

/// Units in the last place between two doubles of the same sign.
fn ulps(x: f64, y: f64) -> u64 {
    assert!(x.is_finite() && y.is_finite() && x.is_sign_negative() == y.is_sign_negative(), "{x} and {y}");
    x.to_bits().abs_diff(y.to_bits())
}

/// 2 ulp is the promise of the f64 path. The inputs are the nearest doubles, so the certified answer is asked for those.
fn close_to_certified(flags: &str) {
    let double = critical(&format!("{flags} --f64"));
    assert_eq!(text(&double, "arithmetic"), "f64");
    assert_eq!(double["digits"], Value::Null);
    let inputs = double["inputs"].as_object().unwrap();
    let exact = inputs
        .iter()
        .map(|(key, value)| format!("--{} {}", key.replace('_', "-"), exact(value.as_f64().unwrap())))
        .collect::<Vec<_>>()
        .join(" ");
    let control = text(&double, "control");
    // 40 digits round to the nearest double.
    let certified = critical(&format!("{exact} --control {control} --digits 40"));
    let compare = |found: &Value, truth: &Value, key: &str| {
        let truth = truth[key].as_str().unwrap();
        let nearest: f64 = truth.parse().unwrap();
        if nearest.is_normal() {
            assert!(ulps(found[key].as_f64().unwrap(), nearest) <= 2, "{key}: {} and {truth}, {flags}", found[key]);
        } else if nearest == 0.0 && truth == "0" {
            assert_eq!(found[key], 0.0, "{flags}");
        } else if !nearest.is_finite() || nearest == 0.0 {
            assert_eq!(found[key], Value::Null, "{flags}");
            let exponent: f64 = truth.split_once('e').unwrap().1.parse().unwrap();
            let log10 = found[format!("log10_{key}")].as_f64().unwrap();
            // The decimal exponent of the truth is the floor of the logarithm.
            assert!((-1e-9..1.0 + 1e-9).contains(&(log10 - exponent)), "{key}: {log10} and {truth}, {flags}");
        }
    };
    compare(&double, &certified, "kappa");
    for key in QUANTITIES {
        compare(&double, &certified, key);
    }
    if let Some(folds) = certified["folds"].as_array() {
        for (found, truth) in double["folds"].as_array().unwrap().iter().zip(folds) {
            for key in QUANTITIES {
                compare(found, truth, key);
            }
            assert_eq!(found["kind"], truth["kind"]);
        }
        assert_eq!(double["folds"].as_array().unwrap().len(), folds.len());
    }
}

/// A double as the fraction of two integers that it is.
fn exact(value: f64) -> String {
    let (mut numerator, mut power) = (value, 0);
    while numerator.fract() != 0.0 {
        numerator *= 2.0;
        power += 1;
    }
    assert!(power < 127 && numerator < 1e30, "{value}");
    format!("{}/{}", numerator as u128, 1u128 << power)
}

#[test]
fn within_two_units_in_the_last_place() {
    for (flags, _) in STATES {
        close_to_certified(flags);
    }
}

/// n = 1/2 ± 2^−k, where 1/(2n−1) is 2^(k−1); the scales are chosen so that results stay in range as long as they can.
#[test]
fn next_to_one_half() {
    for k in [3, 10, 20, 30, 40, 50] {
        for sign in [-1.0, 1.0] {
            let n = 0.5 + sign * 0.5_f64.powi(k);
            close_to_certified(&format!("--n {n} --c 1.9120284409437256 --e-star 1 --work 1"));
        }
    }
}

#[test]
fn folds_on_a_machine() {
    for (flags, _) in FOLDS {
        close_to_certified(flags);
    }
}

#[test]
fn numbers_are_json_numbers() {
    let answer = critical("--n 1.5 --c 12 --e-star 2e6 --work 0.07 --control force --f64");
    let inputs = serde_json::json!({"n": 1.5, "c": 12.0, "e_star": 2e6, "work": 0.07});
    assert_eq!(answer["inputs"], inputs);
    assert_eq!(answer["indentation"], 0.0, "the exact zero");
    assert_eq!(text(&answer, "status"), "ok");
    assert!(answer["kappa"].is_f64());
    let bodies = critical("--n 2 --c 1 --e1 3 --nu1 0.5 --e2 2 --nu2 -0.2 --work 1 --f64");
    // (1.3) in f64: four roundings in each compliance, one sum, one reciprocal.
    assert!((bodies["inputs"]["e_star"].as_f64().unwrap() * 0.73 - 1.0).abs() < 8.0 * f64::EPSILON);
}

#[test]
fn out_of_range_is_said_with_the_logarithm() {
    // mpmath: a = 1.47…e-4678, d = -3.25…e-2343, F = -2.24…e-7016
    let answer = critical("--n 0.5001 --c 3 --e-star 7 --work 2 --f64");
    assert_eq!(text(&answer, "status"), "underflow");
    for (key, exponent) in QUANTITIES.into_iter().zip([-4678, -2343, -7016]) {
        assert_eq!(answer[key], Value::Null);
        assert_eq!(answer[format!("log10_{key}")].as_f64().unwrap().floor(), f64::from(exponent));
    }
    let answer = critical("--n 0.4999 --c 3 --e-star 7 --work 2 --f64");
    assert_eq!(text(&answer, "status"), "overflow");
    assert_eq!(answer["force"], Value::Null);
    assert_eq!(answer["log10_force"].as_f64().unwrap().floor(), 7014.0);
    // Only the force is too large: F = -1.44…e+423.
    let answer = critical("--n 0.501 --c 1e-3 --e-star 1e5 --work 0.1 --f64");
    assert_eq!(text(&answer, "status"), "overflow");
    assert!(answer["contact_radius"].is_f64() && answer["indentation"].is_f64());
    assert!(answer.get("log10_contact_radius").is_none());
    assert_eq!(answer["log10_force"].as_f64().unwrap().floor(), 423.0);
    let table = output("critical --n 0.501 --c 1e-3 --e-star 1e5 --work 0.1 --f64");
    assert!(table.contains("overflow: about 10^423."), "{table}");
    let csv = output("critical --n 0.501 --c 1e-3 --e-star 1e5 --work 0.1 --f64 --format csv");
    assert!(csv.contains(",overflow,") && csv.contains(",423."), "{csv}");
}

#[test]
fn scale_free() {
    let answer = critical("--n 0.5 --c 2 --e-star 1e6 --work 0.05 --f64");
    assert_eq!(text(&answer, "regime"), "scale-free");
    assert_eq!(answer["contact_radius"], Value::Null);
    let threshold = answer["threshold_c"].as_f64().unwrap();
    // Inputs and the result each within half an ulp, the threshold within 2 ulp.
    assert!((threshold / 0.00042752617746494243 - 1.0).abs() < 4.0 * f64::EPSILON);
    assert!((answer["ratio"].as_f64().unwrap() * threshold / 2.0 - 1.0).abs() < 4.0 * f64::EPSILON);
    let beyond = critical("--n 0.5 --c 1e300 --e-star 1e30 --work 1e-30 --f64");
    assert_eq!((text(&beyond, "status"), &beyond["ratio"]), ("overflow", &Value::Null));
    // 10³⁰⁰ · 10³⁰/(0.7627…·√(2π))
    assert!((beyond["log10_ratio"].as_f64().unwrap() - 329.7185).abs() < 1e-3);
    // 1/2 + 10⁻³⁰ is 1/2 as a double, and is not 1/2.
    let near = "--n 0.500000000000000000000000000001 --c 2 --e-star 1e6 --work 0.05";
    assert_eq!(text(&critical(&format!("{near} --f64")), "regime"), "scale-free");
    assert_eq!(text(&critical(near), "regime"), "pull-off");
}
