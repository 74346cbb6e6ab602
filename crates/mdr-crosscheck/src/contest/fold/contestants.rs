//! Ways to an instability, in double precision.

use std::f64::consts::PI;
use std::hint::black_box;
use std::sync::Arc;

use mdr_analytic::double;
use mdr_core::calculus::roots::{self, Bracket, Root};
use mdr_core::contact::{Control, CountedTransform, Error, Material, Quantity, Ranged, Result};
use mdr_core::number::{Dual, Special};
use mdr_numeric::curve::Curve;
use mdr_numeric::folds::folds;
use mdr_numeric::springs::Foundation;

use super::question::{Question, Shape, State};
use crate::contest::{Clock, Effort, Outcome, Point};

/// The settings of methods that have one.
pub(super) struct Ladder {
    tolerances: Vec<f64>,
    springs: Vec<usize>,
}

impl Ladder {
    pub(super) fn new(effort: Effort) -> Self {
        let (step, most) = match effort {
            Effort::Quick => (4, 11),
            Effort::Full => (1, 17),
        };
        let tolerances = (1..=16).filter(|power| power % step == 0).map(|power| 10f64.powi(-power)).collect();
        Ladder { tolerances, springs: (4..=most).map(|power| 1 << power).collect() }
    }
}

/// Radius, indentation, and values of g or g' spent.
type Found = ([f64; 2], u64);

/// The points of one contestant: for the radius, and for the indentation.
type Points = Vec<[Point; 2]>;

const CONTROL: Control<f64> = Control::Indentation;

/// Every contestant that can answer, by name.
pub(super) fn contestants(
    question: &Question,
    ladder: &Ladder,
    clock: &Clock,
    truth: &State,
) -> Vec<(&'static str, Points)> {
    let answer = |setting: String, work: &dyn Fn() -> Result<Found>| both(setting, clock, truth, work);
    let mut all = Vec::new();
    if let Shape::Power { n, c } = question.shape {
        all.push(("closed form, shipped", vec![answer("f64".to_owned(), &|| shipped(question, n, c))]));
        all.push(("closed form, by hand", vec![answer("f64".to_owned(), &|| Ok(by_hand(question, n, c)))]));
    }
    all.push(("search for all folds", vec![answer("f64".to_owned(), &|| search(question))]));
    let by_tolerance = |method: fn(&Question, f64) -> Result<Found>| -> Points {
        let tolerances = ladder.tolerances.iter();
        tolerances.map(|&to| answer(format!("to {to:.0e}"), &|| method(question, black_box(to)))).collect()
    };
    all.push(("tangency, Newton", by_tolerance(newton)));
    all.push(("tangency, interpolation", by_tolerance(interpolation)));
    all.push(("tangency, bisection", by_tolerance(bisection)));
    all.push(("extremum of d, golden section", by_tolerance(golden_section)));
    let springs = ladder.springs.iter();
    let springs = springs.map(|&count| answer(format!("{count} springs"), &|| foundation(question, black_box(count))));
    all.push(("springs", springs.collect()));
    all
}

/// One answer is timed once and judged for both of its numbers.
fn both(setting: String, clock: &Clock, truth: &State, work: &dyn Fn() -> Result<Found>) -> [Point; 2] {
    let answer = work();
    let time = clock.time(work);
    [0, 1].map(|index| {
        let (outcome, evaluations) = match &answer {
            Ok((found, count)) => (Outcome::of(&found[index], &truth[index]), Some(*count)),
            Err(error) => (Outcome::Failed(error.to_string()), None),
        };
        Point { setting: setting.clone(), outcome, evaluations, time }
    })
}

/// The transform of the question, with its evaluations counted.
fn counted<R: Special>(question: &Question, ctx: R::Ctx) -> Result<CountedTransform<R>> {
    Ok(CountedTransform::new(question.shape.transform(ctx)?, &Arc::default()))
}

/// What `mdr_analytic::double` says.
fn shipped(question: &Question, n: f64, c: f64) -> Result<Found> {
    let state = double::critical(black_box(n), c, &question.material()?, &CONTROL)?;
    let value = |quantity, x| match x {
        Ranged::Value(value) => Ok(value),
        Ranged::Overflow { log10 } | Ranged::Underflow { log10 } => Err(Error::OutOfRange { quantity, log10 }),
    };
    let (radius, indentation) =
        (value(Quantity::ContactRadius, state.contact_radius)?, value(Quantity::Indentation, state.indentation)?);
    Ok(([radius, indentation], 1))
}

/// (1.15) as one would type it, and d = g(a) − Δl(a), where two terms cancel.
fn by_hand(question: &Question, n: f64, c: f64) -> Found {
    let ([e_star, work], n) = (question.material, black_box(n));
    let kappa = PI.sqrt() / 2.0 * n * pxfm::f_tgamma(n / 2.0) / pxfm::f_tgamma((n + 1.0) / 2.0);
    let a = (PI * work / (2.0 * (n * kappa * c).powi(2) * e_star)).powf(1.0 / (2.0 * n - 1.0));
    ([a, kappa * c * a.powf(n) - (2.0 * PI * a * work / e_star).sqrt()], 1)
}

/// The search of `mdr_numeric`, which knows no bracket and finds all.
fn search(question: &Question) -> Result<Found> {
    let transform = counted::<f64>(question, ())?;
    let material = question.material()?;
    let found = folds(&transform, &material, &CONTROL)?;
    let [lower, upper] = question.bracket;
    let inside = found.iter().find(|fold| fold.contact_radius > lower && fold.contact_radius < upper);
    let fold = inside.ok_or_else(|| nothing(lower))?;
    Ok(([fold.contact_radius, fold.indentation], transform.evaluations().total()))
}

/// The answer of a method that finds nothing where there is something.
fn nothing(near: f64) -> Error {
    Error::domain(Quantity::ContactRadius, &near, "near an instability")
}

/// The tangency ratio less one on the bracket of the question, handed to a root finder.
fn tangency(
    question: &Question,
    find: impl FnOnce(Bracket<f64>, &dyn Fn(&f64) -> Result<f64>) -> Result<Root<f64>>,
) -> Result<Found> {
    let transform = counted::<f64>(question, ())?;
    let material = question.material()?;
    let curve = Curve::new(&transform, &material, &CONTROL);
    let excess = |a: &f64| Ok(curve.tangency(a)? - 1.0);
    let [lower, upper] = question.bracket;
    let bracket = Bracket::new(&lower, &upper, excess)?.ok_or_else(|| nothing(lower))?;
    let radius = find(bracket, &excess)?.value;
    Ok(([radius, curve.indentation(&radius)?], transform.evaluations().total()))
}

fn bisection(question: &Question, tolerance: f64) -> Result<Found> {
    tangency(question, |bracket, excess| roots::bisect(bracket, &tolerance, excess))
}

fn interpolation(question: &Question, tolerance: f64) -> Result<Found> {
    tangency(question, |bracket, excess| roots::refine(bracket, &tolerance, excess))
}

/// Newton's method within the bracket; the slope of the ratio comes from the quadrature over dual numbers, which counts as
/// one more value.
fn newton(question: &Question, tolerance: f64) -> Result<Found> {
    let moving = counted::<Dual<f64>>(question, ())?;
    let [e_star, work] = question.material.map(Dual::constant);
    let (material, control) = (Material::new(e_star, work)?, Control::Indentation);
    let curve = Curve::new(&moving, &material, &control);
    let with_slope = |a: &f64| {
        let ratio = curve.tangency(&Dual::variable(*a))?;
        Ok((ratio.value - 1.0, ratio.slope))
    };
    let ([radius, indentation], count) =
        tangency(question, |bracket, _| roots::refine_with_slope(bracket, &tolerance, with_slope))?;
    Ok(([radius, indentation], count + 2 * moving.evaluations().total()))
}

/// The extremum of d(a) by golden section. Beside an extremum d changes by the square of the distance: half of the digits
/// of the radius are out of reach.
fn golden_section(question: &Question, tolerance: f64) -> Result<Found> {
    let transform = counted::<f64>(question, ())?;
    let material = question.material()?;
    let curve = Curve::new(&transform, &material, &CONTROL);
    let sign = if question.breaks() { 1.0 } else { -1.0 };
    let height = |a: f64| Ok::<_, Error>(sign * curve.indentation(&a)?);
    let share = (5f64.sqrt() - 1.0) / 2.0;
    let [mut lower, mut upper] = question.bracket;
    let mut inner = [upper - share * (upper - lower), lower + share * (upper - lower)];
    let mut heights = [height(inner[0])?, height(inner[1])?];
    // A step may leave the ends as they are once they are neighbours.
    for _ in 0..100 {
        if upper - lower <= tolerance * lower {
            break;
        }
        if heights[0] < heights[1] {
            upper = inner[1];
            inner = [upper - share * (upper - lower), inner[0]];
            heights = [height(inner[0])?, heights[0]];
        } else {
            lower = inner[0];
            inner = [inner[1], lower + share * (upper - lower)];
            heights = [heights[1], height(inner[1])?];
        }
    }
    let radius = f64::midpoint(lower, upper);
    Ok(([radius, curve.indentation(&radius)?], transform.evaluations().total()))
}

/// The procedure of the paper: so many springs on a side.
fn foundation(question: &Question, springs: usize) -> Result<Found> {
    let transform = counted::<f64>(question, ())?;
    let spacing = question.reach / springs as f64;
    let foundation = Foundation::new(&transform, &question.material()?, spacing, springs)?;
    let breaks = question.breaks();
    let cascades = if breaks { foundation.pull(springs, &CONTROL)? } else { foundation.press(1, &CONTROL)? };
    let found = &cascades.first().ok_or_else(|| nothing(spacing))?.instability;
    // Under pressure the spring that is named is the last one at rest; its outer neighbour is critical.
    let radius = if breaks { found.contact_radius } else { found.contact_radius + spacing };
    Ok(([radius, found.indentation], transform.evaluations().total()))
}
