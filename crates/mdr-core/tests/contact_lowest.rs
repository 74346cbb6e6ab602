//! The shape of formulas by enclosures: whether g falls nowhere, and where f is lowest.
#![cfg(feature = "mp")]
#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::collections::BTreeMap;

use mdr_core::contact::{Expression, FormulaShape, Lowest, Profile, Shape};
use mdr_core::number::{Literal, Precision};
use rug::Float;

fn shape(formula: &str, s: &str) -> FormulaShape {
    let formula: Expression = formula.parse().unwrap();
    let values: BTreeMap<String, Literal> = [("s".to_owned(), s.parse().unwrap())].into();
    let breaks = formula.breaks(&values).unwrap_or_else(|error| panic!("{error}"));
    formula.shape(&values, &breaks).unwrap()
}

fn ring(formula: &str, s: &str) -> [f64; 2] {
    match shape(formula, s).lowest {
        Lowest::Ring(ring) => ring.at::<f64>(()),
        other => panic!("{formula}: {other:?}"),
    }
}

/// f' + r f'' ≥ 0, and kinks that bend upwards.
#[test]
fn g_is_proved_to_rise() {
    for formula in [
        "r^2/2",
        "r",
        "r^1.5",
        "3*r^(1/2)",
        "1 - sqrt(1 - r^2)",
        "0.1*(sqrt(r^2 + 0.01) - 0.1)",
        "r^2/2 + 0.001*(1 - cos(10*r))",
        "max(0.02*r, r^2/2) + 0.2*max(0, r - 0.1)",
        "max(0, r - 0.5)",
        "abs(r - 0.5) + r - 0.5",
        "2*r^2 - min(r^2, 0.3*r)",
        "sqrt((r - 0.5)^2) + r^2 + r - 0.5",
        "r^2*exp(-r) + r^2",
        // Without bounds that are numbers at the largest radii, and with terms that cancel next to the axis.
        "cosh(r) - 1",
        "exp(r^2) - 1 - r^2",
        "sinh(r) - r + r^3",
        // By the form: (r f')' = 4r/(1 + r²)², whose terms cancel at large radii.
        "ln(1 + r^2)",
        "sqrt(1 + r^2) - 1",
        // A dip whose curvature 2A/s² is above −2.
        "r^2/2 - 1e-9*(exp(-((r-0.5037)/5e-4)^2) - exp(-(0.5037/5e-4)^2))",
    ] {
        let shape = shape(formula, "1");
        assert!(shape.rises, "{formula}");
        assert!(matches!(shape.lowest, Lowest::Tip), "{formula}");
    }
}

/// One that falls somewhere, however little, is never proved to rise.
#[test]
fn g_is_not_proved_to_rise_where_it_falls() {
    for formula in [
        "r^2/2 + 0.01*(1 - cos(30*r))",
        "r^2/2 - 0.1*max(0, r - 0.1)",
        // Next to the axis alone: −r⁴/2, and −r².
        "exp(r^2) - 1 - r^2 - r^4",
        "cosh(r) - 1 - r^2",
        "r^2/2 - 0.1*abs(r - 0.5) + 0.05",
        "r^2/2 + min(0, 0.5 - r)",
        "r^2/2 + 1e-9*(1 - cos(1e6*r))",
        "sin(r)",
        "r^2*(r^2 - 2)",
    ] {
        assert!(!shape(formula, "1").rises, "{formula}");
    }
    // The curvature 2A/s² of a dip is below −2.
    for (depth, s) in [("0.01", "5e-2"), ("0.01", "5e-4"), ("1e-9", "1e-6"), ("1e-9", "1e-9"), ("1e-9", "1e-12")] {
        let formula = format!("r^2/2 - {depth}*(exp(-((r-0.5037)/s)^2) - exp(-(0.5037/s)^2))");
        assert!(!shape(&formula, s).rises, "{formula}, {s}");
    }
}

/// Up to where r f' begins to fall, if it rises at the axis.
#[test]
fn g_is_proved_to_rise_up_to_a_radius() {
    let rises = |formula: &str, radius: f64| {
        let formula: Expression = formula.parse().unwrap();
        formula.rises_up_to(&BTreeMap::new(), &Float::with_val(53, radius)).unwrap()
    };
    // (r f')' = 4r − 16r³
    for (radius, expected) in [(1e-300, true), (0.01, true), (0.4999, true), (0.5001, false), (3.0, false)] {
        assert_eq!(rises("r^2 - r^4", radius), expected, "{radius}");
    }
    // It falls next to the axis alone.
    assert!(!rises("r^2/2 - r^2/(1000*r^2 + 1)", 0.01) && !rises("r^2/2 - r^2/(1000*r^2 + 1)", 0.05));
    // One kink downwards.
    assert!(rises("r^2/2 - 0.1*max(0, r - 0.1)", 0.09) && !rises("r^2/2 - 0.1*max(0, r - 0.1)", 0.11));
}

/// A dip of the width s at c: its minimum is at r = c − δ with r = 0.4 δ e^(−δ²/s²)/s², by iteration.
#[test]
fn narrow_dips_are_found() {
    let c = 0.5037;
    for s in ["5e-2", "5e-3", "5e-4", "3.3e-5", "1e-6", "1e-9", "1e-12"] {
        let width: f64 = s.parse().unwrap();
        let mut delta = 0.0;
        for _ in 0..100 {
            delta = (c - delta) * width * width / 0.4 * (delta * delta / width / width).exp();
        }
        let height =
            (c - delta).powi(2) / 2.0 - 0.2 * ((-(delta / width).powi(2)).exp() - (-(c / width).powi(2)).exp());
        let found = ring("r^2/2 - 0.2*(exp(-((r-0.5037)/s)^2) - exp(-(0.5037/s)^2))", s);
        assert!((found[0] / (c - delta) - 1.0).abs() < 1e-14, "{s}: {found:?}, {delta:e}");
        assert!((found[1] - height).abs() < 1e-15, "{s}: {found:?}, {height}");
    }
}

/// Dips that do not reach the height of the tip leave the tip where it is.
#[test]
fn shallow_dips_are_passed() {
    for s in ["5e-2", "5e-4", "1e-9"] {
        let formula = "r^2/2 - 0.1*(exp(-((r-0.5037)/s)^2) - exp(-(0.5037/s)^2))";
        let lowest = shape(formula, s).lowest;
        match lowest {
            // For the wide dip f' < 0 up to r = 10^−43 or so.
            Lowest::Ring(ring) => assert!(ring.at::<f64>(())[0] < 1e-30, "{s}"),
            other => assert!(matches!(other, Lowest::Tip), "{s}: {other:?}"),
        }
    }
    assert!(matches!(shape("r^2/2 + 0.01*(1 - cos(30*r))", "1").lowest, Lowest::Tip));
    assert!(matches!(shape("r^2/2 - 0.1*max(0, r - 0.1)", "1").lowest, Lowest::Tip));
}

#[test]
fn rings_at_kinks_and_of_dimples() {
    assert_eq!(ring("r^2/2 + 0.75*abs(r - 0.5) - 0.375", "1"), [0.5, -0.25]);
    let [radius, height] = ring("r^2*(r^2 - 2)", "1");
    assert!((radius - 1.0).abs() < 1e-15 && (height + 1.0).abs() < 1e-15);
    // To any number of digits: r = √2/2 for r⁴ − r².
    let Lowest::Ring(ring) = shape("r^4 - r^2", "1").lowest else { panic!() };
    let [radius, height] = ring.at::<Float>(Precision::new(400));
    let root = Float::with_val(400, 0.5).sqrt();
    assert!(Float::with_val(400, radius - root).abs() < 1e-118 && Float::with_val(400, height + 0.25).abs() < 1e-118);
}

/// Rings without end, and a profile that falls to its end: nothing is claimed.
#[test]
fn what_is_not_unique_stays_open() {
    for formula in ["cos(r) - 1", "-(r^2)"] {
        let lowest = shape(formula, "1").lowest;
        assert!(matches!(lowest, Lowest::Open { .. }), "{formula}: {lowest:?}");
    }
}

/// The rings of the shapes of the library, and that others are lowest at the tip, against heights of their formulas on many radii.
#[test]
fn rings_of_shapes_are_those_of_their_formulas() {
    for name in Shape::names() {
        // All parameters differ; of a wave on a paraboloid the amplitude is positive.
        let mut tenths = 1;
        let shape = Shape::by_name(name).unwrap().map(|_, ()| {
            tenths += 3;
            format!("{tenths}/10").parse::<Literal>().unwrap()
        });
        let (formula, values) = shape.formula().unwrap();
        let heights = formula.bind::<f64>((), &values).unwrap().broken_at((), &formula.breaks(&values).unwrap());
        let [radius, lowest] = shape.map(|_, length| length.nearest_f64()).lowest_ring().unwrap_or([0.0, 0.0]);
        assert!(radius == 0.0 || (heights.height(&radius) - lowest).abs() < 1e-15, "{name}");
        for r in (1..=4000).map(|k| f64::from(k) * 1e-3) {
            assert!(!(heights.height(&r) < lowest - 1e-15), "{name}: {r}");
        }
    }
}
