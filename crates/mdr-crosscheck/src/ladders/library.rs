//! The closed forms of the profile library and the Struve functions, as f64 has them.

use std::f64::consts::PI;

use mdr_analytic::profiles as closed;
use mdr_analytic::struve::Struve;
use mdr_core::contact::{Ranged, Result, Transform};

use super::questions::{Climb, Direction, Subject, cross, decades, halvings, subject};
use super::{Family, naive};
use crate::Level;

/// g, g' and ∫g of one profile, from an expression for it in the inputs; the last input is x.
macro_rules! profile {
    ($name:literal, $inputs:expr, |$p:ident| $new:expr $(, $part:ident $formula:literal => $naive:expr)*) => {{
        #[allow(unused_mut, reason = "some have no naive formula")]
        let mut subjects = [
            subject!(concat!($name, "::g"), $inputs,
                |x| { let $p = x; $new?.g(at(x)).map(Ranged::Value) }, |y| { let $p = y; $new?.g(at(y)) }),
            subject!(concat!($name, "::slope"), $inputs,
                |x| { let $p = x; $new?.slope(at(x)).map(Ranged::Value) }, |y| { let $p = y; $new?.slope(at(y)) }),
            subject!(concat!($name, "::integral"), $inputs,
                |x| { let $p = x; $new?.integral(at(x)).map(Ranged::Value) }, |y| { let $p = y; $new?.integral(at(y)) }),
        ];
        $(subjects[Part::$part as usize].naive = Some(super::questions::Naive { formula: $formula, value: $naive });)*
        subjects
    }};
}

/// The places of the three subjects of a profile.
enum Part {
    G,
    Slope,
    Integral,
}

/// x.
fn at<R>(inputs: &[R]) -> &R {
    &inputs[inputs.len() - 1]
}

/// An input of its own.
fn own<R: Clone>(inputs: &[R], index: usize) -> R {
    inputs[index].clone()
}

/// Where a formula changes, from the inputs.
type Edge = fn(&[f64]) -> f64;

/// Inputs of a profile, with which of them are lengths.
struct Shape {
    subjects: [Subject; 3],
    /// An ordinary question.
    base: &'static [f64],
    /// Which inputs are lengths.
    lengths: &'static [usize],
    /// Where the formula changes, from the inputs, and whether it is more than 0 inside.
    edge: Option<(Edge, bool)>,
    /// Whether the profile ends there.
    ends: bool,
}

fn shapes() -> Vec<Shape> {
    let mut shapes = smooth();
    shapes.extend(flat_ended());
    shapes.extend(changing());
    shapes.extend(walled());
    shapes.extend(concave());
    shapes
}

fn smooth() -> Vec<Shape> {
    let plain = |subjects, base, lengths| Shape { subjects, base, lengths, edge: None, ends: false };
    vec![
        plain(profile!("Cone", &["slope", "x"], |p| closed::Cone::new(own(p, 0))), &[0.2, 0.5], &[1]),
        plain(profile!("Paraboloid", &["R", "x"], |p| closed::Paraboloid::new(own(p, 0))), &[1.0, 0.5], &[0, 1]),
        Shape {
            subjects: profile!("Sphere", &["R", "x"], |p| closed::Sphere::new(own(p, 0)),
            G "½x ln((R+x)/(R−x))" => |x| x[1] * naive::artanh(x[1] / x[0]),
            Slope "artanh(x/R) + Rx/(R²−x²)" => |x| naive::artanh(x[1] / x[0]) + x[0] * x[1] / (x[0] * x[0] - x[1] * x[1]),
            Integral "½(x²−R²)artanh(x/R) + Rx/2" => |x| {
                0.5 * (x[1] * x[1] - x[0] * x[0]) * naive::artanh(x[1] / x[0]) + x[0] * x[1] / 2.0
            }),
            base: &[1.0, 0.5],
            lengths: &[0, 1],
            edge: Some((|x| x[0], true)),
            ends: true,
        },
        Shape {
            subjects: profile!("Ellipsoid", &["A", "c", "x"], |p| closed::Ellipsoid::new(own(p, 0), own(p, 1)),
            Integral "(c/A)[½(x²−A²)artanh(x/A) + Ax/2]" => |x| {
                x[1] / x[0] * (0.5 * (x[2] * x[2] - x[0] * x[0]) * naive::artanh(x[2] / x[0]) + x[0] * x[2] / 2.0)
            }),
            base: &[2.0, 0.5, 0.7],
            lengths: &[0, 1, 2],
            edge: Some((|x| x[0], true)),
            ends: true,
        },
        plain(
            profile!("Hyperboloid", &["slope", "A", "x"], |p| closed::Hyperboloid::new(own(p, 0), own(p, 1)),
            Integral "½cotα[(x²+A²)arctan(x/A) − Ax]" => |x| {
                0.5 * x[0] * ((x[2] * x[2] + x[1] * x[1]) * (x[2] / x[1]).atan() - x[1] * x[2])
            }),
            &[0.7, 1.0, 0.5],
            &[1, 2],
        ),
        plain(
            profile!("Sum", &["R", "slope", "x"], |p| {
                let terms: [Result<Box<dyn Transform<_>>>; 2] = [
                    closed::Paraboloid::new(own(p, 0)).map(|term| Box::new(term) as Box<dyn Transform<_>>),
                    closed::Cone::new(own(p, 1)).map(|term| Box::new(term) as Box<dyn Transform<_>>),
                ];
                terms.into_iter().collect::<Result<Vec<_>>>().map(closed::Sum::new)
            }),
            &[1.0, 0.1, 0.5],
            &[0, 2],
        ),
    ]
}

/// A profile whose second input is the radius where its formula changes; `inside` tells whether it is more than 0 within.
fn edged(subjects: [Subject; 3], base: &'static [f64], lengths: &'static [usize], inside: bool) -> Shape {
    Shape { subjects, base, lengths, edge: Some((|x| x[1], inside)), ends: false }
}

/// Flat up to a radius.
fn flat_ended() -> Vec<Shape> {
    vec![
        edged(
            profile!("TruncatedCone", &["slope", "b", "x"], |p| closed::TruncatedCone::new(own(p, 0), own(p, 1)),
            G "x t arccos(b/x)" => |x| x[2] * x[0] * (x[1] / x[2]).acos(),
            Slope "t[arccos(b/x) + b/√(x²−b²)]" => |x| x[0] * ((x[1] / x[2]).acos() + x[1] / naive::leg(x[2], x[1])),
            Integral "½t[x² arccos(b/x) − b√(x²−b²)]" => |x| {
                0.5 * x[0] * (x[2] * x[2] * (x[1] / x[2]).acos() - x[1] * naive::leg(x[2], x[1]))
            }),
            &[0.5, 1.0, 1.7],
            &[1, 2],
            false,
        ),
        edged(
            profile!("TruncatedParaboloid", &["R", "b", "x"], |p| closed::TruncatedParaboloid::new(own(p, 0), own(p, 1)),
                G "(x/R)√(x²−b²)" => |x| x[2] / x[0] * naive::leg(x[2], x[1]),
                Slope "(2x²−b²)/(R√(x²−b²))" => |x| (2.0 * x[2] * x[2] - x[1] * x[1]) / (x[0] * naive::leg(x[2], x[1])),
                Integral "(x²−b²)^(3/2)/3R" => |x| naive::leg(x[2], x[1]).powi(3) / (3.0 * x[0])),
            &[5.0, 1.0, 1.7],
            &[0, 1, 2],
            false,
        ),
        edged(
            profile!("RoundedPunch", &["R", "b", "x"], |p| closed::RoundedPunch::new(own(p, 0), own(p, 1)),
            G "(x/R)[√(x²−b²) − b arccos(b/x)]" => |x| x[2] / x[0] * (naive::leg(x[2], x[1]) - x[1] * (x[1] / x[2]).acos()),
            Slope "[2√(x²−b²) − b arccos(b/x)]/R" => |x| (2.0 * naive::leg(x[2], x[1]) - x[1] * (x[1] / x[2]).acos()) / x[0],
            Integral "[q³/3 − ½b(x² arccos(b/x) − bq)]/R" => |x| {
                let q = naive::leg(x[2], x[1]);
                (q.powi(3) / 3.0 - 0.5 * x[1] * (x[2] * x[2] * (x[1] / x[2]).acos() - x[1] * q)) / x[0]
            }),
            &[5.0, 1.0, 1.7],
            &[0, 1, 2],
            false,
        ),
    ]
}

/// Of one formula within a radius and another beyond: rounded tips and hollows.
fn changing() -> Vec<Shape> {
    vec![
        edged(
            profile!("ParabolicCapCone", &["slope", "b", "x"], |p| closed::ParabolicCapCone::new(own(p, 0), own(p, 1)),
            G "tx[(x − √(x²−b²))/b + arccos(b/x)]" => |x| {
                let (t, b, x) = (x[0], x[1], x[2]);
                if x > b { t * x * ((x - naive::leg(x, b)) / b + (b / x).acos()) } else { t * x * x / b }
            }),
            &[0.5, 1.0, 1.7],
            &[1, 2],
            true,
        ),
        edged(
            profile!("ParabolicDimple", &["h", "b", "x"], |p| closed::ParabolicDimple::new(own(p, 0), own(p, 1)),
            G "−(2hx/b²)(x − √(x²−b²))" => |x| {
                let (h, b, x) = (x[0], x[1], x[2]);
                -2.0 * h * x / (b * b) * if x > b { x - naive::leg(x, b) } else { x }
            },
            Integral "−(2h/3b²)(x³ − (x²−b²)^(3/2))" => |x| {
                let (h, b, x) = (x[0], x[1], x[2]);
                -2.0 * h / (3.0 * b * b) * (x.powi(3) - if x > b { naive::leg(x, b).powi(3) } else { 0.0 })
            }),
            &[0.1, 1.0, 1.7],
            &[0, 1, 2],
            true,
        ),
        edged(
            profile!("EllipticalDimple", &["h", "b", "x"], |p| closed::EllipticalDimple::new(own(p, 0), own(p, 1)),
            G "−(hx/b) artanh(b/x), as half a logarithm" => |x| {
                let (h, b, x) = (x[0], x[1], x[2]);
                -h * x / b * naive::artanh(if x > b { b / x } else { x / b })
            },
            Integral "−(h/b)½[(x²−b²)artanh(b/x) + bx]" => |x| {
                let (h, b, x) = (x[0], x[1], x[2]);
                let t = if x > b { b / x } else { x / b };
                -h / b * 0.5 * ((x * x - b * b) * naive::artanh(t) + b * x)
            }),
            &[0.1, 1.0, 1.7],
            &[0, 1, 2],
            true,
        ),
        Shape {
            subjects: profile!("SphericalCapCone", &["slope", "R", "x"], |p| closed::SphericalCapCone::new(own(p, 0), own(p, 1)),
            G "x ln[(R+x)/(√(R²−b²) + √(x²−b²))] + xt arccos(b/x)" => |x| {
                let (t, r, x) = (x[0], x[1], x[2]);
                let b = r * t / (1.0 + t * t).sqrt();
                if x <= b { return x * naive::artanh(x / r) }
                x * ((r + x) / (naive::leg(r, b) + naive::leg(x, b))).ln() + x * t * (b / x).acos()
            }),
            base: &[0.75, 1.0, 1.7],
            lengths: &[1, 2],
            edge: Some((|x| x[1] * x[0] / (1.0 + x[0] * x[0]).sqrt(), true)),
            ends: false,
        },
    ]
}

/// Flat, and nothing beyond.
fn walled() -> Vec<Shape> {
    vec![Shape {
        subjects: profile!("FlatPunch", &["b", "x"], |p| closed::FlatPunch::new(own(p, 0))),
        base: &[1.0, 0.5],
        lengths: &[0, 1],
        edge: Some((|x| x[0], true)),
        ends: true,
    }]
}

fn concave() -> Vec<Shape> {
    vec![
        Shape {
            subjects: profile!("DisplacedParaboloid", &["R", "b", "x"], |p| closed::DisplacedParaboloid::new(
                own(p, 0),
                own(p, 1)
            )),
            base: &[2.0, 0.5, 0.4],
            lengths: &[0, 1, 2],
            edge: None,
            ends: false,
        },
        Shape {
            subjects: profile!("WavyParaboloid", &["R", "A", "λ", "x"],
            |p| closed::WavyParaboloid::new(own(p, 0), own(p, 1), own(p, 2)),
            G "x²/R + (π/2)Akx H₀(kx), its power series" => |x| {
                let z = 2.0 * PI / x[2] * x[3];
                x[3] * x[3] / x[0] + PI / 2.0 * x[1] * z * naive::struve_h0(z)
            }),
            base: &[1.0, 5e-4, 0.1, 0.07],
            lengths: &[0, 1, 2, 3],
            edge: None,
            ends: false,
        },
    ]
}

impl Shape {
    /// The base with another last input.
    fn with(&self, x: f64) -> Vec<f64> {
        let mut inputs = self.base.to_vec();
        inputs.splice(inputs.len() - 1.., [x]);
        inputs
    }

    fn directions(&self, level: Level) -> Vec<Direction> {
        let mut directions =
            vec![Direction::new(Family::Tip, "x → 0", "x", decades(level, 0, -300), |x| self.with(x))];
        if !self.ends {
            directions.push(Direction::new(Family::Far, "x → ∞", "x", decades(level, 0, 300), |x| self.with(x)));
        }
        if let Some((edge, inside)) = self.edge {
            let b = edge(self.base);
            if inside {
                let rungs = halvings(level, 1, 53);
                directions.push(Direction::new(Family::Edge, "x → b from inside", "1 − x/b", rungs, |t| {
                    self.with(b * (1.0 - t))
                }));
            }
            if !self.ends {
                let rungs = halvings(level, 1, 52);
                directions.push(Direction::new(Family::Edge, "x → b from outside", "x/b − 1", rungs, |t| {
                    self.with(b * (1.0 + t))
                }));
            }
        }
        directions.extend(self.scales(level));
        directions
    }

    /// All lengths together, and each input but x alone.
    fn scales(&self, level: Level) -> Vec<Direction> {
        let scaled = |end: i32, which: Vec<usize>, name: String| {
            Direction::new(Family::Scale, format!("{name} → 10^{end}"), "factor", decades(level, 0, end), |t| {
                self.base.iter().enumerate().map(|(i, x)| if which.contains(&i) { x * t } else { *x }).collect()
            })
        };
        let names = self.subjects[0].inputs;
        // The waves have a ladder of their own.
        let alone = (0..self.base.len() - 1).filter(|i| names[*i] != "λ").map(|i| (vec![i], names[i].to_owned()));
        let which = [(self.lengths.to_vec(), "all lengths".to_owned())].into_iter().chain(alone);
        which.flat_map(|(which, name)| [scaled(300, which.clone(), name.clone()), scaled(-300, which, name)]).collect()
    }
}

fn struve() -> [Subject; 2] {
    [
        subject!("struve_h0", &["z"], |x| Ok(Ranged::Value(x[0].struve_h0())), |y| Ok(y[0].struve_h0()),
            naive "power series" => |x| naive::struve_h0(x[0])),
        subject!("struve_h1", &["z"], |x| Ok(Ranged::Value(x[0].struve_h1())), |y| Ok(y[0].struve_h1())),
    ]
}

/// To the zero of g, g' or ∫g of the displaced paraboloid: x = πb/2, πb/4, 3πb/4; and to a joint of the tables of H.
fn special(level: Level) -> Vec<Climb> {
    let mut climbs = Vec::new();
    for (subject, factor) in concave()[0].subjects.iter().zip([0.5, 0.25, 0.75]) {
        for (sign, toward) in [(1.0, "x → the zero from above"), (-1.0, "x → the zero from below")] {
            let rungs = halvings(level, 2, 52);
            let direction = Direction::new(Family::Zero, toward, "|x/x₀ − 1|", rungs, |t| {
                vec![2.0, 0.5, factor * PI * 0.5 * (1.0 + sign * t)]
            });
            climbs.push(Climb { subject: *subject, direction });
        }
    }
    let waves = &concave()[1];
    let directions = [
        Direction::new(Family::Wavelength, "λ → 0", "λ", decades(level, 0, -18), |t| vec![1.0, 5e-4, t, 0.07]),
        Direction::new(Family::Wavelength, "λ → 0 at A ∝ λ²", "λ", decades(level, 0, -18), |t| {
            vec![1.0, t * t / 40.0, t, 0.07]
        }),
        Direction::new(Family::Wavelength, "λ → 0 at A ∝ λ³", "λ", decades(level, 0, -18), |t| {
            vec![1.0, t * t * t, t, 0.07]
        }),
        Direction::new(Family::Edge, "kx → 3 from above", "kx/3 − 1", halvings(level, 3, 50), |t| {
            vec![1.0, 5e-4, 0.1, 0.3 / (2.0 * PI) * (1.0 + t)]
        }),
    ];
    climbs.extend(cross(&waves.subjects, &directions));
    let directions = [
        Direction::new(Family::Tip, "z → 0", "z", decades(level, 0, -300), |z| vec![z]),
        Direction::new(Family::Far, "z → ∞", "z", decades(level, 0, 18), |z| vec![z]),
        // The first zero of H₀; H₁ has none.
        Direction::new(Family::Zero, "z → the first zero of H₀", "z/z₀ − 1", halvings(level, 2, 52), |t| {
            vec![4.332_752_2 * (1.0 + t)]
        }),
        Direction::new(Family::Edge, "z → 3 from above", "z/3 − 1", halvings(level, 2, 51), |t| {
            vec![3.0 * (1.0 + t)]
        }),
        Direction::new(Family::Edge, "z → 3 from below", "1 − z/3", halvings(level, 2, 52), |t| {
            vec![3.0 * (1.0 - t)]
        }),
    ];
    climbs.extend(cross(&struve(), &directions));
    climbs
}

pub(super) fn climbs(level: Level) -> Vec<Climb> {
    let mut climbs = Vec::new();
    for shape in shapes() {
        climbs.extend(cross(&shape.subjects, &shape.directions(level)));
    }
    climbs.extend(special(level));
    climbs
}
