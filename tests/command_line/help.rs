//! Help and version.

use crate::{mdr, output};

#[test]
fn version() {
    assert_eq!(output("--version"), format!("mdr {}\n", env!("CARGO_PKG_VERSION")));
}

#[test]
fn the_overview_lists_every_command() {
    let help = output("--help");
    for command in ["verify", "critical", "solve", "fit", "report", "figures", "reference", "judge", "derive", "cite"] {
        assert!(help.contains(&format!("\n  {command} ")), "{help}");
    }
}

#[test]
fn each_command_has_flags_examples_and_exit_statuses() {
    let cases: [(&str, &[&str]); 10] = [
        ("cite", &["[ANSWER.json]", "--format"]),
        ("report", &["--out", "--quick", "--format"]),
        ("derive", &["[ID]", "--errata", "--format"]),
        ("figures", &["--out", "--format"]),
        ("verify", &["--quick", "--full", "--digits", "--shard", "--seed", "--only", "--merge", "--format"]),
        ("reference", &["--filter", "--export", "--generate", "--format"]),
        ("judge", &["--filter", "--complete", "--lenient", "--accept-inaccurate", "--excess", "--all", "--format"]),
        (
            "critical",
            &[
                "--n",
                "--c",
                "--sphere",
                "--cone",
                "--batch",
                "--e-star",
                "--e1",
                "--nu1",
                "--e2",
                "--nu2",
                "--work",
                "--control",
                "--stiffness",
                "--range-of-adhesion",
                "--digits",
                "--f64",
                "--format",
                "--units",
                "--notation",
            ],
        ),
        ("fit", &["<FIT.toml>", "[CURVE.csv]...", "--batch", "--digits", "--format", "--plot", "--theme"]),
        (
            "solve",
            &["<SCENE.toml>", "--digits", "--f64", "--format", "--plot", "--explain", "--out", "--units", "--notation"],
        ),
    ];
    for (command, flags) in cases {
        let help = output(&format!("{command} --help"));
        for flag in flags {
            assert!(help.contains(&format!("{flag} ")) || help.contains(&format!("{flag}\n")), "{flag} in {help}");
        }
        assert!(help.contains("Examples:") && help.contains(&format!("    mdr {command} ")), "{help}");
        assert!(help.contains("Exit status:"), "{help}");
    }
}

/// No line after the examples is broken on a terminal of 98 columns, or in a pipe, for which there are 100.
#[test]
fn lines_of_the_help_are_not_broken() {
    for command in ["verify", "critical", "solve", "fit", "report", "figures", "reference", "judge", "derive", "cite"] {
        let [wide, narrow] = ["110", "98"].map(|columns| {
            let help = mdr(&format!("{command} --help")).env("COLUMNS", columns).assert().code(0);
            let help = String::from_utf8(help.get_output().stdout.clone()).unwrap();
            help.split_once("Examples:").unwrap().1.to_owned()
        });
        assert_eq!(narrow, wide, "{command}");
    }
}

/// Two units in the last place are promised of closed forms, and not of the states of a scene.
#[test]
fn hardware_arithmetic_promises_what_it_keeps() {
    let promises = |command: &str| output(&format!("{command} --help")).contains("2 units in the last place");
    assert!(promises("critical") && !promises("solve"));
    assert!(output("solve --help").contains("the condition of the question"));
}

/// Every example of the help pages runs as it stands.
#[test]
fn the_examples_of_critical_work() {
    let help = output("critical --help");
    let examples: Vec<_> = help.lines().filter_map(|line| line.trim().strip_prefix("mdr ")).collect();
    assert!(examples.len() >= 4, "{help}");
    for example in examples {
        assert!(!output(example).is_empty(), "{example}");
    }
}

#[test]
fn without_a_command_the_help_is_an_error() {
    mdr("").assert().code(2).stdout_eq("");
}
