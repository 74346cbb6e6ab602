//! Equilibria of power laws at a value of d or F, found by the numerical search in f64, against interval Newton on the
//! closed forms.

use mdr_analytic::{Contact, PowerLaw, double};
use mdr_core::calculus::verify::verify;
use mdr_core::contact::{Error, Quantity, Ranged, Result};
use mdr_core::number::{Dual, Interval, Real};
use mdr_numeric::equilibrium::equilibria;
use rug::Float;

use super::functions::{contact, material};
use super::measure::Moved;
use super::questions::{Climb, Direction, Naive, Subject, cross, decades, halvings};
use super::{Family, naive};
use crate::Level;
use crate::grid::Held;

const INDENTED: &[&str] = &["n", "C", "E*", "w", "d"];
const LOADED: &[&str] = &["n", "C", "E*", "w", "F"];

/// The controlled quantity of a state.
fn controlled<R: Real>(contact: &Contact<R>, held: Held, a: &R) -> Result<R> {
    match held {
        Held::Indentation => contact.indentation(a),
        Held::Force => contact.force(a),
    }
}

/// Its derivative.
fn slope<R: Real>(contact: &Contact<R>, held: Held, a: &R) -> Result<R> {
    match held {
        Held::Indentation => contact.indentation_slope(a),
        Held::Force => contact.force_slope(a),
    }
}

/// The radius on the given side of the fold, beyond (1) or before it (−1): by doubling ln(a/a_c) until the sign changes,
/// bisection, and Newton's method.
fn approximate(contact: &Contact<Float>, held: Held, value: &Float, side: i32) -> Result<Float> {
    let fold = contact.critical(&held.control())?.contact_radius;
    let bits = fold.prec();
    let at = |t: &Float| fold.clone() * t.clone().exp();
    let above = |t: &Float| Ok::<_, Error>(controlled(contact, held, &at(t))? > *value);
    let mut near = Float::with_val(bits, side) >> (bits / 2);
    let mut far = Float::with_val(bits, side) >> 20_u32;
    let here = above(&near)?;
    while above(&far)? == here {
        near = far.clone();
        far *= 2_u32;
        if far.clone().abs() > 1e6 {
            return Err(Error::NoEquilibrium { quantity: Quantity::ContactRadius, value: value.approx().to_string() });
        }
    }
    for _ in 0..96 {
        let middle = Float::with_val(bits, &near + &far) / 2_u32;
        if above(&middle)? == here {
            near = middle;
        } else {
            far = middle;
        }
    }
    let mut a = at(&far);
    for _ in 0..=bits.ilog2() {
        a = a.clone() - (controlled(contact, held, &a)? - value) / slope(contact, held, &a)?;
    }
    Ok(a)
}

fn enclosed(y: &[Interval], held: Held, side: i32) -> Result<Interval> {
    let middles: Vec<_> = y.iter().map(Interval::mid).collect();
    let candidate = approximate(&contact(&middles)?, held, &middles[4], side)?;
    let contact = contact(y)?;
    let zero = verify(&candidate, |a| Ok(controlled(&contact, held, a)? - &y[4]), |a| slope(&contact, held, a))?;
    let unknown = Error::Undecided { quantity: Quantity::ContactRadius, bits: candidate.prec(), what: "where it lies" };
    let zero = zero.ok_or(unknown.clone())?;
    let fold = contact.critical(&held.control())?.contact_radius;
    let beside = if side > 0 { zero > fold } else { zero < fold };
    if beside { Ok(zero) } else { Err(unknown) }
}

/// By the implicit function theorem.
fn moved(y: &[Moved], held: Held, side: i32) -> Result<Moved> {
    let still: Vec<_> = y.iter().map(|x| x.value.clone()).collect();
    let still_contact = contact(&still)?;
    let a = approximate(&still_contact, held, &still[4], side)?;
    let residual = controlled(&contact(y)?, held, &Dual::constant(a.clone()))? - &y[4];
    let slope = -residual.slope / slope(&still_contact, held, &a)?;
    Ok(Dual { value: a, slope })
}

/// The first or the last of those found.
fn found(x: &[f64], held: Held, side: i32) -> Result<Ranged<f64>> {
    let (profile, material) = (PowerLaw::new(x[0], x[1])?, material(&x[2..])?);
    let all = equilibria(&profile, &material, &held.control(), &x[4])?;
    let state = if side > 0 { all.last() } else { all.first() };
    let none = || Error::NoEquilibrium { quantity: Quantity::ContactRadius, value: x[4].to_string() };
    Ok(Ranged::Value(state.ok_or_else(none)?.contact_radius))
}

fn subjects() -> [Subject; 4] {
    macro_rules! equilibrium {
        ($name:literal, $inputs:expr, $held:ident, $side:expr, $naive:expr) => {
            Subject {
                name: $name,
                inputs: $inputs,
                shipped: |x| found(x, Held::$held, $side),
                enclosed: |y| enclosed(y, Held::$held, $side),
                moved: |y| moved(y, Held::$held, $side),
                naive: $naive,
            }
        };
    }
    let ferrari = Naive {
        formula: "the quartic of JKR by Ferrari",
        value: |x| if x[0] == 2.0 { naive::ferrari(0.5 / x[1], x[2], x[3], x[4]) } else { f64::NAN },
    };
    [
        equilibrium!("equilibria, fixed grips, outer a", INDENTED, Indentation, 1, Some(ferrari)),
        equilibrium!("equilibria, fixed grips, inner a", INDENTED, Indentation, -1, None),
        equilibrium!("equilibria, dead load, outer a", LOADED, Force, 1, None),
        equilibrium!("equilibria, dead load, inner a", LOADED, Force, -1, None),
    ]
}

/// The critical value of what is held.
fn critical(law: [f64; 4], held: Held) -> f64 {
    let state = || {
        let state = double::critical(law[0], law[1], &material(&law[2..])?, &held.control())?;
        match held {
            Held::Indentation => state.indentation.value(Quantity::Indentation),
            Held::Force => state.force.value(Quantity::Force),
        }
    };
    state().unwrap_or(f64::NAN)
}

fn directions(level: Level, held: Held, outer: bool) -> Vec<Direction> {
    let law = [2.0, 0.5, 1.0, 1.0];
    let fold = critical(law, held);
    let mut directions =
        vec![Direction::new(Family::Fold, "to the fold, n = 2", "1 − value/critical", halvings(level, 1, 50), |t| {
            [law.to_vec(), vec![fold * (1.0 - t)]].concat()
        })];
    let sharp = [0.25, 0.5, 1.0, 1.0];
    let fold = critical(sharp, held);
    directions.push(Direction::new(
        Family::Fold,
        "to the fold, n = 1/4",
        "1 − value/critical",
        halvings(level, 1, 50),
        |t| [sharp.to_vec(), vec![fold * (1.0 - t)]].concat(),
    ));
    if outer {
        directions.push(Direction::new(Family::Far, "pressed in, n = 2", "value", decades(level, 0, 90), |t| {
            [law.to_vec(), vec![t]].concat()
        }));
    }
    for (index, end) in [(2, 200), (2, -200), (3, 200), (3, -200)] {
        let toward = format!("{} → 10^{end} at half the critical value", INDENTED[index]);
        directions.push(Direction::new(Family::Scale, toward, "the input", decades(level, 0, end), |t| {
            let mut law = law;
            law[index] = t;
            [law.to_vec(), vec![0.5 * critical(law, held)]].concat()
        }));
    }
    directions
}

pub(super) fn climbs(level: Level) -> Vec<Climb> {
    let [grips_outer, grips_inner, load_outer, load_inner] = subjects();
    let mut climbs = Vec::new();
    for (subject, held, outer) in [
        (grips_outer, Held::Indentation, true),
        (grips_inner, Held::Indentation, false),
        (load_outer, Held::Force, true),
        (load_inner, Held::Force, false),
    ] {
        climbs.extend(cross(&[subject], &directions(level, held, outer)));
    }
    climbs
}
