//! κ_n for n = p/q with q ≤ 4: one arithmetic-geometric mean for each q.
//!
//! κ_n = (n/2) B(n/2, 1/2) = ∫₀¹ dx/√(1 − x^{2/n}). For n = 1/2, 1/3 and 1/4 this is, up to square roots, the complete
//! elliptic integral K(k) = π/(2 agm(1, √(1−k²))) at the singular values k_1, k_3 and k_2 (Selberg and Chowla 1967):
//!
//! κ_{1/2} = π/(2 agm(1, √2)),  κ_{1/3} = π/(3^{1/4} agm(2, √(2+√3))),  κ_{1/4} = π (1+√2)/(4 agm(1, 1+√2)).
//!
//! Other n of the same denominator follow by the reflection of Γ, by κ_n κ_{n+1} = π(n+1)/2, and by that twice:
//!
//! κ_{1−n} = κ_n tan(πn/2) (1−n)/n,  κ_{n+1} = π(n+1)/(2κ_n),  κ_{n+2} = κ_n (n+2)/(n+1).
//!
//! Integers start from κ_0 = 1 and κ_1 = π/2. The results of the mean for 0 < n < 2 are cached per thread, as MPFR
//! caches π: from the second call on κ_n costs a few products with short numbers.

use std::cell::RefCell;

use mdr_core::number::{Precision, RoundingCount};
use rug::{Float, Integer, Rational};

/// Up to this many times the precision in bits for n, the factors (n+2)/(n+1) cost less than other expansions do.
/// Measured together with `SHIFT` in `shifted`.
const REACH: f64 = 1.0;

/// Extra bits in the cache, so that a result depends on earlier calls only with a probability of 2⁻⁶⁰.
const GUARD: u32 = 64;

/// The least number of bits in the cache: they cost little more than fewer.
const LEAST: u32 = 1024;

/// κ_n with the given number of bits. `None` for other denominators, and for n so large that another expansion is
/// faster.
pub(super) fn kappa(n: &Rational, bits: u32) -> Option<RoundingCount> {
    let (p, q) = (n.numer().to_u32()?, n.denom().to_u32()?);
    if q > 4 || f64::from(p) > REACH * f64::from(q) * f64::from(bits) {
        return None;
    }
    let (steps, tip) = (p / (2 * q), p % (2 * q));
    let value = match (tip, q) {
        (0, _) => whole(1, bits),
        (_, 1) => half_pi(bits),
        _ => kept(tip, q, bits),
    };
    if steps == 0 {
        return Some(value);
    }
    // Π (n+2i)/(n+2i−1) for n at the tip, i from 1 on.
    let [tip, q, steps] = [tip, q, steps].map(u64::from);
    let above = product(tip + 2 * q, 2 * q, steps);
    let below = product(tip + q, 2 * q, steps);
    Some(RoundingCount::new(Float::with_val(bits, value.value() * &above) / &below, value.roundings() + 2))
}

fn half_pi(bits: u32) -> RoundingCount {
    RoundingCount::pi(Precision::new(bits)).scaled(&(1, 2).into())
}

/// κ_{p/q} for 0 < p < 2q without common factors, q from 2 to 4.
fn reduced(p: u32, q: u32, bits: u32) -> RoundingCount {
    if p > q {
        half_pi(bits).scaled(&(p, q).into()).over(&reduced(p - q, q, bits))
    } else if p > 1 {
        first(q, bits).scaled(&p.into()).over(&cotangent(q, bits))
    } else {
        first(q, bits)
    }
}

/// κ_{1/q}.
fn first(q: u32, bits: u32) -> RoundingCount {
    let pi = RoundingCount::pi(Precision::new(bits));
    match q {
        2 => pi.over(&whole(1, bits).agm(&whole(2, bits).sqrt()).scaled(&2.into())),
        3 => {
            let root = whole(3, bits).sqrt();
            let mean = whole(2, bits).agm(&root.clone().plus(&whole(2, bits)).sqrt());
            pi.over(&root.sqrt()).over(&mean)
        }
        _ => {
            let side = cotangent(q, bits);
            let mean = whole(1, bits).agm(&side);
            pi.times(&side).over(&mean).scaled(&(1, 4).into())
        }
    }
}

/// cot(π/2q).
fn cotangent(q: u32, bits: u32) -> RoundingCount {
    match q {
        2 => whole(1, bits),
        3 => whole(3, bits).sqrt(),
        _ => whole(2, bits).sqrt().plus(&whole(1, bits)),
    }
}

fn whole(number: u32, bits: u32) -> RoundingCount {
    RoundingCount::new(Float::with_val(bits, number), 0)
}

thread_local! {
    /// κ_{p/q} for 0 < p < 2q, with p and q: ten numbers at most.
    static KEPT: RefCell<Vec<([u32; 2], RoundingCount)>> = const { RefCell::new(Vec::new()) };
}

/// Frees the numbers that κ_n caches in this thread: at most ten, each as long as the longest that was requested. The
/// next call computes them again, with the same result. π is cached by MPFR, see `rug::float::free_cache`.
///
/// ```
/// use mdr_analytic::{free_cache, kappa_enclosure};
/// use mdr_core::number::Precision;
/// let kappa = || kappa_enclosure(Precision::new(2000), &(1, 3).into()).mid();
/// let first = kappa();
/// free_cache();
/// assert_eq!(kappa(), first);
/// ```
pub fn free_cache() {
    KEPT.with_borrow_mut(|kept| *kept = Vec::new());
}

/// κ_{p/q} for 0 < p < 2q, from the cache if it has enough bits, else computed.
fn kept(p: u32, q: u32, bits: u32) -> RoundingCount {
    KEPT.with_borrow_mut(|kept| {
        let needed = bits.saturating_add(GUARD).max(LEAST);
        let known = kept.iter().position(|(of, _)| *of == [p, q]);
        let index = known.unwrap_or(kept.len());
        if known.is_none() {
            kept.push(([p, q], reduced(p, q, needed)));
        } else if kept[index].1.value().prec() < needed {
            kept[index].1 = reduced(p, q, needed);
        }
        // The error of the cached number is less than a unit in the last place here.
        RoundingCount::new(Float::with_val(bits, kept[index].1.value()), 2)
    })
}

/// Π (first + step·i), i from 0 to count − 1.
fn product(first: u64, step: u64, count: u64) -> Integer {
    const FEW: u64 = 32;
    if count > FEW {
        let half = count / 2;
        return product(first, step, half) * product(first + step * half, step, count - half);
    }
    let mut long = Integer::from(1);
    let mut word = 1_u64;
    for i in 0..count {
        let factor = first + step * i;
        word = word.checked_mul(factor).unwrap_or_else(|| {
            long *= word;
            factor
        });
    }
    long * word
}
