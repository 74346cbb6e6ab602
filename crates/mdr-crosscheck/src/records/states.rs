//! Single states: the equilibrium that belongs to a contact radius, and the pull-off of a flat punch.

use std::sync::Arc;

use mdr_analytic::flat_punch_pull_off;
use mdr_core::contact::{Control, Material, Quantity, Result};
use mdr_core::number::certify::{Decimal, Enclosure, certify};
use mdr_core::number::{Dual, Interval, Precision, Real};
use mdr_numeric::admissible::{Admissibility, Verdict};
use mdr_numeric::transform::Quadrature;
use mdr_reference::Record;
use rug::Float;

use super::RecordError;
use super::condition::{Named, input, push};
use super::confirm;
use super::draft::{DIGITS, Draft, STATE, literal};
use super::folds::{BITS, Scene};
use super::load::Load;
use crate::library::Height;

/// d and F: the radius is given.
const LOADS: [(&str, &str); 2] = [STATE[1], STATE[2]];

impl Scene {
    /// d and F of the equilibrium with the contact radius `a`. The surfaces may not overlap outside of it: that is looked for
    /// out to twice the radius, or the end of the range; all profiles of which this is asked are convex beyond it.
    pub(super) fn state(&self, a: &str) -> std::result::Result<Vec<Record>, RecordError> {
        let wrong = |error| RecordError::of(self.name, error);
        let quantities = [Quantity::Indentation, Quantity::Force];
        let values = certify(quantities, DIGITS, Precision::new(BITS), |precision| {
            self.enclosed(precision.bits(), FREE, |curve| {
                let (d, f) = curve.plain().state(&Interval::from_literal(precision, &literal(a)))?;
                Ok([d, f].map(Enclosure::from))
            })
        })
        .map_err(wrong)?;
        let conditions = self.state_conditions(a).map_err(wrong)?;
        RecordError::unless(self.name, "the state", self.is_on_curve(a, &values))?;
        RecordError::unless(self.name, "the gap", self.is_open(a))?;
        let draft = Draft {
            id: format!("state/{}/a={a}", self.name),
            profile: self.profile.shape.name(),
            formula: "state",
            inputs: self.given(FREE).chain([("a", a.to_owned())]).collect(),
            methods: ["closed-form/interval", "quadrature/mp"],
            proof: vec!["1.5", "1.6"],
            refs: vec!["Popov (1.5)", "Popov (1.6)"],
            ..Draft::default()
        };
        Ok(draft.records(LOADS, values, conditions).collect())
    }

    fn state_conditions(&self, a: &str) -> Result<[Named; 2]> {
        let ctx = Precision::new(BITS);
        let names: Vec<_> = self.inputs(FREE).map(|(name, _)| name).chain(["a"]).collect();
        let last = names.len() - 1;
        conditions(&names, |moving| {
            self.moving(ctx, moving, FREE, |curve| {
                let (d, f) = curve.state(&input(ctx, &literal(a), moving == last))?;
                Ok([d, f])
            })
        })
    }

    fn is_on_curve(&self, a: &str, values: &[Decimal; 2]) -> Result<bool> {
        let ctx = confirm::precision(1.0);
        let a = Float::from_literal(ctx, &literal(a));
        let [d, f] = values.each_ref().map(|value| confirm::float(ctx, value));
        self.integrated(ctx, FREE, |curve| confirm::on_curve(curve, [&a, &d, &f]))
    }

    /// Whether the surfaces are apart, in double precision.
    fn is_open(&self, a: &str) -> Result<bool> {
        let height = Height { shape: self.profile.shape, parameters: self.profile.numbers::<f64>(()) };
        let transform = Arc::new(Quadrature::new(height));
        let (material, control) = (self.material::<f64>(())?, Control::Indentation);
        let a = literal(a).nearest_f64();
        let curve = mdr_numeric::curve::Curve::new(&*transform, &material, &control);
        let admissibility = Admissibility::new(transform.clone(), [1e-6 * a, self.range.1.min(2.0 * a)]);
        Ok(!matches!(admissibility.of(a, curve.indentation(&a)?), Verdict::Interpenetrating { .. }))
    }
}

/// A state that belongs to a radius belongs to it whatever is held.
const FREE: Load = Load::Indentation;

/// A flat punch on E* and w.
#[derive(Clone, Copy, Debug)]
pub(super) struct Punch {
    pub(super) name: &'static str,
    pub(super) radius: &'static str,
    pub(super) e_star: &'static str,
    pub(super) work: &'static str,
}

impl Punch {
    fn texts(&self) -> [&'static str; 3] {
        [self.radius, self.e_star, self.work]
    }

    /// d and F at which it comes off; confirmed by the balance of energy of Griffith: E*d² = 2πbw and F = 2E*bd.
    pub(super) fn pull_off(&self) -> std::result::Result<Vec<Record>, RecordError> {
        let wrong = |error| RecordError::of(self.name, error);
        let quantities = [Quantity::Indentation, Quantity::Force];
        let values = certify(quantities, DIGITS, Precision::new(BITS), |precision| {
            let [b, e_star, work] = self.texts().map(|text| Interval::from_literal(precision, &literal(text)));
            let state = flat_punch_pull_off(&b, &Material::new(e_star, work)?)?;
            Ok([state.indentation, state.force].map(Enclosure::from))
        })
        .map_err(wrong)?;
        let names = ["radius", "E*", "w"];
        let conditions = conditions(&names, |moving| self.moving(moving)).map_err(wrong)?;
        RecordError::unless(self.name, "pull-off", Ok(self.is_balanced(&values)))?;
        let draft = Draft {
            id: format!("flat-punch/{}", self.name),
            profile: "flat-punch",
            formula: "flat-punch-pull-off",
            inputs: names.into_iter().zip(self.texts().map(str::to_owned)).collect(),
            methods: ["closed-form/interval", "energy-balance/mp"],
            proof: vec!["kendall"],
            refs: vec!["Kendall 1971"],
            flags: if self.name == "unit" { Vec::new() } else { vec!["si"] },
            ..Draft::default()
        };
        Ok(draft.records(LOADS, values, conditions).collect())
    }

    fn moving(&self, moving: usize) -> Result<[Dual<Interval>; 2]> {
        let texts = self.texts();
        let [b, e_star, work] =
            [0, 1, 2].map(|index| input(Precision::new(BITS), &literal(texts[index]), index == moving));
        let state = flat_punch_pull_off(&b, &Material::new(e_star, work)?)?;
        Ok([state.indentation, state.force])
    }

    /// The energy E*bd² of the punch held at d, given to its rim: its derivative with respect to b is 2πbw, that with respect
    /// to d is F.
    fn is_balanced(&self, values: &[Decimal; 2]) -> bool {
        let ctx = confirm::precision(1.0);
        let [b, e_star, work] = self.texts().map(|text| Float::from_literal(ctx, &literal(text)));
        let [d, f] = values.each_ref().map(|value| confirm::float(ctx, value));
        let energy = |b: Dual<Float>, d: Dual<Float>| (Dual::constant(e_star.clone()) * b * d.square()).slope;
        let released = energy(Dual::variable(b.clone()), Dual::constant(d.clone()));
        let pull = energy(Dual::constant(b.clone()), Dual::variable(d.clone()));
        let spent = (b.pi() * &b * &work).times(2);
        d < d.lit(0) && confirm::agree(&released, &spent, &spent) && confirm::agree(&pull, &f, &f.clone().abs())
    }
}

/// d ln d and d ln F with respect to the logarithm of each input.
fn conditions(names: &[&str], state: impl Fn(usize) -> Result<[Dual<Interval>; 2]>) -> Result<[Named; 2]> {
    let mut conditions: [Named; 2] = Default::default();
    for (index, name) in names.iter().enumerate() {
        push(&mut conditions, name, state(index)?);
    }
    Ok(conditions)
}
