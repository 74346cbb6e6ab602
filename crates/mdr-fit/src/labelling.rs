//! The sheet of each leg of a record, with labels and feet of its rows.

use mdr_core::contact::{Edge, Result};

use super::arcs::{self, Arc, Turn};
use super::contact::Contact;
use super::foot::{self, Foot};
use super::judge;
use super::labels::Cheapest;
use super::objective::{Evaluation, Objective};
use super::observation::{Leg, Observation};
use super::pieces::{PIECE, in_pieces};
use super::problem::DataRow;
use super::sheet::{self, Sheet};

impl Objective<'_> {
    /// The sheet of each leg, with labels and feet of its rows.
    pub(super) fn label(&self, evaluation: &mut Evaluation, before: Option<&[Vec<Turn>]>) -> Result<()> {
        let observation = self.problem.observation;
        let numbers = evaluation.numbers.clone();
        let margin = 5.0 * self.x_scale.unwrap_or(0.0).max(self.noise.beyond);
        let [low, high] = judge::extent(self.rows.iter().map(|row| numbers.untrended(row)[0]));
        let range = [low, high + margin];
        let directions: &[Option<Edge>] = match numbers.works {
            Some(_) => &[Some(Edge::Advancing), Some(Edge::Receding)],
            None => &[None],
        };
        for (index, direction) in directions.iter().enumerate() {
            let sheet =
                Sheet { numbers: numbers.of_edge(*direction), direction: *direction, pin: None, arcs: Vec::new() };
            let contact = sheet.contact(&evaluation.tip, observation);
            let turns = self.turns(&contact, before.and_then(|before| before.get(index)).map(Vec::as_slice))?;
            if index == 0 {
                let arcs = arcs::arcs(&contact, &turns, range, self.fineness())?;
                evaluation.sheets.push(Sheet { arcs, ..sheet });
            }
            evaluation.turns.push(turns);
        }
        let parts = self.rows.last().map_or(0, |row| row.part as usize + 1);
        evaluation.of_part = vec![0; parts];
        let mut first = 0;
        for leg in self.rows.chunk_by(|one, other| one.part == other.part) {
            let index = match (numbers.works, leg[0].leg) {
                (Some(_), Leg::Retract) => {
                    let sheet = self.receding(evaluation, &leg[0], range)?;
                    evaluation.sheets.push(sheet);
                    evaluation.sheets.len() - 1
                }
                _ => 0,
            };
            evaluation.of_part[leg[0].part as usize] = index;
            let contact = evaluation.contact(observation, index);
            let (labels, feet) = self.label_leg(&contact, &evaluation.sheets[index].arcs, leg, first)?;
            append(&mut evaluation.labels, labels);
            append(&mut evaluation.feet, feet);
            first += leg.len();
        }
        Ok(())
    }

    /// The sheet of a leg that retracts, of an edge that is pinned before it recedes.
    fn receding(&self, evaluation: &Evaluation, first: &DataRow, range: [f64; 2]) -> Result<Sheet> {
        let numbers = &evaluation.numbers;
        let advancing = evaluation.contact(self.problem.observation, 0);
        let [x, time] = self.problem.turns[first.part as usize];
        // Where the approach ended: on its arc, if it is in the data.
        let before = evaluation.labels.len().checked_sub(1).filter(|before| self.rows[*before].leg == Leg::Approach);
        let level = before.map(|before| evaluation.labels[before]);
        let turn = [x - numbers.trends[2] * time, time];
        let mut sheet = Sheet {
            numbers: numbers.of_edge(Some(Edge::Receding)),
            direction: Some(Edge::Receding),
            pin: sheet::pinned(&advancing, &evaluation.sheets[0].arcs, level, turn)?,
            arcs: Vec::new(),
        };
        let contact = sheet.contact(&evaluation.tip, self.problem.observation);
        let turns = arcs::up_to_edge(&contact, evaluation.turns.get(1).map_or(&[], Vec::as_slice))?;
        sheet.arcs = arcs::arcs(&contact, &turns, range, self.fineness())?;
        Ok(sheet)
    }

    /// Whether a row can be detached: where the contact radius is given, one of radius zero must be.
    fn can_be(&self, row: &DataRow, detached: bool) -> bool {
        match self.problem.observation {
            Observation::ForceOfRadius => detached == (row.x <= 0.0),
            Observation::IndentationOfForce | Observation::RadiusOfForce => !detached,
            _ => true,
        }
    }

    /// Labels and feet of the rows of a leg, of which the first is `first`.
    fn label_leg(
        &self,
        contact: &Contact<'_, f64>,
        arcs: &[Arc],
        leg: &[DataRow],
        first: usize,
    ) -> Result<(Vec<u32>, Vec<Option<Foot>>)> {
        // Level 0 is detached, each other that of an arc.
        let mut found: Vec<Vec<Option<Foot>>> =
            arcs.iter().map(|arc| self.feet(contact, arc, leg)).collect::<Result<_>>()?;
        let mut costs = vec![f64::INFINITY; arcs.len() + 1];
        let mut cheapest = Cheapest::new(costs.len(), leg.len(), leg.first().map_or(Leg::Retract, |row| row.leg));
        for (index, row) in leg.iter().enumerate() {
            costs.fill(f64::INFINITY);
            let held = self.at_fold.iter().find(|held| held.row == first + index && held.beyond == 0.0);
            if let Some(held) = held
                && let Some(fold) = sheet::arc(arcs, held.level).and_then(Arc::inner_fold)
            {
                let foot = foot::at_fold(fold, contact.numbers.untrended(row), self.scales(row).y);
                costs[held.level as usize] = self.loss(foot.residual)[0].powi(2);
                found[held.level as usize - 1][index] = Some(foot);
                cheapest.follow(&costs);
                continue;
            }
            if self.can_be(row, true) || arcs.is_empty() {
                costs[0] = self.loss(self.detached(&contact.numbers, row))[0].powi(2);
            }
            for (cost, feet) in costs[1..].iter_mut().zip(&found) {
                if let Some(foot) = &feet[index] {
                    *cost = self.loss(foot.residual)[0].powi(2);
                }
            }
            cheapest.follow(&costs);
        }
        let labels = cheapest.labels();
        // Those of the first arc make room for all.
        let mut feet = found.first_mut().map_or_else(|| vec![None; leg.len()], std::mem::take);
        for (index, (foot, level)) in feet.iter_mut().zip(&labels).enumerate() {
            match *level as usize {
                0 => *foot = None,
                1 => {}
                level => *foot = found[level - 1][index],
            }
        }
        Ok((labels, feet))
    }

    /// The feet of the rows of a leg on an arc, of those that can be in contact.
    fn feet(&self, contact: &Contact<'_, f64>, arc: &Arc, leg: &[DataRow]) -> Result<Vec<Option<Foot>>> {
        let mut feet = vec![None; leg.len()];
        let pieces = leg.chunks(PIECE).zip(feet.chunks_mut(PIECE));
        in_pieces(pieces, |(_, (rows, feet))| {
            let mut near = 0;
            for (row, foot) in rows.iter().zip(feet).filter(|(row, _)| self.can_be(row, false)) {
                *foot = Some(arc.foot(contact, contact.numbers.untrended(row), &self.scales(row), &mut near)?);
            }
            Ok(())
        })?;
        Ok(feet)
    }
}

/// Appends a list; the first is taken as it is, since a list of all rows of a long record is large.
fn append<T>(list: &mut Vec<T>, more: Vec<T>) {
    if list.is_empty() { *list = more } else { list.extend(more) }
}
