//! Graded half-spaces and Winkler foundations: closed forms against the weight of the transform, against the surface
//! displacement by the kernel of the medium, cos(πk/2)/(πc r^{1+k}) for a point force, and in their own equations.

use mdr_analytic::media::{GradedContact, GradedHalfSpace};
use mdr_core::calculus::quadrature::tanh_sinh_near_ends;
use mdr_core::calculus::roundoff_tolerance;
use mdr_core::contact::{Control, Error, Quantity, Result};
use mdr_core::number::{Dual, Real};
use rug::Float;

use crate::arithmetic::Arithmetic;
use crate::tolerance::{KAPPA, quadrature};
use crate::trial::Trial;

/// Roundings of κ(n, k): three Gamma functions of two each, with arguments that are rounded twice; their logarithmic
/// derivatives times the arguments are below 1 + x|ln x|.
pub(super) fn kappa_roundings(n: f64) -> f64 {
    let argument = 1.0 + n / 2.0;
    KAPPA + 12.0 + 4.0 * (1.0 + argument * (1.0 + argument.ln().abs()))
}

/// The number in 200 bits.
fn wide<R: Arithmetic>(value: &R) -> Float {
    Float::with_val(200, value.widen())
}

/// A contact of the grid: k to both sides of 0, and a radius at which g and Δl are comparable.
struct Drawn<R> {
    n: f64,
    k: f64,
    contact: GradedContact<R>,
    /// n, C, κ, k, c, w, for dual numbers.
    numbers: [R; 6],
}

impl<R: Arithmetic> Drawn<R> {
    fn new(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<Self> {
        let k = if round % 5 == 4 { 1.0 } else { trial.uniform(-0.9, 0.9) };
        let threshold = (1.0 - k) / 2.0;
        let n = if round % 3 == 1 && k < 0.8 {
            threshold * trial.uniform(0.3, 0.9)
        } else {
            threshold + trial.uniform(0.1, 4.0)
        };
        let mut draw = |decades: f64| 10_f64.powf(trial.uniform(-decades, decades));
        let [c, medium, work] = [draw(2.0), draw(6.0), draw(6.0)];
        trial.describe(format_args!("n = {n}, k = {k}, C = {c:e}, c = {medium:e}, w = {work:e} ({})", R::NAME));
        let [n_, k_, c, coefficient, work] = [n, k, c, medium, work].map(|value| R::from_f64(ctx, value));
        let medium = if k == 1.0 {
            GradedHalfSpace::winkler(coefficient / c.pi(), work.clone())?
        } else {
            GradedHalfSpace::new(k_.clone(), coefficient, work.clone())?
        };
        let coefficient = medium.coefficient().clone();
        let contact = GradedContact::new(n_.clone(), c.clone(), medium)?;
        let kappa = contact.profile().kappa().clone();
        Ok(Drawn { n, k, contact, numbers: [n_, c, kappa, k_, coefficient, work] })
    }

    /// The contact over dual numbers, its parameters constant.
    fn dual(&self) -> Result<GradedContact<Dual<R>>> {
        let [n, c, kappa, k, coefficient, work] = self.numbers.each_ref().map(|x| Dual::constant(x.clone()));
        let medium = if self.k == 1.0 {
            let modulus = coefficient.clone() / coefficient.pi();
            GradedHalfSpace::winkler(modulus, work)?
        } else {
            GradedHalfSpace::new(k, coefficient, work)?
        };
        GradedContact::with_kappa(n, c, kappa, medium)
    }

    /// A radius within a factor of e³ of where g' and Δl' balance under a dead load; any, where that is out of range, as for n close
    /// to (1−k)/2.
    fn radius(&self, trial: &mut Trial<'_>) -> Result<R> {
        let near = match self.contact.critical(&Control::Force) {
            Err(Error::OutOfRange { .. }) => self.numbers[0].lit(1),
            state => state?.contact_radius,
        };
        let stretch = R::from_f64(near.ctx(), trial.uniform(-3.0, 3.0) / (self.n + 1.0));
        Ok(near * stretch.exp())
    }

    /// The contact in 200 bits.
    fn wide(&self) -> Result<GradedContact<Float>> {
        let [n, c, _, k, coefficient, work] = self.numbers.each_ref().map(wide);
        let medium = if self.k == 1.0 {
            GradedHalfSpace::winkler(coefficient.clone() / coefficient.pi(), work)?
        } else {
            GradedHalfSpace::new(k, coefficient, work)?
        };
        GradedContact::new(n, c, medium)
    }

    /// A refusal of the energy for range, against the logarithm of the energy of the same state in 200 bits. Its terms are
    /// within S·size², which the difference cancels.
    fn energy_is_beyond(&self, trial: &mut Trial<'_>, log10: f64, state: [&R; 3], terms: f64) -> Result<()> {
        let ([a, d, size], contact) = (state.map(wide), self.wide()?);
        let exact = contact.energy(&a, &d)?.abs();
        let stiffness = contact.medium().punch_stiffness(&a)?;
        let adhesion = a.clone() * &a * a.pi() * contact.medium().work_of_adhesion();
        let cancelled = ((stiffness * &size * &size + adhesion) / &exact).approx();
        let error = (exact.ln().approx() / std::f64::consts::LN_10 - log10).abs();
        let allowed = 4.0 * terms * cancelled + 8.0 * (1.0 + log10.abs());
        trial.enter("log₁₀ of the energy", error / self.numbers[0].unit_roundoff().approx(), allowed);
        trial.demand("the energy is out of range", log10.abs() > 307.0);
        Ok(())
    }

    /// A refusal for range, against the logarithms of the same quantity of states (a, d, F) in 200 bits. The logarithm of a is a
    /// sum of one of each number, each with its rounding, over `excess`, which has one itself: |2n−1+k|, but |n−2| on a machine in
    /// series with springs, whose stiffness grows as that of the contact.
    fn is_beyond(
        &self,
        trial: &mut Trial<'_>,
        (quantity, log10): (Quantity, f64),
        excess: f64,
        states: impl FnOnce(&GradedContact<Float>) -> Result<Vec<[Float; 3]>>,
    ) -> Result<()> {
        let largest = self.numbers.iter().map(|x| x.abs().ln().approx().abs()).fold(1.0, f64::max);
        let states = states(&self.wide()?)?;
        let logs = states.into_iter().filter_map(|[a, d, f]| {
            let value = match quantity {
                Quantity::ContactRadius => a,
                Quantity::Indentation => d,
                Quantity::Force => f,
                _ => return None,
            };
            Some(value.abs().ln().approx() / std::f64::consts::LN_10)
        });
        let error = logs.map(|exact| (exact - log10).abs()).fold(f64::INFINITY, f64::min);
        let allowed = (self.n + 2.0) * (kappa_roundings(self.n) + 40.0 + 16.0 * largest) / excess
            + log10.abs() * (4.0 + 2.0 / excess);
        trial.enter(format!("log₁₀ of {quantity}"), error / self.numbers[0].unit_roundoff().approx(), allowed);
        trial.demand(format!("{quantity} is out of range"), log10.abs() > 307.0);
        Ok(())
    }

    /// Roundings of g, and of Δl with its power.
    fn term_roundings(&self, a: &R) -> f64 {
        kappa_roundings(self.n) + 24.0 + 2.0 * (self.n + 2.0) * a.ln().approx().abs()
    }
}

/// κ(n, k) against quadrature of the transform, (n/2)∫₀¹ t^{n/2−1}(1−t)^{(k−1)/2} dt with t = sin²θ.
pub(super) fn kappa<R: Arithmetic>(trial: &mut Trial<'_>, _round: usize, ctx: R::Ctx) -> Result<()> {
    let (n, k) = (10_f64.powf(trial.uniform(-1.0, 2.0)), trial.uniform(-0.8, 0.95));
    trial.describe(format_args!("n = {n}, k = {k} ({})", R::NAME));
    let [n_, k_] = [n, k].map(|value| R::from_f64(ctx, value));
    let (rise, fall) = (n_.clone().over(2) - n_.lit(1), (k_.clone() - n_.lit(1)).over(2));
    let weight = |t: &R, rest: &R| t.pow(&rise) * rest.pow(&fall);
    let zero = n_.lit(0);
    let integral = tanh_sinh_near_ends(&zero, &n_.lit(1), &roundoff_tolerance(&n_), |node| {
        Ok(weight(&node.from_lower, &node.from_upper))
    })?;
    // What lies between 0 and the least normal double is t^{n/2} of the whole, below rounding for n ≥ 1/10.
    let found = trial.closed.graded_kappa(&n_, &k_)?;
    let expected = integral.value.clone() * &n_.over(2);
    let allowed = kappa_roundings(n) + 8.0 + quadrature(&integral, n);
    trial.compare("κ(n, k)", &found, &expected, allowed);
    Ok(())
}

/// d', F', ∂Π/∂d = F, ∂²Π/∂d² = S and ∂Π/∂a = 0 by dual numbers, at a radius along the equilibria.
pub(super) fn states<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let drawn: Drawn<R> = Drawn::new(trial, round, ctx)?;
    let (contact, dual) = (&drawn.contact, drawn.dual()?);
    let medium = contact.medium();
    let a = drawn.radius(trial)?;
    let terms = drawn.term_roundings(&a);
    let (lifted, variable) = (Dual::constant(a.clone()), Dual::variable(a.clone()));

    let stiffness = trial.closed.graded_stiffness(medium, &a)?;
    let elongation = trial.closed.graded_elongation(medium, &a)?;
    let g = trial.closed.graded_indentation(contact, &a)? + &elongation;
    let size = g.clone() + &elongation;
    let slope = trial.closed.graded_indentation_slope(contact, &a)?;
    let per_radius = size.clone() * R::from_f64(ctx, drawn.n + 2.0) / &a;
    let exact = dual.indentation(&variable)?.slope;
    trial.compare_on("d'", &slope, &exact, &per_radius, 2.0 * terms);
    let slope = trial.closed.graded_force_slope(contact, &a)?;
    let exact = dual.force(&variable)?.slope;
    trial.compare_on("F'", &slope, &exact, &(per_radius.clone() * &stiffness), 4.0 * terms);

    // The transform itself, so that a fault in d or in Δl cannot hide in their sum.
    let transform = contact.profile().kappa().clone() * &drawn.numbers[1] * a.pow(&drawn.numbers[0]);
    trial.compare_on("g", &g, &transform, &size, 4.0 * terms);

    let d = trial.closed.graded_indentation(contact, &a)?;
    let force = trial.closed.graded_force(contact, &a)?;
    let by_depth = match trial.closed.graded_energy(&dual, &lifted, &Dual::variable(d.clone())) {
        Err(Error::OutOfRange { quantity: Quantity::Energy, log10 }) => {
            return drawn.energy_is_beyond(trial, log10, [&a, &d, &size], terms);
        }
        energy => energy?.slope,
    };
    trial.compare_on("∂Π/∂d", &by_depth, &force, &(stiffness.clone() * &size), 4.0 * terms);
    // Π is a quadratic function of d: S is twice the difference quotient of the slope.
    let shifted = trial.closed.graded_energy(&dual, &lifted, &Dual::variable(d.clone() + &size))?.slope;
    trial.compare_on(
        "∂²Π/∂d²",
        &(shifted - &by_depth),
        &(stiffness.clone() * &size),
        &(stiffness.clone() * &size),
        8.0 * terms,
    );
    let by_radius = trial.closed.graded_energy(&dual, &variable, &Dual::constant(d))?.slope;
    let scale = stiffness * size.square() * R::from_f64(ctx, drawn.n + 2.0) / &a;
    trial.compare_on("∂Π/∂a", &by_radius, &a.lit(0), &scale, 16.0 * terms);
    Ok(())
}

/// Critical states and folds of a machine in the equations of the curve; C of the threshold at n = (1−k)/2.
///
/// a is a power 1/(2n−1+k) of a quotient of about 40 roundings beside κ², and of one rounded logarithm. On a machine it is found
/// in ln s, to a few roundings of its terms, whose condition is bounded by that of the balance: it is compared in the equation.
pub(super) fn folds<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let drawn: Drawn<R> = Drawn::new(trial, round, ctx)?;
    let contact = &drawn.contact;
    let excess = (2.0 * drawn.n - 1.0 + drawn.k).abs();
    let on_curve = |trial: &mut Trial<'_>, name: &str, [a, d, f]: [&R; 3], tolerance: f64, slope: R| -> Result<()> {
        let elongation = contact.medium().detachment_elongation(a)?;
        let size = contact.indentation(a)?.abs() + elongation.times(2);
        let stiffness = contact.medium().punch_stiffness(a)?;
        trial.compare_on(format!("d {name}"), d, &contact.indentation(a)?, &size, tolerance);
        trial.compare_on(format!("F {name}"), f, &contact.force(a)?, &(stiffness * &size), tolerance);
        let per_radius = size / a;
        trial.compare_on(format!("slope {name}"), &slope, &a.lit(0), &per_radius, tolerance);
        Ok(())
    };
    let controls = if drawn.k == 1.0 { vec![Control::Force] } else { vec![Control::Indentation, Control::Force] };
    for control in controls {
        let state = match trial.closed.graded_critical(contact, &control) {
            Err(Error::OutOfRange { quantity, log10 }) => {
                let held = if control == Control::Force { Control::Force } else { Control::Indentation };
                drawn.is_beyond(trial, (quantity, log10), excess, |wide| {
                    let state = wide.critical(&held)?;
                    Ok(vec![[state.contact_radius, state.indentation, state.force]])
                })?;
                continue;
            }
            state => state?,
        };
        let a = &state.contact_radius;
        let radius = (40.0 + 2.0 * kappa_roundings(drawn.n)) / excess + 2.0 * a.ln().approx().abs() + 2.0;
        let allowed = 2.0 * (drawn.n + 2.0) * radius + drawn.term_roundings(a) * 4.0;
        let slope = match control {
            Control::Indentation => contact.indentation_slope(a)?,
            _ => contact.force_slope(a)? / &contact.medium().punch_stiffness(a)?,
        };
        on_curve(trial, control.kind().symbol(), [a, &state.indentation, &state.force], allowed, slope)?;
    }

    // A stiffness comparable to that of the contact at the fold.
    let near = match contact.critical(&Control::Force) {
        Err(Error::OutOfRange { .. }) => return threshold(trial, &drawn),
        state => state?.contact_radius,
    };
    let stretch = R::from_f64(ctx, trial.uniform(-3.0, 3.0));
    let stiffness = contact.medium().punch_stiffness(&near)? * stretch.exp();
    let folds = match trial.closed.graded_machine_folds(contact, &stiffness) {
        Err(Error::OutOfRange { quantity, log10 }) => {
            let stiffness = wide(&stiffness);
            let excess = if drawn.k == 1.0 { excess.min((drawn.n - 2.0).abs()) } else { excess };
            drawn.is_beyond(trial, (quantity, log10), excess, |wide| {
                let folds = wide.machine_folds(&stiffness)?.into_iter();
                Ok(folds.map(|fold| [fold.contact_radius, fold.indentation, fold.force]).collect())
            })?;
            return threshold(trial, &drawn);
        }
        folds => folds?,
    };
    let bound = (5.0 - drawn.k) / 2.0 - ((1.0 - drawn.k) * (3.0 + drawn.k)).max(0.0).sqrt();
    let (below, number) = (drawn.n < (1.0 - drawn.k) / 2.0, folds.len());
    let may = if drawn.k == 1.0 {
        if drawn.n < 2.0 { number % 2 == 0 && number <= 2 } else { number == 1 }
    } else {
        number == 1 || (number == 3 && !below && drawn.n < bound)
    };
    trial.demand("the number of folds on a machine", may);
    for fold in &folds {
        let a = &fold.contact_radius;
        let punch = contact.medium().punch_stiffness(a)?;
        let slope =
            (contact.indentation_slope(a)? * &stiffness + contact.force_slope(a)?) / (stiffness.clone() + &punch);
        // ln s and its terms, each to a few roundings: μu, L, ln λ.
        let logarithms = a.ln().abs()
            + stiffness.ln().abs()
            + contact.medium().coefficient().ln().abs()
            + contact.profile().coefficient().ln().abs()
            + contact.medium().work_of_adhesion().ln().abs();
        let allowed =
            8.0 * (drawn.n + 2.0) * (20.0 + 4.0 * logarithms.approx() * (1.0 + excess)) + drawn.term_roundings(a) * 8.0;
        on_curve(trial, "on a machine", [a, &fold.indentation, &fold.force], allowed, slope)?;
    }
    threshold(trial, &drawn)
}

/// At n = (1−k)/2 and the threshold, d (or F) is zero at every radius.
fn threshold<R: Arithmetic>(trial: &mut Trial<'_>, drawn: &Drawn<R>) -> Result<()> {
    if drawn.k == 1.0 {
        return Ok(());
    }
    let medium = drawn.contact.medium();
    for control in [Control::Indentation, Control::Force] {
        let c = trial.closed.graded_threshold(medium, &control)?;
        let n = (c.lit(1) - medium.grading()).over(2);
        let tip = GradedContact::new(n, c.clone(), medium.clone())?;
        let a = R::from_f64(c.ctx(), 10_f64.powf(trial.uniform(-3.0, 3.0)));
        let size = medium.detachment_elongation(&a)?;
        let held = match control {
            Control::Indentation => tip.indentation(&a)?,
            _ => tip.force(&a)? / medium.punch_stiffness(&a)?,
        };
        let factor = (3.0 + drawn.k) / (1.0 - drawn.k);
        let allowed = factor * (2.0 * kappa_roundings(1.0) + 40.0 + 4.0 * a.ln().approx().abs());
        trial.compare_on(format!("threshold ({})", control.kind().symbol()), &held, &a.lit(0), &size, allowed);
    }
    Ok(())
}

/// The pressure of the contact of a paraboloid or of r⁴ in the kernel of the medium: the surface takes the shape of the profile.
///
/// Around a point at r₀ the displacement is A∫dφ∫p ρ^{−k} dρ. The angle is summed by midpoints, which converge as fast as
/// a geometric series, the ratio that of an ellipse in which ρ is analytic; the rest is what the quadratures say.
pub(super) fn kernel(trial: &mut Trial<'_>) -> Result<()> {
    let (n, k) = ([2.0, 4.0][trial.index % 2], trial.uniform(-0.6, 0.7));
    let (a, share) = (trial.uniform(0.5, 2.0), trial.uniform(0.1, 0.5));
    let [c, medium, work] = [(); 3].map(|()| trial.uniform(0.2, 3.0));
    trial.describe(format_args!("n = {n}, k = {k}, C = {c}, c = {medium}, w = {work}, a = {a}, r = {share} a"));
    let half_space = GradedHalfSpace::new(k, medium, work)?;
    let contact = GradedContact::new(n, c, half_space)?;
    let depth = trial.closed.graded_indentation(&contact, &a)?;
    let elongation = contact.medium().detachment_elongation(&a)?;
    let kappa = trial.closed.graded_kappa(&n, &k)?;
    // p(r) of §3 with y = a² − r²: ∫ g'(x)(x²−r²)^{(k−1)/2} dx is elementary for even n.
    let pressure = |square: f64, y: f64| {
        let pressed = if n == 2.0 {
            2.0 * y.powf((k + 1.0) / 2.0) / (k + 1.0)
        } else {
            4.0 * (y.powf((k + 3.0) / 2.0) / (k + 3.0) + square * y.powf((k + 1.0) / 2.0) / (k + 1.0))
        };
        medium / std::f64::consts::PI * (kappa * c * pressed - elongation * y.powf((k - 1.0) / 2.0))
    };
    let kernel = (std::f64::consts::FRAC_PI_2 * k).cos() / (std::f64::consts::PI * medium);
    let r = share * a;
    const ANGLES: u32 = 96;
    let (mut displacement, mut size, mut error) = (0.0, 0.0, 0.0);
    for step in 0..ANGLES {
        let angle = std::f64::consts::PI * (f64::from(step) + 0.5) / f64::from(ANGLES);
        let (sine, cosine) = angle.sin_cos();
        let leg = (a * a - (r * sine).powi(2)).sqrt();
        let (reach, back) = (leg - r * cosine, leg + r * cosine);
        let integral = tanh_sinh_near_ends(&0.0, &reach, &1e-13, |node| {
            let y = node.from_upper * (node.from_lower + back);
            Ok(pressure(a * a - y, y) * node.from_lower.powf(-k))
        })?;
        displacement += integral.value;
        size += integral.value.abs();
        error += integral.error;
    }
    let weight = 2.0 * std::f64::consts::PI / f64::from(ANGLES) * kernel;
    let expected = depth - c * r.powf(n);
    let scale = size * weight + depth.abs() + c * r.powf(n);
    // The power y^{(k−1)/2} of a rounded y near the rim errs by its rounding; midpoints by e^{−96 η}, cosh η = 1/share ≥ 2.
    let allowed = (error * weight / scale) + 1e-12;
    trial.enter("u(r) = d − f(r)", ((displacement * weight - expected) / scale).abs(), allowed);
    Ok(())
}
