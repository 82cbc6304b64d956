"""What a reproduced figure or table is made of: our numbers beside the printed ones, and what draws it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import msgspec
import numpy as np
from numpy.typing import ArrayLike

from pointpred.drawing import Picture

EXACT = 1e-6
"""How far a number may lie from an exact printed one, such as 7/40, and still be that."""


class Value(msgspec.Struct, frozen=True):
    """A number of ours beside the printed one.

    ``printed`` is text as the source prints it; ``None`` where the source prints no number. ``"0.2350"`` and
    ``"1.914e-3"`` are rounded, ``"-7/40"`` and ``"3"`` are exact.
    """

    name: str
    ours: float
    printed: str | None = None
    unit: str = ""

    @property
    def agrees(self) -> bool | None:
        """Whether our number rounds to the printed one; ``None`` without a printed number.

        >>> Value("x", 0.23496, "0.2350").agrees, Value("x", 0.2356, "0.2350").agrees
        (True, False)
        >>> Value("x", -0.175, "-7/40").agrees, Value("x", 1.0).agrees
        (True, None)
        """
        if self.printed is None:
            return None
        rounded = "." in self.printed
        last_digit = 10.0 ** int(Decimal(self.printed).as_tuple().exponent) if rounded else 0.0
        return abs(self.ours - float(Fraction(self.printed))) <= 0.5 * last_digit + EXACT


class Reproduction(msgspec.Struct, frozen=True):
    """A figure or table made again; ``draw`` needs matplotlib and is ``None`` for a table.

    ``data`` says in a few words which data it was made from.
    """

    values: tuple[Value, ...]
    draw: Callable[[], Picture] | None
    data: str


class Entry(msgspec.Struct, frozen=True):
    """A figure or table of a source: what it shows, how it is made again, what differs and why.

    ``make`` takes the data that the user names or ``None``; it is ``None`` where the figure is a diagram.
    ``reads``: what may be named, ``""`` where nothing may be.
    """

    number: str
    source: str
    shows: str
    differs: str
    make: Callable[[Path | None], Reproduction] | None = None
    reads: str = ""
    slow: bool = False
    """Whether it takes more than a few seconds."""

    @property
    def is_table(self) -> bool:
        """Whether it is a table, of which nothing is drawn."""
        return "table" in self.number

    @property
    def file_name(self) -> str:
        """The file it is drawn into unless another is named."""
        return f"{self.number}.svg" if self.source == CAMERA else f"thesis-{self.number}.svg"


THESIS = "thesis"
CAMERA = "camera paper"


def diagram(number: str, shows: str, where: str) -> Entry:
    """A figure of the thesis of which nothing is computed; ``where``: what in pointpred it stands for."""
    return Entry(number, THESIS, shows, f"A diagram, nothing is computed. {where}")


def matrix_values(name: str, ours: ArrayLike, printed: Sequence[Sequence[str]]) -> tuple[Value, ...]:
    """A value for each entry of a matrix, named as ``Pi[2, 1]``; rows and columns count from 1.

    >>> [one.name for one in matrix_values("S1", [[0.0], [3.0]], [["0"], ["3"]])]
    ['S1[1, 1]', 'S1[2, 1]']
    """
    table = np.asarray(ours, np.float64)
    return tuple(
        Value(f"{name}[{i + 1}, {j + 1}]", float(table[i, j]), text)
        for i, row in enumerate(printed)
        for j, text in enumerate(row)
    )
