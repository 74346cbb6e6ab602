//! Folds of the profiles of the library: isolated with a proof over closed forms in intervals, confirmed by tangency of
//! quadratures.

use mdr_core::contact::{Instability, Material, Quantity, Result};
use mdr_core::number::certify::{Decimal, Enclosure, certify};
use mdr_core::number::{Dual, Interval, Precision, Real};
use mdr_numeric::curve::Curve;
use mdr_numeric::proof::{EnclosedCurve, ProvedFolds};
use mdr_numeric::transform::Quadrature;
use mdr_reference::Record;
use rug::Float;

use super::RecordError;
use super::condition::{Named, input, largest, push};
use super::confirm;
use super::draft::{DIGITS, Draft, STATE, literal};
use super::library::Profile;
use super::load::Load;
use crate::library::Height;

/// A profile of the library on a material, and the range of radii in which its folds are sought.
#[derive(Clone, Debug)]
pub(super) struct Scene {
    pub(super) name: &'static str,
    pub(super) profile: Profile<'static>,
    pub(super) e_star: &'static str,
    pub(super) work: &'static str,
    pub(super) range: (f64, f64),
}

/// Bits of the first isolation, of the digits and of the conditions.
const FIRST: u32 = 64;
pub(super) const BITS: u32 = 256;

/// Evaluations that the isolation may take.
const BUDGET: usize = 200_000;

impl Scene {
    /// a, d and F at all folds that are proved to be single ones.
    pub(super) fn records(&self, load: Load) -> std::result::Result<Vec<Record>, RecordError> {
        let wrong = |error| RecordError::of(self.name, error);
        let proved = self.proved(load).map_err(wrong)?;
        let complete = proved.is_complete();
        let mut records = Vec::new();
        for (index, fold) in proved.folds.iter().enumerate() {
            let values = self.certified(fold, load, DIGITS).map_err(wrong)?;
            let conditions = self.conditions(fold, load).map_err(wrong)?;
            RecordError::unless(self.name, "the fold", self.confirmed(&values, load, largest(&conditions)))?;
            let draft = self.draft(index, fold, complete, load);
            records.extend(draft.records(STATE, values, conditions));
        }
        if records.is_empty() { Err(RecordError::missing(self.name, "fold")) } else { Ok(records) }
    }

    /// All folds in the range.
    pub(super) fn proved(&self, load: Load) -> Result<ProvedFolds> {
        let ends = [self.range.0, self.range.1].map(|end| Float::with_val(FIRST, end));
        self.enclosed(FIRST, load, |curve| curve.folds(&ends[0], &ends[1], BUDGET))
    }

    fn draft(&self, index: usize, fold: &Instability<Interval>, complete: bool, load: Load) -> Draft {
        Draft {
            id: format!("fold/{}/fold-{}", self.case(load), index + 1),
            profile: self.profile.shape.name(),
            formula: "folds",
            inputs: self.given(load).chain([("fold", (index + 1).to_string())]).collect(),
            control: Some(load.name()),
            methods: ["interval-isolation", "quadrature-tangency/mp"],
            flags: [fold.kind.name()].into_iter().chain(complete.then_some("all-folds-proved")).collect(),
            proof: vec!["1.5", "1.6", "1.10"],
            refs: vec!["Popov (1.5)", "Popov (1.6)", "Popov (1.10)"],
            ..Draft::default()
        }
    }

    /// The same as they are written into records.
    pub(super) fn given(&self, load: Load) -> impl Iterator<Item = (&'static str, String)> {
        self.inputs(load).map(|(name, text)| (name, text.to_owned()))
    }

    /// The name, with the stiffness of the machine, for identifiers.
    pub(super) fn case(&self, load: Load) -> String {
        match load.input() {
            Some((name, stiffness)) => format!("{}/{name}={stiffness}", self.name),
            None => self.name.to_owned(),
        }
    }

    /// The parameters, E*, w and, on a machine, k.
    pub(super) fn inputs(&self, load: Load) -> impl Iterator<Item = (&'static str, &'static str)> {
        self.profile.parameters.iter().copied().chain([("E*", self.e_star), ("w", self.work)]).chain(load.input())
    }

    pub(super) fn material<R: Real>(&self, ctx: R::Ctx) -> Result<Material<R>> {
        let [e_star, work] = [self.e_star, self.work].map(|text| R::from_literal(ctx, &literal(text)));
        Material::new(e_star, work)
    }

    /// The contact over enclosures, with and without derivatives.
    pub(super) fn enclosed<T>(
        &self,
        bits: u32,
        load: Load,
        f: impl FnOnce(EnclosedCurve<'_>) -> Result<T>,
    ) -> Result<T> {
        let ctx = Precision::new(bits);
        let plain = self.profile.closed(&self.profile.numbers::<Interval>(ctx))?;
        let moving = self.profile.closed(&self.profile.numbers::<Dual<Interval>>(ctx))?;
        let (material, moving_material) = (self.material::<Interval>(ctx)?, self.material::<Dual<Interval>>(ctx)?);
        let (control, moving_control) = (load.control::<Interval>(ctx), load.moving(ctx, false));
        f(EnclosedCurve::new(
            Curve::new(plain.as_ref(), &material, &control),
            Curve::new(moving.as_ref(), &moving_material, &moving_control),
        ))
    }

    /// a, d and F, to so many digits.
    pub(super) fn certified(&self, fold: &Instability<Interval>, load: Load, digits: u32) -> Result<[Decimal; 3]> {
        let quantities = [Quantity::ContactRadius, Quantity::Indentation, Quantity::Force];
        certify(quantities, digits, Precision::new(BITS), |precision| {
            let sharp = self.enclosed(precision.bits(), load, |curve| curve.sharpen(fold))?;
            Ok([sharp.contact_radius, sharp.indentation, sharp.force].map(Enclosure::from))
        })
    }

    /// By the implicit function theorem for the condition of tangency.
    fn conditions(&self, fold: &Instability<Interval>, load: Load) -> Result<[Named; 3]> {
        let ctx = Precision::new(BITS);
        let a = self.enclosed(BITS, load, |curve| curve.sharpen(fold))?.contact_radius;
        let tangency = |curve: &Curve<'_, Dual<Interval>>, a: &Dual<Interval>| {
            Ok(curve.tangency(a)?.slope - curve.threshold(a)?.slope)
        };
        let mut conditions: [Named; 3] = Default::default();
        let across = self.moving(ctx, usize::MAX, load, |curve| tangency(curve, &Dual::variable(a.clone())))?;
        for (index, (name, _)) in self.inputs(load).enumerate() {
            let (radius, [d, f]) = self.moving(ctx, index, load, |curve| {
                let along = tangency(curve, &Dual::constant(a.clone()))?;
                let radius = Dual { value: a.clone(), slope: -along / &across };
                let (d, f) = curve.state(&radius)?;
                Ok((radius, [d, f]))
            })?;
            push(&mut conditions, name, [radius, d, f]);
        }
        Ok(conditions)
    }

    /// The contact with a derivative with respect to the logarithm of one input.
    pub(super) fn moving<T>(
        &self,
        ctx: Precision,
        moving: usize,
        load: Load,
        f: impl FnOnce(&Curve<'_, Dual<Interval>>) -> Result<T>,
    ) -> Result<T> {
        let transform = self.profile.closed(&self.profile.moving(ctx, moving))?;
        let count = self.profile.parameters.len();
        let seeded = |text: &str, index: usize| input(ctx, &literal(text), index == moving);
        let material = Material::new(seeded(self.e_star, count), seeded(self.work, count + 1))?;
        let control = load.moving(ctx, moving == count + 2);
        f(&Curve::new(transform.as_ref(), &material, &control))
    }

    fn confirmed(&self, values: &[Decimal; 3], load: Load, condition: f64) -> Result<bool> {
        let ctx = confirm::precision(condition);
        let state = std::array::from_fn(|index| confirm::float(ctx, &values[index]));
        self.integrated(ctx, load, |curve| confirm::state_at_fold(curve, &state))
    }

    /// The contact by quadrature of heights.
    pub(super) fn integrated<T>(
        &self,
        ctx: Precision,
        load: Load,
        f: impl FnOnce(&Curve<'_, Float>) -> Result<T>,
    ) -> Result<T> {
        let parameters = self.profile.numbers::<Float>(ctx);
        let transform = Quadrature::new(Height { shape: self.profile.shape, parameters });
        let (material, control) = (self.material::<Float>(ctx)?, load.control::<Float>(ctx));
        f(&Curve::new(&transform, &material, &control))
    }
}
