//! Closed forms against rigorous integrals of the profiles. Both are enclosures of the same number: they meet, or one of them is wrong.

use mdr_core::contact::{Error, ExpressionError, Quantity, Result, Shape, Transform};
use mdr_core::number::{Interval, Literal, Precision, Real};
use mdr_numeric::transform::Enclosed;

use super::common::{Drawn, literal};
use crate::subject::profiles::{NAMES, closed_form};
use crate::trial::Trial;

/// g, g' and ∫g of every profile of the library, and of power laws, by their closed forms and by integrals of f that have a proved
/// remainder, from (1.1) by definition. Numbers are short decimals, which both have exactly; x stays a fifth away from the edge.
pub(super) fn profiles(trial: &mut Trial<'_>) -> Result<()> {
    let profile = Drawn::<f64>::draw(trial, ());
    let x = profile.radius(trial, trial.index.is_multiple_of(2), ())?;
    let round = trial.index / NAMES.len();
    let shapes = match trial.index % NAMES.len() {
        // A cone is a power law.
        0 if round % 2 == 1 => vec![Shape::Power { n: trial.uniform(0.1, 6.0), c: profile.steepness() }],
        _ => profile.terms::<f64>(),
    };
    let written = |value: &f64| literal(&format!("{value:.3e}"));
    let shapes = shapes.iter().map(|shape| shape.try_map(|_, value| written(value)));
    let shapes = shapes.collect::<Result<Vec<Shape<Literal>>>>()?;
    let x = written(&x)?;
    let precision = Precision::new(64 + (trial.index as u32 * 37) % 193);
    trial.describe(format_args!("{shapes:?}, x = {x}, {} bits", precision.bits()));
    let number = |literal: &Literal| Interval::from_literal(precision, literal);
    let closed = closed_form(shapes.iter().map(|shape| shape.map(|_, value| number(value))).collect())?;
    let integrals = shapes.iter().map(|shape| integrals(shape, precision)).collect::<Result<Vec<_>>>()?;
    let x = number(&x);
    let parts: [(&str, Part); 3] = [
        ("g", |transform, x| transform.g(x)),
        ("g'", |transform, x| transform.slope(x)),
        ("∫g", |transform, x| transform.integral(x)),
    ];
    for (name, part) in parts {
        let found = part(&*closed, &x)?;
        let terms = match integrals.iter().map(|term| part(term, &x)).collect::<Result<Vec<_>>>() {
            // A power that is no rational of small numbers is cut towards the axis, and beyond some 200 bits too often.
            Err(Error::Unproved { .. }) if precision.bits() > 200 && matches!(shapes[..], [Shape::Power { .. }]) => {
                continue;
            }
            terms => terms?,
        };
        let Some(sum) = terms.into_iter().reduce(|sum, term| sum + term) else { continue };
        trial.demand(format!("{name}: the enclosures meet"), found.overlaps(&sum));
        let bits = found.accuracy_bits().min(sum.accuracy_bits());
        trial.demand(format!("{name}: half of the bits are known"), bits > i64::from(precision.bits() / 2));
    }
    Ok(())
}

/// One of g, g' and ∫g of a transform.
type Part = fn(&dyn Transform<Interval>, &Interval) -> Result<Interval>;

/// The transform of a profile by integrals over its formula.
fn integrals(shape: &Shape<Literal>, precision: Precision) -> Result<Enclosed> {
    let formula = || -> std::result::Result<_, ExpressionError> {
        let (formula, values) = shape.formula()?;
        formula.enclosed(&values, &formula.breaks(&values)?, precision)
    };
    let refused = |error: ExpressionError| Error::Domain {
        quantity: Quantity::Parameter("a profile of the grid"),
        value: error.to_string(),
        requirement: "one with a formula",
    };
    formula().map_err(refused).map(|formula| Enclosed::new(formula, precision))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A closed form that is wrong in its fiftieth bit does not meet the integral, which is known to twice as many.
    #[test]
    fn a_wrong_digit_is_seen() -> Result<()> {
        let precision = Precision::new(128);
        let ball = Shape::Sphere { radius: literal("1.25")? };
        let x = Interval::from_literal(precision, &literal("0.7")?);
        let closed = closed_form(vec![ball.map(|_, radius| Interval::from_literal(precision, radius))])?;
        let integral = integrals(&ball, precision)?;
        let parts: [Part; 2] = [|transform, x| transform.g(x), |transform, x| transform.integral(x)];
        for part in parts {
            let [found, sum] = [part(&*closed, &x)?, part(&integral, &x)?];
            let wrong = found.clone() * (x.lit(1) + x.lit(2).powi(-50));
            assert!(found.overlaps(&sum) && !wrong.overlaps(&sum) && sum.accuracy_bits() > 100);
        }
        Ok(())
    }
}
