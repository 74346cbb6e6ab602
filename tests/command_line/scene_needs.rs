//! A scene says what its outputs need, and no more; what it says in vain has a note.

use crate::{mdr, number, solved};

const MATERIAL: &str = "[material]\ne_star = 1\nwork_of_adhesion = 1e-4\n";
const PROFILE: &str = "[profile]\nkind = \"wavy-paraboloid\"\nradius = 1\namplitude = 5e-4\nwavelength = 0.1\n";
const PATH: &str = "[control]\nkind = \"indentation\"\npath = [0, -0.01]\n";

/// Each output with all that it needs beside the profile: tables, and keys of `[output]`.
const NEEDS: [(&str, &[&str], &str); 9] = [
    ("transform", &[], "transform.at = [0.1]"),
    ("curve", &[MATERIAL], ""),
    ("folds", &[MATERIAL], ""),
    ("equilibria", &[MATERIAL], "equilibria.at = [0]"),
    ("path", &[MATERIAL, PATH], ""),
    ("pressure", &[MATERIAL], "equilibria.at = [0]"),
    ("gap", &[MATERIAL], "equilibria.at = [0]"),
    ("displacement", &[MATERIAL, PATH], ""),
    ("energy", &[MATERIAL, PATH], ""),
];

fn scene(want: &str, tables: &[&str], keys: &str) -> String {
    format!("{}{PROFILE}[output]\nwant = [\"{want}\"]\n{keys}\n", tables.concat())
}

#[test]
fn all_that_is_needed_is_enough_and_less_is_not() {
    for (want, tables, keys) in NEEDS {
        let answer = solved(&scene(want, tables, keys), "--f64");
        assert!(!answer[want].as_array().unwrap().is_empty(), "{answer}");
        assert!(answer.get("notes").is_none(), "{answer}");
        assert_eq!(answer["control"].is_null(), want == "transform", "{answer}");
        let table = mdr("solve - --digits 4").stdin(scene(want, tables, keys)).assert().success();
        let table = String::from_utf8(table.get_output().stdout.clone()).unwrap();
        assert_eq!(table.contains("controlled: indentation"), want != "transform", "{table}");
        let fewer = (0..tables.len()).map(|without| {
            let rest: Vec<_> =
                tables.iter().enumerate().filter(|(i, _)| *i != without).map(|(_, table)| *table).collect();
            scene(want, &rest, keys)
        });
        let incomplete = fewer.chain((!keys.is_empty()).then(|| scene(want, tables, "")));
        for scene in incomplete {
            let assert = mdr("solve -").stdin(scene.as_str()).assert().code(2).stdout_eq("");
            let message = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
            let names = format!("output.want: `{want}` needs ");
            assert!(message.starts_with("error: <stdin>:") && message.contains(&names), "{scene}{message}");
        }
    }
}

/// Every key that may be of no use, in a scene that has none for it, and in one that has.
#[test]
fn what_nothing_uses_has_a_note() {
    let start = format!("{PATH}start = \"smallest\"\n");
    let at = |key: &str| format!("{key}.at = [0.3]");
    let range = "folds.range = [1e-3, 1]";
    for (want, control, keys, flags, unused) in [
        ("folds", PATH, String::new(), "", vec!["[control] path"]),
        ("equilibria", &start, at("equilibria"), "", vec!["[control] path", "[control] start"]),
        ("path", &start, String::new(), "", vec![]),
        ("energy", &start, String::new(), "", vec![]),
        ("energy", &start, at("equilibria"), "", vec!["[control] path", "[control] start"]),
        ("folds", "", at("transform"), "", vec!["[output.transform]"]),
        ("folds", "", at("equilibria"), "", vec!["[output.equilibria]"]),
        ("folds", "", at("curve"), "", vec!["[output.curve]"]),
        ("curve", "", at("curve"), "", vec![]),
        ("folds", "", [at("pressure"), at("gap")].join("\n"), "", vec!["[output.pressure]", "[output.gap]"]),
        ("folds", "", at("displacement"), "", vec!["[output.displacement]"]),
        ("folds", "", range.to_owned(), "", vec![]),
        ("folds", "", range.to_owned(), "--f64", vec!["[output.folds] range"]),
        ("curve", "", range.to_owned(), "", vec!["[output.folds] range"]),
    ] {
        let scene = scene(want, &[MATERIAL, control], &keys);
        let answer = solved(&scene, &format!("{flags} --digits 4").replace("--f64 --digits 4", "--f64"));
        let empty = Vec::new();
        let notes = answer.get("notes").map_or(&empty, |notes| notes.as_array().unwrap());
        let notes: Vec<&str> = notes.iter().map(|note| note.as_str().unwrap()).collect();
        assert_eq!(notes.len(), unused.len(), "{scene}{notes:?}");
        for (note, key) in notes.iter().zip(unused) {
            assert!(note.starts_with(&format!("{key} is not used: ")), "{note}");
        }
    }
    let power = "[profile]\nkind = \"power\"\nn = 2\nc = 1\n";
    let answer = solved(&format!("{MATERIAL}{power}[output]\nwant = [\"folds\"]\n{range}\n"), "");
    assert!(answer["notes"][0].as_str().unwrap().contains("closed form"), "{answer}");
}

/// u(r) is what closes the gap: f(r) − d + u(r), with the height of the profile from its own formula.
#[test]
fn displacement_and_gap_add_up() {
    let keys = "equilibria.at = [0.001]\ngap.at = [0.15, 0.4]\ndisplacement.at = [0.15, 0.4]";
    let both = scene("gap\", \"displacement", &[MATERIAL], keys);
    for (flags, error) in [("--f64", 1e-14), ("--digits 25", 1e-15)] {
        let answer = solved(&both, flags);
        let points = |key: &str| answer[key][0]["states"][0][key].as_array().unwrap().clone();
        for (gap, displacement) in points("gap").iter().zip(points("displacement")) {
            let r = number(&gap["r"]);
            let height = r * r / 2.0 + 5e-4 * (1.0 - (2.0 * std::f64::consts::PI * r / 0.1).cos());
            let sum = height - 0.001 + number(&displacement["displacement"]);
            assert!((number(&gap["gap"]) - sum).abs() < error, "{answer}");
        }
    }
}
