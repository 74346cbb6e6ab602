//! Gaps from bounds of g on cells against the gap by integrals over f.

use std::sync::Arc;

use mdr_core::contact::{Control, Material};
use mdr_core::number::Real;

use super::super::continuation::Continuation;
use super::super::overlap::Outside;
use super::*;
use crate::contact::Contact;
use crate::table::Table;

/// Rows with bumps, of which some would touch a contact within.
pub(crate) fn bumpy() -> Table {
    let row = |i: i32| {
        let r = 0.1 * f64::from(i);
        format!("{r:.3},{:.6}\n", r * r / 2.0 * (1.0 + 0.2 * (1.3 * f64::from(i)).sin()))
    };
    let rows: String = (0..14).map(row).collect();
    Table::from_csv(format!("r,f\n{rows}").as_bytes()).expect("a table")
}

/// Its transform in doubles and in bits.
fn bounded() -> [Bounded; 2] {
    let in_doubles = bumpy().profile::<DoubleInterval>(()).expect("a table");
    let in_bits = bumpy().profile::<Interval>(Precision::new(BITS)).expect("a table");
    [Bounded::InDoubles(Arc::new(in_doubles)), Bounded::InBits(Arc::new(in_bits))]
}

struct Case {
    contact: Contact<Interval>,
    profile: Continuation,
    /// In doubles and in bits.
    staircases: [Staircases; 2],
}

impl Case {
    fn new() -> Self {
        let precision = Precision::new(BITS);
        let [in_doubles, in_bits] = bounded();
        let profile = bumpy().profile::<Interval>(precision).expect("a table");
        let formula = profile.enclosed();
        let number = |x: f64| Interval::from_f64(precision, x);
        let material = Material::new(number(1.0), number(1e-4)).expect("positive");
        let contact = Contact::half_space(&Arc::new(profile), &material, &Control::Indentation);
        let profile = Continuation::new(vec![formula]).expect("kinks in order");
        let staircases = [in_doubles, in_bits].map(|bounded| Staircases::new(bounded, |radii| profile.range(radii)));
        Case { contact, profile, staircases }
    }

    /// A state of equilibrium, pressed deeper by a length.
    fn place(&self, a: f64, deeper: f64) -> Place {
        let a = Interval::from_f64(Precision::new(BITS), a);
        let d = self.contact.indentation(&a).expect("within the table") + &Interval::from_f64(a.ctx(), deeper);
        Place { a, d }
    }

    fn gap(&self, place: &Place, r: f64) -> Interval {
        let [gap, ..] = Outside::new(&self.contact, &self.profile)
            .gap(place, &Interval::from_f64(place.a.ctx(), r))
            .expect("within the table");
        gap
    }
}

const STATES: [[f64; 2]; 3] = [[0.25, 0.0], [0.53, -0.01], [0.61, 0.02]];

#[test]
fn bounds_hold_the_gap_by_integrals_over_f() {
    let case = Case::new();
    for ([a, deeper], staircases) in
        STATES.into_iter().flat_map(|state| case.staircases.iter().map(move |one| (state, one)))
    {
        let place = case.place(a, deeper);
        let mut narrowest = f64::INFINITY;
        for level in 0..LEVELS.len() - 1 {
            let stair = staircases.stair(level, State::of(&place));
            let (first, d) = (stair.first().expect("beyond the tip"), stair.state.d[1]);
            let mut widest = 0f64;
            for share in 1..10 {
                let r = a + (1.299 - a) * f64::from(share) / 10.0;
                let last = stair.cells.partition_point(|cell| cell.to < r);
                let gap = case.gap(&place, r);
                let below = stair.least([r, r], [first, last], |[least, _]| least - d);
                let most = stair.most(r).expect("bounded");
                assert!(*gap.upper() >= below && *gap.lower() <= most, "{a} {r}: {below:e} {gap} {most:e}");
                widest = widest.max(most - below);
            }
            assert!(widest < narrowest / 3.0, "{a}, level {level}: {widest:e} after {narrowest:e}");
            narrowest = widest;
        }
        assert!(narrowest < 4e-3, "{a}: {narrowest:e}");
    }
}

#[test]
fn cells_hold_g_up_to_their_ends() {
    let double = bumpy().profile::<f64>(()).expect("a table");
    let case = Case::new();
    for (profile, cell) in
        case.staircases.iter().flat_map(|one| one.cells(LEVELS[0]).into_iter().map(move |cell| (&one.transform, cell)))
    {
        if cell.from <= 0.05 {
            continue;
        }
        let [least, most] = cell.g(profile);
        for share in 0..=8 {
            let x = (cell.from + (cell.to - cell.from) * f64::from(share) / 8.0).min(1.3);
            let g = double.g(&x).expect("within the table");
            // Roundings of g, which is below 2.
            assert!(g >= least - 1e-14 && g <= most + 1e-14, "{x} after {}: {least} {g} {most}", cell.from);
        }
    }
}

/// Two steps: the sum of what they add, for the first r of a range and the last, whose lesser one is the bound but for the weights.
#[test]
fn weights_are_those_of_arcs() {
    let step = |ends: [f64; 2], g: f64| {
        let cell = Cell::new(ends, None);
        cell.bounds.set([g, g]).expect("not asked for");
        cell
    };
    let [transform, _] = bounded();
    let number = |x: f64| Interval::from_f64(Precision::new(BITS), x);
    let a = number(0.11).hull(&number(0.12));
    for heights in [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [2.0, -1.0], [-1.0, 2.0]] {
        let cells = [step([0.1, 0.2], heights[0]), step([0.2, 0.4], heights[1])];
        let stair = Stair {
            transform: &transform,
            cells: &cells,
            state: State::of(&Place { a: a.clone(), d: number(0.0) }),
            terms: 0,
        };
        for radii in [[0.2, 0.4], [0.21, 0.3], [0.25, 0.25], [0.35, 0.4]] {
            let exact = |r: f64, a: f64| {
                let arc = |from: f64, to: f64| (to / r).asin() - (from / r).asin();
                (heights[0] * arc(a, 0.2) + heights[1] * arc(0.2, r)) * std::f64::consts::FRAC_2_PI
            };
            let all = radii.iter().flat_map(|r| [exact(*r, 0.11), exact(*r, 0.12)]);
            let (truth, bound) = (all.fold(f64::INFINITY, f64::min), stair.least(radii, [0, 1], |[least, _]| least));
            // The radius of a cell is known to its width, and a sum takes the worst of each r.
            let room = if radii[0] < radii[1] && heights[0] * heights[1] != 0.0 { 3.0 } else { 0.3 };
            assert!(bound <= truth + 1e-15 && bound >= truth - room, "{heights:?} {radii:?}: {bound} {truth}");
        }
    }
}

#[test]
fn open_gaps_and_overlaps_are_told_apart() {
    let case = Case::new();
    for (a, open, overlap) in [(0.17, true, None), (0.6, false, Some(0.8)), (0.61, false, Some(0.8))] {
        let place = case.place(a, 0.0);
        let state = State::of(&place);
        let radii = (1..100).map(|share| a + (1.299 - a) * f64::from(share) / 100.0);
        let least = radii.map(|r| case.gap(&place, r).approx()).fold(f64::INFINITY, f64::min);
        assert_eq!(least > 0.0, open, "{a}: {least}");
        for staircases in &case.staircases {
            assert_eq!(staircases.are_open(state).0, open);
            let found = overlap.and_then(|r| staircases.overlap(state, r));
            assert_eq!(found.is_some(), overlap.is_some(), "{a}: {least}");
        }
    }
}

/// 1.3 is not a double: the last cell holds it, and is bounded by the formula of the last piece.
#[test]
fn the_end_of_the_profile_has_a_cell() {
    let case = Case::new();
    let end = Interval::from_int(Precision::new(BITS), 13).over(10);
    for staircases in &case.staircases {
        for count in LEVELS {
            let cells = staircases.cells(count);
            assert!(cells.windows(2).all(|pair| pair[0].to == pair[1].from));
            let last = cells.last().expect("cells");
            assert!(*end.lower() > last.from && *end.upper() <= last.to, "{} {}", last.from, last.to);
            let [least, most] = last.g(&staircases.transform);
            assert!(least.is_finite() && most.is_finite(), "{least} {most}");
        }
    }
    // Of which nothing is known: the gap is not decided.
    let [bounded, _] = bounded();
    let (blind, open) = (Staircases::new(bounded, |_| None), State::of(&case.place(0.17, 0.0)));
    assert!(case.staircases[0].are_open(open).0 && !blind.are_open(open).0);
}
