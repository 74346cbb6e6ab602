//! Known equalities and inequalities of normal forms, and errors.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use mdr_symbolic::{Decision, Domain, Error, Formula, Statement, Undecided};

fn decide(text: &str, domain: Domain) -> Decision {
    text.parse::<Statement>().unwrap().decide(domain)
}

fn holds(text: &str, domain: Domain) {
    assert!(matches!(decide(text, domain), Decision::Proved { .. }), "{text}: {:?}", decide(text, domain));
}

fn fails(text: &str, domain: Domain) {
    assert!(matches!(decide(text, domain), Decision::Refuted { .. }), "{text}: {:?}", decide(text, domain));
}

#[test]
fn powers_of_integers_and_polynomials() {
    holds("4^n = 2^(2*n)", Domain::Positive);
    holds("6^n = 2^n*3^n", Domain::Positive);
    holds("sqrt(12) = 2*sqrt(3)", Domain::Positive);
    holds("2^(n/(2*n - 1)) = sqrt(2)*2^(1/(2*(2*n - 1)))", Domain::Above);
    holds("(4*n^2 - 1)^n = (2*n - 1)^n*(2*n + 1)^n", Domain::Above);
    holds("((2*n + 1)^2)^(n + 1) = (2*n + 1)^(2*n)*(4*n^2 + 4*n + 1)", Domain::Positive);
    fails("4^n = 2^n", Domain::Positive);
    fails("2^n*3^n = 5^n", Domain::Positive);
    fails("sqrt(2) + sqrt(3) = sqrt(5)", Domain::Positive);
    fails("π^n = 3^n", Domain::Positive);
}

/// √((2n−1)²) is 2n − 1 above 1/2, 1 − 2n below, and has no single form on a domain with both.
#[test]
fn signs_depend_on_the_domain() {
    holds("sqrt((2*n - 1)^2) = 2*n - 1", Domain::Above);
    holds("sqrt((2*n - 1)^2) = 1 - 2*n", Domain::Below);
    fails("sqrt((2*n - 1)^2) = 2*n - 1", Domain::Below);
    let undecided = decide("sqrt((2*n - 1)^2) = 2*n - 1", Domain::Positive);
    assert!(matches!(undecided, Decision::Undecided(Undecided::NoNormalForm(Error::NotPositive { .. }))));
    for (text, domain) in [("sqrt(1 - 2*n) = 1", Domain::Above), ("sqrt(0 - 2) = 1", Domain::Positive)] {
        let refused = decide(text, domain);
        let refused = matches!(refused, Decision::Undecided(Undecided::NoNormalForm(Error::NotPositive { .. })));
        assert!(refused, "{text}: the root of a negative number");
    }
    holds("(1 - 2*n)/n < 0", Domain::Above);
    holds("(1 - 2*n)/n > 0", Domain::Below);
    assert!(matches!(decide("a > w", Domain::Above), Decision::Undecided(Undecided::MixedSigns)));
}

/// In every quarter of a turn and beyond a whole one; other angles have no value.
#[test]
fn sines_of_parts_of_a_turn() {
    for (angle, sine) in [
        ("0*π", "0"),
        ("π/6", "1/2"),
        ("π/4", "1/sqrt(2)"),
        ("π/3", "sqrt(3)/2"),
        ("π/2", "1"),
        ("2*π/3", "sqrt(3)/2"),
        ("3*π/4", "1/sqrt(2)"),
        ("5*π/6", "1/2"),
        ("π", "0"),
        ("7*π/6", "-1/2"),
        ("3*π/2", "-1"),
        ("7*π/4", "-1/sqrt(2)"),
        ("2*π", "0"),
        ("π*7/3", "sqrt(3)/2"),
        ("-π/3", "-sqrt(3)/2"),
        ("-5*π/2", "-1"),
        ("(n*π - π)/(2*n - 2)", "1"),
    ] {
        holds(&format!("sin({angle}) = {sine}"), Domain::Positive);
    }
    holds("sin(π*n) + sin(π*n/2)^2 = 3/2", Domain::Half);
    fails("sin(π/3) = 1/2", Domain::Positive);
    for text in ["sin(π/5) = 1/2", "sin(π/12) = 1/4", "sin(π*n) = 0", "sin(1) = 1", "sin(θ) = sinθ", "sin(a*π) = 0"]
    {
        let decision = decide(text, Domain::Positive);
        let refused = matches!(decision, Decision::Undecided(Undecided::NoNormalForm(Error::Transcendental(_))));
        assert!(refused, "{text}: {}", decision.text());
    }
}

#[test]
fn derivatives_and_integrals() {
    holds("diff(a^(n + 1/2), a) = (n + 1/2)*a^(n - 1/2)", Domain::Positive);
    holds("diff(int(x^n, x, a), a) = a^n", Domain::Positive);
    holds("int((d - x^n)^2, x, a) = a*d^2 - 2*d*a^(n + 1)/(n + 1) + a^(2*n + 1)/(2*n + 1)", Domain::Positive);
    holds("diff((1 + 3*s)/(1 + s), s) = 2/(1 + s)^2", Domain::Positive);
    holds("diff(a*G, a) = G + a*g", Domain::Positive);
    let refusals = ["int(x^(-1), x, a) = 0", "int(x^(n - 2), x, a) = 0", "diff(g', a) = 0", "at(g, a, R) = 0"];
    for refused in refusals {
        assert!(matches!(decide(refused, Domain::Positive), Decision::Undecided(_)), "{refused}");
    }
}

#[test]
fn values_at_fixed_exponents() {
    holds("at(κ_Γ, n, 1) = π/2", Domain::Positive);
    holds("at(κ, n, 2) = 2", Domain::Positive);
    holds("kappa(7) = 35/32*π", Domain::Positive);
    holds("Γ(5/2) = 3*sqrt(π)/4", Domain::Positive);
    holds("Γ(5/4)*Γ(3/4) = π*sqrt(2)/4", Domain::Positive);
    holds("at((2*n + 1)^(1/n), n, 4) = sqrt(3)", Domain::Positive);
    assert!(matches!(decide("at(κ, n, 1/3) = 1", Domain::Positive), Decision::Undecided(_)));
}

#[test]
fn dimensions() {
    holds("Δl ~ a", Domain::Positive);
    holds("C*a^n ~ d", Domain::Positive);
    fails("C*a ~ d", Domain::Positive);
    fails("a + w ~ a", Domain::Positive);
}

#[test]
fn refused_texts() {
    for text in ["", "2 +", "(n", "n)", "hello", "2..5", "sqrt(n", "f(1)", "int(n, 2, a)", "at(n, 2, 3)", "$"] {
        let error = text.parse::<Formula>();
        assert!(matches!(error, Err(Error::Syntax { .. })), "{text}: {error:?}");
    }
    assert!("n".parse::<Statement>().is_err());
}

#[test]
fn printing() {
    let shown = |text: &str| {
        let formula: Formula = text.parse().unwrap();
        (formula.text(), formula.tex())
    };
    let (text, tex) = shown("-2*(2*n + 1)/(n + 1)*E*sqrt(B)*a_c^(3/2)");
    assert_eq!(text, "−2·(2·n + 1)/(n + 1)·E*·√B·a_c^(3/2)");
    assert_eq!(tex, r"-\frac{2 (2 n + 1)}{n + 1} E^* \sqrt{B} a_c^{3/2}");
    assert_eq!(shown("0.7628").0, "0.7628");
    assert_eq!(shown("g'^2").1, r"(g'(a))^{2}");
    // Brackets grow around what is tall only, exponents stay on a line, and repeated operators are one.
    assert_eq!(shown("(B/N^2)^(1/(2*n - 1))").1, r"\left(\frac{B}{N^{2}}\right)^{1/(2 n - 1)}");
    assert_eq!(shown("diff(diff(d_n, a), a)").1, r"\frac{d^2}{da^2} \, d_n(a)");
    assert_eq!(shown("at(at(F_c, n, 2), C, 1/(2*R))").1, r"[F_c]_{n = 2,\; C = 1/(2 R)}");
}

/// The crate uses rational arithmetic only.
#[test]
fn there_are_no_floats() {
    fn sources(directory: &std::path::Path, found: &mut Vec<String>) {
        for entry in std::fs::read_dir(directory).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                sources(&path, found);
            } else {
                found.push(std::fs::read_to_string(path).unwrap());
            }
        }
    }
    let mut found = Vec::new();
    sources(&std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut found);
    assert!(found.len() > 15);
    for source in found {
        assert!(!["f64", "f32", "Float"].iter().any(|float| source.contains(float)));
    }
}
