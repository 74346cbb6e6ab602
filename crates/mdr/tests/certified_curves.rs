//! Force curves with every digit proved.

#![cfg(all(feature = "mp", feature = "toml"))]

use mdr::answer::ForceSample;
use mdr::no_files;
use mdr::prelude::*;

/// A scene with E* = 1, or on a medium, in 20 certified digits.
fn certified(work: &str, profile: &str, control: &str, output: &str) -> Answer {
    let text = format!(
        "[material]\ne_star = 1\nwork_of_adhesion = {work}\n[profile]\n{profile}\n[control]\n{control}\n[output]\ndigits = 20\n{output}\n"
    );
    Scene::from_toml(&text, "scene.toml", &no_files).expect("a good scene").solve().expect("an answer")
}

const LOOPS: [&str; 3] = [
    "kind = \"indentation\"\npath = [-0.01, 0.01, -0.1]\nstart = \"detached\"",
    "kind = \"machine\"\nstiffness = 0.1\npath = [-0.01, 0.01, -0.1]\nstart = \"detached\"",
    "kind = \"force\"\npath = [1e-3, -1e-3]",
];

/// Every digit of a sample whose place was chosen is that of an equilibrium at the value that it tells, which other routes find: the closed
/// forms of power laws, and the list of all equilibria.
#[test]
fn samples_are_equilibria_to_the_last_digit() {
    let profiles =
        ["kind = \"paraboloid\"\nradius = 1", "kind = \"sphere\"\nradius = 1", "kind = \"power\"\nn = 3.3\nc = 2"];
    for (profile, control) in profiles.iter().flat_map(|profile| LOOPS.map(|control| (profile, control))) {
        let answer = certified("1e-4", profile, control, "want = [\"force-curve\"]\npoints = 60");
        let curve = answer.force_curve().expect("wanted");
        assert_eq!(curve.samples.promise, Promise::Certified, "{profile} {control}");
        let held = |sample: &ForceSample| {
            let value = match control {
                _ if control.contains("machine") => sample.position.0.as_ref(),
                _ if control.contains("force") => Some(&sample.force),
                _ => sample.indentation.as_ref(),
            };
            value.expect("it is controlled").to_string()
        };
        let samples = &curve.samples.items;
        let touching: Vec<&ForceSample> = samples.iter().filter(|sample| sample.contact_radius.is_some()).collect();
        let values: Vec<String> = touching.iter().map(|sample| format!("\"{}\"", held(sample))).collect();
        let at = format!("want = [\"equilibria\"]\nequilibria = {{ at = [{}] }}", values.join(", "));
        let answer = certified("1e-4", profile, control, &at);
        let found = &answer.equilibria().expect("wanted").items;
        let mut compared = 0;
        for (sample, at) in touching.iter().zip(found) {
            // The value of a fold has more digits than are printed.
            let is_short = held(sample).trim_end_matches('0').len() < 16 || held(sample).contains("0000000e");
            if !is_short {
                continue;
            }
            let told = |value: &Option<Value>| value.as_ref().map(Value::to_string);
            let same = at.items.iter().any(|state| {
                Some(state.contact_radius.to_string()) == told(&sample.contact_radius)
                    && Some(state.indentation.to_string()) == told(&sample.indentation)
                    && state.force.to_string() == sample.force.to_string()
            });
            assert!(same, "{profile} {control}: {sample:?}");
            compared += 1;
        }
        assert!(compared > 8, "{profile} {control}: {compared}");
    }
}

/// All numbers of a force curve are proved, its hysteresis is what the path dissipates, and no number depends on how many samples there are.
#[test]
fn force_curves_are_certified() {
    let profiles = [
        "kind = \"cone\"\nslope = 0.3",
        "kind = \"flat-punch\"\nradius = 0.1",
        "kind = \"wavy-paraboloid\"\nradius = 1\namplitude = 5e-4\nwavelength = 0.1",
        "kind = \"truncated-cone\"\nslope = 0.2\nflat = 0.1",
        "kind = \"expression\"\nformula = \"r^2/2 + r^4\"",
    ];
    let works = ["1e-4", "{ advancing = 3e-5, receding = 1e-4 }"];
    for (profile, work) in profiles.iter().flat_map(|profile| works.map(|work| (profile, work))) {
        for control in LOOPS {
            let case = format!("{profile} {work} {control}");
            let [coarse, fine] = [2, 30].map(|points| {
                let output = format!("want = [\"force-curve\", \"path\"]\npoints = {points}");
                certified(work, profile, control, &output)
            });
            let [one, other] = [&coarse, &fine].map(|answer| answer.force_curve().expect("wanted"));
            assert_eq!(one.summary, other.summary, "{case}");
            assert_eq!((one.samples.promise, one.energy), (Promise::Certified, None), "{case}");
            let path = coarse.path().expect("wanted");
            let lost = path.balance.as_ref().map(|balance| balance.dissipated.clone());
            assert_eq!(one.summary.hysteresis, lost, "{case}");
            assert!(other.samples.items.iter().all(|sample| sample.force.to_f64().is_some()), "{case}");
        }
    }
}

/// The least force on a path of a paraboloid is −(3/2)πwR, wherever its contact breaks; under a dead load it is the last.
#[test]
fn the_minimum_force_of_a_paraboloid_is_proved() {
    for control in LOOPS {
        let answer =
            certified("1e-4", "kind = \"paraboloid\"\nradius = 1", control, "want = [\"force-curve\"]\npoints = 2");
        let summary = &answer.force_curve().expect("wanted").summary;
        let least = summary.minimum_force.as_ref().expect("a force").to_string();
        assert_eq!(least, "-0.00047123889803846898577", "{control}");
    }
}

/// On a Winkler foundation held at its depth a flat is neutral; between two works of adhesion a force passes exactly through nothing, which no
/// precision decides: that sample is left out, and no other.
#[test]
fn flats_on_other_media() {
    let flat = "kind = \"flat-punch\"\nradius = 1e-3\n";
    let winkler = format!("{flat}[medium]\nkind = \"winkler\"\nmodulus = 1e6");
    let answer = certified("1e-4", &winkler, LOOPS[0], "want = [\"force-curve\", \"path\"]\npoints = 20");
    assert_eq!(answer.path().expect("wanted").events.promise, Promise::Certified);
    assert_eq!(answer.force_curve().expect("wanted").samples.promise, Promise::Certified);
    let graded = format!("{flat}[medium]\nkind = \"graded\"\nexponent = 0.3\ncoefficient = 1e3");
    let works = "{ advancing = 1e-5, receding = 1e-4 }";
    let control = "kind = \"indentation\"\npath = [1e-3, -1e-3, 1e-3]";
    let answer = certified(works, &graded, control, "want = [\"force-curve\"]\npoints = 40");
    let curve = answer.force_curve().expect("wanted");
    assert_eq!(curve.samples.promise, Promise::Certified);
    assert!(curve.samples.items.len() > 20 && curve.samples.items.iter().all(|sample| sample.force.to_f64().is_some()));
}

/// A path may begin where the surfaces touch, so that two events are at one value. The force on a flat between two works of adhesion that is
/// brought to nothing is exactly that, and so is its depth: no precision decides it, and the curve is that of f64.
#[test]
fn events_may_be_at_one_value() {
    let ways = [
        "kind = \"indentation\"\npath = [0, 0.02, -0.1]",
        "kind = \"machine\"\nstiffness = 0.1\npath = [0, 0.02, -0.1]",
        "kind = \"force\"\npath = [0, 1e-3, 0, -1]",
    ];
    let works = ["1e-4", "{ advancing = 3e-5, receding = 1e-4 }", "{ advancing = 0, receding = 1e-4 }"];
    for (way, work) in ways.iter().flat_map(|way| works.map(|work| (way, work))) {
        let control = format!("{way}\nstart = \"detached\"");
        for profile in [
            "kind = \"paraboloid\"\nradius = 1",
            "kind = \"sphere\"\nradius = 1",
            "kind = \"flat-punch\"\nradius = 0.1",
        ] {
            let answer = certified(work, profile, &control, "want = [\"force-curve\"]\npoints = 20");
            let curve = answer.force_curve().expect("wanted");
            let is_known = |sample: &ForceSample| sample.force.to_f64().is_some();
            assert!(curve.samples.items.iter().all(is_known), "{profile} {control} {work}");
            let is_open = profile.contains("flat") && way.contains("force") && work.contains("advancing");
            let expected = if is_open { Promise::F64 } else { Promise::Certified };
            assert_eq!(curve.samples.promise, expected, "{profile} {control} {work}");
        }
    }
}
