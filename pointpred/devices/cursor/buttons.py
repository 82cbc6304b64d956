"""The buttons of a cursor as the mask that events carry."""

from __future__ import annotations

from collections.abc import Sequence

BUTTONS = (1, 2, 4, 8, 16)
"""Bits of the left, right, middle, back and forward button in ``PointerEvent``."""


def mask_of(pressed: Sequence[bool]) -> int:
    """Buttons as in ``PointerEvent`` from left, right, middle, back, forward.

    >>> mask_of([True, False, True])
    5
    """
    return sum(bit for bit, down in zip(BUTTONS, pressed, strict=False) if down)
