//! The readers of foreign text, each as a function of any bytes: it reads them and panics only where a promise is broken.
//!
//! `tests/readers.rs` of the workspace runs the same functions over `corpus/` and over random changes of it.

use mdr::Scene;
use mdr::prelude::Literal;
use mdr_core::contact::{Expression, Profile};
use mdr_core::units::SiUnit;
use mdr_reference::{Judge, Rules, records};

/// The longest message, in bytes: messages quote excerpts of an input, never all of it.
const LONGEST_MESSAGE: usize = 4000;

/// A message for a person: neither empty nor a copy of a long input.
fn readable(message: &str) {
    assert!(!message.trim().is_empty() && message.len() < LONGEST_MESSAGE, "a message of {} bytes", message.len());
}

/// A scene as TOML and as JSON.
pub fn scene(input: &[u8]) {
    let Ok(text) = std::str::from_utf8(input) else { return };
    for read in [Scene::from_toml, Scene::from_json] {
        match read(text, "scene", &mdr::no_files) {
            Ok(scene) => assert!(
                scene.wants().iter().all(|want| want.values().iter().all(|value| !value.nearest_f64().is_nan()))
            ),
            Err(error) => readable(&error.to_string()),
        }
    }
}

/// A formula: its parameters, and its heights in f64 wherever they are.
pub fn formula(input: &[u8]) {
    let Ok(text) = std::str::from_utf8(input) else { return };
    match text.parse::<Expression>() {
        Ok(formula) => {
            let one = Literal::from(1);
            let values = formula.parameters().map(|name| (name, one.clone())).collect();
            let profile = formula.bind::<f64>((), &values).expect("every parameter has a value");
            for radius in [1e-300, 1e-9, 1.0, 1e9, 1e300] {
                let _height: f64 = profile.height(&radius);
            }
        }
        Err(error) => readable(&error.to_string()),
    }
}

/// A number, bare or with a unit: it is printed as a number that is equal to it.
pub fn literal(input: &[u8]) {
    let Ok(text) = std::str::from_utf8(input) else { return };
    match text.parse::<Literal>() {
        Ok(number) => {
            let again: Literal = number.to_string().parse().expect("a number is printed as one");
            assert!(again.compare(&number).is_eq(), "{text} is printed as {number}");
            assert!(!number.nearest_f64().is_nan(), "{text} has no nearest double");
        }
        Err(error) => readable(&error.to_string()),
    }
    for unit in [SiUnit::Metre, SiUnit::Degree, SiUnit::Unstated] {
        match unit.read(text) {
            Ok(number) => assert!(!number.nearest_f64().is_nan(), "{text}"),
            Err(error) => readable(&error.to_string()),
        }
    }
}

/// Answers of another program, one a line, and the report about them.
pub fn jsonl(input: &[u8]) {
    let mut judge = Judge::new(records().iter().take(200), Rules::default());
    judge.read(input).expect("bytes can be read");
    let report = judge.report();
    assert!(report.answered() <= report.questions());
    assert_eq!(report.passed(), report.failures().is_empty());
    report.failures().iter().for_each(|failure| readable(failure));
    readable(&report.summary());
}
