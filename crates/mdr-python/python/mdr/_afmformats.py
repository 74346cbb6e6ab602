"""Force curves of afmformats, nanite and PyJibe as arguments of fit."""

from __future__ import annotations

import importlib
from collections.abc import Iterator, Mapping, Sequence
from os import PathLike
from typing import Any, Literal, TypeAlias, final

import numpy as np

from ._numbers import Floats

AfmObservation: TypeAlias = Literal["F(D)", "delta(D)", "F(d)"]
Leg: TypeAlias = Literal["approach", "retract"]

# The numbers of afmformats for segments.
_SEGMENTS: dict[int, Leg] = {0: "approach", 1: "retract"}


@final
class AfmCurve(Mapping[str, Any]):
    """The answer of :func:`from_afmformats`: arguments of :func:`fit` as a mapping, ``fit(**curve, profile=…)``."""

    def __init__(self, arguments: dict[str, Any], stiffness: float | None, sensitivity: float | None) -> None:
        self._arguments = arguments
        self.stiffness = stiffness
        """The spring constant of the file in N/m."""
        self.sensitivity = sensitivity
        """The deflection sensitivity of the file in m/V; it is contained in the forces already."""

    def __getitem__(self, key: str) -> Any:
        return self._arguments[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._arguments)

    def __len__(self) -> int:
        return len(self._arguments)

    def __repr__(self) -> str:
        legs = self["leg"]
        counts = ", ".join(f"{legs.count(leg)} rows of {leg}" for leg in _SEGMENTS.values() if leg in legs)
        known = [f"{self.stiffness} N/m" if self.stiffness else "", f"{self.sensitivity} m/V" if self.sensitivity else ""]
        return f"<AfmCurve: {', '.join(filter(None, [self['observation'], counts, *known]))}>"


def from_afmformats(
    curve: Any,
    *,
    observation: AfmObservation | None = None,
    legs: Leg | Sequence[Leg] = ("approach", "retract"),
    stiffness: float | None = None,
    sensitivity: float | None = None,
    index: int | None = None,
) -> AfmCurve:
    """Reads a force curve by the package afmformats, which knows the files of many instruments.

    Heights and tip positions of afmformats fall as the tip goes down, depths and positions of :func:`fit` rise: x is their
    negative, up to the offset that ``"contact_point"`` is. Forces have the same sign in both.

    Parameters
    ----------
    curve : path, afmformats.AFMForceDistance or nanite.Indentation
        A file that afmformats can read (``pip install 'mdr-contact[afm]'``), or a curve that is read already.
    observation : {"F(D)", "delta(D)", "F(d)"}, optional
        ``"F(D)"``, against the height of the cantilever, which is free of the noise of the force, where there is a spring
        constant; else ``"F(d)"``, against the tip position. ``"delta(D)"`` is for a spring constant that is free or has a
        prior: the deflection is what was measured, whatever the spring constant.
    legs : {"approach", "retract"}, or a sequence of these
        The legs to be taken; pauses never are.
    stiffness, sensitivity : float, optional
        Spring constant in N/m and deflection sensitivity in m/V, where the file has none or wrong ones; for files only.
    index : int, optional
        Which curve of a file with several, from 0.

    Returns
    -------
    AfmCurve
        A mapping of ``x``, ``y``, ``observation``, ``leg``, and ``stiffness`` where the observation needs it.

    Raises
    ------
    ImportError
        A path is given and afmformats is not installed.
    ValueError
        A curve without force, height, or a spring constant that is needed; several curves and no ``index``; heights that rise
        on approach; a format of which afmformats takes no other ``stiffness``.

    Examples
    --------
    ``mdr.fit(**mdr.from_afmformats("curve.jpk-force"), profile=mdr.Paraboloid(radius=5e-6), free=[…])``

    >>> import mdr
    >>> class Curve(dict):  # has what a curve of afmformats has
    ...     modality, metadata = "force-distance", {"spring constant": 0.05, "sensitivity": 6e-8}
    >>> height = [2e-6, 1e-6, 0.0, 1e-6, 2e-6]
    >>> force = [0.0, 0.0, 1e-8, -1e-9, 0.0]
    >>> given = mdr.from_afmformats(Curve({"force": force, "height (measured)": height, "segment": [0, 0, 0, 1, 1]}))
    >>> given
    <AfmCurve: F(D), 3 rows of approach, 2 rows of retract, 0.05 N/m, 6e-08 m/V>
    >>> given["x"].tolist()
    [-2e-06, -1e-06, -0.0, -1e-06, -2e-06]
    """
    if isinstance(curve, (str, PathLike)):
        curve = _load(curve, {"spring constant": stiffness, "sensitivity": sensitivity}, index)
    elif stiffness is not None or sensitivity is not None or index is not None:
        raise ValueError("stiffness, sensitivity and index are for a path: a curve that is read has its own")
    if curve.modality != "force-distance":
        raise ValueError(f"a force-distance curve is needed, not one of {curve.modality}")
    if "force" not in curve:
        raise ValueError("the curve has no column 'force': give the stiffness, and the sensitivity, with the path")
    k, gain = (_number(curve.metadata, key) for key in ("spring constant", "sensitivity"))
    force = _column(curve, "force")
    if observation is None:
        observation = "F(d)" if k is None else "F(D)"
    if observation not in ("F(D)", "delta(D)", "F(d)"):
        raise ValueError(f"observation must be 'F(D)', 'delta(D)' or 'F(d)', got {observation!r}")
    legs = (legs,) if isinstance(legs, str) else tuple(legs)
    if unknown := [leg for leg in legs if leg not in _SEGMENTS.values()]:
        raise ValueError(f"legs are 'approach' and 'retract', got {unknown[0]!r}")
    if observation != "F(d)" and k is None:
        raise ValueError(f"{observation} needs the spring constant: give the stiffness with the path")
    x = -(_tip(curve, force, k) if observation == "F(d)" else _height(curve, force, k))
    segment = np.asarray(curve["segment"]).astype(int)
    down = x[(segment == 0) & np.isfinite(x)]
    if len(down) > 1 and down[-1] < down[0]:
        raise ValueError("the height rises on approach; it has to fall")
    wanted = [number for number, leg in _SEGMENTS.items() if leg in legs]
    keep = np.isin(segment, wanted) & np.isfinite(x) & np.isfinite(force)
    y = force / k if observation == "delta(D)" and k is not None else force
    arguments: dict[str, Any] = {
        "x": x[keep],
        "y": y[keep],
        "observation": observation,
        "leg": [_SEGMENTS[number] for number in segment[keep].tolist()],
    }
    if observation != "F(d)":
        arguments["stiffness"] = k
    return AfmCurve(arguments, k, gain)


def _load(path: str | PathLike[str], stated: dict[str, float | None], index: int | None) -> Any:
    """The curve of a file."""
    try:
        afmformats = importlib.import_module("afmformats")
    except ImportError as error:
        raise ImportError("reading files of instruments needs afmformats: pip install 'mdr-contact[afm]'") from error
    override = {key: value for key, value in stated.items() if value is not None}
    try:
        curves = afmformats.load_data(path, meta_override=override) if override else afmformats.load_data(path)
    except NotImplementedError as error:
        raise ValueError(f"afmformats takes no other {' and '.join(override)} for files of this format: leave it out") from error
    if index is None and len(curves) != 1:
        raise ValueError(f"the file has {len(curves)} curves: choose one by index")
    if not -len(curves) <= (index or 0) < len(curves):
        raise ValueError(f"index must be below the {len(curves)} curves of the file, got {index}")
    return curves[index or 0]


def _number(metadata: Any, key: str) -> float | None:
    """A positive number of the metadata."""
    value = float(metadata[key]) if key in metadata else float("nan")
    return value if np.isfinite(value) and value > 0 else None


def _column(curve: Any, name: str) -> Floats:
    return np.asarray(curve[name], dtype=np.float64)


def _height(curve: Any, force: Floats, k: float | None) -> Floats:
    """Height of the cantilever: measured, of the piezo, or tip position − force/k"""
    for name in ("height (measured)", "height (piezo)"):
        if name in curve:
            return _column(curve, name)
    if "tip position" in curve and k is not None:
        return _column(curve, "tip position") - force / k
    raise ValueError("the curve has no height")


def _tip(curve: Any, force: Floats, k: float | None) -> Floats:
    """Tip position: as it is, or height + force/k"""
    if "tip position" in curve:
        return _column(curve, "tip position")
    if k is None:
        raise ValueError("the curve has neither a tip position nor a spring constant")
    return _height(curve, force, k) + force / k
