//! Error against run time, and the stability ladders, in Markdown.

use std::collections::BTreeSet;

use super::Findings;
use crate::ladders::{Family, Ladder, Rung};
use crate::short;
use crate::work_precision::{Comparison, Series, Task};

impl Findings {
    /// Both parts as a page in Markdown, which shows the picture `NAME.svg` of each task; it ends with `origin`: by which
    /// command, how often and on which machine.
    pub fn page(&self, origin: &str) -> String {
        let mut page = HEAD.to_owned();
        for (task, comparisons) in &self.tasks {
            page.push_str(&section(task, comparisons));
        }
        page.push_str(&failures(self));
        page.push_str(&stability(&self.ladders));
        page + &format!("\n## How it was made\n\n{origin}\n")
    }
}

const HEAD: &str = include_str!("../../text/report.md");

fn section(task: &Task, comparisons: &[Comparison]) -> String {
    let Task { name, title, .. } = task;
    let digits: &[f64] = if *name == "digits" { &[15.0, 50.0, 100.0, 1000.0] } else { &[6.0, 12.0, 15.0] };
    let heads: String = digits.iter().map(|digits| format!(" {digits} digits |")).collect();
    let rules = "---|".repeat(digits.len() + 1);
    let mut text = format!("\n### {title}\n\n![{title}]({name}.svg)\n\n| question |{heads}\n|{rules}\n");
    let mut truths = BTreeSet::new();
    for comparison in comparisons {
        let cells: String = digits.iter().map(|digits| format!(" {} |", cell(comparison, *digits))).collect();
        text.push_str(&format!("| {} |{cells}\n", escaped(&comparison.title)));
        truths.insert(comparison.truth);
    }
    for truth in truths {
        text.push_str(&format!("\nExact: {truth}.\n"));
    }
    text
}

/// The cheapest answers with so many digits.
fn cell(comparison: &Comparison, digits: f64) -> String {
    let best = |ours: bool| fastest(comparison.series.iter().filter(move |series| series.ours == ours), digits);
    let ours = best(true).map(|(seconds, method)| format!("**{}** {method}", time(seconds)));
    let textbook = best(false).map(|(seconds, method)| format!("{} {method}", time(seconds)));
    let shown: Vec<_> = ours.into_iter().chain(textbook).collect();
    if shown.is_empty() { "—".to_owned() } else { shown.join("<br>") }
}

fn fastest<'a>(series: impl Iterator<Item = &'a Series>, digits: f64) -> Option<(f64, &'static str)> {
    let points = series.flat_map(|series| series.points.iter().map(|point| (series.method, point)));
    let right = points.filter(|(_, point)| point.outcome.digits().is_some_and(|found| found >= digits));
    let times = right.filter_map(|(method, point)| Some((point.seconds?, method)));
    times.min_by(|(one, _), (other, _)| one.total_cmp(other))
}

/// Three digits of a time with its unit.
fn time(seconds: f64) -> String {
    let (scale, unit) = match seconds {
        // A rounding below a power of ten belongs to it.
        s if s < 0.9995e-6 => (1e9, "ns"),
        s if s < 0.9995e-3 => (1e6, "µs"),
        s if s < 0.9995 => (1e3, "ms"),
        _ => (1.0, "s"),
    };
    format!("{} {unit}", short::rounded(scale * seconds, 3))
}

fn failures(findings: &Findings) -> String {
    let mut rows = String::new();
    for comparison in findings.comparisons() {
        for (Series { method, .. }, point, failed) in comparison.failures() {
            let (id, reason) = (&comparison.id, escaped(failed));
            rows.push_str(&format!("| {id} | {method} | {} | {reason} |\n", point.setting));
        }
    }
    if rows.is_empty() {
        return "\nEvery method gave a number to every question.\n".to_owned();
    }
    format!("\n### No answer\n\n| question | method | setting | why |\n|---|---|---|---|\n{rows}")
}

const LADDERS: &str = include_str!("../../text/ladders.md");

fn stability(ladders: &[Ladder]) -> String {
    let mut text = LADDERS.to_owned();
    for family in Family::ALL {
        let of_family: Vec<_> = ladders.iter().filter(|ladder| ladder.family == family).collect();
        if !of_family.is_empty() {
            text.push_str(&limit(family, &of_family));
        }
    }
    text.push_str(FUNCTIONS);
    let mut by_loss: Vec<&Ladder> = ladders.iter().collect();
    by_loss.sort_by(|one, other| loss(other).total_cmp(&loss(one)));
    let mut seen = BTreeSet::new();
    for ladder in by_loss {
        if seen.insert(&ladder.function) || !ladder.accepted() {
            text.push_str(&function(ladder));
        }
    }
    text + "\n</details>\n"
}

const FUNCTIONS: &str = include_str!("../../text/functions.md");

/// All ladders in one kind of limit.
fn limit(family: Family, ladders: &[&Ladder]) -> String {
    let open = ladders.iter().filter(|ladder| !ladder.accepted()).count();
    let worst = ladders.iter().max_by(|one, other| loss(one).total_cmp(&loss(other)));
    let naive = |ladder: &Ladder| ladder.worst_naive().unwrap_or(f64::NEG_INFINITY);
    let textbook = ladders.iter().max_by(|one, other| naive(one).total_cmp(&naive(other)));
    let shown =
        worst.map_or_else(String::new, |ladder| format!("{} | `{}`", excess(ladder), escaped(&ladder.function)));
    let typed = textbook.and_then(|ladder| Some(format!("{} | `{}`", size(ladder.worst_naive()?), ladder.function)));
    format!("| {} | {} | {open} | {shown} | {} |\n", family.title(), ladders.len(), typed.unwrap_or("— |".to_owned()))
}

/// A ladder by its worst rung.
fn function(ladder: &Ladder) -> String {
    let rung = ladder.worst();
    let shown = |x: Option<f64>| x.map_or_else(|| "—".to_owned(), size);
    let verdict = if ladder.accepted() { "" } else { "open, not yet explained" };
    format!(
        "| `{}` | {} | {} | {} | {} | {} | {} |\n",
        escaped(&ladder.function),
        escaped(&ladder.toward),
        shown(rung.and_then(Rung::ulp)),
        shown(rung.and_then(|rung| rung.condition)),
        excess(ladder),
        shown(ladder.worst_naive()),
        verdict
    )
}

/// The excess loss of the worst rung, infinite where it is no number and should be one.
fn loss(ladder: &Ladder) -> f64 {
    ladder.worst().map_or(f64::NEG_INFINITY, |rung| match rung.excess() {
        Some(excess) => excess,
        None if rung.accepted() => f64::NEG_INFINITY,
        None => f64::INFINITY,
    })
}

fn excess(ladder: &Ladder) -> String {
    match ladder.worst().and_then(Rung::excess) {
        // No sign for a zero.
        Some(excess) if excess.is_finite() => format!("{excess:.1}").replace("-0.0", "0.0"),
        Some(_) => "no error".to_owned(),
        None => "—".to_owned(),
    }
}

fn size(x: f64) -> String {
    match x {
        x if !x.is_finite() => "no number".to_owned(),
        x if x < 1e4 => format!("{x:.2}"),
        x => format!("{x:.1e}"),
    }
}

/// A text within a cell of a table.
fn escaped(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ladders::Found;

    #[test]
    fn times_have_three_digits_and_a_unit() {
        let shown = [1.5e-8, 9.999e-7, 1.234e-4, 0.02, 3.0].map(time);
        assert_eq!(shown, ["15 ns", "1 µs", "123 µs", "20 ms", "3 s"]);
    }

    #[test]
    fn a_row_tells_loss_and_cost() {
        let rung =
            |found, naive_ulp| Rung { parameter: 0.5, inputs: vec![0.5, 1.0], condition: Some(3e5), found, naive_ulp };
        let ladder = |rung| Ladder {
            function: "f".to_owned(),
            family: Family::Half,
            toward: "n → 1/2".to_owned(),
            axis: "|n − 1/2|".to_owned(),
            inputs: vec!["n".to_owned(), "x".to_owned()],
            naive: None,
            rungs: vec![rung],
        };
        let right = ladder(rung(Found::Number { ulp: 0.25, excess: -5.78 }, None));
        assert_eq!(function(&right), "| `f` | n → 1/2 | 0.25 | 3.0e5 | -5.8 | — |  |\n");
        let wrong = ladder(rung(Found::Wrong("NaN".to_owned()), Some(f64::INFINITY)));
        assert_eq!(function(&wrong), "| `f` | n → 1/2 | — | 3.0e5 | — | no number | open, not yet explained |\n");
        let both = limit(Family::Half, &[&right, &wrong]);
        assert_eq!(both, "| the exponent tends to 1/2 | 2 | 1 | — | `f` | no number | `f` |\n");
    }
}
