//! Force curves in f64: samples and summaries.

use mdr::answer::{ForceCurve, ForceSample};
use mdr::no_files;
use mdr::prelude::*;

/// A cantilever takes a sphere into contact and off again: the curve breaks where the path jumps, and every sample lies on the
/// straight line of the machine, D = d + F/k.
#[test]
fn a_force_curve_is_the_path_as_it_is_measured() {
    let (k, stiffness) = (0.1, "0.1".parse().expect("a number"));
    let tip = Shape::Paraboloid { radius: "1e-6" };
    let scene = Scene::new(tip, Elasticity::effective("1e6").expect("a number"), "0.05")
        .and_then(|scene| scene.control(Control::Machine { stiffness }).path(["-1e-6", "1e-6", "-3e-6"]))
        .expect("a scene")
        .start(Start::Detached)
        .want(Want::ForceCurve { points: 100 })
        .arithmetic(Arithmetic::F64);
    let answer = scene.solve().expect("an answer");
    let curve = answer.force_curve().expect("wanted");
    let number = |value: &Option<Value>| value.as_ref().and_then(Value::to_f64);
    let samples = &curve.samples.items;
    assert!((100..120).contains(&samples.len()), "{}", samples.len());
    for sample in samples {
        let force = sample.force.to_f64().expect("a force");
        let [position, indentation] =
            [&sample.position.0, &sample.indentation].map(|value| number(value).expect("known"));
        assert!((position - indentation - force / k).abs() < 1e-20, "{sample:?}");
        assert_eq!(force == 0.0, sample.contact_radius.is_none());
    }
    let segments: Vec<_> = samples.iter().map(|sample| (sample.segment, sample.direction)).collect();
    assert_eq!((segments[0], segments[samples.len() - 1]), ((1, "approach"), (4, "retract")));
    // The softest machine breaks at the dead load of JKR, this one a little later; it jumps in at D = 0.
    let pull_off = number(&curve.summary.pull_off_force).expect("it breaks");
    let jkr = -1.5 * std::f64::consts::PI * 0.05 * 1e-6;
    assert!(pull_off > jkr && pull_off < 0.99 * jkr, "{pull_off:e}");
    assert!(number(&curve.summary.minimum_force).expect("known") <= pull_off);
    assert!(number(&curve.summary.jump_in_force).is_some_and(|force| force < 0.0));
    assert!(number(&curve.summary.hysteresis).is_some_and(|energy| energy > 0.0));
}

fn number(value: &Option<Value>) -> f64 {
    value.as_ref().and_then(Value::to_f64).unwrap_or_else(|| panic!("{value:?}"))
}

/// The force curve of a contact with E* = 1 and w = 10⁻⁴.
fn force_curve(profile: &str, control: &str, points: u32) -> ForceCurve {
    let text = format!(
        "[material]\ne_star = 1\nwork_of_adhesion = 1e-4\n[profile]\n{profile}\n[control]\n{control}\n\
         [output]\nwant = [\"force-curve\"]\npoints = {points}\n"
    );
    let scene = Scene::from_toml(&text, "scene.toml", &no_files).expect("a good scene").arithmetic(Arithmetic::F64);
    scene.solve().expect("an answer").force_curve().expect("wanted").clone()
}

/// Power laws held at their depth and by machines, soft and stiff, with the curve sampled coarsely and finely: the minimum is
/// that of F = 2E*a(n/(n + 1) κ C aⁿ − √(2πaw/E*)), where its slope vanishes, if the path passes it.
#[test]
fn the_minimum_force_of_a_power_law() {
    use std::f64::consts::PI;
    // κ_n = (√π/2) n Γ(n/2)/Γ((n + 1)/2).
    for (n, kappa) in [(1.0, PI / 2.0), (1.5, 1.797_210_352_103_388_3), (2.0, 2.0), (3.0, 0.75 * PI)] {
        let (slope, root) = (kappa * 0.3, (2.0 * PI * 1e-4_f64).sqrt());
        let force = |a: f64| 2.0 * a * (n / (n + 1.0) * slope * a.powf(n) - root * a.sqrt());
        // n κ C aⁿ⁻¹ = 3√(πw/2E*a).
        let exact = force((1.5 * root / (n * slope)).powf(1.0 / (n - 0.5)));
        let machines = ["0.001", "0.1", "1", "1000"].map(|k| format!("kind = \"machine\"\nstiffness = {k}"));
        for held in ["kind = \"indentation\"".to_owned()].into_iter().chain(machines) {
            let profile = format!("kind = \"power\"\nn = {n}\nc = 0.3");
            let cycle = format!("{held}\npath = [-0.5, 0.5, -20]\nstart = \"detached\"");
            for points in [2, 30, 400] {
                let summary = force_curve(&profile, &cycle, points).summary;
                // Some roundings of two terms that have opposite signs and the size of their sum.
                let found = number(&summary.minimum_force);
                assert!((found / exact - 1.0).abs() < 1e-14, "n = {n}, {held}, {points}: {found:e} {exact:e}");
                assert!(number(&summary.pull_off_force) >= found, "n = {n}, {held}");
            }
            // Not pulled far enough to pass it, the minimum is at an end.
            let held = format!("{held}\npath = [0.5, 0.4]");
            let curve = force_curve(&profile, &held, 2);
            let ends = curve.samples.items.iter().filter_map(|sample| sample.force.to_f64());
            assert_eq!(Some(number(&curve.summary.minimum_force)), ends.reduce(f64::min), "n = {n}, {held}");
        }
    }
}

/// However coarsely a curve is sampled, its minimum force is one number, and no finer sample is below it.
#[test]
fn the_minimum_force_does_not_depend_on_the_samples() {
    let profiles = [
        ("kind = \"sphere\"\nradius = 1", "[-0.1, 0.1, -1]"),
        ("kind = \"hyperboloid\"\nhalf_angle_degrees = 70\nlateral = 1", "[-0.1, 0.1, -1]"),
        ("kind = \"truncated-cone\"\nslope = 0.2\nflat = 0.1", "[-0.1, 0.1, -1]"),
        ("kind = \"truncated-cone\"\nslope = 0.02\nflat = 0.001", "[-0.1, 0.1, -1]"),
        ("kind = \"flat-punch\"\nradius = 0.1", "[0.1, -1]"),
        ("kind = \"wavy-paraboloid\"\nradius = 1\namplitude = 5e-4\nwavelength = 0.1", "[0, -1]"),
        ("kind = \"wavy-paraboloid\"\nradius = 1\namplitude = 2e-3\nwavelength = 0.05", "[0, -1]"),
    ];
    for (profile, path) in profiles {
        for held in
            ["kind = \"indentation\"", "kind = \"machine\"\nstiffness = 0.01", "kind = \"machine\"\nstiffness = 10"]
        {
            let start = if path.starts_with("[-") { "detached" } else { "largest" };
            let control = format!("{held}\npath = {path}\nstart = \"{start}\"");
            let [coarse, fine] = [2, 3000].map(|points| force_curve(profile, &control, points));
            let least = number(&coarse.summary.minimum_force);
            assert_eq!(least, number(&fine.summary.minimum_force), "{profile}, {held}");
            let force = |sample: &ForceSample| sample.force.to_f64().expect("a force");
            let samples = &fine.samples.items;
            let sampled = samples.iter().map(force).reduce(f64::min).expect("samples");
            // The minimum lies between two samples of one stretch, which are no further apart than this.
            let pairs = samples.windows(2).filter(|pair| pair[0].segment == pair[1].segment);
            let step = pairs.map(|pair| (force(&pair[0]) - force(&pair[1])).abs()).fold(0.0, f64::max);
            assert!(least <= sampled && sampled <= least + step, "{profile}, {held}: {least:e} {sampled:e}");
        }
    }
}

/// A tip that is sharper than √r touches continuously, grows, and then jumps: that is its jump into contact, and the jump back is
/// its pull-off.
#[test]
fn a_sharp_tip_jumps_after_it_has_touched() {
    let profile = "kind = \"sum\"\n[[profile.term]]\nkind = \"power\"\nn = 0.3\nc = 0.01\n[[profile.term]]\nkind = \"paraboloid\"\nradius = 1";
    for held in ["kind = \"indentation\"", "kind = \"machine\"\nstiffness = 0.1"] {
        let curve = force_curve(profile, &format!("{held}\npath = [-0.1, 0.1, -1]\nstart = \"detached\""), 200);
        let samples = &curve.samples.items;
        let segment = |number: usize| samples.iter().filter(move |sample| sample.segment == number);
        // Apart, in contact at the sharp end, in contact after the jump.
        assert!(segment(2).next().expect("a touch").contact_radius.as_ref().and_then(Value::to_f64) == Some(0.0));
        let after = segment(3).next().and_then(|sample| sample.force.to_f64()).expect("a jump");
        assert_eq!(number(&curve.summary.jump_in_force), after);
        let pull_off = number(&curve.summary.pull_off_force);
        assert!(pull_off < 0.0 && samples.iter().any(|sample| sample.force.to_f64() == Some(pull_off)), "{pull_off:e}");
    }
}

/// Nothing is lost on a path without a jump, and nothing is written as −0.
#[test]
fn no_number_is_minus_zero() {
    let curve = force_curve("kind = \"paraboloid\"\nradius = 1", "kind = \"indentation\"\npath = [0.1, 0.2]", 2);
    assert_eq!(curve.summary.hysteresis.as_ref().map(Value::to_string).as_deref(), Some("0"));
    assert!(curve.summary.sentence(&mdr::answer::NumberStyle::default()).contains("hysteresis 0 J"));
    let zero = Value::Known(mdr::answer::Number::F64(-0.0));
    assert_eq!((zero.to_string(), serde_json::to_string(&zero).expect("a number")), ("0".to_owned(), "0.0".to_owned()));
}
