"""Plants and designs in files: saved, and loaded with every certificate audited."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import CertificateError, ParameterError, PointpredError
from pointpred.files import write_whole
from pointpred_observers.interconnected.design import DrivenDocument
from pointpred_observers.interconnected.regulator import RegulatorDocument
from pointpred_observers.numerics.equalities import TOLERANCE
from pointpred_observers.numerics.matrices import instance
from pointpred_observers.observer import Observer
from pointpred_observers.paths import path_of, writable
from pointpred_observers.plants.documents import (
    GeneratorDocument,
    ParameterVaryingDocument,
    PlantDocument,
    SteadyStateDocument,
    SymbolicGeneratorDocument,
    SymbolicPlantDocument,
)
from pointpred_observers.plants.entries import Document, Functions
from pointpred_observers.plants.generator import Generator
from pointpred_observers.plants.linear_systems import as_plant
from pointpred_observers.plants.persidskii import Persidskii
from pointpred_observers.plants.symbolic import SymbolicGenerator, SymbolicSteadyState, SymbolicSystem
from pointpred_observers.plants.varying import CornerSystem, ParameterVaryingSystem
from pointpred_observers.reduced_order.design import ReducedOrderDocument
from pointpred_observers.reduced_order.reversed_connection import InvariantDocument
from pointpred_observers.triangular.interlaced_observer import InterlacedDocument
from pointpred_observers.unknown_input.observer import UnknownInputDocument

FORMAT = "pointpred observers"
VERSION = 1
ROW = re.compile(rb"\[\n([^\[\]{}\"]*)\]")
"""An array of numbers over several lines; each is written on one. No text in JSON holds a line break."""
LARGEST = 1 << 26
"""Most bytes of a file."""
PLANTS: dict[type, type[Document]] = {
    Persidskii: PlantDocument,
    Generator: GeneratorDocument,
    CornerSystem: ParameterVaryingDocument,
    SymbolicSystem: SymbolicPlantDocument,
    SymbolicGenerator: SymbolicGeneratorDocument,
    SymbolicSteadyState: SteadyStateDocument,
}
"""The document of each kind of plant; an observer has its own."""
DESIGNS: tuple[type[Document], ...] = (
    DrivenDocument,
    InvariantDocument,
    ReducedOrderDocument,
    RegulatorDocument,
    UnknownInputDocument,
    InterlacedDocument,
)
NAMES = {str(one.__struct_config__.tag): one for one in (*PLANTS.values(), *DESIGNS)}
"""The documents by the ``kind`` in the file."""


def save(thing: Any, file: Path | str) -> Path:
    """Write a plant or a design to a JSON file, which takes its place only when it is whole.

    ``thing``: a Persidskii plant or a linear one, a Generator, a CornerSystem, a symbolic plant, generator or
    steady state, or an observer. Numbers keep every bit. Python functions (an f without a name,
    matrices that vary) are named in the file and passed again to ``load``.

    Raises ParameterError for anything else, for a system whose matrices are not affine in each variable, and
    for a folder or a file in a folder that does not exist; OSError. Returns the path.
    """
    target = writable(file)
    write_whole(target, encoded(thing))
    return target


def encoded(thing: Any) -> bytes:
    """The JSON text of a plant or a design, as ``save`` writes it."""
    content: dict[str, Any] = msgspec.to_builtins(_document(thing))
    whole = {"format": FORMAT, "version": VERSION, **content}
    text = msgspec.json.format(msgspec.json.encode(whole), indent=2)
    return ROW.sub(lambda row: b"[" + b" ".join(row[1].split()) + b"]", text) + b"\n"


def load(file: Path | str, *, functions: Functions | None = None) -> Any:
    """A plant or a design of a JSON file; of a design every inequality and equality is audited again.

    Parameters: ``functions`` the Python functions that the file names, such as {"f": growth}. Raises
    ParameterError naming the file, the field, what it needs and what it has, for another format or a later
    version, for a function that is missing, and for a file that is not there; CertificateError naming the
    inequality that fails; InfeasibleError for an equality that does not hold; OSError.

    >>> from tempfile import TemporaryDirectory
    >>> from pointpred_observers import Persidskii, design
    >>> cart = design(Persidskii([[0.0, 1.0], [0.0, 0.0]], None, None, "sin", C0=[1.0, 0.0]), "full")
    >>> with TemporaryDirectory() as folder:
    ...     again = load(save(cart, f"{folder}/cart.json"))
    >>> bool((again.gain == cart.gain).all()), again.bound == cart.bound
    (True, True)
    """
    path = path_of(file)
    if not path.is_file():
        raise ParameterError(
            f"cannot read {path}: {'it is a folder' if path.is_dir() else 'there is no such file'}",
            field="file",
            value=file,
        )
    if path.stat().st_size > LARGEST:
        raise ParameterError(f"{path}: a plant or a design has at most {LARGEST} bytes")
    return decoded(path.read_bytes(), functions=functions, name=str(path))


def decoded(text: bytes | str, *, functions: Functions | None = None, name: str = "the text") -> Any:
    """The same of JSON text; ``name`` stands for the file in errors."""
    document, given = _read(text, name), instance("functions", functions or {}, dict)
    try:
        with np.errstate(all="ignore"):  # what overflows is not finite, and refused
            return document.made(given)
    except PointpredError as failure:
        raise type(failure)(
            f"{name}: {failure}", code=failure.code, field=failure.field, value=failure.value
        ) from failure
    except (np.linalg.LinAlgError, OverflowError) as failure:
        raise ParameterError(f"{name}: its numbers are too large or too small to compute with") from failure


def audit(observer: Observer) -> dict[str, float]:
    """Every inequality and equality of a design checked again: how far each inequality holds.

    Margins are computed from the matrices, and so is the bound, which may not exceed what the design claims;
    its ``gap`` is not checked. Raises CertificateError naming the inequality that fails, or the bound that
    the matrices do not prove; InfeasibleError for an equality, ParameterError for what has no certificate.

    >>> from pointpred_observers import Persidskii, design
    >>> cart = design(Persidskii([[0.0, 1.0], [0.0, 0.0]], None, None, "sin", C0=[1.0, 0.0]), "full")
    >>> audit(cart) == cart.margins
    True
    """
    if not isinstance(observer, Observer) or not observer.margins:
        raise ParameterError(
            f"an audit needs a design with a certificate, received {type(observer).__name__}",
            field="observer",
        )
    try:
        with np.errstate(all="ignore"):  # what overflows is not finite, and refused
            again = observer.audited()
    except (np.linalg.LinAlgError, OverflowError) as failure:
        raise CertificateError("the design's numbers are too large or too small to compute with") from failure
    for bounds in zip(observer.bounds.values(), again.bounds.values(), strict=True):
        claimed, proved = ([one.overshoot, 1.0 / one.decay, one.rest, *one.gains] for one in bounds)
        if (
            len(claimed) != len(proved)
            or not (np.array(claimed) >= np.array(proved) * (1.0 - TOLERANCE)).all()
        ):
            raise CertificateError(
                f"the design carries the bound {bounds[0]}, its matrices prove {bounds[1]}", field="bound"
            )
    return again.margins


def _document(thing: Any) -> Document:
    if isinstance(thing, Observer):
        return thing.document()
    for kind, document in PLANTS.items():
        if isinstance(thing, kind):
            return document.of(thing)
    if isinstance(thing, ParameterVaryingSystem):
        raise ParameterError(
            "a parameter-varying system of functions is saved by its matrices at the corners of a box: "
            "CornerSystem.of(system, box)",
            field="thing",
        )
    try:
        return PlantDocument.of(as_plant(thing))
    except ParameterError as unknown:
        names = ", ".join(one.__name__ for one in PLANTS)
        raise ParameterError(
            f"can save observers, {names} and linear systems, received {type(thing).__name__}",
            field="thing",
            value=thing,
        ) from unknown


def _read(text: bytes | str, name: str) -> Document:
    """The document of a text: its format, version and kind first, then its fields."""
    try:
        whole = msgspec.json.decode(text)
    except (msgspec.DecodeError, UnicodeError, RecursionError) as unusable:
        raise ParameterError(f"{name}: is no JSON: {unusable}") from unusable
    if not isinstance(whole, dict) or whole.get("format") != FORMAT:
        found = whole.get("format") if isinstance(whole, dict) else type(whole).__name__
        raise ParameterError(
            f'{name}: "format" must be "{FORMAT}", received {found!r:.60}; '
            "pointpred observers example shows a file",
            field="format",
        )
    version = whole.get("version")
    if not isinstance(version, int) or isinstance(version, bool) or version < 1:
        raise ParameterError(
            f'{name}: "version" must be {VERSION}, received {version!r:.40}', field="version", value=version
        )
    if version > VERSION:
        raise ParameterError(
            f"{name}: is of version {version}, this pointpred reads version {VERSION}: install a newer "
            "pointpred, or save it again with this one",
            field="version",
            value=version,
        )
    kind = whole.get("kind")
    if not isinstance(kind, str) or kind not in NAMES:
        raise ParameterError(
            f'{name}: "kind" must be one of {", ".join(NAMES)}, received {kind!r:.60}',
            field="kind",
            value=kind,
        )
    content = {key: one for key, one in whole.items() if key not in ("format", "version")}
    try:
        return msgspec.convert(content, NAMES[kind])
    except msgspec.ValidationError as wrong:
        raise ParameterError(f"{name}: {_sentence(wrong, NAMES[kind])}", field=_place(wrong)) from wrong


def _place(wrong: msgspec.ValidationError) -> str:
    return str(wrong).partition(" - at `")[2].rstrip("`").removeprefix("$").lstrip(".")


def _sentence(wrong: msgspec.ValidationError, document: type[Document]) -> str:
    """What is wrong and where; the fields that are known where one is not."""
    words, place = str(wrong).partition(" - at `")[0].replace("`", ""), _place(wrong)
    if "unknown field" in words and not place:
        words += f"; the fields are {', '.join(one.name for one in msgspec.structs.fields(document))}"
    return f"{place}: {words}" if place else words
