"""The pages say what the code says."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from evidence import ROOT
from evidence.pages import everything, made
from evidence.rendering import filled
from pointpred.differentiators import DIFFERENTIATORS, HomogeneousDifferentiator
from pointpred.person import LARGEST
from pointpred.protocol.decoding import EXTREME_MOST
from pointpred.protocol.server_messages import Limits
from pointpred.registry import REGISTRY, build, parameters
from pointpred_server import access, connection, http_protocol, request_rates, websocket_protocol
from pointpred_server.sessions import costs, lifecycle, outbox, pipelines, quota, trials
from pointpred_server.settings import Settings

CONSTANTS = {
    "events of a frame": Limits().max_events_per_frame,
    "fragments of a message": websocket_protocol.FRAGMENTS_MOST,
    "fragments a second, of messages in several": websocket_protocol.FRAGMENTS_PER_S,
    "other messages a second": quota.MESSAGES_PER_S,
    "pings and pongs a second": websocket_protocol.CONTROL_FRAMES_PER_S,
    "parameters of a message": pipelines.PARAMETERS_MOST,
    "numbers above 1e10 or below 1e-99 in a message, which are slow to decode": EXTREME_MOST,
    "sub-steps of the differentiator for an event (`gap_s` / `step_s`)": pipelines.SUBSTEPS_MOST,
    "memory of a session's stages, such as the templates of `ktm`": pipelines.MEMORY_MOST >> 20,
    "characters of a person's string": LARGEST,
    "events of a trial that is scored": trials.MOST_EVENTS,
    "time until `hello`": lifecycle.HELLO_S,
    "time in which a client reads nothing": connection.STUCK_S,
    "answers that wait unread, predictions aside": outbox.Outbox().most_notes,
    "choices that wait unread": outbox.MOST_CHOICES,
    "time until the header of a request is complete": http_protocol.HEADER_S,
    "header of a request": http_protocol.HEADER_BYTES >> 10,
    "path and query of a request": http_protocol.TARGET_BYTES >> 10,
    "time in which nothing of an HTTP response is read": http_protocol.UNREAD_S,
    "time until a request for a WebSocket is accepted": websocket_protocol.UPGRADE_S,
    "requests of one other machine a second, in the long run": request_rates.REQUESTS_PER_S,
    "requests of one other machine at once": request_rates.REQUESTS_AT_ONCE,
    "requests that wait on one connection": http_protocol.PIPELINED,
    "chunks of the body of a request": http_protocol.CHUNKS,
}
"""Limits of the service that are no settings, by their rows in its guide."""

PRICES = {
    "{:g} ns for each character of a text": 1e9 * costs.TEXT_BYTE_S,
    "{:g} us for each target registered": 1e6 * costs.TARGET_S,
    "{:g} ms for `hello`": 1e3 * costs.BUILD_S,
    "{:g} ms where these": 1e3 * costs.PERSON_S,
    "{:g} ms for the end of a trial": 1e3 * costs.TRIAL_S,
    "{:g} us for each of its events": 1e6 * costs.TRIAL_EVENT_S,
    "{:g} ms for a frame of which something is refused": 1e3 * costs.REFUSED_S,
    "{:g} us for a frame of events": 1e6 * costs._FRAME_S,
    "{:g} us for each of them": 1e6 * costs._EVENT_S,
    "more than {:g} ms is processed": 1e3 * costs.AT_ONCE_S,
    "slices of some {:g} ms": 1e3 * costs.SLICE_S,
    "After {:g} ms of one client's messages": 1e3 * connection.TURN_S,
    "| {:g} s a second: some": quota.SHARE,
}
"""Costs of messages in the guide to the service."""

PAGES = [
    ROOT / "README.md",
    ROOT / "CONTRIBUTING.md",
    ROOT / "CHANGELOG.md",
    ROOT / "SECURITY.md",
    *(ROOT / "docs").rglob("*.md"),
]


@pytest.mark.parametrize("path", everything())
def test_made_pages_are_current(path: str) -> None:
    assert (ROOT / path).read_text(encoding="utf-8") == made(path), "run `make docs`"


@pytest.mark.parametrize("words", PRICES)
def test_the_guide_to_the_service_says_what_messages_cost(words: str) -> None:
    page = (ROOT / "docs/guide/service.md").read_text(encoding="utf-8")
    assert words.format(float(f"{PRICES[words]:.6g}")) in page


def test_every_predictor_and_parameter_is_listed() -> None:
    page = (ROOT / "docs/reference/predictors.md").read_text(encoding="utf-8")
    for name in REGISTRY:
        assert f"### {name}\n" in page
        for parameter in parameters(name):
            assert f"| `{parameter}` |" in page, f"{parameter} of {name}"
    for name in DIFFERENTIATORS:
        assert f"### {name}\n" in page


@pytest.mark.parametrize("name", REGISTRY)
def test_the_gains_on_the_page_are_those_that_build_gives(name: str) -> None:
    page = (ROOT / "docs/reference/predictors.md").read_text(encoding="utf-8")
    section = page.partition(f"### {name}\n")[2].partition("##")[0]
    said = {key: float(value) for key, value in re.findall(r"`(gain_\w+|alpha)` (-?[\d.]+\d|\d)", section)}
    assert set(said) == {"gain_lambda", "gain_xi", "alpha"}
    expected = HomogeneousDifferentiator(dpi=96.0, **said)
    assert np.array_equal(expected.__dict__["_memory"], build(name).differentiator.__dict__["_memory"])


def test_a_part_that_is_missing_is_an_error() -> None:
    with pytest.raises(ValueError, match="expected one part 'scores', found 0"):
        filled("# Nothing here\n", "scores", "text")


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.name)
def test_links_inside_the_project_lead_somewhere(page: Path) -> None:
    for link in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8")):
        assert (page.parent / link).exists(), f"{page.name} links to {link}"


def test_every_test_that_shows_a_defence_exists() -> None:
    text = (ROOT / "SECURITY.md").read_text(encoding="utf-8")
    named = set(re.findall(r"tests/[\w/]+\.py", text))
    assert len(named) > 10
    assert [name for name in sorted(named) if not (ROOT / name).exists()] == []


def test_limits_of_requests_are_those_of_the_code() -> None:
    text = (ROOT / "SECURITY.md").read_text(encoding="utf-8")
    at_once, a_second = request_rates.REQUESTS_AT_ONCE, request_rates.REQUESTS_PER_S
    assert f"each worker answers {at_once:,} requests at once and {a_second} a second" in text
    assert f"limited to {a_second} a second in the long run, by each worker" in text
    assert f"at most {access.MOST_ORIGINS} of them" in text
    assert f"{http_protocol.HEADER_LINES} headers, {http_protocol.CHUNKS:,} chunks" in text


def anchors(page: Path) -> set[str]:
    """The anchors that GitHub gives the headings of a page."""
    text = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)
    headings = [re.sub(r"[`*]|\]\([^)]*\)|\[", "", one) for one in re.findall(r"^#+ (.*)$", text, flags=re.M)]
    named = set(re.findall(r'<a id="([^"]+)"', text))
    return named | {re.sub(r"[^\w\- ]", "", one.lower()).replace(" ", "-") for one in headings}


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.name)
def test_links_to_a_section_lead_to_one(page: Path) -> None:
    for link, anchor in re.findall(r"\]\(([^)#:]*)#([^)]+)\)", page.read_text(encoding="utf-8")):
        where = page.parent / link if link else page
        assert anchor in anchors(where), f"{page.name} links to {link}#{anchor}"


NAMED = re.compile(r"`((?:pointpred|server|datasets|tests|evidence|docs)/[a-z0-9_/.-]+\.[a-z]+)")


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.name)
def test_files_named_on_a_page_exist(page: Path) -> None:
    for named in NAMED.findall(page.read_text(encoding="utf-8")):
        assert (ROOT / named).exists(), f"{page.name} names {named}"


def test_every_page_can_be_reached_from_the_first() -> None:
    reached, waiting = set[Path](), [ROOT / "docs/README.md"]
    while waiting:
        page = waiting.pop()
        reached.add(page)
        links = re.findall(r"\]\(([^)#:]+\.md)(?:#[^)]*)?\)", page.read_text(encoding="utf-8"))
        waiting += {(page.parent / link).resolve() for link in links} - reached
    assert set((ROOT / "docs").rglob("*.md")) - reached == set()


def test_laws_beside_their_equations_are_those_of_the_code() -> None:
    section = (ROOT / "docs/equations.md").read_text().partition("## Laws beside")[2].partition("\n## ")[0]
    lines = ""
    found = 0
    for line in section.splitlines():
        words = re.findall("`([^`]+)`", line)
        if not line.startswith("|"):
            lines = "\n".join((ROOT / word).read_text() for word in words) or lines
            continue
        for word in words:
            assert f"    {word}\n" in lines, word
            found += 1
    assert found > 20


def test_every_correction_names_a_test_that_exists() -> None:
    page = (ROOT / "docs/equations.md").read_text(encoding="utf-8")
    rows = page.partition("## Corrections")[2].strip().splitlines()[2:]
    assert rows
    for row in rows:
        named = re.findall(r"`((?:observers/)?tests/[\w/]+\.py)::(\w+)`", row)
        assert named, f"no test is named in: {row}"
        for file, test in named:
            assert f"def {test}(" in (ROOT / file).read_text(encoding="utf-8"), f"{file} has no {test}"


def test_the_limits_of_the_service_are_those_of_the_code() -> None:
    page = (ROOT / "docs/guide/service.md").read_text(encoding="utf-8")
    section = page.partition("\n## Limits\n")[2].partition("\n## ")[0]
    rows = re.findall(r"^\| ([^|]+) \| ([\d,]+)[^|]*\| (?:`--([a-z-]+)`)?[^|]*\|", section, re.MULTILINE)
    options = {
        option.replace("-", "_"): float(number.replace(",", "")) for _, number, option in rows if option
    }
    set_by_option = [name for name in Limits.__struct_fields__ if name in Settings.model_fields]
    assert options == {name: getattr(Settings(), name) for name in set_by_option}
    constants = {name: float(number.replace(",", "")) for name, number, option in rows if not option}
    assert {name: constants.get(name) for name in CONSTANTS} == CONSTANTS
