"""Fitting the network to examples."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.columns import FloatArray
from pointpred.predictors.kinematic import coefficient_file, features
from pointpred.predictors.kinematic import network as net
from pointpred.training import network
from pointpred.training.examples import Examples
from pointpred.training.losses import Truth, slopes

Floats = NDArray[np.float32]
NEAR_SHARE = 0.05
"""Nearer to the end than this share of its trial's mean distance, a moment weighs no more."""


class Settings(msgspec.Struct, frozen=True):
    """How the network is fitted."""

    hidden: tuple[int, int] = (128, 128)
    passes: int = 8
    batch: int = 2048
    rate: float = 3e-3
    decay: float = 1e-4
    noise: float = 0.1
    seed: int = 1
    law_share: float = 0.2
    time_share: float = 5.0
    varied_time: float = 0.05
    """What a varied movement says about the time left, against one as it was made."""
    varied_law: float = 0.5
    """What it says about widths and tail; about the endpoint as much as one as it was made."""
    late: float = 0.75
    """How much more a moment weighs the nearer the cursor is to the end: the power of that nearness."""


class Fitted(msgspec.Struct, frozen=True):
    """A fitted network with what its inputs are brought to."""

    mean: FloatArray
    scale: FloatArray
    layers: network.Layers

    def outputs(self, seen: Floats) -> Floats:
        """The network's outputs for rows of features."""
        said, _ = network.forward(self.layers, inputs(seen, self.mean, self.scale))
        return said


def of_file(path: Path | str = coefficient_file.OWN) -> Fitted:
    """The network of a file, such as that of the package; raises ParameterError."""
    mean, scale, layers = coefficient_file.layers_of(path)
    return Fitted(mean, scale, [(w.astype(np.float32), b.astype(np.float32)) for w, b in layers])


def sides(seen: Floats) -> Floats:
    """``kinematic_net.side`` of rows."""
    bent = seen[:, net.SIDES[0]] + seen[:, net.SIDES[1]]
    side: Floats = bent / np.sqrt(bent**2 + np.float32(net.SIDE_SOFT**2))
    return side


def unmirrored(seen: Floats) -> Floats:
    """Features as if every movement bent to the same side."""
    turned = seen.copy()
    turned[:, features.ODD :] *= sides(seen)[:, None]
    return turned


def inputs(seen: Floats, mean: FloatArray, scale: FloatArray) -> Floats:
    """Features brought to the same mean and spread, extremes cut."""
    brought = (unmirrored(seen) - mean.astype(np.float32)) * scale.astype(np.float32)
    cut: Floats = np.clip(brought, -net.EXTREME, net.EXTREME).astype(np.float32)
    return cut


def truth(given: Examples, settings: Settings) -> Truth:
    """What is to be said for each example, and what it weighs.

    A set's errors count as shares of what ``hold`` errs there; sets count by the fourth root of their
    trials less than by their number.
    """
    seen, reach = given.features, given.reach
    trials = np.bincount(given.trial, given.weight)
    mean = np.bincount(given.trial, given.weight * given.hold()) / np.maximum(trials, 1e-9)
    whole = np.bincount(given.trial, given.weight * (given.left_s / np.maximum(1.0 - given.share, 1e-3)))
    share = np.empty(len(reach))
    mean_hold = np.empty(len(reach))
    for number in np.unique(given.set).tolist():
        rows = given.set == number
        mine = np.unique(given.trial[rows])
        share[rows] = len(mine) ** -0.25
        mean_hold[rows] = mean[mine].mean()
    near = mean[given.trial] / np.maximum(given.hold(), NEAR_SHARE * mean[given.trial])
    moment = given.weight * share
    duration = np.sqrt(np.maximum(whole[given.trial] / np.maximum(trials[given.trial], 1e-9), 0.05))

    def even(weight: FloatArray, scale: float = 1.0) -> Floats:
        weighed: Floats = (scale * weight / weight.mean()).astype(np.float32)
        return weighed

    return Truth(
        seen[:, list(net.BASIS_ALONG)],
        seen[:, list(net.BASIS_ACROSS)],
        sides(seen),
        (given.along / reach).astype(np.float32),
        (given.across / reach).astype(np.float32),
        given.left_s.astype(np.float32),
        seen[:, features.TIME],
        even(moment * near**settings.late * reach / mean_hold),
        even(moment * np.where(given.own, 1.0, settings.varied_law), settings.law_share),
        even(moment / duration * np.where(given.own, 1.0, settings.varied_time), settings.time_share),
    )


def _beginning(given: Examples, settings: Settings, random: np.random.Generator) -> Fitted:
    """A network that knows nothing, with its inputs brought to the mean and spread of the examples."""
    turned = unmirrored(given.features)
    mean, scale = turned.mean(axis=0, dtype=np.float64), 1.0 / (turned.std(axis=0, dtype=np.float64) + 1e-6)
    return Fitted(mean, scale, network.made((features.FEATURES, *settings.hidden, net.OUTPUTS), random))


def fit(
    given: Examples,
    settings: Settings,
    progress: Callable[[int, int, float], None] | None = None,
    start: Fitted | None = None,
) -> Fitted:
    """Fit a network; the same examples and settings give the same network on the same machine.

    ``start``: a network to go on from, with its own sizes and inputs; ``None`` begins with one at random.
    """
    random = np.random.default_rng(settings.seed)
    begun = _beginning(given, settings, random) if start is None else start
    mean, scale = begun.mean, begun.scale
    ready, wanted = inputs(given.features, mean, scale), truth(given, settings)
    layers = [(weights.copy(), offset.copy()) for weights, offset in begun.layers]
    adam = network.Adam(layers, settings.decay)
    batches = max(len(ready) // settings.batch, 1)
    steps, step = settings.passes * batches, 0
    for turn in range(settings.passes):
        order = random.permutation(len(ready))
        total = 0.0
        for rows in np.array_split(order, batches):
            noisy = ready[rows]
            if settings.noise > 0.0:
                noisy = noisy + np.float32(settings.noise) * random.standard_normal(noisy.shape, np.float32)
            said, kept = network.forward(layers, noisy)
            loss, slope = slopes(said, wanted.only(rows))
            total += loss
            adam.step(layers, network.backward(layers, kept, slope), _rate(settings.rate, step / steps))
            step += 1
        if progress is not None:
            progress(turn + 1, settings.passes, total / batches)
    return Fitted(mean, scale, layers)


def _rate(most: float, share: float) -> float:
    """Rises over the first tenth, then falls to nothing along a cosine."""
    if share < 0.1:
        return most * (0.1 + 9.0 * share)
    return most * 0.5 * (1.0 + float(np.cos(np.pi * (share - 0.1) / 0.9)))
