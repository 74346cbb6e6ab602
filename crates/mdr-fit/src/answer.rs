//! The result of a fit: estimates with their errors, or the reason why the data do not determine them.

use mdr_core::named;
use mdr_core::number::Decimal;

use super::{CurveText, Leg, Observation};
use mdr::validity::Validity;

named! {
    /// How a fit ended.
    pub enum FitStatus {
        /// The estimates are the stationary point of least cost that was found, and the data determine all of them.
        Fitted = "fitted",
        /// So are these, but the stated σ leaves a χ² as large as this a probability below 10⁻⁶.
        PoorFit = "poor-fit",
        /// The data determine only the [invariants](Fit::invariants).
        Unidentifiable = "unidentifiable",
        /// The iteration ended before its tolerance was met.
        NotConverged = "not-converged",
    }
}

impl FitStatus {
    /// Whether there are estimates of all free numbers at a stationary point.
    pub fn has_estimates(self) -> bool {
        matches!(self, FitStatus::Fitted | FitStatus::PoorFit)
    }
}

/// A free number with its estimate; nothing where the data do not determine it.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct FitEstimate {
    /// `e_star`, `work_of_adhesion`, `stiffness`, `contact_point`, `baseline`, or a key of the profile.
    pub name: String,
    /// The estimate.
    pub value: Option<f64>,
    /// The standard error of the estimate: from the stated σ, or scaled by the residuals if none is stated.
    pub stderr: Option<f64>,
    /// The standard error of the estimate scaled by the residuals: from JᵀJ and the residual variance.
    pub scaled_stderr: Option<f64>,
    /// `Pa`, `J/m^2`, `N/m`, `m`, `N`, `1`.
    pub unit: &'static str,
}

/// A product of powers of the free numbers that the data determine although they do not determine its factors.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Invariant {
    /// The product, such as `e_star * radius^(1/2)`.
    pub name: String,
    /// The value of the product, in SI units.
    pub value: f64,
    /// The standard error of the value: from the stated σ, or scaled by the residuals if none is stated.
    pub stderr: f64,
    /// The standard error of the value scaled by the residuals.
    pub scaled_stderr: f64,
}

/// The values of a free number that the data do not contradict at a level, by profile likelihood: the other numbers are fitted again
/// at each.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct LikelihoodInterval {
    /// The name of the free number.
    pub name: String,
    /// 0.68 or 0.95.
    pub level: f64,
    /// The smallest value; `None` if the data exclude none.
    pub lower: Option<f64>,
    /// The largest value; `None` if the data exclude none.
    pub upper: Option<f64>,
}

/// The estimates with another smoothing of a measured tip.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct SmoothedFit {
    /// The length over which its rows are smoothed, in m; `None` for the rows as they are.
    pub length: Option<f64>,
    /// In the order of the free numbers; `None` if the data do not determine one.
    pub estimates: Vec<Option<f64>>,
    /// The sum of squares, in the unit of [`Fit::rss_unit`].
    pub rss: f64,
}

/// A row of the data beside the fitted curve.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct FittedRow {
    /// The given quantity X, in SI units.
    pub x: f64,
    /// The measured quantity Y, in SI units.
    pub y: f64,
    /// Approach or retract.
    #[cfg_attr(feature = "serde", serde(serialize_with = "text"))]
    pub leg: Leg,
    /// The arc it lies on, 0 the outermost; −1 detached.
    pub label: i32,
    /// The residual of the row as it counts in the objective, curve minus datum, in units of σ.
    pub residual: f64,
    /// The nearest point of the curve.
    pub fitted: [f64; 2],
    /// The contact radius there, in m; `None` for a detached row.
    pub contact_radius: Option<f64>,
    /// Whether the edge of the contact is pinned there, between two works of adhesion.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "std::ops::Not::not"))]
    pub pinned: bool,
}

/// A jump into or out of contact.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct FitEvent {
    /// X as it is recorded, offsets included.
    pub x: f64,
    /// Y as it is recorded.
    pub y: f64,
    /// F, in N; `None` if the data do not determine it.
    pub force: Option<f64>,
    /// d, in m; `None` if the data do not determine it.
    pub indentation: Option<f64>,
    /// a, in m; `None` if the data do not determine it, and for a measured event.
    pub contact_radius: Option<f64>,
    /// Standard errors of x, y, force, indentation and contact radius; `None` for a measured event.
    pub stderr: Option<[f64; 5]>,
}

/// Whether the signs of the residuals are in a random order (Wald and Wolfowitz 1940).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct RunsTest {
    /// The number of runs of equal sign.
    pub runs: usize,
    /// The expected number of runs.
    pub expected: f64,
    /// The deviation in standard deviations.
    pub z: f64,
    /// The probability of at least this deviation.
    pub p: f64,
}

/// Whether neighbouring residuals are alike, as where a filter, a drift or a wrong model leaves its trace. White noise has none.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Autocorrelation {
    /// The correlation of residuals with the next of their leg; 2 − 2 of it is the statistic of Durbin and Watson.
    pub lag_one: f64,
    /// Its deviation from that of white noise, in standard deviations.
    pub z: f64,
    /// The probability of at least this correlation in white noise.
    pub p: f64,
    /// The factor by which standard errors grow with residuals that are so correlated: the root of the sum of the correlations of all
    /// lags up to the first that is not positive. It is that of a number on which all rows count alike, and a bound for others.
    pub widening: f64,
}

/// Estimates in digits that are proved, for the labels of the fit.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct CertifiedFit {
    /// The number of significant digits.
    pub digits: u32,
    /// The estimates, in the order of the free numbers.
    pub parameters: Vec<CertifiedEstimate>,
    /// Whether the second derivatives are proved to be positive definite, so that the estimates are a local minimum of the sum of
    /// squares. Otherwise they are proved to be a stationary point.
    pub local_minimum: bool,
    /// The sum of squares.
    #[cfg_attr(feature = "serde", serde(serialize_with = "text"))]
    pub rss: Decimal,
}

/// A free number whose digits are all proved.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct CertifiedEstimate {
    /// The name of the free number.
    pub name: String,
    /// The estimate.
    #[cfg_attr(feature = "serde", serde(serialize_with = "text"))]
    pub value: Decimal,
    /// The standard error of the estimate scaled by the residuals.
    #[cfg_attr(feature = "serde", serde(serialize_with = "text"))]
    pub scaled_stderr: Decimal,
    /// No other stationary point lies within this distance in each number at once.
    pub unique_within: f64,
}

/// A limit of a free number that the rows do not determine, or hardly tell from zero.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct FitLimit {
    /// The name of the free number.
    pub name: String,
    /// The smallest value; `None` if there is no lower limit.
    pub lower: Option<f64>,
    /// The largest value; `None` if there is no upper limit.
    pub upper: Option<f64>,
    /// The level of confidence; `None` for limits that follow from where rows lie.
    pub level: Option<f64>,
    /// The unit of the limits.
    pub unit: &'static str,
}

/// How an estimate follows a given number, of the linearised model: ∂ln θ/∂ln φ, for an offset ∂θ/∂ln φ.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct BudgetEntry {
    /// The name of the free number θ.
    pub name: String,
    /// The name of the given number φ.
    pub of: String,
    /// The derivative.
    pub slope: f64,
    /// The unit of the derivative: `1`, or that of an offset.
    pub unit: &'static str,
}

/// A quantity that follows from a record of force. Pulling counts positive.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct FitQuantity {
    /// `adhesion_force`, `pull_off_force`, `separation_work`, and with `_measured` those of the rows.
    pub name: &'static str,
    /// The meaning of the quantity in words.
    pub label: &'static str,
    /// The value, in SI units.
    pub value: f64,
    /// The standard error; `None` for a quantity of the rows, and for the work of separation.
    pub stderr: Option<f64>,
    /// `N` or `J`; per length on a half-plane.
    pub unit: &'static str,
}

/// The residuals of one leg of a record.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct FittedLeg {
    /// Approach or retract.
    #[cfg_attr(feature = "serde", serde(serialize_with = "text"))]
    pub leg: Leg,
    /// The number of rows.
    pub rows: usize,
    /// The number of rows in contact.
    pub in_contact: usize,
    /// The number of rows at which the edge of the contact is pinned.
    pub pinned: usize,
    /// The mean square of the residuals, in units of σ; `None` beyond the range of a double.
    pub mean_square: Option<f64>,
    /// The order of the signs of the residuals.
    pub runs_test: Option<RunsTest>,
    /// The correlation of the residuals.
    pub autocorrelation: Option<Autocorrelation>,
}

/// Rows of the data that do not count.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct SkippedRows {
    /// `not a number`, `saturated`, `other leg`, `outside of x`, `outside of y`.
    pub why: &'static str,
    /// The number of rows.
    pub rows: usize,
}

/// An end of a descent: its start and its result.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Attempt {
    /// `approach-alone` and `retract-alone`, one leg where there are two works of adhesion; `given`, by the problem; `two-points`, of a power law; `regression`, of known contact radii; `all-in-contact` and `jump`, hypotheses
    /// on the record; `search`, over w/E*; `beside-another`, one standard error from one of these.
    pub start: &'static str,
    /// The number of rows out of contact.
    pub detached: usize,
    /// The free numbers, in their order.
    pub estimates: Vec<f64>,
    /// The sum of squares, in the unit of [`Fit::rss_unit`]. Of an end that was not followed because others are better it is larger
    /// than at the minimum nearby.
    pub rss: f64,
}

/// The answer to a [`Problem`](super::Problem).
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Fit {
    /// How the fit ended.
    #[cfg_attr(feature = "serde", serde(serialize_with = "text"))]
    pub status: FitStatus,
    /// The meaning of the status for these data, in words; empty when all is well.
    pub reason: String,
    /// The name of the profile.
    pub profile: &'static str,
    /// The given and the measured quantity.
    #[cfg_attr(feature = "serde", serde(serialize_with = "observation"))]
    pub observation: Observation,
    /// The units of X and Y; forces on a half-plane are per length.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub units: [&'static str; 2],
    /// The elastic medium, where it is no half-space.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub medium: Option<&'static str>,
    /// The estimates, in the order in which the numbers were made free.
    pub parameters: Vec<FitEstimate>,
    /// The covariance of the estimates, with the standard errors of [`FitEstimate::stderr`]; empty unless all are determined.
    pub covariance: Vec<Vec<f64>>,
    /// The correlation of the estimates; empty unless all are determined.
    pub correlation: Vec<Vec<f64>>,
    /// The combinations that the data determine, if they do not determine the free numbers.
    pub invariants: Vec<Invariant>,
    /// Singular values of the Jacobian with columns of unit length, descending.
    pub singular_values: Vec<f64>,
    /// The sum of squares: of Y in its unit squared where all rows count alike and vertically, else in units of σ.
    pub rss: f64,
    /// The unit of `rss`: `N^2`, `m^2` or `1`.
    pub rss_unit: &'static str,
    /// Rows and priors less free numbers.
    pub dof: usize,
    /// The sum of squares in units of σ, if σ is given; `None` if it is beyond the range of a double.
    pub chi2: Option<f64>,
    /// The probability of at least this χ².
    pub chi2_p: Option<f64>,
    /// σ_X and σ_Y as they were used.
    pub sigma: [f64; 2],
    /// `vertical` or `orthogonal`.
    pub distance: &'static str,
    /// The order of the signs of the residuals.
    pub runs_test: Option<RunsTest>,
    /// The correlation of residuals within their legs.
    pub autocorrelation: Option<Autocorrelation>,
    /// Each row, with its fitted state and its residual.
    pub rows: Vec<FittedRow>,
    /// The arcs of the fitted curve as points (X, Y, a), the outermost first.
    pub arcs: Vec<Vec<[f64; 3]>>,
    /// The event in which the contact breaks, by the fitted curve.
    pub predicted_pull_off: Option<FitEvent>,
    /// The last row in contact before the first detached one.
    pub measured_pull_off: Option<FitEvent>,
    /// X of the last row in contact and of the first detached one: the contact breaks between them.
    pub pull_off_between: Option<[f64; 2]>,
    /// The event in which the surfaces touch, by the fitted curve.
    pub predicted_jump_in: Option<FitEvent>,
    /// The first row in contact after the last detached one.
    pub measured_jump_in: Option<FitEvent>,
    /// X of the last detached row and of the first in contact: the contact forms between them.
    pub jump_in_between: Option<[f64; 2]>,
    /// Whether the theory holds for the fitted contact, where the range of adhesion is given and the data determine it.
    pub validity: Option<Box<Validity>>,
    /// Warnings of results that may mislead.
    pub warnings: Vec<String>,
    /// Proved digits, if they were requested and can be given; if they cannot, a warning states the reason.
    pub certified: Option<CertifiedFit>,
    /// How the text of the curve was read, if it was in a file.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub read: Option<Box<CurveText>>,
    /// Evaluations of the curve.
    pub evaluations: usize,
    /// Different ends of the descents from all starts, the least sum of squares first, which is the answer.
    pub tried: Vec<Attempt>,
    /// Intervals of the free numbers, if [`profile_likelihood`](super::Problem::profile_likelihood) was requested.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Vec::is_empty"))]
    pub intervals: Vec<LikelihoodInterval>,
    /// The estimates with other smoothings of a measured tip, which show the effect of its noise.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Vec::is_empty"))]
    pub smoothing: Vec<SmoothedFit>,
    /// Each leg of the record with its residuals.
    pub legs: Vec<FittedLeg>,
    /// Adhesion force, force before the jump and work of separation, of the fitted curve and of the rows.
    pub quantities: Vec<FitQuantity>,
    /// How the estimates follow the numbers that are given.
    pub budget: Vec<BudgetEntry>,
    /// Limits of free numbers that the rows do not determine, or hardly tell from zero.
    pub limits: Vec<FitLimit>,
    /// Rows that do not count, by the reason.
    pub skipped: Vec<SkippedRows>,
}

impl Fit {
    /// A quantity that follows from the record, by its name.
    pub fn quantity(&self, name: &str) -> Option<&FitQuantity> {
        self.quantities.iter().find(|quantity| quantity.name == name)
    }

    /// The estimate of a free number.
    pub fn estimate(&self, name: &str) -> Option<&FitEstimate> {
        let bare = super::problem::bare(name);
        self.parameters.iter().find(|estimate| estimate.name == bare)
    }
}

#[cfg(feature = "serde")]
impl Fit {
    /// JSON of the schema `mdr.fit/1`.
    pub fn to_json(&self) -> String {
        #[derive(serde::Serialize)]
        struct Document<'f> {
            schema: &'static str,
            #[serde(flatten)]
            fit: &'f Fit,
        }
        // Every key is a string and every number is finite or null, so that nothing can fail.
        serde_json::to_string(&Document { schema: "mdr.fit/1", fit: self }).unwrap_or_default()
    }
}

/// Digits, and names.
#[cfg(feature = "serde")]
fn text<S: serde::Serializer>(text: &impl std::fmt::Display, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(text)
}

#[cfg(feature = "serde")]
fn observation<S: serde::Serializer>(observation: &Observation, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(observation.name())
}
