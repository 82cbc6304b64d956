"""Which observer a plant of a file gets, and the call that designs it."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred_observers import (
    CornerSystem,
    Generator,
    InterlacedObserver,
    Persidskii,
    SymbolicGenerator,
    SymbolicSystem,
    UnknownInputObserver,
    design_full_order,
    design_observer,
    design_reduced_order,
    design_regulator,
    interlaced,
    steady_state_map,
)
from pointpred_observers.documents.expressions import parsed

NEEDS: dict[str, type] = {
    "reduced-order": Persidskii,
    "full-order": Persidskii,
    "driven": Persidskii,
    "regulator": Persidskii,
    "unknown-input": CornerSystem,
    "interlaced": SymbolicSystem,
}
"""The kinds of observers, and the plant of each."""
DEGREE = 3
"""Of the power series of an interlaced observer's steady state."""
NAMES = {Persidskii: "plant", CornerSystem: "parameter-varying plant", SymbolicSystem: "symbolic plant"}


class Wish(msgspec.Struct, frozen=True):
    """What the options ask for."""

    observer: str | None
    decay: float
    upper: int | None = None
    first: str | None = None


def designed(plant: Any, generator: Any, wish: Wish) -> tuple[str, Any]:
    """The kind of observer and its design; raises ParameterError where plant and options do not fit."""
    if not wish.decay > 0.0:
        raise ParameterError(f"--decay must lie above 0, received {wish.decay:g}", field="decay")
    kind = wish.observer or chosen(plant, generator)
    if kind not in NEEDS:
        raise ParameterError(
            f"--observer must be one of {', '.join(NEEDS)}, received {kind!r}", field="observer"
        )
    if not isinstance(plant, NEEDS[kind]):
        raise ParameterError(
            f"--observer {kind} needs a file of the kind {NAMES[NEEDS[kind]]!r}, "
            f"received a {type(plant).__name__}",
            field="observer",
        )
    _refuse_unused(kind, generator, wish)
    one: Any = plant  # of that type
    if kind == "reduced-order":
        return kind, design_reduced_order(one, decay=wish.decay, injection=True)
    if kind == "full-order":
        return kind, design_full_order(one, decay=wish.decay)
    if kind == "regulator":
        return kind, design_regulator(one, decay=wish.decay)
    if kind == "unknown-input":
        return kind, UnknownInputObserver.design(one, one.box, wish.decay)
    if kind == "driven":
        return kind, _driven(one, _generator(generator, Generator, kind, "generator"), wish)
    return kind, _interlaced(one, _generator(generator, SymbolicGenerator, kind, "symbolic generator"), wish)


def _refuse_unused(kind: str, generator: Any, wish: Wish) -> None:
    """Raise ParameterError for an option that this kind of observer does not read."""
    options = {
        "GENERATOR": (generator, ("driven", "interlaced")),
        "--upper": (wish.upper, ("interlaced",)),
        "--first": (wish.first, ("interlaced",)),
    }
    for option, (value, kinds) in options.items():
        if value is not None and kind not in kinds:
            raise ParameterError(
                f"{option} is for --observer {' and '.join(kinds)}, this one is {kind}: leave it out",
                field=option,
            )


def chosen(plant: Any, generator: Any) -> str:
    """The kind of observer for a plant where none is named.

    Of the unmeasured states only if the outputs are independent and free of f, and some states are
    unmeasured.
    """
    if isinstance(plant, CornerSystem):
        return "unknown-input"
    if isinstance(plant, SymbolicSystem):
        return "interlaced"
    if not isinstance(plant, Persidskii):
        raise ParameterError(
            f"design needs the file of a plant, received a {type(plant).__name__}", field="plant"
        )
    if generator is not None:
        return "driven"
    independent = plant.p == np.linalg.matrix_rank(plant.C0)
    return "reduced-order" if independent and plant.p < plant.n and not plant.C1.any() else "full-order"


def _driven(plant: Persidskii, generator: Generator, wish: Wish) -> Any:
    found = steady_state_map(plant, generator)
    return design_observer(plant, generator, found.Pi, decay=wish.decay)


def _interlaced(plant: SymbolicSystem, generator: SymbolicGenerator, wish: Wish) -> Any:
    if wish.first is None:
        raise ParameterError(
            "an interlaced observer needs --first, the steady state of the first lower row, such as w1",
            field="first",
        )
    first = parsed(wish.first, "--first")
    if foreign := sorted(map(str, first.free_symbols - set(generator.states))):
        raise ParameterError(
            f"--first may hold the generator's states {', '.join(map(str, generator.states))}, received "
            f"{wish.first!r} with {', '.join(foreign)}",
            field="first",
        )
    steady = interlaced(plant, generator, wish.upper or 0, first, degree=DEGREE)
    return InterlacedObserver.design(steady, rate=wish.decay)


def _generator(given: Any, wanted: type, kind: str, named: str) -> Any:
    if not isinstance(given, wanted):
        raise ParameterError(
            f"--observer {kind} needs GENERATOR, a file of the kind {named!r}, "
            f"received {'none' if given is None else 'a ' + type(given).__name__}",
            field="generator",
        )
    return given
