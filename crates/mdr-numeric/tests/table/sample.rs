//! Tables for the tests, and a measure of the effect of rounding on them.

/// Points (r, f).
pub(crate) type Points = Vec<(f64, f64)>;

/// A repeatable stream of numbers in (−1, 1) (Knuth's MMIX generator; only spread matters here).
pub(crate) fn noise(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// `rows` radii from 0 to `end`, each displaced from the uniform grid by up to `jitter` < 1/2 of its spacing.
pub(crate) fn radii(rows: usize, end: f64, jitter: f64) -> Vec<f64> {
    let mut noise = noise(rows as u64);
    let last = rows - 1;
    let radius = |i: usize| {
        let shift = if i == 0 || i == last { 0.0 } else { jitter * noise() };
        end * (i as f64 + shift) / last as f64
    };
    (0..rows).map(radius).collect()
}

/// A profile with f(0) = 0 sampled at `radii`.
pub(crate) fn sampled(radii: &[f64], profile: impl Fn(f64) -> f64) -> Points {
    radii.iter().map(|&r| (r, profile(r))).collect()
}

/// Adds noise of the given amplitude everywhere but at the tip.
#[cfg(feature = "mp")]
pub(crate) fn with_noise(mut points: Points, amplitude: f64) -> Points {
    let mut noise = noise(points.len() as u64);
    points.iter_mut().skip(1).for_each(|(_, f)| *f += amplitude * noise());
    points
}

/// Σᵢ w(rᵢ₊₁/Δrᵢ) |Δfᵢ/Δrᵢ| Δθᵢ up to x: the measure of the rounding error of an integral over θ.
pub(crate) fn magnitude(points: &[(f64, f64)], x: f64, weight: impl Fn(f64) -> f64) -> f64 {
    let angle = |r: f64| (r / x).min(1.0).asin();
    let term = |pair: &[(f64, f64)]| {
        let [(p, f), (q, next)] = [pair[0], pair[1]];
        weight(q / (q - p)) * ((next - f) / (q - p)).abs() * (angle(q) - angle(p))
    };
    points.windows(2).filter(|pair| pair[0].0 < x).map(term).sum()
}
