"""Scoring in chunks: the same document bit for bit, whoever does the work and whatever becomes of it."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest

from evidence.costs.scale import write_in_parts
from pointpred.datasets import sample
from pointpred.errors import ParameterError, RecordingError
from pointpred.files import beside
from pointpred.predictors.kinematic import coefficient_file
from pointpred.recording import Recording, Skip
from pointpred.recordings import StoredRecording, read, write
from pointpred.recordings.stored import stored
from pointpred.scoring import chunks as batch
from pointpred.scoring import score, summarise
from pointpred.scoring.checkpoints import FolderStore
from pointpred.scoring.chunks import ScoredSet, score_in_chunks
from pointpred.scoring.executors import Executor, open_executor
from pointpred.scoring.scorer import scoring_with

NAMES = ["switched", "minimum-jerk"]


@pytest.fixture(scope="module")
def short() -> Recording:
    """Trials of four simulated people, with one that cannot be scored and one that was left out."""
    whole = sample().part(0, 96)
    table = whole.events.table.copy()
    table[whole.offsets[5] : whole.offsets[6], 1:3] = 7.0
    table[whole.offsets[5] + 4, 1] = 8.0
    events = type(whole.events)(table, whole.events.begin)
    return msgspec.structs.replace(
        whole, name="short", events=events, skipped=(Skip("99", "a dog passed"),), notes=("mended",)
    )


@pytest.fixture(autouse=True)
def small_chunks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(batch, "CHUNK_EVENTS", 12_000)


@pytest.fixture
def file(short: Recording, tmp_path: Path) -> StoredRecording:
    """The same in a file, whose row groups are no chunks."""
    parts = [short.part(first, min(first + 7, 96)) for first in range(0, 96, 7)]
    parts[0] = msgspec.structs.replace(parts[0], skipped=short.skipped, notes=short.notes)
    one = stored(*write_in_parts(parts, tmp_path / "short.parquet"), rows_least=0)
    assert one is not None
    return one


def document(scored: ScoredSet) -> bytes:
    return msgspec.json.encode(scored.summary())


class Backwards:
    """An executor that does the last item first."""

    workers = inner_threads = 1

    def each(self, function: Any, items: Any) -> Iterator[tuple[int, Any]]:
        for place, item in reversed(list(enumerate(items))):
            yield place, function(item)


class Forgetful:
    """An executor after which one file of a kind is gone from a folder."""

    workers = inner_threads = 1

    def __init__(self, folder: Path, kind: str) -> None:
        self._folder, self._kind = folder, kind

    def each(self, function: Any, items: Any) -> Iterator[tuple[int, Any]]:
        yield from enumerate(map(function, items))
        for path in self._folder.rglob(f"{self._kind}-000001.*"):
            path.unlink()


@pytest.mark.parametrize("kind", ["durations", "scores"])
def test_a_checkpoint_that_is_lost_on_the_way_is_an_error(
    short: Recording, tmp_path: Path, kind: str
) -> None:
    with pytest.raises(ParameterError, match="checkpoint 1 can no longer be read"):
        score_in_chunks(short, scoring_with(["kinematic"]), Forgetful(tmp_path, kind), checkpoints=tmp_path)


@pytest.mark.parametrize("where", ["", "user == p02"])  # there are chunks of which no trial counts
def test_chunks_are_those_of_the_whole_in_every_bit(short: Recording, where: str) -> None:
    with open_executor(threads=2) as executor:
        scored = score_in_chunks(short, scoring_with(NAMES, where=where), executor)
    (whole,) = score([short], NAMES, where=where)
    assert len(scored.chunks) > 5
    assert scored.about.skipped == whole.skipped
    assert len(whole.skipped) == 2
    untimed = [msgspec.structs.replace(one, us_per_event=None) for one in summarise(whole).predictors]
    ours = [msgspec.structs.replace(one, us_per_event=None) for one in scored.summary().predictors]
    assert msgspec.json.encode(ours) == msgspec.json.encode(untimed)
    joined = scored.joined(worst=3)
    for mine, theirs in zip(joined.predictors, whole.predictors, strict=True):
        assert np.array_equal(mine.by_time, theirs.by_time)
    (drawn,) = score([short], NAMES, worst=3, where=where)
    assert joined.worst is not None
    assert drawn.worst is not None
    for one, other in zip(joined.worst.trials, drawn.worst.trials, strict=True):
        assert (one.trial, one.error_px) == (other.trial, other.error_px)
        assert np.array_equal(one.answers.table, other.answers.table, equal_nan=True)


LOCAL: list[dict[str, Any]] = [{"threads": 1}, {"threads": 3}]
REMOTE: list[dict[str, Any]] = [{"processes": 2}, {"cluster": "local"}]


@pytest.mark.parametrize(("names", "ways"), [(NAMES, LOCAL + REMOTE), (["ktm"], LOCAL)], ids=str)
def test_every_executor_gives_the_same_bytes(
    names: list[str],
    ways: list[dict[str, Any]],
    short: Recording,
    file: StoredRecording,
    tmp_path: Path,
) -> None:
    scoring = scoring_with(names, seed=5)
    documents = {document(score_in_chunks(short, scoring, Backwards(), checkpoints=tmp_path / "backwards"))}
    for place, way in enumerate(ways):
        with open_executor(**way) as executor:
            sources = (short, file) if way in LOCAL else (file,)
            for k, source in enumerate(sources):
                folder = tmp_path / f"{place}-{k}"
                documents.add(document(score_in_chunks(source, scoring, executor, checkpoints=folder)))
    assert len(documents) == 1


def test_a_stored_recording_is_read_as_the_whole_file_is(file: StoredRecording) -> None:
    whole = read(file.samples)
    for by_person in (False, True):
        parts = [part.read() for part in file.parts(12_000, by_person=by_person)]
        assert len(parts) > 3
        assert np.array_equal(
            np.concatenate([part.events.table for part in parts]), whole.events.table, equal_nan=True
        )
        assert sum((part.trials for part in parts), ()) == whole.trials
        assert (file.about.notes, file.about.skipped) == (whole.notes, whole.skipped)
    people = [{trial.user for trial in part.read().trials} for part in file.parts(12_000, by_person=True)]
    assert sum(map(len, people)) == len(set().union(*people))


def test_other_files_are_read_as_a_whole(short: Recording, tmp_path: Path) -> None:
    samples, trials = write(short, tmp_path / "short.parquet")
    assert stored(samples, trials) is None  # not long
    assert stored(samples, None, rows_least=0) is None
    other = msgspec.structs.replace(short, trials=short.trials[::-1])
    _, reversed_trials = write(other, tmp_path / "other.parquet")
    assert stored(samples, reversed_trials, rows_least=0) is None
    samples.write_bytes(samples.read_bytes()[:-30])
    assert stored(samples, trials, rows_least=0) is None


def test_people_who_alternate_cannot_be_learned_from_a_long_file(short: Recording, tmp_path: Path) -> None:
    order = [*range(10), *range(30, 40), *range(10, 20)]
    mixed = Recording.of(
        "mixed", [short.rows(k) for k in order], [short.trials[k] for k in order], provenance=short.provenance
    )
    one = stored(*write(mixed, tmp_path / "mixed.parquet"), rows_least=0)
    assert one is not None
    with open_executor(threads=1) as executor:
        assert len(score_in_chunks(one, scoring_with([]), executor).joined().trials) > 25
        with pytest.raises(RecordingError, match="sort it by user"):
            score_in_chunks(one, scoring_with(["ktm"]), executor)
        together = score_in_chunks(mixed, scoring_with(["ktm"]), executor)
    assert len(together.chunks) == 1


class Counting:
    """An executor that counts what it is asked to do."""

    workers = inner_threads = 1

    def __init__(self, executor: Executor) -> None:
        self.executor, self.asked = executor, 0

    def each(self, function: Any, items: Any) -> Iterator[tuple[int, Any]]:
        listed = list(items)
        self.asked += len(listed)
        return self.executor.each(function, listed)


def test_what_is_there_is_not_done_again_unless_something_differs(
    short: Recording, file: StoredRecording, tmp_path: Path
) -> None:
    with open_executor(threads=1) as executor:

        def asked(source: Recording | StoredRecording, **settings: Any) -> int:
            counting = Counting(executor)
            score_in_chunks(source, scoring_with(NAMES, **settings), counting, checkpoints=tmp_path / "done")
            return counting.asked

        chunks = len(batch.plan(short, {}))
        assert asked(short) == 2 * chunks  # durations, then scores
        assert asked(short) == 0
        assert asked(short, seed=7) == 0  # the bootstrap's only
        assert asked(short, cpi=800.0) == 2 * chunks
        assert asked(msgspec.structs.replace(short, trials=short.trials[::-1])) == 2 * chunks
        for one in (tmp_path / "done").rglob("scores-000002.*"):
            one.write_bytes(one.read_bytes()[:-7])
        assert asked(short) == 1
        assert asked(short) == 0
        assert asked(file) > 0
        assert asked(file) == 0


def test_coefficients_written_anew_in_place_are_scored_anew(short: Recording, tmp_path: Path) -> None:
    with np.load(coefficient_file.OWN) as own:
        arrays = {name: np.asarray(own[name]) for name in own.files}
    path = tmp_path / "me.npz"

    def scored(seconds: int, folder: str, **changes: Any) -> bytes:
        np.savez(path, **(arrays | changes))
        os.utime(path, (seconds, seconds))
        scoring = scoring_with(["kinematic"], parameters={"kinematic": {"coefficients": path}})
        with open_executor(threads=1) as executor:
            return document(score_in_chunks(short, scoring, executor, checkpoints=tmp_path / folder))

    before = scored(1, "kept")
    after = scored(2, "kept", mean=arrays["mean"] + 1.0)
    assert after != before
    assert after == scored(3, "fresh", mean=arrays["mean"] + 1.0)


@pytest.mark.parametrize("kind", ["durations", "scores"])
def test_a_checkpoint_with_a_wrong_byte_counts_as_missing(
    kind: str, short: Recording, tmp_path: Path
) -> None:
    with open_executor(threads=1) as executor:
        scored = score_in_chunks(short, scoring_with(NAMES), executor, checkpoints=tmp_path)
        whole, files = document(scored), len(list(tmp_path.rglob("*.*")))
        (one,) = tmp_path.rglob(f"{kind}-000001.*")
        damaged = bytearray(one.read_bytes())
        damaged[len(damaged) // 2] ^= 0x10
        one.write_bytes(damaged)
        if kind == "scores":
            with pytest.raises(ParameterError, match="score once more"):
                scored.store.part(1)
        counting = Counting(executor)
        assert document(score_in_chunks(short, scoring_with(NAMES), counting, checkpoints=tmp_path)) == whole
    assert counting.asked == 1
    assert len(list(tmp_path.rglob("*.*"))) == files


def test_progress_begins_with_what_was_done_and_ends_with_all(short: Recording, tmp_path: Path) -> None:
    seen: list[tuple[str, int, int]] = []
    with open_executor(threads=2) as executor:
        for _ in range(2):
            score_in_chunks(
                short,
                scoring_with(NAMES),
                executor,
                checkpoints=tmp_path,
                progress=lambda *one: seen.append(one),
            )
    total = len(short.events)
    assert {one[2] for one in seen} == {total}
    assert seen[0] == ("short: durations", 0, total)
    assert [done for name, done, _ in seen if name == "short"][-2:] == [total, total]
    assert seen[-1] == ("short", total, total)


def test_many_chunks_leave_memory_for_a_folder_that_goes_with_them(
    short: Recording, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(batch, "IN_MEMORY_CHUNKS", 2)
    with open_executor(threads=1) as executor:
        scored = score_in_chunks(short, scoring_with([]), executor)
    assert isinstance(scored.store, FolderStore)
    folder = scored.store.folder
    assert len(list(folder.glob("*.arrow"))) == len(scored.chunks)
    del scored
    assert not folder.exists()


def test_opening_a_folder_removes_what_a_killed_run_was_writing_and_nothing_younger(tmp_path: Path) -> None:
    """Another run may be writing into the same folder: what is younger than a day stays."""
    store = FolderStore(tmp_path)
    store.put_durations(1, np.array([0.5]))
    names = [beside(tmp_path / f"scores-00000{k}.0123.arrow", "part") for k in range(2)]
    for path in names:
        path.write_bytes(b"half")
    day_s = 24 * 3600
    for path, age_s in (
        (names[0], 1.1 * day_s),
        (names[1], 0.9 * day_s),
        (next(tmp_path.glob("d*")), 9 * day_s),
    ):
        now_s = path.stat().st_mtime
        os.utime(path, (now_s - age_s, now_s - age_s))
    durations = FolderStore(tmp_path).durations(1)
    assert durations is not None
    assert durations.tolist() == [0.5]
    assert [path.exists() for path in names] == [False, True]


def test_a_folder_that_cannot_be_written_is_said(short: Recording, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with open_executor(threads=1) as executor, pytest.raises(ParameterError, match="cannot keep checkpoints"):
        score_in_chunks(short, scoring_with([]), executor, checkpoints=tmp_path / "file")


COMMAND = (
    "import sys, pointpred.scoring.chunks as batch; batch.CHUNK_EVENTS = 12_000\n"
    "from pointpred.cli import main\n"
    "if __name__ == '__main__': main()\n"
)


@pytest.mark.slow
def test_killed_at_random_moments_it_goes_on_to_the_same_bytes(short: Recording, tmp_path: Path) -> None:
    samples, _ = write(short, tmp_path / "short.parquet")
    script = tmp_path / "run.py"
    script.write_text(COMMAND)

    def command(name: str) -> list[str]:
        arguments = [
            "score",
            samples,
            "--predictors",
            "minimum-jerk",
            "--threads",
            "2",
            "--json",
            tmp_path / f"{name}.json",
            "--force",
        ]
        return [sys.executable, str(script), *map(str, arguments), "--checkpoints", str(tmp_path / name)]

    start = time.monotonic()
    subprocess.run(command("whole"), check=True, capture_output=True)
    whole_s = time.monotonic() - start
    moments, kills = random.Random(4), 0
    for _ in range(2):
        process = subprocess.Popen(command("killed"), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            process.wait(moments.uniform(0.5, 0.95) * whole_s)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
            process.wait()
            kills += 1
    assert kills
    subprocess.run(command("killed"), check=True, capture_output=True)
    assert (tmp_path / "killed.json").read_bytes() == (tmp_path / "whole.json").read_bytes()


def test_killed_between_a_file_s_bytes_and_its_name_nothing_is_lost(short: Recording, tmp_path: Path) -> None:
    """The process ends itself after each checkpoint in turn, before the file takes its place."""
    script = tmp_path / "run.py"
    script.write_text(
        "import os, pathlib\n"
        "replace = pathlib.Path.replace\n"
        "def die(self, target):\n"
        "    done = len(list(target.parent.glob('*.arrow')))\n"
        "    if str(target).endswith('.arrow') and int(os.environ['LEFT']) == done:\n"
        "        os.kill(os.getpid(), 9)\n"
        "    return replace(self, target)\n"
        "pathlib.Path.replace = die\n" + COMMAND
    )
    samples, _ = write(short, tmp_path / "short.parquet")
    command = [sys.executable, str(script), "score", str(samples), "--predictors", "linear", "--threads", "1"]
    for left in (0, 2, 99):
        out = ["--json", str(tmp_path / "out.json"), "--checkpoints", str(tmp_path / "done")]
        done = subprocess.run([*command, *out], env={**os.environ, "LEFT": str(left)}, capture_output=True)
        files = list((tmp_path / "done").rglob("*.arrow"))
        assert done.returncode == (0 if left == 99 else -signal.SIGKILL)
        assert left == 99 or len(files) == left
    subprocess.run(
        [*command, "--json", str(tmp_path / "whole.json"), "--checkpoints", str(tmp_path / "new")],
        env={**os.environ, "LEFT": "99"},
        check=True,
        capture_output=True,
    )
    assert (tmp_path / "out.json").read_bytes() == (tmp_path / "whole.json").read_bytes()
