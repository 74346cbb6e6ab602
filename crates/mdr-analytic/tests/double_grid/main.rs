//! The kernel for many points against the generic closed form in 128 bits, with which it shares no code.
//!
//! The bounds are those that the documentation of the kernel derives. They are asserted from below too: an error far
//! below its bound would mean that the test does not reach the worst cases.
#![allow(clippy::unwrap_used, reason = "the helpers belong to the tests")]
#![allow(clippy::print_stdout, reason = "the errors measured are worth reading")]

mod answers;
mod errors;
mod limits;
mod outcomes;
mod points;
