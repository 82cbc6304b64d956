"""The folder of a study: the links, and for each participant who agreed what they did, saved as it goes.

```
pointing/links.json          the secret link of each participant
pointing/design.toml         the design, from the first consent on
pointing/P01/participant.json    consent, device, screen, browser, answers
pointing/P01/P01-1_samples.csv   the movements, in pointpred's own format; another number after each restart
pointing/P01/P01-mouse-1_samples.csv   what the mouse itself sent, where ``study run`` read it
```
"""

from __future__ import annotations

import csv
import os
import secrets
import shutil
import threading
from collections.abc import Iterator
from datetime import UTC, datetime
from functools import cached_property
from itertools import count
from pathlib import Path
from typing import Any, Protocol, TypeVar

import msgspec
import numpy as np
from msgspec import Struct

from pointpred.errors import ParameterError, SourceError
from pointpred.files import whole
from pointpred.recorder.files import SessionFiles, sample_rows, trial_row
from pointpred.recorder.recordings import prepare
from pointpred.recorder.writer import about_of
from pointpred.recording import Provenance
from pointpred.records import FloatArray
from pointpred.studies.design import Design, read_design
from pointpred.studies.messages import Agreed, Answered, Message, Moved, PageAbout
from pointpred.studies.plan import Sequence, plan_of

Kind = TypeVar("Kind")
FORMAT = "pointpred study"
CLOCK = "seconds of the browser's clock"
MOST_ATTEMPTS = 20
"""Where movements are repeated: after so many the next one follows."""
MOST_PAGES = 1000
"""Opened pages that are noted of a participant."""
DESIGN, LINKS, ABOUT = "design.toml", "links.json", "participant.json"


class ConflictError(ParameterError):
    """What a page sent does not follow what is stored: another page goes on with the study."""

    code = "out_of_place"


class OpenedPage(Struct, frozen=True):
    """When a page was opened, and what it told."""

    at: str
    page: PageAbout


class About(Struct):
    """What is known of a participant beside the movements; times are UTC."""

    participant: str
    study: str
    consent: str
    """The text they agreed to."""
    agreed_at: str
    pages: list[OpenedPage] = []
    answers: dict[str, str] = {}
    answered_at: dict[str, str] = {}


class Done(Struct, frozen=True):
    """A stored movement: its place in the plan, counted from 1, and how it ended."""

    sequence: int
    movement: int
    attempt: int
    hit: int
    started_s: float


class Study:
    """A design and the folder of its data. Raises ParameterError where the two do not belong together."""

    def __init__(self, file: Path, folder: Path | None = None) -> None:
        self.design = read_design(file)
        self.text = file.read_text(encoding="utf-8")
        self.folder = file.with_suffix("") if folder is None else folder
        self._lock = threading.Lock()
        if self.folder.exists() and not self.folder.is_dir():
            raise ParameterError(f"{self.folder} is no folder; name another with --folder")
        kept = self.folder / DESIGN
        if kept.exists():
            self._check_same(file, read_design(kept), kept)
        known = set(self.design.codes)
        for about in sorted(self.folder.glob(f"P*/{ABOUT}")):
            if about.parent.name not in known:
                raise ParameterError(
                    f"{file}: participants: {about.parent.name} has taken part, and is not among "
                    f"{self.design.participants}; raise it again, or delete {about.parent}"
                )

    def _check_same(self, file: Path, kept: Design, place: Path) -> None:
        """Only the number of participants may differ once somebody has taken part, and only grow."""
        for field in Design.__struct_fields__:
            before, now = getattr(kept, field), getattr(self.design, field)
            if before == now or (field == "participants" and now > before):
                continue
            raise ParameterError(
                f"{file}: {field} has changed since the first participant began ({place} keeps what it was); "
                "change it back, or keep the data of another design in another --folder"
            )

    @cached_property
    def participants(self) -> dict[str, Participant]:
        """By their codes."""
        codes = self.design.codes
        return {code: Participant(self, code, index) for index, code in enumerate(codes)}

    def chosen(self, code: str) -> Participant:
        """The participant of a code; raises ParameterError."""
        if (one := self.participants.get(code)) is None:
            codes = self.design.codes
            raise ParameterError(f"no participant {code!r}; they are {codes[0]} to {codes[-1]}")
        return one

    def links(self) -> dict[str, str]:
        """The secret link of each participant; made where there is none."""
        with self._lock:
            place, codes = self.folder / LINKS, self.design.codes
            known = _read(place, dict[str, str]) if place.exists() else {}
            links = known | {code: secrets.token_urlsafe(16) for code in codes if code not in known}
            if links != known:
                prepare(self.folder)
                self._write_links(links)
            return {code: links[code] for code in codes}

    def _write_links(self, links: dict[str, str]) -> None:
        _write(self.folder / LINKS, msgspec.json.format(msgspec.json.encode(links), indent=2))

    def find(self, link: str) -> Participant | None:
        """Whose link this is."""
        found = [
            code for code, one in self.links().items() if secrets.compare_digest(one.encode(), link.encode())
        ]
        return self.participants[found[0]] if found else None

    def keep_design(self) -> None:
        """Write the design beside the data, unless it is there."""
        with self._lock:
            if not (kept := self.folder / DESIGN).exists():
                _write(kept, self.text.encode())

    def close(self) -> None:
        """Close the files of all participants."""
        for one in self.participants.values():
            one.close()

    def delete(self, code: str) -> int:
        """Delete all that is kept of a participant, whose link ends to work; returns how many files."""
        one = self.chosen(code)
        self._write_links(self.links() | {code: secrets.token_urlsafe(16)})
        files = [path for path in one.folder.rglob("*") if path.is_file()] if one.folder.exists() else []
        if one.folder.exists():
            shutil.rmtree(one.folder)
        return len(files)


class Mouse(Protocol):
    """What a mouse sends while a participant moves it."""

    origin: Provenance

    def between(self, begin: float, end: float, epoch: float) -> FloatArray:
        """Its events from ``begin`` to ``end`` of a page's clock, which began at ``epoch``, s since 1970.

        Their times are those of the page's clock.
        """


class Participant:
    """One participant: nothing is written before ``Agreed``. Safe for threads."""

    def __init__(self, study: Study, code: str, index: int) -> None:
        self.study = study
        self.code = code
        self.folder = study.folder / code
        self.mouse: Mouse | None = None
        """The participant's mouse, where it is attached to this machine and is recorded as well."""
        self._index = index
        self._files: dict[str, SessionFiles] = {}
        self._lock = threading.Lock()

    @cached_property
    def plan(self) -> list[Sequence]:
        """The sequences of movements."""
        return plan_of(self.study.design, self._index)

    @property
    def about(self) -> About | None:
        """What is known of the participant, ``None`` before the consent."""
        try:
            return _read(self.folder / ABOUT, About)
        except FileNotFoundError:
            return None

    def done(self) -> list[Done]:
        """Every movement that is stored whole, in order."""
        return [done for _, part in self.parts(self.code) for done in part]

    def parts(self, stem: str) -> list[tuple[Path, list[Done]]]:
        """Each file of samples with its whole movements, in the order in which they were made.

        ``stem``: the participant's code, with ``-mouse`` what the mouse itself sent.
        """
        names = [f"{stem}-{n}" for n in range(1, self._free(stem))]
        return [
            (self.folder / f"{name}_samples.csv", list(_read_done(trials)))
            for name in names
            if (trials := self.folder / f"{name}_trials.csv").exists()
        ]

    def next(self, done: list[Done]) -> tuple[int, int] | None:
        """The sequence and the movement in it that come now, both from 1; ``None`` at the end."""
        if not done:
            return 1, 1
        last = done[-1]
        again = self.study.design.on_error == "repeat" and not last.hit and last.attempt < MOST_ATTEMPTS
        if again:
            return last.sequence, last.movement
        if last.movement < self.plan[last.sequence - 1].movements:
            return last.sequence, last.movement + 1
        return (last.sequence + 1, 1) if last.sequence < len(self.plan) else None

    def waiting(self) -> list[str]:
        """Which questions are unanswered: ``before``, ``after``."""
        about = self.about
        asked = {question.when for question in self.study.design.questions}
        answered = about.answered_at if about else {}
        return [when for when in ("before", "after") if when in asked and when not in answered]

    def state(self) -> dict[str, Any]:
        """How far the participant is, for the page."""
        about, done = self.about, self.done()
        return {
            "agreed": about is not None,
            "questions": self.waiting(),
            "stored": len(done),
            "next": self.next(done),
        }

    def take(self, message: Message) -> None:
        """Store what a page sent; raises ParameterError, ConflictError, SourceError where a disk refuses."""
        with self._lock:
            try:
                if isinstance(message, Agreed):
                    self._agree(message.page)
                elif (about := self.about) is None:
                    raise ConflictError("nothing is stored before the participant has agreed")
                elif isinstance(message, Moved):
                    self._add(message)
                elif isinstance(message, Answered):
                    self._answer(about, message)
                elif len(about.pages) < MOST_PAGES:
                    about.pages.append(OpenedPage(_now(), message.page))
                    self._write(about)
            except OSError as error:
                self._close()
                raise SourceError(f"{self.folder}: cannot be written: {error.strerror}") from error

    def close(self) -> None:
        """Close the files."""
        with self._lock:
            self._close()

    def _free(self, stem: str) -> int:
        def taken(n: int) -> bool:
            return any((self.folder / f"{stem}-{n}_{part}.csv").exists() for part in ("samples", "trials"))

        return next(n for n in count(1) if not taken(n))

    def _agree(self, page: PageAbout) -> None:
        if self.about is not None:
            return
        design = self.study.design
        prepare(self.folder)
        self.study.keep_design()
        at = _now()
        self._write(About(self.code, design.name, design.consent, at, [OpenedPage(at, page)]))

    def _answer(self, about: About, message: Answered) -> None:
        asked = {one.name: one for one in self.study.design.questions if one.when == message.when}
        if unknown := message.answers.keys() - asked.keys():
            raise ParameterError(f"no question {sorted(unknown)[0]!r} is asked {message.when} the task")
        for name, question in asked.items():
            if reason := question.refuse(message.answers.get(name, "").strip()):
                raise ParameterError(f"{question.text} {reason}", field=name)
        about.answers |= {name: message.answers.get(name, "").strip() for name in asked}
        about.answered_at[message.when] = _now()
        self._write(about)

    def _write(self, about: About) -> None:
        _write(self.folder / ABOUT, msgspec.json.format(msgspec.json.encode(about), indent=2))

    def _add(self, moved: Moved) -> None:
        """Append a movement, unless it is there already: then a page did not hear that it is."""
        done = self.done()
        if moved.number < len(done) and done[moved.number].started_s == moved.start[0]:
            return
        following = self.next(done)
        if moved.number != len(done) or following is None:
            raise ConflictError(
                f"{len(done)} movements are stored, and this one has the number {moved.number}, counted "
                "from 0: the study goes on in another page"
            )
        table = np.array([[np.nan if v is None else v for v in row] for row in moved.rows])
        if (np.diff(table[:, 0], prepend=moved.start[0]) < 0).any():
            raise ParameterError("the times of a movement must not run backwards", field="rows")
        conditions = conditions_of(self, moved, following, attempt_of(done, following))
        name = f"{moved.number + 1:04}"
        if self.mouse is not None:
            sent = self.mouse.between(moved.start[0], moved.rows[-1][0], moved.at - moved.start[0])
            if len(sent):
                self._append(f"{self.code}-mouse", self.mouse.origin, name, sent, None, conditions)
        target = self.target_of(following, moved.centre)
        self._append(self.code, Provenance(FORMAT, clock=CLOCK), name, table, target, conditions)

    def _append(
        self,
        stem: str,
        origin: Provenance,
        name: str,
        table: FloatArray,
        target: tuple[float, float, float] | None,
        conditions: dict[str, str | float],
    ) -> None:
        """Append a trial to the files of this process: samples first, so that one with a row is whole.

        Others follow where another process has begun files since, as the order of files is that of trials,
        and where ours were deleted.
        """
        free = self._free(stem)
        files = self._files.get(stem)
        if files is None or files.name != f"{stem}-{free - 1}":
            if files is not None:
                files.close()
            files = SessionFiles(self.folder, f"{stem}-{free}", about_of(origin, datetime.now(UTC)))
            self._files[stem] = files
            files.conditions = conditions
        files.append("samples", sample_rows(self.code, [(name, len(table))], table))
        files.sync()
        files.append("trials", trial_row(self.code, name, target, len(table), list(conditions.values())))
        files.sync()

    def target_of(
        self, following: tuple[int, int], centre: tuple[float, float]
    ) -> tuple[float, float, float]:
        """Centre and width of the target of a movement, px of the picture."""
        sequence = self.plan[following[0] - 1]
        x, y = sequence.places[following[1] % len(sequence.places)]
        return centre[0] + x, centre[1] + y, sequence.width

    def _close(self) -> None:
        opened, self._files = self._files, {}
        for files in opened.values():
            files.close()
            samples = files.path_of("samples")
            if samples.exists() and not samples.stat().st_size:  # the disk was full: there will be others
                samples.unlink()


def conditions_of(
    participant: Participant, moved: Moved, following: tuple[int, int], attempt: int
) -> dict[str, str | float]:
    """What a movement was, by the names of columns."""
    sequence = participant.plan[following[0] - 1]
    x, y = sequence.places[(following[1] - 1) % len(sequence.places)]
    return {
        "phase": sequence.phase,
        "block": sequence.block,
        "sequence": following[0],
        "movement": following[1],
        "attempt": attempt,
        "task": sequence.task,
        "distance_px": sequence.distance,
        "width_px": sequence.width,
        "from_x": moved.centre[0] + x,
        "from_y": moved.centre[1] + y,
        "hit": int(moved.hit),
        "clicks": moved.clicks,
        "started_s": moved.start[0],
        "start_x": moved.start[1],
        "start_y": moved.start[2],
        "started_at_s": moved.at,
        "lost_samples": moved.lost,
    }


def attempt_of(done: list[Done], following: tuple[int, int] | None) -> int:
    """Which attempt at a movement comes now, from 1."""
    last = done[-1] if done else None
    again = last is not None and (last.sequence, last.movement) == following
    return last.attempt + 1 if last is not None and again else 1


def _read(path: Path, kind: type[Kind]) -> Kind:
    """A file of JSON; raises SourceError where it is damaged."""
    try:
        return msgspec.json.decode(path.read_bytes(), type=kind)
    except msgspec.DecodeError as error:
        raise SourceError(f"{path}: damaged: {error}") from error


def _write(path: Path, content: bytes) -> None:
    """Write a file whole, so that it survives a loss of power."""
    with whole(path) as stream:
        stream.write(content)
        stream.flush()
        os.fsync(stream.fileno())


def _read_done(file: Path) -> Iterator[Done]:
    """The whole lines of a table of trials, which may end in the middle of one."""
    text = file.read_text(encoding="utf-8")
    lines = text[: text.rfind("\n") + 1].splitlines()
    for row in csv.DictReader(lines[1:]):  # below the header
        whole = {name: row[name] for name in Done.__struct_fields__}
        yield msgspec.convert(whole, Done, strict=False)


def _now() -> str:
    return datetime.now(UTC).isoformat(timespec="seconds")
