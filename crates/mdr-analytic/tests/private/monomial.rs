//! What is private in `mdr_analytic::certified::monomial`.

use mdr_core::number::certify::Enclosure;

use super::*;
use crate::certified::Elasticity;

fn question(n: &str, force: bool) -> Question {
    let control = if force { Control::Force } else { Control::Indentation };
    let [n, c, e_star, work] = [n, "1.5e-3", "1e6", "0.05"].map(|text| text.parse().unwrap());
    Question::new(&n, &c, &Elasticity::Effective(e_star), &work, &control).unwrap()
}

/// Two methods that share no code except κ_n.
#[test]
fn counted_roundings_and_intervals_agree() {
    for n in ["1/3", "3/10", "7/5", "1/4", "2", "1", "3/2", "5", "37/100", "0.49", "0.51", "20/3"] {
        for (bits, force) in [(40, false), (167, true), (167, false), (900, true)] {
            let question = question(n, force);
            let Some(counted) = question.counted(Precision::new(bits)) else {
                assert!(n == "3/2" && force, "n = {n}: no monomials");
                continue;
            };
            let sharp = question.general_critical(Precision::new(2 * bits + 100)).unwrap();
            for (name, (counted, sharp)) in ["κ", "a", "d", "F"].iter().zip(counted.iter().zip(&sharp)) {
                let sharp = match sharp {
                    Enclosure::Value(value) => value.clone(),
                    Enclosure::Exact(value) => Interval::from_rational(Precision::new(2 * bits + 100), value),
                    Enclosure::Log { .. } => panic!("{name} out of range"),
                };
                let inside = counted.lower() <= sharp.lower() && sharp.upper() <= counted.upper();
                assert!(inside, "n = {n}, {bits} bits, {name}: {counted} {sharp}");
                assert!(counted.accuracy_bits() >= i64::from(bits) - 3, "n = {n}, {bits} bits, {name}: {counted}");
            }
        }
    }
}

#[test]
fn long_exponents_are_left_to_the_general_formula() {
    for n in ["1/2", "0.123456", "0.5000001"] {
        assert!(question(n, false).counted(Precision::new(100)).is_none(), "n = {n}");
    }
}
