//! Scenes with two works of adhesion.

#![cfg(all(feature = "mp", feature = "toml"))]
#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use mdr::answer::{Dissipation, LoadingPath, Optional, PathEvent};
use mdr::prelude::*;
use mdr::{Error, no_files};
use std::f64::consts::PI;

fn scene(profile: &str, works: [&str; 2], control: &str, output: &str) -> Result<Scene, Error> {
    let [advancing, receding] = works;
    let text = format!(
        "[profile]\n{profile}\n[material]\ne_star = 1\n\
         work_of_adhesion = {{ advancing = \"{advancing}\", receding = \"{receding}\" }}\n\
         [control]\n{control}\n[output]\n{output}\n"
    );
    Scene::from_toml(&text, "scene.toml", &no_files)
}

const BALL: &str = "kind = \"paraboloid\"\nradius = 1";
const WAVY: &str = "kind = \"wavy-paraboloid\"\nradius = 1\namplitude = \"5e-4\"\nwavelength = \"0.1\"";

const FRUSTUM: &str = "kind = \"truncated-cone\"\nslope = \"0.1\"\nflat = \"0.1\"";

fn path(scene: &Scene) -> LoadingPath {
    scene.solve().unwrap().path().unwrap().clone()
}

fn event<'p>(path: &'p LoadingPath, kind: &str) -> &'p PathEvent {
    path.events.items.iter().find(|event| event.event.name() == kind).unwrap()
}

fn text(value: &Option<Value>) -> String {
    value.as_ref().unwrap().to_string()
}

fn kinds(path: &LoadingPath) -> Vec<&'static str> {
    path.events.items.iter().map(|event| event.event.name()).collect()
}

/// Values of a sphere with E* = R = 1, w₁ = 1/100, w₂ = 4/100 from its closed forms, in 20 digits that are proved.
#[test]
fn known_values_in_certified_digits() {
    // d = g(1/2) − Δl₁(1/2) = 1/4 − √(π/100).
    let way = "kind = \"indentation\"\npath = [\"-0.3\", \"0.07275461490944839727018325166588548172024505438776\", \"-0.3\"]\nstart = \"detached\"";
    let found = path(&scene(BALL, ["0.01", "0.04"], way, "want = [\"path\"]").unwrap());
    assert_eq!(found.events.promise, Promise::Certified);
    assert_eq!(text(&event(&found, "jump-in").to_contact_radius), "0.39755140207189853674");
    let set_free = event(&found, "depinned");
    assert_eq!(text(&set_free.contact_radius), "0.50000000000000000000");
    assert_eq!(text(&set_free.indentation), "-0.10449077018110320546");
    assert_eq!(text(&set_free.force), "-0.18782410351443653879");
    // d = g − Δl₁ at a = 0.45.
    let way = "kind = \"indentation\"\npath = [\"-0.3\", \"0.03435026350806213902066152698393597318437028674367\", \"-0.3\"]\nstart = \"detached\"";
    let found = path(&scene(BALL, ["0.01", "0.04"], way, "want = [\"path\"]").unwrap());
    let Dissipation::Finite(jump_in) = event(&found, "jump-in").dissipated.clone().unwrap() else { panic!("finite") };
    assert_eq!(jump_in.to_string(), "0.0029791179755832651070");
    let Dissipation::Finite(off) = event(&found, "detached").dissipated.clone().unwrap() else { panic!("finite") };
    assert_eq!(off.to_string(), "0.0031527033389188318854");
}

/// A contact that was pressed too little breaks as soon as it is set free.
#[test]
fn pull_off_depends_on_the_preload() {
    let way = "kind = \"indentation\"\npath = [\"-0.08\", \"-0.3\"]\nstart = \"0.2\"";
    let found = scene(BALL, ["0.01", "0.04"], way, "want = [\"path\", \"force-curve\"]").unwrap().solve().unwrap();
    let followed = found.path().unwrap();
    assert_eq!(kinds(followed), ["start", "depinned", "detached", "end"]);
    assert_eq!(text(&event(followed, "detached").force), "-0.079013192795700192522");
    let force = found.force_curve().unwrap().summary.pull_off_force.as_ref().and_then(Value::to_f64).unwrap();
    assert!((force / -0.079_013_192_795_700_2 - 1.0).abs() < 1e-14);
}

/// The work is what is stored and lost; what is lost is lost in jumps and by the receding edge: to the last of 20 digits.
#[test]
fn balance_is_exact() {
    let machine = "kind = \"machine\"\nstiffness = \"0.3\"\nstart = \"detached\"\n";
    let grips = "kind = \"indentation\"\nstart = \"detached\"\n";
    for (profile, works, control, way) in [
        (BALL, ["0.01", "0.04"], grips, "[\"-0.3\", \"0.05\", \"-0.1\", \"0.05\", \"-0.3\"]"),
        (BALL, ["0", "0.04"], grips, "[\"-0.3\", \"0.05\", \"-0.1\", \"0.1\", \"-0.185\"]"),
        (BALL, ["0.01", "0.04"], machine, "[\"-0.3\", \"0.5\", \"0.2\", \"0.5\", \"0.6\", \"-1\"]"),
        (WAVY, ["2e-5", "1e-4"], grips, "[\"-0.01\", \"0.01\", \"-0.002\", \"0.01\", \"-0.05\"]"),
        (WAVY, ["2e-5", "1e-4"], machine, "[\"-0.01\", \"0.02\", \"0.005\", \"0.02\", \"-0.05\"]"),
        ("kind = \"cone\"\nslope = \"1/10\"", ["1e-4", "2e-4"], grips, "[\"-0.1\", \"0.01\", \"-0.1\"]"),
        ("kind = \"power\"\nn = 4\nc = 1", ["1e-4", "2e-4"], grips, "[\"-0.1\", \"0.01\", \"0\"]"),
        // Pulled off from the edge of its face, a kink.
        (FRUSTUM, ["1e-5", "1e-4"], grips, "[\"-0.05\", \"0.02\", \"-0.05\"]"),
        (FRUSTUM, ["1e-5", "1e-4"], machine, "[\"-0.1\", \"0.05\", \"-0.1\"]"),
    ] {
        let scene = scene(profile, works, &format!("{control}path = {way}"), "want = [\"path\"]").unwrap();
        let searched = path(&scene.clone().arithmetic(Arithmetic::F64)).balance.unwrap();
        let found = path(&scene);
        assert_eq!((found.events.promise, found.energy), (Promise::Certified, None), "{profile} {way}");
        let balance = found.balance.unwrap();
        let number = |value: &Value| value.to_f64().unwrap();
        let part = |value: &Optional| number(value.0.as_ref().unwrap());
        let (jumps, hysteresis) = (part(&balance.jumps), part(&balance.hysteresis));
        // By other integrals, in doubles.
        for (one, other) in [(jumps, part(&searched.jumps)), (hysteresis, part(&searched.hysteresis))] {
            assert!((one - other).abs() <= 1e-10 * (jumps + hysteresis), "{profile} {way}: {one}, {other}");
        }
        let [work, lost, stored] = [&balance.work, &balance.dissipated, &balance.stored].map(number);
        assert!((lost - jumps - hysteresis).abs() <= 4e-16 * lost, "{profile} {way}");
        assert!((work - lost - stored).abs() <= 4e-16 * (lost + stored.abs()), "{profile} {way}");
        let each: f64 = found.events.items.iter().map(|event| part(&event.hysteresis)).sum();
        assert!((each - hysteresis).abs() <= 1e-15 * hysteresis && hysteresis > 0.0, "{profile} {way}");
    }
}

/// On a graded half-space and on springs the loop closes as well: the balance, and the closed forms of a foundation.
#[test]
fn media_with_hysteresis() {
    for medium in ["kind = \"graded\"\nexponent = \"3/10\"\ncoefficient = 1", "kind = \"winkler\"\nmodulus = 1"] {
        let scene_of = |works: &str, control: &str| {
            format!(
                "[medium]\n{medium}\n[profile]\nkind = \"paraboloid\"\nradius = 1\n[material]\nwork_of_adhesion = {works}\n\
                 [control]\nkind = \"indentation\"\n{control}\nstart = \"detached\"\n[output]\nwant = [\"path\"]\n"
            )
        };
        let control = "path = [\"-1\", \"0.2\", \"-1\"]";
        let two = scene_of("{ advancing = \"0.01\", receding = \"0.04\" }", control);
        let found = path(&Scene::from_toml(&two, "", &no_files).unwrap());
        let expected = ["start", "jump-in", "way-point", "pinned", "depinned", "detached", "end"];
        assert_eq!(kinds(&found), expected, "{medium}");
        assert_eq!(found.events.promise, Promise::Certified, "{medium}");
        let number = |value: &Value| value.to_f64().unwrap();
        let balance = found.balance.clone().unwrap();
        let radius = number(event(&found, "pinned").contact_radius.as_ref().unwrap());
        let hysteresis = number(balance.hysteresis.0.as_ref().unwrap());
        let swept = 0.03 * std::f64::consts::PI * radius * radius;
        assert!((hysteresis / swept - 1.0).abs() < 1e-14, "{medium}");
        // The advancing edge of w₁ alone reaches the same radius, and the receding one leaves it as that of w₂ does.
        let one = path(&Scene::from_toml(&scene_of("\"0.01\"", control), "", &no_files).unwrap());
        let way_points = [&found, &one].map(|path| text(&path.events.items[2].contact_radius));
        assert_eq!(way_points[0], way_points[1], "{medium}");
    }
}

/// f64 follows the same path as enclosures.
#[test]
fn doubles_follow_the_certified_path() {
    for (profile, works, control) in [
        (BALL, ["0.01", "0.04"], "kind = \"force\"\npath = [\"-1\", \"0.1\", \"-0.1\", \"0.1\", \"-0.19\"]"),
        (BALL, ["0", "0.04"], "kind = \"force\"\npath = [\"-1\", \"0.01\", \"-1\"]"),
        (
            WAVY,
            ["2e-5", "1e-4"],
            "kind = \"indentation\"\npath = [\"-0.01\", \"0.01\", \"-0.002\", \"0.02\", \"-0.05\"]",
        ),
        (
            WAVY,
            ["9e-5", "1e-4"],
            "kind = \"machine\"\nstiffness = 1\npath = [\"-0.01\", \"0.01\", \"0\", \"0.02\", \"-0.05\"]",
        ),
        (WAVY, ["2e-5", "1e-4"], "kind = \"force\"\npath = [\"-0.01\", \"1e-3\", \"-1e-4\", \"2e-3\", \"-0.05\"]"),
    ] {
        let control = format!("{control}\nstart = \"detached\"");
        let certified = scene(profile, works, &control, "want = [\"path\"]").unwrap();
        let double = certified.clone().arithmetic(Arithmetic::F64);
        let [certified, double] = [path(&certified), path(&double)];
        assert_eq!(certified.events.promise, Promise::Certified, "{profile} {control}");
        assert_eq!(kinds(&certified), kinds(&double), "{profile} {control}");
        for (one, other) in certified.events.items.iter().zip(&double.events.items) {
            assert_eq!(one.edge, other.edge);
            for (one, other) in
                [(&one.contact_radius, &other.contact_radius), (&one.to_contact_radius, &other.to_contact_radius)]
            {
                let number = |value: &Option<Value>| value.as_ref().map(|value| value.to_f64().unwrap());
                let (one, other) = (number(one).unwrap_or(0.0), number(other).unwrap_or(0.0));
                // At a fold the radius has half the digits of the controlled quantity.
                assert!((one - other).abs() <= 1e-7 * one, "{one} {other} {control}");
            }
        }
    }
}

/// One number means both, and two equal numbers are one: every answer is the same.
#[test]
fn equal_works_are_one() {
    let control = "kind = \"indentation\"\npath = [\"-0.3\", \"0.05\", \"-0.3\"]\nstart = \"detached\"";
    let output = "want = [\"path\", \"force-curve\", \"folds\", \"equilibria\", \"energy\"]\nequilibria = { at = [0] }";
    let two = scene(BALL, ["0.04", "40 mJ/m2"], control, output).unwrap();
    let one = format!(
        "[profile]\n{BALL}\n[material]\ne_star = 1\nwork_of_adhesion = \"0.04\"\n[control]\n{control}\n[output]\n{output}\n"
    );
    let one = Scene::from_toml(&one, "", &no_files).unwrap();
    assert_eq!(two.solve().unwrap().to_json(), one.solve().unwrap().to_json());
}

/// Energy and fields of the state in which a path starts are certified, on either edge and between the two. A pinned contact is a linear spring: from one
/// depth to another the energy rises by the mean force times the way.
#[test]
fn energy_and_fields_of_a_state_are_certified() {
    let state = |depth: &str, start: &str, profile: &str| {
        let control = format!("kind = \"indentation\"\npath = [\"{depth}\"]\nstart = {start}");
        let wanted = "want = [\"energy\", \"pressure\", \"displacement\"]";
        let answer = scene(profile, ["0.01", "0.04"], &control, wanted).unwrap().solve().unwrap();
        let energies = answer.energy().unwrap();
        let fields = [answer.pressure().unwrap(), answer.displacement().unwrap()];
        assert_eq!(fields.map(|field| field.promise), [Promise::Certified; 2], "{profile} {depth} {start}");
        assert_eq!(energies.promise, Promise::Certified, "{profile} {depth} {start}");
        let state = energies.items[0].items[0].clone();
        (state.edge, [&state.energy, &state.state.force, &state.stiffness].map(|value| value.to_f64().unwrap()))
    };
    for profile in [BALL, WAVY, "kind = \"sphere\"\nradius = 1"] {
        for (start, edge) in [("\"smallest\"", "advancing"), ("\"largest\"", "receding")] {
            assert_eq!(state("0.1", start, profile).0.map(|edge| edge.name()), Some(edge), "{profile}");
        }
        let [(edge, [low, pull, stiffness]), (_, [high, push, _])] =
            ["-0.18", "-0.08"].map(|depth| state(depth, "0.2", profile));
        assert_eq!((edge, stiffness), (None, 0.4), "{profile}");
        let work = 0.5 * (pull + push) * 0.1;
        // Some roundings of two energies and of the work.
        assert!((high - low - work).abs() < 4.0 * f64::EPSILON * (high.abs() + low.abs() + work.abs()), "{profile}");
    }
}

/// Folds and equilibria are those of both edges, each with its name.
#[test]
fn folds_and_equilibria_name_their_edge() {
    let output = "want = [\"folds\", \"equilibria\"]\nequilibria = { at = [0] }";
    let answer = scene(BALL, ["0.01", "0.04"], "kind = \"force\"", output).unwrap().solve().unwrap();
    let folds = answer.folds().unwrap();
    let named: Vec<(&str, f64)> =
        folds.items.iter().map(|fold| (fold.edge.unwrap().name(), fold.force.to_f64().unwrap())).collect();
    let jkr = |w: f64| -1.5 * std::f64::consts::PI * w;
    for ((edge, force), (name, w)) in named.iter().zip([("advancing", 0.01), ("receding", 0.04)]) {
        assert!(*edge == name && (force / jkr(w) - 1.0).abs() < 1e-15, "{named:?}");
    }
    let states = &answer.equilibria().unwrap().items[0].items;
    assert_eq!(states.iter().map(|state| state.edge.unwrap().name()).collect::<Vec<_>>(), ["advancing", "receding"]);
}

/// An edge that turns, turns back within the pin, and comes to the same value again, exactly: decided, not guessed.
#[test]
fn same_value_again_is_decided() {
    let way =
        "kind = \"force\"\npath = [\"0.1\", \"0.05\", \"0.1\", \"1/20\", \"0.11\", \"0.05\"]\nstart = \"smallest\"";
    let found = path(&scene(BALL, ["0.01", "0.04"], way, "want = [\"path\"]").unwrap());
    assert_eq!(found.events.promise, Promise::Certified);
    assert_eq!(
        kinds(&found),
        ["start", "pinned", "way-point", "way-point", "way-point", "depinned", "way-point", "pinned", "end"]
    );
    assert_eq!(text(&event(&found, "depinned").force), "0.10000000000000000000");
}

/// What is refused names the key, the value and the remedy.
#[test]
fn refusals_have_a_remedy() {
    let control = "kind = \"indentation\"\npath = [0, \"-0.3\"]";
    for (works, part) in [
        (["0.05", "0.04"], "exchange the two"),
        (["-0.01", "0.04"], "must not be negative"),
        (["0", "0"], "must be positive"),
        (["0.01 N", "0.04"], "work_of_adhesion.advancing"),
        (["x", "0.04"], "work_of_adhesion.advancing"),
    ] {
        let error = scene(BALL, works, control, "want = [\"path\"]").unwrap_err().to_string();
        assert!(error.contains(part) && error.contains("work_of_adhesion"), "{error}");
    }
}

/// Without adhesion on the way in contact begins at d = F = 0, on all of a flat at once, and follows Hertz; on the way out it
/// breaks as the receding edge does.
#[test]
fn contact_without_adhesion_on_the_way_in() {
    let flat = "kind = \"flat-punch\"\nradius = \"0.1\"";
    let cut_cone = "kind = \"truncated-cone\"\nslope = \"0.1\"\nflat = \"0.1\"";
    let cut_ball = "kind = \"truncated-paraboloid\"\nradius = 1\nflat = \"0.1\"";
    let rounded = "kind = \"rounded-punch\"\nradius = 1\nflat = \"0.1\"";
    let cap = "kind = \"cone-parabolic-cap\"\nslope = \"0.1\"\ncap = \"0.05\"";
    let cone = "kind = \"cone\"\nslope = \"0.1\"";
    let sharp = "kind = \"power\"\nn = \"1/3\"\nc = \"0.01\"";
    let wider = "kind = \"rounded-punch\"\nradius = 1\nflat = \"0.2\"";
    let sum = format!("kind = \"sum\"\n[[profile.term]]\n{cut_cone}\n[[profile.term]]\n{wider}");
    let controls = [
        ("kind = \"indentation\"", "0.01"),
        ("kind = \"force\"", "0.003"),
        ("kind = \"machine\"\nstiffness = \"0.3\"", "0.02"),
    ];
    for (index, profile) in [flat, cut_cone, cut_ball, rounded, cap, cone, sharp, BALL, &sum].into_iter().enumerate() {
        // Each shape under one control.
        let (control, press) = controls[index % 3];
        let control = format!("{control}\nstart = \"detached\"\npath = [\"-1\", \"{press}\", \"-1\"]");
        let certified = scene(profile, ["0", "1e-4"], &control, "want = [\"path\"]").unwrap();
        let found = path(&certified);
        assert_eq!(found.events.promise, Promise::Certified, "{profile} {control}");
        let expected = ["start", "touch", "way-point", "pinned", "depinned", "detached", "end"];
        assert_eq!(kinds(&found), expected, "{profile} {control}");
        let touched = event(&found, "touch");
        let radius = number(&touched.to_contact_radius);
        let is_flat = profile.contains("flat");
        assert_eq!(radius, if is_flat { 0.1 } else { 0.0 }, "{profile} {control}");
        assert_eq!((number(&touched.to_indentation), number(&touched.to_force)), (0.0, 0.0));
        let double = path(&certified.clone().arithmetic(Arithmetic::F64));
        assert_eq!(kinds(&found), kinds(&double), "{profile} {control}");
        for (one, other) in found.events.items.iter().zip(&double.events.items) {
            let [one, other] = [one, other].map(|event| number(&event.contact_radius));
            assert!((one - other).abs() <= 1e-7 * one, "{one} {other} {profile} {control}");
        }
        // The load of Hertz is that of the energy without adhesion: work = stored, and both legs close.
        if let Some(balance) = &found.balance {
            let part = |value: &Optional| value.0.as_ref().unwrap().to_f64().unwrap();
            let [work, lost] = [&balance.work, &balance.dissipated].map(|value| value.to_f64().unwrap());
            assert!((lost - part(&balance.jumps) - part(&balance.hysteresis)).abs() <= 1e-15 * lost);
            assert!((work - lost).abs() <= 1e-15 * lost, "apart at both ends: {profile} {control}");
        }
    }
}

fn number(value: &Option<Value>) -> f64 {
    value.as_ref().map_or(0.0, |value| value.to_f64().unwrap())
}

/// A flat that just touches, at exactly d = 0, is pinned at its own radius, which no double holds.
#[test]
fn flat_that_just_touches() {
    for profile in
        ["kind = \"flat-punch\"\nradius = \"0.1\"", "kind = \"truncated-cone\"\nslope = \"0.1\"\nflat = \"0.1\""]
    {
        for control in ["kind = \"indentation\"", "kind = \"force\"", "kind = \"machine\"\nstiffness = \"0.3\""] {
            let control = format!("{control}\nstart = \"detached\"\npath = [\"-1\", 0, \"-1e-9\", \"-1\"]");
            let found = path(&scene(profile, ["0", "1e-4"], &control, "want = [\"path\"]").unwrap());
            assert_eq!(found.events.promise, Promise::Certified, "{profile} {control}");
            let expected = ["start", "touch", "way-point", "pinned", "way-point", "depinned", "detached", "end"];
            assert_eq!(kinds(&found), expected, "{profile} {control}");
            // F = −√(8πa³wE*), of a punch of this radius.
            let force = number(&event(&found, "detached").force);
            let kendall = -(8.0 * std::f64::consts::PI * 1e-3 * 1e-4_f64).sqrt();
            assert!((force / kendall - 1.0).abs() < 1e-15, "{force} {kendall} {profile} {control}");
        }
    }
    // With adhesion on the way in a punch is pinned at its edge as well.
    let control = "kind = \"indentation\"\nstart = \"detached\"\npath = [\"-1\", 0, \"-1\"]";
    let found = path(
        &scene("kind = \"flat-punch\"\nradius = \"0.1\"", ["1e-5", "1e-4"], control, "want = [\"path\"]").unwrap(),
    );
    assert_eq!(found.events.promise, Promise::Certified);
    assert_eq!(kinds(&found), ["start", "jump-in", "way-point", "pinned", "depinned", "detached", "end"]);
}

/// What describes single states has those of both edges, with the energy that is stored: its differences are work.
#[test]
fn states_of_both_edges() {
    let output = "want = [\"curve\", \"energy\", \"pressure\", \"gap\", \"displacement\"]\ndigits = 12\n\
                  curve = { at = [\"0.5\"] }\nequilibria = { at = [\"-0.05\"] }\npressure = { at = [\"0.1\"] }\n\
                  gap = { at = [\"0.7\"] }\ndisplacement = { at = [\"0.7\"] }";
    for works in [["0.01", "0.04"], ["0", "0.04"]] {
        let certified = scene(BALL, works, "kind = \"indentation\"", output).unwrap();
        let double = certified.clone().arithmetic(Arithmetic::F64);
        let [w1, w2] = works.map(|work| work.parse::<f64>().unwrap());
        for answer in [certified.solve().unwrap(), double.solve().unwrap()] {
            let curve = &answer.curve().unwrap().items;
            for (point, (edge, w)) in curve.iter().zip([("advancing", w1), ("receding", w2)]) {
                let depth = 0.25 - (std::f64::consts::PI * w).sqrt();
                assert_eq!(point.edge.unwrap().name(), edge);
                assert!((point.indentation.to_f64().unwrap() - depth).abs() < 1e-11, "{point:?}");
            }
            let energies = &answer.energy().unwrap().items[0].items;
            let edges: Vec<_> = energies.iter().map(|state| state.edge.unwrap().name()).collect();
            // At w₁ = 0 nothing is held at d < 0.
            let advancing = if w1 > 0.0 { vec!["advancing"; 2] } else { Vec::new() };
            assert_eq!(edges, [advancing, vec!["receding"; 2]].concat());
            for state in energies {
                let a = state.state.contact_radius.to_f64().unwrap();
                let d: f64 = -0.05;
                let elastic = d * d * a - 2.0 * d * a.powi(3) / 3.0 + a.powi(5) / 5.0;
                let stored = elastic - w1 * std::f64::consts::PI * a * a;
                assert!((state.energy.to_f64().unwrap() - stored).abs() < 1e-11 * elastic, "{works:?} {state:?}");
            }
            for field in [answer.pressure(), answer.gap(), answer.displacement()] {
                let states = &field.unwrap().items[0].items;
                assert_eq!(states.iter().map(|state| state.edge.unwrap().name()).collect::<Vec<_>>(), edges);
                assert!(states.last().unwrap().samples[0].value.to_f64().is_some());
            }
        }
    }
}

/// A path may start pinned: the state is that of the radius that is given, with the stiffness of a spring.
#[test]
fn state_that_is_pinned() {
    let control = "kind = \"indentation\"\npath = [\"-0.1\", \"-0.3\"]\nstart = \"0.2\"";
    let output = "want = [\"energy\", \"pressure\"]\ndigits = 12\npressure = { at = [0] }";
    let certified = scene(BALL, ["0.01", "0.04"], control, output).unwrap();
    let double = certified.clone().arithmetic(Arithmetic::F64);
    for answer in [certified.solve().unwrap(), double.solve().unwrap()] {
        let [state] = &answer.energy().unwrap().items[0].items[..] else { panic!("one state") };
        assert!(state.edge.is_none() && state.state.contact_radius.to_f64() == Some(0.2));
        assert_eq!(state.stiffness.to_f64(), Some(0.4));
        let stored = 0.002 + 0.2 * 0.008 / 3.0 + 0.2_f64.powi(5) / 5.0 - 0.01 * std::f64::consts::PI * 0.04;
        assert!((state.energy.to_f64().unwrap() - stored).abs() < 1e-14);
        // p(0) = (1/π)[∫2 dx − (g(a) − d)/a], E* = 1.
        let pressure = (2.0 * 0.2 - (0.04 + 0.1) / 0.2) / std::f64::consts::PI;
        let found = answer.pressure().unwrap().items[0].items[0].samples[0].value.to_f64().unwrap();
        assert!((found - pressure).abs() < 1e-11, "{found} {pressure}");
    }
    // From the receding edge, the default, and from the advancing one.
    for (start, edge) in [("largest", "receding"), ("smallest", "advancing")] {
        let control = format!("kind = \"indentation\"\npath = [0, \"-0.3\"]\nstart = \"{start}\"");
        let answer = scene(BALL, ["0.01", "0.04"], &control, output).unwrap().solve().unwrap();
        assert_eq!(answer.energy().unwrap().items[0].items[0].edge.unwrap().name(), edge);
    }
}

/// Without adhesion on the way in the stiffness is S = 2E*a, proved as well as in doubles; the receding edge has that of its own work.
#[test]
fn stiffness_of_both_edges() {
    let output = "want = [\"energy\"]\ndigits = 12\nequilibria = { at = [\"0.05\"] }";
    for ball in [BALL, "kind = \"sphere\"\nradius = 1", "kind = \"expression\"\nformula = \"r^2/2 + r^4\""] {
        let certified = scene(ball, ["0", "0.04"], "kind = \"indentation\"", output).unwrap();
        let double = certified.clone().arithmetic(Arithmetic::F64);
        let [certified, double] = [certified, double].map(|scene| scene.solve().unwrap());
        let [certified, double] = [&certified, &double].map(|answer| &answer.energy().unwrap().items[0].items);
        let number = |value: &mdr::answer::Value| value.to_f64().unwrap();
        let [advancing, receding] = &certified[..] else { panic!("{ball}: {certified:?}") };
        assert!((number(&advancing.stiffness) / (2.0 * number(&advancing.state.contact_radius)) - 1.0).abs() < 1e-11);
        assert!(number(&receding.stiffness) > 0.0);
        for (proved, found) in certified.iter().zip(double) {
            assert!((number(&proved.stiffness) / number(&found.stiffness) - 1.0).abs() < 1e-11, "{ball}: {proved:?}");
        }
    }
}

/// The scene of another medium than the half-space, with w₁ = 1e-4 and w₂ = 1e-3.
fn on_medium(medium: &str, profile: &str, control: &str, output: &str) -> Scene {
    let text = format!(
        "[medium]\n{medium}\n[profile]\n{profile}\n[material]\ne_star = 1\n\
         work_of_adhesion = {{ advancing = \"1e-4\", receding = \"1e-3\" }}\n\
         [control]\n{control}\n[output]\n{output}\n"
    );
    Scene::from_toml(&text, "scene.toml", &no_files).unwrap()
}

const LOOP: [&str; 7] = ["start", "jump-in", "way-point", "pinned", "depinned", "detached", "end"];

/// Johnson's wave, E* = λ = 1, h₀ = 1/20, from its closed forms P = s − α√t and H = 1 − s + P ln s in thirty digits; the work of
/// the loop is a quadrature of them.
#[test]
fn a_loop_on_a_wave() {
    let (medium, profile) = ("kind = \"periodic\"\nwavelength = 1", "kind = \"wave\"\namplitude = \"0.05\"");
    let way = "kind = \"indentation\"\npath = [\"-0.02\", \"0.03\", \"-0.1\"]\nstart = \"detached\"";
    let found = path(&on_medium(medium, profile, way, "want = [\"path\"]\ndigits = 15"));
    assert_eq!(kinds(&found), LOOP);
    assert_eq!(found.events.promise, Promise::Certified);
    let free = event(&found, "depinned");
    assert_eq!(text(&free.contact_radius), "0.191481215204372");
    assert_eq!(text(&free.indentation), "0.0208179912589283");
    assert_eq!(text(&free.force), "0.0132562946835224");
    let off = event(&found, "detached");
    assert_eq!(text(&off.contact_radius), "0.0220619457468807");
    assert_eq!(text(&off.indentation), "-0.0185080605695416");
    assert_eq!(text(&off.force), "-0.0110297344257645");
    let balance = found.balance.as_ref().unwrap();
    let close = |value: f64, expected: f64| assert!((value / expected - 1.0).abs() < 1e-13, "{value} {expected}");
    close(balance.work.to_f64().unwrap(), 0.000_412_289_958_843_600_4);
    let Optional(Some(hysteresis)) = &balance.hysteresis else { panic!("lost by the edge") };
    close(hysteresis.to_f64().unwrap(), 0.000_344_666_187_367_87);
    let Optional(Some(jumps)) = &balance.jumps else { panic!("lost in jumps") };
    close(jumps.to_f64().unwrap(), 0.000_008_310_496_654_438_258 + 0.000_059_313_274_821_292_15);
    // A formula of the same wave, by quadrature, pinned in the same place.
    let formula = "kind = \"expression\"\nformula = \"0.05*(1 - cos(2*pi*r))\"";
    let found = path(&on_medium(medium, formula, way, "want = [\"path\"]\narithmetic = \"f64\""));
    assert_eq!(kinds(&found), LOOP);
    let free = event(&found, "depinned");
    close(number(&free.indentation), 0.020_817_991_258_928_298);
    close(number(&free.force), 0.013_256_294_683_522_414);
}

/// A cylinder against a reference at L = 3: δ = (2/π)∫arcosh(L/c) N' dc − (2/π) arcosh(L/b)√(2πwb), F = N − √(2πwb), N = πb²/4, by
/// quadrature and roots in thirty digits.
#[test]
fn a_loop_on_a_plane() {
    let (medium, profile) = ("kind = \"plane\"\nreference = 3", "kind = \"paraboloid\"\nradius = 1");
    let way = "kind = \"indentation\"\npath = [\"-0.02\", \"0.05\", \"-0.1\"]\nstart = \"detached\"";
    let found = path(&on_medium(medium, profile, way, "want = [\"path\"]\ndigits = 15"));
    assert_eq!(kinds(&found), LOOP);
    assert_eq!(found.events.promise, Promise::Certified);
    assert_eq!(text(&event(&found, "jump-in").to_contact_radius), "0.0932876644760892");
    let free = event(&found, "depinned");
    assert_eq!(text(&free.contact_radius), "0.194213182493735");
    assert_eq!(text(&free.indentation), "-0.00214981927694795");
    assert_eq!(text(&free.force), "-0.00530822431798296");
    let off = event(&found, "detached");
    assert_eq!(text(&off.indentation), "-0.0477372318431610");
    assert_eq!(text(&off.force), "-0.0165163086288629");
    let Optional(Some(lost)) = &off.hysteresis else { panic!("lost by the edge") };
    assert!((lost.to_f64().unwrap() / 0.000_349_583_728_488_722_5 - 1.0).abs() < 1e-13);
}

/// Under a dead load no depth is needed: the edge is pinned between N − √(2πw₁b) and N − √(2πw₂b), and on a machine between the
/// same forces.
#[test]
fn a_line_under_a_dead_load_is_pinned() {
    let profile = "kind = \"paraboloid\"\nradius = 1";
    let way = "kind = \"force\"\npath = [\"-0.001\", \"0.05\", \"-0.1\"]\nstart = \"largest\"";
    let found = path(&on_medium("kind = \"plane\"", profile, way, "want = [\"path\"]\narithmetic = \"f64\""));
    assert_eq!(found.events.items.last().unwrap().event.name(), "end");
    let free = found.events.items.iter().rfind(|event| event.event.name() == "depinned").unwrap();
    let b = number(&free.contact_radius);
    let load = |w: f64| std::f64::consts::PI * b * b / 4.0 - (2.0 * std::f64::consts::PI * w * b).sqrt();
    assert!((load(1e-4) / 0.05 - 1.0).abs() < 1e-13, "{b} {}", load(1e-4));
    assert!((load(1e-3) / number(&free.force) - 1.0).abs() < 1e-12, "{b} {} {:?}", load(1e-3), free.force);
}

/// A dimple of 10³⁰⁰ m around a contact of one metre: its gap is constant over hundreds of octaves, and is looked at within the
/// budget.
#[test]
fn a_gap_that_is_constant_over_hundreds_of_octaves() {
    let dimple = "kind = \"elliptical-dimple\"\nradius = \"1e300\"\ndepth = \"2.231253598738975\"";
    let way = "kind = \"indentation\"\npath = [\"-0.7\", \"-1\"]\nstart = \"0.7\"";
    let scene = scene(dimple, ["0.03", "0.16"], way, "want = [\"path\"]\narithmetic = \"f64\"").unwrap();
    assert_eq!(kinds(&path(&scene)), ["start", "not-admissible"]);
}

/// A way point 10⁻⁴⁰ m below the start, which radii of 12 digits do not tell apart: the edge has receded by 10⁻⁴⁰/d' all the same.
#[test]
fn an_edge_that_hardly_recedes_loses_something() {
    let way = "kind = \"indentation\"\npath = [\"0.1\", \"0.0999999999999999999999999999999999999999\", \"0.1\"]";
    let found = path(&scene(BALL, ["0.01", "0.04"], way, "want = [\"path\"]\ndigits = 12").unwrap());
    let lost = |event: &PathEvent| match &event.hysteresis {
        Optional(Some(Value::Known(lost))) => lost.to_string().parse::<f64>().unwrap(),
        other => panic!("{other:?}"),
    };
    // d = a² − Δl with Δl² = 2πa w₂, by Newton's iteration.
    let elongation = |a: f64| (0.08 * PI * a).sqrt();
    let slope = |a: f64| 2.0 * a - elongation(a) / (2.0 * a);
    let a = (0..20).fold(1.0, |a, _| a - (a * a - elongation(a) - 0.1) / slope(a));
    let expected = 0.03 * 2.0 * PI * a * 1e-40 / slope(a);
    let way_point = event(&found, "way-point");
    assert!((lost(way_point) / expected - 1.0).abs() < 1e-10, "{} {expected}", lost(way_point));
    // On the way back it is pinned.
    assert_eq!([event(&found, "pinned"), event(&found, "end")].map(lost), [0.0, 0.0]);
}

/// Loads that move the edge less than a double is rounded: what it loses is not 0, and the force is what it was said to be.
#[test]
fn doubles_do_not_call_a_loss_nothing() {
    let load = "kind = \"force\"\npath = [\"1e-20\", \"-1e-20\"]";
    let output = "want = [\"path\", \"energy\"]\narithmetic = \"f64\"";
    let answer = scene(BALL, ["0.01", "0.04"], load, output).unwrap().solve().unwrap();
    let end = event(answer.path().unwrap(), "end").clone();
    assert!(matches!(end.hysteresis, Optional(Some(Value::Unknown { status: Status::Undecided, .. }))), "{end:?}");
    let state = &answer.energy().unwrap().items[0].items[0].state;
    assert_eq!(state.force.to_f64(), Some(1e-20));
}

/// A path that begins pinned, and stays so, loses nothing, and that is known in doubles too.
#[test]
fn a_start_that_is_pinned_loses_nothing() {
    let way = "kind = \"indentation\"\npath = [\"0.05\", \"0\", \"0.05\"]\nstart = \"0.5\"";
    for arithmetic in ["", "\narithmetic = \"f64\""] {
        let output = format!("want = [\"path\", \"force-curve\"]\npoints = 9{arithmetic}");
        let answer = scene(BALL, ["0.01", "0.04"], way, &output).unwrap().solve().unwrap();
        assert_eq!(kinds(answer.path().unwrap()), ["start", "way-point", "end"]);
        let by_edge = answer.path().unwrap().events.items.iter().map(|event| event.hysteresis.0.clone());
        for lost in by_edge.chain([answer.force_curve().unwrap().summary.hysteresis.clone()]) {
            assert!(matches!(&lost, Some(Value::Known(lost)) if lost.to_string() == "0"), "{arithmetic} {lost:?}");
        }
    }
}

/// A power 3/2 breaks at the depth 0 under a dead load, exactly, at either work of adhesion.
#[test]
fn a_power_of_three_halves_breaks_at_zero_depth() {
    let power = "kind = \"power\"\nn = 1.5\nc = 1";
    let load = "kind = \"force\"\npath = [\"1\", \"-1\"]";
    let answer = scene(power, ["0.01", "0.04"], load, "want = [\"path\", \"folds\"]").unwrap().solve().unwrap();
    let detached = event(answer.path().unwrap(), "detached");
    assert_eq!(detached.indentation.as_ref().map(ToString::to_string).as_deref(), Some("0"));
    let folds = &answer.folds().unwrap().items;
    assert!(folds.len() == 2 && folds.iter().all(|fold| fold.indentation.to_string() == "0"), "{folds:?}");
}
