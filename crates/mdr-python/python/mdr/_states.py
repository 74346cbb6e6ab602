"""States, and what happens to them: the answers of a contact."""

from __future__ import annotations

import html
from dataclasses import dataclass
from decimal import Decimal
from enum import IntEnum
from typing import TYPE_CHECKING, Any, Generic, Literal, TypeVar

import numpy as np
from numpy.typing import NDArray

from ._numbers import Floats

if TYPE_CHECKING:
    from matplotlib.axes import Axes

N = TypeVar("N", float, Decimal)


class Status(IntEnum):
    """Whether there is a state, and why not.

    A state that is ``NOT_ADMISSIBLE`` has numbers, but outside of the contact its surfaces would overlap: the theory does not
    hold for it. Of all others but ``OK`` and ``FOLD`` the numbers are NaN.
    """

    OK = 0
    FOLD = 1
    NO_EQUILIBRIUM = 2
    OVERFLOW = 3
    UNDERFLOW = 4
    DOMAIN_ERROR = 5
    NOT_ADMISSIBLE = 6
    UNDECIDED = 7


@dataclass(frozen=True, slots=True)
class State(Generic[N]):
    """A state of the contact: contact radius in m, indentation in m and force in N, both positive when pressed in.

    Surfaces that are apart have the contact radius 0 and the force 0.
    """

    contact_radius: N
    indentation: N
    force: N

    def to_dict(self) -> dict[str, N]:
        """The three numbers by their names."""
        return {"contact_radius": self.contact_radius, "indentation": self.indentation, "force": self.force}


@dataclass(frozen=True, slots=True)
class Fold(State[N]):
    """An instability: a minimum or a maximum of the controlled quantity, along increasing contact radii."""

    kind: Literal["minimum", "maximum"]


@dataclass(frozen=True, eq=False, repr=False)
class States:
    """States as arrays of the shape of what was asked; scalars for a scalar."""

    contact_radius: Floats
    indentation: Floats
    force: Floats
    status: NDArray[np.int8]

    def to_dict(self) -> dict[str, NDArray[Any]]:
        """Flat columns, for ``pandas.DataFrame``."""
        return {name: np.ravel(getattr(self, name)) for name in ("contact_radius", "indentation", "force", "status")}

    def __repr__(self) -> str:
        good = int(np.count_nonzero(np.isin(self.status, (Status.OK, Status.FOLD))))
        return f"<{type(self).__name__} of shape {np.shape(self.status)}, {good} in equilibrium>"


@dataclass(frozen=True, slots=True)
class Event:
    """Something that happens on the way: ``jump-in``, ``jump``, ``detached`` and the like, as in scenes.

    ``value`` is that of the controlled quantity, and ``dissipated`` the energy lost in J, infinite where it has no bound and NaN
    where it is not known. With two works of adhesion ``hysteresis`` is the part of it that the receding edge has lost since the
    event before, and ``edge`` the one that jumps, stops, or begins to move.
    """

    kind: str
    value: float
    before: State[float]
    after: State[float]
    dissipated: float
    hysteresis: float = 0.0
    edge: str | None = None


@dataclass(frozen=True, eq=False, repr=False)
class Trace(States):
    """A state for each value of a history, what happened between them, and the position of a machine."""

    position: Floats | None
    jumps: tuple[Event, ...]


@dataclass(frozen=True, eq=False, repr=False)
class Equilibria:
    """All equilibria: arrays with one more axis than what was asked, for the branches by increasing contact radius.

    NaN stands where a branch has none. ``stable`` belongs to the branches, ``status`` to the values.
    """

    contact_radius: Floats
    indentation: Floats
    force: Floats
    stable: NDArray[np.bool_]
    admissible: NDArray[np.bool_]
    status: NDArray[np.int8]

    @property
    def count(self) -> NDArray[np.intp]:
        """How many there are at each value; the double root of a fold is one."""
        held = np.isfinite(self.contact_radius).sum(axis=-1)
        count: NDArray[np.intp] = np.where(self.status == Status.FOLD, 1, held)[()]
        return count

    def __repr__(self) -> str:
        branches, stable = len(self.stable), int(self.stable.sum())
        return f"<Equilibria at {np.size(self.status)} values, {branches} branches, {stable} stable>"


@dataclass(frozen=True, eq=False, repr=False)
class LoadingPath:
    """What happens between way points, with energy in J, and a curve to be drawn."""

    events: tuple[Event, ...]
    contact_radius: Floats
    indentation: Floats
    force: Floats
    position: Floats | None
    work: float
    dissipated: float
    stored: float
    held: str = "indentation"

    def to_dict(self) -> dict[str, Floats]:
        """The columns of the curve."""
        columns = {name: getattr(self, name) for name in ("contact_radius", "indentation", "force")}
        return columns if self.position is None else columns | {"position": self.position}

    def plot(self, ax: Axes | None = None, *, x: str = "indentation", y: str = "force", **style: Any) -> Axes:
        """Draws one column over another with matplotlib, in SI units, and the ends of each jump as points.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Where to draw; the current axes without it.
        x, y : str
            ``contact_radius``, ``indentation``, ``force``, or ``position`` of a machine.
        **style
            For ``Axes.plot``.

        Returns
        -------
        matplotlib.axes.Axes
            The axes, with labels.
        """
        if ax is None:
            from matplotlib import pyplot

            ax = pyplot.gca()
        ax.plot(self.to_dict()[x], self.to_dict()[y], **style)
        if "position" not in (x, y):
            for event in self.events:
                if event.kind in ("jump-in", "jump", "detached"):
                    ends = [[getattr(state, axis) for state in (event.before, event.after)] for axis in (x, y)]
                    ax.plot(ends[0], ends[1], "k.", ms=4)
        ax.set_xlabel(f"{x.replace('_', ' ')} / {'N' if x == 'force' else 'm'}")
        ax.set_ylabel(f"{y.replace('_', ' ')} / {'N' if y == 'force' else 'm'}")
        return ax

    def __repr__(self) -> str:
        kinds = ", ".join(event.kind for event in self.events)
        return f"<LoadingPath: {kinds}; {self.dissipated:.6g} J dissipated>"

    def _repr_html_(self) -> str:
        rows = [
            (event.kind, *(f"{x:.6g}" for x in (event.value, event.after.indentation, event.after.force, event.dissipated)))
            for event in self.events
        ]
        return html_table(("event", self.held, "indentation / m", "force / N", "dissipated / J"), rows)


def html_table(head: tuple[str, ...], rows: list[tuple[str, ...]]) -> str:
    """A table for a notebook."""

    def line(cells: tuple[str, ...], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in cells) + "</tr>"

    body = "".join(line(cells, "td") for cells in rows)
    return f"<table><thead>{line(head, 'th')}</thead><tbody>{body}</tbody></table>"
