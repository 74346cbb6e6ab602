"""The digits of published records against those of certificates that were checked, for check_certificates.py.

A record belongs to the certificate with the same medium, work of adhesion, control, stiffness and numbers of the profile. Its
number is that of a fold, by its place, or of an equilibrium at a value of what is controlled, by its place; it has to be the
same decimal, to the last of its digits.
"""

import json
from decimal import Context, Decimal
from fractions import Fraction

# The inputs of records that are no number of a profile.
OTHERS = ("E*", "w", "k", "d", "F", "D", "a", "fold", "state", "tau", "x", "chi", "c")
HELD = {"indentation": "d", "force": "F", "machine": "D"}
ASKED = ("ok", "overflow", "underflow", "no-equilibrium")
FOLDS = ("critical", "machine-folds", "folds", "graded-critical", "line-critical", "wave-fold")
EQUILIBRIA = ("equilibrium", "equilibria")
# The media of records that are not about a half-space: by their formulas, the kind and the inputs that are its numbers.
MEDIA = {
    "graded-critical": ("graded", {"exponent": "chi", "coefficient": "c"}),
    "line-critical": ("plane", {}),
    "wave-fold": ("periodic", {"wavelength": "lambda"}),
}
KINDS = {"pull-off": "minimum", "pull-in": "maximum"}
# Enough for the fifty digits of a record, and for any exponent.
EXACT = Context(prec=200, Emax=10**17, Emin=-(10**17))


def medium(kind, numbers, modulus):
    """What has to be equal of a medium; a modulus that it does not use is None."""
    return kind, tuple(sorted((key, Fraction(value)) for key, value in numbers.items())), modulus and Fraction(modulus)


def contact_of_certificate(given):
    numbers = sorted(Fraction(number) for term in given["profile"] for number in term["parameters"].values())
    stiffness = given.get("stiffness")
    words = dict(given.get("medium", {"kind": "half-space"}))
    of = medium(words.pop("kind"), words, given.get("e_star"))
    return of, Fraction(given["work_of_adhesion"]), given["control"], stiffness and Fraction(stiffness), tuple(numbers)


def contact_of_record(record):
    inputs = record["inputs"]
    numbers = sorted(Fraction(number) for name, number in inputs.items() if name not in OTHERS)
    stiffness = Fraction(inputs["k"]) if "k" in inputs else None
    kind, names = MEDIA.get(record["formula"], ("half-space", {}))
    of = medium(kind, {key: inputs[name] for key, name in names.items()}, inputs.get("E*"))
    return of, Fraction(inputs["w"]), record["control"], stiffness, tuple(numbers)


def place(record, rows):
    """Which of the states the record is about."""
    inputs, count = record["inputs"], len(rows)
    if record["formula"] == "wave-fold":
        kind = next(kind for flag, kind in KINDS.items() if flag in record["flags"])
        return next((index for index, row in enumerate(rows) if row["kind"] == kind), count)
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
    index = place(record, rows)
    if not 0 <= index < len(rows):
        return False
    text = rows[index][record["quantity"]]
    return text is not None and EXACT.create_decimal(text) == EXACT.create_decimal(record["mid"])


def moved(record):
    """The record with another last digit, or with a number in the place of none."""
    if record["status"] == "no-equilibrium":
        return dict(record, status="ok", mid="1", rad="1")
    step = EXACT.create_decimal(record["rad"]) or Decimal(1)
    return dict(record, mid=str(EXACT.add(EXACT.create_decimal(record["mid"]), EXACT.multiply(Decimal(2), step))))


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
