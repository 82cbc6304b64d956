"""Parameter-varying systems given by their matrices at the corners of a box, as files hold them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Self

import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred_observers.matrices import dimensions, instance, matrix
from pointpred_observers.unknown_input.boxes import Box
from pointpred_observers.unknown_input.system import ParameterVaryingSystem, Point
from pointpred_observers.unknown_input.takagi_sugeno import TakagiSugeno


class CornerMatrix:
    """A matrix that is affine in each variable of a box, also beyond it; exact at the corners.

    A variable along which the matrix does not change need not be in the point.

    >>> held = CornerMatrix(Box({"k": (1.0, 3.0)}), np.array([[[10.0]], [[30.0]]]))
    >>> held({"k": 1.5}).tolist(), held({"k": 4.0}).tolist()
    ([[15.0]], [[40.0]])
    """

    def __init__(self, box: Box, values: FloatArray) -> None:
        self.values = values
        wide = [(name, pair) for name, pair in box.bounds.items() if pair[0] < pair[1]]
        mixed = values.reshape((2,) * len(wide) + values.shape[1:])
        self._axes: list[tuple[str, float, float]] = []
        for name, (low, high) in wide:
            place = len(self._axes)
            first, last = np.take(mixed, 0, place), np.take(mixed, 1, place)
            if np.array_equal(first, last):
                mixed = first
            else:
                self._axes.append((name, low, high))
        self._mixed = mixed

    def __call__(self, point: Point) -> FloatArray:
        """The matrix at a point; raises KeyError for a variable that it needs and the point lacks."""
        mixed = self._mixed
        for name, low, high in self._axes:
            share = (point[name] - low) / (high - low)
            at_end = share in (0.0, 1.0)
            mixed = mixed[int(share)] if at_end else (1.0 - share) * mixed[0] + share * mixed[1]
        return mixed


class CornerSystem(ParameterVaryingSystem):
    """x' = A(p) x + b(y, u) + F(p) d, y = C x by the matrices at the corners of a box: it can be saved.

    Affine in each scheduling variable; with one variable the corners are its low and its high end.

    Parameters: ``box``; ``A``, ``F`` and, if it is given, ``TA`` (T A where it needs fewer variables than A):
    a matrix, or one for each vertex of ``box.vertices`` in its order, (vertices, rows, columns); ``C`` p x n;
    ``rates``, ``sizes``, ``time`` as for ``ParameterVaryingSystem``. Raises ParameterError.

    >>> box = Box({"k": (-3.0, -1.0)})
    >>> system = CornerSystem(box, [[[0, 1], [0, -3]], [[0, 1], [0, -1]]], [[1], [0]], [[1, 0]])
    >>> system.a({"k": -2.0}).tolist()
    [[0.0, 1.0], [0.0, -2.0]]
    """

    def __init__(
        self,
        box: Box,
        A: Any,
        F: Any,
        C: Any,
        *,
        TA: Any = None,
        rates: Mapping[str, str] | None = None,
        sizes: Any = None,
        time: str = "continuous",
    ) -> None:
        self.box = instance("box", box, Box)
        held = {
            name: _held(box, name, one) for name, one in (("A", A), ("F", F), ("TA", TA)) if one is not None
        }
        self.corners = {name: one.values for name, one in held.items()}
        super().__init__(
            held.get("A"), held.get("F"), C, rates=rates, decoupled=held.get("TA"), sizes=sizes, time=time
        )
        self.checked(box)

    @classmethod
    def of(cls, system: ParameterVaryingSystem, box: Box) -> Self:
        """The matrices of a system at the corners.

        Raises ParameterError unless A and F are affine in each variable: nothing else would be known of them
        between the corners; also where A needs a variable that the box lacks.
        """
        instance("system", system, ParameterVaryingSystem)
        try:
            drift = TakagiSugeno.of(system.a, box, "A").matrices
        except KeyError as missing:
            raise ParameterError(
                f"A needs the variable {missing}, the box has {', '.join(box.names)}: A has no matrices at "
                "the corners, and a T A cannot be compared with it; keep the program that makes the system, "
                "or take a box that has every variable of A",
                field="A",
            ) from missing
        return cls(
            box,
            drift,
            TakagiSugeno.of(system.f, box, "F").matrices,
            system.c,
            TA=TakagiSugeno.of(system.ta, box, "T A").matrices if system.decoupled else None,
            rates=system.rates,
            sizes=system.sizes,
            time=system.time,
        )


def _held(box: Box, name: str, given: Any) -> CornerMatrix:
    count = len(box.vertices)
    if dimensions(given) != 3:
        values = np.repeat(matrix(name, given)[None], count, axis=0)
    elif len(given) != count:
        raise ParameterError(
            f"{name} needs a matrix, or {count} of them, one for each corner of the box, "
            f"received {len(given)}",
            field=name,
            value=given,
        )
    else:
        values = np.array([matrix(name, one) for one in given])
    return CornerMatrix(box, values)
