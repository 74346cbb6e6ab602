//! Admissibility against a gap computed on a fine grid, and its consequences for paths.

use std::sync::Arc;

use mdr_core::contact::{Control, Error, Material, Quantity, Result, Transform};
use mdr_numeric::admissible::{Admissibility, Basis, GapVerdict};
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::path::{Dissipation, EventKind, Path, PathEnergy, Start};
use proptest::prelude::*;

/// f = r²/2 + Σ cᵢ (r − bᵢ)²₊/2: a paraboloid whose curvature jumps, with
/// g = x² + Σ cᵢ x [√(x² − bᵢ²) − bᵢ arccos(bᵢ/x)].
#[derive(Clone, Debug)]
struct Bent(Vec<(f64, f64)>);

impl Bent {
    fn sum(&self, x: f64, term: impl Fn(f64, f64) -> f64) -> f64 {
        self.0.iter().filter(|(b, _)| *b < x).map(|(b, c)| c * term(*b, ((x - b) * (x + b)).sqrt())).sum()
    }

    fn height(&self, r: f64) -> f64 {
        r * r / 2.0 + self.0.iter().map(|(b, c)| c * (r - b).max(0.0).powi(2) / 2.0).sum::<f64>()
    }
}

impl Transform<f64> for Bent {
    fn g(&self, x: &f64) -> Result<f64> {
        Error::require_positive(Quantity::Radius, *x)?;
        Ok(x * x + self.sum(*x, |b, leg| x * (leg - b * (leg / b).atan())))
    }
    fn slope(&self, x: &f64) -> Result<f64> {
        Ok(2.0 * x + self.sum(*x, |b, leg| 2.0 * leg - b * (leg / b).atan()))
    }
    fn integral(&self, x: &f64) -> Result<f64> {
        // ∫ x√(x²−b²) = leg³/3, ∫ b x arccos(b/x) = b (x² arccos(b/x) − b leg)/2.
        let term = |b: f64, leg: f64| leg.powi(3) / 3.0 - b * (x * x * (leg / b).atan() - b * leg) / 2.0;
        Ok(x.powi(3) / 3.0 + self.sum(*x, term))
    }
    fn kinks(&self) -> Vec<f64> {
        self.0.iter().map(|(b, _)| *b).collect()
    }
}

/// A profile that falls and rises again: of curvature 1, −c between some radii, and finally 1 or more.
fn bent() -> impl Strategy<Value = Bent> {
    let wave = (0.05f64..0.6, 0.05f64..0.6, 0.05f64..0.6, 0.5f64..8.0);
    proptest::collection::vec(wave, 1..4).prop_map(|waves| {
        let (mut bends, mut r) = (Vec::new(), 0.0);
        for (rise, fall, lift, c) in waves {
            bends.push((r + rise, -c));
            bends.push((r + rise + fall, 2.0 * c));
            bends.push((r + rise + fall + lift, -c));
            r += rise + fall + lift;
        }
        Bent(bends)
    })
}

/// The gap at r: f − d + u with u by the midpoint rule in θ, x = a sin θ, whose integrand is smooth there.
fn gap(profile: &Bent, a: f64, d: f64, r: f64) -> f64 {
    const POINTS: usize = 400;
    let most = (a / r).asin();
    let at = |i: usize| d - profile.g(&(r * (most * (i as f64 + 0.5) / POINTS as f64).sin())).expect("r > 0");
    let u = (0..POINTS).map(at).sum::<f64>() * most / POINTS as f64 * std::f64::consts::FRAC_2_PI;
    profile.height(r) - d + u
}

/// The least gap on a grid.
fn narrowest(profile: &Bent, a: f64, d: f64) -> f64 {
    let last = profile.0.last().map_or(a, |bend| bend.0).max(a) * 1.5;
    // Beyond the last bend g turns upwards; where it has risen above d, a gap that is open stays so.
    let risen = |x: &f64| profile.slope(x).is_ok_and(|slope| slope > 0.0) && profile.g(x).is_ok_and(|g| g > d);
    let until = (0..40).map(|step| last * 1.25f64.powi(step)).find(risen).unwrap_or(last);
    (1..=600).map(|i| gap(profile, a, d, a + (until - a) * f64::from(i) / 600.0)).fold(f64::INFINITY, f64::min)
}

fn branches(profile: &Bent, material: &Material<f64>, control: &Control<f64>) -> SearchedBranches<f64> {
    SearchedBranches::new(Contact::half_space(&Arc::new(profile.clone()), material, control))
        .expect("a search for folds")
}

/// Between an extremum of g and a kink beside it x g' vanishes but for rounding. Separated surfaces touch beyond them.
#[test]
fn an_extremum_of_g_beside_a_kink() {
    let smooth = vec![(0.1, -3.0), (0.5, 3.0)];
    let valley = Bent(smooth.clone());
    // g has its minimum beyond the last bend, and f beyond that of g.
    let (mut falling, mut rising) = (0.51, 1.2);
    for _ in 0..60 {
        let middle = (falling + rising) / 2.0;
        *if valley.slope(&middle).unwrap() < 0.0 { &mut falling } else { &mut rising } = middle;
    }
    let (material, control) = (Material::new(1.0, 1e-6).unwrap(), Control::Indentation);
    for distance in (3..50).flat_map(|bits| [2f64.powi(-bits), -2f64.powi(-bits)]) {
        let kink = falling * (1.0 + distance);
        let profile = Bent([smooth.clone(), vec![(kink, 0.5)]].concat());
        // From f' = 0, with f'' = 3/2 there.
        let slope = kink + smooth.iter().map(|(b, c)| c * (kink - b)).sum::<f64>();
        let lowest = profile.height(kink - slope / 1.5);
        let branches = branches(&profile, &material, &control);
        let path = Path::follow(&branches, &Start::Detached, &[-50.0, 1e-4]);
        let touch = path.unwrap_or_else(|error| panic!("{distance}: {error}")).events.swap_remove(1);
        assert!(touch.kind == EventKind::NotAdmissible && (touch.value - lowest).abs() < 1e-9, "{distance}: {touch:?}");
    }
}

/// Far above the error of the midpoint rule.
const CLEAR: f64 = 1e-4;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases * 48 / 256))]

    /// Any state, in equilibrium or not, against the gap on a grid.
    #[test]
    fn a_state_is_admissible_where_no_gap_is_negative(profile in bent(), a in 0.02f64..2.0, tension in 1e-3f64..1.0) {
        let d = profile.g(&a).unwrap() - tension * a;
        let least = narrowest(&profile, a, d);
        let profile = Arc::new(profile);
        let admissibility = Admissibility::new(profile.clone(), [1e-6, 10.0]);
        prop_assert_eq!(admissibility.basis(), Basis::Searched);
        match admissibility.of(a, d) {
            GapVerdict::Admissible => prop_assert!(least > -CLEAR, "{}", least),
            GapVerdict::Interpenetrating { radius, gap: found } => {
                prop_assert!(least < CLEAR && found < 0.0, "{}", least);
                prop_assert!((gap(&profile, a, d, radius) - found).abs() < CLEAR, "{}", found);
            }
            GapVerdict::Undecided(why) => prop_assert!(least.abs() < CLEAR, "{}: {}", why, least),
        }
    }

    /// No event gains energy, every state is admissible, and where the path ends at the limit of admissibility a gap
    /// closes that was open before and is negative beyond.
    #[test]
    fn a_path_keeps_to_admissible_states(
        profile in bent(),
        work in -6.0f64..-2.0,
        held in 0usize..3,
        ways in proptest::collection::vec(-0.5f64..1.0, 2..5),
        smallest in any::<bool>(),
    ) {
        let material = Material::new(1.0, 10f64.powf(work)).unwrap();
        let control = [Control::Indentation, Control::Force, Control::Machine { stiffness: 0.3 }][held].clone();
        let branches = branches(&profile, &material, &control);
        let start = if smallest { Start::Smallest } else { Start::Largest };
        let Ok(path) = Path::follow(&branches, &start, &ways) else { return Ok(()) };
        let energies = PathEnergy::new(&path, &branches).unwrap();
        for (event, entry) in path.events.iter().zip(&energies.entries) {
            if let Dissipation::Finite(dissipated) = &entry.dissipated {
                prop_assert!(dissipated.value >= -dissipated.error - 1e-14, "{:?}: {:?}", event, dissipated);
            }
            let Some(rest) = event.after.contact().filter(|rest| rest.contact_radius > 0.0) else { continue };
            let (a, d) = (rest.contact_radius, rest.indentation);
            let least = narrowest(&profile, a, d);
            let first = event.kind == EventKind::Start;
            let ends_at_start = path.events.get(1).is_some_and(|next| next.ring.as_ref().is_some_and(|r| r.gap < 0.0));
            prop_assert!(least > -CLEAR || first && path.events.len() == 2 || ends_at_start, "{:?}: {}", event, least);
            let Some(ring) = event.ring.as_ref().filter(|ring| ring.gap == 0.0) else { continue };
            let there = |a: f64| {
                let d = branches.curve().indentation(&a).unwrap();
                gap(&profile, a, d, ring.radius)
            };
            prop_assert!(there(a).abs() < CLEAR && there(a * 0.999) > there(a * 1.001), "{:?}", event);
        }
    }

    /// Separated surfaces first touch at the least height.
    #[test]
    fn surfaces_first_touch_at_the_lowest_point(profile in bent(), deeper in 0.0f64..2.0) {
        let mut profile = profile;
        profile.0[0].1 -= deeper;
        profile.0[1].1 += deeper;
        // The slope may remain negative, by at most the curvatures that were subtracted.
        let end = profile.0.last().unwrap().0 + 20.0;
        let height = |i: u32| profile.height(end * f64::from(i) / 20_000.0);
        let lowest = (0..=20_000).map(height).fold(f64::INFINITY, f64::min);
        let (material, control) = (Material::new(1.0, 1e-6).unwrap(), Control::Indentation);
        let branches = branches(&profile, &material, &control);
        let events = Path::follow(&branches, &Start::Detached, &[-50.0, 1e-4]).unwrap().events;
        let touch = &events[1];
        if lowest < -1e-6 {
            prop_assert_eq!(touch.kind, EventKind::NotAdmissible);
            // The grid misses the lowest point by half a step, and its height by the curvature times the square of
            // that.
            prop_assert!(touch.value < lowest + 1e-12 && touch.value > lowest - 1e-5, "{} {}", touch.value, lowest);
        } else {
            prop_assert!(touch.value.abs() < 1e-5, "{:?}", touch);
        }
    }
}
