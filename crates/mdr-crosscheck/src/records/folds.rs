//! Folds of the profiles of the library: isolated with a proof over closed forms in intervals, confirmed by tangency of
//! quadratures.

use mdr_core::contact::{Control, Instability, Material, Quantity, Result};
use mdr_core::number::certify::{Decimal, Enclosure, certify};
use mdr_core::number::{Dual, Interval, Precision, Real};
use mdr_numeric::curve::Curve;
use mdr_numeric::proof::EnclosedCurve;
use mdr_numeric::transform::Quadrature;
use mdr_reference::Record;
use rug::Float;

use super::RecordError;
use super::confirm;
use super::draft::{Answered, DIGITS, Draft, literal};
use super::library::Profile;
use super::power::{Held, Named};
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
const BITS: u32 = 256;

/// Evaluations that the isolation may take.
const BUDGET: usize = 200_000;

const STATE: [(&str, &str); 3] = [("contact_radius", "m"), ("indentation", "m"), ("force", "N")];

impl Scene {
    /// a, d and F at all folds that are proved to be single ones.
    pub(super) fn records(&self, held: Held) -> std::result::Result<Vec<Record>, RecordError> {
        let wrong = |error| RecordError::of(self.name, error);
        let ends = [self.range.0, self.range.1].map(|end| Float::with_val(FIRST, end));
        let proved = self.enclosed(FIRST, held, |curve| curve.folds(&ends[0], &ends[1], BUDGET)).map_err(wrong)?;
        let complete = proved.is_complete();
        let mut records = Vec::new();
        for (index, fold) in proved.folds.iter().enumerate() {
            let values = self.certified(fold, held).map_err(wrong)?;
            let conditions = self.conditions(fold, held).map_err(wrong)?;
            let total = conditions.iter().flatten().map(|(_, x)| x).fold(1.0, |a: f64, b| a.max(*b));
            RecordError::unless(self.name, "the fold", self.confirmed(&values, held, total))?;
            let draft = self.draft(index, fold, complete, held);
            for (((quantity, unit), value), condition) in STATE.into_iter().zip(values).zip(conditions) {
                records.push(draft.record(Answered { quantity, unit, value, condition, scale: None }));
            }
        }
        if records.is_empty() { Err(RecordError::missing(self.name, "fold")) } else { Ok(records) }
    }

    fn draft(&self, index: usize, fold: &Instability<Interval>, complete: bool, held: Held) -> Draft {
        Draft {
            id: format!("fold/{}/fold-{}", self.name, index + 1),
            profile: self.profile.shape.name(),
            formula: "folds",
            inputs: self.inputs().into_iter().map(|(name, text)| (name, text.to_owned())).collect(),
            control: Some(held.name()),
            methods: ["interval-isolation", "quadrature-tangency/mp"],
            flags: [fold.kind.name()].into_iter().chain(complete.then_some("all-folds-proved")).collect(),
            proof: vec!["1.5", "1.6", "1.10"],
            refs: vec!["Popov (1.5)", "Popov (1.6)", "Popov (1.10)"],
            ..Draft::default()
        }
    }

    fn inputs(&self) -> Vec<(&'static str, &'static str)> {
        self.profile.parameters.iter().copied().chain([("E*", self.e_star), ("w", self.work)]).collect()
    }

    fn material<R: Real>(&self, ctx: R::Ctx) -> Result<Material<R>> {
        let [e_star, work] = [self.e_star, self.work].map(|text| R::from_literal(ctx, &literal(text)));
        Material::new(e_star, work)
    }

    /// The contact over enclosures, with and without derivatives.
    fn enclosed<T>(&self, bits: u32, held: Held, f: impl FnOnce(EnclosedCurve<'_>) -> Result<T>) -> Result<T> {
        let ctx = Precision::new(bits);
        let plain = self.profile.closed(&self.profile.numbers::<Interval>(ctx))?;
        let moving = self.profile.closed(&self.profile.numbers::<Dual<Interval>>(ctx))?;
        let (material, moving_material) = (self.material::<Interval>(ctx)?, self.material::<Dual<Interval>>(ctx)?);
        let (control, moving_control) = (held.control(), held.control());
        f(EnclosedCurve::new(
            Curve::new(plain.as_ref(), &material, &control),
            Curve::new(moving.as_ref(), &moving_material, &moving_control),
        ))
    }

    fn certified(&self, fold: &Instability<Interval>, held: Held) -> Result<[Decimal; 3]> {
        let quantities = [Quantity::ContactRadius, Quantity::Indentation, Quantity::Force];
        certify(quantities, DIGITS, Precision::new(BITS), |precision| {
            let sharp = self.enclosed(precision.bits(), held, |curve| curve.sharpen(fold))?;
            Ok([sharp.contact_radius, sharp.indentation, sharp.force].map(Enclosure::from))
        })
    }

    /// By the implicit function theorem for the condition of tangency.
    fn conditions(&self, fold: &Instability<Interval>, held: Held) -> Result<[Named; 3]> {
        let ctx = Precision::new(BITS);
        let a = self.enclosed(BITS, held, |curve| curve.sharpen(fold))?.contact_radius;
        let mut conditions: [Named; 3] = Default::default();
        let across = self.moved(ctx, usize::MAX, held, &Dual::variable(a.clone()))?.0.slope;
        for (index, (name, _)) in self.inputs().into_iter().enumerate() {
            let along = self.moved(ctx, index, held, &Dual::constant(a.clone()))?.0.slope;
            let radius = Dual { value: a.clone(), slope: -along / &across };
            let (_, [d, f]) = self.moved(ctx, index, held, &radius)?;
            for (list, moved) in conditions.iter_mut().zip([radius, d, f]) {
                list.push((name.to_owned(), (moved.slope / moved.value).approx().abs()));
            }
        }
        Ok(conditions)
    }

    /// The condition of tangency, d and F at a radius, with a derivative with respect to the logarithm of one input.
    fn moved(
        &self,
        ctx: Precision,
        moving: usize,
        held: Held,
        a: &Dual<Interval>,
    ) -> Result<(Dual<Interval>, [Dual<Interval>; 2])> {
        let transform = self.profile.closed(&self.profile.moving(ctx, moving))?;
        let count = self.profile.parameters.len();
        let seeded = |text: &str, index: usize| {
            let value = Interval::from_literal(ctx, &literal(text));
            let slope = if index == moving { value.clone() } else { value.lit(0) };
            Dual { value, slope }
        };
        let material = Material::new(seeded(self.e_star, count), seeded(self.work, count + 1))?;
        let control: Control<Dual<Interval>> = held.control();
        let curve = Curve::new(transform.as_ref(), &material, &control);
        let (d, f) = curve.state(a)?;
        Ok((curve.tangency(a)? - curve.threshold(a)?, [d, f]))
    }

    fn confirmed(&self, values: &[Decimal; 3], held: Held, condition: f64) -> Result<bool> {
        let ctx = confirm::precision(condition);
        let parameters = self.profile.numbers::<Float>(ctx);
        let transform = Quadrature::new(Height { shape: self.profile.shape, parameters });
        let (material, control) = (self.material::<Float>(ctx)?, held.control());
        let state = std::array::from_fn(|index| confirm::float(ctx, &values[index]));
        confirm::state_at_fold(&Curve::new(&transform, &material, &control), &state)
    }
}
