//! Folds on a machine of finite stiffness k, which controls D = d + F/k.
//!
//! Along the equilibria k D' = k d' + F' = (k + 2E*a) d' − 2E*Δl. With g' = N aⁿ⁻¹ and Δl = 2√(Ba) this vanishes when
//!
//! N a^{n−1/2} = λ√B,  λ = (k + 6E*a)/(k + 2E*a) = 1 + 2p,
//!
//! where p = s/(1+s), s = 2E*a/k, is the share of the machine in the compliance. λ increases from 1 (fixed grips) to 3
//! (dead load). In u = ln s the condition reads
//!
//! φ(u) = μu + L − ln(1+2p) = 0,  μ = n − 1/2,  L = ln(N/√B) + μ ln(k/2E*),
//!
//! and D increases with a where φ > 0. Since 0 < ln(1+2p) < ln 3, every root lies between −L/μ and (ln 3 − L)/μ, that
//! is between the critical radii of the two limits.
//!
//! **Number of folds.** φ'(u) = μ − 2p(1−p)/(1+2p) = μ − 2s/((1+s)(1+3s)). The last term is largest at s = 1/√3, where
//! it is 2 − √3. So φ is monotone for μ < 0 (one fold, a maximum of D) and for μ ≥ 2 − √3 (one fold, a minimum). For 0
//! < μ < 2 − √3, that is 1/2 < n < 5/2 − √3, φ has a maximum and a minimum at the roots of 3μs² − 2(1−2μ)s + μ = 0, and
//! there are three folds if φ is positive at the first and negative at the second, else one. For μ = 0, φ decreases
//! from ln ρ to ln(ρ/3), where ρ = N/√B: one fold for 1 < ρ < 3, none otherwise; λ = ρ gives a = k(ρ−1)/(2E*(3−ρ)).
//!
//! A medium whose punch stiffness and elongation are powers of the radius has the balance μu + L − ln(1+βp), with another β:
//! φ' is least at s = 1/√(1+β), turning points are roots of (1+β)μs² − β(1−(1+2/β)μ)s + μ = 0, and there can be three folds
//! for 0 < μ < (√(1+β) − 1)/(√(1+β) + 1). The half-space is β = 2.

use mdr_core::contact::{Error, Fold, FoldKind, Quantity, Regime, Result};
use mdr_core::number::Real;

use crate::contact::{PowerLawContact, ln_edge_length};
use crate::newton::{self, tolerance, undecided};
use crate::range::{ordinary, representable};
use crate::state::State;

impl<R: Real> PowerLawContact<R> {
    /// All folds on a machine of stiffness k (N/m), by increasing radius: one, or three for some machines when
    /// 1/2 < n < 5/2 − √3; at n = 1/2 one or none. Each is a minimum or a maximum of D = d + F/k.
    ///
    /// ```
    /// use mdr_analytic::{PowerLawContact, PowerLaw};
    /// use mdr_core::contact::Material;
    /// let contact = PowerLawContact::new(PowerLaw::new(0.6, 2.4829)?, Material::new(1.0, 1.0)?);
    /// let folds = contact.machine_folds(&1.0)?;
    /// assert_eq!(folds.len(), 3);
    /// assert!((folds[2].contact_radius / 459.2 - 1.0).abs() < 1e-3);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] unless k is positive and finite; [`Error::Undecided`] if an interval does not decide their
    /// number; [`Error::OutOfRange`].
    pub fn machine_folds(&self, stiffness: &R) -> Result<Vec<Fold<R>>> {
        let stiffness = Error::require_positive(Quantity::Stiffness, stiffness.clone())?;
        let fold = |tangency: Tangency<R>| {
            let State { contact_radius, indentation, force } = self.machine_state(&stiffness, &tangency)?;
            Ok(Fold { contact_radius, indentation, force, kind: tangency.kind })
        };
        self.machine_tangencies(&stiffness)?.into_iter().map(fold).collect()
    }

    /// a, d and F at a fold.
    pub(crate) fn machine_state(&self, stiffness: &R, tangency: &Tangency<R>) -> Result<State<R>> {
        let scale = self.machine_length(stiffness);
        let ln_radius = || self.ln_machine_length(stiffness) + &tangency.ln_s;
        let radius = if ordinary(&scale) && ordinary(&tangency.s) { scale * &tangency.s } else { ln_radius().exp() };
        let a = representable(Quantity::ContactRadius, radius, ln_radius)?;
        self.tangent_state(a, &tangency.critical_ratio, ln_radius)
    }

    /// k/(2E*): a = s k/(2E*).
    pub(crate) fn machine_length(&self, stiffness: &R) -> R {
        stiffness.clone() / self.material().effective_modulus().clone().times(2)
    }

    /// ln of [`PowerLawContact::machine_length`], which itself may be out of range.
    pub(crate) fn ln_machine_length(&self, stiffness: &R) -> R {
        let scale = self.machine_length(stiffness);
        if ordinary(&scale) {
            return scale.ln();
        }
        stiffness.ln() - self.material().effective_modulus().ln() - scale.lit(2).ln()
    }

    /// The points of tangency that are the folds, by increasing radius.
    pub(crate) fn machine_tangencies(&self, stiffness: &R) -> Result<Vec<Tangency<R>>> {
        if self.regime()? == Regime::ScaleFree {
            return Ok(self.scale_free_tangency(stiffness)?.into_iter().collect());
        }
        let balance = Balance::new(self, stiffness);
        let tangency = |piece: &Piece<R>| {
            let ln_s = balance.root(piece)?;
            Ok(Tangency { s: ln_s.exp(), critical_ratio: CriticalRatio::machine(&ln_s), ln_s, kind: piece.kind })
        };
        balance.pieces()?.iter().map(tangency).collect()
    }

    /// n = 1/2, 1 < ρ < 3: s = (ρ−1)/(3−ρ), a maximum of D.
    fn scale_free_tangency(&self, stiffness: &R) -> Result<Option<Tangency<R>>> {
        let ratio = self.unchecked_ratio();
        let (one, three) = (ratio.lit(1), ratio.lit(3));
        let zero = ratio.lit(0);
        let share = |critical_ratio: &R| (critical_ratio.clone() - &one) / (three.clone() - critical_ratio);
        if ratio <= one || ratio >= three {
            return Ok(None);
        }
        let ln_s =
            |s: &R| if *s > zero { Ok(s.ln()) } else { Err(undecided(s, "whether C is between the two thresholds")) };
        // λ = 2nρ a^(n−1/2) equals ρ, but depends on n: the derivatives of a dual number need the full form.
        let excess = self.profile().excess();
        let ln_radius = self.ln_machine_length(stiffness) + ln_s(&share(&ratio))?;
        let critical_ratio = (excess.clone().over(2) * ln_radius).exp() * (excess + &one) * ratio;
        let s = share(&critical_ratio);
        let ln_s = ln_s(&s)?;
        Ok(Some(Tangency { critical_ratio: CriticalRatio::machine(&ln_s), ln_s, s, kind: FoldKind::Maximum }))
    }

    /// The first fold when leaving the stable branch: the largest for n > 1/2, on unloading; the smallest, and only
    /// one, for n < 1/2.
    pub(crate) fn first_machine_tangency(&self, stiffness: &R) -> Result<Tangency<R>> {
        let stiffness = Error::require_positive(Quantity::Stiffness, stiffness.clone())?;
        let none = || Error::domain(Quantity::Stiffness, &stiffness, "such that there is a fold");
        self.machine_tangencies(&stiffness)?.pop().ok_or_else(none)
    }
}

/// A point where N a^{n−1/2} = λ√B, with s = 2E*a/k.
pub(crate) struct Tangency<R> {
    pub(crate) s: R,
    pub(crate) ln_s: R,
    pub(crate) critical_ratio: CriticalRatio<R>,
    pub(crate) kind: FoldKind,
}

/// λ as an offset from the nearer of its limits, so that its difference from either is accurate.
#[derive(Clone, Debug)]
pub(crate) struct CriticalRatio<R> {
    /// 1, 3, or 0.
    limit: i64,
    /// λ minus that limit.
    rest: R,
}

impl<R: Real> CriticalRatio<R> {
    /// One of the limits, 1 under fixed grips or 3 under a dead load.
    #[inline(always)]
    pub(crate) fn limit(limit: i64, like: &R) -> Self {
        CriticalRatio { limit, rest: like.lit(0) }
    }

    /// Any other value.
    pub(crate) fn of(value: R) -> Self {
        CriticalRatio { limit: 0, rest: value }
    }

    /// 1 + 2s/(1+s) = 3 − 2/(1+s), with u = ln s.
    pub(crate) fn machine(u: &R) -> Self {
        if *u > u.lit(0) {
            return CriticalRatio { limit: 3, rest: Balance::share(&-u.clone()).times(-2) };
        }
        CriticalRatio { limit: 1, rest: Balance::share(u).times(2) }
    }

    /// λ.
    #[inline(always)]
    pub(crate) fn value(&self) -> R {
        self.rest.lit(self.limit) + &self.rest
    }

    /// λ − k − excess, so λ − 2n for k = 1 and λ − 2(n+1) for k = 3 with the excess 2n − 1.
    #[inline(always)]
    pub(crate) fn less(&self, k: i64, excess: &R) -> R {
        self.rest.lit(self.limit - k) - excess + &self.rest
    }
}

/// φ(u) and its parameters.
pub(crate) struct Balance<R> {
    /// μ, not zero.
    pub(crate) slope: R,
    /// L.
    pub(crate) offset: R,
    /// β, 2 on the half-space.
    pub(crate) growth: R,
}

/// An interval of u in which φ is monotone and has one root.
pub(crate) struct Piece<R> {
    from: R,
    to: R,
    pub(crate) kind: FoldKind,
}

impl<R: Real> Balance<R> {
    fn new(contact: &PowerLawContact<R>, stiffness: &R) -> Self {
        let slope = contact.profile().excess().over(2);
        let ratio = contact.slope_coefficient() / &contact.edge_root;
        let ln_ratio = if ordinary(&ratio) {
            ratio.ln()
        } else {
            let (profile, material) = (contact.profile(), contact.material());
            let ln_strength = profile.kappa().ln() + profile.coefficient().ln() + profile.exponent().ln();
            ln_strength - ln_edge_length(material).over(2)
        };
        let offset = contact.ln_machine_length(stiffness) * &slope + ln_ratio;
        Balance { growth: slope.lit(2), slope, offset }
    }

    /// p = s/(1+s), without overflow for any u.
    pub(crate) fn share(u: &R) -> R {
        ((-u.clone()).exp() + u.lit(1)).inv()
    }

    fn value(&self, u: &R) -> R {
        u.clone() * &self.slope + &self.offset - (Self::share(u) * &self.growth).ln_1p()
    }

    fn derivative(&self, u: &R) -> R {
        let share = Self::share(u);
        let rest = (u.exp() + u.lit(1)).inv();
        self.slope.clone() - (share.clone() * &rest) * &self.growth / (share * &self.growth + u.lit(1))
    }

    /// The monotone pieces that contain a root, by increasing u.
    pub(crate) fn pieces(&self) -> Result<Vec<Piece<R>>> {
        let zero = self.slope.lit(0);
        let first = -self.offset.clone() / &self.slope;
        let last = ((self.growth.clone() + zero.lit(1)).ln() - &self.offset) / &self.slope;
        if self.slope < zero {
            return Ok(vec![Piece { from: last, to: first, kind: FoldKind::Maximum }]);
        }
        let Some((top, bottom)) = self.turning_points()? else {
            return Ok(vec![Piece { from: first, to: last, kind: FoldKind::Minimum }]);
        };
        let positive = |u: &R| match self.value(u).partial_cmp(&zero) {
            Some(order) => Ok(order.is_gt()),
            None => Err(undecided(u, "whether two folds exist or have just merged")),
        };
        Ok(match (positive(&top)?, positive(&bottom)?) {
            (_, true) => vec![Piece { from: first, to: top, kind: FoldKind::Minimum }],
            (false, _) => vec![Piece { from: bottom, to: last, kind: FoldKind::Minimum }],
            (true, false) => vec![
                Piece { from: first, to: top.clone(), kind: FoldKind::Minimum },
                Piece { from: top, to: bottom.clone(), kind: FoldKind::Maximum },
                Piece { from: bottom, to: last, kind: FoldKind::Minimum },
            ],
        })
    }

    /// ln s of the maximum and the minimum of φ: the roots of (1+β)μs² − β(1−(1+ρ)μ)s + μ = 0, ρ = 2/β, whose product is
    /// 1/(1+β).
    fn turning_points(&self) -> Result<Option<(R, R)>> {
        let mu = &self.slope;
        let ratio = mu.lit(2) / &self.growth;
        let sum = ratio.clone() + mu.lit(1);
        let half = mu.lit(1) - sum.clone() * mu;
        // (1−(1+ρ)μ)² − ρ(2+ρ)μ²: over (1 − (1+ρ+√(ρ(2+ρ)))μ) it leaves a factor that is positive with that one.
        let discriminant = mu.lit(1) - sum.times(2) * mu + mu.square();
        let zero = mu.lit(0);
        if half <= zero || discriminant <= zero {
            return Ok(None);
        }
        if !(half > zero && discriminant > zero) {
            return Err(undecided(mu, "whether n is so small that there can be three folds"));
        }
        let sum = half + discriminant.sqrt();
        let top = (ratio.clone() * mu / &sum).ln();
        Ok(Some((top, (sum / (ratio * mu * (self.growth.clone() + mu.lit(1)))).ln())))
    }

    /// The root in a piece: an approximation, then [its enclosure](newton::enclosed). Over intervals the derivatives are also
    /// enclosed: that of u − φ(u)/φ'(u) with respect to u is φφ''/φ'², which encloses 0 where u encloses the root, so
    /// the accuracy of the slope of u does not matter.
    pub(crate) fn root(&self, piece: &Piece<R>) -> Result<R> {
        let guess = self.centred().approximate_root(piece);
        let residual = self.value(&guess) / self.derivative(&guess);
        let radius = residual.abs().midpoint().times(4) + tolerance(&guess).times(8);
        let rising = piece.kind == FoldKind::Minimum;
        newton::enclosed(&guess, radius, rising, "where exactly the fold lies", |u, neighbourhood| {
            let slope = self.derivative(neighbourhood);
            Ok((u.clone() - self.value(u) / &slope, slope))
        })
    }

    /// This function with representative points as parameters.
    fn centred(&self) -> Self {
        Balance { slope: self.slope.midpoint(), offset: self.offset.midpoint(), growth: self.growth.midpoint() }
    }

    /// Newton's method in the piece. The root of a stiff or a soft machine is at an end, to the last bit.
    fn approximate_root(&self, piece: &Piece<R>) -> R {
        let low = piece.from.midpoint() - tolerance(&piece.from.midpoint());
        let high = piece.to.midpoint() + tolerance(&piece.to.midpoint());
        newton::within(low, high, piece.kind == FoldKind::Minimum, |u| (self.value(u), self.derivative(u)))
    }
}

#[cfg(test)]
mod tests {
    use mdr_core::contact::Material;
    use mdr_core::number::Dual;

    use super::*;
    use crate::PowerLaw;

    /// The fold at n = 1/2 lies on a smooth curve of folds; its derivative is that of the curve.
    #[test]
    fn the_fold_at_one_half_moves_with_n() -> Result<()> {
        let at = |n: Dual<f64>| {
            let [c, e_star, work, stiffness] = [2.4, 1.0, 1.0, 0.7].map(Dual::constant);
            let contact = PowerLawContact::new(PowerLaw::new(n, c)?, Material::new(e_star, work)?);
            let fold = contact.machine_folds(&stiffness)?.remove(0);
            Ok([fold.contact_radius, fold.indentation, fold.force])
        };
        // Above 1/2 there are two more folds, out of the range of doubles, hence three points on one side.
        const STEP: f64 = 1e-5;
        let points = [at(Dual::variable(0.5))?, at(Dual::constant(0.5 - STEP))?, at(Dual::constant(0.5 - 2.0 * STEP))?];
        for part in 0..3 {
            let [here, near, far] = points.each_ref().map(|state| &state[part]);
            let slope = (3.0 * here.value - 4.0 * near.value + far.value) / (2.0 * STEP);
            // The third derivative contributes STEP², rounding 10⁻¹⁶/STEP.
            assert!((here.slope / slope - 1.0).abs() < 1e-7, "{here:?} {slope}");
        }
        Ok(())
    }
}
