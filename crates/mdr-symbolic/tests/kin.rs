//! Statements that are false, or in which a part has no value: none may be proved.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use mdr_symbolic::{Decision, Domain, Statement};

fn proved(text: &str, domain: Domain) -> bool {
    matches!(text.parse::<Statement>().unwrap().decide(domain), Decision::Proved { .. })
}

/// Divisors that are 0 where a value is put in, behind an operation.
const BEHIND_AN_OPERATION: &[(&str, Domain)] = &[
    ("at(at(x/y, x, y), y, 0) = 1", Domain::Positive),
    ("at(y/at(x, x, y), y, 0) = 1", Domain::Positive),
    ("at(y/int(1, x, y), y, 0) = 1", Domain::Positive),
    ("at(y/diff(x*y, x), y, 0) = 1", Domain::Positive),
    ("at(2*y/diff(y^2, y), y, 0) = 1", Domain::Positive),
    ("at(int(x, x, y)/y^2, y, 0) = 1/2", Domain::Positive),
    ("at(diff(int(t^2, t, x)/x, x), x, 0) = 0", Domain::Positive),
    ("at(int(diff(t*y, t)/y, t, a), y, 0) = a", Domain::Positive),
    ("at(y*int(1/y, x, a), y, 0) = a", Domain::Positive),
    ("at(int(x, x, a*y)/int(x, x, a*y), y, 0) = 1", Domain::Positive),
    ("at(int(diff(y*x/y, x), x, a), y, 0) = a", Domain::Positive),
    ("at(diff(int(x*y/y, x, a), a), y, 0) = a", Domain::Positive),
    ("at(diff(a*y/y, a), y, 0) = 1", Domain::Positive),
    ("at(diff(x^3/x, x), x, 0) = 0", Domain::Positive),
    ("at(diff(y^2*a/(y + y^2), a), y, 0) = 0", Domain::Positive),
    ("at(x/(x^2 + x), x, 0) = 1", Domain::Positive),
    ("at((x^2 - 1)/(x - 1), x, 1) = 2", Domain::Positive),
    ("at((x^n - 1)/(x^n - 1), x, 1) = 1", Domain::Positive),
    ("at((x^n - a^n)/(x^n - a^n), x, a) = 1", Domain::Positive),
    ("at((2^n - 4)/(2^n - 4), n, 2) = 1", Domain::Positive),
    ("at(1/(1/y + 1/y^2), y, 0) = 0", Domain::Positive),
    ("at(int(1/(1/y), x, a), y, 0) = 0", Domain::Positive),
    ("int(at(y/y, y, x - x), x, a) = a", Domain::Positive),
    ("at(a, x, at(1/y, y, 0)) = a", Domain::Positive),
    ("int(a, x, at(y/y, y, 0)) = a", Domain::Positive),
    ("at(a^(y/y), y, 0) = a", Domain::Positive),
    ("at((x/x)^0, x, 0) = 1", Domain::Positive),
    ("1^(1/(d - d)) = 1", Domain::Positive),
    ("diff(d/(a - a)*0, d) = 0", Domain::Positive),
    ("at(at(x*z/(x*z), x, y - 1), y, 1) = 1", Domain::Positive),
    ("at(at(a*(n - d)/(n - d), n, 1), d, 1) = a", Domain::Positive),
    ("at(x/x, x, 0) < 2", Domain::Positive),
    ("at(x/x, x, 0) ~ 1", Domain::Positive),
];

/// 0 to a power that is calculated, or of no certain sign.
const POWERS_OF_ZERO: &[(&str, Domain)] = &[
    ("at(x^(n - n), x, 0) = 1", Domain::Positive),
    ("(a - a)^(n - n) = 1", Domain::Positive),
    ("(a - a)^(2 - n - 2 + n) = 1", Domain::Positive),
    ("at(x^(n/n - 1), x, 0) = 1", Domain::Positive),
    ("at((x^2)^(n - n), x, 0) = 1", Domain::Positive),
    ("at((a - d)^(n*0), a, d) = 1", Domain::Positive),
    ("(2*n - 1)^(n - n) = 1", Domain::Half),
    ("at(x^(2*n - 1), x, 0) = 1", Domain::Half),
    ("0^(n - 1) = 0", Domain::Positive),
    ("0^(2*n - 1) = 0", Domain::Below),
    ("(a - a)^(1 - 2*n) = 0", Domain::Above),
    ("at(x^(n - n + 1)/x^(n - n), x, 0) = 0", Domain::Positive),
];

/// Constants that cancel: radicals, sines, Γ and κ.
const CONSTANTS_THAT_CANCEL: &[(&str, Domain)] = &[
    ("(sqrt(2)*sqrt(3) - sqrt(6))/(sqrt(2)*sqrt(3) - sqrt(6)) = 1", Domain::Positive),
    ("0*(sqrt(8) - 2*sqrt(2))^(-1) = 0", Domain::Positive),
    ("(4^n - 2^(2*n))/(4^n - 2^(2*n)) = 1", Domain::Positive),
    ("(sin(π/6) - 1/2)/(sin(π/6) - 1/2) = 1", Domain::Positive),
    ("(Γ(1/2)^2 - π)/(Γ(1/2)^2 - π) = 1", Domain::Positive),
    ("(Γ(n/2 + 1) - n/2*Γ(n/2))/(Γ(n/2 + 1) - n/2*Γ(n/2)) = 1", Domain::Positive),
    ("(Γ(1/4)*Γ(3/4) - π*sqrt(2))/(Γ(1/4)*Γ(3/4) - π*sqrt(2)) = 1", Domain::Positive),
    ("(kappa(n)*kappa(n + 1) - π*(n + 1)/2)/(kappa(n)*kappa(n + 1) - π*(n + 1)/2) = 1", Domain::Positive),
    ("(κ*kappa(n + 1) - π*(n + 1)/2)/(κ*kappa(n + 1) - π*(n + 1)/2) = 1", Domain::Positive),
    ("(diff(G, a) - g)/(diff(G, a) - g) = 1", Domain::Positive),
    ("at(Γ((n - 3)/2)/Γ((n - 3)/2), n, 1) = 1", Domain::Positive),
    ("0*Γ(0) = 0", Domain::Positive),
    ("kappa(-2) - kappa(-2) = 0", Domain::Positive),
];

/// Signs: roots of squares, powers of negative numbers, sums that may be 0.
const SIGNS: &[(&str, Domain)] = &[
    ("sqrt((a - d)^2) = a - d", Domain::Positive),
    ("((a - d)^4)^(1/4) = a - d", Domain::Positive),
    ("((a - d)^(2*n))^(1/(2*n)) = a - d", Domain::Positive),
    ("sqrt(a^2 - 2*a*d + d^2) = a - d", Domain::Positive),
    ("sqrt((n - 1)^2) = n - 1", Domain::Positive),
    ("sqrt((1 - 2*n)^2) = 1 - 2*n", Domain::Above),
    ("((-a)^2)^(1/2) = -a", Domain::Positive),
    ("(-a)^(2*n) = a^(2*n)", Domain::Positive),
    ("(-1)^(2*n) = 1", Domain::Positive),
    ("int(sqrt((x - d)^2), x, a) = a^2/2 - d*a", Domain::Positive),
    ("int((x^2)^(1/2)/x, x, -a) = -a", Domain::Positive),
    ("at(int(sqrt(y^2)/y, x, a), y, -d) = a", Domain::Positive),
    ("diff(sqrt((a - d)^2), a) = 1", Domain::Positive),
    ("at(diff((y^2)^(n - n + 1/2), y), y, -d) = 1", Domain::Positive),
    ("at(y^(2*n)*y^(-2*n), y, -d) = 1", Domain::Positive),
    ("0 < (a - d)^2", Domain::Positive),
    ("0 < (n - 1)^2", Domain::Positive),
    ("0 < n^4 - 2*n^2 + 1", Domain::Positive),
    ("a < a + (n - 1)^2", Domain::Positive),
];

/// Integrals that do not exist.
const INTEGRALS: &[(&str, Domain)] = &[
    ("int(x^(n - 2), x, a) = a^(n - 1)/(n - 1)", Domain::Positive),
    ("int(x^(2*n - 2), x, a) = a^(2*n - 1)/(2*n - 1)", Domain::Below),
    ("int(x^(-1), x, a) - int(x^(-1), x, a) = 0", Domain::Positive),
    ("0*int(x^(-2), x, a) = 0", Domain::Positive),
    ("int(1/x^2, x, a) = -1/a", Domain::Positive),
    ("int(x^(-n), x, a)/int(x^(-n), x, a) = 1", Domain::Positive),
    ("diff(int(x^(-1), x, a), a) = 1/a", Domain::Positive),
    ("diff(int(1/x^n, x, a), a) = a^(-n)", Domain::Positive),
];

#[test]
fn nothing_false_is_proved() {
    let all = [BEHIND_AN_OPERATION, POWERS_OF_ZERO, CONSTANTS_THAT_CANCEL, SIGNS, INTEGRALS].concat();
    assert!(all.len() > 80, "{}", all.len());
    for (text, domain) in all {
        assert!(!proved(text, domain), "{text} on {}", domain.text());
    }
    // Beside them, what is true is proved.
    for (text, domain) in [
        ("at(at(x/y, x, y), y, d) = 1", Domain::Positive),
        ("at(x^(n - n), x, d) = 1", Domain::Positive),
        ("at((a - d)^0, a, d) = 1", Domain::Positive),
        ("Γ(1/4)*Γ(3/4) = π*sqrt(2)", Domain::Positive),
        ("kappa(n)*kappa(n + 1) = π*(n + 1)/2", Domain::Positive),
        ("sqrt((1 - 2*n)^2) = 2*n - 1", Domain::Above),
        ("0 < (2*n - 1)^2", Domain::Above),
        ("int(x^(n - 1), x, a) = a^n/n", Domain::Positive),
        ("int(y^(-n)*y^n, y, a) = a", Domain::Positive),
    ] {
        assert!(proved(text, domain), "{text} on {}", domain.text());
    }
}
