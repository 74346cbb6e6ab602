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
#[cfg(all(test, feature = "mp"))]
mod tests;

/// A number of 64·N bits together with a bound on its relative error: ball arithmetic in a few machine words.
///
/// * The exponent is an `i64` of its own, so that no intermediate result of a formula overflows or underflows.
/// * Every operation adds its rounding error and the errors of its operands to [`error`](Wide::error). An operation whose
///   result is representable is exact and adds nothing, so `0` and the sign of a difference are decided by arithmetic,
///   never by a tolerance.
/// * A difference of numbers whose errors are larger than it is *around zero*: a bound of its magnitude is all that is
///   known. Outside the domain of a function, or with an exponent beyond ±2⁶², nothing is known, and the value is not
///   [finite](super::Real::is_finite). Order is certain or absent. Whoever needs more evaluates the same formula with a
///   larger `N` (Ziv's strategy).
///
/// `Wide<1>` is the fast one: about 2⁻⁶³ an operation with table-driven exponential and logarithm, in integer arithmetic
/// only, so that every machine gives the same bits. N is 1, 2, 3 or 4.
///
/// ```
/// use mdr_core::number::{Real, Wide};
/// let x = Wide::<1>::from_f64((), 2.0);
/// assert_eq!(x.sqrt().nearest_f64(), Some(2.0_f64.sqrt()));
/// // 10³⁰⁰ squared does not overflow, and its square root comes back.
/// let big = Wide::<1>::from_f64((), 1e300);
/// assert_eq!(big.square().sqrt().nearest_f64(), Some(1e300));
/// // √2·√2 − 2 is zero or it is not: 64 bits cannot say.
/// assert_eq!((x.sqrt().square() - x).partial_cmp(&x.lit(0)), None);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Wide<const N: usize> {
    negative: bool,
    /// Least significant first; the top bit is set unless the number is zero or unknown.
    limbs: [u64; N],
    /// The magnitude is 0.limbs · 2^exponent.
    exponent: i64,
    /// |true − stored| ≤ error · 2^(−64N) · |stored|. When it is `AROUND_ZERO` the limbs are zero, and |true| ≤ 2^exponent.
    error: u64,
}

/// The error of a number of which only the largest possible magnitude is known.
const AROUND_ZERO: u64 = u64::MAX;

/// Exponents are kept within ± this.
const EXPONENT_LIMIT: i64 = 1 << 62;

impl<const N: usize> Wide<N> {
    /// Above this, products of two errors might exceed one unit and the number is given up.
    const ERROR_LIMIT: u64 = if N == 1 { 1 << 31 } else { 1 << 62 };

    /// Bits in the significand.
    const BITS: i64 = 64 * N as i64;

    /// Exactly zero.
    const ZERO: Self = Wide { negative: false, limbs: [0; N], exponent: 0, error: 0 };

    /// Nothing is known.
    const NOTHING: Self = Wide { negative: false, limbs: [0; N], exponent: i64::MAX, error: AROUND_ZERO };

    /// The magnitude is at most 2^exponent.
    #[cold]
    fn around_zero(exponent: i64) -> Self {
        if exponent > EXPONENT_LIMIT {
            return Self::NOTHING;
        }
        Wide { negative: false, limbs: [0; N], exponent: exponent.max(-EXPONENT_LIMIT), error: AROUND_ZERO }
    }

    /// ±(0.limbs)·2^exponent with a relative error of at most `error` units of 2^(−64N). The top bit of the last limb must
    /// be set.
    ///
    /// Made for functions that compute a significand by integer arithmetic, as the fit of a special function does.
    #[inline]
    pub fn from_parts(negative: bool, limbs: [u64; N], exponent: i64, error: u64) -> Self {
        if error > Self::ERROR_LIMIT || exponent.unsigned_abs() > EXPONENT_LIMIT as u64 || limbs[N - 1] >> 63 == 0 {
            return if error == u64::MAX { Self::NOTHING } else { Self::around_zero(exponent.saturating_add(1)) };
        }
        Wide { negative, limbs, exponent, error }
    }

    /// A positive constant of up to 256 bits, truncated.
    fn constant((limbs, exponent): ([u64; 4], i64)) -> Self {
        let mut top = [0; N];
        top.copy_from_slice(&limbs[4 - N..]);
        Wide { negative: false, limbs: top, exponent, error: 2 }
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

    /// The bound on the relative error in units of 2^(−64N); 0 for an exact number, `u64::MAX` around zero.
    #[inline]
    pub fn error(&self) -> u64 {
        self.error
    }

    /// The same number with a relative error larger by `units` of 2^(−64N).
    #[inline]
    #[must_use]
    pub fn widened(self, units: u64) -> Self {
        if self.is_hollow() {
            return self;
        }
        Self::from_parts(self.negative, self.limbs, self.exponent, self.error.saturating_add(units))
    }

    /// The same number with an absolute error larger by 2^exponent.
    fn blurred(self, exponent: i64) -> Self {
        if self.is_zero() {
            return Self::around_zero(exponent);
        }
        // In units of the number: 2^exponent/|self| ≤ 2^(exponent − e + 1).
        match exponent.saturating_sub(self.exponent).saturating_add(1 + Self::BITS) {
            shift if self.is_hollow() || shift > 61 => Self::around_zero(self.exponent.max(exponent).saturating_add(1)),
            shift => self.widened(1 << shift.max(0)),
        }
    }

    /// Certainly zero.
    #[inline]
    pub fn is_zero(&self) -> bool {
        self.limbs[N - 1] == 0 && self.error == 0
    }

    /// Zero or around zero: there is no significand to compute with.
    #[inline]
    fn is_hollow(&self) -> bool {
        self.limbs[N - 1] == 0
    }

    #[inline]
    fn is_around_zero(&self) -> bool {
        self.error == AROUND_ZERO
    }

    #[inline]
    fn is_nothing(&self) -> bool {
        self.error == AROUND_ZERO && self.exponent == i64::MAX
    }

    #[inline]
    fn is_exact(&self) -> bool {
        self.error == 0
    }

    /// The stored number taken as exact.
    fn exactly(self) -> Self {
        if self.is_nothing() { self } else { Wide { error: 0, ..self } }
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
