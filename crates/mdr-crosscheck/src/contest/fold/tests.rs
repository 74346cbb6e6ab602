//! The truth against other routes to it.

use mdr_core::number::Real;

use super::question::{QUESTIONS, Shape};

/// The closed form (1.15) in certified digits lies in the enclosure of the tangency, and the enclosure is tight.
#[test]
fn the_truth_is_the_closed_form_where_there_is_one() {
    for question in &QUESTIONS {
        let truth = question.truth();
        assert!(truth.iter().all(|value| value.accuracy_bits() > 90), "{}: {truth:?}", question.name);
        let Shape::Power { n, c } = question.shape else { continue };
        let number = |x: f64| mdr_core::number::Interval::from_f64(mdr_core::number::Precision::new(200), x);
        let profile = mdr_analytic::PowerLaw::new(number(n), number(c)).unwrap();
        let [e_star, work] = question.material.map(number);
        let material = mdr_core::contact::Material::new(e_star, work).unwrap();
        let contact = mdr_analytic::Contact::new(profile, material);
        let state = contact.critical(&mdr_core::contact::Control::Indentation).unwrap();
        assert!(state.contact_radius.overlaps(&truth[0]), "{}", question.name);
        assert!(state.indentation.overlaps(&truth[1]), "{}", question.name);
    }
}

/// The condition of a = (πw/(2E*N²))^(1/(2n−1)): 2/|2n−1| for C, half of that for w and for E*; n is the rest.
#[test]
fn the_condition_contains_that_of_the_scales() {
    for question in &QUESTIONS {
        let [radius, indentation] = question.conditions(&question.truth());
        assert!(radius.is_finite() && indentation.is_finite());
        if let Shape::Power { n, .. } = question.shape {
            assert!(radius > 4.0 / (2.0 * n - 1.0).abs(), "{}: {radius}", question.name);
        }
    }
}

/// The instability of the wavy paraboloid computed elsewhere, to seven digits.
#[test]
fn the_wavy_paraboloid() {
    let [radius, indentation] = QUESTIONS[4].truth();
    assert!((radius.approx() / 0.064_459_0 - 1.0).abs() < 1e-6, "{radius:?}");
    assert!((indentation.approx() / -0.001_848_03 - 1.0).abs() < 3e-6, "{indentation:?}");
}
