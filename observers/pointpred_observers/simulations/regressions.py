"""Constants in a regression beside the regressors that estimate them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred.regression import RecursiveLeastSquares
from pointpred_observers.matrices import instance, matrix
from pointpred_observers.nonlinearity import Nonlinearity, nonlinearity
from pointpred_observers.regressors.gradient import GradientRegressor, NonlinearRegressor
from pointpred_observers.simulations.result import Simulation
from pointpred_observers.simulations.signals import Setting


class Regression(msgspec.Struct, frozen=True):
    """y = D theta, the plant of a regressor: constants (or slowly moving numbers) seen through D.

    ``parameters`` theta (n) or a function of t; ``regressor`` D (p, n), or (n) for one output, as a function
    of t. With a ``weight`` D1, a function of t, the sensor saturates: y = (1 - D1) D theta + D1 f(D theta).

    >>> line = Regression([3.0, 5.0], lambda t: [1.0, t])
    >>> line.at(2.0)[0].tolist(), line.at(2.0)[1].tolist()
    ([3.0, 5.0], [[1.0, 2.0]])
    """

    parameters: Any
    regressor: Callable[[float], Any]
    weight: Callable[[float], float] | None = None
    f: Any = "atan"

    def at(self, t: float) -> tuple[FloatArray, FloatArray]:
        """Theta and D at a time."""
        given = self.parameters(t) if callable(self.parameters) else self.parameters
        theta = matrix("parameters", given, 1)[0]
        return theta, matrix("regressor", self.regressor(t), None, len(theta))


def gradient(stage: GradientRegressor, plant: Any, setting: Setting) -> Simulation:
    """A gradient regressor."""
    return _estimated(stage, plant, setting, lambda one, t, d, y: one.update(d, y, t), "gradient regressor")


def least_squares(stage: RecursiveLeastSquares, plant: Any, setting: Setting) -> Simulation:
    """Recursive least squares; there is no estimate before the constants are determined."""

    def update(one: RecursiveLeastSquares, t: float, d: FloatArray, y: FloatArray) -> Any:
        one.update(d[0], float(y[0]), t)
        values = one.fit().values
        return np.nan if values is None else values

    return _estimated(stage, plant, setting, update, "recursive least squares")


def nonlinear(stage: NonlinearRegressor, plant: Any, setting: Setting) -> Simulation:
    """A nonlinear regressor, whose sensor saturates with the plant's weight."""
    weight = instance("plant", plant, Regression).weight
    if weight is None:
        raise ParameterError(
            "a NonlinearRegressor needs the plant's weight D1, a function of t", field="plant"
        )

    def update(one: NonlinearRegressor, t: float, d: FloatArray, y: FloatArray) -> Any:
        return one.update(d, float(weight(t)), y, t)

    return _estimated(stage, plant, setting, update, "nonlinear regressor")


def _estimated(stage: Any, plant: Any, setting: Setting, update: Any, title: str) -> Simulation:
    setting.refuse("a regression", "start", "estimate", "input", "disturbance", "unknown_input", "schedule")
    model, times = instance("plant", plant, Regression), setting.samples(discrete=False)
    pairs = [model.at(float(t)) for t in times]
    theta, rows = np.array([one for one, _ in pairs]), [d for _, d in pairs]
    exact = np.array([d @ one for one, d in pairs])
    if model.weight is not None:
        f: Nonlinearity = nonlinearity(model.f, exact.shape[1])
        weights = np.array([float(model.weight(float(t))) for t in times])[:, None]
        exact = (1.0 - weights) * exact + weights * np.array([f(one) for one in exact])
    outputs, running = setting.measured(exact), stage.fresh()
    estimate = np.full_like(theta, np.nan)
    for i, t in enumerate(times.tolist()):
        estimate[i] = update(running, t, rows[i], outputs[i])
    none = np.zeros((len(times), 0))
    names = tuple(f"theta{i + 1}" for i in range(theta.shape[1]))
    return Simulation(
        times, theta, estimate, outputs, none, names, title, False, none, none, none, none, np.zeros(0)
    )
