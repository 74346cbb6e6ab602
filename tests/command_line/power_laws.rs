//! `mdr solve` and `mdr critical --f64` for power laws: what no double holds is answered, and never denied. Numbers that are
//! not derived are those of mpmath, at up to 3000 digits.

use serde_json::Value;

use crate::{critical, events, number, solved, text};

/// A power law under a control, with what is wanted.
fn scene([n, c, e_star, work]: [&str; 4], control: &str, output: &str) -> String {
    format!(
        "material = {{ e_star = \"{e_star}\", work_of_adhesion = \"{work}\" }}
        profile = {{ kind = \"power\", n = \"{n}\", c = \"{c}\" }}
        control = {{ {control} }}
        [output]\n{output}\n"
    )
}

fn list<'a>(answer: &'a Value, key: &str) -> &'a [Value] {
    answer[key].as_array().unwrap()
}

/// Radii of 10^−1298 and of 10^−416 m are as good as others, in each output and in each arithmetic.
#[test]
fn states_beyond_doubles_are_listed() {
    let tiny = scene(
        ["0.499", "0.1", "1", "1"],
        "kind = \"indentation\"",
        "want = [\"equilibria\", \"energy\"]\nequilibria.at = [\"1e-650\"]",
    );
    let answer = solved(&tiny, "--digits 20");
    let [small, large] = list(&answer["energy"][0], "states") else { panic!("{answer}") };
    assert_eq!(text(small, "contact_radius"), "1.0882060465616009772e-1298");
    assert_eq!(text(small, "force"), "-3.7240636660005222355e-1947");
    assert_eq!(text(large, "energy"), "1.4764448998851714378e-2566");
    assert_eq!(list(&answer["equilibria"][0], "equilibria").len(), 2);
    assert_eq!((&small["stable"], &large["stable"]), (&true.into(), &false.into()));

    let mixed = scene(
        ["0.01", "2.17026", "7.870928935834614", "1.2"],
        "kind = \"indentation\"",
        "want = [\"equilibria\", \"energy\", \"pressure\"]\nequilibria.at = [\"0.0001536684981\"]",
    );
    let answer = solved(&mixed, "--f64");
    for (key, states) in [("equilibria", "equilibria"), ("energy", "states")] {
        let [small, large] = list(&answer[key][0], states) else { panic!("{answer}") };
        assert_eq!((&small["contact_radius"], text(small, "status")), (&Value::Null, "underflow"));
        assert!((number(&small["log10_contact_radius"]) + 415.291_948_916_188).abs() < 1e-9, "{small}");
        assert!((number(&large["contact_radius"]) / 5.150_512_783_583_959 - 1.0).abs() < 4e-16, "{large}");
    }
    let pressure = &answer["pressure"][0];
    assert!(list(pressure, "states").len() == 2 || text(pressure, "status") == "undecided", "{pressure}");
}

/// A path can start from a stable state of 10^1281 m; its energies are also numbers.
#[test]
fn paths_start_at_any_scale() {
    let path = scene(["0.501", "0.1", "1", "1"], "kind = \"indentation\", path = [\"1\", \"-1\"]", "want = [\"path\"]");
    let answer = solved(&path, "");
    assert_eq!(events(&answer), ["start", "end"]);
    assert_eq!(text(&answer["path"][0], "contact_radius"), "1.9560581781383503412e+1281");
    // Between two depths so close F is one number to all digits: the work is F(d₂ − d₁).
    assert_eq!(text(&answer["path"][0], "force"), "-2.8894280804679615948e+1922");
    assert_eq!(text(&answer["balance"], "work"), "5.7788561609359231896e+1922");
    let answer = solved(&path, "--f64");
    assert!((number(&answer["path"][0]["log10_contact_radius"]) - 1_281.291_381_767_66).abs() < 1e-6, "{answer}");
}

/// Energies that nearly cancel keep their digits, however close the states are; those that cancel are 0, exactly.
#[test]
fn close_states_differ_in_energy() {
    let law = ["0.5664", "0.00892", "254.2", "1.013"];
    let machine = "kind = \"machine\", stiffness = \"129.2\", path = [\"0.58364\", \"0.50997\"]";
    let answer = solved(&scene(law, machine, "want = [\"path\"]"), "--digits 15");
    let balance = &answer["balance"];
    assert_eq!(text(balance, "stored"), "1512116453240.49");
    assert_eq!((text(balance, "work"), text(balance, "dissipated")), ("1512116453240.49", "0"));
    assert_eq!(answer["promise"]["path"], "certified");

    let ball = ["2", "50", "1e6", "0.05"];
    let close = "kind = \"force\", path = [\"1e-9\", \"1.0000000000000000000000000000001e-9\"]";
    let answer = solved(&scene(ball, close, "want = [\"path\"]"), "--digits 20");
    assert_eq!(text(&answer["balance"], "work"), "2.0154617300230360121e-52");

    let cycle = "kind = \"indentation\", path = [\"0\", \"1e-5\", \"0\"], start = \"detached\"";
    let answer = solved(&scene(ball, cycle, "want = [\"path\"]"), "");
    assert_eq!(events(&answer), ["start", "jump-in", "way-point", "end"]);
    assert_eq!(text(&answer["balance"], "work"), "0");
}

/// Another profile: two precisions that find the same zero do not agree on one. By the work of 10⁻⁴⁰ m under the force at 10⁻⁹ m.
#[test]
fn zeros_that_are_not_exact_are_no_agreement() {
    let scene = |path: &str| {
        format!(
            "material = {{ e_star = 1, work_of_adhesion = 1e-10 }}
            profile = {{ kind = \"hyperboloid\", slope = 1, lateral = 1 }}
            control = {{ kind = \"indentation\", path = [{path}] }}
            output = {{ want = [\"path\"] }}\n"
        )
    };
    let answer = solved(&scene("\"1e-9\", \"1.0000000000000000000000000000001e-9\""), "--digits 8");
    let (work, force) = (&answer["balance"]["work"], number(&answer["path"][0]["force"]));
    assert!((number(work) / (force * 1e-40) - 1.0).abs() < 1e-7, "{answer}");
    let answer = solved(&scene("\"1e-9\", \"1e-9\""), "--digits 8");
    assert_eq!(text(&answer["balance"], "stored"), "0");
}

/// Three folds on a machine, a jump from the first stable branch to the last, and the way back to none.
#[test]
fn paths_over_three_folds() {
    let machine = "kind = \"machine\", stiffness = \"1\", path = [\"-0.035\", \"0\", \"-4000\"], start = \"smallest\"";
    let answer = solved(&scene(["0.6", "2.4829", "1", "1"], machine, "want = [\"path\", \"folds\"]"), "--digits 15");
    assert_eq!(events(&answer), ["start", "jump", "way-point", "detached", "end"]);
    assert_eq!(list(&answer, "folds").len(), 3);
    let lost: Vec<&str> = [1, 3].iter().map(|&i| text(&answer["path"][i], "dissipated")).collect();
    assert_eq!(lost, ["214482.044267081", "4728073.94693028"]);
    assert_eq!(text(&answer["balance"], "stored"), "0.0000674119377134118");
}

/// A way point at the fold of a cone, d = −w/(E*C), is met exactly; so is the depth at which its force is least.
#[test]
fn exact_folds_are_decided() {
    let cone = "material = { e_star = 1, work_of_adhesion = 1 }
        profile = { kind = \"cone\", slope = \"0.1\" }
        control = { kind = \"indentation\", path = [\"0\", \"-10\", \"0\"] }
        [output]\nwant = [\"path\", \"energy\"]\nequilibria.at = [\"-10\", \"30\"]\n";
    let answer = solved(cone, "");
    assert_eq!(events(&answer), ["start", "way-point", "end"]);
    assert_eq!(text(&answer["balance"], "work"), "0");
    assert_eq!(answer["promise"]["path"], "certified");
    assert_eq!(text(&answer["energy"][0]["states"][0], "status"), "fold");
    assert_eq!(text(&answer["energy"][1]["states"][0], "stiffness"), "0");
}

/// n < 1/2: contact that shrinks to a point loses nothing.
#[test]
fn nothing_is_lost_at_a_point() {
    for control in ["indentation", "force"] {
        let control = format!("kind = \"{control}\", path = [\"1e-3\", \"-1\"], start = \"smallest\"");
        let answer = solved(&scene(["0.25", "1", "1e6", "0.05"], &control, "want = [\"path\"]"), "");
        assert_eq!(events(&answer), ["start", "detached", "end"]);
        assert_eq!(text(&answer["path"][1], "dissipated"), "0");
        assert_eq!(text(&answer["balance"], "dissipated"), "0");
    }
}

/// Exponents beyond those of any arithmetic have a logarithm, and what hardware holds is a number.
#[test]
fn critical_in_hardware_arithmetic_always_answers() {
    let far = critical("--n 0.49999999999999994 --c 1e70 --e-star 1 --work 1 --control force --f64");
    assert_eq!((text(&far, "status"), &far["contact_radius"]), ("overflow", &Value::Null));
    for (key, expected) in [
        ("contact_radius", 1.247_342_191_611_62e18),
        ("indentation", 6.236_710_958_058_1e17),
        ("force", 1.871_013_287_417_43e18),
    ] {
        assert!((number(&far[format!("log10_{key}")]) / expected - 1.0).abs() < 1e-14, "{far}");
    }
    let soft = "--n 3/2 --c 1 --e-star 1 --work 1 --control machine --stiffness";
    let near = critical(&format!("{soft} 1e-60 --f64"));
    assert!((number(&near["indentation"]) / -7.074_946_630_377_34e-61 - 1.0).abs() < 4e-16, "{near}");
    let near = critical(&format!("{soft} 1e-2600 --digits 20"));
    assert_eq!(text(&near, "indentation"), "-7.0749466303773385560e-2601");
}
