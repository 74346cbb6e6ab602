//! The observed quantities, the legs of a curve, and the loss of residuals.

use mdr_core::named;

/// The given quantity X and the measured quantity Y of a row. `contact_point` and `baseline` are offsets of the recorded
/// quantities.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Observation {
    /// `F(d)`: X = d + contact_point, Y = F + baseline.
    ForceOfIndentation,
    /// `F(D)`: X = d + F/k + contact_point, Y = F + baseline.
    ForceOfPosition,
    /// `delta(D)`: X = d + F/k + contact_point, Y = F/k + baseline, the deflection of a cantilever of stiffness k.
    DeflectionOfPosition,
    /// `d(F)`: X = F + baseline, Y = d + contact_point.
    IndentationOfForce,
    /// `F(a)`: X = a, Y = F + baseline.
    ForceOfRadius,
    /// `a(F)`: X = F + baseline, Y = a.
    RadiusOfForce,
}

impl Observation {
    /// Each observation with its name.
    pub const NAMES: [(&'static str, Observation); 6] = [
        ("F(d)", Observation::ForceOfIndentation),
        ("F(D)", Observation::ForceOfPosition),
        ("delta(D)", Observation::DeflectionOfPosition),
        ("d(F)", Observation::IndentationOfForce),
        ("F(a)", Observation::ForceOfRadius),
        ("a(F)", Observation::RadiusOfForce),
    ];

    /// The name of the observation in a file, such as `delta(D)`.
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, known)| *known == self).map_or("", |(name, _)| name)
    }

    /// The units of X and Y.
    pub fn units(self) -> [&'static str; 2] {
        match self {
            Observation::ForceOfIndentation | Observation::ForceOfPosition | Observation::ForceOfRadius => ["m", "N"],
            Observation::DeflectionOfPosition => ["m", "m"],
            Observation::IndentationOfForce | Observation::RadiusOfForce => ["N", "m"],
        }
    }

    /// The units of X and Y on a medium, where forces may be per length.
    pub(super) fn units_on(self, medium: &mdr::scene::ExactMedium) -> [&'static str; 2] {
        self.units().map(|unit| if unit == "N" { medium.force_unit() } else { unit })
    }

    /// Depth and force of a row (X, Y); the offsets are those of the contact point and of the baseline.
    pub(super) fn state(self, [x, y]: [f64; 2], [contact_point, baseline]: [f64; 2], stiffness: f64) -> [f64; 2] {
        let [given, seen] = [x - contact_point, y - baseline];
        match self {
            Observation::DeflectionOfPosition => [given - seen, stiffness * seen],
            Observation::ForceOfPosition => [given - seen / stiffness, seen],
            Observation::IndentationOfForce => [y - contact_point, x - baseline],
            _ => [given, seen],
        }
    }

    /// Whether the machine position D is given.
    pub fn has_machine(self) -> bool {
        matches!(self, Observation::ForceOfPosition | Observation::DeflectionOfPosition)
    }

    /// Whether X is a depth or a position, and Y a force or a deflection.
    pub(super) fn has_depth(self) -> bool {
        self.has_machine() || self == Observation::ForceOfIndentation
    }

    /// Whether the contact radius is seen, so that depth has no offset and no row is detached.
    pub(super) fn sees_radius(self) -> bool {
        matches!(self, Observation::ForceOfRadius | Observation::RadiusOfForce)
    }
}

named! {
    /// Whether the surfaces approach or retract.
    pub enum Leg {
        /// X grows: detached, then outward from arc to arc.
        Approach = "approach",
        /// X falls: inward from arc to arc, then detached.
        Retract = "retract",
    }
}

/// How residuals count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Loss {
    /// By their squares.
    #[default]
    LeastSquares,
    /// By their squares up to 1.345 σ, linearly beyond (Huber): a few wild rows have little weight. Needs σ_Y.
    Huber,
}
