//! The remainder of a rule counts: without it the sum of a fast wave is wrong.

use super::*;
use crate::number::Special;

/// cos(kt) over [−1, 1], and its rule for so many bits with and without the remainder.
fn wave(k: i64, bits: u32) -> [Interval; 2] {
    let panel = LegendrePanel::new(&Float::with_val(BOUND_BITS, -1), &Float::with_val(BOUND_BITS, 1), bits).unwrap();
    let terms = panel.nodes().unwrap().into_iter().map(|node| Special::cos(&node.place.times(k)) * node.weight);
    let sum = terms.reduce(|sum, term| sum + term).unwrap();
    let remainder = panel.remainder(&Analytic::multiplied(&panel.ellipse(), k).sin_cos().1).unwrap();
    [sum.clone(), sum.inflate(&remainder.widened(Precision::new(bits)))]
}

#[test]
fn a_dropped_remainder_is_caught() {
    for (bits, fast) in [(64, 40), (130, 60), (300, 120)] {
        for k in [1, 7, 20, 40, 60, 90, 120] {
            // 2 sin(k)/k
            let truth = Interval::from_int(Precision::new(2 * bits), k);
            let truth = Special::sin(&truth).times(2) / truth;
            let holds = |found: &Interval| found.lower() <= truth.lower() && found.upper() >= truth.upper();
            let [sum, with_remainder] = wave(k, bits);
            assert!(holds(&with_remainder), "{k}, {bits}: {with_remainder:?} without {truth:?}");
            assert!(k < fast || !holds(&sum), "{k}, {bits}: {sum:?}");
            assert!(k > 7 || with_remainder.accuracy_bits() > i64::from(bits) - 16, "{k}, {bits}: {with_remainder:?}");
        }
    }
}

/// Ends whose middle takes more bits than a bound has are refused.
#[test]
fn pieces_have_exact_ends() {
    let far = Float::with_val(200, 1) + (Float::with_val(200, 1) >> 90u32);
    assert!(LegendrePanel::new(&Float::with_val(64, 0), &far, 64).is_none());
    // As are bits beyond which the gain of a rule is no normal double.
    assert!(LegendrePanel::new(&Float::with_val(64, 0), &Float::with_val(64, 1), 901).is_none());
}
