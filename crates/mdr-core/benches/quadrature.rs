//! The two quadratures on the integral of a power profile, κ_n/n = ∫₀¹ s^(n−1)/√(1−s²) ds at n = 1/4: the rule alone,
//! the value with its error estimate, and the computation of a rule that is not in the cache.
#![allow(missing_docs, clippy::unwrap_used, reason = "macros of criterion; a benchmark fails by panicking")]

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use mdr_core::calculus::gauss_jacobi::GaussLadder;
use mdr_core::calculus::quadrature::tanh_sinh_near_ends;
use mdr_core::calculus::{gauss_jacobi, roundoff_tolerance};
use mdr_core::number::{Precision, Real};
use rug::Float;

/// Nodes for full accuracy: 0.653 per digit and a few more.
fn nodes(digits: u32) -> usize {
    (digits as usize * 2).div_ceil(3)
}

fn rest<R: Real>(s: &R) -> R {
    (s.lit(1) + s).sqrt().inv()
}

fn compare<R: Real>(criterion: &mut Criterion, digits: u32, one: &R) {
    let (alpha, beta, tolerance) = (one.ratio(-1, 2), one.ratio(-3, 4), roundoff_tolerance(one));
    let rule = gauss_jacobi::rule(nodes(digits), &alpha, &beta).unwrap();
    let ladder = GaussLadder::new(&alpha, &beta);

    let mut group = criterion.benchmark_group("quadrature");
    group.sample_size(10);
    group.bench_function(BenchmarkId::new("gauss-jacobi rule", digits), |b| {
        b.iter(|| rule.integrate(|s| Ok(rest(black_box(s)))));
    });
    group.bench_function(BenchmarkId::new("gauss-jacobi estimate", digits), |b| {
        b.iter(|| ladder.integrate(&tolerance, |s| Ok(rest(black_box(s)))));
    });
    group.bench_function(BenchmarkId::new("tanh-sinh estimate", digits), |b| {
        b.iter(|| {
            tanh_sinh_near_ends(&one.lit(0), one, &tolerance, |node| {
                Ok(node.x.pow(&beta) * rest(black_box(&node.x)) / node.from_upper.sqrt())
            })
        });
    });
    let mut k = 0;
    group.bench_function(BenchmarkId::new("gauss-jacobi set-up", digits), |b| {
        b.iter(|| {
            k += 1; // a new exponent each time, or the cached rule would be used
            gauss_jacobi::rule(nodes(digits), &alpha, &one.ratio(k, 1_000_003))
        });
    });
}

fn quadratures(criterion: &mut Criterion) {
    compare(criterion, 16, &1.0);
    for digits in [50, 200] {
        compare(criterion, digits, &Float::with_val(Precision::from_digits(digits).bits(), 1));
    }
}

criterion_group!(benches, quadratures);
criterion_main!(benches);
