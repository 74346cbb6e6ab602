//! Error against run time of the MDR transform (1.1): powers, and smooth, kinked and wavy profiles.
//!
//! Nodes and weights, which serve every profile, are prepared before the clock starts; everything else is in the time.

mod method;
mod outside;
mod subject;
#[cfg(test)]
mod tests;

use std::sync::atomic::{AtomicU64, Ordering};

use mdr_core::contact::{Profile, Result};
use mdr_core::number::{Interval, Precision};
use rug::Float;

pub(super) use self::method::Method;
use self::subject::Counted;
pub(super) use self::subject::Question;
use super::{Arithmetic, Clock, Curve, Diagram, Effort, Outcome, Point, Setup, Task, View, ceiling};
use crate::arithmetic::Arithmetic as Number;

/// The task.
pub(super) const TRANSFORM: Task = Task {
    name: "transform",
    claim: "the transform g(x) of (1.1) from heights: quadratures of the raw and of the regularised form",
    diagrams,
};

/// Bits of the contestants in arbitrary precision: a hundred digits and more.
const BITS: u32 = 400;

/// Bits of the enclosures of the truth.
const TRUTH: u32 = 512;

fn diagrams(setup: &mut Setup) -> Vec<Diagram> {
    subject::questions().iter().map(|question| diagram(question, setup)).collect()
}

fn diagram(question: &Question, setup: &mut Setup) -> Diagram {
    let Setup { effort, clock, ref mut outsiders, .. } = *setup;
    let truth = question.truth(Precision::new(TRUTH));
    let kinked = question.heights::<f64>(()).is_ok_and(|heights| !heights.kinks().is_empty());
    let contest = Contest { question, truth: truth.as_ref().ok(), effort, clock: &clock };
    let in_double = Method::ALL.into_iter().filter(|method| kinked || *method != Method::LegendrePieces);
    let in_mp = [Method::Jacobi, Method::RegularisedTanhSinh, Method::Automatic];
    let mut curves: Vec<Curve> = in_double
        .map(|method| contest.curve::<f64>(method, Arithmetic::Double, ()))
        .chain(in_mp.map(|method| contest.curve::<Float>(method, Arithmetic::Mp, Precision::new(BITS))))
        .collect();
    let (others, omissions) = truth
        .as_ref()
        .map(|truth| outsiders.curves(outside::outsiders(question, effort), std::slice::from_ref(truth)))
        .unwrap_or_default();
    curves.extend(others);
    Diagram {
        id: format!("transform-{}", question.id),
        task: TRANSFORM.name.to_owned(),
        title: question.title.clone(),
        truth: question.source().to_owned(),
        view: View::Error,
        ceiling: question.condition().ok().map(ceiling),
        shipped: Method::Automatic.name().to_owned(),
        curves,
        omissions,
    }
}

/// One question, and how it is put.
pub(super) struct Contest<'a> {
    /// What is asked.
    pub(super) question: &'a Question,
    /// An enclosure of the answer.
    pub(super) truth: Option<&'a Interval>,
    /// How far the ladders go.
    pub(super) effort: Effort,
    /// Who takes the time.
    pub(super) clock: &'a Clock,
}

impl Contest<'_> {
    /// One attempt; what goes wrong in its preparation is its outcome, too.
    pub(super) fn point<R: Number>(&self, method: Method, amount: usize, ctx: R::Ctx, setting: String) -> Point {
        self.attempt::<R>(method, amount, ctx, setting.clone()).unwrap_or_else(|error| Point {
            setting,
            outcome: Outcome::Failed(error.to_string()),
            evaluations: None,
            time: None,
        })
    }

    fn curve<R: Number>(&self, method: Method, arithmetic: Arithmetic, ctx: R::Ctx) -> Curve {
        let mut points: Vec<Point> = Vec::new();
        for &amount in amounts(method, arithmetic, self.effort) {
            let point = self.point::<R>(method, amount, ctx, method.effort(amount).to_string());
            // A looser tolerance may have been met by the same evaluations.
            if points.last().is_none_or(|last| last.evaluations.is_none() || last.evaluations != point.evaluations) {
                points.push(point);
            }
        }
        Curve::new(method.name(), arithmetic, points)
    }

    fn attempt<R: Number>(&self, method: Method, amount: usize, ctx: R::Ctx, setting: String) -> Result<Point> {
        let x = R::from_f64(ctx, self.question.x);
        let heights = self.question.heights::<R>(ctx)?;
        let count = AtomicU64::new(0);
        let counted = method.prepare(amount, Counted { heights: &heights, count: Some(&count) }, &x)?;
        count.store(0, Ordering::Relaxed);
        let outcome = match (counted(), self.truth) {
            (Ok(answer), Some(truth)) => Outcome::of(&answer.widen(), truth),
            (Ok(_), None) => Outcome::Failed("the truth is not known".to_owned()),
            (Err(error), _) => Outcome::Failed(error.to_string()),
        };
        let bare = method.prepare(amount, Counted { heights: &heights, count: None }, &x)?;
        Ok(Point { setting, outcome, evaluations: Some(count.load(Ordering::Relaxed)), time: self.clock.time(bare) })
    }
}

/// The ladder of a method, see [`Method::effort`].
fn amounts(method: Method, arithmetic: Arithmetic, effort: Effort) -> &'static [usize] {
    use Method::*;
    let full = effort == Effort::Full;
    match (arithmetic, method) {
        (Arithmetic::Double, Midpoint) if full => &[16, 64, 256, 1024, 4096, 16_384, 65_536, 262_144, 1_048_576],
        (Arithmetic::Double, Midpoint) => &[16, 256, 4096],
        (Arithmetic::Double, Chebyshev | Legendre | LegendrePieces | Regularised) if full => {
            &[2, 4, 8, 16, 32, 64, 128, 256, 512, 1024]
        }
        (Arithmetic::Double, Chebyshev | Legendre | LegendrePieces | Regularised) => &[4, 16, 64, 256],
        (Arithmetic::Double, Jacobi) if full => &[2, 4, 6, 8, 10, 12, 16, 24, 32, 48, 64, 96],
        (Arithmetic::Double, Jacobi) => &[4, 12, 64],
        (Arithmetic::Double, TanhSinh) if full => &[0, 1, 2, 3, 4, 5, 6],
        (Arithmetic::Double, TanhSinh) => &[1, 3, 5],
        (Arithmetic::Double, _) => &[2, 4, 6, 8, 10, 12, 14, 16],
        (_, Jacobi) if full => &[8, 16, 24, 32, 48, 64, 80, 96, 128, 192],
        (_, Jacobi) => &[16],
        (_, _) if full => &[20, 40, 60, 80, 100, 120],
        (_, _) => &[30],
    }
}
