//! Paths over measured tables in certified digits, within bounded work.
#![cfg(feature = "mp")]

use mdr::prelude::*;

/// A wavy paraboloid of radius 1, in so many rows up to r = 0.5, pulled from an indentation.
fn scene(rows: usize, from: &str, energies: Option<bool>) -> Scene {
    wanting("\"path\"", rows, from, energies)
}

fn wanting(wants: &str, rows: usize, from: &str, energies: Option<bool>) -> Scene {
    let row = |i: usize| {
        let r = 0.5 * i as f64 / (rows - 1) as f64;
        format!("{r:.6e},{:.6e}\n", r * r / 2.0 + 3e-4 * (1.0 - (r / 0.05).cos()))
    };
    let csv: String = std::iter::once("r,f\n".to_owned()).chain((0..rows).map(row)).collect();
    let file = move |_: &str| Ok(csv.clone().into_bytes());
    let text = format!(
        r#"{{"profile": {{"kind": "table", "file": "tip.csv", "columns": "r,f"}},
            "material": {{"e_star": 1, "work_of_adhesion": "1e-3"}},
            "control": {{"kind": "indentation", "path": ["{from}", "-0.1"]}}, "output": {{"want": [{wants}], "digits": 20}}}}"#
    );
    let scene = Scene::from_json(&text, "scene.json", &file).expect("a scene");
    match energies {
        Some(wanted) => scene.energies(wanted),
        None => scene,
    }
}

fn solve(scene: &Scene, seconds: f64) -> mdr::Result<Answer> {
    scene.solve_with(&mut Run::default().within(seconds))
}

fn path(answer: Answer) -> mdr::answer::LoadingPath {
    match answer.outputs.into_iter().next() {
        Some(Output::Path(path)) => *path,
        other => panic!("no path: {other:?}"),
    }
}

#[test]
fn a_path_over_a_table_that_cannot_start_is_refused_for_next_to_no_work() {
    // A proof of the folds of these rows takes a hundred times as much work.
    for from in ["-0.5", "-0.05"] {
        for wants in ["\"path\"", "\"folds\", \"path\""] {
            let refused = solve(&wanting(wants, 100, from, None), 0.02).expect_err("a refusal").to_string();
            assert!(refused.contains("the path cannot start there: no stable equilibrium"), "{refused}");
        }
    }
    assert!(solve(&scene(100, "0.01", None), 0.02).is_ok(), "it can start");
}

/// The table is too long for a proof: what f64 finds is there, with its energies unless they are not wanted.
#[test]
fn a_long_table_has_its_events_and_its_energies() {
    for energies in [None, Some(true), Some(false)] {
        let path = path(solve(&scene(1100, "0.01", energies), 2.0).expect("an answer"));
        let kinds: Vec<EventKind> = path.events.items.iter().map(|event| event.event).collect();
        assert_eq!(kinds, [EventKind::Start, EventKind::Detached, EventKind::End], "{energies:?}");
        let radius = path.events.items[1].contact_radius.as_ref().and_then(Value::to_f64).expect("a radius");
        assert!((radius - 0.0698).abs() < 1e-4, "{radius}");
        match path.balance {
            Some(balance) => assert!(balance.work.to_f64().is_some() && energies != Some(false), "{balance:?}"),
            None => assert_eq!(energies, Some(false)),
        }
    }
}

/// Doubles only help: folds of a table have the same digits where the modulus and the work of adhesion are beyond their range.
#[test]
fn folds_beyond_the_range_of_doubles_are_proved() {
    let folds = |e_star: &str, work: &str| {
        let text = format!(
            "material = {{ e_star = \"{e_star}\", work_of_adhesion = \"{work}\" }}
            profile = {{ kind = \"table\", file = \"tip.csv\" }}
            control = {{ kind = \"indentation\" }}
            output = {{ want = [\"folds\"], digits = 20 }}"
        );
        let rows = |_: &str| Ok(b"r,f\n0,0\n1e-8,5e-11\n2e-8,2e-10\n3e-8,4.5e-10\n5e-8,1.25e-9\n".to_vec());
        let scene = Scene::from_toml(&text, "scene.toml", &rows).expect("a scene");
        let answer = scene.solve().expect("an answer");
        let answer: serde_json::Value = serde_json::from_str(&answer.to_json()).expect("JSON");
        assert_eq!(answer["promise"]["folds"], "certified", "{answer}");
        let folds = answer["folds"].as_array().expect("folds").iter();
        folds.map(|fold| fold["contact_radius"].to_string()).collect::<Vec<_>>()
    };
    let within = folds("1", "1e-12");
    assert_eq!(within.len(), 1);
    assert_eq!(folds("1e400", "1e388"), within);
}

/// Off the half-space doubles know a table by its heights, each of which sees two rows: they do not weigh as much as all.
#[test]
fn a_noisy_table_in_line_contact_has_its_folds() {
    let noise = |i: i32| (f64::from((i * 7919) % 101) / 101.0 - 0.5) * 0.1;
    let row = |i: i32| (f64::from(i) / 40.0, (f64::from(i) / 40.0).powi(2) / 2.0 * (1.0 + noise(i)));
    let rows: String = (1..=40).map(row).map(|(r, f)| format!("{r},{f:.6}\n")).collect();
    let file = move |_: &str| Ok(format!("r,f\n0,0\n{rows}").into_bytes());
    let text = r#"{"profile": {"kind": "table", "file": "tip.csv", "columns": "r,f"}, "medium": {"kind": "plane", "reference": 100},
        "material": {"e_star": 1, "work_of_adhesion": "1e-3"}, "control": {"kind": "indentation"},
        "output": {"want": ["folds"], "arithmetic": "f64"}}"#;
    let answer = solve(&Scene::from_json(text, "scene.json", &file).expect("a scene"), 5.0).expect("an answer");
    let folds = answer.folds().expect("wanted");
    assert!(folds.items.len() > 10, "{folds:?}");
}
