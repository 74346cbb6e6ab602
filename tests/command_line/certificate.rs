//! `mdr solve --certificate`.

use std::path::Path;

use serde_json::Value;

use crate::{mdr, root};

/// The certificate of a scene, without the program that wrote it.
fn certificate(scene: &str) -> Value {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("certificate-{scene}.json"));
    mdr(&format!("solve examples/scenes/{scene}.toml --certificate {}", file.display())).assert().success();
    let mut value: Value = serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap();
    assert!(value["program"].as_str().is_some_and(|program| program.starts_with("mdr ")));
    value.as_object_mut().unwrap().remove("program");
    value
}

/// `make confirm` checks the stored certificates in Arb; these are those of this program.
#[test]
fn the_checked_certificates_are_those_of_the_program() {
    for scene in ["figure-4", "flat-punch", "displaced-paraboloid", "kinked"] {
        let stored = root().join(format!("tests/certificates/{scene}.json"));
        let stored: Value = serde_json::from_str(&std::fs::read_to_string(stored).unwrap()).unwrap();
        assert_eq!(certificate(scene), stored, "{scene}");
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
