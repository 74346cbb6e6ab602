//! Scenes from TOML, from JSON and from the builder: one value, and complaints that name file, line and key.

use mdr::no_files;
use mdr::prelude::*;

const FIGURE_4: &str = r#"
[material]
e_star = "1"
work_of_adhesion = "1e-4"

[profile]
kind = "wavy-paraboloid"
radius = 1
amplitude = 5e-4
wavelength = "0.1"

[control]
kind = "indentation"
path = ["0", "-0.01"]
start = "largest"

[output]
want = ["folds", "path"]
digits = 20
"#;

fn complaint(text: &str) -> String {
    Scene::from_toml(text, "scene.toml", &no_files).expect_err("a bad scene").to_string()
}

/// Figure 4 with one line replaced.
fn changed(from: &str, to: &str) -> String {
    assert!(FIGURE_4.contains(from));
    complaint(&FIGURE_4.replace(from, to))
}

#[test]
fn a_good_scene_keeps_its_decimals() {
    let scene = Scene::from_toml(FIGURE_4, "scene.toml", &no_files).expect("a good scene");
    let Profile::Shape(Shape::WavyParaboloid { amplitude, .. }) = scene.profile() else {
        panic!("{:?}", scene.profile())
    };
    assert_eq!(amplitude.to_string(), "5e-4");
    assert_eq!(scene.wants(), [Want::Folds { range: None }, Want::Path]);
    assert_eq!(*scene.controlled(), Control::Indentation);
    assert_eq!(scene.answers_in(), Arithmetic::Certified { digits: 20 });
}

#[test]
fn complaints_name_file_line_and_key() {
    for (from, to, expected) in [
        (
            "wavelength =",
            "wavelenght =",
            "scene.toml:10: profile.wavelenght: unknown key `wavelenght`; did you mean `wavelength`?",
        ),
        ("radius = 1", "radius = \"-1\"", "scene.toml:8: profile.radius: must be positive, got -1"),
        ("radius = 1", "radius = true", "scene.toml:8: profile.radius: expected a number, got a TOML boolean"),
        (
            "radius = 1",
            "radius = nan",
            "scene.toml:8: profile.radius: `nan` is not finite: expected a decimal such as 0.25 or 1e-9",
        ),
        (
            "wavy-paraboloid",
            "wavy-parabolid",
            "scene.toml:7: profile.kind: unknown profile `wavy-parabolid`; did you mean `wavy-paraboloid`?",
        ),
        (
            "kind = \"indentation\"",
            "kind = \"machine\"",
            "scene.toml:12: control: missing key `stiffness` in [control]",
        ),
        ("\"folds\"", "\"fold\"", "scene.toml:18: output.want: unknown output `fold`; did you mean `folds`?"),
        ("digits = 20", "digits = 0", "scene.toml:19: output.digits: must be a whole number from 1 to 100000, got 0"),
        (
            "path = [\"0\", \"-0.01\"]",
            "path = [\"0\"]",
            "scene.toml:18: output.want: `path` needs at least two way points: [control] path = [\"…\", \"…\"]",
        ),
        (
            "start = \"largest\"",
            "start = \"biggest\"",
            "scene.toml:15: control.start: expected \"largest\", \"smallest\", \"detached\" or a positive contact radius",
        ),
        ("e_star = \"1\"", "", "scene.toml:2: material: missing key `e_star` or `body` in [material]"),
        ("[material]", "[materials]", "scene.toml:2: materials: unknown key `materials`; did you mean `material`?"),
    ] {
        let got = changed(from, to);
        assert!(got == expected, "\n got {got}\nwant {expected}");
    }
}

#[test]
fn two_bodies_or_none() {
    let bodies = |text: &str| FIGURE_4.replace("e_star = \"1\"", text);
    let two = "body = [{ e = 1e6, nu = 0.5 }, { e = 2e11, nu = \"0.3\" }]";
    assert!(Scene::from_toml(&bodies(two), "scene.toml", &no_files).is_ok());
    assert!(complaint(&bodies("body = [{ e = 1e6, nu = 0.5 }]")).contains("expected two bodies, got 1"));
    assert!(complaint(&bodies("body = [{ e = 1, nu = 0.6 }, { e = 1, nu = 0 }]")).contains("(-1, 1/2], got 0.6"));
    assert!(complaint(&bodies("e_star = 1\nbody = []")).contains("cannot be given together with `e_star`"));
}

#[test]
fn formulas_point_at_the_column() {
    let profile = |text: &str| {
        let start = FIGURE_4.find("[profile]").unwrap_or(0);
        let end = FIGURE_4.find("[control]").unwrap_or(0);
        format!("{}[profile]\nkind = \"expression\"\n{text}\n{}", &FIGURE_4[..start], &FIGURE_4[end..])
    };
    let good = "formula = \"r^2/(2*R)\"\nparameters = { R = 2 }";
    assert!(Scene::from_toml(&profile(good), "scene.toml", &no_files).is_ok());
    assert!(
        complaint(&profile("formula = \"r^2/(2*R\"")).contains("scene.toml:8: profile.formula: column 9: expected `)`")
    );
    assert!(complaint(&profile("formula = \"r^2/Q\"")).contains("column 5: unknown name `Q`"));
    assert!(complaint(&profile(&good.replace("R = 2", "R = 2, S = 1"))).contains("no parameter `S`"));
}

/// Figure 4 as JSON, and as it is built.
#[test]
fn json_toml_and_the_builder_meet_in_one_scene() {
    let json = r#"{
        "material": {"e_star": "1", "work_of_adhesion": 1e-4},
        "profile": {"kind": "wavy-paraboloid", "radius": 1, "amplitude": 5e-4, "wavelength": "0.1"},
        "control": {"kind": "indentation", "path": ["0", -0.01], "start": "largest"},
        "output": {"want": ["folds", "path"], "arithmetic": "f64"}
    }"#;
    let toml = FIGURE_4.replace("digits = 20", "arithmetic = \"f64\"");
    let tip = Shape::WavyParaboloid { radius: "1", amplitude: "5e-4", wavelength: "0.1" };
    let built = Scene::new(tip, Elasticity::effective(1).unwrap(), 1e-4)
        .and_then(|scene| scene.control(Control::Indentation).path(["0", "-0.01"]))
        .unwrap()
        .want(Want::Folds { range: None })
        .want(Want::Path)
        .arithmetic(Arithmetic::F64);
    let answers = [
        Scene::from_toml(&toml, "scene.toml", &no_files).unwrap().solve().unwrap(),
        Scene::from_json(json, "scene.json", &no_files).unwrap().solve().unwrap(),
        built.solve().unwrap(),
    ];
    assert_eq!(answers[0], answers[1]);
    assert_eq!(answers[0], answers[2]);
}

#[test]
fn complaints_about_json_name_the_line_and_the_key() {
    let complaint = |text: &str| Scene::from_json(text, "scene.json", &no_files).unwrap_err().to_string();
    for (text, expected) in [
        (
            "{\n \"profile\": {\"kind\": \"cone\",\n  \"slope\": true}}",
            "scene.json:3: profile.slope: expected a number, got a JSON boolean",
        ),
        (
            "{\"profile\": {\"kind\": \"cone\", \"slop\": 1}}",
            "scene.json:1: profile.slop: unknown key `slop`; did you mean `slope`?",
        ),
        ("{\"profile\": 1}", "scene.json:1: profile: expected a table [profile], got a JSON number"),
    ] {
        assert_eq!(complaint(text), expected);
    }
    assert!(complaint("{\n\"profile\":").starts_with("scene.json:2: not JSON: EOF"));
    assert!(complaint("{\"profile\": {}, \"profile\": {}}").contains("duplicate key `profile`"));
}

#[test]
fn a_scene_that_is_built_is_checked_as_one_that_is_read() {
    let modulus = || Elasticity::effective("1e6").unwrap();
    let complaint = |scene: Result<Scene, Error>| scene.and_then(|scene| scene.solve()).unwrap_err().to_string();
    let cone = |slope: &'static str| Shape::Cone { flank: Flank::Slope(slope) };
    assert_eq!(complaint(Scene::new(cone("-1"), modulus(), 1)), "profile.slope: must be positive, got -1");
    assert_eq!(complaint(Scene::new(cone("1"), modulus(), 0)), "material.work_of_adhesion: must be positive, got 0");
    assert!(complaint(Scene::new(cone("x"), modulus(), 1)).starts_with("profile.slope: not a number"));
    assert_eq!(complaint(Scene::new(cone("1"), modulus(), 1)), "output.want: nothing is wanted");
    let unmoved = Scene::new(cone("1"), modulus(), 1).map(|scene| scene.want(Want::Path));
    assert!(complaint(unmoved).starts_with("output.want: `path` needs at least two way points"));
    let bodies = |nu: &str| {
        let body = |nu: &str| Body { youngs_modulus: "1e6".parse().unwrap(), poissons_ratio: nu.parse().unwrap() };
        Elasticity::bodies(body("0.3"), body(nu))
    };
    assert!(complaint(Scene::new(cone("1"), bodies("0.51"), 1)).contains("(-1, 1/2], got 0.51"));
    assert!(Scene::new(cone("1"), bodies("0.5"), 1).is_ok());
    assert!(complaint(Scene::open("no-such-scene.toml")).starts_with("no-such-scene.toml: "));
}

/// A thread of a test has 2 MiB of stack, which is less than a program or Python has.
#[test]
fn nesting_is_refused_at_a_stated_depth() {
    let sums = |count: usize| {
        let profile = format!(
            "{}{{\"kind\":\"cone\",\"slope\":1}}{}",
            "{\"kind\":\"sum\",\"term\":[".repeat(count),
            "]}".repeat(count)
        );
        format!("{{\"profile\":{profile},\"output\":{{\"want\":[\"transform\"],\"transform\":{{\"at\":[1]}}}}}}")
    };
    let json = |text: &str| Scene::from_json(text, "scene.json", &no_files);
    // The sum is level 1, its terms are level 2, each of them level 3.
    assert!(json(&sums(31)).expect("level 63").in_arithmetic(Some(Arithmetic::F64)).solve().is_ok());
    let inline = |count: usize| format!("x = {}1{}", "{a.a.a.a = ".repeat(count), "}".repeat(count));
    let keys = (0..70).fold("1".to_owned(), |value, _| format!("{{{} = {value}}}", ["a"; 79].join(".")));
    let array = format!("[[profile{}]]\na = 1\n", ".term".repeat(70));
    for count in [32, 33, 2000, 100_000] {
        let error = json(&sums(count)).expect_err("too deep").to_string();
        assert!(error.starts_with("scene.json:1: not JSON: nested deeper than 64 levels"), "{count}: {error}");
    }
    for text in [inline(17), format!("x = {keys}"), array] {
        let error = complaint(&text);
        assert!(error.starts_with("scene.toml:1: not TOML: nested deeper than 64 levels"), "{error}");
    }
    assert!(complaint(&inline(100_000)).contains("not TOML: "));
    assert!(complaint(&format!("{} = 1", vec!["a"; 100_000].join("."))).contains("not TOML: "));
}

/// Lists from a file or a pipe are bounded where they are read; lists of a scene built in Rust, here.
#[test]
fn lists_that_are_built_have_the_length_of_lists_that_are_read() {
    let scene = || {
        let elasticity = Elasticity::effective("1").expect("a modulus");
        Scene::new(Shape::Paraboloid { radius: "1" }, elasticity, "1e-4")
            .expect("a contact")
            .arithmetic(Arithmetic::F64)
    };
    let many = |count: usize| (0..count).map(|value| Literal::from(value as i64)).collect::<Vec<_>>();
    let path = scene().path(many(10_001)).expect("numbers").want(Want::Path).solve();
    assert!(path.expect_err("too long").to_string().starts_with("control.path: 10001 way points; at most 10000"));
    let field = Want::Pressure { states: many(101), at: many(1000) };
    let error = scene().want(field).solve().expect_err("too many").to_string();
    assert!(error.contains("`pressure` would have 101000 rows; at most 100000"), "{error}");
}
