"""Read recordings of any known format: a file, or every file in a folder."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from os.path import commonpath
from pathlib import Path
from typing import get_args

import msgspec

from pointpred.columns import Frame, is_frame
from pointpred.errors import ColumnsError, MissingExtraError, ParameterError, RecordingError
from pointpred.recording import Provenance, Recording, Skip
from pointpred.recordings.addresses import address_in, local_copy
from pointpred.recordings.encodings import encoding_of, head_of, stem_of, text_in
from pointpred.recordings.frames import file_of_frame, our_columns
from pointpred.recordings.known_formats import FORMATS, Format, advice_on, format_of
from pointpred.recordings.own import SAMPLES, is_samples, samples_beside, trials_beside
from pointpred.recordings.reading import AS_IS, People, Reading, TimeUnit
from pointpred.recordings.stored import StoredRecording, stored
from pointpred.recordings.trials import join, questions

Progress = Callable[[str, int, int], None]
OWN = ("recorder", "own")
"""Formats in which each file is a separate recording."""


def read_any(
    path: str | Path | Sequence[str | Path] | Frame,
    reading: Reading = AS_IS,
    progress: Progress | None = None,
    *,
    people: People | None = None,
    columns: Mapping[str, str | int] | None = None,
    time_unit: TimeUnit | None = None,
    y_up: bool | None = None,
    px_per_unit: float | tuple[float, float] | None = None,
) -> list[Recording]:
    """Read a recording of any known format, or every recording in a folder and the folders below it.

    ``path`` may be an address of fsspec, such as ``s3://bucket/study.csv``: it is copied here first. It may
    be a ``pandas.DataFrame``, which is read as a table in a file is.

    A file's format is detected from its content. In a folder each own recording stays one; files of one
    foreign format (sessions, users) become one recording named after the folder they share. A file of no
    format is named in a note, one that cannot be read is a skip named after it; an error is raised only if
    nothing can be read. ``progress`` is called before each file of a folder with its path, the number of
    files done, and their total. The keywords override the fields of ``reading``.

    Several paths, or ``people``, make one recording of all files, a person each: named after the "file"
    (unless said otherwise), its "folder", or the users in its "column". Conditions stay as they are; where a
    person has a trial's name twice, the file's goes before it. All files must have one dpi and one cpi.
    Returns at least one recording; raises RecordingError naming the formats that were tried, ColumnsError
    for a table whose columns are not certain, and ParameterError for a keyword out of its bounds.
    """
    if is_frame(path):
        with file_of_frame(path) as file:
            columns = columns or reading.columns or our_columns(path)
            return read_any(
                file, reading, progress, people=people, columns=columns,
                time_unit=time_unit, y_up=y_up, px_per_unit=px_per_unit,
            )  # fmt: skip
    paths = [_here(one) for one in ([path] if isinstance(path, str | Path) else path)]
    if people is None and not isinstance(path, str | Path):
        people = "file"
    if people not in (None, *get_args(People)):
        message = f"people must be file, folder or column, received {people!r}"
        raise ParameterError(message, field="people", value=people)
    unused = {
        "columns": None if columns is None else dict(columns),
        "time_unit": time_unit,
        "y_up": y_up,
        "px_per_unit": px_per_unit,
    }
    reading = msgspec.structs.replace(
        reading, **{name: value for name, value in unused.items() if value is not None}
    )
    with text_in(reading.encoding):
        if people is not None:
            parts = [_set(paths, people, reading, progress)]
        elif paths[0].is_dir():
            parts = _folder(paths[0], reading, progress)
        else:
            parts = [_file(paths[0], reading)]
    return [readable_recording(recording) for recording in parts]


def open_any(
    path: str | Path, reading: Reading = AS_IS, progress: Progress | None = None
) -> list[Recording | StoredRecording]:
    """As ``read_any``, but the trials of a long Parquet file that pointpred wrote stay in the file.

    Each person's and trial's rows must lie together there, and the trials file beside it must have the same
    order, as ``write`` does it; any other file is read into memory.
    """
    path = _here(path)
    plain = msgspec.structs.replace(reading, cpi=AS_IS.cpi, dpi=AS_IS.dpi) == AS_IS
    if plain and path.is_file() and path.suffix == ".parquet":
        one = stored(path, trials_beside(path))
        if one is not None:
            return [one]
    return list(read_any(path, reading, progress))


def _here(path: str | Path) -> Path:
    """A path, or the copy of what lies at an address."""
    address = address_in(path)
    return Path(path) if address is None else local_copy(address)


def _file(path: Path, reading: Reading) -> Recording:
    """The recording in one file."""
    with _guess_named(path):
        form = format_of(path, reading)
        if form is None:
            if advice := advice_on(head_of(path)):
                raise RecordingError(f"{path}: {advice}", code="unknown_format")
            tried = ", ".join(form.title for form in FORMATS)
            raise RecordingError(f"{path}: no known recording format; tried {tried}", code="unknown_format")
        return _read(form, path, reading)


@contextmanager
def _guess_named(path: Path) -> Iterator[None]:
    """Name the encoding of a file in a refusal of it, where that is a guess."""
    try:
        yield
    except RecordingError as error:
        with suppress(RecordingError, OSError):
            if path.is_file() and (guess := encoding_of(path).note):
                error.args = (f"{error}; {guess}; --encoding names another, such as gb18030",)
        raise


def _read(form: Format, path: Path, reading: Reading) -> Recording:
    """Read one file; a note names a ``cut`` that has no effect on its format."""
    recording = form.read(path, reading)
    if form.key not in OWN and not form.binary and (note := encoding_of(path).note):
        recording = msgspec.structs.replace(recording, notes=(note, *recording.notes))
    notes = [] if form.key == "own" else questions(recording)
    if reading.encoding is not None and form.binary:
        notes.append(f"encoding has no effect: {form.title} is no text")
    if reading.cut is not None and form.key == "own":
        notes.append(f"cut {reading.cut!r} has no effect: {form.title} has trials of its own")
    beside = trials_beside(path) if form.tabular and is_samples(path) else None
    if beside is not None:
        notes.append(f"{beside.name} is not read: with columns, the file is read as any table")
    if not form.tabular:
        said = ("columns", "y_up", "px_per_unit") + (() if form.key == "own" else ("time_unit",))
        notes += [
            f"{name} has no effect: {form.title} says it itself"
            for name in said
            if getattr(reading, name) not in (None, False) and name not in form.takes
        ]
    return msgspec.structs.replace(recording, notes=(*recording.notes, *notes)) if notes else recording


def _folder(path: Path, reading: Reading, progress: Progress | None) -> list[Recording]:
    """The recordings in a folder."""
    own: list[Recording] = []
    foreign: dict[str, list[tuple[Path, Recording]]] = {}
    skipped: list[Skip] = []
    files, notes = list_files(path)
    for number, file in enumerate(files):
        label = file.relative_to(path).as_posix()
        if progress is not None:
            progress(label, number, len(files))
        if samples_beside(file):
            continue
        try:
            with _guess_named(file):
                form = format_of(file, reading)
                recording = None if form is None else _read(form, file, reading)
            if form is None or recording is None:
                notes.append(f"{label} fits no recording format")
            elif form.key in OWN:
                own.append(_with_label(recording, label))
            else:
                foreign.setdefault(form.key, []).append((file, recording))
        except ColumnsError as error:
            notes.append(f"{label} is not read: {error}")
        except (RecordingError, MissingExtraError) as error:
            skipped.append(Skip(label, str(error)))
    parts = _with_distinct_names(own + [_join(parts) for parts in foreign.values()])
    if not parts:
        reasons = [skip.reason for skip in skipped] + notes
        raise RecordingError(
            "; ".join([f"{path}: no recording among {len(files)} files", *reasons[:3]]), code="no_recording"
        )
    parts[0] = msgspec.structs.replace(
        parts[0], skipped=(*parts[0].skipped, *skipped), notes=(*parts[0].notes, *notes)
    )
    return parts


def _with_label(recording: Recording, label: str) -> Recording:
    """The recording with each note prefixed by the file's name."""
    return msgspec.structs.replace(recording, notes=tuple(f"{label}: {note}" for note in recording.notes))


def _with_distinct_names(parts: list[Recording]) -> list[Recording]:
    """The recordings with a number added to repeated names."""
    taken: dict[str, Recording] = {}
    for recording in parts:
        name, count = recording.name, 1
        while name in taken:
            count += 1
            name = f"{recording.name}_{count}"
        taken[name] = msgspec.structs.replace(recording, name=name)
    return list(taken.values())


def _join(parts: list[tuple[Path, Recording]]) -> Recording:
    """The recordings of one foreign format as one, named after the folder that holds them all."""
    if len(parts) == 1:
        file, part = parts[0]
        return _with_label(part, file.name)
    folder = Path(commonpath([file.absolute().parent for file, _ in parts]))
    labels = [file.absolute().relative_to(folder).as_posix() for file, _ in parts]
    return join(folder.name, [part for _, part in parts], labels)


def _set(paths: Sequence[Path], people: People, reading: Reading, progress: Progress | None) -> Recording:
    """One recording of every file, in their order."""
    found: list[Path] = []
    notes: list[str] = []
    for path in paths:
        below, said = list_files(path) if path.is_dir() else ([path], [])
        found, notes = found + below, notes + said
    files = [file for file in dict.fromkeys(found) if not samples_beside(file)]
    if not files:
        raise RecordingError("no recording among no files", code="no_recording")
    folder = Path(commonpath([file.absolute().parent for file in files]))
    parts: dict[str, Recording] = {}
    skipped: list[Skip] = []
    for number, file in enumerate(files):
        label = file.absolute().relative_to(folder).as_posix()
        if progress is not None:
            progress(label, number, len(files))
        try:
            parts[label] = _file(file, reading)
        except (RecordingError, MissingExtraError) as error:
            if error.code == "unknown_format":
                notes.append(f"{label} fits no recording format")
            else:
                skipped.append(Skip(label, str(error)))
    if not parts:
        reasons = [skip.reason for skip in skipped] + notes
        raise RecordingError(
            "; ".join([f"{folder}: no recording among {len(files)} files", *reasons[:3]]), code="no_recording"
        )
    known, said = _with_people(parts, people, folder)
    joined = join(folder.name, known, list(parts), [*said, *notes], unique=True)
    return msgspec.structs.replace(joined, skipped=(*joined.skipped, *skipped), provenance=_provenance(parts))


def _with_people(
    parts: Mapping[str, Recording], people: People, folder: Path
) -> tuple[list[Recording], list[str]]:
    """The recordings with the person of each trial, whose trials have names of their own; and notes."""
    stems = {label: stem_of(folder / label).removesuffix(SAMPLES) for label in parts}
    often = Counter(stems.values())
    stems = {label: stem if often[stem] == 1 else label for label, stem in stems.items()}
    notes = []

    def person(label: str, user: str) -> str:
        if people == "file":
            return stems[label]
        return (folder / label).parent.name if people == "folder" else user

    for label, part in parts.items():
        users = {trial.user for trial in part.trials}
        if people != "column" and len(users) > 1:
            notes.append(f"{label}: its {len(users)} users count as one person, {person(label, '')}")
    given = [(label, trial) for label, part in parts.items() for trial in part.trials]
    twice = Counter((person(label, trial.user), trial.trial) for label, trial in given)
    again = Counter((person(label, trial.user), label, trial.trial) for label, trial in given)
    ambiguous = {who for (who, _), count in twice.items() if count > 1}

    def named(label: str, user: str, trial: str) -> str:
        who = person(label, user)
        if who not in ambiguous:
            return trial
        return " ".join([stems[label], *[user] * (again[who, label, trial] > 1), trial])

    replace = msgspec.structs.replace
    return [
        replace(
            part,
            trials=tuple(
                replace(one, user=person(label, one.user), trial=named(label, one.user, one.trial))
                for one in part.trials
            ),
            skipped=tuple(
                replace(
                    one,
                    user=None if people == "column" and one.user is None else person(label, one.user or ""),
                    trial=named(label, one.user or "", one.trial),
                )
                for one in part.skipped
            ),
        )
        for label, part in parts.items()
    ], notes


def _provenance(parts: Mapping[str, Recording]) -> Provenance:
    """That of all parts; raises RecordingError where they differ in what scoring needs of the whole set."""
    labels, all_said = list(parts), [msgspec.to_builtins(part.provenance) for part in parts.values()]
    whole = dict(all_said[0])
    for label, said in zip(labels[1:], all_said[1:], strict=True):
        for field, value in said.items():
            if field in ("dpi", "cpi", "simulated") and value != whole[field]:
                raise RecordingError(
                    f"{label}: {field} is {value}, that of {labels[0]} {whole[field]}: one set has one of "
                    "each; leave the others out, or say it with --cpi or --dpi"
                )
            if isinstance(value, str) and value not in whole[field].split(" and "):
                whole[field] = f"{whole[field]} and {value}"
    return Provenance(**whole)


def list_files(folder: Path) -> tuple[list[Path], list[str]]:
    """The files below a folder in the order of their paths, and notes on everything else.

    Hidden files are ignored. Links to folders are not followed, so that no file occurs twice.
    """
    files: list[Path] = []
    notes: list[str] = []

    def failed(error: OSError) -> None:
        notes.append(f"{_label(Path(error.filename), folder)} cannot be read: {error.strerror}")

    for place, below, names in os.walk(folder, onerror=failed):
        links = [name for name in below if Path(place, name).is_symlink()]
        notes += [
            f"{_label(Path(place, name), folder)} is a link to a folder: not followed" for name in links
        ]
        for path in (Path(place, name) for name in names if not name.startswith(".")):
            if path.is_file():
                files.append(path)
            else:
                what = "a link to nothing" if path.is_symlink() else "no file that can be read twice"
                notes.append(f"{_label(path, folder)} is {what}")
    return sorted(files), sorted(notes)


def _label(path: Path, folder: Path) -> str:
    return path.relative_to(folder).as_posix()


def readable(text: str) -> str:
    """A file's name as valid text; bytes that are not UTF-8 become replacement marks.

    >>> readable("study") == "study"
    True
    """
    return text.encode("utf-8", "surrogateescape").decode("utf-8", "replace")


def readable_recording(recording: Recording) -> Recording:
    """The recording with every name, reason and note ``readable``."""
    replace = msgspec.structs.replace
    return replace(
        recording,
        name=readable(recording.name),
        trials=tuple(
            replace(trial, user=readable(trial.user), trial=readable(trial.trial))
            for trial in recording.trials
        ),
        skipped=tuple(
            replace(
                skip,
                trial=readable(skip.trial),
                reason=readable(skip.reason),
                user=None if skip.user is None else readable(skip.user),
            )
            for skip in recording.skipped
        ),
        notes=tuple(map(readable, recording.notes)),
    )
