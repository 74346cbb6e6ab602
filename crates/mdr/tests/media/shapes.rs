//! Shapes that are no powers, on media: proved folds, against those of the search in f64 and of states beside them.

use mdr::prelude::*;

use crate::{GRIPS, LOAD, scene, solve};

const MEDIA: [&str; 5] = [
    "kind = \"graded\"\nexponent = \"0.3\"\ncoefficient = 1",
    "kind = \"graded\"\nexponent = \"-0.6\"\ncoefficient = 1",
    "kind = \"winkler\"\nmodulus = 1",
    "kind = \"plane\"",
    "kind = \"plane\"\nreference = 10",
];

const SHAPES: [&str; 8] = [
    "kind = \"sphere\"\nradius = 1",
    "kind = \"hyperboloid\"\nslope = 1\nlateral = \"0.2\"",
    "kind = \"rounded-punch\"\nradius = 1\nflat = \"0.1\"",
    "kind = \"cone-parabolic-cap\"\nslope = 1\ncap = \"0.1\"",
    "kind = \"cone-spherical-cap\"\nslope = 1\nradius = \"0.1\"",
    "kind = \"flat-punch\"\nradius = \"0.3\"",
    "kind = \"expression\"\nformula = \"cosh(r) - 1\"",
    SUM,
];

/// A smooth term and one with a kink.
const SUM: &str = "kind = \"sum\"\n[[profile.term]]\nkind = \"paraboloid\"\nradius = 1\n[[profile.term]]\n\
                   kind = \"rounded-punch\"\nradius = 1\nflat = \"0.1\"";

#[test]
fn folds_of_shapes_are_proved() {
    for (row, medium) in MEDIA.into_iter().enumerate() {
        for (column, shape) in SHAPES.into_iter().enumerate() {
            // At grips what is flat on springs that do not couple is an equilibrium everywhere, and without a reference there is no depth.
            let is_loaded = medium.ends_with("\"plane\"") || medium.contains("winkler") || (row + column) % 2 == 0;
            let control = if is_loaded { LOAD } else { GRIPS };
            let text = scene(medium, shape, control, "want = [\"folds\"]\ndigits = 15");
            let proved = solve(&text);
            let folds = proved.folds().expect("wanted");
            assert_eq!(folds.promise, Promise::Certified, "{text}");
            assert!(folds.complete.as_ref().is_some_and(|complete| complete.proved), "{text}");
            let searched = solve(&text.replace("digits = 15", "arithmetic = \"f64\""));
            let searched = &searched.folds().expect("wanted").items;
            assert!(folds.items.len() == searched.len() && !searched.is_empty(), "{text}");
            for (one, other) in folds.items.iter().zip(searched) {
                let values = |fold: &mdr::answer::Fold| [&fold.contact_radius, &fold.force].map(Value::to_f64);
                for (one, other) in values(one).into_iter().zip(values(other)) {
                    let (one, other) = (one.expect("a number"), other.expect("a number"));
                    assert!((one / other - 1.0).abs() < 1e-9, "{text}\n{one} {other}");
                }
            }
        }
    }
}

/// The pull-off of the sum in line contact, F = N − √(2πwb) with N = πb²/4 + ∫r(r − c)/√(b² − r²) dr from c to b, by its own minimum.
#[test]
fn a_sum_with_a_kink_breaks_where_its_force_is_least() {
    let c = 0.1_f64;
    let force = |b: f64| {
        let root = (b * b - c * c).sqrt();
        let corner = 0.5 * (b * b * (c / b).acos() - c * root);
        std::f64::consts::PI * b * b / 4.0 + corner - (0.02 * std::f64::consts::PI * b).sqrt()
    };
    let fold = solve(&scene("kind = \"plane\"", SUM, LOAD, "want = [\"folds\"]\ndigits = 15"));
    let fold = &fold.folds().expect("wanted").items[0];
    let [b, least] = [&fold.contact_radius, &fold.force].map(|value| value.to_f64().expect("a number"));
    assert!((force(b) / least - 1.0).abs() < 1e-13, "{b} {least} {}", force(b));
    assert!(force(0.99 * b) > least && force(1.01 * b) > least);
}

/// r²/2R − br/R falls at the tip: on springs that do not couple d = f − √(2w/c) is least where f is, b²/2R below the tip. A
/// flat breaks off at its edge, all at once.
#[test]
fn springs_at_grips_break_where_the_profile_is_lowest() {
    let springs = "kind = \"winkler\"\nmodulus = 1";
    let elongation = 0.02_f64.sqrt();
    let displaced = "kind = \"displaced-paraboloid\"\nradius = 1\noffset = \"0.2\"";
    for (shape, least) in [(displaced, 0.02), ("kind = \"flat-punch\"\nradius = \"0.2\"", 0.0)] {
        let text = scene(springs, shape, GRIPS, "want = [\"folds\"]\narithmetic = \"f64\"");
        let found = solve(&text);
        let [fold] = found.folds().expect("wanted").items.as_slice() else { panic!("one fold: {text}") };
        let [radius, depth] = [&fold.contact_radius, &fold.indentation].map(|value| value.to_f64().expect("a number"));
        assert!((radius / 0.2 - 1.0).abs() < 1e-14 && (depth / (-least - elongation) - 1.0).abs() < 1e-14, "{text}");
    }
}

/// Near the tip f of these is as small as the roundings of what it is a difference of: that it is no dimple is seen by its slope. The
/// surfaces jump together at first touch.
#[test]
fn paths_of_heights_that_are_differences() {
    let way = "kind = \"indentation\"\npath = [\"-1\", \"1/100\"]\nstart = \"detached\"";
    for medium in [MEDIA[0], MEDIA[2]] {
        for shape in [SHAPES[0], SHAPES[1]] {
            let text = scene(medium, shape, way, "want = [\"path\"]\nenergies = \"no\"\ndigits = 15");
            let answer = solve(&text);
            let path = answer.path().expect("wanted");
            let events: Vec<_> = path.events.items.iter().map(|event| event.event.name()).collect();
            assert_eq!(
                (path.events.promise, events.as_slice()),
                (Promise::Certified, &["start", "jump-in", "end"][..]),
                "{text}"
            );
        }
    }
}

/// Under a dead load a paraboloid, also one that is the cap of a cone, breaks off springs that do not couple at the depth 0.
#[test]
fn a_parabolic_cap_breaks_at_zero_depth() {
    let cone = "kind = \"cone-parabolic-cap\"\nslope = \"0.2\"\ncap = 2";
    let folds = solve(&scene(MEDIA[2], cone, LOAD, "want = [\"folds\"]"));
    let [fold] = folds.folds().expect("wanted").items.as_slice() else { panic!("one fold") };
    // f = t r²/2b is Δl at the depth 0: a = √(2bΔl/t).
    let radius = (20.0 * 0.02_f64.sqrt()).sqrt();
    assert!((fold.contact_radius.to_f64().expect("a number") / radius - 1.0).abs() < 1e-14);
    assert_eq!((fold.indentation.to_f64(), fold.indentation.status()), (Some(0.0), Status::Ok));
}
