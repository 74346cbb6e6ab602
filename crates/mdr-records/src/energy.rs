//! Energies of power laws that jump under fixed grips.

use mdr::answer::{Dissipation, PathEvent};
use mdr::prelude::{Literal, Start, Want};
use mdr_analytic::PowerLawContact as Law;
use mdr_core::contact;
use mdr_core::number::{Decimal, Real};
use mdr_numeric::energy::Energy;
use mdr_reference::Record;

use crate::builder::RecordBuilder;
use crate::cases::{Case, number};
use crate::contact::CaseContact;
use crate::sensitivity::{Seeded, conditions};
use crate::{Failure, Result, confirm, decimals, float};

/// The closed form of an energy.
type Closed = fn(&Law<Seeded>) -> contact::Result<Seeded>;

/// Beyond every critical state of the records.
const FAR: &str = "-1e1000";

/// The energy, and a and d of the state whose potential energy it is, up to the sign.
struct Jump {
    energy: Decimal,
    state: [Decimal; 2],
    sign: i64,
}

/// The energy lost at pull-off, when the contact forms, or needed to pass the barrier; confirmed by the potential
/// energy as an integral over quadratures.
pub(crate) fn record(case: &Case) -> Result<Vec<Record>> {
    let contact = &case.contact;
    let (zero, far) = (Literal::from(0), number(FAR)?);
    let (jump, closed): (Jump, Closed) = match case.at.as_str() {
        "work-lost-at-pull-off" => (lost(contact, [zero, far], Start::Largest, false)?, Law::energy_lost_at_pull_off),
        "work-lost-at-jump-in" => (lost(contact, [far, zero], Start::Detached, true)?, Law::energy_lost_at_jump_in),
        _ => (barrier(contact)?, Law::barrier_to_complete_contact),
    };
    let Jump { energy, state, sign } = jump;
    let ctx = confirm::precision(&[]);
    let agrees = contact.float(ctx)?.integrated(|curve| {
        let [a, d, energy] = [&state[0], &state[1], &energy].map(|value| float(ctx, value));
        let potential = Energy::new(curve.clone())?.potential(&a, &d)?.times(sign);
        let scale = a.pi() * a.square() * curve.adhesion().work();
        Ok(confirm::agree(&potential, &energy, &scale))
    });
    Failure::unless("the energy", agrees?)?;
    let [condition] = conditions(contact, None, |model, _| Ok([closed(&model.law()?)?]))?;
    let builder = RecordBuilder::new(case, contact.inputs()).part(&case.at);
    Ok(vec![builder.number(("energy", "J"), &energy, condition, None)])
}

/// The energy lost in the first event of a path that loses energy: −Π after it if the contact `forms`, Π before it if the
/// contact breaks.
fn lost(contact: &CaseContact, path: [Literal; 2], start: Start, forms: bool) -> Result<Jump> {
    let answer = contact.scene()?.path(path)?.start(start).want(Want::Path).solve()?;
    let events = answer.path().map(|path| path.events.items.as_slice()).unwrap_or_default();
    let loss = |event: &PathEvent| match &event.dissipated {
        Some(Dissipation::Finite(energy)) => Some((event.clone(), energy.clone())),
        _ => None,
    };
    let (event, energy) = events.iter().find_map(loss).ok_or(Failure::Missing("loss of energy"))?;
    let (radius, depth) = match forms {
        true => (event.to_contact_radius, event.to_indentation),
        false => (event.contact_radius, event.indentation),
    };
    let (radius, depth) = radius.zip(depth).ok_or(Failure::Missing("contact"))?;
    let [energy, a, d] = decimals([&energy, &radius, &depth])?;
    Ok(Jump { energy, state: [a, d], sign: if forms { -1 } else { 1 } })
}

/// Π of the equilibrium at d = 0.
fn barrier(contact: &CaseContact) -> Result<Jump> {
    let answer = contact.answer([Want::Energy { states: vec![Literal::from(0)] }])?;
    let states = answer.energy().into_iter().flat_map(|list| &list.items).flat_map(|item| &item.items);
    let top = states.last().ok_or(Failure::Missing("equilibrium"))?;
    let [energy, a, d] = decimals([&top.energy, &top.state.contact_radius, &top.state.indentation])?;
    Ok(Jump { energy, state: [a, d], sign: 1 })
}
