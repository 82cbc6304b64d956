"""What an observer uses for inputs that a sample lacks."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred_observers.numerics.matrices import matrix

Given = Any
"""A matrix, or a function of t (of the index in discrete time)."""


class MissingInputs(msgspec.Struct, frozen=True):
    """What replaces the inputs i of w' = N w + L f(Jw + R i) + K i while they are not measured.

    Of a *value* the input is V0 w + V1 f(.). Any other follows i' = V0 w + V1 f(.) + V2 i from its last
    measurement on; in discrete time this is the next i. ``first``: the inputs before their first measurement.
    """

    value: tuple[bool, ...]
    V0: Given
    V1: Given
    V2: Given
    first: FloatArray

    @classmethod
    def held(cls, inputs: int, q: int, k: int, time: str = "continuous") -> MissingInputs:
        """Each input keeps its last value; it is zero before the first.

        >>> MissingInputs.held(1, 2, 0, "discrete").V2.tolist()
        [[1.0]]
        """
        stay = np.eye(inputs) if time == "discrete" else np.zeros((inputs, inputs))
        return cls((False,) * inputs, np.zeros((inputs, q)), np.zeros((inputs, k)), stay, np.zeros(inputs))

    @classmethod
    def expected(cls, V0: Any, V1: Any, inputs: int, time: str = "continuous") -> MissingInputs:
        """The first inputs are outputs, expected to be V0 w + V1 f(.); the others keep their last value."""
        outputs, q = matrix("V0", V0).shape
        seen = matrix("V1", V1, outputs)
        k = seen.shape[1]
        other = cls.held(inputs, q, k, time)
        rest = inputs - outputs
        return msgspec.structs.replace(
            other,
            value=(True,) * outputs + (False,) * rest,
            V0=np.vstack([V0, np.zeros((rest, q))]),
            V1=np.vstack([seen, np.zeros((rest, k))]),
        )

    def checked(self, q: int, k: int, R: FloatArray) -> MissingInputs:
        """The same with its shapes checked at t = 0; ``R`` is the stage's. Raises ParameterError."""
        m = R.shape[1]
        if len(self.value) != m:
            raise ParameterError(f"missing needs {m} inputs, received {len(self.value)}", field="missing")
        sizes = {"V0": q, "V1": k, "V2": m}
        now = dict(zip(sizes, self.at(0.0), strict=True))
        now = {name: matrix(name, one, m, sizes[name]) for name, one in now.items()}
        kept = {name: one for name, one in now.items() if not callable(getattr(self, name))}
        v1, valued = now["V1"], np.array(self.value, bool)
        if (np.abs(R[:, valued]) @ np.abs(v1[valued])).any():
            raise ParameterError(
                "an input that enters f cannot be replaced by a value of f: set its rows of V1 to zero",
                field="missing",
            )
        return msgspec.structs.replace(self, first=matrix("first", self.first, 1, m)[0], **kept)

    @property
    def varies(self) -> bool:
        """Whether a matrix is a function."""
        return any(callable(one) for one in (self.V0, self.V1, self.V2))

    def at(self, t: float) -> tuple[FloatArray, FloatArray, FloatArray]:
        """V0, V1 and V2 at a time."""
        v0, v1, v2 = (
            np.asarray(one(t) if callable(one) else one, np.float64) for one in (self.V0, self.V1, self.V2)
        )
        return v0, v1, v2

    def flat(self) -> list[FloatArray]:
        """What the compiled law holds of it."""
        return [np.array(self.value, np.float64), *self.at(0.0), self.first]
