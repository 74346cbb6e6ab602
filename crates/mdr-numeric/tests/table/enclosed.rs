//! Measured profiles over enclosures: they contain the results with many bits, and the folds of a table are proved.

use std::sync::Arc;

use mdr_core::contact::{Control, Error, FoldKind, Material, Result, Transform};
use mdr_core::number::{Dual, Interval, Precision, Real};
use mdr_numeric::contact::Contact;
use mdr_numeric::folds::folds;
use mdr_numeric::proof::{EnclosedCurve, ProvedBranches};
use mdr_numeric::table::{MeasuredProfile, Table};
use rug::Float;

/// A tip with a flat step, a reversal and rows that lie on a line: the cut of the slopes meets zeros, signs and ties.
const ROWS: &str =
    "r,f\nm,m\n0.1,0.005\n0.2,0.02\n0.3,0.045\n0.45,0.045\n0.6,0.03\n0.7,0.1\n0.8,0.17\n0.9,0.24\n1.1,0.5\n";

const BITS: u32 = 64;

fn table() -> Table {
    Table::from_csv(ROWS.as_bytes()).unwrap()
}

fn sharp() -> MeasuredProfile<Float> {
    table().profile(Precision::new(300)).unwrap()
}

fn enclosed<R: mdr_core::number::Special<Ctx = Precision>>() -> MeasuredProfile<R> {
    table().profile(Precision::new(BITS)).unwrap()
}

#[test]
fn cells_contain_their_points() {
    let sharp: MeasuredProfile<Dual<Float>> = table().profile(Precision::new(300)).unwrap();
    let enclosed = enclosed::<Dual<Interval>>();
    for octave in [3, 6, 10, 20, 40] {
        for start in [0.05, 0.11, 0.21, 0.33, 0.46, 0.62, 0.75, 0.81, 0.95, 1.05] {
            let [lower, width] = [start, start * 2f64.powi(-octave) * 0.1].map(|value| Float::with_val(BITS, value));
            let cell = Interval::new(lower.clone(), Float::with_val(BITS, &lower + &width));
            let x = Dual::variable(cell);
            let parts = [enclosed.g(&x), enclosed.slope(&x), enclosed.integral(&x)].map(Result::unwrap);
            for share in 0..=4 {
                let at = Float::with_val(300, &width * share) / 4 + &lower;
                let at = Dual::variable(at);
                let points = [sharp.g(&at), sharp.slope(&at), sharp.integral(&at)].map(Result::unwrap);
                for (part, point) in parts.iter().zip(points) {
                    assert!(part.value.contains(&point.value), "{start}, 2^-{octave}: {part:?} {point:?}");
                    assert!(part.slope.contains(&point.slope), "{start}, 2^-{octave}: {part:?} {point:?}");
                    assert!(part.value.accuracy_bits() >= i64::from(octave) - 8, "{start}, 2^-{octave}: {part:?}");
                }
            }
        }
    }
}

#[test]
fn rows_are_enclosed_from_both_sides() {
    let (sharp, enclosed) = (sharp(), enclosed::<Interval>());
    for (index, row) in sharp.kinks().iter().enumerate() {
        for octave in [5, 10, 20, 40] {
            let margin = Interval::from_int(Precision::new(BITS), 2).powi(-octave);
            let kink = enclosed.kink(index, &margin).unwrap().unwrap();
            let (g, mean) = kink.value.unwrap();
            assert!(g.contains(&sharp.g(row).unwrap()) && mean.contains(&sharp.mean(row).unwrap()), "row {index}");
            for share in [1, 3, 17, 1000, 1_000_000] {
                let step = Float::with_val(300, row >> octave as u32) / share;
                let below = sharp.slope(&Float::with_val(300, row - &step)).unwrap();
                let above = sharp.slope(&Float::with_val(300, row + &step)).unwrap();
                for (slopes, slope) in [(&kink.inside, below), (&kink.outside, above)] {
                    let bounds = slopes.least.clone().unwrap().hull(slopes.greatest.as_ref().unwrap());
                    assert!(bounds.contains(&slope), "row {index}, 2^-{octave}/{share}: {slope} in {bounds:?}");
                }
            }
        }
    }
}

/// A neighbourhood that reaches another row has no bounds.
#[test]
fn a_wide_neighbourhood_is_refused() {
    let profile = enclosed::<Interval>();
    let known = |part: i64| profile.kink(5, &Interval::from_int(Precision::new(BITS), 1).over(part)).unwrap().is_some();
    // The row at 0.7, a seventh of it from its neighbours at 0.6 and 0.8.
    assert!(known(8) && !known(7) && !known(4));
}

#[test]
fn a_row_is_not_straddled() {
    let profile = enclosed::<Interval>();
    let across = Interval::new(Float::with_val(BITS, 0.29), Float::with_val(BITS, 0.31));
    assert!(profile.g(&across).is_err());
    let beside = Interval::new(Float::with_val(BITS, 0.301), Float::with_val(BITS, 0.31));
    assert!(profile.g(&beside).is_ok());
}

#[test]
fn the_folds_of_a_table_are_proved() -> Result<()> {
    let precision = Precision::new(BITS);
    let number = |text: &str| Interval::from_literal(precision, &text.parse().unwrap());
    let (plain, moving) = (Arc::new(enclosed::<Interval>()), Arc::new(enclosed::<Dual<Interval>>()));
    let rough: Arc<MeasuredProfile<f64>> = Arc::new(table().profile(())?);
    for (work, control) in [("1e-3", true), ("1e-2", true), ("1e-3", false)] {
        let lift = Dual::constant;
        let material = Material::new(number("1"), number(work))?;
        let moving_material = Material::new(lift(number("1")), lift(number(work)))?;
        let (held, moving_held, rough_held) = if control {
            (Control::Indentation, Control::Indentation, Control::Indentation)
        } else {
            (Control::Force, Control::Force, Control::Force)
        };
        let curve = Contact::half_space(&plain, &material, &held);
        let moving = Contact::half_space(&moving, &moving_material, &moving_held);
        let [lower, upper] = [1e-3, 1.1].map(|end| Float::with_val(BITS, end));
        let proved = EnclosedCurve::new(curve, moving).folds(&lower, &upper, 1_000_000)?;
        assert!(proved.is_complete(), "{work}: {:?}", proved.undecided);
        assert!(proved.folds.windows(2).all(|pair| pair[0].kind != pair[1].kind));
        let found = folds(&rough, &Material::new(1.0, work.parse().unwrap())?, &rough_held)?;
        assert_eq!(found.len(), proved.folds.len(), "{work}");
        for (found, proved) in found.iter().zip(&proved.folds) {
            let a = proved.contact_radius.approx();
            assert!((found.contact_radius / a - 1.0).abs() < 1e-10 && found.kind == proved.kind, "{found:?}");
        }
        assert!(proved.folds.iter().any(|fold| fold.kind == FoldKind::Minimum));
    }
    Ok(())
}

/// The parts that a small budget leaves undecided are given in few digits, rounded outwards.
#[test]
fn a_refusal_names_the_undecided_part() -> Result<()> {
    let (plain, moving) = (Arc::new(enclosed::<Interval>()), Arc::new(enclosed::<Dual<Interval>>()));
    let material = Material::new(plain.kinks()[0].lit(1), plain.kinks()[0].lit(1))?;
    let moving_material = Material::new(moving.kinks()[0].lit(1), moving.kinks()[0].lit(1))?;
    let (held, moving_held) = (Control::Indentation, Control::Indentation);
    let curve = || {
        let moving = Contact::half_space(&moving, &moving_material, &moving_held);
        EnclosedCurve::new(Contact::half_space(&plain, &material, &held), moving)
    };
    let [lower, upper] = [1e-3, 1.1].map(|end| Float::with_val(BITS, end));
    let proved = curve().folds(&lower, &upper, 2)?;
    let (first, last) = &proved.undecided[0];
    let Err(Error::Unproved { from, to, .. }) = ProvedBranches::new(curve(), &proved) else { panic!("proved") };
    for (told, end, direction) in [(from, first, -1.0), (to, last, 1.0)] {
        let outwards = direction * (told.parse::<f64>().unwrap() / end.to_f64() - 1.0);
        assert!((0.0..1e-3).contains(&outwards) && told.len() <= 9, "{told} for {end}");
    }
    Ok(())
}
