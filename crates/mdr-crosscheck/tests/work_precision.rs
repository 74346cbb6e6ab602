//! Error against run time, without a clock: what the comparisons must hold, and what the published data say of them.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

use mdr_core::number::{Interval, Precision, Real};
use mdr_crosscheck::Level;
use mdr_crosscheck::work_precision::{Accuracy, Clock, Comparison, Measurement, TASKS};
use rug::Float;
use serde::Deserialize;

/// All comparisons at the quick level.
static QUICK: LazyLock<Vec<Comparison>> = LazyLock::new(|| {
    let all = TASKS.iter().map(|task| task.comparisons(Level::Quick, Clock::Off).unwrap());
    all.flatten().collect()
});

fn comparison(id: &str) -> &'static Comparison {
    QUICK.iter().find(|comparison| comparison.id == id).unwrap_or_else(|| panic!("no {id}"))
}

fn points(id: &str, method: &str) -> &'static [Measurement] {
    let series = comparison(id).series.iter().find(|series| series.method == method);
    &series.unwrap_or_else(|| panic!("no {method} in {id}")).points
}

/// The digits of the last point of a method.
fn reached(id: &str, method: &str) -> Option<f64> {
    points(id, method).last().unwrap().outcome.digits()
}

#[test]
fn names_are_unique_and_nothing_is_timed() {
    let ids: BTreeSet<_> = QUICK.iter().map(|comparison| &comparison.id).collect();
    assert_eq!((ids.len(), QUICK.len()), (30, 30));
    for Comparison { id, series, .. } in QUICK.iter() {
        assert!(TASKS.iter().any(|task| id.starts_with(&format!("{}-", task.name))), "{id}");
        assert!(series[0].ours, "{id}: what a user gets is first");
        let methods: BTreeSet<_> = series.iter().map(|series| series.method).collect();
        assert_eq!(methods.len(), series.len(), "{id}");
        for series in series {
            let settings: BTreeSet<_> = series.points.iter().map(|point| &point.setting).collect();
            assert_eq!(settings.len(), series.points.len(), "{id}: {}", series.method);
            assert!(series.points.iter().all(|point| point.seconds.is_none()));
        }
    }
}

/// A right answer counts to its own last bit, a wrong one to its error; without a number there are no digits.
#[test]
fn outcomes() {
    let truth = Interval::from_int(Precision::new(300), 2).sqrt();
    let of = |answer: f64| Accuracy::of(&Float::with_val(53, answer), &truth);
    assert!((of(2f64.sqrt() * (1.0 + 1e-9)).digits().unwrap() - 9.0).abs() < 1e-6);
    assert!((of(2f64.sqrt() * 11.0).digits().unwrap() + 1.0).abs() < 1e-9);
    assert!(matches!(of(2f64.sqrt()), Accuracy::AtLeast(digits) if (digits - 15.95).abs() < 0.01));
    let wide = Accuracy::of(&Float::with_val(200, 2).sqrt(), &truth);
    assert!(matches!(wide, Accuracy::AtLeast(digits) if (digits - 60.2).abs() < 0.1), "{wide:?}");
    // Off by 10⁻⁵⁰⁰⁰, which no double holds.
    let small = Float::with_val(20_000, Float::i_exp(1, -16610)) + 1u32;
    let one = Interval::from_int(Precision::new(20_000), 1);
    assert!((Accuracy::of(&small, &one).digits().unwrap() - 5000.1).abs() < 0.1);
    // The enclosure has 20 digits, so no answer can have more.
    let coarse = Interval::from_int(Precision::new(66), 2).sqrt();
    let bound = Accuracy::of(&Float::with_val(200, 2).sqrt(), &coarse);
    assert!(matches!(bound, Accuracy::AtLeast(digits) if (19.0..20.0).contains(&digits)), "{bound:?}");
    for broken in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(matches!(of(broken), Accuracy::Failed { .. }));
    }
    let unknown = Accuracy::of(&Float::with_val(53, 1), &(truth.clone() - &truth));
    assert!(matches!(unknown, Accuracy::Failed { .. }));
}

/// What is shipped is right to the last place at every n; what is typed naively loses digits, or fails.
#[test]
fn kappa() {
    for n in ["1e-6", "0.05", "0.25", "0.5", "3.7", "20", "1000"] {
        let id = format!("kappa-{n}");
        assert!(reached(&id, "expansions, right to 1 ulp").unwrap() > 15.6, "{n}");
        assert!(reached(&id, "balls in fixed words").unwrap() > 15.9, "{n}");
    }
    assert!(reached("kappa-1000", "quotient of Γ").is_none());
    assert!(reached("kappa-1000", "exp of a difference of ln Γ").unwrap() < 14.0);
    assert!(reached("kappa-0.25", "Gauss's series").unwrap() > 15.0);
    // Brouncker's fraction converges slowly where n is small.
    assert!(reached("kappa-20", "Brouncker's continued fraction").unwrap() > 15.0);
    assert!(reached("kappa-0.25", "Brouncker's continued fraction").unwrap() < 6.0);
}

/// The quadratures of this workspace reach what the question and the roundings of their sums leave; textbook rules at a
/// blunt tip give numbers without a right digit.
#[test]
fn transform() {
    for Comparison { id, attainable, series, .. } in QUICK.iter().filter(|found| found.id.starts_with("transform-")) {
        for series in series.iter().filter(|series| series.ours) {
            let last = series.points.last().unwrap();
            // A sum of N terms, each with the condition of the integrand, is off by at most N + 40(1 + condition) roundings.
            let condition = 10_f64.powf(15.95 - attainable.unwrap());
            let roundings = last.evaluations.unwrap() as f64 + 40.0 * (1.0 + condition);
            let digits = last.outcome.digits().unwrap();
            assert!(digits >= 15.9 - roundings.log10(), "{id}, {}: {digits}", series.method);
        }
    }
    for method in ["springs, midpoint sum", "Gauss–Chebyshev", "Gauss–Legendre in θ"] {
        assert!((0.0..0.35).contains(&reached("transform-power-0.05", method).unwrap()), "{method}");
    }
}

/// The tangency gives the radius to the last digits, its interpolation with less than half of the evaluations of halving; the
/// extremum of d gives half of the digits of the radius and all of the indentation; springs converge as 1/N and 1/N².
#[test]
fn fold() {
    let spent = |id: &str, method: &str| points(id, method).last().unwrap().evaluations.unwrap();
    for name in ["2", "1", "0.25", "3.7", "wavy"] {
        let [radius, indentation] = ["radius", "indentation"].map(|quantity| format!("fold-{quantity}-{name}"));
        let attainable = comparison(&radius).attainable.unwrap();
        let search = "search for all folds";
        for method in [search, "tangency, Newton in a bracket", "tangency, interpolation", "tangency, bisection"] {
            let digits = reached(&radius, method).unwrap();
            assert!(digits > attainable - 1.0, "{name}, {method}: {digits} of {attainable}");
        }
        assert!(2 * spent(&radius, "tangency, interpolation") < spent(&radius, "tangency, bisection"), "{name}");
        let golden = "extremum of d, golden section";
        assert!((5.5..10.5).contains(&reached(&radius, golden).unwrap()), "{name}: {:?}", reached(&radius, golden));
        assert!(reached(&indentation, golden).unwrap() > 14.0, "{name}");
        for (id, order) in [(radius, 1.0), (indentation, 2.0)] {
            let points = points(&id, "springs of the paper");
            // The least error that the order allows on the last three steps: luck beats it, not the other way round.
            for point in &points[points.len() - 3..] {
                let springs: f64 = point.setting.split(' ').next().unwrap().parse().unwrap();
                let digits = point.outcome.digits().unwrap();
                assert!(digits > order * (springs.log10() - 1.2), "{id}: {digits} with {springs} springs");
            }
        }
    }
    for name in ["2", "1", "0.25", "3.7"] {
        for quantity in ["radius", "indentation"] {
            assert!(
                reached(&format!("fold-{quantity}-{name}"), "closed form, right to 1 ulp").unwrap() > 15.6,
                "{name}"
            );
        }
    }
}

/// Sixteen guard bits hold the roundings of all but the most careless formula.
#[test]
fn a_method_asked_for_digits_gives_them() {
    for Comparison { id, series, .. } in QUICK.iter().filter(|found| found.id.starts_with("digits-")) {
        for series in series {
            for (point, asked) in series.points.iter().zip([16.0, 50.0, 200.0]) {
                let found = point.outcome.digits().unwrap_or_else(|| panic!("{id}, {}: {point:?}", series.method));
                assert!((asked..asked + 12.0).contains(&found), "{id}, {}: {found} of {asked}", series.method);
            }
        }
    }
}

/// A line of `docs/report/work-precision.csv`, but for the time.
#[derive(Deserialize)]
struct Row {
    comparison: String,
    method: String,
    setting: String,
    outcome: String,
    digits: Option<f64>,
    evaluations: Option<u64>,
}

/// Digits and evaluations are those of the published data. Elementary functions of the system may differ in the last bit, and
/// the luck of roundings with them: half a digit, and a tenth of the evaluations.
#[test]
fn the_published_data_are_those_of_the_source() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/report/work-precision.csv");
    let rows: Vec<Row> = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .from_path(path)
        .unwrap()
        .deserialize()
        .map(Result::unwrap)
        .collect();
    let methods: BTreeSet<_> = rows.iter().map(|row| (row.comparison.as_str(), row.method.as_str())).collect();
    let mut published: BTreeMap<_, _> =
        rows.iter().map(|row| ((row.comparison.as_str(), row.method.as_str(), row.setting.as_str()), row)).collect();
    let all = || QUICK.iter().flat_map(|comparison| comparison.series.iter().map(move |series| (comparison, series)));
    assert_eq!(methods, all().map(|(comparison, series)| (comparison.id.as_str(), series.method)).collect());
    for (comparison, series) in all() {
        for point in &series.points {
            let key = (comparison.id.as_str(), series.method, point.setting.as_str());
            let row = published.remove(&key).unwrap_or_else(|| panic!("{key:?} is not published: run mdr report"));
            match (row.digits, point.outcome.digits()) {
                (Some(old), Some(new)) => {
                    assert!((new - old).abs() < 0.5, "{key:?}: {new} digits, published are {old}")
                }
                (None, None) => assert!(row.outcome.starts_with("failed: "), "{key:?}: {}", row.outcome),
                (old, new) => panic!("{key:?}: {new:?} digits, published are {old:?}"),
            }
            let [old, new] = [row.evaluations, point.evaluations].map(|count| count.map(|count| count as f64));
            let alike = old.zip(new).map_or(old == new, |(old, new)| (new - old).abs() <= 0.1 * old);
            assert!(alike, "{key:?}: {new:?} evaluations, published are {old:?}");
        }
    }
}
