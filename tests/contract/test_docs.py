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
from pointpred_server import access, listening, service, websocket_protocol
from pointpred_server.sessions import lifecycle, outbox, pipelines, quota, trials
from pointpred_server.settings import Settings

CONSTANTS = {
    "events of a frame": Limits().max_events_per_frame,
    "other messages a second": quota.MESSAGES_PER_S,
    "sessions' worth of events and other messages that all sessions of one address may send": (
        quota.SESSIONS_OF_AN_ADDRESS
    ),
    "parameters of a message": pipelines.PARAMETERS_MOST,
    "numbers above 1e10 or below 1e-99 in a message, which are slow to decode": EXTREME_MOST,
    "sub-steps of the differentiator for an event (`gap_s` / `step_s`)": pipelines.SUBSTEPS_MOST,
    "memory of a session's stages, such as the templates of `ktm`": pipelines.MEMORY_MOST >> 20,
    "characters of a person's string": LARGEST,
    "events of a trial that is scored": trials.MOST_EVENTS,
    "time until `hello`": lifecycle.HELLO_S,
    "time without anything of a client, until it is asked by a ping, and then until it is given up": (
        websocket_protocol.PING_S
    ),
    "time in which a client reads nothing": websocket_protocol.STUCK_S,
    "answers that wait unread, predictions aside": outbox.Outbox().most_notes,
    "choices that wait unread": outbox.MOST_CHOICES,
    "header of a request": listening.HEADER_BYTES >> 10,
    "connections beside those of `POINTPRED_MAX_SESSIONS`": listening.REQUESTS_MOST,
}
"""Limits of the service that are no settings, by their rows in its guide."""

CHECKOUT = re.compile(r"\bmake package|docker build|deploy/|tests/data/")
"""What an example needs that no distribution holds."""

WORDS = {
    f"once more for each {quota.TARGETS_AN_EVENT} targets",
    f"{quota.EVENTS_FOR_PLACES} times more with places",
    f"may send {Settings().max_events_per_s // (1 + quota.EVENTS_FOR_PLACES):,} events a second",
    f"Each {quota.BYTES_A_MESSAGE >> 10} KiB of a message counts once more",
    f"share {quota.SESSIONS_OF_AN_ADDRESS} times these two budgets",
    f"reads {websocket_protocol.READ_BYTES >> 10} KiB of each client in turn",
    f"some {websocket_protocol.RECEIVE_BUFFER_BYTES >> 10} KiB of each in the kernel",
    f"has {websocket_protocol.LINGER_S:g} s to read why and to close",
    f"have {listening.END_S} s to end, and then the recorder {service.WRITE_S:g} s to write",
}
"""What the guide says of limits in words."""

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


@pytest.mark.parametrize("words", sorted(WORDS))
def test_the_guide_to_the_service_says_what_the_code_does(words: str) -> None:
    assert words in (ROOT / "docs/guide/service.md").read_text(encoding="utf-8")


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


GUIDES = [*(ROOT / "docs/guide").glob("*.md"), ROOT / "docs/reference/recordings.md"]


@pytest.mark.parametrize("page", GUIDES, ids=lambda path: path.name)
def test_what_needs_a_source_checkout_says_so_before(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    if needed := CHECKOUT.search(text):
        line = text.find("\n", needed.start())
        assert "source checkout" in text[:line], f"{page.name} does not say where {needed[0]} is"


def test_every_test_that_shows_a_defence_exists() -> None:
    text = (ROOT / "SECURITY.md").read_text(encoding="utf-8")
    named = set(re.findall(r"tests/[\w/]+\.py", text))
    assert len(named) > 10
    assert [name for name in sorted(named) if not (ROOT / name).exists()] == []


def test_limits_of_requests_are_those_of_the_code() -> None:
    text = (ROOT / "SECURITY.md").read_text(encoding="utf-8")
    assert f"at most {access.MOST_ORIGINS} of them" in text
    assert f"{listening.REQUESTS_MOST} connections more than `POINTPRED_MAX_SESSIONS`" in text


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
    rows = re.findall(
        r"^\| ([^|]+) \| ([\d,]+)[^|]*\| (?:`POINTPRED_([A-Z_]+)`)?[^|]*\|", section, re.MULTILINE
    )
    options = {option.lower(): float(number.replace(",", "")) for _, number, option in rows if option}
    set_by_option = [name for name in Limits.__struct_fields__ if name in Settings.model_fields]
    assert options == {name: getattr(Settings(), name) for name in set_by_option}
    constants = {name: float(number.replace(",", "")) for name, number, option in rows if not option}
    assert {name: constants.get(name) for name in CONSTANTS} == CONSTANTS
