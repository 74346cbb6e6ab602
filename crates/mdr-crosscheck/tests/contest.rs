//! The contest of error against run time: what its diagrams must hold, without a clock.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use std::collections::HashSet;
use std::sync::LazyLock;

use mdr_core::number::{Interval, Precision, Real};
use mdr_crosscheck::contest::{Clock, Diagram, Effort, Outcome, tasks};
use rug::Float;

/// All diagrams of the quick contest.
static QUICK: LazyLock<Vec<Diagram>> =
    LazyLock::new(|| tasks().iter().flat_map(|task| (task.diagrams)(Effort::Quick, &Clock::Off)).collect());

fn diagram(id: &str) -> &'static Diagram {
    QUICK.iter().find(|diagram| diagram.id == id).unwrap()
}

/// The digits of the last point of a contestant.
fn reached(id: &str, contestant: &str) -> Option<f64> {
    let curve = diagram(id).curves.iter().find(|curve| curve.contestant == contestant).unwrap();
    curve.points.last().unwrap().outcome.digits()
}

#[test]
fn names_are_stable_and_unique() {
    let mut seen = HashSet::new();
    for diagram in QUICK.iter() {
        let legible =
            diagram.id.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || b".-".contains(&byte));
        assert!(legible && diagram.id.starts_with(&diagram.task) && seen.insert(&diagram.id), "{}", diagram.id);
        let contestants: HashSet<_> = diagram.curves.iter().map(|curve| &curve.contestant).collect();
        assert_eq!(contestants.len(), diagram.curves.len(), "{}", diagram.id);
        for curve in &diagram.curves {
            let settings: HashSet<_> = curve.points.iter().map(|point| &point.setting).collect();
            assert_eq!(settings.len(), curve.points.len(), "{}: {}", diagram.id, curve.contestant);
        }
    }
}

#[test]
fn without_a_clock_nothing_is_timed_and_every_run_is_the_same() {
    let points = QUICK.iter().flat_map(|diagram| &diagram.curves).flat_map(|curve| &curve.points);
    assert!(points.into_iter().all(|point| point.time.is_none()));
    for task in tasks().iter().filter(|task| task.name == "kappa") {
        let again = (task.diagrams)(Effort::Quick, &Clock::Off);
        assert!(again.iter().all(|again| diagram(&again.id) == again));
    }
}

/// A right answer counts to its own last bit, a wrong one to its error, and none where there is no number.
#[test]
fn outcomes() {
    let truth = Interval::from_int(Precision::new(300), 2).sqrt();
    let digits = |answer: f64| Outcome::of(&answer, &truth).digits().unwrap();
    assert!((digits(2f64.sqrt() * (1.0 + 1e-9)) - 9.0).abs() < 1e-6);
    assert!((digits(2f64.sqrt() * 11.0) + 1.0).abs() < 1e-9);
    assert!(matches!(Outcome::of(&2f64.sqrt(), &truth), Outcome::AtLeast(digits) if (digits - 15.95).abs() < 0.01));
    let wide = Outcome::of(&Float::with_val(200, 2).sqrt(), &truth);
    assert!(matches!(wide, Outcome::AtLeast(digits) if (digits - 60.2).abs() < 0.1), "{wide:?}");
    // Off by 10⁻⁵⁰⁰⁰, which no double holds.
    let small = Float::with_val(20_000, Float::i_exp(1, -16610)) + 1u32;
    let one = Interval::from_int(Precision::new(20_000), 1);
    assert!((Outcome::of(&small, &one).digits().unwrap() - 5000.1).abs() < 0.1);
    // The enclosure has 20 digits, so no answer can have more.
    let coarse = Interval::from_int(Precision::new(66), 2).sqrt();
    let bound = Outcome::of(&Float::with_val(200, 2).sqrt(), &coarse);
    assert!(matches!(bound, Outcome::AtLeast(digits) if (19.0..20.0).contains(&digits)), "{bound:?}");
    for broken in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(matches!(Outcome::of(&broken, &truth), Outcome::Failed(_)));
    }
    assert!(matches!(Outcome::of(&1.0, &(truth.clone() - &truth)), Outcome::Failed(_)));
}

/// What is shipped is right to the last place at every n; what is typed naively loses digits, or fails.
#[test]
fn kappa() {
    for n in ["1e-6", "0.05", "0.25", "0.5", "3.7", "20", "1000"] {
        let id = format!("kappa-{n}");
        assert!(reached(&id, "shipped, f64").unwrap() > 15.6, "{n}");
        assert!(reached(&id, "extended precision").unwrap() > 15.9, "{n}");
    }
    assert!(reached("kappa-1000", "Γ quotient, pxfm").is_none());
    assert!(reached("kappa-20", "Γ quotient, statrs").unwrap() < 15.0);
    assert!(reached("kappa-1000", "exp of log Γ, pxfm").unwrap() < 14.0);
    assert!(reached("kappa-0.25", "Gauss's series").unwrap() > 15.0);
    // Brouncker's fraction converges slowly where n is small.
    assert!(reached("kappa-20", "Brouncker's fraction").unwrap() > 15.0);
    assert!(reached("kappa-0.25", "Brouncker's fraction").unwrap() < 6.0);
}
