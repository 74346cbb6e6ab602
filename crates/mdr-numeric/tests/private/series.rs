//! Tests of the private items of `mdr_numeric::table::series`.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use mdr_core::contact::Transform;
use mdr_core::number::{Dual, Interval, Precision, Special};
use rug::Float;

use super::super::MeasuredProfile;
use super::super::arc::Spoke;
use super::*;

/// Rows at uneven distances, with noise: moments of both signs.
fn rough<R: Special>(ctx: R::Ctx, rows: i64) -> MeasuredProfile<R> {
    let number = |k: i64, n: i64| R::from_int(ctx, k).over(n);
    let row = |i: i64| (number(10 * i + (i * i) % 7, 300), number(i * i * 40 + 31 * ((i * 73) % 11), 100_000));
    MeasuredProfile::new((0..rows).map(row).collect()).unwrap()
}

/// The sum over pieces, each by itself.
fn directly<R: Special>(pieces: &[Piece<R>], part: Part, x: &R) -> R {
    let share = |piece: &Piece<R>| {
        let end = piece.start.clone() + &piece.width;
        piece.share(part, x, &Spoke::new(&piece.start, x), &Spoke::new(&end, x), &x.lit(1))
    };
    pieces.iter().map(share).reduce(|sum, share| sum + share).unwrap()
}

const PARTS: [Part; 3] = [Part::Value, Part::Slope, Part::Integral];

/// Clusters of each size at their least distance and far away, at points and on cells, truncated early and late: each
/// enclosure holds what the pieces give in four times the bits, and is no wider than its accuracy.
#[test]
fn a_cluster_encloses_its_pieces() {
    let [coarse, fine] = [100, 400].map(Precision::new);
    let (profile, exact) = (rough::<Interval>(coarse, 50), rough::<Interval>(fine, 50));
    let tree = Tree::new(&profile.pieces, terms(100, BITS_PER_TERM));
    for (first, size) in [(0, 8), (8, 8), (16, 16), (0, 32)] {
        let pieces = &exact.pieces[first..first + size];
        let reach = profile.pieces[first + size].start.clone() - &profile.pieces[first].start;
        for (tenths, bits, width) in [(30, 100, 0), (30, 9, 0), (31, 40, 0), (90, 100, 0), (31, 12, 10), (50, 30, 24)] {
            let centre = reach.clone().times(tenths).over(10) + &profile.pieces[first].start;
            // Just beyond the least distance, so that it is certain.
            let centre = Interval::point(centre.mid()) * (centre.lit(1) + centre.lit(2).powi(-90));
            let half = if width == 0 { centre.lit(0) } else { centre.lit(2).powi(-width) * &centre };
            let x = Interval::point(centre.mid()).inflate(&half);
            for part in PARTS {
                let Some((share, after)) = tree.share(part, &x, bits, first, first + size) else {
                    panic!("{first} {size} {tenths}: not far");
                };
                assert_eq!(after, first + size);
                for at in [x.lower(), &x.mid(), x.upper()] {
                    let sum = directly(pieces, part, &Interval::point(Float::with_val(400, at)));
                    assert!(share.contains(&sum.mid()), "{part:?} {first} {size} {tenths} {bits}: {share} {sum}");
                }
                // The remainder, the width of x and sixteen roundings for each term of the bound of ∫ |ρ| dθ, beside what the
                // roundings of the rows themselves make uncertain.
                let level = (size / LEAF).ilog2() as usize;
                let cluster = &tree.levels[level][first / size];
                let (_, variation) = if part == Part::Slope { &cluster.bend } else { &cluster.slope };
                let root = ((x.clone() - &cluster.start) * (x.clone() + &cluster.start)).sqrt();
                let scale = if part == Part::Integral { root / x.square() } else { root.lit(1) / root };
                let given = directly(&profile.pieces[first..first + size], part, &Interval::point(x.mid())).radius();
                let relative = f64::exp2(-f64::from(bits))
                    + 16.0 * half.approx() / x.approx()
                    + 16.0 * terms(100, BITS_PER_TERM) as f64 * f64::exp2(-100.0);
                let most = Interval::point(variation.upper().clone());
                let allowed = 16.0 * given.to_f64() + (most * scale).approx() * relative;
                assert!(
                    share.radius().to_f64() < allowed,
                    "{part:?} {first} {size} {tenths} {bits}: {share} {allowed:e}"
                );
            }
        }
    }
}

/// A remainder that is left out is noticed: at few bits the true value lies away from the truncated sum.
#[test]
fn a_truncated_series_differs_from_its_sum() {
    let precision = Precision::new(100);
    let profile = rough::<Float>(precision, 50);
    let tree = Tree::new(&profile.pieces, terms(100, BITS_PER_TERM));
    let x = profile.pieces[8].start.clone() * 3.5;
    let (share, _) = tree.share(Part::Value, &x, 9, 0, 8).unwrap();
    let sum = directly(&profile.pieces[..8], Part::Value, &x);
    let error = ((share - &sum) / &sum).abs().approx();
    assert!(error > 1e-8, "{error:e}");
}

/// With derivatives: the slope of an enclosure over a cell holds the difference quotients there.
#[test]
fn slopes_are_enclosed() {
    let precision = Precision::new(100);
    let profile = rough::<Dual<Interval>>(precision, 50);
    let exact = rough::<Interval>(precision, 50);
    let tree = Tree::new(&profile.pieces, terms(100, BITS_PER_TERM));
    let start = exact.pieces[16].start.clone();
    for bits in [7, 12, 100] {
        let (low, high) = (start.clone().times(4), start.clone().times(4) + start.clone().over(1 << 8));
        let cell = Dual::variable(low.hull(&high));
        for part in PARTS {
            let (share, _) = tree.share(part, &cell, bits, 0, 16).unwrap();
            let at = |x: &Interval| directly(&exact.pieces[..16], part, &Interval::point(x.mid()));
            let quotient = (at(&high) - at(&low)) / (high.clone() - &low);
            assert!(share.slope.contains(&quotient.mid()), "{part:?} {bits}: {} {quotient}", share.slope);
        }
    }
}

/// The transform with and without the tree, for floating numbers and enclosures, everywhere.
#[test]
fn the_tree_changes_no_digit() {
    let precision = Precision::new(160);
    let (with, without) = (rough::<Float>(precision, 200), rough::<Float>(precision, 200));
    let enclosed = rough::<Interval>(precision, 200);
    assert!(with.series.tree.set(Tree::new(&with.pieces, terms(160, BITS_PER_TERM))).is_ok());
    assert!(enclosed.series.tree.set(Tree::new(&enclosed.pieces, terms(160, BITS_PER_TERM))).is_ok());
    let wide = rough::<Float>(Precision::new(600), 200);
    for k in 1..12 {
        let x = Float::with_val(160, &with.end * (k * k * k)) / 1728;
        let exact = Float::with_val(600, &x);
        for part in 0..3 {
            let of = |profile: &MeasuredProfile<Float>, x: &Float| match part {
                0 => profile.g(x),
                1 => profile.slope(x),
                _ => profile.integral(x),
            };
            let (one, other, exact) = (of(&with, &x).unwrap(), of(&without, &x).unwrap(), of(&wide, &exact).unwrap());
            let size = Float::with_val(160, exact.abs_ref());
            // The bound of `MeasuredProfile`, for which r/Δr and the noise count.
            let allowed = size * f64::exp2(-160.0) * 32.0 * 4e4;
            for value in [&one, &other] {
                assert!(Float::with_val(160, value - &exact).abs() <= allowed, "{part} at {k}: {value} {exact}");
            }
            let x = Interval::point(x.clone());
            let holds = match part {
                0 => enclosed.g(&x),
                1 => enclosed.slope(&x),
                _ => enclosed.integral(&x),
            };
            let holds = holds.unwrap();
            assert!(holds.contains(&exact), "{part} at {k}: {holds} {exact}");
            // The moments widen an enclosure by some roundings for each of their hundred terms.
            let (radius, allowed) = (holds.radius(), allowed * 16);
            assert!(radius <= allowed, "{part} at {k}: {radius} {allowed}");
        }
    }
}

/// Rows of one height, of which all moments are zero: the slope of an absolute value at zero is bounded, and so is that of g.
#[test]
fn a_level_stretch_has_a_bounded_slope() {
    let precision = Precision::new(64);
    let height = |i: i64| if i == 0 { 0 } else { 3 + (i - 6).max(0) };
    let number = |n: i64| Dual::constant(Interval::from_int(precision, n));
    let profile = MeasuredProfile::new((0..=45).map(|i| (number(i), number(height(i)))).collect()).unwrap();
    let tree = Tree::new(&profile.pieces, terms(64, BITS_PER_TERM));
    let x = Dual::variable(Interval::from_int(precision, 30));
    for part in PARTS {
        let (share, after) = tree.share(part, &x, 64, 0, 30).unwrap();
        assert!(after >= 8 && share.value.is_finite() && share.slope.is_finite(), "{part:?}");
    }
}
