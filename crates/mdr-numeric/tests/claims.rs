//! The error estimates and the evaluation counts of the quadrature.

#![cfg(feature = "mp")]
#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::sync::atomic::{AtomicUsize, Ordering};

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Profile, Shape};
use mdr_core::number::Lift;
use mdr_numeric::profiles::Heights;
use mdr_numeric::transform::Quadrature;
use rug::Float;

/// Bits of the references: 53 for the number, and three times 50 for the cancellation of a closed form at 1 − 2⁻⁵⁰.
const BITS: u32 = 256;

fn exact(x: f64) -> Float {
    Float::with_val(BITS, x)
}

/// f = αr up to b, and then (α + 1)r − b: a kink of the profile itself, with an infinite slope of g at b.
struct Bent {
    inner: f64,
    kink: f64,
}

impl Profile<f64> for Bent {
    fn height<S: Lift<f64>>(&self, r: &S) -> S {
        let cone = S::lift(&self.inner) * r;
        let beyond = r.clone() - S::lift(&self.kink);
        if beyond > r.lit(0) { cone + beyond } else { cone }
    }
    fn kinks(&self) -> Vec<f64> {
        vec![self.kink]
    }
}

/// Fails unless the error is at most the estimate.
fn check(name: &str, estimate: &Estimate<f64>, truth: &Float) {
    let error = (exact(estimate.value) - truth).abs().to_f64();
    assert!(error <= estimate.error, "{name}: off by {error:e}, {estimate:?}, in truth {:e}", truth.to_f64());
}

/// g, g' and mean g with their error estimates, at x.
fn estimates<P: Profile<f64>>(q: &Quadrature<f64, P>, x: f64) -> [Estimate<f64>; 3] {
    [q.g_estimate(&x).unwrap(), q.slope_estimate(&x).unwrap(), q.mean_estimate(&x).unwrap()]
}

/// arccos(b/x) and √(x² − b²).
fn angle_and_leg(b: f64, x: f64) -> [Float; 2] {
    [(exact(b) / exact(x)).acos(), (exact(x).square() - exact(b).square()).sqrt()]
}

/// Radii above b, down to a relative distance of 1e-14.
fn above(b: f64) -> impl Iterator<Item = f64> {
    (0..=420).map(move |k| b * (1.0 + 30.0 * 10_f64.powf(-f64::from(k) / 27.0))).filter(move |x| *x > b)
}

/// Popov & Heß 2015, chapter 3, as in `transform.rs`: a truncated cone has g = x arccos(b/x), and a cone of slope α
/// below it adds αxπ/2. The integral of g from b is ½(x² arccos(b/x) − b√(x²−b²)).
#[test]
fn errors_beside_a_kink_of_the_profile() {
    for (inner, kink) in [(0.0, 0.3), (0.7, 0.3), (0.01, 1.7e-5)] {
        let bent = Quadrature::new(Bent { inner, kink });
        for x in above(kink) {
            let [angle, leg] = angle_and_leg(kink, x);
            let cone = exact(0.0).acos() * inner;
            let [g, slope, mean] = estimates(&bent, x);
            check("g", &g, &(exact(x) * (angle.clone() + &cone)));
            check("slope", &slope, &(angle.clone() + exact(kink) / &leg + &cone));
            let part = (exact(x).square() * angle - exact(kink) * leg) / exact(x);
            check("mean", &mean, &((part + cone * exact(x)) / 2u32));
            // An estimate that is too large is of little use.
            let distance = (x - kink) / x;
            assert!(slope.error <= slope.value * f64::EPSILON * (64.0 + 1.0 / distance), "{x}: {slope:?}");
            assert!(g.error <= g.value * f64::EPSILON * 64.0, "{x}: {g:?}");
        }
    }
}

/// A kink of the curvature: g = (x/R)(√(x²−b²) − b arccos(b/x)).
#[test]
fn errors_beside_a_kink_of_the_curvature() {
    let b = 0.3;
    let punch = Quadrature::of([Shape::RoundedPunch { radius: 2.0, flat: b }]).unwrap();
    for x in above(b) {
        let [angle, leg] = angle_and_leg(b, x);
        let [g, slope, _] = estimates(&punch, x);
        check("g", &g, &(exact(x) / 2u32 * (leg.clone() - exact(b) * &angle)));
        check("slope", &slope, &(leg - exact(b) / 2u32 * angle));
    }
}

/// Towards the equator of a sphere the rounding of r is the whole error: g = x artanh x.
#[test]
fn errors_of_a_sphere() {
    let sphere = Quadrature::of([Shape::Sphere { radius: 1.0 }]).unwrap();
    for k in 0..3000 {
        let x = 1.0 - 10_f64.powf(-0.3 - f64::from(k) / 300.0);
        let [g, slope, mean] = estimates(&sphere, x);
        let (s, artanh) = (exact(x), exact(x).atanh());
        let square = s.clone().square();
        check("g", &g, &(s.clone() * &artanh));
        check("slope", &slope, &(s.clone() / (1u32 - square.clone()) + &artanh));
        check("mean", &mean, &((1u32 - (1u32 - square) * artanh / s.clone()) / 2u32));
        let condition = 1.0 / (1.0 - x * x);
        assert!(g.error <= g.value * f64::EPSILON * (32.0 + 9.0 * condition), "{x}: {g:?}");
    }
}

/// A profile that gives its heights only, which are counted.
struct CountingProfile<P> {
    profile: P,
    count: AtomicUsize,
}

impl<P: Profile<f64>> Profile<f64> for CountingProfile<P> {
    fn height<S: Lift<f64>>(&self, r: &S) -> S {
        self.count.fetch_add(1, Ordering::Relaxed);
        self.profile.height(r)
    }
    fn kinks(&self) -> Vec<f64> {
        self.profile.kinks()
    }
    fn outer_radius(&self) -> Option<f64> {
        self.profile.outer_radius()
    }
}

/// Evaluations of g, g' and mean g are all heights, including those of rules that failed, of noise and of kinks.
fn count<P: Profile<f64>>(profile: P, x: f64) -> [usize; 3] {
    let transform = Quadrature::new(CountingProfile { profile, count: AtomicUsize::new(0) });
    let spent = || transform.profile().count.swap(0, Ordering::Relaxed);
    let one = |estimate: Estimate<f64>| {
        assert_eq!(estimate.evaluations, spent());
        estimate.evaluations
    };
    [
        one(transform.g_estimate(&x).unwrap()),
        one(transform.slope_estimate(&x).unwrap()),
        one(transform.mean_estimate(&x).unwrap()),
    ]
}

#[test]
fn all_heights_are_counted() {
    count(Bent { inner: 1.0, kink: 0.3 }, 0.5);
    count(Heights::new([Shape::RoundedPunch { radius: 2.0, flat: 0.3 }]).unwrap(), 0.5);
    count(Heights::new([Shape::WavyParaboloid { radius: 0.5, amplitude: 1e-6, wavelength: 1e-3 }]).unwrap(), 0.3);
    // If only noise remains, no integral is computed twice.
    let [g, ..] = count(Heights::new([Shape::Sphere { radius: 1.0 }]).unwrap(), 1.0 - 1e-6);
    assert!(g < 2500, "{g}");
}
