//! Equilibria at a given indentation depth or force: the inverse of (1.13) and (1.16).
//!
//! With the radius a_λ of the fold (λ = 1 under fixed grips, 3 under a dead load), a = a_λ e^{2u}, both read
//!
//! e^{pu}/p − e^{qu}/q = x/s,  p = 2n, q = 1, s = 2√(Ba_λ) or p = 2(n+1), q = 3, s = 12E*a_λ√(Ba_λ).
//!
//! With v = qu the left side belongs to one family with the parameter m = p/q, which is 1 at n = 1/2 under either
//! control. Divided by its value at the fold, v = 0, it becomes
//!
//! Φ(v) = (e^{mv} − 1 − m(e^v − 1))/(m − 1) = τ,  τ = 1 − x/x_fold,
//!
//! and Φ_m(v) = Φ_{1/m}(mv), so that m > 1 suffices. There Φ decreases from 1 to 0 for v < 0 and increases from 0 to ∞
//! for v > 0: **no equilibrium** for τ < 0, the **double root** at τ = 0, **two** for 0 < τ < 1, and **only the
//! larger** for τ ≥ 1, where x is zero or has the other sign. The larger is stable for n > 1/2 and the smaller for n <
//! 1/2.
//!
//! A root is first approximated as a double, by Halley's iteration from a formula accurate to second order at the fold
//! and to first order far from it ([`start`]). Newton's method refines it to the precision of the arithmetic; the last
//! step, over a neighbourhood that contains its own image, encloses the root in a rigorous arithmetic.

mod at_value;
mod family;
mod fold;
mod start;

use mdr_core::contact::{Control, Equilibrium, Error, Quantity, Regime, Result, Stability};
use mdr_core::number::Real;

pub(crate) use self::fold::FoldFrame;
pub(crate) use self::start::InitialGuess;
use crate::contact::PowerLawContact;
use crate::newton::undecided;
use crate::range::{ordinary, product, representable};

/// The equilibria at one value of the controlled quantity.
#[derive(Clone, Debug, PartialEq)]
pub enum Equilibria<R> {
    /// There is none.
    None,
    /// One; [`Neutral`](Stability::Neutral) at the fold itself, the double root.
    One(Equilibrium<R>),
    /// Two, by increasing radius. One of them is stable.
    Two([Equilibrium<R>; 2]),
}

impl<R> Equilibria<R> {
    /// All of them, by increasing radius.
    pub fn as_slice(&self) -> &[Equilibrium<R>] {
        match self {
            Equilibria::None => &[],
            Equilibria::One(state) => std::slice::from_ref(state),
            Equilibria::Two(states) => states,
        }
    }

    /// The stable one, if there is one.
    pub fn stable(&self) -> Option<&Equilibrium<R>> {
        self.as_slice().iter().find(|state| state.stability == Stability::Stable)
    }

    /// Converts the states to another type of number; `None` if one of them cannot be converted.
    pub(crate) fn transform<S>(&self, f: impl Fn(&Equilibrium<R>) -> Option<Equilibrium<S>>) -> Option<Equilibria<S>> {
        Some(match self {
            Equilibria::None => Equilibria::None,
            Equilibria::One(state) => Equilibria::One(f(state)?),
            Equilibria::Two([smaller, larger]) => Equilibria::Two([f(smaller)?, f(larger)?]),
        })
    }
}

/// A control whose equilibria are those of the family.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Held {
    Indentation,
    Force,
}

impl Held {
    pub(crate) fn of<R: Real>(control: &Control<R>) -> Result<Self> {
        match control {
            Control::Indentation => Ok(Held::Indentation),
            Control::Force => Ok(Held::Force),
            Control::Machine { stiffness } => {
                let requirement =
                    "absent: equilibria at a value are those of controlled indentation or controlled force";
                Err(Error::domain(Quantity::Stiffness, stiffness, requirement))
            }
        }
    }

    /// q, which equals λ.
    fn critical_ratio(self) -> i64 {
        self.pick(1, 3)
    }

    /// The controlled one of d and F.
    pub(crate) fn pick<T>(self, indentation: T, force: T) -> T {
        match self {
            Held::Indentation => indentation,
            Held::Force => force,
        }
    }
}

/// Which of two equilibria.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Branch {
    Smaller,
    Larger,
}

impl Branch {
    pub(crate) fn stability(self, regime: Regime) -> Stability {
        let larger_is_stable = regime == Regime::PullOff;
        if (self == Branch::Larger) == larger_is_stable { Stability::Stable } else { Stability::Unstable }
    }
}

/// The number of equilibria at a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Count {
    None,
    Fold,
    Two,
    Larger,
}

impl<R: Real> PowerLawContact<R> {
    /// The equilibria at a given indentation depth or force, each with its stability under that control.
    ///
    /// | n | x against x_fold | equilibria |
    /// |---|---|---|
    /// | ≠ 1/2 | beyond the fold | none |
    /// | | at the fold | the double root, neutral |
    /// | | between the fold and 0 | two |
    /// | | 0 or of the other sign | the larger one |
    /// | 1/2 | of the sign of ρ − 1 (of ρ − 3 under force) | one |
    /// | | 0 or of the other sign | none |
    ///
    /// Accuracy: the residual of (1.13) or (1.16) is at the rounding level of its terms. The error of the radius is
    /// that times its condition, which grows as 1/√τ towards the fold ([`PowerLawContact::equilibria_at_distance`] avoids this
    /// loss). Over intervals existence, number and values are proved. The uncontrolled quantity follows from the radius
    /// as F = 2E*a(nd − Δl)/(n+1).
    ///
    /// ```
    /// use mdr_analytic::{PowerLawContact, PowerLaw};
    /// use mdr_core::contact::{Control, Material, Stability};
    /// let ball = PowerLawContact::new(PowerLaw::paraboloid(1.0)?, Material::new(1.0, 1e-3)?);
    /// let pulled = ball.equilibria(&Control::Indentation, &-0.01)?;
    /// let [smaller, larger] = pulled.as_slice() else { panic!("two equilibria") };
    /// assert!(smaller.contact_radius < larger.contact_radius && larger.stability == Stability::Stable);
    /// assert!((ball.indentation(&larger.contact_radius)? + 0.01).abs() < 1e-16);
    /// assert!(ball.equilibria(&Control::Indentation, &-1.0)?.as_slice().is_empty());
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] unless the value is finite and the control indentation or force; [`Error::Undecided`] if the
    /// arithmetic cannot distinguish the value from that of the fold, or at n = 1/2 C from its threshold (at the
    /// threshold every radius is in equilibrium at 0); [`Error::OutOfRange`].
    pub fn equilibria(&self, control: &Control<R>, value: &R) -> Result<Equilibria<R>> {
        let held = Held::of(control)?;
        if !value.is_finite() {
            return Err(Error::domain(control.quantity(), value, "finite"));
        }
        match self.regime()? {
            Regime::ScaleFree => self.scale_free_equilibria(held, value),
            regime => self.equilibria_by_residual(held, regime, value),
        }
    }

    /// The equilibria at x = x_fold(1 − τ) of the indentation depth or force: near the fold, the problem without the
    /// rounding of x. At any τ ≥ 0 the radius is accurate to rounding, relative to that of the fold.
    ///
    /// ```
    /// use mdr_analytic::{PowerLawContact, PowerLaw};
    /// use mdr_core::contact::{Control, Material};
    /// let cone = PowerLawContact::new(PowerLaw::cone(1.0)?, Material::new(1.0, 1.0)?);
    /// let near = cone.equilibria_at_distance(&Control::Indentation, &1e-30)?;
    /// // For a cone a = a_c(1 ± √τ)².
    /// let [smaller, larger] = near.as_slice() else { panic!("two equilibria") };
    /// let ratio = larger.contact_radius / smaller.contact_radius;
    /// assert!((ratio - 1.0 - 4e-15).abs() < 4e-16);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] unless the distance is finite, the control indentation or force, and n not 1/2, where there is no
    /// fold; [`Error::Undecided`] if the arithmetic does not decide on which side of the fold an equilibrium lies;
    /// [`Error::OutOfRange`].
    pub fn equilibria_at_distance(&self, control: &Control<R>, distance: &R) -> Result<Equilibria<R>> {
        let held = Held::of(control)?;
        if !distance.is_finite() {
            return Err(Error::domain(Quantity::Parameter("the distance from the fold"), distance, "finite"));
        }
        self.require_length_scale()?;
        FoldFrame::new(self, held)?.at_distance(self, distance)
    }

    /// n = 1/2: d = 2h√a or F = 4E*ha√a with h = κC/(2λ) − √B, each of one sign.
    fn scale_free_equilibria(&self, held: Held, value: &R) -> Result<Equilibria<R>> {
        let profile = self.profile();
        let excess = profile.kappa().clone().over(2 * held.critical_ratio()) * profile.coefficient() - &self.edge_root;
        let zero = value.lit(0);
        let stable = match excess.partial_cmp(&zero) {
            Some(order) if order.is_ne() => order.is_gt(),
            _ => {
                return Err(undecided(
                    &excess,
                    "whether C is above the threshold, where every radius is in equilibrium",
                ));
            }
        };
        match value.partial_cmp(&zero) {
            Some(order) if order.is_ne() && order.is_gt() == stable => {}
            Some(_) => return Ok(Equilibria::None),
            None => return Err(undecided(value, "its sign")),
        }
        let modulus = self.material().effective_modulus();
        let radius = match held {
            Held::Indentation => (value.clone() / &excess).over(2).square(),
            Held::Force => {
                let (unit, power) = (modulus.clone().times(4) * &excess, value.ratio(2, 3));
                let quotient = value.clone() / &unit;
                if ordinary(&unit) && ordinary(&quotient) {
                    quotient.pow(&power)
                } else {
                    let [value, modulus, excess] =
                        [value.abs(), modulus.clone().times(4).inv(), excess.abs().inv()].map(|x| x.pow(&power));
                    product([&value, &modulus, &excess])
                }
            }
        };
        let radius = representable(Quantity::ContactRadius, radius, || {
            let ln_quotient = value.abs().ln() - excess.abs().ln() - value.lit(2).ln();
            match held {
                Held::Indentation => ln_quotient.times(2),
                Held::Force => (ln_quotient - modulus.clone().times(2).ln()).times(2).over(3),
            }
        })?;
        let stability = if stable { Stability::Stable } else { Stability::Unstable };
        Ok(Equilibria::One(self.equilibrium_at(held, value, radius, stability)?))
    }

    /// The state of radius a with the given d or F.
    #[inline(always)]
    pub(crate) fn equilibrium_at(&self, held: Held, value: &R, a: R, stability: Stability) -> Result<Equilibrium<R>> {
        let (indentation, force) = match held {
            Held::Indentation => (value.clone(), self.force_at_indentation(&a, value)?),
            Held::Force => (self.indentation_at_force(&a, value)?, value.clone()),
        };
        Ok(Equilibrium { contact_radius: a, indentation, force, stability })
    }
}
