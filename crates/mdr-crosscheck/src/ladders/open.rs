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

/// All of them: none. A test demands that nothing else is, and that each is still open.
pub const OPEN: &[Open] = &[];
