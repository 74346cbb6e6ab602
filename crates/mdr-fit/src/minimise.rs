//! Levenberg–Marquardt on an objective, and the Gauss–Newton steps that end it, at a stationary point.

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::{DMatrix, DVector, Dyn, Owned};

use super::arcs::Turn;
use super::judge;
use super::objective::{AtFold, Evaluation, LONG, Objective};

/// An end of a descent.
pub(super) struct Minimum {
    pub(super) fitted: Vec<f64>,
    pub(super) evaluation: Evaluation,
    pub(super) jacobian: DMatrix<f64>,
    /// The largest cosine between the residuals and a column of the Jacobian that is not held by a bound.
    pub(super) gradient: f64,
    pub(super) evaluations: usize,
    /// The rows that hold a fold there.
    pub(super) at_fold: Vec<AtFold>,
}

/// A minimum that was reached, without what it has of every row: enough to compare it with others and to return to it.
pub(super) struct Reached {
    pub(super) fitted: Vec<f64>,
    pub(super) cost: f64,
    pub(super) detached: usize,
    pub(super) at_fold: Vec<AtFold>,
    /// The folds of its curves.
    pub(super) turns: Vec<Vec<Turn>>,
    pub(super) evaluations: usize,
}

impl From<Minimum> for Reached {
    fn from(Minimum { fitted, evaluation, evaluations, at_fold, .. }: Minimum) -> Self {
        let (cost, detached) = (evaluation.cost(), evaluation.detached());
        Reached { fitted, cost, detached, at_fold, turns: evaluation.turns, evaluations }
    }
}

impl Reached {
    /// The label of each row there.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn labels(&self, objective: &mut Objective<'_>) -> mdr_core::contact::Result<Vec<u32>> {
        objective.at_fold.clone_from(&self.at_fold);
        Ok(objective.evaluate(&self.fitted, Some(&self.turns))?.labels)
    }

    /// The minimum, followed to the end.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn followed(&self, objective: &mut Objective<'_>) -> mdr_core::contact::Result<Minimum> {
        objective.at_fold.clone_from(&self.at_fold);
        let evaluation = objective.evaluate(&self.fitted, Some(&self.turns))?;
        polish(objective, &self.fitted, evaluation, self.evaluations, Precision::Full)
    }
}

/// The factor on residuals where the objective has no value: far above any sum of squares of data, so that the step is refused
/// and shortened.
const REFUSED: f64 = 1e12;

/// The factor by which a number may change in one descent: further off there is no minimum that the start leads to, but a direction
/// of which the data say nothing.
const FARTHEST: f64 = 1e2;

/// The objective at the place where Levenberg–Marquardt is.
struct Place<'o, 'p> {
    objective: &'o Objective<'p>,
    start: &'o [f64],
    fitted: DVector<f64>,
    /// The last that has a value, and where it is.
    evaluation: Evaluation,
    evaluated: DVector<f64>,
    has_value: bool,
    evaluations: usize,
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Place<'_, '_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, fitted: &DVector<f64>) {
        self.fitted.clone_from(fitted);
        let found =
            self.objective.evaluate(fitted.as_slice(), Some(&self.evaluation.turns)).ok().filter(|_| self.is_near());
        self.has_value = found.is_some();
        if let Some(evaluation) = found {
            self.evaluation = evaluation;
            self.evaluated.clone_from(fitted);
        }
        self.evaluations += 1;
    }

    fn params(&self) -> DVector<f64> {
        self.fitted.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        let residuals = &self.evaluation.residuals;
        Some(if self.has_value {
            residuals.clone()
        } else {
            residuals.map(|residual| REFUSED * (1.0 + residual.abs()))
        })
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        self.objective.jacobian(self.fitted.as_slice(), &self.evaluation).ok()
    }
}

impl Place<'_, '_> {
    /// Whether no number that is fitted by its logarithm has left its start by more than the farthest.
    fn is_near(&self) -> bool {
        let distances = self.fitted.iter().zip(self.start).map(|(fitted, start)| (fitted - start).abs());
        distances.enumerate().all(|(place, distance)| self.objective.is_offset(place) || distance < FARTHEST.ln())
    }
}

/// Where Levenberg–Marquardt ends.
pub(super) struct End {
    pub(super) fitted: Vec<f64>,
    /// The objective there.
    pub(super) evaluation: Evaluation,
    pub(super) evaluations: usize,
}

/// Descends from `start`, where the objective has been evaluated; `tolerance` is that of the sum of squares and of the step.
///
/// # Errors
/// Where the objective has no value at a bound that the descent has gone beyond.
pub(super) fn descend(
    objective: &Objective<'_>,
    start: &[f64],
    evaluation: Evaluation,
    tolerance: f64,
    patience: usize,
) -> mdr_core::contact::Result<End> {
    let fitted = DVector::from_column_slice(start);
    let evaluated = fitted.clone();
    let place = Place { objective, start, fitted, evaluation, evaluated, has_value: true, evaluations: 1 };
    let method = LevenbergMarquardt::new().with_tol(tolerance).with_patience(patience).with_stepbound(1.0);
    let (place, _) = method.minimize(place);
    let fitted = inside_bounds(objective, place.fitted.as_slice());
    let evaluation = if place.evaluated.as_slice() == fitted.as_slice() {
        place.evaluation
    } else {
        objective.evaluate(&fitted, Some(&place.evaluation.turns))?
    };
    Ok(End { fitted, evaluation, evaluations: place.evaluations })
}

/// Values beyond their bounds come back to them.
fn inside_bounds(objective: &Objective<'_>, fitted: &[f64]) -> Vec<f64> {
    let inside = |(place, fitted): (usize, &f64)| {
        if objective.at_bound(place, *fitted) {
            objective.to_fitted(place, objective.value(place, *fitted))
        } else {
            *fitted
        }
    };
    fitted.iter().enumerate().map(inside).collect()
}

/// How far a minimum is followed.
#[derive(Clone, Copy)]
pub(super) enum Precision {
    /// Enough to compare minima and to see what is near a fold.
    Comparable,
    /// Far below what the data resolve: the last step changes the estimates by less than 10⁻¹¹ √N standard errors.
    Full,
}

impl Precision {
    /// The change of the curve by a step, as a share of the residuals, below which no further step is taken, and that above which second
    /// derivatives are worth their evaluations. Of a long record each of these counts, and what moves the estimates by less than a third of a
    /// standard error decides nothing between minima.
    fn steps(self, rows: usize) -> [f64; 2] {
        match self {
            Precision::Comparable if rows >= LONG => [1e-7, 0.3 / (rows as f64).sqrt()],
            Precision::Comparable => [1e-7, 1e-6],
            Precision::Full => [1e-11, 1e-9],
        }
    }
}

/// Gauss–Newton steps from near a minimum, where the objective has been evaluated; Newton steps where the curvature of the curve beside a
/// fold keeps the others from converging.
///
/// # Errors
/// Errors of the transform.
pub(super) fn polish(
    objective: &Objective<'_>,
    start: &[f64],
    mut evaluation: Evaluation,
    mut evaluations: usize,
    precision: Precision,
) -> mdr_core::contact::Result<Minimum> {
    let [smallest, slow] = precision.steps(objective.rows.len());
    let mut fitted = start.to_vec();
    let mut jacobian = objective.jacobian(&fitted, &evaluation)?;
    let mut hessian: Option<DMatrix<f64>> = None;
    let mut last = f64::INFINITY;
    let mut steps = Steps::default();
    for _ in 0..60 {
        evaluations += 1;
        let held = held(objective, &fitted, &jacobian, &evaluation);
        let step = match &hessian {
            None => step(&jacobian, &evaluation.residuals, &held),
            Some(hessian) => newton_step(hessian, &jacobian, &evaluation.residuals, &held),
        };
        let is_free = !held.contains(&true);
        let accelerated = steps.next(&fitted, &step, &jacobian).filter(|_| is_free).unwrap_or_else(|| step.clone());
        let next: Vec<f64> = fitted.iter().zip(accelerated.iter()).map(|(value, step)| value - step).collect();
        let next = inside_bounds(objective, &next);
        let size = (&jacobian * &step).norm() / evaluation.residuals.norm().max(f64::MIN_POSITIVE);
        // Steps that no longer become smaller are rounding; larger ones lead away.
        let candidate = if size < last { objective.evaluate(&next, Some(&evaluation.turns)).ok() } else { None };
        match candidate.filter(|candidate| candidate.cost() <= evaluation.cost() * (1.0 + 1e-9)) {
            Some(candidate) => {
                // The last evaluation and its Jacobian go before another is made.
                (fitted, evaluation, last) = (next, candidate, size);
                drop(std::mem::replace(&mut jacobian, DMatrix::zeros(0, 0)));
                jacobian = objective.jacobian(&fitted, &evaluation)?;
            }
            // What has rows beyond the fold is no end where x is exact.
            None if hessian.is_none() && size > slow && !(objective.x_scale.is_none() && evaluation.is_beyond()) => {
                hessian = curvature(objective, &fitted, &evaluation, &jacobian);
                (last, steps) = (f64::INFINITY, Steps::default());
                if hessian.is_none() {
                    break;
                }
            }
            None => break,
        }
        if size < smallest {
            break;
        }
    }
    let held = held(objective, &fitted, &jacobian, &evaluation);
    let gradient = gradient(&jacobian, &evaluation.residuals, &held, &objective.roundings_of_folds());
    let at_fold = objective.at_fold.clone();
    Ok(Minimum { fitted, evaluation, jacobian, gradient, evaluations, at_fold })
}

/// The last step and where it began, from which the next one is extrapolated.
#[derive(Default)]
struct Steps {
    last: Option<[DVector<f64>; 2]>,
}

impl Steps {
    /// The step of Anderson's acceleration of depth one: where the steps shrink by one factor, along one direction, it leads to
    /// their limit. `None` before a second step.
    fn next(&mut self, fitted: &[f64], step: &DVector<f64>, jacobian: &DMatrix<f64>) -> Option<DVector<f64>> {
        let place = DVector::from_column_slice(fitted);
        let last = self.last.replace([place.clone(), step.clone()]);
        let [last_place, last_step] = last?;
        let (moved, change) = (place - last_place, step - last_step);
        // Lengths as the curve shows them.
        let [seen, wanted] = [jacobian * &change, jacobian * step];
        let share = seen.dot(&wanted) / seen.norm_squared();
        share.is_finite().then(|| step + (moved - change) * share)
    }
}

/// The second derivatives of half the sum of squares, as differences of its exact gradient, in units in which the columns of the
/// Jacobian have length one; `None` where the objective has no value nearby.
fn curvature(
    objective: &Objective<'_>,
    fitted: &[f64],
    evaluation: &Evaluation,
    jacobian: &DMatrix<f64>,
) -> Option<DMatrix<f64>> {
    let lengths: Vec<f64> = jacobian.column_iter().map(|column| column.norm().max(f64::MIN_POSITIVE)).collect();
    let slope = |fitted: &[f64]| -> Option<DVector<f64>> {
        let evaluation = objective.evaluate(fitted, Some(&evaluation.turns)).ok()?;
        let slope = objective.jacobian(fitted, &evaluation).ok()?.tr_mul(&evaluation.residuals);
        Some(DVector::from_iterator(lengths.len(), slope.iter().zip(&lengths).map(|(slope, length)| slope / length)))
    };
    let size = 1e-4 * evaluation.residuals.norm() / (evaluation.residuals.len() as f64).sqrt();
    let mut hessian = DMatrix::zeros(fitted.len(), fitted.len());
    for (place, length) in lengths.iter().enumerate() {
        let mut ends = [fitted.to_vec(), fitted.to_vec()];
        ends[0][place] += size / length;
        ends[1][place] -= size / length;
        let difference = slope(&ends[0])? - slope(&ends[1])?;
        hessian.set_column(place, &(difference / (2.0 * size)));
    }
    Some((&hessian + hessian.transpose()) * 0.5)
}

/// Newton's step by second derivatives; zero along directions that the data do not determine.
fn newton_step(
    hessian: &DMatrix<f64>,
    jacobian: &DMatrix<f64>,
    residuals: &DVector<f64>,
    held: &[bool],
) -> DVector<f64> {
    let lengths: Vec<f64> = jacobian.column_iter().map(|column| column.norm().max(f64::MIN_POSITIVE)).collect();
    let mut slope = jacobian.tr_mul(residuals);
    let mut kept = hessian.clone();
    for (place, length) in lengths.iter().enumerate() {
        slope[place] /= *length;
        if held[place] {
            slope[place] = 0.0;
            kept.row_mut(place).fill(0.0);
            kept.column_mut(place).fill(0.0);
        }
    }
    let step = judge::least_squares(kept, &slope, 1e-9).unwrap_or_else(|| DVector::zeros(held.len()));
    DVector::from_iterator(held.len(), step.iter().zip(&lengths).map(|(step, length)| step / length))
}

/// Which free numbers a bound holds: those at a bound that the objective falls towards.
pub(super) fn held(
    objective: &Objective<'_>,
    fitted: &[f64],
    jacobian: &DMatrix<f64>,
    evaluation: &Evaluation,
) -> Vec<bool> {
    let presses = |place: usize| {
        let Some([lower, _]) = objective.parameter(place).bounds else { return false };
        let towards = jacobian.column(place).dot(&evaluation.residuals);
        let rises = objective.value(place, fitted[place]) <= lower;
        objective.at_bound(place, fitted[place]) && (if rises { towards >= 0.0 } else { towards <= 0.0 })
    };
    (0..fitted.len()).map(presses).collect()
}

/// The least-squares solution of J·step = residuals over the numbers that are not held, with columns of unit length.
fn step(jacobian: &DMatrix<f64>, residuals: &DVector<f64>, held: &[bool]) -> DVector<f64> {
    let lengths: Vec<f64> = jacobian.column_iter().map(|column| column.norm()).collect();
    let mut scaled = jacobian.clone();
    for (place, mut column) in scaled.column_iter_mut().enumerate() {
        if held[place] || lengths[place] == 0.0 { column.fill(0.0) } else { column /= lengths[place] }
    }
    let solution = judge::least_squares(scaled, residuals, 1e-11).unwrap_or_else(|| DVector::zeros(held.len()));
    DVector::from_iterator(
        held.len(),
        solution.iter().zip(&lengths).map(|(value, length)| if *length > 0.0 { value / length } else { 0.0 }),
    )
}

/// The largest cosine; the last rows, of held folds, do not count in the lengths of columns, nor does what is within their roundings.
fn gradient(jacobian: &DMatrix<f64>, residuals: &DVector<f64>, held: &[bool], roundings: &[f64]) -> f64 {
    let norm = residuals.norm();
    let cosine = |(place, column): (usize, nalgebra::DVectorView<'_, f64>)| {
        let rows = column.len() - roundings.len();
        let length = column.rows(0, rows).norm() * norm;
        let of_folds = column.rows(rows, roundings.len());
        let rounding: f64 = of_folds.iter().zip(roundings).map(|(slope, rounding)| slope.abs() * rounding).sum();
        if held[place] || length == 0.0 { 0.0 } else { (column.dot(residuals).abs() - rounding).max(0.0) / length }
    };
    jacobian.column_iter().enumerate().map(cosine).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rounding_of_a_held_fold_is_no_gradient() {
        let jacobian = DMatrix::from_column_slice(3, 1, &[1.0, -1.0, 1e9]);
        let at = |of_fold: f64| DVector::from_column_slice(&[1e3, 1e3, of_fold]);
        let gradient = |residuals: &DVector<f64>, rounding: f64| gradient(&jacobian, residuals, &[false], &[rounding]);
        assert!(gradient(&at(1e-7), 0.0) > 1e-2);
        assert!(gradient(&at(1e-7), 1e-7) < 1e-12);
        assert!(gradient(&at(1e-5), 1e-7) > 1.0);
    }
}
