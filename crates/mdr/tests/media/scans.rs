//! Folds of random contacts on media, against dense scans of closed forms.

use mdr::answer::Fold;

use crate::{GRIPS, LOAD, PERIODIC, scene, solve};

/// d and F along the contact radius.
type Curve = Box<dyn Fn(f64) -> [f64; 2]>;

/// Random numbers within (0, 1).
fn random() -> impl FnMut() -> f64 {
    let mut seed = 0x2545_f491_4f6c_dd1d_u64;
    move || {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        (seed >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// A random contact of one of the media: its tables, and closed forms of (d, F) at a contact radius.
fn random_contact(kind: &str, uniform: &mut dyn FnMut() -> f64) -> Option<(String, String, Curve)> {
    let (pi, w) = (std::f64::consts::PI, 0.01);
    let n = 0.3 + 3.0 * uniform();
    let power = format!("kind = \"power\"\nn = \"{n}\"\nc = 1");
    Some(match kind {
        "graded" => {
            let k = 1.6 * uniform() - 0.8;
            if (n - (1.0 - k) / 2.0).abs() < 0.1 {
                return None;
            }
            let kappa = mdr::contact::graded_kappa(&n, &k);
            let state = move |a: f64| {
                let d = kappa * a.powf(n) - (2.0 * pi * w * a.powf(1.0 - k)).sqrt();
                let mean = (1.0 + k) / (n + 1.0 + k) * kappa * a.powf(n);
                [d, 2.0 * a.powf(1.0 + k) / (1.0 + k) * (d - mean)]
            };
            (format!("kind = \"graded\"\nexponent = \"{k}\"\ncoefficient = 1"), power, Box::new(state))
        }
        "winkler" => {
            let stiff = 10f64.powf(2.0 * uniform() - 1.0);
            let state = move |a: f64| {
                let d = a.powf(n) - (2.0 * w / stiff).sqrt();
                [d, pi * stiff * a * a * (d - 2.0 / (n + 2.0) * a.powf(n))]
            };
            (format!("kind = \"winkler\"\nmodulus = \"{stiff}\""), power, Box::new(state))
        }
        "plane" => {
            // N = (√π/2) n Γ((n + 1)/2)/Γ(1 + n/2) xⁿ, by κ(n, 0) = √π Γ(1 + n/2)/Γ((n + 1)/2).
            let factor = pi * n / 2.0 / mdr::contact::graded_kappa(&n, &0.0);
            let state = move |b: f64| [0.0, factor * b.powf(n) - (2.0 * pi * w * b).sqrt()];
            if (n - 0.5).abs() < 0.1 {
                return None;
            }
            ("kind = \"plane\"".to_owned(), power, Box::new(state))
        }
        _ => {
            let amplitude = 10f64.powf(uniform() - 0.5);
            // The work of adhesion of a scene with a wave is that of α = 0.3 at an amplitude of one.
            let alpha = 0.3 / amplitude;
            let state = move |a: f64| {
                let (s, t) = ((pi * a).sin().powi(2), (pi * a).tan());
                let pressure = s - alpha * t.sqrt();
                [amplitude * (s - pressure * s.ln()), pi * amplitude * pressure]
            };
            (PERIODIC.to_owned(), format!("kind = \"wave\"\namplitude = \"{amplitude}\""), Box::new(state))
        }
    })
}

/// A machine of the stiffness 1.
const MACHINE: &str = "kind = \"machine\"\nstiffness = 1";

/// Folds of d(a), of F(a) and of d + F of random contacts, against a dense scan of closed forms: as many, of the same kinds, at the same places.
fn scan(kind: &str, contacts: usize) {
    let mut uniform = random();
    for _ in 0..contacts {
        let Some((medium, profile, state)) = random_contact(kind, &mut uniform) else { continue };
        for (control, share) in [(GRIPS, [1.0, 0.0]), (LOAD, [0.0, 1.0]), (MACHINE, [1.0, 1.0])] {
            // Without a reference a line contact has no depth.
            if kind == "plane" && control != LOAD {
                continue;
            }
            let held = |[d, force]: [f64; 2]| share[0] * d + share[1] * force;
            let text = scene(&medium, &profile, control, "want = [\"folds\"]\narithmetic = \"f64\"");
            let answer = solve(&text);
            let found = &answer.folds().expect("wanted").items;
            // In equal steps of ln a, or of ln tan(πa/λ) over half of a period.
            let radius = |i: i32| match kind {
                "periodic" => (0.01 * f64::from(i)).exp().atan() / std::f64::consts::PI,
                _ => (0.01 * f64::from(i)).exp(),
            };
            let value = |a: f64| held(state(a));
            // Folds that rise above the rounding of the closed form: elsewhere a scan sees what is none, or not what is one.
            let is_seen = |a: f64| {
                let [below, here, above] =
                    [a / 1.1, a, if kind == "periodic" { a + 0.05 * (0.5 - a) } else { 1.1 * a }].map(value);
                (below - here).abs().min((above - here).abs()) > 1e-8 * here.abs()
            };
            let turns = (-1800..1200).filter_map(|i| {
                let [one, two, three] = [radius(i - 1), radius(i), radius(i + 1)].map(value);
                let turn = if two < one && two < three {
                    Some("minimum")
                } else {
                    (two > one && two > three).then_some("maximum")
                };
                turn.filter(|_| is_seen(radius(i))).map(|turn| (turn, radius(i)))
            });
            let turns: Vec<_> = turns.collect();
            let inside = |fold: &&Fold| {
                fold.contact_radius.to_f64().is_some_and(|a| radius(-1790) < a && a < radius(1190) && is_seen(a))
            };
            let found: Vec<&Fold> = found.iter().filter(inside).collect();
            assert_eq!(found.len(), turns.len(), "{text}\n{turns:?}");
            for (fold, (turn, at)) in found.iter().zip(&turns) {
                let a = fold.contact_radius.to_f64().expect("a number");
                assert!(fold.kind.name() == *turn && (a / at - 1.0).abs() < 0.011, "{text}: {a} {at} {turn}");
                let extremum = held([&fold.indentation, &fold.force].map(|value| value.to_f64().unwrap_or(0.0)));
                let seen = value(a);
                assert!((extremum - seen).abs() <= 1e-9 * (seen.abs() + 1e-6), "{text}: {extremum} {seen}");
            }
        }
    }
}

/// Two hundred contacts a medium.
#[test]
fn folds_are_the_extrema_of_dense_scans() {
    ["graded", "winkler", "plane", "periodic"].into_iter().for_each(|kind| scan(kind, 200));
}
