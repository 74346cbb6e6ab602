//! `mdr solve`: what an answer costs, and that digits are not withheld for the want of more of them.

use std::time::{Duration, Instant};

use serde_json::Value;

use crate::{mdr, number, solved};

fn near(value: &Value, expected: f64, error: f64) {
    assert!((number(value) / expected - 1.0).abs() < error, "{value}, {expected}");
}

/// A paraboloid of 1 m with waves, w/E* = 10⁻⁴ m.
fn waves(amplitude: f64, wavelength: f64, path: &[String], rest: &str) -> String {
    format!(
        "material = {{ e_star = 1, work_of_adhesion = 1e-4 }}
        profile = {{ kind = \"wavy-paraboloid\", radius = 1, amplitude = {amplitude:?}, wavelength = {wavelength:?} }}
        control = {{ kind = \"indentation\", path = {path:?} }}\n{rest}"
    )
}

/// Evaluations of anything, by output and arithmetic.
fn evaluations(scene: &str) -> usize {
    let assert = mdr("solve - --explain --digits 12").stdin(scene).assert().success();
    let text = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
    let counts = |line: &str| -> usize {
        let known = ["f64", "interval with slope", "interval"];
        let Some(rest) = known.iter().find_map(|name| Some(line.split_once(&format!("{name}  "))?.1)) else { return 0 };
        rest.split_whitespace().take(3).map(|count| count.parse::<usize>().unwrap()).sum()
    };
    text.lines().skip(1).map(counts).sum()
}

/// Waves that are steeper than the paraboloid up to 0.1 m, `count` of them: a fold costs the same among 35 and among 145 in
/// certified digits, the path over all of them and its energies included, and the search in f64 for where g turns.
#[test]
fn a_fold_costs_the_same_among_many() {
    let each = [(30.0, 35), (122.0, 145)].map(|(count, folds)| {
        let k = 10.0 * std::f64::consts::PI * count;
        let amplitude = 0.4 / (std::f64::consts::PI * k) / (0.2 * k / std::f64::consts::PI).sqrt();
        let scene =
            waves(amplitude, 0.2 / count, &["0".into(), "-1".into()], "output = { want = [\"folds\", \"path\"] }\n");
        evaluations(&scene) as f64 / f64::from(folds)
    });
    assert!(each[1] < 1.25 * each[0] && each[0] < 1000.0, "{each:?}");
}

/// A state that is proved is not searched again for the energies; of a profile whose g falls, its gap costs some hundred values of g.
#[test]
fn a_way_point_is_solved_once() {
    let cost = |scene: &dyn Fn(&[String]) -> String| {
        let costs = [20, 60].map(|points: i32| {
            let path: Vec<String> = (0..points).map(|i| format!("{}e-5", i % 40)).collect();
            evaluations(&scene(&path))
        });
        costs[1] - costs[0]
    };
    let wavy = cost(&|path| waves(5e-4, 0.1, path, "output = { want = [\"path\"] }\n"));
    let hyperboloid = cost(&|path| {
        format!(
            "material = {{ e_star = 1, work_of_adhesion = 1e-4 }}
            profile = {{ kind = \"hyperboloid\", lateral = 1, half_angle_degrees = 45 }}
            control = {{ kind = \"indentation\", path = {path:?} }}
            output = {{ want = [\"path\"] }}\n"
        )
    });
    assert!(hyperboloid < 40 * 60 && wavy < 40 * 160, "{hyperboloid}, {wavy}");
}

/// There is no equilibrium at −0.004 m, and no number of bits makes one.
#[test]
fn a_start_is_refused_at_once() {
    let rest = "output = { want = [\"path\"], digits = 300 }\n";
    let scene = waves(5e-4, 0.1, &["-0.004".into(), "0".into()], rest);
    let begin = Instant::now();
    let assert = mdr("solve -").stdin(scene).assert().code(2);
    let message = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
    assert!(message.contains("no stable equilibrium"), "{message}");
    assert!(begin.elapsed() < Duration::from_secs(30), "{:?}", begin.elapsed());
}

/// Beside its edge the pressure in a flat face is a nearly singular integral: by mpmath, ∫ g'(x)/√(x² − r²) dx in √(x − b).
#[test]
fn the_pressure_beside_an_edge() {
    let scene = "material = { e_star = 1, work_of_adhesion = 1e-4 }
        profile = { kind = \"truncated-paraboloid\", radius = 1, flat = 0.1 }
        control = { kind = \"indentation\" }
        [output]\nwant = [\"pressure\"]\nequilibria.at = [\"0\"]
        pressure.at = [\"0.09\", \"0.095\", \"0.099\", \"0.0999\"]\n";
    let truth =
        [0.014_725_994_376_906_321, 0.022_750_671_028_533_01, 0.045_950_795_122_535_614, 0.082_281_236_206_504_33];
    for (flags, error) in [("--digits 4", 1e-3), ("--digits 15", 1e-14), ("--f64", 1e-11)] {
        let answer = solved(scene, flags);
        let state = &answer["pressure"][0]["states"][0];
        for (point, truth) in state["pressure"].as_array().unwrap().iter().zip(truth) {
            near(&point["pressure"], truth, error);
        }
    }
}

/// Figure 4 as a formula whose heights cancel at the tip has the energies of the closed form.
#[test]
fn the_energies_of_a_formula() {
    let formula = "material = { e_star = 1, work_of_adhesion = 1e-4 }
        profile = { kind = \"expression\", formula = \"r^2/2 + 5e-4*(1 - cos(20*pi*r))\" }
        control = { kind = \"indentation\", path = [\"0\", \"-0.01\"] }
        output = { want = [\"path\"] }\n";
    let closed = waves(5e-4, 0.1, &["0".into(), "-0.01".into()], "output = { want = [\"path\"] }\n");
    for (flags, error) in [("--digits 8", 1e-7), ("--f64", 1e-10)] {
        let [formula, closed] = [formula, &closed].map(|scene| solved(scene, flags));
        for event in [1, 2] {
            near(&formula["path"][event]["dissipated"], number(&closed["path"][event]["dissipated"]), error);
        }
        for key in ["work", "dissipated", "stored"] {
            near(&formula["balance"][key], number(&closed["balance"][key]), error);
        }
    }
}

/// exp(100 r) − 1 has four digits fewer than the arithmetic at the radii of its contact, and more than were asked for.
#[test]
fn a_formula_that_cancels() {
    let scene = "material = { e_star = 1, work_of_adhesion = 1e-4 }
        profile = { kind = \"expression\", formula = \"exp(100*r) - 1\" }
        control = { kind = \"force\" }
        [output]\nwant = [\"equilibria\"]\nequilibria.at = [\"0\"]\n";
    for (flags, error) in [("--digits 8", 1e-7), ("--digits 12", 1e-11), ("--f64", 1e-13)] {
        let answer = solved(scene, flags);
        let states = answer["equilibria"][0]["equilibria"].as_array().unwrap();
        assert!(
            states
                .iter()
                .any(|state| (number(&state["contact_radius"]) / 1.018_574_022_603_860_7e-7 - 1.0).abs() < error),
            "{answer}"
        );
    }
}
