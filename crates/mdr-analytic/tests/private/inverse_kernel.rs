//! The last step from good and from bad approximations of v: a trusted result is correct.

use mdr_core::contact::{Equilibrium, Material};

use super::*;
use crate::double::contact;
use crate::double::pair::{Fused, Separate};

/// A value of one contact with its equilibria to 128 bits.
struct Question {
    constants: Constants,
    x: f64,
    /// By branch: v and the state.
    roots: [(Branch, f64, Equilibrium<Extended<2>>); 2],
}

impl Question {
    /// At x = `share`·x_fold.
    fn new(n: f64, held: Held, share: f64) -> Option<Self> {
        let contact = contact::<Extended<2>>(n, 0.7, &Material::new(3.0, 0.1).ok()?).ok()?;
        let fold = FoldFrame::new(&contact, held).ok()?;
        let constants = Constants::new(&contact, &fold)?;
        let x = share * constants.fold;
        let found = fold.at_value(&contact, &x.into()).ok()?;
        let [smaller, larger] = found.as_slice() else { return None };
        let root = |branch, state: &Equilibrium<Extended<2>>| {
            let u = (state.contact_radius / fold.state.contact_radius).ln().approx() / 2.0;
            (branch, u / constants.stretch.hi, state.clone())
        };
        Some(Question { roots: [root(Branch::Smaller, smaller), root(Branch::Larger, larger)], constants, x })
    }

    fn from<A: Arithmetic>(&self, arithmetic: A, v: f64) -> (f64, f64, bool) {
        match self.constants.held {
            Held::Indentation => self.constants.state_near::<A, false>(arithmetic, self.x, v),
            Held::Force => self.constants.state_near::<A, true>(arithmetic, self.x, v),
        }
    }

    fn solve<A: Arithmetic>(&self, arithmetic: A, v: f64) -> Lanes<1> {
        match self.constants.held {
            Held::Indentation => self.constants.solve::<A, false, 1>(arithmetic, &[self.x], [v]),
            Held::Force => self.constants.solve::<A, true, 1>(arithmetic, &[self.x], [v]),
        }
    }
}

fn questions() -> Vec<Question> {
    let exponents = [0.05, 0.2, 0.35, 0.45, 0.55, 0.8, 1.0, 1.5, 2.0, 3.7, 12.0];
    let shares = [1e-6, 0.01, 0.3, 0.8, 0.99, 1.0 - 1e-5];
    let all = exponents.into_iter().flat_map(|n| shares.map(|share| (n, share)));
    let all = all.flat_map(|(n, share)| [Held::Indentation, Held::Force].map(|held| Question::new(n, held, share)));
    all.flatten().collect()
}

fn ulps(found: f64, truth: &Extended<2>) -> f64 {
    let size = truth.approx().abs();
    (Extended::from(found) - truth).approx().abs() / (size.next_up() - size)
}

/// K times the distance of v from the root, from 2⁻⁵ to 2⁻²⁰ on either side.
fn check_last_step<A: Arithmetic>(arithmetic: A) {
    let (mut counted, mut refused) = (0, 0);
    for question in questions() {
        for (_, root, state) in &question.roots {
            let size = 2.0 / (question.constants.m.hi + root.abs().recip());
            let other = question.constants.held.pick(&state.force, &state.indentation);
            for k in 20..=80 {
                for offset in [size, -size].map(|size| size * (-f64::from(k) / 4.0).exp2()) {
                    let (a, found, trusted) = question.from(arithmetic, root + offset);
                    counted += usize::from(trusted);
                    refused += usize::from(!trusted);
                    let error = ulps(a, &state.contact_radius).max(ulps(found, other));
                    assert!(!trusted || error <= 1.0, "{error} ulp, {k}: {:?}", question.constants);
                }
            }
        }
    }
    assert!(counted > 10_000 && refused > 10_000, "{counted} and {refused}");
}

/// From distant v, the steps reach the root of the same sign or no trusted result.
fn check_branches<A: Arithmetic>(arithmetic: A) {
    let mut counted = 0;
    for question in questions() {
        for (branch, root, state) in &question.roots {
            for k in -60..=24 {
                let lanes = question.solve(arithmetic, root * (f64::from(k) / 6.0).exp2());
                if lanes.trusted[0] {
                    counted += 1;
                    let error = ulps(lanes.radius[0], &state.contact_radius);
                    assert!(error <= 1.0, "{error} ulp, {k}, {branch:?}: {:?}", question.constants);
                }
            }
        }
    }
    assert!(counted > 5000, "{counted}");
}

#[test]
fn an_answer_that_counts_is_right_wherever_v_comes_from() {
    check_last_step(Fused);
    check_last_step(Separate);
}

#[test]
fn steps_do_not_lead_to_the_other_branch() {
    check_branches(Fused);
    check_branches(Separate);
}
