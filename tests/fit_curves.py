"""The curves of fits over balls of Arb, for confirm_fits.py: truncated power series, profiles, and what is observed of a contact."""

from flint import acb, arb


class Series:
    """A number with its first and second derivatives in some variables; of the second ones the lower triangle."""

    def __init__(self, value, first, second):
        self.value, self.first, self.second = value, first, second

    @classmethod
    def constant(cls, value, count):
        zero = arb(0)
        return cls(arb(value), [zero] * count, [[zero] * (i + 1) for i in range(count)])

    @classmethod
    def variable(cls, value, place, count):
        one = cls.constant(value, count)
        one.first = [arb(int(index == place)) for index in range(count)]
        return one

    def bend(self, i, j):
        return self.second[max(i, j)][min(i, j)]

    def of(self, value, slope, bend):
        """A function of this number, by its value and its two derivatives there."""
        first = [slope * one for one in self.first]
        curved = [bend * one for one in self.first]
        second = [
            [slope * one + curved[i] * self.first[j] for j, one in enumerate(row)] for i, row in enumerate(self.second)
        ]
        return Series(value, first, second)

    def lifted(self, other):
        return other if isinstance(other, Series) else Series.constant(other, len(self.first))

    def combined(self, other, sign):
        first = [one + sign * two for one, two in zip(self.first, other.first)]
        second = [[one + sign * two for one, two in zip(*rows)] for rows in zip(self.second, other.second)]
        return Series(self.value + sign * other.value, first, second)

    def scaled(self, factor):
        return Series(
            self.value * factor, [one * factor for one in self.first], [[x * factor for x in row] for row in self.second]
        )

    def __add__(self, other):
        if not isinstance(other, Series):
            return Series(self.value + other, self.first, self.second)
        return self.combined(other, 1)

    def __sub__(self, other):
        if not isinstance(other, Series):
            return Series(self.value - other, self.first, self.second)
        return self.combined(other, -1)

    def __mul__(self, other):
        if not isinstance(other, Series):
            return self.scaled(other)
        u, v = self.value, other.value
        first = [one * v + u * two for one, two in zip(self.first, other.first)]
        second = [
            [
                one * v + self.first[i] * other.first[j] + self.first[j] * other.first[i] + u * two
                for j, (one, two) in enumerate(zip(*rows))
            ]
            for i, rows in enumerate(zip(self.second, other.second))
        ]
        return Series(u * v, first, second)

    def __truediv__(self, other):
        if not isinstance(other, Series):
            return self.scaled(1 / arb(other))
        inverse = 1 / other.value
        return self * other.of(inverse, -(inverse**2), 2 * inverse**3)

    __radd__, __rmul__ = __add__, __mul__

    def __rsub__(self, other):
        return self.scaled(-1) + other

    def __pow__(self, exponent):
        power = self.value**exponent
        return self.of(power, exponent * power / self.value, exponent * (exponent - 1) * power / self.value**2)

    def sqrt(self):
        root = self.value.sqrt()
        return self.of(root, 1 / (2 * root), -1 / (4 * root * self.value))

    def atan(self):
        slope = 1 / (1 + self.value**2)
        return self.of(self.value.atan(), slope, -2 * self.value * slope**2)

    def atanh(self):
        slope = 1 / (1 - self.value**2)
        return self.of(((1 + self.value) / (1 - self.value)).log() / 2, slope, 2 * self.value * slope**2)

    def struve(self, order):
        """H0' = 2/pi - H1 and (z H1)' = z H0."""
        z, limit = self.value, 2 / arb.pi()
        h0, h1 = struve(0, z), struve(1, z)
        slope = h0 - h1 / z
        return self.of(h0, limit - h1, -slope) if order == 0 else self.of(h1, slope, limit - h1 - slope / z + h1 / z**2)


def struve(order, z):
    """H_0 and H_1 by their power series."""
    if isinstance(z, Series):
        return z.struve(order)
    square, factor = -z * z / 4, 2 / arb.pi()
    if order == 0:
        return z * factor * square.hypgeom([arb(1)], [arb(1.5), arb(1.5)])
    return z * z * (factor / 3) * square.hypgeom([arb(1)], [arb(1.5), arb(2.5)])


def kappa(n):
    return arb.pi().sqrt() * (1 + n / 2).gamma() / ((n + 1) / 2).gamma()


class Profile:
    """g and G by closed forms, and f' for their definition; `p` are the numbers of the profile, balls or series."""

    def __init__(self, kind, p):
        self.kind, self.p = kind, p

    def transform(self, x):
        """g and G, its integral from 0."""
        p, kind = self.p, self.kind
        if kind == "paraboloid":
            return x * x / p["radius"], x**3 / p["radius"] / 3
        if kind == "sphere":
            r = p["radius"]
            t = (x / r).atanh()
            return x * t, ((x * x - r * r) * t + r * x) / 2
        if kind == "cone":
            g = x * p["slope"] * (arb.pi() / 2)
            return g, g * x / 2
        if kind == "hyperboloid":
            b = p["lateral"]
            t = (x / b).atan()
            return x * t * p["slope"], ((x * x + b * b) * t - b * x) * p["slope"] / 2
        if kind in ("truncated-paraboloid", "rounded-punch"):
            b, r = p["flat"], p["radius"]
            u = (x * x - b * b).sqrt()
            if kind == "truncated-paraboloid":
                return x * u / r, u**3 / r / 3
            t = (u / b).atan()
            return x * (u - t * b) / r, (u**3 / 3 - (x * x * t - u * b) * b / 2) / r
        if kind == "power":
            g = x ** p["n"] * p["c"] * kappa(p["n"])
            return g, g * x / (p["n"] + 1)
        z = x / p["wavelength"] * (2 * arb.pi())
        wave = p["amplitude"] * (arb.pi() / 2)
        return x * x / p["radius"] + wave * z * struve(0, z), x**3 / p["radius"] / 3 + wave * x * struve(1, z)

    def height_slope(self, r, analytic):
        """f'(r), for complex balls; what is no number where an `analytic` function is asked for and a root has a branch."""
        p, kind = self.p, self.kind
        below = {"sphere": lambda: p["radius"] ** 2 - r * r, "hyperboloid": lambda: p["lateral"] ** 2 + r * r, "power": lambda: r}
        if analytic and kind in below and not below[kind]().real > 0:
            return acb("nan")
        if kind in ("paraboloid", "truncated-paraboloid"):
            return r / p["radius"]
        if kind == "sphere":
            return r / below[kind]().sqrt()
        if kind == "cone":
            return p["slope"] + 0 * r
        if kind == "hyperboloid":
            return p["slope"] * r / below[kind]().sqrt()
        if kind == "rounded-punch":
            return (r - p["flat"]) / p["radius"]
        if kind == "power":
            return p["c"] * p["n"] * r ** (p["n"] - 1)
        k = 2 * arb.pi() / p["wavelength"]
        return r / p["radius"] + p["amplitude"] * k * (k * r).sin()

    def check(self, x):
        """Both closed forms against the definition, g = x int f'(x sin t) dt and F/2E* of a rigid indenter by parts:
        G = int f'(r) sqrt(x^2 - r^2) dr."""
        b, half = self.p.get("flat", arb(0)), arb.pi() / 2
        start = (b / x).asin()
        width = half - start
        r = lambda t: x * (start + width * t).sin()
        integral = lambda f: acb.integral(f, 0, 1, rel_tol=arb(2) ** -120, abs_tol=arb(2) ** -400).real * width
        g = x * integral(lambda t, analytic: self.height_slope(r(t), analytic))
        total = integral(lambda t, analytic: self.height_slope(r(t), analytic) * (x * (start + width * t).cos()) ** 2)
        for own, other, name in zip(self.transform(x), (g, total), ("g", "G")):
            if not own.overlaps(other) or other.rel_accuracy_bits() < 90:
                raise ValueError(f"{name} of {self.kind} is not that of its definition: {own} and {other}")


class Curve:
    """X and Y of the contact of radius a."""

    def __init__(self, data, p):
        self.data, self.p = data, p
        self.profile = Profile(data.kind, p)

    def state(self, a):
        g, integral = self.profile.transform(a)
        self.dl = (a * self.p["work_of_adhesion"] / self.p["e_star"] * (2 * arb.pi())).sqrt()
        self.g, self.d = g, g - self.dl
        return self.d, (a * self.d - integral) * self.p["e_star"] * 2

    def observed(self, d, f):
        """X and Y of a depth and a force; of changes of both, without offsets."""
        kind = self.data.observation
        bent = f / self.p["stiffness"] if kind in ("F(D)", "delta(D)") else None
        return {
            "F(d)": lambda: (d, f),
            "F(D)": lambda: (d + bent, f),
            "delta(D)": lambda: (d + bent, bent),
            "d(F)": lambda: (f, d),
        }[kind]()

    def at(self, a):
        d, f = self.state(a)
        if self.data.observation == "F(a)":
            return a, f + self.p["baseline"]
        x, y = self.observed(d, f)
        along, across = ("baseline", "contact_point") if self.data.observation == "d(F)" else ("contact_point", "baseline")
        return x + self.p[along], y + self.p[across]

    def turning(self, a):
        """dX/da along a paraboloid on a depth or a machine, as a series: d' = 2a/R - dl/2a, F' = 2E*(a d' - dl)."""
        self.state(a)
        slope = a / self.p["radius"] * 2 - self.dl / a / 2
        return self.observed(slope, (a * slope - self.dl) * self.p["e_star"] * 2)[0]
