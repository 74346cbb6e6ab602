//! The statements of mdr-symbolic and the functions of mdr-analytic say the same: at random rational points the symbolic
//! formula, evaluated in intervals, and the closed form, run over intervals and in f64, enclose one another.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use mdr_analytic::{Kappa, PowerLaw, PowerLawContact, flat_punch_pull_off, kappa, threshold};
use mdr_analytic::{universal_force, universal_indentation};
use mdr_core::contact::{Control, Material, Result};
use mdr_core::number::{Interval, Real};
use mdr_crosscheck::derivations::{SamplePoint, SamplePoints};
use mdr_symbolic::formula::evaluate;
use mdr_symbolic::{Domain, Formula};
use rug::Rational;

/// A symbolic formula, where it holds, and the closed form of the same quantity.
struct Tie {
    formula: &'static str,
    domains: &'static [Domain],
    interval: fn(&At<Interval>) -> Result<Interval>,
    double: fn(&At<f64>) -> Result<f64>,
}

/// A point in an arithmetic.
struct At<R> {
    point: SamplePoint,
    number: fn(&Rational) -> R,
}

impl<R: Kappa> At<R> {
    fn n(&self) -> R {
        (self.number)(self.point.exponent())
    }
    fn value(&self, name: &str) -> R {
        (self.number)(&self.point.value(name))
    }
    fn material(&self) -> Material<R> {
        Material::new(self.value("E"), self.value("w")).unwrap()
    }
    fn contact(&self) -> PowerLawContact<R> {
        PowerLawContact::new(PowerLaw::new(self.n(), self.value("C")).unwrap(), self.material())
    }
    fn machine(&self) -> Control<R> {
        Control::Machine { stiffness: self.value("k") }
    }
}

const ALL: &[Domain] = &[Domain::Positive];
const BOTH: &[Domain] = &[Domain::Above, Domain::Below];
const ABOVE: &[Domain] = &[Domain::Above];
const BELOW: &[Domain] = &[Domain::Below];
const HALF: &[Domain] = &[Domain::Half];

/// One generic expression in both arithmetics.
macro_rules! tie {
    ($formula:literal, $domains:expr, |$at:ident| $closed:expr) => {
        Tie { formula: $formula, domains: $domains, interval: |$at| $closed, double: |$at| $closed }
    };
}

fn ties() -> Vec<Tie> {
    vec![
        tie!("κ_Γ", ALL, |at| kappa(&at.n())),
        tie!("Δl", ALL, |at| at.contact().detachment_elongation(&at.value("a"))),
        tie!("d_n", ALL, |at| at.contact().indentation(&at.value("a"))),
        tie!("F_n", ALL, |at| at.contact().force(&at.value("a"))),
        tie!("diff(d_n, a)", ALL, |at| at.contact().indentation_slope(&at.value("a"))),
        tie!("diff(F_n, a)", ALL, |at| at.contact().force_slope(&at.value("a"))),
        tie!("U_n", ALL, |at| at.contact().energy(&at.value("a"), &at.value("d"))),
        tie!("a_c", BOTH, |at| Ok(at.contact().critical(&Control::Indentation)?.contact_radius)),
        tie!("d_c", BOTH, |at| Ok(at.contact().critical(&Control::Indentation)?.indentation)),
        tie!("F_c", BOTH, |at| Ok(at.contact().critical(&Control::Indentation)?.force)),
        tie!("a_F", BOTH, |at| Ok(at.contact().critical(&Control::Force)?.contact_radius)),
        tie!("d_F", BOTH, |at| Ok(at.contact().critical(&Control::Force)?.indentation)),
        tie!("F_F", BOTH, |at| Ok(at.contact().critical(&Control::Force)?.force)),
        tie!("a_0", BOTH, |at| at.contact().radius_at_zero_indentation()),
        tie!("at(at(U_n, d, d_n), a, a_c)", ABOVE, |at| at.contact().energy_lost_at_pull_off()),
        tie!("-at(at(U_n, d, 0), a, a_0)", ABOVE, |at| at.contact().energy_lost_at_jump_in()),
        tie!("at(at(U_n, d, 0), a, a_0)", BELOW, |at| at.contact().barrier_to_complete_contact()),
        tie!("at(d_n, a, t*a_c)/(-d_c)", ABOVE, |at| universal_indentation(&at.n(), &at.value("t"))),
        tie!("at(d_n, a, t*a_c)/d_c", BELOW, |at| universal_indentation(&at.n(), &at.value("t"))),
        tie!("at(F_n, a, t*a_c)/(-F_c)", BOTH, |at| universal_force(&at.n(), &at.value("t"))),
        tie!("at(C_ρ, ρ, 1)", HALF, |at| threshold(&at.material(), &Control::Indentation)),
        tie!("at(C_ρ, ρ, 3)", HALF, |at| threshold(&at.material(), &Control::Force)),
        tie!("κ*C/sqrt(2*π*w/E)", HALF, |at| at.contact().ratio()),
        tie!("d_n", HALF, |at| Ok(at.contact().scale_free_state(&at.value("a"))?.indentation)),
        tie!("F_n", HALF, |at| Ok(at.contact().scale_free_state(&at.value("a"))?.force)),
        tie!("-at(Δl, a, R)", ALL, |at| Ok(flat_punch_pull_off(&at.value("R"), &at.material())?.indentation)),
        tie!("-sqrt(8*π*R^3*E*w)", ALL, |at| Ok(flat_punch_pull_off(&at.value("R"), &at.material())?.force)),
    ]
}

fn enclosure(value: &Rational) -> Interval {
    SamplePoint::interval(value)
}

/// The relative error of the closed form against the symbolic formula. Rounding the inputs to doubles and every step
/// changes the result by a few units of 2⁻⁵³ times its condition; the powers 1/(2n−1) of moderate exponents are at most 10,
/// the condition of differences is below 2⁷ at these points.
const DOUBLE_TOLERANCE: f64 = 4096.0 * f64::EPSILON;

/// 1/16 ≤ n ≤ 6, and |2n − 1| ≥ 1/10 or n = 1/2.
fn is_moderate(n: &Rational) -> bool {
    let excess: Rational = Rational::from(n * 2_u32) - 1_u32;
    let excess = excess.abs();
    *n >= Rational::from((1, 16)) && *n <= 6 && (excess.is_zero() || excess >= Rational::from((1, 10)))
}

#[test]
fn closed_forms_are_what_the_derivations_say() {
    for Tie { formula, domains, interval, double } in ties() {
        let symbolic: Formula = formula.parse().unwrap();
        for domain in domains {
            let mut moderate = 0;
            for point in SamplePoints::new(formula, *domain, &[]).take(24) {
                let expected = evaluate(&symbolic, *domain, &point).unwrap();
                let found = interval(&At { point: point.clone(), number: enclosure }).unwrap();
                assert!(found.overlaps(&expected), "{formula} for {}: {found} and {expected}", domain.text());
                let bits = expected.accuracy_bits().min(found.accuracy_bits());
                assert!(bits > 40, "{formula}: {found} {expected}");
                if !is_moderate(point.exponent()) {
                    continue;
                }
                moderate += 1;
                assert!(bits > 70, "{formula}: {found} {expected}");
                let nearest = double(&At { point, number: Rational::to_f64 }).unwrap();
                let error = (nearest / expected.approx() - 1.0).abs();
                assert!(error < DOUBLE_TOLERANCE, "{formula} for {}: {nearest} and {expected}", domain.text());
            }
            assert!(moderate >= 2, "{formula} for {}", domain.text());
        }
    }
}

/// Folds on a machine fulfil the symbolic condition N a^(n−1/2) = λ(a)√B, and state the symbolic d and F.
#[test]
fn folds_on_a_machine_fulfil_the_symbolic_condition() {
    let residual: Formula = "N*a^(n - 1/2)/sqrt(B) - λ".parse().unwrap();
    let states: [Formula; 2] = ["d_n", "F_n"].map(|text| text.parse().unwrap());
    for domain in BOTH {
        for point in SamplePoints::new("machine", *domain, &[]).take(8) {
            let at = At { point: point.clone(), number: enclosure };
            let fold = at.contact().critical(&at.machine()).unwrap();
            let there = point.with("a", &fold.contact_radius);
            let remains = evaluate(&residual, *domain, &there).unwrap();
            assert!(remains.contains_zero() && remains.abs() < remains.ratio(1, 1 << 40), "{remains}");
            for (formula, found) in states.iter().zip([&fold.indentation, &fold.force]) {
                assert!(evaluate(formula, *domain, &there).unwrap().overlaps(found));
            }
        }
    }
}

/// The series with three bits a turn, with the weight, the ratio and the remainder of the entry `kappa-series`, is κ_n as the
/// library encloses it; with one sign changed it is not.
#[test]
fn the_series_of_the_derivation_is_the_kappa_of_the_library() {
    const TURNS: i64 = 40;
    let entry = mdr_symbolic::derivations::entry("kappa-series").unwrap();
    let side = |text: &str| text.parse::<Formula>().unwrap();
    let weight = "(3*n/2 + 1 + 3*m)/(n/2 + 1 + 2*m)";
    let ratio = "(n + m)*(1 - n/2 + m)/(2*(n/2 + 1 + 2*m)*(n/2 + 2 + 2*m))";
    for stated in [weight, ratio] {
        let ends_with = |statement: &str| statement.ends_with(&format!("= {stated}"));
        assert!(entry.steps.iter().any(|step| step.statement.is_some_and(ends_with)), "{stated} is not in the entry");
    }
    for point in
        SamplePoints::new("series", Domain::Positive, &[]).filter(|point| is_moderate(point.exponent())).take(12)
    {
        let one = enclosure(&Rational::from(1));
        let sum = |sign: i64| {
            let (mut sum, mut product) = (one.lit(0), one.clone());
            for m in 0..TURNS {
                let there = point.with("m", &one.lit(m));
                let value = |formula: &str| evaluate(&side(formula), Domain::Positive, &there).unwrap();
                sum += &(value(weight) * &product);
                product *= &value(ratio).times(sign);
            }
            // n is at most 6, so that 40 turns are enough for the bound 2 of what is left.
            sum.inflate(&product.times(2))
        };
        let kappa = mdr_analytic::kappa_enclosure(one.ctx(), point.exponent());
        let series = sum(-1);
        assert!(series.overlaps(&kappa) && series.accuracy_bits() > 70, "{series} and {kappa}");
        assert!(!sum(1).overlaps(&kappa) || point.exponent().is_integer(), "{kappa} with the wrong sign");
    }
}

/// A formula that is wrong by one factor is found out.
#[test]
fn a_wrong_formula_is_found_out() {
    let wrong: Formula = "(B/N^2)^(1/(1 - 2*n))".parse().unwrap();
    for point in SamplePoints::new("wrong", Domain::Above, &[]).take(12) {
        let expected = evaluate(&wrong, Domain::Above, &point).unwrap();
        let at = At { point, number: enclosure };
        assert!(!at.contact().critical(&Control::Indentation).unwrap().contact_radius.overlaps(&expected));
    }
}
