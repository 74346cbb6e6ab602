//! From a question and its contestants to the picture.

use mdr_crosscheck::contest::{Arithmetic, Curve, Diagram, Outcome, Point, View};

use super::table;
use crate::picture::{self, Axis, Key, Layer, Mark, Panel, Picture, Side, Stroke, Unit};

/// One contestant after the other.
pub(super) const MARKS: [Mark; 10] = [
    Mark::Filled,
    Mark::Open,
    Mark::Square,
    Mark::OpenSquare,
    Mark::Triangle,
    Mark::OpenTriangle,
    Mark::Diamond,
    Mark::OpenDiamond,
    Mark::Inverted,
    Mark::OpenInverted,
];

/// Height of the row of failures, as a fraction of the frame, and the room that is left free for it.
const FAILURES: f64 = 0.95;
const ROOM: f64 = 0.1;

/// An error beyond 10 to this power is a failure.
const WORST: f64 = 6.0;

/// The diagram of a question. Errors of double precision and of more digits have a panel each.
pub(super) fn picture(diagram: &Diagram) -> Picture {
    let (double, more): (Vec<_>, Vec<_>) =
        diagram.curves.iter().cloned().partition(|curve| curve.arithmetic == Arithmetic::Double);
    let panels = if diagram.view == View::Error && !double.is_empty() && !more.is_empty() {
        vec![
            panel(&Diagram { curves: double, ..diagram.clone() }, format!("{}: double precision", diagram.title)),
            panel(
                &Diagram { curves: more, ceiling: None, ..diagram.clone() },
                format!("{}: arbitrary precision", diagram.title),
            ),
        ]
    } else {
        vec![panel(diagram, diagram.title.clone())]
    };
    let description = format!("{}. Truth: {}. Bars: fastest to slowest run.", diagram.title, diagram.truth);
    Picture { title: diagram.title.clone(), description, panels }
}

/// All contestants in one frame.
fn panel(diagram: &Diagram, heading: String) -> Panel {
    let plot = Plot::new(diagram);
    let mut layers = plot.ceiling();
    let mut legend = Vec::new();
    for (index, curve) in diagram.curves.iter().enumerate() {
        let (mark, letter) = (MARKS[index % MARKS.len()], letter(index));
        let stroke = if curve.outside { Stroke::Dashed } else { Stroke::Solid };
        layers.extend(plot.curve(curve, mark, stroke, &letter));
        legend.push((Key::Series(stroke, mark), format!("{letter}  {}", table::name(curve))));
    }
    if layers.iter().any(|layer| matches!(layer, Layer::Marks { mark: Mark::Cross, .. })) {
        legend.push((Key::Mark(Mark::Cross), "failed or stopped".to_owned()));
    }
    Panel { heading, x: plot.x, y: plot.y, layers, legend, aspect: 0.62 }
}

/// A, B, …, Z, A2, B2, …
fn letter(index: usize) -> String {
    let letter = char::from(b'A' + u8::try_from(index % 26).unwrap_or_default());
    if index < 26 { letter.to_string() } else { format!("{letter}{}", index / 26 + 1) }
}

/// A diagram with its axes.
struct Plot<'a> {
    diagram: &'a Diagram,
    x: Axis,
    y: Axis,
}

impl<'a> Plot<'a> {
    fn new(diagram: &'a Diagram) -> Self {
        let placed = || points(diagram).filter_map(|point| coordinates(diagram.view, point));
        let times = || points(diagram).filter_map(|point| point.time);
        let decades = |quantity: &str, unit, values: &mut dyn Iterator<Item = f64>| {
            let (lower, upper) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, u), x| (x.min(l), x.max(u)));
            if lower > upper {
                return (Axis::log(quantity, unit, 1.0, 10.0), 1.0, 10.0);
            }
            let (lower, upper) = (10f64.powf(lower.log10().floor()), 10f64.powf(upper.log10().ceil()));
            (Axis::log(quantity, unit, lower, upper), lower, upper)
        };
        let second = Unit::Si("s");
        let mut spread = times().flat_map(|time| [time.least, time.most]);
        let (time, fastest, slowest) = decades("time", second, &mut spread);
        let room = if points(diagram).any(|point| failed(diagram.view, point)) { ROOM } else { 0.0 };
        let upwards = Axis::log("time", second, fastest, slowest * (slowest / fastest).max(10.0).powf(room));
        match diagram.view {
            View::Error => {
                let (lower, upper) = placed().fold((-17.0_f64, 1.0_f64), |(l, u), [_, y]| (y.min(l), y.max(u)));
                let upper = upper + (room + 0.02) * (upper - lower);
                let lower = if lower < -17.0 { lower - 0.03 * (upper - lower) } else { lower };
                Plot { diagram, x: time, y: Axis::powers("relative error", lower, upper) }
            }
            View::Digits => {
                let (digits, ..) = decades("right digits", Unit::One, &mut placed().map(|[x, _]| x));
                Plot { diagram, x: digits, y: upwards }
            }
            View::Size => {
                let (size, ..) = decades("size", Unit::One, &mut placed().map(|[x, _]| x));
                Plot { diagram, x: size, y: upwards }
            }
        }
    }

    /// What the question leaves to every method in double precision.
    fn ceiling(&self) -> Vec<Layer> {
        let (View::Error, Some(digits)) = (self.diagram.view, self.diagram.ceiling) else { return Vec::new() };
        let at = |fraction: f64| [self.x.at(fraction), -digits];
        let line = Layer::Curve { name: String::new(), points: vec![at(0.0), at(1.0)], stroke: Stroke::Thin };
        let anchors = (1..20).map(|step| at(f64::from(20 - step) / 20.0)).collect();
        vec![line, Layer::Label { text: "*u* max(1, cond)".to_owned(), anchors, side: Side::Above }]
    }

    /// A contestant: its line, spreads, marks, failures at the upper edge, and its letter.
    fn curve(&self, curve: &Curve, mark: Mark, stroke: Stroke, letter: &str) -> Vec<Layer> {
        let view = self.diagram.view;
        let name = || curve.contestant.clone();
        let points: Vec<_> = curve.points.iter().filter_map(|point| coordinates(view, point)).collect();
        let failures: Vec<_> =
            curve.points.iter().filter(|point| failed(view, point)).map(|point| self.at_edge(point)).collect();
        let mut layers = vec![Layer::Curve { name: name(), points: points.clone(), stroke }];
        layers.extend(curve.points.iter().filter_map(|point| spread(view, point)).map(|ends| Layer::Curve {
            name: name(),
            points: ends.to_vec(),
            stroke: Stroke::Thin,
        }));
        let anchors: Vec<_> = points.iter().rev().chain(&failures).copied().collect();
        layers.push(Layer::Marks { name: name(), points, mark });
        if !failures.is_empty() {
            layers.push(Layer::Marks {
                name: format!("{}: failed", curve.contestant),
                points: failures,
                mark: Mark::Cross,
            });
        }
        if !anchors.is_empty() {
            layers.push(Layer::Label { text: letter.to_owned(), anchors, side: Side::Right });
        }
        layers
    }

    /// The place of a failure: when it came, where time runs to the right; else at the right.
    fn at_edge(&self, point: &Point) -> picture::Point {
        let x = match (self.diagram.view, point.time, point.evaluations) {
            (View::Error, Some(time), _) => time.median,
            (View::Size, _, Some(size)) => size as f64,
            _ => self.x.at(0.97),
        };
        [x, self.y.at(FAILURES)]
    }
}

fn points(diagram: &Diagram) -> impl Iterator<Item = &Point> {
    diagram.curves.iter().flat_map(|curve| &curve.points)
}

/// Whether there is no answer, or one that is worse than none.
fn failed(view: View, point: &Point) -> bool {
    match point.outcome {
        Outcome::Failed(_) | Outcome::Stopped(_) => true,
        Outcome::Digits(digits) | Outcome::AtLeast(digits) => digits < -WORST || (view == View::Digits && digits < 0.5),
        Outcome::Passed => false,
    }
}

/// Where a point is; none without a time.
fn coordinates(view: View, point: &Point) -> Option<picture::Point> {
    let time = point.time?.median;
    if failed(view, point) {
        return None;
    }
    Some(match view {
        View::Error => [time, -point.outcome.digits()?],
        View::Digits => [point.outcome.digits()?, time],
        View::Size => [point.evaluations? as f64, time],
    })
}

/// From the fastest to the slowest run, where that is more than the mark.
fn spread(view: View, point: &Point) -> Option<[picture::Point; 2]> {
    let (time, [x, y]) = (point.time?, coordinates(view, point)?);
    (time.most > 1.1 * time.least).then_some(match view {
        View::Error => [[time.least, y], [time.most, y]],
        View::Digits | View::Size => [[x, time.least], [x, time.most]],
    })
}

#[cfg(test)]
pub(super) mod tests {
    use mdr_crosscheck::contest::Time;

    use super::*;

    /// A contestant that doubles its digits, one that fails, and one from outside that has no right digit.
    pub(in super::super) fn contest(view: View) -> Diagram {
        let time = |median: f64| Some(Time { median, least: 0.9 * median, most: 1.2 * median, runs: 3 });
        let point = |setting: String, outcome, nodes: u64| Point {
            setting,
            outcome,
            evaluations: Some(nodes),
            time: time(1e-6 * nodes as f64),
        };
        let nodes = |nodes: u64| format!("{nodes} nodes");
        let doubling = (0..5).map(|k| point(nodes(1 << k), Outcome::Digits(f64::from(1 << k)), 1 << k));
        let broken = vec![point(nodes(7), Outcome::Failed("no convergence".to_owned()), 7)];
        let another = vec![point(nodes(3), Outcome::Digits(-0.5), 3), point(nodes(30), Outcome::AtLeast(0.6), 30)];
        Diagram {
            id: "test-contest".to_owned(),
            task: "test".to_owned(),
            title: "x at y < 1".to_owned(),
            truth: "an enclosure".to_owned(),
            view,
            ceiling: Some(15.95),
            shipped: "doubling".to_owned(),
            curves: vec![
                Curve::new("doubling", Arithmetic::Double, doubling.collect()),
                Curve::new("broken", Arithmetic::Double, broken),
                Curve { outside: true, ..Curve::new("another", Arithmetic::Double, another) },
            ],
            omissions: vec!["nobody else came".to_owned()],
        }
    }

    fn drawn(diagram: &Diagram) -> String {
        let picture = picture(diagram);
        assert_eq!(picture::crowded(&picture), [""; 0], "{}", diagram.id);
        let svg = picture::svg(&picture).unwrap();
        assert!(svg.len() < 100_000, "{}: {} bytes", diagram.id, svg.len());
        svg
    }

    fn texts(svg: &str) -> Vec<String> {
        let document = roxmltree::Document::parse(svg).unwrap();
        let nodes = document.descendants().filter(|node| node.has_tag_name("text"));
        nodes
            .map(|node| node.descendants().filter(|part| part.is_text()).filter_map(|part| part.text()).collect())
            .collect()
    }

    #[test]
    fn everybody_is_named_and_failures_are_drawn() {
        for view in [View::Error, View::Digits, View::Size] {
            let svg = drawn(&contest(view));
            let texts = texts(&svg);
            for text in ["A  doubling", "B  broken", "C  another (outside)", "failed or stopped", "A", "B", "time (s)"]
            {
                assert!(texts.iter().any(|found| found == text), "{text} in {texts:?}");
            }
        }
    }

    /// What fails is above everything else, at the time it took.
    #[test]
    fn a_failure_is_at_the_upper_edge() {
        let diagram = contest(View::Error);
        let layers = picture(&diagram).panels.remove(0).layers;
        let at = |wanted: Mark| {
            layers.iter().find_map(|layer| match layer {
                Layer::Marks { points, mark, .. } if *mark == wanted => Some(points.clone()),
                _ => None,
            })
        };
        let [[time, height]] = at(Mark::Cross).unwrap()[..] else { panic!("one failure") };
        assert_eq!(time, 7e-6);
        let highest = at(Mark::Square).unwrap().into_iter().map(|[_, y]| y).fold(f64::NEG_INFINITY, f64::max);
        assert!(height > highest && highest == 0.5, "{height} above {highest}");
    }

    /// Ten thousand digits are no number of f64, and a mark on paper.
    #[test]
    fn errors_far_below_the_smallest_double() {
        let mut diagram = contest(View::Error);
        diagram.curves[0].points[4].outcome = Outcome::Digits(10_000.0);
        assert!(texts(&drawn(&diagram)).iter().any(|text| text == "10−10000" || text == "10−8000"));
    }

    #[test]
    fn a_contest_without_times_is_drawn_empty() {
        let mut diagram = contest(View::Error);
        for point in diagram.curves.iter_mut().flat_map(|curve| &mut curve.points) {
            point.time = None;
        }
        assert!(texts(&drawn(&diagram)).iter().any(|text| text == "A  doubling"));
    }

    #[test]
    fn more_digits_have_a_panel_of_their_own() {
        let mut diagram = contest(View::Error);
        diagram.curves[0].arithmetic = Arithmetic::Mp;
        let texts = texts(&drawn(&diagram));
        for text in ["x at y < 1: double precision", "x at y < 1: arbitrary precision", "A  broken", "A  doubling"] {
            assert!(texts.iter().any(|found| found == text), "{text} in {texts:?}");
        }
    }

    #[test]
    fn letters() {
        assert_eq!([letter(0), letter(25), letter(26)], ["A", "Z", "A2"]);
    }
}
