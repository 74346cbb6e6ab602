//! Cost of the search for folds in f64, of a loading path over them and of its energies, by the number of folds: it has to be
//! the same for each fold. What the search finds is compared with what was proved.
#![allow(clippy::print_stdout, reason = "the counts are part of the result")]

mod waves;

use std::hint::black_box;
use std::sync::Arc;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, SamplingMode, Throughput, criterion_group, criterion_main};
use mdr_core::contact::{Control, CountingTransform, Material};
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::folds::{self, Folds};
use mdr_numeric::path::{EventKind, Path, PathEnergy, Start};
use waves::{CASES, waves};

/// What a task gives, and how many evaluations it took.
fn during<T>(counted: &CountingTransform<f64>, task: impl FnOnce() -> T) -> (T, u64) {
    let before = counted.evaluations();
    let result = task();
    (result, (counted.evaluations() - before).total())
}

/// From d = 0 down until the surfaces are apart.
fn pull(branches: &SearchedBranches<f64>) -> Path<f64> {
    Path::follow(branches, &Start::Largest, &[0.0, -1.0]).expect("a path")
}

fn paths(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("f64");
    group.sample_size(10).sampling_mode(SamplingMode::Flat);
    group.warm_up_time(Duration::from_millis(100)).measurement_time(Duration::from_secs(2));
    let (material, control) = (Material::new(1.0, 1e-4).expect("a material"), Control::Indentation);
    for (count, proved) in CASES {
        let profile = Box::new(waves((), count).expect("a profile"));
        let counted = Arc::new(CountingTransform::new(profile, &Default::default()));
        let curve = Contact::half_space(&counted, &material, &control);
        let search = || -> Folds<f64> { folds::find(&curve).expect("folds") };
        let (found, searching) = during(&counted, search);
        let folds = found.folds.len();
        println!("{folds} folds found of {proved} that were proved, {:?}", found.completeness);
        let branches = SearchedBranches::cut_at(curve.clone(), found);
        let (path, following) = during(&counted, || pull(&branches));
        let (energies, accounting) = during(&counted, || PathEnergy::new(&path, &branches));
        let jumps = path.events.iter().filter(|event| event.kind == EventKind::Jump).count();
        assert!(path.events.iter().any(|event| event.kind == EventKind::Detached) && energies.is_ok());
        for (task, evaluations) in [("folds", searching), ("path", following), ("energies", accounting)] {
            println!("{task}: {:.1} evaluations a fold", evaluations as f64 / folds as f64);
        }
        println!("path: {jumps} jumps and the detachment");

        group.throughput(Throughput::Elements(folds as u64));
        group.bench_function(BenchmarkId::new("folds", folds), |bencher| bencher.iter(|| black_box(search())));
        group.bench_function(BenchmarkId::new("path", folds), |bencher| bencher.iter(|| pull(black_box(&branches))));
        group.bench_function(BenchmarkId::new("energies", folds), |bencher| {
            bencher.iter(|| PathEnergy::new(black_box(&path), &branches));
        });
    }
    group.finish();
}

criterion_group!(benches, paths);
criterion_main!(benches);
