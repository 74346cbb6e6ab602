//! Line contacts: the load N(b) without adhesion over E* as a transformed profile.

use mdr_core::contact::{Error, Kink, Quantity, Result, Slopes, Transform};
use mdr_core::number::Real;

use super::Powers;
use crate::medium::arcosh_ratio;

/// A profile f(|x|) on a half-plane, from N(b) = ∫₀ᵇ x f'(x)/√(b² − x²) dx, the force per length without adhesion over E* (K. L.
/// Johnson, Contact Mechanics, Cambridge 1985, chapter 4).
///
/// Without a reference d stands for F/E*, and g is N. Against a point of the surface at the distance L,
/// g' = (2/π) arcosh(L/b) N', and the mean is (2/π)∫₀ᵇ N(c)/(c√(1 − c²/L²)) dc.
///
/// ```
/// use mdr_core::contact::{Control, Transform};
/// use mdr_numeric::{contact::Contact, folds, medium::{Adhesion, Medium}, transform::{LineLoad, Powers}};
/// // A cylinder of radius 1 breaks under a dead load at −3(πE*w²R/16)^(1/3) per length.
/// let cylinder = LineLoad::of_powers(Powers::line([(2.0, 0.5)])?, None);
/// let contact = Contact::new(cylinder, Medium::plane(1.0, None)?, Adhesion::new(1e-2)?, Control::Force);
/// let pull_off = &folds::find(&contact)?[0];
/// assert!((pull_off.force / (-3.0 * (std::f64::consts::PI * 1e-4 / 16.0).cbrt()) - 1.0).abs() < 1e-13);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
pub struct LineLoad<R> {
    load: Load<R>,
    reference: Option<R>,
}

/// N(b).
enum Load<R> {
    Powers(Powers<R>),
    Other(Box<dyn Transform<R>>),
}

impl<R: Real> LineLoad<R> {
    /// From N of a sum of powers, and the distance of the reference.
    pub fn of_powers(load: Powers<R>, reference: Option<R>) -> Self {
        LineLoad { load: Load::Powers(load), reference }
    }

    /// From any N, as the g of a transform whose mean is that against the reference, (2/π)∫₀ᵇ N(c)/(c√(1 − c²/L²)) dc, and the
    /// distance of the reference.
    pub fn new(load: Box<dyn Transform<R>>, reference: Option<R>) -> Self {
        LineLoad { load: Load::Other(load), reference }
    }

    /// N(b).
    fn load(&self) -> &dyn Transform<R> {
        match &self.load {
            Load::Powers(powers) => powers,
            Load::Other(load) => load.as_ref(),
        }
    }

    /// (2/π) arcosh(L/b), the depth per force over E*; 1 without a reference.
    fn depth_per_force(&self, b: &R) -> Result<R> {
        match &self.reference {
            None => Ok(b.lit(1)),
            Some(reference) if b < reference => Ok((arcosh_ratio(reference, b) / b.pi()).times(2)),
            Some(_) => Err(Error::domain(Quantity::ContactRadius, b, "smaller than the distance of the reference")),
        }
    }
}

impl<R: Real> Transform<R> for LineLoad<R> {
    fn g(&self, b: &R) -> Result<R> {
        match &self.reference {
            None => self.load().g(b),
            Some(_) => Ok(self.above_mean(b)? + self.mean(b)?),
        }
    }

    fn slope(&self, b: &R) -> Result<R> {
        Ok(self.load().slope(b)? * self.depth_per_force(b)?)
    }

    /// x times the mean.
    fn integral(&self, b: &R) -> Result<R> {
        Ok(self.mean(b)? * b)
    }

    fn mean(&self, b: &R) -> Result<R> {
        let Some(reference) = &self.reference else { return Ok(b.lit(0)) };
        self.depth_per_force(b)?;
        let weighted = match &self.load {
            Load::Powers(powers) => (powers.against_reference(b, reference)? / b.pi()).times(2),
            Load::Other(load) => load.mean(b)?,
        };
        if !weighted.is_finite() {
            let requirement = "well below the distance of the reference, as this arithmetic needs it";
            return Err(Error::domain(Quantity::ContactRadius, b, requirement));
        }
        Ok(weighted)
    }

    fn g_within(&self, b: &R, needed: &R) -> Result<R> {
        match &self.reference {
            None => self.load().g_within(b, needed),
            Some(_) => self.g(b),
        }
    }

    fn above_mean(&self, b: &R) -> Result<R> {
        Ok(self.load().g(b)? * self.depth_per_force(b)?)
    }

    fn outer_radius(&self) -> Option<R> {
        let ends = [self.load().outer_radius(), self.reference.clone()];
        ends.into_iter().flatten().reduce(|one, other| one.lesser(&other))
    }

    fn vertical_edge(&self) -> bool {
        let outer_edge = self.load().outer_radius().filter(|_| self.load().vertical_edge());
        outer_edge.is_some_and(|outer_edge| self.reference.as_ref().is_none_or(|reference| outer_edge < *reference))
    }

    fn kinks(&self) -> Vec<R> {
        self.load().kinks()
    }

    fn rises(&self) -> bool {
        self.load().rises()
    }

    /// g' is N' times the depth per force, which falls with b.
    fn kink(&self, index: usize, margin: &R) -> Result<Option<Kink<R>>> {
        let Some(kink) = self.load().kink(index, margin)? else { return Ok(None) };
        if self.reference.is_none() {
            return Ok(Some(kink));
        }
        let place = self.load().kinks().into_iter().chain(self.load().outer_radius()).nth(index);
        let Some(b) = place else { return Ok(None) };
        let per_force = |end: R| self.depth_per_force(&(end * &b));
        let (Ok(near), Ok(here), Ok(far)) =
            (per_force(b.lit(1) - margin), per_force(b.lit(1)), per_force(margin.clone() + b.lit(1)))
        else {
            return Ok(None);
        };
        Ok(Some(Kink {
            value: kink.value.map(|(load, mean)| (load * &here + &mean, mean)),
            inside: scaled(kink.inside, [&here, &near]),
            outside: scaled(kink.outside, [&far, &here]),
        }))
    }

    fn work(&self) -> u64 {
        self.load().work()
    }
}

/// The bounds of a slope times a factor between two positive ends.
fn scaled<R: Real>(slopes: Slopes<R>, [low, high]: [&R; 2]) -> Slopes<R> {
    let times = |bound: R| [bound.clone() * low, bound * high];
    let least = |bound: R| {
        let [one, other] = times(bound);
        one.lesser(&other)
    };
    let greatest = |bound: R| {
        let [one, other] = times(bound);
        one.greater(&other)
    };
    Slopes { least: slopes.least.map(least), greatest: slopes.greatest.map(greatest) }
}
