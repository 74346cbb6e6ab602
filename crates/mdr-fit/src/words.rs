//! A fit in words, beside its table of estimates: heading, quality, starts, events, intervals.

use crate::{Fit, FitEvent, LikelihoodInterval, SmoothedFit};

impl Fit {
    /// The observation, the profile and the status of the fit, in a line; the reason below it if something is amiss.
    pub fn heading(&self) -> String {
        let Fit { profile, observation, distance, .. } = self;
        let (rows, status) = (self.rows.len(), self.status.name());
        let line = format!(
            "Profile: {profile}; observed: {}; {rows} rows, {distance} distances: {status}",
            observation.name()
        );
        if self.reason.is_empty() { line } else { format!("{line}\n\nReason: {}.", self.reason) }
    }

    /// How well the curve goes through the data, in a few sentences.
    pub fn quality(&self) -> String {
        let Fit { rss, dof, .. } = self;
        let unit = if self.rss_unit == "1" { String::new() } else { format!(" {}", self.rss_unit) };
        let mut text = format!("Residual sum of squares: {rss:.5e}{unit}; degrees of freedom: {dof}.");
        if let (Some(chi2), Some(p)) = (self.chi2, self.chi2_p) {
            let size = if chi2 < 1e6 { format!("{chi2:.2}") } else { format!("{chi2:.4e}") };
            text.push_str(&format!(" χ² = {size}, p = {p:.3}."));
        }
        if let Some(test) = self.runs_test {
            let (runs, expected, p) = (test.runs, test.expected, test.p);
            text.push_str(&format!(" Runs of equal sign: {runs}, expected {expected:.1}, p = {p:.3}."));
        }
        text
    }

    /// The limits of numbers that the rows do not determine, a row for each: name, ends, level and unit.
    pub fn limit_rows(&self) -> Vec<[String; 5]> {
        let end = |end: Option<f64>| end.map_or_else(|| "open".to_owned(), |end| format!("{end:.4e}"));
        let level = |level: Option<f64>| level.map_or_else(String::new, |level| format!("{:.0} %", 100.0 * level));
        let limits = self.limits.iter();
        limits
            .map(|limit| {
                [limit.name.clone(), end(limit.lower), end(limit.upper), level(limit.level), limit.unit.to_owned()]
            })
            .collect()
    }

    /// How the estimates follow the given numbers: a header, and a row for each estimate.
    pub fn budget_table(&self) -> (Vec<String>, Vec<Vec<String>>) {
        let mut given: Vec<&str> = self.budget.iter().map(|entry| entry.of.as_str()).collect();
        given.dedup();
        let header = std::iter::once("follows, per ln".to_owned()).chain(given.iter().map(|of| (*of).to_owned()));
        let header = header.chain(["unit".to_owned()]).collect();
        let mut rows = Vec::new();
        for estimate in &self.parameters {
            let own: Vec<_> = self.budget.iter().filter(|entry| entry.name == estimate.name).collect();
            let Some(first) = own.first() else { continue };
            // A slope of the baseline may have the unit one, and is no logarithm.
            let is_logarithm = first.unit == "1" && estimate.name != "baseline_slope";
            let name = if is_logarithm { format!("ln {}", estimate.name) } else { estimate.name.clone() };
            let slope = |of: &&str| {
                let entry = own.iter().find(|entry| entry.of == **of);
                entry.map_or_else(String::new, |entry| {
                    if entry.unit == "1" { format!("{:.3}", entry.slope) } else { format!("{:.2e}", entry.slope) }
                })
            };
            let cells = given.iter().map(slope);
            rows.push(std::iter::once(name).chain(cells).chain([first.unit.to_owned()]).collect());
        }
        (header, rows)
    }

    /// Adhesion force, force before the jump and work of separation, a row for each: meaning, value, standard error and unit.
    pub fn quantity_rows(&self) -> Vec<[String; 4]> {
        let row = |quantity: &crate::FitQuantity| {
            let stderr = quantity.stderr.map_or_else(String::new, |stderr| format!("{stderr:.1e}"));
            [quantity.label.to_owned(), format!("{:.5e}", quantity.value), stderr, quantity.unit.to_owned()]
        };
        self.quantities.iter().map(row).collect()
    }

    /// The residuals of each leg, a row for each.
    pub fn leg_rows(&self) -> Vec<[String; 6]> {
        let row = |leg: &crate::FittedLeg| {
            let mean = leg.mean_square.map_or_else(String::new, |mean| format!("{mean:.3}"));
            let p = leg.runs_test.map_or_else(String::new, |test| format!("{:.3}", test.p));
            let [rows, contact, pinned] = [leg.rows, leg.in_contact, leg.pinned].map(|count| count.to_string());
            [leg.leg.name().to_owned(), rows, contact, pinned, mean, p]
        };
        self.legs.iter().map(row).collect()
    }

    /// How many rows do not count and why, in a sentence; `None` if all count.
    pub fn left_out(&self) -> Option<String> {
        let reasons: Vec<String> =
            self.skipped.iter().map(|skipped| format!("{} {}", skipped.rows, skipped.why)).collect();
        (!reasons.is_empty()).then(|| format!("Rows left out: {}.", reasons.join(", ")))
    }

    /// Which starts led where, in a sentence.
    pub fn attempts(&self) -> String {
        let ends: Vec<String> = self
            .tried
            .iter()
            .map(|attempt| {
                format!(
                    "{} rows detached, sum of squares {:.4e} (from `{}`)",
                    attempt.detached, attempt.rss, attempt.start
                )
            })
            .collect();
        match ends.as_slice() {
            [] => String::new(),
            [one] => format!("All starts led to one end: {one}."),
            [first, rest @ ..] => {
                format!("Of {} ends the first is the answer: {first}; {}.", ends.len(), rest.join("; "))
            }
        }
    }

    /// The pull-off and the first touch, predicted and measured, in a sentence for each that has a value.
    pub fn events(&self) -> Vec<String> {
        let named = [
            ("Pull-off, predicted", &self.predicted_pull_off),
            ("Pull-off, measured", &self.measured_pull_off),
            ("First touch, predicted", &self.predicted_jump_in),
            ("Jump into contact, measured", &self.measured_jump_in),
        ];
        let units = self.units;
        let known = named.into_iter().filter_map(|(title, event)| Some((title, event.as_ref()?)));
        known.map(|(title, event)| format!("{title}: {}", event.sentence(&units))).collect()
    }

    /// The estimates with other smoothings of the tip: a header, and a row for each.
    pub fn smoothing_table(&self) -> (Vec<String>, Vec<Vec<String>>) {
        let names = self.parameters.iter().map(|estimate| estimate.name.clone());
        let header = std::iter::once("tip smoothed over".to_owned()).chain(names).chain(["sum of squares".to_owned()]);
        let number =
            |value: Option<f64>| value.map_or_else(|| "not determined".to_owned(), |value| format!("{value:.5e}"));
        let row = |other: &SmoothedFit| {
            let length = other.length.map_or_else(|| "rows as they are".to_owned(), |length| format!("{length:.2e} m"));
            let numbers = other.estimates.iter().copied().chain([Some(other.rss)]).map(number);
            std::iter::once(length).chain(numbers).collect()
        };
        (header.collect(), self.smoothing.iter().map(row).collect())
    }

    /// The intervals by profile likelihood, a row for each: name, level and ends.
    pub fn interval_rows(&self) -> Vec<[String; 4]> {
        let end = |end: Option<f64>| end.map_or_else(|| "open".to_owned(), |end| format!("{end:.5e}"));
        let row = |interval: &LikelihoodInterval| {
            let level = format!("{:.0} %", 100.0 * interval.level);
            [interval.name.clone(), level, end(interval.lower), end(interval.upper)]
        };
        self.intervals.iter().map(row).collect()
    }
}

impl FitEvent {
    /// Its numbers, with their standard errors if there are any; X and Y are in the first two `units`.
    fn sentence(&self, units: &[&str]) -> String {
        // The standard errors are in the order of the numbers.
        let number = |index: usize, value: f64| match self.stderr {
            Some(stderr) if stderr[index] > 0.0 => format!("{value:.4e} ± {:.1e}", stderr[index]),
            _ if value == 0.0 => "0".to_owned(),
            _ => format!("{value:.4e}"),
        };
        let [x, y] = [number(0, self.x), number(1, self.y)];
        let mut sentence = format!("x = {x} {}, y = {y} {}", units[0], units[1]);
        let state = [("F", self.force, "N"), ("d", self.indentation, "m"), ("a", self.contact_radius, "m")];
        let known = (2..).zip(state).filter_map(|(index, (symbol, value, unit))| Some((index, symbol, value?, unit)));
        for (place, (index, symbol, value, unit)) in known.enumerate() {
            let separator = if place == 0 { "; " } else { ", " };
            sentence += &format!("{separator}{symbol} = {} {unit}", number(index, value));
        }
        sentence
    }
}
