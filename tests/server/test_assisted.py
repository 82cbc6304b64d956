"""Sessions whose cursor the service moves: the same as the library does, and nothing for who did not ask."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from pointpred import PointerEvent, Prediction, build
from pointpred.pipeline import Pipeline
from pointpred.records import EVENT_FIELD, refused
from pointpred.transfer import ConstantGain, GuardedTransfer, PixelTransfer, SigmoidGain
from tests.unit.talking import PREDICTION, Talk, events, hello, packed

CPI = 1000.0
START = (300.0, 400.0)


def asking(predictor: str = "switched-direction", **assist: Any) -> dict[str, Any]:
    """A hello that asks for assistance."""
    return hello(predictor, device={"cpi": CPI}, assist=assist)


def reach(count: int = 120, angle: float = 0.4) -> list[list[float]]:
    """Counts of one reach at 1 kHz with a wavering hand; the positions say only where it starts."""
    random = np.random.default_rng(7)
    u = np.arange(1, count + 1) / count
    speed = 60.0 * (u * (1.0 - u)) ** 2 * 16.0
    angles = angle + 0.1 * random.normal(size=count)
    dx, dy = np.round(speed * np.cos(angles)), np.round(speed * np.sin(angles))
    return [
        [0.5 + i / 1000, *(START if i == 0 else (-7e3, 9e3)), float(dx[i]), float(dy[i]), 0]
        for i in range(count)
    ]


def offline(
    rows: list[list[float]], transfer: GuardedTransfer, predictor: str = "switched-direction"
) -> tuple[list[tuple[float, float]], list[Prediction | None]]:
    """The public stages in a plain loop: a prediction guides the next report."""
    pipeline, prediction = build(predictor, cpi=CPI), None
    (x, y), places, predictions = START, [], []
    for t, _, _, dx, dy, buttons in rows:
        px, py = transfer.update((t, dx, dy), prediction, (x, y))
        x, y = x + px, y + py
        prediction = pipeline.update(PointerEvent(t, x, y, dx, dy, int(buttons)))
        places.append((x, y))
        predictions.append(prediction)
    return places, predictions


def cursors(answers: list[Any]) -> list[tuple[float, float]]:
    return [(a["x"], a["y"]) for a in answers if not isinstance(a, bytes) and a["type"] == "cursor"]


def test_the_service_moves_the_cursor_as_the_library_does_bit_for_bit() -> None:
    rows = reach()
    talk = Talk(greet=asking(strength=0.6, rho=5.0))
    found = [talk.say(events(row)) for row in rows]
    transfer = GuardedTransfer(ConstantGain(4.0), cpi=CPI, strength=0.6, rho=5.0)
    places, predictions = offline(rows, transfer)
    assert [cursors(answers) for answers in found] == [[place] for place in places]
    for answers, wanted in zip(found, predictions, strict=True):
        (told,) = [a for a in answers if a["type"] == "prediction"]
        assert (told["x"], told["y"]) == ((None, None) if wanted is None else (wanted.x, wanted.y))
    plain = PixelTransfer(ConstantGain(4.0), cpi=CPI)
    table = np.array(rows)
    alone = np.array(START) + plain.run(table[:, 0], table[:, 3], table[:, 4]).sum(axis=0)
    assert np.hypot(*(np.array(places[-1]) - START)) > 20.0 + np.hypot(*(alone - START))
    assert found[-1][0]["added_px"] > 20.0


@pytest.mark.parametrize("encoding", ["json", "binary"])
def test_frames_of_any_length_and_either_encoding_give_the_same_cursor(encoding: str) -> None:
    rows, places = reach(), []
    for size in (1, 7, 120):
        talk = Talk(greet={**asking(), "encoding": encoding}, max_events_per_frame=120)
        for first in range(0, len(rows), size):
            part = rows[first : first + size]
            answers = talk.say(packed(*part) if encoding == "binary" else events(*part))
            assert [type(a) for a in answers] == [dict, bytes if encoding == "binary" else dict]
            assert answers[0]["type"] == "cursor"
            t = PREDICTION.unpack(answers[1])[0] if encoding == "binary" else answers[1]["t"]
            assert answers[0]["t"] == t == part[-1][0]
        places.append(cursors(answers))
    assert places[0] == places[1] == places[2]


def test_without_strength_it_is_the_function_alone() -> None:
    rows = reach()
    for assist, function in (
        ({"strength": 0.0, "gain": 3.0}, ConstantGain(3.0)),
        ({"strength": 0.0, "function": "sigmoid"}, SigmoidGain()),
    ):
        table = np.array(rows)
        moved = PixelTransfer(function, cpi=CPI).run(table[:, 0], table[:, 3], table[:, 4])
        answers = Talk(greet=asking(**assist), max_events_per_frame=1000).say(events(*rows))
        assert cursors(answers) == [tuple(np.array(START) + moved.sum(axis=0))]
        assert answers[0]["added_px"] == 0.0


def test_the_cursor_stays_on_the_screen() -> None:
    talk = Talk(greet={**asking("hold"), "screen": {"width_px": 640.0, "height_px": 480.0}})
    rows = [[i / 1000, 600.0, 20.0, 90.0, -90.0, 0] for i in range(20)]
    assert cursors(talk.say(events(*rows))) == [(639.0, 0.0)]
    back = [[1.0 + i / 1000, 0.0, 0.0, -9000.0, 9000.0, 0] for i in range(3)]
    assert cursors(talk.say(events(*back))) == [(0.0, 479.0)]


def test_a_reset_forgets_the_movement_and_leaves_the_cursor() -> None:
    rows = reach(60)
    talk = Talk(greet=asking())
    (before,) = cursors(talk.say(events(*rows)))
    talk.say({"type": "reset"})
    still = [rows[0][0], 0.0, 0.0, 0.0, 0.0, 0]  # an earlier time than the last is allowed after a reset
    answers = talk.say(events(still))
    assert cursors(answers) == [before]
    fresh = build("switched-direction", cpi=CPI).update(PointerEvent(rows[0][0], *before, 0.0, 0.0))
    assert answers[1]["x"] == (None if fresh is None else fresh.x)


def test_what_was_predicted_before_a_reset_guides_nothing_after_it() -> None:
    rows = reach()[:55]  # given up while the hand is fast, with an endpoint ahead
    talk = Talk(greet=asking(strength=1.0, rho=100.0))
    (before,) = cursors(talk.say(events(*rows)))
    talk.say({"type": "reset"})
    _, _, _, dx, dy, _ = rows[35]
    (after,) = cursors(talk.say(events([9.0, 0.0, 0.0, dx, dy, 0])))
    assert after == tuple(np.array(before) + PixelTransfer(ConstantGain(4.0), cpi=CPI).update((9.0, dx, dy)))


def test_configure_changes_the_strength_and_keeps_the_cursor() -> None:
    rows = reach()
    talk = Talk(greet=asking(strength=1.0))
    (half,) = cursors(talk.say(events(*rows[:60])))
    (answer,) = talk.say({"type": "configure", "assist": {"strength": 0.0, "gain": 2.0}})
    assert answer["type"] == "welcome"
    (whole,) = cursors(talk.say(events(*rows[60:])))
    table = np.array(rows[60:])
    alone = PixelTransfer(ConstantGain(2.0), cpi=CPI).run(table[:, 0], table[:, 3], table[:, 4])
    assert whole == tuple(np.array(half) + alone.sum(axis=0))


def test_what_is_wrong_is_told_by_its_path() -> None:
    nobody = Talk(greet=False)
    without = nobody.error(hello("hold", assist={}))
    assert (without["code"], without["path"]) == ("bad_field", "$.device.cpi")
    for assist, path in (({"strength": 1.5}, "$.assist.strength"), ({"power": 1}, "$.assist.power")):
        error = nobody.error(hello("hold", device={"cpi": CPI}, assist=assist))
        assert (error["code"], error["path"]) == ("bad_field", path)
    talk = Talk(greet=asking())
    error = talk.error(events([0.0, 1.0, 2.0, 3.0, 4.0, 0], [0.1, 1.0, 2.0, None, None, 0]))
    assert (error["code"], error["path"]) == ("bad_field", "$.events[1][3]")
    assert "counts" in error["message"]
    assert talk.session.stream is not None
    assert talk.session.stream.events == 0
    plain = Talk()
    error = plain.error({"type": "configure", "assist": {}})
    assert (error["code"], error["path"]) == ("out_of_place", "$.assist")


def test_late_events_are_dropped() -> None:
    rows = reach()
    talk, other = Talk(greet=asking()), Talk(greet=asking())
    for one in (talk, other):
        one.say(events(*rows[:50]))
    answers = talk.say(events(rows[50], rows[3], rows[51]))
    assert [a["code"] for a in answers if a["type"] == "error"] == ["out_of_order"]
    assert cursors(answers) == cursors(other.say(events(*rows[50:52])))


@pytest.mark.parametrize("first", [50, 55])
def test_a_frame_that_the_pipeline_refuses_changes_nothing(
    first: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Refused at event 55: in the middle of a frame, or alone in it."""
    rows = reach()
    part = rows[first : first + 60] if first == 50 else rows[55:56]
    talk, other = Talk(greet=asking()), Talk(greet=asking())
    for one in (talk, other):
        one.say(events(*rows[:first]))
    advance = Pipeline.advance

    def refuses(self: Pipeline, row: tuple[float, ...]) -> tuple[float, ...]:
        return refused(EVENT_FIELD, row[0]) if row[0] == rows[55][0] else advance(self, row)

    monkeypatch.setattr(Pipeline, "advance", refuses)
    error = talk.error(events(*part))
    assert (error["code"], error["path"]) == ("bad_field", "$.events")
    monkeypatch.undo()
    for row in rows[first:]:
        assert talk.say(events(row)) == other.say(events(row))


@pytest.mark.parametrize("column", [0, 1, 2])
@pytest.mark.parametrize("value", [np.nan, 1e30])
def test_an_event_alone_is_refused_as_in_a_table(column: int, value: float) -> None:
    rows = reach()
    talk, other = Talk(greet=asking()), Talk(greet=asking())
    for one in (talk, other):
        one.say(packed(*rows[:50]))
    bad = list(rows[50])
    bad[column] = value
    for part in ([bad], [bad, rows[51]]):
        error = talk.error(packed(*part))
        assert (error["code"], error["path"]) == ("bad_field", f"$.events[0][{column}]")
    assert talk.say(packed(rows[50])) == other.say(packed(rows[50]))


@pytest.mark.parametrize("count", [1, 10])
def test_a_frame_in_which_a_law_fails_changes_nothing(count: int, monkeypatch: pytest.MonkeyPatch) -> None:
    rows = reach()
    talk, other = Talk(greet=asking()), Talk(greet=asking())
    for one in (talk, other):
        one.say(events(*rows[: 56 - count]))
    advance = Pipeline.advance

    def fails(self: Pipeline, row: tuple[float, ...]) -> tuple[float, ...] | None:
        if row[0] == rows[55][0]:
            raise RuntimeError("the law fails")
        return advance(self, row)

    monkeypatch.setattr(Pipeline, "advance", fails)
    with pytest.raises(RuntimeError):
        talk.say(events(*rows[56 - count : 56]))
    monkeypatch.undo()
    for row in rows[56 - count :]:
        assert talk.say(events(row)) == other.say(events(row))


def test_targets_and_trials_see_the_assisted_cursor() -> None:
    rows = reach()
    talk = Talk(greet=asking(), max_events_per_frame=1000)
    talk.say(
        {"type": "targets", "targets": [{"id": "a", "x": 500.0, "y": 450.0, "width": 90.0, "height": 90.0}]}
    )
    talk.say({"type": "trial", "action": "start"})
    answers = talk.say(events(*rows))
    assert [a["type"] for a in answers if a["type"] != "choice"] == ["cursor", "prediction"]
    told = next(a for a in answers if a["type"] == "prediction")
    assert told["targets"][0]["id"] == "a"
    place = cursors(answers)[0]
    for _ in range(2):  # one event in a frame, in a trial and with targets
        rows.append([rows[-1][0] + 0.001, 0.0, 0.0, 1.0, 0.0, 0])
        alone = talk.say(events(rows[-1]))
        assert [a["type"] for a in alone if a["type"] != "choice"] == ["cursor", "prediction"]
        assert "targets" in alone[-1]
    end = {"type": "trial", "action": "end", "target": {"x": place[0], "y": place[1], "width": 20.0}}
    (score,) = [a for a in talk.say(end) if a["type"] == "score"]
    assert score["events"] > 100  # some stand still
    assert score["hold_px"] > 5.0
