"""The learned predictor: a small network over what a movement has shown so far."""

from __future__ import annotations

from math import exp
from pathlib import Path
from typing import Any

import numpy as np

from pointpred.columns import BoolArray, FloatArray
from pointpred.compiled import law
from pointpred.predictors import kinematic_calibration as calibration
from pointpred.predictors import kinematic_coefficients, movement
from pointpred.predictors import kinematic_features as features
from pointpred.predictors import kinematic_net as net
from pointpred.predictors import kinematic_sight as sight
from pointpred.predictors.predictor import NONE, Predictor

AT = 0
REFUSED = (NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE)


@law
def bounded(value: float, bounds: tuple[float, float]) -> float:
    """An exponential whose logarithm is bounded."""
    return exp(min(max(value, bounds[0]), bounds[1]))


@law
def step(
    memory: FloatArray,
    coefficients: FloatArray,
    t: float,
    x: float,
    y: float,
    vx: float,
    vy: float,
    ax: float,
    ay: float,
    settled: float,
    start: float,
) -> tuple[float, float, float, float, float, float, float, float, float]:
    """Features, network, calibration, and back to the screen."""
    seen = np.empty(features.FEATURES)
    accepted, reach, ux, uy = sight.see(memory, AT, t, x, y, vx, vy, ax, ay, start, seen)
    if not accepted:
        return REFUSED
    phase = movement.phase(memory, AT, vx, vy)
    if reach == 0.0:
        return x, y, NONE, NONE, NONE, NONE, phase, NONE, NONE
    said = np.empty(net.OUTPUTS)
    table = net.outputs(coefficients, seen, said)
    along, across = said[net.ALONG], said[net.ACROSS] * net.side(seen)
    for i in range(net.BASES):
        along += said[net.BASIS + i] * seen[net.BASIS_ALONG[i]]
        across += said[net.BASIS + i] * seen[net.BASIS_ACROSS[i]]
    since = t - memory[AT + movement.T0]
    left = (since + net.HEAD_START_S) * bounded(said[net.LEFT], net.LEFT_LOGS)
    share = since / (since + left)
    widen = reach * calibration.factor(coefficients, table, share, calibration.WIDTH)
    wide = (widen * bounded(said[net.WIDE], net.WIDTH_LOGS)) ** 2
    broad = (widen * bounded(said[net.BROAD], net.WIDTH_LOGS)) ** 2
    tail = bounded(said[net.TAIL], net.TAIL_LOGS)
    spread = bounded(said[net.SPREAD], net.SPREAD_LOGS)
    return (
        x + reach * (along * ux - across * uy),
        y + reach * (along * uy + across * ux),
        wide * ux * ux + broad * uy * uy,
        (wide - broad) * ux * uy,
        wide * uy * uy + broad * ux * ux,
        left,
        phase,
        tail * calibration.factor(coefficients, table, share, calibration.TAIL),
        spread * calibration.factor(coefficients, table, share, calibration.SPREAD),
    )


@law
def loop(
    memory: FloatArray,
    coefficients: FloatArray,
    first: int,
    begin: BoolArray,
    rows: FloatArray,
    out: FloatArray,
) -> None:
    """The same step over a table."""
    for i in range(len(rows)):
        if begin[i]:
            memory[first:] = 0.0
        r = rows[i]
        answer = step(memory, coefficients, r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8])
        out[i, 0] = r[0]
        for j in range(len(answer)):
            out[i, j + 1] = answer[j]


class KinematicPredictor(Predictor):
    """Learned endpoint, region and time left from what the movement has shown so far.

    Assumes a movement like those it was trained on, from its start on: people with a mouse or a touchpad,
    50 to 1400 px on a screen of 96 dpi. It knows nothing of targets, of who moves, or of the task. At the
    start it can know little; after a stop it cannot know whether a correction follows.

    Features are lengths over the px travelled, speeds over their peak, times, and the logarithm of how far
    and fast the hand moved; positions stand on a grid of 8 ms, so that rates leave no trace. In a mirror the
    features across the direction change sign together and with them the answer. A network of two layers,
    z / (1 + exp(-z)), gives the endpoint in reaches from the cursor along and across the direction from the
    start, as a sum of a vector and shares of the last moments' ways; the widths and the tail of a bivariate
    Student law around it; and the time left as a multiple of the time passed, with the standard deviation
    of its logarithm. Widths, tail and spread are corrected by a table learned on people held out.

    ``scale`` is the scale matrix and ``tail`` the degrees of freedom. Before the cursor has moved the
    answer is its place, without a region. Always answers. A second motion of the same time replaces the
    first. Memory: 273 floats; the coefficients are shared.

    ``coefficients``: the file of others, as ``pointpred train`` writes it. Raises ParameterError for a file
    that cannot be used, and EventError from ``update``.

    Reference: none; docs/evidence/kinematic.md is the card of the coefficients.

    >>> from pointpred import PointerEvent, build
    >>> pipeline = build("kinematic")
    >>> for i in range(30):  # the first half of a minimum-jerk movement of 400 px in 0.6 s
    ...     s = i / 60
    ...     way = 400 * (10 * s**3 - 15 * s**4 + 6 * s**5)
    ...     prediction = pipeline.update(PointerEvent(i / 100, way, 0.0))
    >>> bool(prediction.x > way + 50), prediction.scale is not None
    (True, True)
    """

    step = staticmethod(step)
    loop = staticmethod(loop)

    def __init__(self, *, coefficients: Path | str | None = None) -> None:
        self._use(coefficients)
        super().__init__([], sight.STATES)

    def _use(self, coefficients: Path | str | None) -> None:
        """The coefficients of a file, those of the package for ``None``; raises ParameterError."""
        source = kinematic_coefficients.OWN if coefficients is None else coefficients
        self._coefficients = kinematic_coefficients.read(source)
        self._source = Path(source)
        self._known = kinematic_coefficients.sets(source)  # the file may be gone when it is asked for

    def saw(self, name: str) -> bool:
        """Whether the coefficients were fitted to people of the set of this name."""
        return name in self._known

    def advance(self, row: tuple[float, ...]) -> tuple[float, ...]:
        """``consume``, with the prediction as a row of ``PredictionColumns``."""
        t, x, y, vx, vy, ax, ay, settled, start, _ = row
        values = type(self).step(self._memory, self._coefficients, t, x, y, vx, vy, ax, ay, settled, start)
        return self.accepted(row, values)

    def walk(self, begin: BoolArray, rows: FloatArray) -> FloatArray:
        """Run the law over rows, resetting before each row marked ``begin``; continues from the memory."""
        out = np.empty((len(rows), self.width))
        type(self).loop(self._memory, self._coefficients, self._first, begin, rows, out)
        return out

    def __getstate__(self) -> dict[str, Any]:
        """Where the coefficients stand, not the coefficients."""
        return {name: value for name, value in self.__dict__.items() if name != "_coefficients"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._coefficients = kinematic_coefficients.read(self._source)
