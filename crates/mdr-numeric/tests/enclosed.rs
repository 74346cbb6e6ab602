//! g, g', g'' and the mean of formulas as enclosures, against closed forms and against quadratures of many digits.
#![cfg(feature = "mp")]
#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::sync::Arc;

use mdr_core::contact::{Control, Error, Expression, FoldKind, Material, Transform};
use mdr_core::number::{Dual, Interval, Literal, Precision, Real};
use mdr_numeric::contact::Contact;
use mdr_numeric::proof::EnclosedCurve;
use mdr_numeric::transform::{Enclosed, EnclosedWithSlopes, Quadrature, Weighted};
use proptest::prelude::*;
use rug::Float;

/// Formulas, a radius, and g there by routes that share nothing with enclosures: Struve and Γ functions, artanh, and a
/// quadrature of 240 digits that is split around the dip.
#[rustfmt::skip]
const CLOSED: [(&str, &str, &str); 4] = [
    ("r^2/2 + 5e-4*(1 - cos(20*pi*r))", "0.09", "0.007113336583370309697484406286834763264881201126187106371545616557217598055448475451191102285888525440834509956271296016224588533701559640373199198747890921714687238236054716803319639041424989130684948061786941008887259599675197498082"),
    ("r^0.25", "1.7", "1.328657888132246719110117310998104308591702074718780929090340753311004809451632889246735020362752153313288443762635240754803384927638647677639331894542179883496994092626752115850532422144882421673036636781238709988180595787034949656"),
    ("1 - sqrt(1 - r^2)", "0.9", "1.324997540624898207004062344349534091756820667584607968342082106384181715928888779921371272717082953108668284949337561357059879205806594275069084997841720394137514376201845420856327900324435271574124850780163163981966647580832459794"),
    ("r^2/2 - 0.2*(exp(-(10000*(r - 0.5037))^2) - exp(-(10000*0.5037)^2))", "0.6", "0.3603091808568596376507771918510198214228561314954978924189509809762026219303634361149507919317023848939164095466652998466461403204246025502019796327509638084371533606191178629216774259645728541429361857895724879514159352198723242098"),
];

/// Formulas that enclosures do not see to be analytic at the axis, or that are not: sums of power laws, closed forms and a quadrature, by
/// mpmath.
#[rustfmt::skip]
const AT_AXIS: [(&str, &str, &str); 6] = [
    ("(1 - cos(r))/r", "0.9", "0.6376640558446435818938957959006980438932334411141645661012614002"),
    ("r^-1*(1 - cos(r)) + r - r^3/r^2", "0.9", "0.6376640558446435818938957959006980438932334411141645661012614002"),
    ("(exp(r^2) - 1)/sqrt(r)", "0.9", "2.7729355195928359249730097333415690680141892266476296438244524420"),
    ("r^2*ln(1/r)", "0.3", "0.1819486122778783229769925373346591482780599433602382886320316404"),
    ("-r^1.5*ln(r)", "0.3", "0.2854217472558083297354333067176571047"),
    ("r^2*ln(1 + 1/r)", "0.3", "0.23668713897074844799621668360046519071973"),
];

/// √π Γ(n/2 + 1)/Γ((n + 1)/2) xⁿ at n = 7/3 and x = 1.7, by mpmath.
const POWER: &str = "7.32971773795353583841786058369635937968075274339179182903907533409996312093";

/// g of √(r + r²) at x = 1.1, by mpmath.
const ROOT: &str = "2.191947134134347283397770087515737114346778460125556105190109159768139";

pub(crate) fn enclosed(formula: &str, bits: u32) -> Enclosed {
    let (formula, none) = (formula.parse::<Expression>().unwrap(), Default::default());
    let precision = Precision::new(bits);
    Enclosed::new(formula.enclosed(&none, &formula.breaks(&none).unwrap(), precision).unwrap(), precision)
}

pub(crate) fn number(text: &str, bits: u32) -> Interval {
    Interval::from_literal(Precision::new(bits), &text.parse::<Literal>().unwrap())
}

fn quadrature(formula: &str, bits: u32) -> impl Transform<Float> {
    let (formula, none) = (formula.parse::<Expression>().unwrap(), Default::default());
    let precision = Precision::new(bits);
    let breaks = formula.breaks(&none).unwrap();
    Quadrature::new(formula.bind::<Float>(precision, &none).unwrap().broken_at(precision, &breaks))
}

/// At 20, 50 and 200 digits, and at so few bits that a missing remainder would show.
#[test]
fn closed_forms_are_contained() {
    for (formula, x, truth) in CLOSED {
        let truth = number(truth, 900).inflate(&number("1e-231", 900));
        for bits in [16, 24, 40, 64, 114, 214, 712] {
            let g = enclosed(formula, bits).g(&number(x, bits)).unwrap();
            assert!(g.overlaps(&truth), "{formula} at {bits} bits: {g} without {truth}");
            assert!(g.accuracy_bits() > i64::from(bits) - 24, "{formula} at {bits} bits: {g}");
        }
    }
}

/// (1 + r)³ − 1 − 3r − r³/2 is 3r² + r³/2, with g = 6x² + 3πx³/8: what cancels in sums of powers costs no digits.
#[test]
fn what_cancels_in_sums_of_powers_costs_nothing() {
    for formula in ["(1 + r)^3 - 1 - 3*r - r^3/2", "r*(r + 2)^2 - 4*r - 4*r^2 + 3*r^2 - r^3/2"] {
        for x in ["1e-40", "1", "1e40"] {
            for bits in [24, 64, 114] {
                let (at, exact) = (number(x, bits), number(x, 400));
                let truth = exact.square().times(6) + exact.pi().times(3).over(8) * exact.powi(3);
                let g = enclosed(formula, bits).g(&at).unwrap();
                assert!(g.overlaps(&truth), "{formula} at {x}, {bits} bits: {g} without {truth}");
                assert!(g.accuracy_bits() > i64::from(bits) - 24, "{formula} at {x}, {bits} bits: {g}");
            }
        }
    }
}

/// Far outside of a bump of width 1 samples of the integrand see nothing of it. g of 1 − e^(−r²) is 2x D(x) with Dawson's integral D: the
/// sum of tₖ = (2k − 1)!!/(2x²)ᵏ, asymptotically.
#[test]
fn bumps_are_contained_far_outside_of_them() {
    for (x, octaves) in [("20", 12), ("200", 18), ("1e4", 30), ("1e6", 42)] {
        for bits in [24, 64, 114, 214] {
            let square = number(x, 400).square().times(2);
            let one = square.lit(1);
            let (mut g, mut slope, mut term) = (one.clone(), one.lit(0), one.clone());
            for k in 1..=40 {
                term = term.times(2 * k - 1) / &square;
                g += &term;
                slope -= &term.clone().times(2 * k);
            }
            let error = term.abs().times(100);
            let [g, slope] = [g, slope / number(x, 400)].map(|truth| truth.inflate(&error));
            let (enclosed, at) = (enclosed("1 - exp(-r^2)", bits), number(x, bits));
            let found = [enclosed.g(&at), enclosed.slope(&at)].map(Result::unwrap);
            assert!(found[0].overlaps(&g) && found[1].overlaps(&slope), "{x} at {bits} bits: {found:?}");
            assert!(found[0].accuracy_bits() > i64::from(bits) - 24, "{x} at {bits} bits: {}", found[0]);
            // x g' is so much less than what is integrated.
            let accuracy = found[1].accuracy_bits();
            assert!(accuracy > i64::from(bits) - 24 - octaves, "{x} at {bits} bits: {} ({accuracy} bits)", found[1]);
        }
    }
}

/// Fractional powers of r, integrated over the root of r in which they are analytic at the axis: r^(7/3) against its closed form,
/// √(r + r²) against a quadrature of mpmath, also at so few bits that a missing remainder would show.
#[test]
fn fractional_powers_are_contained() {
    let truth = number(ROOT, 400).inflate(&number("1e-60", 400));
    for bits in [16, 24, 64, 114] {
        let g = enclosed("sqrt(r + r^2)", bits).g(&number("1.1", bits)).unwrap();
        assert!(g.overlaps(&truth) && g.accuracy_bits() > i64::from(bits) - 20, "{bits} bits: {g} without {truth}");
        let g = enclosed("r^(7/3)", bits).g(&number("1.7", bits)).unwrap();
        let expected = number(POWER, 400).inflate(&number("1e-60", 400));
        assert!(g.overlaps(&expected) && g.accuracy_bits() > i64::from(bits) - 20, "{bits} bits: {g} without {POWER}");
    }
    let pieces = |formula: &str| {
        let transform = enclosed(formula, 214);
        transform.g(&number("1.7", 214)).unwrap();
        transform.work()
    };
    // One substitution in place of many pieces towards the axis.
    assert!(pieces("sqrt(r + r^2)") < 1000, "{}", pieces("sqrt(r + r^2)"));
}

/// Also at so few bits that a missing remainder would show.
#[test]
fn quotients_and_logarithms_at_the_axis_are_contained() {
    for (formula, x, truth) in AT_AXIS {
        let truth = number(truth, 400).inflate(&number("1e-35", 400));
        for bits in [16, 24, 40, 64, 100] {
            let g = enclosed(formula, bits).g(&number(x, bits)).unwrap();
            assert!(g.overlaps(&truth), "{formula} at {bits} bits: {g} without {truth}");
            assert!(g.accuracy_bits() > i64::from(bits) - 32, "{formula} at {bits} bits: {g}");
        }
        holds(formula, x);
    }
    // A pole that is not at the axis is none of a quotient by a power of r.
    assert!(enclosed("r*(1 - cos(r))/((r - 0.1)*r)", 64).g(&number("0.3", 64)).is_err());
}

/// What two precisions of a quadrature agree on.
fn agreed(formula: &str, x: &str, what: impl Fn(&dyn Transform<Float>, &Float) -> Float) -> Option<Interval> {
    let [coarse, fine] = [160, 220].map(|bits| {
        let x = Float::from_literal(Precision::new(bits), &x.parse().unwrap());
        what(&quadrature(formula, bits), &x)
    });
    let apart = Float::with_val(220, &fine - &coarse).abs();
    let size = fine.clone().abs();
    (apart < size >> 100u32).then(|| Interval::point(fine).inflate(&Interval::point(apart)))
}

fn holds(formula: &str, x: &str) {
    let at = number(x, 80);
    let values = enclosed(formula, 80);
    let found = [values.g(&at), values.slope(&at), values.mean(&at)].map(Result::unwrap);
    let wanted = [
        agreed(formula, x, |transform, x| transform.g(x).unwrap()),
        agreed(formula, x, |transform, x| transform.slope(x).unwrap()),
        agreed(formula, x, |transform, x| transform.mean(x).unwrap()),
    ];
    for (found, wanted) in found.iter().zip(&wanted) {
        let Some(wanted) = wanted else { continue };
        assert!(found.overlaps(wanted), "{formula} at {x}: {found} without {wanted}");
    }
    // g'' by the mean value theorem: between the slopes at both ends of a small interval.
    let ends = [at.clone(), at.clone() + number("1e-9", 80)];
    let slopes = ends.each_ref().map(|end| values.slope(end).unwrap());
    let over = EnclosedWithSlopes::new(values).slope(&Dual::variable(ends[0].hull(&ends[1]))).unwrap();
    let [first, last] = slopes;
    let chord = (last - &first) / (ends[1].clone() - &ends[0]);
    assert!(over.slope.overlaps(&chord) && over.value.overlaps(&first), "{formula} at {x}: {} {chord}", over.slope);
}

#[test]
fn quadratures_are_contained() {
    for formula in [
        "r",
        "r^2/2",
        "r^1.37",
        "3*r^(1/2)",
        "0.1*(sqrt(r^2 + 0.01) - 0.1)",
        "r^2/2 + 0.01*sin(30*r)*r",
        "r^2*exp(-r)/(1 + r^2)",
        "cosh(r) - 1 + tanh(r^2)",
        "ln(1 + r^2) + log10(1 + r)",
        "atan(r)*r + asin(r/9) - acos(r/9) + acos(0)",
        "atanh(r/7) + sinh(r)^2",
        "r^2/2 - 0.1*max(0, r - 0.3)",
        "abs(r - 0.5) + r - 0.5",
        "r^2 + max(0, r - 0.4)^2",
        "min(r^2, 0.3*r) + 0.1*abs(sin(3*r))",
        "sqrt((r - 0.5)^2) + r^2 + r - 0.5",
        "r^2/2 + (2 + sin(r))^(r)*r - r",
        "sqrt(r + r^2)*cos(r)",
        "(r^2 + 3*r^3)^(3/4) + r^0.7*exp(-r)",
    ] {
        for x in ["0.11", "0.77", "2.1"] {
            holds(formula, x);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    /// Sums of powers, waves, dips and kinks, at radii that are no kink: hundredths that end in 5, from 0.55 on.
    #[test]
    fn random_formulas_are_contained(
        n in 2i32..60, c in -20i32..20, k in 1i32..90, b in 1i32..30, s in 1i32..50, t in -9i32..9, x in 5i32..30,
    ) {
        let formula = format!(
            "r^({n}/10) + 0.0{k}*sin({k}*r)*r + 0.{c}*(exp(-((r - 0.{b})*{s})^2) - exp(-(0.{b}*{s})^2)) + {t}*max(0, r - 0.{b})",
            c = c.abs(),
        );
        holds(&formula, &format!("{}", f64::from(10 * x + 5) / 100.0));
    }
}

/// Over an interval of radii: the values at radii inside, and narrow where the interval is.
#[test]
fn intervals_of_radii_are_contained() {
    for (formula, x, _) in CLOSED {
        let values = enclosed(formula, 64);
        let below = number(x, 64);
        for width in ["1e-3", "1e-5", "1e-8"] {
            let over = (below.clone() - number(width, 64) * &below).hull(&below);
            let wide = [values.g(&over), values.mean(&over), values.slope(&over)].map(Result::unwrap);
            for share in 0..=4 {
                let at = below.clone() - (number(width, 64) * &below).times(share).over(5);
                let at = at.midpoint();
                let narrow = [values.g(&at), values.mean(&at), values.slope(&at)].map(Result::unwrap);
                for (wide, narrow) in wide.iter().zip(narrow) {
                    assert!(wide.overlaps(&narrow), "{formula} over {over}: {wide} without {narrow}");
                }
            }
        }
        if formula.contains("exp") {
            continue;
        }
        // Up to 1.8 times the width by the slope, with what the rules leave.
        let over = below.clone().inflate(&(number("1e-8", 64) * &below));
        let (g, slope) = (values.g(&over).unwrap(), values.slope(&over).unwrap());
        let width = Interval::point(over.radius()) * slope.abs();
        assert!(Interval::point(g.radius()) < width.times(2), "{formula}: {g}");
    }
    // One integral shows that no fold of the wave lies in [0.09, 0.1].
    let wave = enclosed(CLOSED[0].0, 64);
    let slope = wave.slope(&number("0.09", 64).hull(&number("0.1", 64))).unwrap();
    assert!(*slope.lower() > 0.1 && *slope.upper() < 0.4, "{slope}");
}

/// Far outside of a dip, a needle or a pole that is far narrower than an interval of radii, slopes over the interval hold those inside, and
/// their signs are known.
#[test]
fn intervals_beyond_what_is_narrow_are_cut_below() {
    for formula in [
        "r^2/2 - 0.002*(exp(-((r - 0.2)*1e5)^2) - exp(-(0.2*1e5)^2))",
        "r^2/2 - 0.002*(exp(-((r - 0.2)*1e8)^2) - exp(-(0.2*1e8)^2))",
        "r^2/((r - 0.2)^2 + 1e-6)/100",
        "r^0.7 + 1e-9*(1/((r - 0.2)^2 + 1e-8) - 1/(0.2^2 + 1e-8))",
    ] {
        for [from, to] in [["0.21", "0.2103"], ["0.3", "0.305"], ["0.9", "0.92"]] {
            let values = enclosed(formula, 64);
            let over = number(from, 64).hull(&number(to, 64));
            let slopes = EnclosedWithSlopes::new(values.clone());
            let wide = slopes.slope(&Dual::variable(over.clone())).unwrap();
            let slope = values.slope(&over).unwrap();
            assert!(!slope.contains_zero() && wide.value.overlaps(&slope), "{formula} over {over}: {slope}");
            assert!(!wide.slope.contains_zero(), "{formula} over {over}: {}", wide.slope);
            let [g, mean] = [values.g(&over), values.mean(&over)].map(Result::unwrap);
            for share in 0..=4 {
                let radius = number(from, 64) + (number(to, 64) - number(from, 64)).times(share).over(4);
                let radius = radius.midpoint();
                let at = slopes.slope(&Dual::variable(radius.clone())).unwrap();
                assert!(
                    slope.overlaps(&at.value) && wide.value.overlaps(&at.value),
                    "{formula}: {slope} without {}",
                    at.value
                );
                assert!(wide.slope.overlaps(&at.slope), "{formula}: {} without {}", wide.slope, at.slope);
                let narrow = [values.g(&radius), values.mean(&radius)].map(Result::unwrap);
                for (wide, narrow) in [&g, &mean].into_iter().zip(narrow) {
                    assert!(wide.accuracy_bits() > 0 && wide.overlaps(&narrow), "{formula}: {wide} without {narrow}");
                }
            }
        }
    }
}

/// g of max(0, r − 1) is x arccos(1/x), with an infinite slope after the kink, and that of its square has none.
#[test]
fn kinks_bound_the_slope_beside_them() {
    let margin = number("1e-3", 64);
    let edge = enclosed("r^2/2 + max(0, r - 1)", 64);
    let kink = edge.kink(0, &margin).unwrap().expect("known");
    let (g, mean) = kink.value.unwrap();
    assert!((g.approx() - 1.0).abs() < 1e-15 && (mean.approx() - 1.0 / 3.0).abs() < 1e-15);
    assert!(kink.outside.greatest.is_none() && *kink.outside.least.unwrap().lower() > 20);
    assert!((kink.inside.least.unwrap().approx() - 2.0).abs() < 2e-3);
    let down = enclosed("r^2/2 - max(0, r - 1)", 64).kink(0, &margin).unwrap().expect("known");
    assert!(down.outside.least.is_none() && *down.outside.greatest.unwrap().upper() < -15);
    let smooth = enclosed("r^2/2 + max(0, r - 1)^2", 64).kink(0, &margin).unwrap().expect("known");
    let slopes = smooth.outside.greatest.unwrap();
    assert!(*slopes.lower() > 1.9 && *slopes.upper() < 2.3, "{slopes}");
}

#[test]
fn radii_out_of_the_domain_are_refused() {
    let sphere = enclosed("1 - sqrt(1 - r^2)", 64);
    for x in ["1", "1.5", "0", "-1"] {
        let error = sphere.g(&number(x, 64)).unwrap_err();
        assert!(matches!(error, Error::Domain { .. }), "{x}: {error}");
    }
    assert!(sphere.g(&number("0.99999999", 64)).unwrap().accuracy_bits() > 30);
}

/// The curve with hardly any adhesion.
fn curve(formula: &str) -> EnclosedCurve {
    let transform = enclosed(formula, 64);
    let (plain, moving) = (Arc::new(transform.clone()), Arc::new(EnclosedWithSlopes::new(transform)));
    let [one, work] = ["1", "1e-12"].map(|text| number(text, 64));
    let material = Material::new(Dual::constant(one.clone()), Dual::constant(work.clone())).unwrap();
    let moving = Contact::half_space(&moving, &material, &Control::Indentation);
    let plain = Contact::half_space(&plain, &Material::new(one, work).unwrap(), &Control::Indentation);
    EnclosedCurve::new(plain, moving).by_integrals()
}

/// The folds from 10⁻⁶ to 1, proved to be all, with hardly any adhesion.
pub(crate) fn all_folds(formula: &str) -> Vec<(FoldKind, f64)> {
    let found = curve(formula).folds(number("1e-6", 64).lower(), number("1", 64).lower(), 2000).unwrap();
    assert!(found.is_complete(), "{:?}", found.undecided);
    found.folds.iter().map(|fold| (fold.kind, fold.contact_radius.approx())).collect()
}

/// Of radii beyond the end of the profile nothing is proved.
#[test]
fn extrema_of_a_profile_that_ends() {
    let found = |formula: &str, to: &str| {
        let radii = ["1e-3", to].map(|end| number(end, 64).lower().clone());
        curve(formula).extrema(&radii[0], &radii[1], 2000)
    };
    let falling = "r^2 - r^4 + 1e-3*(1 - sqrt(1 - r^2))";
    // g' = 4x − 32x³/3 and little more.
    let inside = found(falling, "0.9").unwrap().expect("all");
    assert!(inside.len() == 1 && inside[0].contains(&Float::with_val(64, 0.375f64.sqrt())), "{inside:?}");
    assert!(found("r^2 + 1e-3*(1 - sqrt(1 - r^2))", "0.9").unwrap().expect("all").is_empty());
    assert!(matches!(found(falling, "2"), Err(Error::Unproved { .. })));
}

/// The extrema of g of (r²/2 − max(0, r − c)/10), c = 1/10 no binary fraction: a maximum at the kink, and a minimum beyond.
#[test]
fn folds_of_a_kinked_formula_are_proved() {
    let folds = all_folds("r^2/2 - 0.1*max(0, r - 0.1)");
    let [(FoldKind::Minimum, _), (FoldKind::Maximum, kink), (FoldKind::Minimum, beyond)] = folds[..] else {
        panic!("{folds:?}")
    };
    // g' = 2x − arccos(c/x)/10 − (c/x)/(10 √(1 − c²/x²)) vanishes there, but for Δl'.
    let share: f64 = 0.1 / beyond;
    let slope = 2.0 * beyond - 0.1 * share.acos() - 0.1 * share / (1.0 - share * share).sqrt();
    assert!((kink - 0.1).abs() < 1e-16 && slope.abs() < 1e-5, "{folds:?} {slope}");
}

/// A dip of width s at c leaves g = x² before it. Beside it g' is that of −W e^(−ρ²), ρ = (r − c)/s, on a line: zero where
/// ∫ φ''(ξ − t²) dt = 0 over t > 0, φ = e^(−ρ²). Far from it, where W s √π is all that counts, g is that of a ring of that weight at c.
#[test]
fn folds_beside_a_narrow_dip_are_all_found() {
    const C: f64 = 0.5037;
    // By mpmath, as zeros of its quadrature.
    const BESIDE: [f64; 2] = [-0.389_513_340_025, 1.234_772_876_095];
    for s in [1e-5_f64, 1e-7, 1e-9] {
        let folds = all_folds(&format!("r^2/2 - 0.2*(exp(-((r - 0.5037)/{s:e})^2) - exp(-(0.5037/{s:e})^2))"));
        let [_, (FoldKind::Maximum, before), (_, inside), (_, outside), (FoldKind::Minimum, far)] = folds[..] else {
            panic!("{folds:?}")
        };
        assert!(before < C && before > C - 9.0 * s, "{folds:?}");
        for (found, expected) in [inside, outside].into_iter().zip(BESIDE) {
            assert!(((found - C) / s - expected).abs() < 1e-4 + 1e-15 / s, "{found}");
        }
        // g' = 2x + W s √π c ((x² − c²)^(−3/2) − 3x² (x² − c²)^(−5/2))
        let square = far * far - C * C;
        let ring = 0.2 * s * std::f64::consts::PI.sqrt() * C;
        let slope = ring * (3.0 * far * far / square - 1.0) / square.powf(1.5);
        assert!((slope / (2.0 * far) - 1.0).abs() < 1e-4, "{far}: {slope}");
    }
}

/// A formula on a medium, over enclosures and over numbers of many bits: by another variable of integration and another rule.
fn on_medium(formula: &str, [kind, value]: [&str; 2], bits: u32) -> (Enclosed, impl Transform<Float> + use<>) {
    let (formula, none) = (formula.parse::<Expression>().unwrap(), Default::default());
    let (precision, fine) = (Precision::new(bits), Precision::new(200));
    let breaks = formula.breaks(&none).unwrap();
    let bound = formula.enclosed(&none, &breaks, precision).unwrap();
    let heights = formula.bind::<Float>(fine, &none).unwrap().broken_at(fine, &breaks);
    let literal: Literal = value.parse().unwrap();
    let (tight, wide) = (Interval::from_literal(precision, &literal), Float::from_literal(fine, &literal));
    match kind {
        "graded" => (Enclosed::graded(bound, precision, tight), Weighted::graded(heights, wide)),
        "winkler" => (Enclosed::winkler(bound, precision), Weighted::winkler(heights, wide)),
        _ => (Enclosed::line(bound, precision, Some(tight)), Weighted::line(heights, Some(wide.clone()), wide)),
    }
}

const MEDIA: [[&str; 2]; 6] =
    [["graded", "0.3"], ["graded", "-0.6"], ["graded", "0.9"], ["graded", "-0.95"], ["winkler", "1"], ["line", "3"]];

/// g, g', g'' and the mean on other media; at few bits a term that is left out shows.
#[test]
fn enclosures_on_media_hold_quadratures() {
    let formulas =
        ["sqrt(r^2 + 0.04) - 0.2", "r^2/2 + 0.3*max(0, r - 0.2)", "min(r, 0.3)^2/0.6 + max(r - 0.3, 0)", "r^1.5"];
    for formula in formulas {
        for medium in MEDIA {
            let is_rough = formula.ends_with("1.5");
            let (enclosed, quadrature) = on_medium(formula, medium, if is_rough { 60 } else { 100 });
            let slopes = EnclosedWithSlopes::new(enclosed.clone());
            for x in [0.1, 0.25, 0.7] {
                let at = |x: f64| Float::with_val(200, x);
                let radius = Interval::from_f64(Precision::new(if is_rough { 60 } else { 100 }), x);
                let moving = Dual::variable(radius.clone());
                // A difference of g' of 200 bits over a distance of 60: half of its digits are of g''.
                let h = Float::with_val(200, Float::i_exp(1, -60));
                let [below, above] = [-1, 1].map(|side| quadrature.slope(&(at(x) + h.clone() * side)).unwrap());
                let bend = (above - below) / (h * 2u32);
                let pairs = [
                    ("g", enclosed.g(&radius).unwrap(), quadrature.g(&at(x)).unwrap(), 0),
                    ("g'", enclosed.slope(&radius).unwrap(), quadrature.slope(&at(x)).unwrap(), 0),
                    ("mean", enclosed.mean(&radius).unwrap(), quadrature.mean(&at(x)).unwrap(), 0),
                    ("g''", slopes.slope(&moving).unwrap().slope, bend, 70),
                ];
                for (name, found, expected, spared) in pairs {
                    let error =
                        Interval::point(expected.clone().abs() * Float::with_val(64, Float::i_exp(1, spared - 150)));
                    let near = Interval::point(expected.clone()).inflate(&error);
                    assert!(found.overlaps(&near), "{formula} {medium:?} {name}({x}): {found:?} {expected}");
                    let bits = if is_rough { 20 } else { 60 };
                    let is_zero = expected.is_zero() || formula.starts_with("min") && x < 0.3 && name == "g''";
                    assert!(is_zero || found.accuracy_bits() > bits, "{formula} {medium:?} {name}({x}): {found:?}");
                }
                let mean = slopes.mean(&moving).unwrap();
                let [below, above] = [-1, 1].map(|side| {
                    let h = Float::with_val(200, Float::i_exp(side, -60));
                    quadrature.mean(&(at(x) + h)).unwrap()
                });
                let change = (above - below) / Float::with_val(200, Float::i_exp(2, -60));
                let error = Interval::point(change.clone().abs() * Float::with_val(64, Float::i_exp(1, -80)));
                assert!(
                    mean.slope.overlaps(&Interval::point(change).inflate(&error)),
                    "{formula} {medium:?} mean'({x})"
                );
            }
        }
    }
}

/// Over intervals of radii, narrow and wide, enclosures hold what they hold at the radii within.
#[test]
fn wide_enclosures_on_media() {
    for formula in ["sqrt(r^2 + 0.04) - 0.2", "r^2/2 + 0.3*max(0, r - 0.2)"] {
        for medium in MEDIA {
            let (enclosed, _) = on_medium(formula, medium, 100);
            let slopes = EnclosedWithSlopes::new(enclosed.clone());
            for (from, to) in [(0.25, 0.2501), (0.15, 0.26), (0.25, 0.4), (0.02, 0.9)] {
                let [low, high] = [from, to].map(|x| Interval::from_f64(Precision::new(100), x));
                let all = low.hull(&high);
                let (slope, moving) =
                    (enclosed.slope(&all).unwrap(), slopes.slope(&Dual::variable(all.clone())).unwrap());
                for share in 0..=6 {
                    let x = low.clone() + (high.clone() - &low).times(share).over(6);
                    let one = enclosed.slope(&x).unwrap();
                    let one_moving = slopes.slope(&Dual::variable(x.clone())).unwrap();
                    assert!(one.overlaps(&slope) && one.overlaps(&moving.value), "{formula} {medium:?} {from}");
                    assert!(one_moving.slope.overlaps(&moving.slope), "{formula} {medium:?} {from}");
                    assert!(enclosed.g(&x).unwrap().overlaps(&enclosed.g(&all).unwrap()), "{formula} {medium:?}");
                }
                if from == 0.25 {
                    assert!(slope.is_finite(), "{formula} {medium:?}");
                }
            }
        }
    }
}

/// The mean of N against a reference is the integral it is defined by.
#[test]
fn the_mean_against_a_reference_is_its_integral() {
    use mdr_core::calculus::quadrature::tanh_sinh;
    for formula in ["sqrt(r^2 + 0.04) - 0.2", "r^2/2"] {
        let (_, quadrature) = on_medium(formula, ["line", "3"], 100);
        for b in [0.1_f64, 0.7, 2.9] {
            let b = Float::with_val(200, b);
            let goal = Float::with_val(200, Float::i_exp(1, -90));
            let integral = tanh_sinh(&Float::new(200), &b, &goal, |c| {
                let share = c.clone() / 3u32;
                Ok(quadrature.g(c)? / c / Float::with_val(200, 1u32 - share.square()).sqrt())
            });
            let expected = integral.unwrap().value * 2u32 / Real::pi(&b);
            let found = quadrature.mean(&b).unwrap();
            let error = (found.clone() - &expected) / &expected;
            assert!(error.abs() < 1e-25, "{formula} {b}: {found} {expected}");
        }
    }
}
