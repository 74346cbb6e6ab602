//! The remainder counts: where the image of each ellipse is taken for a point, and with it the remainder for nothing, the enclosure
//! fails.

use std::sync::Arc;

use mdr_core::contact::{Control, Expression, Material};
use mdr_core::number::Precision;

use super::*;
use crate::proof::EnclosedEnergy;
use crate::transform::Enclosed;

/// A function whose integrals have no remainders.
pub(in crate::proof) struct Dropped<F>(pub(in crate::proof) F);

impl<F: Sampled> Sampled for Dropped<F> {
    fn values(&self, t: &Interval) -> Result<Option<Vec<Interval>>> {
        self.0.values(t)
    }

    fn image<I: Ends>(&self, t: &Rectangle<I>) -> Option<Vec<Rectangle<I>>> {
        let point = |image: Rectangle<I>| Rectangle::new(image.re().midpoint(), image.im().lit(0));
        Some(self.0.image(t)?.into_iter().map(point).collect())
    }

    fn is_moderate(&self) -> bool {
        self.0.is_moderate()
    }

    fn is_dear(&self) -> bool {
        self.0.is_dear()
    }

    fn range(&self, t: &Interval) -> Option<Vec<Interval>> {
        self.0.range(t)
    }
}

/// ∫₀ᵃ g² at a = 0.3 over some waves, whole and without remainders.
fn integrals(bits: u32) -> [Interval; 2] {
    let formula: Expression = "r^2/2 + 5e-4*(1 - cos(20*pi*r))".parse().expect("a formula");
    let (none, precision) = (Default::default(), Precision::new(bits));
    let breaks = formula.breaks(&none).expect("no kinks");
    let bound = || formula.enclosed(&none, &breaks, precision).expect("no names");
    let transform = Enclosed::new(bound(), precision);
    let profile = Continuation::new(vec![bound()]).expect("no kinks");
    let one = Interval::from_int(precision, 1);
    let radius = one.ratio(3, 10);
    let square = || Square {
        transform: &transform,
        stretch: Stretch { profile: &profile, beyond: 0, base: None, from: one.lit(0), length: radius.clone() },
    };
    let material = Material::new(one.clone(), one.clone()).expect("positive");
    let contact = Contact::half_space(&Arc::new(transform.clone()), &material, &Control::Indentation);
    let whole = EnclosedEnergy::new(&contact, &profile).expect("a half-space").squares(std::slice::from_ref(&radius));
    let whole = whole.expect("an integral").swap_remove(0);
    [whole, over_unit_interval(&Dropped(square()), bits).expect("an integral")]
}

#[test]
fn a_dropped_remainder_is_caught_at_few_bits() {
    let [truth, _] = integrals(200);
    for bits in [16, 20, 24] {
        let [whole, dropped] = integrals(bits);
        assert!(whole.overlaps(&truth), "{bits} bits: {whole} without {truth}");
        assert!(!dropped.overlaps(&truth), "{bits} bits: {dropped} holds {truth}");
    }
}

/// ∫₀ᵃ g² over the stretches beside a kink: each aims at its share of the error of the whole.
#[test]
fn stretches_between_kinks_share_the_error() {
    let formula: Expression = "r^4/4 + abs(r - 1/10)".parse().expect("a formula");
    let none = Default::default();
    let breaks = formula.breaks(&none).expect("a kink");
    let squares = |bits: u32| {
        let precision = Precision::new(bits);
        let bound = || formula.enclosed(&none, &breaks, precision).expect("no names");
        let transform = Arc::new(Enclosed::new(bound(), precision));
        let profile = Continuation::new(vec![bound()]).expect("a continuation");
        let one = Interval::from_int(precision, 1);
        let material = Material::new(one.clone(), one.clone()).expect("positive");
        let contact = Contact::half_space(&transform, &material, &Control::Indentation);
        let radii = [one.ratio(2, 10), one.ratio(9, 10)];
        EnclosedEnergy::new(&contact, &profile).expect("a half-space").squares(&radii).expect("integrals")
    };
    let truth = squares(90);
    for bits in [24, 40, 60] {
        for (found, truth) in squares(bits).iter().zip(&truth) {
            assert!(found.overlaps(truth), "{bits} bits: {found} without {truth}");
            assert!(found.accuracy_bits() + 14 > i64::from(bits), "{bits} bits: {found}");
        }
    }
}

/// ∫₀ᵃ g² of r^(1/4) + r^(5/4) at a = 0.9, whole and without remainders.
#[test]
fn a_dropped_remainder_is_caught_beside_a_fractional_power() {
    let formula: Expression = "r^(1/4)*(1 + r)".parse().expect("a formula");
    let (none, one) = (Default::default(), |bits| Interval::from_int(Precision::new(bits), 1));
    let breaks = formula.breaks(&none).expect("no kinks");
    let integrals = |bits: u32| {
        let bound = || formula.enclosed(&none, &breaks, Precision::new(bits)).expect("no names");
        let (transform, radius) = (Enclosed::new(bound(), Precision::new(bits)), one(bits).ratio(9, 10));
        let profile = Continuation::new(vec![bound()]).expect("no kinks");
        let square = || RootedSquare { transform: &transform, profile: &profile, to: &radius, k: 4 };
        assert_eq!(profile.root(), Some(4));
        [over_unit_interval(&square(), bits), over_unit_interval(&Dropped(square()), bits)]
            .map(|all| all.expect("an integral"))
    };
    // g = κ(1/4) x^(1/4) + κ(5/4) x^(5/4), by mpmath.
    let truth = Interval::from_literal(Precision::new(200), &TRUTH.parse().expect("a number"));
    for bits in [12, 16, 20, 24, 100] {
        let [whole, dropped] = integrals(bits);
        assert!(whole.overlaps(&truth), "{bits} bits: {whole} without {truth}");
        assert!(bits < 16 || !dropped.overlaps(&truth), "{bits} bits: {dropped} holds {truth}");
    }
}

/// Of the test above, to 50 digits.
const TRUTH: &str = "2.5403834089832357898129675070575829092564396630349";
