//! Fits of 1000 rows with four free numbers, on one core.

use std::f64::consts::PI;
use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use mdr::prelude::*;
use mdr_analytic::profiles::closed_form;
use mdr_fit::{Observation, Problem};

const E_STAR: f64 = 2e6;
const WORK: f64 = 0.05;

/// A curve on retraction from the contact radius `to`, as far as it is stable, with a detached tail and a ripple for noise.
fn rows(tip: &Shape<&'static str>, to: f64) -> (Vec<f64>, Vec<f64>) {
    let transform = closed_form(tip.map(|_, text| text.parse::<f64>().expect("a number"))).expect("in its domain");
    let state = |index: usize| {
        let a = to * (1.0 - index as f64 / 1000.0);
        let d = transform.g(&a).expect("in range") - (2.0 * PI * a * WORK / E_STAR).sqrt();
        [d, 2.0 * E_STAR * a * (d - transform.mean(&a).expect("in range"))]
    };
    let mut states: Vec<[f64; 2]> = vec![state(0)];
    for index in 1..850 {
        let next = state(index);
        if next[0] < states.last().map_or(f64::INFINITY, |last| last[0]) {
            states.push(next);
        }
    }
    let last = states.last().map_or(0.0, |last| last[0]);
    while states.len() < 1000 {
        states.push([last - 2e-7 - 1e-9 * states.len() as f64, 0.0]);
    }
    let smallest = states.iter().map(|state| state[1]).fold(f64::INFINITY, f64::min).abs();
    let ripple = |index: usize| 1e-2 * smallest * (index as f64 * 1.7).sin();
    (
        states.iter().map(|state| state[0]).collect(),
        states.iter().enumerate().map(|(index, state)| state[1] + ripple(index)).collect(),
    )
}

fn fits(criterion: &mut Criterion) {
    let flank = || Flank::Slope("0.36");
    let tips = [
        (Shape::Paraboloid { radius: "1e-5" }, 6e-6),
        (Shape::Sphere { radius: "1e-5" }, 5e-6),
        (Shape::Power { n: "1.5", c: "100" }, 6e-6),
        (Shape::Hyperboloid { flank: flank(), lateral: "1e-6" }, 3e-6),
        (Shape::RoundedPunch { radius: "1e-5", flat: "1e-6" }, 6e-6),
        (Shape::ConeSphericalCap { flank: flank(), radius: "1e-6" }, 3e-6),
        (Shape::WavyParaboloid { radius: "1e-3", amplitude: "5e-8", wavelength: "1e-4" }, 1.2e-4),
    ];
    for (tip, to) in tips {
        let (x, y) = rows(&tip, to);
        criterion.bench_function(&format!("fit/{}/1000 rows, 4 free", tip.name()), |bencher| {
            bencher.iter(|| {
                let problem =
                    Problem::new(tip.clone(), Observation::ForceOfIndentation, black_box(&x), &y).expect("rows");
                problem
                    .free(["e_star", "work_of_adhesion", "contact_point", "baseline"])
                    .expect("names")
                    .fit()
                    .expect("fitted")
            });
        });
    }
}

criterion_group!(benches, fits);
criterion_main!(benches);
