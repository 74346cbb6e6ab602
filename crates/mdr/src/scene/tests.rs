use super::reader::Document;
use super::*;

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
    Scene::read(&Document::from_text("scene.toml", text), None).expect_err("a bad scene").to_string()
}

/// Figure 4 with one line replaced.
fn changed(from: &str, to: &str) -> String {
    assert!(FIGURE_4.contains(from));
    complaint(&FIGURE_4.replace(from, to))
}

#[test]
fn a_good_scene_keeps_its_decimals() {
    let scene = Scene::read(&Document::from_text("scene.toml", FIGURE_4), None).expect("a good scene");
    let Shape::WavyParaboloid { amplitude, .. } = &scene.profile else { panic!("{:?}", scene.profile) };
    assert_eq!(amplitude.to_string(), "5e-4");
    assert_eq!(scene.output.want, [Want::Folds, Want::Path]);
    assert_eq!((&scene.held.by, &scene.held.start), (&HeldBy::Indentation, &Start::Largest));
    assert_eq!(scene.output.arithmetic, Arithmetic::Certified { digits: 20 });
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
    assert!(Scene::read(&Document::from_text("scene.toml", bodies(two)), None).is_ok());
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
    assert!(Scene::read(&Document::from_text("scene.toml", profile(good)), None).is_ok());
    assert!(
        complaint(&profile("formula = \"r^2/(2*R\"")).contains("scene.toml:8: profile.formula: column 9: expected `)`")
    );
    assert!(complaint(&profile("formula = \"r^2/Q\"")).contains("column 5: unknown name `Q`"));
    assert!(complaint(&profile(&good.replace("R = 2", "R = 2, S = 1"))).contains("no parameter `S`"));
}
