//! Folds of the controlled quantity: critical states of power laws, and all folds of other profiles and on machines.

use mdr_core::contact;
use mdr_core::number::{Decimal, Dual};
use mdr_reference::{Record, Status};
use rug::Float;

use crate::builder::RecordBuilder;
use crate::cases::Case;
use crate::contact::CaseContact;
use crate::sensitivity::{Conditions, constant, on_curve};
use crate::{Failure, Result, confirm, decimals, float};

/// A fold that both methods have.
struct Fold {
    values: [Decimal; 3],
    conditions: [Conditions; 3],
    /// Δl(a), to which d = 0 is compared.
    elongation: Float,
    flags: Vec<&'static str>,
}

/// The critical state of a power law.
pub(crate) fn critical(case: &Case) -> Result<Vec<Record>> {
    let builder = RecordBuilder::new(case, case.contact.inputs());
    Ok(folds(&case.contact)?.into_iter().flat_map(|fold| fold.records(&builder)).collect())
}

/// The critical state as the answer to a question about equilibria, of which the two are one.
pub(crate) fn double_root(case: &Case) -> Result<Vec<Record>> {
    let builder = RecordBuilder::new(case, case.contact.inputs());
    let builder = builder.part(format_args!("tau={}", case.label)).part("outer").input("tau", case.value()?);
    let builder = builder.flag("outer").flag("near-fold").fold_distance(0.0);
    let records =
        folds(&case.contact)?.into_iter().flat_map(|fold| builder.uncontrolled(&fold.values, fold.conditions));
    Ok(records.map(|record| Record { status: Status::Fold, ..record }).collect())
}

/// All folds of a power law on a machine.
pub(crate) fn on_machine(case: &Case) -> Result<Vec<Record>> {
    let folds = (1..).zip(folds(&case.contact)?);
    Ok(folds.flat_map(|(number, fold)| fold.records(&numbered(case, number))).collect())
}

/// All folds of another profile, with their flags.
pub(crate) fn all(case: &Case) -> Result<Vec<Record>> {
    let flagged = |(number, fold): (i64, Fold)| {
        let builder = fold.flags.iter().fold(numbered(case, number), |builder, flag| builder.flag(flag));
        fold.records(&builder)
    };
    Ok((1..).zip(folds(&case.contact)?).flat_map(flagged).collect())
}

fn numbered(case: &Case, number: i64) -> RecordBuilder<'_> {
    let builder = RecordBuilder::new(case, case.contact.inputs());
    builder.part(format_args!("fold-{number}")).input("fold", number)
}

impl Fold {
    fn records(self, builder: &RecordBuilder<'_>) -> Vec<Record> {
        builder.state(&self.values, self.conditions, Some(&self.elongation))
    }
}

fn folds(contact: &CaseContact) -> Result<Vec<Fold>> {
    let answer = contact.answer([contact.all_folds()])?;
    let folds = answer.folds().ok_or(Failure::Missing("fold"))?;
    let is_complete = folds.complete.as_ref().is_some_and(|complete| complete.proved);
    let certified = |fold: &mdr::answer::Fold| {
        let values = decimals([&fold.contact_radius, &fold.indentation, &fold.force])?;
        let conditions = conditions(contact, &values)?;
        confirm::fold(contact, &values, &conditions)?;
        let ctx = confirm::precision(&[]);
        let a = float(ctx, &values[0]);
        let elongation = contact.float(ctx)?.closed(|curve| curve.detachment_elongation(&a))?;
        let complete = is_complete.then_some("all-folds-proved");
        let flags = [fold.kind.name()].into_iter().chain(complete).collect();
        Ok(Fold { values, conditions, elongation, flags })
    };
    folds.items.iter().map(certified).collect()
}

/// By the implicit function theorem for the condition of tangency; that of d = 0 relative to Δl(a).
fn conditions(contact: &CaseContact, [a, d, _]: &[Decimal; 3]) -> contact::Result<[Conditions; 3]> {
    on_curve(contact, None, |curve, _| {
        let a = curve.moved(&constant(a).value, |a| Ok(curve.tangency(a)? - curve.critical_ratio(a)?))?;
        let (depth, f) = curve.state(&a)?;
        let value = if d.is_zero() { curve.detachment_elongation(&a)?.value } else { depth.value };
        Ok([a, Dual { value, slope: depth.slope }, f])
    })
}
