//! The kernel for many points against the generic closed form in 128 bits, with which it shares no code.
//!
//! The bounds are those that the documentation of the kernel derives. They are asserted from below too: an error far
//! under its bound would mean that the test looks away.
#![allow(clippy::unwrap_used, reason = "the helpers belong to the tests")]
#![allow(clippy::print_stdout, reason = "the errors measured are worth reading")]

use std::f64::consts::PI;

use mdr_analytic::double::grid::{Materials, Path, Points, States, Tally, critical_states, critical_states_on};
use mdr_analytic::{Contact, Critical, Kappa, PowerLaw, double};
use mdr_core::contact::{Control, Error, Material, Quantity, Ranged, Status};
use mdr_core::number::{Real, Wide};
use rand::rngs::SmallRng;
use rand::{RngExt, SeedableRng};

const CONTROLS: [Control<f64>; 2] = [Control::Indentation, Control::Force];
/// κ, a, d, F in ulp.
const BOUNDS: [f64; 4] = [1.8, 1.6, 1.3, 1.9];
const PROMISE: f64 = 2.0;

#[derive(Clone, Copy, Debug)]
struct Point {
    n: f64,
    c: f64,
    e: f64,
    w: f64,
}

impl Point {
    /// With C such that a is near `a` under controlled indentation.
    fn with_radius(n: f64, e: f64, w: f64, a: f64) -> Self {
        let ln_c = (PI * w / (2.0 * e)).ln() / 2.0 + (0.5 - n) * a.ln() - (n * double::kappa(n).unwrap()).ln();
        Point { n, c: ln_c.exp(), e, w }
    }
}

/// The same radii under `control`: 3C under a dead load.
fn loaded(points: &[Point], control: &Control<f64>) -> Vec<Point> {
    let factor = if matches!(control, Control::Force) { 3.0 } else { 1.0 };
    points.iter().map(|p| Point { c: p.c * factor, ..*p }).collect()
}

/// Those whose results are normal numbers (or d = 0).
fn representable(mut points: Vec<Point>, control: &Control<f64>) -> Vec<Point> {
    points.retain(|p| {
        let state = Material::new(p.e, p.w).and_then(|m| double::critical(p.n, p.c, &m, control));
        state.is_ok_and(|Critical { contact_radius, indentation, force }| {
            [contact_radius, indentation, force]
                .iter()
                .all(|x| matches!(x, Ranged::Value(v) if v.is_normal() || *v == 0.0))
        })
    });
    points
}

#[derive(Clone, Debug, PartialEq)]
struct Answers {
    values: [Vec<f64>; 4],
    status: Vec<Status>,
    tally: Tally,
}

impl Answers {
    fn of(points: &Points<'_>, path: Path, control: &Control<f64>) -> Self {
        let len = points.exponent.len();
        let mut values = [(); 4].map(|()| vec![f64::NAN; len]);
        let mut status = vec![Status::Undecided; len];
        let [kappa, contact_radius, indentation, force] = &mut values;
        let mut states = States { kappa, contact_radius, indentation, force, status: &mut status };
        let tally = critical_states_on(path, points, control, &mut states).unwrap();
        Answers { values, status, tally }
    }

    fn at(&self, i: usize) -> [f64; 4] {
        [0, 1, 2, 3].map(|q| self.values[q][i])
    }
}

fn columns(points: &[Point]) -> [Vec<f64>; 4] {
    [|p: &Point| p.n, |p: &Point| p.c, |p: &Point| p.e, |p: &Point| p.w].map(|f| points.iter().map(f).collect())
}

fn answers(points: &[Point], path: Path, control: &Control<f64>) -> Answers {
    let [n, c, e, w] = columns(points);
    let material = Materials::Each { effective_modulus: &e, work_of_adhesion: &w };
    Answers::of(&Points { exponent: &n, coefficient: &c, material }, path, control)
}

/// κ, a, d, F by the generic formulas.
fn truth(p: &Point, control: &Control<f64>) -> [Wide<2>; 4] {
    let wide = |x: f64| Wide::<2>::from(x);
    let control = match control {
        Control::Force => Control::Force,
        _ => Control::Indentation,
    };
    let material = Material::new(wide(p.e), wide(p.w)).unwrap();
    let state = Contact::new(PowerLaw::new(wide(p.n), wide(p.c)).unwrap(), material).critical(&control).unwrap();
    [Wide::<2>::kappa(&wide(p.n)), state.contact_radius, state.indentation, state.force]
}

fn ulps(value: f64, truth: &Wide<2>) -> f64 {
    let size = truth.approx().abs();
    if size == 0.0 {
        return value.abs() / f64::MIN_POSITIVE;
    }
    // By the exponent of the truth, not of a value rounded up to a power of two.
    let ulp = if Wide::from(size) > truth.abs() { size - size.next_down() } else { size.next_up() - size };
    (Wide::from(value) - truth).approx().abs() / ulp
}

/// The worst errors of κ, a, d and F over the points whose results are normal; no point may fail.
fn worst(points: &[Point], path: Path, control: &Control<f64>) -> ([f64; 4], Tally) {
    let answers = answers(points, path, control);
    let mut worst = [0.0f64; 4];
    for (i, p) in points.iter().enumerate() {
        assert_eq!(answers.status[i], Status::Ok, "{p:?}");
        for (q, (value, truth)) in answers.at(i).iter().zip(truth(p, control)).enumerate() {
            let error = ulps(*value, &truth);
            assert!(error <= PROMISE, "{} of {p:?} under {control:?} by {path}: {error} ulp", ["κ", "a", "d", "F"][q]);
            worst[q] = worst[q].max(error);
        }
    }
    (worst, answers.tally)
}

struct Draw(SmallRng);

impl Draw {
    fn new(seed: u64) -> Self {
        Draw(SmallRng::seed_from_u64(seed))
    }

    fn between(&mut self, from: f64, to: f64) -> f64 {
        self.0.random_range(from..to)
    }

    fn power(&mut self, from: f64, to: f64) -> f64 {
        10f64.powf(self.between(from, to))
    }

    /// Laboratory values: a from 10 nm to 10 cm.
    fn laboratory(&mut self) -> Point {
        let (n, e, w) = (self.between(0.05, 4.0), self.power(3.0, 11.0), self.power(-3.0, 0.0));
        Point::with_radius(n, e, w, self.power(-8.0, -1.0))
    }

    /// The whole domain of the kernel, dense where the budget is largest: n → 0, n → 1/2, |ln a| → 200.
    fn domain(&mut self) -> Point {
        let n = match self.0.random_range(0..4) {
            0 => self.power(-9.0, 2.7),
            1 => self.between(0.001, 0.1),
            2 => 0.5 + self.power(-10.5, -0.5).copysign(self.between(-1.0, 1.0)),
            _ => self.between(0.1, 20.0),
        };
        let (e, w, a) = (self.power(-24.0, 24.0), self.power(-24.0, 24.0), self.between(-199.0, 198.0).exp());
        Point::with_radius(n.max(1e-9), e, w, a)
    }
}

fn in_range(p: &Point) -> bool {
    (1e-117..1e117).contains(&p.c)
}

fn measure(count: usize) {
    let mut draw = Draw::new(11);
    let laboratory: Vec<Point> = (0..count).map(|_| draw.laboratory()).collect();
    let domain: Vec<Point> = (0..count).map(|_| draw.domain()).filter(in_range).collect();
    assert!(domain.len() > count / 2);
    for path in Path::available() {
        let mut all = [0.0f64; 4];
        for control in &CONTROLS {
            let (errors, tally) = worst(&loaded(&laboratory, control), path, control);
            assert_eq!(tally, Tally::default(), "laboratory values take the fast path");
            let (extremes, tally) = worst(&loaded(&domain, control), path, control);
            // The rounding of C moves a near n = 1/2.
            assert!(tally.passed_on < domain.len() / 20, "{} of {}", tally.passed_on, domain.len());
            all = [0, 1, 2, 3].map(|q| all[q].max(errors[q]).max(extremes[q]));
        }
        println!("{path}: worst κ, a, d, F in ulp over {} points: {all:.3?}", 2 * (laboratory.len() + domain.len()));
        for (error, bound) in all.into_iter().zip(BOUNDS) {
            assert!(error <= bound, "{path}: {error} ulp, the bound is {bound}");
            assert!(error >= 0.5, "{path}: {error} ulp cannot be the worst of {count}");
        }
    }
}

#[test]
fn errors_stay_within_the_bounds() {
    measure(10_000);
}

/// Roundings have no preference, so the mean of many errors shows what is far below the bound of one: a constant without
/// its second part, or a coefficient with a wrong last digit. The fit of X may prefer a side by 0.03 u; the mean of
/// 3000 roundings, each of 0.35 ulp or less in the mean square, strays by more than 0.03 ulp once in a million.
#[test]
fn errors_have_no_preference() {
    let mut draw = Draw::new(3);
    for (from, to) in [(1e-3, 0.1), (0.1, 0.45), (0.55, 1.0), (1.0, 4.0), (4.0, 20.0), (20.0, 500.0)] {
        let mut point = || {
            let (n, e, w) = (draw.between(from, to), draw.power(3.0, 11.0), draw.power(-3.0, 0.0));
            // C = a^(1/2−n) must not leave the fast path.
            let decades = 8f64.min(100.0 / to);
            Point::with_radius(n, e, w, draw.power(-decades, decades))
        };
        let points: Vec<Point> = (0..3000).map(|_| point()).filter(in_range).collect();
        assert!(points.len() > 2000, "n from {from} to {to}: {}", points.len());
        let truths: Vec<_> = points.iter().map(|p| truth(p, &Control::Indentation)).collect();
        for path in Path::available() {
            let answers = answers(&points, path, &Control::Indentation);
            for (q, name) in ["κ", "a", "d", "F"].into_iter().enumerate() {
                let errors = truths.iter().enumerate().map(|(i, truth)| {
                    let (value, truth) = (answers.values[q][i], &truth[q]);
                    ulps(value, truth).copysign((Wide::from(value.abs()) - truth.abs()).approx())
                });
                let mean = errors.sum::<f64>() / points.len() as f64;
                println!("{name}, n from {from} to {to}, {path}: {mean:.4}");
                assert!(mean.abs() < 0.06, "{name} for n from {from} to {to} by {path}: {mean} ulp in the mean");
            }
        }
    }
}

/// `cargo test --release -p mdr-analytic --test double_grid -- --ignored --nocapture`
#[test]
#[ignore = "minutes"]
fn errors_of_many_points() {
    measure(300_000);
}

#[test]
fn ladder_towards_one_half() {
    let mut points = Vec::new();
    for k in 2..=50 {
        for n in [0.5 + 2f64.powi(-k), 0.5 - 2f64.powi(-k)] {
            for (e, w, a) in [(1e6, 0.05, 1e-3), (1e20, 1e-20, 1e-40), (1.0, 1.0, 1.0), (1e200, 1e-100, 1e-40)] {
                points.push(Point::with_radius(n, e, w, a));
            }
        }
    }
    for path in Path::available() {
        for control in &CONTROLS {
            // The rounding of C moves a, for the largest k out of range.
            let points = representable(loaded(&points, control), control);
            assert!(points.len() > 250, "{}", points.len());
            let (_, tally) = worst(&points, path, control);
            assert!(tally.passed_on < points.len() / 2, "{} of {}", tally.passed_on, points.len());
        }
    }
}

/// Both sides of every limit of the kernel.
#[test]
fn the_edges_of_the_domain() {
    let two = |k: i32| 2f64.powi(k);
    let about = |x: f64| [x.next_down(), x, x.next_up()];
    let mut points = Vec::new();
    for n in about(two(-30)).into_iter().chain(about(512.0)).chain(about(0.5 + two(-37))).chain(about(0.5 - two(-37))) {
        for a in [1e-80, 1.0, 1e80] {
            points.push(Point::with_radius(n, 1.0, 1.0, a));
        }
    }
    for (c, n) in [(two(-390), 2.0), (two(390), 2.0), (two(-390), 3e-9), (two(390), 300.0)] {
        points.extend(about(c).map(|c| Point { n, c, e: 1.0, w: 1.0 }));
    }
    for x in [two(-80), two(80)] {
        for y in [two(-80), 1.0, two(80)] {
            points.extend(about(x).map(|e| Point { n: 2.0, c: 1.0, e, w: y }));
            points.extend(about(x).map(|w| Point { n: 0.3, c: 1.0, e: y, w }));
        }
    }
    for a in [-200.0, 200.0] {
        points.extend([a - 1e-9, a, a + 1e-9].map(|a: f64| Point::with_radius(1.3, 1.0, 1.0, a.exp())));
    }
    for path in Path::available() {
        for control in &CONTROLS {
            let points = representable(points.clone(), control);
            let (_, tally) = worst(&points, path, control);
            let few = points.len() / 5;
            assert!(tally.passed_on > few && tally.passed_on < points.len() - few, "{tally:?} of {}", points.len());
        }
    }
}

/// What the kernel cannot promise: the scalar answer, or its status and no value.
#[test]
fn every_other_point_is_the_scalar_answer() {
    let special =
        [0.0, -0.0, -1.0, 5e-324, 1e-310, 1e-300, 1.0, 1e200, f64::MAX, f64::INFINITY, f64::NAN, -f64::INFINITY];
    let exponents = [1e-300, 1e-12, 0.3, 0.5, 0.5 + 2f64.powi(-45), 0.5f64.next_up(), 1.5, 2.0, 700.0, 1e16, f64::MAX];
    let mut points = Vec::new();
    for n in special.into_iter().chain(exponents) {
        for c in special.into_iter().chain([1e-150, 1e150]) {
            for (e, w) in [(1.0, 1.0), (1e200, 1e-200), (1e-200, 1e200), (f64::NAN, 1.0), (1.0, -1.0), (0.0, 1.0)] {
                points.push(Point { n, c, e, w });
            }
        }
    }
    let mut seen = Vec::new();
    for path in Path::available() {
        for control in CONTROLS.into_iter().chain([Control::Machine { stiffness: 30.0 }]) {
            let answers = answers(&points, path, &control);
            let mut without_value = 0;
            for (i, p) in points.iter().enumerate() {
                let [kappa, values @ ..] = answers.at(i);
                let scalar = Material::new(p.e, p.w).and_then(|m| double::critical(p.n, p.c, &m, &control));
                check(&values, answers.status[i], &scalar, p);
                let expected = double::kappa(p.n).unwrap_or(f64::NAN);
                assert!(
                    (kappa - expected).abs() <= 2.0 * expected * f64::EPSILON || kappa.is_nan() && expected.is_nan()
                );
                without_value += usize::from(answers.status[i] != Status::Ok);
                seen.push(answers.status[i]);
            }
            assert_eq!(answers.tally.without_value, without_value);
            assert!(answers.tally.passed_on >= without_value);
        }
    }
    for status in [Status::Ok, Status::Overflow, Status::Underflow, Status::DomainError] {
        assert!(seen.contains(&status), "{status}");
    }
}

#[track_caller]
fn check(values: &[f64], status: Status, scalar: &mdr_core::contact::Result<Critical<Ranged<f64>>>, p: &Point) {
    let Ok(Critical { contact_radius, indentation, force }) = scalar else {
        assert!(values.iter().all(|x| x.is_nan()), "{p:?}: {values:?}");
        let expected =
            if matches!(scalar, Err(Error::Domain { .. })) { Status::DomainError } else { Status::Undecided };
        assert_eq!(status, expected, "{p:?}");
        return;
    };
    let mut first = Status::Ok;
    for (value, expected) in values.iter().zip([contact_radius, indentation, force]) {
        match expected {
            Ranged::Value(x) => assert!((value - x).abs() <= 2.0 * x.abs() * f64::EPSILON, "{p:?}: {value:e}, {x:e}"),
            _ => {
                assert!(value.is_nan(), "{p:?}: {value:e}");
                first = if first == Status::Ok { expected.status() } else { first };
            }
        }
    }
    assert_eq!(status, first, "{p:?}");
}

#[test]
fn exact_results_are_exact() {
    let points = [1.5, 2.0, 6.0].map(|n| Point { n, c: 0.5, e: 1.0, w: 1.0 });
    for path in Path::available() {
        let answers = answers(&points, path, &Control::Force);
        assert_eq!(answers.tally, Tally::default());
        assert_eq!(answers.at(0)[2], 0.0, "d of n = 3/2 under a dead load");
        assert_eq!(answers.at(1)[0], 2.0, "κ_2");
        assert_eq!(answers.at(2)[0], 3.2, "κ_6 = 16/5");
        assert_eq!(answers.at(1)[3], -1.5 * PI, "F = −(3/2)πwR");
    }
}

/// A point's answer depends neither on its place, nor on how its material was given, nor on the vectors' width.
#[test]
fn place_material_and_width_do_not_matter() {
    let mut draw = Draw::new(5);
    let gel = Material::new(1e4, 0.05).unwrap();
    let mut points: Vec<Point> = (0..200).map(|_| Point { e: 1e4, w: 0.05, ..draw.laboratory() }).collect();
    points[70].n = 0.5;
    points[130].c = -1.0;
    let bits = |answers: &Answers, i: usize| answers.at(i).map(f64::to_bits);
    let [n, c, ..] = columns(&points);
    let one = |range: std::ops::Range<usize>| Points {
        exponent: &n[range.clone()],
        coefficient: &c[range],
        material: Materials::One(&gel),
    };
    for path in Path::available() {
        let whole = answers(&points, path, &Control::Indentation);
        for start in [0, 1, 37] {
            for end in start..points.len() {
                let part = Answers::of(&one(start..end), path, &Control::Indentation);
                for i in start..end {
                    assert_eq!(bits(&part, i - start), bits(&whole, i), "{i} of {start}..{end} by {path}");
                    assert_eq!(part.status[i - start], whole.status[i]);
                }
            }
        }
    }
    if let (Some(four), Some(eight)) = (Path::avx2(), Path::avx512()) {
        let (four, eight) = (answers(&points, four, &Control::Force), answers(&points, eight, &Control::Force));
        assert!((0..points.len()).all(|i| bits(&four, i) == bits(&eight, i)));
    }
}

#[test]
fn slices_of_different_lengths_are_refused() {
    let quantities = [
        Quantity::Coefficient,
        Quantity::EffectiveModulus,
        Quantity::WorkOfAdhesion,
        Quantity::Kappa,
        Quantity::ContactRadius,
        Quantity::Indentation,
        Quantity::Force,
        Quantity::Parameter("the status"),
    ];
    for (wrong, quantity) in quantities.into_iter().enumerate() {
        let ones = [1.0; 9];
        let len = |i: usize| if i == wrong { 8 } else { 9 };
        let mut out = [[0.0; 9]; 4];
        let mut status = [Status::Ok; 9];
        let [kappa, radius, indentation, force] = &mut out;
        let points = Points {
            exponent: &ones,
            coefficient: &ones[..len(0)],
            material: Materials::Each { effective_modulus: &ones[..len(1)], work_of_adhesion: &ones[..len(2)] },
        };
        let mut states = States {
            kappa: &mut kappa[..len(3)],
            contact_radius: &mut radius[..len(4)],
            indentation: &mut indentation[..len(5)],
            force: &mut force[..len(6)],
            status: &mut status[..len(7)],
        };
        let refused = critical_states(&points, &Control::Force, &mut states);
        assert_eq!(refused, Err(Error::Length { quantity, len: 8, expected: 9 }));
    }
    let error = Error::Length { quantity: Quantity::Force, len: 8, expected: 9 };
    assert_eq!(error.to_string(), "the normal force F: 8 given for 9 points");
    let mut none = Answers { values: [(); 4].map(|()| vec![]), status: vec![], tally: Tally::default() };
    let [kappa, contact_radius, indentation, force] = &mut none.values;
    let mut states = States { kappa, contact_radius, indentation, force, status: &mut none.status };
    let gel = Material::new(1e4, 0.05).unwrap();
    let points = Points { exponent: &[], coefficient: &[], material: Materials::One(&gel) };
    let machine = Control::Machine { stiffness: -1.0 };
    assert!(matches!(critical_states(&points, &machine, &mut states), Err(Error::Domain { .. })));
}
