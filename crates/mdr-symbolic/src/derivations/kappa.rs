//! The factor κ: recurrences, series without the Gamma function, and means.

use super::{BELOW, Entry, HALF, POSITIVE, Step};

pub(super) const RECURRENCES: Entry = Entry {
    id: "kappa-recurrences",
    title: "Recurrences of κ",
    refuted: false,
    assumptions: &["`n > 0`"],
    steps: &[
        Step::proved(POSITIVE, "kappa(n) = sqrt(π)/2*n*Γ(n/2)/Γ((n + 1)/2)", "The definition (1.12)."),
        Step::proved(POSITIVE, "kappa(n)*kappa(n + 1) = π*(n + 1)/2", "By $\\Gamma(z + 1) = z \\, \\Gamma(z)$."),
        Step::proved(
            POSITIVE,
            "kappa(n + 2) = kappa(n)*(n + 2)/(n + 1)",
            "By the same rule, or by the equality of integrals in 1.1: it carries `κ` through all exponents that differ by 2.",
        ),
        Step::proved(POSITIVE, "kappa(4) = 8/3", "That is `kappa(2)*4/3`."),
        Step::proved(POSITIVE, "kappa(3) = 3*π/4", "That is `kappa(1)*3/2`."),
    ],
    erratum: None,
    references: &[],
};

pub(super) const GROWTH: Entry = Entry {
    id: "kappa-growth",
    title: "κ grows with n",
    refuted: false,
    assumptions: &["`n > 0`"],
    steps: &[
        Step::proved(
            POSITIVE,
            "diff(sinθ^n, θ) = n*sinθ^(n - 1)*cosθ",
            "By 1.1 and 1.12, `κ = n*turn(sinθ^(n - 1))`. With `x = sinθ^n` that is $\\kappa_n = \\int_0^1 dx/\\cos\\theta$, \
             where `cosθ = sqrt(1 - x^(2/n))`.",
        ),
        Step::proved(
            POSITIVE,
            "2/n - 2/(n + ε) > 0",
            "The exponent $2/n$ falls when `n` grows, by any `ε > 0`. As $0 \\lt x \\lt 1$, `x^(2/n)` grows at every `x`, and the integrand with it: \
             `κ` grows with `n`.",
        ),
        Step::enclosed(POSITIVE, "kappa(n + 1) > kappa(n)", "A check in numbers."),
    ],
    erratum: None,
    references: &[],
};

pub(super) const SERIES: Entry = Entry {
    id: "kappa-series",
    title: "Series for κ without the Gamma function",
    refuted: false,
    assumptions: &["$f(b, c) = {}_2F_1(1, b; c; \\tfrac12)$ is the sum of terms $t_j$ with $t_0 = 1$", "`n > 0`"],
    steps: &[
        Step::enclosed(
            POSITIVE,
            "f(n, 1 + n/2) = κ_Γ",
            "Gauss's second theorem, cited; the enclosure sums the series and bounds its tail by a geometric series.",
        ),
        Step::proved(
            POSITIVE,
            "at(q, j, 0) = b/(2*c)",
            "The ratio $t_{j+1}/t_j$ is `q = (b + j)/(2*(c + j))`. So $t_1 = b/2c$,",
        ),
        Step::proved(
            POSITIVE,
            "at(q, j, j + 1) = at(at(q, b, b + 1), c, c + 1)",
            "and from there on the ratios are those of $f(b+1, c+1)$: $f(b,c) = 1 + \\frac{b}{2c} f(b+1,c+1)$.",
        ),
        Step::proved(
            POSITIVE,
            "at(c/(c + j), j, j + 1)*(c + j)/c = at(q, c, c + 1)/q",
            "The terms of $f(b, c+1)$ are `c/(c + j)` times those of $f(b, c)$: both are 1 at `j = 0`, and the ratios agree.",
        ),
        Step::proved(
            POSITIVE,
            "1 + (c - b)/c*c/(c + j) = 2*(1 - q)",
            "So the terms of $f(b,c) + \\frac{c-b}{c} f(b,c+1)$ are $2t_j - 2t_{j+1}$, and their sum is $2t_0$: \
             $f(b,c) = 2 - \\frac{c-b}{c} f(b,c+1)$.",
        ),
        Step::proved(
            POSITIVE,
            "1 + b/(2*c)*(2 - (c - b)/(c + 1)*z) = (b + c)/c - b*(c - b)/(2*c*(c + 1))*z",
            "Both in turn, with `z` for $f(b+1, c+2)$.",
        ),
        Step::proved(
            POSITIVE,
            "at(at((b + c)/c, b, n + m), c, 1 + n/2 + 2*m) = (3*n/2 + 1 + 3*m)/(n/2 + 1 + 2*m)",
            "Started at `b = n`, `c = 1 + n/2`, the turn $m$ has `b = n + m`, `c = 1 + n/2 + 2*m`, and contributes this,",
        ),
        Step::proved(
            POSITIVE,
            "at(at(b*(c - b)/(2*c*(c + 1)), b, n + m), c, 1 + n/2 + 2*m) \
             = (n + m)*(1 - n/2 + m)/(2*(n/2 + 1 + 2*m)*(n/2 + 2 + 2*m))",
            "times the product of these with alternating sign, which tends to 1/8: three bits a turn. For even `n` the series ends.",
        ),
        Step::proved(
            POSITIVE,
            "1/8 - (n + m)*(1 - n/2 + m)/(2*(n/2 + 1 + 2*m)*(n/2 + 2 + 2*m)) \
             = ((3*n/2 - 5/6)^2 + 47/36 + 2*m)/(8*(n/2 + 1 + 2*m)*(n/2 + 2 + 2*m))",
            "From the turn $m \\ge n/2 - 1$ on, where the ratio is not negative, it is below 1/8;",
        ),
        Step::proved(
            POSITIVE,
            "1 + (n + m)*(1 - n/2 + m)/(2*(n/2 + 1 + 2*m)*(n/2 + 2 + 2*m)) \
             = (4 + 4*n + 13*m + 9*n*m/2 + 9*m^2)/(2*(n/2 + 1 + 2*m)*(n/2 + 2 + 2*m))",
            "before it is negative and above −1: the products decrease, and have one sign.",
        ),
        Step::proved(
            POSITIVE,
            "1/2 - q = (c - b)/(2*(c + j))",
            "Where $b \\le c$ no term of $f(b, c)$ exceeds half of the one before, so that $0 \\lt f \\le 2$.",
        ),
        Step::proved(
            POSITIVE,
            "at(at(c - b, b, n + m), c, 1 + n/2 + 2*m) = 1 - n/2 + m",
            "What $m$ turns leave over is $f$ for these `b` and `c` times the product of $m$ factors: for $m \\ge n/2 - 1$ at most twice that \
             product, and at most $2 \\cdot 8^{-j}$ when $j$ of the turns came after the first that is $\\ge n/2 - 1$.",
        ),
    ],
    erratum: None,
    references: &["NIST Digital Library of Mathematical Functions, §15.4 and §15.5"],
};

pub(super) const ELLIPTIC: Entry = Entry {
    id: "kappa-elliptic",
    title: "κ by an arithmetic-geometric mean",
    refuted: false,
    assumptions: &["$n = p/q$ with $q \\le 4$"],
    steps: &[
        Step::cited(
            "By kappa-growth $\\kappa_n = \\int_0^1 dx/\\sqrt{1 - x^{2/n}}$. For $n = \\tfrac12, \\tfrac13, \\tfrac14$ it is a complete elliptic \
             integral up to square roots: that of the first, third and second singular modulus.",
        ),
        Step::enclosed(
            POSITIVE,
            "turn(1/sqrt(cosθ^2 + n^2*sinθ^2)) = π/(2*agm(1, n))",
            "A complete elliptic integral is a mean, by Gauss. Here `n` is any positive number.",
        ),
        Step::enclosed(
            HALF,
            "kappa(1/2) = π/(2*agm(1, sqrt(2)))",
            "The first modulus, `1/sqrt(2)`: half the lemniscate constant.",
        ),
        Step::enclosed(
            HALF,
            "kappa(1/3) = π/(3^(1/4)*agm(2, sqrt(2 + sqrt(3))))",
            "The third, `(sqrt(6) - sqrt(2))/4`.",
        ),
        Step::enclosed(
            HALF,
            "kappa(1/4) = π*(1 + sqrt(2))/(4*agm(1, 1 + sqrt(2)))",
            "The second, `sqrt(2) - 1`, after one step of the mean.",
        ),
        Step::enclosed(
            BELOW,
            "kappa(1 - n) = kappa(n)*(1 - n)/n*sin(π*n)/(2 - 2*sin(π*n/2)^2)",
            "The reflection $\\Gamma(z) \\, \\Gamma(1 - z) = \\pi/\\sin \\pi z$ at `z = n/2` and `z = (1 - n)/2`, divided: what stands at the end is $\\tan(\\pi n/2)$.",
        ),
        Step::enclosed(HALF, "kappa(2/3) = 2*kappa(1/3)/sqrt(3)", "In thirds, $\\tan(\\pi/6) = 1/\\sqrt3$."),
        Step::enclosed(
            HALF,
            "kappa(3/4) = 3*kappa(1/4)/(1 + sqrt(2))",
            "In quarters, $\\tan(\\pi/8) = 1/(1 + \\sqrt2)$.",
        ),
        Step::proved(
            POSITIVE,
            "kappa(n + 1) = π*(n + 1)/(2*kappa(n))",
            "This, and `kappa(n + 2) = kappa(n)*(n + 2)/(n + 1)`, carry them to all `n` of the same denominators; integers start from 1 and `π/2`.",
        ),
        Step::enclosed(
            BELOW,
            "agm(1 + n, 1 - n) < 1 - n^2/4",
            "How a mean is cut short: when its two numbers have become $m (1 \\pm e)$ with $e \\lt \\tfrac12$, it is $m$ times that of $1 \\pm e$. With `n` \
             in the place of $e$, that is below this,",
        ),
        Step::enclosed(BELOW, "agm(1 + n, 1 - n) > 1 - n^2/4 - n^4/4", "And it is above this."),
    ],
    erratum: None,
    references: &[
        "A. Selberg, S. Chowla, On Epstein's zeta-function, J. reine angew. Math. 227 (1967) 86–110",
        "J. M. Borwein, P. B. Borwein, Pi and the AGM, Wiley 1987",
    ],
};
