//! Which rows of a record count, its legs by number, and the time of each row.

use std::sync::Arc as Shared;

use super::judge;
use super::observation::Leg;
use super::parameter::refuse;
use super::problem::{DataRow, Problem};
use mdr::Result;

/// The share of the range of X by which a record goes back where it turns.
const TURN: f64 = 0.25;

/// A record with more legs than this has, on average, at least so many rows in each.
const FEW_LEGS: usize = 4;
const ROWS_OF_A_LEG: usize = 6;

/// Rows that are left out.
#[derive(Clone, Debug, Default)]
pub(super) struct Selection {
    pub(super) only: Option<Leg>,
    /// Of X and Y as they are recorded.
    pub(super) within: [Option<[f64; 2]>; 2],
    pub(super) saturation: Option<[f64; 2]>,
    /// Whether the rows have times in s.
    pub(super) has_times: bool,
    /// Rows without a number that are left out already.
    pub(super) missing: usize,
    /// Reasons with the numbers of rows that were left out.
    pub(super) skipped: Vec<(&'static str, usize)>,
}

impl Problem {
    /// Leaves out all rows of the other leg.
    pub fn only(mut self, leg: Leg) -> Self {
        self.selection.only = Some(leg);
        self
    }

    /// Leaves out all rows with X or Y, as they are recorded, outside of an interval. The place where the record turns stays known.
    ///
    /// # Errors
    /// Ends that do not ascend.
    pub fn within(mut self, x: Option<[f64; 2]>, y: Option<[f64; 2]>) -> Result<Self> {
        for (name, ends) in [("x", x), ("y", y)] {
            if let Some([low, high]) = ends.filter(|[low, high]| !(low < high)) {
                return Err(refuse("fit.rows", format!("the ends of `{name}` must ascend, got {low} to {high}")));
            }
        }
        self.selection.within = [x, y];
        Ok(self)
    }

    /// Leaves out all rows with Y at the ends of this range of the detector, or beyond them.
    ///
    /// # Errors
    /// Ends that do not ascend.
    pub fn saturation(mut self, [low, high]: [f64; 2]) -> Result<Self> {
        if !(low < high) {
            return Err(refuse("data.saturation", format!("must ascend, got {low} to {high}")));
        }
        self.selection.saturation = Some([low, high]);
        Ok(self)
    }

    /// The time of each row, in s: drifts are then per second instead of per record.
    ///
    /// # Errors
    /// Another number of times than of rows; a time that is not finite.
    pub fn times(mut self, times: &[f64]) -> Result<Self> {
        if times.len() != self.rows.len() {
            return Err(refuse("data.time", format!("{} given for {} rows", times.len(), self.rows.len())));
        }
        if let Some(time) = times.iter().find(|time| !time.is_finite()) {
            return Err(refuse("data.time", format!("must be finite, got {time}")));
        }
        let rows = Shared::make_mut(&mut self.rows);
        rows.iter_mut().zip(times).for_each(|(row, time)| row.time = *time);
        self.selection.has_times = true;
        self.turns = arrange(rows, true);
        Ok(self)
    }
}

/// The problem with the rows that count.
///
/// # Errors
/// Rows that are in no order; too few rows that count.
pub(super) fn selected(problem: &Problem) -> Result<Problem> {
    let mut selected = problem.clone();
    let Selection { only, within, saturation, has_times, missing, .. } = &problem.selection;
    let parts = selected.turns.len();
    let is_ordered = problem.observation.sees_radius() || parts <= FEW_LEGS;
    if !is_ordered && selected.rows.len() < ROWS_OF_A_LEG * parts {
        return Err(problem.place.refuse(format!(
            "x turns {} times in {} rows by more than a quarter of its range: give the rows in the order in which they were recorded",
            parts - 1,
            selected.rows.len()
        )));
    }
    let of_baseline = match (has_times, problem.units()[1]) {
        (true, "m") => "m/s",
        (true, "N") => "N/s",
        (true, _) => "N/(m s)",
        (false, unit) => unit,
    };
    let drift = [of_baseline, if *has_times { "m/s" } else { "m" }];
    for parameter in &mut selected.parameters {
        parameter.drift_unit = drift[usize::from(parameter.name == "position_drift")];
    }
    let inside = |ends: Option<[f64; 2]>, value: f64| ends.is_none_or(|[low, high]| value >= low && value <= high);
    let reason = |row: &DataRow| -> Option<&'static str> {
        if saturation.is_some_and(|[low, high]| row.y <= low || row.y >= high) {
            Some("saturated")
        } else if only.is_some_and(|leg| leg != row.leg) {
            Some("other leg")
        } else if !inside(within[0], row.x) {
            Some("outside of x")
        } else if !inside(within[1], row.y) {
            Some("outside of y")
        } else {
            None
        }
    };
    let mut skipped =
        vec![("not a number", *missing), ("saturated", 0), ("other leg", 0), ("outside of x", 0), ("outside of y", 0)];
    for reason in problem.rows.iter().filter_map(reason) {
        skipped.iter_mut().filter(|(why, _)| *why == reason).for_each(|(_, count)| *count += 1);
    }
    skipped.retain(|(_, count)| *count > 0);
    if problem.rows.iter().any(|row| reason(row).is_some()) {
        Shared::make_mut(&mut selected.rows).retain(|row| reason(row).is_none());
        let left = skipped.iter().map(|(why, count)| format!("{count} {why}")).collect::<Vec<_>>().join(", ");
        let complain = |why: String| problem.place.refuse(format!("{why}; left out are {left}"));
        super::data::check(&selected.rows).map_err(complain)?;
    }
    selected.selection.skipped = skipped;
    Ok(selected)
}

/// Numbers the legs, also those that follow another of their own kind, and dates the rows: from the first, or by their number. X and time
/// where each leg and the one before meet.
pub(super) fn arrange(rows: &mut [DataRow], has_times: bool) -> Vec<[f64; 2]> {
    let Some(start) = rows.first().copied() else { return Vec::new() };
    let count = rows.len().saturating_sub(1).max(1) as f64;
    for (index, row) in rows.iter_mut().enumerate() {
        row.time = if has_times { row.time - start.time } else { index as f64 / count };
    }
    let ends = judge::extent(rows.iter().map(|row| row.x));
    let back = TURN * (ends[1] - ends[0]);
    let (mut part, mut farthest, mut meetings) = (0, start.x, vec![[start.x, 0.0]]);
    for index in 0..rows.len() {
        let row = rows[index];
        let onward = if row.leg == Leg::Approach { 1.0 } else { -1.0 };
        if index > 0 {
            let before = rows[index - 1];
            let turns = before.leg != row.leg;
            if turns || onward * (farthest - row.x) > back {
                part += 1;
                farthest = row.x;
                // Where both legs end.
                let is_before = turns && onward * (before.x - row.x) < 0.0;
                meetings.push(if is_before { [before.x, before.time] } else { [row.x, row.time] });
            }
        }
        farthest = if onward * (row.x - farthest) > 0.0 { row.x } else { farthest };
        rows[index].part = part;
    }
    meetings
}

/// Where a record turns more than once, the leg of each row; `None` where it does not.
pub(super) fn cycles(x: &[f64]) -> Option<Vec<Leg>> {
    let ends = judge::extent(x.iter().copied());
    let back = TURN * (ends[1] - ends[0]);
    // The extremes at which the record turns, by a way back of some length.
    let mut turns = Vec::new();
    let (mut low, mut high) = (0, 0);
    let mut rises = None;
    for (index, value) in x.iter().enumerate() {
        if *value < x[low] {
            low = index;
        }
        if *value >= x[high] {
            high = index;
        }
        if rises != Some(false) && x[high] - value > back {
            if rises.is_some() {
                turns.push(high);
            }
            (rises, low) = (Some(false), index);
        } else if rises != Some(true) && value - x[low] > back {
            if rises.is_some() {
                turns.push(low);
            }
            (rises, high) = (Some(true), index);
        }
    }
    if turns.len() < 2 {
        return None;
    }
    let falls_last = rises == Some(false);
    let legs = (0..x.len()).map(|index| {
        let later = turns.iter().filter(|turn| **turn >= index).count();
        if (later % 2 == 0) == falls_last { Leg::Retract } else { Leg::Approach }
    });
    Some(legs.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(ways: &[f64]) -> Vec<f64> {
        let leg = |pair: &[f64]| {
            (0..10).map(|index| pair[0] + (pair[1] - pair[0]) * f64::from(index) / 10.0).collect::<Vec<_>>()
        };
        ways.windows(2).flat_map(leg).collect()
    }

    #[test]
    fn two_cycles_have_four_legs() {
        let x = record(&[-1.0, 1.0, -1.0, 1.0, -1.0]);
        let legs = cycles(&x).unwrap();
        let runs: Vec<(Leg, usize)> = legs.chunk_by(|one, other| one == other).map(|run| (run[0], run.len())).collect();
        assert_eq!(runs, [(Leg::Approach, 11), (Leg::Retract, 10), (Leg::Approach, 10), (Leg::Retract, 9)]);
        // One cycle, and a jitter of x, are none.
        assert_eq!(cycles(&record(&[-1.0, 1.0, -1.0])), None);
        assert_eq!(cycles(&record(&[-1.0, 0.3, 0.2, 1.0, -1.0])), None);
    }

    #[test]
    fn a_leg_after_one_of_its_kind_is_another() {
        let x = [record(&[-1.0, 1.0]), record(&[-1.0, 1.0])].concat();
        let legs = vec![Leg::Approach; x.len()];
        let mut rows = super::super::data::rows(&x, &x, Some(&legs)).unwrap();
        let turns = arrange(&mut rows, false);
        assert_eq!((rows[9].part, rows[10].part, rows[19].part), (0, 1, 1));
        assert_eq!(turns, [[-1.0, 0.0], [-1.0, 10.0 / 19.0]]);
    }
}
