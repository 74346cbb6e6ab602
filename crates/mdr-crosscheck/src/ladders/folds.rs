//! Folds found by the numerical search in f64, against the closed forms.

use mdr_analytic::PowerLaw;
use mdr_core::contact::{Control, Error, Instability, Quantity, Ranged, Result};
use mdr_numeric::folds::folds;

use super::Family;
use super::functions::{LAW, MACHINE, contact, material, planted, scales};
use super::questions::{Climb, Direction, Subject, cross, decades, halvings, subject};
use crate::Level;

/// The only fold of a contact with n > 5/2 − √3 or n < 1/2, from the closed form of g and the numerical search.
fn only(x: &[f64], control: &Control<f64>) -> Result<Instability<f64>> {
    let (profile, material) = (PowerLaw::new(x[0], x[1])?, material(&x[2..])?);
    let found = folds(&profile, &material, control)?;
    let none = || Error::NoEquilibrium { quantity: Quantity::ContactRadius, value: format!("{} folds", found.len()) };
    let [fold] = found.folds.as_slice() else { return Err(none()) };
    Ok(fold.clone())
}

fn held() -> [Subject; 6] {
    macro_rules! fold {
        ($name:literal, $control:ident, $part:ident) => {
            subject!($name, LAW, |x| Ok(Ranged::Value(only(x, &Control::$control)?.$part)), |y| Ok(contact(y)?
                .critical(&Control::$control)?
                .$part))
        };
    }
    [
        fold!("folds, fixed grips, a", Indentation, contact_radius),
        fold!("folds, fixed grips, d", Indentation, indentation),
        fold!("folds, fixed grips, F", Indentation, force),
        fold!("folds, dead load, a", Force, contact_radius),
        fold!("folds, dead load, d", Force, indentation),
        fold!("folds, dead load, F", Force, force),
    ]
}

fn machine() -> [Subject; 2] {
    macro_rules! fold {
        ($name:literal, $part:ident) => {
            subject!(
                $name,
                MACHINE,
                |x| Ok(Ranged::Value(only(x, &Control::Machine { stiffness: x[4] })?.$part)),
                |y| Ok(contact(y)?.critical(&Control::Machine { stiffness: y[4].clone() })?.$part)
            )
        };
    }
    [fold!("folds, machine, a", contact_radius), fold!("folds, machine, F", force)]
}

pub(super) fn climbs(level: Level) -> Vec<Climb> {
    let law = |n: f64| vec![n, planted(n, 1.0), 1.0, 1.0];
    let mut laws = vec![
        // Nearer to 1/2 the other fold of the two controls is 10^±10⁵ away.
        Direction::new(Family::Half, "n → 1/2 from above", "n − 1/2", halvings(level, 2, 8), |t| law(0.5 + t)),
        Direction::new(Family::Half, "n → 1/2 from below", "1/2 − n", halvings(level, 2, 8), |t| law(0.5 - t)),
        Direction::new(Family::SmallExponent, "n → 0", "n", decades(level, -1, -12), law),
        Direction::new(Family::LargeExponent, "n → ∞", "n", decades(level, 0, 6), law),
    ];
    laws.extend(scales(level, LAW, &[2.0, 0.5, 1.0, 1.0], 2));
    let mut climbs = cross(&held(), &laws);
    let mut machines = Vec::new();
    for (n, end) in [(2.0, 300), (2.0, -300), (0.25, 300), (0.25, -300)] {
        let toward = format!("k → 10^{end}, n = {n}");
        machines.push(Direction::new(Family::Stiffness, toward, "k", decades(level, 0, end), |k| {
            [law(n), vec![k]].concat()
        }));
    }
    climbs.extend(cross(&machine(), &machines));
    climbs
}
