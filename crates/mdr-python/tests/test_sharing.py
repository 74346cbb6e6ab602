"""Contacts, answers and errors between processes and threads."""

import copy
import pickle
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context

import numpy as np
import pytest

import mdr

CONTACTS = [
    mdr.jkr("1e-6", 1e6, 0.05),
    mdr.Contact(mdr.Paraboloid(1) + mdr.Cone("0.01"), e_star=1, work_of_adhesion="1/1000"),
    mdr.Contact(mdr.Expression("r^2/(2*R) + r^4/(8*H^3)", R=1, H="1/2"), e_star=1, work_of_adhesion="1e-3"),
    mdr.Contact(mdr.Table([0, 1, 2, 3], [0, 1, 4, 9], offset=0), e_star=1, work_of_adhesion=1),
]


def pull(contact: mdr.Contact) -> mdr.State[float]:
    return contact.critical("force")


@pytest.mark.parametrize("contact", CONTACTS, ids=lambda contact: contact.profile.kind)
def test_contacts_are_values(contact: mdr.Contact) -> None:
    again = pickle.loads(pickle.dumps(contact))
    assert again == contact and hash(again) == hash(contact) and again is not contact
    assert again.critical("force") == contact.critical("force")
    assert copy.deepcopy(contact) == contact
    assert contact != mdr.Contact(contact.profile, e_star=3, work_of_adhesion=1)
    with pytest.raises(AttributeError):
        contact.e_star = 1


def test_answers_are_pickled(ball: mdr.Contact) -> None:
    for answer in (ball.critical("force"), ball.critical("force", digits=20), ball.folds("force"), mdr.Machine(1)):
        assert pickle.loads(pickle.dumps(answer)) == answer
    states = pickle.loads(pickle.dumps(ball.states(force=[0, 1])))
    assert states.force.tolist() == [0, 1]
    path = pickle.loads(pickle.dumps(ball.path(indentation=[0, -1])))
    assert path.events == ball.path(indentation=[0, -1]).events
    solution = mdr.solve(ball.scene("force", want=["folds"]))
    assert dict(pickle.loads(pickle.dumps(solution))) == dict(solution)
    scene = ball.scene("force", want=["folds"])
    assert pickle.loads(pickle.dumps(scene)) == scene
    for profile in (mdr.Expression("r^2/2"), mdr.Table([0, 1, 2, 3], [0, 1, 4, 9]), mdr.Cone(slope=1) + mdr.Paraboloid(radius=1)):
        assert pickle.loads(pickle.dumps(profile)) == profile
    record = mdr.records()[0]
    assert pickle.loads(pickle.dumps(record)) is record


def test_fits_are_pickled(ball: mdr.Contact) -> None:
    depth = np.linspace(1e-6, -1e-7, 30)
    force = ball.states(indentation=depth).force
    fit = mdr.fit(depth, force, profile=ball.profile, observation="F(d)")
    again = pickle.loads(pickle.dumps(fit))
    assert again.to_json() == fit.to_json() and repr(again) == repr(fit)
    assert str(again.plot()) == str(fit.plot())


def test_answers_are_frozen(ball: mdr.Contact) -> None:
    for answer in (ball.critical("force"), ball.states(force=0), ball.profile):
        with pytest.raises(AttributeError):
            answer.force = 1


def test_errors_are_pickled() -> None:
    error = mdr.DomainError("text", "quantity", "value", "requirement")
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is mdr.DomainError and again.args == error.args and again.value == "value"


def test_processes() -> None:
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        assert list(pool.map(pull, CONTACTS)) == [pull(contact) for contact in CONTACTS]


def test_threads() -> None:
    force = np.linspace(-1e-7, 1e-6, 10_000)
    alone = CONTACTS[0].states(force=force).contact_radius
    with ThreadPoolExecutor(4) as pool:
        for states in pool.map(lambda _: CONTACTS[0].states(force=force), range(16)):
            assert np.array_equal(states.contact_radius, alone)
