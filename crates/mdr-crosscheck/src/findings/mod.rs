//! Error against run time and the stability ladders together: the page and the data of `mdr report`.
//!
//! ```no_run
//! use mdr_crosscheck::{Findings, Level};
//! use mdr_crosscheck::work_precision::Clock;
//! let findings = Findings::new(Level::Quick, Clock::Runs(3), |what| eprintln!("{what}"))?;
//! println!("{}", findings.page("as an example, with medians of 3 runs"));
//! # Ok::<(), mdr_core::contact::Error>(())
//! ```

mod page;
mod rows;

use mdr_core::contact::Result;

pub use self::rows::{FindingLine, LadderRow, PointRow};
use crate::Level;
use crate::ladders::{Ladder, ladders};
use crate::work_precision::{Clock, Comparison, TASKS, Task};

/// All comparisons and all ladders.
#[non_exhaustive]
pub struct Findings {
    /// The comparisons of each task.
    pub tasks: Vec<(Task, Vec<Comparison>)>,
    /// The ladders.
    pub ladders: Vec<Ladder>,
}

impl Findings {
    /// Parts of a run: the tasks, and the ladders.
    pub const PARTS: usize = TASKS.len() + 1;

    /// Runs all comparisons and ladders; `begin` gets the name of each part when it begins.
    ///
    /// # Errors
    /// Errors of [`Task::comparisons`].
    pub fn new(level: Level, clock: Clock, mut begin: impl FnMut(&'static str)) -> Result<Self> {
        let mut tasks = Vec::with_capacity(TASKS.len());
        for task in TASKS {
            begin(task.name);
            tasks.push((task, task.comparisons(level, clock)?));
        }
        begin("stability ladders");
        Ok(Findings { tasks, ladders: ladders(level) })
    }

    /// The comparisons of all tasks.
    pub fn comparisons(&self) -> impl Iterator<Item = &Comparison> {
        self.tasks.iter().flat_map(|(_, comparisons)| comparisons)
    }
}
