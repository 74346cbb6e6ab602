//! `mdr solve` where a contact comes close to the radius at which its profile ends.
//!
//! On a sphere of radius R, or an ellipsoid of height c, g(a) = (c/R) a artanh(a/R) is infinite at R while its integral
//! is not. An equilibrium at d has a artanh(a/R) = (R/c)(d + √(2πaw/E*)), so 1 − a/R ≈ 2 exp(−2(d + Δl)/c), and as ∫₀ᴿ
//! g = cR/2 its force is 2E*(Rd − cR/2), with an error of the order of 1 − a/R. Numbers to more digits are from these
//! equations, solved for ln(1 − a/R) with 80 digits.

use serde_json::Value;

use crate::{events, number, solved};

fn near(value: &Value, expected: f64, error: f64) {
    let value = number(value);
    assert!((value - expected).abs() <= error * expected.abs(), "{value}, {expected}");
}

/// The stable states at all values, one each.
fn stable(answer: &Value) -> Vec<&Value> {
    let at = |value: &'_ Value| value["equilibria"].as_array().unwrap().len();
    assert!(answer["equilibria"].as_array().unwrap().iter().all(|value| at(value) > 0), "{answer}");
    let states = answer["equilibria"].as_array().unwrap().iter();
    states.flat_map(|value| value["equilibria"].as_array().unwrap()).filter(|state| state["stable"] == true).collect()
}

fn sphere(modulus: &str, radius: &str, control: &str, output: &str) -> String {
    format!(
        "material = {{ e_star = \"{modulus}\", work_of_adhesion = \"0.05\" }}\n\
         profile = {{ kind = \"sphere\", radius = \"{radius}\" }}\ncontrol = {{ {control} }}\n[output]\n{output}\n"
    )
}

/// A tip of 100 nm on a soft gel, under a dead load. At F = 0 its d is the mean of g, R/2; 1 − a/R = 1.5e-49.
#[test]
fn a_contact_that_ends_at_the_equator() {
    let control = "kind = \"force\", path = [\"-1e-9\", \"1e-12\", \"-1e-6\"], start = \"detached\"";
    let at = "equilibria.at = [0, \"1e-12\"]";
    let wanting = |want: &str| sphere("1e3", "1e-7", control, &format!("want = [{want}]\n{at}"));
    let gel = wanting("\"equilibria\", \"path\"");
    // F/2E*R + R/2.
    let [unloaded, loaded] = [5e-8, 5.5e-8];
    let states = |answer: &Value, radius: f64, error: f64| {
        let states = stable(answer);
        assert_eq!(states.len(), 2, "{answer}");
        for (state, depth) in states.iter().zip([unloaded, loaded]) {
            near(&state["contact_radius"], 1e-7, radius);
            near(&state["indentation"], depth, error);
        }
    };
    // In f64 the last number before R is some u away, and g there is 18 R.
    for (flags, radius, error) in [("--digits 20", 0.0, 1e-16), ("--f64", 4.0 * f64::EPSILON, 40.0 * f64::EPSILON)] {
        let answer = solved(&gel, flags);
        states(&answer, radius, error);
        assert_eq!(events(&answer), ["start", "jump-in", "way-point", "detached", "end"]);
        near(&answer["path"][1]["to_indentation"], unloaded, error);
        // Without a force, πwR² − E*∫(d − g)², and ∫₀¹ t² artanh²(t) dt = (π² + 12)/36.
        let lost = std::f64::consts::PI * 0.05 * 1e-14 - 1e-18 * (std::f64::consts::PI.powi(2) + 3.0) / 36.0;
        near(&answer["path"][1]["dissipated"], lost, error.max(1e-15));
        near(&answer["path"][2]["indentation"], loaded, error);
        near(&answer["path"][3]["contact_radius"], 9.938_793_770_642_438e-8, 1e-14);
        let certified = flags != "--f64";
        assert_eq!(answer["complete"]["path"]["proved"], certified, "{answer}");
        assert_eq!(answer["complete"]["equilibria"]["proved"], certified, "{answer}");
    }
    let answer = solved(&wanting("\"equilibria\""), "--digits 60");
    states(&answer, 0.0, 1e-16);
    assert_eq!(answer["complete"]["equilibria"]["proved"], true, "{answer}");
    let radius = &answer["equilibria"][0]["equilibria"][0]["contact_radius"];
    // 1e-7·(1 − 1.521950e-49).
    assert!(
        radius.as_str().unwrap().starts_with("9.9999999999999999999999999999999999999999999999984780499970"),
        "{radius}"
    );
}

/// Drawn at fixed grips, with 1 − a/R from 4e-49 to 5e-8.
#[test]
fn stable_states_before_the_equator() {
    let control = "kind = \"indentation\", path = [0, \"-1e-4\"]";
    let output = "want = [\"equilibria\", \"path\"]\nequilibria.at = [0, \"-1e-6\", \"-5e-6\", \"-9e-6\"]";
    let soft = [(1e-6, -1e-10), (1e-6, -3e-10), (1e-6, -1.1e-9), (1e-6, -1.9e-9)];
    let stiffer = [
        (9.999_999_999_999_992e-7, -9.999_999_999_999_707e-10),
        (9.999_999_999_999_94e-7, -2.999_999_999_999_783e-9),
        (9.999_999_999_822_73e-7, -1.099_999_999_935_386_6e-8),
        (9.999_999_471_564_328e-7, -1.899_999_807_390_077_3e-8),
    ];
    for (modulus, expected) in [("100", soft), ("1e3", stiffer)] {
        let scene = sphere(modulus, "1e-6", control, output);
        // A radius that is rounded to a double near R is off by u, and the force, at a given d, by g(R(1 − u))/R ≈ 18 times that.
        for (flags, error) in [("--digits 20", 1e-15), ("--f64", 40.0 * f64::EPSILON)] {
            let answer = solved(&scene, flags);
            let states = stable(&answer);
            assert_eq!(states.len(), 4, "{answer}");
            for (state, (radius, force)) in states.iter().zip(expected) {
                near(&state["contact_radius"], radius, 4.0 * f64::EPSILON);
                near(&state["force"], force, error);
            }
            assert_eq!(events(&answer), ["start", "detached", "end"], "{answer}");
            near(&answer["path"][0]["force"], expected[0].1, error);
        }
    }
}

/// A lens of height c: its fold is at 1 − a ≈ 1.26 c, and the stable states are so close to the equator, 1 − a = 10^(−4·10⁵)
/// and less for c = 1e-7, that no precision tells them from it.
#[test]
fn a_flat_ellipsoid_has_its_fold_at_the_equator() {
    let lens = |height: &str| {
        format!(
            "material = {{ e_star = 1, work_of_adhesion = \"0.1\" }}\n\
             profile = {{ kind = \"ellipsoid\", lateral = 1, height = \"{height}\" }}\n\
             control = {{ kind = \"indentation\" }}\n\
             output = {{ want = [\"folds\", \"equilibria\"], equilibria = {{ at = [0, \"-0.7\"] }} }}\n"
        )
    };
    for (height, fold, depth) in [
        ("1e-7", 1.261_568_740_471_625e-7, -0.792_664_580_576_867_4),
        ("1e-13", 1.261_566_261_014_758_3e-13, -0.792_665_459_519_632_5),
    ] {
        for flags in ["--digits 20", "--f64"] {
            let answer = solved(&lens(height), flags);
            let folds = answer["folds"].as_array().unwrap();
            assert_eq!(folds.len(), 1, "{answer}");
            near(&folds[0]["contact_radius"], 1.0 - fold, 2.0 * f64::EPSILON);
            near(&folds[0]["indentation"], depth, 4.0 * f64::EPSILON);
            let states = stable(&answer);
            assert_eq!(states.len(), 2, "{answer}");
            let height: f64 = height.parse().unwrap();
            near(&states[0]["force"], -height, 1e-14);
            near(&states[1]["force"], -1.4 - height, 1e-15);
            assert_eq!(answer["complete"]["folds"]["proved"], flags != "--f64");
        }
    }
    // In f64 no number is left between this fold and the equator: the list is not said to be all. Enclosures take more bits.
    let answer = solved(&lens("1e-40"), "--f64");
    assert!(answer["folds"].as_array().unwrap().is_empty());
    assert!(answer["complete"]["folds"]["why"].as_str().unwrap().contains("not resolved"), "{answer}");
    let answer = solved(&lens("1e-40"), "--digits 50");
    assert_eq!(
        answer["folds"][0]["contact_radius"], "0.99999999999999999999999999999999999999987384337390",
        "{answer}"
    );
    assert_eq!((stable(&answer).len(), &answer["complete"]["equilibria"]["proved"]), (2, &true.into()), "{answer}");
}

/// The paraboloid r²/2 up to r = 1 as a table: g = a² and d(1) = 1 − √(2π) < 0, so at d = 0 the contact grows when the table
/// ends; under a load, F(1) = 2(2/3 − √(2π)) < 0.
#[test]
fn a_contact_that_jumps_to_the_end_of_a_table() {
    let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("jumps-to-its-end.csv");
    let rows: String = (0..=10).map(|i| format!("{},{}\n", f64::from(i) / 10.0, f64::from(i * i) / 200.0)).collect();
    std::fs::write(&file, rows).unwrap();
    for control in ["indentation", "force"] {
        let scene = format!(
            "material = {{ e_star = 1, work_of_adhesion = 1 }}\n\
             profile = {{ kind = \"table\", file = \"{}\" }}\n\
             control = {{ kind = \"{control}\", path = [-1, 1], start = \"detached\" }}\noutput = {{ want = [\"path\"] }}\n",
            file.display()
        );
        for flags in ["--digits 12", "--f64"] {
            let answer = solved(&scene, flags);
            assert_eq!(events(&answer), ["start", "end-of-profile"], "{answer}");
            assert_eq!(number(&answer["path"][1][control]), 0.0, "{answer}");
        }
    }
}

/// A sphere as a formula: nothing is known of g at the radius where it ends, and no complete contact is claimed.
#[test]
fn a_formula_that_ends() {
    // 1 − a = 2 exp(−2·177).
    let scene = "material = { e_star = 1, work_of_adhesion = 5000 }
        profile = { kind = \"expression\", formula = \"1 - sqrt(1 - r^2)\" }
        control = { kind = \"indentation\", path = [-1, 1], start = \"detached\" }
        output = { want = [\"path\"] }\n";
    assert_eq!(events(&solved(scene, "--f64")), ["start", "undecided"]);
}
