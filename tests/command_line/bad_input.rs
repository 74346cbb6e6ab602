//! Bad input: exit status 2, nothing on standard output, and a message that names the flag and the value.

use crate::mdr;

/// A good question; each test spoils one flag of it.
const GOOD: [(&str, &str); 4] = [("--n", "2"), ("--c", "50"), ("--e-star", "1e6"), ("--work", "0.05")];

/// Asserts that `mdr` refuses these arguments with a message that starts with `error: ` and contains all of `parts`.
fn refused<S: AsRef<std::ffi::OsStr>>(arguments: &[S], parts: &[&str]) {
    let line: Vec<_> = arguments.iter().map(|argument| argument.as_ref().to_string_lossy()).collect();
    let assert = mdr("").args(arguments).assert().code(2).stdout_eq("");
    let message = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
    assert!(message.starts_with("error: "), "{line:?}: {message}");
    assert!(!message.contains("panicked"), "{line:?}: {message}");
    for part in parts {
        assert!(message.contains(part), "{line:?} should say {part:?}: {message}");
    }
}

/// `mdr critical` with the good flags, except that those of `change` replace, add or (with an empty value) remove.
fn critical(change: &[(&str, &str)], parts: &[&str]) {
    let mut flags: Vec<_> =
        GOOD.into_iter().filter(|(name, _)| !change.iter().any(|(other, _)| other == name)).collect();
    flags.extend(change.iter().filter(|(_, value)| !value.is_empty()));
    let spaced: Vec<_> = flags.iter().flat_map(|(name, value)| [*name, *value]).collect();
    refused(&[&["critical"], &spaced[..]].concat(), parts);
    // The same with `--flag=value`.
    let joined: Vec<_> = flags.iter().map(|(name, value)| format!("{name}={value}")).collect();
    refused(&[&["critical".to_owned()], &joined[..]].concat(), parts);
}

#[test]
fn exponent_coefficient_modulus_and_work_are_positive_numbers() {
    for flag in ["--n", "--c", "--e-star", "--work"] {
        for (value, why) in [
            ("0", "positive and finite"),
            ("-0.0", "positive and finite"),
            ("-1", "positive and finite"),
            ("-1e-300", "positive and finite"),
            ("-1/3", "positive and finite"),
            ("nan", "not finite"),
            ("NaN", "not finite"),
            ("inf", "not finite"),
            ("-inf", "not finite"),
            ("-Infinity", "not finite"),
            ("abc", "not a number"),
            ("1,5", "not a number"),
            ("0x10", "not a number"),
            ("1e", "not a number"),
            ("--", "not a number"),
            ("1/0", "division by zero"),
            ("1e999999999999", "too large"),
        ] {
            critical(&[(flag, value)], &[&format!("error: {flag}: "), why, &format!("got {value}")]);
        }
    }
    critical(&[("--n", "1e-9999999")], &["error: --n: too large to be meant", "got 1e-9999999"]);
}

#[test]
fn the_message_of_the_contract() {
    mdr("critical --n -1 --c 1 --e-star 1 --work 1")
        .assert()
        .code(2)
        .stdout_eq("")
        .stderr_eq("error: --n: must be positive and finite, got -1\n");
}

/// A long number is not repeated as a whole, nor a part of a range or of a list.
#[test]
fn messages_of_ranges_are_short() {
    let long = "7".repeat(50_000);
    for n in [format!("1:x{long}:2"), format!("x{long}:2:1"), format!("{long},{long}"), format!("1,2,x{long}")] {
        let flag = format!("--n={n}");
        let assert = mdr("critical --c 1 --e-star 1 --work 1").arg(flag).assert().code(2).stdout_eq("");
        let message = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
        assert!(message.starts_with("error: --n: ") && message.chars().count() < 1200, "{}", message.len());
    }
}

#[test]
fn a_flag_without_a_value_takes_the_next_word() {
    refused(&["critical", "--n", "--c", "1", "--e-star", "1", "--work", "1"], &["unexpected argument '1'"]);
    refused(&["critical", "--c", "1", "--e-star", "1", "--work", "1", "--n"], &["--n"]);
    refused(&["critical", "--n=", "--c=1", "--e-star=1", "--work=1"], &["--n"]);
}

#[test]
fn missing_flags() {
    for flag in ["--n", "--c", "--e-star", "--work"] {
        critical(&[(flag, "")], &[flag]);
    }
    refused(&["critical"], &["--n", "--c", "--work"]);
}

#[test]
fn two_bodies_or_an_effective_modulus() {
    let bodies = [("--e1", "1e6"), ("--nu1", "0.5"), ("--e2", "2e11"), ("--nu2", "0.3"), ("--e-star", "")];
    let with = |flag: &str, value: &'static str| {
        bodies.map(|(name, old)| if name == flag { (name, value) } else { (name, old) })
    };
    for (flag, _) in bodies[..4].iter().copied() {
        critical(&with(flag, ""), &[&format!("error: {flag}: missing"), "two bodies"]);
    }
    for flag in ["--e1", "--e2"] {
        for value in ["0", "-1e6", "nan", "inf", "soft"] {
            critical(&with(flag, value), &[&format!("error: {flag}: "), &format!("got {value}")]);
        }
    }
    for flag in ["--nu1", "--nu2"] {
        for value in ["-1", "-1.5", "0.51", "0.50000000000000000000000000001", "1", "nan", "inf", "half"] {
            critical(&with(flag, value), &[&format!("error: {flag}: "), &format!("got {value}")]);
        }
    }
    critical(&[("--e-star", "1e6"), ("--nu2", "0.3")], &["error: --e-star: ", "not both", "--nu2 0.3", "got 1e6"]);
    critical(&with("--e-star", "1e6"), &["error: --e-star: ", "not both", "--e1 1e6", "got 1e6"]);
    critical(&[("--e-star", "")], &["error: --e-star: missing", "--e1", "--nu1", "--e2", "--nu2"]);
}

#[test]
fn absurd_digits() {
    for value in ["0", "-3", "abc", "1000000000", "100001", "99999999999999999999", "1.5", "1e3", "nan"] {
        critical(&[("--digits", value)], &["error: --digits: must be a whole number", &format!("got {value}")]);
    }
    refused(
        &["critical", "--n", "2", "--c", "1", "--e-star", "1", "--work", "1", "--digits", "30", "--f64"],
        &["error: --digits: ", "--f64", "got 30"],
    );
}

#[test]
fn a_machine_has_a_stiffness_and_nothing_else_has() {
    critical(&[("--control", "machine")], &["error: --stiffness: missing", "--control machine"]);
    for value in ["0", "-4", "nan", "inf", "stiff"] {
        let flags = [("--control", "machine"), ("--stiffness", value)];
        critical(&flags, &["error: --stiffness: ", &format!("got {value}")]);
    }
    for control in ["force", "indentation"] {
        let flags = [("--control", control), ("--stiffness", "4")];
        critical(&flags, &["error: --stiffness: only with --control machine", "got 4"]);
    }
    critical(&[("--control", "hands")], &["--control", "hands", "indentation", "force", "machine"]);
}

/// What is out of the range of f64 is refused in an f64 run and answered in a certified one.
#[test]
fn inputs_beyond_hardware() {
    for flag in ["--n", "--c", "--e-star", "--work"] {
        for value in ["1e400", "1e-400"] {
            let mut arguments = vec!["critical", "--f64", flag, value];
            arguments.extend(GOOD.iter().filter(|(name, _)| *name != flag).flat_map(|(name, value)| [*name, *value]));
            refused(&arguments, &[&format!("error: {flag}: "), "f64", &format!("got {value}")]);
        }
    }
}

#[test]
fn long_and_strange_values_are_abridged() {
    let long = "7".repeat(100_001);
    let assert = mdr("critical --c 1 --e-star 1 --work 1 --n").arg(&long).assert().code(2).stdout_eq("");
    assert!(assert.get_output().stderr.len() < 400);
    refused(&["critical", "--n", "1\n2\u{7}", "--c", "1", "--e-star", "1", "--work", "1"], &["--n", r"1\n2\u{7}"]);
    refused(&["critical", "--n", " ", "--c", "1", "--e-star", "1", "--work", "1"], &["error: --n: not a number"]);
}

#[cfg(unix)]
#[test]
fn arguments_that_are_no_text() {
    use std::os::unix::ffi::OsStrExt;
    let garbage = std::ffi::OsStr::from_bytes(b"\xff\xfe");
    let assert = mdr("critical --c 1 --e-star 1 --work 1 --n").arg(garbage).assert().code(2).stdout_eq("");
    assert!(assert.get_output().stderr.starts_with(b"error: "));
}

#[test]
fn unknown_flags_and_commands() {
    refused(&["critical", "--frobnicate"], &["--frobnicate"]);
    refused(&["levitate"], &["levitate"]);
    refused(&["critical", "--n", "1", "--n", "2"], &["--n"]);
    refused(&["critical", "--format", "xml"], &["--format", "xml", "table", "json", "csv"]);
}

#[test]
fn verification_flags() {
    for value in ["0/2", "3/2", "1", "1/0", "a/b", "-1/2", "1/2/3", "4294967296/4294967297"] {
        refused(&["verify", "--shard", value], &["error: --shard: must be I/N", &format!("got {value}")]);
    }
    for value in ["-1", "1.5", "x", "18446744073709551616"] {
        refused(&["verify", "--seed", value], &["error: --seed: ", &format!("got {value}")]);
    }
    for value in ["0", "-3", "1000000000", "abc"] {
        refused(&["verify", "--digits", value], &["error: --digits: ", &format!("got {value}")]);
    }
    refused(
        &["verify", "--only", "jkr,astrology"],
        &["error: --only: must be one of ", "kappa-gamma", "got astrology"],
    );
    refused(&["verify", "--only", "kapa-gama"], &["error: --only: no such check; did you mean `kappa-gamma`?"]);
    refused(&["verify", "--quick", "--full"], &["--quick", "--full"]);
    refused(&["verify", "--merge"], &["--merge"]);
    refused(&["verify", "--merge", "no-such-file"], &["--merge", "no-such-file"]);
    refused(&["verify", "--merge", "x", "--quick"], &["--merge", "--quick"]);
}
