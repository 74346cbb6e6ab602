//! Labels of least cost that are monotone along a leg.

use super::observation::Leg;

/// The label of each row of one leg: the level of least total cost, where level 0 is detached and the others are arcs from the
/// inside out. Levels never fall on an approach and never rise on a retract.
///
/// `costs` are the squared residuals, `levels` of each row, infinite where a level is impossible. Time is rows × levels.
pub(super) fn cheapest(costs: &[f64], levels: usize, leg: Leg) -> Vec<u32> {
    let position = |rank: usize| if leg == Leg::Approach { rank } else { levels - 1 - rank };
    // total[rank]: the least cost of the rows so far that end at this rank, which for a row has come from before[rank].
    let mut total = vec![0.0; levels];
    let mut from = vec![0_u32; costs.len()];
    for (row, before) in costs.chunks(levels).zip(from.chunks_mut(levels)) {
        let (mut best, mut least) = (0, f64::INFINITY);
        for rank in 0..levels {
            if total[rank] < least {
                (best, least) = (rank, total[rank]);
            }
            before[rank] = best as u32;
            total[rank] = least + row[position(rank)];
        }
    }
    let mut rank = (0..levels).fold(0, |best, rank| if total[rank] < total[best] { rank } else { best });
    let mut labels = vec![0_u32; costs.len() / levels];
    for (label, before) in labels.iter_mut().zip(from.chunks(levels)).rev() {
        *label = position(rank) as u32;
        rank = before[rank] as usize;
    }
    labels
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_leg_never_returns_and_costs_least() {
        // Two levels: the third row is a little nearer to the arc, but a way back is impossible.
        let costs = [[9.0, 0.0], [4.0, 0.5], [0.0, 4.0], [1.0, 0.9], [0.0, 9.0]].as_flattened().to_vec();
        assert_eq!(cheapest(&costs, 2, Leg::Retract), [1, 1, 0, 0, 0]);
        // The other way there is no better than one label for all.
        assert_eq!(cheapest(&costs, 2, Leg::Approach), [0, 0, 0, 0, 0]);
    }
}
