//! Positive numbers with a count of their rounding errors.

use rug::float::{Constant, Round, Special, exp_min};
use rug::ops::Pow;
use rug::{Float, Rational};

use super::{Extended, Interval, Precision, Real};

/// A positive number x represented by a `rug::Float` y of p bits and a count k of roundings: (1+u)^−k ≤ x/y ≤ (1+u)^k
/// with u = 2⁻ᵖ.
///
/// Products, quotients, powers and roots add the counts of their operands and one for their own rounding; an integer
/// power multiplies the count. An enclosure of a monomial thus costs half of what two directed roundings do.
///
/// Where the roundings cannot be counted, and near the ends of the exponent range, where a rounding is not a relative
/// error, the number is [unknown](Self::unknown): a NaN that every operation propagates, with the entire line as its
/// [enclosure](Self::enclosure).
///
/// ```
/// use mdr_core::number::{RoundingCount, Precision};
/// // (π/3)^(−5/2)
/// let precision = Precision::new(100);
/// let number = RoundingCount::pi(precision).scaled(&(1, 3).into()).power(-5, 2);
/// let enclosure = number.enclosure(precision);
/// assert!(enclosure.contains(&RoundingCount::pi(Precision::new(200)).scaled(&(1, 3).into()).power(-5, 2).value()));
/// assert!(enclosure.accuracy_bits() > 94);
/// ```
#[derive(Clone, Debug)]
pub struct RoundingCount {
    value: Float,
    roundings: u64,
}

impl RoundingCount {
    /// A positive value with this number of roundings.
    pub fn new(value: Float, roundings: u64) -> Self {
        RoundingCount { value, roundings }
    }

    /// A number of which nothing is known.
    pub fn unknown(precision: Precision) -> Self {
        RoundingCount { value: Float::with_val(precision.bits(), Special::Nan), roundings: 0 }
    }

    /// The result of an operation; `None` roundings make it unknown.
    fn known(value: Float, roundings: Option<u64>) -> Self {
        match roundings {
            Some(roundings) if is_relative(&value) => RoundingCount { value, roundings },
            _ => Self::unknown(Precision::new(value.prec())),
        }
    }

    /// π.
    pub fn pi(precision: Precision) -> Self {
        RoundingCount { value: Float::with_val(precision.bits(), Constant::Pi), roundings: 1 }
    }

    /// The stored value.
    pub fn value(&self) -> &Float {
        &self.value
    }

    /// The number of roundings.
    pub fn roundings(&self) -> u64 {
        self.roundings
    }

    /// The number times a positive rational.
    pub fn scaled(self, factor: &Rational) -> Self {
        let RoundingCount { mut value, roundings } = self;
        let mut added = 0;
        if *factor.numer() != 1 {
            value *= factor.numer();
            added += 1;
        }
        if *factor.denom() != 1 {
            value /= factor.denom();
            added += 1;
        }
        Self::known(value, roundings.checked_add(added))
    }

    /// The product.
    pub fn times(self, other: &Self) -> Self {
        Self::known(self.value * &other.value, self.roundings.checked_add(other.roundings).and_then(one_more))
    }

    /// The quotient.
    pub fn over(self, other: &Self) -> Self {
        Self::known(self.value / &other.value, self.roundings.checked_add(other.roundings).and_then(one_more))
    }

    /// The square root.
    pub fn sqrt(self) -> Self {
        Self::known(self.value.sqrt(), Some(self.roundings.div_ceil(2) + 1))
    }

    /// The sum.
    pub fn plus(self, other: &Self) -> Self {
        Self::known(self.value + &other.value, one_more(self.roundings.max(other.roundings)))
    }

    /// The arithmetic-geometric mean.
    ///
    /// It is homogeneous and increases with both numbers, so it does not magnify their relative errors. With m =
    /// (a+b)/2 and e = (a−b)/(a+b) it is m π/2K(e) = m (1 − e²/4 − θe⁴), 0 ≤ θ < 1/4 for |e| ≤ 1/2: as soon as e⁴ < u
    /// this replaces the last two steps.
    pub fn agm(self, other: &Self) -> Self {
        // The ratio of any two floats is soon below 2, as each step takes its root; from then on the difference is
        // squared.
        const STEPS: u64 = 128;
        let bits = self.value.prec();
        let given = one_more(other.roundings).map(|roundings| roundings.max(self.roundings));
        let (mut a, mut b) = (self.value, Float::with_val(bits, &other.value));
        for step in 0..STEPS {
            if !is_relative(&a) || !is_relative(&b) {
                break;
            }
            let (sum, difference) = (Float::with_val(bits, &a + &b), Float::with_val(bits, &a - &b));
            let apart =
                difference.get_exp().zip(sum.get_exp()).map_or(i64::MIN / 8, |(d, s)| i64::from(d) - i64::from(s));
            let mean = sum >> 1u32;
            // |e| < 2^(apart + 1)
            if 4 * (apart + 1) <= -i64::from(bits) {
                let short = bits / 2 + 16;
                let correction = Float::with_val(short, difference.square_ref()) / Float::with_val(short, &mean);
                // Each earlier step adds to b half the count of a product and one for the root. Here one each for the
                // sum, the difference, θe⁴, and the error of the correction.
                return Self::known(
                    mean - (correction >> 4u32),
                    given.and_then(|given| given.checked_add(2 * step + 3)),
                );
            }
            b *= &a;
            b.sqrt_mut();
            a = mean;
        }
        Self::unknown(Precision::new(bits))
    }

    /// The number to the power p/q. Except for second and fourth roots the result is unknown if p or q is above 1000.
    pub fn power(self, p: i32, q: u32) -> Self {
        match q {
            0 => Self::unknown(Precision::new(self.value.prec())),
            1 => self.integer_power(p),
            2 => self.integer_power(p).sqrt(),
            4 => self.integer_power(p).sqrt().sqrt(),
            _ if p > 0 => self.integer_power(-1).inverse_power(p.unsigned_abs(), q),
            _ => self.inverse_power(p.unsigned_abs(), q),
        }
    }

    fn integer_power(self, p: i32) -> Self {
        if p == 1 {
            return self;
        }
        let roundings = self.roundings.checked_mul(p.unsigned_abs().into()).and_then(one_more);
        Self::known(self.value.pow(p), roundings)
    }

    /// x^(−p/q) by an iteration of third order for y = x^(−1/q), and y^p with the last correction.
    ///
    /// For any y, with ρ = 1 − xy^q and s = p/q, the power is y^p (1 − ρ)^(−s), and 1 + sρ + s(1+s)ρ²/2 differs from
    /// the second factor by less than ((1+s)|ρ|)³ where that is below 1/4. So it suffices that the last ρ is small,
    /// which is checked.
    fn inverse_power(self, p: u32, q: u32) -> Self {
        const LARGEST: u32 = 1000;
        let precision = self.value.prec();
        let unknown = Self::unknown(Precision::new(precision));
        if !is_relative(&self.value) || p.max(q) > LARGEST {
            return unknown;
        }
        let residual = |y: &Float, bits| 1u32 - Float::with_val(bits, &short_power(y, q, bits) * &self.value);
        let mut y = first_inverse_root(&self.value, q);
        for bits in ladder(precision) {
            y = correction(&residual(&y, bits), 1, q, bits) * &y;
        }
        for _ in 0..2 {
            let rest = residual(&y, precision);
            let small = rest.get_exp().map_or(i64::MIN / 8, i64::from);
            if 3 * (small + magnification(p, q)) < -i64::from(precision).max(2) {
                // The error of ρ is at most 3u, from the power, its product with x, and the difference; u each for y^p,
                // the truncation, the shorter operands, and the last two operations.
                let magnified = self.roundings.checked_add(3).and_then(|count| count.checked_mul(p.into()));
                let value = correction(&rest, p, q, precision) * &short_power(&y, p, precision);
                return Self::known(value, magnified.and_then(|count| count.div_ceil(q.into()).checked_add(5)));
            }
            y = correction(&rest, 1, q, precision) * &y;
        }
        unknown
    }

    /// An interval that contains the number, rounded to a precision; the entire line if nothing is known.
    pub fn enclosure(&self, precision: Precision) -> Interval {
        let bits = self.value.prec();
        // For ku ≤ 1/2 both (1+u)^k − 1 and 1 − (1+u)^−k are at most 2ku.
        if !is_relative(&self.value) || u64::BITS - self.roundings.leading_zeros() >= bits.min(u64::BITS - 1) {
            return Interval::entire(precision);
        }
        let (radius, _) = Float::with_val_round(53, &self.value * (2 * self.roundings), Round::Up);
        let radius = radius >> bits;
        let (lower, _) = Float::with_val_round(precision.bits(), &self.value - &radius, Round::Down);
        let (upper, _) = Float::with_val_round(precision.bits(), &self.value + &radius, Round::Up);
        Interval::new(lower, upper)
    }
}

fn one_more(roundings: u64) -> Option<u64> {
    roundings.checked_add(1)
}

/// Whether a value is so far above the least exponent that its roundings are relative, even after a factor u².
fn is_relative(value: &Float) -> bool {
    value
        .get_exp()
        .is_some_and(|exponent| i64::from(exponent) > i64::from(exp_min()) + 2 * i64::from(value.prec()) + 64)
}

/// 1 + sρ + s(1+s)ρ²/2 with s = p/q, for |ρ| below 2^(−bits/3), without the square where it is negligible.
fn correction(rest: &Float, p: u32, q: u32, bits: u32) -> Float {
    let small = rest.get_exp().map_or(i64::MIN / 8, i64::from);
    let mut sum = Float::with_val(bits / 3 * 2 + 16, rest);
    // ρ²(1+s)² > 2^−bits, perhaps
    if 2 * (small + magnification(p, q)) > -i64::from(bits) {
        let square = Float::with_val(bits / 3 + 16, sum.square_ref());
        sum += square * (p + q) / (2 * q);
    }
    if p != 1 {
        sum *= p;
    }
    Float::with_val(bits, sum / q) + 1u32
}

/// An exponent e with 2^e ≥ 1 + p/q.
fn magnification(p: u32, q: u32) -> i64 {
    i64::from(u32::BITS - (p / q + 1).leading_zeros())
}

/// y^k with an error of at most half a unit of the given bits; results that fit the precision are exact.
fn short_power(y: &Float, k: u32, bits: u32) -> Float {
    // Fewer than 2k roundings.
    chain(y, k, bits + 2 + u32::BITS - k.leading_zeros())
}

fn chain(y: &Float, k: u32, bits: u32) -> Float {
    if k <= 1 {
        return if k == 1 { y.clone() } else { Float::with_val(bits, 1) };
    }
    let root = chain(y, k / 2, bits);
    let square = Float::with_val(bits.min(2 * root.prec()), root.square_ref());
    if k.is_multiple_of(2) { square } else { Float::with_val(bits.min(square.prec() + y.prec()), &square * y) }
}

/// Precisions of a third-order iteration that starts from about a hundred bits, without the last.
fn ladder(precision: u32) -> impl Iterator<Item = u32> {
    let third = |bits: u32| (bits > 300).then_some(bits / 3 + 12);
    let mut rungs: Vec<u32> = std::iter::successors(third(precision), |bits| third(*bits)).collect();
    rungs.reverse();
    rungs.into_iter()
}

/// x^(−1/q) to about a hundred bits: one step of the same iteration in two words, starting from a double.
fn first_inverse_root(x: &Float, q: u32) -> Float {
    let (_, exponent) = x.to_f64_exp();
    let q_signed = q as i32;
    // x = 2^(wq) times a number of moderate size.
    let (whole, near) = (exponent.div_euclid(q_signed), x.clone() >> (exponent - exponent.rem_euclid(q_signed)));
    let upper = near.to_f64();
    let lower = Float::with_val(53, near - upper).to_f64();
    let [near, first] = [upper, upper.powf(-1.0 / f64::from(q))].map(|value| Extended::<2>::from_f64((), value));
    let near = near + Extended::from_f64((), lower);
    let (one, q) = (Extended::<2>::from_int((), 1), i64::from(q));
    let rest = one - near * first.powi(q_signed.into());
    let root = first * (one + (rest + rest.square().times(q + 1).over(2 * q)).over(q));
    let [low, high] = *root.limbs();
    let significand = Float::with_val(128, u128::from(high) << 64 | u128::from(low));
    significand << (root.exponent() as i32 - 128 - whole)
}
