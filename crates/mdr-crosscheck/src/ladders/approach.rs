//! Approaches: sequences of inputs that tend to a limit where a question becomes hard.

use super::{Family, Ladder};
use crate::subject::routine::Routine;

/// How many inputs an approach has.
#[derive(Clone, Copy, Debug)]
pub(super) struct Steps {
    /// All of them, not only a few.
    pub(super) all: bool,
}

impl Steps {
    /// A few.
    pub(super) const FEW: Steps = Steps { all: false };

    /// 2⁻ᵏ for k from `first` to `last`.
    pub(super) fn halvings(self, first: i32, last: i32) -> Vec<f64> {
        steps(first, last, if self.all { 1 } else { 12 }).map(|k| 2_f64.powi(-k)).collect()
    }

    /// 10ᵏ for k from `first` to `last`, up or down.
    pub(super) fn decades(self, first: i32, last: i32) -> Vec<f64> {
        let span = (last - first).abs();
        let step = if self.all { (span / 40).max(1) } else { (span / 5).max(1) };
        // As typed: powi is off by many ulp at the ends of the range.
        let power = |k: i32| format!("1e{k}").parse().unwrap_or(f64::NAN);
        steps(0, span, step).map(|k| power(if last > first { first + k } else { first - k })).collect()
    }
}

/// From `first` to `last`, which is always there.
fn steps(first: i32, last: i32, step: i32) -> impl Iterator<Item = i32> {
    let end = ((last - first) % step != 0).then_some(last);
    (first..=last).step_by(step as usize).chain(end)
}

/// Inputs that tend to a limit.
#[derive(Clone, Debug)]
pub(super) struct Approach {
    family: Family,
    toward: String,
    axis: &'static str,
    /// The parameter and the inputs.
    inputs: Vec<(f64, Vec<f64>)>,
}

impl Approach {
    /// The inputs of each parameter. `toward` is the limit in words, `axis` what the parameter is.
    pub(super) fn new(
        family: Family,
        toward: impl Into<String>,
        axis: &'static str,
        parameters: Vec<f64>,
        inputs: impl Fn(f64) -> Vec<f64>,
    ) -> Self {
        let inputs = parameters.into_iter().map(|t| (t, inputs(t))).collect();
        Approach { family, toward: toward.into(), axis, inputs }
    }

    /// From above with the parameters, from below with their negatives.
    pub(super) fn from_both_sides(
        family: Family,
        toward: &str,
        axes: [&'static str; 2],
        parameters: &[f64],
        inputs: impl Fn(f64) -> Vec<f64>,
    ) -> [Self; 2] {
        let [above, below] = axes;
        [
            Approach::new(family, format!("{toward} from above"), above, parameters.to_vec(), &inputs),
            Approach::new(family, format!("{toward} from below"), below, parameters.to_vec(), |t| inputs(-t)),
        ]
    }

    /// From 1 to 10^end, and to 10^−end.
    pub(super) fn to_both_ends(
        steps: Steps,
        family: Family,
        toward: impl Fn(i32) -> String,
        axis: &'static str,
        end: i32,
        inputs: impl Fn(f64) -> Vec<f64>,
    ) -> [Self; 2] {
        [end, -end].map(|end| Approach::new(family, toward(end), axis, steps.decades(0, end), &inputs))
    }

    /// Each of the inputs from the given place on to both ends of the range of doubles, around a base.
    pub(super) fn of_each_input(steps: Steps, names: &[&str], base: &[f64], from: usize) -> Vec<Self> {
        let small = if base[0] < 0.5 { ", n < 1/2" } else { "" };
        let alone = |index: usize| {
            let toward = |end| format!("{} → 10^{end}{small}", names[index]);
            Approach::to_both_ends(steps, Family::Scale, toward, "the input", 300, |t| {
                let mut inputs = base.to_vec();
                inputs[index] = t;
                inputs
            })
        };
        (from..base.len()).flat_map(alone).collect()
    }

    /// n → 1/2, 0 and ∞ as far as `reach` says, with inputs that follow n.
    pub(super) fn of_exponent(steps: Steps, reach: Reach, inputs: impl Fn(f64) -> Vec<f64>) -> Vec<Self> {
        let Reach { half, small, large: [first, last] } = reach;
        let axes = ["n − 1/2", "1/2 − n"];
        let [above, below] =
            Approach::from_both_sides(Family::Half, "n → 1/2", axes, &steps.halvings(2, half), |t| inputs(0.5 + t));
        vec![
            above,
            below,
            Approach::new(Family::SmallExponent, "n → 0", "n", steps.decades(-1, small), &inputs),
            Approach::new(Family::LargeExponent, "n → ∞", "n", steps.decades(first, last), &inputs),
        ]
    }

    /// With more inputs at the end.
    pub(super) fn followed_by(mut self, more: &[f64]) -> Self {
        self.inputs.iter_mut().for_each(|(_, inputs)| inputs.extend(more));
        self
    }
}

/// How far exponents go.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reach {
    /// To 1/2 ± 2⁻ᵏ.
    pub(super) half: i32,
    /// To 10ᵏ.
    pub(super) small: i32,
    /// From 10ʲ to 10ᵏ.
    pub(super) large: [i32; 2],
}

/// As far as doubles go.
pub(super) const FAR: Reach = Reach { half: 50, small: -290, large: [1, 14] };

/// A routine and an approach.
#[derive(Clone, Debug)]
pub(super) struct LadderCase {
    pub(super) routine: Routine,
    approach: Approach,
}

impl LadderCase {
    /// Answers its questions.
    pub(super) fn ladder(&self) -> Ladder {
        let LadderCase { routine, approach } = self;
        Ladder {
            function: routine.name.to_owned(),
            family: approach.family,
            toward: approach.toward.clone(),
            axis: approach.axis.to_owned(),
            inputs: routine.inputs.iter().map(|name| (*name).to_owned()).collect(),
            naive: routine.textbook.map(|textbook| textbook.formula.to_owned()),
            rungs: approach.inputs.iter().map(|(t, inputs)| super::measure::rung(routine, *t, inputs)).collect(),
        }
    }
}

/// Every routine along every approach.
pub(super) fn cross(routines: &[Routine], approaches: &[Approach]) -> Vec<LadderCase> {
    let cases =
        |&routine: &Routine| approaches.iter().map(move |approach| LadderCase { routine, approach: approach.clone() });
    routines.iter().flat_map(cases).collect()
}
