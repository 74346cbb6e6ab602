#!/usr/bin/env python3
"""Answers the questions about kappa_n = sqrt(pi) Gamma(1+n/2)/Gamma((n+1)/2) with Python packages.

    pip install mpmath python-flint scipy
    mdr reference --filter 'flag!=worst' --export records.jsonl
    python3 answer_kappa.py scipy-gamma records.jsonl > answers.jsonl
    mdr judge answers.jsonl

Ways: scipy-gamma, scipy-gammaln, scipy-poch (doubles), mpmath (20 digits), arb (python-flint, 50 digits with a claimed error).
"""

import json
import math
import sys

ROOT = math.sqrt(math.pi)


def scipy_gamma(text):
    from scipy.special import gamma

    n = float(text)
    return {"value": repr(float(ROOT * gamma(1 + n / 2) / gamma((n + 1) / 2)))}


def scipy_gammaln(text):
    from scipy.special import gammaln

    n = float(text)
    return {"value": repr(float(ROOT * math.exp(gammaln(1 + n / 2) - gammaln((n + 1) / 2))))}


def scipy_poch(text):
    from scipy.special import poch

    n = float(text)
    return {"value": repr(float(ROOT * poch((n + 1) / 2, 0.5)))}


def mpmath(text):
    import mpmath as mp

    mp.mp.dps = 20
    n = mp.mpf(text)
    return {"value": mp.nstr(mp.sqrt(mp.pi) * mp.gamma(1 + n / 2) / mp.gamma((n + 1) / 2), 20)}


def arb(text):
    import flint

    flint.ctx.dps = 60
    n = flint.arb(text)
    ball = flint.arb.pi().sqrt() * (1 + n / 2).gamma() / ((n + 1) / 2).gamma()
    value = ball.mid().str(50, radius=False)
    # The distance of the printed decimal to the far end of the ball.
    error = (ball - flint.arb(value)).abs_upper()
    return {"value": value, "error": error.str(5, radius=False)}


WAYS = {
    "scipy-gamma": scipy_gamma,
    "scipy-gammaln": scipy_gammaln,
    "scipy-poch": scipy_poch,
    "mpmath": mpmath,
    "arb": arb,
}

way = WAYS[sys.argv[1]]
for line in open(sys.argv[2], encoding="utf-8"):
    question = json.loads(line)
    if question["formula"] == "kappa" and float(question["inputs"]["n"]) > 0:
        print(json.dumps({"id": question["id"], **way(question["inputs"]["n"])}))
