#!/usr/bin/env python3
"""Answers the questions about folds of Johnson's wave under a mean pressure: with the package Adhesion from PyPI, or in doubles with the
program mdr of this workspace.

    pip install Adhesion
    mdr reference --filter 'formula=wave-fold control=force' --export records.jsonl
    python3 answer_wave.py records.jsonl > answers.jsonl       # or: python3 answer_wave.py records.jsonl mdr
    mdr judge answers.jsonl
"""

import json
import math
import subprocess
import sys

SCENE = """[medium]
kind = "periodic"
wavelength = "{lambda}"
[material]
e_star = "{E*}"
work_of_adhesion = "{w}"
[profile]
kind = "wave"
amplitude = "{h0}"
[control]
kind = "force"
[output]
want = ["folds"]
arithmetic = "f64"
"""


def by_adhesion(question):
    """The half-width, the mean pressure or the approach of the mean planes at a fold, in SI units."""
    from Adhesion.ReferenceSolutions.sinewave import JKR

    height, length, modulus, work = (float(question["inputs"][name]) for name in ("h0", "lambda", "E*", "w"))
    alpha = math.sqrt(2 * length * work / (math.pi**2 * height**2 * modulus))
    at_pull_off, _, at_pull_in = JKR._find_min_max_a(alpha)
    a = at_pull_off if "pull-off" in question["flags"] else at_pull_in
    return {
        "contact_radius": a * length,
        "force": JKR.mean_pressure(a, alpha) * math.pi * modulus * height / length,
        "indentation": height * (1 - JKR.mean_gap(a, alpha)),
    }[question["quantity"]]


def by_mdr(question):
    """What `mdr solve` answers."""
    scene = SCENE.format(**question["inputs"])
    run = subprocess.run(["mdr", "solve", "-", "--format", "json"], input=scene, capture_output=True, text=True, check=True)
    kind = "minimum" if "pull-off" in question["flags"] else "maximum"
    return next(fold for fold in json.loads(run.stdout)["folds"] if fold["kind"] == kind)[question["quantity"]]


answer = by_mdr if sys.argv[2:] == ["mdr"] else by_adhesion
for line in open(sys.argv[1], encoding="utf-8"):
    question = json.loads(line)
    if question["formula"] == "wave-fold" and question["control"] == "force":
        try:
            value = repr(float(answer(question)))
        except (RuntimeError, ValueError, ArithmeticError) as error:
            print(f"{question['id']}: {error}", file=sys.stderr)
            value = "nan"
        print(json.dumps({"id": question["id"], "value": value}))
