"""Targets in a session: what is proposed, retracted and told with predictions, and when."""

from __future__ import annotations

from struct import Struct
from typing import Any

import pytest

from pointpred_server.sessions.target_tracker import LIKELIEST
from tests.unit.talking import Talk, events, hello, packed

PLACES = {"left": (-520.0, -20.0), "right": (380.0, -20.0), "up": (-20.0, -520.0)}
PLACES |= {"above": (380.0, -80.0), "below": (380.0, 40.0)}
USUAL = ("left", "right", "up")


def targets(*names: str, **more: Any) -> dict[str, Any]:
    size = {"width": 40.0, "height": 40.0}
    listed = [{"id": name, "x": PLACES[name][0], "y": PLACES[name][1], **size, **more} for name in names]
    return {"type": "targets", "targets": listed}


def reach(begin: float = 0.0, end: float = 0.6, start_s: float = 0.0) -> list[tuple[float, ...]]:
    """A smooth movement of 0.6 s from the origin to the right target, every 10 ms."""
    rows = []
    for i in range(round(begin * 100), round(end * 100) + 1):
        u = i / 60
        rows.append((start_s + i / 100, 400.0 * u**3 * (10 - 15 * u + 6 * u * u), 0.0, None, None, 0))
    return rows


def talk_of(encoding: str = "json", *names: str, precision: float | None = 0.6) -> Talk:
    talk = Talk(greet=hello("minimum-jerk", encoding=encoding))
    if precision is not None:
        talk.say({"type": "configure", "precision": precision})
    talk.say(targets(*(names or USUAL)))
    return talk


def move(talk: Talk, rows: list[tuple[float, ...]], encoding: str = "json") -> list[Any]:
    return [
        answer
        for row in rows
        for answer in talk.say(packed(row) if encoding == "binary" else events(row))
        if isinstance(answer, dict)
    ]


def choices(answers: list[Any]) -> list[tuple[str, str]]:
    return [(one["action"], one["id"]) for one in answers if one["type"] == "choice"]


@pytest.mark.parametrize("encoding", ["json", "binary"])
def test_a_movement_towards_a_target_proposes_it(encoding: str) -> None:
    talk = talk_of(encoding)
    answers = move(talk, reach(end=0.4), encoding)
    told = [one for one in answers if one["type"] == "choice"]
    assert [one["action"] for one in told] == ["propose", "retract"] * (len(told) // 2) + ["propose"]
    assert told[-1]["id"] == "right"
    assert all(0.6 <= one["p"] <= 1.0 for one in told if one["action"] == "propose")
    assert {(one["action"], one["reason"]) for one in told} <= {("propose", "predicted"), ("retract", None)}
    assert [one["t"] for one in told] == sorted(one["t"] for one in told)
    assert told[-1]["t"] <= 0.4


def test_predictions_in_json_carry_the_likeliest_and_packed_ones_do_not() -> None:
    talk = talk_of()
    answers = [one for one in move(talk, reach(end=0.4)) if one["type"] == "prediction"]
    assert len(answers) == 41
    for one in answers:
        shares = [each["p"] for each in one["targets"]]
        assert shares == sorted(shares, reverse=True)
        assert len(shares) == 3
        assert 0.0 < sum(shares) <= 1.0 + 1e-12
    assert answers[-1]["targets"][0]["id"] == "right"
    binary = talk_of("binary")
    frames = [one for row in reach(end=0.05) for one in binary.say(packed(row)) if isinstance(one, bytes)]
    assert [len(one) for one in frames] == [65] * 6


@pytest.mark.parametrize("reply", ["frame", "event"])
def test_a_prediction_tells_the_target_that_is_likeliest_of_all(reply: str) -> None:
    """In JSON its id, in packed records of version 2 its place, in either null where it is none of them."""
    registered = targets("left", "right", "up")
    ids = [one["id"] for one in registered["targets"]]
    texts, records = (
        Talk(greet=hello("minimum-jerk", version=2, reply=reply, encoding=encoding))
        for encoding in ("json", "binary")
    )
    for talk in (texts, records):
        talk.say(registered)
    rows, told, places = reach(), [], []
    for part in (rows[:1], *(rows[i : i + 3] for i in range(1, len(rows), 3))):
        told += [one for one in texts.say(events(*part)) if one["type"] == "prediction"]
        frames = [one for one in records.say(packed(*part)) if isinstance(one, bytes)]
        places += [place for *_, place in Struct("<dddddddBddh").iter_unpack(b"".join(frames))]
    assert [None if place == -1 else ids[place] for place in places] == [one["target"] for one in told]
    for one in told:
        shares = [target["p"] for target in one["targets"]]
        none = 1.0 - sum(shares)
        assert one["target"] == (one["targets"][0]["id"] if shares[0] >= none else None)
    assert (told[0]["target"], told[-1]["target"]) == (None, "right")


def test_of_many_targets_only_the_likeliest_are_told() -> None:
    talk = talk_of()
    many = [{"id": str(i), "x": 50.0 * i, "y": 0.0, "width": 40.0, "height": 40.0} for i in range(30)]
    talk.say({"type": "targets", "targets": many})
    entered, answer = talk.say(events(reach()[0]))  # the cursor begins in the first target
    assert (entered["id"], entered["reason"]) == ("0", "entered")
    assert len(answer["targets"]) == LIKELIEST == 5


def test_without_targets_a_prediction_says_nothing_of_them() -> None:
    talk = Talk()
    assert "targets" not in talk.say(events(reach()[0]))[0]
    talk.say(targets("left"))
    assert "targets" in talk.say(events(reach()[1]))[0]
    talk.say({"type": "targets", "targets": []})
    assert "targets" not in talk.say(events(reach()[2]))[0]
    assert talk.session.stream is not None
    assert talk.session.stream.tracker is None


@pytest.mark.parametrize(
    "end",
    [
        {"type": "reset"},
        {"type": "trial", "action": "start"},
        {"type": "configure", "predictor": "hold"},
        {"type": "configure", "parameters": {}, "predictor": "minimum-jerk"},
        targets("left", "up"),
        {"type": "targets", "targets": []},
    ],
    ids=lambda one: one["type"] + str(len(one)),
)
def test_what_ends_a_movement_or_takes_a_target_away_retracts(end: dict[str, Any]) -> None:
    talk = talk_of()
    assert choices(move(talk, reach(end=0.4)))[-1] == ("propose", "right")
    answers = talk.say(end)
    (retract,) = (one for one in answers if one["type"] == "choice")
    ended = {"type": "choice", "id": "right", "p": 0.0, "action": "retract", "t": 0.4, "reason": None}
    assert retract == ended
    assert choices(talk.say(end)) == []


def test_a_release_of_the_button_retracts() -> None:
    talk = talk_of()
    rows = reach()
    assert choices(move(talk, rows))[-1] == ("propose", "right")
    pressed, released = ((rows[-1][0] + dt, *rows[-1][1:5], b) for dt, b in ((0.02, 1), (0.1, 0)))
    assert choices(move(talk, [pressed, released])) == [("retract", "right")]


@pytest.mark.parametrize("end", [{"type": "reset"}, targets("left")], ids=["reset", "targets"])
def test_what_is_entered_without_a_prediction_is_proposed_and_retracted(end: dict[str, Any]) -> None:
    talk = talk_of(precision=0.999)
    inside = (0.0, 400.0, 0.0, None, None, 0)
    (choice, _) = talk.say(events(inside))
    assert (choice["action"], choice["id"], choice["reason"]) == ("propose", "right", "entered")
    assert choices(talk.say(events((0.1, *inside[1:])))) == []
    assert choices(talk.say(end)) == [("retract", "right")]
    assert choices(talk.say(end)) == []


@pytest.mark.parametrize("change", [{"predictor": "hold"}, {"parameters": {"gain_xi": 1.5}}])
def test_with_another_predictor_a_movement_begins_whatever_its_clock_says(change: dict[str, Any]) -> None:
    """As in a session that had this predictor, and the targets, from the beginning."""
    talk, new = talk_of(), Talk(greet=hello("minimum-jerk"))
    move(talk, reach(begin=0.1, end=0.11, start_s=50.0))  # too little of a movement to be learned from
    for one in (talk, new):
        one.say({"type": "configure", **change})
    new.say({"type": "configure", "precision": 0.6})
    new.say(targets(*USUAL))
    assert move(talk, reach()) == move(new, reach())


def test_with_targets_what_is_said_of_none_of_them_counts_from_then_on() -> None:
    talk, new = talk_of(), Talk(greet=hello("minimum-jerk", parameters={"elsewhere": 0.6}))
    before = move(talk_of(), reach())
    talk.say({"type": "configure", "parameters": {"elsewhere": 0.6}})
    new.say({"type": "configure", "precision": 0.6})
    new.say(targets(*USUAL))
    said = move(talk, reach())
    assert said == move(new, reach())
    assert said != before


def test_what_is_known_of_the_targets_goes_with_the_person() -> None:
    talk = talk_of()
    for start_s in (0.0, 2.0, 4.0):
        move(talk, reach(start_s=start_s))
        talk.say({"type": "reset"})
    (answer,) = talk.say({"type": "person"})
    known = answer["person"]
    assert known.startswith("+")
    again = Talk(greet=hello("minimum-jerk", person=known))
    again.say({"type": "configure", "precision": 0.6})
    again.say(targets(*USUAL))
    move_of = [move(one, reach(start_s=6.0)) for one in (talk, again, talk_of())]
    assert move_of[0] == move_of[1] != move_of[2]
    talk.say({"type": "configure", "predictor": "linear"})
    assert talk.say({"type": "person"})[0]["person"].startswith("+")


def test_what_does_not_concern_the_proposal_keeps_it() -> None:
    talk = talk_of()
    assert choices(move(talk, reach(end=0.4)))[-1] == ("propose", "right")
    kept = (
        targets("right", "up"),
        {"type": "configure", "precision": 0.7},
        {"type": "trial", "action": "end"},
    )
    assert [choices(talk.say(frame)) for frame in kept] == [[], [], []]
    assert choices(talk.say({"type": "reset"})) == [("retract", "right")]


def test_the_precision_decides_when_to_propose() -> None:
    """Three targets lie in nearly the same direction: which of them, is known late."""
    when = []
    for precision in (0.2, 0.6, 1.0):
        talk = talk_of("json", "right", "above", "below", precision=precision)
        answers = move(talk, reach(end=0.55))
        when.append(next((one["t"] for one in answers if one["type"] == "choice"), 1.0))
    assert when == sorted(when)
    assert when[0] < when[-1]


def test_the_precision_may_be_said_before_the_targets_and_at_any_time() -> None:
    before, after = talk_of(precision=0.3), talk_of(precision=None)
    after.say({"type": "configure", "precision": 0.3})
    assert move(before, reach()) == move(after, reach())


def test_precisions_of_0_and_1_are_taken_as_near_as_the_decisions_go() -> None:
    for precision in (0.0, 1.0):
        talk = talk_of(precision=precision)
        assert talk.goes_on()


def test_a_target_of_weight_0_is_never_proposed() -> None:
    talk = talk_of()
    talk.say(targets("left", "right", weight=0.0))
    answers = move(talk, reach())
    assert choices(answers) == []
    assert all(each["p"] == 0.0 for one in answers for each in one["targets"])


def test_the_score_of_a_trial_tells_what_came_of_the_proposals() -> None:
    talk = talk_of()
    goal = {"x": 401.0, "y": 1.0, "width": 40.0}

    def trial(at: float, start: dict[str, Any], end: dict[str, Any]) -> tuple[list[Any], tuple[Any, ...]]:
        talk.say({"type": "trial", "action": "start", **start})
        heard = [one for one in move(talk, reach(start_s=at)) if one.get("action") == "propose"]
        score = talk.say({"type": "trial", "action": "end", **end})[0]
        return heard, tuple(score[name] for name in ("fired", "hit", "wasted", "lead_s"))

    heard, (fired, hit, wasted, lead_s) = trial(0.0, {"target": goal}, {})
    assert (fired, hit) == (len(heard), True)
    assert wasted == sum(one["id"] != "right" for one in heard)
    entered = next(row[0] for row in reach() if row[1] >= 380.0)
    assert lead_s == pytest.approx(entered - heard[-1]["t"])
    assert lead_s > 0.05

    heard, told = trial(2.0, {"target": goal}, {"target": {**goal, "x": -500.0}})
    assert told == (len(heard), False, sum(one["id"] != "left" for one in heard), None)

    nowhere = {"target": {**goal, "x": 5000.0}}
    heard, told = trial(4.0, nowhere, {})
    assert told == (len(heard), False, len(heard), None)

    assert trial(6.0, {}, {})[1] == (None, None, None, None)


def test_a_predictor_scores_better_given_the_targets() -> None:
    def scored(talk: Talk) -> dict[str, Any]:
        talk.say({"type": "trial", "action": "start", "target": {"x": 400.0, "y": 0.0, "width": 40.0}})
        move(talk, reach())
        score: dict[str, Any] = talk.say({"type": "trial", "action": "end"})[0]
        return score

    given, plain = scored(talk_of()), scored(Talk(greet=hello("minimum-jerk")))
    assert (given["events"], given["hold_px"]) == (plain["events"], plain["hold_px"])
    assert given["skill"] > plain["skill"] + 0.1
    for share in ("0.2", "0.5"):
        assert given["by_time"][share] < plain["by_time"][share]


def test_events_that_run_backwards_do_not_reach_the_decisions() -> None:
    plain, late = talk_of(), talk_of()
    rows = reach(end=0.4)
    expected = choices(move(plain, rows))
    found = []
    for row in rows:
        found += choices(late.say(events(row, (-1.0, *row[1:]))))
    assert found == expected
    assert expected[-1] == ("propose", "right")


def test_an_event_counts_more_where_there_are_many_targets() -> None:
    many = [{"id": str(i), "x": 5.0 * i, "y": 0.0, "width": 4.0, "height": 4.0} for i in range(128)]
    talk = Talk(max_events_per_s=90)
    talk.say({"type": "targets", "targets": many})
    answers = talk.say(events(*reach(end=0.09)))  # ten events count as ninety
    assert [one["type"] for one in answers if one["type"] != "choice"] == ["prediction"]
    error, *_ = talk.say(events(reach(begin=0.1)[0]))
    assert (error["code"], talk.closed) == ("too_fast", 1008)
    assert "at most 10 events a second" in error["message"]
