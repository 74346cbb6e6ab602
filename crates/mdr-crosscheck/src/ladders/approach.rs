//! Approaches: sequences of inputs that tend to a limit where a question becomes hard, from the table `data/ladders.tsv`.

use std::sync::LazyLock;

use mdr_analytic::double;
use mdr_core::contact::{Control, Expression, Profile, Quantity, Result};

use super::{Family, Ladder};
use crate::subject::double::{material, planted};
use crate::subject::routine::Routine;
use crate::subject::routines;

/// base^k for k from `first` to `last`, which is always there: all of them, or a few.
fn values(base: i32, first: i32, last: i32, all: bool) -> Vec<f64> {
    let span = (last - first).abs();
    let step = match (base, all) {
        (2, true) => 1,
        (2, false) => 12,
        (_, true) => (span / 40).max(1),
        (_, false) => (span / 5).max(1),
    };
    // As typed: powi is off by many ulp at the ends of the range.
    let power = |k: i32| if base == 2 { 2_f64.powi(k) } else { format!("1e{k}").parse().unwrap_or(f64::NAN) };
    let end = (span % step != 0).then_some(span);
    (0..=span).step_by(step as usize).chain(end).map(|k| power(first + k * (last - first).signum())).collect()
}

/// A line of the table: how some functions are led towards a limit, or towards two.
pub(super) struct Approach {
    /// The functions, by name or by the beginning of it.
    functions: Vec<&'static str>,
    family: Family,
    toward: &'static str,
    axis: &'static str,
    /// The base of the values of t.
    base: i32,
    /// The first exponent of the base, and the last one of each sequence.
    first: i32,
    last: Vec<i32>,
    inputs: Vec<Expression>,
}

impl Approach {
    /// Reads a line; `None` if it cannot be read.
    fn read(line: &'static str) -> Option<Self> {
        let [functions, family, toward, axis, values, inputs]: [&str; 6] =
            line.split('\t').collect::<Vec<_>>().try_into().ok()?;
        let (base, exponents) = values.split_once('^')?;
        let (first, last) = exponents.split_once("..")?;
        let signs = match last.chars().next()? {
            '±' => [1, -1].as_slice(),
            '∓' => &[-1, 1],
            _ => &[1],
        };
        let last: i32 = last.trim_start_matches(['±', '∓']).parse().ok()?;
        Some(Approach {
            functions: functions.split(" | ").collect(),
            family: Family::ALL.into_iter().find(|known| known.name() == family)?,
            toward,
            axis,
            base: base.parse().ok()?,
            first: first.parse().ok()?,
            last: signs.iter().map(|sign| sign * last).collect(),
            inputs: inputs.split(", ").map(|input| input.parse().ok()).collect::<Option<_>>()?,
        })
    }

    fn leads(&self, name: &str) -> bool {
        self.functions.iter().any(|known| is_named(known, name))
    }

    /// The ladder of a function on the way to one of the last exponents, with all of its rungs or a few.
    pub(super) fn ladder(&self, routine: &Routine, last: i32, all: bool) -> Ladder {
        let values = values(self.base, self.first, last, all).into_iter();
        Ladder {
            function: routine.name.to_owned(),
            family: self.family,
            toward: self.toward.replace("{}", &last.to_string()),
            axis: self.axis.to_owned(),
            inputs: routine.inputs.iter().map(|name| (*name).to_owned()).collect(),
            naive: routine.textbook.map(|textbook| textbook.formula.to_owned()),
            rungs: values.map(|t| super::measure::rung(routine, t, &self.inputs_at(t))).collect(),
        }
    }

    fn inputs_at(&self, t: f64) -> Vec<f64> {
        self.inputs.iter().fold(Vec::new(), |mut inputs, expression| {
            let values = expression.parameters().map(|name| (name.clone(), value(&name, t, &inputs))).collect();
            let bound = expression.bind_numbers((), &values);
            inputs.push(bound.map_or(f64::NAN, |bound| bound.height(&t)));
            inputs
        })
    }
}

/// Whether a function has a name of the table.
fn is_named(known: &str, name: &str) -> bool {
    known.strip_suffix('*').map_or(name == known, |beginning| name.starts_with(beginning))
}

/// The value of a name in an expression after these inputs.
fn value(name: &str, t: f64, inputs: &[f64]) -> f64 {
    match (name, inputs) {
        ("t", _) => t,
        ("n", [n, ..]) => *n,
        ("planted", [n, ..]) => planted(*n),
        ("d_fold", [n, c, rest @ ..]) => critical(*n, *c, rest, &Control::Indentation).unwrap_or(f64::NAN),
        ("F_fold", [n, c, rest @ ..]) => critical(*n, *c, rest, &Control::Force).unwrap_or(f64::NAN),
        _ => f64::NAN,
    }
}

/// The critical value of the controlled quantity.
fn critical(n: f64, c: f64, bodies: &[f64], control: &Control<f64>) -> Result<f64> {
    let state = double::critical(n, c, &material(bodies)?, control)?;
    match control {
        Control::Force => state.force.value(Quantity::Force),
        _ => state.indentation.value(Quantity::Indentation),
    }
}

/// The approaches, in the blocks of the table.
static APPROACHES: LazyLock<Vec<Vec<Approach>>> = LazyLock::new(|| {
    let blocks = include_str!("../../data/ladders.tsv").split("\n\n");
    blocks.map(|block| block.lines().filter_map(Approach::read).collect()).collect()
});

/// Every function with an approach and its last exponent: block by block, and in each in the order of the functions.
pub(super) fn cases() -> Vec<(Routine, &'static Approach, i32)> {
    let mut cases = Vec::new();
    for block in APPROACHES.iter() {
        for routine in routines() {
            let along = block.iter().filter(|approach| approach.leads(routine.name));
            cases.extend(along.flat_map(|approach| approach.last.iter().map(move |last| (routine, approach, *last))));
        }
    }
    cases
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_is_read_and_leads_a_function_to_its_limit() {
        let all = routines();
        for line in include_str!("../../data/ladders.tsv").lines().filter(|line| !line.is_empty()) {
            let approach = Approach::read(line);
            assert_eq!(approach.is_none(), line.starts_with("# "), "{line}");
            let Some(approach) = approach else { continue };
            for known in &approach.functions {
                assert!(all.iter().any(|routine| is_named(known, routine.name)), "{known}");
            }
            let led = all.iter().find(|routine| approach.leads(routine.name)).unwrap();
            for t in approach.last.iter().flat_map(|last| values(approach.base, approach.first, *last, false)) {
                let inputs = approach.inputs_at(t);
                assert!(inputs.len() == led.inputs.len() && inputs.iter().all(|x| !x.is_nan()), "{line}");
            }
        }
    }
}
