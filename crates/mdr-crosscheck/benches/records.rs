//! What certifying a value costs, from 50 to 2000 digits: a critical state and an equilibrium of a sphere, the transform and
//! the folds of a paraboloid with waves.

#![allow(missing_docs, reason = "criterion's macros have no place for them")]

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use mdr_crosscheck::records::Specimen;

fn digits(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("certified");
    group.sample_size(10);
    for digits in [50, 100, 200, 500, 1000, 2000] {
        for specimen in Specimen::ALL {
            let id = BenchmarkId::new(format!("{specimen:?}"), digits);
            group.bench_function(id, |bench| bench.iter(|| specimen.certify(digits)));
        }
    }
    group.finish();
}

criterion_group!(benches, digits);
criterion_main!(benches);
