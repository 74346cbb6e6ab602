#!/usr/bin/env python3
"""Times of a fit beside scipy: a retraction of 1000 rows of a sphere with its tail after pull-off; E*, w, contact point, baseline free.

    make peers-fit

scipy.optimize.curve_fit has the formulas of JKR in numpy, in three ways: as a user writes them, the contact radius of all rows by Newton's
method at once, no contact where the contact is broken at its own fold; with the closed form of the contact radius instead (Parteli et
al. 2014); and with the closed form by the honest recipe, the rows to the minimum of the force on the stable branch, and the tail. All begin at the
same start, twice and half the numbers of the curve, and take turns; the fastest turn of each counts.
"""

import time

import mdr
import numpy as np
from scipy.optimize import curve_fit

RADIUS, E_STAR, WORK, CONTACT_POINT, BASELINE = 1e-5, 2e6, 0.05, 3e-8, 2e-9
ROWS, TURNS = 1000, 15
NAMES = ("e_star", "work_of_adhesion", "contact_point", "baseline")
TRUE = np.array([E_STAR, WORK, CONTACT_POINT, BASELINE])


def jkr_force(x, e_star, work, contact_point, baseline):
    """The force at these positions: JKR on its stable branch, the baseline after pull-off."""
    depth = x - contact_point
    slope = np.sqrt(2 * np.pi * work / e_star)
    # With s = √a: d = s⁴/R − slope·s, least where 4 s³ = R·slope.
    fold = (RADIUS * slope / 4) ** (1 / 3)
    attached = depth > fold**4 / RADIUS - slope * fold
    wanted = depth[attached]
    s = np.maximum(2 * fold, 1.5 * (RADIUS * np.abs(wanted)) ** 0.25)
    for _ in range(40):
        step = (s**4 / RADIUS - slope * s - wanted) / (4 * s**3 / RADIUS - slope)
        s = s - step
        if np.all(np.abs(step) <= 1e-14 * s):
            break
    a = s**2
    force = np.full(x.shape, baseline)
    force[attached] += 4 * e_star * a**3 / (3 * RADIUS) - np.sqrt(8 * np.pi * work * e_star * a**3)
    return force


def closed_force(x, e_star, work, contact_point, baseline, broken_beyond_fold=True):
    """The force by the closed form of the contact radius, the largest root of a⁴ − 2Rda² − (2πw/E*)R²a + R²d² = 0."""
    depth = x - contact_point
    scale = RADIUS * np.sqrt(2 * np.pi * work / e_star)
    fold = (RADIUS * np.sqrt(2 * np.pi * work / e_star) / 4) ** (1 / 3)
    least = fold**4 / RADIUS - scale / RADIUS * fold
    attached = depth > least
    wanted = depth if not broken_beyond_fold else depth[attached]
    wanted = np.maximum(wanted, least)
    c0, c1, c2 = (RADIUS * wanted) ** 2, -(scale**2), -2 * RADIUS * wanted
    p, q = -(c2**2) / 12 - c0, -(c2**3) / 108 + c0 * c2 / 3 - c1**2 / 8
    u = np.cbrt(-q / 2 + np.sqrt(np.maximum(q * q / 4 + p**3 / 27, 0.0)))
    s = -5 * c2 / 6 + u - p / (3 * u)
    w = np.sqrt(c2 + 2 * s)
    # Parteli's λ: a = (w + √(w² − 4(c₂ + s + λ)))/2 with λ = c₁/(2w).
    a = 0.5 * (w + np.sqrt(np.maximum(w**2 - 4 * (c2 + s + c1 / (2 * w)), 0.0)))
    touching = 4 * e_star * a**3 / (3 * RADIUS) - np.sqrt(8 * np.pi * work * e_star * a**3) + baseline
    if not broken_beyond_fold:
        return touching
    force = np.full(x.shape, baseline)
    force[attached] = touching
    return force


def curve():
    """Positions and noisy forces, the pull-off force being a hundred times the noise."""
    x = np.linspace(1.5e-6, -6e-7, ROWS)
    force = jkr_force(x, *TRUE)
    sigma = 1e-2 * 1.5 * np.pi * WORK * RADIUS
    return x, force + np.random.default_rng(1).normal(0.0, sigma, ROWS), sigma


def by_mdr(x, y, sigma, start):
    fit = mdr.fit(
        x,
        y,
        profile=mdr.Paraboloid(radius=RADIUS),
        observation="F(d)",
        free=NAMES,
        start=dict(zip(NAMES, map(float, start))),
        sigma_x=0.0,
        sigma_y=sigma,
    )
    return np.array([fit.parameters[name] for name in NAMES])


def by_scipy(x, y, _sigma, start):
    scale = np.abs(start)
    estimates, _ = curve_fit(lambda x, *numbers: jkr_force(x, *(numbers * scale)), x, y, p0=start / scale)
    return estimates * scale


def by_closed_form(x, y, _sigma, start):
    scale = np.abs(start)
    estimates, _ = curve_fit(lambda x, *numbers: closed_force(x, *(numbers * scale)), x, y, p0=start / scale)
    return estimates * scale


def by_honest_recipe(x, y, _sigma, start):
    """The rows to the minimum have the stable branch, and those far beyond it the baseline; what lies between is left out."""
    scale, least = np.abs(start), int(np.argmin(y))
    # The jump lies between the minimum and the first row that is within a tenth of it of the last ones.
    level = np.median(y[-ROWS // 10 :])
    tail = least + int(np.argmax(y[least:] > level - 0.1 * (level - y[least])))
    keep = np.r_[0 : least + 1, tail:ROWS]
    branch = np.arange(least + 1)

    def force(x, *numbers):
        e_star, work, contact_point, baseline = numbers * scale
        rows = np.full(x.shape, baseline)
        rows[branch] = closed_force(x[branch], e_star, work, contact_point, baseline, broken_beyond_fold=False)
        return rows

    estimates, _ = curve_fit(force, x[keep], y[keep], p0=start / scale)
    return estimates * scale


def main():
    x, y, sigma = curve()
    start = TRUE * np.array([2.0, 0.5, 2.0, 0.5])
    ways = {"mdr": by_mdr, "Newton": by_scipy, "closed form": by_closed_form, "honest recipe": by_honest_recipe}
    # The closed form is that of Newton's method.
    np.testing.assert_allclose(closed_force(x, *TRUE), jkr_force(x, *TRUE), rtol=1e-6, atol=1e-12)
    fastest = dict.fromkeys(ways, float("inf"))
    found = {}
    for _ in range(TURNS):
        for name, fit in ways.items():
            before = time.perf_counter()
            found[name] = fit(x, y, sigma, start)
            fastest[name] = min(fastest[name], time.perf_counter() - before)
    print(f"{'':14}{'time':>10}  estimates over what the curve was made from")
    for name in ways:
        shares = "  ".join(f"{share:.5f}" for share in found[name] / TRUE)
        print(f"{name:14}{fastest[name] * 1e3:7.1f} ms  {shares}")
    for name in [name for name in ways if name != "mdr"]:
        print(f"mdr.fit takes {fastest['mdr'] / fastest[name]:.2f} times as long as scipy, {name}")


if __name__ == "__main__":
    main()
