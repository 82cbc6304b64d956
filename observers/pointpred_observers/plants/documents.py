"""Plants and generators as JSON: matrices, corners, and expressions as text."""

from __future__ import annotations

from typing import Any, Literal, Self

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred_observers.numerics.matrices import matrix
from pointpred_observers.plants.boxes import Box
from pointpred_observers.plants.entries import (
    Document,
    Entries,
    Functions,
    PythonFunction,
    Rows,
    entries,
    fields_of,
    finite,
    named,
    parsed,
    restored,
    symbols_of,
    text_of,
    unbounded,
)
from pointpred_observers.plants.generator import Generator
from pointpred_observers.plants.linear_systems import as_plant
from pointpred_observers.plants.nonlinearity import KNOWN, NAMED, Nonlinearity
from pointpred_observers.plants.persidskii import NAMES, Persidskii
from pointpred_observers.plants.symbolic import (
    Free,
    SymbolicGenerator,
    SymbolicSteadyState,
    SymbolicSystem,
    check_steady_state,
)
from pointpred_observers.plants.varying import CornerSystem

Time = Literal["continuous", "discrete"]
Pairs = list[tuple[float | None, float | None]]
"""Intervals; null is minus infinity below and infinity above."""
MATRICES = ("S0", "S1", "J", "G", "L0", "L1", "E")


class PlantDocument(Document, tag="plant", frozen=True):
    """A ``Persidskii`` system, or a linear one: its matrices by name, f by the names of its components."""

    A0: Rows | PythonFunction
    A1: Entries = None
    H: Entries = None
    f: str | tuple[str, ...] | PythonFunction = ()
    B: Entries = None
    Q: Entries = None
    C0: Entries = None
    C1: Entries = None
    slopes: Pairs | None = None
    domain: float | None = None
    time: Time = "continuous"

    @classmethod
    def of(cls, thing: Any) -> Self:
        """The document of a plant of this library, of python-control or of scipy."""
        plant = as_plant(thing)
        return cls(
            **{name: entries(plant.given(name)) for name in NAMES} | {"time": plant.time},
            f=named(plant.f) if plant.k else (),
            slopes=_slopes(plant.f) if plant.k else None,
            domain=finite(plant.domain),
        )

    def made(self, functions: Functions) -> Persidskii:
        """The plant."""
        return Persidskii(
            **{name: restored(name, getattr(self, name), functions) for name in NAMES},
            f=restored("f", self.f, functions),
            slopes=self.slopes and [(-np.inf if a is None else a, unbounded(b)) for a, b in self.slopes],
            time=self.time,
            domain=unbounded(self.domain),
        )


class GeneratorDocument(Document, tag="generator", frozen=True):
    """A ``Generator``, or a regulator: its matrices by name, and its f where it has one of its own."""

    S0: Rows
    S1: Rows | None = None
    J: Rows | None = None
    G: Rows | None = None
    L0: Rows | None = None
    L1: Rows | None = None
    E: Rows | None = None
    f: str | tuple[str, ...] | PythonFunction | None = None
    time: Time | None = None

    def made(self, functions: Functions) -> Generator:
        """The generator."""
        own = restored("generator.f", self.f, functions)
        return Generator(**{name: getattr(self, name) for name in MATRICES}, f=own, time=self.time)


class Corner(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """The matrices at one corner of the box: at the low or the high end of each variable."""

    at: dict[str, float]
    A: Rows
    F: Rows
    TA: Rows | None = None


class ParameterVaryingDocument(Document, tag="parameter-varying plant", frozen=True):
    """A ``CornerSystem``: the box of its scheduling variables, and its matrices at every corner."""

    box: dict[str, tuple[float, float]]
    corners: list[Corner]
    C: Rows
    rates: dict[str, str] | None = None
    sizes: list[float] | None = None
    time: Time = "continuous"

    @classmethod
    def of(cls, thing: CornerSystem) -> Self:
        """The document of a system that is known by its corners."""
        corners = [
            Corner(at=point, **{name: entries(one[i]) for name, one in thing.corners.items()})
            for i, point in enumerate(thing.box.corners)
        ]
        given = fields_of(cls, thing) | {"box": dict(thing.box.bounds), "corners": corners}
        return cls(**given | {"C": entries(thing.c), "rates": thing.rates or None})

    def made(self, functions: Functions) -> CornerSystem:
        """The system."""
        box, ordered = Box(self.box), []
        for point in box.corners:
            if not (found := [one for one in self.corners if one.at == point]):
                raise ParameterError(f"the corner {point} of the box is missing", field="corners")
            ordered.append(found[0])
        if len(self.corners) > len(ordered):
            words = f"the box has {len(ordered)} corners, received {len(self.corners)}"
            raise ParameterError(words, field="corners")
        if len({one.TA is None for one in ordered}) > 1:
            raise ParameterError("TA is given at some corners only: give it at all or at none", field="TA")
        names = ("A", "F") if ordered[0].TA is None else ("A", "F", "TA")
        held = {name: _stacked(name, [getattr(one, name) for one in ordered]) for name in names}
        return CornerSystem(box, C=self.C, **held, rates=self.rates, sizes=self.sizes, time=self.time)


class SymbolicPlantDocument(Document, tag="symbolic plant", frozen=True):
    """A ``SymbolicSystem``: names of states and of the input, expressions of field and outputs."""

    states: tuple[str, ...]
    field: tuple[str, ...]
    input: str
    outputs: tuple[str, ...] = ()
    zero: tuple[str, ...] = ()
    zero_field: tuple[str, ...] = ()

    def made(self, functions: Functions) -> SymbolicSystem:
        """The plant."""
        x, u, z = symbols_of(self.states), symbols_of((self.input,))[0], symbols_of(self.zero)
        field, eta, h = (_read(name, getattr(self, name)) for name in ("field", "zero_field", "outputs"))
        return SymbolicSystem(x, field, u, zero=z, zero_field=eta, outputs=h)


class SymbolicGeneratorDocument(Document, tag="symbolic generator", frozen=True):
    """A ``SymbolicGenerator``: names of its states, expressions of its field."""

    states: tuple[str, ...]
    field: tuple[str, ...]

    def made(self, functions: Functions) -> SymbolicGenerator:
        """The generator."""
        return SymbolicGenerator(symbols_of(self.states), _read("field", self.field))


class FreeTerms(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Terms that may be added to the maps."""

    degree: int
    terms: dict[str, str]


class SteadyStateDocument(Document, tag="steady state", frozen=True):
    """A ``SymbolicSteadyState``: plant, generator, and the maps, whose equations are checked again."""

    plant: SymbolicPlantDocument
    generator: SymbolicGeneratorDocument
    maps: tuple[str, ...]
    input: str
    zero_maps: tuple[str, ...] = ()
    degree: int | None = None
    free: tuple[FreeTerms, ...] = ()

    @classmethod
    def of(cls, thing: SymbolicSteadyState) -> Self:
        """The document of a steady state."""
        free = [FreeTerms(one.degree, {x: text_of(e) for x, e in one.terms.items()}) for one in thing.free]
        given = fields_of(cls, msgspec.structs.replace(thing, generator=None, free=tuple(free)))
        plant, driving = SymbolicPlantDocument.of(thing.system), thing.generator
        return cls(**given | {"plant": plant, "generator": SymbolicGeneratorDocument.of(driving)})

    def made(self, functions: Functions) -> SymbolicSteadyState:
        """The steady state; raises CertificateError naming an equation that does not hold."""
        plant, generator = self.plant.made(functions), self.generator.made(functions)
        maps, rho = _read("maps", self.maps), _read("zero_maps", self.zero_maps)
        u = parsed(self.input, "input")
        steady = check_steady_state(plant, generator, maps, u, zero=rho, degree=self.degree)
        free = [Free(one.degree, {x: parsed(e, "free") for x, e in one.terms.items()}) for one in self.free]
        return msgspec.structs.replace(steady, degree=self.degree, free=tuple(free))


def functions_of(thing: Any) -> dict[str, Any]:
    """The Python functions of a plant or of what has a plant, by the names under which ``load`` asks."""
    plant = thing if isinstance(thing, Persidskii) else getattr(thing, "plant", None)
    found: dict[str, Any] = {}
    if isinstance(plant, Persidskii):
        found = {name: plant.given(name) for name in plant.varying}
        if plant.k and plant.f.codes is None:
            found["f"] = plant.f.function
    generator = thing if isinstance(thing, Generator) else getattr(thing, "generator", None)
    own = getattr(generator, "f", None)
    if own is not None and own.codes is None:
        found["generator.f"] = own.function
    return found


def _slopes(f: Nonlinearity) -> Any:
    """The slopes where they are not those of the names."""
    if f.slopes is None:
        return None
    if f.codes is not None and f.slopes == tuple(KNOWN[NAMED[code]][1:] for code in f.codes):
        return None
    return [(finite(low), finite(high)) for low, high in f.slopes]


def _stacked(name: str, matrices: list[Any]) -> Any:
    """The matrices of all corners; raises ParameterError where one has another shape."""
    tables = [matrix(name, one) for one in matrices]
    if len({one.shape for one in tables}) > 1:
        raise ParameterError(f"{name} needs the same shape at every corner", field=name)
    return tables


def _read(name: str, texts: tuple[str, ...]) -> list[Any]:
    return [parsed(text, f"{name}[{i}]") for i, text in enumerate(texts)]
