"""GoFitts ``.sd3`` traces: three lines a trial, ``t=`` in ms, ``x=`` and ``y=`` in px."""

from __future__ import annotations

from pathlib import Path

from pointpred.errors import RecordingError
from pointpred.recording import Provenance, Recording, Skip, Trial
from pointpred.recordings.encodings import read_text, stem_of
from pointpred.recordings.reading import AS_IS, Reading
from pointpred.recordings.trials import Lists

TITLE = "GoFitts .sd3"
FIRST = "TRACE DATA"
PREFIX = (
    "App,Participant,Condition,Session,Group,TaskType,SelectionMethod,Block,Sequence,A,W,Trial,from_x,from_y,"
    "to_x,to_y"
)
NAMES = PREFIX.split(",")
NUMBERS = ("to_x", "to_y", "W", "A", "from_x", "from_y")
WORDS = tuple(word for word in NAMES if word not in (*NUMBERS, "Participant"))


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` is a GoFitts trace."""
    return head.lstrip(b"\xef\xbb\xbf").startswith(FIRST.encode())


def read(path: Path, reading: Reading = AS_IS) -> Recording:
    """Read a trace; target centre and width are known, A, from and the other columns become conditions.

    A trial whose three lines do not match or differ in length is skipped; ``row`` is the line of its ``t=``,
    counted from the first below the header. Raises RecordingError.
    """
    lines = read_text(path).splitlines()
    if len(lines) < 2 or lines[0].strip() != FIRST or not lines[1].startswith(PREFIX):
        raise RecordingError(f"{path}: line 2 is not the header of a trace, expected {PREFIX},{{t_x_y}}")
    lists = Lists(reading.sort)
    rows = [(row, line.split(",")) for row, line in enumerate(lines[2:]) if line.strip()]
    at = 0
    while at < len(rows):
        row, cells = rows[at]
        key = cells[: len(NAMES)]
        three = [other for _, other in rows[at : at + 3]]
        letters = [other[len(NAMES)] if len(other) > len(NAMES) else "" for other in three]
        if letters != ["t=", "x=", "y="] or any(other[: len(NAMES)] != key for other in three):
            named = " ".join(key[7:12:4]) if len(key) > 11 else f"row {row}"
            lists.skip(Skip(named, "its lines t=, x= and y= do not follow each other", row))
            at += 1
            while at < len(rows) and rows[at][1][: len(NAMES)] == key:
                at += 1
            continue
        at += 3
        about = dict(zip(NAMES, key, strict=True))
        name = f"{about['Session']} {about['Block']} {about['Sequence']} {about['Trial']}"
        series = [[cell for cell in other[len(NAMES) + 1 :] if cell.strip()] for other in three]
        values = lists.numbers([about[word] for word in NUMBERS], name, row)
        if values is None:
            continue
        numbers = dict(zip(NUMBERS, values.tolist(), strict=True))
        condition: dict[str, str | float] = {word: about[word] for word in WORDS}
        condition |= {word: numbers[word] for word in ("A", "from_x", "from_y")}
        trial = Trial(
            about["Participant"],
            name,
            numbers["to_x"],
            numbers["to_y"],
            numbers["W"],
            condition=condition,
        )
        lists.add(trial, row, series[0], series[1], series[2], scale=0.001)
    provenance = Provenance("gofitts", clock="milliseconds from the trial's start", dpi=reading.dpi)
    return lists.recording(stem_of(path), provenance)
