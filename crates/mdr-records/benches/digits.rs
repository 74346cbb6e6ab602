//! What certifying a value costs, from 50 to 2000 digits: a critical state and an equilibrium of a sphere, the transform and
//! the folds of a paraboloid with waves.

#![allow(
    missing_docs,
    clippy::unwrap_used,
    reason = "criterion's macros have no place for documents; a panic ends the run"
)]

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use mdr::prelude::*;

/// The scenes by name.
fn scenes() -> [(&'static str, Scene); 4] {
    let one = || Elasticity::effective("1").unwrap();
    let sphere = || Scene::new(Shape::Power { n: "2", c: "0.5" }, one(), "1").unwrap();
    let waves = Shape::WavyParaboloid { radius: "1", amplitude: "0.0005", wavelength: "0.1" };
    let waves = Scene::new(waves, one(), "0.0001").unwrap();
    let at = |text: &str| vec![text.parse().unwrap()];
    let range = ["1e-6", "1e3"].map(|end| end.parse().unwrap());
    [
        ("Critical", sphere().control(Control::Force).want(Want::Folds { range: None })),
        ("Equilibrium", sphere().want(Want::Equilibria { at: at("-1.5") })),
        ("Transform", waves.clone().want(Want::Transform { at: at("0.0645") })),
        ("Folds", waves.want(Want::Folds { range: Some(range) })),
    ]
}

fn digits(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("certified");
    group.sample_size(10);
    for digits in [50, 100, 200, 500, 1000, 2000] {
        for (name, scene) in scenes() {
            let scene = scene.arithmetic(Arithmetic::Certified { digits });
            group.bench_function(BenchmarkId::new(name, digits), |bench| bench.iter(|| scene.solve().unwrap()));
        }
    }
    group.finish();
}

criterion_group!(benches, digits);
criterion_main!(benches);
