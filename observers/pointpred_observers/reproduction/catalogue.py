"""The figures and tables of chapters 3 and 4 and of the camera paper, for ``pointpred reproduce``."""

from __future__ import annotations

from pointpred.reproduction.figure import diagram
from pointpred_observers.reproduction import camera, thesis

LISTED = (
    diagram("3.1", "interconnected systems with a reference signal", "As figure 1.4."),
    diagram("3.2", "interconnected systems with a reference signal", "As figure 1.4."),
    thesis.figure_3_3,
    thesis.figure_3_4,
    thesis.figure_3_5,
    thesis.figure_3_6,
    thesis.figure_3_7,
    thesis.figure_3_8,
    thesis.figure_3_9,
    thesis.figure_3_10,
    thesis.figure_3_11,
    diagram("4.1", "connected systems", "As figure 1.2."),
    thesis.figure_4_2,
    diagram("4.3", "schematics of example 9", "The masses of figure 4.4."),
    thesis.figure_4_4,
    camera.figure_1,
    camera.figure_2,
    camera.table_1,
)
