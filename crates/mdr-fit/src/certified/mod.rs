//! CertifiedFit digits of an estimate: a proof that the stationary point is unique in a box, and its digits.
//!
//! With the labels of the fit, and each row compared with a point of the same kind, G = Jᵀr is a smooth function of the fitted values.
//! Krawczyk's operator K = m − C·G(m) + (1 − C·H(B))·(B − m), with H the derivatives of G over the box B by dual numbers over intervals
//! and C near H⁻¹, maps B into its interior only if G has exactly one zero in B; the zero lies in K (Krawczyk 1969; Neumaier 1990). The
//! zero is a stationary point of the sum of squares. Where all pivots of H over the enclosure are positive, H is positive definite there, and
//! the zero is a local minimum.

use mdr_core::contact::{Error, Result};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Dual, Interval, Literal, Precision, Real};

mod linear;
mod rows;
mod sheets;

use self::linear::{inverse, midpoints, points, solve};
use self::rows::{Residual, Row};
use self::sheets::Pinned;
use super::answer::{CertifiedEstimate, CertifiedFit};
use super::contact::{Numbers, Tip};
use super::minimise::Minimum;
use super::objective::Objective;
use super::observation::Loss;
use super::problem::Kind;
use mdr::scene::Profile;

const OUT_OF_RANGE: &str = "a number is out of range";

/// The largest working precision, against that of the digits.
const ROUNDS: u32 = 4;

/// Boxes that are tried, each a hundredth of the last, and how often the operator shrinks one.
const SCALES: usize = 8;
const ROUNDS_OF_A_BOX: usize = 24;

/// A box, with the terms of the normal equations over it.
struct Normal {
    /// Jᵀr, with its derivatives.
    gradient: Vec<Interval>,
    hessian: Vec<Vec<Interval>>,
    /// JᵀJ.
    information: Vec<Vec<Interval>>,
    rss: Interval,
}

impl Normal {
    /// Adds a residual, with its derivatives along the seed.
    fn add(&mut self, row: &Residual, seed: usize) {
        let Residual { value, slopes } = row;
        for (place, slope) in slopes.iter().enumerate() {
            // The derivative of r ∂r with respect to the seed.
            self.hessian[place][seed] += &(value.slope.clone() * &slope.value + value.value.clone() * &slope.slope);
            if seed > 0 {
                continue;
            }
            self.gradient[place] += &(value.value.clone() * &slope.value);
            for (other, entry) in self.information[place].iter_mut().enumerate() {
                *entry += &(slopes[other].value.clone() * &slope.value);
            }
        }
        if seed == 0 {
            self.rss += &value.value.square();
        }
    }
}

/// A problem exactly as it is printed, with the labels of its rows.
struct Proof<'a> {
    objective: &'a Objective<'a>,
    precision: Precision,
    rows: Vec<Row>,
    /// Where the edge of the contact is pinned on each sheet of the minimum.
    pins: Vec<Option<Pinned>>,
    numbers: Vec<Interval>,
    priors: Vec<Prior>,
}

/// The prior of a free parameter, by its place.
struct Prior {
    place: usize,
    mean: Interval,
    sd: Interval,
}

/// The estimate in proved digits.
///
/// # Errors
/// A sentence that says why there are none.
pub(super) fn certified(
    objective: &Objective<'_>,
    minimum: &Minimum,
    digits: u32,
    dof: usize,
) -> std::result::Result<CertifiedFit, String> {
    let problem = objective.problem;
    possible(objective, minimum)?;
    let mut precision = 4 * digits + 96;
    for _ in 0..ROUNDS {
        let proof = Proof::new(objective, minimum, Precision::new(precision))?;
        match proof.run(minimum, digits, dof) {
            Ok(Some(found)) => return Ok(found),
            Ok(None) | Err(Error::Undecided { .. }) => precision *= 2,
            Err(error) => return Err(error.to_string()),
        }
    }
    Err(format!("{digits} digits are not decided at {precision} bits for a {}", problem.profile.name()))
}

/// Checks that the fit can be proved: least squares, closed forms.
fn possible(objective: &Objective<'_>, minimum: &Minimum) -> std::result::Result<(), String> {
    let problem = objective.problem;
    let fitted = &minimum.fitted;
    let why = if problem.loss == Loss::Huber {
        "with Huber's loss"
    } else if problem.pull_off.is_some() {
        "with the place of the pull-off as a datum"
    } else if (0..fitted.len()).any(|place| objective.at_bound(place, fitted[place])) {
        "of a number at its bound"
    } else if !problem.medium.is_half_space() {
        "on another medium than a half-space"
    } else if !matches!(problem.profile, Profile::Shape(_)) {
        "of a profile that is no shape of the library"
    } else {
        return Ok(());
    };
    Err(format!("certified digits are not given {why}"))
}

fn exact(precision: Precision, value: f64) -> Option<Interval> {
    Literal::try_from(value).ok().map(|literal| Interval::from_literal(precision, &literal))
}

impl<'a> Proof<'a> {
    /// # Errors
    /// A sentence that says which row has no proof, or that a number is out of range.
    fn new(objective: &'a Objective<'a>, minimum: &Minimum, precision: Precision) -> std::result::Result<Self, String> {
        let rows = rows::rows(objective, minimum, precision)?;
        let pins = sheets::pins(objective, minimum, precision)?;
        let number = |parameter: &super::problem::Parameter| exact(precision, parameter.value.unwrap_or(0.0));
        let numbers = objective.problem.parameters.iter().map(number).collect::<Option<_>>().ok_or(OUT_OF_RANGE)?;
        let prior = |(place, [mean, sd]): (usize, [f64; 2])| {
            Some(Prior { place, mean: exact(precision, mean)?, sd: exact(precision, sd)? })
        };
        let priors = objective.priors().map(prior).collect::<Option<_>>().ok_or(OUT_OF_RANGE)?;
        Ok(Proof { objective, precision, rows, pins, numbers, priors })
    }

    /// All numbers at fitted values of which one is seeded.
    fn numbers(&self, fitted: &[Interval], seed: usize) -> Numbers<Dual<Interval>> {
        let value = |index: usize| match self.objective.free.iter().position(|free| *free == index) {
            None => Dual::constant(self.numbers[index].clone()),
            Some(place) => {
                let fitted = fitted[place].clone();
                let fitted = if place == seed { Dual::variable(fitted) } else { Dual::constant(fitted) };
                let parameter = self.objective.parameter(place);
                match parameter.kind.is_offset() {
                    true => fitted,
                    false if parameter.is_negative() => -fitted.exp(),
                    false => fitted.exp(),
                }
            }
        };
        Numbers::of(self.objective.problem, value, || Dual::constant(Interval::from_int(self.precision, 0)))
    }

    /// (value − mean)/sd.
    fn prior_residual(&self, prior: &Prior, numbers: &Numbers<Dual<Interval>>) -> Residual {
        let zero = || Dual::constant(prior.sd.lit(0));
        let value = numbers.get(self.objective.kind(prior.place)).cloned().unwrap_or_else(zero);
        let slope = if self.objective.is_offset(prior.place) { value.lit(1) } else { value.clone() };
        let sd = Dual::constant(prior.sd.clone());
        let mut slopes: Vec<_> = (0..self.objective.free.len()).map(|_| zero()).collect();
        slopes[prior.place] = slope / &sd;
        Residual { value: (value - Dual::constant(prior.mean.clone())) / &sd, slopes }
    }

    /// The normal equations over a box.
    fn normal(&self, fitted: &[Interval]) -> Result<Normal> {
        let (problem, count) = (self.objective.problem, fitted.len());
        let zero = || Interval::from_int(self.precision, 0);
        let mut normal = Normal {
            gradient: vec![zero(); count],
            hessian: vec![vec![zero(); count]; count],
            information: vec![vec![zero(); count]; count],
            rss: zero(),
        };
        for seed in 0..count {
            let numbers = self.numbers(fitted, seed);
            let free = self.objective.free_of_profile();
            let tip = Tip::new(problem, self.precision, &numbers.profile, &free)?;
            let kinds: Vec<Kind> = (0..count).map(|place| self.objective.kind(place)).collect();
            let contacts = sheets::contacts(&tip, &numbers, problem.observation, &self.pins, &kinds)?;
            for row in &self.rows {
                row.residuals(&contacts, &kinds)?.iter().for_each(|residual| normal.add(residual, seed));
            }
            for prior in &self.priors {
                normal.add(&self.prior_residual(prior, &numbers), seed);
            }
        }
        Ok(normal)
    }

    /// Refines the estimate, proves a box around it and reads its digits; `None` where they are not decided.
    fn run(&self, minimum: &Minimum, digits: u32, dof: usize) -> Result<Option<CertifiedFit>> {
        let mut middle: Vec<Interval> =
            minimum.fitted.iter().map(|value| Interval::from_f64(self.precision, *value)).collect();
        for _ in 0..12 {
            let normal = self.normal(&middle)?;
            let Some(step) = solve(midpoints(&normal.hessian), vec![points(&normal.gradient)]) else { return Ok(None) };
            for (value, step) in middle.iter_mut().zip(&step[0]) {
                *value = Interval::point((value.clone() - step).mid());
            }
            let size = step[0].iter().map(|step| step.abs().approx()).fold(0.0, f64::max);
            if size < 1e-60 || size < 2f64.powi(40 - self.precision.bits().min(1000) as i32) {
                break;
            }
        }
        let lengths: Vec<f64> = minimum.jacobian.column_iter().map(|column| column.norm()).collect();
        let boxes = Boxes::around(self, middle)?;
        // In a smaller box within one in which the zero is unique it is the same zero, and its enclosure shrinks faster.
        let mut stated: Option<Vec<f64>> = None;
        let mut scale = 1e-2;
        for _ in 0..SCALES {
            let reach: Vec<f64> = lengths.iter().map(|length| scale / length).collect();
            if let Some(proved) = boxes.as_ref().and_then(|boxes| boxes.contract(reach.clone())) {
                let within = stated.get_or_insert(reach);
                if let Some(certified) = self.read(&proved, within, digits, dof)? {
                    return Ok(Some(certified));
                }
            }
            scale *= 1e-2;
        }
        Ok(None)
    }

    /// The digits of the numbers, of their standard errors scaled by the residuals, and of the sum of squares.
    fn read(&self, fitted: &[Interval], reach: &[f64], digits: u32, dof: usize) -> Result<Option<CertifiedFit>> {
        let normal = self.normal(fitted)?;
        let count = fitted.len();
        let Some(covariance) = inverse(normal.information) else { return Ok(None) };
        let variance = normal.rss.clone().over(dof.max(1) as i64);
        let text = |value: Interval| Enclosure::from(value).round(digits);
        let numbers = self.numbers(fitted, usize::MAX);
        let mut parameters = Vec::with_capacity(count);
        for (place, reach) in reach.iter().enumerate() {
            let parameter = self.objective.parameter(place);
            let value = numbers.get(parameter.kind).map_or(&fitted[place], |number| &number.value);
            let factor = if parameter.kind.is_offset() { value.lit(1) } else { value.abs() };
            let error = (covariance[place][place].clone() * &variance).sqrt() * &factor;
            let (Some(value), Some(scaled_stderr)) = (text(value.clone()), text(error)) else { return Ok(None) };
            let name = parameter.name.clone();
            parameters.push(CertifiedEstimate { name, value, scaled_stderr, unique_within: reach * factor.approx() });
        }
        let local_minimum = linear::is_positive_definite(normal.hessian);
        Ok(text(normal.rss).map(|rss| CertifiedFit { digits, parameters, local_minimum, rss }))
    }
}

/// Krawczyk's operator around a point.
struct Boxes<'a> {
    proof: &'a Proof<'a>,
    middle: Vec<Interval>,
    /// G there.
    gradient: Vec<Interval>,
    /// Near the inverse of H there, by columns.
    inverse: Vec<Vec<Interval>>,
}

impl<'a> Boxes<'a> {
    /// `None` if H is nearly singular.
    fn around(proof: &'a Proof<'a>, middle: Vec<Interval>) -> Result<Option<Self>> {
        let Normal { gradient, hessian, .. } = proof.normal(&middle)?;
        Ok(inverse(midpoints(&hessian)).map(|inverse| Boxes { proof, middle, gradient, inverse }))
    }

    /// The enclosure of the zero in a box of these half widths that the operator maps into its interior; `None` for another box.
    fn contract(&self, mut reach: Vec<f64>) -> Option<Vec<Interval>> {
        let mut found = None;
        for _ in 0..ROUNDS_OF_A_BOX {
            let Some(images) = self.image(&reach) else { break };
            let next: Vec<f64> = images
                .iter()
                .zip(&self.middle)
                .map(|(image, middle)| (image.clone() - middle).abs().upper().to_f64() * 2.0)
                .collect();
            let shrinks = next.iter().zip(&reach).any(|(next, reach)| *next < 0.7 * reach);
            (found, reach) = (Some(images), next);
            if !shrinks {
                break;
            }
        }
        found
    }

    /// K over the box of these half widths, where it is in its interior.
    fn image(&self, reach: &[f64]) -> Option<Vec<Interval>> {
        let Boxes { proof, middle, gradient, inverse } = self;
        let zone: Vec<Interval> = middle
            .iter()
            .zip(reach)
            .map(|(value, reach)| value.clone().inflate(&Interval::from_f64(proof.precision, *reach)))
            .collect();
        krawczyk([middle, gradient, &zone], inverse, &proof.normal(&zone).ok()?)
    }
}

/// K over a zone around the middle, from the gradient in the middle, near the inverse of H there and the normal equations over
/// the zone; `None` unless it is in the interior of the zone.
fn krawczyk(
    [middle, gradient, zone]: [&[Interval]; 3],
    inverse: &[Vec<Interval>],
    over: &Normal,
) -> Option<Vec<Interval>> {
    let count = middle.len();
    let times = |vector: &dyn Fn(usize) -> Interval, row: usize| {
        (0..count).fold(middle[0].lit(0), |sum, place| sum + inverse[place][row].clone() * &vector(place))
    };
    let image = |row: usize| {
        let shift = times(&|place| gradient[place].clone(), row);
        let spread = (0..count).fold(middle[0].lit(0), |sum, column| {
            let entry = times(&|place| over.hessian[place][column].clone(), row);
            sum + (middle[0].lit(i64::from(row == column)) - entry) * &(zone[column].clone() - &middle[column])
        });
        middle[row].clone() - shift + spread
    };
    let images: Vec<Interval> = (0..count).map(image).collect();
    let inside =
        images.iter().zip(zone).all(|(image, zone)| image.lower() > zone.lower() && image.upper() < zone.upper());
    inside.then_some(images)
}

#[cfg(test)]
#[path = "../../tests/private/certified.rs"]
mod tests;
