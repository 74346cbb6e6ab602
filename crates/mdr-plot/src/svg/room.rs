//! Rectangles that texts and marks take, and lines cut to a rectangle.

use crate::chart::{Point, Side};

/// A rectangle that a text or a mark takes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Room {
    pub(super) centre: Point,
    pub(super) half: Point,
}

/// The eight ways from a point to a room beside it; straight ones first.
pub(super) const WAYS: [Point; 8] =
    [[1.0, 0.0], [-1.0, 0.0], [0.0, -1.0], [0.0, 1.0], [1.0, -1.0], [-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

impl Side {
    /// The way to this side, downwards positive.
    pub(super) fn way(self) -> Point {
        match self {
            Side::Above => [0.0, -1.0],
            Side::Below => [0.0, 1.0],
            Side::Left => [-1.0, 0.0],
            Side::Right => [1.0, 0.0],
        }
    }
}

impl Room {
    pub(super) fn around(centre: Point, [width, height]: Point) -> Self {
        Room { centre, half: [width / 2.0, height / 2.0] }
    }

    /// Beside a point, the nearest side or corner `gap` away.
    pub(super) fn beside(at: Point, way: Point, size: Point, gap: f64) -> Self {
        // A corner is nearer in each direction than a side.
        let gap = if way[0] != 0.0 && way[1] != 0.0 { 0.6 * gap } else { gap };
        Self::around([0, 1].map(|axis| at[axis] + way[axis] * (size[axis] / 2.0 + gap)), size)
    }

    /// Moved into a frame of this size, with a margin; and how far.
    pub(super) fn within(self, size: Point, margin: f64) -> (Self, f64) {
        let moved = [0, 1].map(|axis| {
            let least = self.half[axis] + margin;
            self.centre[axis].clamp(least, (size[axis] - least).max(least))
        });
        let by = (moved[0] - self.centre[0]).hypot(moved[1] - self.centre[1]);
        (Room { centre: moved, ..self }, by)
    }

    /// The place of the room that is nearest to a point.
    pub(super) fn nearest(&self, at: Point) -> Point {
        [0, 1].map(|axis| at[axis].clamp(self.centre[axis] - self.half[axis], self.centre[axis] + self.half[axis]))
    }

    /// Its corners, and its centre.
    pub(super) fn corners(&self) -> [Point; 5] {
        let ([x, y], [w, h]) = (self.centre, self.half);
        [[x - w, y - h], [x + w, y - h], [x + w, y + h], [x - w, y + h], [x, y]]
    }

    pub(super) fn overlaps(&self, other: &Room) -> bool {
        (0..2).all(|axis| (self.centre[axis] - other.centre[axis]).abs() < self.half[axis] + other.half[axis])
    }

    pub(super) fn holds(&self, at: Point) -> bool {
        (0..2).all(|axis| (self.centre[axis] - at[axis]).abs() <= self.half[axis])
    }

    /// The part of a line within the room.
    pub(super) fn cut(&self, from: Point, to: Point) -> Option<[Point; 2]> {
        let (mut first, mut last) = (0.0_f64, 1.0_f64);
        for axis in 0..2 {
            let (start, along) = (from[axis] - self.centre[axis], to[axis] - from[axis]);
            if !(start + along).is_finite() {
                return None;
            }
            if along == 0.0 {
                if start.abs() > self.half[axis] {
                    return None;
                }
                continue;
            }
            let ends = [(-self.half[axis] - start) / along, (self.half[axis] - start) / along];
            first = first.max(ends[0].min(ends[1]));
            last = last.min(ends[0].max(ends[1]));
        }
        let at = |part: f64| [0, 1].map(|axis| from[axis] + part * (to[axis] - from[axis]));
        (first <= last).then(|| [at(first), at(last)])
    }

    /// The polyline from where it first enters the room to where it first leaves it.
    pub(super) fn first_part(&self, places: &[Point]) -> Vec<Point> {
        let mut part: Vec<Point> = Vec::new();
        for pair in places.windows(2) {
            match self.cut(pair[0], pair[1]) {
                Some([from, to]) => {
                    if part.is_empty() {
                        part.push(from);
                    }
                    part.push(to);
                    if to != pair[1] && !self.holds(pair[1]) {
                        break;
                    }
                }
                None if part.is_empty() => {}
                None => break,
            }
        }
        part
    }

    /// Points of a polyline within the room, no farther than `step` from each other.
    pub(super) fn beads(&self, places: &[Point], step: f64) -> Vec<Point> {
        let mut beads: Vec<Point> = Vec::new();
        for [from, to] in places.windows(2).filter_map(|pair| self.cut(pair[0], pair[1])) {
            let steps = ((to[0] - from[0]).hypot(to[1] - from[1]) / step).ceil().clamp(1.0, 1e3) as usize;
            for part in 0..=steps {
                let part = part as f64 / steps as f64;
                let at = [0, 1].map(|axis| from[axis] + part * (to[axis] - from[axis]));
                let is_far = |last: &Point| (last[0] - at[0]).hypot(last[1] - at[1]) >= 0.7 * step;
                if beads.last().is_none_or(is_far) {
                    beads.push(at);
                }
            }
        }
        beads
    }
}

/// Whether a point is in a closed outline, by the number of its sides to the right.
pub(super) fn encloses(outline: &[Point], [x, y]: Point) -> bool {
    let next = outline.iter().cycle().skip(1);
    let crosses = |(from, to): (&Point, &Point)| {
        (from[1] > y) != (to[1] > y) && x < from[0] + (y - from[1]) / (to[1] - from[1]) * (to[0] - from[0])
    };
    outline.iter().zip(next).filter(|side| crosses(*side)).count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_cut_where_they_leave() {
        let room = Room::around([5.0, 5.0], [10.0, 10.0]);
        assert_eq!(room.cut([-5.0, 5.0], [15.0, 5.0]), Some([[0.0, 5.0], [10.0, 5.0]]));
        assert_eq!(room.cut([-5.0, 11.0], [15.0, 11.0]), None);
        assert_eq!(room.first_part(&[[2.0, 2.0], [2.0, 20.0], [3.0, 2.0]]), [[2.0, 2.0], [2.0, 10.0]]);
        assert_eq!(room.beads(&[[0.0, 0.0], [0.0, 100.0]], 5.0), [[0.0, 0.0], [0.0, 5.0], [0.0, 10.0]]);
        assert_eq!(room.beads(&[[f64::NAN, 0.0], [0.0, 100.0]], 5.0), [[0.0; 2]; 0]);
    }

    #[test]
    fn a_triangle_encloses_its_centre() {
        let triangle = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]];
        assert!(encloses(&triangle, [1.0, 1.0]) && !encloses(&triangle, [3.0, 3.0]));
    }
}
