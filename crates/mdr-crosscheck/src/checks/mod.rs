//! The checks. To add one: a file with a `CHECK`, and its line in [`registry`].

mod bodies;
mod gamma;

use mdr_core::contact::Result;

use crate::options::Level;
use crate::report::Unit;
use crate::trial::Trial;

/// One comparison of the closed forms with something else, over many cases.
#[derive(Debug)]
pub(crate) struct Check {
    /// Stable name.
    pub(crate) name: &'static str,
    /// What is compared with what.
    pub(crate) claim: &'static str,
    /// The equations of the paper it covers.
    pub(crate) equations: &'static [&'static str],
    /// What its errors are measured in.
    pub(crate) unit: Unit,
    /// Cases at the levels quick, default and full.
    pub(crate) cases: [usize; 3],
    /// Runs one case.
    pub(crate) case: fn(&mut Trial<'_>) -> Result<()>,
}

impl Check {
    /// Cases at a level.
    pub(crate) fn budget(&self, level: Level) -> usize {
        self.cases[level as usize]
    }
}

/// All checks, in the order of the report.
pub(crate) fn registry() -> &'static [Check] {
    static CHECKS: [Check; 2] = [gamma::STATRS, bodies::BODIES];
    &CHECKS
}
