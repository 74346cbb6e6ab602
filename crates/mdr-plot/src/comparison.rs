//! Methods that answer the same questions: a row for each, with the times and the digits of its answers.

use crate::{Axis, Colour, Layer, Mark, Panel, Picture, Side, Stroke, Unit};

/// A question that several methods answer.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedQuestion<'a> {
    /// The question in words.
    pub title: &'a str,
    /// The digits that any method in double precision is left with; `None` if the question has no such limit.
    pub attainable: Option<f64>,
    /// Who answers.
    pub methods: Vec<ComparedMethod<'a>>,
}

/// A method, and its answers with growing effort.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedMethod<'a> {
    /// Its name.
    pub name: &'a str,
    /// Whether it comes from a textbook, for comparison: it is grey.
    pub textbook: bool,
    /// The seconds that each answer took, and its right digits where it is a number.
    pub answers: Vec<(f64, Option<f64>)>,
}

/// A panel for each question, and in all of them the same row for a method, with its answers by their times; the axis of times is
/// logarithmic and shared. Marks grow with the right digits, and the most digits of a method are written beside it.
///
/// ```
/// use mdr_plot::{ComparedMethod, ComparedQuestion, comparison};
/// let answers = vec![(1e-6, Some(3.0)), (4e-6, Some(12.5)), (9e-6, None)];
/// let methods = vec![ComparedMethod { name: "quadrature", textbook: false, answers }];
/// let picture = comparison("Transforms", &[ComparedQuestion { title: "g(0.7)", attainable: Some(15.5), methods }]);
/// assert!(picture.csv().contains("quadrature: 12.5 digits"));
/// ```
pub fn comparison(title: &str, questions: &[ComparedQuestion<'_>]) -> Picture {
    let rows = rows(questions);
    let answers = questions.iter().flat_map(|question| &question.methods).flat_map(|method| &method.answers);
    let times = decades(answers.map(|(seconds, _)| *seconds));
    let mut panels: Vec<Panel> = questions.iter().map(|question| panel(question, &rows, times)).collect();
    if let Some(first) = panels.first_mut() {
        first.note("marks grow with the right digits; the most digits are written");
    }
    Picture {
        title: title.to_owned(),
        description: "Methods by the time of an answer, a row for each, those of this library in blue, those of textbooks in grey, by \
                      the most right digits that they reach. Marks grow with the right digits, and the most are written beside \
                      them; \"at most\" where a double holds more. Crosses: no answer."
            .to_owned(),
        panels,
    }
}

/// A method in the rows: its name, and whether it is of a textbook.
type Row<'a> = (&'a str, bool);

/// All methods, those with the most digits above; of methods with as many, the fastest.
fn rows<'a>(questions: &[ComparedQuestion<'a>]) -> Vec<Row<'a>> {
    let mut rows: Vec<(Row<'a>, Vec<f64>, f64)> = Vec::new();
    for method in questions.iter().flat_map(|question| &question.methods) {
        let row = match rows.iter().position(|((name, _), ..)| *name == method.name) {
            Some(known) => &mut rows[known],
            None => {
                rows.push(((method.name, method.textbook), Vec::new(), 0.0));
                rows.last_mut().expect("just pushed")
            }
        };
        let best = best(method);
        row.1.push(best.map_or(0.0, |(_, digits)| digits));
        row.2 += best.map_or(0.0, |(seconds, _)| seconds.ln());
    }
    // Whole digits: fractions of one decide nothing.
    let mean = |digits: &[f64]| (digits.iter().sum::<f64>() / digits.len() as f64).round();
    rows.sort_by(|(_, one, fast), (_, other, slow)| mean(other).total_cmp(&mean(one)).then(fast.total_cmp(slow)));
    rows.into_iter().map(|(row, ..)| row).collect()
}

/// The time and the digits of the answer with the most digits.
fn best(method: &ComparedMethod<'_>) -> Option<(f64, f64)> {
    let answers = method.answers.iter().filter_map(|(seconds, digits)| Some((*seconds, (*digits)?)));
    answers.reduce(|best, next| if next.1 > best.1 { next } else { best })
}

fn panel(question: &ComparedQuestion<'_>, rows: &[Row<'_>], [fastest, slowest]: [f64; 2]) -> Panel {
    let time = Axis::log("time of an answer", Unit::Si("s"), fastest, slowest);
    let name = |(name, textbook): &Row<'_>| format!("{name}{}", if *textbook { " (textbook)" } else { "" });
    let y = Axis::rows("", rows.iter().map(name).collect());
    // An equation stays in one line.
    let heading = raised(question.title).replace("κ_n", "κ_{n}").replace(" = ", "\u{a0}=\u{a0}");
    let mut panel = Panel::new(&heading, time, y);
    let most = question.methods.iter().filter_map(best).map(|(_, digits)| digits).fold(1.0, f64::max);
    for method in &question.methods {
        let Some(row) = rows.iter().position(|(name, _)| *name == method.name) else { continue };
        let height = panel.y.row(row);
        let colour = if method.textbook { Colour::Grey } else { Colour::Blue };
        let reached = || method.answers.iter().filter_map(|(seconds, digits)| Some((*seconds, digits.as_ref()?)));
        let line = reached().map(|(seconds, _)| [seconds, height]).collect();
        panel.layers.push(Layer::curve(method.name, line, Stroke::Thin).coloured(colour));
        for (seconds, digits) in reached() {
            let name = format!("{}: {digits:.1} digits", method.name);
            let mark = Layer::marks(name, vec![[seconds, height]], Mark::Filled).coloured(colour);
            panel.layers.push(mark.sized(0.5 + 0.8 * (digits / most).clamp(0.0, 1.0)));
        }
        let failed = method.answers.iter().filter(|(_, digits)| digits.is_none());
        let failed: Vec<_> = failed.map(|(seconds, _)| [*seconds, height]).collect();
        if !failed.is_empty() {
            panel.layers.push(Layer::marks("no answer", failed.clone(), Mark::Cross).coloured(Colour::Orange));
        }
        // Behind the slowest answer, where no mark is in the way.
        let end = vec![[reached().map(|(seconds, _)| seconds).fold(fastest, f64::max), height]];
        let (text, at) = match (best(method), question.attainable) {
            (None, _) => ("no answer".to_owned(), failed),
            (Some((_, digits)), Some(attainable)) if digits + 1.0 < attainable => (format!("{digits:.1} at most"), end),
            (Some((_, digits)), _) => (format!("{digits:.1}"), end),
        };
        panel.layers.push(Layer::label(text, at, Side::Right).coloured(colour));
    }
    panel
}

/// Powers such as r^0.25 with their exponents above the line.
fn raised(title: &str) -> String {
    let mut parts = title.split('^');
    let mut raised = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let is_exponent = |letter: char| letter.is_ascii_digit() || matches!(letter, '.' | '/' | '(' | ')');
        let end = part.find(|letter| !is_exponent(letter)).unwrap_or(part.len());
        let (exponent, rest) = part.split_at(end);
        raised.push_str(&format!("^{{{}}}{rest}", exponent.trim_matches(['(', ')'])));
    }
    raised
}

/// Whole decades around values, at least one.
fn decades(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let (least, most) = values.fold((f64::INFINITY, 0.0), |(least, most), x: f64| (x.min(least), x.max(most)));
    if least > most {
        return [1.0, 10.0];
    }
    let lower = least.log10().floor();
    [lower, most.log10().ceil().max(lower + 1.0)].map(|exponent| 10_f64.powf(exponent))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponents_are_raised() {
        assert_eq!(raised("g(0.7) of f = r^0.25, by"), "g(0.7) of f = r^{0.25}, by");
        assert_eq!(raised("r^(1/4)"), "r^{1/4}");
        assert_eq!(raised("κ_n"), "κ_n");
    }

    #[test]
    fn axes_are_whole_decades() {
        let [lower, upper] = decades([3e-9, 2e-4].into_iter());
        assert!((lower / 1e-9 - 1.0).abs() < 1e-9 && (upper / 1e-3 - 1.0).abs() < 1e-9, "{lower} to {upper}");
        assert_eq!(decades(std::iter::empty()), [1.0, 10.0]);
    }
}
