//! Other media than the half-space: fields carry the force, energies are those of their springs, quadratures are the closed forms.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use std::f64::consts::PI;
use std::sync::Arc;

use mdr_core::calculus::quadrature::tanh_sinh_near_ends;
use mdr_core::contact::{Control, CountingTransform, EvaluationCounter, Shape, Transform};
use mdr_numeric::contact::Contact;
use mdr_numeric::energy::Energy;
use mdr_numeric::fields::Fields;
use mdr_numeric::folds::{self, SearchQuality};
use mdr_numeric::medium::{Adhesion, Medium};
use mdr_numeric::profiles::Heights;
use mdr_numeric::transform::{LineLoad, Powers, Quadrature, Wave, Weighted};

const WORK: f64 = 1e-2;

fn contact(transform: impl Transform<f64> + 'static, medium: Medium<f64>) -> Contact<f64> {
    Contact::new(transform, medium, Adhesion::new(WORK).unwrap(), Control::Indentation)
}

fn ball() -> Heights<f64> {
    Heights::new([Shape::Paraboloid { radius: 1.0 }]).unwrap()
}

/// ∫₀ᵃ p(r)·measure(r) dr, and its error. With a² − r² = a²v^(2/(1+k)) the edge is smooth; where r rounds to a, below `least`, the
/// integrand is taken as constant.
fn carried(fields: &Fields<f64>, a: f64, k: f64, measure: impl Fn(f64) -> f64) -> (f64, f64) {
    let order = 2.0 / (1.0 + k);
    let least = 1e-12_f64.powf(1.0 / order);
    let integrand = |v: f64, rest: f64| {
        // v = 1 − rest.
        let r = a * (-(order * (-rest).ln_1p()).exp_m1()).sqrt();
        let jacobian = a * a * order / 2.0 * v.powf(order - 1.0) / r;
        fields.pressure_estimate(&r).map(|pressure| pressure.value * measure(r) * jacobian)
    };
    let edge = least * integrand(least, 1.0 - least).unwrap();
    let inner = tanh_sinh_near_ends(&least, &1.0, &1e-10, |node| integrand(node.x, node.from_upper)).unwrap();
    // a² − r² is known to 10⁻⁴ of itself at the end.
    (inner.value + edge, edge.abs() * (1e-3 + 10.0 * least) + 1e-9 * inner.value.abs())
}

#[test]
fn the_pressure_carries_the_force() {
    let a = 0.4;
    for k in [-0.5, 0.0, 0.3] {
        let graded = contact(Powers::graded([(2.0, 0.5)], &k).unwrap(), Medium::graded(2.0, k).unwrap());
        let force = graded.force(&a).unwrap();
        let fields = Fields::new(graded, a).unwrap();
        let (sum, error) = carried(&fields, a, k, |r| 2.0 * PI * r);
        assert!((sum - force).abs() < error, "k = {k}: {sum} {force}");
    }
    let winkler = contact(Powers::winkler([(2.0, 0.5)]).unwrap(), Medium::winkler(2.0).unwrap());
    let force = winkler.force(&a).unwrap();
    let (sum, error) = carried(&Fields::new(winkler, a).unwrap(), a, 1.0, |r| 2.0 * PI * r);
    assert!((sum - force).abs() < error, "{sum} {force}");
    let line =
        contact(LineLoad::of_powers(Powers::line([(2.0, 0.5)]).unwrap(), None), Medium::plane(2.0, None).unwrap());
    let force = line.force(&a).unwrap();
    let (sum, error) = carried(&Fields::new(line, a).unwrap(), a, 0.0, |_| 2.0);
    assert!((sum - force).abs() < error, "{sum} {force}");
}

/// Johnson's pressure and gap, cos X (s + P − 2sin²X)/√(s − sin²X) and 2[y√(y² − s) − P arcosh(y/√s)].
#[test]
fn the_fields_of_a_wave() {
    let medium = Medium::periodic(2.0, 1.5).unwrap();
    let (half_width, height) = (0.4, 0.1);
    let size = medium.size(&half_width);
    let wave = contact(Wave::new(height, 1.5).unwrap(), medium);
    let unit = PI * 2.0 * height / 1.5;
    let load = wave.force(&size).unwrap() / unit;
    let s = (PI * half_width / 1.5).sin().powi(2);
    let fields = Fields::new(wave, size).unwrap();
    for x in [0.0, 0.1, 0.35] {
        let place = PI * x / 1.5;
        let expected = place.cos() * (s + load - 2.0 * place.sin().powi(2)) / (s - place.sin().powi(2)).sqrt() * unit;
        let found = fields.pressure(&x).unwrap();
        assert!((found / expected - 1.0).abs() < 1e-12, "{x}: {found} {expected}");
    }
    for x in [0.41_f64, 0.5, 0.75] {
        let y = (PI * x / 1.5).sin();
        let expected = 2.0 * height * (y * (y * y - s).sqrt() - load * (y / s.sqrt()).acosh());
        let found = fields.gap(&x).unwrap();
        assert!((found / expected - 1.0).abs() < 1e-11, "{x}: {found} {expected}");
    }
    assert!(fields.pressure(&0.4).is_err() && fields.gap(&0.4).is_err() && fields.gap(&0.76).is_err());
}

/// The gap is f − d + u.
#[test]
fn gap_and_displacement_add_up_to_the_profile() {
    for k in [-0.4, 0.3] {
        let graded = contact(Powers::graded([(2.0, 0.5)], &k).unwrap(), Medium::graded(2.0, k).unwrap());
        let fields = Fields::new(graded, 0.4).unwrap();
        for r in [0.41_f64, 0.6, 2.0] {
            let sum = fields.indentation() + fields.gap(&r).unwrap() - fields.displacement(&r).unwrap();
            assert!((sum / (r * r / 2.0) - 1.0).abs() < 1e-12, "k = {k}, r = {r}: {sum}");
        }
    }
}

/// The gap beside a cylinder, in closed form.
#[test]
fn the_gap_of_a_line_contact() {
    let (b, modulus) = (0.4, 2.0);
    let line =
        contact(LineLoad::of_powers(Powers::line([(2.0, 0.5)]).unwrap(), None), Medium::plane(modulus, None).unwrap());
    let fields = Fields::new(line, b).unwrap();
    let edge = (2.0 * PI * WORK * b / modulus).sqrt();
    for x in [0.45_f64, 0.8] {
        let open = (x / b).acosh();
        // (2/π)[∫_b^x arcosh(x/c)(πc/2)dc + arcosh(x/b)Δl], ∫_b^x arcosh(x/c) c dc = ½[x√(x² − b²) − b² arcosh(x/b)].
        let bulk = PI / 4.0 * (x * (x * x - b * b).sqrt() - b * b * open);
        let expected = 2.0 / PI * (bulk + open * edge);
        let found = fields.gap(&x).unwrap();
        assert!((found / expected - 1.0).abs() < 1e-12, "{x}: {found} {expected}");
    }
}

/// Π of a power on a graded medium: c∫xᵏ(d − g)² dx − πa²w; and of the wave, s²/4 − ½P² ln s − α²ψ in units of p*h₀.
#[test]
fn energies() {
    let (a, d, k, c) = (0.4_f64, -0.02, 0.3, 2.0);
    let transform = Powers::graded([(2.0, 0.5)], &k).unwrap();
    let g = transform.g(&1.0).unwrap();
    let graded = contact(transform, Medium::graded(c, k).unwrap());
    let power = |n: f64| a.powf(n + 1.0 + k) / (n + 1.0 + k);
    let expected = c * (d * d * power(0.0) - 2.0 * d * g * power(2.0) + g * g * power(4.0)) - PI * a * a * WORK;
    let found = Energy::new(graded.clone()).unwrap().potential(&a, &d).unwrap();
    assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    let energy = Energy::new(graded).unwrap();
    let (local, varied) = (energy.release(&a, &d).unwrap(), energy.release_by_variation(&a, &d).unwrap());
    assert!((local / varied - 1.0).abs() < 1e-11, "{local} {varied}");

    let (modulus, wavelength, height) = (2.0, 1.5, 0.1);
    let medium = Medium::periodic(modulus, wavelength).unwrap();
    let size = medium.size(&0.3);
    let wave = contact(Wave::new(height, wavelength).unwrap(), medium);
    let unit = PI * modulus * height / wavelength;
    let (d, force) = wave.state(&size).unwrap();
    let (angle, load) = (PI * 0.3 / wavelength, force / unit);
    let s = angle.sin().powi(2);
    let alpha_squared = 2.0 * wavelength * WORK / (PI * PI * height * height * modulus);
    let expected = unit * height * (s * s / 4.0 - load * load / 2.0 * s.ln() - alpha_squared * angle);
    let found = Energy::new(wave).unwrap().potential(&size, &d).unwrap();
    assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    let line =
        contact(LineLoad::of_powers(Powers::line([(2.0, 0.5)]).unwrap(), None), Medium::plane(1.0, None).unwrap());
    assert!(Energy::new(line).is_err());
}

/// The quadratures of other media against sums of powers, and of the half-space against its own quadrature.
#[test]
fn quadratures_are_the_closed_forms() {
    let compare = |one: &dyn Transform<f64>, other: &dyn Transform<f64>, what: &str| {
        for x in [1e-3, 0.7, 40.0] {
            let pairs = [
                (one.g(&x), other.g(&x)),
                (one.slope(&x), other.slope(&x)),
                (one.mean(&x), other.mean(&x)),
                (one.above_mean(&x), other.above_mean(&x)),
            ];
            for (index, (one, other)) in pairs.into_iter().enumerate() {
                let (one, other) = (one.unwrap(), other.unwrap());
                assert!((one - other).abs() <= 1e-12 * other.abs(), "{what} {index} at {x}: {one} {other}");
            }
        }
    };
    for k in [-0.9, -0.3, 0.5, 0.95] {
        let powers = Powers::graded([(2.0, 0.5)], &k).unwrap();
        compare(&Weighted::graded(ball(), k), &powers, &format!("graded, k = {k}"));
    }
    compare(&Weighted::winkler(ball(), 1.0), &Powers::winkler([(2.0, 0.5)]).unwrap(), "winkler");
    let line = LineLoad::new(Box::new(Weighted::line(ball(), None, 1.0)), None);
    compare(&line, &LineLoad::of_powers(Powers::line([(2.0, 0.5)]).unwrap(), None), "line");
    let kinked =
        || Heights::new([Shape::RoundedPunch { radius: 1.0, flat: 0.2 }, Shape::Paraboloid { radius: 3.0 }]).unwrap();
    compare(&Weighted::graded(kinked(), 0.0), &Quadrature::new(kinked()), "kinked");
}

/// In doubles a formula has its kinks where its own roundings put them, which may be at a millionth of the radius, or a rounding below it.
#[test]
#[cfg(feature = "mp")]
fn kinks_that_a_formula_rounds() {
    use mdr_core::contact::{Expression, Profile};
    use mdr_core::number::{Precision, Real, Special};
    use rug::Float;

    fn transform<R: Special>(formula: &str, ctx: R::Ctx, k: &str) -> Weighted<R, impl Profile<R> + use<R>> {
        let (formula, none): (Expression, _) = (formula.parse().unwrap(), Default::default());
        let profile = formula.bind(ctx, &none).unwrap().broken_at(ctx, &formula.breaks(&none).unwrap());
        Weighted::graded(profile, R::from_literal(ctx, &k.parse().unwrap()))
    }
    let kink: f64 = 0.3 * 0.5761;
    // Within the roundings of the kink there is a side to be on.
    for x in [kink.next_down(), kink, kink.next_up(), kink * (1.0 + 1e-15)] {
        for formula in ["max(r/0.5761 - 0.3, 0)^2", "r^2 + max(r/0.5761 - 0.3, 0)"] {
            assert!(transform::<f64>(formula, (), "0.5").slope(&x).is_ok(), "{formula} {x}");
        }
    }
    let (far, near) = ([1.3, 40.0, 1e3, 3e5, 2e6, 1e8, 1e12], [1e-6, 1e-3]);
    let radii = far.iter().map(|ratio| kink * ratio).chain(near.iter().map(|share| kink * (1.0 + share)));
    for x in radii {
        for (formula, k) in [("max(r/0.5761 - 0.3, 0)^2", "-0.5"), ("r^2 + max(r/0.5761 - 0.3, 0)", "0.5")] {
            let ctx = Precision::new(160);
            let (doubles, truth) = (transform::<f64>(formula, (), k), transform::<Float>(formula, ctx, k));
            let exact = Float::from_f64(ctx, x);
            let pairs = [
                (doubles.g(&x), truth.g(&exact)),
                (doubles.slope(&x), truth.slope(&exact)),
                (doubles.mean(&x), truth.mean(&exact)),
            ];
            // The distance from the kink has few digits.
            let lost = 4e-15 * x / (x - kink);
            for (index, (value, truth)) in pairs.into_iter().enumerate() {
                let at = format!("{formula} {index} {x:e}");
                let (value, truth) = (value.expect(&at), truth.expect(&at).to_f64());
                assert!((value - truth).abs() <= (1e-12 + lost) * truth.abs(), "{at}: {value} {truth}");
            }
        }
    }
}

/// Maugis and Dugdale on a graded half-space: values that were computed elsewhere, and the half-space as k = 0.
#[test]
fn a_ring_of_attraction_on_a_graded_half_space() {
    use mdr_numeric::dugdale::{Dugdale, state_on_graded};
    let k = 0.3_f64;
    let kappa = mdr_numeric::transform::graded_kappa(&2.0, &k);
    let square = Powers::new([[2.0, kappa, (1.0 + k) / (3.0 + k)]]).unwrap();
    let state = state_on_graded(&contact(square, Medium::graded(1.0, k).unwrap()), &1.0, &0.3).unwrap();
    let expected = [0.3 * 1.002_200_220_045_070_3, -0.025_668_656_600_878_8, -0.025_910_427_927_081_932];
    for (found, expected) in [state.outer_radius, state.indentation, state.force].into_iter().zip(expected) {
        // The ring is a 450th of a wide, and known to half of the digits less three.
        assert!((found / expected - 1.0).abs() < 1e-10, "{found} {expected}");
    }
    #[cfg(feature = "mp")]
    ring_in_many_digits();
    let homogeneous = contact(Quadrature::new(ball()), Medium::half_space(1.0).unwrap());
    let separation = WORK / 0.5;
    let one = state_on_graded(&homogeneous, &0.5, &0.3).unwrap();
    let other = Dugdale::new(homogeneous.clone(), &separation).unwrap().state(&0.3).unwrap();
    for (one, other) in
        [(one.outer_radius, other.outer_radius), (one.indentation, other.indentation), (one.force, other.force)]
    {
        assert!((one / other - 1.0).abs() < 1e-10, "{one} {other}");
    }
    let springs = contact(Quadrature::new(ball()), Medium::winkler(1.0).unwrap());
    assert!(state_on_graded(&springs, &1.0, &0.3).unwrap_err().to_string().contains("half-space"));
}

/// The state of k = 0.3 to twenty digits that were computed elsewhere: c₀/a − 1, d and F.
#[cfg(feature = "mp")]
fn ring_in_many_digits() {
    use mdr_core::number::{Literal, Precision, Real};
    use rug::Float;
    let precision = Precision::new(160);
    let number = |text: &str| Float::from_literal(precision, &text.parse::<Literal>().unwrap());
    let (k, work) = (number("3/10"), number("1/100"));
    let square = Powers::graded([(number("2"), number("1"))], &k).unwrap();
    let medium = Medium::graded(number("1"), k).unwrap();
    let adhesion = mdr_numeric::medium::Adhesion::new(work).unwrap();
    let contact = Contact::new(square, medium, adhesion, Control::Force);
    let a = number("3/10");
    let state = mdr_numeric::dugdale::state_on_graded(&contact, &number("1"), &a).unwrap();
    let found = [state.outer_radius / &a - 1u32, state.indentation, state.force];
    let expected = ["0.0022002200450702519046", "-0.025668656600878799994", "-0.025910427927081932706"];
    for (found, expected) in found.into_iter().zip(expected) {
        let error = ((found.clone() - number(expected)) / number(expected)).abs();
        assert!(error < 1e-19, "{found} {expected}");
    }
}

/// At fixed grips the folds on springs are where g' = 0. Below the range of doubles nothing of a power law is searched.
#[test]
fn springs_at_grips_are_searched_in_few_evaluations() {
    for n in [0.3, 1.0, 1.5, 2.0, 4.0] {
        let tally = Arc::new(EvaluationCounter::default());
        let counted = CountingTransform::new(Box::new(Powers::winkler([(n, 0.5)]).unwrap()), &tally);
        let found = folds::find(&contact(counted, Medium::winkler(1.0).unwrap())).unwrap();
        assert!(found.is_empty() && found.completeness == SearchQuality::Resolved, "n = {n}: {found:?}");
        let evaluations = tally.read();
        assert!(evaluations.slope < 4000, "n = {n}: {evaluations:?}");
    }
}
