# SPDX-License-Identifier: MIT
"""The largest errors of jkr.h, in units in the last place, against MPFR with 500 bits.

    cc -O2 accuracy.c -lm -o accuracy && ./accuracy 200000 1 | python3 accuracy.py      # pip install gmpy2

The reference solves v^2 - 6 v = 6 F/P by its formula and u^4 - 4 u = d/D by bisection and Newton's method, and puts the result back
into d(a) and F(a). Exit status 1 if an error is above 0.51, or a status is wrong.
"""

import math
import sys
from collections import Counter

import gmpy2
from gmpy2 import cbrt, mpfr, sqrt

gmpy2.get_context().precision = 500
gmpy2.get_context().emax, gmpy2.get_context().emin = 10**8, -(10**8)
PI = gmpy2.const_pi()
AT_CONTACT_RADIUS, AT_INDENTATION, AT_FORCE, FOLD, FOLLOW = range(5)
QUESTIONS = ["at_contact_radius", "at_indentation", "at_force", "fold", "follow"]
OK, AT_FOLD, NONE, DETACHED, OVERFLOW, UNDERFLOW = range(6)
BIG, SMALL = mpfr(sys.float_info.max), mpfr(sys.float_info.min)


def root(delta, unstable):
    """u of u^4 - 4 u = delta >= -3, on one branch: bisection, since nothing may be assumed, and Newton to the end."""
    low, high = (mpfr(0), mpfr(1)) if unstable else (mpfr(1), 2 + sqrt(sqrt(abs(delta) + 3)))
    for _ in range(90):
        middle = (low + high) / 2
        if (middle**4 - 4 * middle > delta) == unstable:
            low = middle
        else:
            high = middle
    u = -delta / 4 if unstable and abs(delta) < mpfr(2) ** -80 else (low + high) / 2
    for _ in range(12):
        slope = 4 * (u**3 - 1)
        step = (u**4 - 4 * u - delta) / slope if slope else mpfr(0)
        u -= step
        if abs(step) < abs(u) * mpfr(2) ** -400:
            break
    return u


def state(radius, modulus, work, a):
    """a, d, F, dF/dd of the equilibrium with a contact radius, by (1.5) and (1.16)."""
    indentation = a * a / radius - sqrt(2 * PI * a * work / modulus)
    force = 4 * modulus * a**3 / (3 * radius) - sqrt(8 * PI * a**3 * modulus * work)
    v = sqrt(8 * modulus * a**3 / (PI * work * radius**2))
    return a, indentation, force, 2 * modulus * a * (v - 3) / (v - 1) if v != 1 else mpfr("inf")


def at_indentation(radius, modulus, work, d, unstable):
    """None, and how far beyond the fold, where there is no equilibrium."""
    a_c = cbrt(PI * work * radius**2 / (8 * modulus))
    delta = d * radius / a_c**2
    if delta < -3 or (unstable and delta >= 0):
        return None, delta / 3 + 1
    a, _, force, stiffness = state(radius, modulus, work, a_c * root(delta, unstable) ** 2)
    return (a, d, force, stiffness), delta / 3 + 1


def at_force(radius, modulus, work, force, unstable):
    load = PI * work * radius
    gap = 9 + 6 * force / load
    if gap < 0 or (unstable and force >= 0):
        return None, gap / 9
    v = -6 * force / load / (3 + sqrt(gap)) if unstable else 3 + sqrt(gap)
    a, d, _, stiffness = state(radius, modulus, work, cbrt(PI * work * radius**2 / (8 * modulus) * v * v))
    return (a, d, force, stiffness), gap / 9


def follow(radius, modulus, work1, work2, a, d):
    excess = a * a / radius - d
    if excess < sqrt(2 * PI * a * work1 / modulus):
        return at_indentation(radius, modulus, work1, d, False)
    if excess > sqrt(2 * PI * a * work2 / modulus):
        if a**3 < PI * work2 * radius**2 / (8 * modulus):
            return None, mpfr(-1)
        return at_indentation(radius, modulus, work2, d, False)
    return (a, d, 2 * modulus * (a * d - a**3 / (3 * radius)), 2 * modulus * a), mpfr(1)


def expected(question, branch, numbers):
    radius, modulus, work, work1, a0, x = map(mpfr, numbers)
    if question == AT_CONTACT_RADIUS:
        return state(radius, modulus, work, x), mpfr(1)
    if question == AT_INDENTATION:
        return at_indentation(radius, modulus, work, x, branch == 1)
    if question == AT_FORCE:
        return at_force(radius, modulus, work, x, branch == 1)
    if question == FOLLOW:
        return follow(radius, modulus, work1, work, a0, x)
    a, d, force, k = state(radius, modulus, work, cbrt(PI * work * radius**2 / (8 * modulus) * (9 if branch else 1)))
    return (a, d, force, mpfr(0) if branch else mpfr("inf")), mpfr(1)


def right_status(question, status, exact, beyond, found):
    """Whether a status says what is the case; within two units of a fold it may be that of the fold, which may be out of range."""
    if status == AT_FOLD:
        return question == FOLD or abs(beyond) <= mpfr(2) ** -52
    if exact is None and abs(beyond) <= mpfr(2) ** -52 and status in (OVERFLOW, UNDERFLOW):
        a, d, force, _ = map(abs, found)
        return math.inf in (a, d, force) if status == OVERFLOW else min(a, d, force) < SMALL
    if exact is None:
        return status == (DETACHED if question == FOLLOW else NONE)
    sizes = [abs(x) for x in exact if gmpy2.is_finite(x)]
    if status == OVERFLOW:
        return any(x > BIG for x in sizes)
    if status == UNDERFLOW:
        return any(0 < x < SMALL for x in sizes)
    return status == OK


def main():
    worst, counts, wrong = {}, Counter(), 0
    for line in sys.stdin:
        question, branch, status, *rest = line.split()
        question, branch, status = int(question), int(branch), int(status)
        numbers = [float.fromhex(x) for x in rest]
        exact, beyond = expected(question, branch, numbers[:6])
        counts[QUESTIONS[question], status] += 1
        if not right_status(question, status, exact, beyond, numbers[6:]):
            wrong += 1
            print("status", status, "is wrong:", line.strip(), float(beyond))
        if exact is None or (status == AT_FOLD and question != FOLD):
            continue
        for member, found, right in zip(("a", "d", "F", "dF/dd"), numbers[6:], exact):
            if not gmpy2.is_finite(right) or right == 0 or abs(right) > BIG or abs(right) < SMALL:
                continue
            error = float(abs(mpfr(found) - right) / mpfr(math.ulp(float(right)))) if math.isfinite(found) else math.inf
            key = QUESTIONS[question], member
            if error > worst.get(key, (-1.0, ""))[0]:
                worst[key] = error, line.strip()
    print(sum(counts.values()), "answers;", wrong, "with a wrong status;", dict(sorted(counts.items())))
    for key, (error, line) in sorted(worst.items()):
        print("%-18s %-6s %.7f" % (*key, error), line if error > 0.51 else "")
    return wrong > 0 or any(error > 0.51 for error, _ in worst.values())


if __name__ == "__main__":
    raise SystemExit(main())
