"""The data are whole, and derived numbers are those of the package with native code."""

import math

import mdr_vectors
import pytest


def test_all_are_there() -> None:
    vectors = mdr_vectors.load()
    assert len({vector.id for vector in vectors}) == len(vectors) == 1994
    physical = {vector.id.split("/")[1] for vector in mdr_vectors.load(flag="physical", formula="critical")}
    assert physical >= {"afm-tip", "pdms-bead", "gecko-spatula", "glass-bead", "wheel-on-rail"}
    assert len(mdr_vectors.table()) == 43


def test_nothing_chosen_is_refused() -> None:
    for where in ({"formula": "crtical"}, {"n": "two"}, {"id": "critical", "control": "force"}):
        with pytest.raises(ValueError, match="no vector"):
            mdr_vectors.load(**where)
    with pytest.raises(ValueError, match="jkr-sphere"):
        mdr_vectors.table("sphere")


def test_numbers_are_those_of_the_judge() -> None:
    mdr = pytest.importorskip("mdr")
    for vector in mdr_vectors.load():
        record = mdr.record(vector.id)
        assert vector.tolerance == record.tolerance, vector
        if vector.status in ("ok", "fold"):
            assert vector.nearest == record.nearest, vector
        elif vector.value is None:
            assert math.isnan(vector.nearest), vector
