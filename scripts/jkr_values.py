"""Writes c/jkr/certified.h: states of JKR contacts at exact doubles, with the digits that `mdr solve` certifies.

    python3 scripts/jkr_values.py target/debug/mdr > c/jkr/certified.h

Needs the program and Python's standard library alone. Values lie at folds, at zeros of d, F and dF/dd, beside them, and far away.
Each certified number is written as the sum of two doubles, so that an error is measured to a millionth of its last place.
"""

import json
import math
import subprocess
import sys
from decimal import Decimal, getcontext
from fractions import Fraction

getcontext().prec = 80
DIGITS = 45
PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803")

# R, E*, w in SI units: unity, a tip of an atomic force microscope, a bead of rubber, a bead of glass with w nearly 0, far scales.
CONTACTS = [
    (1.0, 1.0, 1.0),
    (20e-9, 70e9, 0.1),
    (1e-5, 1.3e6, 0.05),
    (0.0123, 4.1e10, 1e-12),
    (1e100, 3e-70, 7e40),
    (1.7e-120, 2e90, 3e-60),
]
BESIDE = [1e-13, 1e-8, 1e-3]


def steps(x, n):
    """The double n steps above x."""
    for _ in range(abs(n)):
        x = math.nextafter(x, math.inf if n > 0 else -math.inf)
    return x


def around(x):
    """Doubles at and beside a special value."""
    return [steps(x, n) for n in (-2, -1, 0, 1, 2)] + [x * (1 + s * t) for t in BESIDE for s in (1, -1)]


def solved(program, contact, control, want, values):
    """The answer of the program to one scene."""
    radius, modulus, work = (str(Decimal(x)) for x in contact)
    quoted = ", ".join(f'"{Decimal(x)}"' for x in values)
    key = {"curve": "curve.at", "energy": "equilibria.at", "folds": None}[want]
    scene = f"""
[material]
e_star = "{modulus}"
work_of_adhesion = "{work}"
[profile]
kind = "paraboloid"
radius = "{radius}"
[control]
kind = "{control}"
[output]
want = ["{want}"]
digits = {DIGITS}
""" + (f"{key} = [{quoted}]\n" if key else "")
    done = subprocess.run([program, "solve", "-", "--format", "json"], input=scene, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        raise SystemExit(f"{scene}\n{done.stderr}")
    answer = json.loads(done.stdout)
    if answer["promise"][want] != "certified":
        raise SystemExit(f"{scene}\nis not certified: {answer['promise']}")
    return answer[want]


def words(text):
    """A number as two doubles that sum to it, in C."""
    exact = Fraction(Decimal(text))
    try:
        high = float(exact)
    except OverflowError:
        return "{ %sHUGE_VAL, 0 }" % ("-" if exact < 0 else "")
    low = float(exact - Fraction(high))
    return "{ %r, %r }" % (high, low)


def out_of_range(*texts):
    """The status of numbers that are beyond or below the normal doubles."""
    sizes = [abs(Fraction(Decimal(text))) for text in texts]
    if any(size > Fraction(sys.float_info.max) for size in sizes):
        return "JKR_OVERFLOW"
    return "JKR_UNDERFLOW" if any(0 < size < Fraction(sys.float_info.min) for size in sizes) else "JKR_OK"


def row(contact, question, branch, value, status, a="0", d="0", f="0", k="0"):
    """One row of the table."""
    numbers = ", ".join(x if x.startswith("{") else words(x) for x in (a, d, f, k))
    print("    { %r, %r, %r, %s, %s, %r, %s, %s }," % (*contact, question, branch, value, status, numbers))


def stiffness(contact, a):
    """2 E* a (v - 3)/(v - 1) in 80 digits, for states whose contact radius is given."""
    radius, modulus, work = map(Decimal, contact)
    a = Decimal(a)
    v = (8 * modulus * a**3 / (PI * work * radius**2)).sqrt()
    return str(2 * modulus * a * (v - 3) / (v - 1))


def nearest_to(value, fold):
    """Whether a value is that of a fold within its rounding, 2^-52 of it."""
    return abs(Fraction(value) / Fraction(Decimal(fold)) - 1) <= Fraction(2) ** -52


def folds(program, contact):
    """The certified folds under fixed grips and under a dead load, written as rows too."""
    found = []
    for control, branch, k in (("indentation", "JKR_INDENTATION", "{ HUGE_VAL, 0 }"), ("force", "JKR_FORCE", "0")):
        (fold,) = solved(program, contact, control, "folds", [])
        numbers = [fold[key] for key in ("contact_radius", "indentation", "force")]
        status = out_of_range(*numbers)
        row(contact, "FOLD", branch, 0.0, "JKR_FOLD" if status == "JKR_OK" else status, *numbers, k)
        found.append(fold)
    return found


def held(program, contact, control, fold, values):
    """Rows of both branches at given indentations or forces."""
    question = "AT_INDENTATION" if control == "indentation" else "AT_FORCE"
    for entry in solved(program, contact, control, "energy", values):
        value = float(entry["value"])
        for stable, branch in ((True, "JKR_STABLE"), (False, "JKR_UNSTABLE")):
            states = [state for state in entry["states"] if state["stable"] == stable]
            if states:
                numbers = [states[0][key] for key in ("contact_radius", "indentation", "force", "stiffness")]
                row(contact, question, branch, value, out_of_range(*numbers), *numbers)
            elif value < 0 and nearest_to(value, fold[control]):
                numbers = [fold[key] for key in ("contact_radius", "indentation", "force")]
                row(contact, question, branch, value, "JKR_FOLD", *numbers, "{ HUGE_VAL, 0 }" if control == "indentation" else "0")
            elif value <= 0:
                row(contact, question, branch, value, "JKR_NO_EQUILIBRIUM")


def main(program):
    release = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    print("/* SPDX-License-Identifier: CC0-1.0")
    print(f" * Certified states of JKR contacts, each number as the sum of two doubles: {release}, scripts/jkr_values.py. */")
    print("#ifndef JKR_CERTIFIED_H\n#define JKR_CERTIFIED_H\n\n#include <math.h>\n")
    print("enum certified_question { AT_CONTACT_RADIUS, AT_INDENTATION, AT_FORCE, FOLD };\n")
    print("struct certified_row {\n    double radius, modulus, work;\n    int question, branch; /* of FOLD the control */")
    print("    double value;\n    int status;\n    double contact_radius[2], indentation[2], force[2], stiffness[2];\n};\n")
    print("static const struct certified_row certified_rows[] = {")
    for contact in CONTACTS:
        grips, load = folds(program, contact)
        depth, sixth = -float(grips["indentation"]) / 3, -float(load["force"]) / 9
        radius = float(grips["contact_radius"])
        far = [0.0, *(s * t for t in (1e-20, 1e-6, 0.5, 1.0, 2.0) for s in (1, -1)), 6.0, 1e3, 1e12, 1e40]
        values = around(float(grips["indentation"])) + around(float(load["indentation"])) + around(48 ** (1 / 3) * depth)
        held(program, contact, "indentation", grips, values + [x * depth for x in far])
        values = around(float(load["force"])) + around(-8 * sixth) + around(float(grips["force"]))
        held(program, contact, "force", load, values + [x * sixth for x in far])
        values = [y for x in (1, 9, 16, 36) for y in around(x ** (1 / 3) * radius)] + [x * radius for x in far if x > 0]
        for state in solved(program, contact, "indentation", "curve", values):
            a, d, f = (state[key] for key in ("contact_radius", "indentation", "force"))
            exact = float(a)
            k = stiffness(contact, exact)
            row(contact, "AT_CONTACT_RADIUS", "JKR_STABLE", exact, out_of_range(a, d, f, k), words(str(Decimal(exact))), d, f, k)
    print("};\n\n#endif")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    main(sys.argv[1])
