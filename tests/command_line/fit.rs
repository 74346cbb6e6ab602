//! `mdr fit`: answers, formats, exit statuses and complaints.

use std::path::{Path, PathBuf};

use crate::{mdr, output, root};

fn file(name: &str, text: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, text).unwrap();
    path
}

fn example(name: &str) -> String {
    root().join("examples/fits").join(name).display().to_string()
}

/// The published estimates, from no start at all.
#[test]
fn the_example_is_fitted() {
    let answer: serde_json::Value =
        serde_json::from_str(&output(&format!("fit {} --format json", example("tip.toml")))).unwrap();
    assert_eq!(answer["schema"], "mdr.fit/1");
    assert_eq!(answer["status"], "fitted");
    let expected = [4.99161781811737e6, 1.997673595287969e-2, 2.4888331252893856e-8, 1.069650594469785e-9];
    for (estimate, expected) in answer["parameters"].as_array().unwrap().iter().zip(expected) {
        assert!((estimate["value"].as_f64().unwrap() / expected - 1.0).abs() < 1e-10, "{estimate}");
    }
    assert_eq!(answer["rows"].as_array().unwrap().len(), 321);
    let table = output(&format!("fit {}", example("tip.toml")));
    assert!(table.contains("e_star") && table.contains("Pull-off, measured"), "{table}");
}

#[test]
fn what_the_data_cannot_tell_is_said_with_status_one() {
    let fit = mdr(&format!("fit {}", example("unidentifiable.toml"))).assert().code(1);
    let text = String::from_utf8(fit.get_output().stdout.clone()).unwrap();
    assert!(text.contains("unidentifiable") && text.contains("e_star * radius^(1/2)"), "{text}");
    assert!(text.contains("work_of_adhesion * radius") && text.contains("not determined"), "{text}");
}

/// Hysteresis, and rows and trends of an experiment, from the example files: the numbers that they were made from.
#[test]
fn what_experiments_have_is_fitted() {
    let json = |name: &str| -> serde_json::Value {
        serde_json::from_str(&output(&format!("fit {} --format json", example(name)))).unwrap()
    };
    let within = |answer: &serde_json::Value, name: &str, made: f64| {
        let estimates = answer["parameters"].as_array().unwrap();
        let estimate = estimates.iter().find(|estimate| estimate["name"] == name).unwrap();
        let [value, stderr] = ["value", "stderr"].map(|key| estimate[key].as_f64().unwrap());
        assert!(((value - made) / stderr).abs() < 4.0, "{estimate} for {made}");
    };
    let loops = json("hysteresis.toml");
    assert_eq!(loops["status"], "fitted", "{}", loops["reason"]);
    within(&loops, "e_star", 2e6);
    within(&loops, "work_of_adhesion.advancing", 0.01);
    within(&loops, "work_of_adhesion.receding", 0.04);
    let drift = json("drift.toml");
    assert_eq!(drift["status"], "fitted", "{}", drift["reason"]);
    within(&drift, "e_star", 2e6);
    within(&drift, "baseline_slope", 2e-3);
    let skipped: Vec<_> =
        drift["skipped"].as_array().unwrap().iter().map(|each| each["why"].as_str().unwrap()).collect();
    assert_eq!(skipped, ["not a number", "saturated", "outside of x"]);
    let table = output(&format!("fit {}", example("drift.toml")));
    for words in ["follows, per ln", "adhesion force", "Rows left out: 3 not a number", "baseline_slope"] {
        assert!(table.contains(words), "{words}: {table}");
    }
}

/// Digits of another program, from the file of the fit.
#[test]
fn digits_are_proved_on_request() {
    let text = output(&format!("fit {} --digits 12", example("tip.toml")));
    assert!(text.contains("4991617.81812") && text.contains("unique within"), "{text}");
    assert!(text.contains("Proved: a local minimum"), "{text}");
}

#[test]
fn a_batch_has_rows_for_every_curve() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fit-batch");
    std::fs::create_dir_all(&folder).unwrap();
    for name in ["one.csv", "two.csv"] {
        std::fs::copy(example("tip.csv"), folder.join(name)).unwrap();
    }
    let csv = output(&format!("fit {} --batch {} --format csv", example("tip.toml"), folder.display()));
    assert_eq!(csv.lines().count(), 1 + 2 * 4, "{csv}");
    let header = "file,status,name,value,stderr,scaled_stderr,unit,chi2,chi2_p,reason,warnings,lower_limit,upper_limit,\
                  adhesion_force,pull_off_force,separation_work\n";
    assert!(csv.starts_with(header), "{csv}");
}

/// What is said of one curve is said of it in a batch, in every format: warnings, and why a fit is poor.
#[test]
fn a_batch_says_what_may_mislead() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fit-batch-warnings");
    std::fs::create_dir_all(&folder).unwrap();
    for name in ["one.csv", "two.csv"] {
        std::fs::copy(example("tip.csv"), folder.join(name)).unwrap();
    }
    let text = std::fs::read_to_string(example("tip.toml")).unwrap();
    let (small, poor) = ("χ² = ", "the stated σ is too small");
    for (name, sigma, code) in [("large", "2e-9", 0), ("small", "2e-13", 1)] {
        let text = text.replace("tip.csv", &example("tip.csv")).replace("y = \"2e-10\"", &format!("y = \"{sigma}\""));
        let fit = file(&format!("fit-batch-{name}.toml"), &text);
        for format in ["csv", "json", "table"] {
            let answer = mdr(&format!("fit {} --batch {} --format {format}", fit.display(), folder.display()));
            let answer = answer.assert().code(code);
            let answer = String::from_utf8(answer.get_output().stdout.clone()).unwrap();
            assert!(answer.matches(small).count() >= 2, "{answer}");
            assert_eq!(answer.contains(poor) && answer.contains("poor-fit"), code == 1, "{answer}");
        }
    }
}

#[test]
fn a_picture_shows_data_and_fit() {
    let svg = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fit-tip.svg");
    mdr(&format!("fit {} --plot {}", example("tip.toml"), svg.display())).assert().success();
    let [picture, data] = [svg.clone(), svg.with_extension("csv")].map(|file| std::fs::read_to_string(file).unwrap());
    assert!(roxmltree::Document::parse(&picture).is_ok());
    for series in ["detached", "in contact", "in contact, approach", "fit", "predicted pull-off"] {
        assert!(data.lines().any(|line| line.split(',').nth(2) == Some(series)), "{series}");
    }
}

/// What a first try gets wrong, and what is said.
#[test]
fn complaints_name_the_place_and_the_remedy() {
    let head =
        "[profile]\nkind = \"paraboloid\"\nradius = \"1e-5\"\n[fit]\nfree = [\"e_star\", \"work_of_adhesion\"]\n";
    let data = |rows: &str| format!("{head}[data]\nobservation = \"F(d)\"\n{rows}\n");
    let numbers = "rows = [[2e-6, 2.2e-5], [1e-6, 6.6e-6], [5e-7, 1.3e-6], [0, -1.4e-6]]";
    let csv = |name: &str, text: &str| data(&format!("file = \"{}\"", file(name, text).display()));
    let cases = [
        ("one-row", data("rows = [[1e-6, 1e-6]]"), "needs at least three rows, got 1"),
        ("constant", data("rows = [[1e-6, 1], [2e-6, 1], [3e-6, 1]]"), "y is 1 in all 3 rows"),
        ("constant-x", data("rows = [[1, 1], [1, 2], [1, 3]]"), "x is 1 in all 3 rows"),
        ("nan", csv("nan.csv", "d,F\nm,N\n1e-6,nan\n2e-6,1e-6\n"), "line 3: `nan` in the column `F` is not a number"),
        ("units", csv("units.csv", "d,F\n1e-6,1e-6\n2e-6,1e-6\n"), "no units: the row after the header must name them"),
        ("unit", csv("unit.csv", "d,F\nV,N\n1e-6,1e-6\n"), "no unit"),
        (
            "column",
            csv("column.csv", "d,F\nm,N\n1,2\n").replace("[data]", "[data]\ncolumns = { x = \"depth\" }"),
            "unknown column `depth`",
        ),
        ("observation", data(numbers).replace("F(d)", "F(x)"), "unknown observation `F(x)`"),
        ("name", data(numbers).replace("\"e_star\"", "\"e_stra\""), "did you mean `e_star`?"),
        ("key", data(numbers).replace("free", "fre"), "did you mean `free`?"),
        (
            "missing",
            data(numbers).replace(", \"work_of_adhesion\"", ""),
            "`work_of_adhesion` is neither free nor given",
        ),
        ("prior", data(numbers) + "[events]\npull_off = 1\n", "missing key `sigma`"),
        (
            "few",
            data("rows = [[2e-6, 2e-5], [1e-6, 6e-6], [0, -1e-6]]")
                .replace("\"work_of_adhesion\"", "\"work_of_adhesion\", \"baseline\""),
            "3 rows cannot determine 3 numbers",
        ),
    ];
    for (name, text, why) in cases {
        let fit = file(&format!("fit-{name}.toml"), &text);
        let refused = mdr(&format!("fit {}", fit.display())).assert().code(2);
        let error = String::from_utf8(refused.get_output().stderr.clone()).unwrap();
        assert!(error.contains(why), "{name}: {error}");
    }
}
