#!/usr/bin/env python3
"""Answers the questions about kappa_n and critical states of power laws with `mdr critical --f64`.

    mdr reference --filter 'flag!=worst' --export records.jsonl
    python3 answer_mdr.py mdr records.jsonl > answers.jsonl
    mdr judge answers.jsonl
"""

import json
import subprocess
import sys

program, records = sys.argv[1:]


def critical(inputs, control):
    flags = {"--n": "n", "--c": "C", "--e-star": "E*", "--work": "w"}
    given = [text for flag, name in flags.items() for text in (flag, inputs.get(name, "1"))]
    command = [program, "critical", *given, "--control", control, "--f64", "--format", "json"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    return json.loads(run.stdout) if run.returncode == 0 else None


def answer(question):
    state = critical(question["inputs"], question["control"] or "indentation")
    if state is None:
        return {"status": "domain-error"}
    value = state[question["quantity"]]
    if value is None:
        size = state.get(f"log10_{question['quantity']}")
        return {"status": "domain-error" if size is None else "overflow" if size > 0 else "underflow"}
    return {"value": repr(value)}


for line in open(records, encoding="utf-8"):
    question = json.loads(line)
    if question["formula"] in ("kappa", "critical"):
        print(json.dumps({"id": question["id"], **answer(question)}))
