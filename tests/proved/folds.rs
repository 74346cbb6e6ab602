//! All folds, and none hidden.

use std::sync::Arc;

use mdr_analytic::PowerLaw;
use mdr_analytic::profiles::*;
use mdr_core::contact::{Error, FoldKind, Result, Transform};
use mdr_core::number::{Dual, Interval, Precision, Real};
use mdr_numeric::proof::ProvedFolds;
use rug::Float;

use crate::{Contact, Held, contact, near};

fn waves(bits: u32, wavelength: &'static str) -> Result<Contact> {
    Ok(contact!(bits, WavyParaboloid("1", "5e-4", wavelength), "1e-4", Held::Indentation))
}

#[test]
fn figure_4_of_the_paper() -> Result<()> {
    let proved = waves(64, "0.1")?.folds(1e-6, 1e3)?;
    assert!(proved.is_complete(), "{:?}", proved.undecided);
    // The jump 0.0645 → 0.0474 at d ≈ −0.00185, and the end at 0.0189, d ≈ −0.00249.
    let minima: Vec<_> = proved.folds.iter().filter(|fold| fold.kind == FoldKind::Minimum).collect();
    assert!(minima.iter().any(|fold| near(fold, 0.0645, -0.00185)), "{minima:?}");
    assert!(minima.iter().any(|fold| near(fold, 0.0189, -0.00249)), "{minima:?}");
    // Minima and maxima take turns along the curve.
    assert!(proved.folds.windows(2).all(|pair| pair[0].kind != pair[1].kind));

    // The same folds to 300 bits, inside the first enclosures.
    let fine = waves(300, "0.1")?;
    for fold in &proved.folds {
        let sharp = fine.ask(|curve| curve.refine(fold))?;
        assert!(sharp.contact_radius.accuracy_bits() > 280 && sharp.contact_radius.overlaps(&fold.contact_radius));
        assert!(sharp.indentation.accuracy_bits() > 270);
    }
    Ok(())
}

#[test]
fn hundreds_of_folds() -> Result<()> {
    let proved = waves(64, "1e-3")?.folds(1e-6, 0.1)?;
    // Two to a wave as soon as the slope of the waves beats 2x/R: about 200 up to a = 100 λ, and the end.
    assert!((195..=205).contains(&proved.folds.len()), "{}", proved.folds.len());
    assert!(proved.is_complete(), "{:?}", &proved.undecided[..3.min(proved.undecided.len())]);
    assert!(proved.folds.windows(2).all(|pair| pair[0].kind != pair[1].kind));
    Ok(())
}

/// Flat up to b: under every control it comes off at its edge, a = b, where g' jumps from 0 to ∞.
#[test]
fn an_edge_is_the_fold() -> Result<()> {
    for held in [Held::Indentation, Held::Force, Held::Machine("0.03")] {
        let cone = contact!(64, TruncatedCone("0.5", "0.01"), "1e-4", held);
        let paraboloid = contact!(64, TruncatedParaboloid("0.05", "0.01"), "1e-4", held);
        let punch = contact!(64, FlatPunch("0.01"), "1e-4", held);
        for contact in [cone, paraboloid, punch] {
            let proved = contact.folds(1e-6, 1e3)?;
            assert!(proved.is_complete() && proved.folds.len() == 1, "{proved:?}");
            let fold = &proved.folds[0];
            assert!(fold.contact_radius.contains(&Float::with_val(200, Float::parse("0.01").unwrap())));
            assert_eq!(fold.kind, FoldKind::Minimum);
            // F = −√(8πb³E*w) (Kendall 1971)
            let (b, w) = (&fold.contact_radius, crate::interval("1e-4"));
            assert!(fold.force.overlaps(&-(b.pi() * b.powi(3) * w).times(8).sqrt()), "{:?}", fold.force);
            assert!(fold.force.accuracy_bits() > 50);
            assert!(!proved.folds[0].indentation.contains_zero());
        }
    }
    Ok(())
}

/// In an elastic truncated cone that hardly resists, the curve goes on: the edge is a minimum, then comes a maximum so
/// close to the edge that g' still falls from ∞, then the minimum of the cone.
#[test]
fn folds_close_to_an_edge() -> Result<()> {
    let contact = contact!(128, TruncatedCone("1e-3", "0.01"), "1e-4", Held::Indentation);
    let proved = contact.folds(1e-6, 1e6)?;
    assert!(proved.is_complete(), "{:?}", proved.undecided);
    use FoldKind::{Maximum, Minimum};
    assert_eq!(proved.folds.iter().map(|fold| fold.kind).collect::<Vec<_>>(), [Minimum, Maximum, Minimum]);
    let distance = proved.folds[1].contact_radius.clone() / &proved.folds[0].contact_radius - crate::interval("1");
    assert!(distance.approx() > 0.0 && distance.approx() < 1e-3, "{distance:?}");
    Ok(())
}

#[test]
fn every_kink_of_the_library_is_decided() -> Result<()> {
    let complete = |contact: Contact| -> Result<ProvedFolds> {
        let proved = contact.folds(1e-7, 1e4)?;
        assert!(proved.is_complete(), "{:?}", proved.undecided);
        Ok(proved)
    };
    for held in [Held::Indentation, Held::Force, Held::Machine("0.1")] {
        // Continuous g': the kink is passed.
        assert_eq!(complete(contact!(64, RoundedPunch("1", "0.03"), "1e-4", held))?.folds.len(), 1);
        assert_eq!(complete(contact!(64, ParabolicCapCone("0.3", "0.03"), "1e-4", held))?.folds.len(), 1);
        assert_eq!(complete(contact!(64, SphericalCapCone("0.3", "1"), "1e-4", held))?.folds.len(), 1);
        // Dimples: g' jumps to ∞, or g itself is −∞ at the edge.
        let dimple = complete(contact!(64, ParabolicDimple("1e-3", "0.03"), "1e-4", held))?;
        assert!(dimple.folds[0].contact_radius.approx() == 0.03 && dimple.folds.len() == 2, "{dimple:?}");
        let dimple = complete(contact!(64, EllipticalDimple("1e-3", "0.03"), "1e-4", held))?;
        assert!(dimple.poles.len() == 1 && dimple.folds.len() == 1, "{dimple:?}");
    }
    Ok(())
}

/// An edge within a sum whose other term is smooth there.
#[test]
fn the_edge_of_a_sum() -> Result<()> {
    fn sum<R: mdr_core::number::Special>(ctx: R::Ctx) -> Result<Sum<R>> {
        let punch = TruncatedCone::new(crate::number(ctx, "0.5"), crate::number(ctx, "0.01"))?;
        Ok(Sum::new(vec![Box::new(Paraboloid::new(crate::number(ctx, "1"))?), Box::new(punch)]))
    }
    let ctx = Precision::new(64);
    let (plain, moving) = (Arc::new(sum(ctx)?), Arc::new(sum(ctx)?));
    let contact = Contact { bits: 64, plain, moving, work: "1e-4", held: Held::Indentation };
    let proved = contact.folds(1e-6, 1e3)?;
    assert!(proved.is_complete() && proved.folds.len() == 1 && proved.folds[0].contact_radius.approx() == 0.01);
    Ok(())
}

/// Two truncated cones: edges that are apart by more than 2⁻³⁸, or equal and exact in binary, are decided; others are named.
#[test]
fn edges_beside_each_other() -> Result<()> {
    fn sum<R: mdr_core::number::Special>(ctx: R::Ctx, first: &str, second: &str) -> Result<Sum<R>> {
        let cone =
            |slope: &str, flat: &str| TruncatedCone::new(crate::number::<R>(ctx, slope), crate::number(ctx, flat));
        Ok(Sum::new(vec![Box::new(cone("0.2", first)?), Box::new(cone("0.1", second)?)]))
    }
    let ctx = Precision::new(64);
    for held in [Held::Indentation, Held::Force, Held::Machine("0.1")] {
        for (one, second, decided) in [
            ("0.0625", "0.0625", true),
            ("0.05", "0.05", false),
            ("0.05", "0.0500000000005", true),
            ("0.05", "0.049999999", true),
            ("0.05", "0.05000000000001", false),
            ("0.05", "0.0499999999999999", false),
        ] {
            let (plain, moving) = (Arc::new(sum(ctx, one, second)?), Arc::new(sum(ctx, one, second)?));
            let proved = Contact { bits: 64, plain, moving, work: "1e-4", held }.folds(1e-4, 1e2)?;
            assert_eq!(proved.is_complete(), decided, "{second}: {proved:?}");
            let first = second.parse::<f64>().unwrap().min(one.parse().unwrap());
            if decided {
                assert!(proved.folds.len() == 1, "{second}: {proved:?}");
                assert!((proved.folds[0].contact_radius.approx() - first).abs() < 1e-17, "{second}: {proved:?}");
            } else {
                let holds = |(lower, upper): &(Float, Float)| *lower <= first && *upper >= first;
                assert!(proved.undecided.iter().any(holds), "{second}: {proved:?}");
            }
        }
    }
    Ok(())
}

/// A range that ends at a kink, where g' has no value, includes it.
#[test]
fn a_range_that_ends_at_a_kink() -> Result<()> {
    for held in [Held::Indentation, Held::Force, Held::Machine("0.1")] {
        for (lower, upper, count) in [(1e-3, 0.01, 1), (0.01, 1.0, 1), (0.01, 0.02, 1), (0.011, 1.0, 0)] {
            let cone = contact!(64, TruncatedCone("0.5", "0.01"), "1e-4", held);
            let proved = cone.folds(lower, upper)?;
            assert!(proved.is_complete() && proved.folds.len() == count, "{lower} {upper}: {proved:?}");
        }
        let dimple = contact!(64, EllipticalDimple("1e-3", "0.03"), "1e-4", held);
        assert!(dimple.folds(1e-3, 0.03)?.is_complete() && dimple.folds(0.03, 1.0)?.is_complete());
    }
    Ok(())
}

/// Without its own word on a kink, a profile has no proof there.
#[test]
fn a_kink_is_not_passed_over_in_silence() -> Result<()> {
    struct Silent<T>(T);
    impl<R: Real, T: mdr_core::contact::Transform<R>> mdr_core::contact::Transform<R> for Silent<T> {
        fn g(&self, x: &R) -> Result<R> {
            self.0.g(x)
        }
        fn slope(&self, x: &R) -> Result<R> {
            self.0.slope(x)
        }
        fn integral(&self, x: &R) -> Result<R> {
            self.0.integral(x)
        }
        fn kinks(&self) -> Vec<R> {
            self.0.kinks()
        }
    }
    let ctx = Precision::new(64);
    let cone = TruncatedCone::new(crate::number::<Interval>(ctx, "0.5"), crate::number(ctx, "0.01"))?;
    let moving = TruncatedCone::new(crate::number::<Dual<Interval>>(ctx, "0.5"), crate::number(ctx, "0.01"))?;
    let (plain, moving) = (Arc::new(Silent(cone)), Arc::new(Silent(moving)));
    let contact = Contact { bits: 64, plain, moving, work: "1e-4", held: Held::Indentation };
    let proved = contact.folds(1e-6, 1e3)?;
    let gap = |(lower, upper): &(Float, Float)| *lower < 0.01 && *upper > 0.01;
    assert!(!proved.is_complete() && proved.undecided.iter().all(gap), "{:?}", proved.undecided);
    let refused = contact.branches(&proved, |_| Ok(()));
    assert!(matches!(refused, Err(Error::Unproved { .. })), "{refused:?}");
    Ok(())
}

/// A sum ends where its first term does. A kink of another term beyond that end, or at it, is none of the sum; what is
/// flat up to there adds nothing. The radii are the zeros of g' − Δl', found in another program.
#[test]
fn kinks_beyond_the_end_of_a_sum() -> Result<()> {
    fn terms<R: mdr_analytic::struve::Struve>(ctx: R::Ctx, case: usize) -> Result<Sum<R>> {
        let number = |text: &str| crate::number::<R>(ctx, text);
        let ball = || -> Result<Box<dyn Transform<R>>> { Ok(Box::new(Sphere::new(number("1"))?)) };
        let first = if case == 4 { Box::new(Ellipsoid::new(number("1"), number("0.5"))?) } else { ball()? };
        let second: Box<dyn Transform<R>> = match case {
            0 => Box::new(TruncatedCone::new(number("0.1"), number("2"))?),
            1 | 4 => Box::new(RoundedPunch::new(number("3"), number("1.5"))?),
            2 => Box::new(TruncatedParaboloid::new(number("3"), number("1"))?),
            _ => Box::new(EllipticalDimple::new(number("0.01"), number("2"))?),
        };
        Ok(Sum::new(vec![first, second]))
    }
    let ball = ("0.07305556974304634604542152766292115033387", "-0.01607814957501439331874559562456209960173");
    let dimpled = ("0.07317667560944287090337260166298568057983", "-0.01609152044016941290948385134845003832416");
    let ellipsoid = ("0.1155517071642064907204393851584350767026", "-0.02023894323412937005836218408484247109995");
    let ctx = Precision::new(64);
    for (case, (radius, indentation)) in [ball, ball, ball, dimpled, ellipsoid].into_iter().enumerate() {
        let (plain, moving) = (Arc::new(terms(ctx, case)?), Arc::new(terms(ctx, case)?));
        let contact = Contact { bits: 64, plain, moving, work: "1e-3", held: Held::Indentation };
        let proved = contact.folds(1e-4, 1e3)?;
        let [fold] = &proved.folds[..] else { panic!("{case}: {proved:?}") };
        assert!(proved.is_complete() && proved.poles.is_empty(), "{case}: {proved:?}");
        for (found, expected) in [(&fold.contact_radius, radius), (&fold.indentation, indentation)] {
            assert!(found.overlaps(&crate::number(ctx, expected)) && found.accuracy_bits() > 50, "{case}: {found:?}");
        }
    }
    Ok(())
}

#[test]
fn one_fold_of_a_ball() -> Result<()> {
    let proved = contact!(200, Paraboloid("1"), "1", Held::Indentation).folds(1e-12, 1e12)?;
    // a³ = πwR²/8E* (Johnson, Kendall and Roberts 1971, fixed grips)
    let cube = proved.folds[0].contact_radius.powi(3);
    assert!(proved.is_complete() && proved.folds.len() == 1 && cube.overlaps(&cube.pi().over(8)));
    Ok(())
}

/// The compliant machine with three folds: n = 0.6, C = 2.4829, E* = w = k = 1, against their own closed form.
#[test]
fn three_folds_of_a_machine() -> Result<()> {
    let contact = contact!(64, PowerLaw("0.6", "2.4829"), "1", Held::Machine("1"));
    let proved = contact.folds(1e-9, 1e9)?;
    assert!(proved.is_complete() && proved.folds.len() == 3, "{proved:?}");
    let one = Interval::from_int(Precision::new(64), 1);
    let profile = PowerLaw::new(crate::number(Precision::new(64), "0.6"), crate::number(Precision::new(64), "2.4829"))?;
    let material = mdr_core::contact::Material::new(one.clone(), one.clone())?;
    let closed = mdr_analytic::PowerLawContact::new(profile, material).machine_folds(&one)?;
    for (fold, closed) in proved.folds.iter().zip(&closed) {
        assert!(fold.contact_radius.overlaps(&closed.contact_radius) && fold.kind == closed.kind);
        assert!(fold.indentation.overlaps(&closed.indentation) && fold.force.overlaps(&closed.force));
    }
    Ok(())
}

/// Where there is no profile there is nothing to prove.
#[test]
fn a_range_beyond_the_profile_is_refused() -> Result<()> {
    let sphere = contact!(64, Sphere("1"), "1e-4", Held::Indentation);
    for lower in [1.0 - 2f64.powi(-45), 1.0, 2.0] {
        assert!(matches!(sphere.folds(lower, 3.0), Err(Error::Domain { .. })), "{lower}");
    }
    let within = sphere.folds(0.5, 3.0)?;
    assert!(within.is_complete() && within.range.1 > 0.5 && within.range.1 < 1, "{within:?}");
    let punch = contact!(64, FlatPunch("0.01"), "1e-4", Held::Indentation);
    assert!(matches!(punch.folds(0.01, 1.0), Err(Error::Domain { .. })));
    Ok(())
}
