//! `mdr solve`: paths beyond what is proved, to the end of a profile, and on soft machines.

use serde_json::Value;

use crate::{events, mdr, number, root, solved};

/// A scene with E* = 1 at fixed grips.
fn scene(work: &str, profile: &str, rest: &str) -> String {
    format!(
        "material = {{ e_star = 1, work_of_adhesion = \"{work}\" }}\nprofile = {{ {profile} }}\n\
         control = {{ kind = \"indentation\", path = [{rest}] }}\noutput = {{ want = [\"path\"] }}\n"
    )
}

fn near(value: &Value, expected: f64, error: f64) {
    assert!((number(value) / expected - 1.0).abs() < error, "{value}, {expected}");
}

/// Folds that are proved on a part of the radii do not prove a path that leaves them.
#[test]
fn a_path_that_leaves_the_proved_range_is_not_proved() {
    let figure = std::fs::read_to_string(root().join("examples/scenes/figure-4.toml")).unwrap();
    let on = |range: &str| solved(&format!("{figure}\n[output.folds]\nrange = [{range}]\n"), "--digits 6");
    for range in ["\"0.05\", \"1\"", "\"0.06\", \"1\"", "\"0.03\", \"0.05\"", "\"0.01\", \"0.03\""] {
        let answer = on(range);
        assert_eq!((&answer["promise"]["path"], &answer["complete"]["path"]["proved"]), (&"f64".into(), &false.into()));
        assert!(answer["complete"]["path"]["why"].as_str().unwrap().contains("not every state"), "{answer}");
        assert_eq!(events(&answer), ["start", "jump", "detached", "end"], "{answer}");
        near(&answer["path"][2]["contact_radius"], 0.0189447, 1e-5);
        near(&answer["path"][2]["indentation"], -0.00248816, 1e-5);
    }
    let answer = on("\"0.001\", \"1\"");
    assert_eq!(
        (&answer["promise"]["path"], &answer["complete"]["path"]["proved"]),
        (&"certified".into(), &true.into())
    );
}

/// The range of the proof holds the radii of the path.
#[test]
fn the_proved_range_is_that_of_the_path() {
    let answer = solved(&scene("1", "kind = \"paraboloid\", radius = 1", "0, \"1e15\", -10"), "--digits 6");
    let complete = &answer["complete"]["path"];
    assert_eq!((&complete["from"], &complete["to"]), (&"0".into(), &Value::Null), "{answer}");
    let sum = "kind = \"sum\", term = [{ kind = \"paraboloid\", radius = 1 }, { kind = \"cone\", slope = 1 }]";
    let answer = solved(&scene("1", sum, "0, \"1e9\", -10"), "--digits 6");
    let complete = &answer["complete"]["path"];
    let largest = number(&answer["path"][1]["contact_radius"]);
    assert!(complete["proved"] == true && number(&complete["to"]) > largest && largest > 3e4, "{answer}");
}

/// The table ends, and the contact with it, in the state in which it comes there.
#[test]
fn the_end_of_a_table() {
    let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("ends.csv");
    std::fs::write(&file, "r,f\nm,m\n0,0\n1,0.5\n2,2\n3,4.5\n4,8\n").unwrap();
    let table = format!("kind = \"table\", file = \"{}\"", file.display());
    let elongation = (8.0 * std::f64::consts::PI).sqrt();
    for flags in ["--digits 12", "--f64"] {
        let answer = solved(&scene("1", &table, "0, 100, -5"), flags);
        assert_eq!(events(&answer), ["start", "end-of-profile"]);
        let end = &answer["path"][1];
        assert_eq!(number(&end["contact_radius"]), 4.0);
        near(&end["indentation"], 16.0 - elongation, 1e-11);
        near(&end["force"], 8.0 * (32.0 / 3.0 - elongation), 1e-11);
    }
}

/// Neither a sphere nor a paraboloid ends at a finite depth.
#[test]
fn what_is_no_end_of_a_profile() {
    let sphere = scene("1", "kind = \"sphere\", radius = 1", "0, 100, -5");
    let answer = solved(&sphere, "--digits 10");
    assert_eq!(
        (&answer["promise"]["path"], events(&answer)),
        (&"certified".into(), vec!["start", "way-point", "detached", "end"])
    );
    // a → 1, ∫₀¹ x artanh x = 1/2.
    near(&answer["path"][1]["contact_radius"], 1.0, 1e-9);
    near(&answer["path"][1]["force"], 2.0 * 99.5, 1e-9);
    let answer = solved(&sphere, "--f64");
    assert_eq!(events(&answer), ["start", "way-point", "detached", "end"]);
    near(&answer["path"][1]["force"], 2.0 * 99.5, 1e-14);
    // Of a formula nothing is known at the radius where it ends.
    let formula = "kind = \"expression\", formula = \"1 - sqrt(1 - r^2)\"";
    let answer = solved(&scene("1", formula, "0, 100, -5"), "--f64");
    assert_eq!(events(&answer), ["start", "undecided"]);
    assert!(answer["balance"].is_null());
    assert_eq!((&answer["path"][1]["status"], &answer["path"][1]["force"]), (&"undecided".into(), &Value::Null));
    let answer = solved(&scene("1", "kind = \"paraboloid\", radius = 1", "0, \"1e700\""), "--digits 10");
    assert_eq!((&answer["promise"]["path"], events(&answer)), (&"certified".into(), vec!["start", "end"]));
    assert_eq!(answer["path"][1]["contact_radius"], "1.000000000e+350");
}

/// The work of the control on a way to and fro is what is lost and what is stored, whatever went in and came back between.
#[test]
fn the_work_of_a_long_way() {
    for (depth, flags) in [("1e8", "--f64"), ("1e20", "--f64"), ("1e100", "--digits 6")] {
        let way = format!("0, \"{depth}\", -10");
        let answer = solved(&scene("1", "kind = \"paraboloid\", radius = 1", &way), flags);
        near(&answer["balance"]["work"], 7.0922, 1e-5);
    }
}

/// On a machine softer than the contact the force is that of its spring.
#[test]
fn a_soft_machine_keeps_the_digits_of_the_force() {
    let machine = |modulus: &str, work: &str, profile: &str, stiffness: &str| {
        format!(
            "material = {{ e_star = \"{modulus}\", work_of_adhesion = \"{work}\" }}\nprofile = {{ {profile} }}\n\
             control = {{ kind = \"machine\", stiffness = \"{stiffness}\", path = [0, 0] }}\n\
             output = {{ want = [\"path\", \"equilibria\"], equilibria = {{ at = [0] }} }}\n"
        )
    };
    let soft = machine("1e11", "0.05", "kind = \"paraboloid\", radius = \"0.01\"", "0.01");
    let softer = machine("1", "1.933", "kind = \"power\", n = 0.6, c = 0.1214", "1.233");
    for (scene, expected, error) in [(soft, -2.645_048_67e-11, 1e-8), (softer, -3.95e9, 1e-2)] {
        let answer = solved(&scene, "--f64");
        near(&answer["path"][0]["force"], expected, error);
        let states = answer["equilibria"][0]["equilibria"].as_array().unwrap();
        let stable = states.iter().rfind(|state| state["stable"] == true).unwrap();
        near(&stable["force"], expected, error);
    }
}

/// Inside a flat face the pressure is finite, though g' is not at its edge.
#[test]
fn the_pressure_inside_a_flat_face() {
    let scene = "material = { e_star = 1, work_of_adhesion = 0.05 }
        profile = { kind = \"truncated-cone\", slope = 1, flat = 0.2 }
        control = { kind = \"indentation\" }
        [output]\nwant = [\"pressure\"]\nequilibria.at = [0.1]\npressure.at = [0, 0.1, 0.2]\n";
    for (flags, error) in [("--f64", 1e-11), ("--digits 12", 1e-11)] {
        let answer = solved(scene, flags);
        let points = &answer["pressure"][0]["states"].as_array().unwrap().last().unwrap()["pressure"];
        near(&points[0]["pressure"], 0.260195574898, error);
        near(&points[1]["pressure"], 0.299026347, 1e-8);
        assert_eq!(points[2]["status"], "domain-error", "infinite at the edge: {answer}");
    }
}

/// An indentation that is exactly zero at the fold, as for n = 3/2 under a dead load, is known from the closed form.
#[test]
fn an_exact_zero_on_a_path() {
    let scene = "material = { e_star = 1, work_of_adhesion = 1 }
        profile = { kind = \"power\", n = \"1.5\", c = 1 }
        control = { kind = \"force\", path = [0, -50] }
        [output]\nwant = [\"folds\", \"path\"]\n";
    let answer = solved(scene, "--digits 9");
    let fold = &answer["path"][1];
    assert_eq!(
        (&fold["event"], &fold["indentation"], &fold["status"]),
        (&"detached".into(), &"0".into(), &"ok".into())
    );
    assert_eq!(fold["force"], answer["folds"][0]["force"]);
}

/// In CSV a column of numbers has numbers only.
#[test]
fn a_column_of_numbers_has_numbers_only() {
    let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("parabola.csv");
    std::fs::write(&file, "r,f\nm,m\n0,0\n1,0.5\n2,2\n3,4.5\n4,8\n").unwrap();
    let scene = format!(
        "material = {{ e_star = 1, work_of_adhesion = 1 }}\nprofile = {{ kind = \"table\", file = \"{}\" }}\n\
         control = {{ kind = \"indentation\" }}\noutput = {{ want = [\"transform\"], transform = {{ at = [\"1e-300\"] }} }}\n",
        file.display()
    );
    let assert = mdr("solve - --f64 --format csv").stdin(&scene).assert().success();
    let text = String::from_utf8(assert.get_output().stdout.clone()).unwrap();
    let [header, row] = &text.lines().map(|line| line.split(',').collect::<Vec<_>>()).collect::<Vec<_>>()[..] else {
        panic!("{text}")
    };
    let at = |key: &str| row[header.iter().position(|name| *name == key).unwrap_or_else(|| panic!("{key} in {text}"))];
    assert_eq!((at("g"), at("integral"), at("status")), ("", "", "underflow"));
    assert!((at("log10_g").parse::<f64>().unwrap() + 600.0).abs() < 1e-6, "{text}");
    assert!((at("slope").parse::<f64>().unwrap() / 2e-300 - 1.0).abs() < 1e-12, "{text}");
}

/// A picture that cannot be drawn says which flag asks for it, and points at the number.
#[test]
fn a_picture_out_of_hardware_names_its_flag_and_the_number() {
    let scene = scene("1", "kind = \"paraboloid\", radius = \"1e400\"", "0, -1").replace("\"path\"", "\"folds\"");
    let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("huge.svg");
    let assert = mdr(&format!("solve - --digits 6 --plot {}", file.display())).stdin(scene).assert().code(2);
    let text = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
    assert_eq!(
        text,
        "error: <stdin>:2: profile.radius: out of the range of f64 (a drawing is made in f64), got 1e400\n"
    );
}

/// A formula that ends at a radius is searched up to it: that of a sphere has the equilibria of the sphere.
#[test]
fn a_formula_with_an_end() {
    let scene = |profile: &str| {
        format!(
            "material = {{ e_star = 1, work_of_adhesion = \"0.01\" }}\nprofile = {{ {profile} }}\n\
             control = {{ kind = \"indentation\" }}\n[output]\nwant = [\"equilibria\", \"transform\"]\n\
             equilibria.at = [0, 1]\ntransform.at = [\"0.5\", \"1.5\"]\n"
        )
    };
    let read = |profile: &str| solved(&scene(profile), "--f64");
    let (formula, sphere) =
        (read("kind = \"expression\", formula = \"1-sqrt(1-r^2)\""), read("kind = \"sphere\", radius = 1"));
    for value in [0, 1] {
        let radii = |answer: &Value| -> Vec<f64> {
            let states = answer["equilibria"][value]["equilibria"].as_array().unwrap();
            states.iter().map(|state| number(&state["contact_radius"])).collect()
        };
        let (found, expected) = (radii(&formula), radii(&sphere));
        assert_eq!(found.len(), expected.len(), "{formula}");
        assert!(found.iter().zip(&expected).all(|(a, b)| (a / b - 1.0).abs() < 1e-12), "{found:?} {expected:?}");
        assert!(!found.is_empty());
    }
    assert_eq!(formula["transform"][1]["status"], "domain-error");
}

/// A value that cannot be proved leaves the others as they are: each says whether it is.
#[test]
fn values_are_proved_one_by_one() {
    let scene = "material = { e_star = 1, work_of_adhesion = 1 }
        profile = { kind = \"elliptical-dimple\", depth = 1, radius = 1 }
        control = { kind = \"indentation\" }
        [output]\nwant = [\"equilibria\"]\nequilibria.at = [-5, -2]\n";
    let (answer, rough) = (solved(scene, "--digits 9"), solved(scene, "--f64"));
    let values = answer["equilibria"].as_array().unwrap();
    assert_eq!((&values[0]["proved"], &values[1]["proved"]), (&false.into(), &true.into()), "{answer}");
    assert_eq!(answer["complete"]["equilibria"]["proved"], false, "{answer}");
    for (value, known) in values.iter().zip(rough["equilibria"].as_array().unwrap()) {
        let (value, known) = (&value["equilibria"][0], &known["equilibria"][0]);
        near(&value["contact_radius"], number(&known["contact_radius"]), 1e-8);
    }
}

const DEEP: &str = r#"
material = { e_star = 1, work_of_adhesion = 1e-4 }
profile = { kind = "wavy-paraboloid", radius = 1, amplitude = 5e-3, wavelength = 0.1 }
control = { kind = "indentation", path = ["0.001", "0.02", "0"], start = "smallest" }
[output]
want = ["path", "folds"]
"#;

/// The next crest is touched before the first fold: the path ends there, in either arithmetic, and gains no energy beyond. The
/// numbers are those of a gap summed on a fine grid in another program.
#[test]
fn a_path_ends_where_admissibility_is_lost() {
    for (flags, promise) in [("--f64", "f64"), ("--digits 12", "certified")] {
        let answer = solved(DEEP, flags);
        let events = answer["path"].as_array().unwrap();
        let last = events.last().unwrap();
        assert_eq!((events.len(), last["event"].as_str()), (2, Some("not-admissible")), "{answer}");
        assert!((number(&last["contact_radius"]) / 0.0231857 - 1.0).abs() < 1e-5, "{last}");
        assert!((number(&last["indentation"]) / 0.00503335 - 1.0).abs() < 1e-5, "{last}");
        assert!((number(&last["interpenetration"][0]["r"]) - 0.0953).abs() < 2e-4, "{last}");
        assert_eq!((&last["admissible"], &events[0]["admissible"]), (&false.into(), &true.into()));
        assert!(last["why"].as_str().is_some_and(|why| why.contains("largest")));
        assert!(answer["folds"].as_array().unwrap().iter().all(|fold| !fold["admissible"].is_null()));
        assert_eq!(answer["promise"]["admissible"], promise);
    }
}

/// A cone with a dimple is lowest at the rim of the dimple: f(1) = −0.4.
#[test]
fn surfaces_first_touch_where_the_profile_is_lowest() {
    let scene = r#"
control = { kind = "indentation", path = ["-1", "0.01"], start = "detached" }
material = { e_star = 1, work_of_adhesion = 1e-9 }
output = { want = ["path"] }
profile = { kind = "sum", term = [{ kind = "cone", slope = "0.1" }, { kind = "parabolic-dimple", depth = "0.5", radius = "1" }] }
"#;
    for flags in ["--f64", "--digits 8"] {
        let answer = solved(scene, flags);
        let touch = &answer["path"][1];
        assert_eq!(touch["event"], "not-admissible", "{answer}");
        assert!((number(&touch["indentation"]) + 0.4).abs() < 1e-9, "{touch}");
        assert_eq!(number(&touch["interpenetration"][0]["r"]), 1.0, "{touch}");
    }
}

/// The fold of a cone is at −w/(E* tan θ) exactly, and a way point may be as well.
#[test]
fn a_way_point_at_a_rational_fold_is_decided() {
    for (slope, value) in [("1", "-1"), ("3", "-1/3"), ("0.7", "-10/7")] {
        let scene = format!(
            "material = {{ e_star = 1, work_of_adhesion = 1 }}\nprofile = {{ kind = \"cone\", slope = \"{slope}\" }}\n\
             control = {{ kind = \"indentation\", path = [\"0\", \"{value}\", \"0\"] }}\n\
             output = {{ want = [\"path\"], digits = 12 }}\n"
        );
        let answer = solved(&scene, "");
        assert_eq!(answer["promise"]["path"], "certified", "{answer}");
        let events: Vec<&str> = answer["path"].as_array().unwrap().iter().filter_map(|e| e["event"].as_str()).collect();
        assert_eq!(events, ["start", "way-point", "end"]);
    }
}

/// Where the states at one value cannot be had beside an edge where g is infinite, the others have theirs.
#[test]
fn a_state_beside_an_edge_does_not_end_the_scene() {
    let scene = r#"
material = { e_star = 1, work_of_adhesion = 1e-3 }
control = { kind = "indentation" }
profile = { kind = "sum", term = [{ kind = "paraboloid", radius = "1" }, { kind = "elliptical-dimple", depth = "0.05", radius = "0.5" }] }
[output]
want = ["energy"]
equilibria.at = ["0.196", "-3"]
"#;
    let answer = solved(scene, "--digits 6");
    assert_eq!(answer["energy"][0]["states"][0]["status"], "ok", "{answer}");
    assert_eq!(answer["energy"][1]["status"], "undecided", "{answer}");
}
