//! The half-space itself: the pressures of a state in the kernel of Boussinesq. No transform stands on this side.
//!
//! A point force P displaces the surface of an elastic half-space by P/(πE*ρ) at the distance ρ. Around a ring of the radius s
//! ∮ dφ/ρ = 4K(k)/(r + s), k² = 4rs/(r + s)², is 2π/agm(r + s, |r − s|), so that
//!
//! u(r) = (2/E*) ∫₀ᵃ p(s) s/agm(r + s, |r − s|) ds.
//!
//! The method of dimensionality reduction says which pressures those are. That they are right is shown by u = d − f inside, by
//! f − d + u as the gap outside, by the stress intensity √(2E*w) at the edge (Maugis 2000), and by the energy ½∫p(d − f) dA, whose
//! slope along the area of contact at fixed d is w.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use mdr_analytic::PowerLaw;
use mdr_core::calculus::quadrature::tanh_sinh_near_ends;
use mdr_core::calculus::{Estimate, Tolerance, gauss_jacobi};
use mdr_core::contact::{Control, Material, Profile, Result, Shape, Transform};
use mdr_numeric::contact::Contact;
use mdr_numeric::fields::Fields;
use mdr_numeric::profiles::Heights;

use super::common::Drawn;
use crate::trial::Trial;

/// What the pressures, and integrals of them, err by relative to their terms: the quadratures ask for a tenth of it.
const PRESSURE: f64 = 1e-10;

/// Within this part of the contact radius p counts as constant: its square, or 5/4th power for r^(1/4), is below all errors.
const AXIS: f64 = 1e-9;

/// The pressures of a contact of radius a, pressed in by d.
struct Loaded {
    fields: Fields<f64>,
    a: f64,
    d: f64,
    /// |d| and the elongation at the edge together: the size of displacements.
    depth: f64,
    work: f64,
    force: f64,
    /// Radii within the contact at which p may have a logarithm.
    kinks: Vec<f64>,
}

impl Loaded {
    /// The state of a tip at a and d. The work of adhesion is the one that holds it in equilibrium.
    fn new(tip: &Arc<dyn Transform<f64>>, e_star: f64, a: f64, d: f64) -> Result<Self> {
        let elongation = tip.g(&a)? - d;
        let (depth, work) = (d.abs() + elongation.abs(), e_star * elongation.powi(2) / (TAU * a));
        let material = Material::new(e_star, work)?;
        let contact = Contact::half_space(tip, &material, &Control::Indentation);
        let force = contact.force(&a)?;
        let fields = Fields::new(contact, a)?;
        let kinks = tip.kinks().into_iter().filter(|kink| *kink < a).collect();
        Ok(Loaded { fields, a, d, depth, work, force, kinks })
    }

    /// ∫₀ᵃ p(s) s `weight`(s, |r − s|) ds, which is of the size `scale`. The weight may have a logarithm at r.
    ///
    /// In front of the edge s² = a² − q², s ds = −q dq, and p q is smooth in q. Gauss's nodes stay away from q = 0, where s would
    /// round to a; q is that of the rounded s, at which p is evaluated.
    fn integral(&self, r: f64, scale: f64, weight: impl Fn(f64, f64) -> f64) -> Result<Estimate<f64>> {
        let mut ends = self.kinks.clone();
        ends.extend((0.0 < r && r < self.a).then_some(r));
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        let last = ends.last().copied().unwrap_or(0.0);
        let middle = last + (self.a - last) / 2.0;
        ends.push(middle);
        // A narrow piece beside a kink is good to the rounding of its radii only, and small.
        let tolerance = || Tolerance::from(&(PRESSURE / 10.0)).or_error_below(&(PRESSURE / 10.0 * scale));
        let (mut total, mut lower) = (Estimate::exact(0.0), 0.0_f64);
        for upper in ends {
            let (least, most) = (lower.next_up().max(AXIS * self.a), upper.next_down());
            total += &tanh_sinh_near_ends(&lower, &upper, tolerance(), |node| {
                // A node closer to an end than one rounding has a weight far below the error.
                let s = node.x.clamp(least, most);
                let away = match r {
                    r if r == lower => node.from_lower,
                    r if r == upper => node.from_upper,
                    r => (r - s).abs(),
                };
                Ok(self.fields.pressure_estimate(&s)?.value * s * weight(s, away))
            })?;
            lower = upper;
        }
        let reach = leg(self.a, middle);
        let edge = gauss_jacobi::integrate(&0.0, &0.0, tolerance(), |t: &f64| {
            let s = leg(self.a, reach * t);
            Ok(self.fields.pressure_estimate(&s)?.value * leg(self.a, s) * weight(s, (r - s).abs()))
        })?;
        total += &edge.scaled(&reach);
        Ok(total)
    }

    /// u(r).
    fn displacement(&self, e_star: f64, r: f64) -> Result<Estimate<f64>> {
        let integral = self.integral(r, e_star * self.depth, |s, away| 1.0 / agm(r + s, away))?;
        Ok(integral.scaled(&(2.0 / e_star)))
    }

    /// ½∫p(d − f) dA.
    fn energy(&self, e_star: f64, heights: &Heights<f64>) -> Result<Estimate<f64>> {
        let scale = e_star * self.depth.powi(2) * self.a;
        Ok(self.integral(0.0, scale, |s, _| self.d - heights.height(&s))?.scaled(&PI))
    }

    /// −p(s)√(2π(a − s)) for s → a, from two radii; the error falls like the square of the distance.
    fn stress_intensity(&self) -> Result<f64> {
        let at = |distance: f64| -> Result<f64> {
            let s = self.a * (1.0 - distance);
            Ok(-self.fields.pressure_estimate(&s)?.value * (TAU * (self.a - s)).sqrt())
        };
        Ok(2.0 * at(2_f64.powi(-21))? - at(2_f64.powi(-20))?)
    }
}

/// √(x² − y²).
fn leg(x: f64, y: f64) -> f64 {
    ((x - y) * (x + y)).sqrt()
}

/// The arithmetic-geometric mean.
fn agm(mut x: f64, mut y: f64) -> f64 {
    while (x - y).abs() > 1e-9 * x {
        (x, y) = (f64::midpoint(x, y), (x * y).sqrt());
    }
    // The next step has all digits.
    f64::midpoint(x, y)
}

/// A tip by its transform.
type Tip = Arc<dyn Transform<f64>>;

/// A tip of the library, or in every fourth case a power law: its transform, its heights and a radius of contact.
fn tip(trial: &mut Trial<'_>) -> Result<(Tip, Heights<f64>, f64)> {
    if trial.index % 4 == 3 {
        let (n, c) = (trial.uniform(0.25, 5.0), trial.uniform(0.1, 3.0));
        trial.describe(format_args!("n = {n}, C = {c}"));
        let heights = Heights::new([Shape::Power { n, c }])?;
        return Ok((Arc::new(PowerLaw::new(n, c)?), heights, trial.uniform(0.3, 2.0)));
    }
    let profile = Drawn::<f64>::draw(trial, ());
    let a = profile.radius(trial, true, ())?;
    trial.describe(&profile);
    Ok((Arc::from(profile.closed::<f64>()?), profile.heights()?, a))
}

/// One state: u inside, beside a kink and outside, the stress intensity, and the slope of the energy.
pub(super) fn kernel(trial: &mut Trial<'_>) -> Result<()> {
    let (transform, heights, a) = tip(trial)?;
    let e_star = 10_f64.powf(trial.uniform(-9.0, 9.0));
    let g = transform.g(&a)?;
    let elongation = trial.uniform(0.1, 1.0) * transform.slope(&a)?.abs() * a;
    let (inside, outside) = (trial.uniform(0.05, 0.95), trial.uniform(1.02, 1.2));
    trial.describe_also(format_args!(
        "E* = {e_star:e}, a = {a:e}, d = {:e}, r = {inside} a, {outside} a",
        g - elongation
    ));
    let state = Loaded::new(&transform, e_star, a, g - elongation)?;
    let depth = state.depth;

    // Inside, and in turn closer and closer to the outer side of a kink, where the pressure has a logarithm.
    let beside = 2_f64.powi([-24, -33, -42, -51][trial.index / 4 % 4]);
    let close = state.kinks.iter().map(|kink| kink * (1.0 + beside));
    for r in close.chain([inside * a]).collect::<Vec<_>>() {
        let u = state.displacement(e_star, r)?;
        let (expected, scale) = (state.d - heights.height(&r), depth + heights.height(&r).abs());
        trial.enter("u = d − f", ((u.value - expected) / scale).abs(), u.error / scale + PRESSURE);
    }
    let r = outside * a;
    let (u, gap) = (state.displacement(e_star, r)?, state.fields.gap_estimate(&r)?);
    let (height, scale) = (heights.height(&r), depth + heights.height(&r).abs());
    let error = (height - state.d + u.value - gap.value) / scale;
    trial.enter("gap", error.abs(), (u.error + gap.error) / scale + PRESSURE);

    let scale = e_star * depth * a;
    let force = state.integral(0.0, scale, |_, _| TAU)?;
    trial.enter("F = ∫p dA", (force.value - state.force).abs() / scale, force.error / scale + PRESSURE);

    let intensity = (2.0 * e_star * state.work).sqrt();
    trial.enter("K = √(2E*w)", (state.stress_intensity()? / intensity - 1.0).abs(), PRESSURE);

    // Central differences at two steps, and the one that they lead to: it errs by less than what the last step has changed.
    let slope = |step: f64| -> Result<Estimate<f64>> {
        let energy = |a: f64| Loaded::new(&transform, e_star, a, state.d)?.energy(e_star, &heights);
        let (wide, narrow) = (energy(a * (1.0 + step))?, energy(a * (1.0 - step))?);
        let per_area = 1.0 / (2.0 * a * step * TAU * a);
        let noise = (wide.error + narrow.error) * per_area;
        Ok(Estimate { value: (wide.value - narrow.value) * per_area, error: noise, evaluations: 0 })
    };
    let (coarse, fine) = (slope(1.0 / 64.0)?, slope(1.0 / 128.0)?);
    let rate = fine.value + (fine.value - coarse.value) / 3.0;
    let noise = 2.0 * fine.error + PRESSURE * 128.0 * e_star * depth * depth / (TAU * a);
    let allowed = ((fine.value - coarse.value).abs() / 8.0 + noise) / state.work;
    trial.enter("∂U/∂A = w", (rate / state.work - 1.0).abs(), allowed);
    Ok(())
}
