"""C(a) of a contact, in Arb, from the definitions (1.1) and (1.4) to (1.6) alone; what check_certificates.py computes with."""

import ast

from flint import acb, arb, ctx, fmpq

NAN = acb(float("nan"))
EQUAL = arb(2) ** -60  # of slopes: a jump of f' below it is none
EFFORT = 300, 5000  # parts of an integral over a ball of radii, and where 16 halvings of a cell did not help
ROUGH = 72  # bits of numbers of which the sign alone matters


class Refused(Exception):
    """Why a certificate is not accepted."""


def require(holds, why):
    if not holds:
        raise Refused(why)


# Numbers and formulas


def rational(text):
    """The rational number that a decimal or a fraction is."""
    if "/" in text:
        upper, lower = text.split("/")
        return rational(upper) / rational(lower)
    mantissa, _, exponent = text.lower().partition("e")
    require(abs(int(exponent or 0)) < 5000, f"the exponent of {text}")
    whole, _, fraction = mantissa.partition(".")
    scale = int(exponent or 0) - len(fraction)
    return fmpq(int(whole + fraction)) * fmpq(10) ** scale


def half_unit(text):
    """Half a unit in the last place of a decimal."""
    mantissa, _, exponent = text.lower().partition("e")
    return fmpq(10) ** (int(exponent or 0) - len(mantissa.partition(".")[2])) / 2


def hull(lower, upper):
    return arb(lower).union(arb(upper))


class Jet:
    """A Taylor polynomial c0 + c1 h + ..., as long as its list; `analytic` as acb.integral asks it."""

    def __init__(self, coefficients, analytic):
        self.c, self.analytic = coefficients, analytic

    def of(self, coefficients):
        return Jet(coefficients, self.analytic)

    def __add__(self, other):
        return self.of([x + y for x, y in zip(self.c, other.c)])

    def __neg__(self):
        return self.of([-x for x in self.c])

    def __sub__(self, other):
        return self + -other

    def __mul__(self, other):
        return self.of([sum((self.c[i] * other.c[k - i] for i in range(k + 1)), acb(0)) for k in range(len(self.c))])

    def __truediv__(self, other):
        quotient = []
        for k, x in enumerate(self.c):
            quotient.append((x - sum((quotient[i] * other.c[k - i] for i in range(k)), acb(0))) / other.c[0])
        return self.of(quotient)

    def constant(self, value):
        return self.of([acb(value)] + [acb(0)] * (len(self.c) - 1))

    def integrated(self, slope, value):
        """The function with this value and, times the slope of the argument, this derivative."""
        return self.of([value] + [sum((slope[i] * (k - i) * self.c[k - i] for i in range(k)), acb(0)) / k for k in range(1, len(self.c))])

    def power(self, exponent):
        if isinstance(exponent, fmpq) and exponent.q == 1 and abs(int(exponent.p)) <= 64:
            result, n = self.constant(1), abs(int(exponent.p))
            for _ in range(n):
                result = result * self
            return result if exponent >= 0 else self.constant(1) / result
        p = exponent if isinstance(exponent, Jet) else self.constant(exponent)
        return (p * self.ln()).exp()

    def exp(self):
        result = [self.c[0].exp()]
        for k in range(1, len(self.c)):
            result.append(sum((result[i] * (k - i) * self.c[k - i] for i in range(k)), acb(0)) / k)
        return self.of(result)

    def ln(self):
        return self.integrated((self.constant(1) / self).c, self.c[0].log(analytic=self.analytic))

    def sqrt(self):
        result = [self.c[0].sqrt(analytic=self.analytic)]
        for k in range(1, len(self.c)):
            rest = sum((result[i] * result[k - i] for i in range(1, k)), acb(0))
            result.append((self.c[k] - rest) / (2 * result[0]))
        return self.of(result)

    def log10(self):
        return self.ln() / self.constant(arb(10).log())

    def sinh(self):
        return (self.exp() - (-self).exp()) / self.constant(2)

    def cosh(self):
        return (self.exp() + (-self).exp()) / self.constant(2)

    def tanh(self):
        return self.sinh() / self.cosh()

    def circular(self):
        sine, cosine = [self.c[0].sin()], [self.c[0].cos()]
        for k in range(1, len(self.c)):
            weights = [(k - i) * self.c[k - i] / k for i in range(k)]
            sine_k = sum((x * w for x, w in zip(cosine, weights)), acb(0))
            cosine.append(-sum((x * w for x, w in zip(sine, weights)), acb(0)))
            sine.append(sine_k)
        return self.of(sine), self.of(cosine)

    def sin(self):
        return self.circular()[0]

    def cos(self):
        return self.circular()[1]

    def atanh(self):
        one = self.constant(1)
        return ((one + self).ln() - (one - self).ln()) / self.constant(2)

    def atan(self):
        i = self.constant(acb(0, 1))
        return (i * self).atanh() / i

    def asin(self):
        return (self / (self.constant(1) - self * self).sqrt()).atan()

    def acos(self):
        return self.constant(arb.pi() / 2) - self.asin()


OPERATORS = {ast.Add: Jet.__add__, ast.Sub: Jet.__sub__, ast.Mult: Jet.__mul__, ast.Div: Jet.__truediv__}
FUNCTIONS = "sqrt exp ln log10 sin cos atan asin acos sinh cosh tanh atanh".split()


class Formula:
    """f(r) with the values of its parameters. `side` says of each min, max and abs which argument holds."""

    def __init__(self, text, parameters):
        self.text = text.replace("^", "**")
        require(len(text) < 5000, "a formula that long")
        self.root = ast.parse(self.text, mode="eval").body
        self.parameters = {name: value if isinstance(value, fmpq) else Formula(value, {}) for name, value in parameters.items()}
        self.compiled = self.compile(self.root)
        self.switches = [node for node in ast.walk(self.root) if isinstance(node, ast.Call) and node.func.id in ("min", "max", "abs")]

    def __call__(self, r, side):
        return self.compiled(r, side)

    def compile(self, node):
        """The part of the formula as a function of r and of which argument holds where."""
        match node:
            case ast.BinOp(left, ast.Pow(), right):
                base, exact = self.compile(left), self.rational(right)
                exponent = self.compile(right) if exact is None else lambda r, side: exact
                return lambda r, side: base(r, side).power(exponent(r, side))
            case ast.BinOp(left, operator, right) if type(operator) in OPERATORS:
                act, left, right = OPERATORS[type(operator)], self.compile(left), self.compile(right)
                return lambda r, side: act(left(r, side), right(r, side))
            case ast.UnaryOp(ast.USub(), operand):
                operand = self.compile(operand)
                return lambda r, side: -operand(r, side)
            case ast.UnaryOp(ast.UAdd(), operand):
                return self.compile(operand)
            case ast.Call(ast.Name("abs"), [argument]):
                inner = self.compile(argument)
                return lambda r, side: inner(r, side) if side[node] else -inner(r, side)
            case ast.Call(ast.Name("min" | "max"), [first, second]):
                first, second = self.compile(first), self.compile(second)
                return lambda r, side: (first if side[node] else second)(r, side)
            case ast.Call(ast.Name(name), [argument]) if name in FUNCTIONS:
                inner = self.compile(argument)
                return lambda r, side: getattr(inner(r, side), name)()
            case ast.Name("r"):
                return lambda r, side: r
            case ast.Name("pi"):
                return lambda r, side: r.constant(arb.pi())
            case ast.Name(name) if name in self.parameters:
                known = self.parameters[name]
                return (lambda r, side: r.constant(known)) if isinstance(known, fmpq) else lambda r, side: known(r, {})
            case ast.Constant():
                number = self.rational(node)
                return lambda r, side: r.constant(number)
        raise Refused(f"a formula with {ast.unparse(node)}")

    def rational(self, node):
        """The rational number that a part of the formula is, where it is a number as it stands."""
        match node:
            case ast.Constant():
                return rational(ast.get_source_segment(self.text, node))
            case ast.UnaryOp(ast.USub(), operand):
                inner = self.rational(operand)
                return None if inner is None else -inner
            case ast.Name(name):
                known = self.parameters.get(name)
                return known if isinstance(known, fmpq) else None
            case ast.BinOp(left, ast.Div(), right):
                left, right = self.rational(left), self.rational(right)
                return None if left is None or not right else left / right
        return None

    def gap(self, node, r, side):
        """first - second of a min or max, the argument of an abs: positive where the first of a max holds."""
        arguments = [self.compile(argument)(r, side) for argument in node.args]
        return arguments[0] - arguments[1] if len(arguments) == 2 else arguments[0]


# The contact


class Contact:
    """C(a), by the definitions. A radius belongs to a piece of the profile, between two kinks."""

    def __init__(self, given):
        number = lambda key: arb(rational(given[key]))
        self.terms = [
            Formula(term["f"], {name: rational(value) if set(value) <= set("0123456789.eE+-/") else value for name, value in term["parameters"].items()})
            for term in given["profile"]
        ]
        self.control = given["control"]
        require(self.control in ("indentation", "force", "machine"), "the control")
        self.given, self.number = given, number
        self.edge = rational(given["edge"]) if given.get("edge") else None
        self.law, self.factors = self.power_law(), {}
        self.effort = EFFORT[0]
        self.far = 2 * rational(given["range"][1])
        self.breaks, self.sides = self.pieces()

    e = property(lambda self: self.number("e_star"))
    w = property(lambda self: self.number("work_of_adhesion"))
    k = property(lambda self: self.number("stiffness"))

    def power_law(self):
        """n and C of f = C r^n, the only profile with an exponent that is not computed with in Taylor series."""
        if [term.text for term in self.terms] != ["C*r**n"]:
            return None
        return self.terms[0].parameters["n"], self.terms[0].parameters["C"]

    def pieces(self):
        """The radii where an argument of min, max or abs takes over, and which one holds between them."""
        breaks = []
        for term in self.terms:
            for node in term.switches:
                require(not any(inner in term.switches for part in node.args for inner in ast.walk(part)), "min within max")
                gap = lambda r, order=1, node=node, term=term: term.gap(node, Jet([acb(r), acb(1)][:order] if order == 1 else [acb(r), acb(1)], False), {}).c
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

    def piece(self, x):
        """The piece that holds all of a ball; `None` where a kink lies in it."""
        index = sum(1 for b in self.breaks if b < x)
        return index if all(b > x for b in self.breaks[index:]) else None

    def heights(self, r, order, piece, analytic=False):
        """f and its derivatives at r, as Taylor coefficients, in a piece."""
        jet = Jet([acb(r), acb(1)] + [acb(0)] * (order - 1), analytic)
        values = [term(jet, side) for term, side in zip(self.terms, self.sides[piece])]
        return [sum((value.c[k] for value in values), acb(0)) for k in range(order + 1)]

    def limits(self, b, x):
        """The least and the largest angle t at which r = x sin t passes a kink b <= x."""
        angles = []
        for radius in (arb(x.upper()), arb(x.lower())):
            root = (radius * radius - b * b).nonnegative_part()
            angles.append(arb.atan2(b, root.sqrt()) if radius > b else hull(arb.atan2(b, root.sqrt()), arb.pi() / 2))
        return arb(angles[0].lower()), arb(angles[1].upper())

    def integral(self, x, piece, order, f):
        """int f(taylor coefficients at x sin t, r, t) dt over a quarter turn, by parts between kinks."""
        quarter = arb.pi() / 2
        ends = [(arb(0), arb(0))] + [self.limits(b, x) for b in self.breaks[:piece]] + [(quarter, quarter)]
        # Over a ball of radii, as good as the ball.
        wide = ctx.prec <= ROUGH or not x.rad() < abs(x.mid()) * arb(2) ** (-ctx.prec // 2)
        bits, limit = (24, self.effort) if wide else (ctx.prec - 40, 20000)
        total = arb(0)
        for index, ((_, lower), (upper, _)) in enumerate(zip(ends, ends[1:])):

            def integrand(t, analytic, index=index):
                r = acb(x) * t.sin()
                return f(self.heights(r, order, index, analytic), r, t)

            if lower < upper and not integrand(acb(hull(lower, upper)), False) == 0:
                size = self.size(x, arb(((lower + upper) / 2).mid()).sin(), order, index)
                require(size.is_finite(), "an integrand without a bound")
                tolerance = arb(2) ** -bits
                part = acb.integral(integrand, acb(lower), acb(upper), rel_tol=tolerance, abs_tol=size * tolerance, eval_limit=limit)
                require(part.is_finite(), "an integral does not converge")
                total += part.real
            # Where a limit lies is open between two angles.
            for open_end in ends[max(index, 1):min(index, piece - 1) + 2]:
                strip = hull(open_end[0], open_end[1].min(quarter))
                total += hull(0, open_end[1] - open_end[0]) * integrand(acb(strip), False).real
        return total

    def size(self, x, sine, order, piece):
        """The size of f^(k) r^(k - 1) at a radius, for integrals that may vanish."""
        r = arb((x * sine).mid())
        c = self.heights(r, order, piece)
        return sum((c[k].abs_upper() * r ** (k - 1) for k in range(1, order + 1)), arb(0)) / r ** max(order - 2, 0)

    def g(self, x, piece):
        if self.law:
            return self.factor() * arb(self.law[1]) * x ** arb(self.law[0])
        return x * self.integral(x, piece, 1, lambda c, r, t: c[1])

    def factor(self):
        """g(1) for f = r^n, once for each precision: n int sin^(n-1), whose exponent rises by 2 with the factor (n + 1)/n when it is integrated by parts."""
        if ctx.prec in self.factors:
            return self.factors[ctx.prec]
        n, result = self.law[0], arb(self.law[0])
        while n < 9:
            result, n = result * arb((n + 1) / n), n + 2
        power = arb(n - 1)

        def integrand(t, analytic):
            sine = t.sin()
            if not sine.contains(0):
                return (power * sine.log(analytic=analytic)).exp()
            return NAN if analytic else acb(hull(0, sine.abs_upper() ** power), hull(-1, 1) * sine.abs_upper() ** power)

        self.factors[ctx.prec] = result * acb.integral(integrand, 0, acb.pi() / 2, eval_limit=100000).real
        return self.factors[ctx.prec]

    def mean(self, x, piece):
        """int_0^x g."""
        if self.law:
            return self.g(x, piece) * x / arb(self.law[0] + 1)
        return x * x * self.integral(x, piece, 1, lambda c, r, t: c[1] * t.cos() ** 2)

    def slope(self, x, piece, root=None):
        """g', or times root = sqrt(x^2 - b^2) of the nearest kink b, where it has a limit."""
        if self.law:
            n = arb(self.law[0])
            return n * self.factor() * arb(self.law[1]) * x ** (n - 1)
        total = self.integral(x, piece, 2, lambda c, r, t: c[1] + 2 * r * c[2]) * (1 if root is None else root)
        for index, b in enumerate(self.breaks[:piece]):
            jump = self.jump(index)
            if jump is None:
                continue
            if root is not None and index == piece - 1:
                total += jump * b
            else:
                total += jump * b / (x * x - b * b).sqrt() * (1 if root is None else root)
        return total

    def jump(self, index):
        """Of f' at a kink; None where there is none."""
        b = self.breaks[index]
        before, after = (self.heights(b, 1, piece)[1].real for piece in (index, index + 1))
        jump = after - before
        size = abs(before) + abs(after)
        return None if abs(jump) <= size * EQUAL or (size.contains(0) and size < EQUAL) else jump

    def curvature(self, x, piece):
        """g''."""
        if self.law:
            n = arb(self.law[0])
            return n * (n - 1) * self.factor() * arb(self.law[1]) * x ** (n - 2)
        total = self.integral(x, piece, 3, lambda c, r, t: t.sin() * (4 * c[2] + 6 * r * c[3]))
        for index, b in enumerate(self.breaks[:piece]):
            below, above = (self.heights(b, 2, side) for side in (index, index + 1))
            root = (x * x - b * b).sqrt()
            bent = (above[1] + 2 * b * above[2] - below[1] - 2 * b * below[2]).real
            total += bent * b / (x * root)
            if (jump := self.jump(index)) is not None:
                total -= jump * b * x / root**3
        return total

    # d' = g' - dl' and F' = 2 E* (a d' + d - g) = 2 E* (a d' - dl), with dl = 2 a dl'. So C' is positive times
    # turning = sqrt(a) g' - (1 + 2 share) s, with s = sqrt(a) dl' and the share of F in C'.

    def share(self, a):
        if self.control == "machine":
            machine = 2 * self.e * a / self.k
            return machine / (1 + machine)
        return arb(1 if self.control == "force" else 0)

    def turning(self, a, piece, root=None):
        """Has the sign of C'; times a root, see slope."""
        s = (arb.pi() * self.w / (2 * self.e)).sqrt()
        if self.law and a.contains(0):
            # sqrt(a) g' is a power of a: from 0 if it is positive, from infinity if it is negative.
            power, end = self.law[0] - fmpq(1, 2), arb(a.upper())
            require(power != 0, "n = 1/2")
            if power < 0 and a == 0:
                return arb.pos_inf()
            value = arb(self.law[0]) * self.factor() * arb(self.law[1]) * end ** arb(power) if end > 0 else arb(0)
            if power > 0:
                return hull(0, value) - (1 + 2 * self.share(a)) * s
            least = value - (1 + 2 * self.share(a)) * s
            require(least > 0, "a sign that the lower bound leaves open")
            return least
        return a.nonnegative_part().sqrt() * self.slope(a, piece, root) - (1 + 2 * self.share(a)) * s * (1 if root is None else root)

    def turning_slope(self, a, piece):
        """The derivative of turning."""
        value = a.sqrt() * self.curvature(a, piece) + self.slope(a, piece) / (2 * a.sqrt())
        if self.control == "machine":
            s = (arb.pi() * self.w / (2 * self.e)).sqrt()
            value -= 2 * s * (2 * self.e / self.k) / (1 + 2 * self.e * a / self.k) ** 2
        return value

    def controlled_slope(self, a, piece):
        """C'."""
        factor = {"indentation": arb(1), "force": 2 * self.e * a}.get(self.control)
        factor = 1 + 2 * self.e * a / self.k if factor is None else factor
        return factor * self.turning(a, piece) / a.sqrt()

    def state(self, a, piece):
        """d and F."""
        d = self.g(a, piece) - (2 * arb.pi() * a * self.w / self.e).sqrt()
        return d, 2 * self.e * (a * d - self.mean(a, piece))

    def controlled(self, d, force):
        return {"indentation": d, "force": force}.get(self.control) if self.control != "machine" else d + force / self.k

    def at(self, a, piece):
        """C(a)."""
        if self.control == "indentation":
            return self.g(a, piece) - (2 * arb.pi() * a * self.w / self.e).sqrt()
        return self.controlled(*self.state(a, piece))


def bisected(f, lower, upper):
    """The zero of a monotone function between two points where it has opposite signs."""
    rising = bool(f(lower) < 0)
    for _ in range(2 * ctx.prec):
        middle = arb(((lower + upper) / 2).mid())
        value = f(middle)
        if value.contains(0):
            break
        lower, upper = (middle, upper) if bool(value < 0) == rising else (lower, middle)
    return hull(lower, upper)
