//! The example scenes through the library: certified answers as they are published, and the same numbers in a build without
//! certified digits.
#![cfg(all(feature = "toml", feature = "serde"))]

use std::path::{Path, PathBuf};

use mdr::prelude::*;
use serde_json::Value as Json;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn scene(name: &str) -> Scene {
    Scene::open(root().join(format!("examples/scenes/{name}.toml"))).expect("a scene file")
}

fn names() -> Vec<String> {
    let files = std::fs::read_dir(root().join("examples/scenes"))
        .expect("a scene file")
        .map(|entry| entry.expect("a scene file").path());
    let scenes = files.filter(|path| path.extension().is_some_and(|extension| extension == "toml"));
    let mut names: Vec<_> =
        scenes.map(|path| path.file_stem().expect("a scene file").to_str().expect("a scene file").to_owned()).collect();
    names.sort();
    names
}

/// The output of the command line byte for byte, whose answers are checked in.
#[cfg(feature = "mp")]
#[test]
fn certified_answers_are_those_of_the_command_line() {
    for name in ["figure-4", "machine", "cone", "expression", "transform", "kinked", "hysteresis"] {
        let golden = std::fs::read_to_string(root().join(format!("tests/command_line/scenes/{name}.json"))).unwrap();
        assert_eq!(scene(name).solve().unwrap().to_json().trim(), golden.trim(), "{name}");
    }
}

/// Which states are admissible is proved as every digit is, for shapes and a table whose g falls as well, whose gap is enclosed.
#[cfg(feature = "mp")]
#[test]
fn which_states_are_admissible_is_proved() {
    let mut falling = 0;
    for name in names() {
        // Its rows are rough, and their folds many.
        if name == "table" {
            continue;
        }
        let scene = scene(&name).arithmetic(Arithmetic::Certified { digits: 20 });
        let answer: Json = serde_json::from_str(&scene.solve().unwrap().to_json()).unwrap();
        let Some(promise) = answer["promise"].get("admissible") else { continue };
        assert_eq!(promise, "certified", "{name}");
        falling += usize::from(answer["admissibility"].as_str().unwrap().contains("enclosures of the gap"));
    }
    assert_eq!(falling, 6);
}

/// Up to the end of a profile g rises, as towards the equator of a sphere, where it diverges: no gap closes there.
#[cfg(feature = "mp")]
#[test]
fn states_of_a_profile_that_ends_are_decided() {
    for other in [
        "kind = \"parabolic-dimple\", depth = \"1e-3\", radius = \"0.1\"",
        "kind = \"wavy-paraboloid\", radius = 1, amplitude = \"5e-4\", wavelength = \"0.1\"",
    ] {
        let text = format!(
            "material = {{ e_star = 1, work_of_adhesion = \"1e-5\" }}
            profile = {{ kind = \"sum\", term = [{{ kind = \"sphere\", radius = 1 }}, {{ {other} }}] }}
            control = {{ kind = \"indentation\" }}
            output = {{ want = [\"folds\"] }}\n"
        );
        let scene = Scene::from_toml(&text, "scene.toml", &mdr::no_files).unwrap();
        let answer: Json = serde_json::from_str(&scene.solve().unwrap().to_json()).unwrap();
        assert_eq!(answer["promise"]["admissible"], "certified", "{other}");
        assert_eq!(answer["folds"][0]["admissible"], true, "{answer}");
    }
}

/// `MDR_GOLDENS=overwrite` writes them anew.
#[test]
fn answers_in_f64_are_the_same_in_every_build() {
    let overwrite = std::env::var_os("MDR_GOLDENS").is_some_and(|value| value == "overwrite");
    for name in names().iter().filter(|name| cfg!(feature = "mp") || !needs_mp(name)) {
        let answer = scene(name).arithmetic(Arithmetic::F64).solve().unwrap().to_json();
        let golden = root().join(format!("crates/mdr/tests/f64/{name}.json"));
        if overwrite {
            std::fs::write(&golden, &answer).unwrap();
        }
        let golden: Json = serde_json::from_str(&std::fs::read_to_string(&golden).unwrap()).unwrap();
        let answer: Json = serde_json::from_str(&answer).unwrap();
        for kind in scene(name).wants().iter().map(Want::name) {
            close(&answer[kind], &golden[kind], 0.0, &format!("{name}.{kind}"));
        }
    }
}

#[test]
fn the_page_on_scenes_has_a_row_for_each_output() {
    let page = std::fs::read_to_string(root().join("docs/scenes.md")).unwrap();
    let (_, table) = page.split_once("| output | what it lists |").expect("the table of outputs");
    let named: Vec<&str> =
        table.lines().map_while(|line| line.split('|').nth(1).or(line.is_empty().then_some(""))).collect();
    for kind in OutputKind::ALL {
        let name = format!("`{kind}`");
        assert!(named.iter().any(|cell| cell.contains(&name)), "docs/scenes.md lacks a row for {name}");
    }
}

/// A formula with kinks is refused without certified digits.
fn needs_mp(name: &str) -> bool {
    name == "kinked"
}

/// Asserts equal structure, with numbers as close as the condition of the example scenes allows on any platform. Of two numbers
/// in one list the smaller may be a difference of larger ones, so that all are measured against the largest.
fn close(one: &Json, other: &Json, scale: f64, place: &str) {
    match (one, other) {
        (Json::Number(x), Json::Number(y)) => {
            let [x, y] = [x, y].map(|number| number.as_f64().expect("a double"));
            assert!((x - y).abs() <= 1e-11 * x.abs().max(scale), "{place}: {x:e}, not {y:e}");
        }
        (Json::Array(ones), Json::Array(others)) => {
            assert_eq!(ones.len(), others.len(), "{place}");
            for (index, (one, other)) in ones.iter().zip(others).enumerate() {
                close(one, other, scale, &format!("{place}[{index}]"));
            }
        }
        (Json::Object(ones), Json::Object(others)) => {
            // Of a formula it is proved by enclosures, and not known without them.
            let unproved = |key: &str| !cfg!(feature = "mp") && key == "admissible" && ones[key].is_null();
            for (key, other) in others.iter().filter(|(key, _)| *key != "why" && !unproved(key)) {
                let scale = largest(others, key);
                close(&ones[key], other, scale, &format!("{place}.{key}"));
            }
        }
        (one, other) => assert_eq!(one, other, "{place}"),
    }
}

/// The terms that cancel in a force, an indentation depth or an energy are as large as the numbers beside it.
fn largest(record: &serde_json::Map<String, Json>, key: &str) -> f64 {
    let beside: &[&str] = match key {
        "work" | "dissipated" | "stored" | "energy" => &["work", "dissipated", "stored", "energy"],
        _ => &[key],
    };
    beside.iter().filter_map(|key| record.get(*key)?.as_f64()).map(f64::abs).fold(0.0, f64::max)
}

#[cfg(not(feature = "mp"))]
#[test]
fn certified_digits_need_mp() {
    assert!(matches!(scene("figure-4").solve(), Err(Error::NeedsMp { .. })));
    let error = scene("figure-4").solve().unwrap_err().to_string();
    assert!(error.contains("the feature `mp`"), "{error}");
}
