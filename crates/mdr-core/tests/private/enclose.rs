//! The remainder of each piece counts: dropped for one of them, the enclosure fails.

use super::*;

/// 1/(1 + 4t²) on [−1, 1], with poles at ±i/2 and the integral arctan 2, and t² beside it.
struct Runge {
    in_doubles: bool,
}

impl Integrand for Runge {
    fn at<T: Analytic>(&self, t: &T) -> Option<Vec<T>> {
        let one = t.integer(1);
        let square = t.squared();
        Some(vec![one.quotient(&one.plus(&t.integer(4).product(&square)))?, square])
    }

    fn is_moderate(&self) -> bool {
        self.in_doubles
    }
}

/// In intervals of any precision, and where they bound it in doubles.
fn runge(bits: u32, exponent: i32, in_doubles: bool, keep: impl Fn(usize) -> bool) -> Vec<Interval> {
    let tolerances = vec![Float::with_val(BOUND_BITS, Float::i_exp(1, exponent)); 2];
    let goal = Goal { bits, tolerances, pieces: 200 };
    let ends = [Float::with_val(BOUND_BITS, -1), Float::with_val(BOUND_BITS, 1)];
    let kept = |piece, error: Float| if keep(piece) { error } else { Float::new(BOUND_BITS) };
    pieces(&Runge { in_doubles }, [&ends[0], &ends[1]], &goal, kept).unwrap()
}

fn truths() -> [Interval; 2] {
    let two = Interval::from_int(Precision::new(300), 2);
    [crate::number::Special::atan(&two), two.ratio(2, 3)]
}

/// Whether the enclosures meet the truths, which are narrower by far.
fn hold(found: &[Interval]) -> bool {
    found.iter().zip(truths()).all(|(found, truth)| found.overlaps(&truth))
}

#[test]
fn enclosures_hold_at_any_precision_and_tolerance() {
    for bits in [8, 12, 16, 20, 24, 53, 64, 113, 300] {
        for exponent in [-1, -4, -8, -(bits as i32)] {
            for in_doubles in [false, true] {
                let found = runge(bits, exponent, in_doubles, |_| true);
                assert!(hold(&found), "{bits} bits, 2^{exponent}: {found:?}");
            }
        }
    }
}

/// One rule on all of the range, as its tolerance is wide: the truth lies outside of the sum by more than its rounding.
#[test]
fn a_dropped_remainder_is_caught() {
    for bits in [12, 16, 20, 24] {
        for in_doubles in [false, true] {
            assert!(hold(&runge(bits, 8, in_doubles, |_| true)));
            let short = runge(bits, 8, in_doubles, |piece| piece != 1);
            assert!(!hold(&short), "{bits} bits: {short:?}");
        }
    }
}

#[test]
fn a_spent_number_of_pieces_is_an_error() {
    let goal = Goal { bits: 64, tolerances: vec![Float::with_val(BOUND_BITS, 1e-22); 2], pieces: 2 };
    let ends = [Float::with_val(BOUND_BITS, -1), Float::with_val(BOUND_BITS, 1)];
    let found = enclose(&Runge { in_doubles: false }, [&ends[0], &ends[1]], &goal);
    assert!(matches!(found, Err(Error::Undecided { quantity: Quantity::Integral, bits: 64, .. })), "{found:?}");
}
