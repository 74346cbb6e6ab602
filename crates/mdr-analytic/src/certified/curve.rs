//! The curve of equilibria of a power law under any control, in logarithms: all states, at any scale.
//!
//! With u = ln a, t = Δl(a), s = 2E*a/k and the depth φ = nd − t, which is proportional to the force,
//!
//! d = (φ + t)/n,  F = 2E*aφ/(n+1),  Π = E*a [2φ(φ + t)/((n+1)(2n+1)) − (2n−1)t²/(2(2n+1))],
//!
//! the last by (1.13) from [`PowerLawContact::energy`]. The controlled quantity is the difference P − Q of two positive,
//! increasing functions of u:
//!
//! | control | P | Q |
//! |---|---|---|
//! | d | g | t |
//! | F | 2E*a gn/(n+1) | 2E*a t |
//! | D = d + F/k | g(1 + sn/(n+1)) | t(1 + s) |
//!
//! Their logarithms are linear in u except for ln(1 + s), so no value and no radius leaves the range. Between two folds
//! P − Q is monotone. Its signs there, at 0 and at ∞ decide whether a branch contains a value; if it does, a sign
//! change encloses the radius.

use std::cmp::Ordering;

use mdr_core::contact::{Control, Error, FoldKind, Result, Stability};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Interval, Precision, Real};
use rug::Rational;

use super::scaled::Scaled;
use super::{Question, exact};
use crate::contact::{PowerLawContact, ln_edge_length};
use crate::machine::CriticalRatio;
use crate::newton;

/// The equilibria of a [`Question`] under its control, over intervals of some precision.
///
/// ```
/// use mdr_analytic::certified::{Elasticity, Question};
/// use mdr_core::contact::Control;
/// use mdr_core::number::Precision;
/// // Radii of 10^−1300 m and below: two equilibria, neither representable in f64.
/// let [n, c, e_star, work] = ["0.499", "0.1", "1", "1"].map(|text| text.parse());
/// let question = Question::new(&n?, &c?, &Elasticity::Effective(e_star?), &work?, &Control::Indentation)?;
/// let depth: mdr_core::number::Literal = "1e-650".parse()?;
/// let curve = question.curve(Precision::new(128))?;
/// assert_eq!(curve.equilibria(&depth.to_rational())?.len(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Curve {
    pub(super) control: Control<Interval>,
    pub(super) exponent: Interval,
    /// 2n − 1.
    excess: Interval,
    /// ln κ_nC.
    pub(super) ln_strength: Interval,
    /// ln 2√B, so that ln t is this and u/2.
    pub(super) ln_edge: Interval,
    /// ln 2E*.
    pub(super) ln_modulus: Interval,
    /// ln 2E*/k on a machine.
    pub(super) ln_softness: Option<Interval>,
    folds: Vec<(CertifiedPoint, FoldKind)>,
    /// The controlled quantity at each fold, if it is known to be rational.
    exact_folds: Vec<Option<Rational>>,
}

/// An equilibrium.
#[derive(Clone, Debug)]
pub struct CertifiedPoint {
    /// ln a.
    ln_radius: Interval,
    /// d.
    indentation: Scaled,
    /// φ = nd − Δl.
    depth: Scaled,
    /// Stability under the control of the curve.
    pub stability: Stability,
}

impl CertifiedPoint {
    /// a, in m.
    pub fn radius(&self) -> Scaled {
        Scaled::exp(self.ln_radius.clone())
    }

    /// ln a.
    pub fn ln_radius(&self) -> &Interval {
        &self.ln_radius
    }

    /// d, in m.
    pub fn indentation(&self) -> &Scaled {
        &self.indentation
    }
}

impl Question {
    /// The curve of equilibria, with its folds.
    ///
    /// # Errors
    /// [`Error::Undecided`] if the precision does not decide the number of folds.
    pub fn curve(&self, precision: Precision) -> Result<Curve> {
        self.curve_of(&self.contact(precision)?)
    }

    /// The curve of equilibria, with its folds, of the contact over intervals.
    pub(super) fn curve_of(&self, contact: &PowerLawContact<Interval>) -> Result<Curve> {
        let (profile, material) = (contact.profile(), contact.material());
        let precision = profile.exponent().ctx();
        let control = self.control(precision);
        let ln_modulus = material.effective_modulus().clone().times(2).ln();
        let mut curve = Curve {
            exponent: profile.exponent().clone(),
            excess: Interval::from_rational(precision, &(Rational::from(&self.exponent * 2u32) - 1u32)),
            ln_strength: profile.kappa().ln() + profile.coefficient().ln(),
            ln_edge: ln_edge_length(material).over(2) + ln_modulus.lit(2).ln(),
            ln_softness: match &control {
                Control::Machine { stiffness } => Some(ln_modulus.clone() - stiffness.ln()),
                _ => None,
            },
            ln_modulus,
            control,
            folds: Vec::new(),
            exact_folds: Vec::new(),
        };
        curve.folds = match &curve.control {
            Control::Machine { stiffness } => {
                let ln_length = contact.ln_machine_length(stiffness);
                let folds = contact.machine_tangencies(stiffness)?.into_iter();
                folds.map(|fold| (curve.tangent(fold.ln_s + &ln_length, &fold.critical_ratio), fold.kind)).collect()
            }
            _ => curve.fold().into_iter().collect(),
        };
        let exact = match self.control {
            Control::Indentation => exact::indentation(self, &self.control),
            _ => None,
        };
        curve.exact_folds = curve.folds.iter().map(|_| exact.clone()).collect();
        Ok(curve)
    }
}

impl Curve {
    /// The controlled quantity.
    pub fn control(&self) -> &Control<Interval> {
        &self.control
    }

    /// The precision of its intervals.
    pub fn precision(&self) -> Precision {
        self.exponent.ctx()
    }

    /// All folds of the controlled quantity, by increasing radius.
    pub fn folds(&self) -> &[(CertifiedPoint, FoldKind)] {
        &self.folds
    }

    /// Whether the controlled quantity increases from the tip on, so that contact begins continuously.
    ///
    /// # Errors
    /// [`Error::Undecided`] if n or ρ is not distinguished from its threshold.
    pub fn begins_smoothly(&self) -> Result<bool> {
        Ok(self.sign_at_tip()?.is_gt())
    }

    /// All equilibria at a value of the controlled quantity, by increasing radius; at a fold the double root counts as
    /// one.
    ///
    /// # Errors
    /// [`Error::Undecided`] if the precision does not decide their number or their positions.
    pub fn equilibria(&self, value: &Rational) -> Result<Vec<CertifiedPoint>> {
        let scaled = Scaled::from(Interval::from_rational(self.precision(), value));
        let at_fold = |fold: Option<usize>| fold.is_some_and(|fold| self.exact_fold(fold) == Some(value));
        let mut found = Vec::new();
        for branch in 0..=self.folds.len() {
            if !at_fold(branch.checked_sub(1)) && !at_fold(Some(branch)) {
                found.extend(self.on_branch(branch, &scaled)?);
            }
            found.extend(self.folds.get(branch).filter(|_| at_fold(Some(branch))).map(|(fold, _)| fold.clone()));
        }
        Ok(found)
    }

    /// The equilibrium at a value on the branch between fold `branch` − 1 and fold `branch`, the folds excluded.
    ///
    /// # Errors
    /// [`Error::Undecided`] if the precision does not decide whether there is one, or where it is.
    pub fn on_branch(&self, branch: usize, value: &Scaled) -> Result<Option<CertifiedPoint>> {
        if branch > self.folds.len() {
            return Ok(None);
        }
        let [below, above] = [branch.checked_sub(1), Some(branch)].map(|end| end.and_then(|end| self.folds.get(end)));
        let sign = value.sign().ok_or_else(|| self.undecided("the sign of a value"))?;
        let at_fold = |(fold, _): &(CertifiedPoint, FoldKind)| Ok(self.compare(value, fold)?.reverse());
        // The controlled quantity at the tip is 0 with a sign, and unbounded at large radii.
        let first =
            below.map_or_else(|| if sign.is_eq() { self.sign_at_tip() } else { Ok(sign.reverse()) }, at_fold)?;
        let last = above.map_or_else(|| self.sign_far_out(), at_fold)?;
        if first == last || first.is_eq() || last.is_eq() {
            return Ok(None);
        }
        let stability = if first.is_lt() { Stability::Stable } else { Stability::Unstable };
        let ends = [below, above].map(|end| end.map(|(fold, _)| &fold.ln_radius));
        Ok(Some(self.held_at(value, self.root(value, ends, first.is_lt())?, stability)))
    }

    /// The order of a value and the value of a fold.
    ///
    /// # Errors
    /// [`Error::Undecided`] if it is not certain.
    pub fn compare(&self, value: &Scaled, fold: &CertifiedPoint) -> Result<Ordering> {
        let order = value.minus(&self.controlled(fold)).sign();
        order.ok_or_else(|| self.undecided("whether a value is below or above that of a fold"))
    }

    /// The controlled quantity at a fold, if it is regarded as rational: d of a cone under fixed grips is.
    pub fn exact_fold(&self, fold: usize) -> Option<&Rational> {
        self.exact_folds.get(fold)?.as_ref()
    }

    /// Replaces the values of the folds by those that `round` returns, for an arithmetic that does not distinguish the two.
    #[must_use]
    pub fn with_folds_rounded(mut self, round: impl Fn(&Scaled) -> Option<Rational>) -> Self {
        let rounded = |(fold, _): &(CertifiedPoint, FoldKind)| round(&self.controlled(fold));
        let folds: Vec<_> = self.folds.iter().map(rounded).collect();
        let known = std::mem::take(&mut self.exact_folds);
        self.exact_folds = known.into_iter().zip(folds).map(|(known, rounded)| rounded.or(known)).collect();
        self
    }

    /// a, d and F at each fold.
    pub(super) fn states(&self) -> impl Iterator<Item = (FoldKind, [Enclosure; 3])> {
        let state = |point: &CertifiedPoint| [point.radius(), point.indentation.clone(), self.force(point)];
        self.folds.iter().map(move |(point, kind)| (*kind, state(point).map(|number| number.enclosure())))
    }

    /// F, in N.
    pub fn force(&self, point: &CertifiedPoint) -> Scaled {
        let next = self.exponent.lit(1) + &self.exponent;
        self.stiffness_of(point).times(&point.depth).by(&(next.lit(1) / &next))
    }

    /// The controlled quantity.
    pub fn controlled(&self, point: &CertifiedPoint) -> Scaled {
        match &self.control {
            Control::Indentation => point.indentation.clone(),
            Control::Force => self.force(point),
            Control::Machine { stiffness } => {
                point.indentation.plus(&self.force(point).over(&stiffness.clone().into()))
            }
        }
    }

    /// Π(a, d), in J.
    pub fn energy(&self, point: &CertifiedPoint) -> Scaled {
        let (n, one) = (&self.exponent, self.exponent.lit(1));
        let double = self.excess.clone() + self.excess.lit(2);
        let length = self.elongation(&point.ln_radius);
        let elastic = point.depth.times(&point.depth.plus(&length)).by(&(one.clone() / &((one + n) * &double)));
        let adhesive = length.times(&length).by(&(self.excess.clone() / double).over(4));
        elastic.minus(&adhesive).times(&self.stiffness_of(point))
    }

    /// The energy stored in the contact and in the spring of a machine, Π + F²/2k, in J.
    pub fn stored(&self, point: &CertifiedPoint) -> Scaled {
        let energy = self.energy(point);
        let Control::Machine { stiffness } = &self.control else { return energy };
        let force = self.force(point);
        energy.plus(&force.times(&force).over(&stiffness.clone().times(2).into()))
    }

    /// dF/dd along the equilibria, 2E*a (2φ/t + 2n−1)/(2φ/t + 2n+1), in N/m. At a fold of the force it is 0, at that of
    /// a machine −k; `None` at a fold of d.
    pub fn stiffness(&self, point: &CertifiedPoint) -> Option<Scaled> {
        match (&self.control, point.stability) {
            (Control::Indentation, Stability::Neutral) => return None,
            (Control::Force, Stability::Neutral) => return Some(self.excess.lit(0).into()),
            (Control::Machine { stiffness }, Stability::Neutral) => return Some((-stiffness.clone()).into()),
            _ => {}
        }
        let length = self.elongation(&point.ln_radius);
        let depth = point.depth.multiple(2);
        let [above, below] = [0, 2].map(|k| depth.plus(&length.by(&(self.excess.clone() + self.excess.lit(k)))));
        Some(self.stiffness_of(point).times(&above).over(&below))
    }

    /// 2E*a.
    fn stiffness_of(&self, point: &CertifiedPoint) -> Scaled {
        Scaled::exp(self.ln_modulus.clone() + &point.ln_radius)
    }

    /// t = Δl(a).
    fn elongation(&self, ln_radius: &Interval) -> Scaled {
        Scaled::exp(self.ln_elongation(ln_radius))
    }

    pub(super) fn ln_elongation(&self, ln_radius: &Interval) -> Interval {
        ln_radius.clone().over(2) + &self.ln_edge
    }

    /// The fold under fixed grips or a dead load: N a^{n−1/2} = λ√B. `None` at n = 1/2.
    fn fold(&self) -> Option<(CertifiedPoint, FoldKind)> {
        let zero = self.excess.lit(0);
        if self.excess == zero {
            return None;
        }
        let critical_ratio = CriticalRatio::limit(if self.control == Control::Force { 3 } else { 1 }, &zero);
        // ln λ√B/N.
        let ln_ratio =
            self.ln_edge.clone() + (critical_ratio.value().over(2) / &self.exponent).ln() - &self.ln_strength;
        let kind = if self.excess > zero { FoldKind::Minimum } else { FoldKind::Maximum };
        Some((self.tangent(ln_ratio.times(2) / &self.excess, &critical_ratio), kind))
    }

    /// The state with 2ng = λt: 2nd = (λ − 2n)t.
    fn tangent(&self, ln_radius: Interval, critical_ratio: &CriticalRatio<Interval>) -> CertifiedPoint {
        let length = self.elongation(&ln_radius);
        let [indentation, depth] = [1, 3].map(|k| critical_ratio.less(k, &self.excess).over(2));
        CertifiedPoint {
            indentation: length.by(&(indentation / &self.exponent)),
            depth: length.by(&depth),
            ln_radius,
            stability: Stability::Neutral,
        }
    }

    /// The state with the given radius and controlled value.
    fn held_at(&self, value: &Scaled, ln_radius: Interval, stability: Stability) -> CertifiedPoint {
        let (n, length) = (&self.exponent, self.elongation(&ln_radius));
        let next = n.lit(1) + n;
        let (indentation, depth) = match &self.control {
            Control::Indentation => (value.clone(), value.by(n).minus(&length)),
            Control::Force => {
                let depth = value.by(&next).over(&Scaled::exp(self.ln_modulus.clone() + &ln_radius));
                (depth.plus(&length).by(&(n.lit(1) / n)), depth)
            }
            Control::Machine { .. } => {
                // d(n+1+sn) = D(n+1) + st and φ(n+1+sn) = (n+1)(nD − t).
                let softness = Scaled::exp(self.ln_softness.clone().unwrap_or_else(|| n.lit(0)) + &ln_radius);
                let whole = softness.by(n).plus(&next.clone().into());
                let indentation = value.by(&next).plus(&softness.times(&length));
                (indentation.over(&whole), value.by(n).minus(&length).by(&next).over(&whole))
            }
        };
        CertifiedPoint { ln_radius, indentation, depth, stability }
    }

    /// The sign of the controlled quantity close to the tip.
    fn sign_at_tip(&self) -> Result<Ordering> {
        let zero = self.excess.lit(0);
        match self.excess.partial_cmp(&zero) {
            Some(Ordering::Equal) => self.balance_at(if self.control == Control::Force { 3 } else { 1 }),
            order => order.map(Ordering::reverse).ok_or_else(|| self.undecided("whether n is above 1/2")),
        }
    }

    /// The sign of the controlled quantity at large radii.
    fn sign_far_out(&self) -> Result<Ordering> {
        let zero = self.excess.lit(0);
        match self.excess.partial_cmp(&zero) {
            Some(Ordering::Equal) => self.balance_at(if self.control == Control::Indentation { 1 } else { 3 }),
            order => order.ok_or_else(|| self.undecided("whether n is above 1/2")),
        }
    }

    /// n = 1/2: the order of ρ and its threshold.
    fn balance_at(&self, threshold: i64) -> Result<Ordering> {
        let excess = self.ln_strength.clone() - &self.ln_edge - self.ln_edge.lit(threshold).ln();
        excess.partial_cmp(&excess.lit(0)).ok_or_else(|| self.undecided("whether C is above its threshold"))
    }

    pub(super) fn undecided(&self, what: &'static str) -> Error {
        newton::undecided(&self.exponent, what)
    }
}
