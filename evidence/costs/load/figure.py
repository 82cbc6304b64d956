"""The figure of docs/evidence/load.md: delay against the number of clients."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from evidence import FIGURES
from evidence.costs.load.curves import BOUND_MS
from evidence.data import stored
from evidence.rendering import only
from evidence.thinning import thin

FILE = FIGURES / "load.svg"
COLOURS = {
    "ASGI echo": "0.5",
    "`switched`": "#0072b2",
    "`kinematic`": "#d55e00",
    "`kinematic-adaptive`": "#009e73",
}
QUANTILES = ("p50", "p99", "p99.9")
BEFORE = ":"


def save(file: Path = FILE) -> None:
    """Draw it from the stored numbers."""
    import matplotlib as mpl
    from matplotlib.figure import Figure

    curves = stored("costs", "load").tables["curves"]
    loads = list(dict.fromkeys(str(row[0]) for row in curves.rows))
    with mpl.rc_context({"svg.hashsalt": "pointpred", "font.size": 9.0}):
        figure = Figure(figsize=(10.0, 6.4), layout="constrained")
        grid = figure.subplots(len(loads), len(QUANTILES), sharex="row", sharey=True)
        for row, load in zip(grid, loads, strict=True):
            for axes, quantile in zip(row, QUANTILES, strict=True):
                _panel(axes, only(curves, load=load), quantile)
                axes.set_title(f"{quantile}, clients at {load}", fontsize=9.0)
        lines = {line.get_label(): line for axes in figure.axes for line in axes.get_lines()}
        shown = [line for label, line in lines.items() if not label.startswith("_")]
        figure.legend(handles=shown, loc="outside lower center", ncols=3, frameon=False, fontsize=8.0)
        figure.supylabel("delay from when a frame was due, ms")
        figure.savefig(file, metadata={"Date": None})
    thin(file)


def _panel(axes: Any, curves: Any, quantile: str) -> None:
    """One quantile of every series."""
    lines: dict[tuple[str, str, str], list[tuple[float, float]]] = {}
    places = [curves.columns.index(name) for name in ("build", "server", "what", "clients", quantile)]
    for row in curves.rows:
        build, server, what, clients, delay = (row[place] for place in places)
        lines.setdefault((build, server, what), []).append((float(clients), float(delay)))
    for (build, server, what), points in lines.items():
        style = BEFORE if build != "this build" else "-" if server == "one core" else "--"
        name = what.strip("`")
        label = f"{name}, {server}" + ("" if build == "this build" else f", {build}")
        x, y = zip(*points, strict=True)
        axes.plot(x, y, linestyle=style, marker=".", color=COLOURS[what], lw=1.1, ms=4, label=label)
    if quantile == "p99":
        axes.axhline(BOUND_MS, color="0.3", lw=0.8)
    axes.set(yscale="log", xlabel="clients")
    axes.yaxis.set_major_formatter("{x:g}")
    axes.grid(visible=True, color="0.92", lw=0.6)
