//! Quadrature against closed forms: the error estimate covers the error and is small.
//!
//! Most integrals are those of D. H. Bailey, K. Jeyabalan, X. S. Li, "A comparison of three high-precision quadrature
//! schemes", Experimental Mathematics 14 (2005) 317, with their singular ends.

use mdr_core::calculus::quadrature::{Node, pieces, tanh_sinh, tanh_sinh_near_ends, tanh_sinh_pieces};
use mdr_core::calculus::{Estimate, Tolerance, gauss_jacobi, roundoff_tolerance};
use mdr_core::contact::{Error, Quantity, Result};
use mdr_core::number::{Dual, Real, Special};

/// An integral with its closed form.
struct Integral<R> {
    name: &'static str,
    upper: R,
    integrand: fn(&Node<R>) -> R,
    truth: R,
}

/// Integrals from 0 to `upper`, in the precision of `one`.
fn integrals<R: Special>(one: &R) -> Vec<Integral<R>> {
    let pi = one.pi();
    let half_pi = || one.pi().over(2);
    let ln2 = one.lit(2).ln();
    let integral = |name, upper, integrand, truth| Integral { name, upper, integrand, truth };
    vec![
        integral("t ln(1+t)", one.clone(), |n| n.x.ln_1p() * &n.x, one.ratio(1, 4)),
        integral(
            "t² arctan t",
            one.clone(),
            |n| n.x.atan() * n.x.square(),
            (pi.clone() - one.lit(2) + ln2.clone().times(2)).over(12),
        ),
        integral("e^t cos t", half_pi(), |n| n.x.exp() * n.x.cos(), half_pi().exp_m1().over(2)),
        integral(
            "arctan √(2+t²) / ((1+t²)√(2+t²))",
            one.clone(),
            |n| {
                let root = (n.x.square() + n.x.lit(2)).sqrt();
                root.atan() / ((n.x.square() + n.x.lit(1)) * root)
            },
            pi.square().times(5).over(96),
        ),
        integral("√t ln t", one.clone(), |n| n.x.sqrt() * n.x.ln(), -one.ratio(4, 9)),
        integral("√(1−t²)", one.clone(), |n| (n.from_upper.clone() * (n.x.lit(1) + &n.x)).sqrt(), pi.clone().over(4)),
        integral("1/√(1−t)", one.clone(), |n| n.from_upper.sqrt().inv(), one.lit(2)),
        integral("ln² t", one.clone(), |n| n.x.ln().square(), one.lit(2)),
        integral("ln sin t", half_pi(), |n| n.x.sin().ln(), -(pi.clone() * &ln2).over(2)),
        integral(
            "√tan t",
            half_pi(),
            |n| {
                // tan t = cot(π/2 − t), from the nearer end.
                let near_zero = n.x < n.from_upper;
                let angle = if near_zero { &n.x } else { &n.from_upper };
                let tangent = angle.sin() / angle.cos();
                if near_zero { tangent.sqrt() } else { tangent.inv().sqrt() }
            },
            pi.clone() * one.lit(2).sqrt().over(2),
        ),
        // Γ(7/2) = 15√π/8; t is near 1 where −ln t is small.
        integral(
            "(−ln t)^(5/2)",
            one.clone(),
            |n| {
                let log = if n.x < n.from_upper { n.x.ln() } else { (-n.from_upper.clone()).ln_1p() };
                (-log).pow(&n.x.ratio(5, 2))
            },
            pi.sqrt().times(15).over(8),
        ),
        integral("t^(−19/20)", one.clone(), |n| n.x.pow(&-n.x.ratio(19, 20)), one.lit(20)),
        integral("t^20", one.clone(), |n| n.x.powi(20), one.ratio(1, 21)),
        integral("cos 100t", one.clone(), |n| n.x.clone().times(100).cos(), one.lit(100).sin().over(100)),
    ]
}

/// |value − truth| ≤ the estimate, plus what it cannot include: rounding of x and inside f. The integrands are at most
/// ten rounded operations; the power t²⁰ and the cosine of 100t magnify the rounding of t twenty- and hundredfold, and
/// in t^(−19/20) the rounding of ln t is magnified by ln of the smallest t, 700 in `f64` and 20·bits otherwise; its
/// mean in the integral is ∫|ln t|t^(−19/20)/20 = 20.
fn assert_claim<R: Real>(name: &str, estimate: &Estimate<R>, truth: &R, scale: &R) {
    let inside = truth.unit_roundoff().times(120) * scale;
    let error = (estimate.value.clone() - truth).abs();
    let claim = estimate.error.clone() + &inside;
    assert!(error <= claim, "{name}: error {:e}, claimed {:e}", error.approx(), estimate.error.approx());
    // An estimate that is far too large is as useless as one that is too small.
    assert!(estimate.error <= roundoff_tolerance(truth) * scale, "{name}: claimed {:e}", estimate.error.approx());
}

fn closed_forms<R: Special>(one: &R) {
    let tolerance = roundoff_tolerance(one);
    for Integral { name, upper, integrand, truth } in integrals(one) {
        let estimate = tanh_sinh_near_ends(&one.lit(0), &upper, &tolerance, |node| Ok(integrand(node))).expect(name);
        // ∫|f| is below 21 in all of them; where f changes its sign, in "cos 100t", it is below 1.
        let scale = if truth.abs() > one.lit(1) { truth.abs() } else { one.lit(1) };
        assert_claim(name, &estimate, &truth, &scale);
    }
}

#[test]
fn closed_forms_in_f64() {
    closed_forms(&1.0);
}

/// Kahaner's spikes: sech²10(x−1/5) + sech⁴100(x−2/5) + sech⁶1000(x−3/5). A rule that misses the narrowest, of width
/// 10⁻³, has an error of 1 in 10³. With a loose tolerance every rule stops before it could detect it.
#[test]
fn spikes_are_integrated_or_refused() {
    let sech = |x: f64| x.cosh().recip();
    let f =
        |x: f64| sech(10.0 * (x - 0.2)).powi(2) + sech(100.0 * (x - 0.4)).powi(4) + sech(1000.0 * (x - 0.6)).powi(6);
    let primitive = |x: f64| {
        let (t1, t2, t3) = ((10.0 * (x - 0.2)).tanh(), (100.0 * (x - 0.4)).tanh(), (1000.0 * (x - 0.6)).tanh());
        t1 / 10.0 + (t2 - t2.powi(3) / 3.0) / 100.0 + (t3 - t3.powi(3) / 1.5 + t3.powi(5) / 5.0) / 1000.0
    };
    let truth = primitive(1.0) - primitive(0.0);
    for tolerance in [1e-6, 1e-9, 1e-12] {
        for estimate in [
            tanh_sinh(&0.0, &1.0, &tolerance, |&x| Ok(f(x))),
            gauss_jacobi::integrate(&0.0, &0.0, &tolerance, |&x| Ok(f(x))),
        ]
        .into_iter()
        .flatten()
        {
            // The arguments of the steepest spike are rounded 600 times more coarsely than x.
            let inside = 600.0 * f64::EPSILON * truth;
            assert!((estimate.value - truth).abs() <= estimate.error + inside, "{tolerance:e}: {estimate:?}");
        }
    }
}

/// |x − c| with the kink inside converges like h², by chance faster: the estimate must cover that. (A kink outside the
/// nodes of all rules, within 1/40 of an end, is undetectable.)
#[test]
fn kinks_inside_do_not_fool_the_estimate() {
    for k in 10..190 {
        let c = f64::from(k) / 200.0 + 0.000_3;
        let truth = (c * c + (1.0 - c) * (1.0 - c)) / 2.0;
        for tolerance in [1e-2, 1e-4, 1e-6] {
            for (rule, estimate) in [
                ("tanh-sinh", tanh_sinh(&0.0, &1.0, &tolerance, |x| Ok((x - c).abs()))),
                ("Gauss", gauss_jacobi::integrate(&0.0, &0.0, &tolerance, |x| Ok((x - c).abs()))),
            ] {
                let Ok(estimate) = estimate else { continue };
                let error = (estimate.value - truth).abs();
                assert!(error <= estimate.error, "{rule}, c = {c}: {error:e} against {:e}", estimate.error);
            }
        }
    }
}

#[test]
fn divergent_integrals_do_not_converge() {
    let divergent = tanh_sinh(&0.0, &1.0, &1e-3, |x: &f64| Ok(1.0 / x));
    assert!(matches!(divergent, Err(Error::NoConvergence { quantity: Quantity::Integral, .. })), "{divergent:?}");
    // This integrand overflows first.
    assert!(tanh_sinh(&0.0, &1.0, &1e-3, |x: &f64| Ok(x.powf(-1.5))).is_err());
    // ∫ t^(−0.99) = 100 exists, but 10⁻³ of it lies below the smallest double, which the error includes.
    let Err(Error::NoConvergence { error, .. }) = tanh_sinh(&0.0, &1.0, &1e-6, |x: &f64| Ok(x.powf(-0.99))) else {
        panic!("converged")
    };
    assert!(0.5e-3 < error && error < 5e-3, "{error:e}");
}

/// eˣ with a relative noise: the refinement ends at the noise, with an error that covers it and is not much larger, at
/// a fraction of the cost of all levels. Below the limit nothing is accepted.
#[test]
fn noise_of_the_integrand_ends_the_refinement() {
    // Some fixed number in (−1, 1) for each x.
    let hash = |x: f64| (x.to_bits().wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 11) as f64 / 2f64.powi(52) - 1.0;
    let truth = 1f64.exp_m1();
    let mut saved = 0;
    for exponent in 4..14 {
        let noise = 10f64.powi(-exponent);
        let noisy = |x: &f64| Ok(x.exp() * (1.0 + noise * hash(*x)));
        let with = |limit| -> [Result<Estimate<f64>>; 2] {
            let tolerance = Tolerance::new(&0.0).or_noise_below(limit);
            [tanh_sinh(&0.0, &1.0, tolerance.clone(), noisy), gauss_jacobi::integrate(&0.0, &0.0, tolerance, noisy)]
        };
        for estimate in with(10.0 * noise) {
            let Estimate { value, error, evaluations } = estimate.unwrap();
            assert!((value - truth).abs() <= error && error <= 10.0 * noise * truth, "{noise:e}: {value} ± {error:e}");
            assert!(evaluations < 500, "{noise:e}: {evaluations} evaluations");
        }
        let price = |tolerance| gauss_jacobi::integrate(&0.0, &0.0, tolerance, noisy).unwrap();
        let goal = Tolerance::new(&(10.0 * noise));
        let (known, unknown) = (price(goal.clone().with_noise(&noise)), price(goal));
        assert!((known.value - truth).abs() <= known.error + noise * truth, "{noise:e}: {known:?}");
        saved += unknown.evaluations - known.evaluations;
        if noise > 1e-12 {
            assert!(with(0.01 * noise).iter().all(Result::is_err), "{noise:e}");
        }
    }
    assert!(saved > 100, "{saved}");
}

/// With √t a Gauss rule of twice the nodes leaves an eighth of the error, so the changes are not noise, and the finest
/// rule misses the goal by far. It is accepted if the limit allows.
#[test]
fn the_finest_rule_counts_below_the_limit() {
    let with = |limit: f64| {
        let tolerance = Tolerance::new(&0.0).or_noise_below(limit);
        gauss_jacobi::integrate(&0.0, &0.0, tolerance, |t: &f64| Ok(t.sqrt()))
    };
    let Estimate { value, error, .. } = with(1e-5).unwrap();
    assert!((value - 2.0 / 3.0).abs() <= error && error <= 1e-5 * value, "{value} ± {error:e}");
    assert!(matches!(with(error / 2.0), Err(Error::NoConvergence { .. })), "{error:e}");
}

/// If noise is not accepted before the finest rule, that rule is reached, and its value accepted only below the limit.
#[test]
fn the_finest_rule_alone_may_miss_the_goal() {
    // eˣ to a noise of about 1e-9.
    let noisy = |x: &f64| Ok(x.exp() + 1e-9 * (1e12 * x).sin());
    let goal = Tolerance::new(&0.0);
    let by = |tolerance| tanh_sinh(&0.0, &1.0, tolerance, noisy);
    let early = by(goal.clone().or_noise_below(1e-8)).unwrap();
    let late = by(goal.clone().or_finest_below(1e-8)).unwrap();
    assert!((late.value - 1f64.exp_m1()).abs() <= late.error && late.error < 2e-8, "{late:?}");
    let Err(Error::NoConvergence { evaluations, .. }) = by(goal.clone().or_finest_below(1e-12)) else {
        panic!("converged")
    };
    assert_eq!(late.evaluations, evaluations);
    assert!(early.evaluations * 2 < evaluations, "{early:?}");
}

#[test]
fn errors_of_the_integrand_come_through() {
    let refused = Error::NoEquilibrium { quantity: Quantity::Force, value: "1".into() };
    let fails = |_: &f64| -> Result<f64> { Err(refused.clone()) };
    assert_eq!(tanh_sinh(&0.0, &1.0, &1e-9, fails), Err(refused.clone()));
    assert_eq!(gauss_jacobi::integrate(&0.0, &0.0, &1e-9, fails), Err(refused.clone()));
    let hole = |x: &f64| Ok(if *x == 0.5 { f64::NAN } else { 1.0 });
    assert!(matches!(tanh_sinh(&0.0, &1.0, &1e-9, hole), Err(Error::Domain { quantity: Quantity::Integrand, .. })));
}

/// (1/5 − x)₊⁸ and its mirror image are smooth and exactly zero in the middle: neither the sum outwards nor the first
/// rules, which have no other samples, may stop there.
#[test]
fn a_zero_in_the_middle_is_no_end() {
    for mirrored in [false, true] {
        let f = |x: f64| (0.2 - if mirrored { 1.0 - x } else { x }).max(0.0).powi(8);
        let truth = 0.2f64.powi(9) / 9.0;
        for estimate in [
            tanh_sinh(&0.0, &1.0, &1e-7, |&x| Ok(f(x))).unwrap(),
            gauss_jacobi::integrate(&0.0, &0.0, &1e-7, |&x| Ok(f(x))).unwrap(),
        ] {
            // Only seven derivatives exist, which costs two digits of the tolerance.
            assert!((estimate.value - truth).abs() <= 1e-5 * truth, "{estimate:?}");
        }
    }
}

#[test]
fn orientation_and_empty_intervals() {
    let integral = |a: f64, b: f64| tanh_sinh(&a, &b, &1e-12, |x| Ok(x.exp())).unwrap();
    assert_eq!(integral(0.0, 1.0).value, -integral(1.0, 0.0).value);
    assert!(tanh_sinh(&1.0, &1.0f64.next_up(), &1e-12, |x| Ok(*x)).is_err());
    let zero = gauss_jacobi::integrate(&0.0, &0.0, &1e-12, |_| Ok(0.0)).unwrap();
    assert_eq!((zero.value, zero.error), (0.0, 0.0));
    assert_eq!(integral(0.5, 0.5), Estimate { value: 0.0, error: 0.0, evaluations: 0 });
}

/// Multiplying lengths by a power of two changes no bit.
#[test]
fn scale_free() {
    let integral = |scale: f64| {
        tanh_sinh(&0.0, &(3.0 * scale), &roundoff_tolerance(&1.0), |x| Ok((x / scale).sqrt() + x / scale)).unwrap()
    };
    let one = integral(1.0);
    for exponent in [-600, -300, -1, 1, 300, 600] {
        let scale = 2f64.powi(exponent);
        let other = integral(scale);
        assert_eq!((one.value * scale, one.evaluations), (other.value, other.evaluations));
    }
}

/// ∂/∂p ∫₀¹ xᵖ dx = −1/(1+p)², and by the limits: ∂/∂b ∫₀ᵇ x² dx = b².
#[test]
fn derivatives_of_integrals() {
    let p = Dual::variable(0.3);
    let [zero, one] = [0.0, 1.0].map(Dual::constant);
    let tolerance = roundoff_tolerance(&one);
    let by_exponent = tanh_sinh(&zero, &one, &tolerance, |x| Ok(x.pow(&p))).unwrap().value;
    approx::assert_relative_eq!(by_exponent.slope, -1.0 / (1.3 * 1.3), max_relative = 1e-14);
    let by_limit = tanh_sinh(&zero, &Dual::variable(1.5), &tolerance, |x| Ok(x.square())).unwrap().value;
    approx::assert_relative_eq!(by_limit.slope, 2.25, max_relative = 1e-14);
}

#[cfg(feature = "mp")]
#[test]
fn closed_forms_at_50_and_200_digits() {
    use mdr_core::number::Precision;
    use rug::Float;
    for digits in [50, 200] {
        closed_forms(&Float::with_val(Precision::from_digits(digits).bits(), 1));
    }
}

/// In interval arithmetic the sum is an enclosure and the estimate covers the remainder: together they contain the
/// truth.
#[cfg(feature = "mp")]
#[test]
fn intervals() {
    use mdr_core::number::{Interval, Precision};
    let one = Interval::from_int(Precision::new(120), 1);
    let estimate = tanh_sinh(&one.lit(0), &one, &one.unit_roundoff().times(1 << 20), |x| Ok(x.sqrt())).unwrap();
    let value = estimate.value.clone().inflate(&estimate.error);
    assert!(value.contains(one.ratio(2, 3).lower()) && value.accuracy_bits() > 95, "{estimate:?}");
}

#[test]
fn pieces_add_up_in_either_direction() -> Result<()> {
    // ∫₁⁴ |x − 2|^(1/2) + |x − 3| dx = (2/3)(1 + 2√2) + 5/2, with breaks in any order, outside and at the ends.
    let bent = |x: &f64| Ok((x - 2.0).abs().sqrt() + (x - 3.0).abs());
    let truth = 2.0 / 3.0 * (1.0 + 8f64.sqrt()) + 2.5;
    let tolerance = roundoff_tolerance(&1.0);
    let breaks = [3.0, 9.0, 2.0, 1.0, 4.0, 0.5];
    let there = tanh_sinh_pieces(&1.0, &4.0, &breaks, &tolerance, bent)?;
    // x − 2 has the error of x itself where the root is steep: half the digits of a weight that is no larger.
    assert!((there.value - truth).abs() < 1e-7 && there.error < 1e-6, "{there:?}");
    let back = tanh_sinh_pieces(&4.0, &1.0, &breaks, &tolerance, bent)?;
    assert!((back.value + there.value).abs() <= 4.0 * f64::EPSILON * truth && back.evaluations == there.evaluations);

    // The ends of the pieces, the sum of errors and evaluations.
    let mut ends = Vec::new();
    let total = pieces(&0.0, &3.0, &[2.0, 1.0, 5.0], |from, to| {
        ends.push((*from, *to));
        Ok(Estimate { value: to - from, error: 0.5, evaluations: 7 })
    })?;
    assert_eq!(ends, [(0.0, 1.0), (1.0, 2.0), (2.0, 3.0)]);
    assert_eq!(total, Estimate { value: 3.0, error: 1.5, evaluations: 21 });
    Ok(())
}
