//! The limit of admissibility in any arithmetic: an f64 search locates it, two conditions on the gap determine it.

use mdr_core::contact::{Equilibrium, Error, Quantity, Result, Shape, Stability};
#[cfg(feature = "mp")]
use mdr_core::number::{Interval, Precision};
use mdr_core::number::{Literal, Real, order};

use super::extrema::Terrain;
use super::{Admissibility, FirstTouch, HeightSource, gap};
use crate::contact::Contact;

/// A circle outside the contact on which the surfaces touch or interpenetrate.
#[derive(Clone, Debug, PartialEq)]
pub struct Ring<R> {
    /// The radius of the ring, in m.
    pub radius: R,
    /// The gap at this radius, in m: 0 where the surfaces touch.
    pub gap: R,
}

/// The first contact of separated surfaces, if it is not at the tip.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Touch<R> {
    /// The radius of the ring, in m.
    pub radius: R,
    /// min f < 0, the indentation depth at which they touch, in m.
    pub indentation: R,
}

/// The most steps of an iteration that gains about six digits per step.
const STEPS: usize = 200;
/// The relative distance from a kink below which the narrowest gap is taken to be at the kink.
const AT_KINK: f64 = 1e-6;

/// The first contact of separated surfaces; `None` at the tip, when f ≥ 0 everywhere.
///
/// ```
/// use mdr_core::contact::{Control, Material};
/// use mdr_numeric::admissible::{Admissibility, first_touch};
/// use mdr_numeric::{contact::Contact, table::MeasuredProfile};
/// use std::sync::Arc;
/// // A tip with a particle beside it, 5 nm further out than the tip.
/// let rows = [(0.0, 0.0), (2e-8, 1e-8), (4e-8, 1e-8), (6e-8, -5e-9), (8e-8, 3e-8), (1e-7, 6e-8)];
/// let tip = Arc::new(MeasuredProfile::new(rows.to_vec())?);
/// let (material, control) = (Material::new(1e9, 0.01)?, Control::Indentation);
/// let curve = Contact::half_space(&tip, &material, &control);
/// let touch = first_touch(&curve, &Admissibility::new(tip.clone(), [1e-11, 1e-7]))?.expect("on a ring");
/// assert!((touch.indentation + 5e-9).abs() < 1e-22 && (touch.radius - 6e-8).abs() < 1e-16);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// Errors of the transform and of the quadrature; [`Error::Undecided`] if enclosures of a formula do not decide where the
/// surfaces first touch.
pub fn first_touch<R: Real>(curve: &Contact<R>, admissibility: &Admissibility) -> Result<Option<Touch<R>>> {
    require_known(admissibility, curve.modulus())?;
    if let Some(touch) = admissibility.first_touch_by_form() {
        return by_form(touch, curve.modulus());
    }
    let Some(terrain) = &admissibility.terrain else { return Ok(None) };
    let Some([radius, _]) = first_touch_roughly(admissibility)? else { return Ok(None) };
    let ring = Locus::new(curve, terrain, 0.0, radius);
    let zero = curve.modulus().lit(0);
    let radius = ring.lowest()?;
    let indentation = ring.gap(&zero, &zero, &radius)?;
    Ok((indentation < zero).then_some(Touch { radius, indentation }))
}

/// Refuses to say where surfaces first touch where that is not searched.
fn require_known<R: Real>(admissibility: &Admissibility, like: &R) -> Result<()> {
    if admissibility.unknown.is_some() && matches!(admissibility.touch, None | Some(FirstTouch::Open { .. })) {
        let what = "where the surfaces first touch: it is not searched on this medium; begin in contact";
        return Err(Error::undecided(Quantity::Indentation, like, what));
    }
    Ok(())
}

/// The first contact of a formula, or of a shape that is lowest on a ring, in the arithmetic of a number.
fn by_form<R: Real>(touch: &FirstTouch, like: &R) -> Result<Option<Touch<R>>> {
    match touch {
        FirstTouch::Tip => Ok(None),
        #[cfg(feature = "mp")]
        FirstTouch::Ring(ring) => {
            let [radius, indentation] = ring.at::<R>(like.ctx());
            Ok(Some(Touch { radius, indentation }))
        }
        FirstTouch::OfShape(shape) => Ok(on_ring_of(shape, like.ctx())),
        FirstTouch::Open { heights, .. } => {
            let what = match heights {
                HeightSource::Formula => {
                    "where the surfaces first touch: enclosures of the formula do not tell its lowest point"
                }
                HeightSource::Function => "where the surfaces first touch: the lowest point of a function is not known",
            };
            Err(Error::undecided(Quantity::Indentation, like, what))
        }
    }
}

/// The first contact on the ring on which a shape is lowest.
fn on_ring_of<R: Real>(shape: &Shape<Literal>, ctx: R::Ctx) -> Option<Touch<R>> {
    let [radius, indentation] = shape.map(|_, length| R::from_literal(ctx, length)).lowest_ring()?;
    Some(Touch { radius, indentation })
}

/// The radius and the height at which f < 0 is smallest, in double precision; `None` if f ≥ 0.
///
/// # Errors
/// Errors of the transform; [`Error::Undecided`] if enclosures of a formula do not decide where the surfaces first touch.
pub(crate) fn first_touch_roughly(admissibility: &Admissibility) -> Result<Option<[f64; 2]>> {
    require_known(admissibility, &0.0)?;
    if let Some(touch) = admissibility.first_touch_by_form() {
        return Ok(by_form(touch, &0.0)?.map(|touch| [touch.radius, touch.indentation]));
    }
    let Some(terrain) = &admissibility.terrain else { return Ok(None) };
    let lowest = terrain.narrowest(0.0, 0.0, false)?;
    Ok(lowest.filter(|(_, height)| *height < 0.0).map(|(radius, height)| [radius, height]))
}

/// The last admissible state on the stable branch between two contact radii, of which the larger is not admissible, and the ring
/// on which the surfaces touch there; `None` if they also interpenetrate at the smaller radius.
///
/// # Errors
/// Errors of the transform and of the quadrature; [`Error::NoConvergence`] if the iteration does not converge.
pub fn last_admissible<R: Real>(
    curve: &Contact<R>,
    admissibility: &Admissibility,
    [from, to]: [&R; 2],
) -> Result<Option<(Equilibrium<R>, Ring<R>)>> {
    let Some(terrain) = &admissibility.terrain else { return Ok(None) };
    let Some([upper, rough]) = lost_roughly(curve, admissibility, [from.approx(), to.approx()], 1e-8)? else {
        return Ok(None);
    };
    let (medium, work) = (curve.medium().of_unit_modulus(), curve.material_length().approx());
    let indentation = |a: f64| Ok(terrain.transform.g(&a)? - medium.elongation(&work, &a));
    let locus = Locus::new(curve, terrain, upper, rough);
    let (a, radius) = locus.loss(upper, &indentation)?;
    let (indentation, force) = curve.state(&a)?;
    let gap = a.lit(0);
    let state = Equilibrium { contact_radius: a, indentation, force, stability: Stability::Stable };
    Ok(Some((state, Ring { radius, gap })))
}

/// In doubles and to a relative tolerance, the contact radius between two at which admissibility is lost, and the radius of the
/// ring; `None` if the surfaces overlap at the smaller one already, or not at the larger one.
///
/// # Errors
/// Errors of the transform and of the quadrature.
pub(crate) fn lost_roughly<R: Real>(
    curve: &Contact<R>,
    admissibility: &Admissibility,
    [mut lower, mut upper]: [f64; 2],
    tolerance: f64,
) -> Result<Option<[f64; 2]>> {
    let Some(terrain) = &admissibility.terrain else { return Ok(None) };
    let (medium, work) = (curve.medium().of_unit_modulus(), curve.material_length().approx());
    let narrowest = |a: f64| terrain.narrowest(a, terrain.transform.g(&a)? - medium.elongation(&work, &a), false);
    let Some(mut ring) = narrowest(upper)?.filter(|ring| ring.1 < 0.0) else { return Ok(None) };
    let first = if lower > 0.0 { narrowest(lower)? } else { None };
    if first.is_some_and(|ring| ring.1 < 0.0) {
        return Ok(None);
    }
    // The gaps at both ends; that of an end which stays is halved (Illinois), so that the other one moves, too.
    let mut gaps = [first.map(|(_, gap)| gap), Some(ring.1)];
    let mut moved = None;
    while upper - lower > tolerance * upper {
        let middle = match gaps {
            [Some(open), Some(closed)] => {
                let share = open / (open - closed);
                lower + (upper - lower) * share.clamp(0.01, 0.99)
            }
            _ if upper > 2.0 * lower && lower > 0.0 => (lower * upper).sqrt(),
            _ => (lower + upper) / 2.0,
        };
        if !(middle > lower && middle < upper) {
            break;
        }
        let found = narrowest(middle)?;
        let side = usize::from(found.is_some_and(|ring| ring.1 < 0.0));
        match found {
            Some(nearer) if side == 1 => (upper, ring) = (middle, nearer),
            _ => lower = middle,
        }
        gaps[side] = found.map(|(_, gap)| gap);
        if moved == Some(side) {
            gaps[1 - side] = gaps[1 - side].map(|gap| gap / 2.0);
        }
        moved = Some(side);
    }
    Ok(Some([upper, ring.0]))
}

/// The first contact on a ring, as an enclosure; `None` where it is not on one ring that is proved.
#[cfg(feature = "mp")]
pub(crate) fn proved_touch(admissibility: &Admissibility, precision: Precision) -> Option<Touch<Interval>> {
    match admissibility.first_touch_by_form()? {
        FirstTouch::Ring(ring) => {
            let [radius, indentation] = ring.enclosed(precision);
            Some(Touch { radius, indentation })
        }
        FirstTouch::OfShape(shape) => on_ring_of(shape, precision),
        FirstTouch::Tip | FirstTouch::Open { .. } => None,
    }
}

/// The narrowest gap near a radius, in two arithmetics.
struct Locus<'a, R: Real> {
    curve: &'a Contact<R>,
    terrain: &'a Terrain,
    /// The radius of the ring in double precision.
    rough: f64,
    /// The kink or the end of the profile at which the ring is, if it is at one.
    fixed: Option<R>,
    breaks: Vec<R>,
}

impl<'a, R: Real> Locus<'a, R> {
    fn new(curve: &'a Contact<R>, terrain: &'a Terrain, a: f64, rough: f64) -> Self {
        let like = curve.modulus();
        let transform = curve.transform();
        let mut breaks = transform.kinks();
        let known: Vec<f64> = breaks.iter().map(R::approx).collect();
        let near = |x: f64, y: f64| (x - y).abs() <= 1e-9 * y;
        let smooth = terrain.edges.iter().map(|edge| edge.x).filter(|x| *x > a && !known.iter().any(|k| near(*x, *k)));
        breaks.extend(smooth.map(|x| R::from_f64(like.ctx(), x)));
        breaks.sort_by(order);
        let ends = transform.kinks().into_iter().chain(transform.outer_radius());
        let mut fixed = ends.filter(|end| (end.approx() - rough).abs() <= AT_KINK * rough);
        Locus { curve, terrain, rough, fixed: fixed.next(), breaks }
    }

    fn gap(&self, a: &R, d: &R, r: &R) -> Result<R> {
        Ok(gap::gap(self.curve.transform(), a, d, r, &self.breaks)?.value)
    }

    fn number(&self, x: f64) -> R {
        R::from_f64(self.curve.modulus().ctx(), x)
    }

    /// The second derivative of the gap at the ring, in double precision.
    fn bend(&self, a: f64, d: f64) -> Result<f64> {
        let (r, step) = (self.rough, 1e-4 * (self.rough - a));
        let slope = |r: f64| {
            let breaks: Vec<f64> = self.breaks.iter().map(R::approx).collect();
            gap::slope(&*self.terrain.transform, &a, &d, &r, &breaks)
        };
        Ok((slope(r + step)? - slope(r - step)?) / (2.0 * step))
    }

    /// The radius of the narrowest gap of states: Newton's iteration for h' = 0, with h'' in double precision,
    /// alternating with `advance`, which returns the next state (a, d), if the state changes at all.
    fn settle(
        &self,
        mut state: [R; 2],
        bend: impl FnOnce() -> Result<f64>,
        advance: impl Fn(&R, &R, &R) -> Result<Option<(R, R)>>,
    ) -> Result<(R, R)> {
        let mut radius = self.fixed.clone().unwrap_or_else(|| self.number(self.rough));
        let bend = if self.fixed.is_none() { Some(bend()?).filter(|bend| *bend > 0.0) } else { None };
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let [a, d] = &state;
            let mut size = 0.0;
            if let Some(bend) = bend {
                let step = gap::slope(self.curve.transform(), a, d, &radius, &self.breaks)? / self.number(bend);
                // h is stationary at the ring, so its radius is needed to half the digits only.
                size = (step.clone() / &radius).abs().approx();
                size = if size <= radius.unit_roundoff().sqrt().approx() { 0.0 } else { size };
                radius -= &step;
            }
            if let Some((next, d)) = advance(a, d, &radius)? {
                size = f64::max(size, (next.clone() / a - a.lit(1)).abs().approx());
                state = [next, d];
            }
            let roundoff = radius.unit_roundoff().approx();
            if size <= 4.0 * roundoff || size >= 0.25 * last && size <= roundoff.sqrt() {
                let [a, _] = state;
                return Ok((a, radius));
            }
            last = size;
        }
        Err(open(last))
    }

    /// The radius at which f is smallest.
    fn lowest(&self) -> Result<R> {
        let zero = self.number(0.0);
        let bend = || self.bend(0.0, 0.0);
        Ok(self.settle([zero.clone(), zero], bend, |_, _, _| Ok(None))?.1)
    }

    /// The contact radius at which the narrowest gap of the equilibrium is zero, and the radius of that gap.
    fn loss(&self, a: f64, indentation: &dyn Fn(f64) -> Result<f64>) -> Result<(R, R)> {
        let breaks: Vec<f64> = self.breaks.iter().map(R::approx).collect();
        let rough = |a: f64| Ok(gap::gap(&*self.terrain.transform, &a, &indentation(a)?, &self.rough, &breaks)?.value);
        let start = self.number(a);
        let d = self.curve.indentation(&start)?;
        // Of a table that scatters from row to row the slope changes within a wide step.
        let mut unsettled = open(1.0);
        for width in [1e-5, 1e-7, 1e-9] {
            let step = width * a;
            let fall: f64 = (rough(a + step)? - rough(a - step)?) / (2.0 * step);
            if !(fall < 0.0) {
                continue;
            }
            let bend = || self.bend(a, indentation(a)?);
            let settled = self.settle([start.clone(), d.clone()], bend, |a, d, radius| {
                let next = a.clone() - self.gap(a, d, radius)? / self.number(fall);
                let d = self.curve.indentation(&next)?;
                Ok(Some((next, d)))
            });
            match settled {
                Err(error @ Error::NoConvergence { .. }) => unsettled = error,
                settled => return settled,
            }
        }
        Err(unsettled)
    }
}

/// The iteration has not found where the surfaces meet: the relative change of the last step.
fn open(error: f64) -> Error {
    Error::NoConvergence { quantity: Quantity::ContactRadius, evaluations: STEPS, error }
}
