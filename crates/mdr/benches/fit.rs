//! Fits of 1000 rows with four free numbers, on one core.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use mdr::fit::{Observation, Problem};
use mdr::prelude::*;

/// A curve with a detached tail that the theory has made, with a ripple of σ instead of noise.
fn rows(tip: &Shape<&'static str>, contact: f64, tail: f64) -> (Vec<f64>, Vec<f64>) {
    let scene = Scene::new(tip.clone(), Elasticity::effective("2e6").expect("positive"), "0.05").expect("positive");
    let values: Vec<Literal> = (0..700)
        .map(|index| Literal::try_from(2e-6 - (2e-6 + contact) * f64::from(index) / 700.0).expect("finite"))
        .collect();
    let answer = scene.want(Want::Equilibria { at: values }).arithmetic(Arithmetic::Double).solve().expect("solved");
    let equilibria = answer.equilibria().expect("wanted");
    let mut x = Vec::new();
    let mut y = Vec::new();
    for at in &equilibria.items {
        let stable = at.states.iter().filter_map(|state| state.force.to_f64()).next_back();
        if let Some(force) = stable {
            x.push(at.value.nearest_f64());
            y.push(force);
        }
    }
    while x.len() < 1000 {
        x.push(-tail - 1e-9 * x.len() as f64);
        y.push(0.0);
    }
    for (index, y) in y.iter_mut().enumerate() {
        *y += 1e-8 * (index as f64 * 1.7).sin();
    }
    (x, y)
}

fn fits(criterion: &mut Criterion) {
    let sphere = Shape::Paraboloid { radius: "1e-5" };
    let (x, y) = rows(&sphere, 2.8e-7, 4e-7);
    criterion.bench_function("fit/paraboloid/1000 rows, 4 free", |bencher| {
        bencher.iter(|| {
            let problem =
                Problem::new(sphere.clone(), Observation::ForceOfIndentation, black_box(&x), &y).expect("rows");
            problem
                .free(["e_star", "work_of_adhesion", "contact_point", "baseline"])
                .expect("names")
                .fit()
                .expect("fitted")
        });
    });
}

criterion_group!(benches, fits);
criterion_main!(benches);
