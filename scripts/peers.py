#!/usr/bin/env python3
"""Times of Arb (python-flint), scipy and mpmath beside those of this workspace, on the same questions in one run.

    make peers

`mdr report --quick` and the others take turns, so that a busy machine slows both, and the fastest turn of each counts. The
answers of the others are checked. Times are taken inside each process: the start of Python is in none. Ours are those of calls
from Rust, with the question of a critical state made anew for each answer. The others are called from Python, operation by operation;
the column "at 2 bits" is the time of the same calls with next to no arithmetic in them, so what they cost by themselves, and a ratio
says something of arithmetic where it is small beside the time of the other. Arb gives enclosures and is compared with enclosures.
"""

import csv
import math
import statistics
import subprocess
import sys
import tempfile
import time
from fractions import Fraction
from pathlib import Path

import flint
import mpmath
from scipy import integrate

TURNS, RUNS = 3, 5
SHORTEST = 2e-3
GUARD_BITS = 16
PROGRAM = Path(__file__).resolve().parent.parent / "target" / "release" / "mdr"

N, X = Fraction(3, 10), Fraction(7, 10)
SCALES = Fraction(3, 2), Fraction(10**6), Fraction(1, 20)


def bits(digits):
    return math.ceil(digits * math.log2(10)) + GUARD_BITS


def fmpq(value):
    return flint.fmpq(value.numerator, value.denominator)


def mpf(value):
    return mpmath.mpf(value.numerator) / value.denominator


# κ_n = √π Γ(1+n/2)/Γ((n+1)/2), and the critical state (1.15), (1.17) under fixed grips


def kappa_ball(n):
    return flint.arb.pi().sqrt() * (1 + n / 2).gamma() / ((n + 1) / 2).gamma()


def kappa_rational(n):
    gamma = flint.arb.gamma_fmpq
    return flint.arb.pi().sqrt() * gamma(1 + n / 2) / gamma((n + 1) / 2)


def kappa_mpmath(n):
    return mpmath.sqrt(mpmath.pi) * mpmath.gamma(1 + n / 2) / mpmath.gamma((n + 1) / 2)


def arb_power(x, q):
    """x^q for a small denominator, by the fastest of Arb's functions."""
    return (x ** int(q.p)).root(int(q.q)) if q.q > 1 else x ** int(q.p)


def critical(kappa, n, scales, pi, sqrt, power=lambda x, y: x**y):
    c, e, w = scales
    length = pi * w / (2 * e)
    slope = n * kappa * c
    a = power(length / (slope * slope), 1 / (2 * n - 1))
    root = sqrt(length * a)
    return [kappa, a, (1 - 2 * n) / n * root, -2 * (2 * n + 1) / (n + 1) * e * a * root]


def arb_critical():
    scales = [fmpq(value) for value in SCALES]
    return critical(kappa_rational(fmpq(N)), fmpq(N), scales, flint.arb.pi(), lambda x: x.sqrt(), arb_power)


def mpmath_critical():
    return critical(kappa_mpmath(mpf(N)), mpf(N), [mpf(value) for value in SCALES], +mpmath.pi, mpmath.sqrt)


# g(0.7) of f = rⁿ from heights


def arb_transform(n):
    """∫ sinθ (f + r f') dθ, which a rigorous rule can do where the form with the singularity defeats it at the tip."""
    n, x = flint.acb(fmpq(n)), flint.acb(flint.arb(0.7))

    def integrand(angle, analytic):
        sine = angle.sin()
        r = x * sine
        if not r.contains(0):
            height = r.pow(n, analytic=analytic)
        elif analytic:
            return flint.acb("nan")
        else:
            # Around the branch point: as large as the largest.
            most = flint.arb(0, 1) * r.abs_upper() ** n.real
            height = flint.acb(most, most)
        return sine * height * (1 + n)

    return [flint.acb.integral(integrand, 0, flint.acb.pi() / 2).real]


def scipy_transform(n):
    """QUADPACK's QAWS, with the tip and the end of the interval in its weight."""
    n, x = float(n), 0.7
    value, _ = integrate.quad(lambda r: n / math.sqrt(x + r), 0, x, weight="alg", wvar=(n - 1, -0.5), epsabs=0, epsrel=1e-12)
    return [x * value]


def truth(question):
    """Exact results, by mpmath at twice the precision."""
    if question == "digits-kappa":
        return [kappa_mpmath(mpf(N))]
    if question == "digits-critical":
        return mpmath_critical()
    n = Fraction(question.removeprefix("transform-power-")) if question != "digits-transform" else Fraction(1, 4)
    return [kappa_mpmath(mpf(n)) * mpmath.mpf(0.7) ** mpf(n)]


def peers():
    """Question, digits, the method of this workspace, the name of the other and its function."""
    for digits in (16, 50, 200):
        enclosure = "certified, as an enclosure"
        yield "digits-kappa", digits, enclosure, "Arb, Γ of a rational", lambda: [kappa_rational(fmpq(N))]
        yield "digits-kappa", digits, enclosure, "Arb, Γ of a ball", lambda: [kappa_ball(flint.arb(fmpq(N)))]
        yield "digits-kappa", digits, "arbitrary precision", "mpmath, Γ", lambda: [kappa_mpmath(mpf(N))]
        yield "digits-critical", digits, enclosure, "Arb, Γ of a rational", arb_critical
        yield "digits-critical", digits, "arbitrary precision", "mpmath, Γ", mpmath_critical
        automatic = "quadrature, automatic rule"
        yield "digits-transform", digits, automatic, "Arb, integral", lambda: arb_transform(Fraction(1, 4))
    for n in ("0.25", "0.5", "3.7"):
        answer = lambda n=n: scipy_transform(Fraction(n))
        yield f"transform-power-{n}", 12, "quadrature, automatic rule", "scipy, QAWS", answer


def ours():
    """Looks up the time of a question, a method and its digits in one report."""
    with tempfile.TemporaryDirectory() as directory:
        command = [PROGRAM, "report", "--quick", "--format", "csv", "--out", directory]
        text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    rows = [row for row in csv.DictReader(text.splitlines()) if row["digits"]]

    def asked(question, method, digits):
        mine = [row for row in rows if (row["comparison"], row["method"]) == (question, method)]
        exact = [row for row in mine if row["setting"] == f"{digits} digits"]
        right = exact or [row for row in mine if float(row["digits"]) >= min(digits, 15)]
        return min(float(row["seconds"]) for row in right)

    return asked


def timed(answer):
    """Seconds of one call: the median of runs of at least 2 ms."""

    def run(repeats):
        begin = time.perf_counter()
        for _ in range(repeats):
            answer()
        return time.perf_counter() - begin

    repeats = 1
    while run(repeats) < SHORTEST:
        repeats *= 2
    return statistics.median(run(repeats) for _ in range(RUNS)) / repeats


def right_digits(question, found, digits):
    """The worst of several numbers."""
    with mpmath.workprec(2 * bits(digits)):
        exact = truth(question)
        as_mpf = lambda value: mpmath.mpf(value.mid().str(digits + 10, radius=False)) if hasattr(value, "mid") else value
        errors = [abs(as_mpf(value) / mpmath.mpf(expected) - 1) for value, expected in zip(found, exact)]
        return float(-mpmath.log10(max(*errors, mpmath.mpf(10) ** -(digits + 10))))


def told(seconds):
    for scale, unit in ((1e9, "ns"), (1e6, "µs"), (1e3, "ms")):
        if seconds * scale < 999.5:
            return f"{seconds * scale:.3g} {unit}"
    return f"{seconds:.3g} s"


def main():
    names = list(peers())
    times = {index: ([], []) for index in range(len(names))}
    for _ in range(TURNS):
        report = ours()
        for index, (question, digits, method, _, answer) in enumerate(names):
            flint.ctx.prec = mpmath.mp.prec = bits(digits)
            times[index][0].append(report(question, method, digits))
            times[index][1].append(timed(answer))
    print("| question | digits | this workspace | the other | at 2 bits | times faster | right digits of the other |")
    print("|---|---|---|---|---|---|---|")
    for index, (question, digits, method, name, answer) in enumerate(names):
        flint.ctx.prec = mpmath.mp.prec = bits(digits)
        here, there = (min(side) for side in times[index])
        reached = right_digits(question, answer(), digits)
        flint.ctx.prec = mpmath.mp.prec = 2
        # An adaptive integral is another one at two bits, and doubles have no bits to choose.
        calls = "" if "transform" in question else told(timed(answer))
        print(
            f"| {question} | {digits} | {told(here)} {method} | {told(there)} {name} | {calls} | {there / here:.1f} | {reached:.1f} |"
        )


if __name__ == "__main__":
    sys.exit(main())
