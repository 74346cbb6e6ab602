//! `mdr solve`: what cannot be had is a status of its own field, and the rest of the answer stands.

use serde_json::Value;

use crate::{mdr, number, solved};

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
        let answer = solved(scene, flags);
        let at = |key: &str, i: usize| answer[key][i].clone();
        let [known, open, none] = [0, 1, 2].map(|i| at("equilibria", i));
        near(&known["equilibria"][0]["contact_radius"], 0.063_405_950_180_268_13, error);
        assert_eq!(open["status"], "undecided", "{answer}");
        assert!(open["why"].as_str().unwrap().contains("where g is infinite"), "{answer}");
        assert_eq!(none["status"], "no-equilibrium", "{answer}");
        near(&at("energy", 0)["states"][0]["contact_radius"], 0.063_405_950_180_268_13, error);
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
    let (lost, stored) = (0.587_187_062_365_681_8, 3.239_249_186_513_938_7);
    for (flags, error) in [("--digits 17", 1e-15), ("--f64", 1e-12)] {
        let answer = solved(&scene("\"-1e-4\", \"1e-4\""), flags);
        near(&answer["path"][1]["dissipated"], lost, error);
        near(&answer["balance"]["stored"], stored, error);
        near(&answer["balance"]["work"], lost + stored, error);
        // A way point given twice is one, and the path is as certain.
        let twice = solved(&scene("\"-1e-4\", \"-1e-4\", \"1e-4\", \"1e-4\""), flags);
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
    let plain = solved(&scene("1", "1e-4", "1", "-1e-2"), "--digits 17");
    for (modulus, work, radius, end, scale) in
        [("1e300", "1e96", "1e-200", "-1e-202", 1e-300), ("1e50", "1e-64", "1e-110", "-1e-112", 1e-280)]
    {
        let answer = solved(&scene(modulus, work, radius, end), "--f64");
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
        let answer = solved(scene, flags);
        assert!(answer["balance"]["work"].is_null() && answer["balance"]["status"] == "undecided", "{answer}");
        let assert = mdr(&format!("solve - {flags}")).stdin(scene).assert().success();
        let text = String::from_utf8(assert.get_output().stdout.clone()).unwrap();
        assert!(text.contains("work of the control undecided (") && text.contains("zero"), "{text}");
    }
}

/// A contact of 10⁻³⁰⁰ m has forces of 10⁻⁶⁰⁴ N, which the search for its states in f64 does not need: its lengths are those of
/// figure 4 times 10⁻³⁰⁰.
#[test]
fn forces_that_no_double_holds() {
    let scene = |scale: &str, work: &str| {
        format!(
            "material = {{ e_star = 1, work_of_adhesion = \"{work}\" }}
            profile = {{ kind = \"wavy-paraboloid\", radius = \"1e{scale}\", amplitude = \"5e-4e{scale}\", wavelength = \"0.1e{scale}\" }}
            control = {{ kind = \"indentation\", path = [0, \"-0.01e{scale}\"] }}
            output = {{ want = [\"folds\", \"path\"] }}\n"
        )
        .replace("5e-4e-300", "5e-304")
        .replace("5e-4e0", "5e-4")
    };
    let plain = solved(&scene("0", "1e-4"), "--digits 12");
    let small = solved(&scene("-300", "1e-304"), "--digits 12");
    assert_eq!((plain["folds"].as_array().unwrap().len(), &small["promise"]), (3, &plain["promise"]));
    for list in ["folds", "path"] {
        let pairs = small[list].as_array().unwrap().iter().zip(plain[list].as_array().unwrap());
        for (small, plain) in pairs {
            assert_eq!(
                (&small["status"], &small["event"], &small["kind"]),
                (&plain["status"], &plain["event"], &plain["kind"])
            );
            for key in ["contact_radius", "to_contact_radius"] {
                if !plain[key].is_null() {
                    near(&small[key], number(&plain[key]) * 1e-300, 2e-12);
                }
            }
            assert_eq!(small["dissipated"].is_null(), plain["dissipated"].is_null());
        }
    }
}

/// With a range the list is that of the range, and says so. Without it there are two equilibria at −0.01: the zeros of
/// a² − √(2πaw) + 0.01, of which one is below 0.1.
#[test]
fn equilibria_of_a_range() {
    let scene = |range: &str| {
        format!(
            "material = {{ e_star = 1, work_of_adhesion = 1e-3 }}
            profile = {{ kind = \"sum\", term = [{{ kind = \"paraboloid\", radius = 1 }}] }}
            control = {{ kind = \"indentation\" }}
            [output]\nwant = [\"equilibria\"]\nequilibria.at = [\"-0.01\"]\n{range}\n"
        )
    };
    let radii = |answer: &Value| -> Vec<f64> {
        let states = answer["equilibria"][0]["equilibria"].as_array().unwrap();
        states.iter().map(|state| number(&state["contact_radius"])).collect()
    };
    let is_zero = |a: &f64| (a * a - (2e-3 * std::f64::consts::PI * a).sqrt() + 0.01).abs() < 1e-15;
    let all = radii(&solved(&scene(""), ""));
    assert!(all.len() == 2 && all.iter().all(is_zero), "{all:?}");
    let part = solved(&scene("folds.range = [\"1e-3\", \"0.1\"]"), "");
    assert_eq!(radii(&part), all[..1]);
    assert!(part["complete"]["equilibria"]["why"].as_str().unwrap().ends_with("other radii are not listed"), "{part}");
    for range in ["folds.range = [\"10\", \"100\"]", "folds.range = [\"1e-9\", \"1e-5\"]"] {
        let none = solved(&scene(range), "");
        let record = &none["equilibria"][0];
        assert_eq!(
            (&record["status"], &none["complete"]["equilibria"]["proved"]),
            (&"no-equilibrium".into(), &true.into())
        );
        assert!(record["why"].as_str().unwrap().contains("within the range from"), "{none}");
        let assert = mdr("solve -").stdin(scene(range)).assert().success();
        let text = String::from_utf8(assert.get_output().stdout.clone()).unwrap();
        assert!(text.contains("no-equilibrium within the range"), "{text}");
    }
}

/// A table in nanometres is converted, and the answer says so; one in metres has no note.
#[test]
fn a_table_in_other_units_has_a_note() {
    let solve_table = |name: &str, text: &str| {
        let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        std::fs::write(&file, text).unwrap();
        let scene = format!(
            "material = {{ e_star = 1, work_of_adhesion = 1e-10 }}
            profile = {{ kind = \"table\", file = \"{}\" }}
            control = {{ kind = \"indentation\" }}
            [output]\nwant = [\"transform\"]\ntransform.at = [\"2e-9\"]\n",
            file.display()
        );
        let text = mdr("solve - --f64").stdin(scene.as_str()).assert().success();
        (solved(&scene, "--f64"), String::from_utf8(text.get_output().stdout.clone()).unwrap())
    };
    let (nano, text) = solve_table("nano.csv", "r,f\nnm,um\n1,1e-3\n2,2e-3\n3,3e-3\n4,4e-3\n");
    let (metres, plain) = solve_table("metres.csv", "r,f\nm,m\n1e-9,1e-9\n2e-9,2e-9\n3e-9,3e-9\n4e-9,4e-9\n");
    assert_eq!(nano["transform"], metres["transform"]);
    let note = nano["notes"][0].as_str().unwrap();
    assert!(note.contains("r in nm and f in um") && text.contains(&format!("Note: {note}.")), "{note}, {text}");
    assert!(metres.get("notes").is_none() && !plain.contains("Note"), "{metres}");
}

/// Whether folds lie far outside the rows of a table, where it is not known, is not asked again and again with more bits: the
/// path is answered without that proof.
#[test]
fn an_open_question_is_not_asked_for_ever() {
    let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("cap.csv");
    // The rows of a sphere of 1 m, to eight decimals.
    let row = |i: u32| {
        let r = 0.05 * f64::from(i);
        format!("{r:.2},{:.8}\n", 1.0 - (1.0 - r * r).sqrt())
    };
    std::fs::write(&file, (0..20).map(row).fold("r,f\n".to_owned(), |text, row| text + &row)).unwrap();
    let scene = format!(
        "material = {{ e_star = 1, work_of_adhesion = 1e-3 }}
        profile = {{ kind = \"table\", file = \"{}\" }}
        control = {{ kind = \"indentation\", path = [\"0.2\", \"-0.1\"] }}
        output = {{ want = [\"path\"] }}\n",
        file.display()
    );
    let assert = mdr("solve - --digits 20 --explain").stdin(scene).assert().success();
    let costs = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
    let enclosures = costs.lines().find_map(|line| line.trim().strip_prefix("interval  ")).unwrap();
    let slopes: usize = enclosures.split_whitespace().nth(1).unwrap().parse().unwrap();
    // Eight precisions of 512 cells; with all twelve it would be more than 6000.
    assert!(slopes < 5000, "{costs}");
}

fn on_rubber(profile: &str, work: &str, output: &str) -> String {
    format!(
        "profile = {profile}\nmaterial = {{ e_star = 1, work_of_adhesion = {work} }}\ncontrol.kind = \"force\"\noutput = {output}"
    )
}

/// Edges that are a few roundings apart leave a gap in the proof: an empty list is no claim, and one with folds may lack some.
#[test]
fn a_list_that_is_undecided_says_so_in_its_heading() {
    let sum = |edge: &str, work: &str| {
        let term = |flat: &str| format!("{{ kind = \"truncated-cone\", flat = \"{flat}\", slope = \"0.1\" }}");
        let sum = format!("{{ kind = \"sum\", term = [{}, {}] }}", term("0.05"), term(edge));
        on_rubber(&sum, work, "{ want = [\"folds\"] }")
    };
    let table = |scene: &str| {
        let assert = mdr("solve -").stdin(scene).assert().success();
        String::from_utf8(assert.get_output().stdout.clone()).unwrap()
    };
    for edge in ["0.05000000000000001", "0.050000000000003", "0.0500000000001"] {
        let scene = sum(edge, "1e-6");
        let (answer, table) = (solved(&scene, ""), table(&scene));
        let complete = &answer["complete"]["folds"];
        assert_eq!(complete["undecided"] == true, complete["proved"] == false, "{answer}");
        let is_empty = answer["folds"].as_array().unwrap().is_empty();
        let heading = if is_empty {
            "\nfolds (undecided)\n\n none found\n"
        } else {
            "\nfolds (certified; undecided whether all)\n"
        };
        assert!(complete["proved"] == true || table.contains(heading), "{table}");
    }
    assert!(table(&sum("0.05000000000001", "1e-6")).contains("\nfolds (undecided)\n\n none found\n"));
    assert!(table(&sum("0.05000000000001", "1e-3")).contains("\nfolds (certified; undecided whether all)\n"));
    let apart = solved(&sum("0.06", "1e-6"), "");
    assert!(apart["complete"]["folds"].get("undecided").is_none(), "{apart}");
}

/// At a kink the pressure is not enclosed: this number alone is a double, or infinite where the slope jumps.
#[test]
fn one_pressure_at_a_kink_does_not_take_the_others_along() {
    let wants = "{ want = [\"pressure\"], equilibria.at = [\"1e-2\"], pressure.at = [\"0.05\", \"0.06\"] }";
    let scene = |f: &str| on_rubber(&format!("{{ kind = \"expression\", formula = \"{f}\" }}"), "1e-3", wants);
    let smooth = scene("r^2/2+0.1*max(r-0.05,0)^2");
    let answer = solved(&smooth, "--digits 12");
    assert_eq!(answer["promise"]["pressure"], "certified");
    let samples = &answer["pressure"][0]["states"][0]["pressure"];
    assert_eq!((&samples[0]["promise"], &samples[0]["status"]), (&"f64".into(), &"ok".into()), "{samples}");
    assert!((number(&samples[0]["pressure"]) / 0.147_996_705_805_038 - 1.0).abs() < 1e-11, "{samples}");
    assert!(samples[1].get("promise").is_none() && samples[1]["status"] == "ok", "{samples}");
    let csv = mdr("solve - --digits 12 --format csv").stdin(smooth).assert().success();
    let csv = String::from_utf8(csv.get_output().stdout.clone()).unwrap();
    let promises: Vec<_> = csv.lines().map(|line| line.split(',').nth(1).unwrap()).collect();
    assert_eq!(promises, ["promise", "f64", "certified"], "{csv}");

    let answer = solved(&scene("r^2/2+0.1*max(r-0.05,0)"), "--digits 12");
    assert_eq!(answer["promise"]["pressure"], "certified");
    let samples = &answer["pressure"][0]["states"][0]["pressure"];
    assert_eq!((&samples[0]["status"], &samples[1]["status"]), (&"domain-error".into(), &"ok".into()), "{samples}");
}
