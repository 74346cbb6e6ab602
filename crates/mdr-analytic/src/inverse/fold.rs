//! Equilibria in the variables of the fold: a = a_λ e^{2u}, x = x_fold(1 − τ).

use mdr_core::contact::{Control, Equilibrium, Error, Quantity, Result};
use mdr_core::number::Real;

use super::family::{Family, Place};
use super::{Branch, Count, Equilibria, Held};
use crate::contact::PowerLawContact;
use crate::newton::undecided;
use crate::range::{product, representable};
use crate::state::State;

/// The fold of a contact under one control, prepared for many values.
#[derive(Clone, Debug)]
pub(crate) struct FoldFrame<R> {
    pub(crate) held: Held,
    pub(crate) state: State<R>,
    pub(crate) family: Family<R>,
}

impl<R: Real> FoldFrame<R> {
    /// # Errors
    /// Errors of [`PowerLawContact::critical`] and [`PowerLawContact::regime`].
    #[inline(always)]
    pub(crate) fn new(contact: &PowerLawContact<R>, held: Held) -> Result<Self> {
        let state = contact.critical(&held.control())?;
        let family = Family::new(contact, held, contact.regime()?);
        Ok(FoldFrame { held, state, family })
    }

    /// x_fold.
    fn value(&self) -> &R {
        self.held.pick(&self.state.indentation, &self.state.force)
    }

    /// The equilibria at x_fold(1 − τ).
    pub(super) fn at_distance(&self, contact: &PowerLawContact<R>, distance: &R) -> Result<Equilibria<R>> {
        let place = Place { distance: distance.clone(), value: distance.lit(1) - distance };
        let value = place.value.clone() * self.value();
        self.equilibria(contact, &place, &value, |branch| Ok(self.family.polish(&place, self.root(&place, branch)?)))
    }

    /// The equilibria at x, as accurate as the fold is known: the faster method if n is not too close to 1/2.
    #[inline(always)]
    pub(crate) fn at_value(&self, contact: &PowerLawContact<R>, value: &R) -> Result<Equilibria<R>> {
        let place =
            Place { distance: contact.distance(self.held, self.value(), value), value: value.clone() / self.value() };
        self.equilibria(contact, &place, value, |branch| self.root(&place, branch))
    }

    #[inline(always)]
    fn root(&self, place: &Place<R>, branch: Branch) -> Result<R> {
        let first = self.family.first(&place.distance, self.family.seed(place), branch);
        let root = self.family.root(place, first)?;
        // The initial guess was a double: the sign decides which of the two roots was reached.
        let zero = root.lit(0);
        let other_branch = if branch == Branch::Larger { root < zero } else { root > zero };
        if other_branch { Err(undecided(&root, "on which side of the fold the equilibrium lies")) } else { Ok(root) }
    }

    /// The states at the roots v.
    #[inline(always)]
    fn equilibria(
        &self,
        contact: &PowerLawContact<R>,
        place: &Place<R>,
        value: &R,
        root: impl Fn(Branch) -> Result<R>,
    ) -> Result<Equilibria<R>> {
        let state = |branch: Branch| {
            let ln_growth = self.family.ln_growth(self.held, root(branch)?);
            let radius = ln_growth.exp() * &self.state.contact_radius;
            let radius =
                representable(Quantity::ContactRadius, radius, || self.state.contact_radius.ln() + &ln_growth)?;
            contact.equilibrium_at(self.held, value, radius, branch.stability(self.family.regime))
        };
        Equilibria::at(place, || Ok(self.state.clone()), state)
    }
}

impl<R: Real> Equilibria<R> {
    /// The equilibria at a place, from the state of the fold and those of the roots.
    #[inline(always)]
    pub(super) fn at(
        place: &Place<R>,
        fold: impl FnOnce() -> Result<State<R>>,
        state: impl Fn(Branch) -> Result<Equilibrium<R>>,
    ) -> Result<Self> {
        Ok(match Count::of(&place.distance, &place.value)? {
            Count::None => Equilibria::None,
            Count::Fold => Equilibria::One(fold()?.at_rest()),
            Count::Larger => Equilibria::One(state(Branch::Larger)?),
            Count::Two => Equilibria::Two([state(Branch::Smaller)?, state(Branch::Larger)?]),
        })
    }
}

impl<R: Real> PowerLawContact<R> {
    /// τ = 1 − x/x_fold; for a cone 1 + dE*C/w, whose sign is exact in exact arithmetic.
    #[inline(always)]
    pub(super) fn distance(&self, held: Held, at_fold: &R, value: &R) -> R {
        if held == Held::Indentation && *self.profile().exponent() == value.lit(1) {
            let (e_star, work) = (self.material().effective_modulus(), self.material().work_of_adhesion());
            return (product([value, e_star, self.profile().coefficient()]) + work) / work;
        }
        (at_fold.clone() - value) / at_fold
    }
}

impl Count {
    /// The count, from τ and the sign of z = 1 − τ.
    #[inline(always)]
    fn of<R: Real>(distance: &R, value: &R) -> Result<Self> {
        use std::cmp::Ordering::*;
        let zero = distance.lit(0);
        let sign = value.partial_cmp(&zero);
        if matches!(sign, Some(Less | Equal)) {
            return Ok(Count::Larger);
        }
        let unknown = |what| Err::<Self, Error>(undecided(distance, what));
        match distance.partial_cmp(&zero) {
            Some(Less) => Ok(Count::None),
            Some(Equal) => Ok(Count::Fold),
            Some(Greater) if sign.is_some() => Ok(Count::Two),
            Some(Greater) => unknown("its sign"),
            None => unknown("whether it is before, at or beyond the fold"),
        }
    }
}

impl Held {
    /// The control.
    #[inline(always)]
    pub(crate) fn control<R>(self) -> Control<R> {
        self.pick(Control::Indentation, Control::Force)
    }
}
