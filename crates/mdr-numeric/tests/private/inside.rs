//! Integrals from kept heights hold what finer ones hold, however coarse the aim is: there the remainders count.

use mdr_core::calculus::enclose::{Goal, Integrand, enclose};

use super::super::store::tests::{number, store};
use super::*;

fn parabola() -> Parabola {
    Parabola { height: number("0.3"), bend: number("0.7") }
}

/// The integrals up to 1/2 for x, of f − 0.3 − 0.7 r², with remainders of cells up to this share of the sum.
fn up_to_half<I: Ends>(store: &Store, x: &Interval, order: Order, in_arithmetic: (I::Ctx, f64)) -> Option<Vec<I>> {
    let c = Float::with_val(BOUND_BITS, 0.5);
    Inside::up_to(&c, store, Kernel { x, order }, &parabola(), in_arithmetic)
}

fn meet<I: Ends>(one: &[I], other: &[I]) -> bool {
    one.iter().zip(other).all(|(one, other)| (one.clone() - other).has_zero())
}

fn coarse_hold_fine<I: Ends + std::fmt::Debug>(ctx: I::Ctx, finest: f64) {
    for k in [100, 300, 900, 2000] {
        let store = store(&format!("cos({k}*r)"));
        for x in ["0.7", "0.9", "1.3"].map(number) {
            let fine: Vec<I> = up_to_half(&store, &x, Order::Curvature, (ctx, finest)).unwrap();
            for aim in [finest * 1e6, 1e-4, 1e-2, 1.0] {
                let coarse = up_to_half(&store, &x, Order::Curvature, (ctx, aim)).unwrap();
                assert!(meet(&coarse, &fine), "{k}, {x}, {aim}: {coarse:?} without {fine:?}");
            }
        }
    }
}

#[test]
fn coarse_integrals_hold_fine_ones() {
    coarse_hold_fine::<DoubleInterval>((), 1e-12);
    coarse_hold_fine::<Interval>(Precision::new(110), 1e-28);
}

/// Against the integral of the same kernel by rules that are chosen for it.
#[test]
fn integrals_are_those_of_the_kernel() {
    const ORDERS: [Order; 3] = [Order::Value, Order::Slope, Order::Curvature];
    struct Whole<'a> {
        store: &'a Store,
        kernel: Kernel<'a>,
    }
    impl Integrand for Whole<'_> {
        fn at<T: Analytic>(&self, r: &T) -> Option<Vec<T>> {
            self.kernel.times(&self.store.height(r)?.minus(&parabola().at(r)), r)
        }
    }
    let c = Float::with_val(BOUND_BITS, 0.5);
    for formula in ["r^2/2 - 0.01*exp(-((r - 0.3)*1e4)^2)", "exp(r)", "r^1.5/(1 + r^4)", "1/((r - 0.2)^2 + 1e-6)"] {
        let store = store(formula);
        for (x, order) in ["0.55", "0.8", "40"].iter().flat_map(|x| ORDERS.map(|order| (number(x), order))) {
            let whole = Whole { store: &store, kernel: Kernel { x: &x, order } };
            let tolerances = vec![Float::with_val(BOUND_BITS, 1e-30); order.count()];
            let goal = Goal { bits: 140, tolerances, pieces: 4000 };
            let truth = enclose(&whole, [&Float::new(BOUND_BITS), &c], &goal).unwrap();
            let whole: Vec<_> = truth.into_iter().zip(parabola().integrals(&x, order)).map(|(h, p)| h + p).collect();
            for (bits, least) in [(DOUBLE_BITS, 25), (100, 66)] {
                let found = integrals(&store, &x, order, &c, &parabola(), bits).unwrap();
                for (found, truth) in found.iter().zip(&whole) {
                    assert!(found.overlaps(truth), "{formula} at {x}, {order:?}: {found} and {truth}");
                    assert!(found.accuracy_bits() > least, "{formula} at {x}, {order:?}, {bits}: {found}");
                }
            }
        }
    }
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
