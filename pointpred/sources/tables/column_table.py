"""The cells of one table by column, as any file of tables gives them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.recording import Skip

IntArray = NDArray[np.int64]


class ColumnTable(msgspec.Struct, frozen=True):
    """The cells of one table by column, all of one length.

    A cell is a str, a number, a bool, ``None``, a date and time, or a list of numbers (a row a trial);
    a column is a list, a numpy array or an Arrow array. ``format`` for the provenance. ``row_of``: the file's
    row of each row where some were left out, which ``skipped`` names. ``unsure``: columns of numbers that may
    be read in two ways, and why.
    """

    columns: dict[str, Any]
    format: str
    notes: tuple[str, ...] = ()
    skipped: tuple[Skip, ...] = ()
    row_of: IntArray | None = None
    unsure: dict[str, str] = {}


def distinct_names(names: Sequence[str]) -> list[str]:
    """The names, none twice: one that stands at several places has its place from 0 behind it.

    >>> distinct_names(["t", "x", "x", "x.1"])
    ['t', 'x.1', 'x.2', 'x.1.3']
    """
    often = Counter(names)
    taken: dict[str, None] = {}
    for place, name in enumerate(names):
        title = name if often[name] == 1 else f"{name}.{place}"
        while title in taken:
            title += f".{place}"
        taken[title] = None
    return list(taken)
