"""XDF, as Lab Streaming Layer's recorder writes it: the stream of a mouse."""

from __future__ import annotations

import io
import logging
import struct
from collections.abc import Iterator
from contextlib import contextmanager
from os import SEEK_END
from pathlib import Path
from typing import Any, BinaryIO
from xml.etree import ElementTree

import msgspec

from pointpred.errors import RecordingError
from pointpred.extras import require
from pointpred.recordings.arrow_tables import ColumnTable, distinct_names, unreadable
from pointpred.recordings.encodings import open_unpacked
from pointpred.recordings.reading import AS_IS, Reading
from pointpred.recordings.table_choice import MOST_SHOWN, has_column

TITLE = "XDF"
MAGIC = b"XDF:"
STREAM_HEADER = 2
OF_STREAM = (STREAM_HEADER, 3, 4, 6)
"""Tags of chunks that begin with their stream's number: header, samples, clock offset, footer."""
TAG_BYTES, NUMBER_BYTES = 2, 4
LENGTHS = {1: "<B", 4: "<I", 8: "<Q"}
"""The format of a chunk's length, by the byte before it."""
POSITIONS = ("mocap", "position")
MOST_CHANNELS = 1024
MOST_HEADER = 1 << 24
TIMES = "time_stamps"


class Stream(msgspec.Struct, frozen=True):
    """The header of a stream: its number, name, type, format of values.

    ``columns``: a name for each channel, its label or its place from 0.
    """

    number: int
    name: str
    kind: str
    format: str
    columns: tuple[str, ...]

    @property
    def title(self) -> str:
        """Its name in messages."""
        return f"{self.name} (type {self.kind or 'unknown'}, {len(self.columns)} channels)"


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` is an XDF file."""
    return head.startswith(MAGIC)


def read(path: Path, reading: Reading = AS_IS) -> ColumnTable:
    """Read the only stream that may be a mouse, or has the channels that ``reading.columns`` names.

    Times are those of the recording computer: clock offsets are removed, jitter is not. The columns are
    ``time_stamps`` in s and one per channel, by its label or its place from 0.
    Raises RecordingError, which names the streams; MissingExtraError.
    """
    require("tables", f"{path}: reading XDF")
    with open_unpacked(path) as file:
        streams, cut = _streams(path, file)
        stream = _chosen(path, streams, reading)
        part = _chunks_of(file, stream.number)
    values, times, faults = _load(path, part, stream)
    columns = {TIMES: times} | dict(zip(stream.columns, values.T, strict=True))
    notes = [
        f"stream {stream.title}: clocks synchronized, jitter of the time stamps kept",
        *(f"stream left aside: {other.title}" for other in streams if other != stream),
        *([cut] if cut else []),
        *faults,
    ]
    return ColumnTable(columns, TITLE, tuple(notes))


def _streams(path: Path, file: BinaryIO) -> tuple[list[Stream], str]:
    """The headers of all streams, and a note if the file ends within a chunk or is damaged."""
    streams, end = [], 0
    for tag, start, size in _chunks(file):
        if tag == STREAM_HEADER:
            if size > MOST_HEADER:
                raise RecordingError(f"{path}: damaged XDF: the header of a stream has {size} bytes")
            streams.append(_stream(path, _number(file), file.read(size - NUMBER_BYTES)))
        end = start + size
    file.seek(end or len(MAGIC))
    cut = bool(file.read(1))
    return streams, f"cut or damaged from byte {end} on: left aside from there" if cut else ""


def _chunks(file: BinaryIO) -> Iterator[tuple[int, int, int]]:
    """Tag, offset and size of the content of every chunk up to the first that is cut or damaged.

    The file is positioned at the content of each chunk.
    """
    file.seek(0, SEEK_END)
    length = file.tell()
    at = len(MAGIC)
    while at < length:
        file.seek(at)
        layout = LENGTHS.get(file.read(1)[0])
        if layout is None:
            return
        head = file.read(struct.calcsize(layout) + TAG_BYTES)
        if len(head) < struct.calcsize(layout) + TAG_BYTES:
            return
        size, tag = struct.unpack(f"{layout}H", head)
        start, size = at + 1 + len(head), size - TAG_BYTES
        if not (NUMBER_BYTES if tag in OF_STREAM else 0) <= size <= length - start:
            return
        yield tag, start, size
        at = start + size


def _chunks_of(file: BinaryIO, number: int) -> io.BytesIO:
    """The complete chunks of one stream as a separate file."""
    part = io.BytesIO()
    part.write(MAGIC)
    for tag, start, size in _chunks(file):
        if tag in OF_STREAM and _number(file) == number:
            file.seek(start)
            part.write(b"\x08" + struct.pack("<QH", size + TAG_BYTES, tag) + file.read(size))
    part.seek(0)
    return part


def _number(file: BinaryIO) -> int:
    return int.from_bytes(file.read(NUMBER_BYTES), "little")


def _stream(path: Path, number: int, header: bytes) -> Stream:
    try:
        root = ElementTree.fromstring(header.decode("utf-8", "replace"))
        channels = int(root.findtext("channel_count", "0"))
    except (ElementTree.ParseError, ValueError) as error:
        raise RecordingError(f"{path}: damaged XDF: the header of stream {number}: {error}") from error
    if not 0 <= channels <= MOST_CHANNELS:
        raise RecordingError(
            f"{path}: stream {number} has {channels} channels, at most {MOST_CHANNELS} are read"
        )
    labels = [one.findtext("label", "") for one in root.findall("desc/channels/channel")][:channels]
    labels += [""] * (channels - len(labels))
    columns = distinct_names([*(label or str(at) for at, label in enumerate(labels)), TIMES])[:-1]
    name, kind, values = (root.findtext(tag, "").strip() for tag in ("name", "type", "channel_format"))
    return Stream(number, name, kind, values, tuple(columns))


def _chosen(path: Path, streams: list[Stream], reading: Reading) -> Stream:
    """The only stream that is a mouse, a position, or has x and y, of those with the channels that are named.

    Where none is, the only one with these channels.
    """
    numeric = [stream for stream in streams if stream.format != "string" and len(stream.columns) >= 2]
    told = (reading.columns or {}).values()
    named = [one for one in numeric if all(has_column([TIMES, *one.columns], str(name)) for name in told)]
    groups = [
        [stream for stream in named if "mouse" in (stream.name + stream.kind).lower()],
        [stream for stream in named if {"x", "y"} <= {name.lower() for name in stream.columns}],
        [stream for stream in named if stream.kind.lower() in POSITIONS],
        named if told else [],
    ]
    fits = next((group for group in groups if group), [])
    if len(fits) == 1:
        return fits[0]
    what = f"{len(fits)} streams may" if fits else "no stream of numbers can"
    titles = "; ".join(f"{one.title}: {', '.join(one.columns[:MOST_SHOWN])}" for one in streams[:MOST_SHOWN])
    raise RecordingError(
        f"{path}: {what} be a mouse; name channels of the one that is meant, as in: "
        f"--columns x=LABEL,y=LABEL; the file holds {titles or 'no stream'}"
    )


def _load(path: Path, file: io.BytesIO, stream: Stream) -> tuple[Any, Any, list[str]]:
    """Values, times in s, and pyxdf's messages about damage."""
    import pyxdf

    try:
        with _log_of("pyxdf") as faults:
            loaded, _ = pyxdf.load_xdf(
                file, select_streams=[stream.number], synchronize_clocks=True, dejitter_timestamps=False
            )
        values, times = loaded[0]["time_series"], loaded[0]["time_stamps"]
    except MemoryError as error:  # the file need not be damaged
        raise unreadable(path, error) from error
    except Exception as error:  # pyxdf raises errors of many kinds on damaged bytes
        raise RecordingError(f"{path}: damaged XDF: {str(error)[:120]}") from error
    if not len(times) or values.shape != (len(times), len(stream.columns)):
        raise RecordingError(f"{path}: the stream {stream.title} holds no samples")
    return values, times, faults


@contextmanager
def _log_of(name: str) -> Iterator[list[str]]:
    """The errors that a library logs, each once."""
    lines: dict[str, None] = {}

    class Listener(logging.Handler):
        def emit(self, record: logging.LogRecord) -> None:
            if record.levelno >= logging.ERROR:  # its warnings are about segments for jitter removal
                lines[f"{name}: {record.getMessage()[:120]}"] = None

    logger, listener = logging.getLogger(name), Listener(logging.WARNING)
    logger.addHandler(listener)
    unique: list[str] = []
    try:
        yield unique
    finally:
        logger.removeHandler(listener)
        unique += lines
