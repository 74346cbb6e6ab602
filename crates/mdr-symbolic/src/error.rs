//! Why an expression has no normal form, or a question about it no answer.

use thiserror::Error;

/// The result of an exact operation.
pub type Result<T> = std::result::Result<T, Error>;

/// What stops the exact algebra. Each is a refusal: nothing is guessed in its place.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Error {
    /// A divisor is identically zero.
    #[error("division by zero")]
    DivisionByZero,
    /// A real power of something that is not positive everywhere on the domain.
    #[error("a real power of {base}, which is not known to be positive for {domain}")]
    NotPositive {
        /// What was to be raised.
        base: String,
        /// Where.
        domain: &'static str,
    },
    /// A power that is no natural number, of a sum of several terms.
    #[error("a power {exponent} of a sum: only a single term has real powers")]
    PowerOfSum {
        /// The exponent.
        exponent: String,
    },
    /// An exponent that is no rational function of n alone.
    #[error("the exponent {0} is no rational function of n")]
    Exponent(String),
    /// A number or polynomial beyond the reach of the factorisation used here.
    #[error("{0} could not be split into irreducible factors")]
    Unfactored(String),
    /// An integral of a power that is no power, or that diverges at 0.
    #[error("the integral from 0 of {symbol} to the power {exponent} is no finite sum of powers")]
    Integral {
        /// The variable of integration.
        symbol: &'static str,
        /// Its power.
        exponent: String,
    },
    /// A value that is not known to be positive, in the place of a symbol on which more than integer powers act: what was
    /// simplified there took the symbol for positive.
    #[error(
        "{value} in the place of {symbol}: it is not known to be positive for {domain}, and {symbol} stands under a real power"
    )]
    Substitution {
        /// The replaced symbol.
        symbol: &'static str,
        /// What was to stand in its place.
        value: String,
        /// Where.
        domain: &'static str,
    },
    /// A value of n that does not lie in the domain on which the rest was simplified.
    #[error("n = {n} lies outside of the domain {domain}")]
    OutsideDomain {
        /// The value.
        n: String,
        /// Where.
        domain: &'static str,
    },
    /// A power, product or Gamma function too large to be written out.
    #[error("{0} is too large to be written out; take a smaller exponent")]
    TooLarge(String),
    /// A function that the algebra does not know; only intervals can speak about it.
    #[error("{0} is outside the algebra")]
    Transcendental(String),
    /// A text that is no formula.
    #[error("not a formula: {why} in `{text}`")]
    Syntax {
        /// What is wrong.
        why: String,
        /// The whole text.
        text: String,
    },
}
