//! Given points and random points.

use mdr_analytic::{State, double};
use mdr_core::contact::{Control, Material, Ranged};
use rand::rngs::SmallRng;
use rand::{RngExt, SeedableRng};

use crate::common::coefficient_for;

pub(crate) const CONTROLS: [Control<f64>; 2] = [Control::Indentation, Control::Force];

#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    pub(crate) n: f64,
    pub(crate) c: f64,
    pub(crate) e: f64,
    pub(crate) w: f64,
}

impl Point {
    /// With C such that a is near `a` under controlled indentation.
    pub(crate) fn with_radius(n: f64, e: f64, w: f64, a: f64) -> Self {
        Point { n, c: coefficient_for(a, n, e, w, 1.0), e, w }
    }
}

/// The points with the same contact radii under `control`: 3C under a dead load.
pub(crate) fn loaded(points: &[Point], control: &Control<f64>) -> Vec<Point> {
    let factor = if matches!(control, Control::Force) { 3.0 } else { 1.0 };
    points.iter().map(|p| Point { c: p.c * factor, ..*p }).collect()
}

/// The points whose results are normal numbers (or d = 0).
pub(crate) fn representable(mut points: Vec<Point>, control: &Control<f64>) -> Vec<Point> {
    points.retain(|p| {
        let state = Material::new(p.e, p.w).and_then(|m| double::critical(p.n, p.c, &m, control));
        state.is_ok_and(|State { contact_radius, indentation, force }| {
            [contact_radius, indentation, force]
                .iter()
                .all(|x| matches!(x, Ranged::Value(v) if v.is_normal() || *v == 0.0))
        })
    });
    points
}

pub(crate) fn columns(points: &[Point]) -> [Vec<f64>; 4] {
    [|p: &Point| p.n, |p: &Point| p.c, |p: &Point| p.e, |p: &Point| p.w].map(|f| points.iter().map(f).collect())
}

pub(crate) struct Draw(SmallRng);

impl Draw {
    pub(crate) fn new(seed: u64) -> Self {
        Draw(SmallRng::seed_from_u64(seed))
    }

    pub(crate) fn between(&mut self, from: f64, to: f64) -> f64 {
        self.0.random_range(from..to)
    }

    pub(crate) fn power(&mut self, from: f64, to: f64) -> f64 {
        10f64.powf(self.between(from, to))
    }

    /// Laboratory values: a from 10 nm to 10 cm.
    pub(crate) fn laboratory(&mut self) -> Point {
        let (n, e, w) = (self.between(0.05, 4.0), self.power(3.0, 11.0), self.power(-3.0, 0.0));
        Point::with_radius(n, e, w, self.power(-8.0, -1.0))
    }

    /// The whole domain of the kernel, dense where the budget is largest: n → 0, n → 1/2, |ln a| → 200.
    pub(crate) fn domain(&mut self) -> Point {
        let n = match self.0.random_range(0..4) {
            0 => self.power(-9.0, 2.7),
            1 => self.between(0.001, 0.1),
            2 => 0.5 + self.power(-10.5, -0.5).copysign(self.between(-1.0, 1.0)),
            _ => self.between(0.1, 20.0),
        };
        let (e, w, a) = (self.power(-24.0, 24.0), self.power(-24.0, 24.0), self.between(-199.0, 198.0).exp());
        Point::with_radius(n.max(1e-9), e, w, a)
    }
}

pub(crate) fn in_range(p: &Point) -> bool {
    (1e-117..1e117).contains(&p.c)
}
