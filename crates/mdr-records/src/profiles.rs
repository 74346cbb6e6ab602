//! Transforms at a radius, states with a contact radius, and the pull-off of flat punches.

use std::sync::Arc;

use mdr::answer::{Admission, CurvePoint, TransformSample};
use mdr::prelude::{Literal, Want};
use mdr_analytic::flat_punch_pull_off;
use mdr_core::contact::{self, Control, Error, Material, Quantity, Shape};
use mdr_core::number::{Decimal, Dual, Real};
use mdr_numeric::admissible::{Admissibility, GapVerdict};
use mdr_numeric::contact::Contact;
use mdr_numeric::transform::Quadrature;
use mdr_reference::Record;
use rug::Float;

use crate::builder::{RecordBuilder, STATE};
use crate::cases::Case;
use crate::contact::CaseContact;
use crate::sensitivity::{Conditions, on_curve};
use crate::{Failure, Result, confirm, decimals, float};

/// g at a radius as the scene answers it.
pub(crate) fn sample(contact: &CaseContact, x: &Literal) -> Result<TransformSample> {
    let answer = contact.answer([Want::Transform { at: vec![x.clone()] }])?;
    answer.transform().and_then(|list| list.items.first()).cloned().ok_or(Failure::Missing("transform"))
}

/// g, g' and ∫g with their conditions.
fn certified(contact: &CaseContact, x: &Literal) -> Result<([Decimal; 3], [Conditions; 3])> {
    let sample = sample(contact, x)?;
    let values = decimals([&sample.g, &sample.slope, &sample.integral])?;
    let conditions = on_curve(contact, Some(("x", x)), |curve, x| {
        let transform = curve.transform();
        Ok([transform.g(x)?, transform.slope(x)?, transform.integral(x)?])
    })?;
    let ctx = confirm::precision(&conditions);
    let found = contact.float(ctx)?.integrated(|curve| {
        let (transform, x) = (curve.transform(), Float::from_literal(ctx, x));
        Ok([transform.g(&x)?, transform.slope(&x)?, transform.integral(&x)?])
    })?;
    let agrees = found.iter().zip(&values).all(|(found, value)| {
        let value = float(ctx, value);
        confirm::agree(found, &value, &value.clone().abs())
    });
    Failure::unless("the transform", agrees)?;
    Ok((values, conditions))
}

/// g, g' and ∫g at a radius.
pub(crate) fn transform(case: &Case) -> Result<Vec<Record>> {
    const QUANTITIES: [(&str, &str); 3] = [("g", "m"), ("slope", "1"), ("integral", "m^2")];
    let (parameters, x) = (case.contact.parameters(), case.value()?);
    let (values, conditions) = certified(&case.contact, &x)?;
    let builder = RecordBuilder::new(case, parameters).part(format_args!("x={x}")).input("x", x);
    let answers = QUANTITIES.into_iter().zip(&values).zip(conditions);
    Ok(answers.map(|((quantity, value), condition)| builder.number(quantity, value, condition, None)).collect())
}

/// κ_n = g(1) of f = rⁿ.
pub(crate) fn kappa(case: &Case) -> Result<Vec<Record>> {
    let [Shape::Power { n, .. }] = case.contact.terms.as_slice() else { return Err(Failure::Missing("exponent")) };
    let one = Literal::from(1);
    let contact = CaseContact { terms: vec![Shape::Power { n: n.clone(), c: one.clone() }], ..case.contact.clone() };
    let ([kappa, ..], [conditions, ..]) = certified(&contact, &one)?;
    let builder = RecordBuilder::new(case, vec![("n", n)]);
    Ok(vec![builder.number(("kappa", "1"), &kappa, conditions, None)])
}

/// d and F of the equilibrium with a contact radius.
pub(crate) fn state(case: &Case) -> Result<Vec<Record>> {
    let (contact, a) = (&case.contact, case.value()?);
    let point = point(contact, &a)?;
    if point.admissible != Some(Admission::Admissible) || !is_open(contact, &a)? {
        return Err(Failure::Missing("admissible state"));
    }
    let values = decimals([&point.indentation, &point.force])?;
    let conditions = on_curve(contact, Some(("a", &a)), |curve, a| curve.state(a).map(<[_; 2]>::from))?;
    let ctx = confirm::precision(&[]);
    let agrees = contact.float(ctx)?.integrated(|curve| {
        let [d, f] = values.each_ref().map(|value| float(ctx, value));
        confirm::on_curve(curve, [&Float::from_literal(ctx, &a), &d, &f])
    })?;
    Failure::unless("the state", agrees)?;
    let builder = RecordBuilder::new(case, contact.inputs()).part(format_args!("a={a}")).input("a", a);
    Ok(loads(&builder, &values, conditions))
}

/// The state with a contact radius as the scene answers it.
pub(crate) fn point(contact: &CaseContact, a: &Literal) -> Result<CurvePoint> {
    let answer = contact.answer([Want::Curve { at: vec![a.clone()] }])?;
    answer.curve().and_then(|list| list.items.first()).cloned().ok_or(Failure::Missing("state"))
}

/// Whether the surfaces are apart outside of the contact, by quadrature in f64: out to twice the radius, or the end of
/// the range. All profiles of which this is asked are convex beyond it.
fn is_open(contact: &CaseContact, a: &Literal) -> contact::Result<bool> {
    let model = contact.model(Literal::nearest_f64)?;
    let transform = Arc::new(Quadrature::of(model.terms)?);
    let curve = Contact::half_space(&transform, &model.material, &Control::Indentation);
    let a = a.nearest_f64();
    let end = contact.range.as_ref().map_or(f64::INFINITY, |[_, end]| end.nearest_f64());
    let admissibility = Admissibility::new(transform.clone(), [1e-6 * a, end.min(2.0 * a)]);
    Ok(!matches!(admissibility.of(a, curve.indentation(&a)?), GapVerdict::Interpenetrating { .. }))
}

/// The records of d and F.
fn loads(builder: &RecordBuilder<'_>, values: &[Decimal; 2], conditions: [Conditions; 2]) -> Vec<Record> {
    let answers = STATE[1..].iter().zip(values).zip(conditions);
    answers.map(|((quantity, value), condition)| builder.number(*quantity, value, condition, None)).collect()
}

/// d and F at which a flat punch comes off, the fold at its edge; confirmed by the energy balance of Griffith: E*d² =
/// 2πbw and F = 2E*bd.
pub(crate) fn pull_off(case: &Case) -> Result<Vec<Record>> {
    let contact = &case.contact;
    let answer = contact.answer([contact.all_folds()])?;
    let fold = answer.folds().and_then(|folds| folds.items.first()).ok_or(Failure::Missing("fold"))?;
    let values = decimals([&fold.indentation, &fold.force])?;
    let conditions = on_curve(contact, None, |curve, _| {
        let material = Material::new(curve.modulus().clone(), curve.adhesion().work().clone())?;
        let state = flat_punch_pull_off(&edge(curve)?, &material)?;
        Ok([state.indentation, state.force])
    })?;
    Failure::unless("pull-off", is_balanced(contact, &values)?)?;
    Ok(loads(&RecordBuilder::new(case, contact.inputs()), &values, conditions))
}

/// The radius of the vertical edge.
fn edge<R: Real>(curve: &Contact<R>) -> contact::Result<R> {
    let (quantity, requirement) = (Quantity::Parameter("the profile"), "one with a vertical edge");
    curve.vertical_edge().ok_or(Error::Domain { quantity, value: String::new(), requirement })
}

/// The energy E*bd² of the punch held at d, given to its edge: its derivative with respect to b is 2πbw, that with
/// respect to d is F.
fn is_balanced(contact: &CaseContact, values: &[Decimal; 2]) -> contact::Result<bool> {
    let ctx = confirm::precision(&[]);
    let [d, f] = values.each_ref().map(|value| float(ctx, value));
    contact.float(ctx)?.integrated(|curve| {
        let (b, e_star) = (edge(curve)?, curve.modulus());
        let energy = |b: Dual<Float>, d: Dual<Float>| (Dual::constant(e_star.clone()) * b * d.square()).slope;
        let released = energy(Dual::variable(b.clone()), Dual::constant(d.clone()));
        let pull = energy(Dual::constant(b.clone()), Dual::variable(d.clone()));
        let spent = (b.pi() * &b * curve.adhesion().work()).times(2);
        Ok(d < d.lit(0) && confirm::agree(&released, &spent, &spent) && confirm::agree(&pull, &f, &f.clone().abs()))
    })
}
