//! Answers with every digit proved.
//!
//! A [`Question`] contains exact rationals. [`Question::answer`] evaluates the closed forms over rigorous intervals and
//! raises the precision until all required digits are decided, from 1 to 10 000 and more.
//!
//! ```
//! use mdr_analytic::certified::{Elasticity, Question};
//! use mdr_core::contact::Control;
//! let [n, c, e_star, work] = ["1/4", "1", "1e6", "0.05"].map(|text| text.parse());
//! let question = Question::new(&n?, &c?, &Elasticity::Effective(e_star?), &work?, &Control::Indentation)?;
//! let answer = question.answer(20)?;
//! assert_eq!(answer.kappa.to_string(), "1.1635925712182693753");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Values that intervals cannot round
//! An interval cannot decide the rounding of a number that is exactly a decimal, a tie between two decimals, or zero.
//! The rational results, for rational inputs, are:
//!
//! * **κ_n** for even n = 2m is 4ᵐ/binom(2m, m); a terminating decimal only for n = 2 (2) and n = 6 (16/5), since for m ≥ 4
//!   a prime between m and 2m, at least 7, divides the denominator. For odd n it is a rational multiple of π.
//! * **Integer n, indentation or force.** N² is rational times π² (n odd) or rational (n even), and B is rational times π.
//!   So, up to algebraic factors, a is a power of π with the exponent −1/(2n−1) or 1/(2n−1), d with (n−1)/(2n−1) or
//!   n/(2n−1), and F with (n−2)/(2n−1) or (n+1)/(2n−1), for n odd or even. A rational power of π other than 0 times an
//!   algebraic number is transcendental; the exponent is 0 only in d for n = 1, the cone, where d = −w/(E*C) under fixed
//!   grips and 3w/(E*C) under a dead load. These are given exactly.
//! * **d = 0** only for n = 3/2 under a dead load. On a machine it would need λ = 2n, hence N²a^{2n−1} = 4n²B with a
//!   rational a, which for integer n contradicts the transcendence of π again.
//! * **n = 1/2, and half-integers in general**: κ is rational times ϖ, or rational times π/ϖ, and ϖ² is algebraic times
//!   Γ(1/4)⁴/π. π and Γ(1/4) are algebraically independent (Chudnovsky 1976), so thresholds, ratios and folds are
//!   transcendental. The same holds for Γ(1/3), and for κ_{1/4}, which is algebraic times a period of a curve with complex
//!   multiplication.
//!
//! For other n no theorem excludes a tie. None is expected; it would give [`Error::Undecided`] at a stated precision,
//! not an endless loop.
//!
//! [`Error::Undecided`]: mdr_core::contact::Error::Undecided

mod answer;
mod curve;
mod evaluate;
mod exact;
mod ledger;
mod monomial;
mod question;
mod root;
mod scaled;

pub use answer::Answer;
pub use curve::{CertifiedPoint, Curve};
pub use evaluate::kappa;
pub use ledger::{EnergySum, PathPoint};
pub use mdr_core::contact::Elasticity;
pub use question::Question;
pub use scaled::Scaled;
