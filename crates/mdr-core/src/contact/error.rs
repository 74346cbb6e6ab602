//! The one error type. Every message states the quantity, its value and the remedy.

use std::fmt;

use thiserror::Error as ThisError;

#[cfg(feature = "mp")]
use crate::number::Interval;
use crate::number::Real;
use crate::text::excerpt;

/// A result of this workspace.
pub type Result<T> = std::result::Result<T, Error>;

/// The quantities that an error can be about. Symbols are those of the paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Quantity {
    /// n of f = C rⁿ.
    Exponent,
    /// C of f = C rⁿ, in m^(1−n).
    Coefficient,
    /// E*, in Pa.
    EffectiveModulus,
    /// E of one body, in Pa.
    YoungsModulus,
    /// ν of one body.
    PoissonsRatio,
    /// w = Δγ, in J/m².
    WorkOfAdhesion,
    /// k of the machine, in N/m.
    Stiffness,
    /// a, in m.
    ContactRadius,
    /// d, in m.
    Indentation,
    /// F, in N.
    Force,
    /// D = d + F/k, in m.
    MachinePosition,
    /// A radius in the plane of contact, in m.
    Radius,
    /// κ_n.
    Kappa,
    /// g(x), the MDR-transformed profile, in m.
    TransformedProfile,
    /// Π, in J.
    Energy,
    /// Δx of the elastic foundation, in m.
    Spacing,
    /// The number of decimal digits required.
    Digits,
    /// A definite integral.
    Integral,
    /// An integrand.
    Integrand,
    /// A function whose zero is sought.
    Residual,
    /// A parameter of a profile, by name.
    Parameter(&'static str),
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Quantity::Exponent => "the exponent n",
            Quantity::Coefficient => "the coefficient C",
            Quantity::EffectiveModulus => "the effective modulus E*",
            Quantity::YoungsModulus => "Young's modulus E",
            Quantity::PoissonsRatio => "Poisson's ratio ν",
            Quantity::WorkOfAdhesion => "the work of adhesion w",
            Quantity::Stiffness => "the machine stiffness k",
            Quantity::ContactRadius => "the contact radius a",
            Quantity::Indentation => "the indentation depth d",
            Quantity::Force => "the normal force F",
            Quantity::MachinePosition => "the machine position D",
            Quantity::Radius => "the radius r",
            Quantity::Kappa => "the factor κ_n",
            Quantity::TransformedProfile => "the transformed profile g",
            Quantity::Energy => "the potential energy Π",
            Quantity::Spacing => "the spring spacing Δx",
            Quantity::Digits => "the number of digits",
            Quantity::Integral => "the integral",
            Quantity::Integrand => "the integrand",
            Quantity::Residual => "the residual",
            Quantity::Parameter(name) => name,
        })
    }
}

/// Why a result cannot be given as a number.
///
/// ```
/// use mdr_core::contact::{Error, Quantity};
/// let error = Error::domain(Quantity::Exponent, &-1.0, "positive and finite");
/// assert_eq!(error.to_string(), "the exponent n must be positive and finite, got -1");
/// let error = Error::no_equilibrium(Quantity::Indentation, &-1e-300);
/// assert_eq!(error.to_string(), "there is no equilibrium at the indentation depth d = -1e-300");
/// ```
#[derive(Clone, Debug, PartialEq, ThisError)]
#[non_exhaustive]
pub enum Error {
    /// An input outside its domain.
    #[error("{quantity} must be {requirement}, got {}", excerpt(value))]
    Domain {
        /// Which input.
        quantity: Quantity,
        /// Its value.
        value: String,
        /// The requirement on the input.
        requirement: &'static str,
    },
    /// The result is a number, but not representable in this arithmetic.
    #[error(
        "{quantity} is out of the range of this arithmetic: its log10 is {log10}; ask for certified digits instead"
    )]
    OutOfRange {
        /// Which result.
        quantity: Quantity,
        /// log10 of its magnitude.
        log10: f64,
    },
    /// No state satisfies the equations.
    #[error("there is no equilibrium at {quantity} = {}", excerpt(value))]
    NoEquilibrium {
        /// The controlled quantity.
        quantity: Quantity,
        /// Its value.
        value: String,
    },
    /// An iteration ended before its tolerance was met.
    #[error("{quantity}: no convergence after {evaluations} evaluations, relative error about {error:.1e}")]
    NoConvergence {
        /// The computed quantity.
        quantity: Quantity,
        /// Evaluations spent.
        evaluations: usize,
        /// Estimated relative error reached.
        error: f64,
    },
    /// A rigorous computation could not decide between two results at any precision it may use.
    #[error("{quantity}: undecided at {bits} bits: {what}")]
    Undecided {
        /// The computed quantity.
        quantity: Quantity,
        /// The largest precision tried.
        bits: u32,
        /// The open decision.
        what: &'static str,
    },
    /// The work that may be spent on an answer was spent before it was found.
    #[error(
        "the budget was spent, with {evaluations} evaluations of g in this arithmetic so far, before this was decided; a larger \
         budget, or a narrower range of contact radii, may decide it"
    )]
    BudgetSpent {
        /// Evaluations of g, of its slope and of its integral so far.
        evaluations: u64,
    },
    /// The computation was stopped by its caller.
    #[error("stopped before the end")]
    Stopped,
    /// Slices that belong together differ in length.
    #[error("{quantity}: {len} given for {expected} points")]
    Length {
        /// Which slice.
        quantity: Quantity,
        /// Its length.
        len: usize,
        /// That of the first.
        expected: usize,
    },
    /// A part of a range that a proof does not cover.
    #[error("nothing is proved of {quantity} between {} and {}: {remedy}", excerpt(from), excerpt(to))]
    Unproved {
        /// The quantity of which nothing is proved.
        quantity: Quantity,
        /// The lower end of that part.
        from: String,
        /// The upper end.
        to: String,
        /// A possible remedy.
        remedy: &'static str,
    },
}

impl Error {
    /// Whether all further evaluations end with this error, so that nothing is said of the one at which it came:
    /// [`Stopped`](Error::Stopped) or [`BudgetSpent`](Error::BudgetSpent).
    pub fn is_interruption(&self) -> bool {
        matches!(self, Error::Stopped | Error::BudgetSpent { .. })
    }

    /// An input outside its domain.
    pub fn domain<R: Real>(quantity: Quantity, value: &R, requirement: &'static str) -> Error {
        Error::Domain { quantity, value: printed(value), requirement }
    }

    /// No state at this value of the controlled quantity.
    pub fn no_equilibrium<R: Real>(quantity: Quantity, value: &R) -> Error {
        Error::NoEquilibrium { quantity, value: printed(value) }
    }

    /// A decision that the precision of `like` does not allow.
    pub fn undecided<R: Real>(quantity: Quantity, like: &R, what: &'static str) -> Error {
        Error::Undecided { quantity, bits: like.precision(), what }
    }

    /// Nothing proved between the ends of an interval.
    #[cfg(feature = "mp")]
    pub fn unproved(quantity: Quantity, over: &Interval, remedy: &'static str) -> Error {
        let [from, to] = [over.lower(), over.upper()].map(|end| end.to_string_radix(10, Some(17)));
        Error::Unproved { quantity, from, to, remedy }
    }

    /// Arrays of the expected length.
    ///
    /// # Errors
    /// [`Error::Length`] of the first that has another one.
    pub fn require_length(expected: usize, lengths: impl IntoIterator<Item = (Quantity, usize)>) -> Result<()> {
        let other = lengths.into_iter().find(|(_, len)| *len != expected);
        other.map_or(Ok(()), |(quantity, len)| Err(Error::Length { quantity, len, expected }))
    }

    /// Returns `value` if it is certainly positive and finite.
    ///
    /// # Errors
    /// [`Error::Domain`] otherwise.
    #[inline(always)]
    pub fn require_positive<R: Real>(quantity: Quantity, value: R) -> Result<R> {
        if value > value.lit(0) && value.is_finite() {
            Ok(value)
        } else {
            Err(Error::domain(quantity, &value, "positive and finite"))
        }
    }

    /// Checks that `value` is finite.
    ///
    /// # Errors
    /// [`Error::Domain`] otherwise.
    pub fn require_finite<R: Real>(quantity: Quantity, value: &R) -> Result<()> {
        if value.is_finite() { Ok(()) } else { Err(Error::domain(quantity, value, "finite")) }
    }
}

/// The nearest double, with an exponent where it would have more than a few zeros.
fn printed<R: Real>(value: &R) -> String {
    let digits = format!("{:?}", value.approx());
    digits.strip_suffix(".0").map_or(digits.clone(), str::to_owned)
}
