//! The MDR transform (1.1) from heights, at one radius: textbook quadratures of the form with the singularity 1/√(x²−r²)
//! beside those of `mdr_numeric`. No method uses a closed form.
//!
//! | method | of | converges for f ∝ rⁿ as |
//! |---|---|---|
//! | springs, midpoint sum | x∫₀ˣ f'(r)/√(x²−r²) dr | N^−min(n, 1/2) |
//! | Gauss–Chebyshev, the midpoint rule in θ | x∫₀^{π/2} f'(x sinθ) dθ | N^−n; geometrically for odd n |
//! | Gauss–Legendre in θ | the same | N^−2n; geometrically for integer n |
//! | Gauss–Jacobi | ∫₀^{π/2} sinθ (f + r f') dθ | geometrically |
//! | tanh-sinh | the same | exp(−cN/ln N) |
//!
//! Nodes and weights are made before the clock starts.

use std::f64::consts::FRAC_PI_2;
use std::hint::black_box;

use mdr_analytic::profiles::closed_form;
use mdr_core::calculus::gauss_jacobi;
use mdr_core::contact::{Profile, Result, Shape};
use mdr_core::number::{Dual, Interval, Precision, Real};
use mdr_numeric::profiles::Heights;
use mdr_numeric::transform::{Quadrature, Rule};

use super::{Accuracy, Clock, Comparison, Measurement, Series, Task, kappa};
use crate::Level;
use crate::subject::profiles::terms;

/// The task.
pub(super) const TASK: Task = Task {
    name: "transform",
    title: "The transform g(x) (1.1) from heights in double precision: blunt and sharp tips, an edge, a kink, waves",
    comparisons,
};

/// Bits of the enclosures.
const BITS: u32 = 256;

fn comparisons(level: Level, clock: Clock) -> Result<Vec<Comparison>> {
    let question =
        |name: &str, words: &str, x, shape| Question { name: name.to_owned(), words: words.to_owned(), x, shape };
    let powers = [0.05, 0.25, 0.5, 1.0, 2.0, 3.7, 20.0];
    let mut all: Vec<_> = powers.into_iter().map(Question::power).collect();
    let mut punch = terms("rounded-punch", |key| if key == "flat" { 0.3 } else { 1.0 });
    all.extend([
        question("sphere", "the sphere of radius 1", 0.6, Shape::Sphere { radius: 1.0 }),
        question("rounded-punch", "f = (r − 0.3)²/2, flat up to r = 0.3", 0.7, punch.remove(0)),
        question(
            "wavy",
            "the wavy paraboloid of figure 4",
            0.73,
            Shape::WavyParaboloid { radius: 1.0, amplitude: 5e-4, wavelength: 0.1 },
        ),
    ]);
    all.iter().map(|question| question.comparison(level, clock)).collect()
}

/// g and g' by closed forms over intervals, of power laws with the Γ of MPFR (1.12).
pub(super) fn enclosed(shape: &Shape<f64>, x: &Interval) -> Result<[Interval; 2]> {
    let exact = |value: &f64| Interval::from_f64(x.ctx(), *value);
    if let Shape::Power { n, c } = shape {
        let (n, g) = (exact(n), power(&exact(n), x) * exact(c));
        return Ok([g.clone(), g * n / x]);
    }
    let profile = closed_form(shape.map(|_, value| exact(value)))?;
    Ok([profile.g(x)?, profile.slope(x)?])
}

/// g of f = rⁿ, (1.12), with the Γ of MPFR.
pub(super) fn power(n: &Interval, x: &Interval) -> Interval {
    kappa::by_gamma(n) * x.pow(n)
}

/// A question: g(x).
struct Question {
    name: String,
    words: String,
    x: f64,
    shape: Shape<f64>,
}

impl Question {
    /// f = rⁿ.
    fn power(n: f64) -> Self {
        Question { name: format!("power-{n}"), words: format!("f = r^{n}"), x: 0.7, shape: Shape::Power { n, c: 1.0 } }
    }

    /// |x g'/g|.
    fn condition(&self) -> Result<f64> {
        if let Shape::Power { n, .. } = self.shape {
            return Ok(n);
        }
        let (closed, x) = (closed_form(self.shape.clone())?, self.x);
        Ok((x * closed.slope(&x)? / closed.g(&x)?).abs())
    }

    fn comparison(&self, level: Level, clock: Clock) -> Result<Comparison> {
        let (x, quick) = (self.x, level == Level::Quick);
        let [truth, _] = enclosed(&self.shape, &Interval::from_f64(Precision::new(BITS), x))?;
        let profile = Heights::new([self.shape.clone()])?;
        let slope = |r: f64| profile.height(&Dual::variable(r)).slope;
        let point = |setting: String, method: &dyn Fn(f64) -> Result<(f64, u64)>| {
            Measurement::measure(setting, clock, std::slice::from_ref(&truth), || method(black_box(x)))
        };
        let steps: &[u64] = if quick { &[16, 256, 4096] } else { &[16, 64, 256, 1024, 4096, 16_384, 65_536, 262_144] };
        let springs = steps.iter().map(|&n| point(format!("{n} steps"), &|x| Ok((midpoint(slope, x, n), n))));
        let nodes: &[u64] = if quick { &[4, 16, 64, 256] } else { &[2, 4, 8, 16, 32, 64, 128, 256, 512, 1024] };
        let in_angle = |rule: fn(u64) -> Result<Vec<[f64; 2]>>| -> Result<Vec<Measurement>> {
            let at = |&n: &u64| {
                let rule = rule(n)?;
                let sum = |x: f64| x * rule.iter().map(|[sine, weight]| weight * slope(x * sine)).sum::<f64>();
                Ok(point(format!("{n} nodes"), &|x| Ok((sum(x), n))))
            };
            nodes.iter().map(at).collect()
        };
        let solved = |setting: String, solver: &Quadrature<f64, Heights<f64>>| {
            point(setting, &|x| solver.g_estimate(&x).map(|found| (found.value, found.evaluations as u64)))
        };
        let gauss: &[usize] = if quick { &[4, 12, 64] } else { &[2, 4, 6, 8, 10, 12, 16, 24, 32, 48, 64, 96] };
        let jacobi = |&nodes: &usize| {
            let solver = Quadrature::new(profile.clone()).with_rule(Rule::Gauss { nodes });
            solved(format!("{nodes} nodes"), &solver)
        };
        let to_tolerance = |rule: Rule| -> Result<Vec<Measurement>> {
            let mut points: Vec<Measurement> = Vec::new();
            for digits in (2..=16).step_by(2) {
                let solver = Quadrature::new(profile.clone()).with_rule(rule);
                let solver = solver.with_tolerance(10_f64.powi(-digits))?;
                let point = solved(format!("tolerance 1e-{digits}"), &solver);
                // A looser tolerance may have been met by the same evaluations.
                if points.last().is_none_or(|last| last.evaluations != point.evaluations) {
                    points.push(point);
                }
            }
            Ok(points)
        };
        let series = vec![
            Series::ours("quadrature, automatic rule", to_tolerance(Rule::Automatic)?),
            Series::ours("quadrature, Gauss–Jacobi", gauss.iter().map(jacobi).collect()),
            Series::ours("quadrature, tanh-sinh", to_tolerance(Rule::TanhSinh)?),
            Series::textbook("springs, midpoint sum", springs.collect()),
            Series::textbook("Gauss–Chebyshev", in_angle(chebyshev)?),
            Series::textbook("Gauss–Legendre in θ", in_angle(legendre)?),
        ];
        Ok(Comparison {
            id: format!("transform-{}", self.name),
            title: format!("g({x}) of {}", self.words),
            truth: "the closed form of g over intervals, of power laws with the Γ of MPFR; every method integrates heights",
            attainable: Some(Accuracy::attainable(self.condition()?)),
            series,
        })
    }
}

/// The sum over equal steps of r, taken at their middles: the profile handed to a row of springs, literally.
fn midpoint(slope: impl Fn(f64) -> f64, x: f64, steps: u64) -> f64 {
    let half = x / 2.0 / steps as f64;
    let term = |i: u64| {
        let (r, from_x) = (half * (2 * i + 1) as f64, half * (2 * (steps - i) - 1) as f64);
        slope(r) / ((r + x) * from_x).sqrt()
    };
    (0..steps).map(term).sum::<f64>() * 2.0 * half * x
}

/// sinθ and weights of the rule of 2N nodes for the weight 1/√(1−s²) on [−1, 1], of which N are positive.
fn chebyshev(count: u64) -> Result<Vec<[f64; 2]>> {
    let step = FRAC_PI_2 / count as f64;
    Ok((0..count).map(|k| [((k as f64 + 0.5) * step).sin(), step]).collect())
}

/// sinθ and weights of the Gauss–Legendre rule of [0, π/2].
fn legendre(count: u64) -> Result<Vec<[f64; 2]>> {
    let rule = gauss_jacobi::rule(usize::try_from(count).unwrap_or(usize::MAX), &0.0, &0.0)?;
    Ok(rule.nodes().iter().map(|node| [(FRAC_PI_2 * node.t).sin(), FRAC_PI_2 * node.weight]).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// f = r² has f' = 2r: one node, by hand.
    #[test]
    fn one_node_of_each_rule() {
        let (x, slope) = (0.7_f64, |r: f64| 2.0 * r);
        let near = |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 1e-14, "{found}, {expected}");
        near(midpoint(slope, x, 1), x * x / 0.75_f64.sqrt());
        for rule in [chebyshev(1).unwrap(), legendre(1).unwrap()] {
            let [[sine, weight]] = rule[..] else { panic!("{rule:?}") };
            near(x * weight * slope(x * sine), FRAC_PI_2 * 2.0 * x * x * 0.5_f64.sqrt());
        }
    }

    /// A term rⁿ⁻¹ at the tip leaves N^−min(n, 1/2), N^−n and N^−2n of the three rules.
    #[test]
    fn textbook_rules_converge_as_their_theory_says() {
        for n in [0.25, 0.5] {
            let found = Question::power(n).comparison(Level::Full, Clock::Off).unwrap();
            for (method, order) in [(3, n), (4, n), (5, 2.0 * n)] {
                let points = &found.series[method].points;
                let [.., before, last] = &points[..] else { panic!("{points:?}") };
                let grown = (last.evaluations.unwrap() as f64 / before.evaluations.unwrap() as f64).log10();
                let rate = (last.outcome.digits().unwrap() - before.outcome.digits().unwrap()) / grown;
                assert!((rate - order).abs() < 0.1, "n = {n}, {}: {rate}, not {order}", found.series[method].method);
            }
        }
    }
}
