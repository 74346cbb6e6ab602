//! The checks. To add one: a line in `data/checks.tsv`, which describes the comparison, and in a module the function that
//! runs one of its cases, with its name in [`RUNS`].

mod certified;
mod common;
mod containment;
mod double;
mod dugdale;
mod energy;
mod equilibria;
mod folds;
mod graded;
mod half_space;
mod hysteresis;
mod identities;
mod kappa;
mod known;
mod line;
mod machine;
mod media;
mod path;
mod profiles;
mod proof;
mod quadrature;
mod range;
mod rigorous;
mod threshold;
mod wave;

use std::sync::LazyLock;

use rug::Float;

pub(crate) use self::common::literal;
pub(crate) use self::kappa::{by_series, ln_kappa};

use crate::grid::Held;
use crate::report::{CheckRow, CheckVerdict, ErrorUnit};
use crate::subject::SubjectId;
use crate::subject::profiles::NAMES;
use crate::trial::Case;

/// One comparison of the closed forms with something else, over many cases.
#[derive(Debug)]
pub(crate) struct Check {
    /// Its row of a report before any case.
    pub(crate) row: CheckRow,
    /// The closed forms it would catch a mistake in.
    subjects: Vec<SubjectId>,
    /// Cases at the levels quick, default and full.
    pub(crate) cases: [usize; 3],
    /// Runs one case.
    pub(crate) case: Case,
}

/// The names of all checks, in the order of the report.
pub fn check_names() -> Vec<&'static str> {
    registry().iter().map(|check| check.row.check.as_str()).collect()
}

/// The names of the checks that would catch a mistake in a closed form.
pub fn checks_of(id: SubjectId) -> Vec<&'static str> {
    registry().iter().filter(|check| check.subjects.contains(&id)).map(|check| check.row.check.as_str()).collect()
}

/// Runs a generic case by turns in f64 and in arbitrary precision, each in its own rounds of the grid: of `every` so many
/// cases, by default two, the last is in arbitrary precision. Or `all profiles` in one arithmetic, then in the other.
macro_rules! by_turns {
    (every $count:literal, $module:ident::$case:ident $(, $argument:expr)*) => {
        |trial| {
            let (round, precision) = (trial.index / $count, trial.precision);
            match trial.index % $count {
                turn if turn + 1 == $count => $module::$case::<Float>(trial, round, precision $(, $argument)*),
                turn => $module::$case::<f64>(trial, ($count - 1) * round + turn, () $(, $argument)*),
            }
        }
    };
    (all profiles, $module:ident::$case:ident) => {
        |trial| {
            let (round, precision) = (trial.index / NAMES.len(), trial.precision);
            match round % 2 {
                0 => $module::$case::<f64>(trial, round, ()),
                _ => $module::$case::<Float>(trial, round, precision),
            }
        }
    };
    ($($case:tt)*) => {
        by_turns!(every 2, $($case)*)
    };
}

/// The function that runs a case, for each check. Tests within this library run none: what only checks ask for would be compiled into
/// them a second time, which takes a minute.
#[cfg(test)]
const RUNS: &[(&str, Case)] = &[];

/// The function that runs a case, for each check.
#[cfg(not(test))]
const RUNS: &[(&str, Case)] = &[
    ("gamma-libraries", kappa::libraries),
    ("effective-modulus", known::effective_modulus),
    ("kappa-gamma", by_turns!(kappa::against, kappa::by_gamma)),
    ("kappa-series", by_turns!(kappa::against, kappa::middle_of_series)),
    ("kappa-agm", by_turns!(kappa::agm)),
    ("kappa-product", by_turns!(kappa::product)),
    ("kappa-quadrature", by_turns!(quadrature::kappa)),
    ("transform-quadrature", by_turns!(quadrature::power)),
    ("profile-library", by_turns!(all profiles, profiles::parts)),
    ("named-power-laws", by_turns!(profiles::named)),
    ("critical-indentation", by_turns!(folds::critical, Held::Indentation)),
    ("critical-force", by_turns!(folds::critical, Held::Force)),
    ("critical-machine", by_turns!(folds::machine)),
    ("printed-1.15-numerically", by_turns!(folds::printed)),
    ("proved-folds-against-search", proof::search),
    ("proved-folds-closed-form", proof::closed),
    ("proved-equilibria", proof::equilibria),
    ("equilibria-beside-the-fold", by_turns!(every 5, equilibria::beside)),
    ("equilibria-at-a-value", by_turns!(every 5, equilibria::equilibria)),
    ("energy-quadrature", by_turns!(every 8, energy::potential)),
    ("energy-route-against-force-route", energy::routes),
    ("spring-foundation", folds::foundation),
    ("half-space-kernel", half_space::kernel),
    ("universal-curves", by_turns!(quadrature::curves)),
    ("threshold-by-bisection", by_turns!(threshold::bisection)),
    ("scale-free-states", by_turns!(threshold::states)),
    ("double-precision", double::functions),
    ("certified-rounding", certified::rounding),
    ("certified-prefix", certified::prefix),
    ("kappa-enclosure", certified::enclosure),
    ("certified-range", range::digits),
    ("enclosure-range", range::enclosures),
    ("few-bits-power-laws", containment::power_laws),
    ("few-bits-profiles", containment::profiles),
    ("profile-library-proved", rigorous::profiles),
    ("critical-state-in-its-equations", by_turns!(identities::critical)),
    ("slopes-of-equilibria", by_turns!(identities::slopes)),
    ("logarithms-of-critical-states", by_turns!(identities::logarithms)),
    ("energy-closed-form", by_turns!(energy::stationary)),
    ("jump-work-closed-form", by_turns!(energy::jumps)),
    ("path-energy-balance", by_turns!(every 8, path::balance)),
    ("path-losses", by_turns!(every 8, path::losses)),
    ("path-admissible", path::admissible),
    ("hysteresis-loop", by_turns!(every 8, hysteresis::loops)),
    ("machine-folds-in-their-equations", by_turns!(machine::folds)),
    ("maugis-dugdale-paraboloid", by_turns!(dugdale::paraboloid)),
    ("maugis-dugdale-profiles", by_turns!(all profiles, dugdale::profile)),
    ("maugis-dugdale-pull-off", dugdale::pull_off),
    ("graded-transform", by_turns!(graded::kappa)),
    ("graded-kernel", graded::kernel),
    ("graded-states", by_turns!(graded::states)),
    ("graded-folds", by_turns!(graded::folds)),
    ("graded-route", by_turns!(every 5, media::graded)),
    ("line-kernel", by_turns!(every 5, line::kernel)),
    ("line-states", by_turns!(every 5, line::states)),
    ("line-route", by_turns!(every 5, media::line)),
    ("wave-kernel", wave::kernel),
    ("wave-states", by_turns!(wave::states)),
    ("wave-folds", by_turns!(wave::folds)),
    ("wave-route", by_turns!(every 5, media::wave)),
    ("wave-thresholds", wave::thresholds),
    ("printed-1.15-dimensions", by_turns!(identities::dimensions)),
    ("jkr", by_turns!(known::jkr)),
    ("kendall-limit", by_turns!(known::kendall)),
    ("kendall-flat-punch", by_turns!(known::punch)),
    ("flat-punch", by_turns!(path::flat_punch)),
    ("unit-of-force", by_turns!(identities::unit_of_force)),
    ("unit-of-length", by_turns!(identities::unit_of_length)),
];

/// Reads a line of the table; `None` if it cannot be read, or if nothing runs the check.
fn check(line: &'static str) -> Option<Check> {
    let cells: [&str; 8] = line.split('\t').collect::<Vec<_>>().try_into().ok()?;
    let [name, claim, equations, unit, quick, default, full, subjects] = cells;
    let cases = [quick, default, full].map(|count| count.parse().ok());
    let subjects: Option<Vec<_>> = subjects.split_whitespace().map(SubjectId::named).collect();
    Some(Check {
        row: CheckRow {
            check: name.to_owned(),
            claim: claim.to_owned(),
            equations: equations.split_whitespace().map(str::to_owned).collect(),
            unit: ErrorUnit::ALL.into_iter().find(|known| known.name() == unit)?,
            cases: 0,
            skipped: 0,
            failed: 0,
            worst: None,
            tightest: None,
            verdict: CheckVerdict::Skipped,
            errors: Vec::new(),
        },
        subjects: subjects?.concat(),
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
