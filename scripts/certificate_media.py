"""The media of certificates: what each is, and what follows from its definitions, in Arb, for certificate_contact.py.

A contact of size a is given by its stiffness S(a), its area A(a) and the depth g(a) without adhesion; its springs S'(x) dx carry

    dl(a) = sqrt(2 w A'/S')        d = g(a) - dl(a)        F = int_0^a S'(x) (d - g(x)) dx = S (d - mean of g)

A solid of revolution has A = pi a^2, and on a half-space graded as E ~ z^k, with k = 0 the homogeneous one and c = E*,

    S = 2 c a^(1+k)/(1 + k)        g(x) = x int f'(x sin t) cos^k t dt        dl = sqrt(2 pi w a^(1-k)/c)

over a quarter turn. A Winkler foundation has S = pi K a^2 and g = f: k = 1, c = pi K. The mean of g, in the other order of
integration, is (1 + k) a^-(1+k) int_0^a x^k g dx = a int f'(a sin t) cos^(2+k) t dt.

A line contact of half-width b has the force per length F = E* N without adhesion, N(b) = b int f'(b sin t) sin t dt, and
dF = S dg. Its springs at the edge release 2 w per length: S dl = E* sqrt(2 pi w b/E*). Against a point of the surface at the
distance L, E*/S = (2/pi) arcosh(L/b); without one there is no depth, and S = E*. The mean g - F/S = (2/pi) int N(c) L/(c sqrt(L^2 - c^2)) dc
is, in the other order of integration and by parts, (2/pi) int f(b sin t) p/(cos^2 t + p^2 sin^2 t) dt with p = sqrt(1 - b^2/L^2).

One strip a period, of half-width a: with y = sin(pi a/lambda) for the size and sin(pi r/lambda) for the radius all of that is the
line contact once more, N = (1/lambda) y int f'(y sin t) sin t dt per area, with p = 1, E*/S = -(2 lambda/pi) ln y, and, of
A' = 2/lambda, S dl = E* sqrt(2 w tan(pi a/lambda)/(lambda E*)).
"""

from flint import acb, arb, fmpq

from certificate_formula import Jet, hull, rational, require
from certificate_transform import Weight

KEYS = {"half-space": [], "graded": ["exponent", "coefficient"], "winkler": ["modulus"], "plane": ["reference"], "periodic": ["wavelength"]}


def medium_of(given):
    """The medium of a certificate; without one it is a half-space."""
    words = given.get("medium", {"kind": "half-space"})
    kind = words.get("kind")
    require(kind in KEYS, f"the medium {kind}")
    optional = kind == "plane" and len(words) == 1
    require(optional or set(words) == {"kind", *KEYS[kind]}, f"the numbers of a medium {kind}")
    require(("e_star" in given) == (kind not in ("graded", "winkler")), f"the modulus of a medium {kind}")
    numbers = {key: rational(words[key]) for key in KEYS[kind] if key in words}
    require(all(number > 0 for key, number in numbers.items() if key != "exponent"), "a number of the medium that is not positive")
    work = rational(given["work_of_adhesion"])
    if kind == "plane":
        return Plane(rational(given["e_star"]), work, numbers.get("reference"))
    if kind == "periodic":
        return Periodic(rational(given["e_star"]), work, numbers["wavelength"])
    if kind == "winkler":
        return Solid(numbers["modulus"], fmpq(1), work, arb.pi())
    exponent = numbers.get("exponent", fmpq(0))
    require(-1 < exponent < 1, f"the exponent {exponent} of a graded medium")
    return Solid(numbers["coefficient"] if kind == "graded" else rational(given["e_star"]), exponent, work)


def at(f, x):
    """A function of Taylor series at a point."""
    return f(Jet([acb(x)], False)).c[0].real


def over(f, x):
    """A function that rises from 0 at x = 0, over a ball."""
    ends = [arb(end) for end in (x.lower(), x.upper())]
    lower, upper = (at(f, end) if end > 0 else arb(0) for end in ends)
    return hull(lower, upper)


class Solid:
    """A half-space graded as E ~ z^k, or a Winkler foundation with k = 1; c is a rational number times a factor."""

    has_depth, has_laws, period, outer = True, True, None, None

    def __init__(self, c, k, work, factor=1):
        self.k, self.c = k, arb(c) * factor
        self.weight = 0, k
        self.mean_weight = Weight(0, k + 2)
        self.s = (2 * arb.pi() * arb(work) / self.c).sqrt()
        # A power law with this exponent has a scaled g' that is constant.
        self.threshold = (1 - k) / 2

    def size(self, a):
        return a

    def size_slope(self, a):
        return arb(1)

    def radius(self, x):
        return x

    def stiffness(self, x):
        return x.power(1 + self.k) * x.constant(2 * self.c / arb(1 + self.k))

    def elongation(self, x):
        return self.s * x ** arb((1 - self.k) / 2)

    def stretch(self, x):
        """d' per the derivative of g - dl."""
        return arb(1)

    def state(self, x, transform, piece):
        """d and F."""
        d = transform.value(x, piece) - self.elongation(x)
        return d, at(self.stiffness, x) * (d - self.mean(x, transform, piece))

    def sizes(self, x):
        """Of d and F, to tell a zero from."""
        return self.elongation(x), at(self.stiffness, x) * self.elongation(x)

    def tip(self):
        """dl(0)."""
        return self.s if self.k == 1 else arb(0)

    # d' = g' - dl' and F' = S (d' - S' dl/S), with dl' = (1 - k)/2 dl/a and S'/S = (1 + k)/a. So C' has the sign of g' less
    # ((1 - k)/2 + (1 + k) share) dl/a, with the share S/(K + S) of F in C', times a^((1+k)/2), which dl/a is divided by.

    scale_order = property(lambda self: (1 + self.k) / 2)

    def scale(self, x):
        """What g' is multiplied by."""
        return x.power(self.scale_order)

    def scale_from_tip(self, x):
        """The same over a ball that begins at 0."""
        return over(self.scale, x)

    def level(self, x, share):
        return self.s * (arb((1 - self.k) / 2) + arb(1 + self.k) * share)

    def level_slope(self, x, share):
        return self.s * arb(1 + self.k) * share.c[1].real

    def mean(self, x, transform, piece):
        """The mean of g over the springs."""
        if transform.law:
            return transform.value(x, piece) * arb((1 + self.k) / (transform.law[0] + 1 + self.k))
        return x * transform.integral(x, piece, 1, lambda c, r, sine: c[1], self.mean_weight)


class Strip:
    """What line contacts have in common: T is N, and d and dl are forces over S."""

    weight, flat, threshold = (1, 0), Weight(0, 0), None

    # g' = N' E*/S and dl = D/S with S dl = D. So C' has the sign of N' - D' + (1 - share) (S'/S) D, the share being S/(K + S).
    # D' = D/2x times a factor, by which the scale of N' is divided; S' x/S is the order q of S, in the same way.

    def level(self, x, share):
        q = over(self.order, x) if self.has_depth else arb(0)
        return self.s * (1 - 2 * q * (1 - share))

    def level_slope(self, x, share):
        if not self.has_depth:
            return arb(0)
        q = self.order(Jet([acb(x), acb(1)], False)).c
        return -2 * self.s * (q[1] * (1 - share.c[0]) - q[0] * share.c[1]).real

    def mean(self, x, transform, piece):
        """g - F/S, as a mean of the heights."""
        if not self.has_depth:
            return arb(0)
        p = self.ratio(x)
        density = lambda square: 2 * p / (acb.pi() * (1 - (1 - p * p) * square))
        if transform.law:
            return self.mean_of_law(x, transform.law, density)
        start = transform.heights(0, 1, 0)[0]
        return transform.integral(x, piece, 1, lambda c, r, sine: (c[0] - start) * density(sine * sine), self.flat, x)

    def mean_of_law(self, x, law, density):
        """With sin t and cos t in the place of each other."""
        n, c = law
        powers = Weight(0, n)

        def integrand(v, analytic):
            sine, power = powers.at(v, analytic)
            return power * density(1 - sine * sine)

        return arb(c) * x ** arb(n) * acb.integral(integrand, 0, acb(powers.place(arb(0))), eval_limit=100000).real

    def stretch(self, x):
        """d' per the derivative of N - D/E*: E*/S."""
        return self.e / at(self.stiffness, x)

    def state(self, x, transform, piece):
        """d and F."""
        force = self.e * (transform.value(x, piece) * self.unit - self.elongation(x))
        return force / at(self.stiffness, x) + self.mean(x, transform, piece) if self.has_depth else None, force

    def sizes(self, x):
        """Of d and F, to tell a zero from."""
        return self.stretch(x) * self.elongation(x), self.e * self.elongation(x)

    def tip(self):
        return arb(0)


class Plane(Strip):
    """A half-plane, with a point of its surface to measure the depth from or without."""

    has_laws, unit, period = True, 1, None

    def __init__(self, e, work, reference):
        self.e, self.reference, self.outer = arb(e), reference, reference
        self.has_depth = reference is not None
        self.s = (arb.pi() * arb(work) / (2 * self.e)).sqrt()
        if not self.has_depth:
            self.threshold = fmpq(1, 2)

    def size(self, a):
        require(self.reference is None or a < self.reference, "a half-width beyond the reference of the depth")
        return a

    def size_slope(self, a):
        return arb(1)

    def radius(self, x):
        return x

    scale_order = fmpq(1, 2)

    def scale(self, x):
        return x.sqrt()

    def scale_from_tip(self, x):
        return over(self.scale, x)

    def ratio(self, x):
        return (1 - (x / self.reference) ** 2).sqrt()

    def arcosh(self, x):
        """arcosh(L/b)."""
        ratio = x.constant(self.reference) / x
        return (ratio + (ratio * ratio - x.constant(1)).sqrt()).ln()

    def stiffness(self, x):
        if not self.has_depth:
            return x.constant(self.e)
        return x.constant(arb.pi() * self.e / 2) / self.arcosh(x)

    def order(self, x):
        """q."""
        share = x / x.constant(self.reference)
        return x.constant(1) / (self.arcosh(x) * (x.constant(1) - share * share).sqrt())

    def elongation(self, x):
        """D/E*."""
        return 2 * self.s * x.sqrt()


class Periodic(Strip):
    """One strip a period; x is y = sin(pi a/lambda)."""

    has_depth, has_laws = True, False

    def __init__(self, e, work, wavelength):
        self.e, self.wavelength = arb(e), arb(wavelength)
        self.unit, self.period, self.outer = 1 / self.wavelength, wavelength, wavelength / 2
        self.s = (arb(work) / (2 * self.wavelength * self.e)).sqrt()

    def size(self, a):
        require(2 * a < self.wavelength, "a half-width of half of the wavelength or more")
        return (arb.pi() * a / self.wavelength).sin()

    def size_slope(self, a):
        turn = arb.pi() / self.wavelength
        return turn * (turn * a).cos()

    def radius(self, x):
        return x.asin() * x.constant(self.wavelength / arb.pi())

    scale_order = None

    def scale(self, x):
        """With D'/D = 1/(2 y (1 - y^2)); the factor 1/lambda of N, too."""
        rest = x.constant(1) - x * x
        return (x * rest.power(fmpq(5, 2))).sqrt() * x.constant(self.unit)

    def scale_from_tip(self, x):
        """It rises no further than to y = 1/sqrt(6)."""
        return over(Jet.sqrt, x) * (1 - x * x) ** arb(fmpq(5, 4)) * self.unit

    def ratio(self, x):
        return arb(1)

    def stiffness(self, x):
        return x.constant(-arb.pi() * self.e / (2 * self.wavelength)) / x.ln()

    def order(self, x):
        """q, times the factor of D': -(1 - y^2)/ln y, which rises to 2."""
        return (x * x - x.constant(1)) / x.ln()

    def elongation(self, x):
        return 2 * self.s * (x / (1 - x * x).sqrt()).sqrt()
