"""The camera's velocity from the observer's depth, equations (40) to (42), by any differentiator."""

from __future__ import annotations

from math import nan
from typing import Any

import numpy as np

from pointpred.differentiators import DIFFERENTIATORS, Differentiator
from pointpred.errors import ParameterError
from pointpred.parameter import Parameter, check
from pointpred.records import METRES_PER_INCH, FloatArray, PointerEvent
from pointpred_observers.camera.depth import DepthColumns
from pointpred_observers.camera.samples import FOCAL, CameraColumns, CameraSample
from pointpred_observers.camera.unknown_input_filter import UnknownInputFilter, flow

NOISE_PX = Parameter("noise_px", "px", 1e-3, 1e3, "standard deviation of a coordinate in the image")
FLOOR = 1e-4
"""chi at or below this (a depth of 10 km) is invalid: the velocity is then NaN, never clipped."""
FED_FORWARD = "kalman-two-state"
DPI = 96.0
"""Image pixels are treated as pixels of a screen of this resolution, in which differentiators are tuned."""
GAPS = {"dpi": DPI, "gap_s": 2.0, "pause_s": 5.0}
"""Settings of all differentiators; the gaps (s) are long, so that missing images are bridged."""
CALM: dict[str, dict[str, Any]] = {
    "homogeneous": {"order": 3, "gain_lambda": 2.0, "gain_xi": 1.5, "alpha": -0.1, "step_s": 0.004},
    "kalman": {"jerk_density": 1e-3, "noise_m": 1e-3},
}
"""Settings for a camera at 33 images a second, the best of a small grid with 4 px of noise."""
WAYS = (*DIFFERENTIATORS, *(f"{name}, calm" for name in CALM), FED_FORWARD)
"""Methods for d: each differentiator, those tuned for a camera, the two-state filter."""


def velocities(d: FloatArray, depth: DepthColumns) -> FloatArray:
    """(v_x, v_y, v_z) m/s by (41), (42); NaN if chi is at its floor or unknown.

    >>> depth = DepthColumns([[0.0, 0.5, -0.1, -0.1, 1.0, 1.0, 1.0], [1.0, 1e-5, -0.1, -0.1, 1.0, 1.0, 1.0]])
    >>> velocities(np.array([[0.1, 0.0], [0.1, 0.0]]), depth).tolist()
    [[0.2, 0.0, -0.2], [nan, nan, nan]]
    """
    chi = np.where(depth.chi > FLOOR, depth.chi, np.nan)
    rates: FloatArray = np.column_stack([d, depth.eta]) / chi[:, None]
    return rates


class UnknownInputs:
    """d = chi (v_x, v_y) by (40): the known motion of the image less a derivative of it, or a filter.

    Assumes eta correct: its error times (x, y) enters d. A derivative turns n px of noise into n rate / focal
    length; stronger smoothing trades noise for delay; the two-state filter does not differentiate the known
    motion. Between two images the last derivative is held.

    d = (x, y) eta + B_y w - (x, y)'.

    Parameters: ``way``, one of ``WAYS``; ``focal_px`` px; ``noise_px`` px, the standard deviation for the
    two-state filter. Memory: that of its stage and 2 floats. Raises ParameterError.

    Reference: Benyoucef et al. 2021, equations (39) to (41).
    """

    def __init__(self, way: str, *, focal_px: float, noise_px: float = 1.0) -> None:
        if way not in WAYS:
            raise ParameterError(
                f"way must be one of {'; '.join(WAYS)}; received {way!r}", field="way", value=way
            )
        check((FOCAL, NOISE_PX), {"focal_px": focal_px, "noise_px": noise_px})
        self.way, self.focal_px = way, float(focal_px)
        self._d = (nan, nan)
        self._filter: UnknownInputFilter | None = None
        self._differentiator: Differentiator | None = None
        if way == FED_FORWARD:
            self._filter = UnknownInputFilter(noise=noise_px / focal_px)
        else:
            name, _, calm = way.partition(", ")
            kind: Any = DIFFERENTIATORS[name]
            self._differentiator = kind(**GAPS, **(CALM[name] if calm else {}))

    def reset(self) -> None:
        """Forget every sample."""
        self._d = (nan, nan)
        for stage in (self._filter, self._differentiator):
            if stage is not None:
                stage.reset()

    def update(self, sample: CameraSample, eta: float) -> tuple[float, float]:
        """Consume one sample and the observer's eta; NaN before the first estimate."""
        if eta != eta:
            return self._d
        w = (sample.wx, sample.wy, sample.wz)
        if sample.x is None or sample.y is None:
            if self._filter is not None:
                self._d = self._filter.update((sample.t, nan, nan, eta, *w))[1:3]
            return self._d
        x, y = sample.x / self.focal_px, sample.y / self.focal_px
        if self._filter is not None:
            self._d = self._filter.update((sample.t, x, y, eta, *w))[1:3]
        elif self._differentiator is not None:
            motion = self._differentiator.update(PointerEvent(sample.t, sample.x, sample.y))
            scale = DPI / METRES_PER_INCH / self.focal_px if motion.settled else nan
            known_x, known_y = flow(x, y, eta, *w)
            self._d = known_x - motion.vx * scale, known_y - motion.vy * scale
        return self._d

    def run(self, samples: CameraColumns, eta: FloatArray) -> FloatArray:
        """Consume a table: d at each row, by the same stages."""
        records = samples.samples()
        pairs = [self.update(one, float(value)) for one, value in zip(records, eta, strict=True)]
        return np.array(pairs).reshape(-1, 2)
