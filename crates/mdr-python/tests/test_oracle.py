"""Records and judge; and every number of the records through the contacts of this package."""

import json
import math
from decimal import Decimal
from pathlib import Path

import pytest

import mdr
from mdr import _core
from mdr.testing import cases

CRITICAL = "formula=critical status=ok control=force flag!=worst"


def test_the_release_is_that_of_the_records() -> None:
    assert mdr.RECORDS_RELEASE == max(json.loads(line)["release"] for line in _core.lines())
    assert len(mdr.records()) == len(_core.lines())


@pytest.mark.parametrize("record", cases("formula=critical control=force quantity=force id~jkr status=ok"))
def test_pull_off(record: mdr.Record) -> None:
    x = record.arguments
    record.check(-0.75 * math.pi * x["work_of_adhesion"] / x["c"])


def test_contacts_pass_the_judge() -> None:
    def ask(question: mdr.Record) -> mdr.AnswerLike:
        exact = question.inputs
        if question.quantity not in ("contact_radius", "indentation", "force") or "n" not in exact:
            return None
        contact = mdr.Contact(mdr.PowerLaw(exact["n"], exact["C"]), e_star=exact["E*"], work_of_adhesion=exact["w"])
        try:
            return getattr(contact.critical("force"), question.quantity)
        except mdr.OutOfRangeError as error:
            if question.quantity.replace("_", " ") not in error.quantity:
                return None  # a number beside one that is none
            return mdr.Answer(status="overflow" if error.log10 > 0 else "underflow")

    report = mdr.judge(ask, "formula=critical control=force profile=power status=ok")
    assert report.passed, report
    assert len(report.marks) > 20


def test_digits_are_those_of_the_records() -> None:
    asked = 0
    for record in mdr.records(CRITICAL):
        if record.quantity in ("contact_radius", "indentation", "force") and record.profile == "power":
            exact = record.inputs
            contact = mdr.Contact(mdr.PowerLaw(exact["n"], exact["C"]), e_star=exact["E*"], work_of_adhesion=exact["w"])
            assert getattr(contact.critical("force", digits=50), record.quantity) == record.value, record
            asked += 1
    assert asked > 20


def test_the_records_answer_themselves() -> None:
    report = mdr.judge(lambda record: mdr.Answer(record.nearest, status=record.status))
    assert report.passed, report
    assert report.questions == len(mdr.records())


def test_a_wrong_answer_is_told(tmp_path: Path) -> None:
    wrong = mdr.judge({"critical/jkr-unit/force/force": -2 * math.pi})
    assert not wrong.passed and wrong.marks[0].verdict == "wrong"
    assert "rigid sphere" in wrong.marks[0].reason
    with pytest.raises(AssertionError, match="wrong"):
        wrong.check()
    with pytest.raises(AssertionError, match="certified: -4.71"):
        mdr.record("critical/jkr-unit/force/force").check(-2 * math.pi)
    file = tmp_path / "answers.jsonl"
    file.write_text('{"id":"critical/jkr-unit/force/force","value":-4.71238898038469}\n')
    assert mdr.judge(file).passed and mdr.judge(file.read_text().splitlines()).passed
    with pytest.raises(TypeError):
        mdr.judge(str(file))


def test_a_claimed_error_is_judged() -> None:
    record = mdr.record("critical/jkr-unit/force/force")
    assert record.mark((record.nearest, 1e-15)).claim == "holds"
    assert record.mark(Decimal("-4.7123889803846898576939650749")).verdict == "right"
    assert record.mark((-4.7, 1e-9)).claim == "too-small"
