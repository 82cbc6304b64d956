"""How figures look: one palette, one size, vector graphics that follow light and dark."""

from __future__ import annotations

import base64
import io
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import msgspec

from pointpred.files import whole, write_whole

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

PALETTE = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00")
"""Okabe and Ito's colours, distinct with any colour vision; markers repeat the distinction."""
MARKERS = ("o", "s", "^", "D", "v", "P")
GREY = "#808080"
INK = "#010203"
"""Stands for the text colour of the page: replaced by ``currentColor`` once drawn."""
FAINT = "#80808055"
WIDTH_IN, HEIGHT_IN = 5.0, 3.9
"""Small enough that the letters stay readable on a telephone."""

SETTINGS: dict[Any, Any] = {
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "axes.titlecolor": INK,
    "axes.spines.right": False,
    "axes.spines.top": False,
    "axes.titlesize": 11,
    "axes.titlelocation": "left",
    "figure.dpi": 96,
    "figure.facecolor": "none",
    "axes.facecolor": "none",
    "legend.frameon": False,
    "legend.fontsize": 9.5,
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": 10.5,
    "grid.color": FAINT,
    "lines.linewidth": 1.8,
    "lines.markersize": 4.5,
    "svg.fonttype": "none",
    "svg.hashsalt": "pointpred",
    "text.color": INK,
    "text.parse_math": False,  # names are not ours: a dollar sign in one is a dollar sign
    "xtick.color": INK,
    "ytick.color": INK,
}
FOLLOW = (
    "<style>svg{color:#1d2126}@media (prefers-color-scheme:dark){svg{color:#dfe3e8}}"
    "@media print{svg{color:#000}}</style>"
)


class Picture(msgspec.Struct, frozen=True):
    """A figure: SVG text, what it shows in words, and the caption below it."""

    svg: str
    alt: str
    caption: str
    wide: bool = False

    @property
    def url(self) -> str:
        """The figure as a link that holds it."""
        return f"data:image/svg+xml;base64,{base64.b64encode(self.svg.encode()).decode()}"


@contextmanager
def canvas(rows: int = 1, columns: int = 1, *, width: float = WIDTH_IN, height: float = HEIGHT_IN,
           share: bool = False) -> Iterator[tuple[Figure, list[Axes]]]:  # fmt: skip
    """An empty figure in this style and its axes, row by row; no drawing state outlives it."""
    import matplotlib
    from matplotlib.backends.backend_svg import FigureCanvasSVG
    from matplotlib.figure import Figure

    with matplotlib.rc_context(SETTINGS):
        figure = Figure(figsize=(width, height), layout="constrained")
        FigureCanvasSVG(figure)
        axes = figure.subplots(rows, columns, squeeze=False, sharey=share, sharex=share)
        yield figure, list(axes.ravel())


def picture(figure: Figure, alt: str, caption: str, *, wide: bool = False) -> Picture:
    """Draw a figure: the same bytes for the same content. Call within ``canvas``."""
    stream = io.StringIO()
    figure.savefig(stream, format="svg", metadata={"Date": None, "Creator": None})
    svg = stream.getvalue()
    svg = svg[svg.index("<svg") :].replace(INK, "currentColor")
    end = svg.index(">") + 1
    return Picture(svg[:end] + FOLLOW + svg[end:], alt, caption, wide)


def written(figure: Figure, target: Path, caption: str) -> None:
    """Write a figure as .svg that follows light and dark, or as .png or .pdf. Call within ``canvas``."""
    if target.suffix == ".svg":
        write_whole(target, picture(figure, caption, caption).svg.encode())
    else:
        with whole(target) as stream:
            figure.savefig(stream, format=target.suffix[1:], facecolor="white", dpi=150)


def legend_outside(figure: Figure, axes: Axes, *, above: bool = False, columns: int = 2) -> None:
    """The legend under the axes, or above them."""
    handles, labels = axes.get_legend_handles_labels()
    if handles:
        side: Literal["outside upper center", "outside lower center"] = (
            "outside upper center" if above else "outside lower center"
        )
        figure.legend(handles, labels, loc=side, ncols=columns, columnspacing=1.2)
