"""A study as one recording of all participants, with a table of them, and how far each one is."""

from __future__ import annotations

import csv
import io
from pathlib import Path
from typing import Literal

from msgspec import Struct

from pointpred.files import write_whole
from pointpred.recording import IN_MEMORY, Recording, Skip, Trial
from pointpred.recordings import read, write
from pointpred.recordings.own import SAMPLES
from pointpred.records import EventColumns
from pointpred.studies.folder import Participant, Study

State = Literal["not begun", "under way", "done"]


class Progress(Struct, frozen=True):
    """How far a participant is: ``movements`` of ``planned``. ``missed`` counts every attempt."""

    participant: str
    state: State
    link: str
    movements: int = 0
    planned: int = 0
    missed: int = 0
    agreed_at: str | None = None
    pages: int = 0


def status(study: Study) -> list[Progress]:
    """How far everybody is."""
    links = study.links()
    return [_progress(one, links[code]) for code, one in study.participants.items()]


def _progress(one: Participant, link: str) -> Progress:
    planned = sum(sequence.movements for sequence in one.plan)
    if (about := one.about) is None:
        return Progress(one.code, "not begun", link, planned=planned)
    done = one.done()
    ended = one.next(done) is None and not one.waiting()
    return Progress(
        one.code,
        "done" if ended else "under way",
        link,
        len({(movement.sequence, movement.movement) for movement in done}),
        planned,
        sum(not movement.hit for movement in done),
        about.agreed_at,
        len(about.pages),
    )


def export(study: Study, out: Path) -> list[tuple[Recording, Path]]:
    """Write the recording of all participants, that of their mice where there is one, and a table of them.

    ``out`` names the samples file of the first, the others lie beside it. Returns each with its file.
    Raises RecordingError.
    """
    sets = [(joined(study), out)]
    if (mice := joined(study, "-mouse")).trials:
        sets.append((mice, mice_beside(out)))
    write_whole(table_beside(out), participants_table(study).encode())
    return [(one, write(one, place)[0]) for one, place in sets]


def mice_beside(out: Path) -> Path:
    """Where the recording of the mice lies.

    >>> mice_beside(Path("pointing_samples.csv")).name
    'pointing-mouse.csv'
    """
    return out.with_name(f"{out.stem.removesuffix(SAMPLES)}-mouse{out.suffix}")


def table_beside(out: Path) -> Path:
    """Where the table of participants lies.

    >>> table_beside(Path("pointing.csv")).name
    'pointing_participants.csv'
    """
    return out.with_name(f"{out.stem.removesuffix(SAMPLES)}_participants.csv")


def joined(study: Study, what: str = "") -> Recording:
    """All that is stored as one recording, a user each participant; ``-mouse``: what their mice sent.

    A movement is there once, whether its page sent it again or it was cut off by a crash and made again.
    """
    parts: dict[tuple[str, str], EventColumns] = {}
    trials: list[Trial] = []
    skipped: list[Skip] = []
    provenance = IN_MEMORY
    for one in study.participants.values():
        for file, done in one.parts(f"{one.code}{what}"):
            if not done:
                continue
            recording = read(file)
            provenance = recording.provenance
            skipped += recording.skipped
            for i, trial in enumerate(recording.trials):
                if (trial.user, trial.trial) not in parts:
                    parts[trial.user, trial.trial] = recording.rows(i)
                    trials.append(trial)
    left = [skip for skip in skipped if (skip.user, skip.trial) not in parts]
    return Recording.of(f"{study.design.name}{what}", list(parts.values()), trials, left, provenance)


def participants_table(study: Study) -> str:
    """A row a participant who agreed: consent, progress, the newest page's device and screen, the answers."""
    questions = [question.name for question in study.design.questions]
    columns = (
        *("user", "agreed_at", "state", "movements", "missed", "pages"),
        *("browser", "language", "pointer", "screen_w", "screen_h", "window_w", "window_h"),
        *("pixel_ratio", "frame_ms", "clock_step_ms"),
    )
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow([*columns, *(f"answer_{name}" for name in questions)])
    for code, one in study.participants.items():
        if (about := one.about) is None:
            continue
        done, page = _progress(one, ""), about.pages[-1].page
        seen = (*page.screen, *page.window, page.pixel_ratio, page.frame_ms, page.clock_step_ms)
        writer.writerow(
            [
                *(code, about.agreed_at, done.state, done.movements, done.missed, done.pages),
                *(page.browser, page.language, page.pointer, *seen),
                *(about.answers.get(name, "") for name in questions),
            ]
        )
    return out.getvalue()
