//! A tabulated branch against the search on it, which knows no polynomial.

use std::ops::ControlFlow;

use mdr_core::contact::{Control, Equilibrium, Flank, Result, Shape};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::medium::{Adhesion, Medium};
use mdr_numeric::tabulated::TabulatedBranch;
use mdr_numeric::transform::Quadrature;

const ROUNDOFF: f64 = 0.5 * f64::EPSILON;
/// The table may add to g the roundings that it accepts, 8, and those of its own evaluation and of the search, which are of the
/// same size.
const ROUNDINGS: f64 = 24.0;

/// How far two states at a value are apart, in roundings of a and of the lengths of which d is made, a g'(a) among them, through the slope of the
/// direction of change.
fn distance(contact: &Contact<f64>, value: f64, one: &Equilibrium<f64>, other: &Equilibrium<f64>) -> Result<[f64; 3]> {
    let a = other.contact_radius;
    let step = 1e-6;
    let direction = |a: f64| contact.direction(&a, &value);
    let slope = (direction(a * (1.0 + step))? - direction(a * (1.0 - step))?).abs() / (2.0 * step * a);
    let rise = contact.transform().slope(&a)?.abs() * a;
    let lengths =
        rise + contact.transform().g(&a)?.abs() + contact.detachment_elongation(&a)? + other.indentation.abs();
    // A radius that is wrong by so much has lengths that are wrong by as many more.
    let radius = a + lengths / slope;
    let depth = lengths * (1.0 + radius / a);
    let stretched = match contact.control() {
        Control::Machine { stiffness } => stiffness.min(contact.stiffness(&a)),
        _ => contact.stiffness(&a),
    };
    let roundings = |one: f64, other: f64, scale: f64| (one - other).abs() / (ROUNDOFF * scale);
    Ok([
        roundings(one.contact_radius, a, radius),
        roundings(one.indentation, other.indentation, depth),
        roundings(one.force, other.force, stretched * depth + other.force.abs()),
    ])
}

fn shapes() -> Vec<Shape<f64>> {
    let flank = || Flank::Slope(0.3);
    vec![
        Shape::Paraboloid { radius: 1.0 },
        Shape::Cone { flank: flank() },
        Shape::Sphere { radius: 1.0 },
        Shape::Hyperboloid { flank: Flank::Slope(1.0), lateral: 0.3 },
        Shape::RoundedPunch { radius: 1.0, flat: 0.2 },
        Shape::TruncatedCone { flank: flank(), flat: 0.2 },
        Shape::ConeParabolicCap { flank: flank(), cap: 0.3 },
        Shape::WavyParaboloid { radius: 1.0, amplitude: 5e-4, wavelength: 0.1 },
    ]
}

#[test]
fn the_states_of_a_table_are_those_of_the_search() -> Result<()> {
    let media = || -> Result<Vec<Medium<f64>>> { Ok(vec![Medium::half_space(1.0)?, Medium::winkler(1e9)?]) };
    let mut tables = 0;
    for (shape, medium) in
        shapes().into_iter().flat_map(|shape| media().into_iter().flatten().map(move |m| (shape.clone(), m)))
    {
        let work = 1e-3 * medium.modulus();
        for control in [Control::Indentation, Control::Force, Control::machine(0.1 * medium.modulus())?] {
            // Δl of uncoupled springs is constant, and beside the end of a flat so is the depth, to its rounding: a table costs too much.
            if matches!(
                (&shape, &medium, &control),
                (Shape::RoundedPunch { .. }, Medium::Winkler { .. }, Control::Indentation)
            ) {
                continue;
            }
            let transform = Quadrature::of([shape.clone()])?;
            let contact = Contact::new(transform, medium.clone(), Adhesion::new(work)?, control.clone());
            let branches = SearchedBranches::new(contact.clone())?;
            let folds = branches.folds();
            let value = |fold: usize| folds.get(fold).map(|fold| control.controlled(&fold.indentation, &fold.force));
            let scale = (0..folds.len()).filter_map(value).fold(0.0, |scale: f64, value| scale.max(value.abs()));
            for branch in (0..=folds.len()).filter(|branch| branches.is_stable(*branch) == Some(true)) {
                let low = branch.checked_sub(1).and_then(value).unwrap_or(1e-3 * scale);
                let high = value(branch).unwrap_or(low + 5.0 * scale);
                // A fold at no force but for rounding, and a branch that ends below the first value.
                if !(low < high && scale > 1e-9) {
                    continue;
                }
                let table = TabulatedBranch::new(&branches, branch, [low, high], 100_000)?;
                let table = table.unwrap_or_else(|| panic!("no table of {shape:?} on {medium:?}, {control:?}"));
                tables += 1;
                let (mut found, count) = (0, 24);
                for i in 1..=count {
                    // Everywhere, and ever closer to the fold.
                    let share = f64::from(i) * 0.618_033_988_749_894_9 % 1.0;
                    let at = low + (high - low) * if i % 3 == 0 { 1e-5f64.powf(share) } else { share };
                    let Some(state) = table.at(at) else { continue };
                    found += 1;
                    let searched = branches.on_branch(branch, &at)?.expect("an equilibrium");
                    let apart = distance(&contact, at, &state, &searched)?;
                    assert!(
                        apart.iter().all(|roundings| *roundings <= ROUNDINGS),
                        "{shape:?} {control:?} at {at}: {apart:?}"
                    );
                }
                assert!(found >= count * 4 / 5, "{shape:?} {control:?}, branch {branch}: {found}");
                assert!(!table.is_beyond(0.5 * (low + high)));
                assert!(branch == 0 || table.is_beyond(low - 0.1 * scale) && table.at(low - 0.1 * scale).is_none());
            }
        }
    }
    assert!(tables >= 36, "{tables}");
    Ok(())
}

#[test]
fn a_table_that_costs_too_much_is_none() -> Result<()> {
    let ball = Quadrature::of([Shape::Paraboloid { radius: 1.0 }])?;
    let contact = Contact::new(ball, Medium::half_space(1.0)?, Adhesion::new(1e-3)?, Control::Indentation);
    let branches = SearchedBranches::new(contact)?;
    assert!(TabulatedBranch::new(&branches, 1, [-0.01, 0.1], 100)?.is_none());
    // The branch below the fold is not stable.
    assert!(TabulatedBranch::new(&branches, 0, [-0.01, 0.1], 100_000)?.is_none());
    let table = TabulatedBranch::new(&branches, 1, [-0.01, 0.1], 100_000)?.expect("a table");
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.2] {
        assert!(table.at(value).is_none());
    }
    Ok(())
}

#[test]
fn many_states_at_once_are_those_of_each_value() -> Result<()> {
    let ball = Quadrature::of([Shape::Sphere { radius: 1.0 }])?;
    let contact = Contact::new(ball, Medium::half_space(1.0)?, Adhesion::new(1e-3)?, Control::Force);
    let branches = SearchedBranches::new(contact)?;
    let table = TabulatedBranch::new(&branches, 1, [-1e-2, 0.1], 100_000)?.expect("a table");
    let beside = [f64::NAN, f64::INFINITY, -1.0, 0.2, table.end()];
    let values: Vec<f64> = (0..1000).map(|i| -1e-2 + 1.2e-4 * f64::from(i)).chain(beside).collect();
    for count in [0, 1, 31, 32, 33, values.len()] {
        let mut states = Vec::new();
        let all = table.at_each(&values[values.len() - count..], |_, state| {
            states.push(state);
            ControlFlow::<()>::Continue(())
        });
        assert!(all.is_continue());
        let each: Vec<_> = values[values.len() - count..].iter().map(|value| table.at(*value)).collect();
        assert_eq!(states, each);
    }
    assert!(values.iter().filter(|value| table.at(**value).is_some()).count() > 800);
    let stopped = table
        .at_each(&values, |value, _| if value < 0.05 { ControlFlow::Continue(()) } else { ControlFlow::Break(value) });
    assert_eq!(stopped.break_value(), values.iter().copied().find(|value| !(*value < 0.05)));
    Ok(())
}
