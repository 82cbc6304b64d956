"""Figures in one style: one palette, one size, graphics that follow light and dark; and panels of lines."""

from __future__ import annotations

import base64
import io
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import msgspec

from pointpred.files import whole, write_whole
from pointpred.records import FloatArray

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
    "pdf.fonttype": 42,
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
    """A figure: SVG text, what it shows in words, the caption below it, and matplotlib's figure."""

    svg: str
    alt: str
    caption: str
    wide: bool
    figure: Any

    @property
    def url(self) -> str:
        """The figure as a link that holds it."""
        return f"data:image/svg+xml;base64,{base64.b64encode(self.svg.encode()).decode()}"

    def pdf(self) -> bytes:
        """The figure as PDF, on white, letters as fonts; the same bytes for the same content."""
        import matplotlib

        stream = io.BytesIO()
        with matplotlib.rc_context(SETTINGS):
            about = dict.fromkeys(("CreationDate", "Creator", "Producer"))
            self.figure.savefig(stream, format="pdf", facecolor="white", metadata=about)
        return stream.getvalue()


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
    return Picture(svg[:end] + FOLLOW + svg[end:], alt, caption, wide, figure)


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

    def draw() -> Picture:
        with drawn(title, panels, columns) as figure:
            alt = f"{title}: {'; '.join(panel.y for panel in panels)}"
            return picture(figure, alt, title, wide=columns > 1)

    return draw


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


def _draw_panel(ax: Any, panel: Panel) -> None:
    from matplotlib.ticker import LogLocator

    for line in panel.lines:
        ax.plot(line.x, line.y, label=line.label or None, **LOOKS[line.look])
    ax.set(xlabel=panel.x, ylabel=panel.y, title=panel.title)
    ax.grid(visible=True)
    if panel.logarithmic:
        ax.set_yscale("log")
        # Powers would be drawn as formulas, which the style leaves out; in two decades 2 and 5 stand, too.
        low, high = ax.get_ylim()
        ax.yaxis.set_major_formatter("{x:g}")
        ax.yaxis.set_minor_formatter("")
        if high < 100.0 * low:
            ax.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    if panel.limits is not None:
        ax.set_ylim(*panel.limits)
    labels = sum(bool(line.label) for line in panel.lines)
    if labels:  # above the axes, where it hides no line
        ax.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=labels, borderaxespad=0.1)


def beside(x: Any, *lines: tuple[Any, str, Look]) -> tuple[Line, ...]:
    """Lines over the same x: (y, label, look)."""
    return tuple(Line(x, y, label, look) for y, label, look in lines)
