"""The rectangles a cursor may be heading for, as records and as the table that laws walk over."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from hashlib import blake2b
from math import exp, inf, log

import msgspec
import numpy as np

from pointpred.compiled import law
from pointpred.errors import ParameterError
from pointpred.records import LARGEST, FloatArray, FloatTable

MOST_TARGETS = 1000
NOBODY = -1
"""Stands in the place of a target where there is none."""
SMALLEST_PX = 1e-3

# A row of the table: the rectangle's centre and size in px, and the logarithm of its weight
# over that of all.
CENTRE_X, CENTRE_Y, WIDTH, HEIGHT, LOG_WEIGHT, FIELDS = range(6)


LEAST = np.array([-LARGEST, -LARGEST, SMALLEST_PX, SMALLEST_PX, 0.0])
"""The least place, size and weight of a target."""


class Target(msgspec.Struct, frozen=True):
    """A rectangle on the screen: its upper left corner and size, px.

    ``weight`` is the caller's prior, relative to the other targets': 2 is twice as likely as 1 before the
    cursor moves, 0 never. ``kind`` names what it is to the user, such as "button": what a person takes of a
    kind is learned.
    """

    id: Hashable
    x: float
    y: float
    width: float
    height: float
    weight: float = 1.0
    kind: str = ""


KEY_BYTES = 6
"""Of a target's id or kind: a float holds so long a whole number exactly."""


def key_of(text: str) -> float:
    """A text as a whole number above 0."""
    digest = blake2b(text.encode(errors="surrogatepass"), digest_size=KEY_BYTES).digest()
    return float(int.from_bytes(digest)) or 1.0


def around(id: Hashable, x: float, y: float, width: float, height: float | None = None) -> Target:
    """The rectangle with its centre at (x, y), square unless a height is given.

    >>> around("a", 10.0, 20.0, 4.0)
    Target(id='a', x=8.0, y=18.0, width=4.0, height=4.0, weight=1.0, kind='')
    """
    tall = width if height is None else height
    return Target(id, x - width / 2.0, y - tall / 2.0, width, tall)


@law
def complete(rows: FloatTable) -> None:
    """Rows of an upper left corner, a size and a weight become the table: centres, logarithms of weights."""
    most = -inf
    for i in range(len(rows)):
        rows[i, CENTRE_X] += 0.5 * rows[i, WIDTH]
        rows[i, CENTRE_Y] += 0.5 * rows[i, HEIGHT]
        weight = rows[i, LOG_WEIGHT]
        rows[i, LOG_WEIGHT] = log(weight) if weight > 0.0 else -inf
        most = max(most, rows[i, LOG_WEIGHT])
    if most == -inf:
        return
    total = 0.0
    for i in range(len(rows)):
        total += exp(rows[i, LOG_WEIGHT] - most)
    for i in range(len(rows)):
        rows[i, LOG_WEIGHT] -= most + log(total)


@law
def holder(table: FloatTable, x: float, y: float) -> int:
    """The smallest target that holds a point, of equal ones the nearest; NOBODY where there is none."""
    best, smallest, least = NOBODY, inf, inf
    for i in range(len(table)):
        row = table[i]
        across, down = abs(row[CENTRE_X] - x), abs(row[CENTRE_Y] - y)
        if across <= 0.5 * row[WIDTH] and down <= 0.5 * row[HEIGHT]:
            area, away = row[WIDTH] * row[HEIGHT], across + down
            if area < smallest or (area == smallest and away < least):
                best, smallest, least = i, area, away
    return best


def table(targets: Sequence[Target]) -> FloatArray:
    """The targets as a table, a row each.

    Raises ParameterError for what is no sequence, more than MOST_TARGETS, an id that occurs twice, is
    ``None`` or cannot be hashed, and a place, size or weight that is no number or out of bounds.

    >>> table([Target("a", 0.0, 0.0, 20.0, 10.0)]).tolist()
    [[10.0, 5.0, 20.0, 10.0, 0.0]]
    """
    if not isinstance(targets, Sequence):
        raise ParameterError(f"targets must be a sequence of Target, received {targets!r}", field="targets")
    if len(targets) > MOST_TARGETS:
        raise ParameterError(f"at most {MOST_TARGETS} targets, received {len(targets)}")
    rows = _plain_rows(targets)
    if rows is None:
        rows = _checked_rows(targets)
    complete(rows)
    return rows


def _plain_rows(targets: Sequence[Target]) -> FloatArray | None:
    """The rows as ``complete`` takes them, without a look at each; ``None`` where that is needed."""
    values = [(one.x, one.y, one.width, one.height, one.weight) for one in targets if isinstance(one, Target)]
    if len(values) < len(targets) or not {type(value) for row in values for value in row} <= {int, float}:
        return None
    try:
        rows, ids = np.array(values, dtype=np.float64).reshape(-1, FIELDS), {one.id for one in targets}
    except (TypeError, OverflowError):
        return None
    usable = len(ids) == len(rows) and None not in ids and bool(((rows >= LEAST) & (rows <= LARGEST)).all())
    return rows if usable else None


def _checked_rows(targets: Sequence[Target]) -> FloatArray:
    """The rows as ``complete`` takes them; raises ParameterError for the first target that is not usable."""
    seen: set[Hashable] = set()
    rows = np.empty((len(targets), FIELDS))
    for place, target in enumerate(targets):
        if not isinstance(target, Target):
            raise ParameterError(f"a target must be a Target, received {target!r}")
        if target.id is None:
            raise ParameterError("the id of a target must not be None, which stands for none of them")
        try:
            twice = target.id in seen
        except TypeError as unhashable:
            raise ParameterError(
                f"the id of a target must be hashable, received {target.id!r}"
            ) from unhashable
        if twice:
            raise ParameterError(f"the id of a target must occur once, received {target.id!r} twice")
        seen.add(target.id)
        rows[place] = _row(target)
    return rows


def _row(target: Target) -> tuple[float, ...]:
    """A target as ``complete`` takes it; raises ParameterError."""
    for name, value, low, high in (
        ("x", target.x, -LARGEST, LARGEST),
        ("y", target.y, -LARGEST, LARGEST),
        ("width", target.width, SMALLEST_PX, LARGEST),
        ("height", target.height, SMALLEST_PX, LARGEST),
        ("weight", target.weight, 0.0, LARGEST),
    ):
        number = isinstance(value, int | float | np.integer | np.floating) and not isinstance(value, bool)
        if not number or not low <= value <= high:
            unit = "" if name == "weight" else " px"
            raise ParameterError(
                f"{name} of target {target.id!r} must lie in [{low:g}, {high:g}]{unit}, received {value!r}"
            )
    return target.x, target.y, target.width, target.height, target.weight
