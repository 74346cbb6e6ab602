//! Time against digits, from 16 to 10 000: closed forms, and quadratures as far as they go.
//!
//! A contestant is asked for D digits and chooses its precision: ⌈D log₂10⌉ + 16 bits, or D + 1 decimals. What it reaches
//! is judged as everywhere.

mod found;
mod question;
#[cfg(test)]
mod tests;
pub(super) mod truth;

use std::rc::Rc;

use mdr_core::calculus::gauss_jacobi;
use mdr_core::contact::Error;
use mdr_core::number::{Interval, Precision, Real};
use rug::Float;
use serde_json::json;

pub(super) use self::found::{Found, judged};
use self::question::Entry;
pub(super) use self::question::{EXPONENT, Other, Question, questions};
use super::outside::Outsider;
use super::transform::{Contest, Method, Question as Transformed};
use super::{Arithmetic, Clock, Curve, Diagram, Effort, Outcome, Point, Setup, Task, View};

/// The task.
pub(super) const PRECISION: Task = Task {
    name: "precision",
    claim: "time against digits: κ_n, critical states and the transform of a power law",
    diagrams,
};

/// The digits that are asked for.
fn ladder(effort: Effort) -> &'static [u32] {
    match effort {
        Effort::Quick => &[16, 50, 200],
        Effort::Full => &[16, 30, 50, 100, 200, 500, 1000, 2000, 5000, 10_000],
    }
}

/// The most digits that are asked for.
fn most(effort: Effort) -> u32 {
    ladder(effort).last().copied().unwrap_or_default()
}

impl Setup {
    /// The questions, whose truths take seconds, made once.
    pub(super) fn questions(&mut self) -> Rc<[Question]> {
        let made = || questions(enough(most(self.effort))).into();
        Rc::clone(self.questions.get_or_insert_with(made))
    }
}

/// Quadratures end here.
const MOST_OF_QUADRATURE: u32 = 1000;

/// The bits with which a contestant works for so many digits.
fn working(digits: u32) -> Precision {
    Precision::new(Precision::from_digits(digits).bits() + 16)
}

/// The bits of an enclosure that can judge so many digits.
pub(super) fn enough(digits: u32) -> Precision {
    Precision::new(working(digits).bits() + 64)
}

fn diagrams(setup: &mut Setup) -> Vec<Diagram> {
    let questions = setup.questions();
    let mut diagrams: Vec<Diagram> = questions.iter().map(|question| diagram(question, setup)).collect();
    diagrams.push(transform(setup.effort, &setup.clock));
    diagrams
}

fn diagram(question: &Question, setup: &mut Setup) -> Diagram {
    let Setup { effort, clock, ref mut outsiders, .. } = *setup;
    let mut curves: Vec<Curve> =
        question.entries.iter().map(|entry| entry.curve(&question.truths, effort, &clock)).collect();
    let (others, absent) = outsiders.curves(others(question, effort), &question.truths);
    curves.extend(others);
    Diagram {
        id: format!("precision-{}", question.id),
        task: PRECISION.name.to_owned(),
        title: question.title.clone(),
        truth: question.source.to_owned(),
        view: View::Digits,
        ceiling: None,
        shipped: question.entries.first().map_or(String::new(), |entry| entry.name.to_owned()),
        curves,
        omissions: stopped(&question.entries, effort).into_iter().chain(absent).collect(),
    }
}

impl Entry {
    fn curve(&self, truths: &[Interval], effort: Effort, clock: &Clock) -> Curve {
        let point = |&digits: &u32| {
            let setting = setting(digits);
            let (outcome, time) = match (self.solver)(digits) {
                Ok(solver) => {
                    let failed = |error: Error| Outcome::Failed(error.to_string());
                    let outcome = solver().map_or_else(failed, |found| judged(&found, truths));
                    (outcome, clock.time(solver))
                }
                Err(error) => (Outcome::Failed(error.to_string()), None),
            };
            Point { setting, outcome, evaluations: None, time }
        };
        let asked = ladder(effort).iter().filter(|digits| **digits <= self.most);
        Curve::new(self.name, self.arithmetic, asked.map(point).collect())
    }
}

/// Who stops early.
fn stopped(entries: &[Entry], effort: Effort) -> Vec<String> {
    let early = entries.iter().filter(|entry| ladder(effort).iter().any(|digits| *digits > entry.most));
    let told = |entry: &Entry| {
        format!("{} beyond {} digits: the first value of 10 000 digits takes 45 s.", entry.name, entry.most)
    };
    early.map(told).collect()
}

fn setting(digits: u32) -> String {
    format!("{digits} digits")
}

/// Arb and mpmath.
fn others(question: &Question, effort: Effort) -> Vec<Outsider> {
    let asked = |by: &str| {
        let ask = |&digits: &u32| (setting(digits), question.asked(by, digits));
        ladder(effort).iter().map(ask).collect()
    };
    let arb = |&(name, by): &Other| Outsider {
        name,
        package: "python-flint",
        arithmetic: Arithmetic::Certified,
        questions: asked(by),
    };
    let mpmath = Outsider { name: "Γ", package: "mpmath", arithmetic: Arithmetic::Mp, questions: asked("mpmath") };
    question.arb.iter().map(arb).chain([mpmath]).collect()
}

impl Question {
    /// The question for so many digits to a contestant of another project.
    pub(super) fn asked(&self, by: &str, digits: u32) -> serde_json::Map<String, serde_json::Value> {
        let mut fields = self.fields.clone();
        fields.insert("by".to_owned(), json!(by));
        fields.insert("digits".to_owned(), json!(digits));
        fields
    }
}

/// N nodes of Gauss–Jacobi leave (3 + √8)^−2N of a power law.
const NODES_A_DIGIT: f64 = 0.655;

/// g(x) of f = r^(1/4) by quadratures.
fn transform(effort: Effort, clock: &Clock) -> Diagram {
    let question = Transformed::power(0.25);
    let digits: Vec<u32> = ladder(effort).iter().copied().filter(|digits| *digits <= MOST_OF_QUADRATURE).collect();
    let most = working(digits.last().copied().unwrap_or_default());
    let enough = Precision::new(most.bits() + 64);
    let power = Interval::from_f64(enough, question.x).sqrt().sqrt();
    let truth = truth::kappa_of_fraction(enough, 1, 4) * power;
    let contest = Contest { question: &question, truth: Some(&truth), effort, clock };
    let nodes = |digits: u32| (f64::from(digits) * NODES_A_DIGIT) as usize + 3;
    let curve = |method: Method, name: &str, amount: &dyn Fn(u32) -> usize| {
        let point = |&digits: &u32| contest.point::<Float>(method, amount(digits), working(digits), setting(digits));
        Curve::new(name, Arithmetic::Mp, digits.iter().map(point).collect())
    };
    let tolerance = |digits: u32| digits as usize;
    let jacobi = curve(Method::Jacobi, Method::Jacobi.name(), &nodes);
    let with_nodes = Curve {
        contestant: "Gauss–Jacobi, nodes included".to_owned(),
        points: jacobi
            .points
            .iter()
            .zip(&digits)
            .skip(1)
            .map(|(point, &digits)| set_up(point, nodes(digits), digits, clock))
            .collect(),
        ..jacobi.clone()
    };
    Diagram {
        id: "precision-transform".to_owned(),
        task: PRECISION.name.to_owned(),
        title: format!("g(x) of f = r^(1/4) at x = {}, by quadrature", question.x),
        truth: "κ_{1/4} x^(1/4), from the hypergeometric series of positive terms over intervals; every contestant integrates heights".to_owned(),
        view: View::Digits,
        ceiling: None,
        shipped: Method::Automatic.name().to_owned(),
        omissions: vec![format!("Quadratures beyond {MOST_OF_QUADRATURE} digits were not tried.")],
        curves: vec![
            jacobi,
            with_nodes,
            curve(Method::RegularisedTanhSinh, Method::RegularisedTanhSinh.name(), &tolerance),
            curve(Method::Automatic, Method::Automatic.name(), &tolerance),
        ],
    }
}

/// The same answer, with the time of making the nodes, which are otherwise kept. Each time the precision is a bit higher,
/// so that none are.
fn set_up(point: &Point, nodes: usize, digits: u32, clock: &Clock) -> Point {
    let mut bits = working(digits).bits();
    let made = clock.time(|| {
        bits += 1;
        let end = Float::with_val(bits, -0.5);
        gauss_jacobi::rule(nodes, &end, &Float::with_val(bits, -0.75))
    });
    let time = made.zip(point.time).map(|(made, used)| super::Time {
        median: made.median + used.median,
        least: made.least + used.least,
        most: made.most + used.most,
        runs: made.runs.min(used.runs),
    });
    Point { time, ..point.clone() }
}
