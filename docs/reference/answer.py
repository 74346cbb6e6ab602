#!/usr/bin/env python3
"""Answers the questions about critical states of power laws in double precision, by the textbook formula.

    mdr reference --filter 'flag!=worst' --export records.jsonl
    python3 answer.py records.jsonl > answers.jsonl
    mdr judge answers.jsonl
"""

import json
import math
import sys


def critical(n, c, e, w, tangency):
    """a, d, F where N a^(n-1/2) = tangency sqrt(B), B = pi w/(2E*), N = n kappa C."""
    kappa = math.sqrt(math.pi) * math.exp(math.lgamma(1 + n / 2) - math.lgamma((n + 1) / 2))
    b = math.pi * w / (2 * e)
    a = (tangency**2 * b / (n * kappa * c) ** 2) ** (1 / (2 * n - 1))
    d = kappa * c * a**n - 2 * math.sqrt(b * a)
    f = 2 * e * a * (n / (n + 1) * kappa * c * a**n - 2 * math.sqrt(b * a))
    return {"contact_radius": a, "indentation": d, "force": f}


def answer(question):
    n, c, e, w = (float(question["inputs"][name]) for name in ("n", "C", "E*", "w"))
    if min(n, c, e, w) <= 0 or n == 0.5:
        return {"status": "domain-error"}
    try:
        state = critical(n, c, e, w, {"indentation": 1, "force": 3}[question["control"]])
    except OverflowError:
        return {"status": "overflow"}
    except ZeroDivisionError:
        return {"status": "underflow"}
    return {"value": repr(state[question["quantity"]])}


for line in open(sys.argv[1], encoding="utf-8"):
    question = json.loads(line)
    if question["formula"] == "critical":
        print(json.dumps({"id": question["id"], **answer(question)}))
