//! What is integrated from a cut meets what is integrated along rays, and a step at the cut has its terms.

use mdr_core::contact::Expression;

use super::*;

fn transform(formula: &str, bits: u32) -> Enclosed {
    let (formula, none): (Expression, _) = (formula.parse().unwrap(), Default::default());
    let precision = Precision::new(bits);
    Enclosed::new(formula.enclosed(&none, &formula.breaks(&none).unwrap(), precision).unwrap(), precision)
}

/// From cuts below x, in as many bits as x has: with the parabola that touches there, and with one that does not.
fn from_cuts(transform: &Enclosed, x: &Interval, order: Order) -> Option<[Vec<Interval>; 2]> {
    let store = transform.store.as_ref()?;
    let Below::Cut { at, .. } = store.below(x) else { return None };
    let c = Interval::point(at.clone()).rounded(x.ctx());
    let [height, bend] = [-0.02, 0.6].map(|number| Interval::from_f64(x.ctx(), number));
    let other = transform.formula.cut_along(&c, height, bend)?;
    let beside = transform.beside(store, &c, other, x, order, x.precision())?;
    Some([transform.cut_at(store, &at, x, order, x.precision())?, beside])
}

const ORDERS: [Order; 3] = [Order::Value, Order::Slope, Order::Curvature];

/// In a dip, beside it and far from it, whichever parabola is taken from the formula.
#[test]
fn cuts_meet_rays_in_more_bits() {
    for (width, formula) in [
        (1e-3, "r^2/2 - 0.2*(exp(-((r - 0.5037)/1e-3)^2) - exp(-(0.5037/1e-3)^2))"),
        (1e-6, "r^2/2 - 0.2*(exp(-((r - 0.5037)/1e-6)^2) - exp(-(0.5037/1e-6)^2))"),
        (1e-4, "r^2/2 - 1e-9*(1/((r - 0.5037)^2 + 1e-8) - 1/(0.5037^2 + 1e-8))"),
    ] {
        let bits = 110;
        let (coarse, fine) = (transform(formula, bits), transform(formula, 2 * bits));
        for (share, order) in [-0.8, 0.4, 1.5, 6.0, 100.0].iter().flat_map(|share| ORDERS.map(|order| (share, order))) {
            let x = Interval::from_f64(Precision::new(bits), 0.5037 + share * width);
            let cuts = from_cuts(&coarse, &x, order).unwrap_or_else(|| panic!("{formula} at {x}: no cut"));
            let in_all = x.rounded(Precision::new(2 * bits));
            let rays = fine.between_breaks(&in_all, order, fine.formula.breaks()).unwrap();
            for (cut, truth) in cuts.iter().flat_map(|cut| cut.iter().zip(&rays)) {
                assert!(cut.overlaps(truth), "{formula} at {x}, {order:?}: {cut} and {truth}");
                assert!(cut.accuracy_bits() > 60, "{formula} at {x}, {order:?}: {cut}");
            }
        }
    }
}

/// f = 0 up to c and J from there on has the mean J√s/x and g = Jx/√s, with s = x² − c²: M₀ is the mean, and M₁ and M₂ and M₃ are zero.
#[test]
fn a_step_has_its_terms() {
    let precision = Precision::new(100);
    let [x, c, step] = [2.5, 1.5, 0.7].map(|number| Interval::from_f64(precision, number));
    let s = Interval::from_int(precision, 4);
    let root = Real::sqrt(&s);
    let mean = step.clone() * &root / &x;
    let g = step.clone() * &x / &root;
    let slope = -(step.clone() * c.square() / (s.clone() * &root));
    let bend = step.times(3) * c.square() * &x / (s.square() * &root);
    let step = Interval::from_f64(precision, 0.7);
    let expected =
        [vec![x.lit(0), g.clone() - &mean, g - &mean], vec![slope.clone() * &x], vec![slope * &x, bend * x.square()]];
    for (order, expected) in ORDERS.into_iter().zip(expected) {
        for (found, expected) in of_step(&x, &c, &step, order).iter().zip(&expected) {
            assert!(
                found.overlaps(expected) && (*found == x.lit(0) || found.accuracy_bits() > 80),
                "{found} {expected}"
            );
        }
    }
}
