"""How each predictor looks in the report's figures."""

from __future__ import annotations

import zlib
from collections.abc import Sequence

from pointpred.drawing.style import FAINT, GREY, MARKERS, PALETTE

HOLD = "hold"
MOST_LINES = 6
DASHED = (0, (3, 1.2))
STYLES: dict[str, tuple[int, str, object]] = {
    "linear": (5, "v", "solid"),
    "kalman": (4, "D", "solid"),
    "minimum-jerk": (2, "^", "solid"),
    "kep-quadratic": (3, "s", "solid"),
    "kep-quadratic-gated": (3, "P", DASHED),
    "kep-quartic": (1, "X", "solid"),
    "kep-quartic-gated": (1, "*", DASHED),
    "ktm": (2, "<", DASHED),
    "delphian": (4, ">", DASHED),
    "switched": (0, "o", "solid"),
    "switched-printed": (0, "h", DASHED),
    "switched-direction": (0, "d", "dotted"),
    "kinematic": (5, "p", "solid"),
    "kinematic-adaptive": (5, "H", DASHED),
}
"""Place in PALETTE, marker and dash of each name of the registry, the same in every figure and set."""


def line_style(name: str, shown: Sequence[str]) -> dict[str, object]:
    """Colour, marker and dash of a predictor: ``hold`` is the grey reference, what is not shown is faint.

    A name of the registry with words in brackets behind it has that name's colour and marker; where
    another of that name is drawn before it the line is dotted and the marker hollow. Any other name has a
    look of its own too, derived from its letters.
    """
    if name == HOLD:
        return {"color": GREY, "linestyle": (0, (4, 2)), "label": "hold (no prediction)", "zorder": 2.5}
    if name not in shown:
        return {"color": FAINT, "linewidth": 0.8, "zorder": 1.5}
    other = zlib.crc32(name.encode("utf-8", "replace"))
    base = name.partition(" (")[0]
    place, marker, dash = STYLES.get(base, (other % 6, MARKERS[other // 6 % 6], "dotted"))
    earlier = [one for one in shown[: list(shown).index(name)] if one.partition(" (")[0] == base]
    hollow = base in STYLES and bool(earlier)
    dash = "dotted" if hollow else dash
    return {
        "color": PALETTE[place],
        "marker": marker,
        "linestyle": dash,
        "label": name,
        "zorder": 3.0,
        **({"markerfacecolor": "none"} if hollow else {}),
    }
