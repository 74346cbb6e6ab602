//! The states of a path along a [`Curve`], each known by what it is, and sums of their stored energies.
//!
//! Energies that a path stores and loses are sums over its states, E = Σ mᵢ (Π + F²/2k)ᵢ with whole mᵢ. Terms of one state
//! cancel exactly, so that a closed path stores exactly 0, whatever the width of the enclosures.

use mdr_core::contact::{FoldKind, Result, Stability};
use mdr_core::number::Interval;
use mdr_core::number::certify::Enclosure;
use rug::Rational;

use super::curve::{CertifiedPoint, Curve};
use super::scaled::Scaled;

/// What a state on a path is, whatever encloses it.
#[derive(Clone, Debug, PartialEq)]
enum Place {
    OnBranch {
        branch: usize,
        value: Rational,
    },
    AtFold(usize),
    /// Where the contact comes to rest past a fold.
    PastFold(usize),
}

/// A state on a path along a [`Curve`].
#[derive(Clone, Debug)]
pub struct PathPoint {
    place: Place,
    point: CertifiedPoint,
}

impl PathPoint {
    /// Its numbers.
    pub fn point(&self) -> &CertifiedPoint {
        &self.point
    }
}

impl Curve {
    /// The state at fold `fold`; `None` beyond the last.
    pub fn at_fold(&self, fold: usize) -> Option<PathPoint> {
        let (point, _) = self.folds().get(fold)?;
        Some(PathPoint { place: Place::AtFold(fold), point: point.clone() })
    }

    /// The state at a value of the controlled quantity that has a stability, and a ln a within an interval: a fold where the value
    /// is that of the fold. `None` unless there is exactly one.
    ///
    /// # Errors
    /// [`Error::Undecided`](mdr_core::contact::Error::Undecided) if the precision does not decide which states there are.
    pub fn state_near(
        &self,
        value: &Rational,
        stability: Stability,
        ln_radius: &Interval,
    ) -> Result<Option<PathPoint>> {
        let count = self.folds().len();
        if let Some(fold) = (0..count).find(|fold| self.exact_fold(*fold) == Some(value)) {
            return Ok(self.at_fold(fold));
        }
        let scaled = Scaled::from(Interval::from_rational(self.precision(), value));
        let mut found = Vec::new();
        for branch in 0..=count {
            let point = self.on_branch(branch, &scaled)?;
            let same = |point: &CertifiedPoint| point.stability == stability && point.ln_radius().overlaps(ln_radius);
            let place = || Place::OnBranch { branch, value: value.clone() };
            found.extend(point.filter(same).map(|point| PathPoint { place: place(), point }));
        }
        Ok(<[PathPoint; 1]>::try_from(found).ok().map(|[one]| one))
    }

    /// The stable state to which the contact jumps when the controlled quantity passes fold `fold`, with its branch; at a minimum
    /// the contact shrinks, at a maximum it grows. `None` if there is none: the surfaces part or come to touch everywhere.
    ///
    /// # Errors
    /// [`Error::Undecided`](mdr_core::contact::Error::Undecided) if the precision does not decide whether there is one.
    pub fn past_fold(&self, fold: usize) -> Result<Option<(usize, PathPoint)>> {
        let Some((point, kind)) = self.folds().get(fold) else { return Ok(None) };
        let value = self.controlled(point);
        let branches: Vec<usize> = match kind {
            FoldKind::Minimum => (0..fold).rev().step_by(2).collect(),
            FoldKind::Maximum => (fold + 2..=self.folds().len()).step_by(2).collect(),
        };
        for branch in branches {
            if let Some(point) = self.on_branch(branch, &value)? {
                return Ok(Some((branch, PathPoint { place: Place::PastFold(fold), point })));
            }
        }
        Ok(None)
    }
}

/// A sum of stored energies Π + F²/2k, each with its multiplicity.
///
/// ```
/// use mdr_analytic::certified::{Elasticity, EnergySum, Question};
/// use mdr_core::contact::Control;
/// use mdr_core::number::Precision;
/// // JKR's sphere under fixed grips: no energy lies between the fold and the fold.
/// let [n, c, e_star, work] = ["2", "50", "1e6", "0.05"].map(|text| text.parse());
/// let question = Question::new(&n?, &c?, &Elasticity::Effective(e_star?), &work?, &Control::Indentation)?;
/// let curve = question.curve(Precision::new(64))?;
/// let fold = curve.at_fold(0).expect("a sphere breaks");
/// let nothing = EnergySum::difference(Some(&fold), Some(&fold)).value(&curve);
/// assert!(nothing.round(1).is_some_and(|zero| zero.is_zero()));
/// let stored = EnergySum::difference(Some(&fold), None).value(&curve);
/// assert!(stored.round(5).is_some_and(|energy| !energy.is_zero()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct EnergySum(Vec<(PathPoint, i64)>);

impl EnergySum {
    /// The energy of one state less that of another; without contact it is 0.
    pub fn difference(plus: Option<&PathPoint>, minus: Option<&PathPoint>) -> Self {
        let mut sum = EnergySum::default();
        [(plus, 1), (minus, -1)].into_iter().for_each(|(state, times)| sum.add(state, times));
        sum
    }

    fn add(&mut self, state: Option<&PathPoint>, times: i64) {
        let Some(state) = state else { return };
        match self.0.iter_mut().find(|(other, _)| other.place == state.place) {
            Some((_, count)) => *count += times,
            None => self.0.push((state.clone(), times)),
        }
    }

    /// The sum of both.
    #[must_use]
    pub fn plus(mut self, other: &EnergySum) -> Self {
        other.0.iter().for_each(|(state, times)| self.add(Some(state), *times));
        self
    }

    /// The energy in J, on the curve of its states; exactly 0 if all of them cancel.
    pub fn value(&self, curve: &Curve) -> Enclosure {
        let terms = self.0.iter().filter(|(_, times)| *times != 0);
        let terms = terms.map(|(state, times)| curve.stored(&state.point).multiple(*times));
        let sum = terms.reduce(|sum, term| sum.plus(&term));
        sum.map_or_else(|| Rational::new().into(), |sum| sum.enclosure())
    }
}
