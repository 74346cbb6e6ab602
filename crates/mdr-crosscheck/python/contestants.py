#!/usr/bin/env python3
"""Contestants of other projects for `mdr report`: python-flint (Arb), scipy and mpmath, where they are installed.

    pip install python-flint numpy scipy mpmath
    echo '{"id": 1, "ask": "kappa", "by": "arb", "n": "3/10", "digits": 50, "runs": 5}' | python3 contestants.py

One question a line on standard input, one answer a line on standard output, in the same order; the first line tells the
versions. A question has `id`, `ask` (kappa, gamma, critical, transform, grid, equilibria), `by` and `runs` (0: no time is
taken); `limit`, seconds of which timing takes half at most; and `fresh`, to have every run without the constants that Arb
keeps. An answer has `id` and either `values` (decimal strings), `evaluations` where they are counted, and `median`, `least`,
`most` (seconds of one answer) and `runs`; or `failed`, a reason; or `absent`, a package. Numbers are decimals or fractions
and mean the same here as there: exactly that rational, or the nearest double. Nothing is shared with the Rust code; errors
are judged there.
"""

import json
import math
import sys
import time
from fractions import Fraction
from importlib import metadata

try:
    import flint
except ImportError:
    flint = None
try:
    import mpmath
except ImportError:
    mpmath = None
try:
    import numpy
    import scipy
    from scipy import integrate, optimize, special
except ImportError:
    numpy = scipy = None

GUARD_BITS = 16
SHORTEST, LIMIT = 2e-3, 20.0


class Absent(Exception):
    """A package that is not installed."""


def need(module, name):
    if module is None:
        raise Absent(name)


def bits(digits):
    return math.ceil(digits * math.log2(10)) + GUARD_BITS


# κ_n = √π Γ(1+n/2)/Γ((n+1)/2)


def kappa_arb(n):
    return flint.arb.pi().sqrt() * (1 + n / 2).gamma() / ((n + 1) / 2).gamma()


def kappa_arb_rational(n):
    gamma = flint.arb.gamma_fmpq
    return flint.arb.pi().sqrt() * gamma(1 + n / 2) / gamma((n + 1) / 2)


def kappa_mpmath(n):
    return mpmath.sqrt(mpmath.pi) * mpmath.gamma(1 + n / 2) / mpmath.gamma((n + 1) / 2)


def kappa_scipy(n):
    return math.sqrt(math.pi) * special.gamma(1 + n / 2) / special.gamma((n + 1) / 2)


def fmpq(text):
    value = Fraction(text)
    return flint.fmpq(value.numerator, value.denominator)


def arb_number(text):
    """A rational, or the square root of one over an integer: "sqrt(2)/5"."""
    if text.startswith("sqrt("):
        radicand, divisor = text[5:].split(")/")
        return flint.arb(int(radicand)).sqrt() / int(divisor)
    return flint.arb(fmpq(text))


def mp_number(text):
    if text.startswith("sqrt("):
        radicand, divisor = text[5:].split(")/")
        return mpmath.sqrt(int(radicand)) / int(divisor)
    value = Fraction(text)
    return mpmath.mpf(value.numerator) / value.denominator


def ask_kappa(question):
    by, text, digits = question["by"], question["n"], question["digits"]
    if by == "arb":
        need(flint, "python-flint")
        flint.ctx.prec = bits(digits)
        n = arb_number(text)
        return (lambda: [kappa_arb(n)]), arb_decimals(digits), None
    if by == "arb, rational argument":
        need(flint, "python-flint")
        flint.ctx.prec = bits(digits)
        n = fmpq(text)
        return (lambda: [kappa_arb_rational(n)]), arb_decimals(digits), None
    if by == "mpmath":
        need(mpmath, "mpmath")
        mpmath.mp.prec = bits(digits)
        n = mp_number(text)
        return (lambda: [kappa_mpmath(n)]), mp_decimals(digits), None
    need(scipy, "scipy")
    n = float(Fraction(text))
    return (lambda: [kappa_scipy(n)]), double, None


def ask_gamma(question):
    """One Γ(1 + n/2): the least that a κ_n by Γ costs."""
    need(flint, "python-flint")
    flint.ctx.prec = bits(question["digits"])
    above = 1 + fmpq(question["n"]) / 2
    return (lambda: [flint.arb.gamma_fmpq(above)]), arb_decimals(question["digits"]), None


def double(value):
    return repr(float(value))


def arb_decimals(digits):
    return lambda value: value.mid().str(digits + 10, radius=False)


def mp_decimals(digits):
    return lambda value: mpmath.nstr(value, digits + 10, strip_zeros=False)


# The critical state under fixed grips: κ, a, d, F


def rational_power(x, q):
    """x^q by the fastest of Arb's functions."""
    numerator, denominator = int(q.p), int(q.q)
    if denominator > 64:
        return x ** flint.arb(q)
    x = x**numerator
    return x if denominator == 1 else x.sqrt() if denominator == 2 else x.root(denominator)


def critical(kappa, n, c, e, w, pi, sqrt, power=lambda x, y: x**y):
    length = pi * w / (2 * e)
    slope = n * kappa * c
    a = power(length / (slope * slope), 1 / (2 * n - 1))
    root = sqrt(length * a)
    return [kappa, a, (1 - 2 * n) / n * root, -2 * (2 * n + 1) / (n + 1) * e * a * root]


def ask_critical(question):
    by, digits = question["by"], question["digits"]
    texts = [question[key] for key in ("n", "c", "e", "w")]
    if by.startswith("arb"):
        need(flint, "python-flint")
        flint.ctx.prec = bits(digits)
        n, c, e, w = map(fmpq, texts)
        numbers = [flint.arb(value) for value in (c, e, w)]
        exponent = flint.arb(n)

        def answer():
            root = lambda x: x.sqrt()
            if by == "arb":
                return critical(kappa_arb(exponent), exponent, *numbers, flint.arb.pi(), root)
            return critical(kappa_arb_rational(n), n, c, e, w, flint.arb.pi(), root, rational_power)

        return answer, arb_decimals(digits), None
    if by == "mpmath":
        need(mpmath, "mpmath")
        mpmath.mp.prec = bits(digits)
        n, c, e, w = map(mp_number, texts)
        return (lambda: critical(kappa_mpmath(n), n, c, e, w, +mpmath.pi, mpmath.sqrt)), mp_decimals(digits), None
    need(scipy, "scipy")
    n, c, e, w = (float(Fraction(text)) for text in texts)
    return (lambda: critical(kappa_scipy(n), n, c, e, w, math.pi, math.sqrt)), double, None


# g(x) from heights


class Profile:
    """f and f' over the functions of a module, with kinks and the exponent of the tip."""

    def __init__(self, question, functions, number):
        self.kind, self.f = question["profile"], functions
        self.parameters = [number(text) for text in question["parameters"]]
        self.kinks = [self.parameters[1]] if self.kind in ("truncated-cone", "cone-parabolic-cap") else []
        self.tip = {"power": self.parameters[0], "truncated-cone": None}.get(self.kind, 2)

    def derivative(self, r, outer):
        if self.kind == "power":
            (n,) = self.parameters
            return n * r ** (n - 1)
        if self.kind == "sphere":
            (radius,) = self.parameters
            return r / self.f.sqrt(radius * radius - r * r)
        if self.kind == "wavy-paraboloid":
            radius, amplitude, length = self.parameters
            wave = 2 * self.f.pi / length
            return r / radius + amplitude * wave * self.f.sin(wave * r)
        slope, edge = self.parameters
        if self.kind == "truncated-cone":
            return slope if outer else 0 * r
        return slope if outer else slope * r / edge

    def height(self, r, outer):
        if self.kind == "power":
            return r ** self.parameters[0]
        if self.kind == "sphere":
            (radius,) = self.parameters
            return r * r / (radius + self.f.sqrt(radius * radius - r * r))
        if self.kind == "wavy-paraboloid":
            radius, amplitude, length = self.parameters
            return r * r / (2 * radius) + amplitude * (1 - self.f.cos(2 * self.f.pi / length * r))
        slope, edge = self.parameters
        if self.kind == "truncated-cone":
            return slope * (r - edge) if outer else 0 * r
        return slope * (r - edge / 2) if outer else slope * r * r / (2 * edge)


class Counter:
    """Evaluations of one answer."""

    def __init__(self):
        self.count = 0


def ask_transform(question):
    by = question["by"]
    if by.startswith("scipy"):
        need(scipy, "scipy")
        profile = Profile(question, math, lambda text: float(Fraction(text)))
        return transform_scipy(by, profile, float(Fraction(question["x"])), question["effort"])
    if by == "mpmath.quad":
        need(mpmath, "mpmath")
        mpmath.mp.dps = question["effort"]
        return transform_mpmath(Profile(question, mpmath, mp_number), mp_number(question["x"]), question["effort"])
    need(flint, "python-flint")
    flint.ctx.prec = bits(question["effort"])
    return transform_arb(question, question["effort"])


def transform_scipy(by, profile, x, effort):
    """In θ, split at kinks; or in r, where the weights of QUADPACK's QAWS take both ends."""
    counter, tolerance = Counter(), 10.0**-effort
    kinks = [kink for kink in profile.kinks if kink < x]
    ends = [0.0, *kinks, x]

    def in_angle():
        total, angles = 0.0, [math.asin(end / x) for end in ends]
        for piece in range(len(ends) - 1):
            outer = piece > 0

            def integrand(angle, outer=outer):
                counter.count += 1
                return profile.derivative(x * math.sin(angle), outer)

            total += integrate.quad(integrand, angles[piece], angles[piece + 1], epsabs=0, epsrel=tolerance, limit=200)[0]
        return [x * total]

    def weighted():
        total = 0.0
        for piece in range(len(ends) - 1):
            outer, last = piece > 0, piece == len(ends) - 2
            tip = profile.tip - 1 if piece == 0 and profile.tip is not None else 0.0

            def integrand(r, outer=outer, last=last, tip=tip):
                counter.count += 1
                if r == 0:
                    # QAWS asks for the limit at the tip.
                    r = 1e-300 ** min(1.0, 1 / max(abs(tip), 1.0))
                value = profile.derivative(r, outer) / math.sqrt(x + r)
                if tip:
                    value /= r**tip
                return value if last else value / math.sqrt(x - r)

            total += integrate.quad(
                integrand, ends[piece], ends[piece + 1], weight="alg", wvar=(tip, -0.5 if last else 0.0),
                epsabs=0, epsrel=tolerance, limit=200,
            )[0]
        return [x * total]

    return (in_angle if by == "scipy.quad in θ" else weighted), double, counter


def transform_mpmath(profile, x, digits):
    counter = Counter()
    kinks = [kink for kink in profile.kinks if kink < x]
    ends = [mpmath.mpf(0), *(mpmath.asin(kink / x) for kink in kinks), mpmath.pi / 2]

    def answer():
        total = mpmath.mpf(0)
        for piece in range(len(ends) - 1):

            def integrand(angle, outer=piece > 0):
                counter.count += 1
                return profile.derivative(x * mpmath.sin(angle), outer)

            total += mpmath.quad(integrand, [ends[piece], ends[piece + 1]])
        return [x * total]

    return answer, mp_decimals(digits), counter


class ArbFunctions:
    """The functions of a profile over complex balls; outside their domain nothing is known, and Arb then bisects."""

    def __init__(self):
        self.analytic = False
        self.pi = flint.acb.pi()

    def sqrt(self, z):
        return z.sqrt(analytic=self.analytic)

    def sin(self, z):
        return z.sin()

    def cos(self, z):
        return z.cos()


class ArbProfile(Profile):
    def height(self, r, outer):
        if self.kind != "power":
            return super().height(r, outer)
        (n,) = self.parameters
        if not r.contains(0):
            return r.pow(n, analytic=self.f.analytic)
        # Around the branch point: nothing where it must be analytic, else as large as the largest.
        if self.f.analytic:
            return flint.acb("nan")
        most = flint.arb(0, 1) * r.abs_upper() ** n.real
        return flint.acb(most, most)


def transform_arb(question, digits):
    """The regularised form ∫ sinθ (f + r f') dθ, which a rigorous rule can do where the raw one defeats it at the tip."""
    functions, counter = ArbFunctions(), Counter()

    def number(text):
        return flint.acb(flint.arb(fmpq(text)))

    profile, x = ArbProfile(question, functions, number), number(question["x"])
    kinks = [kink for kink in profile.kinks if kink.real < x.real]
    ends = [flint.acb(0), *((kink / x).asin() for kink in kinks), flint.acb.pi() / 2]

    def answer():
        total = flint.acb(0)
        for piece in range(len(ends) - 1):

            def integrand(angle, analytic, outer=piece > 0):
                counter.count += 1
                functions.analytic = analytic
                sine = angle.sin()
                r = x * sine
                height = profile.height(r, outer)
                if profile.kind == "power":
                    return sine * height * (1 + profile.parameters[0])
                return sine * (height + r * profile.derivative(r, outer))

            total += flint.acb.integral(integrand, ends[piece], ends[piece + 1])
        return [total.real]

    return answer, arb_decimals(digits), counter


# Many points, and the inverse


def ask_grid(question):
    """κ, a, d, F of the points n = 0.8 + 1.2 t, C = 1 + t for t = 0, 1/N, …, in batches; the values of the points picked."""
    need(scipy, "scipy")
    count, batch = question["count"], question["batch"]
    t = numpy.arange(count) / count
    n, c = 0.8 + 1.2 * t, 1.0 + t
    e, w = float(question["e"]), float(question["w"])

    def kappa(n):
        return math.sqrt(math.pi) * special.gamma(1 + n / 2) / special.gamma((n + 1) / 2)

    def answer():
        picked = []
        for begin in range(0, count, batch):
            end = min(begin + batch, count)
            columns = critical(kappa(n[begin:end]), n[begin:end], c[begin:end], e, w, math.pi, numpy.sqrt)
            picked += [[column[i - begin] for column in columns] for i in question["picked"] if begin <= i < end]
        return picked

    return answer, lambda state: [double(value) for value in state], None


def ask_equilibria(question):
    """Both contact radii at a given indentation of a power law, with κ_n and the critical radius known."""
    need(scipy, "scipy")
    n, c, e, w, d = (float(Fraction(question[key])) for key in ("n", "c", "e", "w", "d"))
    kappa, a_c, *_ = critical(kappa_scipy(n), n, c, e, w, math.pi, math.sqrt)
    strength, length = kappa * c, math.pi * w / (2 * e)

    def residual(a):
        return strength * a**n - 2 * math.sqrt(length * a) - d

    def answer():
        roots = (optimize.brentq(residual, a_c * 1e-9, a_c, xtol=1e-300, rtol=1e-15),
                 optimize.brentq(residual, a_c, a_c * 16, xtol=1e-300, rtol=1e-15))
        return list(roots)

    return answer, double, None


ASKED = {
    "kappa": ask_kappa,
    "gamma": ask_gamma,
    "critical": ask_critical,
    "transform": ask_transform,
    "grid": ask_grid,
    "equilibria": ask_equilibria,
}


def clock(answer, first, question):
    """Seconds of one answer: the median of runs of at least 2 ms. The first answer stands for all where it was too slow."""
    begin, longest = time.perf_counter(), question.get("limit", LIMIT) / 2
    fresh, repeats = question.get("fresh", False), 1

    def run():
        if fresh:
            flint.ctx.cleanup()
        start = time.perf_counter()
        for _ in range(repeats):
            answer()
        return time.perf_counter() - start

    seconds = []
    if first < longest:
        seconds.append(run())
        while seconds[0] < SHORTEST and not fresh:
            repeats *= 2
            seconds[0] = run()
    while seconds and len(seconds) < question["runs"] and time.perf_counter() - begin < longest:
        seconds.append(run())
    seconds = sorted(value / repeats for value in seconds) or [first]
    return {"median": seconds[len(seconds) // 2], "least": seconds[0], "most": seconds[-1], "runs": len(seconds)}


def reply(question):
    answer, decimals, counter = ASKED[question["ask"]](question)
    begin = time.perf_counter()
    found = answer()
    first = time.perf_counter() - begin
    said = {"values": [text for value in found for text in as_list(decimals(value))]}
    if counter is not None:
        said["evaluations"] = counter.count
    if question["runs"]:
        said.update(clock(answer, first, question))
    return said


def as_list(text):
    return text if isinstance(text, list) else [text]


def versions():
    found = {"python": sys.version.split()[0]}
    for name in ("python-flint", "numpy", "scipy", "mpmath", "gmpy2"):
        try:
            found[name] = metadata.version(name)
        except metadata.PackageNotFoundError:
            pass
    return found


def main():
    # Digits by the ten thousand are wanted here.
    if hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(0)
    print(json.dumps({"versions": versions()}), flush=True)
    for line in sys.stdin:
        question = json.loads(line)
        try:
            said = reply(question)
        except Absent as absent:
            said = {"absent": str(absent)}
        except Exception as error:  # A contestant that fails is told of, not the end of the others.
            said = {"failed": f"{type(error).__name__}: {error}"}
        print(json.dumps({"id": question["id"], **said}), flush=True)


if __name__ == "__main__":
    main()
