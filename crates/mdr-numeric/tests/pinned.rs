//! Paths between two works of adhesion: known values, the rule step by step, and the balance of the energy.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::f64::consts::PI;
use std::sync::Arc;

use mdr_core::contact::{Control, Edge, Error, Shape, Transform};
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::medium::{Adhesion, Medium};
use mdr_numeric::path::{
    Balance, ContactState, Dissipation, EdgeEnergies, EdgeLoss, Edges, Event, EventKind, Path, Start,
};
use mdr_numeric::transform::Quadrature;

/// A contact with E* = 1 and its branches at both works of adhesion.
struct Case {
    contact: Contact<f64>,
    branches: [SearchedBranches<f64>; 2],
}

impl Case {
    fn new(shapes: Vec<Shape<f64>>, works: [f64; 2], control: Control<f64>) -> Self {
        let transform: Arc<dyn Transform<f64>> = Arc::new(Quadrature::of(shapes).unwrap());
        let adhesion = Adhesion::hysteretic(works[0], works[1]).unwrap();
        let contact = Contact::new(transform, Medium::half_space(1.0).unwrap(), adhesion, control);
        let branches = [Edge::Advancing, Edge::Receding].map(|edge| SearchedBranches::new(contact.at(edge)).unwrap());
        Case { contact, branches }
    }

    fn ball(works: [f64; 2], control: Control<f64>) -> Self {
        Case::new(vec![Shape::Paraboloid { radius: 1.0 }], works, control)
    }

    fn wavy(works: [f64; 2], control: Control<f64>) -> Self {
        Case::new(vec![Shape::WavyParaboloid { radius: 1.0, amplitude: 5e-4, wavelength: 0.1 }], works, control)
    }

    fn follow(&self, start: &Start<f64>, way: &[f64]) -> Path<f64> {
        let [advancing, receding] = &self.branches;
        Path::follow_edges(&Edges::new(&self.contact, advancing, receding), start, way, None).unwrap()
    }

    /// The controlled quantity at which an advancing edge has a radius.
    fn reversal(&self, radius: f64) -> f64 {
        self.contact.at(Edge::Advancing).controlled(&radius).unwrap()
    }

    fn losses(&self, path: &Path<f64>) -> Vec<EdgeLoss<f64>> {
        let [advancing, receding] = &self.branches;
        EdgeEnergies::new(advancing, receding).losses(path).into_iter().map(Result::unwrap).collect()
    }

    fn balance(&self, path: &Path<f64>) -> Balance<f64> {
        let [advancing, receding] = &self.branches;
        let balance = EdgeEnergies::new(advancing, receding).balance(path).unwrap().unwrap();
        assert!(balance.residual.abs() <= balance.bound, "{balance:?}");
        let terms = balance.dissipated + balance.hysteresis + balance.stored.abs();
        assert!(balance.bound <= 1e-9 * terms, "a bound that allows anything tests nothing: {balance:?}");
        balance
    }

    /// ∫F dq of the work on the way between events of one state, by the states at many way points: the controlled quantity of a
    /// stretch in t with 3t² − 2t³, so that a root at a fold is smooth, and Simpson's rule.
    fn sampled_work(&self, start: &Start<f64>, way: &[f64], count: usize) -> f64 {
        let events = self.follow(start, way).events;
        let mut dense = vec![events[0].value];
        for pair in events.windows(2).filter(|pair| pair[0].value != pair[1].value) {
            let [from, to] = [pair[0].value, pair[1].value];
            dense.extend((1..count).map(|i| {
                let t = i as f64 / count as f64;
                from + (to - from) * t * t * (3.0 - 2.0 * t)
            }));
            dense.push(to);
        }
        let path = self.follow(start, &dense);
        let arrivals =
            |event: &&Event<f64>| matches!(event.kind, EventKind::Start | EventKind::WayPoint | EventKind::End);
        let force = |event: &Event<f64>| event.after.contact().map_or(0.0, |state| state.force);
        let forces: Vec<f64> = path.events.iter().filter(arrivals).map(force).collect();
        assert_eq!(forces.len(), dense.len());
        let mut work = 0.0;
        for (stretch, values) in forces.windows(count + 1).zip(dense.windows(count + 1)).step_by(count) {
            let span = values[count] - values[0];
            for (i, force) in stretch.iter().enumerate() {
                let t = i as f64 / count as f64;
                let weight = if i % 2 == 1 { 4.0 } else { 2.0 };
                work += weight / (3.0 * count as f64) * force * span * 6.0 * t * (1.0 - t);
            }
        }
        work
    }
}

fn kinds(path: &Path<f64>) -> Vec<&'static str> {
    path.events.iter().map(|event| event.kind.name()).collect()
}

fn of_kind(path: &Path<f64>, kind: EventKind) -> &Event<f64> {
    path.events.iter().find(|event| event.kind == kind).unwrap()
}

/// Values of a sphere with E* = R = 1, w₁ = 1/100, w₂ = 4/100, from closed forms.
#[test]
fn sphere_has_known_values() {
    let case = Case::ball([0.01, 0.04], Control::Indentation);
    let path = case.follow(&Start::Detached, &[-0.3, 0.0, case.reversal(0.5), -0.3]);
    assert_eq!(kinds(&path), ["start", "jump-in", "way-point", "way-point", "pinned", "depinned", "detached", "end"]);
    let jump_in = of_kind(&path, EventKind::JumpIn);
    assert_eq!((jump_in.value, jump_in.edge), (0.0, Some(Edge::Advancing)));
    let a = jump_in.after.contact().unwrap().contact_radius;
    assert!((a / 0.397_551_402_071_898_54 - 1.0).abs() < 1e-15, "{a}");
    let depinned = of_kind(&path, EventKind::Depinned);
    let state = depinned.before.contact().unwrap();
    // a is 1/2 to the rounding of d = a² − Δl over d' a/d < 4, and 2E*a(d − a²/3) loses no more.
    assert!((state.contact_radius / 0.5 - 1.0).abs() < 1e-15);
    assert!((state.indentation / -0.104_490_770_181_103_21 - 1.0).abs() < 4e-15, "{state:?}");
    assert!((state.force / -0.187_824_103_514_436_54 - 1.0).abs() < 4e-15, "{state:?}");
    let off = of_kind(&path, EventKind::Detached);
    assert_eq!((off.fold, off.edge), (Some(0), Some(Edge::Receding)));
    // Pressed to less than the radius of the fold of w₂, it breaks as soon as it is set free.
    let path = case.follow(&Start::Nearest(0.2), &[case.reversal(0.2), -0.3]);
    assert_eq!(kinds(&path), ["start", "depinned", "detached", "end"]);
    let off = of_kind(&path, EventKind::Detached);
    assert_eq!((off.fold, off.edge), (None, Some(Edge::Receding)));
    let force = off.before.contact().unwrap().force;
    assert!((force / -0.079_013_192_795_700_2 - 1.0).abs() < 4e-15, "{force}");
}

/// The loop at fixed grips with its losses, from closed forms.
#[test]
fn loop_has_known_losses() {
    let case = Case::ball([0.01, 0.04], Control::Indentation);
    let path = case.follow(&Start::Detached, &[-0.3, case.reversal(0.45), -0.3]);
    let losses = case.losses(&path);
    let jump = |kind: EventKind| {
        let index = path.events.iter().position(|event| event.kind == kind).unwrap();
        let Dissipation::Finite(jump) = &losses[index].jump else { panic!("finite at fixed grips") };
        jump.value
    };
    assert!((jump(EventKind::JumpIn) / 0.002_979_117_975_583_265 - 1.0).abs() < 1e-13);
    assert!((jump(EventKind::Detached) / 0.003_152_703_338_918_832 - 1.0).abs() < 1e-13);
    let balance = case.balance(&path);
    assert!((balance.hysteresis / 0.019_085_175_370_557_934 - 1.0).abs() < 1e-14);
    assert!((balance.work / 0.025_216_996_685_060_03 - 1.0).abs() < 1e-13);
    assert_eq!(balance.stored, 0.0);
}

/// Work by states at many way points against the losses and the stored energy, which are other integrals. The error of Simpson's
/// rule falls with the fourth power of the count, so that twice as many samples bound it.
#[test]
fn work_is_stored_or_lost() {
    let machine = Control::Machine { stiffness: 0.3 };
    let cases: [(Case, Start<f64>, &[f64]); 7] = [
        (Case::ball([0.01, 0.04], Control::Indentation), Start::Detached, &[-0.3, 0.1, -0.05, 0.12, -0.02, -0.3]),
        (Case::ball([0.0, 0.04], Control::Indentation), Start::Detached, &[-0.1, 0.2, 0.1, 0.15, -0.3]),
        (Case::ball([0.01, 0.04], machine.clone()), Start::Detached, &[-0.5, 0.3, 0.1, 0.4, -1.0]),
        (Case::ball([0.01, 0.04], Control::Indentation), Start::Largest, &[0.0, -0.05, 0.05, 0.02]),
        (Case::wavy([5e-5, 1e-4], Control::Indentation), Start::Detached, &[-0.01, 0.01, -0.002, 0.003, -0.02]),
        (Case::wavy([2e-5, 1e-4], machine), Start::Detached, &[-0.01, 0.02, 0.0, 0.01, -0.05]),
        (Case::wavy([9e-5, 1e-4], Control::Indentation), Start::Detached, &[-0.01, 0.01, 0.0099, 0.02, 0.005]),
    ];
    for (number, (case, start, way)) in cases.iter().enumerate() {
        let path = case.follow(start, way);
        assert!(path.is_finished(), "{number}: {:?}", kinds(&path));
        let balance = case.balance(&path);
        let [coarse, fine] = [32, 64].map(|count| case.sampled_work(start, way, count));
        let expected = balance.dissipated + balance.hysteresis + balance.stored;
        // ∫F dd, and on a machine ∫F dD: both are the integral of F over the controlled quantity.
        let error = (coarse - fine).abs() + 1e-13 * expected.abs();
        assert!((fine - expected).abs() <= error, "{number}: {fine} {expected} {coarse} {:?}", kinds(&path));
        assert!(error <= 1e-3 * expected.abs(), "{number}: {error} {expected}");
    }
}

/// The rule itself in small steps: advance to the first a' ≥ a with y ≥ Δl₁, recede to the first a' ≤ a with y ≤ Δl₂.
struct Steps<'a> {
    contact: &'a Contact<f64>,
    radius: f64,
}

impl Steps<'_> {
    const GRID: f64 = 1e-4;

    /// g − d at a held value, less Δl of an edge.
    fn excess(&self, edge: Edge, a: f64, value: f64) -> f64 {
        self.contact.at(edge).direction(&a, &value).unwrap()
    }

    fn hold(&mut self, value: f64) {
        while self.excess(Edge::Advancing, self.radius, value) < 0.0 {
            self.radius += Self::GRID;
        }
        while self.radius > Self::GRID && self.excess(Edge::Receding, self.radius, value) > 0.0 {
            self.radius -= Self::GRID;
        }
        if self.radius <= Self::GRID {
            self.radius = Self::GRID;
        }
    }
}

/// Along the way the radius of the path is that of the rule in small steps, to two of them, after jumps and in pins.
#[test]
fn path_obeys_the_rule_in_small_steps() {
    let machine = || Control::Machine { stiffness: 0.3 };
    let cases: [(Case, &[f64]); 6] = [
        (Case::ball([0.01, 0.04], Control::Indentation), &[0.0, 0.1, -0.05, 0.12, -0.15, 0.05]),
        (Case::ball([0.01, 0.04], machine()), &[0.0, 0.4, -0.65, 0.1, -0.7]),
        (Case::ball([0.01, 0.04], Control::Force), &[0.0, 0.1, -0.1, 0.15, -0.18]),
        (Case::wavy([5e-5, 1e-4], Control::Indentation), &[0.0, 0.01, -0.001, 0.003, -0.002, 0.004]),
        (Case::wavy([2e-5, 1e-4], machine()), &[0.0, 0.02, 0.0, 0.01, -0.003, 0.01]),
        (Case::wavy([8e-5, 1e-4], Control::Force), &[0.0, 4e-4, -3e-4, 3e-4, -3.5e-4, 3e-4]),
    ];
    for (number, (case, way)) in cases.iter().enumerate() {
        let first = case.follow(&Start::Detached, &[-1e-9, 0.0]);
        let ContactState::Contact(first) = first.events.last().unwrap().after.clone() else { panic!("jumped in") };
        let mut steps = Steps { contact: &case.contact, radius: first.contact_radius };
        let mut dense = vec![-1e-9];
        for pair in way.windows(2) {
            dense.extend((0..40).map(|i| pair[0] + (pair[1] - pair[0]) * f64::from(i) / 40.0));
        }
        let path = case.follow(&Start::Detached, &dense);
        assert!(path.is_finished(), "{number}: {:?}", path.events.last());
        let mut met = 0;
        for event in path.events.iter().skip(2).filter(|event| event.kind == EventKind::WayPoint) {
            let Some(state) = event.after.contact() else { panic!("{number}: detached at {}", event.value) };
            steps.hold(event.value);
            let apart = (steps.radius - state.contact_radius).abs();
            assert!(apart <= 2.0 * Steps::GRID, "{number}: {} {} {state:?}", event.value, steps.radius);
            met += 1;
        }
        assert!(met > 100, "{number}");
        assert!(path.events.iter().any(|event| event.kind == EventKind::Depinned), "{number}");
    }
}

/// A contact that turns within the pinned interval stays pinned; it moves on where it stopped, at the same value.
#[test]
fn pinned_edge_moves_on_where_it_stopped() {
    let case = Case::ball([0.01, 0.04], Control::Force);
    let path = case.follow(&Start::Detached, &[0.0, 0.1, 0.05, 0.1, 0.05, 0.08, 0.12]);
    let expected = [
        "start",
        "jump-in",
        "way-point",
        "pinned",
        "way-point",
        "way-point",
        "way-point",
        "way-point",
        "depinned",
        "end",
    ];
    assert_eq!(kinds(&path), expected);
    assert_eq!(of_kind(&path, EventKind::Depinned).value, 0.1);
    let [stopped, moves] = [EventKind::Pinned, EventKind::Depinned]
        .map(|kind| of_kind(&path, kind).after.contact().unwrap().contact_radius);
    assert_eq!(stopped, moves);
    // It ends pinned: the last state has the radius of the reversal, and lies between the two curves.
    let path = case.follow(&Start::Detached, &[0.0, 0.1, 0.05]);
    assert_eq!(kinds(&path), ["start", "jump-in", "way-point", "pinned", "end"]);
    let [turned, last] = [2, 4].map(|index: usize| path.events[index].after.contact().unwrap().clone());
    assert_eq!(turned.contact_radius, last.contact_radius);
    let slope = (turned.force - last.force) / (turned.indentation - last.indentation);
    assert!((slope / (2.0 * turned.contact_radius) - 1.0).abs() < 1e-13, "dF = 2E*a dd");
}

/// Full pull-off of a power law that was touched at F = 0, and no more: iff w₁/w₂ ≥ 9/(4(n+1)²); a sphere 1/4, a cone 9/16.
#[test]
fn pull_off_depends_on_the_ratio() {
    let shapes = |n: f64| match n {
        1.0 => vec![Shape::Cone { flank: mdr_core::contact::Flank::Slope(0.3) }],
        2.0 => vec![Shape::Paraboloid { radius: 1.0 }],
        _ => vec![Shape::Power { n, c: 1.0 }],
    };
    for n in [0.75, 1.0, 1.5, 2.0, 3.0, 6.0] {
        let threshold = 9.0 / (4.0 * (n + 1.0) * (n + 1.0));
        for (share, full) in [(threshold * (1.0 + 1e-6), true), (threshold * (1.0 - 1e-6), false)] {
            if share > 1.0 {
                continue;
            }
            let case = Case::new(shapes(n), [0.01 * share, 0.01], Control::Force);
            let path = case.follow(&Start::Detached, &[-1.0, 0.0, -1.0]);
            let off = of_kind(&path, EventKind::Detached);
            assert_eq!(off.fold.is_some(), full, "{n} {share}: {:?}", kinds(&path));
            let fold = mdr_numeric::folds::find(&case.contact.at(Edge::Receding)).unwrap()[0].clone();
            let force = off.before.contact().unwrap().force;
            assert_eq!(force == fold.force, full);
            assert!(full || force > fold.force);
        }
    }
}

/// A sphere reaches the pull-off force of w₂ after a preload of 3πw₂R(1/2 − √(w₁/w₂)).
#[test]
fn preload_of_a_sphere() {
    for share in [0.0, 0.01, 0.0625, 0.2] {
        let works = [0.04 * share, 0.04];
        let preload = 3.0 * PI * works[1] * (0.5 - share.sqrt());
        let case = Case::ball(works, Control::Force);
        for (more, full) in [(1.0 + 1e-9, true), (1.0 - 1e-9, false)] {
            let path = case.follow(&Start::Detached, &[-1.0, preload * more, -1.0]);
            assert_eq!(of_kind(&path, EventKind::Detached).fold.is_some(), full, "{share} {more}");
        }
    }
}

/// Two equal works of adhesion are one: the path is the one of [`Path::follow`], bit for bit.
#[test]
fn equal_works_are_one() {
    for control in [Control::Indentation, Control::Force, Control::Machine { stiffness: 0.3 }] {
        let case = Case::wavy([1e-4, 1e-4], control);
        let way = [-0.01, 1e-3, -5e-4, 2e-3, -0.02];
        let single = Path::follow(&case.branches[1], &Start::Detached, &way).unwrap();
        assert_eq!(case.follow(&Start::Detached, &way), single);
        assert!(single.events.iter().all(|event| event.edge.is_none()));
    }
}

#[test]
fn works_are_checked() {
    for (works, ok) in [
        ([0.0, 0.04], true),
        ([0.04, 0.04], true),
        ([0.05, 0.04], false),
        ([-0.01, 0.04], false),
        ([0.0, 0.0], false),
        ([f64::NAN, 0.04], false),
        ([0.01, f64::INFINITY], false),
    ] {
        let made = Adhesion::hysteretic(works[0], works[1]);
        assert_eq!(made.is_ok(), ok, "{works:?}");
        assert!(ok || matches!(made, Err(Error::Domain { .. })));
    }
}
