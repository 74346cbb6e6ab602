//! The library of transformed profiles: g, g' and G at points by closed forms over intervals, confirmed by quadrature.

use mdr_analytic::struve::Struve;
use mdr_core::contact::{Quantity, Result, Transform};
use mdr_core::number::certify::{Decimal, Enclosure, certify};
use mdr_core::number::{Dual, Interval, Lift, Precision, Real};
use mdr_numeric::transform::Quadrature;
use mdr_reference::Record;
use rug::Float;

use super::RecordError;
use super::condition::{Named, input, largest, push};
use super::confirm;
use super::draft::{DIGITS, Draft, literal};
use crate::library::{Height, Shape, closed_form};

/// Bits for conditions.
const BITS: u32 = 192;

/// A profile of the library with exact parameters.
#[derive(Clone, Debug)]
pub(super) struct Profile<'a> {
    pub(super) shape: Shape,
    pub(super) parameters: &'a [(&'static str, &'a str)],
}

/// The quantities of a transform at a point.
const QUANTITIES: [(&str, &str); 3] = [("g", "m"), ("slope", "1"), ("integral", "m^2")];

impl Profile<'_> {
    /// The parameters in an arithmetic.
    pub(super) fn numbers<R: Real>(&self, ctx: R::Ctx) -> Vec<R> {
        self.parameters.iter().map(|(_, text)| R::from_literal(ctx, &literal(text))).collect()
    }

    /// The parameters with a derivative with respect to the logarithm of one of them.
    pub(super) fn moving(&self, ctx: Precision, moving: usize) -> Vec<Dual<Interval>> {
        let texts = self.parameters.iter().enumerate();
        texts.map(|(index, (_, text))| input(ctx, &literal(text), index == moving)).collect()
    }

    /// The closed form.
    pub(super) fn closed<R: Struve + Lift<R>>(&self, parameters: &[R]) -> Result<Box<dyn Transform<R>>> {
        closed_form(self.shape, parameters)
    }

    /// g, g' and G at x.
    pub(super) fn at(&self, x: &str) -> std::result::Result<Vec<Record>, RecordError> {
        let name = format!("{}/x={x}", self.shape.name());
        let wrong = |error| RecordError::of(&name, error);
        let values = self.certified(x, DIGITS).map_err(wrong)?;
        let conditions = self.conditions(x).map_err(wrong)?;
        let check = || {
            let ctx = confirm::precision(largest(&conditions));
            let x = Float::from_literal(ctx, &literal(x));
            let transform = Quadrature::new(Height { shape: self.shape, parameters: self.numbers::<Float>(ctx) });
            let found = [transform.g(&x)?, transform.slope(&x)?, transform.integral(&x)?];
            let agree = |(found, value): (&Float, _)| {
                let value = confirm::float(ctx, value);
                confirm::agree(found, &value, &value.clone().abs())
            };
            Ok(found.iter().zip(&values).all(agree))
        };
        RecordError::unless(&name, "the transform", check())?;
        let inputs = self.parameters.iter().map(|(name, value)| (*name, (*value).to_owned()));
        let draft = Draft {
            id: format!("transform/{name}"),
            profile: self.shape.name(),
            formula: "transform",
            inputs: inputs.chain([("x", x.to_owned())]).collect(),
            methods: ["closed-form/interval", "quadrature/mp"],
            proof: vec!["1.1"],
            refs: vec!["Popov (1.1)", "Popov, Hess & Willert 2019"],
            ..Draft::default()
        };
        Ok(draft.records(QUANTITIES, values, conditions).collect())
    }

    /// g, g' and G at x, to so many digits.
    pub(super) fn certified(&self, x: &str, digits: u32) -> Result<[Decimal; 3]> {
        certify([Quantity::TransformedProfile; 3], digits, Precision::new(BITS), |precision| {
            let x = Interval::from_literal(precision, &literal(x));
            let transform = self.closed(&self.numbers::<Interval>(precision))?;
            Ok([transform.g(&x)?, transform.slope(&x)?, transform.integral(&x)?].map(Enclosure::from))
        })
    }

    /// With respect to every parameter and x.
    fn conditions(&self, x: &str) -> Result<[Named; 3]> {
        let ctx = Precision::new(BITS);
        let mut conditions: [Named; 3] = Default::default();
        let names = self.parameters.iter().map(|(name, _)| *name).chain(["x"]);
        for (index, name) in names.enumerate() {
            let transform = self.closed(&self.moving(ctx, index))?;
            let x = input(ctx, &literal(x), index == self.parameters.len());
            let found = [transform.g(&x)?, transform.slope(&x)?, transform.integral(&x)?];
            push(&mut conditions, name, found);
        }
        Ok(conditions)
    }
}
