//! The Jacobi polynomials of the weight t^(b−1)(1−t)^(a−1) on [0, 1], and their zeros.
//!
//! q_n = ₂F₁(−n, n+s; b; t), s = a+b−1, so that q_n(0) = 1. Written for the differences d_k = q_k − q_{k−1} the recurrence
//! −t q_k = λ_k d_{k+1} − μ_k d_k has no cancellation near t = 0: every zero below 1/2 has full *relative* accuracy;
//! the others follow by exchanging a and b.

use crate::number::Real;

/// One polynomial q_n, ready to be evaluated anywhere.
pub(super) struct Jacobi<R> {
    n: i64,
    a: R,
    b: R,
    /// For k = 0 … n−1.
    steps: Vec<Step<R>>,
}

/// From q_k to q_{k+1}, with the flow λ_k d_{k+1} in place of the difference.
struct Step<R> {
    /// μ_k/λ_{k−1}.
    carry: R,
    /// 1/λ_k.
    gain: R,
}

impl<R: Real> Step<R> {
    /// d_{k+1}, from q_k and the preceding flow.
    fn advance(&self, t: &R, value: &R, flow: &mut R) -> R {
        *flow *= &self.carry;
        *flow -= &(value.clone() * t);
        flow.clone() * &self.gain
    }
}

/// k + x.
fn shifted<R: Real>(x: &R, k: i64) -> R {
    x.lit(k) + x
}

impl<R: Real> Jacobi<R> {
    /// q_n, n ≥ 1, for a > 0 and b > 0.
    pub(super) fn new(n: i64, a: &R, b: &R) -> Self {
        let s = shifted(a, -1) + b;
        // λ_k = (k+b)(k+s)/((2k+s)(2k+s+1)), μ_k = k(k+a−1)/((2k+s−1)(2k+s)); s cancels from λ_0 and from μ_1/λ_0.
        let carry = |k| match k {
            0 => s.lit(0),
            1 => a.clone() / (shifted(&s, 2) * b),
            _ => {
                (shifted(a, k - 1) * shifted(&s, 2 * k - 2)).times(k)
                    / (shifted(&s, 2 * k) * shifted(b, k - 1) * shifted(&s, k - 1))
            }
        };
        let gain = |k| match k {
            0 => shifted(&s, 1) / b,
            _ => shifted(&s, 2 * k) * shifted(&s, 2 * k + 1) / (shifted(b, k) * shifted(&s, k)),
        };
        let steps = (0..n).map(|k| Step { carry: carry(k), gain: gain(k) }).collect();
        Jacobi { n, a: a.clone(), b: b.clone(), steps }
    }

    /// q_n and q_n' at 0 < t < 1, from t(1−t)q_n' = n[(n+a−1)/(2n+s−1)·d_n − t q_n].
    fn jet(&self, t: &R) -> (R, R) {
        let (mut value, mut flow, mut change) = (t.lit(1), t.lit(0), t.lit(0));
        for step in &self.steps {
            change = step.advance(t, &value, &mut flow);
            value += &change;
        }
        let n = self.n;
        let centre = shifted(&self.a, 2 * n - 2) + &self.b;
        let slope = change * shifted(&self.a, n - 1) / centre - value.clone() * t;
        let slope = slope.times(n) / self.span(t);
        (value, slope)
    }

    /// t(1−t).
    pub(super) fn span(&self, t: &R) -> R {
        (t.lit(1) - t) * t
    }

    /// The coefficients of `count` powers of h in q_n(t+h), from the hypergeometric equation
    /// t(1−t)q'' + [b − (a+b)t]q' + n(n+s)q = 0.
    fn series(&self, t: &R, count: i64) -> Vec<R> {
        let (value, slope) = self.jet(t);
        let span = self.span(t);
        let slant = t.lit(1) - t.clone().times(2);
        let drift = self.b.clone() - (self.a.clone() + &self.b) * t;
        let s = shifted(&self.a, -1) + &self.b;
        let mut coefficients = vec![value, slope];
        for k in 0..count - 2 {
            let [.., lower, upper] = coefficients.as_slice() else { break };
            let next = (slant.clone().times(k) + &drift).times(k + 1) * upper
                + shifted(&s, self.n + k).times(self.n - k) * lower;
            coefficients.push(-next / span.clone().times((k + 1) * (k + 2)));
        }
        coefficients
    }

    /// The zero near `guess` and q' there. The guess must be accurate to 32 bits of the spacing or more. The polynomial
    /// is evaluated once; each term of its Taylor series then adds 32 bits, and Newton's iteration uses as many terms
    /// as it needs.
    pub(super) fn zero_near(&self, guess: &R) -> (R, R) {
        let count = i64::from(guess.precision()) / 32 + 3;
        let coefficients = self.series(guess, count);
        let mut shift = guess.lit(0);
        let mut terms = 2;
        loop {
            let (value, slope) = horner(&coefficients[..terms], &shift.midpoint());
            shift = shift.midpoint() - value / slope;
            if terms == coefficients.len() {
                break;
            }
            terms = coefficients.len().min(2 * terms);
        }
        // One more step with all terms, so that the derivatives of a dual number converge and the slope is that at the
        // zero.
        let (value, slope) = horner(&coefficients, &shift.midpoint());
        shift = shift.midpoint() - value / slope;
        let (_, slope) = horner(&coefficients, &shift);
        (shift + guess, slope)
    }
}

/// Σ c_k h^k and its derivative.
fn horner<R: Real>(coefficients: &[R], h: &R) -> (R, R) {
    let mut value = h.lit(0);
    let mut slope = h.lit(0);
    for coefficient in coefficients.iter().rev() {
        slope *= h;
        slope += &value;
        value *= h;
        value += coefficient;
    }
    (value, slope)
}

impl Jacobi<f64> {
    /// How many zeros lie in (0, t): the sign changes of q_0, q_1, … q_n (Sturm).
    pub(super) fn zeros_below(&self, t: f64) -> usize {
        let (mut value, mut flow, mut sign, mut changes) = (1.0, 0.0, 1.0, 0);
        for step in &self.steps {
            value += step.advance(&t, &value, &mut flow);
            if value * sign < 0.0 {
                changes += 1;
                sign = -sign;
            }
        }
        changes
    }

    /// The `count` smallest zeros, ascending. Laguerre's iteration converges from any point to the next zero on its
    /// right without passing it, as all zeros are real. It starts left of the first; in θ, t = sin²(θ/2), the others
    /// are at least about π/ρ apart (Sturm), ρ = n + s/2, and half of that is a safe start.
    pub(super) fn smallest_zeros(&self, count: usize) -> Vec<f64> {
        let n = self.n as f64;
        let s = self.a + self.b - 1.0;
        let mut start = self.b / (n * (n + s));
        let mut zeros = Vec::with_capacity(count);
        for _ in 0..count {
            let zero = self.next_zero(start);
            let angle = zero.sqrt().asin() + 0.25 * zero.pi() / (n + 0.5 * s);
            start = angle.sin().powi(2);
            zeros.push(zero);
        }
        zeros
    }

    fn next_zero(&self, start: f64) -> f64 {
        let n = self.n as f64;
        let mut t = start;
        let sign = self.jet(&t).0.signum();
        // Convergence is of third order and takes a few steps; the limit is for zeros many octaves apart.
        for _ in 0..2200 {
            let (value, slope) = self.jet(&t);
            if value * sign <= 0.0 {
                break; // at the zero, or past it by a rounding
            }
            let drift = self.b - (self.a + self.b) * t;
            let curvature = -(drift * slope + n * (n + self.a + self.b - 1.0) * value) / self.span(&t);
            let radicand = (n - 1.0) * ((n - 1.0) * slope * slope - n * value * curvature);
            let step = n * value.abs() / (radicand.max(0.0).sqrt() - sign * slope);
            t += step;
            if step < 1e-6 * t / n {
                break; // the next step would be below rounding
            }
        }
        t
    }
}
