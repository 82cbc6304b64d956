"""What all tests of the service share."""

from __future__ import annotations

import pytest

from pointpred.server.recorder.recorder import Recorder
from tests.server.running import PATIENCE_S


@pytest.fixture(autouse=True)
def patient_recorders(monkeypatch: pytest.MonkeyPatch) -> None:
    """What a recorder holds is written to the end, however long a busy disk takes."""
    close = Recorder.close
    monkeypatch.setattr(Recorder, "close", lambda self, timeout_s=PATIENCE_S: close(self, timeout_s))
