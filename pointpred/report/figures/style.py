"""How the report's figures look: one palette, one size, vector graphics that follow light and dark."""

from __future__ import annotations

import base64
import io
import zlib
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Literal

import msgspec

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

HOLD = "hold"
MOST_LINES = 6
PALETTE = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00")
"""Okabe and Ito's colours, distinct with any colour vision; markers repeat the distinction."""
MARKERS = ("o", "s", "^", "D", "v", "P")
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
    """A figure of the report: SVG text, what it shows in words, and the caption below it."""

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
    """An empty figure in the report's style and its axes, row by row; no drawing state outlives it."""
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


def legend_outside(figure: Figure, axes: Axes, *, above: bool = False, columns: int = 2) -> None:
    """The legend under the axes, or above them."""
    handles, labels = axes.get_legend_handles_labels()
    if handles:
        side: Literal["outside upper center", "outside lower center"] = (
            "outside upper center" if above else "outside lower center"
        )
        figure.legend(handles, labels, loc=side, ncols=columns, columnspacing=1.2)
