"""The figure of movement time against the index of difficulty."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from pointpred.drawing import MARKERS, PALETTE, canvas, legend_outside, written

Drawn = tuple[Sequence[dict[str, Any]], dict[str, Any] | None]
"""Rows of ``means`` with a row a condition, and the fields of a ``Line``."""
DASHES = ("solid", (0, (5, 2)), (0, (1, 1.5)), (0, (5, 2, 1, 2)))


def draw_lines(sets: Mapping[str, Drawn], file: Path) -> None:
    """Draw a point a condition and the line through them, of each set: a marker and a dash of its own.

    ``sets`` by name; ``file``: .svg, .png or .pdf. Needs matplotlib.
    """
    with canvas(height=4.2) as (figure, (axes,)):
        for place, (name, (rows, line)) in enumerate(sets.items()):
            known = [row for row in rows if row["id_bits"] is not None]
            style: Any = {"color": PALETTE[place % len(PALETTE)], "linestyle": "none"}
            x, y = [row["id_bits"] for row in known], [row["response_time_s"] for row in known]
            label = name
            if line is not None:
                label = f"{name}: {line['intercept']:.2f} + {line['slope']:.3f} ID, R² = {line['r2']:.3f}"
                ends = [min(x), max(x)]
                fitted = [line["intercept"] + line["slope"] * end for end in ends]
                axes.plot(ends, fitted, **(style | {"linestyle": DASHES[place % len(DASHES)]}))
            axes.plot(x, y, MARKERS[place % len(MARKERS)], label=label, markersize=6.5, **style)
        axes.set(xlabel="index of difficulty [bits]", ylabel="time from start to selection [s]")
        axes.set_ylim(bottom=0.0)
        axes.grid()
        legend_outside(figure, axes, columns=1)
        written(figure, file, f"Time from start to selection against difficulty: {', '.join(sets)}")
