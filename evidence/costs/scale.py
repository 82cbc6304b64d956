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
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pyarrow.parquet as pq

from evidence.arguments import parse
from evidence.costs.scale_recordings import generate
from evidence.data import Table, keep
from evidence.machine import machine
from pointpred.recordings.own import trials_beside
from pointpred.recordings.stored import StoredRecording, stored
from pointpred.scoring.chunks import score_in_chunks
from pointpred.scoring.executors import open_executor
from pointpred.scoring.scorer import scoring_with

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
    command += ["--checkpoints", str(out), "--json", str(out.with_suffix(".json"))]
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
