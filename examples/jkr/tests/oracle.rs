//! The certified records as oracle of a solver.

use approx::assert_relative_eq;
use jkr_example::contact_radius;
use mdr_reference::{Answer, Filter, Status, judge, record};

/// One value: as close as the question allows.
#[test]
fn half_way_to_pull_off() {
    let known = record("equilibrium/jkr-unit/tau=2^-1/outer/indentation/contact_radius").expect("a record");
    let pull_off = record("critical/jkr-unit/indentation/indentation").expect("a record").nearest();
    let found = contact_radius(0.5, 1.0, 1.0, pull_off / 2.0).expect("a contact");
    assert_relative_eq!(found, known.nearest(), max_relative = known.tolerance());
}

/// All questions of a kind: sphere of unit size and tip of an atomic force microscope, from far beyond the adhesive range
/// to the fold and just past it.
#[test]
fn every_sphere_at_a_given_indentation() {
    let questions: Filter =
        "formula=equilibrium control=indentation quantity=contact_radius flag=outer".parse().expect("a filter");
    let spheres = questions.select().filter(|question| question.input("n") == Some("2"));
    let report = judge(spheres, |question| {
        let input = |name| question.input_f64(name);
        let radius = contact_radius(input("C")?, input("E*")?, input("w")?, input("d")?);
        Some(radius.map_or(Status::NoEquilibrium.into(), Answer::from))
    });
    assert!(report.passed() && report.unanswered() == 0, "{report}");
}
