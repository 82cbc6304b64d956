"""Files as text in any encoding: gzip, UTF-8, UTF-16, Windows-1252 or a named one, any line ends."""

from __future__ import annotations

import codecs
import gzip
import io
import re
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from itertools import chain
from pathlib import Path
from typing import BinaryIO, TextIO, cast

import msgspec

from pointpred.errors import RecordingError

MOST_BYTES = 1 << 31
"""The longest text that is read, counted after unpacking."""
HEAD_BYTES = 1 << 16
BLOCK_BYTES = 1 << 20
GZIP = b"\x1f\x8b\x08"
UTF_8 = codecs.BOM_UTF8
UTF_16 = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
CONTROLS = re.compile(rb"[\x00-\x08\x0e-\x1a\x1c-\x1f]")
"""Bytes that do not occur in Windows-1252 text."""
UNDEFINED = re.compile(rb"[\x81\x8d\x8f\x90\x9d]")
"""Bytes undefined in Windows-1252 but not in Latin-1."""
CONTROL_BYTES, UNDEFINED_BYTES = (
    bytes(byte for byte in range(256) if pattern.match(bytes([byte]))) for pattern in (CONTROLS, UNDEFINED)
)
_named: ContextVar[str | None] = ContextVar("encoding", default=None)
"""What ``text_in`` says."""
DAMAGED = (gzip.BadGzipFile, EOFError, zlib.error)


class Encoding(msgspec.Struct, frozen=True):
    """A file's encoding; ``name`` is Python's name of it.

    ``packed``: by gzip; ``returns``: lines end with CR alone, as from old Macintosh programs; ``odd`` is the
    first byte that is not UTF-8, ``None`` if the encoding is certain.
    """

    name: str
    packed: bool = False
    returns: bool = False
    odd: int | None = None

    @property
    def plain(self) -> bool:
        """Whether the file's bytes are plain UTF-8, perhaps with a byte order mark."""
        return self.name == "utf-8-sig" and not (self.packed or self.returns)

    @property
    def note(self) -> str:
        """A note if the encoding is a guess, else empty."""
        if self.odd is None:
            return ""
        title = {"cp1252": "Windows-1252", "latin-1": "Latin-1"}[self.name]
        return f"byte {self.odd} is not UTF-8: the file is read as {title}"


@contextmanager
def text_in(encoding: str | None) -> Iterator[None]:
    """Read every text within as of this encoding, of whatever is detected where it is ``None``."""
    before = _named.set(encoding)
    try:
        yield
    finally:
        _named.reset(before)


def encoding_of(path: Path) -> Encoding:
    """The encoding of a whole text file; memory is one block for any unpacked size.

    UTF-16 is detected by its mark. Text that is not UTF-8 is Windows-1252, or Latin-1 if a byte is undefined
    in that. Raises RecordingError for a binary file, a damaged gzip file, more than 2 GiB after unpacking,
    and text that is not in the encoding of ``text_in``.
    """
    if (named := _named.get()) is not None:
        return _in_named(path, named)
    decoder = codecs.getincrementaldecoder("utf-8")()
    place, odd, control, returns, feeds, undefined = 0, -1, -1, False, False, False
    with open_unpacked(path) as file:
        packed = _is_packed(file)
        for block in _blocks(path, file):
            if not place and block.startswith(UTF_16):
                for _ in _blocks(path, file, len(block)):
                    pass
                return Encoding("utf-16", packed)
            zero = block.find(0)
            if zero >= 0:
                raise _binary(path, place + zero, "is 0")
            if odd < 0:
                odd = _odd(decoder, block, place)
            if control < 0 and _has(block, CONTROL_BYTES) and (match := CONTROLS.search(block)):
                control = place + match.start()
            undefined = undefined or _has(block, UNDEFINED_BYTES)
            returns, feeds = returns or b"\r" in block, feeds or b"\n" in block
            place += len(block)
    if odd < 0:
        odd = _odd(decoder, b"", place)
    if odd < 0:
        return Encoding("utf-8-sig", packed, returns and not feeds)
    if control >= 0:
        raise _binary(path, control, "is a control character")
    return Encoding("latin-1" if undefined else "cp1252", packed, returns and not feeds, odd)


def _in_named(path: Path, name: str) -> Encoding:
    """The encoding that was named, where the whole file can be decoded by it; raises RecordingError."""
    decoder = codecs.getincrementaldecoder(name)()
    place, returns, feeds = 0, False, False
    with open_unpacked(path) as file:
        packed = _is_packed(file)
        for block in chain(_blocks(path, file), [b""]):
            odd = _odd(decoder, block, place)
            if odd >= 0:
                raise RecordingError(f"{path}: byte {odd} is not {name}", code="not_text", value=odd)
            returns, feeds = returns or b"\r" in block, feeds or b"\n" in block
            place += len(block)
    utf_8 = codecs.lookup(name).name == "utf-8"
    return Encoding("utf-8-sig" if utf_8 else name, packed, returns and not feeds)


@contextmanager
def open_unpacked(path: Path) -> Iterator[BinaryIO]:
    """The bytes of a file, unpacked if it is gzip; raises RecordingError if it is damaged."""
    try:
        with path.open("rb") as raw:
            packed = raw.read(len(GZIP)) == GZIP
            raw.seek(0)
            if not packed:
                yield raw
                return
            with gzip.GzipFile(fileobj=raw, mode="rb") as file:
                yield cast(BinaryIO, file)
    except DAMAGED as error:
        raise RecordingError(f"{path}: damaged gzip file: {error}", code="damaged_file") from error
    except OSError as error:
        raise RecordingError(f"{path}: cannot be read: {error.strerror or error}") from error


@contextmanager
def open_text(path: Path) -> Iterator[TextIO]:
    """A text file to read line by line, without a mark and with LF line ends; raises RecordingError."""
    name = encoding_of(path).name
    try:
        with open_unpacked(path) as file, io.TextIOWrapper(file, encoding=name) as text:
            yield text
    except UnicodeDecodeError as error:  # UTF-16 only, which is detected by its mark
        raise RecordingError(
            f"{path}: damaged {name.upper()} text: {error.reason}", code="damaged_file"
        ) from error


@contextmanager
def open_utf8(path: Path) -> Iterator[tuple[BinaryIO, Encoding]]:
    """The bytes of a text file as UTF-8, and its original encoding; raises RecordingError.

    A file that is UTF-8 is opened as it is; any other is decoded into memory.
    """
    encoding = encoding_of(path)
    if encoding.plain:
        with open_unpacked(path) as file:
            yield file, encoding
    else:
        yield io.BytesIO(read_text(path).encode()), encoding


def read_text(path: Path) -> str:
    """The whole file as text with LF line ends; raises RecordingError if it is empty or binary."""
    with open_text(path) as file:
        text = file.read()
    if not text.strip():
        raise RecordingError(f"{path}: the file is empty, expected a recording", code="empty_file")
    return text


def read_unpacked(path: Path) -> bytes:
    """All bytes of a file, at most 2 GiB, unpacked if it is gzip; raises RecordingError."""
    with open_unpacked(path) as file:
        return b"".join(_blocks(path, file))


def head_of(path: Path, most: int = HEAD_BYTES) -> bytes:
    """The first ``most`` bytes, unpacked; text as UTF-8 without a mark and with LF for CR line ends.

    Raises RecordingError if the file is empty.
    """
    with open_unpacked(path) as file:
        head = file.read(most)
    if not head:
        raise RecordingError(f"{path}: the file is empty, expected a recording", code="empty_file")
    named = _named.get()
    if named is not None:
        if _odd(codecs.getincrementaldecoder(named)(), head, 0) < 0:
            head = head.decode(named, "ignore").encode("utf-8", "ignore")
    elif head.startswith(UTF_16):
        head = head.decode("utf-16", "ignore").encode("utf-8", "ignore")
    elif _odd(codecs.getincrementaldecoder("utf-8")(), head, 0) >= 0 and not CONTROLS.search(head):
        head = head.decode("latin-1" if UNDEFINED.search(head) else "cp1252").encode()
    head = head.removeprefix(UTF_8)
    return head if b"\n" in head else head.replace(b"\r", b"\n")


def holds(path: Path, word: bytes, most: int) -> bool:
    """Whether the first ``most`` bytes of a file, unpacked, contain ``word``; memory is two blocks."""
    tail, place = b"", 0
    with open_unpacked(path) as file:
        for block in _blocks(path, file):
            if word in tail + block:
                return True
            tail, place = block[-len(word) :], place + len(block)
            if place >= most:
                return False
    return False


def is_ended(path: Path) -> bool:
    """Whether a text file ends with a line break; raises RecordingError."""
    with open_unpacked(path) as file:
        tail = b""
        if not _is_packed(file):
            file.seek(max(file.seek(0, io.SEEK_END) - 2, 0))
        for block in _blocks(path, file):
            tail = (tail + block)[-2:]
    return tail.rstrip(b"\0").endswith((b"\n", b"\r"))


def stem_of(path: Path) -> str:
    """A file's name without its extension, and without ``.gz`` behind that.

    >>> stem_of(Path("study_samples.csv.gz"))
    'study_samples'
    """
    return (Path(path.stem) if path.suffix.lower() == ".gz" else path).stem


def _is_packed(file: object) -> bool:
    return isinstance(file, gzip.GzipFile)


def _blocks(path: Path, file: BinaryIO, place: int = 0) -> Iterator[bytes]:
    """The rest of a file, block by block; raises RecordingError beyond 2 GiB from ``place`` on."""
    while block := file.read(BLOCK_BYTES):
        place += len(block)
        if place > MOST_BYTES:
            raise RecordingError(
                f"{path}: more than {MOST_BYTES} bytes, at most so many are read", code="too_large"
            )
        yield block


def _has(block: bytes, some: bytes) -> bool:
    """Whether a block contains one of some bytes; ten times as fast as a regular expression."""
    return len(block.translate(None, some)) < len(block)


def _odd(decoder: codecs.IncrementalDecoder, block: bytes, place: int) -> int:
    """The first byte that cannot be decoded, else -1; an empty block ends the file."""
    waiting = len(decoder.getstate()[0])
    try:
        decoder.decode(block, final=not block)
    except UnicodeError as error:  # without a place where UTF-16 lacks its mark
        return place - waiting + getattr(error, "start", 0)
    return -1


def _binary(path: Path, place: int, what: str) -> RecordingError:
    return RecordingError(
        f"{path}: byte {place} {what}, so this is no text (binary, or UTF-16 without a mark?)",
        code="not_text",
        value=place,
    )
