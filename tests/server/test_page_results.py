"""Scores on the page: sorted, the best three and hold in colour, every other line switched by a click."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from pointpred.datasets import sample
from pointpred.recording import Recording
from pointpred.recordings import write
from tests.server import browser
from tests.server.page_browser import Visitor

pytestmark = browser.needed

ROWS = "[...document.querySelectorAll('#replay-scores tbody tr')]"
SWATCH = "one.querySelector('line')"
LOOK = f"[{SWATCH}.style.stroke, {SWATCH}.getAttribute('stroke-dasharray')]"
PRESSED = "[...document.querySelectorAll('#replay-legend [aria-pressed=true]')].map((one) => one.textContent)"
TEXT = "(one) => one.textContent"
PAINT = """(() => {
  const plot = document.querySelector("#replay-by-time canvas");
  const { data } = plot.getContext("2d").getImageData(0, 0, plot.width, plot.height);
  const probe = document.createElement("canvas").getContext("2d");
  probe.fillStyle = getComputedStyle(document.documentElement).getPropertyValue(NAME);
  probe.fillRect(0, 0, 1, 1);
  const wanted = probe.getImageData(0, 0, 1, 1).data;
  let count = 0;
  const like = (i) => [0, 1, 2, 3].every((k) => data[i + k] === wanted[k]);
  for (let i = 0; i < data.length; i += 4) count += Number(like(i));
  return count;
})()"""
"""How many points of a plot have a colour of the style sheet."""


def give(visitor: Visitor, folder: Path, trials: range) -> None:
    """Open some movements of the sample in the replay view, and wait for their scores."""
    whole = sample()
    rows, about = [whole.rows(i) for i in trials], [whole.trials[i] for i in trials]
    [samples, _] = write(Recording.of("study", rows, about), folder / "study_samples.csv")
    visitor.value("document.querySelector('#replay-score-status').dataset.state = ''")
    visitor.give_files({"study.csv": samples.read_text()})
    visitor.wait("document.querySelector('#replay-score-status').dataset.state === 'done'")


@pytest.fixture(scope="module")
def scored(one: Visitor, url: str, tmp_path_factory: pytest.TempPathFactory) -> Visitor:
    """The replay view with the scores of four movements."""
    one.prefer(color_scheme="light")
    one.open(f"{url}#replay")
    one.wait("!document.querySelector('#replay-play').disabled")
    give(one, tmp_path_factory.mktemp("study"), range(30, 34))
    assert one.value(PRESSED) == best(one)  # before anything is switched by hand
    return one


@pytest.fixture
def visitor(scored: Visitor) -> Iterator[Visitor]:
    """Somebody at these scores, with the lines in front that the page puts there."""
    yield scored
    for name in scored.value(PRESSED):
        if name not in best(scored):
            press(scored, name)
    for name in best(scored):
        if name not in scored.value(PRESSED):
            press(scored, name)
    assert scored.complaints() == []
    assert scored.shift() < 0.001


def names(visitor: Visitor) -> list[str]:
    """The predictors in the order of the table."""
    found: list[str] = visitor.value(f"{ROWS}.map((one) => one.dataset.predictor)")
    return found


def best(visitor: Visitor) -> list[str]:
    """The three with the lowest error."""
    return [name for name in names(visitor) if name != "hold"][:3]


def press(visitor: Visitor, name: str) -> None:
    """Click a name in the legend."""
    visitor.value(
        "[...document.querySelectorAll('#replay-legend button')]"
        f".find((one) => one.textContent === {name!r}).click()"
    )


def test_the_table_begins_with_the_lowest_error(visitor: Visitor) -> None:
    errors = visitor.value(f"{ROWS}.map((one) => Number(one.dataset.px))")
    assert len(errors) > 5
    assert errors == sorted(errors)
    first, least = names(visitor)[0], errors[0]
    said = visitor.text("#replay-score-status")
    assert f"{first}, {least:.1f} px" in said
    hold = errors[names(visitor).index("hold")]
    assert f"{100 * (1 - least / hold):.0f} %" in said


def test_the_best_three_and_hold_are_in_front_and_differ_in_colour_and_dashes(visitor: Visitor) -> None:
    assert visitor.value(PRESSED) == best(visitor)
    looks = dict(visitor.value(f"{ROWS}.map((one) => [one.dataset.predictor, {LOOK}])"))
    front = {name: looks.pop(name) for name in (*best(visitor), "hold")}
    assert len({colour for colour, _ in front.values()}) == 4
    assert len({dash for _, dash in front.values()}) == 4
    assert set(map(tuple, looks.values())) == {("var(--faint)", "")}
    legend = visitor.value(
        f"[...document.querySelectorAll('#replay-legend li')].map((one) => [one.textContent, {LOOK}])"
    )
    assert {name: look for name, look in legend if name in front} == {
        name: look for name, look in front.items() if name != "hold"
    }


def test_a_click_on_a_row_brings_its_line_to_the_front_and_back(visitor: Visitor) -> None:
    fourth = [name for name in names(visitor) if name != "hold"][3]
    row = f"{ROWS}.find((one) => one.dataset.predictor === {fourth!r})"
    unused = PAINT.replace("NAME", "'--series-4'")
    assert visitor.value(unused) == 0
    visitor.value(f"{row}.cells[2].click()")
    assert set(visitor.value(PRESSED)) == {*best(visitor), fourth}
    assert visitor.value(f"{row}.querySelector('line').style.stroke") == "var(--series-4)"
    visitor.wait(f"{unused} > 20")
    visitor.value(f"{row}.cells[0].click()")
    assert visitor.value(PRESSED) == best(visitor)
    visitor.wait(f"{unused} === 0")


def test_the_keyboard_switches_a_line_and_stays_where_it_is(visitor: Visitor) -> None:
    last = names(visitor)[-1] if names(visitor)[-1] != "hold" else names(visitor)[-2]
    find = (
        f"[...document.querySelectorAll('#replay-legend button')].find((one) => one.textContent === {last!r})"
    )
    visitor.value(f"{find}.focus()")
    for pressed in ("true", "false"):
        visitor.press("Enter")
        assert visitor.value(f"{find}.getAttribute('aria-pressed')") == pressed
        assert visitor.value(f"document.activeElement === {find}")


def test_what_was_switched_stays_so_for_the_next_recording(visitor: Visitor, tmp_path: Path) -> None:
    first, *_ = best(visitor)
    other = names(visitor)[-1] if names(visitor)[-1] != "hold" else names(visitor)[-2]
    press(visitor, first)
    press(visitor, other)
    give(visitor, tmp_path, range(30, 35))
    assert first not in visitor.value(PRESSED)
    assert other in visitor.value(PRESSED)
    give(visitor, tmp_path, range(30, 34))


def test_hold_is_always_in_front(visitor: Visitor) -> None:
    hold = f"{ROWS}.find((one) => one.dataset.predictor === 'hold')"
    before = visitor.value(f"(({{ style }}) => style.stroke)({hold}.querySelector('line'))")
    visitor.value(f"{hold}.click()")
    assert visitor.value(f"{hold}.querySelector('line').style.stroke") == before != "var(--faint)"
    assert (
        visitor.value("document.querySelectorAll('#replay-legend button').length") == len(names(visitor)) - 1
    )


def test_one_movement_has_no_interval(visitor: Visitor, tmp_path: Path) -> None:
    heads = visitor.value(f"[...document.querySelectorAll('#replay-scores th')].map({TEXT})")
    [column] = [i for i, head in enumerate(heads) if "interval" in head]
    others = f"{ROWS}.filter((one) => one.dataset.predictor !== 'hold')"
    cells = f"{others}.map((one) => one.cells[{column}].textContent)"
    assert all(re.fullmatch(r"\d\.\d\d to \d\.\d\d", cell) for cell in visitor.value(cells))
    give(visitor, tmp_path, range(30, 31))
    assert set(visitor.value(cells)) == {"–"}
    give(visitor, tmp_path, range(30, 34))


@pytest.mark.parametrize("view", ["circle", "replay"])
def test_the_words_of_a_table_are_explained_below_it(visitor: Visitor, view: str) -> None:
    details = f"document.querySelector('#{view}-result details.glossary')"
    assert visitor.value(f"{details}.open") is False
    pairs = f"[...{details}.querySelectorAll('dl > div')]"
    told = visitor.value(f"{pairs}.map((pair) => [...pair.children].map({TEXT}))")
    assert {"hold", "95 % interval", "ktm", "kep"} <= {term for term, _ in told}
    assert all(len(meaning) > 20 for _, meaning in told)
    assert visitor.value(f"{details}.firstElementChild.localName") == "summary"
