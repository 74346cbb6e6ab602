//! Folds and equilibria of a contact, with proof, from the closed forms and the independent route together.

mod equilibria;
mod folds;

use std::sync::Arc;

use mdr_core::contact::{Control, Fold, Material, Result, Transform};
use mdr_core::number::{Dual, Interval, Literal, Precision, Real};
use mdr_numeric::proof::{EnclosedCurve, ProvedBranches, ProvedFolds};
use rug::Float;

pub(crate) fn number<R: Real>(ctx: R::Ctx, text: &str) -> R {
    R::from_literal(ctx, &text.parse::<Literal>().expect("a number"))
}

pub(crate) fn interval(text: &str) -> Interval {
    number(Precision::new(100), text)
}

/// The controlled quantity.
#[derive(Clone, Copy)]
pub(crate) enum Held {
    Indentation,
    Force,
    Machine(&'static str),
}

impl Held {
    fn control<R: Real>(self, ctx: R::Ctx) -> Result<Control<R>> {
        match self {
            Held::Indentation => Ok(Control::Indentation),
            Held::Force => Ok(Control::Force),
            Held::Machine(stiffness) => Control::machine(number(ctx, stiffness)),
        }
    }
}

/// A contact with E* = 1: a profile in both arithmetics, w/E*, and the controlled quantity.
pub(crate) struct Contact {
    pub(crate) bits: u32,
    pub(crate) plain: Arc<dyn Transform<Interval>>,
    pub(crate) moving: Arc<dyn Transform<Dual<Interval>>>,
    pub(crate) work: &'static str,
    pub(crate) held: Held,
}

impl Contact {
    /// Answers a question about it.
    pub(crate) fn ask<T>(&self, answer: impl FnOnce(EnclosedCurve) -> Result<T>) -> Result<T> {
        let ctx = Precision::new(self.bits);
        let material = Material::new(number(ctx, "1"), number(ctx, self.work))?;
        let moving_material = Material::new(number(ctx, "1"), number(ctx, self.work))?;
        let (control, moving_control) = (self.held.control(ctx)?, self.held.control(ctx)?);
        let plain = mdr_numeric::contact::Contact::half_space(&self.plain, &material, &control);
        let moving = mdr_numeric::contact::Contact::half_space(&self.moving, &moving_material, &moving_control);
        answer(EnclosedCurve::new(plain, moving))
    }

    /// The folds in a range of radii.
    pub(crate) fn folds(&self, lower: f64, upper: f64) -> Result<ProvedFolds> {
        let [lower, upper] = [lower, upper].map(|end| Float::with_val(self.bits, end));
        self.ask(|curve| curve.folds(&lower, &upper, 10_000_000))
    }

    /// Answers a question about its branches, between folds that were found elsewhere.
    pub(crate) fn branches<T>(
        &self,
        folds: &ProvedFolds,
        answer: impl FnOnce(ProvedBranches) -> Result<T>,
    ) -> Result<T> {
        self.ask(|curve| answer(ProvedBranches::new(curve, folds)?))
    }
}

/// A contact from a profile and its decimal parameters.
macro_rules! contact {
    ($bits:expr, $profile:ident($($parameter:expr),*), $work:expr, $held:expr) => {{
        let ctx = Precision::new($bits);
        $crate::Contact {
            bits: $bits,
            plain: std::sync::Arc::new($profile::new($($crate::number::<Interval>(ctx, $parameter)),*)?),
            moving: std::sync::Arc::new($profile::new($($crate::number::<Dual<Interval>>(ctx, $parameter)),*)?),
            work: $work,
            held: $held,
        }
    }};
}
pub(crate) use contact;

/// Whether a fold is where a table of f64 numbers says.
pub(crate) fn near(fold: &Fold<Interval>, a: f64, d: f64) -> bool {
    (fold.contact_radius.approx() - a).abs() < 1e-4 && (fold.indentation.approx() - d).abs() < 1e-5
}
