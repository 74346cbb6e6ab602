//! Questions without a number: outside of their domain, and states that would interpenetrate.

use std::sync::Arc;

use mdr::answer::Admission;
use mdr::prelude::Literal;
use mdr_analytic::detachment_elongation;
use mdr_core::contact::{self, Error, Status as Outcome};
use mdr_core::number::{Interval, Precision, Real, Special};
use mdr_numeric::contact::Contact;
use mdr_numeric::fields::Fields;
use mdr_numeric::transform::Quadrature;
use mdr_reference::{Record, Status};

use crate::builder::RecordBuilder;
use crate::cases::Case;
use crate::contact::CaseContact;
use crate::{Failure, Result, profiles};

/// A critical state that is asked for with inputs for which there is none.
pub(crate) fn domain(case: &Case) -> Result<Vec<Record>> {
    match case.contact.critical() {
        Err(Failure::Scene(mdr::Error::Contact(Error::Domain { .. }))) => {}
        Ok(answer) if answer.state.is_none() => {}
        Ok(_) => return Err(Failure::Missing("input outside of its domain")),
        Err(error) => return Err(error),
    }
    let builder = RecordBuilder::new(case, case.contact.inputs());
    Ok(vec![builder.without_number("force", "N", Status::DomainError)])
}

/// A transformed profile where it is not defined.
pub(crate) fn outside(case: &Case) -> Result<Vec<Record>> {
    let x = case.value()?;
    if profiles::sample(&case.contact, &x)?.g.status() != Outcome::DomainError {
        return Err(Failure::Missing("radius outside of the domain"));
    }
    let builder = RecordBuilder::new(case, case.contact.parameters()).part(format_args!("x={x}")).input("x", x);
    Ok(vec![builder.without_number("g", "m", Status::DomainError)])
}

/// The equilibrium of a displaced paraboloid with a contact radius inside of its ridge: the ridge would lie in the
/// half-space.
pub(crate) fn interpenetrating(case: &Case) -> Result<Vec<Record>> {
    let (contact, a) = (&case.contact, case.value()?);
    let [(_, radius), (_, offset)] = contact.parameters()[..] else { return Err(Failure::Missing("ridge")) };
    let ridge = (radius, offset);
    let overlaps = matches!(profiles::point(contact, &a)?.admissible, Some(Admission::Interpenetrating { .. }));
    if !(overlaps && enclosed_gap(contact, ridge, &a)? && integrated_gap(contact, ridge.1, &a)?) {
        return Err(Failure::Missing("interpenetration"));
    }
    let builder = RecordBuilder::new(case, contact.inputs()).part(format_args!("a={a}")).input("a", a);
    let without = |quantity, unit| builder.without_number(quantity, unit, Status::NotAdmissible);
    Ok(vec![without("indentation", "m"), without("force", "N")])
}

/// Whether the gap at the ridge is certainly negative: at r it is (2/π)∫(g(r cos φ) − d) dφ over 0 < φ < Φ =
/// arccos(a/r), which is (2/π)[r²(Φ + sin Φ cos Φ)/2R − πbr sin Φ/2R − dΦ], here at r = b.
fn enclosed_gap(contact: &CaseContact, (radius, offset): (&Literal, &Literal), a: &Literal) -> contact::Result<bool> {
    let ctx = Precision::new(128);
    let [a, b, radius] = [a, offset, radius].map(|literal| Interval::from_literal(ctx, literal));
    let model = contact.model(|literal| Interval::from_literal(ctx, literal))?;
    let elongation = detachment_elongation(&model.material, &a)?;
    let d = model.closed(|curve| Ok(curve.transform().g(&a)? - elongation))?;
    let cosine = a / &b;
    let angle = cosine.acos();
    let sine = angle.sin();
    let bowl = (angle.clone() + sine.clone() * &cosine) * b.square() / radius.clone().times(2);
    let cone = sine * b.pi() * b.square() / radius.times(2);
    let gap = bowl - cone - d * angle;
    Ok(gap < gap.lit(0))
}

/// Whether the gap at the ridge is negative in f64, by quadrature of a transform that is itself a quadrature of the heights.
fn integrated_gap(contact: &CaseContact, offset: &Literal, a: &Literal) -> contact::Result<bool> {
    let model = contact.model(Literal::nearest_f64)?;
    let transform = Arc::new(Quadrature::of(model.terms)?);
    let curve = Contact::half_space(&transform, &model.material, &model.control);
    Ok(Fields::new(curve, a.nearest_f64())?.gap(&offset.nearest_f64())? < 0.0)
}
