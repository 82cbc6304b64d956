"""Every format pointpred reads: recognise a file by its content, read files and folders, convert."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from os.path import commonpath
from pathlib import Path

import msgspec

from pointpred.errors import ColumnsError, MissingExtraError, RecordingError
from pointpred.recording import Recording, Skip
from pointpred.sources import (
    appended,
    balabit,
    delimited,
    elsewhere,
    evemu,
    evtest,
    gofitts,
    hid_recorder,
    jspsych,
    libinput,
    matlab,
    mousetrap,
    parquet_table,
    pointing_dynamics,
    psychopy,
    recordings,
    records_json,
    tables,
    workbook,
    xdf,
)
from pointpred.sources.column_table import ColumnTable, recording_of_table
from pointpred.sources.decoding import encoding_of, head_of
from pointpred.sources.folders import listed
from pointpred.sources.joining import join
from pointpred.sources.naming import described_readably, file_names
from pointpred.sources.reading import AS_IS, Reading, TimeUnit
from pointpred.sources.writing import together

Progress = Callable[[str, int, int], None]
OWN = ("recorder", "own")
"""Formats of which each file is a recording of its own."""
ONE_TABLE = ("parquet", "delimited")
"""Formats of which a file holds one table, so that ``Reading.records`` has nothing to choose."""
OWN_NAMES = (set(recordings.REQUIRED), {"user", "trial", "n_samples"})
"""The columns by which pointpred's own samples and trials are known without their mark."""


class Format(msgspec.Struct, frozen=True):
    """A recording format: its key, what people call it, how it is recognised and read.

    ``streams``: it has no trials of its own, so that ``Reading.cut`` says how they are cut.
    ``tabular``: ``Reading.columns`` says what its columns are. ``binary``: its files are no text.
    ``takes``: what of that it has a use for although it is no table of samples.
    ``recognises_further``: looks on in a file, which begins with a head that does not tell.
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


def _is_own(head: bytes) -> bool:
    """Whether a text that begins with ``head`` is one of pointpred's own."""
    first = head.split(b"\n", 1)[0]
    named = first.decode("utf-8", "replace").replace('"', "").replace("\r", "").split(",")
    return first.startswith(tables.MARK) or any(needed <= set(named) for needed in OWN_NAMES)


def _is_own_parquet(path: Path, head: bytes) -> bool:
    """Whether a file is pointpred's own Parquet: what it holds stands at its end."""
    if not parquet_table.recognises(head):
        return False
    marked, names = tables.parquet_names(path)
    return marked or any(needed <= names for needed in OWN_NAMES)


FORMATS: tuple[Format, ...] = (
    Format(
        "recorder",
        appended.TITLE,
        appended.recognises,
        lambda path, reading: recordings.read(path, reading=reading),
        streams=True,
    ),
    Format(
        "own",
        "pointpred Parquet or CSV",
        _is_own,
        lambda path, reading: recordings.read(path, reading=reading),
        recognises_further=_is_own_parquet,
    ),
    Format("gofitts", gofitts.TITLE, gofitts.recognises, gofitts.read),
    Format("balabit", balabit.TITLE, balabit.recognises, balabit.read, streams=True),
    Format(
        "pointing-dynamics", pointing_dynamics.TITLE, pointing_dynamics.recognises, pointing_dynamics.read
    ),
    Format("mousetrap", mousetrap.TITLE, mousetrap.recognises, mousetrap.read),
    Format("psychopy", psychopy.TITLE, psychopy.recognises, psychopy.read, takes=("px_per_unit", "unit")),
    Format(
        "jspsych",
        jspsych.TITLE,
        jspsych.recognises,
        jspsych.read,
        recognises_further=jspsych.recognises_further,
    ),
    Format("libinput", libinput.TITLE, libinput.recognises, libinput.read, streams=True),
    Format("evtest", evtest.TITLE, evtest.recognises, evtest.read, streams=True),
    Format("hid-recorder", hid_recorder.TITLE, hid_recorder.recognises, hid_recorder.read, streams=True),
    Format("evemu", evemu.TITLE, evemu.recognises, evemu.read, streams=True),
    table_format("matlab", matlab.TITLE, matlab.recognises, matlab.read, binary=True),
    table_format("xlsx", workbook.TITLE, workbook.recognises, workbook.read, binary=True),
    table_format("xdf", xdf.TITLE, xdf.recognises, xdf.read, binary=True),
    table_format("parquet", parquet_table.TITLE, parquet_table.recognises, parquet_table.read, binary=True),
    table_format("json", records_json.TITLE, records_json.recognises, records_json.read),
    table_format("delimited", delimited.TITLE, delimited.recognises, delimited.read),
)
"""In the order in which they are tried: the strictest first."""


class Summary(msgspec.Struct, frozen=True):
    """What a conversion did: the files written, trials and users kept, trials skipped by reason, notes."""

    files: tuple[str, ...]
    trials: int
    users: int
    rows: int
    skipped: dict[str, int]
    notes: tuple[str, ...]


def format_of(path: Path, reading: Reading = AS_IS) -> Format | None:
    """The format of a file by its first 64 KiB, whatever its name; ``None`` where none fits.

    Where ``reading`` names columns or records, the file is any table before it is anything else.
    """
    if path.exists() and not path.is_file():
        raise RecordingError(f"{path}: no file that can be read twice (a pipe?); write it to a file first")
    head = head_of(path)
    told = reading.columns is not None or reading.records is not None
    formats = sorted(FORMATS, key=lambda form: not form.tabular) if told else FORMATS
    return next(
        (form for form in formats if form.recognises(head) or form.recognises_further(path, head)), None
    )


def read_any(
    path: str | Path,
    reading: Reading = AS_IS,
    progress: Progress | None = None,
    *,
    columns: Mapping[str, str | int] | None = None,
    time_unit: TimeUnit | None = None,
    y_up: bool | None = None,
    px_per_unit: float | None = None,
    records: str | None = None,
) -> list[Recording]:
    """Read a recording of any known format, or every recording in a folder and the folders below it.

    A file's format is told by its content. In a folder each own recording stays one; files of one foreign
    format (sessions, users) become one recording named after the folder they share. A file that fits no
    format is named in a note, one that cannot be read is a skip named after it; only when nothing can be read
    an error is raised. ``progress`` is told before each file of a folder: its path, how many are done, of
    how many.
    The keywords say of any table what ``Reading`` describes, in the place of the fields of ``reading``.
    Returns at least one recording; raises RecordingError naming the formats that were tried, ColumnsError
    for a table whose columns are not certain, and ParameterError for a keyword out of its bounds.
    """
    path = Path(path)
    told = {
        "columns": None if columns is None else dict(columns),
        "time_unit": time_unit,
        "y_up": y_up,
        "px_per_unit": px_per_unit,
        "records": records,
    }
    reading = msgspec.structs.replace(
        reading, **{name: value for name, value in told.items() if value is not None}
    )
    found = _folder(path, reading, progress) if path.is_dir() else [_file(path, reading)]
    return [described_readably(recording) for recording in found]


def convert(
    path_in: str | Path, path_out: str | Path, reading: Reading = AS_IS, *, replace: bool = True
) -> Summary:
    """Convert a recording of any format, or a folder of one, to pointpred's own Parquet or CSV.

    ``path_out`` ends in ``.parquet`` or ``.csv``; where the input holds several recordings, each goes to a
    file of that name with its own name put in front. A recording without a trial is not written. Where
    anything fails, no file is left and none is replaced. Returns what was kept and skipped; raises
    RecordingError, and ParameterError where a file would be replaced without ``replace``.
    """
    return write_found(read_any(path_in, reading), path_out, replace=replace)


def write_found(found: list[Recording], path_out: str | Path, *, replace: bool = True) -> Summary:
    """Write recordings as ``convert`` does; raises what it raises."""
    out = Path(path_out)
    several = len(found) > 1
    names = file_names([recording.name for recording in found], out.name) if several else [out.name]
    for name in names:
        (recordings.files_of if replace else recordings.check_free)(out.with_name(name))
    files: list[str] = []
    with together() as part:
        for recording, name in zip(found, names, strict=True):
            if recording.trials:
                files += map(str, recordings.write_parts(recording, out.with_name(name), part))
    return Summary(
        tuple(files),
        sum(len(recording.trials) for recording in found),
        len({(recording.name, trial.user) for recording in found for trial in recording.trials}),
        sum(len(recording.events) for recording in found),
        dict(Counter(skip.reason for recording in found for skip in recording.skipped)),
        tuple(note for recording in found for note in recording.notes),
    )


def _file(path: Path, reading: Reading) -> Recording:
    """The recording in one file."""
    form = format_of(path, reading)
    if form is None:
        if advice := elsewhere.advice(head_of(path)):
            raise RecordingError(f"{path}: {advice}")
        tried = ", ".join(form.title for form in FORMATS)
        raise RecordingError(f"{path}: no known recording format; tried {tried}")
    return _read(form, path, reading)


def _read(form: Format, path: Path, reading: Reading) -> Recording:
    """One file; a way of cutting that its format has no use for is named in a note."""
    recording = form.read(path, reading)
    if form.key not in OWN and not form.binary and (note := encoding_of(path).note):
        recording = msgspec.structs.replace(recording, notes=(note, *recording.notes))
    notes = []
    if reading.cut is not None and not form.streams:
        notes.append(f"cut {reading.cut!r} has no effect: {form.title} has trials of its own")
    if reading.records is not None and form.key in ONE_TABLE:
        notes.append(f"records has no effect: {form.title} is one table")
    beside = recordings.trials_beside(path) if form.tabular and recordings.is_samples(path) else None
    if beside is not None:
        notes.append(f"{beside.name} is not read: with columns, the file is read as any table")
    told = [] if form.tabular else _of_tables(reading, form)
    notes += [f"{name} has no effect: {form.title} says it itself" for name in told if name not in form.takes]
    return msgspec.structs.replace(recording, notes=(*recording.notes, *notes)) if notes else recording


def _of_tables(reading: Reading, form: Format) -> list[str]:
    """What ``reading`` says that only tables take; of our own ones, the unit of time."""
    names = (
        "columns",
        "y_up",
        "px_per_unit",
        "records",
        "unit",
        *(("time_unit",) if form.key != "own" else ()),
    )
    return [name for name in names if getattr(reading, name) not in (None, False)]


def _folder(path: Path, reading: Reading, progress: Progress | None) -> list[Recording]:
    """The recordings in a folder."""
    own: list[Recording] = []
    foreign: dict[str, list[tuple[Path, Recording]]] = {}
    skipped: list[Skip] = []
    files, notes = listed(path)
    for number, file in enumerate(files):
        label = file.relative_to(path).as_posix()
        if progress is not None:
            progress(label, number, len(files))
        if recordings.samples_beside(file):
            continue
        try:
            form = format_of(file, reading)
            if form is None:
                notes.append(f"{label} fits no recording format")
            elif form.key in OWN:
                own.append(_labelled(_read(form, file, reading), label))
            else:
                recording = _read(form, file, reading)
                foreign.setdefault(form.key, []).append((file, recording))
        except ColumnsError as error:
            notes.append(f"{label} is not read: {error}")
        except (RecordingError, MissingExtraError) as error:
            skipped.append(Skip(label, str(error)))
    found = _distinct(own + [_joined(parts) for parts in foreign.values()])
    if not found:
        reasons = [skip.reason for skip in skipped] + notes
        raise RecordingError("; ".join([f"{path}: no recording among {len(files)} files", *reasons[:3]]))
    found[0] = msgspec.structs.replace(
        found[0], skipped=(*found[0].skipped, *skipped), notes=(*found[0].notes, *notes)
    )
    return found


def _labelled(recording: Recording, label: str) -> Recording:
    """The recording with the file's name in front of each note."""
    return msgspec.structs.replace(recording, notes=tuple(f"{label}: {note}" for note in recording.notes))


def _distinct(found: list[Recording]) -> list[Recording]:
    """The recordings with a number added to a name that has been taken."""
    taken: dict[str, Recording] = {}
    for recording in found:
        name, count = recording.name, 1
        while name in taken:
            count += 1
            name = f"{recording.name}_{count}"
        taken[name] = msgspec.structs.replace(recording, name=name)
    return list(taken.values())


def _joined(parts: list[tuple[Path, Recording]]) -> Recording:
    """The recordings of one foreign format as one, named after the folder that holds them all."""
    if len(parts) == 1:
        file, part = parts[0]
        return _labelled(part, file.name)
    folder = Path(commonpath([file.absolute().parent for file, _ in parts]))
    labels = [file.absolute().relative_to(folder).as_posix() for file, _ in parts]
    return join(folder.name, [part for _, part in parts], labels)
