"""Fetch a public set: over https, bounded, checked by digest, and in place only when complete."""

from __future__ import annotations

import hashlib
import ipaddress
import urllib.error
import urllib.request
from collections.abc import Callable, Sequence
from http.client import HTTPException
from pathlib import Path
from typing import IO, Any
from urllib.parse import urlsplit

import msgspec

from pointpred.datasets.catalogue import DataSet, RemoteFile
from pointpred.datasets.public import find
from pointpred.errors import ParameterError, SourceError
from pointpred.parameter import Parameter, check

CHUNK = 1 << 16
MOST_BYTES = 500 * 2**20
Progress = Callable[[str, int, int | None], None]
"""Called with a file's name, the bytes so far and all of them (``None`` where the server does not say)."""


class Fetched(msgspec.Struct, frozen=True):
    """A file that is in place. ``verified``: its digest is the catalogue's."""

    path: Path
    sha256: str
    size: int
    verified: bool


def fetch(
    name: str | DataSet,
    folder: str | Path,
    *,
    accept_unverified: bool = False,
    most_bytes: int = MOST_BYTES,
    timeout_s: float = 30.0,
    progress: Progress | None = None,
    say: Callable[[str], None] = print,
) -> tuple[Fetched, ...]:
    """Download the files of a set into ``folder`` (made where missing), one by one, and check each.

    ``say`` hears the licence before anything is fetched, and afterwards the digest of each file. A file
    without a recorded digest is fetched with ``accept_unverified`` only. A file that is already there is
    checked and kept, never replaced. Nothing is opened, unpacked or unpickled.

    Parameters: ``most_bytes`` largest size of one file in [1, 1e12] bytes; ``timeout_s`` in (0, 3600] s for
    each answer of the server. Returns what is in place.
    Raises ParameterError for an unknown set or one that is not to be fetched like this, SourceError when a
    download fails, is too large or has another digest than recorded; no part of that file is then left.
    """
    bounds = (
        Parameter("most_bytes", "bytes", 1, 1e12, "largest size of one file"),
        Parameter("timeout_s", "s", 1e-3, 3600.0, "longest silence of the server"),
    )
    check(bounds, {"most_bytes": most_bytes, "timeout_s": timeout_s})
    entry = find(name) if isinstance(name, str) else name
    if not entry.fetchable:
        raise ParameterError(f"{entry.name} cannot be fetched by a program: see {entry.page}. {entry.note}")
    unknown = [file.name for file in entry.files if file.sha256 is None]
    if unknown and not accept_unverified:
        raise ParameterError(
            f"{entry.name}: no digest is recorded for {', '.join(unknown)}, so what arrives cannot be "
            f"checked; pass accept_unverified=True to fetch it all the same"
        )
    for line in terms(entry):
        say(line)
    place = Path(folder)
    made = [path for path in (place, *place.parents) if not path.exists()]
    _make(place)
    try:
        return tuple(_one(file, place, most_bytes, timeout_s, progress, say) for file in entry.files)
    except BaseException:
        _clear(made)
        raise


def terms(entry: DataSet) -> tuple[str, ...]:
    """The licence of a set, whom to cite, and what else to know before it is used, a line each."""
    licence = f"{entry.name}: {entry.licence}. Please cite {entry.citation}. {entry.page}"
    return (licence, f"{entry.name}: {entry.note}") if entry.note else (licence,)


def check_url(url: str) -> None:
    """Raise ParameterError for a URL that is neither https nor, on this machine itself, http."""
    parts = urlsplit(url)
    if parts.scheme == "https" and parts.hostname:
        return
    if parts.scheme == "http" and _is_loopback(parts.hostname):
        return
    raise ParameterError(f"only https is fetched (http from this machine itself), received {url!r}")


def _is_loopback(host: str | None) -> bool:
    try:
        return host == "localhost" or ipaddress.ip_address(host or "").is_loopback
    except ValueError:
        return False


class _CarefulRedirect(urllib.request.HTTPRedirectHandler):
    """Follows a redirect only to where a direct request would be allowed."""

    def redirect_request(
        self, req: urllib.request.Request, fp: IO[bytes], code: int, msg: str, headers: Any, newurl: str
    ) -> urllib.request.Request | None:
        check_url(newurl)
        if urlsplit(req.full_url).scheme == "https" and urlsplit(newurl).scheme != "https":
            raise ParameterError(f"{req.full_url} redirects from https to {newurl!r}")
        return super().redirect_request(req, fp, code, msg, headers, newurl)


def _make(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise SourceError(f"{folder}: cannot be made: {error}") from error


def _clear(made: Sequence[Path]) -> None:
    """Remove the folders this call made that are still empty, the innermost first."""
    for path in made:
        if any(path.iterdir()):
            return
        path.rmdir()


def _one(
    file: RemoteFile,
    folder: Path,
    most_bytes: int,
    timeout_s: float,
    progress: Progress | None,
    say: Callable[[str], None],
) -> Fetched:
    """One file: kept where it is already there, otherwise downloaded beside its place and renamed."""
    path = folder / Path(file.name).name
    exists = path.exists()
    part = path if exists else path.with_name(path.name + ".part")
    try:
        if exists:
            with path.open("rb") as present:
                digest = hashlib.file_digest(present, "sha256").hexdigest()
        else:
            digest = _download(file, part, most_bytes, timeout_s, progress)
        if file.sha256 is not None and digest != file.sha256:
            raise SourceError(f"{path}: expected sha256 {file.sha256}, received {digest}")
        part.replace(path)
        fetched = Fetched(path, digest, path.stat().st_size, file.sha256 is not None)
    except (OSError, HTTPException, urllib.error.URLError) as error:
        if isinstance(error, SourceError):
            raise
        raise SourceError(f"{file.url}: {error}") from error
    finally:
        if not exists:
            part.unlink(missing_ok=True)
    state = "digest as recorded" if fetched.verified else "not verified, digest to be recorded"
    say(f"{path}: {'already there, ' if exists else ''}{fetched.size} bytes, {state}: sha256 {digest}")
    return fetched


def _download(
    file: RemoteFile, part: Path, most_bytes: int, timeout_s: float, progress: Progress | None
) -> str:
    """Stream one file to disk; returns its sha256."""
    check_url(file.url)
    opener = urllib.request.build_opener(_CarefulRedirect)
    digest, size = hashlib.sha256(), 0
    with opener.open(file.url, timeout=timeout_s) as answer, part.open("wb") as out:
        length = answer.headers.get("Content-Length")
        total = int(length) if length is not None and length.isdigit() else None
        _bound(file, total or 0, most_bytes)
        while chunk := answer.read(CHUNK):
            size += len(chunk)
            _bound(file, size, most_bytes)
            digest.update(chunk)
            out.write(chunk)
            if progress is not None:
                progress(file.name, size, total)
    if total is not None and size != total:
        raise SourceError(f"{file.url}: cut short, expected {total} bytes, received {size}")
    return digest.hexdigest()


def _bound(file: RemoteFile, size: int, most_bytes: int) -> None:
    if size > most_bytes:
        raise SourceError(f"{file.url}: larger than the bound of {most_bytes} bytes, received {size}")
