//! Equilibria of the profiles of the library at a value of what is held, and where a contact lands that jumps: on branches
//! between proved folds, over closed forms in intervals; confirmed by the direction of change from quadratures.

use mdr_core::contact::{Equilibrium, Quantity, Result, Stability};
use mdr_core::number::certify::{Decimal, Enclosure, certify};
use mdr_core::number::{Dual, Interval, Precision, Real};
use mdr_numeric::branch::Branched;
use mdr_numeric::curve::Curve;
use mdr_numeric::proof::{EnclosedBranches, ProvedFolds};
use mdr_reference::Record;

use super::RecordError;
use super::condition::{Named, largest, push};
use super::confirm;
use super::draft::{DIGITS, Draft, STATE, literal};
use super::folds::{BITS, Scene};
use super::load::Load;

/// What is asked about the equilibria of a scene.
#[derive(Clone, Copy, Debug)]
pub(super) enum At {
    /// All equilibria at this value of what is held.
    Value(&'static str),
    /// The equilibrium that the contact reaches when it jumps at the fold of this number, from 1.
    Fold(usize),
}

/// A question about the equilibria of a scene.
#[derive(Clone, Debug)]
pub(super) struct Contacts {
    pub(super) scene: Scene,
    pub(super) load: Load,
    pub(super) at: At,
}

/// An equilibrium: its place in the list, a, d and F in fifty digits, and whether it is stable.
struct Found {
    index: usize,
    values: [Decimal; 3],
    stability: Stability,
}

impl Contacts {
    /// The contact radius and what is not held, of all equilibria that are asked for.
    pub(super) fn records(&self) -> std::result::Result<Vec<Record>, RecordError> {
        let wrong = |error| RecordError::of(self.scene.name, error);
        let proved = self.scene.proved(self.load).map_err(wrong)?;
        let mut records = Vec::new();
        for found in self.certified(&proved).map_err(wrong)? {
            let conditions = self.conditions(&proved, &found).map_err(wrong)?;
            RecordError::unless(
                self.scene.name,
                "the equilibrium",
                self.confirmed(&proved, &found.values, largest(&conditions)),
            )?;
            let draft = self.draft(&found);
            let state = draft.records(STATE, found.values, conditions);
            records.extend(state.filter(|record| record.quantity != self.load.name()));
        }
        if records.is_empty() { Err(RecordError::missing(self.scene.name, "equilibrium")) } else { Ok(records) }
    }

    fn draft(&self, found: &Found) -> Draft {
        let (name, symbol) = (self.scene.case(self.load), self.load.symbol());
        let (id, formula, inputs) = match self.at {
            At::Value(value) => {
                let state = (found.index + 1).to_string();
                let id = format!("equilibria/{name}/{symbol}={value}/state-{state}");
                (id, "equilibria", vec![(symbol, value.to_owned()), ("state", state)])
            }
            At::Fold(fold) => (format!("landing/{name}/fold-{fold}"), "landing", vec![("fold", fold.to_string())]),
        };
        Draft {
            id,
            profile: self.scene.profile.shape.name(),
            formula,
            inputs: self.scene.given(self.load).chain(inputs).collect(),
            control: Some(self.load.name()),
            methods: ["interval-isolation", "quadrature-direction/mp"],
            proof: vec!["1.5", "1.6"],
            refs: vec!["Popov (1.5)", "Popov (1.6)"],
            flags: vec![if found.stability == Stability::Stable { "stable" } else { "unstable" }],
            ..Draft::default()
        }
    }

    /// What is held, and the equilibria there, over enclosures.
    fn enclosed(&self, proved: &ProvedFolds, bits: u32) -> Result<(Interval, Vec<Equilibrium<Interval>>)> {
        self.scene.enclosed(bits, self.load, |curve| {
            let branches = EnclosedBranches::new(curve, proved)?;
            match self.at {
                At::Value(value) => {
                    let value = Interval::from_literal(Precision::new(bits), &literal(value));
                    let found = branches.equilibria(&value)?;
                    Ok((value, found))
                }
                At::Fold(fold) => {
                    let start = &branches.folds()[fold - 1];
                    let value = branches.control().controlled(&start.indentation, &start.force);
                    Ok((value, branches.landing(fold - 1)?.into_iter().map(|(_, state)| state).collect()))
                }
            }
        })
    }

    fn certified(&self, proved: &ProvedFolds) -> Result<Vec<Found>> {
        let quantities = [Quantity::ContactRadius, Quantity::Indentation, Quantity::Force];
        let (_, states) = self.enclosed(proved, BITS)?;
        let certified = |(index, state): (usize, Equilibrium<Interval>)| {
            let values = certify(quantities, DIGITS, Precision::new(BITS), |precision| {
                let (_, states) = self.enclosed(proved, precision.bits())?;
                let Equilibrium { contact_radius, indentation, force, .. } = states[index].clone();
                Ok([contact_radius, indentation, force].map(Enclosure::from))
            })?;
            Ok(Found { index, values, stability: state.stability })
        };
        states.into_iter().enumerate().map(certified).collect()
    }

    /// By the implicit function theorem: the slope of the radius is that of the residual at fixed radius over that of what
    /// is held along the equilibria. At a fold what is held does not depend on the radius, so that the radius of the fold
    /// may be held fixed, too.
    fn conditions(&self, proved: &ProvedFolds, found: &Found) -> Result<[Named; 3]> {
        let ctx = Precision::new(BITS);
        let (_, states) = self.enclosed(proved, BITS)?;
        let a = states[found.index].contact_radius.clone();
        let fold = match self.at {
            At::Value(_) => None,
            At::Fold(fold) => {
                Some(self.scene.enclosed(BITS, self.load, |curve| curve.sharpen(&proved.folds[fold - 1]))?)
            }
        };
        let across = self.scene.moving(ctx, usize::MAX, self.load, |curve| held(curve, &Dual::variable(a.clone())))?;
        let last = matches!(self.at, At::Value(_)).then(|| self.load.symbol());
        let mut conditions: [Named; 3] = Default::default();
        for (index, name) in self.scene.inputs(self.load).map(|(name, _)| name).chain(last).enumerate() {
            let state = self.scene.moving(ctx, index, self.load, |curve| {
                let target = match (self.at, &fold) {
                    (At::Value(value), _) if Some(name) == last => Interval::from_literal(ctx, &literal(value)),
                    (_, Some(fold)) => held(curve, &Dual::constant(fold.contact_radius.clone()))?,
                    _ => a.lit(0),
                };
                let residual = held(curve, &Dual::constant(a.clone()))? - target;
                let radius = Dual { value: a.clone(), slope: -residual / &across };
                let (d, f) = curve.state(&radius)?;
                Ok([radius, d, f])
            })?;
            push(&mut conditions, name, state);
        }
        Ok(conditions)
    }

    /// By quadratures: the direction of change turns at this radius, and d and F are on the curve.
    fn confirmed(&self, proved: &ProvedFolds, values: &[Decimal; 3], condition: f64) -> Result<bool> {
        let ctx = confirm::precision(condition);
        let target = self.enclosed(proved, ctx.bits())?.0.mid();
        let [a, d, f] = values.each_ref().map(|value| confirm::float(ctx, value));
        self.scene.integrated(ctx, self.load, |curve| {
            let turns = confirm::changes_sign(&a, |a| curve.direction(a, &target))?;
            Ok(turns && confirm::on_curve(curve, [&a, &d, &f])?)
        })
    }
}

/// The derivative of what is held along the equilibria.
fn held(curve: &Curve<'_, Dual<Interval>>, a: &Dual<Interval>) -> Result<Interval> {
    let (d, f) = curve.state(a)?;
    Ok(curve.control().controlled(&d, &f).slope)
}
