//! Folds and thresholds of the wave of Johnson (1995).
//!
//! The controlled quantity is P under a dead load and D = s + PL with L = κ − ln s when the approach is controlled through a
//! spring of compliance κ. With M = L − 4 cos²ψ both have folds where
//!
//! α = h(s),  h = 4s^{3/4}(1−s)^{5/4}  (load),  h = 4s^{3/4}(1−s)^{5/4} L/M, M > 0  (approach).
//!
//! **Number of folds.** Under a dead load h rises up to s = 3/8 and then falls, between 0 and α₁. By the approach
//! 4s(1−s) d ln h/ds = T/(LM) with T = (3−8s)L² − 4(1−s)(3−4s)L + 16(1−s)². In y = 4(1−s)/L, which is in (0, 1) where
//! M > 0, T/L² = y² − (3−4s)y + (3−8s), with the discriminant (4s+3)(4s−1) and the value 1 − 4s at y = 1. So T > 0 for
//! s ≤ 1/4, T < 0 for s ≥ 3/8, and between them T has the sign of y₋(s) − y for the smaller root y₋. Along y = y₋ the
//! compliance κ = 4(1−s)/y₋ + ln s rises with s, from 3 − ln 4 at s = 1/4 to ∞ at s = 3/8. Hence for κ > 3 − ln 4 there is
//! one s* at which h is largest, and two folds for α < h(s*). For κ ≤ 3 − ln 4, M changes its sign, at s₁ ≤ 1/4 ≤ s₂; h
//! rises from 0 to ∞ below s₁ and, if κ > 0, falls from ∞ to 0 above s₂: two folds for every α, one for κ = 0.
//!
//! All of it is written in v = ln tan²ψ, s = 1/(1 + e^−v), so that α → 0 is no exception at either end.

use std::cmp::Ordering;

use mdr_core::contact::{Error, FoldKind, Quantity, Result};
use mdr_core::number::{Real, Special};

use super::wave::{JohnsonWave, WaveState};
use crate::newton::{self, tolerance, undecided};

const COMPLIANCE: Quantity = Quantity::Parameter("the compliance κ of the bulk");
const ALPHA: Quantity = Quantity::Parameter("α of the wave");

/// The quantity that is controlled for a [`JohnsonWave`].
#[derive(Clone, Debug, PartialEq)]
pub enum WaveControl<R> {
    /// The mean pressure: a dead load.
    Load,
    /// The approach of the mean planes through a spring in series: D = 1 − H + κP.
    Approach {
        /// κ = πE*/(Kλ) ≥ 0, see [`JohnsonWave::compliance`]; 0 for the approach itself.
        compliance: R,
    },
}

/// A fold of the controlled quantity: pull-off is its minimum, the jump to complete contact its maximum.
#[derive(Clone, Debug, PartialEq)]
pub struct WaveFold<R> {
    /// The equilibrium.
    pub state: WaveState<R>,
    /// The kind of extremum.
    pub kind: FoldKind,
}

/// α₁ = 4(3/8)^{3/4}(5/8)^{5/4} = 1.0652…: below it there are folds under a dead load, pull-off and the jump to complete contact.
///
/// ```
/// assert!((mdr_analytic::media::wave_load_threshold(&1.0_f64) - 1.0652056560632807).abs() < 1e-15);
/// ```
pub fn wave_load_threshold<R: Real>(like: &R) -> R {
    like.ratio(84_375, 65_536).sqrt().sqrt()
}

/// α₀ = 3^{3/4}/4 = 0.5698…: above it surfaces that touch jump to complete contact without a load.
pub fn wave_touch_threshold<R: Real>(like: &R) -> R {
    like.ratio(27, 256).sqrt().sqrt()
}

/// 1/√(2π) = 0.3989…, the α above which complete contact has less energy than separation.
pub fn wave_energy_threshold<R: Real>(like: &R) -> R {
    like.pi().times(2).sqrt().inv()
}

/// 3 − ln 4 = 1.6137…: up to this compliance κ both folds exist for every α (for κ = 0 only pull-off), above it below a
/// threshold of α ([`wave_approach_threshold`]).
pub fn least_compliance_for_complete_contact<R: Real>(like: &R) -> R {
    like.lit(3) - like.lit(4).ln()
}

/// α₁(κ) > α₁, below which there are folds when the approach is controlled through a compliance κ > 3 − ln 4.
///
/// ```
/// assert!((mdr_analytic::media::wave_approach_threshold(&10.0)? - 1.391393917319465).abs() < 1e-14);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`Error::Domain`] unless κ is finite and above 3 − ln 4; [`Error::Undecided`] for an interval.
pub fn wave_approach_threshold<R: Real>(compliance: &R) -> Result<R> {
    let least = least_compliance_for_complete_contact(compliance);
    if !(compliance.is_finite() && *compliance > least) {
        return Err(Error::domain(
            COMPLIANCE,
            compliance,
            "above 3 - ln 4 for a threshold; below there are always folds",
        ));
    }
    let balance = Balance { ln_alpha: compliance.lit(0), compliance: Some(compliance.clone()) };
    Ok(balance.value(&turning_point(compliance)?).exp())
}

impl<R: Special> JohnsonWave<R> {
    /// All folds under the control, by increasing half-width.
    ///
    /// ```
    /// use mdr_analytic::media::{JohnsonWave, WaveControl};
    /// // α = 1: the jump to complete contact is at s = 1/2, P = −1/2.
    /// let folds = JohnsonWave::of_alpha(1.0)?.folds(&WaveControl::Load)?;
    /// assert!((folds[1].state.share - 0.5).abs() < 1e-14 && (folds[1].state.pressure + 0.5).abs() < 1e-14);
    /// assert!(JohnsonWave::of_alpha(1.1)?.folds(&WaveControl::Load)?.is_empty());
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] unless κ ≥ 0 is finite; [`Error::Undecided`] where the arithmetic does not decide their number, close
    /// to a threshold.
    pub fn folds(&self, control: &WaveControl<R>) -> Result<Vec<WaveFold<R>>> {
        let roots = Balance::new(self, control)?.roots()?;
        Ok(roots.into_iter().map(|(v, kind)| WaveFold { state: self.at_logarithm(&v), kind }).collect())
    }

    /// The equilibrium into which surfaces jump that touch at P = 0 (load) or D = 0 (approach); `None` where they jump to complete
    /// contact.
    ///
    /// # Errors
    /// [`Error::Domain`] unless κ ≥ 0 is finite; [`Error::Undecided`] where the arithmetic does not decide.
    pub fn touching(&self, control: &WaveControl<R>) -> Result<Option<WaveState<R>>> {
        let balance = Balance::new(self, control)?;
        let touch = Touch { balance: &balance };
        let far = match (&balance.compliance, control) {
            // α⁴ = s³(1−s): the stable root is below s = 3/4.
            (None, _) => {
                if !self.below(&wave_touch_threshold(&self.alpha))? {
                    return Ok(None);
                }
                Some(self.alpha.lit(3).ln())
            }
            (Some(compliance), _) if *compliance == compliance.lit(0) => None,
            // D is largest at the second fold.
            (Some(_), _) => match balance.roots()?.as_slice() {
                [_, (last, _)] => match touch.value(last).partial_cmp(&last.lit(0)) {
                    Some(Ordering::Greater) => Some(last.clone()),
                    Some(_) => return Ok(None),
                    None => return Err(undecided(last, "whether surfaces that touch jump to complete contact")),
                },
                _ => return Ok(None),
            },
        };
        touch.root(far.as_ref()).map(|v| Some(self.at_logarithm(&v)))
    }

    /// Whether α is below a threshold.
    fn below(&self, threshold: &R) -> Result<bool> {
        let order = self.alpha.partial_cmp(threshold);
        order
            .map(Ordering::is_lt)
            .ok_or_else(|| Error::undecided(ALPHA, &self.alpha, "whether α is below its threshold"))
    }
}

/// sin²ψ, cos²ψ and their logarithms at v = ln tan²ψ.
struct Point<R> {
    share: R,
    rest: R,
    ln_share: R,
    ln_rest: R,
}

impl<R: Real> Point<R> {
    fn new(v: &R) -> Self {
        let (share, rest) = (((-v.clone()).exp() + v.lit(1)).inv(), (v.exp() + v.lit(1)).inv());
        Point { share, rest, ln_share: -softplus(&-v.clone()), ln_rest: -softplus(v) }
    }
}

/// ln(1 + eˣ).
fn softplus<R: Real>(x: &R) -> R {
    if *x > x.lit(0) { (-x.clone()).exp().ln_1p() + x } else { x.exp().ln_1p() }
}

/// f(v) = ln h(s)/α, zero at the folds; without a compliance under a dead load.
struct Balance<R> {
    ln_alpha: R,
    compliance: Option<R>,
}

impl<R: Real> Balance<R> {
    fn new(wave: &JohnsonWave<R>, control: &WaveControl<R>) -> Result<Self> {
        let ln_alpha = wave.alpha.ln();
        let compliance = match control {
            WaveControl::Load => None,
            WaveControl::Approach { compliance } => {
                if !(*compliance >= compliance.lit(0) && compliance.is_finite()) {
                    return Err(Error::domain(COMPLIANCE, compliance, "at least 0 and finite"));
                }
                Some(compliance.clone())
            }
        };
        Ok(Balance { ln_alpha, compliance })
    }

    fn centred(&self) -> Self {
        Balance { ln_alpha: self.ln_alpha.midpoint(), compliance: self.compliance.as_ref().map(R::midpoint) }
    }

    fn value(&self, v: &R) -> R {
        let point = Point::new(v);
        let load = v.lit(4).ln() + (point.ln_share.clone().times(3) + point.ln_rest.times(5)).over(4) - &self.ln_alpha;
        match &self.compliance {
            None => load,
            Some(compliance) => {
                let l = compliance.clone() - point.ln_share;
                load - (-(point.rest.times(4) / l)).ln_1p()
            }
        }
    }

    /// df/dv = T/(4LM), (3 − 8s)/4 under a dead load.
    fn slope(&self, v: &R) -> R {
        let Point { share, rest, ln_share, .. } = Point::new(v);
        let three = v.lit(3);
        let Some(compliance) = &self.compliance else { return (three - share.times(8)).over(4) };
        let y = rest.times(4) / (compliance.clone() - ln_share);
        let quadratic = (y.clone() - &three + share.clone().times(4)) * &y + three - share.times(8);
        quadratic / (v.lit(1) - y).times(4)
    }

    /// M/L, positive where h is defined.
    fn is_defined(&self, v: &R) -> bool {
        let Point { rest, ln_share, .. } = Point::new(v);
        match &self.compliance {
            None => true,
            Some(compliance) => compliance.clone() - ln_share > rest.times(4),
        }
    }

    /// v at each fold, by increasing half-width.
    fn roots(&self) -> Result<Vec<(R, FoldKind)>> {
        let turn = match &self.compliance {
            None => Some(self.ln_alpha.ratio(3, 5).ln()),
            Some(compliance) => {
                let least = least_compliance_for_complete_contact(compliance);
                let order = compliance.partial_cmp(&least);
                let open = || Error::undecided(COMPLIANCE, compliance, "whether κ is above 3 - ln 4");
                if order.ok_or_else(open)?.is_gt() { Some(turning_point(compliance)?) } else { None }
            }
        };
        let Some(turn) = turn else { return self.separate_roots() };
        match self.value(&turn).partial_cmp(&turn.lit(0)) {
            Some(Ordering::Greater) => {
                let (turn, centred) = (turn.midpoint(), self.centred());
                let low = centred.walk(&turn, -1)?;
                let high = centred.walk(&turn, 1)?;
                Ok(vec![
                    (self.root(low, turn.clone(), true)?, FoldKind::Minimum),
                    (self.root(turn, high, false)?, FoldKind::Maximum),
                ])
            }
            Some(_) => Ok(Vec::new()),
            None => Err(Error::undecided(ALPHA, &turn, "whether two folds exist or have just merged")),
        }
    }

    /// The folds for κ ≤ 3 − ln 4, on both sides of the gap in which M < 0.
    fn separate_roots(&self) -> Result<Vec<(R, FoldKind)>> {
        let centred = self.centred();
        // M < 0 at s = 1/4.
        let middle = -self.ln_alpha.lit(3).ln().midpoint();
        let low = centred.walk(&middle, -1)?;
        let high = centred.inside(low.clone(), middle.clone())?;
        let mut roots = vec![(self.root(low, high, true)?, FoldKind::Minimum)];
        if self.compliance.as_ref().is_some_and(|compliance| *compliance != compliance.lit(0)) {
            let high = centred.walk(&middle, 1)?;
            let low = centred.inside(high.clone(), middle)?;
            roots.push((self.root(low, high, false)?, FoldKind::Maximum));
        }
        Ok(roots)
    }

    /// A place with f < 0 on one side of another, by steps of increasing length.
    fn walk(&self, from: &R, side: i64) -> Result<R> {
        let mut step = from.lit(side);
        for _ in 0..from.precision() + 64 {
            let next = from.clone() + &step;
            if self.is_defined(&next) && self.value(&next) < next.lit(0) {
                return Ok(next);
            }
            step = step.times(2);
        }
        Err(undecided(from, "where the fold lies"))
    }

    /// A place with f > 0 between one with f < 0 and one where f is not defined, beside which it is without bound.
    fn inside(&self, mut below: R, mut undefined: R) -> Result<R> {
        for _ in 0..2 * below.precision() + 64 {
            let middle = (below.clone() + &undefined).over(2);
            if !self.is_defined(&middle) {
                undefined = middle;
            } else if self.value(&middle) > middle.lit(0) {
                return Ok(middle);
            } else {
                below = middle;
            }
        }
        Err(undecided(&below, "where the fold lies"))
    }

    fn root(&self, low: R, high: R, rising: bool) -> Result<R> {
        let centred = self.centred();
        let guess = newton::within(low, high, rising, |v| (centred.value(v), centred.slope(v)));
        let residual = self.value(&guess) / self.slope(&guess);
        let radius = residual.abs().midpoint().times(4) + tolerance(&guess).times(8);
        newton::enclosed(&guess, radius, rising, "where exactly the fold lies", |v, around| {
            let slope = self.slope(around);
            Ok((v.clone() - self.value(v) / &slope, slope))
        })
    }
}

/// v at s*, where h is largest for κ > 3 − ln 4: the zero of Φ = (3−8s)L − 2(1−s)(3−4s+√((4s+3)(4s−1))), which falls through it.
fn turning_point<R: Real>(compliance: &R) -> Result<R> {
    let parts = |compliance: &R, s: &R| {
        let rest = s.lit(1) - s;
        let root = ((s.clone().times(4) + s.lit(3)) * (s.clone().times(4) - s.lit(1))).sqrt();
        let (edge, l) = (s.lit(3) - s.clone().times(8), compliance.clone() - s.ln());
        let sum = s.lit(3) - s.clone().times(4) + &root;
        let value = edge.clone() * &l - (rest.clone() * &sum).times(2);
        let turn = (s.clone().times(16) + s.lit(4)) / root - s.lit(4);
        let slope = (sum - rest * turn).times(2) - edge / s - l.times(8);
        (value, slope)
    };
    let centred = compliance.midpoint();
    let guess = newton::within(centred.ratio(1, 4), centred.ratio(3, 8), false, |s| parts(&centred, s));
    let (value, slope) = parts(compliance, &guess);
    let radius = (value / slope).abs().midpoint().times(4) + tolerance(&guess).times(8);
    let s = newton::enclosed(&guess, radius, false, "where two folds merge", |s, around| {
        let slope = parts(compliance, around).1;
        Ok((s.clone() - parts(compliance, s).0 / &slope, slope))
    })?;
    Ok((s.clone() / (s.lit(1) - &s)).ln())
}

/// F(v) = ln k(s)/α with k = s^{3/4}(1−s)^{1/4}(1 + 1/L), which has the sign of the controlled quantity.
struct Touch<'a, R> {
    balance: &'a Balance<R>,
}

impl<R: Real> Touch<'_, R> {
    fn value(&self, v: &R) -> R {
        let point = Point::new(v);
        let load = (point.ln_share.clone().times(3) + point.ln_rest).over(4) - &self.balance.ln_alpha;
        match &self.balance.compliance {
            None => load,
            Some(compliance) => load + (compliance.clone() - point.ln_share).inv().ln_1p(),
        }
    }

    /// dF/dv = [3 − 4s + 4(1−s)/(L(L+1))]/4.
    fn slope(&self, v: &R) -> R {
        let Point { share, rest, ln_share, .. } = Point::new(v);
        let load = v.lit(3) - share.times(4);
        match &self.balance.compliance {
            None => load.over(4),
            Some(compliance) => {
                let l = compliance.clone() - ln_share;
                (load + rest.times(4) / ((l.clone() + v.lit(1)) * l)).over(4)
            }
        }
    }

    /// The zero through which F rises, up to `far`.
    fn root(&self, far: Option<&R>) -> Result<R> {
        let balance = self.balance.centred();
        let centred = Touch { balance: &balance };
        let zero = balance.ln_alpha.lit(0);
        let walk = |from: &R, side: i64, rising: bool| {
            let mut step = from.lit(side);
            for _ in 0..from.precision() + 64 {
                let next = from.clone() + &step;
                if (centred.value(&next) > zero) == rising {
                    return Ok(next);
                }
                step = step.times(2);
            }
            Err(undecided(from, "where the equilibrium lies"))
        };
        let (low, high) = match far.map(R::midpoint) {
            Some(far) => (walk(&far, -1, false)?, far),
            None => (walk(&zero, -1, false)?, walk(&zero, 1, true)?),
        };
        let guess = newton::within(low, high, true, |v| (centred.value(v), centred.slope(v)));
        let residual = self.value(&guess) / self.slope(&guess);
        let radius = residual.abs().midpoint().times(4) + tolerance(&guess).times(8);
        newton::enclosed(&guess, radius, true, "where exactly the equilibrium lies", |v, around| {
            let slope = self.slope(around);
            Ok((v.clone() - self.value(v) / &slope, slope))
        })
    }
}
