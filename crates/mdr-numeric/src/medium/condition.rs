//! The condition of a fold, 2a g'/Δl = 2p + 2q/(1 + K/S), by the orders q of S and p of Δl in the size.

use mdr_core::contact::Control;
use mdr_core::number::Real;

use super::{Medium, arcosh_ratio, openness, phase};

impl<R: Real> Medium<R> {
    /// q = d ln S/d ln a.
    pub(crate) fn stiffness_order(&self, a: &R) -> R {
        match self {
            Medium::HalfSpace { .. } => a.lit(1),
            Medium::Graded { exponent, .. } => exponent.lit(1) + exponent,
            Medium::Winkler { .. } => a.lit(2),
            Medium::Plane { reference: None, .. } => a.lit(0),
            Medium::Plane { reference: Some(reference), .. } => {
                let share = a.clone() / reference;
                let root = ((share.lit(1) - &share) * (share.lit(1) + &share)).sqrt();
                (arcosh_ratio(reference, a) * root).inv()
            }
            Medium::Periodic { wavelength, .. } => {
                let t = phase(a, wavelength);
                (openness(a, wavelength) * (t.square() + t.lit(1))).inv().times(2)
            }
        }
    }

    /// 2p, where p = d ln Δl/d ln a.
    pub(super) fn double_elongation_order(&self, a: &R) -> R {
        match self {
            Medium::HalfSpace { .. } => a.lit(1),
            Medium::Graded { exponent, .. } => exponent.lit(1) - exponent,
            Medium::Winkler { .. } => a.lit(0),
            Medium::Plane { .. } | Medium::Periodic { .. } => a.lit(1) - self.stiffness_order(a).times(2),
        }
    }

    /// Δl'(a) = p Δl/a.
    pub(crate) fn elongation_slope(&self, work: &R, a: &R) -> R {
        match self {
            Medium::HalfSpace { .. } => self.elongation(work, a) / a.clone().times(2),
            _ => self.relative_elongation(work, a) * self.double_elongation_order(a).over(2),
        }
    }

    /// The tangency ratio 2a g'/Δl for a given g'(a); on a half-space it is g'/Δl' (1.10). Where p may be negative both sides of
    /// the condition are raised by 2q/(1 + S/K), after which neither is.
    pub(crate) fn tangency(&self, work: &R, slope: R, a: &R, control: &Control<R>) -> R {
        let ratio = slope.times(2) / self.relative_elongation(work, a);
        match self {
            Medium::Plane { reference: Some(_), .. } | Medium::Periodic { .. } => match control {
                Control::Force => ratio,
                Control::Indentation => ratio + self.stiffness_order(a).times(2),
                Control::Machine { stiffness } => {
                    let share = (self.stiffness(a) / stiffness + a.lit(1)).inv();
                    ratio + self.stiffness_order(a).times(2) * share
                }
            },
            _ => ratio,
        }
    }

    /// The tangency ratio at which the controlled quantity is stationary, 2p + 2q/(1 + K/S).
    pub(crate) fn critical_ratio(&self, a: &R, control: &Control<R>) -> R {
        // 2p + 2q where it is raised.
        if matches!(self, Medium::Plane { .. } | Medium::Periodic { .. }) {
            return a.lit(1);
        }
        let (grips, load) = (self.double_elongation_order(a), self.stiffness_order(a).times(2));
        match control {
            Control::Indentation => grips,
            Control::Force => grips + load,
            Control::Machine { stiffness } => {
                // In this form it stays in range at both ends.
                let share = (stiffness.clone() / self.stiffness(a) + a.lit(1)).inv();
                match self {
                    Medium::HalfSpace { .. } => share.times(2) + grips,
                    _ => share * load + grips,
                }
            }
        }
    }

    /// The stiffness dF/dd of a contact along its equilibria, over that at a fixed size, from 2a g'/Δl:
    /// F'/(S d') = (τ − 2p − 2q)/(τ − 2p); `None` at a fold of d.
    pub(crate) fn stiffening(&self, work: &R, slope: R, a: &R) -> Option<R> {
        let ratio = slope.times(2) / self.relative_elongation(work, a);
        let grips = self.double_elongation_order(a);
        let fold = ratio.clone() - &grips;
        let load = grips + self.stiffness_order(a).times(2);
        (fold != fold.lit(0)).then(|| (ratio - load) / fold)
    }
}
