"""The transform of a profile with the weight of a medium, and its derivatives, in Arb, for certificate_contact.py.

On every medium it is one integral over the heights f, with the weight W = sin^j t cos^k t of the medium:

    T(x) = x int f'(x sin t) W(t) dt  over a quarter turn, r = x sin t

T' and T'' are that integral differentiated: int (f' + r f'') W dt and int sin t (2 f'' + r f''') W dt. Where f' or f'' jumps at
r = b, the lower limit arcsin(b/x) of a part contributes. t = pi/2 - v^m takes the root out of cos^k t dt where k is no whole
number. All integrals are rigorous.
"""

import ast

from flint import acb, arb, ctx, fmpq

from certificate_formula import NAN, ROUGH, Formula, Jet, bisected, hull, rational, require

EFFORT = 300, 5000  # parts of an integral over a ball of radii, and where 16 halvings of a cell did not help
EQUAL = arb(2) ** -60  # of slopes: a jump of f' below it is none


class Weight:
    """sin^j t cos^k t dt with t = pi/2 - v^m."""

    def __init__(self, j, k):
        self.j, self.k = j, fmpq(k)
        self.whole = self.k.q == 1 and self.k >= 0
        short = self.k.q <= 16
        self.m = 1 if self.whole else int(self.k.q) if short else int((9 / (1 + self.k)).ceil())
        # Of v in cos^k t dt: whole if m is the denominator of k.
        self.order = self.m * (1 + self.k) - 1

    def place(self, t):
        """v, which falls from t = 0 to 0 at the quarter turn."""
        rest = (arb.pi() / 2 - t).nonnegative_part()
        if self.m == 1:
            return rest
        lower, upper = (arb(end).nonnegative_part() ** arb(fmpq(1, self.m)) for end in (rest.lower(), rest.upper()))
        return hull(lower, upper)

    def at(self, v, analytic):
        """sin t, and the weight times dt/dv."""
        rest = v if self.m == 1 else v**self.m
        sine = rest.cos()
        value = acb(self.m) * sine**self.j
        if self.whole:
            return sine, value * rest.sin() ** int(self.k.p)
        if self.order.q == 1:
            value *= v ** int(self.order.p)
        elif not v.contains(0):
            value *= (arb(self.order) * v.log(analytic=analytic)).exp()
        else:
            largest = v.abs_upper() ** arb(self.order)
            value *= NAN if analytic else acb(hull(-1, 1) * largest, hull(-1, 1) * largest)
        return sine, value * (arb(self.k) * rest.sinc().log(analytic=analytic)).exp()


def quarter_turn(p, q):
    """int sin^p cos^q, whose exponents rise by 2 with the factors (p + q + 2)/(p + 1) and (p + q + 2)/(q + 1) by parts."""
    factor, p, q = arb(1), fmpq(p), fmpq(q)
    while p < 8:
        factor, p = factor * arb((p + q + 2) / (p + 1)), p + 2
    while q < 8 and q != 0:
        factor, q = factor * arb((p + q + 2) / (q + 1)), q + 2

    def integrand(t, analytic):
        value = acb(1)
        for base, exponent in ((t.sin(), arb(p)), (t.cos(), arb(q))):
            if exponent == 0:
                continue
            if not base.contains(0):
                value *= (exponent * base.log(analytic=analytic)).exp()
            elif analytic:
                return NAN
            else:
                largest = base.abs_upper() ** exponent
                value *= acb(hull(-1, 1) * largest, hull(-1, 1) * largest)
        return value

    return factor * acb.integral(integrand, 0, acb.pi() / 2, eval_limit=100000).real


class Transform:
    """T of the terms of a profile. A radius belongs to a piece of it, between two kinks."""

    def __init__(self, given, medium):
        exact = set("0123456789.eE+-/")
        self.terms = [
            Formula(term["f"], {name: rational(value) if set(value) <= exact else value for name, value in term["parameters"].items()})
            for term in given["profile"]
        ]
        self.medium, self.weight = medium, Weight(*medium.weight)
        self.law, self.wave, self.factors = self.power_law(), self.amplitude(), {}
        self.effort = EFFORT[0]
        # No radius is looked at beyond it.
        self.far = 2 * rational(given["range"][1])
        self.far = medium.outer if medium.outer is not None and medium.outer < self.far else self.far
        # Kinks as radii, and as arguments of T.
        self.radii, self.sides = self.pieces()
        self.breaks = [medium.size(b) for b in self.radii]

    def power_law(self):
        """n and C of f = C r^n, the only profile with an exponent that is not computed with in Taylor series."""
        if [term.text for term in self.terms] != ["C*r**n"] or not self.medium.has_laws:
            return None
        n, c = (self.terms[0].parameters[name] for name in "nC")
        return (n, c) if n > 0 and c > 0 else None

    def amplitude(self):
        """h of a wave of the period of the medium: with the sine y of its argument it is 2 h y^2, without a term that cancels as y nears 1."""
        if [term.text for term in self.terms] != ["h*(1 - cos(2*pi*r/l))"]:
            return None
        h, period = (self.terms[0].parameters[name] for name in "hl")
        return h if self.medium.period == period else None

    def pieces(self):
        """The radii where an argument of min, max or abs takes over, and which one holds between them."""
        breaks = []
        for term in self.terms:
            for node in term.switches:
                require(not any(inner in term.switches for part in node.args for inner in ast.walk(part)), "min within max")
                gap = lambda r, order=1, node=node, term=term: term.gap(node, Jet([acb(r), acb(1)][:order], False), {}).c
                breaks += self.zeros(gap)
        breaks.sort(key=lambda b: float(b.mid()))
        distinct = [b for i, b in enumerate(breaks) if i == 0 or not b.overlaps(breaks[i - 1])]
        ends = [arb(0)] + distinct + [arb(self.far)]
        sides = []
        for lower, upper in zip(ends, ends[1:]):
            middle = Jet([acb((lower.mid() + upper.mid()) / 2)], False)
            sides.append([])
            for term in self.terms:
                holds = {}
                for node in term.switches:
                    gap = term.gap(node, middle, {}).c[0].real
                    require(not gap.contains(0), "which argument of a max holds")
                    holds[node] = bool(gap > 0) != (node.func.id == "min")
                sides[-1].append(holds)
        return distinct, sides

    def zeros(self, gap):
        """All zeros of a smooth function on (0, far], each simple; one at 0 itself is no kink."""
        found, open_cells = [], [(arb(0), arb(self.far), 0)]
        while open_cells:
            lower, upper, depth = open_cells.pop()
            value, slope = (part.real for part in gap(hull(lower, upper), 2))
            if not value.contains(0):
                continue
            require(depth < 400, "the kinks of the formula")
            if not slope.contains(0):
                ends = [gap(lower)[0].real, gap(upper)[0].real]
                if ends[0] * ends[1] < 0:
                    found.append(bisected(lambda r: gap(r)[0].real, lower, upper))
                    continue
                if ends[0] * ends[1] > 0 or lower == 0 and not ends[1].contains(0):
                    continue
            middle = arb(((lower * 0.4375 + upper * 0.5625)).mid())
            open_cells += [(lower, middle, depth + 1), (middle, upper, depth + 1)]
        return found

    def heights(self, x, order, piece, analytic=False):
        """f and its derivatives in the argument of T, as Taylor coefficients, in a piece."""
        jet = Jet([acb(x), acb(1)] + [acb(0)] * (order - 1), analytic)
        if self.wave:
            return (jet * jet * jet.constant(2 * self.wave)).c
        jet = self.medium.radius(jet)
        values = [term(jet, side) for term, side in zip(self.terms, self.sides[piece])]
        return [sum((value.c[k] for value in values), acb(0)) for k in range(order + 1)]

    def limits(self, b, x):
        """The least and the largest angle t at which x sin t passes a kink b <= x."""
        angles = []
        for radius in (arb(x.upper()), arb(x.lower())):
            root = (radius * radius - b * b).nonnegative_part()
            angles.append(arb.atan2(b, root.sqrt()) if radius > b else hull(arb.atan2(b, root.sqrt()), arb.pi() / 2))
        return arb(angles[0].lower()), arb(angles[1].upper())

    def integral(self, x, piece, order, f, weight=None, unit=1):
        """int f(taylor coefficients at r = x sin t, r, sin t) W dt over a quarter turn, by parts between kinks; f is about `unit` f'."""
        quarter, weight = arb.pi() / 2, weight or self.weight
        ends = [(arb(0), arb(0))] + [self.limits(b, x) for b in self.breaks[:piece]] + [(quarter, quarter)]
        # Over a ball of radii, as good as the ball.
        wide = ctx.prec <= ROUGH or not x.rad() < abs(x.mid()) * arb(2) ** (-ctx.prec // 2)
        bits, limit = (24, self.effort) if wide else (ctx.prec - 40, 20000)
        total = arb(0)
        for index, ((_, lower), (upper, _)) in enumerate(zip(ends, ends[1:])):

            def integrand(v, analytic, index=index):
                sine, density = weight.at(v, analytic)
                r = acb(x) * sine
                return f(self.heights(r, order, index, analytic), r, sine) * density

            first, last = weight.place(lower), arb(0) if index == piece else weight.place(upper)
            if lower < upper and not integrand(acb(hull(first, last)), False) == 0:
                size = self.size(x, arb(((lower + upper) / 2).mid()).sin(), order, index) * unit
                require(size.is_finite(), "an integrand without a bound")
                tolerance = arb(2) ** -bits
                part = acb.integral(integrand, acb(last), acb(first), rel_tol=tolerance, abs_tol=size * tolerance, eval_limit=limit)
                require(part.is_finite(), "an integral does not converge")
                total += part.real
            # Where a limit lies is open between two angles.
            for open_end in ends[max(index, 1):min(index, piece - 1) + 2]:
                first, last = weight.place(open_end[0]), weight.place(open_end[1].min(quarter))
                total += hull(0, first - last) * integrand(acb(hull(first, last)), False).real
        return total

    def size(self, x, sine, order, piece):
        """The size of f^(k) r^(k - 1) at a radius, for integrals that may vanish."""
        r = arb((x * sine).mid())
        c = self.heights(r, order, piece)
        return sum((c[k].abs_upper() * r ** (k - 1) for k in range(1, order + 1)), arb(0)) / r ** max(order - 2, 0)

    def value(self, x, piece):
        """T."""
        if self.law:
            return self.factor() * arb(self.law[1]) * x ** arb(self.law[0])
        return x * self.integral(x, piece, 1, lambda c, r, sine: c[1])

    def factor(self):
        """T(1) for f = r^n, once for each precision: n int sin^(n - 1 + j) cos^k."""
        if ctx.prec not in self.factors:
            n, (j, k) = self.law[0], self.medium.weight
            self.factors[ctx.prec] = arb(n) * quarter_turn(n - 1 + j, k)
        return self.factors[ctx.prec]

    def kernel(self, x, b):
        """b W/sqrt(x^2 - b^2) at the angle of a kink, times (x^2 - b^2)^((1 - k)/2)."""
        j, k = self.medium.weight
        return b ** (1 + j) * x ** -arb(j + k)

    def slope(self, x, piece, relief=None):
        """T', or times `relief` = (x^2 - b^2)^((1 - k)/2) of the nearest kink b, where it has a limit."""
        if self.law:
            n = arb(self.law[0])
            return n * self.factor() * arb(self.law[1]) * x ** (n - 1)
        total = self.integral(x, piece, 2, lambda c, r, sine: c[1] + 2 * r * c[2]) * (1 if relief is None else relief)
        power = arb((self.weight.k - 1) / 2)
        for index, b in enumerate(self.breaks[:piece]):
            jump = self.jump(index)
            if jump is None:
                continue
            if relief is not None and index == piece - 1:
                total += jump * self.kernel(x, b)
            else:
                total += jump * self.kernel(x, b) * (x * x - b * b) ** power * (1 if relief is None else relief)
        return total

    def relief(self, piece, upper):
        """(x^2 - b^2)^((1 - k)/2) between the last kink b of a piece and an x above; None where f' does not jump there."""
        if self.jump(piece - 1) is None or self.weight.k == 1:
            return None
        return hull(0, (arb(upper) ** 2 - self.breaks[piece - 1] ** 2).nonnegative_part() ** arb((1 - self.weight.k) / 2))

    def jump(self, index):
        """Of f' at a kink; None where there is none."""
        b = self.breaks[index]
        before, after = (self.heights(b, 1, piece)[1].real for piece in (index, index + 1))
        jump = after - before
        size = abs(before) + abs(after)
        return None if abs(jump) <= size * EQUAL or (size.contains(0) and size < EQUAL) else jump

    def curvature(self, x, piece):
        """T''."""
        if self.law:
            n = arb(self.law[0])
            return n * (n - 1) * self.factor() * arb(self.law[1]) * x ** (n - 2)
        total = self.integral(x, piece, 3, lambda c, r, sine: sine * (4 * c[2] + 6 * r * c[3]))
        j, k = self.medium.weight
        for index, b in enumerate(self.breaks[:piece]):
            below, above = (self.heights(b, 2, side) for side in (index, index + 1))
            square = x * x - b * b
            kernel = self.kernel(x, b) * square ** arb((self.weight.k - 1) / 2)
            bent = (above[1] + 2 * b * above[2] - below[1] - 2 * b * below[2]).real
            total += bent * kernel / x
            if (jump := self.jump(index)) is not None:
                total += jump * kernel * (arb(k - 1) * x / square - arb(j + k) / x)
        return total
