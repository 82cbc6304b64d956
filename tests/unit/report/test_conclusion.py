"""What a reader of a report sees first: a sentence, a chart and a sorted table; the rest is closed."""

import re
from html.parser import HTMLParser

import pytest
from msgspec.structs import replace

from pointpred.scoring.report import write_report
from pointpred.scoring.report.report import conclusion, environment, ranked
from pointpred.scoring.summary import summarise


class Outline(HTMLParser):
    """Tables as rows of cells, and what stands where: in which `details`, and after which tags."""

    def __init__(self, source):
        super().__init__()
        self.order, self.tables, self.depth = [], [], 0
        self.inside = []
        self.feed(source)

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        if tag == "details":
            assert "open" not in attrs
            self.depth += 1
        if tag in ("h1", "h2", "img", "table", "details") or attrs.get("class") == "conclusion":
            self.order.append((attrs.get("class") if tag == "p" else tag, self.depth))
        if tag == "table":
            self.tables.append([])
        if tag == "tr":
            self.tables[-1].append([])
        if tag in ("td", "th"):
            self.tables[-1][-1].append("")
        self.inside.append(tag)

    def handle_endtag(self, tag):
        if tag == "details":
            self.depth -= 1
        while self.inside and self.inside.pop() != tag:
            pass

    def handle_data(self, data):
        data = data.strip()
        if {"td", "th"} & set(self.inside) and "small" not in self.inside:
            self.tables[-1][-1][-1] += data


@pytest.fixture(scope="module")
def page(score, tmp_path_factory):
    path = tmp_path_factory.mktemp("report") / "out.html"
    write_report([score], path)
    return path.read_text(encoding="utf-8")


def test_a_sentence_a_chart_and_a_table_come_first_and_the_rest_is_closed(page):
    order = Outline(page).order
    assert order[:5] == [("h1", 0), ("h2", 0), ("conclusion", 0), ("img", 0), ("table", 0)]
    assert all(depth > 0 for tag, depth in order[5:] if tag in ("img", "table"))
    assert sum(tag == "details" for tag, _ in order) >= 8


def test_every_table_of_predictors_is_sorted_by_the_error_and_holds_hold(page, score):
    errors = {p.name: p.time_averaged.px for p in summarise(score).predictors}
    wanted = sorted(errors, key=errors.get)
    lists = [[row[0] for row in rows[1:]] for rows in Outline(page).tables]
    lists = [names for names in lists if set(names) & set(errors)]
    assert len(lists) >= 5
    assert all(names == wanted for names in lists)
    assert "hold" in wanted


def test_the_sentence_s_numbers_are_those_of_the_document(page, score):
    described = summarise(score)
    best = min((p for p in described.predictors if p.name != "hold"), key=error)
    said = re.search(r'class="conclusion">(.*?)</p>', page).group(1)
    measure = best.time_averaged
    low, high = measure.interval
    assert said.startswith(best.name)
    assert re.findall(r"-?\d+(?:\.\d+)?", said) == [
        f"{measure.px:.1f}",
        f"{100 * (1 - measure.of_hold):.0f}",
        "95",
        f"{100 * (1 - high):.0f}",
        f"{100 * (1 - low):.0f}",
        str(described.trials),
        str(described.users),
    ]


def error(predictor):
    return predictor.time_averaged.px


def words(summary):
    """The sentence as the page has it."""
    sentence = environment().get_template("conclusion.html").module.conclusion
    return " ".join(sentence(summary, conclusion(summary)).split())


def with_measure(described, **changes):
    """The same set, in which the second predictor has another time-averaged error."""
    hold, second = described.predictors
    second = replace(second, time_averaged=replace(second.time_averaged, **changes))
    return replace(described, predictors=(hold, second))


def test_a_predictor_that_is_not_surely_better_is_not_called_so(make_score):
    described = summarise(make_score(names=("hold", "kalman"), people=3, repeats=1))
    doubtful = with_measure(described, of_hold=0.97, interval=(0.9, 1.04))
    assert (conclusion(doubtful).better, conclusion(doubtful).doubtful) == (True, True)
    assert "(95 % interval: 4 % more to 10 % less)" in words(doubtful)
    sure = with_measure(described, of_hold=0.97, interval=(0.9, 0.99))
    assert (conclusion(sure).better, conclusion(sure).doubtful) == (True, False)
    assert "(95 % interval: 1 to 10 % less)" in words(sure)


def test_where_none_beats_no_prediction_this_is_said_first(make_score):
    described = summarise(make_score(names=("hold", "kep-quadratic", "ktm")))
    hold, *others = described.predictors
    assert all(error(one) > error(hold) for one in others)
    found = conclusion(described)
    assert (found.best, found.better) == (min(others, key=error), False)
    assert words(described).startswith("No predictor")
    assert f"{100 * (found.best.time_averaged.of_hold - 1):.0f} % more" in words(described)


def test_a_predictor_fitted_to_these_people_does_not_win(make_score):
    described = summarise(make_score())
    by_name = {one.name: one for one in described.predictors}
    assert conclusion(described).best.name == "kinematic"
    fitted = replace(by_name["kinematic"], seen=True)
    others = tuple(one for one in described.predictors if one.name != "kinematic")
    described = replace(described, predictors=(*others, fitted))
    found = conclusion(described)
    assert found.best == ranked(described).predictors[1]
    assert found.fitted == ("kinematic",)
    assert "kinematic" in words(described).rpartition("fitted")[2]
    alone = conclusion(replace(described, predictors=(by_name["hold"], fitted)))
    assert (alone.best.name, alone.fitted) == ("kinematic", ("kinematic",))


def test_one_trial_and_hold_alone_have_their_own_words(make_score):
    described = replace(summarise(make_score(names=("hold", "linear"))), trials=1, users=1)
    described = with_measure(described, interval=None)
    assert "(one trial has no interval), on 1 trial of one person." in words(described)
    alone = summarise(make_score(names=("hold",)))
    assert conclusion(alone).best is None
    assert words(alone).startswith("Only hold")
    still = with_measure(described, of_hold=None, interval=None)
    assert "nothing can be compared" in words(still)


def test_several_sets_are_listed_with_their_conclusions(make_score, tmp_path):
    scores = [make_score(f"<{name}>", names=("hold", "linear"), people=3, repeats=1) for name in "ab"]
    write_report(scores, tmp_path / "out.html")
    text = (tmp_path / "out.html").read_text()
    listed = re.findall(r'<li><a href="#set-(\d)">&lt;(\w)&gt;</a>: ([^<]+)</li>', text)
    assert [(number, name) for number, name, _ in listed] == [("0", "a"), ("1", "b")]
    assert [words for *_, words in listed] == re.findall(r'class="conclusion">(.*?)</p>', text)
