"""The ledger: by hand, and over movements in a row, where its account is that of the offline scorer."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred import EventColumns, PointerEvent, Prediction, PredictionColumns
from pointpred.records import FloatArray, prediction_row
from pointpred.scoring import target_choice as replaying
from pointpred.targets import Chooser, Ledger, Movement, around
from pointpred.targets.posterior import FITTED
from pointpred.targets.rectangles import table
from tests.aimed import Told

PLACES = [around("left", -400.0, 0.0, 40.0), around("right", 400.0, 0.0, 40.0), around("mid", 0.0, 0.0, 40.0)]
IDS = [place.id for place in PLACES]
WAYS = [("right", 0.0, 400.0), ("left", 400.0, -400.0), ("mid", -400.0, 0.0), ("right", 0.0, 400.0)]
ASK = 0.6
ELSEWHERE, LEAST = 0.02, (0.0, 3.0)  # as an aim and a chooser have them unless told otherwise


def way(begin_s: float, start: float, end: float, beside: float) -> list[PointerEvent]:
    """A reach of 0.6 s from where the last one ended."""
    s = np.linspace(0.0, 1.0, 61)
    x = start + (end - start) * (10 * s**3 - 15 * s**4 + 6 * s**5)
    return [PointerEvent(begin_s + 0.01 * i, place, beside) for i, place in enumerate(x.tolist())]


def movements(beside: float) -> list[tuple[str, list[PointerEvent], list[Prediction]]]:
    found = []
    for i, (right, start, end) in enumerate(WAYS):
        events = way(0.7 * i, start, end, beside)
        law = Prediction(0.0, end, beside, (400.0, 0.0, 400.0), "ballistic", None, None)
        claims = [law] * len(events)
        found.append((right, events, claims))
    return found


def offline(right: str, events: list[PointerEvent], claims: list[Prediction]) -> FloatArray:
    rows, laid = EventColumns.of_events(events).table, table(PLACES)
    answers = np.full((len(rows), len(PredictionColumns.names)), np.nan)
    for row, claim in zip(answers, claims, strict=True):
        row[:] = prediction_row(claim)
    shares, out = np.empty((len(rows), len(laid) + 1)), np.empty(replaying.ACCOUNT)
    replaying.weigh(rows, answers, laid, FITTED, ELSEWHERE, shares)
    replaying.account(rows, answers, laid, shares, IDS.index(right), ASK, *LEAST, out)
    return out


def live(how: str, beside: float) -> tuple[list[Movement], Chooser]:
    """The account of each movement where it is closed at the press, at the release, or without a button."""
    told = Told(PLACES)
    chooser, done = Chooser(told, precision=ASK), []

    def take(events: list[PointerEvent], claims: list[Prediction]) -> None:
        for event, claim in zip(events, claims, strict=True):
            told.take(claim, event)
            chooser.update()

    for right, events, claims in movements(beside):
        take(events, claims)
        last = events[-1]
        press = PointerEvent(last.t + 0.01, last.x, last.y, buttons=1)
        release = PointerEvent(last.t + 0.02, last.x, last.y)
        if how == "press":
            take([press], claims[:1])
            done.append(chooser.finish(right))
            take([release], claims[:1])
        elif how == "release":
            take([press, release], claims[:2])
            done.append(chooser.finish(right))
        else:
            done.append(chooser.finish(right))
    return done, chooser


@pytest.mark.parametrize("how", ["press", "release", "no button"])
@pytest.mark.parametrize("beside", [0.0, 30.0])
def test_the_ledger_and_the_scorer_agree(how: str, beside: float) -> None:
    done, chooser = live(how, beside)
    for account, (right, events, claims) in zip(done, movements(beside), strict=True):
        found = offline(right, events, claims)
        counted = (account.proposed, account.proposed - account.wasted, account.retracted, account.hit)
        assert counted == tuple(found[: replaying.HIT + 1])
        assert account.lead_entry_s is not None
        late = {"press": 0.01, "release": 0.02, "no button": 0.0}[how]
        assert account.lead_entry_s == pytest.approx(found[replaying.LEAD_ENTRY] + (late if beside else 0.0))
        assert account.lead_click_s == pytest.approx(found[replaying.LEAD_CLICK] + late)
    assert [one.retracted for one in done] == [0] * len(WAYS)
    assert chooser.ledger.coverage == chooser.ledger.precision == 1.0


def test_what_is_withdrawn_while_it_stands_is_counted() -> None:
    told = Told(PLACES)
    chooser = Chooser(told, precision=ASK)
    right, events, claims = movements(0.0)[0]
    for event, claim in zip(events[:40], claims[:40], strict=True):
        told.take(claim, event)
        chooser.update()
    assert chooser.standing == right
    told.aim.register([PLACES[0]])
    chooser.follow_targets()
    assert chooser.finish(right).retracted == 1


def test_nothing_is_withdrawn_where_nothing_stands() -> None:
    ledger = Ledger()
    ledger.retract(0.1, "a")
    ledger.propose(0.2, "a")
    ledger.retract(0.3, "b")
    ledger.end(0.4, "a")
    ledger.retract(0.5, "a")
    assert ledger.finish(0.6, "a").retracted == 0


def test_what_a_release_ended_leads_only_a_movement_that_is_closed_there() -> None:
    for closed, hit in ((0.4, True), (0.5, False)):
        ledger = Ledger()
        ledger.propose(0.2, "a")
        ledger.end(0.4, "a")
        assert ledger.finish(closed, "a").hit == hit


def test_what_is_entered_is_counted_apart_and_is_no_hit() -> None:
    """The account of predictions stays what it was: the scorer knows nothing of entries."""
    pipeline = Told(PLACES)
    chooser = Chooser(pipeline, precision=0.999, least_lead_s=10.0)
    right, events, _ = movements(0.0)[0]
    for event in events:
        pipeline.take(None, event)
        chooser.update()
    account = chooser.finish(right)
    assert (account.proposed, account.hit, account.wasted, account.lead_entry_s) == (0, False, 0, None)
    assert account.entered == 2  # the one it set out from, and the one it went to
    told = chooser.ledger.summary()
    assert (told["entered"], told["proposed"], told["hit"], told["precision"]) == (2, 0, 0, None)


def test_a_ledger_by_hand() -> None:
    ledger = Ledger()
    ledger.propose(0.1, "wrong")
    ledger.retract(0.2, "wrong")
    ledger.propose(0.2, "right")
    ledger.enter(0.5, "right")
    ledger.enter(0.7, "right")  # came back after an overshoot: the first time counts
    first = ledger.finish(0.9, "right")
    assert (first.proposed, first.hit, first.wasted, first.retracted) == (2, True, 1, 1)
    assert first.lead_entry_s == pytest.approx(0.3)
    assert first.lead_click_s == pytest.approx(0.7)
    ledger.enter(0.3, "right")
    ledger.propose(0.4, "right")  # too late to lead
    late = ledger.finish(0.6, "right")
    assert (late.proposed, late.hit, late.wasted) == (1, False, 0)
    ledger.propose(0.1, "right")
    assert ledger.finish(0.5, None).wasted == 1
    assert ledger.finish(0.5, "right").proposed == 0
    assert ledger.precision == pytest.approx(2 / 4)
    assert ledger.coverage == pytest.approx(1 / 4)
    assert ledger.proposals_a_movement == pytest.approx(1.0)
    told = ledger.summary()
    assert (told["movements"], told["hit"], told["wasted"], told["retracted"]) == (4, 1, 2, 1)
    assert told["median_lead_entry_s"] == pytest.approx(0.3)


def test_a_click_beside_the_target_ends_its_lead() -> None:
    ledger = Ledger()
    ledger.propose(0.2, "a")
    done = ledger.finish(0.6, "a")
    assert done.hit
    assert (done.lead_entry_s, done.lead_click_s) == (pytest.approx(0.4), pytest.approx(0.4))


def test_a_ledger_that_is_never_closed_stays_bounded() -> None:
    ledger = Ledger()
    for i in range(5000):
        ledger.propose(i, i)
        ledger.enter(i, i)
    assert ledger.account.rows == len(ledger.rows) == 1000
    ledger.drop()
    assert ledger.finish(0.0, 1).proposed == 0


def test_nothing_yet() -> None:
    ledger = Ledger()
    assert ledger.precision is ledger.coverage is ledger.proposals_a_movement is None
    assert ledger.summary()["median_lead_click_s"] is None
