//! Functions of doubles that are shipped, with the exact results they are compared with.

use mdr_core::contact::{Ranged, Result};
use mdr_core::number::{Dual, Interval};
use rug::Float;

/// A function of doubles, or one number of its result.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Routine {
    /// The public function, and after a comma which of its numbers; the name of its ladders.
    pub(crate) name: &'static str,
    /// The names of its inputs.
    pub(crate) inputs: &'static [&'static str],
    /// The shipped function.
    pub(crate) shipped: fn(&[f64]) -> Result<Ranged<f64>>,
    /// The exact result for the same inputs.
    pub(crate) exact: Exact,
    /// The formula of textbooks, where it is worth a comparison.
    pub(crate) textbook: Option<Textbook>,
}

/// One generic expression in three arithmetics.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Exact {
    /// At any precision.
    pub(crate) float: fn(&[Float]) -> Result<Float>,
    /// In rigorous intervals.
    pub(crate) interval: fn(&[Interval]) -> Result<Interval>,
    /// With a derivative.
    pub(crate) dual: fn(&[Dual<Float>]) -> Result<Dual<Float>>,
}

/// A formula as textbooks write it, in doubles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Textbook {
    pub(crate) formula: &'static str,
    pub(crate) value: fn(&[f64]) -> f64,
}

impl Routine {
    /// The name without the number.
    pub(crate) fn function(&self) -> &'static str {
        self.name.split_once(',').map_or(self.name, |(function, _)| function)
    }
}

/// A [`Routine`] of the inputs `x`: the shipped function, `exact` the generic expression, `textbook` the formula and its value.
macro_rules! routine {
    (textbook) => { None };
    (textbook $formula:expr => $value:expr) => {
        Some($crate::subject::routine::Textbook { formula: $formula, value: $value })
    };
    (
        $name:expr, $inputs:expr, |$x:ident| $shipped:expr, exact $exact:expr
        $(, textbook $formula:expr => $textbook:expr)?
    ) => {
        $crate::subject::routine::Routine {
            name: $name,
            inputs: $inputs,
            shipped: |$x: &[f64]| $shipped,
            exact: $crate::subject::routine::Exact {
                float: |$x: &[rug::Float]| $exact,
                interval: |$x: &[mdr_core::number::Interval]| $exact,
                dual: |$x: &[mdr_core::number::Dual<rug::Float>]| $exact,
            },
            textbook: $crate::subject::routine::routine!(textbook $($formula => |$x: &[f64]| $textbook)?),
        }
    };
}
pub(crate) use routine;

/// Arrays of routines with the same inputs, and all of them together as `ROUTINES`.
macro_rules! routines {
    ($(
        $(#[$meta:meta])* $group:ident $inputs:tt {
            $($name:literal: |$x:ident| $shipped:expr, exact $exact:expr $(, textbook $formula:expr => $textbook:expr)?;)*
        }
    )*) => {
        $($(#[$meta])*
        pub(crate) const $group: [$crate::subject::routine::Routine; { [$($name),*].len() }] = [$(
            $crate::subject::routine::routine!(
                $name, &$inputs, |$x| $shipped, exact $exact $(, textbook $formula => $textbook)?
            )
        ),*];
    )*

        pub(crate) const ROUTINES: &[&[$crate::subject::routine::Routine]] = &[$(&$group),*];
    };
}
pub(crate) use routines;
