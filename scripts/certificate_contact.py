"""C(a) of a contact, in Arb, from the definitions of certificate_media.py alone; what check_certificates.py computes with."""

from flint import acb, arb, fmpq

from certificate_formula import Jet, hull, letter_of, rational, require
from certificate_media import at, medium_of, over
from certificate_transform import Transform


class Contact:
    """C(a), and its derivative times positive factors."""

    def __init__(self, given):
        self.given, self.control = given, given["control"]
        require(self.control in ("indentation", "force", "machine"), "the control")
        self.medium = medium_of(given)
        require(self.medium.has_depth or self.control == "force", "a depth, which a line contact without a reference has not")
        self.k = arb(rational(given["stiffness"])) if self.control == "machine" else None
        require(self.k is None or self.k > 0, "a stiffness that is not positive")
        self.edge = rational(given["edge"]) if given.get("edge") else None
        self.transform = Transform(given, self.medium)
        self.breaks = self.transform.radii

    law = property(lambda self: self.transform.law)

    def piece(self, a):
        """The piece that holds all of a ball; `None` where a kink lies in it."""
        require(a < self.transform.far, "a radius far beyond the range")
        index = sum(1 for b in self.breaks if b < a)
        return index if all(b > a for b in self.breaks[index:]) else None

    # C' is positive times turning = scale * T' - level, where T is the transform of the medium.

    def share(self, x):
        """Of F in C': S/(K + S)."""
        if self.control != "machine":
            return x.constant(1 if self.control == "force" else 0)
        one = x.constant(1)
        return one - one / (one + self.medium.stiffness(x) / x.constant(self.k))

    def share_over(self, x):
        return over(self.share, x) if self.control == "machine" else arb(1 if self.control == "force" else 0)

    def course(self):
        """u or d where turning is a rising or a falling power of a and a constant on all radii, + where that constant is 0; else None."""
        threshold = self.medium.threshold
        if not self.law or threshold is None or self.law[0] == threshold or self.control == "machine":
            return None
        if self.law[0] < threshold:
            return "d"
        return "+" if threshold == 0 and self.control == "indentation" else "u"

    def turning(self, a, piece, relieved=False):
        """Has the sign of C'; `relieved` beside a kink at the lower end of a ball, times a root: see Transform.slope."""
        medium, x = self.medium, self.medium.size(a)
        level = medium.level(x, self.share_over(x))
        if self.law and a.contains(0):
            return self.near_tip(x, level)
        relief = self.transform.relief(piece, x.upper()) if relieved else None
        if relief is not None:
            x = hull(self.transform.breaks[piece - 1].lower(), x.upper())
            level *= relief
        elif x.contains(0):
            # The root of a ball that begins at 0.
            return medium.scale_from_tip(x) * self.transform.slope(x.nonnegative_part(), piece) - level
        return at(medium.scale, x) * self.transform.slope(x, piece, relief) - level

    def sign_at_tip(self, upper):
        """Of turning between 0 and a radius, where k = 1, so that both of its parts are 0 at 0 but under a dead load: turning/a is
        g' - 2 s share/a, of which the first derivative that is not 0 at 0 has a sign on the whole ball. None where it stays open."""
        if self.medium.tip() == 0 or self.control == "force" or (piece := self.piece(hull(0, upper))) is None:
            return None
        if self.law:
            return self.sign_of_law(upper)
        for order in range(4):
            ends = []
            for a in (arb(0), hull(0, upper)):
                x = Jet([acb(a), acb(1)][: order + 1] + [acb(0)] * (order - 1), False)
                c = self.transform.heights(a, order + 1, piece)
                turning = x.of([(n + 1) * c[n + 1] for n in range(order + 1)])
                if self.control == "machine":
                    stiffness = self.medium.stiffness(x.constant(1))
                    springs = x * x * stiffness + x.constant(self.k)
                    turning = turning - x * stiffness * x.constant(2 * self.medium.s) / springs
                ends.append(turning.c[order].real)
            if letter := letter_of(ends[1]):
                return letter
            if not ends[0] == 0:
                return None
        return None

    def sign_of_law(self, upper):
        """Of turning, n C a^(n - 1) - 2 s S/(a (K + S)), which is a power of a times a difference that is least or largest at the end."""
        n, c = (arb(number) for number in self.law)
        springs = at(self.medium.stiffness, arb(1))
        if n < 2:
            return "+" if n * c > 2 * self.medium.s * springs * arb(upper) ** (2 - n) / self.k else None
        falls = n * c * arb(upper) ** (n - 2) * (self.k + springs * arb(upper) ** 2) < 2 * self.medium.s * springs
        return "-" if falls else None

    def near_tip(self, x, level):
        """turning of a power law: a power of a, from 0 if it is positive, from infinity if it is negative, less the level."""
        transform, n = self.transform, self.law[0]
        power, end = n - 1 + self.medium.scale_order, arb(x.upper())
        require(power != 0, "the power of a power law at its threshold")
        if power < 0 and x == 0:
            return arb.pos_inf()
        value = arb(n) * transform.factor() * arb(self.law[1]) * end ** arb(power) if end > 0 else arb(0)
        if power > 0:
            return hull(0, value) - level
        require(value - level > 0, "a sign that the lower bound leaves open")
        return value - level

    def turning_slope(self, a, piece):
        """The derivative of turning."""
        x = self.medium.size(a)
        jet = Jet([acb(x), acb(1)], False)
        scale = self.medium.scale(jet).c
        value = scale[0].real * self.transform.curvature(x, piece) + scale[1].real * self.transform.slope(x, piece)
        return (value - self.medium.level_slope(x, self.share(jet))) * self.medium.size_slope(a)

    def controlled_slope(self, a, piece):
        """C'."""
        x = self.medium.size(a)
        stiffness = at(self.medium.stiffness, x)
        factor = {"indentation": arb(1), "force": stiffness}.get(self.control)
        factor = 1 + stiffness / self.k if factor is None else factor
        return factor * self.medium.stretch(x) * self.turning(a, piece) / at(self.medium.scale, x) * self.medium.size_slope(a)

    def state(self, a, piece):
        """d and F; d is None where there is no depth."""
        return self.medium.state(self.medium.size(a), self.transform, piece)

    def sizes(self, a):
        """Of a, d and F."""
        return (a, *self.medium.sizes(self.medium.size(a)))

    def controlled(self, d, force):
        return {"indentation": d, "force": force}.get(self.control) if self.control != "machine" else d + force / self.k

    def at(self, a, piece):
        """C(a)."""
        return self.controlled(*self.state(a, piece))

    def at_tip(self):
        """C as a falls to 0."""
        return arb(0) if self.control == "force" else -self.medium.tip()

    def at_edge(self, value):
        """The contact held at the vertical edge b, F = S (d - mean), with d or F or D given."""
        b, piece = arb(self.edge), len(self.breaks)
        x = self.medium.size(b)
        mean, stiffness = self.medium.mean(x, self.transform, piece), at(self.medium.stiffness, x)
        if self.control == "force":
            return b, (mean + value / stiffness if self.medium.has_depth else None, value)
        d = value if self.control == "indentation" else (value + stiffness * mean / self.k) / (1 + stiffness / self.k)
        return b, (d, stiffness * (d - mean))
