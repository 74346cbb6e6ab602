//! The fast way to equilibria at a value: exponentials of one word, and the rest in pairs of doubles.
//!
//! In the variables of [`inverse`](crate::inverse), with the first approximation v₀ exact as a double, one step
//! δ = (mE − P − μz)/(m(P − E)), E = e^{v₀}, P = e^{mv₀}, gives the root v₀ + δ, and with H = e^{u}, which is E, P or, under
//! force, one more exponential,
//!
//! a = a_λH²(1 + 2δᵤ + …),  Δl = sH(1 + δᵤ + …),  s = 2√(Ba_λ).
//!
//! **Error.** The words bring bounds of their errors with them. What they do to the numerator, over m|P − E|, is the error
//! of δ; to it comes the second order of Newton's step, below (1 + m + 1/|v|)δ². Both together, and those of a_λ, s and H,
//! make that of a, and d or F follow. An answer counts when these bounds are below half an ulp: with the last rounding it is
//! within one. Else, close to the fold or to n = 1/2 or to a zero of d or F, or far out of range, it is left to more words.

use mdr_core::contact::{Equilibrium, Ranged, Regime};
use mdr_core::number::{Real, Wide};

use super::pair::{Arithmetic, Native, Pair, is_ordinary};
use crate::contact::Contact;
use crate::inverse::{Branch, Equilibria, Fold, Held, Seed};

type Word = Wide<1>;

/// Half an ulp of any number, less a little for roundings of the bounds themselves.
const ENOUGH: f64 = 0.4999 * f64::EPSILON / 2.0;

/// 2⁻⁶⁴.
const UNIT: f64 = 1.0 / (1_u128 << 64) as f64;

/// Binary exponents of constants, of E and P, and of H, within which no product here is subnormal or overflows before a
/// result is out of the range that [`Ready::state`] accepts.
const CONSTANTS: u64 = 300;
const POWERS: u64 = 800;
const LENGTHS: u64 = 150;

/// A constant and the bound of its relative error.
#[derive(Clone, Copy, Debug)]
struct Known {
    pair: Pair,
    error: f64,
}

impl Known {
    fn new(value: &Word) -> Option<Self> {
        is_ordinary(value, CONSTANTS).then(|| {
            let magnitude = Pair::from(&value.abs());
            let pair = if *value < value.lit(0) { Pair::from(0.0).minus(magnitude) } else { magnitude };
            Known { pair, error: value.error() * UNIT }
        })
    }
}

/// What does not depend on the value.
#[derive(Clone, Debug)]
pub(super) struct Ready {
    held: Held,
    regime: Regime,
    n: f64,
    /// m, also as a word.
    parameter: Known,
    word: Word,
    mu: f64,
    /// x_fold.
    value: Pair,
    /// μ/x_fold.
    share: Known,
    /// a_λ.
    radius: Known,
    /// s.
    elongation: Known,
    /// 2E*/(n+1), or (n+1)/2E* under force.
    stiffness: Known,
}

impl Ready {
    /// `None` where a constant is out of range.
    pub(super) fn new(contact: &Contact<Word>, fold: &Fold<Word>) -> Option<Self> {
        let (state, (parameter, excess)) = (fold.state(), fold.family().parameters());
        let held = fold.held();
        let n = contact.profile().exponent();
        let next = *n + n.lit(1);
        let modulus = contact.material().effective_modulus().times(2);
        let at_fold = held.pick(&state.indentation, &state.force);
        Some(Ready {
            held,
            regime: fold.family().regime(),
            n: n.approx(),
            parameter: Known::new(parameter)?,
            word: *parameter,
            mu: excess.approx(),
            value: Known::new(at_fold)?.pair,
            share: Known::new(&(*excess / at_fold))?,
            radius: Known::new(&state.contact_radius)?,
            elongation: Known::new(&(*contact.edge_length() * state.contact_radius).sqrt().times(2))?,
            stiffness: Known::new(&held.pick(modulus / next, next / modulus))?,
        })
    }

    /// The equilibria at x, where the error bounds are good enough.
    #[inline]
    pub(super) fn equilibria(&self, x: f64) -> Option<Equilibria<Ranged<f64>>> {
        let z = x / self.value.hi;
        let tau = ((self.value.hi - x) + self.value.lo) / self.value.hi;
        // z is right to three roundings, and τ away from zero for certain.
        let ordinary = |x: f64| x == 0.0 || (1e-200..1e200).contains(&x.abs());
        if !(tau.abs() > 1e-6 && ordinary(z) && ordinary(x)) {
            return None;
        }
        let seed = Seed { mu: self.mu, tau, z, ln_z: pxfm::f_log(z.abs()) };
        Some(if tau < 0.0 {
            Equilibria::None
        } else if z <= 0.0 {
            Equilibria::One(self.state(x, seed.larger(), Branch::Larger)?)
        } else {
            let smaller = self.state(x, seed.smaller(), Branch::Smaller)?;
            Equilibria::Two([smaller, self.state(x, seed.larger(), Branch::Larger)?])
        })
    }

    /// H at the root near v, and the bound of its relative error.
    #[inline]
    fn length(&self, x: f64, v: f64) -> Option<(Pair, f64)> {
        let first = Word::from(v);
        let (e, p) = (first.exp(), (first * self.word).exp());
        if !(is_ordinary(&e, POWERS) && is_ordinary(&p, POWERS)) {
            return None;
        }
        let (power, other) = (Pair::from(&e), Pair::from(&p));
        let m = self.parameter.pair;
        let scaled = m.times(Native, power);
        let shifted = self.share.pair.scaled(Native, x);
        let numerator = scaled.minus(other).minus(shifted);
        let difference = other.hi - power.hi;
        let slope = m.hi * difference;
        let step = (numerator.hi + numerator.lo) / slope;
        let uncertain = scaled.hi * (e.error() * UNIT + self.parameter.error)
            + other.hi * (p.error() * UNIT)
            + shifted.hi.abs() * self.share.error;
        // Newton's second order, and the digits that the slope has lost where P and E are close.
        let step_error = uncertain / slope.abs() * (1.0 + step.abs())
            + 2.0 * (1.0 + m.hi + 1.0 / v.abs()) * step * step
            + step.abs() * f64::EPSILON * 8.0 * (power.hi + other.hi) / difference.abs();
        let above = self.regime == Regime::PullOff;
        let (stretch, length) = match (self.held, above) {
            (Held::Indentation, true) => (1.0, e),
            (Held::Indentation, false) => (m.hi, p),
            (Held::Force, true) => (1.0 / 3.0, first.over(3).exp()),
            (Held::Force, false) => (m.hi / 3.0, (first * self.word).over(3).exp()),
        };
        let (small, small_error) = (step * stretch, step_error * stretch);
        let error = length.error() * UNIT + small_error + small.abs().powi(3);
        is_ordinary(&length, LENGTHS).then(|| (Pair::from(&length).moved(small + 0.5 * small * small), error))
    }

    /// The state with the root near v.
    #[inline]
    fn state(&self, x: f64, v: f64, branch: Branch) -> Option<Equilibrium<Ranged<f64>>> {
        let (grown, grown_error) = self.length(x, v)?;
        let a = self.radius.pair.times(Native, grown.square(Native));
        let a_error = self.radius.error + 2.0 * grown_error;
        let elongation = self.elongation.pair.times(Native, grown);
        let elongation_error = elongation.hi * (self.elongation.error + grown_error);
        let (uncontrolled, error) = match self.held {
            Held::Indentation => {
                let pressed = Native::product(self.n, x).minus(elongation);
                let error = elongation_error / pressed.hi.abs() + self.stiffness.error + a_error;
                (pressed.times(Native, self.stiffness.pair).times(Native, a), error)
            }
            Held::Force => {
                let pressed = self.stiffness.pair.scaled(Native, x).over(Native, a, a.hi.recip());
                let sum = pressed.plus(elongation);
                let error = elongation_error + pressed.hi.abs() * (self.stiffness.error + a_error);
                (sum.over(Native, Pair::from(self.n), self.n.recip()), error / sum.hi.abs())
            }
        };
        if !(a_error < ENOUGH && error < ENOUGH) {
            return None;
        }
        let (a, uncontrolled) = (a.rounded(), uncontrolled.rounded());
        let inside = |value: f64| (1e-250..1e250).contains(&value.abs());
        if !(inside(a) && inside(uncontrolled)) {
            return None;
        }
        Some(Equilibrium {
            contact_radius: Ranged::Value(a),
            indentation: Ranged::Value(self.held.pick(x, uncontrolled)),
            force: Ranged::Value(self.held.pick(uncontrolled, x)),
            stability: branch.stability(self.regime),
        })
    }
}
