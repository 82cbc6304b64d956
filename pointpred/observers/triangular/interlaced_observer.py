"""The reduced-order observer of an interlaced system (4.16) as a stage on irregular samples."""

from __future__ import annotations

from math import isfinite

import msgspec
import numpy as np
from numpy.typing import ArrayLike

from pointpred.columns import FloatArray
from pointpred.errors import EventError, ParameterError
from pointpred.observers.matrices import matrix
from pointpred.observers.triangular import interlaced_law as law
from pointpred.observers.triangular.interlaced_certificate import InterlacedCertificate, certify
from pointpred.observers.triangular.polynomials import symbolic
from pointpred.observers.triangular.program import ROW, program
from pointpred.observers.triangular.system import SymbolicSteadyState
from pointpred.parameter import Parameter, check
from pointpred.regression.recursive_least_squares import moment
from pointpred.stage import CompiledStage


class InterlacedEstimate(msgspec.Struct, frozen=True):
    """The generator's state w, the plant's state x = pi(w), its zero dynamics z = rho(w) and input l(w)."""

    t: float
    w: tuple[float, ...]
    x: tuple[float, ...]
    z: tuple[float, ...]
    input: float


class InterlacedObserver(CompiledStage):
    """Estimate the state of a plant from that of the generator which drives it.

    Assumes that the plant converges to its steady state (assumption 4.4.2): what it has not is an error of y.
    Between two samples y lies on a line. An interval longer than ``gap_s``, or with an end at which nothing
    was measured, is bridged by the generator alone; after one of more than 2048 times the generator's time
    constant w begins anew. Where the steady state is a truncated series, x and z are good near the origin
    only. NaN stands for what has no finite value.

    w' = A w + L (y - C w), x = pi(w), z = rho(w), u = l(w), followed exactly.

    Parameters: ``steady`` whose outputs must be C w; ``certificate`` with L, from ``certify``; ``start`` of
    w, zeros unless given; ``gap_s`` s, 1e-6 to 1e6. Memory: 13 + 4 q + 2 q^2 + p + p q floats and the program
    of the maps. Returns ``InterlacedEstimate`` from ``update``. Raises ParameterError, and EventError and
    EventOrderError from ``update``. Reference: Khalin 2022, Theorem 4.4.1.

    >>> import sympy as sp
    >>> from pointpred.observers.triangular.interlaced_form import interlaced
    >>> from pointpred.observers.triangular.system import SymbolicGenerator, SymbolicSystem
    >>> x1, x2, u, w1, w2 = sp.symbols("x1 x2 u w1 w2")
    >>> plant = SymbolicSystem((x1, x2), (-x1 + x2**2, -x2 + u), u, outputs=(x2,))
    >>> steady = interlaced(plant, SymbolicGenerator((w1, w2), (w2, -w1)), 1, w1, degree=2)
    >>> observer = InterlacedObserver.design(steady)
    >>> for i in range(4000):
    ...     estimate = observer.update(np.cos(0.01 * i), 0.01 * i)
    >>> true = steady.function()((np.cos(39.99), -np.sin(39.99)))
    >>> round(estimate.x[0], 4), round(float(true[0]), 4)
    (0.2887, 0.2887)
    """

    parameters = (Parameter("gap_s", "s", 1e-6, 1e6, "over a longer gap the generator runs alone"),)
    loop = staticmethod(law.loop)

    def __init__(
        self,
        steady: SymbolicSteadyState,
        certificate: InterlacedCertificate,
        *,
        start: ArrayLike | None = None,
        gap_s: float = 1.0,
    ) -> None:
        check(self.parameters, {"gap_s": gap_s})
        a, c = steady.generator.matrix(), output_matrix(steady)
        q, p = len(a), len(c)
        gain = matrix("L", certificate.L, q, p)
        first = np.zeros(q) if start is None else matrix("start", start, q, 1).ravel()
        maps = program(steady.generator.states, (*steady.maps, *steady.zero_maps, steady.input))
        state = law.settings(q, p) + ROW * len(maps.rows) + len(maps.constants)
        computed = state + law.states(q, p)
        rows = maps.placed(state + law.Y + p, state - len(maps.constants), computed)
        closed = a - gain @ c
        speeds = [float(np.abs(one).sum(axis=1).max()) for one in (closed, a)]
        answers = computed + maps.computed - maps.outputs
        shape = [q, p, len(maps.rows), law.settings(q, p), answers, maps.outputs, state, gap_s, *speeds]
        flat = np.concatenate([shape, first, a.ravel(), closed.ravel(), gain.ravel(), rows, maps.constants])
        self.steady, self.certificate = steady, certificate
        self._states, self._outputs = q, p
        self.width = q + maps.outputs
        self.lay_out(flat, law.states(q, p) + maps.computed)

    @classmethod
    def design(
        cls,
        steady: SymbolicSteadyState,
        *,
        rate: float = 0.5,
        gain: ArrayLike | None = None,
        start: ArrayLike | None = None,
        gap_s: float = 1.0,
    ) -> InterlacedObserver:
        """Find a gain, or certify a given one, and build the observer with it; see ``certify``."""
        found = certify(steady.generator.matrix(), output_matrix(steady), rate=rate, gain=gain)
        return cls(steady, found, start=start, gap_s=gap_s)

    def update(self, y: ArrayLike | None, t: float) -> InterlacedEstimate:
        """Take in the outputs at ``t`` s, ``None`` where nothing was measured, and return the estimate.

        Raises EventError for what is not finite or of another length, EventOrderError when time runs
        backwards; nothing is then changed.
        """
        memory = self._memory
        state = int(memory[law.STATE])
        sample = self._sample(y)
        now = moment(t, float(memory[state + law.T]) if memory[state] == 1.0 else None)
        out = np.empty(self.width)
        law.step(memory, now, sample, out)
        values, q, n = out.tolist(), self._states, self._states + len(self.steady.maps)
        return InterlacedEstimate(now, tuple(values[:q]), tuple(values[q:n]), tuple(values[n:-1]), values[-1])

    def _sample(self, y: ArrayLike | None) -> FloatArray:
        if y is None:
            return np.full(self._outputs, np.nan)
        try:
            sample = np.asarray(y, np.float64).reshape(-1)
        except (TypeError, ValueError) as unusable:
            raise EventError(f"outputs must be numbers, received {y!r}") from unusable
        if len(sample) != self._outputs or not all(isfinite(value) for value in sample):
            raise EventError(f"needs {self._outputs} finite outputs, received {y!r}")
        return sample


def output_matrix(steady: SymbolicSteadyState) -> FloatArray:
    """C with h(rho, pi) = C w; raises ParameterError for an output that is not linear in w."""
    states = steady.generator.states
    if not steady.system.outputs:
        raise ParameterError("an observer needs outputs of the system, received none")
    rows = []
    for number, output in enumerate(steady.outputs(), 1):
        row = [symbolic().diff(output, w) for w in states]
        linear = sum((c * w for c, w in zip(row, states, strict=True)), symbolic().Integer(0))
        if any(c.free_symbols for c in row) or symbolic().expand(output - linear) != 0:
            raise ParameterError(f"output {number} must be C w with numbers C, received {output}")
        rows.append([float(c) for c in row])
    return np.array(rows)
