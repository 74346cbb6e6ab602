//! Answers that were judged by certified records: where they lose their digits.

use mdr_reference::{Judged, Limits, Range, Report, UNIT_ROUNDOFF, Verdict};

use crate::{Axis, Colour, Layer, Mark, Panel, Picture, Point, Stroke, Unit, typographic};

/// Where answers stand that have no right digit, below the line of zero digits.
const NO_DIGIT: f64 = -1.0;

/// Where numbers stand that are out of the range of doubles, 10^±308.
const BEYOND: f64 = 330.0;

/// How verdicts are marked, the worst over the others.
const MARKS: [(Verdict, Mark, Colour); 3] = [
    (Verdict::Right, Mark::Open, Colour::Blue),
    (Verdict::Inaccurate, Mark::Filled, Colour::Ink),
    (Verdict::Wrong, Mark::Diamond, Colour::Orange),
];

/// Right digits against the condition of the question and the distance to a fold; excess loss against the size of the
/// numbers in it. A panel without an answer is left out.
pub fn judged(report: &Report<'_>, limits: &Limits) -> Picture {
    let panels = [by_condition(report), by_fold_distance(report), by_size(report, limits)];
    let heads = panels.into_iter().flatten().zip(["(a)", "(b)", "(c)"]);
    let panels = heads.map(|(panel, letter)| Panel { heading: format!("{letter} {}", panel.heading), ..panel });
    Picture {
        title: "Answers, judged by certified records".to_owned(),
        description: caption(report, limits),
        panels: panels.collect(),
    }
}

/// Right digits, with the line that the condition leaves.
fn by_condition(report: &Report<'_>) -> Option<Panel> {
    let condition =
        |judged: &Judged<'_>| judged.record.value.as_ref().map(|_| judged.record.total_condition().max(1.0));
    let heights = Heights::digits(report);
    let most = decade(report.judged.iter().filter_map(condition), f64::max)?;
    let x = Axis::log("condition of the question", Unit::One, 1.0, most.max(100.0));
    let (first, last) = x.range();
    let left = |condition: f64| [condition, -(UNIT_ROUNDOFF * condition).log10()];
    let line = Layer::curve("what rounding the inputs leaves", vec![left(first), left(last)], Stroke::Solid);
    let mut panel = heights.panel("Right digits, and those that rounding the inputs leaves", report, x, condition);
    panel.layers.insert(0, line.meaning("attainable"));
    Some(panel)
}

/// Right digits of equilibria beside a fold, and far from it.
fn by_fold_distance(report: &Report<'_>) -> Option<Panel> {
    let distance = |judged: &Judged<'_>| judged.record.fold_distance().filter(|distance| *distance > 0.0);
    let distances = || report.judged.iter().filter_map(distance);
    let (least, most) = (decade(distances(), f64::min)?, decade(distances(), f64::max)?);
    let x = Axis::log("relative distance to the fold", Unit::One, least, most);
    Some(Heights::digits(report).panel("Right digits beside a fold", report, x, distance))
}

/// Excess loss by the largest power of ten of the question.
fn by_size(report: &Report<'_>, limits: &Limits) -> Option<Panel> {
    let size = |judged: &Judged<'_>| judged.record.decades().min(BEYOND);
    let upper = report.judged.iter().map(size).fold(1.0, f64::max).ceil() + 1.0;
    let x = Axis::linear("largest |log_{10}| of inputs and value", Unit::One, 0.0, upper);
    let (first, last) = x.range();
    let ends = vec![[first, limits.excess_loss], [last, limits.excess_loss]];
    let limit = Layer::curve("limit of the judge", ends, Stroke::Dashed);
    let mut panel = Heights::loss(report)
        .panel("Digits lost beyond what the question costs", report, x, |judged| Some(size(judged)));
    panel.layers.insert(0, limit.meaning("inaccurate above"));
    (report.answered() > 0).then_some(panel)
}

/// A vertical axis, and where on it an answer stands.
struct Heights {
    axis: Axis,
    of: fn(&Judged<'_>) -> Option<f64>,
    /// Where answers stand that have no right digit, and those that are exact.
    edges: (f64, f64),
}

impl Heights {
    fn digits(report: &Report<'_>) -> Self {
        let of = |judged: &Judged<'_>| judged.mark.lre.map(|lre| lre.low);
        let most = report.judged.iter().filter_map(of).filter(|digits| digits.is_finite()).fold(17.0, f64::max);
        let exact = most.ceil() + 1.0;
        let axis = Axis::linear("right digits", Unit::One, NO_DIGIT - 1.0, exact + 1.0);
        Heights { axis, of, edges: (NO_DIGIT, exact) }
    }

    fn loss(report: &Report<'_>) -> Self {
        let of = |judged: &Judged<'_>| {
            judged.mark.excess_loss.map(|loss| if loss.low.is_finite() { loss.low } else { loss.high })
        };
        let losses = || report.judged.iter().filter_map(of).filter(|loss| loss.is_finite());
        let (least, most) = (losses().fold(-3.0, f64::min).floor() - 1.0, 17.0);
        let axis = Axis::linear("excess loss in digits", Unit::One, least - 1.0, most + 1.0);
        Heights { axis, of, edges: (most, least) }
    }

    /// The height of an answer. One of no right digit, or of the wrong kind, stands at the edge; `None` for a right answer
    /// without a number.
    fn height(&self, judged: &Judged<'_>) -> Option<f64> {
        let (nothing, exact) = self.edges;
        match judged.mark.lre {
            Some(Range { high, .. }) if high <= 0.0 => Some(nothing),
            Some(Range { low, .. }) if low.is_infinite() => Some(exact),
            Some(_) => (self.of)(judged),
            None => (judged.mark.verdict != Verdict::Right).then_some(nothing),
        }
    }

    /// The answers that have a place on `x`, by their verdicts.
    fn panel(self, heading: &str, report: &Report<'_>, x: Axis, place: impl Fn(&Judged<'_>) -> Option<f64>) -> Panel {
        let mut panel = Panel::new(heading, x, self.axis.clone());
        for (verdict, mark, colour) in MARKS {
            let of_verdict = report.judged.iter().filter(|judged| judged.mark.verdict == verdict);
            let points: Vec<Point> =
                of_verdict.filter_map(|judged| Some([place(judged)?, self.height(judged)?])).collect();
            if !points.is_empty() {
                panel.layers.push(Layer::marks(verdict.name(), points, mark).coloured(colour).meaning(verdict.name()));
            }
        }
        if panel.layers.iter().flat_map(|layer| &layer.points).any(|[_, y]| *y == self.edges.0) {
            panel.note(format!("at {}: no right digit", typographic(&self.edges.0.round().to_string())));
        }
        panel
    }
}

/// The power of ten beyond the least or the largest of some numbers.
fn decade(values: impl Iterator<Item = f64>, pick: fn(f64, f64) -> f64) -> Option<f64> {
    let extreme = values.reduce(pick)?.log10();
    let beyond = if pick(0.0, 1.0) > 0.0 { extreme.floor() + 1.0 } else { extreme.ceil() - 1.0 };
    Some(10_f64.powf(beyond))
}

/// The caption: the picture in words and numbers.
fn caption(report: &Report<'_>, limits: &Limits) -> String {
    let count = |verdict| report.count(verdict);
    let mut text = format!(
        "{} of {} questions answered: {} right, {} inaccurate, {} wrong. Right digits are −log₁₀ of the relative error; \
         excess loss is log₁₀(error/(u max(1, condition))), u = 2⁻⁵³, and an answer that claims no error is inaccurate where it \
         exceeds {}. Answers with no right digit, and those of the wrong kind, such as NaN or a number where there is none, \
         stand at −1 digits and at a loss of 17, exact ones at the opposite edge, and numbers beyond the range of doubles at a size \
         of 330. Right answers that there is no number are not drawn.",
        report.answered(),
        report.questions(),
        count(Verdict::Right),
        count(Verdict::Inaccurate),
        count(Verdict::Wrong),
        typographic(&limits.excess_loss.to_string()),
    );
    for class in report.classes() {
        let [right, inaccurate, wrong] = class.verdicts;
        let answered = right + inaccurate + wrong;
        let losses = class.excess_loss.map_or_else(String::new, |(median, largest)| {
            format!("; excess loss {} in the median, {} at most", tenths(median), tenths(largest))
        });
        if answered > 0 {
            text.push_str(&format!(
                " Difficulty {}: {right} right, {inaccurate} inaccurate, {wrong} wrong{losses}.",
                class.difficulty
            ));
        }
    }
    text
}

fn tenths(x: f64) -> String {
    if x.is_finite() { typographic(&format!("{x:.1}")) } else { "exact".to_owned() }
}
