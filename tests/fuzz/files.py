"""Any bytes as a recording of one format, and as a file of coefficients."""

from __future__ import annotations

import io
import os
import tempfile
import warnings
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path

import numpy as np

from pointpred.errors import ParameterError, PointpredError
from pointpred.predictors.kinematic import coefficient_file
from pointpred.recordings.encodings import head_of
from pointpred.recordings.known_formats import Format, format_of
from pointpred.recordings.reading import AS_IS
from tests.fuzz.inputs import check as check_recording
from tests.fuzz.refusals import refused

DATA = Path(__file__).parents[1] / "data" / "sources"
DEFLATED = zipfile.ZIP_DEFLATED


@contextmanager
def as_file(data: bytes) -> Iterator[Path]:
    """A path at which the bytes can be read until the block ends; in memory on Linux, which is fast."""
    if hasattr(os, "memfd_create"):
        with os.fdopen(os.memfd_create("input"), "wb") as file:
            file.write(data)
            file.flush()
            yield Path(f"/proc/self/fd/{file.fileno()}")
        return
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "input"
        path.write_bytes(data)
        yield path


def check_source(form: Format, data: bytes) -> str:
    """A file that is recognised as of this format is read in order, or refused with its name."""
    with as_file(data) as path:
        try:
            head = head_of(path)
            if not (form.recognises(head) or form.recognises_further(path, head)):
                return "another format"
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                recording = form.read(path, AS_IS)
        except PointpredError as error:
            return refused(error, path.name)
    check_recording(recording)
    return "read"


def source_seeds(form: Format) -> list[bytes]:
    """The examples of a format."""
    examples = sorted(path for path in DATA.rglob("*") if path.is_file())
    return [path.read_bytes() for path in examples if format_of(path) is form]


@cache
def _members() -> dict[str, bytes]:
    """The files in the archive that comes with the package, without most of its card."""
    with zipfile.ZipFile(coefficient_file.OWN) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def check_coefficients(data: bytes) -> str:
    """An input is a whole file, or a byte from 1 to 31 and what one of its members holds instead."""
    names = list(_members())
    if data[:1] and 0 < data[0] < 32:
        members = {**_members(), names[data[0] % len(names)]: data[1:]}
        packed = io.BytesIO()
        with zipfile.ZipFile(packed, "w") as archive:
            for name, content in members.items():
                archive.writestr(name, content)
        data = packed.getvalue()
    with as_file(data) as path:
        coefficient_file._read.cache_clear()
        read = 0
        for reader in (coefficient_file.read, coefficient_file.card):
            try:
                result = reader(path)
                assert not isinstance(result, np.ndarray) or np.isfinite(result).all()
                read += 1
            except ParameterError as error:
                refused(error, str(path))
    return ("refused", "half read", "read")[read]


def coefficient_seeds() -> list[bytes]:
    """A small archive, and the small members of the file that comes with the package."""
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", DEFLATED) as archive:
        archive.writestr("version.npy", _members()["version.npy"])
        archive.writestr("card.npy", npy(np.frombuffer(b'{"sets":[{"name":"a"}]}', np.uint8)))
    replaced = [
        bytes([place or len(_members())]) + content
        for place, content in enumerate(_members().values())
        if len(content) < 4096
    ]
    return [packed.getvalue(), *replaced]


def npy(array: object) -> bytes:
    """An array as a file of numpy's."""
    file = io.BytesIO()
    np.save(file, np.asarray(array))
    return file.getvalue()
