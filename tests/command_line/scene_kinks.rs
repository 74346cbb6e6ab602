//! Formulas with kinks, in plain sight and hidden, against the closed forms of the same profiles.

use serde_json::Value;

use crate::{events, mdr, number, solved};

fn scene(profile: &str, scale: f64, rest: &str) -> String {
    format!(
        "[material]\ne_star = 1\nwork_of_adhesion = \"{}\"\n[profile]\n{profile}\n[control]\nkind = \"indentation\"\n{rest}\n",
        1e-2 * scale
    )
}

fn formula(text: &str, scale: f64) -> String {
    format!("kind = \"expression\"\nformula = \"{text}\"\nparameters = {{ b = \"{scale}\" }}")
}

/// Numbers below an answer, in the order of its keys.
fn numbers(value: &Value, found: &mut Vec<f64>) {
    match value {
        Value::Array(items) => items.iter().for_each(|item| numbers(item, found)),
        Value::Object(fields) => {
            fields.iter().filter(|(key, _)| *key != "why").for_each(|(_, item)| numbers(item, found))
        }
        Value::String(text) => found.extend(text.parse::<f64>()),
        Value::Number(_) => found.push(number(value)),
        _ => {}
    }
}

/// Pairs of one profile by its kind and as formulas, at three scales.
const SAME: [(&str, &[&str]); 4] = [
    (
        "kind = \"truncated-cone\"\nslope = 2\nflat = \"1b\"",
        &["2*max(0, r - b)", "sqrt((r - b)^2) + r - b", "abs(r - b) + r - b", "2*r - 2*min(r, b)"],
    ),
    (
        "kind = \"truncated-paraboloid\"\nradius = \"2b\"\nflat = \"1b\"",
        &["max(r^2 - b^2, 0)/(4*b)", "(abs(r^2 - b^2) + r^2 - b^2)/(8*b)"],
    ),
    ("kind = \"rounded-punch\"\nradius = \"3b\"\nflat = \"1b\"", &["max(0, r - b)^2/(6*b)"]),
    ("kind = \"cone-parabolic-cap\"\nslope = \"0.5\"\ncap = \"1b\"", &["min(r, b)^2/(4*b) + max(0, r - b)/2"]),
];

#[test]
fn formulas_with_kinks_are_their_profiles() {
    for scale in [1e-140, 1.0, 1e140] {
        for (kind, formulas) in SAME {
            let kind = ["1b", "2b", "3b"].iter().zip([1.0, 2.0, 3.0]).fold(kind.to_owned(), |kind, (name, factor)| {
                kind.replace(&format!("\"{name}\""), &format!("\"{:e}\"", factor * scale))
            });
            let radii: Vec<_> = [1.001, 1.5, 7.0].map(|x| format!("\"{:e}\"", x * scale)).to_vec();
            let wants = format!("[output]\nwant = [\"folds\", \"transform\"]\ntransform.at = [{}]", radii.join(", "));
            let truth = solved(&scene(&kind, scale, &wants), "--digits 15");
            for text in formulas {
                // Hardware arithmetic has a scale that it may lose; the others have none.
                for flags in ["--f64", "--digits 12"].into_iter().take(if scale == 1.0 { 2 } else { 1 }) {
                    let answer = solved(&scene(&formula(text, scale), scale, &wants), flags);
                    for key in ["folds", "transform"] {
                        let (mut expected, mut found) = (Vec::new(), Vec::new());
                        numbers(&truth[key], &mut expected);
                        numbers(&answer[key], &mut found);
                        assert_eq!(found.len(), expected.len(), "{text}, {flags}: {answer}\n{truth}");
                        for (found, expected) in found.iter().zip(&expected) {
                            let near = (found - expected).abs() <= 1e-11 * expected.abs();
                            assert!(near, "{text}, {flags}, {key}: {found} {expected}\n{answer}");
                        }
                    }
                }
            }
        }
    }
}

/// The path over a kink, with its energy.
#[test]
fn a_path_over_a_kink() {
    let rest = "path = [1, -1]\n[output]\nwant = [\"path\"]";
    let truth = solved(&scene("kind = \"truncated-cone\"\nslope = 2\nflat = 1", 1.0, rest), "--digits 10");
    let answer = solved(&scene(&formula("sqrt((r - b)^2) + r - b", 1.0), 1.0, rest), "--digits 8");
    assert_eq!(events(&answer), events(&truth));
    for key in ["work", "dissipated", "stored"] {
        let [found, expected] = [&answer, &truth].map(|answer| number(&answer["balance"][key]));
        assert!((found / expected - 1.0).abs() < 1e-7, "{key}: {found} {expected}");
    }
}

#[test]
fn what_is_no_profile_is_refused() {
    for (text, why) in [
        ("log(1 + r)", "column 1: unknown function `log`; the natural logarithm is `ln`, the decimal one `log10`"),
        ("b*atan(1/(r - b)) + b*atan(1/b)", "jumps at r = 1"),
        ("min(r)", "column 6: `min` needs two arguments"),
    ] {
        let scene = scene(&formula(text, 1.0), 1.0, "[output]\nwant = [\"folds\"]");
        let assert = mdr("solve -").stdin(scene).assert().code(2).stdout_eq("");
        let message = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
        assert!(message.starts_with("error: <stdin>:6: profile.formula: ") && message.contains(why), "{message}");
    }
}

/// Of kinks without end the first are proved, those beyond a range are not looked at, and the answer says that there are more. Folds where
/// the tangency condition is zero by a quadrature of mpmath, and at the kink π/20.
#[test]
fn the_first_of_many_kinks_are_proved() {
    const FOLDS: [f64; 5] =
        [0.015_045_343_423, 0.055_977_723_125, std::f64::consts::PI / 20.0, 0.249_543_875_876, 0.303_860_948_244];
    for (range, end) in [("folds.range = [\"1e-3\", \"0.6\"]", 0.6), ("", 2.6)] {
        let rest = format!("[output]\nwant = [\"folds\"]\ndigits = 5\n{range}");
        let text = scene("kind = \"expression\"\nformula = \"r^2/2 + 0.01*abs(sin(20*r))\"", 0.1, &rest);
        let answer = solved(&text, "");
        assert_eq!(answer["promise"]["folds"], "certified", "{answer}");
        let complete = &answer["complete"]["folds"];
        assert!(complete["proved"] == true && number(&complete["to"]) < end + 1e-9, "{complete}");
        assert_eq!(
            complete["why"].as_str().unwrap().contains("sees more folds or kinks"),
            range.is_empty(),
            "{complete}"
        );
        let folds: Vec<f64> =
            answer["folds"].as_array().unwrap().iter().map(|fold| number(&fold["contact_radius"])).collect();
        assert_eq!(folds.len(), FOLDS.len(), "{folds:?}");
        assert!(folds.iter().zip(FOLDS).all(|(found, fold)| (found / fold - 1.0).abs() < 1e-4), "{folds:?}");
    }
}
