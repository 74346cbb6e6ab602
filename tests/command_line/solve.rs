//! `mdr solve`.

use serde_json::Value;

use crate::output;

/// The answer to a scene of the examples.
fn solve(scene: &str, flags: &str) -> Value {
    let text = output(&format!("solve examples/scenes/{scene}.toml {flags} --format json"));
    assert_eq!(text.lines().count(), 1, "one object, one line");
    serde_json::from_str(&text).unwrap()
}

/// A number, written as text or not.
fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| value.as_str().unwrap().parse().unwrap())
}

/// The jumps of figure 4: 0.0645 → 0.0474 at d ≈ −0.00185, and the end at 0.0189, d ≈ −0.00249.
#[test]
fn the_folds_of_figure_4_are_proved() {
    let answer = solve("figure-4", "");
    assert_eq!(answer["schema"], "mdr.solve/1");
    assert_eq!(answer["promise"]["folds"], "certified");
    assert_eq!(answer["complete"]["folds"]["proved"], true);
    let folds = answer["folds"].as_array().unwrap();
    let read = |fold: &Value, key: &str| number(&fold[key]);
    let found: Vec<_> = folds
        .iter()
        .map(|fold| (read(fold, "contact_radius"), read(fold, "indentation"), fold["kind"].as_str().unwrap()))
        .collect();
    let [(end, end_depth, "minimum"), (_, _, "maximum"), (jump, jump_depth, "minimum")] = found[..] else {
        panic!("{found:?}")
    };
    assert!((end - 0.0189).abs() < 5e-5 && (end_depth + 0.00249).abs() < 5e-6, "{found:?}");
    assert!((jump - 0.0645).abs() < 5e-5 && (jump_depth + 0.00185).abs() < 5e-6, "{found:?}");
    assert!(folds.iter().all(|fold| fold["status"] == "ok"));
}

/// The whole sequence, in both arithmetics.
#[test]
fn the_path_of_figure_4() {
    for flags in ["", "--f64"] {
        let answer = solve("figure-4", flags);
        let events = answer["path"].as_array().unwrap();
        let names: Vec<_> = events.iter().map(|event| event["event"].as_str().unwrap()).collect();
        assert_eq!(names, ["start", "jump", "detached", "end"]);
        let read = |event: usize, key: &str| number(&events[event][key]);
        let near = |value: f64, expected: f64| assert!((value - expected).abs() < 5e-5, "{value}, {expected}");
        near(read(0, "contact_radius"), 0.0926);
        near(read(1, "contact_radius"), 0.0645);
        near(read(1, "to_contact_radius"), 0.0474);
        near(read(2, "contact_radius"), 0.0189);
        assert!(read(1, "dissipated") > 0.0 && read(2, "dissipated") > 0.0);
        assert!(events[2]["to_contact_radius"].is_null() && read(2, "to_force") == 0.0);
    }
}
