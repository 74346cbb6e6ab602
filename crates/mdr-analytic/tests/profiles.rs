//! The closed forms of the profile library against each other: G' = g and g' = slope by automatic differentiation,
//! continuity across the edge, and the limits in which one profile becomes another.
#![cfg(feature = "mp")]

use mdr_analytic::PowerLaw;
use mdr_analytic::profiles::*;
use mdr_analytic::struve::Struve;
use mdr_core::contact::{Error, Result, Transform};
use mdr_core::number::{Dual, Interval, Precision, Real};
use rug::Float;
use rug::float::Round;

const BITS: u32 = 240;
/// Each closed form is a few dozen operations; near an edge or a zero it may lose up to 40 of the 240 bits at the test
/// radii (|x/b − 1| ≥ 2⁻²⁰, loss at most its square).
const LOSS: u32 = 60;

fn number(text: &str) -> Float {
    Real::from_literal(Precision::new(BITS), &text.parse().expect("a decimal"))
}

type Named<R> = (&'static str, Box<dyn Transform<R>>);

/// The whole library over one arithmetic, with edge at b = 3/7 where there is one.
fn library<R: Struve>(seed: &R) -> Result<Vec<Named<R>>> {
    let b = seed.ratio(3, 7);
    let one = seed.lit(1);
    let slope = seed.ratio(2, 5);
    let five = seed.lit(5);
    Ok(vec![
        ("cone", Box::new(Cone::new(slope.clone())?)),
        ("paraboloid", Box::new(Paraboloid::new(five.clone())?)),
        ("sphere", Box::new(Sphere::new(five.clone())?)),
        ("ellipsoid", Box::new(Ellipsoid::new(five.clone(), one.clone())?)),
        ("hyperboloid", Box::new(Hyperboloid::new(slope.clone(), b.clone())?)),
        ("truncated cone", Box::new(TruncatedCone::new(slope.clone(), b.clone())?)),
        ("truncated paraboloid", Box::new(TruncatedParaboloid::new(five.clone(), b.clone())?)),
        ("rounded punch", Box::new(RoundedPunch::new(five.clone(), b.clone())?)),
        ("parabolic cap", Box::new(ParabolicCapCone::new(slope.clone(), b.clone())?)),
        ("spherical cap", Box::new(SphericalCapCone::new(slope.clone(), one.clone())?)),
        ("displaced paraboloid", Box::new(DisplacedParaboloid::new(five.clone(), b.clone())?)),
        ("parabolic dimple", Box::new(ParabolicDimple::new(one.clone(), b.clone())?)),
        ("elliptical dimple", Box::new(EllipticalDimple::new(one, b.clone())?)),
        ("wavy paraboloid", Box::new(WavyParaboloid::new(five.clone(), seed.ratio(1, 50), seed.ratio(1, 3))?)),
        ("sum", Box::new(Sum::new(vec![Box::new(Cone::new(slope)?), Box::new(RoundedPunch::new(five, b)?)]))),
    ])
}

/// Radii on both sides of b, of the spherical cap's edge and of its 2x = R, down to a millionth from the edge.
const RADII: [&str; 10] = ["1e-9", "0.01", "0.3", "0.42857", "0.428572", "0.43", "0.499", "0.501", "1.3", "4.9"];

fn assert_close(what: &str, value: &Float, expected: &Float) {
    let error = Float::with_val(BITS, value - expected).abs();
    let scale = Float::with_val(BITS, expected.abs_ref());
    assert!(error <= (scale >> (BITS - LOSS)), "{what}: {value} against {expected}");
}

#[test]
fn slopes_are_derivatives_and_integrals_are_antiderivatives() {
    let seed = number("1");
    let plain = library(&seed).unwrap();
    let dual = library(&Dual::constant(seed)).unwrap();
    for ((name, profile), (_, differentiated)) in plain.iter().zip(&dual) {
        for text in RADII {
            let x = number(text);
            let moving = Dual::variable(x.clone());
            let g = differentiated.g(&moving).unwrap();
            let integral = differentiated.integral(&moving).unwrap();
            assert_close(&format!("{name}: g at {text}"), &integral.slope, &profile.g(&x).unwrap());
            assert_close(&format!("{name}: g' at {text}"), &g.slope, &profile.slope(&x).unwrap());
        }
    }
}

/// Every closed form over cells of radii, with its slope, against points in them at 240 bits; the cells are of relative
/// width 2⁻³ to 2⁻³⁰ and come as close to an edge as they are wide.
#[test]
fn enclosures_with_slopes_contain_what_they_should() {
    let seed = number("1");
    let sharp = library(&Dual::constant(seed.clone())).unwrap();
    let one = Interval::from_int(Precision::new(60), 1);
    let enclosed = library(&Dual::constant(one.clone())).unwrap();
    for ((name, sharp), (_, enclosed)) in sharp.iter().zip(&enclosed) {
        let edge = sharp.kinks().first().map_or_else(|| seed.ratio(3, 7), |kink| kink.value.clone());
        for octave in 3..=30 {
            let width = seed.lit(2).powi(-octave);
            for start in [1, 2, 5] {
                let ends = [start, start + 1].map(|steps| edge.clone() * (seed.lit(1) + width.clone().times(steps)));
                let end = |value: &Float, round| Float::with_val_round(60, value, round).0;
                let cell = Interval::new(end(&ends[0], Round::Up), end(&ends[1], Round::Down));
                let moving = Dual::variable(cell.clone());
                let parts =
                    [enclosed.g(&moving), enclosed.slope(&moving), enclosed.integral(&moving)].map(Result::unwrap);
                for share in 0..=4 {
                    let x = Float::with_val(BITS, cell.upper() - cell.lower()) * share / 4u32 + cell.lower();
                    let x = Dual::variable(x);
                    let points = [sharp.g(&x), sharp.slope(&x), sharp.integral(&x)].map(Result::unwrap);
                    for (part, point) in parts.iter().zip(points) {
                        assert!(part.value.contains(&point.value), "{name} at {:?}: {part:?}", x.value);
                        assert!(part.slope.contains(&point.slope), "{name} at {:?}: {part:?}", x.value);
                        assert!(part.slope.is_finite(), "{name} at {:?}", x.value);
                    }
                }
            }
        }
    }
}

/// g, its mean and the bounds of g' beside every kink and at the vertical edge, against 240 bits; b = 3/7 is no number of 64 bits.
#[test]
fn kinks_are_enclosed_from_both_sides() {
    let seed = number("1");
    let one = Interval::from_int(Precision::new(64), 1);
    let (mut sharp, mut enclosed) = (library(&seed).unwrap(), library(&one).unwrap());
    sharp.push(("flat punch", Box::new(FlatPunch::new(seed.ratio(3, 7)).unwrap())));
    enclosed.push(("flat punch", Box::new(FlatPunch::new(one.ratio(3, 7)).unwrap())));
    let mut seen = Vec::new();
    for ((name, sharp), (_, enclosed)) in sharp.iter().zip(&enclosed) {
        let edge = sharp.outer_radius().filter(|_| sharp.vertical_edge());
        for (index, b) in sharp.kinks().iter().chain(&edge).enumerate() {
            seen.push(*name);
            for octave in [3, 10, 20, 40] {
                let margin = seed.lit(2).powi(-octave);
                let kink = enclosed.kink(index, &Interval::point(Float::with_val(64, &margin))).unwrap().unwrap();
                if let Some((g, mean)) = &kink.value {
                    assert!(g.contains(&sharp.g(b).unwrap()) && mean.contains(&sharp.mean(b).unwrap()), "{name}");
                }
                for share in [1, 3, 17, 1000, 1_000_000_000] {
                    let step = margin.clone().over(share) * b;
                    let slope = |side: i64| sharp.slope(&(step.clone().times(side) + b)).ok();
                    for (slopes, slope) in [(&kink.inside, slope(-1)), (&kink.outside, slope(1))] {
                        let Some(slope) = slope else { continue };
                        let above = slopes.least.as_ref().is_none_or(|least| *least.lower() <= slope);
                        let below = slopes.greatest.as_ref().is_none_or(|greatest| *greatest.upper() >= slope);
                        assert!(above && below, "{name} at 2^-{octave}/{share}: {slope} in {slopes:?}");
                    }
                }
            }
        }
    }
    assert_eq!(seen.len(), 9, "{seen:?}");
    let past = enclosed.iter().filter(|(_, profile)| profile.kink(2, &one.ratio(1, 8)).unwrap().is_some());
    assert_eq!(past.count(), 0);
}

/// The slope of the slope of a rounded punch, 1/q > 0 beside its edge: the truncated series keeps its sign.
#[test]
fn a_truncated_series_proves_monotonicity() {
    let one = Dual::constant(Interval::from_int(Precision::new(64), 1));
    let punch = RoundedPunch::new(one.lit(5), one.clone()).unwrap();
    for octave in 10..40 {
        let step = one.lit(2).powi(-octave);
        let cell = (one.clone() + &step).value.hull(&(step.times(3).over(2) + &one).value);
        let slope = punch.slope(&Dual::variable(cell)).unwrap();
        assert!(slope.slope > one.value.lit(0), "2^-{octave}: {slope:?}");
    }
}

#[test]
fn continuous_across_the_edge() {
    let b = Float::with_val(BITS, 3) / 7u32;
    let step = Float::with_val(BITS, 1) >> 100;
    for (name, profile) in library(&b).unwrap() {
        if profile.kinks().is_empty() || name == "spherical cap" || name == "elliptical dimple" {
            continue; // its edge is elsewhere; its g is singular there
        }
        let jump = |part: &dyn Fn(&Float) -> Result<Float>| {
            let outside = part(&Float::with_val(BITS, &b + &step)).unwrap();
            Float::with_val(BITS, outside - part(&b).unwrap()).abs().to_f64()
        };
        // g rises at most like √(x − b): 2⁻⁵⁰ over a step of 2⁻¹⁰⁰, with slopes and curvatures of order one.
        assert!(jump(&|x| profile.g(x)) < 8.0 * 2f64.powi(-50), "{name}: g");
        assert!(jump(&|x| profile.integral(x)) < 8.0 * 2f64.powi(-100), "{name}: G");
    }
}

#[test]
fn g_rises_beyond_the_radius_that_is_named() {
    let b = Float::with_val(BITS, 3) / 7u32;
    let mut named = 0;
    for (name, profile) in library(&b).unwrap() {
        let end = profile.outer_radius().map_or(f64::INFINITY, |end| end.to_f64());
        for from in [0.25, 0.5, 0.999, 1.0, 1.001, 2.0, 8.0].map(|share| Float::with_val(BITS, &b * share)) {
            if !profile.rises_beyond(&from) {
                continue;
            }
            named += 1;
            let steps = (1..400).map(|step| Float::with_val(BITS, &from * (f64::from(step) / 50.0).exp()));
            for x in steps.take_while(|x| *x < end) {
                assert!(profile.slope(&x).unwrap() >= 0, "{name}: g falls at {x}, beyond {from}");
            }
        }
    }
    assert!(named > 40, "{named}");
}

#[test]
fn edges_and_ends_are_refused() {
    let b = Float::with_val(BITS, 3) / 7u32;
    for (name, profile) in library(&b).unwrap() {
        assert!(profile.g(&number("0")).is_err(), "{name} at 0");
        assert!(profile.g(&number("-1")).is_err(), "{name} below 0");
        if let Some(end) = profile.outer_radius() {
            assert!(profile.g(&end).is_err() && profile.integral(&(end + 1u32)).is_err(), "{name} at its end");
        }
    }
    let dimple = EllipticalDimple::new(1.0, 0.5).unwrap();
    assert!(dimple.g(&0.5).is_err(), "log-singular at its edge");
    assert!(Cone::new(-1.0).is_err() && Sphere::new(f64::NAN).is_err());
}

#[test]
fn far_away_a_capped_cone_is_a_cone() {
    // g − πtx/2 → −(cap's missing height), so the ratio tends to 1 like b/x.
    let cone = Cone::new(0.4).unwrap();
    let capped = ParabolicCapCone::new(0.4, 1e-3).unwrap();
    let x = 1e3;
    assert!((capped.g(&x).unwrap() / cone.g(&x).unwrap() - 1.0).abs() < 1e-6);
}

/// A flank so flat that the joint is close to the axis: a product of differences must not cancel.
#[test]
fn the_integral_of_a_flat_cone_with_a_spherical_cap() {
    for slope in ["0.5", "1e-3", "7.5e-8", "1e-30", "1e-100"] {
        for x in ["0.6", "1", "1.7", "30"] {
            let at = |bits| {
                let number = |text: &str| Float::from_literal(Precision::new(bits), &text.parse().expect("a decimal"));
                SphericalCapCone::new(number(slope), number("1")).unwrap().integral(&number(x)).unwrap()
            };
            // In the wide one cancellation takes fewer than 800 of 1200 bits.
            let (found, expected) = (at(53), at(1200));
            let error = Float::with_val(100, &found - &expected).abs() / Float::with_val(100, expected.abs_ref());
            assert!(error < 64.0 * f64::EPSILON, "slope {slope}, x {x}: {found} off by {error}");
        }
    }
}

/// If terms leave the range of doubles, the log₁₀ of their sum is that of 200 bits to a few roundings, and a term that
/// is outweighed is negligible.
#[test]
fn sums_beyond_the_range_tell_their_logarithm() {
    fn sum<R: Struve>(x: R) -> Result<(Sum<R>, R)> {
        let terms: Vec<Box<dyn Transform<R>>> = vec![
            Box::new(Paraboloid::new(x.clone().times(2))?),
            Box::new(DisplacedParaboloid::new(x.clone(), x.lit(1))?),
        ];
        Ok((Sum::new(terms), x))
    }
    for scale in ["1e180", "1e300"] {
        let exact = Float::with_val(BITS, Float::parse(scale).unwrap());
        let (wide, x) = sum(exact.clone()).unwrap();
        let expected = wide.integral(&x).unwrap().abs().log10().to_f64();
        let (narrow, x) = sum(exact.to_f64()).unwrap();
        let Err(Error::OutOfRange { log10, .. }) = narrow.integral(&x) else { panic!("{scale}") };
        assert!((log10 - expected).abs() <= 4.0 * f64::EPSILON * expected, "{scale}: {log10}, {expected}");
    }
    let power = |c: f64| Box::new(PowerLaw::new(2.0, c).unwrap()) as Box<dyn Transform<f64>>;
    assert_eq!(Sum::new(vec![power(1e-300), power(1.0)]).g(&1e-50), Ok(2e-100));
    let Err(Error::OutOfRange { log10, .. }) = Sum::new(vec![power(1.0), power(1e3)]).g(&1e170) else { panic!() };
    assert_eq!(log10, f64::INFINITY);
    let Err(Error::OutOfRange { log10, .. }) = Sum::new(vec![power(1.0), power(1e30)]).g(&1e170) else { panic!() };
    assert!((log10 - 370.0 - 2_f64.log10()).abs() < 1e-13, "{log10}");
    let twice = Sum::new(vec![power(1.0), power(1.0)]);
    assert!(matches!(twice.g(&7e153), Err(Error::OutOfRange { log10, .. }) if log10 > 308.0));
}

/// The library in f64 with every length times `unit`, and radii on both sides of its edges.
fn in_units(unit: f64) -> Result<Vec<Named<f64>>> {
    let [five, one, b] = [5.0, 1.0, 3.0 / 7.0].map(|length| length * unit);
    Ok(vec![
        ("cone", Box::new(Cone::new(0.4)?)),
        ("paraboloid", Box::new(Paraboloid::new(five)?)),
        ("sphere", Box::new(Sphere::new(five)?)),
        ("ellipsoid", Box::new(Ellipsoid::new(five, one)?)),
        ("hyperboloid", Box::new(Hyperboloid::new(0.4, b)?)),
        ("truncated cone", Box::new(TruncatedCone::new(0.4, b)?)),
        ("truncated paraboloid", Box::new(TruncatedParaboloid::new(five, b)?)),
        ("rounded punch", Box::new(RoundedPunch::new(five, b)?)),
        ("parabolic cap", Box::new(ParabolicCapCone::new(0.4, b)?)),
        ("spherical cap", Box::new(SphericalCapCone::new(0.4, one)?)),
        ("displaced paraboloid", Box::new(DisplacedParaboloid::new(five, b)?)),
        ("parabolic dimple", Box::new(ParabolicDimple::new(one, b)?)),
        ("elliptical dimple", Box::new(EllipticalDimple::new(one, b)?)),
        ("wavy paraboloid", Box::new(WavyParaboloid::new(five, 0.02 * unit, unit / 3.0)?)),
    ])
}

/// g, its mean and their difference are lengths, in range where the square of a length is not.
#[test]
fn means_are_in_range_where_g_is() {
    for unit in [-1000, -550, 530, 1000].map(|k| 2f64.powi(k)) {
        for ((name, one), (_, other)) in in_units(1.0).unwrap().iter().zip(&in_units(unit).unwrap()) {
            for x in [0.011, 0.3, 0.43, 0.61, 1.7, 4.0] {
                let lengths = |profile: &dyn Transform<f64>, x: f64| {
                    [profile.g(&x), profile.mean(&x), profile.above_mean(&x)].map(Result::unwrap)
                };
                let (expected, found) = (lengths(one.as_ref(), x), lengths(other.as_ref(), x * unit));
                let scale = expected[0].abs();
                for (part, (expected, found)) in ["g", "mean", "above mean"].iter().zip(expected.iter().zip(found)) {
                    // The same formula, but for √2 in a root: a dozen roundings, 40 more in a series.
                    let error = (found / unit - expected).abs();
                    assert!(error <= 50.0 * f64::EPSILON * scale, "{name}: {part} at {x} · {unit:e}: {error:e}");
                }
            }
        }
    }
}

/// Every shape with all its lengths and slopes one.
fn shapes<R: Struve>(one: &R) -> Result<Vec<Named<R>>> {
    let one = || one.clone();
    Ok(vec![
        ("sphere", Box::new(Sphere::new(one())?)),
        ("hyperboloid", Box::new(Hyperboloid::new(one(), one())?)),
        ("truncated cone", Box::new(TruncatedCone::new(one(), one())?)),
        ("truncated paraboloid", Box::new(TruncatedParaboloid::new(one(), one())?)),
        ("rounded punch", Box::new(RoundedPunch::new(one(), one())?)),
        ("parabolic cap", Box::new(ParabolicCapCone::new(one(), one())?)),
        ("spherical cap", Box::new(SphericalCapCone::new(one(), one())?)),
        ("parabolic dimple", Box::new(ParabolicDimple::new(one(), one())?)),
        ("elliptical dimple", Box::new(EllipticalDimple::new(one(), one())?)),
    ])
}

/// No integral loses more than a digit beyond what its condition x g/G costs, and 2⁻²⁰ < t < 2²⁰ with x = t and x² = 1 + t².
#[test]
fn integrals_lose_at_most_a_digit_more_than_they_must() {
    let wide = shapes(&number("1")).unwrap();
    for ((name, narrow), (_, wide)) in shapes(&1.0).unwrap().iter().zip(&wide) {
        let mut worst = (0.0, 0.0);
        for step in 0..2000 {
            let t = 2f64.powf(f64::from(step) / 50.0 - 20.0);
            for x in [t, (1.0 + t * t).sqrt()] {
                let exact = Float::with_val(BITS, x);
                let (Ok(found), Ok(truth)) = (narrow.integral(&x), wide.integral(&exact)) else { continue };
                if truth == 0 {
                    assert_eq!(found, 0.0);
                    continue;
                }
                let condition = Float::with_val(BITS, wide.g(&exact).unwrap() * x / &truth).to_f64().abs().max(1.0);
                let error = Float::with_val(BITS, (found - truth.clone()) / truth).to_f64().abs();
                let loss = (error / (f64::EPSILON / 2.0 * condition)).log10();
                if loss > worst.1 {
                    worst = (x, loss);
                }
            }
        }
        assert!(worst.1 < 1.0, "{name}: {} digits at {}", worst.1, worst.0);
    }
}

/// An error contains the parameter as the user gave it, in few digits.
#[test]
fn refusals_name_what_was_given() {
    let refused = |profile: Result<Box<dyn Transform<f64>>>, named: &str| {
        let message = profile.err().expect(named).to_string();
        assert!(message.starts_with(named) && message.len() < 200, "{message}");
    };
    refused(EllipticalDimple::new(-1.0, 1.0).map(|p| Box::new(p) as _), "depth must be positive");
    refused(EllipticalDimple::new(1.0, -1.0).map(|p| Box::new(p) as _), "radius must be positive");
    refused(
        ParabolicCapCone::new(1e-300, 1e300).map(|p| Box::new(p) as _),
        "the radius of curvature of the cap is out",
    );
    refused(
        WavyParaboloid::new(1.0, 1.0, 1e-320).map(|p| Box::new(p) as _),
        "the wave number 2π/λ is out of the range",
    );
    refused(Sphere::new(-1e300).map(|p| Box::new(p) as _), "radius must be positive and finite, got -1e300");
    let waves = WavyParaboloid::new(1.0, 1.0, 1e-300).unwrap();
    let message = waves.g(&1e100).unwrap_err().to_string();
    assert!(message.contains("small enough") && message.ends_with("got 1e100"), "{message}");
    let none = Sum::<f64>::new(Vec::new());
    assert!(none.g(&f64::NAN).is_err() && none.g(&-1.0).is_err() && none.g(&1.0) == Ok(0.0));
}

/// Close to the radius R where g diverges, g = x·½ ln((R + x)/(R − x)) is accurate, for any R, and the least slope
/// beyond a margin is that at the margin.
#[test]
fn a_sphere_close_to_its_equator() {
    for radius in [0.3, 1.0, 1.9, 1e-7] {
        let ball = Sphere::new(radius).unwrap();
        let exact = Sphere::new(Float::with_val(BITS, radius)).unwrap();
        for octaves in [3, 5, 10, 20, 40, 51] {
            let x = radius - 2f64.powi(-octaves) * radius;
            let truth =
                |value: Float, found: f64| Float::with_val(BITS, (found - value.clone()) / value).to_f64().abs();
            let wide = Float::with_val(BITS, x);
            let error = truth(exact.g(&wide).unwrap(), ball.g(&x).unwrap());
            // A sum, a difference, a quotient, a logarithm above ln 16 and two products.
            assert!(error < 5.0 * f64::EPSILON, "g({x}) of {radius}: {error:e}");
            let margin = Float::with_val(BITS, 1) >> octaves.unsigned_abs();
            let least = exact.kink(0, &margin).unwrap().unwrap().inside.least.unwrap();
            let at_margin = exact.slope(&Float::with_val(BITS, (1 - margin) * Float::with_val(BITS, radius))).unwrap();
            let difference = Float::with_val(BITS, (least - &at_margin) / at_margin).abs();
            assert!(
                difference < Float::with_val(BITS, 1) >> (BITS - LOSS - octaves.unsigned_abs()),
                "{radius}, {octaves}"
            );
        }
    }
}

/// A height whose slope is not bounded.
struct Bent(f64);

impl Transform<Dual<f64>> for Bent {
    fn g(&self, _: &Dual<f64>) -> Result<Dual<f64>> {
        Ok(Dual { value: self.0, slope: f64::INFINITY })
    }
    fn slope(&self, x: &Dual<f64>) -> Result<Dual<f64>> {
        self.g(x)
    }
    fn integral(&self, x: &Dual<f64>) -> Result<Dual<f64>> {
        self.g(x)
    }
}

/// Where terms have values and no bounded slopes, the sum has the sum of all values.
#[test]
fn sums_of_values_without_slopes() {
    let sum = Sum::new(vec![Box::new(Bent(1.0)), Box::new(Bent(2.0))]);
    let g = sum.g(&Dual::variable(1.0)).unwrap();
    assert_eq!(g.value, 3.0);
    assert!(!g.slope.is_finite());
}
