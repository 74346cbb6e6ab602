//! Contacts with an instability, and the exact place of it.

use mdr_analytic::profiles as closed;
use mdr_core::contact::{Material, Result, Transform};
use mdr_core::number::{Interval, Precision, Real, Special};
use mdr_numeric::profiles::{Power, WavyParaboloid};
use mdr_numeric::transform::Quadrature;

use crate::contest::kappa;

/// Bits in which the truth is computed.
pub(super) const BITS: u32 = 128;

/// A profile; lengths in m.
#[derive(Clone, Copy)]
pub(super) enum Shape {
    /// C rⁿ.
    Power { n: f64, c: f64 },
    /// r²/2R + A(1 − cos 2πr/λ).
    Wavy { radius: f64, amplitude: f64, wavelength: f64 },
}

/// What is asked, and what a method may know beforehand.
pub(super) struct Question {
    /// In the names of files.
    pub(super) name: &'static str,
    /// For a reader.
    pub(super) told: &'static str,
    pub(super) shape: Shape,
    /// E* in Pa and w in J/m².
    pub(super) material: [f64; 2],
    /// Radii around the instability and no other one.
    pub(super) bracket: [f64; 2],
    /// The springs stand up to this radius.
    pub(super) reach: f64,
}

/// The exact radius and indentation.
pub(super) type State = [Interval; 2];

const SHARP: [f64; 2] = [1.0, 0.0625];

pub(super) const QUESTIONS: [Question; 5] = [
    Question {
        name: "2",
        told: "a paraboloid",
        shape: Shape::Power { n: 2.0, c: 1.0 },
        material: SHARP,
        bracket: [0.05, 0.7],
        reach: 0.5,
    },
    Question {
        name: "1",
        told: "a cone",
        shape: Shape::Power { n: 1.0, c: 1.0 },
        material: SHARP,
        bracket: [0.01, 0.14],
        reach: 0.125,
    },
    Question {
        name: "0.25",
        told: "a sharp tip, n = 1/4",
        shape: Shape::Power { n: 0.25, c: 1.0 },
        material: SHARP,
        bracket: [0.2, 2.8],
        reach: 2.0,
    },
    Question {
        name: "3.7",
        told: "a power law, n = 3.7",
        shape: Shape::Power { n: 3.7, c: 1.0 },
        material: SHARP,
        bracket: [0.1, 1.4],
        reach: 1.0,
    },
    Question {
        name: "wavy",
        told: "a wavy paraboloid, the first on pulling",
        shape: Shape::Wavy { radius: 1.0, amplitude: 5e-4, wavelength: 0.1 },
        material: [1.0, 1e-4],
        bracket: [0.058, 0.09],
        reach: 0.1,
    },
];

impl Shape {
    fn inputs(self) -> Vec<f64> {
        match self {
            Shape::Power { n, c } => vec![n, c],
            Shape::Wavy { radius, amplitude, wavelength } => vec![radius, amplitude, wavelength],
        }
    }

    fn with(self, inputs: &[f64]) -> Self {
        match (self, inputs) {
            (Shape::Power { .. }, &[n, c, ..]) => Shape::Power { n, c },
            (Shape::Wavy { .. }, &[radius, amplitude, wavelength, ..]) => Shape::Wavy { radius, amplitude, wavelength },
            _ => self,
        }
    }

    /// By quadrature: what every method but the closed forms starts from.
    pub(super) fn transform<R: Special>(self, ctx: R::Ctx) -> Result<Box<dyn Transform<R>>> {
        let number = |x: f64| R::from_f64(ctx, x);
        Ok(match self {
            Shape::Power { n, c } => Box::new(Quadrature::new(Power::new(number(n), number(c))?)),
            Shape::Wavy { radius, amplitude, wavelength } => {
                Box::new(Quadrature::new(WavyParaboloid::new(number(radius), number(amplitude), number(wavelength))?))
            }
        })
    }

    /// Enclosures of g and g'.
    fn enclosed(self, x: &Interval) -> Result<[Interval; 2]> {
        let number = |value: f64| Interval::from_f64(x.ctx(), value);
        match self {
            Shape::Power { n, c } => {
                let n = number(n);
                let g = kappa::exact(&n) * number(c) * x.pow(&n);
                Ok([g.clone(), g * n / x])
            }
            Shape::Wavy { radius, amplitude, wavelength } => {
                let profile = closed::WavyParaboloid::new(number(radius), number(amplitude), number(wavelength))?;
                Ok([profile.g(x)?, profile.slope(x)?])
            }
        }
    }
}

impl Question {
    pub(super) fn material(&self) -> Result<Material<f64>> {
        let [e_star, work] = self.material;
        Material::new(e_star, work)
    }

    /// Whether the contact breaks there; else it spreads.
    pub(super) fn breaks(&self) -> bool {
        !matches!(self.shape, Shape::Power { n, .. } if n < 0.5)
    }

    /// Why no method shares code with the truth.
    pub(super) fn independence(&self) -> &'static str {
        match self.shape {
            Shape::Power { .. } => "κ_n from the Γ of MPFR, which no contestant uses",
            Shape::Wavy { .. } => "g by Struve functions, where every contestant has a quadrature",
        }
    }

    /// The exact state.
    pub(super) fn truth(&self) -> State {
        truth(self.shape, self.material, self.bracket)
    }

    /// Sums of |∂ ln y/∂ ln x| over the inputs x, for the radius and for the indentation.
    pub(super) fn conditions(&self, truth: &State) -> [f64; 2] {
        /// A small step that is exact in every input and leaves half of the bits of the truth.
        const STEP: f64 = 1.0 / (1u64 << 30) as f64;
        let inputs: Vec<f64> = self.shape.inputs().into_iter().chain(self.material).collect();
        let mut sums = [0.0; 2];
        for index in 0..inputs.len() {
            let mut moved = inputs.clone();
            moved[index] *= 1.0 + STEP;
            let material = [moved[moved.len() - 2], moved[moved.len() - 1]];
            let beside = self::truth(self.shape.with(&moved), material, self.bracket);
            for ((sum, from), to) in sums.iter_mut().zip(truth).zip(&beside) {
                *sum += ((to.clone() / from - from.lit(1)).approx() / STEP).abs();
            }
        }
        sums
    }
}

/// Halves the bracket as long as the sign of g' − Δl' in the middle is certain.
fn truth(shape: Shape, material: [f64; 2], bracket: [f64; 2]) -> State {
    let precision = Precision::new(BITS);
    let [e_star, work] = material.map(|x| Interval::from_f64(precision, x));
    let length = work / e_star;
    let nothing = || Interval::entire(precision);
    // Δl' = √(πw/(2E*a)).
    let excess = |a: &Interval| match shape.enclosed(a) {
        Ok([_, slope]) => slope - (length.clone() * a.pi() / a.clone().times(2)).sqrt(),
        Err(_) => nothing(),
    };
    let [mut lower, mut upper] = bracket.map(|x| Interval::from_f64(precision, x));
    let zero = lower.lit(0);
    let rising = excess(&lower) < zero;
    for _ in 0..2 * BITS {
        let middle = (lower.clone() + &upper).over(2).steer();
        match excess(&middle).partial_cmp(&zero) {
            Some(order) if order.is_lt() == rising => lower = middle,
            Some(order) if order.is_ne() => upper = middle,
            _ => break,
        }
    }
    let radius = lower.hull(&upper);
    let indentation = match shape.enclosed(&radius) {
        Ok([g, _]) => g - (length * radius.pi() * &radius).times(2).sqrt(),
        Err(_) => nothing(),
    };
    [radius, indentation]
}
