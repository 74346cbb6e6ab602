//! The picture that stands first: one row a question, one mark a contestant.

use mdr_crosscheck::contest::speed::Race;
use mdr_crosscheck::contest::{Arithmetic, Diagram, View};
use mdr_crosscheck::ladders::{Ladder, MOST_EXCESS};

use super::diagram::MARKS;
use super::store::Section;
use super::{ladders, speed, table};
use crate::picture::{Axis, Key, Layer, Mark, Panel, Picture, Stroke, Unit};

/// Digits to which the answers in double precision are compared.
const DIGITS: u32 = 12;

/// The pictures that stand for a task: their files, and what they show.
pub(super) fn files(section: &Section) -> Vec<(String, String)> {
    if drawn(section) {
        let what = match section {
            Section { ladders: Some(_), .. } => "digits lost beyond what the question costs",
            Section { races, .. } if !races.is_empty() => "times faster than others",
            _ => "time to 12 digits",
        };
        return vec![(id(section), what.to_owned())];
    }
    // Of the others the first two tell the story by themselves.
    section.diagrams.iter().take(2).map(|diagram| (diagram.id.clone(), diagram.title.clone())).collect()
}

/// The name of the file.
pub(super) fn id(section: &Section) -> String {
    format!("{}-summary", section.name)
}

/// Whether there is a picture to be drawn by [`picture`] or [`of_ladders`].
fn drawn(section: &Section) -> bool {
    let by_time = section.diagrams.iter().any(|diagram| diagram.view == View::Error);
    by_time || !section.races.is_empty() || section.ladders.is_some()
}

/// Time to some digits, or ratios to others; none where the diagrams speak for themselves.
pub(super) fn picture(section: &Section) -> Option<Picture> {
    if !section.races.is_empty() {
        return Some(ratios(&section.races));
    }
    let diagrams: Vec<_> = section.diagrams.iter().filter(|diagram| diagram.view == View::Error).collect();
    (!diagrams.is_empty()).then(|| times(&section.name, &diagrams))
}

/// A picture of rows: names from top to bottom, and series of points (value, row).
fn rows(title: String, description: String, x: Axis, names: Vec<String>, series: Vec<Series>) -> Picture {
    let height = names.len() as f64;
    let aspect = (height * ROW).max(0.25);
    let (mut layers, mut legend) = (Vec::new(), Vec::new());
    for Series { name, mark, points } in series {
        let points = points.into_iter().map(|(value, row)| [value, height - 0.5 - row as f64]).collect();
        legend.push((Key::Mark(mark), name.clone()));
        layers.push(Layer::Marks { name, points, mark });
    }
    let names = names.into_iter().map(|name| name.replace("κ_n", "κ_{n}")).collect();
    let panel = Panel { heading: title.clone(), x, y: Axis::rows(names), layers, legend, aspect };
    Picture { title, description, panels: vec![panel] }
}

/// The height of a row over the width of the frame.
const ROW: f64 = 0.055;

struct Series {
    name: String,
    mark: Mark,
    /// Values with the numbers of their rows.
    points: Vec<(f64, usize)>,
}

/// An axis over whole decades around these values.
fn decades(quantity: &str, unit: Unit, values: impl Iterator<Item = f64>) -> Axis {
    let ends = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, u), x| (x.min(l), x.max(u)));
    let (lower, upper) = if ends.0 > ends.1 { (1.0, 10.0) } else { ends };
    // Marks do not touch the frame.
    let [lower, upper] = [(lower / 1.2).log10().floor(), (upper * 1.2).log10().ceil()].map(|power| 10f64.powf(power));
    Axis::log(quantity, unit, lower, upper)
}

/// Time to so many digits in double precision.
fn times(task: &str, diagrams: &[&Diagram]) -> Picture {
    let mut found: Vec<(String, Vec<(f64, usize)>)> = Vec::new();
    // What is shipped comes first, then the others in their order.
    for shipped in [true, false] {
        for (row, diagram) in diagrams.iter().enumerate() {
            for curve in diagram.curves.iter().filter(|curve| curve.arithmetic == Arithmetic::Double) {
                if (curve.contestant == diagram.shipped) != shipped {
                    continue;
                }
                let Some(time) = table::cheapest(curve, DIGITS) else { continue };
                let name = table::name(curve);
                match found.iter_mut().find(|(known, _)| *known == name) {
                    Some((_, points)) => points.push((time, row)),
                    None => found.push((name, vec![(time, row)])),
                }
            }
        }
    }
    let x = decades("time", Unit::Si("s"), found.iter().flat_map(|(_, points)| points.iter().map(|point| point.0)));
    let series = found.into_iter().zip(MARKS.into_iter().cycle());
    let series = series.map(|((name, points), mark)| Series { name, mark, points }).collect();
    let names = diagrams.iter().map(|diagram| table::short(diagram).to_owned()).collect();
    let title = format!("{task}: time to {DIGITS} digits in double precision");
    let description = format!("{title}. Who has no mark in a row does not arrive.");
    rows(title, description, x, names, series)
}

/// How many times faster this workspace is.
fn ratios(races: &[Race]) -> Picture {
    let mut questions: Vec<&str> = races.iter().map(|race| race.question.as_str()).collect();
    questions.dedup();
    let mut found: Vec<Series> = Vec::new();
    for race in races {
        let row = questions.iter().position(|question| *question == race.question).unwrap_or_default();
        let point = (speed::ratio(race), row);
        match found.iter_mut().find(|series| series.name == race.setting) {
            Some(series) => series.points.push(point),
            None => {
                found.push(Series {
                    name: race.setting.clone(),
                    mark: MARKS[found.len() % MARKS.len()],
                    points: vec![point],
                });
            }
        }
    }
    let x = decades("times faster than the other project", Unit::One, races.iter().map(speed::ratio).chain([1.0]));
    let title = "This workspace beside other projects".to_owned();
    let description = format!("{title}: the time of the other over ours. The line is equality.");
    let height = questions.len() as f64;
    let mut picture = rows(title, description, x, questions.into_iter().map(str::to_owned).collect(), found);
    picture.panels[0].layers.insert(0, upright(1.0, height));
    picture
}

/// A line across all rows.
fn upright(at: f64, height: f64) -> Layer {
    Layer::Curve { name: String::new(), points: vec![[at, 0.0], [at, height]], stroke: Stroke::Thin }
}

/// Digits lost by every ladder, one row a family of directions.
pub(super) fn of_ladders(all: &[Ladder]) -> Picture {
    let (mut names, mut shipped, mut textbooks) = (Vec::new(), Vec::new(), Vec::new());
    for (row, (family, of_family)) in ladders::families(all).enumerate() {
        names.push(family.name().to_owned());
        let losses = of_family.iter().map(|ladder| ladders::loss(ladder)).filter(|loss| *loss > f64::NEG_INFINITY);
        shipped.extend(losses.map(|loss| (tenths(loss), row)));
        textbooks.extend(of_family.iter().filter_map(|ladder| naive_loss(ladder)).map(|loss| (tenths(loss), row)));
    }
    for points in [&mut shipped, &mut textbooks] {
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        points.dedup();
    }
    let height = names.len() as f64;
    let x = Axis::linear("digits lost beyond what the question costs", Unit::One, LEAST - 0.5, MOST + 0.5);
    let series = |name: &str, mark, points: Vec<(f64, usize)>| Series { name: name.to_owned(), mark, points };
    let title = "Digits lost by the worst question of every ladder".to_owned();
    let description = format!("{title}. The line is what is accepted: one. {MOST} stands for all digits.");
    let found = vec![series("textbooks", Mark::Open, textbooks), series("shipped", Mark::Filled, shipped)];
    let mut picture = rows(title, description, x, names, found);
    picture.panels[0].layers.insert(0, upright(MOST_EXCESS, height));
    picture
}

/// Beyond these nothing is told apart.
const LEAST: f64 = -2.0;
const MOST: f64 = 17.0;

/// Marks nearer than this are one.
fn tenths(loss: f64) -> f64 {
    (10.0 * loss.clamp(LEAST, MOST)).round() / 10.0
}

/// The digits that the formula of textbooks loses, to a factor of two of the error.
fn naive_loss(ladder: &Ladder) -> Option<f64> {
    let losses = ladder.rungs.iter().filter_map(|rung| Some((rung.naive_ulp? / rung.attainable()).log10()));
    losses.max_by(f64::total_cmp)
}
