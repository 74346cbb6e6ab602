//! `mdr solve --budget`: every search ends, and what is left over is `undecided`.

use std::time::{Duration, Instant};

use serde_json::Value;

use crate::{solved, text};

fn scene(e_star: &str, work: &str, profile: &str, rest: &str) -> String {
    format!("material = {{ e_star = \"{e_star}\", work_of_adhesion = \"{work}\" }}\nprofile = {{ {profile} }}\n{rest}")
}

fn formula(text: &str) -> String {
    format!("kind = \"expression\", formula = \"{text}\"")
}

fn path(from: &str, to: &str) -> String {
    format!(
        "control = {{ kind = \"indentation\", path = [\"{from}\", \"{to}\"] }}\noutput = {{ want = [\"folds\", \"path\"] }}"
    )
}

fn wavy(amplitude: &str, wavelength: &str) -> String {
    format!("kind = \"wavy-paraboloid\", radius = 1, amplitude = \"{amplitude}\", wavelength = \"{wavelength}\"")
}

/// Whether the folds were all found, or the answer says that they were not.
fn says_what_is_left(answer: &Value) {
    let folds = &answer["complete"]["folds"];
    let why = text(folds, "why");
    assert!(folds["proved"] == false && (why.contains("budget") || why.contains("not resolved")), "{answer}");
}

/// These took minutes, or had no end. The budget is a twentieth of a second of a release build; the limit of time is generous,
/// for an unoptimised build on a busy machine.
#[test]
fn searches_without_end_are_ended() {
    let dip = "r^2/2 - 0.2*(exp(-((r-0.5037)/1e-6)^2) - exp(-(0.5037/1e-6)^2))";
    let scenes = [
        scene("1e6", "1e-4", &formula("sin(r)"), &path("1", "5")),
        scene("1", "1e-4", &wavy("1e6", "0.1"), &path("0", "-1")),
        scene("1", "1e-4", &wavy("5e-4", "1e-300"), &path("0", "-0.01")),
        scene("1", "1e-4", &wavy("5e-4", "1e-9"), &path("0", "-0.01")),
        scene("1", "1e-4", &formula(&["r^2"; 480].join("+")), &path("0", "-1")),
        scene("1", "1e-4", &formula(dip), &path("0", "0.1")),
    ];
    for scene in &scenes {
        for arithmetic in ["--f64", "--digits 8"] {
            let begun = Instant::now();
            let answer = solved(scene, &format!("{arithmetic} --budget 0.05"));
            assert!(begun.elapsed() < Duration::from_secs(20), "{scene}: {:?}", begun.elapsed());
            assert!(answer["path"].as_array().is_some_and(|events| !events.is_empty()), "{answer}");
        }
    }
    for scene in &scenes[..4] {
        says_what_is_left(&solved(scene, "--f64 --budget 0.05"));
    }
}

/// A budget that was spent on the folds is not spent again for every output that needs them.
#[test]
fn a_spent_budget_is_spent_once() {
    let one = scene("1", "1e-4", &wavy("1e6", "0.1"), "output = { want = [\"folds\"] }");
    let many = "control = { kind = \"indentation\", path = [\"0\", \"-1\"] }
        output = { want = [\"folds\", \"path\", \"pressure\", \"gap\", \"energy\", \"displacement\", \"force-curve\"] }";
    let many = scene("1", "1e-4", &wavy("1e6", "0.1"), many);
    let evaluations = |scene: &str| -> usize {
        let assert = crate::mdr("solve - --f64 --budget 0.02 --explain").stdin(scene).assert().success();
        let text = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
        let counts = text.lines().skip(1).flat_map(str::split_whitespace).filter_map(|word| word.parse::<usize>().ok());
        counts.sum()
    };
    let [one, many] = [one, many].map(|scene| evaluations(&scene));
    assert!(one > 1000 && many < one + one / 2, "{one}, {many}");
}

/// The work is counted, so that the answer is a function of the question.
#[test]
fn a_budget_gives_the_same_answer_twice() {
    let scene = scene("1e6", "1e-4", &formula("sin(r)"), &path("1", "5"));
    let [one, other] = [(); 2].map(|()| solved(&scene, "--f64 --budget 0.03"));
    assert_eq!(one, other);
}

/// What is legitimate has its answer within a small part of the default budget.
#[test]
fn ordinary_scenes_keep_their_answers() {
    let scene = scene("1", "1e-4", &wavy("5e-4", "0.1"), &path("0", "-0.01"));
    for flags in ["--f64", "--digits 20"] {
        let [default, small] = ["", "--budget 0.5"].map(|budget| solved(&scene, &format!("{flags} {budget}")));
        assert_eq!(default, small);
        assert_eq!(default["folds"].as_array().map(Vec::len), Some(3), "{default}");
    }
}

/// A force curve that is too much to prove within the budget is that of f64, and says so.
#[test]
fn a_curve_that_is_not_proved_in_time_is_searched() {
    let rest = "medium = { kind = \"graded\", exponent = \"0.3\", coefficient = \"1\" }
        control = { kind = \"indentation\", path = [\"0.1\", \"-1\"] }
        output = { want = [\"force-curve\"], points = 20 }";
    let scene = scene("1", "1e-4", "kind = \"sphere\", radius = 1", rest);
    let answer = solved(&scene, "--budget 0.2");
    assert_eq!(answer["promise"]["force-curve"], "f64", "{answer}");
    assert_eq!(answer["force-curve-summary"]["status"], "ok", "{answer}");
    assert!(answer["force-curve"].as_array().is_some_and(|samples| samples.len() > 15), "{answer}");
}

/// Where the radii underflow at the start, the path has its events and the curve says what it lacks.
#[test]
fn a_curve_whose_radii_underflow_is_undecided() {
    let rest = "control = { kind = \"indentation\", path = [\"0.0001536684981\", \"0\"], start = \"smallest\" }
        output = { want = [\"force-curve\", \"path\"] }";
    for n in ["0.01", "0.005", "1/99"] {
        let scene = scene("7.87", "1.2", &format!("kind = \"power\", n = \"{n}\", c = 1"), rest);
        let answer = solved(&scene, "--f64");
        assert!(answer["path"].as_array().is_some_and(|events| events.len() > 1), "{answer}");
        assert_eq!(answer["force-curve-summary"]["status"], "undecided", "{n}: {answer}");
    }
}
