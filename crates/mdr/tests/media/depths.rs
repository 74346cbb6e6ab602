//! A line contact without a reference has no depth, whatever is asked of it.

use super::{LOAD, scene, solve};

/// The texts of the values of a key, wherever it is.
fn values<'a>(json: &'a str, key: &str) -> Vec<&'a str> {
    let mark = format!("{key}\":");
    json.match_indices(&mark)
        .map(|(at, _)| json[at + mark.len()..].split([',', '}']).next().expect("a value"))
        .collect()
}

#[test]
fn a_line_contact_without_a_reference_has_no_depth() {
    let load = format!("{LOAD}\npath = [\"0.1\", \"-0.05\", \"0.1\", \"-3\"]");
    let wants = [
        "path",
        "force-curve\"]\npoints = 4 # \"",
        "equilibria\"]\nequilibria.at = [\"0.1\"] # \"",
        "folds",
        "curve\"]\ncurve.at = [\"0.3\", \"0.6\"] # \"",
        "gap\"]\ngap.at = [\"1\"]\nequilibria.at = [\"0.1\"] # \"",
        "pressure\"]\npressure.at = [\"0.1\"] # \"",
    ];
    for works in ["work_of_adhesion = \"1/25\"", "work_of_adhesion = { advancing = \"1/100\", receding = \"1/25\" }"] {
        for want in wants {
            for arithmetic in ["", "arithmetic = \"f64\""] {
                let want = format!("want = [\"{want}\"]\n{arithmetic}");
                let text = scene("kind = \"plane\"", "kind = \"paraboloid\"\nradius = 1", &load, &want);
                let text = text.replace("work_of_adhesion = \"1/100\"", works);
                let json = solve(&text).to_json();
                let depths = values(&json, "indentation");
                assert!(!depths.is_empty() && depths.iter().all(|depth| *depth == "null"), "{text}\n{json}");
            }
        }
    }
}
