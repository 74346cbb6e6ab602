//! The accurate closed forms in `f64` beside naive versions of the same formulas: `cargo bench --bench double`.
//!
//! Every method computes a, d and F of the critical state of 10⁶ random contacts under controlled indentation, in
//! batches of 4096. The batches of all methods are interleaved and the median of each is reported, so that ratios are
//! valid on a busy machine too; ulps are those of the worst of the three results against the accurate method (itself
//! within one ulp). The kernel for many points, which returns κ as well, is measured with each instruction set of the
//! processor, with a material for each point and with one for all.
#![allow(clippy::print_stdout, reason = "a benchmark prints its table")]

use std::f64::consts::PI;
use std::hint::black_box;
use std::time::Instant;

use mdr_analytic::double::grid::{BatchReport, InstructionSet, Materials, Points, States, critical_states_on};
use mdr_analytic::{PowerLaw, PowerLawContact, State, double};
use mdr_core::contact::{Control, Material, Ranged, Status};
use mdr_core::number::Extended;
use rand::rngs::SmallRng;
use rand::{RngExt, SeedableRng};
use rayon::prelude::*;

const POINTS: usize = 1_000_000;
const PASSES: usize = 7;
const BATCH: usize = 4096;

struct Point {
    n: f64,
    c: f64,
    material: Material<f64>,
}

/// n from 0.05 to 4, E* from 1 kPa to 100 GPa, w from 1 mJ/m² to 1 J/m², and C such that a is between 10 nm and 10 cm.
fn points() -> Vec<Point> {
    let mut random = SmallRng::seed_from_u64(1);
    let mut draw = |from: f64, to: f64| random.random_range(from..to);
    (0..POINTS)
        .map(|_| {
            let (n, e, w) = (draw(0.05, 4.0), 10f64.powf(draw(3.0, 11.0)), 10f64.powf(draw(-3.0, 0.0)));
            let a = 10f64.powf(draw(-8.0, -1.0));
            let slope = (PI * w / (2.0 * e)).sqrt() * a.powf(0.5 - n);
            let c = slope / (n * kappa_by(n, pxfm::f_tgamma));
            Point { n, c, material: Material::new(e, w).expect("positive") }
        })
        .collect()
}

fn kappa_by(n: f64, gamma: impl Fn(f64) -> f64) -> f64 {
    PI.sqrt() / 2.0 * n * gamma(n / 2.0) / gamma((n + 1.0) / 2.0)
}

fn kappa_by_logarithms(n: f64) -> f64 {
    PI.sqrt() * (pxfm::f_lgamma(1.0 + n / 2.0) - pxfm::f_lgamma((n + 1.0) / 2.0)).exp()
}

/// (1.15) and (1.17), naively.
fn by_hand(p: &Point, kappa: impl Fn(f64) -> f64) -> [f64; 3] {
    let (n, e, w) = (p.n, *p.material.effective_modulus(), *p.material.work_of_adhesion());
    let nkc = n * kappa(n) * p.c;
    let a = (PI * w / (2.0 * e * nkc * nkc)).powf(1.0 / (2.0 * n - 1.0));
    let d = (1.0 - 2.0 * n) / n * (PI * w * a / (2.0 * e)).sqrt();
    let f = -2.0 * (2.0 * n + 1.0) / (n + 1.0) * (e * PI * w / 2.0).sqrt() * a.powf(1.5);
    [a, d, f]
}

fn accurate(p: &Point) -> [f64; 3] {
    let value = |x: Ranged<f64>| match x {
        Ranged::Value(value) => value,
        _ => f64::NAN,
    };
    match double::critical(p.n, p.c, &p.material, &Control::Indentation) {
        Ok(State { contact_radius, indentation, force }) => [contact_radius, indentation, force].map(value),
        Err(_) => [f64::NAN; 3],
    }
}

/// Whether 64 bits guarantee the last place of all three results.
fn decided_in_one_word(p: &Point) -> bool {
    let wide = |x: f64| Extended::<1>::from(x);
    let state = PowerLaw::new(wide(p.n), wide(p.c)).and_then(|profile| {
        let material = Material::new(wide(*p.material.effective_modulus()), wide(*p.material.work_of_adhesion()))?;
        PowerLawContact::new(profile, material).critical(&Control::Indentation)
    });
    state.is_ok_and(|s| [s.contact_radius, s.indentation, s.force].iter().all(|x| x.nearest_f64().is_some()))
}

type Route = (&'static str, fn(&Point) -> [f64; 3]);
const ROUTES: [Route; 5] = [
    ("by hand, pxfm gamma", |p| by_hand(p, |n| kappa_by(n, pxfm::f_tgamma))),
    ("by hand, pxfm log-gamma", |p| by_hand(p, kappa_by_logarithms)),
    ("by hand, statrs gamma", |p| by_hand(p, |n| kappa_by(n, statrs::function::gamma::gamma))),
    ("by hand, accurate kappa", |p| by_hand(p, |n| double::kappa(n).unwrap_or(f64::NAN))),
    ("double::critical", accurate),
];

fn nanoseconds(points: usize, work: impl FnOnce()) -> f64 {
    let start = Instant::now();
    work();
    start.elapsed().as_secs_f64() * 1e9 / points as f64
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn ulps(x: [f64; 3], y: [f64; 3]) -> f64 {
    (0..3).map(|i| ((x[i] - y[i]) / (y[i].abs() * f64::EPSILON)).abs()).fold(0.0, f64::max)
}

/// The inputs of the kernel for many points, and its outputs.
struct Columns {
    inputs: [Vec<f64>; 4],
    /// C for the same radii when all points have the material of the first.
    coefficient_for_one: Vec<f64>,
    one: Material<f64>,
    outputs: [Vec<f64>; 4],
    status: Vec<Status>,
}

impl Columns {
    fn new(points: &[Point]) -> Self {
        let one = points[0].material.clone();
        let root = |m: &Material<f64>| (m.work_of_adhesion() / m.effective_modulus()).sqrt();
        let column = |f: fn(&Point) -> f64| points.iter().map(f).collect::<Vec<_>>();
        Columns {
            inputs: [
                column(|p| p.n),
                column(|p| p.c),
                column(|p| *p.material.effective_modulus()),
                column(|p| *p.material.work_of_adhesion()),
            ],
            coefficient_for_one: points.iter().map(|p| p.c * root(&one) / root(&p.material)).collect(),
            one,
            outputs: [(); 4].map(|()| vec![0.0; points.len()]),
            status: vec![Status::Ok; points.len()],
        }
    }

    fn run(&mut self, path: InstructionSet, one_material: bool) -> BatchReport {
        let [n, c, e, w] = &self.inputs;
        let each = Materials::Each { effective_modulus: e, work_of_adhesion: w };
        let (coefficient, material) =
            if one_material { (&self.coefficient_for_one, Materials::One(&self.one)) } else { (c, each) };
        let [kappa, contact_radius, indentation, force] = &mut self.outputs;
        let states = &mut States { kappa, contact_radius, indentation, force, status: &mut self.status };
        let points = Points { exponent: n, coefficient, material };
        critical_states_on(path, &points, &Control::Indentation, states).expect("slices of one length")
    }
}

fn main() {
    let points = points();
    let truth: Vec<[f64; 3]> = points.iter().map(accurate).collect();
    assert!(truth.iter().flatten().all(|x| x.is_finite()), "an ordinary point has an ordinary answer");
    let mut batches: Vec<(&[Point], Columns)> =
        points.chunks(BATCH).map(|batch| (batch, Columns::new(batch))).collect();
    let grids: Vec<(InstructionSet, bool)> =
        InstructionSet::available().flat_map(|path| [(path, false), (path, true)]).collect();
    let mut times = vec![Vec::new(); ROUTES.len() + grids.len()];
    let mut parallel = Vec::new();
    for _ in 0..PASSES {
        for (batch, columns) in &mut batches {
            for (&(_, route), times) in ROUTES.iter().zip(&mut times) {
                times.push(nanoseconds(batch.len(), || {
                    black_box(batch.iter().map(route).fold(0.0, |sum, x| sum + x[0] + x[1] + x[2]));
                }));
            }
            for (&(path, one), times) in grids.iter().zip(&mut times[ROUTES.len()..]) {
                times.push(nanoseconds(batch.len(), || {
                    black_box(columns.run(path, one));
                }));
            }
        }
        parallel.push(nanoseconds(POINTS, || {
            black_box(points.par_iter().map(|p| accurate(p).iter().sum::<f64>()).sum::<f64>());
        }));
    }
    let medians: Vec<f64> = times.into_iter().map(median).collect();
    println!(
        "{:28} {:>9} {:>8} {:>12} {:>12}",
        "critical, ordinary points", "ns/point", "ratio", "median ulp", "worst ulp"
    );
    let line = |name: &str, time: f64, errors: Vec<f64>| {
        let worst = errors.iter().copied().fold(0.0, f64::max);
        println!("{name:28} {time:9.1} {:8.3} {:12.1} {worst:12.1}", time / medians[0], median(errors));
    };
    for ((name, route), time) in ROUTES.iter().zip(&medians) {
        line(name, *time, points.iter().zip(&truth).map(|(p, &t)| ulps(route(p), t)).collect());
    }
    for (&(path, one), time) in grids.iter().zip(&medians[ROUTES.len()..]) {
        let mut passed_on = 0;
        let mut errors = Vec::new();
        for ((_, columns), truth) in batches.iter_mut().zip(truth.chunks(BATCH)) {
            passed_on += columns.run(path, one).passed_on;
            let [_, a, d, f] = &columns.outputs;
            // The reference is that of the other materials.
            let compared = if one { 0 } else { truth.len() };
            errors.extend((0..compared).map(|i| ulps([a[i], d[i], f[i]], truth[i])));
        }
        assert_eq!(passed_on, 0, "ordinary points take the fast path");
        if one {
            println!("{:28} {time:9.1} {:8.3}", format!("grid, {path}, one material"), time / medians[0]);
        } else {
            line(&format!("grid, {path}"), *time, errors);
        }
    }
    let parallel = median(parallel);
    let (threads, one) = (rayon::current_num_threads(), medians[ROUTES.len() - 1]);
    let (easy, hard): (Vec<_>, Vec<_>) = points.iter().partition(|p| decided_in_one_word(p));
    let each = |group: &[&Point]| {
        let pass = || drop(black_box(group.iter().map(|p| accurate(p)).collect::<Vec<_>>()));
        median((0..PASSES).map(|_| nanoseconds(group.len(), pass)).collect())
    };
    let share = 100.0 * hard.len() as f64 / POINTS as f64;
    println!(
        "decided in one word {:.1} ns/point; in more words {share:.2} % at {:.0} ns/point",
        each(&easy),
        each(&hard)
    );
    println!("double::critical on {threads} threads {parallel:7.1} ns/point, {:.2} times faster", one / parallel);
}
