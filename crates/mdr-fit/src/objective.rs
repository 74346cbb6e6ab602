//! The residuals of a problem and their derivatives, at given numbers.

use std::sync::{Arc as Shared, Mutex, PoisonError};

use mdr_core::contact::Result;
use nalgebra::DVector;

use super::arcs::{self, Arc, Turn};
use super::contact::{Contact, Numbers, Tip};
use super::foot::{Foot, Scales};
use super::observation::{Loss, Observation};
use super::problem::{DataRow, Kind, Parameter, Problem};
use super::sheet::{self, Sheet};

/// The distance up to which Huber's loss is a square: 95 % efficient for normal noise.
const HUBER: f64 = 1.345;

/// A problem with σ for all rows, and which rows count.
pub(super) struct Objective<'p> {
    pub(super) problem: &'p Problem,
    /// Indices of the free parameters.
    pub(super) free: Vec<usize>,
    pub(super) noise: Noise,
    /// The scale of X where a row has none of its own, in the unit of the noise; `None` for vertical distances.
    pub(super) x_scale: Option<f64>,
    /// Which rows count.
    pub(super) rows: Shared<Vec<DataRow>>,
    /// Rows whose X is that of the fold at which their arc ends.
    pub(super) at_fold: Vec<AtFold>,
    /// The profile, where all its numbers are known.
    tip: Option<Shared<Tip<f64>>>,
    /// The folds that were searched for last with this profile, with E*, work of adhesion and stiffness.
    searched: Mutex<Vec<([f64; 3], Vec<Turn>)>>,
}

/// The rows from which on a record is long, and the points of its arcs between two that are drawn: then the first guess for a row is as
/// near as a step of Newton's method.
pub(super) const LONG: usize = 10_000;
const FINER: usize = 16;

/// How many searches for folds are kept: descents come back to where others began and ended.
const SEARCHES: usize = 8;

/// The scatter of the data. The objective counts in a unit in which σ_Y is the scatter that the data show, so that a common
/// factor of all stated standard deviations moves no estimate, and none is too small or too large for a double.
#[derive(Clone, Copy, Debug)]
pub(super) struct Noise {
    /// σ_Y, as it is stated or as the data show it.
    pub(super) y: f64,
    /// σ_Y as the data show it.
    pub(super) y_scale: f64,
    /// The ratio of the two, by which a distance in units of σ is multiplied. One if σ is not stated.
    pub(super) unit: f64,
    /// The scale of X for points beyond the end of an arc.
    pub(super) beyond: f64,
}

impl Noise {
    /// The standard deviation of a prior or of an event, in the unit of the noise.
    pub(super) fn unit_of(&self, sd: f64) -> f64 {
        sd / self.unit
    }

    /// A stated standard deviation in the unit of the noise.
    pub(super) fn scaled(&self, sigma: f64) -> f64 {
        sigma / self.y * self.y_scale
    }
}

/// A row that holds a fold: x is exact and the row is in contact, so that the fold cannot lie further in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct AtFold {
    /// The row.
    pub(super) row: usize,
    /// Its level.
    pub(super) level: u32,
    /// How far beyond the row the fold is held; the row is at the fold where that is zero.
    pub(super) beyond: f64,
}

/// The factor on the distance in X of a held fold, against that of a row beyond it.
pub(super) const HELD: f64 = 1e3;

/// The residuals at one set of numbers.
pub(super) struct Evaluation {
    pub(super) tip: Shared<Tip<f64>>,
    pub(super) numbers: Numbers<f64>,
    /// The folds of the curve, or of an edge that advances and one that recedes.
    pub(super) turns: Vec<Vec<Turn>>,
    /// The curve, or of two works of adhesion that of an edge that advances, and for each leg that retracts its own.
    pub(super) sheets: Vec<Sheet>,
    /// Which sheet each leg of the record has.
    pub(super) of_part: Vec<usize>,
    /// The level of each row: 0 detached, else one more than the index of its arc.
    pub(super) labels: Vec<u32>,
    /// The feet of rows in contact.
    pub(super) feet: Vec<Option<Foot>>,
    /// Residuals of the rows, of priors and of the pull-off.
    pub(super) residuals: DVector<f64>,
}

impl Evaluation {
    /// Which sheet a row has.
    pub(super) fn sheet_of(&self, row: &DataRow) -> usize {
        self.of_part.get(row.part as usize).copied().unwrap_or(0)
    }

    /// The sheet on which the contact breaks.
    pub(super) fn breaking(&self) -> usize {
        self.sheets.len() - 1
    }

    /// Whether a row is compared with the fold at which its arc ends.
    pub(super) fn is_beyond(&self) -> bool {
        self.feet.iter().flatten().any(|foot| foot.is_end)
    }

    /// How many rows are detached.
    pub(super) fn detached(&self) -> usize {
        self.labels.iter().filter(|label| **label == 0).count()
    }

    /// The contact of a sheet.
    pub(super) fn contact(&self, observation: Observation, sheet: usize) -> Contact<'_, f64> {
        self.sheets[sheet].contact(&self.tip, observation)
    }

    /// The contacts of all sheets, with the motion of pinned edges by these numbers.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn contacts(&self, observation: Observation, kinds: &[Kind]) -> Result<Vec<Contact<'_, f64>>> {
        let with_speeds = |index: usize| {
            let mut contact = self.contact(observation, index);
            if let Some(pin) = &self.sheets[index].pin {
                contact.pinned = Some(sheet::speeds(&self.contact(observation, 0), pin, kinds)?);
            }
            Ok(contact)
        };
        (0..self.sheets.len()).map(with_speeds).collect()
    }

    /// The arc of a row in contact.
    pub(super) fn arc(&self, row: &DataRow, level: u32) -> Option<&Arc> {
        self.sheets[self.sheet_of(row)].arc(level)
    }

    /// The sum of squares, in the unit of the noise.
    pub(super) fn cost(&self) -> f64 {
        self.residuals.norm_squared()
    }
}

impl<'p> Objective<'p> {
    pub(super) fn new(problem: &'p Problem, x_scale: Option<f64>, noise: Noise) -> Result<Self> {
        let free: Vec<usize> = (0..problem.parameters.len()).filter(|index| problem.parameters[*index].free).collect();
        let mut objective = Objective {
            problem,
            free,
            noise,
            x_scale,
            rows: Shared::clone(&problem.rows),
            at_fold: Vec::new(),
            tip: None,
            searched: Mutex::default(),
        };
        if objective.free_of_profile().is_empty() {
            let numbers: Vec<f64> = {
                let given = |index: usize| problem.parameters[index].value.unwrap_or(f64::NAN);
                Numbers::of(problem, given, || 0.0).profile
            };
            objective.tip = Some(Shared::new(Tip::new(problem, (), &numbers, &[])?));
        }
        Ok(objective)
    }

    /// The free numbers of the profile, by their index in it.
    pub(super) fn free_of_profile(&self) -> Vec<usize> {
        let of_profile = |place: usize| if let Kind::Profile(index) = self.kind(place) { Some(index) } else { None };
        (0..self.free.len()).filter_map(of_profile).collect()
    }

    /// A free parameter.
    pub(super) fn parameter(&self, place: usize) -> &'p Parameter {
        &self.problem.parameters[self.free[place]]
    }

    pub(super) fn kind(&self, place: usize) -> Kind {
        self.parameter(place).kind
    }

    /// Whether a free parameter is an offset, and fitted as it is.
    pub(super) fn is_offset(&self, place: usize) -> bool {
        self.kind(place).is_offset()
    }

    /// The value of a free parameter as it is fitted: its logarithm, or itself for an offset.
    pub(super) fn to_fitted(&self, place: usize, value: f64) -> f64 {
        if self.is_offset(place) { value } else { value.abs().ln() }
    }

    /// The value of a free parameter, kept between its bounds.
    pub(super) fn value(&self, place: usize, fitted: f64) -> f64 {
        let parameter = self.parameter(place);
        let value = if parameter.kind.is_offset() {
            fitted
        } else {
            let sign = if parameter.is_negative() { -1.0 } else { 1.0 };
            sign * fitted.exp()
        };
        let Some([lower, upper]) = parameter.bounds else { return value };
        // The logarithm of a bound is rounded.
        let at = |bound: f64| (value - bound).abs() <= 1e-12 * bound.abs();
        if at(lower) {
            lower
        } else if at(upper) {
            upper
        } else {
            value.clamp(lower, upper)
        }
    }

    /// Whether a bound holds a free parameter.
    pub(super) fn at_bound(&self, place: usize, fitted: f64) -> bool {
        let value = self.value(place, fitted);
        self.parameter(place).bounds.is_some_and(|[lower, upper]| value <= lower || value >= upper)
    }

    /// All numbers of the problem at these fitted values.
    fn numbers(&self, fitted: &[f64]) -> Numbers<f64> {
        let value = |index: usize| match self.free.iter().position(|free| *free == index) {
            Some(place) => self.value(place, fitted[place]),
            None => self.problem.parameters[index].value.unwrap_or(f64::NAN),
        };
        Numbers::of(self.problem, value, || 0.0)
    }

    /// Whether all rows count alike and vertically, so that σ_Y is not needed.
    pub(super) fn counts_alike(&self) -> bool {
        self.x_scale.is_none()
            && self.rows.iter().all(|row| row.sigma[1].get().is_none())
            && self.problem.loss == Loss::LeastSquares
            && self.priors().next().is_none()
    }

    /// σ_Y of a row, in the unit of the noise.
    pub(super) fn y_scale(&self, row: &DataRow) -> f64 {
        row.sigma[1].get().map_or(self.noise.y_scale, |own| self.noise.scaled(own))
    }

    /// The scales of a row, in the unit of the noise.
    pub(super) fn scales(&self, row: &DataRow) -> Scales {
        let own = |x: f64| row.sigma[0].get().map_or(x, |own| x.max(self.noise.scaled(own)));
        Scales { x: self.x_scale.map(own).filter(|x| *x > 0.0), y: self.y_scale(row), beyond: self.noise.beyond }
    }

    /// The scales of a row as they are stated, so that their decimals are exact.
    #[cfg(feature = "mp")]
    pub(super) fn stated_scales(&self, row: &DataRow) -> Scales {
        let x = row.sigma[0].get().or(self.problem.sigma[0]).filter(|_| self.x_scale.is_some());
        Scales { x, y: row.sigma[1].get().unwrap_or(self.noise.y), beyond: self.noise.beyond }
    }

    /// The residuals at these fitted values; folds are followed from an earlier evaluation where there is one.
    ///
    /// # Errors
    /// A number out of its domain; errors of the transform.
    pub(super) fn evaluate(&self, fitted: &[f64], before: Option<&[Vec<Turn>]>) -> Result<Evaluation> {
        let numbers = self.numbers(fitted);
        let tip = match &self.tip {
            Some(tip) => Shared::clone(tip),
            None => Shared::new(Tip::new(self.problem, (), &numbers.profile, &self.free_of_profile())?),
        };
        let mut evaluation = Evaluation {
            tip,
            numbers,
            turns: Vec::new(),
            sheets: Vec::new(),
            of_part: Vec::new(),
            labels: Vec::new(),
            feet: Vec::new(),
            residuals: DVector::zeros(0),
        };
        self.label(&mut evaluation, before)?;
        let numbers = &evaluation.numbers;
        let of_row = |(row, foot): (&DataRow, &Option<Foot>)| {
            self.loss(foot.map_or_else(|| self.detached(numbers, row), |foot| foot.residual))[0]
        };
        // So many, and no more: of a long record half as much again counts.
        let mut residuals = Vec::with_capacity(self.residuals());
        residuals.extend(self.rows.iter().zip(&evaluation.feet).map(of_row));
        residuals.extend(self.prior_residuals(fitted));
        if let Some([place, sd]) = self.problem.pull_off {
            let contact = evaluation.contact(self.problem.observation, evaluation.breaking());
            let end = evaluation.sheets[evaluation.breaking()].last_fold().map(|s| contact.point(&s)).transpose()?;
            residuals.push(end.map_or(0.0, |end| (end.at[0] - place) / self.noise.unit_of(sd)));
        }
        for held in &self.at_fold {
            let row = &self.rows[held.row];
            let fold = evaluation.arc(row, held.level).and_then(Arc::inner_fold);
            let away = |fold: &arcs::Sample| fold.at[0] + held.beyond - numbers.untrended(row)[0];
            residuals.push(fold.map_or(0.0, |fold| away(fold) / self.noise.beyond * HELD));
        }
        evaluation.residuals = DVector::from_vec(residuals);
        Ok(evaluation)
    }

    /// The folds of a contact: followed from these where that is possible, else searched, once for the same numbers.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn turns(&self, contact: &Contact<'_, f64>, before: Option<&[Turn]>) -> Result<Vec<Turn>> {
        if let Some(turns) = before.and_then(|before| arcs::followed(contact, before)) {
            return Ok(turns);
        }
        if self.tip.is_none() {
            return arcs::turns(contact);
        }
        let numbers = &contact.numbers;
        let key = [numbers.e_star, numbers.work, numbers.stiffness.unwrap_or(0.0)];
        let mut searched = self.searched.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, turns)) = searched.iter().find(|(other, _)| *other == key) {
            return Ok(turns.clone());
        }
        let turns = arcs::turns(contact)?;
        searched.truncate(SEARCHES - 1);
        searched.insert(0, (key, turns.clone()));
        Ok(turns)
    }

    /// The rounding of the residual of each held fold, whose place is a difference of lengths as large as those of the row.
    pub(super) fn roundings_of_folds(&self) -> Vec<f64> {
        const ROUNDINGS: f64 = 8.0;
        let rounding =
            |held: &AtFold| ROUNDINGS * f64::EPSILON * self.rows[held.row].x.abs() / self.noise.beyond * HELD;
        self.at_fold.iter().map(rounding).collect()
    }

    /// How many times as many points an arc has as it is drawn with: more where many rows look for their own with exact X.
    pub(super) fn fineness(&self) -> usize {
        if self.x_scale.is_none() && self.rows.len() >= LONG { FINER } else { 1 }
    }

    /// How many residuals there are: of the rows, of priors, of the pull-off, and of folds that are held.
    fn residuals(&self) -> usize {
        self.rows.len() + self.priors().count() + usize::from(self.problem.pull_off.is_some()) + self.at_fold.len()
    }

    pub(super) fn detached(&self, numbers: &Numbers<f64>, row: &DataRow) -> f64 {
        (numbers.baseline - numbers.untrended(row)[1]) / self.y_scale(row)
    }

    /// A residual as it counts, and its derivative with respect to the distance.
    pub(super) fn loss(&self, residual: f64) -> [f64; 2] {
        let huber = HUBER * self.noise.unit;
        if self.problem.loss == Loss::LeastSquares || residual.abs() <= huber {
            return [residual, 1.0];
        }
        let counted = (2.0 * huber * residual.abs() - huber * huber).sqrt();
        [counted.copysign(residual), huber / counted]
    }

    /// The mean and the standard deviation of free parameters that have a prior, by their place.
    pub(super) fn priors(&self) -> impl Iterator<Item = (usize, [f64; 2])> {
        (0..self.free.len()).filter_map(|place| Some((place, self.parameter(place).prior?)))
    }

    fn prior_residuals(&self, fitted: &[f64]) -> Vec<f64> {
        let residual =
            |(place, [mean, sd]): (usize, [f64; 2])| (self.value(place, fitted[place]) - mean) / self.noise.unit_of(sd);
        self.priors().map(residual).collect()
    }

    /// Whether a row of the same leg has left the arc whose fold is held, so that the fold lies between two rows.
    pub(super) fn is_bracketed(&self, evaluation: &Evaluation, held: &AtFold) -> bool {
        let part = self.rows[held.row].part;
        let of_leg = self.rows.iter().zip(&evaluation.labels).filter(|(row, _)| row.part == part);
        of_leg.map(|(_, label)| *label).any(|label| label < held.level)
    }

    /// How far beyond the last row in contact a fold may be: where the curve has risen by the noise. Near a fold at X₀ it rises as
    /// Y' √(2 (X − X₀)/X''), with derivatives along the curve.
    pub(super) fn width_of_fold(&self, evaluation: &Evaluation, held: &AtFold) -> Result<f64> {
        let row = &self.rows[held.row];
        let Some(fold) = evaluation.arc(row, held.level).and_then(Arc::inner_fold) else {
            return Ok(self.noise.beyond);
        };
        let contact = evaluation.contact(self.problem.observation, evaluation.sheet_of(row));
        let point = contact.point(&fold.s)?;
        let sigma = self.y_scale(&self.rows[held.row]) * self.noise.unit;
        let curvature = contact.curvature(&point)?[0];
        Ok((sigma / point.tangent[1]).powi(2) * 0.5 * curvature.abs())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mdr_core::contact::Shape;

    /// A sphere on a cantilever with rows on its curve, beyond its fold, and detached.
    fn problem() -> Problem {
        let (e_star, work, radius, stiffness) = (8e5, 0.04, 5e-6, 1.2);
        let row = |index: i32| {
            let a = 1e-6 * (2.6 - 0.1 * f64::from(index));
            let elongation = (2.0 * std::f64::consts::PI * a * work / e_star).sqrt();
            let d = a * a / radius - elongation;
            let bent = 2.0 * e_star * (a * d - a.powi(3) / (3.0 * radius)) / stiffness;
            [d + bent + 1e-8 * f64::from(index % 3), bent + 2e-9 * f64::from(index % 2)]
        };
        let rows: Vec<[f64; 2]> =
            (0..13).map(row).chain([[-1.09e-6, -7.4e-7], [-1.3e-6, 0.0], [-1.4e-6, 1e-9]]).collect();
        let [x, y] = [0, 1].map(|axis| rows.iter().map(|row| row[axis]).collect::<Vec<f64>>());
        let tip = Shape::Paraboloid { radius: "5e-6" };
        let problem = Problem::new(tip, Observation::DeflectionOfPosition, &x, &y).unwrap();
        problem.free(["e_star", "work_of_adhesion", "stiffness", "contact_point", "baseline", "radius"]).unwrap()
    }

    #[test]
    fn derivatives_are_those_of_differences() {
        let problem = problem();
        for x_scale in [None, Some(3e-8)] {
            let noise = Noise { y: 4e-9, y_scale: 4e-9, unit: 1.0, beyond: 3e-8 };
            let objective = Objective::new(&problem, x_scale, noise).unwrap();
            let fitted = [8.1e5f64.ln(), 0.0401f64.ln(), 1.21f64.ln(), 1e-9, 1e-10, 5.02e-6f64.ln()];
            let evaluation = objective.evaluate(&fitted, None).unwrap();
            assert!(evaluation.feet.iter().flatten().any(|foot| foot.is_end) && evaluation.labels.contains(&0));
            let jacobian = objective.jacobian(&fitted, &evaluation).unwrap();
            for (place, step) in [1e-6, 1e-6, 1e-6, 1e-13, 1e-13, 1e-6].into_iter().enumerate() {
                let residuals = [step, -step].map(|step| {
                    let mut moved = fitted;
                    moved[place] += step;
                    objective.evaluate(&moved, None).unwrap().residuals
                });
                let difference = (&residuals[0] - &residuals[1]) / (2.0 * step);
                let error = (&difference - jacobian.column(place)).norm() / difference.norm();
                assert!(error < 1e-6, "{place}: {error:e} with σ_X {x_scale:?}");
            }
        }
    }
}
