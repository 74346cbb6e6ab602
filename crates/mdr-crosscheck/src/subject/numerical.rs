//! The numerical route in f64 against closed forms: folds, equilibria, fields and energies.

use std::sync::Arc;

use mdr_analytic::profiles::Paraboloid;
use mdr_analytic::{Equilibria, Kappa, PowerLaw};
use mdr_core::contact::{Control, Equilibrium, Error, Fold, Quantity, Ranged, Result};
use mdr_core::number::{Real, Special};
use mdr_numeric::contact::Contact;
use mdr_numeric::energy::Energy;
use mdr_numeric::equilibrium::equilibria;
use mdr_numeric::fields::Fields;
use mdr_numeric::folds::folds;

use super::double::{LAW, MACHINE, contact, machine, material};
use super::routine::{Routine, routine, routines};
use super::textbook;

/// The only fold of a contact with n > 5/2 − √3 or n < 1/2, from the closed form of g and the numerical search.
fn only_fold(x: &[f64], control: &Control<f64>) -> Result<Fold<f64>> {
    let (profile, material) = (Arc::new(PowerLaw::new(x[0], x[1])?), material(&x[2..])?);
    let found = folds(&profile, &material, control)?;
    let none = || Error::NoEquilibrium { quantity: Quantity::ContactRadius, value: format!("{} folds", found.len()) };
    let [fold] = found.folds.as_slice() else { return Err(none()) };
    Ok(fold.clone())
}

/// A number of that fold, on the inputs `x` under a control.
macro_rules! fold {
    ($name:literal, $inputs:expr, |$x:ident| $control:expr, $part:ident) => {
        routine!(
            $name, $inputs,
            |$x| Ok(Ranged::Value(only_fold($x, &$control)?.$part)), exact Ok(contact($x)?.critical(&$control)?.$part)
        )
    };
}

pub(crate) const FOLDS: [Routine; 8] = [
    fold!("folds, fixed grips, a", LAW, |x| Control::Indentation, contact_radius),
    fold!("folds, fixed grips, d", LAW, |x| Control::Indentation, indentation),
    fold!("folds, fixed grips, F", LAW, |x| Control::Indentation, force),
    fold!("folds, dead load, a", LAW, |x| Control::Force, contact_radius),
    fold!("folds, dead load, d", LAW, |x| Control::Force, indentation),
    fold!("folds, dead load, F", LAW, |x| Control::Force, force),
    fold!("folds, machine, a", MACHINE, |x| machine(&x[4]), contact_radius),
    fold!("folds, machine, F", MACHINE, |x| machine(&x[4]), force),
];

/// The radius of a state, if there is one.
fn radius<R: Clone>(state: Option<&Equilibrium<R>>) -> Result<R> {
    let none = || Error::NoEquilibrium { quantity: Quantity::ContactRadius, value: "given".to_owned() };
    Ok(state.ok_or_else(none)?.contact_radius.clone())
}

/// The equilibria of a power law by the numerical search, with the controlled value after E* and w.
fn searched(x: &[f64], control: &Control<f64>) -> Result<Vec<Equilibrium<f64>>> {
    Ok(equilibria(&Arc::new(PowerLaw::new(x[0], x[1])?), &material(&x[2..])?, control, &x[4])?.equilibria)
}

/// The equilibria of a power law in closed form, with the controlled value after E* and w.
fn proved<R: Kappa>(x: &[R], control: &Control<R>) -> Result<Equilibria<R>> {
    contact(x)?.equilibria(control, &x[4])
}

/// The radius of the `first` or the `last` state: the one inside of the fold, or outside.
macro_rules! equilibrium {
    ($name:literal, $value:literal, $control:ident, $which:ident $(, textbook $formula:literal => $textbook:ident)?) => {
        routine!(
            $name, &["n", "C", "E*", "w", $value],
            |x| radius(searched(x, &Control::$control)?.$which()).map(Ranged::Value),
            exact radius(proved(x, &Control::$control)?.as_slice().$which())
            $(, textbook $formula => $textbook(x))?
        )
    };
}

fn ferrari(x: &[f64]) -> f64 {
    if x[0] == 2.0 { textbook::ferrari(0.5 / x[1], x[2], x[3], x[4]) } else { f64::NAN }
}

/// The radius at a given value, on either side of the fold.
pub(crate) const EQUILIBRIA: [Routine; 4] = [
    equilibrium!("equilibria, fixed grips, outer a", "d", Indentation, last,
        textbook "the quartic of JKR by Ferrari" => ferrari),
    equilibrium!("equilibria, fixed grips, inner a", "d", Indentation, first),
    equilibrium!("equilibria, dead load, outer a", "F", Force, last),
    equilibrium!("equilibria, dead load, inner a", "F", Force, first),
];

/// The result of `ask` for the fields of f64 of a paraboloid [R, E*, w, a, …].
fn fields<T>(x: &[f64], ask: impl Fn(&Fields<f64>) -> Result<T>) -> Result<T> {
    let (ball, material, control) = (Arc::new(Paraboloid::new(x[0])?), material(&x[1..])?, Control::Indentation);
    ask(&Fields::new(Contact::half_space(&ball, &material, &control), x[3])?)
}

/// The result of `ask` for the energies of a paraboloid.
fn energy<T>(x: &[f64], ask: impl Fn(&Energy<f64>) -> Result<T>) -> Result<T> {
    let (ball, material) = (Arc::new(Paraboloid::new(x[0])?), material(&x[1..])?);
    ask(&Energy::new(Contact::half_space(&ball, &material, &Control::Indentation))?)
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

/// The paraboloid r²/2R as a power law on the same half-space.
fn law(x: &[f64]) -> [f64; 4] {
    [2.0, 0.5 / x[0], x[1], x[2]]
}

routines! {
    PRESSURE ["R", "E*", "w", "a", "r"] {
        "Fields::pressure": |x| fields(x, |f| f.pressure(&x[4])).map(Ranged::Value), exact Ok(pressure(x));
    }
    OUTSIDE ["R", "E*", "w", "a", "r"] {
        "Fields::gap": |x| fields(x, |f| f.gap(&x[4])).map(Ranged::Value), exact Ok(gap(x));
        "Fields::displacement": |x| fields(x, |f| f.displacement(&x[4])).map(Ranged::Value), exact Ok(displacement(x));
    }
    STIFFNESS ["R", "E*", "w", "a"] {
        "Fields::stiffness": |x| fields(x, |f| f.stiffness()).map(Ranged::Value), exact Ok(stiffness(x));
    }
    POTENTIAL ["R", "E*", "w", "a", "d"] {
        "Energy::potential": |x| energy(x, |e| e.potential(&x[3], &x[4])).map(Ranged::Value),
            exact Ok(potential(x, &x[3], &x[4])),
            textbook "E*a(d² − 2dg/3 + g²/5) − πa²w" => textbook::energy(law(x), x[3], x[4]);
    }
    RELEASE ["R", "E*", "w", "a", "d"] {
        "Energy::release": |x| energy(x, |e| e.release(&x[3], &x[4])).map(Ranged::Value), exact Ok(release(x));
    }
    DISSIPATED ["R", "E*", "w", "from", "to", "d"] {
        "Energy::dissipated": |x| energy(x, |e| e.dissipated(&x[3], &x[4], &x[5])).map(Ranged::Value),
            exact Ok(potential(x, &x[3], &x[5]) - potential(x, &x[4], &x[5])),
            textbook "the difference of two energies" => {
                textbook::energy(law(x), x[3], x[5]) - textbook::energy(law(x), x[4], x[5])
            };
    }
}
