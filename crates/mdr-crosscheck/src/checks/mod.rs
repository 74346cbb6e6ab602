//! The checks. To add one: a line in `data/checks.tsv`, which says what it compares, and in a module the function that runs
//! one of its cases, with its name in [`RUNS`].

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

use std::sync::LazyLock;

use mdr_core::contact::Result;

pub(crate) use self::certified::literal;
pub(crate) use self::kappa::by_series;

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
    pub(crate) equations: Vec<&'static str>,
    /// The closed forms it would catch a mistake in.
    pub(crate) subjects: Vec<SubjectId>,
    /// What its errors are measured in.
    pub(crate) unit: Unit,
    /// Cases at the levels quick, default and full.
    pub(crate) cases: [usize; 3],
    /// Runs one case.
    pub(crate) case: fn(&mut Trial<'_>) -> Result<()>,
}

/// The name of a check, and what runs one of its cases.
type Run = (&'static str, fn(&mut Trial<'_>) -> Result<()>);

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

/// Runs a generic case by turns in f64 and in arbitrary precision, each in its own rounds of the grid: of `every` so many
/// cases, two if nothing is said, the last is in arbitrary precision.
macro_rules! by_turns {
    (every $count:literal, $trial:ident, $case:ident $(, $argument:expr)*) => {{
        let (round, precision) = ($trial.index / $count, $trial.precision);
        match $trial.index % $count {
            turn if turn + 1 == $count => $case::<rug::Float>($trial, round, precision $(, $argument)*),
            turn => $case::<f64>($trial, ($count - 1) * round + turn, () $(, $argument)*),
        }
    }};
    ($trial:ident, $case:ident $(, $argument:expr)*) => {
        by_turns!(every 2, $trial, $case $(, $argument)*)
    };
}
use by_turns;

/// What runs each check.
const RUNS: &[Run] = &[
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

/// A line of the table; none where it cannot be read, or where nothing runs the check.
fn check(line: &'static str) -> Option<Check> {
    let cells: [&str; 8] = line.split('\t').collect::<Vec<_>>().try_into().ok()?;
    let [name, claim, equations, unit, quick, default, full, subjects] = cells;
    let cases = [quick, default, full].map(|count| count.parse().ok());
    let subjects: Option<Vec<_>> = subjects.split_whitespace().map(SubjectId::named).collect();
    Some(Check {
        name,
        claim,
        equations: equations.split_whitespace().collect(),
        subjects: subjects?.concat(),
        unit: Unit::ALL.into_iter().find(|known| known.to_string() == unit)?,
        cases: [cases[0]?, cases[1]?, cases[2]?],
        case: RUNS.iter().find(|(known, _)| *known == name)?.1,
    })
}

/// All checks, in the order of the report.
pub(crate) fn registry() -> &'static [Check] {
    static CHECKS: LazyLock<Vec<Check>> =
        LazyLock::new(|| include_str!("../../data/checks.tsv").lines().filter_map(check).collect());
    &CHECKS
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_of_the_table_is_a_check_and_every_check_has_a_line() {
        let named: Vec<_> = registry().iter().map(|check| check.name).collect();
        let lines = include_str!("../../data/checks.tsv").lines().filter(|line| !line.starts_with('#'));
        assert_eq!(named, lines.map(|line| line.split('\t').next().unwrap_or_default()).collect::<Vec<_>>());
        let run: std::collections::BTreeSet<_> = RUNS.iter().map(|(name, _)| *name).collect();
        assert_eq!(run, named.into_iter().collect());
    }
}
