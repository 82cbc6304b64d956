"""Transfer functions as small JSON files, and as text that a user types."""

from __future__ import annotations

from math import isfinite
from pathlib import Path
from typing import Literal

import msgspec

from pointpred.errors import ParameterError, RecordingError
from pointpred.files import beside
from pointpred.transfer.functions import (
    ConstantGain,
    HeldPolynomial,
    PolynomialFunction,
    SigmoidGain,
    TransferFunction,
)

VERSION = 1
LARGEST_BYTES = 65536
WAYS = "'constant:GAIN', 'sigmoid', 'sigmoid:GAIN_MIN,GAIN_MAX,SPEED_LOW,SPEED_HIGH' or a file that was saved"

Kind = Literal["constant", "sigmoid", "polynomial"]


class SavedTransfer(msgspec.Struct, frozen=True):
    """A transfer function and the resolutions it was identified with; ``None`` if it depends on neither."""

    function: TransferFunction
    cpi: float | None = None
    dpi: float | None = None


class _File(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """File contents: gains have no unit, speeds are in m/s, coefficients c_0 ... c_q in SI units."""

    version: int
    kind: Kind
    numbers: list[float]
    speed_low: float | None = None
    speed_high: float | None = None
    cpi: float | None = None
    dpi: float | None = None


def save_transfer(
    path: Path,
    function: TransferFunction,
    *,
    cpi: float | None = None,
    dpi: float | None = None,
    replace: bool = False,
) -> None:
    """Write a constant gain, a sigmoid or an identified polynomial with the resolutions for which it holds.

    The file is written completely or not at all. Raises ParameterError for another kind of function, for one
    that could not move a cursor, and if the file exists and ``replace`` is false.
    """
    slots = function.slots.tolist()
    if isinstance(function, ConstantGain):
        file = _File(VERSION, "constant", [slots[1]], cpi=cpi, dpi=dpi)
    elif isinstance(function, SigmoidGain):
        file = _File(VERSION, "sigmoid", slots[1:5], cpi=cpi, dpi=dpi)
    elif isinstance(function, PolynomialFunction | HeldPolynomial):
        bounded = function if isinstance(function, HeldPolynomial) else HeldPolynomial(function)
        coefficients = list(bounded.polynomial.coefficients)
        file = _File(VERSION, "polynomial", coefficients, bounded.speed_low, bounded.speed_high, cpi, dpi)
    else:
        raise ParameterError(
            "function must be a constant gain, a sigmoid or a polynomial, "
            f"received {type(function).__name__}",
            field="function",
        )
    if path.exists() and not replace:
        raise ParameterError(f"{path} exists; choose another name, or say that it may be replaced")
    _write(path, msgspec.json.format(msgspec.json.encode(file), indent=2) + b"\n")


def load_transfer(path: Path) -> SavedTransfer:
    """Read a file of ``save_transfer``; a polynomial keeps its gain beyond both ends of its range.

    Raises RecordingError for any other text.
    """
    with path.open("rb") as opened:
        text = opened.read(LARGEST_BYTES + 1)
    try:
        if len(text) > LARGEST_BYTES:
            raise ParameterError(f"longer than {LARGEST_BYTES} bytes")
        file = msgspec.json.decode(text, type=_File)
        if file.version != VERSION:
            raise ParameterError(f"version must be {VERSION}, received {file.version}")
        return SavedTransfer(_function(file), *(_resolution(each) for each in (file.cpi, file.dpi)))
    except (msgspec.DecodeError, ParameterError, UnicodeDecodeError) as error:
        raise RecordingError(f"{path}: not a saved transfer function: {error}") from error


def named_transfer(text: str) -> SavedTransfer:
    """The function that a user names: 'constant:4', 'sigmoid', 'sigmoid:1,15,0.05,0.6', or a saved file.

    Raises ParameterError for text that names none, RecordingError for a file without one.

    >>> float(named_transfer("constant:4").function.gain(0.1))
    4.0
    """
    kind, _, rest = text.partition(":")
    if kind in ("constant", "sigmoid"):
        try:
            numbers = [float(word) for word in rest.split(",")] if rest else []
        except ValueError as error:
            raise ParameterError(f"{text!r}: {rest!r} is not numbers; expected {WAYS}") from error
        wanted = (1,) if kind == "constant" else (0, 4)
        if len(numbers) not in wanted:
            raise ParameterError(f"{text!r} has {len(numbers)} numbers; expected {WAYS}")
        return SavedTransfer(ConstantGain(*numbers) if kind == "constant" else SigmoidGain(*numbers))
    if not _is_file(text):
        raise ParameterError(f"{text!r} names no transfer function; expected {WAYS}")
    return load_transfer(Path(text))


def _is_file(text: str) -> bool:
    """Whether a text names a file; no file has the names that the system refuses, such as very long ones."""
    try:
        return Path(text).is_file()
    except OSError:
        return False


def _function(file: _File) -> TransferFunction:
    """The function of a file; raises ParameterError."""
    if file.kind == "polynomial":
        if file.speed_low is None or file.speed_high is None:
            raise ParameterError("a polynomial needs speed_low and speed_high")
        low, high = file.speed_low, file.speed_high
        return HeldPolynomial(PolynomialFunction(file.numbers, speed_low=low, speed_high=high))
    wanted = 1 if file.kind == "constant" else 4
    if len(file.numbers) != wanted:
        raise ParameterError(f"{file.kind}: expected {wanted} numbers, received {len(file.numbers)}")
    return ConstantGain(*file.numbers) if file.kind == "constant" else SigmoidGain(*file.numbers)


def _resolution(value: float | None) -> float | None:
    if value is not None and not (isfinite(value) and 0.0 < value <= 1e6):
        raise ParameterError(f"cpi and dpi must lie in (0, 1e6], received {value!r}")
    return value


def _write(path: Path, text: bytes) -> None:
    """Put a file in its place in one step."""
    part = beside(path, "part")
    try:
        part.write_bytes(text)
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)
