//! Equilibria at a given value from the residual of (1.13) or (1.16) itself.
//!
//! Near n = 1/2 the fold is ill conditioned where an equilibrium far from it is not. So the family only provides an
//! initial guess, from logarithms that stay in range, and Newton's method for d(a) = d or F(a) = F does the rest.

use std::cell::LazyCell;
use std::ops::Deref;

use mdr_core::contact::{Material, Quantity, Regime, Result, Stability};
use mdr_core::number::Real;

use super::family::{Family, Place};
use super::start::Seed;
use super::{Branch, Equilibria, Held};
use crate::contact::PowerLawContact;
use crate::newton;
use crate::power_law::PowerLaw;
use crate::range::representable;
use crate::state::State;

impl<R: Real> PowerLawContact<R> {
    /// The equilibria at x for n ≠ 1/2.
    pub(super) fn equilibria_by_residual(&self, held: Held, regime: Regime, value: &R) -> Result<Equilibria<R>> {
        let ln_state = self.ln_critical(&held.control())?;
        let family = Family::new(self, held, regime);
        let fold = LazyCell::new(|| self.critical(&held.control()));
        let ln_z = value.abs().ln() - held.pick(&ln_state.indentation, &ln_state.force);
        let (place, seed) = self.place(held, &family, (&ln_z, &fold), value);
        let state = |branch: Branch| {
            let v = family.first_of_far(&ln_z, family.first(&place.distance, seed, branch));
            let ln_radius = ln_state.contact_radius.midpoint() + family.ln_growth(held, v).midpoint();
            let first = representable(Quantity::ContactRadius, ln_radius.exp(), || ln_radius.clone())?.midpoint();
            let stability = branch.stability(regime);
            let radius = self.refined_radius(held, value, first, stability)?;
            self.equilibrium_at(held, value, radius, stability)
        };
        Equilibria::at(&place, || (*fold).clone(), state)
    }

    /// The position of x in the family, also if x_fold is out of range; of z only the sign is accurate.
    fn place(
        &self,
        held: Held,
        family: &Family<R>,
        (ln_z, fold): (&R, &impl Deref<Target = Result<State<R>>>),
        value: &R,
    ) -> (Place<R>, Seed) {
        let zero = value.lit(0);
        // x_fold < 0 for n > 1/2.
        let signed = if family.regime == Regime::PullOff { -value.clone() } else { value.clone() };
        let distance = if signed > zero {
            match &**fold {
                Ok(fold) => self.distance(held, held.pick(&fold.indentation, &fold.force), value),
                Err(_) => -ln_z.clone().exp_m1(),
            }
        } else {
            value.lit(1)
        };
        let ln_z = if *value == zero { f64::NEG_INFINITY } else { ln_z.approx() };
        let magnitude = ln_z.exp();
        let (z, tau) = if signed > zero { (magnitude, distance.approx()) } else { (-magnitude, 1.0 + magnitude) };
        (Place { distance, value: signed }, Seed { mu: family.mu(), tau, z, ln_z })
    }

    /// The radius near `first` that is in equilibrium at x. An enclosure that proves a root also proves by the slope on
    /// which side of the fold it is; `first` is only a double.
    fn refined_radius(&self, held: Held, value: &R, first: R, stability: Stability) -> Result<R> {
        let guess = self.centred()?.approximate_radius(held, &value.midpoint(), first)?;
        let step = self.newton(held, value, &guess, &guess)?.0 - &guess;
        let radius = step.abs().midpoint().times(4) + tolerance(&guess).times(4);
        let rising = stability == Stability::Stable;
        newton::enclosed(&guess, radius, rising, "where exactly the equilibrium lies", |a, neighbourhood| {
            self.newton(held, value, a, neighbourhood)
        })
    }

    /// a − (x(a) − x)/x'(neighbourhood), and that slope.
    fn newton(&self, held: Held, value: &R, a: &R, neighbourhood: &R) -> Result<(R, R)> {
        let (residual, slope) = match held {
            Held::Indentation => (self.indentation(a)? - value, self.indentation_slope(neighbourhood)?),
            Held::Force => (self.force(a)? - value, self.force_slope(neighbourhood)?),
        };
        Ok((a.clone() - residual / &slope, slope))
    }

    /// Newton's method from a first approximation until its steps no longer shrink.
    fn approximate_radius(&self, held: Held, value: &R, first: R) -> Result<R> {
        let (mut a, mut last) = (first.clone(), first);
        for _ in 0..64 + a.precision() {
            let next = self.newton(held, value, &a, &a)?.0.midpoint();
            let step = (next.clone() - &a).abs().midpoint();
            if !(step < last) {
                break;
            }
            // The error of the first approximation is smaller than that.
            let least = a.clone().over(8);
            a = if next > least { next } else { least.midpoint() };
            if step <= tolerance(&a) {
                break;
            }
            last = step;
        }
        Ok(a)
    }

    /// This contact with representative points as parameters.
    fn centred(&self) -> Result<Self> {
        let (profile, material) = (self.profile(), self.material());
        let kappa = profile.kappa().midpoint();
        let profile = PowerLaw::with_kappa(profile.exponent().midpoint(), profile.coefficient().midpoint(), kappa)?;
        let material = Material::new(material.effective_modulus().midpoint(), material.work_of_adhesion().midpoint())?;
        Ok(PowerLawContact::new(profile, material))
    }
}

/// Two units in the last place of a.
fn tolerance<R: Real>(a: &R) -> R {
    a.clone() * a.unit_roundoff().times(2)
}
