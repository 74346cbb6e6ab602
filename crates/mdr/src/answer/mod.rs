//! The answer to a scene: typed outputs, each number with its promise or the reason why there is none.

mod column;
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
use mdr_numeric::admissible::Basis;

pub use column::Column;
pub use record::{Cell, Row};
pub use rows::{FlatCell, FlatRow, columns, find};
pub use style::{Notation, NumberStyle, UnitError, Units};
pub use types::{Admission, AtValue, Completeness, List, Optional, Overlap, PlainState};
pub use value::{Number, Promise, Value};

pub use crate::outputs::records::*;
pub use crate::outputs::{Output, OutputKind};
use crate::run::Cost;
use crate::scene::{Arithmetic, Want};
use crate::validity::Validity;

/// The answer to a scene.
///
/// ```
/// use mdr::prelude::*;
/// let scene = Scene::new(Shape::Paraboloid { radius: "0.01" }, Elasticity::effective("1e6")?, "0.05")?
///     .control(Control::Force)
///     .want(Want::Folds { range: None })
///     .arithmetic(Arithmetic::F64);
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
    /// The name of the medium; `None` on a homogeneous half-space.
    pub medium: Option<&'static str>,
    /// The unit of forces: N, per length N/m, or per area Pa.
    pub force_unit: &'static str,
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
        Basis::Proved => {
            "decided from enclosures of the gap everywhere outside of the contact: of each state that is called admissible, or not, \
             this is proved"
        }
        Basis::Rising => {
            "every state is: enclosures prove that g falls nowhere, so that no gap closes outside of a contact"
        }
        Basis::Searched => {
            "decided in f64 from the extrema of g, which were searched and resolved, and from the gap wherever g is below the \
             indentation"
        }
        Basis::Doubtful => {
            "decided in f64; the extrema of g were not resolved everywhere: an overlap that is found is one, and where none is \
             found it is not known"
        }
        Basis::Unknown(why) => return Cow::Owned(format!("not known: {why}")),
        Basis::Unproved { width, heights } => {
            return Cow::Owned(format!(
                "not decided where no overlap is found: g of a {heights} was searched in f64, at radii up to {width:.2} of \
                 themselves apart, and a narrower dip of the {heights} may be missed; an overlap that is found is one",
                heights = heights.name()
            ));
        }
    })
}
