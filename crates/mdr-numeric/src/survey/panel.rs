//! What nine samples show about the crossings within a panel.

use super::chebyshev::{DEGREE, Drawn, Fit};
use super::{NOISE, Sample};

/// What the samples of a panel show.
pub(super) enum Settled {
    /// No crossing.
    Empty,
    /// At most one.
    Monotone,
    /// The ratio is one up to rounding.
    Flat,
    /// To be halved.
    Open,
}

/// A panel that extends out of the range of the arithmetic, or to radii where the ratio cannot be computed: halved
/// until the remainder is negligible, and read sample by sample.
///
/// After a failed quadrature samples are expensive and the result is doubtful, so larger panels are accepted.
pub(super) fn outside(known: &[Sample], width: f64, blind: bool) -> Settled {
    if known.is_empty() {
        Settled::Empty
    } else if width < if blind { 0.25 } else { 1e-3 } {
        Settled::Monotone
    } else {
        Settled::Open
    }
}

/// The polynomial through all samples of a panel.
pub(super) fn fit(samples: &[Sample], value: impl Fn(&Sample) -> f64) -> Fit {
    Fit::new(std::array::from_fn(|i| value(&samples[i])))
}

fn one_sided(samples: &[Sample]) -> bool {
    samples.windows(2).all(|pair| pair[0].above == pair[1].above)
}

/// Whether the samples stay away from the crossing by a margin, and either are within a factor of two or lie on a
/// smooth curve. Nine samples of many waves may do so by chance, one time in 500 if the waves reach the crossing; hence
/// the three nested panels.
pub(super) fn is_quiet(samples: &[Sample], by_level: &Fit) -> bool {
    let margin = samples.iter().fold(f64::MAX, |m, sample| m.min(sample.level.abs()));
    let step = samples.windows(2).fold(0.0, |step: f64, pair| step.max((pair[1].level - pair[0].level).abs()));
    let spread = by_level.spread();
    one_sided(samples)
        && margin > 1.0 + 2.0 * step
        && (spread < std::f64::consts::LN_2 || by_level.tail() < 0.02 * spread)
}

/// By ln(ratio), smooth over decades of radii, or else by the ratio itself, smooth over a wave.
pub(super) fn settle(samples: &[Sample], by_level: &Fit, roundoff: f64) -> Settled {
    if samples.iter().all(|sample| sample.level.abs() <= NOISE * roundoff) {
        return Settled::Flat;
    }
    let one_sided = one_sided(samples);
    let width = samples[DEGREE].t - samples[0].t;
    match resolved(by_level, one_sided, width, roundoff) {
        Settled::Open if samples.iter().all(|sample| sample.excess.is_finite()) => {
            resolved(&fit(samples, |sample| sample.excess), one_sided, width, roundoff)
        }
        verdict => verdict,
    }
}

/// What the polynomial through the samples of a panel shows about its zeros.
fn resolved(fit: &Fit, one_sided: bool, width: f64, roundoff: f64) -> Settled {
    let (spread, tail) = (fit.spread(), fit.tail());
    let noise = NOISE * roundoff + 8.0 * f64::EPSILON * fit.largest();
    let allowed = if width <= 2.0 { 1e-2 * spread } else { 1e-6 * spread };
    if tail > allowed.max(noise) {
        return Settled::Open;
    }
    let curve = Drawn::new(fit);
    let clear = one_sided && curve.keeps_away(4.0 * tail + noise);
    // The slope of the remainder of the polynomial, by Markov's inequality: two turning points of half a percent of the
    // spread are two folds nevertheless.
    let slope = if tail > noise { tail * (DEGREE * DEGREE) as f64 } else { 0.0 };
    let directed = |sign: f64| curve.is_directed(sign, slope, noise);
    if clear {
        Settled::Empty
    } else if spread > 4.0 * noise && (directed(1.0) || directed(-1.0)) {
        Settled::Monotone
    } else {
        Settled::Open
    }
}
