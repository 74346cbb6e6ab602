//! Labels of least cost that are monotone along a leg.

use super::observation::Leg;

/// The label of each row of one leg: the level of least total cost, where level 0 is detached and the others are arcs from the
/// inside out. Levels never fall on an approach and never rise on a retract. Time is rows × levels.
pub(super) struct Cheapest {
    leg: Leg,
    /// The least cost of the rows so far that end at each rank.
    total: Vec<f64>,
    /// The rank from which each rank of each row has come.
    from: Vec<u32>,
}

impl Cheapest {
    pub(super) fn new(levels: usize, rows: usize, leg: Leg) -> Self {
        Cheapest { leg, total: vec![0.0; levels], from: Vec::with_capacity(levels * rows) }
    }

    /// The next row, with its squared residual at each level, infinite where a level is impossible.
    pub(super) fn follow(&mut self, costs: &[f64]) {
        let (mut best, mut least) = (0, f64::INFINITY);
        for rank in 0..self.total.len() {
            if self.total[rank] < least {
                (best, least) = (rank, self.total[rank]);
            }
            self.from.push(best as u32);
            self.total[rank] = least + costs[self.level(rank)];
        }
    }

    /// The level of a rank: ranks are the levels in the order in which a leg passes them.
    fn level(&self, rank: usize) -> usize {
        if self.leg == Leg::Approach { rank } else { self.total.len() - 1 - rank }
    }

    /// The labels of all rows.
    pub(super) fn labels(self) -> Vec<u32> {
        let levels = self.total.len();
        let mut rank = (0..levels).fold(0, |best, rank| if self.total[rank] < self.total[best] { rank } else { best });
        let mut labels = vec![0; self.from.len() / levels];
        for (label, before) in labels.iter_mut().zip(self.from.chunks(levels)).rev() {
            *label = self.level(rank) as u32;
            rank = before[rank] as usize;
        }
        labels
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_leg_never_returns_and_costs_least() {
        // Two levels: the third row is a little nearer to the arc, but a way back is impossible.
        let costs = [[9.0, 0.0], [4.0, 0.5], [0.0, 4.0], [1.0, 0.9], [0.0, 9.0]];
        let labels = |leg: Leg| {
            let mut cheapest = Cheapest::new(2, costs.len(), leg);
            costs.iter().for_each(|costs| cheapest.follow(costs));
            cheapest.labels()
        };
        assert_eq!(labels(Leg::Retract), [1, 1, 0, 0, 0]);
        // The other way there is no better than one label for all.
        assert_eq!(labels(Leg::Approach), [0, 0, 0, 0, 0]);
    }
}
