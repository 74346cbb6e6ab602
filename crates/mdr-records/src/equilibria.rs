//! Equilibria at a value of the controlled quantity.

use mdr::answer::Equilibrium;
use mdr::prelude::{EventKind, Literal, Stability, Start, Value, Want};
use mdr_core::contact::{self, Error, Quantity, Status as Outcome};
use mdr_core::number::certify::{Enclosure, certify};
use mdr_core::number::{Decimal, Dual, Interval, Precision, Real};
use mdr_numeric::contact::Contact;
use mdr_reference::{Record, Status};
use rug::Float;

use crate::builder::RecordBuilder;
use crate::cases::Case;
use crate::contact::CaseContact;
use crate::sensitivity::{Conditions, Seeded, constant, controlled, on_curve};
use crate::{DIGITS, Failure, Result, confirm, decimals, float};

/// Bits in which a share of the critical value is first tried, and in which states are compared.
const BITS: u32 = 256;

/// a, d and F.
type State = [Decimal; 3];

/// At which value of the controlled quantity.
enum Target<'a> {
    Value(&'a Literal),
    /// The critical value times 1 − τ.
    Share(&'a Literal, &'a State),
    /// The value at a fold.
    Fold(&'a State),
}

impl Target<'_> {
    /// The input that says so.
    fn given(&self, contact: &CaseContact) -> Option<(&'static str, &Literal)> {
        match self {
            Target::Value(value) => Some((contact.symbol(), value)),
            Target::Share(share, _) => Some(("tau", share)),
            Target::Fold(_) => None,
        }
    }

    /// The value while an input changes. At a fold it does not depend on the radius, which is a constant.
    fn seeded(&self, curve: &Contact<Seeded>, given: &Seeded) -> contact::Result<Seeded> {
        match self {
            Target::Value(_) => Ok(given.clone()),
            Target::Share(_, fold) => Ok((given.lit(1) - given) * controlled(curve, &constant(&fold[0]))?),
            Target::Fold(fold) => controlled(curve, &constant(&fold[0])),
        }
    }

    /// The value for the second method.
    fn float(&self, contact: &CaseContact, ctx: Precision) -> contact::Result<Float> {
        let control = contact.float(ctx)?.control;
        Ok(match self {
            Target::Value(value) => Float::from_literal(ctx, value),
            Target::Share(share, _) => {
                let state = contact.float(ctx)?.law()?.critical(&control)?;
                let critical = control.controlled(&state.indentation, &state.force);
                critical * (Float::from_int(ctx, 1) - Float::from_literal(ctx, share))
            }
            Target::Fold([_, d, f]) => control.controlled(&float(ctx, d), &float(ctx, f)),
        })
    }

    /// Confirms a state there; its conditions, by the implicit function theorem for the controlled quantity less the target.
    fn confirmed(&self, contact: &CaseContact, state: &State) -> Result<[Conditions; 3]> {
        let conditions = on_curve(contact, self.given(contact), |curve, given| {
            let target = self.seeded(curve, given)?.slope;
            let residual = |a: &Seeded| {
                let Dual { value, slope } = controlled(curve, a)?;
                Ok(Dual { value, slope: slope - &target })
            };
            let a = curve.moved(&constant(&state[0]).value, residual)?;
            let (d, f) = curve.state(&a)?;
            Ok([a, d, f])
        })?;
        let ctx = confirm::precision(&conditions);
        confirm::equilibrium(contact, &self.float(contact, ctx)?, state, ctx)?;
        Ok(conditions)
    }
}

/// The equilibrium of a power law on one side of the critical radius.
pub(crate) fn at_value(case: &Case) -> Result<Vec<Record>> {
    let (contact, at) = (&case.contact, case.value()?);
    let States { fold, all } = states(contact, &at)?;
    let ctx = Precision::new(BITS);
    let is_there = |state: &State| (float(ctx, &state[0]) > float(ctx, &fold[0])) == (case.row.side == "outer");
    let state = all.into_iter().map(|(state, _)| state).find(is_there);
    let state = state.ok_or(Failure::Missing("equilibrium"))?;
    let conditions = Target::Value(&at).confirmed(contact, &state)?;
    let builder = beside_fold(case, distance(contact, &at, &fold)).part(&case.label).part(&case.row.side);
    Ok(builder.input(contact.symbol(), at).uncontrolled(&state, conditions).collect())
}

/// The equilibria of a power law at the critical value times 1 − τ. That value is no decimal, so no scene contains it.
pub(crate) fn at_share(case: &Case) -> Result<Vec<Record>> {
    let (contact, share) = (&case.contact, case.value()?);
    let quantities = [Quantity::ContactRadius, Quantity::Indentation, Quantity::Force];
    let state = certify(quantities, DIGITS, Precision::new(BITS), |ctx| {
        let model = contact.model(|literal| Interval::from_literal(ctx, literal))?;
        let control = model.control.clone();
        let found = model.law()?.equilibria_at_distance(&control, &Interval::from_literal(ctx, &share))?;
        let none = || Error::NoEquilibrium { quantity: control.quantity(), value: share.to_string() };
        let [inner, outer] = found.as_slice() else { return Err(none()) };
        let state = if case.row.side == "outer" { outer } else { inner };
        Ok([&state.contact_radius, &state.indentation, &state.force].map(|number| Enclosure::from(number.clone())))
    })?;
    let fold = states(contact, &Literal::from(0))?.fold;
    let conditions = Target::Share(&share, &fold).confirmed(contact, &state)?;
    let builder = beside_fold(case, share.nearest_f64()).part(format_args!("tau={}", case.label)).part(&case.row.side);
    Ok(builder.input("tau", share).uncontrolled(&state, conditions).collect())
}

/// The certain absence of an equilibrium.
pub(crate) fn none(case: &Case) -> Result<Vec<Record>> {
    let (contact, at) = (&case.contact, case.value()?);
    let States { fold, all } = states(contact, &at)?;
    if !all.is_empty() {
        return Err(Failure::Missing("value without an equilibrium"));
    }
    let builder = beside_fold(case, distance(contact, &at, &fold)).part(&case.label).part(&case.row.side);
    let builder = builder.input(contact.symbol(), at);
    Ok(vec![builder.without_number("contact_radius", "m", Status::NoEquilibrium)])
}

/// All equilibria of another profile.
pub(crate) fn all(case: &Case) -> Result<Vec<Record>> {
    let (contact, at) = (&case.contact, case.value()?);
    let (symbol, mut records) = (contact.symbol(), Vec::new());
    for (number, (state, stability)) in (1i64..).zip(states(contact, &at)?.all) {
        let conditions = Target::Value(&at).confirmed(contact, &state)?;
        let builder = RecordBuilder::new(case, contact.inputs());
        let builder = builder.part(format_args!("{symbol}={at}")).part(format_args!("state-{number}"));
        let builder = builder.input(symbol, at.clone()).input("state", number);
        let flag = if stability == Stability::Stable { "stable" } else { "unstable" };
        records.extend(builder.flag(flag).uncontrolled(&state, conditions));
    }
    Ok(records)
}

/// The equilibrium that a contact reaches when it jumps at a fold: the first jump on a path.
pub(crate) fn landing(case: &Case) -> Result<Vec<Record>> {
    let contact = &case.contact;
    let start = if case.row.start.as_deref() == Some("smallest") { Start::Smallest } else { Start::Largest };
    let scene = contact.scene()?.path(case.row.path.iter().map(String::as_str))?.start(start);
    let answer = scene.want(contact.all_folds()).want(Want::Path).solve()?;
    let (path, folds) = answer.path().zip(answer.folds()).ok_or(Failure::Missing("path"))?;
    let jump = path.events.items.iter().find(|event| event.event == EventKind::Jump).ok_or(Failure::Missing("jump"))?;
    let state = |values: [&Option<Value>; 3]| match values {
        [Some(a), Some(d), Some(f)] => decimals([a, d, f]),
        _ => Err(Failure::Missing("state")),
    };
    let fold = state([&jump.contact_radius, &jump.indentation, &jump.force])?;
    let state = state([&jump.to_contact_radius, &jump.to_indentation, &jump.to_force])?;
    let number = folds.items.iter().position(|item| decimals([&item.contact_radius]).is_ok_and(|[a]| a == fold[0]));
    if number.map(|index| (index + 1).to_string()).as_ref() != Some(&case.at) {
        return Err(Failure::Missing("jump at this fold"));
    }
    let conditions = Target::Fold(&fold).confirmed(contact, &state)?;
    let builder = RecordBuilder::new(case, contact.inputs()).part(format_args!("fold-{}", case.at));
    Ok(builder.input("fold", case.value()?).flag("stable").uncontrolled(&state, conditions).collect())
}

/// The states in the answer to a scene at a value of the controlled quantity.
struct States {
    /// The first fold: the critical state of a power law.
    fold: State,
    /// Every equilibrium, by increasing radius; proved to be all.
    all: Vec<(State, Stability)>,
}

fn states(contact: &CaseContact, at: &Literal) -> Result<States> {
    let answer = contact.answer([contact.all_folds(), Want::Equilibria { at: vec![at.clone()] }])?;
    let (folds, list) = answer.folds().zip(answer.equilibria()).ok_or(Failure::Missing("equilibria"))?;
    let decided = |status| matches!(status, Outcome::Ok | Outcome::NoEquilibrium);
    if !list.items.iter().all(|item| decided(item.status)) || list.complete.as_ref().is_none_or(|all| !all.proved) {
        return Err(Failure::Missing("proof that these are all equilibria"));
    }
    let fold = folds.items.first().map(|fold| decimals([&fold.contact_radius, &fold.indentation, &fold.force]));
    let certified = |state: &Equilibrium| {
        let values = decimals([&state.contact_radius, &state.indentation, &state.force]);
        Ok::<_, Failure>((values?, state.stability))
    };
    let states = list.items.iter().flat_map(|item| &item.items).map(certified);
    Ok(States { fold: fold.ok_or(Failure::Missing("fold"))??, all: states.collect::<Result<_>>()? })
}

/// The relative distance of a value to the critical one.
fn distance(contact: &CaseContact, at: &Literal, [_, d, f]: &State) -> f64 {
    let ctx = Precision::new(BITS);
    let critical = if contact.symbol() == "d" { d } else { f };
    (Float::from_literal(ctx, at) / float(ctx, critical) - 1u32).abs().to_f64()
}

/// A question about an equilibrium at this relative distance to the critical state of a power law.
fn beside_fold(case: &Case, distance: f64) -> RecordBuilder<'_> {
    let builder = RecordBuilder::new(case, case.contact.inputs()).flag(&case.row.side).fold_distance(distance);
    if distance <= 1e-2 { builder.flag("near-fold") } else { builder }
}
