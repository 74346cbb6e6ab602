//! Integrals from kept heights hold what finer ones hold, however coarse the aim is: there the remainders count.

use mdr_core::contact::Expression;

use super::*;

fn number(text: &str) -> Interval {
    Interval::from_literal(Precision::new(BOUND_BITS), &text.parse().unwrap())
}

fn store(formula: &str) -> Store {
    let (formula, none): (Expression, _) = (formula.parse().unwrap(), Default::default());
    let enclosed = formula.enclosed(&none, &formula.breaks(&none).unwrap(), Precision::new(BOUND_BITS)).unwrap();
    Store::new(enclosed.part(0).unwrap().clone(), Arc::default())
}

/// The integrals up to 1/2 for x, of f − 0.3 − 0.7 r², with remainders of cells up to this share of the sum.
fn integrals(store: &Store, x: &Interval, order: Order, aim: f64) -> Option<Vec<DoubleInterval>> {
    let c = Float::with_val(BOUND_BITS, 0.5);
    let mut inside = Inside {
        store,
        nearest: x.lower(),
        c: &c,
        deepest: -DEEPEST,
        kernel: Kernel { x, order },
        parabola: &Parabola { height: number("0.3"), bend: number("0.7") },
        in_doubles: DoubleInterval::around(x),
        aim,
        sums: vec![DoubleInterval::point(0.0); order.count()],
        looked_at: 0,
    };
    inside.add(Place { exponent: 1, index: 0 })?;
    Some(inside.sums)
}

fn meet(one: &[DoubleInterval], other: &[DoubleInterval]) -> bool {
    one.iter().zip(other).all(|(one, other)| one.lower() <= other.upper() && other.lower() <= one.upper())
}

#[test]
fn coarse_integrals_hold_fine_ones() {
    for k in [100, 300, 900, 2000] {
        let store = store(&format!("cos({k}*r)"));
        for x in ["0.7", "0.9", "1.3"].map(number) {
            let fine = integrals(&store, &x, Order::Curvature, 1e-12).unwrap();
            for aim in [1e-6, 1e-4, 1e-2, 1.0] {
                let coarse = integrals(&store, &x, Order::Curvature, aim).unwrap();
                assert!(meet(&coarse, &fine), "{k}, {x}, {aim}: {coarse:?} without {fine:?}");
            }
        }
    }
}

/// Against the integral of the same kernel by rules that are chosen for it.
#[test]
fn integrals_are_those_of_the_kernel() {
    use mdr_core::calculus::enclose::{Goal, Integrand, enclose};
    const ORDERS: [Order; 3] = [Order::Value, Order::Slope, Order::Curvature];
    struct Whole<'a> {
        store: &'a Store,
        kernel: Kernel<'a>,
        parabola: Parabola,
    }
    impl Integrand for Whole<'_> {
        fn at<T: Analytic>(&self, r: &T) -> Option<Vec<T>> {
            self.kernel.times(&self.store.height(r)?.minus(&self.parabola.at(r)), r)
        }
    }
    for formula in ["r^2/2 - 0.01*exp(-((r - 0.3)*1e4)^2)", "exp(r)", "r^1.5/(1 + r^4)", "1/((r - 0.2)^2 + 1e-6)"] {
        let store = store(formula);
        for (x, order) in ["0.55", "0.8", "40"].iter().flat_map(|x| ORDERS.map(|order| (number(x), order))) {
            let parabola = Parabola { height: number("0.3"), bend: number("0.7") };
            let whole = Whole { store: &store, kernel: Kernel { x: &x, order }, parabola };
            let ends = [Float::new(BOUND_BITS), Float::with_val(BOUND_BITS, 0.5)];
            let tolerances = vec![Float::with_val(BOUND_BITS, 1e-14); order.count()];
            let truth = enclose(&whole, [&ends[0], &ends[1]], &Goal { bits: 64, tolerances, pieces: 2000 }).unwrap();
            let found = integrals(&store, &x, order, 1e-15).unwrap();
            for (found, truth) in found.iter().zip(truth) {
                let found = widened(found, &x);
                assert!(found.overlaps(&truth), "{formula} at {x}, {order:?}: {found} and {truth}");
                assert!(found.accuracy_bits() > 25, "{formula} at {x}, {order:?}: {found}");
            }
        }
    }
}

/// What is narrow is not passed over, and radii before it are not cut.
#[test]
fn cuts_lie_between_what_is_narrow_and_the_radius() {
    let dip = store("r^2/2 - 0.2*exp(-((r - 0.5037)/1e-6)^2)");
    for (x, least) in [("0.504", 0.50371), ("0.51", 0.504), ("0.8", 0.504), ("30", 0.504)] {
        let Below::Cut(c) = dip.below(&number(x)) else { panic!("{x} is not cut") };
        assert!(c > least && c < x.parse::<f64>().unwrap(), "{x}: {c}");
    }
    assert!(matches!(dip.below(&number("0.1")), Below::Nothing));
    let close = number("0.50371").hull(&number("0.5038"));
    assert!(matches!(dip.below(&close), Below::Narrow));
}

/// The parabola's own: 0.3 + 0.7 r² on all of the contact, by the closed forms of its transform.
#[test]
fn integrals_of_the_parabola() {
    let parabola = Parabola { height: number("0.3"), bend: number("0.7") };
    let [mean, g, above] = parabola.integrals(&DoubleInterval::point(2.0), Order::Value)[..] else { panic!() };
    let expected = [0.3 + 0.7 * 8.0 / 3.0, 0.3 + 0.7 * 8.0, 0.7 * 16.0 / 3.0];
    for (found, expected) in [mean, g, above].iter().zip(expected) {
        assert!((found.lower() - expected).abs() < 1e-14 && (found.upper() - expected).abs() < 1e-14, "{found:?}");
    }
    let slopes = parabola.integrals(&DoubleInterval::point(2.0), Order::Curvature);
    assert!(slopes.iter().all(|slope| (slope.upper() - 11.2).abs() < 1e-14), "{slopes:?}");
}

/// Where f is level, as just before a pole, its terms cancel, and the cells are not called narrow.
#[test]
fn level_heights_are_not_narrow() {
    let pole = store("r^2/2 - 0.01/(1 + ((r - 0.4)/1e-4)^2)");
    for x in ["0.39915", "0.39917478", "0.3992", "0.3995"] {
        assert!(matches!(pole.below(&number(x)), Below::Cut(_)), "{x}");
    }
}
