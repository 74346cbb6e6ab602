//! Folds on a machine, thresholds at n = 1/2, and the energy of jumps.

use mdr_analytic::{Contact, Kappa, threshold};
use mdr_core::contact::{Control, Quantity, Result};
use mdr_core::number::certify::{Decimal, Enclosure, certify};
use mdr_core::number::{Interval, Precision, Real};
use mdr_numeric::curve::Curve;
use mdr_numeric::energy::Energy;
use mdr_reference::Record;
use rug::Float;

use super::RecordError;
use super::condition::{Named, input, largest, push, relative};
use super::confirm;
use super::draft::{Answered, DIGITS, Draft, STATE, literal};
use super::power::{Held, NAMES, Power};

/// Bits for conditions.
const BITS: u32 = 192;

/// All folds of a power law on a machine of stiffness k.
pub(super) fn folds(law: &Power, stiffness: &str) -> std::result::Result<Vec<Record>, RecordError> {
    let wrong = |error| RecordError::of(&law.name, error);
    let k = literal(stiffness);
    let answer = law.question(&Control::Machine { stiffness: k.clone() })?.answer(DIGITS).map_err(wrong)?;
    let conditions = machine_conditions(law, stiffness).map_err(wrong)?;
    let mut records = Vec::new();
    for (index, (fold, conditions)) in answer.folds.into_iter().zip(conditions).enumerate() {
        let values = [fold.contact_radius, fold.indentation, fold.force];
        let ctx = confirm::precision(largest(&conditions));
        let control = Control::Machine { stiffness: Float::from_literal(ctx, &k) };
        confirm::fold(law, &control, &values, largest(&conditions))?;
        let draft = law.draft("machine");
        let draft = Draft {
            id: format!("{}/k={stiffness}/fold-{}", draft.id, index + 1),
            formula: "machine-folds",
            control: Some("machine"),
            inputs: draft
                .inputs
                .iter()
                .cloned()
                .chain([("k", stiffness.to_owned()), ("fold", (index + 1).to_string())])
                .collect(),
            methods: ["closed-form/interval", "quadrature-tangency/mp"],
            proof: if law.n == "0.5" { vec!["machine-half"] } else { vec!["critical-machine", "machine-folds"] },
            refs: vec!["Popov (1.5)", "Popov (1.6)", "tangency g' = Delta l' (k+6E*a)/(k+2E*a)"],
            ..draft
        };
        records.extend(draft.records(STATE, values, conditions));
    }
    if records.is_empty() { Err(RecordError::missing(&law.name, "fold")) } else { Ok(records) }
}

/// For each fold those of a, d and F, in arbitrary precision: the proof of the folds does not cover slopes.
fn machine_conditions(law: &Power, stiffness: &str) -> Result<Vec<[Named; 3]>> {
    let ctx = Precision::new(BITS);
    let mut conditions: Vec<[Named; 3]> = Vec::new();
    for (index, name) in NAMES.into_iter().chain(["k"]).enumerate() {
        let contact = law.moving::<Float>(ctx, index)?;
        let stiffness = input(ctx, &literal(stiffness), index == NAMES.len());
        for (position, fold) in contact.machine_folds(&stiffness)?.into_iter().enumerate() {
            if conditions.len() == position {
                conditions.push(Default::default());
            }
            let state = [fold.contact_radius, fold.indentation, fold.force];
            push(&mut conditions[position], name, state);
        }
    }
    Ok(conditions)
}

/// The threshold of C at n = 1/2, and the ratio of C to it.
pub(super) fn thresholds(law: &Power) -> std::result::Result<Vec<Record>, RecordError> {
    let wrong = |error| RecordError::of(&law.name, error);
    let mut records = Vec::new();
    for held in Held::ALL {
        let answer = law.question(&held.control())?.answer(DIGITS).map_err(wrong)?;
        let (Some(value), Some(ratio)) = (answer.threshold, answer.ratio) else {
            return Err(RecordError::missing(&law.name, "threshold"));
        };
        RecordError::unless(&law.name, "the threshold", tangent_everywhere(law, held, &value))?;
        let given = law.draft("threshold");
        let draft = Draft {
            formula: "threshold",
            control: Some(held.name()),
            methods: ["closed-form/interval", "quadrature-tangency/mp"],
            proof: vec![if held == Held::Force { "threshold-force" } else { "1.19" }],
            refs: vec!["Popov (1.18)", "Popov (1.19)"],
            inputs: given.inputs.iter().filter(|(name, _)| !["n", "C"].contains(name)).cloned().collect(),
            ..given.clone()
        };
        let [threshold, over] = threshold_conditions(law, held).map_err(wrong)?;
        let answered = |quantity, unit, value, condition| Answered { quantity, unit, value, condition, scale: None };
        records.push(draft.record(answered("threshold_c", "m^(1/2)", value, threshold)));
        let inputs = given.inputs.iter().filter(|(name, _)| *name != "n").cloned().collect();
        records.push(Draft { inputs, ..draft }.record(answered("ratio", "1", ratio, over)));
    }
    Ok(records)
}

/// With this C the curves touch at any radius; here at 1.
fn tangent_everywhere(law: &Power, held: Held, threshold: &Decimal) -> Result<bool> {
    let ctx = confirm::precision(1.0);
    let control = held.control();
    confirm::changes_sign(&confirm::float(ctx, threshold), |c| {
        let law = Power { c: c.to_string_radix(10, None), ..law.clone() };
        let (transform, material) = confirm::power(&law, ctx)?;
        let curve = Curve::new(&transform, &material, &control);
        let one = c.lit(1);
        Ok(curve.tangency(&one)? - curve.threshold(&one)?)
    })
}

/// In arbitrary precision: the enclosed mean of the lemniscate constant has no enclosed slope.
fn threshold_conditions(law: &Power, held: Held) -> Result<[Named; 2]> {
    let mut conditions: [Named; 2] = Default::default();
    for (index, name) in NAMES.into_iter().enumerate().skip(1) {
        let contact = law.moving::<Float>(Precision::new(BITS), index)?;
        let value = threshold(contact.material(), &held.control())?;
        let ratio = contact.profile().coefficient().clone() / &value;
        let [value, ratio] = [value, ratio].map(relative);
        // The threshold is one of C, and does not depend on it.
        if name != "C" {
            conditions[0].push((name.to_owned(), value));
        }
        conditions[1].push((name.to_owned(), ratio));
    }
    Ok(conditions)
}

/// The energies of a power law that jumps at fixed grips.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Jump {
    /// Lost when the contact breaks.
    PullOff,
    /// Lost when it forms at d = 0.
    Approach,
    /// The barrier before complete contact at d = 0.
    Barrier,
}

impl Jump {
    pub(super) fn name(self) -> &'static str {
        match self {
            Jump::PullOff => "work-lost-at-pull-off",
            Jump::Approach => "work-lost-at-jump-in",
            Jump::Barrier => "barrier-to-complete-contact",
        }
    }

    fn energy<R: Kappa>(self, contact: &Contact<R>) -> Result<R> {
        match self {
            Jump::PullOff => contact.energy_lost_at_pull_off(),
            Jump::Approach => contact.energy_lost_at_jump_in(),
            Jump::Barrier => contact.barrier_to_complete_contact(),
        }
    }

    /// a and d of the state whose energy it is, and the sign.
    fn state(self, contact: &Contact<Interval>) -> Result<(Float, Float, i64)> {
        if self == Jump::PullOff {
            let state = contact.critical(&Control::Indentation)?;
            return Ok((state.contact_radius.mid(), state.indentation.mid(), 1));
        }
        let a = contact.radius_at_zero_indentation()?;
        Ok((a.mid(), a.lit(0).mid(), if self == Jump::Barrier { 1 } else { -1 }))
    }
}

/// Its record, confirmed by the potential energy as an integral over quadratures.
pub(super) fn jump(law: &Power, jump: Jump) -> std::result::Result<Record, RecordError> {
    let wrong = |error| RecordError::of(&law.name, error);
    let [value] = certify([Quantity::Energy], DIGITS, Precision::new(BITS), |precision| {
        Ok([Enclosure::from(jump.energy(&law.contact::<Interval>(precision)?)?)])
    })
    .map_err(wrong)?;
    let check = || {
        let ctx = confirm::precision(1.0);
        let (a, d, sign) = jump.state(&law.contact::<Interval>(ctx)?)?;
        let (transform, material) = confirm::power(law, ctx)?;
        let potential = Energy::new(&transform, &material)?.potential(&a, &d)?.times(sign);
        let scale = a.pi() * a.square() * material.work_of_adhesion();
        Ok(confirm::agree(&potential, &confirm::float(ctx, &value), &scale))
    };
    RecordError::unless(&law.name, "the energy", check())?;
    let condition = || {
        let condition = |(index, name): (usize, &'static str)| {
            let energy = jump.energy(&law.moving::<Interval>(Precision::new(BITS), index)?)?;
            Ok((name.to_owned(), relative(energy)))
        };
        NAMES.into_iter().enumerate().map(condition).collect::<Result<Named>>()
    };
    let draft = Draft {
        formula: jump.name(),
        control: Some("indentation"),
        methods: ["closed-form/interval", "potential-energy/mp"],
        proof: vec![if jump == Jump::PullOff { "work-pull-off" } else { "work-jump-in" }],
        refs: vec!["Griffith 1921", "Popov (1.15) corrected"],
        ..law.draft("jump")
    };
    let condition = condition().map_err(wrong)?;
    let draft = Draft { id: format!("{}/{}", draft.id, jump.name()), ..draft };
    Ok(draft.record(Answered { quantity: "energy", unit: "J", value, condition, scale: None }))
}
