//! The derivations hold, and the judge can say no.

use mdr_crosscheck::derivations::{Document, Judgement, MutantVerdict, Mutants, SamplePoints, judge, judge_all};
use mdr_symbolic::derivations::{Claim, Entry, Step};
use mdr_symbolic::{Domain, Statement};

#[test]
fn every_entry_holds() {
    let judgements = judge_all();
    let mutants: Mutants = judgements.iter().map(Judgement::mutants).sum();
    let count = |fate| mutants.count(fate);
    assert_eq!(MutantVerdict::ALL.map(count).iter().sum::<usize>(), mutants.len());
    assert!(
        count(MutantVerdict::NormalForm) > 1500 && count(MutantVerdict::Enclosure) > 100,
        "{:?}",
        MutantVerdict::ALL.map(count)
    );
    assert!(
        count(MutantVerdict::Meaningless) < 20 && count(MutantVerdict::Undecided) == 0,
        "{:?}",
        MutantVerdict::ALL.map(count)
    );
    let latex = Document::All(&judgements).latex();
    assert_eq!(latex.matches('{').count(), latex.matches('}').count(), "{latex}");
    assert!(latex.chars().all(|c| (c as u32) < 0x180), "beyond Latin letters everything is TeX: {latex}");
    for judgement in judgements {
        for step in &judgement.steps {
            let survivors: Vec<_> = step.mutants.with(MutantVerdict::Survives).map(|mutant| mutant.text()).collect();
            let judged = matches!(step.step.claim, Claim::Proved | Claim::Enclosed);
            assert_eq!(step.mutants.is_empty(), !judged, "{}: {:?}", judgement.entry.id, step.step.statement);
            assert!(
                step.holds(),
                "{}: {:?}: {:?} {survivors:?}",
                judgement.entry.id,
                step.step.statement,
                step.failure
            );
        }
    }
}

const fn step(claim: Claim, statement: &'static str) -> Step {
    Step { claim, domains: &[Domain::Above], statement: Some(statement), point: &[], why: "" }
}

/// False claims of every kind.
static FALSE: [Step; 8] = [
    step(Claim::Proved, "a_c = (B/N^2)^(1/(1 - 2*n))"),
    step(Claim::Proved, "F_c > 0"),
    step(Claim::Proved, "C*a ~ a"),
    step(Claim::Refuted, "4^n = 2^(2*n)"),
    step(Claim::Enclosed, "turn(sinθ) = 1.01"),
    step(Claim::Enclosed, "turn(sinθ^(n + 1)) > 1"),
    step(Claim::Enclosed, "agm(1, sqrt(2)) = π/2"),
    step(Claim::Enclosed, "Γ(-n) = 1"),
];

#[test]
fn false_claims_fail() {
    static ENTRY: Entry = entry(&FALSE);
    let judgement = judge(&ENTRY);
    let first = judgement.steps[0].failure.as_deref().unwrap_or_default();
    assert!(first.starts_with("for n > 1/2 normal forms say refuted: left minus right is "), "{first}");
    for step in judgement.steps {
        assert!(step.failure.is_some(), "{:?}", step.step.statement);
    }
}

const fn entry(steps: &'static [Step]) -> Entry {
    Entry { id: "probe", title: "", refuted: false, assumptions: &[], steps, erratum: None, references: &[] }
}

/// Each fate of a mutant, from steps that hold as such.
#[test]
fn mutants_have_their_fates() {
    static STEPS: [Step; 6] = [
        step(Claim::Proved, "0*a = 0"),
        step(Claim::Proved, "at(3 - 2*n, n, 3/2) = 0"),
        step(Claim::Proved, "at(6/(3 - n), n, 2) = 6"),
        step(Claim::Proved, "κ_Γ = kappa(n)"),
        step(Claim::Enclosed, "turn(sinθ^n) > 0"),
        step(Claim::Enclosed, "turn(1/(1 + sinθ)) = 1"),
    ];
    static ENTRY: Entry = entry(&STEPS);
    let judgement = judge(&ENTRY);
    let fates = |i: usize| MutantVerdict::ALL.map(|fate| judgement.steps[i].mutants.count(fate));
    let [_, _, _, _, surviving] = fates(0);
    assert!(surviving > 0, "0 times anything is 0: {:?}", fates(0));
    assert!(!judgement.steps[0].holds());
    assert!(fates(1)[0] > 0 && fates(1)[4] == 0, "{:?}", fates(1));
    assert!(fates(2)[2] == 1, "n = 3 is a pole: {:?}", fates(2));
    assert!(fates(3)[1] > 0, "κ and the Gamma functions are related: {:?}", fates(3));
    assert_eq!(fates(4), [0, 1, 0, 0, 0]);
    let undecided: Vec<_> = judgement.steps[5].mutants.with(MutantVerdict::Undecided).map(Statement::text).collect();
    let cancelling = ["∫₀^(π/2) 1/(−1 + sinθ) dθ = 1", "∫₀^(π/2) 1/(1 − sinθ) dθ = 1"];
    assert_eq!(undecided, cancelling, "{:?}", fates(5));
    for judged in &judgement.steps[1..] {
        assert!(judged.holds(), "{:?}: {:?}", judged.step.statement, judged.failure);
    }
}

/// Integrands that are infinite at an end, or look so as they are written; values of Γ to the left of 0.
#[test]
fn improper_integrals_are_enclosed() {
    static STEPS: [Step; 8] = [
        step(Claim::Enclosed, "turn(1/sqrt(sinθ)) = sqrt(π)/2*Γ(1/4)/Γ(3/4)"),
        step(Claim::Enclosed, "turn(1/sqrt(cosθ)) = sqrt(π)/2*Γ(1/4)/Γ(3/4)"),
        step(Claim::Enclosed, "turn(sqrt(cosθ/sinθ)) = π/sqrt(2)"),
        step(Claim::Enclosed, "turn(θ^(-3/4)) = 4*(π/2)^(1/4)"),
        step(Claim::Enclosed, "turn(1/sqrt(cosθ^(-2) + sinθ^2)) < 1"),
        step(Claim::Enclosed, "turn(1/sqrt(cosθ^(-2) + sinθ^2)) = turn(1/sqrt(cosθ^2 + sinθ^(-2)))"),
        Step { domains: &[Domain::Below], ..step(Claim::Enclosed, "n*turn(sinθ^(n - 1)) = kappa(n)") },
        Step {
            domains: &[Domain::Positive],
            ..step(Claim::Enclosed, "Γ(-n - 1/3) = -π/(sin(π*(n + 1/3))*Γ(n + 4/3))")
        },
    ];
    static ENTRY: Entry = entry(&STEPS);
    for judged in judge(&ENTRY).steps {
        assert_eq!((judged.failure, judged.certain), (None, judged.points), "{:?}", judged.step.statement);
    }
}

/// ∫ x^(−n) exists for n < 1. On a domain that reaches beyond, the points where it does decide; where none does it is
/// meaningless.
#[test]
fn integrals_that_exist_for_some_exponents() {
    const POWER: Step = step(Claim::Proved, "int(x^n, x, a) = a^(n + 1)/(n + 1)");
    static STEPS: [Step; 2] = [POWER, Step { point: &[("n", "1"), ("a", "2")], ..POWER }];
    static ENTRY: Entry = entry(&STEPS);
    let judgement = judge(&ENTRY);
    let fates = |i: usize, fate| judgement.steps[i].mutants.with(fate).map(Statement::text).collect::<Vec<_>>();
    let negative = "∫₀^a x^(−n) dx = a^(n + 1)/(n + 1)".to_owned();
    assert!(fates(0, MutantVerdict::Enclosure).contains(&negative), "{:?}", judgement.steps[0].mutants);
    assert_eq!(fates(1, MutantVerdict::Meaningless), [negative]);
}

/// Each reason for which a mutant has no value at any point: an integral that diverges at either end, a root of a number that
/// is negative beside an end, a divisor that is 0 by exact algebra.
#[test]
fn mutants_without_a_value() {
    static STEPS: [Step; 3] = [
        step(Claim::Enclosed, "turn(cosθ^2) = turn(sinθ^2)"),
        step(Claim::Enclosed, "turn(sqrt(cosθ^2 + n^2*sinθ^2)) = turn(sqrt(sinθ^2 + n^2*cosθ^2))"),
        step(Claim::Enclosed, "H0(a)/(1 + sin(π/2)) = H0(a)/2"),
    ];
    static ENTRY: Entry = entry(&STEPS);
    let judgement = judge(&ENTRY);
    let texts = |i: usize, fate| judgement.steps[i].mutants.with(fate).map(Statement::text).collect::<Vec<_>>();
    for (i, meaningless) in [2, 8, 2].into_iter().enumerate() {
        assert_eq!(
            texts(i, MutantVerdict::Meaningless).len(),
            meaningless,
            "{:?}",
            texts(i, MutantVerdict::Meaningless)
        );
        assert!(texts(i, MutantVerdict::Enclosure).len() >= 2, "{:?}", judgement.steps[i].mutants);
        assert!(texts(i, MutantVerdict::Undecided).is_empty(), "{:?}", texts(i, MutantVerdict::Undecided));
        assert!(judgement.steps[i].holds(), "{:?}", judgement.steps[i].failure);
    }
}

/// n is spread evenly in its logarithm, over both ends of what is promised.
#[test]
fn points_reach_small_and_large_exponents() {
    let share = |domain, below: f64| {
        let points = SamplePoints::new("a", domain, &[]).take(1000);
        let exponents: Vec<_> = points.map(|point| point.exponent().clone()).collect();
        assert!(exponents.iter().all(|n| domain.contains(n)), "{domain:?}");
        let (lowest, highest) = (exponents.iter().min().unwrap(), exponents.iter().max().unwrap());
        assert!(*lowest < 0.002 || domain == Domain::Above, "{domain:?}: {lowest}");
        assert!(*highest > 600 || domain == Domain::Below, "{domain:?}: {highest}");
        exponents.iter().filter(|n| **n < below).count()
    };
    assert!((400..600).contains(&share(Domain::Positive, 1.0)));
    assert!((400..600).contains(&share(Domain::Above, 1.5)));
    assert!((400..600).contains(&share(Domain::Below, 0.25)));
}

/// Sine, cosine and angle belong together, at a point as under an integral.
#[test]
fn points_have_one_angle() {
    static STEPS: [Step; 4] = [
        step(Claim::Proved, "sinθ^2 + cosθ^2 = 1"),
        step(Claim::Enclosed, "sqrt(1 - cosθ^2) = sinθ"),
        step(Claim::Enclosed, "sin(θ) = sinθ"),
        step(Claim::Enclosed, "turn(sin(θ)) = 1"),
    ];
    static ENTRY: Entry = entry(&STEPS);
    for judged in judge(&ENTRY).steps {
        assert!(judged.holds(), "{:?}: {:?} {:?}", judged.step.statement, judged.failure, judged.mutants);
    }
}
