//! n = 1/2: the C at which every radius is in equilibrium.

use mdr::prelude::Shape;
use mdr_analytic::threshold;
use mdr_core::contact;
use mdr_core::number::{Decimal, Dual};
use mdr_reference::Record;
use rug::Float;

use crate::builder::RecordBuilder;
use crate::cases::Case;
use crate::contact::{CaseContact, Model};
use crate::sensitivity::{Conditions, conditions};
use crate::{Failure, Result, confirm, decimals, float};

/// The threshold of C, and the ratio of C to it.
pub(crate) fn records(case: &Case) -> Result<Vec<Record>> {
    let contact = &case.contact;
    let known = contact.critical()?.threshold.ok_or(Failure::Missing("threshold"))?;
    let [value, ratio] = decimals([&known.c, &known.ratio])?;
    Failure::unless("the threshold", is_tangent(contact, &value)?)?;
    let [of_threshold, of_ratio] = slopes(contact)?;
    // The threshold is one of C, and does not depend on it.
    let builder = |without: &[&str]| {
        let inputs = contact.inputs().into_iter().filter(|(name, _)| !without.contains(name));
        RecordBuilder::new(case, inputs.collect())
    };
    Ok(vec![
        builder(&["n", "C"]).number(("threshold_c", "m^(1/2)"), &value, of_threshold, None),
        builder(&["n"]).number(("ratio", "1"), &ratio, of_ratio, None),
    ])
}

/// In arbitrary precision: the enclosed mean of the lemniscate constant has no enclosed slope.
fn slopes(contact: &CaseContact) -> contact::Result<[Conditions; 2]> {
    conditions(contact, None, |model: Model<Dual<Float>>, _| {
        let control = model.control.clone();
        let law = model.law()?;
        let value = threshold(law.material(), &control)?;
        let ratio = law.profile().coefficient().clone() / &value;
        Ok([value, ratio])
    })
}

/// Whether with this C the curves touch: at any radius, here at 1.
fn is_tangent(contact: &CaseContact, value: &Decimal) -> contact::Result<bool> {
    let ctx = confirm::precision(&[]);
    confirm::changes_sign(&float(ctx, value), |c| {
        let Model { material, control, .. } = contact.float(ctx)?;
        let one = Float::with_val(ctx.bits(), 1);
        let terms = vec![Shape::Power { n: one.clone() / 2u32, c: c.clone() }];
        Model { terms, material, control }.integrated(|curve| Ok(curve.tangency(&one)? - curve.critical_ratio(&one)?))
    })
}
