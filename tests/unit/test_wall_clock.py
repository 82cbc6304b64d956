"""Times since 1970 in seconds are times; in milliseconds they are a mistake that is named."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from pointpred import EventColumns
from pointpred.errors import EventError
from pointpred.records import LARGEST, LATEST_S
from pointpred.transfer import AssistedTransfer, ConstantGain, PixelTransfer, PolynomialIdentifier

NOW_S = 1.7e9
DT_S = 2.0**-7


def written(folder: Path, name: str, origin: float) -> Path:
    """Two reaches of one second in the project's own CSV."""
    folder.mkdir()
    lines = ["user,trial,t_s,x_px,y_px"]
    for trial in range(2):
        for i in range(129):
            s = min(i / 100.0, 1.0)
            way = round(500 * (10 * s**3 - 15 * s**4 + 6 * s**5))
            lines.append(f"ann,{trial},{origin + 4.0 * trial + i * DT_S!r},{way},{-way // 2}")
    path = folder / f"{name}_samples.csv"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def test_a_recording_of_now_scores_as_one_from_zero(command, tmp_path: Path) -> None:
    documents = []
    for folder, origin in (("zero", 0.0), ("now", NOW_S)):
        path = written(tmp_path / folder, "reach", origin)
        left = command("score", path, "--predictors", "switched,kep-quartic", "--json", "-")
        assert left.code == 0, left.err
        (one,) = json.loads(left.out)["sets"]
        assert (one["trials"], one["skipped"]) == (2, [])
        documents.append(
            [(p["name"], p["time_averaged"], p["by_path"], p["coverage"]) for p in one["predictors"]]
        )
    assert documents[0] == documents[1]


def test_transfer_functions_take_any_clock() -> None:
    for origin in (0.0, NOW_S, LATEST_S - 10.0):
        pixels = PixelTransfer(ConstantGain(2.0), cpi=800.0)
        assisted = AssistedTransfer(ConstantGain(2.0), cpi=800.0)
        assert pixels.update((origin, 20.0, 0.0)) == (4.0, 0.0)
        assert assisted.update((origin, 20.0, 0.0)) == (4.0, 0.0)
        identifier = PolynomialIdentifier(order=1, cpi=800.0, dpi=96.0)
        t = origin + DT_S * np.arange(200)
        counts = np.full(200, 10.0)
        identifier.run(EventColumns.of(t, np.cumsum(counts), np.zeros(200), counts, np.zeros(200)))
    for stage in (pixels, assisted):
        with pytest.raises(EventError):
            stage.update((1.1 * LATEST_S, 1.0, 0.0))
        with pytest.raises(EventError):
            stage.update((LATEST_S, 1.1 * LARGEST, 0.0))
