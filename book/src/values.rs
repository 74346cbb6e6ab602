//! Certified reference values: those of an entry, and all of them by family.

use std::collections::BTreeMap;

use maud::{Markup, html};
use mdr_reference::{Record, Status, record, records};
use mdr_symbolic::derivations::Entry;

use crate::entry::permalink;
use crate::error::{Error, Result};

/// The families, in the order of the theory: the formula of the records, and its title.
pub(crate) const FAMILIES: [(&str, &str); 28] = [
    ("kappa", "The factor κ of a power law"),
    ("critical", "Critical states of power laws"),
    ("machine-folds", "Folds of power laws on a machine"),
    ("threshold", "Thresholds of C at n = 1/2"),
    ("equilibrium", "Equilibria of power laws"),
    ("equilibrium-share", "Equilibria of power laws, near the fold"),
    ("work-lost-at-pull-off", "Energy lost at pull-off"),
    ("work-lost-at-jump-in", "Energy lost at jump-in"),
    ("barrier-to-complete-contact", "The barrier to complete contact"),
    ("transform", "Transforms of profiles"),
    ("folds", "Folds of other profiles"),
    ("equilibria", "Equilibria of other profiles"),
    ("landing", "Where a jump ends"),
    ("flat-punch-pull-off", "Pull-off of a flat punch"),
    ("graded-critical", "Critical states on graded half-spaces"),
    ("graded-threshold", "Thresholds of C on graded half-spaces"),
    ("line-critical", "Critical states of line contacts"),
    ("line-threshold", "The threshold of C of line contacts"),
    ("wave-fold", "Folds of wavy surfaces"),
    ("wave-threshold-load", "Wavy surfaces: where folds under a load merge"),
    ("wave-threshold-touch", "Wavy surfaces: where touching completes the contact"),
    ("wave-threshold-energy", "Wavy surfaces: where complete contact has less energy"),
    ("wave-threshold-compliance", "Wavy surfaces: the compliance up to which folds stay"),
    ("loop-state", "Two works of adhesion: states on the way back"),
    ("loop-pull-off", "Two works of adhesion: where a contact comes off"),
    ("loop-work", "Two works of adhesion: the work of a loop"),
    ("loop-preload", "Two works of adhesion: the load that full pull-off needs"),
    (FIT, "Fits of measured curves"),
];

/// Records of fits, which have a page for each data set.
const FIT: &str = "fit";

/// Records of the states, which stand with the equilibria.
const STATE: &str = "state";

/// The page of a record.
fn page(record: &Record) -> String {
    let family = if record.formula == STATE { "equilibria" } else { record.formula.as_str() };
    format!("values-{family}.html")
}

/// The records of a family, in the order of the release.
fn members(family: &str) -> Vec<&'static Record> {
    let of = |record: &&Record| record.formula == family || (family == "equilibria" && record.formula == STATE);
    records().iter().filter(of).collect()
}

/// The question of a record, but for its quantity.
fn question(record: &Record) -> String {
    let inputs: Vec<_> = record.inputs.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    let control = record.control.as_deref().map_or(String::new(), |control| format!("; controlled {control}"));
    let profile = if record.profile == "power" { String::new() } else { format!("{}: ", record.profile) };
    format!("{profile}{}{control}", inputs.join(", "))
}

/// The quantity by its letter, where it has one.
fn quantity(record: &Record) -> String {
    let name = record.quantity.replace('_', " ");
    let letter = match record.quantity.as_str() {
        "contact_radius" => "a",
        "indentation" => "d",
        "force" => "F",
        "kappa" => "κ",
        "slope" => "g′",
        "integral" => "∫g",
        "g" => return "g".to_owned(),
        _ => return name,
    };
    format!("{letter}, {name}")
}

/// The value, or why there is none.
fn value(record: &Record) -> Markup {
    let unit = if record.unit == "1" { String::new() } else { record.unit.replace("^2", "²") };
    html! {
        @match &record.value {
            Some(value) => { span.digits { (minus(&value.mid)) } @if !unit.is_empty() { "\u{a0}" span.unit { (unit) } } @if record.status != Status::Ok { " (" (record.status) ")" } }
            None => { (record.status) }
        }
    }
}

/// A number with a minus sign in place of a hyphen, but for its exponent.
fn minus(number: &str) -> String {
    number.strip_prefix('-').map_or_else(|| number.to_owned(), |rest| format!("−{rest}"))
}

/// The numbers on the page of an entry: those that its text names, and how many others rest on it.
pub(crate) fn of_entry(entry: &Entry, ids: &[String]) -> Result<Markup> {
    let found = |id: &String| record(id).ok_or_else(|| Error::page(entry.id, format!("there is no record {id:?}")));
    let shown = ids.iter().map(found).collect::<Result<Vec<_>>>()?;
    let rest: Vec<_> = records().iter().filter(|record| record.proof.iter().any(|id| id == entry.id)).collect();
    let mut pages: BTreeMap<String, usize> = BTreeMap::new();
    for record in &rest {
        *pages.entry(page(record)).or_default() += 1;
    }
    Ok(html! {
        @if shown.is_empty() && rest.is_empty() { p { "No certified record rests on this entry by itself; it enters those of the equations that follow." } }
        @if !shown.is_empty() {
            p.hint { "Every digit is proved by enclosures and confirmed by quadrature of the heights, which shares the definitions of d and F with them and no closed form." }
            div.table tabindex="0" role="group" aria-label="Certified values" { table.values {
                thead { tr { th { "question" } th { "quantity" } th { "value" } } }
                tbody { @for record in &shown { tr {
                    td { (question(record)) }
                    td { (quantity(record)) }
                    td { a href={ (page(record)) "#" (record.id) } { (value(record)) } }
                } } }
            } }
            @if let Some(first) = shown.first() { p.ask { "All that is known of a value, on a terminal: " code { "mdr reference --filter id=" (first.id) " --format json" } } }
        }
        @if !rest.is_empty() {
            p { (rest.len()) " certified records rest on this entry: "
                @for (i, (page, count)) in pages.iter().enumerate() { @if i > 0 { ", " } a href=(page) { (count) " in " (family(page)) } } "." }
        }
    })
}

/// The title of a family, from its page, as it stands in a sentence.
fn family(page: &str) -> String {
    let name = page.trim_start_matches("values-").trim_end_matches(".html");
    let title = FAMILIES.iter().find(|(family, _)| *family == name).map_or(name, |(_, title)| *title);
    let mut letters = title.chars();
    letters.next().map_or(String::new(), |first| first.to_lowercase().chain(letters).collect())
}

/// The list of families.
pub(crate) fn index() -> Markup {
    html! {
        p.lede { "Numbers of adhesive contact mechanics of which every digit is proved, from easy to hard: what the Statistical Reference Datasets of NIST are to statistics. "
            a href="reference.html" { "What a record holds, and how to judge a program with it." } }
        p { (records().len()) " records in " (FAMILIES.len()) " families." }
        div.table tabindex="0" role="group" aria-label="Families" { table { thead { tr { th { "family" } th { "records" } th { "lower" } th { "average" } th { "higher" } } }
            tbody { @for (family, title) in FAMILIES {
                @let members = members(family);
                tr { td { a href={ "values-" (family) ".html" } { (title) } } td { (members.len()) }
                    @for difficulty in ["lower", "average", "higher"] { td { (members.iter().filter(|record| record.difficulty.name() == difficulty).count()) } } }
            } }
        } }
        p { "The program exports them for any language: " code { "mdr reference --export records.jsonl" } "." }
    }
}

/// The page of a family: the questions in order, each with its quantities.
pub(crate) fn family_page(name: &str) -> Markup {
    let mut cases: Vec<(String, Vec<&Record>)> = Vec::new();
    for record in members(name) {
        // What a function did worst on is a question of its own, whatever it is called.
        let worst = record.flags.iter().any(|flag| flag == "worst");
        let shared = record.id.rsplit_once('/').filter(|_| !worst).map(|(case, _)| case);
        let case = shared.unwrap_or(&record.id).to_owned();
        match cases.last_mut() {
            Some((last, found)) if *last == case => found.push(record),
            _ => cases.push((case, vec![record])),
        }
    }
    html! {
        p { (members(name).len()) " certified values. The condition is the factor by which a relative error of the inputs grows at least; f64 is the nearest double, hexadecimal. " a href="values.html" { "All families" } }
        p { input type="search" data-filter="values" placeholder="Filter: n = 2, force, higher …" aria-label="Filter the questions"; }
        div #values { @for (case, found) in &cases { section.case {
            h2 { (case) @if let Some(first) = found.first() { (permalink(&first.id, "this question")) } }
            @if let Some(first) = found.first() { p.hint { (question(first)) @if name == FIT { ". " a href={ (case.replace('/', "-")) ".html" } { "The data" } } } }
            (table(found))
        } } }
    }
}

/// Values, and in one fold their doubles, conditions and difficulties.
pub(crate) fn table(found: &[&Record]) -> Markup {
    html! {
        div.table tabindex="0" role="group" aria-label="Values" { table.values {
            thead { tr { th { "quantity" } th { "value" } } }
            tbody { @for record in found { tr id=(record.id) data-release=(record.release) {
                td { (quantity(record)) } td { (value(record)) }
            } } }
        } }
        details.more { summary { "f64, condition and difficulty" }
            div.table tabindex="0" role="group" aria-label="Doubles and conditions" { table.values {
                thead { tr { th { "quantity" } th { "f64" } th { "condition" } th { "difficulty" } } }
                tbody { @for record in found { tr {
                    td { (quantity(record)) }
                    td { @if let Some(double) = record.hexadecimal() { code { (double) } } }
                    td { (format!("{:.3}", record.total_condition())) } td { (record.difficulty.name()) }
                } } }
            } }
        }
    }
}
