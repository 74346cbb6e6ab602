//! Methods that answer the same questions: the error of each answer against its time, or its time against its digits.

use crate::{Axis, Colour, Layer, Mark, Panel, Picture, Stroke, Unit};

/// A question that several methods answer.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedQuestion<'a> {
    /// The question in words.
    pub title: &'a str,
    /// The digits that any method in double precision is left with, drawn as a line of relative errors; without them the
    /// digits of the answers are drawn instead.
    pub attainable: Option<f64>,
    /// Who answers.
    pub methods: Vec<ComparedMethod<'a>>,
}

/// A method, and its answers with growing effort.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedMethod<'a> {
    /// Its name.
    pub name: &'a str,
    /// Whether it comes from a textbook, for comparison: its marks are open.
    pub textbook: bool,
    /// The seconds that each answer took, and its right digits where it is a number.
    pub answers: Vec<(f64, Option<f64>)>,
}

/// An error beyond this is drawn as a failure.
const LARGEST: f64 = 10.0;

/// A panel for each question and a curve for each method, both axes logarithmic.
///
/// ```
/// use mdr_plot::{ComparedMethod, ComparedQuestion, comparison};
/// let answers = vec![(1e-6, Some(3.0)), (4e-6, Some(12.5)), (9e-6, None)];
/// let methods = vec![ComparedMethod { name: "quadrature", textbook: false, answers }];
/// let picture = comparison("Transforms", &[ComparedQuestion { title: "g(0.7)", attainable: Some(15.5), methods }]);
/// assert!(picture.csv().contains("quadrature"));
/// ```
pub fn comparison(title: &str, questions: &[ComparedQuestion<'_>]) -> Picture {
    let mut names: Vec<&str> = Vec::new();
    for method in questions.iter().flat_map(|question| &question.methods) {
        if !names.contains(&method.name) {
            names.push(method.name);
        }
    }
    let colour = |method: &ComparedMethod<'_>| {
        Colour::series(names.iter().position(|name| *name == method.name).unwrap_or_default())
    };
    let mut panels: Vec<Panel> = questions.iter().map(|question| panel(question, colour)).collect();
    if let Some((first, others)) = panels.split_first_mut() {
        // One legend is enough: the first panel has those of all.
        for layer in others.iter_mut().flat_map(|panel| &mut panel.layers) {
            let legend = layer.legend.take();
            first.layers.push(Layer { name: String::new(), points: Vec::new(), legend, ..*layer });
        }
    }
    Picture {
        title: title.to_owned(),
        description: "Methods by the time of an answer and its relative error or right digits. Crosses at the edge: no answer, or \
                      an error above 10. Thin line: u·max(1, condition), what any method in double precision is left with."
            .to_owned(),
        panels,
    }
}

fn panel(question: &ComparedQuestion<'_>, colour: impl Fn(&ComparedMethod<'_>) -> Colour) -> Panel {
    let answers = || question.methods.iter().flat_map(|method| &method.answers);
    let [fastest, slowest] = decades(answers().map(|(seconds, _)| *seconds));
    let time = Axis::log("time of an answer", Unit::Si("s"), fastest, slowest);
    let shows_errors = question.attainable.is_some();
    let (x, y) = if shows_errors {
        (time, Axis::log("relative error", Unit::One, 1e-17, LARGEST))
    } else {
        let [_, most] = decades(answers().filter_map(|(_, digits)| *digits));
        (Axis::log("right digits", Unit::One, 10.0, most), time)
    };
    let edge = y.range().1;
    // An equation stays in one line.
    let heading = question.title.replace("κ_n", "κ_{n}").replace(" = ", "\u{a0}=\u{a0}");
    let mut panel = Panel::new(&heading, x, y);
    if let Some(digits) = question.attainable {
        let line = [fastest, slowest].map(|time| [time, 10_f64.powf(-digits)]).to_vec();
        let attainable = Layer::curve("attainable", line, Stroke::Thin);
        panel.layers.push(attainable.meaning("left to any method in double precision"));
    }
    let place = |(seconds, digits): &(f64, Option<f64>)| match *digits {
        Some(digits) if !shows_errors => Some([digits, *seconds]),
        Some(digits) if digits > -LARGEST.log10() => Some([*seconds, 10_f64.powf(-digits)]),
        _ => None,
    };
    for method in &question.methods {
        let reached = method.answers.iter().filter_map(place).collect();
        let failed = method.answers.iter().filter(|answer| shows_errors && place(answer).is_none());
        let failed = failed.map(|(seconds, _)| [*seconds, edge]).collect();
        let (mark, by) = if method.textbook { (Mark::Open, " (textbook)") } else { (Mark::Filled, "") };
        panel.series(&format!("{}{by}", method.name), reached, mark, colour(method));
        panel.layers.push(Layer::marks("no answer", failed, Mark::Cross).coloured(colour(method)));
    }
    panel
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
    fn axes_are_whole_decades() {
        let [lower, upper] = decades([3e-9, 2e-4].into_iter());
        assert!((lower / 1e-9 - 1.0).abs() < 1e-9 && (upper / 1e-3 - 1.0).abs() < 1e-9, "{lower} to {upper}");
        assert_eq!(decades(std::iter::empty()), [1.0, 10.0]);
    }
}
