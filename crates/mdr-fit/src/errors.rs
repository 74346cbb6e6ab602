//! Errors of the free numbers, and the combinations that the data determine if they do not determine all.

use nalgebra::DVector;

use super::answer::{FitEstimate, FitStatus, Invariant};
use super::judge::{self, Spectrum};
use super::objective::{Evaluation, Objective};
use super::problem::Kind;

/// Errors of the free numbers and of quantities that follow from them.
pub(super) struct Errors<'a> {
    pub(super) objective: &'a Objective<'a>,
    pub(super) fitted: &'a [f64],
    /// The free numbers that no bound holds, by their place.
    pub(super) kept: &'a [usize],
    pub(super) spectrum: &'a Spectrum,
    /// The standard deviation of a residual: as stated, and by the residuals.
    pub(super) scales: [f64; 2],
}

/// A place one standard error away from the answer.
pub(super) struct Step {
    /// The number, by its place.
    pub(super) place: usize,
    pub(super) fitted: Vec<f64>,
    pub(super) rise: f64,
}

impl Errors<'_> {
    pub(super) fn kinds(&self) -> Vec<Kind> {
        self.kept.iter().map(|place| self.objective.kind(*place)).collect()
    }

    /// The standard error of a quantity with this gradient in the fitted values, from the stated σ if there is one.
    pub(super) fn stderr(&self, gradient: &DVector<f64>) -> f64 {
        self.scales[0] * self.spectrum.covariance(gradient, gradient).sqrt()
    }

    /// How a free number grows with its fitted value.
    pub(super) fn slope(&self, place: usize) -> f64 {
        if self.objective.is_offset(place) { 1.0 } else { self.objective.value(place, self.fitted[place]) }
    }

    fn gradient(&self, index: usize) -> DVector<f64> {
        let mut gradient = DVector::zeros(self.kept.len());
        gradient[index] = self.slope(self.kept[index]);
        gradient
    }

    pub(super) fn estimates(&self, status: FitStatus) -> Vec<FitEstimate> {
        let undetermined = self.spectrum.undetermined();
        let estimate = |place: usize| {
            let parameter = self.objective.parameter(place);
            let index = self.kept.iter().position(|kept| *kept == place);
            let known = index.is_none_or(|index| status != FitStatus::Unidentifiable || !undetermined[index]);
            let stderr = |scale: f64| {
                let gradient = self.gradient(index.filter(|_| known)?);
                // Beyond the range of a double where σ is stated so.
                Some(scale * self.spectrum.covariance(&gradient, &gradient).sqrt()).filter(|stderr| stderr.is_finite())
            };
            FitEstimate {
                name: parameter.name.clone(),
                value: known.then(|| self.objective.value(place, self.fitted[place])),
                stderr: stderr(self.scales[0]),
                scaled_stderr: stderr(self.scales[1]),
                unit: parameter.unit_name(),
            }
        };
        (0..self.fitted.len()).map(estimate).collect()
    }

    /// The covariance of all free numbers if a residual has this standard deviation; zero for a number that a bound holds.
    pub(super) fn covariance(&self, scale: f64) -> Vec<Vec<f64>> {
        let mut covariance = vec![vec![0.0; self.fitted.len()]; self.fitted.len()];
        for (one, row) in self.kept.iter().enumerate() {
            for (other, column) in self.kept.iter().enumerate() {
                let value = self.spectrum.covariance(&self.gradient(one), &self.gradient(other));
                covariance[*row][*column] = value * scale * scale;
            }
        }
        covariance
    }

    /// One standard error below and above each estimate, with the others following it, and by how much the sum of squares rises there, in
    /// variances: by one where the curve is as good as linear in the numbers. Places where it has no value are left out.
    pub(super) fn steps(&self, evaluation: &Evaluation) -> Vec<Step> {
        let unit = |index: usize| DVector::from_fn(self.kept.len(), |place, _| f64::from(u8::from(place == index)));
        let step = |index: usize, sign: f64| {
            let own = unit(index);
            let deviation = self.spectrum.covariance(&own, &own).sqrt();
            let mut fitted = self.fitted.to_vec();
            for (other, place) in self.kept.iter().enumerate() {
                fitted[*place] += sign * self.scales[1] * self.spectrum.covariance(&unit(other), &own) / deviation;
            }
            let cost = self.objective.evaluate(&fitted, Some(&evaluation.turns)).ok()?.cost();
            let rise = (cost - evaluation.cost()) / self.scales[1].powi(2);
            rise.is_finite().then_some(Step { place: self.kept[index], fitted, rise })
        };
        (0..self.kept.len()).flat_map(|index| [-1.0, 1.0].map(|sign| step(index, sign))).flatten().collect()
    }

    /// The combinations that the data determine instead, and a description in words.
    pub(super) fn invariants(&self) -> (Vec<Invariant>, String) {
        let names: Vec<&str> = self.kept.iter().map(|place| self.objective.parameter(*place).name.as_str()).collect();
        let fitted: Vec<f64> = self.kept.iter().map(|place| self.fitted[*place]).collect();
        let undetermined = self.spectrum.undetermined();
        let lost: Vec<&str> =
            names.iter().zip(&undetermined).filter(|(_, lost)| **lost).map(|(name, _)| *name).collect();
        let offsets =
            self.kept.iter().zip(&undetermined).any(|(place, lost)| *lost && self.objective.is_offset(*place));
        let (exponents, pivots) = self.spectrum.exponents();
        let give: Vec<&str> = pivots.iter().map(|place| names[*place]).collect();
        let remedy = format!("give {}, a prior for it, or contact radii", listed(&give));
        if offsets {
            return (Vec::new(), format!("these data do not determine {}: {remedy}", listed(&lost)));
        }
        let invariant = |exponents: &DVector<f64>| {
            let value = exponents.iter().zip(&fitted).map(|(exponent, ln)| exponent * ln).sum::<f64>().exp();
            let relative = self.spectrum.covariance(exponents, exponents).sqrt();
            let [stderr, scaled_stderr] = self.scales.map(|scale| value * scale * relative);
            Invariant { name: judge::product(&names, exponents), value, stderr, scaled_stderr }
        };
        let invariants: Vec<Invariant> = exponents.iter().map(invariant).collect();
        let fixed: Vec<&str> = invariants.iter().map(|invariant| invariant.name.as_str()).collect();
        let what = if fixed.is_empty() { "nothing".to_owned() } else { format!("only {}", listed(&fixed)) };
        (invariants, format!("of {} these data determine {what}: {remedy}", listed(&lost)))
    }
}

fn listed(names: &[&str]) -> String {
    match names {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [before @ .., last] => format!("{} and {last}", before.join(", ")),
    }
}
