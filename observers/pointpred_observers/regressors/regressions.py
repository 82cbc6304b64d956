"""Constants in a regression beside the regressors that estimate them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred.regression import RecursiveLeastSquares
from pointpred_observers.numerics.matrices import matrix
from pointpred_observers.plants.nonlinearity import nonlinearity
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

    def simulated(self, regressor: Any, setting: Setting) -> Simulation:
        """The parameters beside those that a regressor estimates; see ``simulate``."""
        unused = ("start", "estimate", "input", "disturbance", "unknown_input", "schedule")
        setting.refuse("a regression", *unused)
        title = TITLES.get(type(regressor))
        if title is None:
            known = ", ".join(one.__name__ for one in TITLES)
            raise ParameterError(
                f"a Regression needs one of {known}, received {type(regressor).__name__}", field="observer"
            )
        running, weight = regressor.fresh(), self.weight
        if isinstance(regressor, NonlinearRegressor) and weight is None:
            raise ParameterError(
                "a NonlinearRegressor needs the plant's weight D1, a function of t", field="plant"
            )
        times = setting.samples(discrete=False)
        pairs = [self.at(float(t)) for t in times]
        theta, rows = np.array([one for one, _ in pairs]), [d for _, d in pairs]
        exact = np.array([d @ one for one, d in pairs])
        weights = np.zeros((len(times), 1))
        if weight is not None:
            f = nonlinearity(self.f, exact.shape[1])
            weights[:, 0] = [float(weight(float(t))) for t in times]
            exact = (1.0 - weights) * exact + weights * np.array([f(one) for one in exact])
        outputs, estimate = setting.measured(exact), np.full_like(theta, np.nan)
        for i, t in enumerate(times.tolist()):
            if isinstance(running, NonlinearRegressor):
                estimate[i] = running.update(rows[i], weights[i, 0], outputs[i], t)
            elif isinstance(running, GradientRegressor):
                estimate[i] = running.update(rows[i], outputs[i], t)
            else:
                running.update(rows[i][0], float(outputs[i][0]), t)
                values = running.fit().values
                estimate[i] = np.nan if values is None else values  # None before they are determined
        none = np.zeros((len(times), 0))
        names = tuple(f"theta{i + 1}" for i in range(theta.shape[1]))
        return Simulation(
            times, theta, estimate, outputs, none, names, title, False, none, none, none, none, np.zeros(0)
        )


TITLES: dict[type, str] = {
    GradientRegressor: "gradient regressor",
    NonlinearRegressor: "nonlinear regressor",
    RecursiveLeastSquares: "recursive least squares",
}
