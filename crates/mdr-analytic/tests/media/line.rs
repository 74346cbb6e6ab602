//! Power laws in line contact.

use approx::assert_relative_eq;
use mdr_analytic::media::{LineContact, cylinder_depth, line_factor, line_stiffness, line_threshold};
use mdr_core::contact::{Error, Material, Regime, Result, Stability};
use mdr_core::number::{Dual, Interval, Precision, Real};

use super::{number, prove};

fn contact(precision: Precision, n: &str) -> Result<LineContact<Interval>> {
    let [n, work] = [n, "0.01"].map(|text| number(precision, text));
    LineContact::new(n, work.lit(1), Material::new(work.lit(1), work)?)
}

#[test]
fn critical_states_of_power_laws() {
    let critical = |n: &'static str| {
        move |precision: Precision| contact(precision, n)?.critical().map(|(half_width, force)| [half_width, force])
    };
    let square = ["0.11675443249407359924094248537", "-0.0642373898770883625007337513968"];
    prove(square, critical("2"));
    let quarter = ["0.205379013679104853025403034976", "0.113597288750726217274819194434"];
    prove(quarter, critical("1/4"));
    // The wedge: πw/2 and −πw/2.
    prove(["0.0157079632679489661923132169163975", "-0.0157079632679489661923132169163975"], critical("1"));
}

#[test]
fn the_cylinder() {
    prove(["0.185336108963042562922120435725", "-0.0809340396964474671233119722858"], |precision| {
        let work = number(precision, "0.01");
        let cylinder = LineContact::cylinder(work.lit(1), Material::new(work.lit(1), work)?)?;
        cylinder.critical().map(|(half_width, force)| [half_width, force])
    });
}

#[test]
fn the_threshold_is_twice_the_constant_of_gauss() {
    prove(["1.6692536833481463725628594656"], |precision| {
        let one = Interval::from_int(precision, 1);
        // √(2πw/E*) = 1.
        Ok([line_threshold(&Material::new(one.pi().times(2), one)?)?])
    });
    let [factor, half] = [line_factor(&0.5).unwrap(), line_threshold(&Material::new(1.0, 0.01).unwrap()).unwrap()];
    assert_relative_eq!(half * factor, (0.02 * std::f64::consts::PI).sqrt(), max_relative = 1e-15);
}

/// c_n = nκ_{n+1}/(n+1), against the form with κ_n that is computed.
#[test]
fn the_factor_by_the_next_kappa() {
    for n in [0.05, 0.5, 1.0, 2.0, 7.3, 120.0] {
        let expected = n * mdr_analytic::kappa(&(n + 1.0)).unwrap() / (n + 1.0);
        assert_relative_eq!(line_factor(&n).unwrap(), expected, max_relative = 1e-15);
    }
}

#[test]
fn states_slopes_and_release_rate() -> Result<()> {
    for n in [0.3, 1.0, 2.0, 4.5] {
        let tip = LineContact::new(n, 0.7, Material::new(3.0, 0.02)?)?;
        let constant = Dual::constant;
        let dual = LineContact::new(constant(n), constant(0.7), Material::new(constant(3.0), constant(0.02))?)?;
        for b in [0.01, 0.2, 3.0] {
            let force = tip.force(&b)?;
            assert_relative_eq!(tip.energy_release_rate(&b, &force)?, 0.02, max_relative = 1e-12);
            let slope = tip.force_slope(&b)?;
            let scale = 3.0 * (b.powf(n - 1.0) * 3.0 + 1.0 / b.sqrt());
            assert!((dual.force(&Dual::variable(b))?.slope - slope).abs() < 1e-14 * scale, "{n} {b}");
            let found = tip.half_widths(&force)?;
            let here = found.iter().find(|(half_width, _)| (half_width / b - 1.0).abs() < 1e-9);
            let stability = if slope > 0.0 { Stability::Stable } else { Stability::Unstable };
            assert_eq!(here.map(|(_, stability)| *stability), Some(stability), "{n} {b}: {found:?}");
        }
        let (half_width, _) = tip.critical()?;
        assert!(tip.force_slope(&half_width)?.abs() < 1e-13 * 3.0 / half_width.sqrt());
        let expected = if n > 0.5 { Regime::PullOff } else { Regime::CompleteContact };
        assert_eq!(tip.regime()?, expected);
        // The loss at jump-in is ∫ 2(w − G) db, here by the trapezoidal rule in √b, whose error is of the order h².
        if n < 0.5 {
            assert!(matches!(tip.energy_lost_at_jump_in(), Err(Error::Domain { .. })));
            continue;
        }
        let stable = tip.half_widths(&0.0)?.last().unwrap().0;
        let steps = 20_000;
        let integrand = |x: f64| 2.0 * (0.02 - tip.energy_release_rate(&(x * x), &0.0).unwrap()) * 2.0 * x;
        let width = stable.sqrt() / f64::from(steps);
        let sum: f64 = (1..steps).map(|step| integrand(f64::from(step) * width)).sum();
        assert_relative_eq!(tip.energy_lost_at_jump_in()?, sum * width, max_relative = 1e-6);
    }
    Ok(())
}

/// dδ/dF = 1/S at a fixed half-width: the flat strip.
#[test]
fn depth_against_a_reference() -> Result<()> {
    let material = Material::new(2.0, 0.01)?;
    let (radius, b, reference) = (1.5, 0.2, 3.0);
    let depth = |force: f64| cylinder_depth(&radius, &b, &(force / 2.0), &reference);
    let stiffness = 0.5 / (depth(0.5)? - depth(0.0)?);
    assert_relative_eq!(stiffness, line_stiffness(&material, &b, &reference)?, max_relative = 1e-13);
    // (2/π)∫₀ᵇ arcosh(L/c) N'(c) dc with N' = πc/2R, by the midpoint rule, plus the part of the strip.
    let force = -0.3;
    let steps = 20_000;
    let width = b / f64::from(steps);
    let integrand = |c: f64| (reference / c).acosh() * c / radius;
    let shape: f64 = (0..steps).map(|step| integrand((f64::from(step) + 0.5) * width) * width).sum();
    let pulled = force / 2.0 - std::f64::consts::PI * b * b / (4.0 * radius);
    let expected = shape + 2.0 / std::f64::consts::PI * (reference / b).acosh() * pulled;
    assert_relative_eq!(depth(force)?, expected, max_relative = 1e-8);
    assert!(line_stiffness(&material, &1.0, &1.0).is_err() && line_stiffness(&material, &0.0, &1.0).is_err());
    Ok(())
}

#[test]
fn at_one_half_only_the_threshold_decides() {
    let tip = LineContact::new(0.5, 1.0, Material::new(1.0, 0.01).unwrap()).unwrap();
    assert!(matches!(tip.critical(), Err(Error::Domain { .. })));
    assert!(matches!(tip.energy_lost_at_jump_in(), Err(Error::Domain { .. })));
    assert!(LineContact::new(0.0, 1.0, Material::new(1.0, 0.01).unwrap()).is_err());
}
