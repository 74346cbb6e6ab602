//! Why an expression has no normal form, or a statement no decision.

use thiserror::Error;

/// The result of an exact operation.
pub type Result<T> = std::result::Result<T, Error>;

/// The limits of the exact algebra. An operation beyond them fails; it never guesses.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Error {
    /// A divisor is identically zero.
    #[error("division by zero")]
    DivisionByZero,
    /// A divisor that may be identically zero by a relation of its symbols which the algebra does not include.
    #[error("the divisor {0} may be zero by a relation of its symbols: write it with one of them")]
    Divisor(String),
    /// A real power of an expression that is not positive everywhere on the domain.
    #[error("a real power of {base}, which is not known to be positive for {domain}")]
    NotPositive {
        /// The base.
        base: String,
        /// The domain.
        domain: &'static str,
    },
    /// A power of a sum of several terms that is not a natural number.
    #[error("a power {exponent} of a sum: only a single term has real powers")]
    PowerOfSum {
        /// The exponent.
        exponent: String,
    },
    /// An exponent that is not a rational function of n alone.
    #[error("the exponent {0} is no rational function of n")]
    Exponent(String),
    /// A number or polynomial that the factorisation used here cannot split.
    #[error("{0} could not be split into irreducible factors")]
    Unfactored(String),
    /// An integral of a power that is not a power, or that diverges at 0.
    #[error("the integral from 0 of {symbol} to the power {exponent} is no finite sum of powers")]
    Integral {
        /// The variable of integration.
        symbol: &'static str,
        /// Its power.
        exponent: String,
    },
    /// A value that is not known to be positive, substituted for a symbol under more than integer powers:
    /// simplification there has assumed that the symbol is positive.
    #[error(
        "{value} in the place of {symbol}: it is not known to be positive for {domain}, and {symbol} stands under a real power"
    )]
    Substitution {
        /// The replaced symbol.
        symbol: &'static str,
        /// The value.
        value: String,
        /// The domain.
        domain: &'static str,
    },
    /// A value in the place of a symbol while another one occurs that is determined by it.
    #[error("a value in the place of {symbol} while {relative} occurs, which belongs to it: give both, in one formula")]
    Related {
        /// The replaced symbol.
        symbol: &'static str,
        /// The one that belongs to it.
        relative: &'static str,
    },
    /// A value of n outside the domain on which the rest was simplified.
    #[error("n = {n} lies outside of the domain {domain}")]
    OutsideDomain {
        /// The value.
        n: String,
        /// The domain.
        domain: &'static str,
    },
    /// A power, product or Gamma function that is too large to expand.
    #[error("{0} is too large to be written out; take a smaller exponent")]
    TooLarge(String),
    /// A function outside the algebra; only intervals can evaluate it.
    #[error("{0} is outside the algebra")]
    Transcendental(String),
    /// A text that is not a formula.
    #[error("not a formula: {why} in `{text}`")]
    Syntax {
        /// The reason.
        why: String,
        /// The whole text.
        text: String,
    },
}
