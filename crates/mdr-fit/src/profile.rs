//! Intervals of the free numbers by the profile of the sum of squares.
//!
//! With one number given, the others are fitted again: S(p) is the least sum of squares at p. An interval of the level 1 − α holds
//! the p with S(p) − S ≤ q·s², s² being the variance of a residual and q the quantile of χ² with one degree of freedom, or of
//! F(1, dof) where s² is that of the residuals (Bates and Watts, *Nonlinear Regression Analysis*, 1988, § 6.1; Venzon and
//! Moolgavkar 1988). For a linear model the ends are the estimate ± √q standard errors.

use mdr_core::calculus::roots::{self, Bracket, Sample};
use mdr_core::contact;
use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

use super::answer::{Fit, LikelihoodInterval};
use super::errors::Errors;
use super::minimise::{self, Minimum};
use super::objective::Objective;
use super::problem::Problem;

/// The levels that are given.
const LEVELS: [f64; 2] = [0.68, 0.95];

/// The relative tolerance of the distance from the estimate to an end.
const TOLERANCE: f64 = 1e-7;

/// How often the distance from the estimate doubles before the interval is open.
const DOUBLINGS: i32 = 7;

/// How many evaluations of the curve all intervals may take.
const BUDGET: usize = 12_000;

/// The rise of the sum of squares at an end, against itself, below which it is lost in rounding.
const RESOLVED: f64 = 1e-10;

/// Adds the intervals of the numbers that no bound holds; `stated` is whether σ is. Those that are left out are named in a warning.
pub(super) fn add(fit: &mut Fit, errors: &Errors<'_>, minimum: &Minimum, stated: bool) {
    let (objective, deviation) = (errors.objective, errors.scales[0]);
    let mut budget = BUDGET;
    let mut left: Vec<String> = Vec::new();
    for place in errors.kept {
        let name = &objective.parameter(*place).name;
        let Some(stderr) = fit.parameters[*place].stderr.filter(|stderr| *stderr > 0.0) else { continue };
        let slope = errors.slope(*place).abs();
        for level in LEVELS {
            let tail = 0.5 * (1.0 + level);
            let quantile = match StudentsT::new(0.0, 1.0, fit.dof as f64).ok().filter(|_| !stated) {
                Some(student) => student.inverse_cdf(tail),
                None => Normal::standard().inverse_cdf(tail),
            };
            if budget == 0 {
                left.push(format!("`{name}` at {level}"));
                continue;
            }
            if !((deviation * quantile).powi(2) > RESOLVED * minimum.evaluation.cost()) {
                fit.warnings.push(
                    "intervals by profile likelihood are not given: σ is so small against the residuals that the rise of the sum of squares \
                     is lost in rounding"
                        .to_owned(),
                );
                return;
            }
            let mut ends = [-1.0, 1.0].map(|direction| {
                let mut profile = Profile::new(objective, minimum, *place, deviation * quantile);
                profile.budget = budget;
                let end = profile.end(direction * stderr / slope, quantile);
                if profile.lowest < minimum.evaluation.cost() * (1.0 - 1e-6) - 1e-6 * (deviation * quantile).powi(2) {
                    fit.warnings.push(format!(
                        "the sum of squares is smaller at other values of `{name}`: the estimates are not its least; give a start"
                    ));
                }
                budget = profile.budget;
                end
            });
            if budget == 0 {
                left.push(format!("`{name}` at {level}"));
                continue;
            }
            if ends.iter().flatten().count() == 2 && ends[0] > ends[1] {
                ends.swap(0, 1);
            }
            fit.intervals.push(LikelihoodInterval { name: name.clone(), level, lower: ends[0], upper: ends[1] });
        }
    }
    if !left.is_empty() {
        fit.warnings.push(format!(
            "{BUDGET} evaluations of the curve were not enough for all intervals by profile likelihood: left out are {}",
            left.join(", ")
        ));
    }
    fit.warnings.dedup();
}

/// The sum of squares as a function of one number, the others fitted.
struct Profile<'o, 'p> {
    objective: &'o Objective<'p>,
    minimum: &'o Minimum,
    /// The problem with the number given.
    problem: Problem,
    place: usize,
    /// √(S(p) − S) at an end.
    rise: f64,
    /// Where the others were last, from which they go on.
    others: Vec<f64>,
    lowest: f64,
    /// Evaluations that are left.
    budget: usize,
}

impl<'o, 'p> Profile<'o, 'p> {
    fn new(objective: &'o Objective<'p>, minimum: &'o Minimum, place: usize, rise: f64) -> Self {
        let mut problem = objective.problem.clone();
        problem.parameters[objective.free[place]].free = false;
        let mut others = minimum.fitted.clone();
        others.remove(place);
        Profile { objective, minimum, problem, place, rise, others, lowest: f64::INFINITY, budget: BUDGET }
    }

    /// The end of the interval in steps of `step` from the fitted value, the first of them `quantile` long; `None` if the sum of
    /// squares does not rise enough, or has no value.
    fn end(&mut self, step: f64, quantile: f64) -> Option<f64> {
        let mut last = self.sample(step, quantile).ok()?;
        let outwards = last.f < 0.0;
        for _ in 0..DOUBLINGS {
            let next = self.sample(step, if outwards { 2.0 * last.x } else { 0.5 * last.x }).ok()?;
            let nearest = if outwards { last.clone() } else { next.clone() };
            if let Some(bracket) = Bracket::between(last, next.clone(), 0) {
                let root = roots::refine(bracket, &TOLERANCE, |distance| Ok(self.sample(step, *distance)?.f)).ok()?;
                return Some(self.value(step, root.value));
            }
            // Beyond a bound there is nothing.
            if outwards && self.value(step, nearest.x) == self.value(step, next.x) {
                return Some(self.value(step, next.x));
            }
            last = next;
        }
        None
    }

    /// The number at this distance from its estimate.
    fn value(&self, step: f64, distance: f64) -> f64 {
        self.objective.value(self.place, self.minimum.fitted[self.place] + step * distance)
    }

    /// √(S(p) − S) less that of an end, relative to it.
    fn sample(&mut self, step: f64, distance: f64) -> contact::Result<Sample<f64>> {
        if self.budget == 0 {
            let quantity = contact::Quantity::ContactRadius;
            return Err(contact::Error::NoConvergence { quantity, evaluations: BUDGET, error: 1.0 });
        }
        let value = self.value(step, distance);
        let index = self.objective.free[self.place];
        self.problem.parameters[index].value = Some(value);
        let given = &self.objective;
        let mut objective = Objective::new(&self.problem, given.x_scale, given.noise)?;
        objective.at_fold.clone_from(&given.at_fold);
        let mut cost = match self.problem.parameters[index].prior {
            Some([mean, sd]) => ((value - mean) / sd * given.noise.unit).powi(2),
            None => 0.0,
        };
        if self.others.is_empty() {
            self.budget = self.budget.saturating_sub(1);
            cost += objective.evaluate(&[], None)?.cost();
        } else {
            let start = objective.evaluate(&self.others, None)?;
            let end = minimise::descend(&objective, &self.others, start, 1e-11, 100)?;
            self.budget = self.budget.saturating_sub(end.evaluations);
            cost += end.evaluation.cost();
            self.others = end.fitted;
        }
        self.lowest = self.lowest.min(cost);
        let rise = (cost - self.minimum.evaluation.cost()).max(0.0).sqrt();
        Ok(Sample { x: distance, f: rise / self.rise - 1.0 })
    }
}
