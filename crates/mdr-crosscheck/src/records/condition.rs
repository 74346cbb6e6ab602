//! Conditions of a question with respect to its inputs.

use mdr_core::number::{Dual, Literal, Real};

/// |d ln value/d ln input| by the names of the inputs.
pub(super) type Named = Vec<(String, f64)>;

/// The largest of all, at least 1: digits that the question may cost.
pub(super) fn largest(conditions: &[Named]) -> f64 {
    conditions.iter().flatten().map(|(_, x)| x).fold(1.0, |a: f64, b| a.max(*b))
}

/// An input; if it `moves`, with the derivative with respect to its own logarithm.
pub(super) fn input<R: Real>(ctx: R::Ctx, exact: &Literal, moves: bool) -> Dual<R> {
    let value = R::from_literal(ctx, exact);
    let slope = if moves { value.clone() } else { value.lit(0) };
    Dual { value, slope }
}

/// |d ln value| where the slope is that with respect to the logarithm of an input.
pub(super) fn relative<R: Real>(moved: Dual<R>) -> f64 {
    (moved.slope / moved.value).approx().abs()
}

/// Adds the conditions of several quantities with respect to one input.
pub(super) fn push<R: Real>(conditions: &mut [Named], name: &str, moved: impl IntoIterator<Item = Dual<R>>) {
    for (list, moved) in conditions.iter_mut().zip(moved) {
        list.push((name.to_owned(), relative(moved)));
    }
}
