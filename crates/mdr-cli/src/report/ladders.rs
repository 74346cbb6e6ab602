//! The stability ladders: a picture and the data of each family of directions, and one table.

use std::collections::BTreeSet;

use mdr_crosscheck::contest::Effort;
use mdr_crosscheck::ladders::{Family, Found, Ladder, OPEN, Rung};

use serde::{Deserialize, Serialize};

use super::ladder_panels;
use super::page::{capitalised, details, in_cell, made, pictures};
use super::store::Section;
use crate::error::{Failure, Result};
use crate::picture;

/// The name by which `--only` asks for them, and what they are about.
pub(super) const NAME: &str = "ladders";
pub(super) const CLAIM: &str = "how errors of double precision grow while questions become hard";

/// What is kept of all ladders, for the overview.
#[derive(Serialize, Deserialize)]
pub(super) struct Summary {
    ladders: usize,
    functions: usize,
    /// Ladders that are not accepted.
    open: usize,
    /// The names of the families.
    pub(super) families: Vec<String>,
}

impl Summary {
    pub(super) fn of(all: &[Ladder]) -> Self {
        let functions: BTreeSet<&str> = all.iter().map(|ladder| ladder.function.as_str()).collect();
        Summary {
            ladders: all.len(),
            functions: functions.len(),
            open: all.iter().filter(|ladder| !ladder.accepted()).count(),
            families: families(all).map(|(family, _)| family.name().to_owned()).collect(),
        }
    }

    /// For the overview.
    pub(super) fn told(&self) -> String {
        let Summary { ladders, functions, open, .. } = self;
        format!(
            "\n{ladders} ladders of {functions} functions; on {open} of them more than one digit is lost beyond what the \
             question costs, or something is not said.\n"
        )
    }
}

/// The families that have ladders, with those.
pub(super) fn families(ladders: &[Ladder]) -> impl Iterator<Item = (Family, Vec<&Ladder>)> {
    let of = |family| ladders.iter().filter(|ladder| ladder.family == family).collect::<Vec<_>>();
    Family::ALL.into_iter().map(move |family| (family, of(family))).filter(|(_, of_family)| !of_family.is_empty())
}

/// The name of a family's files.
pub(super) fn id(family: Family) -> String {
    format!("{NAME}-{}", family.name())
}

/// The names and the contents of all files; none without ladders.
pub(super) fn files(ladders: &[Ladder]) -> Result<Vec<(String, Vec<u8>)>> {
    let mut files = Vec::new();
    for (family, of_family) in families(ladders) {
        let svg = picture::svg(&ladder_panels::picture(family, &of_family))?;
        files.push((format!("{}.svg", id(family)), svg.into_bytes()));
        files.push((format!("{}.csv", id(family)), data(ladders, family)?));
    }
    if !ladders.is_empty() {
        let described = ladders.iter().enumerate().map(|(number, ladder)| description(number, ladder));
        files.push((format!("{NAME}.csv"), csv(&LADDERS, described)?));
    }
    Ok(files)
}

/// Data of a family that would be longer are thinned.
const MOST_BYTES: usize = 290_000;

/// All rungs of a family, or every second, every third, and so on.
fn data(ladders: &[Ladder], family: Family) -> Result<Vec<u8>> {
    let of_family = || ladders.iter().enumerate().filter(|(_, ladder)| ladder.family == family);
    let longest = of_family().map(|(_, ladder)| ladder.rungs.len()).max().unwrap_or_default();
    let mut step = 1;
    loop {
        let rungs = of_family().flat_map(|(number, ladder)| kept(ladder, step).map(move |rung| row(number, rung)));
        let data = csv(&RUNGS, rungs)?;
        if data.len() <= MOST_BYTES || step >= longest {
            return Ok(data);
        }
        step += 1;
    }
}

/// Every so many rungs, the last, the worst, and all that are not accepted.
pub(super) fn kept(ladder: &Ladder, step: usize) -> impl Iterator<Item = &Rung> {
    let (last, worst) = (ladder.rungs.len().saturating_sub(1), ladder.worst());
    let special = move |rung: &Rung| !rung.accepted() || worst.is_some_and(|worst| std::ptr::eq(worst, rung));
    let numbered = ladder.rungs.iter().enumerate();
    numbered.filter(move |(index, rung)| index % step == 0 || *index == last || special(rung)).map(|(_, rung)| rung)
}

const RUNGS: [&str; 8] =
    ["ladder", "parameter", "inputs", "outcome", "ulp", "excess_loss", "condition", "textbook_ulp"];

const LADDERS: [&str; 8] =
    ["ladder", "family", "function", "direction", "parameter", "inputs", "textbook_formula", "accepted"];

fn row(number: usize, rung: &Rung) -> [String; 8] {
    let inputs: Vec<_> = rung.inputs.iter().map(|x| format!("{x:e}")).collect();
    let outcome = match &rung.found {
        Found::Number { .. } => "number".to_owned(),
        Found::Beyond { .. } => "out of range".to_owned(),
        Found::Flushed => "rounded to 0".to_owned(),
        Found::Refused => "no such number".to_owned(),
        Found::Declined(what) => format!("declined: {what}"),
        Found::Wrong(what) => format!("wrong: {what}"),
    };
    // An error of 0 has lost −∞ digits.
    let told =
        |x: Option<f64>| x.map_or(String::new(), |x| if x.is_finite() { format!("{x:.2e}") } else { x.to_string() });
    [
        number.to_string(),
        format!("{:e}", rung.parameter),
        inputs.join(" "),
        outcome,
        told(ulp(rung)),
        told(rung.excess()),
        told(rung.condition),
        told(rung.naive_ulp),
    ]
}

fn description(number: usize, ladder: &Ladder) -> [String; 8] {
    [
        number.to_string(),
        ladder.family.name().to_owned(),
        ladder.function.clone(),
        ladder.toward.clone(),
        ladder.axis.clone(),
        ladder.inputs.join(" "),
        ladder.naive.clone().unwrap_or_default(),
        ladder.accepted().to_string(),
    ]
}

fn csv(header: &[&str; 8], rows: impl Iterator<Item = [String; 8]>) -> Result<Vec<u8>> {
    let failed = |error: csv::Error| Failure::file("csv", std::io::Error::from(error));
    let mut csv = csv::Writer::from_writer(Vec::new());
    csv.write_record(header).map_err(failed)?;
    for row in rows {
        csv.write_record(row).map_err(failed)?;
    }
    csv.into_inner().map_err(|error| Failure::file("csv", error.into_error()))
}

/// The error of an answer that is a number.
pub(super) fn ulp(rung: &Rung) -> Option<f64> {
    match rung.found {
        Found::Number { ulp, .. } => Some(ulp),
        _ => None,
    }
}

/// The excess loss of the worst rung, infinite where it is no number and should be one.
pub(super) fn loss(ladder: &Ladder) -> f64 {
    ladder.worst().map_or(f64::NEG_INFINITY, |rung| match rung.excess() {
        Some(excess) => excess,
        None if rung.accepted() => f64::NEG_INFINITY,
        None => f64::INFINITY,
    })
}

const HEAD: &str = "
Every function of double precision is led, step by step, towards where it is in danger. The error of its answer, in units in
the last place, stands beside what the question costs, and beside the error of the formula as textbooks write it, in the same
arithmetic. The truth is an enclosure of the exact result for the doubles given; the condition is Σ|xᵢ ∂f/∂xᵢ|/|f| over the
inputs. The excess loss log₁₀(error/(u·max(1, condition))), u = 2⁻⁵³, counts the digits that an algorithm loses beyond what
any must; one is accepted.

Solid: shipped. Dashed, open marks: textbooks. Thin: max(1, condition) ulp, the attainable error u·max(1, condition) or up
to twice that. Crosses at the upper edge: wrong, declined, or beyond 10²⁰ ulp; what is below 10⁻² ulp is drawn there. Each
picture shows the four functions of its family that lose most and the two whose textbook formulas do. The data have all of
them, numbered as in [the list of ladders](ladders.csv); where a family has thousands of rungs, its file has every so many,
the worst and what is not accepted, and so have pictures of long ladders.
";

const FEW: &str = "\nThis report has few rungs of each ladder; one without `--quick` has all, and may find worse.\n";

/// The page.
pub(super) fn page(section: &Section, ladders: &[Ladder], effort: Effort) -> String {
    let mut text = format!("# {NAME}\n\n{}. [All tasks](README.md)\n", capitalised(CLAIM));
    text.push_str(&pictures(section));
    text.push_str(HEAD);
    if effort == Effort::Quick {
        text.push_str(FEW);
    }
    for (family, of_family) in families(ladders) {
        let (id, title, count) = (id(family), family.title(), of_family.len());
        text.push_str(&format!("\n## As {title}\n\n![As {title}]({id}.svg)\n\n{count} ladders. [Data]({id}.csv)\n"));
    }
    text.push_str(WORST);
    text.push_str(&details("All functions", &table(ladders)));
    text + &made(section)
}

const WORST: &str = "
## The worst of each function

The ladder of the largest excess loss, and every other that is not accepted. Worst: where the excess loss is largest.
";

const TABLE: &str = "\
| function | direction | worst, ulp | condition there | excess loss | textbooks, worst, ulp | |
|---|---|---|---|---|---|---|
";

/// A row a function, and one for each further ladder that is not accepted; worst first.
fn table(ladders: &[Ladder]) -> String {
    let mut by_loss: Vec<&Ladder> = ladders.iter().collect();
    by_loss.sort_by(|a, b| loss(b).total_cmp(&loss(a)));
    let mut seen: Vec<&str> = Vec::new();
    let mut text = TABLE.to_owned();
    for ladder in by_loss {
        let known = seen.contains(&ladder.function.as_str());
        if known && ladder.accepted() {
            continue;
        }
        seen.push(&ladder.function);
        text.push_str(&line(ladder));
    }
    text
}

/// A ladder by its worst rung.
fn line(ladder: &Ladder) -> String {
    let rung = ladder.worst();
    let size = |x: f64| match x {
        x if !x.is_finite() => "no number".to_owned(),
        x if x < 1e4 => format!("{x:.2}"),
        x => format!("{x:.1e}"),
    };
    let told = |x: Option<f64>| x.map_or_else(|| "—".to_owned(), size);
    let excess = match rung.and_then(Rung::excess) {
        Some(excess) if excess.is_finite() => format!("{excess:.1}"),
        Some(_) => "no error".to_owned(),
        None => "—".to_owned(),
    };
    format!(
        "| `{}` | {} | {} | {} | {excess} | {} | {} |\n",
        in_cell(&ladder.function),
        in_cell(&ladder.toward),
        told(rung.and_then(ulp)),
        told(rung.and_then(|rung| rung.condition)),
        told(ladder.worst_naive()),
        in_cell(&verdict(ladder))
    )
}

/// Nothing of what is accepted.
fn verdict(ladder: &Ladder) -> String {
    if ladder.accepted() {
        return String::new();
    }
    match OPEN.iter().find(|open| open.is(ladder)) {
        Some(open) => format!("open: {}", open.why),
        None => "open, not yet explained".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use std::sync::LazyLock;

    use mdr_crosscheck::ladders;

    use super::super::store;
    use super::*;

    static CLIMBED: LazyLock<Vec<Ladder>> = LazyLock::new(|| ladders::ladders(Effort::Quick));

    #[test]
    fn pictures_are_legible_and_data_short() {
        for (family, of_family) in families(&CLIMBED) {
            let picture = ladder_panels::picture(family, &of_family);
            assert_eq!(picture::crowded(&picture), [""; 0], "{family:?}");
            // What is longer leaves the sheet.
            for (_, text) in picture.panels.iter().flat_map(|panel| &panel.legend) {
                assert!(text.chars().count() <= 50, "{family:?}: {text}");
            }
        }
        let files = files(&CLIMBED).unwrap();
        assert_eq!(files.len(), 2 * Family::ALL.len() + 1);
        for (name, bytes) in &files {
            let text = str::from_utf8(bytes).unwrap();
            if name.ends_with(".svg") {
                assert!(text.len() < 100_000, "{name}: {} bytes", text.len());
                roxmltree::Document::parse(text).unwrap();
            } else {
                assert!(text.len() < 300_000, "{name}: {} bytes", text.len());
            }
        }
    }

    /// Every rung is in the data, by the number of its ladder in the list.
    #[test]
    fn the_data_are_complete() {
        let files = files(&CLIMBED).unwrap();
        let rows = |name: &str| -> Vec<Vec<String>> {
            let (_, bytes) = files.iter().find(|(file, _)| file == name).unwrap();
            let records = csv::Reader::from_reader(&bytes[..]).into_records();
            records.map(|row| row.unwrap().iter().map(str::to_owned).collect()).collect()
        };
        let list = rows("ladders.csv");
        assert_eq!(list.len(), CLIMBED.len());
        let mut found = vec![0; list.len()];
        for (family, _) in families(&CLIMBED) {
            for row in rows(&format!("{}.csv", id(family))) {
                let number: usize = row[0].parse().unwrap();
                assert_eq!(list[number][1], family.name());
                assert_eq!(list[number][5].split(' ').count(), row[2].split(' ').count(), "{row:?}");
                found[number] += 1;
            }
        }
        let wanted: Vec<_> = CLIMBED.iter().map(|ladder| ladder.rungs.len()).collect();
        assert_eq!(found, wanted);
    }

    #[test]
    fn what_is_open_is_called_open() {
        let section = Section { ladders: Some(Summary::of(&CLIMBED)), ..store::tests::section(NAME) };
        let page = page(&section, &CLIMBED, Effort::Quick);
        let rows: Vec<_> = page.lines().filter(|line| line.starts_with("| `")).collect();
        for open in OPEN {
            let named = |row: &&&str| {
                row.starts_with(&format!("| `{}", open.function)) && row.ends_with(&format!("| open: {} |", open.why))
            };
            assert!(rows.iter().any(|row| named(&row)), "{open:?} in\n{page}");
        }
        let open = rows.iter().filter(|row| row.contains("| open")).count();
        assert_eq!(open, CLIMBED.iter().filter(|ladder| !ladder.accepted()).count());
        for ladder in CLIMBED.iter() {
            assert!(
                rows.iter().any(|row| row.starts_with(&format!("| `{}` |", ladder.function))),
                "{}",
                ladder.function
            );
        }
    }

    /// Of hundreds of rungs some are left out, but none that a reader looks for.
    #[test]
    fn data_are_thinned() {
        let mut ladder = CLIMBED.iter().find(|ladder| ladder.accepted() && ladder.rungs.len() > 3).unwrap().clone();
        ladder.rungs = vec![ladder.rungs[0].clone(); 100];
        ladder.rungs[37].found = Found::Wrong("NaN".to_owned());
        for (index, rung) in ladder.rungs.iter_mut().enumerate() {
            rung.parameter = index as f64;
        }
        let parameters = |step| kept(&ladder, step).map(|rung| rung.parameter).collect::<Vec<_>>();
        assert_eq!(parameters(40), [0.0, 37.0, 40.0, 80.0, 99.0]);
        assert_eq!(parameters(1).len(), 100);
        let (few, many) = (vec![ladder.clone(); 10], vec![ladder.clone(); 200]);
        let rows = |ladders: &[Ladder]| data(ladders, ladder.family).unwrap().split(|byte| *byte == b'\n').count() - 2;
        assert_eq!(rows(&few), 1000);
        assert!((200 * 20..200 * 60).contains(&rows(&many)), "{}", rows(&many));
        assert!(data(&many, ladder.family).unwrap().len() <= MOST_BYTES);
    }

    #[test]
    fn a_row_tells_loss_and_cost() {
        let rung =
            |found| Rung { parameter: 0.5, inputs: vec![0.5, 1.0], condition: Some(3e5), found, naive_ulp: None };
        let ladder = |function: &str, rungs| Ladder {
            function: function.to_owned(),
            family: Family::Half,
            toward: "n → 1/2".to_owned(),
            axis: "|n − 1/2|".to_owned(),
            inputs: vec!["n".to_owned(), "x".to_owned()],
            naive: None,
            rungs,
        };
        let right = ladder("f", vec![rung(Found::Number { ulp: 0.25, excess: -5.78 })]);
        assert_eq!(line(&right), "| `f` | n → 1/2 | 0.25 | 3.0e5 | -5.8 | — |  |\n");
        let broken = Rung { naive_ulp: Some(f64::INFINITY), ..rung(Found::Wrong("NaN".to_owned())) };
        let wrong = ladder("h", vec![broken]);
        assert_eq!(line(&wrong), "| `h` | n → 1/2 | — | 3.0e5 | — | no number | open, not yet explained |\n");
        let table = table(&[right.clone(), wrong.clone(), wrong, right]);
        let order: Vec<_> = table.lines().filter_map(|line| line.strip_prefix("| `")?.chars().next()).collect();
        assert_eq!(order, ['h', 'h', 'f'], "{table}");
        assert!(files(&[]).unwrap().is_empty());
    }
}
