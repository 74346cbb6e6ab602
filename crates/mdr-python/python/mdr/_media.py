"""Elastic media: what a profile is pressed into. Names and parameters are those of scenes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from types import MappingProxyType
from typing import Any, ClassVar

from ._errors import DomainError
from ._numbers import Number, double, exact, plain, positive

# The units of the parameters, by keys of their own where the name alone does not tell.
_UNITS = {"coefficient": "medium.coefficient", "reference": "medium.length", "flaw": "medium.length", "modulus": "medium.modulus"}


@dataclass(frozen=True)
class Medium:
    """An elastic medium: immutable, hashable, to be pickled; without one a contact is that with a homogeneous half-space.

    Parameters are exact as typed (``int``, ``float``, ``str``, ``Decimal``, ``Fraction``), in SI units; a ``str`` may have a unit.
    """

    kind: ClassVar[str] = ""
    _own_modulus: ClassVar[bool] = False

    def __post_init__(self) -> None:
        if not self.kind:
            raise TypeError("a medium is one of the kinds, such as Winkler")
        for name, value in self.parameters.items():
            object.__setattr__(self, name, plain(value))
            self._check(name, value)

    def _check(self, name: str, value: Number) -> None:
        positive(value, name, f"the {name} of the medium", self._unit(name))

    def _unit(self, name: str) -> str:
        return _UNITS.get(name, name)

    @property
    def parameters(self) -> Mapping[str, Number]:
        """The numbers of the medium by their names, as given."""
        given = {field.name: getattr(self, field.name) for field in fields(self)}
        return MappingProxyType({name: value for name, value in given.items() if value is not None})

    def _scene(self) -> dict[str, Any]:
        """The table ``[medium]`` of a scene."""
        numbers = {name: exact(value, name, self._unit(name)) for name, value in self.parameters.items()}
        return {"kind": self.kind, **numbers}


@dataclass(frozen=True)
class Graded(Medium):
    """A half-space whose modulus is a power of the depth, E ∝ zᵏ with k = ``exponent`` within (−1, 1).

    How stiff it is say either ``coefficient`` c, in N/m^(2+k), of the stiffness 2c a^(1+k)/(1+k) of a contact; or Young's modulus
    ``modulus`` at the depth ``depth`` and Poisson's ratio ``nu``. E* of the contact is of no use.

    Examples
    --------
    >>> import mdr
    >>> soil = mdr.Graded(exponent="0.3", coefficient=1)
    >>> ball = mdr.Contact(mdr.Paraboloid(radius=1), medium=soil, work_of_adhesion="1/100")
    >>> round(ball.folds("force")[0].force, 12)  # −(3 + k)/2 πwR
    -0.051836278784
    """

    kind: ClassVar[str] = "graded"
    _own_modulus: ClassVar[bool] = True
    exponent: Number
    coefficient: Number | None = None
    modulus: Number | None = None
    nu: Number | None = None
    depth: Number | None = None

    def __post_init__(self) -> None:
        by_depth = [self.modulus, self.nu, self.depth]
        if self.coefficient is None and None in by_depth or self.coefficient is not None and by_depth != [None] * 3:
            raise TypeError("a graded medium has either its coefficient, or modulus, nu and depth")
        super().__post_init__()

    def _check(self, name: str, value: Number) -> None:
        if name == "nu":
            double(value, name)
        elif name != "exponent":
            super()._check(name, value)
        elif not -1 < double(value, name) < 1:
            requirement = "within (-1, 1)"
            message = f"the exponent k must be {requirement}, got {value}; for k = 1 take Winkler(modulus=c/pi)"
            raise DomainError(message, "the exponent k", str(value), requirement)


@dataclass(frozen=True)
class Winkler(Medium):
    """A foundation of springs that do not act on one another, of ``modulus`` K_w in Pa/m. E* of the contact is of no use."""

    kind: ClassVar[str] = "winkler"
    _own_modulus: ClassVar[bool] = True
    modulus: Number

    def _unit(self, name: str) -> str:
        return "medium.foundation"


@dataclass(frozen=True)
class Plane(Medium):
    """A half-plane in line contact with the profile f(\\|x\\|); forces are per length, in N/m, and contact radii half-widths.

    Depths are measured against the point of the surface at the distance ``reference`` L, in m; without one they are NaN, and the
    force has to be controlled.
    """

    kind: ClassVar[str] = "plane"
    reference: Number | None = None


@dataclass(frozen=True)
class Periodic(Medium):
    """A half-plane in contact along one strip in each period ``wavelength`` λ, in m; forces are per area, in Pa, and contact radii
    half-widths. The profile is :class:`Wave` or a periodic :class:`Expression`. A complete contact opens from a ``flaw`` in the
    troughs, half as wide as given, in m: the notes of a path say when.

    Examples
    --------
    Johnson's wave: pull-off, and the jump into complete contact.

    >>> import mdr
    >>> wave = mdr.Contact(mdr.Wave(amplitude=1), medium=mdr.Periodic(wavelength=1), e_star=1, work_of_adhesion="0.4")
    >>> [fold.kind for fold in wave.folds("force")]
    ['minimum', 'maximum']
    """

    kind: ClassVar[str] = "periodic"
    wavelength: Number
    flaw: Number | None = None


__all__ = ["Graded", "Medium", "Periodic", "Plane", "Winkler"]
