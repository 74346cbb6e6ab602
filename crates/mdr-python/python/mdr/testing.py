"""For the tests of other packages; needs pytest, which ``import mdr`` does not."""

from __future__ import annotations

from typing import Any


def records(filter: str = "", **inputs: float) -> list[Any]:
    """Certified records for ``pytest.mark.parametrize``, each a case that is named by its id.

    Parameters
    ----------
    filter : str
        As that of :func:`mdr.records`.
    **inputs : float
        Only those with these arguments: ``n=2`` for spheres.

    Examples
    --------
    >>> from mdr import testing
    >>> spheres = testing.records("formula=critical control=force quantity=force flag=physical", n=2)
    >>> spheres[0].id
    'critical/afm-tip/force/force'
    """
    import pytest

    from ._oracle import records as all_of

    chosen = [record for record in all_of(filter) if inputs.items() <= record.arguments.items()]
    if not chosen:
        raise ValueError(f"no record of the filter {filter!r} has {inputs}")
    return [pytest.param(record, id=record.id) for record in chosen]


cases = records
