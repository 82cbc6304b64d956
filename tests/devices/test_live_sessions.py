"""Sessions of a device: the same predictions as everywhere, and everything that is lost is counted."""

from __future__ import annotations

import threading
from collections.abc import Sequence

import numpy as np
import pytest

from pointpred import EventColumns, PointerEvent, build, run
from pointpred.clock import Instant
from pointpred.devices.cursor_paths import MotorPath, SurfacePath, TransferPath
from pointpred.devices.source import PlaceReport, Report
from pointpred.live.session import DelayHistogram, LiveSession, ReportRate
from pointpred.records import Pair
from pointpred.transfer import ConstantGain, PixelTransfer, SigmoidGain
from tests.devices.live_fakes import SURFACE, FakeMouse, reach, touches

REACH = reach(3.0, (900.0, -400.0))


def test_predictions_are_those_of_a_batch_bit_for_bit() -> None:
    session = LiveSession(FakeMouse(REACH), MotorPath(800.0), build("switched", cpi=800.0))
    pairs = session.advance(0.0)
    assert len(pairs) == len(REACH)
    events = EventColumns.of_events([event for event, _ in pairs])
    batch = list(run(build("switched", cpi=800.0), events).predictions())
    assert [prediction for _, prediction in pairs] == batch
    assert any(prediction is not None and prediction.phase == "ballistic" for prediction in batch)


def test_counts_are_integrated_where_there_is_no_cursor() -> None:
    session = LiveSession(FakeMouse(REACH), MotorPath(cpi=1920.0, dpi=96.0), build("hold"))
    last, _ = session.advance(0.0)[-1]
    assert (last.x, last.y) == (pytest.approx(900.0 * 96 / 1920), pytest.approx(-400.0 * 96 / 1920))
    assert (session.space, "motor space" in session.words) == ("motor", True)


def test_without_a_resolution_a_count_is_a_pixel_and_the_words_say_so() -> None:
    session = LiveSession(FakeMouse(REACH), None, build("hold"))
    last, _ = session.advance(0.0)[-1]
    assert (last.x, last.y) == (900.0, -400.0)
    assert "no CPI" in session.words


def test_a_transfer_function_moves_the_cursor_as_it_does_offline() -> None:
    path = TransferPath(SigmoidGain(), cpi=2000.0)
    session = LiveSession(FakeMouse(REACH), path, build("hold"))
    last, _ = session.advance(0.0)[-1]
    t, dx, dy = ([getattr(report, name) for report in REACH] for name in ("t", "dx", "dy"))
    moved = PixelTransfer(SigmoidGain(), cpi=2000.0).run(np.array(t), np.array(dx), np.array(dy))
    assert (last.x, last.y) == tuple(moved.sum(axis=0))
    assert session.space == "transfer"


def test_a_contact_begins_a_movement_as_in_a_batch() -> None:
    reports = touches((0.1, 0.2), (0.7, 0.9))
    session = LiveSession(FakeMouse(reports), SurfacePath(), build("switched"))
    assert (session.space, session.words) == ("screen", "the device's own")
    pairs = session.advance(0.0)
    table = EventColumns.of_events([event for event, _ in pairs]).table
    begin = np.array([report.place.begins for report in reports])
    assert begin.sum() == 2
    batch = list(run(build("switched"), EventColumns(table, begin)).predictions())
    assert [prediction for _, prediction in pairs] == batch
    assert session.words == "the device's own, px of the surface, 508 x 254 mm at 96 px per inch"
    assert table[0, 1:3] == pytest.approx((0.1 * 1920, 0.2 * 960))
    assert np.isnan(table[:, 3:5]).all()


def test_a_mouse_that_is_followed_after_a_tablet_goes_on_by_counts() -> None:
    reports: list[Report] = [*touches((0.1, 0.2)), Report(9.0, 3, 4), Report(9.1, 1, 0)]
    source = FakeMouse(reports)
    session = LiveSession(source, SurfacePath(MotorPath(), screen=(100.0, 100.0), whole=True), build("hold"))
    pairs = session.advance(0.0)
    assert len(pairs) == len(reports)
    assert [(event.x, event.dx) for event, _ in pairs[-2:]] == [(3.0, 3.0), (4.0, 1.0)]
    assert max(event.x for event, _ in pairs) <= 100.0
    source.put([Report(9.2, 1, 0)])
    assert session.advance(0.0)[0][0].x == 5.0
    assert session.space == "motor"
    assert SURFACE.scale(96.0, whole=True)[:2] == (1920.0, 1080.0)
    assert all(isinstance(report, PlaceReport) for report in reports[:-2])


def test_a_report_that_runs_backwards_is_refused_counted_and_said() -> None:
    reports = [Report(1.0, 1, 0), Report(0.5, 1, 0), Report(1.1, 1, 0)]
    session = LiveSession(FakeMouse(reports), None, build("hold"))
    assert [event.t for event, _ in session.advance(0.0)] == [1.0, 1.1]
    state = session.state()
    assert (state.reports, state.refused) == (3, 1)
    assert state.why is not None
    assert "0.5" in state.why


def test_a_transfer_path_takes_a_late_report_as_no_movement() -> None:
    path = TransferPath(ConstantGain(4.0), cpi=96.0)
    events = path.events([Report(1.0, 2, 0), Report(0.5, 2, 0), Report(1.1, 2, 0)])
    assert [event.x for event in events] == [8.0, 8.0, 16.0]
    assert path.refused == 1


def test_what_the_source_lost_is_part_of_the_state() -> None:
    mouse = FakeMouse()
    mouse.put(Report(0.001 * i, 1, 0) for i in range(65536 + 7))
    mouse.unreadable, mouse.resynchronised, mouse.plugged = 3, 2, False
    session = LiveSession(mouse, None, build("hold"))
    session.advance(0.0)
    state = session.state()
    assert (state.lost, state.unreadable, state.resynchronised, state.plugged) == (7, 3, 2, False)
    assert state.reports == 65536


def test_delays_run_from_the_stamp_to_the_prediction() -> None:
    moments = map(Instant, [10.0, 10.25, 10.5, 11.0, 11.0])
    reports = [Report(10.0, 1, 0), Report(10.2, 1, 0)]
    session = LiveSession(FakeMouse(reports), None, build("hold"), clock=lambda: next(moments))
    session.advance(0.0)
    state = session.state()
    assert session.delays.longest == pytest.approx(0.3)
    assert state.delay_p99_s == pytest.approx(0.3)
    assert state.delay_p50_s == pytest.approx(0.25, rel=0.05)


def test_a_place_that_is_corrected_later_is_no_late_prediction() -> None:
    class Corrected(MotorPath):
        def events(self, reports: Sequence[Report]) -> list[PointerEvent]:
            return super().events(reports) or [PointerEvent(10.0, 7.0, 0.0, 0.0, 0.0)]

    moments = map(Instant, [10.0, 10.001, 12.0, 12.0])
    session = LiveSession(
        FakeMouse([Report(10.0, 1, 0)]), Corrected(), build("hold"), clock=lambda: next(moments)
    )
    session.advance(0.0)
    ((event, prediction),) = session.advance(0.0)
    assert (event.x, prediction and prediction.x) == (7.0, 7.0)
    assert (session.delays.count, session.delays.longest) == (1, pytest.approx(0.001))


def test_stamps_of_another_clock_give_no_delays() -> None:
    session = LiveSession(FakeMouse(REACH, clock="the device's own"), None, build("hold"))
    session.advance(0.0)
    assert session.state().delay_p99_s is None


def test_watchers_hear_what_came_together_and_may_end_the_session() -> None:
    heard: list[int] = []

    def watch(pairs: Sequence[Pair]) -> None:
        heard.append(len(pairs))
        if len(heard) == 3:
            raise OSError("no space left")

    mouse = FakeMouse(REACH[:5])
    session = LiveSession(mouse, None, build("hold"), watchers=[watch])
    session.advance(0.0)
    session.advance(0.0)  # nothing came
    mouse.put(REACH[5:7])
    with pytest.raises(OSError, match="no space left"):
        session.advance(0.0)
    assert heard == [5, 0, 2]


def test_it_stops_when_it_is_told_to() -> None:
    mouse, stopping = FakeMouse(REACH), threading.Event()
    session = LiveSession(mouse, None, build("hold"))
    thread = threading.Thread(target=session.run, args=(stopping,))
    thread.start()
    stopping.set()
    thread.join(60.0)
    assert not thread.is_alive()


def test_what_waits_at_the_stop_is_taken_too() -> None:
    stopping, heard = threading.Event(), list[int]()
    session = LiveSession(
        FakeMouse(REACH), None, build("hold"), watchers=[lambda pairs: heard.append(len(pairs))]
    )
    stopping.set()
    session.run(stopping)
    assert (session.state().reports, sum(heard)) == (len(REACH), len(REACH))


def test_percentiles_bound_the_share_they_name() -> None:
    delays = DelayHistogram()
    values = [1e-5 * 1.01**i for i in range(1000)]
    for value in values:
        delays.add(value)
    for share in (0.01, 0.5, 0.9, 0.99, 1.0):
        bound = delays.percentile(share)
        assert bound is not None
        below = sum(value <= bound for value in values) / len(values)
        assert share <= below <= share + 0.006
    assert delays.longest == values[-1]
    assert DelayHistogram().percentile(0.5) is None


def test_a_rate_forgets_what_is_older_than_a_second() -> None:
    pace = ReportRate()
    for i in range(8000):
        pace.add(Instant(i / 8000), 1)
    assert pace.rate(Instant(1.0)) == pytest.approx(8000, rel=0.03)
    assert pace.rate(Instant(1.5)) == pytest.approx(4000, rel=0.05)
    assert pace.rate(Instant(2.1)) == 0.0
