//! The instability under controlled indentation: its radius and its indentation, from the closed form, from the tangency of
//! (1.10), from the extremum of d(a), and from the springs of the paper.

mod contestants;
mod question;

use self::contestants::{Ladder, contestants};
use self::question::{QUESTIONS, Question};
use super::{Clock, Curve, Diagram, Setup, Task, View, ceiling};

/// The task.
pub(super) const FOLD: Task = Task {
    name: "fold",
    claim: "the last equilibrium under controlled indentation, its contact radius and its indentation (1.15)",
    diagrams,
};

fn diagrams(setup: &mut Setup) -> Vec<Diagram> {
    let ladder = Ladder::new(setup.effort);
    QUESTIONS.iter().flat_map(|question| of(question, &ladder, &setup.clock)).collect()
}

/// The two diagrams of a question: every method gives both numbers.
fn of(question: &Question, ladder: &Ladder, clock: &Clock) -> [Diagram; 2] {
    let truth = question.truth();
    let conditions = question.conditions(&truth);
    let contestants = contestants(question, ladder, clock, &truth);
    let [name, shape] = [question.name, question.told];
    [("radius", "contact radius", 0), ("indentation", "indentation", 1)].map(|(id, quantity, index)| Diagram {
        id: format!("fold-{id}-{name}"),
        task: FOLD.name.to_owned(),
        title: format!("{quantity} at the instability of {shape}"),
        truth: format!(
            "the tangency g' = Δl' (1.10) in an interval of {} bits, halved as long as its sign is certain, with {}",
            question::BITS,
            question.independence()
        ),
        view: View::Error,
        ceiling: Some(ceiling(conditions[index])),
        // The closed form where there is one, else the search.
        shipped: contestants.first().map_or(String::new(), |(name, _)| (*name).to_owned()),
        curves: contestants
            .iter()
            .map(|(contestant, points)| {
                let points = points.iter().map(|pair| pair[index].clone()).collect();
                Curve::new(*contestant, super::Arithmetic::Double, points)
            })
            .collect(),
        omissions: Vec::new(),
    })
}

#[cfg(test)]
mod tests;
