"""One function over many items: the same answers on threads, processes and a Dask cluster."""

from __future__ import annotations

import itertools
import os
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from pointpred.errors import ParameterError
from pointpred.scoring import executors
from pointpred.scoring.executors import AHEAD, open_executor

WAYS: list[dict[str, Any]] = [{"threads": 1}, {"threads": 3}, {"processes": 2}, {"cluster": "local"}]


def square(item: int) -> tuple[int, int]:
    return item * item, os.getpid()


def broken(item: int) -> int:
    if item == 3:
        raise ValueError(f"item {item}")
    return item


@pytest.mark.parametrize("way", WAYS, ids=str)
def test_every_item_is_answered_once_at_its_place(way: dict[str, Any]) -> None:
    with open_executor(**way) as executor:
        answers = dict(executor.each(square, range(40)))
        assert {place: square for place, (square, _) in answers.items()} == {k: k * k for k in range(40)}
        elsewhere = {process for _, process in answers.values()} - {os.getpid()}
        assert bool(elsewhere) == ("threads" not in way)
        with pytest.raises(ValueError, match="item 3"):
            dict(executor.each(broken, range(40)))
        assert dict(executor.each(broken, [7])) == {0: 7}  # an error is not the executor's end


def test_a_process_that_is_killed_is_named_as_the_reason() -> None:
    with open_executor(processes=1) as executor:
        for _ in range(2):
            with pytest.raises(ParameterError, match="was killed") as caught:
                dict(executor.each(os._exit, [1]))
            assert caught.value.field == "processes"


LOST_WORKERS = """
import os
import subprocess
import sys
from pointpred.errors import ParameterError
from pointpred.scoring.executors import open_executor

if __name__ == "__main__":  # each worker of the cluster imports this file
    with open_executor(cluster="local") as executor:
        try:
            dict(executor.each(os._exit, [1]))
        except ParameterError as error:
            print(error.field, error)
"""


def test_a_cluster_that_loses_its_workers_is_named_as_the_reason(tmp_path: Path) -> None:
    """In a process of its own: once the process that it ran in ended, or waited without end."""
    script = tmp_path / "lost_workers.py"
    script.write_text(LOST_WORKERS)
    ran = subprocess.run(
        [sys.executable, "-X", "faulthandler", script],
        capture_output=True,
        text=True,
        check=False,
        timeout=240,
    )
    assert ran.stdout.startswith("cluster the Dask cluster lost workers"), (ran.returncode, ran.stderr)


def test_a_cluster_without_workers_is_not_waited_for_for_ever(monkeypatch: pytest.MonkeyPatch) -> None:
    """A worker without a nanny that ends is not started again."""
    distributed = pytest.importorskip("distributed")
    monkeypatch.setattr(executors, "WITHOUT_WORKERS_S", 0.4)
    monkeypatch.setattr(executors, "CHECK_S", 0.1)
    with (
        distributed.LocalCluster(
            n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None
        ) as local,
        open_executor(cluster=local.scheduler_address) as executor,
    ):
        answers = executor.each(abs, itertools.repeat(-3))
        assert next(answers) == (0, 3)
        local.scale(0)
        with pytest.raises(ParameterError, match=r"no other came within 0.4 s") as caught:
            list(answers)
    assert caught.value.field == "cluster"


def test_items_are_taken_as_workers_become_free() -> None:
    taken = 0

    def items() -> Iterator[int]:
        nonlocal taken
        for k in range(100):
            taken += 1
            yield k

    with open_executor(threads=2) as executor:
        for done, _ in enumerate(executor.each(lambda item: item, items()), 1):
            assert taken <= done + 2 * AHEAD + 2


def test_what_was_not_begun_is_given_up_when_the_caller_stops() -> None:
    begun = []

    def slow(item: int) -> int:
        begun.append(item)
        time.sleep(0.05)
        return item

    with open_executor(threads=2) as executor:
        for _ in executor.each(slow, range(50)):
            break
    assert len(begun) <= 2 + 2 * AHEAD


def test_one_thread_is_the_callers() -> None:
    with open_executor(threads=1) as executor:
        assert dict(executor.each(lambda _: threading.get_ident(), [0])) == {0: threading.get_ident()}


@pytest.mark.parametrize(
    ("wrong", "sentence"),
    [
        ({"threads": 2, "cluster": "local"}, "received threads and cluster"),
        ({"processes": 0}, "processes must be at least 1, received 0"),
        ({"cluster": "nowhere"}, "no Dask scheduler answers at 'nowhere'"),
    ],
)
def test_settings_that_cannot_be_are_refused(wrong: dict[str, Any], sentence: str) -> None:
    with pytest.raises(ParameterError, match=sentence), open_executor(**wrong):
        pass
