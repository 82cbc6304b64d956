"""The figure of docs/evidence/soak.md: memory, delay, descriptors and threads over the time of the soak."""

from __future__ import annotations

from pathlib import Path

from evidence import FIGURES
from evidence.data import stored
from evidence.thinning import thin

FILE = FIGURES / "soak.svg"
PANELS = (("memory MB",), ("p99 ms", "p50 ms"), ("descriptors",), ("threads",))


def save(file: Path = FILE) -> None:
    """Draw it from the stored numbers."""
    import matplotlib as mpl
    from matplotlib.figure import Figure

    course = stored("costs", "soak").tables["course"]
    columns = dict(zip(course.columns, zip(*course.rows, strict=True), strict=True))
    with mpl.rc_context({"svg.hashsalt": "pointpred", "font.size": 9.0}):
        figure = Figure(figsize=(9.0, 5.0), layout="constrained")
        for axes, names in zip(figure.subplots(2, 2, sharex=True).flat, PANELS, strict=True):
            for name, colour in zip(names, ("#0072b2", "#d55e00"), strict=False):
                axes.plot(columns["minute"], columns[name], color=colour, lw=1.0, label=name)
            axes.set_ylim(bottom=0.0)
            axes.set_ylabel(" and ".join(names))
        figure.supxlabel("minutes")
        figure.savefig(file, metadata={"Date": None})
    thin(file)
