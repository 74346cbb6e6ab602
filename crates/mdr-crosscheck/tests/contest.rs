//! The contest of error against run time: what its diagrams must hold, without a clock.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use std::collections::HashSet;
use std::sync::LazyLock;

use mdr_core::number::{Interval, Precision, Real};
use mdr_crosscheck::contest::{Baseline, Clock, Diagram, Effort, Outcome, Setup, tasks};
use rug::Float;

/// All diagrams of the quick contest.
static QUICK: LazyLock<Vec<Diagram>> = LazyLock::new(|| {
    tasks().iter().flat_map(|task| task.diagrams(&mut Setup::new(Effort::Quick, Clock::Off))).collect()
});

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
        let contestants: HashSet<_> =
            diagram.curves.iter().map(|curve| (&curve.contestant, curve.arithmetic)).collect();
        assert_eq!(contestants.len(), diagram.curves.len(), "{}", diagram.id);
        assert!(diagram.curves.iter().any(|curve| curve.contestant == diagram.shipped), "{}", diagram.id);
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
        let again = task.diagrams(&mut Setup::new(Effort::Quick, Clock::Off));
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

/// The tangency gives the radius to the last digits, its interpolation with less than half of the evaluations of halving; the
/// extremum of d gives half of the digits of the radius and all of the indentation; springs converge as 1/N and 1/N².
#[test]
fn fold() {
    for name in ["2", "1", "0.25", "3.7", "wavy"] {
        let [radius, indentation] = ["radius", "indentation"].map(|quantity| format!("fold-{quantity}-{name}"));
        let ceiling = diagram(&radius).ceiling.unwrap();
        for contestant in ["search for all folds", "tangency, Newton", "tangency, interpolation", "tangency, bisection"]
        {
            let digits = reached(&radius, contestant).unwrap();
            assert!(digits > ceiling - 1.0, "{name}, {contestant}: {digits} of {ceiling}");
        }
        assert!(2 * spent(&radius, "tangency, interpolation") < spent(&radius, "tangency, bisection"), "{name}");
        let golden = "extremum of d, golden section";
        assert!((5.5..10.5).contains(&reached(&radius, golden).unwrap()), "{name}: {:?}", reached(&radius, golden));
        assert!(reached(&indentation, golden).unwrap() > 14.0, "{name}");
        for (id, order) in [(radius, 1.0), (indentation, 2.0)] {
            let points = &diagram(&id).curves.last().unwrap().points;
            let springs = |setting: &str| setting.split(' ').next().unwrap().parse::<f64>().unwrap();
            // The least error that the order allows on the last three steps: luck beats it, not the other way round.
            for pair in points[points.len() - 4..].windows(2) {
                let digits = pair[1].outcome.digits().unwrap();
                assert!(
                    digits > order * (springs(&pair[1].setting).log10() - 1.2),
                    "{id}: {digits} at {}",
                    pair[1].setting
                );
            }
        }
    }
    for name in ["2", "1", "0.25", "3.7"] {
        for quantity in ["radius", "indentation"] {
            assert!(reached(&format!("fold-{quantity}-{name}"), "closed form, shipped").unwrap() > 15.6, "{name}");
        }
    }
}

/// The evaluations of the last point of a contestant.
fn spent(id: &str, contestant: &str) -> u64 {
    let curve = diagram(id).curves.iter().find(|curve| curve.contestant == contestant).unwrap();
    curve.points.last().unwrap().evaluations.unwrap()
}

/// Digits and evaluations are those of the baseline, or better.
#[test]
fn nothing_is_worse_than_the_baseline() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/report/baseline.jsonl");
    let old = Baseline::from_json_lines(&std::fs::read_to_string(path).unwrap()).unwrap();
    let worse: String =
        old.regressions(&Baseline::of(&QUICK)).iter().map(|regression| format!("{regression}\n")).collect();
    assert!(
        worse.is_empty(),
        "{worse}if that is meant: cargo run -p mdr-cli -- report --renew docs/report/baseline.jsonl"
    );
}
