//! The results of the kernel and their errors.

use mdr_analytic::double::grid::{BatchReport, InstructionSet, Materials, Points, States, critical_states_on};
use mdr_analytic::{Kappa, PowerLaw, PowerLawContact};
use mdr_core::contact::{Control, Material, Status};
use mdr_core::number::{Extended, Real};

use super::points::{Point, columns};

pub(crate) const PROMISE: f64 = 2.0;

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Answers {
    pub(crate) values: [Vec<f64>; 4],
    pub(crate) status: Vec<Status>,
    pub(crate) tally: BatchReport,
}

impl Answers {
    pub(crate) fn of(points: &Points<'_>, path: InstructionSet, control: &Control<f64>) -> Self {
        let len = points.exponent.len();
        let mut values = [(); 4].map(|()| vec![f64::NAN; len]);
        let mut status = vec![Status::Undecided; len];
        let [kappa, contact_radius, indentation, force] = &mut values;
        let mut states = States { kappa, contact_radius, indentation, force, status: &mut status };
        let tally = critical_states_on(path, points, control, &mut states).unwrap();
        Answers { values, status, tally }
    }

    pub(crate) fn at(&self, i: usize) -> [f64; 4] {
        [0, 1, 2, 3].map(|q| self.values[q][i])
    }
}

pub(crate) fn answers(points: &[Point], path: InstructionSet, control: &Control<f64>) -> Answers {
    let [n, c, e, w] = columns(points);
    let material = Materials::Each { effective_modulus: &e, work_of_adhesion: &w };
    Answers::of(&Points { exponent: &n, coefficient: &c, material }, path, control)
}

/// κ, a, d, F by the generic formulas.
pub(crate) fn truth(p: &Point, control: &Control<f64>) -> [Extended<2>; 4] {
    let wide = |x: f64| Extended::<2>::from(x);
    let control = match control {
        Control::Force => Control::Force,
        _ => Control::Indentation,
    };
    let material = Material::new(wide(p.e), wide(p.w)).unwrap();
    let state =
        PowerLawContact::new(PowerLaw::new(wide(p.n), wide(p.c)).unwrap(), material).critical(&control).unwrap();
    [Extended::<2>::kappa(&wide(p.n)), state.contact_radius, state.indentation, state.force]
}

pub(crate) fn ulps(value: f64, truth: &Extended<2>) -> f64 {
    let size = truth.approx().abs();
    if size == 0.0 {
        return value.abs() / f64::MIN_POSITIVE;
    }
    // By the exponent of the true value, not of a value rounded up to a power of two.
    let ulp = if Extended::from(size) > truth.abs() { size - size.next_down() } else { size.next_up() - size };
    (Extended::from(value) - truth).approx().abs() / ulp
}

/// The worst errors of κ, a, d and F over the points whose results are normal; no point may fail.
pub(crate) fn worst(points: &[Point], path: InstructionSet, control: &Control<f64>) -> ([f64; 4], BatchReport) {
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
