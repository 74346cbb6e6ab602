//! |d ln value/d ln input| from dual numbers over enclosures.

use mdr_core::contact::Result;
use mdr_core::number::{Decimal, Dual, Interval, Literal, Precision, Real};
use mdr_numeric::curve::Curve;

use crate::contact::Contact;
use crate::float;

/// Conditions by the names of the inputs.
pub(crate) type Conditions = Vec<(String, f64)>;

/// A number with its derivative with respect to the logarithm of one input.
pub(crate) type Seeded = Dual<Interval>;

/// Bits in which derivatives are computed. Radii are known to fewer; what that costs is far below three digits.
const BITS: u32 = 256;

/// The largest of all, at least 1: digits that the question may cost.
pub(crate) fn largest(conditions: &[Conditions]) -> f64 {
    conditions.iter().flatten().map(|(_, x)| x).fold(1.0, |a: f64, b| a.max(*b))
}

/// The numbers of a contact in their order, that of number `index` with its derivative.
pub(crate) fn seeded<R: Real>(ctx: R::Ctx, index: usize) -> impl FnMut(&Literal) -> Dual<R> {
    let mut next = 0;
    move |literal| {
        next += 1;
        seed(ctx, literal, next == index + 1)
    }
}

/// A number; where it is an input that changes, with the derivative with respect to its own logarithm.
fn seed<R: Real>(ctx: R::Ctx, literal: &Literal, changes: bool) -> Dual<R> {
    let value = R::from_literal(ctx, literal);
    let slope = if changes { value.clone() } else { value.lit(0) };
    Dual { value, slope }
}

/// The conditions of quantities that are computed with one input seeded, by its number.
pub(crate) fn by_input<R: Real, const K: usize>(
    names: &[&str],
    quantities: impl Fn(usize) -> Result<[Dual<R>; K]>,
) -> Result<[Conditions; K]> {
    let mut conditions: [Conditions; K] = std::array::from_fn(|_| Vec::new());
    for (index, name) in names.iter().enumerate() {
        for (list, quantity) in conditions.iter_mut().zip(quantities(index)?) {
            list.push(((*name).to_owned(), (quantity.slope / quantity.value).approx().abs()));
        }
    }
    Ok(conditions)
}

/// The conditions of quantities on the curve of equilibria of the closed form, with respect to the inputs of these names, the
/// first of the contact, and to a number that is given with them.
pub(crate) fn on_curve<const K: usize>(
    contact: &Contact,
    inputs: &[&str],
    given: Option<(&str, &Literal)>,
    quantities: impl Fn(&Curve<'_, Seeded>, &Seeded) -> Result<[Seeded; K]>,
) -> Result<[Conditions; K]> {
    let ctx = Precision::new(BITS);
    let names: Vec<&str> = inputs.iter().copied().chain(given.map(|(name, _)| name)).collect();
    by_input(&names, |index| {
        let is_given = index == inputs.len();
        let number = match given {
            Some((_, literal)) => seed(ctx, literal, is_given),
            None => Seeded::from_int(ctx, 0),
        };
        let index = if is_given { usize::MAX - 1 } else { index };
        contact.model(seeded(ctx, index))?.closed(|curve| quantities(curve, &number))
    })
}

/// A certified number as a constant.
pub(crate) fn constant(decimal: &Decimal) -> Seeded {
    Dual::constant(Interval::point(float(Precision::new(BITS), decimal)))
}

/// The radius at which a residual stays zero while an input changes, by the implicit function theorem. Both derivatives are with
/// respect to logarithms, so that their difference keeps its digits at any scale.
pub(crate) fn implicit(a: &Seeded, residual: impl Fn(&Seeded) -> Result<Seeded>) -> Result<Seeded> {
    let along = residual(a)?.slope;
    let total = residual(&Dual { value: a.value.clone(), slope: a.value.clone() })?.slope;
    let across = total - &along;
    Ok(Dual { value: a.value.clone(), slope: -along / across * &a.value })
}

/// What is controlled at a contact radius.
pub(crate) fn controlled(curve: &Curve<'_, Seeded>, a: &Seeded) -> Result<Seeded> {
    let (d, f) = curve.state(a)?;
    Ok(curve.control().controlled(&d, &f))
}
