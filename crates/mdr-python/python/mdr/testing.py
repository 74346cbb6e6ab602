"""For the tests of other packages; needs pytest, which ``import mdr`` does not."""

from __future__ import annotations

from typing import Any


def cases(filter: str = "") -> list[Any]:
    """Certified records for ``pytest.mark.parametrize``, each a case that is named by its id.

    Parameters
    ----------
    filter : str
        As that of :func:`mdr.records`.
    """
    import pytest

    from . import records

    return [pytest.param(record, id=record.id) for record in records(filter)]
