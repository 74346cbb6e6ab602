//! Equilibria at a value of what is controlled.

use mdr::prelude::{EventKind, Stability, Want};
use mdr_core::contact::{Error as ContactError, Quantity, Status as Outcome};
use mdr_core::number::certify::{Enclosure, certify};
use mdr_core::number::{Decimal, Dual, Interval, Literal, Precision, Real};
use mdr_numeric::curve::Curve;
use mdr_reference::{Record, Status};
use rug::Float;

use crate::builder::RecordBuilder;
use crate::cases::{Case, Kind, Side};
use crate::contact::Contact;
use crate::sensitivity::{Conditions, Seeded, constant, controlled, implicit, on_curve};
use crate::{DIGITS, Failure, Result, confirm, decimal, float};

/// Bits in which a share of the critical value is first tried.
const BITS: u32 = 256;

/// At which value of the controlled quantity.
enum Target<'a> {
    Value(&'a Literal),
    /// The value at the fold of this radius, times 1 − τ.
    Share(&'a Literal, &'a Decimal),
    /// The value at the fold of this radius.
    Fold(&'a Decimal),
}

impl Target<'_> {
    /// The value while an input changes, of which the one that is given with the contact is `given`. At a fold it does not
    /// depend on the radius, which is a constant.
    fn value(&self, curve: &Curve<'_, Seeded>, given: &Seeded) -> mdr_core::contact::Result<Seeded> {
        match self {
            Target::Value(_) => Ok(given.clone()),
            Target::Share(_, fold) => Ok((given.lit(1) - given) * controlled(curve, &constant(fold))?),
            Target::Fold(fold) => controlled(curve, &constant(fold)),
        }
    }

    /// |d ln y/d ln x| by the implicit function theorem for the residual, what is controlled at the radius less the target.
    fn conditions(&self, contact: &Contact, a: &Decimal) -> mdr_core::contact::Result<[Conditions; 3]> {
        let names: Vec<_> = contact.inputs().into_iter().map(|(name, _)| name).collect();
        let given = match self {
            Target::Value(value) => Some((contact.symbol(), *value)),
            Target::Share(share, _) => Some(("tau", *share)),
            Target::Fold(_) => None,
        };
        on_curve(contact, &names, given, |curve, given| {
            let target = self.value(curve, given)?;
            let a = implicit(&constant(a), |a| {
                Ok(controlled(curve, a)? - &Dual { value: a.value.lit(0), ..target.clone() })
            })?;
            let (d, f) = curve.state(&a)?;
            Ok([a, d, f])
        })
    }
}

/// The contact radius of a power law on one side of the critical one, and what is not controlled.
pub(crate) fn of_power_law(case: &Case) -> Result<Vec<Record>> {
    let (contact, at) = (&case.contact, case.value()?);
    let side = case.side.ok_or(Failure::Missing("side"))?;
    let [fold, d, f] = critical(contact)?;
    let (values, target, name) = if case.kind == Kind::EquilibriumShare {
        (at_share(contact, &at, side)?, Target::Share(&at, &fold), "tau")
    } else {
        let states = states(contact, &at)?.into_iter().map(|(values, _)| values);
        let beyond = |values: &[Decimal; 3]| difference(&values[0], &fold) > 0.0;
        let mut states = states.filter(|values| beyond(values) == (side == Side::Outer));
        (states.next().ok_or(Failure::Missing("equilibrium"))?, Target::Value(&at), contact.symbol())
    };
    let conditions = target.conditions(contact, &values[0])?;
    let ctx = confirm::precision(&conditions);
    let value = match target {
        Target::Share(..) => {
            let law = contact.float(ctx)?.law()?;
            let state = law.critical(&contact.float(ctx)?.control)?;
            let critical = contact.float(ctx)?.control.controlled(&state.indentation, &state.force);
            critical * (Float::from_int(ctx, 1) - Float::from_literal(ctx, &at))
        }
        _ => Float::from_literal(ctx, &at),
    };
    confirm::equilibrium(contact, &value, &values, ctx)?;
    let share = match target {
        Target::Share(..) => at.nearest_f64(),
        _ => distance(contact, &at, [&d, &f]),
    };
    Ok(question(case, name, &at, side, share).state(values, conditions))
}

/// The certain absence of an equilibrium.
pub(crate) fn none(case: &Case) -> Result<Vec<Record>> {
    let (contact, at) = (&case.contact, case.value()?);
    let answer = contact.answer(Want::Equilibria { at: vec![at.clone()] })?;
    let list = answer.equilibria().ok_or(Failure::Missing("equilibria"))?;
    let is_complete = list.complete.as_ref().is_some_and(|complete| complete.proved);
    if !(is_complete && list.items.iter().all(|item| item.status == Outcome::NoEquilibrium)) {
        return Err(Failure::Missing("proof that there is no equilibrium"));
    }
    let [_, d, f] = critical(contact)?;
    let share = distance(contact, &at, [&d, &f]);
    let question = question(case, contact.symbol(), &at, Side::Outer, share);
    Ok(vec![question.without_number("contact_radius", "m", Status::NoEquilibrium)])
}

/// All equilibria of another profile.
pub(crate) fn all(case: &Case) -> Result<Vec<Record>> {
    let (contact, at) = (&case.contact, case.value()?);
    let mut records = Vec::new();
    for (number, (values, stability)) in (1i64..).zip(states(contact, &at)?) {
        let conditions = Target::Value(&at).conditions(contact, &values[0])?;
        let ctx = confirm::precision(&conditions);
        confirm::equilibrium(contact, &Float::from_literal(ctx, &at), &values, ctx)?;
        let builder = RecordBuilder::new(case, contact.inputs());
        let builder = builder.part(format_args!("{}={at}", contact.symbol())).part(format_args!("state-{number}"));
        let builder = builder.input(contact.symbol(), at.clone()).input("state", number);
        let flag = if stability == Stability::Stable { "stable" } else { "unstable" };
        records.extend(builder.flag(flag).state(values, conditions));
    }
    Ok(records)
}

/// The equilibrium that a contact reaches when it jumps at a fold: the first jump on a path.
pub(crate) fn landing(case: &Case) -> Result<Vec<Record>> {
    let contact = &case.contact;
    let scene = contact.scene()?.path(case.path.iter())?.start(case.start.clone()).want(Want::Path);
    let scene = contact.range.clone().map_or(scene.clone(), |range| scene.want(Want::Folds { range: Some(range) }));
    let answer = scene.solve()?;
    let (path, folds) = answer.path().zip(answer.folds()).ok_or(Failure::Missing("path"))?;
    let jump = path.events.items.iter().find(|event| event.event == EventKind::Jump).ok_or(Failure::Missing("jump"))?;
    let known = |value: &Option<_>| decimal(value.as_ref().ok_or(Failure::Missing("state"))?);
    let [from, d, f] = [&jump.contact_radius, &jump.indentation, &jump.force].map(known);
    let [a, to_d, to_f] = [&jump.to_contact_radius, &jump.to_indentation, &jump.to_force].map(known);
    let (fold, values) = ([from?, d?, f?], [a?, to_d?, to_f?]);
    let number = folds.items.iter().position(|item| decimal(&item.contact_radius).is_ok_and(|a| a == fold[0]));
    if number.map(|index| (index + 1).to_string()).as_ref() != Some(&case.at) {
        return Err(Failure::Missing("jump at this fold"));
    }
    let conditions = Target::Fold(&fold[0]).conditions(contact, &values[0])?;
    let ctx = confirm::precision(&conditions);
    let [_, d, f] = fold.each_ref().map(|value| float(ctx, value));
    let value = contact.float(ctx)?.control.controlled(&d, &f);
    confirm::equilibrium(contact, &value, &values, ctx)?;
    let builder = RecordBuilder::new(case, contact.inputs()).part(format_args!("fold-{}", case.at));
    let builder = builder.input("fold", case.value()?).flag("stable");
    Ok(builder.state(values, conditions))
}

/// Every equilibrium at a value, with its stability.
fn states(contact: &Contact, at: &Literal) -> Result<Vec<([Decimal; 3], Stability)>> {
    let scene = contact.scene()?.want(Want::Equilibria { at: vec![at.clone()] });
    let scene = contact.range.clone().map_or(scene.clone(), |range| scene.want(Want::Folds { range: Some(range) }));
    let answer = scene.solve()?;
    let list = answer.equilibria().ok_or(Failure::Missing("equilibria"))?;
    let states = list.items.iter().flat_map(|item| &item.items);
    let certified = |state: &mdr::answer::Equilibrium| {
        let [a, d, f] = [&state.contact_radius, &state.indentation, &state.force].map(decimal);
        Ok(([a?, d?, f?], state.stability))
    };
    states.map(certified).collect()
}

/// The critical state of a power law.
fn critical(contact: &Contact) -> Result<[Decimal; 3]> {
    let state = contact.critical()?.state.ok_or(Failure::Missing("critical state"))?;
    let [a, d, f] = state.values().map(decimal);
    Ok([a?, d?, f?])
}

/// The equilibrium at the critical value times 1 − τ. No decimal is that value, and no scene asks for it.
fn at_share(contact: &Contact, share: &Literal, side: Side) -> Result<[Decimal; 3]> {
    let quantities = [Quantity::ContactRadius, Quantity::Indentation, Quantity::Force];
    Ok(certify(quantities, DIGITS, Precision::new(BITS), |ctx| {
        let model = contact.model(|literal| Interval::from_literal(ctx, literal))?;
        let control = model.control.clone();
        let found = model.law()?.equilibria_at_distance(&control, &Interval::from_literal(ctx, share))?;
        let state = if side == Side::Inner { found.as_slice().first() } else { found.as_slice().last() };
        let value = share.to_string();
        let state = state.ok_or(ContactError::NoEquilibrium { quantity: control.quantity(), value })?;
        Ok([&state.contact_radius, &state.indentation, &state.force].map(|number| Enclosure::from(number.clone())))
    })?)
}

/// The relative distance of a value to the critical one.
fn distance(contact: &Contact, at: &Literal, [d, f]: [&Decimal; 2]) -> f64 {
    let ctx = Precision::new(BITS);
    let [d, f] = [d, f].map(|value| float(ctx, value));
    let critical = if contact.symbol() == "d" { d } else { f };
    (Float::from_literal(ctx, at) / critical - 1u32).abs().to_f64()
}

fn difference(one: &Decimal, other: &Decimal) -> f64 {
    let ctx = Precision::new(BITS);
    (float(ctx, one) - float(ctx, other)).to_f64()
}

/// About the equilibrium of a power law on one side of the critical radius.
fn question<'a>(case: &'a Case, name: &'static str, at: &Literal, side: Side, share: f64) -> RecordBuilder<'a> {
    let side = if side == Side::Inner { "inner" } else { "outer" };
    let builder = RecordBuilder::new(case, case.contact.inputs()).part(&case.label).part(side);
    let builder = builder.input(name, at.clone()).flag(side).fold_distance(share);
    if share <= 1e-2 { builder.flag("near-fold") } else { builder }
}
