//! The operator that proves a fit, where there is nothing to prove: boxes without a stationary point or with several, saddles and maxima.

use super::*;

const BITS: u32 = 80;

fn number(value: f64) -> Interval {
    Interval::from_f64(Precision::new(BITS), value)
}

/// The normal equations of one residual x² − c over a zone: G = 2x(x² − c), H = 6x² − 2c, JᵀJ = 4x².
fn normal(x: &Interval, c: f64) -> Normal {
    let rest = x.square() - number(c);
    Normal {
        gradient: vec![x.clone().times(2) * &rest],
        hessian: vec![vec![x.square().times(6) - number(2.0 * c)]],
        information: vec![vec![x.square().times(4)]],
        rss: rest.square(),
    }
}

/// The operator over middle ± reach.
fn image(c: f64, middle: f64, reach: f64) -> Option<Vec<Interval>> {
    let middle = number(middle);
    let zone = middle.clone().inflate(&number(reach));
    let Normal { gradient, hessian, .. } = normal(&middle, c);
    let inverse = inverse(midpoints(&hessian)).unwrap();
    krawczyk([&[middle], &gradient, std::slice::from_ref(&zone)], &inverse, &normal(&zone, c))
}

#[test]
fn a_stationary_point_is_enclosed() {
    // x = 1 is a minimum for c = 1; x = 0 a maximum.
    for (middle, reach, zero, is_minimum) in [(1.001, 0.01, 1.0, true), (1e-3, 0.01, 0.0, false)] {
        let found = image(1.0, middle, reach).unwrap();
        assert!(found[0].contains(&number(zero).mid()), "{middle}: {found:?}");
        assert_eq!(linear::is_positive_definite(normal(&found[0], 1.0).hessian), is_minimum, "{middle}");
    }
}

#[test]
fn boxes_without_a_proof_are_refused() {
    let cases = [
        ("no stationary point, beside the middle", -1.0, 3.0, 0.1),
        ("a minimum just outside of the box", 1.0, 1.01, 0.005),
        ("a minimum at the end of the box", 1.0, 1.0625, 0.0625),
        ("two minima and the maximum between them", 1.0, 0.3, 1.5),
        ("a minimum and the maximum", 1.0, 0.9, 1.0),
        ("a triple zero of the gradient", 0.0, 1e-3, 0.01),
        ("a gradient that is nearly zero for long", 1e-8, 2e-4, 1e-3),
    ];
    for (what, c, middle, reach) in cases {
        assert!(image(c, middle, reach).is_none(), "{what}");
    }
}

/// JᵀJ contracts where H does not: the residual is large, and the point is a maximum.
#[test]
fn the_operator_takes_second_derivatives_of_residuals() {
    let (middle, zone) = (number(1.0), number(1.0).inflate(&number(0.01)));
    let over = normal(&zone, 3.9);
    let inverse = vec![vec![number(0.25)]];
    let none = [number(0.0)];
    assert!(krawczyk([std::slice::from_ref(&middle), &none, std::slice::from_ref(&zone)], &inverse, &over).is_none());
    // As if JᵀJ were H.
    let gauss_newton = Normal { hessian: over.information.clone(), ..over };
    assert!(krawczyk([&[middle], &none, &[zone]], &inverse, &gauss_newton).is_some());
}

/// In two numbers: a saddle is a stationary point, and no minimum.
#[test]
fn a_saddle_is_no_minimum() {
    let point = [number(0.0), number(0.0)];
    let zone = point.each_ref().map(|value| value.clone().inflate(&number(0.1)));
    // x² − y² + xy/4.
    let hessian = vec![vec![number(2.0), number(0.25)], vec![number(0.25), number(-2.0)]];
    let inverse = inverse(hessian.clone()).unwrap();
    let over = Normal {
        gradient: point.to_vec(),
        hessian: hessian.clone(),
        information: vec![vec![number(1.0), number(0.0)], vec![number(0.0), number(1.0)]],
        rss: number(1.0),
    };
    let found = krawczyk([&point, &point, &zone], &inverse, &over).unwrap();
    assert!(found.iter().all(|value| value.contains_zero()));
    assert!(!linear::is_positive_definite(hessian));
}
