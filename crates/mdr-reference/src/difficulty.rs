//! The difficulty of a question for double precision, by published thresholds.

use std::str::FromStr;

use crate::named::named;
use crate::text::excerpt;

named! {
    /// The three levels of NIST's Statistical Reference Datasets.
    pub enum Difficulty {
        /// Any correct program computes it correctly.
        Lower = "lower",
        /// Digits are lost, or intermediate results need care.
        Average = "average",
        /// Few digits are left, or a naive program overflows, does not converge or finds the wrong state.
        Higher = "higher",
    }
}

impl FromStr for Difficulty {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let found = Difficulty::ALL.into_iter().find(|level| level.name() == text);
        found.ok_or_else(|| format!("difficulty must be lower, average or higher, got {}", excerpt(text)))
    }
}

/// The measures of difficulty. The difficulty is the highest level that one of the four reaches.
///
/// | measure | lower | average | higher |
/// |---|---|---|---|
/// | total condition | below 10 | below 10⁴ | from 10⁴ |
/// | relative distance to a fold | above 10⁻² | above 10⁻⁶ | up to 10⁻⁶ |
/// | largest \|log₁₀\| of inputs and value | below 30 | below 100 | from 100 |
/// | \|n − 1/2\| | from 1/16 | from 2⁻²⁰ | below 2⁻²⁰ |
///
/// Where there is no number, the question is at least of average difficulty.
///
/// ```
/// use mdr_reference::{Difficulty, DifficultyInputs};
/// let plain = DifficultyInputs::default();
/// assert_eq!(plain.difficulty(), Difficulty::Lower);
/// assert_eq!(DifficultyInputs { condition: 1e6, ..plain }.difficulty(), Difficulty::Higher);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DifficultyInputs {
    /// Σ|d ln value/d ln input|.
    pub condition: f64,
    /// The relative distance of the controlled quantity to its value at a fold; ∞ if that is irrelevant.
    pub fold_distance: f64,
    /// The largest |log₁₀| of the inputs and the value.
    pub decades: f64,
    /// |n − 1/2|; ∞ for a profile that is no power law, and for n = 1/2, which has formulas of its own.
    pub from_half: f64,
    /// Whether there is a number.
    pub is_number: bool,
}

impl Default for DifficultyInputs {
    /// The lowest difficulty.
    fn default() -> Self {
        let far = f64::INFINITY;
        DifficultyInputs { condition: 1.0, fold_distance: far, decades: 0.0, from_half: far, is_number: true }
    }
}

impl DifficultyInputs {
    /// The level.
    pub fn difficulty(&self) -> Difficulty {
        let higher = self.condition >= 1e4
            || self.fold_distance <= 1e-6
            || self.decades >= 100.0
            || self.from_half < 2_f64.powi(-20);
        let average = self.condition >= 10.0
            || self.fold_distance <= 1e-2
            || self.decades >= 30.0
            || self.from_half < 2_f64.powi(-4)
            || !self.is_number;
        match (higher, average) {
            (true, _) => Difficulty::Higher,
            (false, true) => Difficulty::Average,
            (false, false) => Difficulty::Lower,
        }
    }
}
