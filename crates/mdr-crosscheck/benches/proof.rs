//! Cost of proving all folds of a paraboloid with waves, by their number: it has to be the same for each fold.
#![allow(clippy::print_stdout, reason = "the number of folds is part of the result")]

mod waves;

use std::hint::black_box;
use std::sync::Arc;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, SamplingMode, Throughput, criterion_group, criterion_main};
use mdr_core::contact::{Control, Material, Result};
use mdr_core::number::{Dual, Interval, Precision, Real};
use mdr_numeric::contact::Contact;
use mdr_numeric::proof::{EnclosedCurve, ProvedFolds};
use rug::Float;
use waves::{CASES, waves};

const BITS: u32 = 64;

fn prove(count: u32) -> Result<ProvedFolds> {
    let ctx = Precision::new(BITS);
    let (plain, moving) = (Arc::new(waves::<Interval>(ctx, count)?), Arc::new(waves::<Dual<Interval>>(ctx, count)?));
    let material = Material::new(Interval::from_int(ctx, 1), Interval::from_int(ctx, 1).over(10_000))?;
    let lifted = |value: &Interval| Dual::constant(value.clone());
    let moving_material = Material::new(lifted(material.effective_modulus()), lifted(material.work_of_adhesion()))?;
    let curve = Contact::half_space(&plain, &material, &Control::Indentation);
    let moving = Contact::half_space(&moving, &moving_material, &Control::Indentation);
    let ends = [1e-6, 1e3].map(|end| Float::with_val(BITS, end));
    EnclosedCurve::new(curve, moving).folds(&ends[0], &ends[1], 100_000_000)
}

fn proved_folds(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("proved folds");
    group.sample_size(10).sampling_mode(SamplingMode::Flat).warm_up_time(Duration::from_millis(100));
    for (count, folds) in CASES {
        let found = prove(count).expect("a proof");
        assert!(found.is_complete(), "{:?}", found.undecided);
        assert_eq!(found.folds.len(), folds);
        println!("{folds} folds, {} evaluations", found.evaluations);
        group.throughput(Throughput::Elements(folds as u64));
        group.bench_function(BenchmarkId::from_parameter(folds), |bencher| {
            bencher.iter(|| prove(black_box(count)));
        });
    }
    group.finish();
}

criterion_group!(benches, proved_folds);
criterion_main!(benches);
