//! The residuals of rows over intervals.

use mdr_core::contact::{Error, Quantity, Result};
use mdr_core::number::{Dual, Interval, Precision, Real};
use rug::Float;

use super::super::contact::{Contact, Point};
use super::super::minimise::Minimum;
use super::super::objective::{Evaluation, Objective};
use super::super::problem::{DataRow, Kind};
use super::{OUT_OF_RANGE, exact};

/// A number with its derivative along the seed.
pub(super) type Moving = Dual<Interval>;

/// A row as it is printed, and how it counts.
pub(super) struct Row {
    x: Moving,
    y: Moving,
    time: Moving,
    /// The sheet of its leg.
    sheet: usize,
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
            Some(foot) if foot.is_end && pin_of(evaluation, row) == Some(foot.s) => {
                return Err("certified digits are not given with rows beyond the place where the contact breaks from a pinned edge".to_owned());
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
        let (x, y, time) = (exact(row.x)?, exact(row.y)?, exact(row.time)?);
        rows.push(Row { x, y, time, sheet: evaluation.sheet_of(row), ratio, weight, foot });
    }
    Ok(rows)
}

/// The radius at which the edge of the contact is pinned in the leg of a row.
fn pin_of(evaluation: &Evaluation, row: &DataRow) -> Option<f64> {
    evaluation.sheets[evaluation.sheet_of(row)].pin.map(|pin| pin.radius)
}

impl Row {
    /// The place of the row on the curve: without trends.
    fn place(&self, contact: &Contact<'_, Moving>) -> [Moving; 2] {
        contact.numbers.without_trends([&self.x, &self.y, &self.time])
    }

    /// How the curve moves against the row with a number, by its trends.
    fn trend(&self, contact: &Contact<'_, Moving>, kind: Kind) -> [Moving; 2] {
        contact.numbers.partial_of_trends(kind, [&self.x, &self.time])
    }

    /// The residual, and its derivatives with respect to numbers of these kinds; for the end of an arc both components of the distance.
    ///
    /// # Errors
    /// [`Error::Undecided`] if the foot is not enclosed well enough; errors of the transform.
    pub(super) fn residuals(&self, contacts: &[Contact<'_, Moving>], kinds: &[Kind]) -> Result<Vec<Residual>> {
        let contact = &contacts[self.sheet];
        let place = self.place(contact);
        let residual = match self.foot {
            Foot::Detached => {
                let slope = |kind: &Kind| {
                    let [_, y] = self.trend(contact, *kind);
                    (y + &self.x.lit(i64::from(*kind == Kind::Baseline))) * &self.weight
                };
                let value = (contact.numbers.baseline.clone() - &place[1]) * &self.weight;
                Residual { value, slopes: kinds.iter().map(slope).collect() }
            }
            Foot::Vertical(near) => {
                let point =
                    point(contact, near, |point| Ok((point.at[0].clone() - &place[0], point.tangent[0].clone())))?;
                let [x_slope, y_slope] = &point.tangent;
                let direction = [-(y_slope.clone() / x_slope), y_slope.lit(1)];
                let value = point.at[1].clone() - &place[1];
                self.along(contact, kinds, &point, value, direction)?
            }
            Foot::Nearest(near) => {
                // Half the derivative of the squared distance along the curve, and its own.
                let equation = |point: &Point<Moving>| {
                    let [away, tangent] = [self.away(&place, point), self.isotropic(&point.tangent)];
                    let curvature = self.isotropic(&contact.curvature(point)?);
                    Ok((dot(&away, &tangent), dot(&tangent, &tangent) + dot(&away, &curvature)))
                };
                let point = point(contact, near, equation)?;
                let [x, y] = self.isotropic(&point.tangent);
                let length = (x.square() + y.square()).sqrt();
                let normal = [-y / &length, x / &length];
                let value = dot(&self.away(&place, &point), &normal);
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
    fn away(&self, place: &[Moving; 2], point: &Point<Moving>) -> [Moving; 2] {
        let [x, y] = &point.at;
        self.isotropic(&[x.clone() - &place[0], y.clone() - &place[1]])
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
        let slope = |kind: &Kind| {
            let ([x, y], [more_x, more_y]) = (contact.partial(*kind, point)?, self.trend(contact, *kind));
            Ok(dot(&direction, &[x + more_x, y + more_y]) * &self.weight)
        };
        let slopes = kinds.iter().map(slope).collect::<Result<_>>()?;
        Ok(Residual { value: value * &self.weight, slopes })
    }

    /// The two components of the distance to a fold, which moves with all numbers.
    fn at_fold(&self, contact: &Contact<'_, Moving>, kinds: &[Kind], near: f64) -> Result<Vec<Residual>> {
        let equation = |point: &Point<Moving>| Ok((point.tangent[0].clone(), contact.curvature(point)?[0].clone()));
        let point = point(contact, near, equation)?;
        let [x_curvature, _] = contact.curvature(&point)?;
        let place = self.place(contact);
        let mut residuals =
            self.away(&place, &point).map(|value| Residual { value: value * &self.weight, slopes: Vec::new() });
        for kind in kinds {
            let speed = -contact.x_slope_partial(*kind, &point)? / &x_curvature;
            let (partial, trend) = (contact.partial(*kind, &point)?, self.trend(contact, *kind));
            let along = |axis: usize| point.tangent[axis].clone() * &speed + &trend[axis];
            let moved = [0, 1].map(|axis| partial[axis].clone() + along(axis));
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
pub(super) fn point(
    contact: &Contact<'_, Moving>,
    near: f64,
    equation: impl Fn(&Point<Moving>) -> Result<(Moving, Moving)>,
) -> Result<Point<Moving>> {
    let precision = contact.numbers.e_star.ctx();
    let what = "whether a row has one state on its arc";
    let undecided = || Error::undecided(Quantity::ContactRadius, &contact.numbers.e_star, what);
    let at = |s: &Interval| {
        // On which side of the edge a point lies decides its formula.
        let s = Dual::constant(s.clone());
        if contact.edge.as_ref().is_some_and(|edge| s.partial_cmp(edge).is_none()) {
            return Err(undecided());
        }
        equation(&contact.point(&s)?)
    };
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
