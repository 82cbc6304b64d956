"""How the figures of chapters 3 and 4 and of the camera paper are listed, and how their panels are made."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from inspect import getdoc
from pathlib import Path
from typing import Any

from pointpred.drawing import Panel, beside
from pointpred.reproduction.figure import CAMERA, THESIS, Entry, Reproduction


def figure(number: str, reads: str = "") -> Callable[[Callable[[Path | None], Reproduction]], Entry]:
    """The entry of a figure or table that a function makes; ``reads``: what data may be named.

    The first sentence of the function's documentation says what it shows, the others what differs from print.
    """

    def listed(make: Callable[[Path | None], Reproduction]) -> Entry:
        shows, _, differs = (getdoc(make) or "").partition("\n\n")
        shows = shows.removesuffix(".")
        shows = shows[0].lower() + shows[1:] if shows[1].islower() else shows  # RMSE stays
        source = THESIS if number[0].isdigit() else CAMERA
        return Entry(number, source, shows, " ".join(differs.split()), make, reads)

    return listed


def panel(name: str, t: Any, *lines: tuple[Any, str, Any], **more: Any) -> Panel:
    """Lines over the same t, each (y, label, look); ``more`` of ``Panel``."""
    return Panel(name, beside(t, *lines), **more)


def panels(names: Sequence[str], t: Any, *tables: tuple[Any, str, Any]) -> list[Panel]:
    """A panel for each name, of that column of each table; a ``#`` in a label is the column's number."""
    return [
        panel(name, t, *((y[:, i], label.replace("#", str(i + 1)), look) for y, label, look in tables))
        for i, name in enumerate(names)
    ]
