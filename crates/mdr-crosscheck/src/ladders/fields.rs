//! Pressure, gap, displacement and stiffness of a paraboloid by quadrature of g, against their closed forms.

use std::f64::consts::PI;

use mdr_analytic::profiles::Paraboloid;
use mdr_core::contact::{Control, Ranged, Result};
use mdr_core::number::Special;
use mdr_numeric::curve::Curve;
use mdr_numeric::fields::Fields;

use super::Family;
use super::functions::material;
use super::questions::{Climb, Direction, Subject, cross, decades, halvings, subject};
use crate::Level;

const FIELD: &[&str] = &["R", "E*", "w", "a", "r"];
const STATE: &[&str] = &["R", "E*", "w", "a"];

/// What the fields of f64 say.
fn fields<T>(x: &[f64], ask: impl Fn(&Fields<'_, f64>) -> Result<T>) -> Result<T> {
    let (ball, material, control) = (Paraboloid::new(x[0])?, material(&x[1..])?, Control::Indentation);
    ask(&Fields::new(Curve::new(&ball, &material, &control), x[3])?)
}

/// Δl and d of [R, E*, w, a, …].
fn state<R: Special>(x: &[R]) -> (R, R) {
    let length = (x[0].pi() * &x[3] * &x[2] / &x[1]).times(2).sqrt();
    let d = x[3].square() / &x[0] - &length;
    (length, d)
}

/// (E*/π)[2q/R − Δl/q], q = √(a² − r²).
fn pressure<R: Special>(x: &[R]) -> R {
    let (length, _) = state(x);
    let q = ((x[3].clone() - &x[4]) * (x[3].clone() + &x[4])).sqrt();
    (q.clone().times(2) / &x[0] - length / &q) * &x[1] / x[0].pi()
}

/// (2/π)[r²(φ + sin φ cos φ)/2R − dφ], cos φ = a/r.
fn gap<R: Special>(x: &[R]) -> R {
    let (_, d) = state(x);
    let (a, r) = (&x[3], &x[4]);
    let q = ((r.clone() - a) * (r.clone() + a)).sqrt();
    let phi = (q.clone() / a).atan();
    let product = q * a + r.square() * &phi;
    (product / x[0].clone().times(2) - d * phi).times(2) / r.pi()
}

/// (2/π)[dθ − r²(θ − sin θ cos θ)/2R], sin θ = a/r.
fn displacement<R: Special>(x: &[R]) -> R {
    let (_, d) = state(x);
    let (a, r) = (&x[3], &x[4]);
    let q = ((r.clone() - a) * (r.clone() + a)).sqrt();
    let theta = (a.clone() / &q).atan();
    let difference = r.square() * &theta - q * a;
    (d * theta - difference / x[0].clone().times(2)).times(2) / r.pi()
}

/// 2E*a(τ − 3)/(τ − 1), τ = g'/Δl' = (2a/R)/√(πw/(2E*a)).
fn stiffness<R: Special>(x: &[R]) -> R {
    let slope = (x[0].pi() * &x[2] / x[1].clone().times(2) / &x[3]).sqrt();
    let tau = x[3].clone().times(2) / &x[0] / &slope;
    (x[1].clone() * &x[3]).times(2) * (tau.clone() - tau.lit(3)) / &(tau.clone() - tau.lit(1))
}

fn subjects() -> [Subject; 4] {
    [
        subject!("Fields::pressure", FIELD, |x| fields(x, |f| f.pressure(&x[4])).map(Ranged::Value), |y| Ok(pressure(
            y
        ))),
        subject!("Fields::gap", FIELD, |x| fields(x, |f| f.gap(&x[4])).map(Ranged::Value), |y| Ok(gap(y))),
        subject!("Fields::displacement", FIELD, |x| fields(x, |f| f.displacement(&x[4])).map(Ranged::Value), |y| Ok(
            displacement(y)
        )),
        subject!("Fields::stiffness", STATE, |x| fields(x, |f| f.stiffness()).map(Ranged::Value), |y| Ok(stiffness(y))),
    ]
}

pub(super) fn climbs(level: Level) -> Vec<Climb> {
    let [pressure, gap, displacement, stiffness] = subjects();
    let at = |r: f64| vec![1.0, 1.0, 1.0, 2.0, r];
    let scaled = |r: f64, end: i32| {
        Direction::new(
            Family::Scale,
            format!("all lengths → 10^{end}, w/E* with them"),
            "factor",
            decades(level, 0, end),
            move |t| vec![t, 1.0, t, 2.0 * t, r * t],
        )
    };
    // The pressure is 0 where 2(a² − r²) = RΔl.
    let zero = (4.0 - (4.0 * PI).sqrt() / 2.0).sqrt();
    let within = [
        Direction::new(Family::Edge, "r → a from inside", "1 − r/a", halvings(level, 1, 52), |t| {
            at(2.0 * (1.0 - t))
        }),
        Direction::new(Family::Tip, "r → 0", "r", decades(level, 0, -300), at),
        Direction::new(Family::Zero, "r → the zero of p", "r/r₀ − 1", halvings(level, 3, 50), |t| {
            at(zero * (1.0 + t))
        }),
        scaled(0.7, 150),
        scaled(0.7, -150),
    ];
    let mut climbs = cross(&[pressure], &within);
    let outside = [
        Direction::new(Family::Edge, "r → a from outside", "r/a − 1", halvings(level, 1, 51), |t| {
            at(2.0 * (1.0 + t))
        }),
        Direction::new(Family::Far, "r → ∞", "r", decades(level, 1, 150), at),
        scaled(3.0, 150),
        scaled(3.0, -150),
    ];
    climbs.extend(cross(&[gap, displacement], &outside));
    let state = |a: f64| vec![1.0, 1.0, 1.0, a];
    let states = [
        Direction::new(Family::Fold, "a → the fold", "a/a_c − 1", halvings(level, 2, 50), |t| {
            state((PI / 8.0).cbrt() * (1.0 + t))
        }),
        Direction::new(Family::Zero, "a → the zero at the fold of F", "a/a_F − 1", halvings(level, 2, 50), |t| {
            state((9.0 * PI / 8.0).cbrt() * (1.0 + t))
        }),
        Direction::new(Family::Tip, "a → 0", "a", decades(level, 0, -150), state),
        Direction::new(Family::Far, "a → ∞", "a", decades(level, 0, 150), state),
    ];
    climbs.extend(cross(&[stiffness], &states));
    climbs
}
