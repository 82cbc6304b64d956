"""How predictors look: a marker a name, whatever else is drawn, and a colour of its own in each figure."""

import base64
import re

import matplotlib.colors
import pytest

from pointpred.drawing import FAINT, PALETTE
from pointpred.registry import REGISTRY
from pointpred.scoring.report import write_report
from pointpred.scoring.report.figures import STYLES, cost, curves, line_style
from pointpred.scoring.summary import summarise


def test_every_name_of_the_registry_has_a_look_of_its_own():
    assert STYLES.keys() == REGISTRY.keys() - {"hold"}
    assert len({marker for _, marker, _ in STYLES.values()}) == len(STYLES)


def test_a_look_does_not_depend_on_the_rank():
    assert line_style("kalman", ["kalman", "linear"]) == line_style("kalman", ["linear", "x", "kalman"])
    assert line_style("mine", ["mine"]) == line_style("mine", ["linear", "mine"])
    assert line_style("kalman", ["linear"])["color"] == FAINT


def test_as_many_names_as_there_are_colours_have_one_each():
    for start in range(len(STYLES)):
        names = [*STYLES, *STYLES][start : start + len(PALETTE)]
        assert len({line_style(name, names)["color"] for name in names}) == len(PALETTE)
        assert len({line_style(name, names)["marker"] for name in names}) == len(PALETTE)
    usual = ["kinematic", "kinematic-adaptive", "switched", "minimum-jerk", "kep-quartic", "linear"]
    assert [line_style(name, usual)["color"] for name in usual] == [
        line_style(name, [name])["color"] for name in usual
    ]


@pytest.fixture(scope="module")
def described(make_score):
    return summarise(make_score(), draws=20)


def test_thin_lines_are_named(described):
    drawn = curves(described, ["linear", "kalman"], "by_time")
    assert "Thin lines: switched-printed, kep-quartic-gated, kep-quadratic, kinematic," in drawn.caption
    assert "Thin" not in curves(described, [p.name for p in described.predictors], "by_time").caption


def test_shares_by_path_end_where_hold_is_right(described):
    assert "at 90%" in curves(described, ["linear"], "by_path", "of_hold").alt
    assert "at 100%" not in curves(described, ["linear"], "by_path", "of_hold").alt
    assert "at 100%" in curves(described, ["linear"], "by_path", "px").alt
    assert "at 90%" in curves(described, ["linear"], "by_time", "of_hold").alt


def test_costs_are_told_apart_by_a_legend_of_all(described):
    svg = cost(described).svg
    assert all(svg.count(f">{p.name}") == 1 for p in described.predictors)
    colour = matplotlib.colors.to_hex(line_style("kalman", ["kalman"])["color"])
    assert colour in svg.lower()


def test_a_report_on_counts_speaks_of_counts(make_score, tmp_path):
    write_report([make_score(people=3, repeats=1, unit="counts")], tmp_path / "out.html")
    page = (tmp_path / "out.html").read_text().partition('id="protocol"')[0]
    drawn = "".join(base64.b64decode(data).decode() for data in re.findall(r"base64,([^\"]+)", page))
    assert "[counts]" in drawn
    assert not re.findall(r"\bpx\b", re.sub(r"base64,[^\"]+", "", page))
    assert "[px]" not in drawn


def test_a_report_says_what_it_compares_and_nothing_twice(make_score, tmp_path):
    score = make_score(people=3, repeats=1)
    write_report([score.__class__(score.name, score.trials, (), score.predictors)], tmp_path / "out.html")
    page = (tmp_path / "out.html").read_text()
    assert "Models compared: the thesis's two, switched-printed and kep-quartic-gated." in page
    assert page.count("No trial was skipped") + page.count("trials skipped") == 1
    assert '<th scope="col">with sub-movements' in page
    assert "docs/guide/scoring.md" in page
    write_report([make_score(people=3, repeats=1, names=("hold", "linear", "kalman"))], tmp_path / "b.html")
    assert "the thesis's two, " not in (tmp_path / "b.html").read_text()
