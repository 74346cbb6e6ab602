//! Flags and lines of a batch with units: every digit is that of the SI number.

use crate::mdr;

/// The answer without what repeats an input as it was typed.
fn digits(arguments: &[&str]) -> String {
    let assert = mdr("critical --format json --digits 40").args(arguments).assert().success();
    let mut answer: serde_json::Value = serde_json::from_slice(&assert.get_output().stdout).unwrap();
    if let Some(validity) = answer["validity"].as_object_mut() {
        validity.remove("range_of_adhesion");
    }
    ["kappa", "contact_radius", "indentation", "force", "folds", "validity"]
        .map(|key| answer[key].to_string())
        .join(" ")
}

#[test]
fn every_flag_with_a_unit_may_have_another() {
    let good = [
        ("--sphere", "5e-6"),
        ("--e-star", "1e9"),
        ("--work", "0.05"),
        ("--control", "machine"),
        ("--stiffness", "0.3"),
    ];
    let ask = |flag: &str, value: &str| {
        let mut flags: Vec<&str> =
            good.iter().filter(|(name, _)| *name != flag).flat_map(|(name, of)| [*name, *of]).collect();
        flags.extend([flag, value]);
        digits(&flags)
    };
    for (flag, si, others) in [
        ("--sphere", "5e-6", &["5um", "5 um", "5 µm", "5 μm", "0.005mm", "5000 nm"][..]),
        ("--e-star", "1e9", &["1GPa", "1000 MPa", "1e3 N/mm^2"]),
        ("--work", "0.05", &["50mJ/m^2", "50 mJ/m2", "50 mJ/m²", "0.05 N/m", "50 mN/m"]),
        ("--stiffness", "0.3", &["0.3N/m", "300 mN/m", "0.3 nN/nm"]),
        ("--range-of-adhesion", "3e-10", &["0.3nm", "0.3 nm", "300pm", "3 Å"]),
    ] {
        let expected = ask(flag, si);
        for other in others {
            assert_eq!(ask(flag, other), expected, "{flag} {other}");
        }
    }
    let cone = |angle| digits(&["--cone", angle, "--e-star", "1e9", "--work", "0.05"]);
    assert_eq!([cone("70 deg"), cone("70°")], [cone("70"), cone("70")]);
    let bodies =
        |e1, e2| digits(&["--sphere", "5e-6", "--work", "1", "--e1", e1, "--nu1", "0.3", "--e2", e2, "--nu2", "0.3"]);
    assert_eq!(bodies("1 GPa", "200GPa"), bodies("1e9", "2e11"));
}

#[test]
fn a_unit_of_another_dimension_is_refused_with_those_that_would_do() {
    for (flag, value, parts) in [
        ("--sphere", "5nN", &["--sphere: is in m; got \"5nN\"", "um"][..]),
        ("--e-star", "1 Gpa", &["--e-star: ", "unknown unit `Gpa`; did you mean `GPa`?"]),
        ("--work", "50 mJ", &["--work: is in J/m^2; got \"50 mJ\"", "mJ/m^2"]),
        ("--sphere", "-5um", &["--sphere: must be positive and finite, got -5um"]),
    ] {
        let good = [("--sphere", "5e-6"), ("--e-star", "1e9"), ("--work", "0.05")];
        let flags = good.into_iter().map(|(name, of)| format!("{name}={}", if name == flag { value } else { of }));
        let assert = mdr("critical").args(flags).assert().code(2).stdout_eq("");
        let message = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
        for part in parts {
            assert!(message.contains(part), "{flag} {value}: {message}");
        }
    }
}

#[test]
fn lines_of_a_batch_have_units() {
    let questions =
        "n,c,e_star,work,control,stiffness\n2,1e5,1 GPa,50 mJ/m^2,machine,300 mN/m\n2,1e5,1e9,50e-3,machine,300e-3\n";
    let assert = mdr("critical --batch -").stdin(questions).assert().success();
    let text = String::from_utf8(assert.get_output().stdout.clone()).unwrap();
    let lines: Vec<&str> = text.lines().skip(1).collect();
    assert_eq!(lines[0], lines[1]);
    let questions = "{\"n\":2,\"c\":1e5,\"e_star\":\"1 GPa\",\"work\":\"50 mJ/m\\u00b2\"}\n{\"n\":2,\"c\":1e5,\"e_star\":1e9,\"work\":50e-3}\n";
    let assert = mdr("critical --batch -").stdin(questions).assert().success();
    let text = String::from_utf8(assert.get_output().stdout.clone()).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], lines[1]);
}
