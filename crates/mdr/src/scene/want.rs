//! The arithmetic of a scene, and its limits.

use crate::answer::Promise;

/// The most digits that may be requested.
pub const MAX_DIGITS: u32 = 100_000;

/// The default number of digits of a certified answer.
pub const DEFAULT_DIGITS: u32 = 20;

/// The arithmetic of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Arithmetic {
    /// Every digit is proved where that can be; elsewhere numbers are doubles, which the answer says.
    Certified {
        /// Significant decimal digits.
        digits: u32,
    },
    /// Hardware numbers.
    F64,
}

impl Arithmetic {
    /// The requested promise.
    pub fn promise(self) -> Promise {
        match self {
            Arithmetic::Certified { .. } => Promise::Certified,
            Arithmetic::F64 => Promise::F64,
        }
    }

    /// The requested significant decimal digits; `None` in f64.
    pub fn digits(self) -> Option<u32> {
        match self {
            Arithmetic::Certified { digits } => Some(digits),
            Arithmetic::F64 => None,
        }
    }
}

impl Default for Arithmetic {
    fn default() -> Self {
        Arithmetic::Certified { digits: DEFAULT_DIGITS }
    }
}

/// The most rows of one output, states times radii: each takes up to 4 kB of memory.
pub const MOST_ROWS: u32 = 100_000;

/// The most way points of a path.
pub const MOST_WAY_POINTS: usize = 10_000;
