"""Two works of adhesion: contacts whose edge is pinned when the motion turns."""

import math
import pickle

import numpy as np
import pytest

import mdr


def ball(advancing, receding):
    return mdr.Contact(mdr.Paraboloid(1), e_star=1, work_of_adhesion=(advancing, receding))


def test_loop_has_the_known_values():
    contact = ball("0.01", "40 mJ/m2")
    turn = 0.45**2 - math.sqrt(2 * math.pi * 0.45 * 0.01)
    loop = contact.path(indentation=[-0.3, turn, -0.3], start="detached")
    kinds = ["start", "jump-in", "way-point", "pinned", "depinned", "detached", "end"]
    assert [event.kind for event in loop.events] == kinds
    assert loop.work == pytest.approx(0.0252169966850600909, rel=1e-13)
    lost = sum(event.hysteresis for event in loop.events)
    assert lost == pytest.approx(0.0190851753705579339, rel=1e-13)
    jumps = {event.kind: event.dissipated - event.hysteresis for event in loop.events}
    assert jumps["jump-in"] == pytest.approx(0.00297911797558326511, rel=1e-12)
    assert jumps["detached"] == pytest.approx(0.00315270333891883188, rel=1e-12)
    assert loop.dissipated == pytest.approx(loop.work) and loop.stored == 0


def test_states_along_a_history():
    values = np.array([[-0.3, 0.0, 0.05], [0.05, -0.1, -0.3]])
    trace = ball(0.01, 0.04).follow(indentation=values, start="detached")
    assert trace.force.shape == values.shape and (trace.status == mdr.Status.OK).all()
    a = trace.contact_radius
    assert a[0, 1] == pytest.approx(0.39755140207189853674, rel=1e-14)
    # Pinned: the radius stays, and the force falls by 2E*a.
    assert a[0, 2] == a[1, 0] == a[1, 1]
    assert trace.force[1, 1] - trace.force[1, 0] == pytest.approx(-0.15 * 2 * a[1, 1], rel=1e-12)
    assert [jump.kind for jump in trace.jumps] == ["jump-in", "detached"]
    machine = ball(0.01, 0.04).follow(position=[-1, 1, -1], stiffness=0.3, start="detached")
    assert machine.position.tolist() == [-1, 1, -1]
    assert isinstance(ball(0.01, 0.04).follow(indentation=0.01, start="smallest").force, float)


def test_pull_off_depends_on_the_preload():
    contact = ball(0, 0.04)
    weak, strong = (contact.path(force=[-1, load, -1], start="detached").force.min() for load in (0.01, 1.0))
    assert strong == pytest.approx(-1.5 * math.pi * 0.04) and strong < weak < 0
    # The load that full pull-off needs is 3πw₂R/2.
    above, below = (
        contact.path(force=[-1, 1.5 * math.pi * 0.04 * factor, -1], start="detached").events[-2].before.force
        for factor in (1.001, 0.9)
    )
    assert above == pytest.approx(strong) and below > strong * 0.9999


def test_both_works_are_kept():
    contact = ball(0.01, "40 mJ/m2")
    assert contact.work_of_adhesion == (0.01, "40 mJ/m2")
    assert pickle.loads(pickle.dumps(contact)) == contact and hash(contact) == hash(ball(0.01, "40 mJ/m2"))
    assert contact == mdr.Contact(
        mdr.Paraboloid(1), e_star=1, work_of_adhesion={"receding": "40 mJ/m2", "advancing": 0.01}
    )
    # Equal ones are one.
    assert ball("0.04", "40 mJ/m2").work_of_adhesion == "40 mJ/m2"
    assert contact.at("receding").critical("force").force == mdr.jkr(1, 1, 0.04).critical("force").force
    scene = contact.scene("indentation", want=["folds"])
    assert scene["material"]["work_of_adhesion"] == {"advancing": 0.01, "receding": "40 mJ/m2"}
    assert {fold["edge"] for fold in mdr.solve(scene, digits=8)["folds"]} == {"advancing", "receding"}


@pytest.mark.parametrize(
    "ask",
    [
        lambda contact: contact.critical("force"),
        lambda contact: contact.pull_off("force"),
        lambda contact: contact.folds("force", digits=8),
        lambda contact: contact.energy(force=0),
        lambda contact: contact.states(force=0.0),
        lambda contact: contact.states(indentation=[0, 1]),
        lambda contact: contact.equilibria(force=0),
        lambda contact: contact.curve(0.1),
        lambda contact: contact.gap(1, contact_radius=0.1),
        lambda contact: contact.sensitivity("force"),
    ],
)
def test_what_takes_one_work_says_so(ask):
    with pytest.raises(ValueError, match="at\\('receding'\\)"):
        ask(ball(0.01, 0.04))


@pytest.mark.parametrize(
    ("works", "message"),
    [
        ((0.05, 0.04), "exchange the two"),
        ((-0.01, 0.04), "at least 0"),
        ((0, 0), "positive and finite"),
        ((0.01, math.inf), "positive and finite"),
        ((math.nan, 0.04), "no number"),
        ((0.01, 0.02, 0.04), "3 numbers"),
        ({"advancing": 0.01}, "keys"),
        (("0.01 N", 0.04), "work_of_adhesion"),
    ],
)
def test_refusals(works, message):
    with pytest.raises(ValueError, match=message):
        mdr.Contact(mdr.Paraboloid(1), e_star=1, work_of_adhesion=works)
    with pytest.raises(ValueError):
        ball(0.01, 0.04).path(force=[math.nan, 1])
    with pytest.raises(ValueError, match="edge"):
        ball(0.01, 0.04).at("both")
