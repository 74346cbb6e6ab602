//! Statistics of residuals, and the names of products.
#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use super::*;

#[test]
fn products_are_written_as_in_a_formula() {
    let names = ["e_star", "work_of_adhesion", "radius"];
    let product = |exponents: [f64; 3]| product(&names, &DVector::from_column_slice(&exponents));
    assert_eq!(product([1.0, 0.0, 0.5]), "e_star * radius^(1/2)");
    assert_eq!(product([0.0, 1.0, 1.0]), "work_of_adhesion * radius");
    assert_eq!(product([-2.0, 1.0, -0.5]), "e_star^(-2) * work_of_adhesion * radius^(-1/2)");
}

#[path = "../normal/mod.rs"]
mod normal;

/// Of white noise on two legs one record in a hundred is below p = 0.01; of a filter that halves from row to row, whose integrated
/// correlation is √3, 99 of a hundred are.
#[test]
fn neighbours_of_white_noise_are_not_alike() {
    let mut noise = normal::Normal(7);
    let records = 4000;
    let judged = |residuals: &[f64]| autocorrelation(&[&residuals[..60], &residuals[60..]], 120).unwrap();
    let white: Vec<f64> = (0..records).map(|_| judged(&[0.0; 120].map(|_| noise.next())).p).collect();
    let share = white.iter().filter(|p| **p < 0.01).count() as f64 / f64::from(records);
    assert!((0.005..0.015).contains(&share), "{share}");
    let (mut widening, mut found_out) = (0.0, 0);
    for _ in 0..records {
        let mut last = 0.0;
        let filtered = [0.0; 120].map(|_| {
            last = 0.5 * last + noise.next();
            last
        });
        let found = judged(&filtered);
        found_out += usize::from(found.p < 0.01);
        widening += found.widening / f64::from(records);
    }
    assert!(found_out as f64 > 0.99 * f64::from(records), "{found_out}");
    assert!((widening / 3f64.sqrt() - 1.0).abs() < 0.1, "{widening}");
}

/// Residuals of a fit of two numbers are less alike than white noise, which is allowed for.
#[test]
fn numbers_that_were_fitted_are_allowed_for() {
    let mut noise = normal::Normal(11);
    let records = 4000;
    let mut below = 0;
    for _ in 0..records {
        let y = [0.0; 40].map(|_| noise.next());
        let x = |index: usize| index as f64 - 19.5;
        let mean = y.iter().sum::<f64>() / 40.0;
        let slope = y.iter().enumerate().map(|(index, y)| x(index) * y).sum::<f64>()
            / (0..40).map(|index| x(index).powi(2)).sum::<f64>();
        let residuals: Vec<f64> = y.iter().enumerate().map(|(index, y)| y - mean - slope * x(index)).collect();
        below += usize::from(autocorrelation(&[&residuals], 38).unwrap().p < 0.01);
    }
    let share = below as f64 / f64::from(records);
    assert!((0.004..0.016).contains(&share), "{share}");
}

#[test]
fn alternating_signs_are_no_noise() {
    let residuals: Vec<f64> = (0..40).map(|index| if index % 2 == 0 { 1.0 } else { -1.0 }).collect();
    assert!(runs_test(&residuals).is_some_and(|test| test.runs == 40 && test.p < 1e-8));
}

/// A decomposition ends for every matrix: an entry that is not finite is a typed nothing, never an iteration for ever.
#[test]
fn no_matrix_holds_a_fit_for_ever() {
    let sound = DMatrix::from_fn(5, 3, |row, column| ((row + 1) as f64).powi(column as i32));
    let right = DVector::from_element(5, 1.0);
    let solved = least_squares(sound.clone(), &right, 1e-12).unwrap();
    assert!((&sound * solved - &right).norm() < 1e-12);
    for entry in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..15 {
            let mut matrix = sound.clone();
            matrix[place] = entry;
            assert_eq!(least_squares(matrix.clone(), &right, 1e-12), None);
            let spectrum = Spectrum::new(matrix.clone());
            assert_eq!(spectrum.nullity(), 3);
            assert_eq!(spectrum.undetermined(), [true; 3]);
        }
    }
    for scale in [f64::MIN_POSITIVE * f64::EPSILON, 1e-300, 1e150, 1e300, f64::MAX / 1e4] {
        let spectrum = Spectrum::new(&sound * scale);
        assert!(spectrum.nullity() == 0 || spectrum.undetermined().contains(&true), "{scale}");
    }
}
