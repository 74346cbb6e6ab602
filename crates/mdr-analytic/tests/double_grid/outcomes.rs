//! Points that are passed on, exact results, and independence of position and instruction set.

use std::f64::consts::PI;

use mdr_analytic::double::grid::{BatchReport, InstructionSet, Materials, Points, States, critical_states};
use mdr_analytic::{State, double};
use mdr_core::contact::{Control, Error, Material, Quantity, Ranged, Status};

use super::answers::{Answers, answers};
use super::points::{CONTROLS, Draw, Point, columns};

/// Points outside the guarantee of the kernel: the scalar result, or its status and no value.
#[test]
fn every_other_point_is_the_scalar_answer() {
    let special =
        [0.0, -0.0, -1.0, 5e-324, 1e-310, 1e-300, 1.0, 1e200, f64::MAX, f64::INFINITY, f64::NAN, -f64::INFINITY];
    let exponents = [1e-300, 1e-12, 0.3, 0.5, 0.5 + 2f64.powi(-45), 0.5f64.next_up(), 1.5, 2.0, 700.0, 1e16, f64::MAX];
    let mut points = Vec::new();
    for n in special.into_iter().chain(exponents) {
        for c in special.into_iter().chain([1e-150, 1e150]) {
            for (e, w) in [(1.0, 1.0), (1e200, 1e-200), (1e-200, 1e200), (f64::NAN, 1.0), (1.0, -1.0), (0.0, 1.0)] {
                points.push(Point { n, c, e, w });
            }
        }
    }
    let mut seen = Vec::new();
    for path in InstructionSet::available() {
        for control in CONTROLS.into_iter().chain([Control::Machine { stiffness: 30.0 }]) {
            let answers = answers(&points, path, &control);
            let mut without_value = 0;
            for (i, p) in points.iter().enumerate() {
                let [kappa, values @ ..] = answers.at(i);
                let scalar = Material::new(p.e, p.w).and_then(|m| double::critical(p.n, p.c, &m, &control));
                check(&values, answers.status[i], &scalar, p);
                let expected = double::kappa(p.n).unwrap_or(f64::NAN);
                assert!(
                    (kappa - expected).abs() <= 2.0 * expected * f64::EPSILON || kappa.is_nan() && expected.is_nan()
                );
                without_value += usize::from(answers.status[i] != Status::Ok);
                seen.push(answers.status[i]);
            }
            assert_eq!(answers.tally.without_value, without_value);
            assert!(answers.tally.passed_on >= without_value);
        }
    }
    for status in [Status::Ok, Status::Overflow, Status::Underflow, Status::DomainError] {
        assert!(seen.contains(&status), "{status}");
    }
}

#[track_caller]
fn check(values: &[f64], status: Status, scalar: &mdr_core::contact::Result<State<Ranged<f64>>>, p: &Point) {
    let Ok(State { contact_radius, indentation, force }) = scalar else {
        assert!(values.iter().all(|x| x.is_nan()), "{p:?}: {values:?}");
        let expected =
            if matches!(scalar, Err(Error::Domain { .. })) { Status::DomainError } else { Status::Undecided };
        assert_eq!(status, expected, "{p:?}");
        return;
    };
    let mut first = Status::Ok;
    for (value, expected) in values.iter().zip([contact_radius, indentation, force]) {
        match expected {
            Ranged::Value(x) => assert!((value - x).abs() <= 2.0 * x.abs() * f64::EPSILON, "{p:?}: {value:e}, {x:e}"),
            _ => {
                assert!(value.is_nan(), "{p:?}: {value:e}");
                first = if first == Status::Ok { expected.status() } else { first };
            }
        }
    }
    assert_eq!(status, first, "{p:?}");
}

#[test]
fn exact_results_are_exact() {
    let points = [1.5, 2.0, 6.0].map(|n| Point { n, c: 0.5, e: 1.0, w: 1.0 });
    for path in InstructionSet::available() {
        let answers = answers(&points, path, &Control::Force);
        assert_eq!(answers.tally, BatchReport::default());
        assert_eq!(answers.at(0)[2], 0.0, "d of n = 3/2 under a dead load");
        assert_eq!(answers.at(1)[0], 2.0, "κ_2");
        assert_eq!(answers.at(2)[0], 3.2, "κ_6 = 16/5");
        assert_eq!(answers.at(1)[3], -1.5 * PI, "F = −(3/2)πwR");
    }
}

/// The result of a point is independent of its position, of the form of its material, and of the vector width.
#[test]
fn place_material_and_width_do_not_matter() {
    let mut draw = Draw::new(5);
    let gel = Material::new(1e4, 0.05).unwrap();
    let mut points: Vec<Point> = (0..200).map(|_| Point { e: 1e4, w: 0.05, ..draw.laboratory() }).collect();
    points[70].n = 0.5;
    points[130].c = -1.0;
    let bits = |answers: &Answers, i: usize| answers.at(i).map(f64::to_bits);
    let [n, c, ..] = columns(&points);
    let one = |range: std::ops::Range<usize>| Points {
        exponent: &n[range.clone()],
        coefficient: &c[range],
        material: Materials::One(&gel),
    };
    for path in InstructionSet::available() {
        let whole = answers(&points, path, &Control::Indentation);
        for start in [0, 1, 37] {
            for end in start..points.len() {
                let part = Answers::of(&one(start..end), path, &Control::Indentation);
                for i in start..end {
                    assert_eq!(bits(&part, i - start), bits(&whole, i), "{i} of {start}..{end} by {path}");
                    assert_eq!(part.status[i - start], whole.status[i]);
                }
            }
        }
    }
    if let (Some(four), Some(eight)) = (InstructionSet::avx2(), InstructionSet::avx512()) {
        let (four, eight) = (answers(&points, four, &Control::Force), answers(&points, eight, &Control::Force));
        assert!((0..points.len()).all(|i| bits(&four, i) == bits(&eight, i)));
    }
}

#[test]
fn slices_of_different_lengths_are_refused() {
    let quantities = [
        Quantity::Coefficient,
        Quantity::EffectiveModulus,
        Quantity::WorkOfAdhesion,
        Quantity::Kappa,
        Quantity::ContactRadius,
        Quantity::Indentation,
        Quantity::Force,
        Quantity::Parameter("the status"),
    ];
    for (wrong, quantity) in quantities.into_iter().enumerate() {
        let ones = [1.0; 9];
        let len = |i: usize| if i == wrong { 8 } else { 9 };
        let mut out = [[0.0; 9]; 4];
        let mut status = [Status::Ok; 9];
        let [kappa, radius, indentation, force] = &mut out;
        let points = Points {
            exponent: &ones,
            coefficient: &ones[..len(0)],
            material: Materials::Each { effective_modulus: &ones[..len(1)], work_of_adhesion: &ones[..len(2)] },
        };
        let mut states = States {
            kappa: &mut kappa[..len(3)],
            contact_radius: &mut radius[..len(4)],
            indentation: &mut indentation[..len(5)],
            force: &mut force[..len(6)],
            status: &mut status[..len(7)],
        };
        let refused = critical_states(&points, &Control::Force, &mut states);
        assert_eq!(refused, Err(Error::Length { quantity, len: 8, expected: 9 }));
    }
    let error = Error::Length { quantity: Quantity::Force, len: 8, expected: 9 };
    assert_eq!(error.to_string(), "the normal force F: 8 given for 9 points");
    let mut none = Answers { values: [(); 4].map(|()| vec![]), status: vec![], tally: BatchReport::default() };
    let [kappa, contact_radius, indentation, force] = &mut none.values;
    let mut states = States { kappa, contact_radius, indentation, force, status: &mut none.status };
    let gel = Material::new(1e4, 0.05).unwrap();
    let points = Points { exponent: &[], coefficient: &[], material: Materials::One(&gel) };
    let machine = Control::Machine { stiffness: -1.0 };
    assert!(matches!(critical_states(&points, &machine, &mut states), Err(Error::Domain { .. })));
}
