//! The laws of algebra that each arithmetic satisfies, and the weaker ones for intervals.

#![cfg(feature = "mp")]

use std::cmp::Ordering;

use mdr_core::number::{Dual, Interval, Precision, Real};
use num_traits::Inv;
use quickcheck::{Arbitrary, Gen, quickcheck};
use rug::Float;

/// A double of moderate size, often a small integer, so that cancellations and zeros are common.
#[derive(Clone, Copy, Debug)]
struct Number(f64);

impl Arbitrary for Number {
    fn arbitrary(g: &mut Gen) -> Self {
        let mantissa = f64::from(i32::arbitrary(g) >> (u32::arbitrary(g) % 32));
        let exponent = i32::from(i8::arbitrary(g)) / 4;
        Number(if bool::arbitrary(g) { mantissa } else { mantissa * 2_f64.powi(exponent) })
    }
}

/// An interval at 60 bits: a point, or between two numbers.
#[derive(Clone, Debug)]
struct Range(Interval);

impl Arbitrary for Range {
    fn arbitrary(g: &mut Gen) -> Self {
        let (Number(a), Number(b)) = (Number::arbitrary(g), Number::arbitrary(g));
        let (lo, hi) = if bool::arbitrary(g) { (a, a) } else { (a.min(b), a.max(b)) };
        Range(Interval::new(Float::with_val(60, lo), Float::with_val(60, hi)))
    }
}

/// An interval and a part of it.
#[derive(Clone, Debug)]
struct Nested {
    outer: Interval,
    inner: Interval,
}

impl Arbitrary for Nested {
    fn arbitrary(g: &mut Gen) -> Self {
        let (Range(inner), Range(other)) = (Range::arbitrary(g), Range::arbitrary(g));
        Nested { outer: inner.hull(&other), inner }
    }
}

fn same(a: &Interval, b: &Interval) -> bool {
    a.lower() == b.lower() && a.upper() == b.upper()
}

fn within(inner: &Interval, outer: &Interval) -> bool {
    outer.lower() <= inner.lower() && inner.upper() <= outer.upper()
}

fn int(value: i64) -> Interval {
    Interval::from_int(Precision::new(60), value)
}

quickcheck! {
    fn sums_and_products_commute(x: Range, y: Range) -> bool {
        let (Range(x), Range(y)) = (x, y);
        same(&(x.clone() + &y), &(y.clone() + &x)) && same(&(x.clone() * &y), &(y * &x))
    }

    fn neutral_elements(x: Range) -> bool {
        let Range(x) = x;
        same(&(x.clone() + int(0)), &x) && same(&(x.clone() * int(1)), &x) && same(&(x.clone() / int(1)), &x)
            && same(&-(-x.clone()), &x) && same(&x.clone().times(1).over(1), &x)
    }

    fn inverses_are_contained(x: Range) -> bool {
        let Range(x) = x;
        let quotient = x.clone() / &x;
        (x.clone() - &x).contains_zero() && quotient.contains(int(1).lower()) && (quotient.is_finite() != x.contains_zero())
    }

    /// Two enclosures of the same number overlap: associativity and distributivity up to width.
    fn ring_laws_overlap(x: Range, y: Range, z: Range) -> bool {
        let (Range(x), Range(y), Range(z)) = (x, y, z);
        (x.clone() + &y + &z).overlaps(&(x.clone() + (y.clone() + &z)))
            && (x.clone() * &y * &z).overlaps(&(x.clone() * (y.clone() * &z)))
            && (x.clone() * (y.clone() + &z)).overlaps(&(x.clone() * &y + x * &z))
    }

    /// x(y + z) ⊆ xy + xz, for exact sums and products.
    fn subdistributivity(x: (i16, i16), y: (i16, i16), z: (i16, i16)) -> bool {
        let exact = |(a, b): (i16, i16)| Interval::new(Float::with_val(60, a.min(b)), Float::with_val(60, a.max(b)));
        let (x, y, z) = (exact(x), exact(y), exact(z));
        within(&(x.clone() * (y.clone() + &z)), &(x.clone() * &y + x * &z))
    }

    fn inclusion_is_isotone(x: Nested, y: Nested) -> bool {
        let each = |f: fn(Interval, &Interval) -> Interval| {
            within(&f(x.inner.clone(), &y.inner), &f(x.outer.clone(), &y.outer))
        };
        each(|x, y| x + y) && each(|x, y| x - y) && each(|x, y| x * y) && each(|x, y| x / y) && each(|x, y| x.abs().pow(y))
    }

    fn functions_are_isotone(x: Nested, exponent: i8) -> bool {
        let each = |f: &dyn Fn(&Interval) -> Interval| within(&f(&x.inner), &f(&x.outer));
        each(&Real::abs) && each(&Real::square) && each(&Real::sqrt) && each(&Real::exp) && each(&Real::ln)
            && each(&|x| x.powi(exponent.into())) && each(&|x| x.clone().times(exponent.into()))
            && each(&|x| x.clone().over(exponent.into())) && each(&|x| x.clone().inv())
    }

    /// A square is tighter than a product.
    fn square_within_product(x: Range) -> bool {
        let Range(x) = x;
        within(&x.square(), &(x.clone() * &x)) && *x.square().lower() >= 0
    }

    fn integers_scale_as_intervals_do(x: Range, k: i64) -> bool {
        let Range(x) = x;
        let precise = Interval::from_int(Precision::new(64), k);
        same(&x.clone().times(k), &(x.clone() * &precise)) && same(&x.clone().over(k), &(x / &precise))
    }

    /// Certain comparisons agree with those of all pairs of ends.
    fn comparison_is_certain(x: Range, y: Range) -> bool {
        let (Range(x), Range(y)) = (x, y);
        let ends = |i: &Interval| [i.lower().clone(), i.upper().clone()];
        let less = ends(&x).iter().all(|a| ends(&y).iter().all(|b| a < b));
        let equal = ends(&x).iter().all(|a| ends(&y).iter().all(|b| a == b));
        let expected = match (less, equal) {
            (true, _) => Some(Ordering::Less),
            (_, true) => Some(Ordering::Equal),
            _ if x.overlaps(&y) => None,
            _ => Some(Ordering::Greater),
        };
        x.partial_cmp(&y) == expected && y.partial_cmp(&x) == expected.map(Ordering::reverse)
    }

    /// An interval contains what f64 computes from points, up to the rounding of f64: 2⁻⁵³ relative.
    fn contains_f64(x: Number, y: Number) -> bool {
        let (Number(a), Number(b)) = (x, y);
        let [x, y] = [a, b].map(|v| Interval::point(Float::with_val(60, v)));
        let near = |enclosure: Interval, value: f64| {
            let slack = Interval::point(Float::with_val(60, value.abs()) >> 53);
            enclosure.inflate(&slack).contains(&Float::with_val(60, value))
        };
        near(x.clone() + &y, a + b) && near(x.clone() - &y, a - b) && near(x.clone() * &y, a * b) && (b == 0.0 || near(x / &y, a / b))
    }
}

/// The laws of dual numbers hold exactly where f64 is exact: small integers.
fn dual(value: i8, slope: i8) -> Dual<f64> {
    Dual { value: value.into(), slope: slope.into() }
}

fn identical(a: &Dual<f64>, b: &Dual<f64>) -> bool {
    a.value == b.value && a.slope == b.slope
}

quickcheck! {
    fn dual_ring(a: (i8, i8), b: (i8, i8), c: (i8, i8)) -> bool {
        let [a, b, c] = [a, b, c].map(|(value, slope)| dual(value, slope));
        identical(&(a.clone() + &b), &(b.clone() + &a))
            && identical(&(a.clone() * &b), &(b.clone() * &a))
            && identical(&(a.clone() * &b * &c), &(a.clone() * (b.clone() * &c)))
            && identical(&(a.clone() * (b.clone() + &c)), &(a.clone() * &b + a.clone() * &c))
            && identical(&(a.clone() - &b), &(a.clone() + -b.clone()))
            && identical(&a.square(), &(a.clone() * &a))
    }

    fn product_rule(a: (i8, i8), b: (i8, i8)) -> bool {
        let product = dual(a.0, a.1) * dual(b.0, b.1);
        product.slope == f64::from(a.1) * f64::from(b.0) + f64::from(a.0) * f64::from(b.1)
    }

    /// (a/b)·b = a: exact for a divisor that is a power of two.
    fn quotient_rule(a: (i8, i8), power: u8, slope: i8) -> bool {
        let divisor = Dual { value: 2_f64.powi(i32::from(power % 8)), slope: slope.into() };
        let a = dual(a.0, a.1);
        identical(&(a.clone() / &divisor * &divisor), &a) && identical(&(a.clone() / &divisor), &(a * divisor.inv()))
    }

    fn integer_powers_are_products(a: (i8, i8), exponent: u8) -> bool {
        let (base, exponent) = (dual(a.0 / 16, a.1), exponent % 6);
        let product = (0..exponent).fold(dual(1, 0), |product, _| product * &base);
        identical(&base.powi(exponent.into()), &product)
    }

    /// Dual numbers over intervals contain those over exact doubles.
    fn dual_over_intervals(a: (i8, i8), b: (i8, i8)) -> bool {
        let enclose = |(value, slope): (i8, i8)| Dual { value: int(value.into()), slope: int(slope.into()) };
        let (x, y) = (dual(a.0, a.1) * dual(b.0, b.1), enclose(a) * enclose(b));
        y.value.approx() == x.value && y.slope.approx() == x.slope && y.value.is_point() && y.slope.is_point()
    }
}
