//! Certified digits of an estimate: a proof that the stationary point is unique in a box, and its digits.
//!
//! With the labels of the fit, G = Jᵀr is a smooth function of the fitted values. Krawczyk's operator
//! K = m − C·G(m) + (1 − C·H(B))·(B − m), with H the derivatives of G over the box B by dual numbers over intervals and C near H⁻¹,
//! maps B into its interior only if G has exactly one zero in B; the zero lies in K (Krawczyk 1969; Neumaier 1990).

use mdr_core::contact::{Error, Quantity, Result};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Dual, Interval, Literal, Precision, Real};
use rug::Float;

use super::answer::{Certified, CertifiedEstimate};
use super::contact::{Contact, Numbers, Tip};
use super::minimise::Minimum;
use super::objective::Objective;
use super::observation::Loss;
use super::problem::{Kind, Problem};
use crate::scene::Profile;

/// The largest working precision, against that of the digits.
const ROUNDS: u32 = 4;

/// A box, with what the normal equations are over it.
struct Normal {
    /// Jᵀr, with its derivatives.
    gradient: Vec<Interval>,
    hessian: Vec<Vec<Interval>>,
    /// JᵀJ.
    information: Vec<Vec<Interval>>,
    rss: Interval,
}

/// The rows of a problem, exactly as they are printed, and what is fitted to them.
struct Proof<'a> {
    problem: &'a Problem,
    free: &'a [usize],
    precision: Precision,
    /// X, Y and 1/σ of each row, and the contact radius where it is in contact.
    rows: Vec<(Interval, Interval, Interval, Option<f64>)>,
    numbers: Vec<Interval>,
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
) -> std::result::Result<Certified, String> {
    let problem = objective.problem;
    possible(objective, minimum)?;
    let mut precision = 4 * digits + 96;
    for _ in 0..ROUNDS {
        let proof = Proof::new(objective, minimum, Precision::new(precision)).ok_or("a number is out of range")?;
        match proof.run(minimum, digits, dof) {
            Ok(Some(found)) => return Ok(found),
            Ok(None) | Err(Error::Undecided { .. }) => precision *= 2,
            Err(error) => return Err(error.to_string()),
        }
    }
    Err(format!("{digits} digits are not decided at {precision} bits for a {}", problem.profile.name()))
}

/// What has a proof: vertical distances, least squares, closed forms.
fn possible(objective: &Objective<'_>, minimum: &Minimum) -> std::result::Result<(), String> {
    let problem = objective.problem;
    let why = if objective.x_scale.is_some() {
        "of orthogonal distances"
    } else if problem.loss == Loss::Huber {
        "with Huber's loss"
    } else if problem.parameters.iter().any(|parameter| parameter.prior.is_some()) || problem.pull_off.is_some() {
        "with priors or events"
    } else if !matches!(problem.profile, Profile::Shape(_)) {
        "of a profile that is no shape of the library"
    } else if minimum.evaluation.feet.iter().flatten().any(|foot| foot.is_end) {
        "with rows beyond the end of an arc"
    } else {
        return Ok(());
    };
    Err(format!("certified digits are not given {why}"))
}

fn exact(precision: Precision, value: f64) -> Option<Interval> {
    Literal::try_from(value).ok().map(|literal| Interval::from_literal(precision, &literal))
}

impl<'a> Proof<'a> {
    fn new(objective: &'a Objective<'_>, minimum: &Minimum, precision: Precision) -> Option<Self> {
        let problem = objective.problem;
        let row = |(row, foot): (&super::problem::DataRow, &Option<super::arcs::Foot>)| {
            let weight = row.sigma[1].map_or(Some(Interval::from_int(precision, 1)), |sigma| {
                Some(exact(precision, sigma)?.lit(1) / exact(precision, sigma)?)
            });
            Some((exact(precision, row.x)?, exact(precision, row.y)?, weight?, foot.map(|foot| foot.s)))
        };
        let rows = objective.rows.iter().zip(&minimum.evaluation.feet).map(row).collect::<Option<_>>()?;
        let number = |parameter: &super::problem::Parameter| exact(precision, parameter.value.unwrap_or(0.0));
        let numbers = problem.parameters.iter().map(number).collect::<Option<_>>()?;
        Some(Proof { problem, free: &objective.free, precision, rows, numbers })
    }

    /// All numbers at fitted values of which one is seeded.
    fn numbers(&self, fitted: &[Interval], seed: usize) -> Numbers<Dual<Interval>> {
        let value = |index: usize| match self.free.iter().position(|free| *free == index) {
            None => Dual::constant(self.numbers[index].clone()),
            Some(place) => {
                let fitted = fitted[place].clone();
                let fitted = if place == seed { Dual::variable(fitted) } else { Dual::constant(fitted) };
                let parameter = &self.problem.parameters[index];
                let negative = parameter.start.or(parameter.value).is_some_and(|value| value < 0.0);
                match parameter.kind.is_offset() {
                    true => fitted,
                    false if negative => -fitted.exp(),
                    false => fitted.exp(),
                }
            }
        };
        Numbers::of(self.problem, value, || Dual::constant(Interval::from_int(self.precision, 0)))
    }

    fn kind(&self, place: usize) -> Kind {
        self.problem.parameters[self.free[place]].kind
    }

    /// The normal equations over a box.
    fn normal(&self, fitted: &[Interval]) -> Result<Normal> {
        let count = fitted.len();
        let zero = || Interval::from_int(self.precision, 0);
        let mut normal = Normal {
            gradient: vec![zero(); count],
            hessian: vec![vec![zero(); count]; count],
            information: vec![vec![zero(); count]; count],
            rss: zero(),
        };
        for seed in 0..count {
            let numbers = self.numbers(fitted, seed);
            let free: Vec<usize> = (0..count)
                .filter_map(|place| if let Kind::Profile(index) = self.kind(place) { Some(index) } else { None })
                .collect();
            let tip = Tip::new(&self.problem.profile, self.precision, &numbers.profile, &free)?;
            let contact = Contact::new(&tip, numbers, self.problem.observation);
            for (x, y, weight, radius) in &self.rows {
                let (residual, slopes) = self.row(&contact, x, y, *radius)?;
                let weight = weight.square();
                for (place, slope) in slopes.iter().enumerate() {
                    // The derivative of r ∂r with respect to the seed.
                    let derivative = residual.slope.clone() * &slope.value + residual.value.clone() * &slope.slope;
                    normal.hessian[place][seed] += &(derivative * &weight);
                    if seed == 0 {
                        normal.gradient[place] += &(residual.value.clone() * &slope.value * &weight);
                        for (other, entry) in normal.information[place].iter_mut().enumerate() {
                            *entry += &(slopes[other].value.clone() * &slope.value * &weight);
                        }
                    }
                }
                if seed == 0 {
                    normal.rss += &(residual.value.square() * weight);
                }
            }
        }
        Ok(normal)
    }

    /// The residual of a row and its derivatives with respect to the fitted values, each with its derivative along the seed.
    fn row(
        &self,
        contact: &Contact<'_, Dual<Interval>>,
        x: &Interval,
        y: &Interval,
        radius: Option<f64>,
    ) -> Result<(Dual<Interval>, Vec<Dual<Interval>>)> {
        let count = self.free.len();
        let Some(radius) = radius else {
            let one = |place| if self.kind(place) == Kind::Baseline { 1 } else { 0 };
            let slopes = (0..count).map(|place| Dual::constant(y.lit(one(place)))).collect();
            return Ok((contact.numbers.baseline.clone() - Dual::constant(y.clone()), slopes));
        };
        let radius = self.radius(contact, x, radius)?;
        let point = contact.point(&radius)?;
        let [x_slope, y_slope] = &point.tangent;
        let steepness = y_slope.clone() / x_slope;
        let slope = |place: usize| {
            let [x, y] = contact.partial(self.kind(place), &point)?;
            Ok(y - steepness.clone() * &x)
        };
        let slopes = (0..count).map(slope).collect::<Result<_>>()?;
        Ok((point.at[1].clone() - Dual::constant(y.clone()), slopes))
    }

    /// The radius where X is `x`, over the whole box, by the interval Newton method; with its derivative along the seed.
    fn radius(&self, contact: &Contact<'_, Dual<Interval>>, x: &Interval, near: f64) -> Result<Dual<Interval>> {
        let undecided = || Error::Undecided {
            quantity: Quantity::ContactRadius,
            bits: self.precision.bits(),
            what: "whether a row has one state on its arc",
        };
        let mut middle = Interval::from_f64(self.precision, near);
        let mut found: Option<Interval> = None;
        for _ in 0..12 {
            let excess = contact.point(&Dual::constant(middle.clone()))?;
            let error = excess.at[0].value.clone() - x;
            let guess = (error.clone() / &excess.tangent[0].value).abs();
            let reach = Interval::point(guess.upper().clone()).times(2) + middle.abs() * middle.unit_roundoff();
            let around = middle.clone().inflate(&reach);
            let slope = contact.point(&Dual::constant(around.clone()))?.tangent[0].value.clone();
            if slope.contains_zero() {
                return Err(undecided());
            }
            let next = middle.clone() - error / slope;
            let inside = next.lower() > around.lower() && next.upper() < around.upper();
            let narrower = found.as_ref().is_none_or(|found| next.radius() < Float::with_val(53, found.radius() * 0.5));
            if inside && (found.is_none() || narrower) {
                middle = Interval::point(next.mid());
                found = Some(next);
            } else if found.is_some() {
                break;
            } else {
                middle = Interval::point(next.mid());
            }
        }
        let value = found.ok_or_else(undecided)?;
        let point = contact.point(&Dual::constant(value.clone()))?;
        let slope = -point.at[0].slope.clone() / &point.tangent[0].value;
        Ok(Dual { value, slope })
    }

    /// Refines the estimate, proves a box around it and reads its digits; `None` where they are not decided.
    fn run(&self, minimum: &Minimum, digits: u32, dof: usize) -> Result<Option<Certified>> {
        let mut middle: Vec<Interval> =
            minimum.fitted.iter().map(|value| Interval::from_f64(self.precision, *value)).collect();
        for _ in 0..12 {
            let normal = self.normal(&middle)?;
            let Some(step) = solve(midpoints(&normal.hessian), vec![points(&normal.gradient)]) else { return Ok(None) };
            let small = step[0].iter().zip(&normal.hessian).all(|(step, _)| step.abs().approx() < 1e-60);
            for (value, step) in middle.iter_mut().zip(&step[0]) {
                *value = Interval::point((value.clone() - step).mid());
            }
            let size = step[0].iter().zip(&middle).map(|(step, _)| step.abs().approx()).fold(0.0, f64::max);
            if small || size < 2f64.powi(40 - self.precision.bits().min(1000) as i32) {
                break;
            }
        }
        let Some((proved, reach)) = self.prove(&middle, minimum)? else { return Ok(None) };
        self.read(&proved, &reach, digits, dof)
    }

    /// A box that Krawczyk's operator maps into its interior: the enclosure of the zero, and the half widths of the box in
    /// which it is the only one.
    fn prove(&self, middle: &[Interval], minimum: &Minimum) -> Result<Option<(Vec<Interval>, Vec<f64>)>> {
        let count = middle.len();
        let lengths: Vec<f64> = minimum.jacobian.column_iter().map(|column| column.norm()).collect();
        let at_middle = self.normal(middle)?;
        let unit = |row: usize| (0..count).map(|place| middle[0].lit(i64::from(row == place))).collect::<Vec<_>>();
        let Some(inverse) = solve(midpoints(&at_middle.hessian), (0..count).map(unit).collect()) else {
            return Ok(None);
        };
        // inverse[j] solves H z = e_j: column j of the inverse.
        let times = |vector: &dyn Fn(usize) -> Interval, row: usize| {
            (0..count).fold(middle[0].lit(0), |sum, place| sum + inverse[place][row].clone() * &vector(place))
        };
        let mut scale = 1e-2;
        for _ in 0..8 {
            let mut reach: Vec<f64> = lengths.iter().map(|length| scale / length).collect();
            let stated = reach.clone();
            let mut found: Option<Vec<Interval>> = None;
            for _ in 0..24 {
                let zone: Vec<Interval> = middle
                    .iter()
                    .zip(&reach)
                    .map(|(value, reach)| value.clone().inflate(&Interval::from_f64(self.precision, *reach)))
                    .collect();
                let Ok(over) = self.normal(&zone) else { break };
                let image = |row: usize| {
                    let shift = times(&|place| at_middle.gradient[place].clone(), row);
                    let spread = (0..count).fold(middle[0].lit(0), |sum, column| {
                        let entry = times(&|place| over.hessian[place][column].clone(), row);
                        sum + (middle[0].lit(i64::from(row == column)) - entry)
                            * &(zone[column].clone() - &middle[column])
                    });
                    middle[row].clone() - shift + spread
                };
                let images: Vec<Interval> = (0..count).map(image).collect();
                let inside = images
                    .iter()
                    .zip(&zone)
                    .all(|(image, zone)| image.lower() > zone.lower() && image.upper() < zone.upper());
                if !inside {
                    break;
                }
                let next: Vec<f64> = images
                    .iter()
                    .zip(middle)
                    .map(|(image, middle)| (image.clone() - middle).abs().upper().to_f64() * 2.0)
                    .collect();
                let shrinks = next.iter().zip(&reach).any(|(next, reach)| *next < 0.7 * reach);
                (found, reach) = (Some(images), next);
                if !shrinks {
                    break;
                }
            }
            if let Some(found) = found {
                return Ok(Some((found, stated)));
            }
            scale *= 1e-2;
        }
        Ok(None)
    }

    /// The digits of the numbers, of their standard errors scaled by the residuals, and of the sum of squares.
    fn read(&self, fitted: &[Interval], reach: &[f64], digits: u32, dof: usize) -> Result<Option<Certified>> {
        let normal = self.normal(fitted)?;
        let count = fitted.len();
        let unit = |row: usize| (0..count).map(|place| fitted[0].lit(i64::from(row == place))).collect::<Vec<_>>();
        let Some(covariance) = solve(normal.information.clone(), (0..count).map(unit).collect()) else {
            return Ok(None);
        };
        let variance = normal.rss.clone().over(dof.max(1) as i64);
        let text = |value: Interval| Enclosure::from(value).round(digits);
        let numbers = self.numbers(fitted, usize::MAX);
        let mut parameters = Vec::with_capacity(count);
        for (place, reach) in reach.iter().enumerate() {
            let parameter = &self.problem.parameters[self.free[place]];
            let value = match parameter.kind {
                Kind::EffectiveModulus => &numbers.e_star.value,
                Kind::WorkOfAdhesion => &numbers.work.value,
                Kind::Stiffness => numbers.stiffness.as_ref().map_or(&fitted[place], |stiffness| &stiffness.value),
                Kind::Profile(index) => &numbers.profile[index].value,
                Kind::ContactPoint | Kind::Baseline => &fitted[place],
            };
            let factor = if parameter.kind.is_offset() { value.lit(1) } else { value.abs() };
            let error = (covariance[place][place].clone() * &variance).sqrt() * &factor;
            let (Some(value), Some(scaled_stderr)) = (text(value.clone()), text(error)) else { return Ok(None) };
            let name = parameter.name.clone();
            parameters.push(CertifiedEstimate { name, value, scaled_stderr, unique_within: reach * factor.approx() });
        }
        Ok(text(normal.rss).map(|rss| Certified { digits, parameters, rss }))
    }
}

fn points(values: &[Interval]) -> Vec<Interval> {
    values.iter().map(|value| Interval::point(value.mid())).collect()
}

fn midpoints(matrix: &[Vec<Interval>]) -> Vec<Vec<Interval>> {
    matrix.iter().map(|row| points(row)).collect()
}

/// Solves matrix · z = right for each right-hand side, by elimination with pivots; none where a pivot may vanish.
fn solve(mut matrix: Vec<Vec<Interval>>, mut right: Vec<Vec<Interval>>) -> Option<Vec<Vec<Interval>>> {
    let count = matrix.len();
    for place in 0..count {
        let size = |row: &usize| matrix[*row][place].abs().approx();
        let pivot = (place..count).max_by(|one, other| size(one).total_cmp(&size(other)))?;
        matrix.swap(place, pivot);
        right.iter_mut().for_each(|right| right.swap(place, pivot));
        if matrix[place][place].contains_zero() || !matrix[place][place].is_finite() {
            return None;
        }
        for row in (0..count).filter(|row| *row != place) {
            let factor = matrix[row][place].clone() / &matrix[place][place];
            let pivot = matrix[place].clone();
            for (entry, pivot) in matrix[row].iter_mut().zip(&pivot).skip(place) {
                *entry -= &(factor.clone() * pivot);
            }
            for right in &mut right {
                let change = factor.clone() * &right[place];
                right[row] -= &change;
            }
        }
    }
    for right in &mut right {
        for place in 0..count {
            right[place] = right[place].clone() / &matrix[place][place];
        }
    }
    Some(right)
}
