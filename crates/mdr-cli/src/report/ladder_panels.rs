//! From the ladders of a family to the picture.

use mdr_crosscheck::ladders::{Family, Ladder, Rung};

use super::ladders::{kept, loss, ulp};
use crate::picture::{Axis, Key, Layer, Mark, Panel, Picture, Point, Side, Stroke};

/// Functions that lose most, and functions whose textbook formulas lose most: two curves each.
const WORST: usize = 4;
const TEXTBOOKS: usize = 2;

/// One ladder after the other: shipped, and textbooks.
const MARKS: [(Mark, Mark); WORST] = [
    (Mark::Filled, Mark::Open),
    (Mark::Square, Mark::OpenSquare),
    (Mark::Triangle, Mark::OpenTriangle),
    (Mark::Diamond, Mark::OpenDiamond),
];

/// Of a curve with more marks some are left out.
const MOST_MARKS: usize = 20;

/// log₁₀ of errors in ulp: what is smaller is drawn here, what is larger is drawn as failed.
const LEAST: f64 = -2.0;
const MOST: f64 = 20.0;

/// Height of the row of failures, as a fraction of the frame, and the room that is left free for it.
const FAILURES: f64 = 0.95;
const ROOM: f64 = 0.12;

/// The worst of a family.
pub(super) fn picture(family: Family, ladders: &[&Ladder]) -> Picture {
    let title = format!("Errors as {}", family.title());
    let shipped = first(ladders, WORST, |ladder| loss(ladder).min(f64::MAX));
    let textbooks = first(ladders, TEXTBOOKS, textbook_loss);
    let mut panels = vec![panel("Shipped: the largest excess losses".to_owned(), &shipped, false)];
    if !textbooks.is_empty() {
        panels.push(panel("Beside formulas of textbooks".to_owned(), &textbooks, true));
    }
    let description = format!(
        "{title}, in units in the last place. Thin: max(1, condition) ulp. Crosses: wrong, declined, or beyond 10²⁰ ulp. \
         The worst of {} ladders.",
        ladders.len()
    );
    Picture { title, description, panels }
}

/// Those of the largest finite key, one a function.
fn first<'a>(ladders: &[&'a Ladder], most: usize, key: impl Fn(&Ladder) -> f64) -> Vec<&'a Ladder> {
    let mut sorted: Vec<(f64, &Ladder)> = ladders.iter().map(|ladder| (key(ladder), *ladder)).collect();
    sorted.retain(|(key, _)| key.is_finite());
    sorted.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    let mut chosen: Vec<&Ladder> = Vec::new();
    for (_, ladder) in sorted {
        let function = |ladder: &Ladder| ladder.function.split(',').next().map(str::to_owned);
        if chosen.len() < most && chosen.iter().all(|known| function(known) != function(ladder)) {
            chosen.push(ladder);
        }
    }
    chosen
}

/// Digits that the formula of textbooks loses beyond what the question costs, summed over the rungs; at most all 16 of a rung,
/// and no loss but a failure where there is no number: curves tell more.
fn textbook_loss(ladder: &Ladder) -> f64 {
    let digits = |rung: &Rung| Some((rung.naive_ulp.filter(|ulp| ulp.is_finite())? / rung.attainable()).log10());
    let losses = || ladder.rungs.iter().filter_map(digits);
    if losses().next().is_none() { f64::NAN } else { losses().map(|digits| digits.clamp(0.0, 16.0)).sum() }
}

/// Ladders in one frame.
fn panel(heading: String, ladders: &[&Ladder], textbooks: bool) -> Panel {
    let (x, y) = (horizontal(ladders), vertical(ladders, textbooks));
    let edge = y.at(FAILURES);
    let (mut layers, mut legend) = (Vec::new(), Vec::new());
    for ((letter, ladder), (filled, open)) in ('A'..).zip(ladders).zip(MARKS) {
        let name = format!("{}: {}", ladder.function, ladder.toward);
        let (points, failures) = drawn(ladder, edge, ulp, |rung| !rung.accepted() && ulp(rung).is_none());
        let anchors: Vec<_> = points.iter().rev().copied().collect();
        layers.push(guide(ladder));
        layers.extend(label(letter, anchors, Side::Above).into_iter().chain(label(
            letter,
            failures.clone(),
            Side::Below,
        )));
        layers.extend(series(&name, points, failures, Stroke::Solid, filled));
        legend.push((Key::Series(Stroke::Solid, filled), typeset(&format!("{letter}  {}:", ladder.function))));
        legend.push((Key::Text, typeset(&ladder.toward)));
        if let (true, Some(formula)) = (textbooks, &ladder.naive) {
            let (points, failures) = drawn(ladder, edge, |rung| rung.naive_ulp, |_| false);
            layers.extend(series(&format!("{name}, {formula}"), points, failures, Stroke::Dashed, open));
            legend.push((Key::Series(Stroke::Dashed, open), typeset(formula)));
        }
    }
    legend.push((Key::Line(Stroke::Thin), "max(1, condition)".to_owned()));
    if layers.iter().any(|layer| matches!(layer, Layer::Marks { mark: Mark::Cross, .. })) {
        legend.push((Key::Mark(Mark::Cross), "failed".to_owned()));
    }
    Panel { heading, x, y, layers, legend, aspect: 0.5 }
}

/// A letter at points, where there are any.
fn label(letter: char, anchors: Vec<Point>, side: Side) -> Option<Layer> {
    (!anchors.is_empty()).then(|| Layer::Label { text: letter.to_string(), anchors, side })
}

/// Errors by growing parameter, and what failed, at the edge.
fn drawn(
    ladder: &Ladder,
    edge: f64,
    error: impl Fn(&Rung) -> Option<f64>,
    failed: impl Fn(&Rung) -> bool,
) -> (Vec<Point>, Vec<Point>) {
    let (mut points, mut failures) = (Vec::new(), Vec::new());
    for rung in kept(ladder, ladder.rungs.len().div_ceil(MOST_MARKS).max(1)) {
        let Some(x) = place(rung) else { continue };
        match error(rung).map(f64::log10) {
            Some(y) if y <= MOST => points.push([x, y.max(LEAST)]),
            Some(_) => failures.push([x, edge]),
            None if failed(rung) => failures.push([x, edge]),
            None => {}
        }
    }
    points.sort_by(|a: &Point, b| a[0].total_cmp(&b[0]));
    (points, failures)
}

/// What the question costs.
fn guide(ladder: &Ladder) -> Layer {
    let (points, _) = drawn(ladder, MOST, |rung| rung.condition.map(|_| rung.attainable()), |_| false);
    Layer::Curve { name: "max(1, condition)".to_owned(), points, stroke: Stroke::Thin }
}

fn series(name: &str, points: Vec<Point>, failures: Vec<Point>, stroke: Stroke, mark: Mark) -> Vec<Layer> {
    let mut layers = vec![
        Layer::Curve { name: name.to_owned(), points: points.clone(), stroke },
        Layer::Marks { name: name.to_owned(), points, mark },
    ];
    if !failures.is_empty() {
        layers.push(Layer::Marks { name: format!("{name}: failed"), points: failures, mark: Mark::Cross });
    }
    layers
}

/// log₁₀ of the parameter.
fn place(rung: &Rung) -> Option<f64> {
    Some(rung.parameter.abs().log10()).filter(|x| x.is_finite())
}

/// Whole decades around all parameters, named where they are the same.
fn horizontal(ladders: &[&Ladder]) -> Axis {
    let places = ladders.iter().flat_map(|ladder| ladder.rungs.iter().filter_map(place));
    let (lower, upper) = ends(places);
    let mut names: Vec<_> = ladders.iter().map(|ladder| ladder.axis.as_str()).collect();
    names.dedup();
    let name = if let [name] = names[..] { typeset(name) } else { "parameter".to_owned() };
    let margin = 0.02 * (upper - lower);
    Axis::powers(name, lower - margin, upper + margin)
}

/// All errors that are drawn, and room for failures.
fn vertical(ladders: &[&Ladder], textbooks: bool) -> Axis {
    let errors = ladders.iter().flat_map(|ladder| &ladder.rungs).flat_map(|rung| {
        let textbook = rung.naive_ulp.filter(|_| textbooks);
        [ulp(rung), textbook, rung.condition.map(|_| rung.attainable())]
    });
    let heights = errors.flatten().map(|ulp| ulp.log10().max(LEAST)).filter(|y| *y <= MOST);
    let (_, upper) = ends(heights.chain([LEAST, 1.0]));
    Axis::powers("error in ulp", LEAST - 0.3, upper + ROOM * (upper - LEAST))
}

fn ends(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (lower, upper) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, u), x| (x.min(l), x.max(u)));
    if lower <= upper { (lower.floor(), upper.ceil()) } else { (-1.0, 1.0) }
}

/// A text of ladders in the markup of pictures: 10^-300 is raised, and the asterisk of E* stays one.
fn typeset(text: &str) -> String {
    let mut parts = text.split("10^");
    let mut typeset = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let end = part.find(|c: char| c != '-' && !c.is_ascii_digit()).unwrap_or(part.len());
        let (power, rest) = part.split_at(end);
        typeset.push_str(&format!("10^{{{}}}{rest}", power.replace('-', "−")));
    }
    typeset.replace('*', "∗")
}

#[cfg(test)]
mod tests {
    use mdr_crosscheck::ladders::Found;

    use super::*;

    fn rung(parameter: f64, found: Found, naive_ulp: Option<f64>) -> Rung {
        Rung { parameter, inputs: vec![parameter], condition: Some(10.0), found, naive_ulp }
    }

    fn ladder(function: &str, rungs: Vec<Rung>) -> Ladder {
        Ladder {
            function: function.to_owned(),
            family: Family::Scale,
            toward: "E* → 10^-300".to_owned(),
            axis: "E*".to_owned(),
            inputs: vec!["E*".to_owned()],
            naive: Some("of old".to_owned()),
            rungs,
        }
    }

    /// What fails is above everything else; what says truly that there is no double is no failure.
    #[test]
    fn failures_are_at_the_upper_edge() {
        let number = Found::Number { ulp: 0.5, excess: -1.3 };
        let rungs = vec![
            rung(1.0, number, Some(1e3)),
            rung(1e-100, Found::Wrong("NaN".to_owned()), Some(f64::INFINITY)),
            rung(1e-200, Found::Beyond { excess: 0.0 }, None),
            rung(1e-300, Found::Declined("no convergence".to_owned()), Some(1e30)),
        ];
        let ladder = ladder("f", rungs);
        let panel = panel(String::new(), &[&ladder], true);
        let marks = |wanted: Mark| -> Vec<Point> {
            let layers = panel.layers.iter().filter_map(|layer| match layer {
                Layer::Marks { points, mark, .. } if *mark == wanted => Some(points.clone()),
                _ => None,
            });
            layers.flatten().collect()
        };
        assert_eq!((marks(Mark::Filled), marks(Mark::Open)), (vec![[0.0, 0.5_f64.log10()]], vec![[0.0, 3.0]]));
        let crosses = marks(Mark::Cross);
        assert_eq!(crosses.iter().map(|[x, _]| *x).collect::<Vec<_>>(), [-100.0, -300.0, -100.0, -300.0]);
        let (_, top) = panel.y.range();
        assert!(crosses.iter().all(|[_, y]| (3.1..top).contains(y)), "{crosses:?}");
    }

    /// Two numbers of one function are one function.
    #[test]
    fn the_worst_functions_are_drawn() {
        let losing = |function: &str, excess: f64| {
            ladder(function, vec![rung(1.0, Found::Number { ulp: 10_f64.powf(excess), excess }, None)])
        };
        let all = [losing("f, a", 0.5), losing("g", -1.0), losing("f, b", 0.7), losing("h", 0.6), losing("i", -2.0)];
        let all: Vec<_> = all.iter().collect();
        let chosen: Vec<_> = first(&all, 3, loss).iter().map(|ladder| ladder.function.as_str()).collect();
        assert_eq!(chosen, ["f, b", "h", "g"]);
        assert_eq!(picture(Family::Scale, &all).panels.len(), 1, "no textbook has a number");
    }

    #[test]
    fn powers_are_raised() {
        assert_eq!(typeset("E* → 10^-300, n < 1/2"), "E∗ → 10^{−300}, n < 1/2");
        assert_eq!(typeset("w → 10^200"), "w → 10^{200}");
        assert_eq!(typeset("n → 1/2"), "n → 1/2");
    }
}
