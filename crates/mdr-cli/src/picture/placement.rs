//! Where a label goes: beside its anchor, over nothing else.

use super::Side;
use super::geometry::{Rect, Spot, crossing, distance};

/// What labels must not cover.
#[derive(Default)]
pub(crate) struct Obstacles {
    segments: Vec<(Spot, Spot)>,
    boxes: Vec<Rect>,
}

/// Free room around a label.
const GAP: f64 = 14.0;

/// The size of the marks that anchors usually carry.
const CLEARANCE: f64 = 30.0;

impl Obstacles {
    /// A line.
    pub(crate) fn line(&mut self, line: &[Spot]) {
        self.segments.extend(line.windows(2).map(|pair| (pair[0], pair[1])));
    }

    /// A rectangle.
    pub(crate) fn block(&mut self, rect: Rect) {
        self.boxes.push(rect);
    }

    /// How badly a label would cover things: boxes are worse than lines.
    fn covered(&self, label: &Rect) -> f64 {
        let boxes = self.boxes.iter().filter(|other| label.overlaps(other)).count();
        let lines = self.segments.iter().filter(|(from, to)| label.clip(*from, *to).is_some()).count();
        3.0 * boxes as f64 + (lines as f64).min(4.0)
    }

    /// Whether a line passes between a label and its anchor, which would then seem to name that line.
    fn parted(&self, label: &Rect, anchor: Spot) -> bool {
        let centre = [(label.left + label.right) / 2.0, (label.top + label.bottom) / 2.0];
        let reach = distance(centre, anchor, anchor);
        // The line on which the anchor lies does not part them.
        let share = (CLEARANCE / 2.0 / reach).min(1.0);
        let start = [anchor[0] + share * (centre[0] - anchor[0]), anchor[1] + share * (centre[1] - anchor[1])];
        self.segments.iter().any(|(from, to)| crossing((start, centre), (*from, *to)))
    }

    /// The best place for a label of the given size, inside `frame` and beside one of the anchors, the first preferred.
    /// Its rectangle, and how much it covers in spite of all: 0 when it is free.
    pub(crate) fn place(&self, frame: &Rect, anchors: &[Spot], size: (f64, f64), side: Side) -> Option<(Rect, f64)> {
        let mut best: Option<(f64, Rect, f64)> = None;
        for (rank, anchor) in anchors.iter().enumerate() {
            for (cost, rect) in candidates(*anchor, size, side) {
                if !frame.contains(&rect) {
                    continue;
                }
                let covered = self.covered(&padded(&rect));
                let parted = if self.parted(&rect, *anchor) { 3e3 } else { 0.0 };
                let cost = 1e4 * covered + parted + cost + 12.0 * rank as f64;
                if best.is_none_or(|(least, ..)| cost < least) {
                    best = Some((cost, rect, covered));
                }
            }
        }
        best.map(|(_, rect, covered)| (rect, covered))
    }
}

fn padded(rect: &Rect) -> Rect {
    Rect { left: rect.left - GAP, top: rect.top - GAP / 2.0, right: rect.right + GAP, bottom: rect.bottom + GAP / 2.0 }
}

/// Places around an anchor with what speaks against them: the distance, and the turn away from the preferred side.
fn candidates(anchor: Spot, (width, height): (f64, f64), side: Side) -> impl Iterator<Item = (f64, Rect)> {
    const TURNS: i32 = 24;
    let preferred: f64 = match side {
        Side::Right => 0.0,
        Side::Below => 0.25,
        Side::Left => 0.5,
        Side::Above => 0.75,
    };
    (0..5).flat_map(move |ring| {
        (0..TURNS).map(move |turn| {
            let share = f64::from(turn) / f64::from(TURNS);
            let (sine, cosine) = ((share + preferred) * std::f64::consts::TAU).sin_cos();
            let reach = CLEARANCE + GAP + 40.0 * f64::from(ring);
            // The nearest side of the label keeps the distance in its direction.
            let x = anchor[0] + cosine * reach + cosine.clamp(-0.7, 0.7) / 0.7 * width / 2.0;
            let y = anchor[1] + sine * reach + sine.clamp(-0.7, 0.7) / 0.7 * height / 2.0;
            let away = share.min(1.0 - share);
            (150.0 * f64::from(ring) + 300.0 * away, Rect::around([x, y], width, height))
        })
    })
}

/// Lines and boxes that a label of a finished drawing covers.
#[cfg(test)]
pub(crate) fn covers(label: &Rect, lines: &[Vec<Spot>]) -> bool {
    lines.iter().flat_map(|line| line.windows(2)).any(|pair| label.clip(pair[0], pair[1]).is_some())
}

/// The line from a label to the nearest of its anchors, where it is too far away to be understood without.
pub(crate) fn leader(rect: &Rect, anchors: &[Spot]) -> Option<(Spot, Spot)> {
    let corners = [
        [rect.left, (rect.top + rect.bottom) / 2.0],
        [rect.right, (rect.top + rect.bottom) / 2.0],
        [(rect.left + rect.right) / 2.0, rect.top],
        [(rect.left + rect.right) / 2.0, rect.bottom],
    ];
    let pairs = anchors.iter().flat_map(|anchor| corners.iter().map(move |corner| (*corner, *anchor)));
    let nearest = pairs.min_by(|one, other| {
        let length = |pair: &(Spot, Spot)| distance(pair.0, pair.1, pair.1);
        length(one).total_cmp(&length(other))
    })?;
    (distance(nearest.0, nearest.1, nearest.1) > CLEARANCE + 90.0).then_some(nearest)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Rect = Rect { left: 0.0, top: 0.0, right: 2000.0, bottom: 2000.0 };

    #[test]
    fn the_preferred_side_where_it_is_free() {
        let (rect, covered) =
            Obstacles::default().place(&FRAME, &[[1000.0, 1000.0]], (200.0, 100.0), Side::Right).unwrap();
        assert!(rect.left > 1000.0 && rect.top < 1000.0 && rect.bottom > 1000.0 && covered == 0.0);
    }

    #[test]
    fn a_label_gives_way_to_lines_and_labels() {
        let mut obstacles = Obstacles::default();
        let line = vec![[1040.0, 0.0], [1040.0, 2000.0]];
        obstacles.line(&line);
        let (rect, covered) = obstacles.place(&FRAME, &[[1000.0, 1000.0]], (200.0, 100.0), Side::Right).unwrap();
        assert!(covered == 0.0 && !covers(&rect, &[line]));
        obstacles.block(rect);
        let (other, covered) = obstacles.place(&FRAME, &[[1000.0, 1000.0]], (200.0, 100.0), Side::Right).unwrap();
        assert!(covered == 0.0 && !other.overlaps(&rect));
    }

    #[test]
    fn never_outside_the_frame() {
        let corner = [[1990.0, 10.0]];
        let (rect, _) = Obstacles::default().place(&FRAME, &corner, (200.0, 100.0), Side::Right).unwrap();
        assert!(FRAME.contains(&rect));
        assert!(Obstacles::default().place(&FRAME, &corner, (3000.0, 100.0), Side::Right).is_none());
    }
}
