"""A recording of our own format chosen from the disk in the replay view."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from pointpred import build, run
from pointpred.datasets import sample
from pointpred.recording import Recording
from pointpred.recordings import write
from tests.server import browser
from tests.server.page_browser import Visitor

pytestmark = browser.needed


@pytest.fixture
def visitor(one: Visitor, url: str) -> Iterator[Visitor]:
    """Somebody at the replay view with its sample; whatever they do: no complaint, no other host."""
    one.open(f"{url}?by=service#replay")
    one.wait("!document.querySelector('#replay-play').disabled")
    yield one
    assert one.complaints() == []
    assert {address.split("/")[2] for address in one.asked() if "//" in address} == {url.split("/")[2]}


def test_an_opened_file_gets_the_predictions_of_the_package(visitor: Visitor, tmp_path: Path) -> None:
    whole = sample()
    parts = [whole.rows(i) for i in (3, 4, 5)]
    own = Recording.of("study", parts, [whole.trials[i] for i in (3, 4, 5)], provenance=whole.provenance)
    files = write(own, tmp_path / "study_samples.csv")
    visitor.page.set_input_files("#replay-file", files)
    visitor.wait("document.querySelector('#replay-readout').textContent.includes('Movement 1 of 3')")
    predicted = visitor.value(
        "import('/web/page/replay/predictions.js').then(async ({ predictionsAlong }) => {"
        "const { readFiles } = await import('/web/page/replay/csv.js');"
        "const { movements, dpi, cpi } = await readFiles([...document.querySelector('#replay-file').files]);"
        "return predictionsAlong(movements[1].rows, 'switched', { dpi, cpi }); })"
    )
    said = own.provenance
    expected = run(build("switched", cpi=said.cpi, dpi=said.dpi), parts[1])
    for axis, column in (("x", expected.x), ("y", expected.y)):
        assert np.array_equal(np.array(predicted[axis], dtype=float), column, equal_nan=True)
