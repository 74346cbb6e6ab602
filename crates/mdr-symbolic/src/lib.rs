//! Exact algebra for the theory of adhesion instabilities, and the derivations it proves.
//!
//! ```
//! use mdr_symbolic::{Decision, Domain, Statement};
//! // The critical contact radius (1.15) with its exponent corrected fulfils the condition of instability (1.14).
//! let statement: Statement = "at(diff(d_n, a), a, (B/N^2)^(1/(2*n - 1))) = 0".parse()?;
//! assert!(matches!(statement.decide(Domain::Below), Decision::Proved { .. }));
//! # Ok::<(), mdr_symbolic::Error>(())
//! ```
//!
//! # The normal form
//!
//! An [`Expression`] is a finite sum Σ c(n) Π bᵢ^eᵢ(n). Coefficients and exponents are rational functions of n with
//! rational coefficients, in lowest terms ([`RationalFunction`]). The bases are
//!
//! * the prime numbers,
//! * irreducible primitive polynomials in n, with the sign that makes them positive on the domain: 2n − 1 above n = 1/2,
//!   1 − 2n below,
//! * π,
//! * the symbols E*, w, C, a, κ, …, which stand for independent positive numbers ([`Symbol`]).
//!
//! An exponent splits uniquely into n times a polynomial, a constant q and a proper fraction. For primes and polynomials
//! q lies in [0, 1); the integer powers beyond belong to the coefficient. So 4ⁿ and 2²ⁿ, 6ⁿ and 2ⁿ3ⁿ, √12 and 2√3 are
//! equal values. A [`Quotient`] of two expressions is compared by cross-multiplication.
//!
//! # What is proved, and where
//!
//! A statement is made on a [`Domain`]: n > 0, n > 1/2, 0 < n < 1/2 or n = 1/2, and for all positive values of all
//! symbols. At n = 1/2 the number is put in the place of n before anything else, and what distinguishes the cases is the
//! ratio ρ of C to its threshold, a symbol like the others.
//!
//! **Equal normal forms prove equality.** Every rule that leads to a normal form is an identity of real functions on the
//! domain: the field operations of Q(n), b^e b^f = b^(e+f), (b^e)^f = b^(ef) and (bc)^e = b^e c^e for positive b, c. A
//! real power of something whose sign is not known is refused ([`Error::NotPositive`]); signs of polynomials on a domain
//! are decided by Sturm's theorem.
//!
//! **Different normal forms prove inequality**, as functions of n and of the symbols.
//!
//! 1. Powers of independent positive symbols with different exponents are linearly independent over the functions of n.
//!    So it is enough to look at terms with the same powers of all symbols.
//! 2. Let such a sum of c(n) exp φ(n) vanish, with φ = Σ eᵢ(n) ln bᵢ. By the structure theorem for exponentials of
//!    elementary functions (Ax; Risch) the sum splits into parts that vanish by themselves, within each of which the φ
//!    differ only by constants and rational multiples of ln bᵢ, bᵢ a polynomial. As the logarithms of primes and of π are
//!    linearly independent over Q (π is transcendental), the exponents in one part differ by rational constants only.
//! 3. Within a part: different fractional powers of different irreducible polynomials are linearly independent over C(n)
//!    (Kummer), powers of π over the algebraic numbers (Lindemann), different fractional powers of primes over Q
//!    (Besicovitch). Hence all c(n) are 0, which the normal form excludes.
//!
//! This says nothing about a symbol that is *not* independent. κ_n and Γ(n/2) are functions of n: an equality proved with
//! them as symbols holds for them; a difference says that the two sides are not equal for every κ. A statement that is
//! refuted in this sense is refuted for κ_n itself by its value at one point, which rigorous arithmetic provides
//! ([`formula::Arithmetic`]).
//!
//! A sign ([`Expression::sign_on`]) is proved when the coefficients of all terms have it on the whole domain. Otherwise
//! nothing is said.
//!
//! There is no floating-point number in this crate.

#![forbid(unsafe_code)]

mod calculus;
pub mod derivations;
mod dimension;
mod domain;
mod error;
mod expression;
pub mod formula;
mod monomial;
mod polynomial;
mod print;
mod quotient;
mod rational_function;
mod statement;
mod symbol;

pub use dimension::Dimension;
pub use domain::Domain;
pub use error::{Error, Result};
pub use expression::Expression;
pub use formula::Formula;
pub use monomial::{Base, Monomial};
pub use polynomial::Polynomial;
pub use quotient::Quotient;
pub use rational_function::RationalFunction;
pub use statement::{Decision, Relation, Statement, Undecided, Witness};
pub use symbol::Symbol;
