//! The points of a contest as rows, and the cheapest way to so many digits.

use mdr_crosscheck::contest::{Arithmetic, Curve, Diagram, Outcome, Point, View};

use crate::error::{Failure, Result};

/// Digits that a reader may want.
const DIGITS: [u32; 6] = [6, 12, 15, 50, 100, 1000];

pub(super) const HEADER: [&str; 14] = [
    "task",
    "diagram",
    "contestant",
    "arithmetic",
    "outside",
    "setting",
    "outcome",
    "digits",
    "reason",
    "evaluations",
    "median_s",
    "least_s",
    "most_s",
    "runs",
];

/// One row a point.
pub(super) fn rows(diagram: &Diagram) -> impl Iterator<Item = [String; 14]> {
    let points = diagram.curves.iter().flat_map(|curve| curve.points.iter().map(move |point| (curve, point)));
    points.map(|(curve, point)| row(diagram, curve, point))
}

fn row(diagram: &Diagram, curve: &Curve, point: &Point) -> [String; 14] {
    let (outcome, reason) = match &point.outcome {
        Outcome::Digits(_) => ("digits", ""),
        Outcome::AtLeast(_) => ("at-least", ""),
        Outcome::Failed(reason) => ("failed", reason.as_str()),
        Outcome::Stopped(reason) => ("stopped", reason.as_str()),
        Outcome::Passed => ("passed", ""),
    };
    let seconds = point.time.map(|time| [time.median, time.least, time.most].map(|seconds| format!("{seconds:.3e}")));
    let [median, least, most] = seconds.unwrap_or_default();
    [
        diagram.task.clone(),
        diagram.id.clone(),
        curve.contestant.clone(),
        arithmetic(curve.arithmetic).to_owned(),
        curve.outside.to_string(),
        point.setting.clone(),
        outcome.to_owned(),
        point.outcome.digits().map_or(String::new(), |digits| format!("{digits:.2}")),
        reason.to_owned(),
        point.evaluations.map_or(String::new(), |count| count.to_string()),
        median,
        least,
        most,
        point.time.map_or(String::new(), |time| time.runs.to_string()),
    ]
}

/// The name of an arithmetic in files and on the page.
pub(super) fn arithmetic(arithmetic: Arithmetic) -> &'static str {
    match arithmetic {
        Arithmetic::Double => "f64",
        Arithmetic::Mp => "mp",
        Arithmetic::Certified => "certified",
    }
}

/// A header and the points of these diagrams.
pub(super) fn csv<'a>(diagrams: impl IntoIterator<Item = &'a Diagram>) -> Result<Vec<u8>> {
    let failed = |error: csv::Error| Failure::file("csv", std::io::Error::from(error));
    let mut csv = csv::Writer::from_writer(Vec::new());
    csv.write_record(HEADER).map_err(failed)?;
    for row in diagrams.into_iter().flat_map(rows) {
        csv.write_record(row).map_err(failed)?;
    }
    csv.into_inner().map_err(|error| Failure::file("csv", error.into_error()))
}

/// The most digits that anyone reaches, and the number of failures.
pub(super) fn summary(diagram: &Diagram) -> (Option<f64>, usize) {
    let points = || diagram.curves.iter().flat_map(|curve| &curve.points);
    let digits = points().filter_map(|point| point.outcome.digits()).max_by(f64::total_cmp);
    (digits, points().filter(|point| matches!(point.outcome, Outcome::Failed(_))).count())
}

/// The median time of the cheapest point that reaches so many digits, in s.
fn cheapest(curve: &Curve, digits: u32) -> Option<f64> {
    let reaches = |point: &&Point| point.outcome.digits().is_some_and(|reached| reached >= f64::from(digits));
    curve.points.iter().filter(reaches).filter_map(|point| Some(point.time?.median)).min_by(f64::total_cmp)
}

/// "Time to so many digits" in Markdown: a row a contestant, a column a number of digits that someone reaches. Where time is
/// shown by size, a column a size.
pub(super) fn times(diagrams: &[Diagram]) -> String {
    let by_digits: Vec<_> = diagrams.iter().filter(|diagram| diagram.view != View::Size).collect();
    let reached = |digits: &u32| curves(&by_digits).any(|(_, curve)| cheapest(curve, *digits).is_some());
    let columns: Vec<u32> = DIGITS.into_iter().filter(reached).collect();
    let mut text = String::new();
    if !columns.is_empty() {
        let heads: String = columns.iter().map(|digits| format!(" {digits} |")).collect();
        text.push_str(&format!(
            "| question | contestant | arithmetic |{heads}\n|---|---|---|{}\n",
            "---|".repeat(columns.len())
        ));
    }
    for (diagram, curve) in curves(&by_digits).filter(|_| !columns.is_empty()) {
        let cell = |digits: &u32| cheapest(curve, *digits).map_or("—".to_owned(), seconds);
        let cells: String = columns.iter().map(|digits| format!(" {} |", cell(digits))).collect();
        text.push_str(&format!("| {} | {} | {} |{cells}\n", diagram.id, name(curve), arithmetic(curve.arithmetic)));
    }
    text
}

/// Time by size in Markdown: a row a contestant, a column a setting.
pub(super) fn sizes(diagram: &Diagram) -> String {
    let settings = diagram.curves.iter().max_by_key(|curve| curve.points.len()).map(|curve| &curve.points);
    let settings: Vec<_> = settings.into_iter().flatten().map(|point| &point.setting).collect();
    let heads: String = settings.iter().map(|setting| format!(" {setting} |")).collect();
    let mut text = format!("| contestant |{heads}\n|---|{}\n", "---|".repeat(settings.len()));
    for curve in &diagram.curves {
        let time = |setting: &str| curve.points.iter().find(|point| point.setting == setting)?.time;
        let cell = |setting: &&String| time(setting).map_or("—".to_owned(), |time| seconds(time.median));
        let cells: String = settings.iter().map(|setting| format!(" {} |", cell(setting))).collect();
        text.push_str(&format!("| {} |{cells}\n", name(curve)));
    }
    text
}

fn curves<'a>(diagrams: &[&'a Diagram]) -> impl Iterator<Item = (&'a Diagram, &'a Curve)> {
    diagrams
        .iter()
        .flat_map(|diagram| diagram.curves.iter().map(|curve| (*diagram, curve)))
        .collect::<Vec<_>>()
        .into_iter()
}

/// A contestant, and whether it is another project's.
pub(super) fn name(curve: &Curve) -> String {
    if curve.outside { format!("{} (outside)", curve.contestant) } else { curve.contestant.clone() }
}

/// Three significant digits and a prefix: "12.3 µs".
pub(super) fn seconds(seconds: f64) -> String {
    const PREFIXES: [(f64, &str); 5] = [(1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"), (1e-12, "p")];
    // What rounds to a thousand takes the next prefix.
    let fits = |(unit, _): &&(f64, &str)| seconds >= 0.9995 * unit;
    let (unit, prefix) = PREFIXES.iter().find(fits).copied().unwrap_or((1e-12, "p"));
    let scaled = seconds / unit;
    let decimals = if scaled < 9.995 {
        2
    } else if scaled < 99.95 {
        1
    } else {
        0
    };
    format!("{scaled:.decimals$} {prefix}s")
}

#[cfg(test)]
mod tests {
    use super::super::diagram::tests::contest;
    use super::*;

    #[test]
    fn three_digits_and_a_prefix() {
        for (value, text) in [
            (1.234e-8, "12.3 ns"),
            (9.999e-4, "1.00 ms"),
            (0.00999, "9.99 ms"),
            (99.96e-6, "100 µs"),
            (2.0, "2.00 s"),
            (432.1, "432 s"),
            (3e-13, "0.30 ps"),
        ] {
            assert_eq!(seconds(value), text);
        }
    }

    /// Nothing is interpolated: 12 digits cost what the first point with 12 or more costs.
    #[test]
    fn time_to_digits_is_that_of_a_point() {
        let text = times(&[contest(View::Error)]);
        assert!(text.starts_with("| question | contestant | arithmetic | 6 | 12 | 15 |\n"), "{text}");
        assert!(text.contains("| test-contest | doubling | f64 | 8.00 µs | 16.0 µs | 16.0 µs |"), "{text}");
        assert!(text.contains("| test-contest | another (outside) | f64 | — | — | — |"), "{text}");
        assert_eq!(times(&[contest(View::Size)]), "");
    }

    #[test]
    fn rows_have_all_columns() {
        let text = String::from_utf8(csv([&contest(View::Error)]).unwrap()).unwrap();
        let lines: Vec<_> = text.lines().collect();
        assert_eq!(lines[0], HEADER.join(","));
        assert_eq!(
            lines[1],
            "test,test-contest,doubling,f64,false,1 nodes,digits,1.00,,1,1.000e-6,9.000e-7,1.200e-6,3"
        );
        assert!(lines.iter().any(|line| line.contains(",failed,,no convergence,")), "{text}");
        assert_eq!(summary(&contest(View::Error)), (Some(16.0), 1));
    }
}
