"""What training makes small, and its slope: the point's distance, the law around it, the time left."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.predictors.kinematic import network as net

Floats = NDArray[np.float32]
SOFT = 1e-5
"""Squared distances below this share of the squared reach are as good as none."""
FASTEST_S = 0.02
"""Added to both times before their logarithms are compared: the clock of a screen is not finer."""
FAR = 3.0


class Truth(msgspec.Struct, frozen=True):
    """What the network should have predicted_s, a row a moment, and what each moment weighs."""

    basis_along: Floats
    """What the shares of the basis multiply, along the direction; a column each."""
    basis_across: Floats
    side: Floats
    along: Floats
    """Endpoint from the cursor, in reaches."""
    across: Floats
    left_s: Floats
    since_s: Floats
    point_weight: Floats
    law_weight: Floats
    time_weight: Floats

    def only(self, rows: NDArray[Any]) -> Truth:
        """Some of the rows."""
        return Truth(*(getattr(self, name)[rows] for name in self.__struct_fields__))


def point(outputs: Floats, truth: Truth) -> tuple[Floats, Floats]:
    """The endpoint the outputs mean, in reaches along and across."""
    shares = outputs[:, net.BASIS : net.BASIS + net.BASES]
    along = outputs[:, net.ALONG] + (shares * truth.basis_along).sum(axis=1)
    across = outputs[:, net.ACROSS] * truth.side + (shares * truth.basis_across).sum(axis=1)
    return along, across


def slopes(outputs: Floats, truth: Truth) -> tuple[float, Floats]:
    """The loss and its slope by each output, both as means over the rows.

    The law around the point does not move the point: its errors count as they are.
    """
    rows = np.float32(len(outputs))
    slope = np.zeros_like(outputs)
    along, across = point(outputs, truth)
    off_along, off_across = along - truth.along, across - truth.across
    distance = np.sqrt(off_along**2 + off_across**2 + np.float32(SOFT))
    loss = float((truth.point_weight * distance).mean())
    pull = truth.point_weight / distance / rows
    slope[:, net.ALONG] = pull * off_along
    slope[:, net.ACROSS] = pull * off_across * truth.side
    slope[:, net.BASIS : net.BASIS + net.BASES] = (pull * off_along)[:, None] * truth.basis_along
    slope[:, net.BASIS : net.BASIS + net.BASES] += (pull * off_across)[:, None] * truth.basis_across
    loss += _law(outputs, truth, off_along, off_across, slope)
    loss += _time(outputs, truth, slope)
    return loss, slope


def _law(outputs: Floats, truth: Truth, off_along: Floats, off_across: Floats, slope: Floats) -> float:
    """Minus the logarithm of the Student law's density."""
    rows = np.float32(len(outputs))
    width = [np.exp(np.clip(outputs[:, place], *net.WIDTH_LOGS)) for place in (net.WIDE, net.BROAD)]
    inside = [
        (outputs[:, place] > net.WIDTH_LOGS[0]) & (outputs[:, place] < net.WIDTH_LOGS[1])
        for place in (net.WIDE, net.BROAD)
    ]
    q_along, q_across = (off_along / width[0]) ** 2, (off_across / width[1]) ** 2
    heavy = np.clip(outputs[:, net.TAIL], *net.TAIL_LOGS)
    nu = np.exp(heavy)
    q = q_along + q_across
    value = np.log(width[0]) + np.log(width[1]) + 0.5 * (nu + 2.0) * np.log1p(q / nu)
    by_q = 0.5 * (nu + 2.0) / (nu + q)
    by_nu = 0.5 * np.log1p(q / nu) - 0.5 * (nu + 2.0) * q / (nu * (nu + q))
    weight = truth.law_weight / rows
    slope[:, net.WIDE] = weight * (1.0 - 2.0 * by_q * q_along) * inside[0]
    slope[:, net.BROAD] = weight * (1.0 - 2.0 * by_q * q_across) * inside[1]
    slope[:, net.TAIL] = weight * by_nu * nu * (heavy == outputs[:, net.TAIL])
    return float((truth.law_weight * value).mean())


def _time(outputs: Floats, truth: Truth, slope: Floats) -> float:
    """The error of the time left, and minus the logarithm of a normal law of its logarithm."""
    rows = np.float32(len(outputs))
    log_ahead = np.clip(outputs[:, net.LEFT], *net.LEFT_LOGS)
    predicted_s = (truth.since_s + np.float32(net.HEAD_START_S)) * np.exp(log_ahead)
    off = predicted_s - truth.left_s
    weight = truth.time_weight / rows
    slope[:, net.LEFT] = weight * np.sign(off) * predicted_s * (log_ahead == outputs[:, net.LEFT])
    spread_log = np.clip(outputs[:, net.SPREAD], *net.SPREAD_LOGS)
    far = np.clip(np.log((predicted_s + FASTEST_S) / (truth.left_s + FASTEST_S)), -FAR, FAR)
    relative = far**2 * np.exp(-2.0 * spread_log)
    law = truth.law_weight / rows
    slope[:, net.SPREAD] = law * (1.0 - relative) * (spread_log == outputs[:, net.SPREAD])
    return float(
        (truth.time_weight * np.abs(off)).mean() + (truth.law_weight * (spread_log + 0.5 * relative)).mean()
    )
