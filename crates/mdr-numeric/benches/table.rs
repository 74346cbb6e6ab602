//! The transform of a measured profile: time of one evaluation against the number of rows.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use mdr_core::contact::Transform;
use mdr_numeric::table::MeasuredProfile;

fn transform(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("table");
    for rows in [100, 1000, 10_000, 100_000] {
        let radius = |i: usize| i as f64 / (rows - 1) as f64;
        let points: Vec<(f64, f64)> = (0..rows).map(|i| (radius(i), radius(i).powi(2))).collect();
        let Ok(profile) = MeasuredProfile::new(points.clone()) else { continue };
        let x = 0.9173;
        group.bench_function(BenchmarkId::new("g", rows), |b| b.iter(|| profile.g(black_box(&x))));
        group.bench_function(BenchmarkId::new("g'", rows), |b| b.iter(|| profile.slope(black_box(&x))));
        group.bench_function(BenchmarkId::new("G", rows), |b| b.iter(|| profile.integral(black_box(&x))));
        group.sample_size(10);
        group.bench_function(BenchmarkId::new("set-up", rows), |b| b.iter(|| MeasuredProfile::new(points.clone())));
        group.sample_size(100);
    }
    group.finish();
}

criterion_group!(benches, transform);
criterion_main!(benches);
