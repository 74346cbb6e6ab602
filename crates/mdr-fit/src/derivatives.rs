//! The derivatives of the residuals with respect to the fitted values.

use mdr_core::contact::{Edge, Result};
use nalgebra::DMatrix;

use super::arcs::{self, Arc};
use super::contact::Contact;
use super::foot::Foot;
use super::objective::{Evaluation, HELD, Objective};
use super::pieces::{self, PIECE, in_pieces};
use super::problem::{DataRow, Kind};

/// What the derivatives of all rows have in common.
struct Common<'a> {
    evaluation: &'a Evaluation,
    /// The numbers, with their places among those that are free.
    moving: &'a [(usize, Kind)],
    contacts: &'a [Contact<'a, f64>],
    has_trends: bool,
}

impl Objective<'_> {
    /// The derivatives of the residuals with respect to the fitted values. A number at a bound that it presses against has none.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn jacobian(&self, fitted: &[f64], evaluation: &Evaluation) -> Result<DMatrix<f64>> {
        let moving = self.moving(fitted);
        let columns = self.derivatives(fitted, evaluation, &moving)?;
        if moving.len() == self.free.len() {
            return Ok(columns);
        }
        let mut jacobian = DMatrix::zeros(columns.nrows(), self.free.len());
        for (column, (place, _)) in columns.column_iter().zip(&moving) {
            jacobian.set_column(*place, &column);
        }
        for (index, (place, [_, sd])) in self.priors().enumerate() {
            jacobian[(self.rows.len() + index, place)] = self.slope_of_prior(place, fitted, sd);
        }
        Ok(jacobian)
    }

    /// How the residual of a prior moves with its number.
    fn slope_of_prior(&self, place: usize, fitted: &[f64], sd: f64) -> f64 {
        let value = if self.is_offset(place) { 1.0 } else { self.value(place, fitted[place]) };
        value / self.noise.unit_of(sd)
    }

    /// The derivatives with respect to some of the free numbers, given with their places: a column for each of these.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn derivatives(
        &self,
        fitted: &[f64],
        evaluation: &Evaluation,
        moving: &[(usize, Kind)],
    ) -> Result<DMatrix<f64>> {
        let mut jacobian = DMatrix::zeros(evaluation.residuals.len(), moving.len());
        let kinds: Vec<Kind> = moving.iter().map(|(_, kind)| *kind).collect();
        let contacts = evaluation.contacts(self.problem.observation, &kinds)?;
        let has_trends = evaluation.numbers.trends != [0.0; 3] || kinds.iter().any(|kind| kind.is_trend());
        let count = self.rows.len();
        let pieces = pieces::columns(jacobian.as_mut_slice(), evaluation.residuals.len(), count);
        let common = Common { evaluation, moving, contacts: &contacts, has_trends };
        in_pieces(pieces, |(piece, mut columns)| {
            let first = piece * PIECE;
            (first..count.min(first + PIECE)).try_for_each(|index| {
                self.slopes_of_row(&common, index, |column, slope| columns[column][index - first] = slope)
            })
        })?;
        let mut index = self.rows.len();
        for (place, [_, sd]) in self.priors() {
            if let Some(column) = moving.iter().position(|(other, _)| *other == place) {
                jacobian[(index, column)] = self.slope_of_prior(place, fitted, sd);
            }
            index += 1;
        }
        // How the place of a fold moves with each number.
        let mut fold = |index: usize, sheet: usize, s: f64, unit: f64, row: Option<&DataRow>| -> Result<()> {
            let contact = &contacts[sheet];
            let point = contact.point(&s)?;
            for (column, (_, kind)) in moving.iter().enumerate() {
                let speed = arcs::end_speed(contact, *kind, &point)?;
                let trend = row.map_or(0.0, |row| evaluation.numbers.trend_partial(*kind, row)[0]);
                jacobian[(index, column)] =
                    (contact.partial(*kind, &point)?[0] + point.tangent[0] * speed + trend) / unit;
            }
            Ok(())
        };
        if let Some([_, sd]) = self.problem.pull_off {
            let sheet = evaluation.breaking();
            if let Some(s) = evaluation.sheets[sheet].last_fold() {
                fold(index, sheet, s, self.noise.unit_of(sd), None)?;
            }
            index += 1;
        }
        for held in &self.at_fold {
            let row = &self.rows[held.row];
            if let Some(end) = evaluation.arc(row, held.level).and_then(Arc::inner_fold) {
                fold(index, evaluation.sheet_of(row), end.s, self.noise.beyond / HELD, Some(row))?;
            }
            index += 1;
        }
        Ok(jacobian)
    }

    /// The derivatives of the residual of a row.
    fn slopes_of_row(&self, of: &Common<'_>, index: usize, mut set: impl FnMut(usize, f64)) -> Result<()> {
        let Common { evaluation, moving, contacts, has_trends } = *of;
        let row = &self.rows[index];
        let Some(foot) = &evaluation.feet[index] else {
            let slope = self.loss(self.detached(&evaluation.numbers, row))[1] / self.y_scale(row);
            for (column, (_, kind)) in moving.iter().enumerate() {
                let own = f64::from(u8::from(*kind == Kind::Baseline));
                set(column, slope * (own + evaluation.numbers.trend_partial(*kind, row)[1]));
            }
            return Ok(());
        };
        let contact = &contacts[evaluation.sheet_of(row)];
        let point = contact.point(&foot.s)?;
        let slope = self.loss(foot.residual)[1];
        let Some(arc) = evaluation.arc(row, evaluation.labels[index]) else { return Ok(()) };
        let is_pinned = point.beyond_edge && contact.pinned.is_some();
        for (column, (_, kind)) in moving.iter().enumerate() {
            // What holds a pinned edge does not show: not even in rounding, which would be a direction of its own.
            if is_pinned && !foot.is_end && *kind == Kind::Work(Edge::Receding) {
                continue;
            }
            let mut partial = arc.partial(contact, *kind, foot, &point)?;
            if has_trends {
                let [more_x, more_y] = evaluation.numbers.trend_partial(*kind, row);
                partial = [partial[0] + more_x, partial[1] + more_y];
            }
            set(column, slope * (foot.weights[0] * partial[0] + foot.weights[1] * partial[1]));
        }
        Ok(())
    }

    /// The Jacobian for standard errors: a row that is compared to the end of an arc counts in both directions, along the
    /// distance and across it, where its residual is zero.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(super) fn information(&self, fitted: &[f64], evaluation: &Evaluation) -> Result<DMatrix<f64>> {
        let moving = self.moving(fitted);
        let kinds: Vec<Kind> = moving.iter().map(|(_, kind)| *kind).collect();
        let contacts = evaluation.contacts(self.problem.observation, &kinds)?;
        let across = |(index, foot): (usize, &Foot)| {
            let data = &self.rows[index];
            let contact = &contacts[evaluation.sheet_of(data)];
            let point = contact.point(&foot.s)?;
            let scales = self.scales(data);
            let scales = [scales.x.unwrap_or(scales.beyond), scales.y];
            let [along_x, along_y] = [foot.weights[0] * scales[0], foot.weights[1] * scales[1]];
            let mut row = vec![0.0; self.free.len()];
            let Some(arc) = evaluation.arc(data, evaluation.labels[index]) else { return Ok(row) };
            for (place, kind) in &moving {
                let [x, y] = arc.partial(contact, *kind, foot, &point)?;
                let [more_x, more_y] = evaluation.numbers.trend_partial(*kind, data);
                row[*place] = along_x * (y + more_y) / scales[1] - along_y * (x + more_x) / scales[0];
            }
            Ok(row)
        };
        let is_held = |index: usize| self.at_fold.iter().any(|held| held.row == index);
        let feet = evaluation.feet.iter().enumerate().filter(|(index, _)| !is_held(*index));
        let ends = feet.filter_map(|(index, foot)| Some((index, foot.as_ref().filter(|foot| foot.is_end)?)));
        let rows: Vec<Vec<f64>> = ends.map(across).collect::<Result<_>>()?;
        let mut jacobian = self.jacobian(fitted, evaluation)?;
        let known = jacobian.nrows();
        for (index, held) in self.at_fold.iter().enumerate() {
            // Without a row beyond it the fold may be anywhere beyond, and its place tells nothing.
            let scale = if self.is_bracketed(evaluation, held) {
                self.noise.unit * self.noise.beyond / HELD / self.width_of_fold(evaluation, held)?
            } else {
                0.0
            };
            jacobian.row_mut(known - self.at_fold.len() + index).scale_mut(scale);
        }
        let mut information = jacobian.resize_vertically(known + rows.len(), 0.0);
        for (index, row) in rows.iter().enumerate() {
            information.row_mut(known + index).copy_from_slice(row);
        }
        Ok(information)
    }

    /// The free numbers but those whose fitted value lies beyond a bound: these do not follow it.
    fn moving(&self, fitted: &[f64]) -> Vec<(usize, Kind)> {
        let follows = |place: &usize| {
            let fitted = fitted[*place];
            !self.at_bound(*place, fitted) || self.to_fitted(*place, self.value(*place, fitted)) == fitted
        };
        (0..self.free.len()).filter(follows).map(|place| (place, self.kind(place))).collect()
    }
}
