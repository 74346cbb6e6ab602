#!/usr/bin/env python3
"""Fits the certified data sets of a paraboloid by lmfit, with the model of answer_scipy.py.

    mdr reference --data-sets curves
    python3 answer_lmfit.py curves > answers.jsonl
    mdr judge answers.jsonl
"""

import lmfit

from answer_scipy import main


def by_lmfit(data):
    """By lmfit's Model with its own tolerances."""
    model = lmfit.Model(data.force, independent_vars=["x"])
    names = dict(zip(data.free, ("e_star", "work", "contact_point")))
    parameters = model.make_params(**{names[name]: start for name, start in zip(data.free, data.start)})
    for name in ("e_star", "work"):
        parameters[name].set(min=0)
    if "contact_point" not in data.free:
        parameters["contact_point"].set(value=0.0, vary=False)
    found = model.fit(data.y, parameters, x=data.x)
    fitted = [found.params[names[name]] for name in data.free]
    return [each.value for each in fitted], [each.stderr for each in fitted]


if __name__ == "__main__":
    main(by_lmfit)
