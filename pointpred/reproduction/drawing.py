"""Panels as a picture, in the style of the report's figures."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from pointpred.report.figures.style import GREY, PALETTE, Picture, canvas, picture
from pointpred.reproduction.figure import Line, Look, Panel

LOOKS: dict[Look, dict[str, Any]] = {
    "truth": {"color": GREY, "linewidth": 3.0},
    "first": {"color": PALETTE[0], "linewidth": 1.3},
    "second": {"color": PALETTE[1], "linewidth": 1.3},
    "third": {"color": PALETTE[2], "linewidth": 1.3},
    "fourth": {"color": PALETTE[3], "linewidth": 1.3},
    "limit": {"color": GREY, "linewidth": 1.0, "linestyle": (0, (4, 2))},
}
PANEL_IN = (7.5, 2.3)
"""Width of a figure of one column and height of a panel, inches."""


def drawing(title: str, panels: Sequence[Panel], *, columns: int = 1) -> Callable[[], Picture]:
    """What draws the panels row by row, when it is called."""
    return lambda: _drawn(title, panels, columns)


def _drawn(title: str, panels: Sequence[Panel], columns: int) -> Picture:
    rows = -(-len(panels) // columns)
    width, height = PANEL_IN
    with canvas(rows, columns, width=width * (1.0 if columns == 1 else 1.4), height=height * rows + 0.4) as (
        figure,
        axes,
    ):
        for ax, panel in zip(axes, panels, strict=False):
            _draw_panel(ax, panel)
        for ax in axes[len(panels) :]:
            ax.set_visible(False)
        figure.suptitle(title, x=0.01, ha="left")
        alt = f"{title}: {'; '.join(panel.y for panel in panels)}"
        return picture(figure, alt, title, wide=columns > 1)


def _draw_panel(ax: Any, panel: Panel) -> None:
    for line in panel.lines:
        ax.plot(line.x, line.y, label=line.label or None, **LOOKS[line.look])
    ax.set(xlabel=panel.x, ylabel=panel.y, title=panel.title)
    ax.grid(visible=True)
    if panel.logarithmic:
        ax.set_yscale("log")
        ax.yaxis.set_major_formatter("{x:g}")  # powers would be drawn as formulas, which the style leaves out
    if panel.limits is not None:
        ax.set_ylim(*panel.limits)
    labels = sum(bool(line.label) for line in panel.lines)
    if labels:  # above the axes, where it hides no line
        ax.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=labels, borderaxespad=0.1)


def beside(x: Any, *lines: tuple[Any, str, Look]) -> tuple[Line, ...]:
    """Lines over the same x: (y, label, look)."""
    return tuple(Line(x, y, label, look) for y, label, look in lines)
