"""What the service tells of itself: every metric is described, and no entry quotes what anybody did."""

from __future__ import annotations

import errno
import json
import logging
import os
import re
import threading
from functools import partial
from pathlib import Path

import pytest
from httpx2 import get

from pointpred.logs import PlainLines
from pointpred.recorder.writer import Recorder
from pointpred_server.logs import JsonLines, set_up
from pointpred_server.metrics import BUCKETS
from pointpred_server.service import Service
from tests.server.listener import soon
from tests.server.running import PATIENCE_S, running


def test_metrics_and_readiness() -> None:
    with running() as here:
        with here.greeted() as socket:
            socket.send('{"type":"events","events":[[1,5,6,null,null,0]]}')
            assert '"prediction"' in str(socket.recv(PATIENCE_S))
            socket.send("{oops")
            assert '"bad_json"' in str(socket.recv(PATIENCE_S))
            text = get(f"{here.url}/metrics", timeout=PATIENCE_S).text
        assert "pointpred_event_to_prediction_seconds_count 1.0" in text
        assert 'pointpred_refused_total{code="bad_json"} 1.0' in text
        assert "pointpred_recordings_failed_total 0.0" in text  # told where nothing is recorded, too
        assert get(f"{here.url}/readyz", timeout=PATIENCE_S).json() == {"ready": True, "stopping": False}


def test_sessions_are_counted_by_the_thread_that_opens_and_closes_them(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Read from another thread, the sessions change while they are counted."""
    threads: dict[str, int] = {}
    settle, open_one = Service.update_metrics, Service.open_session

    def settled(self: Service) -> None:
        threads["counts"] = threading.get_ident()
        settle(self)

    def opened(self: Service, now: float) -> object:
        threads["opens"] = threading.get_ident()
        return open_one(self, now)

    monkeypatch.setattr(Service, "update_metrics", settled)
    monkeypatch.setattr(Service, "open_session", opened)
    with running() as here, here.greeted():
        assert get(f"{here.url}/metrics", timeout=PATIENCE_S).status_code == 200
    assert threads["counts"] == threads["opens"]


def test_what_the_recorder_lost_and_where_it_failed_is_counted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A full disk: the session goes on, nothing of it is recorded, and the counters say so."""

    def full(descriptor: int, data: bytes) -> int:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    def counted() -> dict[str, str]:
        lines = get(f"{here.url}/metrics", timeout=PATIENCE_S).text.splitlines()
        return dict(
            line.rsplit(" ", 1) for line in lines if re.match("pointpred_record.*(total|waiting) ", line)
        )

    kept = partial(Recorder, write=full)
    monkeypatch.setattr("pointpred_server.service.Recorder", kept)
    with running(record=tmp_path / "kept") as here, here.greeted() as socket:
        for t in range(3):
            socket.send(f'{{"type":"events","events":[[{t},5,6,null,null,0]]}}')
            assert '"prediction"' in str(socket.recv(PATIENCE_S))
            if t == 0:
                soon(lambda: counted()["pointpred_recordings_failed_total"] == "1.0", "it has failed")
        wanted = {
            "pointpred_recordings_failed_total": "1.0",
            "pointpred_recorder_events_lost_total": "3.0",
            "pointpred_recorder_events_waiting": "0.0",
        }
        soon(lambda: counted() == wanted, "all is lost")  # the recorder's thread counts in several steps
        assert counted()["pointpred_recordings_failed_total"] == "1.0", "counted once"


def test_delays_are_told_from_50_us() -> None:
    assert BUCKETS[0] == 5e-5
    assert list(BUCKETS) == sorted(BUCKETS)


def failed() -> tuple[logging.LogRecord, ...]:
    """Entries of ours and of a library about an error whose words quote an event."""
    try:
        try:
            float("7315.25,4.5")
        except ValueError as first:
            raise RuntimeError("cannot use 7315.25") from first
    except RuntimeError as error:
        caught = (type(error), error, error.__traceback__)
    return (
        logging.LogRecord("pointpred.service", logging.ERROR, "", 0, "session failed", (), caught),
        logging.LogRecord("uvicorn.error", logging.ERROR, "", 0, "in ASGI application\n", (), caught),
        logging.LogRecord("uvicorn.error", logging.WARNING, "", 0, "got %s", ("7315.25",), None),
        logging.LogRecord(
            "asyncio", logging.ERROR, "", 0, "never retrieved\nValueError('7315.25')", (), None
        ),
        logging.LogRecord("asyncio", logging.ERROR, "", 0, "Exception in f(b'7315.25')", (), caught),
    )


@pytest.mark.parametrize("style", [JsonLines(), PlainLines()])
def test_an_error_is_told_by_type_and_place_without_its_words(style: logging.Formatter) -> None:
    lines = [style.format(record) for record in failed()]
    for line in lines:
        assert "7315.25" not in line
        assert "\n" not in line
    assert "RuntimeError at test_metrics_and_logs.py" in lines[0]
    assert "after ValueError" in lines[0]


def test_json_entries_are_objects_with_known_fields() -> None:
    record = logging.LogRecord("pointpred.service", logging.INFO, "", 0, "session closed", (), None)
    record.session, record.code, record.x = "ab", 1000, 7315.25
    told = json.loads(JsonLines().format(record))
    assert set(told) == {"time", "level", "logger", "message", "session", "code"}


def test_every_logger_of_the_process_speaks_through_the_same_handler() -> None:
    root, own = logging.getLogger(), logging.getLogger("pointpred")
    handlers, level, ours = root.handlers[:], root.level, own.level
    try:
        set_up("json")
        (handler,) = root.handlers
        assert isinstance(handler.formatter, JsonLines)
        assert logging.getLogger("pointpred.service").isEnabledFor(logging.INFO)
        assert not logging.getLogger("uvicorn.access").isEnabledFor(logging.INFO)
    finally:
        root.handlers[:] = handlers
        root.setLevel(level)
        own.setLevel(ours)
