//! One contact at arrays of values: the closed form against the search, and histories against single states.

use mdr::columns::{Choice, ContactColumns, States};
use mdr::prelude::*;

fn contact(shape: Shape<&str>) -> ContactColumns {
    let elasticity = Elasticity::effective("1").expect("positive");
    ContactColumns::new(&Scene::new(shape, elasticity, "1e-3").expect("a scene")).expect("a contact")
}

/// r²/2R as a power law, and as a sum of one term, which has no closed form here.
fn ball_in_two_ways() -> [ContactColumns; 2] {
    let scene = r#"{"profile": {"kind": "sum", "term": [{"kind": "paraboloid", "radius": 1}]},
        "material": {"e_star": 1, "work_of_adhesion": "1e-3"}, "output": {"want": ["folds"]}}"#;
    let sum = Scene::from_json(scene, "sum.json", &mdr::no_files).expect("a scene");
    [contact(Shape::Paraboloid { radius: "1" }), ContactColumns::new(&sum).expect("a contact")]
}

fn same(one: &[f64], other: &[f64]) {
    assert_eq!(one.len(), other.len());
    for (one, other) in one.iter().zip(other) {
        let near = (one - other).abs() <= 1e-9 * one.abs().max(1e-6);
        assert!(near || one.is_nan() && other.is_nan(), "{one} {other}");
    }
}

#[test]
fn the_closed_form_and_the_search_agree() {
    let [law, searched] = ball_in_two_ways();
    let values = [-1.0, -4e-3, -1e-3, 0.0, 1e-3, f64::NAN];
    for control in [Control::Indentation, Control::Force] {
        let [one, other] = [&law, &searched].map(|ball| ball.equilibria(&control, &values).expect("equilibria"));
        assert_eq!((&one.stable, &one.status), (&other.stable, &other.status));
        assert_eq!(one.admissible, other.admissible);
        for (i, value) in values[..5].iter().enumerate() {
            let at_value = law.equilibria_at(&control, *value).expect("equilibria");
            let known: Vec<_> =
                one.contact_radius.iter().skip(i).step_by(values.len()).filter(|a| !a.is_nan()).collect();
            assert_eq!(known.len(), at_value.len());
            for (state, a) in at_value.iter().zip(known) {
                same(&[state.contact_radius], &[*a]);
            }
        }
        same(&one.contact_radius, &other.contact_radius);
        same(&one.indentation, &other.indentation);
        same(&one.force, &other.force);
        let [one, other] =
            [&law, &searched].map(|ball| ball.states(&control, &values, Choice::Largest).expect("states"));
        assert_eq!(one.status, other.status);
        assert_eq!((one.status[0], one.status[5]), (Status::NoEquilibrium, Status::DomainError));
        same(&one.force, &other.force);
    }
}

#[test]
fn a_history_is_made_of_states() {
    let [ball, _] = ball_in_two_ways();
    let control = Control::machine(0.1).expect("positive");
    let values: Vec<f64> = (0..40).map(|step| 0.1 - 0.01 * f64::from(step)).collect();
    let history = ball.follow(&control, &values, &Start::Largest).expect("a history");
    assert_eq!(history.jumps.iter().map(|event| event.kind).collect::<Vec<_>>(), [EventKind::Detached]);
    let alone = ball.states(&control, &values, Choice::Largest).expect("states");
    for (i, value) in values.iter().enumerate() {
        if *value > history.jumps[0].value {
            same(&history.states.force[i..=i], &alone.force[i..=i]);
        } else {
            assert_eq!((history.states.force[i], history.states.status[i]), (0.0, Status::Ok));
        }
    }
    let off = ball.pull_off(&control).expect("it comes off");
    assert_eq!(history.jumps[0].before.contact_radius, off.contact_radius);
}

#[test]
fn a_path_that_cannot_go_on_has_no_more_states() {
    // Pressed on, the surfaces touch at the next crest.
    let waves = contact(Shape::WavyParaboloid { radius: "1", amplitude: "1e-2", wavelength: "0.1" });
    let history = waves.follow(&Control::Indentation, &[-1.0, 0.0, 0.1], &Start::Detached).expect("a history");
    assert_eq!(history.states.status.last(), Some(&Status::NotAdmissible));
    assert!(history.states.force[2].is_nan());
    // What is known of the contact by now serves the same question, and no other control.
    for control in [Control::Indentation, Control::Force, Control::Indentation] {
        let ask = |waves: &ContactColumns| {
            let history = waves.follow(&control, &[-1.0, 0.0, 0.1], &Start::Detached).expect("a history");
            // As text: a depth that is not known is NaN, which is not equal to itself.
            format!("{:?}", (history.jumps, history.states))
        };
        let anew = contact(Shape::WavyParaboloid { radius: "1", amplitude: "1e-2", wavelength: "0.1" });
        assert_eq!(ask(&waves), ask(&anew));
    }
}

#[test]
fn a_stopped_contact_answers_nothing() {
    let [_, ball] = ball_in_two_ways();
    let stop = Stop::default();
    stop.stop();
    let stopped = Err(mdr::ContactError::Stopped);
    assert_eq!(ball.until(&stop).states(&Control::Force, &[0.0], Choice::Largest), stopped);
    assert!(ball.states(&Control::Force, &[0.0], Choice::Largest).is_ok(), "others go on");
}

#[test]
fn the_edge_is_in_balance_in_the_equilibria_and_nowhere_else() {
    let ball = contact(Shape::Paraboloid { radius: "1" });
    for control in [Control::Indentation, Control::Force, Control::machine(0.1).expect("positive")] {
        let found = ball.equilibria(&control, &[1e-3]).expect("equilibria");
        for (branch, a) in found.contact_radius.iter().enumerate().filter(|(_, a)| !a.is_nan()) {
            let around = [0.99 * a, *a, 1.01 * a];
            let balance = ball.balance(&control, 1e-3, &around).expect("a balance");
            let beyond = |i: usize| balance.excess[i] - balance.elongation[i];
            assert!(beyond(1).abs() < 1e-12 * balance.elongation[1], "{control:?}");
            same(&balance.indentation[1..2], &found.indentation[branch..=branch]);
            // A stable contact shrinks when it is too large (1.8), and grows when it is too small (1.9).
            let stable = found.stable[branch];
            assert_eq!([beyond(0) < 0.0, beyond(2) > 0.0], [stable; 2], "{control:?}");
            let stability = ball.stability(&control, &[*a]).expect("stability");
            assert_eq!(stability, [Some(if stable { Stability::Stable } else { Stability::Unstable })]);
        }
    }
}

#[test]
fn outside_of_the_profile_there_is_no_balance() {
    let ball = contact(Shape::Sphere { radius: "1" });
    let control = Control::Indentation;
    let radii = [-1.0, 0.0, 0.5, 1.5];
    let balance = ball.balance(&control, 0.0, &radii).expect("a balance");
    assert_eq!(balance.excess.iter().map(|x| !x.is_nan()).collect::<Vec<_>>(), [false, false, true, false]);
    let stability = ball.stability(&control, &radii).expect("stability");
    assert_eq!(stability.iter().map(Option::is_some).collect::<Vec<_>>(), [false, false, true, false]);
    assert!(ball.balance(&control, f64::NAN, &radii).is_err());
}

/// A scene on a medium, from its tables in JSON.
fn on_medium(medium: &str, profile: &str, work: &str) -> Result<ContactColumns, mdr::Error> {
    let text = format!(
        r#"{{"profile": {profile}, "medium": {medium}, "material": {{"e_star": 1, "work_of_adhesion": "{work}"}},
            "output": {{"want": ["transform"], "transform": {{"at": ["0.1"]}}}}}}"#
    );
    let text = if medium.contains("graded") || medium.contains("winkler") {
        text.replace("\"e_star\": 1, ", "")
    } else {
        text
    };
    ContactColumns::new(&Scene::from_json(&text, "medium.json", &mdr::no_files)?)
}

const BALL: &str = r#"{"kind": "paraboloid", "radius": 1}"#;

/// The pull-off forces and depths of MEDIA in columns: −(3 + k)/2 πwR of a ball, −3(πE*w²R/16)^(1/3) of a cylinder, and Johnson's
/// wave at α = 0.3.
#[test]
fn columns_on_other_media() {
    let pi = std::f64::consts::PI;
    let wave = r#"{"kind": "wave", "amplitude": 1}"#;
    let alpha = "0.44413219804902113784755209499442680108911647332584";
    let contacts = [
        (r#"{"kind": "graded", "exponent": "0.3", "coefficient": 1}"#, BALL, "1/100", -1.65e-2 * pi),
        (r#"{"kind": "winkler", "modulus": 7}"#, BALL, "1/100", -2e-2 * pi),
        (r#"{"kind": "plane"}"#, BALL, "1/100", -0.080_934_039_696_447_47),
        (r#"{"kind": "plane", "reference": 10}"#, BALL, "1/100", -0.080_934_039_696_447_47),
        (r#"{"kind": "periodic", "wavelength": 1}"#, wave, alpha, -0.301_417_048_312_055_9),
    ];
    let load = Control::Force;
    for (medium, profile, work, expected) in contacts {
        let contact = on_medium(medium, profile, work).expect(medium);
        let fold = &contact.folds(&load).expect(medium)[0];
        assert!((fold.force / expected - 1.0).abs() < 1e-11, "{medium} {} {expected}", fold.force);
        let values = [1.5 * expected, 0.5 * expected, 0.0];
        let states = contact.states(&load, &values, Choice::Largest).expect(medium);
        assert_eq!(states.status, [Status::NoEquilibrium, Status::Ok, Status::Ok], "{medium}");
        // The state of the curve at that radius, by which a half-width is not taken for a size.
        let again = contact.curve(&states.contact_radius[1..]).expect(medium);
        for (force, value) in again.force.iter().zip(&values[1..]) {
            assert!((force - value).abs() < 1e-9 * expected.abs(), "{medium}");
        }
        let both = contact.equilibria(&load, &values[1..2]).expect(medium);
        assert!(both.contact_radius.contains(&states.contact_radius[1]) && both.admissible[0], "{medium}");
        let pulled = contact.pull_off(&load).expect(medium);
        assert!((pulled.contact_radius / fold.contact_radius - 1.0).abs() < 1e-6, "{medium}");
        let pressures = contact.field(mdr::answer::Field::Pressure, states.contact_radius[1], &[0.0]).expect(medium);
        assert!(pressures[0].is_finite(), "{medium}");
        let history = contact.follow(&load, &values[1..], &Start::Largest).expect(medium);
        same(&history.states.contact_radius, &states.contact_radius[1..]);
    }
}

/// A line contact without a reference has no depth: not 0, but NaN, and as a control it is refused.
#[test]
fn a_line_contact_without_a_reference_has_no_depths() {
    let line = on_medium(r#"{"kind": "plane"}"#, BALL, "1/100").expect("a contact");
    let states = line.states(&Control::Force, &[0.0], Choice::Largest).expect("states");
    assert!(states.indentation[0].is_nan() && states.contact_radius[0] > 0.0);
    let why = line.states(&Control::Indentation, &[0.0], Choice::Largest).expect_err("no depth").to_string();
    assert!(why.contains("reference"), "{why}");
    let why = on_medium(r#"{"kind": "periodic", "wavelength": 1}"#, BALL, "1").err().expect("no period").to_string();
    assert!(why.contains("not periodic"), "{why}");
}

/// Values between `low` and `high` in no order, and a quarter of them ever closer to the first fold.
fn scattered(len: usize, [low, high]: [f64; 2], fold: f64) -> Vec<f64> {
    let value = |i: usize| {
        let share = i as f64 * 0.618_033_988_749_894_9 % 1.0;
        if i.is_multiple_of(4) { fold + fold.abs() * 1e-12f64.powf(share) } else { low + (high - low) * share }
    };
    (0..len).map(value).collect()
}

/// Shapes with a fold, with folds between, with kinks, an equator and a vertical edge.
fn many() -> Vec<ContactColumns> {
    vec![
        contact(Shape::Hyperboloid { flank: Flank::Slope("1"), lateral: "0.3" }),
        contact(Shape::Sphere { radius: "1" }),
        contact(Shape::RoundedPunch { radius: "1", flat: "0.2" }),
        contact(Shape::WavyParaboloid { radius: "1", amplitude: "5e-4", wavelength: "0.1" }),
        contact(Shape::WavyParaboloid { radius: "1", amplitude: "1e-2", wavelength: "0.1" }),
        contact(Shape::FlatPunch { radius: "1" }),
    ]
}

#[test]
fn a_long_column_has_the_states_of_short_ones() {
    let mut seen = std::collections::BTreeSet::new();
    for (shape, contact) in many().iter().enumerate() {
        for control in [Control::Indentation, Control::Force, Control::machine(0.1).expect("positive")] {
            let folds = contact.folds(&control).expect("folds");
            let at_folds: Vec<f64> =
                folds.iter().map(|fold| control.controlled(&fold.indentation, &fold.force)).collect();
            let low = at_folds.iter().copied().fold(-1e-4, f64::min);
            let first = at_folds.first().copied().unwrap_or(low);
            let mut values = scattered(1100, [1.2 * low, -5.0 * low], first);
            values[7] = f64::NAN;
            for choice in [Choice::Largest, Choice::Smallest] {
                let long = contact.states(&control, &values, choice).expect("states");
                for (block, values) in values.chunks(550).enumerate().map(|(i, block)| (550 * i, block)) {
                    let short = contact.states(&control, values, choice).expect("states");
                    for (i, value) in values.iter().enumerate() {
                        let row = |states: &States, i: usize| {
                            [states.contact_radius[i], states.indentation[i], states.force[i]]
                        };
                        let (one, other) = (row(&long, block + i), row(&short, i));
                        assert_eq!(long.status[block + i], short.status[i], "shape {shape}, {control:?} at {value}");
                        seen.insert(format!("{:?}", short.status[i]));
                        // Half of the digits at the fold.
                        let near = at_folds.iter().map(|fold| (value - fold).abs() / low.abs()).fold(1.0, f64::min);
                        let close = |one: f64, other: f64, scale: f64| {
                            one == other
                                || one.is_nan() && other.is_nan()
                                || (one - other).abs() < 1e-14 * scale / near.sqrt()
                        };
                        assert!(
                            close(one[0], other[0], other[0]),
                            "shape {shape}, {control:?} at {value}: {one:?} {other:?}"
                        );
                        assert!(close(one[1], other[1], 1.0) && close(one[2], other[2], 1.0), "{one:?} {other:?}");
                    }
                }
            }
        }
    }
    assert_eq!(seen.into_iter().collect::<Vec<_>>(), ["DomainError", "NoEquilibrium", "NotAdmissible", "Ok"]);
}

#[test]
fn a_long_history_has_the_events_of_a_path() {
    for (shape, contact) in many().iter().enumerate() {
        for control in [Control::Indentation, Control::Force, Control::machine(0.1).expect("positive")] {
            let folds = contact.folds(&control).expect("folds");
            let low = folds.iter().map(|fold| control.controlled(&fold.indentation, &fold.force)).fold(-1e-4, f64::min);
            // Three times to and fro, with noise.
            let value = |i: usize| {
                let phase = i as f64 / 400.0;
                let way = 2.0 * (phase - (phase + 0.5).floor()).abs();
                -4.0 * low * (1.0 - 1.4 * way) + 0.01 * low * (i as f64 * 0.618_033_988_749_894_9 % 1.0)
            };
            let values: Vec<f64> = (0..1100).map(value).collect();
            for start in [Start::Largest, Start::Smallest] {
                let history = contact.follow(&control, &values, &start);
                let (Ok(history), Ok(path)) = (&history, contact.path(&control, &values, &start, 0)) else {
                    assert!(history.is_err(), "shape {shape}");
                    continue;
                };
                let (arrivals, jumps): (Vec<_>, Vec<_>) = path
                    .events
                    .into_iter()
                    .partition(|event| matches!(event.kind, EventKind::Start | EventKind::WayPoint | EventKind::End));
                assert_eq!(format!("{:?}", history.jumps), format!("{jumps:?}"), "shape {shape}, {control:?}");
                assert_eq!(history.states.status.len(), values.len());
                for (i, arrival) in arrivals.iter().enumerate().take(values.len()) {
                    let (one, other) = (history.states.contact_radius[i], arrival.after.contact_radius);
                    assert!(
                        (one - other).abs() <= 1e-12 * other || one.is_nan() && other.is_nan(),
                        "{i}: {one} {other}"
                    );
                }
                let known = history.states.status.iter().filter(|status| **status == Status::Ok).count();
                assert!(known <= arrivals.len(), "shape {shape}, {control:?}");
            }
        }
    }
}

/// A path that starts at a contact radius starts there on waves too, of which half of a period is the most.
#[test]
fn a_start_on_waves_is_a_half_width() {
    let scene = r#"{"profile": {"kind": "wave", "amplitude": "0.2"}, "medium": {"kind": "periodic", "wavelength": 1},
        "material": {"e_star": 1, "work_of_adhesion": "1e-2"}, "output": {"want": ["folds"]}}"#;
    let waves = ContactColumns::new(&Scene::from_json(scene, "waves.json", &mdr::no_files).expect("a scene"));
    let waves = waves.expect("a contact");
    let start = |radius: f64| waves.follow(&Control::Force, &[0.1], &Start::Nearest(radius));
    let stable = waves.states(&Control::Force, &[0.1], Choice::Largest).expect("states").contact_radius[0];
    same(&start(stable).expect("a history").states.contact_radius, &[stable]);
    let refused = [start(0.5).map(|_| ()), waves.path(&Control::Force, &[0.1], &Start::Nearest(0.7), 0).map(|_| ())];
    for why in refused.map(|refused| refused.expect_err("more than half of a period").to_string()) {
        assert!(why.contains("half of the wavelength"), "{why}");
    }
}

/// A search for folds that is not resolved leaves open whether there is a state to start from: elliptical dimples on graded
/// half-spaces.
#[test]
fn a_start_is_not_denied_where_folds_may_be_missing() {
    let dimple = r#"{"kind": "elliptical-dimple", "depth": "0.090283", "radius": "4.9249"}"#;
    let soil = r#"{"kind": "graded", "exponent": "-0.5", "coefficient": "163480000"}"#;
    let contact = on_medium(soil, dimple, "12802000").expect("a contact");
    let machine = Control::machine(28_603_000.0).expect("positive");
    let states = contact.states(&machine, &[0.246_725], Choice::Largest).expect("states");
    assert_eq!(states.status, [Status::Undecided]);
    let why = contact.follow(&machine, &[0.246_725, 0.1], &Start::Largest).expect_err("no start").to_string();
    assert!(why.contains("not resolved everywhere"), "{why}");
}

/// The distance of the reference over a half-width may be beyond the root of the largest double: there is no state there.
#[test]
fn a_line_contact_has_no_states_beyond_the_range_of_squares() {
    let dimple = r#"{"kind": "parabolic-dimple", "depth": "0.0012885", "radius": "1.0264"}"#;
    let line = on_medium(r#"{"kind": "plane", "reference": 1000}"#, dimple, "3.3226166684e-4").expect("a contact");
    let found = line.equilibria(&Control::Indentation, &[-0.243_558]).expect("equilibria");
    let radii: Vec<f64> = found.contact_radius.into_iter().filter(|a| !a.is_nan()).collect();
    assert!(radii.len() == 2 && radii[0] > 1.0, "{radii:?}");
    // (2/π)(L/b) is its slope: d = N (2/π) ln(2L/b) there, and not infinite.
    let ball = on_medium(r#"{"kind": "plane", "reference": 1000}"#, BALL, "1/100").expect("a contact");
    let state = ball.curve(&[1e-160]).expect("a state");
    let per_force = 2.0 / std::f64::consts::PI * (2e3_f64.ln() - 1e-160_f64.ln());
    assert!((state.indentation[0] / (state.force[0] * per_force) - 1.0).abs() < 1e-12, "{state:?}");
}
