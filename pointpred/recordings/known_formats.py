"""Every format pointpred reads, and the detection of a file's format by its content."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec

from pointpred.errors import RecordingError
from pointpred.recording import Recording
from pointpred.recordings import own
from pointpred.recordings.arrow_tables import ColumnTable
from pointpred.recordings.columns.table_recording import recording_of_table
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


def table_format(
    key: str,
    title: str,
    recognises: Callable[[bytes], bool],
    read: Callable[[Path, Reading], ColumnTable],
    *,
    binary: bool = False,
) -> Format:
    """A format whose files hold any table: ``read`` gives its cells."""

    def recording(path: Path, reading: Reading) -> Recording:
        return recording_of_table(path, read(path, reading), reading)

    return Format(key, title, recognises, recording, streams=True, tabular=True, binary=binary)


def _log(key: str, module: Any, **more: Any) -> Format:
    """A format of streams whose rows are read as those of a table, under the names t, x, y and buttons."""

    def recording(path: Path, reading: Reading) -> Recording:
        return recording_of_table(path, module.read(path, reading), reading)

    return Format(key, module.TITLE, module.recognises, recording, streams=True, **more)


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
    Format("gofitts", gofitts.TITLE, gofitts.recognises, gofitts.read),
    Format("balabit", balabit.TITLE, balabit.recognises, balabit.read, streams=True),
    Format(
        "pointing-dynamics", pointing_dynamics.TITLE, pointing_dynamics.recognises, pointing_dynamics.read
    ),
    Format("mousetrap", mousetrap.TITLE, mousetrap.recognises, mousetrap.read),
    Format("psychopy", psychopy.TITLE, psychopy.recognises, psychopy.read, takes=("px_per_unit",)),
    Format(
        "jspsych",
        jspsych.TITLE,
        jspsych.recognises,
        jspsych.read,
        recognises_further=jspsych.recognises_further,
    ),
    Format(
        "libinput", libinput.TITLE, libinput.recognises, libinput.read, streams=True, takes=("px_per_unit",)
    ),
    Format("evtest", evtest.TITLE, evtest.recognises, evtest.read, streams=True, takes=("px_per_unit",)),
    Format(
        "hid-recorder",
        hid_recorder.TITLE,
        hid_recorder.recognises,
        hid_recorder.read,
        streams=True,
        takes=("px_per_unit",),
    ),
    Format("evemu", evemu.TITLE, evemu.recognises, evemu.read, streams=True, takes=("px_per_unit",)),
    Format(
        "getevent", getevent.TITLE, getevent.recognises, getevent.read, streams=True, takes=("px_per_unit",)
    ),
    Format(
        "libinput-debug-events", debug_events.TITLE, debug_events.recognises, debug_events.read, streams=True
    ),
    _log("pynput", pynput),
    _log("rrweb", rrweb, recognises_further=rrweb.recognises_further),
    table_format("matlab", matlab.TITLE, matlab.recognises, matlab.read, binary=True),
    table_format("xlsx", xlsx.TITLE, xlsx.recognises, xlsx.read, binary=True),
    table_format("xdf", xdf.TITLE, xdf.recognises, xdf.read, binary=True),
    table_format("parquet", parquet.TITLE, parquet.recognises, parquet.read, binary=True),
    table_format("json", json_records.TITLE, json_records.recognises, json_records.read),
    table_format("delimited", delimited.TITLE, delimited.recognises, delimited.read),
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
