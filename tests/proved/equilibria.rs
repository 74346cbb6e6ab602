//! All equilibria at a value, and none invented.

use mdr_analytic::profiles::*;
use mdr_core::contact::{Error, Result, Stability};
use mdr_core::number::{Dual, Interval, Precision, Real};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::path::{EventKind, Path, Start};
use mdr_numeric::proof::ProvedFolds;
use rug::Float;

use crate::{Contact, Held, contact, interval};

const WAVES: (&str, &str, &str) = ("1", "5e-4", "0.1");

fn waves(bits: u32, held: Held) -> Result<Contact> {
    Ok(contact!(bits, WavyParaboloid(WAVES.0, WAVES.1, WAVES.2), "1e-4", held))
}

/// Proves the folds at 64 bits and asks for equilibria at 200.
fn equilibria(contact: impl Fn(u32) -> Result<Contact>, value: &str) -> Result<Vec<(f64, bool)>> {
    let proved = contact(64)?.folds(1e-6, 1e3)?;
    contact(200)?.branches(&proved, |branches| {
        let found = branches.equilibria(&crate::number(Precision::new(200), value))?;
        for rest in &found {
            assert!(rest.contact_radius.accuracy_bits() > 150, "{rest:?}");
        }
        Ok(found.iter().map(|rest| (rest.contact_radius.approx(), rest.stability == Stability::Stable)).collect())
    })
}

#[test]
fn the_ball_of_johnson_kendall_and_roberts() -> Result<()> {
    for bits in [64, 100, 500] {
        let contact = contact!(bits, Paraboloid("1"), "1", Held::Force);
        let proved = contact!(64, Paraboloid("1"), "1", Held::Force).folds(1e-6, 1e3)?;
        contact.branches(&proved, |branches| {
            let ctx = Precision::new(bits);
            // No load: a³ = 9πwR²/2E*. The other branch comes from a = 0, d = 0 and ends at the pull-off force.
            let free = branches.equilibria(&Interval::from_int(ctx, 0))?;
            assert!(free.len() == 1 && free[0].stability == Stability::Stable, "{free:?}");
            let cube = free[0].contact_radius.powi(3);
            assert!(cube.overlaps(&cube.pi().times(9).over(2)) && cube.accuracy_bits() > i64::from(bits) - 12);
            assert!(free[0].force == Interval::from_int(ctx, 0));
            // Pulled with half the pull-off force 3πwR/2: two, with 2 a³ = 9πwR²/2E* (1 ± …).
            let half = -Interval::from_int(ctx, 0).pi().times(3).over(4);
            let pulled = branches.equilibria(&half)?;
            assert!(pulled.len() == 2 && pulled[0].stability == Stability::Unstable, "{pulled:?}");
            // Beyond it: none.
            assert!(branches.equilibria(&half.times(3))?.is_empty());
            Ok(())
        })?;
    }
    Ok(())
}

/// Figure 4 of the paper: at d = 0 the contact rests at 0.0926; it jumps from 0.0645 to 0.0474. The value at which it
/// jumps is itself an enclosure.
#[test]
fn a_jump_lands_on_proved_ground() -> Result<()> {
    let at_zero = equilibria(|bits| waves(bits, Held::Indentation), "0")?;
    assert!(at_zero.iter().any(|(a, stable)| *stable && (a - 0.0926).abs() < 1e-4), "{at_zero:?}");
    assert!(at_zero.windows(2).all(|pair| pair[0].1 != pair[1].1));

    let proved = waves(64, Held::Indentation)?.folds(1e-6, 1e3)?;
    waves(300, Held::Indentation)?.branches(&proved, |branches| {
        let start = branches.folds().iter().position(|fold| (fold.contact_radius.approx() - 0.0645).abs() < 1e-4);
        let (_, landing) = branches.after_jump(start.expect("the fold"))?.expect("a landing point");
        assert!((landing.contact_radius.approx() - 0.0474).abs() < 1e-4, "{landing:?}");
        assert!(landing.contact_radius.accuracy_bits() > 270 && landing.stability == Stability::Stable);
        // On the branches that meet at the fold, nothing can be said of its own value.
        let fold = &branches.folds()[start.expect("the fold")];
        let at_fold = branches.on_branch(start.expect("the fold"), &fold.indentation);
        assert!(matches!(at_fold, Err(Error::Undecided { .. })), "{at_fold:?}");
        Ok(())
    })
}

/// Every sign of an equilibrium can be checked by a point on either side of its enclosure, at higher precision.
#[test]
fn each_enclosure_holds_a_change_of_direction() -> Result<()> {
    for held in [Held::Indentation, Held::Force, Held::Machine("1e-3")] {
        let proved = waves(64, held)?.folds(1e-6, 1e3)?;
        for value in ["0", "-1e-5", "1e-4", "0.3", "-1e-3"] {
            let value = interval(value);
            let found = waves(100, held)?.branches(&proved, |branches| branches.equilibria(&value))?;
            let fine = waves(400, held)?;
            for rest in &found {
                let changes = fine.ask(|curve| {
                    let end = |end: &Float| Interval::point(Float::with_val(400, end));
                    let wide = rest
                        .contact_radius
                        .clone()
                        .inflate(&(rest.contact_radius.unit_roundoff() * &rest.contact_radius));
                    let [below, above] = [wide.lower(), wide.upper()].map(|x| curve.plain().direction(&end(x), &value));
                    let (below, above, zero) = (below?, above?, value.lit(0));
                    Ok(if rest.stability == Stability::Stable {
                        below < zero && above > zero
                    } else {
                        below > zero && above < zero
                    })
                })?;
                assert!(changes, "{rest:?}");
            }
        }
    }
    Ok(())
}

#[test]
fn a_punch_rests_at_its_wall() -> Result<()> {
    for held in [Held::Indentation, Held::Force, Held::Machine("1")] {
        let contact = |bits| -> Result<Contact> { Ok(contact!(bits, FlatPunch("0.01"), "1e-4", held)) };
        let found = equilibria(contact, "1e-6")?;
        assert_eq!(found.iter().filter(|(a, stable)| *stable && *a == 0.01).count(), 1, "{found:?}");
        assert!(equilibria(contact, "-1e3")?.is_empty());
    }
    Ok(())
}

/// Between an edge and the radius where a truncated cone would rest without it.
#[test]
fn equilibria_beside_an_edge() -> Result<()> {
    let contact =
        |bits| -> Result<Contact> { Ok(contact!(bits, TruncatedCone("0.5", "0.01"), "1e-4", Held::Indentation)) };
    // d(b) = −√(2πbw/E*) ≈ −0.002507; just above it there are an unstable one below b and a stable one above.
    let found = equilibria(contact, "-0.0025")?;
    assert!(found.len() == 2 && !found[0].1 && found[1].1, "{found:?}");
    assert!(found[0].0 < 0.01 && found[1].0 > 0.01 && found[1].0 < 0.0100001, "{found:?}");
    assert!(equilibria(contact, "-0.00251")?.is_empty());
    Ok(())
}

/// Both sides of a dimple whose g is −∞ at the edge: an equilibrium on either side at any value, however low.
#[test]
fn equilibria_beside_a_pole() -> Result<()> {
    let contact =
        |bits| -> Result<Contact> { Ok(contact!(bits, EllipticalDimple("1e-3", "0.03"), "1e-4", Held::Indentation)) };
    let proved = contact(64)?.folds(1e-6, 1e3)?;
    let found = contact(100)?.branches(&proved, |branches| branches.equilibria(&interval("-0.0066")))?;
    assert!(found.windows(2).all(|pair| pair[0].contact_radius < pair[1].contact_radius), "{found:?}");
    assert!(found.iter().any(|rest| rest.contact_radius < interval("0.03") && rest.stability == Stability::Unstable));
    assert!(found.iter().any(|rest| rest.contact_radius > interval("0.03") && rest.stability == Stability::Stable));
    let deep = contact(100)?.branches(&proved, |branches| branches.equilibria(&interval("-1")));
    assert!(matches!(deep, Err(Error::Undecided { .. })), "{deep:?}");
    Ok(())
}

/// One outside the stated range is found by walking outwards.
#[test]
fn beyond_the_range() -> Result<()> {
    let contact = contact!(64, Paraboloid("1"), "1", Held::Indentation);
    let proved = contact.folds(0.1, 10.0)?;
    contact.branches(&proved, |branches| {
        let found = branches.equilibria(&Interval::from_int(Precision::new(64), 1_000_000))?;
        assert!(found.len() == 1 && (found[0].contact_radius.approx() / 1e3 - 1.0).abs() < 1e-2, "{found:?}");
        assert!(found[0].contact_radius.lower() > &branches.range().1);
        let tiny = -Interval::from_int(Precision::new(64), 1).over(1_000_000);
        let found = branches.equilibria(&tiny)?;
        assert!(found.len() == 2 && found[0].contact_radius.upper() < &branches.range().0, "{found:?}");
        Ok(())
    })
}

/// Loading paths run over enclosures as they do over f64, and then each decision in them is proved.
#[test]
fn paths_are_proved() -> Result<()> {
    use EventKind::{Detached, End, Jump, JumpIn, Start as Begin, WayPoint};
    let proved = waves(64, Held::Indentation)?.folds(1e-6, 1e3)?;
    waves(200, Held::Indentation)?.branches(&proved, |branches| {
        let way = ["0", "-0.01", "0"].map(|value| crate::number::<Interval>(Precision::new(200), value));
        let path = Path::follow(&branches, &Start::Largest, &way)?;
        let kinds: Vec<EventKind> = path.events.iter().map(|event| event.kind).collect();
        assert_eq!(kinds, [Begin, Jump, Detached, WayPoint, JumpIn, End], "{path:?}");
        // 0.0645 → 0.0474 at d ≈ −0.00185, and the end at 0.0189, d ≈ −0.00249; each to 40 digits and more.
        for (event, from, value) in [(&path.events[1], 0.0645, -0.00185), (&path.events[2], 0.0189, -0.00249)] {
            let left = &event.before.contact().expect("in contact").contact_radius;
            assert!((left.approx() - from).abs() < 1e-4 && (event.value.approx() - value).abs() < 1e-5, "{event:?}");
            assert!(left.accuracy_bits() > 140 && event.value.accuracy_bits() > 140);
        }
        let landing = path.events[1].after.contact().expect("a landing point");
        assert!((landing.contact_radius.approx() - 0.0474).abs() < 1e-4);
        Ok(())
    })
}

/// Inside an elliptical dimple, between the tip and the edge where g is −∞: digits grow with the precision. The radii are
/// the zeros of −ha artanh(a/b)/b − Δl(a) − d, found by a secant to 50 digits in another program.
#[test]
fn digits_grow_beside_a_pole() -> Result<()> {
    let dimple = |bits| Ok(contact!(bits, EllipticalDimple("0.01", "1"), "1e-3", Held::Indentation));
    let proved = dimple(64)?.folds(1e-4, 1e3)?;
    assert!(proved.is_complete(), "{:?}", proved.undecided);
    for bits in [99, 150, 300] {
        for (value, radius) in [
            ("-0.02", "0.063405950180268132082486716199659067629121005851604"),
            ("-0.07", "0.66541748279651129054808165973051715343423469759183"),
            ("-0.09", "0.91435190045263399303993761184492075432871639862361"),
        ] {
            let found = dimple(bits)?
                .branches(&proved, |branches| branches.equilibria(&crate::number(Precision::new(bits), value)))?;
            let [rest] = &found[..] else { panic!("{value}: {found:?}") };
            let expected: Interval = crate::number(Precision::new(150), radius);
            assert!((rest.contact_radius.clone() - expected).abs() < interval("1e-24"), "{rest:?}");
            assert!(rest.contact_radius.accuracy_bits() > i64::from(bits) - 12, "{bits}, {value}: {rest:?}");
            assert_eq!(rest.stability, Stability::Unstable);
        }
    }
    Ok(())
}

/// A budget too small for the proof: the parts left over are named, and no equilibrium is claimed.
#[test]
fn an_unfinished_proof_is_refused() -> Result<()> {
    let contact = waves(64, Held::Indentation)?;
    let [lower, upper] = [1e-6, 1e3].map(|end| Float::with_val(64, end));
    let proved: ProvedFolds = contact.ask(|curve| curve.folds(&lower, &upper, 20))?;
    assert!(!proved.is_complete());
    let refused = contact.branches(&proved, |_| Ok(())).expect_err("not proved");
    assert!(refused.to_string().contains("budget"), "{refused}");
    Ok(())
}
