//! Tests of the private items of `mdr_numeric::table::far`.

use super::super::MeasuredProfile;
use super::super::arc::Spoke;
use super::*;
use mdr_core::number::Real;

/// The worst case: one step, the rest flat, at the smallest distance of a cluster. With one charge the
/// interpolation errors, which alternate in sign, do not cancel.
#[test]
fn a_cluster_acts_like_its_pieces() {
    for step in 0..2 * LEAF {
        let height = |i: usize| if i > step { 1.0 } else { 0.0 };
        let profile = MeasuredProfile::new((0..=3 * LEAF).map(|i| (i as f64, height(i))).collect()).unwrap();
        let far = profile.far.as_ref().unwrap();
        for size in [LEAF, 2 * LEAF] {
            let x = 2.0 * size as f64;
            let (cluster, after) = far.cluster(0, size, &x).unwrap();
            assert_eq!(after, size);
            let spoke = |r: f64| Spoke::new(&r, &x);
            let share = |piece: &Piece<f64>, part: Part| {
                piece.share(part, &x, &spoke(piece.start), &spoke(piece.start + 1.0), &1.0)
            };
            let sum = |part: Part| profile.pieces[..size].iter().map(|piece| share(piece, part)).sum::<f64>();
            let value = sum(Part::Value);
            for (part, magnitude) in
                [(Part::Value, value), (Part::Integral, sum(Part::Integral)), (Part::Slope, value * (step + 2) as f64)]
            {
                // Half of the stated bound for two levels.
                let (error, allowed) = ((far.share(cluster, part, &x) - sum(part)).abs(), 16.0 * x.unit_roundoff());
                assert!(error <= allowed * magnitude, "{part:?}, step {step} of {size}: {error:e} of {magnitude:e}");
            }
        }
    }
}
