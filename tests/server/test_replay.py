"""``pointpred replay``: the socket answers as the batch does, and where it does not, it is said."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest

from pointpred import EventColumns, PredictionColumns, build, run
from pointpred.client import connect
from pointpred.datasets import sample
from pointpred.errors import ParameterError
from pointpred.live.playback import Pacing, select_trials
from pointpred.live.socket import replay_to, unlike
from pointpred.predictors.kinematic import coefficient_file
from pointpred.recording import Recording, Trial
from pointpred.recordings import write
from pointpred.registry import REGISTRY
from pointpred_server.sessions.pointing import PointingSession
from tests.server.listener import Listener
from tests.server.running import PATIENCE_S


@pytest.fixture(scope="module")
def listener() -> Iterator[Listener]:
    with Listener() as service:
        yield service


@pytest.fixture(autouse=True)
def patient(monkeypatch: pytest.MonkeyPatch) -> None:
    """An answer may take long where many share the processors."""
    monkeypatch.setattr("pointpred.live.socket.connect", partial(connect, timeout_s=PATIENCE_S))


SAMPLE = sample()
NAMES = ["1", "p10-23", "120"]


@pytest.mark.parametrize("predictor", REGISTRY)
def test_socket_and_batch_agree_bit_for_bit(listener: Listener, predictor: str) -> None:
    played = replay_to(listener.url, SAMPLE, predictor=predictor, speed=math.inf, trials=NAMES)
    assert [(one.user, one.predictions) for one in played.trials] == [
        (SAMPLE.trials[k].user, len(SAMPLE.rows(k))) for k in (0, 239, 119)
    ]
    assert played.agree
    for one in played.trials:
        assert one.unlike == one.gave_way == 0
        assert one.score == one.batch
        assert one.score.time_averaged_px is not None


def test_coefficients_of_ones_own_are_named_to_the_service(tmp_path: Path) -> None:
    path = tmp_path / "me.npz"
    with np.load(coefficient_file.OWN) as shipped:
        np.savez(path, **{**shipped, "offset2": shipped["offset2"] + np.float32(0.5)})
    asked = {"predictor": "kinematic", "speed": math.inf, "trials": ["1"]}
    with Listener(coefficients={"me": path}) as service:
        assert replay_to(service.url, SAMPLE, coefficients=("me", path), **asked).agree
        other = replay_to(service.url, SAMPLE, coefficients=("me", coefficient_file.OWN), **asked)
    assert other.trials[0].unlike > 0


@pytest.mark.parametrize(
    "options",
    [
        ["--coefficients", "me", "--to", "ws://127.0.0.1:1"],
        ["--coefficients", "=me.npz", "--to", "ws://127.0.0.1:1"],
        ["--coefficients", "me=none.npz", "--to", "ws://127.0.0.1:1"],
        ["--coefficients", f"me={coefficient_file.OWN}", "--devtools", "http://127.0.0.1:1"],
        [
            "--coefficients",
            f"me={coefficient_file.OWN}",
            "--to",
            "ws://127.0.0.1:1",
            "--predictor",
            "hold",
        ],
    ],
)
def test_wrong_coefficients_are_refused_before_anything_is_played(command: Any, options: list[str]) -> None:
    left = command("replay", *options)
    assert left.code == 2
    assert "coefficients" in left.err


def test_a_service_that_answers_otherwise_is_found_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """The service resets in the middle of every trial: a few predictions differ, and that is seen."""
    receive = PointingSession.receive

    def forgetful(self: PointingSession, frame: str | bytes, now: float) -> None:
        receive(self, frame, now)
        if isinstance(frame, bytes):
            receive(self, '{"type":"reset"}', now)

    monkeypatch.setattr(PointingSession, "receive", forgetful)
    with Listener() as listener:
        played = replay_to(listener.url, SAMPLE, speed=math.inf, trials=["1"])
    assert not played.agree
    assert 0 < played.trials[0].unlike < played.trials[0].events


@pytest.mark.parametrize("predictor", ["ktm", "kinematic-adaptive"])
def test_each_user_meets_a_predictor_that_knows_nobody(listener: Listener, predictor: str) -> None:
    """Three trials of one person are followed by one of another, who is answered as if he came first."""
    users = [trial.user for trial in SAMPLE.trials]
    other = next(k for k, user in enumerate(users) if user != users[0])
    names = ["1", "2", "3", str(other + 1)]
    before = len(listener.messages("hello"))
    played = replay_to(listener.url, SAMPLE, predictor=predictor, speed=math.inf, trials=names)
    assert played.agree
    assert len(listener.messages("hello")) == before + 2
    heard = {}
    for first in (names[:3], []):
        pipeline = build(predictor, cpi=SAMPLE.provenance.cpi, dpi=SAMPLE.provenance.dpi)
        for name in first:
            run(pipeline, SAMPLE.rows(int(name) - 1))
            pipeline.reset()
        heard[len(first)] = run(pipeline, SAMPLE.rows(other))
    assert unlike(heard[3], heard[0]) > 0  # it would have mattered


def test_one_bit_is_seen() -> None:
    table = np.arange(30.0).reshape(3, 10)
    table[1, 3:] = np.nan
    other = table.copy()
    assert unlike(PredictionColumns(table), PredictionColumns(other)) == 0
    other[2, 1] = np.nextafter(other[2, 1], 100.0)
    assert unlike(PredictionColumns(table), PredictionColumns(other)) == 1
    assert unlike(PredictionColumns(table[[0, 2]]), PredictionColumns(table)) == 0  # one gave way
    assert unlike(PredictionColumns(table[[2, 0]]), PredictionColumns(table)) == 1  # out of order


def test_rows_come_when_they_are_due() -> None:
    clock = [5.0]
    t = np.array([7.0, 7.0, 7.5, 7.75, 8.0])
    pacing = Pacing(t, 2.0, clock=lambda: clock[0], sleep=lambda s: clock.__setitem__(0, clock[0] + s))
    handed = []
    while due := pacing.take():
        handed.append((due.start, due.stop, clock[0]))
        # sending takes long: what fell due meanwhile comes together
        clock[0] += 0.2 if due.start == 2 else 0.0
    assert handed == [(0, 2, 5.0), (2, 3, 5.25), (3, 4, 5.45), (4, 5, 5.5)]


def test_it_keeps_the_recorded_pace(listener: Listener) -> None:
    t = np.linspace(0.0, 0.4, 41)
    recording = Recording.of("line", [EventColumns.of(t, 1000 * t, 0 * t)], [Trial("ann", "1")])
    for speed in (1.0, 4.0):
        (one,) = replay_to(listener.url, recording, speed=speed, predictor="hold").trials
        assert one.agree
        assert one.seconds >= 0.4 / speed


def test_counts_that_are_not_whole_travel_as_text(listener: Listener) -> None:
    t = np.linspace(0.0, 0.4, 41)
    path = EventColumns.of(t, 1000 * t, 0 * t, 0.5 + 0 * t, 0 * t)
    recording = Recording.of("line", [path], [Trial("ann", "1")])
    played = replay_to(listener.url, recording, speed=math.inf, cpi=800.0)
    assert played.agree
    assert listener.messages("hello")[-1]["encoding"] == "json"


def test_what_cannot_be_played_is_left_out_in_words(
    listener: Listener, tmp_path: Path, command: Callable[..., Any]
) -> None:
    line = EventColumns.of([0.0, 0.1, 0.2], [0, 50, 100], [0, 0, 0])
    back = EventColumns.of([0.0, 0.2, 0.1], [0, 50, 100], [0, 0, 0])
    recording = Recording.of("two", [line, back], [Trial("ann", "1"), Trial("ann", "2")])
    file, _ = write(recording, tmp_path / "two_samples.parquet")
    left = command("replay", file, "--to", listener.url, "--speed", "max", "--json", "-")
    told = msgspec.json.decode(left.out)
    assert left.code == 0
    assert [one["trial"] for one in told["trials"]] == ["1"]
    assert told["agree"] is True
    assert "left out: ann-2 " in left.err
    assert [one["trial"] for one in told["skipped"]] == ["2"]
    with pytest.raises(ParameterError, match="unknown trial"):
        replay_to(listener.url, recording, trials=["ann-3"])
    played = replay_to(listener.url, recording, trials=["2"])
    assert [skip.reason for skip in played.skipped] == ["event 2 of the trial: time runs backwards"]


def test_the_table_says_how_many_agree(listener: Listener, command: Callable[..., Any]) -> None:
    left = command("replay", "--to", listener.url, "--speed", "max", "--trial", "2", "--predictor", "linear")
    assert left.code == 0
    assert "1 of 1 trials as the local batch, bit for bit (linear)" in left.out


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ([], "--to URL of a service, or --devtools URL of a browser"),
        (
            ["--to", "ws://127.0.0.1:1", "--speed", "0"],
            "speed must be a positive number or 'max', received '0'",
        ),
        (
            ["--to", "ws://127.0.0.1:1", "--trial", "zz"],
            "unknown trial 'zz': trials are named as 'p01-0'",
        ),
        (["--to", "ws://127.0.0.1:1", "--predictor", "x"], "unknown predictor 'x'"),
        (["--devtools", "127.0.0.1:9222"], "DevTools are at http://HOST:PORT"),
    ],
)
def test_wrong_use_is_named(command: Callable[..., Any], options: list[str], said: str) -> None:
    left = command("replay", *options)
    assert left.code == 2
    assert said in left.err


def test_nobody_there_is_said(command: Callable[..., Any]) -> None:
    left = command("replay", "--to", "ws://127.0.0.1:1", "--trial", "1")
    assert (left.code, left.out) == (1, "")
    assert "cannot connect to ws://127.0.0.1:1/v1/stream" in left.err
    left = command("replay", "--devtools", "http://127.0.0.1:1", "--trial", "1")
    assert left.code == 1
    assert "no browser answers at http://127.0.0.1:1" in left.err
    assert "--remote-debugging-port=9222" in left.err


def test_trials_are_chosen_once() -> None:
    assert select_trials(SAMPLE, ["2", "p01-1", "1"]) == [1, 0]
    assert select_trials(SAMPLE, []) == list(range(240))
