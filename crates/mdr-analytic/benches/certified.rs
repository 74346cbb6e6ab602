//! Certified digits beside bare MPFR at the same precision: κ_n, and the four numbers of a critical state (κ, a, d, F).
//!
//! `bare` evaluates the same closed forms over `rug::Float`; `gamma` takes κ from MPFR's Γ, as a textbook program
//! would. Neither has error bounds or prints decimals; `enclosure` includes the proof, `certified` the decimal digits
//! too. `make peers` measures Arb beside `enclosure`.
#![allow(missing_docs, clippy::unwrap_used, reason = "macros of criterion; a benchmark fails by panicking")]

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use mdr_analytic::certified::{Elasticity, Question, kappa};
use mdr_analytic::{Kappa, PowerLaw, PowerLawContact, kappa_enclosure};
use mdr_core::contact::{Control, Material};
use mdr_core::number::{Literal, Precision, Real};
use rug::Float;

const DIGITS: [u32; 3] = [50, 200, 1000];
const EXPONENT: &str = "0.3";

fn literal(text: &str) -> Literal {
    text.parse().unwrap()
}

fn float(digits: u32, text: &str) -> Float {
    Float::from_literal(Precision::from_digits(digits), &literal(text))
}

/// √π Γ(1+n/2)/Γ((n+1)/2).
fn kappa_by_gamma(n: &Float) -> Float {
    let upper = (n.clone() / 2u32) + 1u32;
    let lower = (n.clone() + 1u32) / 2u32;
    upper.gamma() / lower.gamma() * n.pi().sqrt()
}

fn kappas(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("kappa");
    for digits in DIGITS {
        let (exact, n) = (literal(EXPONENT), float(digits, EXPONENT));
        group.bench_function(BenchmarkId::new("certified", digits), |b| b.iter(|| kappa(black_box(&exact), digits)));
        let (precision, fraction) = (Precision::from_digits(digits), exact.to_rational());
        group.bench_function(BenchmarkId::new("enclosure", digits), |b| {
            b.iter(|| kappa_enclosure(precision, black_box(&fraction)));
        });
        group.bench_function(BenchmarkId::new("bare", digits), |b| b.iter(|| Float::kappa(black_box(&n))));
        group.bench_function(BenchmarkId::new("gamma", digits), |b| b.iter(|| kappa_by_gamma(black_box(&n))));
    }
}

fn criticals(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("critical");
    for digits in DIGITS {
        let elasticity = Elasticity::Effective(literal("1e6"));
        let (n, c, w) = (literal(EXPONENT), literal("1.5"), literal("0.05"));
        let ask = || Question::new(&n, &c, &elasticity, &w, &Control::Indentation).unwrap().answer(digits);
        group.bench_function(BenchmarkId::new("certified", digits), |b| b.iter(|| black_box(ask())));
        let question = Question::new(&n, &c, &elasticity, &w, &Control::Indentation).unwrap();
        group.bench_function(BenchmarkId::new("enclosure", digits), |b| {
            b.iter(|| black_box(&question).enclosures(Precision::from_digits(digits)));
        });
        let [n, c, e, w] = [EXPONENT, "1.5", "1e6", "0.05"].map(|text| float(digits, text));
        let state = |profile: PowerLaw<Float>| {
            PowerLawContact::new(profile, Material::new(e.clone(), w.clone()).unwrap()).critical(&Control::Indentation)
        };
        group.bench_function(BenchmarkId::new("bare", digits), |b| {
            b.iter(|| state(PowerLaw::new(black_box(n.clone()), c.clone()).unwrap()));
        });
        group.bench_function(BenchmarkId::new("gamma", digits), |b| {
            b.iter(|| {
                let n = black_box(n.clone());
                let kappa = kappa_by_gamma(&n);
                state(PowerLaw::with_kappa(n, c.clone(), kappa).unwrap())
            });
        });
    }
}

criterion_group!(benches, kappas, criticals);
criterion_main!(benches);
