//! κ_n for a rational n in fixed point, by blocks of terms, with the error counted in units of the last place.
//!
//! The value of the series from the k-th [block](super::blocks) on is V_k = (sum_k + above_k V_{k+1})/below_k: Horner's
//! rule from the last block to the first, each step a product, a sum and a quotient of integers. V_k contributes to κ_n
//! = V_0 with the factor Π_{j<k} above_j/below_j, which decreases by three bits per term; so V_k is stored with as many
//! places fewer, and an error of one unit in it is at most one unit of V_0. After the last block the value is f ∈ (0,
//! 2], as proved in [series](super::series), and is stored as 1 ± 1.

use std::ops::{DivAssign, MulAssign};

use mdr_core::number::RoundingCount;
use rug::{Assign, Float, Integer};

use super::blocks::{Block, Series};

/// The sum of the series with this number of binary places. `run(from, to)` gives a block of terms from `from`, at most
/// up to `to`, with the first term that is left.
pub(super) fn sum<T>(series: &Series, places: u32, run: impl Fn(u32, u32) -> (Block<T>, u32)) -> RoundingCount
where
    Integer: for<'a> MulAssign<&'a T> + for<'a> DivAssign<&'a T> + for<'a> Assign<&'a T>,
{
    let places_from = |term: u32| places.saturating_sub(3 * term.saturating_sub(series.settled));
    let mut blocks = Vec::with_capacity(32);
    let mut term = 0;
    while term < series.terms {
        let (block, next) = run(term, series.terms);
        blocks.push((block, term));
        term = next;
    }
    let size = places as usize + 256;
    let (mut units, mut addend) = (Integer::with_capacity(size), Integer::with_capacity(size));
    let mut behind = places_from(series.terms);
    units.set_bit(behind, true);
    for (block, term) in blocks.iter().rev() {
        let before = places_from(*term);
        units *= &block.above;
        addend.assign(&block.sum);
        addend <<= behind;
        units += &addend;
        units <<= before - behind;
        units /= &block.below;
        behind = before;
    }
    // One unit for each quotient, one for the end of the series, and one for the value as a float, which is at least 1.
    let value = Float::with_val(places, units) >> places;
    RoundingCount::new(value, blocks.len() as u64 + 2)
}
