//! The section that sets this workspace beside other projects.

use mdr_crosscheck::contest::speed::{Race, Side};
use mdr_crosscheck::contest::{Outcome, Time};

/// The name by which `--only` asks for it.
pub(super) const NAME: &str = "speed";

const HEAD: &str = "
## speed

Ratios to other projects, both sides taking turns in one run: the median of one turn's medians. The ratio in brackets is that
of the fastest answers, the one that a busy machine disturbs least. Enclosures are compared with enclosures, and with the
fastest way that the other project has; its times are taken inside Python around calls into compiled code.

| question | this workspace | takes | digits | other | takes | digits | times faster | aim |
|---|---|---|---|---|---|---|---|---|
";

/// The table of ratios; nothing where nobody raced.
pub(super) fn section(races: &[Race]) -> String {
    if races.is_empty() {
        return String::new();
    }
    let row = |race: &Race| {
        let Race { question, setting, ours, theirs, aim } = race;
        let aim = aim.map_or(String::new(), |aim| aim.to_string());
        format!(
            "| {question}, {setting} | {} | {} | {:.1} ({:.1}) | {aim} |\n",
            side(ours),
            side(theirs),
            race.ratio(),
            theirs.time.least / ours.time.least
        )
    };
    races.iter().fold(HEAD.to_owned(), |text, race| text + &row(race))
}

fn side(side: &Side) -> String {
    let digits = match (&side.outcome, side.outcome.digits()) {
        (_, Some(digits)) => format!("{digits:.1}"),
        (Outcome::Passed, _) => "—".to_owned(),
        _ => "failed".to_owned(),
    };
    format!("{} | {} | {digits}", side.name, seconds(&side.time))
}

/// With a prefix of the SI.
fn seconds(time: &Time) -> String {
    const UNITS: [(f64, &str); 4] = [(1.0, "s"), (1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns")];
    let (unit, name) = UNITS.into_iter().find(|(unit, _)| time.median >= *unit).unwrap_or(UNITS[3]);
    let value = time.median / unit;
    let places = usize::from(value < 100.0) + usize::from(value < 10.0);
    format!("{value:.places$} {name}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn took(median: f64) -> Time {
        Time { median, least: median / 2.0, most: median, runs: 3 }
    }

    #[test]
    fn ratios_are_told_with_both_times() {
        let side = |name: &str, time| Side { name: name.to_owned(), outcome: Outcome::Digits(50.25), time };
        let theirs = Time { least: 3e-6, ..took(9e-6) };
        let race = Race {
            question: "κ".to_owned(),
            setting: "50 digits".to_owned(),
            ours: side("ours", took(2e-6)),
            theirs: side("Arb", theirs),
            aim: Some(3.0),
        };
        let text = section(&[race]);
        let row = "| κ, 50 digits | ours | 2.00 µs | 50.2 | Arb | 9.00 µs | 50.2 | 4.5 (3.0) | 3 |\n";
        assert!(text.ends_with(row), "{text}");
        assert_eq!(section(&[]), "");
    }

    #[test]
    fn times_have_three_figures() {
        let told = [4.5, 0.0123, 123.4e-6, 7.654e-9, 2e-11].map(|median| seconds(&took(median)));
        assert_eq!(told, ["4.50 s", "12.3 ms", "123 µs", "7.65 ns", "0.02 ns"]);
    }
}
