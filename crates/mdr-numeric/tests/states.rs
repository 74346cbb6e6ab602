//! Inputs without a solution are errors, and no incomplete solution is returned silently.

use std::sync::Arc;

use mdr_core::contact::{Control, Error, Material, Quantity, Result, Shape};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::energy::Energy;
use mdr_numeric::equilibrium::{SearchedBranches, equilibria};
use mdr_numeric::folds::{SearchQuality, folds};
use mdr_numeric::path::{Path, Start};
use mdr_numeric::profiles::Heights;
use mdr_numeric::transform::Quadrature;

fn ball() -> Result<Quadrature<f64, Heights<f64>>> {
    Quadrature::of([Shape::Paraboloid { radius: 1.0 }])
}

fn refused<T>(result: Result<T>) -> Option<Quantity> {
    match result {
        Err(Error::Domain { quantity, .. }) => Some(quantity),
        _ => None,
    }
}

#[test]
fn no_state_is_found_at_a_value_that_is_no_number() -> Result<()> {
    let (ball, material) = (Arc::new(ball()?), Material::new(1.0, 1.0)?);
    let energy = Energy::new(Contact::half_space(&ball, &material, &Control::Indentation))?;
    for control in [Control::Indentation, Control::Force, Control::machine(1.0)?] {
        let branches = SearchedBranches::new(Contact::half_space(&ball, &material, &control))?;
        let quantity = Some(control.quantity());
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(refused(equilibria(&ball, &material, &control, &value)), quantity);
            assert_eq!(refused(branches.on_branch(0, &value)), quantity);
            assert_eq!(refused(energy.equilibria(&control, &value)), quantity);
            for start in [Start::Largest, Start::Smallest, Start::Nearest(1.0), Start::Detached] {
                assert_eq!(refused(Path::first(&branches, &start, &value)), quantity);
                assert_eq!(refused(Path::follow(&branches, &start, &[0.0, value])), quantity);
            }
        }
        assert!(matches!(branches.compare(&f64::NAN, &branches.folds()[0]), Err(Error::Undecided { .. })));
    }
    Ok(())
}

#[test]
fn impossible_machines_are_refused() -> Result<()> {
    let (ball, material) = (Arc::new(ball()?), Material::new(1.0, 1.0)?);
    let energy = Energy::new(Contact::half_space(&ball, &material, &Control::Indentation))?;
    for stiffness in [-1.0, 0.0, f64::NAN, f64::INFINITY] {
        let machine = Arc::new(Control::Machine { stiffness });
        assert_eq!(refused(folds(&ball, &material, &machine)), Some(Quantity::Stiffness));
        assert_eq!(refused(equilibria(&ball, &material, &machine, &0.0)), Some(Quantity::Stiffness));
        assert_eq!(refused(energy.equilibria(&machine, &0.0)), Some(Quantity::Stiffness));
    }
    Ok(())
}

#[test]
fn a_branch_that_does_not_exist_is_empty() -> Result<()> {
    let (ball, material) = (Arc::new(ball()?), Material::new(1.0, 1.0)?);
    let branches = SearchedBranches::new(Contact::half_space(&ball, &material, &Control::Indentation))?;
    assert!(branches.on_branch(1, &0.0)?.is_some());
    assert_eq!(branches.on_branch(2, &0.0)?, None);
    assert_eq!(branches.on_branch(99, &0.0)?, None);
    Ok(())
}

/// n = 0.48, κC = 5·10⁵, E* = w = 10⁻²⁰⁰: the fold is at 10²⁸⁰, where a dead load would leave the range.
#[test]
fn radii_near_the_largest_numbers_are_looked_at() -> Result<()> {
    let (blade, glue) = (Arc::new(Quadrature::of([Shape::Power { n: 0.48, c: 8e5 }])?), Material::new(1e-200, 1e-200)?);
    let found = folds(&blade, &glue, &Control::Indentation)?;
    assert!(found.len() == 1 && found[0].contact_radius > 1e280, "{found:?}");
    let states = equilibria(&blade, &glue, &Control::Indentation, &1e130)?;
    assert_eq!((states.len(), states.completeness), (2, SearchQuality::Resolved));
    Ok(())
}

/// On a ball at d < 0 there are two states; if |d| < √(2πaw/E*) for all numbers a, the one near the tip is not
/// representable.
#[test]
fn what_is_out_of_range_is_not_left_out_without_a_word() -> Result<()> {
    let (ball, glue) = (Arc::new(ball()?), Material::new(1.0, 1.0)?);
    for (value, count, completeness) in [
        (-1e-100, 2, SearchQuality::Resolved),
        (-1e-200, 1, SearchQuality::Doubtful),
        (0.0, 1, SearchQuality::Resolved),
        (1e-200, 1, SearchQuality::Resolved),
        (-2.0, 0, SearchQuality::Resolved),
        (1e100, 1, SearchQuality::Resolved),
    ] {
        let found = equilibria(&ball, &glue, &Control::Indentation, &value)?;
        assert_eq!((found.len(), found.completeness), (count, completeness), "{value}");
    }
    Ok(())
}

#[test]
fn a_curve_is_asked_at_radii_and_values_alone() -> Result<()> {
    let (ball, glue) = (Arc::new(ball()?), Material::new(1.0, 1.0)?);
    for control in [Control::Indentation, Control::Force, Control::machine(1.0)?] {
        let curve = Contact::half_space(&ball, &glue, &control);
        for a in [-1.0, 0.0, f64::NAN, f64::INFINITY] {
            assert_eq!(refused(curve.detachment_elongation(&a)), Some(Quantity::ContactRadius));
            assert_eq!(refused(curve.critical_ratio(&a)), Some(Quantity::ContactRadius));
            assert!(curve.direction(&a, &0.0).is_err() && curve.state(&a).is_err() && curve.tangency(&a).is_err());
        }
        assert_eq!(refused(curve.direction(&0.1, &f64::NAN)), Some(control.quantity()));
    }
    let machine = Arc::new(Control::Machine { stiffness: -1.0 });
    assert_eq!(refused(Contact::half_space(&ball, &glue, &machine).critical_ratio(&0.1)), Some(Quantity::Stiffness));
    Ok(())
}

/// A machine that hardly gives way, near d = 0 where g is Δl: the indentation is D − F/k in all digits, not the difference of two lengths.
#[test]
fn a_stiff_machine_holds_a_depth_far_below_its_lengths() -> Result<()> {
    let (ball, material) = (Arc::new(ball()?), Material::new(1.0, 0.01)?);
    let (position, stiffness) = (1e-12, 1e12);
    let [rest] = &equilibria(&ball, &material, &Control::machine(stiffness)?, &position)?.equilibria[..] else {
        panic!("one equilibrium")
    };
    // a² = Δl = √(2πa/100), F = 2a(d − a²/3).
    let a = (0.02 * std::f64::consts::PI).cbrt();
    let force = 2.0 * a * (1e-12 - a * a / 3.0);
    // But for what the depth changes.
    assert!((rest.contact_radius / a - 1.0).abs() < 1e-10 && (rest.force / force - 1.0).abs() < 1e-10, "{rest:?}");
    let depth = position - rest.force / stiffness;
    assert!((rest.indentation / depth - 1.0).abs() < 1e-13, "{} {depth}", rest.indentation);
    Ok(())
}
