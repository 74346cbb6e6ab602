#!/usr/bin/env python3
"""The fits of the critical states over a grid in double precision.

    pip install mpmath
    python3 scripts/grid_table.py > crates/mdr-analytic/data/grid.rs

Checked in: the output under mpmath 1.4.1 and Python 3.11.

κ²(n) = (κ²(1/2) − π/4) + nπ/2 − (2n − 1) X(n): X is smooth for all n > 0, between 0 and 0.067, and rational in 1/n to all
orders at infinity. The fit has degrees 7 and 8; it interpolates at Chebyshev points of (n − s)/(n + s), and all its
coefficients are positive. Its error counts relatively to κ², since that is what ln a sees, however near to n = 1/2.

artanh(s) = s + s³/3 + s⁵(1/5 + w R(w)), w = s²; and eʳ = 1 + r + r²/2 + r³ Q(r): polynomials through Chebyshev points.

The errors of the fits are found on fine grids, and the roundings of an evaluation of X are bounded term by term; both are
printed on the standard error, in units of 2⁻⁵³.
"""
import sys

from mpmath import (atanh, cos, exp, frexp, inf, log, loggamma, lu_solve, matrix, mp, mpf, nint, pi, polyval, psi,
                    sqrt, tanh)

mp.prec = 400
UNIT = mpf(2) ** -53
HALF = mpf(1) / 2
# n ≤ 2⁹ in the fast path; X is fitted to infinity all the same.
SCALE = mpf(5) / 2


def kappa_squared(n):
    return pi * exp(2 * (loggamma(1 + n / 2) - loggamma((n + 1) / 2)))


AT_HALF = kappa_squared(HALF)


def rest(n):
    """X(n)."""
    if n == HALF:
        return pi / 4 - AT_HALF * (psi(0, 1 + n / 2) - psi(0, (n + 1) / 2)) / 2
    return pi / 4 - (kappa_squared(n) - AT_HALF) / (2 * n - 1)


def double(x):
    return mpf(float(x))


def evaluate(coefficients, x):
    return polyval(coefficients[::-1], x)


def chebyshev(count, a, b):
    return [(a + b) / 2 + (b - a) / 2 * cos(pi * (2 * j + 1) / (2 * count)) for j in range(count)]


def polynomial(f, degree, a, b):
    points = chebyshev(degree + 1, a, b)
    system = matrix([[x**j for j in range(degree + 1)] for x in points])
    return [double(c) for c in lu_solve(system, matrix([f(x) for x in points]))]


def rational(f, upper, lower):
    points = [SCALE * (1 + z) / (1 - z) for z in chebyshev(upper + lower + 1, mpf(-1), mpf(1))]
    rows, right = [], []
    for n in points:
        weight, value = (1 + n) ** -lower, f(n)
        rows.append([weight * n**j for j in range(upper + 1)] + [-weight * value * n**j for j in range(1, lower + 1)])
        right.append(weight * value)
    c = [double(x) for x in lu_solve(matrix(rows), matrix(right))]
    return c[: upper + 1], [mpf(1)] + c[upper + 1 :]


def roundings(coefficients, n, per_step):
    """A bound of the relative error of the evaluation in even and odd powers, terms positive, in units of 2⁻⁵³."""
    terms = [c * n**j for j, c in enumerate(coefficients)]
    # cⱼ is added (1), passes j//2 further steps with as many roundings of n², and is joined (times n if j is odd).
    weights = [1 + (per_step + 1) * (j // 2) + (per_step if j % 2 else 1) for j in range(len(terms))]
    return sum(w * t for w, t in zip(weights, terms)) / sum(terms)


def split(x, bits):
    """The leading bits of x, and the rest as a double."""
    mantissa, exponent = frexp(x)
    high = nint(mantissa * mpf(2) ** bits) * mpf(2) ** (exponent - bits)
    return high, double(x - high)


upper, lower = rational(rest, 7, 8)
assert all(c > 0 for c in upper + lower)
fit = fused = separate = mpf(0)
for j in range(1, 2000):
    n = mpf(j) / (2000 - j)
    weight = 1 / kappa_squared(n) / UNIT
    x = evaluate(upper, n) / evaluate(lower, n)
    fit = max(fit, abs(x - rest(n)) * weight)
    for per_step in (1, 2):
        error = (roundings(upper, n, per_step) + roundings(lower, n, per_step) + 1) * x / kappa_squared(n)
        fused, separate = (max(fused, error), separate) if per_step == 1 else (fused, max(separate, error))

# m = 2^x with |x| ≤ 1/2 + 0.0861 (the bits of a double are a piecewise linear logarithm), and w = tanh²(ln m/2).
widest = tanh(log(2) / 2 * (HALF + mpf("0.0861"))) ** 2
artanh = polynomial(lambda w: (atanh(sqrt(w)) / sqrt(w) - 1 - w / 3 - w * w / 5) / w**3, 7, mpf(0), widest)
grid = [widest * (j + mpf(1) / 3) / 500 for j in range(500)]
artanh_fit = max(
    abs(w**3 * evaluate(artanh, w) / (atanh(sqrt(w)) / sqrt(w)) - 1 + (1 + w / 3 + w * w / 5) / (atanh(sqrt(w)) / sqrt(w)))
    for w in grid
)
reach = log(2) / 2 * (1 + mpf(2) ** -30)
power = polynomial(lambda r: (exp(r) - 1 - r - r * r / 2) / r**3, 9, -reach, reach)
grid = [reach * (mpf(2 * j) / 500 - 1) for j in range(1, 500) if j != 250]
power_fit = max(abs((1 + r + r * r / 2 + r**3 * evaluate(power, r)) / exp(r) - 1) for r in grid)

for name, value in [
    ("X, fit", fit),
    ("X, roundings with FMA", fused),
    ("X, roundings without", separate),
    ("artanh, fit", artanh_fit / UNIT),
    ("exp, fit", power_fit / UNIT),
]:
    print(f"{name:24} {float(value):.5f} u", file=sys.stderr)
assert fit < mpf("0.03") and artanh_fit < UNIT / 2**16 and power_fit < UNIT / 100


def numbers(values):
    return "".join(f"    {float(v)!r},\n" for v in values)


def pair(name, doc, high, low):
    return f"/// {doc}\npub(super) const {name}: Pair = Pair {{ hi: {float(high)!r}, lo: {float(low)!r} }};\n"


def table(name, doc, values):
    return f"/// {doc}\npub(super) static {name}: [f64; {len(values)}] = [\n{numbers(values)}];\n"


print("//! Constants and fits of the kernel, generated by `scripts/grid_table.py`; not edited by hand.")
print("#![allow(clippy::excessive_precision, clippy::approx_constant, reason = \"printed by a program\")]\n")
print("use crate::double::pair::Pair;\n")
print(pair("OFFSET", "κ²(1/2) − π/4; the lowest bit of the first part is 2⁻⁴³.", *split(AT_HALF - pi / 4, 43)))
print(pair("HALF_PI", "π/2.", *split(pi / 2, 53)))
print(pair("THIRD", "1/3.", *split(mpf(1) / 3, 53)))
print(pair("HALF_LN_2", "(ln 2)/2, the first part with 38 bits.", *split(log(2) / 2, 38)))
print(pair("LN_2", "ln 2, the first part with 41 bits.", *split(log(2), 41)))
print(table("REST_UPPER", "X = upper/lower.", upper))
print(table("REST_LOWER", "X = upper/lower.", lower))
print(table("ARTANH", "R of artanh(s) = s + s³/3 + s⁵/5 + s⁷R(s²).", artanh))
print(table("EXPONENTIAL", "Q of eʳ = 1 + r + r²/2 + r³Q(r).", power), end="")
