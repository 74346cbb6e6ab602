//! A transform that is kept beside the radii at which it is asked: by the polynomials through five neighbouring values.
//!
//! Differences of a fit ask for many radii that are all but the same. The remainder of a polynomial over a millionth of the radius is
//! about 10⁻³⁰ of the value, as small as the digits that a quadrature is asked for.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use mdr_core::contact::{Result, Transform};
use mdr_core::number::Real;
use rug::Float;

/// The nodes are so many steps from the middle.
const NODES: [i64; 5] = [-2, -1, 0, 1, 2];
/// A step is the radius over ten to this power.
const STEP: i64 = -6;

/// The values at five radii around one.
struct Patch {
    middle: Float,
    step: Float,
    /// g.
    values: Vec<Float>,
    /// g minus its mean.
    above_mean: Vec<Float>,
}

impl Patch {
    fn around<T: Transform<Float>>(transform: &T, middle: &Float) -> Result<Self> {
        let step = middle.lit(10).powi(STEP) * middle;
        let radii = NODES.map(|node| step.clone().times(node) + middle);
        let values = radii.iter().map(|x| transform.g(x)).collect::<Result<_>>()?;
        let above_mean = radii.iter().map(|x| transform.above_mean(x)).collect::<Result<_>>()?;
        Ok(Patch { middle: middle.clone(), step, values, above_mean })
    }

    /// The distance from the middle in steps, if it is among the nodes.
    fn place(&self, x: &Float) -> Option<Float> {
        let place = (x.clone() - &self.middle) / &self.step;
        (Real::abs(&place) <= place.lit(2)).then_some(place)
    }
}

/// The polynomial through values at the nodes, by Lagrange.
fn through(values: &[Float], place: &Float) -> Float {
    let others = |node: i64| NODES.into_iter().filter(move |other| *other != node);
    let share = |node: i64| {
        others(node).fold(place.lit(1), |share, other| (share * (place.clone() - place.lit(other))).over(node - other))
    };
    NODES.into_iter().zip(values).fold(place.lit(0), |sum, (node, value)| sum + share(node) * value)
}

/// A transform with the patches that were made so far, by the nearest doubles of their middles.
pub(crate) struct Patches<T> {
    inner: T,
    patches: Mutex<BTreeMap<u64, Patch>>,
}

impl<T: Transform<Float>> Patches<T> {
    pub(crate) fn new(inner: T) -> Self {
        Patches { inner, patches: Mutex::default() }
    }

    /// A value at x: by the patch that holds it, which is made where there is none.
    fn at(&self, x: &Float, of: impl Fn(&Patch) -> &[Float]) -> Result<Float> {
        let key = x.approx().to_bits();
        let mut patches = self.patches.lock().unwrap_or_else(PoisonError::into_inner);
        let neighbours = [patches.range(..=key).next_back(), patches.range(key..).next()];
        let held = |(_, patch): (&u64, &Patch)| Some(through(of(patch), &patch.place(x)?));
        if let Some(value) = neighbours.into_iter().flatten().find_map(held) {
            return Ok(value);
        }
        let patch = Patch::around(&self.inner, x)?;
        let value = through(of(&patch), &x.lit(0));
        patches.insert(key, patch);
        Ok(value)
    }
}

impl<T: Transform<Float>> Transform<Float> for Patches<T> {
    fn g(&self, x: &Float) -> Result<Float> {
        self.at(x, |patch| &patch.values)
    }

    fn slope(&self, x: &Float) -> Result<Float> {
        self.inner.slope(x)
    }

    fn integral(&self, x: &Float) -> Result<Float> {
        self.inner.integral(x)
    }

    fn above_mean(&self, x: &Float) -> Result<Float> {
        self.at(x, |patch| &patch.above_mean)
    }
}

#[cfg(test)]
mod tests {
    use mdr::prelude::Shape;
    use mdr_core::number::Precision;
    use mdr_numeric::transform::Quadrature;

    use super::*;

    /// Beside a radius values are those of the quadrature itself, and farther away a second patch is made.
    #[test]
    fn what_is_kept_is_what_the_quadrature_gives() -> Result<()> {
        let number = |text: &str| Float::with_val(110, Float::parse(text).expect("a number"));
        let ctx = Precision::new(110);
        for shape in [
            Shape::Sphere { radius: number("1e-5") },
            Shape::Power { n: number("1.7"), c: Float::from_int(ctx, 3) },
            Shape::Paraboloid { radius: number("2e-6") },
        ] {
            let of = || Quadrature::of([shape.clone()]);
            let (kept, exact) = (Patches::new(of()?), of()?);
            let middle = number("3e-6");
            for offset in ["0", "1e-6", "-1.3e-8", "1.9e-6", "-1.99e-6", "1e-3"] {
                let x = (number(offset) + middle.lit(1)) * &middle;
                for (one, other) in [(kept.g(&x)?, exact.g(&x)?), (kept.above_mean(&x)?, exact.above_mean(&x)?)] {
                    let error = ((one - &other) / other).approx().abs();
                    assert!(error < 1e-28, "{shape:?} {offset}: {error:e}");
                }
            }
            assert_eq!(kept.patches.lock().expect("not poisoned").len(), 2, "{shape:?}");
        }
        Ok(())
    }
}
