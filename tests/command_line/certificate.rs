//! `mdr solve --certificate`.

use std::path::Path;

use serde_json::Value;

use crate::{mdr, root};

/// The certificate of a scene in a folder, without the program that wrote it.
fn certificate(folder: &str, scene: &str) -> Value {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("certificate-{scene}.json"));
    mdr(&format!("solve {folder}/{scene}.toml --certificate {}", file.display())).assert().success();
    let mut value: Value = serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap();
    assert!(value["program"].as_str().is_some_and(|program| program.starts_with("mdr ")));
    value.as_object_mut().unwrap().remove("program");
    value
}

/// `make confirm` checks the stored certificates in Arb; these are those of this program.
#[test]
fn the_checked_certificates_are_those_of_the_program() {
    let examples = ["figure-4", "flat-punch", "displaced-paraboloid", "kinked"].map(|scene| ("examples/scenes", scene));
    let media = ["graded", "winkler", "cylinder", "wave"].map(|scene| ("tests/certificates", scene));
    for (folder, scene) in examples.into_iter().chain(media) {
        let stored = root().join(format!("tests/certificates/{scene}.json"));
        let stored: Value = serde_json::from_str(&std::fs::read_to_string(stored).unwrap()).unwrap();
        assert_eq!(certificate(folder, scene), stored, "{scene}");
    }
}

/// A power law has a certificate however large its contact is.
#[test]
fn a_radius_beyond_the_range_of_doubles_has_a_certificate() {
    let file = |extension| Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("certificate-huge.{extension}"));
    let scene = "[profile]\nkind = \"power\"\nn = 1\nc = \"1e-150\"\n[material]\ne_star = \"1e-100\"\n\
                 work_of_adhesion = \"1e100\"\n[output]\nwant = [\"folds\"]\n";
    std::fs::write(file("toml"), scene).unwrap();
    mdr(&format!("solve {} --certificate {}", file("toml").display(), file("json").display())).assert().success();
    let value: Value = serde_json::from_str(&std::fs::read_to_string(file("json")).unwrap()).unwrap();
    assert_eq!(value["folds"][0]["contact_radius"], "6.3661977236758134308e+499");
    assert!(value["range"][1].as_str().is_some_and(|end| end.ends_with("e501")));
}

#[test]
fn what_a_certificate_cannot_say_is_refused() {
    let file = |extension| Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("certificate-unsaid.{extension}"));
    let graded = "[medium]\nkind = \"graded\"\nexponent = 0.3\nmodulus = \"1e6\"\nnu = 0.3\ndepth = 1\n[profile]\nkind = \"paraboloid\"\n\
                  radius = 1\n[output]\nwant = [\"folds\"]\n";
    let wave = "[medium]\nkind = \"periodic\"\nwavelength = 1\n[profile]\nkind = \"wave\"\namplitude = 1\n[control]\n\
                kind = \"force\"\npath = [\"0\", \"2\"]\n[output]\nwant = [\"path\"]\n";
    for (scene, modulus, work, why) in [
        (graded, "", "1e-3", "give coefficient in place of modulus and depth"),
        (wave, "e_star = 1\n", "0.45", "a certificate speaks of no path to complete contact"),
    ] {
        let material = format!("[material]\n{modulus}work_of_adhesion = \"{work}\"\n");
        std::fs::write(file("toml"), material + scene).unwrap();
        let command = format!("solve {} --certificate {}", file("toml").display(), file("json").display());
        let assert = mdr(&command).assert().code(2);
        let error = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
        assert!(error.contains(why), "{error}");
        assert!(!file("json").exists());
    }
}

#[test]
fn what_is_not_proved_has_no_certificate() {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("certificate-refused.json");
    for (scene, flags, why) in [
        ("figure-4", "--f64", "a certificate needs certified folds, equilibria or a path"),
        ("transform", "", "a certificate needs certified folds, equilibria or a path"),
        ("hysteresis", "", "a certificate speaks of one work of adhesion"),
    ] {
        let command = format!("solve examples/scenes/{scene}.toml {flags} --certificate {}", file.display());
        let assert = mdr(&command).assert().code(2);
        let error = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
        assert!(error.contains(why), "{scene}: {error}");
        assert!(!file.exists());
    }
}
