//! The wave of Johnson (1995).

use approx::assert_relative_eq;
use mdr_analytic::media::{
    JohnsonWave, WaveControl, WaveFold, least_compliance_for_complete_contact, wave_approach_threshold,
    wave_energy_threshold, wave_load_threshold, wave_touch_threshold,
};
use mdr_core::contact::{Error, FoldKind, Material, Result};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Dual, Interval, Precision, Real};

use super::{number, prove};

fn wave(precision: Precision, alpha: &str) -> Result<JohnsonWave<Interval>> {
    JohnsonWave::of_alpha(number(precision, alpha))
}

fn approach(precision: Precision, compliance: &str) -> WaveControl<Interval> {
    WaveControl::Approach { compliance: number(precision, compliance) }
}

fn double(alpha: f64) -> JohnsonWave<f64> {
    JohnsonWave::of_alpha(alpha).unwrap()
}

#[test]
fn thresholds() {
    prove(["1.06520565606328065797270722923"], |p| Ok([wave_load_threshold(&Interval::from_int(p, 1))]));
    prove(["1.61370563888010938116553575708"], |p| {
        Ok([least_compliance_for_complete_contact(&Interval::from_int(p, 1))])
    });
    // 3^{3/4}/4 and 1/√(2π).
    prove(["0.569876764238694410498390813", "0.398942280401432677939946059934"], |p| {
        let one = Interval::from_int(p, 1);
        Ok([wave_touch_threshold(&one), wave_energy_threshold(&one)])
    });
    // As many digits as are printed.
    for (compliance, expected) in [("10", "1.391393917319464992637912"), ("2", "8.654553508873590745178009")] {
        let threshold = wave_approach_threshold(&number(Precision::new(200), compliance)).unwrap();
        let rounded = Enclosure::from(threshold).round(25).unwrap();
        assert_eq!(rounded.to_string(), expected);
    }
}

#[test]
fn folds_under_a_dead_load() {
    let folds = |fold: usize| {
        move |precision: Precision| {
            let state = wave(precision, "0.3")?.folds(&WaveControl::Load)?.remove(fold).state;
            Ok([state.share, state.pressure, state.mean_gap])
        }
    };
    let pull_off =
        ["0.0334754863637401504042060377185", "-0.0959440263420646401834393766371", "1.29244079277598441516112033957"];
    prove(pull_off, folds(0));
    let pull_in =
        ["0.862398133131568084063415741549", "0.387727760720551064348407731248", "0.0802033301896337151300989698191"];
    prove(pull_in, folds(1));
}

#[test]
fn states_without_a_load() {
    prove(["0.485766904263314938515561698278"], |precision| {
        let touching = wave(precision, "0.3")?.touching(&WaveControl::Load)?;
        Ok([touching.expect("below the threshold").angle])
    });
    // α = 1/2: ψ = π/4.
    prove(["0.785398163397448309615660845819876"], |precision| {
        let touching = wave(precision, "0.5")?.touching(&WaveControl::Load)?;
        Ok([touching.expect("below the threshold").angle])
    });
    assert_eq!(double(0.57).touching(&WaveControl::Load), Ok(None));
}

#[test]
fn losses_in_jumps() {
    prove(["0.0318398552359114908538073415045", "0.0123597916818971449567331141213"], |precision| {
        let wave = wave(precision, "0.3")?;
        Ok([wave.energy_lost_at_touch(&WaveControl::Load)?, wave.energy_lost_at_complete_contact()?])
    });
    prove(["0.0248600346983331267962461142702", "0.00848865170864881410029806736936"], |precision| {
        let wave = wave(precision, "0.3")?;
        let grips = approach(precision, "0");
        Ok([wave.energy_lost_at_touch(&grips)?, wave.energy_lost_at_pull_off(&number(precision, "0"))?])
    });
}

#[test]
fn control_by_the_approach() {
    prove(["0.360573796696666508549055031288", "-0.0597394310842927004965631743837"], |precision| {
        let state = wave(precision, "0.3")?.touching(&approach(precision, "0"))?.expect("always for κ = 0");
        Ok([state.angle, state.pressure])
    });
    prove(["0.0707343437978380260911284997512", "1.39170871811427556509813294049"], |precision| {
        let mut folds = wave(precision, "0.3")?.folds(&approach(precision, "0"))?;
        assert_eq!(folds.len(), 1);
        let state = folds.remove(0).state;
        Ok([state.angle, state.mean_gap])
    });
    // As many digits as are printed.
    let wave = double(0.3);
    let folds = wave.folds(&WaveControl::Approach { compliance: 2.0 }).unwrap();
    let angles: Vec<f64> = folds.iter().map(|fold| fold.state.angle).collect();
    assert_relative_eq!(
        angles.as_slice(),
        [0.098_122_737_754_104_06, 1.229_819_869_496_210_3].as_slice(),
        max_relative = 4e-15
    );
}

/// α = 1: the jump to complete contact is exactly at s = 1/2, P = −1/2. Over intervals it is enclosed.
#[test]
fn a_fold_with_rational_numbers() -> Result<()> {
    let precision = Precision::new(160);
    let state = wave(precision, "1")?.folds(&WaveControl::Load)?.remove(1).state;
    let half = state.share.ratio(1, 2);
    assert!(state.share.contains(half.lower()) && state.pressure.contains((-half).lower()));
    assert!(state.share.accuracy_bits() > 140);
    Ok(())
}

/// What the controlled quantity is worth at ψ.
fn held(wave: &JohnsonWave<f64>, control: &WaveControl<f64>, angle: f64) -> f64 {
    let state = wave.state(&angle).unwrap();
    match control {
        WaveControl::Load => state.pressure,
        WaveControl::Approach { compliance } => 1.0 - state.mean_gap + compliance * state.pressure,
    }
}

/// A dense scan of the equilibria in ln tan²ψ turns where the folds are, and nowhere else.
#[test]
fn folds_are_those_of_a_scan() -> Result<()> {
    let compliances = [0.0, 1e-3, 0.5, 1.5, 1.613, 1.614, 1.7, 2.5, 10.0, 300.0]
        .map(|compliance| WaveControl::Approach { compliance });
    let mut seen = std::collections::BTreeSet::new();
    for control in compliances.into_iter().chain([WaveControl::Load]) {
        for alpha in [1e-3, 0.1, 0.3, 0.7, 1.06, 1.2, 3.0, 20.0] {
            let wave = double(alpha);
            let folds = wave.folds(&control)?;
            seen.insert(folds.len());
            let at = |step: i32| (f64::from(step) / 400.0).exp().sqrt().atan();
            let mut turns = Vec::new();
            for step in -8800..8800 {
                let [before, here, after] = [step - 1, step, step + 1].map(|step| held(&wave, &control, at(step)));
                if here < before.min(after) {
                    turns.push((step, FoldKind::Minimum));
                } else if here > before.max(after) {
                    turns.push((step, FoldKind::Maximum));
                }
            }
            assert_eq!(folds.len(), turns.len(), "{control:?}, α = {alpha}: {folds:?} {turns:?}");
            for (WaveFold { state, kind }, (step, expected)) in folds.iter().zip(turns) {
                assert_eq!(*kind, expected);
                assert!(state.angle > at(step - 1) && state.angle < at(step + 1), "{control:?}, α = {alpha}");
            }
        }
    }
    assert_eq!(seen.into_iter().collect::<Vec<_>>(), [0, 1, 2]);
    Ok(())
}

/// The number of folds is decided beside each threshold, and open only within rounding of it.
#[test]
fn folds_beside_their_threshold() -> Result<()> {
    let precision = Precision::new(200);
    let one = Interval::from_int(precision, 1);
    let controls = [WaveControl::Load, approach(precision, "2"), approach(precision, "40")];
    for control in controls {
        let threshold = match &control {
            WaveControl::Load => wave_load_threshold(&one),
            WaveControl::Approach { compliance } => wave_approach_threshold(compliance)?,
        };
        for (offset, number) in [(-1, 2), (1, 0)] {
            let alpha = threshold.midpoint() + one.lit(offset) * one.lit(10).powi(-30);
            let folds = JohnsonWave::of_alpha(alpha.midpoint())?.folds(&control)?;
            assert_eq!(folds.len(), number, "{control:?}");
        }
        let at = JohnsonWave::of_alpha(threshold)?.folds(&control);
        assert!(matches!(at, Err(Error::Undecided { .. })), "{control:?}: {at:?}");
    }
    Ok(())
}

/// P_off → −3(α/4)^{4/3}, with the next term of the order α^{4/3} relative to it, and P_in → 1 − 5(α/4)^{4/5}.
#[test]
fn small_adhesion() -> Result<()> {
    for alpha in [1e-2, 1e-5, 1e-9, 1e-60, 1e-200] {
        let folds = double(alpha).folds(&WaveControl::Load)?;
        let small = (alpha / 4.0).powf(4.0 / 3.0);
        assert_relative_eq!(folds[0].state.pressure, -3.0 * small, max_relative = 5.0 * small + 1e-12);
        // s ~ (α/4)^{4/3}, also where an absolute tolerance would lose it.
        assert_relative_eq!(folds[0].state.share, small, max_relative = 5.0 * small + 1e-12);
        let rest = (alpha / 4.0).powf(0.8);
        assert_relative_eq!(folds[1].state.rest, rest, max_relative = 5.0 * rest + 1e-12);
        // H = 5ε² − ε²/2 + … at complete contact.
        assert_relative_eq!(folds[1].state.mean_gap, 4.5 * rest * rest, max_relative = 10.0 * rest + 1e-12);
        let lost = double(alpha).energy_lost_at_complete_contact()?;
        assert_relative_eq!(lost, 35.0 / 6.0 * rest.powi(3), max_relative = 10.0 * rest + 1e-12);
    }
    Ok(())
}

/// G = w on the equilibria; dΠ/dψ = (G/w − 1)α² at a fixed approach, and dΠ/dH = −P at a fixed ψ.
#[test]
fn energy_and_its_release() -> Result<()> {
    let wave = JohnsonWave::of_alpha(Dual::constant(0.3))?;
    for angle in [1e-3, 0.2, 0.8, 1.3, 1.55] {
        let equilibrium = double(0.3).state(&angle)?;
        assert_relative_eq!(equilibrium.release_rate(), 1.0, max_relative = 1e-11);
        for pressure in [-0.4, 0.0, 0.7] {
            // Under a dead load the potential changes by the same (G/w − 1)α².
            let dual = wave.held(&Dual::variable(angle), &Dual::constant(pressure))?;
            let expected = (dual.release_rate().value - 1.0) * 0.09;
            let scale = 1.0 / (angle * angle) + 1.0;
            assert!((dual.load_potential().slope - expected).abs() < 1e-13 * scale, "{angle} {pressure}");
            let pressed = wave.held(&Dual::constant(angle), &Dual::variable(pressure))?;
            let slope = pressed.energy().slope + pressure * pressed.mean_gap.slope;
            assert!(slope.abs() < 1e-14 * (1.0 + angle.sin().ln().abs()), "{slope}");
        }
    }
    Ok(())
}

/// The mean of the pressure is P, the mean of the gap H; pressures rise without bound at the edge, gaps are never negative.
#[test]
fn pressure_and_gap() -> Result<()> {
    for (angle, pressure) in [(0.3, -0.1), (0.8, 0.6), (1.3, 0.2), (1.5, 0.99)] {
        let state = double(0.3).held(&angle, &pressure)?;
        let half_pi = std::f64::consts::FRAC_PI_2;
        // X = ψ sin φ takes the roots out of both ends; midpoint sums of periodic functions converge geometrically.
        let steps = 400;
        let middle = |step: i32| half_pi * (f64::from(step) + 0.5) / f64::from(steps);
        let sum: f64 = (0..steps)
            .map(|step| {
                let phi = middle(step);
                state.pressure_at(&(angle * phi.sin())).unwrap() * angle * phi.cos()
            })
            .sum();
        assert_relative_eq!(sum / f64::from(steps), pressure, max_relative = 1e-10);
        let width = half_pi - angle;
        let gaps: Vec<f64> = (0..steps)
            .map(|step| {
                let phi = middle(step);
                let gap = state.gap_at(&(angle + width * phi.sin().powi(2))).unwrap();
                assert!(gap > 0.0 || pressure > state.share, "{gap}");
                gap * width * 2.0 * phi.sin() * phi.cos()
            })
            .collect();
        let mean = gaps.iter().sum::<f64>() / f64::from(steps);
        assert_relative_eq!(mean, state.mean_gap, max_relative = 1e-5);
        assert!(state.pressure_at(&angle).is_err() && state.gap_at(&(angle - 0.1)).is_err());
        assert_eq!(state.gap_at(&angle), Ok(0.0));
    }
    Ok(())
}

#[test]
fn a_flaw_breaks_complete_contact() -> Result<()> {
    let wave = JohnsonWave::new(1e-6, 1e-4, Material::new(1e6, 0.01)?)?;
    let flaw = wave.state_with_flaw(&1e-6)?;
    let angle = std::f64::consts::PI * 1e-2;
    let expected = angle.cos().powi(2) - wave.alpha() / angle.tan().sqrt();
    assert_relative_eq!(flaw.pressure, expected, max_relative = 1e-13);
    let same = wave.state_at_half_width(&4.9e-5)?;
    assert_relative_eq!(same.pressure, flaw.pressure, max_relative = 1e-12);
    assert!(wave.state_with_flaw(&5e-5).is_err() && wave.state_at_half_width(&5e-5).is_err());
    Ok(())
}

#[test]
fn what_is_outside_of_the_domain_is_refused() {
    let material = || Material::new(1.0, 1.0).unwrap();
    assert!(JohnsonWave::new(0.0, 1.0, material()).is_err() && JohnsonWave::new(1.0, f64::NAN, material()).is_err());
    assert!(JohnsonWave::of_alpha(-0.3).is_err() && double(0.3).compliance(&0.0).is_err());
    for compliance in [-1.0, f64::INFINITY, f64::NAN] {
        let folds = double(0.3).folds(&WaveControl::Approach { compliance });
        assert!(matches!(folds, Err(Error::Domain { .. })), "{compliance}");
    }
    assert!(wave_approach_threshold(&1.6).is_err());
    assert!(double(0.3).state(&1.6).is_err() && double(0.3).held(&0.5, &f64::NAN).is_err());
    assert!(matches!(double(1.1).energy_lost_at_complete_contact(), Err(Error::Domain { .. })));
    assert!(matches!(double(0.6).energy_lost_at_touch(&WaveControl::Load), Err(Error::Domain { .. })));
    // α of 10^−400.
    let beyond = JohnsonWave::new(1e200, 1e-200, Material::new(1e200, 1e-200).unwrap());
    assert!(matches!(beyond, Err(Error::OutOfRange { .. })), "{beyond:?}");
}
