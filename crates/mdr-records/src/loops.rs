//! Records of loops with two works of adhesion, w₁ of an edge that advances and w₂ of one that recedes, for power laws with n > 1/2.
//!
//! Surfaces that are apart are pressed together until what is held is `turn`, and drawn back. At w₁ = 0 they are pressed together as
//! Hertz has it. Values are closed forms of `mdr-analytic` over intervals, and equilibria of both edges proved there.

use mdr_analytic::{PowerLaw, PowerLawContact};
use mdr_core::contact::{Control, Error, Material, Quantity, Result, Stability, Transform};
use mdr_core::number::{Interval, Real};

use crate::media::{Held, LENGTHS, Question, question};

const RADIUS_AND_FORCE: &[(&str, &str)] = &[("contact_radius", "m"), ("force", "N")];
const RADIUS_AND_DEPTH: &[(&str, &str)] = &[("contact_radius", "m"), ("indentation", "m")];
const ENERGY: &[(&str, &str)] = &[("energy", "J")];
const FORCE: &[(&str, &str)] = &[("force", "N")];

/// Questions: formula, name, what is held, quantities, flags, n, C, E*, w₁, w₂, and the reversal with what is held after it.
macro_rules! questions {
    ($($formula:literal $name:literal $held:ident $quantities:ident [$($flag:literal)*] $n:literal $c:literal $e:literal $w1:literal $w2:literal $($more:literal = $value:literal)*;)*) => {
        &[$(question!($formula "power" $name Some(Held::$held), $quantities, Minimum, [$($flag)*],
            "n" = $n "C" = $c "E*" = $e "w1" = $w1 "w2" = $w2 $($more = $value)*)),*]
    };
}

/// The grain is two spheres of 1 mm that touch, without adhesion while they are pressed together.
pub(crate) const LOOPS: &[Question] = questions! {
    "loop-state" "grain" Indentation RADIUS_AND_FORCE ["si" "pinned"] "2" "1000" "5e6" "0" "0.05" "turn" = "2e-6" "d" = "1e-6";
    "loop-state" "grain" Indentation RADIUS_AND_FORCE ["si" "receding"] "2" "1000" "5e6" "0" "0.05" "turn" = "2e-6" "d" = "-2e-7";
    "loop-pull-off" "grain" Indentation LENGTHS ["si"] "2" "1000" "5e6" "0" "0.05" "turn" = "2e-6";
    "loop-pull-off" "grain" Indentation LENGTHS ["si" "pressed-too-little"] "2" "1000" "5e6" "0" "0.05" "turn" = "1e-7";
    "loop-pull-off" "grain" Force LENGTHS ["si" "pressed-too-little"] "2" "1000" "5e6" "0" "0.05" "turn" = "1e-5";
    "loop-work" "grain" Indentation ENERGY ["si"] "2" "1000" "5e6" "0" "0.05" "turn" = "2e-6";
    "loop-preload" "grain" Force FORCE ["si"] "2" "1000" "5e6" "0" "0.05";
    "loop-state" "unit" Indentation RADIUS_AND_FORCE ["receding"] "2" "0.5" "1" "0.04" "1" "turn" = "1" "d" = "-1.5";
    "loop-state" "unit" Force RADIUS_AND_DEPTH ["pinned"] "2" "0.5" "1" "0.04" "1" "turn" = "2" "F" = "-4";
    "loop-work" "unit" Indentation ENERGY [] "2" "0.5" "1" "0.04" "1" "turn" = "1";
    "loop-pull-off" "cone-unit" Force LENGTHS ["pressed-too-little"] "1" "1" "1" "0" "0.1" "turn" = "0.01";
    "loop-work" "cone-unit" Indentation ENERGY [] "1" "1" "1" "0" "0.1" "turn" = "0.5";
};

/// The values of the quantities, enclosed.
pub(crate) fn values(formula: &str, held: Option<Held>, x: &[Interval]) -> Result<Vec<Interval>> {
    let control = if held == Some(Held::Force) { Control::Force } else { Control::Indentation };
    let law = PowerLaw::new(x[0].clone(), x[1].clone())?;
    let receding = PowerLawContact::new(law, Material::new(x[2].clone(), x[4].clone())?);
    if formula == "loop-preload" {
        return Ok(vec![receding.preload_for_full_pull_off(&x[3], &control)?]);
    }
    let reversal = reversal(&receding, &x[3], &control, &x[5])?;
    match formula {
        "loop-work" => {
            let lost = receding.loop_work(&x[3], &reversal)?;
            Ok(vec![lost.jump_in + &lost.hysteresis + &lost.pull_off])
        }
        "loop-pull-off" => {
            let state = receding.pull_off_from(&reversal, &control)?;
            Ok(vec![state.contact_radius, state.indentation, state.force])
        }
        _ => on_the_way_back(&receding, &reversal, &control, &x[6]),
    }
}

/// The contact radius of the advancing edge, which gains `advancing`, where what is held is `turn`.
fn reversal(
    receding: &PowerLawContact<Interval>,
    advancing: &Interval,
    control: &Control<Interval>,
    turn: &Interval,
) -> Result<Interval> {
    let (profile, modulus) = (receding.profile(), receding.material().effective_modulus());
    if *advancing > turn.lit(0) {
        let material = Material::new(modulus.clone(), advancing.clone())?;
        return stable(&PowerLawContact::new(profile.clone(), material), control, turn);
    }
    // Hertz: d = κC aⁿ, F = 2E*a nd/(n + 1).
    let (n, unit) = (profile.exponent(), profile.kappa().clone() * profile.coefficient());
    let next = n.clone() + &n.lit(1);
    Ok(match control {
        Control::Force => (turn.clone() * &next / &(unit * n * modulus).times(2)).pow(&(n.lit(1) / &next)),
        _ => (turn.clone() / &unit).pow(&(n.lit(1) / n)),
    })
}

/// The radius of the stable equilibrium at a value of what is held.
fn stable(contact: &PowerLawContact<Interval>, control: &Control<Interval>, value: &Interval) -> Result<Interval> {
    let found = contact.equilibria(control, value)?;
    let stable = found.as_slice().iter().find(|state| state.stability == Stability::Stable);
    let state = stable.ok_or_else(|| Error::no_equilibrium(control.quantity(), value))?;
    Ok(state.contact_radius.clone())
}

/// The state on the way back from a reversal at this radius: the edge is pinned there while g − d is less than Δl₂, then it recedes.
/// The contact radius, and of d and F the one that is not held.
fn on_the_way_back(
    receding: &PowerLawContact<Interval>,
    reversal: &Interval,
    control: &Control<Interval>,
    value: &Interval,
) -> Result<Vec<Interval>> {
    let (profile, modulus) = (receding.profile(), receding.material().effective_modulus());
    // F = 2E*a(d − g/(n + 1)) of any radius.
    let other = |a: &Interval| -> Result<Interval> {
        let mean = profile.g(a)? / &(profile.exponent().clone() + &a.lit(1));
        let stiffness = (modulus.clone() * a).times(2);
        Ok(if *control == Control::Force {
            value.clone() / &stiffness + &mean
        } else {
            (value.clone() - &mean) * &stiffness
        })
    };
    let held_back = other(reversal)?;
    let depth = if *control == Control::Force { &held_back } else { value };
    let (elongation, most) = (profile.g(reversal)? - depth, receding.detachment_elongation(reversal)?);
    if elongation < most {
        return Ok(vec![reversal.clone(), held_back]);
    }
    let radius = stable(receding, control, value)?;
    if elongation > most && radius < *reversal {
        let other = other(&radius)?;
        return Ok(vec![radius, other]);
    }
    Err(Error::undecided(Quantity::ContactRadius, reversal, "whether the edge recedes"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use mdr_core::number::Precision;

    /// Half of a loop in closed form: pinned at the Hertz radius √(Rd), F = 2E*a(d − a²/3R).
    #[test]
    fn a_grain_is_pinned_at_the_radius_of_hertz() -> Result<()> {
        let number = |text: &str| Interval::from_literal(Precision::new(200), &text.parse().expect("a number"));
        let x = ["2", "1000", "5e6", "0", "0.05", "2e-6", "1e-6"].map(number);
        let found = values("loop-state", Some(Held::Indentation), &x)?;
        assert!((found[0].approx() / 1e-9_f64.sqrt() - 1.0).abs() < 1e-15);
        assert!((found[1].approx() / (1e7 * 1e-9_f64.sqrt() * (1e-6 - 2e-6 / 3.0)) - 1.0).abs() < 1e-14);
        // Beside the reversal nothing is decided by chance: drawn back by less than Δl₂ it is pinned, by more it recedes.
        let beyond = values("loop-state", Some(Held::Indentation), &[&x[..6], &[number("5e-7")]].concat())?;
        assert!(beyond[0].approx() < 0.999 * found[0].approx());
        Ok(())
    }

    /// A state is flagged as pinned if, and only if, its radius does not depend on w₂.
    #[test]
    fn flags_say_which_edge_moves() -> Result<()> {
        for question in LOOPS.iter().filter(|question| question.formula == "loop-state") {
            let number = |text: &str| Interval::from_literal(Precision::new(200), &text.parse().expect("a number"));
            let mut x: Vec<Interval> = question.inputs.iter().map(|(_, text)| number(text)).collect();
            let radius = values(question.formula, question.held, &x)?.swap_remove(0);
            x[4] = x[4].clone() * number("1.001");
            let moved = values(question.formula, question.held, &x)?.swap_remove(0);
            let flag = if radius.is_same(&moved) { "pinned" } else { "receding" };
            assert!(question.flags.contains(&flag), "{question:?}");
        }
        Ok(())
    }

    /// Below the fold there is nothing to answer.
    #[test]
    fn a_broken_contact_has_no_state() {
        let number = |text: &str| Interval::from_literal(Precision::new(200), &text.parse().expect("a number"));
        let x = ["2", "1000", "5e6", "0", "0.05", "2e-6", "-6e-7"].map(number);
        assert!(values("loop-state", Some(Held::Indentation), &x).is_err());
    }
}
