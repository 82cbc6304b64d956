"""The contract between the rooms: a stage consumes one sample and returns its answer.

Each law is one function ``step(memory, sample...)`` on a flat float64 array: parameters first, then what
the stage remembers, which is all zeros while it remembers nothing. ``update`` calls the step once; ``loop``
calls the same step over a table. There is no second implementation.
"""

from __future__ import annotations

import copy
import inspect
from collections.abc import Callable
from typing import Any, ClassVar, Protocol, Self, TypeVar, runtime_checkable

import msgspec
import numpy as np

from pointpred.columns import BoolArray, FloatArray
from pointpred.errors import ParameterError

In = TypeVar("In", contravariant=True)
Out = TypeVar("Out", covariant=True)


@runtime_checkable
class Stage(Protocol[In, Out]):
    """Consumes samples one by one."""

    def update(self, sample: In, /) -> Out:
        """Consume one sample and return the new answer; a sample that is refused changes nothing."""
        ...

    def reset(self) -> None:
        """Forget every sample; one that learns its person keeps what it knows of them."""
        ...

    def fresh(self) -> Self:
        """Return a stage with the same parameters and no memory."""
        ...


class Parameter(msgspec.Struct, frozen=True):
    """What a user may set: its unit, its closed bounds and what it does."""

    name: str
    unit: str
    low: float
    high: float
    meaning: str


class Slot(msgspec.Struct, frozen=True):
    """A run of numbers that a stage knows of its person: their name, how many, the closed bounds of each."""

    name: str
    count: int
    low: float
    high: float
    whole: bool = False
    """Whether each is a whole number, such as how many of something are held."""


class CompiledStage:
    """What all stages share whose law is compiled: the flat memory, reset, fresh, and the walk over rows.

    A child names its ``parameters`` (checked against the bounds), its ``loop`` over a table, and the width
    of the rows the loop writes.

    A stage that learns its person keeps what it knows between the parameters and the movement's memory:
    ``learned`` floats, all zero while it knows nothing. ``reset`` and a row marked ``begin`` forget the
    movement only, after ``conclude(memory)`` has taken from it what is worth keeping; its loop calls the same
    law before it forgets. ``fresh`` knows nobody.

    What it knows can be saved as a string (``pointpred.person``) where ``slots`` names the ``learned`` floats
    in their order. Within the bounds of the slots, and where ``doubt`` has no objection, no memory makes the
    law fail or answer NaN.
    """

    parameters: ClassVar[tuple[Parameter, ...]] = ()
    width: int
    loop: ClassVar[Callable[..., None]]
    learned: int = 0
    conclude: ClassVar[Callable[..., None]] = staticmethod(lambda memory: None)
    slots: ClassVar[tuple[Slot, ...]] = ()
    doubt: ClassVar[Callable[..., str]] = staticmethod(lambda known: "")
    """What is wrong with learned floats that are each within their bounds, in words; empty for nothing."""

    def __init__(self, settings: list[float] | FloatArray, states: int) -> None:
        """Lay out the memory: ``settings`` first, ``learned`` zeros, then ``states`` zeros."""
        self._first = len(settings) + self.learned
        self._memory = np.zeros(self._first + states)
        self._memory[: len(settings)] = settings

    def reset(self) -> None:
        """Forget every sample of the movement: the memory is replaced whole."""
        memory = self._memory.copy()
        type(self).conclude(memory)
        memory[self._first :] = 0.0
        self._memory = memory

    def fresh(self) -> Self:
        """Return a stage with the same parameters, which remembers no sample and knows nobody."""
        twin = copy.copy(self)
        twin._memory[self._first - self.learned :] = 0.0
        return twin

    @property
    def known(self) -> FloatArray:
        """What finished movements taught: a view of the learned floats."""
        return self._memory[self._first - self.learned : self._first]

    def remembered(self) -> bytes:
        """The memory as it is now, to be given back to ``recall``."""
        return self._memory.tobytes()

    def recall(self, memory: bytes) -> None:
        """Go on from where ``remembered`` was asked."""
        self._memory[:] = np.frombuffer(memory)

    def __copy__(self) -> Self:
        twin = type(self).__new__(type(self))
        twin.__dict__.update(self.__dict__)
        twin._memory = self._memory.copy()
        return twin

    def walk(self, begin: BoolArray, rows: FloatArray) -> FloatArray:
        """Run the law over rows, resetting before each row marked ``begin``; continues from the memory."""
        out = np.full((len(rows), self.width), np.nan)
        type(self).loop(self._memory, self._first, begin, rows, out)
        return out


def check(parameters: tuple[Parameter, ...], values: dict[str, Any]) -> None:
    """Raise ParameterError for a value that is not a number within its bounds."""
    for parameter in parameters:
        value = values[parameter.name]
        unit = f" {parameter.unit}" if parameter.unit else ""
        if isinstance(value, bool) or not isinstance(value, int | float | np.integer | np.floating):
            kind = f"a number ({parameter.unit})" if unit else "a number"
            raise ParameterError(f"{parameter.name} must be {kind}, received {value!r}")
        if not parameter.low <= value <= parameter.high:
            raise ParameterError(
                f"{parameter.name} must lie in [{parameter.low:g}, {parameter.high:g}]{unit}, "
                f"received {value!r}"
            )


def defaults(stage: type[CompiledStage]) -> dict[str, Any]:
    """The default of each parameter of a stage, read from its constructor."""
    signature = inspect.signature(stage.__init__)
    return {p.name: signature.parameters[p.name].default for p in stage.parameters}


def settable(stage: type[CompiledStage]) -> tuple[str, ...]:
    """Everything a stage's constructor accepts: its parameters, and choices that are no numbers."""
    return tuple(name for name in inspect.signature(stage.__init__).parameters if name != "self")
