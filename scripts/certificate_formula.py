"""Numbers, Taylor series and formulas of certificates, in Arb; what check_certificates.py computes with."""

import ast

from flint import acb, arb, ctx, fmpq

NAN = acb(float("nan"))
ROUGH = 72  # bits of numbers of which the sign alone matters


class Refused(Exception):
    """Why a certificate is not accepted."""


def require(holds, why):
    if not holds:
        raise Refused(why)


# Numbers and formulas


def parts(text):
    """The mantissa of a decimal as a whole number, and its power of ten."""
    mantissa, _, exponent = text.lower().partition("e")
    whole, _, fraction = mantissa.partition(".")
    return int(whole + fraction), int(exponent or 0) - len(fraction)


def power_of_ten(exponent):
    """Exactly, or where that has too many digits a ball."""
    return fmpq(10) ** exponent if abs(exponent) < 5000 else arb(10) ** exponent


def rational(text):
    """The rational number that a decimal or a fraction is; a ball of one with thousands of digits."""
    if "/" in text:
        upper, lower = text.split("/")
        return rational(upper) / rational(lower)
    whole, exponent = parts(text)
    return whole * power_of_ten(exponent)


def half_unit(text):
    """Half a unit in the last place of a decimal; 0 has none."""
    whole, exponent = parts(text)
    return power_of_ten(exponent) / 2 if whole else fmpq(0)


def shown(number):
    """For a message."""
    return arb(number).str(9, radius=False)


def hull(lower, upper):
    return arb(lower).union(arb(upper))


def letter_of(value):
    return "+" if value > 0 else "-" if value < 0 else None


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
        root = (self.constant(1) - self * self).sqrt()
        return self.integrated((self.constant(1) / root).c, self.c[0].asin() if root.c[0].is_finite() else NAN)

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
