//! The energy balance of loading paths: known dissipation, balance, hysteresis.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::f64::consts::PI;
use std::sync::Arc;

use approx::assert_relative_eq;
use mdr_core::contact::{Control, Material, Shape, Transform};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::path::{Balance, ContactState, Dissipation, EventKind, Path, PathEnergy, Start};
use mdr_numeric::profiles::Heights;
use mdr_numeric::transform::Quadrature;
use proptest::prelude::*;

const U: f64 = f64::EPSILON / 2.0;

struct Run {
    path: Path<f64>,
    energies: PathEnergy<f64>,
    balance: Option<Balance<f64>>,
}

impl Run {
    fn new(
        transform: &(impl Transform<f64> + Clone + 'static),
        material: &Material<f64>,
        control: &Control<f64>,
        start: Start<f64>,
        way: &[f64],
    ) -> Self {
        let branches =
            SearchedBranches::new(Contact::half_space(&Arc::new(transform.clone()), material, control)).unwrap();
        let path = Path::follow(&branches, &start, way).unwrap();
        let energies = PathEnergy::new(&path, &branches).unwrap();
        let balance = energies.balance(&path, &branches).unwrap();
        Run { path, energies, balance }
    }

    /// The finite dissipation in the first event of a kind, and the radius on its contact side.
    fn loss(&self, kind: EventKind) -> (f64, f64) {
        let i = self.path.events.iter().position(|event| event.kind == kind).unwrap();
        let Dissipation::Finite(dissipated) = &self.energies.entries[i].dissipated else { panic!("unbounded") };
        let event = &self.path.events[i];
        let rest = event.before.contact().or(event.after.contact()).unwrap();
        (dissipated.value, rest.contact_radius)
    }

    fn balanced(&self) -> &Balance<f64> {
        let balance = self.balance.as_ref().unwrap();
        assert!(balance.residual.abs() <= balance.bound, "{balance:?}");
        // A bound that allows anything would test nothing.
        let works: f64 = self.energies.entries.iter().map(|entry| entry.work.value.abs()).sum();
        assert!(balance.bound <= 1e-10 * (works + balance.dissipated + balance.stored.abs()), "{balance:?}");
        balance
    }
}

#[test]
fn losses_of_power_laws() {
    // At fixed grips n(2n−1)/((n+1)(2n+1)) of πa_c²w at pull-off; (2n−1)/(2n+1) at jump-in from d = 0, and from F = 0 too:
    // there d(a) is the mean of g and the integrand Δl² − (n/(n+1))²g², with (n/(n+1))g = Δl at the end.
    for n in [0.6, 1.0, 2.0, 3.5, 12.0] {
        let profile = Arc::new(Quadrature::of([Shape::Power { n, c: 0.7 }]).unwrap());
        let (e, w) = (3e5, 0.04);
        let material = Material::new(e, w).unwrap();
        let unit = |a: f64| PI * a * a * w;
        let run = Run::new(&profile, &material, &Control::Indentation, Start::Detached, &[0.0, -1e3]);
        let (dissipated, a) = run.loss(EventKind::JumpIn);
        // Quadrature to 128u of integrals over Δl², twice πa²w, and 2n for the rounding of a in g².
        let allowed = 256.0 * U * (1.0 + 2.0 * n);
        assert_relative_eq!(dissipated / unit(a), (2.0 * n - 1.0) / (2.0 * n + 1.0), epsilon = allowed);
        let (dissipated, a) = run.loss(EventKind::Detached);
        let fraction = n * (2.0 * n - 1.0) / ((n + 1.0) * (2.0 * n + 1.0));
        // (d/Δl)² there is (1 − 1/2n)².
        assert_relative_eq!(dissipated / unit(a), fraction, epsilon = allowed);
        run.balanced();

        let run = Run::new(&profile, &material, &Control::Force, Start::Detached, &[0.0, 1.0]);
        let (dissipated, a) = run.loss(EventKind::JumpIn);
        assert_relative_eq!(dissipated / unit(a), (2.0 * n - 1.0) / (2.0 * n + 1.0), epsilon = allowed);
        run.balanced();
    }
}

#[test]
fn the_flat_punch_gives_all_it_has() {
    // Jump-in at d = 0: πb²w. Pull-off: ∫(Δl(b)² − Δl(a)²) is πb²w as well. Pressed, it is a linear spring.
    let (b, e, w) = (0.3, 2e6, 0.05);
    let (punch, material) = (Quadrature::of([Shape::FlatPunch { radius: b }]).unwrap(), Material::new(e, w).unwrap());
    let run = Run::new(&punch, &material, &Control::Indentation, Start::Detached, &[0.0, 1e-3, -1e-3]);
    for kind in [EventKind::JumpIn, EventKind::Detached] {
        assert_relative_eq!(run.loss(kind).0, PI * b * b * w, max_relative = 256.0 * U);
    }
    assert_relative_eq!(run.energies.entries[2].work.value, e * b * 1e-6, max_relative = 16.0 * U);
    run.balanced();
}

#[test]
fn a_cycle_of_jkr_loses_its_area() {
    // Fixed grips: 2/5 of π a_c² w at pull-off and 3/5 of π a₀² w at jump-in, a₀³ = 16a_c³.
    let (r, e, w) = (3.0, 7e5, 0.02);
    let (ball, material) = (Quadrature::of([Shape::Paraboloid { radius: r }]).unwrap(), Material::new(e, w).unwrap());
    let a_c = f64::cbrt(PI * w * r * r / (8.0 * e));
    let depth = 10.0 * a_c * a_c / r;
    let run = Run::new(&ball, &material, &Control::Indentation, Start::Detached, &[-depth, depth, -depth]);
    let balance = run.balanced();
    let expected = PI * w * a_c * a_c * (0.4 + 0.6 * f64::cbrt(256.0));
    assert_relative_eq!(balance.dissipated, expected, max_relative = 256.0 * U);
    assert_relative_eq!(balance.work, balance.dissipated, max_relative = balance.bound / balance.dissipated);
    assert_eq!(balance.stored, 0.0);

    // A soft machine: Π of the spring is included; the dissipation lies in between.
    let machine = Control::machine(2.0 * e * a_c).unwrap();
    let soft = Run::new(&ball, &material, &machine, Start::Detached, &[-9.0 * depth, depth, -9.0 * depth]);
    assert!(soft.balanced().dissipated > balance.dissipated);
    let open = Run::new(&ball, &material, &machine, Start::Largest, &[0.0, depth]);
    let spring = open.path.events[1].after.contact().unwrap().force.powi(2) / (4.0 * e * a_c);
    assert!(open.balanced().stored > spring - 10.0 * PI * w * a_c * a_c);

    // Under a dead load the pull-off has no final state, and only it is unbounded.
    let dead = Run::new(&ball, &material, &Control::Force, Start::Largest, &[0.0, -100.0]);
    assert_eq!((&dead.energies.entries[1].dissipated, &dead.balance), (&Dissipation::Unbounded, &None));
    Run::new(&ball, &material, &Control::Force, Start::Detached, &[-1.0, 3.0, -0.1]).balanced();
}

/// R = 1, A = 5e-4, λ = 0.1, w/E* = 1e-4.
fn figure_4() -> (Quadrature<f64, Heights<f64>>, Material<f64>) {
    (
        Quadrature::of([Shape::WavyParaboloid { radius: 1.0, amplitude: 5e-4, wavelength: 0.1 }]).unwrap(),
        Material::new(1.0, 1e-4).unwrap(),
    )
}

#[test]
fn the_hysteresis_of_figure_4() {
    let (profile, material) = figure_4();
    // Down past the first jump and back up: a closed cycle that never detaches.
    let cycle = Run::new(&profile, &material, &Control::Indentation, Start::Largest, &[0.0, -0.002, 0.0]);
    let [first, .., last] = cycle.path.events.as_slice() else { panic!("events") };
    assert_eq!(first.after, last.after);
    let balance = cycle.balanced();
    assert!(balance.dissipated > 0.0);
    assert_relative_eq!(balance.work, balance.dissipated, max_relative = balance.bound / balance.dissipated);
    // The whole path: under every control the dissipation is positive and the energies balance.
    let stiff = Control::machine(0.05).unwrap();
    for control in [Control::Indentation, stiff] {
        let run = Run::new(&profile, &material, &control, Start::Detached, &[-0.02, 0.02, -0.02]);
        run.balanced();
    }
    // Under a dead load until just before the pull-off.
    let run = Run::new(&profile, &material, &Control::Force, Start::Detached, &[0.0, 0.02, -0.0001]);
    run.balanced();
}

#[test]
fn a_small_force_control_jump_is_paid_by_the_load() {
    // Waves with folds under a dead load: F(d₂ − d₁) is part of the work.
    let profile =
        Arc::new(Quadrature::of([Shape::WavyParaboloid { radius: 1.0, amplitude: 2e-3, wavelength: 0.1 }]).unwrap());
    let material = Material::new(1.0, 1e-4).unwrap();
    let run = Run::new(&profile, &material, &Control::Force, Start::Detached, &[0.0, 0.02]);
    let jumps: Vec<f64> = run.energies.entries.iter().map(|entry| entry.work_in_event).collect();
    assert!(run.path.events.iter().any(|event| event.kind == EventKind::Jump), "{:?}", run.path);
    assert!(jumps.iter().any(|work| *work > 0.0));
    run.balanced();
}

#[test]
fn below_one_half_a_cycle_loses_nothing() {
    let (profile, material) =
        (Arc::new(Quadrature::of([Shape::Power { n: 0.25, c: 1.0 }]).unwrap()), Material::new(1.0, 1.0).unwrap());
    for control in [Control::Indentation, Control::Force, Control::machine(1.0).unwrap()] {
        let branches = SearchedBranches::new(Contact::half_space(&profile, &material, &control)).unwrap();
        let fold = &branches.folds()[0];
        let top = control.controlled(&fold.indentation, &fold.force);
        let run = Run::new(&profile, &material, &control, Start::Detached, &[-top, 0.9 * top]);
        assert_eq!(run.balanced().dissipated, 0.0);
        let cycle = Run::new(&profile, &material, &control, Start::Detached, &[-top, 0.9 * top, -top]);
        let balance = cycle.balance.unwrap();
        assert!(balance.work.abs() <= balance.bound && balance.dissipated == 0.0 && balance.stored == 0.0);
        let beyond = Run::new(&profile, &material, &control, Start::Detached, &[-top, 2.0 * top]);
        assert_eq!((beyond.balance, beyond.energies.entries[2].dissipated.clone()), (None, Dissipation::Unbounded));
    }
}

#[test]
fn kinks_do_no_harm() {
    let (punch, material) =
        (Quadrature::of([Shape::RoundedPunch { radius: 1.0, flat: 0.3 }]).unwrap(), Material::new(1.0, 1e-4).unwrap());
    Run::new(&punch, &material, &Control::Indentation, Start::Detached, &[-0.1, 0.1, -0.1]).balanced();
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases * 12 / 256))]

    /// Random wavy profiles, way points and controls: the energies balance, and every jump dissipates energy.
    #[test]
    fn energy_is_balanced(
        amplitude in 1e-4..1e-3, wavelength in 0.07..0.3, ways in prop::collection::vec(-1.0..1.0, 1..5),
        stiffness in -3.0..1.0, by_machine in any::<bool>(),
    ) {
        let profile = Arc::new(Quadrature::of([Shape::WavyParaboloid { radius: 1.0, amplitude, wavelength }]).unwrap());
        let material = Material::new(1.0, 1e-4).unwrap();
        let control = if by_machine {
            Control::machine(10f64.powf(stiffness)).unwrap()
        } else {
            Control::Indentation
        };
        let mut way = vec![-0.02];
        way.extend(ways.iter().map(|x| 0.01 * x));
        let run = Run::new(&profile, &material, &control, Start::Detached, &way);
        prop_assert!(run.path.is_finished());
        let balance = run.balance.as_ref().unwrap();
        prop_assert!(balance.residual.abs() <= balance.bound, "{:?}", balance);
        for (entry, event) in run.energies.entries.iter().zip(&run.path.events) {
            let Dissipation::Finite(dissipated) = &entry.dissipated else { panic!("unbounded") };
            prop_assert!(dissipated.value >= 0.0);
            let jumps = event.before != event.after && event.before != ContactState::Detached;
            prop_assert!(!jumps || dissipated.value > dissipated.error, "{:?}", event);
        }
    }
}
