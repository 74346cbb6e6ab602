#!/usr/bin/env python3
"""What scripts/check_certificates.py has to refuse: each certificate of this folder is accepted, and each change of it is not.

    python3 tests/certificates/refuse.py
"""

import copy
import glob
import json
import os
import sys

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(here, "../../scripts"))

import check_certificates  # noqa: E402
from check_certificates import Certificate, Refused  # noqa: E402

found = {}


def remembered(contact, lower, upper, compute=check_certificates.trend):
    """The trend of C on a cell of a contact, computed once: most changes leave most cells as they are."""
    given = contact.given
    keys = ("medium", "profile", "edge", "e_star", "work_of_adhesion", "control", "stiffness")
    key = str([given.get(key) for key in keys] + [lower, upper])
    if key not in found:
        found[key] = compute(contact, lower, upper)
    return found[key]


check_certificates.trend = remembered


def bumped(text, step):
    """A decimal with its last digit moved."""
    mantissa, exponent = (text.split("e") + [""])[:2]
    whole, fraction = (mantissa.split(".") + ["0"])[:2]
    digits = str(int(whole + fraction) + step)
    sign, digits = ("-", digits[1:]) if digits.startswith("-") else ("", digits)
    digits = digits.rjust(len(fraction) + 1, "0")
    return f"{sign}{digits[:-len(fraction)]}.{digits[-len(fraction):]}" + (f"e{exponent}" if exponent else "")


FLIPPED = {"rises": "falls", "falls": "rises", "minimum": "maximum", "maximum": "minimum"}
ONE_FOLD_LESS = {"minimum": "rises", "maximum": "falls"}


MEDIA = [
    None,
    {"kind": "graded", "exponent": "0.25", "coefficient": "E"},
    {"kind": "winkler", "modulus": "E"},
    {"kind": "plane"},
    {"kind": "plane", "reference": "20"},
    {"kind": "periodic", "wavelength": "1"},
    {"kind": "layer"},
]


def on_other_media(given):
    """Certificates of the same answer on each other medium, of the modulus that the medium had, and with other numbers of its own."""
    own = given.get("medium", {})
    modulus = given.get("e_star") or own.get("coefficient") or own.get("modulus")
    for medium in MEDIA:
        words = {key: modulus if value == "E" else value for key, value in (medium or {}).items()}
        if words == own:
            continue
        other = {key: value for key, value in copy.deepcopy(given).items() if key not in ("medium", "e_star")}
        if medium:
            other["medium"] = words
        if "E" not in (medium or {}).values():
            other["e_star"] = modulus
        yield f"on the medium {medium}", other
    for key in [key for key in own if key != "kind"]:
        yield f"another {key}", dict(given, medium=dict(own, **{key: bumped(own[key], 1)}))
        yield f"no {key}", dict(given, medium={name: value for name, value in own.items() if name != key})
    yield "a number that the medium has not", dict(given, medium=dict(own or {"kind": "half-space"}, poisson="0.3"))


def changes(given):
    """Certificates with one fault each, and what it is."""

    def changed(what, act):
        other = copy.deepcopy(given)
        act(other)
        return what, other

    for index, cell in enumerate(given["cells"]):
        yield changed(f"cell {index} missing", lambda c: c["cells"].pop(index))
        yield changed(f"trend of cell {index} flipped", lambda c: c["cells"][index].update(trend=FLIPPED[cell["trend"]]))
        if cell["trend"] in ONE_FOLD_LESS:
            yield changed(f"fold of cell {index} denied", lambda c: c["cells"][index].update(trend=ONE_FOLD_LESS[cell["trend"]]))
    yield changed("the last cell and its range missing", lambda c: c["cells"].append(dict(c["cells"].pop(), to=c["range"][1] + "1")))
    for index, fold in enumerate(given.get("folds", [])):
        for key in ("contact_radius", "indentation", "force"):
            for step in (1, -1):
                yield changed(f"{key} of fold {index} moved", lambda c: c["folds"][index].update({key: bumped(fold[key], step)}))
        for key in [key for key in ("indentation", "force") if fold[key] not in ("0", None)]:
            yield changed(f"{key} of fold {index} is 0", lambda c: c["folds"][index].update({key: "0"}))
        yield changed(f"fold {index} missing", lambda c: c["folds"].pop(index))
        yield changed(f"kind of fold {index}", lambda c: c["folds"][index].update(kind=FLIPPED[fold["kind"]]))
    for row, at in enumerate(given.get("equilibria", [])):
        for index, state in enumerate(at["equilibria"]):
            states = lambda c: c["equilibria"][row]["equilibria"]
            yield changed(f"equilibrium {index} of value {row} missing", lambda c: states(c).pop(index))
            yield changed("an equilibrium twice", lambda c: states(c).append(states(c)[index]))
            yield changed("stability", lambda c: states(c)[index].update(stable=not state["stable"]))
            radius = bumped(state["contact_radius"], 1)
            yield changed("a radius of an equilibrium moved", lambda c: states(c)[index].update(contact_radius=radius))
    for index, event in enumerate(given.get("path", [])):
        yield changed(f"event {index} missing", lambda c: c["path"].pop(index))
        for key in ("contact_radius", "to_contact_radius", "force", "to_force"):
            if event.get(key) and "." in event[key]:
                yield changed(f"{key} of event {index} moved", lambda c: c["path"][index].update({key: bumped(event[key], 1)}))
    yield from on_other_media(given)
    for key in [key for key in ("e_star", "stiffness") if key in given]:
        yield changed(f"another {key}", lambda c: c.update({key: bumped(given[key], 1)}))
    yield changed("another work of adhesion", lambda c: c.update(work_of_adhesion=c["work_of_adhesion"] + "1" if "." in c["work_of_adhesion"] else "7e-4"))


def in_other_words(given):
    """The certificate of a wave whose formula is not read as that of a wave, so that all of its integrals are others."""
    other = copy.deepcopy(given)
    for term in other["profile"]:
        term["f"] = term["f"].replace("h*(1 - cos(2*pi*r/l))", "2*h*sin(pi*r/l)^2")
    return other


def main():
    survived, refused = [], 0
    for file in sorted(glob.glob(os.path.join(here, "*.json"))):
        with open(file, encoding="utf-8") as text:
            given = json.load(text)
        Certificate(copy.deepcopy(given)).check()
        Certificate(in_other_words(given)).check()
        for what, other in changes(given):
            try:
                Certificate(other).check()
            except (Refused, KeyError) as why:
                refused += 1
                if "-v" in sys.argv:
                    print(f"{os.path.basename(file)}: {what}: {why}")
            else:
                survived.append(f"{os.path.basename(file)}: {what}")
    for fault in survived:
        print(f"accepted with a fault: {fault}")
    print(f"{refused} certificates with a fault refused, {len(survived)} accepted")
    sys.exit(1 if survived else 0)


if __name__ == "__main__":
    main()
