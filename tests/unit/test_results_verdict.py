"""What the pages say of the numbers follows from the numbers."""

from pathlib import Path
from typing import Any

import pytest

from pages.results.verdict import recorded, verdict
from pointpred.errors import ParameterError


def one_set(name: str, users: int, simulated: bool = False, **shares: float) -> dict[str, Any]:
    predictors = [
        {"name": key, "time_averaged": {"of_hold": share}, "by_time": {"0.2": {"of_hold": share + 0.01}}}
        for key, share in {"hold": 1.0, **shares}.items()
    ]
    return {"name": name, "users": users, "trials": 9, "simulated": simulated, "predictors": predictors}


def test_words_follow_the_numbers() -> None:
    (said,) = verdict(
        [
            one_set("made", 10, True, kalman=0.5, linear=0.4, switched=0.9),
            one_set("crowd", 8, kalman=0.81, linear=1.2, switched=0.95),
            one_set("loner", 1, kalman=0.9, linear=0.84, switched=0.97),
            one_set("other", 2, kalman=0.7, linear=1.0, switched=0.8),
        ]
    )
    assert "Below 1 on each of the 4 sets: `kalman`, `switched`; 1 of 3 predictors do worse" in said
    assert "is 0.70 to 0.84 of hold's" in said
    assert "`kalman` (2), `linear` (1)" in said
    assert "`kalman` predicts where the cursor will be 25 ms later" in said
    assert "At 20% of the time it has 0.71 to 0.91 of hold's error on these sets" in said
    assert said.endswith("sets of one person: loner.")


def test_a_winner_without_a_fixed_horizon_is_not_called_cautious() -> None:
    (said,) = verdict([one_set("crowd", 8, kalman=0.9, switched=0.8)])
    assert "`switched` (1)" in said
    assert "risks little" not in said
    assert verdict([]) == []


def learner(one: dict[str, Any], ending: str, share: float, high: float, worst: float) -> dict[str, Any]:
    row = {
        "name": f"kinematic ({ending})",
        "time_averaged": {"of_hold": share, "interval": [0.5, high]},
        "by_time": {"0.2": {"of_hold": share}, "0.9": {"of_hold": worst}},
    }
    return one | {"predictors": [*one["predictors"], row]}


def test_what_has_learned_is_judged_without_the_set() -> None:
    made = one_set("made", 10, True, kalman=0.9, kinematic=0.5)
    crowd = learner(one_set("crowd", 8, kalman=0.9), "set left out", 0.7, 0.8, 0.97)
    crowd = learner(crowd, "people left out", 0.6, 0.7, 0.9)
    other = learner(one_set("other", 8, kalman=0.8), "set left out", 0.95, 1.1, 0.9)
    (said,) = verdict([made, crowd, other])
    assert "Below 1 on each of the 3 sets: `kalman`, `kinematic`." in said
    assert "`kinematic` (1), `kalman` (1)" in said
    assert "`kinematic`, fitted without the set it is judged on, has 0.70 to 0.95 of hold's error" in said
    assert "below 1 on 1 of 2 sets; at its worst share of the time 0.97 (crowd, 90%)" in said
    assert "fitted without the person it is judged on, has 0.60 to 0.60" in said
    assert "lowest time-averaged error is 0.70 to 0.80" in said  # not the 0.60 of people left out


PAGE = """# Results

## Time-averaged error of all sets

Words.

| predictor | made (simulated) | crowd | loner |
| --- | --- | --- | --- |
| `hold` | 1.00 | 1.00 | 1.00 |
| `linear` | 0.40 | 1.20 | 0.84 |
| `kalman` | 0.50 | 0.81 | 0.90 |

## crowd

| predictor | px | all |
| --- | --- | --- |
| `linear` | 9 | 0.1 |
"""


def test_the_readme_quotes_the_first_table(tmp_path: Path) -> None:
    page = tmp_path / "results.md"
    page.write_text(PAGE)
    said = recorded(page)
    assert "2 recorded sets" in said
    assert "1 of 2 predictors do worse than no prediction" in said
    page.write_text("# Results\n")
    with pytest.raises(ParameterError, match="no recorded set"):
        recorded(page)


def test_the_readme_quotes_what_has_learned_by_its_row_without_the_set(tmp_path: Path) -> None:
    page = tmp_path / "results.md"
    rows = (
        "| `kinematic (set left out)` | 0.50 | 0.70 | 0.80 |\n"
        "| `kinematic (people left out)` | - | 0.60 | 0.6 |\n"
    )
    page.write_text(PAGE.replace("\n\n## crowd", f"\n{rows}\n## crowd", 1))
    said = recorded(page)
    assert "1 of 3 predictors do worse" in said
    assert "`kinematic` 0.70 to 0.80 of hold's error" in said
