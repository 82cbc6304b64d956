"""Fitting the network to examples: the network, what training makes small, and the fit."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.predictors.kinematic import coefficient_file, features
from pointpred.predictors.kinematic import network as net
from pointpred.records import FloatArray
from pointpred.training.data import Examples

Floats = NDArray[np.float32]
Layers = list[tuple[Floats, Floats]]
"""Weights (inputs, outputs) and offsets of each layer."""


def random_layers(sizes: tuple[int, ...], random: np.random.Generator) -> Layers:
    """Layers at random; the last one small, so that training begins near no answer at all."""
    layers: Layers = []
    for inputs, outputs in pairwise(sizes):
        scale = np.sqrt(2.0 / inputs) * (0.1 if len(layers) == len(sizes) - 2 else 1.0)
        weights = (random.standard_normal((inputs, outputs)) * scale).astype(np.float32)
        layers.append((weights, np.zeros(outputs, np.float32)))
    return layers


def forward(layers: Layers, inputs: Floats) -> tuple[Floats, list[tuple[Floats, Floats, Floats]]]:
    """Outputs, and what the gradient needs of each layer: its inputs, its sums, the shares that pass."""
    cache = []
    for weights, offset in layers[:-1]:
        sums = inputs @ weights + offset
        shares = np.clip(sums * np.float32(net.GATE_SLOPE) + np.float32(0.5), 0.0, 1.0)
        cache.append((inputs, sums, shares))
        inputs = sums * shares
    weights, offset = layers[-1]
    cache.append((inputs, inputs, inputs))
    return inputs @ weights + offset, cache


def backward(layers: Layers, cache: list[tuple[Floats, Floats, Floats]], slope: Floats) -> Layers:
    """The gradient of every weight from that of the outputs."""
    gradient: Layers = []
    for place in range(len(layers) - 1, -1, -1):
        inputs, _, _ = cache[place]
        gradient.append((inputs.T @ slope, slope.sum(axis=0)))
        if place > 0:
            _, sums, shares = cache[place - 1]
            bent = shares + sums * np.float32(net.GATE_SLOPE) * ((shares > 0.0) & (shares < 1.0))
            slope = ((slope @ layers[place][0].T) * bent).astype(np.float32)
    return gradient[::-1]


class Adam:
    """Adam with decoupled decay of the weights (Loshchilov, Hutter 2019)."""

    def __init__(self, layers: Layers, decay: float) -> None:
        self._first = [(np.zeros_like(w), np.zeros_like(b)) for w, b in layers]
        self._second = [(np.zeros_like(w), np.zeros_like(b)) for w, b in layers]
        self._decay = decay
        self._steps = 0

    def step(self, layers: Layers, gradient: Layers, rate: float) -> None:
        """One step down the gradient, in place."""
        self._steps += 1
        grown = 1.0 - 0.9**self._steps, 1.0 - 0.999**self._steps
        for layer, slopes, first, second in zip(layers, gradient, self._first, self._second, strict=True):
            for place in range(2):
                first[place][:] = 0.9 * first[place] + 0.1 * slopes[place]
                second[place][:] = 0.999 * second[place] + 0.001 * slopes[place] ** 2
                way = (first[place] / grown[0]) / (np.sqrt(second[place] / grown[1]) + 1e-8)
                if place == 0:
                    way = way + self._decay * layer[place]
                layer[place][:] -= np.float32(rate) * way


SOFT = 1e-5
"""Squared distances below this share of the squared reach are as good as none."""
FASTEST_S = 0.02
"""Added to both times before their logarithms are compared: the clock of a screen is not finer."""
FAR = 3.0


class Truth(msgspec.Struct, frozen=True):
    """What the network should have predicted, a row a moment, and what each moment weighs."""

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
    layers: Layers

    def outputs(self, moments: Floats) -> Floats:
        """The network's outputs for rows of features."""
        outputs, _ = forward(self.layers, inputs(moments, self.mean, self.scale))
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
        moments[:, features.PLACE["time"]],
        even(moment * near**settings.late * reach / mean_hold),
        even(moment * np.where(examples.own, 1.0, settings.varied_law), settings.law_share),
        even(moment / duration * np.where(examples.own, 1.0, settings.varied_time), settings.time_share),
    )


def _beginning(examples: Examples, settings: Settings, random: np.random.Generator) -> FittedNetwork:
    """A network that knows nothing, with its inputs brought to the mean and spread of the examples."""
    turned = unmirrored(examples.features)
    mean, scale = turned.mean(axis=0, dtype=np.float64), 1.0 / (turned.std(axis=0, dtype=np.float64) + 1e-6)
    return FittedNetwork(
        mean, scale, random_layers((features.Values.length, *settings.hidden, net.Outputs.length), random)
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
    adam = Adam(layers, settings.decay)
    batches = max(len(ready) // settings.batch, 1)
    steps, step = settings.passes * batches, 0
    for turn in range(settings.passes):
        order = random.permutation(len(ready))
        total = 0.0
        for rows in np.array_split(order, batches):
            noisy = ready[rows]
            if settings.noise > 0.0:
                noisy = noisy + np.float32(settings.noise) * random.standard_normal(noisy.shape, np.float32)
            outputs, cache = forward(layers, noisy)
            loss, slope = slopes(outputs, target.only(rows))
            total += loss
            adam.step(layers, backward(layers, cache, slope), _rate(settings.rate, step / steps))
            step += 1
        if progress is not None:
            progress(turn + 1, settings.passes, total / batches)
    return FittedNetwork(mean, scale, layers)


def _rate(most: float, share: float) -> float:
    """Rises over the first tenth, then falls to nothing along a cosine."""
    if share < 0.1:
        return most * (0.1 + 9.0 * share)
    return most * 0.5 * (1.0 + float(np.cos(np.pi * (share - 0.1) / 0.9)))
