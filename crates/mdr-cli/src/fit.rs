//! `mdr fit`: E*, w and other unknowns of measured curves.

use std::path::PathBuf;

use clap::Args;
use indicatif::{ParallelProgressIterator, ProgressBar, ProgressStyle};
use mdr::answer::NumberStyle;
use mdr::fit::{Event, Fit as Answer, FitStatus, Problem};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use crate::error::{Failure, Result};
use crate::output::{Format, Output as Out};
use crate::plot;
use crate::table::{Tone, cell, render_whole, table};
use crate::validity;

const EXAMPLES: &str = "\
Examples:
  E* and w of a tip on a cantilever, with standard errors and what may mislead:
    mdr fit examples/fits/tip.toml

  For another program; with a picture of data, fit, residuals and contact radius:
    mdr fit examples/fits/tip.toml --format json
    mdr fit examples/fits/tip.toml --plot tip.svg

  With intervals that need no linearised model:
    mdr fit examples/fits/tip.toml --profile-likelihood

  With proved digits of the estimates:
    mdr fit examples/fits/tip.toml --digits 15

  The same fit of many curves, on all cores, one row for each number of each curve:
    mdr fit examples/fits/tip.toml --batch curves --format csv

A fit is a TOML file with the tables [profile], [data] and [fit], and with [control] where the
curve is seen through a cantilever; docs/fit.md lists the keys. Data are a CSV file: a header, a
row of units, rows.
JSON: schema mdr.fit/1, one line for each curve.
Exit status: 0 fitted, 1 not determined by the data or not converged, 2 bad input.";

/// Fit E*, work of adhesion, contact point and more to a measured curve.
///
/// The theory decides on which branch a row lies and where the contact jumps: no row is clipped. What the data cannot tell is
/// said, not estimated.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Fit {
    /// The fit, a TOML file
    #[arg(value_name = "FIT.toml")]
    fit: PathBuf,

    /// Curves to fit instead of the file that [data] names
    #[arg(value_name = "CURVE.csv")]
    curves: Vec<PathBuf>,

    /// Fit every .csv file of a folder
    #[arg(long, value_name = "DIR")]
    batch: Option<PathBuf>,

    /// Certify estimates, standard errors and sum of squares to this many significant digits, too
    #[arg(long, value_name = "D", value_parser = clap::value_parser!(u32).range(1..=1000))]
    digits: Option<u32>,

    /// Give intervals of 68 % and 95 % by profile likelihood, too
    #[arg(long)]
    profile_likelihood: bool,

    /// Shape of the answer
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,

    /// Draw data, fitted curve, residuals and contact radius as SVG, and write the data as CSV beside it
    #[arg(long, value_name = "OUT.svg")]
    plot: Option<PathBuf>,

    /// Colours of the picture
    #[arg(long, value_enum, default_value_t)]
    theme: plot::Colours,
}

/// A curve with its answer.
type Fitted = (String, mdr::Result<Answer>);

impl Fit {
    /// Answers on `out`; whether every curve is fitted.
    ///
    /// # Errors
    /// A file that cannot be read, and with a single curve what is wrong with it.
    pub(crate) fn run(&self, out: &mut Out<impl std::io::Write>) -> Result<bool> {
        self.plot.as_deref().map_or(Ok(()), plot::check)?;
        let curves = self.curves()?;
        if curves.is_empty() {
            let answer = self.asked(Problem::open(&self.fit)?).fit()?;
            self.draw(&answer)?;
            let fitted = answer.status == FitStatus::Fitted;
            let name = self.fit.display().to_string();
            write(&[(name, Ok(answer))], self.format, out)?;
            return Ok(fitted);
        }
        if self.plot.is_some() && curves.len() > 1 {
            return Err(Failure::refused("--plot", "draws one curve"));
        }
        let bar = ProgressBar::new(curves.len() as u64);
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} {elapsed}") {
            bar.set_style(style);
        }
        let fitted: Vec<Fitted> = curves
            .par_iter()
            .progress_with(bar.clone())
            .map(|curve| {
                (
                    curve.display().to_string(),
                    Problem::open_for(&self.fit, curve).and_then(|problem| self.asked(problem).fit()),
                )
            })
            .collect();
        bar.finish_and_clear();
        if let [(_, Ok(answer))] = fitted.as_slice() {
            self.draw(answer)?;
        }
        write(&fitted, self.format, out)?;
        Ok(fitted.iter().all(|(_, answer)| answer.as_ref().is_ok_and(|answer| answer.status == FitStatus::Fitted)))
    }

    fn asked(&self, problem: Problem) -> Problem {
        let problem = if self.profile_likelihood { problem.profile_likelihood() } else { problem };
        match self.digits {
            Some(digits) => problem.digits(digits),
            None => problem,
        }
    }

    /// The curves that are named, and those of the folder.
    fn curves(&self) -> Result<Vec<PathBuf>> {
        let mut curves = self.curves.clone();
        if let Some(folder) = &self.batch {
            let failed = |error| Failure::file(format!("--batch {}", folder.display()), error);
            let entries = std::fs::read_dir(folder).map_err(failed)?;
            let mut found: Vec<PathBuf> =
                entries.map(|entry| entry.map(|entry| entry.path())).collect::<std::io::Result<_>>().map_err(failed)?;
            found.retain(|path| path.extension().is_some_and(|extension| extension == "csv"));
            found.sort();
            if found.is_empty() {
                return Err(Failure::flag("--batch", "there is no .csv file in it", &folder.display().to_string()));
            }
            curves.extend(found);
        }
        Ok(curves)
    }

    fn draw(&self, answer: &Answer) -> Result<()> {
        let Some(file) = &self.plot else { return Ok(()) };
        let name = self.fit.file_stem().map_or_else(String::new, |stem| format!(": {}", stem.display()));
        plot::write(
            &mdr_plot::fit(&format!("{} of a {}{name}", answer.observation.name(), answer.profile), answer),
            self.theme,
            file,
            "--plot ",
        )
    }
}

fn write(fitted: &[Fitted], format: Format, out: &mut Out<impl std::io::Write>) -> Result<()> {
    match format {
        Format::Json => {
            for (file, answer) in fitted {
                match answer {
                    Ok(answer) if fitted.len() == 1 => out.text(answer.to_json())?,
                    Ok(answer) => out.text(format_args!("{{\"file\":{},{}", quoted(file), &answer.to_json()[1..]))?,
                    Err(error) => out.json(&Refused {
                        file,
                        schema: "mdr.fit/1",
                        status: "bad-input",
                        reason: error.to_string(),
                    })?,
                }
            }
            Ok(())
        }
        Format::Csv => {
            let header = ["file", "status", "name", "value", "stderr", "scaled_stderr", "unit"];
            out.csv(&header, fitted.iter().flat_map(|(file, answer)| cells(file, answer)))
        }
        Format::Table if fitted.len() == 1 => match &fitted[0].1 {
            Ok(answer) => out.text(for_reader(answer)),
            Err(error) => out.text(error),
        },
        Format::Table => {
            let mut table = table(&["file", "status", "number", "estimate", "standard error", "unit"]);
            for (file, answer) in fitted {
                for [file, status, name, value, stderr, _, unit] in cells(file, answer) {
                    table.add_row([file, status, name, value, stderr, unit]);
                }
            }
            out.text(render_whole(&table))
        }
    }
}

/// The line of a curve that cannot be fitted.
#[derive(serde::Serialize)]
struct Refused<'f> {
    file: &'f str,
    schema: &'static str,
    status: &'static str,
    reason: String,
}

fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

/// One row for each number of a curve; one with the reason where there is none.
fn cells(file: &str, answer: &mdr::Result<Answer>) -> Vec<[String; 7]> {
    let number = |value: Option<f64>| value.map(|value| format!("{value:.9e}")).unwrap_or_default();
    match answer {
        Err(error) => {
            let [file, reason] = [file.to_owned(), error.to_string()];
            vec![[file, "bad-input".to_owned(), reason, String::new(), String::new(), String::new(), String::new()]]
        }
        Ok(answer) => {
            let row = |estimate: &mdr::fit::Estimate| {
                [
                    file.to_owned(),
                    answer.status.name().to_owned(),
                    estimate.name.clone(),
                    number(estimate.value),
                    number(estimate.stderr),
                    number(estimate.scaled_stderr),
                    estimate.unit.to_owned(),
                ]
            };
            answer.parameters.iter().map(row).collect()
        }
    }
}

fn for_reader(answer: &Answer) -> String {
    let rows = answer.rows.len();
    let mut parts = vec![format!(
        "Profile: {}; observed: {}; {rows} rows, {} distances: {}",
        answer.profile,
        answer.observation.name(),
        answer.distance,
        answer.status.name()
    )];
    if !answer.reason.is_empty() {
        parts.push(format!("Reason: {}.", answer.reason));
    }
    parts.push(estimates(answer));
    if !answer.intervals.is_empty() {
        parts.push(intervals(answer));
    }
    if let Some(certified) = &answer.certified {
        let mut table = table(&["certified", "estimate", "scaled by residuals", "unique within"]);
        for estimate in &certified.parameters {
            let [value, stderr] = [&estimate.value, &estimate.scaled_stderr].map(ToString::to_string);
            table.add_row([estimate.name.clone(), value, stderr, format!("± {}", digits(estimate.unique_within, 1))]);
        }
        parts.push(render_whole(&table));
    }
    if !answer.invariants.is_empty() {
        let mut table = table(&["what the data determine", "value, SI", "standard error"]);
        for invariant in &answer.invariants {
            table.add_row([invariant.name.clone(), digits(invariant.value, 10), digits(invariant.stderr, 3)]);
        }
        parts.push(render_whole(&table));
    }
    if answer.status == FitStatus::Fitted && answer.parameters.len() > 1 {
        parts.push(correlations(answer));
    }
    parts.push(quality(answer));
    let unit = |axis: usize| answer.observation.units()[axis];
    for (title, event) in [
        ("Pull-off, predicted", &answer.predicted_pull_off),
        ("Pull-off, measured", &answer.measured_pull_off),
        ("First touch, predicted", &answer.predicted_jump_in),
        ("Jump into contact, measured", &answer.measured_jump_in),
    ] {
        if let Some(event) = event {
            parts.push(format!("{title}: {}", of_event(event, [unit(0), unit(1)])));
        }
    }
    parts.extend(answer.validity.iter().map(|validity| validity::text(validity, &NumberStyle::default())));
    parts.extend(answer.warnings.iter().map(|warning| format!("Warning: {warning}.")));
    parts.join("\n\n")
}

fn estimates(answer: &Answer) -> String {
    let mut table = table(&["number", "estimate", "standard error", "scaled by residuals", "unit"]);
    for estimate in &answer.parameters {
        let number = |value: Option<f64>, figures: usize| match value {
            Some(value) => cell(digits(value, figures), Tone::Good),
            None => cell("not determined", Tone::Bad),
        };
        table.add_row([
            cell(&estimate.name, Tone::Plain),
            number(estimate.value, 10),
            number(estimate.stderr, 3),
            number(estimate.scaled_stderr, 3),
            cell(estimate.unit, Tone::Plain),
        ]);
    }
    render_whole(&table)
}

fn intervals(answer: &Answer) -> String {
    let mut table = table(&["by profile likelihood", "level", "from", "to"]);
    for interval in &answer.intervals {
        let end = |end: Option<f64>| end.map_or_else(|| "open".to_owned(), |end| digits(end, 6));
        let level = format!("{:.0} %", 100.0 * interval.level);
        table.add_row([interval.name.clone(), level, end(interval.lower), end(interval.upper)]);
    }
    render_whole(&table)
}

fn correlations(answer: &Answer) -> String {
    let names: Vec<&str> = answer.parameters.iter().map(|estimate| estimate.name.as_str()).collect();
    let mut table = table(&[&["correlation"], names.as_slice()].concat());
    for (name, row) in names.iter().zip(&answer.correlation) {
        table.add_row(std::iter::once((*name).to_owned()).chain(row.iter().map(|value| format!("{value:.3}"))));
    }
    render_whole(&table)
}

fn quality(answer: &Answer) -> String {
    let unit = if answer.rss_unit == "1" { String::new() } else { format!(" {}", answer.rss_unit) };
    let mut text =
        format!("Residual sum of squares: {}{unit}; degrees of freedom: {}.", digits(answer.rss, 6), answer.dof);
    if let (Some(chi2), Some(p)) = (answer.chi2, answer.chi2_p) {
        text.push_str(&format!(" χ² = {chi2:.2}, p = {p:.3}."));
    }
    if let Some(test) = answer.runs_test {
        text.push_str(&format!(
            " Runs of equal sign: {}, expected {:.1}, p = {:.3}.",
            test.runs, test.expected, test.p
        ));
    }
    text
}

fn of_event(event: &Event, [x_unit, y_unit]: [&str; 2]) -> String {
    let error =
        |index: usize| event.stderr.map_or_else(String::new, |stderr| format!(" ± {}", digits(stderr[index], 2)));
    let mut text = format!(
        "x = {}{} {x_unit}, y = {}{} {y_unit}; F = {}{} N, d = {}{} m",
        digits(event.x, 5),
        error(0),
        digits(event.y, 5),
        error(1),
        digits(event.force, 5),
        error(2),
        digits(event.indentation, 5),
        error(3)
    );
    if let Some(radius) = event.contact_radius {
        text.push_str(&format!(", a = {}{} m", digits(radius, 5), error(4)));
    }
    text
}

/// A number with so many significant digits.
fn digits(value: f64, figures: usize) -> String {
    format!("{value:.*e}", figures.saturating_sub(1))
}
