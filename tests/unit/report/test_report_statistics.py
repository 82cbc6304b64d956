import numpy as np
import pytest

from pointpred.scoring.report import write_report
from pointpred.scoring.report.report import ALPHA, leads, terms
from pointpred.scoring.results import AXIS_FRACTIONS
from pointpred.scoring.statistics import Effect, axis_anova


def effect(f, p):
    return Effect(("model",), f, 1, 9, p, f / (f + 9), 1.0, p)


SERIES = tuple(
    (effect(38.81, 0.0002),) if 0.1 <= fraction <= 0.75 else (effect(50.0 if fraction == 1.0 else 1.0, 0.2),)
    for fraction in AXIS_FRACTIONS
)


def test_a_term_names_its_significant_stretch_and_the_strongest_place_in_it():
    (term,) = terms(SERIES)
    assert term.name == "model"
    assert term.significant == ((0.1, 0.75),)
    assert (term.at, term.effect.f) == (0.1, 38.81)
    assert term.effect.eta2 == pytest.approx(0.81, abs=0.005)  # which the thesis prints for this F
    assert [one is not None and one.p_corrected < ALPHA for one in term.cells] == [True] * 4 + [False] * 3


def test_without_a_significant_place_the_largest_f_is_named():
    nowhere = [(effect(2.0, 0.19),)] * len(AXIS_FRACTIONS)
    nowhere[4] = (effect(3.0, 0.1),)
    (term,) = terms(nowhere)
    assert (term.significant, term.at) == ((), AXIS_FRACTIONS[4])


def test_who_leads_where():
    rising, level = np.array(AXIS_FRACTIONS), np.full(len(AXIS_FRACTIONS), 0.52)
    assert leads({"a": rising, "b": level}) == (("a", ((0.05, 0.5),)), ("b", ((0.55, 1.0),)))
    assert leads({"a": rising}) == (("a", ((0.05, 1.0),)),)


def test_the_page_shows_the_analysis_and_only_significant_cells_are_bold(make_score, tmp_path):
    score = make_score(names=("hold", "switched-printed", "kep-quadratic"))
    write_report([score], tmp_path / "out.html")
    page = (tmp_path / "out.html").read_text()
    series = axis_anova(score, ("switched-printed", "kep-quadratic"))
    for effects in (series.effects, series.effects_replaced):
        for term in terms(effects):
            for cell in term.cells:
                shown = f"{cell.f:.2f}"
                bold = f"<strong>{shown}</strong>" in page
                assert bold == (cell.p_corrected < ALPHA), (term.name, cell)
                assert shown in page
    assert "p &lt; 0.001" in page
