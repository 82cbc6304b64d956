"""The cells of one table by column, for files of any table format."""

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
    row of each row if some were left out, which ``skipped`` names. ``unsure``: columns of ambiguous numbers,
    and why.
    """

    columns: dict[str, Any]
    format: str
    notes: tuple[str, ...] = ()
    skipped: tuple[Skip, ...] = ()
    row_of: IntArray | None = None
    unsure: dict[str, str] = {}


def distinct_names(names: Sequence[str]) -> list[str]:
    """The names made unique: a repeated one gets its place from 0 as a suffix.

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
