"""Panels of lines as a figure: an SVG picture, or a file of any kind that matplotlib writes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Literal

import msgspec

from pointpred.drawing import GREY, PALETTE, Picture, canvas, picture
from pointpred.records import FloatArray

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Look = Literal["truth", "first", "second", "third", "fourth", "limit"]
"""How a line looks: the truth is grey and wide, a limit dashed and thin, the others have a colour each."""
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


class Line(msgspec.Struct, frozen=True):
    """A curve: x and y of the same length, NaN where there is nothing."""

    x: FloatArray
    y: FloatArray
    label: str = ""
    look: Look = "first"


class Panel(msgspec.Struct, frozen=True):
    """Axes with their lines; ``limits`` of y, all that is drawn unless given."""

    y: str
    lines: tuple[Line, ...]
    x: str = "t [s]"
    title: str = ""
    logarithmic: bool = False
    limits: tuple[float, float] | None = None


def drawing(title: str, panels: Sequence[Panel], *, columns: int = 1) -> Callable[[], Picture]:
    """What draws the panels row by row, when it is called."""
    return lambda: _drawn(title, panels, columns)


@contextmanager
def drawn(title: str, panels: Sequence[Panel], columns: int = 1) -> Iterator[Figure]:
    """The panels row by row as a figure; write it within the context, which holds the style."""
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
        yield figure


def _drawn(title: str, panels: Sequence[Panel], columns: int) -> Picture:
    with drawn(title, panels, columns) as figure:
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
