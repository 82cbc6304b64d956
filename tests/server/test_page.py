"""The page in a real browser, where there is one: it draws, and it says nothing but what it was told."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from pointpred.datasets import sample

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
QUIET = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--virtual-time-budget=20000",
)

pytestmark = pytest.mark.skipif(BROWSER is None, reason="no chromium on this machine")


@pytest.fixture(scope="module")
def url() -> Iterator[str]:
    command = [sys.executable, "-m", "pointpred", "serve", "--port", "0"]
    service = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    assert service.stdout is not None
    yield service.stdout.readline().strip()
    service.kill()
    service.communicate()


@pytest.fixture(scope="module")
def page(url: str, tmp_path_factory: pytest.TempPathFactory) -> str:
    """The document after its script has run."""
    assert BROWSER is not None
    profile = f"--user-data-dir={tmp_path_factory.mktemp('profile')}"
    command = [BROWSER, *QUIET, profile, "--window-size=390,844", "--dump-dom", url]
    return subprocess.run(command, capture_output=True, text=True, check=True, timeout=120).stdout


def test_the_readout_names_the_movement(page: str) -> None:
    readout = re.search(r'<p id="readout"[^>]*>([^<]*)</p>', page)
    assert readout is not None
    assert f"Movement 1 of {len(sample().trials)}, simulated person" in readout[1]
    assert "px from where it ended" in readout[1]


def test_the_controls_can_be_used(page: str) -> None:
    for control in ("play", "time", "previous", "next", "predictor"):
        tag = re.search(rf'<\w+ id="{control}"[^>]*>', page)
        assert tag is not None
        assert "disabled" not in tag[0]


def test_something_is_drawn(url: str, tmp_path: Path) -> None:
    from matplotlib.image import imread

    assert BROWSER is not None
    target = tmp_path / "page.png"
    profile = f"--user-data-dir={tmp_path / 'profile'}"
    command = [BROWSER, *QUIET, profile, "--window-size=1280,720", f"--screenshot={target}", url]
    subprocess.run(command, capture_output=True, check=True, timeout=120)
    scene = imread(target)[130:410, 150:1130, :3]  # inside the first canvas
    colours = {tuple(colour) for colour in (scene.reshape(-1, 3) * 255).round().astype(int).tolist()}
    assert {(37, 99, 168), (63, 125, 79)} <= colours  # the trail and the target, in light colours
