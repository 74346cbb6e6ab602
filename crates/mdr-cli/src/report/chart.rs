//! One SVG for each task: a panel for each question, a curve for each method, both axes logarithmic. Methods of this workspace
//! have filled marks, those of textbooks open ones.

use mdr_crosscheck::work_precision::{Comparison, Outcome, Point, Series, Task};
use mdr_plot::{Axis, Colour, Layer, Mark, Panel, Picture, Stroke, Unit};

/// An error beyond this is drawn as a failure.
const LARGEST: f64 = 10.0;

/// What the axes are.
#[derive(Clone, Copy, PartialEq)]
enum View {
    /// Time to the right, relative error upwards.
    Error,
    /// Right digits to the right, time upwards.
    Digits,
}

/// The chart of a task.
pub(super) fn picture(task: &Task, comparisons: &[Comparison]) -> Picture {
    let mut methods: Vec<&str> = Vec::new();
    for series in comparisons.iter().flat_map(|comparison| &comparison.series) {
        if !methods.contains(&series.method) {
            methods.push(series.method);
        }
    }
    let colour = |series: &Series| {
        Colour::series(methods.iter().position(|method| *method == series.method).unwrap_or_default())
    };
    let mut panels: Vec<Panel> = comparisons.iter().map(|comparison| panel(comparison, colour)).collect();
    if let Some((first, others)) = panels.split_first_mut() {
        // One legend is enough: the first panel has those of all.
        for layer in others.iter_mut().flat_map(|panel| &mut panel.layers) {
            let legend = layer.legend.take();
            first.layers.push(Layer { name: String::new(), points: Vec::new(), legend, ..*layer });
        }
    }
    Picture {
        title: task.title.to_owned(),
        description: "Methods by the time of an answer and its relative error or right digits. Crosses at the edge: no answer, or \
                      an error above 10. Thin line: u·max(1, condition), what any method in double precision is left with."
            .to_owned(),
        panels,
    }
}

fn panel(comparison: &Comparison, colour: impl Fn(&Series) -> Colour) -> Panel {
    let view = if comparison.attainable.is_some() { View::Error } else { View::Digits };
    let points = || comparison.series.iter().flat_map(|series| &series.points);
    let [fastest, slowest] = decades(points().filter_map(|point| point.seconds));
    let time = Axis::log("time of an answer", Unit::Si("s"), fastest, slowest);
    let (x, y) = match view {
        View::Error => (time, Axis::log("relative error", Unit::One, 1e-17, LARGEST)),
        View::Digits => {
            let [_, most] = decades(points().filter_map(|point| point.outcome.digits()));
            (Axis::log("right digits", Unit::One, 10.0, most), time)
        }
    };
    let edge = y.range().1;
    let mut panel = Panel::new(&comparison.title, x, y);
    if let Some(digits) = comparison.attainable {
        let line = [fastest, slowest].map(|time| [time, 10_f64.powf(-digits)]).to_vec();
        let attainable = Layer::curve("attainable", line, Stroke::Thin);
        panel.layers.push(attainable.meaning("left to any method in double precision"));
    }
    for series in &comparison.series {
        let (reached, failed): (Vec<_>, Vec<_>) =
            series.points.iter().filter_map(|point| place(view, point, edge)).partition(|(_, reached)| *reached);
        let [reached, failed] = [reached, failed].map(|points| points.into_iter().map(|(place, _)| place).collect());
        let (mark, by) = if series.ours { (Mark::Filled, "") } else { (Mark::Open, " (textbook)") };
        panel.series(&format!("{}{by}", series.method), reached, mark, colour(series));
        panel.layers.push(Layer::marks("no answer", failed, Mark::Cross).coloured(colour(series)));
    }
    panel
}

/// Where a point is, and whether an answer was reached; none without a time.
fn place(view: View, point: &Point, edge: f64) -> Option<(mdr_plot::Point, bool)> {
    let seconds = point.seconds?;
    match (view, &point.outcome) {
        (View::Error, Outcome::Digits(digits) | Outcome::AtLeast(digits)) if *digits > -LARGEST.log10() => {
            Some(([seconds, 10_f64.powf(-digits)], true))
        }
        (View::Error, _) => Some(([seconds, edge], false)),
        (View::Digits, outcome) => outcome.digits().map(|digits| ([digits, seconds], true)),
    }
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
