"""Typed uses of the package, for `mypy --strict`: what users see of the types."""

from decimal import Decimal
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

import mdr


def pull_off() -> float:
    ball: mdr.Contact = mdr.jkr(radius=1e-6, e_star="1e6", work_of_adhesion=Fraction(1, 20))
    state: mdr.State[float] = ball.critical("force")
    return state.force


def certified(control: mdr.Control) -> Decimal:
    state: mdr.State[Decimal] = mdr.jkr("1e-6", 1e6, Decimal("0.05")).critical(control, digits=50)
    return state.force / mdr.kappa(2, digits=50)


def arrays(force: NDArray[np.float64]) -> NDArray[np.float64]:
    tip = mdr.Contact(mdr.Paraboloid(1) + mdr.Cone(0.01), e_star=1, work_of_adhesion=1e-3)
    states: mdr.States = tip.states(force=force)
    both: mdr.Equilibria = tip.equilibria(position=[0, 1], stiffness=2)
    most = int(both.count.max())
    known: NDArray[np.float64] = states.force[states.status == mdr.Status.OK]
    return known[:most]


def history() -> list[str]:
    wavy = mdr.Contact(mdr.WavyParaboloid(1, 5e-4, 0.1), e_star=1, work_of_adhesion=1e-4)
    trace: mdr.Trace = wavy.follow(indentation=[0, -0.01])
    path: mdr.LoadingPath = wavy.path(position=[0, -0.02], stiffness=5)
    assert path.position is not None
    return [event.kind for event in (*trace.jumps, *path.events)]


def scene() -> str:
    answer: mdr.Solution = mdr.solve({"profile": mdr.Sphere(1), "output": {"want": ["transform"]}}, digits=30)
    return answer.to_json()


def judged(question: mdr.Record) -> mdr.AnswerLike:
    x = question.arguments
    return -0.75 * np.pi * x["work_of_adhesion"] / x["c"] if x.get("n") == 2 else None


def report() -> bool:
    report: mdr.Report = mdr.judge(judged, "formula=critical")
    try:
        mdr.records("colour=red")
    except mdr.FilterError:
        pass
    except mdr.DomainError as error:
        print(error.quantity, error.requirement)
    return report.passed
