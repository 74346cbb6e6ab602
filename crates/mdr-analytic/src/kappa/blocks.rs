//! Runs of terms of the [series](super::series) for n = p/q, as exact fractions.
//!
//! The term ratio is −(p+qm)(2q(m+1)−p) / ((p+2q(2m+1))(p+4q(m+1))), the weight (3p+2q(3m+1))/(p+2q(2m+1)). If p and q
//! are short, a machine word holds several terms and two words twice as many; longer runs use long integers.

use rug::{Integer, Rational};

/// Consecutive terms over one denominator. With the product P at the first of them, their sum is P · sum/below, and the
/// product at the next term is P · above/below.
#[derive(Clone, Debug)]
pub(super) struct Block<T> {
    /// The product of the numerators of the term ratio, with sign.
    pub(super) above: T,
    /// The product of the denominators.
    pub(super) below: T,
    /// The sum of the terms times `below`.
    pub(super) sum: T,
}

/// Denominators in a word stay below this. As |above| ≤ below and every weight is at most 3, the sum of up to
/// [`TERMS`] terms stays below 2⁶³, and all of [`Series::double_word`] below 2¹²⁷.
const WORD: i64 = 1 << 57;

/// The most terms in a word.
const TERMS: u32 = 12;

/// The terms for one n = p/q, p and q short.
pub(super) struct Series {
    p: i64,
    q: i64,
    /// Bits of the largest factor.
    longest: u32,
    /// From this term on, at least x − 1 for n = 2x, the term ratio is below 1/8; before it the ratio is below 1.
    pub(super) settled: u32,
    /// This number of terms leaves less than 2^−bits.
    pub(super) terms: u32,
}

impl Series {
    /// `None` if two factors do not fit in a word.
    pub(super) fn new(n: &Rational, bits: u32) -> Option<Self> {
        let (p, q) = (n.numer().to_i64()?, n.denom().to_i64()?);
        let settled = u32::try_from(p / q.checked_mul(2)?).ok()?;
        let terms = settled.checked_add(bits.div_ceil(3))?;
        let largest = q.checked_mul(6 * i64::from(terms + 2))?.checked_add(p.checked_mul(3)?)?;
        let longest = i64::BITS - largest.leading_zeros();
        (2 * longest < 57).then_some(Series { p, q, longest, settled, terms })
    }

    /// The number of terms in a run whose denominators have `bits` bits.
    pub(super) fn terms_in(&self, bits: u32) -> u32 {
        (bits / (2 * self.longest)).max(1)
    }

    /// As many terms from the given one as fit in a word, up to `to`; with the first term that is left.
    fn word(&self, from: u32, to: u32) -> (Block<i64>, u32) {
        let (p, q, m) = (self.p, self.q, i64::from(from));
        let [mut rising, mut falling] = [p + q * m, p - 2 * q * (m + 1)];
        let [mut odd, mut even] = [p + 2 * q * (2 * m + 1), p + 4 * q * (m + 1)];
        let mut weight = 3 * p + 2 * q * (3 * m + 1);
        let mut block = Block { above: 1_i64, below: 1_i64, sum: 0_i64 };
        let mut term = from;
        while term < to.min(from + TERMS) {
            let both = odd * even;
            let Some(below) = block.below.checked_mul(both).filter(|below| *below < WORD) else { break };
            block.sum = block.sum * both + block.above * (weight * even);
            block.above *= rising * falling;
            block.below = below;
            rising += q;
            falling -= 2 * q;
            odd += 4 * q;
            even += 4 * q;
            weight += 6 * q;
            term += 1;
        }
        (block, term)
    }

    /// As many terms from the given one as fit in two words, up to `to`; with the first term that is left.
    pub(super) fn double_word(&self, from: u32, to: u32) -> (Block<i128>, u32) {
        let (first, middle) = self.word(from, to);
        let (second, end) = self.word(middle, to);
        (first.widen().then(&second.widen()), end)
    }

    /// The terms from `from` up to `to`, in a tree whose operands double in length from level to level.
    pub(super) fn long(&self, from: u32, to: u32) -> (Block<Integer>, u32) {
        let mut level = Vec::new();
        let mut term = from;
        while term < to {
            let (leaf, next) = self.double_word(term, to);
            level.push(Block::from(leaf));
            term = next;
        }
        while level.len() > 1 {
            let mut blocks = level.into_iter();
            let pair = || blocks.next().map(|left| (left, blocks.next()));
            level = std::iter::from_fn(pair)
                .map(|(left, right)| match right {
                    Some(right) => left.then(&right),
                    None => left,
                })
                .collect();
        }
        (level.pop().unwrap_or_else(|| Block { above: 1.into(), below: 1.into(), sum: 0.into() }), term)
    }
}

impl Block<i64> {
    fn widen(&self) -> Block<i128> {
        Block { above: self.above.into(), below: self.below.into(), sum: self.sum.into() }
    }
}

impl From<Block<i128>> for Block<Integer> {
    fn from(block: Block<i128>) -> Self {
        Block { above: block.above.into(), below: block.below.into(), sum: block.sum.into() }
    }
}

impl Block<i128> {
    /// This run and the following one.
    fn then(&self, next: &Self) -> Self {
        Block {
            sum: self.sum * next.below + self.above * next.sum,
            above: self.above * next.above,
            below: self.below * next.below,
        }
    }
}

impl Block<Integer> {
    /// This run and the following one.
    fn then(self, next: &Self) -> Self {
        Block {
            sum: self.sum * &next.below + Integer::from(&self.above * &next.sum),
            above: self.above * &next.above,
            below: self.below * &next.below,
        }
    }
}
