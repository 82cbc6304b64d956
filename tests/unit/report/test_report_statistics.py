import numpy as np

from pointpred.report.statistics import anova_table, leads, sentences
from pointpred.scoring.anova import Effect
from pointpred.scoring.results import AXIS_FRACTIONS
from pointpred.scoring.statistics import AxisProfile, box


def effect(f, p):
    return Effect(("model",), f, 1, 9, p, f / (f + 9), 1.0, p)


SERIES = tuple(
    (effect(38.81, 0.0002),) if 0.1 <= fraction <= 0.75 else (effect(50.0 if fraction == 1.0 else 1.0, 0.2),)
    for fraction in AXIS_FRACTIONS
)


def test_the_words_name_the_significant_stretch_and_its_strongest_place():
    (line,) = sentences(SERIES)
    assert line.startswith(
        "model: significant at 10% to 75% of the path, most at 10%: F(1, 9) = 38.81, p < 0.001"
    )
    assert "0.81" in line  # the effect size that the thesis prints for this F


def test_the_words_say_where_nothing_is_significant():
    (line,) = sentences(((effect(2.0, 0.19),),) * len(AXIS_FRACTIONS))
    assert line.startswith("model: not significant anywhere")


def test_only_significant_cells_are_bold():
    page = anova_table("caption", SERIES)
    assert page.count("<strong>38.81</strong>") == 4  # 10, 25, 50 and 75 %
    assert page.count("<strong>") == 4


def profile(name, means):
    return AxisProfile(name, tuple(box(np.array([mean])) for mean in means))


def test_who_leads_where():
    rising = profile("a", AXIS_FRACTIONS)
    level = profile("b", [0.52] * len(AXIS_FRACTIONS))
    assert leads([rising, level]) == "Lowest MAE: a at 5% to 50%; b at 55% to 100% of the path."
    assert leads([rising]) == "Lowest MAE: a at 5% to 100% of the path."
