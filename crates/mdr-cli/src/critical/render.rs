//! The answer for a reader and for a spreadsheet.

use mdr::answer::Reader;
use mdr::critical::{CriticalAnswer, CriticalFold, CriticalState};
use mdr::prelude::{Arithmetic, ControlKind, Value};
use mdr_core::contact::Regime;

use crate::error::Result;
use crate::output::{Format, Output};
use crate::table::{Tone, cell, render, render_whole, table};

const QUANTITIES: [(&str, &str); 3] =
    [("contact radius a", "m"), ("indentation depth d", "m"), ("normal force F", "N")];

/// Writes `answer` in the `format` asked for; for a reader with its sibling under the other control.
pub(crate) fn write(
    answer: &CriticalAnswer,
    sibling: Option<&CriticalAnswer>,
    format: Format,
    reader: &Reader,
    out: &mut Output<impl std::io::Write>,
) -> Result<()> {
    match format {
        Format::Json => out.json(answer),
        Format::Csv => for_spreadsheet(std::slice::from_ref(answer), out),
        Format::Table => {
            let sibling = sibling
                .and_then(|sibling| in_a_line(sibling, reader))
                .map_or_else(String::new, |line| format!("\n{line}"));
            out.text(format!("{}{sibling}", for_reader(answer, reader)))
        }
    }
}

/// Writes several answers: a row or a line for each.
pub(crate) fn write_all(
    answers: &[CriticalAnswer],
    format: Format,
    reader: &Reader,
    out: &mut Output<impl std::io::Write>,
) -> Result<()> {
    match format {
        Format::Json => answers.iter().try_for_each(|answer| out.json(answer)),
        Format::Csv => for_spreadsheet(answers, out),
        Format::Table => {
            let keys = ["n", "kappa", "contact_radius", "indentation", "force", "kind", "status"];
            let names = ["n", "kappa_n", "contact radius", "indentation", "force", "fold", "status"];
            let units = ["", "", "m", "m", "N", "", ""];
            let titles: Vec<_> = names.iter().zip(units).map(|(name, unit)| reader.titled(name, unit)).collect();
            let mut table = table(&titles);
            for row in answers.iter().flat_map(rows) {
                let value = |key: &&str| row.iter().find(|(title, _)| title == key).map_or("", |(_, value)| value);
                let columns = keys.iter().zip(units).enumerate();
                table.add_row(columns.map(|(column, (key, unit))| match column {
                    1..=4 => cell(reader.number(value(key), unit), Tone::Plain),
                    _ => cell(value(key), Tone::Plain),
                }));
            }
            out.text(render_whole(&table))
        }
    }
}

/// The sibling of an answer: what the other control would make of the same contact.
fn in_a_line(sibling: &CriticalAnswer, reader: &Reader) -> Option<String> {
    let state = sibling.state.as_ref()?;
    let control = match sibling.law.control.kind() {
        ControlKind::Force => "Under a dead load",
        _ => "At fixed grips",
    };
    let jkr = sibling.law.control.kind() == ControlKind::Force && sibling.law.n.small_integer() == Some(2);
    let closed = if jkr { " = -3/2 pi w R" } else { "" };
    let of = |value: &Value, unit| format!("{} {}", reader.value(value, unit), reader.unit(unit));
    let [a, d, force] = [of(&state.contact_radius, "m"), of(&state.indentation, "m"), of(&state.force, "N")];
    Some(format!("{control}: F = {force}{closed} at d = {d}, a = {a}."))
}

fn for_reader(answer: &CriticalAnswer, reader: &Reader) -> String {
    let mut table = table(&["quantity", "value", "unit"]);
    let kappa = reader.number(&answer.kappa.to_string(), "");
    table.add_row([cell("kappa_n", Tone::Plain), cell(kappa, Tone::Good), cell("", Tone::Faint)]);
    let mut add = |name: &str, value: Option<&Value>, unit: &str| {
        let tone = match value {
            Some(Value::Unknown { .. }) => Tone::Bad,
            Some(_) => Tone::Good,
            None => Tone::Faint,
        };
        let text = value.map_or("none".to_owned(), |value| reader.value(value, unit));
        table.add_row([cell(name, Tone::Plain), cell(text, tone), cell(reader.unit(unit), Tone::Faint)]);
    };
    if let Some(threshold) = &answer.threshold {
        add("threshold of C", Some(&threshold.c), "m^(1/2)");
        add("C / threshold", Some(&threshold.ratio), "");
    }
    match answer.folds.as_deref() {
        Some(folds) if folds.len() > 1 => {
            for (index, fold) in folds.iter().enumerate() {
                for ((name, unit), value) in QUANTITIES.iter().zip(fold.state.values()) {
                    add(&format!("{name}, fold {} ({})", index + 1, fold.kind.name()), Some(value), unit);
                }
            }
        }
        _ if answer.regime == Regime::ScaleFree && answer.state.is_none() => {}
        _ => {
            for ((name, unit), value) in QUANTITIES.iter().zip(values(answer.state.as_ref())) {
                add(name, value, unit);
            }
        }
    }
    format!("{}\n\n{}\n\n{}", heading(answer), render(&table), explanation(answer))
}

/// The quantities of a state, if there is one.
fn values(state: Option<&CriticalState>) -> [Option<&Value>; 3] {
    state.map_or([None; 3], |state| state.values().map(Some))
}

/// The question in one line.
fn heading(answer: &CriticalAnswer) -> String {
    let inputs = &answer.inputs;
    let bodies = match &inputs.bodies {
        Some([[e1, nu1], [e2, nu2]]) => {
            format!(" from E1 = {e1} Pa, nu1 = {nu1}, E2 = {e2} Pa, nu2 = {nu2}")
        }
        None => String::new(),
    };
    let control = match &inputs.stiffness {
        Some(stiffness) => format!("a machine of stiffness {stiffness} N/m"),
        None => format!("controlled {}", answer.law.control.kind().name()),
    };
    let promise = match answer.arithmetic {
        Arithmetic::Certified { digits: 1 } => "1 certified digit".to_owned(),
        Arithmetic::Certified { digits } => format!("{digits} certified digits"),
        Arithmetic::Double => "f64".to_owned(),
    };
    format!(
        "Profile f(r) = C r^n, n = {}, C = {}; E* = {} Pa{bodies}; w = {} J/m²; {control}; {promise}",
        inputs.n, inputs.c, inputs.e_star, inputs.work
    )
}

/// What happens there, in a sentence or two.
fn explanation(answer: &CriticalAnswer) -> String {
    let held = match answer.law.control.kind() {
        ControlKind::Force => "force",
        ControlKind::Machine => "position d + F/k",
        ControlKind::Indentation => "indentation depth",
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
fn scale_free(answer: &CriticalAnswer) -> String {
    match answer.law.control.kind() {
        ControlKind::Machine => {
            "Scale-free (n = 1/2) on a machine: below the threshold of C no contact is stable; from there to \
                      three times the threshold a contact is stable up to the radius of a fold, beyond which it \
                      spreads over the whole surface; above, every contact is stable."
                .to_owned()
        }
        held => format!(
            "Scale-free (n = 1/2): no radius is singled out. At zero {} a contact of any radius shrinks to \
             nothing when C is above the threshold, and spreads over the whole surface when C is below.",
            held.name()
        ),
    }
}

/// One row a critical state: one, or one a fold on a machine.
pub(crate) fn rows(answer: &CriticalAnswer) -> Vec<Columns> {
    match answer.folds.as_deref() {
        Some(folds) if !folds.is_empty() => {
            folds.iter().map(|fold| columns(answer, Some(&fold.state), Some(fold))).collect()
        }
        _ => vec![columns(answer, answer.state.as_ref(), None)],
    }
}

fn for_spreadsheet(answers: &[CriticalAnswer], out: &mut Output<impl std::io::Write>) -> Result<()> {
    let header = columns_of_none().map(|(title, _)| title);
    let rows = answers.iter().flat_map(rows);
    out.csv(&header, rows.map(|row| row.map(|(_, value)| value)))
}

/// Titles and values.
pub(crate) type Columns = [(&'static str, String); 24];

/// The titles without values.
pub(crate) fn columns_of_none() -> Columns {
    [
        "arithmetic",
        "digits",
        "control",
        "regime",
        "n",
        "c",
        "e1",
        "nu1",
        "e2",
        "nu2",
        "e_star",
        "work",
        "stiffness",
        "kappa",
        "status",
        "contact_radius",
        "indentation",
        "force",
        "log10_contact_radius",
        "log10_indentation",
        "log10_force",
        "kind",
        "threshold_c",
        "ratio",
    ]
    .map(|title| (title, String::new()))
}

/// The titles and values of a row.
fn columns(answer: &CriticalAnswer, state: Option<&CriticalState>, fold: Option<&CriticalFold>) -> Columns {
    let text = |value: Option<&Value>| match value {
        Some(Value::Unknown { .. }) | None => String::new(),
        Some(value) => value.to_string(),
    };
    let log10 = |value: Option<&Value>| value.and_then(Value::log10).map(|log10| log10.to_string()).unwrap_or_default();
    let inputs = &answer.inputs;
    let body = |body: usize, constant: usize| text(inputs.bodies.as_ref().map(|bodies| &bodies[body][constant]));
    let [radius, indentation, force] = values(state);
    let threshold = answer.threshold.as_ref();
    let values = [
        answer.arithmetic.promise().name().to_owned(),
        answer.arithmetic.digits().map_or_else(String::new, |digits| digits.to_string()),
        answer.law.control.kind().name().to_owned(),
        answer.regime.to_string(),
        inputs.n.to_string(),
        inputs.c.to_string(),
        body(0, 0),
        body(0, 1),
        body(1, 0),
        body(1, 1),
        inputs.e_star.to_string(),
        inputs.work.to_string(),
        text(inputs.stiffness.as_ref()),
        answer.kappa.to_string(),
        fold.map_or(answer.status, |fold| fold.state.status()).to_string(),
        text(radius),
        text(indentation),
        text(force),
        log10(radius),
        log10(indentation),
        log10(force),
        fold.map(|fold| fold.kind.name()).unwrap_or_default().to_owned(),
        text(threshold.map(|threshold| &threshold.c)),
        text(threshold.map(|threshold| &threshold.ratio)),
    ];
    let mut row = columns_of_none();
    row.iter_mut().zip(values).for_each(|((_, slot), value)| *slot = value);
    row
}
