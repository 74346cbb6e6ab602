//! `mdr solve`: what cannot be had is a status of its own field, and the rest of the answer stands.

use serde_json::Value;

use crate::mdr;

/// The answer to a scene from standard input.
fn solve(scene: &str, flags: &str) -> Value {
    let assert = mdr(&format!("solve - {flags} --format json")).stdin(scene).assert().success().stderr_eq("");
    serde_json::from_slice(&assert.get_output().stdout).unwrap()
}

/// A number, written as text or not.
fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| value.as_str().unwrap_or_else(|| panic!("{value}")).parse().unwrap())
}

fn near(value: &Value, expected: f64, error: f64) {
    assert!((number(value) / expected - 1.0).abs() < error, "{value}, {expected}");
}

/// At −10⁹ m an equilibrium lies closer to the edge of the dimple, where g is −∞, than any precision tells. The one at −0.02
/// is the zero of −ha artanh(a/b)/b − Δl − d, found in another program.
#[test]
fn one_value_does_not_take_the_others_along() {
    let scene = "material = { e_star = 1, work_of_adhesion = 1e-3 }
        profile = { kind = \"elliptical-dimple\", depth = 0.01, radius = 1 }
        control = { kind = \"indentation\" }
        [output]\nwant = [\"equilibria\", \"energy\"]\nequilibria.at = [\"-0.02\", \"-1e9\", \"0\"]\n";
    for (flags, error) in [("--digits 10", 1e-10), ("--f64", 1e-14)] {
        let answer = solve(scene, flags);
        let at = |key: &str, i: usize| answer[key][i].clone();
        let [known, open, none] = [0, 1, 2].map(|i| at("equilibria", i));
        near(&known["equilibria"][0]["contact_radius"], 0.063405950180268132, error);
        assert_eq!(open["status"], "undecided", "{answer}");
        assert!(open["why"].as_str().unwrap().contains("where g is infinite"), "{answer}");
        assert_eq!(none["status"], "no-equilibrium", "{answer}");
        near(&at("energy", 0)["states"][0]["contact_radius"], 0.063405950180268132, error);
        assert_eq!(at("energy", 1)["status"], "undecided", "{answer}");
    }
}

/// A punch so sharp that a fold lies 10⁻⁹ of its radius beside the kink: Π(a, d) = E*∫(d − g)² − πa²w between the states, by a
/// quadrature in √(x − b) in another program.
#[test]
fn energies_beside_a_kink() {
    let scene = |path: &str| {
        format!(
            "material = {{ e_star = 15.8e9, work_of_adhesion = 318.1 }}
            profile = {{ kind = \"rounded-punch\", radius = 0.00103, flat = 0.0242 }}
            control = {{ kind = \"indentation\", path = [{path}], start = \"detached\" }}
            output = {{ want = [\"path\"] }}\n"
        )
    };
    let (lost, stored) = (0.587187062365681838, 3.239249186513938672);
    for (flags, error) in [("--digits 17", 1e-15), ("--f64", 1e-12)] {
        let answer = solve(&scene("\"-1e-4\", \"1e-4\""), flags);
        near(&answer["path"][1]["dissipated"], lost, error);
        near(&answer["balance"]["stored"], stored, error);
        near(&answer["balance"]["work"], lost + stored, error);
        // A way point given twice is one, and the path is as certain.
        let twice = solve(&scene("\"-1e-4\", \"-1e-4\", \"1e-4\", \"1e-4\""), flags);
        let events: Vec<_> = twice["path"].as_array().unwrap().iter().map(|event| event["event"].clone()).collect();
        assert_eq!(events, ["start", "way-point", "jump-in", "way-point", "end"], "{twice}");
        assert_eq!((&twice["promise"], &twice["complete"]), (&answer["promise"], &answer["complete"]));
        assert_eq!((&twice["path"][2], &twice["balance"]), (&answer["path"][1], &answer["balance"]));
    }
}

/// At lengths of 10⁻²⁰² m the products of lengths are out of range, and the energies are not. They are those of a sphere of
/// 1 m with w/E* = 10⁻³ m, times E*R³.
#[test]
fn energies_of_small_lengths() {
    let scene = |modulus: &str, work: &str, radius: &str, end: &str| {
        format!(
            "material = {{ e_star = \"{modulus}\", work_of_adhesion = \"{work}\" }}
            profile = {{ kind = \"sphere\", radius = \"{radius}\" }}
            control = {{ kind = \"indentation\", path = [0, \"{end}\"] }}
            output = {{ want = [\"path\"] }}\n"
        )
    };
    let plain = solve(&scene("1", "1e-4", "1", "-1e-2"), "--digits 17");
    for (modulus, work, radius, end, scale) in
        [("1e300", "1e96", "1e-200", "-1e-202", 1e-300), ("1e50", "1e-64", "1e-110", "-1e-112", 1e-280)]
    {
        let answer = solve(&scene(modulus, work, radius, end), "--f64");
        for (small, one) in [
            (&answer["path"][1]["dissipated"], &plain["path"][1]["dissipated"]),
            (&answer["balance"]["work"], &plain["balance"]["work"]),
        ] {
            assert_eq!(answer["path"][1]["status"], "ok");
            near(small, number(one) * scale, 1e-13);
        }
    }
}

/// To and fro the work of the control is zero: a sum of energies that does not know it says so, and leaves no hole.
#[test]
fn a_work_of_nothing() {
    let scene = "material = { e_star = 1, work_of_adhesion = 1e-3 }
        profile = { kind = \"sphere\", radius = 1 }
        control = { kind = \"indentation\", path = [0, 0.2, 0], start = \"detached\" }
        output = { want = [\"path\"] }\n";
    for flags in ["", "--f64"] {
        let answer = solve(scene, flags);
        assert!(answer["balance"]["work"].is_null() && answer["balance"]["status"] == "undecided", "{answer}");
        let assert = mdr(&format!("solve - {flags}")).stdin(scene).assert().success();
        let text = String::from_utf8(assert.get_output().stdout.clone()).unwrap();
        assert!(text.contains("work of the control undecided (zero up to the rounding"), "{text}");
    }
}
