//! Folds of the controlled quantity: critical states of power laws, and all folds of other profiles and on machines.

use mdr_core::contact::Result;
use mdr_core::number::{Decimal, Dual};
use mdr_reference::{Record, Status};
use rug::Float;

use crate::builder::{RecordBuilder, STATE};
use crate::cases::{Case, Kind};
use crate::contact::Contact;
use crate::sensitivity::{Conditions, constant, implicit, on_curve};
use crate::{Failure, confirm, decimal, float};

/// a, d and F at each fold.
pub(crate) fn records(case: &Case) -> std::result::Result<Vec<Record>, Failure> {
    let contact = &case.contact;
    let answer = contact.folds()?;
    let folds = answer.folds().ok_or(Failure::Missing("fold"))?;
    let is_complete = folds.complete.as_ref().is_some_and(|complete| complete.proved);
    let mut records = Vec::new();
    for (number, fold) in (1i64..).zip(&folds.items) {
        let [a, d, f] = [&fold.contact_radius, &fold.indentation, &fold.force].map(decimal);
        let values = [a?, d?, f?];
        let conditions = conditions(contact, &values)?;
        confirm::fold(contact, &values, &conditions)?;
        let builder = RecordBuilder::new(case, contact.inputs());
        if case.kind == Kind::DoubleRoot {
            // The two equilibria are one: the critical state, as the answer to a question about equilibria.
            let builder =
                builder.part(&case.label).part("outer").input("tau", case.value()?).flag("outer").flag("near-fold");
            let state = builder.fold_distance(0.0).state(values, conditions);
            records.extend(state.into_iter().map(|record| Record { status: Status::Fold, ..record }));
            continue;
        }
        let mut builder = builder;
        if case.kind != Kind::Critical {
            builder = builder.part(format_args!("fold-{number}")).input("fold", number);
        }
        if case.kind == Kind::Folds {
            builder = builder.flag(fold.kind.name());
            builder = if is_complete { builder.flag("all-folds-proved") } else { builder };
        }
        let scale = elongation(contact, &values[0])?;
        let answers = STATE.into_iter().zip(&values).zip(conditions);
        records.extend(
            answers.map(|((quantity, value), condition)| builder.number(quantity, value, condition, Some(&scale))),
        );
    }
    Ok(records)
}

/// Δl(a), to which d = 0 is compared.
fn elongation(contact: &Contact, a: &Decimal) -> Result<Float> {
    let ctx = confirm::precision(&[]);
    contact.float(ctx)?.closed(|curve| curve.detachment_elongation(&float(ctx, a)))
}

/// By the implicit function theorem for the condition of tangency; that of d = 0 relative to Δl(a).
fn conditions(contact: &Contact, [a, d, _]: &[Decimal; 3]) -> Result<[Conditions; 3]> {
    let names: Vec<_> = contact.inputs().into_iter().map(|(name, _)| name).collect();
    let is_zero = d.is_zero();
    on_curve(contact, &names, None, |curve, _| {
        let a = implicit(&constant(a), |a| Ok(curve.tangency(a)? - curve.threshold(a)?))?;
        let (d, f) = curve.state(&a)?;
        let d = if is_zero { Dual { value: curve.detachment_elongation(&a)?.value, ..d } } else { d };
        Ok([a, d, f])
    })
}
