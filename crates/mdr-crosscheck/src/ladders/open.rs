//! Ladders that are not accepted, and why.

use super::Ladder;

/// A ladder, or all whose names begin so, with at least one rung that is not accepted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Open {
    /// How the name of the function begins.
    pub function: &'static str,
    /// How its direction begins.
    pub toward: &'static str,
    /// What is lost there, and why it was left.
    pub why: &'static str,
}

impl Open {
    /// Whether this is one of the ladders meant.
    pub fn is(&self, ladder: &Ladder) -> bool {
        ladder.function.starts_with(self.function) && ladder.toward.starts_with(self.toward)
    }
}

const fn open(function: &'static str, toward: &'static str, why: &'static str) -> Open {
    Open { function, toward, why }
}

const HEIGHTS: &str =
    "a quadrature knows heights alone; where they are below 10^-308, their slope is 0, which is not said";
const NARROW: &str =
    "the tolerance of a quadrature is 32 roundoffs, and 16 times the rounding of the radius near an edge";

/// All of them. A test demands that each is still open.
pub const OPEN: &[Open] = &[
    open("Quadrature<Power>::slope", "x → 10^-300", HEIGHTS),
    open("Quadrature<Sphere>::slope", "x → 0", HEIGHTS),
    open("Quadrature<WavyParaboloid>::slope", "x → 0", HEIGHTS),
    open(
        "Quadrature<Sphere>",
        "all lengths → 10^-300",
        "heights at the lower end of the range have lost digits; 2.5 of ours at 10^-300",
    ),
    open("Quadrature<Power>", "C → 10^-300", NARROW),
    open("Quadrature<Sphere>::g", "x → R", NARROW),
    open("Quadrature<WavyParaboloid>", "λ → 0", "from some 350 waves on it says that it does not converge"),
    open(
        "Energy::release",
        "d → g(a)",
        "the derivative of an integral is known to a few roundings of the integral, not of itself, where it vanishes",
    ),
    open("Sum::integral", "all lengths → 10^300", "the log10 of an overflow is that of the first term that overflows"),
    open(
        "equilibria, fixed grips",
        "to the fold, n = 2",
        "1.07 digits at 2^-50 from the fold: twelve roundings of the terms of d",
    ),
];
