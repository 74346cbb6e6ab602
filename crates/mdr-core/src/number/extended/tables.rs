//! Constants, and the tables that the compiler computes from them: in Q128, whose errors are far below half a unit of a table.

/// π, truncated.
pub(super) const PI: ([u64; 4], i64) =
    ([0x020bbea63b139b22, 0x29024e088a67cc74, 0xc4c6628b80dc1cd1, 0xc90fdaa22168c234], 2);

/// ln 2, truncated.
pub(super) const LN_2: ([u64; 4], i64) =
    ([0x8a0d175b8baafa2b, 0x40f343267298b62d, 0xc9e3b39803f2f6af, 0xb17217f7d1cf79ab], 0);

/// ln 2 in Q128.
const LN_2_Q128: u128 = ((LN_2.0[3] as u128) << 64) + LN_2.0[2] as u128;

/// log2(e) in Q127.
const LOG2_E_Q127: u128 = 0xb8aa3b295c17f0bbbe87fed0691d3e88;

/// The product of two numbers below one, truncated.
const fn product(a: u128, b: u128) -> u128 {
    let [a_high, b_high] = [a >> 64, b >> 64];
    let [a_low, b_low] = [a as u64 as u128, b as u64 as u128];
    let [one, other] = [a_high * b_low, a_low * b_high];
    let middle = ((a_low * b_low) >> 64) + one as u64 as u128 + other as u64 as u128;
    a_high * b_high + (one >> 64) + (other >> 64) + (middle >> 64)
}

/// The nearest integer to value·2^−bits.
const fn rounded(value: u128, bits: u32) -> u64 {
    ((value >> bits) + ((value >> (bits - 1)) & 1)) as u64
}

/// The values of a function at 0, 1, 2, … as a constant.
macro_rules! table {
    ($($(#[$doc:meta])* $name:ident: [$type:ty; $len:literal] = |$i:ident| $value:expr;)*) => {$(
        $(#[$doc])*
        pub(super) static $name: [$type; $len] = {
            let mut values = [0; $len];
            let mut $i = 0;
            while $i < $len {
                values[$i] = $value;
                $i += 1;
            }
            values
        };
    )*};
}

table! {
    /// 2^(i/256) in Q63.
    EXP2: [u64; 256] = |i| (1 << 63) + rounded(power_less_one(i as u128 * (LN_2_Q128 >> 8)), 65);

    /// ln2^(k+1)/(k+1)! · 2^-8k in Q64: Horner's rule of (2^r − 1)/r multiplies by 2^8 r, r < 2^-8. The first omitted term is
    /// below 2^-72 of the whole.
    EXP2_TAYLOR: [u64; 7] = |k| rounded(power_term(LN_2_Q128, k as u128 + 1), 64 + 8 * k as u32);

    /// 1/m in Q10 at the middle of [(128 + i)/256, (129 + i)/256]: within the interval it differs from 1/m by less than 0.00437.
    RECIPROCAL: [u16; 128] = |i| ((1 << 20) / (257 + 2 * i as u32) + 1) as u16 / 2;

    /// log2 of that reciprocal in Q64.
    LOG2_RECIPROCAL: [u64; 128] = |i| rounded(product(logarithm(RECIPROCAL[i] as u128, 1 << 10), LOG2_E_Q127), 63);

    /// (−1)^k log2(e)/(k+1) · 2^-6k in Q62.
    LOG2_SERIES: [i64; 9] =
        |k| (1 - 2 * (k as i64 % 2)) * rounded(LOG2_E_Q127 / (k as u128 + 1), 65 + 6 * k as u32) as i64;
}

/// 1/k!, k = 2 …, in Q256, truncated.
pub(super) static INVERSE_FACTORIAL: [[u64; 4]; 23] = {
    let mut values = [[0; 4]; 23];
    let mut quotient = [0, 0, 0, 1 << 63];
    let mut k = 0;
    while k < 23 {
        values[k] = quotient;
        let (mut remainder, mut limb) = (0, 4);
        while limb > 0 {
            limb -= 1;
            let dividend = (remainder << 64) + quotient[limb] as u128;
            (quotient[limb], remainder) = ((dividend / (k as u128 + 3)) as u64, dividend % (k as u128 + 3));
        }
        k += 1;
    }
    values
};

/// x^k/k!.
const fn power_term(x: u128, k: u128) -> u128 {
    if k == 1 { x } else { product(power_term(x, k - 1), x) / k }
}

/// e^x − 1 for 0 ≤ x < ln 2, by its series.
const fn power_less_one(x: u128) -> u128 {
    let (mut sum, mut term, mut k) = (0, x, 1);
    while term > 0 {
        sum += term;
        k += 1;
        term = product(term, x) / k;
    }
    sum
}

/// ln(p/q) = 2 artanh((p − q)/(p + q)) for q ≤ p < 2q < 2⁶⁴, by its series.
const fn logarithm(p: u128, q: u128) -> u128 {
    let (high, rest) = (((p - q) << 64) / (p + q), ((p - q) << 64) % (p + q));
    let z = (high << 64) + (rest << 64) / (p + q);
    let (mut sum, mut term, mut k) = (0, z, 1);
    while term > 0 {
        sum += term / k;
        term = product(term, product(z, z));
        k += 2;
    }
    2 * sum
}
