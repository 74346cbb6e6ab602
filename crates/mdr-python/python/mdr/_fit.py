"""Fits of measured curves: E*, w and other unknowns of a contact, with their errors."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property
from typing import Any, Literal, TypeAlias, final, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._afmformats import from_afmformats
from ._media import Medium
from ._numbers import Floats, Number, digits_of, exact, row
from ._profiles import Files, Profile
from ._scene import Picture, _double, _numbers
from ._states import html_table

Observation: TypeAlias = Literal["F(d)", "F(D)", "delta(D)", "d(F)", "F(a)", "a(F)"]


@dataclass(frozen=True, slots=True)
class Estimate:
    """A free number: its estimate, its standard error and its unit; None where the data do not determine it."""

    name: str
    value: float | None
    stderr: float | None
    scaled_stderr: float | None
    unit: str


@dataclass(frozen=True, slots=True)
class Interval:
    """What the data do not contradict of a free number at a level, by profile likelihood; None where an end is open."""

    name: str
    level: float
    lower: float | None
    upper: float | None


@dataclass(frozen=True, slots=True)
class CertifiedEstimate:
    """A free number whose digits are all proved. No other stationary point is within ``unique_within`` in each number at once."""

    name: str
    value: Decimal
    scaled_stderr: Decimal
    unique_within: float


@dataclass(frozen=True, slots=True)
class _Rows:
    """The rows of a fit as columns."""

    x: Floats
    y: Floats
    fitted: Floats
    residuals: Floats
    contact_radius: Floats
    labels: NDArray[np.int64]
    leg: tuple[str, ...]
    pinned: NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class _Kept:
    """What is left of a fit that was pickled."""

    text: str
    picture: str
    rows: _Rows

    def json(self) -> str:
        return self.text

    def svg(self) -> str:
        return self.picture


_LEGS = ("approach", "retract")


@final
class Fit:
    """The answer of :func:`fit`. Its ``repr`` is a table; a notebook shows it with its picture."""

    def __init__(self, fitted: _core.Fitted) -> None:
        self._fitted: _core.Fitted | _Kept = fitted
        answer: dict[str, Any] = json.loads(fitted.head())
        self._answer = answer
        self.status: Literal["fitted", "poor-fit", "unidentifiable", "not-converged"] = answer["status"]
        """How it ended. Where it is ``"unidentifiable"``, :attr:`invariants` are what the data determine."""
        self.reason: str = answer["reason"]
        """What the status means for these data; empty when all is well."""
        self.estimates: tuple[Estimate, ...] = tuple(
            Estimate(*(each[key] for key in Estimate.__slots__)) for each in answer["parameters"]
        )
        """The free numbers with their errors, in the order in which they were named."""
        self.parameters: dict[str, float | None] = {each.name: each.value for each in self.estimates}
        """The estimates by name, in SI units."""
        self.stderr: dict[str, float | None] = {each.name: each.stderr for each in self.estimates}
        """Their standard errors: from the stated sigma; scaled by the residuals where none is stated."""
        self.covariance: Floats = _matrix(answer["covariance"])
        """Of the estimates, in their order; of shape (0, 0) unless all are determined."""
        self.correlation: Floats = _matrix(answer["correlation"])
        """Of the estimates, likewise."""
        self.invariants: list[dict[str, Any]] = answer["invariants"]
        """Products of powers that the data determine although they do not determine their factors."""
        self.rss: float = answer["rss"]
        """The sum of squares."""
        self.dof: int = answer["dof"]
        """Rows and priors less free numbers."""
        self.chi2: float | None = answer["chi2"]
        """The sum of squares in units of sigma, where sigma is given."""
        self.predicted_pull_off: dict[str, Any] | None = answer["predicted_pull_off"]
        """Where the contact breaks, by the fitted curve: ``x``, ``y``, ``force``, ``indentation``, ``contact_radius``."""
        self.measured_pull_off: dict[str, Any] | None = answer["measured_pull_off"]
        """The last row in contact before the first detached one."""
        self.validity: dict[str, Any] | None = _numbers(answer["validity"], _double)
        """Whether the theory holds for the fitted contact, where ``range_of_adhesion`` is given."""
        self.legs: list[dict[str, Any]] = answer["legs"]
        """Each leg with its rows and its residuals: ``leg``, ``rows``, ``in_contact``, ``pinned``, ``mean_square``, ``runs_test``,
        ``autocorrelation``."""
        self.autocorrelation: dict[str, float] | None = answer["autocorrelation"]
        """Whether neighbouring residuals are alike: ``lag_one``, ``z``, ``p`` of white noise, and ``widening``, the factor of standard errors."""
        self.quantities: dict[str, dict[str, Any]] = {each["name"]: each for each in answer["quantities"]}
        """``adhesion_force``, ``pull_off_force`` and ``separation_work`` of the fitted curve, and with ``_measured`` of the rows.

        Each has ``label``, ``value``, ``stderr`` and ``unit``; pulling counts positive."""
        self.budget: dict[tuple[str, str], float] = {(each["name"], each["of"]): each["slope"] for each in answer["budget"]}
        """How an estimate follows a given number, ∂ln estimate/∂ln given, by both names; of an offset ∂estimate/∂ln given."""
        self.limits: dict[str, dict[str, Any]] = {each["name"]: each for each in answer["limits"]}
        """``lower`` and ``upper`` of numbers that the rows do not determine, or hardly tell from zero."""
        self.skipped: dict[str, int] = {each["why"]: each["rows"] for each in answer["skipped"]}
        """How many rows do not count, by the reason."""
        self.chi2_p: float | None = answer["chi2_p"]
        """The probability of at least this chi2."""
        self.warnings: tuple[str, ...] = tuple(answer["warnings"])
        """What may mislead."""

        self.intervals: tuple[Interval, ...] = tuple(Interval(**each) for each in answer.get("intervals", []))
        """Of the free numbers at 0.68 and 0.95, where ``profile_likelihood`` asks for them."""
        self.smoothing: list[dict[str, Any]] = answer.get("smoothing", [])
        """Of a measured tip: ``length`` that it is smoothed over instead, ``estimates`` and ``rss`` then."""
        proved = answer["certified"] or {"parameters": []}
        self.certified: tuple[CertifiedEstimate, ...] = tuple(
            CertifiedEstimate(
                each["name"], Decimal(each["value"]), Decimal(each["scaled_stderr"]), float(each["unique_within"])
            )
            for each in proved["parameters"]
        )
        """The estimates where ``digits`` asks for them; empty where they cannot be proved, and a warning says why."""

    @cached_property
    def _of_rows(self) -> _Rows:
        # Of a long record they take room, and are made when one of them is asked for.
        if isinstance(self._fitted, _Kept):
            return self._fitted.rows
        (x, y, fitted, residuals, radii), labels, (retracts, pinned) = self._fitted.columns()
        leg = tuple(_LEGS[each] for each in retracts.tolist())
        return _Rows(x, y, fitted, residuals, radii, labels, leg, pinned)

    @property
    def residuals(self) -> Floats:
        """Curve minus datum of each row, in units of sigma."""
        return self._of_rows.residuals

    @property
    def x(self) -> Floats:
        """X of each row that counts, in SI units."""
        return self._of_rows.x

    @property
    def y(self) -> Floats:
        """Y of each row, likewise."""
        return self._of_rows.y

    @property
    def fitted(self) -> Floats:
        """Y of the curve where it is compared with each row: at its X where x is exact, else at the nearest point."""
        return self._of_rows.fitted

    @property
    def leg(self) -> tuple[str, ...]:
        """``"approach"`` or ``"retract"`` of each row."""
        return self._of_rows.leg

    @property
    def pinned(self) -> NDArray[np.bool_]:
        """Whether the edge of the contact is pinned between two works of adhesion."""
        return self._of_rows.pinned

    @property
    def labels(self) -> NDArray[np.int64]:
        """The arc of each row, 0 the outermost; −1 detached."""
        return self._of_rows.labels

    @property
    def contact_radius(self) -> Floats:
        """The contact radius of each row in m; NaN where the surfaces are apart."""
        return self._of_rows.contact_radius

    def __getitem__(self, name: str) -> Estimate:
        for each in self.estimates:
            if each.name in (name.removeprefix("profile."), f"work_of_adhesion.{name}"):
                return each
        raise KeyError(name)

    def to_dataframe(self) -> Any:
        """The rows as a ``pandas.DataFrame``, in SI units; pandas has to be installed.

        Columns: ``x``, ``y``, ``leg``, ``label``, ``fitted``, ``residual``, ``contact_radius``, ``pinned``.
        """
        try:
            import pandas as pd  # type: ignore[import-not-found, import-untyped, unused-ignore]
        except ImportError as error:
            raise ImportError("to_dataframe needs pandas: pip install pandas") from error
        return pd.DataFrame(self._columns())

    def _columns(self) -> dict[str, Any]:
        return {
            "x": self.x,
            "y": self.y,
            "leg": list(self.leg),
            "label": self.labels,
            "fitted": self.fitted,
            "residual": self.residuals,
            "contact_radius": self.contact_radius,
            "pinned": self.pinned,
        }

    @overload
    def plot(self) -> Picture: ...

    @overload
    def plot(self, ax: Any) -> Any: ...

    def plot(self, ax: Any = None) -> Any:
        """Data with their labels and the fitted curve, residuals, and contact radius, as SVG.

        With ``ax``, the axes of a matplotlib figure, data and curve are drawn there instead, and the axes returned.
        """
        if ax is not None:
            return self._draw(ax)
        return Picture(self._fitted.svg())

    def _draw(self, ax: Any) -> Any:
        detached = self.labels < 0
        for leg, colour in (("approach", "tab:cyan"), ("retract", "tab:blue")):
            own = np.array([each == leg for each in self.leg]) & ~detached
            if own.any():
                ax.plot(self.x[own], self.y[own], "o", mfc="none", ms=4, color=colour, label=f"in contact, {leg}", zorder=1)
        if detached.any():
            ax.plot(self.x[detached], self.y[detached], "x", ms=4, color="tab:gray", label="detached", zorder=1)
        for index, arc in enumerate(self._answer["arcs"]):
            x, y, _ = np.array(arc, dtype=np.float64).T
            ax.plot(x, y, "-", color="black", label="fit" if index == 0 else None, zorder=2)
        x_name, y_name = _AXES[self._answer["observation"]]
        ax.set_xlabel(x_name)
        ax.set_ylabel(y_name)
        ax.legend()
        return ax

    def to_json(self) -> str:
        """The answer as one line of JSON, schema ``mdr.fit/1``, as the command line prints it."""
        return self._fitted.json()

    def __getstate__(self) -> dict[str, Any]:
        return self.__dict__ | {"_fitted": _Kept(self._fitted.json(), self._fitted.svg(), self._of_rows)}

    def _rows(self) -> list[tuple[str, ...]]:
        rows = []
        for each in self.estimates:
            number = [f"{x:.6g}" if x is not None else "-" for x in (each.value, each.stderr)]
            share = "-" if not each.value or each.stderr is None else f"{abs(each.stderr / each.value):.2%}"
            rows.append((each.name, *number, share, each.unit))
        return rows

    def _notes(self) -> list[str]:
        known = [f"determined: {each['name']} = {each['value']:.6g} ± {each['stderr']:.2g}" for each in self.invariants]
        return [*filter(None, [self.reason]), *known, *(f"warning: {warning}" for warning in self.warnings)]

    def __repr__(self) -> str:
        lines = [f"<Fit: {self.status}, {len(self.residuals)} rows, {self.dof} degrees of freedom>"]
        rows = [_TITLES, *self._rows()]
        widths = [max(len(row[column]) for row in rows) for column in range(len(_TITLES))]
        lines += ["  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in rows]
        return "\n".join(lines + self._notes())

    def _repr_html_(self) -> str:
        notes = "".join(f"<p>{note}</p>" for note in self._notes())
        picture = self.plot()._repr_svg_()
        return f"<h4>{self.status}</h4>" + html_table(_TITLES, self._rows()) + notes + picture


_AXES = {
    "F(d)": ("indentation depth d, m", "force F, N"),
    "F(D)": ("position D, m", "force F, N"),
    "delta(D)": ("position D, m", "deflection F/k, m"),
    "d(F)": ("force F, N", "indentation depth d, m"),
    "F(a)": ("contact radius a, m", "force F, N"),
    "a(F)": ("force F, N", "contact radius a, m"),
}
_TITLES = ("name", "value", "stderr", "share", "unit")


def _matrix(rows: list[list[float]]) -> Floats:
    return np.array(rows, dtype=np.float64).reshape(len(rows), len(rows))


def fit(
    x: ArrayLike,
    y: ArrayLike,
    *,
    profile: Profile,
    observation: Observation,
    medium: Medium | None = None,
    free: Sequence[str] = ("e_star", "work_of_adhesion"),
    e_star: Number | None = None,
    work_of_adhesion: Number | Mapping[str, Number] | None = None,
    stiffness: Number | None = None,
    sigma_x: Number | None = None,
    sigma_y: Number | None = None,
    leg: Sequence[Literal["approach", "retract"]] | None = None,
    time: ArrayLike | None = None,
    legs: Literal["both", "approach", "retract"] = "both",
    rows: Mapping[str, tuple[Number, Number]] | None = None,
    saturation: tuple[Number, Number] | None = None,
    missing: Literal["refuse", "skip"] = "refuse",
    start: Mapping[str, Number] | None = None,
    fixed: Mapping[str, Number] | None = None,
    prior: Mapping[str, tuple[Number, Number]] | None = None,
    bounds: Mapping[str, tuple[Number, Number]] | None = None,
    loss: Literal["least-squares", "huber"] = "least-squares",
    range_of_adhesion: Number | str | None = None,
    profile_likelihood: bool = False,
    digits: int | None = None,
) -> Fit:
    """Fits a measured curve. The theory decides on which branch a row lies and where the contact jumps: no row is clipped.

    Parameters
    ----------
    x, y : array_like
        X and Y of each row, given and measured, in SI units and in the order of the record.
    profile : Profile
        What was pressed. Its numbers are starts where they are free.
    observation : {"F(d)", "F(D)", "delta(D)", "d(F)", "F(a)", "a(F)"}
        What x and y are: force F, depth d, position D of a machine, deflection delta of a cantilever, contact radius a.
    medium : Medium, optional
        What it was pressed into; a half-space without it. ``"coefficient"`` of :class:`Graded` and ``"modulus"`` of
        :class:`Winkler` can be free in the place of ``"e_star"``; their values are known numbers, or starts.
    free : sequence of str
        The unknowns: ``"e_star"``, ``"work_of_adhesion"``, or two of them, ``"advancing"`` and ``"receding"``, ``"stiffness"``,
        ``"sensitivity"`` (true deflection over recorded one), ``"contact_point"`` (an offset of x), ``"baseline"`` (an offset of the
        force or the deflection), ``"baseline_slope"``, ``"baseline_drift"``, ``"position_drift"``, and numbers of the profile, such as
        ``"radius"``.
    e_star, work_of_adhesion, stiffness : Number, optional
        Where they are known: Pa, J/m², N/m. ``work_of_adhesion`` may be ``{"advancing": ..., "receding": ...}``.
    sigma_x, sigma_y : Number, optional
        Standard deviations. Without ``sigma_x`` x is exact; without ``sigma_y`` the residuals tell it.
    leg : sequence of {"approach", "retract"}, optional
        Of each row; legs end where x turns without it.
    time : array_like, optional
        Of each row, in s: drifts are then per second, else per record.
    legs : {"both", "approach", "retract"}
        The leg that counts.
    rows : mapping, optional
        ``{"x": (lowest, highest), "y": (lowest, highest)}``: rows outside of it do not count.
    saturation : pair, optional
        Range of y; rows at its ends or beyond do not count.
    missing : {"refuse", "skip"}
        Whether rows with NaN are refused, or skipped and counted in :attr:`Fit.skipped`.
    start, fixed : mapping, optional
        Values to begin from, and values of offsets that are not free.
    prior, bounds : mapping, optional
        ``(mean, standard deviation)`` and ``(lower, upper)`` by name. A number with a prior is free.
    loss : {"least-squares", "huber"}
        Huber counts wild rows less, and needs ``sigma_y``.
    range_of_adhesion : Number or str, optional
        In m, or with its unit, ``"0.3 nm"``: the answer says whether the theory holds.
    profile_likelihood : bool
        Also intervals of 68 % and 95 % without a linearised model: each takes some ten further fits.
    digits : int, optional
        Also estimates in so many proved digits.

    Returns
    -------
    Fit
        Also where the data do not determine the unknowns, which its ``status`` says.

    Raises
    ------
    SceneError
        What cannot be fitted: nothing free, fewer rows than unknowns, numbers that are none.

    Examples
    --------
    >>> import mdr, numpy as np
    >>> ball = mdr.jkr(radius=1e-5, e_star=2e6, work_of_adhesion=0.05)
    >>> depth = np.linspace(2e-6, -2e-7, 12)
    >>> force = ball.states(indentation=depth).force
    >>> found = mdr.fit(depth, force, profile=mdr.Paraboloid(radius=1e-5), observation="F(d)")
    >>> found.status, [float(f"{value:.8g}") for value in found.parameters.values()]
    ('fitted', [2000000.0, 0.05])
    """
    xs, ys = row(x, "x"), row(y, "y")
    times = None if time is None else row(time, "time")
    if len(xs) != len(ys):
        raise ValueError(f"x and y must have as many rows, got {len(xs)} and {len(ys)}")
    if leg is not None and len(leg) != len(xs):
        raise ValueError(f"leg must have as many rows as x, got {len(leg)} and {len(xs)}")
    if times is not None and len(times) != len(xs):
        raise ValueError(f"time must have as many rows as x, got {len(times)} and {len(xs)}")
    if missing not in ("refuse", "skip"):
        raise ValueError(f'missing must be "refuse" or "skip", got {missing!r}')
    for name, column in (("x", xs), ("y", ys)):
        if missing == "refuse" and not np.isfinite(column).all():
            at = int(np.argmin(np.isfinite(column)))
            raise ValueError(f"x and y must be finite: leave out rows that were not measured, or missing='skip'; {name}[{at}] is {column[at]}")
    files: Files = {}
    problem: dict[str, Any] = {
        "profile": profile._scene(files),
        "data": {"observation": observation},
        "fit": {"free": list(free), "loss": loss},
    }
    if times is not None:
        problem["data"]["time"] = times.tolist()
    if missing == "skip":
        problem["data"]["missing"] = missing
    if legs != "both":
        problem["fit"]["legs"] = legs
    if rows:
        problem["fit"]["rows"] = {axis: [exact(end, axis) for end in ends] for axis, ends in rows.items()}
    if saturation is not None:
        problem["data"]["saturation"] = [exact(end, "saturation") for end in saturation]
    if medium is not None:
        problem["medium"] = medium._scene()
    sigma = {"x": sigma_x, "y": sigma_y}
    if given := {axis: exact(value, f"sigma_{axis}") for axis, value in sigma.items() if value is not None}:
        problem["data"]["sigma"] = given
    known: dict[str, Any] = {}
    if e_star is not None:
        known["e_star"] = exact(e_star, "e_star")
    if isinstance(work_of_adhesion, Mapping):
        known["work_of_adhesion"] = {edge: exact(value, edge) for edge, value in work_of_adhesion.items()}
    elif work_of_adhesion is not None:
        known["work_of_adhesion"] = exact(work_of_adhesion, "work_of_adhesion")
    if known:
        problem["material"] = known
    if stiffness is not None:
        problem["control"] = {"kind": "machine", "stiffness": exact(stiffness, "stiffness")}
    for key, numbers in (("start", start), ("fixed", fixed)):
        if numbers:
            problem["fit"][key] = {name: exact(value, name) for name, value in numbers.items()}
    if prior:
        problem["fit"]["prior"] = {
            name: {"mean": exact(mean, name), "sd": exact(sd, name)} for name, (mean, sd) in prior.items()
        }
    if bounds:
        problem["fit"]["bounds"] = {name: [exact(end, name) for end in ends] for name, ends in bounds.items()}
    output: dict[str, Any] = {}
    if range_of_adhesion is not None:
        output["range_of_adhesion"] = exact(range_of_adhesion, "range_of_adhesion")
    if profile_likelihood:
        output["intervals"] = "profile-likelihood"
    if digits is not None:
        output["digits"] = digits_of(digits)
    if output:
        problem["output"] = output
    return Fit(_core.fit(json.dumps(problem), files, xs, ys, None if leg is None else list(leg)))


# mdr.fit.from_afmformats is mdr.from_afmformats, where one looks for it.
setattr(fit, "from_afmformats", from_afmformats)
