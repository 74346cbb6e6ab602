//! The last equilibrium under fixed grips, its contact radius and its indentation: from the closed form, from the tangency
//! (1.10), from the extremum of d(a), and from the springs of the paper. All but the closed forms start from heights.

use std::hint::black_box;
use std::sync::Arc;

use mdr_analytic::double;
use mdr_core::calculus::roots::{self, Bracket, Root};
use mdr_core::contact::{Control, CountingTransform, Error, Material, Quantity, Ranged, Result, Shape};
use mdr_core::number::{Dual, Interval, Precision, Real, Special};
use mdr_numeric::contact::Contact;
use mdr_numeric::folds::folds;
use mdr_numeric::springs::Foundation;
use mdr_numeric::transform::Quadrature;

use super::kappa::by_gamma;
use super::{Accuracy, Clock, Comparison, Measurement, Series, Task, transform};
use crate::Level;

/// The task.
pub(super) const TASK: Task = Task {
    name: "fold",
    title: "The last equilibrium under fixed grips in double precision, its contact radius and its indentation (1.15)",
    comparisons,
};

/// Bits of the enclosures.
const BITS: u32 = 128;

const CONTROL: Control<f64> = Control::Indentation;

/// A question, with the data that a method may use beforehand.
struct Question {
    name: &'static str,
    words: &'static str,
    /// Lengths in m.
    shape: Shape<f64>,
    /// E* in Pa and w in J/m².
    material: [f64; 2],
    /// Radii around this fold and no other one, in m.
    bracket: [f64; 2],
    /// The springs stand up to this radius, in m.
    reach: f64,
}

/// A power law with C = 1, E* = 1 and w = 1/16.
const fn power(name: &'static str, words: &'static str, n: f64, bracket: [f64; 2], reach: f64) -> Question {
    Question { name, words, shape: Shape::Power { n, c: 1.0 }, material: [1.0, 0.0625], bracket, reach }
}

const QUESTIONS: [Question; 5] = [
    power("2", "a paraboloid", 2.0, [0.05, 0.7], 0.5),
    power("1", "a cone", 1.0, [0.01, 0.14], 0.125),
    power("0.25", "a sharp tip, n = 1/4", 0.25, [0.2, 2.8], 2.0),
    power("3.7", "a power law, n = 3.7", 3.7, [0.1, 1.4], 1.0),
    Question {
        name: "wavy",
        words: "a wavy paraboloid, the first on pulling",
        shape: Shape::WavyParaboloid { radius: 1.0, amplitude: 5e-4, wavelength: 0.1 },
        material: [1.0, 1e-4],
        bracket: [0.058, 0.09],
        reach: 0.1,
    },
];

fn comparisons(level: Level, clock: Clock) -> Result<Vec<Comparison>> {
    let both = QUESTIONS.iter().map(|question| question.comparisons(level, clock));
    Ok(both.collect::<Result<Vec<_>>>()?.into_iter().flatten().collect())
}

/// The exact radius and indentation.
type State = [Interval; 2];

/// Halves the bracket as long as the sign of g' − Δl' in the middle is certain.
fn truth(shape: &Shape<f64>, material: [f64; 2], bracket: [f64; 2]) -> Result<State> {
    let exact = |x| Interval::from_f64(Precision::new(BITS), x);
    let [e_star, work] = material.map(exact);
    let length = work / e_star;
    // Δl' = √(πw/(2E*a)).
    let excess = |a: &Interval| -> Result<Interval> {
        let [_, slope] = transform::enclosed(shape, a)?;
        Ok(slope - (length.clone() * a.pi() / a.clone().times(2)).sqrt())
    };
    let [mut lower, mut upper] = bracket.map(exact);
    let zero = lower.lit(0);
    let rising = excess(&lower)? < zero;
    for _ in 0..2 * BITS {
        let middle = (lower.clone() + &upper).over(2).midpoint();
        match excess(&middle)?.partial_cmp(&zero) {
            Some(order) if order.is_lt() == rising => lower = middle,
            Some(order) if order.is_ne() => upper = middle,
            _ => break,
        }
    }
    let radius = lower.hull(&upper);
    let [g, _] = transform::enclosed(shape, &radius)?;
    let indentation = g - (length * radius.pi() * &radius).times(2).sqrt();
    Ok([radius, indentation])
}

/// A method: radius, indentation, and values of g or g' spent.
type Found = ([f64; 2], u64);

/// The answer of a method that finds nothing where there is something.
fn nothing(near: f64) -> Error {
    Error::domain(Quantity::ContactRadius, &near, "near an instability")
}

impl Question {
    /// Every method gives both numbers.
    fn comparisons(&self, level: Level, clock: Clock) -> Result<[Comparison; 2]> {
        let truth = truth(&self.shape, self.material, self.bracket)?;
        let conditions = self.conditions(&truth)?;
        let methods = self.methods(level, clock, &truth);
        let numbers = [("radius", "contact radius", 0), ("indentation", "indentation", 1)];
        Ok(numbers.map(|(id, quantity, index)| Comparison {
            id: format!("fold-{id}-{}", self.name),
            title: format!("{quantity} at the instability of {}", self.words),
            truth: "the tangency g' = Δl' (1.10) over intervals, halved as long as its sign is certain, with closed forms of g",
            attainable: Some(Accuracy::attainable(conditions[index])),
            series: methods
                .iter()
                .map(|(method, ours, points)| {
                    let points = points.iter().map(|pair| pair[index].clone()).collect();
                    Series { method, ours: *ours, points }
                })
                .collect(),
        }))
    }

    /// Sums of |∂ ln y/∂ ln x| over the inputs x, for the radius and for the indentation.
    fn conditions(&self, truth: &State) -> Result<[f64; 2]> {
        /// Exact in every input; it leaves half of the bits of the enclosures.
        const STEP: f64 = 1.0 / (1u64 << 30) as f64;
        let mut sums = [0.0; 2];
        for index in 0..self.shape.parameters().len() + self.material.len() {
            let mut inputs = 0..;
            let mut stepped = |value: f64| if inputs.next() == Some(index) { value * (1.0 + STEP) } else { value };
            let shape = self.shape.map(|_, value| stepped(*value));
            let beside = self::truth(&shape, self.material.map(stepped), self.bracket)?;
            for ((sum, from), to) in sums.iter_mut().zip(truth).zip(&beside) {
                *sum += ((to.clone() / from - from.lit(1)).approx() / STEP).abs();
            }
        }
        Ok(sums)
    }

    /// Every method that can answer: its name, whether it is ours, and its points for the radius and the indentation.
    fn methods(&self, level: Level, clock: Clock, truth: &State) -> Vec<(&'static str, bool, Vec<[Measurement; 2]>)> {
        let answer = |setting: String, work: &dyn Fn() -> Result<Found>| {
            let (answer, seconds) = (work(), clock.time(work));
            [0, 1].map(|index| {
                let number = answer.clone().map(|(found, count)| (found[index], count));
                Measurement::of(&*setting, number, &truth[index..=index], seconds)
            })
        };
        let (step, most) = if level == Level::Quick { (4, 11) } else { (1, 17) };
        let to_tolerance = |method: fn(&Question, f64) -> Result<Found>| -> Vec<_> {
            let tolerances = (1..=16).filter(|power| power % step == 0).map(|power| 10_f64.powi(-power));
            tolerances.map(|to| answer(format!("to {to:.0e}"), &|| method(self, black_box(to)))).collect()
        };
        let springs = (4..=most).map(|power| 1 << power);
        let springs = springs.map(|count| answer(format!("{count} springs"), &|| self.springs(black_box(count))));
        let search = answer("f64".to_owned(), &|| self.search());
        let mut all = vec![
            ("search for all folds", true, vec![search]),
            ("tangency, Newton in a bracket", true, to_tolerance(Self::newton)),
            ("tangency, interpolation", true, to_tolerance(Self::interpolation)),
            ("springs of the paper", false, springs.collect()),
            ("tangency, bisection", false, to_tolerance(Self::bisection)),
            ("extremum of d, golden section", false, to_tolerance(Self::golden_section)),
        ];
        if let Shape::Power { n, c } = self.shape {
            let shipped = answer("f64".to_owned(), &|| self.closed_form(black_box(n), c));
            let typed = answer("f64".to_owned(), &|| Ok(self.as_printed(black_box(n), c)));
            all.insert(0, ("closed form, right to 1 ulp", true, vec![shipped]));
            all.push(("(1.15) as printed", false, vec![typed]));
        }
        all
    }

    fn material(&self) -> Result<Material<f64>> {
        let [e_star, work] = self.material;
        Material::new(e_star, work)
    }

    /// The transform, with its evaluations counted.
    fn counted<R: Special>(&self, ctx: R::Ctx) -> Result<Arc<CountingTransform<R>>> {
        let transform = Quadrature::of([self.shape.map(|_, value| R::from_f64(ctx, *value))])?;
        Ok(Arc::new(CountingTransform::new(Box::new(transform), &Arc::default())))
    }

    fn closed_form(&self, n: f64, c: f64) -> Result<Found> {
        let state = double::critical(n, c, &self.material()?, &CONTROL)?;
        let value = |quantity, x| match x {
            Ranged::Value(value) => Ok(value),
            Ranged::Overflow { log10 } | Ranged::Underflow { log10 } => Err(Error::OutOfRange { quantity, log10 }),
        };
        let radius = value(Quantity::ContactRadius, state.contact_radius)?;
        Ok(([radius, value(Quantity::Indentation, state.indentation)?], 1))
    }

    /// (1.15) as one would type it, and d = g(a) − Δl(a), where two terms cancel.
    fn as_printed(&self, n: f64, c: f64) -> Found {
        let [e_star, work] = self.material;
        let kappa = by_gamma(&n);
        let a = (n.pi() * work / (2.0 * (n * kappa * c).powi(2) * e_star)).powf(1.0 / (2.0 * n - 1.0));
        ([a, kappa * c * a.powf(n) - (2.0 * n.pi() * a * work / e_star).sqrt()], 1)
    }

    /// The search of `mdr_numeric`, which needs no bracket and finds all folds.
    fn search(&self) -> Result<Found> {
        let transform = self.counted(())?;
        let found = folds(&transform, &self.material()?, &CONTROL)?;
        let [lower, upper] = self.bracket;
        let inside = found.iter().find(|fold| fold.contact_radius > lower && fold.contact_radius < upper);
        let fold = inside.ok_or_else(|| nothing(lower))?;
        Ok(([fold.contact_radius, fold.indentation], transform.evaluations().total()))
    }

    /// The tangency ratio less one on the bracket, handed to a root finder.
    fn tangency(
        &self,
        find: impl FnOnce(Bracket<f64>, &dyn Fn(&f64) -> Result<f64>) -> Result<Root<f64>>,
    ) -> Result<Found> {
        let transform = self.counted(())?;
        let material = self.material()?;
        let curve = Contact::half_space(&transform, &material, &CONTROL);
        let excess = |a: &f64| Ok(curve.tangency(a)? - 1.0);
        let [lower, upper] = self.bracket;
        let bracket = Bracket::new(&lower, &upper, excess)?.ok_or_else(|| nothing(lower))?;
        let radius = find(bracket, &excess)?.value;
        Ok(([radius, curve.indentation(&radius)?], transform.evaluations().total()))
    }

    fn bisection(&self, tolerance: f64) -> Result<Found> {
        self.tangency(|bracket, excess| roots::bisect(bracket, &tolerance, excess))
    }

    fn interpolation(&self, tolerance: f64) -> Result<Found> {
        self.tangency(|bracket, excess| roots::refine(bracket, &tolerance, excess))
    }

    /// The slope of the ratio comes from the quadrature over dual numbers, which counts as one more value.
    fn newton(&self, tolerance: f64) -> Result<Found> {
        let dual = self.counted::<Dual<f64>>(())?;
        let [e_star, work] = self.material.map(Dual::constant);
        let (material, control) = (Material::new(e_star, work)?, Control::Indentation);
        let curve = Contact::half_space(&dual, &material, &control);
        let with_slope = |a: &f64| {
            let ratio = curve.tangency(&Dual::variable(*a))?;
            Ok((ratio.value - 1.0, ratio.slope))
        };
        let (state, count) = self.tangency(|bracket, _| roots::refine_with_slope(bracket, &tolerance, with_slope))?;
        Ok((state, count + 2 * dual.evaluations().total()))
    }

    /// Beside an extremum d changes by the square of the distance: half of the digits of the radius are out of reach.
    fn golden_section(&self, tolerance: f64) -> Result<Found> {
        let transform = self.counted(())?;
        let material = self.material()?;
        let curve = Contact::half_space(&transform, &material, &CONTROL);
        let sign = if self.breaks() { 1.0 } else { -1.0 };
        let height = |a: f64| Ok::<_, Error>(sign * curve.indentation(&a)?);
        let share = (5_f64.sqrt() - 1.0) / 2.0;
        let [mut lower, mut upper] = self.bracket;
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

    /// Whether the contact breaks there; else it spreads.
    fn breaks(&self) -> bool {
        !matches!(self.shape, Shape::Power { n, .. } if n < 0.5)
    }

    /// The procedure of the paper: so many springs on a side.
    fn springs(&self, springs: usize) -> Result<Found> {
        let transform = self.counted(())?;
        let spacing = self.reach / springs as f64;
        let foundation = Foundation::new(&*transform, &self.material()?, spacing, springs)?;
        let breaks = self.breaks();
        let cascades = if breaks { foundation.pull(springs, &CONTROL)? } else { foundation.press(1, &CONTROL)? };
        let found = &cascades.first().ok_or_else(|| nothing(spacing))?.instability;
        // Under pressure the spring that is named is the last one at rest; its outer neighbour is critical.
        let radius = if breaks { found.contact_radius } else { found.contact_radius + spacing };
        Ok(([radius, found.indentation], transform.evaluations().total()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The closed form (1.15) over intervals overlaps the tangency, and the enclosure is tight.
    #[test]
    fn the_tangency_is_the_closed_form_where_there_is_one() {
        for question in &QUESTIONS {
            let truth = truth(&question.shape, question.material, question.bracket).unwrap();
            assert!(truth.iter().all(|value| value.accuracy_bits() > 90), "{}: {truth:?}", question.name);
            let [condition, _] = question.conditions(&truth).unwrap();
            let Shape::Power { n, c } = question.shape else { continue };
            let exact = |x: f64| Interval::from_f64(Precision::new(200), x);
            // Of a = (πw/(2E*N²))^(1/(2n−1)): 2/|2n−1| for C, half of that for w and for E*; n is the rest.
            assert!(condition.is_finite() && condition > 4.0 / (2.0 * n - 1.0).abs(), "{condition}");
            let ([n, c], [e_star, work]) = ([n, c].map(exact), question.material.map(exact));
            let profile = mdr_analytic::PowerLaw::new(n, c).unwrap();
            let contact = mdr_analytic::PowerLawContact::new(profile, Material::new(e_star, work).unwrap());
            let state = contact.critical(&Control::Indentation).unwrap();
            assert!(state.contact_radius.overlaps(&truth[0]), "{}", question.name);
            assert!(state.indentation.overlaps(&truth[1]), "{}", question.name);
        }
    }

    /// The instability of the wavy paraboloid computed elsewhere, to seven digits.
    #[test]
    fn the_wavy_paraboloid() {
        let [radius, indentation] = truth(&QUESTIONS[4].shape, QUESTIONS[4].material, QUESTIONS[4].bracket).unwrap();
        assert!((radius.approx() / 0.064_459_0 - 1.0).abs() < 1e-6, "{radius:?}");
        assert!((indentation.approx() / -0.001_848_03 - 1.0).abs() < 3e-6, "{indentation:?}");
    }
}
