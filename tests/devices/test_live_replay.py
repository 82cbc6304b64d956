"""``pointpred live --replay``: a recording in the place of a mouse, on the path of a mouse's events."""

from __future__ import annotations

import csv
import math
import re
import signal
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from websockets.sync.client import connect

from pointpred import EventColumns, build, run
from pointpred.devices.cursor_paths import PositionPath
from pointpred.errors import ParameterError
from pointpred.live.playback import GAP_S, PlayedPipeline, PlayedSource, PlayedTrial
from pointpred.live.run import PAGE_FIRST
from pointpred.live.session import LiveSession
from pointpred.recording import Recording, Trial
from pointpred.recordings import read, write
from pointpred.records import FloatArray, Pair, PredictionColumns
from tests.devices.live_process import PATIENCE_S
from tests.devices.test_live_served import goodbye, heard

NAME = "kinematic-adaptive"


class Clock:
    """Time that passes only where somebody sleeps."""

    def __init__(self) -> None:
        self.now = 100.0

    def __call__(self) -> float:
        return self.now

    def sleep(self, seconds: float) -> None:
        self.now += seconds


def reach(begin: float, distance: float, seed: int) -> EventColumns:
    """A noisy reach without counts, on times that no addition leaves as they are."""
    t = np.arange(0.0, 0.6, 0.01)
    s = np.clip(t / 0.5, 0.0, 1.0)
    way = distance * (10 * s**3 - 15 * s**4 + 6 * s**5)
    aside = np.random.default_rng(seed).normal(size=len(t))
    return EventColumns.of(begin + t, np.round(way), np.round(0.3 * way + aside))


TRIALS = [("ann", 0.1, 300.0), ("ann", 0.1, 500.0), ("ann", 9.7, -400.0), ("bob", 0.3, 700.0)]
"""Two trials that begin at the same time, one that follows by itself, and another person's."""


def parts() -> list[PlayedTrial]:
    return [PlayedTrial(Trial(user, str(i)), reach(t, way, i)) for i, (user, t, way) in enumerate(TRIALS)]


def played(trials: Sequence[PlayedTrial], speed: float = 1.0, **more: Any) -> tuple[PlayedSource, Clock]:
    clock = Clock()
    return PlayedSource("replay", "f", trials, speed=speed, clock=clock, sleep=clock.sleep, **more), clock


def pairs_of(trials: Sequence[PlayedTrial], speed: float = math.inf) -> list[Pair]:
    """What a session makes of trials."""
    source, _ = played(trials, speed)
    session = LiveSession(source, PositionPath("recorded", counts=True), PlayedPipeline(build(NAME)))
    pairs: list[Pair] = []
    while not source.ended:
        pairs += session.advance()
    return pairs


def batch(trials: Sequence[PlayedTrial]) -> FloatArray:
    """Predictions of the recording as ``run`` makes them: a fresh pipeline a person, a beginning a trial."""
    tables = []
    for user in dict.fromkeys(trial.about.user for trial in trials):
        pipeline = build(NAME)
        for trial in (one for one in trials if one.about.user == user):
            pipeline.reset()
            tables.append(run(pipeline, trial.events).table)
    return np.concatenate(tables)


def test_its_predictions_are_those_of_the_batch_bit_for_bit() -> None:
    trials = parts()
    pairs, wanted = pairs_of(trials), PredictionColumns(batch(trials))
    assert len(pairs) == len(wanted)
    for (event, one), expected in zip(pairs, wanted.predictions(), strict=True):
        assert (one is None) == (expected is None)
        if one is not None and expected is not None:
            assert one.t == event.t
            assert one == type(one)(event.t, *(getattr(expected, n) for n in expected.__struct_fields__[1:]))
    learned = batch([trials[1]])
    assert not np.array_equal(wanted.table[60:120], learned, equal_nan=True)  # the order matters


def test_shown_times_grow_and_stay_as_recorded_where_they_can() -> None:
    trials = parts()
    shown = np.array([event.t for event, _ in pairs_of(trials)])
    assert (np.diff(shown) >= 0.0).all()
    first, second, third, _ = np.split(shown, 4)
    assert first.tolist() == trials[0].events.t.tolist()
    assert second[0] == pytest.approx(first[-1] + GAP_S)
    assert third.tolist() == trials[2].events.t.tolist()


@pytest.mark.parametrize("speed", [1.0, 2.0])
def test_events_come_when_they_came(speed: float) -> None:
    trial = PlayedTrial(Trial("ann", "a"), EventColumns.of([5.0, 5.1, 5.4], [0.0, 1.0, 2.0], [0.0, 0.0, 0.0]))
    source, clock = played([trial], speed)
    came: list[tuple[float, float]] = []
    while not source.ended:
        came += [(report.t, clock.now - 100.0) for report in source.take(0.01)]
    assert [t for t, _ in came] == [5.0, 5.1, 5.4]
    assert [at * speed for _, at in came] == pytest.approx([0.0, 0.1, 0.4], abs=0.021 * speed)
    assert [source.take(0.5), clock.now] == [[], pytest.approx(100.5 + 0.4 / speed, abs=0.03)]


def test_it_begins_with_the_first_wait_and_not_while_it_is_held() -> None:
    source, clock = played(parts())
    held = [True]
    source.hold = lambda: held[0]
    assert source.take(0.0) == source.take(1.0) == []
    held[0] = False
    clock.now += 5.0
    assert [report.t for report in source.take(0.001)] == [0.1]


@pytest.mark.parametrize("speed", [0.0, -1.0, math.nan])
def test_a_speed_must_be_positive(speed: float) -> None:
    with pytest.raises(ParameterError, match="speed"):
        played(parts(), speed)


@pytest.fixture
def file(tmp_path: Path) -> Path:
    """The trials as our CSV."""
    trials = parts()
    names = [trial.about for trial in trials]
    write(Recording.of("study", [trial.events for trial in trials], names), tmp_path / "study_samples.csv")
    return tmp_path / "study_samples.csv"


def test_the_command_plays_all_of_it_and_ends_with_0(
    command: Callable[..., Any], file: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in ("hid", "evdev", "pointpred.devices.hidraw", "pointpred.devices.evdev"):
        monkeypatch.setitem(sys.modules, module, None)  # an import of these fails
    back = file.with_name("back_samples.csv")
    left = command("live", "--replay", file, "--speed", "max", "--record", back)
    assert left.code == 0, left.err
    assert "replay of study_samples.csv" in left.err
    lines = file.with_name("back_predictions.csv").read_text().splitlines()
    rows = list(csv.DictReader(lines))
    wanted = PredictionColumns(batch(parts()))
    for name, column in (("x_px", wanted.x), ("y_px", wanted.y), ("remaining_s", wanted.remaining_s)):
        got = np.array([float(row[name] or "nan") for row in rows])
        assert np.array_equal(got, column, equal_nan=True)


def test_some_trials_are_played_in_the_order_asked_for(command: Callable[..., Any], file: Path) -> None:
    pattern = file.with_name("study_s*.csv")
    left = command("live", "--replay", pattern, "--speed", "max", "--trial", "bob-3", "--trial", "1")
    assert left.code == 0, left.err
    assert "plays: 2 trials" in left.err
    assert re.search(r"^120 reports;", left.out, re.MULTILINE)


@pytest.mark.parametrize(
    ("arguments", "code", "said"),
    [
        (["--replay", "nosuch.csv"], 2, "nosuch.csv"),
        (["--replay", "FILE", "--device", "/dev/hidraw0"], 2, "--device"),
        (["--replay", "FILE", "--cursor", "motor"], 2, "--cursor"),
        (["--replay", "FILE", "--trial", "nobody"], 2, "nobody"),
        (["--replay", "FILE", "--speed", "0"], 2, "speed"),
        (["--trial", "1"], 2, "--replay"),
        (["--speed", "2"], 2, "--replay"),
    ],
)
def test_wrong_use_is_one_line(
    command: Callable[..., Any], file: Path, arguments: list[str], code: int, said: str
) -> None:
    left = command("live", *(str(file) if word == "FILE" else word for word in arguments))
    assert (left.code, left.out) == (code, "")
    assert said in left.err
    assert "Traceback" not in left.err


def started(*arguments: str | Path) -> subprocess.Popen[str]:
    words = [sys.executable, "-m", "pointpred", "live", "--predictor", "hold", *map(str, arguments)]
    pipe = subprocess.PIPE
    return subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=pipe, stderr=pipe, text=True)


def test_a_viewer_sees_all_of_it_from_the_beginning_and_then_it_ends(file: Path) -> None:
    process = started("--replay", file, "--speed", "4", "--serve", "--port", "0")
    assert process.stdout is not None
    address = next(line.strip() for line in process.stdout if line.startswith("http"))
    stream = address.replace("http", "ws") + "v1/live"
    with connect(stream, compression=None, open_timeout=PATIENCE_S) as socket:
        told: dict[str, list[Any]] = {}
        heard(socket, told, 240)
        assert "replay of study_samples.csv" in told["device"][0]["name"]
        assert told["device"][0]["space"] == "screen"
        rows = [row for one in told["events"] for row in one["events"]]
        assert [row[1] for row in rows] == read(file).events.x.tolist()
        assert goodbye(socket)["type"] == "bye"
    out, err = process.communicate(timeout=PATIENCE_S)
    assert process.returncode == 0, err
    assert PAGE_FIRST in err
    assert "240 reports" in out


def test_ctrl_c_ends_it_in_order(file: Path) -> None:
    back = file.with_name("back_samples.csv")
    process = started("--replay", file, "--speed", "0.02", "--record", back)
    assert process.stdout is not None
    next(line for line in process.stdout if "cursor" in line)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=PATIENCE_S)
    assert process.returncode == 0, err
    assert "recorded:" in out
    assert "Traceback" not in err


def test_a_recording_of_simulated_people_still_says_so(command: Callable[..., Any], tmp_path: Path) -> None:
    back = tmp_path / "back.csv"
    left = command("live", "--replay", "sample", "--trial", "1", "--speed", "max", "--record", back)
    assert left.code == 0, left.err
    assert read(back).provenance.simulated
