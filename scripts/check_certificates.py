#!/usr/bin/env python3
"""Checks certificates of mdr (schema mdr.certificate/1), without mdr, in Arb.

    pip install python-flint
    python3 scripts/check_certificates.py CERTIFICATE.json [MORE.jsonl ...] [--records RECORDS.jsonl ...]

What is taken from the theory are the definitions of the media, in certificate_media.py: a contact is given by its stiffness, its
area and the depth without adhesion. On a half-space, with the heights f(r),

    g(x) = x int_0^x f'(r)/sqrt(x^2 - r^2) dr  (1.1)        dl(a) = sqrt(2 pi a w/E*)  (1.4)
    d = g(a) - dl(a)  (1.5)                                 F = 2 E* int_0^a (d - g) dx  (1.6)

C(a) is the controlled quantity (d, F or d + F/k) of the equilibrium with contact radius a. certificate_transform.py has the
integrals, certificate_contact.py C and its derivatives, certificate_formula.py reads f as a formula and differentiates it by
Taylor series. All numbers are balls, and all integrals rigorous. One thing is assumed: slopes on the two sides of a kink that
agree to 60 bits are equal.

A certificate is refused unless its cells join without a gap from one end of the range to the other, C has on each cell the
trend that is claimed, each fold and each equilibrium lies where it is printed (an interval Newton step proves it, and every
digit), none is missing by the signs of C - value between the turning points, and the path is the one that follows from these
(certificate_path.py). Not checked: energies, and whether surfaces overlap outside of the contact.

With --records, the digits of published records are compared with those of the certificates that were checked, each of which is
proved then: certificate_records.py.

Exit status: 0 all checked, 1 one is refused, 77 python-flint is not there.
"""

import itertools
import json
import sys
import time

try:
    from flint import arb, ctx
except ImportError:
    print("skipped: python-flint is not installed (pip install python-flint)")
    sys.exit(77)

from certificate_contact import Contact
from certificate_formula import ROUGH, Refused, bisected, half_unit, hull, letter_of, rational, require, shown
from certificate_path import Path
from certificate_records import compared
from certificate_transform import EFFORT

DEPTH = 64  # halvings of a cell
LEAVES = 4000  # parts of a cell


# Cells


class Parts:
    """The sign of turning on parts of a cell within one piece, which is halved until each has one or is monotone."""

    def __init__(self, contact, piece, above=None):
        self.contact, self.piece, self.above, self.count = contact, piece, above, 0

    def kind(self, lower, upper):
        """+ or - for a sign, u or d where turning rises or falls; None where it stays open."""
        contact, x, piece = self.contact, hull(lower, upper), self.piece
        if course := contact.course():
            return course
        beside = self.above is not None and lower == self.above and contact.transform.jump(piece - 1) is not None
        try:
            if letter := letter_of(contact.turning(x, piece, beside)):
                return letter
            if beside:
                return None
            if lower == 0:
                return contact.sign_at_tip(upper)
            slope, middle = contact.turning_slope(x, piece), arb(x.mid())
            if letter := letter_of(contact.turning(middle, piece) + slope * (x - middle)):
                return letter
            return {"+": "u", "-": "d"}.get(letter_of(slope))
        except Refused:
            return None

    def leaves(self, lower, upper, depth=0):
        self.count += 1
        self.contact.transform.effort = EFFORT[depth > 16]
        if kind := self.kind(lower, upper):
            return [(lower, upper, kind)]
        require(depth < DEPTH and self.count < LEAVES, f"a cell at a = {shown(lower)} is not decided")
        middle = arb((upper / 16 if lower == 0 else (arb(lower) + arb(upper)) / 2).mid())
        return self.leaves(lower, middle, depth + 1) + self.leaves(middle, upper, depth + 1)

    def trend(self, lower, upper):
        signs, leaves = "", self.leaves(lower, upper)
        while leaves:
            kind = leaves[0][2]
            run = list(itertools.takewhile(lambda leaf: leaf[2] == kind, leaves))
            leaves = leaves[len(run):]
            if kind in "ud":
                ends = [letter_of(self.contact.turning(arb(x), self.piece)) for x in (run[0][0], run[-1][1])]
                require(None not in ends, "the sign beside a fold")
                kind = ends[0] if ends[0] == ends[1] else kind
            signs += kind if not signs.endswith(kind) else ""
        found = {"+": "rises", "-": "falls"}.get(signs) or TURNS.get(signs)
        require(found, f"C' has the signs {signs} on one cell")
        return found


# With u and d for a change of sign where turning is monotone.
TURNS = {shape: "minimum" for shape in ("-u+", "-u", "u+", "u")} | {shape: "maximum" for shape in ("+d-", "+d", "d-", "d")}


JOINED = {
    ("falls", "falls"): "falls", ("rises", "rises"): "rises", ("falls", "rises"): "minimum", ("rises", "falls"): "maximum",
    ("minimum", "rises"): "minimum", ("falls", "minimum"): "minimum", ("maximum", "falls"): "maximum", ("rises", "maximum"): "maximum",
}


def trend(contact, lower, upper):
    """How C behaves on a cell: found, not believed."""
    if contact.edge is not None and not upper < contact.edge:
        require(within(contact, lower, arb(contact.edge)) == "falls", "C rises to a vertical edge")
        return "minimum"
    return within(contact, lower, upper)


def within(contact, lower, upper):
    """How C behaves on a cell before a vertical edge."""
    kinks = [i for i, b in enumerate(contact.breaks) if not (b < lower or b > upper)]
    require(len(kinks) <= 1, "two kinks in one cell")
    if not kinks:
        return Parts(contact, contact.piece(hull(lower, upper))).trend(lower, upper)
    kink, parts = kinks[0], []
    below, above = arb(contact.breaks[kink].lower()), arb(contact.breaks[kink].upper())
    if lower < below:
        parts.append(Parts(contact, kink).trend(lower, above))
    if above < upper:
        parts.append(Parts(contact, kink + 1, below).trend(below, upper))
    require(len(parts) == 1 or tuple(parts) in JOINED, f"at a kink C {' and '.join(parts)}")
    return parts[0] if len(parts) == 1 else JOINED[tuple(parts)]


# Certificates


class Turn:
    """A turning point of C: where, and the value there."""

    def __init__(self, a, kind, state, value):
        self.a, self.kind, self.state, self.value = a, kind, state, value


class Certificate:
    def __init__(self, given):
        require(given.get("schema") == "mdr.certificate/1", "the schema")
        self.given, self.digits = given, given["digits"]
        self.bits = int(3.33 * self.digits) + 80
        with precision(self.bits):
            self.contact = Contact(given)

    def check(self):
        """Refuses, or counts what was checked; with more bits where digits cancel."""
        try:
            return self.check_in(self.bits, 2)
        except Refused:
            if not self.contact.law:
                raise
        with precision(4 * self.bits):
            self.contact = Contact(self.given)
        return self.check_in(4 * self.bits, 8)

    def check_in(self, bits, steps):
        self.steps = steps
        with precision(self.bits if self.contact.law else ROUGH):
            cells = self.cells()
        with precision(bits):
            self.turns = [self.turn(cell, row) for cell, row in self.folds(cells)]
            ends = [rational(text) for text in self.given["range"]]
            self.range = [arb(end) for end in ends]
            states = sum(self.equilibria(row) for row in self.given.get("equilibria", []))
            events = Path(self).check() if "path" in self.given else 0
        return len(cells), len(self.turns), states, events

    def cells(self):
        """The cells, which cover the range, each with the trend that it claims."""
        rows = self.given["cells"]
        require(rows and rows[0]["from"] == self.given["range"][0], "the first cell does not begin with the range")
        require(rows[-1]["to"] == self.given["range"][1], "the last cell does not end with the range")
        for cell, other in zip(rows, rows[1:]):
            require(cell["to"] == other["from"], f"the cell to a = {cell['to']} and the next, from {other['from']}, do not join")
        cells = [(rational(cell["from"]), rational(cell["to"]), cell["trend"]) for cell in rows]
        for begin, end, claimed in cells:
            require(0 <= begin < end, "a cell without radii")
            found = trend(self.contact, arb(begin), arb(end))
            require(found == claimed, f"from a = {shown(begin)} to {shown(end)} C {found}, not {claimed}")
        courses = "".join({"falls": "-", "rises": "+", "minimum": "-+", "maximum": "+-"}[cell[2]] for cell in cells)
        require(all(left == right for left, right in courses_at_ends(cells)), f"the trends {courses} do not join")
        return cells

    def folds(self, cells):
        """The cells where C turns, each with the fold that is printed."""
        turning = [cell for cell in cells if cell[2] in ("minimum", "maximum")]
        rows = self.given.get("folds", [None] * len(turning))
        require(len(rows) == len(turning), f"{len(rows)} folds, and C turns {len(turning)} times")
        return list(zip(turning, rows))

    def turn(self, cell, row):
        lower, upper, kind = cell
        contact = self.contact
        kinks = [b for b in contact.breaks if not (b < lower or b > upper)]
        if contact.edge is not None and not upper < contact.edge:
            a, piece = arb(contact.edge), len(contact.breaks)
        elif kinks and self.is_fold(kinks[0], kind):
            a = kinks[0]
            piece = contact.breaks.index(a)
        else:
            pieces = [arb(lower)] + kinks + [arb(upper)]
            a, piece = self.zero(pieces, kind, row)
        state = contact.state(a, piece)
        if row is not None:
            require(row["kind"] == kind, "the kind of a fold")
            self.agree(row, a, state)
        return Turn(a, kind, state, contact.controlled(*state))

    def is_fold(self, kink, kind):
        """Whether C' changes its sign at a kink itself, as its two pieces say beside it."""
        index, near = self.contact.breaks.index(kink), arb(2) ** -30
        signs = [letter_of(self.contact.turning(arb((kink * (1 + side * near)).mid()), index + (side > 0))) for side in (-1, 1)]
        return signs == (["-", "+"] if kind == "minimum" else ["+", "-"])

    def zero(self, ends, kind, row):
        """The zero of turning between ends, between which it has one: around the printed radius, or bisected."""
        contact = self.contact
        for lower, upper in zip(ends, ends[1:]):
            piece = contact.piece(arb(((lower + upper) / 2).mid()))
            f = lambda a: contact.turning(a, piece)
            if row is not None and row["contact_radius"] is not None:
                a = rational(row["contact_radius"])
                if lower < a < upper:
                    return self.newton(row["contact_radius"], f, lambda a: contact.turning_slope(a, piece)), piece
            else:
                inner = [arb(lower.upper()), arb(upper.lower())]
                if lower > 0 and f(inner[0]) * f(inner[1]) < 0:
                    return bisected(f, *inner), piece
        raise Refused(f"no {kind} of C where its cell is")

    def newton(self, text, f, slope):
        """The zero of f within half a unit of the last printed digit, by interval Newton steps."""
        printed = arb(rational(text))
        unit = arb(half_unit(text))
        box = printed + unit * hull(-1, 1)
        steep = slope(box)
        require(not steep.contains(0), f"whether there is one zero at {text}")
        for step in range(self.steps):
            middle = arb(box.mid())
            image = middle - f(middle) / steep
            if step == 0:
                require(image.overlaps(box) and image.is_finite(), f"no zero within half a unit of the last digit of {text}")
                inside = bool(abs(image - printed) <= unit * (1 + arb(2) ** -40))
                require(inside, f"a zero within half a unit of the last digit of {text}")
            box = image.intersection(box)
        return box

    def agree(self, row, a, state, prefix=""):
        """The printed digits are those of the state; a 0 is one of which nothing is left in so many bits."""
        for key, value, size in zip(("contact_radius", "indentation", "force"), (a, *state), self.contact.sizes(a)):
            text = row.get(prefix + key)
            if text is None:
                missing = row.get("status", "ok") == "ok" and prefix + key in row and not prefix
                require(value is None or not missing, f"no {key}")
                continue
            require(value is not None, f"{prefix}{key} {text}, which is not defined")
            slack = half_unit(text) if "/" not in text else 0
            rounding = arb(2) ** -(ctx.prec // 2 + 20) * (size if rational(text) == 0 else abs(value))
            exact = bool(abs(value - rational(text)) <= arb(slack) * (1 + arb(2) ** -40) + rounding)
            require(exact, f"{prefix}{key} {text}, which is {value.str(self.digits + 5)}")

    # Equilibria

    def branches(self):
        """Between turning points: the two ends with the value of C, None at the vertical edge beyond which it has no bound."""
        ends = [(self.range[0], self.end_value(self.range[0]))]
        ends += [(turn.a, turn.value) for turn in self.turns]
        at_edge = self.contact.edge is not None and self.turns and self.turns[-1].a.contains(self.contact.edge)
        ends.append((arb(self.contact.edge), None) if at_edge else (self.range[1], self.end_value(self.range[1])))
        return list(zip(ends, ends[1:]))

    def end_value(self, a):
        with precision(ROUGH):
            return self.contact.at_tip() if a == 0 else self.contact.at(a, self.contact.piece(a))

    def side(self, end, value):
        """The sign of C - value at the end of a branch."""
        if end[1] is None:
            return "+"
        if end[0] == 0 and value == end[1]:
            return {"falls": "-", "minimum": "-"}.get(self.given["cells"][0]["trend"], "+")
        letter = letter_of(end[1] - value)
        require(letter, "a value at a fold")
        return letter

    def equilibria(self, row):
        """As many states as C passes the value, each where it is printed."""
        value = arb(rational(row["value"]))
        states = [state for state in row["equilibria"]]
        inside = [state for state in states if self.range[0] <= rational(state["contact_radius"]) <= self.range[1]]
        for state in states:
            self.equilibrium(state, value)
        for lower, upper in self.branches():
            sides = [self.side(lower, value), self.side(upper, value)]
            here = [state for state in inside if lower[0] < rational(state["contact_radius"]) < upper[0]]
            if upper[1] is None:
                here = [state for state in inside if abs(rational(state["contact_radius"]) - upper[0]) < half_unit(state["contact_radius"]) * 2]
            require(len(here) == (sides[0] != sides[1]), f"{len(here)} equilibria on a branch where C - value goes from {sides[0]} to {sides[1]}")
            if here:
                stable = sides[0] == "-"
                require(here[0]["stable"] is stable, f"stable at a = {here[0]['contact_radius']}")
        return len(states)

    def equilibrium(self, row, value, prefix=""):
        """The state with C = value around the printed radius; its radius."""
        text, contact = row[prefix + "contact_radius"], self.contact
        near = arb(rational(text)) + arb(half_unit(text)) * hull(-1, 1)
        if contact.edge is not None and near.contains(arb(contact.edge)):
            a, state = contact.at_edge(value)
        else:
            piece = contact.piece(near)
            require(piece is not None, "an equilibrium at a kink")
            a = self.newton(text, lambda a: contact.at(a, piece) - value, lambda a: contact.controlled_slope(a, piece))
            state = contact.state(a, piece)
        self.agree(row, a, state, prefix)
        return a


def courses_at_ends(cells):
    """Pairs of the trend with which a cell ends and that with which the next begins."""
    ends = {"falls": "--", "rises": "++", "minimum": "-+", "maximum": "+-"}
    return [(ends[one[2]][1], ends[other[2]][0]) for one, other in zip(cells, cells[1:])]


class precision:
    """Arithmetic with so many bits."""

    def __init__(self, bits):
        self.bits = bits

    def __enter__(self):
        self.before, ctx.prec = ctx.prec, self.bits

    def __exit__(self, *_):
        ctx.prec = self.before


def lines(file):
    """The certificates of a file: one, or one a line."""
    text = open(file, encoding="utf-8").read()
    return [json.loads(line) for line in text.splitlines() if line.strip()]


def main():
    arguments, start, wrong, total = sys.argv[1:], time.time(), 0, [0, 0, 0, 0]
    end = arguments.index("--records") if "--records" in arguments else len(arguments)
    files, records, checked = arguments[:end], arguments[end + 1 :], []
    for file in files:
        for number, given in enumerate(lines(file), 1):
            try:
                counts = Certificate(given).check()
                total = [x + y for x, y in zip(total, counts)]
                checked.append(given)
            except Refused as why:
                wrong += 1
                print(f"{file}:{number}: refused: {why}")
    cells, folds, states, events = total
    print(f"{cells} cells, {folds} folds, {states} equilibria, {events} events checked; {wrong} certificates refused; {time.time() - start:.1f} s")
    if records:
        same, contacts, differ, apart = compared(records, checked)
        print(f"{same} records of {contacts} contacts have the digits of their certificates, {len(differ)} differ, {apart} have none")
        for name in differ:
            print(f"not the digits of its certificate: {name}")
        wrong += len(differ)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
