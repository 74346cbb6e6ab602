//! A problem of fitting: a profile, an observation, rows, and unknowns.

use std::sync::Arc as Shared;

use mdr_core::contact::Edge;
use mdr_core::text::excerpt;
use mdr_core::units::SiUnit;

use super::answer::Fit;
use super::observation::{Leg, Loss, Observation};
pub(super) use super::parameter::{Kind, Parameter, WORK, bare};
use super::parameter::{not_negative, number_repeated_names, positive, refuse};
use super::select::Selection;
use super::text::CurveText;
use mdr::Result;
use mdr::reading::Location;
use mdr::scene::{ExactMedium, IntoProfile, Profile};

/// One row of the data, in SI units.
#[derive(Clone, Copy, Debug)]
pub(super) struct DataRow {
    pub(super) x: f64,
    pub(super) y: f64,
    /// When it was recorded: in s from the first row where times are known, else in shares of the record.
    pub(super) time: f64,
    /// Its own σ_X and σ_Y.
    pub(super) sigma: [OwnSigma; 2],
    /// The leg of the record, by its number.
    pub(super) part: u32,
    pub(super) leg: Leg,
}

/// A standard deviation that a row has for itself, or none, in the room of a number: a long record has many rows.
#[derive(Clone, Copy, Debug)]
pub(super) struct OwnSigma(f64);

impl OwnSigma {
    pub(super) const NONE: OwnSigma = OwnSigma(f64::NAN);

    pub(super) fn get(self) -> Option<f64> {
        (!self.0.is_nan()).then_some(self.0)
    }
}

impl From<Option<f64>> for OwnSigma {
    fn from(sigma: Option<f64>) -> Self {
        sigma.map_or(OwnSigma::NONE, OwnSigma)
    }
}

/// A measured curve and the numbers to be found from it. All numbers are in SI units.
#[derive(Clone, Debug)]
pub struct Problem {
    pub(super) profile: Profile,
    pub(super) medium: ExactMedium,
    pub(super) observation: Observation,
    pub(super) parameters: Vec<Parameter>,
    /// One copy serves all problems that are made of this one on the way to an answer.
    pub(super) rows: Shared<Vec<DataRow>>,
    /// X and time where each leg of the record and the one before meet.
    pub(super) turns: Vec<[f64; 2]>,
    /// σ_X and σ_Y of all rows, where they are given.
    pub(super) sigma: [Option<f64>; 2],
    pub(super) loss: Loss,
    /// The place of the jump out of contact and its standard deviation, where it is a datum.
    pub(super) pull_off: Option<[f64; 2]>,
    pub(super) range_of_adhesion: Option<f64>,
    /// The requested certified digits.
    pub(super) digits: Option<u32>,
    /// Whether intervals by the profile of the sum of squares are requested.
    pub(super) profile_likelihood: bool,
    /// Which rows count.
    pub(super) selection: Selection,
    /// How the text of the curve was read, where it was in a file, and a remark on it.
    pub(super) read: Option<(CurveText, Option<String>)>,
    pub(super) place: Location,
}

impl Problem {
    /// The curve of a tip, `x` given and `y` measured, in the order in which they were recorded. Nothing is free yet.
    ///
    /// # Errors
    /// A profile with a number that is none; slices that differ in length, fewer than three rows, numbers that are not finite.
    pub fn new(profile: impl IntoProfile, observation: Observation, x: &[f64], y: &[f64]) -> Result<Problem> {
        let rows = super::data::rows(x, y, None)?;
        Problem::with(profile.into_profile()?, observation, rows, Location::built("data"))
    }

    pub(super) fn with(
        profile: Profile,
        observation: Observation,
        mut rows: Vec<DataRow>,
        place: Location,
    ) -> Result<Problem> {
        let turns = super::select::arrange(&mut rows, false);
        super::data::check(&rows).map_err(|why| place.refuse(why))?;
        let parameter = |kind, name: &str, unit, value| Parameter {
            kind,
            name: name.to_owned(),
            unit,
            value,
            start: None,
            free: false,
            prior: None,
            bounds: None,
            drift_unit: "1",
        };
        let mut parameters = vec![
            parameter(Kind::EffectiveModulus, "e_star", SiUnit::Pascal, None),
            parameter(Kind::WorkOfAdhesion, "work_of_adhesion", SiUnit::JoulePerSquareMetre, None),
        ];
        if observation != Observation::ForceOfRadius {
            for edge in [Edge::Advancing, Edge::Receding] {
                let name = format!("{WORK}{}", edge.name());
                parameters.push(parameter(Kind::Work(edge), &name, SiUnit::JoulePerSquareMetre, None));
            }
        }
        if observation.has_machine() {
            parameters.push(parameter(Kind::Stiffness, "stiffness", SiUnit::NewtonPerMetre, None));
            parameters.push(parameter(Kind::Sensitivity, "sensitivity", SiUnit::One, Some(1.0)));
        }
        if !observation.sees_radius() {
            parameters.push(parameter(Kind::ContactPoint, "contact_point", SiUnit::Metre, Some(0.0)));
        }
        let of_baseline = if observation == Observation::DeflectionOfPosition { SiUnit::Metre } else { SiUnit::Newton };
        parameters.push(parameter(Kind::Baseline, "baseline", of_baseline, Some(0.0)));
        if observation.has_depth() {
            let of_slope = if of_baseline == SiUnit::Metre { SiUnit::One } else { SiUnit::NewtonPerMetre };
            parameters.push(parameter(Kind::BaselineSlope, "baseline_slope", of_slope, Some(0.0)));
            parameters.push(parameter(Kind::BaselineDrift, "baseline_drift", SiUnit::Unstated, Some(0.0)));
            parameters.push(parameter(Kind::PositionDrift, "position_drift", SiUnit::Unstated, Some(0.0)));
        }
        for (index, ((number, location), unit)) in profile.numbers().into_iter().zip(profile.units()).enumerate() {
            let name = location.key().trim_start_matches("profile.").to_owned();
            parameters.push(parameter(Kind::Profile(index), &name, unit, Some(number.nearest_f64())));
        }
        number_repeated_names(&mut parameters);
        Ok(Problem {
            profile,
            medium: ExactMedium::HalfSpace,
            observation,
            parameters,
            rows: Shared::new(rows),
            turns,
            sigma: [None; 2],
            loss: Loss::default(),
            pull_off: None,
            range_of_adhesion: None,
            digits: None,
            profile_likelihood: false,
            selection: Selection::default(),
            read: None,
            place,
        })
    }

    /// Sets the elastic medium; without it a half-space. On a graded half-space `coefficient` c takes the place of `e_star`, and on
    /// a Winkler foundation `modulus` K_w: a known number, which may be made free. The exponent of the grading and the reference of
    /// a half-plane stay as they are given. Forces on a half-plane are per length.
    ///
    /// # Errors
    /// A number of the medium out of its domain; a periodic medium; a half-plane without a reference, unless radii are observed.
    pub fn medium(mut self, medium: ExactMedium) -> Result<Self> {
        let refused = |key: &str, why: &str| Err(refuse(key, why));
        if !medium.has_depth() && !self.observation.sees_radius() {
            let why = "a line contact has no depth of its own: give the reference of the measured depths, or observe F(a) or a(F)";
            return refused("medium.reference", why);
        }
        if medium.is_periodic() {
            let why = "fits on a periodic medium are not available: solve scenes for several numbers and compare";
            return refused("medium", why);
        }
        let (name, unit) = medium.modulus_key();
        let value = medium.own_modulus::<f64>(())?;
        let unit_of_force = if medium.force_unit() == "N" { SiUnit::Newton } else { SiUnit::NewtonPerMetre };
        for parameter in &mut self.parameters {
            match parameter.kind {
                Kind::EffectiveModulus => {
                    (parameter.name, parameter.unit) = (name.to_owned(), unit);
                    parameter.value = value.or(parameter.value);
                }
                Kind::Baseline if parameter.unit == SiUnit::Newton => parameter.unit = unit_of_force,
                Kind::BaselineSlope if unit_of_force != SiUnit::Newton && parameter.unit == SiUnit::NewtonPerMetre => {
                    parameter.unit = SiUnit::Pascal;
                }
                Kind::Stiffness if unit_of_force != SiUnit::Newton => parameter.unit = SiUnit::Pascal,
                _ => {}
            }
        }
        self.medium = medium.without_grading();
        Ok(self)
    }

    /// The units of X and Y.
    pub(super) fn units(&self) -> [&'static str; 2] {
        self.observation.units_on(&self.medium)
    }

    /// Whether the modulus is that of the medium, and not E*.
    pub(super) fn has_modulus_of_medium(&self) -> bool {
        self.parameters.iter().any(|parameter| parameter.kind == Kind::EffectiveModulus && parameter.name != "e_star")
    }

    /// Makes these numbers unknown: `e_star`, `work_of_adhesion` or `work_of_adhesion.advancing` and `work_of_adhesion.receding`,
    /// `stiffness`, `sensitivity`, `contact_point`, `baseline`, `baseline_slope`, `baseline_drift`, `position_drift`, and the numbers of
    /// the profile by their keys, such as `radius`.
    ///
    /// # Errors
    /// A name that the problem does not have, or that is named twice.
    pub fn free<'n>(mut self, names: impl IntoIterator<Item = &'n str>) -> Result<Self> {
        for name in names {
            let parameter = self.parameter_mut(name, "fit.free")?;
            if std::mem::replace(&mut parameter.free, true) {
                return Err(refuse("fit.free", format!("`{}` is named twice", excerpt(name))));
            }
        }
        Ok(self)
    }

    /// Sets a known number: `stiffness`, or E* or w where they are not free.
    ///
    /// # Errors
    /// A name that the problem does not have; a number that is not finite, or not positive where it must be.
    pub fn fixed(mut self, name: &str, value: f64) -> Result<Self> {
        let parameter = self.parameter_mut(name, "fit.fixed")?;
        parameter.value = Some(parameter.checked(value, "fit.fixed")?);
        Ok(self)
    }

    /// Sets the starting value of a number. Without it the program finds one.
    ///
    /// # Errors
    /// A name that the problem does not have; a number that is not finite, or not positive where it must be.
    pub fn start(mut self, name: &str, value: f64) -> Result<Self> {
        let parameter = self.parameter_mut(name, "fit.start")?;
        let value = parameter.checked(value, "fit.start")?;
        if value == 0.0 && !parameter.kind.is_offset() {
            let why = "is fitted by its logarithm: its start must be positive; `fixed` may be zero";
            return Err(refuse("fit.start", format!("`{}` {why}", excerpt(name))));
        }
        parameter.start = Some(value);
        Ok(self)
    }

    /// Sets the prior of a number: its mean and standard deviation. The number becomes free.
    ///
    /// # Errors
    /// A name that the problem does not have; a mean that is not finite, or not positive where it must be; a standard deviation
    /// that is not positive.
    pub fn prior(mut self, name: &str, mean: f64, sd: f64) -> Result<Self> {
        let parameter = self.parameter_mut(name, "fit.prior")?;
        let mean = parameter.checked(mean, "fit.prior")?;
        parameter.prior = Some([mean, positive("fit.prior", name, sd)?]);
        parameter.free = true;
        Ok(self)
    }

    /// Keeps a number between two bounds.
    ///
    /// # Errors
    /// A name that the problem does not have; a bound that is not finite, or not positive where it must be; bounds that do not
    /// ascend.
    pub fn bounds(mut self, name: &str, [lower, upper]: [f64; 2]) -> Result<Self> {
        let parameter = self.parameter_mut(name, "fit.bounds")?;
        let bounds = [parameter.checked(lower, "fit.bounds")?, parameter.checked(upper, "fit.bounds")?];
        if bounds[0] >= bounds[1] {
            return Err(refuse(
                "fit.bounds",
                format!("the bounds of `{}` must ascend, got {lower} to {upper}", excerpt(name)),
            ));
        }
        parameter.bounds = Some(bounds);
        Ok(self)
    }

    /// Sets the standard deviation of the given quantity X, for all rows. Without it, or with 0, X is exact: distances are
    /// vertical.
    ///
    /// # Errors
    /// A number that is negative or not finite.
    pub fn sigma_x(mut self, sigma: f64) -> Result<Self> {
        self.sigma[0] = Some(not_negative("data.sigma.x", sigma)?);
        Ok(self)
    }

    /// Sets the standard deviation of the measured quantity Y, for all rows. Without it, or with 0, standard errors are scaled by
    /// the residuals. A factor common to it and to all other standard deviations moves no estimate.
    ///
    /// # Errors
    /// A number that is negative or not finite.
    pub fn sigma_y(mut self, sigma: f64) -> Result<Self> {
        self.sigma[1] = Some(not_negative("data.sigma.y", sigma)?).filter(|sigma| *sigma > 0.0);
        Ok(self)
    }

    /// Sets the leg of each row. Without it legs end where X turns.
    ///
    /// # Errors
    /// Another number of legs than of rows.
    pub fn legs(mut self, legs: &[Leg]) -> Result<Self> {
        if legs.len() != self.rows.len() {
            return Err(refuse("data.leg", format!("{} given for {} rows", legs.len(), self.rows.len())));
        }
        let rows = Shared::make_mut(&mut self.rows);
        for (row, leg) in rows.iter_mut().zip(legs) {
            row.leg = *leg;
        }
        self.turns = super::select::arrange(rows, self.selection.has_times);
        Ok(self)
    }

    /// Sets the loss.
    pub fn loss(self, loss: Loss) -> Self {
        Problem { loss, ..self }
    }

    /// Adds the measured place of the jump out of contact, a value of X, as a datum with its standard deviation. It is reported
    /// beside its prediction in any case.
    ///
    /// # Errors
    /// Numbers that are not finite; a standard deviation that is not positive.
    pub fn pull_off(mut self, place: f64, sd: f64) -> Result<Self> {
        if !place.is_finite() {
            return Err(refuse("events.pull_off", format!("must be finite, got {place}")));
        }
        self.pull_off = Some([place, positive("events.sigma", "sigma", sd)?]);
        Ok(self)
    }

    /// The problem without the questions that go beyond its estimates: certified digits, profile likelihood, range of adhesion.
    pub(super) fn alone(&self) -> Self {
        Problem { digits: None, profile_likelihood: false, range_of_adhesion: None, ..self.clone() }
    }

    /// Requests estimates in so many certified digits as well (feature `mp`).
    pub fn digits(self, digits: u32) -> Self {
        Problem { digits: Some(digits.max(1)), ..self }
    }

    /// Requests [intervals](Fit::intervals) of 68 % and 95 % by profile likelihood as well. They need no linearised model; each
    /// takes some ten further fits.
    pub fn profile_likelihood(self) -> Self {
        Problem { profile_likelihood: true, ..self }
    }

    /// Sets the range of adhesion, in m: the answer then states whether the theory holds for the fitted contact.
    ///
    /// # Errors
    /// A range that is not positive and finite.
    pub fn range_of_adhesion(mut self, range: f64) -> Result<Self> {
        self.range_of_adhesion = Some(positive("output.range_of_adhesion", "range_of_adhesion", range)?);
        Ok(self)
    }

    /// The value of the number of a kind, or its starting value.
    pub(super) fn known(&self, kind: Kind) -> Option<f64> {
        self.parameters.iter().find(|parameter| parameter.kind == kind)?.known()
    }

    /// The work of adhesion at which contacts are about as large as this length, for a modulus of the medium: E* times the length on a
    /// half-space.
    pub(super) fn work_of_length(&self, modulus: f64, length: f64) -> f64 {
        let unit = self.medium.of_modulus((), 1.0);
        modulus * unit.map_or(length, |unit| unit.work_of_length(&length))
    }

    /// A row by what is known before a fit: without trends, and of a true deflection.
    pub(super) fn seen(&self, row: &DataRow) -> [f64; 2] {
        let known = |kind: Kind| self.known(kind).unwrap_or(0.0);
        let [slope, drift] = [Kind::BaselineSlope, Kind::BaselineDrift].map(known);
        let y = row.y - slope * (row.x - known(Kind::ContactPoint)) - drift * row.time;
        let y = match self.known(Kind::Sensitivity) {
            Some(sensitivity) if sensitivity != 1.0 => {
                known(Kind::Baseline) + sensitivity * (y - known(Kind::Baseline))
            }
            _ => y,
        };
        [row.x - known(Kind::PositionDrift) * row.time, y]
    }

    /// Whether the number of a kind is unknown.
    pub(super) fn is_free(&self, kind: Kind) -> bool {
        self.parameters.iter().any(|parameter| parameter.kind == kind && parameter.free)
    }

    /// How many numbers have a prior.
    pub(super) fn priors(&self) -> usize {
        self.parameters.iter().filter(|parameter| parameter.prior.is_some()).count()
    }

    /// The given and the measured quantity.
    pub fn observation(&self) -> Observation {
        self.observation
    }

    /// The rows (X, Y), in SI units.
    pub fn data(&self) -> impl Iterator<Item = [f64; 2]> {
        self.rows.iter().map(|row| [row.x, row.y])
    }

    /// How the text of the curve was read, if it was in a file.
    pub fn read_from(&self) -> Option<&CurveText> {
        self.read.as_ref().map(|(text, _)| text)
    }

    /// The estimates, with their standard errors and further results.
    ///
    /// # Errors
    /// A problem that cannot be fitted: nothing free, no more rows than unknowns, a missing number, all rows out of contact.
    /// Numbers that the data do not determine are no error, but a [status](Fit::status) of the answer.
    pub fn fit(&self) -> Result<Fit> {
        super::drive::fit(&super::select::selected(self)?)
    }

    /// Whether the edge has a work of adhesion of its own for each direction.
    pub(super) fn has_two_works(&self) -> bool {
        let is_given = |parameter: &Parameter| parameter.free || parameter.value.is_some();
        self.parameters.iter().any(|parameter| matches!(parameter.kind, Kind::Work(_)) && is_given(parameter))
    }

    /// The unit of a number by its name; where there is none of this name, the name is what is refused.
    pub(super) fn unit_of(&self, name: &str) -> SiUnit {
        let bare = bare(name);
        let parameter = self.parameters.iter().find(|parameter| parameter.name == bare);
        parameter.map_or(SiUnit::Unstated, |parameter| parameter.unit)
    }

    fn parameter_mut(&mut self, name: &str, key: &str) -> Result<&mut Parameter> {
        let bare = bare(name);
        match self.parameters.iter().position(|parameter| parameter.name == bare) {
            Some(index) => Ok(&mut self.parameters[index]),
            None => {
                let known: Vec<&str> = self.parameters.iter().map(|parameter| parameter.name.as_str()).collect();
                Err(refuse(key, mdr::reading::unknown_name_of_input("name", name, &known)))
            }
        }
    }
}
