#!/usr/bin/env python3
"""Times of a fit beside scipy: a retraction of 1000 rows of a sphere with its tail after pull-off; E*, w, contact point, baseline free.

    make peers-fit

scipy.optimize.curve_fit has the textbook formulas of JKR as a user writes them, in numpy: the contact radius of all rows by Newton's
method at once, no contact where the contact is broken at its own fold. Both begin at the same start, twice and half the numbers
of the curve, and take turns; the fastest turn of each counts.
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


def main():
    x, y, sigma = curve()
    start = TRUE * np.array([2.0, 0.5, 2.0, 0.5])
    ways = {"mdr": by_mdr, "scipy": by_scipy}
    fastest = dict.fromkeys(ways, float("inf"))
    found = {}
    for _ in range(TURNS):
        for name, fit in ways.items():
            before = time.perf_counter()
            found[name] = fit(x, y, sigma, start)
            fastest[name] = min(fastest[name], time.perf_counter() - before)
    print(f"{'':8}{'time':>10}  estimates over what the curve was made from")
    for name in ways:
        shares = "  ".join(f"{share:.5f}" for share in found[name] / TRUE)
        print(f"{name:8}{fastest[name] * 1e3:7.1f} ms  {shares}")
    print(f"scipy takes {fastest['scipy'] / fastest['mdr']:.1f} times as long")


if __name__ == "__main__":
    main()
