//! The numbers of a problem: their kinds, names, units and checks.

use mdr_core::contact::Edge;
use mdr_core::text::excerpt;
use mdr_core::units::SiUnit;

use mdr::reading::Location;
use mdr::{Error, Result};

/// The numbers of a problem that can be unknown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Kind {
    EffectiveModulus,
    WorkOfAdhesion,
    /// Of an edge that advances, or recedes.
    Work(Edge),
    Stiffness,
    /// The true deflection over the recorded one.
    Sensitivity,
    ContactPoint,
    Baseline,
    /// By how much the baseline rises with X.
    BaselineSlope,
    /// By how much the baseline and the position rise with time.
    BaselineDrift,
    PositionDrift,
    /// A number of the profile, by its place among them.
    Profile(usize),
}

impl Kind {
    /// Whether it is an offset, fitted as it is. All others are fitted by their logarithm.
    pub(super) fn is_offset(self) -> bool {
        matches!(self, Kind::ContactPoint | Kind::Baseline) || self.is_trend()
    }

    /// Whether it moves rows by their place or time.
    pub(super) fn is_trend(self) -> bool {
        matches!(self, Kind::BaselineSlope | Kind::BaselineDrift | Kind::PositionDrift)
    }

    /// Whether it is a work of adhesion, which may be zero.
    pub(super) fn is_work(self) -> bool {
        matches!(self, Kind::WorkOfAdhesion | Kind::Work(_))
    }
}

/// One number of a problem, unknown or given.
#[derive(Clone, Debug)]
pub(super) struct Parameter {
    pub(super) kind: Kind,
    pub(super) name: String,
    pub(super) unit: SiUnit,
    pub(super) value: Option<f64>,
    pub(super) start: Option<f64>,
    pub(super) free: bool,
    /// Mean and standard deviation.
    pub(super) prior: Option<[f64; 2]>,
    pub(super) bounds: Option<[f64; 2]>,
    /// The unit of a drift.
    pub(super) drift_unit: &'static str,
}

impl Parameter {
    /// The unit as answers write it.
    pub(super) fn unit_name(&self) -> &'static str {
        match self.unit {
            _ if self.kind.is_trend() && self.unit == SiUnit::Unstated => self.drift_unit,
            SiUnit::One => "1",
            SiUnit::Degree => "degree",
            SiUnit::JoulePerSquareMetre => "J/m^2",
            SiUnit::Unstated => "SI",
            unit => unit.symbol(),
        }
    }

    /// The stated value of an unknown number: its start, or the mean of its prior.
    pub(super) fn guess(&self) -> Option<f64> {
        self.start.or(self.prior.map(|[mean, _]| mean))
    }

    /// The value of the number, or the starting value of an unknown one.
    pub(super) fn known(&self) -> Option<f64> {
        self.guess().filter(|_| self.free).or(self.value)
    }

    /// Whether a number that is fitted by its logarithm is negative.
    pub(super) fn is_negative(&self) -> bool {
        self.start.or(self.value).is_some_and(|value| value < 0.0)
    }

    /// The number, if it can be one of this parameter.
    pub(super) fn checked(&self, value: f64, key: &str) -> Result<f64> {
        if self.kind.is_offset() || self.name == "amplitude" || self.name.ends_with(".amplitude") {
            if value.is_finite() {
                return Ok(value);
            }
            return Err(refuse(key, format!("`{}` must be finite, got {value}", excerpt(&self.name))));
        }
        if value == 0.0 && self.kind.is_work() && key != "fit.prior" {
            return Ok(value);
        }
        positive(key, &self.name, value)
    }
}

/// The prefix of the names of two works of adhesion.
pub(super) const WORK: &str = "work_of_adhesion.";

/// A name as parameters have it: numbers of the profile may be prefixed, and the two works of adhesion named by their edge.
pub(super) fn bare(name: &str) -> std::borrow::Cow<'_, str> {
    let name = name.strip_prefix("profile.").unwrap_or(name);
    match Edge::ALL
        .into_iter()
        .find(|edge| edge.name() == name || name.strip_suffix("_work_of_adhesion") == Some(edge.name()))
    {
        Some(edge) => format!("{WORK}{}", edge.name()).into(),
        None => name.into(),
    }
}

pub(super) fn refuse(key: &str, why: impl Into<String>) -> Error {
    Location::built(key).refuse(why)
}

pub(super) fn positive(key: &str, name: &str, value: f64) -> Result<f64> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(refuse(key, format!("`{}` must be positive and finite, got {value}", excerpt(name))))
    }
}

pub(super) fn not_negative(key: &str, value: f64) -> Result<f64> {
    if value >= 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(refuse(key, format!("must be a finite number, zero or above, got {value}")))
    }
}

/// Terms of a sum may have the same keys: `radius`, `radius.2`, `radius.3`.
pub(super) fn number_repeated_names(parameters: &mut [Parameter]) {
    let names: Vec<String> = parameters.iter().map(|parameter| parameter.name.clone()).collect();
    for (index, parameter) in parameters.iter_mut().enumerate() {
        let before = names[..index].iter().filter(|name| **name == names[index]).count();
        if before > 0 {
            parameter.name = format!("{}.{}", names[index], before + 1);
        }
    }
}
