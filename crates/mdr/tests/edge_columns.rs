//! Histories between two works of adhesion in columns: against scenes, and where there is nothing to say.

use std::f64::consts::PI;

use mdr::columns::{ContactColumns, EdgeColumns, Event};
use mdr::prelude::*;

const BALL: &str = r#"{"kind": "paraboloid", "radius": 1}"#;

fn scene(profile: &str, more: &str) -> Scene {
    let text = format!(
        r#"{{"profile": {profile}, {more} "output": {{"want": ["path"], "arithmetic": "f64"}},
            "material": {{"e_star": 1, "work_of_adhesion": {{"advancing": "0.01", "receding": "0.04"}}}}}}"#
    );
    Scene::from_json(&text, "edges.json", &mdr::no_files).unwrap_or_else(|why| panic!("{why}\n{text}"))
}

/// A contact whose scene controls the force, which every medium has.
fn edges(profile: &str, medium: &str) -> EdgeColumns {
    EdgeColumns::new(&scene(profile, &format!("{medium} \"control\": {{\"kind\": \"force\", \"path\": [0, 1]}},")))
        .expect("edges")
}

fn kinds(events: &[Event]) -> Vec<&'static str> {
    events.iter().map(|event| event.kind.name()).collect()
}

/// Loops under each control, event by event as the path of a scene.
#[test]
fn a_history_is_the_path_of_a_scene() {
    let wavy = r#"{"kind": "wavy-paraboloid", "radius": 1, "amplitude": "5e-3", "wavelength": "0.2"}"#;
    let controls = [
        ("\"kind\": \"indentation\"", Control::Indentation, [-0.3, 0.1, 0.0, 0.2, -0.5]),
        ("\"kind\": \"force\"", Control::Force, [-0.3, 0.1, -0.02, 0.2, -0.5]),
        ("\"kind\": \"machine\", \"stiffness\": \"0.3\"", Control::machine(0.3).unwrap(), [-0.8, 0.4, 0.1, 0.5, -1.5]),
    ];
    for profile in [BALL, wavy] {
        for (written, control, way) in &controls {
            let more = format!(r#""control": {{{written}, "path": {way:?}, "start": "detached"}},"#);
            let scene = scene(profile, &more);
            let answer = scene.solve().unwrap();
            let expected = answer.path().unwrap();
            let contact = EdgeColumns::new(&scene).unwrap();
            let path = contact.path(control, way, &Start::Detached, 7).unwrap();
            let names: Vec<&str> = expected.events.items.iter().map(|event| event.event.name()).collect();
            assert_eq!(kinds(&path.events), names, "{more}");
            assert!(names.contains(&"pinned") && names.contains(&"depinned"), "{names:?}");
            let number = |value: &Option<Value>| value.as_ref().and_then(Value::to_f64);
            for (event, record) in path.events.iter().zip(&expected.events.items) {
                assert_eq!(number(&record.hysteresis.0), Some(event.hysteresis), "{more}");
                assert_eq!(number(&record.contact_radius).unwrap_or(0.0), event.before.contact_radius);
                assert_eq!(event.edge, record.edge);
            }
            let history = contact.follow(control, way, &Start::Detached).unwrap();
            let arrivals =
                path.events.iter().filter(|event| ["start", "way-point", "end"].contains(&event.kind.name()));
            let radii: Vec<f64> = arrivals.map(|event| event.after.contact_radius).collect();
            assert_eq!(history.states.contact_radius, radii, "{more}");
            assert_eq!(history.jumps.len() + way.len(), path.events.len());
        }
    }
}

/// The energy of a loop, as scenes balance it: what is lost in the jumps and by the receding edge is the work.
#[test]
fn the_energy_of_a_loop() {
    let turn = 0.45_f64.powi(2) - (2.0 * PI * 0.45 * 0.01).sqrt();
    let path = edges(BALL, "").path(&Control::Indentation, &[-0.3, turn, -0.3], &Start::Detached, 3).unwrap();
    let [work, dissipated, stored] = path.balance.unwrap();
    assert!((work / 0.025_216_996_685_060_09 - 1.0).abs() < 1e-12 && (dissipated / work - 1.0).abs() < 1e-9);
    assert!(stored.abs() < 1e-15);
    let by_edge: f64 = path.events.iter().map(|event| event.hysteresis).sum();
    assert!((by_edge / 0.019_085_175_370_557_934 - 1.0).abs() < 1e-12, "{by_edge}");
    let all: f64 = path.events.iter().map(|event| event.dissipated).sum();
    assert!((all / dissipated - 1.0).abs() < 1e-12);
}

/// What is not known, or is not there, is not 0.
#[test]
fn what_is_not_known_is_not_nothing() {
    let load = Control::Force;
    let ball = edges(BALL, "");
    // An edge that moves by less than its radius is rounded.
    let path = ball.path(&load, &[1e-20, -1e-20], &Start::Largest, 1).unwrap();
    assert!(path.events[1].hysteresis.is_nan() && path.events[1].dissipated.is_nan());
    assert!(path.balance.is_some_and(|balance| balance.iter().all(|part| part.is_nan())));
    // Pinned from the start it loses nothing.
    let path = ball.path(&Control::Indentation, &[0.05, 0.0], &Start::Nearest(0.5), 1).unwrap();
    assert_eq!(
        [path.events[1].hysteresis, path.events[1].dissipated, path.events[1].after.contact_radius],
        [0.0, 0.0, 0.5]
    );
    // A dead load that has torn the surfaces apart has no depth, and a line contact without a reference none at all.
    let torn = ball.follow(&load, &[0.0, -1.0], &Start::Largest).unwrap();
    assert!(
        torn.states.indentation[1].is_nan() && torn.states.force[1] == 0.0 && torn.jumps[0].dissipated.is_infinite()
    );
    let line = edges(BALL, r#""medium": {"kind": "plane"},"#).follow(&load, &[0.1, 0.05], &Start::Largest).unwrap();
    assert!(line.states.indentation.iter().all(|depth| depth.is_nan()) && line.states.contact_radius[1] > 0.3);
    assert!(
        edges(BALL, r#""medium": {"kind": "plane"},"#).follow(&Control::Indentation, &[0.1], &Start::Largest).is_err()
    );
    let stop = Stop::default();
    stop.stop();
    assert!(ball.until(&stop).follow(&load, &[0.0], &Start::Largest).is_err());
    assert!(
        ball.follow(&load, &[f64::NAN], &Start::Largest).is_err() && ball.follow(&load, &[], &Start::Largest).is_err()
    );
}

/// With one work of adhesion the history is that of a contact with one; of two, each edge alone has its own.
#[test]
fn edges_with_one_work() {
    let one = Scene::new(Shape::Paraboloid { radius: "1" }, Elasticity::effective("1").unwrap(), "0.04").unwrap();
    let (both, one) = (EdgeColumns::new(&one).unwrap(), ContactColumns::new(&one).unwrap());
    let way = [0.2, 0.1, -0.05, 0.1, -0.3];
    let histories = [
        both.follow(&Control::Indentation, &way, &Start::Largest),
        one.follow(&Control::Indentation, &way, &Start::Largest),
    ];
    let [found, expected] = histories.map(Result::unwrap);
    for (found, expected) in found.states.contact_radius.iter().zip(&expected.states.contact_radius) {
        assert!((found - expected).abs() <= 1e-12 * expected, "{found} {expected}");
    }
    assert_eq!(kinds(&found.jumps), kinds(&expected.jumps));
    let receding =
        edges(BALL, "").at(Edge::Receding).states(&Control::Force, &[0.0], mdr::columns::Choice::Largest).unwrap();
    let expected = one.states(&Control::Force, &[0.0], mdr::columns::Choice::Largest).unwrap();
    assert!((receding.contact_radius[0] / expected.contact_radius[0] - 1.0).abs() < 1e-13);
}
