"""The plot of ``pointpred camera run``: depth and velocity over time, observer and peer, and the flag."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from pointpred.drawing import GREY, PALETTE, canvas, picture
from pointpred.files import write_whole
from pointpred.records import FloatArray
from pointpred_observers.camera import CameraTable

SHOWN = (("depth Z [m]", None), ("v_x [m/s]", "vx"), ("v_y [m/s]", "vy"), ("v_z [m/s]", "vz"))
OBSERVER, PEER = PALETTE[1], PALETTE[0]


def plot(estimates: CameraTable, truth: FloatArray | None, target: Path, title: str) -> None:
    """Write an SVG file with four panels; grey: where the observer's errors do not fade."""
    with canvas(2, 2, width=9.0, height=6.0) as (figure, axes):
        for place, (label, name) in enumerate(SHOWN):
            ax = axes[place]
            observer = 1.0 / estimates.chi if name is None else getattr(estimates, name)
            peer = 1.0 / estimates.peer_chi if name is None else getattr(estimates, f"peer_{name}")
            low, high = _range(peer, observer, None if truth is None else truth[:, place + 1])
            if truth is not None:
                ax.plot(
                    estimates.t, truth[:, place + 1], color=GREY, linewidth=3.5, label="truth", zorder=1.5
                )
            ax.plot(estimates.t, observer, color=OBSERVER, linewidth=1.0, label="observer")
            ax.plot(
                estimates.t, peer, color=PEER, linestyle=(0, (4, 2)), linewidth=1.5, label="filter (peer)"
            )
            blind = estimates.detectable == 0.0
            ax.fill_between(
                estimates.t, 0.0, 1.0, where=blind, color=GREY, alpha=0.15, linewidth=0.0,
                transform=ax.get_xaxis_transform(), label="not detectable" if blind.any() else None,
            )  # fmt: skip
            ax.set(xlabel="t [s]", ylabel=label, ylim=(low, high))
        figure.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=4)
        figure.suptitle(title, x=0.01, ha="left")
        caption = "Depth and velocity over time by observer and filter."
        write_whole(target, picture(figure, caption, title, wide=True).svg.encode())


def _range(*lines: FloatArray | None) -> tuple[float, float]:
    """What is worth seeing: the middle 96 % of each line, and some air."""
    finite = [line[line == line] for line in lines if line is not None]
    ends = [np.percentile(line, (2.0, 98.0)) for line in finite if len(line)]
    if not ends:
        return 0.0, 1.0
    low, high = float(np.min(ends)), float(np.max(ends))
    air = 0.1 * max(high - low, 1e-3)
    return low - air, high + air
