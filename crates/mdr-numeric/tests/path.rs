//! Loading paths: the order of events, and the states at them.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::f64::consts::PI;
use std::sync::Arc;

use approx::assert_relative_eq;
use mdr_core::contact::{Control, Error, Material, Profile, Shape, Stability, Transform};
use mdr_core::number::Lift;
use mdr_numeric::branch::{EquilibriumBranches, FirstContact};
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::path::{ContactState, Event, EventKind, Path, Start};
use mdr_numeric::profiles::Heights;
use mdr_numeric::transform::Quadrature;

use EventKind::{CompleteContact, Detached, End, Jump, JumpIn, NotAdmissible, Touch, WayPoint};

const U: f64 = f64::EPSILON / 2.0;

fn follow(
    transform: &(impl Transform<f64> + Clone + 'static),
    material: &Material<f64>,
    control: &Control<f64>,
    start: Start<f64>,
    way: &[f64],
) -> Result<Vec<Event<f64>>, Error> {
    let branches = SearchedBranches::new(Contact::half_space(&Arc::new(transform.clone()), material, control)).unwrap();
    Path::follow(&branches, &start, way).map(|path| path.events)
}

fn kinds(events: &[Event<f64>]) -> Vec<EventKind> {
    events.iter().map(|event| event.kind).collect()
}

/// The radius, 0 if the surfaces are separated.
fn radius(state: &ContactState<f64>) -> f64 {
    state.contact().map_or(0.0, |rest| rest.contact_radius)
}

/// R = 1, A = 5e-4, λ = 0.1, w/E* = 1e-4.
fn figure_4() -> (Arc<Quadrature<f64, Heights<f64>>>, Material<f64>) {
    (
        Arc::new(Quadrature::of([Shape::WavyParaboloid { radius: 1.0, amplitude: 5e-4, wavelength: 0.1 }]).unwrap()),
        Material::new(1.0, 1e-4).unwrap(),
    )
}

#[test]
fn figure_4_of_the_paper() {
    let (profile, material) = figure_4();
    let events = follow(&profile, &material, &Control::Indentation, Start::Largest, &[0.0, -0.01]).unwrap();
    assert_eq!(kinds(&events), [EventKind::Start, Jump, Detached, End]);
    let [start, jump, breaks, _] = events.as_slice() else { panic!("four events") };
    assert_relative_eq!(radius(&start.after), 0.0926, max_relative = 1e-3);
    assert_relative_eq!(radius(&jump.before), 0.0645, max_relative = 1e-3);
    assert_relative_eq!(radius(&jump.after), 0.0474, max_relative = 1e-3);
    assert_relative_eq!(jump.value, -0.00185, max_relative = 2e-3);
    assert_relative_eq!(radius(&breaks.before), 0.0189, max_relative = 3e-3);
    assert_relative_eq!(breaks.value, -0.00249, max_relative = 2e-3);
    assert_eq!((jump.fold, breaks.fold), (Some(2), Some(0)));
    // Both jumps are at constant indentation.
    assert_eq!(jump.value, jump.before.contact().unwrap().indentation);
    assert_relative_eq!(jump.after.contact().unwrap().indentation, jump.value, max_relative = 64.0 * U);
}

#[test]
fn figure_4_turned_back_between_its_jumps() {
    // Increased again from beyond the first jump, the contact spreads at the maximum and not at the minimum:
    // hysteresis.
    let (profile, material) = figure_4();
    let way = [0.0, -0.0020, 0.0, -0.0020, -0.0010];
    let events = follow(&profile, &material, &Control::Indentation, Start::Largest, &way).unwrap();
    assert_eq!(kinds(&events), [EventKind::Start, Jump, WayPoint, Jump, WayPoint, Jump, WayPoint, Jump, End]);
    assert_eq!((events[1].fold, events[3].fold), (Some(2), Some(1)));
    assert!(events[3].value > events[1].value && radius(&events[3].after) > radius(&events[1].before));
    assert_eq!(events[0].after, events[4].after);
    // Reversed in the middle of a branch, the path is retraced.
    let events = follow(&profile, &material, &Control::Indentation, Start::Largest, &[0.0, -0.0015, 0.0]).unwrap();
    assert_eq!(kinds(&events), [EventKind::Start, WayPoint, End]);
    assert_eq!(events[0].after, events[2].after);
}

#[test]
fn a_cycle_of_jkr_under_every_control() {
    let (r, e, w) = (3.0, 7e5, 0.02);
    let (ball, material) = (Quadrature::of([Shape::Paraboloid { radius: r }]).unwrap(), Material::new(e, w).unwrap());
    let a_c = f64::cbrt(PI * w * r * r / (8.0 * e));
    for (control, pull_off, pull_off_radius) in
        [(Control::Indentation, -3.0 * a_c * a_c / r, a_c), (Control::Force, -1.5 * PI * w * r, a_c * f64::cbrt(9.0))]
    {
        let way = [4.0 * pull_off, -pull_off, 4.0 * pull_off, 0.0];
        let events = follow(&ball, &material, &control, Start::Detached, &way).unwrap();
        assert_eq!(kinds(&events), [EventKind::Start, JumpIn, WayPoint, Detached, WayPoint, JumpIn, End]);
        assert_eq!(events[1].value, 0.0);
        // d = 0: a³ = 2πwR²/E*; F = 0: a³ = 9πwR²/(2E*).
        let at_zero = if control == Control::Indentation { 16.0 } else { 36.0 };
        assert_relative_eq!(radius(&events[1].after), a_c * f64::cbrt(at_zero), max_relative = 64.0 * U);
        assert_relative_eq!(events[3].value, pull_off, max_relative = 64.0 * U);
        assert_relative_eq!(radius(&events[3].before), pull_off_radius, max_relative = 64.0 * U);
        assert_eq!((&events[3].after, events[3].fold), (&ContactState::Detached, Some(0)));
        assert_eq!(events[5].after, events[6].after);
    }
    // A machine lies between the two.
    let machine = Control::machine(2.0 * e * a_c).unwrap();
    let events = follow(&ball, &material, &machine, Start::Largest, &[0.0, -1.0]).unwrap();
    assert_eq!(kinds(&events), [EventKind::Start, Detached, End]);
    assert_relative_eq!(radius(&events[1].before) / a_c, 1.72526627, max_relative = 1e-8);
}

#[test]
fn a_multistable_machine() {
    // n = 0.6, C = 2.4829, E* = w = k = 1: folds at a ≈ 0.01271 (minimum), 0.06940 (maximum), 459.2 (minimum).
    let (profile, material) =
        (Arc::new(Quadrature::of([Shape::Power { n: 0.6, c: 2.4829 }]).unwrap()), Material::new(1.0, 1.0).unwrap());
    let control = Control::machine(1.0).unwrap();
    let branches = SearchedBranches::new(Contact::half_space(&profile, &material, &control)).unwrap();
    let values: Vec<f64> =
        branches.folds().iter().map(|fold| control.controlled(&fold.indentation, &fold.force)).collect();
    let between = 0.5 * (values[0] + values[1]);
    let go = |start, way: &[f64]| Path::follow(&branches, &start, way).unwrap().events;
    let (small, large) = (go(Start::Smallest, &[between]), go(Start::Largest, &[between]));
    assert!(radius(&small[0].after) < 0.0694 && radius(&large[0].after) > 459.2);
    assert_eq!(go(Start::Nearest(0.1), &[between]), small);
    assert_eq!(go(Start::Nearest(100.0), &[between]), large);
    // Pressed past the maximum the small contact jumps past the third fold; from there it can only break.
    let events = go(Start::Smallest, &[between, 2.0 * values[1].abs(), 2.0 * values[2]]);
    assert_eq!(kinds(&events), [EventKind::Start, Jump, WayPoint, Detached, End]);
    assert_eq!((events[1].fold, events[3].fold), (Some(1), Some(2)));
    assert!(radius(&events[1].after) > 459.2);
}

#[test]
fn below_one_half_contact_begins_smoothly_and_ends_everywhere() {
    let (profile, material) =
        (Arc::new(Quadrature::of([Shape::Power { n: 0.25, c: 1.0 }]).unwrap()), Material::new(1.0, 1.0).unwrap());
    for control in [Control::Indentation, Control::Force, Control::machine(1.0).unwrap()] {
        let branches = SearchedBranches::new(Contact::half_space(&profile, &material, &control)).unwrap();
        assert_eq!(branches.onset().unwrap(), FirstContact::Smooth);
        let fold = &branches.folds()[0];
        let top = control.controlled(&fold.indentation, &fold.force);
        let way = [-top, 0.5 * top, -top, 0.0, 0.5 * top, 0.0, top, 2.0 * top, 0.0];
        let events = Path::follow(&branches, &Start::Detached, &way).unwrap();
        assert!(!events.is_finished());
        let expected = [
            [EventKind::Start, Touch, WayPoint, Detached].as_slice(),
            &[WayPoint, WayPoint, Touch, WayPoint, Detached, WayPoint, Touch, WayPoint, CompleteContact],
        ];
        assert_eq!(kinds(&events.events), expected.concat());
        let at_top = &events.events[11];
        assert_eq!(at_top.after.contact().unwrap().stability, Stability::Neutral);
        assert_eq!(
            (events.events.last().unwrap().value, &events.events.last().unwrap().after),
            (top, &ContactState::Complete)
        );
        // Halfway the same state from either side.
        assert_eq!(events.events[2].after, events.events[7].after);
    }
}

#[test]
fn a_way_point_at_a_fold_is_a_place_to_rest() {
    let (profile, material) = figure_4();
    let control = Control::Indentation;
    let branches = SearchedBranches::new(Contact::half_space(&profile, &material, &control)).unwrap();
    let fold = &branches.folds()[2];
    let d = fold.indentation;
    let events = Path::follow(&branches, &Start::Largest, &[0.0, d, 0.0, d, 1.000001 * d]).unwrap().events;
    assert_eq!(kinds(&events), [EventKind::Start, WayPoint, WayPoint, WayPoint, Jump, End]);
    let resting = events[1].after.contact().unwrap();
    assert_eq!((resting.contact_radius, resting.stability), (fold.contact_radius, Stability::Neutral));
    assert_eq!(events[0].after, events[2].after);
    // A path may begin at a fold; the largest stable state of figure 4 there is the fold itself.
    let events = Path::follow(&branches, &Start::Largest, &[d, 2.0 * d]).unwrap().events;
    assert_eq!(kinds(&events), [EventKind::Start, Jump, Detached, End]);
    assert_eq!(radius(&events[0].after), fold.contact_radius);
}

#[test]
fn the_flat_punch_jumps_onto_its_whole_face() {
    let (b, e, w) = (0.3, 2e6, 0.05);
    let (punch, material) = (Quadrature::of([Shape::FlatPunch { radius: b }]).unwrap(), Material::new(e, w).unwrap());
    let control = Control::Indentation;
    let events = follow(&punch, &material, &control, Start::Detached, &[-1e-3, 1e-3, -1e-3]).unwrap();
    assert_eq!(kinds(&events), [EventKind::Start, JumpIn, WayPoint, Detached, End]);
    assert_eq!((radius(&events[1].after), radius(&events[3].before)), (b, b));
    assert_eq!(events[1].after.contact().unwrap().force, 0.0);
    assert_relative_eq!(events[2].after.contact().unwrap().force, 2.0 * e * b * 1e-3, max_relative = 8.0 * U);
    assert_relative_eq!(events[3].value, -f64::sqrt(2.0 * PI * b * w / e), max_relative = 8.0 * U);
}

/// The displaced paraboloid (r−b)²/2R minus its height at the axis: it first touches on a ring.
#[derive(Clone)]
struct Ring;

impl Profile<f64> for Ring {
    fn height<S: Lift<f64>>(&self, r: &S) -> S {
        r.square().over(2) - r.clone().over(10)
    }
    fn tip_exponent(&self) -> Option<f64> {
        Some(1.0)
    }
}

#[test]
fn a_dimple_is_not_touched_at_its_tip() {
    let (ring, material) = (Quadrature::new(Ring), Material::new(1.0, 1e-4).unwrap());
    let control = Control::Indentation;
    // (r − b)²/2R − b²/2R with b = 0.1 and R = 1 is lowest at r = b.
    let events = follow(&ring, &material, &control, Start::Detached, &[-0.1, 0.1]).unwrap();
    assert_eq!(kinds(&events), [EventKind::Start, NotAdmissible]);
    assert_relative_eq!(events[1].value, -0.005, max_relative = 1e-12);
    assert_relative_eq!(events[1].ring.as_ref().unwrap().radius, 0.1, max_relative = 1e-7);
    let events = follow(&ring, &material, &Control::Force, Start::Detached, &[-0.1, 0.1]).unwrap();
    assert_eq!((kinds(&events), events[1].value), (vec![EventKind::Start, NotAdmissible], 0.0));
    // A path that begins in contact can be followed until the contact breaks, and not back.
    let events = follow(&ring, &material, &control, Start::Largest, &[0.1, -0.1, 0.1]).unwrap();
    assert_eq!(kinds(&events), [EventKind::Start, Detached, WayPoint, NotAdmissible]);
    // Separated surfaces can move until they touch; at zero they would interpenetrate.
    let events = follow(&ring, &material, &control, Start::Detached, &[-0.1, -0.2]).unwrap();
    assert_eq!(kinds(&events), [EventKind::Start, End]);
    let events = follow(&ring, &material, &control, Start::Detached, &[-0.1, -0.2, -0.0051]).unwrap();
    assert_eq!(kinds(&events), [EventKind::Start, WayPoint, End]);
    let overlapping = follow(&ring, &material, &control, Start::Detached, &[0.0]);
    assert!(matches!(overlapping, Err(Error::NoEquilibrium { .. })), "{overlapping:?}");
}

#[test]
fn a_path_that_cannot_begin_says_so() {
    let (profile, material) = figure_4();
    let control = Control::Indentation;
    let begin = |start, value: f64| follow(&profile, &material, &control, start, &[value]);
    let refused = |start, value| matches!(begin(start, value), Err(Error::NoEquilibrium { .. }));
    assert!(refused(Start::Largest, -0.01) && refused(Start::Smallest, -0.01) && refused(Start::Nearest(0.1), -0.01));
    assert!(refused(Start::Detached, 0.001) && !refused(Start::Detached, 0.0));
    assert!(matches!(begin(Start::Nearest(-1.0), 0.0), Err(Error::Domain { .. })));
    assert!(matches!(follow(&profile, &material, &control, Start::Largest, &[]), Err(Error::Domain { .. })));
    // Without a fold: n = 1/2 below the threshold (1.19) has only unstable equilibria.
    let (root, unit) = (Quadrature::of([Shape::Power { n: 0.5, c: 1.0 }]).unwrap(), Material::new(1.0, 1.0).unwrap());
    let result = follow(&root, &unit, &control, Start::Largest, &[-0.7]);
    assert!(matches!(result, Err(Error::NoEquilibrium { .. })));
    // Above it, only stable ones.
    let (root, way) = (Quadrature::of([Shape::Power { n: 0.5, c: 3.0 }]).unwrap(), [1e-30, 1e30, -1.0]);
    let events = follow(&root, &unit, &control, Start::Largest, &way).unwrap();
    assert_eq!(kinds(&events), [EventKind::Start, WayPoint, Detached, End]);
}

#[test]
fn the_end_of_a_profile_ends_the_path() {
    let (ball, material) =
        (Quadrature::of([Shape::Sphere { radius: 1.0 }]).unwrap(), Material::new(1.0, 1e-3).unwrap());
    let events = follow(&ball, &material, &Control::Indentation, Start::Largest, &[0.0, 1.0, 1e3, 0.0]).unwrap();
    // g is infinite at the edge: there is an equilibrium at every depth, but its radius may not be a double below 1.
    assert_eq!(kinds(&events), [EventKind::Start, WayPoint, EventKind::Undecided]);
    // A table of the paraboloid r²/2 ends at r = 4, with g = 16 and the mean 16/3.
    let rows = (0..=4).map(|i| (f64::from(i), f64::from(i * i) / 2.0));
    let table = mdr_numeric::table::MeasuredProfile::new(rows.collect()).unwrap();
    let unit = Material::new(1.0, 1.0).unwrap();
    for control in [Control::Indentation, Control::Force, Control::Machine { stiffness: 2.0 }] {
        let events = follow(&table, &unit, &control, Start::Largest, &[0.0, 1e3, -5.0]).unwrap();
        assert_eq!(kinds(&events), [EventKind::Start, EventKind::EndOfProfile]);
        let end = events.last().unwrap();
        let rest = end.after.contact().unwrap();
        let elongation = (8.0 * std::f64::consts::PI).sqrt();
        let (d, force) = (16.0 - elongation, 8.0 * (16.0 - 16.0 / 3.0 - elongation));
        assert_eq!(rest.contact_radius, 4.0);
        assert!((rest.indentation / d - 1.0).abs() < 1e-14 && (rest.force / force - 1.0).abs() < 1e-13, "{rest:?}");
        assert_eq!(end.value, control.controlled(&rest.indentation, &rest.force));
        assert_eq!(end.before, end.after);
    }
}

#[test]
fn units_do_not_matter() {
    // Lengths in units of 2^±200 and forces in units of 2^±150, about 10^±60: every event has the same significand.
    for (length, force) in [(2f64.powi(-200), 2f64.powi(150)), (2f64.powi(200), 2f64.powi(-150))] {
        let (plain, unit) = figure_4();
        let scaled = Quadrature::of([Shape::WavyParaboloid {
            radius: length,
            amplitude: 5e-4 * length,
            wavelength: 0.1 * length,
        }])
        .unwrap();
        let material = Material::new(force / length / length, 1e-4 * force / length).unwrap();
        let way = [-0.01, 0.01, -0.01];
        let far: Vec<f64> = way.iter().map(|d| d * length).collect();
        let here = follow(&plain, &unit, &Control::Indentation, Start::Detached, &way).unwrap();
        let there = follow(&scaled, &material, &Control::Indentation, Start::Detached, &far).unwrap();
        assert_eq!(kinds(&here), kinds(&there));
        for (one, other) in here.iter().zip(&there) {
            let (Some(one), Some(other)) = (one.after.contact(), other.after.contact()) else { continue };
            assert_relative_eq!(other.contact_radius / length, one.contact_radius, max_relative = 256.0 * U);
            assert_relative_eq!(other.force / force, one.force, max_relative = 1024.0 * U);
        }
    }
}

#[cfg(feature = "mp")]
mod arbitrary_precision {
    use std::sync::atomic::{AtomicU64, Ordering};

    use mdr_core::number::Real;
    use rug::Float;

    use super::*;

    /// A paraboloid that records the largest |ln x| at which it is evaluated.
    struct Asked {
        profile: Quadrature<Float, Heights<Float>>,
        farthest: AtomicU64,
    }

    impl Asked {
        fn ask(&self, x: &Float) -> &Quadrature<Float, Heights<Float>> {
            self.farthest.fetch_max(x.ln().abs().approx() as u64, Ordering::Relaxed);
            &self.profile
        }
    }

    impl Transform<Float> for Asked {
        fn g(&self, x: &Float) -> Result<Float, Error> {
            self.ask(x).g(x)
        }

        fn slope(&self, x: &Float) -> Result<Float, Error> {
            self.ask(x).slope(x)
        }

        fn integral(&self, x: &Float) -> Result<Float, Error> {
            self.ask(x).integral(x)
        }

        fn outer_radius(&self) -> Option<Float> {
            None
        }

        fn kinks(&self) -> Vec<Float> {
            Vec::new()
        }
    }

    /// Without an equilibrium a search ends with the search for folds, far before the exponent range of MPFR.
    #[test]
    fn walks_end_where_folds_are_searched() {
        let one = Float::with_val(64, 1);
        let profile = Quadrature::of([Shape::Paraboloid { radius: one.clone() }]).unwrap();
        let asked = Arc::new(Asked { profile, farthest: AtomicU64::new(0) });
        let material = Material::new(one.clone(), one.clone() / 1000).unwrap();
        let branches = SearchedBranches::new(Contact::half_space(&asked, &material, &Control::Indentation)).unwrap();
        assert_eq!(branches.equilibria(&-one).unwrap(), []);
        let farthest = asked.farthest.load(Ordering::Relaxed);
        assert!(1_000_000 < farthest && farthest < 1_050_000, "{farthest}");
    }
}
