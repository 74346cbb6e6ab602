#!/usr/bin/env python3
"""Fits the certified data sets of a paraboloid by scipy.optimize.curve_fit and the textbook formulas of JKR.

    mdr reference --data-sets curves
    python3 answer_scipy.py curves > answers.jsonl
    mdr judge answers.jsonl

The force is a function of the contact radius; where the depth or the position is given, the radius is found by bisection on the
branch that is stable there. Sets with a tail after pull-off are left out: these formulas know no detached row.
"""

import csv
import json
import sys
import tomllib
from pathlib import Path

import numpy as np
from scipy.optimize import brentq, curve_fit

SETS = ("sphere1", "sphere2", "jkrtest2")


def state(a, radius, e_star, work):
    """Indentation depth and force at a contact radius."""
    depth = a**2 / radius - np.sqrt(2 * np.pi * work * a / e_star)
    force = 4 * e_star * a**3 / (3 * radius) - np.sqrt(8 * np.pi * work * e_star * a**3)
    return depth, force


class DataSet:
    """A data set: its rows, what is known, what is free, and a start."""

    def __init__(self, folder, name):
        text = (folder / f"{name}.toml").read_text(encoding="utf-8")
        fit = tomllib.loads(text)
        with open(folder / fit["data"]["file"], encoding="utf-8") as file:
            rows = [[float(number) for number in row] for row in list(csv.reader(file))[2:]]
        self.name, self.x, self.y = name, *np.array(rows).T
        self.radius = float(fit["profile"]["radius"])
        self.stiffness = float(fit.get("control", {}).get("stiffness", "inf"))
        self.observation, self.free = fit["data"]["observation"], fit["fit"]["free"]
        words = text.replace("\n#", "").split("Start 1:")[1].split("Start 2:")[0].strip(" .")
        starts = dict(term.split(" = ") for term in words.split(", "))
        self.start = [float(starts[name]) for name in self.free]

    def force(self, x, e_star, work, contact_point=0.0):
        """The model: the force at what is given."""
        if self.observation == "F(a)":
            return state(x, self.radius, e_star, work)[1]

        def given(a):
            depth, force = state(a, self.radius, e_star, work)
            return depth + force / self.stiffness + contact_point

        radii = np.geomspace(1e-3, 1, 2000) * self.radius
        fold = radii[np.argmin([given(a) for a in radii])]
        def radius(at):
            # Past the fold there is no state; a script without folds takes the last one.
            return fold if given(fold) >= at else brentq(lambda a: given(a) - at, fold, 2 * self.radius, xtol=1e-18, rtol=1e-14)

        return state(np.array([radius(at) for at in x]), self.radius, e_star, work)[1]


def answers(data, estimates, errors):
    """The records of a fit."""
    yield "rss", float(np.sum((data.force(data.x, *estimates) - data.y) ** 2))
    for name, estimate, error in zip(data.free, estimates, errors):
        yield name, float(estimate)
        yield f"{name}_stderr", float(error)


def main(fit):
    """Prints the answers of a way to fit: a function of a data set that returns estimates and standard errors."""
    for name in SETS:
        data = DataSet(Path(sys.argv[1]), name)
        for quantity, value in answers(data, *fit(data)):
            print(json.dumps({"id": f"fit/{name}/{quantity}", "value": value}))


def by_scipy(data):
    """By curve_fit with its own tolerances."""
    estimates, covariance = curve_fit(data.force, data.x, data.y, p0=data.start)
    return estimates, np.sqrt(np.diag(covariance))


if __name__ == "__main__":
    main(by_scipy)
