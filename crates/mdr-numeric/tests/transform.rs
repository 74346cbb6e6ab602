//! The transform by quadrature against identities that need no formula for κ_n.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::atomic::{AtomicUsize, Ordering};

use approx::assert_relative_eq;
use mdr_core::contact::{Error, Flank, Profile, Shape, Transform};
use mdr_core::number::Lift;
use mdr_numeric::profiles::Heights;
use mdr_numeric::transform::{Quadrature, Rule};
use proptest::prelude::*;

/// At most 24 positive terms of four roundings each, with weights and nodes of a few roundings, summed.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// f = (r − b) for r > b: a kink of the profile itself, hence an infinite slope of g at b.
struct TruncatedCone {
    flat: f64,
}

impl Profile<f64> for TruncatedCone {
    fn height<S: Lift<f64>>(&self, r: &S) -> S {
        let beyond = r.clone() - S::lift(&self.flat);
        if beyond > r.lit(0) { beyond } else { r.lit(0) }
    }
    fn kinks(&self) -> Vec<f64> {
        vec![self.flat]
    }
}

#[test]
fn cone_paraboloid_and_sphere() {
    // M. Heß, Über die exakte Abbildung ausgewählter dreidimensionaler Kontakte auf Systeme mit niedrigerer räumlicher
    // Dimension, 2011; V. L. Popov, M. Heß, Method of Dimensionality Reduction, 2015, table 3.1.
    let cone = Quadrature::of([Shape::Cone { flank: Flank::Slope(0.5) }]).unwrap();
    let ball = Quadrature::of([Shape::Paraboloid { radius: 4.0 }]).unwrap();
    for x in [1e-200, 1e-9, 0.3, 1.0, 7e5, 1e150] {
        assert_relative_eq!(cone.g(&x).unwrap(), FRAC_PI_2 * 0.5 * x, max_relative = ROUNDING);
        assert_relative_eq!(cone.slope(&x).unwrap(), FRAC_PI_2 * 0.5, max_relative = ROUNDING);
        assert_relative_eq!(cone.mean(&x).unwrap(), FRAC_PI_2 * 0.25 * x, max_relative = ROUNDING);
        assert_relative_eq!(ball.slope(&x).unwrap(), x / 2.0, max_relative = ROUNDING);
    }
    for x in [1e-150, 1e-9, 0.3, 1.0, 7e5, 1e150] {
        assert_relative_eq!(ball.g(&x).unwrap(), x * (x / 4.0), max_relative = ROUNDING);
    }
    assert_relative_eq!(ball.integral(&2.0).unwrap(), 2.0 / 3.0, max_relative = ROUNDING);

    let sphere = Quadrature::of([Shape::Sphere { radius: 2.0 }]).unwrap();
    for s in [1e-6, 0.1, 0.5, 0.9, 0.99, 0.9999, 1.0 - 1e-9] {
        let x = 2.0 * s;
        // x g'/g bounds the effect of the rounding of x and of r near the equator; for g' it is included once more.
        let condition = 1.0 / (1.0 - s * s);
        let g = sphere.g_estimate(&x).unwrap();
        assert_relative_eq!(g.value, x * f64::atanh(s), max_relative = ROUNDING * (1.0 + condition));
        assert!((g.value - x * f64::atanh(s)).abs() <= g.error, "s = {s}: the error {} is too small", g.error);
        let slope = f64::atanh(s) + s * condition;
        assert_relative_eq!(sphere.slope(&x).unwrap(), slope, max_relative = ROUNDING * (1.0 + 2.0 * condition));
        let integral = 0.5 * (x * x - 4.0) * f64::atanh(s) + x;
        // The reference cancels as s².
        assert_relative_eq!(sphere.integral(&x).unwrap(), integral, max_relative = ROUNDING * (1.0 + 1.0 / (s * s)));
    }
}

/// Towards the equator the accuracy of g' is x g''/g' ≈ 2ᵏ roundings of x, and no more than that is lost.
#[test]
fn slope_of_a_sphere_up_to_its_last_radius() {
    let sphere = Quadrature::of([Shape::Sphere { radius: 1.0 }]).unwrap();
    for k in 1..=53 {
        let to_equator = 0.5_f64.powi(k);
        let x = 1.0 - to_equator;
        let beyond = 2.0 - to_equator;
        let truth = 0.5 * (beyond / to_equator).ln() + x / (to_equator * beyond);
        let tolerance = ROUNDING + f64::EPSILON / to_equator;
        assert_relative_eq!(sphere.slope(&x).unwrap(), truth, max_relative = tolerance);
    }
}

#[test]
fn kinks_split_the_integral() {
    // Popov & Heß 2015, chapter 3: g = x tanθ arccos(b/x) beyond the flat, and for the rounded edge
    // g = (x/R)(√(x²−b²) − b arccos(b/x)).
    let b = 0.3;
    let cone = Quadrature::new(TruncatedCone { flat: b });
    let punch = Quadrature::of([Shape::RoundedPunch { radius: 2.0, flat: b }]).unwrap();
    for x in [0.1, 0.3] {
        assert_eq!([cone.g(&x).unwrap(), cone.slope(&x).unwrap(), punch.g(&x).unwrap()], [0.0; 3]);
    }
    for x in [0.31, 0.5, 3.0, 300.0] {
        let (angle, leg) = (f64::acos(b / x), f64::sqrt(x * x - b * b));
        // arccos near 1 and the differences below lose the digits that (x − b)/x loses.
        let rounding = ROUNDING * (1.0 + x / (x - b));
        assert_relative_eq!(cone.g(&x).unwrap(), x * angle, max_relative = rounding);
        assert_relative_eq!(cone.slope(&x).unwrap(), angle + b / leg, max_relative = rounding);
        let squared = ROUNDING * (1.0 + x / (x - b)).powi(2);
        assert_relative_eq!(punch.g(&x).unwrap(), x / 2.0 * (leg - b * angle), max_relative = squared);
        assert_relative_eq!(punch.slope(&x).unwrap(), leg - b / 2.0 * angle, max_relative = rounding);
    }
}

#[test]
fn twelve_nodes_are_enough_for_powers() {
    for n in [0.001, 0.25, 0.5, 1.0, 2.5, 7.0, 50.0, 1000.0] {
        let profile = Heights::new([Shape::Power { n, c: 1.0 }]).unwrap();
        let automatic = Quadrature::new(profile.clone()).g_estimate(&1.0).unwrap();
        assert_eq!(automatic.evaluations, 27, "n = {n}"); // 4 + 8 + 12, and three for noise
        let fixed = Quadrature::new(profile).with_rule(Rule::Gauss { nodes: 12 });
        assert_relative_eq!(fixed.g(&1.0).unwrap(), automatic.value, max_relative = ROUNDING);
    }
}

#[test]
fn radii_outside_the_domain_are_refused() {
    let sphere = Quadrature::of([Shape::Sphere { radius: 1.0 }]).unwrap();
    for x in [0.0, -1.0, f64::NAN, f64::INFINITY, 1.0, 2.0] {
        assert!(matches!(sphere.g(&x), Err(Error::Domain { .. })), "x = {x}");
    }
    let steep = Quadrature::of([Shape::Power { n: 1000.0, c: 1.0 }]).unwrap();
    assert!(matches!(steep.g(&1e10), Err(Error::OutOfRange { .. })));
    assert!(Quadrature::of([Shape::Cone { flank: Flank::Slope(1.0) }]).unwrap().with_tolerance(-1.0).is_err());
    assert!(
        Heights::new([Shape::Power { n: f64::NAN, c: 1.0 }]).is_err()
            && Heights::new([Shape::Power { n: -1.0, c: 1.0 }]).is_err()
    );
}

proptest! {
    /// A homogeneous profile of degree n has a homogeneous transform: x g' = n g and x g = (n+1) G (Euler).
    #[test]
    fn powers_are_homogeneous(n in 0.001..20.0_f64, x in 1e-9..1e9_f64) {
        let q = Quadrature::of([Shape::Power { n, c: 0.7 }]).unwrap();
        let (g, slope, integral) = (q.g(&x).unwrap(), q.slope(&x).unwrap(), q.integral(&x).unwrap());
        // The rounding of r = xs is multiplied by n.
        let rounding = ROUNDING * (1.0 + n / 4.0);
        prop_assert!((x * slope / (n * g) - 1.0).abs() <= rounding);
        prop_assert!((x * g / ((n + 1.0) * integral) - 1.0).abs() <= rounding);
    }

    /// Two independent rules agree within their error estimates.
    #[test]
    fn rules_agree(n in 0.01..50.0_f64, x in 1e-3..1e3_f64) {
        let gauss = Quadrature::of([Shape::Power { n, c: 1.0 }]).unwrap().g_estimate(&x).unwrap();
        let tanh_sinh =
            Quadrature::of([Shape::Power { n, c: 1.0 }]).unwrap().with_rule(Rule::TanhSinh).g_estimate(&x).unwrap();
        prop_assert!((gauss.value - tanh_sinh.value).abs() <= 2.0 * (gauss.error + tanh_sinh.error));
        // An estimate that is too large is of little use.
        prop_assert!(gauss.error <= 64.0 * f64::EPSILON * (1.0 + n) * gauss.value);
    }

    /// g is linear in f: a wave added to a paraboloid adds its transform, whatever the paraboloid.
    #[test]
    fn transform_is_linear(x in 0.01..1.0_f64, first in 0.5..2.0_f64, second in 3.0..9.0_f64) {
        let wavy = |radius| Quadrature::of([Shape::WavyParaboloid { radius, amplitude: 1e-2, wavelength: 0.2 }]).unwrap().g(&x).unwrap();
        let wave = [first, second].map(|radius| wavy(radius) - x * x / radius);
        let scale = x * x / first + 1e-2 * PI * x / 0.1 * FRAC_PI_2;
        prop_assert!((wave[0] - wave[1]).abs() <= 4.0 * ROUNDING * scale);
    }
}

/// If r g' overflows and g' does not, the rounding of r is still recognised as the limit of a steep profile; otherwise
/// every rule is tried to its end, and a search takes minutes.
#[test]
fn steep_slopes_at_the_end_of_the_range() {
    let (n, step) = (300.0, 1.01_f64);
    for x in [10.2_f64, 10.25, 10.3, 10.32] {
        let steep = Quadrature::of([Shape::Power { n, c: 1.0 }]).unwrap();
        assert_eq!((n * n * x.powf(n)).is_infinite(), x > 10.26, "{x}");
        let [below, here] = [x / step, x].map(|x| steep.slope_estimate(&x).unwrap());
        // g' is of degree n − 1; both x are rounded.
        let rounding = 2.0 * n * f64::EPSILON + below.error / below.value + here.error / here.value;
        assert!(((here.value / below.value).ln() - (n - 1.0) * step.ln()).abs() < rounding, "{x}");
        assert!(here.evaluations <= 72, "{x}: {here:?}");
    }
}

#[cfg(feature = "mp")]
#[test]
fn fifty_digits() {
    use mdr_core::number::{Precision, Real};
    use rug::Float;
    let like = Float::from_int(Precision::from_digits(50), 1);
    let cone = Quadrature::of([Shape::Cone { flank: Flank::Slope(like.clone()) }]).unwrap();
    let sphere = Quadrature::of([Shape::Sphere { radius: like.clone() }]).unwrap().with_rule(Rule::TanhSinh);
    let x = like.ratio(1, 3);
    let error = |value: Float, truth: Float| ((value - &truth) / truth).abs();
    let bound = like.unit_roundoff().times(32);
    let g = cone.g_estimate(&x).unwrap();
    assert_eq!(g.evaluations, 75); // 12 + 24 + 36, and three for noise
    assert!(error(g.value, like.pi().over(6)) < bound);
    assert!(error(sphere.g(&x).unwrap(), x.clone() * x.atanh()) < bound);
}

#[test]
fn one_node_claims_nothing() {
    let ball = Quadrature::of([Shape::Paraboloid { radius: 1.0 }]).unwrap().with_rule(Rule::Gauss { nodes: 1 });
    // g(1) = 1.
    let estimate = ball.g_estimate(&1.0).unwrap();
    assert!((estimate.value - 1.0).abs() > 1e-4 && (estimate.value - 1.0).abs() <= estimate.error, "{estimate:?}");
    // With a kink the integral is split into pieces.
    let punch = Quadrature::of([Shape::RoundedPunch { radius: 1.0, flat: 0.1 }]).unwrap();
    let exact = punch.g_estimate(&1.0).unwrap().value;
    let estimate = punch.with_rule(Rule::Gauss { nodes: 1 }).g_estimate(&1.0).unwrap();
    assert!((estimate.value - exact).abs() <= estimate.error, "{estimate:?} {exact}");
}

/// r² + A(1 − cos kr), k = 2π/λ, given by its heights only; they are counted.
struct Waves {
    amplitude: f64,
    wavelength: f64,
    heights: AtomicUsize,
}

impl Profile<f64> for Waves {
    fn height<S: Lift<f64>>(&self, r: &S) -> S {
        self.heights.fetch_add(1, Ordering::Relaxed);
        let half_phase = r.clone() / S::lift(&self.wavelength) * r.pi();
        r.square() + (half_phase.sin().square() * S::lift(&self.amplitude)).times(2)
    }
}

/// Up to five hundred waves are integrated, at about twenty heights each, besides rules that fail.
#[test]
fn waves_cost_twenty_heights_each() {
    for (amplitude, wavelength) in [(1e-6, 1e-3), (1e-7, 3e-4), (1e-3, 1e-2)] {
        for waves in [70.0, 100.0, 150.0, 200.3, 300.0, 400.0, 500.0] {
            let x = waves * wavelength;
            let profile = Waves { amplitude, wavelength, heights: AtomicUsize::new(0) };
            let transform = Quadrature::new(profile);
            let estimate = transform.slope_estimate(&x).unwrap();
            let spent = transform.profile().heights.load(Ordering::Relaxed) as f64;
            assert!(spent <= 4000.0 + 20.0 * waves, "{waves} waves of {wavelength}: {spent} heights");
            let smooth = Quadrature::of([Shape::WavyParaboloid { radius: 0.5, amplitude, wavelength }]).unwrap();
            let other = smooth.with_rule(Rule::Gauss { nodes: 1000 }).slope(&x).unwrap();
            // g' is 4x and waves that grow to Ak √(kx) or so; the phase kx has the rounding of r.
            let phase = 2.0 * PI * waves;
            let size = 4.0 * x + phase / x * amplitude * phase.sqrt();
            let rounding = estimate.error + size * phase * f64::EPSILON;
            assert!((estimate.value - other).abs() <= rounding, "{waves}: {estimate:?} {other}");
        }
    }
}

/// Rules of few nodes may agree by chance over a few waves. Eighty nodes resolve them, with rounding errors only.
#[test]
fn luck_is_not_convergence() {
    let waves = || Quadrature::of([Shape::WavyParaboloid { radius: 1.0, amplitude: 0.1, wavelength: 1.0 }]).unwrap();
    let (automatic, fine) = (waves(), waves().with_rule(Rule::Gauss { nodes: 80 }));
    for i in 1..8000 {
        let x = f64::from(i) / 2000.0;
        for ask in [Quadrature::g_estimate, Quadrature::slope_estimate, Quadrature::mean_estimate] {
            let (found, truth) = (ask(&automatic, &x).unwrap(), ask(&fine, &x).unwrap());
            assert!((found.value - truth.value).abs() <= found.error + truth.error, "{x}: {found:?} {truth:?}");
        }
    }
}

/// Waves of the opposite phase, a trough on the axis, subtract the heights that the others add.
#[test]
fn a_negative_amplitude_is_the_opposite_phase() {
    let g = |amplitude, x| {
        Quadrature::of([Shape::WavyParaboloid { radius: 1.0, amplitude, wavelength: 0.2 }]).unwrap().g(&x).unwrap()
    };
    for x in [0.03, 0.1, 0.45] {
        let smooth: f64 = x * x;
        // Each to 32 roundoffs of |g| < x² + π²x A/λ · 2.
        let tolerance = 64.0 * f64::EPSILON * (smooth + x);
        assert!((g(1e-2, x) + g(-1e-2, x) - 2.0 * smooth).abs() < tolerance && g(-1e-2, x) != g(1e-2, x), "x = {x}");
    }
    assert!(Heights::new([Shape::WavyParaboloid { radius: 1.0, amplitude: f64::NAN, wavelength: 0.2 }]).is_err());
}
