//! κ_n in double precision: the function of this workspace beside formulas that one would type.

use std::f64::consts::PI;
use std::hint::black_box;

use mdr_analytic::Kappa;
use mdr_core::contact::Result;
use mdr_core::number::{Extended, Gamma, Interval, Precision, Real};

use super::{Accuracy, Clock, Comparison, Measurement, Series, Task};
use crate::Level;
use crate::subject::textbook::kappa_by_logarithms;

/// The task.
pub(super) const TASK: Task = Task {
    name: "kappa",
    title: "The factor κ_n of a power law (1.12) in double precision, from n near 0 to large n",
    comparisons,
};

/// Exponents, as they are named.
const EXPONENTS: [(f64, &str); 7] =
    [(1e-6, "1e-6"), (0.05, "0.05"), (0.25, "0.25"), (0.5, "0.5"), (3.7, "3.7"), (20.0, "20"), (1000.0, "1000")];

fn comparisons(level: Level, clock: Clock) -> Result<Vec<Comparison>> {
    Ok(EXPONENTS.iter().map(|&(n, name)| comparison(n, name, level, clock)).collect())
}

fn comparison(n: f64, name: &str, level: Level, clock: Clock) -> Comparison {
    let truth = [by_gamma(&Interval::from_f64(Precision::new(256), n))];
    let point = |setting: &str, method: &dyn Fn(f64) -> f64| {
        Measurement::measure(setting, clock, &truth, || Ok(method(black_box(n))))
    };
    let most = if level == Level::Quick { 6 } else { 10 };
    let growing = |unit: &str, method: fn(f64, u64) -> f64| {
        let terms = (1..=most).map(|power| 1 << power);
        terms.map(|terms| point(&format!("{terms} {unit}"), &|n| method(n, terms))).collect()
    };
    let words = [
        point("64 bits", &|n| Extended::<1>::kappa(&n.into()).approx()),
        point("128 bits", &|n| Extended::<2>::kappa(&n.into()).approx()),
        point("256 bits", &|n| Extended::<4>::kappa(&n.into()).approx()),
    ];
    Comparison {
        id: format!("kappa-{name}"),
        title: format!("κ_n at n = {name}"),
        truth: "√π Γ(1+n/2)/Γ((n+1)/2) over intervals of 256 bits, with the Γ of MPFR",
        // |n κ'/κ| < 1/2.
        attainable: Some(Accuracy::attainable(0.5)),
        series: vec![
            Series::ours(
                "expansions, right to 1 ulp",
                vec![point("f64", &|n| mdr_analytic::double::kappa(n).unwrap_or(f64::NAN))],
            ),
            Series::ours("balls in fixed words", words.into()),
            Series::textbook("quotient of Γ", vec![point("f64", &|n| by_gamma(&n))]),
            Series::textbook("exp of a difference of ln Γ", vec![point("f64", &kappa_by_logarithms)]),
            Series::textbook("Gauss's series", growing("terms", by_series)),
            Series::textbook("Brouncker's continued fraction", growing("levels", by_fraction)),
        ],
    }
}

/// √π Γ(1+n/2)/Γ((n+1)/2), (1.12).
pub(super) fn by_gamma<R: Gamma>(n: &R) -> R {
    let half = n.clone().over(2);
    (half.clone() + n.lit(1)).gamma() / (half + n.ratio(1, 2)).gamma() * n.pi().sqrt()
}

/// κ_n = ₂F₁(1, n; 1+n/2; 1/2), Gauss's second theorem (DLMF 15.4.28), by its power series: one bit a term in the end.
fn by_series(n: f64, terms: u64) -> f64 {
    let (mut term, mut sum) = (1.0, 0.0);
    for j in 0..terms {
        sum += term;
        let j = j as f64;
        term *= (n + j) / (n + 2.0 + 2.0 * j);
    }
    sum
}

/// 4κ²/π = s + 1²/(2s + 3²/(2s + 5²/(2s + …))) with s = 2n + 1, cut at a level.
fn by_fraction(n: f64, levels: u64) -> f64 {
    let s = 2.0 * n + 1.0;
    let tail = (1..=levels).rev().fold(2.0 * s, |tail, k| {
        let odd = (2 * k - 1) as f64;
        if k == 1 { s + odd * odd / tail } else { 2.0 * s + odd * odd / tail }
    });
    (PI * tail).sqrt() / 2.0
}
