//! The closed forms of the profile library and the Struve functions, as f64 has them.

use std::f64::consts::PI;

use mdr_analytic::Kappa;
use mdr_analytic::profiles::FlatPunch;
use mdr_analytic::struve::Struve;
use mdr_core::contact::{Ranged, Result, Transform};
use mdr_core::number::{Lift, Special};
use mdr_numeric::profiles::Heights;
use mdr_numeric::transform::Quadrature;

use super::routine::{Routine, Textbook, routine, routines};
use super::textbook;
use crate::library::{closed_form, ordered};

/// A function of the inputs: where a formula changes.
type Edge = fn(&[f64]) -> f64;

/// g, g' and ∫g of a profile; the last input is x.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ProfileRoutines {
    /// In scenes.
    pub(crate) name: &'static str,
    /// The public constructor of the closed form.
    pub(crate) constructor: &'static str,
    pub(crate) routines: [Routine; 3],
    /// An ordinary question.
    pub(crate) base: &'static [f64],
    /// The radius where the formula changes, if there is one.
    pub(crate) edge: Option<Edge>,
    /// Whether g is 0 within the edge.
    pub(crate) flat: bool,
    /// Whether the profile ends at the edge.
    pub(crate) ends: bool,
}

impl ProfileRoutines {
    const fn of([name, constructor]: [&'static str; 2], routines: [Routine; 3], base: &'static [f64]) -> Self {
        ProfileRoutines { name, constructor, routines, base, edge: None, flat: false, ends: false }
    }

    /// With another formula beyond a radius.
    const fn changing_at(self, edge: Edge) -> Self {
        ProfileRoutines { edge: Some(edge), ..self }
    }

    /// Flat up to the second input.
    const fn flat_to_second(self) -> Self {
        ProfileRoutines { edge: Some(second), flat: true, ..self }
    }

    /// The profile ends at the first input.
    const fn ending_at_first(self) -> Self {
        ProfileRoutines { edge: Some(first), ends: true, ..self }
    }
}

const fn first(x: &[f64]) -> f64 {
    x[0]
}

const fn second(x: &[f64]) -> f64 {
    x[1]
}

/// The profile of all inputs but the last.
fn library<R: Struve + Lift<R> + Kappa>(name: &str, inputs: &[R]) -> Result<Box<dyn Transform<R>>> {
    closed_form(ordered(name, &inputs[..inputs.len() - 1]))
}

/// The same by quadrature of its heights.
fn integrated(name: &str, inputs: &[f64]) -> Result<Quadrature<f64, Heights<f64>>> {
    Quadrature::of(ordered(name, &inputs[..inputs.len() - 1]))
}

/// The flat punch of the first input, which the library leaves out: g = 0.
fn flat_punch<R: Special>(inputs: &[R]) -> Result<FlatPunch<R>> {
    FlatPunch::new(inputs[0].clone())
}

/// x, the last input.
fn at<R>(inputs: &[R]) -> &R {
    &inputs[inputs.len() - 1]
}

/// g, g' and ∫g from an expression for the profile, with the formulas of textbooks for some of them.
macro_rules! parts {
    ($name:ident, $inputs:expr, |$x:ident| $profile:expr $(, $part:ident $formula:literal => $textbook:expr)*) => {{
        #[allow(unused_mut, reason = "some have no formula of textbooks")]
        let mut routines = [
            routine!(
                concat!(stringify!($name), "::g"), $inputs,
                |$x| $profile?.g(at($x)).map(Ranged::Value), exact $profile?.g(at($x))
            ),
            routine!(
                concat!(stringify!($name), "::slope"), $inputs,
                |$x| $profile?.slope(at($x)).map(Ranged::Value), exact $profile?.slope(at($x))
            ),
            routine!(
                concat!(stringify!($name), "::integral"), $inputs,
                |$x| $profile?.integral(at($x)).map(Ranged::Value), exact $profile?.integral(at($x))
            ),
        ];
        $(routines[PartIndex::$part as usize].textbook = Some(Textbook { formula: $formula, value: $textbook });)*
        routines
    }};
}

/// The same of a shape of the library.
macro_rules! profile {
    ($shape:ident $name:literal $inputs:tt $base:tt $($formulas:tt)*) => {
        ProfileRoutines::of(
            [$name, concat!(stringify!($shape), "::new")],
            parts!($shape, &$inputs, |x| library($name, x) $($formulas)*),
            &$base,
        )
    };
}

/// g, g' and the mean of g by quadrature of the heights of a shape, against its closed form; the last input is x.
macro_rules! quadrature {
    ($shape:ident $name:literal $inputs:tt) => {
        [
            quadrature!($shape $name $inputs g),
            quadrature!($shape $name $inputs slope),
            quadrature!($shape $name $inputs mean),
        ]
    };
    ($shape:ident $name:literal $inputs:tt $part:ident) => {
        routine!(
            concat!("Quadrature<", stringify!($shape), ">::", stringify!($part)), &$inputs,
            |x| integrated($name, x)?.$part(at(x)).map(Ranged::Value), exact library($name, x)?.$part(at(x))
        )
    };
}

/// The places of the three routines of a profile.
enum PartIndex {
    G,
    Slope,
    Integral,
}

/// All profiles with closed forms.
pub(crate) const PROFILES: [ProfileRoutines; 16] = [
    profile!(Cone "cone" ["slope", "x"] [0.2, 0.5]),
    profile!(Paraboloid "paraboloid" ["R", "x"] [1.0, 0.5]),
    profile!(Sphere "sphere" ["R", "x"] [1.0, 0.5],
    G "½x ln((R+x)/(R−x))" => |x| x[1] * textbook::artanh(x[1] / x[0]),
    Slope "artanh(x/R) + Rx/(R²−x²)" => |x| {
        textbook::artanh(x[1] / x[0]) + x[0] * x[1] / (x[0] * x[0] - x[1] * x[1])
    },
    Integral "½(x²−R²)artanh(x/R) + Rx/2" => |x| {
        0.5 * (x[1] * x[1] - x[0] * x[0]) * textbook::artanh(x[1] / x[0]) + x[0] * x[1] / 2.0
    })
    .ending_at_first(),
    profile!(Ellipsoid "ellipsoid" ["A", "c", "x"] [2.0, 0.5, 0.7],
    Integral "(c/A)[½(x²−A²)artanh(x/A) + Ax/2]" => |x| {
        x[1] / x[0] * (0.5 * (x[2] * x[2] - x[0] * x[0]) * textbook::artanh(x[2] / x[0]) + x[0] * x[2] / 2.0)
    })
    .ending_at_first(),
    profile!(Hyperboloid "hyperboloid" ["slope", "A", "x"] [0.7, 1.0, 0.5],
    Integral "½cotα[(x²+A²)arctan(x/A) − Ax]" => |x| {
        0.5 * x[0] * ((x[2] * x[2] + x[1] * x[1]) * (x[2] / x[1]).atan() - x[1] * x[2])
    }),
    profile!(Sum "sum" ["R", "slope", "x"] [1.0, 0.1, 0.5]),
    profile!(TruncatedCone "truncated-cone" ["slope", "b", "x"] [0.5, 1.0, 1.7],
    G "x t arccos(b/x)" => |x| x[2] * x[0] * (x[1] / x[2]).acos(),
    Slope "t[arccos(b/x) + b/√(x²−b²)]" => |x| x[0] * ((x[1] / x[2]).acos() + x[1] / textbook::leg(x[2], x[1])),
    Integral "½t[x² arccos(b/x) − b√(x²−b²)]" => |x| {
        0.5 * x[0] * (x[2] * x[2] * (x[1] / x[2]).acos() - x[1] * textbook::leg(x[2], x[1]))
    })
    .flat_to_second(),
    profile!(TruncatedParaboloid "truncated-paraboloid" ["R", "b", "x"] [5.0, 1.0, 1.7],
        G "(x/R)√(x²−b²)" => |x| x[2] / x[0] * textbook::leg(x[2], x[1]),
        Slope "(2x²−b²)/(R√(x²−b²))" => |x| (2.0 * x[2] * x[2] - x[1] * x[1]) / (x[0] * textbook::leg(x[2], x[1])),
        Integral "(x²−b²)^(3/2)/3R" => |x| textbook::leg(x[2], x[1]).powi(3) / (3.0 * x[0]))
    .flat_to_second(),
    profile!(RoundedPunch "rounded-punch" ["R", "b", "x"] [5.0, 1.0, 1.7],
    G "(x/R)[√(x²−b²) − b arccos(b/x)]" => |x| {
        x[2] / x[0] * (textbook::leg(x[2], x[1]) - x[1] * (x[1] / x[2]).acos())
    },
    Slope "[2√(x²−b²) − b arccos(b/x)]/R" => |x| {
        (2.0 * textbook::leg(x[2], x[1]) - x[1] * (x[1] / x[2]).acos()) / x[0]
    },
    Integral "[q³/3 − ½b(x² arccos(b/x) − bq)]/R" => |x| {
        let q = textbook::leg(x[2], x[1]);
        (q.powi(3) / 3.0 - 0.5 * x[1] * (x[2] * x[2] * (x[1] / x[2]).acos() - x[1] * q)) / x[0]
    })
    .flat_to_second(),
    profile!(ParabolicCapCone "cone-parabolic-cap" ["slope", "b", "x"] [0.5, 1.0, 1.7],
    G "tx[(x − √(x²−b²))/b + arccos(b/x)]" => |x| {
        let (t, b, x) = (x[0], x[1], x[2]);
        if x > b { t * x * ((x - textbook::leg(x, b)) / b + (b / x).acos()) } else { t * x * x / b }
    })
    .changing_at(second),
    profile!(ParabolicDimple "parabolic-dimple" ["h", "b", "x"] [0.1, 1.0, 1.7],
    G "−(2hx/b²)(x − √(x²−b²))" => |x| {
        let (h, b, x) = (x[0], x[1], x[2]);
        -2.0 * h * x / (b * b) * if x > b { x - textbook::leg(x, b) } else { x }
    },
    Integral "−(2h/3b²)(x³ − (x²−b²)^(3/2))" => |x| {
        let (h, b, x) = (x[0], x[1], x[2]);
        -2.0 * h / (3.0 * b * b) * (x.powi(3) - if x > b { textbook::leg(x, b).powi(3) } else { 0.0 })
    })
    .changing_at(second),
    profile!(EllipticalDimple "elliptical-dimple" ["h", "b", "x"] [0.1, 1.0, 1.7],
    G "−(hx/b) artanh(b/x), as half a logarithm" => |x| {
        let (h, b, x) = (x[0], x[1], x[2]);
        -h * x / b * textbook::artanh(if x > b { b / x } else { x / b })
    },
    Integral "−(h/b)½[(x²−b²)artanh(b/x) + bx]" => |x| {
        let (h, b, x) = (x[0], x[1], x[2]);
        let t = if x > b { b / x } else { x / b };
        -h / b * 0.5 * ((x * x - b * b) * textbook::artanh(t) + b * x)
    })
    .changing_at(second),
    profile!(SphericalCapCone "cone-spherical-cap" ["slope", "R", "x"] [0.75, 1.0, 1.7],
    G "x ln[(R+x)/(√(R²−b²) + √(x²−b²))] + xt arccos(b/x)" => |x| {
        let (t, r, x) = (x[0], x[1], x[2]);
        let b = r * t / (1.0 + t * t).sqrt();
        if x <= b { return x * textbook::artanh(x / r) }
        x * ((r + x) / (textbook::leg(r, b) + textbook::leg(x, b))).ln() + x * t * (b / x).acos()
    })
    .changing_at(|x| x[1] * x[0] / (1.0 + x[0] * x[0]).sqrt()),
    ProfileRoutines::of(
        ["flat-punch", "FlatPunch::new"],
        parts!(FlatPunch, &["b", "x"], |x| flat_punch(x)),
        &[1.0, 0.5],
    )
    .ending_at_first(),
    DISPLACED_PARABOLOID,
    WAVY_PARABOLOID,
];

pub(crate) const DISPLACED_PARABOLOID: ProfileRoutines =
    profile!(DisplacedParaboloid "displaced-paraboloid" ["R", "b", "x"] [2.0, 0.5, 0.4]);

pub(crate) const WAVY_PARABOLOID: ProfileRoutines = profile!(WavyParaboloid "wavy-paraboloid" ["R", "A", "λ", "x"] [1.0, 5e-4, 0.1, 0.07],
G "x²/R + (π/2)Akx H₀(kx), its power series" => |x| {
    let z = 2.0 * PI / x[2] * x[3];
    x[3] * x[3] / x[0] + PI / 2.0 * x[1] * z * textbook::struve_h0(z)
});

pub(crate) const POWER_QUADRATURE: [Routine; 3] = quadrature!(Power "power" ["n", "C", "x"]);
pub(crate) const SPHERE_QUADRATURE: [Routine; 3] = quadrature!(Sphere "sphere" ["R", "x"]);
pub(crate) const PUNCH_QUADRATURE: [Routine; 3] = quadrature!(RoundedPunch "rounded-punch" ["R", "b", "x"]);
pub(crate) const WAVES_QUADRATURE: [Routine; 3] = quadrature!(WavyParaboloid "wavy-paraboloid" ["R", "A", "λ", "x"]);

routines! {
    STRUVE ["z"] {
        "struve_h0": |x| Ok(Ranged::Value(x[0].struve_h0())), exact Ok(x[0].struve_h0()),
            textbook "power series" => textbook::struve_h0(x[0]);
        "struve_h1": |x| Ok(Ranged::Value(x[0].struve_h1())), exact Ok(x[0].struve_h1());
    }
}
