"""A service that has no place to write to, as in a container, and counters of sessions that come and go."""

from __future__ import annotations

import os
import tempfile
import threading
from collections import Counter
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
from httpx2 import get, post

from pointpred.datasets import sample
from pointpred.errors import RecordingError
from pointpred.recordings import write
from pointpred_server.service import Service
from pointpred_server.uploads.recordings import score_body
from tests.server.running import PATIENCE_S, running

CSV = b"user,trial,t_s,x_px,y_px\n" + b"".join(
    b"ann,%d,%.2f,%d,0\n" % (trial, i / 100, 7 * i) for trial in range(3) for i in range(60)
)


@pytest.mark.skipif(not hasattr(os, "memfd_create"), reason="files in memory are Linux's")
@pytest.mark.parametrize("ending", ["csv", "parquet"])
def test_a_recording_is_scored_where_no_file_can_be_made(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, ending: str
) -> None:
    file, _ = write(sample(), tmp_path / f"circle_samples.{ending}")
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "nowhere"))
    with running() as here:
        url = f"{here.url}/v1/score?predictors=hold"
        answer = post(url, content=file.read_bytes(), timeout=PATIENCE_S)
        assert answer.status_code == 200, answer.text
        (told,) = answer.json()["sets"]
        assert told["trials"] > 200
        assert post(url, content=CSV.replace(b"x_px", b"z_px"), timeout=PATIENCE_S).status_code == 422


def scores() -> Any:
    """What a body is scored with, the time it took left aside."""
    (told,) = score_body(CSV, ("hold",)).sets
    return told.name, told.trials, told.predictors[0].time_averaged


def test_in_memory_and_in_a_folder_the_scores_are_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    told = scores()
    monkeypatch.delattr(os, "memfd_create", raising=False)
    assert scores() == told
    assert told[:2] == ("recording", 3)


@pytest.mark.skipif(not hasattr(os, "memfd_create"), reason="files in memory are Linux's")
def test_a_file_in_memory_is_given_back() -> None:
    def held() -> Counter[str]:
        found: Counter[str] = Counter()
        for place in Path("/proc/self/fd").iterdir():
            with suppress(FileNotFoundError):  # the descriptor by which the folder itself is read
                found[str(place.readlink())] += 1
        return found

    scores()
    before = held()
    scores()
    with pytest.raises(RecordingError, match="the recording") as refused:
        score_body(CSV.replace(b"x_px", b"z_px"), ("hold",))
    assert "/proc" not in str(refused.value)
    assert not held() - before  # what other tests left behind may be given back meanwhile


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
