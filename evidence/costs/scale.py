"""Scoring at scale: ``python -m evidence costs scale``.

``rates``: events scored a second on one and two threads, two processes and a Dask cluster of two workers, in
turns within one run. ``million``: one million generated trials scored by the command line, killed on the way
and resumed, with peak memory. Without a name both, in about half an hour. The variable SCALE_FOLDER names a
folder that keeps the generated recordings, 1 GB, for another run; otherwise they are made and deleted.
"""

from __future__ import annotations

import os
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

from evidence.arguments import parse
from evidence.data import Table, keep
from evidence.machine import machine
from pointpred.datasets import sample
from pointpred.errors import RecordingError
from pointpred.recording import Provenance, Recording, Trial
from pointpred.recordings.arrow_tables import open_file
from pointpred.recordings.own import KEY, trials_beside
from pointpred.recordings.stored import StoredRecording, stored
from pointpred.recordings.writing import files_of, samples_table, trial_table, write_together
from pointpred.records import EventColumns
from pointpred.scoring.chunks import score_in_chunks
from pointpred.scoring.executors import open_executor
from pointpred.scoring.scorer import scoring_with


def write_in_parts(parts: Iterable[Recording], path: str | Path) -> tuple[Path, Path]:
    """Write a recording that comes in parts as a samples and a trials file, a row group of each a part.

    ``path`` as for ``write``, but Parquet only. Every part has other trials, the same name and provenance,
    and the same conditions; skips and notes of all are kept. Parts of about 65,536 events are best: they
    are what ``pointpred score`` reads at once. On a failure no file is left. Raises RecordingError.
    """
    samples, beside = files_of(path)
    if samples.suffix != ".parquet":
        raise RecordingError(f"{samples}: in parts only Parquet is written, expected .parquet")
    with write_together() as part:
        _write(parts, samples, part(samples), part(beside))
    return samples, beside


def _write(parts: Iterable[Recording], path: Path, samples: Path, trials: Path) -> None:
    writers: list[pq.ParquetWriter] = []
    about: dict[str, Any] = {}
    counts = [0, 0]
    skipped: list[list[Any]] = []
    notes: list[str] = []
    try:
        for recording in parts:
            rows, text = trial_table(recording)
            described = text | {"provenance": msgspec.to_builtins(recording.provenance)}
            tables = [samples_table(recording, rows, every=True), rows]
            if not writers:
                about = described
                writers = [
                    pq.ParquetWriter(
                        open_file(file, "wb"), table.schema, compression="zstd", write_page_checksum=True
                    )
                    for file, table in zip((samples, trials), tables, strict=True)
                ]
            if described != about or any(w.schema != t.schema for w, t in zip(writers, tables, strict=True)):
                message = (
                    f"{path}: a part has another name, provenance or other conditions than the first one"
                )
                raise RecordingError(message)
            for i, (writer, table) in enumerate(zip(writers, tables, strict=True)):
                writer.write_table(table, row_group_size=max(table.num_rows, 1))
                counts[i] += table.num_rows
            skipped += [[skip.trial, skip.reason, skip.row, skip.user] for skip in recording.skipped]
            notes += recording.notes
        if not writers:
            raise RecordingError(f"{path}: no part to write, expected at least one")
        more = {"provenance": about["provenance"], "skipped": skipped, "notes": notes}
        for writer, count, header in zip(writers, counts, (more, {}), strict=True):
            header = {"name": about["name"], "text": about["text"], **header, "version": 1, "rows": count}
            encoded = msgspec.json.encode(header, order="sorted")
            writer.add_key_value_metadata({KEY: encoded})
    except (OSError, pa.ArrowException) as error:
        raise RecordingError(f"{path}: cannot be written: {error}") from error
    finally:
        for writer in writers:
            writer.close()


PEOPLE_TRIALS = 1000
"""Trials of one person."""
PART_EVENTS = 65_536
SIZE, TEMPO = (0.5, 1.6), (0.7, 1.5)


def generate(folder: Path, trials: int, rate_hz: int, seed: int = 17) -> Path:
    """Write a recording of so many trials at 1000 / n Hz, and return its samples file."""
    name = f"generated_{trials}_{rate_hz}hz"
    samples, _ = write_in_parts(_parts(name, trials, rate_hz, seed), folder / f"{name}.parquet")
    return samples


def _parts(name: str, trials: int, rate_hz: int, seed: int) -> Iterator[Recording]:
    base = sample()
    thin = 1000 // rate_hz
    rows = [_thinned(base, k, thin) for k in range(len(base.trials))]
    lengths = np.array([len(one) for one in rows])
    table = base.events.table[np.concatenate(rows)]
    begins = np.concatenate([[0], np.cumsum(lengths)[:-1]])
    random = np.random.default_rng(seed)
    first = 0
    while first < trials:
        most = min(trials - first, PART_EVENTS // int(lengths.mean()))
        drawn = random.integers(0, len(rows), most)
        yield _part(name, table, begins[drawn], lengths[drawn], first, random)
        first += most


def _thinned(base: Recording, trial: int, thin: int) -> np.ndarray:
    """Every so many rows of a trial, and its last two: the click."""
    first, stop = int(base.offsets[trial]), int(base.offsets[trial + 1])
    rows: np.ndarray = np.unique(np.append(np.arange(first, stop, thin), [stop - 2, stop - 1]))
    return rows


def _part(
    name: str,
    table: np.ndarray,
    begins: np.ndarray,
    lengths: np.ndarray,
    first: int,
    random: np.random.Generator,
) -> Recording:
    """Successive trials, all at once."""
    count, offsets = len(begins), np.concatenate([[0], np.cumsum(lengths)])
    trial = np.repeat(np.arange(count), lengths)
    events = table[np.repeat(begins - offsets[:-1], lengths) + np.arange(offsets[-1])]
    start = events[offsets[:-1]][trial]
    angle, mirror = random.uniform(0.0, 2.0 * np.pi, count)[trial], random.choice([-1.0, 1.0], count)[trial]
    size = np.exp(random.uniform(*np.log(SIZE), count))[trial]
    tempo = np.exp(random.uniform(*np.log(TEMPO), count))[trial]
    x, y = size * (events[:, 1] - start[:, 1]), mirror * size * (events[:, 2] - start[:, 2])
    out = np.full((len(events), 6), np.nan)
    out[:, 0] = np.round(tempo * (events[:, 0] - start[:, 0]), 4)
    out[:, 1] = np.round(960.0 + np.cos(angle) * x - np.sin(angle) * y)
    out[:, 2] = np.round(540.0 + np.sin(angle) * x + np.cos(angle) * y)
    out[:, 5] = events[:, 5]
    ends = out[offsets[1:] - 1, 1:3].tolist()
    trials = tuple(
        Trial(f"person {(first + k) // PEOPLE_TRIALS:05d}", str(first + k), *end, 24.0)
        for k, end in enumerate(ends)
    )
    begin = np.zeros(len(out), dtype=np.bool_)
    begin[offsets[:-1]] = True
    provenance = Provenance("generated", simulated=True)
    return Recording(name, EventColumns(out, begin), offsets.astype(np.int64), trials, provenance=provenance)


WAYS: dict[str, dict[str, Any]] = {
    "1 thread": {"threads": 1},
    "2 threads": {"threads": 2},
    "2 processes": {"processes": 2},
    "Dask, 2 workers": {"cluster": "local"},
}
RECORDINGS = ((4_000, 1000), (30_000, 125))
"""Trials and events a second of the recordings that rates are measured on: about 4 million events each."""
PREDICTORS = ("switched", "kinematic")
ROUNDS = 3
MILLION, MILLION_HZ = 1_000_000, 125
KILLS, KILLED_AT = 3, 0.3
"""How often a run is killed, and after which share of the time of one that is not."""
LAST_MOST = 0.7
"""The last run takes at most this share of that time, or the checkpoints were not used."""


def recording(folder: Path, trials: int, rate_hz: int) -> Path:
    """A generated recording, made where it is missing."""
    path = folder / f"generated_{trials}_{rate_hz}hz_samples.parquet"
    return path if path.exists() else generate(folder, trials, rate_hz)


def opened(path: Path) -> StoredRecording:
    """A recording that stays in its file."""
    one = stored(path, trials_beside(path), rows_least=0)
    assert one is not None
    return one


def rates(folder: Path) -> Table:
    """Million events a second from file to scores, the median of rounds in which all ways take turns."""
    seconds: dict[tuple[int, str, str], list[float]] = {}
    sources = {rate: opened(recording(folder, trials, rate)) for trials, rate in RECORDINGS}
    with ExitStack() as stack:
        executors = {way: stack.enter_context(open_executor(**given)) for way, given in WAYS.items()}
        for turn in range(ROUNDS + 1):  # in the first one workers start and load machine code
            for rate, source in sources.items():
                for name in PREDICTORS:
                    for way, executor in executors.items():
                        start = time.perf_counter()
                        score_in_chunks(source, scoring_with([name]), executor)
                        if turn:
                            took = time.perf_counter() - start
                            seconds.setdefault((rate, name, way), []).append(took)
    rows = []
    for rate, source in sources.items():
        events = float(source.starts[-1])
        for name in PREDICTORS:
            values = {way: events / 1e6 / statistics.median(seconds[rate, name, way]) for way in WAYS}
            share = statistics.median(
                threads / dask
                for threads, dask in zip(
                    seconds[rate, name, "2 threads"], seconds[rate, name, "Dask, 2 workers"], strict=True
                )
            )
            rows.append(
                (f"{rate}", f"`{name}`", *(f"{values[way]:.2f}" for way in WAYS), f"{100.0 * share:.0f}")
            )
    return Table.of(("events a second of a trial", "predictor", *WAYS, "Dask, % of threads"), rows)


def million(folder: Path) -> tuple[Table, dict[str, Any]]:
    """One million trials by the command line: undisturbed, then killed three times and resumed."""
    path = recording(folder, MILLION, MILLION_HZ)
    events = pq.read_metadata(path).num_rows
    work = Path(tempfile.mkdtemp(dir=folder))
    rows, same, resumed = [], [], dict[str, float]()
    for name in PREDICTORS:
        took, peak_mb, _ = _scored(path, name, work / f"{name}-whole")
        rows.append(
            (f"`{name}`", f"{took:.0f}", f"{events / took / 1e6:.2f}", f"{peak_mb:.0f}", _size_mb(work, name))
        )
        if name == PREDICTORS[0]:
            for _ in range(KILLS):
                *_, was_killed = _scored(path, name, work / f"{name}-killed", killed_after_s=KILLED_AT * took)
                if not was_killed:
                    raise SystemExit(f"a run ended before it was killed: score more than {MILLION} trials")
            last_s, *_ = _scored(path, name, work / f"{name}-killed")
            if last_s > LAST_MOST * took:
                raise SystemExit(
                    f"after {KILLS} kills the last run took {last_s:.1f} s, expected at most {LAST_MOST:g} "
                    f"of {took:.1f} s: checkpoints were not used"
                )
            resumed = {"kills": KILLS, "killed_at": KILLED_AT, "whole_s": took, "last_s": last_s}
            documents = [(work / f"{name}-{one}.json").read_bytes() for one in ("whole", "killed")]
            same.append(documents[0] == documents[1])
    shutil.rmtree(work)
    headings = ("predictor", "seconds", "million events a second", "peak memory, MB", "checkpoints, MB")
    numbers = {
        "trials": MILLION,
        "events": events,
        "file_mb": path.stat().st_size / 1e6,
        "resumed_same": all(same),
        **resumed,
    }
    return Table.of(headings, rows), numbers


def _scored(
    path: Path, name: str, out: Path, killed_after_s: float | None = None
) -> tuple[float, float, bool]:
    """Seconds, peak memory in MB, and whether ``pointpred score`` on two threads was killed on the way."""
    command = [sys.executable, "-m", "pointpred", "score", str(path), "--predictors", name, "--threads", "2"]
    command += ["--checkpoints", str(out), "--json", str(out.with_suffix(".json")), "--force"]
    start = time.perf_counter()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    if killed_after_s is not None:
        try:
            process.wait(killed_after_s)
        except subprocess.TimeoutExpired:
            process.kill()
    if process.returncode is not None:  # it ended before it was to be killed
        return time.perf_counter() - start, 0.0, False
    _, status, usage = os.wait4(process.pid, 0)
    took = time.perf_counter() - start
    code = os.waitstatus_to_exitcode(status)
    if killed_after_s is None and code:
        raise SystemExit(f"{' '.join(command)} failed")
    return took, usage.ru_maxrss / 1024.0, code == -signal.SIGKILL


def _size_mb(work: Path, name: str) -> str:
    return f"{sum(file.stat().st_size for file in (work / f'{name}-whole').rglob('*.*')) / 1e6:.0f}"


def main(wanted: list[str]) -> None:
    """Measure and keep the numbers."""
    with ExitStack() as stack:
        given = os.environ.get("SCALE_FOLDER")
        folder = Path(given or stack.enter_context(tempfile.TemporaryDirectory()))
        where = machine(load=True)
        if not wanted or "rates" in wanted:
            keep("costs", {"rates": rates(folder)}, part="scale", numbers={"rates_machine": where})
        if not wanted or "million" in wanted:
            table, numbers = million(folder)
            keep("costs", {"million": table}, part="scale", numbers={**numbers, "million_machine": where})


if __name__ == "__main__":
    main(parse(__doc__, metavar="WHAT", choices=["rates", "million"]))
