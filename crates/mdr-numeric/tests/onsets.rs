//! Formulas with powers that begin at a radius, such as max(0, r − b)^1.5: against closed forms, and quadratures of mpmath.
#![cfg(feature = "mp")]
#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::sync::Arc;

use mdr_core::contact::{Control, Expression, FoldKind, Material, Transform};
use mdr_core::number::{Dual, Interval, Precision, Real};
use mdr_numeric::admissible::GapVerdict;
use mdr_numeric::contact::Contact;
use mdr_numeric::proof::{Continuation, EnclosedEnergy, EnclosedGaps};
use mdr_numeric::transform::{Enclosed, EnclosedWithSlopes};

use crate::enclosed::{all_folds, enclosed, number};

/// A formula, a radius, and g there: x∫f' dr/√(x² − r²) over v with r = b + (x − b)v²(2 − v²), by mpmath to sixty digits.
#[rustfmt::skip]
const QUADRATURES: [[&str; 3]; 5] = [
    ["max(0, r - 0.3)^1.5", "0.7", "0.580011042562725593814189575963568749254478466715053530562463"],
    ["r^2/2 - 0.1*max(0, r - 0.3)^1.5", "0.7", "0.431998895743727440618581042403643125074552153328494646943754"],
    ["r*max(r - 0.3, 0)^(3/4)", "0.7", "0.761003422512713339332775725120519155870332823854829212071583"],
    ["2.2*max(0, r - 0.3)^1.2/1.2", "0.30001", "0.000482594988150496204945019312706472674366764111283058131537699"],
    ["-sqrt(max(0, r^2 - 0.09)^1.5)", "0.7", "-1.00048815052546454466475334308712016802326625262672828924063"],
];

/// Also at so few bits that a missing remainder would show.
#[test]
fn quadratures_are_contained() {
    for [formula, x, truth] in QUADRATURES {
        let truth = number(truth, 400);
        let truth = truth.clone().inflate(&(truth.abs() * number("1e-55", 400)));
        for bits in [16, 24, 40, 64, 114, 160] {
            let g = enclosed(formula, bits).g(&number(x, bits)).unwrap();
            assert!(g.overlaps(&truth), "{formula} at {bits} bits: {g} without {truth}");
            // x − b cancels.
            let lost = if x == "0.7" { 16 } else { 32 };
            assert!(g.accuracy_bits() > i64::from(bits) - lost, "{formula} at {bits} bits: {g}");
        }
    }
}

/// c(r² − b²)^(3/2) has g = (3π/4) c x(x² − b²), and ∫g = (3π/16) c (x² − b²)².
struct Cubic {
    b: Interval,
    c: Interval,
}

impl Cubic {
    /// The mean of g, g, g' and g'' at x ≥ b.
    fn at(&self, x: &Interval) -> [Interval; 4] {
        let (square, b) = (x.square(), self.b.square());
        let unit = self.c.clone() * x.pi().times(3).over(4);
        let rise = square.clone() - &b;
        [
            rise.square() / x.clone().times(4) * &unit,
            rise * x * &unit,
            (square.times(3) - b) * &unit,
            x.clone().times(6) * unit,
        ]
    }
}

fn found(values: &Enclosed, x: &Interval) -> [Interval; 4] {
    let slopes = EnclosedWithSlopes::new(values.clone());
    let bend = slopes.slope(&Dual::variable(x.clone())).unwrap();
    assert!(bend.value.overlaps(&values.slope(x).unwrap()), "{x}");
    [values.mean(x).unwrap(), values.g(x).unwrap(), values.slope(x).unwrap(), bend.slope]
}

#[test]
fn a_cubic_has_its_closed_form_at_radii_and_over_intervals() {
    let formula = "r^2/2 - 0.7*sqrt(max(0, 2*r^2 - 2/9)^3)";
    for bits in [16, 24, 53, 64, 100] {
        let values = enclosed(formula, bits);
        let one = number("1", bits);
        let cubic = Cubic { b: one.ratio(1, 3), c: -number("0.7", bits) * Real::sqrt(&one.lit(8)) };
        let truth = |x: &Interval| {
            let paraboloid = [x.square().over(3), x.square(), x.clone().times(2), x.lit(2)];
            let cubic = cubic.at(x);
            [0, 1, 2, 3].map(|k: usize| paraboloid[k].clone() + &cubic[k])
        };
        for x in ["0.3334", "0.35", "0.5", "0.9", "30"] {
            let x = number(x, bits);
            for (k, (found, truth)) in found(&values, &x).iter().zip(truth(&x)).enumerate() {
                assert!(found.overlaps(&truth), "{k} at {x}, {bits} bits: {found} without {truth}");
            }
        }
        for [from, to] in [["0.3334", "0.34"], ["0.4", "0.41"], ["0.5", "0.9"], ["0.34", "2"], ["0.3", "0.4"]] {
            let [from, to] = [from, to].map(|end| number(end, bits));
            let over = from.hull(&to);
            let wide = found(&values, &over);
            for share in 0..=8 {
                let x = (from.clone() + (to.clone() - &from).times(share).over(8)).midpoint();
                if x < cubic.b {
                    continue;
                }
                for (k, (found, truth)) in wide.iter().zip(truth(&x)).enumerate() {
                    assert!(found.overlaps(&truth), "{k} over {over}, {bits} bits: {found} without {truth}");
                }
            }
        }
    }
    // Over a narrow interval the enclosures are narrow.
    let over = number("0.4", 64).hull(&number("0.401", 64));
    let [_, g, slope, bend] = found(&enclosed(formula, 64), &over);
    assert!(g.accuracy_bits() > 3 && slope.accuracy_bits() > 3 && bend.accuracy_bits() > 2, "{g} {slope} {bend}");
}

/// g' begins as (x − b)^(e − 3/2).
#[test]
fn slopes_beside_an_onset() {
    let margin = number("1e-3", 64);
    let kink = |formula: &str| enclosed(formula, 64).kink(0, &margin).unwrap().expect("known");
    // g' = 3x² − b² times 3π/4, and 2b²·3π/4 at b.
    let finite = kink("r^2/2 + max(0, r^2 - 1)^1.5");
    let (g, mean) = finite.value.unwrap();
    assert!((g.approx() - 1.0).abs() < 1e-15 && (mean.approx() - 1.0 / 3.0).abs() < 1e-15);
    let [least, most] = [finite.outside.least.unwrap(), finite.outside.greatest.unwrap()];
    let [at, far] = [2.0, 2.0 + 6e-3].map(|share| 2.0 + share * 0.75 * std::f64::consts::PI);
    assert!(least.lower().to_f64() < at && least.lower().to_f64() > at - 0.05, "{least}");
    assert!(most.upper().to_f64() > far && most.upper().to_f64() < far + 0.05, "{most}");
    assert!((finite.inside.least.unwrap().approx() - 2.0).abs() < 2e-3);
    // (a − 1/2) B(a + 1/2, 1/2)… of (r² − 1)^1.2 grows beyond all bounds, and that of (r² − 1)^1.8 begins at 0.
    let steep = kink("r^2/2 - max(0, r^2 - 1)^1.2");
    assert!(steep.outside.least.is_none() && *steep.outside.greatest.unwrap().upper() < -10);
    let flat = kink("r^2/2 - max(0, r^2 - 1)^1.8");
    let least = flat.outside.least.unwrap();
    // 2 − 2.3 · 2.6 B(2.8, 1/2) 0.002^0.3 = 0.974
    assert!(*least.lower() > 0.9 && *least.lower() < 0.976, "{least}");
    // Kinks of other kinds beside it in the same formula, and two powers that begin together.
    let both = enclosed("r^2/2 + max(0, r - 1) + max(0, r - 2)^1.5 - max(0, r - 2)^2.5", 64);
    let [first, second] = [0, 1].map(|index| both.kink(index, &margin).unwrap().expect("known"));
    assert!(both.kinks().len() == 2 && first.outside.greatest.is_none() && second.outside.greatest.is_some());
}

/// x² − (3π/4) c x(x² − b²) has its maximum where 2x = (3π/4) c (3x² − b²).
#[test]
fn folds_beyond_an_onset_are_proved() {
    let folds = all_folds("r^2/2 - 0.5*max(0, r^2 - 0.01)^1.5");
    let (kind, x) = *folds.last().unwrap();
    let slope = 2.0 * x - 0.75 * std::f64::consts::PI * 0.5 * (3.0 * x * x - 0.01);
    assert!(kind == FoldKind::Maximum && slope.abs() < 1e-5, "{x} {slope}");
}

/// With g = c x² + k x(x² − b²) beyond b the square integral is a polynomial. At so few bits that a missing remainder would show, also
/// without a paraboloid, c = 0, whose remainder would hide that of the power.
#[test]
fn energies_beyond_an_onset() {
    for (c, text) in [(1, "r^2/2 - 0.5*max(0, r^2 - 0.25)^1.5"), (0, "-0.5*max(0, r^2 - 0.25)^1.5")] {
        let (formula, none): (Expression, _) = (text.parse().unwrap(), Default::default());
        for bits in [16, 24, 40, 64, 100] {
            let precision = Precision::new(bits);
            let bound = || formula.enclosed(&none, &formula.breaks(&none).unwrap(), precision).unwrap();
            let one = number("1", bits);
            let material = Material::new(one.clone(), one.clone()).unwrap();
            let transform = Arc::new(Enclosed::new(bound(), precision));
            let contact = Contact::half_space(&transform, &material, &Control::Indentation);
            let profile = Continuation::new(vec![bound()]).unwrap();
            for a in ["0.501", "0.8", "1.3"] {
                let (a, d) = (number(a, bits), number("0.3", bits));
                let truth = energy_of_cubic(&a, &d, c);
                let energy = EnclosedEnergy::new(&contact, &profile).unwrap().potential(&a, &d).unwrap();
                assert!(energy.overlaps(&truth), "{text}, {a} at {bits} bits: {energy} without {truth}");
                let lost = i64::from(bits) - energy.accuracy_bits();
                assert!(lost < 20, "{text}, {a} at {bits} bits: {energy}");
            }
        }
    }
}

/// E*(a d² − 2d ∫g + ∫g²) − πa²w of these formulas, with b = 1/2 and k = −3π/8.
fn energy_of_cubic(a: &Interval, d: &Interval, c: i64) -> Interval {
    let (k, b) = (-(a.pi().times(3)).over(8), a.lit(1).over(2));
    let from_b = |n: i64| (a.powi(n) - b.powi(n)).over(n);
    let square = b.square();
    // ∫x³(x² − b²), ∫x²(x² − b²)² and ∫x(x² − b²) from b on.
    let product = from_b(6) - from_b(4) * &square;
    let own = from_b(7) - from_b(5) * square.clone().times(2) + from_b(3) * square.square();
    let integral = a.powi(3).over(3).times(c) + (from_b(4) - from_b(2) * &square) * &k;
    let squares = a.powi(5).over(5).times(c) + (product * &k).times(2 * c) + own * k.square();
    a.clone() * d.square() - (integral * d).times(2) + squares - a.square() * a.pi()
}

/// A state beyond an onset is admissible where g rises, and not where a dip lies further out.
#[test]
fn gaps_outside_contacts_beyond_an_onset() {
    let precision = Precision::new(64);
    let verdict = |text: &str, a: &str| {
        let (formula, none): (Expression, _) = (text.parse().unwrap(), Default::default());
        let bound = || formula.enclosed(&none, &formula.breaks(&none).unwrap(), precision).unwrap();
        let material = Material::new(number("1", 64), number("1e-6", 64)).unwrap();
        let contact =
            Contact::half_space(&Arc::new(Enclosed::new(bound(), precision)), &material, &Control::Indentation);
        let a = number(a, 64);
        let d = contact.indentation(&a).unwrap();
        EnclosedGaps::new(contact, Continuation::new(vec![bound()])).unwrap().verdict(&a, &d)
    };
    assert_eq!(verdict("r^2/2 - 0.1*max(0, r - 0.1)^1.5", "0.16"), GapVerdict::Admissible);
    assert_eq!(verdict("r^2/2 - 0.1*max(0, r - 0.1)^1.2", "0.3"), GapVerdict::Admissible);
    // Two powers that begin together.
    let both = "r^2/2 - 0.1*max(0, r - 0.1)^1.5 + 0.1*max(0, r - 0.1)^2.5 - 0.06*exp(-((r - 0.4)*100)^2)";
    assert!(matches!(verdict(both, "0.2"), GapVerdict::Interpenetrating { .. }));
    let dipped = verdict("r^2/2 - 0.1*max(0, r - 0.1)^1.5 - 0.06*exp(-((r - 0.4)*100)^2)", "0.2");
    let GapVerdict::Interpenetrating { radius, .. } = dipped else { panic!("{dipped:?}") };
    assert!((radius - 0.4).abs() < 0.02, "{radius}");
}

/// Where g jumps, or where a power stands under another function, nothing is split, and nothing is proved.
#[test]
fn what_is_no_sum_is_left_as_it_is() {
    for formula in ["r^2 + sqrt(max(0, r - 0.3))", "sqrt(r^4 + max(0, r - 0.3)^1.5)", "r^2 + max(0, sin(r))^1.5"] {
        let (formula, none) = (formula.parse::<Expression>().unwrap(), Default::default());
        let bound = formula.enclosed(&none, &formula.breaks(&none).unwrap(), Precision::new(64)).unwrap();
        assert!(bound.onsets().is_none(), "{formula:?}");
    }
}
