"""What several tests share."""

from pathlib import Path

import pytest

import mdr

ROOT = Path(__file__).parents[3]


@pytest.fixture
def ball() -> mdr.Contact:
    """A sphere of 1 µm on rubber."""
    return mdr.jkr(radius=1e-6, e_star=1e6, work_of_adhesion=0.05)


@pytest.fixture
def wavy() -> mdr.Contact:
    """Figure 4 of the paper."""
    return mdr.Contact(mdr.WavyParaboloid(radius=1.0, amplitude=5e-4, wavelength=0.1), e_star=1.0, work_of_adhesion=1e-4)


@pytest.fixture
def scenes() -> Path:
    """The scenes of the repository."""
    return ROOT / "examples" / "scenes"


@pytest.fixture
def goldens() -> Path:
    """Their answers, as the command line prints them."""
    return ROOT / "tests" / "command_line" / "scenes"
