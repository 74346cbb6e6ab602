"""Contacts: a profile and a material, and what may be asked of them."""

from __future__ import annotations

import dataclasses
import json
import math
from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction
from typing import Any, Literal, TypeAlias, Union, final, overload

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._edges import QUIET, Works, in_scene, works_of
from ._numbers import Floats, Number, array, digits_of, double, exact, plain, positive, shaped
from ._media import Medium
from ._profiles import Files, Profile
from ._states import Equilibria, Event, Fold, LoadingPath, State, States, Trace

_Row: TypeAlias = tuple[float, float, float]
_Happening: TypeAlias = tuple[str, float, _Row, _Row, float, float, Union[str, None]]


@final
@dataclasses.dataclass(frozen=True, slots=True)
class Machine:
    """A spring whose far end is held at ``position = indentation + force/stiffness``: a cantilever, a testing machine.

    Parameters
    ----------
    stiffness : Number
        In N/m, kept as given.
    """

    stiffness: Number

    def __post_init__(self) -> None:
        object.__setattr__(self, "stiffness", plain(self.stiffness))
        positive(self.stiffness, "stiffness", "the machine stiffness k")


# Differences over this relative step are exact to its square, and lose ten of the digits.
_STEP = Fraction(1, 10**10)
_DIGITS = 30
# Numbers of a medium to which there is no sensitivity.
_EXPONENTS = ("exponent", "nu", "flaw")

Control: TypeAlias = Union[Literal["indentation", "force"], Machine]
Start: TypeAlias = Literal["largest", "smallest", "detached"]


def core_of(
    profile: Profile, e_star: Number | None, work_of_adhesion: Number | tuple[Number, Number], medium: Medium | None = None
) -> _core.Contact:
    """The contact in Rust."""
    files: Files = {}
    scene: dict[str, Any] = {
        "profile": profile._scene(files),
        "material": {"work_of_adhesion": in_scene(work_of_adhesion, exactly=True)},
        "output": {"want": ["folds"]},
    }
    if e_star is not None:
        scene["material"]["e_star"] = exact(e_star, "e_star")
    if medium is not None:
        # By the force, which is controlled on every medium; each call names its own control.
        scene |= {"medium": medium._scene(), "control": {"kind": "force"}}
    return _core.Contact(json.dumps(scene), files)


@final
class Contact:
    """A profile in adhesive contact with an elastic medium, which is a half-space unless another one is given; immutable, hashable,
    to be pickled and shared between threads.

    The keyword that carries the values names the controlled quantity: ``indentation=``, ``force=``, or ``position=`` together with
    ``stiffness=``. Where there are no values it is ``"indentation"``, ``"force"`` or a :class:`Machine`.

    Parameters
    ----------
    profile : Profile
        What is pressed.
    e_star : Number
        The effective modulus E* in Pa; of two bodies :func:`effective_modulus`. :class:`Graded` and :class:`Winkler` media have
        their own modulus in its place.
    work_of_adhesion : Number, or a pair of them
        w in J/m²: the full work of separation, not half of it. ``(w1, w2)`` or ``{"advancing": w1, "receding": w2}`` are those of an
        edge that advances and of one that recedes, ``0 <= w1 <= w2``: :meth:`path`, :meth:`follow` and :meth:`scene` take both, all
        else that of one edge, :meth:`at`.
    medium : Medium, optional
        :class:`Graded`, :class:`Winkler`, :class:`Plane` or :class:`Periodic` instead of a half-space. Forces on the last two are
        per length, in N/m, and per area, in Pa.

    Raises
    ------
    DomainError
        A parameter is not positive and finite, or otherwise outside its domain.

    Examples
    --------
    >>> import mdr
    >>> cone = mdr.Contact(mdr.Cone(slope=0.1), e_star=1e6, work_of_adhesion=0.05)
    >>> cone
    Contact(Cone(slope=0.1), e_star=1000000.0, work_of_adhesion=0.05)
    >>> [fold.kind for fold in cone.folds("force")]
    ['minimum']
    >>> sticky = mdr.Contact(mdr.Paraboloid(1), e_star=1, work_of_adhesion=("10 mJ/m2", "40 mJ/m2"))
    >>> [event.kind for event in sticky.path(indentation=[-0.3, 0.05, -0.3], start="detached").events]
    ['start', 'jump-in', 'way-point', 'pinned', 'depinned', 'detached', 'end']
    """

    __slots__ = ("_profile", "_e_star", "_work", "_medium", "_core")

    @overload
    def __init__(self, profile: Profile, *, e_star: Number, work_of_adhesion: Works, medium: None = None) -> None: ...
    @overload
    def __init__(
        self, profile: Profile, *, e_star: Number | None = None, work_of_adhesion: Works, medium: Medium
    ) -> None: ...
    def __init__(
        self,
        profile: Profile,
        *,
        e_star: Number | None = None,
        work_of_adhesion: Works,
        medium: Medium | None = None,
    ) -> None:
        if medium is not None and not isinstance(medium, Medium):
            raise TypeError(f"medium: expected a Medium such as Winkler(modulus=1e9), got {type(medium).__name__}")
        if e_star is not None:
            positive(e_star, "e_star", "the effective modulus E*")
        elif medium is None or not medium._own_modulus:
            raise TypeError("e_star is missing: the effective modulus E* in Pa")
        self._profile, self._work, self._medium = profile, works_of(work_of_adhesion), medium
        self._e_star = None if e_star is None else plain(e_star)
        self._core = core_of(profile, e_star, self._work, medium)

    @property
    def profile(self) -> Profile:
        """What is pressed."""
        return self._profile

    @property
    def e_star(self) -> Number | None:
        """E* in Pa, as given; None on a medium that has its own modulus."""
        return self._e_star

    @property
    def work_of_adhesion(self) -> Number | tuple[Number, Number]:
        """w in J/m², as given; with two works of adhesion, that of an advancing and that of a receding edge."""
        return self._work

    def at(self, edge: Literal["advancing", "receding"]) -> Contact:
        """The contact with the work of adhesion of one edge alone.

        Examples
        --------
        >>> import mdr
        >>> sticky = mdr.Contact(mdr.Paraboloid(1), e_star=1, work_of_adhesion=(0.01, 0.04))
        >>> sticky.at("receding").work_of_adhesion
        0.04
        """
        if edge not in ("advancing", "receding"):
            raise ValueError(f"edge must be 'advancing' or 'receding', got {edge!r}")
        if not isinstance(self._work, tuple):
            return self
        return _contact(self._profile, self._e_star, self._work[edge == "receding"], self._medium)

    def _of_one(self, what: str) -> Number:
        """The work of adhesion of what has one."""
        if isinstance(self._work, tuple):
            raise ValueError(
                f"{what} takes one work of adhesion: ask contact.at('receding') or contact.at('advancing'); path, follow and "
                "scene take both"
            )
        return self._work

    @property
    def medium(self) -> Medium | None:
        """What it is pressed into; None for a homogeneous half-space."""
        return self._medium

    def _material(self) -> dict[str, Any]:
        """The table ``[material]`` of a scene."""
        modulus = {} if self._e_star is None else {"e_star": self._e_star}
        return modulus | {"work_of_adhesion": in_scene(self._work)}

    def __reduce__(self) -> tuple[Any, ...]:
        return _contact, (self._profile, self._e_star, self._work, self._medium)

    def __repr__(self) -> str:
        named: dict[str, Any] = self._material() | {"work_of_adhesion": self._work} | ({} if self._medium is None else {"medium": self._medium})
        return f"Contact({self._profile!r}, {', '.join(f'{name}={value!r}' for name, value in named.items())})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Contact) and self.__reduce__() == other.__reduce__()

    def __hash__(self) -> int:
        return hash((self._profile, self._e_star, self._work, self._medium))

    @overload
    def critical(self, control: Control, *, digits: None = None) -> State[float]: ...
    @overload
    def critical(self, control: Control, *, digits: int) -> State[Decimal]: ...
    def critical(self, control: Control, *, digits: int | None = None) -> State[float] | State[Decimal]:
        """The state in which the contact becomes unstable.

        Of a power law, paraboloid or cone it is the critical state of the theory: where the contact breaks (n > 1/2), or
        spreads over the whole surface (n < 1/2). Of any other profile it is where the contact comes off, as :meth:`pull_off`.

        Parameters
        ----------
        control : {"indentation", "force"} or Machine
            The controlled quantity. There is no default: pull-off at fixed grips and under a dead load differ.
        digits : int, optional
            So many certified digits as ``Decimal``, from 1 to 100 000; doubles without.

        Raises
        ------
        OutOfRangeError
            A double cannot hold the result; digits can.
        NoEquilibriumError
            There is none.

        Examples
        --------
        >>> import mdr
        >>> ball = mdr.jkr(radius="1e-6", e_star="1e6", work_of_adhesion="0.05")
        >>> ball.critical("force").force  # −3/2 πwR
        -2.356194490192345e-07
        >>> ball.critical("force", digits=30).force
        Decimal('-2.35619449019234492884698253746E-7')
        """
        self._of_one("critical")
        held, stiffness = held_by(control)
        k = None if stiffness is None else exact(stiffness, "stiffness")
        if digits is None:
            return State(*self._core.critical(held, k))
        a, d, force = self._core.certified(held, digits_of(digits), k)
        return State(a, d, force)

    def pull_off(self, control: Control) -> State[float]:
        """The state from which the contact comes off, drawn back slowly from the value 0 of the controlled quantity.

        Of a rough or wavy profile the strongest pull on the way may be larger: that is ``path(…).force.min()``.
        """
        self._of_one("pull_off")
        held, stiffness = held_by(control)
        return State(*self._core.pull_off(held, stiffness_of(stiffness)))

    @overload
    def folds(self, control: Control, *, digits: None = None) -> tuple[Fold[float], ...]: ...
    @overload
    def folds(self, control: Control, *, digits: int) -> tuple[Fold[Decimal], ...]: ...
    def folds(
        self, control: Control, *, digits: int | None = None
    ) -> tuple[Fold[float], ...] | tuple[Fold[Decimal], ...]:
        """All instabilities that are found, by increasing contact radius.

        Parameters
        ----------
        control : {"indentation", "force"} or Machine
            The controlled quantity.
        digits : int, optional
            So many certified digits as ``Decimal``, each proved; whether it is also proved that there are no other folds is
            said by ``solve(contact.scene(control, want=["folds"])).complete``.

        Examples
        --------
        >>> import mdr
        >>> tip = mdr.Contact(mdr.WavyParaboloid("1", "5e-4", "0.1"), e_star=1, work_of_adhesion="1e-4")
        >>> [(fold.kind, fold.force) for fold in tip.folds("indentation", digits=6)][0]
        ('minimum', Decimal('-0.000106943'))
        """
        self._of_one("folds")
        held, stiffness = held_by(control)
        if digits is None:
            return tuple(Fold(*fold) for fold in self._core.folds(held, stiffness_of(stiffness)))
        from ._scene import solve

        rows = solve(self.scene(control, want=["folds"]), digits=digits)["folds"]
        return tuple(
            Fold(row["contact_radius"], row["indentation"], row["force"], row["kind"]) for row in rows if "kind" in row
        )

    def energy(
        self,
        *,
        indentation: ArrayLike | None = None,
        force: ArrayLike | None = None,
        position: ArrayLike | None = None,
        stiffness: Number | None = None,
    ) -> Floats:
        """The potential energy in J of the states of :meth:`states`: elastic energy less work of adhesion times contact area,
        of the contact alone, without a dead load or the spring of a machine; NaN where nothing is in equilibrium.

        In f64, for hundreds of values rather than for millions.

        Examples
        --------
        >>> import mdr
        >>> ball = mdr.jkr(radius=1e-6, e_star=1e6, work_of_adhesion=0.05)
        >>> down, up = ball.energy(indentation=[2e-7 - 1e-12, 2e-7 + 1e-12]).tolist()
        >>> force = ball.states(indentation=2e-7).force
        >>> bool(abs((up - down) / 2e-12 / force - 1) < 1e-3)  # the force is the slope of the energy
        True
        """
        self._of_one("energy")
        held, flat, shape, k = _held_values(indentation, force, position, stiffness)
        from ._scene import solve

        control: Control = "force" if held == "force" else "indentation"
        if stiffness is not None:
            control = Machine(stiffness)
        known = np.isfinite(flat)
        energies = np.full(len(flat), np.nan)
        if known.any():
            values = [float(value) for value in flat[known]]
            output = {"want": ["energy"], "equilibria": {"at": values}, "path": values[:1]}
            rows = solve(self.scene(control, **output), f64=True)["energy"]
            found = [[state["energy"] for state in row["states"] if state["stable"]] for row in rows]
            energies[known] = [states[-1] if states and states[-1] is not None else np.nan for states in found]
        result: Floats = shaped(energies, shape)
        return result

    def sensitivity(self, control: Control) -> dict[str, State[float]]:
        """How the critical state depends on each input: d ln(result)/d ln(input), to about twelve digits.

        An error of 1 % in an input moves a result by so many percent. Central differences of certified digits, so that
        nothing cancels; an integer exponent n has none, and k, Poisson's ratio and the flaw of a medium are left out. Other numbers of a medium
        are called ``medium.coefficient`` and so on. NaN for a result that is 0.

        Raises
        ------
        TypeError
            The profile is a sum, a formula or a table.

        Examples
        --------
        >>> import mdr
        >>> ball = mdr.jkr(radius=1e-6, e_star=1e6, work_of_adhesion=0.05)
        >>> found = ball.sensitivity("force")
        >>> {name: round(state.force, 9) + 0 for name, state in found.items()}  # F = −3/2 πwR
        {'radius': 1.0, 'e_star': 0.0, 'work_of_adhesion': 1.0}
        >>> round(found["e_star"].contact_radius, 9)
        -0.333333333
        """
        held, stiffness = held_by(control)
        inputs: dict[str, Number] = {name: value for name, value in self._profile.parameters.items() if name != "n"}
        if not inputs or set(self._profile.parameters) != {field.name for field in dataclasses.fields(self._profile)}:
            raise TypeError(f"no sensitivity to the parameters of {self._profile!r}")
        inputs |= self._material() | {"work_of_adhesion": self._of_one("sensitivity")}
        of_medium = [] if self._medium is None else [name for name in self._medium.parameters if name not in _EXPONENTS]
        inputs |= {f"medium.{name}": self._medium.parameters[name] for name in of_medium if self._medium is not None}
        if stiffness is not None:
            inputs["stiffness"] = stiffness

        def stated(name: str) -> str:
            """A number without its unit."""
            own = name.removeprefix("medium.")
            if self._medium is None or own == name:
                return exact(inputs[name], name)
            return str(self._medium._scene()[own])

        def state(name: str, factor: Fraction) -> State[Decimal]:
            values = inputs | {name: Fraction(stated(name)) * factor}
            shape = dataclasses.replace(self._profile, **{key: values[key] for key in self._profile.parameters if key != "n"})
            medium = self._medium and dataclasses.replace(self._medium, **{key: values[f"medium.{key}"] for key in of_medium})
            contact = _contact(shape, values.get("e_star"), values["work_of_adhesion"], medium)
            return contact.critical(Machine(values["stiffness"]) if "stiffness" in values else control, digits=_DIGITS)

        def slope(lower: Decimal, upper: Decimal) -> float:
            above, below = Fraction(upper), Fraction(lower)
            middle = (above + below) / 2
            return float((above - below) / middle / (2 * _STEP)) if middle else math.nan

        found = {}
        for name in inputs:
            low, high = state(name, 1 - _STEP), state(name, 1 + _STEP)
            pairs = zip(low.to_dict().values(), high.to_dict().values())
            found[name] = State(*(slope(lower, upper) for lower, upper in pairs))
        return found

    def states(
        self,
        *,
        indentation: ArrayLike | None = None,
        force: ArrayLike | None = None,
        position: ArrayLike | None = None,
        stiffness: Number | None = None,
        branch: Literal["largest", "smallest"] = "largest",
    ) -> States:
        """The stable equilibrium at each value, as if each were asked alone.

        Parameters
        ----------
        indentation, force, position : array_like
            Values of the controlled quantity, exactly one of the three, of any shape.
        stiffness : Number
            Of the machine, with ``position``.
        branch : {"largest", "smallest"}
            Which one, where there are several.

        Returns
        -------
        States
            NaN where nothing is in equilibrium.

        Examples
        --------
        >>> import mdr
        >>> ball = mdr.jkr(radius=1e-6, e_star=1e6, work_of_adhesion=0.05)
        >>> states = ball.states(force=[-3e-7, 0, 1e-6])
        >>> states
        <States of shape (3,), 2 in equilibrium>
        >>> mdr.Status(states.status[0])
        <Status.NO_EQUILIBRIUM: 2>
        """
        self._of_one("states")
        if branch not in ("largest", "smallest"):
            raise ValueError(f"branch must be 'largest' or 'smallest', got {branch!r}")
        # One double needs no arrays on its way.
        if isinstance(force, float) and indentation is position is stiffness is None:
            return _scalar(self._core.state(force, "force", None, branch == "largest"))
        if isinstance(indentation, float) and force is position is stiffness is None:
            return _scalar(self._core.state(indentation, "indentation", None, branch == "largest"))
        if isinstance(position, float) and isinstance(stiffness, float) and indentation is force is None:
            positive(stiffness, "stiffness", "the machine stiffness k")
            return _scalar(self._core.state(position, "position", stiffness, branch == "largest"))
        held, flat, shape, k = _held_values(indentation, force, position, stiffness)
        columns, status = self._core.states(flat, held, k, branch == "largest")
        return States(*(shaped(column, shape) for column in (*columns, status)))

    def equilibria(
        self,
        *,
        indentation: ArrayLike | None = None,
        force: ArrayLike | None = None,
        position: ArrayLike | None = None,
        stiffness: Number | None = None,
    ) -> Equilibria:
        """All equilibria at each value, stable or not, a column for each branch; parameters as those of :meth:`states`.

        Examples
        --------
        >>> import mdr
        >>> ball = mdr.jkr(radius=1e-6, e_star=1e6, work_of_adhesion=0.05)
        >>> both = ball.equilibria(force=[-2e-7, -1e-7])
        >>> both.contact_radius.shape, both.stable.tolist(), both.count.tolist()
        ((2, 2), [False, True], [2, 2])
        """
        self._of_one("equilibria")
        held, flat, shape, k = _held_values(indentation, force, position, stiffness)
        columns, admissible, stable, status = self._core.equilibria(flat, held, k)

        def by_branch(column: Any) -> Any:
            return np.moveaxis(column.reshape(len(stable), *shape), 0, -1)

        a, d, f, reached = (by_branch(column) for column in (*columns, admissible))
        return Equilibria(a, d, f, stable, reached, shaped(status, shape))

    def curve(self, contact_radius: ArrayLike) -> States:
        """The equilibrium with each contact radius, stable or not; ``DOMAIN_ERROR`` outside of the profile."""
        self._of_one("curve")
        radii, shape = array(contact_radius, "contact_radius")
        columns, status = self._core.curve(radii)
        return States(*(shaped(column, shape) for column in (*columns, status)))

    def pressure(self, r: ArrayLike, *, contact_radius: float) -> Floats:
        """The normal pressure in Pa within the equilibrium with this contact radius, at radii r of any shape.

        NaN where it is infinite, as at the edge, and outside of the contact.

        Examples
        --------
        >>> import mdr
        >>> ball = mdr.jkr(radius=1, e_star=1, work_of_adhesion=1e-3)
        >>> a = ball.states(force=0).contact_radius
        >>> bool(ball.pressure(0, contact_radius=a) > 0 > ball.pressure(0.99 * a, contact_radius=a))
        True
        """
        return self._field("pressure", r, contact_radius)

    def gap(self, r: ArrayLike, *, contact_radius: float) -> Floats:
        """The gap in m outside of the equilibrium with this contact radius; NaN within the contact."""
        return self._field("gap", r, contact_radius)

    def displacement(self, r: ArrayLike, *, contact_radius: float) -> Floats:
        """The displacement in m, into the half-space, of the surface outside of the equilibrium; NaN within the contact."""
        return self._field("displacement", r, contact_radius)

    def _field(self, name: str, r: ArrayLike, contact_radius: float) -> Floats:
        self._of_one(name)
        radii, shape = array(r, "r")
        field: Floats = shaped(self._core.field(name, double(contact_radius, "contact_radius"), radii), shape)
        return field

    def follow(
        self,
        *,
        indentation: ArrayLike | None = None,
        force: ArrayLike | None = None,
        position: ArrayLike | None = None,
        stiffness: Number | None = None,
        start: Start = "largest",
    ) -> Trace:
        """What the contact does while it is moved slowly from value to value: a state for each, to be compared with a
        measurement.

        Parameters
        ----------
        indentation, force, position, stiffness
            As those of :meth:`states`; values in the order of time.
        start : {"largest", "smallest", "detached"}
            The state at the first value.

        Raises
        ------
        NoEquilibriumError
            There is no such state at the first value.
        """
        held, flat, shape, k = _held_values(indentation, force, position, stiffness)
        columns, status, jumps = self._core.follow(flat, held, k, start)
        at = flat.reshape(shape) if held == "position" else None
        a, d, f, status = (shaped(column, shape) for column in (*columns, status))
        quiet = QUIET if isinstance(self._work, tuple) else ()
        return Trace(a, d, f, status, at, tuple(_event(jump) for jump in jumps if jump[0] not in quiet))

    def path(
        self,
        *,
        indentation: ArrayLike | None = None,
        force: ArrayLike | None = None,
        position: ArrayLike | None = None,
        stiffness: Number | None = None,
        start: Start = "largest",
        samples: int = 200,
    ) -> LoadingPath:
        """What happens between way points, with its energy, and a curve to be drawn.

        Parameters
        ----------
        indentation, force, position, stiffness, start
            As those of :meth:`follow`; the values are way points.
        samples : int
            States between each two events between which the edge moves.

        Examples
        --------
        >>> import mdr
        >>> ball = mdr.jkr(radius=1e-6, e_star=1e6, work_of_adhesion=0.05)
        >>> pulled = ball.path(position=[0, -1e-5], stiffness=0.1)
        >>> [event.kind for event in pulled.events]
        ['start', 'detached', 'end']
        >>> float(pulled.force.min()) == ball.critical(mdr.Machine(0.1)).force
        False
        """
        held, flat, _, k = _held_values(indentation, force, position, stiffness)
        happenings, (a, d, f), balance = self._core.path(flat, held, k, start, samples)
        events = tuple(_event(event) for event in happenings)
        lost = sum(event.dissipated for event in events)
        work, dissipated, stored = balance or (lost, lost, float("nan"))
        at = None if k is None else d + f / k
        return LoadingPath(events, a, d, f, at, work, dissipated, stored, held)

    def validity(self, range_of_adhesion: Number | str, *, digits: int | None = None) -> dict[str, Any]:
        """Whether the theory, which is that of adhesion of short range, holds for this contact.

        Parameters
        ----------
        range_of_adhesion : Number or str
            The range z₀ of the attraction in m, or with its unit: ``"0.3 nm"``. There is no default: 0.16 nm and 0.3 nm are
            both in use.
        digits : int, optional
            So many digits, as ``Decimal``, proved where that can be; doubles without.

        Returns
        -------
        dict
            With the keys of ``validity`` in an answer: Tabor's number ``tabor`` at the pull-off under a dead load, ``regime``
            (``"JKR"`` above 5, ``"transition"``, ``"DMT"`` below 0.1), ``maugis_dugdale_pull_off`` and its ``correction``,
            that force over the one of short range less 1, ``slope`` and ``a_over_r``, which should be small, ``admissible``.

        Examples
        --------
        >>> import mdr
        >>> tip = mdr.jkr(radius="1e-8", e_star="5e9", work_of_adhesion="0.05")
        >>> holds = tip.validity("0.3 nm")
        >>> holds["regime"], round(holds["tabor"], 3), round(holds["correction"], 3)
        ('transition', 0.333, 0.179)
        """
        from ._scene import solve

        scene = self.scene("force", want=["folds"])
        scene["material"]["range_of_adhesion"] = range_of_adhesion
        validity = solve(scene, digits=digits, f64=digits is None).validity
        assert validity is not None
        return validity

    def scene(self, control: Control, **output: Any) -> dict[str, Any]:
        """The scene of this contact, for :func:`solve`.

        Parameters
        ----------
        control : {"indentation", "force"} or Machine
            The controlled quantity.
        **output
            ``path`` and ``start`` of the control; all else is of the table ``[output]``, such as ``want=["folds"]``.
        """
        held, stiffness = held_by(control)
        by: dict[str, Any] = {"kind": held} if stiffness is None else {"kind": "machine", "stiffness": stiffness}
        by |= {key: output.pop(key) for key in ("path", "start") if key in output}
        scene = {"material": self._material(), "profile": self._profile, "control": by, "output": output}
        return scene if self._medium is None else scene | {"medium": self._medium}


def _contact(profile: Profile, e_star: Number | None, work_of_adhesion: Works, medium: Medium | None = None) -> Contact:
    if medium is None:
        assert e_star is not None
        return Contact(profile, e_star=e_star, work_of_adhesion=work_of_adhesion)
    return Contact(profile, e_star=e_star, work_of_adhesion=work_of_adhesion, medium=medium)


def held_by(control: Control) -> tuple[str, Number | None]:
    """The controlled quantity, and the stiffness of a machine."""
    if isinstance(control, Machine):
        return "position", control.stiffness
    if control in ("indentation", "force"):
        return control, None
    raise ValueError(f"control must be 'indentation', 'force' or a Machine, got {control!r}")


def stiffness_of(stiffness: Number | None) -> float | None:
    """That of a machine as a double."""
    return None if stiffness is None else double(stiffness, "stiffness")


def _held_values(
    indentation: ArrayLike | None, force: ArrayLike | None, position: ArrayLike | None, stiffness: Number | None
) -> tuple[str, Floats, tuple[int, ...], float | None]:
    named: Mapping[str, ArrayLike | None] = {"indentation": indentation, "force": force, "position": position}
    given = [(name, values) for name, values in named.items() if values is not None]
    if len(given) != 1:
        raise TypeError("give the values of exactly one of indentation, force and position")
    held, values = given[0]
    if (held == "position") != (stiffness is not None):
        raise TypeError("position and stiffness go together: position = indentation + force/stiffness")
    if stiffness is not None:
        positive(stiffness, "stiffness", "the machine stiffness k")
    flat, shape = array(values, held)
    return held, flat, shape, stiffness_of(stiffness)


def _scalar(state: tuple[_Row, int]) -> States:
    (a, d, force), status = state
    numbers: Any = np.float64(a), np.float64(d), np.float64(force), np.int8(status)
    return States(*numbers)


def _event(row: _Happening) -> Event:
    kind, value, before, after, dissipated, hysteresis, edge = row
    return Event(kind, value, State(*before), State(*after), dissipated, hysteresis, edge)
