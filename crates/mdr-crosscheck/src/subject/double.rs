//! The functions of `mdr_analytic::double` for one number.

use std::f64::consts::PI;

use mdr_analytic::{Kappa, PowerLaw, PowerLawContact, State, double, flat_punch_pull_off, threshold};
use mdr_core::contact::{Control, Error, Fold, Material, Quantity, Ranged, Result, Transform};
use mdr_core::number::Real;

use super::routine::{Routine, routine, routines};
use super::textbook;

/// The inputs of a question about a power law, and of one about a power law on a machine.
pub(crate) const LAW: &[&str] = &["n", "C", "E*", "w"];
pub(crate) const MACHINE: &[&str] = &["n", "C", "E*", "w", "k"];

/// The profile of [n, C, …].
pub(crate) fn profile<R: Kappa>(x: &[R]) -> Result<PowerLaw<R>> {
    PowerLaw::new(x[0].clone(), x[1].clone())
}

/// The material of [E*, w, …].
pub(crate) fn material<R: Real>(x: &[R]) -> Result<Material<R>> {
    Material::new(x[0].clone(), x[1].clone())
}

/// The contact of [n, C, E*, w, …].
pub(crate) fn contact<R: Kappa>(x: &[R]) -> Result<PowerLawContact<R>> {
    Ok(PowerLawContact::new(profile(x)?, material(&x[2..])?))
}

/// The contact of [C, E*, w, …] at n = 1/2.
fn half<R: Kappa>(x: &[R]) -> Result<PowerLawContact<R>> {
    contact(&[x[0].ratio(1, 2), x[0].clone(), x[1].clone(), x[2].clone()])
}

/// The machine of stiffness k.
pub(crate) fn machine<R: Clone>(k: &R) -> Control<R> {
    Control::Machine { stiffness: k.clone() }
}

/// [n, C, E*, w].
fn law(x: &[f64]) -> [f64; 4] {
    [x[0], x[1], x[2], x[3]]
}

routines! {
    KAPPA ["n"] {
        "double::kappa": |x| double::kappa(x[0]).map(Ranged::Value), exact mdr_analytic::kappa(&x[0]),
            textbook "√π Γ(1+n/2)/Γ((n+1)/2)" => textbook::kappa(x[0]);
        "double::kappa, against log-gammas": |x| double::kappa(x[0]).map(Ranged::Value), exact mdr_analytic::kappa(&x[0]),
            textbook "√π exp(ln Γ(1+n/2) − ln Γ((n+1)/2))" => textbook::kappa_by_logarithms(x[0]);
    }
    UNIVERSAL ["n", "a/a_c"] {
        "double::universal_indentation": |x| double::universal_indentation(x[0], x[1]),
            exact mdr_analytic::universal_indentation(&x[0], &x[1]),
            textbook "(ãⁿ − 2nã^½)/|1−2n|" => textbook::universal_indentation(x[0], x[1]);
        "double::universal_force": |x| double::universal_force(x[0], x[1]),
            exact mdr_analytic::universal_force(&x[0], &x[1]),
            textbook "(ãⁿ⁺¹ − 2(n+1)ã^(3/2))/(2n+1)" => textbook::universal_force(x[0], x[1]);
    }
    TRANSFORM ["n", "C", "x"] {
        "double::g": |x| double::g(x[0], x[1], x[2]), exact profile(x)?.g(&x[2]),
            textbook "κ_n C xⁿ with log-gammas" => textbook::g(x[0], x[1], x[2]);
        "double::g_slope": |x| double::g_slope(x[0], x[1], x[2]), exact profile(x)?.slope(&x[2]),
            textbook "n κ_n C xⁿ⁻¹ with log-gammas" => x[0] * textbook::g(x[0], x[1], x[2]) / x[2];
        "double::g_integral": |x| double::g_integral(x[0], x[1], x[2]), exact profile(x)?.integral(&x[2]),
            textbook "κ_n C xⁿ⁺¹/(n+1) with log-gammas" => textbook::g(x[0], x[1], x[2]) * x[2] / (x[0] + 1.0);
    }
    ELONGATION ["E*", "w", "a"] {
        "double::detachment_elongation": |x| double::detachment_elongation(&material(x)?, x[2]),
            exact mdr_analytic::detachment_elongation(&material(x)?, &x[2]),
            textbook "√(2πaw/E*)" => textbook::elongation(x[0], x[1], x[2]);
    }
    /// d, F, d', F'.
    STATE ["n", "C", "E*", "w", "a"] {
        "double::indentation": |x| double::indentation(x[0], x[1], &material(&x[2..])?, x[4]),
            exact contact(x)?.indentation(&x[4]), textbook "(1.13)" => textbook::indentation(law(x), x[4]);
        "double::force": |x| double::force(x[0], x[1], &material(&x[2..])?, x[4]),
            exact contact(x)?.force(&x[4]), textbook "(1.16)" => textbook::force(law(x), x[4]);
        "double::indentation_slope": |x| double::indentation_slope(x[0], x[1], &material(&x[2..])?, x[4]),
            exact contact(x)?.indentation_slope(&x[4]),
            textbook "g' − √(πw/(2E*a))" => textbook::indentation_slope(law(x), x[4]);
        "double::force_slope": |x| double::force_slope(x[0], x[1], &material(&x[2..])?, x[4]),
            exact contact(x)?.force_slope(&x[4]),
            textbook "2E*(a d' − Δl)" => textbook::force_slope(law(x), x[4]);
    }
    ENERGY ["n", "C", "E*", "w", "a", "d"] {
        "double::energy": |x| double::energy(x[0], x[1], &material(&x[2..])?, x[4], x[5]),
            exact contact(x)?.energy(&x[4], &x[5]),
            textbook "E*a(d² − 2dg/(n+1) + g²/(2n+1)) − πa²w" => textbook::energy(law(x), x[4], x[5]);
    }
    CRITICAL_ON_MACHINE ["n", "C", "E*", "w", "k"] {
        "double::critical, machine, a":
            |x| Ok(double::critical(x[0], x[1], &material(&x[2..])?, &machine(&x[4]))?.contact_radius),
            exact Ok(contact(x)?.critical(&machine(&x[4]))?.contact_radius);
        "double::critical, machine, F":
            |x| Ok(double::critical(x[0], x[1], &material(&x[2..])?, &machine(&x[4]))?.force),
            exact Ok(contact(x)?.critical(&machine(&x[4]))?.force);
    }
    MACHINE_FOLDS ["n", "C", "E*", "w", "k"] {
        "double::machine_folds, middle, a":
            |x| Ok(middle(double::machine_folds(x[0], x[1], &material(&x[2..])?, x[4])?)?.contact_radius),
            exact Ok(middle(contact(x)?.machine_folds(&x[4])?)?.contact_radius);
        "double::machine_folds, middle, d":
            |x| Ok(middle(double::machine_folds(x[0], x[1], &material(&x[2..])?, x[4])?)?.indentation),
            exact Ok(middle(contact(x)?.machine_folds(&x[4])?)?.indentation);
        "double::machine_folds, middle, F":
            |x| Ok(middle(double::machine_folds(x[0], x[1], &material(&x[2..])?, x[4])?)?.force),
            exact Ok(middle(contact(x)?.machine_folds(&x[4])?)?.force);
        "double::machine_folds, first, a":
            |x| Ok(nth(double::machine_folds(x[0], x[1], &material(&x[2..])?, x[4])?, 0)?.contact_radius),
            exact Ok(nth(contact(x)?.machine_folds(&x[4])?, 0)?.contact_radius);
    }
    ZERO_INDENTATION ["n", "C", "E*", "w"] {
        "double::radius_at_zero_indentation": |x| double::radius_at_zero_indentation(x[0], x[1], &material(&x[2..])?),
            exact contact(x)?.radius_at_zero_indentation();
    }
    /// For n > 1/2.
    LOSSES ["n", "C", "E*", "w"] {
        "double::energy_lost_at_pull_off": |x| double::energy_lost_at_pull_off(x[0], x[1], &material(&x[2..])?),
            exact contact(x)?.energy_lost_at_pull_off();
        "double::energy_lost_at_jump_in": |x| double::energy_lost_at_jump_in(x[0], x[1], &material(&x[2..])?),
            exact contact(x)?.energy_lost_at_jump_in();
    }
    /// For n < 1/2.
    BARRIER ["n", "C", "E*", "w"] {
        "double::barrier_to_complete_contact": |x| double::barrier_to_complete_contact(x[0], x[1], &material(&x[2..])?),
            exact contact(x)?.barrier_to_complete_contact();
    }
    RATIO ["C", "E*", "w"] {
        "double::ratio": |x| double::ratio(x[0], &material(&x[1..])?), exact half(x)?.ratio();
    }
    /// Under fixed grips, under a dead load.
    THRESHOLDS ["E*", "w"] {
        "double::threshold, fixed grips": |x| double::threshold(&material(x)?, &Control::Indentation),
            exact threshold(&material(x)?, &Control::Indentation);
        "double::threshold, dead load": |x| double::threshold(&material(x)?, &Control::Force),
            exact threshold(&material(x)?, &Control::Force);
    }
    /// d, F.
    SCALE_FREE_STATE ["C", "E*", "w", "a"] {
        "double::scale_free_state, d": |x| Ok(double::scale_free_state(x[0], &material(&x[1..])?, x[3])?.indentation),
            exact Ok(half(x)?.scale_free_state(&x[3])?.indentation),
            textbook "(1.13)" => textbook::indentation([0.5, x[0], x[1], x[2]], x[3]);
        "double::scale_free_state, F": |x| Ok(double::scale_free_state(x[0], &material(&x[1..])?, x[3])?.force),
            exact Ok(half(x)?.scale_free_state(&x[3])?.force),
            textbook "(1.16)" => textbook::force([0.5, x[0], x[1], x[2]], x[3]);
    }
    FLAT_PUNCH ["b", "E*", "w"] {
        "double::flat_punch_pull_off, d": |x| Ok(double::flat_punch_pull_off(x[0], &material(&x[1..])?)?.indentation),
            exact Ok(flat_punch_pull_off(&x[0], &material(&x[1..])?)?.indentation);
        "double::flat_punch_pull_off, F": |x| Ok(double::flat_punch_pull_off(x[0], &material(&x[1..])?)?.force),
            exact Ok(flat_punch_pull_off(&x[0], &material(&x[1..])?)?.force);
    }
}

/// A number of the critical state under a control, with its tangency λ.
macro_rules! critical {
    ($name:literal, $control:ident, $part:ident, textbook $formula:literal => $textbook:ident($lambda:literal)) => {
        routine!(
            $name, LAW,
            |x| Ok(double::critical(x[0], x[1], &material(&x[2..])?, &Control::$control)?.$part),
            exact state_of(&contact(x)?, &Control::$control, |state| state.$part),
            textbook $formula => textbook::$textbook(law(x), $lambda)
        )
    };
}

/// The critical state under fixed grips: a, d, F.
pub(crate) const CRITICAL_INDENTATION: [Routine; 3] = [
    critical!("double::critical, fixed grips, a", Indentation, contact_radius,
        textbook "(1.15) corrected, in powers" => critical_radius(1.0)),
    critical!("double::critical, fixed grips, d", Indentation, indentation,
        textbook "(1.13) at a_c" => critical_indentation(1.0)),
    critical!("double::critical, fixed grips, F", Indentation, force, textbook "(1.16) at a_c" => critical_force(1.0)),
];

/// The critical state under a dead load: a, d, F.
pub(crate) const CRITICAL_FORCE: [Routine; 3] = [
    critical!("double::critical, dead load, a", Force, contact_radius,
        textbook "(1.15) with 9w, in powers" => critical_radius(3.0)),
    critical!("double::critical, dead load, d", Force, indentation, textbook "(1.13) at a_F" => critical_indentation(3.0)),
    critical!("double::critical, dead load, F", Force, force, textbook "(1.16) at a_F" => critical_force(3.0)),
];

/// A number of the critical state; its log₁₀ where one of the numbers is beyond the exponents of MPFR.
fn state_of<R: Kappa>(contact: &PowerLawContact<R>, control: &Control<R>, part: fn(State<R>) -> R) -> Result<R> {
    /// Half of the decades that MPFR has.
    const DECADES: f64 = 1.5e8;
    let logarithms = contact.ln_critical(control)?;
    let log10 = |x: &R| x.approx() / std::f64::consts::LN_10;
    let State { contact_radius, indentation, force } = &logarithms;
    // A number with the logarithm of 0 is 0, and not beyond anything.
    let far = |x: &R| log10(x).is_finite() && log10(x).abs() > DECADES;
    if [contact_radius, indentation, force].into_iter().any(far) {
        let log10 = log10(&part(logarithms));
        return Err(Error::OutOfRange { quantity: Quantity::ContactRadius, log10 });
    }
    Ok(part(contact.critical(control)?))
}

/// The middle one of some folds.
fn middle<R>(folds: Vec<Fold<R>>) -> Result<Fold<R>> {
    let at = folds.len() / 2;
    nth(folds, at)
}

fn nth<R>(folds: Vec<Fold<R>>, index: usize) -> Result<Fold<R>> {
    let none = || Error::NoEquilibrium { quantity: Quantity::MachinePosition, value: "any".to_owned() };
    folds.into_iter().nth(index).ok_or_else(none)
}

/// The C with which the critical state under fixed grips has the radius 1 on E* = w = 1.
pub(crate) fn planted(n: f64) -> f64 {
    (PI / 2.0).sqrt() / (n * mdr_analytic::kappa(&n).unwrap_or(f64::NAN))
}
