"""Symbolic plants, generators and steady states as JSON: expressions as text."""

from __future__ import annotations

from typing import Any, Self

import msgspec

from pointpred_observers.plants.entries import Document, Functions, fields_of
from pointpred_observers.plants.expressions import parsed, symbols_of, text_of
from pointpred_observers.plants.polynomials import Free
from pointpred_observers.plants.symbolic import (
    SymbolicGenerator,
    SymbolicSteadyState,
    SymbolicSystem,
    check_steady_state,
)


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
        return SymbolicSystem(
            symbols_of(self.states),
            _read("field", self.field),
            symbols_of((self.input,))[0],
            zero=symbols_of(self.zero),
            zero_field=_read("zero_field", self.zero_field),
            outputs=_read("outputs", self.outputs),
        )


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
        return cls(
            **fields_of(cls, msgspec.structs.replace(thing, generator=None, free=()))
            | {
                "plant": SymbolicPlantDocument.of(thing.system),
                "generator": SymbolicGeneratorDocument.of(thing.generator),
                "free": tuple(
                    FreeTerms(one.degree, {name: text_of(term) for name, term in one.terms.items()})
                    for one in thing.free
                ),
            }
        )

    def made(self, functions: Functions) -> SymbolicSteadyState:
        """The steady state; raises CertificateError naming an equation that does not hold."""
        steady = check_steady_state(
            self.plant.made(functions),
            self.generator.made(functions),
            _read("maps", self.maps),
            parsed(self.input, "input"),
            zero=_read("zero_maps", self.zero_maps),
            degree=self.degree,
        )
        free = tuple(
            Free(one.degree, {name: parsed(text, "free") for name, text in one.terms.items()})
            for one in self.free
        )
        return msgspec.structs.replace(steady, degree=self.degree, free=free)


def _read(name: str, texts: tuple[str, ...]) -> list[Any]:
    return [parsed(text, f"{name}[{i}]") for i, text in enumerate(texts)]
