"""The digits of published records against those of certificates that were checked, for check_certificates.py.

A record belongs to the certificate with the same modulus, work of adhesion, control, stiffness and numbers of the profile. Its
number is that of a fold, by its place, or of an equilibrium at a value of what is controlled, by its place; it has to be the
same decimal, to the last of its digits.
"""

import json
from fractions import Fraction

# The inputs of records that are no number of a profile.
OTHERS = ("E*", "w", "k", "d", "F", "D", "a", "fold", "state", "tau", "x")
HELD = {"indentation": "d", "force": "F", "machine": "D"}
ASKED = ("ok", "overflow", "underflow", "no-equilibrium")
FOLDS = ("critical", "machine-folds", "folds")
EQUILIBRIA = ("equilibrium", "equilibria")


def contact_of_certificate(given):
    numbers = sorted(Fraction(number) for term in given["profile"] for number in term["parameters"].values())
    stiffness = given.get("stiffness")
    material = Fraction(given["e_star"]), Fraction(given["work_of_adhesion"])
    return (*material, given["control"], stiffness and Fraction(stiffness), tuple(numbers))


def contact_of_record(record):
    inputs = record["inputs"]
    numbers = sorted(Fraction(number) for name, number in inputs.items() if name not in OTHERS)
    stiffness = Fraction(inputs["k"]) if "k" in inputs else None
    return Fraction(inputs["E*"]), Fraction(inputs["w"]), record["control"], stiffness, tuple(numbers)


def place(record, count):
    """Which of so many states the record is about."""
    inputs = record["inputs"]
    if "fold" in inputs or "state" in inputs:
        return int(inputs.get("fold") or inputs["state"]) - 1
    if record["formula"] == "equilibrium":
        # The inner one of two is unstable below a fold; on the other side of it there is one alone.
        return 0 if "inner" in record["id"] else count - 1
    return 0


def states(record, given):
    """The states of a certificate among which that of the record is; None if the question is not asked there."""
    if record["formula"] in FOLDS:
        return given.get("folds")
    value = Fraction(record["inputs"][HELD[record["control"]]])
    at_value = [at["equilibria"] for at in given.get("equilibria", []) if Fraction(at["value"]) == value]
    return at_value[0] if at_value else None


def matches(record, rows):
    if record["status"] == "no-equilibrium":
        return not rows
    index = place(record, len(rows))
    if not 0 <= index < len(rows):
        return False
    text = rows[index][record["quantity"]]
    return text is not None and Fraction(text) == Fraction(record["mid"])


def moved(record):
    """The record with another last digit, or with a number in the place of none."""
    if record["status"] == "no-equilibrium":
        return dict(record, status="ok", mid="1", rad="1")
    return dict(record, mid=str(Fraction(record["mid"]) + 2 * (Fraction(record["rad"]) or 1)))


def compared(files, certificates):
    """How many records have their digits from certificates, of how many contacts, and the ids of those that differ."""
    by_contact = {}
    for given in certificates:
        by_contact.setdefault(contact_of_certificate(given), []).append(given)
    same, contacts, differ, apart = 0, set(), [], 0
    for file in files:
        for line in open(file, encoding="utf-8"):
            record = json.loads(line)
            if record["formula"] not in FOLDS + EQUILIBRIA or record["status"] not in ASKED:
                continue
            contact = contact_of_record(record)
            found = (states(record, given) for given in by_contact.get(contact, []))
            found = [rows for rows in found if rows is not None]
            if not found:
                apart += 1
            elif any(matches(moved(record), rows) for rows in found):
                differ.append(f"{record['id']} with another last digit, too")
            elif any(matches(record, rows) for rows in found):
                same += 1
                contacts.add(contact)
            else:
                differ.append(record["id"])
    return same, len(contacts), differ, apart
