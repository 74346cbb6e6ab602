//! The f64 functions, which promise an ulp, or two for many points at once, against the same closed forms at 400 bits.

use mdr_analytic::double::grid::{Materials, Path, Points, States, critical_states_on};
use mdr_analytic::double::{Branches, Side};
use mdr_analytic::{Contact, Critical, Equilibria, PowerLaw, double};
use mdr_core::contact::{Error, Material, Ranged, Result, Status, Transform};
use mdr_core::number::{Precision, Real};
use rug::Float;

use super::Check;
use super::gamma::ulps;
use crate::grid::{Exponent, Family, Held, Scene};
use crate::report::Unit;
use crate::subject::DOUBLE_IDS;
use crate::trial::Trial;

/// Every function of `mdr_analytic::double`, also where its result is out of the range of f64.
pub(super) const DOUBLE_PRECISION: Check = Check {
    name: "double-precision",
    claim: "f64 functions against 400 bits: an ulp, two for many points at once; also of the log10 of what f64 cannot hold",
    equations: &["1.4", "1.5", "1.6", "1.10", "1.12", "1.13", "1.15", "1.16", "1.17", "1.19"],
    subjects: DOUBLE_IDS,
    unit: Unit::Ulp,
    cases: [120, 1200, 12_000],
    case,
};

/// What a function promises.
fn promised_ulp(name: &str) -> f64 {
    if matches!(name, "double::critical_states" | "double::Inverse::branches") { 2.0 } else { 1.0 }
}

/// Enough for 1/2 ± 2⁻⁵⁰, for ln a of any size and for what cancels in d, F and their slopes.
const REFERENCE_BITS: u32 = 400;

/// One comparison: the name of the function, its result, and the reference.
struct Pair {
    name: &'static str,
    found: Result<Ranged<f64>>,
    expected: Result<Float>,
}

fn pair(name: &'static str, found: Result<Ranged<f64>>, expected: Result<Float>) -> Pair {
    Pair { name, found, expected }
}

/// The three quantities of a state.
fn state(name: &'static str, found: Result<Critical<Ranged<f64>>>, expected: Result<Critical<Float>>) -> Vec<Pair> {
    let split = |quantity: fn(&Critical<Ranged<f64>>) -> Ranged<f64>, exact: fn(&Critical<Float>) -> Float| {
        pair(
            name,
            found.as_ref().map(quantity).map_err(Error::clone),
            expected.as_ref().map(exact).map_err(Error::clone),
        )
    };
    vec![
        split(|s| s.contact_radius, |s| s.contact_radius.clone()),
        split(|s| s.indentation, |s| s.indentation.clone()),
        split(|s| s.force, |s| s.force.clone()),
    ]
}

fn case(trial: &mut Trial<'_>) -> Result<()> {
    let held = trial.held();
    let round = trial.index;
    if round % 6 == 5 {
        return scale_free(trial, held);
    }
    let exponent = trial.exponent(round, Family::up_to(50));
    let mut scene: Scene<f64> = trial.scene(round, exponent, held.lambda(), ());
    // Every fourth coefficient is off by decades: results leave the range of f64.
    if round % 4 == 3 {
        let off = trial.uniform(-3.0, 3.0);
        scene.c *= 10_f64.powf(off);
        trial.describe_also(format_args!("C times 10^{off:e}"));
    }
    let stretch = (trial.uniform(-1.0, 1.0) / (scene.n + 1.0)).exp();
    let (n, c, material) = (scene.n, scene.c, scene.material()?);
    let exact = wide(&scene)?;
    let control = held.control::<f64>();
    let found = double::critical(n, c, &material, &control);
    let Ok(Critical { contact_radius: Ranged::Value(radius), .. }) = found else {
        return enter(trial, state("double::critical", found, exact.critical(&held.control())));
    };
    let a = radius * stretch;
    let (x, profile) = (float(a), exact.profile());
    let d = n.mul_add(a, -a);
    let mut pairs = state("double::critical", found, exact.critical(&held.control()));
    pairs.extend([
        pair("double::kappa", double::kappa(n).map(Ranged::Value), Ok(profile.kappa().clone())),
        pair("double::g", double::g(n, c, a), profile.g(&x)),
        pair("double::g_slope", double::g_slope(n, c, a), profile.slope(&x)),
        pair("double::g_integral", double::g_integral(n, c, a), profile.integral(&x)),
        pair(
            "double::detachment_elongation",
            double::detachment_elongation(&material, a),
            exact.detachment_elongation(&x),
        ),
        pair("double::indentation", double::indentation(n, c, &material, a), exact.indentation(&x)),
        pair("double::force", double::force(n, c, &material, a), exact.force(&x)),
        pair("double::indentation_slope", double::indentation_slope(n, c, &material, a), exact.indentation_slope(&x)),
        pair("double::force_slope", double::force_slope(n, c, &material, a), exact.force_slope(&x)),
        pair("double::energy", double::energy(n, c, &material, a, d), exact.energy(&x, &float(d))),
        pair(
            "double::universal_indentation",
            double::universal_indentation(n, stretch),
            mdr_analytic::universal_indentation(&float(n), &float(stretch)),
        ),
        pair(
            "double::universal_force",
            double::universal_force(n, stretch),
            mdr_analytic::universal_force(&float(n), &float(stretch)),
        ),
        pair(
            "double::radius_at_zero_indentation",
            double::radius_at_zero_indentation(n, c, &material),
            exact.radius_at_zero_indentation(),
        ),
    ]);
    if n > 0.5 {
        pairs.push(pair(
            "double::energy_lost_at_pull_off",
            double::energy_lost_at_pull_off(n, c, &material),
            exact.energy_lost_at_pull_off(),
        ));
        pairs.push(pair(
            "double::energy_lost_at_jump_in",
            double::energy_lost_at_jump_in(n, c, &material),
            exact.energy_lost_at_jump_in(),
        ));
    } else {
        pairs.push(pair(
            "double::barrier_to_complete_contact",
            double::barrier_to_complete_contact(n, c, &material),
            exact.barrier_to_complete_contact(),
        ));
    }
    pairs.extend(state(
        "double::flat_punch_pull_off",
        double::flat_punch_pull_off(a, &material),
        mdr_analytic::flat_punch_pull_off(&x, exact.material()),
    ));
    pairs.extend(batch(&scene, held, &exact)?);
    pairs.extend(equilibria(trial, &scene, held, &exact)?);
    let stiffness = 2.0 * scene.e_star * a;
    if (n - 0.5).abs() > 0.03 {
        let folds = double::machine_folds(n, c, &material, stiffness)?;
        let expected = exact.machine_folds(&float(stiffness))?;
        trial.demand("the number of machine folds", folds.len() == expected.len());
        for (fold, exact) in folds.into_iter().zip(expected) {
            pairs.push(pair("double::machine_folds", Ok(fold.contact_radius), Ok(exact.contact_radius)));
            pairs.push(pair("double::machine_folds", Ok(fold.indentation), Ok(exact.indentation)));
            pairs.push(pair("double::machine_folds", Ok(fold.force), Ok(exact.force)));
        }
    }
    enter(trial, pairs)
}

/// The critical state as a batch of one point, by all instructions that the processor has.
fn batch(scene: &Scene<f64>, held: Held, exact: &Contact<Float>) -> Result<Vec<Pair>> {
    let material = scene.material()?;
    let points = Points { exponent: &[scene.n], coefficient: &[scene.c], material: Materials::One(&material) };
    let expected = exact.critical(&held.control())?;
    let mut pairs = Vec::new();
    for path in Path::available() {
        let [mut kappa, mut contact_radius, mut indentation, mut force] = [[0.0]; 4];
        let mut status = [Status::Ok];
        let mut states = States {
            kappa: &mut kappa,
            contact_radius: &mut contact_radius,
            indentation: &mut indentation,
            force: &mut force,
            status: &mut status,
        };
        critical_states_on(path, &points, &held.control(), &mut states)?;
        // Out of range the log10 is that of double::critical.
        if status == [Status::Ok] {
            let numbers = [
                (kappa, exact.profile().kappa()),
                (contact_radius, &expected.contact_radius),
                (indentation, &expected.indentation),
                (force, &expected.force),
            ];
            let named = |([found], expected): ([f64; 1], &Float)| {
                pair("double::critical_states", Ok(Ranged::Value(found)), Ok(expected.clone()))
            };
            pairs.extend(numbers.map(named));
        }
    }
    Ok(pairs)
}

/// Both sides of the fold, from close to it to far: at a value, fresh and ready, and at a distance.
fn equilibria(trial: &mut Trial<'_>, scene: &Scene<f64>, held: Held, exact: &Contact<Float>) -> Result<Vec<Pair>> {
    let (n, c, material, control) = (scene.n, scene.c, scene.material()?, held.control::<f64>());
    let fold = double::critical(n, c, &material, &control)?;
    let held_at_fold = match held {
        Held::Indentation => fold.indentation,
        Held::Force => fold.force,
    };
    let Ranged::Value(at_fold) = held_at_fold else { return Ok(Vec::new()) };
    let distance = 2_f64.powf(trial.uniform(-50.0, 3.0));
    let value = at_fold - distance * at_fold;
    if !(value.is_normal() && at_fold.is_normal()) {
        return Ok(Vec::new());
    }
    trial.describe_also(format_args!("{held}, τ = {distance:e}"));
    let fresh = double::equilibria(n, c, &material, &control, value)?;
    let ready = double::Inverse::new(n, c, &material, &control)?.equilibria(value)?;
    let expected = exact.equilibria(&held.control(), &float(value))?;
    let beside = double::equilibria_at_distance(n, c, &material, &control, distance)?;
    let expected_beside = exact.equilibria_at_distance(&held.control(), &float(distance))?;
    let mut pairs = Vec::new();
    for (name, found, expected) in [
        ("double::equilibria", fresh, &expected),
        ("double::Inverse::equilibria", ready, &expected),
        ("double::equilibria_at_distance", beside, &expected_beside),
    ] {
        let (found, expected) = (found.as_slice(), expected.as_slice());
        let same = found.iter().map(|x| x.stability).eq(expected.iter().map(|x| x.stability));
        trial.demand(format!("number and stability of {name}"), same);
        for (found, expected) in found.iter().zip(expected) {
            pairs.push(pair(name, Ok(found.contact_radius), Ok(expected.contact_radius.clone())));
            pairs.push(pair(name, Ok(found.indentation), Ok(expected.indentation.clone())));
            pairs.push(pair(name, Ok(found.force), Ok(expected.force.clone())));
        }
    }
    pairs.extend(branches(&double::Inverse::new(n, c, &material, &control)?, value, held, &expected)?);
    Ok(pairs)
}

/// The equilibria as a batch of one value, by all instructions that the processor has.
fn branches(inverse: &double::Inverse, value: f64, held: Held, expected: &Equilibria<Float>) -> Result<Vec<Pair>> {
    let mut pairs = Vec::new();
    for path in Path::available() {
        let ([mut a0, mut x0, mut a1, mut x1], mut status) = ([[0.0]; 4], [Status::Ok]);
        let mut found = Branches {
            smaller: Side { contact_radius: &mut a0, uncontrolled: &mut x0 },
            larger: Side { contact_radius: &mut a1, uncontrolled: &mut x1 },
            status: &mut status,
        };
        inverse.clone().with_instructions(path).branches(&[value], &mut found)?;
        // Out of range the log10 is that of double::equilibria.
        let sides = match expected.as_slice() {
            [only] if status == [Status::Ok] => vec![(only, a1, x1)],
            [smaller, larger] if status == [Status::Ok] => vec![(smaller, a0, x0), (larger, a1, x1)],
            _ => continue,
        };
        for (expected, [a], [x]) in sides {
            let other = match held {
                Held::Indentation => &expected.force,
                Held::Force => &expected.indentation,
            };
            for (found, expected) in [(a, &expected.contact_radius), (x, other)] {
                pairs.push(pair("double::Inverse::branches", Ok(Ranged::Value(found)), Ok(expected.clone())));
            }
        }
    }
    Ok(pairs)
}

fn scale_free(trial: &mut Trial<'_>, held: Held) -> Result<()> {
    let exponent = Exponent::Fraction(1, 2);
    let scales = trial.scales::<f64>(trial.index, exponent);
    let rho = 2_f64.powf(trial.uniform(-3.0, 3.0));
    let scene: Scene<f64> = trial.planted(exponent, rho, scales, ());
    let (c, material, a) = (scene.c, scene.material()?, scales.radius);
    let exact = wide(&scene)?;
    let mut pairs =
        state("double::scale_free_state", double::scale_free_state(c, &material, a), exact.scale_free_state(&float(a)));
    pairs.push(pair("double::ratio", double::ratio(c, &material), exact.ratio()));
    let threshold = mdr_analytic::threshold(exact.material(), &held.control());
    pairs.push(pair("double::threshold", double::threshold(&material, &held.control()), threshold));
    trial.demand("fate", double::fate(c, &material, &held.control())? == exact.fate(&held.control())?);
    enter(trial, pairs)
}

fn float(x: f64) -> Float {
    Float::from_f64(Precision::new(REFERENCE_BITS), x)
}

/// The same contact at 400 bits.
fn wide(scene: &Scene<f64>) -> Result<Contact<Float>> {
    let material = Material::new(float(scene.e_star), float(scene.work))?;
    Ok(Contact::new(PowerLaw::new(float(scene.n), float(scene.c))?, material))
}

fn enter(trial: &mut Trial<'_>, pairs: Vec<Pair>) -> Result<()> {
    for Pair { name, found, expected } in pairs {
        let (log10, exact) = match (found?, expected) {
            (Ranged::Value(value), expected) => {
                let (value, expected) = (trial.closed.double(name, value), expected?);
                let error = if value == 0.0 && expected == 0 { 0.0 } else { ulps(value, &expected) };
                trial.enter(name, error, promised_ulp(name));
                continue;
            }
            (Ranged::Overflow { log10 }, Ok(exact)) => {
                trial.demand(format!("{name} overflows"), exact.clone().abs() > f64::MAX);
                (log10, exact)
            }
            (Ranged::Underflow { log10 }, Ok(exact)) => {
                // 2⁻¹⁰⁷⁴ is the smallest.
                trial.demand(format!("{name} underflows"), exact != 0 && exact.get_exp().is_some_and(|e| e <= -1074));
                (log10, exact)
            }
            // Towards n = 1/2 some results, or what they come from, are out of the range of MPFR, too.
            (Ranged::Overflow { .. } | Ranged::Underflow { .. }, Err(Error::OutOfRange { .. })) => continue,
            (_, Err(error)) => return Err(error),
        };
        trial.enter(format!("log10 of {name}"), ulps(log10, &exact.abs().log10()), 1.0);
    }
    Ok(())
}
