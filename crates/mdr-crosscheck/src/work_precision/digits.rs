//! Time against digits, from 16 to 1000: κ_n, a critical state, and the transform by quadrature.
//!
//! A method is asked for D digits and works with ⌈D log₂10⌉ + 16 bits, or prints D + 1 decimals. What it reaches is
//! compared as everywhere.

use mdr_analytic::certified::{self, Elasticity};
use mdr_analytic::{PowerLaw, PowerLawContact, kappa, kappa_enclosure};
use mdr_core::contact::{Control, Material, Result, Shape, Transform};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Interval, Literal, Precision, Real};
use mdr_numeric::transform::{Quadrature, Rule};
use rug::{Float, Rational};

use super::kappa::by_gamma;
use super::outcome::Answer;
use super::{Clock, Comparison, Measurement, Series, Task, transform};
use crate::Level;
use crate::checks::{by_series, literal};
use crate::subject::closed::numbers;

/// The task.
pub(super) const TASK: Task = Task {
    name: "digits",
    title: "Time against digits, from 16 to 1000: κ_n, a critical state, and the transform by quadrature",
    comparisons,
};

/// The exponent of the rational questions.
const N: (u32, u32) = (3, 10);

/// C, E* in Pa and w in J/m² of the critical state.
fn scales() -> Result<[Literal; 3]> {
    let [c, e, w] = ["1.5", "1e6", "0.05"].map(literal);
    Ok([c?, e?, w?])
}

/// Where the transform of r^(1/4) is asked for.
const X: f64 = 0.7;

/// N nodes of Gauss–Jacobi leave (3 + √8)^−2N of a power law.
const NODES_A_DIGIT: f64 = 0.655;

/// The digits that are asked for.
fn ladder(level: Level) -> &'static [u32] {
    if level == Level::Quick { &[16, 50, 200] } else { &[16, 30, 50, 100, 200, 500, 1000] }
}

/// The precision in which a method works for so many digits.
fn working(digits: u32) -> Precision {
    Precision::new(Precision::from_digits(digits).bits() + 16)
}

fn comparisons(level: Level, clock: Clock) -> Result<Vec<Comparison>> {
    let asked = Asked { digits: ladder(level), clock };
    Ok(vec![asked.kappa()?, asked.critical()?, asked.transform()?])
}

/// How much is asked.
struct Asked {
    digits: &'static [u32],
    clock: Clock,
}

impl Asked {
    /// The precision of enclosures that can judge all answers.
    fn enough(&self) -> Precision {
        Precision::new(working(self.digits.iter().copied().max().unwrap_or(16)).bits() + 128)
    }

    /// The answers of one method, which prepares for a number of digits before the clock starts.
    fn points<T: Answer, S: Fn() -> Result<T>>(
        &self,
        truths: &[Interval],
        prepare: impl Fn(u32) -> Result<S>,
    ) -> Result<Vec<Measurement>> {
        let point =
            |&digits: &u32| Ok(Measurement::measure(format!("{digits} digits"), self.clock, truths, prepare(digits)?));
        self.digits.iter().map(point).collect()
    }

    fn kappa(&self) -> Result<Comparison> {
        let n = literal(&format!("{}/{}", N.0, N.1))?;
        let truths = [by_series(&Interval::from_rational(self.enough(), &Rational::from(N)))];
        let enclosed = |digits| Ok(move || Ok(kappa_enclosure(working(digits), &Rational::from(N))));
        let decimals = |digits| {
            let n = &n;
            Ok(move || certified::kappa(n, digits + 1))
        };
        let with = |kappa: fn(&Float) -> Result<Float>| {
            move |digits| {
                let n = Float::with_val(working(digits).bits(), Rational::from(N));
                Ok(move || kappa(&n))
            }
        };
        let series = vec![
            Series::ours("certified, as an enclosure", self.points(&truths, enclosed)?),
            Series::ours("certified, in decimals", self.points(&truths, decimals)?),
            Series::ours("arbitrary precision", self.points(&truths, with(kappa))?),
            Series::textbook("quotient of Γ, MPFR", self.points(&truths, with(|n| Ok(by_gamma(n))))?),
        ];
        Ok(Comparison::of_digits("kappa", format!("κ_n at n = {}/{}", N.0, N.1), SERIES, series))
    }

    fn critical(&self) -> Result<Comparison> {
        let truths = critical(self.enough())?;
        let (scales, n) = (scales()?, literal(&format!("{}/{}", N.0, N.1))?);
        let [c, e, w] = &scales;
        let elasticity = Elasticity::Effective(e.clone());
        // Each answer has a question of its own, whose time counts.
        let question = || certified::Question::new(&n, c, &elasticity, w, &Control::Indentation);
        let enclosed = |digits| {
            let question = &question;
            Ok(move || {
                let precision = working(digits);
                let found = question()?.enclosures(precision)?;
                Ok(found.map(|number| interval(number, precision)).to_vec())
            })
        };
        let decimals = |digits| {
            let question = &question;
            Ok(move || Ok(numbers(question()?.answer(digits + 1)?).map(|(.., number)| number).collect::<Vec<_>>()))
        };
        let with = |kappa: fn(&Float) -> Result<Float>| {
            let scales = &scales;
            move |digits| {
                let float = |value: Rational| Float::with_val(working(digits).bits(), value);
                let scales = scales.each_ref().map(|value| float(value.to_rational()));
                let n = float(Rational::from(N));
                Ok(move || state(n.clone(), kappa(&n)?, scales.clone()))
            }
        };
        let series = vec![
            Series::ours("certified, as an enclosure", self.points(&truths, enclosed)?),
            Series::ours("certified, in decimals", self.points(&truths, decimals)?),
            Series::ours("arbitrary precision", self.points(&truths, with(kappa))?),
            Series::textbook("quotient of Γ, MPFR", self.points(&truths, with(|n| Ok(by_gamma(n))))?),
        ];
        let title = format!("κ, a, d and F under fixed grips at n = {}/{}, the worst of the four", N.0, N.1);
        Ok(Comparison::of_digits("critical", title, TANGENCY, series))
    }

    fn transform(&self) -> Result<Comparison> {
        let [n, x] = [0.25, X].map(|value| Interval::from_f64(self.enough(), value));
        let truths = [transform::power(&n, &x)];
        let by = |rule: fn(u32) -> Rule| {
            let prepare = |digits: u32| {
                let float = |value: f64| Float::with_val(working(digits).bits(), value);
                let solver = Quadrature::of([Shape::Power { n: float(0.25), c: float(1.0) }])?.with_rule(rule(digits));
                let solver = solver.with_tolerance(float(10.0).powi(-i64::from(digits)))?;
                let x = float(X);
                Ok(move || solver.g(&x))
            };
            self.points(&truths, prepare)
        };
        let gauss = |digits: u32| Rule::Gauss { nodes: (f64::from(digits) * NODES_A_DIGIT) as usize + 3 };
        let series = vec![
            Series::ours("quadrature, automatic rule", by(|_| Rule::Automatic)?),
            Series::ours("quadrature, Gauss–Jacobi", by(gauss)?),
            Series::ours("quadrature, tanh-sinh", by(|_| Rule::TanhSinh)?),
        ];
        Ok(Comparison::of_digits("transform", format!("g({X}) of f = r^(1/4), by quadrature"), CLOSED_FORM, series))
    }
}

impl Comparison {
    /// Digits are what is asked for.
    fn of_digits(name: &str, title: String, truth: &'static str, series: Vec<Series>) -> Self {
        Comparison { id: format!("digits-{name}"), title, truth, attainable: None, series }
    }
}

const SERIES: &str = "the hypergeometric series of positive terms over intervals; the methods have another series or Γ";
const TANGENCY: &str =
    "the tangency in logarithms, then (1.13) and (1.16), over intervals; the methods have (1.15) and (1.17)";
const CLOSED_FORM: &str =
    "κ_n xⁿ (1.12) over intervals, with the Γ of MPFR; every method integrates heights, with nodes that are kept";

/// Numbers of this size have a value or are exact; nothing is known of a logarithm.
fn interval(number: Enclosure, precision: Precision) -> Interval {
    match number {
        Enclosure::Value(value) => value,
        Enclosure::Exact(value) => Interval::from_rational(precision, &value),
        Enclosure::Log { .. } => Interval::entire(precision),
    }
}

/// κ, a, d, F of a contact in plain arbitrary precision.
fn state(n: Float, kappa: Float, [c, e, w]: [Float; 3]) -> Result<Vec<Float>> {
    let contact = PowerLawContact::new(PowerLaw::with_kappa(n, c, kappa.clone())?, Material::new(e, w)?);
    let critical = contact.critical(&Control::Indentation)?;
    Ok(vec![kappa, critical.contact_radius, critical.indentation, critical.force])
}

/// κ, a, d, F at the fold under fixed grips: a from the tangency (1.14) in logarithms, d and F from (1.13) and (1.16) there.
fn critical(precision: Precision) -> Result<Vec<Interval>> {
    let n = Interval::from_rational(precision, &Rational::from(N));
    let kappa = by_series(&n);
    let [c, e, w] = scales()?.map(|value| Interval::from_literal(precision, &value));
    // ln g' = ln Δl' is (n − 1/2) ln a = ½ ln(πw/2E*) − ln(nκC).
    let tension = (w.pi() * &w / &e).over(2).ln().over(2);
    let stiffness = n.ln() + kappa.ln() + c.ln();
    let ln_a = (tension - stiffness) / (n.clone() - n.ratio(1, 2));
    let a = ln_a.exp();
    let g = (ln_a * &n).exp() * &c * &kappa;
    let elongation = (a.pi().times(2) * &a * &w / &e).sqrt();
    let d = g.clone() - &elongation;
    let f = (g * &n / (n.lit(1) + &n) - elongation) * &a * &e.times(2);
    Ok(vec![kappa, a, d, f])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The series against the Γ of MPFR, and the tangency against certified decimals.
    #[test]
    fn the_exact_results_agree_with_another_route() {
        let precision = Precision::new(1000);
        for n in [0.3, 1.75] {
            let n = Interval::from_f64(precision, n);
            let found = by_series(&n);
            assert!(found.overlaps(&by_gamma(&n)) && found.accuracy_bits() > 980);
        }
        let asked = Asked { digits: &[50], clock: Clock::Off };
        let comparison = asked.critical().unwrap();
        assert!(critical(precision).unwrap().iter().all(|number| number.accuracy_bits() > 900));
        assert!(comparison.series.iter().all(|series| series.points[0].outcome.digits().unwrap() >= 50.0));
    }
}
