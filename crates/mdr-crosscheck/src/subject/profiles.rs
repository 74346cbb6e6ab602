//! The profiles of the library by their names in scenes and records, as closed forms and as shapes; and their closed forms and
//! the Struve functions, as f64 has them.

use std::f64::consts::PI;

use mdr_analytic::profiles::{self as closed, ClosedReal, FlatPunch};
use mdr_analytic::struve::Struve;
use mdr_core::contact::{Ranged, Result, Shape, Transform};
use mdr_core::number::{Real, Special};
use mdr_numeric::profiles::Heights;
use mdr_numeric::transform::Quadrature;

use super::routine::{Routine, routine, routines};
use super::textbook;

/// A paraboloid and a cone together.
const SUM: &str = "sum";

/// Every profile with a closed form that is no power law, in the order of the trials.
pub(crate) const NAMES: [&str; 15] = [
    "cone",
    "paraboloid",
    "sphere",
    "ellipsoid",
    "hyperboloid",
    "truncated-cone",
    "truncated-paraboloid",
    "rounded-punch",
    "cone-parabolic-cap",
    "cone-spherical-cap",
    "displaced-paraboloid",
    "parabolic-dimple",
    "elliptical-dimple",
    "wavy-paraboloid",
    SUM,
];

/// The shapes of which the profile with this name is the sum; `parameter` gets the key of each parameter.
pub(crate) fn terms<R>(name: &str, mut parameter: impl FnMut(&'static str) -> R) -> Vec<Shape<R>> {
    let names = if name == SUM { vec!["paraboloid", "cone"] } else { vec![name] };
    names.into_iter().filter_map(Shape::by_name).map(|blank| blank.map(|key, ()| parameter(key))).collect()
}

/// The shapes of a profile with all inputs but the last for parameters, in the order of [`Shape::parameters`]. A parameter
/// that is not given is no number.
fn ordered<R: Real>(name: &str, inputs: &[R]) -> Vec<Shape<R>> {
    let mut given = inputs[..inputs.len() - 1].iter().cloned();
    terms(name, |_| given.next().unwrap_or_else(|| inputs[0].lit(0).over(0)))
}

/// The closed form of a sum of shapes.
///
/// # Errors
/// Parameters out of their domain.
pub(crate) fn closed_form<R: ClosedReal>(terms: Vec<Shape<R>>) -> Result<Box<dyn Transform<R>>> {
    let mut terms = terms.into_iter().map(closed::closed_form).collect::<Result<Vec<_>>>()?;
    Ok(if terms.len() == 1 { terms.remove(0) } else { R::sum(terms) })
}

/// g, g' and ∫g of a profile; the last input is x.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ProfileRoutines {
    /// In scenes.
    pub(crate) name: &'static str,
    /// The public constructor of the closed form.
    pub(crate) constructor: &'static str,
    pub(crate) routines: [Routine; 3],
}

/// The profile of all inputs but the last.
fn library<R: ClosedReal>(name: &str, inputs: &[R]) -> Result<Box<dyn Transform<R>>> {
    closed_form(ordered(name, inputs))
}

/// The profile of all inputs but the last, by quadrature of its heights.
fn integrated(name: &str, inputs: &[f64]) -> Result<Quadrature<f64, Heights<f64>>> {
    Quadrature::of(ordered(name, inputs))
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
    (only $part:ident, $name:ident, $inputs:expr, |$x:ident| $profile:expr $(, $formula:literal => $textbook:expr)?) => {
        Routine {
            textbook: routine!(textbook $($formula => $textbook)?),
            ..routine!(
                concat!(stringify!($name), "::", stringify!($part)), $inputs,
                |$x| $profile?.$part(at($x)).map(Ranged::Value), exact $profile?.$part(at($x))
            )
        }
    };
    (
        $name:ident, $inputs:expr, |$x:ident| $profile:expr
        $(, G $g:literal => $by_g:expr)? $(, Slope $slope:literal => $by_slope:expr)?
        $(, Integral $integral:literal => $by_integral:expr)?
    ) => {
        [
            parts!(only g, $name, $inputs, |$x| $profile $(, $g => $by_g)?),
            parts!(only slope, $name, $inputs, |$x| $profile $(, $slope => $by_slope)?),
            parts!(only integral, $name, $inputs, |$x| $profile $(, $integral => $by_integral)?),
        ]
    };
}

/// g, g' and ∫g of a shape of the library; the last input is x.
macro_rules! profile {
    ($shape:ident $name:literal $inputs:tt $($formulas:tt)*) => {
        ProfileRoutines {
            name: $name,
            constructor: concat!(stringify!($shape), "::new"),
            routines: parts!($shape, &$inputs, |x| library($name, x) $($formulas)*),
        }
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

/// All profiles with closed forms.
pub(crate) const PROFILES: [ProfileRoutines; 16] = [
    profile!(Cone "cone" ["slope", "x"]),
    profile!(Paraboloid "paraboloid" ["R", "x"]),
    profile!(Sphere "sphere" ["R", "x"],
    G "½x ln((R+x)/(R−x))" => |x| x[1] * textbook::artanh(x[1] / x[0]),
    Slope "artanh(x/R) + Rx/(R²−x²)" => |x| {
        textbook::artanh(x[1] / x[0]) + x[0] * x[1] / (x[0] * x[0] - x[1] * x[1])
    },
    Integral "½(x²−R²)artanh(x/R) + Rx/2" => |x| {
        0.5 * (x[1] * x[1] - x[0] * x[0]) * textbook::artanh(x[1] / x[0]) + x[0] * x[1] / 2.0
    }),
    profile!(Ellipsoid "ellipsoid" ["A", "c", "x"],
    Integral "(c/A)[½(x²−A²)artanh(x/A) + Ax/2]" => |x| {
        x[1] / x[0] * (0.5 * (x[2] * x[2] - x[0] * x[0]) * textbook::artanh(x[2] / x[0]) + x[0] * x[2] / 2.0)
    }),
    profile!(Hyperboloid "hyperboloid" ["slope", "A", "x"],
    Integral "½cotα[(x²+A²)arctan(x/A) − Ax]" => |x| {
        0.5 * x[0] * ((x[2] * x[2] + x[1] * x[1]) * (x[2] / x[1]).atan() - x[1] * x[2])
    }),
    profile!(Sum "sum" ["R", "slope", "x"]),
    profile!(TruncatedCone "truncated-cone" ["slope", "b", "x"],
    G "x t arccos(b/x)" => |x| x[2] * x[0] * (x[1] / x[2]).acos(),
    Slope "t[arccos(b/x) + b/√(x²−b²)]" => |x| x[0] * ((x[1] / x[2]).acos() + x[1] / textbook::leg(x[2], x[1])),
    Integral "½t[x² arccos(b/x) − b√(x²−b²)]" => |x| {
        0.5 * x[0] * (x[2] * x[2] * (x[1] / x[2]).acos() - x[1] * textbook::leg(x[2], x[1]))
    }),
    profile!(TruncatedParaboloid "truncated-paraboloid" ["R", "b", "x"],
        G "(x/R)√(x²−b²)" => |x| x[2] / x[0] * textbook::leg(x[2], x[1]),
        Slope "(2x²−b²)/(R√(x²−b²))" => |x| (2.0 * x[2] * x[2] - x[1] * x[1]) / (x[0] * textbook::leg(x[2], x[1])),
        Integral "(x²−b²)^(3/2)/3R" => |x| textbook::leg(x[2], x[1]).powi(3) / (3.0 * x[0])),
    profile!(RoundedPunch "rounded-punch" ["R", "b", "x"],
    G "(x/R)[√(x²−b²) − b arccos(b/x)]" => |x| {
        x[2] / x[0] * (textbook::leg(x[2], x[1]) - x[1] * (x[1] / x[2]).acos())
    },
    Slope "[2√(x²−b²) − b arccos(b/x)]/R" => |x| {
        (2.0 * textbook::leg(x[2], x[1]) - x[1] * (x[1] / x[2]).acos()) / x[0]
    },
    Integral "[q³/3 − ½b(x² arccos(b/x) − bq)]/R" => |x| {
        let q = textbook::leg(x[2], x[1]);
        (q.powi(3) / 3.0 - 0.5 * x[1] * (x[2] * x[2] * (x[1] / x[2]).acos() - x[1] * q)) / x[0]
    }),
    profile!(ParabolicCapCone "cone-parabolic-cap" ["slope", "b", "x"],
    G "tx[(x − √(x²−b²))/b + arccos(b/x)]" => |x| {
        let (t, b, x) = (x[0], x[1], x[2]);
        if x > b { t * x * ((x - textbook::leg(x, b)) / b + (b / x).acos()) } else { t * x * x / b }
    }),
    profile!(ParabolicDimple "parabolic-dimple" ["h", "b", "x"],
    G "−(2hx/b²)(x − √(x²−b²))" => |x| {
        let (h, b, x) = (x[0], x[1], x[2]);
        -2.0 * h * x / (b * b) * if x > b { x - textbook::leg(x, b) } else { x }
    },
    Integral "−(2h/3b²)(x³ − (x²−b²)^(3/2))" => |x| {
        let (h, b, x) = (x[0], x[1], x[2]);
        -2.0 * h / (3.0 * b * b) * (x.powi(3) - if x > b { textbook::leg(x, b).powi(3) } else { 0.0 })
    }),
    profile!(EllipticalDimple "elliptical-dimple" ["h", "b", "x"],
    G "−(hx/b) artanh(b/x), as half a logarithm" => |x| {
        let (h, b, x) = (x[0], x[1], x[2]);
        -h * x / b * textbook::artanh(if x > b { b / x } else { x / b })
    },
    Integral "−(h/b)½[(x²−b²)artanh(b/x) + bx]" => |x| {
        let (h, b, x) = (x[0], x[1], x[2]);
        let t = if x > b { b / x } else { x / b };
        -h / b * 0.5 * ((x * x - b * b) * textbook::artanh(t) + b * x)
    }),
    profile!(SphericalCapCone "cone-spherical-cap" ["slope", "R", "x"],
    G "x ln[(R+x)/(√(R²−b²) + √(x²−b²))] + xt arccos(b/x)" => |x| {
        let (t, r, x) = (x[0], x[1], x[2]);
        let b = r * t / (1.0 + t * t).sqrt();
        if x <= b { return x * textbook::artanh(x / r) }
        x * ((r + x) / (textbook::leg(r, b) + textbook::leg(x, b))).ln() + x * t * (b / x).acos()
    }),
    ProfileRoutines {
        name: "flat-punch",
        constructor: "FlatPunch::new",
        routines: parts!(FlatPunch, &["b", "x"], |x| flat_punch(x)),
    },
    profile!(DisplacedParaboloid "displaced-paraboloid" ["R", "b", "x"]),
    profile!(WavyParaboloid "wavy-paraboloid" ["R", "A", "λ", "x"],
    G "x²/R + (π/2)Akx H₀(kx), its power series" => |x| {
        let z = 2.0 * PI / x[2] * x[3];
        x[3] * x[3] / x[0] + PI / 2.0 * x[1] * z * textbook::struve_h0(z)
    }),
];

/// Quadratures of heights, beside closed forms.
pub(crate) const QUADRATURES: [[Routine; 3]; 4] = [
    quadrature!(Power "power" ["n", "C", "x"]),
    quadrature!(Sphere "sphere" ["R", "x"]),
    quadrature!(RoundedPunch "rounded-punch" ["R", "b", "x"]),
    quadrature!(WavyParaboloid "wavy-paraboloid" ["R", "A", "λ", "x"]),
];

routines! {
    STRUVE ["z"] {
        "struve_h0": |x| Ok(Ranged::Value(x[0].struve_h0())), exact Ok(x[0].struve_h0()),
            textbook "power series" => textbook::struve_h0(x[0]);
        "struve_h1": |x| Ok(Ranged::Value(x[0].struve_h1())), exact Ok(x[0].struve_h1());
    }
}
