//! κ_n for a rational n, by binary splitting of the series with three bits a term.
//!
//! With n = P/Q the term ratio of the [series] is
//! −(P+Qm)(2Q(m+1)−P) / ((P+2Q(2m+1))(P+4Q(m+1))) and the weight (3P+2Q(3m+1))/(P+2Q(2m+1)): small integers when P and Q
//! are. A run of terms is one exact fraction T/D, computed in a tree whose operands double from level to level. The runs
//! are as long as the precision; only from one to the next is there rounding.

use mdr_core::number::{Interval, Precision, Real};
use rug::float::Round;
use rug::{Float, Integer, Rational};

use super::{brouncker, expansion, series};

/// An enclosure of κ_n for a rational n > 0, a few units in the last place wide at the given precision.
///
/// Binary splitting where n has few digits, so that ten thousand digits of κ_{1/3} take milliseconds; the expansions for
/// a general n elsewhere.
///
/// ```
/// use mdr_analytic::kappa_enclosure;
/// use mdr_core::number::Precision;
/// let kappa = kappa_enclosure(Precision::new(120), &(1, 2).into());
/// assert!(kappa.accuracy_bits() > 110);
/// assert!((kappa.mid().to_f64() - 1.3110287771460599).abs() < 1e-15);
/// ```
pub fn kappa_enclosure(precision: Precision, n: &Rational) -> Interval {
    let bits = precision.bits() + GUARD;
    let enclosure = match plan(n, bits) {
        Plan::Split { terms } => split_series(n, terms, bits),
        Plan::Expand => interval_kappa(&Interval::from_rational(Precision::new(bits), n)),
    };
    round(&enclosure, precision)
}

/// Bits that the rounding errors of an expansion may use up.
const GUARD: u32 = 8;

/// Terms that are summed one by one.
const LEAF: u32 = 16;

enum Plan {
    /// Binary splitting of the series.
    Split { terms: u32 },
    /// The expansion for a general n.
    Expand,
}

/// A step of the continued fraction is a long division, a term of the series a few short products; factors longer than
/// the precision are no longer short.
fn plan(n: &Rational, bits: u32) -> Plan {
    let approximate = n.to_f64();
    let size = n.numer().significant_bits() + n.denom().significant_bits();
    let fewest_terms = f64::from(bits / 3).max(approximate / 2.0);
    let shallow = brouncker::depth(approximate, bits)
        .is_some_and(|depth| f64::from(depth) * f64::from(bits) < 80.0 * fewest_terms);
    if shallow || size > 128 + bits { Plan::Expand } else { Plan::Split { terms: series::terms(approximate, bits) } }
}

/// κ_n for an interval n ≥ 0. κ grows with n, so a wide interval is treated at its ends.
pub(super) fn interval_kappa(n: &Interval) -> Interval {
    const SLACK: i64 = 16;
    if n.accuracy_bits() >= i64::from(n.precision()) - SLACK {
        return expansion(n);
    }
    let end = |end: &Float| expansion(&Interval::point(end.clone()));
    let (lower, upper) = (end(n.lower()), end(n.upper()));
    Interval::new(lower.lower().clone(), upper.upper().clone())
}

/// The sum of `terms` terms as an interval of the given precision, remainder included.
pub(super) fn split_series(n: &Rational, terms: u32, bits: u32) -> Interval {
    let ratio = Ratio::new(n, terms);
    let enclose = |value: &Integer| {
        let end = |round| Float::with_val_round(bits, value, round).0;
        Interval::new(end(Round::Down), end(Round::Up))
    };
    let mut sum = Interval::from_int(Precision::new(bits), 0);
    let mut product = sum.lit(1);
    let run = usize::try_from((bits / ratio.bits_per_term).max(LEAF)).unwrap_or(usize::MAX);
    for from in (0..terms).step_by(run) {
        let Block { above, below, sum: part } = ratio.split(from, terms.min(from.saturating_add(run as u32)));
        product /= &enclose(&below);
        sum += &(enclose(&part) * &product);
        product *= &enclose(&above);
    }
    sum.inflate(&product.times(2))
}

/// The same interval with ends rounded outward to fewer bits.
fn round(value: &Interval, precision: Precision) -> Interval {
    let end = |value: &Float, round| Float::with_val_round(precision.bits(), value, round).0;
    Interval::new(end(value.lower(), Round::Down), end(value.upper(), Round::Up))
}

/// n = p/q.
struct Ratio {
    p: Integer,
    q: Integer,
    /// The same in machine words, when all factors up to the last term fit in words.
    words: Option<(i64, i64)>,
    /// The size of a denominator of the term ratio, about.
    bits_per_term: u32,
}

/// Consecutive terms over one denominator: the products of the numerators and denominators of the term ratio, and the
/// sum times `below`.
struct Block {
    above: Integer,
    below: Integer,
    sum: Integer,
}

impl Ratio {
    fn new(n: &Rational, terms: u32) -> Self {
        let (p, q) = (n.numer().clone(), n.denom().clone());
        let largest = (Integer::from(&p * 3u32) + Integer::from(&q * 6u32) * (terms + 1)).significant_bits();
        let words = (largest < 63).then(|| (p.to_i64_wrapping(), q.to_i64_wrapping()));
        Ratio { p, q, words, bits_per_term: 2 * largest }
    }

    fn split(&self, from: u32, to: u32) -> Block {
        match self.words {
            Some((p, q)) if to - from <= LEAF => return short_terms(p, q, from, to),
            None if to - from == 1 => return self.long_term(from),
            _ => {}
        }
        let middle = from + (to - from) / 2;
        let (left, right) = (self.split(from, middle), self.split(middle, to));
        Block {
            sum: left.sum * &right.below + Integer::from(&left.above * &right.sum),
            above: left.above * right.above,
            below: left.below * right.below,
        }
    }

    fn long_term(&self, m: u32) -> Block {
        let factor = |p: i32, q: u32| Integer::from(&self.p * p) + Integer::from(&self.q * q);
        let even = factor(1, 4 * m + 4);
        Block {
            sum: factor(3, 6 * m + 2) * &even,
            above: -factor(1, m) * factor(-1, 2 * m + 2),
            below: factor(1, 4 * m + 2) * even,
        }
    }
}

fn short_terms(p: i64, q: i64, from: u32, to: u32) -> Block {
    let mut block = Block { above: Integer::from(1), below: Integer::from(1), sum: Integer::new() };
    for m in (from..to).map(i64::from) {
        let factor = |k: i64, l: i64| i128::from(k * p + l * q);
        let even = factor(1, 4 * m + 4);
        let below = factor(1, 4 * m + 2) * even;
        multiply(&mut block.sum, below);
        let mut term = block.above.clone();
        multiply(&mut term, factor(3, 6 * m + 2) * even);
        block.sum += term;
        multiply(&mut block.above, -factor(1, m) * factor(-1, 2 * m + 2));
        multiply(&mut block.below, below);
    }
    block
}

/// By one word where the factor is one.
fn multiply(value: &mut Integer, factor: i128) {
    match i64::try_from(factor) {
        Ok(word) => *value *= word,
        Err(_) => *value *= factor,
    }
}
