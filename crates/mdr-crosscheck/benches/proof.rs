//! Cost of proving all folds of a paraboloid with waves, by their number: it has to be the same for each fold.
#![allow(clippy::print_stdout, reason = "the number of folds is part of the result")]

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, SamplingMode, Throughput, criterion_group, criterion_main};
use mdr_analytic::profiles::WavyParaboloid;
use mdr_analytic::struve::Struve;
use mdr_core::contact::{Control, Material, Result};
use mdr_core::number::{Dual, Interval, Precision, Real};
use mdr_numeric::curve::Curve;
use mdr_numeric::proof::{EnclosedCurve, ProvedFolds};
use rug::Float;

const BITS: u32 = 64;

/// R = 1 and waves that are steeper than the paraboloid up to a = 0.1: 2a/R = (π/2)Ak√(2ka/π), k = 10πN, about N folds.
fn waves<R: Struve>(ctx: R::Ctx, folds: u32) -> Result<WavyParaboloid<R>> {
    let k = 10.0 * std::f64::consts::PI * f64::from(folds);
    let amplitude = 0.4 / (std::f64::consts::PI * k) / (0.2 * k / std::f64::consts::PI).sqrt();
    let number = |value: f64| R::from_f64(ctx, value);
    WavyParaboloid::new(number(1.0), number(amplitude), number(0.2 / f64::from(folds)))
}

fn prove(folds: u32) -> Result<ProvedFolds> {
    let ctx = Precision::new(BITS);
    let (plain, moving) = (waves::<Interval>(ctx, folds)?, waves::<Dual<Interval>>(ctx, folds)?);
    let material = Material::new(Interval::from_int(ctx, 1), Interval::from_int(ctx, 1).over(10_000))?;
    let lifted = |value: &Interval| Dual::constant(value.clone());
    let moving_material = Material::new(lifted(material.effective_modulus()), lifted(material.work_of_adhesion()))?;
    let curve = Curve::new(&plain, &material, &Control::Indentation);
    let moving = Curve::new(&moving, &moving_material, &Control::Indentation);
    let ends = [1e-6, 1e3].map(|end| Float::with_val(BITS, end));
    EnclosedCurve::new(curve, moving).folds(&ends[0], &ends[1], 100_000_000)
}

fn proved_folds(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("proved folds");
    group.sample_size(10).sampling_mode(SamplingMode::Flat).warm_up_time(Duration::from_millis(100));
    for waves in [3, 30, 300, 3000, 10_000] {
        let found = prove(waves).expect("a proof");
        assert!(found.is_complete(), "{:?}", found.undecided);
        println!("{} folds, {} evaluations", found.folds.len(), found.evaluations);
        group.throughput(Throughput::Elements(found.folds.len() as u64));
        group.bench_function(BenchmarkId::from_parameter(found.folds.len()), |bencher| {
            bencher.iter(|| prove(black_box(waves)));
        });
    }
    group.finish();
}

criterion_group!(benches, proved_folds);
criterion_main!(benches);
