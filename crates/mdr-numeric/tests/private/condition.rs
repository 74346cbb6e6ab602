//! What doubles say of the condition of folds beside what two hundred bits say.

use std::sync::Arc;

use mdr_core::contact::Material;
use mdr_core::number::{Precision, Special};
use rug::Float;

use super::super::staircase::tests::bumpy;
use super::super::{EnclosedCurve, ProvedFolds};
use super::*;

const BITS: u32 = 200;

/// The rows with bumps on a half-space, in an arithmetic.
fn contact<R: Special>(ctx: R::Ctx, control: Control<R>) -> Contact<R> {
    let number = |text: &str| R::from_literal(ctx, &text.parse().expect("a number"));
    let transform = Arc::new(bumpy().profile::<R>(ctx).expect("a table"));
    let material = Material::new(number("1"), number("1e-3")).expect("positive");
    Contact::half_space(&transform, &material, &control)
}

fn in_doubles() -> CurveInDoubles {
    CurveInDoubles::new(contact((), Control::Force), contact((), Control::Force))
}

fn in_bits(bits: u32) -> EnclosedCurve {
    let precision = Precision::new(bits);
    EnclosedCurve::new(contact(precision, Control::Force), contact(precision, Control::Force))
}

/// Radii within the table, none of them at a row.
fn radii() -> impl Iterator<Item = f64> {
    (1..200).map(|step| 0.013 + 0.00637 * f64::from(step))
}

#[test]
fn doubles_hold_what_bits_say() {
    let (doubles, bits) = (in_doubles(), in_bits(BITS));
    for a in radii() {
        let exact = bits.with_slope(&Interval::from_f64(Precision::new(BITS), a)).expect("within the table");
        let at = DoubleInterval::point(a);
        let dual = doubles.with_slope(at).expect("no error").expect("within the table");
        let plain = condition(&doubles.plain, &at).expect("no error").expect("within the table");
        for (held, what) in [(plain, &exact.value), (dual.value, &exact.value), (dual.slope, &exact.slope)] {
            let held = held.widened(Precision::new(BITS));
            assert!(held.lower() <= what.lower() && what.upper() <= held.upper(), "{a}: {held} {what}");
            // Roundings of some hundred operations, magnified where bumps are narrow.
            assert!(Float::with_val(53, held.radius()) < 1e-10 * (1.0 + what.approx().abs()), "{a}: {held}");
        }
    }
}

/// A cell of which doubles say that it has no zero, or one at most, has the signs of that in bits at its ends and within.
#[test]
fn doubles_say_nothing_that_bits_deny() {
    let (doubles, bits) = (in_doubles(), in_bits(BITS));
    let precision = Precision::new(BITS);
    let mut said = [0; 3];
    for (a, width) in radii().flat_map(|a| [0.03, 3e-3, 1e-5].map(|width| (a, width))) {
        let radii = (0..=6).map(|part| Interval::from_f64(precision, a + width * f64::from(part) / 6.0));
        let values: Vec<Interval> = radii.map(|a| bits.condition(&a).expect("no error")).collect();
        let [first, last] = [a, a + width].map(|end| Interval::from_f64(precision, end));
        let zero = first.lit(0);
        let changes = values.windows(2).filter(|pair| (pair[0] < zero) != (pair[1] < zero)).count();
        match doubles.behaviour(&first.hull(&last)).expect("no error") {
            Some(Behaviour::Nonzero) => {
                said[0] += 1;
                assert_eq!(changes, 0, "{a} {width}");
            }
            Some(Behaviour::Monotone) => {
                said[1] += 1;
                let rises = values.windows(2).all(|pair| pair[0] < pair[1]);
                let falls = values.windows(2).all(|pair| pair[0] > pair[1]);
                assert!(rises || falls, "{a} {width}");
            }
            _ => said[2] += 1,
        }
        let sign = doubles.signed_condition(&first).expect("no error");
        assert!(sign.is_none_or(|sign| (sign < zero) == (values[0] < zero)), "{a}");
    }
    assert!(said.iter().all(|count| *count > 10), "{said:?}");
}

/// The folds, cells and kinks of a proof with the help of doubles are those without.
#[test]
fn folds_are_the_same_with_doubles() {
    let [lower, upper] = [1e-3, 1.29].map(|end| Float::with_val(64, end));
    let folds = |curve: EnclosedCurve| curve.folds(&lower, &upper, 100_000).expect("no error");
    let trends = |proved: &ProvedFolds| {
        assert!(proved.is_complete(), "{:?}", proved.undecided);
        proved.folds.iter().map(|fold| fold.kind).collect::<Vec<_>>()
    };
    let (helped, alone) = (folds(in_bits(64).with_doubles(Some(in_doubles()))), folds(in_bits(64)));
    assert_eq!(trends(&helped), trends(&alone));
    assert!(helped.folds.len() > 3, "{}", helped.folds.len());
    for (one, other) in helped.folds.iter().zip(&alone.folds) {
        assert!(
            one.contact_radius.overlaps(&other.contact_radius) && one.force.overlaps(&other.force),
            "{one:?} {other:?}"
        );
        assert!(one.contact_radius.accuracy_bits() > 40);
    }
}

/// A place that doubles find is that of the fold, to nearly all of their digits.
#[test]
fn places_of_folds_are_found_in_doubles() {
    let [lower, upper] = [1e-3, 1.29].map(|end| Float::with_val(100, end));
    let proved = in_bits(100).folds(&lower, &upper, 100_000).expect("no error");
    let mut found = 0;
    for fold in proved.folds.iter().filter(|fold| fold.contact_radius.accuracy_bits() < i64::MAX) {
        let a = &fold.contact_radius;
        let cell = a.clone().inflate(&(a.lit(2).powi(-20) * a));
        let Some(place) = in_doubles().approached(&cell).expect("no error") else { continue };
        assert!((place / a.approx() - 1.0).abs() < 1e-10, "{place} {a}");
        found += 1;
    }
    assert!(found > 1, "{found}");
}
