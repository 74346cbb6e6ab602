"""Certified records as cases of pytest, each named by its id.

    pip install mdr-contact pytest
    pytest test_my_jkr.py
"""

import math

import pytest

import my_jkr
from mdr import Answer, Record, judge, testing

RADII = "formula=equilibrium control=force quantity=contact_radius flag=outer"


@pytest.mark.parametrize("record", testing.records("formula=critical control=force quantity=force status=ok", n=2))
def test_pull_off(record: Record) -> None:
    given = record.arguments
    record.check(my_jkr.pull_off_force(given["n"], given["c"], given["work_of_adhesion"]))


def test_all_radii_at_once() -> None:
    """The judge tells a bad algorithm from a badly conditioned question, and names a mistaken convention."""

    def answer(record: Record) -> Answer | None:
        radius = my_jkr.contact_radius(**record.arguments)
        if radius is None:
            return None
        return Answer(status="no-equilibrium") if math.isnan(radius) else Answer(radius)

    judge(answer, RADII).check()
