"""A trial that a client marks, its score, and who looks on."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from pointpred import EventColumns, PredictionColumns, build, run
from pointpred.clock import Instant
from pointpred.datasets import sample
from pointpred.protocol.client_messages import Conditions, Goal, Hello
from pointpred.protocol.server_messages import Limits, ServerMessage
from pointpred.recording import Recording
from pointpred.scoring import prepare, replay
from pointpred_server.sessions.pointing import PointingSession
from pointpred_server.sessions.trials import MOST_EVENTS, TrialBuffer
from tests.unit.talking import Talk, events, hello, packed

START = {"type": "trial", "action": "start"}
END = {"type": "trial", "action": "end"}
CPI, DPI = sample().provenance.cpi, sample().provenance.dpi


def rows_of(number: int) -> list[list[float | None]]:
    table = sample().rows(number).table.tolist()
    return [[*(None if v != v else v for v in row[:5]), int(row[5])] for row in table]


def greeting(name: str = "switched") -> dict[str, Any]:
    return hello(name, device={"cpi": CPI} if CPI else None, screen={"dpi": DPI})


def scored(talk: Talk, number: int, frame: int = 64) -> dict[str, Any]:
    """Run a trial of the embedded sample through a session."""
    talk.say(START)
    talk.feed(rows_of(number), packed, frame)
    (score,) = talk.say(END)
    found: dict[str, Any] = score
    return found


@pytest.mark.parametrize("frame", [1, 7, 64])
@pytest.mark.parametrize("name", ["switched", "kep-quartic-gated", "hold"])
def test_the_score_is_that_of_the_offline_scorer(name: str, frame: int) -> None:
    score = scored(Talk(greet=greeting(name)), 0, frame)
    recording = Recording.of("one", [sample().rows(0)], [sample().trials[0]])
    prepared = prepare(recording, cpi=CPI, dpi=DPI, threads=1)
    errors = replay(prepared, build(name, cpi=CPI, dpi=DPI), threads=1)
    hold = replay(prepared, build("hold", cpi=CPI, dpi=DPI), threads=1)
    assert score["type"] == "score"
    assert score["time_averaged_px"] == errors.time_averaged[0]
    assert score["hold_px"] == hold.time_averaged[0]
    assert score["skill"] == 1.0 - errors.time_averaged[0] / hold.time_averaged[0]
    assert score["events"] == prepared.trials[0].events
    assert score["reason"] is None
    assert list(score["by_time"].values()) == errors.by_time[0].tolist()


def test_the_score_does_not_depend_on_what_was_before() -> None:
    talk = Talk(greet=greeting())
    first = scored(talk, 0)
    talk.say(events([1e6, 1.0, 2.0, None, None, 0]))
    assert scored(talk, 1) != first
    assert scored(talk, 0) == first


def test_a_trial_starts_a_movement() -> None:
    talk, other = Talk(greet=greeting()), Talk(greet=greeting())
    talk.feed(rows_of(0)[:500])
    assert talk.say(START) == []
    assert talk.feed(rows_of(1)[:500]) == other.feed(rows_of(1)[:500])


def test_another_predictor_within_a_trial_scores_the_whole_trial() -> None:
    talk = Talk(greet=greeting())
    talk.say(START)
    rows = rows_of(0)
    talk.say(packed(*rows[:30]))
    talk.say({"type": "configure", "predictor": "linear"})
    talk.feed(rows[30:])
    (score,) = talk.say(END)
    assert score == scored(Talk(greet=greeting("linear")), 0)


def test_an_end_without_a_start_is_out_of_place() -> None:
    talk = Talk()
    for _ in range(2):
        error = talk.error(END)
        assert (error["code"], error["path"], error["recoverable"]) == ("out_of_place", "$.action", True)
        assert "'start'" in error["message"]
        scored(talk, 0)


@pytest.mark.parametrize("rows", [[], [[0.0, 1.0, 1.0, None, None, 0]]])
def test_a_trial_that_cannot_be_scored_says_why(rows: list[Any]) -> None:
    talk = Talk()
    talk.say(START)
    talk.say(events(*rows))
    (score,) = talk.say(END)
    assert (score["type"], score["events"], score["time_averaged_px"]) == ("score", len(rows), None)
    assert score["reason"]


def test_memory_is_bounded_and_a_trial_that_is_too_long_says_so() -> None:
    keeper = TrialBuffer()
    keeper.start(None, {})
    table = EventColumns.of(np.arange(30_000.0), np.zeros(30_000), np.zeros(30_000))
    for _ in range(10):
        keeper.add(table.table)
    assert len(pickle.dumps(keeper)) < MOST_EVENTS * table.table[0].nbytes + 1000
    score = keeper.end(None, build("hold"), None, 96.0)()
    assert (score.events, score.time_averaged_px) == (300_000, None)
    assert str(MOST_EVENTS) in str(score.reason)


def test_a_score_made_aside_shares_nothing_with_what_comes_after() -> None:
    talk, other = Talk(greet=greeting()), Talk(greet=greeting())
    score = scored(other, 0)
    aside: list[Callable[[], ServerMessage]] = []
    talk.session.run_aside = aside.append
    talk.say(START)
    talk.feed(rows_of(0))
    assert talk.say(END) == []
    assert talk.say({"type": "configure", "predictor": "linear"})[0]["type"] == "welcome"
    talk.say(START)
    talk.say(events([1e6, 1.0, 2.0, None, None, 0]))
    (work,) = aside
    talk.session.send(work())
    assert talk.hear() == [score]


class Diary:
    """Looks on, and writes everything down."""

    def __init__(self) -> None:
        self.lines: list[Any] = []

    def open(self, name: str, hello: Hello) -> Diary:
        self.lines.append(("open", name, hello.predictor))
        return self

    def configure(self, hello: Hello) -> None:
        self.lines.append(("configure", hello.predictor))

    def events(self, table: EventColumns, predictions: PredictionColumns) -> None:
        self.lines.append((table.table.tobytes(), predictions.table.tobytes()))

    def trial(self, action: str, target: Goal | None = None, conditions: Conditions | None = None) -> None:
        self.lines.append(("trial", action, target, conditions))

    def close(self) -> None:
        self.lines.append("close")


@pytest.mark.parametrize("form", [events, packed])
def test_who_looks_on_is_told_everything_that_was_taken_in(form: Any) -> None:
    diary, talk = Diary(), Talk(greet=False)
    talk.session = PointingSession("name", Limits(), Instant(0.0), observe=diary.open)
    talk.say(events([0.0, 1.0, 1.0, None, None, 0]))
    talk.say(hello("linear"))
    rows = [[0.1 * i, 5.0 * i, 1.0, 3, 4, 0] for i in range(4)]
    talk.say(form(rows[0]))
    told = {"block": 1.0, "participant": "p7"}
    talk.say({**START, "target": {"x": 1, "y": 2, "width": 3}, "conditions": told})
    talk.say(form(rows[1], rows[3], rows[2]))
    talk.say({**END, "conditions": {"block": 2, "hit": "yes"}})
    talk.say({"type": "configure", "predictor": "hold"})
    talk.say({"type": "bye"})
    talk.session.stop("again")
    first = EventColumns(np.array([rows[0]], np.float64))
    taken = EventColumns(np.array([rows[1], rows[3]]))
    assert diary.lines == [
        ("open", "name", "linear"),
        (first.table.tobytes(), run(build("linear"), first).table.tobytes()),
        ("trial", "start", Goal(1.0, 2.0, 3.0), None),
        (taken.table.tobytes(), run(build("linear"), taken).table.tobytes()),
        ("trial", "end", None, {"block": 2.0, "participant": "p7", "hit": "yes"}),
        ("configure", "hold"),
        "close",
    ]


def test_the_trials_of_a_session_have_the_conditions_of_the_first() -> None:
    talk = Talk()
    talk.say({**START, "conditions": {"block": 1}})
    assert talk.say({**START, "conditions": {"block": 1, "size": 2}}) == []  # none has ended
    assert talk.say({**END, "conditions": {"hit": "yes"}})[0]["type"] == "score"
    assert talk.say({**START, "conditions": {"hit": "no"}}) == []
    error = talk.error({**START, "conditions": {"phase": "practice"}})
    assert (error["code"], error["path"]) == ("bad_field", "$.conditions.phase")
    assert "first trial, which had: block, size, hit" in error["message"]
    assert talk.error({**END, "conditions": {"phase": "practice"}})["path"] == "$.conditions.phase"
    assert talk.say(END)[0]["type"] == "score"
