//! The options of a run: how many cases, how many digits, which seed, which part.

use std::fmt;
use std::str::FromStr;

use mdr_core::named;
use mdr_core::number::Precision;
use serde::{Deserialize, Serialize};
use thiserror::Error;

named! {
    /// How many cases each check takes. The cases of a level are the first ones of the next level.
    #[derive(Default, Serialize, Deserialize)]
    #[serde(rename_all = "lowercase")]
    pub enum Level {
        /// Seconds.
        Quick = "quick",
        /// A minute or two.
        #[default]
        Default = "default",
        /// A quarter of an hour or so.
        Full = "full",
    }
}

/// One of several parts of a run that share no case and together are the whole: part `index` of `count`, from 1.
///
/// Case k of a check belongs to the part k mod `count` + 1.
///
/// ```
/// use mdr_crosscheck::Shard;
/// let shard: Shard = "2/3".parse()?;
/// assert_eq!((0..9).filter(|case| shard.holds(*case)).collect::<Vec<_>>(), [1, 4, 7]);
/// assert!("4/3".parse::<Shard>().is_err());
/// # Ok::<(), mdr_crosscheck::ShardError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Shard {
    index: u32,
    count: u32,
}

/// A text that is no part `I/N` with 1 ≤ I ≤ N.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("a shard must be I/N with 1 <= I <= N, got {0:?}")]
pub struct ShardError(String);

impl Shard {
    /// All cases.
    pub const WHOLE: Shard = Shard { index: 1, count: 1 };

    /// Part `index` of `count`, or nothing unless 1 ≤ `index` ≤ `count`.
    pub fn new(index: u32, count: u32) -> Option<Shard> {
        (1..=count).contains(&index).then_some(Shard { index, count })
    }

    /// Which part, from 1.
    pub fn index(self) -> u32 {
        self.index
    }

    /// How many parts there are.
    pub fn count(self) -> u32 {
        self.count
    }

    /// Whether the case of this index is in this part.
    pub fn holds(self, case: usize) -> bool {
        case % self.count as usize == self.index as usize - 1
    }
}

impl FromStr for Shard {
    type Err = ShardError;

    fn from_str(text: &str) -> Result<Self, ShardError> {
        let part = |text: &str| text.trim().parse::<u32>().ok();
        text.split_once('/')
            .and_then(|(index, count)| Shard::new(part(index)?, part(count)?))
            .ok_or_else(|| ShardError(text.to_owned()))
    }
}

impl TryFrom<String> for Shard {
    type Error = ShardError;
    fn try_from(text: String) -> Result<Self, ShardError> {
        text.parse()
    }
}

impl From<Shard> for String {
    fn from(shard: Shard) -> String {
        shard.to_string()
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

/// The options of a run. The result is a pure function of them, whatever the number of threads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// How many cases.
    pub level: Level,
    /// Decimal digits of the arbitrary-precision cases.
    pub digits: u32,
    /// Seed of the random part of the grid.
    pub seed: u64,
    /// Which part of the cases.
    pub shard: Shard,
    /// Only the checks of these names, when there are any.
    pub only: Vec<String>,
    /// At most so many cases a check (before sharding).
    pub limit: Option<usize>,
}

impl Default for Options {
    fn default() -> Self {
        Options { level: Level::Default, digits: 50, seed: 0, shard: Shard::WHOLE, only: Vec::new(), limit: None }
    }
}

impl Options {
    /// The defaults at a level.
    pub fn at(level: Level) -> Self {
        Options { level, ..Options::default() }
    }

    /// The precision of the arbitrary-precision cases: that of the digits asked for, and at least the 38 digits in which
    /// every input of the grid is exact and 1/2 ± 2⁻⁵⁰ still leaves digits.
    pub fn precision(&self) -> Precision {
        Precision::from_digits(self.digits.max(38))
    }
}
