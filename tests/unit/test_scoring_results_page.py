"""The results page names every set, in its place, with the numbers of its summary."""

from __future__ import annotations

import numpy as np
import pytest

from pages.results import measure as results
from pages.results import page as results_page
from pointpred import EventColumns
from pointpred.recording import Recording, Trial
from pointpred.scoring import score, summary
from pointpred.sources import write


def recording(name: str) -> Recording:
    random = np.random.default_rng(12)
    s = np.linspace(0.0, 1.0, 40)
    way = s**3 * (10 - 15 * s + 6 * s**2)
    parts = [
        EventColumns.of(0.016 * np.arange(40), *np.round(random.uniform(-600, 600, (2, 1)) * way))
        for _ in range(12)
    ]
    trials = [Trial(f"u{i % 3}", str(i), clean=i % 2 == 0) for i in range(12)]
    return Recording.of(name, [*parts, parts[0].rows(0, 1)], [*trials, Trial("u0", "short")])


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> str:
    folder, docs = tmp_path_factory.mktemp("recordings"), tmp_path_factory.mktemp("docs")
    write(recording("reaches"), folder / "reaches_samples.parquet")
    (folder / "broken_samples.csv").write_text("user,trial,colour\nann,1,red\n", encoding="utf-8")
    written = results.write(folder, ["hold", "linear"], docs)
    for line in written.read_text(encoding="utf-8").splitlines():
        if line.startswith("!["):
            figure = docs / line.rsplit("(", 1)[1].rstrip(")")
            assert figure.read_text(encoding="utf-8").startswith("<svg")
    assert str(folder) not in written.read_text(encoding="utf-8")
    return written.read_text(encoding="utf-8")


def test_every_set_is_named_present_absent_or_unread(page: str) -> None:
    assert "## simulated-circle (simulated)\n" in page
    assert "## reaches\n" in page
    assert "not at hand: `freihaut2021`," in page
    assert "Not read: broken_samples.csv" in page
    assert page.count("![") == 6  # nobody claims anything: errors by time and path, cost
    assert "- [simulated-circle (simulated)](#simulated-circle-simulated)\n- [reaches](#reaches)" in page


def test_cells_hold_the_numbers_of_the_summary(page: str) -> None:
    one = summary(score([recording("reaches")], ["linear"], seed=results.SEED)[0])
    linear = one["predictors"][1]
    whole, clean = linear["time_averaged"], linear["groups"]["clean_trials"]
    section = page.split("## reaches\n")[1]
    assert "3 people, 12 trials, 6 of them clean" in section
    assert "1 trial skipped" in section
    assert "\nSkipped: " in section
    low, high = whole["interval"]
    assert f"| `linear` | {whole['px']:.1f} | {whole['of_hold']:.2f} [{low:.2f}, {high:.2f}] |" in section
    cell = f"{linear['by_time']['0.7']['of_hold']:.2f} / {clean['by_time']['0.7']['of_hold']:.2f}"
    line = next(row for row in section.split("By time")[1].splitlines() if row.startswith("| `linear`"))
    assert line.split(" | ")[6] == cell
    axis = next(row for row in section.split("longer axis")[1].splitlines() if row.startswith("| `linear`"))
    assert axis.split(" | ")[5] == f"{linear['single_axis']['0.5']['px']:.1f}"


def test_what_failed_and_what_means_nothing_is_said() -> None:
    one = summary(score([recording("reaches")], ["linear"])[0])
    one["predictors"][1]["failed"] = [{"trial": "4", "reason": "RuntimeError: lost its way"}]
    said = results_page.skipped(one)
    assert said[0].startswith("Skipped: ")
    assert said[1].startswith("`linear` failed in 1 trial,")
    assert results_page.number(None) == "-"
    empty = summary(score([Recording.of("none", [], [])], ["linear"])[0])
    assert results_page.section(empty, {}, None)[-1] == "No trial could be scored."


def test_hits_say_where_the_set_knows_no_target(page: str) -> None:
    assert "This set does not know its targets." in page.split("## reaches\n")[1]
    made = page.split("## simulated-circle (simulated)\n")[1].split("\n## ")[0]
    assert "### Hits in the target, % of the 240 trials whose target is known, by time" in made
    assert "| `hold`, clean |" in made


def test_template_matching_stands_beside_the_predictors(page: str) -> None:
    section = page.split("## simulated-circle (simulated)\n")[1].split("\n## ")[0]
    lines = section.split("### The protocol of template matching")[1].splitlines()
    matched = next(line for line in lines if line.startswith("| ktm, library |"))
    assert matched.split(" | ")[-1].startswith("1.00 [1.00, 1.00] / 1.00 [1.00, 1.00]")
    assert any(line.startswith("| `linear` |") for line in lines)
    assert "no person has the movements that a library needs" in page.split("## reaches\n")[1]
