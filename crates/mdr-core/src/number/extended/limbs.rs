//! Unsigned integers of N words, least significant first. N is a small constant, so the loops unroll.

use std::cmp::Ordering;

/// a + b, and the carry.
#[inline]
pub(super) fn add<const N: usize>(a: &[u64; N], b: &[u64; N]) -> ([u64; N], bool) {
    let mut sum = [0; N];
    let mut carry = false;
    for i in 0..N {
        let (s, c1) = a[i].overflowing_add(b[i]);
        let (s, c2) = s.overflowing_add(u64::from(carry));
        sum[i] = s;
        carry = c1 | c2;
    }
    (sum, carry)
}

/// a − b − borrow for a ≥ b + borrow.
#[inline]
pub(super) fn sub<const N: usize>(a: &[u64; N], b: &[u64; N], mut borrow: bool) -> [u64; N] {
    let mut difference = [0; N];
    for i in 0..N {
        let (d, b1) = a[i].overflowing_sub(b[i]);
        let (d, b2) = d.overflowing_sub(u64::from(borrow));
        difference[i] = d;
        borrow = b1 | b2;
    }
    difference
}

#[inline]
pub(super) fn compare<const N: usize>(a: &[u64; N], b: &[u64; N]) -> Ordering {
    for i in (0..N).rev() {
        if a[i] != b[i] {
            return a[i].cmp(&b[i]);
        }
    }
    Ordering::Equal
}

#[inline]
pub(super) fn is_zero<const N: usize>(a: &[u64; N]) -> bool {
    a.iter().all(|&word| word == 0)
}

/// The number of trailing zero bits.
#[inline]
pub(super) fn trailing_zeros<const N: usize>(a: &[u64; N]) -> i64 {
    let words = a.iter().take_while(|&&word| word == 0).count();
    64 * words as i64 + a.get(words).map_or(0, |word| i64::from(word.trailing_zeros()))
}

/// a shifted down by `bits`, with one more word below it and whether any bit below that was lost.
#[inline]
pub(super) fn shift_down<const N: usize>(a: &[u64; N], bits: u64) -> ([u64; N], u64, bool) {
    if bits == 0 {
        return (*a, 0, false);
    }
    if bits >= 64 * (N as u64 + 1) {
        return ([0; N], 0, !is_zero(a));
    }
    let (words, bits) = ((bits / 64) as usize, (bits % 64) as u32);
    // Word i of the result joins the words i + words and i + words + 1; word −1 is the guard.
    let word = |i: usize| if i < N { a[i] } else { 0 };
    let joined = |low: u64, high: u64| if bits == 0 { low } else { low >> bits | high << (64 - bits) };
    let mut shifted = [0; N];
    for (i, s) in shifted.iter_mut().enumerate() {
        *s = joined(word(i + words), word(i + words + 1));
    }
    let guard = if words == 0 { joined(0, a[0]) } else { joined(word(words - 1), word(words)) };
    let mut lost = words > 0 && bits > 0 && a[words - 1] << (64 - bits) != 0;
    for &low in a.iter().take(words.saturating_sub(1)) {
        lost |= low != 0;
    }
    (shifted, guard, lost)
}

/// (a, guard) shifted up until the top bit is set: the words, the rest of the guard, and the shift. `None` for zero.
#[inline]
pub(super) fn normalise<const N: usize>(mut a: [u64; N], mut guard: u64) -> Option<([u64; N], u64, i64)> {
    let mut shift = 0;
    while a[N - 1] == 0 {
        for i in (1..N).rev() {
            a[i] = a[i - 1];
        }
        a[0] = guard;
        guard = 0;
        shift += 64;
        if shift > 64 * N as i64 {
            return None;
        }
    }
    let bits = a[N - 1].leading_zeros();
    if bits > 0 {
        for i in (1..N).rev() {
            a[i] = a[i] << bits | a[i - 1] >> (64 - bits);
        }
        a[0] = a[0] << bits | guard >> (64 - bits);
        guard <<= bits;
    }
    Some((a, guard, shift + i64::from(bits)))
}

/// The product a·b: its upper and its lower half.
#[inline]
pub(super) fn mul<const N: usize>(a: &[u64; N], b: &[u64; N]) -> ([u64; N], [u64; N]) {
    let mut halves = [[0u64; N]; 2];
    for i in 0..N {
        let mut carry = 0u64;
        for j in 0..N {
            let word = &mut halves[(i + j) / N][(i + j) % N];
            let t = u128::from(a[i]) * u128::from(b[j]) + u128::from(*word) + u128::from(carry);
            *word = t as u64;
            carry = (t >> 64) as u64;
        }
        halves[1][i] = carry;
    }
    let [low, high] = halves;
    (high, low)
}

/// a·k: the words and the carry word.
#[inline]
pub(super) fn mul_word<const N: usize>(a: &[u64; N], k: u64) -> ([u64; N], u64) {
    let mut product = [0; N];
    let mut carry = 0u64;
    for i in 0..N {
        let t = u128::from(a[i]) * u128::from(k) + u128::from(carry);
        product[i] = t as u64;
        carry = (t >> 64) as u64;
    }
    (product, carry)
}

/// a·2⁶⁴/k: the N upper words, the lowest word, and whether there is a remainder.
#[inline]
pub(super) fn div_word<const N: usize>(a: &[u64; N], k: u64) -> ([u64; N], u64, bool) {
    let mut quotient = [0; N];
    let mut remainder = 0u64;
    for i in (0..N).rev() {
        let t = u128::from(remainder) << 64 | u128::from(a[i]);
        quotient[i] = (t / u128::from(k)) as u64;
        remainder = (t % u128::from(k)) as u64;
    }
    let t = u128::from(remainder) << 64;
    (quotient, (t / u128::from(k)) as u64, t % u128::from(k) != 0)
}

/// ⌊(a + next·2⁻⁶⁴)·2^(64N)/b⌋ for a < b with the top bit of b set (Knuth's algorithm D), and whether there is a remainder.
#[inline]
pub(super) fn div<const N: usize>(a: [u64; N], next: u64, b: &[u64; N]) -> ([u64; N], bool) {
    let mut remainder = a;
    let mut incoming = next;
    let mut quotient = [0; N];
    for digit in quotient.iter_mut().rev() {
        let top = remainder[N - 1];
        let below = if N == 1 { incoming } else { remainder[N.saturating_sub(2)] };
        let mut q = if top >= b[N - 1] {
            u64::MAX
        } else {
            ((u128::from(top) << 64 | u128::from(below)) / u128::from(b[N - 1])) as u64
        };
        // remainder·2⁶⁴ + incoming − q·b, modulo 2^(64(N+1)); `over` is its top word.
        let mut shifted = [0; N];
        shifted[1..].copy_from_slice(&remainder[..N - 1]);
        shifted[0] = incoming;
        let (product, carry) = mul_word(b, q);
        let mut over = top.wrapping_sub(carry).wrapping_sub(u64::from(compare(&shifted, &product).is_lt()));
        remainder = sub(&shifted, &product, false);
        while over != 0 {
            q -= 1;
            let (sum, carry) = add(&remainder, b);
            remainder = sum;
            over = over.wrapping_add(u64::from(carry));
        }
        *digit = q;
        incoming = 0;
    }
    (quotient, !is_zero(&remainder))
}
