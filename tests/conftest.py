"""What tests of several rooms share."""

from __future__ import annotations

import logging
import os
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import pytest
from hypothesis import settings

settings.register_profile("pointpred", deadline=None, derandomize=True)
settings.load_profile("pointpred")


class Left(NamedTuple):
    """How a command left: its exit code and what it wrote."""

    code: int
    out: str
    err: str


@pytest.fixture
def command(capsys: pytest.CaptureFixture[str]) -> Callable[..., Left]:
    """Run the command line in this process."""

    def run(*arguments: str | Path) -> Left:
        from pointpred.cli import main

        handlers = logging.root.handlers[:]
        with pytest.raises(SystemExit) as left:
            main([str(argument) for argument in arguments])
        logging.root.handlers[:] = handlers  # `serve` logs to the stderr of this test
        told = capsys.readouterr()
        return Left(int(left.value.code or 0), told.out, told.err)

    return run


@pytest.fixture
def recordings() -> Path:
    """The folder of recordings; the test is skipped where there is none."""
    folder = os.environ.get("POINTPRED_RECORDINGS")
    if not folder:
        pytest.skip("POINTPRED_RECORDINGS names no folder of recordings")
    return Path(folder)
