//! `mdr_analytic::double` along the equilibria: κ_n, g, d(a), F(a), their slopes, energy, universal curves.

use std::f64::consts::PI;

use mdr_analytic::{Contact, Kappa, PowerLaw, double};
use mdr_core::contact::{Material, Ranged, Result, Transform};
use mdr_core::number::Real;

use super::questions::{Climb, Direction, Subject, cross, decades, halvings, subject};
use super::{Family, naive};
use crate::Level;

/// The contact of [n, C, E*, w, …].
pub(super) fn contact<R: Kappa>(x: &[R]) -> Result<Contact<R>> {
    Ok(Contact::new(PowerLaw::new(x[0].clone(), x[1].clone())?, material(&x[2..])?))
}

/// The material of [E*, w, …].
pub(super) fn material<R: Real>(x: &[R]) -> Result<Material<R>> {
    Material::new(x[0].clone(), x[1].clone())
}

/// The inputs of questions about a power law, and about one on a machine.
pub(super) const LAW: &[&str] = &["n", "C", "E*", "w"];
pub(super) const MACHINE: &[&str] = &["n", "C", "E*", "w", "k"];

/// [n, C, E*, w].
pub(super) fn law(x: &[f64]) -> [f64; 4] {
    [x[0], x[1], x[2], x[3]]
}

/// The C with which the state of tangency λ has the radius 1 on E* = w = 1.
pub(super) fn planted(n: f64, tension: f64) -> f64 {
    tension * (PI / 2.0).sqrt() / (n * mdr_analytic::kappa(&n).unwrap_or(f64::NAN))
}

const KAPPA: &[&str] = &["n"];
const UNIVERSAL: &[&str] = &["n", "a/a_c"];
const POWER: &[&str] = &["n", "C", "x"];
const EDGE: &[&str] = &["E*", "w", "a"];
const STATE: &[&str] = &["n", "C", "E*", "w", "a"];
const ENERGY: &[&str] = &["n", "C", "E*", "w", "a", "d"];

fn kappa() -> [Subject; 2] {
    [
        subject!("double::kappa", KAPPA, |x| double::kappa(x[0]).map(Ranged::Value), |y| mdr_analytic::kappa(&y[0]),
            naive "√π Γ(1+n/2)/Γ((n+1)/2)" => |x| naive::kappa(x[0])),
        subject!("double::kappa, against log-gammas", KAPPA, |x| double::kappa(x[0]).map(Ranged::Value), |y| mdr_analytic::kappa(&y[0]),
            naive "√π exp(ln Γ(1+n/2) − ln Γ((n+1)/2))" => |x| naive::kappa_by_logarithms(x[0])),
    ]
}

fn universal() -> [Subject; 2] {
    [
        subject!("double::universal_indentation", UNIVERSAL, |x| double::universal_indentation(x[0], x[1]),
            |y| mdr_analytic::universal_indentation(&y[0], &y[1]),
            naive "(ãⁿ − 2nã^½)/|1−2n|" => |x| naive::universal_indentation(x[0], x[1])),
        subject!("double::universal_force", UNIVERSAL, |x| double::universal_force(x[0], x[1]),
            |y| mdr_analytic::universal_force(&y[0], &y[1]),
            naive "(ãⁿ⁺¹ − 2(n+1)ã^(3/2))/(2n+1)" => |x| naive::universal_force(x[0], x[1])),
    ]
}

fn power() -> [Subject; 3] {
    [
        subject!("double::g", POWER, |x| double::g(x[0], x[1], x[2]),
            |y| PowerLaw::new(y[0].clone(), y[1].clone())?.g(&y[2]),
            naive "κ_n C xⁿ with log-gammas" => |x| naive::g(x[0], x[1], x[2])),
        subject!("double::g_slope", POWER, |x| double::g_slope(x[0], x[1], x[2]),
            |y| PowerLaw::new(y[0].clone(), y[1].clone())?.slope(&y[2]),
            naive "n κ_n C xⁿ⁻¹ with log-gammas" => |x| x[0] * naive::g(x[0], x[1], x[2]) / x[2]),
        subject!("double::g_integral", POWER, |x| double::g_integral(x[0], x[1], x[2]),
            |y| PowerLaw::new(y[0].clone(), y[1].clone())?.integral(&y[2]),
            naive "κ_n C xⁿ⁺¹/(n+1) with log-gammas" => |x| naive::g(x[0], x[1], x[2]) * x[2] / (x[0] + 1.0)),
    ]
}

fn elongation() -> Subject {
    subject!("double::detachment_elongation", EDGE, |x| double::detachment_elongation(&material(x)?, x[2]),
        |y| mdr_analytic::detachment_elongation(&material(y)?, &y[2]),
        naive "√(2πaw/E*)" => |x| naive::elongation(x[0], x[1], x[2]))
}

fn values() -> [Subject; 2] {
    [
        subject!("double::indentation", STATE, |x| double::indentation(x[0], x[1], &material(&x[2..])?, x[4]),
            |y| contact(y)?.indentation(&y[4]),
            naive "(1.13)" => |x| naive::indentation(law(x), x[4])),
        subject!("double::force", STATE, |x| double::force(x[0], x[1], &material(&x[2..])?, x[4]),
            |y| contact(y)?.force(&y[4]),
            naive "(1.16)" => |x| naive::force(law(x), x[4])),
    ]
}

fn slopes() -> [Subject; 2] {
    [
        subject!("double::indentation_slope", STATE, |x| double::indentation_slope(x[0], x[1], &material(&x[2..])?, x[4]),
        |y| contact(y)?.indentation_slope(&y[4]),
        naive "g' − √(πw/(2E*a))" => |x| {
            let [n, c, e, w] = law(x);
            n * naive::g(n, c, x[4]) / x[4] - (PI * w / (2.0 * e * x[4])).sqrt()
        }),
        subject!("double::force_slope", STATE, |x| double::force_slope(x[0], x[1], &material(&x[2..])?, x[4]),
        |y| contact(y)?.force_slope(&y[4]),
        naive "2E*(a d' − Δl)" => |x| {
            let ([n, c, e, w], a) = (law(x), x[4]);
            2.0 * e * (n * naive::g(n, c, a) - (PI * w * a / (2.0 * e)).sqrt() - naive::elongation(e, w, a))
        }),
    ]
}

fn energy() -> Subject {
    subject!("double::energy", ENERGY, |x| double::energy(x[0], x[1], &material(&x[2..])?, x[4], x[5]),
        |y| contact(y)?.energy(&y[4], &y[5]),
        naive "E*a(d² − 2dg/(n+1) + g²/(2n+1)) − πa²w" => |x| naive::energy(law(x), x[4], x[5]))
}

/// n → 1/2, 0 and ∞, with inputs that follow n.
pub(super) fn exponents(level: Level, inputs: impl Fn(f64) -> Vec<f64> + Copy) -> Vec<Direction> {
    let half = halvings(level, 2, 50);
    vec![
        Direction::new(Family::Half, "n → 1/2 from above", "n − 1/2", half.clone(), |t| inputs(0.5 + t)),
        Direction::new(Family::Half, "n → 1/2 from below", "1/2 − n", half, |t| inputs(0.5 - t)),
        Direction::new(Family::SmallExponent, "n → 0", "n", decades(level, -1, -290), inputs),
        Direction::new(Family::LargeExponent, "n → ∞", "n", decades(level, 1, 14), inputs),
    ]
}

/// Each of the inputs from the given place on to both ends of the range, around a base.
pub(super) fn scales(level: Level, names: &[&str], base: &[f64], from: usize) -> Vec<Direction> {
    let led = |index: usize, end: i32| {
        let toward = format!("{} → 10^{end}{}", names[index], if base[0] < 0.5 { ", n < 1/2" } else { "" });
        Direction::new(Family::Scale, toward, "the input", decades(level, 0, end), |t| {
            let mut inputs = base.to_vec();
            inputs[index] = t;
            inputs
        })
    };
    (from..base.len()).flat_map(|index| [led(index, 300), led(index, -300)]).collect()
}

/// To where a difference vanishes: a₀(1 ± δ).
fn zeros(level: Level, toward: &str, [n, c, zero]: [f64; 3]) -> Vec<Direction> {
    let delta = halvings(level, 2, 52);
    let at = |t: f64| vec![n, c, 1.0, 1.0, zero * (1.0 + t)];
    vec![
        Direction::new(Family::Zero, format!("{toward} from above"), "a/a₀ − 1", delta.clone(), at),
        Direction::new(Family::Zero, format!("{toward} from below"), "1 − a/a₀", delta, move |t| at(-t)),
    ]
}

pub(super) fn climbs(level: Level) -> Vec<Climb> {
    let mut climbs = cross(&kappa(), &exponents(level, |n| vec![n]));
    let mut curves = exponents(level, |n| vec![n, 0.75]);
    // F = 0 at ã = 16 for the cone, d = 0 at ã = 4^(1/3)·… for the paraboloid.
    curves.push(Direction::new(Family::Zero, "ã → the zero", "ã/ã₀ − 1", halvings(level, 2, 52), |t| {
        vec![2.0, 4_f64.powf(2.0 / 3.0) * (1.0 + t)]
    }));
    curves.push(Direction::new(
        Family::Zero,
        "ã → the zero of the cone",
        "ã/16 − 1",
        halvings(level, 2, 52),
        |t| vec![1.0, 16.0 * (1.0 + t)],
    ));
    curves.extend(scales(level, UNIVERSAL, &[2.0, 1.0], 1));
    curves.extend(scales(level, UNIVERSAL, &[0.25, 1.0], 1));
    climbs.extend(cross(&universal(), &curves));

    let mut transforms = exponents(level, |n| vec![n, planted(n, 1.0), 1.0 - 0.5 / (1.0 + n)]);
    transforms.extend(scales(level, POWER, &[1.5, 1.0, 1.0], 1));
    climbs.extend(cross(&power(), &transforms));
    climbs.extend(cross(&[elongation()], &scales(level, EDGE, &[1.0, 1.0, 1.0], 0)));

    let along = |n: f64| vec![n, planted(n, 1.0), 1.0, 1.0, 1.0 - 0.5 / (1.0 + n)];
    let mut states = exponents(level, along);
    for n in [2.0, 0.25] {
        states.extend(scales(level, STATE, &[n, 0.5, 1.0, 1.0, 1.0], 1));
    }
    let paraboloid = |power: f64| [2.0, 0.5, power.powf(1.0 / 3.0)];
    // d = a² − √(2πa), F ∝ 2a²/3·… − √(2πa); their slopes.
    let directions = |ends: &[Direction]| [states.clone(), ends.to_vec()].concat();
    let [d, f] = values();
    climbs.extend(cross(&[d], &directions(&zeros(level, "a → the zero of d", paraboloid(2.0 * PI)))));
    climbs.extend(cross(&[f], &directions(&zeros(level, "a → the zero of F", paraboloid(4.5 * PI)))));
    let [d, f] = slopes();
    climbs.extend(cross(&[d], &directions(&zeros(level, "a → the fold of d", paraboloid(PI / 8.0)))));
    climbs.extend(cross(&[f], &directions(&zeros(level, "a → the fold of F", paraboloid(9.0 * PI / 8.0)))));

    // At a = 1 Π vanishes with (d − 1/3)² = π − 4/45.
    let zero = 1.0 / 3.0 + (PI - 4.0 / 45.0).sqrt();
    let mut states = exponents(level, |n| [along(n), vec![0.1]].concat());
    states.extend(scales(level, ENERGY, &[2.0, 0.5, 1.0, 1.0, 1.0, 1.0], 1));
    states.push(Direction::new(Family::Zero, "d → the zero of Π", "d/d₀ − 1", halvings(level, 2, 52), |t| {
        vec![2.0, 0.5, 1.0, 1.0, 1.0, zero * (1.0 + t)]
    }));
    climbs.extend(cross(&[energy()], &states));
    climbs
}
