//! The races of this workspace beside other projects.

use mdr_crosscheck::contest::Outcome;
use mdr_crosscheck::contest::speed::{Race, Side};

use super::table::seconds;

/// The name by which `--only` asks for it, and what it is about.
pub(super) const NAME: &str = "speed";
pub(super) const CLAIM: &str = "this workspace beside Arb, numpy and scipy, taking turns in one run";

const HEAD: &str = "
Both sides take turns: a time is the median of the medians of all turns. The ratio is that of the fastest answers, which a busy
machine disturbs least, in brackets that of the medians; one below 1.5 either way means little. Enclosures are compared with enclosures,
and with the fastest way that the other project has; its times are taken inside Python around calls into compiled code. \"The
first answer\" is that of a process which has no constants yet: MPFR and Arb are told to forget theirs before every answer.
";

/// The ratios of a question.
fn questions(races: &[Race]) -> Vec<(&str, Vec<&Race>)> {
    let mut all: Vec<(&str, Vec<&Race>)> = Vec::new();
    for race in races {
        match all.iter_mut().find(|(question, _)| *question == race.question) {
            Some((_, races)) => races.push(race),
            None => all.push((&race.question, vec![race])),
        }
    }
    all
}

/// One row a question; nothing where nobody raced.
pub(super) fn overview(races: &[Race]) -> String {
    if races.is_empty() {
        return String::new();
    }
    let mut text = "\n| question | times faster than the other |\n|---|---|\n".to_owned();
    for (question, races) in questions(races) {
        let told: Vec<_> = races.iter().map(|race| format!("**{:.1}** ({})", ratio(race), race.setting)).collect();
        text.push_str(&format!("| {question} | {} |\n", told.join(", ")));
    }
    text
}

/// A table a question; nothing where nobody raced.
pub(super) fn section(races: &[Race]) -> String {
    if races.is_empty() {
        return String::new();
    }
    let mut text = format!("\n![{NAME}: times faster than others]({NAME}-summary.svg)\n{HEAD}");
    for (question, races) in questions(races) {
        text.push_str(&format!("\n### {question}\n\n{COLUMNS}"));
        text.extend(races.into_iter().map(row));
    }
    text
}

const COLUMNS: &str = "\
| | this workspace | takes | digits | other | takes | digits | times faster | aim |
|---|---|---|---|---|---|---|---|---|
";

fn row(race: &Race) -> String {
    let Race { setting, ours, theirs, aim, .. } = race;
    let aim = aim.map_or(String::new(), |aim| aim.to_string());
    let (least, median) = (ratio(race), race.ratio());
    format!("| {setting} | {} | {} | **{least:.1}** ({median:.1}) | {aim} |\n", side(ours), side(theirs))
}

/// How many times faster the fastest answer is.
pub(super) fn ratio(race: &Race) -> f64 {
    race.theirs.time.least / race.ours.time.least
}

fn side(side: &Side) -> String {
    let digits = match (&side.outcome, side.outcome.digits()) {
        (_, Some(digits)) => format!("{digits:.1}"),
        (Outcome::Passed, _) => "—".to_owned(),
        _ => "failed".to_owned(),
    };
    format!("{} | {} | {digits}", side.name, seconds(side.time.median))
}

#[cfg(test)]
mod tests {
    use mdr_crosscheck::contest::Time;

    use super::*;

    #[test]
    fn ratios_are_told_with_both_times() {
        let took = |median: f64| Time { median, least: median / 2.0, most: median, runs: 3 };
        let side = |name: &str, time| Side { name: name.to_owned(), outcome: Outcome::Digits(50.25), time };
        let race = |setting: &str, outcome, aim| Race {
            question: "κ".to_owned(),
            setting: setting.to_owned(),
            ours: side("ours", took(2e-6)),
            theirs: Side { outcome, ..side("Arb", Time { least: 3e-6, ..took(9e-6) }) },
            aim,
        };
        let races = [race("50 digits", Outcome::Digits(50.25), Some(3.0)), race("a part", Outcome::Passed, None)];
        let text = section(&races);
        let rows = "| 50 digits | ours | 2.00 µs | 50.2 | Arb | 9.00 µs | 50.2 | **3.0** (4.5) | 3 |\n\
                    | a part | ours | 2.00 µs | 50.2 | Arb | 9.00 µs | — | **3.0** (4.5) |  |\n";
        assert!(text.ends_with(rows), "{text}");
        assert!(overview(&races).ends_with("| κ | **3.0** (50 digits), **3.0** (a part) |\n"));
        assert_eq!((section(&[]), overview(&[])), (String::new(), String::new()));
    }
}
