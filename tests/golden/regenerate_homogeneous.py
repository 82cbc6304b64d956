"""Write homogeneous.csv again: ``python tests/golden/regenerate_homogeneous.py`` from the project's root.

Do so only when the law is meant to change, and say why in the commit.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from pointpred import EventColumns
from pointpred.differentiators import HomogeneousDifferentiator

FILE = Path(__file__).parent / "homogeneous.csv"
HEADER = """Generated, not recorded: two minimum-jerk reaches in whole pixels (96 dpi) and whole counts
(2000 CPI), 125 Hz then 1 kHz, stamps rounded to 1/8192 s, a click, two pairs of equal stamps and a pause of
0.5 s between the reaches (seed 20220102). Columns after buttons: velocity and acceleration of HOMD with the
printed gains (alpha -0.2, line) from counts, then velocity of the linear law (alpha 0) from the cursor.
Written by: python tests/golden/regenerate_homogeneous.py
t,x,y,dx,dy,buttons,vx,vy,ax,ay,linear_vx,linear_vy"""


def recording() -> EventColumns:
    """The events of the golden file."""
    random = np.random.default_rng(20220102)
    t = np.concatenate([np.arange(100) * 0.008, 1.3 + np.arange(400) * 0.001])
    t = np.round((t + random.uniform(0.0, 2e-4, len(t))) * 8192.0) / 8192.0
    t[50] = t[49]
    t[300] = t[299]
    s = np.concatenate([np.clip(t[:100] / 0.6, 0.0, 1.0), np.clip((t[100:] - 1.3) / 0.35, 0.0, 1.0)])
    way = 10 * s**3 - 15 * s**4 + 6 * s**5
    way[100:] = 1.0 - 0.4 * way[100:]
    metres = np.outer(way, [0.12, -0.05])
    cursor = np.round(metres * 96.0 / 0.0254) + np.array([300.0, 500.0])
    counts = np.diff(np.round(metres * 2000.0 / 0.0254), axis=0, prepend=[[0.0, 0.0]]) + 0.0
    buttons = np.where((np.arange(len(t)) >= 85) & (np.arange(len(t)) < 95), 1.0, 0.0)
    return EventColumns.of(t, *cursor.T, *counts.T, buttons)


def answers(events: EventColumns) -> np.ndarray:
    """What the golden file keeps of the differentiator."""
    printed = HomogeneousDifferentiator(cpi=2000.0).run(events)
    linear = HomogeneousDifferentiator(alpha=0.0, gain_lambda=20.0, gain_xi=1.2).run(events)
    return np.column_stack([printed.table[:, 3:7], linear.table[:, 3:5]])


if __name__ == "__main__":
    found = recording()
    table = np.column_stack([found.table, answers(found)])
    np.savetxt(FILE, table, fmt="%.17g", delimiter=",", header=HEADER)
    print(f"wrote {FILE}: {len(table)} rows")
