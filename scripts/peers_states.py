#!/usr/bin/env python3
"""Times of states in arrays beside numpy's cbrt of as many values, and of single states beside a call of a Python function.

    make peers-states

All take turns in one process, and the fastest turn of each counts: ratios hold within one run. A state is a contact radius, a depth,
a force and a status. The cbrt of numpy is the dearest part of the formula of JKR under a dead load; where numpy has it in vectors it takes
a nanosecond, less than writing the columns of a state. So the whole formula in numpy, for contact radius and depth alone, is measured too.
"""

import time

import mdr
import numpy as np

VALUES, TURNS, SINGLE = 10**6, 15, 2000
CONTROLS = ("force", "indentation", "position")
STIFFNESS, WORK = 0.1, 1e-3


def profiles():
    return {
        "power law n = 2": mdr.Paraboloid(1),
        "power law n = 1": mdr.Cone(slope=0.1),
        "power law n = 1.7": mdr.PowerLaw(1.7, 1),
        "hyperboloid": mdr.Hyperboloid(slope=1, lateral=0.3),
        "sphere": mdr.Sphere(1),
        "rounded punch": mdr.RoundedPunch(1, 0.2),
        "wavy paraboloid": mdr.WavyParaboloid(1, 5e-4, 0.1),
    }


def values_of(contact, control):
    """Values from just above the lowest fold to four times as far on the other side of zero, in no order."""
    held = mdr.Machine(STIFFNESS) if control == "position" else control
    folds = contact.folds(held)
    lowest = {
        "force": lambda fold: fold.force,
        "indentation": lambda fold: fold.indentation,
        "position": lambda fold: fold.indentation + fold.force / STIFFNESS,
    }
    low = min(map(lowest[control], folds), default=-1e-3)
    return low * (0.999 - 5 * (np.arange(VALUES) * 0.618033988749895 % 1))


def question(contact, control, values, **more):
    """Keywords of a question at these values."""
    stiffness = {"stiffness": STIFFNESS} if control == "position" else {}
    return {control: values} | stiffness | more


def plain(*, force):
    """As little as a function can do with a keyword."""
    return float(force)


def jkr_by_hand(force, radius=1.0, e_star=1.0, work=WORK):
    """Contact radius and depth under a dead load, as a user writes them in numpy."""
    pull = 1.5 * np.pi * work * radius
    cube_root = np.cbrt(np.sqrt(force + pull) + np.sqrt(pull))
    a = cube_root * cube_root * np.cbrt(0.75 * radius / e_star)
    return a, a * a / radius - np.sqrt(2 * np.pi * work / e_star * a)


def least(tasks, turns):
    """The fastest turn of each in seconds; they take turns."""
    times = [float("inf")] * len(tasks)
    for _ in range(turns):
        for index, task in enumerate(tasks):
            begin = time.perf_counter()
            task()
            times[index] = min(times[index], time.perf_counter() - begin)
    return times


def repeated(call):
    def run():
        for _ in range(SINGLE):
            call()

    return run


def main():
    cube = np.random.default_rng(1).uniform(0.1, 10.0, VALUES)
    print("| profile | held | states, ns a value | cbrt, ns | ratio | follow, ns a sample | one state, µs | call, µs |")
    print("|---|---|---|---|---|---|---|---|")
    for name, profile in profiles().items():
        contact = mdr.Contact(profile, e_star=1, work_of_adhesion=WORK)
        for control in CONTROLS:
            values = values_of(contact, control)
            ramp, one = np.sort(values)[::-1], float(values[3])
            tasks = [
                lambda: np.cbrt(cube),
                lambda: contact.states(**question(contact, control, values)),
                lambda: contact.follow(**question(contact, control, ramp)),
            ]
            cbrt, states, follow = (seconds / VALUES * 1e9 for seconds in least(tasks, TURNS))
            single = [repeated(lambda: contact.states(**question(contact, control, one))), repeated(lambda: plain(force=one))]
            state, call = (seconds / SINGLE * 1e6 for seconds in least(single, 3))
            print(f"| {name} | {control} | {states:.1f} | {cbrt:.1f} | {states / cbrt:.2f} | {follow:.0f} | {state:.2f} | {call:.2f} |")
    ball = mdr.Contact(mdr.Paraboloid(1), e_star=1, work_of_adhesion=WORK)
    force = values_of(ball, "force")
    np.testing.assert_allclose(jkr_by_hand(force)[0], ball.states(force=force).contact_radius, rtol=1e-12)
    ours, by_hand = (s / VALUES * 1e9 for s in least([lambda: ball.states(force=force), lambda: jkr_by_hand(force)], TURNS))
    print(f"\nJKR under a dead load: {ours:.1f} ns a state, {by_hand:.1f} ns by the formula in numpy, without force and status.")


if __name__ == "__main__":
    main()
