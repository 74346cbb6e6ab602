//! The integrands of a formula on a medium, over a variable t in which weight and heights are analytic.
//!
//! | medium | t | sinθ | weight dθ/dt |
//! |---|---|---|---|
//! | half-space | 2θ/π | sin(πt/2) | (π/2) sinθ |
//! | graded as zᵏ | the inverse Gudermannian of θ | tanh t | sinθ cos^(1+k)θ, as cosθ dt = dθ |
//! | Winkler | sinθ | t | sinθ, as cosθ dθ = dt |
//! | line contact | 2θ/π | sin(πt/2) | π/2 |
//!
//! Where fractional powers of r make f analytic at the axis as a function of q = r^(1/k) alone, the variable is another: with
//! u = tᵏ it is u = tan(θ/2), so that sinθ = 2u/(1 + u²), dθ = 2du/(1 + u²) and q = x^(1/k) t (2/(1 + u²))^(1/k); on a Winkler
//! foundation u = sinθ. On a graded half-space the pieces are cut towards the axis instead.
//!
//! On a graded half-space t ends at a finite T, where what is beyond is a mean of its integrand times
//! ∫ sinθ cosᵏθ dθ = cos^(1+k)θ/(1 + k).

use std::sync::atomic::{AtomicU64, Ordering};

use mdr_core::calculus::enclose::Integrand;
use mdr_core::contact::FormulaPart;
use mdr_core::number::{Analytic, Euler, Interval, Precision, Real, Special};
use rug::Float;

use super::super::weight::Weight;
use super::Order;

/// A formula between two breaks, on radii r = x sinθ.
pub(super) struct Ray<'a> {
    pub(super) part: &'a FormulaPart,
    pub(super) x: &'a Interval,
    pub(super) order: Order,
    pub(super) weight: &'a Weight<Interval>,
    /// The heights that were evaluated, counted over intervals of doubles.
    pub(super) heights: &'a AtomicU64,
}

impl Ray<'_> {
    /// The Euler derivatives of f at x sinθ.
    fn heights<T: Analytic>(&self, sine: &T) -> Option<Euler<T>> {
        self.heights.fetch_add(T::WORK, Ordering::Relaxed);
        self.part.derivatives_at(&sine.scaled(self.x), self.order.derivatives())
    }

    /// What is weighted, from f.
    fn weighted<T: Analytic>(&self, f: &Euler<T>, sine: &T) -> Option<Vec<T>> {
        let k = match self.weight {
            Weight::Line(reference) => return self.of_line(f, sine, reference.as_ref()),
            Weight::HalfSpace => None,
            Weight::Graded(k) => Some(k.clone()),
            Weight::Winkler => Some(self.x.lit(1)),
        };
        let number = |value: &Interval| value.rounded(Precision::new(sine.bits()));
        // (1 + k) v.
        let ordered = |v: &T| match &k {
            None => v.clone(),
            Some(k) => v.scaled(&(number(k) + Interval::from_int(Precision::new(sine.bits()), 1))),
        };
        Some(match self.order {
            Order::Value => {
                let height = ordered(f.value());
                vec![height.clone(), height.plus(&f.derivative(1)), f.derivative(1)]
            }
            Order::Slope => vec![ordered(&f.derivative(1)).plus(&f.derivative(2))],
            Order::Curvature => {
                let first = ordered(&f.derivative(1));
                let third = match &k {
                    None => f.derivative(3),
                    Some(k) => f.derivative(3).plus(&f.derivative(2).scaled(&number(k))),
                };
                vec![first.plus(&f.derivative(2)), third.minus(&first)]
            }
        })
    }

    /// In line contact: the mean of N against the reference, N, and N; or bN'; or bN' and b²N''.
    fn of_line<T: Analytic>(&self, f: &Euler<T>, sine: &T, reference: Option<&Interval>) -> Option<Vec<T>> {
        Some(match self.order {
            Order::Value => {
                let mean = match reference {
                    None => sine.integer(0),
                    Some(reference) => {
                        let share = (self.x.clone() / reference).square();
                        let two = share.lit(2);
                        let factor = Real::sqrt(&(share.lit(1) - &share)) * two / share.pi();
                        let room = sine.integer(1).minus(&sine.squared().scaled(&share));
                        f.value().scaled(&factor).quotient(&room)?
                    }
                };
                vec![mean, f.derivative(1), f.derivative(1)]
            }
            Order::Slope => vec![f.derivative(2)],
            Order::Curvature => vec![f.derivative(2), f.derivative(3).minus(&f.derivative(2))],
        })
    }

    /// sinθ and the weight dθ/dt.
    fn places<T: Analytic>(&self, t: &T) -> Option<[T; 2]> {
        let quarter_turn = || t.half_turn().divided(2);
        Some(match self.weight {
            Weight::HalfSpace => {
                let quarter_turn = quarter_turn();
                let sine = t.product(&quarter_turn).sin_cos().0;
                let weight = sine.product(&quarter_turn);
                [sine, weight]
            }
            Weight::Line(_) => {
                let quarter_turn = quarter_turn();
                [t.product(&quarter_turn).sin_cos().0, quarter_turn]
            }
            Weight::Winkler => [t.clone(), t.clone()],
            Weight::Graded(k) => {
                // With e = exp(−2t): tanh t = (1 − e)/(1 + e), and 1/cosh t = 2 exp(−t)/(1 + e).
                let one = t.integer(1);
                let e = t.integer(-2).product(t).exp();
                let sum = one.plus(&e);
                let sine = one.minus(&e).quotient(&sum)?;
                let two = Interval::from_int(Precision::new(t.bits()), 2);
                let log = t.constant(&Real::ln(&two)).minus(t).minus(&sum.ln()?);
                let cosine = log.scaled(&(k.rounded(two.ctx()) + two.lit(1))).exp();
                let weight = sine.product(&cosine);
                [sine, weight]
            }
        })
    }

    /// The integral beyond the end of t, on a graded half-space: the range of what is weighted, times the weight there.
    pub(super) fn beyond(&self, end: &Float, precision: Precision) -> Option<Vec<Interval>> {
        let Weight::Graded(k) = self.weight else { return Some(Vec::new()) };
        let order = k.rounded(precision) + Interval::from_int(precision, 1);
        let end = Interval::point(end.clone()).rounded(precision);
        let cosine = end.lit(1) / Special::cosh(&end);
        let sine = Special::tanh(&end).hull(&end.lit(1));
        let weight = cosine.pow(&order) / order;
        let range = self.weighted(&self.heights(&sine)?, &sine)?;
        Some(range.into_iter().map(|value| value * &weight).collect())
    }
}

impl Ray<'_> {
    /// t where sinθ has this value.
    pub(super) fn position(&self, sine: &Interval) -> Interval {
        match (self.part.root(), self.weight) {
            (None, _) | (_, Weight::Graded(_)) => self.weight.position(sine),
            (Some(k), weight) => {
                let root = sine.lit(1).over(i64::from(k));
                // tan(θ/2) = sinθ/(1 + cosθ)
                let cosine = Real::sqrt(&((sine.lit(1) - sine) * (sine.lit(1) + sine)));
                let u = if let Weight::Winkler = weight { sine.clone() } else { sine.clone() / (cosine + sine.lit(1)) };
                u.pow(&root)
            }
        }
    }

    /// The integrand over t with q = r^(1/k) proportional to t at the axis.
    fn at_root<T: Analytic>(&self, t: &T, k: u32) -> Option<Vec<T>> {
        self.heights.fetch_add(T::WORK, Ordering::Relaxed);
        let precision = Precision::new(t.bits());
        let number = |value: u32| Interval::from_int(precision, i64::from(value));
        let root = number(1) / number(k);
        let u = t.raised(i64::from(k))?;
        let slope = t.raised(i64::from(k) - 1)?.scaled(&number(k));
        let [sine, turn, q] = match self.weight {
            Weight::Winkler => [u, t.integer(1), t.clone()],
            _ => {
                let half = t.integer(2).quotient(&t.integer(1).plus(&u.squared()))?;
                [u.product(&half), half.clone(), t.product(&half.power(&root)?)]
            }
        };
        let q = q.scaled(&self.x.rounded(precision).pow(&root));
        let weight = turn.product(&slope);
        let weight = if let Weight::Line(_) = self.weight { weight } else { weight.product(&sine) };
        let f = self.part.derivatives_at_root(&q, self.order.derivatives())?;
        let values = self.weighted(&f, &sine)?;
        Some(values.into_iter().map(|value| value.product(&weight)).collect())
    }
}

/// The logarithm of 10⁷⁵ to the base 2: the fourth power of a radius up to there is a double.
const MODERATE: i32 = 250;

/// Whether powers of a radius are in the range of doubles.
pub(crate) fn is_moderate(x: &Interval) -> bool {
    let exponents = [x.lower(), x.upper()].map(Float::get_exp);
    exponents.iter().all(|exponent| exponent.is_some_and(|exponent| exponent.abs() < MODERATE))
}

impl Integrand for Ray<'_> {
    fn is_moderate(&self) -> bool {
        is_moderate(self.x)
    }

    fn at<T: Analytic>(&self, t: &T) -> Option<Vec<T>> {
        if let (Some(k), Weight::HalfSpace | Weight::Winkler | Weight::Line(_)) = (self.part.root(), self.weight) {
            return self.at_root(t, k);
        }
        let [sine, weight] = self.places(t)?;
        let values = self.weighted(&self.heights(&sine)?, &sine)?;
        Some(values.into_iter().map(|value| value.product(&weight)).collect())
    }
}

impl Weight<Interval> {
    /// The end of t: 1, or where the range of what is beyond is as narrow as these bits ask for, cos^(3+k)θ ≈ 2^−bits.
    pub(super) fn end(&self, bits: u32) -> Float {
        match self {
            Weight::Graded(k) => {
                let end = (f64::from(bits) * std::f64::consts::LN_2 / (3.0 + k.approx())).ceil();
                Float::with_val(bits, end)
            }
            _ => Float::with_val(bits, 1),
        }
    }

    /// t where sinθ has this value.
    pub(super) fn position(&self, sine: &Interval) -> Interval {
        match self {
            Weight::HalfSpace | Weight::Line(_) => Special::asin(sine).times(2) / sine.pi(),
            Weight::Winkler => sine.clone(),
            Weight::Graded(_) => {
                // artanh, which is not finite at an enclosure of 1.
                let [low, high] = [sine.lower(), sine.upper()].map(|end| Interval::point(end.clone()));
                let far = Interval::point(self.end(sine.precision()));
                let place = |end: Interval| {
                    let place = if end < end.lit(1) { Special::atanh(&end) } else { far.clone() };
                    if Real::is_finite(&place) { place } else { far.clone() }
                };
                place(low).hull(&place(high))
            }
        }
    }

    /// A place beside a number in (0, 1): the places are spread over most of the integral.
    pub(super) fn sample(&self, t: &Interval) -> Interval {
        if let Weight::Graded(_) = self { self.position(t) } else { t.clone() }
    }

    /// T of a kink b, whose jump \[Df\] is in x g' the further term \[Df\] T: tanθ times the weight, sin²θ cos^(k−1)θ on a graded
    /// half-space with k = 0 on a homogeneous one, tanθ in line contact. It is the entire line unless x is certainly beyond b.
    pub(super) fn share_of_kink(&self, x: &Interval, b: &Interval) -> Interval {
        // x cosθ.
        let root = Real::sqrt(&((x.clone() - b) * (x.clone() + b)));
        match self {
            Weight::Line(_) => b.clone() / root,
            Weight::Graded(k) if root > root.lit(0) => {
                let share = b.square() / (x.clone() * &root);
                share * (root / x).pow(&k.rounded(x.ctx()))
            }
            Weight::Graded(_) => Interval::entire(x.ctx()),
            Weight::HalfSpace | Weight::Winkler => b.square() / (x.clone() * root),
        }
    }

    /// What \[Df\] has as its factor in x²g'', over T: −1 − (1 − k)/cos²θ, beside the term T\[D²f\].
    pub(super) fn bend_of_kink(&self, x: &Interval, b: &Interval) -> Interval {
        let inverse = x.square() / ((x.clone() - b) * (x.clone() + b));
        match self {
            Weight::Graded(k) => -(inverse * (x.lit(1) - k.rounded(x.ctx())) + x.lit(1)),
            _ => -(inverse + x.lit(1)),
        }
    }

    /// The part of g' of a jump \[r f'\], beside ranges of (r f')': cos^(k−1)θ/x, tanθ/x in line contact.
    pub(super) fn share_of_step(&self, x: &Interval, b: &Interval) -> Interval {
        let root = Real::sqrt(&((x.clone() - b) * (x.clone() + b)));
        match self {
            Weight::Line(_) => b.clone() / root / x,
            Weight::Graded(k) if root > root.lit(0) => (root.clone() / x).pow(&k.rounded(x.ctx())) / root,
            Weight::Graded(_) => Interval::entire(x.ctx()),
            Weight::HalfSpace | Weight::Winkler => x.lit(1) / root,
        }
    }

    /// The integral, over the part of the quarter circle with this number of `count`, of what (r f')' has as its weight in g': 1,
    /// cosᵏθ, or sinθ in line contact.
    pub(super) fn mass(&self, part: i64, count: i64, like: &Interval) -> Interval {
        let step = like.pi().over(2 * count);
        let [from, to] = [part, part + 1].map(|end| step.clone().times(end));
        match self {
            Weight::HalfSpace | Weight::Winkler => step,
            Weight::Line(_) => Special::cos(&from) - Special::cos(&to),
            Weight::Graded(k) => {
                let k = k.rounded(like.ctx());
                if part + 1 < count {
                    return Special::cos(&from.hull(&to)).pow(&k) * step;
                }
                // From the edge cosᵏθ is the power of the angle, times that of sin φ/φ between its value at the step and 1.
                let order = k.clone() + k.lit(1);
                let ratio = (Special::sin(&step) / &step).hull(&k.lit(1)).pow(&k);
                step.pow(&order) / order * ratio
            }
        }
    }
}
