//! The output `transform`: g, g' and ∫g of the profile at radii.

use mdr_core::contact::Result;
#[cfg(feature = "mp")]
use mdr_core::contact::Status;
use mdr_core::number::Literal;
#[cfg(feature = "mp")]
use mdr_core::number::{Interval, certify::Enclosure};

use super::key::Key;
use super::room::{Facts, Open, Request, Room as IsRoom, Subject, not_wanted};
use super::{Output, Want};
#[cfg(feature = "mp")]
use crate::answer::Number;
#[cfg(feature = "mp")]
use crate::answer::record::Numbers;
use crate::answer::record::record;
use crate::answer::{List, Promise, Value};
#[cfg(feature = "mp")]
use crate::solve::certified::Certified;
use crate::solve::model::{Model, SceneReal};
use crate::solve::search::{self, Search};

record! {
    /// The transformed profile at a radius.
    TransformSample {
        /// The radius x.
        x: Literal = "x" in "m",
        /// g(x).
        g: Value<N> = "g" in "m",
        /// g'(x).
        slope: Value<N> = "slope g'(a)" in "",
        /// ∫₀ˣ g, in m².
        integral: Value<N> = "integral" in "m²",
    }
}

pub(super) const FACTS: Facts = Facts {
    of: Subject::Profile,
    key: Some(Key::Radii(|value, unit| value.positive(unit))),
    question: |keys, kind| Want::Transform { at: keys.radii(kind) },
    unused: not_wanted,
};

pub(super) struct Room<'w> {
    pub(super) at: &'w [Literal],
}

impl<'w> Request<'w> for Room<'w> {
    fn rows(&self) -> usize {
        self.at.len()
    }

    fn missing(&self) -> Option<&'static str> {
        self.at.is_empty().then_some("radii: [output.transform] at = [\"…\"]")
    }
}

impl<'w> IsRoom<'w> for Room<'w> {
    /// Proved where g has enclosures.
    #[cfg(feature = "mp")]
    fn proved(&self, certified: &Certified<'_>) -> Result<Option<Output>> {
        if !certified.scene.encloses_at(self.at) {
            return Ok(None);
        }
        let items = certified.proved(|precision| {
            Ok(samples(&certified.model::<Interval>(precision)?, self.at)?.convert(Enclosure::from))
        })?;
        Ok(items.map(|items| Output::Transform(List::new(Promise::Certified, items))))
    }

    fn searched(&self, search: &Search<'_>) -> Result<Output> {
        Ok(Output::Transform(search::list(samples(&search.model, self.at)?)))
    }

    /// Zeros beside numbers that are none, and numbers below the smallest normal double. A sample of zeros is a flat face.
    #[cfg(feature = "mp")]
    fn lost_numbers(&self, output: &Output) -> bool {
        let Output::Transform(list) = output else { return false };
        let lost = |sample: &TransformSample| {
            let values = [&sample.g, &sample.slope, &sample.integral];
            let known: Vec<f64> = values.iter().filter_map(|value| value.number().map(Number::to_f64)).collect();
            let small = known.iter().filter(|x| x.abs() < f64::MIN_POSITIVE).count();
            let unknown_magnitude = |value: &&Value| value.log10().is_some_and(|log10| !log10.is_finite());
            small > 0 && small < known.len() || values.iter().any(unknown_magnitude)
        };
        list.items.iter().any(lost)
    }

    #[cfg(feature = "mp")]
    fn has_open_numbers(&self, output: &Output) -> bool {
        let Output::Transform(list) = output else { return false };
        let is_open = |value: &Value| value.status() == Status::Undecided;
        list.items.iter().any(|sample| [&sample.g, &sample.slope, &sample.integral].into_iter().any(is_open))
    }

    fn undecided(&self, open: &Open<'_>) -> Output {
        let sample = |x: &Literal| TransformSample {
            x: x.clone(),
            g: open.value(),
            slope: open.value(),
            integral: open.value(),
        };
        Output::Transform(List::new(Promise::F64, self.at.iter().map(sample).collect()))
    }
}

/// g, g' and ∫₀ˣ g at the radii x.
fn samples<R: SceneReal>(model: &Model<R>, radii: &[Literal]) -> Result<Vec<TransformSample<R>>> {
    let transform = model.transform();
    let at = |literal: &Literal| {
        let x = model.number(literal);
        Ok(TransformSample {
            x: literal.clone(),
            g: Value::from_result(transform.g(&x))?,
            slope: Value::from_result(transform.slope(&x))?,
            integral: Value::from_result(transform.integral(&x))?,
        })
    };
    radii.iter().map(at).collect()
}
