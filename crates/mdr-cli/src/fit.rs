//! `mdr fit`: E*, w and other unknowns of measured curves.

use std::path::PathBuf;

use clap::Args;
use indicatif::ParallelProgressIterator;
use mdr::answer::NumberStyle;
use mdr_core::text::{excerpt, printable};
use mdr_fit::{Fit as Answer, FitStatus, Problem};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use crate::error::{Failure, Result};
use crate::output::{Format, Output as Out};
use crate::plot::PictureFlags;
use crate::table::{CellStyle, cell, render_whole, table, text_table};
use crate::{files, progress, validity};

/// The help of `--plot`.
const PICTURE: &str = "Draw data, fitted curve, residuals and contact radius as SVG, PNG or PDF by the name of the file, and write the data as CSV beside it";

/// Fit E*, work of adhesion, contact point and more to a measured curve.
///
/// The theory decides on which branch a row lies and where the contact jumps: no row is clipped. Parameters that the data do
/// not determine are reported, not estimated.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../help/fit.txt"), mut_arg("plot", |flag| flag.help(PICTURE)))]
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

    /// Also certify estimates, standard errors and sum of squares to this many significant digits
    #[arg(long, value_name = "D", value_parser = clap::value_parser!(u32).range(1..=1000))]
    digits: Option<u32>,

    /// Also give intervals of 68 % and 95 % by profile likelihood
    #[arg(long)]
    profile_likelihood: bool,

    /// Shape of the answer
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,

    #[command(flatten)]
    picture: PictureFlags,
}

/// A curve with its answer.
type Fitted = (String, mdr::Result<Answer>);

impl Fit {
    /// Answers on `out`; whether every curve is fitted.
    ///
    /// # Errors
    /// A file that cannot be read or fitted; of several curves after all answers, with how many there are.
    pub(crate) fn run(&self, out: &mut Out<impl std::io::Write>) -> Result<bool> {
        let drawn = self.picture.wanted()?;
        let curves = self.curves()?;
        if drawn && curves.len() > 1 {
            return Err(Failure::refused("--plot", "draws one curve"));
        }
        let mut fitted = match curves.is_empty() {
            true => vec![(self.fit.display().to_string(), Ok(self.asked(Problem::open(&self.fit)?).fit()?))],
            false => self.fit_all(&curves)?,
        };
        if fitted.len() == 1 {
            // One curve is refused as the file of a fit is.
            fitted = fitted.into_iter().map(|(file, answer)| Ok((file, Ok(answer?)))).collect::<Result<_>>()?;
        }
        if let [(_, Ok(answer))] = fitted.as_slice() {
            self.draw(answer)?;
        }
        write(&fitted, self.format, out)?;
        let mut refused = fitted.iter().filter_map(|(file, answer)| Some((file, answer.as_ref().err()?)));
        if let Some((file, why)) = refused.next() {
            let [count, all] = [1 + refused.count(), fitted.len()];
            let why = format_args!("{count} of {all} cannot be fitted; the first is {}: {why}", excerpt(file));
            return Err(Failure::refused("CURVE.csv", why));
        }
        Ok(fitted.iter().all(|(_, answer)| answer.as_ref().is_ok_and(|answer| answer.status == FitStatus::Fitted)))
    }

    /// On all cores, with a bar.
    fn fit_all(&self, curves: &[PathBuf]) -> Result<Vec<Fitted>> {
        let open = Problem::opener(&self.fit)?;
        let bar = progress::bar(curves.len());
        let fit = |curve: &PathBuf| {
            let answer = open(curve).and_then(|problem| self.asked(problem).fit());
            (curve.display().to_string(), answer)
        };
        let fitted = curves.par_iter().progress_with(bar.clone()).map(fit).collect();
        bar.finish_and_clear();
        Ok(fitted)
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
            let failed = |error| files::of_flag("--batch", folder, error);
            let entries = std::fs::read_dir(folder).map_err(failed)?;
            let mut found: Vec<PathBuf> =
                entries.map(|entry| entry.map(|entry| entry.path())).collect::<std::io::Result<_>>().map_err(failed)?;
            found.retain(|path| path.extension().is_some_and(|extension| extension == "csv"));
            found.sort();
            if let Some(other) = found.iter().find(|path| !path.is_file()) {
                let why = "no regular file: a folder, a device or a pipe";
                return Err(Failure::flag("--batch", why, &other.display().to_string()));
            }
            if found.is_empty() {
                return Err(Failure::flag("--batch", "there is no .csv file in it", &folder.display().to_string()));
            }
            curves.extend(found);
        }
        Ok(curves)
    }

    fn draw(&self, answer: &Answer) -> Result<()> {
        let name = self.fit.file_stem().map_or_else(String::new, |stem| format!(": {}", files::shown(stem.as_ref())));
        let title = format!("{} of a {}{name}", answer.observation.name(), answer.profile);
        self.picture.draw(|| Ok(mdr_plot::fit(&title, answer)))
    }
}

fn write(fitted: &[Fitted], format: Format, out: &mut Out<impl std::io::Write>) -> Result<()> {
    match format {
        Format::Json => {
            for (file, answer) in fitted {
                match answer {
                    Ok(answer) if fitted.len() == 1 => out.json_lines(&answer.to_json())?,
                    Ok(answer) => {
                        let file = serde_json::Value::from(file.as_str());
                        out.json_lines(&format!("{{\"file\":{file},{}", &answer.to_json()[1..]))?;
                    }
                    Err(error) => {
                        let reason = error.to_string();
                        out.json(&Refused { file, schema: "mdr.fit/1", status: "bad-input", reason })?;
                    }
                }
            }
            Ok(())
        }
        Format::Csv => {
            let header = [
                "file",
                "status",
                "name",
                "value",
                "stderr",
                "scaled_stderr",
                "unit",
                "chi2",
                "chi2_p",
                "reason",
                "warnings",
                "lower_limit",
                "upper_limit",
                "adhesion_force",
                "pull_off_force",
                "separation_work",
            ];
            let rows = fitted.iter().flat_map(|(file, answer)| {
                let (more, quantities) = (remarks(answer), quantities_of(answer));
                cells(file, answer).into_iter().map(move |row| {
                    let limits = limits_of(answer, &row[2]);
                    row.into_iter().chain(more.clone()).chain(limits).chain(quantities.clone()).collect::<Vec<_>>()
                })
            });
            out.csv(&header, rows)
        }
        Format::Table if fitted.len() == 1 => match &fitted[0].1 {
            Ok(answer) => out.text(for_reader(answer)),
            Err(error) => out.text(error),
        },
        Format::Table => {
            let rows = fitted.iter().flat_map(|(file, answer)| cells(file, answer));
            let rows = rows.map(|[file, status, name, value, stderr, _, unit]| {
                [excerpt(&file).to_string(), status, printable(&name).to_string(), value, stderr, unit]
            });
            let header = ["file", "status", "number", "estimate", "standard error", "unit"];
            let warnings = fitted.iter().flat_map(|(file, answer)| {
                let file = excerpt(file);
                let warnings = answer.iter().flat_map(|answer| &answer.warnings);
                let warnings = warnings.map(move |warning| format!("{file}: Warning: {warning}."));
                let reason = answer.iter().filter(|answer| !answer.reason.is_empty());
                reason.map(move |answer| format!("{file}: Reason: {}.", answer.reason)).chain(warnings)
            });
            let parts: Vec<String> = std::iter::once(text_table(&header, rows)).chain(warnings).collect();
            out.text(parts.join("\n\n"))
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

/// One row for each number of a curve; one with the reason where there is none.
fn cells(file: &str, answer: &mdr::Result<Answer>) -> Vec<[String; 7]> {
    let number = |value: Option<f64>| value.map(|value| format!("{value:.9e}")).unwrap_or_default();
    match answer {
        Err(error) => vec![[file, "bad-input", &error.to_string(), "", "", "", ""].map(str::to_owned)],
        Ok(answer) => {
            let row = |estimate: &mdr_fit::FitEstimate| {
                let [file, status, name, unit] =
                    [file, answer.status.name(), &estimate.name, estimate.unit].map(str::to_owned);
                let [value, stderr, scaled] = [estimate.value, estimate.stderr, estimate.scaled_stderr].map(number);
                [file, status, name, value, stderr, scaled, unit]
            };
            answer.parameters.iter().map(row).collect()
        }
    }
}

/// χ², its probability, the reason of the status, and the warnings, as cells of a curve.
fn remarks(answer: &mdr::Result<Answer>) -> [String; 4] {
    match answer {
        Err(error) => ["", "", &error.to_string(), ""].map(str::to_owned),
        Ok(answer) => {
            let number = |value: Option<f64>| value.map(|value| format!("{value:.9e}")).unwrap_or_default();
            [number(answer.chi2), number(answer.chi2_p), answer.reason.clone(), answer.warnings.join("; ")]
        }
    }
}

/// The limits of a number, as cells of its row.
fn limits_of(answer: &mdr::Result<Answer>, name: &str) -> [String; 2] {
    let limit = answer.as_ref().ok().and_then(|answer| answer.limits.iter().find(|limit| limit.name == name));
    limit.map_or([None; 2], |limit| [limit.lower, limit.upper]).map(exact)
}

/// Adhesion force, force before the jump, and work of separation, as cells of a curve.
fn quantities_of(answer: &mdr::Result<Answer>) -> [String; 3] {
    ["adhesion_force", "pull_off_force", "separation_work"]
        .map(|name| exact(answer.as_ref().ok().and_then(|answer| answer.quantity(name)).map(|quantity| quantity.value)))
}

fn exact(value: Option<f64>) -> String {
    value.map(|value| format!("{value:.9e}")).unwrap_or_default()
}

fn for_reader(answer: &Answer) -> String {
    let mut parts = vec![answer.heading()];
    parts.push(estimates(answer));
    if !answer.intervals.is_empty() {
        let header = ["by profile likelihood", "level", "from", "to"];
        parts.push(text_table(&header, answer.interval_rows()));
    }
    if !answer.smoothing.is_empty() {
        let (header, rows) = answer.smoothing_table();
        parts.push(text_table(&header, rows));
    }
    if let Some(certified) = &answer.certified {
        let rows = certified.parameters.iter().map(|estimate| {
            let [value, stderr] = [&estimate.value, &estimate.scaled_stderr].map(ToString::to_string);
            [estimate.name.clone(), value, stderr, format!("± {:.0e}", estimate.unique_within)]
        });
        let header = ["certified", "estimate", "scaled by residuals", "unique within"];
        parts.push(text_table(&header, rows));
        parts.push(match certified.local_minimum {
            true => "Proved: a local minimum of the sum of squares, with these labels of the rows.".to_owned(),
            false => "Proved: a stationary point of the sum of squares, with these labels of the rows.".to_owned(),
        });
    }
    if !answer.invariants.is_empty() {
        let rows = answer.invariants.iter().map(|invariant| {
            [invariant.name.clone(), format!("{:.9e}", invariant.value), format!("{:.2e}", invariant.stderr)]
        });
        let header = ["what the data determine", "value, SI", "standard error"];
        parts.push(text_table(&header, rows));
    }
    if answer.status.has_estimates() && answer.parameters.len() > 1 {
        parts.push(correlations(answer));
    }
    if !answer.limits.is_empty() {
        parts.push(text_table(&["limits", "at least", "at most", "level", "unit"], answer.limit_rows()));
    }
    if !answer.budget.is_empty() {
        let (header, rows) = answer.budget_table();
        parts.push(text_table(&header, rows));
    }
    if !answer.quantities.is_empty() {
        parts.push(text_table(
            &["quantity (pulling counts positive)", "value", "standard error", "unit"],
            answer.quantity_rows(),
        ));
    }
    if answer.legs.len() > 1 {
        let header = ["leg", "rows", "in contact", "pinned", "mean square residual", "runs test, p"];
        parts.push(text_table(&header, answer.leg_rows()));
    }
    parts.extend(answer.left_out());
    parts.extend(answer.read.iter().map(|read| read.sentence()));
    parts.push(answer.quality());
    parts.push(answer.attempts());
    parts.extend(answer.events());
    parts.extend(answer.validity.iter().map(|validity| validity::text(validity, &NumberStyle::default())));
    parts.extend(answer.warnings.iter().map(|warning| format!("Warning: {warning}.")));
    parts.join("\n\n")
}

fn estimates(answer: &Answer) -> String {
    let mut table = table(&["number", "estimate", "standard error", "scaled by residuals", "unit"]);
    for estimate in &answer.parameters {
        let number = |value: Option<f64>, decimals: usize| match value {
            Some(value) => cell(format_args!("{value:.decimals$e}"), CellStyle::Good),
            None => cell("not determined", CellStyle::Bad),
        };
        table.add_row([
            cell(&estimate.name, CellStyle::Plain),
            number(estimate.value, 9),
            number(estimate.stderr, 2),
            number(estimate.scaled_stderr, 2),
            cell(estimate.unit, CellStyle::Plain),
        ]);
    }
    render_whole(&table)
}

fn correlations(answer: &Answer) -> String {
    let names: Vec<&str> = answer.parameters.iter().map(|estimate| estimate.name.as_str()).collect();
    let rows = names.iter().zip(&answer.correlation).map(|(name, row)| {
        std::iter::once((*name).to_owned()).chain(row.iter().map(|value| format!("{value:.3}"))).collect::<Vec<_>>()
    });
    text_table(&[&["correlation"], names.as_slice()].concat(), rows)
}
