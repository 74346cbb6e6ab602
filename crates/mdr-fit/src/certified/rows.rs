//! The residuals of rows over intervals.

use mdr_core::contact::{Error, Quantity, Result};
use mdr_core::number::{Dual, Interval, Precision, Real};
use rug::Float;

use super::super::contact::{Contact, Point};
use super::super::minimise::Minimum;
use super::super::objective::Objective;
use super::super::problem::Kind;
use super::{OUT_OF_RANGE, exact};

/// A number with its derivative along the seed.
type Moving = Dual<Interval>;

/// A row as it is printed, and how it counts.
pub(super) struct Row {
    x: Moving,
    y: Moving,
    /// σ_Y/σ_X.
    ratio: Moving,
    /// 1/σ_Y; one where all rows count alike.
    weight: Moving,
    foot: Foot,
}

/// The point of the curve with which a row is compared, near a double that only says where to look.
enum Foot {
    Detached,
    /// That with the X of the row.
    Vertical(f64),
    /// The nearest.
    Nearest(f64),
    /// The fold at which its arc ends.
    Fold(f64),
}

/// A residual, and its derivatives with respect to the fitted values.
pub(super) struct Residual {
    pub(super) value: Moving,
    pub(super) slopes: Vec<Moving>,
}

/// The rows of a problem with the labels and feet of its minimum.
///
/// # Errors
/// A sentence that says which row has no proof.
pub(super) fn rows(
    objective: &Objective<'_>,
    minimum: &Minimum,
    precision: Precision,
) -> std::result::Result<Vec<Row>, String> {
    let evaluation = &minimum.evaluation;
    let alike = objective.counts_alike();
    let exact = |value: f64| exact(precision, value).map(Dual::constant).ok_or(OUT_OF_RANGE);
    let mut rows = Vec::with_capacity(objective.rows.len());
    for (index, row) in objective.rows.iter().enumerate() {
        let scales = objective.stated_scales(row);
        let foot = match &evaluation.feet[index] {
            None => Foot::Detached,
            Some(_) if objective.at_fold.iter().any(|held| held.row == index) => {
                return Err("certified digits are not given with a fold at the last row of its arc: a kink of the sum of squares".to_owned());
            }
            Some(foot) if !foot.is_end && scales.x.is_none() => Foot::Vertical(foot.s),
            Some(foot) if !foot.is_end => Foot::Nearest(foot.s),
            Some(foot) if evaluation.arc(row, evaluation.labels[index]).is_some_and(|arc| arc.is_fold(foot.s)) => {
                Foot::Fold(foot.s)
            }
            Some(_) => return Err("certified digits are not given with rows beyond an end that is no fold".to_owned()),
        };
        let y_scale = exact(scales.y)?;
        let ratio = y_scale.clone() / exact(scales.x.unwrap_or(scales.beyond))?;
        let weight = if alike { y_scale.lit(1) } else { y_scale.lit(1) / y_scale };
        rows.push(Row { x: exact(row.x)?, y: exact(row.y)?, ratio, weight, foot });
    }
    Ok(rows)
}

impl Row {
    /// The residual, and its derivatives with respect to numbers of these kinds; for the end of an arc both components of the distance.
    ///
    /// # Errors
    /// [`Error::Undecided`] if the foot is not enclosed well enough; errors of the transform.
    pub(super) fn residuals(&self, contact: &Contact<'_, Moving>, kinds: &[Kind]) -> Result<Vec<Residual>> {
        let residual = match self.foot {
            Foot::Detached => {
                let slope = |kind: &Kind| self.weight.clone().times(i64::from(*kind == Kind::Baseline));
                let value = (contact.numbers.baseline.clone() - &self.y) * &self.weight;
                Residual { value, slopes: kinds.iter().map(slope).collect() }
            }
            Foot::Vertical(near) => {
                let point =
                    point(contact, near, |point| Ok((point.at[0].clone() - &self.x, point.tangent[0].clone())))?;
                let [x_slope, y_slope] = &point.tangent;
                let direction = [-(y_slope.clone() / x_slope), y_slope.lit(1)];
                let value = point.at[1].clone() - &self.y;
                self.along(contact, kinds, &point, value, direction)?
            }
            Foot::Nearest(near) => {
                // Half the derivative of the squared distance along the curve, and its own.
                let equation = |point: &Point<Moving>| {
                    let [away, tangent] = [self.away(point), self.isotropic(&point.tangent)];
                    let curvature = self.isotropic(&contact.curvature(point)?);
                    Ok((dot(&away, &tangent), dot(&tangent, &tangent) + dot(&away, &curvature)))
                };
                let point = point(contact, near, equation)?;
                let [x, y] = self.isotropic(&point.tangent);
                let length = (x.square() + y.square()).sqrt();
                let normal = [-y / &length, x / &length];
                let value = dot(&self.away(&point), &normal);
                let direction = self.isotropic(&normal);
                self.along(contact, kinds, &point, value, direction)?
            }
            Foot::Fold(near) => return self.at_fold(contact, kinds, near),
        };
        Ok(vec![residual])
    }

    /// A vector (X, Y) with X in units of σ_X/σ_Y.
    fn isotropic(&self, [x, y]: &[Moving; 2]) -> [Moving; 2] {
        [x.clone() * &self.ratio, y.clone()]
    }

    /// From the row to a point of the curve.
    fn away(&self, point: &Point<Moving>) -> [Moving; 2] {
        let [x, y] = &point.at;
        self.isotropic(&[x.clone() - &self.x, y.clone() - &self.y])
    }

    /// The residual of a row that a shift of the curve along it does not change to first order: its derivatives are those at a fixed
    /// parameter of the curve.
    fn along(
        &self,
        contact: &Contact<'_, Moving>,
        kinds: &[Kind],
        point: &Point<Moving>,
        value: Moving,
        direction: [Moving; 2],
    ) -> Result<Residual> {
        let slope = |kind: &Kind| Ok(dot(&direction, &contact.partial(*kind, point)?) * &self.weight);
        let slopes = kinds.iter().map(slope).collect::<Result<_>>()?;
        Ok(Residual { value: value * &self.weight, slopes })
    }

    /// The two components of the distance to a fold, which moves with all numbers.
    fn at_fold(&self, contact: &Contact<'_, Moving>, kinds: &[Kind], near: f64) -> Result<Vec<Residual>> {
        let equation = |point: &Point<Moving>| Ok((point.tangent[0].clone(), contact.curvature(point)?[0].clone()));
        let point = point(contact, near, equation)?;
        let [x_curvature, _] = contact.curvature(&point)?;
        let mut residuals = self.away(&point).map(|value| Residual { value: value * &self.weight, slopes: Vec::new() });
        for kind in kinds {
            let speed = -contact.x_slope_partial(*kind, &point)? / &x_curvature;
            let partial = contact.partial(*kind, &point)?;
            let moved = [0, 1].map(|axis| partial[axis].clone() + point.tangent[axis].clone() * &speed);
            for (residual, moved) in residuals.iter_mut().zip(self.isotropic(&moved)) {
                residual.slopes.push(moved * &self.weight);
            }
        }
        Ok(residuals.into())
    }
}

fn dot([x, y]: &[Moving; 2], [other_x, other_y]: &[Moving; 2]) -> Moving {
    x.clone() * other_x + y.clone() * other_y
}

/// The point of the curve near a parameter where an equation, given with its derivative along the curve, holds over the whole box, by
/// the interval Newton method; with its derivative along the seed.
fn point(
    contact: &Contact<'_, Moving>,
    near: f64,
    equation: impl Fn(&Point<Moving>) -> Result<(Moving, Moving)>,
) -> Result<Point<Moving>> {
    let precision = contact.numbers.e_star.ctx();
    let what = "whether a row has one state on its arc";
    let undecided = || Error::undecided(Quantity::ContactRadius, &contact.numbers.e_star, what);
    let at = |s: &Interval| equation(&contact.point(&Dual::constant(s.clone()))?);
    let mut middle = Interval::from_f64(precision, near);
    let mut found: Option<Interval> = None;
    for _ in 0..12 {
        let (error, slope) = at(&middle)?;
        let guess = (error.value.clone() / &slope.value).abs();
        let reach = Interval::point(guess.upper().clone()).times(2) + middle.abs() * middle.unit_roundoff();
        let around = middle.clone().inflate(&reach);
        let (_, slope) = at(&around)?;
        if slope.value.contains_zero() {
            return Err(undecided());
        }
        let next = middle.clone() - error.value / slope.value;
        let inside = next.lower() > around.lower() && next.upper() < around.upper();
        let narrower = found.as_ref().is_none_or(|found| next.radius() < Float::with_val(53, found.radius() * 0.5));
        if inside && (found.is_none() || narrower) {
            middle = Interval::point(next.mid());
            found = Some(next);
        } else if found.is_some() {
            break;
        } else {
            middle = Interval::point(next.mid());
        }
    }
    let value = found.ok_or_else(undecided)?;
    let (error, slope) = at(&value)?;
    contact.point(&Dual { value, slope: -error.slope / slope.value })
}
