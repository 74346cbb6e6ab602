"""Scenes through the library give what the command line gives."""

import json
import signal
import threading
import time
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

import mdr

QUICK = ["power", "paraboloid", "cone", "sphere", "flat-punch", "figure-4", "machine", "sum", "table", "transform"]


@pytest.mark.parametrize("name", QUICK)
def test_an_answer_is_that_of_the_program(name: str, scenes: Path, goldens: Path) -> None:
    answer = mdr.solve(scenes / f"{name}.toml")
    written = json.loads(answer.to_json())
    assert written.pop("program") == mdr.PROGRAM
    assert written == json.loads((goldens / f"{name}.json").read_text())


def test_a_dict_a_text_and_a_file_are_one_scene(scenes: Path) -> None:
    scene = {
        "material": {"e_star": 1, "work_of_adhesion": 1e-4},
        "profile": {"kind": "wavy-paraboloid", "radius": np.float64(1.0), "amplitude": 5e-4, "wavelength": 0.1},
        "control": {"kind": "indentation", "path": np.array([0, -0.01])},
        "output": {"want": ["folds", "path"]},
    }
    answer = mdr.solve(scene, digits=30)
    assert repr(answer) == "<Solution: folds (3, certified), path (4, certified)>"
    assert answer["folds"][0]["force"] == Decimal("-0.000106943495831304675418439773734")
    assert answer.complete["folds"]["proved"]
    file = scenes / "figure-4.toml"
    assert dict(mdr.solve(file, digits=30)) == dict(answer) == dict(mdr.solve(file.read_text(), digits=30))
    assert answer.balance is not None and isinstance(answer.balance["work"], Decimal)
    assert answer.columns("path")["event"] == ["start", "jump", "detached", "end"]


def test_a_contact_makes_a_scene(wavy: mdr.Contact) -> None:
    fast = mdr.solve(wavy.scene("indentation", want=["folds"]), f64=True)
    forces = [record["force"] for record in fast["folds"]]
    assert all(isinstance(force, float) for force in forces)
    assert forces == pytest.approx([fold.force for fold in wavy.folds("indentation")], rel=1e-12)
    held = mdr.solve(wavy.scene(mdr.Machine("1/3"), want=["path"], path=[0, -1]), f64=True)
    assert held["path"][-1]["event"] == "end"
    curve = mdr.solve(wavy.scene("indentation", want=["force-curve"], path=[0, "-1/100"], points=50), f64=True)
    assert curve.force_curve_summary is not None and min(curve.columns("force-curve")["force"]) < -6e-4


def test_a_table_goes_with_its_scene(tmp_path: Path) -> None:
    r = np.linspace(0, 1, 21)
    tip = mdr.Contact(mdr.Table(r, r**2 / 2), e_star=1, work_of_adhesion="1e-3")
    (fold,) = mdr.solve(tip.scene("force", want=["folds"]))["folds"]
    assert fold["force"] == pytest.approx(-1.5e-3 * np.pi, rel=1e-2)
    file = tmp_path / "tip.csv"
    file.write_text("r,f\nnm,nm\n" + "".join(f"{x * 1e9},{x * x * 5e8}\n" for x in r))
    read = mdr.Contact(mdr.Table.read_csv(file), e_star=1, work_of_adhesion="1e-3")
    assert read.critical("force").force == pytest.approx(tip.critical("force").force, rel=1e-6)


def test_a_solution_is_drawn(wavy: mdr.Contact, tmp_path: Path) -> None:
    picture = mdr.solve(wavy.scene("indentation", want=["path"], path=[0, "-0.01"]), f64=True).picture()
    picture.save(tmp_path / "wavy.svg")
    assert ElementTree.parse(tmp_path / "wavy.svg").getroot().tag.endswith("svg")
    assert picture._repr_svg_() == (tmp_path / "wavy.svg").read_text(encoding="utf-8")


def test_numbers_are_exact_as_typed() -> None:
    def force(radius: mdr.Number) -> Decimal:
        scene = mdr.jkr(radius, 1, "0.05").scene("force", want=["folds"])
        value = mdr.solve(scene, digits=40)["folds"][0]["force"]
        assert isinstance(value, Decimal)
        return value

    assert force(0.1) == force("0.1") == force(Decimal("0.1")) == force(Fraction(1, 10)) == force("1/10")
    assert force(Fraction(0.1)) != force(0.1)


def prove_folds() -> None:
    mdr.solve(mdr.Contact(mdr.Sphere(1), e_star=1, work_of_adhesion="1e-3").scene("force", want=["folds"]), digits=100_000)


def many_digits() -> None:
    mdr.Contact(mdr.PowerLaw("1.3717", 1), e_star=1, work_of_adhesion=1).critical("force", digits=30_000)


@pytest.mark.parametrize("work", [prove_folds, many_digits])
def test_a_signal_stops_a_long_computation(work: Callable[[], None]) -> None:
    class Ring(Exception):
        pass

    def ring(*_: object) -> None:
        raise Ring

    before = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, 0.3)
    began = time.monotonic()
    try:
        with pytest.raises(Ring):
            work()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert time.monotonic() - began < 20


def test_other_threads_go_on_meanwhile(ball: mdr.Contact) -> None:
    ticks = 0
    done = threading.Event()

    def count() -> None:
        nonlocal ticks
        while not done.is_set():
            ticks += 1
            time.sleep(0.001)

    counter = threading.Thread(target=count)
    counter.start()
    began = time.monotonic()
    while time.monotonic() - began < 0.2:
        ball.critical("force", digits=3000)
    done.set()
    counter.join()
    assert ticks > 20
