"""The network in training: what the predictor computes, for many moments at once, and its gradient."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from pointpred.predictors.kinematic import network as net

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
