//! Ways to compute g(x) from heights: textbook quadratures of (1.1), and those of `mdr-numeric`. No closed form is used.
//!
//! | method | of | converges for f ∝ rⁿ as |
//! |---|---|---|
//! | midpoint sum | x∫₀ˣ f'(r)/√(x²−r²) dr | N^−min(n, 1/2) |
//! | Gauss–Chebyshev, that is midpoint in θ | x∫₀^{π/2} f'(x sinθ) dθ | N^−n; geometrically for odd n |
//! | Gauss–Legendre in θ | the same | N^−2n; geometrically for integer n |
//! | regularised, Gauss–Legendre in θ | ∫₀^{π/2} sinθ (f + r f') dθ | N^−2(n+2); geometrically for integer n |
//! | Gauss–Jacobi with the weight r^{n−1}(x−r)^{−1/2} | x∫₀ˣ f'(r)/√(x²−r²) dr | geometrically |
//! | tanh-sinh of a fixed step | the raw form | exp(−cN/ln N) |
//! | tanh-sinh with an error estimate | the regularised form | exp(−cN/ln N) |

use std::sync::Arc;

use mdr_core::calculus::Estimate;
use mdr_core::calculus::gauss_jacobi::{self, Rule as Gauss};
use mdr_core::calculus::quadrature::pieces;
use mdr_core::contact::{Profile, Result, Transform};
use mdr_core::number::{Dual, Special};
use mdr_numeric::transform::{Quadrature, Rule};

/// A contestant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) enum Method {
    /// The midpoint sum of (1.1) over equal steps of r: the profile handed to a foundation of springs, taken literally.
    Midpoint,
    /// Gauss–Chebyshev on (1.1), whose weight it has.
    Chebyshev,
    /// Gauss–Legendre in θ on f'.
    Legendre,
    /// The same between the kinks of the profile.
    LegendrePieces,
    /// Gauss–Legendre in θ on the regularised form, between the kinks.
    Regularised,
    /// Gauss–Jacobi on (1.1), with the tip and the end of the interval in its weight, between the kinks.
    Jacobi,
    /// Tanh-sinh of a fixed step on (1.1), between the kinks.
    TanhSinh,
    /// Tanh-sinh on the regularised form until it has converged: `mdr_numeric` when told so.
    RegularisedTanhSinh,
    /// `mdr_numeric` as it comes.
    Automatic,
}

/// What the effort of a method is counted in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Effort {
    /// Equal steps.
    Steps(usize),
    /// Nodes a piece.
    Nodes(usize),
    /// The step 2⁻ᵏ.
    Halvings(usize),
    /// The tolerance 10⁻ᵏ.
    Tolerance(usize),
}

impl std::fmt::Display for Effort {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Effort::Steps(count) => write!(f, "{count} steps"),
            Effort::Nodes(count) => write!(f, "{count} nodes"),
            Effort::Halvings(count) => write!(f, "step 2^-{count}"),
            Effort::Tolerance(digits) => write!(f, "tolerance 1e-{digits}"),
        }
    }
}

/// Computes g at the radius that it was prepared for.
pub(super) type Solver<'a, R> = Box<dyn Fn() -> Result<R> + 'a>;

impl Method {
    /// All of them.
    pub(super) const ALL: [Method; 9] = [
        Method::Midpoint,
        Method::Chebyshev,
        Method::Legendre,
        Method::LegendrePieces,
        Method::Regularised,
        Method::Jacobi,
        Method::TanhSinh,
        Method::RegularisedTanhSinh,
        Method::Automatic,
    ];

    /// As in the legend.
    pub(in super::super) fn name(self) -> &'static str {
        match self {
            Method::Midpoint => "spring foundation, midpoint sum",
            Method::Chebyshev => "Gauss–Chebyshev",
            Method::Legendre => "Gauss–Legendre in θ",
            Method::LegendrePieces => "Gauss–Legendre in θ, split at kinks",
            Method::Regularised => "regularised form, Gauss–Legendre",
            Method::Jacobi => "Gauss–Jacobi",
            Method::TanhSinh => "tanh-sinh on (1.1)",
            Method::RegularisedTanhSinh => "regularised form, tanh-sinh",
            Method::Automatic => "mdr-numeric",
        }
    }

    /// The effort that an amount is: steps, nodes, halvings of the step, or digits of the tolerance.
    pub(super) fn effort(self, amount: usize) -> Effort {
        match self {
            Method::Midpoint => Effort::Steps(amount),
            Method::TanhSinh => Effort::Halvings(amount),
            Method::RegularisedTanhSinh | Method::Automatic => Effort::Tolerance(amount),
            _ => Effort::Nodes(amount),
        }
    }

    /// Does beforehand what does not depend on the profile but for its kinks and its tip: nodes and weights.
    pub(super) fn prepare<'a, R, P>(self, amount: usize, profile: P, x: &R) -> Result<Solver<'a, R>>
    where
        R: Special,
        P: Profile<R> + 'a,
    {
        let tolerance = || x.lit(10).powi(-i64::try_from(amount).unwrap_or(i64::MAX));
        let legendre = || gauss_jacobi::rule(amount, &x.lit(0), &x.lit(0));
        let x = x.clone();
        Ok(match self {
            Method::Midpoint => Box::new(move || Ok(midpoint(&profile, &x, amount))),
            Method::Chebyshev => {
                let nodes = chebyshev(&x, amount);
                Box::new(move || Ok(weighted(&nodes, &x, |r, _| slope(&profile, r)) * &x))
            }
            Method::Legendre => {
                let nodes = between_angles(&*legendre()?, &x.lit(0), &x.pi().over(2));
                Box::new(move || Ok(weighted(&nodes, &x, |r, _| slope(&profile, r)) * &x))
            }
            Method::LegendrePieces => in_angles(profile, legendre()?, x, |profile, r, _, x| slope(profile, r) * x),
            Method::Regularised => in_angles(profile, legendre()?, x, |profile, r, sine, _| {
                let f = derivative(profile, r);
                (f.value + f.slope * r) * sine
            }),
            Method::Jacobi => jacobi(profile, amount, x)?,
            Method::TanhSinh => {
                let rule = DoubleExponential::new(&x, amount);
                Box::new(move || by_tanh_sinh(&profile, &x, &rule))
            }
            Method::RegularisedTanhSinh => {
                let solver = Quadrature::new(profile).with_rule(Rule::TanhSinh).with_tolerance(tolerance())?;
                Box::new(move || solver.g(&x))
            }
            Method::Automatic => {
                let solver = Quadrature::new(profile).with_tolerance(tolerance())?;
                Box::new(move || solver.g(&x))
            }
        })
    }
}

/// f and f' at r.
fn derivative<R: Special>(profile: &impl Profile<R>, r: &R) -> Dual<R> {
    profile.height(&Dual::variable(r.clone()))
}

/// f'(r).
fn slope<R: Special>(profile: &impl Profile<R>, r: &R) -> R {
    derivative(profile, r).slope
}

/// f'(r)/√(x²−r²), from x − r.
fn raw<R: Special>(profile: &impl Profile<R>, x: &R, r: &R, from_x: &R) -> R {
    slope(profile, r) / ((r.clone() + x) * from_x).sqrt()
}

/// The kinks inside x, ascending.
fn kinks<R: Special>(profile: &impl Profile<R>, x: &R) -> Vec<R> {
    profile.kinks().into_iter().filter(|kink| kink < x).collect()
}

fn midpoint<R: Special>(profile: &impl Profile<R>, x: &R, steps: usize) -> R {
    let count = i64::try_from(steps).unwrap_or(i64::MAX);
    let half = x.clone().over(2).over(count);
    let mut total = x.lit(0);
    for i in 0..count {
        let (r, from_x) = (half.clone().times(2 * i + 1), half.clone().times(2 * (count - i) - 1));
        total += &raw(profile, x, &r, &from_x);
    }
    total * half.times(2) * x
}

/// A point s = sinθ of the quarter circle with the weight of f(xs).
type Point<R> = (R, R);

fn weighted<R: Special>(nodes: &[Point<R>], x: &R, mut integrand: impl FnMut(&R, &R) -> R) -> R {
    nodes.iter().fold(x.lit(0), |total, (sine, weight)| {
        let r = x.clone() * sine;
        integrand(&r, sine) * weight + total
    })
}

/// The rule of 2N nodes of the weight 1/√(1−s²) on [−1, 1], of which N are positive.
fn chebyshev<R: Special>(like: &R, count: usize) -> Vec<Point<R>> {
    let count = i64::try_from(count).unwrap_or(i64::MAX);
    let step = like.pi().over(2).over(count);
    (0..count).map(|k| (step.clone().times(2 * k + 1).over(2).sin(), step.clone())).collect()
}

/// The points of a Gauss–Legendre rule between two angles.
fn between_angles<R: Special>(rule: &Gauss<R>, from: &R, to: &R) -> Vec<Point<R>> {
    let width = to.clone() - from;
    let point = |node: &gauss_jacobi::Node<R>| {
        let angle = width.clone() * &node.t + from;
        (angle.sin(), width.clone() * &node.weight)
    };
    rule.nodes().iter().map(point).collect()
}

/// ∫₀^{π/2} integrand dθ between the angles of the kinks. Without kinks the points are known beforehand.
fn in_angles<'a, R: Special, P: Profile<R> + 'a>(
    profile: P,
    rule: Arc<Gauss<R>>,
    x: R,
    integrand: impl Fn(&P, &R, &R, &R) -> R + 'a,
) -> Solver<'a, R> {
    let angle = |kink: R| (kink / &x).asin();
    let breaks: Vec<R> = kinks(&profile, &x).into_iter().map(angle).collect();
    let (zero, quarter) = (x.lit(0), x.pi().over(2));
    let whole = breaks.is_empty().then(|| between_angles(&rule, &zero, &quarter));
    Box::new(move || {
        let sum = |nodes: &[Point<R>]| weighted(nodes, &x, |r, sine| integrand(&profile, r, sine, &x));
        if let Some(nodes) = &whole {
            return Ok(sum(nodes));
        }
        let piece = |from: &R, to: &R| Ok(bare(sum(&between_angles(&rule, from, to))));
        Ok(pieces(&zero, &quarter, &breaks, piece)?.value)
    })
}

/// A number without an error, for the sum over pieces.
fn bare<R: Special>(value: R) -> Estimate<R> {
    Estimate { error: value.lit(0), value, evaluations: 0 }
}

/// On a piece from r₀ to r₁, with t = (r − r₀)/(r₁ − r₀), the weight is t^{p−1} at a tip of exponent p and (1−t)^{−1/2} at x.
fn jacobi<'a, R: Special, P: Profile<R> + 'a>(profile: P, count: usize, x: R) -> Result<Solver<'a, R>> {
    let breaks = kinks(&profile, &x);
    let zero = x.lit(0);
    let tip = profile.tip_exponent().map_or_else(|| zero.clone(), |p| p - zero.lit(1));
    let end = zero.ratio(-1, 2);
    let (first, last) = if breaks.is_empty() {
        let both = gauss_jacobi::rule(count, &end, &tip)?;
        (both.clone(), both)
    } else {
        (gauss_jacobi::rule(count, &zero, &tip)?, gauss_jacobi::rule(count, &end, &zero)?)
    };
    let between = if breaks.len() > 1 { gauss_jacobi::rule(count, &zero, &zero)? } else { last.clone() };
    let pick = move |from: &R, to: &R, x: &R| {
        if *from == from.lit(0) {
            first.clone()
        } else if to == x {
            last.clone()
        } else {
            between.clone()
        }
    };
    Ok(Box::new(move || {
        let piece = |from: &R, to: &R| {
            let rule = pick(from, to, &x);
            let (width, beyond) = (to.clone() - from, x.clone() - to);
            let term = |node: &gauss_jacobi::Node<R>| {
                let r = width.clone() * &node.t + from;
                let from_x = width.clone() * &node.complement + &beyond;
                let mut value = raw(&profile, &x, &r, &from_x) * &node.weight;
                if *rule.beta() != zero {
                    value /= &node.t.pow(rule.beta());
                }
                if *rule.alpha() != zero {
                    value *= &node.complement.sqrt();
                }
                value
            };
            let total = rule.nodes().iter().fold(zero.clone(), |total, node| term(node) + total);
            Ok(bare(total * width))
        };
        Ok(pieces(&zero, &x, &breaks, piece)?.value * &x)
    }))
}

/// The double exponential rule of a fixed step h on [0, 1], but for the middle.
struct DoubleExponential<R> {
    step: R,
    /// δ, the distance from the nearer end, with its weight.
    abscissae: Vec<(R, R)>,
}

impl<R: Special> DoubleExponential<R> {
    /// At t = h, 2h, … δ = 1/(1 + e^{π sinh t}), with the weight hπ cosh t δ(1−δ), until δ < 2^−(18 bits).
    fn new(like: &R, halvings: usize) -> Self {
        let step = like.lit(2).powi(-i64::try_from(halvings).unwrap_or(i64::MAX));
        let reach = like.lit(13 * i64::from(like.precision()));
        let abscissa = |k: i64| {
            let growth = step.clone().times(k).exp();
            let decay = growth.clone().inv();
            let exponent = (growth.clone() - &decay) * like.pi().over(2);
            let cosh = (growth + decay).over(2);
            let small = (-exponent.clone()).exp();
            let distance = small.clone() / (small.clone() + like.lit(1));
            let weight = like.pi() * cosh * &step * &distance / (small + like.lit(1));
            (exponent < reach).then_some((distance, weight))
        };
        let abscissae = (1..).map_while(abscissa).collect();
        DoubleExponential { step, abscissae }
    }

    /// ∫₀¹ of an integrand that knows its distances from both ends: from the middle outwards, until weight and term are
    /// both below rounding.
    fn integrate(&self, integrand: impl Fn(&R, &R) -> R) -> R {
        let half = self.step.ratio(1, 2);
        let roundoff = half.unit_roundoff();
        let mut total = integrand(&half, &half) * half.pi().over(4) * &self.step;
        for upper in [false, true] {
            for (near, weight) in &self.abscissae {
                let far = half.lit(1) - near;
                let term = if upper { integrand(&far, near) } else { integrand(near, &far) } * weight;
                total += &term;
                if *weight < roundoff && term.abs() < roundoff.clone() * total.abs() {
                    break;
                }
            }
        }
        total
    }
}

fn by_tanh_sinh<R: Special>(profile: &impl Profile<R>, x: &R, rule: &DoubleExponential<R>) -> Result<R> {
    let piece = |from: &R, to: &R| {
        let (width, beyond) = (to.clone() - from, x.clone() - to);
        let total = rule.integrate(|below, above| {
            let r = width.clone() * below + from;
            raw(profile, x, &r, &(width.clone() * above + &beyond))
        });
        Ok(bare(total * width))
    };
    Ok(pieces(&x.lit(0), x, &kinks(profile, x), piece)?.value * x)
}
