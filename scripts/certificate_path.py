"""The path that follows from the turning points of C, against the events of a certificate, for check_certificates.py."""

from flint import arb

from certificate_formula import bisected, half_unit, rational, require


class Path:
    """A path: on rising branches, and at their ends to the next in the way of the jump."""

    def __init__(self, certificate):
        self.of, self.rows = certificate, list(certificate.given["path"])
        self.branches = certificate.branches()
        require(certificate.given["cells"][0]["from"] == "0", "a path whose radii are known down to the tip")

    def rising(self, index):
        lower, upper = self.branches[index]
        start = self.of.given["cells"][0]["trend"] in ("rises", "maximum")
        return start == (index % 2 == 0)

    def holds(self, index, value):
        """Whether there is an equilibrium on a rising branch."""
        lower, upper = self.branches[index]
        return self.rising(index) and self.of.side(lower, value) == "-" and self.of.side(upper, value) == "+"

    def next_row(self, event):
        require(self.rows, f"the path ends before its {event}")
        row = self.rows.pop(0)
        require(row["event"] == event, f"the event {row['event']}, where the path has {event}")
        return row

    def state(self, row, index, value, prefix=""):
        """The state of a row is the one on a branch."""
        if index is None:
            require(row[prefix + "contact_radius"] is None, "a contact radius without contact")
            return
        a = self.of.equilibrium(row, value, prefix)
        lower, upper = self.branches[index]
        require(upper[1] is None or lower[0] < a < upper[0], "a state on another branch")

    def check(self):
        way = [arb(rational(text)) for text in self.of.given["way"]]
        count, here = len(self.rows), self.begin(self.of.given["start"], way[0])
        self.state(self.next_row("start"), here, way[0])
        for place, (value, target) in enumerate(zip(way, way[1:])):
            here = self.move(here, value, target)
            if here == "complete":
                break
            self.state(self.next_row("end" if place == len(way) - 2 else "way-point"), here, target)
        require(not self.rows, "events after the end of the path")
        return count

    def begin(self, start, value):
        held = [index for index in range(len(self.branches)) if self.holds(index, value)]
        if start == "detached":
            return None
        require(held, "no stable state to start from")
        if start in ("largest", "smallest"):
            return held[-1 if start == "largest" else 0]
        row, wanted = self.rows[0], arb(rational(start))
        nearness = []
        for index in held:
            f = lambda a: self.of.contact.at(a, self.of.contact.piece(a)) - value
            lower, upper = (arb(end[0].mid()) for end in self.branches[index])
            a = bisected(f, lower * (1 + arb(2) ** -60), upper * (1 - arb(2) ** -60))
            nearness.append((abs((a / wanted).log()), index))
        return min(nearness, key=lambda pair: float(pair[0].mid()))[1]

    def move(self, here, value, target):
        up = bool(target > value)
        while True:
            if here is None:
                if not up or not target > 0:
                    return None
                require(value <= 0, "surfaces that touch already")
                value = arb(0)
                if self.rising(0) and self.branches[0][0][1] == 0:
                    here = 0
                    self.next_row("touch")
                    continue
                here = self.land(-1, value, outwards=True)
                self.state(self.next_row("jump-in"), here, value, "to_")
                continue
            lower, upper = self.branches[here]
            end = upper if up else lower
            beyond = end[1] is not None and (end[1] < target if up else end[1] > target)
            if not beyond:
                require(end[1] is None or end[1] > target or end[1] < target, "a way point at a fold")
                return here
            if end[0] == 0:
                here, value = self.shrink(end[1]), end[1]
                continue
            require(here + 1 < len(self.branches) if up else here > 0, "a path that leaves the range")
            turn, value = self.of.turns[here if up else here - 1], end[1]
            there = self.land(here, value, up)
            if up and there is None:
                # Beyond the last turning point of a power law below its threshold turning falls on all radii.
                require(self.of.contact.course() == "d", "a jump out of the range")
                self.of.agree(self.next_row("complete-contact"), turn.a, turn.state)
                return "complete"
            row = self.next_row("jump" if there is not None else "detached")
            self.of.agree(row, turn.a, turn.state)
            if there is not None:
                self.state(row, there, value, "to_")
            here = there

    def shrink(self, value):
        """A contact that shrinks to a point."""
        row = self.next_row("detached")
        require(row["contact_radius"] == "0" and row["force"] == "0", "a point with a radius or a force")
        if row["indentation"] is None:
            return require(not self.of.contact.medium.has_depth, "no depth of a point")
        slack = abs(rational(row["indentation"]) - value)
        require(bool(slack <= arb(half_unit(row["indentation"])) * (1 + arb(2) ** -40)), "the depth at which a contact is a point")

    def land(self, here, value, outwards):
        """The next branch with an equilibrium, over which C - value keeps the sign that drives the contact."""
        order = range(here + 1, len(self.branches)) if outwards else range(here - 1, -1, -1)
        for index in order:
            if abs(index - here) > 1 and self.holds(index, value):
                return index
            if index == 0 and outwards and here == -1 and self.holds(index, value):
                return index
        return None
