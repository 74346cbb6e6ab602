//! Plane geometry of the drawing, in units of the canvas.

/// A point of the canvas; y points down.
pub(crate) type Spot = [f64; 2];

/// A rectangle with sides along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rect {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) right: f64,
    pub(crate) bottom: f64,
}

impl Rect {
    /// Around a point.
    pub(crate) fn around(centre: Spot, width: f64, height: f64) -> Self {
        let [x, y] = centre;
        Rect { left: x - width / 2.0, top: y - height / 2.0, right: x + width / 2.0, bottom: y + height / 2.0 }
    }

    /// Without a margin on each side.
    pub(crate) fn shrunk(&self, margin: f64) -> Self {
        Rect {
            left: self.left + margin,
            top: self.top + margin,
            right: self.right - margin,
            bottom: self.bottom - margin,
        }
    }

    pub(crate) fn width(&self) -> f64 {
        self.right - self.left
    }

    pub(crate) fn height(&self) -> f64 {
        self.bottom - self.top
    }

    pub(crate) fn contains(&self, inner: &Rect) -> bool {
        inner.left >= self.left && inner.right <= self.right && inner.top >= self.top && inner.bottom <= self.bottom
    }

    pub(crate) fn overlaps(&self, other: &Rect) -> bool {
        self.left < other.right && other.left < self.right && self.top < other.bottom && other.top < self.bottom
    }

    /// The part of the segment from `from` to `to` inside (Liang and Barsky).
    pub(crate) fn clip(&self, from: Spot, to: Spot) -> Option<(Spot, Spot)> {
        let step = [to[0] - from[0], to[1] - from[1]];
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for (speed, room) in [
            (-step[0], from[0] - self.left),
            (step[0], self.right - from[0]),
            (-step[1], from[1] - self.top),
            (step[1], self.bottom - from[1]),
        ] {
            if speed == 0.0 {
                if room < 0.0 {
                    return None;
                }
            } else if speed < 0.0 {
                enter = enter.max(room / speed);
            } else {
                leave = leave.min(room / speed);
            }
        }
        let on = |share: f64| [from[0] + share * step[0], from[1] + share * step[1]];
        // Ends that are inside stay exactly as they are.
        (enter <= leave)
            .then(|| (if enter == 0.0 { from } else { on(enter) }, if leave == 1.0 { to } else { on(leave) }))
    }

    /// The parts of a polyline inside.
    pub(crate) fn clip_line(&self, line: &[Spot]) -> Vec<Vec<Spot>> {
        let mut parts: Vec<Vec<Spot>> = Vec::new();
        let mut open = false;
        for pair in line.windows(2) {
            let finite = pair.iter().flatten().all(|x| x.is_finite());
            let Some((from, to)) = finite.then(|| self.clip(pair[0], pair[1])).flatten() else {
                open = false;
                continue;
            };
            match parts.last_mut() {
                Some(part) if open && part.last() == Some(&from) => part.push(to),
                _ => parts.push(vec![from, to]),
            }
            open = to == pair[1];
        }
        parts
    }
}

/// Leaves out points of a polyline that lie closer to it than `tolerance` anyway (Ramer, Douglas and Peucker).
pub(crate) fn simplified(line: &[Spot], tolerance: f64) -> Vec<Spot> {
    let Some(last) = line.len().checked_sub(1) else { return Vec::new() };
    let mut keep = vec![false; line.len()];
    keep[0] = true;
    keep[last] = true;
    let mut open = vec![(0, last)];
    while let Some((from, to)) = open.pop() {
        let farthest = (from + 1..to)
            .map(|index| (index, distance(line[index], line[from], line[to])))
            .max_by(|one, other| one.1.total_cmp(&other.1));
        if let Some((index, distance)) = farthest.filter(|(_, distance)| *distance > tolerance) {
            debug_assert!(distance.is_finite());
            keep[index] = true;
            open.push((from, index));
            open.push((index, to));
        }
    }
    line.iter().zip(keep).filter(|(_, keep)| *keep).map(|(point, _)| *point).collect()
}

/// From a point to a segment.
pub(crate) fn distance(point: Spot, from: Spot, to: Spot) -> f64 {
    let step = [to[0] - from[0], to[1] - from[1]];
    let square = step[0] * step[0] + step[1] * step[1];
    let along = (point[0] - from[0]) * step[0] + (point[1] - from[1]) * step[1];
    let share = if square > 0.0 { (along / square).clamp(0.0, 1.0) } else { 0.0 };
    (point[0] - from[0] - share * step[0]).hypot(point[1] - from[1] - share * step[1])
}

/// Whether two segments cross.
pub(crate) fn crossing((a, b): (Spot, Spot), (c, d): (Spot, Spot)) -> bool {
    let turn = |p: Spot, q: Spot, r: Spot| (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Rect = Rect { left: 0.0, top: 0.0, right: 1.0, bottom: 1.0 };

    #[test]
    fn a_segment_is_cut_at_the_border() {
        assert_eq!(UNIT.clip([-1.0, 0.5], [2.0, 0.5]), Some(([0.0, 0.5], [1.0, 0.5])));
        assert_eq!(UNIT.clip([0.2, 0.2], [0.4, 0.2]), Some(([0.2, 0.2], [0.4, 0.2])));
        assert_eq!(UNIT.clip([-1.0, 2.0], [2.0, 2.0]), None);
        assert_eq!(UNIT.clip([-1.0, 0.5], [0.5, 2.5]), None);
    }

    #[test]
    fn a_line_that_leaves_and_returns_has_two_parts() {
        let line = [[0.5, 0.5], [0.5, 2.0], [0.7, 2.0], [0.7, 0.5], [0.8, 0.5]];
        let parts = UNIT.clip_line(&line);
        assert_eq!(parts, [vec![[0.5, 0.5], [0.5, 1.0]], vec![[0.7, 1.0], [0.7, 0.5], [0.8, 0.5]]]);
        assert!(UNIT.clip_line(&[[f64::NAN, 0.0], [0.5, 0.5]]).is_empty());
    }

    #[test]
    fn simplification_keeps_corners() {
        let line = [[0.0, 0.0], [1.0, 0.001], [2.0, 0.0], [2.0, 5.0]];
        assert_eq!(simplified(&line, 0.01), [[0.0, 0.0], [2.0, 0.0], [2.0, 5.0]]);
        assert_eq!(simplified(&line, 1e-4).len(), 4);
    }

    #[test]
    fn crossings() {
        let diagonal = ([0.0, 0.0], [1.0, 1.0]);
        assert!(crossing(diagonal, ([0.0, 1.0], [1.0, 0.0])));
        assert!(!crossing(diagonal, ([0.0, 1.0], [0.4, 0.6])));
        assert!(!crossing(diagonal, ([2.0, 0.0], [3.0, 1.0])));
    }
}
