//! At the fold, beyond it, out of range, and rejected inputs.

use mdr_analytic::{Equilibria, PowerLaw, PowerLawContact, double};
use mdr_core::contact::{Control, Error, Material, Ranged, Stability};

#[test]
fn the_fold_itself_and_beyond() {
    // A cone with w = E* = C = 1 has d_c = −1 exactly, and the double root there is a_c = 2/π.
    let unit = Material::new(1.0, 1.0).unwrap();
    let ask = |d: f64| double::equilibria(1.0, 1.0, &unit, &Control::Indentation, d).unwrap();
    let Equilibria::One(fold) = ask(-1.0) else { panic!("the double root") };
    assert_eq!(fold.stability, Stability::Neutral);
    assert_eq!(fold.contact_radius, Ranged::Value(std::f64::consts::FRAC_2_PI));
    assert_eq!(ask(-1.0 - f64::EPSILON), Equilibria::None);
    assert_eq!(ask(-1.0 + f64::EPSILON / 2.0).as_slice().len(), 2);
    let ball = PowerLawContact::new(PowerLaw::new(2.0, 0.5).unwrap(), unit.clone());
    for control in [Control::Indentation, Control::Force] {
        let fold = ball.equilibria_at_distance(&control, &0.0).unwrap();
        assert_eq!(fold.as_slice()[0].contact_radius, ball.critical(&control).unwrap().contact_radius);
        assert_eq!(fold.as_slice()[0].stability, Stability::Neutral);
        assert_eq!(ball.equilibria_at_distance(&control, &-1e-300).unwrap(), Equilibria::None);
        assert_eq!(ball.equilibria_at_distance(&control, &1.0).unwrap().as_slice().len(), 1);
    }
}

#[test]
fn what_is_refused() {
    let unit = Material::new(1.0, 1.0).unwrap();
    let machine = Control::Machine { stiffness: 1.0 };
    for (n, control, value) in [
        (2.0, Control::Indentation, f64::NAN),
        (2.0, Control::Force, f64::INFINITY),
        (2.0, machine.clone(), 0.0),
        (-1.0, Control::Indentation, 0.0),
    ] {
        let refused = double::equilibria(n, 1.0, &unit, &control, value);
        assert!(matches!(refused, Err(Error::Domain { .. })), "{n}, {control:?}, {value}");
        let refused = double::equilibria_at_distance(n, 1.0, &unit, &control, value);
        assert!(matches!(refused, Err(Error::Domain { .. })), "{n}, {control:?}, {value}");
    }
    let scale_free = double::equilibria_at_distance(0.5, 1.0, &unit, &Control::Indentation, 0.5);
    assert!(matches!(scale_free, Err(Error::Domain { .. })));
}

/// A prepared contact gives the same results as a new one, and radii out of the range of f64 come with their logarithm.
#[test]
fn out_of_range() {
    let unit = Material::new(1.0, 1.0).unwrap();
    let ready = double::Inverse::new(2.0, 0.5, &unit, &Control::Indentation).unwrap();
    for d in [-1e-200, -1e-3, -1.0, 0.0, 1.0, 1e300] {
        let fresh = double::equilibria(2.0, 0.5, &unit, &Control::Indentation, d).unwrap();
        assert_eq!(ready.equilibria(d).unwrap(), fresh);
    }
    // a = d²/(2π) at d = −10⁻²⁰⁰.
    let Equilibria::Two([tiny, _]) = ready.equilibria(-1e-200).unwrap() else { panic!("two equilibria") };
    let expected = -400.0 - (2.0 * std::f64::consts::PI).log10();
    assert!(matches!(tiny.contact_radius, Ranged::Underflow { log10 } if (log10 - expected).abs() < 1e-10));
    let plain = PowerLawContact::new(PowerLaw::new(2.0, 0.5).unwrap(), unit);
    let refused = plain.equilibria(&Control::Indentation, &-1e-200);
    assert!(matches!(refused, Err(Error::OutOfRange { .. })), "{refused:?}");
}
