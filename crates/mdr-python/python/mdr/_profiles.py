"""Profiles f(r): what is pressed. Names and parameters are those of scenes."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from types import MappingProxyType
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from ._errors import DomainError, SceneError
from ._media import Medium
from ._numbers import Floats, Number, array, double, exact, plain, positive, row, shaped

# How complaints call the parameters; those that are not here by their name.
_QUANTITIES = {
    "n": "the exponent n",
    "c": "the coefficient C",
    "radius": "the radius R",
    "slope": "the slope tan θ",
    "amplitude": "the amplitude A",
    "wavelength": "the wavelength λ",
}

# The least number of rows of a measured profile.
_ROWS = 4

Files = dict[str, bytes]


@dataclass(frozen=True)
class Profile:
    """A profile: immutable, hashable, to be pickled; equal to another of the same kind and parameters.

    Parameters are exact as typed (``int``, ``float``, ``str``, ``Decimal``, ``Fraction``), in SI units; a ``str`` may have a unit, ``"5 um"``. Heights f count from the tip,
    outward: f(0) = 0.
    """

    kind: ClassVar[str] = ""

    def __post_init__(self) -> None:
        if not self.kind:
            raise TypeError("a profile is one of the kinds, such as Paraboloid")
        for name, value in self.parameters.items():
            object.__setattr__(self, name, plain(value))
            if name == "amplitude":  # waves may begin with a trough
                double(value, name)
            else:
                positive(value, name, _QUANTITIES.get(name, f"the {name}"))

    @property
    def parameters(self) -> Mapping[str, Number]:
        """The numbers of the profile by their names, as given."""
        return MappingProxyType({field.name: getattr(self, field.name) for field in fields(self)})

    def _scene(self, files: Files) -> dict[str, Any]:
        """The table ``[profile]`` of a scene; what is no number goes to ``files``."""
        return {"kind": self.kind, **{name: exact(value, name) for name, value in self.parameters.items()}}

    def _transform(self, x: ArrayLike, part: int) -> Floats:
        from ._contact import core_of

        values, shape = array(x, "x")
        result: Floats = shaped(core_of(self, 1, 1).transform(values)[part], shape)
        return result

    def g(self, x: ArrayLike) -> Floats:
        """The MDR transform g(x) of the profile, in m, of the shape of x; NaN outside of the profile.

        Examples
        --------
        >>> import mdr
        >>> mdr.Paraboloid(radius=2).g([1, 2]).tolist()
        [0.5, 2.0]
        """
        return self._transform(x, 0)

    def g_slope(self, x: ArrayLike) -> Floats:
        """g'(x), of the shape of x; NaN outside of the profile."""
        return self._transform(x, 1)

    def integral(self, x: ArrayLike) -> Floats:
        """The integral of g from 0 to x, in m², of the shape of x; NaN outside of the profile."""
        return self._transform(x, 2)

    def __add__(self, other: Profile) -> Sum:
        if not isinstance(other, Profile):
            return NotImplemented
        return Sum((*_terms(self), *_terms(other)))


@dataclass(frozen=True)
class PowerLaw(Profile):
    """f = ``C*r^n`` with C = ``c``, in m^(1−n)."""

    kind: ClassVar[str] = "power"
    n: Number
    c: Number


@dataclass(frozen=True)
class Paraboloid(Profile):
    """f = ``r^2/(2*R)``, what the JKR theory calls a sphere."""

    kind: ClassVar[str] = "paraboloid"
    radius: Number


@dataclass(frozen=True)
class Cone(Profile):
    """f = ``t*r``; the slope t is tan θ of the flank against the plane of contact."""

    kind: ClassVar[str] = "cone"
    slope: Number


@dataclass(frozen=True)
class Sphere(Profile):
    """f = ``R - sqrt(R^2 - r^2)``, the true sphere. JKR's is a :class:`Paraboloid`."""

    kind: ClassVar[str] = "sphere"
    radius: Number


@dataclass(frozen=True)
class Ellipsoid(Profile):
    """f = ``h*(1 - sqrt(1 - r^2/b^2))``, half axes ``lateral`` b in the plane of contact and ``height`` h across it."""

    kind: ClassVar[str] = "ellipsoid"
    lateral: Number
    height: Number


@dataclass(frozen=True)
class FlatPunch(Profile):
    """A flat face, f = ``0``, with a vertical edge."""

    kind: ClassVar[str] = "flat-punch"
    radius: Number


@dataclass(frozen=True)
class TruncatedCone(Profile):
    """A cone with a flat face of radius ``flat`` b instead of its tip: f = ``t*max(r - b, 0)``."""

    kind: ClassVar[str] = "truncated-cone"
    slope: Number
    flat: Number


@dataclass(frozen=True)
class TruncatedParaboloid(Profile):
    """A paraboloid with a flat face of radius ``flat`` b instead of its tip: f = ``max(r^2 - b^2, 0)/(2*R)``."""

    kind: ClassVar[str] = "truncated-paraboloid"
    radius: Number
    flat: Number


@dataclass(frozen=True)
class ConeParabolicCap(Profile):
    """A cone that a paraboloid caps up to the radius ``cap`` b, with one slope where they meet.

    f = ``t*min(r, b)^2/(2*b) + t*max(r - b, 0)``.
    """

    kind: ClassVar[str] = "cone-parabolic-cap"
    slope: Number
    cap: Number


@dataclass(frozen=True)
class ConeSphericalCap(Profile):
    """A cone that a sphere of ``radius`` R caps, with one slope where they meet.

    f = ``R - sqrt(R^2 - min(r, R*t/sqrt(1 + t^2))^2) + t*max(r - R*t/sqrt(1 + t^2), 0)``.
    """

    kind: ClassVar[str] = "cone-spherical-cap"
    slope: Number
    radius: Number


@dataclass(frozen=True)
class Hyperboloid(Profile):
    """f = ``t*(sqrt(r^2 + b^2) - b)``: asymptote of slope t, half axis ``lateral`` b in the plane of contact."""

    kind: ClassVar[str] = "hyperboloid"
    slope: Number
    lateral: Number


@dataclass(frozen=True)
class RoundedPunch(Profile):
    """A flat face of radius ``flat`` b with a parabolic rounding around it: f = ``max(r - b, 0)^2/(2*R)``."""

    kind: ClassVar[str] = "rounded-punch"
    radius: Number
    flat: Number


@dataclass(frozen=True)
class DisplacedParaboloid(Profile):
    """A parabola with its vertex, a ridge, at the distance ``offset`` b from the axis.

    f = ``(r^2 - 2*b*r)/(2*R)``: heights count from the tip, and the ridge is b²/2R below it.
    """

    kind: ClassVar[str] = "displaced-paraboloid"
    radius: Number
    offset: Number


@dataclass(frozen=True)
class ParabolicDimple(Profile):
    """A parabolic dimple in a flat face: f = ``-h*min(r, b)^2/b^2``.

    Heights count from the tip, and the face is h below it.
    """

    kind: ClassVar[str] = "parabolic-dimple"
    depth: Number
    radius: Number


@dataclass(frozen=True)
class EllipticalDimple(Profile):
    """An elliptical dimple in a flat face: f = ``h*(sqrt(1 - min(r, b)^2/b^2) - 1)``.

    Heights count from the tip, and the face is h below it. Heights are known up to b, where g is −∞.
    """

    kind: ClassVar[str] = "elliptical-dimple"
    depth: Number
    radius: Number


@dataclass(frozen=True)
class WavyParaboloid(Profile):
    """f = ``r^2/(2*R) + A*(1 - cos(2*pi*r/L))``, figure 4 of the paper; the amplitude A may be negative."""

    kind: ClassVar[str] = "wavy-paraboloid"
    radius: Number
    amplitude: Number
    wavelength: Number


@dataclass(frozen=True)
class Wave(Profile):
    """f = ``h*(1 - cos(2*pi*x/L))`` with the ``amplitude`` h, half of peak to valley, on a :class:`Periodic` medium, which has the
    wavelength L (Johnson 1995)."""

    kind: ClassVar[str] = "wave"
    amplitude: Number

    def __post_init__(self) -> None:
        super().__post_init__()
        positive(self.amplitude, "amplitude", "the amplitude h")


@dataclass(frozen=True)
class Sum(Profile):
    """The sum of several profiles; ``one + other`` makes it.

    Examples
    --------
    >>> import mdr
    >>> mdr.Paraboloid(radius=1) + mdr.Cone(slope="0.01")
    Sum(terms=(Paraboloid(radius=1), Cone(slope='0.01')))
    """

    kind: ClassVar[str] = "sum"
    terms: tuple[Profile, ...]

    def __post_init__(self) -> None:
        if not self.terms:
            raise TypeError("a sum has one term at least")

    @property
    def parameters(self) -> Mapping[str, Number]:
        """None: they are those of the terms."""
        return MappingProxyType({})

    def _scene(self, files: Files) -> dict[str, Any]:
        return {"kind": self.kind, "term": [term._scene(files) for term in self.terms]}


def _terms(profile: Profile) -> tuple[Profile, ...]:
    return profile.terms if isinstance(profile, Sum) else (profile,)


@dataclass(frozen=True, init=False)
class Expression(Profile):
    """A formula in ``r`` with f(0) = 0; what other names it has are given by keyword.

    Examples
    --------
    >>> import mdr
    >>> lens = mdr.Expression("r^2/(2*R) + r^4/(8*H^3)", R=1, H="1/2")
    >>> round(float(lens.g(0.3)), 12)  # x²/R + x⁴/3H³
    0.1116
    """

    kind: ClassVar[str] = "expression"
    formula: str
    values: tuple[tuple[str, Number], ...]

    def __init__(self, formula: str, **parameters: Number) -> None:
        object.__setattr__(self, "formula", formula)
        object.__setattr__(self, "values", tuple(sorted(parameters.items())))
        for name, value in parameters.items():
            double(value, name, "parameters")

    @property
    def parameters(self) -> Mapping[str, Number]:
        """The values of the names in the formula."""
        return MappingProxyType(dict(self.values))

    def _scene(self, files: Files) -> dict[str, Any]:
        values = {name: exact(value, name, "parameters") for name, value in self.values}
        return {"kind": self.kind, "formula": self.formula, "parameters": values}

    def __reduce__(self) -> tuple[Any, ...]:
        return _expression, (self.formula, dict(self.values))

    def __repr__(self) -> str:
        return ", ".join([f"Expression({self.formula!r}", *(f"{name}={value!r}" for name, value in self.values)]) + ")"


def _expression(formula: str, values: dict[str, Number]) -> Expression:
    return Expression(formula, **values)


@dataclass(frozen=True, init=False, repr=False)
class Table(Profile):
    """A measured profile: at least four rows of ascending radii and of heights from the tip. What is none is refused with its
    row.

    Parameters
    ----------
    r, f : array_like
        Radii and heights in m.
    offset : Number, optional
        The height of the tip among the rows, subtracted from each.
    smooth : Number, optional
        A length in m over which the rows are smoothed.

    Notes
    -----
    Noise of the rows becomes rings that adhere: see "Noise" in the documentation of scenes before drawing conclusions from
    rows that are not smooth.
    """

    kind: ClassVar[str] = "table"
    csv: str
    offset: Number | None = None
    smooth: Number | None = None
    _name: str = field(default="", compare=False)

    def __init__(
        self, r: ArrayLike, f: ArrayLike, *, offset: Number | None = None, smooth: Number | None = None
    ) -> None:
        radii, heights = row(r, "r"), row(f, "f")
        if radii.shape != heights.shape:
            raise ValueError(f"r and f differ in length: {len(radii)} and {len(heights)}")
        _check_rows(radii, heights, has_tip=offset is not None or smooth is not None)
        rows = zip(radii.tolist(), heights.tolist())
        self._set("r,f\n" + "".join(f"{one!r},{other!r}\n" for one, other in rows), offset, smooth)

    def _set(self, csv: str, offset: Number | None, smooth: Number | None) -> None:
        name = f"rows-{hashlib.sha256(csv.encode()).hexdigest()[:12]}.csv"
        for key, value in {"csv": csv, "offset": offset, "smooth": smooth, "_name": name}.items():
            object.__setattr__(self, key, value)

    @classmethod
    def read_csv(
        cls, path: str | os.PathLike[str], *, offset: Number | None = None, smooth: Number | None = None
    ) -> Table:
        """Reads radii and heights from a file, in m or in the units of a row below its header, such as ``nm,nm``."""
        with open(path, encoding="utf-8") as file:
            return _table(file.read(), offset, smooth)

    @property
    def parameters(self) -> Mapping[str, Number]:
        """The offset and the length of smoothing, where they are given."""
        given = {"offset": self.offset, "smooth": self.smooth}
        return MappingProxyType({name: value for name, value in given.items() if value is not None})

    def _scene(self, files: Files) -> dict[str, Any]:
        files[self._name] = self.csv.encode()
        numbers = {name: exact(value, name) for name, value in self.parameters.items()}
        return {"kind": self.kind, "file": self._name, **numbers}

    def __reduce__(self) -> tuple[Any, ...]:
        return _table, (self.csv, self.offset, self.smooth)

    def __repr__(self) -> str:
        return f"<Table of {self.csv.count(chr(10)) - 1} rows>"


def _check_rows(radii: Floats, heights: Floats, has_tip: bool) -> None:
    """Refuses what is no measured profile, by the first row at fault; rows count from 0, as those of an array.

    `has_tip` says that the height of the tip is given, or that of the smooth rows.
    """
    if len(radii) < _ROWS:
        requirement = f"{_ROWS} or more"
        raise DomainError(f"the rows of r and f must be {requirement}, got {len(radii)}", "rows", str(len(radii)), requirement)
    rising = np.empty(len(radii), dtype=bool)
    rising[0], rising[1:] = radii[0] >= 0, radii[1:] > radii[:-1]
    good = np.isfinite(radii) & np.isfinite(heights) & rising
    if good.all():
        if radii[0] == 0 and heights[0] != 0 and not has_tip:
            requirement = "zero at the tip, r[0] = 0, unless there is an offset"
            message = f"f[0] must be {requirement}, got {heights[0]}: offset={heights[0]} subtracts it from every height"
            raise DomainError(message, "f[0]", str(heights[0]), requirement)
        return
    at = int(np.argmin(good))
    for name, column in (("r", radii), ("f", heights)):
        if not np.isfinite(column[at]):
            message = f"{name}[{at}] must be finite, got {column[at]}: leave out rows that were not measured"
            raise DomainError(message, f"{name}[{at}]", str(column[at]), "finite")
    requirement = "zero or positive" if at == 0 else f"larger than r[{at - 1}] = {radii[at - 1]}"
    raise DomainError(f"r[{at}] must be {requirement}, got {radii[at]}", f"r[{at}]", str(radii[at]), requirement)


def _table(csv: str, offset: Number | None, smooth: Number | None) -> Table:
    table = Table.__new__(Table)
    table._set(csv, offset, smooth)
    return table


def scene_text(scene: Any, files: Files) -> str:
    """A scene as JSON; one that is nested deeper than Python follows is refused as a deep file is."""
    try:
        return json.dumps(scene_of(scene, files))
    except RecursionError:
        message = "the scene is nested deeper than 64 levels of tables and lists; a sum may have all its terms in one list"
        raise SceneError(message, None, None, "the scene") from None


def scene_of(value: Any, files: Files, key: str = "the scene") -> Any:
    """A scene of plain values: profiles and media become tables, numbers stay as typed. What is masked is refused with its key."""
    if isinstance(value, Profile):
        return value._scene(files)
    if isinstance(value, Medium):
        return value._scene()
    if isinstance(value, Mapping):
        return {str(name): scene_of(item, files, str(name)) for name, item in value.items()}
    if isinstance(value, (list, tuple)) or hasattr(value, "tolist") and getattr(value, "ndim", 0) > 0:
        return [scene_of(item, files, key) for item in value]
    if value is np.ma.masked:
        raise TypeError(f"{key}: a value is masked; leave it out")
    if value is None or isinstance(value, (bool, str, int)):
        return value
    return exact(value, key)


__all__ = [
    "Cone", "ConeParabolicCap", "ConeSphericalCap", "DisplacedParaboloid", "Ellipsoid", "EllipticalDimple",
    "Expression", "FlatPunch", "Hyperboloid", "Paraboloid", "ParabolicDimple", "PowerLaw", "Profile", "RoundedPunch",
    "Sphere", "Sum", "Table", "TruncatedCone", "TruncatedParaboloid", "Wave", "WavyParaboloid",
]
