//! κ_n in double precision: what is shipped beside what one would type.

use std::convert::Infallible;
use std::f64::consts::PI;
use std::hint::black_box;

use mdr_analytic::Kappa;
use mdr_core::number::{Gamma, Interval, Precision, Real, Wide};

use super::{Arithmetic, Clock, Curve, Diagram, Effort, Point, Setup, Task, View, ceiling};

/// The task.
pub(super) const KAPPA: Task = Task {
    name: "kappa",
    claim: "the factor κ_n of a power law (1.12) in double precision, from n near 0 to large n",
    diagrams,
};

const SHIPPED: &str = "shipped, f64";

/// Exponents, and their names in files.
const EXPONENTS: [(f64, &str); 7] =
    [(1e-6, "1e-6"), (0.05, "0.05"), (0.25, "0.25"), (0.5, "0.5"), (3.7, "3.7"), (20.0, "20"), (1000.0, "1000")];

fn diagrams(setup: &mut Setup) -> Vec<Diagram> {
    let Setup { effort, clock, .. } = *setup;
    EXPONENTS.iter().map(|&(n, name)| diagram(n, name, effort, &clock)).collect()
}

fn diagram(n: f64, name: &str, effort: Effort, clock: &Clock) -> Diagram {
    let truth = exact(&Interval::from_f64(Precision::new(256), n));
    let one = |contestant: &str, setting: &str, method: fn(f64) -> f64| {
        let point = Point::measure(setting, clock, &truth, || Ok::<_, Infallible>(method(black_box(n))));
        Curve::new(contestant, Arithmetic::Double, vec![point])
    };
    let wide = [
        ("64 bits", kappa_in_words::<1> as fn(f64) -> f64),
        ("128 bits", kappa_in_words::<2>),
        ("256 bits", kappa_in_words::<4>),
    ];
    let wide = wide
        .map(|(setting, method)| Point::measure(setting, clock, &truth, || Ok::<_, Infallible>(method(black_box(n)))));
    let most = match effort {
        Effort::Quick => 6,
        Effort::Full => 10,
    };
    let growing = |contestant: &str, unit: &str, method: fn(f64, u64) -> f64| {
        let points = (1..=most).map(|power| {
            let terms = 1 << power;
            let answer = || Ok::<_, Infallible>((method(black_box(n), terms), terms));
            Point::measure(format!("{terms} {unit}"), clock, &truth, answer)
        });
        Curve::new(contestant, Arithmetic::Double, points.collect())
    };
    Diagram {
        id: format!("kappa-{name}"),
        task: KAPPA.name.to_owned(),
        title: format!("κ_n at n = {name}, in double precision"),
        truth: "√π Γ(1+n/2)/Γ((n+1)/2) over intervals of 256 bits, with the Γ of MPFR, which no contestant uses"
            .to_owned(),
        view: View::Error,
        // |n κ'/κ| < 1/2.
        ceiling: Some(ceiling(0.5)),
        shipped: SHIPPED.to_owned(),
        curves: vec![
            one(SHIPPED, "f64", shipped),
            Curve::new("extended precision", Arithmetic::Double, wide.into()),
            one("Γ quotient, pxfm", "f64", |n| quotient(n, pxfm::f_tgamma)),
            one("Γ quotient, statrs", "f64", |n| quotient(n, statrs::function::gamma::gamma)),
            one("exp of log Γ, pxfm", "f64", by_logarithms),
            growing("Gauss's series", "terms", by_series),
            growing("Brouncker's fraction", "levels", by_fraction),
        ],
        omissions: Vec::new(),
    }
}

/// κ_n with the Γ of MPFR, which no contestant uses.
pub(super) fn exact(n: &Interval) -> Interval {
    let half = n.clone().over(2);
    let quotient = (half.clone() + half.lit(1)).gamma() / (half.clone() + half.ratio(1, 2)).gamma();
    quotient * half.pi().sqrt()
}

fn shipped(n: f64) -> f64 {
    mdr_analytic::double::kappa(n).unwrap_or(f64::NAN)
}

fn kappa_in_words<const N: usize>(n: f64) -> f64 {
    Wide::<N>::kappa(&n.into()).approx()
}

/// (1.12) as printed.
fn quotient(n: f64, gamma: impl Fn(f64) -> f64) -> f64 {
    PI.sqrt() / 2.0 * n * gamma(n / 2.0) / gamma((n + 1.0) / 2.0)
}

/// The same where Γ would overflow: a difference of logarithms.
fn by_logarithms(n: f64) -> f64 {
    PI.sqrt() * (pxfm::f_lgamma(1.0 + n / 2.0) - pxfm::f_lgamma((n + 1.0) / 2.0)).exp()
}

/// κ_n = ₂F₁(1, n; 1+n/2; 1/2), Gauss's second theorem, by its power series: one bit a term in the end.
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
