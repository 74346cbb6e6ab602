//! `mdr solve`.

use serde_json::Value;

use crate::output;

/// The answer to a scene of the examples.
fn solve(scene: &str, flags: &str) -> Value {
    let text = output(&format!("solve examples/scenes/{scene}.toml {flags} --format json"));
    assert_eq!(text.lines().count(), 1, "one object, one line");
    serde_json::from_str(&text).unwrap()
}

/// The jumps of figure 4: 0.0645 → 0.0474 at d ≈ −0.00185, and the end at 0.0189, d ≈ −0.00249.
#[test]
fn the_folds_of_figure_4_are_proved() {
    let answer = solve("figure-4", "");
    assert_eq!(answer["schema"], "mdr.solve/1");
    assert_eq!(answer["promise"]["folds"], "certified");
    assert_eq!(answer["complete"]["folds"]["proved"], true);
    let folds = answer["folds"].as_array().unwrap();
    let read = |fold: &Value, key: &str| fold[key].as_str().unwrap().parse::<f64>().unwrap();
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
