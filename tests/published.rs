//! Published values, each with its source.
//!
//! The formulas are written out here as they are printed in the source, for the E* and w of this workspace (w is the
//! full work of separation; K = 4E*/3). Computed at 150 bits, where fifty published digits count as exact: the allowed
//! error is that of the few operations on both sides times their condition, far below what a wrong factor or exponent
//! would make.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use mdr_analytic::{PowerLaw, PowerLawContact, State, flat_punch_pull_off, kappa, lemniscate_constant, threshold};
use mdr_core::contact::{Control, Material, Result};
use mdr_core::number::{Literal, Precision, Real};
use rug::Float;

const BITS: u32 = 150;

/// Every comparison: below 60 operations on each side, no condition number above 8, one rounding 2^−150.
const ALLOWED: f64 = 60.0 * 2.0 * 8.0 * f64::from_bits((1023 - BITS as u64) << 52);

fn number(text: &str) -> Float {
    Float::from_literal(Precision::new(BITS), &text.parse::<Literal>().unwrap())
}

fn root(value: &Float, degree: i64) -> Float {
    value.abs().pow(&value.ratio(1, degree))
}

#[track_caller]
fn agree(found: &Float, published: &Float) {
    let error = (found.clone() / published - 1u32).abs().approx();
    assert!(error <= ALLOWED, "{} against {}: {error:e}", found.approx(), published.approx());
}

/// A soft gel, a work of adhesion, and some other combinations; the formulas are homogeneous, the numbers are arbitrary.
fn materials() -> Vec<Material<Float>> {
    [("1e4", "0.05"), ("2.1e11", "1"), ("3", "7"), ("1/3", "1e-9")]
        .map(|(e, w)| Material::new(number(e), number(w)).unwrap())
        .into()
}

fn both(material: &Material<Float>) -> (&Float, &Float) {
    (material.effective_modulus(), material.work_of_adhesion())
}

fn critical(profile: Result<PowerLaw<Float>>, material: &Material<Float>, control: &Control<Float>) -> State<Float> {
    PowerLawContact::new(profile.unwrap(), material.clone()).critical(control).unwrap()
}

/// Johnson, Kendall & Roberts, Proc. R. Soc. Lond. A 324 (1971) 301–313: the pull-off force −(3/2)πwR and
/// the radius (3πwR²/2K)^{1/3} at it. The depth is that of Maugis, PowerLawContact, Adhesion and Rupture of Elastic Solids,
/// Springer 2000: −(π²w²R/12K²)^{1/3}.
#[test]
fn jkr_sphere_under_a_dead_load() {
    for material in materials() {
        let (e, w) = both(&material);
        let (r, k) = (number("0.01"), e.clone().times(4).over(3));
        let found = critical(PowerLaw::paraboloid(r.clone()), &material, &Control::Force);
        let pi = w.pi();
        agree(&found.force, &-(pi.clone() * w * &r).times(3).over(2));
        agree(&found.contact_radius, &root(&((pi.clone() * w * r.powi(2)).times(3) / k.clone().times(2)), 3));
        agree(&found.indentation, &-root(&(pi.powi(2) * w.powi(2) * &r / k.powi(2).times(12)), 3));
    }
}

/// The sphere under fixed grips: F = −(5/6)πwR, a = (πwR²/6K)^{1/3}, d = −(3/4)(π²w²R/E*²)^{1/3}. Maugis (2000); Popov,
/// Contact Mechanics and Friction, 2nd ed., Springer 2017.
#[test]
fn jkr_sphere_under_fixed_grips() {
    for material in materials() {
        let (e, w) = both(&material);
        let (r, k) = (number("0.01"), e.clone().times(4).over(3));
        let found = critical(PowerLaw::paraboloid(r.clone()), &material, &Control::Indentation);
        let pi = w.pi();
        agree(&found.force, &-(pi.clone() * w * &r).times(5).over(6));
        agree(&found.contact_radius, &root(&(pi.clone() * w * r.powi(2) / k.times(6)), 3));
        agree(&found.indentation, &-root(&(pi.powi(2) * w.powi(2) * &r / e.powi(2)), 3).times(3).over(4));
    }
}

/// Kendall, J. Phys. D 4 (1971) 1186–1195: the flat punch of radius b is pulled off by √(8πE*wb³), and the power law with
/// C = b^{1−n} tends to it.
#[test]
fn kendalls_flat_punch() {
    for material in materials() {
        let (e, w) = both(&material);
        let b = number("0.3");
        let published = -(w.pi() * e * w * b.powi(3)).times(8).sqrt();
        agree(&flat_punch_pull_off(&b, &material).unwrap().force, &published);
        let defect = |n: i64| {
            let n = b.lit(n);
            let c = b.pow(&(n.lit(1) - &n));
            let force = critical(PowerLaw::new(n, c), &material, &Control::Indentation).force;
            (force / &published - 1u32).approx()
        };
        // F/F_∞ = (1 − 1/(2(n+1))) (B/(b n²κ²))^{3/(4n−2)} with κ² < (π/2)(n+1): see (1.17).
        let edge = (w.pi() * w / e.clone().times(2) / &b).ln().approx().abs();
        for n in [100_u32, 10_000, 1_000_000] {
            let x = f64::from(n);
            let bound = 1.5 / (2.0 * x - 1.0) * (edge + 3.0 * (x + 1.0).ln() + 0.5) + 0.5 / x;
            assert!(defect(n.into()).abs() < bound, "n = {n}: {} against {bound}", defect(n.into()));
        }
    }
    // b = E* = w = 1, n = 10⁴, by mpmath from (1.12), (1.15) and (1.16).
    let unit = Material::new(number("1"), number("1")).unwrap();
    let force = critical(PowerLaw::new(number("10000"), number("1")), &unit, &Control::Indentation).force;
    let ratio = force / flat_punch_pull_off(&number("1"), &unit).unwrap().force;
    agree(&ratio, &number("0.9978798205566613564881064754981291282314312078512"));
}

/// The cone f = r tanθ: Popov, Heß & Willert, Handbook of Contact Mechanics, Springer 2019, chapter 3 (Heß 2010).
/// Dead load: F = −54w²/(πE* tan³θ), a = 18w/(πE* tan²θ), d = 3w/(E* tanθ). Fixed grips: −6w²/(πE* tan³θ),
/// 2w/(πE* tan²θ), −w/(E* tanθ).
#[test]
fn cone() {
    for material in materials() {
        let (e, w) = both(&material);
        let slope = number("0.2");
        let pi = w.pi();
        let published = [(Control::Force, [-54, 18, 3]), (Control::Indentation, [-6, 2, -1])];
        for (control, [force, radius, depth]) in published {
            let found = critical(PowerLaw::cone(slope.clone()), &material, &control);
            agree(&found.force, &(w.powi(2) / (pi.clone() * e * slope.powi(3))).times(force));
            agree(&found.contact_radius, &(w.clone() / (pi.clone() * e * slope.powi(2))).times(radius));
            agree(&found.indentation, &(w.clone() / (e.clone() * &slope)).times(depth));
        }
    }
}

/// (1.18) and (1.19) of the paper: κ_{1/2} = π^{3/2}√2/(4Γ(3/4)²) ≈ 1,311, and the threshold 0,7628 in front of
/// √(2πw/E*). To fifty digits, mpmath: `1/(sqrt(pi)*gamma(mpf(5)/4)/gamma(mpf(3)/4))`; times 3 under a dead load.
#[test]
fn popovs_threshold() {
    let half = kappa(&number("1/2")).unwrap();
    let three_quarters = Float::with_val(BITS, 0.75).gamma();
    let printed = half.pi() * half.pi().sqrt() * half.lit(2).sqrt() / three_quarters.powi(2).times(4);
    agree(&half, &printed);
    agree(&half, &lemniscate_constant(&half).over(2));
    assert_eq!(format!("{:.4}", half.approx()), "1.3110");
    // √(2πw/E*) = 1.
    let unit = Material::new(half.pi().times(2), number("1")).unwrap();
    let stiff = threshold(&unit, &Control::Indentation).unwrap();
    agree(&stiff, &number("0.76275976350181318806232598096361579329262923734807"));
    assert_eq!(format!("{:.4}", stiff.approx()), "0.7628");
    agree(&threshold(&unit, &Control::Force).unwrap(), &number("2.2882792905054395641869779428908473798778877120442"));
}

/// The lemniscate constant ϖ, OEIS A062539.
#[test]
fn lemniscate() {
    let constant = lemniscate_constant(&number("1"));
    agree(&constant, &number("2.62205755429211981046483958989111941368275495143162"));
}

/// κ_n of the named profiles: 2 (paraboloid), π/2 (cone); Popov & Heß, Method of Dimensionality Reduction in PowerLawContact
/// Mechanics and Friction, Springer 2015, also have n = 3: 3π/4, and n = 4: 8/3.
#[test]
fn tabulated_kappa() {
    let pi = number("1").pi();
    let table =
        [("2", number("2")), ("1", pi.clone().over(2)), ("3", pi.clone().times(3).over(4)), ("4", number("8/3"))];
    for (n, published) in table {
        agree(&kappa(&number(n)).unwrap(), &published);
    }
}

/// The paraboloid on a machine, k/(2E*a_c) = 0.1, 1, 10: a/a_c solves t^{3/2} = (κ + 3t)/(κ + t); mpmath `findroot`.
#[test]
fn machine_between_the_limits() {
    let material = Material::new(number("1e6"), number("0.05")).unwrap();
    let contact = PowerLawContact::new(PowerLaw::paraboloid(number("0.01")).unwrap(), material.clone());
    let stiff = contact.critical(&Control::Indentation).unwrap().contact_radius;
    for (scaled, published) in [
        ("0.1", "2.0365865307982584792988855998458288453856451985841"),
        ("1", "1.7252662726654581352550067766676889814115497937682"),
        ("10", "1.1312893423936646718282059355138621063876283940864"),
    ] {
        let stiffness = number(scaled) * material.effective_modulus().clone().times(2) * &stiff;
        let folds = contact.machine_folds(&stiffness).unwrap();
        assert_eq!(folds.len(), 1);
        agree(&(folds[0].contact_radius.clone() / &stiff), &number(published));
    }
}

/// Energy lost in the jump of the paraboloid: 2/5 of πa_c²w at pull-off under fixed grips, 3/5 at the jump into contact at
/// d = 0, with a_c of the same and a of the new contact: n(2n−1)/((n+1)(2n+1)) and (2n−1)/(2n+1).
#[test]
fn energy_lost_in_a_jump() {
    let material = Material::new(number("1e6"), number("0.05")).unwrap();
    let contact = PowerLawContact::new(PowerLaw::paraboloid(number("0.01")).unwrap(), material.clone());
    let disc = |a: &Float| a.pi() * a.powi(2) * material.work_of_adhesion();
    let critical = contact.critical(&Control::Indentation).unwrap().contact_radius;
    agree(&contact.energy_lost_at_pull_off().unwrap(), &disc(&critical).times(2).over(5));
    let first = contact.radius_at_zero_indentation().unwrap();
    agree(&contact.energy_lost_at_jump_in().unwrap(), &disc(&first).times(3).over(5));
}
