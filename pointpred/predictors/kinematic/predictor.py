"""The learned predictor: a small network over what a movement has shown so far."""

from __future__ import annotations

from collections.abc import Callable
from math import exp
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from pointpred.compiled import law
from pointpred.parameter import option
from pointpred.predictors import movement
from pointpred.predictors.kinematic import coefficient_file, features, network
from pointpred.predictors.predictor import Predictor
from pointpred.records import FINE, MotionRow, TenFloats, endpoint


@law
def bounded_exp(logarithm: float, bounds: tuple[float, float]) -> float:
    """The exponential of a logarithm that is bounded first."""
    return exp(min(max(logarithm, bounds[0]), bounds[1]))


@law
def step(s: features.State, motion: TenFloats, coefficients: network.Coefficients) -> TenFloats:
    """Features, network, calibration, and back to the screen."""
    m = MotionRow(*motion)
    values = np.empty(features.Values.length)
    fault, frame = features.observe(s, m, features.Values(values))
    if fault != FINE:
        return movement.refuse(s.movement, m, fault)
    phase = movement.phase(s.movement, m)
    reach, _, ux, uy = frame
    if reach == 0.0:
        return endpoint(m.t, m.x, m.y, phase)
    sums = np.empty(network.Outputs.length)
    at = network.evaluate(coefficients, values, sums)
    calibration, out = network.Calibration(coefficients.rest, at), network.Outputs(sums)
    along, across = out.along, out.across * network.side(values)
    for i in range(network.BASES):
        along += out.basis[i] * values[network.BASIS_ALONG[i]]
        across += out.basis[i] * values[network.BASIS_ACROSS[i]]
    since = m.t - s.movement.t0
    left = (since + network.HEAD_START_S) * bounded_exp(out.left, network.LEFT_LOGS)
    share = since / (since + left)
    scale = reach * network.factor(calibration, share, network.WIDTH_FACTOR)
    wide = (scale * bounded_exp(out.wide, network.WIDTH_LOGS)) ** 2
    broad = (scale * bounded_exp(out.broad, network.WIDTH_LOGS)) ** 2
    tail = bounded_exp(out.tail, network.TAIL_LOGS)
    spread = bounded_exp(out.spread, network.SPREAD_LOGS)
    return (
        m.t,
        m.x + reach * (along * ux - across * uy),
        m.y + reach * (along * uy + across * ux),
        wide * ux * ux + broad * uy * uy,
        (wide - broad) * ux * uy,
        wide * uy * uy + broad * ux * ux,
        left,
        phase,
        tail * network.factor(calibration, share, network.TAIL_FACTOR),
        spread * network.factor(calibration, share, network.SPREAD_FACTOR),
    )


@law
def follow(s: features.State, motion: TenFloats, coefficients: network.Coefficients) -> bool:
    """Take one motion in without an answer: the network remembers nothing."""
    fault, _ = features.follow(s, MotionRow(*motion))
    return fault == FINE


class KinematicPredictor(Predictor):
    """Learned endpoint, region and time left from what the movement has shown so far.

    Assumes a movement like those it was trained on, from its start on: people with a mouse or a touchpad,
    50 to 1400 px on a screen of 96 dpi. It knows nothing of targets, of who moves, or of the task. At the
    start it can know little; after a stop it cannot know whether a correction follows.

    Features are lengths over the px travelled, speeds over their peak, times, and the logarithm of how far
    and fast the hand moved; positions stand on a grid of 8 ms, so that rates leave no trace. In a mirror the
    features across the direction change sign together and with them the answer. A network of two layers, z
    min(max(z / 6 + 1 / 2, 0), 1), gives the endpoint in reaches from the cursor along and across the
    direction from the start, as a sum of a vector and shares of the last moments' ways; the widths and the
    tail of a bivariate Student law around it; and the time left as a multiple of the time passed, with the
    standard deviation of its logarithm. Widths, tail and spread are corrected by a table learned on people
    held out.

    ``scale`` is the scale matrix and ``tail`` the degrees of freedom. Before the cursor has moved the
    answer is its place, without a region. Always answers. A second motion of the same time replaces the
    first. Memory: 273 floats; the coefficients are shared.

    ``coefficients``: the file of others, as ``pointpred train`` writes it. Raises ParameterError for a file
    that cannot be used, and EventError from ``update``.

    Reference: none; docs/evidence/results.md has the card of the coefficients.

    >>> from pointpred import PointerEvent, build
    >>> pipeline = build("kinematic")
    >>> for i in range(30):  # the first half of a minimum-jerk movement of 400 px in 0.6 s
    ...     s = i / 60
    ...     way = 400 * (10 * s**3 - 15 * s**4 + 6 * s**5)
    ...     prediction = pipeline.update(PointerEvent(i / 100, way, 0.0))
    >>> bool(prediction.x > way + 50), prediction.scale is not None
    (True, True)
    """

    coefficients: Path | str | None = option(
        "the file of other coefficients, as `pointpred train` writes it", default=None
    )
    step: ClassVar[Callable[..., TenFloats]] = staticmethod(step)
    follow: ClassVar[Callable[..., bool] | None] = staticmethod(follow)
    states = features.State.length

    def declare(self, **values: Any) -> None:
        """Check the values and read the coefficients: those of the package for ``None``."""
        super().declare(**values)
        source = coefficient_file.OWN if self.coefficients is None else self.coefficients
        self.shared = (coefficient_file.read(source),)
        self._source = Path(source)
        self._sets = coefficient_file.sets(source)  # the file may be gone when it is asked for

    def saw(self, name: str) -> bool:
        """Whether the coefficients were fitted to people of the set of this name."""
        return name in self._sets

    def __getstate__(self) -> dict[str, Any]:
        """Where the coefficients stand, not the coefficients."""
        return {name: value for name, value in self.__dict__.items() if name != "shared"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self.shared = (coefficient_file.read(self._source),)
