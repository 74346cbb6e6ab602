//! Enclosures of a few bits contain a truth of 400 bits. At 2 to 24 bits each operation errs by nearly as much as it says, and no
//! guard bit hides an enclosure that is too narrow.

#![cfg(feature = "mp")]

use mdr_core::number::{Gamma, Interval, Precision, Real, RoundingCount, Special};
use proptest::prelude::*;
use rug::Float;
use rug::ops::Pow;

use crate::number_support::{float, interval_of, samples, signed};

/// Bits of the truth.
const TRUTH: u32 = 400;

/// A few bits.
const FEW: std::ops::RangeInclusive<u32> = 2..=24;

/// A function over intervals, and over floats of 400 bits.
type Function = (&'static str, fn(&Interval) -> Interval, fn(Float) -> Float);

const ANYWHERE: [Function; 16] = [
    ("|x|", Real::abs, Float::abs),
    ("x²", Real::square, Float::square),
    ("x³", |x| x.powi(3), |x| x.pow(3)),
    ("x⁴", |x| x.powi(4), |x| x.pow(4)),
    ("7x", |x| x.clone().times(7), |x| x * 7),
    ("−7x", |x| x.clone().times(-7), |x| x * -7),
    ("x/7", |x| x.clone().over(7), |x| x / 7),
    ("−x/7", |x| x.clone().over(-7), |x| x / -7),
    ("eˣ", Real::exp, Float::exp),
    ("eˣ − 1", Real::exp_m1, Float::exp_m1),
    ("sin x", Special::sin, Float::sin),
    ("cos x", Special::cos, Float::cos),
    ("arctan x", Special::atan, Float::atan),
    ("sinh x", Special::sinh, Float::sinh),
    ("cosh x", Special::cosh, Float::cosh),
    ("tanh x", Special::tanh, Float::tanh),
];

const POSITIVE: [Function; 10] = [
    ("√x", Real::sqrt, Float::sqrt),
    ("ln x", Real::ln, Float::ln),
    ("ln(1 + x)", Real::ln_1p, Float::ln_1p),
    ("log₁₀ x", Special::log10, Float::log10),
    ("1/x", |x| num_traits::Inv::inv(x.clone()), Float::recip),
    ("x⁻²", |x| x.powi(-2), |x| x.pow(-2)),
    ("x⁻³", |x| x.powi(-3), |x| x.pow(-3)),
    ("Γ(x)", Gamma::gamma, Float::gamma),
    ("ln Γ(x)", Gamma::ln_gamma, Float::ln_gamma),
    ("ψ(x)", Gamma::digamma, Float::digamma),
];

const WITHIN_ONE: [Function; 4] = [
    ("arcsin x", Special::asin, Float::asin),
    ("arccos x", Special::acos, Float::acos),
    ("artanh x", Special::atanh, Float::atanh),
    ("ln(1 + x)", Real::ln_1p, Float::ln_1p),
];

/// All functions at one interval.
fn contained(functions: &[Function], x: &Interval) -> Result<(), TestCaseError> {
    for (name, function, exact) in functions {
        let image = function(x);
        for at in samples(x, TRUTH) {
            let truth = exact(at.clone());
            prop_assert!(image.contains(&truth), "{name} of {x:?} is {image:?} without {truth}, at {at}");
        }
    }
    Ok(())
}

fn few<S: Strategy<Value = Interval> + 'static>(kind: fn(u32) -> S) -> impl Strategy<Value = Interval> {
    FEW.prop_flat_map(kind)
}

proptest! {
    #[test]
    fn functions_of_any_number(x in few(|bits| interval_of(signed(bits, -20..=5).boxed()))) {
        contained(&ANYWHERE, &x)?;
    }

    #[test]
    fn functions_of_positive_numbers(x in few(|bits| interval_of(float(bits, -12..=6).boxed()))) {
        contained(&POSITIVE, &x)?;
    }

    #[test]
    fn functions_within_one(x in few(|bits| interval_of(signed(bits, -12..=-1).boxed()))) {
        // Steps of two or three bits may lead beyond the domain.
        prop_assume!(*x.lower() > -1 && *x.upper() < 1);
        contained(&WITHIN_ONE, &x)?;
    }

    #[test]
    fn operations(x in few(|bits| interval_of(signed(bits, -20..=20).boxed())), y in few(|bits| interval_of(signed(bits, -20..=20).boxed()))) {
        let y = y.rounded(x.ctx());
        let pairs = samples(&x, TRUTH).into_iter().flat_map(|left| samples(&y, TRUTH).into_iter().map(move |right| (left.clone(), right)));
        let [sum, difference, product, quotient] = [x.clone() + &y, x.clone() - &y, x.clone() * &y, x.clone() / &y];
        for (left, right) in pairs {
            // Exact in 400 bits, but for the quotient.
            prop_assert!(sum.contains(&Float::with_val(TRUTH, &left + &right)), "{left} + {right}: {sum:?}");
            prop_assert!(difference.contains(&Float::with_val(TRUTH, &left - &right)), "{left} − {right}: {difference:?}");
            prop_assert!(product.contains(&Float::with_val(TRUTH, &left * &right)), "{left} · {right}: {product:?}");
            prop_assert!(right.is_zero() || quotient.contains(&Float::with_val(TRUTH, &left / &right)), "{left}/{right}: {quotient:?}");
        }
    }

    #[test]
    fn powers(x in few(|bits| interval_of(float(bits, -6..=6).boxed())), y in few(|bits| interval_of(signed(bits, -6..=3).boxed()))) {
        let y = y.rounded(x.ctx());
        let power = x.pow(&y);
        for base in samples(&x, TRUTH) {
            for exponent in samples(&y, TRUTH) {
                let truth = base.clone().pow(&exponent);
                prop_assert!(power.contains(&truth), "{base}^{exponent}: {power:?}");
            }
        }
    }
}

/// A number of a few bits beside its truth.
struct Counted {
    number: RoundingCount,
    truth: Float,
}

impl Counted {
    /// The relative error is at most (1+u)^k − 1, and so the truth is in the enclosure, whose own rounding is far below u.
    fn check(&self, what: &str) -> Result<(), TestCaseError> {
        let bits = self.number.value().prec();
        let ratio = Float::with_val(TRUTH, &self.truth / self.number.value());
        let unit = Float::with_val(TRUTH, 1) >> bits;
        let most = (Float::with_val(TRUTH, self.number.roundings()) * unit.ln_1p()).exp_m1();
        let error = Float::with_val(TRUTH, &ratio - 1u32).abs().max(&(ratio.recip() - 1u32).abs());
        prop_assert!(
            error <= most,
            "{what}: an error of {error}, {} roundings of {bits} bits",
            self.number.roundings()
        );
        let enclosure = self.number.enclosure(Precision::new(TRUTH));
        prop_assert!(enclosure.contains(&self.truth), "{what}: {enclosure:?} without {}", self.truth);
        Ok(())
    }
}

proptest! {
    /// Operations on exact numbers: one rounding more or less shows.
    #[test]
    fn counts_of_one_operation((x, y) in FEW.prop_flat_map(|bits| (float(bits, -8..=8), float(bits, -8..=8)))) {
        let exact = |x: &Float| RoundingCount::new(x.clone(), 0);
        let wide = |x: &Float| Float::with_val(TRUTH, x);
        let (left, right) = (wide(&x), wide(&y));
        let cases = [
            ("product", exact(&x).times(&exact(&y)), left.clone() * &right),
            ("quotient", exact(&x).over(&exact(&y)), left.clone() / &right),
            ("sum", exact(&x).plus(&exact(&y)), left.clone() + &right),
            ("root", exact(&x).sqrt(), left.clone().sqrt()),
            ("mean", exact(&x).agm(&exact(&y)), left.clone().agm(&right)),
            ("thirds", exact(&x).scaled(&(1, 3).into()), left.clone() / 3),
            ("sevenths", exact(&x).scaled(&(5, 7).into()), left.clone() * 5 / 7),
            ("cube", exact(&x).power(3, 1), Float::with_val(TRUTH, left.clone().pow(3))),
            ("inverse square", exact(&x).power(-2, 1), Float::with_val(TRUTH, left.clone().pow(-2))),
            ("power 3/2", exact(&x).power(3, 2), Float::with_val(TRUTH, left.clone().pow(3)).sqrt()),
            ("power 1/4", exact(&x).power(1, 4), left.clone().sqrt().sqrt()),
        ];
        for (what, number, truth) in cases {
            Counted { number, truth }.check(what)?;
        }
    }

    /// Chains of operations, and roots by iteration.
    #[test]
    fn counts_of_many_operations(
        numbers in FEW.prop_flat_map(|bits| prop::collection::vec(float(bits, -3..=3), 2..8)),
        kinds in prop::collection::vec(0..7, 8),
    ) {
        let exact = |x: &Float| Counted { number: RoundingCount::new(x.clone(), 0), truth: Float::with_val(TRUTH, x) };
        let mut chain = exact(&numbers[0]);
        for (next, kind) in numbers[1..].iter().map(exact).zip(kinds) {
            let Counted { number, truth } = chain;
            let (number, truth) = match kind {
                0 => (number.times(&next.number), truth * next.truth),
                1 => (number.over(&next.number), truth / next.truth),
                2 => (number.plus(&next.number), truth + next.truth),
                3 => (number.sqrt().times(&next.number), truth.sqrt() * next.truth),
                4 => (number.agm(&next.number), truth.agm(&next.truth)),
                5 => (number.power(-2, 1).plus(&next.number), Float::with_val(TRUTH, truth.pow(-2)) + next.truth),
                _ => (number.scaled(&(7, 9).into()), truth * 7 / 9),
            };
            chain = Counted { number, truth };
            chain.check("a chain")?;
        }
        let Counted { number, truth } = chain;
        for (p, q) in [(1, 3), (-2, 3), (5, 7), (-1, 5)] {
            let found = number.clone().power(p, q);
            // At so few bits the iteration may give up, which is said.
            if found.value().is_finite() {
                let exponent = Float::with_val(TRUTH, p) / q;
                Counted { number: found, truth: truth.clone().pow(exponent) }.check("a root")?;
            }
        }
    }
}

/// A number with a rational truth, at every few bits.
#[test]
fn numbers_that_are_no_floats() {
    for bits in FEW {
        let precision = Precision::new(bits);
        let third = Interval::from_int(precision, 1).over(3);
        assert!(third.contains(&(Float::with_val(TRUTH, 1) / 3)) && !third.is_point(), "{bits}");
        let pi = Float::with_val(TRUTH, rug::float::Constant::Pi);
        assert!(third.pi().contains(&pi), "{bits}: {:?}", third.pi());
        assert!(RoundingCount::pi(precision).enclosure(Precision::new(TRUTH)).contains(&pi), "{bits}");
        for value in [0.1, 1e-30, 123_456_789.0, -0.7] {
            assert!(Interval::from_f64(precision, value).contains(&Float::with_val(TRUTH, value)), "{bits}: {value}");
        }
    }
}
