use mdr_core::number::Real;

use super::*;
use crate::checks::by_gamma;

/// κ_n xⁿ by the Γ of MPFR, which no truth is made with.
#[test]
fn the_truth_is_that_of_the_definition_by_gamma() {
    for (question, n) in subject::questions().iter().zip(subject::EXPONENTS) {
        let truth = question.truth(Precision::new(TRUTH)).unwrap();
        assert!(truth.accuracy_bits() > 490, "{}", question.id);
        let [n, x] = [n, question.x].map(|value| Float::with_val(TRUTH + 64, value));
        let power = x.pow(&n);
        assert!(truth.contains(&(by_gamma(&n) * power)), "{}", question.id);
    }
    for question in subject::questions() {
        assert!(question.truth(Precision::new(TRUTH)).unwrap().accuracy_bits() > 420, "{}", question.id);
    }
}

fn one(index: usize) -> Diagram {
    diagram(&subject::questions()[index], &mut Setup::new(Effort::Quick, Clock::Off))
}

fn find(diagram: &Diagram, method: Method, arithmetic: Arithmetic) -> &Curve {
    let of = |curve: &&Curve| curve.contestant == method.name() && curve.arithmetic == arithmetic;
    diagram.curves.iter().find(of).expect("every diagram has the contestant")
}

fn digits(point: &Point) -> f64 {
    point.outcome.digits().unwrap_or_else(|| panic!("{point:?}"))
}

/// A sum of N terms, each with the condition of the integrand, is off by at most N + 40(1 + cond) roundings.
fn rounding(ceiling: f64, evaluations: u64) -> f64 {
    let cond = 10_f64.powf(super::ceiling(1.0) - ceiling);
    ceiling + cond.log10() - (evaluations as f64 + 40.0 * (1.0 + cond)).log10()
}

#[test]
fn quick_diagrams_reach_their_ceilings_with_the_same_counts_every_time() {
    let found = diagrams(&mut Setup::new(Effort::Quick, Clock::Off));
    assert_eq!(found.len(), 11);
    for diagram in &found {
        let ceiling = diagram.ceiling.unwrap();
        for method in [Method::Jacobi, Method::TanhSinh, Method::RegularisedTanhSinh, Method::Automatic] {
            let last = find(diagram, method, Arithmetic::Double).points.last().unwrap();
            let least = rounding(ceiling, last.evaluations.unwrap());
            assert!(digits(last) >= least, "{}: {} of {last:?}", diagram.id, method.name());
        }
        for method in [Method::RegularisedTanhSinh, Method::Automatic] {
            assert!(digits(&find(diagram, method, Arithmetic::Mp).points[0]) > 30.0, "{}", diagram.id);
        }
        for (curve, point) in diagram.curves.iter().flat_map(|curve| curve.points.iter().map(move |p| (curve, p))) {
            assert!(point.evaluations.is_some_and(|count| count > 0), "{}", curve.contestant);
            assert!(point.time.is_none());
        }
    }
    assert_eq!(found[1], one(1));
}

/// The nodes that are set are the heights that are asked for: once a piece.
#[test]
fn nodes_are_evaluations() {
    for (index, pieces) in [(0, 1), (9, 2)] {
        let diagram = one(index);
        for method in [Method::Midpoint, Method::Chebyshev, Method::Legendre] {
            for (point, amount) in find(&diagram, method, Arithmetic::Double).points.iter().zip(amounts(
                method,
                Arithmetic::Double,
                Effort::Quick,
            )) {
                assert_eq!(point.evaluations, Some(*amount as u64));
            }
        }
        for method in [Method::Regularised, Method::Jacobi] {
            for (point, amount) in find(&diagram, method, Arithmetic::Double).points.iter().zip(amounts(
                method,
                Arithmetic::Double,
                Effort::Quick,
            )) {
                assert_eq!(point.evaluations, Some(pieces * *amount as u64));
            }
        }
    }
}

/// What Gauss–Legendre says in silence of a blunt tip is wrong: half of it is missing with 256 nodes.
#[test]
fn gauss_legendre_is_wrong_at_blunt_tips() {
    let diagram = one(0);
    for method in [Method::Midpoint, Method::Chebyshev, Method::Legendre] {
        let last = find(&diagram, method, Arithmetic::Double).points.last().unwrap();
        assert!((0.0..0.35).contains(&digits(last)), "{}: {last:?}", method.name());
    }
    assert!(digits(find(&diagram, Method::Regularised, Arithmetic::Double).points.last().unwrap()) > 11.0);
}

/// The digits of a method in p bits.
fn reached(question: &Question, method: Method, amount: usize) -> f64 {
    let truth = question.truth(Precision::new(TRUTH)).unwrap();
    let contest = Contest { question, truth: Some(&truth), effort: Effort::Quick, clock: &Clock::Off };
    let point = contest.attempt::<Float>(method, amount, Precision::new(BITS), String::new()).unwrap();
    digits(&point)
}

/// A singularity rᵖ at an end leaves N^−(p+1) of a midpoint and N^−2(p+1) of a Gauss rule. Between N and 2N a second term
/// N^−(p+1+δ), if no larger at N = 1, changes the order by δN^−δ ≤ 1/(e ln N) at most.
#[test]
fn every_textbook_rule_converges_as_its_theory_says() {
    let order = |question: &Question, method, nodes: usize| {
        (reached(question, method, 2 * nodes) - reached(question, method, nodes)) / 2_f64.log10()
    };
    for (question, n) in subject::questions().iter().zip(subject::EXPONENTS) {
        let expect = |method: Method, nodes: usize, expected: f64| {
            let found = order(question, method, nodes);
            let second = ((nodes as f64).ln() * std::f64::consts::E).recip();
            assert!((found - expected).abs() < second, "n = {n}, {}: {found}, not {expected}", method.name());
        };
        expect(Method::Midpoint, 512, n.min(0.5));
        if n != 1.0 && n != 20.0 {
            expect(Method::Chebyshev, 128, n);
        }
        if n.fract() != 0.0 {
            expect(Method::Legendre, 64, 2.0 * n);
            expect(Method::Regularised, 64, 2.0 * (n + 2.0));
        }
        // (3 + √8)^−2N: the nearest singularity is s = −1.
        let rate = (reached(question, Method::Jacobi, 40) - reached(question, Method::Jacobi, 24)) / 16.0;
        let expected = 2.0 * (3.0 + 8_f64.sqrt()).log10();
        assert!((rate - expected).abs() < 0.1, "n = {n}: {rate} digits a node, not {expected}");
    }
}

/// f = r² has f' = 2r: one step, one node, by hand.
#[test]
fn one_node_of_each_rule_is_what_a_pencil_says() {
    let question = Question::power(2.0);
    let heights = question.heights::<f64>(()).unwrap();
    let x = question.x;
    let one = |method: Method| method.prepare(1, Counted { heights: &heights, count: None }, &x).unwrap()().unwrap();
    let at_half_angle = std::f64::consts::PI / 2.0 * 2.0 * x * x * std::f64::consts::FRAC_1_SQRT_2;
    for (method, expected) in [
        (Method::Midpoint, x * x / 0.75_f64.sqrt()),
        (Method::Chebyshev, at_half_angle),
        (Method::Legendre, at_half_angle),
        (Method::LegendrePieces, at_half_angle),
        // sinθ (f + r f') = 3x² sin³θ.
        (Method::Regularised, std::f64::consts::PI / 2.0 * 3.0 * x * x * 0.125_f64.sqrt()),
    ] {
        let found = one(method);
        assert!((found / expected - 1.0).abs() < 16.0 * f64::EPSILON, "{}: {found}, not {expected}", method.name());
    }
}
