"""Fit models for nanite and PyJibe: contacts with adhesion of short range, for any profile.

A model of nanite is a file. It needs two lines, as in ``examples/nanite``::

    import mdr, mdr.nanite
    globals().update(mdr.nanite.model(lambda R: mdr.Paraboloid(radius=R), {"R": ("Tip Radius", "m", 5e-6)},
                                      key="mdr_jkr_sphere", name="sphere with adhesion (JKR, mdr)"))

nanite brings lmfit, which this module needs when a model is used.
"""

from __future__ import annotations

import importlib
import inspect
import warnings
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from ._contact import Contact
from ._errors import Error
from ._fit import fit
from ._numbers import Floats
from ._profiles import Profile

__all__ = ["model"]

# Bounds of lmfit can be reached, where a contact needs positive numbers.
_LEAST_MODULUS, _LEAST_WORK, _LEAST_SHARE = 1e-6, 1e-15, 1e-6
# Rows that are enough for a start.
_ROWS = 400
# A pull-off below so many standard deviations of the noise is not told from it: the least of a thousand rows of noise is at 3.2.
_DROWNED = 5.0


def model(
    profile: Callable[..., Profile], numbers: Mapping[str, tuple[str, str, float]], *, key: str, name: str
) -> dict[str, Any]:
    """Returns what a model file of nanite has to define, for a profile on an elastic half-space.

    The numbers of the fit are E in Pa, nu, w in J/m², those of the profile, the contact point in m and the baseline in N. nanite's
    tip position falls as the tip goes down: the depth is contact_point − tip position. Young's modulus is that of the sample
    under a rigid tip, E* = E/(1 − nu²).

    Fit the segment "retract". Which rows are in contact is decided by least squares along the segment, so that an early
    pull-off biases nothing; nanite's ``weight_cp`` is ignored, since it would fade out the adhesion. Start values are those of
    :func:`mdr.fit` on the retract segment, with a warning where its pull-off is not told from the noise.

    Parameters
    ----------
    profile : callable
        The profile from its numbers, called by their keys: ``lambda R: mdr.Paraboloid(radius=R)``.
    numbers : mapping
        Of each number of the profile its title, its unit and its default in SI units. PyJibe shows "Tip Radius" in µm. They
        are fixed unless you let them vary.
    key, name : str
        Of the model: a unique key, and its title in lists.

    Returns
    -------
    dict
        The attributes of the module, by name.

    Examples
    --------
    >>> import mdr.nanite
    >>> made = mdr.nanite.model(lambda R: mdr.Paraboloid(radius=R), {"R": ("Tip Radius", "m", 5e-6)},
    ...                         key="jkr", name="sphere")
    >>> made["parameter_keys"]
    ['E', 'nu', 'w', 'R', 'contact_point', 'baseline']
    >>> force = made["model_func"]([-1e-6, 1e-6], E=5e4, nu=0.5, w=2e-4, R=5e-6, contact_point=0, baseline=1e-12)
    >>> bool(force[0] > 1e-7), float(force[1])  # pressed in, and out of contact
    (True, 1e-12)
    """
    return _Model(profile, dict(numbers), key, name).attributes()


class _Model:
    def __init__(
        self, profile: Callable[..., Profile], numbers: dict[str, tuple[str, str, float]], key: str, name: str
    ) -> None:
        self.profile, self.numbers, self.key, self.name = profile, numbers, key, name
        taken = {"E", "nu", "w", "contact_point", "baseline"}
        if clash := taken & numbers.keys():
            raise ValueError(f"the number {sorted(clash)[0]!r} belongs to every model: call it otherwise")

    def attributes(self) -> dict[str, Any]:
        rows = [
            ("E", "Young's Modulus", "Pa"), ("nu", "Poisson's Ratio", ""), ("w", "Work of Adhesion", "J/m²"),
            *((key, title, unit) for key, (title, unit, _) in self.numbers.items()),
            ("contact_point", "Contact Point", "m"), ("baseline", "Force Baseline", "N"),
        ]
        keys, titles, units = (list(column) for column in zip(*rows))
        starts = ["E", "w", "contact_point", "baseline"]
        return {
            "get_parameter_defaults": self.defaults, "model_func": self.function(keys), "model": self.curve,
            "residual": self.residual, "compute_ancillaries": self.starts, "model_doc": self.describe(rows),
            "model_key": self.key, "model_name": self.name, "parameter_keys": keys, "parameter_names": titles,
            "parameter_units": units, "parameter_anc_keys": starts,
            "parameter_anc_names": [f"{title} (mdr.fit)" for key, title, _ in rows if key in starts],
            "parameter_anc_units": [unit for key, _, unit in rows if key in starts],
            "valid_axes_x": ["tip position"], "valid_axes_y": ["force"],
        }

    def defaults(self) -> Any:
        """Start values in SI units, in the order of the keys; without lmfit there is no nanite to ask for them."""
        params = importlib.import_module("lmfit").Parameters()
        params.add("E", value=1e5, min=0)
        params.add("nu", value=0.5, min=0, max=0.5, vary=False)
        params.add("w", value=1e-3, min=0)
        for key, (_, _, value) in self.numbers.items():
            params.add(key, value=value, min=0, vary=False)
        params.add("contact_point", value=0)
        params.add("baseline", value=0)
        return params

    def shape(self, numbers: Mapping[str, float]) -> Profile:
        known = {key: max(float(numbers[key]), _LEAST_SHARE * own) for key, (_, _, own) in self.numbers.items()}
        return self.profile(**known)

    def contact(self, numbers: Mapping[str, float]) -> Contact:
        work = max(float(numbers["w"]), _LEAST_WORK)
        return Contact(self.shape(numbers), e_star=_e_star(numbers), work_of_adhesion=work)

    def force(self, delta: Any, numbers: Mapping[str, float]) -> Floats:
        """The stable branch down to where the contact breaks at fixed grips, and the baseline beyond."""
        depth = numbers["contact_point"] - np.asarray(delta, dtype=np.float64)
        force: Floats = self.contact(numbers).states(indentation=depth).force
        return np.where(np.isfinite(force), force, 0.0) + numbers["baseline"]

    def function(self, keys: list[str]) -> Callable[..., Floats]:
        """The model with the signature that nanite checks."""

        def force_of_tip_position(delta: Any, *args: float, **kwargs: float) -> Floats:
            return self.force(delta, dict(zip(keys, args)) | kwargs)

        kind = inspect.Parameter.POSITIONAL_OR_KEYWORD
        parameters = [inspect.Parameter(name, kind) for name in ["delta", *keys]]
        force_of_tip_position.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
        force_of_tip_position.__doc__ = self.name
        return force_of_tip_position

    def curve(self, params: Any, delta: Any) -> Floats:
        """Curve of a segment: on approach contact begins at the contact point, on retract it lasts to the fold."""
        numbers, delta = params.valuesdict(), np.asarray(delta, dtype=np.float64)
        force = self.force(delta, numbers)
        if _is_approach(delta):
            force[delta > numbers["contact_point"]] = numbers["baseline"]
        return force

    def residual(self, params: Any, delta: Any, force: Any, weight_cp: float = 0) -> Floats:
        """Force minus curve; which rows are in contact is decided by least squares, not by the curve.

        Along a segment there is one change between contact and baseline. Of all places for it, below half of the largest force,
        the one with the smallest sum of squares is taken, so that the sum is a continuous function of the parameters
        although the curve jumps. Rows in contact beyond the fold count with their distance from it.
        """
        numbers, delta = params.valuesdict(), np.asarray(delta, dtype=np.float64)
        contact = self.contact(numbers)
        fold = contact.critical("indentation")
        depth = numbers["contact_point"] - delta
        free: Floats = np.asarray(force, dtype=np.float64) - numbers["baseline"]
        # The fold itself may be on the other side of its rounding.
        end = fold.indentation + 1e-9 * abs(fold.indentation)
        touching = free - contact.states(indentation=np.maximum(depth, end)).force
        miss = 2 * _e_star(numbers) * fold.contact_radius * np.minimum(depth - fold.indentation, 0)
        touching = np.copysign(np.hypot(touching, miss), touching)
        flip = slice(None, None, -1 if _is_approach(delta) else 1)  # contact first
        gain = np.concatenate([[0], np.cumsum(touching[flip] ** 2 - free[flip] ** 2)])
        level = free[flip] + numbers["baseline"]
        level = level - np.median(level[-max(len(level) // 20, 1):])
        least = int(np.argmax(np.append(level < level.max() / 2, True)))  # more than half of the largest force is contact
        rows = np.arange(len(free)) < least + np.argmin(gain[least:])
        chosen: Floats = np.where(rows[flip], touching, free)
        return chosen

    def starts(self, curve: Any) -> dict[str, float]:
        """Start values by mdr.fit on the retract segment, NaN, which nanite skips, where it has none."""
        found = dict.fromkeys(["E", "w", "contact_point", "baseline"], float("nan"))
        if "tip position" not in curve:
            return found
        given = (curve.fit_properties.get("params_initial") or self.defaults()).valuesdict()
        retract = curve.retr
        x, y = (np.asarray(retract[column], dtype=np.float64) for column in ("tip position", "force"))
        keep = np.isfinite(x) & np.isfinite(y)
        x, y = x[keep], y[keep]
        if len(x) < 10:
            return found
        _warn_of_noise(y)
        thin = max(len(x) // _ROWS, 1)
        try:
            fitted = fit(
                -x[::thin], y[::thin], profile=self.shape(given), observation="F(d)", leg=["retract"] * len(x[::thin]),
                free=["e_star", "work_of_adhesion", "contact_point", "baseline"],
            ).parameters
        except (Error, ValueError):
            return found
        e_star, w, contact_point, baseline = (fitted[key] for key in fitted)
        if e_star is None or w is None or contact_point is None or baseline is None:
            return found
        return {"E": e_star * (1 - given["nu"] ** 2), "w": w, "contact_point": -contact_point, "baseline": baseline}

    def describe(self, rows: list[tuple[str, str, str]]) -> str:
        listed = "\n".join(f"{key}: float\n    {title} [{unit or '1'}]" for key, title, unit in rows)
        return (
            f"{self.name}\n\nForce against tip position, adhesion of short range included. Tension is negative. The stable\n"
            "branch ends where the contact breaks at fixed grips; beyond it the force is the baseline. Fit the\n*retract* segment; "
            "`weight_cp` is ignored.\n\nParameters\n----------\ndelta: 1d ndarray\n    Tip position [m]; smaller is deeper\n"
            f"{listed}\n\nReturns\n-------\nF: float\n    Force [N]\n"
        )


def _e_star(numbers: Mapping[str, float]) -> float:
    """E* in Pa, of a sample under a rigid tip."""
    return max(float(numbers["E"]), _LEAST_MODULUS) / (1 - float(numbers["nu"]) ** 2)


def _is_approach(delta: Floats) -> bool:
    return bool(delta[0] > delta[-1])


def _warn_of_noise(force: Floats) -> None:
    """Warns where the smallest force is not told from noise: w is then a number that noise made."""
    tail = force[-max(len(force) // 10, 5):]
    noise = float(np.std(np.diff(tail)) / np.sqrt(2))
    pull_off = float(np.median(tail) - force.min())
    if pull_off < _DROWNED * noise:
        warnings.warn(
            f"the pull-off force, {pull_off:.2g} N, is not told from the noise, {noise:.2g} N: the work of adhesion is not determined",
            stacklevel=2,
        )
