"""Lab Streaming Layer: positions in, predictions out, over real streams that stay on this machine."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from pointpred import PointerEvent, build
from pointpred.cli.app import app
from pointpred.devices.cursor_paths import PositionPath
from pointpred.devices.lsl import CHANNELS, Channels, LslInlet, LslOutlet, ahead_s, channels_of
from pointpred.errors import ParameterError, SourceError
from pointpred.live.follow import silence
from pointpred.live.playback import PlayedSource
from pointpred.live.session import LiveSession

CONFIGURATION = """[ports]
IPv6 = disable
[multicast]
ResolveScope = machine
MachineAddresses = {127.0.0.1}
ListenAddress = 127.0.0.1
[lab]
KnownPeers = {127.0.0.1}
[log]
level = -2
"""
PATIENCE_S = 60.0
STAMP_S = 0.001
"""The time correction of a stream from the same machine is below this."""


@pytest.fixture(scope="module")
def lsl(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    """The library, told before its first use to announce nothing beyond this machine."""
    file = tmp_path_factory.mktemp("lsl") / "lsl_api.cfg"
    file.write_text(CONFIGURATION)
    before = os.environ.get("LSLAPICFG")
    os.environ["LSLAPICFG"] = str(file)
    yield pytest.importorskip("pylsl", reason="pylsl is not installed: it comes with the extra live")
    if before is None:
        del os.environ["LSLAPICFG"]
    else:
        os.environ["LSLAPICFG"] = before


def sender(lsl: Any, name: str, labels: list[str], kind: Any = None) -> Any:
    about = lsl.StreamInfo(name, "Position", len(labels), 0.0, kind or lsl.cf_double64, f"id of {name}")
    about.set_channel_labels(labels)
    return lsl.StreamOutlet(about)


def test_positions_come_in_and_predictions_go_out_with_the_times_of_the_events(lsl: Any) -> None:
    name = f"mouse {os.getpid()}"
    outlet = sender(lsl, name, ["Buttons", "MouseY", "MouseX", "dx", "dy"])
    places = [(float(i), 0.5 * i * i) for i in range(30)]
    with LslInlet(name, wait_s=PATIENCE_S) as source:
        session = LiveSession(source, PositionPath(source.words), build("linear"))
        sent = LslOutlet("linear", source)
        session.watchers.append(sent.take)
        reader = lsl.StreamInlet(lsl.resolve_byprop("name", "pointpred", 1, PATIENCE_S)[0])
        reader.open_stream(PATIENCE_S)
        begun = lsl.local_clock()
        stamps = [begun + 0.01 * i for i in range(30)]
        for stamp, (x, y) in zip(stamps, places, strict=True):
            outlet.push_sample([3.0, y, x, 2.0, -1.0], stamp)
        outlet.push_sample([0.0, math.nan, 1.0, 2.0, 0.0], begun + 1.0)
        pairs: list[Any] = []
        until = time.monotonic() + PATIENCE_S
        while (len(pairs) < 30 or not source.unreadable) and time.monotonic() < until:
            pairs += session.advance(0.1)
        events = [event for event, _ in pairs]
        ahead = ahead_s(lsl)
        assert [(event.x, event.y) for event in events] == places
        assert {(event.dx, event.dy, event.buttons) for event in events} == {(2.0, -1.0, 3)}
        assert (source.unreadable, source.counts) == (1, True)
        off = [event.t - ahead - stamp for event, stamp in zip(events, stamps, strict=True)]
        assert max(map(abs, off)) < STAMP_S
        assert "monotonic" in source.clock
        about = reader.info(PATIENCE_S)
        rows: list[Any] = []
        times: list[float] = []
        while len(rows) < 30 and time.monotonic() < until:
            sample, stamp = reader.pull_sample(PATIENCE_S)
            rows, times = [*rows, sample], [*times, stamp]
    pipeline = build("linear")
    batch = [pipeline.update(event) for event in events]
    assert [row[0] for row in rows] == [event.t for event in events]
    expected = [[math.nan] * 2 if one is None else [one.x, one.y] for one in batch]
    assert np.array_equal(np.array(rows)[:, 1:3], np.array(expected), equal_nan=True)
    assert about.get_channel_labels() == list(CHANNELS)
    assert about.get_channel_units() == list(CHANNELS.values())
    clock = about.desc().child("clock")
    offset = float(clock.child_value("offset_s"))
    assert np.allclose(np.array(times) - [event.t for event in events], offset, atol=1e-9)
    assert abs(offset + ahead) < STAMP_S
    assert clock.child_value("source") == source.clock
    assert float(clock.child_value("correction_s")) == source.offset_s
    phases = about.desc().child_value("phases").split()
    assert [phases[int(row[8])] for row, one in zip(rows, batch, strict=True) if one] == [
        one.phase for one in batch if one
    ]


def test_a_recording_that_is_played_is_stamped_when_it_is_sent(lsl: Any) -> None:
    from tests.devices.test_live_replay import parts

    outlet = LslOutlet("hold", PlayedSource("replay", "none", parts()))
    (found,) = lsl.resolve_byprop("source_id", outlet._outlet.get_info().source_id(), 1, PATIENCE_S)
    reader = lsl.StreamInlet(found)
    reader.open_stream(PATIENCE_S)
    before = lsl.local_clock()
    outlet.take([(PointerEvent(7.5, 1.0, 2.0), None)])
    sample, stamp = reader.pull_sample(PATIENCE_S)
    assert sample[0] == 7.5
    assert np.isnan(sample[1:]).all()
    assert before <= stamp <= lsl.local_clock()
    assert reader.info(PATIENCE_S).desc().child("clock").child_value("offset_s") == ""


def test_a_stream_that_is_not_there_or_holds_words_is_refused_and_the_others_are_named(lsl: Any) -> None:
    kept = sender(lsl, f"words {os.getpid()}", ["x", "y"], lsl.cf_string)
    with pytest.raises(SourceError, match=f"words {os.getpid()}"), LslInlet("none of these", wait_s=0.3):
        pass
    with pytest.raises(SourceError, match="words"), LslInlet(f"words {os.getpid()}", wait_s=PATIENCE_S):
        pass
    del kept


@pytest.mark.parametrize(
    ("labels", "expected"),
    [
        (["x", "y"], Channels(0, 1)),
        ([None, None, None], Channels(0, 1)),
        ([], Channels(0, 1)),
        (["pos_y", "X [px]", "dY", "dX", "Button"], Channels(1, 0, 3, 2, 4)),
        (["x_px", "y_px", "x"], Channels(0, 1)),
    ],
)
def test_channels_are_known_by_their_labels(labels: list[str | None], expected: Channels) -> None:
    assert channels_of("one", max(len(labels), 2), labels) == expected


@pytest.mark.parametrize(
    ("count", "labels"), [(1, ["x"]), (2, ["Fz", "Cz"]), (2, ["x", None]), (2, ["x", "t", "y"])]
)
def test_a_stream_without_a_position_is_refused(count: int, labels: list[str | None]) -> None:
    with pytest.raises(SourceError):
        channels_of("one", count, labels)


@pytest.mark.parametrize(
    ("labels", "rows", "expected"),
    [
        (["x", "y"], [(5.0, 5.0), (5.0, 5.0), (7.0, 4.0)], [(0.0, 0.0), (0.0, 0.0), (2.0, -1.0)]),
        (["x", "y", "dx", "dy"], [(5.0, 5.0, 0.0, 3.0), (9.0, 5.0, 0.0, 0.0)], [(0.0, 3.0), (0.0, 0.0)]),
    ],
)
def test_a_stream_that_moves_is_known_to_move(labels: list[str], rows: Any, expected: Any) -> None:
    inlet = LslInlet("one")
    inlet._channels = channels_of("one", len(labels), labels)
    reports = [inlet._report(row, 0.0) for row in rows]
    assert [(report.dx, report.dy) for report in reports if report is not None] == expected


def test_a_silent_stream_is_named_without_advice_on_mice() -> None:
    words = silence(LslInlet("eye"))
    assert "'eye'" in words
    assert "devices list" not in words


@pytest.mark.parametrize(
    "options", [["--replay", "sample"], ["--transfer", "constant:4"], ["--cursor", "motor"]]
)
def test_options_of_a_mouse_are_refused_beside_a_stream(options: list[str], monkeypatch: Any) -> None:
    monkeypatch.setattr(LslInlet, "__enter__", lambda self: self)
    ended = CliRunner().invoke(app, ["live", "--device", "lsl:any", *options])
    assert isinstance(ended.exception, ParameterError)
    assert options[0] in str(ended.exception)
