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
        why = "it is a folder" if path.is_dir() else "there is no such file"
        raise ParameterError(f"cannot read {path}: {why}", field="file", value=file)
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
        words = f"{name}: {failure}"
        raise type(failure)(words, code=failure.code, field=failure.field, value=failure.value) from failure
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
        words = f"an audit needs a design with a certificate, received {type(observer).__name__}"
        raise ParameterError(words, field="observer")
    try:
        with np.errstate(all="ignore"):  # what overflows is not finite, and refused
            again = observer.audited()
    except (np.linalg.LinAlgError, OverflowError) as failure:
        raise CertificateError("the design's numbers are too large or too small to compute with") from failure
    for bounds in zip(observer.bounds.values(), again.bounds.values(), strict=True):
        claimed, proved = (np.array([one.overshoot, 1.0 / one.decay, one.rest, *one.gains]) for one in bounds)
        if claimed.shape != proved.shape or not (claimed >= proved * (1.0 - TOLERANCE)).all():
            words = f"the design carries the bound {bounds[0]}, its matrices prove {bounds[1]}"
            raise CertificateError(words, field="bound")
    return again.margins


def _document(thing: Any) -> Document:
    if isinstance(thing, Observer):
        return thing.document()
    for kind, document in PLANTS.items():
        if isinstance(thing, kind):
            return document.of(thing)
    if isinstance(thing, ParameterVaryingSystem):
        words = "a parameter-varying system of functions is saved as CornerSystem.of(system, box)"
        raise ParameterError(words, field="thing")
    try:
        return PlantDocument.of(as_plant(thing))
    except ParameterError as unknown:
        names = ", ".join(one.__name__ for one in PLANTS)
        words = f"can save observers, {names} and linear systems, received {type(thing).__name__}"
        raise ParameterError(words, field="thing", value=thing) from unknown


def _read(text: bytes | str, name: str) -> Document:
    """The document of a text: its format, version and kind first, then its fields."""
    try:
        whole = msgspec.json.decode(text)
    except (msgspec.DecodeError, UnicodeError, RecursionError) as unusable:
        raise ParameterError(f"{name}: is no JSON: {unusable}") from unusable
    if not isinstance(whole, dict):
        whole = {"format": type(whole).__name__}
    content = {key: one for key, one in whole.items() if key not in ("format", "version")}
    form, version, kind = (whole.get(key) for key in ("format", "version", "kind"))

    def require(fits: bool, key: str, must: str, value: Any) -> None:
        if not fits:
            words = f'{name}: "{key}" must be {must}, received {value!r:.60}'
            raise ParameterError(words, field=key, value=value)

    require(form == FORMAT, "format", f'"{FORMAT}", see pointpred observers example', form)
    require(type(version) is int and version >= 1, "version", str(VERSION), version)
    if whole["version"] > VERSION:
        words = f"{name}: is of version {version}, this pointpred reads version {VERSION}: install a newer"
        raise ParameterError(words, field="version", value=version)
    require(isinstance(kind, str) and kind in NAMES, "kind", f"one of {', '.join(NAMES)}", kind)
    document = NAMES[whole["kind"]]
    try:
        return msgspec.convert(content, document)
    except msgspec.ValidationError as wrong:
        words, _, place = str(wrong).replace("`", "").partition(" - at ")
        place = place.removeprefix("$").lstrip(".")
        if "unknown field" in words and not place:
            words += f"; the fields are {', '.join(one.name for one in msgspec.structs.fields(document))}"
        raise ParameterError(": ".join(filter(None, (name, place, words))), field=place) from wrong
