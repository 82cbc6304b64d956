"""The Python client speaks to the real session: answers, errors in words, and the same bits."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Iterator
from functools import partial

import numpy as np
import pytest
from msgspec import UNSET

from pointpred import EventColumns, PointerEvent, build, client, run
from pointpred.client import ServiceError
from pointpred.client.session import service_address
from pointpred.datasets import sample
from pointpred.errors import EventError, ParameterError, SourceError
from pointpred.protocol.frames import pack_events, packable, unpack_predictions
from pointpred.protocol.server_messages import Limits, PredictionMessage, Score
from tests.server.listener import Listener
from tests.server.running import PATIENCE_S

connect = partial(client.connect, timeout_s=PATIENCE_S)
connect_async = partial(client.connect_async, timeout_s=PATIENCE_S)


@pytest.fixture(scope="module")
def listener() -> Iterator[Listener]:
    with Listener() as service:
        yield service


MOVEMENT = sample().rows(0)
CPI = 2000.0


@pytest.mark.parametrize("encoding", ["binary", "json"])
@pytest.mark.parametrize("predictor", ["switched", "minimum-jerk", "kinematic-adaptive"])
def test_every_prediction_is_that_of_the_batch(listener: Listener, encoding: str, predictor: str) -> None:
    wanted = run(build(predictor, cpi=CPI), MOVEMENT).table
    wanted[np.isnan(wanted[:, 1]), 1:] = np.nan
    options = {"predictor": predictor, "encoding": encoding, "device": {"cpi": CPI}}
    with connect(listener.url, reply="event", **options) as connection:
        for first in range(0, len(MOVEMENT), 500):
            connection.send(MOVEMENT.rows(first, first + 500))
            heard = connection.columns().table
            assert np.array_equal(heard, wanted[first : first + 500], equal_nan=True)
    with connect(listener.url, reply="frame", **options) as connection:
        assert connection.send(MOVEMENT.rows(0, 300)) == 5, "frames of 64 events"
        *_, newest = connection.predictions()
        assert newest.t == wanted[299, 0]
        x = math.nan if newest.x is None else newest.x
        assert np.array_equal(x, wanted[299, 1], equal_nan=True)


def test_records_and_rows_are_events(listener: Listener) -> None:
    with connect(listener.url, predictor="hold", reply="event") as connection:
        connection.send([PointerEvent(0.0, 1.0, 2.0), (0.01, 3, 4), (0.01, 5, 6, 7, -8, 1)])
        assert [(p.t, p.x, p.y) for p in connection.predictions()] == [(0, 1, 2), (0.01, 3, 4), (0.01, 5, 6)]
        assert list(connection.predictions()) == []  # nothing is awaited any more
    assert listener.binary()[-1] == pack_events(
        EventColumns.of_events(
            [PointerEvent(0.0, 1.0, 2.0), PointerEvent(0.01, 3, 4), PointerEvent(0.01, 5, 6, 7, -8, 1)]
        ).table
    )


def test_frames_keep_to_the_limits() -> None:
    rows = [(i / 7, i / 3, i / 9) for i in range(100)]
    for limits, encoding in (
        (Limits(max_events_per_frame=9), "binary"),
        (Limits(max_frame_bytes=900), "json"),
    ):
        with Listener(limits=limits) as listener:
            with connect(listener.url, predictor="hold", reply="event", encoding=encoding) as connection:
                assert connection.send(rows) > 7
                assert len(connection.columns()) == 100
            for frame in listener.frames:
                assert len(frame) <= limits.max_frame_bytes
            if encoding == "json":
                heard = [tuple(row[:3]) for one in listener.messages("events") for row in one["events"]]
                assert heard == rows


def test_a_trial_targets_and_changes_are_answered(listener: Listener) -> None:
    with connect(listener.url, predictor="switched") as connection:
        assert connection.targets([{"id": "a", "x": 1, "y": 2, "width": 3, "height": 4}]) == 1
        connection.trial("start", {"x": 400, "y": 300, "width": 20}, {"block": 2, "participant": "p7"})
        connection.send(MOVEMENT)
        score = connection.trial("end")
        assert isinstance(score, Score)
        assert score.time_averaged_px is not None
        assert connection.configure(predictor="hold", reply="event").predictor == "hold"
        connection.columns()
        connection.reset()
        connection.send([(0.0, 1, 1), (0.5, 2, 2)])
        assert connection.columns().t.tolist() == [0.0, 0.5]


@pytest.mark.parametrize("encoding", ["json", "binary"])
def test_predictions_name_the_target_that_is_likeliest(listener: Listener, encoding: str) -> None:
    end = sample().trials[0]
    box = {"x": end.target_x - 15.0, "y": end.target_y - 15.0, "width": 30.0, "height": 30.0}
    with connect(listener.url, predictor="switched", encoding=encoding, reply="event") as connection:
        assert connection.welcome.version == 2
        connection.send(MOVEMENT)
        assert {one.target for one in connection.predictions()} == {UNSET}
        connection.reset()
        connection.targets([{"id": "elsewhere", **box, "x": 0.0, "y": 0.0}, {"id": "there", **box}])
        connection.send(MOVEMENT)
        told = [one.target for one in connection.predictions()]
        assert (told[0], told[-1]) == (None, "there")
        connection.targets([])
        connection.reset()
        connection.send(MOVEMENT)
        assert {one.target for one in connection.predictions()} == {UNSET}


def test_the_cursor_of_a_session_with_assistance_is_heard(listener: Listener) -> None:
    with connect(listener.url, device={"cpi": 1000}, assist={"strength": 0.0, "gain": 3.0}) as connection:
        assert connection.cursor is None
        connection.send([(0.1 + i / 100, 0.0, 0.0, 2.0, 0.0, 0) for i in range(5)])
        connection.columns()
        assert connection.cursor is not None
        assert connection.cursor.x > 0.0
        assert connection.cursor.added_px == 0.0
        connection.configure(assist={"strength": 0.5})


def test_a_hello_that_does_not_fit_is_refused_before_anything_is_sent() -> None:
    for wrong in ({"assist": {"strength": 7}}, {"colour": "blue"}):
        with pytest.raises(ParameterError, match=next(iter(wrong))):
            connect("ws://127.0.0.1:9/v1/stream", **wrong)


REACH = [(i / 100, 400.0 * (i / 60) ** 2 * (3 - 2 * i / 60), 0.0) for i in range(40)]
"""Two thirds of a movement to the right."""
PLACES = [
    {"id": name, "x": x, "y": -20.0, "width": 40.0, "height": 40.0}
    for name, x in (("left", -420.0), ("right", 380.0))
]


@pytest.mark.parametrize("encoding", ["json", "binary"])
def test_choices_come_with_the_predictions_of_their_events(listener: Listener, encoding: str) -> None:
    with connect(listener.url, predictor="minimum-jerk", encoding=encoding) as connection:
        connection.configure(precision=0.6)
        assert connection.targets(PLACES) == 2
        stands = None
        for row in REACH:
            connection.send([row])
            (prediction,) = connection.predictions()
            told = connection.choices()
            assert all(choice.t == prediction.t for choice in told)
            stands = told[-1].id if told else stands
            assert bool(prediction.targets) == (encoding == "json")
        assert connection.proposed == stands == "right"
        if encoding == "json":
            assert prediction.targets[0].id == "right"
        connection.targets(PLACES[:1])
        (retract,) = connection.choices()
        assert (retract.id, retract.action, retract.t) == ("right", "retract", REACH[-1][0])
        assert connection.proposed is None
        assert connection.choices() == []


def test_what_is_refused_is_said_in_words(listener: Listener) -> None:
    with connect(listener.url, predictor="hold") as connection:
        with pytest.raises(ServiceError) as refused:
            connection.configure(predictor="swiched")
        error = refused.value
        assert (error.code, error.path, error.recoverable) == ("unknown_predictor", "$.predictor", True)
        assert (error.field, error.value) == ("predictor", "swiched")
        connection.send([(1.0, 0, 0)])
        connection.send([(0.5, 0, 0)])
        connection.send([(2.0, 0, 0)])
        heard: list[PredictionMessage] = []
        with pytest.raises(ServiceError, match=r"out_of_order at \$\.events\[0\]\[0\]"):
            heard.extend(connection.predictions())
        heard.extend(connection.predictions())
        assert [p.t for p in heard] == [1.0, 2.0]  # nothing heard was lost
        with pytest.raises(EventError, match="binary records hold whole counts"):
            connection.send([(3.0, 0, 0, 0.5, 0, 0)])
        with pytest.raises(EventError, match=r"t, x, y\[, dx, dy, buttons\], received 2 values"):
            connection.send([(3.0, 0)])
        with pytest.raises(ParameterError, match="trial"):
            connection.trial("stop")
    with pytest.raises(ServiceError, match="unknown_predictor"):
        connect(listener.url, predictor="nobody")
    with pytest.raises(ParameterError, match="hello"):
        connect(listener.url, reply="often")
    with pytest.raises(SourceError, match=r"cannot connect to ws://127\.0\.0\.1:1/v1/stream"):
        connect("ws://127.0.0.1:1")


def test_a_service_that_leaves_is_noticed() -> None:
    with Listener() as listener:
        connection = connect(listener.url, predictor="hold")
        listener.stop()
        with pytest.raises(SourceError, match="closed the session: 1001"):
            connection.targets([])
        connection.close()
        connection.close()


def test_the_last_words_of_the_service_are_heard() -> None:
    with Listener(limits=Limits(max_events_per_s=10)) as listener, connect(listener.url) as connection:
        connection.send([(i / 100, i, i) for i in range(50)])
        with pytest.raises(ServiceError, match="too_fast"):
            list(connection.predictions())


def test_the_same_calls_for_asyncio(listener: Listener) -> None:
    async def talk() -> None:
        async with await connect_async(listener.url, predictor="hold", reply="event") as connection:
            await connection.send([(0.0, 1, 2), (0.1, 3, 4)])
            assert [p.x async for p in connection.predictions()] == [1, 3]
            assert await connection.targets([]) == 0
            await connection.trial("start")
            await connection.send(MOVEMENT.rows(0, 700))
            assert len(await connection.columns()) == 700
            score = await connection.trial("end")
            assert score is not None
            assert (await connection.configure(predictor="linear")).predictor == "linear"
            with pytest.raises(ServiceError, match="unknown_predictor"):
                await connection.configure(predictor="nobody")
            await connection.reset()

    asyncio.run(talk())
    with pytest.raises(SourceError, match="cannot connect"):
        asyncio.run(connect_async("http://127.0.0.1:1"))


@pytest.mark.parametrize(
    ("given", "wanted"),
    [
        ("http://127.0.0.1:8765", "ws://127.0.0.1:8765/v1/stream"),
        ("https://lab.example/", "wss://lab.example/v1/stream"),
        ("ws://127.0.0.1:1/own", "ws://127.0.0.1:1/own"),
        ("ws://127.0.0.1:1?a=b", "ws://127.0.0.1:1/v1/stream?a=b"),
    ],
)
def test_addresses(given: str, wanted: str) -> None:
    assert service_address(given) == wanted
    with pytest.raises(ParameterError, match="must be ws"):
        service_address("127.0.0.1:8765")


def test_counts_that_do_not_fit_are_not_packed() -> None:
    assert packable(EventColumns.of([0.0, 1.0], [0, 0], [0, 0], [1, np.nan], [32767, np.nan]))
    assert not packable(EventColumns.of([0.0], [0], [0], [0.5], [0]))
    assert not packable(EventColumns.of([0.0], [0], [0], [0], [-32768]))
    assert unpack_predictions(b"") == ([], [])
