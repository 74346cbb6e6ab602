//! Energies of a paraboloid by quadrature of g, against their closed forms.

use std::f64::consts::PI;

use mdr_analytic::profiles::Paraboloid;
use mdr_core::contact::{Ranged, Result};
use mdr_core::number::Real;
use mdr_numeric::energy::Energy;

use super::functions::material;
use super::questions::{Climb, Direction, Subject, cross, decades, halvings, subject};
use super::{Family, naive};
use crate::Level;

const STATE: &[&str] = &["R", "E*", "w", "a", "d"];
const JUMP: &[&str] = &["R", "E*", "w", "from", "to", "d"];

fn energy<T>(x: &[f64], ask: impl Fn(&Energy<'_, f64>) -> Result<T>) -> Result<T> {
    let (ball, material) = (Paraboloid::new(x[0])?, material(&x[1..])?);
    ask(&Energy::new(&ball, &material)?)
}

/// E*(d²a − 2da³/3R + a⁵/5R²) − πa²w.
fn potential<R: Real>(x: &[R], a: &R, d: &R) -> R {
    let share = a.square() / &x[0];
    let elastic = d.square() - d.clone() * &share.clone().times(2).over(3) + share.square().over(5);
    (elastic * &x[1] - a.pi() * a * &x[2]) * a
}

/// ((d − a²/R)/Δl)².
fn release<R: Real>(x: &[R]) -> R {
    let stretched = x[4].clone() - x[3].square() / &x[0];
    stretched.square() * &x[1] / (x[0].pi() * &x[3] * &x[2]).times(2)
}

fn subjects() -> [Subject; 3] {
    [
        subject!("Energy::potential", STATE, |x| energy(x, |e| e.potential(&x[3], &x[4])).map(Ranged::Value),
            |y| Ok(potential(y, &y[3], &y[4])),
            naive "E*a(d² − 2dg/3 + g²/5) − πa²w" => |x| naive::energy([2.0, 0.5 / x[0], x[1], x[2]], x[3], x[4])),
        subject!("Energy::release", STATE, |x| energy(x, |e| e.release(&x[3], &x[4])).map(Ranged::Value), |y| Ok(
            release(y)
        )),
        subject!("Energy::dissipated", JUMP, |x| energy(x, |e| e.dissipated(&x[3], &x[4], &x[5])).map(Ranged::Value),
        |y| Ok(potential(y, &y[3], &y[5]) - potential(y, &y[4], &y[5])),
        naive "the difference of two energies" => |x| {
            let law = [2.0, 0.5 / x[0], x[1], x[2]];
            naive::energy(law, x[3], x[5]) - naive::energy(law, x[4], x[5])
        }),
    ]
}

pub(super) fn climbs(level: Level) -> Vec<Climb> {
    let [potential, release, dissipated] = subjects();
    let at = |a: f64, d: f64| vec![1.0, 1.0, 1.0, a, d];
    // At a = 1 Π vanishes with (d − 1/3)² = π − 4/45.
    let zero = 1.0 / 3.0 + (PI - 4.0 / 45.0).sqrt();
    let mut states = vec![
        Direction::new(Family::Zero, "d → the zero of Π", "d/d₀ − 1", halvings(level, 2, 50), |t| {
            at(1.0, zero * (1.0 + t))
        }),
        Direction::new(Family::Tip, "a → 0", "a", decades(level, 0, -120), |a| at(a, -0.1)),
    ];
    for end in [100, -100] {
        let toward = format!("all lengths → 10^{end}, w/E* with them");
        states.push(Direction::new(Family::Scale, toward, "factor", decades(level, 0, end), |t| {
            vec![t, 1.0, t, t, -0.3 * t]
        }));
    }
    let mut climbs = cross(&[potential], &states);
    states[0] = Direction::new(Family::Zero, "d → g(a)", "d − 1", halvings(level, 2, 50), |t| at(1.0, 1.0 + t));
    climbs.extend(cross(&[release], &states));
    // At d = d_c the energy has an inflection in a.
    let fold = (PI / 8.0).cbrt();
    let d = fold * fold - (2.0 * PI * fold).sqrt();
    let jumps = [
        Direction::new(Family::Fold, "the jump → 0", "1 − to/from", halvings(level, 2, 40), |t| {
            vec![1.0, 1.0, 1.0, 1.0, 1.0 - t, -0.3]
        }),
        Direction::new(Family::Fold, "the jump → 0 at the fold", "1 − to/from", halvings(level, 2, 14), |t| {
            vec![1.0, 1.0, 1.0, fold * (1.0 + t / 2.0), fold * (1.0 - t / 2.0), d]
        }),
    ];
    climbs.extend(cross(&[dissipated], &jumps));
    climbs
}
