"""A browser of its own for tests, where there is one."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from pointpred.live.devtools import Page, open_page

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
    "--window-size=1280,720",
)

PATIENCE_S = 120.0
"""A browser that many others starve may take long to answer."""

needed = pytest.mark.skipif(BROWSER is None, reason="no chromium on this machine")


@contextmanager
def running(profile: Path, *further: str) -> Iterator[str]:
    """A browser, with further flags; yields the address of its DevTools."""
    assert BROWSER is not None
    flags = [*QUIET, *further, f"--user-data-dir={profile}", "--remote-debugging-port=0"]
    command = [BROWSER, *flags, "about:blank"]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        try:
            for line in process.stderr:
                if line.startswith("DevTools listening on "):
                    yield f"http://{line.split('/')[2]}"
                    break
            else:
                pytest.fail("the browser left before it listened")
        finally:
            process.terminate()
            process.stderr.read()


def tab(devtools: str, url: str | None = None) -> Page:
    """A tab of a browser, as ``open_page`` gives it, with the patience of tests."""
    return open_page(devtools, url, timeout_s=PATIENCE_S)
