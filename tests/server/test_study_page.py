"""People at the page of a study in a browser: killed services, reloaded pages, nothing lost or doubled."""

from __future__ import annotations

import threading
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from pointpred.recordings import read
from pointpred.simulation.person import people
from pointpred.studies.export import export, status
from pointpred.studies.folder import Study
from pointpred.studies.plan import plan_of
from tests.server import browser, page_browser
from tests.server.page_browser import Visitor
from tests.server.study_people import FRAMES, GOAL, SHEET, Hand, Served, served
from tests.studied import DESIGN

pytestmark = browser.needed

ANSWERED = "performance.getEntriesByType('resource').filter(({name}) => name.includes('/v1/study/')).length"
"""How many requests of the page the service has answered."""


@pytest.fixture
def visitor(one: Visitor) -> Visitor:
    one.resize(1280, 720)
    return one


@pytest.fixture
def service(tmp_path: Path) -> Iterator[Served]:
    design = tmp_path / "pointing.toml"
    design.write_text(
        DESIGN.replace("break_s", 'blocks = 2\non_error = "repeat"\nbreak_s').replace("[20, 40]", "[40]")
    )
    with served(design) as started:
        yield started


def sequences(study: Study, participant: str) -> list[tuple[int, int]]:
    """Every movement of a participant's plan: the sequence and the movement in it, from 1."""
    plan = plan_of(study.design, study.design.codes.index(participant))
    return [(i + 1, m + 1) for i, one in enumerate(plan) for m in range(one.movements)]


def check(study: Study, people: list[str], out: Path) -> None:
    """The export holds each planned movement of each person once, and their missed attempts before it."""
    [(recording, file)] = export(study, out)
    assert recording.skipped == ()
    again = read(file)
    assert len({(trial.user, trial.trial) for trial in again.trials}) == len(again.trials)
    for person in people:
        own = [i for i, trial in enumerate(again.trials) if trial.user == person]
        told = [again.trials[i].condition for i in own]
        hits = [(int(c["sequence"]), int(c["movement"])) for c in told if c["hit"] == 1.0]
        assert hits == sequences(study, person)
        assert all(count == 1 for count in Counter(str(sorted(c.items())) for c in told).values())
        for i, condition in zip(own, told, strict=True):
            events, trial = again.rows(i), again.trials[i]
            assert condition["started_s"] <= events.t[0]
            assert (np.diff(events.t) >= 0.0).all()
            x, y = abs(events.x[-1] - trial.target_x), abs(events.y[-1] - trial.target_y)
            inside = (
                np.hypot(x, y) <= trial.target_w / 2
                if condition["task"] == "circle"
                else x <= trial.target_w / 2
            )
            assert inside == (condition["hit"] == 1.0)


def test_a_study_goes_on_after_a_killed_service_and_a_reloaded_page(
    visitor: Visitor, service: Served, tmp_path: Path
) -> None:
    one, other = (Hand(visitor, service.links[code], seed) for seed, code in enumerate(("P01", "P02")))
    one.open()
    one.go_on(3)
    service.kill()
    assert "not saved yet" in one.until_trouble()
    service.start()
    one.go_on(4)
    one.open()  # in the middle of a sequence
    one.go_on(3)
    assert one.go_on() == "The end"
    other.open()
    other.go_on(5)
    service.kill()
    service.start()
    other.open()
    assert other.go_on() == "The end"
    service.kill()
    check(Study(service.design), ["P01", "P02"], tmp_path / "all_samples.parquet")


def test_sheets_work_by_keyboard_and_nothing_is_stored_without_consent(
    visitor: Visitor, service: Served
) -> None:
    study, title = Study(service.design), "document.querySelector('#sheet-title').textContent"
    visitor.open(service.links["P03"])
    visitor.wait(f"{title} === 'A study'")
    visitor.page.keyboard.press("Tab")
    visitor.page.keyboard.press("Tab")
    visitor.page.keyboard.press("Enter")  # "I do not take part"
    visitor.wait(f"{title} === 'Thank you'")
    assert not (study.folder / "P03").exists()
    visitor.open(service.links["P03"])
    visitor.wait(f"{title} === 'A study'")
    visitor.page.keyboard.press("Tab")
    visitor.page.keyboard.press("Enter")
    visitor.wait(f"{title} === 'Before you begin'")
    visitor.page.keyboard.press("Tab")
    visitor.page.keyboard.press("Tab")
    visitor.page.keyboard.press("Enter")
    assert visitor.text("#wrong-hand") == "Please answer this."
    visitor.page.keyboard.press("ArrowDown")
    visitor.page.keyboard.press("Enter")
    visitor.wait("document.querySelector('#sheet-form button').textContent === 'Start'")
    about = study.participants["P03"].about
    assert about is not None
    assert about.answers["hand"] in ("left", "right")
    assert about.pages[0].page.window == (1280.0, 720.0)
    assert visitor.complaints() == []


def test_the_end_of_a_block_waits_for_the_service_and_a_break_for_its_end(
    visitor: Visitor, tmp_path: Path
) -> None:
    design = tmp_path / "pointing.toml"
    few = DESIGN.replace("[20, 40]", "[40]").replace('"circle", ', "").replace("break_s = 1", "break_s = 60")
    design.write_text(few.replace("movements = 3", "movements = 2\nblocks = 2"))
    with served(design) as service:
        hand = Hand(visitor, service.links["P01"], 1)
        hand.open()
        hand.go_on(2)
        visitor.wait(f"{ANSWERED} === 4")  # the state, the consent, the answers, the first movement
        service.kill()
        assert "not saved yet" in hand.until_trouble()  # the movement that was the last of the block
        assert visitor.value(GOAL) is None
        service.start()
        visitor.wait(f"{SHEET} === 'A break'")
        hand.open()
        visitor.wait("document.querySelector('#sheet-form button')?.textContent.startsWith('Continue in')")


def test_a_page_says_what_is_in_the_way(visitor: Visitor, service: Served) -> None:
    hand = Hand(visitor, service.links["P01"], 1)
    hand.open()
    hand.go_on(2)
    for size in ((390, 800), (200, 200)):
        visitor.resize(*size)
        visitor.value(FRAMES)
        left, top, width, height = visitor.corner("#task-scene")
        assert (left, left + width, top + height) == (0, *size)
    assert "too small" in visitor.text("#task-trouble")
    visitor.resize(1280, 720)
    hand.go_on(2)
    with page_browser.visitor(service.design.parent / "profile") as second:
        elsewhere = Hand(second, hand.link, 2)
        elsewhere.open()
        elsewhere.go_on(2)
        hand.go_on(1)
        visitor.wait("document.querySelector('#sheet-title').textContent === 'This study goes on elsewhere'")
    hand.go_on(2)  # after a click on "Go on here"
    one = Study(service.design).participants["P01"]
    assert [done.movement for done in one.done()][:2] == [1, 2]


@pytest.mark.slow
@pytest.mark.timeout(3000)
def test_twelve_people_whose_service_is_killed_every_few_seconds(
    visitor: Visitor, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    design = tmp_path / "pointing.toml"
    few = DESIGN.replace("participants = 3", "participants = 12").replace("[20, 40]", "[40]")
    design.write_text(
        few.replace("break_s", 'blocks = 2\non_error = "repeat"\nbreak_s').replace("= 1\n", "= 0.2\n", 1)
    )
    rng, kills, stop = np.random.default_rng(12), 0, threading.Event()
    with served(design) as service:

        def kill() -> None:
            nonlocal kills
            while not stop.wait(rng.uniform(6.0, 12.0)):
                service.kill()
                service.start()
                kills += 1

        killer = threading.Thread(target=kill)
        killer.start()
        reloads = 0
        try:
            for i, person in enumerate(people(12, 4)):
                hand = Hand(visitor, service.links[f"P{i + 1:02}"], i, person)
                hand.open()
                while hand.go_on(int(rng.integers(5, 25))) != "The end":
                    hand.open()
                    reloads += 1
        finally:
            stop.set()
            killer.join()
    study = Study(design)
    check(study, study.design.codes, tmp_path / "all_samples.parquet")
    assert [one.state for one in status(study)] == ["done"] * 12
    files = sum(len(one.parts(code)) for code, one in study.participants.items())
    with capsys.disabled():
        told = sum(one.movements for one in status(study)), sum(one.missed for one in status(study))
        print(f"\n{kills} kills, {reloads} reloads, {files} files, {told[0]} movements, {told[1]} missed")
