//! Double precision beside numpy and scipy.

use std::cell::RefCell;
use std::hint::black_box;

use mdr_analytic::double::Inverse;
use mdr_analytic::double::grid::{Materials, Points, States, critical_states};
use mdr_core::contact::{Control, Equilibrium, Material, Ranged, Result, Status};
use mdr_core::number::{Interval, Precision, Real};

use super::super::outside::question;
use super::super::precision::{Found, truth};
use super::super::{Arithmetic, Effort};
use super::{Hall, Lane};

/// Points of a batch whose arrays stay in the caches of a processor.
const BATCH: usize = 4096;

/// Arrays of so many points, in batches and at once.
pub(super) fn grids(hall: &mut Hall<'_>, effort: Effort) {
    let counts: &[usize] = if effort == Effort::Full { &[100_000, 1_000_000] } else { &[100_000] };
    for &count in counts {
        for batch in [BATCH, count] {
            hall.outsiders.begin();
            grid(hall, count, batch);
        }
    }
}

/// κ, a, d, F in f64 over the points n = 0.8 + 1.2 t, C = 1 + t. Both sides read whole arrays and write arrays of a batch.
fn grid(hall: &mut Hall<'_>, count: usize, batch: usize) {
    let picked = [0, count / 3, count - 1];
    let (e, w) = (1e4, 0.05);
    let Ok(material) = Material::new(e, w) else { return };
    let at = |i: usize| {
        let t = i as f64 / count as f64;
        (0.8 + 1.2 * t, 1.0 + t)
    };
    let (exponent, coefficient): (Vec<f64>, Vec<f64>) = (0..count).map(at).unzip();
    let truths: Vec<Interval> = picked.iter().filter_map(|&i| critical_truth(at(i), e, w)).flatten().collect();
    let table = RefCell::new(([(); 4].map(|()| vec![0.0; batch]), vec![Status::Ok; batch]));
    let solver = || {
        let (columns, statuses) = &mut *table.borrow_mut();
        let mut found = Vec::with_capacity(4 * picked.len());
        for (begin, n) in (0..).step_by(batch).zip(exponent.chunks(batch)) {
            let points = Points {
                exponent: n,
                coefficient: &coefficient[begin..begin + n.len()],
                material: Materials::One(&material),
            };
            let [kappa, contact_radius, indentation, force] = columns.each_mut().map(|column| &mut column[..n.len()]);
            let status = &mut statuses[..n.len()];
            let mut states = States { kappa, contact_radius, indentation, force, status };
            critical_states(&points, &Control::Indentation, &mut states)?;
            for i in picked.into_iter().filter(|i| (begin..begin + n.len()).contains(i)) {
                found.extend(columns.each_ref().map(|column| Found::Double(column[i - begin])));
            }
        }
        Ok(found)
    };
    let asked = question! {
        "ask": "grid", "by": "scipy", "count": count, "batch": batch, "e": e.to_string(), "w": w.to_string(),
        "picked": picked,
    };
    let how = if batch < count { format!("in batches of {batch}") } else { "at once".to_owned() };
    let race = hall.race(&Lane {
        question: "κ, a, d and F in f64, time a point",
        setting: &format!("{count} points {how}"),
        ours: "double::grid",
        solver: &solver,
        theirs: ("numpy arrays and Γ", "scipy", asked),
        arithmetic: Arithmetic::Double,
        truths: &truths,
        whole: true,
        fresh: false,
        count,
        aim: Some(4.0),
    });
    hall.keep(vec![race]);
}

/// Both equilibria of a paraboloid under tension, the critical radius being known to both sides.
pub(super) fn equilibria(hall: &mut Hall<'_>) {
    let truths = jkr_radii();
    let ball = Material::new(1.0, 1.0).and_then(|glue| Inverse::new(2.0, 0.5, &glue, &Control::Indentation));
    let Ok(ball) = ball else { return };
    let value = |x: &Ranged<f64>| match x {
        Ranged::Value(value) => *value,
        _ => f64::NAN,
    };
    let solver = || -> Result<Vec<Found>> {
        let found = ball.equilibria(black_box(-0.5))?;
        let radius = |state: &Equilibrium<Ranged<f64>>| Found::Double(value(&state.contact_radius));
        Ok(found.as_slice().iter().map(radius).collect())
    };
    let asked = question! {
        "ask": "equilibria", "by": "brentq", "n": "2", "c": "1/2", "e": "1", "w": "1", "d": "-1/2",
    };
    let race = hall.race(&Lane {
        question: "both equilibria at a given d in f64",
        setting: "n = 2",
        ours: "double::Inverse",
        solver: &solver,
        theirs: ("brentq", "scipy", asked),
        arithmetic: Arithmetic::Double,
        truths: &truths,
        whole: true,
        fresh: false,
        count: 1,
        aim: None,
    });
    hall.keep(vec![race]);
}

/// The critical state under fixed grips for doubles.
fn critical_truth((n, c): (f64, f64), e: f64, w: f64) -> Option<[Interval; 4]> {
    let [n, c, e, w] = [n, c, e, w].map(|value| Interval::from_f64(Precision::new(256), value));
    truth::critical(&n, truth::kappa_of(&n), [c, e, w]).try_into().ok()
}

/// Both roots of a² − √(2πa) = −1/2, by bisection over intervals.
fn jkr_radii() -> Vec<Interval> {
    let fraction = |p: i64, q: i64| Interval::from_int(Precision::new(256), p).over(q);
    let above = |a: &Interval| a.square() + a.ratio(1, 2) > (a.pi() * a).times(2).sqrt();
    let root = |mut one: Interval, mut other: Interval| {
        let side = above(&one);
        for _ in 0..200 {
            let middle = (one.clone() + &other).over(2);
            if above(&middle) == side { one = middle } else { other = middle }
        }
        one.hull(&other)
    };
    vec![root(fraction(1, 1000), fraction(1, 2)), root(fraction(1, 1), fraction(2, 1))]
}

#[cfg(test)]
mod tests {
    use rug::Float;

    use super::*;

    #[test]
    fn the_radii_are_enclosed() {
        let radii = jkr_radii();
        for a in &radii {
            let residual = a.square() - (a.pi() * a).times(2).sqrt() + a.ratio(1, 2);
            assert!(residual.contains_zero() && a.accuracy_bits() > 180);
        }
        assert!(radii[0] < radii[1]);
    }

    #[test]
    fn the_grid_is_judged_by_the_equations_of_equilibrium() {
        let truth = critical_truth((2.0, 0.5), 1.0, 1.0).unwrap();
        // a³ = πwR²/(8E*), F = −(5/6)πwR.
        let (pi, a) = (truth[0].pi(), truth[1].clone());
        assert!(a.powi(3).overlaps(&pi.clone().over(8)) && truth[0].contains(&Float::with_val(53, 2)));
        assert!(truth[3].overlaps(&pi.times(-5).over(6)) && truth[3].accuracy_bits() > 200);
    }
}
