//! The answers of `mdr critical`: shape, regimes, controls, formats.

use serde_json::Value;

use crate::decimal::Decimal;
use crate::{critical, mdr, output, text, without_program};

const PARABOLOID: &str = "--n 2 --c 50 --e-star 1e6 --work 0.05";
const SHARP: &str = "--n 0.25 --c 1 --e-star 1e9 --work 0.05";
/// C over the threshold of (1.19) is κ C/√(2πw/E*) = 1.0460… here.
const SCALE_FREE: &str = "--n 1/2 --c 2 --e-star 1 --work 1";

fn keys(value: &Value) -> Vec<&str> {
    value.as_object().unwrap().keys().map(String::as_str).collect()
}

/// The keys of the first object of `text`, in the order in which they are written.
fn written_keys(text: &str) -> Vec<&str> {
    let mut depth = 0;
    let mut keys = Vec::new();
    let mut rest = text;
    while let Some(start) = rest.find(['"', '{', '}', '[', ']']) {
        match rest.as_bytes()[start] {
            b'{' | b'[' => depth += 1,
            b'}' | b']' => depth -= 1,
            _ => {
                let end = start + 1 + rest[start + 1..].find('"').unwrap();
                if depth == 1 && rest[end + 1..].starts_with(':') {
                    keys.push(&rest[start + 1..end]);
                }
                rest = &rest[end + 1..];
                continue;
            }
        }
        rest = &rest[start + 1..];
    }
    keys
}

#[test]
fn keys_and_their_order_are_those_of_the_schema() {
    let common =
        "schema arithmetic digits control regime inputs kappa status contact_radius indentation force threshold_c";
    for flags in [PARABOLOID, SHARP] {
        let text = output(&format!("critical {flags} --digits 30 --format json"));
        assert_eq!(written_keys(&text).join(" "), common);
    }
    let text = output(&format!("critical {SCALE_FREE} --format json"));
    assert_eq!(written_keys(&text).join(" "), format!("{common} ratio"));
    let text = output(&format!("critical {PARABOLOID} --control machine --stiffness 3 --format json"));
    assert_eq!(written_keys(&text).join(" "), format!("{common} folds"));
}

#[test]
fn a_certified_answer() {
    let answer = critical(&format!("{SHARP} --digits 50"));
    assert_eq!(text(&answer, "schema"), "mdr.critical/1");
    assert_eq!(text(&answer, "arithmetic"), "certified");
    assert_eq!(answer["digits"], 50);
    assert_eq!(text(&answer, "control"), "indentation");
    assert_eq!(text(&answer, "regime"), "complete-contact");
    assert_eq!(text(&answer, "status"), "ok");
    assert_eq!(answer["threshold_c"], Value::Null);
    // As they were typed.
    let inputs = serde_json::json!({"n": "0.25", "c": "1", "e_star": "1e9", "work": "0.05"});
    assert_eq!(answer["inputs"], inputs);
}

#[test]
fn twenty_digits_unless_told_otherwise() {
    assert_eq!(critical(PARABOLOID)["digits"], 20);
    assert_eq!(text(&critical(PARABOLOID), "kappa"), "2.0000000000000000000");
}

#[test]
fn inputs_are_echoed_as_written() {
    let answer = critical("--n 2/4 --c +1.50 --e-star 1E+06 --work .05");
    let inputs = serde_json::json!({"n": "2/4", "c": "+1.50", "e_star": "1E+06", "work": ".05"});
    assert_eq!(answer["inputs"], inputs);
    assert_eq!(text(&answer, "regime"), "scale-free");
}

/// −(3/2)πwR and −(5/6)πwR for f = r²/2R: Johnson, Kendall & Roberts, Proc. R. Soc. A 324 (1971) 301; the second under
/// fixed grips, Maugis, Contact, Adhesion and Rupture of Elastic Solids (2000).
#[test]
fn jkr() {
    let force = |control| text(&critical(&format!("{PARABOLOID} --control {control} --digits 16")), "force").to_owned();
    let pi_w_r = std::f64::consts::PI * 0.05 * 0.01;
    for (control, factor) in [("force", -1.5), ("indentation", -5.0 / 6.0)] {
        let found: f64 = force(control).parse().unwrap();
        // 16 digits read as a double and three rounded products: a few units of 2⁻⁵³.
        assert!((found / (factor * pi_w_r) - 1.0).abs() < 8.0 * f64::EPSILON, "{control}: {found}");
    }
}

#[test]
fn the_default_control_is_indentation() {
    assert_eq!(critical(PARABOLOID), critical(&format!("{PARABOLOID} --control indentation")));
    assert_ne!(critical(PARABOLOID)["force"], critical(&format!("{PARABOLOID} --control force"))["force"]);
}

/// 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂ (1.3), exactly: here 0.75/3 + 0.96/2 = 0.73.
#[test]
fn two_bodies() {
    let answer = critical("--n 2 --c 1 --e1 3 --nu1 0.5 --e2 2 --nu2 -0.2 --work 1 --digits 8");
    assert_eq!(keys(&answer["inputs"]).len(), 8);
    assert_eq!(text(&answer["inputs"], "nu2"), "-0.2");
    assert_eq!(text(&answer["inputs"], "e_star"), "1.3698630");
    let same = critical("--n 2 --c 1 --e-star 100/73 --work 1 --digits 8");
    for key in ["contact_radius", "indentation", "force"] {
        assert_eq!(answer[key], same[key]);
    }
    // ν = 1/2 is allowed, −1 is not.
    critical("--n 2 --c 1 --e1 3 --nu1 1/2 --e2 2 --nu2 -0.999 --work 1");
}

/// The thresholds of (1.19): (2/ϖ)√(2πw/E*) and three times that under a dead load.
#[test]
fn scale_free() {
    let answer = critical("--n 0.5 --c 2 --e-star 1e6 --work 0.05 --digits 30");
    assert_eq!(text(&answer, "regime"), "scale-free");
    assert_eq!(text(&answer, "kappa"), "1.31102877714605990523241979495");
    // mpmath: sqrt(2*pi*mpf('0.05')/mpf('1e6'))*gamma(mpf(3)/4)**2*2*sqrt(2)/pi**1.5
    assert_eq!(text(&answer, "threshold_c"), "0.000427526177464942431973955110554");
    for key in ["contact_radius", "indentation", "force"] {
        assert_eq!(answer[key], Value::Null);
    }
    assert_eq!(text(&answer, "status"), "ok");
    let force = critical("--n 0.5 --c 2 --e-star 1e6 --work 0.05 --digits 10 --control force");
    assert_eq!(text(&force, "threshold_c"), "0.001282578532");
    let [stiff, dead] = [&answer, &force].map(|answer| text(answer, "ratio").parse::<f64>().unwrap());
    // Ten digits of one ratio against thirty of the other.
    assert!((stiff / dead / 3.0 - 1.0).abs() < 1e-9);
}

/// One fold for 1 < ρ < 3, at a = k(ρ−1)/(2E*(3−ρ)); none outside.
#[test]
fn scale_free_on_a_machine() {
    let with_c = |c: &str| critical(&format!("--n 0.5 --c {c} --e-star 1 --work 1 --control machine --stiffness 1"));
    let between = with_c("2");
    assert_eq!(between["folds"].as_array().unwrap().len(), 1);
    assert_eq!(between["folds"][0]["contact_radius"], between["contact_radius"]);
    assert_eq!(text(&between["folds"][0], "kind"), "maximum");
    for c in ["1", "100"] {
        let outside = with_c(c);
        assert_eq!(outside["folds"], Value::Array(Vec::new()));
        assert_eq!(outside["contact_radius"], Value::Null);
    }
}

/// With several folds the three quantities are those met first: at the largest radius for n > 1/2.
#[test]
fn a_multistable_machine() {
    let answer = critical("--n 0.6 --c 2.4829 --e-star 1 --work 1 --control machine --stiffness 1");
    let folds = answer["folds"].as_array().unwrap();
    assert_eq!(folds.len(), 3);
    assert_eq!(keys(&folds[0]), ["contact_radius", "force", "indentation", "kind", "status"]);
    for key in ["contact_radius", "indentation", "force"] {
        assert_eq!(answer[key], folds[2][key]);
    }
    assert_eq!(answer["inputs"]["stiffness"], "1");
    let kinds: Vec<_> = folds.iter().map(|fold| text(fold, "kind")).collect();
    assert_eq!(kinds, ["minimum", "maximum", "minimum"]);
}

/// k/(2E*a_c) = 1 for the paraboloid: a/a_c = 1.72526…, between 1 (fixed grips) and 9^{1/3} (dead load).
#[test]
fn a_machine_lies_between_the_limits() {
    let radius =
        |flags: &str| text(&critical(&format!("{PARABOLOID} {flags}")), "contact_radius").parse::<f64>().unwrap();
    let (stiff, dead) = (radius(""), radius("--control force"));
    let machine = |k: f64| radius(&format!("--control machine --stiffness {k:e}")) / stiff;
    // 20 digits of a radius, and a stiffness rounded to a double.
    assert!((machine(2e6 * stiff) - 1.7252662726654581).abs() < 1e-14);
    assert!((machine(1e12) - 1.0).abs() < 1e-8);
    assert!((machine(1e-12) / (dead / stiff) - 1.0).abs() < 1e-8);
}

#[test]
fn plain_notation_and_exponents() {
    let answer = critical("--n 1 --c 0.1 --e-star 1e6 --work 0.05 --digits 5");
    assert_eq!(text(&answer, "contact_radius"), "0.0000031831");
    assert_eq!(text(&answer, "indentation"), "-5.0000e-7");
    let answer = critical("--n 1/3 --c 0.7 --e-star 3e8 --work 0.02 --digits 5 --control force");
    assert_eq!(text(&answer, "contact_radius"), "6.1810e+23");
    assert_eq!(Decimal::new(text(&answer, "indentation")), Decimal::new("56317000"));
}

#[test]
fn a_table_for_a_reader() {
    let table = output(&format!("critical {PARABOLOID} --control force --digits 12"));
    for part in ["kappa_n", "2.00000000000", "contact radius a", "-0.00235619449019", " N", " m", "Pull-off", "breaks"]
    {
        assert!(table.contains(part), "{part:?} in\n{table}");
    }
    assert!(!table.contains('\u{1b}'), "no colours in a pipe");
    assert!(table.lines().all(|line| line == line.trim_end()), "no trailing blanks");
    for (flags, word) in [(SHARP, "Complete contact"), (SCALE_FREE, "Scale-free")] {
        assert!(output(&format!("critical {flags}")).contains(word));
    }
}

#[test]
fn a_spreadsheet() {
    let csv = output(&format!("critical {PARABOLOID} --digits 12 --format csv"));
    let [header, row] = csv.lines().map(|line| line.split(',').collect()).collect::<Vec<Vec<_>>>().try_into().unwrap();
    let value = |column| row[header.iter().position(|title| *title == column).unwrap()];
    assert_eq!(header.len(), row.len());
    assert_eq!(value("kappa"), "2.00000000000");
    assert_eq!(value("force"), "-0.00130899693900");
    assert_eq!(value("e_star"), "1e6");
    assert_eq!(value("status"), "ok");
    let csv = output("critical --n 0.6 --c 2.4829 --e-star 1 --work 1 --control machine --stiffness 1 --format csv");
    assert_eq!(csv.lines().count(), 4, "a header and a row a fold");
}

/// A reader that goes away is no reason to panic.
#[cfg(unix)]
#[test]
fn a_closed_pipe() {
    use std::process::{Command, Stdio};
    let mut child = Command::new(env!("CARGO_BIN_EXE_mdr"))
        .args(format!("critical {SHARP} --digits 60000 --format json").split_whitespace())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let end = child.wait_with_output().unwrap();
    assert_eq!(end.status.code(), Some(0));
    assert!(end.stderr.is_empty(), "{}", String::from_utf8_lossy(&end.stderr));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_reported() {
    use std::process::Command;
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_mdr"));
    let end = command.args(format!("critical {SHARP}").split_whitespace()).stdout(full).output().unwrap();
    assert_eq!(end.status.code(), Some(2));
    assert!(end.stderr.starts_with(b"error: standard output: "));
}

#[test]
fn words_are_not_abbreviated() {
    mdr("critical --n 2 --c 50 --e-st 1e6 --work 0.05").assert().code(2).stdout_eq("");
}

/// A body by its name is the power law that it stands for.
#[test]
fn bodies_by_name() {
    let of = |flags: &str| output(&format!("critical {flags} --e-star 1e6 --work 0.05 --format json"));
    assert_eq!(of("--sphere 0.01"), of("--n 2 --c 50"));
    assert_eq!(of("--paraboloid 1/300"), of("--n 2 --c 150"));
    let cone = critical("--cone 45 --e-star 1e6 --work 0.05 --digits 30");
    assert_eq!(text(&cone["inputs"], "c").parse::<f64>().unwrap(), 1.0);
    // d = −w/(E*C) at the fold of a cone, whose C is rounded to ten digits more than are asked for.
    let steep = critical("--cone 30 --e-star 1 --work 1 --digits 12");
    assert_eq!(text(&steep, "indentation"), "-0.577350269190");
    mdr("critical --cone 90 --e-star 1 --work 1")
        .assert()
        .code(2)
        .stderr_eq("error: --cone: must be below 90 degrees, got 90\n");
    mdr("critical --sphere 1 --cone 30 --e-star 1 --work 1").assert().code(2);
}

/// The table of one answer ends with what the other control would make of it.
#[test]
fn the_sibling_of_an_answer() {
    let grips = output(&format!("critical {PARABOLOID} --digits 5"));
    assert!(grips.contains("Under a dead load: F = -0.0023562 N = -3/2 pi w R at d = "), "{grips}");
    let load = output(&format!("critical {PARABOLOID} --digits 5 --control force"));
    assert!(load.contains("At fixed grips: F = -0.0013090 N at d = "), "{load}");
    assert!(!output(&format!("critical {SHARP}")).contains("pi w R"));
}

#[test]
fn several_exponents_are_rows_of_one_table() {
    let flags = "--c 1 --e-star 1e6 --work 0.05 --digits 5";
    let table = output(&format!("critical --n 0.5:1.5:0.25 {flags}"));
    let exponents: Vec<_> = table.lines().skip(1).map(|line| line.split_whitespace().next().unwrap()).collect();
    assert_eq!(exponents, ["0.5", "0.75", "1", "1.25", "1.5"]);
    let lines = output(&format!("critical --n 1,2,1/3 {flags} --format json"));
    assert_eq!(lines.lines().count(), 3);
    assert_eq!(lines.lines().nth(1).unwrap(), output(&format!("critical --n 2 {flags} --format json")).trim());
    // The row of n = 1/2 has its threshold, which a table without that row has no column for.
    let threshold = output("critical --n 0.25:0.75:0.25 --c 1 --e-star 1 --work 1 --digits 6");
    assert!(threshold.contains("threshold of C, m^(1/2)") && threshold.contains("1.91196"), "{threshold}");
    assert!(!output(&format!("critical --n 1,2.5 {flags}")).contains("threshold"));
    for (range, part) in
        [("1:2:0", "step"), ("1:2:-1", "step"), ("0:2:1", "first"), ("1:-2:1", "last"), ("1:2:x", "step")]
    {
        let refused = mdr(&format!("critical --n {range} {flags}")).assert().code(2);
        let error = String::from_utf8(refused.get_output().stderr.clone()).unwrap();
        assert!(error.starts_with(&format!("error: --n: the {part} of the range")), "{range}: {error}");
    }
    for bad in ["1:2", "1,", "2:1:1", "1:2:0"] {
        mdr(&format!("critical --n {bad} {flags}")).assert().code(2);
    }
}

/// A batch answers every line in its own format; a line that is no question says so in its place.
#[test]
fn a_batch_answers_every_line() {
    let csv = "n,c,e_star,work,control\n2,50,1e6,0.05,force\n-1,50,1e6,0.05,force\n1/4,1,1e9,0.05,\n";
    let assert = mdr("critical --batch - --f64").stdin(csv).assert().code(1);
    let answers = String::from_utf8(assert.get_output().stdout.clone()).unwrap();
    let single = output("critical --n 2 --c 50 --e-star 1e6 --work 0.05 --control force --f64 --format csv");
    assert_eq!(answers.lines().nth(1).unwrap(), format!("{},", single.lines().nth(1).unwrap()));
    assert!(answers.lines().nth(2).unwrap().ends_with("n: must be positive, got -1\""), "{answers}");
    assert_eq!(answers.lines().count(), 4);
    let json = "{\"n\": 2, \"c\": \"50\", \"e_star\": 1e6, \"work\": 0.05}\n{\"n\": 2, \"q\": 1}\n";
    let assert = mdr("critical --batch -").stdin(json).assert().code(1);
    let answers = String::from_utf8(assert.get_output().stdout.clone()).unwrap();
    let single = output(&format!("critical {PARABOLOID} --format json"));
    assert_eq!(without_program(answers.lines().next().unwrap()), single.trim());
    assert!(answers.lines().nth(1).unwrap().contains("unknown key `q`"), "{answers}");
    mdr("critical --batch no-such-file").assert().code(2);
}

/// A control that was not asked for is named where the answer begins, and what another would give where it ends.
#[test]
fn the_control_that_was_taken_is_said_first() {
    let question = "critical --sphere 1 --e-star 1 --work 1";
    let answer = crate::output(question);
    let first = answer.lines().next().unwrap_or_default();
    assert!(first.contains("controlled indentation (no --control is given)"), "{first}");
    assert!(answer.contains("Under a dead load: F = -4.71"), "{answer}");
    let asked = crate::output(&format!("{question} --control indentation"));
    assert!(asked.lines().next().is_some_and(|first| !first.contains("--control")), "{asked}");
}
