//! Polynomials through Chebyshev points: the sign and the monotonicity of a function between them.

use std::f64::consts::PI;
use std::sync::LazyLock;

/// The degree, one less than the number of points.
pub(super) const DEGREE: usize = 8;

/// The fraction of the interval at point i; exactly 0 and 1 at the ends.
pub(super) fn share(i: usize) -> f64 {
    match i {
        0 => 0.0,
        DEGREE => 1.0,
        _ => 0.5 - 0.5 * (PI * i as f64 / DEGREE as f64).cos(),
    }
}

/// The polynomial Σ cₖ Tₖ through the values at −cos(iπ/DEGREE), i = 0 … DEGREE.
pub(super) struct Fit {
    smallest: f64,
    largest: f64,
    coefficients: [f64; DEGREE + 1],
}

impl Fit {
    pub(super) fn new(values: [f64; DEGREE + 1]) -> Self {
        let (smallest, largest) = values.iter().fold((f64::MAX, f64::MIN), |(s, l), &x| (s.min(x), l.max(x)));
        let half = |i: usize| if i == 0 || i == DEGREE { 0.5 } else { 1.0 };
        let coefficients = std::array::from_fn(|k| {
            let term = |i: usize| half(i) * values[DEGREE - i] * COSINES[i * k % (2 * DEGREE)];
            2.0 / DEGREE as f64 * half(k) * (0..=DEGREE).map(term).sum::<f64>()
        });
        Fit { smallest, largest, coefficients }
    }

    pub(super) fn spread(&self) -> f64 {
        self.largest - self.smallest
    }

    /// The largest magnitude among the values.
    pub(super) fn largest(&self) -> f64 {
        self.largest.abs().max(self.smallest.abs())
    }

    /// The magnitude of the truncation error of the polynomial: that of its last terms.
    pub(super) fn tail(&self) -> f64 {
        self.coefficients[DEGREE - 2..].iter().map(|c| c.abs()).sum()
    }
}

/// cos(iπ/DEGREE) over a whole turn.
static COSINES: LazyLock<[f64; 2 * DEGREE]> =
    LazyLock::new(|| std::array::from_fn(|i| (PI * i as f64 / DEGREE as f64).cos()));

fn clenshaw(coefficients: &[f64], x: f64) -> f64 {
    let (b1, b2) = coefficients.iter().skip(1).rev().fold((0.0, 0.0), |(b1, b2), c| (c + 2.0 * x * b1 - b2, b1));
    coefficients[0] + x * b1 - b2
}

/// The polynomial at the angles iπ/DRAWN, x = cos of them.
pub(super) struct Drawn {
    points: [(f64, f64); DRAWN + 1],
}

const DRAWN: usize = 4 * DEGREE;

impl Drawn {
    pub(super) fn new(fit: &Fit) -> Self {
        let point = |i: usize| {
            let x = (PI * i as f64 / DRAWN as f64).cos();
            (x, clenshaw(&fit.coefficients, x))
        };
        Drawn { points: std::array::from_fn(point) }
    }

    /// Whether all values have one sign and are no closer to zero than `margin`, also between the points: there a value
    /// is less than its neighbours by an eighth of their second difference in the angle; twice as much is allowed for.
    pub(super) fn keeps_away(&self, margin: f64) -> bool {
        let value = |i: usize| self.points[i].1;
        let bend = |i: usize| {
            let (before, after) = (i.abs_diff(1), if i == DRAWN { i - 1 } else { i + 1 });
            (value(before) - 2.0 * value(i) + value(after)).abs()
        };
        (0..=DRAWN).all(|i| {
            let bends = (i.saturating_sub(1)..=DRAWN.min(i + 1)).map(bend);
            value(i) * value(0).signum() > margin + bends.fold(0.0, f64::max) / 4.0
        })
    }

    /// Whether every step has the direction of `sign`, by more than `slope` minus the rounding `noise`.
    pub(super) fn is_directed(&self, sign: f64, slope: f64, noise: f64) -> bool {
        self.points.windows(2).all(|pair| sign * (pair[1].1 - pair[0].1) > slope * (pair[0].0 - pair[1].0) - noise)
    }
}
