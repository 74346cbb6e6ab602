//! The contact of the benches of folds: R = 1, w/E* = 10⁻⁴, and waves steeper than the paraboloid up to a = 0.1.

use mdr_analytic::profiles::WavyParaboloid;
use mdr_analytic::struve::Struve;
use mdr_core::contact::Result;

/// Waves within a = 0.1, and the number of folds under controlled indentation, as proved on radii from 10⁻⁶ to 10³.
pub(crate) const CASES: [(u32, usize); 5] = [(3, 5), (30, 35), (300, 353), (3000, 3535), (10_000, 11_785)];

/// 2a/R = (π/2)Ak√(2ka/π) at a = 0.1, k = 10πN: about N folds.
pub(crate) fn waves<R: Struve>(ctx: R::Ctx, count: u32) -> Result<WavyParaboloid<R>> {
    let k = 10.0 * std::f64::consts::PI * f64::from(count);
    let amplitude = 0.4 / (std::f64::consts::PI * k) / (0.2 * k / std::f64::consts::PI).sqrt();
    let number = |value: f64| R::from_f64(ctx, value);
    WavyParaboloid::new(number(1.0), number(amplitude), number(0.2 / f64::from(count)))
}
