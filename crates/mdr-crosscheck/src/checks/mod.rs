//! The checks. To add one: a file with a `CHECK`, and its line in [`registry`].

mod bodies;
mod certified;
mod double;
mod dugdale;
mod energy;
mod equilibria;
mod folds;
mod gamma;
mod griffith;
mod identities;
mod inverse;
mod kappa;
mod known;
mod machine;
mod path;
mod printed;
mod profiles;
mod proof;
mod quadrature;
mod range;
mod scaling;
mod springs;
mod threshold;
mod universal;

use mdr_core::contact::Result;

use crate::options::Level;
use crate::report::Unit;
use crate::subject::SubjectId;
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
    /// The closed forms it would catch a mistake in.
    pub(crate) subjects: &'static [SubjectId],
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

/// The names of all checks, in the order of the report.
pub fn check_names() -> Vec<&'static str> {
    registry().iter().map(|check| check.name).collect()
}

/// The names of the checks that would catch a mistake in a closed form.
pub fn checks_of(id: SubjectId) -> Vec<&'static str> {
    registry().iter().filter(|check| check.subjects.contains(&id)).map(|check| check.name).collect()
}

/// Runs a generic case by turns in f64 and in arbitrary precision, each in its own rounds of the grid.
macro_rules! by_turns {
    ($trial:ident, $case:ident $(, $argument:expr)*) => {{
        let round = $trial.index / 2;
        if $trial.index % 2 == 0 {
            $case::<f64>($trial, round, () $(, $argument)*)
        } else {
            let precision = $trial.precision;
            $case::<rug::Float>($trial, round, precision $(, $argument)*)
        }
    }};
}
use by_turns;

/// All checks, in the order of the report.
pub(crate) fn registry() -> &'static [Check] {
    static CHECKS: &[Check] = &[
        gamma::LIBRARIES,
        bodies::BODIES,
        kappa::GAMMA,
        kappa::SERIES,
        kappa::AGM,
        kappa::PRODUCT,
        quadrature::KAPPA_RATIO,
        quadrature::POWER,
        profiles::LIBRARY,
        profiles::NAMED,
        folds::INDENTATION,
        folds::FORCE,
        folds::MACHINE,
        folds::PRINTED,
        proof::SEARCH,
        proof::CLOSED,
        proof::EQUILIBRIA,
        equilibria::BESIDE,
        inverse::EQUILIBRIA,
        energy::POTENTIAL,
        energy::ROUTES,
        springs::SPRINGS,
        universal::CURVES,
        threshold::BISECTION,
        threshold::STATES,
        double::DOUBLE_PRECISION,
        certified::ROUNDING,
        certified::PREFIX,
        certified::ENCLOSURE,
        range::DIGITS,
        range::ENCLOSURES,
        identities::CRITICAL,
        identities::SLOPES,
        identities::LOGARITHMS,
        griffith::CLOSED,
        griffith::JUMPS,
        path::BALANCE,
        path::LOSSES,
        path::ADMISSIBLE,
        machine::FOLDS,
        dugdale::PARABOLOID,
        dugdale::PROFILES,
        dugdale::PULL_OFF,
        printed::DIMENSIONS,
        known::JKR,
        known::KENDALL,
        known::PUNCH,
        path::FLAT_PUNCH,
        scaling::FORCE,
        scaling::LENGTH,
    ];
    CHECKS
}
