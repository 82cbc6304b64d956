"""``pointpred study run`` reads an emulated mouse beside the page, whose trials mark its counts."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from pathlib import Path

import msgspec
import pytest
from httpx2 import post
from msgspec.structs import replace

from pointpred.recordings import read
from pointpred.studies.export import export
from pointpred.studies.folder import Study
from pointpred.studies.messages import Agreed, Message
from tests.devices.live_fakes import reach
from tests.devices.live_process import PATIENCE_S, environment, send
from tests.devices.mice import TWO_WHEELS, plug
from tests.devices.umockdev import Testbed
from tests.studied import PAGE, movement, study_in

WAYS = ((900.0, -400.0), (-700.0, 500.0))


def tell(link: str, message: Message) -> None:
    address = link.replace("/study/", "/v1/study/")
    assert post(address, content=msgspec.json.encode(message), timeout=PATIENCE_S).status_code == 200


def test_the_counts_of_a_mouse_are_marked_by_the_trials_of_the_page(testbed: Testbed, tmp_path: Path) -> None:
    mouse, study = plug(testbed, TWO_WHEELS), study_in(tmp_path)
    command = [sys.executable, "-m", "pointpred", "study", "run", str(tmp_path / "pointing.toml"), "P02"]
    with subprocess.Popen(
        [*command, "--cpi", "800", "--port", "0"],
        env=environment(testbed),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        try:
            assert process.stdout is not None
            code, link = process.stdout.readline().split()
            assert code == "P02"
            tell(link, Agreed(PAGE))
            one, epoch, spans = study.participants["P02"], time.time() - 50.0, []
            for way in WAYS:  # the clock of this page began 50 s ago
                send(mouse, reach(0.0, (300.0, 0.0), rate_hz=500.0))  # belongs to no trial
                time.sleep(0.1)
                began = time.time() - epoch
                send(mouse, reach(0.0, way, rate_hz=500.0))
                time.sleep(0.5)
                spans.append((began, time.time() - epoch))
                moved = movement(one, t=began)
                ended = (spans[-1][1], *moved.rows[-1][1:])
                tell(link, replace(moved, rows=[*moved.rows[:1], ended], at=epoch + began))
            process.send_signal(signal.SIGINT)
            _, said = process.communicate(timeout=PATIENCE_S)
        finally:
            process.kill()
    assert "of the mouse kept" in said
    [(page, _), (mice, file)] = export(Study(tmp_path / "pointing.toml"), tmp_path / "all.csv")
    assert file.name == "all-mouse_samples.csv"
    again = read(file)
    assert again.provenance.cpi == 800.0
    assert [(t.user, t.trial) for t in again.trials] == [(t.user, t.trial) for t in page.trials]
    assert [t.condition for t in again.trials] == [t.condition for t in page.trials]
    for i, way in enumerate(WAYS):
        events = again.rows(i)
        assert (events.table[:, 3].sum(), events.table[:, 4].sum()) == pytest.approx(way, abs=1e-6)
        assert spans[i][0] <= events.t[0] < events.t[-1] <= spans[i][1]
        assert events.t[0] >= float(again.trials[i].condition["started_s"])
    assert len(mice.trials) == 2
