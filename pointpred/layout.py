"""Memories with names: the one declaration of what a law remembers, and the view that plain Python runs on.

A memory is a flat float64 array. A ``Layout`` names its numbers in their order; ``translation`` makes C's
struct and JavaScript's places of it. Laws write ``s.rows[i, j]``, ``s.count = 1.0``, ``s.places[k].weight``.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby
from math import prod
from typing import Annotated, Any, ClassVar, NamedTuple, get_args, get_origin, get_type_hints

import msgspec
import numpy as np
from numpy.typing import NDArray


class Known(NamedTuple):
    """What may be saved of a person: the name of the numbers, their closed bounds, whether they are whole."""

    name: str
    low: float
    high: float
    whole: bool = False


class Slot(msgspec.Struct, frozen=True):
    """A run of numbers that a stage knows of its person: their name, how many, the closed bounds of each."""

    name: str
    count: int
    low: float
    high: float
    whole: bool = False
    """Whether each is a whole number, such as how many of something are held."""


class Part(NamedTuple):
    """A named part of a layout: where it begins, its shape (() for a number), the layout of each, bounds.

    The shape (-1,) is that of a last part that takes what is left of the memory.
    """

    name: str
    at: int
    shape: tuple[int, ...]
    of: type[Layout] | None = None
    known: Known | None = None

    @property
    def length(self) -> int:
        """How many numbers it takes at least."""
        return max(0, prod(self.shape)) * (1 if self.of is None else self.of.length)


class Layout:
    """Names for the numbers of a memory, one behind the other; a child declares them as annotations.

    ``float``: a number. ``Annotated[FloatArray, n]`` and ``Annotated[FloatTable, n, m]``: so many numbers;
    n None, in a last part: what is left. Another layout: its numbers. ``Annotated[Sequence[Other], n]``: n of
    it. ``Known`` among the annotations says what of it is saved of a person, and its bounds.

    >>> class Path(Layout):
    ...     count: float
    ...     rows: Annotated[NDArray[np.float64], 2, 3]
    >>> memory = np.zeros(Path.length)
    >>> path = Path(memory)
    >>> path.rows[1, 0] = path.count = 4.0
    >>> memory.tolist()
    [4.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0]
    """

    parts: ClassVar[tuple[Part, ...]] = ()
    length: ClassVar[int] = 0
    """How many numbers it takes; without a last part that takes what is left."""

    def __init_subclass__(cls) -> None:
        hints = get_type_hints(cls, include_extras=True)
        at, parts = 0, []
        if wrong := [name for name in vars(cls).get("__annotations__", ()) if hasattr(Layout, name)]:
            raise TypeError(f"{wrong[0]} has a meaning of its own in a layout: call the part something else")
        for name, hint in hints.items():
            if name in Layout.__annotations__:
                continue
            part = _part(name, at, hint)
            at += part.length
            parts.append(part)
            setattr(cls, name, _Number(part.at) if not part.shape and part.of is None else _Inside(part))
        cls.parts, cls.length = tuple(parts), at

    def __init__(self, memory: NDArray[np.float64], at: int = 0) -> None:
        self.memory = memory[at : at + type(self).length] if _is_closed(type(self)) else memory[at:]
        """The numbers as a flat array."""


def clear(part: Layout) -> None:
    """Forget: every number becomes 0."""
    part.memory[:] = 0.0


def slots_of(layout: type[Layout]) -> tuple[Slot, ...]:
    """What of a layout is saved of a person, in its order; neighbours that say the same are one slot."""
    slots: tuple[Slot, ...] = ()
    for known, parts in groupby(layout.parts, lambda part: part.known):
        if known is not None:
            slots += (Slot(known.name, sum(part.length for part in parts), *known[1:]),)
        else:
            for part in parts:
                slots += slots_of(part.of) * prod(part.shape) if part.of is not None else ()
    return slots


def places(layout: type[Layout], prefix: str = "", at: int = 0) -> Iterator[tuple[str, int]]:
    """The names of all numbers and arrays, dotted, and where each begins."""
    for part in layout.parts:
        if part.of is None:
            yield prefix + part.name, at + part.at
        else:
            count = prod(part.shape)
            for i in range(count):
                word = f"{prefix}{part.name}[{i}]." if part.shape else f"{prefix}{part.name}."
                yield from places(part.of, word, at + part.at + i * part.of.length)


def _is_closed(layout: type[Layout]) -> bool:
    return not layout.parts or layout.parts[-1].shape != (-1,)


def _part(name: str, at: int, hint: Any) -> Part:
    kind, *said = get_args(hint) if get_origin(hint) is Annotated else (hint,)
    known = next((one for one in said if isinstance(one, Known)), None)
    shape = tuple(-1 if one is None else one for one in said if not isinstance(one, Known))
    if isinstance(kind, type) and issubclass(kind, Layout):
        return Part(name, at, (), kind, known)
    if get_origin(kind) is Sequence:
        return Part(name, at, shape, get_args(kind)[0], known)
    if kind is not float and not shape:
        raise TypeError(f"{name} must say how many numbers it takes")
    return Part(name, at, shape, None, known)


class _Number:
    """A number of a memory, read and written by its name."""

    def __init__(self, at: int) -> None:
        self._at = at

    def __get__(self, view: Layout | None, owner: type[Layout]) -> Any:
        return self if view is None else view.memory[self._at]

    def __set__(self, view: Layout, value: float) -> None:
        view.memory[self._at] = value


class _Inside:
    """An array or a layout within a memory, made when it is first asked for."""

    def __init__(self, part: Part) -> None:
        self._part = part

    def __get__(self, view: Layout | None, owner: type[Layout]) -> Any:
        if view is None:
            return self
        part = self._part
        if part.of is None:
            whole = part.shape == (-1,)
            numbers = view.memory[part.at :] if whole else view.memory[part.at : part.at + part.length]
            made: Any = numbers.reshape(part.shape)
        elif part.shape:
            size = part.of.length
            made = [part.of(view.memory, part.at + i * size) for i in range(part.shape[0])]
        else:
            made = part.of(view.memory, part.at)
        view.__dict__[part.name] = made
        return made
