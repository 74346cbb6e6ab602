//! The answer to a scene: typed outputs, each number with its promise or the reason why there is none.

#[cfg(feature = "serde")]
pub(crate) mod json;
pub(crate) mod record;
mod rows;
mod spreadsheet;
mod style;
pub(crate) mod types;
mod value;
mod words;

use std::borrow::Cow;

use mdr_core::contact::ControlKind;
use mdr_core::named;
use mdr_numeric::admissible::Basis;

pub use record::{Cell, Row};
pub use rows::{FlatCell, FlatRow, columns, find, title};
pub use style::{Notation, NumberStyle, UnitError, Units};
pub use types::{
    Admission, AtValue, Balance, Completeness, CurvePoint, CurveStability, CurveSummary, Dissipation, EnergyState,
    Equilibrium, Field, FieldSample, FieldState, Fold, ForceCurve, ForceSample, List, LoadingPath, Optional, Overlap,
    PathEvent, PlainState, TransformSample,
};
pub use value::{Number, Promise, Value};

use crate::run::Cost;
use crate::scene::{Arithmetic, Want};
use crate::validity::Validity;
use record::Numbers;

named! {
    /// The kinds of output, by their names in scenes and answers.
    pub enum OutputKind {
        /// g, g' and ∫g at radii.
        Transform = "transform",
        /// All equilibria at values of the controlled quantity.
        Equilibria = "equilibria",
        /// All folds.
        Folds = "folds",
        /// A loading path.
        Path = "path",
        /// Equilibria by their contact radius.
        Curve = "curve",
        /// The normal pressure of states.
        Pressure = "pressure",
        /// The gap of states.
        Gap = "gap",
        /// The surface displacement of states.
        Displacement = "displacement",
        /// Energy and stiffness of states.
        Energy = "energy",
        /// The loading path, sampled.
        ForceCurve = "force-curve",
    }
}

impl OutputKind {
    /// Whether it is computed from the profile alone.
    pub fn is_of_profile(self) -> bool {
        self == OutputKind::Transform
    }

    /// Whether it describes single states.
    pub fn is_of_states(self) -> bool {
        matches!(self, OutputKind::Pressure | OutputKind::Gap | OutputKind::Displacement | OutputKind::Energy)
    }
}

/// One requested output.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Output {
    /// The transformed profile at radii.
    Transform(List<TransformSample>),
    /// All equilibria at values.
    Equilibria(List<AtValue<Equilibrium>>),
    /// All folds, by increasing contact radius.
    Folds(List<Fold>),
    /// The loading path.
    Path(Box<LoadingPath>),
    /// Equilibria by their contact radius.
    Curve(List<CurvePoint>),
    /// Pressure, gap or displacement of states.
    Field(Field, List<AtValue<FieldState>>),
    /// Energy and stiffness of states.
    Energy(List<AtValue<EnergyState>>),
    /// The loading path, sampled.
    ForceCurve(Box<ForceCurve>),
}

/// Evaluates one expression for the list of any output.
macro_rules! with_list {
    ($output:expr, $list:ident => $value:expr) => {
        match $output {
            Output::Transform($list) => $value,
            Output::Equilibria($list) => $value,
            Output::Folds($list) => $value,
            Output::Path(path) => {
                let $list = &path.events;
                $value
            }
            Output::Curve($list) => $value,
            Output::Field(_, $list) => $value,
            Output::Energy($list) => $value,
            Output::ForceCurve(curve) => {
                let $list = &curve.samples;
                $value
            }
        }
    };
}

impl Output {
    /// The kind of this output.
    pub fn kind(&self) -> OutputKind {
        match self {
            Output::Transform(_) => OutputKind::Transform,
            Output::Equilibria(_) => OutputKind::Equilibria,
            Output::Folds(_) => OutputKind::Folds,
            Output::Path(_) => OutputKind::Path,
            Output::Curve(_) => OutputKind::Curve,
            Output::Field(Field::Pressure, _) => OutputKind::Pressure,
            Output::Field(Field::Gap, _) => OutputKind::Gap,
            Output::Field(Field::Displacement, _) => OutputKind::Displacement,
            Output::Energy(_) => OutputKind::Energy,
            Output::ForceCurve(_) => OutputKind::ForceCurve,
        }
    }

    /// How far the numbers of the output can be trusted.
    pub fn promise(&self) -> Promise {
        with_list!(self, list => list.promise)
    }

    /// Whether its list is complete, where that is a question.
    pub fn complete(&self) -> Option<&Completeness> {
        with_list!(self, list => list.complete.as_ref())
    }

    /// A row for each record of its list.
    pub fn rows(&self) -> Vec<Row<'_>> {
        with_list!(self, list => list.items.rows())
    }

    /// The energy balance of a path, where it is finite.
    pub fn balance(&self) -> Option<&Balance> {
        match self {
            Output::Path(path) => path.balance.as_ref(),
            _ => None,
        }
    }

    /// The single records beside its list, by their keys in an answer.
    pub fn beside(&self) -> Vec<(&'static str, Vec<Row<'_>>)> {
        match self {
            Output::Path(path) => path.balance.iter().map(|balance| ("balance", balance.rows())).collect(),
            Output::ForceCurve(curve) => vec![("force-curve-summary", curve.summary.rows())],
            _ => Vec::new(),
        }
    }

    /// The parts with a promise of their own, by their keys.
    pub fn exceptions(&self) -> Vec<(&'static str, Promise)> {
        match self {
            Output::Path(path) => {
                let dissipated = path.energy.map(|promise| ("path.dissipated", promise));
                let balance = path.balance.as_ref().and(path.energy).map(|promise| ("balance", promise));
                dissipated.into_iter().chain(balance).collect()
            }
            _ => Vec::new(),
        }
    }

    /// Every number changed by `f`, with another promise.
    #[cfg(feature = "mp")]
    pub(crate) fn resolve(self, promise: Promise, f: fn(Number) -> Value) -> Self {
        fn list<T>(List { items, complete, .. }: List<T>, promise: Promise, f: fn(Number) -> Value) -> List<T>
        where
            T: Numbers<Number, With<Number> = T>,
        {
            List { items: items.resolve(f), promise, complete }
        }
        match self {
            Output::Transform(items) => Output::Transform(list(items, promise, f)),
            Output::Equilibria(items) => Output::Equilibria(list(items, promise, f)),
            Output::Folds(items) => Output::Folds(list(items, promise, f)),
            Output::Path(path) => {
                let (events, balance) = (list(path.events, promise, f), path.balance.resolve(f));
                Output::Path(Box::new(LoadingPath { events, balance, energy: None }))
            }
            Output::Curve(items) => Output::Curve(list(items, promise, f)),
            Output::Field(field, items) => Output::Field(field, list(items, promise, f)),
            Output::Energy(items) => Output::Energy(list(items, promise, f)),
            curve @ Output::ForceCurve(_) => curve,
        }
    }
}

/// The answer to a scene.
///
/// ```
/// use mdr::prelude::*;
/// let scene = Scene::new(Shape::Paraboloid { radius: "0.01" }, Elasticity::effective("1e6")?, "0.05")?
///     .control(Control::Force)
///     .want(Want::Folds { range: None })
///     .arithmetic(Arithmetic::Double);
/// let answer = scene.solve()?;
/// let pull_off = answer.folds().expect("wanted").items[0].force.to_f64().expect("a number");
/// assert!((pull_off / (-1.5 * std::f64::consts::PI * 0.05 * 0.01) - 1.0).abs() < 1e-14, "JKR: −3/2 π w R");
/// # Ok::<(), mdr::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The requested arithmetic.
    pub arithmetic: Arithmetic,
    /// The name of the profile.
    pub profile: &'static str,
    /// The kind of controlled quantity; `None` if nothing is controlled.
    pub control: Option<ControlKind>,
    /// Notes on how the scene was read, where that may surprise.
    pub notes: Vec<String>,
    /// The outputs, in the order of the scene.
    pub outputs: Vec<Output>,
    /// How the admissible states were determined; `None` if there are no states.
    pub admissibility: Option<Basis>,
    /// Whether the theory holds, where the scene has a range of adhesion.
    pub validity: Option<Box<Validity>>,
    /// The cost of each output.
    pub costs: Vec<Cost>,
}

/// An accessor for each output, by its kind; `None` if the output was not requested.
macro_rules! accessors {
    ($($(#[$doc:meta])* $name:ident: $type:ty = $pattern:pat => $value:expr;)*) => {
        impl Answer {
            $($(#[$doc])*
            pub fn $name(&self) -> Option<&$type> {
                self.outputs.iter().find_map(|output| match output {
                    $pattern => Some($value),
                    _ => None,
                })
            })*
        }
    };
}

accessors! {
    /// The transformed profile; `None` if it was not requested.
    transform: List<TransformSample> = Output::Transform(list) => list;
    /// The equilibria at the values of the scene; `None` if they were not requested.
    equilibria: List<AtValue<Equilibrium>> = Output::Equilibria(list) => list;
    /// The folds; `None` if they were not requested.
    folds: List<Fold> = Output::Folds(list) => list;
    /// The loading path; `None` if it was not requested.
    path: LoadingPath = Output::Path(path) => &**path;
    /// The curve of equilibria; `None` if it was not requested.
    curve: List<CurvePoint> = Output::Curve(list) => list;
    /// The pressure of states; `None` if it was not requested.
    pressure: List<AtValue<FieldState>> = Output::Field(Field::Pressure, list) => list;
    /// The gap of states; `None` if it was not requested.
    gap: List<AtValue<FieldState>> = Output::Field(Field::Gap, list) => list;
    /// The surface displacement of states; `None` if it was not requested.
    displacement: List<AtValue<FieldState>> = Output::Field(Field::Displacement, list) => list;
    /// The sampled loading path; `None` if it was not requested.
    force_curve: ForceCurve = Output::ForceCurve(curve) => &**curve;
    /// Energy and stiffness of states; `None` if they were not requested.
    energy: List<AtValue<EnergyState>> = Output::Energy(list) => list;
}

impl Answer {
    /// The output that answers a request.
    pub fn output(&self, want: &Want) -> Option<&Output> {
        self.outputs.iter().find(|output| output.kind() == want.kind())
    }

    /// The requested promise.
    pub fn promise(&self) -> Promise {
        self.arithmetic.promise()
    }
}

/// How admissibility was decided, in words.
pub fn described(basis: Basis) -> Cow<'static, str> {
    Cow::Borrowed(match basis {
        Basis::Bound => {
            "every state is, by the form of the profile: its g falls nowhere, so that no gap closes outside of a contact"
        }
        Basis::Isolated => {
            "decided from the extrema of g, which were isolated by enclosures and are proved to be all, and from the gap, in f64, \
             wherever g is below the indentation"
        }
        Basis::Searched => {
            "decided in f64 from the extrema of g, which were searched and resolved, and from the gap wherever g is below the \
             indentation"
        }
        Basis::Doubtful => {
            "decided in f64; the extrema of g were not resolved everywhere: an overlap that is found is one, and where none is \
             found it is not known"
        }
        Basis::Unproved { width } => {
            return Cow::Owned(format!(
                "not decided where no overlap is found: g of a formula was searched in f64, at radii up to {width:.2} of \
                 themselves apart, and a narrower dip of the formula may be missed; an overlap that is found is one"
            ));
        }
    })
}
