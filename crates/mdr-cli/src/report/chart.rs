//! One SVG for each task: a panel for each question, a curve for each method, both axes logarithmic.
//!
//! Colours are those of Okabe and Ito, which readers with any colour vision tell apart (yellow, too faint on white, is
//! grey). Methods of this workspace have filled marks, those of textbooks open ones.

use std::ops::Range;

use mdr_crosscheck::work_precision::{Comparison, Outcome, Point, Series, Task};
use plotters::coord::Shift;
use plotters::prelude::*;

use super::page::time;
use crate::error::{Failure, Result};

const COLOURS: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    BLACK,
    RGBColor(120, 120, 120),
];

const COLUMNS: usize = 2;
/// Width and height of a panel, height of a line of text.
const PANEL: (u32, u32) = (480, 330);
const LINE: u32 = 24;

/// An error beyond this is drawn as a failure.
const LARGEST: f64 = 10.0;

/// What is drawn beside the curves of double precision.
const NOTE: &str = "Thin line: u·max(1, condition), what any method in double precision is left with. Crosses: no answer, or an error above 10.";

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn<T = ()> = std::result::Result<T, Box<dyn std::error::Error + Send + Sync>>;

/// What the axes are.
#[derive(Clone, Copy, PartialEq)]
enum View {
    /// Time to the right, relative error upwards.
    Error,
    /// Right digits to the right, time upwards.
    Digits,
}

/// The SVG of a task.
pub(super) fn svg(task: &Task, comparisons: &[Comparison]) -> Result<String> {
    let mut svg = String::new();
    draw(&mut svg, task, comparisons).map_err(|error| Failure::file(task.name, std::io::Error::other(error)))?;
    // The first tag opens the document.
    Ok(svg.replacen(">\n", &format!(">\n<title>{}</title>\n", task.title), 1))
}

fn draw(svg: &mut String, task: &Task, comparisons: &[Comparison]) -> Drawn {
    let mut methods: Vec<&Series> = Vec::new();
    for series in comparisons.iter().flat_map(|comparison| &comparison.series) {
        if methods.iter().all(|known| known.method != series.method) {
            methods.push(series);
        }
    }
    let rows = comparisons.len().div_ceil(COLUMNS);
    let legend = LINE * (methods.len().div_ceil(COLUMNS) as u32 + 3);
    let size = (PANEL.0 * COLUMNS as u32, legend + PANEL.1 * rows as u32);
    let area = SVGBackend::with_string(svg, size).into_drawing_area();
    area.fill(&WHITE)?;
    let (top, panels) = area.split_vertically(legend);
    top.draw(&Text::new(task.title, (12, 10), ("sans-serif", 17)))?;
    for (index, series) in methods.iter().enumerate() {
        let place = |x: i32| (12 + x, LINE as i32 * (2 + (index / COLUMNS) as i32));
        let left = PANEL.0 as i32 * (index % COLUMNS) as i32;
        let line = PathElement::new([place(left), place(left + 30)], COLOURS[index % COLOURS.len()].stroke_width(2));
        top.draw(&line)?;
        top.draw(&mark(place(left + 15), index, series.ours))?;
        let by = if series.ours { "" } else { " (textbook)" };
        let (x, y) = place(left + 38);
        top.draw(&Text::new(format!("{}{by}", series.method), (x, y - 7), ("sans-serif", 14)))?;
    }
    if comparisons.iter().any(|comparison| comparison.attainable.is_some()) {
        top.draw(&Text::new(NOTE, (12, legend as i32 - LINE as i32 - 4), ("sans-serif", 13)))?;
    }
    let index_of = |series: &Series| methods.iter().position(|known| known.method == series.method).unwrap_or_default();
    for (comparison, area) in comparisons.iter().zip(panels.split_evenly((rows, COLUMNS))) {
        panel(&area, comparison, index_of)?;
    }
    area.present()?;
    Ok(())
}

fn mark<C>(at: C, index: usize, filled: bool) -> Circle<C, i32> {
    let colour = COLOURS[index % COLOURS.len()];
    Circle::new(at, 4, if filled { colour.filled() } else { colour.stroke_width(1) })
}

fn panel(area: &Area<'_>, comparison: &Comparison, index_of: impl Fn(&Series) -> usize) -> Drawn {
    let view = if comparison.attainable.is_some() { View::Error } else { View::Digits };
    let points = || comparison.series.iter().flat_map(|series| &series.points);
    let times = decades(points().filter_map(|point| point.seconds));
    let (x, y) = match view {
        View::Error => (times, 1e-17..LARGEST),
        View::Digits => (10.0..decades(points().filter_map(|point| point.outcome.digits())).end, times),
    };
    let edge = y.end;
    let mut chart = ChartBuilder::on(area)
        .caption(&comparison.title, ("sans-serif", 15))
        .margin(12)
        .margin_right(20)
        .x_label_area_size(45)
        .y_label_area_size(75)
        .build_cartesian_2d(x.clone().log_scale(), y.log_scale())?;
    let (seconds, error, digits) = (|x: &f64| time(*x), |x: &f64| power(*x), |x: &f64| format!("{x:.0}"));
    let mut mesh = chart.configure_mesh();
    mesh.light_line_style(WHITE.mix(0.0)).bold_line_style(BLACK.mix(0.12)).x_labels(8).y_labels(8);
    match view {
        View::Error => mesh.x_desc("time of an answer").x_label_formatter(&seconds),
        View::Digits => mesh.x_desc("right digits").x_label_formatter(&digits),
    };
    match view {
        View::Error => mesh.y_desc("relative error").y_label_formatter(&error),
        View::Digits => mesh.y_desc("time of an answer").y_label_formatter(&seconds),
    };
    mesh.draw()?;
    if let Some(digits) = comparison.attainable {
        let error = 10_f64.powf(-digits);
        let line = vec![(x.start, error), (x.end, error)];
        chart.draw_series([PathElement::new(line, BLACK.stroke_width(1))])?;
    }
    for series in &comparison.series {
        let index = index_of(series);
        let colour = COLOURS[index % COLOURS.len()];
        let (reached, failed): (Vec<_>, Vec<_>) =
            series.points.iter().filter_map(|point| place(view, point, edge)).partition(|(_, reached)| *reached);
        let line: Vec<_> = reached.into_iter().map(|(place, _)| place).collect();
        chart.draw_series([PathElement::new(line.clone(), colour.stroke_width(2))])?;
        chart.draw_series(line.into_iter().map(|place| mark(place, index, series.ours)))?;
        chart.draw_series(failed.into_iter().map(|(place, _)| Cross::new(place, 4, colour.stroke_width(2))))?;
    }
    Ok(())
}

/// Where a point is, and whether an answer was reached; none without a time.
fn place(view: View, point: &Point, edge: f64) -> Option<((f64, f64), bool)> {
    let seconds = point.seconds?;
    match (view, &point.outcome) {
        (View::Error, Outcome::Digits(digits) | Outcome::AtLeast(digits)) if *digits > -LARGEST.log10() => {
            Some(((seconds, 10_f64.powf(-digits)), true))
        }
        (View::Error, _) => Some(((seconds, edge), false)),
        (View::Digits, outcome) => outcome.digits().map(|digits| ((digits, seconds), true)),
    }
}

/// Whole decades around values, at least one.
fn decades(values: impl Iterator<Item = f64>) -> Range<f64> {
    let (least, most) = values.fold((f64::INFINITY, 0.0), |(least, most), x: f64| (x.min(least), x.max(most)));
    if least > most {
        return 1.0..10.0;
    }
    let lower = least.log10().floor();
    10_f64.powf(lower)..10_f64.powf(most.log10().ceil().max(lower + 1.0))
}

/// A power of ten as one writes it.
fn power(x: f64) -> String {
    let exponent = format!("{:.0}", x.log10());
    let raised = exponent.chars().map(|c| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => digit.to_digit(10).and_then(|digit| char::from_u32(0x2070 + digit)).unwrap_or(digit),
    });
    format!("10{}", raised.collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_powers_of_ten_and_axes_whole_decades() {
        assert_eq!([1e-16, 1.0, 1e-3].map(power), ["10⁻¹⁶", "10⁰", "10⁻³"]);
        let found = decades([3e-9, 2e-4].into_iter());
        assert!((found.start / 1e-9 - 1.0).abs() < 1e-9 && (found.end / 1e-3 - 1.0).abs() < 1e-9, "{found:?}");
        assert_eq!(decades(std::iter::empty()), 1.0..10.0);
    }
}
