//! The axioms of the field Q(n), and normal forms against exact evaluation.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use mdr_symbolic::formula::{Evaluator, Function, evaluate};
use mdr_symbolic::{Domain, Expression, Formula, Polynomial, RationalFunction, Symbol};
use proptest::prelude::*;
use rug::Rational;
use rug::ops::Pow;

fn polynomial() -> impl Strategy<Value = Polynomial> {
    prop::collection::vec(-6i64..=6, 0..4).prop_map(|coefficients| Polynomial::from_integers(&coefficients))
}

fn function() -> impl Strategy<Value = RationalFunction> {
    (polynomial(), polynomial().prop_filter("a denominator", |p| !p.is_zero()))
        .prop_map(|(above, below)| RationalFunction::new(above, below).unwrap())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases * 64 / 256))]

    #[test]
    fn rational_functions_are_a_field(f in function(), g in function(), h in function()) {
        let (zero, one) = (RationalFunction::constant(0), RationalFunction::constant(1));
        prop_assert_eq!(&f + &g, &g + &f);
        prop_assert_eq!(&f * &g, &g * &f);
        prop_assert_eq!(&(&f + &g) + &h, &f + &(&g + &h));
        prop_assert_eq!(&(&f * &g) * &h, &f * &(&g * &h));
        prop_assert_eq!(&f * &(&g + &h), &(&f * &g) + &(&f * &h));
        prop_assert_eq!(&f + &zero, f.clone());
        prop_assert_eq!(&f * &one, f.clone());
        prop_assert_eq!(&f + &-&f, zero.clone());
        if !f.is_zero() {
            prop_assert_eq!(&f * &f.inverse().unwrap(), one);
        }
    }

    #[test]
    fn division_leaves_a_smaller_rest(p in polynomial(), q in polynomial()) {
        // One in four is zero: to reject them all would end a long run.
        if q.is_zero() {
            prop_assert!(p.divide(&q).is_err());
            return Ok(());
        }
        let (quotient, rest) = p.divide(&q).unwrap();
        prop_assert_eq!(&(&quotient * &q) + &rest, p);
        prop_assert!(rest.is_zero() || rest.degree() < q.degree());
    }

    /// The rules of powers, with exponents in Q(n): b^e b^f = b^(e+f), (b^e)² = b^2e, (bc)^e = b^e c^e.
    #[test]
    fn powers_of_positive_bases(e in function(), f in function(), number in 1i64..200, offset in 1i64..9) {
        let domain = Domain::Positive;
        let n_plus = Expression::from(RationalFunction::from(Polynomial::linear(2, offset)));
        let bases = [Expression::integer(number), n_plus, Expression::pi(), Expression::symbol(Symbol::KAPPA)];
        let power = |base: &Expression, exponent: &RationalFunction| base.power(exponent, domain).unwrap();
        for base in &bases {
            prop_assert_eq!(power(base, &e).times(&power(base, &f)).unwrap(), power(base, &(&e + &f)));
            prop_assert_eq!(power(base, &e).times(&power(base, &e)).unwrap(), power(base, &(&e + &e)));
            let product = base.times(&bases[1]).unwrap();
            prop_assert_eq!(power(&product, &e), power(base, &e).times(&power(&bases[1], &e)).unwrap());
        }
    }
}

/// Exact arithmetic at a rational point.
struct Exact {
    n: Rational,
    values: [Rational; 2],
}

impl Evaluator for Exact {
    /// `None` after a division by zero.
    type Value = Option<Rational>;

    fn rational(&self, value: &Rational) -> Self::Value {
        Some(value.clone())
    }
    fn pi(&self) -> Self::Value {
        None
    }
    fn n(&self) -> Self::Value {
        Some(self.n.clone())
    }
    fn symbol(&self, symbol: Symbol) -> Self::Value {
        Some(self.values[usize::from(symbol.name() == "a")].clone())
    }
    fn add(&self, left: &Self::Value, right: &Self::Value) -> Self::Value {
        Some(Rational::from(left.as_ref()? + right.as_ref()?))
    }
    fn multiply(&self, left: &Self::Value, right: &Self::Value) -> Self::Value {
        Some(Rational::from(left.as_ref()? * right.as_ref()?))
    }
    fn divide(&self, left: &Self::Value, right: &Self::Value) -> Self::Value {
        let right = right.as_ref().filter(|right| !right.is_zero())?;
        Some(Rational::from(left.as_ref()? / right))
    }
    fn integer_power(&self, base: &Self::Value, exponent: i32) -> Self::Value {
        let base = base.as_ref().filter(|base| exponent >= 0 || !base.is_zero())?;
        Some(base.pow(exponent).into())
    }
    fn power(&self, _: &Self::Value, _: &Self::Value) -> Self::Value {
        None
    }
    fn function(&self, _: Function, _: &[Self::Value]) -> Self::Value {
        None
    }
    fn quarter_turn(&self, _: &Formula) -> Self::Value {
        None
    }
}

/// Random formulas with integer exponents in n, a and w.
fn formula() -> impl Strategy<Value = Formula> {
    let leaf = prop_oneof![
        (0u32..5).prop_map(|value| Formula::Number(value.into())),
        Just(Formula::N),
        Just(Formula::Symbol(Symbol::named("a").unwrap())),
        Just(Formula::Symbol(Symbol::named("w").unwrap())),
    ];
    leaf.prop_recursive(4, 24, 3, |inner| {
        let boxed = || inner.clone().prop_map(Box::new);
        prop_oneof![
            prop::collection::vec(inner.clone(), 2..4).prop_map(Formula::Sum),
            prop::collection::vec(inner.clone(), 2..4).prop_map(Formula::Product),
            boxed().prop_map(Formula::Negative),
            (boxed(), boxed()).prop_map(|(above, below)| Formula::Quotient(above, below)),
            (boxed(), 0u32..3).prop_map(|(base, e)| Formula::Power(base, Box::new(Formula::Number(e.into())))),
        ]
    })
}

fn points() -> impl Iterator<Item = Exact> {
    (1..8).map(|i| Exact {
        n: Rational::from((7 * i + 3, 13)),
        values: [(5 * i + 1, 7).into(), (3 * i * i + 2, 11).into()],
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases * 96 / 256))]

    /// A normal form has the values of its formula, exactly; it is 0 if and only if they all vanish; and the normal
    /// form of a normal form is itself.
    #[test]
    fn normal_forms_agree_with_exact_evaluation(formula in formula()) {
        let Ok(normal) = formula.normalise(Domain::Positive) else { return Ok(()) };
        let written = Formula::from(&normal);
        let mut all_vanish = true;
        for point in points() {
            let [value, of_normal] =
                [&formula, &written].map(|formula| evaluate(formula, Domain::Positive, &point).unwrap());
            if let (Some(value), Some(of_normal)) = (value, of_normal) {
                prop_assert_eq!(&value, &of_normal);
                all_vanish &= value.is_zero();
            }
        }
        prop_assert_eq!(normal.numerator().is_zero(), all_vanish);
        let again = written.normalise(Domain::Positive).unwrap();
        prop_assert_eq!(again.numerator(), normal.numerator());
        prop_assert_eq!(again.denominator(), normal.denominator());
    }

    /// Two formulas are equal if and only if their values are.
    #[test]
    fn equality_is_decided(left in formula(), right in formula()) {
        let (Ok(l), Ok(r)) = (left.normalise(Domain::Positive), right.normalise(Domain::Positive)) else { return Ok(()) };
        let values = |formula: &Formula| -> Vec<_> {
            points().map(|point| evaluate(formula, Domain::Positive, &point).unwrap()).collect()
        };
        let same = values(&left).iter().zip(&values(&right)).all(|(l, r)| l.is_none() || r.is_none() || l == r);
        prop_assert_eq!(l.equals(&r).unwrap(), same);
    }
}
