#!/usr/bin/env python3
"""Recomputes the certified fits in Arb, from the data sets alone.

    pip install python-flint
    python3 tests/confirm_fits.py [NAME ...]

For each data set of crates/mdr-reference/data/fits: rows are assigned to the arcs of the curve or to the baseline by least
cost; Newton's iteration from the published estimates ends in a box around a stationary point of the sum of squares, on which
Krawczyk's operator proves that there is one, and a Cholesky decomposition of the Hessian in balls proves that it is a local
minimum. The estimates of the records, the standard errors s sqrt((J'J)^-1)_jj and the sum of squares have to lie within their
radii of what the box gives.

Shared with the Rust code: the definitions d = g - dl, F = 2 E* (a d - G), dl = sqrt(2 pi a w/E*), what each observation
compares, and the closed forms of g and G, each of which is compared here with its definition by rigorous quadrature of f'.
Other than in Rust are the derivatives (truncated power series in the free numbers, along the implicit radius of each row) and
the assignment of rows.

At the end a data set and its records are changed in a few places, which has to be refused.

Exit status: 0 all confirmed, 1 a fit differs or a change is not refused, 77 python-flint is not there.
"""

import csv
import glob
import json
import math
import os
import sys
import time

try:
    import tomllib
    from flint import arb, arb_mat, ctx, fmpq
except ImportError:
    print("skipped: python-flint (pip install python-flint), or tomllib of Python 3.11, is not there")
    sys.exit(77)

from fit_curves import Curve, Profile, Series

DATA = os.path.join(os.path.dirname(__file__), "..", "crates", "mdr-reference", "data")
BITS = 512
UNITS = {"": fmpq(1), "m": fmpq(1), "N": fmpq(1), "nm": fmpq(1, 10**9), "nN": fmpq(1, 10**9)}
# What a detached row, the nearest point of an arc and its end are.
DETACHED, AT_X, NEAREST, END = range(4)


def exact(text):
    """The rational number that a decimal is."""
    mantissa, _, exponent = text.strip().lower().partition("e")
    whole, _, fraction = mantissa.partition(".")
    scale = int(exponent or 0) - len(fraction)
    digits = int(whole + fraction)
    return fmpq(digits * 10**scale) if scale >= 0 else fmpq(digits, 10**-scale)


class Data:
    """A data set: what is fitted, its rows, and the records of its answer."""

    def __init__(self, name):
        self.name = name
        base = os.path.join(DATA, "fits", name)
        with open(base + ".toml", "rb") as file:
            asked = tomllib.load(file)
        self.kind, self.observation = asked["profile"].pop("kind"), asked["data"]["observation"]
        self.free = asked["fit"]["free"]
        self.known = {"contact_point": fmpq(0), "baseline": fmpq(0)}
        for table in (asked["profile"], asked.get("material", {}), asked["fit"].get("fixed", {})):
            self.known |= {key: exact(text) for key, text in table.items()}
        if "control" in asked:
            self.known["stiffness"] = exact(asked["control"]["stiffness"])
        self.known = {key: value for key, value in self.known.items() if key not in self.free}
        sigma = {key: exact(text) for key, text in asked["data"]["sigma"].items()}
        self.scales = (sigma["x"], sigma["y"]) if sigma["x"] != 0 else None
        columns = asked["data"].get("columns")
        with open(base + ".csv", encoding="utf-8") as file:
            header, units, *lines = csv.reader(file)
        places = [header.index(columns[key]) if columns else index for index, key in enumerate("xy")]
        leg = header.index(columns["leg"]) if columns and "leg" in columns else None
        self.rows = [tuple(exact(line[place]) * UNITS[units[place]] for place in places) for line in lines]
        legs = [line[leg] for line in lines] if leg is not None else None
        ends = self.rows[0][0], self.rows[-1][0]
        self.legs = legs or ["retract" if ends[0] > ends[1] else "approach"] * len(lines)
        with open(os.path.join(DATA, "fits.jsonl"), encoding="utf-8") as file:
            records = (json.loads(line) for line in file)
            self.records = {r["quantity"]: r for r in records if r["id"].startswith(f"fit/{name}/")}

    def numbers(self, values):
        """All numbers, as balls."""
        return {key: arb(value) for key, value in self.known.items()} | dict(zip(self.free, values))

    def series(self, values, more=0):
        """All numbers, the free ones as variables, with `more` variables after them."""
        count = len(self.free) + more
        variables = {key: Series.variable(value, place, count) for place, (key, value) in enumerate(zip(self.free, values))}
        return {key: arb(value) for key, value in self.known.items()} | variables


def middle(x):
    return arb(x.mid())


def arcs(data, values):
    """The arcs of the curve on which X rises with the radius, outermost first, as lists of (a, X, Y), in few bits."""
    ctx.prec = 64
    curve = Curve(data, data.numbers([middle(value) for value in values]))
    top = max(x for x, _ in data.rows)
    inner = float(curve.p["flat"]) * (1 + 1e-12) if "flat" in curve.p else 0.0
    limit = 0.999 * float(curve.p["radius"]) if data.kind == "sphere" else math.inf
    outer = max(1e-12, 1.01 * inner)
    # Small unstable contacts may have a greater X, too.
    is_above = lambda a: curve.at(arb(a))[0] > arb(top) and curve.at(arb(1.001 * a))[0] > curve.at(arb(a))[0]
    while outer < limit and not is_above(outer):
        outer *= 1.2
    outer = min(outer * 1.2, limit)
    lowest = inner or outer * 1e-5
    steps = [k / 1500 for k in range(1501)]
    radii = sorted({lowest * (outer / lowest) ** k for k in steps} | {lowest + (outer - lowest) * k for k in steps})
    found, points = [], [(a, *map(float, curve.at(arb(a)))) for a in radii]
    for before, after in zip(points, points[1:]):
        if after[1] > before[1]:
            if not found or found[-1][-1] is not before:
                found.append([before])
            found[-1].append(after)
    ctx.prec = BITS
    return found[::-1]


def on_arc(data, arc, x, y):
    """Where a row belongs on an arc: cost, what it is there, and roughly its radius; None beyond the ends of the arc."""
    if data.scales:
        sx, sy = map(float, (arb(scale) for scale in data.scales))
        costs = [((px - x) / sx) ** 2 + ((py - y) / sy) ** 2 for _, px, py in arc]
        best = min(range(len(costs)), key=costs.__getitem__)
        return costs[best], (END if best == 0 else NEAREST), arc[best][0]
    if not arc[0][1] <= x <= arc[-1][1]:
        return None
    low, high = 0, len(arc) - 1
    while high - low > 1:
        between = (low + high) // 2
        low, high = (between, high) if arc[between][1] <= x else (low, between)
    share = (x - arc[low][1]) / (arc[high][1] - arc[low][1])
    a, value = (arc[low][k] + share * (arc[high][k] - arc[low][k]) for k in (0, 2))
    return (value - y) ** 2, AT_X, a


def assigned(data, values):
    """Each row on an arc or detached, of least cost, monotone along each leg: inwards and off on retraction."""
    found = arcs(data, values)
    base = float(dict(zip(data.free, values)).get("baseline", arb(0)))
    scale = float(arb(data.scales[1])) if data.scales else 1.0
    places = []
    for row in data.rows:
        x, y = (float(arb(value)) for value in row)
        options = [on_arc(data, arc, x, y) for arc in found]
        detached = None if data.observation == "F(a)" else (((base - y) / scale) ** 2, DETACHED, None)
        places.append(options + [detached])
    start, labels = 0, []
    for end in range(1, len(places) + 1):
        if end == len(places) or data.legs[end] != data.legs[start]:
            labels += cheapest(places[start:end], data.legs[start] == "retract")
            start = end
    return [options[label][1:] for options, label in zip(places, labels)]


def cheapest(rows, falls):
    """The labels of least cost that never decrease where `falls`, else never increase."""
    count = len(rows[0])
    order = range(count) if falls else range(count - 1, -1, -1)
    costs, back = {label: 0.0 for label in order}, []
    for row in rows:
        best, least, now, came = None, math.inf, {}, {}
        for label in order:
            if costs[label] < least:
                best, least = label, costs[label]
            now[label] = least + (row[label][0] if row[label] else math.inf)
            came[label] = best
        costs = now
        back.append(came)
    label = min(costs, key=costs.get)
    labels = []
    for came in reversed(back):
        labels.append(label)
        label = came[label]
    return labels[::-1]


class Sums:
    """Half the sum of squares with its derivatives, and J'J, at balls of the free numbers."""

    def __init__(self, data, values, places):
        count = len(data.free)
        self.data, self.values, self.count = data, values, count
        self.total, self.gradient = arb(0), [arb(0)] * count
        self.hessian, self.normal = ([[arb(0)] * count for _ in range(count)] for _ in range(2))
        self.plain = Curve(data, data.numbers(values))
        self.curve = Curve(data, data.series(values, 1))
        self.radii = []
        for row, place in zip(data.rows, places):
            self.radii.append(self.add([arb(value) for value in row], *place))

    def add(self, row, kind, near):
        scale = [1 / arb(value) for value in self.data.scales] if self.data.scales else [arb(1), arb(1)]
        if kind == DETACHED:
            base = self.curve.p["baseline"]
            part = (base if isinstance(base, Series) else Series.constant(base, self.count + 1)) - row[1]
            self.include([self.cut(part * scale[1])], None)
            return None
        a = self.radius(row, kind, near, scale)
        if kind == END:
            self.at_end(a, row, scale)
            return a
        x, y = self.curve.at(Series.variable(a, self.count, self.count + 1))
        x, y = (self.spread(part) for part in (x, y))
        if kind == AT_X:
            self.include([self.along(x, y - row[1])], None)
        else:
            self.nearest((x - row[0]) * scale[0], (y - row[1]) * scale[1])
        return a

    def spread(self, part):
        return part if isinstance(part, Series) else Series.constant(part, self.count + 1)

    def cut(self, part):
        """Without the radius, on which it does not depend."""
        return Series(part.value, part.first[: self.count], part.second[: self.count])

    def along(self, x, y):
        """y as a function of the free numbers alone, where x stays."""
        last, n = self.count, range(self.count)
        slope = [-x.first[i] / x.first[last] for i in n]

        def second(part, i, j):
            return (
                part.bend(i, j)
                + part.bend(i, last) * slope[j]
                + part.bend(j, last) * slope[i]
                + part.bend(last, last) * slope[i] * slope[j]
            )

        first = [y.first[i] + y.first[last] * slope[i] for i in n]
        ratio = y.first[last] / x.first[last]
        return Series(y.value, first, [[second(y, i, j) - ratio * second(x, i, j) for j in range(i + 1)] for i in n])

    def nearest(self, x, y):
        """The distance of the nearest point: X X_a + Y Y_a = 0."""
        last, n = self.count, range(self.count)
        along = lambda i: (q.first[last] * q.first[i] + q.value * q.bend(i, last) for q in (x, y))
        mixed = [sum(along(i), arb(0)) for i in range(last + 1)]
        length = (x.first[last] ** 2 + y.first[last] ** 2).sqrt()
        first = [sum((q.value * q.first[i] for q in (x, y)), arb(0)) for i in n]
        second = [
            [
                sum((q.first[i] * q.first[j] + q.value * q.bend(i, j) for q in (x, y)), arb(0))
                - mixed[i] * mixed[j] / mixed[last]
                for j in range(i + 1)
            ]
            for i in n
        ]
        half = Series((x.value**2 + y.value**2) / 2, first, second)
        self.include([], half, [[(y.first[i] * x.first[last] - x.first[i] * y.first[last]) / length for i in n]])

    def at_end(self, a, row, scale):
        """The distance of the end of an arc, where dX/da = 0."""
        curve = Curve(self.data, self.data.series(self.values))
        bend = self.plain_at(a)[0].bend(0, 0)
        radius = Series.constant(a, self.count)
        for _ in range(2):
            wrong = curve.turning(radius)
            # At the end itself it is 0, whatever the ball of the radius says.
            wrong.value = arb(0)
            radius = radius - wrong / bend
            radius.value = a
        x, y = curve.at(radius)
        self.include([(x - row[0]) * scale[0], (y - row[1]) * scale[1]], None)

    def include(self, residuals, half, columns=None):
        half = half or sum((part * part / 2 for part in residuals[1:]), residuals[0] * residuals[0] / 2)
        self.total += half.value
        columns = columns or [part.first for part in residuals]
        for i in range(self.count):
            self.gradient[i] += half.first[i]
            for j in range(self.count):
                self.hessian[i][j] += half.bend(i, j)
                self.normal[i][j] += sum((column[i] * column[j] for column in columns), arb(0))

    def plain_at(self, a):
        x, y = self.plain.at(Series.variable(a, 0, 1))
        return [part if isinstance(part, Series) else Series.constant(part, 1) for part in (x, y)]

    def radius(self, row, kind, near, scale):
        """A ball around the radius of the row for all values of the free numbers: by Newton's iteration, and the interval
        Newton operator over the ball."""
        if self.data.observation == "F(a)":
            return row[0]

        def equation(a):
            x, y = self.plain_at(a)
            if kind == AT_X:
                return x.value - row[0], x.first[0]
            if kind == END:
                return x.first[0], x.second[0][0]
            x, y = (x - row[0]) * scale[0], (y - row[1]) * scale[1]
            slope = sum((q.first[0] ** 2 + q.value * q.second[0][0] for q in (x, y)), arb(0))
            return x.value * x.first[0] + y.value * y.first[0], slope

        a = arb(near)
        if kind == END:
            return self.end_ball(a)
        for _ in range(60):
            value, slope = equation(a)
            step = middle(value / slope)
            a = middle(a - step)
            if abs(float(step)) < 1e-90 * abs(float(a)):
                break
        ball = a + a * arb(0, 1e-60)
        image = a - equation(a)[0] / equation(ball)[1]
        if not ball.contains_interior(image):
            raise ValueError("the radius of a row is not certain")
        return image

    def end_ball(self, a):
        """The end of an arc, where dX/da certainly changes its sign."""
        turning = lambda a: self.plain_at(a)[0].first[0]
        for _ in range(200):
            x = self.plain_at(a)[0]
            step = middle(x.first[0] / x.second[0][0])
            a = middle(a - step)
            if abs(float(step)) < 1e-90 * abs(float(a)):
                break
        for power in range(100, 50, -5):
            width = a / arb(10) ** power
            if turning(a - width) < 0 and turning(a + width) > 0:
                return (a - width).union(a + width)
        raise ValueError("the end of an arc is not certain")


def confirmed(data):
    """Refuses unless the records follow; how many there are, how many rows are detached, and how many at an end."""
    values = [arb(exact(data.records[name]["mid"])) for name in data.free]
    places = assigned(data, values)
    outermost = max((near for kind, near in places if near is not None))
    numbers = data.numbers(values)
    Profile(data.kind, numbers).check(arb(outermost))
    count = len(values)
    units = [arb(exact(data.records[f"{name}_stderr"]["mid"])) for name in data.free]
    first = Sums(data, values, places)
    # In units of the standard errors, and of the sum.
    square = lambda entries: arb_mat(
        [[entries[i][j] * units[i] * units[j] / (2 * first.total) for j in range(count)] for i in range(count)]
    )
    scaled = lambda sums: square(sums.hessian)
    pull = lambda sums: arb_mat([[sums.gradient[i] * units[i] / (2 * first.total)] for i in range(count)])
    inverse = arb_mat([[middle(x) for x in row] for row in scaled(first).inv().tolist()])
    step = inverse * pull(first)
    start = [middle(value - step[i, 0] * units[i]) for i, value in enumerate(values)]
    at_start = Sums(data, start, places)
    ball = arb(0, 1e-70)
    box = [value + unit * ball for value, unit in zip(start, units)]
    over = Sums(data, box, places)
    identity = arb_mat([[int(i == j) for j in range(count)] for i in range(count)])
    moved = inverse * pull(at_start)
    change = (identity - inverse * scaled(over)) * arb_mat([[ball]] * count)
    image = [arb(0) - moved[i, 0] + change[i, 0] for i in range(count)]
    if not all(ball.contains_interior(one) for one in image):
        raise ValueError(f"no stationary point is proved: {image}")
    pivots = cholesky(scaled(over), count)
    if not all(pivot > 0 for pivot in pivots):
        raise ValueError(f"not certainly a local minimum: {pivots}")
    found = dict(zip(data.free, (value + unit * one for value, unit, one in zip(start, units, image))))
    dof = len(data.rows) - count
    variance = 2 * over.total / dof
    covariance = (square(over.normal) * (2 * first.total / variance)).inv()
    for i, name in enumerate(data.free):
        found[f"{name}_stderr"] = covariance[i, i].sqrt() * units[i]
    found["rss"] = 2 * over.total
    if found.keys() != data.records.keys():
        raise ValueError(f"records of {sorted(data.records)}")
    for name, value in found.items():
        record = data.records[name]
        mid, rad = arb(exact(record["mid"])), arb(exact(record["rad"]))
        if not abs(value - mid) <= rad:
            raise ValueError(f"{name} is {value.str(60)}, the record says {record['mid']}")
    kinds = [kind for kind, _ in places]
    return len(found), kinds.count(DETACHED), kinds.count(END)


def cholesky(matrix, count):
    """The pivots of the decomposition of a symmetric matrix of balls."""
    rows, pivots = [list(row) for row in matrix.tolist()], []
    for k in range(count):
        pivots.append(rows[k][k])
        if not rows[k][k] > 0:
            break
        for i in range(k + 1, count):
            factor = rows[i][k] / rows[k][k]
            for j in range(k + 1, count):
                rows[i][j] -= factor * rows[k][j]
    return pivots


def refused(data):
    """Whether the fit is not confirmed."""
    try:
        confirmed(data)
    except (ValueError, ZeroDivisionError):
        return True
    return False


def refusals(name):
    """Of changes of a data set, whether each is refused: a datum by a millionth of itself, a known number by 1e-40 of itself, every
    record by one unit of its last digit; and whether a saddle is."""
    changes = []

    def changed(change):
        data = Data(name)
        change(data)
        changes.append(refused(data))

    def datum(data):
        x, y = data.rows[7]
        data.rows[7] = (x, y * (1 + fmpq(1, 10**6)))

    def last_digit(quantity):
        def change(data):
            record = data.records[quantity]
            value = exact(record["mid"]) + 2 * exact(record["rad"])
            record["mid"] = f"{value.p * 10**400 // value.q}e-400"

        return change

    def known(data):
        data.known["radius"] *= 1 + fmpq(1, 10**40)

    for change in [datum, known] + [last_digit(quantity) for quantity in Data(name).records]:
        changed(change)
    # A saddle is no minimum.
    changes.append(not all(pivot > 0 for pivot in cholesky(arb_mat([[1, 2], [2, 1]]), 2)))
    return changes


def main():
    ctx.prec = BITS
    names = sys.argv[1:] or sorted(os.path.basename(path)[:-5] for path in glob.glob(os.path.join(DATA, "fits", "*.toml")))
    total = failed = 0
    for name in names:
        begin = time.monotonic()
        data = Data(name)
        try:
            count, detached, ends = confirmed(data)
            total += count
            print(
                f"fit/{name}: {count} numbers of {len(data.rows)} rows, {detached} detached, {ends} at an end: a local minimum "
                f"({time.monotonic() - begin:.1f} s)"
            )
        except (ValueError, ZeroDivisionError) as error:
            failed += 1
            print(f"fit/{name}: NOT CONFIRMED: {error}")
    print(f"{total} numbers of {len(names) - failed} fits are confirmed, {failed} fits are not")
    changes = refusals("sphere1")
    print(f"{sum(changes)} of {len(changes)} changes of a fit are refused")
    return 1 if failed or not all(changes) else 0


if __name__ == "__main__":
    sys.exit(main())
