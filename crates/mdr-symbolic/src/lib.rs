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
//! * the symbols E*, w, C, a, κ, …, which represent independent positive numbers ([`Symbol`]).
//!
//! An exponent splits uniquely into n times a polynomial, a constant q and a proper fraction. For primes and
//! polynomials q lies in [0, 1); the remaining integer powers belong to the coefficient. So 4ⁿ and 2²ⁿ, 6ⁿ and 2ⁿ3ⁿ,
//! √12 and 2√3 are equal values. A [`Quotient`] of two expressions is compared by cross-multiplication.
//!
//! # What is proved, and where
//!
//! A statement is made on a [`Domain`]: n > 0, n > 1/2, 0 < n < 1/2 or n = 1/2, and for all positive values of all
//! symbols. At n = 1/2 the number is substituted for n before anything else, and the cases differ in the ratio ρ of C
//! to its threshold, a symbol like the others.
//!
//! A proved statement is true at every point of the domain at which both sides, as written, have a value: (2n − 1)/(2n
//! − 1) is 1 for n > 0, with n = 1/2 excluded by the left side itself.
//!
//! **Equal normal forms prove equality.** Every rule that leads to a normal form is an identity of real functions
//! wherever both of its sides have a value: the field operations of Q(n), b^e b^f = b^(e+f), (b^e)^f = b^(ef) and
//! (bc)^e = b^e c^e for positive b, c. The sine has its values at the multiples of π/6 and π/4. A real power of an
//! expression of unknown sign is an error ([`Error::NotPositive`]); signs of polynomials on a domain are decided by
//! Sturm's theorem. In the same way cos²θ = 1 − sin²θ is used where two normal forms differ.
//!
//! **A value substituted for a symbol** must be positive on the domain, as is assumed of the symbol when √(a²) becomes
//! a. A value of unknown sign, or 0, is accepted only if the four operations and integer powers are all that acts on
//! the symbol in the formula as written; otherwise it is an error ([`Error::Substitution`]). A value substituted for n
//! must lie in the domain, which at n = 1/2 is 1/2 itself ([`Error::OutsideDomain`]).
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
//! This does not apply to symbols that are *not* independent. sinθ, cosθ and θ belong to one angle 0 < θ < π/2; κ_n,
//! Γ(n/2) and Γ((n+1)/2) to one n, and at n = 1/2 κ_n to Γ(3/4). If terms differ in two members of such a family, the
//! result is [`Undecided::HiddenRelation`], and intervals are needed. An equality proved with κ as a symbol is valid
//! for κ_n; if κ is the only member, a difference shows that the two sides are not equal for every κ. For κ_n itself
//! that is shown by its value at one point, which rigorous arithmetic provides ([`formula::Evaluator`]). g, g', ∫g and
//! ∫g² represent their values at a radius, which are independent as the profile is arbitrary; a difference shows that
//! the two sides are not equal for every profile. All other symbols are free numbers, also those to which the text of a
//! derivation gives a value: t, s, ρ, μ, y, Λ. The value is substituted with `at` where it is used.
//!
//! **A divisor whose normal form is 0** is 0 on the whole domain: a formula that divides by it has a value nowhere,
//! whatever the rest of it is ([`Statement::divides_by_zero`]). Then nothing can be proved or refuted. The divisors are
//! those of the formula as written: x²/x² has no value at x = 0, although its normal form is 1. Below an integral it is one
//! if it is 0 along the whole range. A base is one unless its exponent is certainly positive or is written as a natural
//! number, and so is a pole of Γ. A divisor that is 0 by cos²θ = 1 − sin²θ is 0; where another relation of symbols leaves
//! that open, the statement stays open too ([`Error::Divisor`]).
//!
//! **A value for one of several that belong together**, for g while g' or ∫g occurs, is refused ([`Error::Related`]), and so is
//! a derivative or an integral along it: ∂(sin²θ + cos²θ)/∂sinθ would hold cosθ fixed.
//!
//! A sign ([`Expression::sign_on`]) is proved if the coefficients of all terms have it on the whole domain, and is
//! undecided otherwise.
//!
//! The crate uses no floating-point numbers.

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
mod relations;
mod special;
mod statement;
mod symbol;
mod table;

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

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
