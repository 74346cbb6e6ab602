//! Positive numbers with a count of their rounding errors.

use rug::float::{Constant, Round};
use rug::ops::Pow;
use rug::{Float, Rational};

use super::{Interval, Precision};

/// A positive number x that is known as a `rug::Float` y of p bits and a count k: (1+u)^−k ≤ x/y ≤ (1+u)^k with u = 2⁻ᵖ.
///
/// Products, quotients, powers and roots are all there is, and they keep relative errors in hand: the counts add up, and
/// one more is that of the rounding. An enclosure of a monomial so costs half of what two directed ends do, and a large
/// integer power times the error, as it must.
///
/// Beyond the range of the exponents a value is 0 or ∞, and its [enclosure](Self::enclosure) the entire line.
///
/// ```
/// use mdr_core::number::{Counted, Precision};
/// // (π/3)^(−5/2)
/// let precision = Precision::new(100);
/// let number = Counted::pi(precision).scaled(&(1, 3).into()).power(-5, 2);
/// let enclosure = number.enclosure(precision);
/// assert!(enclosure.contains(&Counted::pi(Precision::new(200)).scaled(&(1, 3).into()).power(-5, 2).value()));
/// assert!(enclosure.accuracy_bits() > 94);
/// ```
#[derive(Clone, Debug)]
pub struct Counted {
    value: Float,
    roundings: u64,
}

impl Counted {
    /// A positive value of which so many roundings are known.
    pub fn new(value: Float, roundings: u64) -> Self {
        Counted { value, roundings }
    }

    /// π.
    pub fn pi(precision: Precision) -> Self {
        Counted { value: Float::with_val(precision.bits(), Constant::Pi), roundings: 1 }
    }

    /// The value that is held.
    pub fn value(&self) -> &Float {
        &self.value
    }

    /// The number of roundings.
    pub fn roundings(&self) -> u64 {
        self.roundings
    }

    /// The number times a positive rational.
    pub fn scaled(mut self, factor: &Rational) -> Self {
        if *factor.numer() != 1 {
            self.value *= factor.numer();
            self.roundings += 1;
        }
        if *factor.denom() != 1 {
            self.value /= factor.denom();
            self.roundings += 1;
        }
        self
    }

    /// The product.
    pub fn times(mut self, other: &Self) -> Self {
        self.value *= &other.value;
        self.roundings = self.roundings.saturating_add(other.roundings).saturating_add(1);
        self
    }

    /// The quotient.
    pub fn over(mut self, other: &Self) -> Self {
        self.value /= &other.value;
        self.roundings = self.roundings.saturating_add(other.roundings).saturating_add(1);
        self
    }

    /// The square root.
    pub fn sqrt(mut self) -> Self {
        self.value.sqrt_mut();
        self.roundings = self.roundings.div_ceil(2) + 1;
        self
    }

    /// The sum.
    pub fn plus(mut self, other: &Self) -> Self {
        self.value += &other.value;
        self.roundings = self.roundings.max(other.roundings).saturating_add(1);
        self
    }

    /// The arithmetic-geometric mean.
    ///
    /// It is homogeneous and grows with both numbers, so a relative error of theirs becomes no larger in it. With
    /// m = (a+b)/2 and e = (a−b)/(a+b) it is m π/2K(e) = m (1 − e²/4 − θe⁴), 0 ≤ θ < 1/4 for |e| ≤ 1/2: as soon as e⁴ < u this
    /// takes the place of the last two steps.
    pub fn agm(self, other: &Self) -> Self {
        // Squared in each step, the ratio of any two floats is soon below 2, and then the difference squared.
        const STEPS: u32 = 128;
        let bits = self.value.prec();
        let Counted { value: mut a, mut roundings } = self;
        let mut b = Float::with_val(bits, &other.value);
        roundings = roundings.max(other.roundings.saturating_add(1));
        for _ in 0..STEPS {
            if !a.is_normal() || !b.is_normal() {
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
                // One for the sum, one for the difference, one for θe⁴ and what the correction is wrong by.
                return Counted { value: mean - (correction >> 4u32), roundings: roundings.saturating_add(3) };
            }
            b *= &a;
            b.sqrt_mut();
            a = mean;
            // b: half the count of a product, and one for the root.
            roundings = roundings.saturating_add(2);
        }
        Counted { value: a, roundings: u64::MAX }
    }

    /// The number to the power p/q.
    pub fn power(self, p: i32, q: u32) -> Self {
        match q {
            0 => Counted { value: Float::with_val(self.value.prec(), 0), roundings: u64::MAX },
            1 => self.integer_power(p),
            2 => self.integer_power(p).sqrt(),
            4 => self.integer_power(p).sqrt().sqrt(),
            _ => self.integer_power(-p).inverse_root(q),
        }
    }

    fn integer_power(mut self, p: i32) -> Self {
        if p != 1 {
            self.value = self.value.pow(p);
            self.roundings = self.roundings.saturating_mul(p.unsigned_abs().into()).saturating_add(1);
        }
        self
    }

    /// x^(−1/q) by an iteration of third order from a double.
    ///
    /// Whatever y is, with ρ = 1 − xy^q the root is y (1 − ρ)^(−1/q), and 1 + ρ/q + (1+q)ρ²/2q² differs from the power by at
    /// most |ρ|³ for |ρ| ≤ 1/2. So nothing is asked of the iteration but that its last ρ is small, and that is seen.
    fn inverse_root(self, q: u32) -> Self {
        let precision = self.value.prec();
        let unknown = Counted { value: self.value.clone(), roundings: u64::MAX };
        if !self.value.is_normal() {
            return unknown;
        }
        let mut y = first_inverse_root(&self.value, q);
        for bits in ladder(precision) {
            let rest = 1u32 - Float::with_val(bits, (&y).pow(q)) * &self.value;
            // |ρ| < 2^small
            let small = rest.get_exp().map_or(i64::MIN / 4, i64::from);
            let linear = Float::with_val(bits / 3 * 2 + 16, &rest);
            let square = Float::with_val(bits / 3 + 16, linear.square_ref()) * (q + 1) / (2 * q);
            let correction = Float::with_val(bits, (linear + square) / q) + 1u32;
            y = correction * &y;
            if bits == precision && 3 * small < -i64::from(precision) {
                // ρ is wrong by up to 3u, for the power, its product with x, and the difference; u each for the third order,
                // the shorter operands, and the last two operations.
                let roundings = self.roundings.div_ceil(q.into()).saturating_add(8);
                return Counted { value: y, roundings };
            }
        }
        unknown
    }

    /// An interval that contains the number, rounded to a precision; the entire line where nothing is known.
    pub fn enclosure(&self, precision: Precision) -> Interval {
        let bits = self.value.prec();
        // For ku ≤ 1/2 both (1+u)^k − 1 and 1 − (1+u)^−k are at most 2ku.
        if !self.value.is_normal() || u64::BITS - self.roundings.leading_zeros() >= bits.min(u64::BITS - 1) {
            return Interval::entire(precision);
        }
        let (radius, _) = Float::with_val_round(53, &self.value * (2 * self.roundings), Round::Up);
        let radius = radius >> bits;
        let (lower, _) = Float::with_val_round(precision.bits(), &self.value - &radius, Round::Down);
        let (upper, _) = Float::with_val_round(precision.bits(), &self.value + &radius, Round::Up);
        Interval::new(lower, upper)
    }
}

/// Precisions for an iteration of third order that starts from a double; the last twice, should once not be enough.
fn ladder(precision: u32) -> impl Iterator<Item = u32> {
    let mut rungs = vec![precision, precision];
    let mut bits = precision;
    while bits > 120 {
        bits = bits / 3 + 12;
        rungs.push(bits);
    }
    rungs.into_iter().rev()
}

/// x^(−1/q) to the accuracy of a double, for 0 < q < 1000.
fn first_inverse_root(x: &Float, q: u32) -> Float {
    let (significand, exponent) = x.to_f64_exp();
    let q_signed = q.min(1000) as i32;
    let root = (significand * f64::from(exponent.rem_euclid(q_signed)).exp2()).powf(-1.0 / f64::from(q));
    Float::with_val(53, root) >> exponent.div_euclid(q_signed)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_and_roots_are_enclosed_and_tight() {
        for bits in [2, 10, 53, 54, 100, 121, 192, 700, 4000] {
            for x in [(1, 3), (2, 1), (123_456_789, 1), (1, 1_000_000_007)].map(Rational::from) {
                for (p, q) in
                    [(1, 3), (-1, 3), (2, 5), (-5, 7), (5, 2), (3, 4), (-7, 1), (100, 87), (11, 499), (-499, 500)]
                {
                    let power = |bits| Counted::new(Float::with_val(bits, &x), 1).power(p, q);
                    let found = power(bits + 24).enclosure(Precision::new(bits));
                    // MPFR's power at more than twice the precision.
                    let wide = Float::with_val(2 * bits + 100, &x);
                    let exact = wide.clone().pow(Float::with_val(wide.prec(), Rational::from((p, q))));
                    assert!(found.contains(&exact), "{x}^({p}/{q}), {bits} bits: {found} {exact}");
                    assert!(found.accuracy_bits() >= i64::from(bits) - 2, "{x}^({p}/{q}), {bits} bits: {found}");
                }
            }
        }
    }

    #[test]
    fn means_are_enclosed_and_tight() {
        for bits in (2..300).step_by(7).chain([700, 4000]) {
            for (x, y) in [(1, 2), (1, 1), (3, 1), (1_000_000_007, 1_000_000_009), (1, i64::MAX), (355, 113)] {
                for shift in [0, 7, -100_000_000] {
                    let number = |value, bits| Float::with_val(bits, value);
                    let [a, b] = [x, y].map(|value| Counted::new(number(value, bits + 24), 1));
                    let b = Counted::new(b.value << shift, 1);
                    let found = a.agm(&b).enclosure(Precision::new(bits));
                    // MPFR's mean at more than twice the precision.
                    let exact = number(x, 2 * bits + 100).agm(&(number(y, 2 * bits + 100) << shift));
                    assert!(found.contains(&exact), "agm({x}, {y}·2^{shift}), {bits} bits: {found} {exact}");
                    assert!(found.accuracy_bits() >= i64::from(bits) - 2, "agm({x}, {y}·2^{shift}): {found}");
                }
            }
        }
    }

    #[test]
    fn the_count_is_in_the_enclosure() {
        let precision = Precision::new(100);
        let number = |roundings| Counted::new(Float::with_val(100, 3), roundings);
        let width = |roundings| number(roundings).enclosure(precision).radius() >> 1_u32;
        // (1+u)^1000 − 1 is more than 999 u.
        assert!(width(1000) * 2u32 > Float::with_val(100, 3 * 999) >> 100);
        assert!(number(u64::MAX).enclosure(precision).is_entire());
        assert!(!number(1 << 61).enclosure(Precision::new(10)).is_entire());
        assert!(Counted::new(Float::with_val(20, 3), 1 << 20).enclosure(precision).is_entire());
        assert!(number(1).times(&number(2)).over(&number(3)).roundings() == 8);
    }

    #[test]
    fn beyond_the_exponents_nothing_is_known() {
        let huge = Counted::new(Float::with_val(60, 1) << (i32::MAX / 2), 0);
        let tiny = Counted::new(Float::with_val(60, 1) >> (i32::MAX / 2), 0);
        assert!(tiny.clone().plus(&tiny).agm(&tiny).enclosure(Precision::new(50)).is_entire());
        assert!(huge.clone().agm(&Counted::new(Float::with_val(60, 0), 0)).enclosure(Precision::new(50)).is_entire());
        assert!(huge.clone().power(100, 1).enclosure(Precision::new(50)).is_entire());
        assert!(huge.power(-100, 3).enclosure(Precision::new(50)).is_entire());
    }
}
