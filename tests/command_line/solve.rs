//! `mdr solve`.

use serde_json::Value;

use crate::{mdr, number, output, root};

/// The answer to a scene of the examples.
fn solve(scene: &str, flags: &str) -> Value {
    let text = output(&format!("solve examples/scenes/{scene}.toml {flags} --format json"));
    assert_eq!(text.lines().count(), 1, "one object, one line");
    serde_json::from_str(&text).unwrap()
}

/// The jumps of figure 4: 0.0645 → 0.0474 at d ≈ −0.00185, and the end at 0.0189, d ≈ −0.00249.
#[test]
fn the_folds_of_figure_4_are_proved() {
    let answer = solve("figure-4", "");
    assert_eq!(answer["schema"], "mdr.solve/1");
    assert_eq!(answer["promise"]["folds"], "certified");
    assert_eq!(answer["complete"]["folds"]["proved"], true);
    let folds = answer["folds"].as_array().unwrap();
    let read = |fold: &Value, key: &str| number(&fold[key]);
    let found: Vec<_> = folds
        .iter()
        .map(|fold| (read(fold, "contact_radius"), read(fold, "indentation"), fold["kind"].as_str().unwrap()))
        .collect();
    let [(end, end_depth, "minimum"), (_, _, "maximum"), (jump, jump_depth, "minimum")] = found[..] else {
        panic!("{found:?}")
    };
    assert!((end - 0.0189).abs() < 5e-5 && (end_depth + 0.00249).abs() < 5e-6, "{found:?}");
    assert!((jump - 0.0645).abs() < 5e-5 && (jump_depth + 0.00185).abs() < 5e-6, "{found:?}");
    assert!(folds.iter().all(|fold| fold["status"] == "ok"));
}

/// The whole sequence, in both arithmetics.
#[test]
fn the_path_of_figure_4() {
    for flags in ["", "--f64"] {
        let answer = solve("figure-4", flags);
        let events = answer["path"].as_array().unwrap();
        let names: Vec<_> = events.iter().map(|event| event["event"].as_str().unwrap()).collect();
        assert_eq!(names, ["start", "jump", "detached", "end"]);
        let read = |event: usize, key: &str| number(&events[event][key]);
        let near = |value: f64, expected: f64| assert!((value - expected).abs() < 5e-5, "{value}, {expected}");
        near(read(0, "contact_radius"), 0.0926);
        near(read(1, "contact_radius"), 0.0645);
        near(read(1, "to_contact_radius"), 0.0474);
        near(read(2, "contact_radius"), 0.0189);
        assert!(read(1, "dissipated") > 0.0 && read(2, "dissipated") > 0.0);
        // work − dissipated = stored, three integrals of their own.
        let balance = |key: &str| number(&answer["balance"][key]);
        let residual = balance("work") - balance("dissipated") - balance("stored");
        assert!(residual.abs() < 1e-12 * balance("work"), "{residual}");
        assert!(events[2]["to_contact_radius"].is_null() && read(2, "to_force") == 0.0);
    }
}

/// Every scene of the folder is refused with the message beside it (SNAPSHOTS=overwrite writes it anew).
#[test]
fn bad_scenes_are_refused_with_file_line_and_key() {
    let folder = root().join("tests/command_line/bad_scenes");
    let mut scenes: Vec<_> = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    scenes.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    assert!(scenes.len() >= 40, "{}", scenes.len());
    for scene in scenes {
        let name = scene.file_stem().unwrap().to_str().unwrap();
        let expected = snapbox::Data::read_from(&scene.with_extension("stderr"), None);
        mdr("")
            .args(["solve", &format!("{name}.toml")])
            .current_dir(&folder)
            .assert()
            .code(2)
            .stdout_eq("")
            .stderr_eq(expected);
    }
}

/// The answer to a scene from standard input.
fn solve_text(scene: &str, flags: &str) -> Value {
    let assert = mdr(&format!("solve - {flags} --format json")).stdin(scene).assert().success().stderr_eq("");
    serde_json::from_slice(&assert.get_output().stdout).unwrap()
}

/// A path that starts exactly at a fold rests there, and its fields are those of the fold.
#[test]
fn a_start_at_a_fold_has_fields() {
    let (a, d) =
        (f64::cbrt(std::f64::consts::PI * 1e-3 / 8.0), -3.0 * f64::cbrt(std::f64::consts::PI * 1e-3 / 8.0).powi(2));
    let scene = |path: f64| {
        format!(
            "material = {{ e_star = 1, work_of_adhesion = 1e-3 }}\nprofile = {{ kind = \"paraboloid\", radius = 1 }}\n\
             control = {{ kind = \"indentation\", path = [{path:e}, 0] }}\noutput = {{ want = [\"energy\", \"path\"] }}\n"
        )
    };
    let states = |path: f64| solve_text(&scene(path), "--f64")["energy"][0]["states"].as_array().unwrap().clone();
    let at_fold = states(d);
    assert_eq!(at_fold.len(), 1, "{at_fold:?}");
    assert!((number(&at_fold[0]["contact_radius"]) / a - 1.0).abs() < 1e-14, "{at_fold:?}");
    // Π at the fold: E*∫(d − x²)² dx − πa²w with d = −3a² and πw = 8a³.
    let energy = a.powi(5) * (9.0 + 2.0 + 0.2 - 8.0);
    assert!((number(&at_fold[0]["energy"]) / energy - 1.0).abs() < 1e-13, "{at_fold:?} {energy}");
    assert_eq!(solve_text(&scene(d), "--f64")["path"][0]["event"], "start");
}

/// Short tables are proved, and the cubic through points of a paraboloid is the paraboloid: every digit is that of the
/// closed form. Longer ones are searched, and the answer says so.
#[test]
fn folds_of_short_tables_are_proved() {
    let scene = |profile: &str, want: &str| {
        format!(
            "material = {{ e_star = 1, work_of_adhesion = 1e-3 }}\nprofile = {{ {profile} }}\n\
             control = {{ kind = \"indentation\", path = [0, -1] }}\n\
             output = {{ want = [{want}], equilibria = {{ at = [-0.01, 0.001] }} }}\n"
        )
    };
    let all = "\"folds\", \"equilibria\", \"path\"";
    let table = |name: &str, rows: u32, want: &str| {
        let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        // r²/2 up to r = 0.3, exactly.
        let row = |i: u32| format!("{}/{},{}/{}\n", 3 * i, 10 * rows, 9 * i * i, 200 * rows * rows);
        let text = (0..=rows).map(row).fold("r,f\nm,m\n".to_owned(), |text, row| text + &row);
        std::fs::write(&file, text).unwrap();
        solve_text(&scene(&format!("kind = \"table\", file = \"{}\"", file.display()), want), "--digits 20")
    };
    let closed = solve_text(&scene("kind = \"paraboloid\", radius = 1", all), "--digits 20");
    let short = table("short.csv", 15, all);
    for want in ["folds", "equilibria", "path"] {
        assert_eq!(short["promise"][want], "certified");
        assert_eq!(short["complete"][want]["proved"], true, "{}", short["complete"]);
        assert_eq!(short[want], closed[want]);
    }
    let long = table("long.csv", 1000, "\"folds\"");
    assert_eq!(long["promise"]["folds"], "f64");
    let why = long["complete"]["folds"]["why"].as_str().unwrap();
    assert!(why.ends_with("tables are proved up to 1000 rows, this has 1001"), "{why}");
    for name in ["contact_radius", "indentation", "force"] {
        let [found, exact] = [&long, &closed].map(|answer| number(&answer["folds"][0][name]));
        assert!((found / exact - 1.0).abs() < 1e-12, "{name}: {found}");
    }
}

const DEEP_WAVES: &str = r#"
material = { e_star = 1, work_of_adhesion = 1e-6 }
profile = { kind = "wavy-paraboloid", radius = 1, amplitude = 0.01, wavelength = 0.1 }
control = { kind = "indentation" }
[output]
want = ["gap", "equilibria", "pressure"]
equilibria.at = ["0.01"]
gap.at = ["0.01", "0.5"]
pressure.at = ["0", "0.5"]
"#;

/// On waves that are deep against their length the contact of the first crest alone is no simply connected contact: the
/// surfaces overlap at the next one.
#[test]
fn interpenetration_is_not_hidden() {
    for flags in ["--f64", "--digits 12"] {
        let answer = solve_text(DEEP_WAVES, flags);
        let states = answer["gap"][0]["states"].as_array().unwrap();
        let outside: Vec<_> = states.iter().filter(|state| state["status"] == "not-admissible").collect();
        assert!(!outside.is_empty(), "{answer}");
        for state in &outside {
            let point = &state["interpenetration"][0];
            assert!(number(&point["gap"]) < 0.0 && number(&point["r"]) > number(&state["contact_radius"]), "{state}");
        }
        // A radius inside the contact has no gap, one outside no pressure.
        for (state, key) in states
            .iter()
            .map(|s| (s, "gap"))
            .chain(answer["pressure"][0]["states"].as_array().unwrap().iter().map(|state| (state, "pressure")))
        {
            let a = number(&state["contact_radius"]);
            for point in state[key].as_array().unwrap() {
                let inside = number(&point["r"]) < a;
                assert_eq!(point["status"] == "ok", inside == (key == "pressure"), "{state}");
                assert_eq!(point[key].is_null(), point["status"] == "domain-error", "{point}");
            }
        }
    }
}

#[test]
fn a_value_without_equilibrium_is_no_error() {
    let scene = DEEP_WAVES.replace("equilibria.at = [\"0.01\"]", "equilibria.at = [\"-10\"]");
    for flags in ["--f64", ""] {
        let answer = solve_text(&scene, flags);
        for (output, key) in [("equilibria", "equilibria"), ("gap", "states"), ("pressure", "states")] {
            assert_eq!(answer[output][0]["status"], "no-equilibrium", "{answer}");
            assert_eq!(answer[output][0][key].as_array().unwrap().len(), 0, "{answer}");
        }
    }
}

/// Folds and equilibria do not depend on the unit of force, however far it is out of the range of hardware.
#[test]
fn moduli_beyond_hardware() {
    let scene = |modulus: &str, work: &str| {
        format!(
            "material = {{ e_star = \"{modulus}\", work_of_adhesion = \"{work}\" }}
            profile = {{ kind = \"sphere\", radius = 1 }}
            control = {{ kind = \"indentation\" }}
            [output]\nwant = [\"folds\", \"equilibria\", \"energy\"]\nequilibria.at = [\"0.01\"]\n"
        )
    };
    let plain = solve_text(&scene("1", "1e-3"), "");
    let beyond = solve_text(&scene("1e600", "1e597"), "");
    let digits = |answer: &Value, pointer: &str| answer.pointer(pointer).unwrap().as_str().unwrap().to_owned();
    for pointer in ["/folds/0/contact_radius", "/folds/0/indentation", "/equilibria/0/equilibria/0/contact_radius"] {
        assert_eq!(digits(&plain, pointer), digits(&beyond, pointer));
    }
    // The mantissa is the same, the exponent 600 more.
    for pointer in ["/folds/0/force", "/energy/0/states/0/energy"] {
        let (near, far) = (digits(&plain, pointer), digits(&beyond, pointer));
        let significant =
            |text: &str| text.split('e').next().unwrap().replace(['-', '.'], "").trim_start_matches('0').to_owned();
        assert_eq!(significant(&near), significant(&far));
        assert!(far.contains("e+59"), "{far}");
    }
}

/// What no double holds is marked, with log10; the rest is there.
#[test]
fn results_beyond_hardware() {
    let scene = "material = { e_star = 1e300, work_of_adhesion = 1e297 }
        profile = { kind = \"sphere\", radius = 1e12 }
        control = { kind = \"indentation\" }
        [output]\nwant = [\"folds\", \"transform\"]\ntransform.at = [\"1e-200\", \"1\"]\n";
    let answer = solve_text(scene, "--f64");
    let fold = &answer["folds"][0];
    assert_eq!((&fold["status"], &fold["force"]), (&"overflow".into(), &Value::Null), "{answer}");
    // Close to the pull-off force of a paraboloid at fixed grips, (5/6)πwR.
    let expected = (5.0 / 6.0 * std::f64::consts::PI).log10() + 309.0;
    assert!((number(&fold["log10_force"]) - expected).abs() < 1e-3, "{answer}");
    assert!(fold["contact_radius"].is_f64() && fold["indentation"].is_f64());
    let tip = &answer["transform"][0];
    assert_eq!((&tip["status"], &tip["g"]), (&"underflow".into(), &Value::Null), "{answer}");
    assert!((number(&tip["log10_g"]) + 412.0).abs() < 1e-9 && (number(&tip["slope"]) / 2e-212 - 1.0).abs() < 1e-12);
    assert_eq!(answer["transform"][1]["status"], "ok");
    assert_eq!(answer["promise"]["folds"], "f64");
}

/// A path is told even where the energy that a jump loses cannot be integrated: it is marked, not left out.
#[test]
fn a_path_without_its_energy() {
    let scene = "material = { e_star = 1, work_of_adhesion = 1 }
        profile = { kind = \"power\", n = 0.6, c = 2.4829 }
        control = { kind = \"force\", path = [\"-1e-9\", \"1e-6\"], start = \"detached\" }
        [output]\nwant = [\"path\"]\n";
    let answer = solve_text(scene, "--f64");
    let events: Vec<_> =
        answer["path"].as_array().unwrap().iter().map(|event| event["event"].as_str().unwrap()).collect();
    assert_eq!(events, ["start", "jump-in", "end"]);
    let jump = &answer["path"][1];
    assert!(number(&jump["to_contact_radius"]) > 800.0);
    let known = jump["dissipated"].is_number();
    assert_eq!(jump["status"] == "ok", known, "{answer}");
    assert_eq!(jump["why"].as_str().is_some_and(|why| why.contains("no convergence")), !known, "{answer}");
}

/// In CSV each innermost record is a row, with the output, its promise and the fields around it.
#[test]
fn a_spreadsheet_has_a_row_for_each_record() {
    let csv = output("solve examples/scenes/paraboloid.toml --f64 --format csv");
    let mut lines = csv.lines();
    let header: Vec<_> = lines.next().unwrap().split(',').collect();
    assert_eq!(header[..2], ["output", "promise"]);
    let rows: Vec<Vec<_>> = lines.map(|line| line.split(',').collect()).collect();
    assert!(rows.iter().all(|row| row.len() == header.len() && row[1] == "f64"));
    let count = |output: &str| rows.iter().filter(|row| row[0] == output).count();
    // Three states in equilibrium with six pressures each, and a value without any.
    assert_eq!((count("folds"), count("equilibria"), count("path"), count("pressure")), (1, 4, 5, 19));
}

/// What `--explain` says about a scene: output, arithmetic, and evaluations of g, slope and integral.
fn explained(scene: &str) -> Vec<(String, String, [usize; 3])> {
    let assert = mdr("solve - --explain").stdin(scene).assert().success();
    let text = String::from_utf8(assert.get_output().stderr.clone()).unwrap();
    let mut output = String::new();
    let row = |line: &str| {
        let columns: Vec<_> = line.split("  ").map(str::trim).filter(|column| !column.is_empty()).collect();
        let first = columns.len() == 6;
        if first {
            output = columns[0].to_owned();
        }
        let columns = &columns[usize::from(first)..];
        let count = |i: usize| columns[i].parse().unwrap();
        (output.clone(), columns[0].to_owned(), [count(1), count(2), count(3)])
    };
    text.lines().skip(1).map(row).collect()
}

fn figure_4() -> String {
    std::fs::read_to_string(root().join("examples/scenes/figure-4.toml")).unwrap()
}

/// Folds need g' where they are looked for, and g and its integral once for each fold that is found; whether they are
/// admissible needs the extrema of g, and with a proof g outside of each. No field, and no quadrature where g is closed.
#[test]
fn folds_alone_cost_nothing_but_folds() {
    let scene = figure_4().replace("want = [\"folds\", \"path\"]", "want = [\"folds\"]");
    let in_f64 = explained(&scene.replace("digits = 20", "arithmetic = \"f64\""));
    let [(output, arithmetic, [g, slope, integral])] = &in_f64[..] else { panic!("{in_f64:?}") };
    assert_eq!((output.as_str(), arithmetic.as_str(), *integral), ("folds", "f64", 3));
    assert!((100..10_000).contains(slope) && *g < 10_000, "{slope} {g}");
    let certified = explained(&scene);
    assert!(certified.iter().all(|(output, arithmetic, [g, _, integral])| {
        output == "folds" && (*g <= 200 || arithmetic == "f64") && *integral <= 40
    }));
}

/// `arithmetic = "f64"` is hardware arithmetic for every output.
#[test]
fn f64_touches_no_other_arithmetic() {
    let all = "\"transform\", \"equilibria\", \"folds\", \"path\", \"curve\", \"pressure\", \"gap\", \"energy\"";
    let scene = figure_4().replace("\"folds\", \"path\"", all).replace("digits = 20", "arithmetic = \"f64\"")
        + "transform.at = [\"0.1\"]\nequilibria.at = [\"-0.001\"]\n";
    let costs = explained(&scene);
    assert!(costs.len() == 8 && costs.iter().all(|(_, name, _)| name == "f64" || name == "none"), "{costs:?}");
    // In certified digits the same scene uses enclosures, and f64 to search for states.
    let certified = explained(&scene.replace("arithmetic = \"f64\"", "digits = 10"));
    for name in ["f64", "interval", "interval with slope"] {
        assert!(certified.iter().any(|(_, arithmetic, _)| arithmetic == name), "{name} in {certified:?}");
    }
}

/// Every example, in JSON, against the answer that was reviewed (SNAPSHOTS=overwrite writes it anew).
#[test]
fn the_examples_are_answered_as_they_were() {
    let folder = root().join("tests/command_line/scenes");
    for name in examples() {
        let answer = output(&format!("solve examples/scenes/{name}.toml --format json"));
        let expected = snapbox::Data::read_from(&folder.join(format!("{name}.json")), None).raw();
        snapbox::Assert::new().action_env("SNAPSHOTS").eq(answer, expected);
    }
}

/// There is an example for every kind of profile and every control.
#[test]
fn the_examples_show_every_profile_and_control() {
    let kinds = [
        "power",
        "paraboloid",
        "cone",
        "sphere",
        "ellipsoid",
        "flat-punch",
        "truncated-cone",
        "truncated-paraboloid",
        "cone-parabolic-cap",
        "cone-spherical-cap",
        "hyperboloid",
        "rounded-punch",
        "displaced-paraboloid",
        "parabolic-dimple",
        "elliptical-dimple",
        "wavy-paraboloid",
        "sum",
        "expression",
        "table",
        "indentation",
        "force",
        "machine",
    ];
    let scenes: Vec<_> = examples()
        .into_iter()
        .map(|name| std::fs::read_to_string(root().join(format!("examples/scenes/{name}.toml"))).unwrap())
        .collect();
    for kind in kinds {
        let line = format!("kind = \"{kind}\"");
        assert!(scenes.iter().any(|scene| scene.lines().any(|given| given == line)), "{kind}");
    }
}

/// The names of the examples.
fn examples() -> Vec<String> {
    let files = std::fs::read_dir(root().join("examples/scenes")).unwrap().map(|entry| entry.unwrap().path());
    let mut names: Vec<_> = files
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
        .collect();
    names.sort();
    names
}
