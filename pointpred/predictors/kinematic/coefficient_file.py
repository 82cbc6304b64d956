"""The coefficients of the learned predictor: a versioned file, read once and shared read-only."""

from __future__ import annotations

import hashlib
import io
import json
import zipfile
import zlib
from functools import lru_cache
from itertools import pairwise
from math import prod
from pathlib import Path
from tokenize import TokenError
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pointpred.errors import ParameterError
from pointpred.files import beside
from pointpred.predictors.kinematic import features, network
from pointpred.records import FloatArray

VERSION = 2
"""Of what the file holds and of what its numbers mean; a file of another version is refused."""
OWN = Path(__file__).with_name("kinematic.npz")
"""The file that comes with the package."""
LARGEST_BYTES = 2 * 1024 * 1024
LARGEST_INFLATED = 16 * 1024 * 1024
"""Bytes of all arrays of a file together."""
MANTISSA_BITS = 9
"""Bits behind the leading one that ``write`` keeps of a number: a browser then loads about 16 kB, packed."""
LINE = 8
"""Numbers in a line of the processor's cache."""
WIDEST = 1024
"""Units of a hidden layer."""
LARGEST_SCALE, LARGEST_WEIGHT, LARGEST_LOG = 2e6, 1e4, 20.0
"""Magnitudes of means and scales, of weights, of logarithms of factors: no answer overflows within them."""
UNUSABLE = (
    OSError,
    ValueError,
    TypeError,
    LookupError,
    EOFError,
    RuntimeError,
    SyntaxError,
    MemoryError,
    TokenError,
    zipfile.BadZipFile,
    zlib.error,
)
"""Errors of reading an invalid file; numpy reads the header of an array with Python's own parser."""


def write(
    path: Path,
    mean: FloatArray,
    scale: FloatArray,
    layers: list[tuple[Any, Any]],
    table: FloatArray,
    card: dict[str, Any],
) -> None:
    """Write coefficients and their card; the same numbers make a file of the same ``digest``.

    Every number is rounded by ``short``. The file is there whole or not at all: an interrupted write leaves
    what was there before.
    """
    arrays: dict[str, Any] = {"version": np.int64(VERSION)}
    arrays |= {"mean": short(mean), "scale": short(scale), "table": short(table)}
    for number, (weights, offset) in enumerate(layers):
        arrays[f"weights{number}"], arrays[f"offset{number}"] = short(weights), short(offset)
    arrays["card"] = np.frombuffer(json.dumps(card, sort_keys=True).encode(), np.uint8)
    part = beside(path, "part")
    try:
        with part.open("wb") as file:
            np.savez(file, **arrays)
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)


def short(values: Any) -> NDArray[np.float32]:
    """The nearest numbers with ``MANTISSA_BITS`` bits behind the leading one.

    Their last bits are 0, so that gzip packs them well. ``values``: 0 or of magnitude 1e-35 to 1e35; none is
    changed by more than a share of 2 ** -(MANTISSA_BITS + 1), and rounding twice is rounding once.

    >>> short([1 / 3, -1.0, 0.0]).tolist()
    [0.33349609375, -1.0, 0.0]
    """
    mantissas, exponents = np.frexp(np.asarray(values, np.float64))
    digits = MANTISSA_BITS + 1
    rounded: FloatArray = np.ldexp(np.rint(np.ldexp(mantissas, digits)), exponents - digits)
    return rounded.astype(np.float32)


def check_writable(path: Path) -> None:
    """Raise ParameterError now where ``write`` would fail later; leaves nothing behind."""
    if path.is_dir():
        raise ParameterError(f"cannot write {path}: it is a folder; name a file")
    part = beside(path, "part")
    try:
        part.open("wb").close()
        part.unlink()
    except OSError as error:
        raise ParameterError(
            f"cannot write {path}: {error.strerror}; name a file in a folder that can be written to"
        ) from error


def read(path: Path | str) -> FloatArray:
    """The coefficients of a file as one read-only array.

    A file is read once, and again when its size or the time of its last change is another.
    Raises ParameterError for a file that cannot be read, is of another version or does not fit.
    """
    if not isinstance(path, Path | str):
        raise ParameterError(f"coefficients must be the path of a file, received {path!r}")
    path = Path(path)
    try:
        status = path.stat()
        return _read(path, status.st_mtime_ns, status.st_size)
    except UNUSABLE as unusable:
        raise ParameterError(
            f"coefficients must be a file of version {VERSION}: {path}: {unusable}"
        ) from unusable


@lru_cache(maxsize=16)
def _read(path: Path, changed_ns: int, size: int) -> FloatArray:
    """``read``, once for each path, time of change and size."""
    if not path.is_file() or size > LARGEST_BYTES:
        raise ValueError(f"must be a plain file of at most {LARGEST_BYTES} bytes")
    with path.open("rb") as file:
        parts = _parts(_unpacked(file.read(LARGEST_BYTES)))
    flat = _aligned(np.concatenate([np.ravel(part) for part in parts]).astype(np.float64))
    flat.flags.writeable = False
    return flat


def _aligned(values: FloatArray) -> FloatArray:
    """The same numbers, with the weights of the first layer at a multiple of 64 bytes.

    Vectors of eight weights then lie in one line of the cache each: on two, a network takes a fifth longer.
    """
    spare = np.empty(len(values) + LINE)
    first = spare.ctypes.data // spare.itemsize + network.Coefficients.length
    aligned = spare[-first % LINE :][: len(values)]
    aligned[:] = values
    return aligned


def _unpacked(packed: bytes) -> dict[str, Any]:
    """The arrays of an archive; nothing is inflated or laid out before its size is known to be bounded."""
    arrays: dict[str, Any] = {}
    with zipfile.ZipFile(io.BytesIO(packed)) as archive:
        members = archive.infolist()
        inflated = sum(member.file_size for member in members)
        if inflated > LARGEST_INFLATED:
            raise ValueError(f"may inflate to at most {LARGEST_INFLATED} bytes, would to {inflated}")
        for member in members:
            name = member.filename.removesuffix(".npy")
            arrays[name] = _array(name, archive.read(member))
    return arrays


def _array(name: str, written: bytes) -> Any:
    """One array, whose header must name as many bytes as follow it."""
    file = io.BytesIO(written)
    if np.lib.format.read_magic(file) != (1, 0):
        raise ValueError(f"{name} is not written in version 1.0 of its format")
    shape, _, kind = np.lib.format.read_array_header_1_0(file)
    if prod(shape) * kind.itemsize != len(written) - file.tell():
        raise ValueError(f"{name} has {len(written) - file.tell()} bytes, its header names {shape} of {kind}")
    file.seek(0)
    return np.lib.format.read_array(file, allow_pickle=False)


def _parts(arrays: dict[str, Any]) -> list[Any]:
    """The arrays in the order in which ``network.evaluate`` reads them; ValueError where one does not fit."""
    version = arrays["version"]
    if version.shape != () or version.dtype.kind not in "iu" or int(version) != VERSION:
        raise ValueError(f"is of version {version}")
    first, second = _width(arrays, 0), _width(arrays, 1)
    wanted: list[tuple[str, tuple[int, ...], float]] = [
        ("mean", (features.Values.length,), LARGEST_SCALE),
        ("scale", (features.Values.length,), LARGEST_SCALE),
    ]
    for number, (rows, width) in enumerate(
        ((features.Values.length, first), (first, second), (second, network.Outputs.length))
    ):
        wanted += [
            (f"weights{number}", (rows, width), LARGEST_WEIGHT),
            (f"offset{number}", (width,), LARGEST_WEIGHT),
        ]
    wanted.append(("table", (network.KNOTS, network.FACTORS), LARGEST_LOG))
    for name, shape, most in wanted:
        _check(name, arrays[name], shape, most)
    if not (arrays["scale"] > 0.0).all():
        raise ValueError(f"scale must hold numbers above 0, holds {arrays['scale'].min():g}")
    return [np.array([first, second], np.float64), *(arrays[name] for name, _, _ in wanted)]


def _width(arrays: dict[str, Any], number: int) -> int:
    """How many units a hidden layer has."""
    shape = arrays[f"weights{number}"].shape
    if len(shape) != 2 or not 1 <= shape[1] <= WIDEST:
        raise ValueError(f"weights{number} must have from 1 to {WIDEST} columns, is of shape {shape}")
    return int(shape[1])


def _check(name: str, values: Any, shape: tuple[int, ...], most: float) -> None:
    if values.shape != shape or values.dtype.kind != "f":
        raise ValueError(f"{name} must hold floats of shape {shape}, holds {values.dtype} of {values.shape}")
    if (wrong := values[~(np.abs(values) <= most)]).size:
        raise ValueError(f"{name} must hold numbers of magnitude up to {most:g}, holds {wrong.flat[0]:g}")


def layers_of(path: Path | str = OWN) -> tuple[FloatArray, FloatArray, list[tuple[FloatArray, FloatArray]]]:
    """Means and scales of the inputs, and the layers of a file's network; raises ParameterError."""
    file = network.Coefficients(read(path))
    sizes = (features.Values.length, int(file.first), int(file.second), network.Outputs.length)
    layers, at = [], 0
    for rows, width in pairwise(sizes):
        offset = at + rows * width
        layers.append((file.rest[at:offset].reshape(rows, width), file.rest[offset : offset + width]))
        at = offset + width
    return file.mean, file.scale, layers


def card(path: Path = OWN) -> dict[str, Any]:
    """What the file says of itself: sets, users, seeds, scores; raises ParameterError where it is no card."""
    try:
        if path.stat().st_size > LARGEST_BYTES:
            raise ValueError(f"must be a file of at most {LARGEST_BYTES} bytes")
        about = json.loads(_unpacked(path.read_bytes())["card"].tobytes())
        if not isinstance(about, dict) or not all(
            isinstance(one["name"], str) for one in about.get("sets", ())
        ):
            raise ValueError("must be a JSON object whose sets have names")
    except UNUSABLE as unusable:
        raise ParameterError(f"the card of {path}: {type(unusable).__name__}: {unusable}") from unusable
    return about


def sets(path: Path | str = OWN) -> frozenset[str]:
    """The names of the sets that the coefficients were fitted to, as far as the card says.

    Read once, and again when the file's size or the time of its last change is another; raises ParameterError
    where there is no card.
    """
    path = Path(path)
    status = path.stat()
    return _sets(path, status.st_mtime_ns, status.st_size)


@lru_cache(maxsize=16)
def _sets(path: Path, changed_ns: int, size: int) -> frozenset[str]:
    """``sets``, once for each path, time of change and size."""
    return frozenset(one["name"] for one in card(path).get("sets", ()))


def digest(path: Path = OWN) -> str:
    """A short digest of what the file holds: how an interpreter packs the same arrays makes no difference."""
    digest = hashlib.blake2b(digest_size=8)
    with np.load(path, allow_pickle=False) as arrays:
        for name in sorted(arrays.files):
            array = np.ascontiguousarray(arrays[name])
            digest.update(f"{name} {array.dtype.str} {array.shape} ".encode() + array.tobytes())
    return digest.hexdigest()
