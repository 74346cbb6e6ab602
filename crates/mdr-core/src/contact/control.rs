//! The controlled quantity, which is prescribed while the contact radius adjusts.

use super::{Error, Quantity, Result};
use crate::named;
use crate::number::Real;
use crate::units::SiUnit;

/// The controlled quantity.
#[derive(Clone, Debug, PartialEq)]
pub enum Control<R> {
    /// Fixed grips: the indentation depth d (the case of the paper).
    Indentation,
    /// Dead load: the normal force F.
    Force,
    /// A machine of finite stiffness k (N/m): D = d + F/k. k → ∞ is fixed grips, k → 0 a dead load.
    Machine {
        /// k, in N/m.
        stiffness: R,
    },
}

named! {
    /// The kind of controlled quantity, without the stiffness of a machine.
    pub enum ControlKind {
        /// The indentation depth d: fixed grips.
        Indentation = "indentation",
        /// The normal force F: a dead load.
        Force = "force",
        /// The position D = d + F/k of a machine of stiffness k.
        Machine = "machine",
    }
}

impl ControlKind {
    /// The symbol of the controlled quantity: `d`, `F` or `D = d + F/k`.
    pub fn symbol(self) -> &'static str {
        match self {
            ControlKind::Indentation => "d",
            ControlKind::Force => "F",
            ControlKind::Machine => "D = d + F/k",
        }
    }

    /// The unit of the controlled quantity.
    pub fn unit(self) -> SiUnit {
        match self {
            ControlKind::Indentation | ControlKind::Machine => SiUnit::Metre,
            ControlKind::Force => SiUnit::Newton,
        }
    }
}

impl<N> Control<N> {
    /// The kind of controlled quantity.
    pub fn kind(&self) -> ControlKind {
        match self {
            Control::Indentation => ControlKind::Indentation,
            Control::Force => ControlKind::Force,
            Control::Machine { .. } => ControlKind::Machine,
        }
    }

    /// Converts the stiffness to another type of number.
    ///
    /// # Errors
    /// The error of `f`.
    pub fn try_map<M, E>(&self, f: impl FnOnce(&N) -> std::result::Result<M, E>) -> std::result::Result<Control<M>, E> {
        Ok(match self {
            Control::Indentation => Control::Indentation,
            Control::Force => Control::Force,
            Control::Machine { stiffness } => Control::Machine { stiffness: f(stiffness)? },
        })
    }

    /// This control with its stiffness in another form.
    ///
    /// ```
    /// use mdr_core::contact::Control;
    /// assert_eq!(Control::Machine { stiffness: 2 }.map(|k| f64::from(*k)), Control::Machine { stiffness: 2.0 });
    /// ```
    pub fn map<M>(&self, f: impl FnOnce(&N) -> M) -> Control<M> {
        let Ok(control) = self.try_map(|stiffness| Ok::<M, std::convert::Infallible>(f(stiffness)));
        control
    }
}

impl<R: Real> Control<R> {
    /// Control by a machine of the given stiffness k > 0, in N/m.
    ///
    /// # Errors
    /// [`Error::Domain`] unless the stiffness is positive and finite.
    pub fn machine(stiffness: R) -> Result<Self> {
        Ok(Control::Machine { stiffness: Error::require_positive(Quantity::Stiffness, stiffness)? })
    }

    /// Checks the stiffness of a machine that was not made by [`Control::machine`].
    ///
    /// # Errors
    /// [`Error::Domain`] unless it is positive and finite.
    pub fn check(&self) -> Result<()> {
        match self {
            Control::Indentation | Control::Force => Ok(()),
            Control::Machine { stiffness } => {
                Error::require_positive(Quantity::Stiffness, stiffness.clone()).map(|_| ())
            }
        }
    }

    /// Checks that `value` can be a value of the controlled quantity.
    ///
    /// ```
    /// use mdr_core::contact::Control;
    /// assert!(Control::Force.check_value(&-0.1).is_ok());
    /// assert!(Control::Force.check_value(&f64::NAN).is_err());
    /// assert!(Control::Machine { stiffness: -1.0 }.check_value(&0.0).is_err());
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] unless it is finite; as [`Control::check`].
    pub fn check_value(&self, value: &R) -> Result<()> {
        self.check()?;
        Error::require_finite(self.quantity(), value)
    }

    /// The controlled quantity, for errors.
    pub fn quantity(&self) -> Quantity {
        match self {
            Control::Indentation => Quantity::Indentation,
            Control::Force => Quantity::Force,
            Control::Machine { .. } => Quantity::MachinePosition,
        }
    }

    /// The value of the controlled quantity in a state with indentation `d` and force `f`.
    pub fn controlled(&self, d: &R, f: &R) -> R {
        match self {
            Control::Indentation => d.clone(),
            Control::Force => f.clone(),
            Control::Machine { stiffness } => f.clone() / stiffness + d,
        }
    }
}
