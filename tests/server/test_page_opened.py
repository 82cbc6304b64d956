"""A recording chosen from the disk in the replay view, and a file that is none."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
import pytest

from pointpred import build, run
from pointpred.datasets import sample
from pointpred.recording import Recording
from pointpred.sources import write
from tests.server import browser
from tests.server.page_browser import Visitor

pytestmark = browser.needed


@pytest.fixture
def visitor(one: Visitor, url: str) -> Iterator[Visitor]:
    """Somebody at the replay view with its sample; whatever they do: no complaint, no other host."""
    one.open(f"{url}#replay")
    one.wait("!document.querySelector('#replay-play').disabled")
    yield one
    assert one.complaints() == []
    assert {address.split("/")[2] for address in one.asked() if "//" in address} == {url.split("/")[2]}


def choose(visitor: Visitor, files: Sequence[Path]) -> None:
    """Choose files in the browser's own dialogue."""
    root = visitor.page.call("DOM.getDocument")["root"]["nodeId"]
    node = visitor.page.call("DOM.querySelector", nodeId=root, selector="#replay-file")["nodeId"]
    visitor.page.call("DOM.setFileInputFiles", nodeId=node, files=[str(file) for file in files])


def test_an_opened_file_gets_the_predictions_and_scores_of_the_command(
    visitor: Visitor, tmp_path: Path
) -> None:
    whole = sample()
    parts = [whole.rows(i) for i in (3, 4, 5)]
    own = Recording.of("study", parts, [whole.trials[i] for i in (3, 4, 5)], provenance=whole.provenance)
    files = write(own, tmp_path / "study_samples.csv")
    choose(visitor, files)
    visitor.wait("document.querySelector('#replay-readout').textContent.includes('Movement 1 of 3')")
    predicted = visitor.value(
        "import('/web/replay-stream.js').then(async ({ predictionsAlong }) => {"
        "const { readFiles } = await import('/web/replay-file.js');"
        "const { movements, dpi, cpi } = await readFiles([...document.querySelector('#replay-file').files]);"
        "return predictionsAlong(movements[1].rows, 'switched', { dpi, cpi }); })"
    )
    said = own.provenance
    expected = run(build("switched", cpi=said.cpi, dpi=said.dpi), parts[1])
    for axis, column in (("x", expected.x), ("y", expected.y)):
        assert np.array_equal(np.array(predicted[axis], dtype=float), column, equal_nan=True)
    visitor.wait("document.querySelector('#replay-scored').textContent.startsWith('3 movements scored')")
    visitor.wait("document.querySelectorAll('#replay-scores tbody tr[data-px]').length > 1")


def test_a_file_that_is_no_recording_is_refused_with_the_reason(visitor: Visitor, tmp_path: Path) -> None:
    file = tmp_path / "shopping.csv"
    file.write_text("what,price\nmilk,1\n")
    choose(visitor, [file])
    visitor.wait("document.querySelector('#replay-source').textContent.includes('shopping.csv')")
    assert "no table of samples" in visitor.text("#replay-source")
    assert "Movement 1 of" in visitor.text("#replay-readout")
