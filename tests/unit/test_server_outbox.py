from __future__ import annotations

import json

from hypothesis import given
from hypothesis import strategies as st

from pointpred.protocol.frames import Frame
from pointpred.protocol.server_messages import Choice
from pointpred_server.sessions.outbox import MOST_CHOICES, Outbox


def test_what_is_said_comes_out_in_order_and_once() -> None:
    outbox = Outbox()
    assert not outbox
    outbox.add("a")
    outbox.predict(["p"], 1)
    outbox.add("b")
    assert outbox
    assert outbox.take() == ["a", "p", "b"]
    assert not outbox
    assert outbox.take() == []


def test_the_newest_prediction_takes_the_place_where_it_was_made() -> None:
    outbox = Outbox()
    outbox.predict(["old"], 1)
    outbox.add("a")
    outbox.predict([b"new"], 1)
    outbox.add("b")
    note, slow, *rest = outbox.take()
    assert (note, rest) == ("a", [b"new", "b"])
    assert json.loads(slow)["message"].startswith("1 prediction")


def test_a_frame_of_many_predictions_gives_way_whole() -> None:
    outbox = Outbox()
    outbox.predict([b"3 records"], 3)
    outbox.predict(["1", "2"], 2)
    outbox.predict(["new"], 1)
    assert (outbox.dropped, outbox.dropped_total) == (5, 5)
    slow, new = outbox.take()
    assert (json.loads(slow)["code"], new) == ("slow", "new")
    assert (outbox.dropped, outbox.dropped_total) == (0, 5)


def test_nothing_is_told_to_a_client_that_reads() -> None:
    outbox = Outbox()
    for name in "abc":
        outbox.predict([name], 1)
        assert outbox.take() == [name]
    assert outbox.dropped_total == 0


def test_full_by_notes_and_not_by_what_gave_way() -> None:
    outbox = Outbox(most_notes=2)
    for _ in range(2):
        outbox.add("a")
    assert not outbox.full
    outbox.add("a")
    assert outbox.full
    outbox.take()
    assert not outbox.full
    for _ in range(100):
        outbox.predict([b"many"], 1024)
    assert not outbox.full
    assert len(outbox.take()) == 2


def proposed(outbox: Outbox, *changes: str) -> None:
    for change in changes:
        outbox.add_choice(Choice(change[1:], 0.5, "propose" if change[0] == "+" else "retract"))


def told(frames: list[Frame]) -> list[str]:
    said = [json.loads(frame) for frame in frames]
    return [{"propose": "+", "retract": "-"}[one["action"]] + one["id"] for one in said if "action" in one]


def test_choices_come_out_in_order_among_the_notes() -> None:
    outbox = Outbox()
    outbox.add('"a"')
    outbox.predict(['"p"'], 1)
    proposed(outbox, "+x", "-x")
    outbox.add('"b"')
    frames = outbox.take()
    assert (frames[:2], frames[-1]) == (['"a"', '"p"'], '"b"')
    assert told(frames[2:-1]) == ["+x", "-x"]


def test_choices_do_not_give_way_to_predictions() -> None:
    outbox = Outbox()
    for change in ("+a", "-a", "+b"):
        outbox.predict(['"p"'], 1)
        proposed(outbox, change)
    assert told(outbox.take()) == ["+a", "-a", "+b"]


@given(st.lists(st.sampled_from("abcd"), max_size=400), st.lists(st.integers(0, 400), max_size=3))
def test_who_reads_rarely_knows_what_stands_and_hears_of_every_end(
    names: list[str], reads: list[int]
) -> None:
    """A client that follows what it is told knows, whenever it reads, what a client that reads all knows.

    At most two targets stand at a time: the one predicted, and the one entered.
    """
    outbox, knows = Outbox(), set[str]()
    stands: list[str] = []
    for place, name in enumerate([*names, None]):
        if place in reads or name is None:
            frames = outbox.take()
            assert len(told(frames)) <= MOST_CHOICES
            for change in told(frames):
                assert (change[1:] in knows) == (change[0] == "-")  # only what was proposed ends
                knows ^= {change[1:]}
                assert len(knows) <= 2
            assert knows == set(stands)
        if name is None:
            return
        if name in stands:
            proposed(outbox, f"-{name}")
            stands.remove(name)
            continue
        if len(stands) == 2:
            proposed(outbox, f"-{stands.pop(0)}")
        proposed(outbox, f"+{name}")
        stands.append(name)
    raise AssertionError("the last entry reads")


def test_too_many_choices_are_shortened_and_their_number_is_told() -> None:
    outbox = Outbox(most_notes=100)
    proposed(outbox, "+a")
    outbox.take()
    outbox.add('"note"')
    outbox.predict(['"old"'], 1)
    proposed(outbox, "-a", *("+b", "-b") * 200, "+c")
    outbox.predict(['"new"'], 1)
    assert not outbox.full
    frames = outbox.take()
    (slow,) = (json.loads(one) for one in frames if '"slow"' in str(one))
    changes = told([one for one in frames if "action" in str(one)])
    assert changes[0] == "-a"
    assert changes[-1] == "+c"
    assert slow["message"].startswith(f"1 predictions and {402 - len(changes)} choices gave way")
    assert frames.index('"note"') < frames.index('"new"')
