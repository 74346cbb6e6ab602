//! The number of folds of a power law on a machine.

use super::{ABOVE, Entry, POSITIVE, Step};

/// Values for a contact with three folds.
const THREE: &[(&str, &str)] = &[("n", "3/5"), ("C", "2.4829"), ("E", "1"), ("w", "1"), ("k", "1"), ("a", "0.01")];
const SECOND: &[(&str, &str)] = &[("n", "3/5"), ("C", "2.4829"), ("E", "1"), ("w", "1"), ("k", "1"), ("a", "0.03")];
const THIRD: &[(&str, &str)] = &[("n", "3/5"), ("C", "2.4829"), ("E", "1"), ("w", "1"), ("k", "1"), ("a", "1")];
const FOURTH: &[(&str, &str)] = &[("n", "3/5"), ("C", "2.4829"), ("E", "1"), ("w", "1"), ("k", "1"), ("a", "1000")];

pub(super) const FOLDS: Entry = Entry {
    id: "machine-folds",
    title: "Up to three folds on a machine",
    refuted: false,
    assumptions: &[
        "$f = C r^n$ with `n > 0`",
        "the position $d + F/k$ of a machine of stiffness `k > 0` is controlled",
    ],
    steps: &[
        Step::proved(
            POSITIVE,
            "at(λ, a, s*k/(2*E)) = (1 + 3*s)/(1 + s)",
            "In units of the machine's stiffness, `s = 2*E*a/k`. With $u = \\ln s$ and `μ = n - 1/2` the logarithm of the condition \
             `N*a^(n - 1/2) = λ*sqrt(B)` reads $\\varphi(u) = 0$, $\\varphi = \\mu u + \\text{const} - \\ln \\lambda$.",
        ),
        Step::proved(
            POSITIVE,
            "s*diff((1 + 3*s)/(1 + s), s)*(1 + s)/(1 + 3*s) = h",
            "$d \\ln \\lambda/du$ is `h = 2*s/((1 + s)*(1 + 3*s))`, so $\\varphi' = \\mu - h(s)$.",
        ),
        Step::proved(
            POSITIVE,
            "(1 + s)*(1 + 3*s)*(μ - h) = 3*μ*s^2 - 2*(1 - 2*μ)*s + μ",
            "$\\varphi'$ has the zeros of a quadratic polynomial, at most two. So $\\varphi$ is made of at most three monotone pieces and has \
             at most three zeros: there are at most three folds.",
        ),
        Step::proved(
            POSITIVE,
            "2 - sqrt(3) - h = (2 - sqrt(3))*(1 - sqrt(3)*s)^2/((1 + s)*(1 + 3*s))",
            "`h` is never above `2 - sqrt(3)`, and reaches it at `s = 1/sqrt(3)` only. So $\\varphi$ is monotone for $\\mu \\le 0$ and for $\\mu \\ge 2 - \\sqrt3$, and \
             there is no more than one fold.",
        ),
        Step::proved(
            POSITIVE,
            "(1 - 2*μ)^2 - 3*μ^2 = (1 - (2 + sqrt(3))*μ)*(1 - (2 - sqrt(3))*μ)",
            "A quarter of the discriminant of the quadratic. For $0 \\lt \\mu \\lt 2 - \\sqrt3$ it is positive, and as the sum and the product \
             of the zeros are positive, both are: $\\varphi$ has a maximum and a minimum.",
        ),
        Step::proved(
            POSITIVE,
            "1/2 + (2 - sqrt(3)) = 5/2 - sqrt(3)",
            "So three folds are possible for $\\tfrac12 \\lt n \\lt \\tfrac52 - \\sqrt3 \\approx 0.768$, for machines of suitable stiffness, and for no other `n`.",
        ),
        Step::at(
            THREE,
            ABOVE,
            "k*diff(d_n + F_n/k, a) < 0",
            "They occur: here is a contact with `n = 0.6`. The position falls with the contact radius at `a = 0.01`,",
        ),
        Step::at(SECOND, ABOVE, "k*diff(d_n + F_n/k, a) > 0", "grows at `a = 0.03`,"),
        Step::at(THIRD, ABOVE, "k*diff(d_n + F_n/k, a) < 0", "falls at `a = 1`,"),
        Step::at(
            FOURTH,
            ABOVE,
            "k*diff(d_n + F_n/k, a) > 0",
            "and grows at `a = 1000`. Between these radii lie three folds.",
        ),
    ],
    erratum: None,
    references: &[],
};

pub(super) const HALF: Entry = Entry {
    id: "machine-half",
    title: "The fold on a machine at n = 1/2",
    refuted: false,
    assumptions: &["$f = C r^{1/2}$", "the position $d + F/k$ of a machine of stiffness `k > 0` is controlled"],
    steps: &[
        Step::proved(
            super::HALF,
            "at(k*diff(d_n + F_n/k, a), C, C_ρ) = (k + 2*E*a)*sqrt(B/a)*(ρ - λ)",
            "With the ratio `ρ` of `C` to its threshold, `C_ρ = ρ/κ*sqrt(2*π*w/E)`. `λ` grows from 1 to 3 with `a` (see \
             critical-machine): there is no fold for $\\rho \\le 1$ or $\\rho \\ge 3$, and one between.",
        ),
        Step::proved(super::HALF, "at(λ, a, a_k) = ρ", "It lies at `a_k = k*(ρ - 1)/(2*E*(3 - ρ))`."),
    ],
    erratum: None,
    references: &[],
};
