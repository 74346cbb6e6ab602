//! The output `curve`: the equilibria with given contact radii.

use std::cmp::Ordering;

use mdr_core::contact::{Edge, Error, Quantity, Result, Stability};
use mdr_core::number::Literal;
#[cfg(feature = "mp")]
use mdr_core::number::{Interval, certify::Enclosure};
use mdr_numeric::admissible::Admissibility;

use super::key::Key;
use super::room::{Facts, Open, Request, Room as IsRoom, Subject, not_wanted};
use super::{Output, Want};
#[cfg(feature = "mp")]
use crate::answer::record::Numbers;
use crate::answer::record::{constant_parts, record};
use crate::answer::{Admission, Cell, List, Promise, Value};
#[cfg(feature = "mp")]
use crate::solve::certified::Certified;
use crate::solve::model::{Model, SceneReal};
use crate::solve::sample;
use crate::solve::search::{self, Search};
use crate::solve::verdict;

/// The stability of a state on the curve, or the reason why it is not decided.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveStability(pub Value<Stability>);

constant_parts! {
    CurveStability as "stable": |stability, key, row| match &stability.0 {
        Value::Known(stability) => stability.put(key, row),
        unknown => row.cells.push(("stable", Cell::UnknownStability(unknown))),
    };
}

record! {
    /// The equilibrium with a given contact radius.
    CurvePoint {
        /// a.
        contact_radius: Literal = "contact radius" in "m",
        /// d = g(a) − Δl(a).
        indentation: Value<N> = "indentation" in "m",
        /// F.
        force: Value<N> = "force" in "N",
        /// Neutral at a fold.
        stability: CurveStability,
        /// Whether the state is admissible; `None` if it has no indentation depth.
        admissible: Option<Admission<N>>,
        /// With two works of adhesion, the edge that is in equilibrium.
        edge: Option<Edge>,
    }
}

pub(super) const FACTS: Facts = Facts {
    of: Subject::Contact,
    key: Some(Key::Radii(|value, unit| value.positive(unit))),
    question: |keys, kind| Want::Curve { at: keys.radii(kind) },
    unused: not_wanted,
};

pub(super) struct Room<'w> {
    pub(super) at: &'w [Literal],
}

impl Room<'_> {
    /// The radii of the question; without any, radii around the folds that a search finds.
    fn radii<'s>(&self, search: impl FnOnce() -> Result<&'s Search<'s>>) -> Result<Vec<Literal>> {
        if !self.at.is_empty() {
            return Ok(self.at.to_vec());
        }
        let search = search()?;
        sample::radii(&search.model, search.folds()?)
    }
}

impl<'w> Request<'w> for Room<'w> {
    fn rows(&self) -> usize {
        self.at.len()
    }
}

impl<'w> IsRoom<'w> for Room<'w> {
    /// Proved where g has enclosures.
    #[cfg(feature = "mp")]
    fn proved(&self, certified: &Certified<'_>) -> Result<Option<Output>> {
        if !certified.scene.has_proofs() {
            return Ok(None);
        }
        let radii = self.radii(|| certified.search())?;
        if !certified.scene.encloses_at(&radii) {
            return Ok(None);
        }
        let items = certified.proved(|precision| {
            let model = certified.model::<Interval>(precision)?;
            Ok(points(&model, &radii, &*certified.admissibility()?)?.convert(Enclosure::from))
        })?;
        Ok(items.map(|items| Output::Curve(List::new(Promise::Certified, items))))
    }

    fn searched(&self, search: &Search<'_>) -> Result<Output> {
        let radii = self.radii(|| Ok(search))?;
        Ok(Output::Curve(search::list(points(&search.model, &radii, &search.admissibility())?)))
    }

    /// The curve of an advancing edge, then that of a receding one: at a radius the states between the two are pinned.
    fn of_edges(&self, outputs: [Output; 2]) -> Option<Output> {
        let [Output::Curve(advancing), Output::Curve(receding)] = outputs else { return None };
        let of = |edge: Edge| move |point: CurvePoint| CurvePoint { edge: Some(edge), ..point };
        Some(Output::Curve(advancing.map(of(Edge::Advancing)).and(receding.map(of(Edge::Receding)))))
    }

    fn undecided(&self, open: &Open<'_>) -> Output {
        let point = |a: &Literal| CurvePoint {
            contact_radius: a.clone(),
            indentation: open.value(),
            force: open.value(),
            stability: CurveStability(open.value()),
            admissible: None,
            edge: None,
        };
        Output::Curve(List::new(Promise::F64, self.at.iter().map(point).collect()).complete(open.completeness()))
    }
}

/// The equilibria with the given contact radii.
///
/// # Errors
/// Errors that concern the whole computation, not one value.
fn points<R: SceneReal>(
    model: &Model<R>,
    radii: &[Literal],
    admissibility: &Admissibility,
) -> Result<Vec<CurvePoint<R>>> {
    let curve = model.contact();
    let at = |literal: &Literal| {
        let a = model.size(literal)?;
        let (indentation, force) = match curve.state(&a) {
            Ok((indentation, force)) => (Ok(indentation), Ok(force)),
            Err(error) => (curve.indentation(&a), Err(error)),
        };
        let stability = curve.tangency(&a).and_then(|ratio| Ok(ratio.partial_cmp(&curve.critical_ratio(&a)?)));
        let stability = match stability {
            Ok(Some(Ordering::Greater)) => Value::Known(Stability::Stable),
            Ok(Some(Ordering::Less)) => Value::Known(Stability::Unstable),
            Ok(Some(Ordering::Equal)) => Value::Known(Stability::Neutral),
            Ok(None) => {
                let what = "whether the equilibrium is stable";
                return Err(Error::undecided(Quantity::ContactRadius, &a, what));
            }
            Err(error) => Value::from_result(Err(error))?,
        };
        let verdict = indentation.as_ref().ok().map(|d| verdict(admissibility, &a, d));
        Ok(CurvePoint {
            contact_radius: literal.clone(),
            indentation: model.depth(Value::from_result(indentation)?),
            force: Value::from_result(force)?,
            stability: CurveStability(stability),
            admissible: verdict.map(Admission::of),
            edge: None,
        })
    };
    radii.iter().map(at).collect()
}
