"""Fitting the network to examples."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.predictors.kinematic import coefficient_file, features
from pointpred.predictors.kinematic import network as net
from pointpred.records import FloatArray
from pointpred.training import network
from pointpred.training.data import Examples
from pointpred.training.fitting import Truth, slopes

Floats = NDArray[np.float32]
NEAR_SHARE = 0.05
"""Nearer to the end than this share of its trial's mean distance, a moment weighs no more."""


class Settings(msgspec.Struct, frozen=True):
    """How the network is fitted."""

    hidden: tuple[int, int] = (64, 48)
    passes: int = 24
    batch: int = 2048
    rate: float = 3e-3
    decay: float = 1e-4
    noise: float = 0.05
    seed: int = 1
    law_share: float = 0.2
    time_share: float = 5.0
    varied_time: float = 0.05
    """What a varied movement says about the time left, against one as it was made."""
    varied_law: float = 0.5
    """What it says about widths and tail; about the endpoint as much as one as it was made."""
    late: float = 0.75
    """How much more a moment weighs the nearer the cursor is to the end: the power of that nearness."""


class FittedNetwork(msgspec.Struct, frozen=True):
    """A fitted network with what its inputs are brought to."""

    mean: FloatArray
    scale: FloatArray
    layers: network.Layers

    def outputs(self, moments: Floats) -> Floats:
        """The network's outputs for rows of features."""
        outputs, _ = network.forward(self.layers, inputs(moments, self.mean, self.scale))
        return outputs


def load_network(path: Path | str = coefficient_file.OWN) -> FittedNetwork:
    """The network of a file, such as that of the package; raises ParameterError."""
    mean, scale, layers = coefficient_file.layers_of(path)
    return FittedNetwork(mean, scale, [(w.astype(np.float32), b.astype(np.float32)) for w, b in layers])


def sides(moments: Floats) -> Floats:
    """``side`` of ``predictors.kinematic.network``, of rows."""
    bent = moments[:, net.SIDES[0]] + moments[:, net.SIDES[1]]
    side: Floats = bent / np.sqrt(bent**2 + np.float32(net.SIDE_SOFT**2))
    return side


def unmirrored(moments: Floats) -> Floats:
    """Features as if every movement bent to the same side."""
    turned = moments.copy()
    turned[:, features.ODD :] *= sides(moments)[:, None]
    return turned


def inputs(moments: Floats, mean: FloatArray, scale: FloatArray) -> Floats:
    """Features brought to the same mean and spread, extremes cut."""
    brought = (unmirrored(moments) - mean.astype(np.float32)) * scale.astype(np.float32)
    cut: Floats = np.clip(brought, -net.EXTREME, net.EXTREME).astype(np.float32)
    return cut


def truth(examples: Examples, settings: Settings) -> Truth:
    """The answers that training works towards, and the weight of each example.

    A set's errors count as shares of what ``hold`` errs there; sets count by the fourth root of their
    trials less than by their number.
    """
    moments, reach = examples.features, examples.reach
    trials = np.bincount(examples.trial, examples.weight)
    mean = np.bincount(examples.trial, examples.weight * examples.hold()) / np.maximum(trials, 1e-9)
    whole = np.bincount(
        examples.trial, examples.weight * (examples.left_s / np.maximum(1.0 - examples.share, 1e-3))
    )
    share = np.empty(len(reach))
    mean_hold = np.empty(len(reach))
    for number in np.unique(examples.set).tolist():
        rows = examples.set == number
        mine = np.unique(examples.trial[rows])
        share[rows] = len(mine) ** -0.25
        mean_hold[rows] = mean[mine].mean()
    near = mean[examples.trial] / np.maximum(examples.hold(), NEAR_SHARE * mean[examples.trial])
    moment = examples.weight * share
    duration = np.sqrt(np.maximum(whole[examples.trial] / np.maximum(trials[examples.trial], 1e-9), 0.05))

    def even(weight: FloatArray, scale: float = 1.0) -> Floats:
        weighed: Floats = (scale * weight / weight.mean()).astype(np.float32)
        return weighed

    return Truth(
        moments[:, list(net.BASIS_ALONG)],
        moments[:, list(net.BASIS_ACROSS)],
        sides(moments),
        (examples.along / reach).astype(np.float32),
        (examples.across / reach).astype(np.float32),
        examples.left_s.astype(np.float32),
        moments[:, features.TIME],
        even(moment * near**settings.late * reach / mean_hold),
        even(moment * np.where(examples.own, 1.0, settings.varied_law), settings.law_share),
        even(moment / duration * np.where(examples.own, 1.0, settings.varied_time), settings.time_share),
    )


def _beginning(examples: Examples, settings: Settings, random: np.random.Generator) -> FittedNetwork:
    """A network that knows nothing, with its inputs brought to the mean and spread of the examples."""
    turned = unmirrored(examples.features)
    mean, scale = turned.mean(axis=0, dtype=np.float64), 1.0 / (turned.std(axis=0, dtype=np.float64) + 1e-6)
    return FittedNetwork(
        mean, scale, network.random_layers((features.FEATURES, *settings.hidden, net.OUTPUTS), random)
    )


def fit(
    examples: Examples,
    settings: Settings,
    progress: Callable[[int, int, float], None] | None = None,
    start: FittedNetwork | None = None,
) -> FittedNetwork:
    """Fit a network; the same examples and settings give the same network on the same machine.

    ``start``: a network to go on from, with its own sizes and inputs; ``None`` begins with one at random.
    """
    random = np.random.default_rng(settings.seed)
    initial = _beginning(examples, settings, random) if start is None else start
    mean, scale = initial.mean, initial.scale
    ready, target = inputs(examples.features, mean, scale), truth(examples, settings)
    layers = [(weights.copy(), offset.copy()) for weights, offset in initial.layers]
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
            outputs, cache = network.forward(layers, noisy)
            loss, slope = slopes(outputs, target.only(rows))
            total += loss
            adam.step(layers, network.backward(layers, cache, slope), _rate(settings.rate, step / steps))
            step += 1
        if progress is not None:
            progress(turn + 1, settings.passes, total / batches)
    return FittedNetwork(mean, scale, layers)


def _rate(most: float, share: float) -> float:
    """Rises over the first tenth, then falls to nothing along a cosine."""
    if share < 0.1:
        return most * (0.1 + 9.0 * share)
    return most * 0.5 * (1.0 + float(np.cos(np.pi * (share - 0.1) / 0.9)))
