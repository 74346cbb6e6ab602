//! The wave of Johnson (1995): closed forms against the displacement by the periodic kernel, −(2/π)∫q ln|2 sin(X − S)| dS, the
//! energy by the pressure, the release rate by dual numbers, losses as its integral, folds in their equations and by a scan.

use mdr_analytic::media::{JohnsonWave, WaveControl, WaveState};
use mdr_core::calculus::quadrature::{tanh_sinh, tanh_sinh_near_ends};
use mdr_core::calculus::roundoff_tolerance;
use mdr_core::contact::{Material, Result};
use mdr_core::number::{Dual, Precision, Real, Special};
use rug::Float;

use crate::arithmetic::Arithmetic;
use crate::trial::Trial;

/// Gap, mean pressure, energy and pressure at a place against the kernel, with twice the digits of the case: near the edge the
/// pressure loses half of them to the rounding of its place.
///
/// The unit of errors is relative; `allowed` is 2^{-bits} of the case times the sums of the terms.
pub(super) fn kernel(trial: &mut Trial<'_>) -> Result<()> {
    let bits = trial.precision;
    let working = Precision::new(2 * bits.bits() + 32);
    let (alpha, angle, pressure) =
        (10_f64.powf(trial.uniform(-2.0, 1.0)), trial.uniform(0.1, 1.4), trial.uniform(-1.0, 1.0));
    let (inside, outside) = (trial.uniform(-0.95, 0.95), trial.uniform(0.05, 0.95));
    trial.describe(format_args!("α = {alpha}, ψ = {angle}, P = {pressure}, X = {inside} ψ, {outside} of the gap"));
    let number = |x: f64| Float::with_val(working.bits(), x);
    let wave = JohnsonWave::of_alpha(number(alpha))?;
    let angle = number(angle);
    let state = wave.held(&angle, &number(pressure))?;
    let goal = Float::with_val(working.bits(), 1) >> bits.bits();
    // S = ψ sin φ takes the root out of the ends; the pressure at S is that under test.
    let half_pi = angle.pi().over(2);
    let stress = |trial: &Trial<'_>, phi: &Float| -> Result<(Float, Float)> {
        let place = phi.clone().sin() * &angle;
        let weight = phi.clone().cos() * &angle;
        // Where S rounds to the edge the weight is 2^{-bits} of the case.
        if place.clone().abs() >= angle {
            return Ok((place.clone(), place.lit(0)));
        }
        Ok((place.clone(), trial.closed.wave_pressure_at(&state, &place)? * weight))
    };
    let allowed = 1e3 * goal.approx();
    let mean = tanh_sinh(&-half_pi.clone(), &half_pi, &goal, |phi| Ok(stress(trial, phi)?.1))?;
    let mean = mean.value / angle.pi();
    trial.enter("mean pressure", (mean - &state.pressure).abs().approx(), allowed);

    let gap = trial.closed.wave_held_gap(&wave, &angle, &state.pressure)?;
    let beneath = |place: &Float| place.sin().square().times(2) - place.lit(1) + &gap;
    // u = 1 − H − 2 sin²X in the contact, and the mean of u is zero: U = (1/2π)∫ q u dS.
    let energy = tanh_sinh(&-half_pi.clone(), &half_pi, &goal, |phi| {
        let (place, stress) = stress(trial, phi)?;
        Ok(-beneath(&place) * stress)
    })?;
    let energy = energy.value.over(2) / angle.pi();
    let closed = trial.closed.wave_elastic_energy(&state)?;
    trial.enter("U", ((energy.clone() - closed) / &energy).abs().approx(), allowed / energy.approx().abs());

    let displacement = |trial: &Trial<'_>, place: &Float| -> Result<Float> {
        let middle = (place.clone() / &angle).asin();
        let within = place.abs() < angle;
        let ends = if within {
            vec![-half_pi.clone(), middle, half_pi.clone()]
        } else {
            vec![-half_pi.clone(), half_pi.clone()]
        };
        let mut sum = angle.lit(0);
        for (piece, pair) in ends.windows(2).enumerate() {
            let integral = tanh_sinh_near_ends(&pair[0], &pair[1], &goal, |node| {
                let (source, stress) = stress(trial, &node.x)?;
                // Beside the place X − S = 2ψ sin((φ₀−φ)/2) cos((φ₀+φ)/2).
                let away = if piece == 0 { &node.from_upper } else { &node.from_lower };
                let apart = if within {
                    let end = if piece == 0 { &pair[1] } else { &pair[0] };
                    (away.clone().over(2).sin() * (node.x.clone() + end).over(2).cos() * &angle).times(2).abs()
                } else {
                    (place.clone() - source).abs()
                };
                Ok(-(apart.sin().times(2).ln()) * stress)
            })?;
            sum += &integral.value;
        }
        Ok(sum.times(2) / angle.pi())
    };
    let place = number(inside) * &angle;
    let flat = beneath(&place) + displacement(trial, &place)?;
    trial.enter("gap in the contact", flat.abs().approx(), 4.0 * allowed);
    let place = angle.clone() + number(outside) * (half_pi.clone() - &angle);
    let opened = beneath(&place) + displacement(trial, &place)?;
    let closed = trial.closed.wave_gap_at(&state, &place)?;
    trial.enter(
        "gap outside",
        (opened - &closed).abs().approx() / closed.approx().abs(),
        4.0 * allowed / closed.approx().abs(),
    );
    Ok(())
}

/// P, H of the equilibrium, with G = w; dΠ along the release rate; scales of a wave with units; a flaw; energy of a state.
pub(super) fn states<R: Arithmetic>(trial: &mut Trial<'_>, _round: usize, ctx: R::Ctx) -> Result<()> {
    let mut draw = |decades: f64| 10_f64.powf(trial.uniform(-decades, decades));
    let [amplitude, stretch, e_star, spring] = [draw(6.0), draw(1.0), draw(6.0), draw(6.0)];
    let (alpha, angle, pressure) =
        (10_f64.powf(trial.uniform(-2.0, 0.3)), trial.uniform(0.05, 1.5), trial.uniform(-1.0, 1.0));
    trial.describe(format_args!(
        "α ≈ {alpha}, ψ = {angle}, P = {pressure}, h₀ = {amplitude:e}, E* = {e_star:e} ({})",
        R::NAME
    ));
    let [h, l, e, k, alpha, angle, pressure] =
        [amplitude, amplitude * (2.0 + stretch), e_star, spring, alpha, angle, pressure]
            .map(|value| R::from_f64(ctx, value));
    // w from α, so that the numbers without units are moderate; then α once more from w.
    let work = (alpha.square() * alpha.pi().square() * h.square() * &e / &l).over(2);
    let material = Material::new(e.clone(), work.clone())?;
    trial.compare("α", &trial.closed.wave_alpha(&h, &l, &material)?, &alpha, 24.0);
    let wave = JohnsonWave::new(h.clone(), l.clone(), material)?;
    let unit = h.pi() * &e * &h / &l;
    trial.compare("p*", &trial.closed.wave_closing_pressure(&wave)?, &unit, 12.0);
    // κ = p*/(Kh₀).
    trial.compare("κ", &trial.closed.wave_compliance(&wave, &k)?, &(unit / &k / &h), 20.0);

    let [found, gap] = trial.closed.wave_state(&wave, &angle)?;
    let (sine, cosine) = angle.sin_and_cos();
    let elongation = wave.alpha().clone() * (sine.clone() / &cosine).sqrt();
    let scale = sine.square() + &elongation;
    trial.compare_on("P", &found, &(sine.square() - &elongation), &scale, 24.0);
    let ln_share = sine.ln().times(2);
    let expected = cosine.square() + found.clone() * &ln_share;
    let scale = cosine.square() + (found.abs() + &elongation) * (ln_share.abs() + angle.lit(1));
    trial.compare_on("H", &gap, &expected, &scale, 60.0);
    let place = angle.clone() * &l / angle.pi();
    let [width_pressure, width_gap] = trial.closed.wave_state_at_half_width(&wave, &place)?;
    // ψ is rounded thrice; P and H vary by 4(s + α√t)/sin 2ψ and as much times ln s.
    let moved = (scale.clone() * R::from_f64(ctx, 8.0)) / (sine * cosine);
    trial.compare_on("P(a)", &width_pressure, &found, &moved, 60.0);
    trial.compare_on("H(a)", &width_gap, &gap, &moved, 60.0);
    let flaw = l.clone().over(2) - &place;
    let moved = moved * (l / &flaw);
    let [flaw_pressure, flaw_gap] = trial.closed.wave_state_with_flaw(&wave, &flaw)?;
    trial.compare_on("P(flaw)", &flaw_pressure, &found, &moved, 60.0);
    trial.compare_on("H(flaw)", &flaw_gap, &gap, &moved, 60.0);

    let equilibrium = wave.state(&angle)?;
    let condition = (scale / &elongation).approx();
    trial.compare("G", &trial.closed.wave_release_rate(&equilibrium)?, &angle.lit(1), 80.0 * (1.0 + condition));
    // Under a fixed P the potential changes by (G/w − 1)α² with ψ; Π differs from it by PH.
    let lifted = JohnsonWave::of_alpha(Dual::constant(wave.alpha().clone()))?;
    let state = lifted.held(&Dual::variable(angle.clone()), &Dual::constant(pressure.clone()))?;
    let potential = trial.closed.wave_load_potential(&state)?;
    let square = wave.alpha().square();
    let driven = trial.closed.wave_release_rate(&state)?.value * &square;
    let scale =
        (driven.abs() + &square) + equilibrium.angle.cos() / equilibrium.angle.sin() * angle.lit(4) + angle.lit(4);
    trial.compare_on("dΠ/dψ", &potential.slope, &(driven - &square), &scale, 200.0);
    let plain = wave.held(&angle, &pressure)?;
    let energy = trial.closed.wave_energy(&plain)?;
    let rest = energy.clone() + pressure * &plain.mean_gap;
    let scale = energy.abs() + plain.mean_gap.abs() + square * &angle + angle.lit(1);
    trial.compare_on("Π + PH", &rest, &potential.value, &scale, 60.0);
    Ok(())
}

/// The controls of the grid.
fn control<R: Real>(round: usize, ctx: R::Ctx) -> (f64, WaveControl<R>) {
    const COMPLIANCES: [f64; 7] = [f64::INFINITY, 0.0, 0.4, 1.5, 1.8, 4.0, 40.0];
    let compliance = COMPLIANCES[round % COMPLIANCES.len()];
    if compliance.is_infinite() {
        (compliance, WaveControl::Load)
    } else {
        (compliance, WaveControl::Approach { compliance: R::from_f64(ctx, compliance) })
    }
}

/// What is controlled, at a state.
fn controlled<R: Special>(state: &WaveState<R>, compliance: Option<&R>) -> R {
    match compliance {
        None => state.pressure.clone(),
        Some(compliance) => state.pressure.lit(1) - &state.mean_gap + state.pressure.clone() * compliance,
    }
}

/// Folds: the controlled quantity is stationary by dual numbers, P and H are those of the curve, and a scan in ln tan²ψ turns as
/// often. First touch: the controlled quantity is zero. Losses are integrals of (1 − G/w)α² at the controlled quantity.
pub(super) fn folds<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let (compliance, control) = control::<R>(round, ctx);
    let alpha = [0.05, 0.2, 0.35, 0.5][round / 7 % 4] * trial.uniform(0.8, 1.1);
    trial.describe(format_args!("α = {alpha}, κ = {compliance} ({})", R::NAME));
    let wave = JohnsonWave::of_alpha(R::from_f64(ctx, alpha))?;
    let lifted = JohnsonWave::of_alpha(Dual::constant(wave.alpha().clone()))?;
    let held = match &control {
        WaveControl::Load => None,
        WaveControl::Approach { compliance } => Some(compliance.clone()),
    };
    let dual = held.as_ref().map(|compliance| Dual::constant(compliance.clone()));
    let size = |angle: &R| {
        let share = angle.sin().ln().abs().times(2) + angle.lit(2);
        share * (held.clone().unwrap_or_else(|| angle.lit(0)) + angle.lit(1))
    };
    let folds = trial.closed.wave_folds(&wave, &control)?;
    for fold in &folds {
        let angle = &fold.contact_radius;
        let slope = controlled(&lifted.state(&Dual::variable(angle.clone()))?, dual.as_ref()).slope;
        let state = wave.state(angle)?;
        // ψ errs by 40 roundings of v = ln tan²ψ, |v| < 40; the curvature is below 8/(ψ(π/2 − ψ))² times the size.
        let room = angle.clone() * (angle.pi().over(2) - angle);
        let per_angle = size(angle) / &room;
        trial.compare_on("slope at the fold", &slope, &angle.lit(0), &per_angle, 8.0 * 40.0 * 8.0);
        trial.compare_on("P", &fold.force, &state.pressure, &size(angle), 100.0);
        trial.compare_on("H", &fold.indentation, &state.mean_gap, &size(angle), 200.0);
    }
    trial.demand("as many folds as turns of a scan", folds.len() == turns(alpha, compliance)?);

    let touching = trial.closed.wave_touching(&wave, &control)?;
    let angle = &touching.contact_radius;
    let state = wave.state(angle)?;
    let per_angle = size(angle);
    trial.compare_on("held at first touch", &controlled(&state, held.as_ref()), &angle.lit(0), &per_angle, 800.0);
    trial.compare_on("P at first touch", &touching.force, &state.pressure, &per_angle, 200.0);
    trial.compare_on("H at first touch", &touching.indentation, &state.mean_gap, &per_angle, 200.0);
    losses(trial, &wave, (&control, held.as_ref()), &state)
}

/// The turns of the controlled quantity in a scan of f64.
fn turns(alpha: f64, compliance: f64) -> Result<usize> {
    let wave = JohnsonWave::of_alpha(alpha)?;
    let compliance = compliance.is_finite().then_some(compliance);
    let mut values = Vec::new();
    for step in -1000..1000 {
        let angle = (f64::from(step) / 50.0).exp().sqrt().atan();
        values.push(controlled(&wave.state(&angle)?, compliance.as_ref()));
    }
    Ok(values.windows(3).filter(|w| (w[1] - w[0]) * (w[2] - w[1]) < 0.0).count())
}

fn losses<R: Arithmetic>(
    trial: &mut Trial<'_>,
    wave: &JohnsonWave<R>,
    (control, held): (&WaveControl<R>, Option<&R>),
    touching: &WaveState<R>,
) -> Result<()> {
    let square = wave.alpha().square();
    let goal = roundoff_tolerance(&square);
    let end = &touching.angle;
    // D = 0: P = −s/(κ − ln s); P = 0 under a load.
    let integral = tanh_sinh(&end.lit(0), end, &goal, |angle| {
        let share = angle.sin().square();
        let pressure = match held {
            None => share.lit(0),
            Some(compliance) => -share.clone() / (compliance.clone() - share.ln()),
        };
        Ok((square.lit(1) - wave.held(angle, &pressure)?.release_rate()) * &square)
    })?;
    let found = trial.closed.wave_lost_at_touch(wave, control)?;
    // Differences of energies of the order of α²ψ, and the end errs little: the integrand is zero there.
    let scale = square.clone() * end;
    let cost = integral.evaluations as f64 + (integral.error / &scale / scale.unit_roundoff()).approx();
    trial.compare_on("loss at first touch", &found, &integral.value, &scale, 400.0 + cost * 4.0);
    if let Some(compliance) = held {
        let fold = wave.folds(control)?.remove(0).state;
        let lost = trial.closed.wave_lost_at_pull_off(wave, compliance)?;
        let expected = fold.elastic_energy() - square * &fold.angle + (fold.pressure.square() * compliance).over(2);
        trial.compare_on("loss at pull-off", &lost, &expected, &(expected.abs() + &scale), 100.0);
        return Ok(());
    }
    let fold = wave.folds(control)?.remove(1).state;
    let lost = trial.closed.wave_lost_at_complete_contact(wave)?;
    // In χ = π/2 − ψ: G/w = tan χ (s − P)²/α², s = cos²χ.
    let far = fold.angle.pi().over(2) - &fold.angle;
    let integral = tanh_sinh(&far.lit(0), &far, &goal, |chi| {
        let (sine, cosine) = chi.sin_and_cos();
        let rate = (cosine.square() - &fold.pressure).square() * sine / cosine;
        Ok(square.clone() - rate)
    })?;
    let scale = square * &far;
    let condition = (scale.clone() / &lost).abs().approx();
    trial.compare(
        "loss at complete contact",
        &lost,
        &integral.value,
        condition * (400.0 + 4.0 * integral.evaluations as f64),
    );
    Ok(())
}

/// α₁, α₀, 1/√(2π), 3 − ln 4 and α₁(κ), each from what it means.
pub(super) fn thresholds(trial: &mut Trial<'_>) -> Result<()> {
    let one = Float::with_val(trial.precision.bits(), 1);
    let compliance = one.clone() * (1.7 + 10_f64.powf(trial.uniform(-1.0, 2.0)));
    trial.describe(format_args!("κ = {}", compliance.to_f64()));
    let small = one.clone() >> 44_u32;
    // P is stationary with a zero curvature at sin²ψ = 3/8 and α₁: P' = P'' = 0.
    let alpha = trial.closed.wave_load_threshold(&one)?;
    let angle = (one.ratio(3, 5)).sqrt().atan();
    let nested = Dual::variable(Dual::variable(angle));
    let constant = |x: &Float| Dual::constant(Dual::constant(x.clone()));
    let pressure = JohnsonWave::of_alpha(constant(&alpha))?.state(&nested)?.pressure;
    trial.compare_on("P' at α₁", &pressure.slope.value, &one.lit(0), &one, 200.0);
    trial.compare_on("P'' at α₁", &pressure.slope.slope, &one.lit(0), &one, 2000.0);
    // P touches 0 at tan²ψ = 3 and α₀.
    let alpha = trial.closed.wave_touch_threshold(&one)?;
    let angle = one.pi().over(3);
    let pressure = JohnsonWave::of_alpha(Dual::constant(alpha))?.state(&Dual::variable(angle.clone()))?.pressure;
    trial.compare_on("P at α₀", &pressure.value, &one.lit(0), &one, 200.0);
    trial.compare_on("P' at α₀", &pressure.slope, &one.lit(0), &one, 200.0);
    // Complete contact has the energy 1/4 − πα²/2: that of ψ → π/2 without a load, within α² of the rest of the angle.
    let alpha = trial.closed.wave_energy_threshold(&one)?;
    let angle = one.pi().over(2) - (one.clone() >> (trial.precision.bits() / 2));
    let state = JohnsonWave::of_alpha(alpha)?.held(&angle, &one.lit(0))?;
    let rest = (one.pi().over(2) - &angle).approx();
    trial.enter(
        "energy of complete contact",
        state.energy().abs().approx() / one.unit_roundoff().approx(),
        rest / one.unit_roundoff().approx() + 100.0,
    );
    // ln s + 4(1 − s) is largest at s = 1/4, where it is 3 − ln 4.
    let share = Dual::variable(one.ratio(1, 4));
    let least = share.ln() + (share.lit(1) - &share).times(4);
    let closed = trial.closed.least_compliance(&one)?;
    trial.compare("least compliance", &closed, &least.value, 20.0);
    trial.compare_on("its slope", &least.slope, &one.lit(0), &one, 20.0);
    // Folds merge at α₁(κ).
    let alpha = trial.closed.wave_approach_threshold(&compliance)?;
    let control = WaveControl::Approach { compliance };
    for (offset, number) in [(one.clone() - &small, 2), (one.clone() + &small, 0)] {
        let folds = JohnsonWave::of_alpha(alpha.clone() * offset)?.folds(&control)?;
        trial.demand(format!("{number} folds beside α₁(κ)"), folds.len() == number);
    }
    Ok(())
}
