//! |d ln value/d ln input| from dual numbers over enclosures.

use mdr_core::contact::Result;
use mdr_core::number::{Decimal, Dual, Interval, Literal, Precision, Real};
use mdr_numeric::contact::Contact;

use crate::contact::{CaseContact, Model};
use crate::float;

/// Conditions by the names of the inputs.
pub(crate) type Conditions = Vec<(&'static str, f64)>;

/// A number with its derivative with respect to the logarithm of one input.
pub(crate) type Seeded = Dual<Interval>;

/// Bits in which derivatives are computed. Radii are known to fewer; what that costs is far below three digits.
const BITS: u32 = 256;

/// The largest of all, at least 1: digits that the question may cost.
pub(crate) fn largest(conditions: &[Conditions]) -> f64 {
    conditions.iter().flatten().map(|(_, x)| x).fold(1.0, |a: f64, b| a.max(*b))
}

/// The conditions of the results of `quantities` for a contact, with respect to its inputs and to a number that is given
/// with it.
pub(crate) fn conditions<R: Real<Ctx = Precision>, const K: usize>(
    contact: &CaseContact,
    given: Option<(&'static str, &Literal)>,
    quantities: impl Fn(Model<Dual<R>>, Dual<R>) -> Result<[Dual<R>; K]>,
) -> Result<[Conditions; K]> {
    let ctx = Precision::new(BITS);
    let mut conditions: [Conditions; K] = std::array::from_fn(|_| Vec::new());
    for (index, (name, _)) in contact.inputs().into_iter().chain(given).enumerate() {
        let mut next = 0;
        let mut seeded = |literal: &Literal| {
            let value = R::from_literal(ctx, literal);
            let slope = if next == index { value.clone() } else { value.lit(0) };
            next += 1;
            Dual { value, slope }
        };
        let model = contact.model(&mut seeded)?;
        let given = given.map_or_else(|| Dual::from_int(ctx, 0), |(_, literal)| seeded(literal));
        for (list, quantity) in conditions.iter_mut().zip(quantities(model, given)?) {
            list.push((name, (quantity.slope / quantity.value).approx().abs()));
        }
    }
    Ok(conditions)
}

/// The conditions of the results of `quantities` on the curve of equilibria of the closed form.
pub(crate) fn on_curve<const K: usize>(
    contact: &CaseContact,
    given: Option<(&'static str, &Literal)>,
    quantities: impl Fn(&Contact<Seeded>, &Seeded) -> Result<[Seeded; K]>,
) -> Result<[Conditions; K]> {
    conditions(contact, given, |model, given| model.closed(|curve| quantities(curve, &given)))
}

/// A certified number as a constant.
pub(crate) fn constant(decimal: &Decimal) -> Seeded {
    Dual::constant(Interval::point(float(Precision::new(BITS), decimal)))
}

/// The controlled quantity at a contact radius.
pub(crate) fn controlled(curve: &Contact<Seeded>, a: &Seeded) -> Result<Seeded> {
    let (d, f) = curve.state(a)?;
    Ok(curve.control().controlled(&d, &f))
}
