//! Profiles that end with a vertical edge: the contact edge can stay there.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::f64::consts::PI;
use std::sync::Arc;

use approx::assert_relative_eq;
use mdr_core::contact::{Control, FoldKind, Material, Outcome, Profile, Shape, Stability, Transform};
use mdr_core::number::{Lift, Real};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::{SearchedBranches, equilibria};
use mdr_numeric::fields::Fields;
use mdr_numeric::folds::folds;
use mdr_numeric::transform::Quadrature;

/// g and Δl, and F as a product of four such factors.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

fn controls() -> [Control<f64>; 3] {
    [Control::Indentation, Control::Force, Control::machine(3e5).unwrap()]
}

#[test]
fn the_flat_punch_of_kendall() {
    // K. Kendall, J. Phys. D 4 (1971) 1186: d = −√(2πbw/E*), F = −√(8πb³E*w), under every control.
    let (b, e, w) = (0.3, 2e6, 0.05);
    let (punch, material) =
        (Arc::new(Quadrature::of([Shape::FlatPunch { radius: b }]).unwrap()), Material::new(e, w).unwrap());
    for control in controls() {
        let found = folds(&punch, &material, &control).unwrap();
        assert_eq!(found.len(), 1);
        assert_eq!((found[0].contact_radius, found[0].kind), (b, FoldKind::Minimum));
        assert_relative_eq!(found[0].indentation, -f64::sqrt(2.0 * PI * b * w / e), max_relative = ROUNDING);
        assert_relative_eq!(found[0].force, -f64::sqrt(8.0 * PI * b.powi(3) * e * w), max_relative = ROUNDING);

        let branches = SearchedBranches::new(Contact::half_space(&punch, &material, &control)).unwrap();
        assert_eq!(branches.outcome(0).unwrap(), Outcome::Detached);
        let pull_off = control.controlled(&found[0].indentation, &found[0].force);
        assert!(branches.equilibria(&(1.001 * pull_off)).unwrap().is_empty());
        let at_fold = branches.equilibria(&pull_off).unwrap();
        assert_eq!(at_fold.iter().map(|state| state.stability).collect::<Vec<_>>(), [Stability::Neutral]);
        // Halfway down, an unstable contact on the flat face beside the stable one at the vertical edge: 2E*bd.
        let half = branches.equilibria(&(0.5 * pull_off)).unwrap();
        let [inside, rest] = half.as_slice() else { panic!("two equilibria") };
        assert_eq!((inside.stability, rest.stability), (Stability::Unstable, Stability::Stable));
        assert_relative_eq!(rest.force, 0.5 * found[0].force, max_relative = ROUNDING);
        assert_relative_eq!(rest.force, 2.0 * e * b * rest.indentation, max_relative = ROUNDING);
        assert!(inside.contact_radius < b && rest.contact_radius == b);
        // Pressed, it stays there.
        let pressed = branches.equilibria(&-pull_off).unwrap();
        assert_eq!(pressed.len(), 1);
        assert_relative_eq!(pressed[0].force, -found[0].force, max_relative = ROUNDING);
    }
}

/// A rod of radius `edge` with a paraboloid as its end.
struct Rod<R> {
    curvature: R,
    edge: R,
}

impl<R: Real> Profile<R> for Rod<R> {
    fn height<S: Lift<R>>(&self, r: &S) -> S {
        r.square() / S::lift(&self.curvature).times(2)
    }
    fn outer_radius(&self) -> Option<R> {
        Some(self.edge.clone())
    }
    fn vertical_edge(&self) -> bool {
        true
    }
    fn tip_exponent(&self) -> Option<R> {
        Some(self.edge.lit(2))
    }
}

#[test]
fn a_stable_contact_goes_on_along_the_wall() {
    let material = Material::new(1.0, 1e-3).unwrap();
    // Under fixed grips the paraboloid is stable from a_c = (πw/8E*)^(1/3) ≈ 0.0732 on.
    let a_c = f64::cbrt(PI * 1e-3 / 8.0);
    let control = Control::Indentation;
    for edge in [0.5, a_c * (1.0 + 1e-7), a_c * (1.0 - 1e-7), 0.05] {
        let rod = Arc::new(Quadrature::new(Rod { curvature: 1.0, edge }));
        let found = folds(&rod, &material, &control).unwrap();
        let on_wall = found.last().unwrap().contact_radius == edge;
        assert_eq!((found.len(), on_wall), (1, edge < a_c), "{edge}");
        let curve = Contact::half_space(&rod, &material, &control);
        let corner = curve.indentation(&edge).unwrap();
        let rest = |d: f64| equilibria(&rod, &material, &control, &d).unwrap().equilibria.pop().unwrap();
        let beyond = rest(corner + 0.01);
        assert_eq!((beyond.contact_radius, beyond.stability), (edge, Stability::Stable));
        let mean = edge * edge / 3.0;
        assert_relative_eq!(beyond.force, 2.0 * edge * (corner + 0.01 - mean), max_relative = 1e-13);
        if edge > 0.1 {
            // One side of the corner continues the other.
            let step = 1e-9 * corner.abs();
            let (below, above) = (rest(corner - step), rest(corner + step));
            assert!(below.contact_radius < edge && above.contact_radius == edge);
            assert_relative_eq!(below.contact_radius, edge, max_relative = 1e-8);
            assert_relative_eq!(below.force, above.force, max_relative = 1e-7);
        }
    }
}

#[test]
fn equilibria_are_found_up_to_the_equator() {
    let (ball, material) =
        (Arc::new(Quadrature::of([Shape::Sphere { radius: 1.0 }]).unwrap()), Material::new(1.0, 1e-3).unwrap());
    for a in [0.3, 0.55, 0.8, 0.99] {
        let control = Control::Indentation;
        let d = Contact::half_space(&ball, &material, &control).indentation(&a).unwrap();
        let found = equilibria(&ball, &material, &control, &d).unwrap();
        assert_relative_eq!(found.last().unwrap().contact_radius, a, max_relative = 1e-13);
    }
    assert!(ball.g(&1.0).is_err());
}

/// Pressed with F, a flat punch of radius b has p(r) = F/(2πb√(b² − r²)) (Boussinesq 1885), with or without adhesion, and
/// the stiffness 2E*b.
#[test]
fn the_pressure_under_a_flat_punch() {
    let (b, e, w) = (0.3, 2e6, 0.05);
    let (punch, material) =
        (Arc::new(Quadrature::of([Shape::FlatPunch { radius: b }]).unwrap()), Material::new(e, w).unwrap());
    let curve = Contact::half_space(&punch, &material, &Control::Force);
    for force in [500.0, -50.0] {
        let rest = equilibria(&punch, &material, &Control::Force, &force).unwrap().equilibria.pop().unwrap();
        let fields = Fields::of(curve.clone(), &rest).unwrap();
        for r in [0.0_f64, 0.1, 0.29] {
            let expected = force / (2.0 * PI * b * (b * b - r * r).sqrt());
            assert_relative_eq!(fields.pressure(&r).unwrap(), expected, max_relative = ROUNDING);
        }
        assert_relative_eq!(fields.stiffness().unwrap(), 2.0 * e * b, max_relative = ROUNDING);
    }
}
