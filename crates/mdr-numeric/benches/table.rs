//! The transforms of a measured profile: time of an evaluation and of the set-up against the number of rows, and its
//! error: the interpolant of a sphere against the sphere, and doubles against 60 digits.

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use mdr_core::contact::Transform;
use mdr_numeric::table::MeasuredProfile;

const X: f64 = 0.9173;

/// A sphere of radius 2 up to r = 1.
fn sphere(rows: usize) -> Vec<(f64, f64)> {
    let point = |i: usize| {
        let r = i as f64 / (rows - 1) as f64;
        (r, r * r / (2.0 + (4.0 - r * r).sqrt()))
    };
    (0..rows).map(point).collect()
}

/// The relative difference of f64 from 60 digits, for g, g' and G at X.
#[cfg(feature = "mp")]
fn rounding(points: &[(f64, f64)], profile: &MeasuredProfile<f64>) -> mdr_core::contact::Result<[f64; 3]> {
    use rug::Float;
    let wide = |value: f64| Float::with_val(200, value);
    let exact = MeasuredProfile::new(points.iter().map(|&(r, f)| (wide(r), wide(f))).collect())?;
    let x = wide(X);
    let pairs = [
        (profile.g(&X)?, exact.g(&x)?),
        (profile.slope(&X)?, exact.slope(&x)?),
        (profile.integral(&X)?, exact.integral(&x)?),
    ];
    Ok(pairs.map(|(value, exact)| ((wide(value) - &exact) / exact).abs().to_f64()))
}

#[cfg(not(feature = "mp"))]
fn rounding(_: &[(f64, f64)], _: &MeasuredProfile<f64>) -> mdr_core::contact::Result<[f64; 3]> {
    Ok([f64::NAN; 3])
}

fn transform(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("table");
    group.sample_size(10).warm_up_time(Duration::from_millis(200)).measurement_time(Duration::from_secs(1));
    for rows in [100, 1000, 10_000, 100_000] {
        let points = sphere(rows);
        let profile = MeasuredProfile::new(points.clone()).expect("a table");
        let interpolation = profile.g(&X).map_or(f64::NAN, |g| g / (X * (X / 2.0).atanh()) - 1.0);
        let [g, slope, integral] = rounding(&points, &profile).unwrap_or([f64::NAN; 3]);
        eprintln!("{rows} rows: interpolation error of g {interpolation:.1e}");
        eprintln!("{rows} rows: rounding errors of g, g', G {g:.1e}, {slope:.1e}, {integral:.1e}");
        group.bench_function(BenchmarkId::new("g", rows), |b| b.iter(|| profile.g(black_box(&X))));
        group.bench_function(BenchmarkId::new("g'", rows), |b| b.iter(|| profile.slope(black_box(&X))));
        group.bench_function(BenchmarkId::new("G", rows), |b| b.iter(|| profile.integral(black_box(&X))));
        let graded = profile.clone().graded(0.3).expect("on a graded half-space");
        group.bench_function(BenchmarkId::new("g' on a graded half-space", rows), |b| {
            b.iter(|| graded.slope(black_box(&X)))
        });
        let line = profile.clone().line(None).expect("in line contact");
        group.bench_function(BenchmarkId::new("N' in line contact", rows), |b| b.iter(|| line.slope(black_box(&X))));
        group.bench_function(BenchmarkId::new("set-up", rows), |b| b.iter(|| MeasuredProfile::new(points.clone())));
    }
    group.finish();
}

criterion_group!(benches, transform);
criterion_main!(benches);
