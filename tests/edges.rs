//! Contacts whose edge meets an edge of the profile, in f64: g' has an inverse root there, or g is −∞.

use std::sync::Arc;

use mdr_analytic::profiles::{EllipticalDimple, ParabolicDimple, Paraboloid, Sum, TruncatedCone, TruncatedParaboloid};
use mdr_core::contact::{Control, Error, Material, Result, Stability, Transform};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::energy::Energy;
use mdr_numeric::equilibrium::{SearchedBranches, equilibria};
use mdr_numeric::folds::{SearchQuality, find};
use mdr_numeric::path::{Dissipation, EventKind, Path, PathEnergy, Start};

/// The radius b of the edge, and w/E*.
const EDGE: f64 = 0.1;
const LENGTH: f64 = 1e-4;

fn glue() -> Result<Material<f64>> {
    Material::new(1.0, LENGTH)
}

/// A paraboloid of radius 1 with an elliptical dimple of this depth.
fn dimple(depth: f64) -> Result<Sum<f64>> {
    Ok(Sum::new(vec![Box::new(Paraboloid::new(1.0)?), Box::new(EllipticalDimple::new(depth, EDGE)?)]))
}

/// The radii in (10⁻⁷, 1) where the contact changes its direction at a held value, and whether it grows below: a scan in
/// steps of 10⁻⁴ of the radius, finer towards the edge, by formulas of its own.
fn scanned(depth: f64, control: &Control<f64>, value: f64) -> Vec<(f64, bool)> {
    let moment = |a: f64| {
        let t = (a / EDGE).min(EDGE / a);
        // ∫₀ᵃ x artanh(x/b) dx, and the same with artanh(b/x) beyond b.
        let inner = 0.5 * ((a * a - EDGE * EDGE) * t.atanh() + a * EDGE);
        a.powi(3) / 3.0 - depth / EDGE * inner
    };
    let shrinks = |a: f64| {
        let t = (a / EDGE).min(EDGE / a);
        let g = a * a - depth * a / EDGE * t.atanh();
        let d = if *control == Control::Force { (0.5 * value + moment(a)) / a } else { value };
        g - d > (2.0 * std::f64::consts::PI * a * LENGTH).sqrt()
    };
    let far = (0..160_000).map(|i| 1e-7 * (1e-4 * f64::from(i)).exp());
    let near = (0..3000).map(|i| EDGE * (-0.01 * f64::from(i)).exp());
    let mut radii: Vec<f64> = far.chain(near.flat_map(|step| [EDGE - step, EDGE + step])).collect();
    radii.retain(|a| *a > 1e-7 && *a < 1.0 && (a - EDGE).abs() > 1e-14);
    radii.sort_by(f64::total_cmp);
    let turns = radii.windows(2).filter(|pair| shrinks(pair[0]) != shrinks(pair[1]));
    turns.map(|pair| (pair[0], !shrinks(pair[0]))).collect()
}

/// All states on both sides of the pole of g, close to it or not.
#[test]
fn a_pole_ends_branches() -> Result<()> {
    let glue = glue()?;
    let indented = [(0.001, -0.001), (0.003, 0.0), (0.003, -0.003), (0.003, -0.01), (0.001, -0.012), (0.01, 1e-3)];
    let loaded = [(0.003, -0.001), (0.001, 0.0), (0.001, -0.0005), (0.003, -0.003)];
    let questions = indented.map(|question| (Control::Indentation, question)).into_iter();
    for (control, (depth, value)) in questions.chain(loaded.map(|question| (Control::Force, question))) {
        let found = equilibria(&Arc::new(dimple(depth)?), &glue, &control, &value)?;
        let expected = scanned(depth, &control, value);
        assert_eq!(found.len(), expected.len(), "{control:?} {depth} {value}: {found:?} {expected:?}");
        assert_eq!(found.completeness, SearchQuality::Resolved);
        for (found, (radius, grows)) in found.iter().zip(expected) {
            assert!((found.contact_radius / radius - 1.0).abs() < 1.1e-4, "{found:?} {radius}");
            assert_eq!(found.stability == Stability::Stable, grows, "{found:?}");
        }
    }
    Ok(())
}

#[test]
fn the_pole_is_told_apart_from_folds() -> Result<()> {
    let (dimple, glue) = (Arc::new(dimple(0.003)?), glue()?);
    let curve = Contact::half_space(&dimple, &glue, &Control::Indentation);
    let found = find(&curve)?;
    assert_eq!((found.folds.len(), found.completeness), (2, SearchQuality::Resolved));
    let [pole] = found.poles.as_slice() else { panic!("{:?}", found.poles) };
    assert_eq!((pole.contact_radius, pole.indentation), (EDGE, f64::NEG_INFINITY));
    // Closer to the edge than f64 can tell.
    let beside = SearchedBranches::cut_at(curve, found).equilibria(&-0.5);
    assert!(matches!(beside, Err(Error::Undecided { .. })), "{beside:?}");
    Ok(())
}

/// Pressed out of the dimple and pulled back, the contact stays outside the edge.
#[test]
fn a_path_starts_beside_a_pole() -> Result<()> {
    let (dimple, glue) = (Arc::new(dimple(0.003)?), glue()?);
    let branches = SearchedBranches::new(Contact::half_space(&dimple, &glue, &Control::Indentation))?;
    let path = Path::follow(&branches, &Start::Largest, &[0.0, -0.01, 0.0])?;
    let kinds: Vec<EventKind> = path.events.iter().map(|event| event.kind).collect();
    assert_eq!(kinds, [EventKind::Start, EventKind::WayPoint, EventKind::End]);
    let radius = path.events[0].after.contact().expect("in contact").contact_radius;
    assert!((radius - 0.114496).abs() < 1e-6, "{radius}");
    let balance = PathEnergy::new(&path, &branches)?.balance(&path, &branches)?.expect("nothing unbounded");
    assert!(balance.residual.abs() <= balance.bound, "{balance:?}");

    // From inside it would have to grow over the edge, where g is −∞ and the contact is pressed back: the path ends.
    let path = Path::follow(&branches, &Start::Nearest(0.05), &[-0.0035, 0.0])?;
    let last = path.events.last().expect("it starts");
    assert_eq!((path.events.len(), last.kind), (2, EventKind::NotAdmissible));
    let ring = last.ring.as_ref().expect("the radius of the edge");
    assert!((ring.radius - EDGE).abs() < 1e-9, "{ring:?}");
    Ok(())
}

/// A truncated tip breaks off its edge as the flat punch does, which loses πb²w.
#[test]
fn the_energy_of_a_truncated_tip_is_balanced() -> Result<()> {
    let glue = glue()?;
    let (cone, paraboloid) = (TruncatedCone::new(0.2, EDGE)?, TruncatedParaboloid::new(1.0, EDGE)?);
    for tip in [Arc::new(cone) as Arc<dyn Transform<f64>>, Arc::new(paraboloid)] {
        let branches = SearchedBranches::new(Contact::half_space(&tip, &glue, &Control::Indentation))?;
        assert_eq!(branches.completeness(), SearchQuality::Resolved);
        let path = Path::follow(&branches, &Start::Largest, &[0.0, -0.5])?;
        assert_eq!(path.events[1].kind, EventKind::Detached);
        let energies = PathEnergy::new(&path, &branches)?;
        let Dissipation::Finite(dissipated) = &energies.entries[1].dissipated else { panic!("finite at fixed grips") };
        let expected = std::f64::consts::PI * EDGE * EDGE * LENGTH;
        assert!(
            (dissipated.value - expected).abs() <= dissipated.error.max(8.0 * f64::EPSILON * expected),
            "{dissipated:?}"
        );
        let balance = energies.balance(&path, &branches)?.expect("nothing unbounded");
        // The bound is that of roundings, not of a quadrature that stops at the edge.
        assert!(balance.bound < 1e-10 * balance.work, "{balance:?}");
        assert!(balance.residual.abs() <= balance.bound, "{balance:?}");
    }
    Ok(())
}

/// Energy and force find the same states of contacts with an edge.
#[test]
fn the_energy_is_stationary_at_the_same_states() -> Result<()> {
    let glue = glue()?;
    let cone = TruncatedCone::new(0.2, EDGE)?;
    let paraboloid = TruncatedParaboloid::new(1.0, EDGE)?;
    let ridge: Sum<f64> = Sum::new(vec![Box::new(Paraboloid::new(1.0)?), Box::new(ParabolicDimple::new(0.003, EDGE)?)]);
    let (shallow, deep) = (dimple(0.001)?, dimple(0.003)?);
    type Tip = Arc<dyn Transform<f64>>;
    let tips: [(Tip, &[f64]); 5] = [
        (Arc::new(cone), &[0.01, -0.0079]),
        (Arc::new(paraboloid), &[0.0]),
        (Arc::new(ridge), &[-0.005]),
        (Arc::new(shallow), &[0.0, -0.001]),
        (Arc::new(deep), &[-0.003]),
    ];
    for (tip, values) in &tips {
        for value in *values {
            for (control, value) in [(Control::Indentation, *value), (Control::Force, 0.1 * value)] {
                let curve = Contact::half_space(tip, &glue, &control);
                let by_energy = Energy::new(curve.clone())?.equilibria(&control, &value)?;
                let by_force = equilibria(tip, &glue, &control, &value)?;
                assert_eq!(by_energy.len(), by_force.len(), "{control:?} {value}: {by_energy:?} {by_force:?}");
                for (one, other) in by_energy.iter().zip(by_force.iter()) {
                    let a = other.contact_radius;
                    // 128 roundings of g, Δl and d over the slope of the direction of change, by a difference.
                    let shift = 1e-4 * (a - EDGE).abs().min(a);
                    let slope = (curve.direction(&(a + shift), &value)? - curve.direction(&(a - shift), &value)?)
                        / (2.0 * shift);
                    let size = tip.g(&a)?.abs() + curve.detachment_elongation(&a)? + other.indentation.abs();
                    let allowed = 128.0 * f64::EPSILON * (size / slope.abs() + a);
                    assert!(
                        (one.contact_radius - a).abs() <= allowed,
                        "{control:?} {value}: {one:?} {other:?} {allowed}"
                    );
                    assert_eq!(one.stability, other.stability);
                }
            }
        }
    }
    Ok(())
}
