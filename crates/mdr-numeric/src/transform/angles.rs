//! The angles of radii r = x sinθ on the quarter circle, from either of its ends.

use mdr_core::number::Special;

/// The end of the quarter circle from which an angle is measured.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Origin {
    /// r = 0: r/x is the sine.
    Tip,
    /// r = x: r/x is the cosine.
    Edge,
}

/// An interval of angles between two radii, measured from the end where a narrow one keeps its digits.
#[derive(Clone)]
pub(super) struct Angles<R> {
    pub(super) lower: R,
    pub(super) upper: R,
    origin: Origin,
    /// The radii beside the kinks at their ends: between them the profile is smooth.
    inner: Option<R>,
    outer: Option<R>,
}

/// The angle of a kink inside x, or of an end, from the tip and from the edge, each to full relative accuracy.
struct Direction<R> {
    kink: Option<R>,
    from_tip: R,
    from_edge: R,
}

/// sinθ and cosθ of a radius r = x sinθ, r < x. Near the edge the accuracy is that of the difference x − r.
pub(super) fn sine_and_cosine<R: Special>(radius: &R, x: &R) -> [R; 2] {
    let sine = radius.clone() / x;
    let cosine = ((x.clone() - radius) / x * (sine.lit(1) + &sine)).sqrt();
    [sine, cosine]
}

impl<R: Special> Direction<R> {
    fn new(kink: &R, x: &R) -> Self {
        let [sine, cosine] = sine_and_cosine(kink, x);
        let from_tip = (sine.clone() / &cosine).atan();
        Direction { kink: Some(kink.clone()), from_tip, from_edge: (cosine / sine).atan() }
    }

    fn tip(x: &R) -> Self {
        Direction { kink: None, from_tip: x.lit(0), from_edge: x.pi().over(2) }
    }

    fn edge(x: &R) -> Self {
        Direction { kink: None, from_tip: x.pi().over(2), from_edge: x.lit(0) }
    }

    /// The radius two floating-point numbers above the kink or below it.
    fn beside(&self, side: i64) -> Option<R> {
        self.kink.as_ref().map(|kink| kink.unit_roundoff().times(2 * side) * kink + kink)
    }
}

impl<R: Special> Angles<R> {
    /// The whole quarter circle.
    pub(super) fn quarter(x: &R) -> Self {
        Angles { lower: x.lit(0), upper: x.pi().over(2), origin: Origin::Tip, inner: None, outer: None }
    }

    /// The quarter circle cut at the radii that are inside x; they ascend.
    pub(super) fn between(radii: &[R], x: &R) -> Vec<Self> {
        let zero = x.lit(0);
        let inside =
            radii.iter().filter(|radius| **radius > zero && *radius < x).map(|radius| Direction::new(radius, x));
        let directions: Vec<Direction<R>> =
            std::iter::once(Direction::tip(x)).chain(inside).chain(std::iter::once(Direction::edge(x))).collect();
        let pieces = directions.windows(2).map(|ends| {
            let (inner, outer) = (&ends[0], &ends[1]);
            let (origin, lower, upper) = if inner.from_edge < inner.from_tip {
                (Origin::Edge, &outer.from_edge, &inner.from_edge)
            } else {
                (Origin::Tip, &inner.from_tip, &outer.from_tip)
            };
            let (lower, upper) = (lower.clone(), upper.clone());
            Angles { lower, upper, origin, inner: inner.beside(1), outer: outer.beside(-1) }
        });
        pieces.filter(|angles| angles.lower < angles.upper).collect()
    }

    /// A part of the interval.
    pub(super) fn part(&self, lower: &R, upper: &R) -> Self {
        Angles { lower: lower.clone(), upper: upper.clone(), ..self.clone() }
    }

    /// Whether the interval begins at the tip.
    pub(super) fn touch_tip(&self) -> bool {
        self.origin == Origin::Tip && self.lower == self.lower.lit(0)
    }

    /// r/x at one of the angles.
    pub(super) fn sine(&self, angle: &R) -> R {
        match self.origin {
            Origin::Tip => angle.sin(),
            Origin::Edge => angle.cos(),
        }
    }

    /// r = x sinθ, rounded to the correct side of the kinks.
    pub(super) fn radius(&self, sine: &R, x: &R) -> R {
        let radius = sine.clone() * x;
        match (&self.inner, &self.outer) {
            (Some(inner), _) if radius < *inner => inner.lesser(x),
            (_, Some(outer)) if radius > *outer => outer.clone(),
            _ => radius,
        }
    }

    /// The largest of the radii.
    pub(super) fn largest_radius(&self, x: &R) -> R {
        self.outer.as_ref().unwrap_or(x).clone()
    }
}
