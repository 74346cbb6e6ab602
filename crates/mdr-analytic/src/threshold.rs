//! n = 1/2, where the problem has no length scale (1.18), (1.19): thresholds of C decide the outcome.

use mdr_core::contact::{Control, Error, Material, Quantity, Regime, Result};
use mdr_core::number::Real;

use crate::contact::{PowerLawContact, edge_length, edge_root, ln_edge_length};
use crate::machine::CriticalRatio;
use crate::range::representable;
use crate::state::State;

/// The lemniscate constant ϖ = π/agm(1, √2) = 2.62205755…, in the precision of `like`; κ_{1/2} = ϖ/2.
pub fn lemniscate_constant<R: Real>(like: &R) -> R {
    like.pi() / arithmetic_geometric_mean(&like.lit(1), &like.lit(2).sqrt())
}

/// agm(x, y) of constants, 1 ≤ y/x ≤ 2. Each step reduces the difference of the two means to at most its square over 8,
/// so ⌈log₂ p⌉ + 1 steps give p bits; the last difference bounds the remainder.
fn arithmetic_geometric_mean<R: Real>(x: &R, y: &R) -> R {
    let (mut x, mut y) = (x.clone(), y.clone());
    let steps = u32::BITS - x.precision().leading_zeros() + 1;
    for _ in 0..steps {
        let arithmetic = (x.clone() + &y).over(2);
        let geometric = (x * &y).sqrt();
        (x, y) = (geometric, arithmetic);
    }
    // The slopes of duals are zero, as for constants, and so is that of the remainder.
    let rest = y.clone() - &x;
    y.inflate_with_slope(&rest)
}

/// The coefficient C at n = 1/2 that separates the two outcomes (1.19), in √m.
///
/// Under controlled indentation (2/ϖ)√(2πw/E*) = 0.7627…√(2πw/E*), under controlled force three times that. On a
/// machine no single C decides: between the two thresholds there is one fold ([`PowerLawContact::machine_folds`]); the value
/// returned is the lower one, that of the stiff limit.
///
/// ```
/// use mdr_analytic::threshold;
/// use mdr_core::contact::{Control, Material};
/// let unit = Material::new(2.0 * std::f64::consts::PI, 1.0)?;
/// assert!((threshold(&unit, &Control::Indentation)? - 0.762759763501813).abs() < 1e-15);
/// assert!((threshold(&unit, &Control::Force)? - 2.28827929050544).abs() < 1e-14);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`].
pub fn threshold<R: Real>(material: &Material<R>, control: &Control<R>) -> Result<R> {
    // √(2πw/E*) = 2√B.
    let root = edge_root(material, &edge_length(material));
    let constant = lemniscate_constant(&root);
    let factor = match control {
        Control::Indentation | Control::Machine { .. } => 4,
        Control::Force => 12,
    };
    let threshold = root.times(factor) / &constant;
    let ln = || ln_edge_length(material).over(2) + (constant.lit(factor) / &constant).ln();
    representable(Quantity::Coefficient, threshold, ln)
}

const RATIO: Quantity = Quantity::Parameter("the ratio of C to its threshold");

/// The outcome of a contact with n = 1/2 (1.19).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ScaleFreeOutcome {
    /// C above the threshold (case I): the equilibria are stable, and the radius shrinks to zero without indentation
    /// (or load).
    Shrinks,
    /// C below the threshold (case II): the equilibria are unstable, and the contact spreads over the whole surface.
    CompleteContact,
    /// C at the threshold: every radius is an equilibrium of d = 0 (or F = 0).
    Indifferent,
}

impl<R: Real> PowerLawContact<R> {
    /// ρ = κ_{1/2}C/√(2πw/E*) at n = 1/2: the ratio of C to its threshold under controlled indentation, three times the
    /// ratio under controlled force.
    ///
    /// # Errors
    /// [`Error::Domain`] unless n = 1/2; [`Error::OutOfRange`].
    pub fn ratio(&self) -> Result<R> {
        self.require_scale_free()?;
        representable(RATIO, self.unchecked_ratio(), || {
            let profile = self.profile();
            let ln_root = ln_edge_length(self.material()).over(2);
            (profile.kappa().clone().over(2)).ln() + profile.coefficient().ln() - ln_root
        })
    }

    /// ρ, or 0 or ∞ if it is out of range.
    pub(crate) fn unchecked_ratio(&self) -> R {
        self.profile().strength() / self.edge_root.clone().times(2)
    }

    /// The equilibrium of radius a at n = 1/2: d = (ρ−1)√(2πwa/E*) and F = 2E*a√(2πwa/E*)(ρ/3−1), tensile for ρ < 3.
    ///
    /// # Errors
    /// [`Error::Domain`] unless n = 1/2 and a is positive and finite; [`Error::OutOfRange`].
    pub fn scale_free_state(&self, a: &R) -> Result<State<R>> {
        let ratio = self.ratio()?;
        let a = Error::require_positive(Quantity::ContactRadius, a.clone())?;
        // Here N a^{n−1/2} = ρ√B at every radius.
        self.tangent_state(a.clone(), &CriticalRatio::of(ratio), || a.ln())
    }

    /// The outcome of the contact at n = 1/2 under the given control (1.19). On a machine the result for small radii is
    /// that of fixed grips.
    ///
    /// # Errors
    /// [`Error::Domain`] unless n = 1/2; [`Error::Undecided`] when an interval contains the threshold.
    pub fn fate(&self, control: &Control<R>) -> Result<ScaleFreeOutcome> {
        use std::cmp::Ordering::*;
        self.require_scale_free()?;
        let ratio = self.unchecked_ratio();
        let critical = match control {
            Control::Indentation | Control::Machine { .. } => ratio.lit(1),
            Control::Force => ratio.lit(3),
        };
        match ratio.partial_cmp(&critical) {
            Some(Greater) => Ok(ScaleFreeOutcome::Shrinks),
            Some(Equal) => Ok(ScaleFreeOutcome::Indifferent),
            Some(Less) => Ok(ScaleFreeOutcome::CompleteContact),
            None => Err(Error::undecided(Quantity::Coefficient, &ratio, "whether it is above or below the threshold")),
        }
    }

    fn require_scale_free(&self) -> Result<()> {
        self.require(&[Regime::ScaleFree], "1/2 for a scale-free contact")
    }
}
