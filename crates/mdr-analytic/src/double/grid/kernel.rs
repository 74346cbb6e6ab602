//! The closed forms for a row of points without branches, so that the compiler vectorizes each loop.
//!
//! With λ = 1 (fixed grips) or 3 (dead load), B = πw/(2E*) and t = 2n − 1:
//!
//! 1. κ² = κ²(1/2) + t(π/4 − X(n)) as a pair of doubles; X ≤ 0.067 is a rational fit in doubles. It is multiplied by t,
//!    so its error enters ln a = ln(λ²B/(nCκ)²)/t undivided, however close n is to 1/2.
//! 2. λ²B = 2ᵉm(nCκ)² with ln m = 2 artanh(s), s a quotient of pairs.
//! 3. z = ln(a)/2 = (e(ln 2)/2 + artanh(s))/t.
//! 4. eᶻ = 2ᵏy, y a pair.
//! 5. a = 4ᵏy², d = ((λ−2n)/n)√B 2ᵏy and F = −2((2n+2−λ)/(n+1))E*√B 8ᵏy³, each rounded once from a pair.
//!
//! **Error budget**, relative, u = 2⁻⁵³; a relative error of u is at most one ulp. The fit of X and the roundings of
//! its evaluation contribute at most 0.36 u of κ² (printed by `scripts/grid_table.py`), those of t and tX another 0.10
//! u. In artanh the terms from s⁵ on are doubles: 0.0011 u of s, that is at most 0.0005 u/|t| in ln a, and at most
//! 0.0015 u |ln a|. The fit and the tail of the exponential contribute 0.03 u of y. All other steps are pairs, accurate
//! to 2⁻¹⁰⁰, except the last rounding of each result. X contributes most for n → 0 and 0.2 u near n = 1/2, where artanh
//! contributes most: together δ = 0.5 u in ln a as long as |ln a| ≤ 200.
//!
//! | | last rounding | ln a | exponential | at most |
//! |---|---|---|---|---|
//! | κ | u, and u/2 from rounding κ² | 0.23 u | | 1.8 ulp |
//! | a | u | δ | 0.06 u | 1.6 ulp |
//! | d | u | δ/2 | 0.03 u | 1.3 ulp |
//! | F | u | 3δ/2 | 0.09 u | 1.9 ulp |
//!
//! Points outside the ranges below are passed to extended precision; inside, no step leaves the range of a double.

use std::f64::consts::{FRAC_1_PI, LOG2_E};
use std::ops::RangeInclusive;

use super::table::{ARTANH, EXPONENTIAL, HALF_LN_2, HALF_PI, LN_2, OFFSET, REST_LOWER, REST_UPPER, THIRD};
use crate::double::exponential::{FROM_INTEGER, TO_INTEGER};
use crate::double::pair::{Arithmetic, Pair};

/// Points in a row: the data of five loops fit into the first-level cache.
pub(super) const LEN: usize = 64;
pub(super) type Row = [f64; LEN];

const fn power(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

/// 2⁻³⁰ to 2⁹: 2n − 1 and the sum of κ² are exact pairs.
const EXPONENT: RangeInclusive<f64> = power(-30)..=power(9);
/// κ²(1/2) is known to 2⁻⁹⁷: 2⁻⁶¹ of ln a.
const EXCESS: RangeInclusive<f64> = power(-36)..=power(10);
/// 2^±390: (nCκ)² and its quotient by λ²B stay within 2^±1005.
const COEFFICIENT: RangeInclusive<f64> = power(-390)..=power(390);
/// 2^±80, of E* and w.
const MATERIAL: RangeInclusive<f64> = power(-80)..=power(80);
/// |ln a| ≤ 200.
const HALF_LN_RADIUS: f64 = 100.0;

#[inline(always)]
fn within(range: &RangeInclusive<f64>, x: f64) -> bool {
    (x >= *range.start()) & (x <= *range.end())
}

/// The edge quantities of one pair of bodies. B is NaN if E* or w is out of [`MATERIAL`]: then ln a is NaN and the
/// point is hard.
#[derive(Clone, Copy)]
pub(super) struct Edge {
    /// B = πw/(2E*).
    length: Pair,
    /// √B.
    root: Pair,
    modulus: f64,
}

impl Edge {
    #[inline(always)]
    pub(super) fn new<A: Arithmetic>(arithmetic: A, modulus: f64, work: f64) -> Self {
        let both = 1.0 / (modulus * work);
        let (per_modulus, per_work) = (work * both, modulus * both);
        let length = HALF_PI.scaled(arithmetic, work).over(arithmetic, Pair { hi: modulus, lo: 0.0 }, per_modulus);
        let hi = length.hi.sqrt();
        let residual = A::residual(length.hi, hi, hi) + length.lo;
        // 1/(2√B) = √B E*/(πw).
        let root = Pair { hi, lo: residual * (hi * per_work * (modulus * FRAC_1_PI)) };
        let ordinary = within(&MATERIAL, modulus) & within(&MATERIAL, work);
        Edge { length: Pair { hi: if ordinary { length.hi } else { f64::NAN }, lo: length.lo }, root, modulus }
    }
}

/// One pair of bodies for a whole row, or one for each point.
pub(super) trait Edges: Copy {
    fn at(self, i: usize) -> Edge;
}

impl Edges for Edge {
    #[inline(always)]
    fn at(self, _: usize) -> Edge {
        self
    }
}

/// B and √B of a row of materials.
#[derive(Clone, Copy)]
pub(super) struct EdgeRows<'a> {
    pub(super) length: &'a Pairs,
    pub(super) root: &'a Pairs,
    pub(super) modulus: &'a Row,
}

impl Edges for EdgeRows<'_> {
    #[inline(always)]
    fn at(self, i: usize) -> Edge {
        Edge { length: self.length.at(i), root: self.root.at(i), modulus: self.modulus[i] }
    }
}

/// A row of pairs.
pub(super) struct Pairs {
    hi: Row,
    lo: Row,
}

impl Pairs {
    pub(super) const fn new() -> Self {
        Pairs { hi: [1.0; LEN], lo: [0.0; LEN] }
    }

    #[inline(always)]
    fn at(&self, i: usize) -> Pair {
        Pair { hi: self.hi[i], lo: self.lo[i] }
    }

    #[inline(always)]
    fn set(&mut self, i: usize, pair: Pair) {
        self.hi[i] = pair.hi;
        self.lo[i] = pair.lo;
    }
}

#[inline(always)]
pub(super) fn edges<A: Arithmetic>(arithmetic: A, modulus: &Row, work: &Row, length: &mut Pairs, root: &mut Pairs) {
    for i in 0..LEN {
        let edge = Edge::new(arithmetic, modulus[i], work[i]);
        length.set(i, edge.length);
        root.set(i, edge.root);
    }
}

/// The slices for a row of results.
pub(super) struct Results<'a> {
    pub(super) kappa: &'a mut Row,
    pub(super) radius: &'a mut Row,
    pub(super) indentation: &'a mut Row,
    pub(super) force: &'a mut Row,
}

/// The steps and their intermediate results.
pub(super) struct Kernel<A> {
    arithmetic: A,
    critical_ratio: f64,
    kappa_squared: Pairs,
    tanh: Pairs,
    binary_exponent: Row,
    half_ln_radius: Pairs,
    mantissa: Pairs,
    scale: Row,
    /// 1 if extended precision is needed, else 0.
    pub(super) hard: Row,
}

impl<A: Arithmetic> Kernel<A> {
    /// For λ = `tension`.
    #[inline(always)]
    pub(super) fn new(arithmetic: A, critical_ratio: f64) -> Self {
        Kernel {
            arithmetic,
            critical_ratio,
            kappa_squared: Pairs::new(),
            tanh: Pairs::new(),
            binary_exponent: [0.0; LEN],
            half_ln_radius: Pairs::new(),
            mantissa: Pairs::new(),
            scale: [1.0; LEN],
            hard: [0.0; LEN],
        }
    }

    /// All results of a row, and whether it contains a hard point, whose results are meaningless.
    #[inline(always)]
    pub(super) fn run(&mut self, n: &Row, c: &Row, edges: impl Edges, results: &mut Results<'_>) -> bool {
        self.kappa_squared(n);
        self.tanh(n, c, edges);
        self.half_ln_radius(n);
        self.exponential(results);
        self.results(n, c, edges, results);
        self.hard.iter().fold(0, |any, hard| any | hard.to_bits()) != 0
    }

    /// κ² = (κ²(1/2) − π/4) + nπ/2 − tX.
    #[inline(always)]
    fn kappa_squared(&mut self, n: &Row) {
        for (i, &n) in n.iter().enumerate() {
            let rest = polynomial::<A, 8>(&REST_UPPER, n) / polynomial::<A, 9>(&REST_LOWER, n);
            let linear = A::product(n, HALF_PI.hi);
            let sum = Pair::quick_sum(OFFSET.hi, linear.hi);
            let all = Pair::quick_sum(sum.hi, (1.0 - (n + n)) * rest);
            let lo = (sum.lo + all.lo) + (linear.lo + A::multiply_add(n, HALF_PI.lo, OFFSET.lo));
            self.kappa_squared.set(i, Pair::quick_sum(all.hi, lo));
        }
    }

    /// s = (m − 1)/(m + 1), and e.
    #[inline(always)]
    fn tanh(&mut self, n: &Row, c: &Row, edges: impl Edges) {
        for i in 0..LEN {
            let slope = A::product(n[i], c[i]).square(self.arithmetic).times(self.arithmetic, self.kappa_squared.at(i));
            let edge = edges.at(i).length.scaled(self.arithmetic, self.critical_ratio * self.critical_ratio);
            // The bits of a double are a piecewise linear logarithm: e is rounded from their difference, |log₂ m| <
            // 0.59.
            let difference = edge.hi.to_bits().wrapping_sub(slope.hi.to_bits());
            let biased = difference.wrapping_add((1024 << 52) + (1 << 51)) >> 52;
            self.binary_exponent[i] = f64::from_bits(biased | FROM_INTEGER.to_bits()) - (FROM_INTEGER + 1024.0);
            let down = f64::from_bits(2047_u64.wrapping_sub(biased) << 52);
            let edge = Pair { hi: edge.hi * down, lo: edge.lo * down };
            // Exact, because the ratio is between 1/2 and 2.
            let difference = Pair { hi: edge.hi - slope.hi, lo: edge.lo - slope.lo };
            let sum = Pair::quick_sum(slope.hi + slope.hi, difference.hi);
            let sum = Pair { hi: sum.hi, lo: sum.lo + (edge.lo + slope.lo) };
            self.tanh.set(i, difference.over(self.arithmetic, sum, 1.0 / sum.hi));
        }
    }

    /// z = (e(ln 2)/2 + artanh(s))/t.
    #[inline(always)]
    fn half_ln_radius(&mut self, n: &Row) {
        for (i, &n) in n.iter().enumerate() {
            let (s, e) = (self.tanh.at(i), self.binary_exponent[i]);
            let w = s.square(self.arithmetic);
            let tail = w.hi * A::multiply_add(w.hi, polynomial::<A, 8>(&ARTANH, w.hi), 0.2);
            let factor = Pair::quick_sum(THIRD.hi, tail);
            let factor = Pair { hi: factor.hi, lo: factor.lo + THIRD.lo };
            let cubic = s.times(self.arithmetic, w.times(self.arithmetic, factor));
            // e(ln 2)/2 is 0 or larger than artanh(s), and the sum larger than its cubic part.
            let sum = Pair::quick_sum(e * HALF_LN_2.hi, s.hi);
            let all = Pair::quick_sum(sum.hi, cubic.hi);
            let lo = A::multiply_add(e, HALF_LN_2.lo, (sum.lo + all.lo) + (s.lo + cubic.lo));
            let excess = Pair::quick_sum(-1.0, n + n);
            self.half_ln_radius.set(i, Pair { hi: all.hi, lo }.over(self.arithmetic, excess, 1.0 / excess.hi));
        }
    }

    /// eᶻ = 2ᵏy; and the root of κ², here because the division unit is idle.
    #[inline(always)]
    fn exponential(&mut self, results: &mut Results<'_>) {
        for i in 0..LEN {
            let z = self.half_ln_radius.at(i);
            let k = A::multiply_add(z.hi, LOG2_E, TO_INTEGER) - TO_INTEGER;
            let r = Pair::quick_sum(A::multiply_add(-k, LN_2.hi, z.hi), A::multiply_add(-k, LN_2.lo, z.lo));
            let square = A::product(r.hi, r.hi);
            let cubic = square.hi * (r.hi * polynomial::<A, 10>(&EXPONENTIAL, r.hi));
            let linear = Pair::quick_sum(1.0, r.hi);
            let quadratic = Pair::quick_sum(linear.hi, 0.5 * square.hi);
            // The products are at most 0.12 u and 0.04 u of y: too small for a test, but F, of y³, needs them for its 2
            // ulp.
            let r_lo = A::multiply_add(r.lo, r.hi, A::multiply_add(0.5, square.lo, r.lo));
            let tail = cubic + ((linear.lo + quadratic.lo) + r_lo);
            self.mantissa.set(i, Pair::quick_sum(quadratic.hi, tail));
            self.scale[i] = f64::from_bits((k + (TO_INTEGER + 1023.0)).to_bits() << 52);
            results.kappa[i] = self.kappa_squared.hi[i].sqrt();
        }
    }

    /// a, d and F; and which points are outside the ranges of the error budget. NaN is outside.
    #[inline(always)]
    fn results(&mut self, n: &Row, c: &Row, edges: impl Edges, results: &mut Results<'_>) {
        let arithmetic = self.arithmetic;
        for (i, &n) in n.iter().enumerate() {
            let (edge, y, scale) = (edges.at(i), self.mantissa.at(i), self.scale[i]);
            let y_squared = y.square(arithmetic);
            let root = y.times(arithmetic, edge.root);
            let next = Pair::quick_sum(1.0, n);
            let reciprocal = 1.0 / (n * next.hi);

            let factor = Pair::quick_sum(self.critical_ratio, -(n + n));
            let product = root.times(arithmetic, factor);
            let d = product.over(arithmetic, Pair { hi: n, lo: 0.0 }, next.hi * reciprocal);

            let factor = Pair::quick_sum(2.0 - self.critical_ratio, n + n);
            let product = y_squared.times(arithmetic, root).scaled(arithmetic, -2.0 * edge.modulus);
            let f = product.times(arithmetic, factor).over(arithmetic, next, n * reciprocal);

            let scale_squared = scale * scale;
            results.radius[i] = y_squared.rounded() * scale_squared;
            results.indentation[i] = d.rounded() * scale;
            results.force[i] = f.rounded() * (scale_squared * scale);

            let ordinary = within(&EXPONENT, n)
                & within(&EXCESS, (n + n - 1.0).abs())
                & within(&COEFFICIENT, c[i])
                & (self.half_ln_radius.hi[i].abs() <= HALF_LN_RADIUS);
            self.hard[i] = if ordinary { 0.0 } else { 1.0 };
        }
    }
}

/// Σ cⱼxʲ, with even and odd powers separate: half the latency of Horner's scheme.
#[inline(always)]
fn polynomial<A: Arithmetic, const N: usize>(c: &[f64; N], x: f64) -> f64 {
    let square = x * x;
    let (odd, even) = if N.is_multiple_of(2) { (N - 1, N - 2) } else { (N - 2, N - 1) };
    A::multiply_add(every_second::<A, N>(c, odd, square), x, every_second::<A, N>(c, even, square))
}

/// The terms of c below and at the highest of one parity, as a polynomial in x².
#[inline(always)]
fn every_second<A: Arithmetic, const N: usize>(c: &[f64; N], highest: usize, square: f64) -> f64 {
    let mut sum = c[highest];
    for j in (highest % 2..highest).step_by(2).rev() {
        sum = A::multiply_add(sum, square, c[j]);
    }
    sum
}
