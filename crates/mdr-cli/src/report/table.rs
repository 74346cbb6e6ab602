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
pub(super) fn cheapest(curve: &Curve, digits: u32) -> Option<f64> {
    let reaches = |point: &&Point| point.outcome.digits().is_some_and(|reached| reached >= f64::from(digits));
    curve.points.iter().filter(reaches).filter_map(|point| Some(point.time?.median)).min_by(f64::total_cmp)
}

/// What the question is called where its task is known.
pub(super) fn short(diagram: &Diagram) -> &str {
    diagram.id.strip_prefix(&*diagram.task).and_then(|rest| rest.strip_prefix('-')).unwrap_or(&diagram.id)
}

/// The numbers of digits that somebody reaches.
fn columns<'a>(curves: impl Iterator<Item = &'a Curve> + Clone) -> Vec<u32> {
    DIGITS.into_iter().filter(|digits| curves.clone().any(|curve| cheapest(curve, *digits).is_some())).collect()
}

fn heads(columns: &[u32]) -> (String, String) {
    (columns.iter().map(|digits| format!(" {digits} |")).collect(), "---|".repeat(columns.len()))
}

/// The fastest way to so many digits in Markdown: a row a question, a column a number of digits; this workspace, and below it
/// other projects. Nothing of diagrams by size.
pub(super) fn fastest(diagrams: &[Diagram]) -> String {
    let by_digits = diagrams.iter().filter(|diagram| diagram.view != View::Size);
    let columns = columns(by_digits.clone().flat_map(|diagram| &diagram.curves));
    if columns.is_empty() {
        return String::new();
    }
    let (heads, rule) = heads(&columns);
    let mut text = format!("| question |{heads}\n|---|{rule}\n");
    for diagram in by_digits {
        let best = |outside: bool, digits: u32| {
            let curves = diagram.curves.iter().filter(|curve| curve.outside == outside);
            let times = curves.filter_map(|curve| Some((cheapest(curve, digits)?, curve)));
            times.min_by(|(one, _), (other, _)| one.total_cmp(other))
        };
        let told = |(time, curve): (f64, &Curve), bold: &str| {
            let arithmetic = match curve.arithmetic {
                Arithmetic::Mp if !curve.contestant.starts_with("mp") => " (mp)",
                _ => "",
            };
            format!("{bold}{}{bold} {}{arithmetic}", seconds(time), curve.contestant)
        };
        let cell = |digits: &u32| {
            let ours = best(false, *digits).map(|found| told(found, "**"));
            let theirs = best(true, *digits).map(|found| told(found, ""));
            let lines: Vec<_> = ours.into_iter().chain(theirs).collect();
            if lines.is_empty() { " — |".to_owned() } else { format!(" {} |", lines.join("<br>")) }
        };
        let cells: String = columns.iter().map(cell).collect();
        text.push_str(&format!("| `{}`: {} |{cells}\n", short(diagram), diagram.title));
    }
    text
}

/// "Time to so many digits" of all contestants in Markdown: a row a contestant, a column a number of digits that someone
/// reaches, with the ratio to what is shipped. Nothing of a diagram by size.
pub(super) fn times(diagram: &Diagram) -> String {
    let columns = columns(diagram.curves.iter());
    if columns.is_empty() || diagram.view == View::Size {
        return String::new();
    }
    let (heads, rule) = heads(&columns);
    let mut text = format!("| contestant | arithmetic |{heads}\n|---|---|{rule}\n");
    let shipped = |digits: u32| {
        let curves = diagram.curves.iter().filter(|curve| curve.contestant == diagram.shipped);
        curves.filter_map(|curve| cheapest(curve, digits)).min_by(f64::total_cmp)
    };
    for curve in &diagram.curves {
        let cell = |digits: &u32| match (cheapest(curve, *digits), shipped(*digits)) {
            (None, _) => " — |".to_owned(),
            (Some(time), None) => format!(" {} |", seconds(time)),
            (Some(time), Some(unit)) => format!(" {} ({}) |", seconds(time), times_that(time / unit)),
        };
        let cells: String = columns.iter().map(cell).collect();
        text.push_str(&format!("| {} | {} |{cells}\n", name(curve), arithmetic(curve.arithmetic)));
    }
    text
}

/// A ratio to two digits.
fn times_that(ratio: f64) -> String {
    match ratio {
        ratio if ratio < 0.000_95 => format!("{ratio:.1e}×"),
        ratio if ratio < 0.095 => format!("{ratio:.3}×"),
        ratio if ratio < 0.95 => format!("{ratio:.2}×"),
        ratio if ratio < 9.5 => format!("{ratio:.1}×"),
        ratio => format!("{ratio:.0}×"),
    }
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
        let text = times(&contest(View::Error));
        assert!(text.starts_with("| contestant | arithmetic | 6 | 12 | 15 |\n"), "{text}");
        assert!(text.contains("| doubling | f64 | 8.00 µs (1.0×) | 16.0 µs (1.0×) | 16.0 µs (1.0×) |"), "{text}");
        assert!(text.contains("| another (outside) | f64 | — | — | — |"), "{text}");
        assert_eq!(times(&contest(View::Size)), "");
    }

    #[test]
    fn the_fastest_of_this_workspace_and_of_others() {
        let mut diagram = contest(View::Error);
        let slower = Curve { outside: true, contestant: "slower".to_owned(), ..diagram.curves[0].clone() };
        diagram.curves.push(slower);
        let text = fastest(&[contest(View::Size), diagram]);
        assert!(
            text.starts_with(
                "| question | 6 | 12 | 15 |\n|---|---|---|---|\n| `contest`: x at y < 1 | **8.00 µs** doubling<br>8.00 µs slower |"
            ),
            "{text}"
        );
        assert_eq!(fastest(&[contest(View::Size)]), "");
        assert_eq!([0.0123, 0.5, 3.12, 9.7, 123.4].map(times_that), ["0.012×", "0.50×", "3.1×", "10×", "123×"]);
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
