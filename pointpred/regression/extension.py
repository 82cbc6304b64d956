"""DREM for Python: samples in, estimates of the constants out, each by its own scalar equation."""

from __future__ import annotations

from collections.abc import Sequence
from math import expm1
from typing import Any

import msgspec

from pointpred.parameter import parameter
from pointpred.records import FloatArray
from pointpred.regression import drem
from pointpred.regression.recursive_least_squares import moment, sample
from pointpred.stage import CompiledStage

DELAY_S, GAMMA, AT = range(3)


class Estimate(msgspec.Struct, frozen=True):
    """The constants at ``t`` s.

    ``phi`` in [-1, 1] is the present excitation, and ``learnt`` in [0, 1] the fraction covered of the
    distance from the initial values (zeros) to the constants: below 1 the values are biased towards zero.
    """

    t: float
    values: tuple[float, ...]
    phi: float
    learnt: float


class DynamicRegressorExtension(CompiledStage):
    """Dynamic regressor extension and mixing (DREM) with the delays 0, tau, 2 tau, ...

    Assumes y = w'theta with constant theta. Needs some excitation, though not persistent: over short delays
    the rows are nearly equal, phi falls with the power n (n - 1) / 2 of the delay, and noise dominates.

    Row i of Phi and Y is w and y delayed by i tau; phi = det Phi, Y~ = adj(Phi) Y = phi theta, so that each
    theta_i' = gamma phi (Y~_i - phi theta_i) is independent; integrated exactly over each step. Columns are
    scaled by their largest values so far and rows by their norms: |phi| <= 1 in any units.

    Parameters: ``count`` of unknowns, 2 to 6; ``delay_s`` tau in s; ``gamma`` in 1/s, the rate at full
    excitation (real phi are small: 1e6 is not unusual).
    Memory: 2 + drem.states(count) floats, 701 for three. Raises ParameterError, and EventError and
    EventOrderError from ``update``.

    Reference: Khalin 2022, section 2.5.3, with the delay e^(-i tau s) where e^(i tau s) is printed;
    Aranovskiy, Bobtsov, Ortega, Pyrkin 2016.

    >>> from math import sin
    >>> stage = DynamicRegressorExtension(2, delay_s=0.5, gamma=100.0)
    >>> for i in range(300):
    ...     estimate = stage.update((sin(i / 50), 1.0), 3.0 * sin(i / 50) + 2.0, i / 100)
    >>> [round(value, 6) for value in estimate.values]
    [3.0, 2.0]
    """

    count: int = parameter("", 2, 6, "number of unknown constants", default=3, whole=True, kw_only=False)
    delay_s: float = parameter("s", 1e-4, 1e2, "basic delay tau", default=0.1)
    gamma: float = parameter("1/s", 0.0, 1e18, "rate of the estimates at full excitation", default=1e6)

    def declare(self, **values: Any) -> None:
        """Check the values."""
        super().declare(**values)
        self.count = int(self.count)
        self.states = drem.states(self.count)

    def settings(self) -> list[float]:
        """The beginning of the memory."""
        return [float(self.delay_s), float(self.gamma)]

    def update(self, regressor: Sequence[float] | FloatArray, output: float, t: float) -> Estimate | None:
        """Process output = regressor . theta at ``t`` s; ``None`` while the history is too short.

        That is before n - 1 delays have passed. Raises EventError for a value that is not finite or a
        regressor of another length, EventOrderError when time runs backwards; the stage is then unchanged.
        """
        memory, n = self._memory, self.count
        last_t = float(memory[AT + drem.T]) if memory[AT + drem.STARTED] == 1.0 else None
        w, y = sample(n, regressor, output)
        now = moment(t, last_t)
        memory[AT + drem.REGRESSOR : AT + drem.REGRESSOR + n] = w
        if not drem.advance(memory, AT, n, memory[DELAY_S], memory[GAMMA], (now, y)):
            return None
        first = drem.estimates(AT, n)
        learnt = -expm1(-float(memory[AT + drem.EXCITATION]))
        return Estimate(now, tuple(memory[first : first + n].tolist()), float(memory[AT + drem.PHI]), learnt)
