"""The window or page that the cursor moves in, as laws know it."""

from __future__ import annotations

from hashlib import blake2b
from typing import NamedTuple

import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import LARGEST

DIGEST_BYTES = 6
"""Of a key: a float holds so long a whole number exactly."""


class Scene(NamedTuple):
    """The key of a window or page, as a whole number, and where its origin lies on the screen, px."""

    key: float
    x: float
    y: float


SCREEN = Scene(0.0, 0.0, 0.0)
"""Where nobody named a window."""


def scene(key: str, x: float, y: float) -> Scene:
    """The window of this name with its origin at (x, y) px; "" is the screen.

    Raises ParameterError for a key that is no string of whole Unicode characters, and for an origin that is
    no number or lies beyond the bounds of positions.
    """
    if not isinstance(key, str):
        raise ParameterError(f"key must be a string, received {key!r}", field="key", value=key)
    try:
        written = key.encode()
    except UnicodeEncodeError as surrogate:
        message = f"key must hold whole Unicode characters, received {key!r}"
        raise ParameterError(message, field="key", value=key) from surrogate
    digest = blake2b(written, digest_size=DIGEST_BYTES).digest()
    number = float(int.from_bytes(digest)) if key else 0.0
    return Scene(number, _coordinate("x", x), _coordinate("y", y))


def _coordinate(name: str, value: float) -> float:
    number = isinstance(value, int | float | np.integer | np.floating) and not isinstance(value, bool)
    if not number or not abs(value) <= LARGEST:
        bounds = f"[{-LARGEST:g}, {LARGEST:g}] px"
        message = f"{name} of the origin must be a number in {bounds}, received {value!r}"
        raise ParameterError(message, field=name, value=value)
    return float(value)
