//! CertifiedFit fits of the data sets: estimates, standard errors and sums of squares.
//!
//! [`mdr`] proves the digits: Krawczyk's operator on the normal equations. The second method has heights f(r) only: residuals by
//! quadrature at the certified estimates, derivatives by differences of them. The normal equations, the sum of squares and the
//! standard errors have to hold for these.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::sync::Arc;

use mdr::prelude::{Literal, Shape};
use mdr_core::contact::{Control, Material};
use mdr_core::number::{Decimal, Precision, Real};
use mdr_fit::{CertifiedFit, Fit, FittedRow, Observation, Problem};
use mdr_numeric::contact::Contact;
use mdr_numeric::profiles::Heights;
use mdr_numeric::transform::Quadrature;
use mdr_reference::{DataSet, Method, Record};
use rug::Float;

use crate::builder::{certified, status, three_digits};
use crate::cases::number;
use crate::patches::Patches;
use crate::{DIGITS, Failure, RecordError, Result, float};

/// The digits in which the second method works.
const WORKING: u32 = 30;

/// The relative step of its differences; they have the error of its square, and of rounding over it.
const STEP: i64 = -8;

/// The scale of the relative error allowed in the normal equations (against the lengths of their factors), in sums of squares
/// and in standard errors.
const AGREED: f64 = 1e-10;

/// The file of the release.
pub(crate) const FILE: &str = "fits.jsonl";

/// The records of a data set.
pub(crate) fn records(set: &DataSet) -> std::result::Result<Vec<Record>, RecordError> {
    of(set).map_err(|source| RecordError { case: format!("fit of {}", set.name), source })
}

fn of(set: &DataSet) -> Result<Vec<Record>> {
    let files = |_: &str| Ok(set.curve.as_bytes().to_vec());
    let problem = Problem::from_toml(set.fit, set.name, &files)?.digits(DIGITS);
    let fit = problem.fit()?;
    let Some(proved) = &fit.certified else { return Err(Failure::Data(fit.warnings.join("; "))) };
    let known = Known::read(set)?;
    known.confirm(&problem, &fit, proved)?;
    let ys = problem.data().map(|[_, y]| y.abs()).fold(0.0, f64::max);
    // How far an error of the data, relative to the largest of them, moves residuals of the size of their scatter.
    let amplified = ys / (proved.rss.to_f64() / fit.dof as f64).sqrt();
    let mut records = Vec::new();
    for (estimate, digits) in fit.parameters.iter().zip(&proved.parameters) {
        let (value, stderr) = (&digits.value, &digits.scaled_stderr);
        let share = (stderr.to_f64() / value.to_f64()).abs();
        let unit = estimate.unit;
        records.push(known.record(set, &digits.name, unit, value, share * amplified));
        records.push(known.record(set, &format!("{}_stderr", digits.name), unit, stderr, amplified));
    }
    records.push(known.record(set, "rss", fit.rss_unit, &proved.rss, 2.0 * amplified));
    Ok(records)
}

/// The statements of a data set: the profile, and numbers that are not free.
struct Known {
    shape: Shape<Literal>,
    numbers: BTreeMap<String, Literal>,
    free: Vec<String>,
}

impl Known {
    fn read(set: &DataSet) -> Result<Self> {
        let table: toml::Table = toml::from_str(set.fit).map_err(|error| Failure::Data(error.to_string()))?;
        let text = |section: &str, key: &str| table.get(section)?.get(key)?.as_str();
        let kind = text("profile", "kind").and_then(Shape::by_name).ok_or(Failure::Missing("profile"))?;
        let shape =
            kind.try_map(|key, ()| number(text("profile", key).ok_or(Failure::Missing("number of the profile"))?))?;
        let mut numbers = BTreeMap::new();
        for (section, key) in [("material", "e_star"), ("material", "work_of_adhesion"), ("control", "stiffness")] {
            if let Some(text) = text(section, key) {
                numbers.insert(key.to_owned(), number(text)?);
            }
        }
        let fit = table.get("fit").and_then(|fit| fit.as_table()).ok_or(Failure::Missing("table [fit]"))?;
        for (key, value) in fit.get("fixed").and_then(|fixed| fixed.as_table()).into_iter().flatten() {
            numbers.insert(key.clone(), number(value.as_str().unwrap_or_default())?);
        }
        let free = fit.get("free").and_then(|free| free.as_array()).into_iter().flatten();
        let free = free.filter_map(|name| name.as_str().map(str::to_owned)).collect();
        Ok(Known { shape, numbers, free })
    }

    /// The record of a number.
    fn record(&self, set: &DataSet, quantity: &str, unit: &str, value: &Decimal, condition: f64) -> Record {
        let of_profile = self.shape.parameters().into_iter();
        let mut inputs: Vec<(String, String)> = of_profile
            .filter(|(name, _)| !self.free.iter().any(|free| free == name))
            .map(|(name, number)| (if name == "c" { "C" } else { name }.to_owned(), number.to_string()))
            .collect();
        inputs.extend(self.numbers.iter().map(|(name, number)| (name.clone(), number.to_string())));
        inputs.push(("rows".to_owned(), set.rows().to_string()));
        let method = |name: &str, rigorous| Method { name: name.to_owned(), rigorous };
        Record {
            id: format!("fit/{}/{quantity}", set.name),
            release: 3,
            profile: self.shape.name().to_owned(),
            formula: "fit".to_owned(),
            inputs,
            quantity: quantity.to_owned(),
            unit: unit.to_owned(),
            control: None,
            status: status(value),
            value: Some(certified(value)),
            log10: Some((value.log10_f64() * 1e9).round() / 1e9),
            scale: None,
            condition: vec![("data".to_owned(), three_digits(condition))],
            difficulty: set.level,
            methods: vec![method("krawczyk/interval", true), method("quadrature-residuals/mp", false)],
            proof: vec!["1.5".to_owned(), "1.6".to_owned()],
            flags: Vec::new(),
            refs: vec!["Popov (1.5)".to_owned(), "Popov (1.6)".to_owned(), "Krawczyk 1969".to_owned()],
        }
    }

    /// Whether residuals by quadrature satisfy the normal equations at the certified estimates, with the certified sum of squares and
    /// standard errors.
    fn confirm(&self, problem: &Problem, fit: &Fit, proved: &CertifiedFit) -> Result<()> {
        let ctx = Precision::from_digits(WORKING);
        let mut numbers = BTreeMap::new();
        for (name, number) in self.shape.parameters() {
            numbers.insert(name.to_owned(), Float::from_literal(ctx, number));
        }
        for (name, number) in &self.numbers {
            numbers.insert(name.clone(), Float::from_literal(ctx, number));
        }
        for estimate in &proved.parameters {
            numbers.insert(estimate.name.clone(), float(ctx, &estimate.value));
        }
        let mut places: Vec<Place> = fit.rows.iter().map(|row| Place::of(row, fit, ctx)).collect();
        let rows: Vec<[Float; 2]> = problem.data().map(|row| row.map(|value| exact(ctx, value))).collect();
        let scales = (fit.distance == "orthogonal").then(|| fit.sigma.map(|sigma| exact(ctx, sigma)));
        let (observation, kept) = (problem.observation(), RefCell::default());
        let model = Rows { shape: &self.shape, observation, rows: &rows, scales, kept };
        let residuals = model.residuals(&numbers, &mut places)?;
        let zero = || Float::from_int(ctx, 0);
        let rss = residuals.iter().fold(zero(), |sum, residual| sum + residual.square());
        let step = zero().lit(10).powi(STEP);
        let mut columns = Vec::new();
        for estimate in &proved.parameters {
            let value = numbers[&estimate.name].clone();
            let size = float(ctx, &estimate.scaled_stderr);
            let moved = |sign: i64| {
                let mut numbers = numbers.clone();
                numbers.insert(estimate.name.clone(), value.clone() + step.clone().times(sign) * &value);
                model.residuals(&numbers, &mut places.clone())
            };
            let [above, below] = [moved(1)?, moved(-1)?];
            let width = step.clone().times(2) * &value / &size;
            columns
                .push(above.into_iter().zip(below).map(|(above, below)| (above - below) / &width).collect::<Vec<_>>());
        }
        // In units of the standard errors, so that the covariance has a diagonal of one.
        let dot = |one: &[Float], other: &[Float]| {
            one.iter().zip(other).fold(zero(), |sum, (one, other)| sum + one.clone() * other)
        };
        let small = |value: &Float, scale: &Float| (value.clone() / scale).abs().to_f64() < AGREED;
        for column in &columns {
            let lengths = (dot(column, column) * &rss).sqrt();
            Failure::unless("the estimates", small(&dot(column, &residuals), &lengths))?;
        }
        Failure::unless("the sum of squares", small(&(float(ctx, &proved.rss) - &rss), &rss))?;
        let variance = rss.over(fit.dof as i64);
        let information: Vec<Vec<Float>> =
            columns.iter().map(|one| columns.iter().map(|other| dot(one, other) / &variance).collect()).collect();
        for place in 0..columns.len() {
            let error = inverse_diagonal(information.clone(), place) - zero().lit(1);
            Failure::unless("the standard errors", error.abs().to_f64() < 100.0 * AGREED)?;
        }
        Ok(())
    }
}

/// The number that a double was printed as.
fn exact(ctx: Precision, value: f64) -> Float {
    Literal::try_from(value)
        .map_or_else(|_| Float::from_f64(ctx, f64::NAN), |literal| Float::from_literal(ctx, &literal))
}

/// An entry of the diagonal of the inverse of a positive definite matrix: one over what elimination of all others leaves there.
fn inverse_diagonal(mut matrix: Vec<Vec<Float>>, place: usize) -> Float {
    for pivot in (0..matrix.len()).filter(|pivot| *pivot != place) {
        for row in (0..matrix.len()).filter(|row| *row != pivot) {
            let factor = matrix[row][pivot].clone() / &matrix[pivot][pivot];
            let subtracted = matrix[pivot].clone();
            for (entry, other) in matrix[row].iter_mut().zip(subtracted) {
                *entry -= factor.clone() * other;
            }
        }
    }
    matrix[place][place].lit(1) / &matrix[place][place]
}

/// The point of the curve with which a row is compared.
#[derive(Clone)]
struct Place {
    /// The contact radius of the place; `None` if the row is detached.
    a: Option<Float>,
    kind: PlaceKind,
    /// How the equation of the place grows with the radius, once it is known.
    slope: Option<Float>,
}

#[derive(Clone, Copy, PartialEq)]
enum PlaceKind {
    /// X is that of the row.
    Vertical,
    /// The nearest to the row.
    Nearest,
    /// Where X turns.
    Fold,
}

impl Place {
    fn of(row: &FittedRow, fit: &Fit, ctx: Precision) -> Self {
        let is_end =
            |radius: f64| fit.arcs.iter().flat_map(|arc| [arc.first(), arc.last()]).flatten().any(|at| at[2] == radius);
        let kind = match row.contact_radius {
            Some(radius) if is_end(radius) => PlaceKind::Fold,
            _ if fit.distance == "orthogonal" => PlaceKind::Nearest,
            _ => PlaceKind::Vertical,
        };
        Place { a: row.contact_radius.map(|radius| Float::from_f64(ctx, radius)), kind, slope: None }
    }
}

/// Rows of a data set, and the model that they are compared with.
struct Rows<'a> {
    shape: &'a Shape<Literal>,
    observation: Observation,
    rows: &'a [[Float; 2]],
    /// σ_X and σ_Y of orthogonal distances.
    scales: Option<[Float; 2]>,
    /// The last profile and its transform: most differences are of other numbers.
    kept: RefCell<Option<(Shape<Float>, Arc<Kept>)>>,
}

/// A transform by quadrature, and what is kept of it.
type Kept = Patches<Quadrature<Float, Heights<Float>>>;

impl Rows<'_> {
    /// Curve minus datum of each row, at a fold in both directions; `places` are near those of the numbers, and become them.
    fn residuals(&self, numbers: &BTreeMap<String, Float>, places: &mut [Place]) -> Result<Vec<Float>> {
        let named = |name: &str| numbers.get(name).cloned();
        let shape = self.shape.try_map(|key, _| named(key).ok_or(Failure::Missing("number of the profile")))?;
        let transform = self.transform(shape)?;
        let required = |name| named(name).ok_or(Failure::Missing("modulus or work of adhesion"));
        let material = Material::new(required("e_star")?, required("work_of_adhesion")?)?;
        let control = Control::Indentation;
        let curve = Contact::half_space(&transform, &material, &control);
        let zero = self.rows[0][0].lit(0);
        let [contact_point, baseline] =
            ["contact_point", "baseline"].map(|name| named(name).unwrap_or_else(|| zero.clone()));
        let stiffness = named("stiffness");
        let bent = |f: &Float| stiffness.as_ref().map_or_else(|| zero.clone(), |stiffness| f.clone() / stiffness);
        // X and Y of a contact radius.
        let at = |a: &Float| -> Result<[Float; 2]> {
            let (d, f) = curve.state(a)?;
            let (position, force) = (d.clone() + bent(&f) + &contact_point, f.clone() + &baseline);
            Ok(match self.observation {
                Observation::ForceOfIndentation => [d + &contact_point, force],
                Observation::ForceOfPosition => [position, force],
                Observation::DeflectionOfPosition => [position, bent(&f) + &baseline],
                Observation::IndentationOfForce => [force, d + &contact_point],
                Observation::ForceOfRadius => [a.clone(), force],
                Observation::RadiusOfForce => [force, a.clone()],
            })
        };
        let mut residuals = Vec::with_capacity(self.rows.len());
        for (row, place) in self.rows.iter().zip(places) {
            residuals.extend(self.residual(row, place, &at, &baseline)?);
        }
        Ok(residuals)
    }

    /// The transform of a profile, the kept one if that is the last profile.
    fn transform(&self, shape: Shape<Float>) -> Result<Arc<Kept>> {
        let mut kept = self.kept.borrow_mut();
        if let Some((_, transform)) = kept.as_ref().filter(|(last, _)| *last == shape) {
            return Ok(Arc::clone(transform));
        }
        let transform = Arc::new(Patches::new(Quadrature::of([shape.clone()])?));
        kept.replace((shape, Arc::clone(&transform)));
        Ok(transform)
    }

    fn residual(
        &self,
        [x, y]: &[Float; 2],
        place: &mut Place,
        at: &dyn Fn(&Float) -> Result<[Float; 2]>,
        baseline: &Float,
    ) -> Result<Vec<Float>> {
        let scaled = |[x, y]: [Float; 2]| match &self.scales {
            Some([x_scale, y_scale]) => [x / x_scale, y / y_scale],
            None => [x, y],
        };
        let zero = || x.lit(0);
        let Some(a) = &mut place.a else { return Ok(vec![scaled([zero(), baseline.clone() - y])[1].clone()]) };
        let step = a.lit(10).powi(STEP) * &*a;
        // The distance of the curve from the row, and its derivative by differences.
        let away = |a: &Float| at(a).map(|[curve_x, curve_y]| scaled([curve_x - x, curve_y - y]));
        let tangent = |a: &Float| -> Result<[Float; 2]> {
            let [[x1, y1], [x0, y0]] = [away(&(a.clone() + &step))?, away(&(a.clone() - &step))?];
            let width = step.clone().times(2);
            Ok([(x1 - x0) / &width, (y1 - y0) / width])
        };
        let equation = |a: &Float| -> Result<Float> {
            Ok(match place.kind {
                PlaceKind::Vertical => away(a)?[0].clone(),
                PlaceKind::Nearest => {
                    let ([x, y], [x_slope, y_slope]) = (away(a)?, tangent(a)?);
                    x * x_slope + y * y_slope
                }
                PlaceKind::Fold => tangent(a)?[0].clone(),
            })
        };
        let slope = match &mut place.slope {
            Some(slope) => slope,
            None => {
                let near = a.clone() + &step;
                place.slope.insert((equation(&near)? - equation(a)?) / (near - &*a))
            }
        };
        // The slope is known to the size of its step, by which each correction is smaller than the last.
        for _ in 0..2 {
            let change = equation(a)? / &*slope;
            *a -= change;
        }
        let [x, y] = away(a)?;
        Ok(match place.kind {
            PlaceKind::Vertical => vec![y],
            PlaceKind::Nearest => {
                let [x_slope, y_slope] = tangent(a)?;
                let length = (x_slope.clone().square() + y_slope.clone().square()).sqrt();
                vec![(y * x_slope - x * y_slope) / length]
            }
            PlaceKind::Fold => vec![x, y],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The second method notices a datum that is another in its sixth digit.
    #[test]
    fn a_wrong_answer_is_not_confirmed() -> Result<()> {
        let set = &mdr_reference::data_sets()[0];
        let other = set.curve.replacen("2.16184e-5", "2.16185e-5", 1);
        assert_ne!(other, set.curve);
        let [right, wrong] = [set.curve, &other].map(|curve| {
            let files = move |_: &str| Ok(curve.as_bytes().to_vec());
            Problem::from_toml(set.fit, set.name, &files).map(|problem| problem.digits(DIGITS))
        });
        let (right, wrong) = (right?, wrong?);
        let fit = right.fit()?;
        let Some(proved) = &fit.certified else { return Err(Failure::Missing("proof of every digit")) };
        let known = Known::read(set)?;
        known.confirm(&right, &fit, proved)?;
        assert!(matches!(known.confirm(&wrong, &fit, proved), Err(Failure::Unconfirmed(_))));
        Ok(())
    }
}
