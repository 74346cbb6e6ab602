//! The remainder of a rule counts: without it the sum of a fast wave is wrong.

use super::*;

/// cos(kt) over [−1, 1], and its rule with and without the remainder.
fn wave(k: i64) -> [DoubleInterval; 2] {
    let panel = LegendrePanel::new(&Float::with_val(BOUND_BITS, -1), &Float::with_val(BOUND_BITS, 1)).unwrap();
    let terms = panel.nodes().unwrap().into_iter().map(|node| node.t.times(k).sin_cos().1 * node.weight);
    let sum = terms.reduce(|sum, term| sum + term).unwrap();
    let remainder = panel.remainder(&Analytic::multiplied(&panel.ellipse(), k).sin_cos().1).unwrap();
    [sum, sum.inflate(&remainder)]
}

#[test]
fn a_dropped_remainder_is_caught() {
    for k in [1, 7, 20, 40, 60, 90] {
        // 2 sin(k)/k
        let truth = Interval::from_int(crate::number::Precision::new(200), k);
        let truth = DoubleInterval::around(&(crate::number::Special::sin(&truth).times(2) / truth));
        let holds = |found: &DoubleInterval| found.lower() <= truth.lower() && found.upper() >= truth.upper();
        let [sum, with_remainder] = wave(k);
        assert!(holds(&with_remainder), "{k}: {with_remainder:?} without {truth:?}");
        assert!(k < 40 || !holds(&sum), "{k}: {sum:?}");
    }
}

/// Ends whose middle takes more bits than a bound has are refused.
#[test]
fn pieces_have_exact_ends() {
    let far = Float::with_val(200, 1) + (Float::with_val(200, 1) >> 90u32);
    assert!(LegendrePanel::new(&Float::with_val(64, 0), &far).is_none());
}
