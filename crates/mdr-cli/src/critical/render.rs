//! The answer for a reader and for a spreadsheet.

use mdr::answer::{NumberStyle, title};
use mdr::critical::{CriticalAnswer, CriticalState, spreadsheet};
use mdr::prelude::{Arithmetic, ControlKind, Value};
use mdr_core::contact::Regime;

use crate::error::Result;
use crate::output::{Format, Output};
use crate::table::{Tone, cell, render, render_whole, table};
use crate::validity;

const QUANTITIES: [(&str, &str); 3] =
    [("contact radius a", "m"), ("indentation depth d", "m"), ("normal force F", "N")];

/// Writes `answer` in the `format` asked for; for a reader with its sibling under the other control.
pub(crate) fn write(
    answer: &CriticalAnswer,
    sibling: Option<&CriticalAnswer>,
    format: Format,
    style: &NumberStyle,
    out: &mut Output<impl std::io::Write>,
) -> Result<()> {
    match format {
        Format::Json => out.json(answer),
        Format::Csv => out.spreadsheet(&spreadsheet(std::slice::from_ref(answer))),
        Format::Table => {
            let sibling = sibling
                .and_then(|sibling| in_a_line(sibling, style))
                .map_or_else(String::new, |line| format!("\n{line}"));
            let validity = answer
                .validity
                .as_ref()
                .map_or_else(String::new, |validity| format!("\n\n{}", validity::text(validity, style)));
            out.text(format!("{}{sibling}{validity}", for_reader(answer, style)))
        }
    }
}

/// Writes several answers: a row or a line for each.
pub(crate) fn write_all(
    answers: &[CriticalAnswer],
    format: Format,
    style: &NumberStyle,
    out: &mut Output<impl std::io::Write>,
) -> Result<()> {
    match format {
        Format::Json => answers.iter().try_for_each(|answer| out.json(answer)),
        Format::Csv => out.spreadsheet(&spreadsheet(answers)),
        Format::Table => {
            let keys = ["n", "kappa", "contact_radius", "indentation", "force", "kind", "status"];
            let names = ["n", "kappa_n", "contact radius", "indentation", "force", "fold", "status"];
            let units = ["", "", "m", "m", "N", "", ""];
            let asked = answers.iter().any(|answer| answer.validity.is_some());
            let added: &[&str] = if asked { &["tabor", "regime", "maugis_dugdale_pull_off"] } else { &[] };
            let titles = names.into_iter().zip(units).chain(added.iter().map(|key| title(key, None)));
            let mut table = table(&titles.map(|(name, unit)| style.titled(name, unit)).collect::<Vec<_>>());
            for answer in answers {
                let validity = answer.validity.as_ref().map(|validity| validity.table()).unwrap_or_default();
                let added = added.iter().map(|key| validity::number(&validity, key, style));
                let added: Vec<String> = added.collect();
                for row in answer.rows() {
                    let own = keys.iter().zip(units).enumerate().map(|(column, (key, unit))| {
                        let text = row.get(key).unwrap_or_default();
                        if (1..=4).contains(&column) { style.number(text, unit) } else { text.to_owned() }
                    });
                    table.add_row(own.chain(added.iter().cloned()).map(|text| cell(text, Tone::Plain)));
                }
            }
            out.text(render_whole(&table))
        }
    }
}

/// The sibling of an answer: what the other control would make of the same contact.
fn in_a_line(sibling: &CriticalAnswer, style: &NumberStyle) -> Option<String> {
    let state = sibling.state.as_ref()?;
    let control = match sibling.law.control.kind() {
        ControlKind::Force => "Under a dead load",
        _ => "At fixed grips",
    };
    let jkr = sibling.law.control.kind() == ControlKind::Force && sibling.law.n.small_integer() == Some(2);
    let closed = if jkr { " = -3/2 pi w R" } else { "" };
    let of = |value: &Value, unit| format!("{} {}", style.value(value, unit), style.unit(unit));
    let [a, d, force] = [of(&state.contact_radius, "m"), of(&state.indentation, "m"), of(&state.force, "N")];
    Some(format!("{control}: F = {force}{closed} at d = {d}, a = {a}."))
}

fn for_reader(answer: &CriticalAnswer, style: &NumberStyle) -> String {
    let mut table = table(&["quantity", "value", "unit"]);
    let kappa = style.number(&answer.kappa.to_string(), "");
    table.add_row([cell("kappa_n", Tone::Plain), cell(kappa, Tone::Good), cell("", Tone::Faint)]);
    let mut add = |name: &str, value: Option<&Value>, unit: &str| {
        let tone = match value {
            Some(Value::Unknown { .. }) => Tone::Bad,
            Some(_) => Tone::Good,
            None => Tone::Faint,
        };
        let text = value.map_or("none".to_owned(), |value| style.value(value, unit));
        table.add_row([cell(name, Tone::Plain), cell(text, tone), cell(style.unit(unit), Tone::Faint)]);
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
    format!("{}\n\n{}\n\n{}", heading(answer), render(&table), answer.explanation())
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
