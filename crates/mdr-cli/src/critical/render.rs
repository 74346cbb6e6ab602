//! The answer for a reader and for a spreadsheet.

use mdr_core::contact::Regime;

use super::answer::{Answer, Entry, Fold, State};
use crate::error::Result;
use crate::number::Number;
use crate::output::{Format, Output};
use crate::table::{Tone, cell, render, table};

const QUANTITIES: [(&str, &str); 3] =
    [("contact radius a", "m"), ("indentation depth d", "m"), ("normal force F", "N")];

/// Writes `answer` in the `format` asked for.
pub(crate) fn write(answer: &Answer, format: Format, out: &mut Output<impl std::io::Write>) -> Result<()> {
    match format {
        Format::Json => out.json(answer),
        Format::Csv => for_spreadsheet(answer, out),
        Format::Table => out.text(for_reader(answer)),
    }
}

fn for_reader(answer: &Answer) -> String {
    let mut table = table(&["quantity", "value", "unit"]);
    table.add_row([cell("kappa_n", Tone::Plain), cell(&answer.kappa, Tone::Good), cell("", Tone::Faint)]);
    let mut add = |name: &str, entry: &Entry, unit: &str| {
        let tone = match entry {
            Entry::Value(_) => Tone::Good,
            Entry::Beyond { .. } => Tone::Bad,
            Entry::Absent => Tone::Faint,
        };
        table.add_row([cell(name, Tone::Plain), cell(entry, tone), cell(unit, Tone::Faint)]);
    };
    if let Some(ratio) = &answer.threshold.ratio {
        add("threshold of C", &answer.threshold.threshold_c, "m^(1/2)");
        add("C / threshold", ratio, "");
    }
    match answer.folds.as_deref() {
        Some(folds) if folds.len() > 1 => {
            for (index, fold) in folds.iter().enumerate() {
                for ((name, unit), entry) in QUANTITIES.iter().zip(fold.state.entries()) {
                    add(&format!("{name}, fold {} ({})", index + 1, fold.kind.name()), entry, unit);
                }
            }
        }
        _ if answer.regime == Regime::ScaleFree && answer.state == State::absent() => {}
        _ => {
            for ((name, unit), entry) in QUANTITIES.iter().zip(answer.state.entries()) {
                add(name, entry, unit);
            }
        }
    }
    format!("{}\n\n{}\n\n{}", heading(answer), render(&table), explanation(answer))
}

/// The question in one line.
fn heading(answer: &Answer) -> String {
    let inputs = &answer.inputs;
    let bodies = match &inputs.bodies {
        Some(b) => format!(" from E1 = {} Pa, nu1 = {}, E2 = {} Pa, nu2 = {}", b.e1, b.nu1, b.e2, b.nu2),
        None => String::new(),
    };
    let control = match &inputs.stiffness {
        Some(stiffness) => format!("a machine of stiffness {stiffness} N/m"),
        None => format!("controlled {}", answer.control),
    };
    let promise = match answer.digits {
        Some(1) => "1 certified digit".to_owned(),
        Some(digits) => format!("{digits} certified digits"),
        None => "f64".to_owned(),
    };
    format!(
        "Profile f(r) = C r^n, n = {}, C = {}; E* = {} Pa{bodies}; w = {} J/m²; {control}; {promise}",
        inputs.n, inputs.c, inputs.e_star, inputs.work
    )
}

/// What happens there, in a sentence or two.
fn explanation(answer: &Answer) -> String {
    let held = match answer.control {
        "force" => "force",
        "machine" => "position d + F/k",
        _ => "indentation depth",
    };
    let folds = answer.folds.as_ref().map_or(1, Vec::len);
    match answer.regime {
        Regime::ScaleFree => scale_free(answer),
        Regime::PullOff if folds > 1 => format!(
            "Pull-off (n > 1/2), multistable with {folds} folds of the {held}: on unloading the one of the largest \
             radius is met first; beyond it the contact jumps to a smaller radius or breaks."
        ),
        Regime::PullOff => format!(
            "Pull-off (n > 1/2): when the {held} falls below that of this state, no equilibrium is left and the \
             contact breaks."
        ),
        Regime::CompleteContact => format!(
            "Complete contact (n < 1/2): when the {held} rises above that of this state, no equilibrium is left and \
             the contact spreads over the whole surface."
        ),
    }
}

/// n = 1/2: no length in the problem but that of a machine.
fn scale_free(answer: &Answer) -> String {
    match answer.control {
        "machine" => "Scale-free (n = 1/2) on a machine: below the threshold of C no contact is stable; from there to \
                      three times the threshold a contact is stable up to the radius of a fold, beyond which it \
                      spreads over the whole surface; above, every contact is stable."
            .to_owned(),
        held => format!(
            "Scale-free (n = 1/2): no radius is singled out. At zero {held} a contact of any radius shrinks to \
             nothing when C is above the threshold, and spreads over the whole surface when C is below."
        ),
    }
}

/// One row a critical state: one, or one a fold on a machine.
fn for_spreadsheet(answer: &Answer, out: &mut Output<impl std::io::Write>) -> Result<()> {
    let rows: Vec<_> = match answer.folds.as_deref() {
        Some(folds) if !folds.is_empty() => folds.iter().map(|fold| columns(answer, &fold.state, Some(fold))).collect(),
        _ => vec![columns(answer, &answer.state, None)],
    };
    let header = rows[0].each_ref().map(|(title, _)| *title);
    out.csv(&header, rows.into_iter().map(|row| row.map(|(_, value)| value)))
}

/// The titles and values of a row.
fn columns(answer: &Answer, state: &State, fold: Option<&Fold>) -> [(&'static str, String); 24] {
    let text = |number: Option<&Number>| number.map(Number::to_string).unwrap_or_default();
    let value = |entry: &Entry| match entry {
        Entry::Value(number) => number.to_string(),
        _ => String::new(),
    };
    let log10 = |entry: &Entry| entry.log10().map(|log10| log10.to_string()).unwrap_or_default();
    let inputs = &answer.inputs;
    let bodies = inputs.bodies.as_ref();
    [
        ("arithmetic", answer.arithmetic.to_owned()),
        ("digits", answer.digits.map(|digits| digits.to_string()).unwrap_or_default()),
        ("control", answer.control.to_owned()),
        ("regime", answer.regime.to_string()),
        ("n", inputs.n.to_string()),
        ("c", inputs.c.to_string()),
        ("e1", text(bodies.map(|b| &b.e1))),
        ("nu1", text(bodies.map(|b| &b.nu1))),
        ("e2", text(bodies.map(|b| &b.e2))),
        ("nu2", text(bodies.map(|b| &b.nu2))),
        ("e_star", inputs.e_star.to_string()),
        ("work", inputs.work.to_string()),
        ("stiffness", text(inputs.stiffness.as_ref())),
        ("kappa", answer.kappa.to_string()),
        ("status", fold.map_or(answer.status, |fold| fold.status).to_string()),
        ("contact_radius", value(&state.contact_radius)),
        ("indentation", value(&state.indentation)),
        ("force", value(&state.force)),
        ("log10_contact_radius", log10(&state.contact_radius)),
        ("log10_indentation", log10(&state.indentation)),
        ("log10_force", log10(&state.force)),
        ("kind", fold.map(|fold| fold.kind.name()).unwrap_or_default().to_owned()),
        ("threshold_c", value(&answer.threshold.threshold_c)),
        ("ratio", answer.threshold.ratio.as_ref().map(value).unwrap_or_default()),
    ]
}
