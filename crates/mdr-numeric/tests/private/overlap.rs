//! The gap and its slopes against the gap of fields, and the loss of admissibility at few bits.

use std::sync::Arc;

use mdr_core::contact::{Budget, Control, Expression, Material};
use rug::Float;

use super::super::energy::all_over_unit_interval;
use super::super::fields::Kernel;
use super::super::squares::tests::Dropped;
use super::*;
use crate::proof::{EnclosedFields, EnclosedGaps};
use crate::transform::Enclosed;

struct Case {
    contact: Contact<Interval>,
    profile: Continuation,
}

fn case(formula: &str, work: &str, bits: u32) -> Case {
    let (formula, none): (Expression, _) = (formula.parse().expect("a formula"), Default::default());
    let precision = Precision::new(bits);
    let breaks = formula.breaks(&none).expect("known kinks");
    let bound = || formula.enclosed(&none, &breaks, precision).expect("no names");
    let transform = Arc::new(Enclosed::new(bound(), precision));
    let number = |text: &str| Interval::from_literal(precision, &text.parse().expect("a number"));
    let material = Material::new(number("1"), number(work)).expect("positive");
    let contact = Contact::half_space(&transform, &material, &Control::Indentation);
    Case { contact, profile: Continuation::new(vec![bound()]).expect("kinks in order") }
}

/// A kink that opens, and the paraboloid beyond it; a smooth dip; a dip with a kink at its lowest point.
const CASES: [(&str, &str, [f64; 2]); 3] = [
    ("r^2/2 - 0.1*max(0, r - 0.1)", "1e-6", [0.0922972, 0.12309]),
    ("r^2/2 - 0.1*r^2*exp(-((r - 0.5)/0.1)^2)*20", "1e-6", [0.2, 0.5]),
    ("r^2/2 + 0.2*abs(r - 0.5) - 0.1", "1e-6", [0.3, 0.5]),
];

#[test]
fn the_gap_and_its_slopes_are_those_of_fields() {
    for (formula, work, [a, r]) in CASES {
        let (coarse, fine) = (case(formula, work, 64), case(formula, work, 160));
        let of = |case: &Case, r: &Interval| {
            let outside = Outside::new(&case.contact, &case.profile);
            let place = outside.equilibrium(Interval::from_f64(r.ctx(), a)).expect("a state");
            outside.gap(&place, r).expect("a gap")
        };
        let radius = |bits: u32, shift: f64| Interval::from_f64(Precision::new(bits), (r + 0.03) * (1.0 + shift));
        let (few, many) = (of(&coarse, &radius(64, 0.0)), of(&fine, &radius(160, 0.0)));
        for (few, many) in few.iter().zip(&many) {
            assert!(few.overlaps(many) && few.accuracy_bits() > 40, "{formula}: {few} without {many}");
        }
        let state = fine.contact.state(&Interval::from_f64(Precision::new(160), a)).expect("a state");
        let state = Equilibrium {
            contact_radius: Interval::from_f64(Precision::new(160), a),
            indentation: state.0,
            force: state.1,
            stability: Stability::Stable,
        };
        let fields = EnclosedFields::new(&fine.contact, &fine.profile, &state).expect("a state");
        let [before, at, after] = [-1e-12, 0.0, 1e-12].map(|shift| fields.gap(&radius(160, shift)).expect("a gap"));
        assert!(at.overlaps(&many[0]), "{formula}: {at} and {}", many[0]);
        let step = (radius(160, 1e-12) - radius(160, -1e-12)).over(2);
        let slope = ((after.clone() - &before) / &step).over(2);
        let bend = (after + before - at.times(2)) / step.square();
        for (difference, proved) in [(slope, &many[1]), (bend, &many[2])] {
            let off = (difference.approx() - proved.approx()).abs();
            assert!(off <= 1e-6 * (1.0 + proved.approx().abs()), "{formula}: {difference} and {proved}");
        }
    }
}

#[test]
fn a_dropped_remainder_of_a_moment_is_caught_at_few_bits() {
    let of = |bits: u32, drop: bool| {
        let Case { profile, .. } = case("r^2/2 + 5e-4*(1 - cos(20*pi*r))", "1", bits);
        let one = Interval::from_int(Precision::new(bits), 1);
        let (a, c, zero) = (one.ratio(3, 10), one.ratio(1, 10), one.lit(0));
        let width = one.pi().over(2);
        let kernel = Kernel { profile: &profile, a: &a, c: &c, order: 2, beyond: 0, from: zero, width };
        let found =
            if drop { all_over_unit_interval(&Dropped(kernel), bits) } else { all_over_unit_interval(&kernel, bits) };
        found.expect("integrals")
    };
    let truth = of(200, false);
    let all = |bits: u32, drop: bool| of(bits, drop).iter().zip(&truth).all(|(found, truth)| found.overlaps(truth));
    assert!((10..30).all(|bits| all(bits, false)));
    assert!((10..30).any(|bits| !all(bits, true)));
}

#[test]
fn admissibility_is_lost_where_the_gap_closes() {
    let kinked = case(CASES[0].0, CASES[0].1, 100);
    let outside = Outside::new(&kinked.contact, &kinked.profile);
    let (state, ring) = outside.last_admissible([0.0923, 0.123]).expect("a proof");
    // The gap and its slope are nothing there, by the fields of a contact a little smaller and a little larger.
    let fine = case(CASES[0].0, CASES[0].1, 200);
    let gap = |shift: f64| {
        let factor = Float::with_val(200, 1) + shift;
        let contact_radius = Interval::point(factor * state.contact_radius.mid());
        let (indentation, force) = fine.contact.state(&contact_radius).expect("a state");
        let state = Equilibrium { contact_radius, indentation, force, stability: Stability::Stable };
        let fields = EnclosedFields::new(&fine.contact, &fine.profile, &state).expect("a state");
        fields.gap(&Interval::point(Float::with_val(200, ring.radius.mid()))).expect("a gap")
    };
    assert!(gap(-1e-16).lower() > &0 && gap(1e-16).upper() < &0);
    assert!(state.contact_radius.accuracy_bits() > 60 && ring.radius.accuracy_bits() > 40);
    for (found, published) in
        [(&state.contact_radius, 0.0922972), (&state.indentation, 0.00775725), (&ring.radius, 0.12309)]
    {
        assert!((found.approx() / published - 1.0).abs() < 1e-4, "{found}");
    }
    // The same state at few bits holds the truth.
    let coarse = case(CASES[0].0, CASES[0].1, 64);
    let outside = Outside::new(&coarse.contact, &coarse.profile);
    let (few, _) = outside.last_admissible([0.0923, 0.123]).expect("a proof");
    assert!(few.contact_radius.overlaps(&state.contact_radius));
    assert!(few.contact_radius.accuracy_bits() < state.contact_radius.accuracy_bits());
}

#[test]
fn a_narrow_dip_elsewhere_is_not_passed_over() {
    // A second dip closes first: the ring at 0.5 is no loss while the surfaces overlap at 0.8.
    let formula = "r^2/2 - 0.05*exp(-((r - 0.5)/0.05)^2) - 0.4*exp(-((r - 0.8)/0.001)^2) \
                   + 0.05*exp(-(0.5/0.05)^2) + 0.4*exp(-(0.8/0.001)^2)";
    let dips = case(formula, "1e-6", 80);
    let outside = Outside::new(&dips.contact, &dips.profile);
    assert!(outside.last_admissible([0.29, 0.5]).is_err());
    let one = case("r^2/2 - 0.05*exp(-((r - 0.5)/0.05)^2) + 0.05*exp(-(0.5/0.05)^2)", "1e-6", 80);
    let outside = Outside::new(&one.contact, &one.profile);
    assert!(outside.last_admissible([0.29, 0.5]).is_ok());
}

#[test]
fn the_last_admissible_state_beside_a_dip_is_proved() {
    let dip = case("r^2/2 - 0.3*r^2*exp(-((r - 0.5)/0.1)^2)", "1e-6", 100);
    let outside = Outside::new(&dip.contact, &dip.profile);
    // From approximations of a thousandth.
    let (state, ring) = outside.last_admissible([0.2531, 0.4885]).expect("a proof");
    assert!(state.contact_radius.accuracy_bits() > 60 && ring.radius.accuracy_bits() > 40);
    assert!(!outside.overlaps(&Interval::from_f64(Precision::new(100), 0.253), 0.488).expect("a gap"));
    assert!(outside.overlaps(&Interval::from_f64(Precision::new(100), 0.254), 0.488).expect("a gap"));
}

#[test]
fn verdicts_hold_up_to_the_state_in_which_the_gap_closes() {
    let dip = "r^2/2 - 0.3*r^2*exp(-((r - 0.5)/0.1)^2)";
    for (formula, work, rough) in [(CASES[0].0, CASES[0].1, [0.0923, 0.123]), (dip, "1e-6", [0.2531, 0.4885])] {
        let Case { contact, profile } = case(formula, work, 100);
        let (state, ring) = Outside::new(&contact, &profile).last_admissible(rough).expect("a proof");
        let gaps = EnclosedGaps::new(contact.clone(), Some(profile)).expect("a half-space");
        let beside = |shift: f64| {
            let a = Interval::point(Float::with_val(100, state.contact_radius.mid() * (1.0 + shift)));
            let d = contact.indentation(&a).expect("a state");
            [gaps.are_open(&a, &d), gaps.is_closed(&a, &d, ring.radius.approx())]
        };
        for shift in [1e-9, 1e-6, 1e-3] {
            assert_eq!((beside(-shift), beside(shift)), ([true, false], [false, true]), "{formula}, {shift}");
        }
        // An enclosure that holds states of both kinds is neither.
        let both = state.contact_radius.clone().inflate(&Interval::from_f64(Precision::new(100), 1e-9));
        let d = contact.indentation(&both).expect("states");
        assert!(!gaps.are_open(&both, &d) && !gaps.is_closed(&both, &d, ring.radius.approx()), "{formula}");
    }
}

/// A fold may be at a kink: the contact ends there, and f is one part or the next.
#[test]
fn gaps_of_a_contact_that_ends_at_a_kink_are_enclosed() {
    let of = |a: &str, bits: u32| {
        let Case { contact, profile } = case(CASES[0].0, CASES[0].1, bits);
        let number = |text: &str| Interval::from_literal(Precision::new(bits), &text.parse().expect("a number"));
        let place = Place { a: number(a), d: number("0.0092") };
        let outside = Outside::new(&contact, &profile);
        let [gap, slope, bend] = outside.gap(&place, &number("0.128")).expect("a gap");
        let gaps = EnclosedGaps::new(contact.clone(), Some(case(CASES[0].0, CASES[0].1, bits).profile));
        let is_closed = gaps.expect("a half-space").is_closed(&place.a, &place.d, 0.128);
        ([gap, slope, bend], is_closed)
    };
    let (at_kink, is_closed) = of("0.1", 64);
    assert!(is_closed && at_kink[0].accuracy_bits() > 20, "{}", at_kink[0]);
    let [(inside, _), (outside, _)] = ["0.099999999999999999999999", "0.100000000000000000000001"].map(|a| of(a, 160));
    for (found, (inside, outside)) in at_kink.iter().zip(inside.iter().zip(&outside)) {
        assert!(found.overlaps(inside) && found.overlaps(outside), "{found}, {inside}, {outside}");
    }
}

/// Outputs ask of one state again, and of it in more bits: what was decided is known, and what the budget left open is asked again.
#[test]
fn a_state_is_looked_at_once() {
    let Case { contact, profile } = case("r^2/2 + 0.01*(1 - cos(20*pi*r))", "1e-6", 64);
    let number = |x: f64| Interval::from_f64(Precision::new(64), x);
    let budget = Arc::new(Budget::default());
    let gaps = EnclosedGaps::new(contact.clone(), Some(profile)).expect("a half-space").within(&budget, 1);
    let state = |a: Interval| (contact.indentation(&a).expect("a state"), a);
    let wide = number(0.01).inflate(&number(1e-15));
    budget.allow(1);
    let (d, a) = state(wide);
    assert!(!gaps.are_open(&a, &d), "one height is no proof");
    budget.allow(u64::MAX);
    assert!(gaps.are_open(&a, &d));
    let spent = budget.spent();
    assert!(spent > 1);
    let (d, a) = state(number(0.01));
    assert!(gaps.are_open(&a, &d));
    assert_eq!(budget.spent(), spent);
    let (d, a) = state(number(0.009));
    assert!(gaps.are_open(&a, &d));
    assert!(budget.spent() > spent, "another state");
}
