//! Extended precision in pure Rust: a significand of 64·N bits, an exponent of its own, and a running error bound.

mod arithmetic;
mod compare;
mod exponential;
mod limbs;
mod logarithm;
mod real;
mod root;
mod round;
mod tables;

/// A number of 64·N bits together with a bound on its relative error: ball arithmetic in a few machine words.
///
/// * The exponent is a separate `i64`, so intermediate results of a formula do not overflow or underflow.
/// * Every operation adds its rounding error and the errors of its operands to [`error`](Extended::error). An operation
///   whose result is representable is exact and adds nothing, so `0` and the sign of a difference are decided by
///   arithmetic, never by a tolerance.
/// * A difference of numbers that is smaller than their errors is *around zero*: only a bound of its magnitude is
///   known. Outside the domain of a function, or with an exponent beyond ±2⁶², nothing is known, and the value is not
///   [finite](super::Real::is_finite). Comparisons are certain or `None`. If the result is not precise enough, evaluate
///   the same formula with a larger `N` (Ziv's strategy).
///
/// `Extended<1>` is the fastest: about 2⁻⁶³ per operation, with table-driven exponential and logarithm, in integer
/// arithmetic only, so that every machine gives the same bits. N is 1, 2, 3 or 4.
///
/// ```
/// use mdr_core::number::{Real, Extended};
/// let x = Extended::<1>::from_f64((), 2.0);
/// assert_eq!(x.sqrt().nearest_f64(), Some(2.0_f64.sqrt()));
/// // 10³⁰⁰ squared does not overflow, and its square root comes back.
/// let big = Extended::<1>::from_f64((), 1e300);
/// assert_eq!(big.square().sqrt().nearest_f64(), Some(1e300));
/// // √2·√2 − 2 is zero or it is not: 64 bits cannot say.
/// assert_eq!((x.sqrt().square() - x).partial_cmp(&x.lit(0)), None);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Extended<const N: usize> {
    negative: bool,
    /// Least significant first; the top bit is set unless the number is zero or unknown.
    limbs: [u64; N],
    /// The magnitude is 0.limbs · 2^exponent.
    exponent: i64,
    /// |true − stored| ≤ error · 2^(−64N) · |stored|. If it is infinite the limbs are zero, and |true| ≤ 2^exponent.
    /// Sums of errors are rounded to 53 bits; [`round`] allows for that.
    error: f64,
}

const TWO_64: f64 = (1u128 << 64) as f64;

/// Exponents stay within ± this.
const EXPONENT_LIMIT: i64 = 1 << 62;

impl<const N: usize> Extended<N> {
    /// Above this error, an eighth of the magnitude, only a bound of the magnitude is kept.
    const ERROR_LIMIT: f64 = (1u128 << 61) as f64 * Self::UNITS;

    /// 2^(64(N−1)), the number of units of 2^(−64N) in 2⁻⁶⁴.
    const UNITS: f64 = [1.0, TWO_64, TWO_64 * TWO_64, TWO_64 * TWO_64 * TWO_64][N - 1];

    /// Bits in the significand.
    const BITS: i64 = 64 * N as i64;

    /// Exactly zero.
    const ZERO: Self = Extended { negative: false, limbs: [0; N], exponent: 0, error: 0.0 };

    /// Nothing is known.
    const NOTHING: Self = Extended { negative: false, limbs: [0; N], exponent: i64::MAX, error: f64::INFINITY };

    /// The magnitude is at most 2^exponent.
    #[cold]
    fn around_zero(exponent: i64) -> Self {
        if exponent > EXPONENT_LIMIT {
            return Self::NOTHING;
        }
        Extended { negative: false, limbs: [0; N], exponent: exponent.max(-EXPONENT_LIMIT), error: f64::INFINITY }
    }

    /// ±(0.limbs)·2^exponent with a relative error of at most `error` units of 2^(−64N). The top bit of the last limb must
    /// be set.
    ///
    /// For functions that compute a significand in integer arithmetic, such as a fit of a special function.
    #[inline]
    pub fn from_parts(negative: bool, limbs: [u64; N], exponent: i64, error: f64) -> Self {
        debug_assert!(limbs[N - 1] >> 63 == 1, "the significand is normalised");
        if (error > Self::ERROR_LIMIT) | (exponent.unsigned_abs() > EXPONENT_LIMIT as u64) {
            return Self::given_up(exponent, error);
        }
        Extended { negative, limbs, exponent, error }
    }

    /// The result for a number whose error, or whose exponent, is too large.
    #[cold]
    fn given_up(exponent: i64, error: f64) -> Self {
        // |stored|(1 + error · 2^(−64N)).
        let growth = (error.log2() as i64 + 2).saturating_sub(Self::BITS).max(1);
        if error.is_finite() { Self::around_zero(exponent.saturating_add(growth)) } else { Self::NOTHING }
    }

    /// A positive constant of up to 256 bits, truncated.
    fn constant((limbs, exponent): ([u64; 4], i64)) -> Self {
        let mut top = [0; N];
        top.copy_from_slice(&limbs[4 - N..]);
        Extended { negative: false, limbs: top, exponent, error: 2.0 }
    }

    /// The significand 0.limbs, in [1/2, 1) unless the number is zero; least significant limb first.
    #[inline]
    pub fn limbs(&self) -> &[u64; N] {
        &self.limbs
    }

    /// e such that the magnitude is in [2^(e−1), 2^e).
    #[inline]
    pub fn exponent(&self) -> i64 {
        self.exponent
    }

    /// The bound on the relative error in units of 2^(−64N); 0 for an exact number, ∞ around zero.
    #[inline]
    pub fn error(&self) -> f64 {
        self.error
    }

    /// This number with a relative error larger by `units` of 2^(−64N).
    #[inline]
    #[must_use]
    pub fn widened(self, units: f64) -> Self {
        if self.is_hollow() {
            return self;
        }
        Self::from_parts(self.negative, self.limbs, self.exponent, units + Self::second_order(self.error))
    }

    /// This number with an absolute error larger by 2^exponent.
    fn blurred(self, exponent: i64) -> Self {
        if self.is_zero() {
            return Self::around_zero(exponent);
        }
        if self.is_hollow() {
            return Self::around_zero(self.exponent.max(exponent).saturating_add(1));
        }
        // In units of the number: 2^exponent/|self| ≤ 2^(exponent − e + 1).
        match exponent.saturating_sub(self.exponent) {
            0.. => Self::around_zero(exponent.saturating_add(2)),
            below => self.widened(power_of_two(below.saturating_add(1 + Self::BITS))),
        }
    }

    /// Certainly zero.
    #[inline]
    pub fn is_zero(&self) -> bool {
        self.limbs[N - 1] == 0 && self.error == 0.0
    }

    /// Zero or around zero: there is no significand to compute with.
    #[inline]
    fn is_hollow(&self) -> bool {
        self.limbs[N - 1] == 0
    }

    #[inline]
    fn is_around_zero(&self) -> bool {
        self.error == f64::INFINITY
    }

    #[inline]
    fn is_nothing(&self) -> bool {
        self.error == f64::INFINITY && self.exponent == i64::MAX
    }

    #[inline]
    fn is_exact(&self) -> bool {
        self.error == 0.0
    }

    /// An error including the terms of second order: below 2δ² where δ ≤ 1/8 is the relative error, hence below a unit
    /// for every number that is known to half its bits.
    #[inline]
    fn second_order(error: f64) -> f64 {
        let square = error * (1.0 / TWO_64 / Self::UNITS) * error;
        if square < 0.25 { error + if error == 0.0 { 0.0 } else { 1.0 } } else { error + 1.0 + 2.0 * square }
    }

    /// The stored number, regarded as exact.
    fn exactly(self) -> Self {
        if self.is_nothing() { self } else { Extended { error: 0.0, ..self } }
    }

    /// self · 2^k, exactly.
    #[inline]
    #[must_use]
    pub fn scaled(self, k: i64) -> Self {
        match (self.is_hollow(), self.is_zero()) {
            (false, _) => Self::from_parts(self.negative, self.limbs, self.exponent.saturating_add(k), self.error),
            (_, true) => self,
            _ => Self::around_zero(self.exponent.saturating_add(k)),
        }
    }
}

/// 2^exponent, from 2⁻⁶⁴ upwards.
#[inline]
fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((exponent.clamp(-64, 1024) + 1023) as u64) << 52)
}

/// The error of truncation: below one unit in the last place, which is up to 2^(1−64N) of the number.
#[inline]
fn truncation(inexact: bool) -> f64 {
    if inexact { 2.0 } else { 0.0 }
}
