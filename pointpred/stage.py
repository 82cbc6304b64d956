"""The contract between the rooms: a stage consumes one sample and returns its answer.

Each law is one function ``step(memory, row)`` on a flat float64 array: parameters first, then what the stage
remembers, which is all zeros while it remembers nothing. ``advance`` calls the step once; the loop that
``loop_of`` makes of it calls the same step over a table. There is no second implementation.
"""

from __future__ import annotations

import copy
import inspect
from collections.abc import Callable
from typing import Any, ClassVar, Protocol, Self, TypeVar, dataclass_transform, runtime_checkable

import numpy as np

from pointpred.compiled import law
from pointpred.errors import EventError, ParameterError
from pointpred.layout import Slot
from pointpred.parameter import Option, Parameter, by_name, complete, declared, option, parameter, signature
from pointpred.records import BoolArray, FloatArray, FloatTable, refusal

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


def offsets(*sizes: int) -> tuple[int, ...]:
    """Where parts of these sizes lie in a memory, one behind the other; the last number is where they end.

    >>> THRESHOLD, BOUND, PAST, END = offsets(1, 1, 24)
    >>> THRESHOLD, BOUND, PAST, END
    (0, 1, 2, 26)
    """
    ends = [0]
    for size in sizes:
        ends.append(ends[-1] + size)
    return tuple(ends)


@law
def copy_values(values: FloatArray, memory: FloatArray) -> None:
    """What most stages do with the numbers of their parameters: these are their settings."""
    for i in range(len(values)):
        memory[i] = values[i]


@law
def learn_nothing(memory: FloatArray) -> None:
    """What most stages do when a movement ends."""


def loop_of(
    step: Callable[..., Any], row_of: Callable[..., Any], conclude: Callable[..., None] = learn_nothing
) -> Callable[..., None]:
    """The compiled loop around a law ``step(memory, row, *shared) -> row`` over a table.

    ``row_of(rows, i)`` takes a row out of the table as a tuple. A row marked ``begin`` forgets the memory
    from ``first`` on, after ``conclude(memory)`` has learned from the movement that it ends. ``shared``: an
    array that many stages read, or none.
    """

    @law
    def loop(
        memory: FloatArray,
        first: int,
        begin: BoolArray,
        rows: FloatTable,
        out: FloatTable,
        *shared: FloatArray,
    ) -> None:
        for i in range(len(rows)):
            if begin[i]:
                conclude(memory)
                memory[first:] = 0.0
            answer = step(memory, row_of(rows, i), *shared)
            for j in range(len(answer)):
                out[i, j] = answer[j]

    return loop


def loop_into(step: Callable[..., Any]) -> Callable[..., None]:
    """The compiled loop around a law ``step(memory, row, out)`` on arrays, for rows of any width."""

    @law
    def loop(memory: FloatArray, first: int, begin: BoolArray, rows: FloatTable, out: FloatTable) -> None:
        for i in range(len(rows)):
            if begin[i]:
                memory[first:] = 0.0
            step(memory, rows[i], out[i])

    return loop


@law
def first_refused(answers: FloatTable) -> int:
    """The first row whose answer is a refusal, with NaN for a time; -1 where there is none."""
    for i in range(len(answers)):
        if answers[i, 0] != answers[i, 0]:
            return i
    return -1


@dataclass_transform(kw_only_default=True, field_specifiers=(parameter, option))
class CompiledStage:
    """What all stages share whose law is compiled: the flat memory, reset, fresh, and the walk over rows.

    A child declares what may be set by ``parameter`` and ``option``; its constructor takes these keywords,
    checks them, and keeps each as an attribute. It gives its ``step``, the ``loop`` over a table, the
    ``width`` of the rows that the loop writes, and ``states``, how many floats the step remembers.

    A stage that learns its person keeps what it knows between the parameters and the movement's memory:
    ``learned`` floats, all zero while it knows nothing. ``reset`` and a row marked ``begin`` forget the
    movement only, after ``conclude(memory)`` has taken from it what is worth keeping; its loop calls the same
    law before it forgets. ``fresh`` knows nobody.

    What it knows can be saved as a string (``pointpred.person``) where ``slots`` names the ``learned`` floats
    in their order. Within the bounds of the slots, and where ``doubt`` has no objection, no memory makes the
    law fail or answer NaN.
    """

    __signature__: ClassVar[inspect.Signature]
    declarations: ClassVar[tuple[Parameter | Option, ...]] = ()
    parameters: ClassVar[tuple[Parameter, ...]] = ()
    """The declarations that are numbers."""
    fill: ClassVar[Callable[..., None]] = staticmethod(copy_values)
    """Writes the settings, which stand first in a memory, from the parameters' numbers in their order."""
    sizes: ClassVar[Callable[..., tuple[int, int, int]] | None] = None
    """How many settings, learned floats and states follow from the values; None: always as many."""
    states: int = 0
    step: ClassVar[Callable[..., Any]]
    width: int
    loop: ClassVar[Callable[..., None]]
    learned: int = 0
    conclude: ClassVar[Callable[..., None]] = staticmethod(lambda memory: None)
    slots: ClassVar[tuple[Slot, ...]] = ()
    shared: tuple[FloatArray, ...] = ()
    """An array that the law reads besides its memory and many stages share, or none."""
    doubt: ClassVar[Callable[..., str]] = staticmethod(lambda known: "")
    """What is wrong with learned floats that are each within their bounds, in words; empty for nothing."""

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        cls.declarations = declared(vars(cls), cls.declarations)
        if "parameters" not in vars(cls):
            cls.parameters = tuple(one for one in cls.declarations if isinstance(one, Parameter))
        if cls.__init__ is CompiledStage.__init__:
            cls.__signature__ = signature(cls.declarations)

    def __init__(self, *first: Any, **values: Any) -> None:
        """Check the values and lay out the memory; raises ParameterError."""
        self.declare(**by_name(type(self).declarations, first), **values)
        self.lay_out(self.settings(), self.states)

    def declare(self, **values: Any) -> None:
        """Check the values of the declarations, and keep them as attributes; raises ParameterError."""
        self.__dict__.update(complete(type(self).__name__, type(self).declarations, values))

    def settings(self) -> list[float] | FloatArray:
        """What stands first in the memory: as many numbers as there are parameters, made by ``fill``."""
        return self.filled(len(type(self).parameters))

    def filled(self, count: int) -> FloatArray:
        """So many settings, as ``fill`` makes them of the parameters' numbers."""
        settings = np.zeros(count)
        type(self).fill(self.values(), settings)
        return settings

    def values(self) -> FloatArray:
        """The parameters' numbers in the order of their declarations."""
        return np.array([one.number(getattr(self, one.name)) for one in type(self).parameters])

    def lay_out(self, settings: list[float] | FloatArray, states: int) -> None:
        """Make the memory: ``settings`` first, ``learned`` zeros, then ``states`` zeros."""
        self._first = len(settings) + self.learned
        self._memory = np.zeros(self._first + states)
        self._memory[: len(settings)] = settings

    def __repr__(self) -> str:
        """The class and the numbers and words that are not its defaults."""
        said = [(one, getattr(self, one.name)) for one in type(self).declarations]
        short = ((one, value) for one, value in said if isinstance(value, int | float | str))
        values = (f"{one.name}={value!r}" for one, value in short if value != one.default)
        return f"{type(self).__name__}({', '.join(values)})"

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

    @property
    def memory_bytes(self) -> int:
        """Bytes of the memory."""
        return self._memory.nbytes

    def remembered(self) -> bytes:
        """The memory as it is now, to be given back to ``recall``."""
        return self._memory.tobytes()

    def recall(self, memory: bytes) -> None:
        """Go on from where ``remembered`` was asked; raises ParameterError for another stage's memory."""
        if len(memory) != self._memory.nbytes:
            raise ParameterError(f"memory must have {self._memory.nbytes} bytes, received {len(memory)}")
        self._memory[:] = np.frombuffer(memory)

    def __copy__(self) -> Self:
        twin = type(self).__new__(type(self))
        twin.__dict__.update(self.__dict__)
        twin._memory = self._memory.copy()
        return twin

    def advance(self, row: Any, /) -> Any:
        """One row through the law: its answer, whose first number is NaN where the row is refused.

        Nothing has changed then, and the answer says why; see ``records.refusal``.
        """
        return type(self).step(self._memory, row, *self.shared)

    def walk(self, begin: BoolArray, rows: FloatArray) -> FloatArray:
        """Run the law over rows, resetting before each row marked ``begin``; continues from the memory.

        A row that is refused changes nothing, and its answer says why; the rows after it are taken. Raises
        EventError where ``begin`` has fewer marks than there are rows.
        """
        if len(begin) < len(rows):
            raise EventError(f"begin needs {len(rows)} rows, received {len(begin)}")
        out = np.full((len(rows), self.width), np.nan)
        type(self).loop(self._memory, self._first, begin, rows, out, *self.shared)
        return out

    def walk_all(self, begin: BoolArray, rows: FloatArray) -> FloatArray:
        """``walk`` where no row may be refused: raises EventError naming the first, and changes nothing."""
        before = self.remembered()
        out: FloatArray | None = None
        try:
            answers = self.walk(begin, rows)
            if (i := first_refused(answers)) >= 0:
                raise refusal(rows[i].tolist(), answers[i].tolist(), f"row {i}: ")
            out = answers
        finally:
            if out is None:
                self.recall(before)
        return out
