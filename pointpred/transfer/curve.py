"""The gain curve of an identification as plain lists, with a constant gain and a sigmoid fitted to it."""

from __future__ import annotations

from importlib.util import find_spec
from math import inf
from typing import Literal

import msgspec
import numpy as np

from pointpred.records import FloatArray
from pointpred.transfer.bands import Bands
from pointpred.transfer.functions import ConstantGain, SigmoidGain, TransferFunction
from pointpred.transfer.identification import Identification

POINTS = 41
GAIN_MOST, SPEED_MOST = 1e3, 1e2
AS_GOOD = 0.02
"""A simpler function is preferred if its largest error is larger by no more than this."""
NARROWEST_M_S = 1e-3

Kind = Literal["constant", "sigmoid", "polynomial"]


class Comparison(msgspec.Struct, frozen=True):
    """A function compared with the measured gains: relative errors over the trusted bands.

    ``gains`` are its own at the curve's ``speeds``.
    """

    kind: Kind
    parameters: dict[str, float]
    median: float
    largest: float
    gains: list[float]


class GainCurve(msgspec.Struct, frozen=True):
    """The curve that a page draws: the gain over the speed of the hand where it is known, and its comparison.

    ``speeds`` in m/s and ``gains`` run over ``excited`` only, the range of speeds with enough samples; both
    are empty and ``excited`` is ``None`` while there is no function, for the reason in ``words``.
    ``measured_speeds``, ``measured_gains``, ``measured_errors``: the bands behind it. ``compared``: a
    constant gain, a sigmoid and the polynomial on the same bands; ``closest``: the simplest of the best fits.
    ``skipped`` reports came after a pause, ``edges`` at the screen's edge, ``fast`` above the range of the
    fit: none of these were used.
    """

    words: str
    speeds: list[float]
    gains: list[float]
    excited: tuple[float, float] | None
    measured_speeds: list[float]
    measured_gains: list[float]
    measured_errors: list[float]
    coefficients: list[float]
    compared: list[Comparison]
    closest: Kind | None
    samples: int
    skipped: int
    edges: int
    fast: int


def curve_of(identification: Identification, bands: Bands, edges: int, fast: int) -> GainCurve:
    """The curve of an identification and the bands behind it, and the events left out by reason."""
    function = identification.function
    speeds = gains = np.zeros(0)
    if function is not None:
        speeds = np.linspace(function.speed_low, function.speed_high, POINTS)
        gains = function.gain(speeds)
    compared = compare(bands, function, speeds)
    return GainCurve(
        words_of(identification),
        speeds.tolist(),
        gains.tolist(),
        None if function is None else (function.speed_low, function.speed_high),
        bands.speeds.tolist(),
        bands.gains.tolist(),
        bands.errors.tolist(),
        [] if function is None else list(function.coefficients),
        compared,
        closest(compared),
        identification.samples,
        identification.skipped,
        edges,
        fast,
    )


def words_of(identification: Identification) -> str:
    """Text: the data behind the identification, or the data it lacks."""
    if identification.samples == 0:
        return "nothing learnt yet: move the mouse"
    if identification.function is None:
        powers = ", ".join(map(str, identification.unexcited))
        return f"the speeds so far do not tell the powers {powers} apart: move slowly, and fast, and between"
    low, high = identification.function.speed_low, identification.function.speed_high
    samples = identification.samples
    return f"identified between {low:.3f} and {high:.3f} m/s of the hand, from {samples} displacements"


def compare(bands: Bands, function: TransferFunction | None, speeds: FloatArray) -> list[Comparison]:
    """A constant gain and a sigmoid fitted to the bands, and ``function``, each with its errors there."""
    certain = bands.trust > 0.5
    if not certain.any():
        return []
    trusted = Bands(bands.speeds[certain], bands.gains[certain], bands.errors[certain])
    constant, sigmoid = {"gain": fitted_constant(trusted)}, fitted_sigmoid(trusted)
    fitted: list[tuple[Kind, TransferFunction, dict[str, float]]] = []
    fitted.append(("constant", ConstantGain(**constant), constant))
    if sigmoid is not None:
        fitted.append(("sigmoid", SigmoidGain(**sigmoid), sigmoid))
    if function is not None:
        fitted.append(("polynomial", function, {}))
    comparisons = []
    for kind, each, parameters in fitted:
        errors = np.abs(each.gain(trusted.speeds) / trusted.gains - 1.0)
        median, largest = float(np.median(errors)), float(errors.max())
        comparisons.append(Comparison(kind, parameters, median, largest, each.gain(speeds).tolist()))
    return comparisons


def closest(compared: list[Comparison]) -> Kind | None:
    """The simplest whose largest error exceeds the smallest by no more than 2 % of the gain."""
    least = min((each.largest for each in compared), default=inf)
    return next((each.kind for each in compared if each.largest <= least + AS_GOOD), None)


def fitted_constant(bands: Bands) -> float:
    """The constant gain whose squared relative errors are least, weighed by trust."""
    inverse = 1.0 / bands.gains
    return float(min(np.sum(bands.trust * inverse) / np.sum(bands.trust * inverse**2), GAIN_MOST))


def fitted_sigmoid(bands: Bands) -> dict[str, float] | None:
    """The sigmoid whose squared relative errors are least, weighed by trust.

    ``None`` with too few bands, and if scipy is not installed.
    """
    if len(bands.speeds) < 5 or find_spec("scipy") is None:
        return None
    from scipy.optimize import least_squares

    weights = np.sqrt(bands.trust)
    low, high = float(bands.speeds[0]), float(bands.speeds[-1])

    def wrong(numbers: FloatArray) -> FloatArray:
        least, most, start, width = numbers
        share = np.clip((bands.speeds - start) / width, 0.0, 1.0)
        errors: FloatArray = weights * ((least + share * (most - least)) / bands.gains - 1.0)
        return errors

    best, cost = None, inf
    for begins, ends in ((0.0, 1.0), (0.1, 0.9), (0.3, 0.6), (0.5, 1.5)):
        start = low + begins * (high - low)
        first = [bands.gains[0], bands.gains[-1], start, (ends - begins) * (high - low)]
        bounds = ([0.0, 0.0, 0.0, NARROWEST_M_S], [GAIN_MOST, GAIN_MOST, SPEED_MOST / 2, SPEED_MOST / 2])
        answer = least_squares(wrong, np.clip(first, *bounds), bounds=bounds, x_scale=np.maximum(first, 1e-3))
        if answer.cost < cost:
            best, cost = answer.x.tolist(), float(answer.cost)
    if best is None:
        return None
    return {"gain_min": best[0], "gain_max": best[1], "speed_low": best[2], "speed_high": best[2] + best[3]}
