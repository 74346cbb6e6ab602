//! The vocabulary of contact mechanics: profiles, materials, controlled quantities, states and errors.

mod control;
mod counted;
mod error;
mod expression;
mod kink;
mod material;
mod profile;
mod shape;
mod state;
mod transform;

pub use control::{Control, ControlKind};
pub use counted::{Budget, CountingTransform, EvaluationCounter, Evaluations};
pub use error::{Error, Quantity, Result};
#[cfg(feature = "mp")]
pub use expression::{
    Breaks, CutFormula, EnclosedFormula, FormulaPart, FormulaShape, LocalPolynomial, Lowest, LowestRing, Onset, Onsets,
};
pub use expression::{Expression, ExpressionError, ExpressionProfile};
pub use kink::{Kink, Slopes};
pub use material::{Body, Elasticity, Material};
pub use profile::Profile;
pub use shape::{Flank, Shape};
pub use state::{Edge, Equilibrium, Fold, FoldKind, Outcome, Ranged, Regime, Stability, Status};
pub use transform::Transform;
