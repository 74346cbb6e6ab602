//! Differences such as exp(u) − 1 that cancel where u is small, computed without the cancellation, and logarithms such as ln(1 + exp(u)) whose
//! argument overflows where u is large, without the overflow.

#[cfg(feature = "mp")]
use std::cmp::Ordering;

use super::{Function, Node, Operator};
#[cfg(feature = "mp")]
use crate::number::{Analytic, Interval, Precision, Real};
use crate::number::{Lift, Special};

/// A difference f(u) − f(0) of a function whose form allows another way to compute it, or a logarithm of 1 + u, 1 + exp(u) or cosh u.
pub(super) struct Departure<'a, R> {
    kind: Kind<'a, R>,
    u: &'a Node<R>,
    /// Whether −u is the argument,
    falls: bool,
    /// and whether the difference is f(0) − f(u).
    is_reversed: bool,
}

enum Kind<'a, R> {
    Exponential,
    Cosine,
    HyperbolicCosine,
    Logarithm,
    /// ln(1 + exp(u)), a smooth max(0, u).
    Softplus,
    /// ln(cosh u), a smooth |u| − ln 2.
    LogarithmOfCosh,
    /// √(b² + u) − b.
    Root(&'a Node<R>),
}

impl<R: Special> Node<R> {
    /// The formula as such a difference, if it has its form.
    pub(super) fn departure(&self) -> Option<Departure<'_, R>> {
        match self {
            Node::Function(Function::Ln, inner) => {
                let of = |kind, u, falls| Some(Departure { kind, u, falls, is_reversed: false });
                if let Node::Function(Function::Cosh, u) = &**inner {
                    return of(Kind::LogarithmOfCosh, u, false);
                }
                match inner.parts_of_sum().find(|(one, ..)| one.is_one())? {
                    (_, Node::Function(Function::Exp, u), false) => of(Kind::Softplus, u, false),
                    (_, u, falls) => of(Kind::Logarithm, u, falls),
                }
            }
            Node::Operation(Operator::Subtract, a, b) => {
                a.less(b).or_else(|| b.less(a).map(|difference| Departure { is_reversed: true, ..difference }))
            }
            _ => None,
        }
    }

    /// The difference f(u) − f(0), if this is f(u), with the other as f(0).
    fn less<'a>(&'a self, other: &'a Node<R>) -> Option<Departure<'a, R>> {
        let (kind, u, falls) = match self {
            Node::Function(Function::Exp, u) if other.is_one() => (Kind::Exponential, &**u, false),
            Node::Function(Function::Cos, u) if other.is_one() => (Kind::Cosine, &**u, false),
            Node::Function(Function::Cosh, u) if other.is_one() => (Kind::HyperbolicCosine, &**u, false),
            Node::Function(Function::Sqrt, inner) => {
                let (_, u, falls) = inner.parts_of_sum().find(|(square, ..)| square.is_square_of(other))?;
                (Kind::Root(other), u, falls)
            }
            _ => return None,
        };
        Some(Departure { kind, u, falls, is_reversed: false })
    }

    /// Of a sum or difference one part, the other, and whether the other is subtracted.
    fn parts_of_sum(&self) -> impl Iterator<Item = (&Node<R>, &Node<R>, bool)> {
        let (added, swapped) = match self {
            Node::Operation(Operator::Add, a, b) => (Some((&**a, &**b, false)), Some((&**b, &**a, false))),
            Node::Operation(Operator::Subtract, a, b) => (Some((&**a, &**b, true)), None),
            _ => (None, None),
        };
        added.into_iter().chain(swapped)
    }

    fn is_one(&self) -> bool {
        matches!(self, Node::Constant(constant) if constant.is_integer(1))
    }

    /// Whether it is seen to be the square of a constant that is not negative.
    fn is_square_of(&self, root: &Node<R>) -> bool {
        let Node::Constant(value) = root else { return false };
        let is_square = match self {
            Node::Constant(square) => *square == value.square(),
            Node::Power(base, 2) => **base == *root,
            Node::Operation(Operator::Multiply, a, b) => **a == *root && **b == *root,
            _ => false,
        };
        is_square && *value >= value.lit(0)
    }
}

impl<R: Special> Departure<'_, R> {
    /// The argument u, whose rounding errors are those of the value.
    pub(super) fn argument(&self) -> &Node<R> {
        self.u
    }

    pub(super) fn value<S: Lift<R>>(&self, r: &S) -> S {
        let u = self.u.value(r);
        let u = if self.falls { -u } else { u };
        let value = self.kind.value(&u, r);
        if self.is_reversed { -value } else { value }
    }
}

impl<R: Special> Kind<'_, R> {
    /// By the other way only where u is small: elsewhere less than three bits cancel, and enclosures are tighter as written.
    fn value<S: Lift<R>>(&self, u: &S, r: &S) -> S {
        let is_small = u.value_of().abs() < u.value_of().ratio(1, 2);
        let (one, half) = (u.lit(1), || u.clone().over(2));
        match self {
            Kind::Exponential if is_small => (half().exp() * half().sinh()).times(2),
            Kind::Exponential => u.exp() - one,
            Kind::Cosine if is_small => -half().sin().square().times(2),
            Kind::Cosine => u.cos() - one,
            Kind::HyperbolicCosine if is_small => half().sinh().square().times(2),
            Kind::HyperbolicCosine => u.cosh() - one,
            Kind::Logarithm if is_small => (u.clone() / (u.lit(2) + u)).atanh().times(2),
            Kind::Logarithm => (one + u).ln(),
            Kind::Softplus if u.value_of() > u.value_of().lit(0) => (-u.clone()).exp().ln_1p() + u,
            Kind::Softplus => u.exp().ln_1p(),
            Kind::LogarithmOfCosh if is_small => u.sinh().square().ln_1p().over(2),
            Kind::LogarithmOfCosh => {
                let size = u.abs();
                (size.clone().times(-2)).exp().ln_1p() - one.times(2).ln() + size
            }
            Kind::Root(base) => {
                let base = base.value(r);
                let square = base.square();
                let root = (square.clone() + u).sqrt();
                let is_small = u.value_of().abs() < square.value_of().over(2);
                if is_small { u.clone() / (root + base) } else { root - base }
            }
        }
    }
}

/// The exponent above which an exponential function is not divided by: its square overflows in doubles above 354.
const LARGE: i64 = 300;

/// A denominator that grows as an exponential function.
pub(super) enum Growing<'a, R> {
    /// c + e^u with a constant c.
    Exponential(&'a R, &'a Node<R>),
    /// cosh u.
    Cosh(&'a Node<R>),
}

impl<R: Special> Node<R> {
    /// The two sides of a quotient whose denominator grows as an exponential function.
    pub(super) fn over_growing(&self) -> Option<(&Node<R>, Growing<'_, R>)> {
        let Node::Operation(Operator::Divide, a, b) = self else { return None };
        if let Node::Function(Function::Cosh, u) = &**b {
            return Some((a, Growing::Cosh(u)));
        }
        let growing = b.parts_of_sum().find_map(|part| match part {
            (Node::Constant(c), Node::Function(Function::Exp, u), false) => Some(Growing::Exponential(c, u)),
            _ => None,
        })?;
        Some((a, growing))
    }

    /// a/(c + e^u) where e^u is large, as a e^(−u)/(c e^(−u) + 1), and a/cosh u as 2a e^(−|u|)/(1 + e^(−2|u|)): the derivatives of a
    /// quotient by an infinity are no numbers.
    pub(super) fn over_large_exponential<S: Lift<R>>(&self, r: &S) -> Option<S> {
        let (a, growing) = self.over_growing()?;
        let inverse = |u: &S| (u.value_of() > u.value_of().lit(LARGE)).then(|| (-u.clone()).exp());
        Some(match growing {
            Growing::Exponential(c, u) => {
                let e = inverse(&u.value(r))?;
                a.value(r) * &e / (S::lift(c) * &e + e.lit(1))
            }
            Growing::Cosh(u) => {
                let u = u.value(r);
                let e = inverse(&u).or_else(|| inverse(&-u))?;
                a.value(r).times(2) * &e / (e.clone().square() + e.lit(1))
            }
        })
    }
}

#[cfg(feature = "mp")]
impl Growing<'_, Interval> {
    /// a over this, also where this has no bound.
    pub(super) fn under<T: Analytic>(&self, a: &T, r: &T) -> Option<T> {
        match self {
            Growing::Exponential(c, u) => {
                let u = u.analytic(r)?;
                let direct = a.quotient(&u.constant(c).plus(&u.exp()));
                direct.filter(T::is_bounded).or_else(|| {
                    let e = u.negated().exp();
                    a.product(&e).quotient(&e.scaled(c).plus(&e.integer(1)))
                })
            }
            Growing::Cosh(u) => {
                let u = u.analytic(r)?;
                let far = |u: &T| {
                    let e = u.exp();
                    a.product(&e).multiplied(2).quotient(&e.squared().plus(&e.integer(1))).filter(T::is_bounded)
                };
                let direct = a.quotient(&u.sinh_cosh().1).filter(T::is_bounded);
                direct.or_else(|| far(&u.negated())).or_else(|| far(&u))
            }
        }
    }
}

#[cfg(feature = "mp")]
impl Departure<'_, Interval> {
    /// The value over a set.
    pub(super) fn analytic<T: Analytic>(&self, r: &T) -> Option<T> {
        let u = self.u.analytic(r)?;
        let u = if self.falls { u.negated() } else { u };
        let value = self.kind.analytic(&u, r)?;
        Some(if self.is_reversed { value.negated() } else { value })
    }
}

#[cfg(feature = "mp")]
impl Kind<'_, Interval> {
    /// By the ways of [`Kind::value`].
    fn analytic<T: Analytic>(&self, u: &T, r: &T) -> Option<T> {
        let (one, half, is_small) = (u.integer(1), || u.divided(2), u.is_small());
        Some(match self {
            // 2 e^(u/2) sinh(u/2)
            Kind::Exponential if is_small => {
                let (sinh, cosh) = half().sinh_cosh();
                sinh.plus(&cosh).product(&sinh).multiplied(2)
            }
            Kind::Exponential => u.exp().minus(&one),
            Kind::Cosine if is_small => half().sin_cos().0.squared().multiplied(-2),
            Kind::Cosine => u.sin_cos().1.minus(&one),
            Kind::HyperbolicCosine if is_small => half().sinh_cosh().0.squared().multiplied(2),
            Kind::HyperbolicCosine => u.sinh_cosh().1.minus(&one),
            Kind::Logarithm if is_small => u.quotient(&u.integer(2).plus(u))?.atanh()?.multiplied(2),
            Kind::Logarithm => one.plus(u).ln()?,
            Kind::Softplus if u.side() == Some(Ordering::Greater) => {
                Kind::Logarithm.analytic(&u.negated().exp(), r)?.plus(u)
            }
            Kind::Softplus => Kind::Logarithm.analytic(&u.exp(), r)?,
            Kind::LogarithmOfCosh if is_small => Kind::Logarithm.analytic(&u.sinh_cosh().0.squared(), r)?.divided(2),
            Kind::LogarithmOfCosh => {
                let size = match u.side() {
                    Some(Ordering::Greater) => u.clone(),
                    Some(_) => u.negated(),
                    None => return u.sinh_cosh().1.ln(),
                };
                let rest = Kind::Logarithm.analytic(&size.multiplied(-2).exp(), r)?;
                let two = u.constant(&Real::ln(&Interval::from_int(Precision::new(u.bits()), 2)));
                rest.minus(&two).plus(&size)
            }
            Kind::Root(base) => {
                let base = base.analytic(r)?;
                let square = base.squared();
                let root = square.plus(u).sqrt()?;
                let is_small = u.quotient(&square).is_some_and(|share| share.is_small());
                if is_small { u.quotient(&root.plus(&base))? } else { root.minus(&base) }
            }
        })
    }
}

#[cfg(all(test, feature = "mp"))]
mod tests {
    use std::collections::BTreeMap;

    use rug::Float;

    use super::super::{Expression, Profile};
    use crate::number::{DoubleInterval, Dual, Euler, Interval, Precision, Real, Rectangle};

    const FORMS: [&str; 14] = [
        "ln(cosh(r))",
        "ln(1 + exp(-r))",
        "exp(r^2) - 1",
        "1 - exp(-r^2)",
        "3*(1 - cos(r))",
        "cosh(2*r) - 1",
        "ln(1 + r^2)",
        "ln(r^2 + 1)/2",
        "-ln(1 - r^2)",
        "sqrt(1 + r^2) - 1",
        "1 - sqrt(1 - r^2)",
        "0.3 - sqrt(0.3^2 - r^2)",
        "sqrt(r*r + 0.3*0.3) - 0.3",
        "sqrt(4 + r^2) - 2",
    ];

    fn exact(formula: &Expression, r: f64) -> [Float; 2] {
        let precision = Precision::new(2000);
        let profile = formula.bind::<Float>(precision, &BTreeMap::new()).expect("bound");
        let f = profile.height(&Dual::variable(Float::with_val(2000, r)));
        [f.value, f.slope]
    }

    #[test]
    fn small_differences_keep_their_digits() {
        for text in FORMS {
            let formula: Expression = text.parse().expect("a formula");
            let profile = formula.bind::<f64>((), &BTreeMap::new()).expect("bound");
            for r in [1e-12, 1e-9, 1e-6, 1e-3, 0.03, 0.2, 0.29] {
                let f = profile.height(&Dual::variable(r));
                for (got, truth) in [f.value, f.slope].into_iter().zip(exact(&formula, r)) {
                    let error = ((got - truth.clone()) / truth).to_f64();
                    // A few roundings, and where the other way begins three bits that cancel.
                    assert!(error.abs() < 16.0 * f64::EPSILON, "{text} at {r}: {error:e}");
                }
                let largest = profile.largest_term(&r).expect("of a formula");
                assert!(largest <= 2.0 * f.value.abs(), "{text} at {r}: {largest:e}");
            }
        }
    }

    #[test]
    fn enclosures_hold_and_do_not_widen() {
        // Enclosures of 0.3 are not seen to be the same number.
        for text in FORMS.into_iter().filter(|text| !text.contains("0.3")) {
            let formula: Expression = text.parse().expect("a formula");
            let profile = formula.bind::<Interval>(Precision::new(64), &BTreeMap::new()).expect("bound");
            for (r, width) in [(1e-9, 1e-12), (1e-3, 1e-6), (0.2, 0.001), (0.2, 0.05)] {
                let cell =
                    Interval::from_f64(Precision::new(64), r).hull(&Interval::from_f64(Precision::new(64), r + width));
                let f = profile.height(&Dual::variable(cell));
                let [low, high] = [exact(&formula, r), exact(&formula, r + width)];
                for ((got, low), high) in [f.value, f.slope].iter().zip(&low).zip(&high) {
                    assert!(got.contains(low) && got.contains(high), "{text} at {r} + {width}");
                    let widening =
                        Float::with_val(64, got.upper() - got.lower()) / Float::with_val(64, high - low).abs();
                    assert!(widening < 4.0, "{text} at {r} + {width}: {widening}");
                }
            }
        }
    }

    /// ln(1 + exp(±u)) and ln(cosh u) at u = 5000, where exp(u) is no double: u, 0 and u − ln 2, up to exp(−5000).
    #[test]
    fn large_exponentials_do_not_overflow() {
        let ln_2 = std::f64::consts::LN_2;
        for (text, value, slope) in [
            ("ln(1 + exp(1e4*r))", 5000.0, 1e4),
            ("ln(exp(-1e4*r) + 1)", 0.0, 0.0),
            ("ln(cosh(1e4*r))", 5000.0 - ln_2, 1e4),
            ("ln(cosh(-1e4*r))", 5000.0 - ln_2, 1e4),
        ] {
            let formula: Expression = text.parse().expect("a formula");
            let profile = formula.bind::<f64>((), &BTreeMap::new()).expect("bound");
            let f = profile.height(&Dual::variable(0.5));
            assert!((f.value - value).abs() < 1e-12 && f.slope == slope, "{text}: {f:?}");
            let root = formula.with_values(&BTreeMap::new()).expect("no parameters");
            let tree = root.bound::<Interval>(Precision::new(64));
            let cell = DoubleInterval::point(0.5).hull(&DoubleInterval::point(0.5001));
            let over = tree.analytic(&Euler::variable(&cell, 1)).expect("defined");
            let rise = 0.5 * slope;
            assert!(over.value().lower() <= value && over.value().upper() >= value, "{text}");
            assert!(over.derivative(1).lower() <= rise && over.derivative(1).upper() < rise + 2.0, "{text}");
            let set = Rectangle::new(cell, DoubleInterval::point(0.0).hull(&DoubleInterval::point(0.001)));
            let image = tree.analytic(&set).expect("analytic");
            assert!(image.re().lower() <= value && image.re().upper() >= value, "{text}");
        }
    }

    /// Over points, also in doubles and with derivatives: relative to the value a few roundings remain.
    #[test]
    fn steps_have_derivatives_far_from_them() {
        for (text, value) in [
            ("tanh((r - 0.4)/1e-6)", -1.0),
            ("tanh((0.4 - r)/1e-6)", 1.0),
            ("1/(1 + exp((0.4 - r)/1e-6))", 0.0),
            ("1/(1 + exp((r - 0.4)/1e-6))", 1.0),
            ("1/(exp((0.4 - r)/1e-3) + 2)", 0.0),
        ] {
            let formula: Expression = text.parse().expect("a formula");
            let profile = formula.bind::<f64>((), &BTreeMap::new()).expect("bound");
            let f = profile.height(&Dual::variable(Dual::variable(0.01)));
            let found = (f.value.value, f.slope.value, f.slope.slope);
            assert!(found.0 == value || found.0.abs() < 1e-160, "{text}: {found:?}");
            assert!(found.1.abs() < 1e-160 && found.2.abs() < 1e-160, "{text}: {found:?}");
        }
    }

    #[test]
    fn sets_keep_their_digits() {
        for text in FORMS {
            let formula: Expression = text.parse().expect("a formula");
            let root = formula.with_values(&BTreeMap::new()).expect("no parameters");
            let tree = root.bound::<Interval>(Precision::new(64));
            // Enclosures of 0.3 are not seen to be the same number: they cancel.
            let spared = if text.contains("0.3") { 64 } else { 8 };
            for r in [1e-9, 1e-3, 0.2] {
                let point = Interval::from_f64(Precision::new(64), r);
                let [height, rise] = exact(&formula, r);
                let rise = rise * r;
                let f = tree.analytic(&Euler::variable(&point, 1)).expect("defined");
                for (value, truth) in [(f.value().clone(), &height), (f.derivative(1), &rise)] {
                    assert!(value.contains(truth), "{text} at {r}: {value} without {truth}");
                    assert!(value.accuracy_bits() > 64 - spared, "{text} at {r}: {value}");
                }
                let double = tree.analytic(&DoubleInterval::point(r)).expect("defined").widened(Precision::new(64));
                assert!(double.contains(&height), "{text} at {r}: {double} without {height}");
                assert!(double.accuracy_bits() > 53 - spared, "{text} at {r}: {double}");
                let disc = point.clone().inflate(&point.clone().over(4));
                let set = Rectangle::new(disc, point.clone().over(4).hull(&point.lit(0)));
                assert!(tree.analytic(&set).expect("defined").re().contains(&height), "{text} around {r}");
            }
        }
    }
}
