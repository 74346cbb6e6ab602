//! The outputs that are read off the curve of equilibria, once for every arithmetic.

use std::cmp::Ordering;

use mdr_core::contact::{Equilibrium, Error, Instability, Quantity, Result, Stability, Status};
use mdr_core::number::{Literal, Real};
use mdr_numeric::admissible::Admissibility;

use super::contact::{Arithmetic, Contact};
use super::record::{Field, Record};

/// g, g' and ∫₀ˣ g at the radii x.
///
/// # Errors
/// Those of the transform that are not about one number.
pub(crate) fn transform<R: Arithmetic>(contact: &Contact<R>, radii: &[Literal]) -> Result<Vec<Record<R>>> {
    let transform = contact.transform();
    let at = |literal: &Literal| {
        let x = contact.number(literal);
        Record::new()
            .with("x", Field::Given(literal.clone()))
            .number("g", transform.g(&x))?
            .number("slope", transform.slope(&x))?
            .number("integral", transform.integral(&x))
    };
    radii.iter().map(at).collect()
}

/// The equilibria with the given contact radii.
///
/// # Errors
/// As [`transform`].
pub(crate) fn curve<R: Arithmetic>(
    contact: &Contact<R>,
    radii: &[Literal],
    admissibility: &Admissibility<'_>,
) -> Result<Vec<Record<R>>> {
    let curve = contact.curve();
    let at = |literal: &Literal| {
        let a = contact.number(literal);
        let (indentation, force) = match curve.state(&a) {
            Ok((indentation, force)) => (Ok(indentation), Ok(force)),
            Err(error) => (curve.indentation(&a), Err(error)),
        };
        let stability = curve.tangency(&a).and_then(|ratio| Ok(ratio.partial_cmp(&curve.threshold(&a)?)));
        let fold = matches!(stability, Ok(Some(Ordering::Equal)));
        let stable = match stability {
            Ok(Some(order)) => Field::Flag(order.is_gt()),
            Ok(None) => return Err(undecided(&a)),
            Err(error) => Field::from_result(Err(error))?,
        };
        let verdict = indentation.as_ref().ok().map(|d| admissibility.of(a.approx(), d.approx()));
        let record = Record::new()
            .with("contact_radius", Field::Given(literal.clone()))
            .number("indentation", indentation)?
            .number("force", force)?
            .with("stable", stable);
        let record = if fold { record.marked(Status::Fold) } else { record };
        Ok(verdict.map_or_else(|| record.clone(), |verdict| record.clone().judged(verdict)))
    };
    radii.iter().map(at).collect()
}

fn undecided<R: Arithmetic>(a: &R) -> Error {
    Error::Undecided {
        quantity: Quantity::ContactRadius,
        bits: a.precision(),
        what: "whether the equilibrium is stable",
    }
}

/// A fold.
pub(crate) fn fold<R: Real>(fold: Instability<R>, admissibility: &Admissibility<'_>) -> Record<R> {
    let verdict = admissibility.of(fold.contact_radius.approx(), fold.indentation.approx());
    fold_of(fold).judged(verdict)
}

/// The numbers of a fold.
pub(crate) fn fold_of<N>(fold: Instability<N>) -> Record<N> {
    Record::new()
        .with("contact_radius", Field::Number(fold.contact_radius))
        .with("indentation", Field::Number(fold.indentation))
        .with("force", Field::Number(fold.force))
        .with("kind", Field::Word(fold.kind.name()))
}

/// An equilibrium.
pub(crate) fn equilibrium<R: Real>(state: Equilibrium<R>, admissibility: &Admissibility<'_>) -> Record<R> {
    let verdict = admissibility.of(state.contact_radius.approx(), state.indentation.approx());
    equilibrium_of(state).judged(verdict)
}

/// The numbers of an equilibrium.
pub(crate) fn equilibrium_of<N>(state: Equilibrium<N>) -> Record<N> {
    let record = Record::new()
        .with("contact_radius", Field::Number(state.contact_radius))
        .with("indentation", Field::Number(state.indentation))
        .with("force", Field::Number(state.force))
        .with("stable", Field::Flag(state.stability == Stability::Stable));
    if state.stability == Stability::Neutral { record.marked(Status::Fold) } else { record }
}

/// What belongs to one value of the controlled quantity: a list of states under `key`.
pub(crate) fn at_value<N>(value: &Literal, key: &'static str, states: Vec<Record<N>>) -> Record<N> {
    let none = states.is_empty();
    let record = Record::new().with("value", Field::Given(value.clone())).with(key, Field::Records(states));
    if none { record.marked(Status::NoEquilibrium) } else { record }
}
