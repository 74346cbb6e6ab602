"""Adhesive contact of axisymmetric tips, JKR and beyond: doubles right to the last place, or certified digits.

All numbers are SI. Indentation and force are positive when pressed in; angles are slopes, tan θ. A parameter out of its domain
raises; a value at which nothing is in equilibrium is NaN, and its status says why.

>>> import mdr
>>> ball = mdr.jkr(radius=1e-6, e_star=1e6, work_of_adhesion=0.05)
>>> ball.critical("force")  # pull-off under a dead load
State(contact_radius=5.611652890227367e-07, indentation=-1.0496882720132389e-07, force=-2.356194490192345e-07)
"""

from typing import Final

from . import _media, _profiles
from ._afmformats import AfmCurve, from_afmformats
from ._contact import Contact, Control, Machine, Start
from ._core import CERTIFIED, PROGRAM
from ._core import VERSION as __version__
from ._errors import (
    DomainError, Error, FilterError, InternalError, NoConvergenceError, NoEquilibriumError, OutOfRangeError, SceneError,
    UndecidedError,
)
from ._fit import CertifiedEstimate, Estimate, Fit, Interval, fit
from ._functions import context, critical_states, effective_modulus, jkr, kappa
from ._media import *
from ._numbers import Floats, Number
from ._oracle import Answer, AnswerLike, Mark, Record, Report, judge, record, records
from ._profiles import *
from ._scene import File, Picture, Solution, solve
from ._states import Equilibria, Event, Fold, LoadingPath, State, States, Status, Trace

RECORDS_RELEASE: Final = 4

__all__ = [
    "CERTIFIED", "PROGRAM", "RECORDS_RELEASE", "__version__",
    "Contact", "Control", "Machine", "Start", "context", "critical_states", "effective_modulus", "jkr", "kappa",
    "Equilibria", "Event", "Fold", "LoadingPath", "State", "States", "Status", "Trace",
    "File", "Picture", "Solution", "solve",
    "AfmCurve", "CertifiedEstimate", "Estimate", "Fit", "Interval", "fit", "from_afmformats",
    "Answer", "AnswerLike", "Mark", "Record", "Report", "judge", "record", "records",
    "DomainError", "Error", "FilterError", "InternalError", "NoConvergenceError", "NoEquilibriumError", "OutOfRangeError",
    "SceneError", "UndecidedError",
    "Floats", "Number",
]
__all__ += _media.__all__ + _profiles.__all__
