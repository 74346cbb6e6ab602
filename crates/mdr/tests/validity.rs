//! Whether the theory holds: the same answer through every interface, and the answers at its limits.

use std::f64::consts::PI;

use mdr::critical::{PowerLaw, critical};
use mdr::prelude::*;
use mdr::validity::AdhesionRegime;
use mdr::{Validity, no_files};

fn contact<X: Exact + Clone>(shape: Shape<X>, e_star: &str, work: &str) -> Scene {
    let elasticity = Elasticity::effective(e_star).expect("a number");
    Scene::new(shape, elasticity, work).expect("a contact").arithmetic(Arithmetic::F64)
}

fn validity<X: Exact + Clone>(shape: Shape<X>, e_star: &str, work: &str, range: &str) -> Validity {
    let scene = contact(shape, e_star, work).range_of_adhesion(range).expect("a range");
    scene.validity().expect("an answer")
}

fn double(value: &Value) -> f64 {
    value.to_f64().expect("a number")
}

const SCENE: &str = "[material]\ne_star = 5e9\nwork_of_adhesion = 0.05\nrange_of_adhesion = \"0.3 nm\"\n\
                     [profile]\nkind = \"paraboloid\"\nradius = 1e-8\n[output]\nwant = [\"folds\"]\n";

#[test]
fn a_scene_says_it_wherever_the_range_stands() {
    let moved = SCENE.replace("range_of_adhesion = \"0.3 nm\"\n", "") + "range_of_adhesion = 3e-10\n";
    let built = validity(Shape::Paraboloid { radius: "1e-8" }, "5e9", "0.05", "3e-10");
    for text in [SCENE, &moved] {
        let scene =
            Scene::from_toml(text, "tip.toml", &no_files).expect("a scene").in_arithmetic(Some(Arithmetic::F64));
        let answer = scene.solve().expect("an answer");
        let found = answer.validity.as_deref().expect("asked for");
        assert_eq!(found.tabor, built.tabor);
        assert_eq!(found.maugis_dugdale_pull_off, built.maugis_dugdale_pull_off);
        assert_eq!(found.regime, AdhesionRegime::Transition);
        assert!(answer.to_json().contains(r#""validity":{"range_of_adhesion":""#));
    }
    let without = Scene::from_toml(&SCENE.replace("range_of_adhesion = \"0.3 nm\"\n", ""), "tip.toml", &no_files);
    let without = without.expect("a scene").in_arithmetic(Some(Arithmetic::F64));
    assert!(without.solve().expect("an answer").validity.is_none());
}

#[cfg(feature = "mp")]
#[test]
fn digits_are_those_of_doubles_and_more() {
    let scene = Scene::from_toml(SCENE, "tip.toml", &no_files).expect("a scene");
    let answer = scene.solve().expect("an answer");
    let found = answer.validity.expect("asked for");
    assert_eq!(found.promise(), Promise::Estimated);
    // Maugis 1992, solved for the least force with 30 digits by other means.
    assert_eq!(found.tabor.to_string(), "0.33333333333333333333");
    assert_eq!(found.maugis_dugdale_pull_off.to_string(), "-2.7780704315163099417e-9");
    let double = validity(Shape::Paraboloid { radius: "1e-8" }, "5e9", "0.05", "0.3e-9");
    let ratio =
        found.maugis_dugdale_pull_off.to_f64().unwrap_or(0.0) / double.maugis_dugdale_pull_off.to_f64().unwrap_or(1.0);
    assert!((ratio - 1.0).abs() < 1e-13, "{ratio}");
}

#[test]
fn regimes_and_limits_of_a_sphere() {
    let at = |range: &str| validity(Shape::Paraboloid { radius: "1" }, "1", "1e-6", range);
    let [short, middle, long] = ["1e-6", "1e-4", "1e-2"].map(at);
    let regimes = [&short, &middle, &long].map(|validity| validity.regime.name());
    assert_eq!(regimes, ["JKR", "transition", "DMT"]);
    let share = |validity: &Validity| -double(&validity.maugis_dugdale_pull_off) / (PI * 1e-6);
    assert!((share(&short) - 1.5).abs() < 1e-4 && (share(&long) - 2.0).abs() < 0.01);
    let correction = double(middle.correction.as_ref().expect("a number"));
    assert!((share(&middle) / 1.5 - 1.0 - correction).abs() < 1e-12);
    // g' = 2a/R.
    let a_over_r = double(middle.a_over_r.0.as_ref().expect("R is known"));
    assert!((double(&middle.slope) / a_over_r - 2.0).abs() < 1e-14);
}

#[test]
fn every_profile_has_an_answer() {
    let parameter = |shape: &str, key: &str| match (shape, key) {
        (_, "n") => "2",
        (_, "slope" | "c") => "0.5",
        (_, "flat" | "cap" | "offset") => "0.1",
        (_, "depth") => "1e-2",
        (_, "amplitude") => "1e-4",
        ("elliptical-dimple" | "parabolic-dimple", "radius") => "0.2",
        (_, "wavelength") => "0.2",
        _ => "1",
    };
    for name in Shape::names() {
        let shape = Shape::by_name(name).expect("a name").map(|key, ()| parameter(name, key));
        let found = validity(shape, "1", "1e-4", "1e-4");
        let [tabor, force] = [&found.tabor, &found.maugis_dugdale_pull_off].map(Value::to_f64);
        assert!(tabor.is_some_and(|tabor| tabor > 0.0), "{name}: {:?}", found.tabor);
        // At a sharp edge g' has an inverse root, and of a dimple g has no value: a ring over it may stay undecided.
        let sharp = name.starts_with("truncated") || name.ends_with("dimple");
        let undecided = sharp && found.maugis_dugdale_pull_off.status() == Status::Undecided;
        let known = undecided || force.is_some_and(|force| force < 0.0);
        assert!(known, "{name}: {:?}", found.maugis_dugdale_pull_off);
    }
}

#[test]
fn a_formula_and_a_table_have_an_answer() {
    let paraboloid = validity(Shape::Paraboloid { radius: "1" }, "1", "1e-4", "1e-3");
    let scene = SCENE.replace("5e9", "1").replace("0.05", "1e-4").replace("0.3 nm", "1e-3");
    let formula = scene.replace("kind = \"paraboloid\"\nradius = 1e-8", "kind = \"expression\"\nformula = \"r^2/2\"");
    let table = scene.replace("kind = \"paraboloid\"\nradius = 1e-8", "kind = \"table\"\nfile = \"tip.csv\"");
    let rows: String = (0..=200).map(|i| f64::from(i) / 200.0).map(|r| format!("{r},{}\n", r * r / 2.0)).collect();
    let files = |_: &str| Ok(rows.clone().into_bytes());
    for text in [formula, table] {
        let scene = Scene::from_toml(&text, "tip.toml", &files).expect("a scene").arithmetic(Arithmetic::F64);
        let found = scene.validity().expect("an answer");
        let ratio = double(&found.maugis_dugdale_pull_off) / double(&paraboloid.maugis_dugdale_pull_off);
        assert!((ratio - 1.0).abs() < 1e-3, "{ratio}");
    }
}

#[test]
fn exactly_zero_is_the_limit_of_short_range() {
    let found = validity(Shape::Power { n: "1/4", c: "1" }, "1", "1e-4", "1e-3");
    assert_eq!(found.jkr_pull_off, Some(Value::Given(0.into())));
    assert!(found.correction.is_none());
    assert!(double(&found.maugis_dugdale_pull_off) < 0.0);
    assert!(found.advice().contains("exactly 0 is the limit of short range"), "{}", found.advice());
    // n = 1/2 has no instability under a dead load, and no Tabor number.
    let found = validity(Shape::Power { n: "1/2", c: "1" }, "1", "1e-4", "1e-3");
    assert_eq!((found.regime, found.tabor.status()), (AdhesionRegime::Unknown, Status::NoEquilibrium));
    assert!(double(&found.maugis_dugdale_pull_off) < 0.0);
}

#[test]
fn a_power_law_has_it_beside_its_critical_state() {
    let [n, c, work, range] = ["2", "5e7", "0.05", "3e-10"].map(|text| text.parse::<Literal>().expect("a number"));
    let elasticity = Elasticity::effective("5e9").expect("a number");
    let law = PowerLaw { n, c, elasticity, work_of_adhesion: work, control: Control::Indentation };
    let answer = critical(&law, Arithmetic::F64).expect("an answer");
    assert!(answer.validity.is_none());
    let found = answer.with_range(&range).expect("an answer").validity.expect("asked for");
    let paraboloid = validity(Shape::Paraboloid { radius: "1e-8" }, "5e9", "0.05", "3e-10");
    assert!((double(&found.tabor) / double(&paraboloid.tabor) - 1.0).abs() < 1e-14);
}

#[test]
fn a_bad_range_is_refused_where_it_stands() {
    let complaint = |text: &str| Scene::from_toml(text, "tip.toml", &no_files).expect_err("refused").to_string();
    let negative = complaint(&SCENE.replace("0.3 nm", "-0.3 nm"));
    assert_eq!(negative, "tip.toml:4: material.range_of_adhesion: must be positive, got -0.3e-9");
    let second = complaint(&SCENE.replace("0.3 nm", "0.3 s"));
    assert!(second.contains("material.range_of_adhesion") && second.contains("unknown unit `s`"), "{second}");
    assert!(complaint(&format!("{SCENE}range_of_adhesion = 1e-9\n")).contains("is given in [material], too"));
    let alone = "[profile]\nkind = \"paraboloid\"\nradius = 1\n[output]\nwant = [\"transform\"]\ntransform.at = [1]\n\
                 range_of_adhesion = 1e-9\n";
    assert!(complaint(alone).contains("output.range_of_adhesion: needs a material"));
    let scene = contact(Shape::Paraboloid { radius: "1" }, "1", "1");
    assert!(scene.clone().range_of_adhesion("0").expect_err("refused").to_string().contains("must be positive, got 0"));
    assert!(scene.validity().expect_err("refused").to_string().contains("missing"));
    // A ring that would reach beyond the equator of the ball.
    let found = validity(Shape::Sphere { radius: "1" }, "1", "1e-4", "10");
    assert_eq!(found.maugis_dugdale_pull_off.status(), Status::DomainError);
}
