//! The condition of folds over sets of radii in any arithmetic, and what doubles decide of it.

use std::cmp::Ordering;

use mdr_core::calculus::isolate::Behaviour;
use mdr_core::contact::{Control, Error, Kink, Result, Slopes};
use mdr_core::number::{DoubleInterval, Dual, Ends, Interval, Literal, Real};

use super::kinks::share;
use crate::contact::Contact;

/// Bits that the radii of a cell have in common: with fewer, its width leaves it undecided, and not the rounding of doubles.
const WIDE: i64 = 20;
/// The most steps of Newton's method in doubles.
const STEPS: u32 = 12;
/// The relative size of the last of them.
const LAST: f64 = f64::EPSILON * 1024.0;

/// The tangency ratio minus its critical value: positive where equilibria are stable, zero at a fold. `None` where the set of radii
/// leaves the domain of the profile.
pub(super) fn condition<R: Real>(contact: &Contact<R>, a: &R) -> Result<Option<R>> {
    match contact.tangency(a) {
        Err(Error::Domain { .. }) => Ok(None),
        ratio => Ok(Some(holding(contact, ratio?) - contact.critical_ratio_at(a))),
    }
}

/// The tangency ratio, but −1 where g' = 0 on all of a cell and folds are where g' = 0: a flat is neutral there, and surfaces touch without
/// holding.
fn holding<R: Real>(contact: &Contact<R>, ratio: R) -> R {
    if ratio == ratio.lit(0) && folds_where_level(contact) { ratio.lit(-1) } else { ratio }
}

/// Whether folds are where g' = 0: at an edge without adhesion, and on a Winkler foundation at fixed grips, where Δl is constant.
pub(super) fn folds_where_level<R: Real>(contact: &Contact<R>) -> bool {
    let like = contact.modulus();
    contact.critical_ratio_at(&like.lit(1)) == like.lit(0)
}

/// The sign of the condition at all radii of a cell, from bounds of g'.
pub(super) fn sign<R: Real>(contact: &Contact<R>, cell: &R, slopes: &Slopes<R>) -> Option<Ordering> {
    let threshold = contact.critical_ratio_at(cell);
    let ratio = |slope: &R| contact.tangency_of(slope.clone(), cell);
    let holding = |greatest: &R| holding(contact, ratio(greatest));
    if slopes.greatest.as_ref().is_some_and(|greatest| holding(greatest) < threshold) {
        Some(Ordering::Less)
    } else if slopes.least.as_ref().is_some_and(|least| ratio(least) > threshold) {
        Some(Ordering::Greater)
    } else {
        None
    }
}

/// The signs of the condition below a kink and above it, at all radii of a cell around it.
pub(super) fn signs<R: Real>(contact: &Contact<R>, around: &R, kink: &Kink<R>) -> [Option<Ordering>; 2] {
    [&kink.inside, &kink.outside].map(|slopes| sign(contact, around, slopes))
}

/// The behaviour of a function on a cell, from its enclosure with a slope, either direct or in the mean-value form
/// f(m) + f'(cell)(cell − m).
pub(super) fn behaviour<I: Ends>(
    over_cell: Option<Dual<I>>,
    cell: &I,
    at: impl FnOnce(&I) -> Result<Option<I>>,
) -> Result<Behaviour> {
    let Some(Dual { value, slope }) = over_cell else { return Ok(Behaviour::Unknown) };
    if !value.has_zero() {
        return Ok(Behaviour::Nonzero);
    }
    if !slope.is_finite() {
        return Ok(Behaviour::Unknown);
    }
    // Before another evaluation: what is monotone needs none.
    if !slope.has_zero() {
        return Ok(Behaviour::Monotone);
    }
    let centre = cell.midpoint();
    let mean_value = at(&centre)?.map(|value| value + slope * (cell.clone() - &centre));
    Ok(if mean_value.is_some_and(|value| !value.has_zero()) { Behaviour::Nonzero } else { Behaviour::Unknown })
}

/// A contact over intervals of doubles, and over such intervals with derivatives: they decide most signs, and what happens on most cells,
/// as well as many bits do, and cost less.
///
/// ```
/// use std::sync::Arc;
/// use mdr_core::contact::{Control, Material};
/// use mdr_core::number::{Precision, Special};
/// use mdr_numeric::{contact::Contact, proof::{CurveInDoubles, EnclosedCurve}, table::Table};
/// use rug::Float;
/// // Rows of a paraboloid with R = 1 m, E* = 1 Pa and w = 0.1 N/m, under a dead load.
/// fn contact<R: Special>(ctx: R::Ctx) -> Result<Contact<R>, Box<dyn std::error::Error>> {
///     let tip = Table::from_csv("r,f\n0,0\n1,0.5\n2,2\n3,4.5\n".as_bytes())?.profile::<R>(ctx)?;
///     let material = Material::new(R::from_int(ctx, 1), R::from_int(ctx, 1).over(10))?;
///     Ok(Contact::half_space(&Arc::new(tip), &material, &Control::Force))
/// }
/// let (bits, in_doubles) = (Precision::new(64), CurveInDoubles::new(contact(())?, contact(())?));
/// let curve = EnclosedCurve::new(contact(bits)?, contact(bits)?).with_doubles(Some(in_doubles));
/// let proved = curve.folds(&Float::with_val(64, 0.01), &Float::with_val(64, 2.9), 1000)?;
/// // The pull-off of JKR: F = −3πwR/2.
/// assert!(proved.is_complete() && proved.folds.len() == 1);
/// let force = proved.folds[0].force.mid().to_f64();
/// assert!((force / (-0.15 * std::f64::consts::PI) - 1.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct CurveInDoubles {
    plain: Contact<DoubleInterval>,
    dual: Contact<Dual<DoubleInterval>>,
}

impl CurveInDoubles {
    /// A contact in two arithmetics, whose numbers enclose those of the [curve](super::EnclosedCurve) that it helps.
    pub fn new(plain: Contact<DoubleInterval>, dual: Contact<Dual<DoubleInterval>>) -> Self {
        CurveInDoubles { plain, dual }
    }

    /// The contact over intervals of doubles.
    pub(super) fn plain(&self) -> &Contact<DoubleInterval> {
        &self.plain
    }

    /// The curve under another control.
    #[must_use]
    pub fn under(&self, control: &Control<Literal>) -> Self {
        let plain = self.plain.with_control(control.map(|stiffness| DoubleInterval::from_literal((), stiffness)));
        let dual = self.dual.with_control(control.map(|stiffness| Dual::from_literal((), stiffness)));
        CurveInDoubles { plain, dual }
    }

    fn with_slope(&self, a: DoubleInterval) -> Result<Option<Dual<DoubleInterval>>> {
        within_range(condition(&self.dual, &Dual::variable(a)))
    }

    /// The condition at a radius, if its sign is certain.
    pub(super) fn signed_condition(&self, a: &Interval) -> Result<Option<Interval>> {
        let condition = within_range(condition(&self.plain, &DoubleInterval::around(a)))?;
        Ok(condition.filter(|value| !value.has_zero()).map(|value| value.widened(a.ctx())))
    }

    /// The behaviour on a cell; `None` where more bits may tell more.
    pub(super) fn behaviour(&self, cell: &Interval) -> Result<Option<Behaviour>> {
        let cell_in_doubles = DoubleInterval::around(cell);
        let over_cell = self.with_slope(cell_in_doubles)?;
        let at = |centre: &DoubleInterval| within_range(condition(&self.plain, centre));
        // Where doubles leave their range nothing is said of the cell.
        let is_wide = cell.accuracy_bits() < WIDE && over_cell.as_ref().is_some_and(|over| over.value.is_finite());
        let known = behaviour(over_cell, &cell_in_doubles, at)?;
        Ok((known != Behaviour::Unknown || is_wide).then_some(known))
    }

    /// The signs of the condition below a kink and above it, up to a relative distance 2^−margin; `None` if nothing is known of the kink.
    pub(super) fn signs_beside_kink(
        &self,
        index: usize,
        around: &Interval,
        margin: u32,
    ) -> Result<Option<[Option<Ordering>; 2]>> {
        let kink = within_range(self.plain.transform().kink(index, &share(self.plain.modulus(), margin)))?;
        Ok(kink.map(|kink| signs(&self.plain, &DoubleInterval::around(around), &kink)))
    }

    /// A place near the zero in a cell where the condition is monotone, by Newton's method from its middle; `None` where that leads
    /// out of the cell.
    pub(super) fn approached(&self, cell: &Interval) -> Result<Option<f64>> {
        let around = DoubleInterval::around(cell);
        let mut place = around.approx();
        for _ in 0..STEPS {
            let Some(at) = self.with_slope(DoubleInterval::point(place))? else { return Ok(None) };
            let step = (at.value / at.slope).approx();
            place -= step;
            if !(around.lower() < place && place < around.upper()) {
                return Ok(None);
            }
            if step.abs() <= LAST * place {
                break;
            }
        }
        Ok(Some(place))
    }
}

/// What doubles know: nothing where they leave their range, or where the profile does not reach.
fn within_range<T>(result: Result<Option<T>>) -> Result<Option<T>> {
    match result {
        Err(error) if error.is_interruption() => Err(error),
        result => Ok(result.ok().flatten()),
    }
}

#[cfg(test)]
#[path = "../../tests/private/condition.rs"]
mod tests;
