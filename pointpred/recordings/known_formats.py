"""Every format pointpred reads, and the detection of a file's format by its content."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec

from pointpred.errors import RecordingError
from pointpred.recording import Recording
from pointpred.recordings import own
from pointpred.recordings.encodings import head_of, text_in
from pointpred.recordings.formats import (
    balabit,
    debug_events,
    delimited,
    evemu,
    evtest,
    getevent,
    gofitts,
    hid_recorder,
    json_records,
    jspsych,
    libinput,
    matlab,
    mousetrap,
    parquet,
    pointing_dynamics,
    psychopy,
    pynput,
    rrweb,
    xdf,
    xlsx,
)
from pointpred.recordings.reading import AS_IS, Reading
from pointpred.recordings.tables import recording_of_table

ADVICE = (
    ((b"RDX2\n", b"RDX3\n"), "R data are not read; in R: write.csv(NAME, 'table.csv', row.names = FALSE)"),
    (
        (b"X\n\x00\x00\x00", b"A\n2\n", b"A\n3\n"),
        "R data are not read; in R: write.csv(readRDS('FILE'), 'table.csv', row.names = FALSE)",
    ),
    (
        (b"$FL2", b"$FL3"),
        "SPSS data are not read; save them in SPSS as CSV, or in R: write.csv(haven::read_sav(...), ...)",
    ),
    ((b"\x89HDF\r\n",), "HDF5 is not read; save t, x and y as CSV"),
)


class Format(msgspec.Struct, frozen=True):
    """A recording format: its key, its title, how it is recognised and read.

    ``streams``: it has no trials of its own; ``Reading.cut`` selects how they are cut. ``tabular``:
    ``Reading.columns`` names its columns. ``binary``: its files are not text. ``takes``: the options for
    tables that it uses although it is not a table of samples. ``recognises_further``: decides from the rest
    of the file if its head is ambiguous.
    """

    key: str
    title: str
    recognises: Callable[[bytes], bool]
    read: Callable[[Path, Reading], Recording]
    streams: bool = False
    tabular: bool = False
    binary: bool = False
    takes: tuple[str, ...] = ()
    recognises_further: Callable[[Path, bytes], bool] = lambda path, head: False


def _table(key: str, module: Any, **more: Any) -> Format:
    """A format whose files hold a table: the module gives its cells."""

    def recording(path: Path, reading: Reading) -> Recording:
        return recording_of_table(path, module.read(path, reading), reading)

    return Format(key, module.TITLE, module.recognises, recording, **more)


def _log(key: str, module: Any, takes: tuple[str, ...] = ("px_per_unit",)) -> Format:
    """A format of the events of devices, which move by counts or on a surface."""
    return Format(key, module.TITLE, module.recognises, module.read, streams=True, takes=takes)


ANY = {"streams": True, "tabular": True}
"""Of formats whose files hold any table."""


FORMATS: tuple[Format, ...] = (
    Format(
        "recorder",
        "pointpred recorder CSV",
        own.recognises_recorder,
        lambda path, reading: own.read(path, reading=reading),
        streams=True,
    ),
    Format(
        "own",
        "pointpred Parquet or CSV",
        own.recognises,
        lambda path, reading: own.read(path, reading=reading),
        recognises_further=own.recognises_further,
    ),
    _table("gofitts", gofitts),
    _table("balabit", balabit, streams=True),
    _table("pointing-dynamics", pointing_dynamics),
    _table("mousetrap", mousetrap),
    _table("psychopy", psychopy, takes=("px_per_unit",)),
    _table("jspsych", jspsych, recognises_further=jspsych.recognises_further),
    _log("libinput", libinput),
    _log("evtest", evtest),
    _log("hid-recorder", hid_recorder),
    _log("evemu", evemu),
    _log("getevent", getevent),
    _log("libinput-debug-events", debug_events, takes=()),
    _table("pynput", pynput, streams=True),
    _table("rrweb", rrweb, streams=True, recognises_further=rrweb.recognises_further),
    _table("matlab", matlab, binary=True, **ANY),
    _table("xlsx", xlsx, binary=True, **ANY),
    _table("xdf", xdf, binary=True, **ANY),
    _table("parquet", parquet, binary=True, **ANY),
    _table("json", json_records, **ANY),
    _table("delimited", delimited, **ANY),
)
"""In the order of detection: the strictest first."""


def format_of(path: Path, reading: Reading = AS_IS) -> Format | None:
    """The format of a file by its first 64 KiB, not by its name; ``None`` if none fits.

    If ``reading`` names columns, formats of general tables are tried first.
    """
    if path.exists() and not path.is_file():
        raise RecordingError(f"{path}: no file that can be read twice (a pipe?); write it to a file first")
    with text_in(reading.encoding):
        return _format_of(path, reading)


def _format_of(path: Path, reading: Reading) -> Format | None:
    """The format of a file that can be read twice."""
    head = head_of(path)
    formats = FORMATS if reading.columns is None else sorted(FORMATS, key=lambda form: not form.tabular)
    return next(
        (form for form in formats if form.recognises(head) or form.recognises_further(path, head)), None
    )


def advice_on(head: bytes) -> str:
    """Advice for a file that begins with ``head``; empty if the format is unknown.

    >>> advice_on(b"$FL2")
    'SPSS data are not read; save them in SPSS as CSV, or in R: write.csv(haven::read_sav(...), ...)'
    """
    return next((words for marks, words in ADVICE if head.startswith(marks)), "")
