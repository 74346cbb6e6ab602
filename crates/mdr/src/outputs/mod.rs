//! The outputs of a scene, one room each.
//!
//! A room is a module that says all of one output: the keys of its question, its record with the headings and units of the
//! columns, how it is computed in f64 and over enclosures, its closed form for power laws where there is one,
//! and what is left of it where it cannot be computed. An output is added by three files: its room; this one, with its `mod`, its
//! records and its entry in the list below; and docs/scenes.md, with its row.

#![cfg_attr(
    not(any(feature = "toml", feature = "serde")),
    allow(dead_code, unused_imports, reason = "what reads is not called")
)]

mod curve;
mod displacement;
mod energy;
mod equilibria;
mod fields;
pub(crate) mod folds;
mod force_curve;
mod gap;
pub(crate) mod key;
pub(crate) mod path;
mod pressure;
pub(crate) mod room;
mod transform;

use std::borrow::Borrow;
#[cfg(feature = "mp")]
use std::borrow::BorrowMut;

use mdr_core::named;
use mdr_core::number::Literal;

use self::key::Keys;
use self::room::{Content, Facts, Request, Room, Subject};
use crate::answer::record::Row;
use crate::answer::{Answer, AtValue, Column, Completeness, List, NumberStyle, Promise};
#[cfg(feature = "mp")]
use crate::answer::{Number, Value};
use crate::scene::Scene;

pub use force_curve::POINTS;

use records::*;

/// The records of all outputs, as [`answer`](crate::answer) has them.
pub(crate) mod records {
    pub use super::curve::{CurvePoint, CurveStability};
    pub use super::energy::EnergyState;
    pub use super::equilibria::Equilibrium;
    pub use super::fields::{Field, FieldSample, FieldState};
    pub use super::folds::Fold;
    pub use super::force_curve::{CurveSummary, ForceCurve, ForceSample};
    pub use super::path::{Balance, Dissipation, LoadingPath, PathEvent};
    pub use super::transform::TransformSample;
}

/// The type of the content in [`Output`]: boxed where it is large.
macro_rules! stored {
    (boxed $content:ty) => { Box<$content> };
    ($content:ty) => { $content };
}

/// Declares the outputs: the room, the name of its variants and in scenes and answers, the question, and the content.
macro_rules! outputs {
    ($(
        $(#[$doc:meta])*
        $room:ident: $kind:ident = $key:literal
        $({ $($(#[$field_doc:meta])* $field:ident: $type:ty,)* })?
        -> $($boxed:ident)? [$content:ty],
    )*) => {
        named! {
            /// The kinds of output, by their names in scenes and answers.
            pub enum OutputKind {
                $($(#[$doc])* $kind = $key,)*
            }
        }

        impl OutputKind {
            pub(crate) fn facts(self) -> &'static Facts {
                match self {
                    $(OutputKind::$kind => &$room::FACTS,)*
                }
            }
        }

        /// One output of a scene. `states` are values of the controlled quantity, at which all equilibria are described; without
        /// any it is the state in which the path starts. An empty `at` lets the program choose the radii.
        #[derive(Clone, Debug, PartialEq)]
        #[non_exhaustive]
        pub enum Want {
            $($(#[$doc])* $kind $({ $($(#[$field_doc])* $field: $type,)* })?,)*
        }

        impl Want {
            /// The kind of the output.
            pub fn kind(&self) -> OutputKind {
                match self {
                    $(Want::$kind { .. } => OutputKind::$kind,)*
                }
            }

            pub(crate) fn room(&self) -> Box<dyn Room<'_> + '_> {
                match self {
                    $(Want::$kind $({ $($field),* })? => Box::new($room::Room { $($($field),*)? }),)*
                }
            }

            pub(crate) fn request(&self) -> Box<dyn Request<'_> + '_> {
                match self {
                    $(Want::$kind $({ $($field),* })? => Box::new($room::Room { $($($field),*)? }),)*
                }
            }
        }

        /// One requested output.
        #[derive(Clone, Debug, PartialEq)]
        #[non_exhaustive]
        pub enum Output {
            $($(#[$doc])* $kind(stored!($($boxed)? $content)),)*
        }

        impl Output {
            /// The kind of this output.
            pub fn kind(&self) -> OutputKind {
                match self {
                    $(Output::$kind(_) => OutputKind::$kind,)*
                }
            }

            fn content(&self) -> &dyn Content {
                match self {
                    $(Output::$kind(content) => Borrow::<$content>::borrow(content),)*
                }
            }

            #[cfg(feature = "mp")]
            fn content_mut(&mut self) -> &mut dyn Content {
                match self {
                    $(Output::$kind(content) => BorrowMut::<$content>::borrow_mut(content),)*
                }
            }
        }

        impl Answer {$(
            $(#[$doc])*
            ///
            /// `None` if it was not requested.
            pub fn $room(&self) -> Option<&$content> {
                self.outputs.iter().find_map(|output| match output {
                    Output::$kind(content) => Some(Borrow::<$content>::borrow(content)),
                    _ => None,
                })
            }
        )*}
    };
}

outputs! {
    /// g, g' and ∫g at radii.
    transform: Transform = "transform" {
        /// Radii x > 0; at least one.
        at: Vec<Literal>,
    } -> [List<TransformSample>],
    /// All equilibria at values of the controlled quantity.
    equilibria: Equilibria = "equilibria" {
        /// At these values of the controlled quantity; at least one.
        at: Vec<Literal>,
    } -> [List<AtValue<Equilibrium>>],
    /// All folds, by increasing contact radius, with their proof of completeness.
    folds: Folds = "folds" {
        /// The contact radii between which all are proved; none lets the program choose.
        range: Option<[Literal; 2]>,
    } -> [List<Fold>],
    /// The events of the loading path.
    path: Path = "path" -> boxed [LoadingPath],
    /// Indentation and force of the equilibria with given contact radii.
    curve: Curve = "curve" {
        /// Contact radii.
        at: Vec<Literal>,
    } -> [List<CurvePoint>],
    /// The normal pressure of states within the contact.
    pressure: Pressure = "pressure" {
        /// Values of the controlled quantity.
        states: Vec<Literal>,
        /// Radii r.
        at: Vec<Literal>,
    } -> [List<AtValue<FieldState>>],
    /// The gap of states outside the contact.
    gap: Gap = "gap" {
        /// Values of the controlled quantity.
        states: Vec<Literal>,
        /// Radii r.
        at: Vec<Literal>,
    } -> [List<AtValue<FieldState>>],
    /// The normal surface displacement of states outside the contact.
    displacement: Displacement = "displacement" {
        /// Values of the controlled quantity.
        states: Vec<Literal>,
        /// Radii r.
        at: Vec<Literal>,
    } -> [List<AtValue<FieldState>>],
    /// Potential energy and stiffness dF/dd of states.
    energy: Energy = "energy" {
        /// Values of the controlled quantity.
        states: Vec<Literal>,
    } -> [List<AtValue<EnergyState>>],
    /// The loading path as a measurement shows it, with what is read off a measured curve.
    force_curve: ForceCurve = "force-curve" {
        /// How many samples there are about, spread evenly over the controlled quantity.
        points: u32,
    } -> boxed [ForceCurve],
}

impl OutputKind {
    /// Whether it is computed from the profile alone.
    pub fn is_of_profile(self) -> bool {
        self.facts().of == Subject::Profile
    }

    /// Whether it describes single states.
    pub fn is_of_states(self) -> bool {
        self.facts().of == Subject::States
    }

    /// Whether it follows the path.
    pub(crate) fn moves(self) -> bool {
        self.facts().of == Subject::Path
    }

    /// The question, by the keys of a scene.
    pub(crate) fn question(self, keys: &Keys) -> Want {
        (self.facts().question)(keys, self)
    }

    /// Why the key of the output is of no use for a scene.
    pub(crate) fn unused(self, scene: &Scene, drawn: bool) -> Option<&'static str> {
        (self.facts().unused)(scene, self, drawn)
    }
}

impl Want {
    /// The key of the output.
    pub fn name(&self) -> &'static str {
        self.kind().name()
    }

    /// The values of the controlled quantity at which the output is requested.
    pub fn values(&self) -> &[Literal] {
        self.request().values()
    }

    /// The least number of rows of the output, by the given values.
    pub(crate) fn rows(&self) -> usize {
        self.request().rows()
    }

    /// The missing input of a scene with or without a material and a path.
    pub(crate) fn missing(&self, has_material: bool, path: &[Literal]) -> Option<&'static str> {
        match self.kind().facts().of {
            Subject::Profile => self.request().missing(),
            _ if !has_material => Some("a material: [material] e_star, work_of_adhesion"),
            Subject::Path if path.len() < 2 => Some("at least two way points: [control] path = [\"…\", \"…\"]"),
            Subject::States if self.values().is_empty() && path.is_empty() => {
                Some("states: [output.equilibria] at = [\"…\"], or the start of a path")
            }
            _ => self.request().missing(),
        }
    }
}

impl Output {
    /// How far the numbers of the output can be trusted.
    pub fn promise(&self) -> Promise {
        self.content().list().promise()
    }

    /// Whether its list is complete; `None` if that is not meaningful.
    pub fn complete(&self) -> Option<&Completeness> {
        self.content().list().complete()
    }

    /// A row for each record of its list.
    pub fn rows(&self) -> Vec<Row<'_>> {
        self.content().list().rows()
    }

    /// The columns that its rows may have.
    pub(crate) fn columns(&self) -> Vec<Column> {
        self.content().list().columns()
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
        self.content().beside()
    }

    /// The parts with a promise of their own, by their keys.
    pub fn exceptions(&self) -> Vec<(&'static str, Promise)> {
        self.content().exceptions()
    }

    /// The results that are no row of the list, in a sentence each: the energy of a path, the summary of a force curve.
    pub fn sentences(&self, style: &NumberStyle) -> Vec<String> {
        self.content().sentences(style)
    }

    /// Every number changed by `f`, with another promise.
    #[cfg(feature = "mp")]
    pub(crate) fn resolve(mut self, promise: Promise, f: fn(Number) -> Value) -> Self {
        self.content_mut().resolve(promise, f);
        self
    }
}
