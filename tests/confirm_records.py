#!/usr/bin/env python3
"""Recomputes the certified records in Arb, from nothing but their own fields.

    pip install python-flint
    python3 tests/confirm_records.py [RECORDS.jsonl ...]

Closed forms are evaluated in ball arithmetic; zeros are confirmed by a certain change of sign between mid - rad and
mid + rad, and refined; integrals are rigorous quadratures. A record is confirmed when the ball of the recomputed number
lies within rad of mid, and its conditions are the differences that small changes of the inputs make.

With the Rust code it shares no line and no library (Arb in the place of MPFR and of the enclosures there), but formulas of
the theory, written once more: the definitions d = g - dl, F = 2 E* (a d - G) and dl = sqrt(2 pi a w/E*); the conditions of
tangency at a fold; the closed forms of kappa_n, of g of every profile, of a_c, d_c and F_c, of the thresholds at n = 1/2 and
of the energies of power laws; P and H of the wave of Johnson, whose folds are zeros of slopes by power series; the edges of two works
of adhesion, and the energies lost in their loops. A wrong formula of these would be confirmed; quadrature of the heights, the second method of each record, would not confirm a wrong g. Other than in Rust are g' (by power series, but of waves), G (by rigorous
quadrature, but of power laws and waves), conditions (by differences) and the certain changes of sign.

Exit status: 0 all confirmed, 1 a record differs, 77 python-flint is not there.
"""

import glob
import json
import os
import sys
import time

try:
    from flint import acb, arb, arb_series, ctx, fmpq
except ImportError:
    print("skipped: python-flint is not installed (pip install python-flint)")
    sys.exit(77)

# The second where the first does not decide: extreme scales in one sum, short waves in a power series.
BITS = (512, 4096)

# The relative change of an input for a condition: zeros stay between mid - rad and mid + rad.
STEP = fmpq(1, 10**60)


def exact(text):
    """The rational number that a decimal is."""
    mantissa, _, exponent = text.lower().partition("e")
    whole, _, fraction = mantissa.partition(".")
    scale = int(exponent or 0) - len(fraction)
    digits = int(whole + fraction)
    return fmpq(digits * 10**scale) if scale >= 0 else fmpq(digits, 10**-scale)


def ball(text):
    """The same as a ball."""
    mantissa, _, exponent = text.lower().partition("e")
    if abs(int(exponent or 0)) < 5000:
        return arb(exact(text))
    # 10^exponent is too long to be written out.
    return arb(exact(mantissa)) * arb(10) ** int(exponent)


class Law:
    """f = C r^n."""

    def __init__(self, given):
        self.n, self.c, self.e, self.w = (given[key] for key in ("n", "C", "E*", "w"))
        self.kappa = kappa(self.n)

    def g(self, x):
        return self.kappa * self.c * x**self.n

    def slope(self, x):
        return self.n * self.g(x) / x

    def integral(self, x):
        return self.g(x) * x / (self.n + 1)

    def critical_radius(self, tangency):
        """g'(a) = tangency * sqrt(pi w/(2 E a))."""
        square = tangency**2 * arb.pi() * self.w / (2 * self.e)
        return (square / (self.n * self.kappa * self.c) ** 2) ** (1 / (2 * self.n - 1))


def kappa(n):
    return arb.pi().sqrt() * (1 + n / 2).gamma() / ((n + 1) / 2).gamma()


def elongation(profile, a):
    return (2 * arb.pi() * a * profile.w / profile.e).sqrt()


def indentation(profile, a):
    return profile.g(a) - elongation(profile, a)


def force(profile, a):
    return 2 * profile.e * (a * indentation(profile, a) - profile.integral(a))


def held(profile, a, control, k=None):
    """What is controlled, at the equilibrium with this radius."""
    if control == "machine":
        return indentation(profile, a) + force(profile, a) / k
    return indentation(profile, a) if control == "indentation" else force(profile, a)


def tangency(profile, a, control, k=None):
    """Zero at a fold."""
    ratio = {"indentation": arb(1), "force": arb(3)}.get(control)
    if control == "machine":
        ratio = (k + 6 * profile.e * a) / (k + 2 * profile.e * a)
    return profile.slope(a) - ratio * (arb.pi() * profile.w / (2 * profile.e * a)).sqrt()


def half(t):
    """artanh"""
    return ((1 + t) / (1 - t)).log() / 2


def struve(order, z):
    """H_0 and H_1 by their power series."""
    if order == 0:
        return 2 * z / arb.pi() * (-z * z / 4).hypgeom([arb(1)], [arb(1.5), arb(1.5)])
    return 2 * z * z / (3 * arb.pi()) * (-z * z / 4).hypgeom([arb(1)], [arb(1.5), arb(2.5)])


class Profile:
    """A profile of the library."""

    def __init__(self, kind, given):
        self.kind, self.given = kind, given
        self.e, self.w = given.get("E*"), given.get("w")

    def edge(self):
        given = self.given
        if self.kind == "cone-spherical-cap":
            return given["radius"] * given["slope"] / (1 + given["slope"] ** 2).sqrt()
        name = {"cone-parabolic-cap": "cap", "parabolic-dimple": "radius"}.get(self.kind, "flat")
        return given.get(name, arb(0))

    def form(self, x, beyond):
        """g for balls, complex balls and power series; `beyond` says on which side of the edge."""
        p, pi, b = self.given, arb.pi(), self.edge()
        kind = self.kind
        if kind == "cone":
            return x * (pi / 2 * p["slope"])
        if kind == "paraboloid":
            return x * x / p["radius"]
        if kind == "sphere":
            return x * half(x / p["radius"])
        if kind == "ellipsoid":
            return x * half(x / p["lateral"]) * (p["height"] / p["lateral"])
        if kind == "hyperboloid":
            return x * (x / p["lateral"]).atan() * p["slope"]
        if kind == "displaced-paraboloid":
            return x * x / p["radius"] - x * (pi * p["offset"] / (2 * p["radius"]))
        if kind == "sum":
            return x * x / p["radius"] + x * (pi / 2 * p["slope"])
        if kind == "elliptical-dimple":
            return -(x * half(x / p["radius"]) * (p["depth"] / p["radius"]))
        if not beyond:
            return {
                "cone-parabolic-cap": lambda: x * x * (p["slope"] / b),
                "cone-spherical-cap": lambda: x * half(x / p["radius"]),
                "parabolic-dimple": lambda: -(x * x * (2 * p["depth"] / (b * b))),
            }.get(kind, lambda: x * 0)()
        root, angle = (x * x - b * b).sqrt(), ((x * x - b * b).sqrt() / b).atan()
        if kind == "truncated-cone":
            return x * angle * p["slope"]
        if kind == "truncated-paraboloid":
            return x * root / p["radius"]
        if kind == "rounded-punch":
            return x * (root - angle * b) / p["radius"]
        if kind == "cone-parabolic-cap":
            return x * (x - root) * (p["slope"] / b) + x * angle * p["slope"]
        if kind == "cone-spherical-cap":
            inner = (p["radius"] ** 2 - b * b).sqrt()
            return x * ((x + p["radius"]) / (root + inner)).log() + x * angle * p["slope"]
        if kind == "parabolic-dimple":
            return -(x * (x - root) * (2 * p["depth"] / (b * b)))
        raise KeyError(kind)

    def g(self, x):
        if self.kind == "wavy-paraboloid":
            p = self.given
            z = 2 * arb.pi() / p["wavelength"] * x
            return x * x / p["radius"] + arb.pi() / 2 * p["amplitude"] * z * struve(0, z)
        return self.form(x, bool(x > self.edge()))

    def slope(self, x):
        if self.kind == "wavy-paraboloid":
            p = self.given
            k = 2 * arb.pi() / p["wavelength"]
            wave = struve(0, k * x) + k * x * (2 / arb.pi() - struve(1, k * x))
            return 2 * x / p["radius"] + arb.pi() / 2 * p["amplitude"] * k * wave
        ctx.cap = 2
        return self.form(arb_series([x, 1]), bool(x > self.edge()))[1]

    def integral(self, x):
        """Rigorous quadrature of g; beyond an edge in u with x^2 = b^2 + u^2, where g is analytic."""
        if self.kind == "wavy-paraboloid":
            p = self.given
            z = 2 * arb.pi() / p["wavelength"] * x
            return x**3 / (3 * p["radius"]) + arb.pi() / 2 * p["amplitude"] * x * struve(1, z)
        b = self.edge()
        inner = x if not bool(x > b) or b == 0 else b
        total = quadrature(lambda t: self.form(t, False), arb(0), inner) if b == 0 or inner is x or self.inside() else arb(0)
        if b == 0 or not bool(x > b):
            return total

        def beyond(u):
            t = (b * b + u * u).sqrt()
            return self.form(t, True) * u / t

        return total + quadrature(beyond, arb(0), (x * x - b * b).sqrt())

    def inside(self):
        """Whether g is more than 0 inside of the edge."""
        return self.kind in ("cone-parabolic-cap", "cone-spherical-cap", "parabolic-dimple")


def quadrature(f, lower, upper):
    """The integral over [lower, upper], scaled to [0, 1]."""
    width = upper - lower
    value = acb.integral(lambda t, _: f(lower + width * t), 0, 1, rel_tol=arb(2) ** -230, abs_tol=arb(2) ** -20000)
    return value.real * width


def refine(f, lower, upper, bits=140):
    """The zero between two points where f certainly has different signs, to so many bits of their distance: secants lead to it,
    and certain signs on both of its sides prove it."""
    last, x = arb(lower.mid()), arb(upper.mid())
    before, value = f(last), f(x)
    if not ((before < 0 and value > 0) or (before > 0 and value < 0)):
        raise ValueError("no certain change of sign")
    rising, lower, upper, close = bool(before < 0), last, x, (x - last) / arb(2) ** bits
    for _ in range(1000):
        if value.contains(0) or not bool(abs(x - last) > close / 4):
            break
        # The zero stays between the points: a secant that leaves them is replaced by a bisection.
        lower, upper = (x, upper) if bool(value < 0) == rising else (lower, x)
        secant = arb((x - value * (x - last) / (value - before)).mid())
        last, before = x, value
        x = secant if bool(lower < secant) and bool(secant < upper) else arb(((lower + upper) / 2).mid())
        value = f(x)
    # What f itself is not certain of makes the enclosure wider.
    for close in (close * 2**wider for wider in range(0, 80, 8)):
        below, above = f(arb((x - close).mid())), f(arb((x + close).mid()))
        if (below < 0 and above > 0) if rising else (below > 0 and above < 0):
            return (x - close).union(x + close)
    raise ValueError("no certain change of sign beside a zero")


class Records:
    """All records, for those that belong to one state."""

    def __init__(self, files):
        lines = (line for file in files for line in open(file, encoding="utf-8"))
        self.all = [json.loads(line) for line in lines]
        self.by_id = {record["id"]: record for record in self.all}

    def root(self, record, f):
        """The zero of f within the certified radius of the same state."""
        own = record["quantity"] == "contact_radius"
        state = record if own else self.by_id[record["id"].rsplit("/", 1)[0] + "/contact_radius"]
        mid, rad = ball(state["mid"]), ball(state["rad"])
        return refine(f, mid - rad, mid + rad)

    def answer(self, record, moved=None):
        """The number, recomputed, with one of the inputs a little larger."""
        given = {name: ball(text) for name, text in record["inputs"].items()}
        if moved is not None:
            given[moved] *= 1 + arb(STEP)
        formula, control, quantity = record["formula"], record["control"], record["quantity"]
        if formula.split("-")[0] in ("graded", "line", "wave"):
            return medium(self, record, given)
        if formula.startswith("loop"):
            return loop(record, given)
        parts = {"indentation": indentation, "force": force}
        if formula == "kappa":
            return kappa(given["n"])
        if formula == "transform":
            profile = Profile(record["profile"], given)
            return getattr(profile, quantity)(given["x"])
        if formula == "threshold":
            factor = 3 if control == "force" else 1
            limit = factor * (2 * arb.pi() * given["w"] / given["E*"]).sqrt() / kappa(arb(0.5))
            return limit if quantity == "threshold_c" else given["C"] / limit
        if formula == "flat-punch-pull-off":
            d = -(2 * arb.pi() * given["radius"] * given["w"] / given["E*"]).sqrt()
            return d if quantity == "indentation" else 2 * given["E*"] * given["radius"] * d
        if formula in ("folds", "equilibria", "landing", "state"):
            profile = Profile(record["profile"], given)
            a = given["a"] if formula == "state" else self.contact(record, profile, given)
            return a if quantity == "contact_radius" else parts[quantity](profile, a)
        law = Law(given)
        if formula == "critical":
            return critical(law, control, quantity)
        if formula == "machine-folds":
            a = self.root(record, lambda a: tangency(law, a, "machine", given["k"]))
            return a if quantity == "contact_radius" else parts[quantity](law, a)
        if formula.startswith("equilibrium"):
            return self.equilibrium(record, law, given)
        return energy(law, formula)

    def contact(self, record, profile, given):
        """The contact radius at a fold, at a value of what is held, or where the contact lands that jumps at a fold."""
        control, k = record["control"], given.get("k")
        fold = record if record["formula"] == "folds" else self.by_id.get(record["id"].replace("landing/", "fold/", 1))
        if fold and fold["formula"] == "folds":
            start = self.root(fold, lambda a: tangency(profile, a, control, k))
            if fold is record:
                return start
            target = held(profile, start, control, k)
        else:
            target = given[{"indentation": "d", "force": "F", "machine": "D"}[control]]
        return self.root(record, lambda a: held(profile, a, control, k) - target)

    def equilibrium(self, record, law, given):
        control = record["control"]
        fold = critical(law, control, control)
        if record["inputs"].get("tau") == "0":
            return critical(law, control, record["quantity"])
        target = fold * (1 - given["tau"]) if "tau" in given else given["d" if control == "indentation" else "F"]
        a = self.root(record, lambda a: held(law, a, control) - target)
        side = critical(law, control, "contact_radius")
        if not (a > side if "outer" in record["flags"] else a < side):
            raise ValueError("on the other side of the fold")
        return a if record["quantity"] == "contact_radius" else {"force": force, "indentation": indentation}[record["quantity"]](law, a)


def critical(law, control, quantity):
    ratio = arb(3 if control == "force" else 1)
    a = law.critical_radius(ratio)
    if quantity == "contact_radius":
        return a
    # Without the difference of g and the elongation, which cancels far from n = 1.
    root = (arb.pi() * law.w * a / (2 * law.e)).sqrt()
    if quantity == "indentation":
        return (ratio - 2 * law.n) / law.n * root
    return 2 * (ratio - 2 * law.n - 2) / (law.n + 1) * law.e * a * root


def medium(records, record, given):
    """A number of a graded half-space, of line contact or of the wave of Johnson (1995)."""
    formula, control, quantity = record["formula"], record["control"], record["quantity"]
    pi, w = arb.pi(), given.get("w")
    if formula.startswith("graded"):
        k, c = given["chi"], given["c"]
        n = given.get("n", (1 - k) / 2)
        factor = (1 + n / 2).gamma() * ((1 + k) / 2).gamma() / ((n + 1 + k) / 2).gamma()
        ratio = 3 + k if control == "force" else 1 - k
        if formula == "graded-threshold":
            # n factor C = ratio sqrt(pi w/2c)
            return ratio * (pi * w / (2 * c)).sqrt() / (n * factor)
        a = (ratio * (pi * w / (2 * c)).sqrt() / (n * factor * given["C"])) ** (2 / (2 * n - 1 + k))
        d = factor * given["C"] * a**n - (2 * pi * w * a ** (1 - k) / c).sqrt()
        force = 2 * c * (d * a ** (1 + k) / (1 + k) - factor * given["C"] * a ** (n + 1 + k) / (n + 1 + k))
        return {"contact_radius": a, "indentation": d, "force": force}[quantity]
    if formula.startswith("line"):
        n, e = given.get("n", arb(0.5)), given["E*"]
        # N(1)/C, the integral of n sin^n over a quarter turn.
        factor = n * pi.sqrt() / 2 * ((n + 1) / 2).gamma() / (n / 2 + 1).gamma()
        if formula == "line-threshold":
            return (2 * pi * w / e).sqrt() / factor
        b = ((2 * pi * w / e).sqrt() / (2 * n * factor * given["C"])) ** (2 / (2 * n - 1))
        return b if quantity == "contact_radius" else e * (factor * given["C"] * b**n - (2 * pi * w * b / e).sqrt())
    e, length = given["E*"], given["lambda"]
    if formula == "wave-threshold-compliance":
        return pi * e / (length * (3 - arb(4).log()))
    height = given["h0"]
    if formula.startswith("wave-threshold"):
        # alpha^4 = max 256 s^3 (1-s)^5, max s^3 (1-s), and alpha^2 = 1/(2 pi).
        square = {
            "wave-threshold-load": (256 * arb(fmpq(3, 8)) ** 3 * arb(fmpq(5, 8)) ** 5).sqrt(),
            "wave-threshold-touch": (arb(fmpq(3, 4)) ** 3 / 4).sqrt(),
            "wave-threshold-energy": 1 / (2 * pi),
        }[formula]
        return square * pi**2 * height**2 * e / (2 * length)
    alpha = (2 * length * w / e).sqrt() / (pi * height)
    closing = pi * e * height / length
    compliance = closing / (given["k"] * height) if "k" in given else arb(0)

    def state(angle):
        """P and H at a number or at a series."""
        sine, cosine = angle.sin(), angle.cos()
        pressure = sine**2 - alpha * (sine / cosine).sqrt()
        return pressure, 1 - sine**2 + pressure * 2 * sine.log()

    def slope(a):
        """Of what is held, by a series of two terms."""
        pressure, gap = state(arb_series([pi * a / length, 1], 2))
        return pressure[1] if control == "force" else compliance * pressure[1] - gap[1]

    a = records.root(record, slope)
    pressure, gap = state(pi * a / length)
    return {"contact_radius": a, "indentation": height * (1 - gap), "force": closing * pressure}[quantity]


def loop(record, given):
    """A number of a loop between two works of adhesion: pressed together to `turn`, and drawn back."""
    formula, control, quantity = record["formula"], record["control"], record["quantity"]
    held_back = formula == "loop-state"
    inward, outward = (Law({**given, "w": given[work]}) for work in ("w1", "w2"))
    n, fold = outward.n, outward.critical_radius(arb(3 if control == "force" else 1))

    def zero(law, target):
        """The radius at which what is held has this value, outside of the fold."""
        upper = 2 * fold
        while not held(law, upper, control) > target:
            upper *= 2
        lower = upper / 4096 if law.w == 0 else law.critical_radius(arb(3 if control == "force" else 1))
        return refine(lambda a: held(law, a, control) - target, lower, upper, 300)

    if formula == "loop-preload":
        return held(inward, fold, control)
    reversal = zero(inward, given["turn"])
    if formula == "loop-work":
        return loop_work(inward, outward, reversal)
    a = fold if reversal > fold else reversal
    if held_back:
        # F = 2 E* a (d - g/(n + 1)): what is not held, of any radius.
        mean, stiffness = (lambda a: outward.g(a) / (n + 1)), (lambda a: 2 * outward.e * a)
        depth = given["d"] if "d" in given else given["F"] / stiffness(reversal) + mean(reversal)
        pinned = outward.g(reversal) - depth < elongation(outward, reversal)
        a = reversal if pinned else zero(outward, given.get("d", given.get("F")))
        if not (pinned or fold < a < reversal) or pinned != ("pinned" in record["flags"]):
            raise ValueError("the edge is elsewhere")
        other = given["F"] / stiffness(a) + mean(a) if control == "force" else stiffness(a) * (given["d"] - mean(a))
        return a if quantity == "contact_radius" else other
    return {"contact_radius": lambda law, a: a, "indentation": indentation, "force": force}[quantity](outward, a)


def loop_work(inward, outward, reversal):
    """What is lost in the jump into contact, by the edge that recedes, and in the pull-off."""
    lost = arb.pi() * reversal**2 * (outward.w - inward.w)
    if inward.w > 0:
        lost += energy(inward, "work-lost-at-jump-in")
    fold = outward.critical_radius(arb(1))
    if reversal > fold:
        return lost + energy(outward, "work-lost-at-pull-off")
    return lost + potential(outward, reversal, indentation(outward, reversal))


def potential(law, a, d):
    """E* int (d - g)^2 dx - pi a^2 w, term by term."""
    g, n = law.g(a), law.n
    return law.e * a * (d * d - 2 * d * g / (n + 1) + g * g / (2 * n + 1)) - arb.pi() * a * a * law.w


def energy(law, formula):
    """The potential energy E* int (d - g)^2 dx - pi a^2 w of the state, term by term."""
    if formula == "work-lost-at-pull-off":
        a = law.critical_radius(arb(1))
        d = indentation(law, a)
    else:
        a = law.critical_radius(2 * law.n)
        d = arb(0)
    value = potential(law, a, d)
    return -value if formula == "work-lost-at-jump-in" else value


def absent(record, records):
    """Whether there is certainly no equilibrium."""
    given = {name: ball(text) for name, text in record["inputs"].items()}
    law, control = Law(given), record["control"]
    fold = critical(law, control, control)
    target = given["d" if control == "indentation" else "F"]
    return bool(target < fold) if given["n"] > arb(0.5) else bool(target > fold)


def confirmed(record, records):
    """Whether Arb says the same; None where there is nothing to say."""
    if record["status"] == "no-equilibrium":
        return absent(record, records)
    if record["mid"] is None:
        return None
    mid, rad = ball(record["mid"]), ball(record["rad"])
    value = records.answer(record)
    require_conditions(record, records, value)
    if rad == 0:
        return bool((value - mid).contains(0))
    return bool(abs(value - mid) <= rad * (1 + arb(2) ** -100))


def require_conditions(record, records, value):
    """An error unless the conditions are right, to the three digits that they have."""
    size = ball(record["scale"]) if record["scale"] else abs(value)
    for name, told in record["condition"].items():
        found = abs(records.answer(record, name) - value) / (size * arb(STEP))
        if not abs(found - told) <= max(0.006 * told, 1e-9):
            raise ValueError(f"the condition with respect to {name} is {found.mid().str(4, radius=False)}, not {told}")


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    files = sys.argv[1:] or sorted(glob.glob(os.path.join(here, "../crates/mdr-reference/data/*.jsonl")))
    records = Records(files)
    counts, start = {}, time.time()
    fits = [record for record in records.all if record["formula"] == "fit"]
    for record in (record for record in records.all if record["formula"] != "fit"):
        for ctx.prec in BITS:
            try:
                verdict, error = confirmed(record, records), None
            except (ValueError, KeyError, ZeroDivisionError) as refusal:
                verdict, error = False, refusal
            if verdict is not False:
                break
        if error is not None:
            print(f"{record['id']}: {error!r}")
        if verdict is False:
            print(f"{record['id']}: not confirmed")
        formula = counts.setdefault(record["formula"], [0, 0, 0])
        formula[{True: 0, False: 1, None: 2}[verdict]] += 1
    for formula, (good, bad, passed) in counts.items():
        print(f"{formula}: {good} confirmed, {bad} not, {passed} without a number")
    print(f"fit: {len(fits)} are those of confirm_fits.py, which reads their data")
    wrong = sum(bad for _, bad, _ in counts.values())
    total = sum(good for good, _, _ in counts.values())
    print(f"{total} records confirmed by Arb, {wrong} not, in {time.time() - start:.1f} s")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
