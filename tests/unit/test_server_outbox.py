from __future__ import annotations

import json

from pointpred.server.outbox import Outbox


def test_what_is_said_comes_out_in_order_and_once() -> None:
    outbox = Outbox()
    assert not outbox
    outbox.say("a")
    outbox.predict(["p"], 1)
    outbox.say("b")
    assert outbox
    assert outbox.take() == ["a", "p", "b"]
    assert not outbox
    assert outbox.take() == []


def test_the_newest_prediction_takes_the_place_where_it_was_made() -> None:
    outbox = Outbox()
    outbox.predict(["old"], 1)
    outbox.say("a")
    outbox.predict([b"new"], 1)
    outbox.say("b")
    note, slow, *rest = outbox.take()
    assert (note, rest) == ("a", [b"new", "b"])
    assert json.loads(slow)["message"].startswith("1 prediction")


def test_a_frame_of_many_predictions_gives_way_whole() -> None:
    outbox = Outbox()
    outbox.predict([b"3 records"], 3)
    outbox.predict(["1", "2"], 2)
    outbox.predict(["new"], 1)
    assert (outbox.dropped, outbox.dropped_in_all) == (5, 5)
    slow, new = outbox.take()
    assert (json.loads(slow)["code"], new) == ("slow", "new")
    assert (outbox.dropped, outbox.dropped_in_all) == (0, 5)


def test_nothing_is_told_to_a_client_that_reads() -> None:
    outbox = Outbox()
    for name in "abc":
        outbox.predict([name], 1)
        assert outbox.take() == [name]
    assert outbox.dropped_in_all == 0


def test_full_by_notes_and_not_by_what_gave_way() -> None:
    outbox = Outbox(most_notes=2)
    for _ in range(2):
        outbox.say("a")
    assert not outbox.full
    outbox.say("a")
    assert outbox.full
    outbox.take()
    assert not outbox.full
    for _ in range(100):
        outbox.predict([b"many"], 1024)
    assert not outbox.full
    assert len(outbox.take()) == 2
