#!/usr/bin/env python3
"""Answers the questions about the stable JKR sphere with the package Adhesion from PyPI.

    pip install Adhesion
    mdr reference --filter 'flag!=worst' --export records.jsonl
    python3 answer_adhesion.py records.jsonl > answers.jsonl
    mdr judge answers.jsonl
"""

import json
import sys

from Adhesion.ReferenceSolutions import JKR


def contact_radius(inputs):
    """The radius on the stable branch, at a penetration or at a force."""
    sphere = {
        "radius": 0.5 / float(inputs["C"]),
        "contact_modulus": float(inputs["E*"]),
        "work_of_adhesion": float(inputs["w"]),
    }
    held = {"penetration": float(inputs["d"])} if "d" in inputs else {"force": float(inputs["F"])}
    return JKR.contact_radius(**held, **sphere)


def answer(question):
    try:
        a = contact_radius(question["inputs"])
    except (RuntimeError, ArithmeticError) as error:
        print(f"{question['id']}: {error}", file=sys.stderr)
        return {"value": "nan"}
    return {"value": repr(float(a))}


for line in open(sys.argv[1], encoding="utf-8"):
    question = json.loads(line)
    asked = question["formula"] == "equilibrium" and question["quantity"] == "contact_radius"
    if asked and float(question["inputs"]["n"]) == 2 and "outer" in question["flags"]:
        print(json.dumps({"id": question["id"], **answer(question)}))
