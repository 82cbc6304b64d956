"""A table under names of its own opened in the replay view: the form that asks which column is which."""

from __future__ import annotations

from pathlib import Path

from tests.server import browser
from tests.server.page_browser import Visitor

pytestmark = browser.needed

ROWS = "".join(f"{16 * i},{3 * i},{500 - 2 * i},ann\n" for i in range(40))


def test_a_table_whose_columns_cannot_be_guessed_is_asked_about_and_opened(
    one: Visitor, url: str, tmp_path: Path
) -> None:
    one.open(f"{url}#replay")
    one.wait("!document.querySelector('#replay-play').disabled")
    file = tmp_path / "mine.csv"
    file.write_text("clock,across,upwards,who\n" + ROWS)
    one.page.set_input_files("#replay-file", [file])
    one.wait("!document.querySelector('#replay-columns').hidden")
    options = "[...document.querySelector('#replay-column-x').options].map(({ value }) => value)"
    assert one.value(options) == ["", "clock", "across", "upwards", "who"]
    assert one.value("document.querySelector('#replay-column-t').value") == "clock"  # guessed
    assert one.value("document.activeElement.id") == "replay-column-x"
    for field, column in {"x": "across", "y": "across", "user": "who", "unit": "ms"}.items():
        one.choose(f"#replay-column-{field}", column)
    one.value("document.querySelector('#replay-column-up').click()")
    one.value("document.querySelector('#replay-columns [type=submit]').click()")
    one.wait("document.querySelector('#replay-source').dataset.state === 'failed'")  # one column twice
    assert not one.value("document.querySelector('#replay-columns').hidden")
    one.choose("#replay-column-y", "upwards")
    one.value("document.querySelector('#replay-columns [type=submit]').click()")
    one.wait("document.querySelector('#replay-readout').textContent.includes('Movement 1 of 1, person ann')")
    assert one.value("document.querySelector('#replay-columns').hidden")
    one.wait("document.querySelector('#replay-score-status').dataset.state === 'done'")
    assert one.text("#replay-score-status").startswith("1 movement scored")
    # what the browser itself says of the refusal that the form answers, and nothing else
    assert [said for said in one.complaints() if "422" not in said] == []


def test_a_file_that_is_no_table_is_refused_and_what_was_open_stays(
    one: Visitor, url: str, tmp_path: Path
) -> None:
    one.open(f"{url}#replay")
    one.wait("!document.querySelector('#replay-play').disabled")
    file = tmp_path / "letter.txt"
    file.write_text("Dear Ann,\nthere is nothing to predict here.\n")
    one.page.set_input_files("#replay-file", [file])
    one.wait("document.querySelector('#replay-source').dataset.state === 'failed'")
    assert one.value("document.querySelector('#replay-columns').hidden")
    assert "Movement 1 of" in one.text("#replay-readout")
