//! The requested outputs of a scene, and the arithmetic.

use mdr_core::number::Literal;

use crate::answer::{OutputKind, Promise};

/// The most digits that may be requested.
pub const MAX_DIGITS: u32 = 100_000;

/// The default number of digits of a certified answer.
pub const DEFAULT_DIGITS: u32 = 20;

/// The arithmetic of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Arithmetic {
    /// Every digit is proved where that can be; elsewhere two precisions agree on it, which the answer says.
    Certified {
        /// Significant decimal digits.
        digits: u32,
    },
    /// Hardware numbers.
    Double,
}

impl Arithmetic {
    /// The requested promise.
    pub fn promise(self) -> Promise {
        match self {
            Arithmetic::Certified { .. } => Promise::Certified,
            Arithmetic::Double => Promise::Double,
        }
    }

    /// The requested significant decimal digits; `None` in f64.
    pub fn digits(self) -> Option<u32> {
        match self {
            Arithmetic::Certified { digits } => Some(digits),
            Arithmetic::Double => None,
        }
    }
}

impl Default for Arithmetic {
    fn default() -> Self {
        Arithmetic::Certified { digits: DEFAULT_DIGITS }
    }
}

/// One output of a scene. `states` are values of the controlled quantity, at which all equilibria are described; without any it
/// is the state in which the path starts. An empty `at` lets the program choose the radii.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Want {
    /// g, g' and ∫g.
    Transform {
        /// Radii x > 0; at least one.
        at: Vec<Literal>,
    },
    /// All folds, with their proof of completeness.
    Folds {
        /// The contact radii between which all are proved; none lets the program choose.
        range: Option<[Literal; 2]>,
    },
    /// All equilibria.
    Equilibria {
        /// At these values of the controlled quantity; at least one.
        at: Vec<Literal>,
    },
    /// The events of the loading path.
    Path,
    /// Indentation and force by contact radius.
    Curve {
        /// Contact radii.
        at: Vec<Literal>,
    },
    /// The normal pressure within the contact.
    Pressure {
        /// Values of the controlled quantity.
        states: Vec<Literal>,
        /// Radii r.
        at: Vec<Literal>,
    },
    /// The gap outside the contact.
    Gap {
        /// Values of the controlled quantity.
        states: Vec<Literal>,
        /// Radii r.
        at: Vec<Literal>,
    },
    /// The normal surface displacement outside the contact.
    Displacement {
        /// Values of the controlled quantity.
        states: Vec<Literal>,
        /// Radii r.
        at: Vec<Literal>,
    },
    /// Potential energy and stiffness dF/dd.
    Energy {
        /// Values of the controlled quantity.
        states: Vec<Literal>,
    },
    /// The loading path as a measurement shows it, in f64.
    ForceCurve {
        /// How many samples there are about, spread evenly over the controlled quantity.
        points: u32,
    },
}

/// The most rows of one output, states times radii: each takes up to 4 kB of memory.
pub const MOST_ROWS: u32 = 100_000;

/// The most way points of a path.
pub const MOST_WAY_POINTS: usize = 10_000;

/// About so many radii of a field the program chooses itself.
const CHOSEN_RADII: usize = 41;

/// The samples of a force curve when their number is not given.
pub const POINTS: u32 = 400;

impl Want {
    /// The kind of the output.
    pub fn kind(&self) -> OutputKind {
        match self {
            Want::Transform { .. } => OutputKind::Transform,
            Want::Folds { .. } => OutputKind::Folds,
            Want::Equilibria { .. } => OutputKind::Equilibria,
            Want::Path => OutputKind::Path,
            Want::Curve { .. } => OutputKind::Curve,
            Want::Pressure { .. } => OutputKind::Pressure,
            Want::Gap { .. } => OutputKind::Gap,
            Want::Displacement { .. } => OutputKind::Displacement,
            Want::Energy { .. } => OutputKind::Energy,
            Want::ForceCurve { .. } => OutputKind::ForceCurve,
        }
    }

    /// The key of the output.
    pub fn name(&self) -> &'static str {
        self.kind().name()
    }

    /// The values of the controlled quantity at which the output is requested.
    pub fn values(&self) -> &[Literal] {
        match self {
            Want::Equilibria { at: values }
            | Want::Pressure { states: values, .. }
            | Want::Gap { states: values, .. }
            | Want::Displacement { states: values, .. }
            | Want::Energy { states: values } => values,
            _ => &[],
        }
    }

    /// The least number of rows of the output, by the given values.
    pub(crate) fn rows(&self) -> usize {
        let radii = match self {
            Want::Transform { at } | Want::Curve { at } => return at.len(),
            Want::ForceCurve { points } => return *points as usize,
            Want::Pressure { at, .. } | Want::Gap { at, .. } | Want::Displacement { at, .. } => at.len(),
            _ => 1,
        };
        self.values().len().max(1).saturating_mul(if radii == 0 { CHOSEN_RADII } else { radii })
    }

    /// The missing input of a scene with or without a material and a path.
    pub(super) fn missing(&self, has_material: bool, path: &[Literal]) -> Option<&'static str> {
        match self {
            want if !want.kind().is_of_profile() && !has_material => {
                Some("a material: [material] e_star, work_of_adhesion")
            }
            Want::Transform { at } if at.is_empty() => Some("radii: [output.transform] at = [\"…\"]"),
            Want::Equilibria { at } if at.is_empty() => Some("values: [output.equilibria] at = [\"…\"]"),
            Want::Path | Want::ForceCurve { .. } if path.len() < 2 => {
                Some("at least two way points: [control] path = [\"…\", \"…\"]")
            }
            want if want.kind().is_of_states() && want.values().is_empty() && path.is_empty() => {
                Some("states: [output.equilibria] at = [\"…\"], or the start of a path")
            }
            _ => None,
        }
    }
}
