//! What several checks share: power laws and machines with a planted fold, drawn profiles, and how folds are compared.

use std::sync::Arc;

use mdr_analytic::profiles::ClosedReal;
use mdr_core::contact::{Error, Fold, Material, Profile, Quantity, Result, Shape, Transform};
use mdr_core::number::{Lift, Literal, Real, Special};
use mdr_numeric::profiles::Heights;
use mdr_numeric::transform::Quadrature;
use rug::{Float, Rational};

use crate::arithmetic::Arithmetic;
use crate::grid::{Exponent, Family, Held, Scene};
use crate::subject::profiles::{NAMES, closed_form, terms};
use crate::tolerance::{Tangent, machine_balance, quadrature};
use crate::trial::Trial;

/// A double as a fraction.
pub(super) fn rational(x: f64) -> Rational {
    Rational::from_f64(x).unwrap_or_default()
}

/// The number that is written.
pub(crate) fn literal(text: &str) -> Result<Literal> {
    let quantity = Quantity::Parameter("an input of the grid");
    text.parse().map_err(|_| Error::Domain { quantity, value: text.to_owned(), requirement: "a number" })
}

/// A power law for the numerical route, which uses nothing but its heights.
pub(super) fn transform<R: Arithmetic>(scene: &Scene<R>) -> Result<Arc<Quadrature<R, Heights<R>>>> {
    Quadrature::of([Shape::Power { n: scene.n.clone(), c: scene.c.clone() }]).map(Arc::new)
}

/// Errors of the quadratures at a radius.
#[derive(Clone, Copy)]
pub(super) struct Quadratures {
    pub(super) g: f64,
    pub(super) slope: f64,
    pub(super) mean: f64,
}

impl Quadratures {
    pub(super) fn at<R: Arithmetic>(transform: &Quadrature<R, Heights<R>>, n: f64, a: &R) -> Result<Self> {
        Ok(Quadratures {
            g: quadrature(&transform.g_estimate(a)?, n),
            slope: quadrature(&transform.slope_estimate(a)?, n),
            mean: quadrature(&transform.mean_estimate(a)?, n),
        })
    }
}

/// The fold of a power law by its closed form, for checks beside it.
pub(super) struct ClosedFold<R> {
    /// The law for the numerical route.
    pub(super) transform: Arc<Quadrature<R, Heights<R>>>,
    pub(super) tangent: Tangent,
    /// The controlled quantity at the fold.
    pub(super) value: R,
    /// The allowed error of the closed form in ln a_λ, in roundoffs.
    pub(super) radius_error: f64,
    /// The allowed relative error of both routes in the value, in roundoffs.
    pub(super) value_error: f64,
}

impl<R: Arithmetic> ClosedFold<R> {
    pub(super) fn of(trial: &mut Trial<'_>, scene: &Scene<R>, held: Held) -> Result<Self> {
        let state = trial.closed.critical(&scene.contact()?, &held.control())?;
        let tangent = scene.tangent(held.lambda(), &state.contact_radius);
        let transform = transform(scene)?;
        let errors = Quadratures::at(&transform, tangent.n, &state.contact_radius)?;
        let (closed, found) = (tangent.radius(), tangent.found_radius(errors.slope));
        // The value is a difference: its error is on the scale of one of the terms.
        let (value, error, difference) = held.of([
            (state.indentation, tangent.fold_indentation(closed, found, errors.g), tangent.transform() - 1.0),
            (state.force, tangent.fold_force(closed, found, errors.g, errors.mean), tangent.pressed() - 1.0),
        ]);
        let value_error = (error + 32.0) / difference.abs();
        Ok(ClosedFold { transform, tangent, value, radius_error: closed, value_error })
    }

    /// −log₂ of the least distance from the fold, relative to its value, that is `spare` bits above that error.
    pub(super) fn bits(&self, spare: f64) -> f64 {
        f64::from(self.value.precision()) - spare - self.value_error.log2()
    }
}

/// Enters the three quantities and the kind of a fold.
pub(super) fn compare<R: Arithmetic>(
    trial: &mut Trial<'_>,
    closed: &Fold<R>,
    found: &Fold<R>,
    material: &Material<R>,
    tangent: Tangent,
    (closed_radius, found_radius): (f64, f64),
    errors: Quadratures,
) {
    let a = &found.contact_radius;
    let elongation = (a.pi() * a * material.work_of_adhesion() / material.effective_modulus()).times(2).sqrt();
    let force_scale = elongation.clone() * a * material.effective_modulus().clone().times(2);
    let radius_error = (closed.contact_radius.clone() / a).ln() / a.unit_roundoff();
    trial.enter("ln a", radius_error.abs().approx(), closed_radius + found_radius);
    let allowed = tangent.fold_indentation(closed_radius, found_radius, errors.g);
    trial.compare_on("d/Δl", &closed.indentation, &found.indentation, &elongation, allowed);
    let allowed = tangent.fold_force(closed_radius, found_radius, errors.g, errors.mean);
    trial.compare_on("F/2E*aΔl", &closed.force, &found.force, &force_scale, allowed);
    trial.demand("the kind of fold", closed.kind == found.kind);
}

/// A contact on a machine with a fold at a planted radius.
pub(super) struct Machine<R> {
    pub(super) scene: Scene<R>,
    pub(super) stiffness: R,
    /// The planted radius.
    pub(super) radius: f64,
    /// Whether the planted fold is the middle one of three.
    pub(super) middle: bool,
}

impl Trial<'_> {
    /// Draws one. Every third is the middle fold of three: 1/2 < n < 5/2 − √3 and s between the roots of
    /// 3μs² − 2(1−2μ)s + μ = 0, μ = n − 1/2, where D falls with a.
    pub(super) fn machine<R: Arithmetic>(&mut self, round: usize, family: Family, ctx: R::Ctx) -> Machine<R> {
        let middle = round % 3 == 1;
        let exponent = if middle {
            Exponent::Double(0.5 + 10_f64.powf(self.uniform(-2.0, 0.24_f64.log10())))
        } else {
            self.exponent(round / 3, family)
        };
        let share = if middle {
            let mu = exponent.value::<f64>(()) - 0.5;
            let (half, third) = ((1.0 - 2.0 * mu) / (3.0 * mu), 1.0 / 3.0);
            let width = (half * half - third).sqrt();
            let (least, most) = (third / (half + width), half + width);
            // Away from both ends, where two folds merge.
            least * (most / least).powf(self.uniform(0.1, 0.9))
        } else {
            10_f64.powf(self.uniform(-3.0, 3.0))
        };
        let scales = self.scales::<R>(round, exponent);
        let lambda = 1.0 + 2.0 * part(share);
        let scene = self.planted(exponent, lambda, scales, ctx);
        let stiffness = R::from_f64(ctx, 2.0 * scales.e_star / share) * R::from_f64(ctx, scales.radius);
        self.describe_also(format_args!("k = {:e}", stiffness.approx()));
        Machine { scene, stiffness, radius: scales.radius, middle }
    }
}

/// s/(1+s), the part of the compliance that lies in the machine.
pub(super) fn part(share: f64) -> f64 {
    1.0 / (1.0 + 1.0 / share)
}

impl<R: Arithmetic> Machine<R> {
    /// Whether there may be so many folds: three around a planted middle one, one outside 1/2 < n < 5/2 − √3.
    pub(super) fn expects(&self, folds: usize) -> bool {
        let multistable = (0.5..2.5 - 3_f64.sqrt()).contains(&self.scene.n.approx());
        if self.middle { folds == 3 } else { folds == 1 || multistable && folds == 3 }
    }

    /// Checks the log₁₀ of a quantity of some fold that is out of the range of this arithmetic, by the same in an arithmetic
    /// that holds it.
    pub(super) fn is_beyond(&self, trial: &mut Trial<'_>, quantity: Quantity, log10: f64) -> Result<()> {
        const BITS: u32 = 200;
        let precise = |value: &R| Float::with_val(BITS, value.widen());
        let scene = self.scene.map(precise);
        let folds = trial.closed.machine_folds(&scene.contact()?, &precise(&self.stiffness))?;
        let logs = folds.iter().filter_map(|fold| {
            let value = match quantity {
                Quantity::ContactRadius => &fold.contact_radius,
                Quantity::Indentation => &fold.indentation,
                Quantity::Force => &fold.force,
                _ => return None,
            };
            Some(value.clone().abs().ln().approx() / std::f64::consts::LN_10)
        });
        let error = logs.map(|exact| (exact - log10).abs()).fold(f64::INFINITY, f64::min);
        // A logarithm of each input, each with its rounding, over |2n − 1|, and one of the sum.
        let largest = [&scene.c, &scene.e_star, &scene.work, &precise(&self.stiffness)]
            .map(|value| value.clone().ln().approx().abs())
            .into_iter()
            .fold(1.0, f64::max);
        let inputs = 16.0 * largest / (2.0 * scene.n.approx() - 1.0).abs();
        let roundoff = self.scene.n.unit_roundoff().approx();
        trial.enter(format!("log₁₀ of {quantity}"), error / roundoff, inputs + 4.0 * log10.abs());
        trial.demand(format!("{quantity} is out of range"), log10.abs() > 307.0);
        Ok(())
    }

    /// How far the balance of forces may be off at a computed fold of share s = 2E*a/k.
    pub(super) fn balance(&self, share: &R) -> f64 {
        let ln = |x: &R| x.ln().approx();
        let Scene { n, c, e_star, work } = &self.scene;
        let ln_stiffness_length = ln(&self.stiffness) - ln(e_star);
        let ln_ratio = ln(n) + ln(c) - 0.5 * (ln(work) - ln(e_star));
        machine_balance(n.approx(), ln(share), ln_stiffness_length, ln_ratio)
    }
}

/// Roundings of a closed form of the library.
pub(super) const ROUNDINGS: f64 = 40.0;

/// A profile: its name, a length L, a second length b = ratio·L where there is one, and a slope or height over L.
#[derive(Clone)]
pub(super) struct Drawn<R> {
    pub(super) name: &'static str,
    length: R,
    second: R,
    slope: R,
}

impl<R: Arithmetic> Drawn<R> {
    /// The profile of this case, at any scale.
    pub(super) fn draw(trial: &mut Trial<'_>, ctx: R::Ctx) -> Self {
        let name = NAMES[trial.index % NAMES.len()];
        let length = R::from_f64(ctx, 10_f64.powf(trial.uniform(-15.0, 15.0)));
        let ratio = R::from_f64(ctx, 2_f64.powf(trial.uniform(-2.0, 1.0)));
        let slope = R::from_f64(ctx, 2_f64.powf(trial.uniform(-4.0, 1.0)));
        let second = ratio * &length;
        Drawn { name, length, second, slope }
    }

    /// A radius within the profile, off its edge by a fifth or more on the given side.
    ///
    /// # Errors
    /// Parameters out of their domain.
    pub(super) fn radius(&self, trial: &mut Trial<'_>, beyond: bool, ctx: R::Ctx) -> Result<R> {
        let heights = self.heights()?;
        if let Some(end) = heights.outer_radius() {
            return Ok(end * R::from_f64(ctx, trial.uniform(0.05, 0.8)));
        }
        let edge = heights.kinks().into_iter().next().unwrap_or_else(|| self.second.clone());
        let octaves = trial.uniform(0.3, 2.0);
        let octaves = if beyond { octaves } else { -octaves };
        Ok(edge * R::from_f64(ctx, 2_f64.powf(octaves)))
    }

    /// The slope or height over L.
    pub(super) fn steepness(&self) -> R {
        self.slope.clone()
    }
}

impl<R: Real> std::fmt::Display for Drawn<R> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [length, second, slope] = [&self.length, &self.second, &self.slope].map(R::approx);
        write!(f, "{}, L = {length:e}, b = {second:e}, t = {slope:e}", self.name)
    }
}

impl Drawn<f64> {
    /// The drawn profile, exactly, in another arithmetic.
    pub(super) fn lifted<R: Real>(&self, ctx: R::Ctx) -> Drawn<R> {
        let [length, second, slope] = [self.length, self.second, self.slope].map(|value| R::from_f64(ctx, value));
        Drawn { name: self.name, length, second, slope }
    }
}

impl<R: Real> Drawn<R> {
    /// Its shapes, over numbers in which R is a constant.
    pub(super) fn terms<S: Lift<R>>(&self) -> Vec<Shape<S>> {
        let [l, b, t] = [&self.length, &self.second, &self.slope].map(S::lift);
        terms(self.name, |key| match key {
            "slope" => t.clone(),
            "flat" | "cap" | "offset" | "wavelength" => b.clone(),
            "height" | "depth" => t.clone() * &l,
            "amplitude" => b.square() / l.clone().times(32),
            _ => l.clone(),
        })
    }

    /// The profile by its heights.
    pub(super) fn heights(&self) -> Result<Heights<R>>
    where
        R: Lift<R> + Special,
    {
        Heights::new(self.terms::<R>())
    }

    /// The closed form, over numbers in which R is a constant.
    pub(super) fn closed<S: Lift<R> + ClosedReal>(&self) -> Result<Box<dyn Transform<S>>> {
        closed_form(self.terms::<S>())
    }
}
