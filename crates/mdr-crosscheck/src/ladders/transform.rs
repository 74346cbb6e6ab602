//! g, g' and the mean of g by quadrature in f64, against the closed forms.

use mdr_analytic::{PowerLaw, profiles as closed};
use mdr_core::contact::{Ranged, Transform};
use mdr_numeric::profiles;
use mdr_numeric::transform::Quadrature;

use super::Family;
use super::functions::{exponents, scales};
use super::questions::{Climb, Direction, Subject, cross, decades, halvings, subject};
use crate::Level;

/// The three quadratures of one height.
macro_rules! quadrature {
    ($name:literal, $inputs:expr, |$p:ident| $height:expr, |$q:ident| $closed:expr) => {
        [
            subject!(
                concat!($name, "::g"),
                $inputs,
                |$p| Quadrature::new($height?).g(&$p[$p.len() - 1]).map(Ranged::Value),
                |$q| $closed?.g(&$q[$q.len() - 1])
            ),
            subject!(
                concat!($name, "::slope"),
                $inputs,
                |$p| Quadrature::new($height?).slope(&$p[$p.len() - 1]).map(Ranged::Value),
                |$q| $closed?.slope(&$q[$q.len() - 1])
            ),
            subject!(
                concat!($name, "::mean"),
                $inputs,
                |$p| Quadrature::new($height?).mean(&$p[$p.len() - 1]).map(Ranged::Value),
                |$q| $closed?.mean(&$q[$q.len() - 1])
            ),
        ]
    };
}

const POWER: &[&str] = &["n", "C", "x"];
const SPHERE: &[&str] = &["R", "x"];
const PUNCH: &[&str] = &["R", "b", "x"];
const WAVY: &[&str] = &["R", "A", "λ", "x"];

fn power() -> [Subject; 3] {
    quadrature!("Quadrature<Power>", POWER, |p| profiles::Power::new(p[0], p[1]), |q| PowerLaw::new(
        q[0].clone(),
        q[1].clone()
    ))
}

fn sphere() -> [Subject; 3] {
    quadrature!("Quadrature<Sphere>", SPHERE, |p| profiles::Sphere::new(p[0]), |q| closed::Sphere::new(q[0].clone()))
}

fn punch() -> [Subject; 3] {
    quadrature!("Quadrature<RoundedPunch>", PUNCH, |p| profiles::RoundedPunch::new(p[0], p[1]), |q| {
        closed::RoundedPunch::new(q[0].clone(), q[1].clone())
    })
}

fn wavy() -> [Subject; 3] {
    quadrature!("Quadrature<WavyParaboloid>", WAVY, |p| profiles::WavyParaboloid::new(p[0], p[1], p[2]), |q| {
        closed::WavyParaboloid::new(q[0].clone(), q[1].clone(), q[2].clone())
    })
}

pub(super) fn climbs(level: Level) -> Vec<Climb> {
    let mut powers = exponents(level, |n| vec![n, 1.0, 1.0 - 0.5 / (1.0 + n)]);
    // Steeper heights than r^1000 are known no better than their radii, which a quadrature has to step over.
    powers.retain(|direction| direction.family != Family::LargeExponent);
    powers.push(Direction::new(Family::LargeExponent, "n → ∞", "n", decades(level, 0, 3), |n| {
        vec![n, 1.0, 1.0 - 0.5 / (1.0 + n)]
    }));
    powers.extend(scales(level, POWER, &[1.5, 1.0, 1.0], 1));
    let mut climbs = cross(&power(), &powers);

    let both = |base: [f64; 2], end: i32| {
        Direction::new(Family::Scale, format!("all lengths → 10^{end}"), "factor", decades(level, 0, end), move |t| {
            base.map(|x| x * t).to_vec()
        })
    };
    let spheres = [
        Direction::new(Family::Tip, "x → 0", "x", decades(level, 0, -300), |x| vec![1.0, 0.9 * x]),
        Direction::new(Family::Edge, "x → R", "1 − x/R", halvings(level, 1, 53), |t| vec![1.0, 1.0 - t]),
        both([1.0, 0.5], 300),
        both([1.0, 0.5], -300),
    ];
    climbs.extend(cross(&sphere(), &spheres));
    let punches = [
        Direction::new(Family::Edge, "x → b from outside", "x/b − 1", halvings(level, 1, 52), |t| {
            vec![5.0, 1.0, 1.0 + t]
        }),
        Direction::new(Family::Far, "x → ∞", "x", decades(level, 1, 300), |x| vec![5.0, 1.0, x]),
    ];
    climbs.extend(cross(&punch(), &punches));
    let waves = [
        Direction::new(Family::Tip, "x → 0", "x", decades(level, -1, -300), |x| vec![1.0, 5e-4, 0.1, x]),
        // Five hundred waves are the patience of the quadrature.
        Direction::new(Family::Wavelength, "λ → 0", "λ", halvings(level, 0, 11), |t| vec![1.0, 5e-4, t, 0.17]),
    ];
    climbs.extend(cross(&wavy(), &waves));
    climbs
}
