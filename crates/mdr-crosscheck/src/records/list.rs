//! The power laws of the records.

use mdr_analytic::{Contact, Kappa, PowerLaw};
use mdr_core::contact::{Error, Material};
use mdr_core::number::{Precision, Real};
use rug::ops::Pow;
use rug::{Float, Integer};

use super::draft::literal;
use super::equilibria::{Equilibrium, Side, Target};
use super::machine::Jump;
use super::power::{Held, Power};

/// Exponents with a name or a place in the theory, on E* = w = 1.
const UNIT: [(&str, &str, &str); 24] = [
    ("jkr-unit", "2", "0.5"),
    ("cone-unit", "1", "1"),
    ("n=1.5", "1.5", "1"),
    ("n=3", "3", "1"),
    ("n=4", "4", "1"),
    ("n=6", "6", "1"),
    ("n=2.5", "2.5", "1"),
    ("n=1.25", "1.25", "1"),
    ("n=0.75", "0.75", "1"),
    ("n=0.6", "0.6", "2"),
    ("n=0.55", "0.55", "2"),
    ("n=0.45", "0.45", "2"),
    ("n=0.4", "0.4", "2"),
    ("n=0.25", "0.25", "1"),
    ("n=0.1", "0.1", "1"),
    ("n=0.01", "0.01", "1"),
    ("n=1e-3", "0.001", "1"),
    ("n=1e-4", "0.0001", "1"),
    ("n=1e-6", "0.000001", "1"),
    ("n=10", "10", "1"),
    ("n=31", "31", "1"),
    ("n=100", "100", "1"),
    ("n=316", "316", "1"),
    ("n=1000", "1000", "1"),
];

/// Contacts of real size, in SI units.
const REAL: [(&str, [&str; 4]); 9] = [
    ("afm-tip", ["2", "2.5e7", "7e10", "0.1"]),
    ("afm-tip-blunt", ["4", "1e22", "7e10", "0.1"]),
    ("glass-bead", ["2", "500", "4e10", "0.08"]),
    ("pdms-bead", ["2", "5e4", "1.3e6", "0.05"]),
    ("gecko-spatula", ["2", "5e6", "2e9", "0.05"]),
    ("tyre-asperity", ["2", "5e3", "5e6", "0.06"]),
    ("wheel-on-rail", ["2", "1.0870", "1.154e11", "0.5"]),
    ("berkovich-cone", ["1", "0.3584", "1.1e11", "0.3"]),
    ("cusp-on-gelatine", ["0.25", "0.01", "3e3", "0.02"]),
];

/// Scales that a program in f64 meets when it squares, cubes or multiplies carelessly, and beyond.
const EXTREME: [(&str, [&str; 4]); 9] = [
    ("stiff-1e100", ["2", "0.5", "1e100", "1"]),
    ("soft-1e-100", ["2", "0.5", "1e-100", "1"]),
    ("sticky-1e100", ["2", "0.5", "1", "1e100"]),
    ("slippery-1e-100", ["2", "0.5", "1", "1e-100"]),
    ("sharp-1e100", ["2", "1e100", "1", "1"]),
    ("flat-1e-100", ["2", "1e-100", "1", "1"]),
    ("all-1e100", ["3", "1e100", "1e100", "1e100"]),
    ("cone-1e-150", ["1", "1e-150", "1e-100", "1e100"]),
    ("cusp-1e-100", ["0.25", "1e-100", "1", "1"]),
];

/// k of n = 1/2 ± 2^−k.
const LADDER: [u32; 14] = [2, 3, 4, 6, 8, 10, 13, 16, 20, 25, 30, 35, 42, 50];

/// All power laws with a critical state.
pub(super) fn all() -> Vec<Power> {
    let unit = UNIT.iter().map(|(name, n, c)| Power::new(name, [n, c, "1", "1"], &[]));
    let real = REAL.iter().map(|(name, inputs)| Power::new(name, *inputs, &["si"]));
    let extreme = EXTREME.iter().map(|(name, inputs)| Power::new(name, *inputs, &["extreme-scale"]));
    let ladder = LADDER.iter().flat_map(|k| [near_half(*k, true), near_half(*k, false)]);
    unit.chain(real).chain(extreme).chain(ladder.flatten()).collect()
}

/// From this k on, the two critical radii are so far apart that no arbitrary-precision number holds both.
const APART: u32 = 26;

/// n = 1/2 ± 2^−k, exactly, and the C of 17 digits that puts the critical radius next to 1 for E* = w = 1: that of fixed
/// grips, and where the other one is out of reach that of a dead load in a case of its own.
fn near_half(k: u32, above: bool) -> Vec<Power> {
    // In units of 10^−k: 2^−k is 5^k, and 1/2 is 5·10^(k−1).
    let (step, half) = (Integer::from(5).pow(k), Integer::from(10).pow(k - 1) * 5u32);
    let digits: Integer = if above { half + step } else { half - step };
    let n = format!("0.{:0>width$}", digits.to_string(), width = k as usize);
    let sign = if above { '+' } else { '-' };
    let case = |suffix: &str, tension| {
        let name = format!("half{sign}2^-{k}{suffix}");
        Power::new(&name, [&n, &planted(&n, tension), "1", "1"], &["near-half"])
    };
    if k < APART {
        return vec![case("", 1)];
    }
    let only = |held, law| Power { held: vec![held], ..law };
    vec![only(Held::Indentation, case("", 1)), only(Held::Force, case("-loaded", 3))]
}

/// C = λ√B/(nκ_n) for E* = w = 1, to 17 digits.
fn planted(n: &str, tension: i64) -> String {
    let n = Float::from_literal(Precision::new(192), &literal(n));
    let c = n.pi().over(2).sqrt().times(tension) / Float::kappa(&n) / &n;
    c.to_string_radix(10, Some(17))
}

/// Contacts whose equilibria are records, and under which part of the identifier.
const EQUILIBRIA: [&str; 5] = ["jkr-unit", "cone-unit", "n=0.25", "n=0.6", "afm-tip"];

/// k of the distances τ = 2^−k to the fold.
const SHARES: [u32; 7] = [1, 4, 8, 16, 26, 40, 52];

/// k of the distances to the fold, in the controlled quantity to 17 digits.
const NEAR: [u32; 4] = [3, 12, 26, 40];

/// Equilibria at given shares of the critical value, and at given values.
pub(super) fn equilibria() -> Vec<Equilibrium> {
    let mut found = Vec::new();
    for law in all().into_iter().filter(|law| EQUILIBRIA.contains(&law.name.as_str())) {
        for held in Held::ALL {
            let ask = |target, side, label| Equilibrium { law: law.clone(), held, target, side, label };
            for side in Side::ALL {
                for k in SHARES {
                    found.push(ask(Target::Share(power_of_two(k)), side, format!("tau=2^-{k}")));
                }
                for k in NEAR {
                    let value = beside_fold(&law, held, k, -1);
                    found.push(ask(Target::Value(value), side, format!("near=2^-{k}")));
                }
            }
            // On the other side of zero there is one equilibrium, at last without a trace of adhesion in its leading digits.
            for (label, sign) in [("opposite", -2), ("opposite-1e3", -1001), ("opposite-1e6", -1_000_001)] {
                let value = beside_fold(&law, held, 0, sign);
                found.push(ask(Target::Value(value), Side::Outer, label.to_owned()));
            }
        }
    }
    found
}

/// Questions just past the fold, where there is no equilibrium.
pub(super) fn past_folds() -> Vec<Equilibrium> {
    let mut found = Vec::new();
    for law in all().into_iter().filter(|law| EQUILIBRIA.contains(&law.name.as_str())) {
        for (held, k) in Held::ALL.into_iter().flat_map(|held| [1, 12, 26, 40].map(|k| (held, k))) {
            let target = Target::Value(beside_fold(&law, held, k, 1));
            let label = format!("past=2^-{k}");
            found.push(Equilibrium { law: law.clone(), held, target, side: Side::Outer, label });
        }
    }
    found
}

/// Contacts of which the fold itself is asked for.
pub(super) fn double_roots() -> Vec<Equilibrium> {
    let laws = all().into_iter().filter(|law| EQUILIBRIA.contains(&law.name.as_str()));
    let fold = |law: Power| {
        Held::ALL.map(|held| {
            let target = Target::Share("0".to_owned());
            Equilibrium { law: law.clone(), held, target, side: Side::Outer, label: "tau=0".to_owned() }
        })
    };
    laws.flat_map(fold).collect()
}

/// 2^−k as a decimal.
fn power_of_two(k: u32) -> String {
    format!("0.{:0>width$}", Integer::from(5).pow(k).to_string(), width = k as usize)
}

/// The critical value of the controlled quantity times 1 + sign·2^−k, to 17 digits.
fn beside_fold(law: &Power, held: Held, k: u32, sign: i64) -> String {
    let [n, c, e_star, work] = law.texts().map(|text| Float::from_literal(Precision::new(192), &literal(text)));
    let factor = n.lit(1) + n.lit(2).powi(-i64::from(k)).times(sign);
    let critical = || {
        let contact = Contact::new(PowerLaw::new(n, c)?, Material::new(e_star, work)?);
        let state = contact.critical(&held.control())?;
        Ok::<_, Error>(if held == Held::Indentation { state.indentation } else { state.force })
    };
    let value = critical().unwrap_or_else(|error| unreachable!("{}: {error}", law.name));
    (value * factor).to_string_radix(10, Some(17))
}

/// Contacts on machines, and stiffnesses in N/m.
pub(super) fn machines() -> Vec<(Power, &'static str)> {
    let unit = |name: &str, n: &str, c: &str| Power::new(name, [n, c, "1", "1"], &[]);
    let tip = Power::new("afm-tip", ["2", "2.5e7", "7e10", "0.1"], &["si"]);
    vec![
        (unit("jkr-unit", "2", "0.5"), "1e-6"),
        (unit("jkr-unit", "2", "0.5"), "0.1"),
        (unit("jkr-unit", "2", "0.5"), "1"),
        (unit("jkr-unit", "2", "0.5"), "10"),
        (unit("jkr-unit", "2", "0.5"), "1e6"),
        (unit("cone-unit", "1", "1"), "1"),
        (unit("n=4", "4", "1"), "2"),
        (unit("n=0.25", "0.25", "1"), "0.5"),
        (unit("three-folds", "0.6", "2.4829"), "1"),
        (unit("three-folds-wide", "0.55", "2.6"), "1"),
        (unit("n=0.5", "0.5", "4"), "1"),
        (tip.clone(), "0.2"),
        (tip, "40"),
    ]
}

/// Contacts with n = 1/2.
pub(super) fn scale_free() -> Vec<Power> {
    let law = |name: &str, inputs: [&str; 4], flags: &[&'static str]| Power::new(name, inputs, flags);
    vec![
        law("half-unit", ["0.5", "1", "1", "1"], &[]),
        law("half-gelatine", ["0.5", "0.01", "3e3", "0.02"], &["si"]),
        law("half-1e100", ["0.5", "1e-90", "1e-100", "1e-250"], &["extreme-scale"]),
    ]
}

/// Contacts that jump.
pub(super) fn jumps() -> Vec<(Power, Jump)> {
    let laws = all().into_iter();
    let chosen = laws.flat_map(|law| {
        let kinds: &[Jump] = match law.name.as_str() {
            "jkr-unit" | "cone-unit" | "n=3" | "n=1.5" | "n=0.75" | "n=0.6" | "afm-tip" | "pdms-bead"
            | "gecko-spatula" | "tyre-asperity" => &[Jump::PullOff, Jump::Approach],
            "n=0.25" | "n=0.4" | "n=0.1" | "cusp-on-gelatine" => &[Jump::Barrier],
            _ => &[],
        };
        kinds.iter().map(move |kind| (law.clone(), *kind)).collect::<Vec<_>>()
    });
    chosen.collect()
}

/// A critical state asked for with these inputs is none.
pub(super) fn outside() -> Vec<Power> {
    let cases: [(&str, [&str; 4]); 8] = [
        ("n=0", ["0", "1", "1", "1"]),
        ("n=-1", ["-1", "1", "1", "1"]),
        ("n=0.5", ["0.5", "1", "1", "1"]),
        ("C=0", ["2", "0", "1", "1"]),
        ("C=-0.5", ["2", "-0.5", "1", "1"]),
        ("E*=0", ["2", "0.5", "0", "1"]),
        ("E*=-1e6", ["2", "0.5", "-1e6", "0.05"]),
        ("w=-0.05", ["2", "0.5", "1e6", "-0.05"]),
    ];
    cases.iter().map(|(name, inputs)| Power::new(name, *inputs, &[])).collect()
}
