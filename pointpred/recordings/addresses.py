"""Files at addresses such as ``s3://bucket/study.csv``: copied once into a folder of this process."""

from __future__ import annotations

import atexit
import re
import shutil
import tempfile
from functools import cache
from pathlib import Path, PurePosixPath
from typing import Any

from pointpred.errors import MissingExtraError, PointpredError, RecordingError
from pointpred.extras import require

SCHEME = re.compile(r"(?<![\w/])([a-z][a-z0-9+.-]+):/+", re.IGNORECASE)
LOCAL = ("file", "local")
WEB = ("http", "https")
"""Protocols that have files only: to ask for a folder would fetch the file."""

_copies: dict[str, Path] = {}


def address_in(path: Path | str) -> str | None:
    """The address that a text is, or that a path was, whose ``//`` it has lost; ``None`` for a real path.

    A text is taken as it is. Of a path, which cannot tell two slashes from three, a ``file:`` is absolute and
    any other names its host.

    >>> address_in("hdfs:///study.csv"), address_in("study.csv")
    ('hdfs:///study.csv', None)
    >>> address_in(Path("s3://bucket/study.csv")), address_in(Path("zip://a.csv::file:///data/all.zip"))
    ('s3://bucket/study.csv', 'zip://a.csv::file:///data/all.zip')
    """
    text = path if isinstance(path, str) else path.as_posix()
    if not SCHEME.match(text) or Path(path).exists():
        return None
    return text if isinstance(path, str) else SCHEME.sub(_with_slashes, text)


def _with_slashes(scheme: re.Match[str]) -> str:
    return f"{scheme[1]}:///" if scheme[1].lower() in LOCAL else f"{scheme[1]}://"


def address_of(path: Path) -> str | None:
    """The address that a file was copied from; ``None`` for any other file."""
    return next((address for address, copy in _copies.items() if copy == path), None)


def local_copy(address: str) -> Path:
    """The file or folder at an address, copied with the trials file beside it; a second call copies nothing.

    The copy keeps the file's name and is deleted when the process ends. Raises RecordingError where nothing
    can be read there, MissingExtraError where the library for its protocol is not installed.
    """
    if address not in _copies:
        require("remote", f"reading {address}")
        try:
            _copies[address] = _copy(address)
        except PointpredError:
            raise
        except ImportError as error:
            message = f"{address}: {error}; install it beside pointpred with pip"
            raise MissingExtraError(message, field="files", value=address) from error
        except FileNotFoundError as error:
            message = f"{address}: no such file"
            raise RecordingError(message, code="no_recording", value=address) from error
        except Exception as error:  # each protocol has errors of its own
            why = f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
            raise RecordingError(f"{address}: cannot be read: {why}", value=address) from error
    return _copies[address]


def _copy(address: str) -> Path:
    import fsspec

    from pointpred.recordings.own import READ, trials_names  # loads Arrow, which no address needs

    system, place = fsspec.url_to_fs(address)
    folder = Path(tempfile.mkdtemp(dir=_folder()))
    name = PurePosixPath(place.partition("?")[0].rstrip("/")).name
    if not name:
        raise RecordingError(f"{address}: names no file", value=address)
    target = _inside(folder, name, address)
    if not _is_web(system) and system.isdir(place):
        top = system._strip_protocol(place)
        names = sorted(system.find(place))
        copies = [_inside(target, PurePosixPath(file).relative_to(top), address) for file in names]
        for file, copy in zip(names, copies, strict=True):
            copy.parent.mkdir(parents=True, exist_ok=True)
            system.get_file(file, str(copy))
        return target
    system.get_file(place, str(target))
    for beside in trials_names(target) if target.name.endswith(READ) else ():
        other = place[: place.rindex(name)] + beside.name
        if system.exists(other):
            system.get_file(other, str(beside))
            break
    return target


def _inside(folder: Path, name: str | PurePosixPath, address: str) -> Path:
    """A file of this name in a folder; raises RecordingError where an archive's name leads out of it."""
    file = folder / name
    if not file.resolve().is_relative_to(folder.resolve()):
        message = f"{address}: the name {str(name)!r} leads out of its folder: expected names without '..'"
        raise RecordingError(message, value=str(name))
    return file


def _is_web(system: Any) -> bool:
    protocols = (system.protocol,) if isinstance(system.protocol, str) else system.protocol
    return any(protocol in WEB for protocol in protocols)


@cache
def _folder() -> str:
    """A folder that ends with the process."""
    folder = tempfile.mkdtemp(prefix="pointpred-remote-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder
