//! `mdr_analytic::double` at instabilities: critical states, machine folds, jumps, n = 1/2, the flat punch.

use std::f64::consts::PI;

use mdr_analytic::{Contact, Critical, Kappa, double, flat_punch_pull_off, threshold};
use mdr_core::contact::{Control, Error, Instability, Quantity, Result};

use super::functions::{LAW, MACHINE, contact, exponents, law, material, planted, scales};
use super::questions::{Climb, Direction, Subject, cross, decades, halvings, subject};
use super::{Family, naive};
use crate::Level;

const HALF: &[&str] = &["C", "E*", "w"];
const HALF_STATE: &[&str] = &["C", "E*", "w", "a"];
const MATERIAL: &[&str] = &["E*", "w"];
const PUNCH: &[&str] = &["b", "E*", "w"];

/// A number of the critical state; its log₁₀ where one of the numbers is beyond the exponents of MPFR.
fn state_of<R: Kappa>(contact: &Contact<R>, control: &Control<R>, part: fn(Critical<R>) -> R) -> Result<R> {
    /// Half of the decades that MPFR has.
    const DECADES: f64 = 1.5e8;
    let logarithms = contact.ln_critical(control)?;
    let log10 = |x: &R| x.approx() / std::f64::consts::LN_10;
    let Critical { contact_radius, indentation, force } = &logarithms;
    // A number with the logarithm of 0 is 0, and not beyond anything.
    let far = |x: &R| log10(x).is_finite() && log10(x).abs() > DECADES;
    if [contact_radius, indentation, force].into_iter().any(far) {
        let log10 = log10(&part(logarithms));
        return Err(Error::OutOfRange { quantity: Quantity::ContactRadius, log10 });
    }
    Ok(part(contact.critical(control)?))
}

fn critical() -> [Subject; 6] {
    macro_rules! held {
        ($name:literal, $control:ident, $part:ident, $formula:literal => $naive:expr) => {
            subject!($name, LAW,
                |x| Ok(double::critical(x[0], x[1], &material(&x[2..])?, &Control::$control)?.$part),
                |y| state_of(&contact(y)?, &Control::$control, |state| state.$part),
                naive $formula => $naive)
        };
    }
    [
        held!("double::critical, fixed grips, a", Indentation, contact_radius, "(1.15) corrected, in powers" => |x| naive::critical_radius(law(x), 1.0)),
        held!("double::critical, fixed grips, d", Indentation, indentation, "(1.13) at a_c" => |x| naive::critical_indentation(law(x), 1.0)),
        held!("double::critical, fixed grips, F", Indentation, force, "(1.16) at a_c" => |x| naive::critical_force(law(x), 1.0)),
        held!("double::critical, dead load, a", Force, contact_radius, "(1.15) with 9w, in powers" => |x| naive::critical_radius(law(x), 3.0)),
        held!("double::critical, dead load, d", Force, indentation, "(1.13) at a_F" => |x| naive::critical_indentation(law(x), 3.0)),
        held!("double::critical, dead load, F", Force, force, "(1.16) at a_F" => |x| naive::critical_force(law(x), 3.0)),
    ]
}

fn critical_on_machine() -> [Subject; 2] {
    macro_rules! held {
        ($name:literal, $part:ident) => {
            subject!(
                $name,
                MACHINE,
                |x| {
                    let control = Control::Machine { stiffness: x[4] };
                    Ok(double::critical(x[0], x[1], &material(&x[2..])?, &control)?.$part)
                },
                |y| Ok(contact(y)?.critical(&Control::Machine { stiffness: y[4].clone() })?.$part)
            )
        };
    }
    [held!("double::critical, machine, a", contact_radius), held!("double::critical, machine, F", force)]
}

/// The first, the middle and the last of some folds.
fn middle<R>(folds: Vec<Instability<R>>) -> Result<Instability<R>> {
    let at = folds.len() / 2;
    pick(folds, at)
}

fn first<R>(folds: Vec<Instability<R>>) -> Result<Instability<R>> {
    pick(folds, 0)
}

fn pick<R>(folds: Vec<Instability<R>>, index: usize) -> Result<Instability<R>> {
    let none = || Error::NoEquilibrium { quantity: Quantity::MachinePosition, value: "any".to_owned() };
    folds.into_iter().nth(index).ok_or_else(none)
}

fn machine() -> [Subject; 4] {
    macro_rules! fold {
        ($name:literal, $which:ident, $part:ident) => {
            subject!(
                $name,
                MACHINE,
                |x| Ok($which(double::machine_folds(x[0], x[1], &material(&x[2..])?, x[4])?)?.$part),
                |y| Ok($which(contact(y)?.machine_folds(&y[4])?)?.$part)
            )
        };
    }
    [
        fold!("double::machine_folds, middle, a", middle, contact_radius),
        fold!("double::machine_folds, middle, d", middle, indentation),
        fold!("double::machine_folds, middle, F", middle, force),
        fold!("double::machine_folds, first, a", first, contact_radius),
    ]
}

fn jumps() -> [Subject; 4] {
    macro_rules! of {
        ($name:literal, $function:ident) => {
            subject!($name, LAW, |x| double::$function(x[0], x[1], &material(&x[2..])?), |y| contact(y)?.$function())
        };
    }
    [
        of!("double::radius_at_zero_indentation", radius_at_zero_indentation),
        of!("double::energy_lost_at_pull_off", energy_lost_at_pull_off),
        of!("double::energy_lost_at_jump_in", energy_lost_at_jump_in),
        of!("double::barrier_to_complete_contact", barrier_to_complete_contact),
    ]
}

/// [C, E*, w, …] at n = 1/2.
fn half<R: Kappa>(x: &[R]) -> Result<Contact<R>> {
    contact(&[x[0].ratio(1, 2), x[0].clone(), x[1].clone(), x[2].clone()])
}

fn scale_free() -> [Subject; 3] {
    [
        subject!("double::ratio", HALF, |x| double::ratio(x[0], &material(&x[1..])?), |y| half(y)?.ratio()),
        subject!(
            "double::threshold, fixed grips",
            MATERIAL,
            |x| double::threshold(&material(x)?, &Control::Indentation),
            |y| threshold(&material(y)?, &Control::Indentation)
        ),
        subject!(
            "double::threshold, dead load",
            MATERIAL,
            |x| double::threshold(&material(x)?, &Control::Force),
            |y| threshold(&material(y)?, &Control::Force)
        ),
    ]
}

fn scale_free_state() -> [Subject; 2] {
    macro_rules! state {
        ($name:literal, $part:ident, $formula:literal => $naive:expr) => {
            subject!($name, HALF_STATE,
                |x| Ok(double::scale_free_state(x[0], &material(&x[1..])?, x[3])?.$part),
                |y| Ok(half(y)?.scale_free_state(&y[3])?.$part),
                naive $formula => $naive)
        };
    }
    [
        state!("double::scale_free_state, d", indentation, "(1.13)" => |x| naive::indentation([0.5, x[0], x[1], x[2]], x[3])),
        state!("double::scale_free_state, F", force, "(1.16)" => |x| naive::force([0.5, x[0], x[1], x[2]], x[3])),
    ]
}

fn punch() -> [Subject; 2] {
    macro_rules! state {
        ($name:literal, $part:ident) => {
            subject!($name, PUNCH, |x| Ok(double::flat_punch_pull_off(x[0], &material(&x[1..])?)?.$part), |y| {
                let Critical { $part, .. } = flat_punch_pull_off(&y[0], &material(&y[1..])?)?;
                Ok($part)
            })
        };
    }
    [state!("double::flat_punch_pull_off, d", indentation), state!("double::flat_punch_pull_off, F", force)]
}

/// C with which two folds on a machine of E* = w = k = 1 merge at the smaller turning point s of the tangency condition:
/// 3μs² − 2(1−2μ)s + μ = 0, λ = (1+3s)/(1+s), a = s/2.
fn merging(n: f64) -> f64 {
    let mu = n - 0.5;
    let half = 1.0 - 2.0 * mu;
    let s = mu / (half + (half * half - 3.0 * mu * mu).sqrt());
    (1.0 + 3.0 * s) / (1.0 + s) * planted(n, 1.0) * (s / 2.0).powf(-mu)
}

fn machines(level: Level) -> Vec<Direction> {
    let ctx = halvings(level, 2, 20);
    // ρ = 2 in the middle of the thresholds: near n = 1/2 the middle fold stays at 2E*a = k.
    let near = |n: f64| vec![n, planted(n, 2.0) * 2_f64.powf(n - 0.5), 1.0, 1.0, 1.0];
    let stiff = |n: f64, k: f64| vec![n, planted(n, 1.0), 1.0, 1.0, k];
    let mut directions = vec![
        Direction::new(Family::Half, "n → 1/2 from above", "n − 1/2", ctx.clone(), |t| near(0.5 + t)),
        Direction::new(Family::Half, "n → 1/2 from below", "1/2 − n", ctx, |t| near(0.5 - t)),
        Direction::new(Family::SmallExponent, "n → 0", "n", decades(level, -1, -14), near),
        Direction::new(Family::LargeExponent, "n → ∞", "n", decades(level, 1, 12), |n| stiff(n, 1.0)),
        Direction::new(Family::Fold, "C → two folds merge", "C/C* − 1", halvings(level, 3, 44), |t| {
            vec![0.6, merging(0.6) * (1.0 + t), 1.0, 1.0, 1.0]
        }),
        Direction::new(Family::Fold, "C → two folds merge, from one", "1 − C/C*", halvings(level, 3, 44), |t| {
            vec![0.6, merging(0.6) * (1.0 - t), 1.0, 1.0, 1.0]
        }),
    ];
    for n in [2.0, 0.7, 0.25] {
        for end in [-300, 300] {
            let toward = format!("k → 10^{end}, n = {n}");
            let rungs = decades(level, 0, end);
            directions.push(Direction::new(Family::Stiffness, toward, "k", rungs, |k| stiff(n, k)));
        }
    }
    directions.extend(scales(level, &MACHINE[..4], &[2.0, 0.5, 1.0, 1.0, 1.0][..4], 1).into_iter().map(|direction| {
        let rungs = direction.rungs.into_iter().map(|(t, x)| (t, [x, vec![1.0]].concat())).collect();
        Direction { rungs, ..direction }
    }));
    directions
}

pub(super) fn climbs(level: Level) -> Vec<Climb> {
    let mut laws = exponents(level, |n| vec![n, planted(n, 1.0), 1.0, 1.0]);
    for n in [2.0, 0.25] {
        laws.extend(scales(level, LAW, &[n, 0.5, 1.0, 1.0], 1));
    }
    let mut critical_laws = laws.clone();
    critical_laws.push(Direction::new(Family::Half, "n → 1/2, C = 1", "n − 1/2", halvings(level, 2, 50), |t| {
        vec![0.5 + t, 1.0, 1.0, 1.0]
    }));
    critical_laws.push(Direction::new(Family::Zero, "n → 3/2", "n − 3/2", halvings(level, 2, 52), |t| {
        vec![1.5 + t, 1.0, 1.0, 1.0]
    }));
    let mut climbs = cross(&critical(), &critical_laws);
    climbs.extend(cross(&jumps(), &laws));
    let machines = machines(level);
    climbs.extend(cross(&critical_on_machine(), &machines));
    climbs.extend(cross(&machine(), &machines));

    // ρ = κC/√(2πw/E*) = 1 and 3 are the zeros of d and F.
    let threshold = |factor: f64| factor * (2.0 * PI).sqrt() / 1.311_028_777_146_059_9;
    let zero = |factor: f64, sign: f64, toward: &str| {
        Direction::new(Family::Zero, toward, "|ρ/ρ₀ − 1|", halvings(level, 2, 52), |t| {
            vec![threshold(factor) * (1.0 + sign * t), 1.0, 1.0, 1.0]
        })
    };
    let ends = |names: &[&str]| scales(level, names, &vec![1.0; names.len()], 0);
    let [ratio, grips, load] = scale_free();
    climbs.extend(cross(&[ratio], &ends(HALF)));
    climbs.extend(cross(&[grips, load], &ends(MATERIAL)));
    let [d, f] = scale_free_state();
    let states = |zeros: [Direction; 2]| [ends(HALF_STATE), zeros.to_vec()].concat();
    let near = |factor| [zero(factor, 1.0, "ρ → ρ₀ from above"), zero(factor, -1.0, "ρ → ρ₀ from below")];
    climbs.extend(cross(&[d], &states(near(1.0))));
    climbs.extend(cross(&[f], &states(near(3.0))));
    climbs.extend(cross(&punch(), &ends(PUNCH)));
    climbs
}
