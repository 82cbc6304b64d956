import base64
import re
from html.parser import HTMLParser
from itertools import pairwise
from xml.etree import ElementTree

import msgspec
import numpy as np
import pandas as pd
import pytest

from pointpred import build
from pointpred import run as pipeline_run
from pointpred.drawing import Picture, canvas, picture
from pointpred.errors import ParameterError
from pointpred.recording import Provenance, Recording, Skip, Trial
from pointpred.records import EventColumns
from pointpred.scoring import score as run
from pointpred.scoring.report import write_report
from pointpred.scoring.report.figures import curves
from pointpred.scoring.report.report import compared, highlighted
from pointpred.scoring.report.tables import tables_of
from pointpred.scoring.results import SetScore
from pointpred.scoring.statistics import AnovaSeries
from pointpred.scoring.summary import summarise
from pointpred.scoring.summary.document import footnotes

VOID = {"meta", "img", "br", "link", "hr", "input"}


class Page(HTMLParser):
    """Tags in order with their attributes; fails on a tag that closes another."""

    def __init__(self, source):
        super().__init__()
        self.tags, self.open, self.words = [], [], []
        self.feed(source)
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if data.strip():
            self.words.append(data.strip())

    def of(self, tag):
        return [attrs for name, attrs in self.tags if name == tag]


@pytest.fixture(scope="module")
def hostile(make_score, tmp_path_factory):
    """The text of a report on sets whose every name is an attack."""
    path = tmp_path_factory.mktemp("report") / "out.html"
    evil = '<script>alert("x")</script>\x00 \ud800 $x_1$ ${title} {}'
    scores = [
        make_score(evil, people=3, repeats=1, user=evil, notes=("<img src=http://example.com/>",)),
        make_score("people", people=3, repeats=1, simulated=True),
    ]
    write_report(scores, path)
    return path.read_text(encoding="utf-8")


def test_nothing_outside_the_file_is_asked_for(hostile):
    page = Page(hostile)
    assert {tag for tag, _ in page.tags} & {"script", "link", "iframe", "object", "base", "form"} == set()
    assert all(image["src"].startswith("data:image/svg+xml;base64,") for image in page.of("img"))
    assert all(link["href"].startswith("#") for link in page.of("a"))
    assert not [name for _, attrs in page.tags for name in attrs if name.startswith("on")]
    assert "url(" not in hostile
    assert "@import" not in hostile


def test_names_are_text_and_never_markup(hostile):
    assert "<script" not in hostile
    assert 'alert("x")' in "".join(Page(hostile).words)
    assert "\x00" not in hostile


def test_headings_go_down_one_level_at_a_time(hostile):
    levels = [int(tag[1]) for tag, _ in Page(hostile).tags if re.fullmatch("h[1-6]", tag)]
    assert levels[0] == 1
    assert levels.count(1) == 1
    assert all(after <= before + 1 for before, after in pairwise(levels))


def test_every_figure_has_words_and_every_table_a_caption(hostile):
    page = Page(hostile)
    assert len(page.of("img")) >= 18
    assert all(len(image["alt"]) > 30 for image in page.of("img"))
    assert len(page.of("caption")) == len(page.of("table")) == hostile.count('role="region"')
    anchors = {link["href"][1:] for link in page.of("a")}
    assert anchors <= {attrs["id"] for _, attrs in page.tags if "id" in attrs}


def test_figures_are_sound_and_say_simulated_where_people_were(hostile):
    images = [base64.b64decode(i["src"].split(",")[1]).decode() for i in Page(hostile).of("img")]
    for svg in images:
        ElementTree.fromstring(svg)
        assert "#010203" not in svg
    said = ["(simulated)" in image["alt"] for image in Page(hostile).of("img")]
    half = len(said) // 2
    assert said == [False] * half + [True] * half
    assert (
        sum("(simulated)" in svg for svg in images) >= half - 3
    )  # panels carry names, their caption says it
    assert '<span class="tag">simulated people</span>' in hostile


def test_the_same_scores_give_the_same_bytes(make_score, tmp_path):
    score = make_score(people=3, repeats=1, names=("hold", "linear"))
    write_report([score], tmp_path / "a.html")
    write_report([score], tmp_path / "b.html")
    assert (tmp_path / "a.html").read_bytes() == (tmp_path / "b.html").read_bytes()


def test_a_dollar_sign_in_a_name_is_drawn_as_one():
    with canvas() as (figure, (axes,)):
        axes.set_title("cost $a_b$ & <c>")
        svg = picture(figure, "a", "b").svg
    assert "cost $a_b$ &amp; &lt;c&gt;" in svg
    assert svg in base64.b64decode(Picture(svg, "a", "b", False, None).url.partition(",")[2]).decode()


def test_the_numbers_are_those_of_the_summary(make_score, tmp_path):
    score = make_score(people=3, repeats=1, names=("hold", "linear"))
    write_report([score], tmp_path / "out.html")
    words = Page((tmp_path / "out.html").read_text()).words
    averaged = summarise(score).predictors[1].time_averaged
    place = words.index("linear")  # the first is that of the table
    low, high = averaged.interval
    assert words[place + 1 : place + 4] == [
        f"{averaged.px:.1f}", f"{averaged.of_hold:.2f}", f"{low:.2f} to {high:.2f}"
    ]  # fmt: skip


def test_nothing_to_report_is_refused(make_score, tmp_path):
    with pytest.raises(ParameterError, match="at least one scored set"):
        write_report([], tmp_path / "out.html")
    with pytest.raises(ParameterError, match="hold"):
        write_report([make_score(names=("linear",))], tmp_path / "out.html")


def test_a_set_without_trials_says_so(make_score, tmp_path):
    score = make_score(names=("hold",))
    bare = [p.__class__(p.name, *(np.empty((0, *a.shape[1:])) for a in (
        p.time_averaged, p.by_time, p.by_path, p.single_axis, p.coverage)), float("nan"))
        for p in score.predictors]  # fmt: skip
    write_report([SetScore("empty", (), score.skipped, tuple(bare))], tmp_path / "out.html")
    assert "No trial could be scored." in (tmp_path / "out.html").read_text()


def test_at_most_six_are_told_apart_and_the_thesis_s_pair_is_compared(score, make_score):
    names = highlighted(summarise(score, draws=20))
    assert len(names) == 6
    assert "hold" not in names
    assert {"switched-printed", "kep-quartic-gated", "kinematic"} <= set(names)
    assert "kep-quadratic" not in names  # the worst, and not the thesis's
    assert compared(score) == ("switched-printed", "kep-quartic-gated")
    assert compared(make_score(names=("hold", "linear", "kalman"))) == ("linear", "kalman")
    assert compared(make_score(names=("hold",))) == ("hold",)


def walk(distance, extra):
    t = np.arange(0.0, 1.0, 0.02)
    s = np.clip(t / 0.8, 0.0, 1.0)
    x = distance * s**3 * (10 - 15 * s + 6 * s**2)
    return EventColumns.of(t, x, extra * np.sin(np.pi * s))


@pytest.fixture(scope="module")
def recording():
    parts = [walk(distance, 10.0 * k) for k, distance in enumerate((100.0, 900.0, 300.0))]
    trials = [Trial("ann", str(k), target_x=100.0, target_y=0.0, target_w=30.0) for k in range(3)]
    return Recording.of("walks", parts, trials, provenance=Provenance("memory", simulated=True))


def test_worst_trials_are_replayed_and_drawn(recording, tmp_path):
    (scored,) = run([recording], ["linear"], worst=2)
    assert scored.worst.predictor == "linear"
    assert [one.trial.trial.trial for one in scored.worst.trials] == ["1", "2"]
    first = scored.worst.trials[0]
    assert first.error_px == scored.predictors[1].time_averaged[1]
    assert len(first.events) == len(first.answers) == first.trial.events
    write_report([scored], tmp_path / "out.html")
    page = (tmp_path / "out.html").read_text()
    assert "Worst trials of linear" in page
    assert "Not drawn" not in page


def test_worst_trials_are_those_of_the_pipeline_that_was_scored(recording):
    """A pattern with parameters of its own is replayed as it was scored, not as the registry builds it."""
    ours = build("linear", horizon_s=0.3)
    (scored,) = run([recording], [ours], worst=1)
    (one,) = scored.worst.trials
    assert one.answers.table.tobytes() == pipeline_run(ours.fresh(), one.events).table.tobytes()
    assert run([recording], ["linear"])[0].worst is None


def test_hold_stands_in_where_nothing_else_was_scored(recording):
    (scored,) = run([recording], [], worst=6)
    assert (scored.worst.predictor, len(scored.worst.trials)) == ("hold", 3)


@pytest.fixture(scope="module")
def paper(make_score, tmp_path_factory):
    """The folder of a report on two sets whose names clash as names of files, and the scores."""
    folder = tmp_path_factory.mktemp("report") / "paper"
    names = ("hold", "kinematic", "linear")
    scores = [make_score(name, people=4, repeats=1, names=names) for name in ("lab/a", "lab:A")]
    scores[1] = msgspec.structs.replace(scores[1], trials=())  # a set of which nothing was drawn
    write_report(scores, folder)
    return folder, scores


def test_a_folder_has_the_page_and_each_figure_twice(paper):
    folder, _ = paper
    assert sorted(one.name for one in folder.iterdir()) == ["lab_A_2", "lab_a", "report.html"]
    page = Page((folder / "report.html").read_text(encoding="utf-8"))
    drawn = [base64.b64decode(one["src"].partition(",")[2]) for one in page.of("img")]
    svg = [path.read_bytes() for name in ("lab_a", "lab_A_2") for path in (folder / name).glob("*.svg")]
    assert sorted(svg) == sorted(drawn)
    for path in folder.glob("*/*.svg"):
        assert path.with_suffix(".pdf").read_bytes().startswith(b"%PDF-")


def test_tables_hold_the_numbers_of_the_summary(paper):
    folder, scores = paper
    summary = summarise(scores[0])
    table = pd.read_csv(folder / "lab_a" / "scores.csv", index_col="predictor")
    for predictor in summary.predictors:
        row, averaged = table.loc[predictor.name], predictor.time_averaged
        assert row["error [px]"] == averaged.px
        assert row["of hold"] == averaged.of_hold
        assert (row["from"], row["to"]) == averaged.interval
    along = pd.read_csv(folder / "lab_a" / "by-time.csv", index_col="predictor")
    assert along.loc["kinematic", "50%"] == next(
        p.by_time[0.5].of_hold for p in summary.predictors if p.name == "kinematic"
    )
    assert pd.read_csv(folder / "lab_a" / "left-out.csv")["reason"].tolist() == ["has no events"]
    skips = (Skip("1", "why", 4), Skip("2", "why"))
    none = AnovaSeries((), 0, (), (), (), (), ())
    rows = tables_of(msgspec.structs.replace(summary, skipped=skips), none)["left-out"][1]["row"]
    assert str(rows.dtype) == "Int64"
    assert [None if pd.isna(row) else row for row in rows] == [4, None]
    people = pd.read_csv(folder / "lab_a" / "people.csv")
    assert len(people) == 4 * len(summary.predictors)
    terms = pd.read_csv(folder / "lab_a" / "anova.csv")
    assert {"F", "df1", "df2", "p corrected", "partial eta2"} <= set(terms.columns)


def test_latex_has_every_row_and_no_bare_percent(paper):
    folder, scores = paper
    text = (folder / "lab_a" / "scores.tex").read_text(encoding="utf-8")
    assert text.count(r"\\") == len(scores[0].predictors) + 1
    assert r"\label{tab:lab_a-scores}" in text
    labels = set()
    files = list(folder.glob("*/*.tex"))
    for path in files:
        text = path.read_text(encoding="utf-8")
        assert not re.search(r"(?<!\\)%", text)
        labels |= set(re.findall(r"\\label\{(.+?)\}", text))
    assert len(labels) == len(files)  # of both sets, for one paper


def test_a_figure_gives_the_same_pdf_each_time(score):
    summary = summarise(score, draws=20)
    one, other = (curves(summary, ["linear"], "by_time").pdf() for _ in range(2))
    assert one == other


def test_intervals_over_few_people_carry_a_warning(make_score):
    few = footnotes(summarise(make_score(people=4, repeats=1), draws=20))
    assert [note for note in few if note.startswith("4 people are few")]
    assert not footnotes(summarise(make_score(people=12, repeats=1), draws=20))
